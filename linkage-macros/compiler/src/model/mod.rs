//! Names into typed ids, dimensions, and one function per rule; one file a statement.
//!
//! [`resolve`] walks the statements in order. Every statement makes what it declares, then looks
//! at what it was given; a name can be used from the next statement on. A mistake is reported
//! where it was made and everything else of the statement is still looked at; what a statement in
//! error has made stays known, so that its users get no message of their own. The same holds for
//! what the parser could not read: a damaged part is known to be there, and nothing more.
//!
//! Nothing here knows how a mechanism is solved. Of numbers there is what the rules need of constants, and what a
//! drawing needs: `drawn` finds the inputs of the drawn pose by Newton's method, and the angles of links that are held
//! together by the theorem of cosines.

pub(crate) mod acting;
pub(crate) mod as_drawn;
mod assembly;
mod calls;
mod class_three;
mod coincidence;
mod declared;
mod dimension;
mod drawn;
mod drawn_relations;
mod dynamics_outputs;
mod effort;
mod effort_formulas;
mod exponents;
mod expr;
mod expressions;
mod facts;
mod fields;
mod findings;
mod folding;
mod given;
mod ids;
mod incidence;
mod jointed;
mod kinds;
mod left_out;
mod link_efforts;
mod literals;
pub(crate) mod mechanism;
pub(crate) mod modes;
mod names;
mod needs;
mod numbers;
mod order;
mod readings;
mod reads;
mod references;
mod relations;
mod rotatability;
mod scope;
mod searched;
mod statements;
mod step;
mod stub;
mod titles;
pub(crate) mod units;
mod uses;

#[cfg(test)]
mod tests;

use crate::diagnostics::Diagnostics;
use crate::syntax::tree::{Declaration, Statement};

use mechanism::Mechanism;
use scope::Scope;
pub(crate) use statements::drive_by::load_does_no_work;
use statements::{acts, friction, input, output, rules, unknown};

/// The stub of a declaration in which something was reported.
pub(crate) struct Stub(pub Box<Mechanism>);

/// The mechanism that the declaration means; a stub of it if a mistake was reported, by the parser or
/// here.
pub(crate) fn resolve(
    tree: &Declaration,
    diagnostics: &mut Diagnostics,
) -> Result<Mechanism, Stub> {
    if drawn::is_drawn(tree) {
        let resolved = drawn::resolve(tree, diagnostics).filter(|_| diagnostics.count() == 0);
        return resolved.ok_or_else(|| Stub(Box::new(stub_of_drawing(tree, diagnostics))));
    }
    let scope = walked(tree, diagnostics, None);
    match scope.diagnostics.count() {
        0 => Ok(scope.mechanism),
        _ => Err(Stub(Box::new(stub::stub(scope, tree)))),
    }
}

/// The stub that the declaration would have if it had mistakes.
#[cfg(test)]
pub(crate) fn stub(tree: &Declaration) -> Mechanism {
    let mut diagnostics = Diagnostics::new();
    let stub = match drawn::is_drawn(tree) {
        true => stub_of_drawing(tree, &mut diagnostics),
        false => stub::stub(walked(tree, &mut diagnostics, None), tree),
    };
    drop(diagnostics.into_mistakes());
    stub
}

/// The stub of a drawing, which may not be one of drivers and groups. Mistakes were reported.
fn stub_of_drawing(tree: &Declaration, diagnostics: &mut Diagnostics) -> Mechanism {
    let reported = diagnostics.count();
    let mut scope = Scope::new(tree, &tree.unread, diagnostics);
    statements(&mut scope, tree);
    let stub = stub::stub(scope, tree);
    diagnostics.forget_since(reported);
    stub
}

/// The mechanism of a declaration of drivers and groups; `None` if anything in it was reported.
fn resolve_groups(
    tree: &Declaration,
    diagnostics: &mut Diagnostics,
    drawn: &drawn::DrawnLinks,
) -> Option<Mechanism> {
    let scope = walked(tree, diagnostics, Some(drawn));
    (scope.diagnostics.count() == 0).then_some(scope.mechanism)
}

/// Every statement and every rule; of a drawing, with what groups have made of its links.
fn walked<'d>(
    tree: &'d Declaration,
    diagnostics: &'d mut Diagnostics,
    drawn: Option<&'d drawn::DrawnLinks>,
) -> Scope<'d> {
    let mut scope = Scope::new(tree, &tree.unread, diagnostics);
    scope.drawn = drawn;
    scope.names.hide(drawn.map_or(&[], |drawn| &drawn.names));
    statements(&mut scope, tree);
    unknown::every_unknown_is_solved(&mut scope, tree);
    drawn::joints::links_are_as_drawn(&mut scope);
    friction::frictions(&mut scope, tree);
    output::outputs(&mut scope, tree);
    order::statements_are_in_order(&mut scope, tree);
    literals::bare_lengths_are_of_a_machine(&mut scope);
    input::an_input_is_declared(&mut scope, tree);
    input::every_input_is_used(&mut scope, tree, drawn.is_some());
    acts::actions_have_an_effect(&mut scope, tree);
    scope.mechanism.rotatabilities = rotatability::rotatabilities(&scope.mechanism);
    rotatability::cranks_can_turn(&mut scope);
    unknown::ends_can_be_assembled(&mut scope);
    scope
}

fn statements(scope: &mut Scope<'_>, tree: &Declaration) {
    for (index, next) in tree.statements.iter().enumerate() {
        scope.names.go_to(index);
        statement(scope, next);
        unknown::note_what_follows(scope, next);
    }
    scope.names.go_to(tree.statements.len());
}

fn statement(scope: &mut Scope<'_>, statement: &Statement) {
    // What a statement makes moves if anything that it uses does.
    let moves = uses::uses(scope, statement, |scope, entity| scope.facts.moves(entity));
    rules(statement).resolve(scope, &statement.docs, moves);
}
