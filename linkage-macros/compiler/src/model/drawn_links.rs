//! The links of a drawing as groups have made them.

use std::collections::HashMap;

use proc_macro2::Ident;

use crate::syntax::tree::Expr;

/// The links of a drawing as groups have made them.
#[derive(Default)]
pub(in crate::model) struct DrawnLinks {
    /// Every link that groups of the drawing make, whether drawn or hidden.
    pub made: Vec<Ident>,
    /// All names that nobody has written.
    pub names: Vec<Ident>,
    /// Links and unknowns among them, and the links of the drawing that each stands for.
    pub hidden: Vec<(Ident, Vec<Ident>)>,
    pub turned: Vec<TurnedFrame>,
    /// Pins between links.
    pub joints: Vec<Ident>,
    pub bars: Vec<BarFound>,
    pub pins: Vec<PinFound>,
    /// In the order in which groups make their joints.
    pub slides: Vec<SlideFound>,
    /// Links that unknowns turn which nobody has written.
    pub searched: Vec<Ident>,
    /// The pins of two bars that are drawn as a parallelogram, and the corners opposite to each.
    pub parallels: HashMap<Ident, Vec<Ident>>,
    /// The angles of links in the drawing, with the turns that their drives count.
    pub angles: Vec<(Ident, f64)>,
    /// Links that are driven, and those whose drivers drive them.
    pub drives: Vec<[Ident; 2]>,
}

/// A link whose frame is turned against that of its group, and the angle.
pub(in crate::model) struct TurnedFrame {
    pub link: Ident,
    pub angle: Expr,
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
    pub middle: [Expr; 2],
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
}
