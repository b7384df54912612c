//! The number that a sweep runs generated code on: lanes that may know their sine and cosine beforehand.

use core::ops::{Add, Div, Mul, Neg, Sub};

use crate::{Float, Fusion, LaneMask, Lanes, Scalar};

/// Lanes, and the sine and cosine of those that were read from a sweep's first input.
///
/// The steps of one pose wait for each other: sine and cosine, division and root, and what is made of them.
/// A processor hides that by beginning with the next poses, as far as its window reaches, and one vector of
/// poses fills it. So a sweep takes the sines of a whole block in a loop of their own, short enough for
/// several vectors to be under way. Generated code is as ever: it asks an input for its sine, and the input
/// has it. Whether it does is known while compiling, and sines that no one asks for are computed by no one.
#[derive(Clone, Copy, Debug)]
pub(super) struct Poses<T, const W: usize, F> {
    lanes: Lanes<T, W, F>,
    circle: Option<(Lanes<T, W, F>, Lanes<T, W, F>)>,
}

impl<T: Copy, const W: usize, F> Poses<T, W, F> {
    /// Of numbers alone.
    #[inline(always)]
    pub(super) const fn new(lanes: Lanes<T, W, F>) -> Self {
        Self { lanes, circle: None }
    }

    /// Of angles, their sines and their cosines.
    #[inline(always)]
    pub(super) const fn on_circle(lanes: [T; W], sines: [T; W], cosines: [T; W]) -> Self {
        Self { lanes: Lanes::new(lanes), circle: Some((Lanes::new(sines), Lanes::new(cosines))) }
    }

    #[inline(always)]
    pub(super) const fn into_array(self) -> [T; W] {
        self.lanes.to_array()
    }
}

macro_rules! operators {
    ($($trait:ident $method:ident),*) => {$(
        impl<T: Float, const W: usize, F: Fusion> $trait for Poses<T, W, F> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self::new($trait::$method(self.lanes, other.lanes))
            }
        }
    )*};
}

operators!(Add add, Sub sub, Mul mul, Div div);

impl<T: Float, const W: usize, F: Fusion> Neg for Poses<T, W, F> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self::new(-self.lanes)
    }
}

/// Methods that are those of the lanes: of one number and of two, and questions.
macro_rules! of_the_lanes {
    ($($one:ident)*; $($two:ident)*; $($asked:ident)*; $($compared:ident)*) => {
        $(#[inline(always)]
        fn $one(self) -> Self {
            Self::new(self.lanes.$one())
        })*
        $(#[inline(always)]
        fn $two(self, other: Self) -> Self {
            Self::new(self.lanes.$two(other.lanes))
        })*
        $(#[inline(always)]
        fn $asked(self) -> LaneMask<W> {
            self.lanes.$asked()
        })*
        $(#[inline(always)]
        fn $compared(self, other: Self) -> LaneMask<W> {
            self.lanes.$compared(other.lanes)
        })*
    };
}

impl<T: Float, const W: usize, F: Fusion> Scalar for Poses<T, W, F> {
    type Mask = LaneMask<W>;

    of_the_lanes!(
        sqrt tan asin acos atan; atan2 hypot; is_near is_finite; ge gt is_within
    );

    #[inline(always)]
    fn lit(wide: f64, narrow: f32) -> Self {
        Self::new(Lanes::lit(wide, narrow))
    }
    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.lanes.sin_cos();
        (Self::new(sin), Self::new(cos))
    }
    #[inline(always)]
    fn sin_cos_near(self) -> (Self, Self) {
        let (sin, cos) = match self.circle {
            Some(known) => known,
            None => self.lanes.sin_cos_near(),
        };
        (Self::new(sin), Self::new(cos))
    }
    #[inline(always)]
    fn det(a: Self, b: Self, c: Self, d: Self) -> Self {
        Self::new(Scalar::det(a.lanes, b.lanes, c.lanes, d.lanes))
    }
    #[inline(always)]
    fn fused(a: Self, b: Self, c: Self) -> Self {
        Self::new(Scalar::fused(a.lanes, b.lanes, c.lanes))
    }
    #[inline(always)]
    fn mul_err(a: Self, b: Self) -> Self {
        Self::new(Scalar::mul_err(a.lanes, b.lanes))
    }
    #[inline(always)]
    fn add_err(a: Self, b: Self) -> Self {
        Self::new(Scalar::add_err(a.lanes, b.lanes))
    }
    #[inline(always)]
    fn plain(wide: bool, narrow: bool) -> bool {
        <Lanes<T, W, F> as Scalar>::plain(wide, narrow)
    }
    #[inline(always)]
    fn select(mask: LaneMask<W>, yes: Self, no: Self) -> Self {
        Self::new(Scalar::select(mask, yes.lanes, no.lanes))
    }
    #[inline(always)]
    fn smallest_square() -> Self {
        Self::new(Scalar::smallest_square())
    }
}
