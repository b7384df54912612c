//! The chain rule for each of `num-dual`'s numbers of fixed size.
//!
//! All of `num-dual`'s own functions are left aside: its square root of zero and its arc tangent of a
//! vector on the y axis have derivatives that are not numbers, its sine is not the kernel's, and
//! comparing its numbers compares real parts only. Addition, multiplication and division are its own;
//! the last multiplies by the reciprocal, which costs one more rounding than a division does.

use nalgebra::Const;
use num_dual::{
    Derivative, Dual, Dual2, Dual2SVec, Dual3, DualNum, DualSVec, HyperDual, HyperDualVec,
    HyperHyperDual,
};

use crate::Real;
use crate::chain_rule::Compose;
use crate::scalar::lit;

/// A type that can be the part of a `num-dual` dual number.
pub trait Part: Real + DualNum {}

impl<T: Real + DualNum> Part for T {}

/// The methods that only name the type's fields.
macro_rules! real_part {
    (order: $order:literal) => {
        type Part = T;

        const ORDER: usize = $order;

        #[inline]
        fn constant(part: T) -> Self {
            Self::from_re(part)
        }
        #[inline]
        fn real(self) -> T {
            self.re
        }
        #[inline]
        fn with_real(mut self, part: T) -> Self {
            self.re = part;
            self
        }
    };
}

impl<T: Part> Compose for Dual<T> {
    real_part!(order: 1);

    #[inline]
    fn compose(self, [f0, f1, ..]: [T; 4]) -> Self {
        Self::new(f0, f1 * self.eps)
    }
    #[inline]
    fn derivatives_all(self, test: impl Fn(T) -> bool) -> bool {
        test(self.eps)
    }
}

impl<T: Part> Compose for Dual2<T> {
    real_part!(order: 2);

    #[inline]
    fn compose(self, [f0, f1, f2, _]: [T; 4]) -> Self {
        Self::new(f0, f1 * self.v1, f1 * self.v2 + f2 * self.v1 * self.v1)
    }
    #[inline]
    fn derivatives_all(self, test: impl Fn(T) -> bool) -> bool {
        test(self.v1) && test(self.v2)
    }
}

impl<T: Part> Compose for Dual3<T> {
    real_part!(order: 3);

    /// Faà di Bruno's formula to the third order.
    #[inline]
    fn compose(self, [f0, f1, f2, f3]: [T; 4]) -> Self {
        let (v1, v2, v3) = (self.v1, self.v2, self.v3);
        let third = f1 * v3 + lit::<T>(3.0) * f2 * v1 * v2 + f3 * v1 * v1 * v1;
        Self::new(f0, f1 * v1, f1 * v2 + f2 * v1 * v1, third)
    }
    #[inline]
    fn derivatives_all(self, test: impl Fn(T) -> bool) -> bool {
        test(self.v1) && test(self.v2) && test(self.v3)
    }
}

impl<T: Part> Compose for HyperDual<T> {
    real_part!(order: 2);

    #[inline]
    fn compose(self, [f0, f1, f2, _]: [T; 4]) -> Self {
        let mixed = f1 * self.eps1eps2 + f2 * self.eps1 * self.eps2;
        Self::new(f0, f1 * self.eps1, f1 * self.eps2, mixed)
    }
    #[inline]
    fn derivatives_all(self, test: impl Fn(T) -> bool) -> bool {
        test(self.eps1) && test(self.eps2) && test(self.eps1eps2)
    }
}

impl<T: Part> Compose for HyperHyperDual<T> {
    real_part!(order: 3);

    #[inline]
    fn compose(self, [f0, f1, f2, f3]: [T; 4]) -> Self {
        let [e1, e2, e3] = [self.eps1, self.eps2, self.eps3];
        let [e12, e13, e23] = [self.eps1eps2, self.eps1eps3, self.eps2eps3];
        Self::new(
            f0,
            f1 * e1,
            f1 * e2,
            f1 * e3,
            f1 * e12 + f2 * e1 * e2,
            f1 * e13 + f2 * e1 * e3,
            f1 * e23 + f2 * e2 * e3,
            f1 * self.eps1eps2eps3 + f2 * (e1 * e23 + e2 * e13 + e3 * e12) + f3 * e1 * e2 * e3,
        )
    }
    #[inline]
    fn derivatives_all(self, test: impl Fn(T) -> bool) -> bool {
        let first = test(self.eps1) && test(self.eps2) && test(self.eps3);
        let second = test(self.eps1eps2) && test(self.eps1eps3) && test(self.eps2eps3);
        first && second && test(self.eps1eps2eps3)
    }
}

/// True if all entries pass the test; an absent derivative has no entries.
macro_rules! all_of {
    ($derivative:expr, $test:expr) => {
        match &$derivative {
            Derivative(Some(entries)) => entries.iter().all(|&entry| $test(entry)),
            _ => true,
        }
    };
}

impl<T: Part, const N: usize> Compose for DualSVec<T, N> {
    real_part!(order: 1);

    #[inline]
    fn compose(self, [f0, f1, ..]: [T; 4]) -> Self {
        Self::new(f0, self.eps * f1)
    }
    #[inline]
    fn derivatives_all(self, test: impl Fn(T) -> bool) -> bool {
        all_of!(self.eps, test)
    }
    #[inline]
    fn has_no_derivative(self) -> bool {
        self.eps.0.is_none()
    }
}

impl<T: Part, const N: usize> Compose for Dual2SVec<T, N> {
    real_part!(order: 2);

    #[inline]
    fn compose(self, [f0, f1, f2, _]: [T; 4]) -> Self {
        Self::new(f0, self.v1 * f1, self.v2 * f1 + self.v1.tr_mul(&self.v1) * f2)
    }
    #[inline]
    fn derivatives_all(self, test: impl Fn(T) -> bool) -> bool {
        all_of!(self.v1, test) && all_of!(self.v2, test)
    }
    #[inline]
    fn has_no_derivative(self) -> bool {
        self.v1.0.is_none() && self.v2.0.is_none()
    }
}

impl<T: Part, const M: usize, const N: usize> Compose for HyperDualVec<T, Const<M>, Const<N>> {
    real_part!(order: 2);

    #[inline]
    fn compose(self, [f0, f1, f2, _]: [T; 4]) -> Self {
        let mixed = self.eps1eps2 * f1 + &self.eps1 * &self.eps2 * f2;
        Self::new(f0, self.eps1 * f1, self.eps2 * f1, mixed)
    }
    #[inline]
    fn derivatives_all(self, test: impl Fn(T) -> bool) -> bool {
        all_of!(self.eps1, test) && all_of!(self.eps2, test) && all_of!(self.eps1eps2, test)
    }
    #[inline]
    fn has_no_derivative(self) -> bool {
        self.eps1.0.is_none() && self.eps2.0.is_none() && self.eps1eps2.0.is_none()
    }
}

#[cfg(test)]
mod tests;
