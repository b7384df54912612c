//! One declaration a variant of a group: fixed and moving joints and guides, both modes, constant
//! and driven dimensions. Each comes with inputs at which it assembles, well off its limits.

/// A named declaration and the value, rate and second rate of each input.
pub(crate) struct Variant {
    pub name: &'static str,
    pub source: &'static str,
    pub inputs: &'static [[f64; 3]],
}

/// Turning and being turned: ω and α both non-zero.
const ONE: &[[f64; 3]] = &[[0.7, 1.3, -0.6]];
const TWO: &[[f64; 3]] = &[[0.7, 1.3, -0.6], [0.21, -0.4, 0.9]];

/// A crank and a body that turns about a moving pivot: something to stand on that moves freely.
macro_rules! moving {
    ($($rest:literal)*) => {
        concat!(
            "pub struct M { input q: angle; ground A(0.1, -0.2); ground O(0, 0);",
            "crank AB(A) -> B { length: 0.5, angle: q }",
            "crank EF(A) -> F { length: 0.3, angle: 40deg - 2 * q }",
            "crank body(B) { angle: 3 * q + 0.2, relative_to: EF }",
            "point P on body at (0.2, 0.1); point R on body at (-0.1, 0.35);",
            "guide way on body through (0.05, -0.15) along 65deg;",
            "guide tilt on body through P along 0.3 * q;",
            $($rest,)* "}"
        )
    };
}

macro_rules! fixed {
    ($($rest:literal)*) => {
        concat!(
            "pub struct M { input q: angle; input s: length; ground A(0, 0), D(0.9, 0.15);",
            "crank AB(A) -> B { length: 0.3, angle: q }",
            "guide rail through (0.2, -0.1) along 20deg; guide post through (0.7, 0) along 90deg;",
            $($rest,)* "}"
        )
    };
}

pub(crate) const VARIANTS: &[Variant] = &[
    Variant { name: "crank", source: moving!(), inputs: ONE },
    Variant {
        name: "crank with a driven length",
        source: fixed!("crank BE(B) -> E { length: 0.2 + s, angle: 2 * q, relative_to: AB }"),
        inputs: TWO,
    },
    Variant {
        name: "slider on a fixed guide",
        source: fixed!("slider ram(rail) -> P { slide: s, offset: 0.1m * q }"),
        inputs: TWO,
    },
    Variant {
        name: "slider on a moving guide",
        source: moving!("slider ram(way) -> S { slide: 0.4m * q, offset: 0.05 + 0.02m * q }"),
        inputs: ONE,
    },
    Variant {
        name: "slider on a guide that turns in its carrier",
        source: moving!("slider ram(tilt) -> S { slide: 0.4m * q, offset: 0.05 }"),
        inputs: ONE,
    },
    Variant {
        name: "rrr on the ground, left",
        source: fixed!("rrr BC(B), DC(D) -> C { lengths: (0.8, 0.5), mode: left }" 
            "point X on BC at (0.3, 0.2); point Y on DC at polar (0.2, 100deg); let t = s;"
            "slider z(rail) { slide: t }"),
        inputs: TWO,
    },
    Variant {
        name: "rrr on the ground, right, equal bars",
        source: fixed!("rrr BC(B), DC(D) -> C { lengths: (0.8, 0.8), mode: right }"
            "slider z(rail) { slide: s }"),
        inputs: TWO,
    },
    Variant {
        name: "rrr with a cylinder",
        source: fixed!("rrr BC(B), DC(D) -> C { lengths: (0.6 + s, 0.5 - 0.1m * q), mode: right }"
            "point X on BC at distances (0.4, 0.5) left; point Y on DC at (q * 0.1m, s);"),
        inputs: TWO,
    },
    Variant {
        name: "rrr on moving points",
        source: moving!("rrr PX(P), FX(F) -> X { lengths: (0.7, 0.9), mode: left }"
            "rrr RY(R), XY(X) -> Y { lengths: (0.8, 0.9), mode: right }"),
        inputs: ONE,
    },
    Variant {
        name: "rrp on a fixed guide, ahead",
        source: fixed!("rrp BC(B), block(rail) -> C { length: 0.9, offset: 0.05, mode: ahead }"
            "point X on block at (0.1, 0.2); slider z(post) { slide: s }"),
        inputs: TWO,
    },
    Variant {
        name: "rrp on an upright guide, behind",
        source: fixed!("rrp BC(B), block(post) -> C { length: 0.9, mode: behind }"
            "slider z(post) { slide: s }"),
        inputs: TWO,
    },
    Variant {
        name: "rrp with driven length and offset",
        source: fixed!(
            "rrp BC(B), block(rail) -> C { length: 0.9 + s, offset: 0.1m * q, mode: behind }"
        ),
        inputs: TWO,
    },
    Variant {
        name: "rrp on a moving guide",
        source: moving!("rrp FC(F), block(way) -> C { length: 1.3, offset: 0.1, mode: ahead }"
            "rrp OE(O), runner(tilt) -> E { length: 1.4, offset: 0.1m * q, mode: behind }"),
        inputs: ONE,
    },
    Variant {
        name: "rpr about the ground, ahead",
        source: fixed!("rpr block(B), bar(D) { mode: ahead } point X on bar at (1, 0.2);"
            "point Y on block at (0.1, 0.1); slider z(post) { slide: s }"),
        inputs: TWO,
    },
    Variant {
        name: "rpr with a driven offset, behind",
        source: fixed!(
            "rpr block(B), bar(D) { offset: s, mode: behind } point X on bar at (1, 0.2);"
        ),
        inputs: TWO,
    },
    Variant {
        name: "rpr about a moving pivot",
        source: moving!("rpr block(F), bar(P) { offset: 0.1, mode: behind }"
            "rpr collar(O), rod(R) { mode: ahead } point X on rod at (0.2, 0.3);"),
        inputs: ONE,
    },
    Variant {
        name: "prp on fixed guides",
        source: fixed!("slider z(post) -> Z { slide: s } crank ZW(Z) { angle: q }"
            "guide cross on ZW through (0, 0) along 10deg;"
            "prp a(rail), b(post) -> C { offsets: (0.02, -0.03) } prp c(cross), d(rail) -> E { offsets: (0.1m * q, s) }"),
        inputs: TWO,
    },
    Variant {
        name: "prp on moving guides",
        source: moving!("guide bar on EF through (0.1, 0.1) along 100deg;"
            "prp a(way), b(bar) -> C { offsets: (0.05, 0.02m * q) } prp c(tilt), d(bar) -> E {}"
            "prp e(way), f(tilt) -> G { offsets: (0, 0.1) } point X on c at (0.1, 0.1);"),
        inputs: ONE,
    },
    Variant {
        name: "rpp on a fixed rail",
        source: fixed!("rpp block(B), yoke(rail) { slot: 90deg }"
            "rpp collar(B), frame(post) { slot: 50deg, offsets: (0.1, -0.05) }"
            "point X on frame at (0.1, 0.2); point Y on collar at (0.3, 0.1); slider z(post) { slide: s }"),
        inputs: TWO,
    },
    Variant {
        name: "rpp with a driven slot and driven offsets",
        source: fixed!("rpp block(B), yoke(rail) { slot: 1 + 0.2 * q, offsets: (s, 0.1m * q) }"
            "point Y on block at (0.3, 0.1);"),
        inputs: TWO,
    },
    Variant {
        name: "rpp on a moving rail",
        source: moving!("rpp block(F), yoke(way) { slot: 75deg, offsets: (0.02, 0.03) }"
            "rpp collar(O), frame(tilt) { slot: 80deg } point X on yoke at (0.1, 0.1);"),
        inputs: ONE,
    },
    Variant {
        name: "rpp on a moving rail with a driven slot and driven offsets",
        source: moving!("rpp block(F), yoke(way) { slot: 1 + 0.2 * q, offsets: (0.05m * q, 0.1m * q) }"
            "point X on block at (0.3, 0.1); point Y on yoke at (0.1, 0.2);"),
        inputs: ONE,
    },
    Variant {
        name: "guide towards a driven place",
        source: fixed!("point T on AB at (0.5 + s, 0.4 + 0.2m * q); guide line on AB through B towards T;"
            "slider a(line) -> U { slide: 0.3m * q, offset: 0.1 }"),
        inputs: TWO,
    },
    Variant {
        name: "guides towards points",
        source: moving!("guide line on body through P towards R; guide ground_line through A towards O;"
            "slider a(line) -> U { slide: 0.3m * q, offset: 0.1 }"
            "slider b(ground_line) -> V { slide: 0.2 + 1m * q, offset: -0.1 }"),
        inputs: ONE,
    },
    Variant {
        name: "driven points and expressions",
        source: fixed!("point T at (0.3 + s * cos(q), sqrt(0.4 + q) * 0.2m);"
            "slider ram(rail) -> P { slide: s }"
            "crank pinion(D) { angle: ram.slide / 20mm - atan2(s, 0.3) }"
            "crank wheel(D) { angle: -2 * pinion.angle + asin(q / 2) }"
            "point W on wheel at (0.1, hypot(s, 0.2) * tan(0.3 * q));"
            "output T, W, pinion, wheel, ram, fold = wheel.angle - 2 * pinion.angle,"
            "x = acos(q / 3) * 0.1m + atan(s / 0.2m) * 0.1m;"),
        inputs: TWO,
    },
    Variant {
        name: "coordinates and distances",
        source: moving!("rrr PX(P), FX(F) -> X { lengths: (0.7, 0.9), mode: left }"
            "let reach = distance(P, X) / 2 + distance(X, O); point Y at (X.x + 0.1, 2 * P.y);"
            "crank turned(O) -> H { length: distance(P, F), angle: B.y / 1m }"
            "rrr HK(H), YK(Y) -> K { lengths: (reach, distance(A, O) + 1.1), mode: right }"
            "output X, X.x, Y, K.y, H, reach, d = distance(K, X);"),
        inputs: ONE,
    },
    Variant {
        name: "margins and transmission",
        source: moving!("rrr PX(P), FX(F) -> X { lengths: (0.7, 0.9), mode: left }"
            "rrp FC(F), block(way) -> C { length: 1.3, offset: 0.1, mode: ahead }"
            "rpr collar(O), rod(R) { offset: 0.1, mode: ahead }"
            "output PX.margin, PX.transmission, FC.margin, FC.transmission, rod.margin, rod.transmission;"),
        inputs: ONE,
    },
    Variant {
        name: "transmission of slides",
        source: moving!("rrr PX(P), FX(F) -> X { lengths: (0.7, 0.9), mode: left }"
            "guide bar on PX through X along 20deg; guide ground_line through (0.1, 0) along 0.4 * q;"
            "prp a(bar), b(way) -> C {} rpp c(F), d(ground_line) { slot: PX.angle }"
            "output a.transmission, d.transmission, C, c, d;"),
        inputs: ONE,
    },
    Variant {
        name: "every function of a driven angle",
        source: fixed!("point S at (1m * sin(2 * q), 1m * cos(q) * sin(q));"
            "point T at (1m * tan(q / 2), 1m * sqrt(1 + q)); slider z(post) { slide: s * q / (1 + s / 1m) }"),
        inputs: TWO,
    },
];
