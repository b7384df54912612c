//! Sums and products together with their rounding errors.
//!
//! The error of a rounded sum is itself a number of the same width, always; the error of a
//! rounded product is, unless it underflows. T. J. Dekker, "A floating-point technique for
//! extending the available precision", Numerische Mathematik 18 (1971); J.-M. Muller et al.,
//! "Handbook of Floating-Point Arithmetic", 2nd ed. (2018), chapter 4.

use super::Fusion;
use super::arithmetic::Arithmetic;

/// The rounded sum and its error: `sum + error == a + b` exactly, for any order of magnitudes
/// (Knuth's `TwoSum`). Not a number where the sum overflows.
#[inline]
pub(crate) fn two_sum<T: Arithmetic>(a: T, b: T) -> (T, T) {
    let sum = a + b;
    let b_part = sum - a;
    let a_part = sum - b_part;
    (sum, (a - a_part) + (b - b_part))
}

/// The two halves of a number: `high + low == x` exactly, and the product of any two halves is
/// exact (Veltkamp's split). Not a number beyond 2^996 for f64, 2^115 for f32, where the
/// multiplication overflows.
#[inline]
fn split<T: Arithmetic>(x: T) -> (T, T) {
    let scaled = T::SPLITTER * x;
    let high = scaled - (scaled - x);
    (high, x - high)
}

/// The error of the rounded product `product` = fl(a·b), by one fused operation or by Dekker's
/// five exact ones.
#[inline]
fn product_error<T: Arithmetic, F: Fusion>(a: T, b: T, product: T) -> T {
    if F::FUSED {
        return T::multiply_add(a, b, -product);
    }
    let (a_high, a_low) = split(a);
    let (b_high, b_low) = split(b);
    ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low
}

/// Exact product minus rounded product.
///
/// Exact unless a·b underflows; without a fused operation, not a number where a factor exceeds
/// 2^996 (f64) or 2^115 (f32).
#[inline]
pub(crate) fn mul_err<T: Arithmetic, F: Fusion>(a: T, b: T) -> T {
    product_error::<T, F>(a, b, a * b)
}

/// a·b − c·d, within 1.5 units in the last place whatever cancels.
///
/// Fused: Kahan's algorithm; C.-P. Jeannerod, N. Louvet and J.-M. Muller, "Further analysis of
/// Kahan's algorithm for the accurate computation of 2×2 determinants", Mathematics of
/// Computation 82 (2013). Otherwise both products are taken apart exactly: where the products
/// cancel, their difference is exact, and where they do not, the errors are below its last place.
/// Range as for [`mul_err`].
#[inline]
pub(crate) fn det<T: Arithmetic, F: Fusion>(a: T, b: T, c: T, d: T) -> T {
    let cd = c * d;
    if F::FUSED {
        return T::multiply_add(a, b, -cd) - T::multiply_add(c, d, -cd);
    }
    let ab = a * b;
    let ab_error = product_error::<T, F>(a, b, ab);
    let cd_error = product_error::<T, F>(c, d, cd);
    (ab - cd) + (ab_error - cd_error)
}

/// The sum of all terms, rounded at the very end: within one unit in the last place, so that its
/// sign, and whether it is zero, are those of the exact sum.
///
/// The running sum is kept as numbers that do not overlap, each the rounding error of the next
/// (J. R. Shewchuk, "Adaptive precision floating-point arithmetic and fast robust geometric
/// predicates", Discrete & Computational Geometry 18 (1997), grow-expansion).
pub(crate) fn exact_sum<const N: usize>(terms: [f64; N]) -> f64 {
    let mut parts = [0.0; N];
    for (count, &term) in terms.iter().enumerate() {
        let mut carry = term;
        // Without an index: at the lowest optimisation level one would be checked, and could panic.
        for part in parts.iter_mut().take(count) {
            (carry, *part) = two_sum(carry, *part);
        }
        if let Some(last) = parts.get_mut(count) {
            *last = carry;
        }
    }
    parts.iter().fold(0.0, |sum, part| sum + part)
}

#[cfg(test)]
mod tests {
    use super::super::double_word::DoubleWord;
    use super::super::{Fused, Plain};
    use super::*;

    /// Numbers of random bits and a moderate exponent, by a multiplicative congruence.
    fn numbers(count: usize) -> impl Iterator<Item = f64> {
        let mut state = 0x853c_49e6_748f_ea9b_u64;
        core::iter::repeat_with(move || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            let sign_and_fraction = (state >> 11) | (state << 63);
            let exponent = 1023 - 20 + (state >> 40) % 40;
            f64::from_bits((sign_and_fraction & !(0x7ff << 52)) | (exponent << 52))
        })
        .take(count)
    }

    #[test]
    fn sum_and_product_with_their_errors_are_exact() {
        let numbers: std::vec::Vec<f64> = numbers(10_000).collect();
        for pair in numbers.windows(2) {
            let (a, b) = (pair[0], pair[1]);
            let exact = a.mul_add(b, -(a * b));
            assert_eq!(mul_err::<_, Plain>(a, b), exact, "{a:e} {b:e}");
            assert_eq!(mul_err::<_, Fused>(a, b), exact, "{a:e} {b:e}");
            // f64 holds the product of two f32, and the sum of two within 29 binades.
            let (a, b) = (a as f32, b as f32);
            let error = (f64::from(a) * f64::from(b) - f64::from(a * b)) as f32;
            assert_eq!(mul_err::<_, Plain>(a, b), error, "{a:e} {b:e}");
            assert_eq!(mul_err::<_, Fused>(a, b), error, "{a:e} {b:e}");
            let (sum, error) = two_sum(a, b);
            if (a / b).abs().log2().abs() < 29.0 {
                assert_eq!(f64::from(sum) + f64::from(error), f64::from(a) + f64::from(b));
            }
        }
        assert_eq!(two_sum(1e300, 1.0), (1e300, 1.0));
        assert_eq!(two_sum(1.0, 1e300), (1e300, 1.0));
        assert_eq!(two_sum(1.0, f64::EPSILON / 2.0), (1.0, f64::EPSILON / 2.0));
    }

    #[test]
    fn a_difference_of_products_is_right_where_the_products_cancel() {
        let numbers: std::vec::Vec<f64> = numbers(10_000).collect();
        let mut cancelling = 0;
        for [a, b, c] in numbers.windows(3).map(|w| [w[0], w[1], w[2]]) {
            // d such that c·d is the nearest to a·b, up to a few last places.
            for ulps in 0..3 {
                let d = f64::from_bits((a * b / c).to_bits() + ulps);
                let truth = DoubleWord::product(a, b) - DoubleWord::product(c, d);
                for det in [det::<_, Plain>(a, b, c, d), det::<_, Fused>(a, b, c, d)] {
                    let error = truth.distance_in_ulp(det, 53);
                    assert!(error <= 1.5, "{error} ulp at {a:e} {b:e} {c:e} {d:e}");
                }
                cancelling += u32::from(truth.high.abs() < 1e-15 * (a * b).abs());
            }
            let truth = DoubleWord::product(a, b) - DoubleWord::product(c, -a);
            assert!(truth.distance_in_ulp(det::<_, Plain>(a, b, c, -a), 53) <= 1.5);
            assert!(truth.distance_in_ulp(det::<_, Fused>(a, b, c, -a), 53) <= 1.5);
        }
        assert!(cancelling > 20_000, "{cancelling}");
    }

    #[test]
    fn a_sum_of_many_terms_loses_nothing() {
        assert_eq!(exact_sum([1e300, 1.0, -1e300, 1e-300, -1.0]), 1e-300);
        assert_eq!(exact_sum([0.1, 0.2, -0.30000000000000004]), -2f64.powi(-55));
        assert_eq!(exact_sum([1.0, 2f64.powi(-200), -1.0, -2f64.powi(-200)]), 0.0);
        assert_eq!(exact_sum([3.0, -4.5]), -1.5);
    }

    #[test]
    fn single_precision_cancels_as_well() {
        // (2¹² + 1)² − (2¹² + 2)·2¹² = 1, where both products are about 2²⁴ and odd parts are lost.
        assert_eq!(det::<_, Plain>(4097.0_f32, 4097.0, 4098.0, 4096.0), 1.0);
        assert_eq!(det::<_, Fused>(4097.0_f32, 4097.0, 4098.0, 4096.0), 1.0);
        assert_eq!(4097.0_f32 * 4097.0 - 4098.0 * 4096.0, 0.0);
    }
}
