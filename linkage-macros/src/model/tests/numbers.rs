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
            "B: the distance of a point from itself is zero; name two points",
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
             `distance` / the functions are `sqrt hypot sin cos tan asin acos atan atan2 distance \
             offset`, and `rate` in the values of forces and torques",
        ),
        (
            CRANK,
            "crank EF(D) -> F { length: distance(A, F), angle: t }",
            "F: `F` is used inside the statement that makes it / a statement can use what earlier \
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
             write `2 * s`\ns: nothing uses the input `s`; use it or remove it / a driver takes \
             it: `slider ram(rail) { slide: s }`",
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
            "let a = t - 90deg - 0.5; output a;",
            "0.5: write the unit of `0.5`: `0.5deg` or `0.5rad` / a number without a unit is in \
             radians",
        ),
    ]);
}

/// Lengths without any unit are metres, and few machines are a hundred of them long.
#[test]
fn lengths_without_any_unit_are_of_a_machine() {
    const BARE: &str = "input t: angle; ground A(0, 0), D(665.7, 0); \
                        crank AB(A) -> B { length: 80, angle: t }";
    check(&[
        (
            BARE,
            "rrr BC(B), DC(D) -> C { lengths: (632, 374), mode: left }",
            "665.7: a length of 665.7 m; write `665.7mm`, or `665.7m` if it is meant / no length \
             of this declaration has a unit, and a bare number is in metres",
        ),
        (BARE, "rrr BC(B), DC(D) -> C { lengths: (632m, 374), mode: left }", ""),
        (
            "input t: angle; param l = -250; ground A(l, 0);",
            "crank AB(A) -> B { length: 99, angle: t }",
            "-250: a length of 250 m; write `250mm`, or `250m` if it is meant / no length of this \
             declaration has a unit, and a bare number is in metres",
        ),
        ("input t: angle; ground A(0, 0);", "crank AB(A) -> B { length: 99, angle: t }", ""),
    ]);
}
