//! Systems at which a decision hangs on one number: a pivot of zero, one that is no number, a reaction of zero, a tie,
//! a square out of range, an earlier failure; and those that random systems are not, which take many steps.

use super::{Call, MOST};

/// A call with the starts that no friction has.
fn call<R: AsRef<[f64]>>(guides: u32, is_single: bool, rows: &[R]) -> Call {
    let count = rows.len();
    let mut start = vec![0.0; count];
    for (j, (row, start)) in rows.iter().zip(&mut start).enumerate() {
        let [share, x, y, ..] = *row.as_ref() else { panic!("a row is too short") };
        let size = if guides >> j & 1 == 1 { x.abs().max(y.abs()) } else { x.hypot(y) };
        *start = share * size;
    }
    assert!(count <= MOST && rows.iter().all(|row| row.as_ref().len() == 3 + 2 * count));
    Call {
        count,
        guides,
        is_single,
        has_failed: false,
        rows: rows.iter().flat_map(AsRef::as_ref).copied().collect(),
        start,
    }
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
    calls.extend(CLOSE.map(|(guides, rows)| call(guides, is_single, rows)));
    calls.extend(CYCLES.map(|rows| call(0b1111, is_single, &rows.each_ref().map(spread))));
    calls.extend((1..=15).flat_map(|places| many_steps(places, is_single)));
    if is_single {
        let numbers = calls.iter_mut().flat_map(|call| call.rows.iter_mut().chain(&mut call.start));
        numbers.for_each(|x| *x = f64::from(*x as f32));
    }
    calls
}

/// Systems that take as many steps as one search makes, or whose steps gain about as much as they have to: the few of
/// four million that tell neighbouring numbers of steps, and the measures of a gain, apart.
const CLOSE: [(u32, &[&[f64]]); 5] = [
    (
        0b111,
        &[
            &[0.548, 1.0, 0.0, 0.125, 0.0, -0.3125, 0.0, 0.875, 0.0],
            &[0.319, -0.25, 0.0, 0.0, 0.0, -0.1875, 0.0, 0.625, 0.0],
            &[1.083, -0.5625, 0.0, 0.875, 0.0, -0.75, 0.0, 0.25, 0.0],
        ],
    ),
    (
        0b111,
        &[
            &[0.697, 0.6875, 0.0, 0.8125, 0.0, -0.625, 0.0, 0.3125, 0.0],
            &[0.595, 0.125, 0.0, 0.125, 0.0, -0.125, 0.0, -0.6875, 0.0],
            &[0.839, -1.0, 0.0, 0.75, 0.0, -0.375, 0.0, 0.1875, 0.0],
        ],
    ),
    (
        0b01,
        &[
            &[0.905487262, -0.0625, 0.875, 0.25, 0.3125, 0.4375, -0.6875],
            &[0.527951408, 0.5625, -0.75, -0.625, 0.625, 0.625, -0.9375],
        ],
    ),
    (
        0b10,
        &[
            &[0.676450031, -0.625, -0.3125, -0.5, -0.9375, 0.6875, 0.5],
            &[0.87591214, 0.625, 0.625, -0.375, 0.25, 0.375, -0.125],
        ],
    ),
    (
        0b10,
        &[
            &[0.231207168, 0.75, 0.625, -1.0, 0.9375, -0.375, 0.6875],
            &[1.15474406, 0.0, 0.0, 0.4375, 0.4375, -0.125, 0.75],
        ],
    ),
];

/// Shares, reactions and changes of guides along one axis, which send Newton's steps round in a circle: three of 300 000
/// systems at random.
const CYCLES: [[[f64; 6]; 4]; 3] = [
    [
        [0.212, -0.9375, -0.125, 0.5625, 0.4375, -0.125],
        [0.737, -0.0625, 1.0, 0.125, 0.1875, -0.75],
        [1.027, -0.9375, 0.5, -0.5625, -0.0625, 0.0625],
        [0.732, -0.125, -0.75, 0.1875, 0.25, -0.8125],
    ],
    [
        [0.411, 0.8125, -0.6875, -0.1875, -0.75, 0.5625],
        [0.63, -0.125, 0.0, -1.0, -0.5, 0.8125],
        [0.605, 0.25, 0.625, 0.0625, 0.375, -0.3125],
        [0.395, 0.0625, 0.125, -0.875, -0.25, 0.375],
    ],
    [
        [0.572, -0.5625, 0.0, -0.5, 0.0625, 0.125],
        [1.206, 0.5, -0.4375, -0.4375, -0.625, 1.0],
        [0.337, 0.875, 0.4375, -0.0625, 0.625, 0.3125],
        [0.244, 0.0, 0.375, -0.375, 0.875, -0.375],
    ],
];

/// A row of numbers along one axis as one of both.
fn spread(&[share, free, changes @ ..]: &[f64; 6]) -> Vec<f64> {
    let pairs = changes.iter().flat_map(|&change| [change, 0.0]);
    [share, free, 0.0].into_iter().chain(pairs).collect()
}

/// Pins beside which the friction that they cause is just below them, by so many decimal places: Newton's steps double
/// an amount until it is as large as the root of that.
fn many_steps(places: i32, is_single: bool) -> [Call; 2] {
    let share = 1.0 - 0.1_f64.powi(places);
    let one: &[&[f64]] = &[&[share, 0.0, 1.0, 1.0, 0.0]];
    let two: &[&[f64]] =
        &[&[share, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0], &[share, 0.5, 1.0, -1.0, 0.0, 0.0, 0.0]];
    [one, two].map(|rows| call(0, is_single, rows))
}
