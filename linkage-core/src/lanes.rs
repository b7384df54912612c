//! Several numbers side by side: one solve for a handful of poses.
//!
//! Every operation is the single number's, lane by lane, in loops that compile to vector
//! instructions; nothing here depends on an instruction set. Which lanes may be used is said by
//! the mask that comes with the result.

use core::fmt;
use core::marker::PhantomData;
use core::ops::{Add, BitAnd, Div, Mul, Neg, Sub};

use crate::kernels::{self, Float, Fusion, Plain};
use crate::{Mask, Scalar};

/// `W` numbers of type `T`.
///
/// `F` says whether a·b + c rounds once ([`Fused`](crate::Fused)) or twice ([`Plain`]): inside a
/// function that is compiled for another instruction set than the rest of the program, only the
/// type can tell. A plain lane computes the same bits as a single number on a target without
/// fused operations, a fused lane the same as one on a target with them.
///
/// Four `f64` or eight `f32` fill a 256-bit register; twice as many hide the latency of one
/// behind the other.
#[derive(Clone, Copy, PartialEq)]
pub struct Lanes<T, const W: usize, F = Plain> {
    lanes: [T; W],
    fusion: PhantomData<F>,
}

/// What a comparison of lanes answers: yes or no for each.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LaneMask<const W: usize>([bool; W]);

// Loops over lanes are inlined always: as calls on arrays they would stay in memory. None has an
// index: below the highest optimisation level it would be checked, and could panic.
impl<T: Copy, const W: usize, F> Lanes<T, W, F> {
    /// One number in each lane.
    #[inline(always)]
    #[must_use]
    pub const fn new(lanes: [T; W]) -> Self {
        Self { lanes, fusion: PhantomData }
    }

    /// The same number in every lane.
    #[inline(always)]
    #[must_use]
    pub const fn splat(value: T) -> Self {
        Self::new([value; W])
    }

    /// The numbers.
    #[inline(always)]
    #[must_use]
    pub const fn to_array(self) -> [T; W] {
        self.lanes
    }

    #[inline(always)]
    fn map(mut self, f: impl Fn(T) -> T) -> Self {
        for x in &mut self.lanes {
            *x = f(*x);
        }
        self
    }

    #[inline(always)]
    fn zip(mut self, other: Self, f: impl Fn(T, T) -> T) -> Self {
        for (x, &y) in self.lanes.iter_mut().zip(&other.lanes) {
            *x = f(*x, y);
        }
        self
    }

    #[inline(always)]
    fn ask(self, f: impl Fn(T) -> bool) -> LaneMask<W> {
        let mut mask = [false; W];
        for (answer, &x) in mask.iter_mut().zip(&self.lanes) {
            *answer = f(x);
        }
        LaneMask(mask)
    }

    #[inline(always)]
    fn compare(self, other: Self, f: impl Fn(T, T) -> bool) -> LaneMask<W> {
        let mut mask = [false; W];
        for ((answer, &x), &y) in mask.iter_mut().zip(&self.lanes).zip(&other.lanes) {
            *answer = f(x, y);
        }
        LaneMask(mask)
    }
}

impl<const W: usize> LaneMask<W> {
    #[inline(always)]
    pub(crate) const fn new(answers: [bool; W]) -> Self {
        Self(answers)
    }

    /// The answer for each lane.
    #[inline(always)]
    #[must_use]
    pub const fn to_array(self) -> [bool; W] {
        self.0
    }
}

impl<const W: usize> BitAnd for LaneMask<W> {
    type Output = Self;
    #[inline(always)]
    fn bitand(mut self, other: Self) -> Self {
        for (one, &other) in self.0.iter_mut().zip(&other.0) {
            *one &= other;
        }
        self
    }
}

impl<const W: usize> Mask for LaneMask<W> {
    const ALL: Self = Self([true; W]);

    #[inline(always)]
    fn all(self) -> bool {
        // Without early exit: a loop that may stop early stays one lane at a time.
        self.0.iter().fold(true, |all, &lane| all & lane)
    }
}

impl<T: Copy, const W: usize, F> From<[T; W]> for Lanes<T, W, F> {
    #[inline(always)]
    fn from(lanes: [T; W]) -> Self {
        Self::new(lanes)
    }
}

impl<T: Copy, const W: usize, F> From<Lanes<T, W, F>> for [T; W] {
    #[inline(always)]
    fn from(lanes: Lanes<T, W, F>) -> Self {
        lanes.lanes
    }
}

impl<T: fmt::Debug, const W: usize, F> fmt::Debug for Lanes<T, W, F> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.lanes.fmt(f)
    }
}

macro_rules! lane_by_lane {
    ($($trait:ident $method:ident),*) => {$(
        impl<T: Float, const W: usize, F: Fusion> $trait for Lanes<T, W, F> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                self.zip(other, $trait::$method)
            }
        }
    )*};
}

lane_by_lane!(Add add, Sub sub, Mul mul, Div div);

impl<T: Float, const W: usize, F: Fusion> Neg for Lanes<T, W, F> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.map(Neg::neg)
    }
}

/// Two lanes of results from one of arguments.
#[inline(always)]
fn both<T: Float, const W: usize, F: Fusion>(
    x: Lanes<T, W, F>,
    f: impl Fn(T) -> (T, T),
) -> (Lanes<T, W, F>, Lanes<T, W, F>) {
    let (mut first, mut second) = (x, x);
    // Written out for as many lanes as registers hold: the body may be so long that the compiler
    // leaves a loop over it as it is, one lane at a time.
    macro_rules! lane {
        ($($i:literal)*) => { $(
            if $i < W {
                (first.lanes[$i], second.lanes[$i]) = f(x.lanes[$i]);
            }
        )* };
    }
    lane!(0 1 2 3 4 5 6 7);
    for (first, second) in first.lanes.iter_mut().zip(&mut second.lanes).skip(8) {
        (*first, *second) = f(*first);
    }
    (first, second)
}

impl<T: Float, const W: usize, F: Fusion> Scalar for Lanes<T, W, F> {
    type Mask = LaneMask<W>;

    #[inline(always)]
    fn lit(wide: f64, narrow: f32) -> Self {
        Self::splat(T::lit(wide, narrow))
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        self.map(T::sqrt)
    }
    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        both(self, |x| if x.is_near() { x.sin_cos_kernel::<F>() } else { x.sin_cos() })
    }
    #[inline(always)]
    fn sin_cos_near(self) -> (Self, Self) {
        both(self, T::sin_cos_near_kernel::<F, false>)
    }
    #[inline(always)]
    fn is_near(self) -> LaneMask<W> {
        self.ask(T::is_near)
    }
    #[inline(always)]
    fn tan(self) -> Self {
        self.map(T::tan)
    }
    #[inline(always)]
    fn asin(self) -> Self {
        self.map(T::asin)
    }
    #[inline(always)]
    fn acos(self) -> Self {
        self.map(T::acos)
    }
    #[inline(always)]
    fn atan(self) -> Self {
        self.map(T::atan)
    }
    #[inline(always)]
    fn atan2(self, x: Self) -> Self {
        self.zip(x, T::atan2)
    }
    #[inline(always)]
    fn hypot(self, other: Self) -> Self {
        self.zip(other, T::hypot)
    }
    #[inline(always)]
    fn det(mut a: Self, b: Self, c: Self, d: Self) -> Self {
        let others = b.lanes.iter().zip(&c.lanes).zip(&d.lanes);
        for (a, ((&b, &c), &d)) in a.lanes.iter_mut().zip(others) {
            *a = kernels::det::<T, F>(*a, b, c, d);
        }
        a
    }
    #[inline(always)]
    fn mul_err(a: Self, b: Self) -> Self {
        a.zip(b, kernels::mul_err::<T, F>)
    }
    #[inline(always)]
    fn add_err(a: Self, b: Self) -> Self {
        a.zip(b, T::add_err)
    }
    #[inline(always)]
    fn fused(mut a: Self, b: Self, c: Self) -> Self {
        for (a, (&b, &c)) in a.lanes.iter_mut().zip(b.lanes.iter().zip(&c.lanes)) {
            *a = T::fused_by::<F>(*a, b, c);
        }
        a
    }
    #[inline(always)]
    fn ge(self, other: Self) -> LaneMask<W> {
        self.compare(other, T::ge)
    }
    #[inline(always)]
    fn gt(self, other: Self) -> LaneMask<W> {
        self.compare(other, T::gt)
    }
    #[inline(always)]
    fn is_within(self, bound: Self) -> LaneMask<W> {
        self.compare(bound, T::is_within)
    }
    #[inline(always)]
    fn plain(wide: bool, narrow: bool) -> bool {
        T::plain(wide, narrow)
    }
    #[inline(always)]
    fn is_finite(self) -> LaneMask<W> {
        self.ask(T::is_finite)
    }
    #[inline(always)]
    fn select(mask: LaneMask<W>, mut yes: Self, no: Self) -> Self {
        for (yes, (&mask, &no)) in yes.lanes.iter_mut().zip(mask.0.iter().zip(&no.lanes)) {
            *yes = T::select(mask, *yes, no);
        }
        yes
    }
    #[inline(always)]
    fn smallest_square() -> Self {
        Self::splat(T::smallest_square())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kernels::Native;
    use crate::{Fused, Real};

    const ARGUMENTS: [f64; 8] = [0.3, -1.25, 2.0, 7e4, -0.0, 1e6, 3e-9, -12.5];
    const OTHERS: [f64; 8] = [1.7, 0.25, -3.5, 2e-7, 1.0, -1.0, 5.0, 12.5];

    /// Bits, with all numbers that are none taken for the same.
    fn bits<T: Real>(x: T) -> u64 {
        if x.value().is_nan() { u64::MAX } else { x.value().to_bits() }
    }

    #[track_caller]
    fn assert_same<T: Float, F: Fusion>(lanes: Lanes<T, 8, F>, single: impl Fn(usize) -> T) {
        for (i, lane) in lanes.to_array().into_iter().enumerate() {
            assert_eq!(bits(lane), bits(single(i)), "lane {i}: {lane:?} {:?}", single(i));
        }
    }

    /// Every operation, against the single number's with `F` as its way of fusing.
    fn agrees_with_single_numbers<T: Float, F: Fusion>() {
        let t = |x: f64| T::lit(x, x as f32);
        let [x, y] = [ARGUMENTS.map(t), OTHERS.map(t)];
        let [lx, ly] = [Lanes::<T, 8, F>::new(x), Lanes::new(y)];
        assert_same(lx + ly, |i| x[i] + y[i]);
        assert_same(lx - ly, |i| x[i] - y[i]);
        assert_same(lx * ly, |i| x[i] * y[i]);
        assert_same(lx / ly, |i| x[i] / y[i]);
        assert_same(-lx, |i| -x[i]);
        assert_same(lx.sqrt(), |i| x[i].sqrt());
        assert_same(lx.tan(), |i| x[i].tan());
        assert_same(lx.asin(), |i| x[i].asin());
        assert_same(lx.acos(), |i| x[i].acos());
        assert_same(lx.atan(), |i| x[i].atan());
        assert_same(lx.atan2(ly), |i| x[i].atan2(y[i]));
        assert_same(lx.hypot(ly), |i| x[i].hypot(y[i]));
        assert_same(lx.sin_cos_near().0, |i| x[i].sin_cos_near_kernel::<F, true>().0);
        assert_same(lx.sin_cos_near().1, |i| x[i].sin_cos_near_kernel::<F, true>().1);
        let full = |x: T| if x.is_near() { x.sin_cos_kernel::<F>() } else { x.sin_cos() };
        assert_same(lx.sin_cos().0, |i| full(x[i]).0);
        assert_same(lx.sin_cos().1, |i| full(x[i]).1);
        assert_same(Scalar::det(lx, ly, ly, lx + ly), |i| {
            kernels::det::<T, F>(x[i], y[i], y[i], x[i] + y[i])
        });
        assert_same(Scalar::mul_err(lx, ly), |i| kernels::mul_err::<T, F>(x[i], y[i]));
        assert_same(Scalar::add_err(lx, ly), |i| T::add_err(x[i], y[i]));
        assert_same(Scalar::fused(lx, ly, lx), |i| T::fused_by::<F>(x[i], y[i], x[i]));
        assert_eq!(lx.ge(ly).to_array(), core::array::from_fn(|i| x[i].ge(y[i])));
        assert_eq!(lx.gt(ly).to_array(), core::array::from_fn(|i| x[i].gt(y[i])));
        assert_eq!(lx.is_near().to_array(), x.map(Scalar::is_near));
        assert_eq!(lx.is_within(ly).to_array(), core::array::from_fn(|i| x[i].is_within(y[i])));
        assert_eq!(
            (ly / lx).is_finite().to_array(),
            core::array::from_fn(|i| Scalar::is_finite(y[i] / x[i]))
        );
        assert_same(Scalar::select(lx.gt(ly), lx, ly), |i| if x[i].gt(y[i]) { x[i] } else { y[i] });
        assert_same::<T, F>(Scalar::smallest_square(), |_| T::smallest_square());
        assert_same::<T, F>(Scalar::lit(1.0 / 3.0, 0.2), |_| T::lit(1.0 / 3.0, 0.2));
    }

    #[test]
    fn lanes_agree_with_single_numbers_bit_for_bit() {
        agrees_with_single_numbers::<f64, Plain>();
        agrees_with_single_numbers::<f64, Fused>();
        agrees_with_single_numbers::<f32, Plain>();
        agrees_with_single_numbers::<f32, Fused>();
    }

    #[test]
    fn lanes_fused_like_the_target_are_the_single_numbers() {
        fn check<T: Float>() {
            let t = |x: f64| T::lit(x, x as f32);
            let [x, y] = [ARGUMENTS.map(t), OTHERS.map(t)];
            let [lx, ly] = [Lanes::<T, 8, Native>::new(x), Lanes::new(y)];
            assert_same(lx.sin_cos().0, |i| x[i].sin_cos().0);
            assert_same(lx.sin_cos_near().1, |i| x[i].sin_cos_near().1);
            assert_same(Scalar::det(lx, ly, ly, lx), |i| T::det(x[i], y[i], y[i], x[i]));
            assert_same(Scalar::fused(lx, ly, lx), |i| T::fused(x[i], y[i], x[i]));
        }
        check::<f64>();
        check::<f32>();
    }

    #[test]
    fn a_mask_speaks_for_every_lane() {
        let x = Lanes::<f64, 3>::new([1.0, 2.0, 3.0]);
        let one = Lanes::splat(1.0);
        assert!(x.ge(one).all() && !x.gt(one).all());
        assert_eq!((x.ge(one) & x.gt(one)).to_array(), [false, true, true]);
        assert_eq!(LaneMask::<3>::ALL.to_array(), [true; 3]);
        assert_eq!(<[f64; 3]>::from(Lanes::from([1.0, 2.0, 3.0]) - one), [0.0, 1.0, 2.0]);
    }
}
