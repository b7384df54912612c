//! The plain values a solver returns: points, directions, slides and their rates.
//!
//! Every type is a `Copy` record with public fields, of `f64` unless another number is named. What
//! can be computed from a record on request, such as the angle of a direction, is a method; nothing
//! else is. The layouts are C's, as the header of `export c;` declares them.

use crate::{Real, Scalar};

/// A point in ground axes, its velocity or its acceleration: metres, m/s or m/s².
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[repr(C)]
pub struct Point<T = f64> {
    /// The component along ground x.
    pub x: T,
    /// The component along ground y.
    pub y: T,
}

/// A force in ground axes, in newtons. Its docs name what it acts on.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[repr(C)]
pub struct Force<T = f64> {
    /// The component along ground x.
    pub x: T,
    /// The component along ground y.
    pub y: T,
}

/// The load that a guide exerts on the link that slides on it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[repr(C)]
pub struct GuideForce<T = f64> {
    /// The force in newtons at the origin of the link's frame, along the guide's normal, which is
    /// 90° counter-clockwise of its direction.
    pub normal: T,
    /// The couple in N·m, counter-clockwise positive.
    pub couple: T,
}

/// The load that the inertia of all masses puts on the ground, without weight and applied forces.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[repr(C)]
pub struct Shaking<T = f64> {
    /// The force along ground x in newtons.
    pub x: T,
    /// The force along ground y in newtons.
    pub y: T,
    /// The couple about the ground's origin in N·m, counter-clockwise positive.
    pub couple: T,
}

/// The unit vector along a link's x axis, in ground axes.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[repr(C)]
pub struct Direction<T = f64> {
    /// The cosine of the link's angle.
    pub cos: T,
    /// The sine of the link's angle.
    pub sin: T,
}

/// The direction of a link that slides, and how far it has slid.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[repr(C)]
pub struct SlidingDirection<T = f64> {
    /// The cosine of the link's angle.
    pub cos: T,
    /// The sine of the link's angle.
    pub sin: T,
    /// The distance along the guide, positive along its direction, in metres.
    pub slide: T,
}

/// The slide of a link that does not turn, or its velocity or acceleration: metres, m/s or m/s².
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[repr(C)]
pub struct Slide<T = f64> {
    /// The distance along the guide, positive along its direction.
    pub slide: T,
}

/// The angular velocity of a link.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[repr(C)]
pub struct AngularVelocity<T = f64> {
    /// In rad/s, counter-clockwise positive.
    pub omega: T,
}

/// The angular velocity of a link that slides, and the rate of its slide.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[repr(C)]
pub struct SlidingVelocity<T = f64> {
    /// In rad/s, counter-clockwise positive.
    pub omega: T,
    /// In m/s, positive along the guide's direction.
    pub slide: T,
}

/// The angular acceleration of a link.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[repr(C)]
pub struct AngularAcceleration<T = f64> {
    /// In rad/s², counter-clockwise positive.
    pub alpha: T,
}

/// The angular acceleration of a link that slides, and the acceleration of its slide.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[repr(C)]
pub struct SlidingAcceleration<T = f64> {
    /// In rad/s², counter-clockwise positive.
    pub alpha: T,
    /// In m/s², positive along the guide's direction.
    pub slide: T,
}

impl<T> From<SlidingDirection<T>> for Direction<T> {
    #[inline]
    fn from(sliding: SlidingDirection<T>) -> Self {
        Self { cos: sliding.cos, sin: sliding.sin }
    }
}

impl<T: Scalar> Force<T> {
    /// The magnitude in newtons: one square root, computed when called.
    #[inline]
    #[must_use]
    pub fn magnitude(self) -> T {
        self.x.hypot(self.y)
    }
}

impl<T: Scalar> Direction<T> {
    /// The angle from ground +x, counter-clockwise positive, in (−π, π].
    ///
    /// One arc tangent, computed when called.
    #[inline]
    #[must_use]
    pub fn angle(self) -> T {
        self.sin.atan2(self.cos)
    }

    /// The angle of this direction against the `other`, counter-clockwise positive, in (−π, π].
    ///
    /// From the cross and the dot product of the two directions rather than from a difference of
    /// two angles, which would jump by 2π.
    #[inline]
    #[must_use]
    pub fn angle_from(self, other: impl Into<Self>) -> T {
        let other = other.into();
        let sin = T::det(self.sin, other.cos, self.cos, other.sin);
        let cos = T::det(self.cos, other.cos, -self.sin, other.sin);
        sin.atan2(cos)
    }
}

impl<T: Real> Direction<T> {
    /// The angle nearest `previous` among all angles, 2π apart, of this direction.
    ///
    /// Feeding each answer back as the next `previous` unrolls the angle of a turning link, as
    /// long as it turns less than half a turn between the two. A `previous` that is not finite
    /// gives an angle that is not finite.
    #[inline]
    #[must_use]
    pub fn angle_near(self, previous: T) -> T {
        turned_near(self.angle(), previous.value())
    }
}

impl<T: Scalar> SlidingDirection<T> {
    /// See [`Direction::angle`].
    #[inline]
    #[must_use]
    pub fn angle(self) -> T {
        Direction::from(self).angle()
    }

    /// See [`Direction::angle_from`].
    #[inline]
    #[must_use]
    pub fn angle_from(self, other: impl Into<Direction<T>>) -> T {
        Direction::from(self).angle_from(other)
    }
}

impl<T: Real> SlidingDirection<T> {
    /// See [`Direction::angle_near`].
    #[inline]
    #[must_use]
    pub fn angle_near(self, previous: T) -> T {
        Direction::from(self).angle_near(previous)
    }
}

/// The angle nearest `previous` among all that are turns away from this one.
#[inline]
pub(crate) fn turned_near<T: Real>(angle: T, previous: f64) -> T {
    let turns = nearest_integer((previous - angle.value()) / core::f64::consts::TAU);
    let unroll = turns * core::f64::consts::TAU;
    angle + T::lit(unroll, unroll as f32)
}

/// The integer nearest `x`, ties to even. `f64::round` needs the standard library.
fn nearest_integer(x: f64) -> f64 {
    // At 1.5·2⁵² the spacing of f64 is one, so that adding it rounds x to an integer, which the
    // subtraction leaves exact; from 2⁵¹ on the fraction's bits are beyond what an angle can tell.
    const SHIFT: f64 = 6_755_399_441_055_744.0;
    if x.abs() < 2_251_799_813_685_248.0 { (x + SHIFT) - SHIFT } else { x }
}

#[cfg(test)]
mod tests {
    use super::*;
    use core::f64::consts::{FRAC_PI_2, PI, TAU};

    fn direction(angle: f64) -> Direction<f64> {
        let (sin, cos) = angle.sin_cos();
        Direction { cos, sin }
    }

    #[test]
    fn half_a_turn_is_plus_pi_whatever_the_sign_of_zero() {
        assert_eq!(Direction { cos: -1.0, sin: 0.0 }.angle(), PI);
        assert_eq!(Direction { cos: -1.0, sin: -0.0 }.angle(), PI);
        assert_eq!(Direction { cos: -1.0_f32, sin: -0.0 }.angle(), core::f32::consts::PI);
    }

    #[test]
    fn an_angle_follows_the_previous_one_over_many_turns() {
        // Each step adds the rounding of one angle of up to 200 rad: half a spacing, 2^-46.
        let mut previous = 0.0;
        for step in 0..1000 {
            let angle = 0.2 * f64::from(step);
            previous = direction(angle).angle_near(previous);
            assert!((previous - angle).abs() < 1e-13, "{previous} {angle}");
        }
        assert_eq!(previous.round(), 200.0);
        let backwards = direction(3.0).angle_near(-TAU);
        assert!((backwards - (3.0 - TAU)).abs() < 1e-15);
        assert!(direction(3.0).angle_near(f64::NAN).is_nan());
    }

    #[test]
    fn a_relative_angle_does_not_jump_where_the_absolute_ones_do() {
        let (a, b) = (direction(PI - 0.1), direction(-PI + 0.1));
        // Four products and an arc tangent: a few 2^-53.
        assert!((a.angle_from(b) - -0.2).abs() < 1e-15);
        assert!((b.angle_from(a) - 0.2).abs() < 1e-15);
        let block = SlidingDirection { cos: 0.0, sin: 1.0, slide: 2.0 };
        assert_eq!(block.angle_from(Direction { cos: 1.0, sin: 0.0 }), FRAC_PI_2);
        assert_eq!(Direction { cos: 1.0, sin: 0.0 }.angle_from(block), -FRAC_PI_2);
    }
}
