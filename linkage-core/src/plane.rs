//! Operations on points and directions: arithmetic, lengths, conversions, text.
//!
//! The records themselves stand in `results`; conversions to other crates' types, each behind its
//! feature, in `conversions`.

use core::fmt;
use core::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

use crate::{Direction, Point, Scalar, SlidingDirection};

impl<T> Point<T> {
    /// The point or vector with these components.
    #[inline]
    #[must_use]
    pub const fn new(x: T, y: T) -> Self {
        Self { x, y }
    }
}

impl<T: Scalar> Point<T> {
    /// The length of the vector from the origin, √(x² + y²): a speed where this is a velocity.
    #[inline]
    #[must_use]
    pub fn norm(self) -> T {
        self.x.hypot(self.y)
    }

    /// The distance from the `other` point, in metres.
    #[inline]
    #[must_use]
    pub fn distance(self, other: Self) -> T {
        (self - other).norm()
    }

    /// The dot product, x·x' + y·y'.
    #[inline]
    #[must_use]
    pub fn dot(self, other: Self) -> T {
        T::det(self.x, other.x, -self.y, other.y)
    }

    /// The cross product, x·y' − y·x': positive where the `other` vector is counter-clockwise of
    /// this one.
    #[inline]
    #[must_use]
    pub fn cross(self, other: Self) -> T {
        T::det(self.x, other.y, self.y, other.x)
    }

    /// The vector turned by 90° counter-clockwise.
    #[inline]
    #[must_use]
    pub fn perpendicular(self) -> Self {
        Self { x: -self.y, y: self.x }
    }
}

impl<T: Scalar> Direction<T> {
    /// The direction at this angle from ground +x, in radians, counter-clockwise positive.
    #[inline]
    #[must_use]
    pub fn from_angle(angle: T) -> Self {
        let (sin, cos) = angle.sin_cos();
        Self { cos, sin }
    }

    /// The unit vector as a point: of the link's x axis.
    #[inline]
    #[must_use]
    pub fn vector(self) -> Point<T> {
        Point { x: self.cos, y: self.sin }
    }

    /// The direction turned by 90° counter-clockwise: that of the link's y axis.
    #[inline]
    #[must_use]
    pub fn perpendicular(self) -> Self {
        Self { cos: -self.sin, sin: self.cos }
    }

    /// The ground components of a vector that is given in the axes of a link of this direction.
    #[inline]
    #[must_use]
    pub fn rotate(self, vector: Point<T>) -> Point<T> {
        Point {
            x: T::det(self.cos, vector.x, self.sin, vector.y),
            y: T::det(self.sin, vector.x, -self.cos, vector.y),
        }
    }
}

/// +x, the direction of ground.
impl<T: Scalar> Default for Direction<T> {
    #[inline]
    fn default() -> Self {
        Self { cos: T::lit(1.0, 1.0), sin: T::lit(0.0, 0.0) }
    }
}

/// +x, and no slide.
impl<T: Scalar> Default for SlidingDirection<T> {
    #[inline]
    fn default() -> Self {
        let Direction { cos, sin } = Direction::default();
        Self { cos, sin, slide: T::lit(0.0, 0.0) }
    }
}

impl<T: Add<Output = T>> Add for Point<T> {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self { x: self.x + other.x, y: self.y + other.y }
    }
}

impl<T: Sub<Output = T>> Sub for Point<T> {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        Self { x: self.x - other.x, y: self.y - other.y }
    }
}

impl<T: AddAssign> AddAssign for Point<T> {
    #[inline]
    fn add_assign(&mut self, other: Self) {
        self.x += other.x;
        self.y += other.y;
    }
}

impl<T: SubAssign> SubAssign for Point<T> {
    #[inline]
    fn sub_assign(&mut self, other: Self) {
        self.x -= other.x;
        self.y -= other.y;
    }
}

impl<T: Neg<Output = T>> Neg for Point<T> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self { x: -self.x, y: -self.y }
    }
}

impl<T: Mul<Output = T> + Copy> Mul<T> for Point<T> {
    type Output = Self;
    #[inline]
    fn mul(self, factor: T) -> Self {
        Self { x: self.x * factor, y: self.y * factor }
    }
}

impl<T: Div<Output = T> + Copy> Div<T> for Point<T> {
    type Output = Self;
    #[inline]
    fn div(self, divisor: T) -> Self {
        Self { x: self.x / divisor, y: self.y / divisor }
    }
}

/// The vector of this length along the direction.
impl<T: Mul<Output = T> + Copy> Mul<T> for Direction<T> {
    type Output = Point<T>;
    #[inline]
    fn mul(self, length: T) -> Point<T> {
        Point { x: self.cos * length, y: self.sin * length }
    }
}

/// The opposite direction.
impl<T: Neg<Output = T>> Neg for Direction<T> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self { cos: -self.cos, sin: -self.sin }
    }
}

/// The conversions of a record of two fields from and to arrays and pairs.
macro_rules! of_two {
    ($(#[$doc:meta])* $record:ident { $first:ident, $second:ident }) => {
        $(#[$doc])*
        impl<T> From<[T; 2]> for $record<T> {
            #[inline]
            fn from([$first, $second]: [T; 2]) -> Self {
                Self { $first, $second }
            }
        }

        $(#[$doc])*
        impl<T> From<(T, T)> for $record<T> {
            #[inline]
            fn from(($first, $second): (T, T)) -> Self {
                Self { $first, $second }
            }
        }

        impl<T> From<$record<T>> for [T; 2] {
            #[inline]
            fn from(record: $record<T>) -> Self {
                [record.$first, record.$second]
            }
        }

        impl<T> From<$record<T>> for (T, T) {
            #[inline]
            fn from(record: $record<T>) -> Self {
                (record.$first, record.$second)
            }
        }
    };
}

of_two! { Point { x, y } }
of_two! {
    /// The cosine and the sine of one angle, in this order; that they are is not checked.
    Direction { cos, sin }
}

/// `(0.25, -0.1)`; a precision is that of both components.
impl<T: fmt::Display> fmt::Display for Point<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("(")?;
        self.x.fmt(f)?;
        f.write_str(", ")?;
        self.y.fmt(f)?;
        f.write_str(")")
    }
}

/// The angle in degrees, `-12.5°`; a precision is that of the degrees.
impl<T: crate::Real> fmt::Display for Direction<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.angle().value().to_degrees().fmt(f)?;
        f.write_str("°")
    }
}

/// The angle in degrees and the slide in metres, `-12.5°, 0.2`.
impl<T: crate::Real + fmt::Display> fmt::Display for SlidingDirection<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        Direction::from(*self).fmt(f)?;
        f.write_str(", ")?;
        fmt::Display::fmt(&self.slide, f)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use core::f64::consts::{FRAC_PI_2, FRAC_PI_6};
    use std::string::ToString;

    #[test]
    fn points_are_vectors() {
        let (a, b) = (Point::new(3.0, 4.0), Point::from((1.0, -2.0)));
        assert_eq!((a + b, a - b, -a), ([4.0, 2.0].into(), [2.0, 6.0].into(), [-3.0, -4.0].into()));
        assert_eq!((a * 2.0, a / 2.0), (Point::new(6.0, 8.0), Point::new(1.5, 2.0)));
        assert_eq!((a.norm(), a.distance(Point::default())), (5.0, 5.0));
        assert_eq!((a.dot(b), a.cross(b), b.cross(a)), (-5.0, -10.0, 10.0));
        assert_eq!(a.perpendicular(), Point::new(-4.0, 3.0));
        let mut sum = a;
        sum += b;
        sum -= a;
        assert_eq!(sum, b);
        assert_eq!((<[f64; 2]>::from(a), <(f64, f64)>::from(a)), ([3.0, 4.0], (3.0, 4.0)));
    }

    #[test]
    fn a_direction_turns_vectors_of_its_link_into_the_ground() {
        let up = Direction::<f64>::from_angle(FRAC_PI_2);
        let turned = up.rotate(Point::new(2.0, 1.0));
        // The cosine of the rounded right angle is 6e-17, and two products are rounded.
        assert!(turned.distance(Point::new(-1.0, 2.0)) < 1e-15);
        assert_eq!(Direction::default().rotate(Point::new(2.0, 1.0)), Point::new(2.0, 1.0));
        assert_eq!((up * 3.0).y, 3.0);
        assert_eq!((-Direction::<f64>::default()).vector(), Point::new(-1.0, 0.0));
        assert_eq!(Direction::<f64>::default().perpendicular().vector(), Point::new(0.0, 1.0));
    }

    #[test]
    fn points_and_directions_are_text_of_the_wanted_precision() {
        assert_eq!(Point::new(0.25, -0.1).to_string(), "(0.25, -0.1)");
        assert_eq!(std::format!("{:.2}", Point::new(0.256, -0.1)), "(0.26, -0.10)");
        assert_eq!(std::format!("{:.1}", Direction::<f64>::from_angle(-FRAC_PI_6)), "-30.0°");
        let block = SlidingDirection { cos: 1.0, sin: 0.0, slide: 0.2 };
        assert_eq!(std::format!("{block:.1}"), "0.0°, 0.2");
    }
}
