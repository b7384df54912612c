//! How formulas of a pose say how clear of their limits the groups are.

use super::{Clearance, Jet};
use crate::checks::Checks;
use crate::roots::FindError;
use crate::roots::unknown::open;
use crate::{Real, Scalar};

/// Value and scale of every group's clearance, asked of the formulas. Conditions are passed by: what is
/// out of reach is a number below zero here.
pub struct Told<T, const N: usize>([[T; 2]; N]);

impl<T: Scalar, const N: usize> Checks<T> for Told<T, N> {
    #[inline]
    fn sin_cos(&mut self, angle: T) -> (T, T) {
        angle.sin_cos()
    }

    #[inline]
    fn root(&mut self, found: Result<[T; 2], FindError>, _: &'static str, _: &'static str) -> (T, T)
    where
        T: Real,
    {
        open(found)
    }

    #[inline]
    fn closed(&mut self, _: T, _: T, _: &'static str, _: &'static str)
    where
        T: Real,
    {
    }

    #[inline(always)]
    fn clearances(&mut self, groups: &[[T; 2]]) {
        self.0.iter_mut().zip(groups).for_each(|(told, group)| *told = *group);
    }
}

/// What the formulas say.
#[inline(always)]
pub fn told<T: Scalar, R, const N: usize>(
    formulas: impl FnOnce(&mut Told<T, N>) -> R,
) -> [[T; 2]; N] {
    let mut told = Told([[T::num(f64::NAN); 2]; N]);
    formulas(&mut told);
    told.0
}

/// Of numbers that move, with the value's rates.
#[inline]
pub(crate) fn moving<T: Real>([told, scale]: [Jet<T>; 2]) -> Clearance<T> {
    let Jet { value, rate, second_rate, .. } = told;
    Clearance { value, rate, second_rate, scale: scale.value }
}
