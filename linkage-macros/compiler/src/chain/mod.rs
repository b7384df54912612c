//! A mechanism as it is drawn, cut into drivers and Assur groups.
//!
//! [`cut`] takes bodies, the joints between them and what is driven, with one pose in which all of
//! it is drawn, and returns the groups in solving order. [`count`] finds them by counting freedoms:
//! every constraint is held by a body or a pin that it leaves one freedom less, and bodies that
//! hold each other's constraints in a circle are one group. [`groups`] makes drivers and dyads of
//! them, [`pose`] says how far each is from its limit.
//!
//! Only numbers in `f64` and indices stand here: no names, no tokens, no exact constants and no
//! messages. A result decides which groups there are and on which side they assemble, and no
//! dimension of them.

pub(crate) mod count;
pub(crate) mod groups;
pub(crate) mod machine;
pub(crate) mod plane;
pub(crate) mod pose;

#[cfg(test)]
mod tests;

use groups::Step;
use machine::Machine;

/// What keeps a machine from being cut. Bodies and drives by their indices.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Trouble {
    /// The bodies have more constraints than freedoms, whatever the drawing is.
    TooMany {
        bodies: Vec<usize>,
        /// The drives among these constraints.
        drives: Vec<usize>,
        /// The freedoms that the bodies have against each other without these drives.
        freedoms: usize,
    },
    /// The bodies still move when every drive is held.
    Loose { bodies: Vec<usize>, freedoms: usize },
    /// The bodies are one group, which is no driver and no dyad.
    Undecided { bodies: Vec<usize> },
}

/// The groups of a machine in solving order, or all that keeps it from being cut.
pub(crate) fn cut(machine: &Machine) -> Result<Vec<Step>, Vec<Trouble>> {
    let troubles = count::troubles(machine);
    if !troubles.is_empty() {
        return Err(troubles);
    }
    let mut steps = Vec::new();
    let mut known = groups::Known::at_first(machine);
    for group in count::groups(machine) {
        let found = groups::steps(machine, &known, &group);
        let Some(found) = found else {
            return Err(vec![Trouble::Undecided { bodies: group }]);
        };
        steps.extend(found);
        known.add(machine, &group);
    }
    Ok(steps)
}
