//! The checks through which the formulas of a pose report the clearances of the groups.

use super::{Clearance, Jet};
use crate::checks::Checks;
use crate::roots::FindError;
use crate::roots::unknown::open;
use crate::{Real, Scalar};

/// Value and scale of every group's clearance, as the formulas report them. No condition is checked: a
/// group out of reach has a negative value.
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

/// Runs the formulas and returns the clearances that they report; NaN where they report none.
#[inline(always)]
pub fn told<T: Scalar, R, const N: usize>(
    formulas: impl FnOnce(&mut Told<T, N>) -> R,
) -> [[T; 2]; N] {
    let mut told = Told([[T::num(f64::NAN); 2]; N]);
    formulas(&mut told);
    told.0
}

/// The clearance with the rates of its value, from jets.
#[inline]
pub(crate) fn moving<T: Real>([told, scale]: [Jet<T>; 2]) -> Clearance<T> {
    let Jet { value, rate, second_rate, .. } = told;
    Clearance { value, rate, second_rate, scale: scale.value }
}
