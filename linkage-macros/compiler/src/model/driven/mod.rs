//! Quantities of a drawing that are inputs, `input a = AB.angle, x = tool.x;`: plain inputs, and the statements that
//! drive what they are.
//!
//! [`coordinate`] reads a quantity, [`driving_statements`] writes what drives it. Angles and slides are driven, a point both of whose
//! coordinates are inputs is moved, a distance is a link with that length, and one coordinate of a point is the slide
//! of a carriage on which the point slides across. Links and guides that stand for a quantity are written by nobody:
//! the tree says by which texts messages tell them.

mod coordinate;
mod driving_statements;
mod input_sets;
mod quantities;

use std::borrow::Cow;

use proc_macro2::Ident;
use syn::Attribute;

use crate::diagnostics::Diagnostics;
use crate::syntax::tree::{Declaration, InputStatement, Statement, StatementKind};

use coordinate::Coordinate;
use driving_statements::DrivingStatements;
pub(crate) use input_sets::{DrivenBySet, drivings};
pub use quantities::PlanarQuantity;
pub(crate) use quantities::{DrivenQuantity, driven_quantities};

const FORM: &str = "a factor stands in front of the quantity and a constant behind it: `2 * tip.y`, \
                    `shank.angle + 90deg`";

/// The declaration with plain inputs and what drives the quantities that they are.
pub(super) fn lowered<'t>(
    tree: &'t Declaration,
    diagnostics: &mut Diagnostics,
) -> Cow<'t, Declaration> {
    let is_quantity = |statement: &Statement| match &statement.kind {
        StatementKind::Input(input) => !input.of.is_empty(),
        _ => false,
    };
    if !tree.statements.iter().any(is_quantity) {
        return Cow::Borrowed(tree);
    }
    let reported = diagnostics.count();
    let mut statements = Vec::new();
    let mut motions = DrivingStatements::of(tree);
    for statement in &tree.statements {
        match &statement.kind {
            StatementKind::Input(input) if !input.of.is_empty() => {
                inputs(input, &statement.docs, (&mut statements, &mut motions), diagnostics);
            }
            _ => statements.push(statement.clone()),
        }
    }
    let unwritten = motions.finish(&mut statements, diagnostics);
    let is_damaged = tree.is_damaged || diagnostics.count() > reported;
    Cow::Owned(Declaration { statements, unwritten, is_damaged, ..tree.clone() })
}

/// The inputs of a statement, those of one kind together, and what drives them.
fn inputs<'t>(
    input: &'t InputStatement,
    docs: &[Attribute],
    (statements, motions): (&mut Vec<Statement>, &mut DrivingStatements<'t>),
    diagnostics: &mut Diagnostics,
) {
    let mut last: Option<InputStatement> = None;
    let mut put = |statement: Option<InputStatement>| {
        let kind = statement.map(StatementKind::Input);
        statements.extend(kind.map(|kind| Statement { docs: docs.to_vec(), kind }));
    };
    for (name, of) in input.names.iter().zip(&input.of) {
        let found = Coordinate::of(name, of);
        let kind = found.as_ref().map(Coordinate::kind);
        match &mut last {
            Some(last) if last.kind == kind => last.names.push(name.clone()),
            _ => {
                let next = InputStatement { names: vec![name.clone()], kind, of: Vec::new() };
                put(last.replace(next));
            }
        }
        match found {
            Some(coordinate) => motions.drive(coordinate, diagnostics),
            None if of.is_mistake() => {}
            None => report_unknown(name, of, diagnostics),
        }
    }
    // An input without a quantity was reported as it was read.
    for name in input.names.iter().skip(input.of.len()) {
        put(last.replace(InputStatement { names: vec![name.clone()], kind: None, of: Vec::new() }));
    }
    put(last);
}

/// Reports an expression that no input can be.
fn report_unknown(name: &Ident, of: &crate::syntax::tree::Expr, diagnostics: &mut Diagnostics) {
    let mut is_constant = true;
    of.each_part(&mut |part| is_constant &= !coordinate::is_of_the_machine(part));
    if is_constant {
        let message = format!("`{name}` moves nothing; write `param` for a number with a default");
        let reason = "an input is a quantity of the machine: an angle, a slide, a length, a coordinate of a point \
                      or a distance";
        diagnostics.error_because(of.span, message, reason);
        return;
    }
    let message =
        "an input is one quantity of the machine, a factor before and a constant behind it";
    diagnostics.error_because(of.span, message, FORM);
}
