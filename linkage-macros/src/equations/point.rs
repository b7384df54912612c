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
/// x = ((r₁ − r₂)(r₁ + r₂) + l²)/(2 l), y = ± √((r₁ − x)(r₁ + x)), + on the left.
pub(super) fn at_distances<'s>(
    group: u32,
    [r1, r2]: [Jet<'s>; 2],
    length: Jet<'s>,
    side: Sym<'s>,
) -> [Jet<'s>; 2] {
    let x = ((r1 - r2) * (r1 + r2) + length * length) / length.twice();
    let square = (r1 - x) * (r1 + x);
    let operands = [x.value, r1.value];
    let value = square.value.provided(Check::ReachLine, group, &operands);
    let y = Jet { value, ..square }.sqrt().times(side);
    [x, y]
}
