//! The number that a sweep runs generated code on: one lane, which may know its sine and cosine beforehand.

use core::ops::{Add, Div, Mul, Neg, Sub};

use crate::{Float, Fusion, LaneMask, Lanes, Scalar};

/// A number of one pose, and its sine and cosine if it was read from a sweep's first input. One lane, since
/// it is the loop over the poses that becomes one over vectors; a lane rather than a number, since its type
/// says whether products are fused.
///
/// The steps of one pose wait for each other: sine and cosine, division and root, and what is made of them.
/// A processor hides that by beginning with the next poses, as far as its window reaches, and one vector of
/// poses fills it. So a sweep takes the sines of a whole block in a loop of their own, short enough for
/// several vectors to be under way. Generated code is as ever: it asks an input for its sine, and the input
/// has it. Whether it does is known while compiling, and sines that no one asks for are computed by no one.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pose<T, F> {
    lane: Lanes<T, 1, F>,
    circle: Option<(Lanes<T, 1, F>, Lanes<T, 1, F>)>,
}

impl<T: Copy, F> Pose<T, F> {
    /// Of a number alone.
    #[inline(always)]
    pub(super) const fn new(number: T) -> Self {
        Self::of(Lanes::splat(number))
    }

    /// Of an angle, its sine and its cosine.
    #[inline(always)]
    pub(super) const fn on_circle([angle, sine, cosine]: [T; 3]) -> Self {
        Self { lane: Lanes::splat(angle), circle: Some((Lanes::splat(sine), Lanes::splat(cosine))) }
    }

    #[inline(always)]
    const fn of(lane: Lanes<T, 1, F>) -> Self {
        Self { lane, circle: None }
    }

    #[inline(always)]
    pub(super) const fn number(self) -> T {
        let [number] = self.lane.to_array();
        number
    }
}

macro_rules! operators {
    ($($trait:ident $method:ident),*) => {$(
        impl<T: Float, F: Fusion> $trait for Pose<T, F> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self::of($trait::$method(self.lane, other.lane))
            }
        }
    )*};
}

operators!(Add add, Sub sub, Mul mul, Div div);

impl<T: Float, F: Fusion> Neg for Pose<T, F> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self::of(-self.lane)
    }
}

/// Methods that are those of the lane: of one number and of two, and questions.
macro_rules! of_the_lane {
    ($($one:ident)*; $($two:ident)*; $($asked:ident)*; $($compared:ident)*) => {
        $(#[inline(always)]
        fn $one(self) -> Self {
            Self::of(self.lane.$one())
        })*
        $(#[inline(always)]
        fn $two(self, other: Self) -> Self {
            Self::of(self.lane.$two(other.lane))
        })*
        $(#[inline(always)]
        fn $asked(self) -> LaneMask<1> {
            self.lane.$asked()
        })*
        $(#[inline(always)]
        fn $compared(self, other: Self) -> LaneMask<1> {
            self.lane.$compared(other.lane)
        })*
    };
}

impl<T: Float, F: Fusion> Scalar for Pose<T, F> {
    type Mask = LaneMask<1>;

    of_the_lane!(
        sqrt tan asin acos atan; atan2 hypot; is_near is_finite; ge gt is_within
    );

    #[inline(always)]
    fn lit(wide: f64, narrow: f32) -> Self {
        Self::of(Lanes::lit(wide, narrow))
    }
    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.lane.sin_cos();
        (Self::of(sin), Self::of(cos))
    }
    #[inline(always)]
    fn sin_cos_near(self) -> (Self, Self) {
        let (sin, cos) = match self.circle {
            Some(known) => known,
            None => self.lane.sin_cos_near(),
        };
        (Self::of(sin), Self::of(cos))
    }
    #[inline(always)]
    fn det(a: Self, b: Self, c: Self, d: Self) -> Self {
        Self::of(Scalar::det(a.lane, b.lane, c.lane, d.lane))
    }
    #[inline(always)]
    fn fused(a: Self, b: Self, c: Self) -> Self {
        Self::of(Scalar::fused(a.lane, b.lane, c.lane))
    }
    #[inline(always)]
    fn mul_err(a: Self, b: Self) -> Self {
        Self::of(Scalar::mul_err(a.lane, b.lane))
    }
    #[inline(always)]
    fn add_err(a: Self, b: Self) -> Self {
        Self::of(Scalar::add_err(a.lane, b.lane))
    }
    #[inline(always)]
    fn plain(wide: bool, narrow: bool) -> bool {
        <Lanes<T, 1, F> as Scalar>::plain(wide, narrow)
    }
    #[inline(always)]
    fn select(mask: LaneMask<1>, yes: Self, no: Self) -> Self {
        Self::of(Scalar::select(mask, yes.lane, no.lane))
    }
    #[inline(always)]
    fn smallest_square() -> Self {
        Self::of(Scalar::smallest_square())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kernels::Plain;

    type Lane = Lanes<f64, 1, Plain>;
    type Number = Pose<f64, Plain>;

    fn bits(lane: Lane) -> u64 {
        let [number] = lane.to_array();
        number.to_bits()
    }

    /// Numbers of no symmetry, in the domain of every function.
    const ALL: [f64; 4] = [0.3, 0.7, -0.45, 0.9];

    /// Every operation is that of the lane, and leaves what is known of its operands behind.
    #[test]
    fn a_pose_computes_what_its_lane_does() {
        // A sine and a cosine that nobody would compute.
        let poses = ALL.map(|number| Number::on_circle([number, 7.0, 8.0]));
        let ([a, b, c, d], [w, x, y, z]) = (poses, ALL.map(Lane::splat));
        let check = |pose: Number, lane: Lane| {
            assert_eq!(pose.number().to_bits(), bits(lane));
            assert!(pose.circle.is_none());
        };
        check(a + b, w + x);
        check(a - b, w - x);
        check(a * b, w * x);
        check(a / b, w / x);
        check(-a, -w);
        check(a.sqrt(), w.sqrt());
        check(a.tan(), w.tan());
        check(a.asin(), w.asin());
        check(a.acos(), w.acos());
        check(a.atan(), w.atan());
        check(a.atan2(c), w.atan2(y));
        check(a.hypot(b), w.hypot(x));
        check(a.sin_cos().0, w.sin_cos().0);
        check(a.sin_cos().1, w.sin_cos().1);
        check(Scalar::det(a, b, c, d), Scalar::det(w, x, y, z));
        check(Scalar::fused(a, b, c), Scalar::fused(w, x, y));
        check(Scalar::mul_err(a, b), Scalar::mul_err(w, x));
        check(Scalar::add_err(a, b), Scalar::add_err(w, x));
        check(Number::lit(0.3, 0.4), Lane::lit(0.3, 0.4));
        check(Number::smallest_square(), Lane::smallest_square());
        assert_eq!((a.gt(b), a.ge(b), b.ge(a)), (w.gt(x), w.ge(x), x.ge(w)));
        assert_eq!((a.is_within(b), b.is_within(a)), (w.is_within(x), x.is_within(w)));
        assert_eq!((a.is_near(), a.is_finite()), (w.is_near(), w.is_finite()));
        for mask in [a.gt(b), b.gt(a)] {
            check(Scalar::select(mask, a, b), Scalar::select(mask, w, x));
        }
        for known in [[true, false], [false, true]] {
            let [wide, narrow] = known;
            assert_eq!(Number::plain(wide, narrow), Lane::plain(wide, narrow));
        }
    }

    #[test]
    fn a_sine_that_is_known_is_not_computed_again() {
        let (sin, cos) = Number::on_circle([0.3, 7.0, 8.0]).sin_cos_near();
        assert_eq!((sin.number(), cos.number()), (7.0, 8.0));
        let (sin, cos) = Number::new(0.3).sin_cos_near();
        let lanes = Lane::splat(0.3).sin_cos_near();
        assert_eq!(
            (sin.number().to_bits(), cos.number().to_bits()),
            (bits(lanes.0), bits(lanes.1))
        );
    }
}
