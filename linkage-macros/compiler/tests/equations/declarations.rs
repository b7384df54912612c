//! A declaration a variant of a group: joints and guides fixed and moving, modes, dimensions, off its limits.

/// A named declaration and the value, rate and acceleration of each input.
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
        name: "rrr with two cylinders on the ground",
        source: fixed!("rrr AC(A), DC(D) -> C { lengths: (0.6 + s, 0.5 - 0.1m * q), mode: left }"
            "point X on AC at (0.1, 0.2); point Y on DC at (0.2, -0.1);"),
        inputs: TWO,
    },
    Variant {
        name: "rrr with a cylinder beside a bar on the ground, first and second",
        source: fixed!("rrr AC(A), DC(D) -> C { lengths: (0.6 + s, 0.5), mode: left }"
            "rrr AE(A), DE(D) -> E { lengths: (0.5, 0.6 + s), mode: right }"
            "point X on AC at (0.1, 0.2); point Y on DE at (0.2, -0.1);"),
        inputs: TWO,
    },
    Variant {
        name: "rrr with two cylinders on a crank",
        source: fixed!("point K on AB at (0.25, 0.2); point L on AB at (-0.3, 0.1);"
            "rrr KC(K), LC(L) -> C { lengths: (0.4m + 0.2m * q, 0.3 + s), mode: right }"
            "point X on KC at (0.1, 0.2); point Y on LC at (0.2, -0.1);"),
        inputs: TWO,
    },
    Variant {
        name: "rrr with a cylinder whose joint slides along a crank",
        source: fixed!("point K on AB at (0.25 + 0.3 * s, 0.2); point L on AB at (-0.3, 0.1m * q);"
            "rrr KC(K), LC(L) -> C { lengths: (0.5, 0.3 + s), mode: left } point X on KC at (0.1, 0.2);"),
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
        name: "prp on a fixed guide and one that swings, first and second",
        source: fixed!("guide cross on AB through (0.2, 0.1) along 15deg; slider z(post) -> Z { slide: s }"
            "prp a(rail), b(cross) -> C { offsets: (0.02, -0.03) }"
            "prp c(cross), d(post) -> E { offsets: (0.04, 0.01) }"),
        inputs: TWO,
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
        name: "exponentials, logarithms and powers",
        source: fixed!("slider ram(rail) -> P { slide: 0.3m * tanh(q) + s }"
            "crank pinion(D) { angle: ln(ram.slide / 20mm) - exp(-s / 0.3m) }"
            "crank wheel(D) { angle: pow(ram.slide / 0.3m, 1.3) + pow(q, 3) }"
            "point W on wheel at (pow(1 + s / 1m, q) * 0.1m,"
            "pow(s, 2) / 1m + pow(q, -2) * 0.05m);"
            "output W, pinion, wheel, ram, x = exp(q) * tanh(s / 0.1m) * 0.1m, y = pow(q, s / 0.1m);"),
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
        name: "dimensions of offsets from guides",
        source: moving!(
            "guide line through (0.1, 0.2) along 25deg - 0.4 * q; point X on EF at (0.11, 0.2);"
            "crank turned(O) -> H { length: 0.5 + offset(F, way), angle: offset(B, tilt) / 1m }"
            "point Y at (offset(X, line), 0.3 - offset(P, line) / 2);"
            "output H, Y, gap = offset(H, way) - offset(X, tilt), fixed = offset(P, way);"
        ),
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
        name: "driven places by radius and angle, and by distances",
        source: fixed!("rrr BC(B), DC(D) -> C { lengths: (0.8, 0.5), mode: left }"
            "point X on BC at polar (0.3 + s, 0.4 + 0.5 * q); point T at polar (0.5 - s, 0.3 * q);"
            "point Y on DC at distances (0.4 + 0.5 * s, 0.35 - 0.05m * q) left;"
            "crank turned(D) { angle: atan2(0.3 + 0.2m * q, s + 0.1) }"),
        inputs: TWO,
    },
    Variant {
        name: "guide from one driven place towards another",
        source: fixed!("point P on AB at (0.1 + s, 0.3 - 0.1m * q); point T on AB at (0.6 - s, 0.4 + 0.2m * q);"
            "guide line on AB through P towards T; slider a(line) -> U { slide: 0.3m * q, offset: 0.1 }"
            "guide other on AB through (0.2m * q, s) towards T; slider b(other) -> V { slide: s }"),
        inputs: TWO,
    },
    Variant {
        name: "rack on a block in a driven slot",
        source: fixed!("rpp block(B), yoke(rail) { slot: 1 + 0.2 * q, offsets: (s, 0.1m * q) }"
            "crank pinion(D) { angle: block.slide / 0.3m }"),
        inputs: TWO,
    },
    Variant {
        name: "torsion springs on both links of a prp",
        source: fixed!("guide cross on AB through (0, 0) along 10deg + 0.4 * q;"
            "prp a(rail), b(cross) -> C { offsets: (0.02, s) }"
            "spring between ground and a { stiffness: 3, free_angle: 0.1, damping: 0.2 }"
            "spring between ground and b { stiffness: 2, free_angle: -0.2, damping: 0.5 }"
            "spring between b and AB { stiffness: 5 }"),
        inputs: TWO,
    },
    Variant {
        name: "stops beyond either end, between them and leaving",
        source: fixed!("rrr BC(B), DC(D) -> C { lengths: (0.8, 0.5), mode: left }"
            "guide arm on DC through (0.1, 0) along 20deg; rrp CK(C), ram(rail) -> K { length: 0.9, mode: ahead }"
            "slider z(post) -> Z { slide: s }"
            "stop low DC.angle between (130deg, 170deg) { stiffness: 300, damping: 2 }"
            "stop high BC.angle - DC.angle between (-179deg, -170deg) { stiffness: 200, damping: 3 }"
            "stop DC.angle - AB.angle between (-3, 3) { stiffness: 100 }"
            "stop ram.slide between (2, 3) { stiffness: 700, damping: 20 }"
            "stop z.slide between (0, 0.1) { stiffness: 500, damping: 100 }"
            "stop z.slide between (0, 0.1) { stiffness: 500, damping: 1000 }"
            "stop gap distance(B, Z) between (0.1, 0.2) { stiffness: 900, damping: 7 }"),
        inputs: TWO,
    },
    Variant {
        name: "outputs and forces with corners",
        source: fixed!("crank BE(B) -> E { length: 0.2 + s, angle: 2 * q }"
            "force (min(3N, 20(N/m) * E.y), max(1N, 40(N/m) * s) - abs(5(N*s/m) * rate(E.y))) on E;"
            "torque -2(N*m) * sign(rate(q)) on AB;"
            "output E, up = abs(E.y), down = abs(-E.y - 1m), side = sign(q - 2) * E.x,"
            "least = min(E.x, E.y), same = min(E.y, E.x), most = max(E.x, s), other = max(s, E.x);"),
        inputs: TWO,
    },
    Variant {
        name: "every function of a driven angle",
        source: fixed!("point S at (1m * sin(2 * q), 1m * cos(q) * sin(q));"
            "point T at (1m * tan(q / 2), 1m * sqrt(1 + q)); slider z(post) { slide: s * q / (1 + s / 1m) }"),
        inputs: TWO,
    },
];

/// Machines with an unknown: each group between the unknown and its equation, every form of equation,
/// several unknowns.
pub(crate) const UNKNOWNS: &[Variant] = &[
    Variant {
        name: "the angle that puts a slide where it is wanted",
        source: concat!(
            "pub struct M { input x: length; param seed: near = 60deg; param e = 0.03;",
            "unknown theta: angle between (10deg, 150deg); ground A(0, 0);",
            "guide rail through (0, e) along 0deg; crank AB(A) -> B { length: 80mm, angle: theta }",
            "rrp BC(B), ram(rail) -> C { length: 250mm, mode: ahead }",
            "solve theta { ram.slide = x, mode: falling, near: seed }",
            "output theta, AB, B, BC, ram, twice = 2 * theta; }"
        ),
        inputs: &[[0.27, 0.6, -1.1]],
    },
    Variant {
        name: "a suspension by the wheel's travel",
        source: concat!(
            "pub struct M { input z: length; unknown theta: angle between (-25deg, 25deg);",
            "ground A(0, 0.2), D(0.05, 0.45); crank lower(A) -> B { length: 0.38, angle: theta }",
            "rrr kingpin(B), upper(D) -> C { lengths: (0.25, 0.28), mode: right }",
            "point W on kingpin at (0.12, -0.06); solve theta { W.y = z, mode: rising } }"
        ),
        inputs: &[[0.36, 0.7, 2.3]],
    },
    Variant {
        name: "a triad between a driven point and the ground",
        source: concat!(
            "pub struct M { input x, y: length; ground A1(0, 0), A2(2.6, 0.1); param reach = 1.1;",
            "unknown phi: angle between (35deg, 70deg); point P at (x, y);",
            "crank leg1(A1) -> C1 { length: 1.6, angle: phi }",
            "rrr plate(P), bar(C1) -> C2 { lengths: (0.9, 0.7), mode: left }",
            "point C3 on plate at (0.6, 0.25);",
            "solve phi { reach + 0.02 * y = distance(A2, C3), mode: falling, near: 0.9 } }"
        ),
        inputs: &[[1.9, 0.7, -0.4], [1.4, -0.3, 0.8]],
    },
    Variant {
        name: "a crank's angle for a rocker's, its equation one of angles",
        source: concat!(
            "pub struct M { input psi: angle; unknown theta: angle between (20deg, 130deg);",
            "ground A(0, 0), D(0.6657, 0); crank AB(A) -> B { length: 80mm, angle: theta }",
            "rrr BC(B), DC(D) -> C { lengths: (632mm, 374mm), mode: right }",
            "solve theta { DC.angle = psi - 2 * AB.angle, mode: rising, near: 1.3 }",
            "crank follower(D) -> F { length: 0.1, angle: 3 * theta }",
            "output theta, C, F, DC, BC; }"
        ),
        inputs: &[[0.55, 0.8, -0.5]],
    },
    Variant {
        name: "two unknowns, the second behind the first",
        source: concat!(
            "pub struct M { input q: angle; input x: length; param lag: angle = 2deg;",
            "ground D(0.1, 0.6); guide rail through (0.2, -0.1) along 20deg;",
            "guide post through (1.2, 0) along 80deg + 0.1 * q; unknown s: length between (0.1, 0.7);",
            "slider ram(rail) -> P { slide: s } rpr block(P), bar(D) { offset: 50mm, mode: ahead }",
            "solve s { bar.angle = q - lag, mode: rising, near: 0.35 }",
            "guide slot on bar through (0.9, 0.1) along 70deg; ground O(0.9, 0.8);",
            "unknown phi: angle between (-40deg, 10deg);",
            "crank OE(O) -> E { length: 0.3, angle: phi, relative_to: bar }",
            "prp first(slot), second(post) -> R { offsets: (0.02, 0.1m * phi) }",
            "rpp pinned(E), yoke(post) { slot: 50deg, offsets: (0.03 + s / 10, -0.02) }",
            "solve phi { offset(E, post) + yoke.slide / 3 = x, mode: falling, near: -15deg } }"
        ),
        inputs: &[[-0.98, 0.5, 0.3], [0.4, 0.1, -0.05]],
    },
];
