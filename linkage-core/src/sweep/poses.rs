//! The number that a sweep runs generated code on: two poses', which may know their sines and cosines
//! beforehand.

use core::marker::PhantomData;
use core::ops::{Add, Div, Mul, Neg, Sub};

use super::verdict::{Asked, TOGETHER, Usable};
use crate::scalar::{Sealed, elementary, root_of_squares};
use crate::{Float, Fusion, Lanes, LibraryFunction, Scalar};

/// A number of some poses, and their sines and cosines if it was read from a sweep's first input. Lanes
/// rather than numbers, since their type says whether products are fused.
///
/// The steps of one pose wait for each other: sine and cosine, division and root, and what is made of them.
/// A processor hides that by beginning with the next poses, as far as its window reaches, and a vector or
/// two of poses fill it. So a sweep takes the sines of a whole block in a loop of their own, short enough for
/// several vectors to be under way. Generated code does not change: it calls an input's sine, and the input
/// has it. The compiler knows which inputs have theirs, and removes unused sines.
///
/// `A` says what comparisons are to tell: which poses may be used, or which are out of reach.
#[derive(Clone, Copy, Debug)]
pub(super) struct Poses<T, F, A = Usable> {
    lanes: Of<T, F>,
    circles: Option<(Of<T, F>, Of<T, F>)>,
    asked: PhantomData<A>,
}

type Of<T, F> = Lanes<T, TOGETHER, F>;

impl<T: Copy, F, A> Poses<T, F, A> {
    /// Poses of numbers alone.
    #[inline(always)]
    pub(super) const fn new(numbers: [T; TOGETHER]) -> Self {
        Self::of(Lanes::new(numbers))
    }

    /// Poses of angles, with their sines and cosines.
    #[inline(always)]
    pub(super) const fn on_circle([angles, sines, cosines]: [[T; TOGETHER]; 3]) -> Self {
        let circles = Some((Lanes::new(sines), Lanes::new(cosines)));
        Self { lanes: Lanes::new(angles), circles, asked: PhantomData }
    }

    #[inline(always)]
    const fn of(lanes: Of<T, F>) -> Self {
        Self { lanes, circles: None, asked: PhantomData }
    }

    #[inline(always)]
    pub(super) const fn numbers(self) -> [T; TOGETHER] {
        self.lanes.to_array()
    }
}

macro_rules! operators {
    ($($trait:ident $method:ident),*) => {$(
        impl<T: Float, F: Fusion, A: Asked> $trait for Poses<T, F, A> {
            type Output = Self;
            #[cfg_attr(debug_assertions, inline(never))]
            #[cfg_attr(not(debug_assertions), inline(always))]
            fn $method(self, other: Self) -> Self {
                Self::of($trait::$method(self.lanes, other.lanes))
            }
        }
    )*};
}

operators!(Add add, Sub sub, Mul mul, Div div);

impl<T: Float, F: Fusion, A: Asked> Neg for Poses<T, F, A> {
    type Output = Self;
    #[cfg_attr(debug_assertions, inline(never))]
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn neg(self) -> Self {
        Self::of(-self.lanes)
    }
}

/// Methods that are those of the lanes: of one number and of two, and comparisons.
macro_rules! of_the_lanes {
    ($($one:ident)*; $($two:ident)*; $($compared:ident)*) => {
        $(#[cfg_attr(debug_assertions, inline(never))]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn $one(self) -> Self {
            Self::of(self.lanes.$one())
        })*
        $(#[cfg_attr(debug_assertions, inline(never))]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn $two(self, other: Self) -> Self {
            Self::of(self.lanes.$two(other.lanes))
        })*
        $(#[cfg_attr(debug_assertions, inline(never))]
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn $compared(self, other: Self) -> A::Mask {
            A::compared(self.lanes.$compared(other.lanes))
        })*
    };
}

macro_rules! functions_of_the_lanes {
    ($($one:ident $_of_one:ident)*; $($two:ident $_of_two:ident)*) => {
        of_the_lanes!($($one)*; $($two)*;);
    };
}

impl<T: Float, F: Fusion, A: Asked> Sealed for Poses<T, F, A> {}

impl<T: Float, F: Fusion, A: Asked> Scalar for Poses<T, F, A> {
    type Mask = A::Mask;

    of_the_lanes!(sqrt; hypot pow; ge gt is_within);
    elementary!(functions_of_the_lanes);

    #[cfg_attr(debug_assertions, inline(never))]
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn is_near(self) -> A::Mask {
        A::compared(self.lanes.is_near())
    }
    #[cfg_attr(debug_assertions, inline(never))]
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn is_finite(self) -> A::Mask {
        A::finite(self.lanes.is_finite())
    }

    #[cfg_attr(debug_assertions, inline(never))]
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn lit(wide: f64, narrow: f32) -> Self {
        Self::of(Of::lit(wide, narrow))
    }
    #[cfg_attr(debug_assertions, inline(never))]
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.lanes.sin_cos();
        (Self::of(sin), Self::of(cos))
    }
    #[cfg_attr(debug_assertions, inline(never))]
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn sin_cos_near(self) -> (Self, Self) {
        let (sin, cos) = match self.circles {
            Some(known) => known,
            None => self.lanes.sin_cos_near(),
        };
        (Self::of(sin), Self::of(cos))
    }
    #[cfg_attr(debug_assertions, inline(never))]
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn apply(self, function: LibraryFunction) -> Self {
        Self::of(self.lanes.apply(function))
    }
    #[cfg_attr(debug_assertions, inline(never))]
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn hypot_near(self, other: Self, least: Self) -> (Self, A::Mask) {
        root_of_squares(self, other, least)
    }
    #[cfg_attr(debug_assertions, inline(never))]
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn det(a: Self, b: Self, c: Self, d: Self) -> Self {
        Self::of(Scalar::det(a.lanes, b.lanes, c.lanes, d.lanes))
    }
    #[cfg_attr(debug_assertions, inline(never))]
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn fused(a: Self, b: Self, c: Self) -> Self {
        Self::of(Scalar::fused(a.lanes, b.lanes, c.lanes))
    }
    #[cfg_attr(debug_assertions, inline(never))]
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn mul_err(a: Self, b: Self) -> Self {
        Self::of(Scalar::mul_err(a.lanes, b.lanes))
    }
    #[cfg_attr(debug_assertions, inline(never))]
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn add_err(a: Self, b: Self) -> Self {
        Self::of(Scalar::add_err(a.lanes, b.lanes))
    }
    #[inline(always)]
    fn plain(wide: bool, narrow: bool) -> bool {
        <Of<T, F> as Scalar>::plain(wide, narrow)
    }
    #[cfg_attr(debug_assertions, inline(never))]
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn select(mask: A::Mask, yes: Self, no: Self) -> Self {
        Self::of(Scalar::select(A::usable(mask), yes.lanes, no.lanes))
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
    type Numbers = Poses<f64, Plain>;

    /// Numbers of no symmetry, in the domain of every function.
    const ALL: [[f64; TOGETHER]; 4] = [[0.3, 0.8], [0.7, -0.4], [-0.45, 0.2], [0.9, 0.5]];

    fn lane(list: [f64; TOGETHER], nth: usize) -> Lane {
        Lane::splat(list[nth])
    }

    /// Every operation is that of a lane for each pose, and leaves what is known of its operands behind.
    #[test]
    fn poses_compute_what_their_lanes_do() {
        // Wrong sines and cosines, which show if an operation keeps them.
        let [a, b, c, d] = ALL.map(|numbers| Numbers::on_circle([numbers, [7.0; 2], [8.0; 2]]));
        for nth in 0..TOGETHER {
            let [w, x, y, z] = ALL.map(|numbers| lane(numbers, nth));
            let check = |poses: Numbers, lane: Lane| {
                assert_eq!([poses.numbers()[nth].to_bits()], lane.to_array().map(f64::to_bits));
                assert!(poses.circles.is_none());
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
            check(a.pow(c), w.pow(y));
            for function in LibraryFunction::ALL {
                check(a.apply(function), w.apply(function));
            }
            check(a.hypot_near(b, c).0, w.hypot_near(x, y).0);
            check(a.sin_cos().0, w.sin_cos().0);
            check(a.sin_cos().1, w.sin_cos().1);
            check(Scalar::det(a, b, c, d), Scalar::det(w, x, y, z));
            check(Scalar::fused(a, b, c), Scalar::fused(w, x, y));
            check(Scalar::mul_err(a, b), Scalar::mul_err(w, x));
            check(Scalar::add_err(a, b), Scalar::add_err(w, x));
            check(Numbers::lit(0.3, 0.4), Lane::lit(0.3, 0.4));
            check(Numbers::smallest_square(), Lane::smallest_square());
            let answers = [
                (a.gt(b), w.gt(x)),
                (a.ge(b), w.ge(x)),
                (b.ge(a), x.ge(w)),
                (a.is_within(b), w.is_within(x)),
                (b.is_within(a), x.is_within(w)),
                (a.is_near(), w.is_near()),
                (a.hypot_near(b, c).1, w.hypot_near(x, y).1),
                (a.is_finite(), w.is_finite()),
            ];
            for (poses, lane) in answers {
                assert_eq!([poses.to_array()[nth]], lane.to_array());
            }
            for (mask, of_lane) in [(a.gt(b), w.gt(x)), (b.gt(a), x.gt(w))] {
                check(Scalar::select(mask, a, b), Scalar::select(of_lane, w, x));
            }
        }
        for known in [[true, false], [false, true]] {
            let [wide, narrow] = known;
            assert_eq!(Numbers::plain(wide, narrow), Lane::plain(wide, narrow));
        }
    }

    #[test]
    fn a_sine_that_is_known_is_not_computed_again() {
        let (sin, cos) = Numbers::on_circle([[0.3, 0.8], [7.0, 5.0], [8.0, 6.0]]).sin_cos_near();
        assert_eq!((sin.numbers(), cos.numbers()), ([7.0, 5.0], [8.0, 6.0]));
        let (sin, cos) = Numbers::new([0.3, 0.8]).sin_cos_near();
        for (nth, angle) in [0.3, 0.8].into_iter().enumerate() {
            let (of_lane, cos_of_lane) = Lane::splat(angle).sin_cos_near();
            assert_eq!([sin.numbers()[nth].to_bits()], of_lane.to_array().map(f64::to_bits));
            assert_eq!([cos.numbers()[nth].to_bits()], cos_of_lane.to_array().map(f64::to_bits));
        }
    }
}
