//! The plan by which a mechanism is drawn: its names, and the statements that place them, for every language.

use super::docs::words;
use super::identifiers::text;
use crate::model::acting::{Ends, Force, Spring};
use crate::model::mechanism::{Carrier, Drive, Group, Mechanism, Point, Slideway, Step};

/// A statement, every part by its place among the names.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum PlanStatement {
    /// A fixed point.
    Ground(u32),
    /// A guide, and the link that carries it.
    Guide(u32, Option<u32>),
    /// A point, and the link that carries it.
    Point(u32, Option<u32>),
    /// The links of a driver or a group, and its pin.
    Group(Vec<PlanMember>, Option<u32>),
}

/// A link of a group.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PlanMember {
    /// The link.
    pub link: u32,
    /// The point that it turns about.
    pub pivot: Option<u32>,
    /// The guide that it slides on.
    pub guide: Option<u32>,
    /// The word for its shape: `bar`, `cylinder`, `body`, `block`, `sleeve`, `slotted_bar` or `yoke`.
    pub shape: &'static str,
    /// True if an input turns it against the ground.
    pub is_turned: bool,
}

/// A spring, a damper, or both, between two points.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PlanSpring {
    /// Its ends.
    pub ends: [u32; 2],
    /// Two flags: it has a stiffness, and it has a damping.
    pub kinds: [bool; 2],
}

/// The plan of a mechanism: its names, and the statements that place them.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct PlanParts {
    /// The mechanism's name.
    pub name: String,
    /// Its doc comment, in one line.
    pub docs: String,
    /// The points' names.
    pub points: Vec<String>,
    /// The links' names.
    pub links: Vec<String>,
    /// The guides' names.
    pub guides: Vec<String>,
    /// The statements that place them, in solving order.
    pub statements: Vec<PlanStatement>,
    /// Springs and dampers between two points.
    pub springs: Vec<PlanSpring>,
}

impl PlanParts {
    pub(crate) fn of(mechanism: &Mechanism) -> Self {
        let [points, links, guides] = names(mechanism);
        Self {
            name: text(&mechanism.name),
            docs: words(&mechanism.docs),
            points,
            links,
            guides,
            statements: statements(mechanism).collect(),
            springs: springs(mechanism).collect(),
        }
    }
}

/// The names of points, links and guides; none of a point that nobody has named.
pub(super) fn names(mechanism: &Mechanism) -> [Vec<String>; 3] {
    let point = |point: &Point| if point.is_hidden { String::new() } else { text(&point.name) };
    [
        mechanism.points.iter().map(point).collect(),
        mechanism.links.iter().map(|link| text(&link.name)).collect(),
        mechanism.guides.iter().map(|guide| text(&guide.name)).collect(),
    ]
}

pub(super) fn statements(mechanism: &Mechanism) -> impl Iterator<Item = PlanStatement> {
    let on = |carrier: Carrier| match carrier {
        Carrier::Ground => None,
        Carrier::Link(link) => Some(link.0),
    };
    mechanism.steps.iter().map(move |step| match step {
        Step::Ground { point, .. } => PlanStatement::Ground(point.0),
        Step::Guide { guide, carrier, .. } => PlanStatement::Guide(guide.0, on(*carrier)),
        Step::Point { point, carrier, .. } => PlanStatement::Point(point.0, on(*carrier)),
        Step::Group(group) => group_of(mechanism, group),
    })
}

fn group_of(mechanism: &Mechanism, group: &Group) -> PlanStatement {
    let members = group.outer.iter().enumerate().map(|(index, joint)| PlanMember {
        link: group.links[index].0,
        pivot: joint.point().map(|point| point.0),
        guide: joint.guide().map(|guide| guide.0),
        shape: shape(mechanism, group, index),
        is_turned: matches!(
            &joint.drive,
            Some(Drive::Angle { angle, relative_to: Carrier::Ground }) if mechanism.turns(angle)
        ),
    });
    PlanStatement::Group(members.collect(), group.pin.map(|pin| pin.0))
}

/// The word for the shape of a link, from its joints.
fn shape(mechanism: &Mechanism, group: &Group, index: usize) -> &'static str {
    let link = group.links[index];
    let slides_in = group.inner.iter().find_map(|joint| match joint.slideway()? {
        Slideway::Guide(_) => None,
        Slideway::Bar(carrier) | Slideway::Slot { link: carrier, .. } => Some(*carrier),
    });
    match (&group.lengths[index], slides_in, group.outer[index].guide()) {
        (Some(length), ..) if mechanism.moves(&length.value) => "cylinder",
        (Some(_), ..) => "bar",
        (None, Some(carrier), Some(_)) if carrier == link => "yoke",
        (None, Some(carrier), None) if carrier == link => "slotted_bar",
        (None, Some(_), _) => "sleeve",
        (None, None, Some(_)) => "block",
        (None, None, None) => "body",
    }
}

/// The points that forces of the declaration act on, in their order.
pub(super) fn pushed(mechanism: &Mechanism) -> impl Iterator<Item = u32> {
    mechanism.dynamics.forces.iter().flat_map(|force| match force {
        Force::At { point, .. } => vec![point.0],
        Force::Between { points, .. } => points.map(|point| point.0).to_vec(),
    })
}

/// The springs between two points; a torsion spring is not drawn.
pub(super) fn springs(mechanism: &Mechanism) -> impl Iterator<Item = PlanSpring> {
    mechanism.dynamics.springs.iter().filter_map(|spring: &Spring| {
        let Ends::Points(ends) = spring.ends else { return None };
        let kinds = [&spring.stiffness, &spring.damping].map(|number| !number.value.is_zero());
        Some(PlanSpring { ends: ends.map(|end| end.0), kinds })
    })
}
