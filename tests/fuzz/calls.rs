//! The checks of every answer, and a record of what they found.

use std::collections::BTreeMap;
use std::fmt::{Debug, Write};

use linkage_core::private::{Entry, Series, sweep};
use linkage_core::{Record, SolveError, Status};

use super::numbers::Number;

/// The answers of all calls, and the mistakes found in them.
#[derive(Default)]
pub(crate) struct Calls {
    pub(crate) count: u64,
    /// Answers, and refusals of each kind.
    pub(crate) answers: BTreeMap<&'static str, u64>,
    /// The count of a mistake and its first case, by mechanism, entry point and kind of mistake.
    pub(crate) wrong: BTreeMap<String, (u64, String)>,
    /// The worst error, by mechanism, in half units in the last place of everything.
    pub(crate) worst: BTreeMap<String, f64>,
}

/// The calls at one state.
pub(crate) struct At<'a> {
    pub(crate) calls: &'a mut Calls,
    pub(crate) mechanism: &'a str,
    pub(crate) state: &'a dyn Debug,
}

pub(crate) fn kind_of(error: &SolveError) -> &'static str {
    match error {
        SolveError::OutOfReach { .. } => "OutOfReach",
        SolveError::Singular { .. } => "Singular",
        SolveError::Invalid { .. } => "Invalid",
        SolveError::NotFinite { .. } => "NotFinite",
        SolveError::OffCircle { .. } => "OffCircle",
        SolveError::NoSolution { .. } => "NoSolution",
        SolveError::SeveralDeadPoints { .. } => "SeveralDeadPoints",
        SolveError::Jams { .. } => "Jams",
        _ => "a kind that this program does not know",
    }
}

fn kind_of_status(status: Status) -> &'static str {
    match status {
        Status::Solved => "Ok",
        Status::OutOfReach => "OutOfReach",
        Status::Singular => "Singular",
        Status::Invalid => "Invalid",
        Status::NotFinite => "NotFinite",
        Status::OffCircle => "OffCircle",
        Status::NoSolution => "NoSolution",
        Status::SeveralDeadPoints => "SeveralDeadPoints",
        Status::Jams => "Jams",
        _ => "a status that this program does not know",
    }
}

impl At<'_> {
    pub(crate) fn wrong(&mut self, entry: &str, what: &str, found: &dyn Debug) {
        let key = format!("{}::{entry}: {what}", self.mechanism);
        let state = self.state;
        let (count, _) = self
            .calls
            .wrong
            .entry(key)
            .or_insert_with(|| (0, format!("{found:?}\n        at {state:?}")));
        *count += 1;
    }

    /// A call's answer: every number of it is finite, every refusal says by how much.
    pub(crate) fn answer<T: Number, R: AsRef<[T]>>(
        &mut self,
        entry: &str,
        answer: Result<R, SolveError>,
    ) -> Option<R> {
        self.calls.count += 1;
        let kind = answer.as_ref().map_or_else(kind_of, |_| "Ok");
        *self.calls.answers.entry(kind).or_default() += 1;
        if let Err(SolveError::OutOfReach { by, .. } | SolveError::NoSolution { by, .. }) = answer
            && (by < 0.0 || by.is_nan())
        {
            self.wrong(entry, "refused by what is no distance", &by);
        }
        let numbers = answer.ok()?;
        if !numbers.as_ref().iter().all(|number| number.value().is_finite()) {
            self.wrong(entry, "not finite, as Ok", &numbers.as_ref());
        }
        Some(numbers)
    }

    /// Checks that the function without a branch, where it reports that its result is usable, returns the
    /// same result.
    pub(crate) fn straight<T: Number, R: AsRef<[T]>>(
        &mut self,
        entry: &str,
        (numbers, usable): (R, bool),
        checked: Option<&R>,
    ) {
        self.calls.count += 1;
        if !usable {
            return;
        }
        match checked {
            Some(checked) if checked.as_ref() == numbers.as_ref() => {}
            Some(checked) => {
                let both = (numbers.as_ref(), checked.as_ref());
                self.wrong(entry, "not what the function with a branch answers", &both);
            }
            None => self.wrong(entry, "usable, where the other refuses", &numbers.as_ref()),
        }
    }

    /// Two declarations of one mechanism refuse the same poses: that is decided on joints and lengths,
    /// whatever the formulas are. Only what is too large or too small for one may not be for the other.
    pub(crate) fn alike<P, Q>(
        &mut self,
        entry: &str,
        found: &Result<P, SolveError>,
        twin: &Result<Q, SolveError>,
    ) {
        let both = [found.as_ref().err(), twin.as_ref().err()];
        let kinds = both.map(|error| error.map_or("Ok", kind_of));
        if kinds[0] != kinds[1] && !kinds.contains(&"NotFinite") {
            self.wrong(entry, "refused by one of two declarations", &both);
        }
    }

    /// A direction is a unit vector.
    pub(crate) fn unit<T: Number>(&mut self, entry: &str, [cos, sin]: [T; 2]) {
        let (x, y) = (cos.value(), sin.value());
        // Two squares that sum up to one, each factor wrong by a few units in its last place.
        if (x * x + y * y - 1.0).abs() > 32.0 * T::HALF_UNIT {
            self.wrong(entry, "a direction that is no unit vector", &(x, y, x.hypot(y) - 1.0));
        }
    }

    /// A sweep over poses answers as the single calls do.
    pub(crate) fn sweep<
        K,
        T: Number,
        E: Entry<K, T, IN, OUT>,
        R: Record<Array = [T; OUT]>,
        const IN: usize,
        const OUT: usize,
    >(
        &mut self,
        entry: &str,
        solver: &E,
        inputs: &[[T; IN]],
        singles: &[Result<R, SolveError>],
    ) {
        self.calls.count += 1;
        let columns: [Vec<T>; IN] =
            core::array::from_fn(|i| inputs.iter().map(|pose| pose[i]).collect());
        let mut outs: [Vec<T>; OUT] =
            core::array::from_fn(|_| vec![T::lit(0.0, 0.0); inputs.len()]);
        let mut statuses = vec![Status::Solved; inputs.len()];
        let series = core::array::from_fn(|i| Series::Each(&columns[i][..]));
        let swept =
            sweep(solver, series, outs.each_mut().map(|out| &mut out[..]), &mut statuses, ());
        if swept.is_err() {
            self.wrong(entry, "a mismatch of lengths", &swept);
        }
        for (pose, (status, single)) in statuses.iter().zip(singles).enumerate() {
            let expected = single.as_ref().map_or_else(kind_of, |_| "Ok");
            // With fused instructions a sweep may solve what the single call finds too large or
            // without a derivative; what it refuses, the single call has refused.
            let is_solved_by_fusing = *status == Status::Solved
                && matches!(
                    single,
                    Err(SolveError::NotFinite { .. } | SolveError::Singular { .. })
                );
            // It may say how a pose is refused where the single call could not make a product.
            let is_too_large = inputs[pose].iter().any(|input| input.value().abs() > T::SPLIT);
            let is_told_by_fusing = *status == Status::OutOfReach
                && matches!(single, Err(SolveError::NotFinite { .. }))
                && is_too_large;
            let is_fusing = is_solved_by_fusing || is_told_by_fusing;
            if kind_of_status(*status) != expected && !is_fusing {
                let found = (status, single.as_ref().err(), inputs[pose]);
                self.wrong(entry, "another status than the single call's", &found);
            }
            let numbers: Vec<T> = outs.iter().map(|out| out[pose]).collect();
            if *status == Status::Solved && !numbers.iter().all(|x| x.value().is_finite()) {
                self.wrong(entry, "not finite, as Solved", &numbers);
            }
        }
    }
}

impl Calls {
    pub(crate) fn report(&self, title: &str) -> String {
        let mut text = format!("{title}: {} calls\n", self.count);
        let mut line = |line: String| writeln!(text, "    {line}").expect("a string takes all");
        self.answers.iter().for_each(|(kind, count)| line(format!("{count:>12} {kind}")));
        self.worst
            .iter()
            .for_each(|(name, worst)| line(format!("{worst:>12.1} half units in {name}")));
        for (what, (count, first)) in &self.wrong {
            line(format!("{count} times {what}: {first}"));
        }
        text
    }
}
