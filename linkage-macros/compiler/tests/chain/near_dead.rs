//! Tests of `chain/near_dead`.

use std::f64::consts::TAU;

use crate::chain::fit::NearDead;
pub(crate) use linkage_compiler::chain::near_dead::*;

/// The branch of φ² = x² + e² beside a smooth curve: the terms are those of the curve, to roundings of the least
/// squares, which are some dozen units in the last place.
#[test]
fn the_terms_of_a_bend_are_those_of_the_curve() {
    let terms = [NearDead { at: 0.7, width: 0.05, even: -0.8, odd: 0.3 }];
    let curve: Vec<_> = (0..120).map(|i| TAU * f64::from(i) / 120.0 - 3.0).collect();
    let smooth = |x: f64| vec![1.0, x.cos(), x.sin()];
    let curve: Vec<_> =
        curve.iter().map(|&x| [x, 0.4 - 0.3 * x.cos() + 0.1 * x.sin() + terms[0].at(x)]).collect();
    let found = fitted(&curve, &[[0.7, 0.05]], smooth);
    let off = [found[0].even - terms[0].even, found[0].odd - terms[0].odd].map(f64::abs);
    assert!(off.iter().all(|off| *off < 1e-13), "{off:?}");
}

/// The place and the distance are those of the complex zeros of the squared slope, here a parabola.
#[test]
fn a_place_is_that_of_the_complex_zeros_of_the_squared_slope() {
    let squares = |x: f64| 2.0 * ((x - 0.31).powi(2) + 0.04_f64.powi(2));
    let near = [0.26, 0.3, 0.37].map(|x| [x, squares(x)]);
    let [at, width] = place(&near, 1.0).expect("it is least in between");
    // Differences of squares of some hundredths, over a step of some hundredths.
    assert!((at - 0.31).abs() < 1e-13 && (width - 0.04).abs() < 1e-13, "{at} {width}");
    assert!(place(&near, squares(0.3)).is_none(), "it is not deep");
    assert!(place(&[0.36, 0.4, 0.47].map(|x| [x, squares(x)]), 1.0).is_none());
}
