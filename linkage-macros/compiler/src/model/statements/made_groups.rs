//! Groups that a drawing became.

use proc_macro2::Ident;

use crate::syntax::anatomy::{GroupSpec, JointRule};

use crate::model::mechanism::{Assembly, Carrier, GroupName, Mode, PartOf, Sign};
use crate::model::names::Kind;
use crate::model::parts_of_groups::{GroupNumbers, OuterJoint, Parts};
use crate::model::statements::dyads;
use crate::model::statements::made::MadeItem;
use crate::model::{declared, drawn_joints, drawn_sliding, jointed, opposite_sides, uses};

/// A driver or a dyad of a drawing: its links, each with what its outer joint stands on, and its pin.
pub(in crate::model) fn made_group(
    anatomy: &'static GroupSpec,
    legs: Vec<[Ident; 2]>,
    pin: Option<Ident>,
    given: GroupNumbers,
) -> MadeItem {
    let links: Vec<_> = legs.iter().map(|[link, _]| link.clone()).collect();
    let makes = links.iter().map(|link| (link.clone(), Kind::Link));
    let makes = makes.chain(pin.iter().map(|pin| (pin.clone(), Kind::Point))).collect();
    let builds_on =
        legs.iter().map(|[_, joint]| joint).chain(&given.relative_to).cloned().collect();
    let names: Vec<_> = links.iter().map(ToString::to_string).collect();
    let title = format!("{} {}", anatomy.keyword, names.join(", "));
    let made = MadeItem::new(makes, builds_on, given.all(), move |scope, moves| {
        let id = declared::next_group(scope);
        let slides = |link| scope.drawn.is_some_and(|drawn| drawn.slide_of(link).is_some());
        let slides: Vec<_> = links.iter().map(slides).collect();
        let made = links.iter().zip(slides);
        let made = made.map(|(link, slides)| declared::add_link(scope, &[], link, id, slides));
        let made = made.collect();
        let part_of = PartOf::Pin(id);
        let made_pin = pin.as_ref().and_then(|pin| declared::add_point(scope, &[], pin, part_of));
        let (title, at) = (drawn_sliding::title_as_drawn(scope, links.iter()), links[0].span());
        scope.mechanism.groups.push(GroupName { keyword: Ident::new(anatomy.keyword, at), title });
        let outer = legs.iter().zip(anatomy.joints).map(|([_, joint], rule)| match rule {
            JointRule::Revolute(_) => uses::point(scope, joint).map(OuterJoint::Point),
            JointRule::Prismatic(_) => uses::guide(scope, joint).map(OuterJoint::Guide),
        });
        let (outer, pin_name) = (outer.collect(), pin.clone());
        let parts = Parts { at, anatomy, id, links: made, outer, pin_name, pin: made_pin };
        let against = match &given.relative_to {
            Some(link) => uses::link(scope, link).map(Carrier::Link),
            None => Some(Carrier::Ground),
        };
        let mut dimensions = jointed::resolved(scope, &parts, links.iter(), (&given, against));
        let mode = Mode::Fixed(given.mode.unwrap_or(Sign::Plus));
        let parallel = opposite_sides::drawn(scope, &parts, &dimensions.lengths, mode);
        dimensions.assembly = Some(match (anatomy.modes, parallel) {
            (None, _) => Assembly::Unique,
            (Some(_), Some(sides)) => Assembly::Parallel(sides),
            (Some(_), None) => Assembly::Signed(mode),
        });
        dyads::group_is_made(scope, &parts, dimensions, moves);
        drawn_joints::joints_are_as_drawn(scope, &parts);
    });
    made.called(title)
}
