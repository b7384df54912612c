//! An exact decision: can two links bridge the distance between their outer joints?
//!
//! At a toggle the distance equals the bars' span up to rounding, and what is asked is on which
//! side of a limit a few last places away it lies: the sign of a difference of squares that
//! cancels down to the last bit. It is computed without rounding, on numbers scaled by a power of
//! two so that no square leaves the range. Nothing in here knows of groups or scalars.

use crate::kernels::{Native, exact_sum, mul_err, sqrt, two_sum};

/// The error of a value in ε of its spread: larger values are positive for certain.
pub const ROUNDINGS: f64 = 16.0;

/// The distance by which a pose may miss assembly, in units in the last place of the longest length:
/// what rounding does to a joint that lies on the line of centres in real numbers.
const ULPS: f64 = 4.0;

/// The answer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Reach {
    /// The joints can be bridged.
    Meets,
    /// They cannot, by rounding only.
    AtLimit,
    /// They cannot, by this much.
    Beyond(f64),
    /// They coincide: the direction from one to the other is undefined.
    Coincident,
    /// A number is not finite.
    NotFinite,
}

/// The numbers that are judged: the distance from one to the next, and the smallest above zero.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Width {
    pub(crate) epsilon: f64,
    pub(crate) smallest: f64,
}

/// Decides if circles of radii |`l1`| and |`l2`| about points (`dx`, `dy`) apart meet.
#[inline(always)]
pub(crate) fn circles([dx, dy]: [f64; 2], [l1, l2]: [f64; 2], width: Width) -> Reach {
    in_registers(dx, dy, l1, l2, width)
}

/// [`circles`], of numbers that are handed over in registers: an array would be read before it is written.
#[inline(never)]
fn in_registers(dx: f64, dy: f64, l1: f64, l2: f64, width: Width) -> Reach {
    let Some(scale) = Scale::of([dx, dy, l1, l2]) else {
        return Reach::NotFinite;
    };
    let [dx, dy, l1, l2] = [dx, dy, l1, l2].map(|x| scale.down(x).abs());
    let (long, short) = (l1.max(l2), l1.min(l2));
    let slack_of = |d: f64| ULPS * scale.ulp(d.max(long), width);
    let span = long + short;
    let missing = excess([dx, dy], [long, short]);
    if missing <= 0.0 {
        return too_close([dx, dy], [long, short], slack_of(distance([dx, dy])), scale);
    }
    // Slack makes up for (span + slack)² − span². Twice that is beyond any rounding of it. The distance is no longer
    // than both sides, and its root is not waited for.
    let most = slack_of(dx + dy);
    let is_clear = missing > 2.0 * (most * (2.0 * span + most));
    let d = distance([dx, dy]);
    if !is_clear && excess_with([dx, dy], [long, short, slack_of(d)]) <= 0.0 {
        Reach::AtLimit
    } else {
        Reach::Beyond(scale.up(missing / (d + span)))
    }
}

/// (d² − (l₁ − l₂)²) ((l₁ + l₂)² − d²) / (4 l₁ l₂)² for d = (`dx`, `dy`): the square of
/// half the sine of the angle between the bars. Within a few last places, however near the limit, and
/// with the sign of the exact value.
pub(crate) fn height_product([dx, dy]: [f64; 2], [l1, l2]: [f64; 2]) -> f64 {
    let Some(scale) = Scale::of([dx, dy, l1, l2]) else {
        return f64::NAN;
    };
    let [dx, dy, l1, l2] = [dx, dy, l1, l2].map(|x| scale.down(x).abs());
    let (long, short) = (l1.max(l2), l1.min(l2));
    let outer = -excess([dx, dy], [long, short]);
    let inner = excess([dx, dy], [long, -short]);
    let four = 4.0 * long * short;
    (outer / four) * (inner / four)
}

/// (d² + l₁² − l₂²)/2d² for d = (`dx`, `dy`): where the foot of the joint stands on the line from the
/// first centre to the second, as a share of it. Within a few last places.
pub(crate) fn foot([dx, dy]: [f64; 2], [l1, l2]: [f64; 2]) -> f64 {
    let Some(scale) = Scale::of([dx, dy, l1, l2]) else {
        return f64::NAN;
    };
    let [dx, dy, l1, l2] = [dx, dy, l1, l2].map(|x| scale.down(x).abs());
    let mut terms = [0.0; 8];
    exact_products(&mut terms, [(dx, dx), (dy, dy), (l1, l1), (-l2, l2)]);
    exact_sum(terms) / (2.0 * (dx * dx + dy * dy))
}

/// The same for a joint on the line: ± l₁/|d|, on the side on which the foot is.
pub(crate) fn foot_on_line(d: [f64; 2], [l1, l2]: [f64; 2]) -> f64 {
    let Some(scale) = Scale::of([d[0], d[1], l1, l2]) else {
        return f64::NAN;
    };
    let share = scale.down(l1).abs() / distance(d.map(|x| scale.down(x)));
    if foot(d, [l1, l2]) < 0.0 { -share } else { share }
}

/// Decides if (`dx`, `dy`) is at least |`e`| long.
#[inline(never)]
pub(crate) fn offset([dx, dy]: [f64; 2], e: f64, width: Width) -> Reach {
    let Some(scale) = Scale::of([dx, dy, e]) else {
        return Reach::NotFinite;
    };
    let [dx, dy, e] = [dx, dy, e].map(|x| scale.down(x).abs());
    let slack = ULPS * scale.ulp(distance([dx, dy]).max(e), width);
    too_close([dx, dy], [e, 0.0], slack, scale)
}

/// Decides if |`t`| ≤ |`l`|.
#[inline(never)]
pub(crate) fn line(t: f64, l: f64, width: Width) -> Reach {
    let Some(scale) = Scale::of([t, l]) else {
        return Reach::NotFinite;
    };
    let [t, l] = [t, l].map(|x| scale.down(x).abs());
    let slack = ULPS * scale.ulp(t.max(l), width);
    if t <= l {
        Reach::Meets
    } else if exact_sum([t, -l, -slack]) <= 0.0 {
        Reach::AtLimit
    } else {
        Reach::Beyond(scale.up(t - l))
    }
}

/// Decides if points `d` apart are at least `long` − `short` ≥ 0 apart.
fn too_close(d: [f64; 2], [long, short]: [f64; 2], slack: f64, scale: Scale) -> Reach {
    let (gap, missing) = (long - short, -excess(d, [long, -short]));
    // Slack makes up for gap² − (gap − slack)², or for all where the gap is no longer than that. What is
    // missing is at most gap², so that a gap that misses twice as much is longer.
    let is_clear = missing > 2.0 * (2.0 * gap * slack);
    let by_rounding_only = || {
        exact_sum([long, -short, -slack]) <= 0.0 || excess_with(d, [long, -short, -slack]) >= 0.0
    };
    if missing > 0.0 && (is_clear || !by_rounding_only()) {
        Reach::Beyond(scale.up(missing / (distance(d) + gap)))
    } else if d == [0.0; 2] {
        Reach::Coincident
    } else if missing > 0.0 {
        Reach::AtLimit
    } else {
        Reach::Meets
    }
}

/// Above this a sum of two words has the sign and, but for half a unit, the last place of the exact one.
///
/// Scaled numbers are below 2, their squares below 4, those of a span below 16. The rounding errors of
/// the products and sums are below 2⁻⁴⁹ each and 2⁻⁴⁷ together, and six roundings of their sum below
/// 2⁻⁹⁷: a sixteenth of a unit in the last place of 2⁻⁴⁰.
const TWO_WORDS: f64 = 1.0 / (1_u64 << 40) as f64;

/// dx² + dy² − (a + b)², within a unit in the last place and with the sign of the exact value.
///
/// In two words, and without rounding where these do not do: next to a limit.
fn excess([dx, dy]: [f64; 2], [a, b]: [f64; 2]) -> f64 {
    let error = mul_err::<f64, Native>;
    let (span, rest) = two_sum(a, b);
    let (square, square_rest) = two_sum(dx * dx, dy * dy);
    let (high, high_rest) = two_sum(square, -(span * span));
    let products = error(dx, dx) + error(dy, dy) - error(span, span) - rest * (2.0 * span);
    let value = high + (products + (square_rest + high_rest));
    if value.abs() > TWO_WORDS { value } else { excess_with([dx, dy], [a, b, 0.0]) }
}

/// dx² + dy² − (a + b + w)², within a unit in the last place and with the sign of the exact value.
#[cold]
#[inline(never)]
fn excess_with([dx, dy]: [f64; 2], [a, b, w]: [f64; 3]) -> f64 {
    let mut terms = [0.0; 16];
    let products = [
        (dx, dx),
        (dy, dy),
        (-a, a),
        (-b, b),
        (-w, w),
        (-2.0 * a, b),
        (-2.0 * a, w),
        (-2.0 * b, w),
    ];
    exact_products(&mut terms, products);
    exact_sum(terms)
}

/// Each product and its rounding error, side by side.
fn exact_products<const N: usize>(terms: &mut [f64], products: [(f64, f64); N]) {
    for ([product, error], (x, y)) in terms.as_chunks_mut().0.iter_mut().zip(products) {
        *product = x * y;
        *error = mul_err::<f64, Native>(x, y);
    }
}

fn distance([dx, dy]: [f64; 2]) -> f64 {
    sqrt(dx * dx + dy * dy)
}

/// A power of two that brings the largest of some numbers between 1 and 2.
#[derive(Clone, Copy)]
struct Scale {
    down: f64,
    up: f64,
    /// The exponent of the largest number.
    exponent: i32,
}

impl Scale {
    /// The scale of these numbers, if they are finite. Subnormal numbers are brought only as far
    /// as the smallest normal number is, which leaves them large enough to be squared.
    #[inline(always)]
    fn of<const N: usize>(numbers: [f64; N]) -> Option<Self> {
        // The patterns of magnitudes are in the numbers' order, with all that is not finite at the end.
        let patterns = numbers.map(|x| x.abs().to_bits());
        let largest = patterns.into_iter().fold(0, u64::max);
        if largest >= f64::INFINITY.to_bits() {
            return None;
        }
        let exponent = ((largest >> 52) as i32).max(1) - 1023;
        Some(Self { down: power_of_two(-exponent), up: power_of_two(exponent), exponent })
    }

    /// The number in the scale: exact, unless it is 2⁻¹⁰⁰⁰ times as large as the largest.
    #[inline(always)]
    fn down(self, x: f64) -> f64 {
        x * self.down
    }

    /// The number out of the scale; the largest number where it is out of range.
    fn up(self, x: f64) -> f64 {
        (x * self.up).min(f64::MAX)
    }

    /// The unit in the last place of a scaled number as a number of this width.
    fn ulp(self, x: f64, width: Width) -> f64 {
        let leading_bit = f64::from_bits(x.to_bits() & f64::INFINITY.to_bits());
        let ulp = leading_bit * width.epsilon;
        // The unit of numbers around one is at least ε/2. A smallest number that could be more than that
        // after scaling by less than 2¹⁰⁰ is none of either width, and processors are slow with subnormals.
        if self.exponent > -100 { ulp } else { ulp.max(self.down(width.smallest)) }
    }
}

/// 2ᵏ for −1023 ≤ k ≤ 1023, of which the first is subnormal.
#[inline(always)]
fn power_of_two(k: i32) -> f64 {
    if k < -1022 { f64::MIN_POSITIVE / 2.0 } else { f64::from_bits(((k + 1023) as u64) << 52) }
}

#[cfg(test)]
mod tests;
