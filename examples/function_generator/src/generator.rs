//! The crank-rocker that generates a function, as a mechanism and as an optimisation problem.
//!
//! With a crank of 1 and a ground of 5 the rocker shall turn, over the first 90° of crank after
//! its right-hand limit, as ψ = ψ₀ + 2/(3π) (φ − φ₀)², and the transmission angle shall stay
//! between 45° and 135°. Unknown are the lengths of coupler and rocker.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

use linkage_core::{SolveError, mechanism};

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

/// A number and its derivatives by the two lengths.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sloped {
    pub(crate) value: f64,
    pub(crate) slope: Lengths,
}

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

/// The sum of squared errors over all steps.
pub(crate) fn objective(lengths: Lengths) -> Result<f64, SolveError> {
    steps().map(|turn| Ok(error(lengths, turn)?.powi(2))).sum()
}

/// The objective with its exact gradient.
pub(crate) fn sloped_objective([coupler, rocker]: Lengths) -> Result<Sloped, SolveError> {
    let generator = FunctionGenerator { coupler, rocker };
    let mut sum = Sloped { value: 0.0, slope: [0.0; 2] };
    for turn in steps() {
        let error = generator.position(turn)?.error.angle();
        let slopes = generator.sensitivity(turn)?;
        sum.value += error * error;
        for length in 0..2 {
            sum.slope[length] += 2.0 * error * slopes[(0, length)];
        }
    }
    Ok(sum)
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

    fn crank_angle(self) -> f64 {
        match self {
            Self::Least => 0.0,
            Self::Largest => PI,
        }
    }

    /// The transmission angle there.
    pub(crate) fn angle(self, [coupler, rocker]: Lengths) -> Result<f64, SolveError> {
        let bars = Transmission { coupler, rocker };
        Ok(bars.position(self.crank_angle())?.transmission.angle())
    }

    /// The excess of the transmission angle over its limit: an optimum has at most zero.
    pub(crate) fn excess(self, lengths: Lengths) -> Result<f64, SolveError> {
        let angle = self.angle(lengths)?;
        Ok(match self {
            Self::Least => FRAC_PI_4 - angle,
            Self::Largest => angle - 3.0 * FRAC_PI_4,
        })
    }

    /// The excess with its exact gradient.
    pub(crate) fn sloped_excess(self, lengths: Lengths) -> Result<Sloped, SolveError> {
        let [coupler, rocker] = lengths;
        let slopes = Transmission { coupler, rocker }.sensitivity(self.crank_angle())?;
        let sign = if self == Self::Least { -1.0 } else { 1.0 };
        let slope = [sign * slopes[(0, 0)], sign * slopes[(0, 1)]];
        Ok(Sloped { value: self.excess(lengths)?, slope })
    }
}
