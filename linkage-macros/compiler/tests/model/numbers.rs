//! Readings of points, products of units, numbers without a unit.

use super::*;

#[test]
fn a_distance_is_between_two_points() {
    check(&[
        (CRANK, "output d = distance(B, D), half = distance(A, B) / 2;", ""),
        (
            CRANK,
            "output d = distance(B);",
            "distance: `distance` takes two points, and one is given",
        ),
        (
            CRANK,
            "output d = distance(A, B, D);",
            "distance: `distance` takes two points, and 3 are given",
        ),
        (
            CRANK,
            "output d = distance(AB, D);",
            "AB: `AB` is a link, not a point / name a joint of `AB`, or a `point` on it",
        ),
        (
            CRANK,
            "output d = distance(B, 2m);",
            "2m: a distance is between two points; write a point's name / as in `distance(B, C)`; \
             a point of a link is declared with `point`",
        ),
        (
            CRANK,
            "output d = distance(B, B);",
            "B#2: the distance of a point from itself is zero; name two points",
        ),
        (
            CRANK,
            "crank EF(D) -> F { length: 1m, angle: distance(A, B) }",
            "distance(A, B): a length where an angle belongs / a length divided by a length is a \
             number, and so an angle: `s / 20mm`",
        ),
        (
            CRANK,
            "output d = distence(A, B);",
            "distence: no function named `distence`; a function with a similar name exists: \
             `distance` / the functions are `sqrt hypot sin cos tan asin acos atan atan2 abs sign \
             min max exp ln tanh pow distance offset`, and `rate` in forces, torques and outputs, `pole` in outputs",
        ),
        (
            CRANK,
            "crank EF(D) -> F { length: distance(A, F), angle: t }",
            "F#2: `F` is used inside the statement that makes it / a statement can use what earlier \
             ones have made",
        ),
    ]);
}

#[test]
fn a_ground_point_may_be_placed_by_another_but_not_by_what_moves() {
    check(&[
        (CRANK, "ground E(A.x + 200mm, D.y - A.y), F(D.x, distance(A, D));", ""),
        (
            CRANK,
            "ground E(B.x, 0);",
            "B.x: a ground point is fixed; it cannot depend on an input / a point that is driven \
             is declared `point E at (x, y);`",
        ),
        (
            CRANK,
            "ground E(0, distance(D, B));",
            "B: a ground point is fixed; it cannot depend on an input / a point that is driven is \
             declared `point E at (x, y);`",
        ),
    ]);
}

#[test]
fn a_product_of_units_is_one_quantity() {
    check(&[
        (CRANK, "param k = 15(N/m); let l = k * 2mm / 1(kg*m/s^2) * 1m; output l;", ""),
        (
            CRANK,
            "crank EF(D) -> F { length: 2(N/m), angle: t }",
            "2(N/m): a force over a length (N/m) where a length belongs / multiply or divide by what is \
             missing",
        ),
        (
            CRANK,
            "let x = 1m + 40(N*m/deg);",
            "40(N*m/deg): a torque where a length belongs / what stands left of the `+` is a length",
        ),
        (CRANK, "crank EF(D) -> F { length: 3(m/s) * 5ms + 2t / 1(kg/m), angle: 1(1/s) * 2s }", ""),
        (
            CRANK,
            "crank EF(D) -> F { length: 1m, angle: 2s }",
            "2s: a time where an angle belongs / multiply or divide by what is missing",
        ),
        (
            CRANK,
            "crank EF(D) -> F { length: 1m, angle: 2pi - t }",
            "2pi: write `2 * pi` / letters directly behind a number are its unit",
        ),
    ]);
}

/// Where an input is called as a unit is, its name was meant.
#[test]
fn a_name_taken_for_a_unit_is_told() {
    const SLIDE: &str = "input s: length; ground A(0, 0); guide rail through A along 0deg;";
    check(&[
        (SLIDE, "slider ram(rail) { slide: 2 * s }", ""),
        (
            SLIDE,
            "slider ram(rail) { slide: 2s }",
            "2s: a time where a length belongs / letters directly behind a number are its unit; \
             write `2 * s`",
        ),
        (
            SLIDE,
            "slider ram(rail) { slide: s + 2s }",
            "2s: a time where a length belongs / letters directly behind a number are its unit; \
             write `2 * s`",
        ),
    ]);
}

#[test]
fn a_bare_number_is_no_forgotten_unit() {
    check(&[
        (CRANK, "let a = 10m + 1; let b = 10mm + 0; let c = 0.5 + 1rad; output a, b, c;", ""),
        (
            CRANK,
            "let a = 10mm + 1; output a;",
            "1: write the unit of `1`: `1mm` or `1m` / a number without a unit is in metres",
        ),
        (
            CRANK,
            "let a = 2ft + 1; output a;",
            "1: write the unit of `1`: `1mm` or `1m` / a number without a unit is in metres",
        ),
        (
            CRANK,
            "let a = t - 90deg - 0.5; output a;",
            "0.5: write the unit of `0.5`: `0.5deg` or `0.5rad` / a number without a unit is in \
             radians",
        ),
    ]);
}

/// Lengths without any unit are metres, and few machines are ten of them long.
#[test]
fn lengths_without_any_unit_are_of_a_machine() {
    const BARE: &str = "input t: angle; ground A(0, 0), D(665.7, 0); \
                        crank AB(A) -> B { length: 80, angle: t }";
    check(&[
        (
            BARE,
            "rrr BC(B), DC(D) -> C { lengths: (632, 374), mode: left }",
            "before 665.7: a length of 665.7 m; write `665.7mm`, or `665.7m` if it is meant / no length \
             of this declaration has a unit, and a bare number is in metres",
        ),
        (BARE, "rrr BC(B), DC(D) -> C { lengths: (632m, 374), mode: left }", ""),
        (
            "input t: angle; param l = -250; ground A(l, 0);",
            "crank AB(A) -> B { length: 99, angle: t }",
            "before -250: a length of 250 m; write `250mm`, or `250m` if it is meant / no length of this \
             declaration has a unit, and a bare number is in metres",
        ),
        (
            "input t: angle; ground A(0, 0);",
            "crank AB(A) -> B { length: 10, angle: t }",
            "10: a length of 10 m; write `10mm`, or `10m` if it is meant / no length of this declaration has a unit, \
             and a bare number is in metres",
        ),
        ("input t: angle; ground A(0, 0);", "crank AB(A) -> B { length: 9.9, angle: t }", ""),
        ("input t: angle; ground A(0, 0);", "crank AB(A) -> B { length: 99m, angle: t }", ""),
        (
            NOTHING,
            "input theta: angle; ground A(0, 0), D(60, 10); pin B(15, 0), C(55, 40), E(70, 60);
             link crank(A, B), coupler(B, C, E), rocker(C, D); drive crank.angle = theta;",
            "E#1: a length of 81.3173 m in the drawing; write its numbers with a unit, `mm`, or `m` if it is meant / no \
             length of this declaration has a unit, and a bare number is in metres",
        ),
        // The pins alone have units.
        (
            NOTHING,
            "input theta: angle; ground A(0, 0), D(6, 1); pin B(1.5m, 0), C(5.5m, 4m);
             link crank(A, B), coupler(B, C), rocker(C, D); drive crank.angle = theta;
             point E on coupler at (12, 0);",
            "",
        ),
        (
            NOTHING,
            "input theta: angle; ground A(0, 0), D(0.6m, 0), P(240, 0); pin B(0.15m, 0), C(0.5m, 0.4m);
             link crank(A, B), coupler(B, C), rocker(C, D); drive crank.angle = theta;",
            "240: a length of 240 m; write `240mm`, or `240m` if it is meant / every length with a unit is much \
             shorter, and a bare number is in metres",
        ),
    ]);
}

/// Among millimetres, a bare length that only millimetres explain has lost its unit; metres beside small
/// offsets, and long machines in metres, are meant.
#[test]
fn a_bare_length_among_millimetres_is_not_the_longest_by_far() {
    const MILLIMETRES: &str = "input t: angle; ground A(0, 0), D(750mm, 0);";
    let told = |digits: &str| {
        format!(
            "{digits}: a length of {digits} m; write `{digits}mm`, or `{digits}m` if it is meant / every \
             length with a unit is much shorter, and a bare number is in metres"
        )
    };
    let crank = |length: &str| format!("crank AB(A) -> B {{ length: {length}, angle: t }}");
    check(&[
        (MILLIMETRES, &crank("100"), &told("100")),
        // Where the group of the bare length could not be assembled either, one message is enough.
        (
            MILLIMETRES,
            &format!(
                "{} rrr BC(B), DC(D) -> C {{ lengths: (510mm, 500), mode: left }}",
                crank("250mm")
            ),
            &told("500"),
        ),
        (
            MILLIMETRES,
            &format!("param l = 12.5; {} point P on AB at (l, 3mm);", crank("l")),
            &told("12.5"),
        ),
        (MILLIMETRES, &crank("9.9"), ""),
        (MILLIMETRES, &crank("100m"), ""),
        ("input t: angle; ground A(0, 0), D(2m, 3mm);", &crank("100"), &told("100")),
        ("input t: angle; ground A(0, 0), D(2m, 3mm);", &crank("19.9"), ""),
        ("input t: angle; ground A(0, 0), D(11m, 3mm);", &crank("12"), ""),
        ("input t: angle; ground A(0, 0), D(2000mm, 0);", &crank("19.9"), ""),
        ("input t: angle; ground A(0, 0), D(2000mm, 0);", &crank("20"), &told("20")),
    ]);
}

/// Units behind a number stand in parentheses; a name that is declared is no unit.
#[test]
fn products_of_units_have_parentheses() {
    const REASON: &str = "a product of units stands in parentheses";
    check(&[
        (CRANK, "torque 5kN*m on AB;", &format!("5kN*m: write `5(kN*m)` / {REASON}")),
        (CRANK, "torque -5kN*m on AB;", &format!("5kN*m: write `5(kN*m)` / {REASON}")),
        (CRANK, "torque 5kNm on AB;", &format!("5kNm: write `5(kN*m)` / {REASON}")),
        (
            CRANK,
            "spring between A and B { stiffness: 20N/mm, free_length: 0 }",
            &format!("20N/mm: write `20(N/mm)` / {REASON}"),
        ),
        (CRANK, "let m = 2m; torque 5kN*m on AB;", ""),
        ("input s: length;", "ground A(0, 0); point P at (2m + s * 2m / 1m, 0);", ""),
    ]);
}

/// A product that misses a dimension and has a number without a unit is told that unit.
#[test]
fn a_factor_without_a_unit_is_told_its_unit() {
    check(&[
        (
            CRANK,
            "force (-10 * rate(B.x), 0) on B;",
            "-10 * rate(B.x): a speed where a force belongs / give `10` its unit: `10(N*s/m)`",
        ),
        (
            CRANK,
            "torque -(rate(AB.angle) * 0.5 / 2) on AB;",
            "-(rate(AB.angle) * 0.5 / 2): a rate (1/s) where a torque belongs / give `0.5` its unit: \
             `0.5(N*m*s)`",
        ),
        (
            CRANK,
            "param c = 1.5; force (-c * rate(B.x), 0) on B;",
            "-c * rate(B.x): a speed where a force belongs / give `c` its unit where it is declared: \
             `param c = 1.5(N*s/m)`",
        ),
        (
            CRANK,
            "force (3 * B.x, 0) on B;",
            "3 * B.x: a length where a force belongs / give `3` its unit: `3(N/m)`",
        ),
        // A divisor, a sum and a number that has its unit are told no other.
        (
            CRANK,
            "force (3 + B.x, 0) on B;",
            "3 + B.x: a length where a force belongs / multiply or divide by what is missing",
        ),
        (
            CRANK,
            "force (B.x / 3, 0) on B;",
            "B.x / 3: a length where a force belongs / multiply or divide by what is missing",
        ),
        (
            CRANK,
            "force (3kg * rate(B.x), 0) on B;",
            "3kg * rate(B.x): a quantity in m kg s^-1 where a force belongs / multiply or divide by \
             what is missing",
        ),
        (CRANK, "param c = 10(N*s/m); force (-c * rate(B.x), 0) on B;", ""),
    ]);
}
