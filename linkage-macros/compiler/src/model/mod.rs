//! Names into typed ids, dimensions, and one function per rule.
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
mod actions;
mod assembly;
mod class_three;
mod coincidence;
mod contacts;
mod dimension;
mod drawn;
mod driving_load;
mod dyads;
mod dynamics_outputs;
mod effort;
mod effort_formulas;
mod end_stops;
mod exponents;
mod expr;
mod expressions;
mod facts;
mod fields;
mod findings;
mod folding;
mod guides;
mod ids;
mod incidence;
mod inputs;
mod jointed;
mod laws;
mod left_out;
mod literals;
mod masses;
pub(crate) mod mechanism;
pub(crate) mod modes;
mod names;
mod needs;
mod numbers;
mod order;
mod outputs;
mod points;
mod readings;
mod references;
mod relations;
mod rotatability;
mod searched;
mod settings;
mod solves;
mod spring_damper;
mod step;
mod stub;
mod titles;
pub(crate) mod units;
mod unknowns;
mod uses;

#[cfg(test)]
mod tests;

use std::collections::HashSet;

use proc_macro2::Ident;

use crate::diagnostics::Diagnostics;
use crate::syntax::tree::{Declaration, Statement, StatementKind, Unread};

pub(crate) use driving_load::load_does_no_work;
use facts::Facts;
use mechanism::{Mechanism, References};
use names::{Names, TooEarly};

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
    let resolver = walked(tree, diagnostics, None);
    match resolver.diagnostics.count() {
        0 => Ok(resolver.mechanism),
        _ => Err(Stub(Box::new(resolver.stub(tree)))),
    }
}

/// The stub that the declaration would have if it had mistakes.
#[cfg(test)]
pub(crate) fn stub(tree: &Declaration) -> Mechanism {
    let mut diagnostics = Diagnostics::new();
    let stub = match drawn::is_drawn(tree) {
        true => stub_of_drawing(tree, &mut diagnostics),
        false => walked(tree, &mut diagnostics, None).stub(tree),
    };
    drop(diagnostics.into_mistakes());
    stub
}

/// The stub of a drawing, which may not be one of drivers and groups. Mistakes were reported.
fn stub_of_drawing(tree: &Declaration, diagnostics: &mut Diagnostics) -> Mechanism {
    let reported = diagnostics.count();
    let mut resolver = Resolver::new(tree, &tree.unread, diagnostics);
    resolver.statements(tree);
    let stub = resolver.stub(tree);
    diagnostics.forget_since(reported);
    stub
}

/// The mechanism of a declaration of drivers and groups; `None` if anything in it was reported.
fn resolve_groups(
    tree: &Declaration,
    diagnostics: &mut Diagnostics,
    turned: &[drawn::TurnedFrame],
) -> Option<Mechanism> {
    let resolver = walked(tree, diagnostics, Some(turned));
    (resolver.diagnostics.count() == 0).then_some(resolver.mechanism)
}

/// Every statement and every rule; of a drawing, `turned` links with the frames that they are written in.
fn walked<'d>(
    tree: &'d Declaration,
    diagnostics: &'d mut Diagnostics,
    turned: Option<&[drawn::TurnedFrame]>,
) -> Resolver<'d> {
    let mut resolver = Resolver::new(tree, &tree.unread, diagnostics);
    resolver.statements(tree);
    resolver.every_unknown_is_solved(tree);
    resolver.frictions(tree);
    resolver.outputs(tree);
    resolver.statements_are_in_order(tree);
    resolver.bare_lengths_are_of_a_machine();
    resolver.an_input_is_declared(tree);
    resolver.every_input_is_used(tree, turned.is_some());
    resolver.actions_have_an_effect(tree);
    resolver.mechanism.rotatabilities = rotatability::rotatabilities(&resolver.mechanism);
    resolver.cranks_can_turn();
    resolver.ends_can_be_assembled();
    resolver.directions_are_as_written(turned.unwrap_or_default());
    resolver
}

/// The state of the resolver while it walks the statements.
struct Resolver<'d> {
    diagnostics: &'d mut Diagnostics,
    /// The tokens that the parser gave up. Nothing is known of a name among them.
    unread: &'d Unread,
    names: Names,
    mechanism: Mechanism,
    facts: Facts,
    /// Names used before they are made.
    too_early: Vec<TooEarly>,
    /// True if a mistake may have hidden the use of an input.
    use_is_hidden: bool,
    /// True if an expression names a number that nothing declares.
    number_is_unknown: bool,
    /// Names that nothing declares, and that were reported.
    reported_unknown: HashSet<String>,
    /// Where gravity is given.
    gravity_at: Option<proc_macro2::Span>,
    /// The load that drives an input.
    driving: Option<String>,
    /// The names behind `solve`.
    solved: HashSet<String>,
    /// The pins of a drawing, which are resolved as points that stand still.
    pins: HashSet<String>,
}

impl<'d> Resolver<'d> {
    fn new(tree: &Declaration, unread: &'d Unread, diagnostics: &'d mut Diagnostics) -> Self {
        Self {
            diagnostics,
            unread,
            names: Names::collect(tree),
            mechanism: empty(tree),
            facts: Facts::of(tree),
            too_early: Vec::new(),
            use_is_hidden: false,
            number_is_unknown: false,
            reported_unknown: HashSet::new(),
            gravity_at: None,
            driving: driving_load::named_by(tree).map(Ident::to_string),
            solved: tree.statements.iter().filter_map(solved).collect(),
            pins: HashSet::new(),
        }
    }
}

impl Resolver<'_> {
    fn statements(&mut self, tree: &Declaration) {
        for (index, statement) in tree.statements.iter().enumerate() {
            self.names.go_to(index);
            self.statement(statement);
            self.note_what_follows(statement);
        }
        self.names.go_to(tree.statements.len());
    }

    fn statement(&mut self, statement: &Statement) {
        let docs = &statement.docs;
        // What a statement makes moves if anything that it uses does.
        let moves = self.uses(statement, |resolver, entity| resolver.facts.moves(entity));
        match &statement.kind {
            StatementKind::Input { names, kind } => self.input(docs, names, kind.as_ref()),
            StatementKind::Param { name, kind, default } => {
                self.param(docs, name, kind.as_ref(), default);
            }
            StatementKind::Let { name, value } => self.named_expression(name, value, moves),
            StatementKind::Unknown { name, kind, between } => {
                self.unknown(docs, name, kind.as_ref(), between.as_ref());
            }
            StatementKind::Solve(solve) => self.solve(solve),
            StatementKind::Ground { points } => self.ground(docs, points),
            StatementKind::Guide { name, on, through, course } => {
                self.guide_line(name, on.as_ref(), through, course, moves);
            }
            StatementKind::Point { name, on, place } => {
                self.placed_point(docs, name, on.as_ref(), place, moves);
            }
            StatementKind::Group(group) => self.group(docs, group, moves),
            // Outputs may name anything, wherever they stand: they come last. Drawn links were made
            // into groups.
            StatementKind::Output { .. }
            | StatementKind::Pin { .. }
            | StatementKind::Link { .. }
            | StatementKind::Drive(_) => {}
            StatementKind::DriveBy { input, load } => self.drive_by(input, load),
            StatementKind::Load { names, kind } => self.load(docs, names, kind.as_ref()),
            StatementKind::Action(action) => self.action(docs, action),
            StatementKind::Numerics { mode } => self.numerics(mode),
            StatementKind::Crate { path } => self.crate_path(path),
            StatementKind::Export { language } => self.export(language),
        }
    }
}

fn solved(statement: &Statement) -> Option<String> {
    match &statement.kind {
        StatementKind::Solve(solve) => Some(solve.unknown.to_string()),
        _ => None,
    }
}

fn empty(tree: &Declaration) -> Mechanism {
    let empty = Mechanism::empty(tree.docs.clone(), tree.visibility.clone(), tree.name.clone());
    Mechanism { references: References::of(tree), ..empty }
}
