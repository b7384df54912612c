//! Kinematic coefficients, the derivatives of the outputs with respect to the inputs.
//!
//! Times the rates they are the velocity. They are held against the tabulated velocities with the
//! tables' own conditions: twenty operations of half ε for each inner joint on the way.

mod accuracy;
mod data {
    pub(crate) mod drivers;
    pub(crate) mod moving_bases;
    pub(crate) mod single_groups;
    pub(crate) mod truth;
}
mod mechanisms {
    pub(crate) mod drivers;
    pub(crate) mod moving_bases;
    pub(crate) mod single_groups;
}

use accuracy::{all, only, roundings, widened};
use linkage_core::{Real, Sense, Side};
use mechanisms::{drivers::*, moving_bases::*, single_groups::*};

/// The tabulated velocities, found again as coefficients times rates.
macro_rules! times_rates {
    ($t:ty, $table:expr, $mechanism:ident $fields:tt, $read:expr, $allowed:expr) => {{
        let mechanism = $mechanism::<$t> $fields;
        let counts = roundings::<$t>(&$table, &$mechanism::OUTPUTS, |row| {
            let slopes = mechanism.coefficients($read(row.input)).unwrap();
            let pose = mechanism.position($read(row.input)).unwrap();
            let rates = slopes.map(|slopes| {
                slopes.iter().zip(row.rate).map(|(c, rate)| c.value() * rate).sum::<f64>()
            });
            // There are no accelerations to check: the table's own.
            let seconds = $mechanism::OUTPUTS.map(|name| {
                let place = $table.outputs.iter().position(|output| *output == name).unwrap();
                row.acceleration[place].0
            });
            [widened(pose.rows()), rates.to_vec(), seconds.to_vec()]
        });
        println!("{}: {:.2} roundings", stringify!($mechanism), counts[1]);
        assert!(counts[1] <= $allowed, "{}: {counts:?}", stringify!($mechanism));
    }};
}

fn of_single_groups<T: Real>() {
    use data::single_groups::*;
    times_rates!(T, COUPLER_FOUR_BAR, CouplerFourBar { ..Default::default() }, only, 20.0);
    times_rates!(
        T,
        COUPLER_FOUR_BAR_FLIPPED,
        CouplerFourBar { elbow: Side::Right, ..Default::default() },
        only,
        20.0
    );
    times_rates!(
        T,
        INCLINED_SLIDER_CRANK,
        InclinedSliderCrank { ..Default::default() },
        only,
        20.0
    );
    times_rates!(
        T,
        OFFSET_QUICK_RETURN_FLIPPED,
        OffsetQuickReturn { side: Sense::Behind, ..Default::default() },
        only,
        20.0
    );
    times_rates!(T, CROSSED_GUIDES, CrossedGuides { ..Default::default() }, only, 20.0);
    times_rates!(T, OBLIQUE_YOKE, ObliqueYoke { ..Default::default() }, only, 20.0);
}

fn of_drivers<T: Real>() {
    use data::drivers::*;
    times_rates!(T, GANTRY, Gantry { ..Default::default() }, all::<T, 2>, 20.0);
    times_rates!(T, POLAR_ARM, PolarArm { ..Default::default() }, all::<T, 2>, 20.0);
    times_rates!(T, GEARED_FIVE_BAR, GearedFiveBar { ..Default::default() }, only, 20.0);
    times_rates!(T, RACK_AND_PINION, RackAndPinion { ..Default::default() }, only, 20.0);
    times_rates!(T, EXCAVATOR, Excavator { ..Default::default() }, all::<T, 3>, 120.0);
    times_rates!(T, SWINGING_GUIDE, SwingingGuide { ..Default::default() }, all::<T, 3>, 20.0);
}

fn of_moving_bases<T: Real>() {
    let table = data::moving_bases::MOVING_BASES;
    times_rates!(T, table, MovingBases { ..Default::default() }, only, 120.0);
}

macro_rules! in_both_widths {
    ($($test:ident)+) => {
        mod double {
            $(#[test] fn $test() { super::$test::<f64>(); })+
        }
        mod single {
            $(#[test] fn $test() { super::$test::<f32>(); })+
        }
    };
}

in_both_widths! { of_single_groups of_drivers of_moving_bases }

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
