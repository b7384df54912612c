//! The frames that groups give drawn links, as far as the rules of a statement ask for them.

use proc_macro2::Ident;

use crate::syntax::tree::{
    Expr, ExprKind, GroupFieldValue, GroupStatement, GuideStatement, PointPlace,
};

/// Puts what stands in the frames that links are written in into those of their groups.
pub(super) trait FramesOfGroups {
    /// An expression in which the angles of links are those of their groups' frames.
    fn expr(&self, expr: &Expr) -> Expr;

    fn pair(&self, [first, second]: &[Expr; 2]) -> [Expr; 2] {
        [self.expr(first), self.expr(second)]
    }

    /// An angle against the written frame of a link, against that of its group.
    fn added(&self, link: &Ident, angle: Expr) -> Expr;

    /// Components along the axes of a link.
    fn components(&self, link: &Ident, local: &[Expr; 2]) -> [Expr; 2];

    /// Coordinates in the frame of a link.
    fn place(&self, link: &Ident, local: &[Expr; 2]) -> [Expr; 2];

    fn point(&self, on: Option<&Ident>, place: &PointPlace) -> PointPlace;

    /// The fields of a group, of a spring or of a stop.
    fn group(&self, group: &mut GroupStatement) {
        let reference = group.fields.iter().find_map(|field| match &field.value {
            GroupFieldValue::One(Expr { kind: ExprKind::Name(name), .. })
                if field.name == "relative_to" =>
            {
                Some(name.clone())
            }
            _ => None,
        });
        for field in &mut group.fields {
            field.value = match &field.value {
                GroupFieldValue::One(value) => GroupFieldValue::One(match &reference {
                    Some(reference) if field.name == "angle" => {
                        self.added(reference, self.expr(value))
                    }
                    _ => self.expr(value),
                }),
                GroupFieldValue::Pair(values) => GroupFieldValue::Pair(self.pair(values)),
            };
        }
    }

    /// The place that a guide goes through, in the frame of the group of what carries it; none where it stays as it is.
    fn through(&self, guide: &GuideStatement) -> Option<[Expr; 2]>;

    /// The angle there of a guide that runs towards a point; none where that stays as it is.
    fn towards(&self, guide: &GuideStatement) -> Option<Expr>;
}
