//! Functions of exact numbers; sines, cosines and angles in normal form.
//!
//! A sine or cosine that stays unopened has an angle of one of two shapes, so that the same number
//! always has the same shape: r·π with 0 < r < 1/4, or r·π + x with 0 ≤ r < 1/2, where x has no
//! rational multiple of π in it and a positive first coefficient.

use core::cmp::Ordering;

use super::Exact;
use super::atom::AtomKind;
use super::rational::Rational;
use super::sum::Term;
use crate::function::Function;

impl Exact {
    /// The function of these numbers; `None` outside its domain.
    pub fn of(function: Function, arguments: &[&Self]) -> Option<Self> {
        let (a, b) = (arguments[0], arguments[arguments.len() - 1]);
        match function {
            Function::Sqrt => a.sqrt(),
            Function::Hypot => Some(a.hypot(b)),
            Function::Sin => Some(a.sin()),
            Function::Cos => Some(a.cos()),
            Function::Tan => a.sin().div(&a.cos()),
            Function::Asin => a.asin(),
            Function::Acos => Some(Self::half_turns(&Rational::ratio(1, 2)).sub(&a.asin()?)),
            Function::Atan => Some(a.arc_tangent()),
            Function::Atan2 => a.atan2(b),
            Function::Abs => Some(if a.signum().is_lt() { a.neg() } else { a.clone() }),
            Function::Sign => Some(Self::integer(a.signum() as i64)),
            Function::Min => Some(if a.cmp_value(b).is_le() { a } else { b }.clone()),
            Function::Max => Some(if a.cmp_value(b).is_ge() { a } else { b }.clone()),
            _ => a.grown(function, b),
        }
    }

    /// Exact at multiples of 30° and 90° as far as the value is rational, roots at those of 45°
    /// and 60°, and normalised by symmetry elsewhere (sin(−x) = −sin x, …), so that equal values
    /// compare equal.
    pub(crate) fn sin(&self) -> Self {
        self.sine(0)
    }

    /// See [`Self::sin`].
    pub fn cos(&self) -> Self {
        self.sine(1)
    }

    /// `None` outside [−1, 1].
    fn asin(&self) -> Option<Self> {
        let one = Self::integer(1);
        let within = self.cmp_value(&one).is_le() && self.cmp_value(&one.neg()).is_ge();
        within.then(|| self.arc_sine())
    }

    /// The angle of the vector (x, self) in (−π, π]; `None` for the zero vector.
    pub(crate) fn atan2(&self, x: &Self) -> Option<Self> {
        let half_turn = match (x.signum(), self.signum()) {
            (Ordering::Equal, Ordering::Equal) => return None,
            (Ordering::Equal, Ordering::Greater) => {
                return Some(Self::half_turns(&Rational::ratio(1, 2)));
            }
            (Ordering::Equal, Ordering::Less) => {
                return Some(Self::half_turns(&Rational::ratio(-1, 2)));
            }
            (Ordering::Greater, _) => Rational::ZERO,
            (Ordering::Less, Ordering::Less) => Rational::integer(-1),
            (Ordering::Less, _) => Rational::ONE,
        };
        Some(self.quotient_of(x).arc_tangent().add(&Self::half_turns(&half_turn)))
    }

    /// The length of the vector (self, other).
    pub(crate) fn hypot(&self, other: &Self) -> Self {
        if self.is_zero() || other.is_zero() {
            let size = self.add(other);
            return if size.signum().is_lt() { size.neg() } else { size };
        }
        // A sum of squares is not negative, even where its sign is beyond the finest enclosure.
        self.mul(self).add(&other.mul(other)).sqrt().unwrap_or_else(|| Self::integer(0))
    }

    /// The sine of self + `quarter_turns`·π/2.
    fn sine(&self, quarter_turns: i64) -> Self {
        let (half_turns, rest) = self.split_at_pi();
        let half_turns = half_turns.add(&Rational::ratio(quarter_turns, 2));
        if rest.is_structural_zero() {
            return sine_of_half_turns(&half_turns);
        }
        // sin(r·π − x) = −sin(−r·π + x)
        let mirrored = rest.monic().0.signum().is_lt();
        let (half_turns, rest) =
            if mirrored { (half_turns.neg(), rest.neg()) } else { (half_turns, rest) };
        let quarters = half_turns.mul(&Rational::integer(2)).floor();
        let half_turns = half_turns.sub(&quarters.mul(&Rational::ratio(1, 2)));
        let quadrant = quarters.modulo(4).to_integer().unwrap_or(0);
        let value = unreduced_sine(&half_turns, &rest, quadrant % 2 == 1);
        if mirrored != (quadrant >= 2) { value.neg() } else { value }
    }

    /// The arc sine of a number in [−1, 1].
    fn arc_sine(&self) -> Self {
        if self.monic().0.signum().is_lt() {
            return self.neg().arc_sine().neg();
        }
        match known_sine(self) {
            Some(half_turns) => Self::half_turns(&half_turns),
            None => Self::atom(AtomKind::Of(Function::Asin, self.clone())),
        }
    }

    /// The arc tangent in (−π/2, π/2).
    fn arc_tangent(&self) -> Self {
        if self.monic().0.signum().is_lt() {
            return self.neg().arc_tangent().neg();
        }
        match known_tangent(self) {
            Some(half_turns) => Self::half_turns(&half_turns),
            None => Self::atom(AtomKind::Of(Function::Atan, self.clone())),
        }
    }

    /// The angle of so many half turns.
    pub(super) fn half_turns(turns: &Rational) -> Self {
        Self::pi().scaled(turns)
    }

    /// The number as a rational multiple of π and the rest.
    fn split_at_pi(&self) -> (Rational, Self) {
        let mut terms = self.terms();
        match terms.iter().position(Term::is_multiple_of_pi) {
            Some(place) => (terms.remove(place).coefficient, Self::collect(terms)),
            None => (Rational::ZERO, self.clone()),
        }
    }
}

/// sin(r·π), by symmetry from an angle of at most 45°.
fn sine_of_half_turns(half_turns: &Rational) -> Exact {
    let within_turn = half_turns.modulo(2);
    let (folded, negative) = if within_turn >= Rational::ONE {
        (within_turn.sub(&Rational::ONE), true)
    } else {
        (within_turn, false)
    };
    let complement = Rational::ONE.sub(&folded);
    let acute = folded.min(complement);
    let value = match KNOWN_SINES.iter().find(|known| known.half_turns() == acute) {
        Some(known) => known.sine(),
        None if acute < Rational::ratio(1, 4) => {
            Exact::atom(AtomKind::Of(Function::Sin, Exact::half_turns(&acute)))
        }
        None => {
            let complement = Rational::ratio(1, 2).sub(&acute);
            Exact::atom(AtomKind::Of(Function::Cos, Exact::half_turns(&complement)))
        }
    };
    if negative { value.neg() } else { value }
}

/// sin(r·π + x) or its cosine, where r and x have the shape that stays; opened where x is the
/// angle of a known sine or tangent.
fn unreduced_sine(half_turns: &Rational, rest: &Exact, cosine: bool) -> Exact {
    let one = Exact::rational(Rational::ONE);
    match rest.as_atom().filter(|_| half_turns.is_zero()) {
        Some(AtomKind::Of(Function::Asin, sine)) if cosine => {
            return one.sub(&sine.mul(sine)).root();
        }
        Some(AtomKind::Of(Function::Asin, sine)) => return sine.clone(),
        Some(AtomKind::Of(Function::Atan, tangent)) => {
            let secant = one.add(&tangent.mul(tangent)).root();
            return if cosine { secant.reciprocal() } else { tangent.quotient_of(&secant) };
        }
        _ => {}
    }
    let angle = rest.add(&Exact::half_turns(half_turns));
    Exact::atom(if cosine {
        AtomKind::Of(Function::Cos, angle)
    } else {
        AtomKind::Of(Function::Sin, angle)
    })
}

/// The acute angle, in half turns, whose sine is known to be the number.
fn known_sine(sine: &Exact) -> Option<Rational> {
    if let Some(known) = KNOWN_SINES.iter().find(|known| known.sine() == *sine) {
        return Some(known.half_turns());
    }
    match sine.as_atom()? {
        AtomKind::Of(Function::Sin, angle) => in_half_turns(angle),
        AtomKind::Of(Function::Cos, angle) => {
            in_half_turns(angle).map(|angle| Rational::ratio(1, 2).sub(&angle))
        }
        _ => None,
    }
}

/// The acute angle, in half turns, whose tangent is known to be the number.
fn known_tangent(tangent: &Exact) -> Option<Rational> {
    let is_tangent = |known: &&KnownSine| {
        known.half_turns != (1, 2) && known.sine().quotient_of(&known.cosine()) == *tangent
    };
    if let Some(known) = KNOWN_SINES.iter().find(is_tangent) {
        return Some(known.half_turns());
    }
    let term = tangent.as_term().filter(|term| term.coefficient.is_one())?;
    let [first, second] = term.factors.as_slice() else { return None };
    match (first.atom.kind(), second.atom.kind(), first.power, second.power) {
        (AtomKind::Of(Function::Sin, a), AtomKind::Of(Function::Cos, b), 1, -1) if a == b => {
            in_half_turns(a)
        }
        (AtomKind::Of(Function::Sin, a), AtomKind::Of(Function::Cos, b), -1, 1) if a == b => {
            in_half_turns(a).map(|angle| Rational::ratio(1, 2).sub(&angle))
        }
        _ => None,
    }
}

/// The rational r of an angle r·π.
fn in_half_turns(angle: &Exact) -> Option<Rational> {
    let (half_turns, rest) = angle.split_at_pi();
    rest.is_structural_zero().then_some(half_turns)
}

/// An angle from 0 to 90° with the sine √n/2.
struct KnownSine {
    /// Numerator and denominator.
    half_turns: (i64, i64),
    /// n
    quadruple_square: i64,
}

const KNOWN_SINES: [KnownSine; 5] = [
    KnownSine { half_turns: (0, 1), quadruple_square: 0 },
    KnownSine { half_turns: (1, 6), quadruple_square: 1 },
    KnownSine { half_turns: (1, 4), quadruple_square: 2 },
    KnownSine { half_turns: (1, 3), quadruple_square: 3 },
    KnownSine { half_turns: (1, 2), quadruple_square: 4 },
];

impl KnownSine {
    fn half_turns(&self) -> Rational {
        Rational::ratio(self.half_turns.0, self.half_turns.1)
    }

    fn sine(&self) -> Exact {
        Exact::root_of_rational(&Rational::ratio(self.quadruple_square, 4))
    }

    fn cosine(&self) -> Exact {
        Exact::root_of_rational(&Rational::ratio(4 - self.quadruple_square, 4))
    }
}
