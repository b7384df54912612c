//! Names into typed ids, dimensions, and one function per rule; one file a statement.
//!
//! [`resolve`] walks the statements in order. Every statement makes what it declares, then looks
//! at what it was given; a name can be used from the next statement on. A mistake is reported
//! where it was made and everything else of the statement is still looked at; what a statement in
//! error has made stays known, so that its users get no message of their own. The same holds for
//! what the parser could not read: a damaged part is known to be there, and nothing more.
//!
//! | rooms, each standing on those above it | |
//! |---|---|
//! | `dimension`, `units`, `expr`, `ids`, `mechanism`, `acting`, `effort` | the mechanism, as later phases read it |
//! | `names`, `facts`, `figures`, `scope` | all that is declared so far |
//! | `uses`, `declared`, `kinds`, `meant` | names where they are used, links and points where they are made |
//! | `resolved_expr`, `fits`, `literals`, `calls`, `laws`, `rates`, `ratios`, `loads_in_forces`, `readings`, `poles`, `machine_functions`, `expressions`, `numbers`, `told_numbers` | expressions, and numbers of drawings |
//! | `effort_dimensions`, `driven_through`, `named_efforts`, `link_efforts`, `dynamics_outputs`, `effort_formulas`, `given` | efforts, and what is asked for |
//! | `fields`, `modes`, `same_expression`, `opposite_sides`, `jointed`, `assembly`, `coincidence` | what the groups share |
//! | `statements` | a file a statement |
//! | `items`, `begun`, `statement_walk`, `references`, `needs`, `order`, `unused`, `stub` | the whole declaration |
//! | `drawn` | links and joints into drivers and groups |
//! | `driven` | quantities that are inputs into what drives them |
//! | `wheels` | the cranks that are coupled as gears are |
//!
//! Nothing here knows how a mechanism is solved. Of numbers there is what the rules need of constants, and what a
//! drawing needs: `drawn` finds the inputs of the drawn pose by Newton's method, and the angles of links that are held
//! together by the theorem of cosines.

pub mod acting;
pub(crate) mod any_assembly;
pub mod as_drawn;
mod as_written;
mod assembly;
mod begun;
mod calls;
pub mod class_three;
mod coincidence;
mod declared;
pub mod dimension;
pub mod drawn;
pub(crate) mod drawn_bodies;
mod drawn_joints;
mod drawn_links;
mod drawn_relations;
mod drawn_sliding;
mod driven;
mod driven_through;
mod dynamics_outputs;
mod effort;
pub(crate) mod effort_dimensions;
mod effort_formulas;
mod exponents;
pub mod expr;
pub mod expressions;
mod facts;
pub mod fields;
mod figures;
mod findings;
mod fits;
pub mod folding;
mod given;
mod ids;
pub mod incidence;
mod items;
mod jointed;
pub mod kinds;
pub mod laws;
mod left_out;
mod link_efforts;
mod literals;
mod loads_in_forces;
mod machine_functions;
mod meant;
pub mod mechanism;
pub(crate) mod modes;
mod named_efforts;
pub mod names;
mod needs;
pub mod numbers;
mod on_drawn_links;
mod opposite_sides;
mod order;
mod parts_of_groups;
mod poles;
mod rates;
pub mod ratios;
mod readings;
mod reads;
mod references;
mod relations;
mod resolved_expr;
pub mod rigid;
mod rotatability;
mod same_expression;
mod scope;
mod searched;

pub(crate) mod solved_at_once;
mod statement_walk;
mod statements;
mod step;
pub mod stub;
mod titles;
mod told_numbers;
pub(crate) mod touching;
pub mod units;
mod unknown_friction;
mod unused;
mod uses;
pub mod wheels;

use proc_macro2::TokenStream;

use crate::diagnostics::{Diagnostic, Diagnostics, Failure};
use crate::exact::Exact;
use crate::model::drawn_links::DrawnLinks;
use crate::model::items::{Item, items};
use crate::model::mechanism::{Dimension, Mechanism, ParamKind};
use crate::model::scope::Scope;
use crate::model::statements::contacts;
use crate::model::statements::output;
use crate::model::statements::unknowns;
use crate::syntax;
use crate::syntax::tree::Declaration;

pub(crate) use drawn::value_at_defaults;
pub use driven::PlanarQuantity;
pub(crate) use driven::{DrivenBySet, DrivenQuantity, driven_quantities, drivings};
pub(crate) use poles::link_never_turns;
pub(crate) use statements::drive_by::load_does_no_work;

/// The stub of a declaration in which something was reported.
pub struct Stub(pub Box<Mechanism>);

/// The mechanism that the declaration means; a stub of it if a mistake was reported, by the parser or
/// here.
pub fn resolve(tree: &Declaration, diagnostics: &mut Diagnostics) -> Result<Mechanism, Stub> {
    let tree = driven::lowered(tree, diagnostics);
    let resolved = resolve_statements(&tree, diagnostics);
    diagnostics.tell(&tree.unwritten.told);
    resolved
}

/// The same of a declaration of which no input is a quantity.
fn resolve_statements(
    tree: &Declaration,
    diagnostics: &mut Diagnostics,
) -> Result<Mechanism, Stub> {
    if drawn::is_drawn(tree) {
        let resolved = drawn::resolve(tree, diagnostics).filter(|_| diagnostics.count() == 0);
        return resolved.ok_or_else(|| Stub(Box::new(stub_of_drawing(tree, diagnostics))));
    }
    let scope = walked(tree, &items(tree), diagnostics, None);
    match scope.diagnostics.count() {
        0 => Ok(scope.mechanism),
        _ => Err(Stub(Box::new(stub::stub(scope, tree)))),
    }
}

/// A value that is written as the default of a parameter, and its dimension.
///
/// # Errors
/// The mistakes in it; none where it is no value at all.
pub(crate) fn written_value(text: &str) -> Result<(Exact, Dimension), Vec<Diagnostic>> {
    let source = format!("struct Value {{ param value = {text}; }}");
    // A bracket that closes too early would end the declaration.
    let (Ok(_), Ok(tokens)) = (text.parse::<TokenStream>(), source.parse()) else {
        return Err(Vec::new());
    };
    let mut diagnostics = Diagnostics::new();
    let found = syntax::parse(tokens, &mut diagnostics).and_then(|tree| {
        let items = items(&tree);
        let mut scope = begun::scope(&tree, &items, &tree.unread, &mut diagnostics);
        statement_walk::items(&mut scope, &items);
        let param = scope.mechanism.params.pop().filter(|_| tree.statements.len() == 1)?;
        match param.kind {
            ParamKind::Number { dimension, default, .. } => Some((default, dimension)),
            ParamKind::Mode { .. } => None,
        }
    });
    diagnostics.finish().map_err(|Failure(mistakes)| mistakes)?;
    found.ok_or_else(Vec::new)
}

/// The stub that the declaration would have if it had mistakes.
pub fn stub(tree: &Declaration) -> Mechanism {
    let mut diagnostics = Diagnostics::new();
    let stub = match drawn::is_drawn(tree) {
        true => stub_of_drawing(tree, &mut diagnostics),
        false => stub::stub(walked(tree, &items(tree), &mut diagnostics, None), tree),
    };
    drop(diagnostics.into_mistakes());
    stub
}

/// The stub of a drawing, which may not be one of drivers and groups. Mistakes were reported.
fn stub_of_drawing(tree: &Declaration, diagnostics: &mut Diagnostics) -> Mechanism {
    let reported = diagnostics.count();
    let items = items(tree);
    let mut scope = begun::scope(tree, &items, &tree.unread, diagnostics);
    statement_walk::items(&mut scope, &items);
    let stub = stub::stub(scope, tree);
    diagnostics.forget_since(reported);
    stub
}

/// Every statement and every rule; of a drawing, what it became, with what groups have made of its links.
fn walked<'d>(
    tree: &'d Declaration,
    items: &[Item<'_>],
    diagnostics: &'d mut Diagnostics,
    drawn: Option<&'d DrawnLinks>,
) -> Scope<'d> {
    let mut scope = begun::scope(tree, items, &tree.unread, diagnostics);
    scope.drawn = drawn;
    scope.names.hide_unwritten(&scope.mechanism.references);
    statement_walk::items(&mut scope, items);
    unknowns::every_unknown_is_solved(&mut scope, tree);
    drawn_joints::links_are_as_drawn(&mut scope);
    contacts::frictions(&mut scope, tree);
    output::outputs(&mut scope, tree);
    order::items_are_in_order(&mut scope, items);
    literals::bare_lengths_are_of_a_machine(&mut scope);
    unused::an_input_is_declared(&mut scope, tree);
    scope.names.use_is_hidden |= scope.diagnostics.count() > 0;
    unused::every_input_is_used(&mut scope, tree);
    unused::actions_have_an_effect(&mut scope, tree);
    contacts::frictions_are_pressed(&mut scope, tree);
    scope.mechanism.rotatabilities = rotatability::rotatabilities(&scope.mechanism);
    rotatability::cranks_can_turn(&mut scope);
    rotatability::note_change_points(&mut scope);
    scope.mechanism.touchings = touching::touchings(&scope);
    unknowns::ends_can_be_assembled(&mut scope);
    scope
}
