//! Lists of assemblies against other ways to count them.

mod numbers;
mod special;
mod trusses;
mod two_cuts;

use super::circle::PIECES;
use super::*;
use crate::chain::cutting::Placed;
use crate::chain::machine::RigidBody;
use crate::chain::options::options;

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

/// The power of a triad's base: the kind of group is the same for all lengths.
fn of_triad(machine: &Machine, search: &SearchedGroup) -> Assemblies {
    let group = PinnedGroup::of(machine, search).expect("it has pins alone");
    let degree = ClosureDegree { powers: vec![1], half: 3 };
    of_degree(machine, search, (&group, &degree)).expect("it has pins alone")
}

/// The counts of assemblies by every cut.
fn counts(machine: &Machine) -> Vec<(usize, Outcome)> {
    let count = |list: Assemblies| (list.list.len(), list.outcome);
    cuts(machine).iter().map(|search| count(of_triad(machine, search))).collect()
}
