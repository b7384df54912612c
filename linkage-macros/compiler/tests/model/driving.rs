//! `drive theta by pull;`: where the load may stand, and what is asked for in place of the drive.

use super::{CRANK, GUIDE, SIX_BAR, check, resolved};

const PULL: &str = "load pull: force; mass 1kg on B;";

/// The outputs of forces where nothing is asked for.
fn asked(base: &str, statements: &str) -> Vec<String> {
    let (mechanism, mistakes) = resolved(&format!("{base} {statements}"));
    let dynamics = mechanism.unwrap_or_else(|| panic!("{mistakes}")).dynamics;
    dynamics.asked.iter().map(|asked| asked.path()).collect()
}

#[test]
fn the_load_stands_in_place_of_the_drive() {
    let all = asked(CRANK, &format!("{PULL} force (0, pull) on B; drive t by pull;"));
    assert_eq!(all, ["pull", "AB.A"]);
    let some = "output pull, AB.A, twice = 2 * pull;";
    let all = asked(CRANK, &format!("{PULL} force (0, pull) on B; drive t by pull; {some}"));
    assert_eq!(all, ["pull", "AB.A", "twice"]);
    // The other loads are given, in their order.
    let statements = "load first: force; load pull: torque; load last: force; torque pull on AB; \
                      force (first, last) on B; drive t by pull;";
    let (mechanism, _) = resolved(&format!("{CRANK} {statements}"));
    let dynamics = mechanism.expect("it is legal").dynamics;
    let loads: Vec<_> = dynamics.loads.iter().map(|load| load.name.to_string()).collect();
    assert_eq!(loads, ["first", "last"]);
    assert_eq!(dynamics.driven().expect("one drives").1.name, "pull");
}

/// A crank's own drive is none where the input that a load drives moves nothing else, and some where it does.
#[test]
fn the_drive_of_a_crank_is_put_in_by_the_load() {
    const NONE: &str =
        "AB: `pull` drives `AB` by `t`; ask for `pull` / a drive of its own would put in nothing";
    let driven = format!("{PULL} force (0, pull) on B; drive t by pull; output AB.drive;");
    check(&[(CRANK, &driven, NONE)]);
    for other in [
        "crank EF(D) -> F { length: 1, angle: t }",
        "crank EF(D) -> F { length: 1, angle: -t }",
        "crank EF(D) -> F { length: 1, angle: 2 * t + 1rad }",
        "let twice = 2 * t; crank EF(D) -> F { length: 1, angle: 1rad - sin(twice) * 1rad }",
        "point F at (1m * sin(t), 0);",
        "point F on AB at (0.1m, 0.1m * t);",
        "point F on AB at polar (0.1m, t);",
        "point F on AB at distances (0.7m, 0.7m + 0.1m * sin(t)) left;",
        "point F at (1m * ln(9 + t / 1rad), 0);",
        "guide rail through (1m * t, 0) along 0deg; slider ram(rail) -> F { slide: 1m }",
        "guide rail through (1m, 0) along t; slider ram(rail) -> F { slide: 1m }",
        "guide rail through (1m, 0) along 10deg; slider ram(rail) -> F { slide: 1m * t }",
        "guide rail through (1m, 0) along 10deg; slider ram(rail) -> F { slide: 1m, offset: 0.1m * t }",
        "guide rail through (1m, 0) along 10deg; rpp block(B), yoke(rail) { slot: 90deg + t / 9, offsets: (0, 0) }",
        "rrr BF(B), DF(D) -> F { lengths: (1.5, 1.5 + 0.1 * cos(t)), mode: left }",
    ] {
        let moved =
            format!("{other} {driven}").replace("mass 1kg on B;", "mass 1kg on AB at (1, 0);");
        check(&[(CRANK, &moved, "")]);
    }
}

#[test]
fn forces_are_multiples_of_the_load_that_drives() {
    for force in [
        "force (pull, 0) on B;",
        "force (5N - pull * cos(t) / 2, -pull) on B;",
        "let half = pull / 2; let law = half * rate(t) * 1s; force (law, half) on B;",
        "let wide = pull * pull; force (pull, 0) on B; output AB.A, square = 1 / wide;",
        "force pull between B and D;",
        "torque pull * 0.1m between ground and AB;",
    ] {
        check(&[(CRANK, &format!("{PULL} {force} drive t by pull;"), "")]);
    }
    const REASON: &str = "the value of `pull` follows from one linear equation: write `2 * pull` or `5N - pull * \
                          cos(theta)`, and no function of it";
    for (force, at) in [
        ("force (max(0, pull), 0) on B;", "pull"),
        ("force (0, pull * pull / 1N) on B;", "pull"),
        ("force (-(pull * pull / 1N), 0) on B;", "pull"),
        ("force (1N * 1N / pull, 0) on B;", "pull"),
        ("let law = abs(pull); force (law, 0) on B;", "law"),
        (
            "let half = pull / 2; let law = half * rate(t) * 1s; force (law * half / 1N, 0) on B;",
            "law",
        ),
        ("torque 1(N*m) * exp(pull / 1N) on AB;", "pull"),
        ("torque 1(N*m) * ln(2 - pull / 1N) on AB;", "pull"),
        ("force hypot(pull, 1N) between B and D;", "pull"),
    ] {
        let refused =
            format!("{at}#2: a force is a multiple of `pull`, which drives an input / {REASON}");
        check(&[(CRANK, &format!("{PULL} {force} drive t by pull;"), &refused)]);
        // A load that is given may stand anywhere.
        check(&[(CRANK, &format!("{PULL} {force}"), "")]);
    }
}

#[test]
fn one_load_drives_one_input() {
    const TWICE: &str = "one load drives one input; remove this statement / the values of several loads would \
                         follow from each other";
    let with = |statements: &str| format!("{PULL} force (pull, 0) on B; {statements}");
    check(&[
        (CRANK, &with("drive t by pull; drive t by pull;"), &format!("t#2: {TWICE}")),
        (
            CRANK,
            &with("load push: force; force (push, 0) on B; drive t by pull; drive t by push;"),
            &format!("t#2: {TWICE}"),
        ),
        (
            CRANK,
            &with("drive t by push;"),
            "push: no load named `push`; a load with a similar name exists: `pull`",
        ),
        (CRANK, &with("drive AB by pull;"), "AB: `AB` is a link, not an input"),
        (
            CRANK,
            &with("load push: force; force (push, 0) on B; drive AB by pull; drive t by push;"),
            &format!("AB: `AB` is a link, not an input\nt: {TWICE}"),
        ),
        (CRANK, &with("drive t by t;"), "t#2: `t` is an input, not a load"),
        (
            CRANK,
            "mass 1kg on B; drive t by pull; load pull: force; force (pull, 0) on B;",
            "pull#1: `pull` is used before `load pull` makes it / this order works: `load pull`, `drive t by pull`",
        ),
        (
            GUIDE,
            "load pull: force; mass 1kg on B; force (pull, 0) on B; drive t by rail;",
            "rail: `rail` is a guide, not a load",
        ),
    ]);
}

#[test]
fn a_load_that_drives_has_to_act() {
    const UNUSED: &str =
        "pull#1: nothing uses the load `pull`; use it or remove it / as in `force (0, -pull) on P`";
    check(&[
        (CRANK, &format!("{PULL} drive t by pull;"), UNUSED),
        (CRANK, &format!("{PULL} drive t by pull; output pull;"), UNUSED),
        (CRANK, &format!("{PULL} drive t by pull; output twice = 2 * pull;"), UNUSED),
    ]);
}

#[test]
fn an_input_that_is_driven_has_no_effort_of_its_own() {
    let driven = |output: &str| format!("{PULL} force (pull, 0) on B; drive t by pull; {output}");
    const REFUSED: &str =
        "t#2: `t` is driven by `pull`; ask for `pull` / a drive of its own would put in nothing";
    check(&[
        (CRANK, &driven("output t.drive;"), REFUSED),
        (CRANK, &driven("output power = t.drive * rate(t);"), REFUSED),
        (CRANK, &driven("output power = pull * rate(B.x);"), ""),
        (
            CRANK,
            &driven("output pull, pull;"),
            "pull#5: the output `pull` is given twice; remove one",
        ),
        (
            CRANK,
            &format!("{PULL} force (pull, 0) on B; output pull;"),
            "pull#3: `pull` is a load, and an output is a point or a link / it is given, at each call",
        ),
    ]);
}

#[test]
fn joints_rub_beside_a_load_that_drives() {
    let pulled = |friction: &str| {
        format!("load pull: force; force (pull, 0) on E; drive t by pull; {friction}")
    };
    check(&[
        (SIX_BAR, &pulled("friction 0.1 on block; output losses, pull, block.rail.friction;"), ""),
        (
            SIX_BAR,
            &pulled("friction 0.1 + pull / 9N on block;"),
            "pull#4: no coefficient depends on `pull`, which drives an input / `pull` follows from friction, and its \
             equation is linear",
        ),
    ]);
    let rubbing = |count: usize| {
        let cranks = (0..count).map(|nth| {
            format!(
                "crank L{nth}(A) -> P{nth} {{ length: 1m, angle: t }} \
                 friction 0.1 on L{nth} at A radius 5mm;"
            )
        });
        let cranks: String = cranks.collect();
        format!("load pull: force; {cranks} force (pull, 0) on P0; drive t by pull;")
    };
    check(&[
        (CRANK, &rubbing(8), ""),
        (
            CRANK,
            &rubbing(9),
            "friction#9: a joint too many rubs beside `pull`, which drives an input / its value and the friction of \
             up to eight joints follow from each other",
        ),
    ]);
}

#[test]
fn a_drawing_is_driven_by_a_load() {
    const DRAWN: &str = "input q: angle; ground A(0, 0), D(4m, 0); pin B(1m, 0), C(3m, 2m); \
                         link AB(A, B), BC(B, C), DC(D, C); drive AB.angle = q;";
    let all = asked(
        DRAWN,
        "drive q by brake; load brake: torque; torque -brake on DC; mass 1kg on C; output brake;",
    );
    assert_eq!(all, ["brake"]);
}
