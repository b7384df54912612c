//! Several numbers side by side: one solve for a handful of poses.
//!
//! Every operation is the single number's, lane by lane, in loops that compile to vector
//! instructions; nothing here depends on an instruction set. Which lanes may be used is said by
//! the mask that comes with the result.

use core::fmt;
use core::marker::PhantomData;
use core::ops::{Add, BitAnd, Div, Mul, Neg, Sub};

use crate::kernels::{self, Float, Fusion, Plain};
use crate::scalar::{Sealed, elementary, root_of_squares};
use crate::{LibraryFunction, Mask, Scalar};

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

/// The result of a comparison of lanes: yes or no for each.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LaneMask<const W: usize>([bool; W]);

// Loops over lanes are inlined always: as calls on arrays they would stay in memory. Without optimisation
// they stay there anyway, and every operation that is inlined takes a place of its own on the stack, of
// which a machine with many groups has thousands: there the common ones are calls. None has an index: below
// the highest optimisation level it would be checked, and could panic.
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
    #[cfg_attr(debug_assertions, inline(never))]
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn bitand(mut self, other: Self) -> Self {
        for (one, &other) in self.0.iter_mut().zip(&other.0) {
            *one &= other;
        }
        self
    }
}

impl<const W: usize> Sealed for LaneMask<W> {}

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
            #[cfg_attr(debug_assertions, inline(never))]
            #[cfg_attr(not(debug_assertions), inline(always))]
            fn $method(self, other: Self) -> Self {
                self.zip(other, $trait::$method)
            }
        }
    )*};
}

lane_by_lane!(Add add, Sub sub, Mul mul, Div div);

impl<T: Float, const W: usize, F: Fusion> Neg for Lanes<T, W, F> {
    type Output = Self;
    #[cfg_attr(debug_assertions, inline(never))]
    #[cfg_attr(not(debug_assertions), inline(always))]
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
    // Where there is no more, not even a loop that ends at once: it would keep the lanes in memory.
    if W > 8 {
        for (first, second) in first.lanes.iter_mut().zip(&mut second.lanes).skip(8) {
            (*first, *second) = f(*first);
        }
    }
    (first, second)
}

/// The elementary functions of lanes.
macro_rules! lanes {
    ($($one:ident $of_one:ident)*; $($two:ident $of_two:ident)*) => {
        $(#[inline(always)]
        fn $one(self) -> Self {
            self.map(T::$of_one::<F>)
        })*
        $(#[inline(always)]
        fn $two(self, other: Self) -> Self {
            self.zip(other, T::$of_two::<F>)
        })*
    };
}

impl<T: Float, const W: usize, F: Fusion> Sealed for Lanes<T, W, F> {}

impl<T: Float, const W: usize, F: Fusion> Scalar for Lanes<T, W, F> {
    type Mask = LaneMask<W>;

    #[inline(always)]
    fn lit(wide: f64, narrow: f32) -> Self {
        Self::splat(T::lit(wide, narrow))
    }
    #[cfg_attr(debug_assertions, inline(never))]
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn sqrt(self) -> Self {
        self.map(T::sqrt)
    }
    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        both(
            self,
            |x| if x.is_near() { x.sin_cos_kernel::<F>() } else { x.sin_cos_far_kernel::<F>() },
        )
    }
    #[inline(always)]
    fn sin_cos_near(self) -> (Self, Self) {
        both(self, T::sin_cos_near_kernel::<F, false>)
    }
    #[inline(always)]
    fn is_near(self) -> LaneMask<W> {
        self.ask(T::is_near)
    }
    elementary!(lanes);

    #[inline(always)]
    fn hypot(self, other: Self) -> Self {
        self.zip(other, T::hypot)
    }
    #[inline(always)]
    fn apply(self, function: LibraryFunction) -> Self {
        self.map(|x| x.apply(function))
    }
    #[inline(always)]
    fn pow(self, exponent: Self) -> Self {
        self.zip(exponent, T::pow)
    }
    #[inline(always)]
    fn hypot_near(self, other: Self, least: Self) -> (Self, LaneMask<W>) {
        root_of_squares(self, other, least)
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
    #[cfg_attr(debug_assertions, inline(never))]
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn fused(mut a: Self, b: Self, c: Self) -> Self {
        for (a, (&b, &c)) in a.lanes.iter_mut().zip(b.lanes.iter().zip(&c.lanes)) {
            *a = T::fused_by::<F>(*a, b, c);
        }
        a
    }
    #[cfg_attr(debug_assertions, inline(never))]
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn ge(self, other: Self) -> LaneMask<W> {
        self.compare(other, T::ge)
    }
    #[cfg_attr(debug_assertions, inline(never))]
    #[cfg_attr(not(debug_assertions), inline(always))]
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
    #[cfg_attr(debug_assertions, inline(never))]
    #[cfg_attr(not(debug_assertions), inline(always))]
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
mod tests;
