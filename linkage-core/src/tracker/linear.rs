//! Sums and differences of whole results and inputs, component by component.
//!
//! Only what interpolating between results takes: nothing here knows what a component means, so
//! an interpolated direction is a unit vector only as far as the interpolation is right.

use crate::{Real, Record, Scalar};

/// Arithmetic with records of numbers `T`.
pub(super) trait Linear<T>: Copy {
    /// `self` + `factor` · `other`.
    #[must_use]
    fn plus(self, factor: T, other: Self) -> Self;

    /// `self` − `other`.
    #[must_use]
    fn minus(self, other: Self) -> Self;

    /// True if every number passes the test.
    #[must_use]
    fn all(self, test: impl Fn(T) -> bool) -> bool;
}

impl<T: Scalar, R: Record<Number = T> + Copy> Linear<T> for R {
    #[inline]
    fn plus(self, factor: T, other: Self) -> Self {
        with(self, other, |one, other| one + factor * other)
    }

    #[inline]
    fn minus(self, other: Self) -> Self {
        with(self, other, |one, other| one - other)
    }

    #[inline]
    fn all(self, test: impl Fn(T) -> bool) -> bool {
        self.into_array().into_iter().all(test)
    }
}

/// The record of what is made of each pair of numbers.
#[inline]
fn with<R: Record>(one: R, other: R, make: impl Fn(R::Number, R::Number) -> R::Number) -> R
where
    R::Number: Copy,
{
    let (mut numbers, other) = (one.into_array(), other.into_array());
    for (number, other) in numbers.as_mut().iter_mut().zip(other) {
        *number = make(*number, other);
    }
    R::from_array(numbers)
}

/// A result by a polynomial, and how far it may be off.
#[derive(Clone, Copy, Debug)]
pub(super) struct Estimate<R> {
    pub(super) result: R,
    /// The distance from the result of the polynomial without the last two nodes.
    pub(super) change: R,
}

impl<R> Estimate<R> {
    /// The same with each number that is better in `other`, and whether there is one: its change is less
    /// than a sixteenth there. Through nodes half as far from each other a polynomial changes by a
    /// thousandth, and rounding is eight times as large; less than a sixteenth is no accident of
    /// rounding.
    pub(super) fn better<T: Real>(self, other: Self) -> (Self, bool)
    where
        R: Record<Number = T> + Copy,
    {
        let [mut result, mut change] = [self.result, self.change].map(R::into_array);
        let others = [other.result, other.change].map(R::into_array);
        let mut is_better = false;
        let numbers = result.as_mut().iter_mut().zip(change.as_mut());
        let others = others[0].as_ref().iter().zip(others[1].as_ref());
        for ((result, change), (other, its_change)) in numbers.zip(others) {
            if 16.0 * its_change.value().abs() < change.value().abs() {
                (*result, *change, is_better) = (*other, *its_change, true);
            }
        }
        let [result, change] = [result, change].map(R::from_array);
        (Self { result, change }, is_better)
    }
}

/// The value at `at` of the polynomial through the values at the nodes (Lagrange's form); none
/// without nodes.
///
/// # Errors
/// The first of a value.
pub(super) fn interpolate<T: Scalar, R: Linear<T>, E>(
    nodes: &[f64],
    value: impl Fn(f64) -> Result<R, E>,
    at: f64,
) -> Result<Option<Estimate<R>>, E> {
    let weight = |nodes: &[f64], node: f64| -> f64 {
        let others = nodes.iter().filter(|other| **other != node);
        others.map(|other| (at - other) / (node - other)).product()
    };
    let number = |weight: f64| T::lit(weight, weight as f32);
    let fewer = nodes.get(..nodes.len().saturating_sub(2)).unwrap_or_default();
    // The weights add up to one: the first value's share is what the others leave.
    let Some(first_node) = nodes.first() else { return Ok(None) };
    let first = value(*first_node)?;
    let start = Estimate { result: first, change: first.minus(first) };
    let add = |sum: Estimate<R>, (place, &node): (usize, &f64)| {
        let more = value(node)?.minus(first);
        let full = weight(nodes, node);
        let change = if place < fewer.len() { full - weight(fewer, node) } else { full };
        Ok(Estimate {
            result: sum.result.plus(number(full), more),
            change: sum.change.plus(number(change), more),
        })
    };
    nodes.iter().enumerate().skip(1).try_fold(start, add).map(Some)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[derive(Clone, Copy, Debug)]
    struct Point {
        x: f64,
        y: f64,
    }

    impl Record for Point {
        type Number = f64;
        type Array = [f64; 2];

        const LABELS: &'static [&'static str] = &["x", "y"];

        fn into_array(self) -> [f64; 2] {
            [self.x, self.y]
        }

        fn from_array([x, y]: [f64; 2]) -> Self {
            Self { x, y }
        }
    }

    #[test]
    fn a_polynomial_of_lower_degree_is_reproduced() {
        let cubic = |x: f64| Point { x: 1.0 - x + 0.5 * x * x * x, y: x * x };
        let nodes = [-2.5, -1.0, 0.5, 1.0, 2.0];
        let found = interpolate(&nodes, |x| Ok::<_, ()>(cubic(x)), 0.25).unwrap().unwrap();
        let (result, change) = (found.result, found.change);
        // Five terms below 10, each right to a few roundings.
        assert!((result.x - cubic(0.25).x).abs() < 1e-14, "{found:?}");
        assert!((result.y - cubic(0.25).y).abs() < 1e-14, "{found:?}");
        // Through the first three nodes y is the same, and x is off by x³/2's share.
        let missing = 0.5 * (0.25 + 2.5) * (0.25 + 1.0) * (0.25 - 0.5);
        assert!((change.x - missing).abs() < 1e-14 && change.y.abs() < 1e-14, "{found:?}");
    }

    #[test]
    fn a_node_without_a_value_leaves_none() {
        let found = interpolate(&[0.0, 1.0], |x| if x < 0.5 { Ok(x) } else { Err(x) }, 0.25);
        assert_eq!(found.map(|_| ()), Err(1.0));
    }

    #[test]
    fn of_two_estimates_each_number_is_the_one_that_changes_less() {
        let of = |x, y, off_x, off_y| Estimate {
            result: Point { x, y },
            change: Point { x: off_x, y: off_y },
        };
        let (both, is_better) = of(1.0, 2.0, 0.1, -0.1).better(of(3.0, 4.0, -0.01, 0.005));
        assert_eq!([both.result.x, both.result.y], [1.0, 4.0]);
        assert_eq!([both.change.x, both.change.y], [0.1, 0.005]);
        assert!(is_better);
        assert!(!both.better(of(5.0, 6.0, 0.01, -0.005)).1);
    }
}
