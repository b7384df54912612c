//! Functions of points, guides, links and motion, a row each. Those of numbers stand in `function`.

use proc_macro2::Ident;

use crate::syntax::tree::{Expr, ExprKind};

use crate::model::mechanism::OutputKind;
use crate::model::poles::{self, POLE};
use crate::model::rates::{self, RATE};
use crate::model::readings;
use crate::model::reads::Allowed;
use crate::model::resolved_expr::{Resolve, ResolvedExpr};
use crate::model::scope::Scope;

type ResolveCall = fn(&mut Scope<'_>, &Ident, &[Expr], Allowed, Resolve) -> Option<ResolvedExpr>;

/// A function with what it means.
pub(in crate::model) struct MachineFunction {
    pub name: &'static str,
    /// Where it stands, if not wherever a number does.
    pub stands_in: Option<&'static str>,
    /// A call of it in an expression.
    pub resolve: ResolveCall,
    /// Its value, where that is no number.
    pub point: Option<PointFunction>,
}

/// A function whose value is a point, which is an output with a name.
#[derive(Clone, Copy)]
pub(in crate::model) struct PointFunction {
    /// The output of a call. Reports every mistake in it.
    pub output: fn(&mut Scope<'_>, &Ident, &[Expr]) -> Option<OutputKind>,
    /// The output in a stub.
    pub stand_in: fn() -> OutputKind,
}

const ROWS: [MachineFunction; 4] = [
    number("distance", |scope, name, points, _, _| readings::distance(scope, name, points)),
    number("offset", |scope, name, both, _, _| readings::offset_from_guide(scope, name, both)),
    MachineFunction { stands_in: Some("forces, torques and outputs"), ..number(RATE, rates::rate) },
    MachineFunction {
        stands_in: Some("outputs"),
        point: Some(PointFunction {
            output: poles::pole,
            stand_in: || OutputKind::Pole(Vec::new()),
        }),
        ..number(POLE, |scope, name, links, _, _| poles::pole_is_a_point(scope, name, links))
    },
];

/// A function that stands wherever a number does.
const fn number(name: &'static str, resolve: ResolveCall) -> MachineFunction {
    MachineFunction { name, stands_in: None, resolve, point: None }
}

/// All of them.
pub(in crate::model) fn all() -> impl Iterator<Item = &'static MachineFunction> {
    ROWS.iter()
}

/// The row of a name.
pub(in crate::model) fn named(name: &Ident) -> Option<&'static MachineFunction> {
    all().find(|row| name == row.name)
}

/// The function that is called, where its value is a point.
pub(in crate::model) fn point_function(value: &Expr) -> Option<PointFunction> {
    match &value.kind {
        ExprKind::Call(function, _) => named(function)?.point,
        _ => None,
    }
}
