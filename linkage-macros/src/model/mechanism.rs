//! The resolved mechanism: every name is a typed id, every number an expression whose dimension
//! was checked, every statement a step in solving order.
//!
//! Identifiers keep their spans for the fields and docs of the generated code; nothing else here
//! remembers the source text.

use proc_macro2::Ident;
use syn::{Attribute, Visibility};

use crate::exact::Exact;
use crate::model::mentions::Mentions;
use crate::model::turning::Turning;

macro_rules! ids {
    ($($(#[$doc:meta])* $name:ident)*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        pub(crate) struct $name(pub u32);

        impl $name {
            pub(crate) fn index(self) -> usize {
                self.0 as usize
            }
        }
    )*};
}

ids! {
    /// An index into [`Mechanism::inputs`].
    InputId
    /// An index into [`Mechanism::params`].
    ParamId
    /// An index into [`Mechanism::lets`].
    LetId
    /// An index into [`Mechanism::points`].
    PointId
    /// An index into [`Mechanism::links`].
    LinkId
    /// An index into [`Mechanism::guides`].
    GuideId
    /// An index into [`Mechanism::groups`].
    GroupId
}

pub(crate) struct Mechanism {
    pub docs: Vec<Attribute>,
    pub visibility: Visibility,
    pub name: Ident,
    pub inputs: Vec<Input>,
    pub params: Vec<Param>,
    /// Named expressions; a later one may use an earlier one.
    pub lets: Vec<Turn>,
    pub points: Vec<Named>,
    pub links: Vec<Link>,
    pub guides: Vec<Named>,
    /// Drivers and dyads, for messages and docs.
    pub groups: Vec<Group>,
    /// What places points, guides and links, in solving order: a step uses only what earlier
    /// steps have made.
    pub steps: Vec<Step>,
    pub outputs: Vec<Output>,
    /// What dyads of constants leave of the turns of cranks.
    pub turnings: Vec<Turning>,
    /// For editors.
    pub mentions: Mentions,
    pub numerics: Numerics,
    /// `crate = path;`, where given.
    pub crate_path: Option<syn::Path>,
    /// `export c;`
    pub export_c: bool,
}

/// A point or a guide: its name and how it is documented.
pub(crate) struct Named {
    pub name: Ident,
    pub docs: Vec<Attribute>,
    /// What made it, for the docs: "ground", "crank AB", "rrr BC, DC", "point on BC".
    pub made_by: String,
}

pub(crate) struct Input {
    pub name: Ident,
    pub docs: Vec<Attribute>,
    pub dimension: Dimension,
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

pub(crate) struct Group {
    /// The links, as run-time errors name them: `"BC, DC"`.
    pub title: String,
    /// `crank`, `slider`, `rrr`, …
    pub keyword: &'static str,
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
    /// The part of a named expression that is not a multiple of link angles.
    Let(LetId),
    /// The slide of a link that slides.
    Slide(LinkId),
    /// A coordinate of a point in ground axes.
    Coordinate(PointId, Axis),
    /// The distance between two points.
    Distance([PointId; 2]),
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
pub(crate) struct Turn {
    pub links: Vec<(LinkId, i32)>,
    pub rest: Expr,
}

pub(crate) enum Course {
    /// The angle against the carrier's x.
    Along(Turn),
    Towards(PointId),
}

pub(crate) enum Spot {
    /// Coordinates in the carrier's frame.
    At([Expr; 2]),
    Point(PointId),
}

pub(crate) enum Place {
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
        through: Spot,
        course: Course,
    },
    /// A point of a link, or a driven point in ground axes.
    Point {
        point: PointId,
        carrier: Carrier,
        place: Place,
        group: GroupId,
    },
    Crank {
        group: GroupId,
        link: LinkId,
        pivot: PointId,
        /// The pin and its distance from the pivot; a body without a pin has neither.
        pin: Option<(PointId, Length)>,
        angle: Turn,
        relative_to: Carrier,
    },
    Slider {
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
        slot: Turn,
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
    Turn(Turn),
    /// Signed distance of the group from its limit.
    Margin(GroupId),
    /// Sine of the group's transmission angle.
    Transmission(GroupId),
}
