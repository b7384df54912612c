//! Kinematic coefficients, the derivatives of the outputs with respect to the inputs: their shape,
//! their zeros and their linearity. That times the rates they are the velocity is held in
//! `tabulated.rs`.

use linkage_tests::mechanisms::{drivers::*, single_groups::*};

/// All about a velocity with one input is proportional to the rate, so doubling it commutes with
/// every rounding.
#[test]
fn velocities_are_linear_in_the_rate() {
    for step in 0..32 {
        let theta = -3.0 + f64::from(step) * 0.09375;
        let bars = CouplerFourBar::new();
        let unit = bars.velocity(theta, 1.0).unwrap().rows();
        for factor in [2.0, -4.0, 0.125, 0.0] {
            let scaled = bars.velocity(theta, factor).unwrap().rows();
            assert_eq!(scaled, unit.map(|rate| rate * factor));
        }
    }
}

#[test]
fn coefficients_have_a_row_an_output_and_a_column_an_input() {
    let slopes: [[f64; 3]; 9] = Excavator::new().coefficients([2.3125, 2.25, 1.90625]).unwrap();
    assert_eq!(Excavator::INPUTS, ["lift", "crowd", "curl"]);
    let row =
        |name: &str| slopes[Excavator::OUTPUTS.iter().position(|output| *output == name).unwrap()];
    // The boom moves by its own cylinder alone, the stick by two, the bucket by all three.
    assert_eq!(row("boom.angle")[1..], [0.0, 0.0]);
    assert!(row("boom.angle")[0] != 0.0);
    assert!(row("stick.angle")[1] != 0.0);
    assert_eq!(row("stick.angle")[2], 0.0);
    assert!(row("bucket.angle").iter().all(|slope| *slope != 0.0));
}
