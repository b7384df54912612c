//! The links of a drawing as groups have made them.

use std::collections::HashMap;

use proc_macro2::Ident;

use crate::model::as_drawn::{DrawnSlide, FrameShift, SearchFollowed};
use crate::model::figures::Figure;
use crate::model::mechanism::{Sign, StandsFor};

/// The links of a drawing as groups have made them.
#[derive(Default)]
pub struct DrawnLinks {
    /// Links and unknowns that nobody has written, and what each stands for.
    pub hidden: Vec<(Ident, StandsFor)>,
    /// The links whose groups gave them other frames than their statements.
    pub frames: Vec<FrameFound>,
    /// Pins between links.
    pub joints: Vec<Ident>,
    /// Links that no group has as bars between the first two pins of their statements.
    pub bars: Vec<BarFound>,
    pub pins: Vec<PinFound>,
    /// In the order in which groups make their joints.
    pub slides: Vec<SlideFound>,
    /// Links that unknowns turn which nobody has written.
    pub searched: Vec<Ident>,
    /// The pins of two bars that are drawn as a parallelogram, and the corners opposite to each.
    pub parallels: HashMap<Ident, Vec<Ident>>,
    /// By their first links, the modes of groups that are declared by hand and leave them to the drawing.
    pub modes: HashMap<Ident, Sign>,
    /// The angles of links in the drawing, with the turns that their drives count.
    pub angles: Vec<(Ident, f64)>,
    /// Links that are driven, and those whose drivers drive them.
    pub drives: Vec<[Ident; 2]>,
    pub searches: Vec<SearchFollowed>,
    /// True if drives hold links together.
    pub holds_links: bool,
    /// Points declared on links that are made elsewhere, though their place is not known before the link's.
    pub misplaced: Vec<Ident>,
}

/// The frame in which a link is written, by names and numbers of the drawing.
pub(in crate::model) type FrameFound = FrameShift<Ident, Figure>;

/// A slide as it is drawn, by the joint of a group, in the same terms.
pub(in crate::model) type SlideFound = DrawnSlide<Ident, Figure>;

/// A link as a bar between the first two pins of its statement.
pub struct BarFound {
    pub link: Ident,
    /// Its middle; none where an input changes its length.
    pub middle: Option<[Figure; 2]>,
    pub length: Figure,
}

/// A pin of a link that its group makes elsewhere, and its place in the frame of the group.
pub struct PinFound {
    pub link: Ident,
    pub pin: Ident,
    pub at: [Figure; 2],
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
