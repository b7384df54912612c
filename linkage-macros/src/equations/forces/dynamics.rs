//! From forces to motion: the equations of motion in the inputs, and their second rates.
//!
//! ```text
//! M q̈ = Q + τ      M_ij = Σ m c_i·c_j + J k_i k_j
//! ```
//!
//! with the drives τ, and Q all that acts along an input at q̈ = 0: of a single one Q − ½M′ q̇² from the state
//! at its unit rate, of several the power of all that acts and of the inertia that is left without second
//! rates. Positions are solved, not integrated, so that there are as many states as inputs and no
//! loop can open.
//!
//! One input takes one division. Several take M = L D Lᵀ without pivoting, unrolled: M is positive
//! definite where every input moves mass, and for such the elimination is stable in any order. A pivot
//! that vanishes is an input that moves no mass there; at a dead point of the inputs the velocities
//! themselves are singular.
//!
//! # Source
//! Eksergian's equation and Lagrange's of the second kind, e.g. Uicker, Pennock, Shigley, Theory of
//! Machines and Mechanisms, ch. 16; Golub and Van Loan, Matrix Computations, ch. 4 (LDLᵀ).

use crate::equations::forces::power::{applied_power, of_one_among_several};
use crate::equations::forces::reduced::Reduced;
use crate::equations::forces::unit_rate::at_unit_rate;
use crate::equations::kinematics::{Kinematics, Source};
use crate::equations::symbol::Sym;
use crate::ir::graph::{Check, Id, Node};

/// M and Q.
struct Equations<'s> {
    mass: Vec<Vec<Sym<'s>>>,
    force: Vec<Sym<'s>>,
}

fn equations_of<'s>(kinematics: &Kinematics<'s>) -> Equations<'s> {
    let count = kinematics.inputs.len();
    let units: Vec<_> = (0..count).map(|input| at_unit_rate(kinematics, input)).collect();
    // What swings with every input: at a unit rate of one, a length that another drives stands still.
    let masses = Reduced::of(kinematics);
    let entry = |row: usize, column: usize| masses.inertia(&units[row], &units[column]);
    // Symmetric: each product once.
    let entry = |row: usize, column: usize| entry(row.max(column), row.min(column));
    let mass =
        (0..count).map(|row| (0..count).map(|column| entry(row, column)).collect()).collect();
    let force = match &units[..] {
        [unit] => {
            let rate = kinematics.inputs[0].jet.rate;
            let acting = applied_power(unit, unit) + masses.power_of_weight(unit);
            vec![acting - masses.slope(unit) * rate.squared()]
        }
        _ => {
            let coasting = without_second_rates(kinematics);
            units.iter().map(|unit| -of_one_among_several(&coasting, unit)).collect()
        }
    };
    Equations { mass, force }
}

fn without_second_rates<'s>(kinematics: &Kinematics<'s>) -> Kinematics<'s> {
    let inputs = Source::without_second_rates(&kinematics.inputs, kinematics.sheet);
    Kinematics::of(kinematics.sheet, kinematics.mechanism, inputs)
}

/// Whether no input is known to move no mass at all.
pub(in crate::equations) fn every_input_moves_mass(kinematics: &Kinematics<'_>) -> bool {
    let unit = |input| at_unit_rate(kinematics, input);
    let moves = |input| {
        let unit = unit(input);
        !Reduced::of(&unit).inertia(&unit, &unit).is_zero()
    };
    !kinematics.mechanism.dynamics.masses.is_empty() && (0..kinematics.inputs.len()).all(moves)
}

/// The mass matrix column by column, then the forces.
pub(in crate::equations) fn equations(kinematics: &Kinematics<'_>) -> Vec<Id> {
    let Equations { mass, force } = equations_of(kinematics);
    mass.concat().into_iter().chain(force).map(|number| number.id).collect()
}

/// The second rates of the inputs.
pub(in crate::equations) fn accelerations(kinematics: &Kinematics<'_>) -> Vec<Id> {
    let Equations { mass, force } = equations_of(kinematics);
    let drive = |input: usize| kinematics.sheet.node(Node::Drive(input as u32));
    let right = force.iter().enumerate().map(|(input, force)| *force + drive(input)).collect();
    let title = |input| kinematics.mechanism.title_of_input(input);
    solved(mass, right, &title).into_iter().map(|number| number.id).collect()
}

/// M x = b by L D Lᵀ; pivots are provided not to vanish, each under its title.
fn solved<'s>(
    mass: Vec<Vec<Sym<'s>>>,
    mut right: Vec<Sym<'s>>,
    title: &dyn Fn(usize) -> u32,
) -> Vec<Sym<'s>> {
    let count = right.len();
    if let [only] = right[..] {
        return vec![only / mass[0][0].provided(Check::Nonzero, title(0), &[])];
    }
    // Below the diagonal L, on it D.
    let mut factors = mass;
    let mut inverses = Vec::new();
    for column in 0..count {
        let pivot = (0..column).fold(factors[column][column], |pivot, k| {
            pivot - factors[column][k].squared() * factors[k][k]
        });
        let pivot = pivot.provided(Check::Nonzero, title(column), &[]);
        factors[column][column] = pivot;
        inverses.push(pivot.recip());
        for row in column + 1..count {
            let entry = (0..column).fold(factors[row][column], |entry, k| {
                entry - factors[row][k] * factors[column][k] * factors[k][k]
            });
            factors[row][column] = entry * inverses[column];
        }
    }
    for row in 0..count {
        for k in 0..row {
            right[row] = right[row] - factors[row][k] * right[k];
        }
    }
    let mut solution: Vec<_> = right.iter().zip(&inverses).map(|(b, d)| *b * *d).collect();
    for row in (0..count).rev() {
        for k in row + 1..count {
            solution[row] = solution[row] - factors[k][row] * solution[k];
        }
    }
    solution
}
