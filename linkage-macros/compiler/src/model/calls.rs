//! Calls of functions of numbers.

use proc_macro2::Ident;

use crate::diagnostics::nearest;
use crate::function::{Function, Measures};
use crate::syntax::tree;

use crate::model::dimension::{Dimension, Measure};
use crate::model::folding::shown;
use crate::model::mechanism::Scalar;
use crate::model::names::Kind;
use crate::model::reads::{Allowed, Reads};
use crate::model::resolved_expr::{Resolve, ResolvedExpr, bare_name, counted};
use crate::model::scope::Scope;
use crate::model::{exponents, fits, machine_functions, readings};

pub(super) fn call(
    scope: &mut Scope<'_>,
    name: &Ident,
    arguments: &[tree::Expr],
    allowed: Allowed,
    resolve: Resolve,
) -> Option<ResolvedExpr> {
    let Some(function) = Function::named(&name.to_string()) else {
        if member_as_a_function(scope, name, arguments) {
            return None;
        }
        function_exists(scope, name);
        // It may be a function of points or guides.
        let numbers = arguments.iter().filter(|argument| !readings::is_a_place(scope, argument));
        let numbers: Vec<_> = numbers.collect();
        numbers.into_iter().for_each(|argument| drop(resolve(scope, argument, allowed)));
        return None;
    };
    let values = arguments.iter().map(|argument| resolve(scope, argument, allowed));
    let values: Vec<_> = values.collect();
    if arguments.len() != function.arity() {
        let takes = if function.arity() == 1 { "one argument" } else { "two arguments" };
        let message = format!("`{name}` takes {takes}, and {} given", counted(arguments.len()));
        scope.diagnostics.error(name.span(), message);
        return None;
    }
    let values: Vec<_> = values.into_iter().collect::<Option<_>>()?;
    for (argument, value) in arguments.iter().zip(&values) {
        fits::no_link_angle(scope, argument, value)?;
    }
    let measure = measure_of_call(scope, function, arguments, &values)?;
    let mut reads = values.iter().fold(Reads::default(), |all, value| all.and(&value.reads));
    let rests = exponents::arguments_above_zero(function, arguments, values);
    let constants: Vec<_> = rests.iter().filter_map(|rest| rest.constant()).map(shown).collect();
    let called = Scalar::call(function, rests);
    if called.is_none() {
        let call = format!("{name}({})", constants.join(", "));
        function_is_defined(scope, function, &arguments[0], &call);
    }
    let called = called?;
    if !function.is_smooth() && !called.is_constant() {
        reads = reads.with_a_corner(function.name());
    }
    if !function.is_smooth() && !called.is_constant() && !allowed.corners {
        let message = format!("`{name}` stands in forces, torques and outputs alone");
        let reason = "a dimension is smooth: write `hypot(x, e)` with a small `e` for `abs(x)`";
        scope.diagnostics.error_because(name.span(), message, reason);
        return None;
    }
    Some(ResolvedExpr { reads, ..ResolvedExpr::plain(measure, called) })
}

/// Reports `angle(BC)` and `x(P)`; whether it was one of these.
fn member_as_a_function(scope: &mut Scope<'_>, name: &Ident, arguments: &[tree::Expr]) -> bool {
    let names: Vec<_> = arguments.iter().filter_map(bare_name).collect();
    if let [first, second] = names[..]
        && name == "angle"
        && names.iter().all(|owner| scope.names.kind(owner) == Some(Kind::Link))
    {
        let message = format!("write `{first}.angle - {second}.angle`");
        let reason = "an angle between two links is a difference, and an output of it has a name: `output fold = …;`";
        scope.diagnostics.error_because(name.span(), message, reason);
        return true;
    }
    let [Some(owner)] = arguments.iter().map(bare_name).collect::<Vec<_>>()[..] else {
        return false;
    };
    let members: &[&str] = match scope.names.kind(owner) {
        Some(Kind::Link) => &["angle", "slide"],
        Some(Kind::Point) => &["x", "y"],
        _ => return false,
    };
    let is_member = members.iter().any(|member| name == member);
    if is_member {
        let message = format!("write `{owner}.{name}`");
        let reason = "what a link or a point has stands behind its name";
        scope.diagnostics.error_because(name.span(), message, reason);
    }
    is_member
}

/// Reports a function that does not exist, with the nearest one.
fn function_exists(scope: &mut Scope<'_>, name: &Ident) {
    let text = name.to_string();
    let mut message = format!("no function named `{text}`");
    let others = || machine_functions::all();
    let known = Function::names().chain(others().map(|row| row.name));
    if let Some(near) = nearest(&text, known) {
        message += &format!("; a function with a similar name exists: `{near}`");
    }
    let everywhere = others().filter(|row| row.stands_in.is_none()).map(|row| row.name);
    let names: Vec<_> = Function::names().chain(everywhere).collect();
    let limited = others().filter_map(|row| Some(format!("`{}` in {}", row.name, row.stands_in?)));
    let limited: Vec<_> = limited.collect();
    let reason = format!("the functions are `{}`, and {}", names.join(" "), limited.join(", "));
    scope.diagnostics.error_because(name.span(), message, reason);
}

/// Reports a function of constants where it has no value.
fn function_is_defined(
    scope: &mut Scope<'_>,
    function: Function,
    argument: &tree::Expr,
    call: &str,
) {
    let message = format!("`{call}` has no value");
    scope.diagnostics.error_because(argument.span, message, function.domain());
}

/// The arguments of a function have the dimensions it is defined for.
fn measure_of_call(
    scope: &mut Scope<'_>,
    function: Function,
    arguments: &[tree::Expr],
    values: &[ResolvedExpr],
) -> Option<Measure> {
    match function.measures() {
        Measures::Root => {
            let root = values[0].measure.root();
            if root.is_none() {
                let message = format!(
                    "the square root of {} has no dimension",
                    values[0].measure.dimension().words()
                );
                let reason = "the powers of its units must be even";
                scope.diagnostics.error_because(arguments[0].span, message, reason);
            }
            root
        }
        Measures::OfAngle => {
            fits::dimension_fits(scope, &arguments[0], &values[0], Dimension::ANGLE)?;
            Some(Measure::NUMBER)
        }
        Measures::Common if values.len() == 1 => Some(values[0].measure),
        Measures::Number => Some(Measure::NUMBER),
        Measures::Plain => {
            fits::dimension_fits(scope, &arguments[0], &values[0], Dimension::NUMBER)?;
            Some(Measure::NUMBER)
        }
        Measures::Power => exponents::measure_of_power(scope, arguments, values),
        Measures::OfNumber => {
            fits::dimension_fits(scope, &arguments[0], &values[0], Dimension::NUMBER)?;
            Some(Measure::ANGLE)
        }
        measures @ (Measures::Common | Measures::Direction) => {
            let sum = values[0].measure.sum(values[1].measure);
            if sum.is_none() {
                fits::dimension_fits(
                    scope,
                    &arguments[1],
                    &values[1],
                    values[0].measure.dimension(),
                )?;
            }
            sum.map(|sum| if measures == Measures::Common { sum } else { Measure::ANGLE })
        }
    }
}
