//! The arguments, results and refusals of the generated functions.

use linkage_core::num_dual::DualSVec;
use linkage_core::{SolveError, differentiate};
use linkage_tests::mechanisms::forces::*;

#[test]
fn labels_follow_the_fields() {
    assert_eq!(Press::LOADS, ["work", "friction"]);
    assert_eq!(
        HeavySixBar::FORCES,
        [
            "block.B.x",
            "block.B.y",
            "block.rod.normal",
            "block.rod.couple",
            "rod.D.x",
            "rod.D.y",
            "AB.drive"
        ]
    );
    assert_eq!(DrivenFourBar::FORCES, ["theta.drive"]);
    assert!(Press::FORCES.contains(&"ram.way.normal") && Press::FORCES.contains(&"AB.B.y"));
}

#[test]
fn several_loads_are_named_or_an_array() {
    let press = Press::new();
    let named = PressLoads { work: 500.0, friction: 2.0 };
    assert_eq!(press.forces(0.4, 2.0, 1.0, named), press.forces(0.4, 2.0, 1.0, [500.0, 2.0]));
}

#[test]
fn a_cosine_and_a_sine_do_as_well_as_the_angle() {
    let four_bar = HeavyFourBar::new();
    let (sin, cos) = 0.7_f64.sin_cos();
    let by_angle = four_bar.forces(0.7, 3.0, -2.0).unwrap();
    let by_circle = four_bar.forces_at(cos, sin, 3.0, -2.0).unwrap();
    assert!((by_angle.theta.drive - by_circle.theta.drive).abs() < 1e-15);
    let (rest, rest_at) = (four_bar.statics(0.7).unwrap(), four_bar.statics_at(cos, sin).unwrap());
    assert!((rest.DC.D.y - rest_at.DC.D.y).abs() < 1e-15);
}

#[test]
fn a_load_that_is_no_number_is_named() {
    let press = Press::new();
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let refused = press.forces(0.4, 2.0, 1.0, [bad, 0.0]);
        assert_eq!(refused, Err(SolveError::NotFinite { name: "work" }));
        let refused = press.statics(0.4, [0.0, bad]);
        assert_eq!(refused, Err(SolveError::NotFinite { name: "friction" }));
        let (_, usable) = press.solve_statics(0.4, [bad, 0.0]);
        assert!(!usable);
    }
    let lift = Lift::new();
    let refused = lift.statics([1.1, 0.4], f64::NAN);
    assert_eq!(refused, Err(SolveError::NotFinite { name: "cargo" }));
    let refused = lift.forces([1.1, 0.4], [0.0, f64::NAN], [0.0, 0.0], 1.0);
    assert!(matches!(refused, Err(SolveError::NotFinite { .. })), "{refused:?}");
}

#[test]
fn a_result_beyond_the_numbers_is_refused() {
    let four_bar = HeavyFourBar::new();
    let refused = four_bar.forces(0.4, 1e200, 0.0);
    assert!(matches!(refused, Err(SolveError::NotFinite { .. })), "{refused:?}");
}

#[test]
fn a_negative_mass_is_refused_and_none_is_fine() {
    let press = Press::new();
    let without = Press { counterweight: 0.0, ..press }.forces(0.4, 2.0, 1.0, [0.0; 2]).unwrap();
    let with = press.forces(0.4, 2.0, 1.0, [0.0; 2]).unwrap();
    assert!((without.AB.A.y - with.AB.A.y).abs() > 1.0);
    let refused = Press { counterweight: -1e-9, ..press }.forces(0.4, 2.0, 1.0, [0.0; 2]);
    let expected = SolveError::Invalid { group: "AB", name: "mass on AB" };
    assert_eq!(refused, Err(expected));
    assert_eq!(expected.to_string(), "AB: `mass on AB` must not be negative");
    let refused = Press { counterweight: f64::NAN, ..press }.statics(0.4, [0.0; 2]);
    assert!(matches!(refused, Err(SolveError::NotFinite { .. })), "{refused:?}");
}

#[test]
fn a_pose_out_of_reach_has_no_forces() {
    let press = Press { r: 0.7, ..Press::new() };
    assert!(press.statics(0.0, [1.0; 2]).is_err());
}

#[test]
fn single_precision_says_the_same() {
    let (wide, narrow) = (HeavyFourBar::new(), HeavyFourBar::<f32>::default());
    for step in 0..60 {
        let theta = 0.1 * f64::from(step);
        let expected = wide.forces(f64::from(theta as f32), 3.0, -2.0).unwrap();
        let found = narrow.forces(theta as f32, 3.0, -2.0).unwrap();
        // A hundred roundings of forces of about two newtons, a few times enlarged.
        let apart = f64::from(found.BC.C.x) - expected.BC.C.x;
        assert!(apart.abs() < 1e-4, "{theta}: {apart}");
        let apart = f64::from(found.theta.drive) - expected.theta.drive;
        assert!(apart.abs() < 1e-4, "{theta}: {apart}");
    }
}

#[test]
fn a_drive_is_differentiated_by_a_dimension() {
    let press = Press::new();
    let (theta, rate, acceleration, loads) = (0.7, 3.0, -2.0, [250.0, 1.0]);
    let exact = differentiate([press.r, press.counterweight], |[r, counterweight]| {
        let at = |x: f64| DualSVec::from_re(x);
        let dual = Press { r, counterweight };
        let f = dual.forces(at(theta), at(rate), at(acceleration), loads.map(at))?;
        Ok([f.theta.drive, f.BC.C.x])
    })
    .unwrap();
    let rows = |press: Press| {
        let f = press.forces(theta, rate, acceleration, loads).unwrap();
        [f.theta.drive, f.BC.C.x]
    };
    let h = 1e-6;
    for (column, (up, down)) in [
        (Press { r: press.r + h, ..press }, Press { r: press.r - h, ..press }),
        (
            Press { counterweight: press.counterweight + h, ..press },
            Press { counterweight: press.counterweight - h, ..press },
        ),
    ]
    .into_iter()
    .enumerate()
    {
        let (up, down) = (rows(up), rows(down));
        for row in 0..2 {
            let difference = (up[row] - down[row]) / (2.0 * h);
            // Forces of some 1e2: 1e-14·1e2/h of rounding, and h² times a third derivative.
            let apart = (exact[(row, column)] - difference).abs();
            assert!(apart < 1e-4 * difference.abs().max(1.0), "{row} {column}: {apart}");
        }
    }
}

#[test]
fn costs_are_stated() {
    let (alone, all) = (DrivenFourBar::COST.forces.total(), HeavyFourBar::COST.forces.total());
    assert!(alone > 0 && alone < all, "{alone} {all}");
    assert!(HeavyFourBar::COST.statics.total() < all);
    assert!(HeavyFourBar::COST.to_string().contains("; forces: "));
}
