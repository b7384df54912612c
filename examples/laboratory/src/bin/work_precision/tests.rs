//! The truth is right, and every form is near it.

use laboratory::generated as g;
use linkage_tests::double_double::DoubleDouble;

use crate::error::errors;
use crate::forms::by_hand::ByHand;
use crate::forms::dual::Dual;
use crate::forms::half_angle::HalfAngle;
use crate::forms::straightforward::Straightforward;
use crate::mechanisms::{self as m, CHAIN, FOUR_BAR, Mechanism, SIX_BAR, STEPHENSON};

/// A number of 50 digits as high and low word.
type Words = (f64, f64);

/// Position, velocity and acceleration of each mechanism at a crank angle of 1.0390625 rad, from closed forms on complex
/// numbers; velocities and accelerations are their central differences, all of it in 130 digits (mpmath). The low words
/// have three digits.
#[rustfmt::skip]
const FOUR_BAR_NUMBERS: [Words; 14] = [
    (0.17425754079383016, -1.11e-17), (0.18724170612123978, 2.56e-19), (0.9358000328433643, -3.75e-17),
    (0.35253127312390076, 7.94e-18), (-0.0876979310138635, 2.21e-18), (0.996147114082999, 5.52e-17),
    (-15.883866399906578, -6.68e-16), (5.478259741205837, -4.51e-17), (-60.29051379924402, 3.15e-15),
    (93.12829139181797, -6.68e-16), (-5308.6249349484615, 2.75e-13), (-3868.729690965809, -1.28e-13),
    (15604.100634384291, -4.84e-13), (32203.242177674525, 1.04e-12),
];

#[rustfmt::skip]
const SIX_BAR_NUMBERS: [Words; 13] = [
    (0.14912832199791914, 7.01e-18), (0.9888178515672565, -2.72e-17), (1.3599791959689667, 7.42e-17),
    (0.23860531519667064, 5.66e-18), (-0.21789143749238957, -4.73e-18), (2.7291692806908183, -1.73e-16),
    (1.4912832199791914, 7.01e-17), (-4.31784208751368, 1.38e-16), (0.6511942964443036, -4.26e-17),
    (6.071819992776852, 3.41e-16), (-26.38999975896882, -2.22e-16), (-11.38349787019402, 8.54e-16),
    (-10.335353460922281, -5.90e-16),
];

#[rustfmt::skip]
const STEPHENSON_NUMBERS: [Words; 16] = [
    (0.0566583956266646, -2.38e-18), (0.11243033215809405, -6.33e-18), (0.16717968498395736, -8.57e-18),
    (0.15917479277966468, 1.31e-17), (-0.12820315016042652, -1.35e-17), (0.9917479277966469, -2.34e-18),
    (-0.6528552044134412, -9.58e-18), (0.430423964083317, -2.37e-18), (-0.4464027428439764, -1.54e-17),
    (-0.05770643554557279, -1.66e-18), (4.501171419997251, 4.44e-16), (-47.7237084117677, -1.05e-15),
    (-19.130737296030723, -2.69e-16), (-54.512062570097235, -3.21e-15), (-9.089681264549277, 6.06e-16),
    (552.2755086588452, 1.88e-14),
];

#[rustfmt::skip]
const CHAIN_NUMBERS: [Words; 10] = [
    (0.37548526455843634, -1.76e-17), (0.08659692688675587, 1.77e-18), (-0.27238594935070753, -1.67e-17),
    (0.9621880765195097, 1.21e-18), (-0.2608254268289268, -2e-17), (-0.07383710444489196, -6.58e-18),
    (3.0119478393270493, -1.49e-18), (-12.875776115338285, -7.01e-16), (-4.49355514491281, -3.98e-17),
    (151.2544393135558, -1.04e-15),
];

/// The truth has some 31 digits, and the low word that it is compared with three of its own, behind the 16 of the high
/// one: half a unit of the third is 5e-3 of at most ε/2 of the number.
fn is_true<const N: usize>(mechanism: &Mechanism<N>, numbers: [Words; N]) {
    let input = [1.039_062_5, mechanism.rate, mechanism.second].map(DoubleDouble::new);
    let found = (mechanism.truth)(input).expect("it is reached");
    for (k, (found, (high, low))) in found.into_iter().zip(numbers).enumerate() {
        let off = ((found.high - high) + (found.low - low)).abs();
        let allowed = 6e-3 * f64::EPSILON / 2.0 * high.abs();
        assert!(off <= allowed, "{} {k}: {off:e}, {allowed:e}", mechanism.name);
    }
}

#[test]
fn the_truth_is_that_of_fifty_digits() {
    is_true(&FOUR_BAR, FOUR_BAR_NUMBERS);
    is_true(&SIX_BAR, SIX_BAR_NUMBERS);
    is_true(&STEPHENSON, STEPHENSON_NUMBERS);
    is_true(&CHAIN, CHAIN_NUMBERS);
}

/// The forms are another way to the same numbers: none is off by more than 20 ε, where a wrong formula is off by 1e12.
/// The documentation has their errors, 6.2 ε at the most.
#[test]
fn every_form_is_near_the_truth() {
    let all = [
        errors(&FOUR_BAR, |input: [f64; 3]| m::four_bar(&mut ByHand, input)),
        errors(&FOUR_BAR, |input: [f64; 3]| m::four_bar(&mut HalfAngle, input)),
        errors(&FOUR_BAR, |input: [f64; 3]| m::four_bar(&mut Dual, input)),
        errors(&STEPHENSON, |input: [f64; 3]| m::stephenson(&mut ByHand, input)),
        errors(&CHAIN, |input: [f64; 3]| m::chain(&mut ByHand, input)),
        errors(&CHAIN, |input: [f32; 3]| m::chain(&mut ByHand, input)),
        errors(&SIX_BAR, |input: [f64; 3]| m::six_bar(&mut Straightforward, input)),
        errors(&SIX_BAR, |input: [f32; 3]| m::six_bar(&mut Dual, input)),
    ];
    for (form, errors) in all.into_iter().enumerate() {
        assert!(errors.iter().all(|error| *error < 20.0), "{form}: {errors:?}");
    }
}

/// An error is in ε of the largest value of its quantity, and a form that refuses has none.
#[test]
fn an_error_is_of_its_order_and_in_its_unit() {
    let at = |order: usize| {
        errors(&FOUR_BAR, |[t, w, a]: [f64; 3]| {
            let mut numbers = m::four_bar(&mut Straightforward, [t, w, a])?;
            // P.x, the coupler's rate, and the rocker's acceleration.
            let number = &mut numbers[[0, 8, 13][order]];
            *number += [0.2, 150.0, 5e4][order] * 1e-12;
            Some(numbers)
        })
    };
    for order in 0..3 {
        let errors = at(order);
        for (other, error) in errors.into_iter().enumerate() {
            // 1e-12 is 4504 ε; the largest values are within a factor of three of the numbers above.
            let is_large = (1500.0..14_000.0).contains(&error);
            assert_eq!(is_large, other == order, "{order}: {errors:?}");
        }
    }
    let refused = errors(&FOUR_BAR, |_: [f64; 3]| None);
    assert!(refused.iter().all(|error| error.is_nan()), "{refused:?}");
}

/// The generated solvers' numbers come in the order of the forms'.
#[test]
fn records_have_the_order_of_the_forms() {
    let solver = g::SixBar::<f64>::default();
    let found = errors(&SIX_BAR, |[t, w, a]: [f64; 3]| {
        let (motion, is_met) = solver.solve_motion(t, w, a);
        is_met.then(|| linkage_core::Record::into_array(motion))
    });
    assert!(found.iter().all(|error| *error < 20.0), "{found:?}");
}
