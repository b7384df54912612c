//! Slides, drives and directions of links as their drawing has them, in terms of the joints and frames that groups gave
//! them.
//!
//! A group may have a joint the other way round, or measure it from another place: which it does is a matter of what
//! is driven. What a drawing says of the joint is the same whatever that is.

use std::f64::consts::{PI, TAU};

use proc_macro2::Ident;

use crate::chain::assembly_list::Assemblies;

use super::expr::Scalar;
use super::ids::{LinkId, PointId};

/// The statements of a drawing about its links; empty where nothing is drawn.
#[derive(Clone, Default)]
pub struct AsDrawn {
    pub slides: Vec<DrawnSlide>,
    pub drives: Vec<DrawnDrive>,
    /// Joints between links, which are bodies without mass of their own whichever link a group makes them with.
    pub joints: Vec<PointId>,
    /// The links whose groups gave them other frames than their statements.
    pub frames: Vec<FrameShift>,
    /// The links that unknowns of searches turn.
    pub searched: Vec<LinkId>,
    /// The angles of links in the drawing, with the turns that their drives count.
    pub angles: Vec<(LinkId, f64)>,
    /// True if groups were found in a drawing.
    pub is_found: bool,
    /// The searches that groups of class III became, in the order of their unknowns.
    pub searches: Vec<SearchFollowed>,
}

/// The whole turns that bring an angle to within half a turn. Half a turn backwards counts as one forwards, to more than
/// rounding and the last digits of a drawing, so that these change no angle by a turn.
pub fn whole_turns(angle: f64) -> f64 {
    const LAST_DIGITS: f64 = 1e-6;
    ((PI + LAST_DIGITS - angle) / TAU).floor()
}

/// A link that is drawn on a guide. With the slide s of a group's joint its slide is ±s + `shift`.
#[derive(Clone)]
pub struct DrawnSlide<L = LinkId, N = Scalar> {
    pub link: L,
    pub guide: Ident,
    /// The link that carries the guide.
    pub carrier: Option<Ident>,
    /// The link whose joint it is in a group.
    pub by: L,
    /// True if that link is the guide's carrier, so that the group has the joint the other way round.
    pub is_reversed: bool,
    pub shift: N,
    /// From the origin of the drawn link's frame to that of `by`, along the guide and across it. Where the joint is
    /// reversed, s adds to what is along.
    pub arm: [N; 2],
    /// True for the guide that the link's statement names first, along which its slide is.
    pub is_first: bool,
}

/// The frame in which a link is written, in that of its group.
#[derive(Clone)]
pub struct FrameShift<L = LinkId, N = Scalar> {
    pub link: L,
    /// Its angle, where it is turned.
    pub angle: Option<N>,
    /// The cosine and the sine of that angle.
    pub axis: [N; 2],
    pub origin: [N; 2],
    /// True if it begins at the other end of a bar.
    pub is_reversed: bool,
}

impl FrameShift {
    /// Components along the axes of the group's frame.
    pub(in crate::model) fn components(&self, [x, y]: [Scalar; 2]) -> [Scalar; 2] {
        if self.angle.is_none() {
            return [x, y];
        }
        let [cos, sin] = self.axis.clone();
        [
            cos.clone().times(x.clone()).minus(sin.clone().times(y.clone())),
            sin.times(x).plus(cos.times(y)),
        ]
    }

    /// Coordinates in the group's frame.
    pub(in crate::model) fn place(&self, local: [Scalar; 2]) -> [Scalar; 2] {
        let [x, y] = self.components(local);
        let [dx, dy] = self.origin.clone();
        [dx.plus(x), dy.plus(y)]
    }
}

/// An unknown, and how far the machine was followed with it.
#[derive(Clone)]
pub struct SearchFollowed {
    pub unknown: Ident,
    /// The name of what it is measured from, where that follows the drive.
    pub traced: Option<Ident>,
    pub stretches: Vec<Stretch>,
    /// The ways to assemble its group in the drawing, where they are listed.
    pub assemblies: Option<Assemblies>,
}

/// The ends to which a motion was followed, from the drawing.
#[derive(Clone)]
pub struct Stretch {
    /// The input, where several drive the machine.
    pub input: Option<Ident>,
    pub ends: [f64; 2],
    pub is_angle: bool,
}

/// The drive of a link that a group has the other way round: its effort is the opposite.
#[derive(Clone)]
pub struct DrawnDrive {
    pub link: LinkId,
    pub by: LinkId,
}
