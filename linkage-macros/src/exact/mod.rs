//! Exact real constants: what is known when the mechanism is declared is computed without error
//! and rounded once.

#![allow(dead_code)]

/// An exact real number.
///
/// Held as a rational, as rational + rational·π, or as an expression of those that is enclosed
/// more and more tightly until it rounds uniquely. Equality is structural on the normal form:
/// equal values are normally, not always, recognised as equal.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub(crate) struct Exact(());

impl Exact {
    pub(crate) fn integer(_value: i64) -> Self {
        todo!()
    }
    /// A decimal literal as Rust writes it (`1_000.5e-3`), exactly.
    pub(crate) fn decimal(_digits: &str) -> Option<Self> {
        todo!()
    }
    /// The exact value of a float; `None` unless finite.
    pub(crate) fn float(_value: f64) -> Option<Self> {
        todo!()
    }
    pub(crate) fn pi() -> Self {
        todo!()
    }
    pub(crate) fn add(&self, _other: &Self) -> Self {
        todo!()
    }
    pub(crate) fn sub(&self, _other: &Self) -> Self {
        todo!()
    }
    pub(crate) fn mul(&self, _other: &Self) -> Self {
        todo!()
    }
    /// `None` where the divisor is zero.
    pub(crate) fn div(&self, _other: &Self) -> Option<Self> {
        todo!()
    }
    pub(crate) fn neg(&self) -> Self {
        todo!()
    }
    /// `None` for a negative number; rational on rational squares.
    pub(crate) fn sqrt(&self) -> Option<Self> {
        todo!()
    }
    /// Exact at multiples of 30° and 90° as far as the value is rational, and normalised by
    /// symmetry elsewhere (sin(−x) = −sin x, …), so that equal values compare equal.
    pub(crate) fn sin(&self) -> Self {
        todo!()
    }
    pub(crate) fn cos(&self) -> Self {
        todo!()
    }
    /// `None` where the cosine is zero.
    pub(crate) fn tan(&self) -> Option<Self> {
        todo!()
    }
    /// `None` outside [−1, 1].
    pub(crate) fn asin(&self) -> Option<Self> {
        todo!()
    }
    /// `None` outside [−1, 1].
    pub(crate) fn acos(&self) -> Option<Self> {
        todo!()
    }
    pub(crate) fn atan(&self) -> Self {
        todo!()
    }
    /// The angle of the vector (x, self) in (−π, π]; `None` for the zero vector.
    pub(crate) fn atan2(&self, _x: &Self) -> Option<Self> {
        todo!()
    }
    pub(crate) fn hypot(&self, _other: &Self) -> Self {
        todo!()
    }
    pub(crate) fn is_zero(&self) -> bool {
        todo!()
    }
    pub(crate) fn is_one(&self) -> bool {
        todo!()
    }
    /// The order against zero: exact for rationals; an expression whose enclosure still holds
    /// zero at the finest precision counts as zero.
    pub(crate) fn signum(&self) -> core::cmp::Ordering {
        todo!()
    }
    pub(crate) fn cmp_value(&self, _other: &Self) -> core::cmp::Ordering {
        todo!()
    }
    /// `Some` where the number is an integer that fits.
    pub(crate) fn to_integer(&self) -> Option<i64> {
        todo!()
    }
    /// Correctly rounded (ties to even); infinite beyond the range.
    pub(crate) fn to_f64(&self) -> f64 {
        todo!()
    }
    pub(crate) fn to_f32(&self) -> f32 {
        todo!()
    }
    /// What `to_f64` left: (self − to_f64) correctly rounded, the low word of a double word.
    pub(crate) fn low_f64(&self) -> f64 {
        todo!()
    }
    pub(crate) fn low_f32(&self) -> f32 {
        todo!()
    }
}
