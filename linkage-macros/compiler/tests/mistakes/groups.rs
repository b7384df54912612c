//! Mistakes in drivers, groups and searches.

use super::{PRESS, Slip, check, slip};

const CRANK: &str = "crank AB(A) -> B { length: 60mm, angle: theta }";
const RAM: &str = "rrp CE(C), ram(bed) -> E { length: 300mm, mode: ahead }";

const SLIPS: [Slip; 9] = [
    slip("rrr BC(B), DC(D)", "rrr AB(B), DC(D)", "AB", "", "rrr BC(B), DC(D)"),
    slip(
        RAM,
        "rrp ram(bed), CE(C) -> E { length: 300mm, mode: ahead }",
        "ram",
        "rrp CE(C), ram(bed) -> E",
        RAM,
    ),
    slip(
        RAM,
        "rrp CE(C), ram(bed) -> E { lengths: (300mm, 10mm), mode: ahead }",
        "lengths",
        "length: 300mm, offset: 10mm",
        "rrp CE(C), ram(bed) -> E { length: 300mm, offset: 10mm, mode: ahead }",
    )
    .means(&[(RAM, "rrp CE(C), ram(bed) -> E { length: 300mm, offset: 10mm, mode: ahead }")]),
    slip(
        RAM,
        "rrp CE(C), ram(bed) -> E { length: 300mm, offset: 3deg, mode: ahead }",
        "3deg",
        "3mm",
        "rrp CE(C), ram(bed) -> E { length: 300mm, offset: 3mm, mode: ahead }",
    )
    .means(&[(RAM, "rrp CE(C), ram(bed) -> E { length: 300mm, offset: 3mm, mode: ahead }")]),
    slip(RAM, "rrp CE(C), ram(bed) -> E { length: 300mm }", "}", "ahead", RAM),
    slip(RAM, "rrp CE(C), ram(bed) -> E { length: 300mm, mode: left }", "left", "ahead", RAM),
    slip(CRANK, "crank AB(A) -> B { length: 60mm, angle: 30mm }", "30mm", "", CRANK),
    slip(
        "rrr BC(B), DC(D) -> C { lengths: (390mm, 180mm), mode: left }",
        "pin C(420mm, 280mm); link BC(B, C); link DC(D, C);",
        "B",
        "",
        "pin B(60mm, 0), C(420mm, 280mm); link BC(B, C); link DC(D, C);",
    )
    .means(&[(
        "rrr BC(B), DC(D) -> C { lengths: (390mm, 180mm), mode: left }",
        "pin B(60mm, 0), C(420mm, 280mm); link BC(B, C); link DC(D, C);",
    )]),
    slip(
        RAM,
        "slider ram(bed) -> E { slide: 100mm } rrr CE(C), XE(A) -> E { lengths: (1m, 1m), mode: left }",
        "E#2",
        "",
        RAM,
    ),
];

const INPUT: &str = "input theta: angle;";
const SEARCH: &str = "input x: length; unknown theta: angle between (0, 90deg);";
const LOAD: &str = "load work: force;";
const SOLVE: &str = "solve theta { ram.slide = x, mode: rising } load work: force;";
const MEANT: &[(&str, &str)] = &[(INPUT, SEARCH), (LOAD, SOLVE), (RUBS, "")];
const RUBS: &str = "friction 0.12 on ram length 120mm;";

const SEARCHES: [Slip; 6] = [
    slip(LOAD, LOAD, "before theta#1", "solve theta { … }", SOLVE)
        .also(&[(INPUT, SEARCH), (RUBS, "")])
        .means(MEANT),
    slip(LOAD, "solve theta { ram.slide == x, mode: rising } load work: force;", "=#1", "=", SOLVE)
        .also(&[(INPUT, SEARCH), (RUBS, "")])
        .means(MEANT),
    slip(LOAD, "solve theta { ram.slide = x } load work: force;", "}", "rising", SOLVE)
        .also(&[(INPUT, SEARCH), (RUBS, "")])
        .means(MEANT),
    slip(
        LOAD,
        "solve theta { ram.slide = x, mode: left } load work: force;",
        "left",
        "rising",
        SOLVE,
    )
    .also(&[(INPUT, SEARCH), (RUBS, "")])
    .means(MEANT),
    slip(
        INPUT,
        "input x: length; unknown theta: angle from 0 to 90deg;",
        "from",
        "between (0, 90deg)",
        SEARCH,
    )
    .also(&[(LOAD, SOLVE), (RUBS, "")])
    .means(MEANT),
    slip(
        INPUT,
        "input x: length; unknown theta: angle between (90deg, 0);",
        "0",
        "between (0, 90deg)",
        SEARCH,
    )
    .also(&[(LOAD, SOLVE), (RUBS, "")])
    .means(MEANT),
];

#[test]
fn mistakes_about_groups_are_mended_by_what_is_proposed() {
    check(PRESS, &SLIPS);
}

#[test]
fn mistakes_about_searches_are_mended_by_what_is_proposed() {
    check(PRESS, &SEARCHES);
}
