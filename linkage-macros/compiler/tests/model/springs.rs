//! Springs, dampers, and rates in the values of forces.

use super::*;

#[test]
fn the_ends_of_a_spring_are_alike() {
    check(&[
        (
            CRANK,
            "spring between B and ground { stiffness: 20(N/mm), free_length: 0 }",
            "ground: `B` is a point and `ground` a body; name two points or two bodies / a point of the \
             ground is declared: `ground G(x, y);`",
        ),
        (
            CRANK,
            "spring between AB and D { stiffness: 20(N/mm), free_length: 0 }",
            "AB: `D` is a point and `AB` a body; name two points or two bodies / a point of `AB` is \
             declared: `point P on AB at (x, y);`",
        ),
    ]);
}

/// Springs of every kind, and rates of all that has one.
const SPRINGS: &str = "param k = 15(N/m); param l0 = 0.3m;
    spring shock between E and C { stiffness: k, free_length: l0, damping: 1.5(N*s/m) }
    spring between A and C { stiffness: 3(N/m), free_length: 0 }
    spring between B and E { damping: 2(kg/s) }
    spring clutch between AB and DC { stiffness: 5(N*m/rad), free_angle: 30deg, damping: 0.1 }
    spring between ground and CE { stiffness: 40(N*m/deg) }
    torque -0.1(N*m*s) * rate(BC.angle - AB.angle) between AB and BC;
    force (-2(N*s/m) * rate(block.slide), 3(N*s/m) * rate(C.y) + 1N) on E;
    force -5(N*s/m) * rate(distance(A, C)) between A and C;
    torque -2(N*m*s) * rate(t) on AB;";

#[test]
fn springs_and_rates_are_understood() {
    check(&[
        (SIX_BAR, SPRINGS, ""),
        (SIX_BAR, &format!("{SPRINGS} output shock.force, shock.length;"), ""),
        (SIX_BAR, &format!("{SPRINGS} output clutch.angle, clutch.torque, C;"), ""),
    ]);
    let (mechanism, _) = resolved(&format!("{SIX_BAR} {SPRINGS}"));
    let dynamics = mechanism.expect("it is understood").dynamics;
    assert_eq!(dynamics.springs.len(), 5);
    let paths: Vec<_> =
        dynamics.asked.iter().map(|asked| format!("{}.{}", asked.owner, asked.field)).collect();
    assert!(paths.join(" ").ends_with("shock.force clutch.torque"), "{paths:?}");
}

#[test]
fn a_spring_is_the_machines_own() {
    const REASON: &str = "it is made of constants and parameters";
    let spring = |fields: &str| format!("spring between B and D {{ {fields} }}");
    let rows = [
        (
            "stiffness: t * 2(N/m), free_length: 0",
            format!("t: a stiffness cannot depend on an input / {REASON}"),
        ),
        (
            "stiffness: 2(N/m), free_length: B.x",
            format!("B.x: a free length cannot depend on an input / {REASON}"),
        ),
        ("damping: t * 2(N*s/m)", format!("t: a damping cannot depend on an input / {REASON}")),
        (
            "stiffness: -2, free_length: 0",
            "-2: a stiffness of -2; make it zero or greater".to_string(),
        ),
        (
            "stiffness: 2, free_length: -1m",
            "-1m: a free length of -1; make it zero or greater".to_string(),
        ),
        ("damping: -3", "-3: a damping of -3; make it zero or greater".to_string()),
        (
            "stiffness: 2N, free_length: 0",
            "2N: a force where a force over a length (N/m) belongs / write `2(N/m)`"
                .to_string(),
        ),
        (
            "damping: 2(N/m)",
            "2(N/m): a force over a length (N/m) where a force over a speed (N*s/m) belongs / write \
             `2(N*s/m)`"
                .to_string(),
        ),
    ];
    for (fields, expected) in rows {
        check(&[(CRANK, &spring(fields), &expected)]);
    }
    check(&[
        (
            CRANK,
            "load f: force; force (f, 0) on B; spring between B and D { stiffness: f / 1m, \
             free_length: 0 }",
            "f#3: `f` is a load, and stands in forces, torques and outputs alone / what the mechanism \
             is made of and how it moves depends on no load",
        ),
        (
            CRANK,
            "spring between AB and ground { stiffness: 2(N*m), free_angle: t }",
            "t: a free angle cannot depend on an input / it is made of constants and parameters",
        ),
        (
            CRANK,
            "param k = -1; spring between B and D { stiffness: k, free_length: 0 }",
            "-1: a stiffness of -1; make it zero or greater",
        ),
    ]);
}

#[test]
fn a_spring_has_what_it_needs() {
    check(&[
        (
            CRANK,
            "spring between B and D { stiffness: 2(N/m) }",
            "}: missing field `free_length` / a spring is measured from the length at which it is \
             slack; `0` will do",
        ),
        (
            CRANK,
            "spring between B and D { }",
            "}: a spring of no stiffness and no damping does nothing / write `stiffness: …`, \
             `damping: …` or both",
        ),
        (
            CRANK,
            "spring between B and D { stiffness: 2, free_length: 0, damping: 3(N*s/m) }",
            "3(N*s/m): a spring of no free length has no damping; leave it out / where its ends \
             meet, a damper has no direction: what brakes a point in every direction is `force (-c \
             * rate(P.x), -c * rate(P.y)) on P`",
        ),
        (
            CRANK,
            "spring between B and D { stiffness: 2, length: 0.3 }",
            "length: `spring` has no field `length` / its fields are `stiffness`, `free_length` and \
             `damping`\n}: missing field `free_length` / a spring is measured from the length at \
             which it is slack; `0` will do",
        ),
        (
            CRANK,
            "spring between AB and ground { stiffness: 2, free_length: 0.3 }",
            "free_length: `spring` has no field `free_length`; a field with a similar name exists: \
             `free_angle`",
        ),
        (
            CRANK,
            "spring between B and D { stiffness: 2, stiffness: 3, free_length: 0 }",
            "stiffness#2: the field `stiffness` is given twice; remove one",
        ),
    ]);
}

#[test]
fn a_spring_stands_between_two_bodies() {
    const SPRING: &str = "{ stiffness: 2, free_length: 0 }";
    let ends = |ends: &str| format!("spring between {ends} {SPRING}");
    const INSIDE: &str = "what acts inside a body moves nothing";
    const FIXED: &str = "what acts between them moves nothing; it does where an input drives a coordinate \
                         of one, as in `at (0.2m + s, 0)`";
    check(&[
        (CRANK, &ends("A and D"), &format!("D: `A` and `D` are fixed to one body / {FIXED}")),
        (CRANK, &ends("B and B"), &format!("B#2: a spring is between two points / {INSIDE}")),
        (
            CRANK,
            "spring between AB and AB { stiffness: 2 }",
            &format!("AB#2: a spring between links is between two bodies / {INSIDE}"),
        ),
        (
            CRANK,
            "spring between AB and B { stiffness: 2 }",
            "AB: `B` is a point and `AB` a body; name two points or two bodies / a point of `AB` is \
             declared: `point P on AB at (x, y);`",
        ),
        (CRANK, &ends("B and X"), "X: no point named `X` / declared so far: `A`, `D`, `B`"),
        (
            CRANK,
            "spring AB between B and D { damping: 2 }",
            "AB: the name `AB` is taken; choose another / the first `AB` is made by `crank AB`",
        ),
        (
            CRANK,
            "spring s between B and D { damping: 2 } output s;",
            "s#2: `s` is a spring, and an output is a point or a link / between points it has \
             `s.force` and `s.length`, between links `s.torque` and `s.angle`",
        ),
        (
            CRANK,
            "spring s between B and D { damping: 2 } output s.torque;",
            "torque: the spring `s` has no `torque` / it has `force` and `length`",
        ),
    ]);
}

#[test]
fn corners_stand_in_forces_and_outputs_and_nowhere_else() {
    let alone = |name: &str| {
        format!(
            "{name}: `{name}` stands in forces, torques and outputs alone / a dimension is smooth: \
             write `hypot(x, e)` with a small `e` for `abs(x)`"
        )
    };
    for (statements, name) in [
        ("point P on AB at (max(B.x, 1m), 0);", "max"),
        ("point P on AB at (sign(t) * 1m, 0);", "sign"),
        ("output W; point W on AB at (1m, min(B.x, B.y));", "min"),
    ] {
        check(&[(CRANK, statements, &alone(name))]);
    }
    check(&[
        (CRANK, "point P on AB at (abs(-1m), max(1m, 2m) * sign(3m - 2m));", ""),
        (CRANK, "output size = abs(B.x), side = sign(t), far = min(B.x, B.y) + max(0m, B.y);", ""),
        (CRANK, "torque -2(N*m) * sign(rate(t)) on AB; force (abs(B.x) * 1(N/m), 0) on B;", ""),
        (
            CRANK,
            "output w = max(B.x, t);",
            "t: an angle where a length belongs / an angle times a length is a length, as in `theta * 20mm`",
        ),
        (CRANK, "output w = min(B.x);", "min: `min` takes two arguments, and one is given"),
    ]);
}

#[test]
fn rates_stand_in_forces_and_nowhere_else() {
    const ALONE: &str = "rate: a `rate` stands in forces, torques and outputs alone / what the \
                         mechanism is made of depends on no rate";
    for statements in [
        "point P on AB at (rate(t) * 1(m*s), 0);",
        "mass 1(kg*s) * rate(t) on B;",
        "spring between B and D { damping: 1(N*s/m) * (rate(t) * 1s) }",
    ] {
        check(&[(CRANK, statements, ALONE)]);
    }
    let torque = |value: &str| format!("load f: torque; torque {value} + f on AB;");
    check(&[
        (
            CRANK,
            &torque("2(N*m*s) * rate(AB.angle, t)"),
            "rate: `rate` takes one argument, and 2 are given",
        ),
        (
            CRANK,
            &torque("2(N*m*s*s) * rate(rate(t))"),
            "rate(t): a rate of a rate is an acceleration, on which no force may depend / what \
             resists acceleration is a mass, `mass 2kg on P`, or an inertia",
        ),
        (
            CRANK,
            &torque("1s * rate(f)"),
            "f#2: a load has no rate / it is a number that each call is given",
        ),
        (
            CRANK,
            &torque("2(N*s) * rate(distance(A, D))"),
            "distance(A, D): nothing here moves, and its rate is zero / a rate is that of an input, \
             a link's `angle` or `slide`, a point's `x` or `y`, or a `distance`",
        ),
        (
            CRANK,
            &torque("2(N*m) * rate(t)"),
            "f#2: a torque where a quantity in m^2 kg s^-3 belongs / what stands left of the `+` is a \
             quantity in m^2 kg s^-3",
        ),
    ]);
}
