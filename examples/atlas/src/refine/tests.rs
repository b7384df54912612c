//! Derivatives against differences, and refinement against designs that are known.

use linkage_core::Side;

use super::{
    Alignment, DIMENSIONS, LIMITS, POSES, RANGE, RESIDUALS, Remainder, VARIED, four_bar, free,
    of_curve, refined,
};
use crate::four_bar::{Dimensions, FourBar, Tracer};
use crate::grid::Grid;
use crate::search;
use crate::shape::{Complex, Describer, Descriptor, HARMONICS};

/// A curve of no symmetry, between the nodes of the grid.
const KNOWN: Dimensions = Dimensions {
    coupler: 3.037,
    follower: 3.462,
    base: 2.059,
    along: 2.213,
    across: 1.127,
    branch: Side::Left,
};

fn described(dimensions: &Dimensions, poses: u32) -> Descriptor {
    let mut tracer = Tracer::new(poses);
    assert_eq!(tracer.trace(dimensions), Ok(true), "{dimensions:?}");
    Describer::default().describe(&tracer.x, &tracer.y).expect("it has a size")
}

fn of(four_bar: FourBar) -> Dimensions {
    let FourBar { coupler, follower, base, p_x: along, p_y: across, branch } = four_bar;
    Dimensions { coupler, follower, base, along, across, branch }
}

#[test]
fn free_numbers_are_those_of_the_four_bar_and_every_one_can_be_assembled() {
    let again = of(four_bar(free(&KNOWN).expect("it is within the limits")));
    let numbers = |d: Dimensions| [d.coupler, d.follower, d.base, d.along, d.across];
    for (found, wanted) in numbers(again).into_iter().zip(numbers(KNOWN)) {
        // A handful of roundings of numbers up to twice 16.
        assert!((found - wanted).abs() < 1e-13, "{found} {wanted}");
    }
    // At the corners of the limits too, half of the free numbers' turn.
    for corner in 0..1_u32 << DIMENSIONS {
        let free: [f64; DIMENSIONS] = core::array::from_fn(|i| {
            let sign = if corner >> i & 1 == 1 { 1.0 } else { -1.0 };
            sign * std::f64::consts::FRAC_PI_2
        });
        let dimensions = of(four_bar(free));
        let mut tracer = Tracer::new(720);
        assert_eq!(tracer.trace(&dimensions), Ok(true), "{dimensions:?}");
    }
    // A drag link is beyond them.
    assert_eq!(free(&Dimensions { coupler: 2.0, follower: 2.0, base: 0.5, ..KNOWN }), None);
}

#[test]
fn every_candidate_of_the_grid_is_within_the_limits() {
    let grid = Grid { lengths: 14, columns: 3, rows: 3 };
    let candidates = grid.candidates();
    assert!(candidates.count() > 5000);
    for candidate in 0..candidates.count() {
        let dimensions = candidates.dimensions(candidate).expect("it is one");
        assert!(free(&dimensions).is_some(), "{dimensions:?}");
    }
    assert!(LIMITS.iter().all(|[least, most]| least < most));
}

#[test]
fn coefficients_are_the_describers() {
    let curve = described(&KNOWN, POSES);
    let found = of_curve(free(&KNOWN).expect("it is within the limits")).expect("it is assembled");
    let sides = curve.sides().concat();
    assert_eq!(sides.len() * 2, RESIDUALS);
    for (nth, wanted) in sides.iter().enumerate() {
        let found = Complex { re: found[2 * nth], im: found[2 * nth + 1] };
        // Sums of 320 roundings each.
        assert!((found - *wanted).square().sqrt() < 1e-13, "{nth}");
    }
}

/// Every way to lay one curve onto another.
fn alignments() -> impl Iterator<Item = Alignment> {
    let turn = Complex::turn(0.3);
    [(false, false), (true, false), (true, true), (false, true)]
        .into_iter()
        .map(move |(swapped, mirrored)| Alignment { swapped, mirrored, turn, shift: 0.2 })
}

#[test]
fn the_jacobian_is_the_limit_of_differences() {
    let path = described(&Dimensions { coupler: 3.2, across: 0.9, ..KNOWN }, POSES);
    let free = free(&KNOWN).expect("it is within the limits");
    for alignment in alignments() {
        let remainder = Remainder { path: &path, alignment };
        let [a, b, c, d, e] = free;
        let varied = [a, b, c, d, e, 0.3, 0.2];
        // In numbers from 0 to 1, of which each stands for a range of angles.
        let slopes =
            remainder.evaluated(varied, true).expect("it is assembled").aims.slopes / RANGE;
        for column in 0..VARIED {
            let at = |step: f64| {
                let mut varied = varied;
                varied[column] += step;
                remainder.evaluated(varied, false).expect("it is assembled").aims.values
            };
            let h = 1e-5;
            for (row, (more, less)) in at(h).iter().zip(at(-h).iter()).enumerate() {
                let difference = (more - less) / (2.0 * h);
                let slope = slopes[(row, column)];
                // h²/6 of a third derivative of up to 12³, and roundings of 1e-14 over 2h.
                let slack = h * h / 6.0 * (HARMONICS as f64).powi(3) + 1e-14 / h;
                assert!((slope - difference).abs() < slack, "{row} {column}: {slope} {difference}");
            }
        }
    }
}

#[test]
fn the_remainder_is_the_distance() {
    let path = described(&Dimensions { base: 2.4, across: -1.0, ..KNOWN }, POSES);
    for dimensions in [KNOWN, KNOWN.mirrored(), Dimensions { along: -0.7, ..KNOWN }] {
        // The mirrored one on the same branch is another curve, and laid on in its own way.
        let dimensions = Dimensions { branch: Side::Left, ..dimensions };
        let curve = described(&dimensions, POSES);
        let (square, alignment) = path.aligned(&curve);
        let psi = alignment.turn.im.atan2(alignment.turn.re);
        let free = free(&dimensions).expect("it is within the limits");
        let [a, b, c, d, e] = free;
        let remainder = Remainder { path: &path, alignment };
        let at = remainder.evaluated([a, b, c, d, e, psi, alignment.shift], false);
        let sum = at.expect("it is assembled").cost();
        assert!((sum - square).abs() < 1e-13, "{sum} {square}");
    }
}

#[test]
fn a_known_design_is_found_from_the_grids_nearest() {
    let path = described(&KNOWN, search::FINE_POSES);
    let near = Dimensions {
        coupler: 3.0,
        follower: 3.5,
        base: 2.1,
        along: 2.2,
        across: 1.1,
        branch: Side::Left,
    };
    let start = search::compared(&path, 7, near).expect("slices of one length").expect("a curve");
    assert!(start.distance > 2e-3, "{}", start.distance);
    let found = refined(&path, &start).expect("slices of one length");
    // While it is refined a curve has half the poses, which leaves some 1e-5 of it.
    assert!(found.distance < 2e-5, "{found:?}");
    // The optimum lies in a valley: what is left of the curve leaves a tenth of the way from the grid.
    assert!((found.dimensions.coupler - KNOWN.coupler).abs() < 0.01, "{found:?}");
    assert_eq!(found.candidate, 7);
}

#[test]
fn what_cannot_be_bettered_stays_as_it_is() {
    let path = described(&KNOWN, search::FINE_POSES);
    let start = search::compared(&path, 0, KNOWN).expect("slices of one length").expect("a curve");
    let found = refined(&path, &start).expect("slices of one length");
    assert_eq!((found.dimensions, found.distance), (KNOWN, start.distance));
}
