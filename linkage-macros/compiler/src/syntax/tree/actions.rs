//! Statements about forces as written: what has mass, and what acts.

use proc_macro2::{Ident, Span};

use super::{Expr, GroupStatement};

/// A mass or an action.
#[derive(Clone)]
pub enum Action {
    Gravity(GravityStatement),
    Mass(MassStatement),
    Inertia(InertiaStatement),
    Force(ForceStatement),
    ForceBetween(ForceBetweenStatement),
    Torque(TorqueStatement),
    TorqueBetween(TorqueBetweenStatement),
    Spring(SpringStatement),
    Friction(FrictionStatement),
    Stop(StopStatement),
}

impl Action {
    /// True if something has mass or acts by it.
    pub(crate) fn acts(&self) -> bool {
        !matches!(self, Self::Gravity(_))
    }
}

/// `load cut: force;`; without a kind only after a mistake.
#[derive(Clone)]
pub struct LoadStatement {
    pub names: Vec<Ident>,
    pub kind: Option<Ident>,
}

/// `gravity (0, -g);` and where it stands.
#[derive(Clone)]
pub struct GravityStatement {
    pub at: Span,
    pub value: [Expr; 2],
}

/// `mass 2kg on BC at G inertia 0.1(kg*m^2);`
#[derive(Clone)]
pub struct MassStatement {
    pub value: Expr,
    pub on: Ident,
    pub place: MassSite,
    pub inertia: Option<Expr>,
}

/// `inertia J on AB;`
#[derive(Clone)]
pub struct InertiaStatement {
    pub value: Expr,
    pub on: Ident,
}

/// `force (0, -f) in BC on P;`
#[derive(Clone)]
pub struct ForceStatement {
    pub value: [Expr; 2],
    pub axes: Option<Ident>,
    pub on: Ident,
}

/// `force f between P and Q;`
#[derive(Clone)]
pub struct ForceBetweenStatement {
    pub value: Expr,
    pub points: [Ident; 2],
}

/// `torque t on DC;`
#[derive(Clone)]
pub struct TorqueStatement {
    pub value: Expr,
    pub on: Ident,
}

/// `torque t between AB and DC;`
#[derive(Clone)]
pub struct TorqueBetweenStatement {
    pub value: Expr,
    pub bodies: [Ident; 2],
}

/// `spring shock between P and Q { stiffness: 15(N/m), free_length: 0.3m }`: two points, or two bodies.
/// Its fields are read like those of a group.
#[derive(Clone)]
pub struct SpringStatement {
    pub name: Option<Ident>,
    pub ends: [Ident; 2],
    pub fields: GroupStatement,
}

/// `stop DC.angle between (20deg, 110deg) { stiffness: 2e4(N*m/rad) }`, with or without a name. Its fields are read like
/// those of a group.
#[derive(Clone)]
pub struct StopStatement {
    pub name: Option<Ident>,
    pub of: Expr,
    pub ends: [Expr; 2],
    pub fields: GroupStatement,
}

/// `friction 0.1 at C radius 8mm;`, at a pin or a guide, and where its word stands.
#[derive(Clone)]
pub struct FrictionStatement {
    pub at: Span,
    pub coefficient: Expr,
    pub site: FrictionSite,
    pub radius: Option<Expr>,
    pub length: Option<Expr>,
    pub smooth: Option<Expr>,
}

/// The joint that has friction.
#[derive(Clone)]
pub enum FrictionSite {
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
pub enum MassSite {
    /// Nothing is said: the mass is on a point.
    Here,
    /// `at (x, y)` in the link's frame.
    At([Expr; 2]),
    /// `at G`
    Point(Ident),
    /// `uniform`, and where the word stands.
    Uniform(Span),
}
