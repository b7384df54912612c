//! The frames that groups give drawn links, as far as the rules of a statement ask for them.

use proc_macro2::Ident;

use crate::syntax::tree::{Expr, GroupStatement, GuideStatement, PointPlace};

/// Puts what stands in the frames that links are written in into those of their groups.
pub(super) trait FramesOfGroups {
    /// An expression in which the angles of links are those of their groups' frames.
    fn expr(&self, expr: &Expr) -> Expr;

    fn pair(&self, pair: &[Expr; 2]) -> [Expr; 2];

    /// An angle against the written frame of a link, against that of its group.
    fn added(&self, link: &Ident, angle: Expr) -> Expr;

    /// Components along the axes of a link.
    fn components(&self, link: &Ident, local: &[Expr; 2]) -> [Expr; 2];

    /// Coordinates in the frame of a link.
    fn place(&self, link: &Ident, local: &[Expr; 2]) -> [Expr; 2];

    fn point(&self, on: Option<&Ident>, place: &PointPlace) -> PointPlace;

    fn group(&self, group: &mut GroupStatement);

    /// The place in the frame of the group that a guide on a link goes through; none where it stays as it is.
    fn through(&self, guide: &GuideStatement) -> Option<[Expr; 2]>;
}
