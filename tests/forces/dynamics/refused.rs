//! Where there are no accelerations: dead points, inputs that move nothing, numbers that are none.

use std::f64::consts::{FRAC_PI_2, PI};

use linkage_core::SolveError;
use linkage_tests::mechanisms::dynamics::{
    GearedArm, LightCrank, RockerDriven, Squeezer, Twin, Twins,
};
use linkage_tests::mechanisms::forces::{HeavyFourBar, Oscillator, Press, SprungLift};

#[test]
fn a_dead_point_of_the_input_is_singular() {
    let machine = RockerDriven::new();
    // Coupler and crank in line: the pose is there, its rates are not.
    assert!(machine.position(FRAC_PI_2).is_ok());
    let dead = SolveError::Singular { group: "BC, DC" };
    assert_eq!(machine.velocity(FRAC_PI_2, 1.0), Err(dead));
    assert_eq!(machine.forward_dynamics(FRAC_PI_2, 0.0, 1.0), Err(dead));
    assert_eq!(machine.forward_dynamics(FRAC_PI_2, 2.0, 0.0), Err(dead));
    assert_eq!(machine.equations_of_motion(FRAC_PI_2, 0.0), Err(dead));
    assert_eq!(machine.state_rates([FRAC_PI_2, 1.0], 0.0), Err(dead));
    let (_, usable) = machine.solve_forward_dynamics(FRAC_PI_2, 1.0, 0.0);
    assert!(!usable);
    assert_eq!(dead.to_string(), "BC, DC: undefined in this pose, at a limit or a dead point");
    // Beyond it there is no pose.
    let beyond = machine.forward_dynamics(FRAC_PI_2 + 1e-9, 0.0, 1.0);
    assert!(matches!(beyond, Err(SolveError::OutOfReach { group: "BC, DC", .. })), "{beyond:?}");
}

#[test]
fn next_to_a_dead_point_the_mass_grows_as_the_square_of_the_coefficients() {
    let machine = RockerDriven::new();
    let at = |apart: f64| {
        let (mass, rate) = (
            machine.equations_of_motion(FRAC_PI_2 - apart, 0.0).unwrap().mass[0][0],
            machine.velocity(FRAC_PI_2 - apart, 1.0).unwrap().BC.omega,
        );
        (mass, rate * rate)
    };
    // The coefficients grow as one over the root of what is left to the limit.
    let [(mass, square), (near_mass, near_square)] = [at(1e-4), at(1e-8)];
    assert!((near_mass / mass - 1e4).abs() < 200.0, "{mass} {near_mass}");
    assert!((near_square / square - 1e4).abs() < 200.0, "{square} {near_square}");
    // The given drive is recovered to the digits that the pose has left: 1e-8 of the angle is known to eight
    // digits.
    let ddq = machine.forward_dynamics(FRAC_PI_2 - 1e-8, 0.0, 3.0).unwrap();
    let drive = machine.forces(FRAC_PI_2 - 1e-8, 0.0, ddq).unwrap().rocker.drive;
    assert!((drive - 3.0).abs() < 1e-7, "{drive}");
}

#[test]
fn an_input_that_moves_no_mass_is_singular_by_its_name() {
    let light = LightCrank::new();
    assert!(light.forward_dynamics(0.5, 1.0, 0.1).is_ok());
    // At the dead centre the crank moves without the piston.
    let dead = SolveError::Singular { group: "theta" };
    assert_eq!(light.forward_dynamics(0.0, 1.0, 0.1), Err(dead));
    // The equations themselves are there, with a mass of zero.
    assert_eq!(light.equations_of_motion(0.0, 1.0).unwrap().mass, [[0.0]]);
    let heavy = LightCrank { flywheel: 0.25 };
    let found = heavy.forward_dynamics(0.0, 0.0, 0.5).unwrap();
    assert_eq!(found, 2.0);
}

#[test]
fn what_is_no_number_is_named() {
    let refused = HeavyFourBar::new().forward_dynamics(1.0, f64::NAN, 0.0);
    assert!(matches!(refused, Err(SolveError::NotFinite { .. })), "{refused:?}");
    let refused = HeavyFourBar::new().forward_dynamics(1.0, 0.0, f64::INFINITY);
    assert_eq!(refused, Err(SolveError::NotFinite { name: "drive of theta" }));
    let lift = SprungLift::new();
    let refused = lift.forward_dynamics([0.9, 0.4], [0.0; 2], [0.0, f64::NAN]);
    assert_eq!(refused, Err(SolveError::NotFinite { name: "drive of tilt" }));
    let press = Press { counterweight: 0.0, ..Press::new() };
    assert!(press.forward_dynamics(0.3, 1.0, 0.0, [0.0; 2]).is_ok());
    let refused = Press { counterweight: -1.0, ..press }.forward_dynamics(0.3, 1.0, 0.0, [0.0; 2]);
    assert_eq!(refused, Err(SolveError::Invalid { group: "AB", name: "mass on AB" }));
    let refused = press.forward_dynamics(0.3, 1.0, 0.0, [f64::NAN, 0.0]);
    assert_eq!(refused, Err(SolveError::NotFinite { name: "work" }));
}

#[test]
fn single_precision_and_loads() {
    let free = Oscillator { c: 2.0, ..Oscillator::new() };
    let found = free.forward_dynamics(0.5, 0.25, 1.0, 3.0).unwrap();
    assert!((found - (1.0 + 3.0 - 7.5 - 0.5) / 1.6632).abs() < 1e-15, "{found}");
    let narrow = Oscillator::<f32>::default().forward_dynamics(0.5, 0.0, 0.0, 0.0).unwrap();
    assert!((narrow + 7.5 / 1.6632).abs() < 1e-6);
    let (wide, narrow) = (HeavyFourBar::new(), HeavyFourBar::<f32>::default());
    for step in 0..60 {
        let q = (0.1 * f64::from(step)) as f32;
        let expected = wide.forward_dynamics(q.into(), 3.0, 0.25).unwrap();
        let found = f64::from(narrow.forward_dynamics(q, 3.0, 0.25).unwrap());
        // A hundred roundings, a few times enlarged, of terms of up to some hundred 1/s².
        assert!((found - expected).abs() < 1e-3, "{q}: {found} {expected}");
    }
}

/// Where two groups are the assemblies of one triangle, the first is named, as it is where they do not
/// share what they compute; and the second where nobody asks for the first.
#[test]
fn the_first_of_two_groups_on_one_triangle_is_named() {
    let (twins, twin) = (Twins::new(), Twin::new());
    let beyond = |refused, expected: &str| match refused {
        Err(SolveError::OutOfReach { group, by }) => {
            assert_eq!(group, expected);
            assert!((by - 0.5).abs() < 1e-15, "{by}");
        }
        other => panic!("{other:?}"),
    };
    beyond(twins.position(PI).map(|_| 0.0), "K4, K5");
    beyond(twins.forward_dynamics(PI, 1.0, 0.0), "K4, K5");
    beyond(twin.position(PI).map(|_| 0.0), "K4, K5");
    beyond(twin.forward_dynamics(PI, 1.0, 0.0), "K6, K7");
    let cost = [Twins::COST.forward_dynamics, Twins::COST.motion];
    assert_eq!(cost.map(|cost| cost.roots), [1, 2]);
}

/// The published state at 30 ms (Test Set for IVP Solvers, from 30 digits of a 40-digit extrapolation).
#[test]
fn the_squeezer_accelerates_as_published() {
    let (beta, rate) = (15.810_771_195_153_707, 1_139.920_302_259_106);
    let found = Squeezer::new().forward_dynamics(beta, rate, 0.033).unwrap();
    // The angle's last place alone is worth 4e-12 of it.
    let expected = -24_631.763_122_874_634;
    assert!((found - expected).abs() < 2e-11 * expected.abs(), "{found} {expected}");
}

/// A rate that is not finite is refused even where no acceleration depends on it: the answer holds the rates.
#[test]
fn state_rates_of_rates_that_are_no_numbers_are_refused() {
    let arm = GearedArm::new();
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        // Where the cart stands and how fast it goes changes no force.
        let state = [0.1, 0.2, 0.3, bad, 0.0, 0.0];
        assert!(arm.forward_dynamics([0.1, 0.2, 0.3], [bad, 0.0, 0.0], [0.0; 3]).is_ok());
        let refused = Err(SolveError::NotFinite { name: "base_rate" });
        assert_eq!(arm.state_rates(state, [0.0; 3]), refused);
        let narrow = GearedArm::<f32>::default();
        let state = state.map(|number: f64| number as f32);
        assert_eq!(narrow.state_rates(state, [0.0; 3]).map(|_| ()), refused.map(|_: [f64; 6]| ()));
    }
}
