//! Points of a link, by coordinates, polar, or by distances from its two joints.

use crate::equations::jet::Jet;
use crate::equations::symbol::Sym;
use crate::ir::graph::Check;

/// The coordinates of a point at the angle `angle` and the distance `radius` from the origin.
pub(super) fn polar<'s>(radius: Jet<'s>, angle: Jet<'s>) -> [Jet<'s>; 2] {
    let (sine, cosine) = angle.sin_cos();
    [radius * cosine, radius * sine]
}

/// The coordinates of a point at the distances r₁ and r₂ from the joints (0, 0) and (l, 0):
/// x = ((r₁ − r₂)(r₁ + r₂) + l²)/(2 l), y = ± √((r₁ − x)(r₁ + x)), + on the left. On the line through
/// the joints y has no rates: 2 y ẏ = (y²)˙ and 2 ẏ² + 2 y ÿ = (y²)¨.
///
/// x loses at most 2 ε (l + r₁), three of which are x's products and sums and the rest the quotient's,
/// where the point is on the line, so y² at most 4 ε r₁ (l + r₁) + 2 ε r₁².
pub(super) fn at_distances<'s>(
    group: u32,
    [r1, r2]: [Jet<'s>; 2],
    length: Jet<'s>,
    side: Sym<'s>,
) -> [Jet<'s>; 2] {
    let x = ((r1 - r2) * (r1 + r2) + length * length) / length.twice();
    let square = (r1 - x) * (r1 + x);
    let (l, r1, r2) = (length.value, r1.value, r2.value);
    let operands = [l, r1, r2, r1 * (r1 + l)];
    let value = square.value.guarded_by(Check::ReachDistances, group, &operands);
    // 1/y = y/y²: of a point that stands still on its link nothing of it remains.
    let y = side * value.sqrt();
    let inverse = y * value.guarded_by(Check::Nonzero, group, &[]).recip();
    let rate = square.rate.half() * inverse;
    let accel = (square.accel.half() - rate.squared()) * inverse;
    [x, Jet { value: y, rate, accel }]
}
