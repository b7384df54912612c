//! Names of the graph's values in the generated code: a component of a result after the user's name for it,
//! a value of a derivation after its group and its letter there, everything else by its number.

use std::collections::HashSet;

use syn::ext::IdentExt;

use super::routine::{Instruction, Locals};
use super::schedule::defines;
use crate::interface::entries::{Analysis, EntryPoint};
use crate::interface::quantity::{Order, Quantity};
use crate::ir::graph::Graph;
use crate::ir::hash::Map;
use crate::ir::program::Program;
use crate::model::mechanism::{DeclaredOutput, Mechanism};

/// The names of the locals that hold components of results.
pub(super) fn named(mechanism: &Mechanism, program: &Program) -> Locals {
    let mut names = Map::default();
    let is_motion = |point: EntryPoint| point.analysis == Analysis::Motion;
    let motions = program.answers.iter().filter(|answer| answer.entry.is_some_and(is_motion));
    for answer in motions {
        let labels = Order::ALL.into_iter().flat_map(|order| components(mechanism, order));
        // Upper and lower case may make one name of two.
        let mut taken = Map::default();
        for (label, &sink) in labels.zip(&answer.sinks) {
            // Only ASCII labels become names: this pass has no rule for letters of other alphabets.
            let is_its_own = *taken.or_insert(label.clone(), sink) == sink;
            if is_its_own && label.is_ascii() {
                names.or_insert(sink, label);
            }
        }
    }
    let components = names.keys().copied().collect();
    Locals { names, components, ..Locals::default() }
}

/// The same with the letters of the derivations. Two values of one routine may have one letter, as
/// the velocities at unit rates of two inputs have: the later one gets a number.
pub(super) fn with_letters<'s>(
    components: &Locals,
    graph: &Graph,
    statements: impl IntoIterator<Item = &'s Instruction>,
) -> Locals {
    let mut locals = components.clone();
    let mut taken: HashSet<String> = components.names.values().cloned().collect();
    for id in statements.into_iter().flat_map(defines) {
        let Some(letter) = graph.name_of(id).filter(|name| name.text.is_ascii()) else { continue };
        if locals.names.get(&id).is_some() {
            continue;
        }
        if letter.is_in_passing {
            locals.in_passing.insert(id);
        }
        let stem = stem(&letter.text);
        let numbered = (2..).map(|number| format!("{stem}{number}_"));
        let mut names = std::iter::once(stem.clone()).chain(numbered);
        let free = names.find(|name| taken.insert(name.clone()));
        locals.names.extend(free.map(|name| (id, name)));
    }
    locals
}

/// Names of the components of all outputs at one order, in the order of the sinks.
fn components(mechanism: &Mechanism, order: Order) -> Vec<String> {
    let of = |output: &DeclaredOutput| {
        let field = output.field.unraw().to_string().to_lowercase();
        let parts = Quantity::of(&output.kind).layout(order).parts;
        parts.iter().map(move |part| single_underscores(&format!("{field}_{}_", part.local)))
    };
    mechanism.outputs.iter().flat_map(of).collect()
}

/// A letter of a derivation, which is ASCII, as the name of a local.
fn stem(letter: &str) -> String {
    let mut stem = letter.to_ascii_lowercase().into_bytes();
    for byte in &mut stem {
        if matches!(byte, b' ' | b',') {
            *byte = b'_';
        }
    }
    single_underscores(&String::from_utf8(stem).expect("what is ASCII stays so"))
}

/// The name without the double underscores that the compiler frowns upon.
pub fn single_underscores(name: &str) -> String {
    let mut single = String::with_capacity(name.len() + 1);
    for character in name.chars() {
        if character != '_' || !(single.is_empty() || single.ends_with('_')) {
            single.push(character);
        }
    }
    if !single.ends_with('_') {
        single.push('_');
    }
    single
}
