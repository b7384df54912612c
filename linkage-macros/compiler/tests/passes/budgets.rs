//! Cost limits of each driver and group, by variant: a lost common subexpression, a constant that leaves a
//! trace, or a group that is computed without a request fails here by name.
//!
//! A budget counts what an output costs beyond the declaration without it: additions,
//! multiplications, divisions, roots, and sine-cosine pairs, a fused operation counting as an
//! addition and a multiplication. Lowering a number is welcome; raising one needs a reason. The
//! affine square of a distance is one addition more than the sum of squares beside a pivot that
//! lies aside of the crank's axes, and known three operations earlier; on the axis it is less. The
//! accelerations of an rrr whose bars are nearly of one length, or of lengths not known before run
//! time, pay for the digits that their centripetal terms would lose. Bars of lengths not known before
//! run time also pay for what rounding does to their height, which says on which side of a limit they
//! are. Between three and five lengths of the crank away, a pivot on its axis costs a position one
//! multiplication: the affine square agrees less well with the line whose square it is. A motion of an rrr
//! takes up to three operations more than it could: half of i, for which no position waits, and the arm's
//! products with d, by which those with the bars need not wait for the bars.

use crate::interface::entries::EntryPoint;
use crate::ir::cost::{Operations, operations};
use crate::oracle::mechanism;
use crate::{equations, lower, passes};

/// Additions, multiplications, divisions, roots, sine-cosine pairs.
type Budget = [u32; 5];

fn cost(source: &str, entry: &str) -> Budget {
    let mechanism = mechanism(source);
    let program = passes::optimise(&equations::derive(&mechanism, passes::RULES));
    let lowered = lower::lower(&mechanism, &program);
    let entry = lowered.interface.find(EntryPoint::named(entry)).expect("the entry exists");
    let Operations { additions, multiplications, divisions, roots, sines } =
        lowered.costs[entry.index()];
    [additions, multiplications, divisions, roots, sines]
}

/// A group after a crank: both joints on the ground but for B, or on what the prelude moves.
macro_rules! after_crank {
    ($($rest:literal)*) => {
        concat!(
            "struct M { input q: angle; param p = 0.7m; ground A(0, 0), D(0.9, 0.15), E(0.9, 0);",
            "guide level through (0, 0.1) along 0deg; guide slope through (0.2, -0.1) along 20deg;",
            "guide post through (0.7, 0) along 90deg;",
            "crank AB(A) -> B { length: 0.3, angle: q }",
            "crank EF(E) -> F { length: 0.2, angle: -q }",
            "guide way on EF through (0.05, 0.1) along 65deg;",
            $($rest,)* "}"
        )
    };
}

#[test]
fn every_variant_keeps_its_budget() {
    let mut broken = Vec::new();
    for &(name, source, position, motion) in CASES {
        let found = (cost(source, "position"), cost(source, "motion"));
        if found != (position, motion) {
            broken.push(format!("{name}: {found:?} instead of {:?}", (position, motion)));
        }
    }
    assert!(broken.is_empty(), "{}", broken.join("\n"));
}

#[test]
fn what_is_not_asked_for_costs_nothing() {
    let crank = cost(after_crank!("output B;"), "motion");
    let with_groups = after_crank!(
        "rrr BC(B), DC(D) -> C { lengths: (0.8, 0.5), mode: left }"
        "rrp CE(C), block(level) -> G { length: 0.9, mode: ahead } output B;"
    );
    assert_eq!(cost(with_groups, "motion"), crank);
}

#[test]
fn constants_leave_no_trace() {
    let plain = after_crank!("rrp BC(B), block(level) -> C { length: 0.9, mode: ahead } output C;");
    let spelt = after_crank!(
        "let none = 2mm - 0.002m; let l = sqrt(0.81m * 1m) + none * 3;"
        "guide same through (0m * 5, 100mm) along 360deg - 2 * 180deg;"
        "rrp BC(B), block(same) -> C { length: l, offset: none, mode: ahead } output C;"
    );
    assert_eq!(cost(spelt, "motion"), cost(plain, "motion"));
}

/// A four-bar of three uniform bars under gravity, and what is asked of it.
macro_rules! heavy_four_bar {
    ($output:literal) => {
        concat!(
            "struct M { input q: angle; ground A(0, 0), D(0.75, 0); gravity (0, -9.81);",
            "crank AB(A) -> B { length: 0.25, angle: q }",
            "rrr BC(B), DC(D) -> C { lengths: (0.51, 0.5), mode: left }",
            "mass 0.05221 on AB uniform; mass 0.10421 on BC uniform; mass 0.10221 on DC uniform;",
            $output,
            "}"
        )
    };
}

/// All operations before products are contracted into sums.
fn written(source: &str, entry: &str) -> u32 {
    let program = equations::derive(&mechanism(source), passes::RULES);
    let entry = program.answer(entry).expect("the entry exists");
    let Operations { additions, multiplications, divisions, roots, sines } =
        operations(&program.graph, &entry.sinks);
    additions + multiplications + divisions + roots + sines
}

#[test]
fn forces_keep_their_budgets() {
    let drive = heavy_four_bar!("output q.drive;");
    let all = heavy_four_bar!("output q.drive, AB.A, AB.B, BC.B, BC.C, DC.C, DC.D;");
    let one = heavy_four_bar!("output DC.D;");
    let found = [drive, all].map(|source| [written(source, "forces"), written(source, "statics")]);
    let [[drive, drive_at_rest], [all, all_at_rest]] = found;
    let text = format!("{found:?}");
    assert!(drive <= 100 && drive_at_rest <= 51, "{text}");
    assert!(all <= 132 && all_at_rest <= 54, "{text}");
    let forward = written(heavy_four_bar!("output q.drive;"), "forward_dynamics");
    assert!(forward <= 100, "{forward}");
    assert!(written(one, "forces") < all && written(one, "statics") < all_at_rest, "{text}");
}

/// Three pins of a group share what their common force changes by: a sign taken for another sum costs a third unknown. 56
/// operations of a motion bound the rounding of its slips and of their rates, and 29 that of a creep.
#[test]
fn friction_keeps_its_budgets() {
    let rrr = heavy_four_bar!(
        "friction 0.1 at B radius 0.02; friction 0.1 at C radius 0.02; friction 0.1 at D radius 0.02;
         output q.drive;"
    );
    let found = [written(rrr, "forces"), written(rrr, "statics")];
    assert!(found[0] <= 477 && found[1] <= 366, "{found:?}");
}

/// Name, declaration, and the budgets of position and motion.
const CASES: &[(&str, &str, Budget, Budget)] = &[
    ("crank", after_crank!("output B;"), [0, 2, 0, 0, 1], [2, 9, 0, 0, 1]),
    ("crank's direction", after_crank!("output AB;"), [0, 0, 0, 0, 1], [0, 0, 0, 0, 1]),
    ("two cranks", after_crank!("output B, F;"), [1, 4, 0, 0, 2], [5, 17, 0, 0, 2]),
    (
        "crank on a moving pivot",
        after_crank!("crank BG(B) -> G { length: 0.1, angle: 30deg, relative_to: AB } output G;"),
        [4, 8, 0, 0, 1],
        [6, 15, 0, 0, 1],
    ),
    (
        "slider on a level guide",
        "struct M { input s: length; guide g through (0, 0.1) along 0deg; slider r(g) -> P { slide: s } output P; }",
        [0, 0, 0, 0, 0],
        [0, 0, 0, 0, 0],
    ),
    (
        "slider on a sloping guide",
        "struct M { input s: length; guide g through (0, 0.1) along 20deg; slider r(g) -> P { slide: s } output P; }",
        [1, 2, 0, 0, 0],
        [1, 6, 0, 0, 0],
    ),
    (
        "rrr, pin",
        after_crank!("rrr BC(B), DC(D) -> C { lengths: (0.8, 0.5), mode: left } output C;"),
        [10, 11, 1, 1, 1],
        [23, 37, 2, 1, 1],
    ),
    (
        "rrr, axis-parallel pivots",
        after_crank!("rrr BC(B), EC(E) -> C { lengths: (0.8, 0.5), mode: left } output C;"),
        [8, 11, 1, 1, 1],
        [20, 35, 2, 1, 1],
    ),
    (
        "rrr, equal bars",
        after_crank!("rrr BC(B), DC(D) -> C { lengths: (0.8, 0.8), mode: left } output C;"),
        [8, 10, 1, 1, 1],
        [21, 37, 2, 1, 1],
    ),
    (
        "rrr, bars that differ by a seventh",
        after_crank!("rrr BC(B), DC(D) -> C { lengths: (0.8, 0.6), mode: left } output C;"),
        [10, 11, 1, 1, 1],
        [23, 37, 2, 1, 1],
    ),
    (
        "rrr, bars that differ by less",
        after_crank!("rrr BC(B), DC(D) -> C { lengths: (0.8, 0.601), mode: left } output C;"),
        [10, 11, 1, 1, 1],
        [25, 40, 2, 1, 1],
    ),
    (
        "rrr, first bar",
        after_crank!("rrr BC(B), DC(D) -> C { lengths: (0.8, 0.5), mode: left } output BC;"),
        [10, 13, 1, 1, 1],
        [19, 33, 2, 1, 1],
    ),
    (
        "rrr, both bars and pin",
        after_crank!("rrr BC(B), DC(D) -> C { lengths: (0.8, 0.5), mode: left } output BC, DC, C;"),
        [12, 15, 1, 1, 1],
        [27, 48, 2, 1, 1],
    ),
    (
        "rrr, coupler point",
        after_crank!(
            "rrr BC(B), DC(D) -> C { lengths: (0.8, 0.5), mode: left } point P on BC at (0.3, 0.1); output P;"
        ),
        [14, 15, 1, 1, 1],
        [31, 47, 2, 1, 1],
    ),
    (
        "rrr, a length to tune",
        after_crank!("rrr BC(B), DC(D) -> C { lengths: (p, 0.5), mode: left } output C;"),
        [11, 20, 2, 1, 1],
        [30, 60, 3, 1, 1],
    ),
    (
        "rrr on moving points",
        after_crank!("rrr BC(B), FC(F) -> C { lengths: (0.8, 0.7), mode: left } output C;"),
        [13, 13, 1, 1, 2],
        [34, 49, 2, 1, 2],
    ),
    (
        "rrr with a cylinder on the ground",
        "struct M { input s: length; ground A(0, 0), D(0.9, 0.15);
         rrr AC(A), DC(D) -> C { lengths: (s, 0.5), mode: left } output C; }",
        [8, 10, 0, 1, 0],
        [12, 24, 1, 1, 0],
    ),
    (
        "rrr with a cylinder between joints of one link",
        "struct M { input q: angle; input s: length; ground A(0, 0);
         crank AB(A) -> B { length: 0.3, angle: q } point K on AB at (0.25, 0.2);
         rrr KC(K), BC(B) -> C { lengths: (s, 0.6), mode: right } output C; }",
        [10, 17, 0, 1, 1],
        [22, 39, 1, 1, 1],
    ),
    (
        "rrr with a cylinder between joints of two links",
        "struct M { input q: angle; input s: length; ground A(0, 0), D(0.9, 0.15);
         crank AB(A) -> B { length: 0.3, angle: q } crank DE(D) -> E { length: 0.2, angle: -q }
         rrr EC(E), BC(B) -> C { lengths: (s, 0.6), mode: right } output C; }",
        [13, 24, 2, 1, 2],
        [48, 83, 3, 1, 2],
    ),
    (
        "rrr with a cylinder",
        after_crank!(
            "rrr BC(B), DC(D) -> C { lengths: (0.8 + 0.1m * q, 0.5), mode: left } output C;"
        ),
        [12, 21, 2, 1, 1],
        [37, 75, 3, 1, 1],
    ),
    (
        "rrp on a level guide",
        after_crank!("rrp BC(B), block(level) -> C { length: 0.9, mode: ahead } output C;"),
        [4, 3, 0, 1, 1],
        [10, 17, 1, 1, 1],
    ),
    (
        "rrp on a level guide with offset",
        after_crank!(
            "rrp BC(B), block(level) -> C { length: 0.9, offset: 0.05, mode: ahead } output C;"
        ),
        [5, 3, 0, 1, 1],
        [11, 17, 1, 1, 1],
    ),
    (
        "rrp on an upright guide",
        after_crank!("rrp BC(B), block(post) -> C { length: 0.9, mode: ahead } output C;"),
        [4, 3, 0, 1, 1],
        [10, 17, 1, 1, 1],
    ),
    (
        "rrp on a sloping guide",
        after_crank!("rrp BC(B), block(slope) -> C { length: 0.9, mode: ahead } output C;"),
        [9, 9, 0, 1, 1],
        [19, 35, 1, 1, 1],
    ),
    (
        "rrp on a moving guide",
        after_crank!("rrp BC(B), block(way) -> C { length: 1.9, mode: ahead } output C;"),
        [14, 17, 0, 1, 2],
        [36, 45, 1, 1, 2],
    ),
    (
        "rrp, slide",
        after_crank!(
            "rrp BC(B), block(slope) -> C { length: 0.9, mode: ahead } output block.slide;"
        ),
        [7, 7, 0, 1, 1],
        [17, 29, 1, 1, 1],
    ),
    ("rpr", after_crank!("rpr block(B), bar(D) {} output bar;"), [3, 6, 1, 1, 1], [6, 18, 2, 1, 1]),
    (
        "rpr with slide",
        after_crank!("rpr block(B), bar(D) {} output block;"),
        [3, 6, 1, 1, 1],
        [8, 24, 2, 1, 1],
    ),
    (
        "rpr with offset",
        after_crank!("rpr block(B), bar(D) { offset: 0.1 } output block;"),
        [6, 10, 1, 1, 1],
        [15, 33, 2, 1, 1],
    ),
    (
        "rpr about a moving pivot",
        after_crank!("rpr block(B), bar(F) {} output block;"),
        [4, 8, 1, 1, 2],
        [18, 35, 1, 1, 2],
    ),
    (
        "prp on axis-parallel guides",
        after_crank!(
            "guide high through (0, 0.3) along 0deg; prp a(high), b(post) -> C {} point T at (cos(q) * 1m, 0); output C, T;"
        ),
        [0, 0, 0, 0, 1],
        [1, 4, 0, 0, 1],
    ),
    (
        "prp on moving and fixed guide",
        after_crank!("prp a(way), b(slope) -> C {} output C;"),
        [10, 13, 1, 0, 2],
        [16, 31, 1, 0, 2],
    ),
    (
        "rpp, upright slot on a level rail",
        after_crank!("rpp block(B), yoke(level) { slot: 90deg } output block.slide, yoke.slide;"),
        [1, 2, 0, 0, 1],
        [3, 9, 0, 0, 1],
    ),
    (
        "rpp, sloping slot",
        after_crank!("rpp block(B), yoke(level) { slot: 60deg } output block.slide, yoke.slide;"),
        [2, 4, 0, 0, 1],
        [6, 15, 0, 0, 1],
    ),
    (
        "rpp on a moving rail",
        after_crank!("rpp block(B), yoke(way) { slot: 60deg } output block.slide, yoke.slide;"),
        [10, 16, 0, 0, 2],
        [28, 44, 0, 0, 2],
    ),
];
