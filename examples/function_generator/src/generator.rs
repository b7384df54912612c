//! The crank-rocker that generates a function, as a mechanism and as an optimisation problem.
//!
//! With a crank of 1 and a ground of 5 the rocker shall turn, over the first 90° of crank after
//! its right-hand limit, as ψ = ψ₀ + 2/(3π) (φ − φ₀)², and the transmission angle shall stay
//! between 45° and 135°. Unknown are the lengths of coupler and rocker.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

use linkage_core::{Real, SolveError, mechanism};

mechanism! {
    /// A crank-rocker and a pointer on the rocker's pivot that turns as wanted.
    ///
    /// Both start at the rocker's limit, where crank and coupler lie in line, so that all three
    /// angles there depend on the lengths: a sensitivity accounts for that too.
    pub(crate) struct FunctionGenerator {
        /// The crank's angle past the rocker's limit.
        input turn: angle;
        param coupler = 4m;
        param rocker = 2.5m;

        let reach = 1m + coupler;
        let squares = reach * reach - rocker * rocker;
        let crank_at_limit = acos((squares + 5m * 5m) / (10m * reach));
        let rocker_at_limit = acos((squares - 5m * 5m) / (10m * rocker));

        ground A(0, 0), D(5m, 0);

        crank AB(A) -> B        { length: 1m, angle: crank_at_limit + turn }
        rrr   BC(B), DC(D) -> C { lengths: (coupler, rocker), mode: left }
        crank pointer(D)        { angle: rocker_at_limit + 2 * turn * turn / (3 * pi) }

        /// How far the rocker is ahead of the pointer.
        output error = DC.angle - pointer.angle;
    }
}

mechanism! {
    /// The same crank-rocker at any crank angle, for its transmission angle.
    pub(crate) struct Transmission {
        input phi: angle;
        param coupler = 4m;
        param rocker = 2.5m;

        ground A(0, 0), D(5m, 0);

        crank AB(A) -> B        { length: 1m, angle: phi }
        rrr   BC(B), DC(D) -> C { lengths: (coupler, rocker), mode: left }

        output transmission = DC.angle - BC.angle;
    }
}

/// Lengths of coupler and rocker, in units of the crank.
pub(crate) type Lengths = [f64; 2];

/// The crank's angle past the limit at each of the 30 steps.
pub(crate) fn steps() -> impl Iterator<Item = f64> {
    (1..=30).map(|step| FRAC_PI_2 * f64::from(step) / 30.0)
}

/// The wanted turn of the rocker.
pub(crate) fn wanted(turn: f64) -> f64 {
    2.0 / (3.0 * PI) * turn * turn
}

/// The lead of the rocker over its wanted turn.
pub(crate) fn error([coupler, rocker]: Lengths, turn: f64) -> Result<f64, SolveError> {
    Ok(FunctionGenerator { coupler, rocker }.position(turn)?.error.angle())
}

/// The transmission angle has its extremes where the crank lies along the ground.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Limit {
    /// At least 45°, with the crank towards the rocker.
    Least,
    /// At most 135°, with the crank away from the rocker.
    Largest,
}

impl Limit {
    pub(crate) const BOTH: [Self; 2] = [Self::Least, Self::Largest];

    /// The transmission angle there.
    pub(crate) fn angle<T: Real>(self, bars: &Transmission<T>) -> Result<T, SolveError> {
        let crank = match self {
            Self::Least => 0.0,
            Self::Largest => PI,
        };
        Ok(bars.position(T::num(crank))?.transmission.angle())
    }

    /// The excess of the transmission angle over its limit: an optimum has at most zero.
    pub(crate) fn excess<T: Real>(self, bars: &Transmission<T>) -> Result<T, SolveError> {
        let angle = self.angle(bars)?;
        Ok(match self {
            Self::Least => T::num(FRAC_PI_4) - angle,
            Self::Largest => angle - T::num(3.0 * FRAC_PI_4),
        })
    }
}
