//! The declaration as written: names are not resolved, dimensions not checked.
//!
//! Every identifier and expression keeps its span, because every later message points at one.

mod calculation;

use std::collections::HashSet;

use proc_macro2::{Ident, Span};
use syn::{Attribute, Visibility};

pub(crate) use calculation::{BinaryOp, Expr, ExprKind, UnitPower};

/// `pub struct Name { statements }`.
pub(crate) struct Declaration {
    /// Doc comments of the struct.
    pub docs: Vec<Attribute>,
    pub visibility: Visibility,
    pub name: Ident,
    pub statements: Vec<Statement>,
    pub unread: Unread,
}

/// The tokens that a mistake kept from being read. A name among them may have been declared or used
/// there, so later phases do not report its absence.
#[derive(Clone)]
pub(crate) enum Unread {
    /// Nothing behind the name of the mechanism.
    Everything,
    /// The identifiers among the tokens that were given up, keywords included.
    Words(HashSet<String>),
}

impl Unread {
    pub(crate) fn may_hold(&self, word: &str) -> bool {
        match self {
            Self::Everything => true,
            Self::Words(words) => words.contains(word),
        }
    }
}

#[derive(Clone)]
pub(crate) struct Statement {
    /// Doc comments in front of the statement.
    pub docs: Vec<Attribute>,
    pub kind: StatementKind,
}

#[derive(Clone)]
pub(crate) enum StatementKind {
    /// `input s, x: length;`; without a kind only after a mistake.
    Input { names: Vec<Ident>, kind: Option<Ident> },
    /// `param l = 632mm;` or `param elbow: mode = left;`; `kind` is the word after the colon.
    Param { name: Ident, kind: Option<Ident>, default: Expr },
    /// `unknown theta: angle between (10deg, 170deg);`; without a kind or ends only after a mistake.
    Unknown { name: Ident, kind: Option<Ident>, between: Option<[Expr; 2]> },
    /// `solve theta { ram.slide = x, mode: falling, near: seed }`
    Solve(Solve),
    /// `let half = l / 2;`
    Let { name: Ident, value: Expr },
    /// `ground A(0, 0), D(…);`
    Ground { points: Vec<(Ident, [Expr; 2])> },
    /// `pin B(80mm, 0), C(600mm, 360mm);`: where joints and tracer points are in the drawing.
    Pin { points: Vec<(Ident, [Expr; 2])> },
    /// `link AB(A, B), block(Q) on slot;` or `link lift(F, G) { length: s }`
    Link { links: Vec<DrawnLink>, fields: Option<GroupStatement> },
    /// `drive AB.angle = theta;`
    Drive(DriveStatement),
    /// `drive theta by pull;`: the load that puts in the effort of an input.
    DriveBy { input: Ident, load: Ident },
    /// `guide slot on BC through P towards C;`
    Guide { name: Ident, on: Option<Ident>, through: GuideAnchor, course: Course },
    /// `point P on BC at …;`
    Point { name: Ident, on: Option<Ident>, place: PointPlace },
    /// Everything with braces of fields: crank, slider and the dyads.
    Group(GroupStatement),
    /// `load cut: force;`; without a kind only after a mistake.
    Load { names: Vec<Ident>, kind: Option<Ident> },
    /// A mass or an action.
    Action(Action),
    /// `output blade, DC.angle, fold = BC.angle - DC.angle;`
    Output { items: Vec<OutputItem> },
    /// `numerics compensated;`
    Numerics { mode: Ident },
    /// `crate = ::path;`: where `linkage-core` is found.
    Crate { path: syn::Path },
    /// `export c;`
    Export { language: Ident },
}

impl StatementKind {
    /// True if it puts a force on one or two points.
    pub(crate) fn is_force(&self) -> bool {
        matches!(self, Self::Action(Action::Force { .. } | Action::ForceBetween { .. }))
    }
}

/// `gravity`, `mass`, `inertia`, `force`, `torque`, `spring`, `friction` or `stop`.
#[derive(Clone)]
pub(crate) enum Action {
    /// `gravity (0, -g);` and where it stands.
    Gravity { at: Span, value: [Expr; 2] },
    /// `mass 2kg on BC at G inertia 0.1(kg*m^2);`
    Mass { value: Expr, on: Ident, place: MassSite, inertia: Option<Expr> },
    /// `inertia J on AB;`
    Inertia { value: Expr, on: Ident },
    /// `force (0, -f) in BC on P;`
    Force { value: [Expr; 2], axes: Option<Ident>, on: Ident },
    /// `force f between P and Q;`
    ForceBetween { value: Expr, points: [Ident; 2] },
    /// `torque t on DC;`
    Torque { value: Expr, on: Ident },
    /// `torque t between AB and DC;`
    TorqueBetween { value: Expr, bodies: [Ident; 2] },
    /// `spring shock between P and Q { stiffness: 15(N/m), free_length: 0.3m }`: two points, or two
    /// bodies. Its fields are read like those of a group.
    Spring { name: Option<Ident>, ends: [Ident; 2], fields: GroupStatement },
    /// `friction 0.1 at C radius 8mm;`
    Friction(FrictionStatement),
    /// `stop DC.angle between (20deg, 110deg) { stiffness: 2e4(N*m/rad) }`
    Stop(StopStatement),
}

/// A stop, which may have a name; its fields are read like those of a group.
#[derive(Clone)]
pub(crate) struct StopStatement {
    pub name: Option<Ident>,
    pub of: Expr,
    pub ends: [Expr; 2],
    pub fields: GroupStatement,
}

/// Friction at a pin or a guide, and where its word stands.
#[derive(Clone)]
pub(crate) struct FrictionStatement {
    pub at: Span,
    pub coefficient: Expr,
    pub site: FrictionSite,
    pub radius: Option<Expr>,
    pub length: Option<Expr>,
    pub smooth: Option<Expr>,
}

/// The joint that has friction.
#[derive(Clone)]
pub(crate) enum FrictionSite {
    /// `at C`
    Pin(Ident),
    /// `on BC at C`
    LinkAtPin(Ident, Ident),
    /// `on ram`
    Slider(Ident),
    /// `between BC and EF at C`
    Between([Ident; 2], Ident),
}

/// Where a mass is.
#[derive(Clone)]
pub(crate) enum MassSite {
    /// Nothing is said: the mass is on a point.
    Here,
    /// `at (x, y)` in the link's frame.
    At([Expr; 2]),
    /// `at G`
    Point(Ident),
    /// `uniform`, and where the word stands.
    Uniform(Span),
}

impl Action {
    /// The names that the statement builds on.
    pub(crate) fn names(&self) -> Vec<&Ident> {
        match self {
            Self::Gravity { .. } | Self::Stop(_) => Vec::new(),
            Self::Mass { on, place: MassSite::Point(point), .. } => vec![on, point],
            Self::Mass { on, .. } | Self::Inertia { on, .. } | Self::Torque { on, .. } => vec![on],
            Self::Force { axes, on, .. } => axes.iter().chain([on]).collect(),
            Self::ForceBetween { points: ends, .. } | Self::TorqueBetween { bodies: ends, .. } => {
                ends.iter().collect()
            }
            Self::Spring { ends, .. } => ends.iter().collect(),
            Self::Friction(friction) => match &friction.site {
                FrictionSite::Pin(name) | FrictionSite::Slider(name) => vec![name],
                FrictionSite::LinkAtPin(link, pin) => vec![link, pin],
                FrictionSite::Between([first, second], pin) => vec![first, second, pin],
            },
        }
    }

    /// The expressions in it, from left to right.
    pub(crate) fn expressions(&self) -> Vec<&Expr> {
        match self {
            Self::Gravity { value, .. } | Self::Force { value, .. } => value.iter().collect(),
            Self::Mass { value, place, inertia, .. } => {
                let place: &[Expr] = match place {
                    MassSite::At(place) => place,
                    MassSite::Here | MassSite::Point(_) | MassSite::Uniform(_) => &[],
                };
                [value].into_iter().chain(place).chain(inertia).collect()
            }
            Self::Inertia { value, .. }
            | Self::ForceBetween { value, .. }
            | Self::Torque { value, .. }
            | Self::TorqueBetween { value, .. } => vec![value],
            Self::Spring { fields, .. } => fields.values().collect(),
            Self::Stop(StopStatement { of, ends, fields, .. }) => {
                [of].into_iter().chain(ends).chain(fields.values()).collect()
            }
            Self::Friction(friction) => {
                let FrictionStatement { coefficient, radius, length, smooth, .. } = friction;
                [coefficient].into_iter().chain(radius).chain(length).chain(smooth).collect()
            }
        }
    }
}

/// `rrr BC(B), DC(D) -> C { lengths: (632mm, 374mm), mode: left }`.
#[derive(Clone)]
pub(crate) struct GroupStatement {
    /// `crank`, `slider`, `rrr`, …; not yet known to be one of them.
    pub keyword: Ident,
    pub legs: Vec<Leg>,
    pub pin: Option<Ident>,
    pub fields: Vec<GroupField>,
    /// The closing brace, where a missing field is reported.
    pub end: Span,
    /// True if all of its legs and its pin were read. After a mistake none of them is reported
    /// missing.
    pub head_is_read: bool,
    /// The same for the names of its fields.
    pub fields_are_read: bool,
}

/// `BC(B, C, blade) on slot`: a body through pins, rigid as it is drawn.
#[derive(Clone)]
pub(crate) struct DrawnLink {
    pub name: Ident,
    pub pins: Vec<Ident>,
    /// The guides on which it slides without turning.
    pub on: Vec<Ident>,
}

/// `drive BC.angle - AB.angle = theta;`.
#[derive(Clone)]
pub(crate) struct DriveStatement {
    pub link: Ident,
    /// `angle` or `slide`; not yet known to be one of them.
    pub member: Ident,
    /// The link that the first one is driven against and its member; the ground where there is none.
    pub to: Option<(Ident, Ident)>,
    pub value: Expr,
}

/// `solve theta { ram.slide = x, mode: falling, near: seed }`.
#[derive(Clone)]
pub(crate) struct Solve {
    pub unknown: Ident,
    /// The two sides; `None` only after a mistake.
    pub equation: Option<[Expr; 2]>,
    pub mode: Option<Ident>,
    pub near: Option<Expr>,
    /// The closing brace, where a missing mode is reported.
    pub end: Span,
    /// True if all of it was read. After a mistake nothing is reported missing.
    pub is_read: bool,
}

impl GroupStatement {
    /// A statement with fields, but without links or a pin.
    pub(super) fn without_links(keyword: Ident, end: Span) -> Self {
        Self {
            keyword,
            legs: Vec::new(),
            pin: None,
            fields: Vec::new(),
            end,
            head_is_read: true,
            fields_are_read: true,
        }
    }

    /// The values of its fields.
    pub(crate) fn values(&self) -> impl Iterator<Item = &Expr> {
        self.fields.iter().flat_map(|field| match &field.value {
            GroupFieldValue::One(value) => std::slice::from_ref(value),
            GroupFieldValue::Pair(values) => values,
        })
    }

    /// The links, as messages and run-time errors name the group.
    pub(crate) fn title(&self) -> String {
        self.legs.iter().map(|leg| leg.link.to_string()).collect::<Vec<_>>().join(", ")
    }
}

/// `BC(B)`: a link and what its outer joint stands on.
#[derive(Clone)]
pub(crate) struct Leg {
    pub link: Ident,
    /// `None` only after a mistake.
    pub joint: Option<Ident>,
}

/// `lengths: (632mm, 374mm)`.
#[derive(Clone)]
pub(crate) struct GroupField {
    pub name: Ident,
    pub value: GroupFieldValue,
}

#[derive(Clone)]
pub(crate) enum GroupFieldValue {
    /// A mode is an expression that is a bare name.
    One(Expr),
    Pair([Expr; 2]),
}

/// The place a guide goes through.
#[derive(Clone)]
pub(crate) enum GuideAnchor {
    At([Expr; 2]),
    Point(Ident),
    /// Could not be read, and was reported.
    Mistake,
}

/// Where a guide goes.
#[derive(Clone)]
pub(crate) enum Course {
    Along(Expr),
    Towards(Ident),
    /// Could not be read, and was reported.
    Mistake,
}

#[derive(Clone)]
pub(crate) enum PointPlace {
    /// `at (x, y)`
    Cartesian([Expr; 2]),
    /// `at polar (r, 20deg)`
    Polar([Expr; 2]),
    /// `at distances (r1, r2) left`
    Distances([Expr; 2], Ident),
    /// Could not be read, and was reported.
    Mistake,
}

#[derive(Clone)]
pub(crate) struct OutputItem {
    /// `fold =`, where the item is a named expression.
    pub name: Option<Ident>,
    /// Where `as` stands, if the name is written behind it: `C as tip`.
    pub renamed_at: Option<Span>,
    pub value: Expr,
}
