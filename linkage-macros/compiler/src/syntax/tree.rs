//! The declaration as written: names are not resolved, dimensions not checked.
//!
//! Every identifier and expression keeps its span, because every later message points at one.

mod actions;
mod calculation;
mod kinematic;

use std::collections::HashSet;

use proc_macro2::Ident;
use syn::{Attribute, Visibility};

pub use actions::*;
pub use calculation::{BinaryOp, Expr, ExprKind, UnitPower};
pub use kinematic::*;

/// `pub struct Name { statements }`.
#[derive(Clone)]
pub struct Declaration {
    /// Doc comments of the struct.
    pub docs: Vec<Attribute>,
    pub visibility: Visibility,
    pub name: Ident,
    pub statements: Vec<Statement>,
    pub unread: Unread,
    /// True if a statement by which the machine moves was not read as it is written: what else moves waits.
    pub is_damaged: bool,
    pub unwritten: Unwritten,
}

/// Links and guides that stand for quantities, which nobody has written.
#[derive(Clone, Default)]
pub struct Unwritten {
    pub names: Vec<Ident>,
    /// Texts of messages, and what is told in place of them.
    pub told: Vec<[String; 2]>,
    /// The set of inputs, where the declaration is that of one of several.
    pub set: Option<Ident>,
}

/// The tokens that a mistake kept from being read. A name among them may have been declared or used
/// there, so later phases do not report its absence.
#[derive(Clone)]
pub enum Unread {
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
pub struct Statement {
    /// Doc comments in front of the statement.
    pub docs: Vec<Attribute>,
    pub kind: StatementKind,
}

#[derive(Clone)]
pub enum StatementKind {
    /// `input s, x: length;` or `input a = AB.angle, x = tool.x;`
    Input(InputStatement),
    /// `input hand { x = tool.x, y = tool.y }`; a declaration with such sets stands for one a set.
    InputSet(InputSetStatement),
    /// `param l = 632mm;` or `param elbow: mode = left;`; `kind` is the word after the colon.
    Param(ParamStatement),
    /// `unknown theta: angle between (10deg, 170deg);`; without a kind or ends only after a mistake.
    Unknown(UnknownStatement),
    /// `solve theta { ram.slide = x, mode: falling, near: seed }`
    Solve(Solve),
    /// `let half = l / 2;`
    Let(LetStatement),
    /// `ground A(0, 0), D(…);`
    Ground(GroundStatement),
    /// `pin B(80mm, 0), C(600mm, 360mm);`: where joints and tracer points are in the drawing.
    Pin(PinStatement),
    /// `link AB(A, B), block(Q) on slot;` or `link lift(F, G) { length: s }`
    Link(LinkStatement),
    /// `drive AB.angle = theta;`
    Drive(DriveStatement),
    /// `drive theta by pull;`: the load that puts in the effort of an input.
    DriveBy(DriveByStatement),
    /// `guide slot on BC through P towards C;`
    Guide(GuideStatement),
    /// `point P on BC at …;`
    Point(PointStatement),
    /// Everything with braces of fields: crank, slider and the dyads.
    Group(GroupStatement),
    /// `load cut: force;`; without a kind only after a mistake.
    Load(LoadStatement),
    /// A mass or an action.
    Action(Action),
    /// `output blade, DC.angle, fold = BC.angle - DC.angle;`
    Output(OutputStatement),
    /// `numerics compensated;`
    Numerics(NumericsStatement),
    /// `crate = ::path;`: where `linkage-core` is found.
    Crate(CrateStatement),
    /// `export c;`
    Export(ExportStatement),
}

impl StatementKind {
    /// True if it puts a force on one or two points.
    pub(crate) fn is_force(&self) -> bool {
        matches!(self, Self::Action(Action::Force(_) | Action::ForceBetween(_)))
    }
}
