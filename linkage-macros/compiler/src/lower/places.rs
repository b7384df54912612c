//! The place where a function finds an input, a load, a drive or a parameter among its arguments.

use proc_macro2::Ident;

use crate::interface::Interface;
use crate::interface::entries::ArgumentKind;
use crate::ir::graph::Node;
use crate::model::mechanism::Mechanism;

/// A place from which a value is read.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Place<'m> {
    /// A field of the solver.
    Param(&'m Ident),
    /// An argument, by its index, or a part of it.
    Argument(usize, ArgumentPart<'m>),
}

/// The part of an argument that is read.
#[derive(Clone, Copy, Debug)]
pub(crate) enum ArgumentPart<'m> {
    All,
    Field(&'m Ident),
    Index(u32),
}

/// The index of the argument that a node reads.
pub(crate) fn argument(given: &[ArgumentKind], node: Node) -> Option<usize> {
    let wanted = match node {
        Node::InputCos(_) => ArgumentKind::Cosine,
        Node::InputSin(_) => ArgumentKind::Sine,
        Node::Load(_) => ArgumentKind::Loads,
        Node::Drive(_) => ArgumentKind::Drives,
        Node::Input { order, .. } => {
            [ArgumentKind::Value, ArgumentKind::Rate, ArgumentKind::Acceleration]
                [usize::from(order)]
        }
        _ => return None,
    };
    given.iter().position(|&known| known == wanted)
}

/// The place of a leaf of the graph among these arguments.
pub(crate) fn place<'m>(
    mechanism: &'m Mechanism,
    interface: &Interface,
    given: &[ArgumentKind],
    node: Node,
) -> Option<Place<'m>> {
    if let Node::Param(param) = node {
        return Some(Place::Param(&mechanism.params[param as usize].name));
    }
    let part = match node {
        Node::Input { input, .. } if interface.inputs.is_some() => {
            ArgumentPart::Field(&mechanism.inputs[input as usize].name)
        }
        Node::Load(load) if interface.loads.is_some() => {
            ArgumentPart::Field(&mechanism.dynamics.loads[load as usize].name)
        }
        Node::Drive(input) if interface.inputs.is_some() => ArgumentPart::Index(input),
        _ => ArgumentPart::All,
    };
    Some(Place::Argument(argument(given, node)?, part))
}
