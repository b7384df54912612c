//! The documentation of an equation's roots, where constants decide.

use super::{generate, line_by_line};
use crate::oracle::mechanism;
use crate::{equations, passes};

/// The words about the unknown: its trend, and its count of roots.
fn said(source: &str) -> String {
    let mechanism = mechanism(&format!("struct M {{ {source} }}"));
    let program = passes::optimise(&equations::derive(&mechanism, passes::RULES));
    let file = super::file(line_by_line(generate(&mechanism, &program)));
    let text = prettyplease::unparse(&file).replace("\n///   ", " ");
    let mut lines = text.lines().filter(|line| line.contains(": up to"));
    let line = lines.next_back().expect("there is a line about the search").to_string();
    let (before, _) = line.split_once(": up to").expect("it has these words");
    before.rsplit(", ").take(2).collect::<Vec<_>>().join(", ")
}

/// A ram's crank between these ends, in line with the shaft unless there is an offset.
fn ram(ends: &str, mode: &str, offset: &str) -> String {
    said(&format!(
        "input x: length; param way: mode = falling; ground A(0, 0);
         guide bed through (0, {offset}) along 0deg;
         unknown theta: angle between ({ends});
         crank AB(A) -> B {{ length: 80mm, angle: theta }}
         rrp BC(B), ram(bed) -> C {{ length: 250mm, mode: ahead }}
         solve theta {{ ram.slide = x, mode: {mode} }}"
    ))
}

#[test]
fn one_root_is_said_where_it_is_proved() {
    // Within the dead points, exactly from one to the other, and beyond both.
    for ends in ["10deg, 170deg", "0, 180deg", "-30deg, 200deg"] {
        assert_eq!(ram(ends, "falling", "0"), "one root, falling", "{ends}");
    }
    assert_eq!(ram("-17deg, 217deg", "falling", "30mm"), "one root, falling");
    assert_eq!(ram("-100deg, 100deg", "way", "0"), "one root, rising or falling by `way`");
    // A turn has both dead points: from some place on the ram rises again.
    assert_eq!(ram("-90deg, 270deg", "falling", "0"), "one root, falling");
    assert_eq!(ram("-90deg, 270deg", "rising", "0"), "may have several roots, rising");
    // A parameter may select either trend, so the docs consider both: here the ram falls twice.
    let either = ram("-270deg, 90deg", "way", "0");
    assert_eq!(either, "may have several roots, rising or falling by `way`");
    // The wheel's travel.
    let wishbone = said(
        "input z: length; unknown theta: angle between (-25deg, 25deg);
         ground A(0, 200mm), D(50mm, 450mm);
         crank lower(A) -> B { length: 380mm, angle: theta }
         rrr kingpin(B), upper(D) -> C { lengths: (250mm, 280mm), mode: right }
         point W on kingpin at (120mm, -60mm);
         solve theta { W.y = z, mode: rising }",
    );
    assert_eq!(wishbone, "one root, rising");
}

#[test]
fn several_roots_are_possible_where_nothing_is_proved() {
    let wave = |ends: &str| {
        said(&format!(
            "input x: length; ground A(0, 0); unknown theta: angle between ({ends});
             crank AB(A) -> B {{ length: 1m, angle: theta }}
             solve theta {{ sin(3 * theta) = x / 1m, mode: falling }}"
        ))
    };
    // From its crest at 30° to the next one at 150° it falls once, and from there again.
    assert_eq!(wave("0, 149deg"), "one root, falling");
    assert_eq!(wave("0, 152deg"), "may have several roots, falling");
    // The docs leave out the count of roots where it depends on a parameter or an input.
    let by_parameter = said(
        "input x: length; param r = 80mm; ground A(0, 0); unknown theta: angle between (0, 1rad);
         crank AB(A) -> B { length: r, angle: theta } solve theta { B.y = x, mode: rising }",
    );
    assert!(by_parameter.starts_with("rising, "), "{by_parameter}");
    // Nor where an earlier unknown is what changes.
    let by_another = said(
        "input x, y: length; ground A(0, 0); guide rail through (0, 0) along 0deg;
         unknown s: length between (1m, 2m); slider block(rail) -> P { slide: s }
         solve s { P.x * P.x = x * x, mode: rising }
         unknown theta: angle between (0, 1rad);
         crank PB(P) -> B { length: s / 4, angle: theta } solve theta { B.y = y, mode: rising }",
    );
    assert!(by_another.starts_with("rising, "), "{by_another}");
}

/// The search of the only unknown as a sweep may begin it: whether one root is proved, if its equation stands
/// apart at all.
fn apart(source: &str) -> Option<bool> {
    let mechanism = mechanism(&format!("struct M {{ {source} }}"));
    let program = passes::optimise(&equations::derive(&mechanism, passes::RULES));
    let text: String = generate(&mechanism, &program).to_string();
    let text = text.split_whitespace().collect::<String>();
    let (_, after) = text.split_once("has_one_root:")?;
    assert!(text.contains("checks_.seed(0)") && text.contains("fnfollow<"), "{text}");
    Some(after.starts_with("true"))
}

#[test]
fn sweeps_begin_where_the_pose_before_ended() {
    let ram = |ends: &str, length: &str, solve: &str| {
        apart(&format!(
            "input x: length; param l = 80mm; param seed: near = 1rad; ground A(0, 0);
             guide bed through (0, 0) along 0deg;
             unknown theta: angle between ({ends});
             crank AB(A) -> B {{ length: {length}, angle: theta }}
             rrp BC(B), ram(bed) -> C {{ length: 250mm, mode: ahead }}
             solve theta {{ {solve}, mode: falling }}"
        ))
    };
    let from_end_to_end = ["10deg, 170deg", "0, 180deg"];
    for ends in from_end_to_end {
        assert_eq!(ram(ends, "80mm", "ram.slide = x"), Some(true), "{ends}");
    }
    // Beyond a dead point, and where a parameter decides, the ends alone are remembered.
    assert_eq!(ram("-30deg, 180deg", "80mm", "ram.slide = x"), Some(false));
    assert_eq!(ram("0, 210deg", "80mm", "ram.slide = x"), Some(false));
    assert_eq!(ram("0, 180deg", "l", "ram.slide = x"), Some(false));
    // An input on the unknown's side, none that is apart, ends that change, and a seed of the user's.
    assert_eq!(ram("0, 180deg", "80mm", "ram.slide + x = 0.1m"), None);
    assert_eq!(ram("0, 180deg", "l + x / 10", "ram.slide = 0.3m"), None);
    assert_eq!(ram("0, l / 1mm * 1deg", "80mm", "ram.slide = x"), None);
    assert_eq!(ram("0, 180deg", "80mm", "ram.slide = x, near: seed"), None);
}
