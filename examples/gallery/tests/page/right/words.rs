//! Ratios of rates, poles and transmission angles: their right numbers, with motions to the bit in printed C and on pages.

use linkage_core::sketch::Paged;
use linkage_core::{Record, Solver};

use super::in_c::Printed;
use super::word_machines::{ByTravel, EqualBars, Groups, Rear};
use super::{INPUTS, Pose, everywhere, inputs, word_rows};

/// The numbers of a motion at an input, its rate and its acceleration.
fn motion<S: Solver>(solver: &S, number: fn(f64) -> S::Scalar, at: &[f64]) -> Pose
where
    f64: From<S::Scalar>,
{
    let [q, rate, acceleration] = [0, 1, 2].map(|k| S::input(|_| number(at[k])));
    let motion = solver.motion(q, rate, acceleration).ok()?;
    Some(motion.into_array().as_ref().iter().map(|&x| x.into()).collect())
}

/// Motions in printed C, in both widths. At least so many are answered.
fn moves_in_c<W, N>(wide: W, narrow: N, ends: [f64; 2], least: usize)
where
    W: Paged + Solver<Scalar = f64>,
    N: Solver<Scalar = f32>,
{
    let given = inputs(&[ends, [-9.0, 9.0], [-9.0, 9.0]]);
    let of_wide: Vec<Pose> = given.iter().map(|at| motion(&wide, |x| x, at)).collect();
    let of_narrow: Vec<Pose> = given.iter().map(|at| motion(&narrow, |x| x as f32, at)).collect();
    for answers in [&of_wide, &of_narrow] {
        assert!(answers.iter().flatten().count() >= least, "{}", W::PLAN.name);
    }
    let (text, has_params) = (W::PAGE.text, !W::PAGE.params.is_empty());
    Printed { text, name: W::PLAN.name, has_params }.motions(&given, &[of_wide, of_narrow]);
}

#[test]
fn ratios_poles_and_transmissions_are_right_everywhere() {
    macro_rules! table {
        ($($name:ident by $right:ident in $ends:expr, answered $least:literal;)*) => {$(
            everywhere($name::new(), $name::<f32>::default(), word_rows::$right, &[$ends]);
            moves_in_c($name::new(), $name::<f32>::default(), $ends, $least);
        )*};
    }
    table! {
        Rear by REAR in [2.5, 3.6], answered 150;
        Groups by GROUPS in [-9.0, 9.0], answered 200;
        ByTravel by BY_TRAVEL in [0.0, 0.5], answered 100;
    }
}

/// At half of the angles bars of equal length are a parallelogram, and the others an antiparallelogram.
#[test]
fn a_coupler_that_does_not_turn_has_no_pole_anywhere() {
    let ends: &[[f64; 2]] = &[[-3.1, 3.1]];
    everywhere(EqualBars::new(), EqualBars::<f32>::default(), &[], ends);
    moves_in_c(EqualBars::new(), EqualBars::<f32>::default(), ends[0], 80);
    let mut answered = [[0; 2]; 2];
    let given = inputs(ends);
    for at in &given {
        let in_front = usize::from(at[0] < 0.0);
        answered[in_front][0] += u32::from(EqualBars::new().position(at[0]).is_ok());
        answered[in_front][1] +=
            u32::from(EqualBars::<f32>::default().position(at[0] as f32).is_ok());
    }
    // Next to the change points rounding turns the coupler by more than the guard grants, and the pole is far away.
    let [parallel, crossed] = answered;
    let all = given.iter().filter(|at| at[0] < 0.0).count() as u32;
    assert!(crossed.iter().all(|count| 10 * count >= 9 * all), "{crossed:?} of {all}");
    assert!(parallel.iter().all(|count| 4 * count <= INPUTS - all), "{parallel:?}");
}
