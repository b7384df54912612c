//! Every group, driver and composition against tables of 22 digits, in both widths: motions, and
//! velocities once more as kinematic coefficients times rates.
//!
//! A table gives with each number its condition: what it changes per unit relative change of all
//! dimensions, inputs and rates. A rounding inside a solver that works in vectors relative to a
//! joint is at worst as harmful as a relative change of half ε in one of these. A group's position
//! takes some twenty operations behind an inner joint (the sine and cosine of the driver, the pin,
//! the square root, the joint, the direction, the point), its velocity and acceleration some
//! twenty each more. Roundings are of either sign: n of them, each up to half ε and evenly
//! distributed, add up to √(n/12) ε in the mean square; a table may show twice that.

use linkage_core::{Real, Sense, Side};
use linkage_tests::accuracy::{roundings, widened};
use linkage_tests::in_both_widths;
use linkage_tests::mechanisms::variable_dimensions::*;
use linkage_tests::mechanisms::{drivers::*, moving_bases::*, published::*, single_groups::*};
use linkage_tests::tables;
use linkage_tests::tables::truth::Table;
use linkage_tests::widths::number;

/// 2 √(20/12), 2 √(40/12), 2 √(60/12): behind one inner joint.
const ONE_GROUP: [f64; 3] = [2.6, 3.7, 4.5];

/// Six inner joints, each standing on earlier ones: six times the operations.
const SIX_GROUPS: [f64; 3] = [6.3, 8.9, 11.0];

/// The only number of a row's list.
fn only<T: Real>(values: &[f64]) -> T {
    assert_eq!(values.len(), 1);
    number(values[0])
}

/// All numbers of a row's list.
fn all<T: Real, const N: usize>(values: &[f64]) -> [T; N] {
    core::array::from_fn(|i| number(values[i]))
}

fn assert_within(table: &str, roundings: [f64; 3], allowed: [f64; 3]) {
    println!("{table}: {roundings:.2?} roundings");
    for order in 0..3 {
        assert!(roundings[order] <= allowed[order], "{table}: {roundings:?} > {allowed:?}");
    }
}

/// The mechanism's motion over a table, and its coefficients times the table's rates.
macro_rules! follow {
    ($t:ty, $table:expr, $mechanism:ident $fields:tt, $read:expr, $allowed:expr) => {{
        let mechanism = $mechanism::<$t> $fields;
        let table: &Table = &$table;
        let counts = roundings::<$t>(table, &$mechanism::OUTPUTS, |row| {
            let motion = mechanism
                .motion($read(row.input), $read(row.rate), $read(row.second))
                .unwrap_or_else(|error| panic!("{error} at {row:?}"));
            [
                widened(motion.position.rows()),
                widened(motion.velocity.rows()),
                widened(motion.acceleration.rows()),
            ]
        });
        assert_within(stringify!($table), counts, $allowed);

        let counts = roundings::<$t>(table, &$mechanism::OUTPUTS, |row| {
            let motion = mechanism
                .motion($read(row.input), $read(row.rate), $read(row.second))
                .unwrap_or_else(|error| panic!("{error} at {row:?}"));
            let slopes = mechanism
                .coefficients($read(row.input))
                .unwrap_or_else(|error| panic!("{error} at {row:?}"));
            let rates = slopes.map(|slopes| {
                slopes.iter().zip(row.rate).map(|(slope, rate)| slope.value() * rate).sum()
            });
            let seconds = widened(motion.acceleration.rows());
            [widened(motion.position.rows()), Vec::from(rates), seconds]
        });
        assert_within(concat!(stringify!($table), " by coefficients"), counts, $allowed);
    }};
}

/// All of the mechanism's outputs are in the table.
fn assert_complete(table: &Table, outputs: &[&str]) {
    for output in outputs {
        assert!(table.outputs.contains(output), "`{output}` is not tabulated");
    }
}

#[test]
fn the_tables_hold_every_output() {
    assert_complete(&tables::single_groups::COUPLER_FOUR_BAR, &CouplerFourBar::OUTPUTS);
    assert_complete(&tables::single_groups::INCLINED_SLIDER_CRANK, &InclinedSliderCrank::OUTPUTS);
    assert_complete(&tables::single_groups::OFFSET_QUICK_RETURN, &OffsetQuickReturn::OUTPUTS);
    assert_complete(&tables::single_groups::CROSSED_GUIDES, &CrossedGuides::OUTPUTS);
    assert_complete(&tables::single_groups::OBLIQUE_YOKE, &ObliqueYoke::OUTPUTS);
    assert_complete(&tables::drivers::GANTRY, &Gantry::OUTPUTS);
    assert_complete(&tables::drivers::POLAR_ARM, &PolarArm::OUTPUTS);
    assert_complete(&tables::drivers::GEARED_FIVE_BAR, &GearedFiveBar::OUTPUTS);
    assert_complete(&tables::drivers::RACK_AND_PINION, &RackAndPinion::OUTPUTS);
    assert_complete(&tables::drivers::EXCAVATOR, &Excavator::OUTPUTS);
    assert_complete(&tables::drivers::SWINGING_GUIDE, &SwingingGuide::OUTPUTS);
    use tables::variable_dimensions::*;
    assert_complete(&VARIABLE_FOUR_BAR, &VariableFourBar::OUTPUTS);
    assert_complete(&VARIABLE_BAR, &VariableBar::OUTPUTS);
    assert_complete(&VARIABLE_CROSS, &VariableCross::OUTPUTS);
    assert_complete(&VARIABLE_YOKE, &VariableYoke::OUTPUTS);
    assert_complete(&VARIABLE_ROD, &VariableRod::OUTPUTS);
    assert_complete(&tables::moving_bases::MOVING_BASES, &MovingBases::OUTPUTS);
    assert_complete(&tables::four_bar::FOUR_BAR, &FourBar::OUTPUTS);
    assert_complete(&tables::rpp_systems::CRANK_RPP, &CrankRpp::OUTPUTS);
    assert_complete(&tables::rpp_systems::SIX_BAR, &SixBar::OUTPUTS);
    assert_complete(&tables::flying_shear::FLYING_SHEAR, &FlyingShear::OUTPUTS);
}

fn coupler_four_bar<T: Real>() {
    use tables::single_groups::{COUPLER_FOUR_BAR, COUPLER_FOUR_BAR_FLIPPED};
    follow!(T, COUPLER_FOUR_BAR, CouplerFourBar { ..Default::default() }, only, ONE_GROUP);
    follow!(
        T,
        COUPLER_FOUR_BAR_FLIPPED,
        CouplerFourBar { elbow: Side::Right, ..Default::default() },
        only,
        ONE_GROUP
    );
}

fn inclined_slider_crank<T: Real>() {
    use tables::single_groups::{INCLINED_SLIDER_CRANK, INCLINED_SLIDER_CRANK_FLIPPED};
    follow!(
        T,
        INCLINED_SLIDER_CRANK,
        InclinedSliderCrank { ..Default::default() },
        only,
        ONE_GROUP
    );
    follow!(
        T,
        INCLINED_SLIDER_CRANK_FLIPPED,
        InclinedSliderCrank { side: Sense::Behind, ..Default::default() },
        only,
        ONE_GROUP
    );
}

fn offset_quick_return<T: Real>() {
    use tables::single_groups::{OFFSET_QUICK_RETURN, OFFSET_QUICK_RETURN_FLIPPED};
    follow!(T, OFFSET_QUICK_RETURN, OffsetQuickReturn { ..Default::default() }, only, ONE_GROUP);
    follow!(
        T,
        OFFSET_QUICK_RETURN_FLIPPED,
        OffsetQuickReturn { side: Sense::Behind, ..Default::default() },
        only,
        ONE_GROUP
    );
}

fn groups_of_two_guides<T: Real>() {
    use tables::single_groups::{CROSSED_GUIDES, OBLIQUE_YOKE};
    follow!(T, CROSSED_GUIDES, CrossedGuides { ..Default::default() }, only, ONE_GROUP);
    follow!(T, OBLIQUE_YOKE, ObliqueYoke { ..Default::default() }, only, ONE_GROUP);
}

fn drivers<T: Real>() {
    use tables::drivers::{GANTRY, GEARED_FIVE_BAR, POLAR_ARM, RACK_AND_PINION};
    follow!(T, GANTRY, Gantry { ..Default::default() }, all::<T, 2>, ONE_GROUP);
    follow!(T, POLAR_ARM, PolarArm { ..Default::default() }, all::<T, 2>, ONE_GROUP);
    follow!(T, GEARED_FIVE_BAR, GearedFiveBar { ..Default::default() }, only, ONE_GROUP);
    follow!(T, RACK_AND_PINION, RackAndPinion { ..Default::default() }, only, ONE_GROUP);
}

fn dimensions_that_are_inputs<T: Real>() {
    use tables::drivers::{EXCAVATOR, SWINGING_GUIDE};
    follow!(T, EXCAVATOR, Excavator { ..Default::default() }, all::<T, 3>, SIX_GROUPS);
    follow!(T, SWINGING_GUIDE, SwingingGuide { ..Default::default() }, all::<T, 3>, ONE_GROUP);
}

fn variable_dimensions<T: Real>() {
    use tables::variable_dimensions::*;
    let pair = all::<T, 2>;
    follow!(T, VARIABLE_FOUR_BAR, VariableFourBar { ..Default::default() }, pair, ONE_GROUP);
    follow!(T, VARIABLE_BAR, VariableBar { ..Default::default() }, pair, ONE_GROUP);
    follow!(T, VARIABLE_CROSS, VariableCross { ..Default::default() }, pair, ONE_GROUP);
    follow!(T, VARIABLE_YOKE, VariableYoke { ..Default::default() }, pair, ONE_GROUP);
    follow!(T, VARIABLE_ROD, VariableRod { ..Default::default() }, pair, ONE_GROUP);
}

fn moving_bases<T: Real>() {
    use tables::moving_bases::MOVING_BASES;
    follow!(T, MOVING_BASES, MovingBases { ..Default::default() }, only, SIX_GROUPS);
    follow!(T, MOVING_BASES, CompensatedBases { ..Default::default() }, only, SIX_GROUPS);
}

fn published_systems<T: Real>() {
    use tables::flying_shear::FLYING_SHEAR;
    use tables::four_bar::FOUR_BAR;
    use tables::rpp_systems::{CRANK_RPP, SIX_BAR};
    follow!(T, FOUR_BAR, FourBar { ..Default::default() }, only, ONE_GROUP);
    follow!(T, CRANK_RPP, CrankRpp { ..Default::default() }, only, ONE_GROUP);
    follow!(T, SIX_BAR, SixBar { ..Default::default() }, only, ONE_GROUP);
    follow!(T, FLYING_SHEAR, FlyingShear { ..Default::default() }, only, ONE_GROUP);
}

in_both_widths! {
    coupler_four_bar
    inclined_slider_crank
    offset_quick_return
    groups_of_two_guides
    drivers
    dimensions_that_are_inputs
    variable_dimensions
    moving_bases
    published_systems
}
