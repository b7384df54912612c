//! Dimensions, units, functions, link angles.

use super::*;

#[test]
fn a_quantity_has_the_dimension_that_belongs_there() {
    check(&[
        (
            CRANK,
            "crank EF(D) -> F { length: t, angle: t }",
            "t#1: an angle where a length belongs / an angle times a length is a length, as in \
             `theta * 20mm`",
        ),
        (
            CRANK,
            "crank EF(D) -> F { length: 1m, angle: 20mm }",
            "20mm: a length where an angle belongs / write `20deg`",
        ),
        (
            CRANK,
            "crank EF(D) -> F { length: 1m * 1m, angle: t }",
            "1m * 1m: an area where a length belongs / multiply or divide by what is missing",
        ),
        (
            CRANK,
            "crank EF(D) -> F { length: cos(t), angle: t }",
            "cos(t): a number where a length belongs / a number times a length is a length, as \
             in `cos(theta) * 20mm`",
        ),
        (
            CRANK,
            "crank EF(D) -> F { length: 2kg, angle: t }",
            "2kg: a mass where a length belongs / multiply or divide by what is missing",
        ),
        (CRANK, "crank EF(D) -> F { length: 2 + 0.1 * cos(t), angle: t }", ""),
        (
            CRANK,
            "crank EF(D) -> F { length: 1m + t, angle: t }",
            "t#1: an angle where a length belongs / what stands left of the `+` is a length",
        ),
        (
            CRANK,
            "crank EF(D) -> F { length: 1m, angle: t - 3mm }",
            "3mm: a length where an angle belongs / what stands left of the `-` is an angle",
        ),
        (
            GUIDE,
            "slider ram(rail) -> P { slide: 90deg, offset: 5mm }",
            "90deg: an angle where a length belongs / write `90mm`",
        ),
        (
            GUIDE,
            "rrp BC(B), block(rail) -> C { length: 3m, offset: t, mode: ahead }",
            "t: an angle where a length belongs / an angle times a length is a length, as in \
             `theta * 20mm`",
        ),
        (
            CRANK,
            "crank EF(D) -> F { length: 1m, angle: sin(2m) }",
            "2m: a length where an angle belongs / write `2deg`",
        ),
    ]);
}

#[test]
fn the_sides_of_a_sum_are_of_one_kind() {
    check(&[
        (
            CRANK,
            "crank EF(D) -> F { length: sqrt(1m), angle: t }",
            "1m: the square root of a length has no dimension / the powers of its units must be \
             even",
        ),
        (CRANK, "crank EF(D) -> F { length: sqrt(4m * 1m), angle: t }", ""),
        (
            CRANK,
            "crank EF(D) -> F { length: 1m, angle: asin(1m) }",
            "1m#2: a length where a number belongs / a length divided by a length is a number, \
             and so an angle: `s / 20mm`",
        ),
        (
            CRANK,
            "crank EF(D) -> F { length: 1m, angle: asin(1.5) }",
            "1.5: `asin(1.5)` has no value / a sine or a cosine lies between -1 and 1",
        ),
        (
            CRANK,
            "let x = 2kg + 3m; let y = 1 / 2m + 1; let z = 1kg * 1m - 2g;",
            "3m: a length where a mass belongs / what stands left of the `+` is a mass\n\
             2g: a mass where a quantity in m kg belongs / what stands left of the `-` is a \
             quantity in m kg",
        ),
    ]);
}

#[test]
fn a_bare_angle_is_within_a_turn() {
    check(&[
        (
            CRANK,
            "crank EF(D) -> F { length: 1m, angle: 90 }",
            "90: an angle of 90 without a unit; write `90deg` / a bare number is SI; if radians \
             are meant, write `90rad`",
        ),
        (
            CRANK,
            "crank EF(D) -> F { length: 1m, angle: t + 90 }",
            "90: an angle of 90 without a unit; write `90deg` / a bare number is SI; if radians \
             are meant, write `90rad`",
        ),
        (
            CRANK,
            "crank EF(D) -> F { length: 1m, angle: -90 }",
            "-90: an angle of -90 without a unit; write `-90deg` / a bare number is SI; if \
             radians are meant, write `-90rad`",
        ),
        (CRANK, "crank EF(D) -> F { length: 1m, angle: 6.28 }", ""),
        (
            CRANK,
            "param a = 90; crank EF(D) -> F { length: 1m, angle: a } crank EG(D) -> G { length: \
             1m, angle: a + t }",
            "90: an angle of 90 without a unit; write `90deg` / a bare number is SI; if radians \
             are meant, write `90rad`",
        ),
        (
            CRANK,
            "let a = 45 * 2; crank EF(D) -> F { length: 1m, angle: a }",
            "a#2: an angle of 90 without a unit; write `90deg` / a bare number is SI; if radians \
             are meant, write `90rad`",
        ),
        (
            CRANK,
            "let c = sin(90);",
            "90: an angle of 90 without a unit; write `90deg` / a bare number is SI; if radians \
             are meant, write `90rad`",
        ),
    ]);
}

#[test]
fn a_function_is_known_and_has_its_arguments() {
    check(&[
        (
            CRANK,
            "crank EF(D) -> F { length: hypot(3m, 1deg), angle: t }",
            "1deg: an angle where a length belongs / write `1mm`",
        ),
        (
            CRANK,
            "crank EF(D) -> F { length: hypot(3m, 4m), angle: atan2(3m, t) }",
            "t: an angle where a length belongs / an angle times a length is a length, as in \
             `theta * 20mm`",
        ),
        (
            CRANK,
            "crank EF(D) -> F { length: 1m, angle: sqrt(-2) }",
            "-2: `sqrt(-2)` has no value / a square root needs a number that is not negative",
        ),
        (
            CRANK,
            "crank EF(D) -> F { length: 1m, angle: sine(t) }",
            "sine: no function named `sine`; a function with a similar name exists: `sin` / the \
             functions are `sqrt hypot sin cos tan asin acos atan atan2 abs sign min max exp ln \
             tanh pow distance offset`, and `rate` in forces, torques and outputs, `pole` in outputs",
        ),
        (
            CRANK,
            "crank EF(D) -> F { length: 1m, angle: exp(701) }",
            "701: `exp(701)` has no value / e to a power beyond 700 is beyond floating point",
        ),
        (
            CRANK,
            "crank EF(D) -> F { length: 1m, angle: ln(-2) }",
            "-2: `ln(-2)` has no value / a logarithm needs a number above zero",
        ),
        (
            CRANK,
            "crank EF(D) -> F { length: 1m, angle: pow(-2, 1.3) }",
            "-2: `pow(-2, 1.3)` has no value / a power that is no integer needs a number above zero",
        ),
        (
            CRANK,
            "crank EF(D) -> F { length: 1m, angle: tanh(2m) }",
            "2m: a length where a number belongs / a length divided by a length is a number, and so an \
             angle: `s / 20mm`",
        ),
        (
            CRANK,
            "crank EF(D) -> F { length: 1m, angle: pow(t, 1m) }",
            "1m#2: a length where a number belongs / a length divided by a length is a number, and so an \
             angle: `s / 20mm`",
        ),
        (
            CRANK,
            "crank EF(D) -> F { length: pow(4m * t, 0.5), angle: t }",
            "4m * t: a length where a number belongs / a length divided by a length is a number, and so an \
             angle: `s / 20mm`",
        ),
        (
            CRANK,
            "crank EF(D) -> F { length: 1m, angle: pow(t, 65) }",
            "65: an exponent of 65, beyond ±64 / write `exp(65 * ln(t))`",
        ),
        (
            CRANK,
            "crank EF(D) -> F { length: 1m, angle: pow(t, -65) }",
            "-65: an exponent of -65, beyond ±64 / write `exp(-65 * ln(t))`",
        ),
        (CRANK, "crank EF(D) -> F { length: 1m, angle: pow(t, 64) + pow(t, -64) }", ""),
        (
            CRANK,
            "crank EF(D) -> F { length: pow(1m, 3), angle: t }",
            "pow(1m, 3): a volume where a length belongs / multiply or divide by what is missing",
        ),
        (
            CRANK,
            "crank EF(D) -> F { length: 1m, angle: sin(t, t) }",
            "sin: `sin` takes one argument, and 2 are given",
        ),
        (
            CRANK,
            "crank EF(D) -> F { length: 1m, angle: hypot(t) }",
            "hypot: `hypot` takes two arguments, and one is given",
        ),
        (
            CRANK,
            "crank EF(D) -> F { length: 1m, angle: ln(0) }",
            "0: `ln(0)` has no value / a logarithm needs a number above zero",
        ),
    ]);
}

#[test]
fn constants_have_a_value() {
    check(&[
        (
            CRANK,
            "crank EF(D) -> F { length: 1m, angle: tan(90deg) }",
            "90deg: `tan(1.5708)` has no value / the tangent is infinite where the cosine is \
             zero",
        ),
        (
            CRANK,
            "crank EF(D) -> F { length: 1m, angle: atan2(0, 0) }",
            "0#1: `atan2(0, 0)` has no value / the zero vector has no direction",
        ),
        (
            CRANK,
            "crank EF(D) -> F { length: 1m, angle: asin(1.5) + acos(-2) }",
            "1.5: `asin(1.5)` has no value / a sine or a cosine lies between -1 and 1\n\
             -2: `acos(-2)` has no value / a sine or a cosine lies between -1 and 1",
        ),
        (
            CRANK,
            "crank EF(D) -> F { length: 1m / 0, angle: t / (1 - 1) }",
            "0: a division by zero\n\
             (1 - 1): a division by zero",
        ),
    ]);
}

#[test]
fn a_unit_exists() {
    check(&[
        (
            CRANK,
            "crank EF(D) -> F { length: 1m, angle: 3mn }",
            "3mn: no unit named `mn`; a unit with a similar name exists: `mm` / lengths have `m \
             mm cm um in`, angles `rad deg turn`, masses `kg g t`, forces `N kN`, times `s ms`; \
             products stand in parentheses, as in `15(N/m)`",
        ),
        (
            CRANK,
            "let x = 1m / 2sec;",
            "2sec: no unit named `sec` / lengths have `m mm cm um in`, angles `rad deg turn`, \
             masses `kg g t`, forces `N kN`, times `s ms`; products stand in parentheses, as in \
             `15(N/m)`",
        ),
        (
            CRANK,
            "let x = 1e400m; let y = 1e-400; let z = 1e300 * 1e300; let w = 0.0mm;",
            "1e400m: a number too large or too small; change its exponent / `f64` holds \
             numbers between 1e-308 and 1e308\n\
             1e-400: a number too large or too small; change its exponent / `f64` holds \
             numbers between 1e-308 and 1e308\n\
             1e300 * 1e300: a number too large or too small; change its exponent / `f64` holds \
             numbers between 1e-308 and 1e308",
        ),
    ]);
}

#[test]
fn a_parameter_is_a_constant() {
    check(&[
        (
            CRANK,
            "param l = t;",
            "t: the default of `l` is not a constant / `let` names an expression of inputs and \
             parameters",
        ),
        (
            CRANK,
            "param l = AB.angle;",
            "AB.angle: the default of `l` is not a constant / `let` names an expression of \
             inputs and parameters",
        ),
        (CRANK, "param l: length = 2deg;", "2deg: an angle where a length belongs / write `2mm`"),
        (
            CRANK,
            "param l: weight = 2;",
            "weight: no parameter kind named `weight` / it is `angle`, `length`, `number` or \
             `mode`",
        ),
        (CRANK, "param l: length = 2; param k: number = 2; param a: angle = 2;", ""),
    ]);
}

#[test]
fn a_link_angle_is_multiplied_by_integers_alone() {
    check(&[
        (
            CRANK,
            "output sum = 0.5 * AB.angle;",
            "0.5: `AB.angle` can be multiplied by an integer only / a link's angle is known up \
             to whole turns: it stands in sums of angles, times an integer, because other \
             ratios jump at ±π",
        ),
        (
            CRANK,
            "output sum = AB.angle * t;",
            "t: `AB.angle` can be multiplied by an integer only / a link's angle is known up to \
             whole turns: it stands in sums of angles, times an integer, because other ratios \
             jump at ±π",
        ),
        (
            CRANK,
            "output sum = AB.angle / 3;",
            "3: `AB.angle` can be multiplied by an integer only / a link's angle is known up to \
             whole turns: it stands in sums of angles, times an integer, because other ratios \
             jump at ±π",
        ),
        (
            CRANK,
            "output sum = sin(AB.angle);",
            "AB.angle: `AB.angle` cannot stand here / a link's angle is known up to whole \
             turns: it stands in sums of angles, times an integer, because other ratios jump at \
             ±π",
        ),
        (
            CRANK,
            "output sum = AB.angle * 1m;",
            "1m: `AB.angle` can be multiplied by an integer only / a link's angle is known up \
             to whole turns: it stands in sums of angles, times an integer, because other \
             ratios jump at ±π",
        ),
        (
            CRANK,
            "output sum = 1 / AB.angle;",
            "AB.angle: `AB.angle` can be multiplied by an integer only / a link's angle is \
             known up to whole turns: it stands in sums of angles, times an integer, because \
             other ratios jump at ±π",
        ),
        (CRANK, "output sum = 2 * AB.angle - 4 * AB.angle / 2 + 10deg;", ""),
        (
            CRANK,
            "let fine = 3 * AB.angle; crank X(A) { angle: fine - t } crank W(A) { angle: 0.5 * \
             fine }",
            "0.5: `AB.angle` can be multiplied by an integer only / a link's angle is known up \
             to whole turns: it stands in sums of angles, times an integer, because other \
             ratios jump at ±π",
        ),
    ]);
}
