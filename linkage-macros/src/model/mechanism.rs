//! The resolved mechanism: every name is a typed id, every number an expression whose dimension
//! was checked, every statement a step in solving order.
//!
//! Identifiers keep their spans for the fields and docs of the generated code; nothing else here
//! remembers the source text.

use proc_macro2::Ident;
use syn::{Attribute, Visibility};

use crate::exact::Exact;
use crate::model::dynamics::Dynamics;
pub(crate) use crate::model::findings::{Known, Rotatability};
pub(crate) use crate::model::ids::{
    GroupId, GuideId, InputId, LetId, LinkId, LoadId, ParamId, PointId, SpringId, UnknownId,
};

pub(crate) struct Mechanism {
    pub docs: Vec<Attribute>,
    pub visibility: Visibility,
    pub name: Ident,
    pub inputs: Vec<Input>,
    pub params: Vec<Param>,
    /// What equations fix, in solving order.
    pub unknowns: Vec<Unknown>,
    /// Named expressions; a later one may use an earlier one.
    pub lets: Vec<AngleSum>,
    pub points: Vec<Point>,
    pub links: Vec<Link>,
    pub guides: Vec<Guide>,
    /// Drivers and dyads, for messages and docs.
    pub groups: Vec<Group>,
    /// What places points, guides and links, in solving order: a step uses only what earlier
    /// steps have made.
    pub steps: Vec<Step>,
    pub outputs: Vec<Output>,
    /// What dyads of constants leave of the turns of cranks.
    pub rotatabilities: Vec<Rotatability>,
    /// What constants say of groups, for their docs.
    pub known: Vec<Known>,
    /// Masses, and what acts.
    pub dynamics: Dynamics,
    /// For editors.
    pub references: References,
    pub numerics: Numerics,
    /// `crate = path;`, where given.
    pub crate_path: Option<syn::Path>,
    /// `export c;`
    pub export_c: bool,
}

pub(crate) struct Point {
    pub name: Ident,
    pub docs: Vec<Attribute>,
    pub part_of: Body,
}

/// What a point is part of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Body {
    Ground,
    /// Placed on a link.
    Link(LinkId),
    /// The pin of a driver, or between the links of a dyad.
    Pin(GroupId),
    /// Driven in ground axes.
    Driven(GroupId),
}

impl Mechanism {
    pub(crate) fn point_ids(&self) -> impl Iterator<Item = PointId> + use<> {
        (0..self.points.len() as u32).map(PointId)
    }

    pub(crate) fn link_ids(&self) -> impl Iterator<Item = LinkId> + use<> {
        (0..self.links.len() as u32).map(LinkId)
    }

    pub(crate) fn guide_ids(&self) -> impl Iterator<Item = GuideId> + use<> {
        (0..self.guides.len() as u32).map(GuideId)
    }

    /// The statement that makes a group, as errors and docs call it: `rrr BC, DC`.
    pub(crate) fn statement(&self, group: GroupId) -> String {
        let Group { keyword, title, .. } = &self.groups[group.index()];
        format!("{keyword} {title}")
    }

    /// What made a point: `ground`, `crank AB`, `rrr BC, DC`, `point on BC`.
    pub(crate) fn maker(&self, point: PointId) -> String {
        match self.points[point.index()].part_of {
            Body::Ground => "ground".to_string(),
            Body::Link(link) => format!("point on {}", self.links[link.index()].name),
            Body::Pin(group) => self.statement(group),
            Body::Driven(_) => "driven point".to_string(),
        }
    }
}

pub(crate) struct Guide {
    pub name: Ident,
}

/// Where a declaration makes its names and where it uses them, for editors.
#[derive(Default)]
pub(crate) struct References {
    /// Every name where it is made, and the statement that makes it.
    pub made: Vec<(Ident, String)>,
    /// Every place where one of them is used.
    pub used: Vec<Ident>,
}

pub(crate) struct Input {
    pub name: Ident,
    pub docs: Vec<Attribute>,
    pub dimension: Dimension,
}

/// A number that an equation fixes.
pub(crate) struct Unknown {
    pub name: Ident,
    pub docs: Vec<Attribute>,
    pub dimension: Dimension,
    /// Its title is the unknown's name: what fails with it.
    pub group: GroupId,
    /// Where it is looked for, lower end first.
    pub between: [Expr; 2],
    /// How many steps stand before `unknown`, and before `solve`: what lies between depends on the
    /// trial.
    pub steps: [usize; 2],
    pub equation: Equation,
    /// What both sides of it are.
    pub measure: Dimension,
    /// The sign of the slope of left − right at the wanted root.
    pub mode: Sign,
    /// Where the root is expected.
    pub near: Option<Expr>,
}

/// What is zero at the root.
pub(crate) enum Equation {
    /// left − right
    Difference([Expr; 2]),
    /// An angle, within half a turn.
    Turn(AngleSum),
    /// The distance of two points is a length.
    Distance { points: [PointId; 2], length: Length, is_left: bool },
}

pub(crate) struct Param {
    pub name: Ident,
    pub docs: Vec<Attribute>,
    pub kind: ParamKind,
}

pub(crate) enum ParamKind {
    Number {
        dimension: Dimension,
        default: Exact,
    },
    /// `left` (+1) or `right` (−1): the type is `Side`.
    Side {
        default: Sign,
    },
    /// `ahead` (+1) or `behind` (−1): the type is `Sense`.
    Sense {
        default: Sign,
    },
}

/// Powers of metre, kilogram and second; an angle counts as a number, except that `angle` remembers
/// that it is one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Dimension {
    pub length: i32,
    pub mass: i32,
    pub time: i32,
    pub angle: bool,
}

pub(crate) struct Link {
    pub name: Ident,
    pub docs: Vec<Attribute>,
    pub made_by: GroupId,
    /// Whether it slides on a guide and so has a `slide`.
    pub slides: bool,
}

/// A driver or a dyad, or a driven point, which is a group of its own.
pub(crate) struct Group {
    /// `crank`, `slider`, `rrr`, …, where it is written.
    pub keyword: Ident,
    /// The links, as run-time errors name them: `"BC, DC"`.
    pub title: String,
    /// In the order of the statement.
    pub links: Vec<LinkId>,
    pub pin: Option<PointId>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Numerics {
    Plain,
    Compensated,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Sign {
    Plus,
    Minus,
}

/// An assembly mode: +1 is `left` or `ahead`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Mode {
    Fixed(Sign),
    /// A mode parameter.
    Param(ParamId),
}

/// What a point, a guide or a crank's angle is fixed to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Carrier {
    Ground,
    Link(LinkId),
}

/// A scalar expression. Lengths in metres, angles in radians.
#[derive(Clone, Debug)]
pub(crate) enum Expr {
    Constant(Exact),
    Input(InputId),
    Param(ParamId),
    /// A load, in the values of forces and torques alone.
    Load(LoadId),
    /// What an equation fixes.
    Unknown(UnknownId),
    /// The part of a named expression that is not a multiple of link angles.
    Let(LetId),
    /// The slide of a link that slides.
    Slide(LinkId),
    /// A coordinate of a point in ground axes.
    Coordinate(PointId, Axis),
    /// The distance between two points.
    Distance([PointId; 2]),
    /// The distance of a point from a guide's line, positive on the side of its normal.
    Offset(PointId, GuideId),
    /// How far a spring between two bodies is turned from its free angle.
    Twist(SpringId),
    /// The rate of a sum of angles, or of any other number, in the values of forces and torques
    /// alone.
    Rate(Box<AngleSum>),
    Negate(Box<Expr>),
    /// One operation after the other, each on what the one before has made.
    Chain(Box<Expr>, Vec<(Operator, Expr)>),
    Call(Function, Vec<Expr>),
}

/// An axis of the ground.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Axis {
    X,
    Y,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Operator {
    Add,
    Sub,
    Mul,
    Div,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Function {
    Sqrt,
    Hypot,
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Atan2,
}

/// An angle (or any other number, then without link angles): Σ kᵢ·linkᵢ.angle + rest.
#[derive(Clone, Debug)]
pub(crate) struct AngleSum {
    pub links: Vec<(LinkId, i32)>,
    pub rest: Expr,
}

pub(crate) enum GuideDirection {
    /// The angle against the carrier's x.
    Along(AngleSum),
    Towards(PointId),
}

pub(crate) enum Through {
    /// Coordinates in the carrier's frame.
    At([Expr; 2]),
    Point(PointId),
}

pub(crate) enum Placement {
    Cartesian([Expr; 2]),
    /// Distance from the carrier's origin, angle against its x.
    Polar(Expr, Expr),
    /// Distances from the carrier's two joints, `length` apart on its x; `Plus` is left of it.
    Distances {
        distances: [Length; 2],
        length: Expr,
        side: Sign,
    },
}

/// One statement that places something. The comments name what the formulas call it.
pub(crate) enum Step {
    Ground {
        point: PointId,
        at: [Expr; 2],
    },
    Guide {
        guide: GuideId,
        carrier: Carrier,
        through: Through,
        course: GuideDirection,
    },
    /// A point of a link, or a driven point in ground axes.
    Point {
        point: PointId,
        carrier: Carrier,
        place: Placement,
        group: GroupId,
    },
    Crank {
        group: GroupId,
        link: LinkId,
        pivot: PointId,
        /// The pin and its distance from the pivot; a body without a pin has neither.
        pin: Option<(PointId, Length)>,
        angle: AngleSum,
        relative_to: Carrier,
    },
    Slider {
        group: GroupId,
        link: LinkId,
        guide: GuideId,
        pin: Option<PointId>,
        slide: Expr,
        offset: Expr,
    },
    Rrr {
        group: GroupId,
        links: [LinkId; 2],
        outer: [PointId; 2],
        pin: PointId,
        lengths: [Length; 2],
        mode: Mode,
    },
    Rrp {
        group: GroupId,
        links: [LinkId; 2],
        outer: PointId,
        guide: GuideId,
        pin: PointId,
        length: Length,
        offset: Expr,
        mode: Mode,
    },
    Rpr {
        group: GroupId,
        links: [LinkId; 2],
        outer: [PointId; 2],
        offset: Expr,
        mode: Mode,
    },
    Prp {
        group: GroupId,
        links: [LinkId; 2],
        guides: [GuideId; 2],
        pin: PointId,
        offsets: [Expr; 2],
    },
    Rpp {
        group: GroupId,
        links: [LinkId; 2],
        outer: PointId,
        guide: GuideId,
        slot: AngleSum,
        offsets: [Expr; 2],
    },
}

/// A length that must be positive, and the words that name it in `SolveError::Invalid`.
#[derive(Clone, Debug)]
pub(crate) struct Length {
    pub value: Expr,
    pub name: String,
}

pub(crate) struct Output {
    /// The field of the result.
    pub field: Ident,
    pub docs: Vec<Attribute>,
    pub kind: OutputKind,
}

pub(crate) enum OutputKind {
    Point(PointId),
    /// A link's direction, its slide, or both.
    Link {
        link: LinkId,
        direction: bool,
        slide: bool,
    },
    /// A named expression.
    Value {
        value: Expr,
        dimension: Dimension,
    },
    /// A named angle that contains link angles: given by its direction.
    Angle(AngleSum),
    /// Signed distance of the group from its limit.
    Margin(GroupId),
    /// Sine of the group's transmission angle.
    Transmission(GroupId),
    /// The centre of all masses.
    CentreOfMass,
}
