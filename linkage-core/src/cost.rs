//! The cost of a solver, counted in the generated code.

use core::fmt;

/// Floating-point operations of one evaluation.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Operations {
    /// Additions and subtractions.
    pub additions: u32,
    /// Multiplications.
    pub multiplications: u32,
    /// Divisions.
    pub divisions: u32,
    /// Square roots.
    pub roots: u32,
    /// Sine and cosine pairs, and other transcendental functions.
    pub sines: u32,
}

/// The cost of a solver, as `COST` of the generated struct states it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Cost {
    /// One call of `position`.
    pub position: Operations,
    /// One call of `motion`: position, velocity and acceleration together.
    pub motion: Operations,
    /// One call of `coefficients`.
    pub coefficients: Operations,
}

/// The cost of a solver with masses or loads, as `COST` of the generated struct states it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ForcesCost {
    /// One call of `position`.
    pub position: Operations,
    /// One call of `motion`: position, velocity and acceleration together.
    pub motion: Operations,
    /// One call of `coefficients`.
    pub coefficients: Operations,
    /// One call of `forces`.
    pub forces: Operations,
    /// One call of `statics`.
    pub statics: Operations,
    /// One call of `energy`; nothing where it is not asked for.
    pub energy: Operations,
    /// One call of `forward_dynamics`; nothing where an input moves no mass.
    pub forward_dynamics: Operations,
}

/// The cost of finding one unknown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SearchCost {
    /// The unknown; of a drawing, the links for which it was put.
    pub unknown: &'static str,
    /// One evaluation of its equation and of the slope of that.
    pub evaluation: Operations,
    /// The most evaluations of one call in `f64`, from both ends; twice as many where an end lies
    /// beyond a dead point, and three more where there is a seed.
    pub evaluations: u32,
    /// The same in `f32`.
    pub evaluations_f32: u32,
}

/// The cost of a solver with unknowns, as `COST` of the generated struct states it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SearchingCost {
    /// One call of `position`, but for the searches.
    pub position: Operations,
    /// One call of `motion`: position, velocity and acceleration together, but for the searches.
    pub motion: Operations,
    /// One call of `coefficients`, but for the searches.
    pub coefficients: Operations,
    /// Each unknown, in any of these.
    pub searches: &'static [SearchCost],
}

/// The cost of a solver with unknowns and with masses or loads, as `COST` of the generated struct
/// states it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SearchingForcesCost {
    /// One call of `position`, but for the searches.
    pub position: Operations,
    /// One call of `motion`: position, velocity and acceleration together, but for the searches.
    pub motion: Operations,
    /// One call of `coefficients`, but for the searches.
    pub coefficients: Operations,
    /// One call of `forces`, but for the searches.
    pub forces: Operations,
    /// One call of `statics`, but for the searches.
    pub statics: Operations,
    /// One call of `energy`, but for the searches; nothing where it is not asked for.
    pub energy: Operations,
    /// One call of `forward_dynamics`, but for the searches; nothing where an input moves no mass.
    pub forward_dynamics: Operations,
    /// Each unknown, in any of these.
    pub searches: &'static [SearchCost],
}

impl Operations {
    /// All operations, each counted once whatever it costs.
    #[must_use]
    pub const fn total(self) -> u32 {
        self.additions + self.multiplications + self.divisions + self.roots + self.sines
    }
}

impl fmt::Display for Operations {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "{} add, {} mul, {} div, {} sqrt, {} sin/cos",
            self.additions, self.multiplications, self.divisions, self.roots, self.sines
        )
    }
}

impl fmt::Display for Cost {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "position: {}; motion: {}; coefficients: {}",
            self.position, self.motion, self.coefficients
        )
    }
}

impl fmt::Display for ForcesCost {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { position, motion, coefficients, forces, statics, energy, forward_dynamics } =
            *self;
        let motion = Cost { position, motion, coefficients };
        write!(f, "{motion}; forces: {forces}; statics: {statics}; energy: {energy}; ")?;
        write!(f, "forward dynamics: {forward_dynamics}")
    }
}

impl fmt::Display for SearchCost {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { unknown, evaluation, evaluations, evaluations_f32 } = self;
        write!(f, "{unknown}: up to {evaluations} (f32: {evaluations_f32}) times {evaluation}")
    }
}

impl fmt::Display for SearchingCost {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { position, motion, coefficients, searches } = *self;
        write!(f, "{}", Cost { position, motion, coefficients })?;
        searches.iter().try_for_each(|search| write!(f, "; {search}"))
    }
}

impl fmt::Display for SearchingForcesCost {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { position, motion, coefficients, forces, statics, energy, .. } = *self;
        let Self { forward_dynamics, searches, .. } = *self;
        let closed = ForcesCost {
            position,
            motion,
            coefficients,
            forces,
            statics,
            energy,
            forward_dynamics,
        };
        write!(f, "{closed}")?;
        searches.iter().try_for_each(|search| write!(f, "; {search}"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::string::ToString;

    #[test]
    fn a_cost_reads_as_a_list_of_operations() {
        let position =
            Operations { additions: 20, multiplications: 31, divisions: 2, roots: 1, sines: 1 };
        assert_eq!(position.to_string(), "20 add, 31 mul, 2 div, 1 sqrt, 1 sin/cos");
        assert_eq!(position.total(), 55);
        let cost = Cost { position, ..Cost::default() };
        assert!(cost.to_string().starts_with("position: 20 add"));
        const SEARCHES: &[SearchCost] = &[SearchCost {
            unknown: "theta",
            evaluation: Operations { additions: 3, ..Operations { sines: 1, ..EMPTY } },
            evaluations: 61,
            evaluations_f32: 32,
        }];
        const EMPTY: Operations =
            Operations { additions: 0, multiplications: 0, divisions: 0, roots: 0, sines: 0 };
        let motion = Operations::default();
        let searching =
            SearchingCost { position, motion, coefficients: motion, searches: SEARCHES };
        let words = "; theta: up to 61 (f32: 32) times 3 add, 0 mul, 0 div, 0 sqrt, 1 sin/cos";
        assert!(searching.to_string().ends_with(words), "{searching}");
        let of_forces = SearchingForcesCost {
            position,
            motion,
            coefficients: motion,
            forces: position,
            statics: motion,
            energy: motion,
            forward_dynamics: motion,
            searches: SEARCHES,
        };
        assert!(of_forces.to_string().contains("; forces: 20 add"), "{of_forces}");
        assert!(of_forces.to_string().ends_with(words), "{of_forces}");
        assert!(
            cost.to_string().ends_with("; coefficients: 0 add, 0 mul, 0 div, 0 sqrt, 0 sin/cos")
        );
    }
}
