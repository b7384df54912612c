//! Why a pose, a velocity or a derivative could not be computed.

use core::fmt;

use crate::crossing::{Crossing, SEVERAL_DEAD_POINTS};
use crate::shown::{Digits, Length, Measured};

/// The name of ends that are in order and too far apart.
pub(crate) const ENDS_OF_BETWEEN: &str = "ends of between";

/// Why a solver gave no answer. The group is named by its links, as declared: `"BC, DC"`.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
// A tag of one byte leaves padding that is copied in pieces, which is read before it is written: it was a third
// of a refusal's time.
#[repr(u64)]
pub enum SolveError {
    /// The group cannot be assembled: its joints are too far apart or too close together.
    OutOfReach {
        /// The links of the group.
        group: &'static str,
        /// The missing distance in metres.
        by: f64,
    },
    /// The group is at a toggle or otherwise undetermined: what was asked for is undefined there. A
    /// spring, or a force between two points, is so where they meet.
    Singular {
        /// The links of the group, or the output that has no derivative, or `spring P, Q`.
        group: &'static str,
    },
    /// A length given at run time is zero or negative, or a mass, an inertia or a number of a spring
    /// negative; or a coefficient of friction is; or the ends of an unknown are not in order, or more than a turn apart.
    Invalid {
        /// The links of the group, or the spring.
        group: &'static str,
        /// The expression that is out of range, as written in the declaration.
        name: &'static str,
    },
    /// A cosine and a sine that were given are too far from those of any angle.
    OffCircle {
        /// The input they were given for.
        name: &'static str,
        /// √(cos² + sin²), accepted from 0.9 to 1.1.
        amplitude: f64,
    },
    /// Between its ends an unknown does not solve its equation in the wanted way.
    NoSolution {
        /// The unknown; of a drawing, the links for which it was put.
        unknown: &'static str,
        /// The residual of the equation at the nearer end, or at the dead point next to it.
        by: f64,
        /// The unit of that: `m`, `rad`, `m²`, or `1` for a plain number.
        unit: &'static str,
        /// Where the equation is solved in the other way, if it is: the other trend, and the unknown in
        /// its base unit.
        other: Option<Crossing>,
    },
    /// The equation of an unknown has more than one dead point between its ends, and it is not known
    /// whether it has a solution; or it is not smooth there.
    SeveralDeadPoints {
        /// The unknown; of a drawing, the links for which it was put.
        unknown: &'static str,
    },
    /// Friction may hold itself at a joint: it is so large, or the pose so near a dead point, that what it
    /// adds to its own load is no less than itself. Some load leaves the joint at rest under any drive.
    Jams {
        /// The joint: the link on a guide, or the link and the point of a pin, `BC.C`.
        joint: &'static str,
    },
    /// A group that is solved by all its unknowns at once is not followed here: beyond the stretch on which it was
    /// followed from the drawing, or so near a dead point that no certificate says which root Newton's method finds.
    NotCertified {
        /// The links of the group.
        group: &'static str,
    },
    /// A result is not a finite number.
    NotFinite {
        /// The input or parameter to blame, or what left the number's range.
        name: &'static str,
    },
}

impl fmt::Display for SolveError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::OutOfReach { group, by } => {
                write!(f, "{group}: out of reach by {}", Length(by))
            }
            Self::Singular { group } if acts_along_a_line(group) => {
                write!(f, "{group}: its ends meet, and it has no direction")
            }
            Self::Singular { group } => {
                write!(f, "{group}: undefined in this pose, at a limit or a dead point")
            }
            Self::NoSolution { unknown, other: Some(Crossing { trend, at }), .. } => {
                let (wanted, found) = (trend.flipped().participle(), trend.verb());
                write!(f, "{unknown}: no {wanted} root between its ends; ")?;
                write!(f, "the equation {found} through zero at {}", Digits(at))
            }
            Self::SeveralDeadPoints { unknown } => {
                write!(f, "{unknown}: {SEVERAL_DEAD_POINTS}")
            }
            Self::NoSolution { unknown, by, unit, other: None } => {
                write!(f, "{unknown}: no solution between its ends, ")?;
                write!(f, "{} is missing", Measured { value: by, unit })
            }
            Self::Invalid { group, name } if may_be_zero(name) || is_spring(group) => {
                write!(f, "{group}: `{name}` must not be negative")
            }
            Self::Invalid { group, name } if name.starts_with(ENDS_OF_BETWEEN) => {
                write!(f, "{group}: the ends of `between` must be at most a turn apart")
            }
            Self::Invalid { group, name } => {
                write!(f, "{group}: `{name}` must be greater than zero")
            }
            Self::NotCertified { group } => {
                write!(f, "{group}: not certified here, beyond the stretch that was followed")
            }
            Self::Jams { joint } => write!(f, "{joint}: friction may hold itself here"),
            Self::OffCircle { name, amplitude } => {
                let amplitude = Digits(amplitude);
                write!(f, "the cosine and sine of `{name}` have an amplitude of {amplitude}, not 1")
            }
            Self::NotFinite { name } => {
                write!(f, "`{name}` leads to a result that is not finite")
            }
        }
    }
}

/// True if the name is that of a mass, an inertia or a coefficient of friction; a length bears its link's,
/// without a space.
fn may_be_zero(name: &str) -> bool {
    ["mass on ", "inertia on ", "friction at "].iter().any(|start| name.starts_with(start))
}

/// True if the group is a spring or a force between two points.
fn acts_along_a_line(group: &str) -> bool {
    is_spring(group) || group.starts_with("force ")
}

/// True if the group is a spring; no link can be called so.
fn is_spring(group: &str) -> bool {
    group.starts_with("spring ")
}

impl SolveError {
    /// The subject of the error, by its name in the declaration: the group that has no pose, the joint that jams, or
    /// the unknown, input or parameter.
    #[must_use]
    pub const fn culprit(self) -> &'static str {
        match self {
            Self::OutOfReach { group, .. }
            | Self::Singular { group }
            | Self::NotCertified { group }
            | Self::Invalid { group, .. }
            | Self::NoSolution { unknown: group, .. }
            | Self::SeveralDeadPoints { unknown: group }
            | Self::Jams { joint: group } => group,
            Self::NotFinite { name } | Self::OffCircle { name, .. } => name,
        }
    }
}

impl core::error::Error for SolveError {}
