//! `pole(BC)`, `pole(BC, DE)`: instant centres, as outputs.

use proc_macro2::Ident;

use crate::diagnostics::Diagnostics;
use crate::syntax::tree::Expr;

use crate::model::ids::LinkId;
use crate::model::mechanism::{Mechanism, OutputKind};
use crate::model::names::listed;
use crate::model::resolved_expr::{ResolvedExpr, bare_name, counted};
use crate::model::scope::Scope;
use crate::model::uses;

/// The function of one link or two, whose value is a point.
pub(in crate::model) const POLE: &str = "pole";

/// `output I = pole(BC);`
pub(in crate::model) fn pole(
    scope: &mut Scope<'_>,
    function: &Ident,
    arguments: &[Expr],
) -> Option<OutputKind> {
    let links = links(scope, function, arguments);
    one_input_moves(scope, function).and(links).map(OutputKind::Pole)
}

/// The links of a pole: two different ones, or one and the ground.
fn links(
    scope: &mut Scope<'_>,
    function: &Ident,
    arguments: &[Expr],
) -> Option<Vec<(LinkId, Ident)>> {
    let links: Vec<_> = arguments.iter().map(|argument| link(scope, argument)).collect();
    if !(1..=2).contains(&links.len()) {
        let given = counted(links.len());
        let message = format!("`{function}` takes a link, or two, and {given} given");
        scope.diagnostics.error(function.span(), message);
        return None;
    }
    let links: Vec<_> = links.into_iter().collect::<Option<_>>()?;
    if let [(first, _), (second, name)] = &links[..]
        && first == second
    {
        let message = format!("`{name}` has no pole against itself; name two links");
        let reason = format!("its pole against the ground is `{POLE}({name})`");
        scope.diagnostics.error_because(name.span(), message, reason);
        return None;
    }
    Some(links)
}

fn link(scope: &mut Scope<'_>, argument: &Expr) -> Option<(LinkId, Ident)> {
    match bare_name(argument) {
        Some(name) if name == "ground" => {
            let message = "leave out `ground`";
            let reason =
                format!("`{POLE}(BC)` is the pole against the ground, which has none itself");
            scope.diagnostics.error_because(argument.span, message, reason);
            None
        }
        Some(name) => Some((uses::link(scope, name)?, name.clone())),
        None if argument.is_mistake() => None,
        None => {
            let message = "a pole is that of a link; write its name";
            let reason = format!("as in `output I = {POLE}(BC)`, or `{POLE}(BC, DE)` of two links");
            scope.diagnostics.error_because(argument.span, message, reason);
            None
        }
    }
}

/// The velocities of a link are one family where one input moves it.
fn one_input_moves(scope: &mut Scope<'_>, at: &Ident) -> Option<()> {
    let inputs: Vec<_> = scope.mechanism.inputs.iter().map(|input| input.name.clone()).collect();
    if inputs.len() == 1 {
        return Some(());
    }
    let message = match inputs.len() {
        0 => "nothing moves here, and there is no pole".to_string(),
        _ => "a pole is that of one input".to_string(),
    };
    let named: Vec<_> = inputs.iter().map(|name| format!("`{name}`")).collect();
    let reason = match inputs.len() {
        0 => "an instant centre is where a link that moves has no velocity".to_string(),
        _ => format!("where {} move, it depends on their rates", listed(&named, "and")),
    };
    scope.diagnostics.error_because(at.span(), message, reason);
    None
}

/// Reports a pole where a number belongs.
pub(in crate::model) fn pole_is_a_point(
    scope: &mut Scope<'_>,
    function: &Ident,
    arguments: &[Expr],
) -> Option<ResolvedExpr> {
    if links(scope, function, arguments).is_some() {
        let message = format!("a pole has a name; write `output I = {function}(…)`");
        let reason = "the result has `I.x` and `I.y`";
        scope.diagnostics.error_because(function.span(), message, reason);
    }
    None
}

/// Reports the pole of links that keep their direction in every pose.
pub(crate) fn link_never_turns(
    mechanism: &Mechanism,
    links: &[(LinkId, Ident)],
    diagnostics: &mut Diagnostics,
) {
    let Some((link, name)) = links.first() else { return };
    let known = mechanism.links[link.index()].known_as();
    let message = match links.get(1) {
        Some((_, other)) => {
            format!("`{known}` never turns against `{other}`, and has no pole there")
        }
        None => format!("`{known}` never turns, and has no pole"),
    };
    let reason = "an instant centre is that of a link that turns: what moves along a line, or on a circle without \
                  turning, has it at infinity";
    diagnostics.error_because(name.span(), message, reason);
}
