//! Rational numbers: two machine words while they fit, big integers beyond.
//!
//! Most constants of a mechanism are lengths with a few decimals. They never leave the machine
//! words, so that folding them costs nothing even where the compiler itself is not optimised.

use core::cmp::Ordering;
use core::hash::{Hash, Hasher};

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::Ratio;
use num_traits::{One, Signed, ToPrimitive, Zero};

/// `num-rational` has this name behind a feature. Where the workspace builds the macro and `nalgebra`
/// together, `nalgebra` would get that feature too, and the target a second `num-bigint`.
pub type BigRational = Ratio<BigInt>;

/// A reduced fraction with a positive denominator.
///
/// Equal numbers are structurally equal: a number is `Small` whenever both its parts fit.
#[derive(Clone, Debug)]
pub enum Rational {
    /// |numerator| ≤ `i64::MAX`, 0 < denominator.
    Small(i64, i64),
    Big(Box<BigRational>),
}

impl Rational {
    pub(super) const ZERO: Self = Self::Small(0, 1);
    pub(super) const ONE: Self = Self::Small(1, 1);

    pub(super) fn integer(value: i64) -> Self {
        Self::reduced(value.into(), 1)
    }

    /// The quotient of two small integers; the divisor is positive.
    pub fn ratio(numerator: i64, denominator: i64) -> Self {
        Self::integer(numerator).mul(&Self::reduced(1, denominator.into()))
    }

    /// The quotient of two integers; the divisor is not zero.
    pub fn of(numerator: BigInt, denominator: BigInt) -> Self {
        Self::from_big(BigRational::new(numerator, denominator))
    }

    pub fn numerator(&self) -> BigInt {
        match self {
            Self::Small(numerator, _) => (*numerator).into(),
            Self::Big(big) => big.numer().clone(),
        }
    }

    pub fn denominator(&self) -> BigInt {
        match self {
            Self::Small(_, denominator) => (*denominator).into(),
            Self::Big(big) => big.denom().clone(),
        }
    }

    pub(super) fn is_zero(&self) -> bool {
        matches!(self, Self::Small(0, _))
    }

    pub(super) fn is_one(&self) -> bool {
        matches!(self, Self::Small(1, 1))
    }

    pub fn signum(&self) -> Ordering {
        match self {
            Self::Small(numerator, _) => numerator.cmp(&0),
            Self::Big(big) => big.numer().cmp(&BigInt::zero()),
        }
    }

    pub(super) fn to_integer(&self) -> Option<i64> {
        match self {
            Self::Small(numerator, 1) => Some(*numerator),
            Self::Small(..) => None,
            // `i64::MIN` is the one integer that fits and is not small.
            Self::Big(big) => big.is_integer().then(|| big.numer().to_i64()).flatten(),
        }
    }

    /// The greatest integer not above the number.
    pub fn floor(&self) -> Self {
        match self {
            Self::Small(numerator, denominator) => {
                Self::Small(Integer::div_floor(numerator, denominator), 1)
            }
            Self::Big(big) => Self::from_big(big.floor()),
        }
    }

    /// The number modulo the divisor, in [0, divisor).
    pub fn modulo(&self, divisor: i64) -> Self {
        let divisor = Self::integer(divisor);
        self.sub(&self.div(&divisor).floor().mul(&divisor))
    }

    pub fn neg(&self) -> Self {
        match self {
            Self::Small(numerator, denominator) => Self::Small(-numerator, *denominator),
            Self::Big(big) => Self::from_big(-big.as_ref()),
        }
    }

    pub fn abs(&self) -> Self {
        if self.signum().is_lt() { self.neg() } else { self.clone() }
    }

    /// The reciprocal of a number that is not zero.
    pub(super) fn recip(&self) -> Self {
        match self {
            Self::Small(numerator, denominator) => {
                Self::Small(denominator * numerator.signum(), numerator.abs())
            }
            Self::Big(big) => Self::from_big(big.recip()),
        }
    }

    pub fn add(&self, other: &Self) -> Self {
        let (&Self::Small(n1, d1), &Self::Small(n2, d2)) = (self, other) else {
            return Self::from_big(self.to_big() + other.to_big());
        };
        let wide = i128::from;
        let common = gcd(d1.unsigned_abs(), d2.unsigned_abs()) as i64;
        if common == 1 {
            return Self::reduced(wide(n1) * wide(d2) + wide(n2) * wide(d1), wide(d1) * wide(d2));
        }
        // Whatever the sum has in common with its denominator divides `common` (Knuth, TAOCP 2,
        // 4.5.1), so one more division of words reduces it.
        let sum = wide(n1) * wide(d2 / common) + wide(n2) * wide(d1 / common);
        let rest = (sum % wide(common)).unsigned_abs() as u64;
        let shared = gcd(rest, common.unsigned_abs()) as i64;
        Self::reduced(sum / wide(shared), wide(d1 / common) * wide(d2 / shared))
    }

    pub fn sub(&self, other: &Self) -> Self {
        self.add(&other.neg())
    }

    pub fn mul(&self, other: &Self) -> Self {
        let (&Self::Small(n1, d1), &Self::Small(n2, d2)) = (self, other) else {
            return Self::from_big(self.to_big() * other.to_big());
        };
        let first = gcd(n1.unsigned_abs(), d2.unsigned_abs()) as i64;
        let second = gcd(n2.unsigned_abs(), d1.unsigned_abs()) as i64;
        Self::reduced(
            i128::from(n1 / first) * i128::from(n2 / second),
            i128::from(d1 / second) * i128::from(d2 / first),
        )
    }

    /// The quotient; the divisor is not zero.
    pub fn div(&self, other: &Self) -> Self {
        self.mul(&other.recip())
    }

    /// A fraction that is reduced already.
    fn reduced(numerator: i128, denominator: i128) -> Self {
        let small = |value| i64::try_from(value).ok().filter(|&word| word != i64::MIN);
        match (small(numerator), small(denominator)) {
            (Some(numerator), Some(denominator)) => Self::Small(numerator, denominator),
            _ => Self::Big(Box::new(BigRational::new_raw(numerator.into(), denominator.into()))),
        }
    }

    fn from_big(big: BigRational) -> Self {
        let small = |value: &BigInt| value.to_i64().filter(|&word| word != i64::MIN);
        match (small(big.numer()), small(big.denom())) {
            (Some(numerator), Some(denominator)) => Self::Small(numerator, denominator),
            _ => Self::Big(Box::new(big)),
        }
    }

    fn to_big(&self) -> BigRational {
        match self {
            Self::Small(numerator, denominator) => {
                BigRational::new_raw((*numerator).into(), (*denominator).into())
            }
            Self::Big(big) => big.as_ref().clone(),
        }
    }
}

/// By the parts of the reduced fractions. `BigRational` expands both into continued fractions to
/// compare and to hash them, one call inside the other: thousands of long divisions, and as many
/// frames on the stack.
impl PartialEq for Rational {
    fn eq(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Small(n1, d1), Self::Small(n2, d2)) => (n1, d1) == (n2, d2),
            (Self::Big(a), Self::Big(b)) => (a.numer(), a.denom()) == (b.numer(), b.denom()),
            _ => false,
        }
    }
}

impl Eq for Rational {}

/// See [`Self::eq`].
impl Hash for Rational {
    fn hash<H: Hasher>(&self, state: &mut H) {
        match self {
            Self::Small(numerator, denominator) => (numerator, denominator).hash(state),
            Self::Big(big) => (big.numer(), big.denom()).hash(state),
        }
    }
}

impl Ord for Rational {
    fn cmp(&self, other: &Self) -> Ordering {
        match (self, other) {
            (Self::Small(n1, d1), Self::Small(n2, d2)) => {
                (i128::from(*n1) * i128::from(*d2)).cmp(&(i128::from(*n2) * i128::from(*d1)))
            }
            _ => (self.numerator() * other.denominator())
                .cmp(&(other.numerator() * self.denominator())),
        }
    }
}

impl PartialOrd for Rational {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

const SMALL_PRIMES: [u32; 25] = [
    2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47, 53, 59, 61, 67, 71, 73, 79, 83, 89, 97,
];

/// The square part of a positive integer: `(k, m)` with value = k²·m.
///
/// m is free of the squares of small primes and no square itself; the square of a large prime
/// inside a larger number goes unnoticed, which costs a normal form its uniqueness, not its truth.
pub fn square_part(value: &BigInt) -> (BigInt, BigInt) {
    assert!(value.is_positive());
    let (mut rest, mut root) = (value.clone(), BigInt::one());
    for prime in SMALL_PRIMES {
        let square = BigInt::from(prime * prime);
        while rest >= square {
            let (quotient, remainder) = rest.div_rem(&square);
            if !remainder.is_zero() {
                break;
            }
            (rest, root) = (quotient, root * prime);
        }
    }
    let whole = rest.sqrt();
    if &whole * &whole == rest { (root * whole, BigInt::one()) } else { (root, rest) }
}

fn gcd(mut a: u64, mut b: u64) -> u64 {
    while b != 0 {
        (a, b) = (b, a % b);
    }
    // Only 0 and 0 have no divisor in common; dividing by one leaves them alone.
    a.max(1)
}
