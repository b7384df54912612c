//! Sums and differences of whole results and inputs, component by component.
//!
//! Only what interpolating between results takes: nothing here knows what a component means, so
//! an interpolated direction is a unit vector only as far as the interpolation is right.

use crate::{Record, Scalar};

/// Arithmetic with records of numbers `T`.
pub(super) trait Linear<T>: Copy {
    /// `self` + `factor` · `other`.
    #[must_use]
    fn plus(self, factor: T, other: Self) -> Self;

    /// `self` − `other`.
    #[must_use]
    fn minus(self, other: Self) -> Self;

    /// Whether every number passes the test.
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

/// The value at `at` of the polynomial through the values at the nodes (Lagrange's form); none
/// without nodes.
///
/// # Errors
/// The first of a value.
pub(super) fn interpolate<T: Scalar, R: Linear<T>, E, const N: usize>(
    nodes: [f64; N],
    value: impl Fn(f64) -> Result<R, E>,
    at: f64,
) -> Result<Option<R>, E> {
    let weight = |node: f64| -> f64 {
        let others = nodes.iter().filter(|other| **other != node);
        others.map(|other| (at - other) / (node - other)).product()
    };
    // The weights add up to one: the first value's share is what the others leave.
    let mut nodes = nodes.iter();
    let Some(first) = nodes.next() else { return Ok(None) };
    let first = value(*first)?;
    let sum = nodes.try_fold(first, |sum, &node| {
        let weight = weight(node);
        Ok(sum.plus(T::lit(weight, weight as f32), value(node)?.minus(first)))
    })?;
    Ok(Some(sum))
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
        let found = interpolate(nodes, |x| Ok::<_, ()>(cubic(x)), 0.25).unwrap().unwrap();
        // Five terms below 10, each right to a few roundings.
        assert!((found.x - cubic(0.25).x).abs() < 1e-14, "{found:?}");
        assert!((found.y - cubic(0.25).y).abs() < 1e-14, "{found:?}");
    }

    #[test]
    fn a_node_without_a_value_leaves_none() {
        let found = interpolate([0.0, 1.0], |x| if x < 0.5 { Ok(x) } else { Err(x) }, 0.25);
        assert_eq!(found, Err(1.0));
    }
}
