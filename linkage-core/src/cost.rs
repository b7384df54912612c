//! The cost of a solver, counted in the generated code.

use core::fmt;

/// Floating-point operations of one evaluation.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
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

/// The cost of a solver, as `COST` of the generated struct states it. Searches of unknowns are not
/// part of the entry points' operations: they stand beside them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Cost {
    /// One call of `position`.
    pub position: Operations,
    /// One call of `motion`: position, velocity and acceleration together.
    pub motion: Operations,
    /// One call of `coefficients`.
    pub coefficients: Operations,
    /// One call of `forces`; nothing where there are no masses or loads.
    pub forces: Operations,
    /// One call of `statics`; nothing where there are no masses or loads.
    pub statics: Operations,
    /// One call of `energy`; nothing where it is not asked for.
    pub energy: Operations,
    /// One call of `forward_dynamics`; nothing where an input moves no mass.
    pub forward_dynamics: Operations,
    /// Each unknown, in any of these.
    pub searches: &'static [SearchCost],
}

/// The cost of finding one unknown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
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

/// The operations of one entry point as generated code states them: additions, multiplications,
/// divisions, roots and sines.
type Counts = [u32; 5];

/// The cost of a solver: `position`, `motion` and `coefficients`, and with masses or loads `forces`,
/// `statics`, `energy` and `forward_dynamics`.
#[must_use]
pub const fn cost(points: &[Counts], searches: &'static [SearchCost]) -> Cost {
    Cost {
        position: nth(points, 0),
        motion: nth(points, 1),
        coefficients: nth(points, 2),
        forces: nth(points, 3),
        statics: nth(points, 4),
        energy: nth(points, 5),
        forward_dynamics: nth(points, 6),
        searches,
    }
}

/// The cost of an unknown: of one evaluation, and the most evaluations in `f64` and in `f32`.
#[must_use]
pub const fn search_cost(unknown: &'static str, of_one: Counts, most: [u32; 2]) -> SearchCost {
    let [evaluations, evaluations_f32] = most;
    SearchCost { unknown, evaluation: operations(of_one), evaluations, evaluations_f32 }
}

/// The operations at a place of a list; none beyond its end.
const fn nth(points: &[Counts], place: usize) -> Operations {
    operations(if place < points.len() { points[place] } else { [0; 5] })
}

const fn operations(counts: Counts) -> Operations {
    let [additions, multiplications, divisions, roots, sines] = counts;
    Operations { additions, multiplications, divisions, roots, sines }
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
        let Self { position, motion, coefficients, .. } = self;
        write!(f, "position: {position}; motion: {motion}; coefficients: {coefficients}")?;
        let of_forces = [
            ("forces", self.forces),
            ("statics", self.statics),
            ("energy", self.energy),
            ("forward dynamics", self.forward_dynamics),
        ];
        for (name, cost) in of_forces.into_iter().filter(|(_, cost)| cost.total() > 0) {
            write!(f, "; {name}: {cost}")?;
        }
        self.searches.iter().try_for_each(|search| write!(f, "; {search}"))
    }
}

impl fmt::Display for SearchCost {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { unknown, evaluation, evaluations, evaluations_f32 } = self;
        write!(f, "{unknown}: up to {evaluations} (f32: {evaluations_f32}) times {evaluation}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::string::ToString;

    #[test]
    fn a_cost_reads_as_a_list_of_operations() {
        const BARE: Cost = cost(&[[20, 31, 2, 1, 1], [0; 5], [0; 5]], &[]);
        assert_eq!(BARE.position.to_string(), "20 add, 31 mul, 2 div, 1 sqrt, 1 sin/cos");
        assert_eq!(BARE.position.total(), 55);
        assert_eq!(
            BARE.to_string(),
            "position: 20 add, 31 mul, 2 div, 1 sqrt, 1 sin/cos; \
             motion: 0 add, 0 mul, 0 div, 0 sqrt, 0 sin/cos; \
             coefficients: 0 add, 0 mul, 0 div, 0 sqrt, 0 sin/cos"
        );
    }

    #[test]
    fn each_entry_point_has_its_own_operations() {
        const SEARCHES: &[SearchCost] = &[search_cost("theta", [3, 0, 0, 0, 1], [61, 32])];
        const ALL: Cost =
            cost(&[[1; 5], [2; 5], [3; 5], [4; 5], [5; 5], [0; 5], [7, 8, 9, 10, 11]], SEARCHES);
        let totals =
            [ALL.position, ALL.motion, ALL.coefficients, ALL.forces, ALL.statics, ALL.energy]
                .map(Operations::total);
        assert_eq!(totals, [5, 10, 15, 20, 25, 0]);
        let words = ALL.to_string();
        assert!(!words.contains("energy"), "{words}");
        assert!(
            words.ends_with(
                "statics: 5 add, 5 mul, 5 div, 5 sqrt, 5 sin/cos; \
                 forward dynamics: 7 add, 8 mul, 9 div, 10 sqrt, 11 sin/cos; \
                 theta: up to 61 (f32: 32) times 3 add, 0 mul, 0 div, 0 sqrt, 1 sin/cos"
            ),
            "{words}"
        );
    }
}
