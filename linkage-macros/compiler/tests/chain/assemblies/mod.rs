//! Lists of assemblies against other ways to count them.

pub(crate) mod nearest;
pub(crate) mod numbers;
pub(crate) mod special;
pub(crate) mod trusses;
pub(crate) mod two_cuts;

use super::*;
use crate::chain::assembly_list::{Assemblies, ListedAssembly, Outcome};
use crate::chain::cutting::{Pair, Placed};
use crate::chain::machine::RigidBody;
use crate::chain::options::options;
use crate::chain::plane::Complex;
use linkage_assemblies::{ClosureDegree, PinnedGroup};
pub(crate) use linkage_compiler::chain::assemblies::*;

/// Numbers from zero to one by a linear congruence.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// A machine of one group: body 0 stands still.
fn machine(bodies: &[Vec<usize>], places: &[[f64; 2]]) -> Machine {
    Machine {
        pins: places.iter().map(|&[x, y]| Complex::new(x, y)).collect(),
        bodies: bodies
            .iter()
            .map(|pins| RigidBody { pins: pins.clone(), ..RigidBody::default() })
            .collect(),
        ..Machine::default()
    }
}

/// A plate on three bars: the pins of the ground, then those of the plate.
fn triad(places: [[f64; 2]; 6]) -> Machine {
    let bodies: [&[usize]; 5] = [&[0, 1, 2], &[3, 4, 5], &[0, 3], &[1, 4], &[2, 5]];
    machine(&bodies.map(<[usize]>::to_vec), &places)
}

/// All ways to solve the group by one unknown.
fn cuts(machine: &Machine) -> Vec<SearchedGroup> {
    let group: Vec<_> = (1..machine.bodies.len()).collect();
    options(machine, &Placed::at_first(machine), &group)
}

/// The list of a kind of group, and the pieces that were looked at.
fn list_and_pieces(
    machine: &Machine,
    search: &SearchedGroup,
    kind: (&PinnedGroup, &ClosureDegree),
) -> (Assemblies, u32) {
    let list = listed(machine, search, kind).expect("it has pins alone");
    assert!(list.samples <= BUDGET.samples && list.pieces <= BUDGET.pieces);
    (as_drawn(machine, kind, &list), list.pieces)
}

/// The same of a triad: the kind of group is one for all lengths.
fn counted_triad(machine: &Machine, search: &SearchedGroup) -> (Assemblies, u32) {
    let group = pinned::pinned(machine, search).expect("it has pins alone");
    list_and_pieces(machine, search, (&group, &ClosureDegree { powers: [1, 0, 0, 0], half: 3 }))
}

fn of_triad(machine: &Machine, search: &SearchedGroup) -> Assemblies {
    counted_triad(machine, search).0
}

/// The counts of assemblies by every cut.
fn counts(machine: &Machine) -> Vec<(usize, Outcome)> {
    let count = |list: Assemblies| (list.list.len(), list.outcome);
    cuts(machine).iter().map(|search| count(of_triad(machine, search))).collect()
}
