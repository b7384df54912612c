//! Size and place do not matter: a mechanism is the same mechanism at any scale and anywhere, and
//! where squares of its lengths leave the range of the width it says so.

use linkage_core::{Real, SolveError};
use linkage_tests::mechanisms::driven_groups::*;
use linkage_tests::random::Random;
use linkage_tests::widths::{list, number};

/// Position, velocity and acceleration, each row by its name.
type Rows = Vec<(&'static str, [f64; 3])>;

/// One pose of a group with its lengths `size` times as large, and its joints `away` from the
/// origin.
type Solve = fn(&mut Random, f64, [f64; 2]) -> Result<Rows, SolveError>;

macro_rules! rows {
    ($group:ident, $solver:expr, $inputs:expr, $($angle:literal)*) => {{
        |random: &mut Random, size: f64, away: [f64; 2]| -> Result<Rows, SolveError> {
            const ANGLES: &[usize] = &[$($angle),*];
            let scale = |i: usize| if ANGLES.contains(&i) { 1.0 } else { size };
            let solver: $group<T> = $solver(random, size);
            let q = $inputs(random).map(f64::from);
            // Coordinates come first, x and y in turn, and the angles among them stand alone.
            let place = |i: usize| {
                let before = ANGLES.iter().filter(|angle| **angle < i).count();
                if ANGLES.contains(&i) { 0.0 } else { away[(i - before) % 2] }
            };
            let q = core::array::from_fn(|i| q[i] * scale(i) + place(i));
            let mut rates = || core::array::from_fn(|i| random.between(-1.0, 1.0) * scale(i));
            let (rate, second) = (rates(), rates());
            let m = solver.motion(list(q), list(rate), list(second))?;
            let orders = [m.position.rows(), m.velocity.rows(), m.acceleration.rows()];
            let names = $group::<f64>::OUTPUTS.iter().enumerate();
            Ok(names.map(|(row, name)| (*name, orders.map(|rows| rows[row].value()))).collect())
        }
    }};
}

/// Every group, at poses well inside its limits.
fn groups<T: Real>() -> [Solve; 5] {
    [
        rows!(
            DrivenRrr,
            |random: &mut Random, size| DrivenRrr {
                l1: number(size * random.between(1.0, 2.0)),
                l2: number(size * random.between(1.0, 2.0)),
                ..Default::default()
            },
            |random: &mut Random| [0.25, -0.5, 1.5, random.between(-1.0, 1.0) as f32],
        ),
        rows!(
            DrivenRrp,
            |random: &mut Random, size| DrivenRrp {
                l: number(size * random.between(2.0, 3.0)),
                e: number(size * random.between(-0.5, 0.5)),
                ..Default::default()
            },
            |random: &mut Random| [0.25, -0.5, 0.5, -0.25, random.between(-3.0, 3.0) as f32],
            4
        ),
        rows!(
            DrivenRpr,
            |random: &mut Random, size| DrivenRpr {
                e: number(size * random.between(-0.5, 0.5)),
                ..Default::default()
            },
            |random: &mut Random| [1.25, -0.5, random.between(-0.5, 0.5) as f32, 0.75],
        ),
        rows!(
            DrivenPrp,
            |random: &mut Random, size| DrivenPrp {
                e1: number(size * random.between(-0.5, 0.5)),
                e2: number(size * random.between(-0.5, 0.5)),
            },
            |random: &mut Random| {
                [0.25, -0.5, 0.5, 1.25, random.between(-0.5, 0.5) as f32, 1.75]
            },
            2 5
        ),
        rows!(
            DrivenRpp,
            |random: &mut Random, size| DrivenRpp {
                slot: number(random.between(0.5, 2.0)),
                e1: number(size * random.between(-0.5, 0.5)),
                e2: number(size * random.between(-0.5, 0.5)),
            },
            |random: &mut Random| [0.25, -0.5, 0.5, -0.25, random.between(-3.0, 3.0) as f32],
            4
        ),
    ]
}

const HERE: [f64; 2] = [0.0; 2];

/// A power of two scales every length exactly, so nothing but the lengths may change, and they by
/// that power: not the last place of an angle or of its rates.
fn powers_of_two<T: Real>(powers: core::ops::RangeInclusive<i32>) {
    for (group, solve) in groups::<T>().iter().enumerate() {
        for seed in 0..20 {
            let unit = solve(&mut Random::new(seed), 1.0, HERE).unwrap();
            for power in powers.clone().step_by(6) {
                let size = 2.0_f64.powi(power);
                let scaled = solve(&mut Random::new(seed), size, HERE).unwrap();
                for ((name, unit), (_, scaled)) in unit.iter().zip(&scaled) {
                    let is_length = !name.ends_with("angle");
                    let expected = unit.map(|x| if is_length { size * x } else { x });
                    assert_eq!(*scaled, expected, "group {group}, 2^{power}: {name}");
                }
            }
        }
    }
}

/// Coordinates that are moved exactly leave everything but the coordinates as it is.
fn far_away<T: Real>(away: f64) {
    for (group, solve) in groups::<T>().iter().enumerate() {
        // Inputs of five bits: moved by less than 1/16 ε they are still numbers of the width.
        for seed in 0..20 {
            let coarse = |place| solve(&mut Random::coarse(seed), 1.0, place);
            let (near, far) = (coarse(HERE).unwrap(), coarse([away, -away]).unwrap());
            for ((name, near), (_, far)) in near.iter().zip(&far) {
                let is_moved = name.ends_with(".x") || name.ends_with(".y");
                let from = usize::from(is_moved);
                assert_eq!(far[from..], near[from..], "group {group}: {name}");
                let shift = if name.ends_with(".x") { away } else { -away };
                let error = if is_moved { far[0] - shift - near[0] } else { 0.0 };
                assert!(error.abs() <= T::EPSILON * away, "group {group}: {name} {error:e}");
            }
        }
    }
}

/// Squares beyond the range, or so small that they are no squares any more.
fn out_of_range<T: Real>(sizes: [f64; 2]) {
    // Without a square, prp and rpp go on to the range of the lengths themselves.
    for (group, solve) in groups::<T>()[..3].iter().enumerate() {
        for size in sizes {
            let error = solve(&mut Random::new(1), size, HERE).unwrap_err();
            let is_typed =
                matches!(error, SolveError::NotFinite { .. } | SolveError::Singular { .. });
            assert!(is_typed, "group {group} at {size:e}: {error}");
        }
    }
}

mod double {
    #[test]
    fn powers_of_two() {
        super::powers_of_two::<f64>(-300..=300);
    }
    #[test]
    fn far_away() {
        super::far_away::<f64>(2.0_f64.powi(40));
    }
    #[test]
    fn out_of_range() {
        super::out_of_range::<f64>([1e-160, 1e160]);
    }
}

mod single {
    #[test]
    fn powers_of_two() {
        super::powers_of_two::<f32>(-36..=36);
    }
    #[test]
    fn far_away() {
        super::far_away::<f32>(2.0_f64.powi(16));
    }
    #[test]
    fn out_of_range() {
        super::out_of_range::<f32>([1e-22, 1e22]);
    }
}
