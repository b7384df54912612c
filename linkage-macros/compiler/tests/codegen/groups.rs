//! The documentation of every group: dimensions, mode, and where it can be assembled.

use super::{generate, line_by_line};
use crate::oracle::mechanism;
use crate::{equations, passes};

/// The lines about the groups, in their order.
fn said(source: &str) -> Vec<String> {
    let mechanism = mechanism(&format!("struct M {{ {source} }}"));
    let program = passes::optimise(&equations::derive(&mechanism, passes::RULES));
    let file = super::file(line_by_line(generate(&mechanism, &program)));
    let text = prettyplease::unparse(&file).replace("\n///   ", " ");
    let (_, groups) = text.split_once("solved\n").expect("there is a section about groups");
    let lines = groups.lines().map_while(|line| line.strip_prefix("/// - "));
    lines.map(str::to_string).collect()
}

#[test]
fn every_group_has_its_dimensions_its_mode_and_its_range() {
    let lines = said(
        "input theta: angle; param l = 632mm; param elbow: mode = left;
         ground A(0, 0), D(665.7mm, 0);
         guide rail through D along 90deg; guide floor through A along 0deg;
         crank AB(A) -> B { length: 80mm, angle: theta }
         rrr BC(B), DC(D) -> C { lengths: (632mm, 374mm), mode: right }
         rrr BE(B), DE(D) -> E { lengths: (l, 374mm), mode: elbow }
         rrp CF(C), ram(rail) -> F { length: 1.2m, offset: 5mm, mode: behind }
         rpr block(B), bar(D) { offset: -10mm }
         prp p(rail), q(floor) -> G { offsets: (1mm, 0) }
         rpp pin(B), yoke(floor) { slot: 80deg }
         crank gear(D) { angle: -2 * AB.angle }
         crank flag(B) { angle: 15deg, relative_to: AB }",
    );
    let expected = [
        "crank AB: length 80 mm, angle `theta`",
        "rrr BC, DC: lengths 632 mm and 374 mm, `C` on the right seen from `B` to `D`; assembles while \
         |BD| is from 258 mm to 1.006 m",
        "rrr BE, DE: lengths `l` and 374 mm, `E` on the side that `elbow` says seen from `B` to `D`; \
         assembles while |BD| is between the difference of the lengths and their sum",
        "rrp CF, ram: length 1.2 m, offset 5 mm, `F` behind the foot of `C`; assembles while `C` is no \
         farther than 1.2 m from the line on which `F` slides",
        "rpr block, bar: offset -10 mm, block on the positive side of `bar`; assembles while |BD| is \
         at least 10 mm",
        "prp p, q: offsets 1 mm and 0 m; assembles where the guides are not parallel",
        "rpp pin, yoke: slot at 80°, assembles everywhere",
        "crank gear: angle as driven",
        "crank flag: angle 15° from `AB`",
    ];
    assert_eq!(lines, expected);
}

#[test]
fn an_unknown_has_its_ends_and_drives_by_its_name() {
    let lines = said(
        "input x: length; param far: angle = 170deg; ground A(0, 0); guide bed through A along 0deg;
         unknown theta: angle between (-10deg, far);
         crank AB(A) -> B { length: 80mm, angle: theta }
         rrp BC(B), ram(bed) -> C { length: 250mm, mode: ahead }
         solve theta { ram.slide = x, mode: falling }
         unknown s: length between (0.2m, 1.5m); slider other(bed) { slide: s }
         solve s { other.slide = 2 * x, mode: rising }",
    );
    assert_eq!(lines[0], "unknown theta: between -10° and `far`, fixed by its equation, falling");
    assert_eq!(lines[1], "crank AB: length 80 mm, angle `theta`");
    assert_eq!(lines[3], "unknown s: between 200 mm and 1.5 m, fixed by its equation, rising");
    assert_eq!(lines[4], "slider other: slide `s`");
}

#[test]
fn the_range_of_a_cylinder_is_its_own_lengths() {
    let lines = said(
        "input lift: length; ground O(0, 0), F(0.6m, -0.8m);
         rrr ram(F), boom(O) -> G { lengths: (lift, 2.4m), mode: right }",
    );
    let expected = "rrr ram, boom: lengths `lift` and 2.4 m, `G` on the right seen from `F` to `O`; \
                    assembles while `lift` is from 1.4 m to 3.4 m";
    assert_eq!(lines, [expected]);
}

#[test]
fn a_kite_is_told_onto_which_point_it_folds() {
    let cell = |lengths| {
        said(&format!(
            "input theta: angle; ground O(0, 0), A(0.13m, 0);
             crank AB(A) -> B {{ length: 0.13m, angle: theta }}
             rrr OP(O), BP(B) -> P {{ lengths: (0.3m, 0.1m), mode: left }}
             rrr OQ(O), BQ(B) -> Q {{ lengths: (0.3m, 0.1m), mode: right }}
             rrr PE(P), QE(Q) -> E {{ lengths: ({lengths}), mode: left }}"
        ))
    };
    let warning = "`B` is as far from `P` and `Q` as `E`: one of the modes puts `E` onto `B`, and \
                   the machine is the other";
    assert!(cell("0.1m, 0.1m")[3].ends_with(warning), "{:?}", cell("0.1m, 0.1m"));
    let without = cell("0.11m, 0.1m");
    assert!(!without[3].contains("onto"), "{without:?}");
    // The dyad of `P` is the first half of the kite, so the second names it.
    assert!(without[2].contains("puts `Q` onto `P`"), "{without:?}");
    assert!(!without[1].contains("onto"), "{without:?}");
}
