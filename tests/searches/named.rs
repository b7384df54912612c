//! Set-points and extremes of outputs by their names.

use std::f64::consts::PI;

use linkage_core::find::{FindError, OutputError, Search};
use linkage_core::range::{RangeError, extrema, extrema_of};
use linkage_core::{Mechanism, SolveError, Trend, mechanism};
use linkage_tests::mechanisms::ranges::FourBar;

mechanism! {
    /// A press with all its outputs.
    struct Named {
        input theta: angle;
        ground A(0, 0);
        guide bed through (0, 30mm) along 0deg;
        crank AB(A) -> B           { length: 80mm, angle: theta }
        rrp   BC(B), ram(bed) -> C { length: 250mm, mode: ahead }
        output AB, BC.angle, B, C.x, ram.slide;
    }
}

const OUTPUTS: &[&str] = <Named as Mechanism>::OUTPUTS;

/// Each output by its name is the output of its row.
#[test]
fn every_output_is_found_by_its_name() {
    let press = Named::new();
    assert!(OUTPUTS.len() > 3);
    for (row, name) in OUTPUTS.iter().enumerate() {
        let by_name = extrema_of(&press, name, [-2.9, 2.8]).expect("the crank turns fully");
        let by_row = extrema([-2.9, 2.8], |theta| {
            Ok(Mechanism::motion(&press, [theta], [1.0], [0.0])?.map(|rows| rows[row]))
        });
        assert_eq!(by_name[..], by_row.expect("the crank turns fully")[..], "{name}");
        // Where it stands at an angle it is found again.
        let of = |theta: f64| Mechanism::motion(&press, [theta], [1.0], [0.0]).expect("it turns");
        let [value, slope, _] = of(0.7).map(|rows| rows[row]);
        let trend = if slope > 0.0 { Trend::Rising } else { Trend::Falling };
        let search = Search::new([0.6, 0.8], trend);
        let found = search.find_output(&press, name, value).expect("it is there");
        let left = of(found.at)[0][row] - value;
        assert!(left.abs() < 4e-16 && (found.at - 0.7).abs() < 1e-12, "{name} {left:e}");
        let single = Named::<f32>::default();
        let search = Search::new([0.6_f32, 0.8], trend);
        let found = search.find_output(&single, name, value as f32).expect("it is there");
        assert!((found.at - 0.7).abs() < 1e-4, "{name}");
    }
}

#[test]
fn a_name_that_is_none_lists_those_that_are() {
    let press = Named::new();
    for name in ["", "ram", "ram.slid", "ram.slides", "RAM.slide", "C"] {
        let found = extrema_of(&press, name, [0.0, 1.0]).map(|_| ());
        assert_eq!(found, Err(RangeError::NoOutput { outputs: OUTPUTS }));
        let found = Search::new([0.0, 1.0], Trend::Rising).find_output(&press, name, 0.2);
        assert_eq!(found, Err(OutputError::NoOutput { outputs: OUTPUTS }));
        let text = found.unwrap_err().to_string();
        assert!(text.starts_with("no output of this name; there are `"), "{text}");
        assert!(OUTPUTS.iter().all(|output| text.contains(&format!("`{output}`"))), "{text}");
    }
}

/// An angle that passes ±π is found there, and its jump on the other side is no root.
#[test]
fn an_angle_is_compared_within_half_a_turn() {
    let press = Named::new();
    assert!(OUTPUTS.contains(&"AB.angle"), "{:?}", OUTPUTS);
    for wanted in [3.0, PI, -3.0, -2.5] {
        let rising = Search::new([2.0, 4.5], Trend::Rising);
        let found = rising.find_output(&press, "AB.angle", wanted).expect("it turns").at;
        let expected = if wanted < 0.0 { wanted + 2.0 * PI } else { wanted };
        assert!((found - expected).abs() < 2e-15, "{wanted} {found}");
    }
    let falling = Search::new([0.0, 1.0], Trend::Falling);
    let jump = falling.find_output(&press, "AB.angle", 0.5 - PI);
    let is_refused = matches!(
        jump,
        Err(OutputError::Find(FindError::NoSolution { .. } | FindError::SeveralDeadPoints))
    );
    assert!(is_refused, "{jump:?}");
}

#[test]
fn a_pose_that_is_none_names_its_group() {
    let short = FourBar { crank: 2.0, coupler: 1.0, rocker: 1.0, base: 3.0, ..FourBar::new() };
    let name = <FourBar as Mechanism>::OUTPUTS[0];
    let found = Search::new([0.0, PI], Trend::Rising).find_output(&short, name, 0.3);
    assert!(
        matches!(found, Err(OutputError::Solve(SolveError::OutOfReach { group: "BC, DC", .. }))),
        "{found:?}"
    );
    let found = extrema_of(&short, name, [0.0, PI]).map(|_| ());
    assert!(matches!(found, Err(RangeError::Solve(SolveError::OutOfReach { .. }))), "{found:?}");
}
