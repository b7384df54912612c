//! The place where a function finds an input, a load, a drive or a parameter among its arguments.

use proc_macro2::Ident;

use crate::interface::Interface;
use crate::interface::entries::Given;
use crate::ir::graph::Node;
use crate::model::mechanism::Mechanism;

/// A place from which a value is read.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Place<'m> {
    /// A field of the solver.
    Param(&'m Ident),
    /// An argument, by its index, or a part of it.
    Argument(usize, Part<'m>),
}

/// The part of an argument that is read.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Part<'m> {
    All,
    Field(&'m Ident),
    Index(u32),
}

/// The index of the argument that a node reads.
pub(crate) fn argument(given: &[Given], node: Node) -> Option<usize> {
    let wanted = match node {
        Node::InputCos(_) => Given::Cosine,
        Node::InputSin(_) => Given::Sine,
        Node::Load(_) => Given::Loads,
        Node::Drive(_) => Given::Drives,
        Node::Input { order, .. } => {
            [Given::Value, Given::Rate, Given::Acceleration][usize::from(order)]
        }
        _ => return None,
    };
    given.iter().position(|&known| known == wanted)
}

/// The place of a leaf of the graph among these arguments.
pub(crate) fn place<'m>(
    mechanism: &'m Mechanism,
    interface: &Interface,
    given: &[Given],
    node: Node,
) -> Option<Place<'m>> {
    if let Node::Param(param) = node {
        return Some(Place::Param(&mechanism.params[param as usize].name));
    }
    let part = match node {
        Node::Input { input, .. } if interface.inputs.is_some() => {
            Part::Field(&mechanism.inputs[input as usize].name)
        }
        Node::Load(load) if interface.loads.is_some() => {
            Part::Field(&mechanism.dynamics.loads[load as usize].name)
        }
        Node::Drive(input) if interface.inputs.is_some() => Part::Index(input),
        _ => Part::All,
    };
    Some(Place::Argument(argument(given, node)?, part))
}
