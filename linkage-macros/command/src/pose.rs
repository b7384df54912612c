//! The conditions of a pose that no generated code computes: those of the run-time's slow path, by their names.

use linkage_compiler::{Conditions, GuardedValue, SoughtRoot};
use linkage_core::SolveError;
use linkage_core::private::{
    Certified, Checks, FirstError, Moving, Nonzero, NotNegative, Positive, ReachCircles,
    ReachDistances, ReachLine, ReachOffset, ShareOfCentres, Square, SquareOfCentres, Trend, bound,
    root, root_within_a_turn,
};

/// The first condition that is not met, if there is one.
pub(crate) struct PoseConditions {
    first: FirstError,
}

impl PoseConditions {
    pub(crate) fn new() -> Self {
        Self { first: FirstError::new() }
    }

    /// # Errors
    /// The condition that is not met.
    pub(crate) fn first(self) -> Result<(), SolveError> {
        self.first.first()
    }
}

impl Conditions for PoseConditions {
    fn guard(&mut self, condition: &GuardedValue<'_>) -> f64 {
        let &GuardedValue { kind, group, word, value, operands, .. } = condition;
        let (first, group, word) = (&mut self.first, lasting(group), lasting(word));
        match kind {
            "ReachCircles" => first.guard(value, ReachCircles(array(operands), group)),
            "ShareOfCentres" => first.guard(value, ShareOfCentres(array(operands), group)),
            "ReachDistances" => first.guard(value, ReachDistances(array(operands), group)),
            "ReachLine" => first.guard(value, ReachLine(array(operands), group)),
            "ReachOffset" => first.guard(value, ReachOffset(array(operands), group)),
            "SquareOfCentres" => first.guard(value, SquareOfCentres(array(operands), group)),
            "Certified" => first.guard(value, Certified(group)),
            "Moving" => first.guard(value, Moving(array(operands), group)),
            "Nonzero" => first.guard(value, Nonzero(group)),
            "Square" => first.guard(value, Square(group)),
            "Positive" => first.guard(value, Positive(group, word)),
            "NotNegative" => first.guard(value, NotNegative(group, word)),
            _ => unreachable!("the compiler has a row for each condition"),
        }
    }

    fn closed(&mut self, condition: &GuardedValue<'_>) {
        let &GuardedValue { group, word, value, operands: &[size], .. } = condition else {
            unreachable!("an equation has the size of its sides")
        };
        self.first.closed(value, size, lasting(group), lasting(word));
    }

    fn root(
        &mut self,
        sought: &SoughtRoot<'_>,
        sides: &mut dyn FnMut(f64) -> [f64; 3],
    ) -> [f64; 2] {
        let find = if sought.checks_span_at_run_time { root_within_a_turn } else { root };
        // Numbers without derivatives ask for no root of plain ones.
        let plain = || unreachable!("these are plain numbers");
        let found = find(sought.between, trend(sought), sought.near, plain, sides);
        let (at, size) = self.first.root(found, lasting(sought.unknown), lasting(sought.unit));
        [at, size]
    }

    fn bound(
        &mut self,
        sought: &SoughtRoot<'_>,
        end: usize,
        sides: &mut dyn FnMut(f64) -> [f64; 3],
    ) -> [f64; 2] {
        bound(sought.between, trend(sought), end, sides).into()
    }
}

fn trend(sought: &SoughtRoot<'_>) -> Trend {
    if sought.rises { Trend::Rising } else { Trend::Falling }
}

fn array<const N: usize>(operands: &[f64]) -> [f64; N] {
    operands.try_into().expect("a condition has the operands of its row")
}

/// The text for as long as the program runs, which draws a few machines and ends.
pub(crate) fn lasting(text: &str) -> &'static str {
    Box::leak(text.into())
}
