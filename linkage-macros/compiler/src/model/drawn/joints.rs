//! The joints of a drawing in the mechanism of its groups: what slides, what is driven, and the directions of frames, each
//! as its statement says, whatever group has it.

use proc_macro2::Ident;

use crate::model::as_drawn::{DrawnDrive, DrawnSlide};
use crate::model::mechanism::LinkId;
use crate::model::names::Entity;
use crate::model::scope::Scope;
use crate::model::statements::group::Parts;
use crate::model::{numbers, uses};
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
    pub bars: Vec<BarFound>,
    pub pins: Vec<PinFound>,
    /// In the order in which groups make their joints.
    pub slides: Vec<SlideFound>,
    /// Links that are driven, and those whose drivers drive them.
    pub drives: Vec<[Ident; 2]>,
}

/// A link whose frame is turned against that of its group, and the angle.
pub(in crate::model) struct TurnedFrame {
    pub link: Ident,
    pub angle: Expr,
    /// True if it goes from one pin of the group's bar to the other, the other way round.
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
    fn slide_of(&self, link: &Ident) -> Option<&SlideFound> {
        self.slides.iter().find(|slide| slide.link == *link && slide.is_first)
    }
}

/// The names of links as users know them.
pub(in crate::model) fn title_as_drawn<'n>(
    scope: &Scope<'_>,
    names: impl Iterator<Item = &'n Ident>,
) -> String {
    let hidden = scope.drawn.map_or(&[][..], |drawn| &drawn.hidden);
    let mut known: Vec<String> = Vec::new();
    for name in names {
        match hidden.iter().find(|(hidden, _)| hidden == name) {
            Some((_, links)) => known.extend(links.iter().map(ToString::to_string)),
            None => known.push(name.to_string()),
        }
    }
    known.join(", ")
}

/// True if a link of a drawing slides by its statement; `None` of a link that is declared as part of a group.
pub(in crate::model) fn is_drawn_sliding(scope: &Scope<'_>, link: &Ident) -> Option<bool> {
    let drawn = scope.drawn?;
    drawn.made.contains(link).then(|| drawn.slide_of(link).is_some())
}

/// The link by whose joint a link slides; `None` where that is not made yet, which is reported.
pub(in crate::model) fn slides_by(
    scope: &mut Scope<'_>,
    name: &Ident,
    link: LinkId,
) -> Option<LinkId> {
    let Some(slide) = scope.drawn.and_then(|drawn| drawn.slide_of(name)) else {
        return Some(link);
    };
    uses::link(scope, &Ident::new(&slide.by.to_string(), name.span()))
}

/// The slides whose joints a group has made, once it is made.
pub(in crate::model) fn joints_are_as_drawn(scope: &mut Scope<'_>, parts: &Parts) {
    let Some(drawn) = scope.drawn else { return };
    for slide in &drawn.slides {
        let made = parts.group.legs.iter().position(|leg| leg.link == slide.by);
        let by = made.and_then(|leg| parts.link(leg));
        let (Some(by), Some(Entity::Link(link))) = (by, scope.names.made(&slide.link)) else {
            continue;
        };
        let (shift, arm) =
            (numbers::length(scope, &slide.shift), numbers::lengths(scope, &slide.arm));
        if let (Some(shift), Some(arm)) = (shift, arm) {
            let (guide, carrier) = (slide.guide.clone(), slide.carrier.clone());
            let (is_reversed, is_first) = (slide.is_reversed, slide.is_first);
            let slide = DrawnSlide { link, guide, carrier, by, is_reversed, shift, arm, is_first };
            scope.mechanism.as_drawn.slides.push(slide);
        }
    }
}

/// The drives and the directions of frames, once all links are made.
pub(in crate::model) fn links_are_as_drawn(scope: &mut Scope<'_>) {
    let Some(drawn) = scope.drawn else { return };
    let link = |name: &Ident, scope: &Scope<'_>| match scope.names.entity(name) {
        Some(Entity::Link(link)) => Some(link),
        _ => None,
    };
    for [driven, by] in &drawn.drives {
        if let (Some(driven), Some(by)) = (link(driven, scope), link(by, scope)) {
            scope.mechanism.as_drawn.drives.push(DrawnDrive { link: driven, by });
        }
    }
    for TurnedFrame { link: name, angle, .. } in &drawn.turned {
        let Some(link) = link(name, scope) else { continue };
        if let Some(turn) = numbers::plain_angle(scope, angle) {
            scope.mechanism.as_drawn.turns.push((link, turn));
        }
    }
}
