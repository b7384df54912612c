//! Poses near toggles, near change points, tiny, huge and far away: as right as the data allow,
//! and at the edges of assembly the outcome that is right.

use linkage_core::{Side, SolveError};
use linkage_tests::hard_table;
use linkage_tests::mechanisms::driven_groups::DrivenRrp;
use linkage_tests::mechanisms::stacked_sliders::*;

/// Every number of every case within four times the error that rounding the inputs would cause;
/// what is refused has squares that leave the range of the numbers.
#[test]
fn every_number_is_as_right_as_its_data() {
    let (lines, refusals) = hard_table::table();
    for (mechanism, case, error) in &refusals {
        println!("{mechanism:14} {case:24} {error}");
        assert!(
            ["scale_1e-160", "rpr_over_pivot_1e-150"].contains(case),
            "{mechanism} {case}: {error}"
        );
        assert!(matches!(error, SolveError::NotFinite { .. }), "{case}: {error}");
    }
    for line in &lines {
        let (error, achievable, ratio) = (line.error, line.achievable, line.ratio());
        println!(
            "{:14} {:24} {:7} {error:9.2e} {achievable:9.2e} {ratio:6.2}{}",
            line.mechanism,
            line.case,
            line.quantity,
            if ratio > 4.0 { " !" } else { "" }
        );
    }
    let over: Vec<_> = lines.iter().filter(|line| line.ratio() > 4.0).collect();
    assert!(over.is_empty(), "{over:?}");
}

const RATE: [f64; 2] = [0.3, 0.7];
const SECOND: [f64; 2] = [-0.2, 0.5];

/// B at the origin, D on the x axis.
fn bars(dx: f64, l2: f64, l3: f64) -> StackedRrr {
    StackedRrr { dx, dy: 0.0, l2, l3, elbow: Side::Left }
}

/// The errors of position, velocity and motion, in this order.
fn refusals(group: StackedRrr) -> [SolveError; 3] {
    [
        group.position([0.0; 2]).unwrap_err(),
        group.velocity([0.0; 2], RATE).unwrap_err(),
        group.motion([0.0; 2], RATE, SECOND).unwrap_err(),
    ]
}

#[test]
fn short_by_one_unit_is_assembled_at_the_limit() {
    let group = bars(2.0 + 2.0 * f64::EPSILON, 1.0, 1.0);
    let pose = group.position([0.0; 2]).unwrap();
    // C is carried by the bar that stands on the ground, and that bar keeps its length.
    assert_eq!((pose.C.x, pose.C.y), (1.0 + 2.0 * f64::EPSILON, 0.0));
    assert_eq!([pose.BC.cos, pose.DC.cos], [1.0, -1.0]);
    let singular = SolveError::Singular { group: "BC, DC" };
    assert_eq!(group.velocity([0.0; 2], RATE).unwrap_err(), singular);
    assert_eq!(group.motion([0.0; 2], RATE, SECOND).unwrap_err(), singular);
}

#[test]
fn one_unit_inside_is_an_ordinary_pose() {
    let group = bars(2.0 - f64::EPSILON, 1.0, 1.0);
    let pose = group.position([0.0; 2]).unwrap();
    // √ε (1 − ε/8) = 2⁻²⁶ (1 − 2⁻⁵⁵), where all but the last roundings are exact: four of them.
    let height = 1.4901161193847656e-8;
    assert!((pose.C.y - height).abs() <= 4.0 * f64::EPSILON * height, "{:e}", pose.C.y);
    assert!((pose.C.x - 0.9999999999999999).abs() <= f64::EPSILON);
    assert!(group.motion([0.0; 2], RATE, SECOND).is_ok());
}

#[test]
fn a_length_that_is_no_number_is_named() {
    for error in refusals(bars(2.0, f64::NAN, 1.0)) {
        assert_eq!(error, SolveError::NotFinite { name: "l2" });
    }
}

#[test]
fn a_negative_length_is_named() {
    for error in refusals(bars(2.0, -1.0, 1.0)) {
        assert_eq!(error, SolveError::Invalid { group: "BC, DC", name: "l2" });
    }
}

#[test]
fn lengths_of_zero_are_invalid() {
    for error in refusals(bars(0.0, 0.0, 0.0)) {
        assert_eq!(error, SolveError::Invalid { group: "BC, DC", name: "l2" });
    }
}

#[test]
fn circles_about_one_point_are_out_of_reach() {
    for error in refusals(bars(0.0, 1.0, 2.0)) {
        assert_eq!(error, SolveError::OutOfReach { group: "BC, DC", by: 1.0 });
    }
}

#[test]
fn subnormal_lengths_are_refused() {
    let tiny = f64::from_bits(1);
    for error in refusals(bars(tiny, tiny, tiny)) {
        assert!(matches!(error, SolveError::NotFinite { .. } | SolveError::Singular { .. }));
    }
}

/// A bar as long as B is far from the guide.
#[test]
fn a_bar_square_to_its_guide_is_assembled_at_the_limit() {
    let group = DrivenRrp::new();
    let (q, rate) = ([0.0, 1.0, 0.0, 0.0, 0.0], [0.3, 0.0, 0.0, 0.0, 0.0]);
    let pose = group.position(q).unwrap();
    assert_eq!(pose.block.slide, 0.0);
    let singular = SolveError::Singular { group: "BC, block" };
    assert_eq!(group.velocity(q, rate).unwrap_err(), singular);
}

/// A massless rod nearly square to its guide, a load of 1000 on its block. By virtual work the
/// force on the rod's pin is −1000 times what the block's slide changes with the pin's place.
#[test]
fn the_reaction_of_a_toggle_press_is_as_right_as_its_data() {
    let coefficients = DrivenRrp::new().coefficients([0.0, 0.99, 0.0, 0.0, 0.0]).unwrap();
    let row = DrivenRrp::OUTPUTS.iter().position(|row| *row == "block.slide").unwrap();
    let [x, y, ..] = coefficients[row];
    assert!((-1000.0 * x + 1000.0).abs() <= 4.0 * 2.22e-13, "{x}");
    let error = (-1000.0 * y - 7_017.923_929_582_522) - 2.539_344e-13;
    assert!(error.abs() <= 4.0 * 7.986e-11, "{error:e}");
}

/// The largest crank angle of a double-rocker, found as the zero of its margin.
#[test]
fn the_margin_vanishes_where_the_crank_must_stop() {
    let linkage = DoubleRocker::new();
    let margin = |theta| linkage.margins(theta).unwrap().DC_margin;
    let (mut reached, mut missed) = (1.0, 2.5);
    assert!(margin(reached) > 0.0 && margin(missed) < 0.0);
    while missed - reached > f64::EPSILON {
        let middle = (reached + missed) / 2.0;
        if margin(middle) >= 0.0 {
            reached = middle;
        } else {
            missed = middle;
        }
    }
    let error = reached - 1.847_264_863_117_762_9;
    assert!(error.abs() <= 4.0 * 1.531e-15, "{error:e}");
    // The margin's slope against the angle is |∂d/∂θ| ≈ a: short of the limit by some last places
    // of the angle, the pose is still there or assembled at the limit.
    assert!(linkage.position(reached).is_ok());
    assert!(matches!(linkage.position(2.0), Err(SolveError::OutOfReach { .. })));
}
