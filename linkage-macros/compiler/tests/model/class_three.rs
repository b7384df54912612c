//! Which bar of a group of class III the message takes apart.

use super::*;

/// Two circles with one group in common, which stands on neither ground nor drive: whatever single bar is
/// taken apart, the other circle stays.
#[test]
fn an_unknown_that_leaves_a_circle_is_not_proposed() {
    const GROUND: &str = "input t: angle; ground A1(0, 0), A3(1m, 0), A4(2m, 0), A5(3m, 0); \
                          crank drive(A1) -> B { length: 1m, angle: t }";
    let circle = |second: &str| {
        format!(
            "rrr a(B), b(C2) -> C1 {{ lengths: (1m, 2m), mode: left }} \
             rrr c(C3), d({second}) -> C2 {{ lengths: (1m, 2m), mode: left }} \
             rrr e(A3), f(C1) -> C3 {{ lengths: (1m, 2m), mode: left }} \
             rrr g(A4), h(C5) -> C4 {{ lengths: (1m, 2m), mode: left }} \
             rrr i(A5), j(C2) -> C5 {{ lengths: (1m, 2m), mode: left }}"
        )
    };
    let all = "C2#1: `rrr a, b`, `rrr c, d`, `rrr e, f`, `rrr g, h` and `rrr i, j` need each other: a group of \
               class III or higher / only drivers and dyads are solved in closed form; drive the chain \
               at another link, so that each dyad stands on what is known";
    // With one circle a bar of it is enough.
    let one = "C2#1: `rrr a, b`, `rrr c, d` and `rrr e, f` need each other: a group of class III or higher / \
               write `unknown phi: angle between (…, …);`, `crank a(B) -> C1 { length: 1m, angle: phi }` \
               for `rrr a, b`, and last `solve phi { distance(C1, C2) = 2m, mode: rising }`";
    check(&[(GROUND, &circle("C4"), all), (GROUND, &circle("A4"), one)]);
}

/// The bar proposed as a crank stands on a joint that is declared.
#[test]
fn an_unknown_is_proposed_at_a_joint_that_exists() {
    check(&[(
        "input t: angle; ground A2(2.6m, 0), A3(2m, 1.5m); crank drive(A3) -> B { length: 1m, angle: t }",
        "rrr leg1(A1), s12(C2) -> C1 { lengths: (1m, 2m), mode: left } \
         rrr leg2(A2), s23(C3) -> C2 { lengths: (3m, 4m), mode: left } \
         rrr leg3(B), s31(C1) -> C3 { lengths: (5m, 6m), mode: left }",
        "A1: no point named `A1`; a point with a similar name exists: `A2`\n\
         C2#1: `rrr leg1, s12`, `rrr leg2, s23` and `rrr leg3, s31` need each other: a group of class III \
         or higher / write `unknown phi: angle between (…, …);`, `crank leg2(A2) -> C2 { length: 3m, \
         angle: phi }` for `rrr leg2, s23`, and last `solve phi { distance(C2, C3) = 4m, mode: rising }`",
    )]);
}
