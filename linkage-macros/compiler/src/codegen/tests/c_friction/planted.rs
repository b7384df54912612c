//! Systems at which a decision hangs on one number: a pivot of zero, one that is no number, a reaction of zero, a tie,
//! a square out of range, an earlier failure.

use super::{Call, JOINTS, MOST};

/// So many equal numbers, with the starts that no friction has.
fn call(guides: u32, is_single: bool, rows: &[&[f64]]) -> Call {
    let count = rows.len();
    let mut start = vec![0.0; count];
    for (j, (row, start)) in rows.iter().zip(&mut start).enumerate() {
        let &[share, x, y, ..] = *row else { panic!("a row is too short") };
        let size = if guides >> j & 1 == 1 { x.abs().max(y.abs()) } else { x.hypot(y) };
        *start = share * size;
    }
    assert!(count <= MOST && rows.iter().all(|row| row.len() == 3 + 2 * count), "{JOINTS:?}");
    Call { count, guides, is_single, has_failed: false, rows: rows.concat(), start }
}

/// Calls in one width.
pub(super) fn calls(is_single: bool) -> Vec<Call> {
    // Squares of the first leave the numbers' range, those of the second what a root can be taken of.
    let [large, small] = if is_single { [1e25, 1e-25] } else { [1e200, 1e-200] };
    let pin: &[&[f64]] = &[&[0.3, 3.0, 4.0, 0.5, 0.2]];
    let mut calls: Vec<Call> = [
        // The first pivot is zero, or the second.
        (0, &[&[1.0, 3.0, 4.0, 1.0, 0.0][..]][..]),
        (1, &[&[1.0, 3.0, 4.0, 1.0, 0.0]]),
        (0, &[&[1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0], &[1.0, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0]]),
        // The second is the product of zero and infinity in double precision.
        (0, &[&[1.0, 1.0, 0.0, 0.0, 0.0, large, 0.0], &[1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0]]),
        (0, &[&[1.0, large, 0.0, 0.0, 0.0, 1.0, 0.0], &[1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0]]),
        // Pins without a load, one of them between loaded ones.
        (0, &[&[0.3, 0.0, 0.0, 0.5, 0.2]]),
        (0, &[&[0.3, 0.0, 0.0, 0.5, 0.2, 0.0, 0.0], &[0.3, 3.0, 4.0, 0.0, 0.0, 0.5, 0.2]]),
        (2, &[&[0.3, 0.0, 0.0, 0.5, 0.2, 0.1, 0.4], &[0.3, 3.0, 4.0, 0.1, 0.2, 0.5, 0.2]]),
        // Guides whose reaction is zero where steps begin, and whose ends are loaded alike there.
        (3, &[&[0.5, -2.0, 0.0, 1.0, 0.0, 1.0, 0.0], &[0.5, 2.0, 0.0, 0.4, 0.0, 0.1, 0.0]]),
        (1, &[&[0.25, 2.0, 4.0, 1.0, -1.0]]),
        (0, &[&[0.3, 3.0 * small, 4.0 * small, 0.5, 0.2]]),
        (0, &[&[0.3, 3.0 * large, 4.0 * large, 0.5, 0.2]]),
        (0, pin),
    ]
    .into_iter()
    .map(|(guides, rows)| call(guides, is_single, rows))
    .collect();
    calls.push(Call { has_failed: true, ..call(0, is_single, pin) });
    if is_single {
        let numbers = calls.iter_mut().flat_map(|call| call.rows.iter_mut().chain(&mut call.start));
        numbers.for_each(|x| *x = f64::from(*x as f32));
    }
    calls
}
