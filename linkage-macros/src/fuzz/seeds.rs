//! The declarations that are mangled: every variant of every group, and some that use what those
//! do not.

use crate::equations::tests::declarations::VARIANTS;

const MORE: &[&str] = &[
    "/// Strip-mill flying shear.
     pub struct FlyingShear {
         input theta: angle;
         ground A(0, 0);
         ground D(665.7mm, 0);
         crank AB(A) -> B { length: 80mm, angle: theta }
         rrr BC(B), DC(D) -> C { lengths: (632mm, 374mm), mode: left }
         /// Upper blade.
         point blade on BC at (500mm, -60mm);
         output blade, DC.angle, fold = BC.angle - DC.angle, BC.margin;
     }",
    "pub(crate) struct Press {
         crate = ::linkage_core; numerics compensated;
         input s, x: length;
         param l = 0.3m; param reach: mode = ahead; param side: mode = right; param k: number = 2;
         let half = s / 2;
         ground O(0, 0), D(1, 0.2in);
         guide rail through O towards D; guide post through (1, 0) along 90deg;
         slider ram(rail) -> P { slide: half }
         rrp PC(P), block(post) -> C { length: 4 * l, mode: reach }
         rrr PE(P), DE(D) -> E { lengths: (l * 5, 1.2 + x * k), mode: side }
         point tip on DE at distances (1.3m, 0.6m) left;
     }",
];

pub(super) fn all() -> impl Iterator<Item = &'static str> {
    VARIANTS.iter().map(|variant| variant.source).chain(MORE.iter().copied())
}
