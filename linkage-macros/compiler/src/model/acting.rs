//! Masses and what acts: the resolved statements about forces, and which of the forces in the
//! mechanism are asked for.

use proc_macro2::Ident;
use syn::Attribute;
use syn::ext::IdentExt;

use super::dimension::Dimension;
use super::expr::{AngleSum, Scalar};
use super::ids::{GuideId, InputId, LinkId, PointId};
use super::incidence::{Carrier, Length};

pub use super::effort::Effort;
/// Everything that a declaration says about forces; empty where it says nothing.
#[derive(Clone, Default)]
pub struct Dynamics {
    /// In ground axes; none unless written.
    pub gravity: Option<[Scalar; 2]>,
    pub loads: Vec<Load>,
    /// The load that drives an input: what it is follows.
    pub pull: Option<Load>,
    /// The input that it drives.
    pub pulled: Option<InputId>,
    /// Named expressions that read rates or loads; a later one may use an earlier one.
    pub laws: Vec<AngleSum>,
    pub masses: Vec<Mass>,
    pub forces: Vec<Force>,
    pub torques: Vec<Torque>,
    pub springs: Vec<Spring>,
    pub stops: Vec<Stop>,
    pub frictions: Vec<Friction>,
    /// Outputs that read efforts, rates or loads.
    pub formulas: Vec<Formula>,
    /// The outputs of `forces` and `statics`.
    pub asked: Vec<RequestedEffort>,
    /// True if `energy` is an output.
    pub energy: bool,
}

/// A number given at each call.
#[derive(Clone)]
pub struct Load {
    pub name: Ident,
    pub docs: Vec<Attribute>,
    pub dimension: Dimension,
}

#[derive(Clone)]
pub struct Mass {
    pub place: MassPlace,
    pub mass: Magnitude,
    /// About the centre of mass; of a uniform bar it follows from mass and length.
    pub inertia: Magnitude,
}

/// A mass, an inertia or a number of a spring: no input changes it, and of all but the free angle
/// no parameter may make it negative.
#[derive(Clone)]
pub struct Magnitude {
    pub value: Scalar,
    /// The name in errors.
    pub name: String,
}

#[derive(Clone)]
pub enum MassPlace {
    /// A point mass on a pin or a driven point.
    Pin(PointId),
    /// At a point of the link.
    Point(LinkId, PointId),
    /// At coordinates of the link's frame.
    At(LinkId, [Scalar; 2]),
    /// A bar of this length.
    Uniform(LinkId, Scalar),
}

#[derive(Clone)]
pub enum Force {
    At {
        point: PointId,
        value: [Scalar; 2],
        axes: Axes,
    },
    /// Positive pushes the points apart.
    Between {
        points: [PointId; 2],
        value: Scalar,
    },
}

/// Whose axes a force is given in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axes {
    Body(Carrier),
    Guide(GuideId),
}

/// A couple: positive on the one, its opposite on the other if there is one.
#[derive(Clone)]
pub struct Torque {
    pub on: Carrier,
    pub against: Option<Carrier>,
    pub value: Scalar,
}

/// A spring and damper, with the names that errors have for its numbers.
#[derive(Clone)]
pub struct Spring {
    pub name: Option<Ident>,
    pub docs: Vec<Attribute>,
    /// The name in errors.
    pub title: String,
    pub ends: Ends,
    pub stiffness: Magnitude,
    pub damping: Magnitude,
    /// The length or the angle at which it is slack.
    pub free: Magnitude,
}

/// The two ends of a spring.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ends {
    Points([PointId; 2]),
    /// A torsion spring: its angle is that of the second against the first.
    Bodies([Carrier; 2]),
}

/// Two ends of a motion that push back, and never pull.
#[derive(Clone)]
pub struct Stop {
    pub name: Option<Ident>,
    pub docs: Vec<Attribute>,
    /// The name in errors.
    pub title: String,
    pub of: Stopped,
    /// The lower end and the upper one.
    pub ends: [Scalar; 2],
    pub stiffness: Magnitude,
    pub damping: Magnitude,
}

/// A spring or a stop, by its place among its like.
#[derive(Clone, Copy)]
pub(crate) enum Elastic {
    Spring(usize),
    Stop(usize),
}

/// The motion that a stop ends.
#[derive(Clone)]
pub enum Stopped {
    /// A sum of links' angles and a number that no input changes.
    Angle(AngleSum),
    Slide(LinkId),
    Distance([PointId; 2]),
}

impl Stopped {
    pub(crate) fn dimension(&self) -> Dimension {
        match self {
            Self::Angle(_) => Dimension::ANGLE,
            Self::Slide(_) | Self::Distance(_) => Dimension::LENGTH,
        }
    }
}

/// Friction at a joint that follows from its reaction.
#[derive(Clone)]
pub struct Friction {
    pub contact: Contact,
    /// Couple over radius and load, or force over load.
    pub coefficient: Magnitude,
    /// Radius of a pin.
    pub radius: Option<Magnitude>,
    /// Length of a block that touches its guide at both ends.
    pub length: Option<Length>,
    /// The slip by which the sign of the slip is smoothed.
    pub smooth: Option<Length>,
}

/// Two bodies that rub.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Contact {
    /// The link turns on the pin, which the other body holds; the pin's force on the link presses.
    Pin { link: LinkId, pin: PointId, against: Carrier },
    /// The link slides.
    Guide(LinkId),
}

impl Contact {
    /// The link whose reaction presses.
    pub(crate) fn link(self) -> LinkId {
        match self {
            Self::Pin { link, .. } | Self::Guide(link) => link,
        }
    }

    /// The reaction that presses.
    pub fn pressed_by(self) -> Effort {
        match self {
            Self::Pin { link, pin, .. } => Effort::Pin(link, pin),
            Self::Guide(link) => Effort::Guide(link),
        }
    }

    /// True if both are between the same bodies at one joint.
    pub(super) fn is_at(self, other: Self) -> bool {
        match (self, other) {
            (
                Self::Pin { link, pin, against },
                Self::Pin { pin: at, against: other_body, link: by },
            ) => {
                let same = link == by && against == other_body;
                let turned = against == Carrier::Link(by) && other_body == Carrier::Link(link);
                pin == at && (same || turned)
            }
            (one, other) => one == other,
        }
    }
}

/// A force, couple or effort in the mechanism, as a field of a field of the result.
#[derive(Clone)]
pub struct RequestedEffort {
    /// The input, link or spring whose it is.
    pub owner: Ident,
    /// The point, guide or word behind the dot; what is the whole mechanism's has its owner again.
    pub field: Ident,
    pub docs: Vec<Attribute>,
    pub effort: Effort,
}

/// An output that is a number made of efforts, rates and loads.
#[derive(Clone)]
pub struct Formula {
    pub value: Scalar,
    pub dimension: Dimension,
    /// The efforts that it reads.
    pub reads: Vec<Effort>,
}

impl RequestedEffort {
    /// True for a formula of this name.
    pub(super) fn is_formula(&self, name: &Ident) -> bool {
        matches!(self.effort, Effort::Formula(_)) && self.owner == *name
    }

    /// The name by which it was asked for: `BC.C`, `ram.bed.friction`, `losses`.
    pub fn path(&self) -> String {
        let (owner, field) = (self.owner.unraw(), self.field.unraw().to_string());
        match self.effort {
            effort if effort.is_of_the_whole() => owner.to_string(),
            Effort::PinFriction(..) | Effort::GuideFriction(_) => {
                format!("{owner}.{}.friction", field.trim_end_matches("_friction"))
            }
            _ => format!("{owner}.{field}"),
        }
    }
}

impl Dynamics {
    /// True if a mass, a force or a spring is on the point.
    pub(super) fn loads_point(&self, asked: PointId) -> bool {
        let masses = self
            .masses
            .iter()
            .any(|mass| matches!(mass.place, MassPlace::Pin(point) if point == asked));
        let forces = self.forces.iter().any(|force| match force {
            Force::At { point, .. } => *point == asked,
            Force::Between { points, .. } => points.contains(&asked),
        });
        let springs = self
            .springs
            .iter()
            .any(|spring| matches!(spring.ends, Ends::Points(points) if points.contains(&asked)));
        let stops = self
            .stops
            .iter()
            .any(|stop| matches!(stop.of, Stopped::Distance(points) if points.contains(&asked)));
        masses || forces || springs || stops
    }

    /// The same requests without efforts that follow from reactions.
    pub(super) fn what_is_of_power(&self, mut asked: Vec<RequestedEffort>) -> Vec<RequestedEffort> {
        asked.retain(|asked| self.is_of_power(asked.effort));
        asked
    }

    /// True if the effort follows from the power of all that acts, without any reaction.
    pub(crate) fn is_of_power(&self, effort: Effort) -> bool {
        match effort {
            Effort::Input(_)
            | Effort::Pull
            | Effort::Unknown(_)
            | Effort::Spring(_)
            | Effort::Stop(_)
            | Effort::Gap(_)
            | Effort::Shaking => true,
            Effort::Drive(_)
            | Effort::Push(_)
            | Effort::Pin(..)
            | Effort::Bearing(..)
            | Effort::Guide(_)
            | Effort::PinFriction(..)
            | Effort::GuideFriction(_)
            | Effort::Losses => false,
            Effort::Formula(id) => {
                self.formulas[id.index()].reads.iter().all(|read| self.is_of_power(*read))
            }
        }
    }

    /// True if nothing has mass and nothing acts.
    pub(crate) fn is_empty(&self) -> bool {
        let Self { masses, forces, torques, .. } = self;
        let are_none = masses.is_empty() && forces.is_empty() && torques.is_empty();
        are_none && !self.is_elastic()
    }

    /// True if something stores energy by how far it is pushed.
    pub(super) fn is_elastic(&self) -> bool {
        !self.springs.is_empty() || !self.stops.is_empty()
    }

    /// The titles of what is elastic.
    pub(super) fn elastic_titles(&self) -> impl Iterator<Item = &str> {
        let springs = self.springs.iter().map(|spring| spring.title.as_str());
        springs.chain(self.stops.iter().map(|stop| stop.title.as_str()))
    }

    /// The place of a title among [`Self::elastic_titles`].
    pub(super) fn elastic_place(&self, of: Elastic) -> usize {
        match of {
            Elastic::Spring(spring) => spring,
            Elastic::Stop(stop) => self.springs.len() + stop,
        }
    }

    /// The number and the name of all that is neither a body nor a spring nor a stop.
    pub(crate) fn beside_bodies(&self) -> [(usize, &'static str); 4] {
        [
            (self.loads.len(), "load"),
            (self.forces.len(), "force"),
            (self.torques.len(), "torque"),
            (self.frictions.len(), "friction that follows the load of its joint"),
        ]
    }
}
