//! Laws: named expressions that read rates or loads, and where they stand.

use super::{CRANK, SIX_BAR, check};

#[test]
fn laws_stand_in_forces_and_torques() {
    for statements in [
        "let law = -5(N*m*s) * rate(t); torque law on AB;",
        "load cut: force; let law = -5(N*s/m) * rate(B.x) + cut; force (law, 2 * law) on B;",
        "load cut: force; let half = cut / 2; let full = half + half; force (full, 0) on B;",
        "let w = abs(t); torque 1(N*m) * w on AB;",
        "let w = abs(t); torque 1(N*m*s) * rate(w) on AB;",
        "let w = rate(t); let quick = max(0, w); torque 1(N*m*s) * quick on AB;",
    ] {
        check(&[(CRANK, statements, "")]);
    }
    let of_a_rate =
        "mass 1kg on E; let v = rate(block.slide); friction 0.1 * (1 - v / 9(m/s)) on block;";
    check(&[(SIX_BAR, of_a_rate, "")]);
}

#[test]
fn no_dimension_reads_a_law() {
    const FORM: &str =
        "what the mechanism is made of and how it moves depends on no load and no rate";
    let refused = |what: &str| {
        format!(
            "law#2: `law` reads {what}, and stands in forces, torques and outputs alone / {FORM}"
        )
    };
    for statements in [
        "let law = rate(t) * 1(m*s); point P on AB at (law, 0);",
        "let law = rate(t) * 1s; crank AC(A) { angle: law }",
        "let law = rate(t) * 1(m*s); rrr BC(B), DC(D) -> C { lengths: (law, 3m), mode: left }",
        "let law = rate(t) * 1(kg*s); mass law on B;",
        "let law = rate(t) * 1s; mass 1kg on B; gravity (0, -law * 9.81(m/s^2));",
        "let law = rate(t) * 1(N*s/m); spring between B and D { stiffness: law, free_length: 0 }",
        "let law = rate(t) * 1s; stop AB.angle between (0, law) { stiffness: 5(N*m) }",
    ] {
        check(&[(CRANK, statements, &refused("a rate"))]);
    }
    let of_a_load =
        "load f: number; let law = f * 1m; point P on AB at (law, 0); force (f * 1N, 0) on B;";
    check(&[(CRANK, of_a_load, &refused("a load"))]);
    let of_both = "load f: number; let law = f * rate(t) * 1s; let other = law; \
                   crank AC(A) { angle: other } torque f * 1(N*m) on AB;";
    check(&[(CRANK, of_both, &refused("loads and rates").replace("law", "other"))]);
}

#[test]
fn a_corner_is_refused_where_it_is_used() {
    check(&[(
        CRANK,
        "let w = abs(t); crank AC(A) { angle: w }",
        "w#2: `w` has a corner by `abs`, and stands in forces, torques and outputs alone / a dimension \
         is smooth: write `hypot(x, e)` with a small `e` for `abs(x)`",
    )]);
}

#[test]
fn a_law_has_no_rate() {
    check(&[
        (
            CRANK,
            "let v = rate(t); torque 1(N*m*s*s) * rate(2 * v) on AB;",
            "v#2: a rate of a rate is an acceleration, on which no force may depend / what resists \
             acceleration is a mass, `mass 2kg on P`, or an inertia",
        ),
        (
            CRANK,
            "load f: torque; let half = f / 2; torque f + 1s * rate(half) on AB;",
            "half#2: a load has no rate / it is a number that each call is given",
        ),
    ]);
}

#[test]
fn a_load_is_used_by_a_law_that_is_used() {
    const UNUSED: &str =
        "f#1: nothing uses the load `f`; use it or remove it / as in `torque f on BC`";
    check(&[
        (CRANK, "load f: torque; let half = f / 2; torque half on AB;", ""),
        (CRANK, "load f: torque; let half = f / 2; torque 1(N*m) on AB;", UNUSED),
    ]);
}

#[test]
fn a_law_stands_behind_what_it_reads() {
    check(&[(
        SIX_BAR,
        "let law = -5(N*m*s) * rate(later); let later = t / 2; torque law on AB;",
        "later#1: `later` is used before `let later` makes it / this order works: `let later`, `let law`",
    )]);
}

#[test]
fn a_drawing_has_laws() {
    const DRAWN: &str = "input q: angle; ground A(0, 0), D(4m, 0); pin B(1m, 0), C(3m, 2m); \
                         link AB(A, B), BC(B, C), DC(D, C); drive AB.angle = q;";
    check(&[
        (DRAWN, "let law = -5(N*m*s) * rate(DC.angle); torque law on DC;", ""),
        (DRAWN, "load f: torque; torque law on DC; let law = f - 5(N*m*s) * rate(DC.angle);", ""),
        (
            DRAWN,
            "let law = 1(kg*s) * rate(q); mass law on C;",
            "law#2: `law` reads a rate, and stands in forces, torques and outputs alone / what the mechanism is \
             made of and how it moves depends on no load and no rate",
        ),
    ]);
}

/// A statement that makes what the law reads needs the law itself, in no order.
#[test]
fn a_law_that_is_made_too_late_is_refused_as_a_law() {
    const RAM: &str = "input t: angle; ground A(0, 0); guide bed through A along 0deg; \
                       crank AB(A) -> B { length: 1m, angle: t }";
    const FORM: &str =
        "what the mechanism is made of and how it moves depends on no load and no rate";
    let refused = |what: &str| {
        format!(
            "brake#1: `brake` reads {what}, and stands in forces, torques and outputs alone / {FORM}"
        )
    };
    for (statements, what) in [
        (
            "rrp BC(B), ram(bed) -> C { length: brake, mode: ahead } \
             let brake = -5(m*s/m) * rate(ram.slide);",
            "a rate",
        ),
        (
            "load f: number; rrp BC(B), ram(bed) -> C { length: brake, mode: ahead } \
             let brake = f * 1m; force (f * 1N, 0) on B;",
            "a load",
        ),
        (
            "point P on AB at (brake, 0); rrp BC(B), ram(bed) -> C { length: 3m, mode: ahead } \
             let brake = -5(m*s/m) * rate(ram.slide);",
            "a rate",
        ),
    ] {
        check(&[(RAM, statements, &refused(what))]);
    }
    // Forces and other laws only have to wait.
    let late =
        "brake#1: `brake` is used before `let brake` makes it / this order works: `let brake`, ";
    for (statements, last) in [
        ("torque brake on AB; let brake = -5(N*m*s) * rate(t);", "``"),
        (
            "let twice = 2 * brake; let brake = -5(N*m*s) * rate(t); torque twice on AB;",
            "`let twice`",
        ),
    ] {
        check(&[(RAM, statements, &format!("{late}{last}"))]);
    }
}

/// A name behind a load does not hide it.
#[test]
fn a_sum_reads_all_that_its_parts_read() {
    const FORM: &str =
        "what the mechanism is made of and how it moves depends on no load and no rate";
    for (first, what) in [("2 * t", "a load"), ("rate(t) * 1s", "loads and rates")] {
        let statements = format!(
            "load f: number; let w = {first}; let both = f + w; crank AC(A) {{ angle: both }} \
             torque f * 1(N*m) on AB;"
        );
        let refused = format!(
            "both#2: `both` reads {what}, and stands in forces, torques and outputs alone / {FORM}"
        );
        check(&[(CRANK, &statements, &refused)]);
    }
}
