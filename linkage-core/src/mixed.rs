//! Motion of which some inputs are told and the others follow from forces.

use core::array::from_fn;

use crate::{Real, SolveError};

/// One input of a motion: its second rate is told, or the effort of its drive is given.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Given<T = f64> {
    /// The second rate, in m/s² or rad/s²; the drive follows.
    SecondRate(T),
    /// The effort of the drive, in N or N·m; the second rate follows.
    Drive(T),
}

/// Second rates and drives of all inputs, those that were given among them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mixed<T, const N: usize> {
    /// In m/s² and rad/s², in the order of `INPUTS`.
    pub second_rates: [T; N],
    /// In N and N·m, in the order of `INPUTS`.
    pub drives: [T; N],
}

/// Rounding of a pivot in units of 16 ε. A derivation stands at the equations of motion in the compiler; it gives five of
/// them for up to five inputs and some thirty terms in each mass.
const SHARE: f64 = 5.0 * 16.0;

/// M q̈ = force + drive with one of q̈ᵢ and driveᵢ given for each i. `names` are those of the inputs.
///
/// A told row and its column become those of the unit matrix, and Mⱼᵢ q̈ᵢ goes to the right-hand side of every other row j:
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
    let second_rates = second_rates(&mass, &force, &given, names)?;
    let drives = from_fn(|row| match given[row] {
        Given::Drive(drive) => drive,
        Given::SecondRate(_) => {
            let products = mass[row].iter().zip(second_rates).map(|(mass, rate)| *mass * rate);
            products.fold(-force[row], |sum, product| sum + product)
        }
    });
    for row in 0..N {
        if !(second_rates[row].is_finite() && drives[row].is_finite()) {
            return Err(SolveError::NotFinite { name: names[row] });
        }
    }
    Ok(Mixed { second_rates, drives })
}

/// A matrix, and the right-hand side of a system with it.
type Reduced<T, const N: usize> = ([[T; N]; N], [T; N]);

/// The equations of motion with told rows and columns of the unit matrix.
fn reduced<T: Real, const N: usize>(
    mass: &[[T; N]; N],
    force: &[T; N],
    given: &[Given<T>; N],
) -> Reduced<T, N> {
    let right = from_fn(|row| match given[row] {
        Given::SecondRate(rate) => rate,
        Given::Drive(drive) => (0..N).fold(force[row] + drive, |sum, input| match given[input] {
            Given::SecondRate(rate) => sum - mass[row][input] * rate,
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

fn second_rates<T: Real, const N: usize>(
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
            if pivot.value() <= SHARE * T::EPSILON * sizes[column] {
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

    /// Rows of a mass matrix by hand: pivots 2, 3/2 and 4/3 where all are free.
    const MASS: [[f64; 3]; 3] = [[2.0, 1.0, 0.0], [1.0, 2.0, 1.0], [0.0, 1.0, 2.0]];

    #[test]
    fn a_told_second_rate_pushes_the_others() {
        let given = [Given::Drive(1.0), Given::SecondRate(3.0), Given::Drive(-5.0)];
        let found = mixed_dynamics(MASS, [0.5, 7.0, 0.25], given, NAMES).unwrap();
        // 2 a = 1.5 − 3, 2 c = −4.75 − 3, and the second row's drive is a + 2·3 + c − 7.
        assert_eq!(found.second_rates, [-0.75, 3.0, -3.875]);
        assert_eq!(found.drives, [1.0, -0.75 + 6.0 - 3.875 - 7.0, -5.0]);
    }

    #[test]
    fn all_told_is_inverse_and_all_given_is_forward() {
        let [force, seconds] = [[0.5, 7.0, 0.25], [1.0, -2.0, 4.0]];
        let inverse = mixed_dynamics(MASS, force, seconds.map(Given::SecondRate), NAMES).unwrap();
        assert_eq!(inverse.second_rates, seconds);
        assert_eq!(inverse.drives, [-0.5, 1.0 - 7.0, 5.75]);
        let forward = mixed_dynamics(MASS, force, inverse.drives.map(Given::Drive), NAMES).unwrap();
        for (found, expected) in forward.second_rates.into_iter().zip(seconds) {
            // Three pivots of one and more.
            assert!((found - expected).abs() < 16.0 * f64::EPSILON * 4.0, "{found} {expected}");
        }
        assert_eq!(forward.drives, inverse.drives);
    }

    /// Two that move all mass alike: the second moves none of its own, unless the first is told.
    #[test]
    fn an_input_that_moves_nothing_of_its_own_is_singular() {
        let alike = [[1.0, 1.0], [1.0, 1.0 + f64::EPSILON]];
        let found = |given| mixed_dynamics(alike, [0.0; 2], given, ["a", "b"]);
        let singular = Err(SolveError::Singular { group: "b" });
        assert_eq!(found([Given::Drive(1.0); 2]), singular);
        let told = found([Given::SecondRate(2.0), Given::Drive(1.0)]).unwrap();
        assert!((told.second_rates[1] + 1.0).abs() < 4.0 * f64::EPSILON);
        let none = mixed_dynamics([[0.0]], [0.0], [Given::Drive(1.0)], ["a"]);
        assert_eq!(none, Err(SolveError::Singular { group: "a" }));
        // Nobody asks for a mass where nothing follows from it.
        assert!(mixed_dynamics([[0.0]], [0.0], [Given::SecondRate(1.0)], ["a"]).is_ok());
    }

    #[test]
    fn what_is_no_number_is_named() {
        for bad in [f64::NAN, f64::INFINITY] {
            for given in [Given::SecondRate(bad), Given::Drive(bad)] {
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
