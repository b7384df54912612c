//! What the values of the graph are called in the generated code: a component of a result after
//! the user's name for it, everything else by its number.

use std::collections::HashMap;

use proc_macro2::Ident;

use super::names::{generated, text};
use super::results::Order;
use crate::ir::graph::Id;
use crate::ir::program::{EntryKind, Program};
use crate::model::mechanism::{Mechanism, Shape};

/// The names of the locals that hold components of results.
#[derive(Default)]
pub(super) struct Locals(HashMap<Id, Ident>);

impl Locals {
    pub(super) fn new(mechanism: &Mechanism, program: &Program) -> Self {
        let mut names = HashMap::new();
        for kind in [EntryKind::Motion, EntryKind::MotionAt] {
            let Some(entry) = program.entries.iter().find(|entry| entry.kind == kind) else {
                continue;
            };
            let labels = Order::ALL.into_iter().flat_map(|order| components(mechanism, order));
            // Upper and lower case may make one name of two.
            let mut taken = HashMap::new();
            for (label, &sink) in labels.zip(&entry.sinks) {
                // Whether a letter of another alphabet may stand in a name is for others to know.
                let is_its_own = *taken.entry(label.clone()).or_insert(sink) == sink;
                if is_its_own && label.is_ascii() {
                    names.entry(sink).or_insert_with(|| generated(&label));
                }
            }
        }
        Self(names)
    }

    /// Whether the value is a component of a result.
    pub(super) fn is_named(&self, id: Id) -> bool {
        self.0.contains_key(&id)
    }

    /// The local that holds a node's value.
    pub(super) fn name(&self, id: Id) -> Ident {
        self.0.get(&id).cloned().unwrap_or_else(|| numbered(id))
    }
}

/// A local that nobody has a name for.
pub(super) fn numbered(id: Id) -> Ident {
    generated(&format!("v{}_", id.0))
}

/// What the components of all outputs are called at one order, in the order of the sinks.
fn components(mechanism: &Mechanism, order: Order) -> Vec<String> {
    let of = |output: &crate::model::mechanism::Output| {
        let field = text(&output.field).to_lowercase();
        let endings = endings(output.kind.shape(), order);
        endings.iter().map(move |ending| single_underscores(&format!("{field}_{ending}_")))
    };
    mechanism.outputs.iter().flat_map(of).collect()
}

fn endings(shape: Shape, order: Order) -> &'static [&'static str] {
    match (shape, order) {
        (Shape::Point, Order::Position) => &["x", "y"],
        (Shape::Point, Order::Velocity) => &["vx", "vy"],
        (Shape::Point, Order::Acceleration) => &["ax", "ay"],
        (Shape::Direction, Order::Position) => &["cos", "sin"],
        (Shape::Direction, Order::Velocity) => &["omega"],
        (Shape::Direction, Order::Acceleration) => &["alpha"],
        (Shape::SlidingDirection, Order::Position) => &["cos", "sin", "slide"],
        (Shape::SlidingDirection, Order::Velocity) => &["omega", "slide_rate"],
        (Shape::SlidingDirection, Order::Acceleration) => &["alpha", "slide_acceleration"],
        (Shape::Slide, Order::Position) => &["slide"],
        (Shape::Slide, Order::Velocity) => &["slide_rate"],
        (Shape::Slide, Order::Acceleration) => &["slide_acceleration"],
        (Shape::Value, Order::Position) => &["value"],
        (Shape::Value, Order::Velocity) => &["rate"],
        (Shape::Value, Order::Acceleration) => &["acceleration"],
    }
}

/// The name without the double underscores that the compiler frowns upon.
fn single_underscores(name: &str) -> String {
    let parts: Vec<&str> = name.split('_').filter(|part| !part.is_empty()).collect();
    format!("{}_", parts.join("_"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_local_has_one_underscore_between_its_words_and_one_behind() {
        assert_eq!(single_underscores("a__b__x_"), "a_b_x_");
        assert_eq!(single_underscores("_b_x_"), "b_x_");
    }
}
