//! The panels that a way along an input is walked in, before any is divided.

/// Panels of a way of up to a turn.
const LEAST: u32 = 16;

/// The longest panel, in the input's unit: a sixteenth of a turn is 0.393 rad. The clearances of a
/// machine whose crank is the input repeat after a turn, and longer panels may step over a part of each.
const LONGEST: f64 = 0.4;

/// Panels of no more than that length, at most: 34 turns. A function that repeats in each turn
/// has either no zero at all or more zeros there than an answer may have.
const MOST: u32 = 535;

/// Panels over a way: equal ones, and where these would be more than [`MOST`], so many of the longest,
/// and [`LEAST`] over the rest.
#[derive(Clone, Copy, Debug)]
pub(super) struct Panels {
    /// The part of the way of each of the first.
    step: f64,
    /// The number of these panels.
    first: u32,
    /// The number of panels over the rest.
    rest: u32,
}

impl Panels {
    /// The panels of a way over which the input changes by so much.
    pub(super) fn over(length: f64) -> Self {
        if length > LONGEST * f64::from(MOST) {
            return Self { step: LONGEST / length, first: MOST, rest: LEAST };
        }
        // Rounded up; a negative number or none is zero.
        let needed = (length / LONGEST) as u32 + 1;
        let first = needed.clamp(LEAST, MOST);
        Self { step: 1.0 / f64::from(first), first, rest: 0 }
    }

    /// The part of the way at which each ends, the last at 1, with the part that it is long.
    pub(super) fn ends(self) -> impl Iterator<Item = [f64; 2]> {
        let Self { step, first, rest } = self;
        let walked = step * f64::from(first);
        let rest_step = (1.0 - walked) / f64::from(rest.max(1));
        let of_rest = move |panel| [walked + rest_step * f64::from(panel), rest_step];
        let ends = (1..=first).map(move |panel| [step * f64::from(panel), step]);
        let last = first + rest;
        ends.chain((1..=rest).map(of_rest))
            .zip(1..=last)
            .map(move |([end, long], panel)| [if panel == last { 1.0 } else { end }, long])
    }
}
