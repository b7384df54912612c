//! From forces to motion: the equations of motion in the inputs, and their accelerations.
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
//! definite where every input moves mass of its own, and for such the elimination is stable in any
//! order. A pivot that vanishes belongs to an input that moves no mass there, or none that earlier
//! inputs do not move alike; at a dead point of the inputs the velocities themselves are singular.
//!
//! # The rounding of a pivot
//! A pivot D_j = M_jj − Σ L_ji² D_i is a difference, and so is M_jj where a mass is counted about a
//! moving origin: 2 k (c_O·S⊥) may take back all that m c_O·c_O + J_O k² bring. Let S_jj be the sum of
//! such squares alone, and u = ε/2.
//!
//! - A sine is right within 2 u, a length and their product within 1 u each: a velocity within 4 u.
//! - A term m c·c, J k² or 2 k (c·S⊥) takes two velocities, two products, a sum and a rounded mass: 12 u.
//!   The last kind has two parts, of at most √2 S_jj together, as (Σm r)² ≤ Σm Σm r². All terms of M_jj
//!   are within 3 S_jj, and have an error of 36 u S_jj.
//! - A sum of t terms adds 3 t u S_jj; the n − 1 products and differences of a pivot 4 n u M_jj.
//! - An entry M_ij has the same share of √(S_ii S_jj) for an error, by Schwarz's inequality.
//!
//! Row j of L⁻¹ is w_j = e_j − Σ L_ji w_i, and D_j = w_j M w_jᵀ. An error E of M therefore moves D_j by
//! w_j E w_jᵀ, which is at most (√S_jj + Σ |L_ji| √T_i)² times that share. With (Σ x)² ≤ n Σ x² this is
//!
//! ```text
//! T_j = (j + 1) (S_jj + Σ L_ji² T_i)      |δD_j| ≤ (36 + 3 t + 4 n) u T_j
//! ```
//!
//! and 32 u = 16 ε are the run-time crate's roundings of a spread. S, M and T of an input scale
//! alike, so that neither units nor small masses matter. A velocity that is itself a small difference,
//! next to a dead point of a group, has more error than 4 u of its size; that is not counted.
//!
//! # Source
//! Eksergian's equation and Lagrange's of the second kind, e.g. Uicker, Pennock, Shigley, Theory of
//! Machines and Mechanisms, ch. 16; Golub and Van Loan, Matrix Computations, ch. 4 (LDLᵀ).

use crate::equations::forces::power::{applied_power, of_one_among_several};
use crate::equations::forces::reduced::Reduced;
use crate::equations::forces::unit_rate::at_unit_rate;
use crate::equations::kinematics::{InputMotion, Kinematics};
use crate::equations::symbol::Sym;
use crate::ir::graph::{Check, Id, Node};

/// The rounding of the pivots of several inputs.
struct Rounding<'s> {
    /// S_jj
    sizes: Vec<Sym<'s>>,
    /// An error of T_j as a multiple of 16 ε of it.
    share: i64,
}

/// M and Q.
pub(super) struct Equations<'s> {
    mass: Vec<Vec<Sym<'s>>>,
    pub force: Vec<Sym<'s>>,
    rounding: Rounding<'s>,
}

impl<'s> Equations<'s> {
    pub(super) fn of(kinematics: &Kinematics<'s>) -> Self {
        equations_of(kinematics)
    }

    /// M⁻¹ of the right-hand side.
    pub(super) fn solve(&self, kinematics: &Kinematics<'s>, right: Vec<Sym<'s>>) -> Vec<Sym<'s>> {
        let title = |input| kinematics.mechanism.title_of_input(input);
        solved(self.mass.clone(), right, &self.rounding, &title)
    }
}

fn equations_of<'s>(kinematics: &Kinematics<'s>) -> Equations<'s> {
    let count = kinematics.inputs.len();
    let units: Vec<_> = (0..count).map(|input| at_unit_rate(kinematics, input)).collect();
    // The actual motion tells which masses swing: at a unit rate of one input, a length that another drives
    // stands still.
    let masses = Reduced::of(kinematics);
    if let [unit] = &units[..] {
        let rate = kinematics.inputs[0].jet.rate;
        let mass = vec![vec![masses.inertia(unit, unit)]];
        let acting = applied_power(unit, unit) + masses.power_of_weight(unit);
        let force = vec![acting - masses.slope(unit) * rate.squared()];
        return Equations { mass, force, rounding: Rounding { sizes: Vec::new(), share: 1 } };
    }
    let (diagonal, sizes): (Vec<_>, Vec<_>) =
        units.iter().map(|unit| masses.mass_and_size(unit)).map(|[m, s]| (m, s)).unzip();
    // Symmetric: each product once.
    let entry = |row: usize, column: usize| match row == column {
        true => diagonal[row],
        false => masses.inertia(&units[row.max(column)], &units[row.min(column)]),
    };
    let mass =
        (0..count).map(|row| (0..count).map(|column| entry(row, column)).collect()).collect();
    let coasting = without_second_rates(kinematics);
    let force = units.iter().map(|unit| -of_one_among_several(&coasting, unit)).collect();
    let rounding = Rounding { sizes, share: share_of_a_pivot(masses.terms(), count) };
    Equations { mass, force, rounding }
}

/// The error of T_j in units of 16 ε of it, given the terms of a mass and the inputs.
pub fn share_of_a_pivot(terms: usize, inputs: usize) -> i64 {
    (36 + 3 * terms + 4 * inputs).div_ceil(32) as i64
}

fn without_second_rates<'s>(kinematics: &Kinematics<'s>) -> Kinematics<'s> {
    let inputs = InputMotion::without_second_rates(&kinematics.inputs, kinematics.builder);
    Kinematics::of(kinematics.builder, kinematics.mechanism, inputs)
}

/// True if there are masses and no input is known to move none of them.
pub fn every_input_moves_mass(kinematics: &Kinematics<'_>) -> bool {
    let unit = |input| at_unit_rate(kinematics, input);
    let moves = |input| {
        let unit = unit(input);
        !Reduced::of(&unit).inertia(&unit, &unit).is_zero()
    };
    !kinematics.mechanism.dynamics.masses.is_empty() && (0..kinematics.inputs.len()).all(moves)
}

/// The mass matrix column by column, then the forces.
pub fn equations(kinematics: &Kinematics<'_>) -> Vec<Id> {
    let Equations { mass, force, .. } = equations_of(kinematics);
    mass.concat().into_iter().chain(force).map(|number| number.id).collect()
}

/// The accelerations of the inputs.
pub(in crate::equations) fn accelerations(kinematics: &Kinematics<'_>) -> Vec<Id> {
    let equations = equations_of(kinematics);
    let right = equations.force.iter().enumerate();
    let right = right.map(|(input, force)| *force + drive_at(kinematics, input)).collect();
    equations.solve(kinematics, right).into_iter().map(|number| number.id).collect()
}

/// The effort of a drive at an input that a call is given. A load that drives is among what acts.
pub(super) fn drive_at<'s>(kinematics: &Kinematics<'s>, input: usize) -> Sym<'s> {
    match kinematics.mechanism.dynamics.driven() {
        Some((driven, _)) if driven.index() == input => kinematics.builder.zero(),
        _ => kinematics.builder.node(Node::Drive(input as u32)),
    }
}

/// M x = b by L D Lᵀ; pivots are provided to be above their rounding, each under its title.
fn solved<'s>(
    mass: Vec<Vec<Sym<'s>>>,
    mut right: Vec<Sym<'s>>,
    rounding: &Rounding<'s>,
    title: &dyn Fn(usize) -> u32,
) -> Vec<Sym<'s>> {
    let count = right.len();
    if let [only] = right[..] {
        return vec![only / mass[0][0].guarded_by(Check::Nonzero, title(0), &[])];
    }
    // Below the diagonal L, on it D.
    let mut factors = mass;
    // T_j
    let (mut inverses, mut sizes) = (Vec::new(), Vec::new());
    for column in 0..count {
        let pivot = (0..column).fold(factors[column][column], |pivot, k| {
            pivot - factors[column][k].squared() * factors[k][k]
        });
        let size = (0..column)
            .fold(rounding.sizes[column], |size, k| size + factors[column][k].squared() * sizes[k]);
        let whole = |value| pivot.builder().integer(value);
        let size = whole(column as i64 + 1) * size;
        sizes.push(size);
        let spread = whole(rounding.share) * size;
        // A sum of squares is no difference.
        let pivot = match pivot.id == rounding.sizes[column].id {
            true => pivot.guarded_by(Check::Nonzero, title(column), &[]),
            false => pivot.guarded_by(Check::Moving, title(column), &[spread]),
        };
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
