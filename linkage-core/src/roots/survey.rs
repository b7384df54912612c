//! A look at all of an interval, where the ends alone do not enclose a root.
//!
//! Samples divide the interval into pieces, the widest of which is halved again and again until two
//! samples enclose a root, or until every piece is clear: the cubic of its ends shows that the function
//! does not rise through zero there, by more than the cubic's error. The error follows from the sample
//! that halved the piece before it. Where neither happens in time, the answer is that it is not
//! known.

use super::FindError;
use super::approach::{At, greater, magnitude, middle, number};
use super::cubic::Cubic;
use super::equation::Equation;
use super::lowest::{dead_point_most, lowest};
use crate::Real;

/// The course of a function between two ends.
#[derive(Clone, Copy, Debug)]
pub(super) enum Course<T> {
    /// It rises through zero between these two.
    Rises([At<T>; 2]),
    /// It is zero here and does not fall.
    Zero(At<T>),
    /// It does not rise through zero.
    Never {
        /// The dead point at which it comes nearest to doing so, if there is one.
        nearest: Option<At<T>>,
        /// Between these two it falls through zero; one and the same where it is zero there.
        falls: Option<[At<T>; 2]>,
    },
    /// More turns than the samples can tell apart.
    Unknown,
}

/// The most samples.
const MOST: usize = 48;

/// A piece wider than this part of the interval is halved whatever its cubic shows: a cubic and one sample
/// can agree by chance with a function that turns several times. Of 200,000 sums of sines with up to six
/// dead points 16 were judged wrongly without this rule, none with pieces of a quarter.
const WIDEST: f64 = 0.125;

/// A sample, and the piece from it to the next.
#[derive(Clone, Copy, Debug)]
struct Piece<T> {
    from: At<T>,
    /// A bound on the error of the piece's cubic; NaN until a sample gives one.
    error: T,
    /// True if the function is known not to rise through zero.
    is_clear: bool,
}

/// The pieces in order, the last of no width.
struct Survey<T> {
    pieces: [Piece<T>; MOST],
    count: usize,
    /// The widest piece that is believed to be what its cubic is.
    widest: T,
}

/// Finds the course of the function between the first and the last of the places, which are in rising
/// order, with at most so many further samples.
///
/// # Errors
/// `NotFinite` where it is not a number.
pub(super) fn survey<T: Real>(
    f: &mut Equation<'_, T>,
    places: [At<T>; 4],
    most: u32,
) -> Result<Course<T>, FindError> {
    let mut survey = Survey::new(places);
    let end = f.evaluations().saturating_add(most);
    let left = |f: &Equation<'_, T>| end.saturating_sub(f.evaluations());
    loop {
        if let Some(course) = survey.root() {
            return Ok(course);
        }
        let Some((index, open)) = survey.widest() else { break };
        if left(f) == 0 || survey.count == MOST {
            return Ok(Course::Unknown);
        }
        if let Some(sign) = open.only_turn().filter(|_| survey.is_narrow(open.ends)) {
            let at = extreme(f, open.ends, sign, left(f))?;
            if at.value.value() == 0.0 {
                return Ok(Course::Zero(at));
            }
            survey.insert(index, Piece { from: at, error: number(0.0), is_clear: true });
            continue;
        }
        let [a, b] = open.ends;
        let x = middle([a.x, b.x]);
        if !(x.gt(a.x) && b.x.gt(x)) {
            // The ends are neighbouring numbers, so their signs say everything.
            survey.clear(index);
            continue;
        }
        let at = f.at(x)?;
        let error = open.remainder_of_halves(at);
        survey.insert(index, Piece { from: at, error, is_clear: false });
    }
    let nearest = match survey.nearest() {
        Some((ends, sign)) if left(f) > 1 => Some((extreme(f, ends, sign, left(f))?, sign)),
        _ => None,
    };
    match nearest {
        // The cubic that had shown the contrary was wrong.
        Some((at, sign)) if number::<T>(0.0).gt(sign * at.value) => Ok(Course::Unknown),
        nearest => Ok(Course::Never { nearest: nearest.map(|(at, _)| at), falls: survey.falls() }),
    }
}

/// The lowest point of a dip (`sign` 1), or the highest of a hump (−1), or the first place beyond zero.
fn extreme<T: Real>(
    f: &mut Equation<'_, T>,
    ends: [At<T>; 2],
    sign: T,
    most: u32,
) -> Result<At<T>, FindError> {
    let turned = |at: At<T>| At { value: sign * at.value, slope: sign * at.slope, ..at };
    // One more sample may be taken than asked for.
    let most = dead_point_most::<T>().min(most.saturating_sub(1));
    lowest(ends.map(turned), number(0.0), most, &mut |x| f.at(x).map(turned)).map(turned)
}

/// A piece between two samples.
struct Open<T> {
    ends: [At<T>; 2],
    error: T,
}

impl<T: Real> Open<T> {
    /// A bound on the errors of the cubics of both halves, from the sample in the middle.
    ///
    /// The remainder of the cubic through values and slopes of both ends is f⁗ u² (1 − u)² w⁴/24: halving
    /// the width divides it by 16. In the middle it is the greatest, and has no slope; a remainder that is
    /// odd about the middle shows by its slope, of which it is at most a seventh. A remainder that is not
    /// divided at all allows for a fourth derivative that is 16 times as large in one half.
    fn remainder_of_halves(&self, middle: At<T>) -> T {
        let ([a, b], cubic, half) = (self.ends, Cubic::through(self.ends), number(0.5));
        let off = magnitude(cubic.at(half) - middle.value);
        off + magnitude(cubic.slope_at(half) - middle.slope * (b.x - a.x)) * number(0.25)
    }

    /// True if the function does not rise through zero here: it keeps its sign, or it falls all the way, or
    /// it rises all the way from above zero or to below it, or it bends one way all the way and is below
    /// zero at an end of a sagging piece, above zero at one of an arched piece, or has no turn.
    fn is_clear(&self) -> bool {
        let [a, b] = self.ends;
        let zero = number::<T>(0.0);
        let cubic = Cubic::through(self.ends);
        // Rounding of the values, that of the equation's sides left aside.
        let rounding = greater(magnitude(a.value), magnitude(b.value)) * number(4.0 * T::EPSILON);
        let error = self.error + rounding;
        let above = |least: T, numbers: &[T]| numbers.iter().all(|&number| number.gt(least));
        let below = |least: T, numbers: &[T]| numbers.iter().all(|&number| (-least).gt(number));
        let values = cubic.values_within();
        if above(error, &values) || below(error, &values) {
            return true;
        }
        let slopes = cubic.slopes_within();
        let least = error * number(SLOPE);
        let ends = [a.value, b.value];
        if below(least, &slopes)
            || above(least, &slopes) && (above(zero, &ends) || below(zero, &ends))
        {
            return true;
        }
        let Some(sign) = self.bends() else { return false };
        // A dip between values above zero, or a hump between values below it, may reach beyond.
        let is_beyond = |at: At<T>| zero.gt(sign * at.value);
        is_beyond(a) || is_beyond(b) || !self.turns(sign)
    }

    /// Which way it bends, if it is one way throughout: 1 for the dip, −1 for the hump.
    fn bends(&self) -> Option<T> {
        let least = self.error * number(CURVATURE);
        let [first, second] = Cubic::through(self.ends).curvatures();
        match () {
            () if first.gt(least) && second.gt(least) => Some(number(1.0)),
            () if (-least).gt(first) && (-least).gt(second) => Some(number(-1.0)),
            () => None,
        }
    }

    /// True if there is a dip (`sign` 1) or a hump (−1).
    fn turns(&self, sign: T) -> bool {
        let ([a, b], zero) = (self.ends, number::<T>(0.0));
        zero.gt(sign * a.slope) && (sign * b.slope).gt(zero)
    }

    /// The dip or the hump that is all there is in a piece.
    fn only_turn(&self) -> Option<T> {
        self.bends().filter(|&sign| self.turns(sign))
    }
}

/// The slope of the remainder is at most √3/216 · 384 times as large as the remainder, by the part of the
/// way; its second derivative is 32 times as large.
const SLOPE: f64 = 3.1;
const CURVATURE: f64 = 32.0;

impl<T: Real> Survey<T> {
    fn new(places: [At<T>; 4]) -> Self {
        let piece = |from| Piece { from, error: number(f64::NAN), is_clear: false };
        let [first, .., end] = places;
        let widest = (end.x - first.x) * number(WIDEST * (1.0 + 4.0 * <T as Real>::EPSILON));
        let mut survey = Self { pieces: [piece(first); MOST], count: 1, widest };
        let mut last = first;
        for place in places {
            if place.x.gt(last.x) {
                survey.insert(survey.count - 1, piece(place));
                last = place;
            }
        }
        survey
    }

    /// Divides the piece of this index: both parts are known as well as the new one.
    fn insert(&mut self, index: usize, new: Piece<T>) {
        let mut carried = new;
        for place in self.pieces.iter_mut().take(self.count + 1).skip(index + 1) {
            core::mem::swap(place, &mut carried);
        }
        self.count = MOST.min(self.count + 1);
        if let Some(divided) = self.pieces.get_mut(index) {
            (divided.error, divided.is_clear) = (new.error, new.is_clear);
        }
        let mut next = None;
        for piece in self.pieces.iter_mut().take(self.count).skip(index).take(3).rev() {
            if let Some(next) = next.replace(piece.from) {
                let open = Open { ends: [piece.from, next], error: piece.error };
                let is_narrow = self.widest.ge(next.x - piece.from.x);
                piece.is_clear = piece.is_clear || is_narrow && open.is_clear();
            }
        }
    }

    fn clear(&mut self, index: usize) {
        if let Some(piece) = self.pieces.get_mut(index) {
            piece.is_clear = true;
        }
    }

    /// The pieces, with their ends.
    fn all(&self) -> impl Iterator<Item = (&Piece<T>, [At<T>; 2])> {
        let pieces = self.pieces.iter().take(self.count);
        pieces
            .clone()
            .zip(pieces.clone().skip(1))
            .map(|(piece, next)| (piece, [piece.from, next.from]))
    }

    /// The widest of the pieces that are not clear, and its index.
    fn widest(&self) -> Option<(usize, Open<T>)> {
        let width = |ends: [At<T>; 2]| ends[1].x - ends[0].x;
        let mut widest: Option<(usize, Open<T>)> = None;
        for (index, (piece, ends)) in self.all().enumerate() {
            let is_widest = widest.as_ref().is_none_or(|(_, of)| width(ends).gt(width(of.ends)));
            if !piece.is_clear && is_widest {
                widest = Some((index, Open { ends, error: piece.error }));
            }
        }
        widest
    }

    fn is_narrow(&self, ends: [At<T>; 2]) -> bool {
        self.widest.ge(ends[1].x - ends[0].x)
    }

    /// Two samples that enclose a root, or a sample that is one.
    fn root(&self) -> Option<Course<T>> {
        let zero = number::<T>(0.0);
        let mut low = None;
        for at in self.pieces.iter().take(self.count).map(|piece| piece.from) {
            if at.value.value() == 0.0 && at.slope.gt(zero) {
                return Some(Course::Zero(at));
            }
            match low {
                Some(low) if at.value.gt(zero) => return Some(Course::Rises([low, at])),
                _ if zero.gt(at.value) => low = Some(at),
                _ => {}
            }
        }
        None
    }

    /// Two samples between which the function falls through zero, or twice the one at which it does.
    fn falls(&self) -> Option<[At<T>; 2]> {
        let zero = number::<T>(0.0);
        let mut high = None;
        for at in self.pieces.iter().take(self.count).map(|piece| piece.from) {
            if at.value.value() == 0.0 && zero.gt(at.slope) {
                return Some([at; 2]);
            }
            match high {
                Some(high) if zero.gt(at.value) => return Some([high, at]),
                _ if at.value.gt(zero) => high = Some(at),
                _ => {}
            }
        }
        None
    }

    /// The dip or the hump that comes nearest to zero by its cubic, and which it is.
    fn nearest(&self) -> Option<([At<T>; 2], T)> {
        let zero = number::<T>(0.0);
        let mut nearest: Option<([At<T>; 2], T, T)> = None;
        for (_, ends) in self.all() {
            let sign = number::<T>(if ends[0].value.gt(zero) { 1.0 } else { -1.0 });
            let turned = ends.map(|at| At { value: sign * at.value, slope: sign * at.slope, ..at });
            let [a, b] = turned;
            let is_turn = zero.gt(a.slope) && b.slope.gt(zero) && b.value.gt(zero);
            let cubic = Cubic::through(turned);
            let least = cubic.at(cubic.turning_part());
            if is_turn && nearest.is_none_or(|(.., other)| other.gt(least)) {
                nearest = Some((ends, sign, least));
            }
        }
        nearest.map(|(ends, sign, _)| (ends, sign))
    }
}

/// True if a piece is clear, 1 or −1 for its only turn and zero for none, and the error of its halves by the sample in
/// the middle: beside what the script of a page finds.
#[cfg(all(test, feature = "page"))]
pub(crate) fn judged(ends: [At<f64>; 2], error: f64, middle: At<f64>) -> (bool, f64, f64) {
    let open = Open { ends, error };
    (open.is_clear(), open.only_turn().unwrap_or(0.0), open.remainder_of_halves(middle))
}

/// The course between the first and the last of the places in a word, with the samples that it names, and the
/// evaluations: beside what the script of a page finds.
#[cfg(all(test, feature = "page"))]
pub(crate) fn surveyed(
    mut f: impl FnMut(f64) -> [f64; 2],
    places: [f64; 4],
    most: u32,
) -> (&'static str, std::vec::Vec<At<f64>>, u32) {
    let mut f = Equation::new(&mut f, super::Trend::Rising);
    let places = places.map(|x| f.at(x).expect("it is a number everywhere"));
    let (word, met) = match survey(&mut f, places, most).expect("it is a number everywhere") {
        Course::Rises(ends) => ("rises", ends.into()),
        Course::Zero(at) => ("zero", std::vec![at]),
        Course::Never { nearest, falls } => {
            ("never", nearest.into_iter().chain(falls.into_iter().flatten()).collect())
        }
        Course::Unknown => ("unknown", std::vec![]),
    };
    (word, met, f.evaluations())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The remainder of both halves is estimated too large rather than too small, for a power that is even
    /// about the middle and for one that is odd.
    #[test]
    fn cubics_of_halves_are_no_further_off_than_is_said() {
        for power in [4, 5, 6, 7] {
            for [from, to] in [[-1.0, 1.0], [-0.7, 1.1], [0.0, 1.0]] {
                let f = |x: f64| At {
                    x,
                    value: x.powi(power),
                    slope: f64::from(power) * x.powi(power - 1),
                };
                let middle = f(0.5 * (from + to));
                let whole = Open { ends: [f(from), f(to)], error: f64::NAN };
                let said = whole.remainder_of_halves(middle);
                for ends in [[f(from), middle], [middle, f(to)]] {
                    let off = |part: f64| {
                        let x = ends[0].x + (ends[1].x - ends[0].x) * part;
                        (Cubic::through(ends).at(part) - f(x).value).abs()
                    };
                    let most = (1..100).map(|step| off(0.01 * f64::from(step))).fold(0.0, f64::max);
                    assert!(most <= said && said <= 300.0 * most, "{power} {from} {most} {said}");
                }
            }
        }
    }
}
