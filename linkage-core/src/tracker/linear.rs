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

/// The value at `at` of the polynomial through the values at the nodes (Lagrange's form), if each
/// of them has a value.
pub(super) fn interpolate<T: Scalar, R: Linear<T>, const N: usize>(
    nodes: [f64; N],
    value: impl Fn(f64) -> Option<R>,
    at: f64,
) -> Option<R> {
    let weight = |node: f64| -> f64 {
        let others = nodes.iter().filter(|other| **other != node);
        others.map(|other| (at - other) / (node - other)).product()
    };
    // The weights add up to one: the first value's share is what the others leave.
    let mut nodes = nodes.iter();
    let first = value(*nodes.next()?)?;
    nodes.try_fold(first, |sum, &node| {
        let weight = weight(node);
        Some(sum.plus(T::lit(weight, weight as f32), value(node)?.minus(first)))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Point;

    #[test]
    fn a_polynomial_of_lower_degree_is_reproduced() {
        let cubic = |x: f64| Point { x: 1.0 - x + 0.5 * x * x * x, y: x * x };
        let nodes = [-2.5, -1.0, 0.5, 1.0, 2.0];
        let found: Point<f64> = interpolate(nodes, |x| Some(cubic(x)), 0.25).unwrap();
        // Five terms below 10, each right to a few roundings.
        assert!((found.x - cubic(0.25).x).abs() < 1e-14, "{found:?}");
        assert!((found.y - cubic(0.25).y).abs() < 1e-14, "{found:?}");
    }

    #[test]
    fn a_node_without_a_value_leaves_none() {
        let found = interpolate([0.0, 1.0], |x| (x < 0.5).then_some(x), 0.25);
        assert!(found.is_none());
    }
}
