//! Few amounts of friction by Newton's method in straight-line code, and numbers that show them solved.
//!
//! Written in the sizes h of the reactions, x = c h, the equation has no units but those of forces:
//!
//! ```text
//! h_j = ‖G_j + Σ_k b_jk h_k‖        b_jk = c_k A_jk        z = Σ_k b_k h_k
//! ```
//!
//! Two links share their joints' reactions, so that many components shift alike: by z or by −z. Two bars have two
//! shifts for three pins, the components of what their common pin's force changes by. The steps are
//! made in the shifts where these are no more than the sizes: (I − B S) δz = B h − z, where S is the slope of
//! h by z. Both ways make the same steps. They begin at z = 0: a step from there is worth more than the
//! repetition h⁰ ← ‖G‖ takes.
//!
//! # What shows them solved
//! *One solution.* ρ(L) < 1. Contacts that have the same shifts have equal rows of L, and stand for one row with
//! the sum of their columns, of which √n times the root of the sum of squares is a bound. The pivots of I less
//! that matrix have to be positive. So a pose next to jamming may fail, never the reverse.
//!
//! *Solved.* The amounts are c (h + S δz) of the last step. A pin's size at z + δz is larger than that
//! by no more than δ²/2a, δ being the step of its reaction and a = h + S δz: since
//! |R + δ|² = a² + δ⊥², where u is the direction of R, a = |R| + u·δ and δ⊥ the part across u. A guide's size is a itself
//! unless another of its branches is larger. These have to be less than 4ε of the reaction without
//! friction, or where nothing is added but rounding, of it and a: then the amounts are within what the run-time
//! crate's search ends at. Elsewhere that search takes over.
//!
//! # Source
//! The theory is in `friction.rs` of the run-time crate.

use super::amount::Row;
use crate::equations::symbol::Sym;
use crate::ir::graph::Id;

/// Steps between pins, each with the sizes of all reactions: the error of the third is some ρ¹⁵. Where a guide's
/// reaction changes its side, one step goes for nothing.
const STEPS: usize = 3;

/// The most amounts that are solved here: those of a group's own joints.
pub(super) const MOST: usize = 3;

/// The amounts that straight-line code finds, and what shows that they are the solution.
pub(super) struct Straight<'s> {
    pub amounts: Vec<Sym<'s>>,
    /// Above zero if there is exactly one solution.
    pub positive: Vec<Sym<'s>>,
    /// The first is less than 4ε of the second if the steps have ended.
    pub small: Vec<[Sym<'s>; 2]>,
}

/// A component of a reaction: without friction, and the shift that is added or subtracted.
#[derive(Clone, Copy)]
struct Shifted<'s> {
    free: Sym<'s>,
    shift: Option<(usize, bool)>,
}

/// The size of a reaction, and its slope by each shift.
struct Size<'s> {
    size: Sym<'s>,
    slope: Vec<Sym<'s>>,
}

/// The equation in shifts.
struct Shifts<'s> {
    /// By shift and contact: b.
    by_size: Vec<Vec<Sym<'s>>>,
    components: Vec<[Shifted<'s>; 2]>,
    are_guides: Vec<bool>,
}

/// The amounts of up to three contacts.
pub(super) fn straight<'s>(rows: &[Row<'s>]) -> Straight<'s> {
    let shifts = Shifts::of(rows);
    let zero = rows[0].share.builder().zero();
    let (mut at, mut sizes) = (vec![zero; shifts.by_size.len()], vec![zero; rows.len()]);
    let mut step = at.clone();
    let steps = STEPS + usize::from(rows.iter().any(|row| row.is_guide));
    for _ in 0..steps {
        let found = shifts.sizes(&at);
        (step, sizes) = shifts.step(&found, &at, &sizes);
        at = sum(&at, &step);
    }
    let free: Vec<_> =
        shifts.sizes(&vec![zero; at.len()]).into_iter().map(|own| own.size).collect();
    let small = (0..rows.len()).filter_map(|j| shifts.off(j, [free[j], sizes[j]], &at, &step));
    Straight {
        amounts: rows.iter().zip(&sizes).map(|(row, size)| row.share * *size).collect(),
        positive: shifts.pivots(),
        small: small.collect(),
    }
}

fn sum<'s>(a: &[Sym<'s>], b: &[Sym<'s>]) -> Vec<Sym<'s>> {
    a.iter().zip(b).map(|(a, b)| *a + *b).collect()
}

/// The sum of products, from zero on.
fn product<'s>(zero: Sym<'s>, a: &[Sym<'s>], b: &[Sym<'s>]) -> Sym<'s> {
    a.iter().zip(b).fold(zero, |sum, (a, b)| sum + *a * *b)
}

impl<'s> Shifts<'s> {
    fn of(rows: &[Row<'s>]) -> Self {
        let (mut by_size, mut known) = (Vec::new(), Vec::<Vec<Id>>::new());
        let mut component = |row: &Row<'s>, axis: usize| {
            let changes: Vec<_> = row.changes.iter().map(|change| change[axis]).collect();
            let first = changes.iter().find(|change| !change.is_zero());
            let is_subtracted = first.is_some_and(|first| first.is_negated());
            let changes: Vec<_> = changes
                .iter()
                .map(|&change| if is_subtracted { -change } else { change })
                .collect();
            let ids: Vec<_> = changes.iter().map(|change| change.id).collect();
            let shift = first.map(|_| {
                known.iter().position(|known| *known == ids).unwrap_or_else(|| {
                    let shares = rows.iter().map(|row| row.share);
                    by_size.push(changes.iter().zip(shares).map(|(a, c)| *a * c).collect());
                    known.push(ids);
                    known.len() - 1
                })
            });
            Shifted { free: row.free[axis], shift: shift.map(|shift| (shift, is_subtracted)) }
        };
        let components = rows.iter().map(|row| [component(row, 0), component(row, 1)]).collect();
        Self { by_size, components, are_guides: rows.iter().map(|row| row.is_guide).collect() }
    }

    fn at(component: Shifted<'s>, shifts: &[Sym<'s>]) -> Sym<'s> {
        match component.shift {
            None => component.free,
            Some((shift, true)) => component.free - shifts[shift],
            Some((shift, false)) => component.free + shifts[shift],
        }
    }

    /// The sizes of all reactions where they are shifted so far.
    fn sizes(&self, shifts: &[Sym<'s>]) -> Vec<Size<'s>> {
        let size = |(components, &is_guide): (&[Shifted<'s>; 2], &bool)| {
            let at = components.map(|component| Self::at(component, shifts));
            let (size, direction) = if is_guide { larger(at) } else { length(at) };
            let mut slope = vec![size.builder().zero(); shifts.len()];
            for (component, by) in components.iter().zip(direction) {
                if let Some((shift, is_subtracted)) = component.shift {
                    slope[shift] = slope[shift] + if is_subtracted { -by } else { by };
                }
            }
            Size { size, slope }
        };
        self.components.iter().zip(&self.are_guides).map(size).collect()
    }

    /// The step of the shifts, and the sizes as far as slopes tell them after it. `linear` are those of
    /// the step before.
    fn step(
        &self,
        found: &[Size<'s>],
        at: &[Sym<'s>],
        linear: &[Sym<'s>],
    ) -> (Vec<Sym<'s>>, Vec<Sym<'s>>) {
        let (count, shifts) = (found.len(), at.len());
        let [zero, one] = [0, 1].map(|value| found[0].size.builder().integer(value));
        let without = |own: bool, a: &[Sym<'s>], b: &[Sym<'s>]| {
            a.iter().zip(b).fold(if own { one } else { zero }, |rest, (a, b)| rest - *a * *b)
        };
        let sizes: Vec<_> = found.iter().map(|own| own.size).collect();
        if shifts <= count {
            let by = |d: usize, e: usize| {
                let slopes: Vec<_> = found.iter().map(|own| own.slope[e]).collect();
                without(d == e, &self.by_size[d], &slopes)
            };
            let matrix = (0..shifts).map(|d| (0..shifts).map(|e| by(d, e)).collect()).collect();
            let right = (0..shifts).map(|d| {
                let sizes = self.by_size[d].iter().zip(&sizes);
                sizes.fold(-at[d], |sum, (by, size)| sum + *by * *size)
            });
            let right = right.collect();
            let step = solve(matrix, right);
            let after = found.iter().map(|own| own.size + product(zero, &own.slope, &step));
            return (step.clone(), after.collect());
        }
        let column = |k: usize| self.by_size.iter().map(|by| by[k]).collect::<Vec<_>>();
        let by = |j: usize, k: usize| without(j == k, &found[j].slope, &column(k));
        let matrix = (0..count).map(|j| (0..count).map(|k| by(j, k)).collect()).collect();
        let right = sizes.iter().zip(linear).map(|(size, linear)| *size - *linear).collect();
        let changes = solve(matrix, right);
        let step = self.by_size.iter().map(|by| product(zero, by, &changes)).collect();
        (step, sum(linear, &changes))
    }

    /// By how much a size is larger than its slope has told, in terms of its rounding: see the module. `free` is
    /// the size without friction, `linear` what the slope told; shifts are those after the step.
    fn off(
        &self,
        j: usize,
        [free, linear]: [Sym<'s>; 2],
        at: &[Sym<'s>],
        step: &[Sym<'s>],
    ) -> Option<[Sym<'s>; 2]> {
        let own = self.components[j];
        own.iter().find_map(|component| component.shift)?;
        if self.are_guides[j] {
            let (size, _) = larger(own.map(|component| Self::at(component, at)));
            return Some([size - linear, free + linear]);
        }
        let shifts = own.iter().filter_map(|component| component.shift);
        let zero = free.builder().zero();
        Some([shifts.fold(zero, |sum, (shift, _)| sum + step[shift].squared()), free * linear])
    }

    /// Pivots of I less a bound of L, all of them above zero only if ρ(L) < 1.
    fn pivots(&self) -> Vec<Sym<'s>> {
        let of = |j: usize| -> Vec<usize> {
            self.components[j].iter().filter_map(|own| own.shift).map(|(shift, _)| shift).collect()
        };
        let all: Vec<_> = (0..self.components.len()).map(of).collect();
        let mut kinds: Vec<&Vec<usize>> = Vec::new();
        for own in all.iter().filter(|own| !own.is_empty()) {
            if !kinds.contains(&own) {
                kinds.push(own);
            }
        }
        let builder = self.components[0][0].free.builder();
        // n times the sum of squares.
        let squared = |kind: &[usize], other: &[usize]| {
            let columns = (0..all.len()).filter(|&k| all[k] == other);
            let squares = columns.map(|k| {
                kind.iter().fold(builder.zero(), |sum, &d| sum + self.by_size[d][k].squared())
            });
            let squares: Vec<_> = squares.filter(|square| !square.is_zero()).collect();
            let sum = squares.iter().fold(builder.zero(), |sum, square| sum + *square);
            builder.integer(squares.len() as i64) * sum
        };
        if let [kind] = kinds[..] {
            return vec![builder.integer(1) - squared(kind, kind)];
        }
        let entry = |a: usize, b: usize| {
            let size = squared(kinds[a], kinds[b]);
            let size = if size.is_zero() { size } else { size.sqrt() };
            if a == b { builder.integer(1) - size } else { -size }
        };
        let mut matrix: Vec<Vec<_>> =
            (0..kinds.len()).map(|a| (0..kinds.len()).map(|b| entry(a, b)).collect()).collect();
        let mut right = vec![builder.zero(); kinds.len()];
        (0..kinds.len()).for_each(|k| eliminate(&mut matrix, &mut right, k));
        (0..kinds.len()).map(|k| matrix[k][k]).collect()
    }
}

/// Length and direction of a pin's force.
fn length<'s>([x, y]: [Sym<'s>; 2]) -> (Sym<'s>, [Sym<'s>; 2]) {
    let length = (x.squared() + y.squared()).sqrt();
    let inverse = length.recip();
    (length, [x * inverse, y * inverse])
}

/// The larger magnitude of a guide's force and couple, and its slope by each.
fn larger<'s>([x, y]: [Sym<'s>; 2]) -> (Sym<'s>, [Sym<'s>; 2]) {
    let [zero, one] = [0, 1].map(|value| x.builder().integer(value));
    let signs = [x, y].map(|part| part.at_least(zero, one, -one));
    let [size, other] = [x, y].map(Sym::magnitude);
    if y.is_zero() {
        return (size, [signs[0], zero]);
    }
    let slope = [size.at_least(other, signs[0], zero), size.at_least(other, zero, signs[1])];
    (size.at_least(other, size, other), slope)
}

/// The solution of one to three equations. No exchanges: in sizes the matrix is I − Φ′ with |Φ′| ≤ L, and two are
/// solved by determinants.
fn solve<'s>(mut matrix: Vec<Vec<Sym<'s>>>, mut right: Vec<Sym<'s>>) -> Vec<Sym<'s>> {
    if let ([first, second], &[x, y]) = (&matrix[..], &right[..]) {
        let inverse = (first[0] * second[1] - first[1] * second[0]).recip();
        return vec![
            (second[1] * x - first[1] * y) * inverse,
            (first[0] * y - second[0] * x) * inverse,
        ];
    }
    let (count, zero) = (right.len(), right[0].builder().zero());
    (0..count).for_each(|k| eliminate(&mut matrix, &mut right, k));
    for k in (0..count).rev() {
        let known = product(zero, &matrix[k][k + 1..], &right[k + 1..]);
        right[k] = (right[k] - known) / matrix[k][k];
    }
    right
}

/// Clears a column below its pivot.
fn eliminate<'s>(matrix: &mut [Vec<Sym<'s>>], right: &mut [Sym<'s>], k: usize) {
    for j in k + 1..right.len() {
        let factor = matrix[j][k] / matrix[k][k];
        let top = matrix[k].clone();
        for (entry, above) in matrix[j].iter_mut().zip(&top).skip(k + 1) {
            *entry = *entry - factor * *above;
        }
        right[j] = right[j] - factor * right[k];
    }
}
