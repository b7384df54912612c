//! The error of every group as its limit comes near, 1e-1 to 1e-15 of its size away, against the change that
//! rounding the data would cause.

use linkage_tests::double_double::DoubleDouble;
use linkage_tests::measured;
use linkage_tests::measured::families::{self, Family};
use linkage_tests::measured::poses::Source;
use linkage_tests::measured::{Measured, Pose, Width};
use linkage_tests::mechanisms::near_limits::{CompensatedRrp, LevelRrp};
use linkage_tests::random::cases;

/// The count of poses of each family at each distance; without optimisation a measurement takes half a
/// millisecond, and an ordinary run samples what `.ci/nightly` measures whole.
fn poses() -> usize {
    if cfg!(debug_assertions) { cases(16, 50) } else { 1000 }
}

/// The worst ratio of error to achievable error of position, velocity and acceleration over a
/// family, at each distance; a point is one quantity. Where the data determine no answer, none is
/// counted.
fn ratios<const I: usize, const P: usize, const ROWS: usize>(
    family: Family<I, P>,
    measure: impl Fn(&Pose<I, P>, Width) -> Option<[[Measured; ROWS]; 3]>,
    width: Width,
    gap: f64,
) -> (usize, [f64; 3]) {
    let mut source = Source::new(7);
    let mut worst = [0.0_f64; 3];
    let mut count = 0;
    for _ in 0..poses() {
        let Some(orders) = measure(&family(&mut source, gap).rounded(width), width) else {
            continue;
        };
        count += 1;
        for (worst, rows) in worst.iter_mut().zip(orders) {
            *worst = rows.iter().fold(*worst, |worst, row| worst.max(row.ratio()));
        }
    }
    (count, worst)
}

macro_rules! assert_achieved {
    ($name:ident: $family:ident of $group:ident, $allowed:expr) => {
        #[test]
        fn $name() {
            for width in [Width::Double, Width::Single] {
                for exponent in 1..=15 {
                    let gap = 10.0_f64.powi(-exponent);
                    let (count, worst) =
                        ratios(families::$family, measured::$group::measure, width, gap);
                    println!("{width:?} {gap:5.0e} {count:4} {worst:5.2?}");
                    assert!(
                        gap < 64.0 * width.half_unit() || count > poses() / 2,
                        "{gap:e}: {count}"
                    );
                    for order in 0..3 {
                        assert!(worst[order] <= $allowed[order], "{width:?} {gap:e}: {worst:?}");
                    }
                }
            }
        }
    };
}

const FOUR: [f64; 3] = [4.0; 3];

assert_achieved! { stretched_bars: stretched of rrr, FOUR }
assert_achieved! { folded_bars: folded of rrr, FOUR }
assert_achieved! { collapsed_bars: collapsed of rrr, FOUR }
assert_achieved! { compensated_collapsed_bars: collapsed of compensated_rrr, FOUR }
assert_achieved! { compensated_stretched_bars: stretched of compensated_rrr, FOUR }
assert_achieved! { a_bar_square_to_its_guide: square_to_guide of rrp, FOUR }
assert_achieved! { a_block_at_its_offset: at_offset of rpr, FOUR }
assert_achieved! { a_block_over_its_pivot: over_pivot of rpr, FOUR }
assert_achieved! { nearly_parallel_guides: parallel_guides of prp, FOUR }
assert_achieved! { a_slot_nearly_along_its_rail: slot_along_rail of rpp, FOUR }
assert_achieved! { a_rod_behind_a_four_bar: chained_rod of chained_press, FOUR }
assert_achieved! { bars_behind_a_four_bar: chained_stretched of chained_bars, FOUR }

/// At rest and in motion: reactions have the inverse that velocities have, and no other.
const REACTIONS: [f64; 3] = [4.0, 4.0, 8.0];

assert_achieved! { reactions_of_stretched_bars: stretched of rrr_forces, REACTIONS }
assert_achieved! { reactions_of_folded_bars: folded of rrr_forces, REACTIONS }
assert_achieved! { reactions_of_a_bar_square_to_its_guide: square_to_guide of rrp_forces, REACTIONS }
assert_achieved! { reactions_of_a_block_at_its_offset: at_offset of rpr_forces, REACTIONS }
assert_achieved! { reactions_of_nearly_parallel_guides: parallel_guides of prp_forces, REACTIONS }
assert_achieved! { reactions_of_a_slot_nearly_along_its_rail: slot_along_rail of rpp_forces, REACTIONS }

/// The pose with every length `size` times as large: all numbers but the angles among the inputs
/// and parameters.
fn sized<const I: usize, const P: usize>(
    pose: Pose<I, P>,
    size: f64,
    angles: &[usize],
    params: &[usize],
) -> Pose<I, P> {
    let list = |values: [f64; I]| {
        core::array::from_fn(|i| if angles.contains(&i) { values[i] } else { size * values[i] })
    };
    let (q, rate, second) = (list(pose.q), list(pose.rate), list(pose.second));
    let params = core::array::from_fn(|i| {
        if params.contains(&i) { pose.params[i] } else { size * pose.params[i] }
    });
    Pose { q, rate, second, params, ..pose }
}

macro_rules! assert_any_size {
    ($name:ident: $family:ident of $group:ident, $gap:literal, angles $angles:expr, $params:expr) => {
        #[test]
        fn $name() {
            for width in [Width::Double, Width::Single] {
                for exponent in -9..=9 {
                    let size = 10.0_f64.powi(exponent);
                    let mut source = Source::new(11);
                    for _ in 0..poses() {
                        let pose = families::$family(&mut source, $gap);
                        let pose = sized(pose, size, &$angles, &$params).rounded(width);
                        let orders = measured::$group::measure(&pose, width);
                        let orders = orders.unwrap_or_else(|| panic!("{width:?} {pose:?}"));
                        let worst = orders.iter().flatten().map(|row| row.ratio());
                        let worst = worst.fold(0.0, f64::max);
                        assert!(worst <= 4.0, "{width:?} {size:e}: {worst} at {pose:?}");
                    }
                }
            }
        }
    };
}

assert_any_size! { bars_of_any_size: stretched of rrr, 0.1, angles [], [] }
assert_any_size! { sliders_of_any_size: square_to_guide of rrp, 0.1, angles [4], [] }
assert_any_size! { blocks_of_any_size: at_offset of rpr, 0.1, angles [], [] }
assert_any_size! { guides_of_any_size: parallel_guides of prp, 0.3, angles [2, 5], [] }
assert_any_size! { yokes_of_any_size: slot_along_rail of rpp, 0.3, angles [4], [0] }

/// The slide's relative error where B is at (0, `y`) and the guide runs along x.
macro_rules! slide_error {
    ($group:ident, $y:expr, $l:expr, $e:expr) => {{
        let group = $group { l: $l, e: $e };
        let found = group.position([0.0, $y]).ok().map(|pose| pose.block.slide);
        let wide = $group { l: DoubleDouble::<false>::new($l), e: DoubleDouble::new($e) };
        let (truth, ok) = wide.solve_position([0.0, $y].map(DoubleDouble::new));
        let truth = truth.block.slide;
        found.filter(|_| ok).map(|found| ((found - truth.high) - truth.low).abs() / truth.high)
    }};
}

/// The rounding error of e − y is added back, so the slide is right to its last places. Without it the slide
/// would lose √(ε/2) of itself at a distance of ε.
#[test]
fn a_carried_distance_pays_nothing_for_the_limit() {
    let mut source = Source::new(3);
    let (mut carried, mut plain, mut count) = (0.0_f64, 0.0_f64, 0);
    for exponent in 1..=15 {
        for _ in 0..100 {
            let (e, y) = (source.between(0.1, 1.0), source.between(-2.0, -0.5));
            let l = (e - y) * (1.0 + 10.0_f64.powi(-exponent));
            let Some(error) = slide_error!(CompensatedRrp, y, l, e) else { continue };
            carried = carried.max(error);
            plain = plain.max(slide_error!(LevelRrp, y, l, e).unwrap_or(1.0));
            count += 1;
        }
    }
    assert!(count > 1400, "{count}");
    // Two differences and their product, the root, and two products beside it: half an ε each at
    // most, half of those under the root.
    assert!(carried <= 3.0 * f64::EPSILON, "{carried:e}");
    assert!(plain > 1e-3, "{plain:e}");
}
