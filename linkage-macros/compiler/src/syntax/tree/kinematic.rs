//! Statements about the machine itself as written: its numbers, its links and joints, and what is asked of it.

use proc_macro2::{Ident, Span};

use super::Expr;

/// `input s, x: length;` or `input a = AB.angle, x = tool.x;`.
#[derive(Clone)]
pub struct InputStatement {
    pub names: Vec<Ident>,
    /// The word after the colon; where there is none, the inputs are quantities, or the kind is a mistake.
    pub kind: Option<Ident>,
    /// The quantity of each input; none where they are of a kind.
    pub of: Vec<Expr>,
}

/// `input hand { x = tool.x, y = tool.y }`
#[derive(Clone)]
pub struct InputSetStatement {
    pub name: Ident,
    pub coordinates: Vec<SetCoordinate>,
}

/// `x = tool.x`; without a quantity where another set says it.
#[derive(Clone)]
pub struct SetCoordinate {
    pub name: Ident,
    pub of: Option<Expr>,
}

/// `param l = 632mm;` or `param elbow: mode = left;`.
#[derive(Clone)]
pub struct ParamStatement {
    pub name: Ident,
    /// The word after the colon.
    pub kind: Option<Ident>,
    pub default: Expr,
}

/// `let half = l / 2;`
#[derive(Clone)]
pub struct LetStatement {
    pub name: Ident,
    pub value: Expr,
}

/// `unknown theta: angle between (10deg, 170deg);`; without a kind or ends only after a mistake.
#[derive(Clone)]
pub struct UnknownStatement {
    pub name: Ident,
    pub kind: Option<Ident>,
    pub between: Option<[Expr; 2]>,
}

/// `ground A(0, 0), D(…);`
#[derive(Clone)]
pub struct GroundStatement {
    pub points: Vec<(Ident, [Expr; 2])>,
}

/// `pin B(80mm, 0), C(600mm, 360mm);`
#[derive(Clone)]
pub struct PinStatement {
    pub points: Vec<(Ident, [Expr; 2])>,
}

/// `link AB(A, B), block(Q) on slot;` or `link lift(F, G) { length: s }`
#[derive(Clone)]
pub struct LinkStatement {
    pub links: Vec<DrawnLink>,
    pub fields: Option<GroupStatement>,
}

/// `drive theta by pull;`: the load that puts in the effort of an input.
#[derive(Clone)]
pub struct DriveByStatement {
    pub input: Ident,
    pub load: Ident,
}

/// `guide slot on BC through P towards C;`
#[derive(Clone)]
pub struct GuideStatement {
    pub name: Ident,
    pub on: Option<Ident>,
    pub through: GuideAnchor,
    pub course: Course,
}

/// `point P on BC at …;`
#[derive(Clone)]
pub struct PointStatement {
    pub name: Ident,
    pub on: Option<Ident>,
    pub place: PointPlace,
}

/// `output blade, DC.angle, fold = BC.angle - DC.angle;`
#[derive(Clone)]
pub struct OutputStatement {
    pub items: Vec<OutputItem>,
    /// True if these stand beside what is asked for elsewhere, or beside all where nothing is.
    pub is_beside: bool,
}

/// `numerics compensated;`
#[derive(Clone)]
pub struct NumericsStatement {
    pub mode: Ident,
}

/// `crate = ::path;`: where `linkage-core` is found.
#[derive(Clone)]
pub struct CrateStatement {
    pub path: syn::Path,
}

/// `export c;` or `export assemblies;`
#[derive(Clone)]
pub struct ExportStatement {
    pub what: Ident,
}

/// `rrr BC(B), DC(D) -> C { lengths: (632mm, 374mm), mode: left }`.
#[derive(Clone)]
pub struct GroupStatement {
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
pub struct DrawnLink {
    pub name: Ident,
    pub pins: Vec<Ident>,
    /// The guides on which it slides without turning.
    pub on: Vec<Ident>,
}

/// `drive BC.angle - AB.angle = theta;`.
#[derive(Clone)]
pub struct DriveStatement {
    pub link: Ident,
    /// `angle` or `slide`; not yet known to be one of them.
    pub member: Ident,
    /// The link that the first one is driven against and its member; the ground where there is none.
    pub to: Option<(Ident, Ident)>,
    pub value: Expr,
    /// The link and its member that the statement drives, where it is read the other way round.
    pub written: Option<(Ident, Ident)>,
}

/// `solve theta { ram.slide = x, mode: falling, near: seed }`.
#[derive(Clone)]
pub struct Solve {
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
    pub(crate) fn without_links(keyword: Ident, end: Span) -> Self {
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
pub struct Leg {
    pub link: Ident,
    /// `None` only after a mistake.
    pub joint: Option<Ident>,
}

/// `lengths: (632mm, 374mm)`.
#[derive(Clone)]
pub struct GroupField {
    pub name: Ident,
    pub value: GroupFieldValue,
}

#[derive(Clone)]
pub enum GroupFieldValue {
    /// A mode is an expression that is a bare name.
    One(Expr),
    Pair([Expr; 2]),
}

/// The place a guide goes through.
#[derive(Clone)]
pub enum GuideAnchor<N = Expr> {
    At([N; 2]),
    Point(Ident),
    /// Could not be read, and was reported.
    Mistake,
}

/// Where a guide goes.
#[derive(Clone)]
pub enum Course<N = Expr> {
    Along(N),
    Towards(Ident),
    /// Could not be read, and was reported.
    Mistake,
}

#[derive(Clone)]
pub enum PointPlace {
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
pub struct OutputItem {
    /// `fold =`, where the item is a named expression.
    pub name: Option<Ident>,
    /// Where `as` stands, if the name is written behind it: `C as tip`.
    pub renamed_at: Option<Span>,
    pub value: Expr,
}
