//! From where on a clearance counts as zero, as clear, and as so near that results are interpolated.

use crate::Real;
use crate::kernels::sqrt;

/// From where on a clearance, in units of its scale, counts as what.
#[derive(Clone, Copy, Debug)]
pub(super) struct Thresholds {
    /// Up to this it counts as zero, where it is lowest.
    pub(super) zero: f64,
    /// From this on no mode changes nearby: a change point that counts as zero is at least three
    /// times as far below as it can be above zero, so that the sign of the rate is sure.
    pub(super) clear: f64,
}

impl Thresholds {
    pub(super) fn of<T: Real>() -> Self {
        let zero = sqrt(T::EPSILON);
        Self { zero, clear: 4.0 * zero }
    }
}

/// The width of interpolation around a change point. At a distance w, where the clearance is
/// about ½ w² of its scale, the rounding of an acceleration is ε/w³; a motion that is a power series
/// as far as ρ is interpolated by n nodes with an error of (w/ρ)ⁿ. Both are equal at
/// wⁿ⁺³ = ε ρⁿ.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Zone {
    /// For results as they are: eight nodes, and ρ = 0.3 rad for links that turn back three times as
    /// fast as they came, as an antiparallelogram's does.
    Shown,
    /// For second rates that are integrated: the errors in the passages of a change point are alike and
    /// add up over the turns. So the zone begins where rounding is less, with sixteen nodes and
    /// ρ = 0.36 rad, and is refined. In `f32` it would be half a radian wide: there it is as for
    /// `Shown`.
    Integrated,
}

/// ½ (ε ρ⁸)^(2/11) with ρ = 0.3.
const NEAR_SHOWN: [f64; 2] = [1.2e-4, 4.8e-3];
/// ½ (ε ρ¹⁶)^(2/19) with ρ = 0.36 in `f64`.
const NEAR_INTEGRATED: [f64; 2] = [2e-3, 4.8e-3];

/// Nodes on both sides of a change point, in units of the zone's width. The outermost come last:
/// leaving two out tells how far the interpolation may be off.
const NODES: [f64; 16] =
    [-1.0, 1.0, -1.5, 1.5, -2.0, 2.0, -2.5, 2.5, -3.0, 3.0, -3.5, 3.5, -4.0, 4.0, -4.5, 4.5];

impl Zone {
    /// The clearance at its edge, in units of its scale.
    pub(super) fn near<T: Real>(self) -> f64 {
        let [wide, narrow] = match self {
            Self::Shown => NEAR_SHOWN,
            Self::Integrated => NEAR_INTEGRATED,
        };
        if T::EPSILON <= f64::EPSILON { wide } else { narrow }
    }

    pub(super) fn nodes(self) -> &'static [f64] {
        match self {
            Self::Shown => NODES.get(..8).unwrap_or(&NODES),
            Self::Integrated => &NODES,
        }
    }

    /// The distance of the outermost nodes, in widths.
    pub(super) fn reach(self) -> f64 {
        self.nodes().last().copied().unwrap_or(1.0)
    }

    /// True if narrower nodes are tried although those of the whole width give a result.
    pub(super) fn is_refined(self) -> bool {
        self == Self::Integrated
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thresholds_are_what_they_are_derived_to_be() {
        fn check<T: Real>() {
            let Thresholds { zero, clear } = Thresholds::of::<T>();
            let derived = |rho: f64, nodes: i32| {
                0.5 * (T::EPSILON * rho.powi(nodes)).powf(2.0 / f64::from(nodes + 3))
            };
            let shown = Zone::Shown.near::<T>();
            assert!((shown / derived(0.3, 8) - 1.0).abs() < 0.05, "{shown}");
            let integrated = Zone::Integrated.near::<T>();
            let expected = if T::EPSILON < 1e-10 { derived(0.36, 16) } else { shown };
            assert!((integrated / expected - 1.0).abs() < 0.05, "{integrated} for {expected}");
            assert!((zero * zero / T::EPSILON - 1.0).abs() < 1e-15, "{zero}");
            assert_eq!(clear, 4.0 * zero);
            assert!(clear < shown);
        }
        check::<f64>();
        check::<f32>();
    }
}
