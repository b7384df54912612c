//! What a solver costs, counted in the generated code.

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

/// What a solver costs, as `COST` of the generated struct states it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Cost {
    /// Of `position`.
    pub position: Operations,
    /// Of `motion`: position, velocity and acceleration together.
    pub motion: Operations,
    /// Of `coefficients`.
    pub coefficients: Operations,
}

/// What a solver with masses or loads costs, as `COST` of the generated struct states it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ForcesCost {
    /// Of `position`.
    pub position: Operations,
    /// Of `motion`: position, velocity and acceleration together.
    pub motion: Operations,
    /// Of `coefficients`.
    pub coefficients: Operations,
    /// Of `forces`.
    pub forces: Operations,
    /// Of `statics`.
    pub statics: Operations,
    /// Of `energy`; nothing where it is not asked for.
    pub energy: Operations,
    /// Of `forward_dynamics`; nothing where an input moves no mass.
    pub forward_dynamics: Operations,
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
        assert!(
            cost.to_string().ends_with("; coefficients: 0 add, 0 mul, 0 div, 0 sqrt, 0 sin/cos")
        );
    }
}
