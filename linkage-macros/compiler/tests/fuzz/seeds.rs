//! The declarations that are mangled: small ones that together use the whole language, and every
//! variant of every group.

use crate::equations::declarations::{UNKNOWNS, VARIANTS};
use crate::equations::parallelograms::PARALLELOGRAMS;

pub(super) const SMALL: &[&str] = &[
    "/// A crank-rocker.
     pub struct Rocker {
         /// The crank's angle.
         input theta: angle;
         ground A(0, 0), D(665.7mm, 0);
         crank AB(A) -> B { length: 80mm, angle: theta }
         rrr BC(B), DC(D) -> C { lengths: (632mm, 374mm), mode: left }
         output C, fold = BC.angle - DC.angle;
     }",
    "struct Piston {
         crate = ::linkage_core;
         input t: angle; param l = 0.3m; param reach: mode = ahead;
         ground A(0, 0); guide rail through A along 30deg;
         crank AB(A) -> B { length: 0.1, angle: t }
         rrp BC(B), block(rail) -> C { length: l, offset: 0.01, mode: reach }
         output block.slide, BC.margin;
     }",
    "pub(crate) struct Lift {
         input s, x: length; let half = s / 2;
         ground O(0, 0), D(1, 0.2in); guide rail through O towards D;
         slider ram(rail) -> P { slide: half, offset: x }
         point tip on ram at polar (0.1m, 20deg);
         output tip;
     }",
    "pub struct Cylinder {
         numerics compensated; input lift: length; param side: mode = right;
         ground B(0, 0), D(1.1, 0.3);
         rrr cyl(B), boom(D) -> C { lengths: (lift, 0.9m), mode: side }
         point bucket on boom at distances (1.2m, 0.6m) left;
         output bucket, boom.transmission;
     }",
    "pub struct Whitworth {
         input q: angle; ground A(0, 0), D(0, -1.1m);
         crank AB(A) -> B { length: 0.4m, angle: q }
         rpr stone(B), bar(D) { offset: 1cm, mode: behind }
         guide slot on bar through D along 90deg;
         output bar.angle;
     }",
    "pub struct Cross {
         input a: angle; input s: length; ground O(0, 0);
         guide u through O along 0; guide v through (0, 1um) along 0.25turn;
         prp p(u), q(v) -> C { offsets: (s, 0) }
         crank w(O) { angle: a * 2 }
         output C, w;
     }",
    "pub struct Yoke {
         input a: angle; ground O(0, 0); guide rail through (0, 2) along 10deg;
         crank OB(O) -> B { length: 1, angle: a, relative_to: ground }
         crank BE(B) { angle: -2 * a + 15deg, relative_to: OB }
         rpp pin(B), yoke(rail) { slot: 80deg, offsets: (0, 1mm) }
         output yoke.slide;
     }",
    "pub struct Values {
         input q: angle; param k: number = 2; param w: angle = 0.3;
         let x = hypot(3, k) * 1m; let y = atan2(x, 4m) + asin(0.5) - acos(q / 9) * pi;
         ground A(0, sqrt(2) * 1m); crank AB(A) { angle: q + w }
         point P at (x * cos(q), tan(w) * sin(2 * q) * 1m);
         output P, y, z = -(y + atan(k)) / 2, AB;
     }",
];

pub(super) fn all() -> impl Iterator<Item = &'static str> {
    SMALL
        .iter()
        .copied()
        .chain(VARIANTS.iter().chain(UNKNOWNS).chain(PARALLELOGRAMS).map(|variant| variant.source))
}
