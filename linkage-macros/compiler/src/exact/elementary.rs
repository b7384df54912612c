//! π, sine, cosine and angle of fixed-point numbers, with every error counted.
//!
//! An *ulp* is a unit of the fixed point in use, 2^−w. All cutting off rounds down and costs at
//! most one ulp.

use std::sync::{Mutex, PoisonError};

use num_bigint::BigInt;
use num_integer::{Integer, Roots};
use num_traits::{One, Signed, ToPrimitive, Zero};

use super::enclosure::Enclosure;
use crate::function::Function;

/// The finest π asked for so far; every function of an angle needs it.
static FINEST_PI: Mutex<Option<Enclosure>> = Mutex::new(None);

impl Enclosure {
    /// An enclosure of π.
    pub fn pi(bits: u32) -> Self {
        // It is replaced as a whole: a panic elsewhere does not spoil it.
        let mut finest = FINEST_PI.lock().unwrap_or_else(PoisonError::into_inner);
        match finest.as_ref() {
            Some(known) if known.bits() >= bits => known.with_bits(bits),
            _ => {
                let pi = machin(bits.next_power_of_two().max(512));
                finest.insert(pi).with_bits(bits)
            }
        }
    }

    /// The function of an atom, of all numbers of the enclosure; `None` where it has no value.
    pub fn apply(&self, function: Function) -> Option<Self> {
        match function {
            Function::Sin => Some(self.sin_cos().0),
            Function::Cos => Some(self.sin_cos().1),
            Function::Asin => self.asin(),
            Function::Atan => Some(self.atan()),
            _ => self.grown(function),
        }
    }

    /// Neither sine nor cosine changes faster than the angle: they are evaluated in the middle.
    pub fn sin_cos(&self) -> (Self, Self) {
        let (middle, radius) = self.middle();
        let (sin, cos) = sin_cos(&middle, self.bits);
        (sin.widened(&radius).within_one(), cos.widened(&radius).within_one())
    }

    /// The arc sine in [−π/2, π/2] of what lies in [−1, 1] of the enclosure, unless nothing does.
    pub fn asin(&self) -> Option<Self> {
        let one = BigInt::one() << self.bits;
        if self.lower > one || self.upper < -&one {
            return None;
        }
        let within = self.within_one();
        let below = asin(&within.lower, self.bits);
        if within.lower == within.upper {
            return Some(below);
        }
        let above = asin(&within.upper, self.bits);
        Some(Self::new(below.lower, above.upper, self.bits))
    }

    /// The arc tangent in [−π/2, π/2], which does not change faster than its argument either.
    pub fn atan(&self) -> Self {
        let (middle, radius) = self.middle();
        let one = BigInt::one() << self.bits;
        angle(&middle, &one, self.bits).widened(&radius)
    }

    /// The part of the enclosure in [−1, 1]; there is some.
    fn within_one(&self) -> Self {
        let one = BigInt::one() << self.bits;
        Self::new(self.lower.clone().max(-&one), self.upper.clone().min(one), self.bits)
    }
}

/// π = 16 atan(1/5) − 4 atan(1/239) (Machin 1706).
fn machin(bits: u32) -> Enclosure {
    let working = bits + 32;
    let (first, first_error) = inverse_arc_tangent(5, working);
    let (second, second_error) = inverse_arc_tangent(239, working);
    let error = BigInt::from(16 * first_error + 4 * second_error);
    Enclosure::around(&(first * 16 - second * 4), &error, working).with_bits(bits)
}

/// atan(1/n) by its series, and the error in ulp.
///
/// A power of 1/n is wrong by less than 2 ulp (what the previous one is wrong by, divided by n²,
/// and one), its share of the sum by one more. The tail is below twice the first power left out,
/// which is wrong by less than 2 ulp from zero.
fn inverse_arc_tangent(n: u32, working: u32) -> (BigInt, u64) {
    let mut power = (BigInt::one() << working) / n;
    let (mut sum, mut odd, mut terms) = (BigInt::zero(), 1_u32, 0_u64);
    while !power.is_zero() {
        let share = &power / odd;
        if terms.is_multiple_of(2) {
            sum += share
        } else {
            sum -= share
        }
        power /= n * n;
        odd += 2;
        terms += 1;
    }
    (sum, 3 * terms + 4)
}

/// Enclosures of the sine and the cosine of `angle`·2^−bits, a few ulp wide.
pub(super) fn sin_cos(angle: &BigInt, bits: u32) -> (Enclosure, Enclosure) {
    // Halving the angle shortens the series, doubling it again costs at most two bits a time.
    let halvings = bits.sqrt() / 2;
    let working = bits + 2 * halvings + 24;
    let (reduced, quarter_turns) = reduce(angle, bits, working);
    let (mut sin, mut cos, series_error) = series(&(reduced.abs() >> halvings), working);
    for _ in 0..halvings {
        // sin 2t = 2 sin t cos t, cos 2t = 1 − 2 sin² t. With both wrong by at most e, the first
        // is wrong by at most 2(|sin t| + |cos t|)e + 1 < 3e + 1 (the squares of e, far below an
        // ulp, included), and the second, as |sin t| < 0.4 here, by less than 2e + 1.
        let doubled = (&sin * &cos) >> (working - 1);
        cos = (BigInt::one() << working) - ((&sin * &sin) >> (working - 1));
        sin = doubled;
    }
    if reduced.is_negative() {
        sin = -sin;
    }
    // e ↦ 3e + 1 makes less than 4^h·(e + 1) of e in h steps; two more ulp from the reduction.
    let error = (BigInt::from(series_error + 1) << (2 * halvings)) + 2;
    let (sin, cos) = match quarter_turns {
        0 => (sin, cos),
        1 => (cos, -sin),
        2 => (-sin, -cos),
        _ => (-cos, sin),
    };
    let enclose = |value| Enclosure::around(&value, &error, working).with_bits(bits);
    (enclose(sin), enclose(cos))
}

/// The angle less the nearest multiple of π/2, at `working` bits, within two ulp; and the multiple
/// modulo four.
fn reduce(angle: &BigInt, bits: u32, working: u32) -> (BigInt, u32) {
    // An angle of m bits before the point multiplies the error of π by less than 2^m.
    let whole_bits = (angle.bits() as u32).saturating_sub(bits);
    let fine = working + whole_bits + 4;
    // π in units of 2^−(fine − 1) is π/2 in units of 2^−fine.
    let quarter = Enclosure::pi(fine - 1).lower().clone();
    let angle = angle << (fine - bits);
    let doubled: BigInt = &angle * 2;
    let turns = (doubled + &quarter).div_floor(&(&quarter * 2));
    let reduced = (angle - &turns * quarter) >> (fine - working);
    let quarter_turns = turns.mod_floor(&BigInt::from(4)).to_u32().unwrap_or(0);
    (reduced, quarter_turns)
}

/// Sine and cosine of a small angle, 0 ≤ t < 0.8, by their series, and the error of both in ulp.
///
/// A term is made of the previous one by a product with t and a division by n, both cut off:
/// wrong by e it makes the next one wrong by at most (e + 1)/n + 1, so none is wrong by more than
/// 2 ulp. The first term left out is wrong by less than 2 ulp from zero, and the terms after it
/// add less than half of it. One more ulp for a cut-off argument.
fn series(t: &BigInt, working: u32) -> (BigInt, BigInt, u64) {
    let (mut sin, mut cos) = (BigInt::zero(), BigInt::one() << working);
    let (mut term, mut n) = (t.clone(), 1_u32);
    while !term.is_zero() {
        match n % 4 {
            0 => cos += &term,
            1 => sin += &term,
            2 => cos -= &term,
            _ => sin -= &term,
        }
        n += 1;
        term = ((term * t) >> working) / n;
    }
    (sin, cos, 2 * u64::from(n) + 4)
}

/// An enclosure of the angle of the vector (x, y), which is not zero, a few ulp wide.
///
/// An approximate angle θ in f64 turns the vector close to the x axis; what is left,
/// v = (y cos θ − x sin θ)/(x cos θ + y sin θ), is so small that atan v takes a term of the series
/// for every hundred bits. Nothing depends on how good θ is but the number of terms.
pub fn angle(y: &BigInt, x: &BigInt, bits: u32) -> Enclosure {
    const APPROXIMATE_BITS: u32 = 52;
    let working = bits + 24;
    let excess = y.bits().max(x.bits()).saturating_sub(u64::from(APPROXIMATE_BITS) + 8);
    let leading = |side: &BigInt| (side >> excess).to_f64().unwrap_or(0.0);
    let approximate = leading(y).atan2(leading(x)) * (1_u64 << APPROXIMATE_BITS) as f64;
    let approximate = BigInt::from(approximate as i64) << (working - APPROXIMATE_BITS);
    let (sin, cos) = sin_cos(&approximate, working);
    let (along, across) = (cos.times(x).add(&sin.times(y)), cos.times(y).sub(&sin.times(x)));
    let rest = across.div(&along).expect("the vector is turned close to the x axis");
    let (middle, radius) = rest.middle();
    let (arc, error) = small_arc_tangent(&middle, working);
    Enclosure::around(&(approximate + arc), &(error + radius), working).with_bits(bits)
}

/// atan v for |v| < 1/2 by its series, and the error in ulp.
///
/// The square of v is wrong by one ulp and below 1/4, so a power wrong by e makes the next one
/// wrong by at most e/4 + 1 + 1: none is wrong by more than 3 ulp, a share of the sum by one more.
/// The first power left out is wrong by at most 3 ulp from zero, the tail below twice that.
fn small_arc_tangent(v: &BigInt, working: u32) -> (BigInt, BigInt) {
    assert!(v.bits() < u64::from(working));
    let square = (v * v) >> working;
    let (mut power, mut odd, mut sum) = (v.abs(), 1_u32, BigInt::zero());
    while !power.is_zero() {
        let share = &power / odd;
        if odd % 4 == 1 {
            sum += share
        } else {
            sum -= share
        }
        power = (power * &square) >> working;
        odd += 2;
    }
    let error = BigInt::from(2 * odd + 6);
    (if v.is_negative() { -sum } else { sum }, error)
}

/// An enclosure of the arc sine of `sine`·2^−bits, which lies in [−1, 1].
fn asin(sine: &BigInt, bits: u32) -> Enclosure {
    let working = bits + 2;
    let sine = sine << 2;
    let one = BigInt::one() << working;
    let square: BigInt = (&one - &sine) * (&one + &sine);
    let cosine = square.sqrt();
    // The root is cut off by one ulp, across a vector of length one: less than 2 ulp of angle.
    angle(&sine, &cosine, working).widened(&BigInt::from(2)).with_bits(bits)
}
