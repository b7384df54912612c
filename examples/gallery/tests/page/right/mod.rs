//! Machines that were wrong, refused, or of which nobody was told enough, by their right numbers: in both widths, in printed C to
//! the bit, and on pages.

mod bar_rows;
mod cut_machines;
mod cut_rows;
mod in_c;
mod machines;
mod rows;
mod rubbing;
mod word_machines;
mod word_rows;
mod words;

use linkage_core::sketch::{Drawn, Page, Paged};
use linkage_core::{Record, Solver};

use super::numbers::{asked, compare, has_node};
use in_c::Printed;
use rows::Right;

/// Inputs of each machine at which C and Rust are compared.
const INPUTS: u32 = 200;

/// Newton's method has left 1e-14 of the size, which a sine of 1e-3 at a joint makes 1e-11.
const WITHIN: f64 = 1e-11;

/// Single precision leaves some tens of roundings of 6e-8, over a sine of a hundredth at a joint.
const WITHIN_NARROW: f64 = 5e-4;

/// The numbers of a pose, none where there is none.
type Pose = Option<Vec<f64>>;

fn pose<S: Solver>(solver: &S, number: fn(f64) -> S::Scalar, at: &[f64]) -> Pose
where
    f64: From<S::Scalar>,
{
    let pose = solver.position(S::input(|k| number(at[k]))).ok()?;
    Some(pose.into_array().as_ref().iter().map(|&x| x.into()).collect())
}

/// Asserts that a pose has the right numbers, within this share of the largest.
fn is_right(
    name: &str,
    labels: &[&str],
    pose: impl Fn(&[f64]) -> Pose,
    rows: &[Right],
    within: f64,
) {
    for (at, right) in rows {
        let found = pose(at).unwrap_or_else(|| panic!("{name} has no pose at {at:?}"));
        let size = right.iter().fold(0.0, |size: f64, (_, value)| size.max(value.abs()));
        for (label, value) in *right {
            let place = labels.iter().position(|own| own == label);
            let number = found[place.unwrap_or_else(|| panic!("{name}: {label} in {labels:?}"))];
            let is_right = (number - value).abs() <= within * size;
            assert!(is_right, "{name} at {at:?}: {label} is {number}, not {value}");
        }
    }
}

/// Inputs over these ends, all of them at once.
fn inputs(ends: &[[f64; 2]]) -> Vec<Vec<f64>> {
    // A share of the span that no simple ratio of lengths meets.
    let share =
        |step: u32, nth: usize| (f64::from(step) * 0.618_033_988_75 + 0.3 * nth as f64).fract();
    let at = |step| {
        (0..).zip(ends).map(|(nth, [from, to])| from + (to - from) * share(step, nth)).collect()
    };
    (0..INPUTS).map(at).collect()
}

/// A machine everywhere. Its inputs lie between these ends.
fn everywhere<W, N>(wide: W, narrow: N, rows: &[Right], ends: &'static [[f64; 2]])
where
    W: Paged + Drawn<Input = <W as Solver>::Input> + Solver<Scalar = f64> + 'static,
    <W as Solver>::Input: 'static,
    N: Solver<Scalar = f32>,
{
    let name = W::PLAN.name;
    let poses = (|at: &[f64]| pose(&wide, |x| x, at), |at: &[f64]| pose(&narrow, |x| x as f32, at));
    is_right(name, <<W as Solver>::Position as Record>::LABELS, poses.0, rows, WITHIN);
    is_right(name, <N::Position as Record>::LABELS, poses.1, rows, WITHIN_NARROW);
    let given: Vec<Vec<f64>> = rows.iter().map(|(at, _)| at.to_vec()).chain(inputs(ends)).collect();
    let printed = Printed { text: W::PAGE.text, name, has_params: !W::PAGE.params.is_empty() };
    let answers = [
        given.iter().map(|at| poses.0(at)).collect(),
        given.iter().map(|at| poses.1(at)).collect(),
    ];
    printed.places(&given, &answers);
    if has_node() {
        let pages = [(name, Page::of(&wide).to_html().expect("nothing is asked of it"))];
        compare(&asked(&pages, name, ends, |_| wide, |_, _, _| Vec::new()));
    }
}

/// A row a machine: its right numbers, and the ends of its inputs.
macro_rules! table {
    ($machines:ident, $rows:ident: $($name:ident by $right:ident in $ends:expr;)*) => {$(
        everywhere($machines::$name::new(), $machines::$name::<f32>::default(), $rows::$right, &$ends);
    )*};
}

#[test]
fn parallelograms_stay_such_everywhere() {
    table! { machines, rows:
        Wiper by WIPER in [[-9.0, 9.0]];
        WiperByDrive by WIPER in [[-9.0, 9.0]];
        Direct by DIRECT in [[-9.0, 9.0]];
        Square by SQUARE in [[-9.0, 9.0]];
    }
}

#[test]
fn drawings_that_were_refused_are_right_everywhere() {
    table! { machines, rows:
        Turning by TURNING in [[-9.0, 9.0]];
        Tiny by TINY in [[-4.0, 4.0]];
        Guided by GUIDED in [[-9.0, 9.0]];
        Frame by FRAME in [[-2.0, 2.0]];
        Yoke by YOKE in [[-9.0, 9.0]];
        Boom by BOOM in [[0.01, 0.06]];
        Law by LAW in [[-9.0, 9.0]];
    }
}

#[test]
fn names_and_places_given_twice_are_right_everywhere() {
    table! { machines, rows:
        Knee by KNEE in [[-3.2, 3.2]];
        KneeByHand by KNEE_BY_HAND in [[-3.2, 3.2]];
        ByCrank by BY_CRANK in [[-4.0, 4.0]];
        ByPoint by BY_POINT in [[-0.2, 0.1], [0.0, 0.3]];
        Triad by TRIAD in [[-1.0, 1.0]];
        Named by NAMED in [[0.4, 0.6]];
    }
}

#[test]
fn lengths_that_are_declared_are_right_everywhere() {
    table! { cut_machines, bar_rows:
        Bar by BAR in [[-4.0, 4.0]];
        LongerCrank by LONGER_CRANK in [[-4.0, 4.0]];
    }
}

#[test]
fn cuts_have_the_signs_of_the_drawing_everywhere() {
    table! { cut_machines, cut_rows:
        Bent by BENT in [[-4.0, 4.0]];
        Cylinder by CYLINDER in [[1.9, 2.6]];
        Deck by DECK in [[0.3, 1.2]];
        Geared by GEARED in [[0.7, 1.1]];
        HeldArms by HELD_ARMS in [[-0.2, 0.9]];
        HeldPlate by HELD_PLATE in [[-1.5, -0.3]];
        OffsetBlock by OFFSET_BLOCK in [[0.4, 1.4]];
        OffsetRam by OFFSET_RAM in [[1.6, 2.4]];
        Stephenson by STEPHENSON in [[0.3, 1.3]];
        TurnedBack by TURNED_BACK in [[-4.0, 4.0]];
        TwoInputs by TWO_INPUTS in [[0.7, 1.4], [0.7, 1.3]];
        TwoLengths by TWO_LENGTHS in [[-4.0, 4.0]];
        Whitworth by WHITWORTH in [[1.0, 2.2]];
    }
}
