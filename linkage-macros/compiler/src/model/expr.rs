//! Numbers of a resolved declaration: names are ids, lengths in metres, angles in radians.

use crate::exact::Exact;
use crate::function::Function;

use crate::model::effort::Effort;
use crate::model::ids::{
    GuideId, InputId, LawId, LetId, LinkId, LoadId, ParamId, PointId, SpringId, TrackedId,
    UnknownId,
};

/// A scalar expression. Lengths in metres, angles in radians.
#[derive(Clone, Debug)]
pub enum Scalar {
    Constant(Exact),
    Input(InputId),
    Param(ParamId),
    /// A load, in forces, torques and outputs alone.
    Load(LoadId),
    /// The load that drives an input, in the same places.
    Pull,
    /// An unknown, which an equation fixes.
    Unknown(UnknownId),
    /// One of the unknowns of a group that is solved by all of them at once.
    Tracked(TrackedId, usize),
    /// The part of a named expression that is not a multiple of link angles.
    Let(LetId),
    /// The same of one that reads rates or loads, in forces, torques and outputs alone.
    Law(LawId),
    /// The slide of a link that slides.
    Slide(LinkId),
    /// A coordinate of a point in ground axes.
    Coordinate(PointId, Axis),
    /// The distance between two points.
    Distance([PointId; 2]),
    /// The distance of a point from a guide's line, positive on the side of its normal.
    Offset(PointId, GuideId),
    /// The angle by which a spring between two bodies is turned from its free angle.
    Twist(SpringId),
    /// A component of an effort or a reaction, in outputs alone.
    Effort(Effort, usize),
    /// The rate of a sum of angles, or of any other number, in forces, torques and outputs
    /// alone.
    Rate(Box<AngleSum>),
    /// A number that must be above zero.
    AboveZero(Box<AboveZero>),
    Negate(Box<Scalar>),
    /// One operation after the other, each on what the one before has made.
    Chain(Box<Scalar>, Vec<(Operator, Scalar)>),
    Call(Function, Vec<Scalar>),
}

/// The argument of a function that needs a number above zero, with its text.
#[derive(Clone, Debug)]
pub struct AboveZero {
    pub value: Scalar,
    pub name: String,
    pub function: Function,
}

/// An axis of the ground.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    X,
    Y,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Operator {
    Add,
    Sub,
    Mul,
    Div,
}

/// An angle (or any other number, then without link angles): Σ kᵢ·linkᵢ.angle + rest.
#[derive(Clone, Debug)]
pub struct AngleSum {
    pub links: Vec<(LinkId, i32)>,
    pub rest: Scalar,
}
