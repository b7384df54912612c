//! Automatic differentiation against the formulas: velocities and accelerations from second-order
//! dual numbers along q(t), Jacobians, and sensitivities to the dimensions.
//!
//! Differentiating the position's closed form loses up to two digits against the formulas that
//! each group has for its velocity and acceleration; the allowance says so.

use linkage_core::nalgebra::SMatrix;
use linkage_core::num_dual::DualSVec;
use linkage_core::{Differentiable, Mechanism, Sense, Side, differentiate};
use linkage_tests::accuracy::{roundings, widened};
use linkage_tests::mechanisms::variable_dimensions::*;
use linkage_tests::mechanisms::{driven_groups::*, drivers::*, moving_bases::*, single_groups::*};
use linkage_tests::tables;
use num_dual::Dual2_64;

/// What `tabulated.rs` allows the formulas, times one, ten and a hundred.
const ONE_GROUP: [f64; 3] = [2.6, 37.0, 450.0];
const SIX_GROUPS: [f64; 3] = [6.3, 89.0, 1100.0];

fn only(seeds: [Dual2_64; 1]) -> Dual2_64 {
    seeds[0]
}

fn all<const N: usize>(seeds: [Dual2_64; N]) -> [Dual2_64; N] {
    seeds
}

/// An angle's second derivative is a difference of products as large as the squared rates. Where
/// it vanishes, the formulas say so exactly and a difference leaves the products' roundings.
fn still(second: f64, squared_rates: f64) -> f64 {
    if second.abs() <= 8.0 * f64::EPSILON * squared_rates { 0.0 } else { second }
}

macro_rules! differentiated {
    ($table:expr, $mechanism:expr, $outputs:expr, $arrange:expr, $allowed:expr) => {{
        let mechanism = $mechanism.lift::<Dual2_64>();
        let counts = roundings::<f64>(&$table, &$outputs, |row| {
            let seeds =
                core::array::from_fn(|i| Dual2_64::new(row.input[i], row.rate[i], row.second[i]));
            let rows = mechanism.position($arrange(seeds)).unwrap().rows();
            let row_rates = row.rate.iter().map(|rate| rate * rate).sum();
            [
                widened(rows.map(|row| row.re)),
                widened(rows.map(|row| row.v1)),
                widened(rows.map(|row| still(row.v2, row_rates))),
            ]
        });
        println!("{}: {counts:.2?} roundings", stringify!($table));
        for order in 0..3 {
            assert!(counts[order] <= $allowed[order], "{}: {counts:?}", stringify!($table));
        }
    }};
}

#[test]
fn single_groups_differentiate_to_their_motion() {
    use tables::single_groups::*;
    let bars = CouplerFourBar::new();
    differentiated!(COUPLER_FOUR_BAR, bars, CouplerFourBar::OUTPUTS, only, ONE_GROUP);
    let bars = CouplerFourBar { elbow: Side::Right, ..bars };
    differentiated!(COUPLER_FOUR_BAR_FLIPPED, bars, CouplerFourBar::OUTPUTS, only, ONE_GROUP);
    let crank = InclinedSliderCrank::new();
    differentiated!(INCLINED_SLIDER_CRANK, crank, InclinedSliderCrank::OUTPUTS, only, ONE_GROUP);
    let crank = InclinedSliderCrank { side: Sense::Behind, ..crank };
    let outputs = InclinedSliderCrank::OUTPUTS;
    differentiated!(INCLINED_SLIDER_CRANK_FLIPPED, crank, outputs, only, ONE_GROUP);
    let crank = OffsetQuickReturn::new();
    differentiated!(OFFSET_QUICK_RETURN, crank, OffsetQuickReturn::OUTPUTS, only, ONE_GROUP);
    let crank = OffsetQuickReturn { side: Sense::Behind, ..crank };
    let outputs = OffsetQuickReturn::OUTPUTS;
    differentiated!(OFFSET_QUICK_RETURN_FLIPPED, crank, outputs, only, ONE_GROUP);
    let guides = CrossedGuides::new();
    differentiated!(CROSSED_GUIDES, guides, CrossedGuides::OUTPUTS, only, ONE_GROUP);
    let yoke = ObliqueYoke::new();
    differentiated!(OBLIQUE_YOKE, yoke, ObliqueYoke::OUTPUTS, only, ONE_GROUP);
}

#[test]
fn drivers_and_inputs_differentiate_to_their_motion() {
    use tables::drivers::*;
    differentiated!(GANTRY, Gantry::new(), Gantry::OUTPUTS, all::<2>, ONE_GROUP);
    differentiated!(POLAR_ARM, PolarArm::new(), PolarArm::OUTPUTS, all::<2>, ONE_GROUP);
    let bars = GearedFiveBar::new();
    differentiated!(GEARED_FIVE_BAR, bars, GearedFiveBar::OUTPUTS, only, ONE_GROUP);
    let rack = RackAndPinion::new();
    differentiated!(RACK_AND_PINION, rack, RackAndPinion::OUTPUTS, only, ONE_GROUP);
    differentiated!(EXCAVATOR, Excavator::new(), Excavator::OUTPUTS, all::<3>, SIX_GROUPS);
    let guide = SwingingGuide::new();
    differentiated!(SWINGING_GUIDE, guide, SwingingGuide::OUTPUTS, all::<3>, ONE_GROUP);
}

#[test]
fn variable_dimensions_differentiate_to_their_motion() {
    use tables::variable_dimensions::*;
    let bars = VariableFourBar::new();
    differentiated!(VARIABLE_FOUR_BAR, bars, VariableFourBar::OUTPUTS, all::<2>, ONE_GROUP);
    differentiated!(VARIABLE_BAR, VariableBar::new(), VariableBar::OUTPUTS, all::<2>, ONE_GROUP);
    let guides = VariableCross::new();
    differentiated!(VARIABLE_CROSS, guides, VariableCross::OUTPUTS, all::<2>, ONE_GROUP);
    let yoke = VariableYoke::new();
    differentiated!(VARIABLE_YOKE, yoke, VariableYoke::OUTPUTS, all::<2>, ONE_GROUP);
    differentiated!(VARIABLE_ROD, VariableRod::new(), VariableRod::OUTPUTS, all::<2>, ONE_GROUP);
}

#[test]
fn a_long_chain_differentiates_to_its_motion() {
    let table = &tables::moving_bases::MOVING_BASES;
    differentiated!(table, MovingBases::new(), MovingBases::OUTPUTS, only, SIX_GROUPS);
}

/// The coefficients from the velocity equations against the position on dual numbers; the Jacobian is the
/// former.
macro_rules! assert_same_slopes {
    ($mechanism:expr, $q:expr, $slack:expr) => {{
        let mechanism = $mechanism;
        let (slopes, matrix) =
            (mechanism.coefficients($q).unwrap(), mechanism.jacobian($q).unwrap());
        let jacobian = by_duals(mechanism.lift(), $q);
        let largest = slopes.iter().flatten().fold(1.0, |a: f64, b| a.max(f64::from(b.abs())));
        for (i, row) in slopes.iter().enumerate() {
            for (j, slope) in row.iter().enumerate() {
                assert_eq!(matrix[(i, j)], *slope, "[{i}, {j}]");
                let error = f64::from((slope - jacobian[(i, j)]).abs());
                assert!(error <= $slack * largest, "[{i}, {j}]: {slope} and {}", jacobian[(i, j)]);
            }
        }
    }};
}

/// What an input is to a list.
trait Listed<F, const N: usize> {
    fn listed(self) -> [F; N];
}

impl<F> Listed<F, 1> for F {
    fn listed(self) -> [F; 1] {
        [self]
    }
}

impl<F, const N: usize> Listed<F, N> for [F; N] {
    fn listed(self) -> Self {
        self
    }
}

fn by_duals<F, M, const OUT: usize, const N: usize>(
    lifted: M,
    q: impl Listed<F, N>,
) -> SMatrix<F, OUT, N>
where
    F: Differentiable,
    M: Mechanism<
            Scalar = DualSVec<F, N>,
            Inputs = [DualSVec<F, N>; N],
            Rows = [DualSVec<F, N>; OUT],
        >,
{
    differentiate(q.listed(), |q| Mechanism::position(&lifted, q)).expect("far from limits")
}

#[test]
fn jacobians_are_the_coefficients() {
    // Conditions of the tabulated velocities, per unit velocity, stay below 100; two ways with
    // twenty and two hundred roundings.
    let (wide, narrow) = (1.0e4 * f64::EPSILON, 1.0e4 * f64::from(f32::EPSILON));
    for theta in [-3.0, -0.625, 0.5, 1.75] {
        assert_same_slopes!(CouplerFourBar::new(), theta, wide);
        assert_same_slopes!(InclinedSliderCrank::new(), theta, wide);
        assert_same_slopes!(OffsetQuickReturn::new(), theta, wide);
        assert_same_slopes!(CrossedGuides::new(), theta, wide);
        assert_same_slopes!(ObliqueYoke::new(), theta, wide);
        let theta = theta as f32;
        assert_same_slopes!(CouplerFourBar::<f32>::default(), theta, narrow);
        assert_same_slopes!(OffsetQuickReturn::<f32>::default(), theta, narrow);
    }
    assert_same_slopes!(Excavator::new(), [2.3125, 2.25, 1.90625], 6.0 * wide);
    assert_same_slopes!(SwingingGuide::new(), [0.5, 0.25, 0.375], wide);
    assert_same_slopes!(PolarArm::new(), [0.5, 0.75], wide);
    assert_same_slopes!(MovingBases::new(), 0.25, 6.0 * wide);
}

/// Lengthening a bar moves the pin along it by that much and along the other bar not at all.
#[test]
fn sensitivities_satisfy_the_constraints() {
    let bars = DrivenRrr { l1: 1.25, l2: 1.5, ..DrivenRrr::new() };
    assert_eq!(DrivenRrr::PARAMS, ["l1", "l2"]);
    for q in [[0.0, 0.0, 1.0, 0.5], [0.25, -0.5, 1.5, 1.0], [-1.0, 0.5, 0.5, -0.75]] {
        let pose = bars.position(q).unwrap();
        let slopes = bars.sensitivity(q).unwrap();
        let row =
            |name: &str| DrivenRrr::OUTPUTS.iter().position(|output| *output == name).unwrap();
        let (x, y) = (row("C.x"), row("C.y"));
        let along = |cos: f64, sin: f64, length: usize| {
            slopes[(x, length)] * cos + slopes[(y, length)] * sin
        };
        // Twenty roundings of numbers below 2, at angles whose sine is above 0.5.
        let slack = 80.0 * f64::EPSILON;
        for (bar, own) in [(pose.BC, 0), (pose.DC, 1)] {
            for length in 0..2 {
                let stretch = if length == own { 1.0 } else { 0.0 };
                assert!((along(bar.cos, bar.sin, length) - stretch).abs() <= slack);
            }
        }
        for (bar, name, size) in [(pose.BC, "BC.angle", 1.25), (pose.DC, "DC.angle", 1.5)] {
            for length in 0..2 {
                let turned = along(-bar.sin, bar.cos, length) / size;
                assert!((slopes[(row(name), length)] - turned).abs() <= slack);
            }
        }
    }
}
