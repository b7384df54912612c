//! The amounts of friction that depend on each other, by Newton's method on any kind of number.

use crate::exact::Exact;
use crate::ir::implicit::Contacts;
use crate::ir::interpret::Searched;

/// Enough for a hundred digits where friction is moderate: each step squares what is left, and ρ² is left of
/// the first value.
const STEPS: usize = 12;

/// All amounts of x = c ‖G + A x‖, given the rows c, G, A of all and their first values; or the contact at which
/// friction may hold itself.
pub(super) fn all<N: Searched>(contacts: &Contacts, operands: &[&N]) -> Result<Vec<N>, usize> {
    let count = contacts.joints.len();
    let (rows, starts) = operands.split_at(operands.len() - count);
    let rows: Vec<&[&N]> = rows.chunks(rows.len() / count).collect();
    if let Some(jams) = jams(contacts, &rows) {
        return Err(jams);
    }
    let mut amounts: Vec<N> = starts.iter().map(|start| start.point()).collect();
    let one = N::exact(&Exact::integer(1));
    for _ in 0..STEPS {
        let (mut matrix, mut right) = (Vec::new(), Vec::new());
        for (j, row) in rows.iter().enumerate() {
            let reaction = [1, 2].map(|axis| {
                let changes = row[2 + axis..].iter().step_by(2).zip(&amounts);
                changes.fold(row[axis].clone(), |sum, (by, amount)| sum.add(&by.mul(amount)))
            });
            let (size, direction) = sized(&reaction, contacts.joints[j].1);
            let slope = |k: usize| {
                let parts = [0, 1].map(|axis| row[3 + 2 * k + axis].mul(&direction[axis]));
                row[0].mul(&parts[0].add(&parts[1]))
            };
            let entry = |k: usize| if j == k { one.sub(&slope(k)) } else { slope(k).neg() };
            matrix.push((0..count).map(entry).collect());
            right.push(row[0].mul(&size).sub(&amounts[j]));
        }
        let steps = eliminated(matrix, right);
        amounts = amounts.iter().zip(steps).map(|(x, step)| x.add(&step).point()).collect();
    }
    Ok(amounts)
}

/// The first contact whose pivot of I − L is not positive, L being c ‖A‖.
fn jams<N: Searched>(contacts: &Contacts, rows: &[&[&N]]) -> Option<usize> {
    let [zero, one] = [0, 1].map(|value| N::exact(&Exact::integer(value)));
    let count = rows.len();
    let entry = |j: usize, k: usize| {
        let change = [3, 4].map(|axis| rows[j][2 * k + axis].clone());
        let (size, _) = sized(&change, contacts.joints[j].1);
        let bound = rows[j][0].mul(&size);
        if j == k { one.sub(&bound) } else { bound.neg() }
    };
    let mut matrix: Vec<Vec<N>> =
        (0..count).map(|j| (0..count).map(|k| entry(j, k)).collect()).collect();
    let mut right = vec![zero.clone(); count];
    (0..count).find(|&k| {
        let is_positive = !zero.is_at_least(&matrix[k][k]);
        if is_positive {
            eliminate(&mut matrix, &mut right, k);
        }
        !is_positive
    })
}

/// The size of a reaction, and its slope by each component.
fn sized<N: Searched>([x, y]: &[N; 2], is_guide: bool) -> (N, [N; 2]) {
    let [zero, one] = [0, 1].map(|value| N::exact(&Exact::integer(value)));
    if !is_guide {
        let size = x.hypot(y);
        let is_none = zero.is_at_least(&size);
        let part = |part: &N| if is_none { zero.clone() } else { part.div(&size) };
        return (size.clone(), [part(x), part(y)]);
    }
    let signed = |value: &N| match value.is_at_least(&zero) {
        true => (value.clone(), one.clone()),
        false => (value.neg(), one.neg()),
    };
    let [(x, by_x), (y, by_y)] = [signed(x), signed(y)];
    match x.is_at_least(&y) {
        true => (x, [by_x, zero]),
        false => (y, [zero, by_y]),
    }
}

/// The solution of a system whose elimination needs no exchanges.
fn eliminated<N: Searched>(mut matrix: Vec<Vec<N>>, mut right: Vec<N>) -> Vec<N> {
    let count = right.len();
    (0..count).for_each(|k| eliminate(&mut matrix, &mut right, k));
    for k in (0..count).rev() {
        for i in k + 1..count {
            right[k] = right[k].sub(&matrix[k][i].mul(&right[i]));
        }
        right[k] = right[k].div(&matrix[k][k]);
    }
    right
}

/// Clears a column below its pivot.
fn eliminate<N: Searched>(matrix: &mut [Vec<N>], right: &mut [N], k: usize) {
    for j in k + 1..right.len() {
        let factor = matrix[j][k].div(&matrix[k][k]);
        let top = matrix[k].clone();
        for (entry, above) in matrix[j].iter_mut().zip(&top) {
            *entry = entry.sub(&factor.mul(above));
        }
        right[j] = right[j].sub(&factor.mul(&right[k]));
    }
}
