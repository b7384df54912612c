//! Friction in joints that do not turn, and smooth friction at rest: none, in both widths, in printed C to the bit, and on
//! pages. What presses in these joints is compared with a full matrix elsewhere.

use linkage_core::sketch::{Page, Paged};
use linkage_core::{Record, SolveError};

use super::super::numbers::{asked, compare, has_node};
use super::in_c::{Answers, Printed};
use super::{inputs, machines};

/// Asserts that each of these results is zero.
fn are_zero(name: &str, labels: &[&str], numbers: &[f64], zero: &[&str]) {
    for label in zero {
        let place = labels.iter().position(|own| own == label);
        let place = place.unwrap_or_else(|| panic!("{name}: {label} in {labels:?}"));
        assert_eq!(numbers[place], 0.0, "{name}: {label}");
    }
}

/// Forces in both widths, C and the page, with loads; at inputs, rates and accelerations between these ends.
macro_rules! rubbing {
    ($name:ident, $record:ident { $($zero:literal),* } in $ends:expr; [$($load:expr),*]) => {{
        let (wide, narrow) = (machines::$name::new(), machines::$name::<f32>::default());
        let (name, labels) = (stringify!($name), <machines::$record<f64> as Record>::LABELS);
        let given = inputs(&[$ends, [-9.0, 9.0], [-9.0, 9.0]]);
        let list = |forces: Result<Vec<f64>, SolveError>| {
            let numbers = forces.ok()?;
            are_zero(name, labels, &numbers, &[$($zero),*]);
            Some(numbers)
        };
        let of_wide = given.iter().map(|at| {
            let forces = wide.forces(at[0], at[1], at[2], $($load),*);
            list(forces.map(|forces| forces.into_array().to_vec()))
        });
        let of_narrow = given.iter().map(|at| {
            let [q, v, a] = [0, 1, 2].map(|k| at[k] as f32);
            let forces = narrow.forces(q, v, a, $($load),*);
            list(forces.map(|forces| forces.into_array().map(f64::from).to_vec()))
        });
        let answers: Answers = [of_wide.collect(), of_narrow.collect()];
        assert!(answers.iter().all(|of_width| of_width.iter().flatten().count() > 50), "{name}");
        let text = <machines::$name<f64> as Paged>::PAGE.text;
        let loads: Vec<String> = vec![$(format!("(real){:?}, ", $load)),*];
        Printed { text, name, has_params: false }.forces(&loads.concat(), &given, &answers);
        if has_node() {
            let pages = [(name, Page::of(&wide).to_html().expect("nothing is asked of it"))];
            compare(&asked(&pages, name, &[$ends], |_| wide, |solver, [q, v, a], _loads| {
                let forces = solver.forces(q, v, a $(, _loads[0] + 0.0 * $load)*);
                vec![("forces", forces.map(|forces| forces.into_array().into()))]
            }));
        }
    }};
}

/// Constants keep the coupler parallel between its change points, and the truss turns as one.
#[test]
fn joints_that_do_not_turn_do_not_rub_anywhere() {
    rubbing!(Still, StillForces { "block.P.friction", "losses" } in [0.1, 3.0]; [90.0]);
    rubbing!(Truss, TrussForces { "r.H.friction", "r.F.friction", "losses" } in [-3.1, 3.1]; []);
}

/// The limit of an ever slower motion is zero, in every entry point.
#[test]
fn smooth_friction_at_rest_is_none_anywhere() {
    rubbing!(Smooth, SmoothForces {} in [-1.0, 1.0]; []);
    let (wide, narrow) = (machines::Smooth::new(), machines::Smooth::<f32>::default());
    for x in [-0.5, 0.0, 0.5] {
        assert_eq!(wide.forces(x, 0.0, 0.0).unwrap().x.drive, 0.0);
        assert_eq!(wide.statics(x, 1.0).unwrap().x.drive, 0.0);
        assert_eq!(wide.holding(x).unwrap(), [0.0; 2]);
        assert_eq!(narrow.statics(x as f32, 1.0).unwrap().x.drive, 0.0);
        // In motion it is 0.1 of the weight, by a smooth sign.
        let (push, right) =
            (wide.forces(x, 0.1, 0.0).unwrap().x.drive, 0.1 * 3.0 * 9.81 / 1.01_f64.sqrt());
        assert!((push - right).abs() < 8.0 * f64::EPSILON * right, "{push}");
    }
}
