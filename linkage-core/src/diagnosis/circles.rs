//! Circles that have to meet.

use super::{
    Diagnosis, Square, behind_reach, is_certain, is_full_square, reached, restored,
    smallest_normal, width,
};
use crate::limit::{self, Reach};
use crate::{Real, Scalar, SolveError};

/// The value is (d² − (l₁ − l₂)²) ((l₁ + l₂)² − d²) / (4 l₁ l₂)² in squares of a unit: circles of radii l₁
/// and l₂ about points d = (dx, dy) apart meet. Operands dx, dy, l₁, l₂, the unit and the spread; then the
/// group.
///
/// The value is zero where the circles fail to meet by at most four units in the last place of the longest of the
/// three lengths. Where rounding could have changed its sign, that is decided without rounding, and the
/// value computed once more.
///
/// # Errors
/// `OutOfReach` by the distance that is missing, `Singular` where the centres coincide or where a
/// derivative is asked for at the limit, `NotFinite` where a number is not or where l₁ · l₂ is too small
/// to be divided by.
#[derive(Clone, Copy, Debug)]
pub struct ReachCircles<T>(pub [T; 6], pub &'static str);

impl<T: Real> ReachCircles<T> {
    /// The answer where rounding could have changed the sign, and the circles are not beyond reach.
    #[cold]
    #[inline(never)]
    fn decided(self, value: T, reach: Reach) -> Result<T, SolveError> {
        let Self([dx, dy, l1, l2, unit, _], group) = self;
        let (d, lengths) = ([dx.value(), dy.value()], [l1.value(), l2.value()]);
        let is_product_sound = 4.0 * lengths[0] * lengths[1] >= smallest_normal::<T>();
        if matches!(reach, Reach::Meets | Reach::AtLimit) && !is_product_sound {
            return Err(SolveError::NotFinite { name: group });
        }
        let value = match reach {
            Reach::Meets => {
                let unit = unit.value();
                restored(value, limit::height_product(d, lengths) * unit * unit)
            }
            _ => value,
        };
        reached(value, &[dx, dy, l1, l2], reach, group)
    }
}

impl<T: Scalar> Diagnosis<T> for ReachCircles<T> {
    #[inline(always)]
    fn diagnose(self, value: T) -> Result<T, SolveError>
    where
        T: Real,
    {
        let Self([dx, dy, l1, l2, _, spread], group) = self;
        if is_certain(value, spread) {
            return Ok(value);
        }
        let (d, lengths) = ([dx.value(), dy.value()], [l1.value(), l2.value()]);
        // The most frequent answer comes in registers.
        match limit::circles(d, lengths, width::<T>()) {
            Reach::Beyond(by) => Err(SolveError::OutOfReach { group, by }),
            reach => self.decided(value, reach),
        }
    }

    /// Against (l₁ + l₂)²/4l₁l₂ in squares of the unit: compensated values have no spread.
    #[inline(always)]
    fn behind(self, met: T::Mask, value: T) -> T::Mask {
        let [dx, dy, l1, l2, unit, _] = self.0;
        let (sum, half) = (l1 + l2, T::lit(0.5, 0.5) * unit);
        let scale = (sum * sum) * (half / l1 * (half / l2));
        behind_reach(met, value, scale, &[dx, dy, l1, l2])
    }
}

/// The value is (d² + l₁² − l₂²)/2d²: the share of the line between the centres at which the joint's foot
/// stands. Operands the value of [`ReachCircles`], dx, dy, l₁, l₂ and the spread; then the group.
///
/// Where [`ReachCircles`] decides without rounding on the height, so does this on the share; at the limit it
/// puts the joint at the bar's length from its centre.
#[derive(Clone, Copy, Debug)]
pub struct ShareOfCentres<T>(pub [T; 6], pub &'static str);

impl<T: Real> ShareOfCentres<T> {
    /// The share where rounding could have changed the height's sign.
    #[cold]
    #[inline(never)]
    fn decided(self, value: T) -> T {
        let [_, dx, dy, l1, l2, _] = self.0;
        let (d, lengths) = ([dx.value(), dy.value()], [l1.value(), l2.value()]);
        match limit::circles(d, lengths, width::<T>()) {
            Reach::Meets => restored(value, limit::foot(d, lengths)),
            Reach::AtLimit => restored(value, limit::foot_on_line(d, lengths)),
            Reach::Beyond(_) | Reach::Coincident | Reach::NotFinite => value,
        }
    }
}

impl<T: Scalar> Diagnosis<T> for ShareOfCentres<T> {
    #[inline(always)]
    fn diagnose(self, value: T) -> Result<T, SolveError>
    where
        T: Real,
    {
        Ok(if is_certain(self.0[0], self.0[5]) { value } else { self.decided(value) })
    }

    /// Nothing is refused here.
    #[inline(always)]
    fn behind(self, met: T::Mask, _: T) -> T::Mask {
        met
    }
}

/// The value is the square of a point's distance from the line through two joints l apart: there is a point
/// at the distances r₁ and r₂ from them. Operands l, r₁, r₂ and the spread; then the group. At the limit and
/// in doubt as for [`ReachCircles`].
///
/// # Errors
/// Those of [`ReachCircles`]; `NotFinite` where the square is below the number's normal range.
#[derive(Clone, Copy, Debug)]
pub struct ReachDistances<T>(pub [T; 4], pub &'static str);

impl<T: Scalar> Diagnosis<T> for ReachDistances<T> {
    #[cold]
    fn diagnose(self, value: T) -> Result<T, SolveError>
    where
        T: Real,
    {
        let Self([l, r1, r2, spread], group) = self;
        if is_certain(value, spread) {
            return Ok(value);
        }
        let (d, lengths) = ([l.value(), 0.0], [r1.value(), r2.value()]);
        let reach = limit::circles(d, lengths, width::<T>());
        let value = match reach {
            Reach::Meets => {
                let height = 2.0 * lengths[0] * (lengths[1] / d[0]);
                let product = limit::height_product(d, lengths);
                let square = product * height * height;
                if product > 0.0 && square < smallest_normal::<T>() {
                    return Err(SolveError::NotFinite { name: group });
                }
                restored(value, square)
            }
            _ => value,
        };
        reached(value, &[l, r1, r2], reach, group)
    }

    #[inline(always)]
    fn behind(self, met: T::Mask, value: T) -> T::Mask {
        let [l, r1, r2, spread] = self.0;
        behind_reach(met, value, spread, &[l, r1, r2])
    }
}

/// The value is a squared length between centres of circles: in the range in which a square carries full
/// precision. Operands dx, dy, l₁ and l₂ of the circles; then the group.
///
/// # Errors
/// As for [`Square`](super::Square); about one point, circles of different radii are `OutOfReach`.
#[derive(Clone, Copy, Debug)]
pub struct SquareOfCentres<T>(pub [T; 4], pub &'static str);

impl<T: Scalar> Diagnosis<T> for SquareOfCentres<T> {
    #[inline(always)]
    fn diagnose(self, value: T) -> Result<T, SolveError>
    where
        T: Real,
    {
        if is_full_square(value) { Ok(value) } else { self.refused(value) }
    }
}

impl<T: Real> SquareOfCentres<T> {
    /// The reason why a square is none of full precision.
    #[cold]
    #[inline(never)]
    fn refused(self, value: T) -> Result<T, SolveError> {
        let Self([dx, dy, l1, l2], group) = self;
        let refused = match Square(group).diagnose(value) {
            // [`ReachCircles`] tells whether the circles meet.
            Ok(value) => return Ok(value),
            Err(refused) => refused,
        };
        let (d, lengths) = ([dx.value(), dy.value()], [l1.value(), l2.value()]);
        match limit::circles(d, lengths, width::<T>()) {
            Reach::Beyond(by) => Err(SolveError::OutOfReach { group, by }),
            Reach::Coincident => Err(SolveError::Singular { group }),
            Reach::Meets | Reach::AtLimit | Reach::NotFinite => Err(refused),
        }
    }
}
