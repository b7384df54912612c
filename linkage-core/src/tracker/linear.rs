//! Sums and differences of whole results and inputs, component by component.
//!
//! Only what interpolating between results takes: nothing here knows what a component means, so
//! an interpolated direction is a unit vector only as far as the interpolation is right.

use crate::{
    AngularAcceleration, AngularVelocity, Direction, Point, Scalar, Slide, SlidingAcceleration,
    SlidingDirection, SlidingVelocity,
};

/// A record of numbers `T`.
pub trait Linear<T>: Copy {
    /// `self` + `factor` · `other`.
    #[must_use]
    fn plus(self, factor: T, other: Self) -> Self;

    /// `self` − `other`.
    #[must_use]
    fn minus(self, other: Self) -> Self;

    /// Whether every number passes the test.
    #[must_use]
    fn all(self, test: impl Fn(T) -> bool + Copy) -> bool;
}

impl<T: Scalar> Linear<T> for T {
    #[inline]
    fn plus(self, factor: T, other: Self) -> Self {
        self + factor * other
    }
    #[inline]
    fn minus(self, other: Self) -> Self {
        self - other
    }
    #[inline]
    fn all(self, test: impl Fn(T) -> bool + Copy) -> bool {
        test(self)
    }
}

macro_rules! linear {
    ($($record:ident { $($field:ident)* })*) => {$(
        impl<T: Scalar> Linear<T> for $record<T> {
            #[inline]
            fn plus(self, factor: T, other: Self) -> Self {
                Self { $($field: self.$field + factor * other.$field),* }
            }
            #[inline]
            fn minus(self, other: Self) -> Self {
                Self { $($field: self.$field - other.$field),* }
            }
            #[inline]
            fn all(self, test: impl Fn(T) -> bool + Copy) -> bool {
                $(test(self.$field))&&*
            }
        }
    )*};
}

linear! {
    Point { x y }
    Direction { cos sin }
    SlidingDirection { cos sin slide }
    Slide { slide }
    AngularVelocity { omega }
    SlidingVelocity { omega slide }
    AngularAcceleration { alpha }
    SlidingAcceleration { alpha slide }
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
    use crate::Point;

    #[test]
    fn a_polynomial_of_lower_degree_is_reproduced() {
        let cubic = |x: f64| Point { x: 1.0 - x + 0.5 * x * x * x, y: x * x };
        let nodes = [-2.5, -1.0, 0.5, 1.0, 2.0];
        let found: Point<f64> =
            interpolate(nodes, |x| Ok::<_, ()>(cubic(x)), 0.25).unwrap().unwrap();
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
