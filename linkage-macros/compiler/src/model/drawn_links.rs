//! The links of a drawing as groups have made them.

use std::collections::{HashMap, HashSet};

use proc_macro2::Ident;

use crate::syntax::tree::Expr;

use crate::model::mechanism::StandsFor;
use crate::model::solved_at_once::TrackedFit;

/// The links of a drawing as groups have made them.
#[derive(Default)]
pub(in crate::model) struct DrawnLinks {
    /// Every link that groups of the drawing make, whether drawn or hidden.
    pub made: Vec<Ident>,
    /// All names that nobody has written.
    pub names: Vec<Ident>,
    /// Links and unknowns among them, and what each stands for.
    pub hidden: Vec<(Ident, StandsFor)>,
    /// The links whose groups gave them other frames than their statements.
    pub frames: Vec<FrameFound>,
    /// Pins and guides whose places are told in the frames of groups.
    pub placed: HashSet<Ident>,
    /// Pins between links.
    pub joints: Vec<Ident>,
    /// Links that no group has as bars between the first two pins of their statements.
    pub bars: Vec<BarFound>,
    pub pins: Vec<PinFound>,
    /// In the order in which groups make their joints.
    pub slides: Vec<SlideFound>,
    /// Groups that are solved by all their unknowns at once: their links, and these unknowns.
    pub tracked: Vec<(Vec<Ident>, TrackedFit)>,
    /// Links that unknowns turn which nobody has written.
    pub searched: Vec<Ident>,
    /// The pins of two bars that are drawn as a parallelogram, and the corners opposite to each.
    pub parallels: HashMap<Ident, Vec<Ident>>,
    /// The angles of links in the drawing, with the turns that their drives count.
    pub angles: Vec<(Ident, f64)>,
    /// Links that are driven, and those whose drivers drive them.
    pub drives: Vec<[Ident; 2]>,
}

/// The frame in which a link is written, in that of its group: see [`FrameShift`].
///
/// [`FrameShift`]: crate::model::as_drawn::FrameShift
pub(in crate::model) struct FrameFound {
    pub link: Ident,
    pub angle: Option<Expr>,
    pub axis: [Expr; 2],
    pub origin: [Expr; 2],
    pub is_reversed: bool,
}

/// A slide as it is drawn, by the joint of a group: see [`DrawnSlide`].
pub(in crate::model) struct SlideFound {
    pub link: Ident,
    pub guide: Ident,
    pub carrier: Option<Ident>,
    pub by: Ident,
    pub is_reversed: bool,
    pub shift: Expr,
    pub arm: [Expr; 2],
    /// True for the guide that the link's statement names first.
    pub is_first: bool,
}

/// A link as a bar between the first two pins of its statement.
pub(in crate::model) struct BarFound {
    pub link: Ident,
    /// Its middle; none where an input changes its length.
    pub middle: Option<[Expr; 2]>,
    pub length: Expr,
}

/// A pin of a link that its group makes elsewhere, and its place in the frame of the group.
pub(in crate::model) struct PinFound {
    pub link: Ident,
    pub pin: Ident,
    pub at: [Expr; 2],
}

impl DrawnLinks {
    /// The slide that a link is known by: that on the first guide of its statement.
    pub(super) fn slide_of(&self, link: &Ident) -> Option<&SlideFound> {
        self.slides.iter().find(|slide| slide.link == *link && slide.is_first)
    }

    /// The parts of the drawing that a link or an unknown stands for.
    pub(super) fn stands_for(&self, name: &Ident) -> StandsFor {
        let mut hidden = self.hidden.iter();
        hidden.find(|(own, _)| own == name).map_or(StandsFor::Itself, |(_, of)| of.clone())
    }
}
