//! Motion of which some inputs are prescribed and the others follow from forces.

use core::array::from_fn;

use crate::limit::ROUNDINGS;
use crate::{Real, SolveError};

/// One input of a motion: its acceleration is prescribed, or the effort of its drive is given.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Given<T = f64> {
    /// The acceleration, in m/s² or rad/s²; the drive follows.
    Acceleration(T),
    /// The effort of the drive, in N or N·m; the acceleration follows.
    Drive(T),
}

/// Accelerations and drives of all inputs, those that were given among them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mixed<T, const N: usize> {
    /// In m/s² and rad/s², in the order of `INPUTS`.
    pub accelerations: [T; N],
    /// In N and N·m, in the order of `INPUTS`.
    pub drives: [T; N],
}

/// Rounding of a pivot in units of ε. A derivation stands at the equations of motion in the compiler, whose tests hold
/// this to it: five units of 16 ε for up to five inputs and thirty terms in each mass.
pub const ROUNDINGS_OF_A_PIVOT: f64 = 5.0 * ROUNDINGS;

/// M q̈ = force + drive with one of q̈ᵢ and driveᵢ given for each i. `names` are those of the inputs.
///
/// A prescribed row and its column become those of the unit matrix, and Mⱼᵢ q̈ᵢ goes to the right-hand side of every other row j:
/// the matrix stays positive definite, and L D Lᵀ needs no exchanges. A pivot that rounding alone could have made
/// is an input that moves no mass of its own, as in `forward_dynamics`; its size is the diagonal's here, so that a mass
/// that is itself a difference of large ones is not seen to be one.
///
/// # Errors
/// `Singular` with the input that moves nothing of its own, `NotFinite` with the one whose numbers are not finite.
#[inline]
pub fn mixed_dynamics<T: Real, const N: usize>(
    mass: [[T; N]; N],
    force: [T; N],
    given: [Given<T>; N],
    names: [&'static str; N],
) -> Result<Mixed<T, N>, SolveError> {
    let accelerations = accelerations(&mass, &force, &given, names)?;
    let drives = from_fn(|row| match given[row] {
        Given::Drive(drive) => drive,
        Given::Acceleration(_) => {
            let products = mass[row].iter().zip(accelerations).map(|(mass, rate)| *mass * rate);
            products.fold(-force[row], |sum, product| sum + product)
        }
    });
    for row in 0..N {
        if !(accelerations[row].is_finite() && drives[row].is_finite()) {
            return Err(SolveError::NotFinite { name: names[row] });
        }
    }
    Ok(Mixed { accelerations, drives })
}

/// A matrix, and the right-hand side of a system with it.
type Reduced<T, const N: usize> = ([[T; N]; N], [T; N]);

/// The equations of motion with prescribed rows and columns of the unit matrix.
fn reduced<T: Real, const N: usize>(
    mass: &[[T; N]; N],
    force: &[T; N],
    given: &[Given<T>; N],
) -> Reduced<T, N> {
    let right = from_fn(|row| match given[row] {
        Given::Acceleration(rate) => rate,
        Given::Drive(drive) => (0..N).fold(force[row] + drive, |sum, input| match given[input] {
            Given::Acceleration(rate) => sum - mass[row][input] * rate,
            Given::Drive(_) => sum,
        }),
    });
    let matrix = from_fn(|row| {
        from_fn(|column| match (given[row], given[column]) {
            (Given::Drive(_), Given::Drive(_)) => mass[row][column],
            _ => T::num(if row == column { 1.0 } else { 0.0 }),
        })
    });
    (matrix, right)
}

fn accelerations<T: Real, const N: usize>(
    mass: &[[T; N]; N],
    force: &[T; N],
    given: &[Given<T>; N],
    names: [&'static str; N],
) -> Result<[T; N], SolveError> {
    // Below the diagonal L, on it D.
    let (mut factors, mut right) = reduced(mass, force, given);
    let (mut sizes, mut free) = ([0.0; N], 0.0);
    for column in 0..N {
        let (mut pivot, mut size) = (factors[column][column], factors[column][column].value());
        for k in 0..column {
            let squared = factors[column][k] * factors[column][k];
            pivot = pivot - squared * factors[k][k];
            size += squared.value() * sizes[k];
        }
        if let Given::Drive(_) = given[column] {
            free += 1.0;
            sizes[column] = free * size;
            // No for a pivot that is no number, and `NotFinite` follows from it.
            if pivot.value() <= ROUNDINGS_OF_A_PIVOT * T::EPSILON * sizes[column] {
                return Err(SolveError::Singular { group: names[column] });
            }
        }
        factors[column][column] = pivot;
        for row in column + 1..N {
            let entry = (0..column).fold(factors[row][column], |entry, k| {
                entry - factors[row][k] * factors[column][k] * factors[k][k]
            });
            factors[row][column] = entry / pivot;
        }
    }
    for row in 0..N {
        for k in 0..row {
            right[row] = right[row] - factors[row][k] * right[k];
        }
    }
    let mut solution: [T; N] = from_fn(|row| right[row] / factors[row][row]);
    for row in (0..N).rev() {
        for k in row + 1..N {
            solution[row] = solution[row] - factors[k][row] * solution[k];
        }
    }
    Ok(solution)
}

#[cfg(test)]
mod tests {
    use super::*;

    const NAMES: [&str; 3] = ["a", "b", "c"];

    /// Where all are free, every pivot is 4 and every factor 1/2.
    const MASS: [[f64; 3]; 3] = [[4.0, 2.0, 2.0], [2.0, 5.0, 3.0], [2.0, 3.0, 6.0]];

    #[track_caller]
    fn close(found: [f64; 3], expected: [f64; 3]) {
        for (found, expected) in found.into_iter().zip(expected) {
            // Some ten roundings of numbers below 32.
            assert!((found - expected).abs() < 10.0 * 32.0 * f64::EPSILON, "{found} {expected}");
        }
    }

    #[test]
    fn a_told_second_rate_pushes_the_others() {
        let given = [Given::Drive(1.0), Given::Acceleration(3.0), Given::Drive(-5.0)];
        let found = mixed_dynamics(MASS, [0.5, 7.0, 0.25], given, NAMES).unwrap();
        // 4 a + 2 c = 1.5 − 6 and 2 a + 6 c = −4.75 − 9; the second drive is 2 a + 15 + 3 c − 7.
        close(found.accelerations, [0.025, 3.0, -2.3]);
        close(found.drives, [1.0, 1.15, -5.0]);
        assert_eq!((found.accelerations[1], found.drives[0], found.drives[2]), (3.0, 1.0, -5.0));
    }

    #[test]
    fn all_told_is_inverse_and_all_given_is_forward() {
        let [force, seconds] = [[0.5, 7.0, 0.25], [1.0, -2.0, 4.0]];
        let inverse = mixed_dynamics(MASS, force, seconds.map(Given::Acceleration), NAMES).unwrap();
        assert_eq!(inverse.accelerations, seconds);
        assert_eq!(inverse.drives, [7.5, -3.0, 19.75]);
        let forward = mixed_dynamics(MASS, force, inverse.drives.map(Given::Drive), NAMES).unwrap();
        close(forward.accelerations, seconds);
        assert_eq!(forward.drives, inverse.drives);
    }

    /// Two that move all mass alike: the second moves none of its own, unless the first is prescribed.
    #[test]
    fn an_input_that_moves_nothing_of_its_own_is_singular() {
        let alike = [[1.0, 1.0], [1.0, 1.0 + f64::EPSILON]];
        let found = |given| mixed_dynamics(alike, [0.0; 2], given, ["a", "b"]);
        let singular = Err(SolveError::Singular { group: "b" });
        assert_eq!(found([Given::Drive(1.0); 2]), singular);
        let prescribed = found([Given::Acceleration(2.0), Given::Drive(1.0)]).unwrap();
        assert!((prescribed.accelerations[1] + 1.0).abs() < 4.0 * f64::EPSILON);
        let none = mixed_dynamics([[0.0]], [0.0], [Given::Drive(1.0)], ["a"]);
        assert_eq!(none, Err(SolveError::Singular { group: "a" }));
        // Nobody asks for a mass where nothing follows from it.
        assert!(mixed_dynamics([[0.0]], [0.0], [Given::Acceleration(1.0)], ["a"]).is_ok());
    }

    #[test]
    fn what_is_no_number_is_named() {
        for bad in [f64::NAN, f64::INFINITY] {
            for given in [Given::Acceleration(bad), Given::Drive(bad)] {
                let given = [Given::Drive(0.0), given, Given::Drive(0.0)];
                let found = mixed_dynamics(MASS, [0.0; 3], given, NAMES);
                assert!(matches!(found, Err(SolveError::NotFinite { .. })), "{found:?}");
            }
            let mut mass = MASS;
            mass[1][1] = bad;
            let found = mixed_dynamics(mass, [0.0; 3], [Given::Drive(1.0); 3], NAMES);
            assert!(found.is_err(), "{found:?}");
        }
    }
}
