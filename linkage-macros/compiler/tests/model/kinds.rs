//! Kinds: of what a name stands for, and of inputs, parameters and loads.

use super::*;

#[test]
fn a_name_is_of_a_kind_that_belongs_there() {
    check(&[
        (
            CRANK,
            "rrr BC(AB), DC(D) -> C { lengths: (3m, 3m), mode: left }",
            "AB: `AB` is a link, not a point / name a joint of `AB`, or a `point` on it",
        ),
        (
            CRANK,
            "output sum = B;",
            "B: `B` is a point, not a number / its coordinates are `B.x` and `B.y`",
        ),
        (
            CRANK,
            "crank EF(D) -> F { length: 1m, angle: t, relative_to: A }",
            "A: `A` is a point, not a link / a link is what a `crank`, `slider` or dyad makes",
        ),
        (
            CRANK,
            "let x = B; let y = rail; guide rail through A along 0deg; let z = rail;",
            "B: `B` is a point, not a number / its coordinates are `B.x` and `B.y`\n\
             rail#1: `rail` is a guide, not a number\n\
             rail#3: `rail` is a guide, not a number",
        ),
        (
            GUIDE,
            "crank relative(A) { angle: t, relative_to: rail } crank other(A) { angle: 1rad, \
             relative_to: other }",
            "rail: `rail` is a guide, not a link\n\
             other#2: `other` is used inside the statement that makes it / a statement can use \
             what earlier ones have made",
        ),
        (
            CRANK,
            "crank EF(t) -> F { length: 1m, angle: 2 * AB }",
            "t: `t` is an input, not a point\n\
             AB: `AB` is a link, not a number / its angle is `AB.angle`, and `AB.slide` its slide if it \
             slides",
        ),
        (
            GUIDE,
            "slider ram(rial) { slide: 1m }",
            "rial: no guide named `rial`; a guide with a similar name exists: `rail`",
        ),
    ]);
}

#[test]
fn a_kind_is_a_word_and_no_unit() {
    check(&[
        (
            CRANK,
            "param l: lenght = 1m;",
            "lenght: no parameter kind named `lenght`; one with a similar name exists: `length` / it is \
             `angle`, `length`, `number` or `mode`",
        ),
        (
            CRANK,
            "input u: deg; crank EF(D) { angle: u }",
            "deg: `deg` is a unit; write `angle` / a value is in metres and radians; units stand behind \
             numbers: `30deg`",
        ),
        (
            CRANK,
            "load f: kN; force (f, 0) on B;",
            "kN: `kN` is a unit; write `force` / a load is in newtons or newton metres; units stand \
             behind numbers: `2kN`",
        ),
        (
            CRANK,
            "param l: length = 30deg;",
            "30deg: an angle where a length belongs / write `30mm`",
        ),
    ]);
}
