//! Resolved forms of legal declarations.

use super::mechanism::{Numerics, PointId};
use super::text::text;
use super::*;

/// Compares the mechanism of the statements with its text.
fn means(statements: &str, expected: &str) {
    let (mechanism, mistakes) = resolved(statements);
    assert_eq!(mistakes, "", "{statements}");
    let found = text(&mechanism.expect("nothing was reported"));
    let expected: Vec<_> = expected.trim().lines().map(str::trim).collect();
    assert_eq!(found.lines().collect::<Vec<_>>(), expected, "{statements}\n{found}");
}

#[test]
fn a_flying_shear_resolves() {
    means(
        "input theta: angle;
         ground A(0, 0);
         ground D(665.7mm, 0);
         crank AB(A) -> B { length: 80mm, angle: theta }
         rrr BC(B), DC(D) -> C { lengths: (632mm, 374mm), mode: left }
         point blade on BC at (500mm, -60mm);",
        "input theta: an angle
         ground A(0, 0)
         ground D(0.6657, 0)
         crank AB(A) -> B at 0.08 `length of AB` turned theta from ground
         rrr BC, DC on B, D -> C lengths 0.632 `length of BC`, 0.374 `length of DC` mode +
         point blade on BC at (0.5, -0.06) by rrr BC, DC
         output AB = AB.angle
         output B = point B
         output BC = BC.angle
         output DC = DC.angle
         output C = point C
         output blade = point blade",
    );
}

#[test]
fn every_group_resolves() {
    means(
        "input theta: angle; input s, x: length;
         ground A(0, 0), D(1in, 2cm);
         guide rail through A along 90deg;
         guide up through (0, s) along 0.5turn;
         crank AB(A) -> B { length: 80mm, angle: theta }
         crank body(D) { angle: -2 * theta + AB.angle, relative_to: AB }
         slider ram(rail) -> P { slide: x, offset: 5mm }
         rrp BC(B), piston(rail) -> C { length: 1m, mode: behind }
         rpr block(B), bar(D) { }
         prp p(rail), q(up) -> Q { offsets: (1mm, 2mm) }
         guide axis through A towards D;
         rpp pin(B), yoke(axis) { slot: 90deg }",
        "input theta: an angle
         input s: a length
         input x: a length
         ground A(0, 0)
         ground D(0.0254, 0.02)
         guide rail on ground through A along 1.5707963267948966
         guide up on ground through (0, s) along 3.141592653589793
         crank AB(A) -> B at 0.08 `length of AB` turned theta from ground
         crank body(D) turned 1*AB.angle + (-2 * theta) from AB
         slider ram(rail) -> P x offset 0.005
         rrp BC, piston on B, rail -> C length 1 `length of BC` offset 0 mode -
         rpr block, bar on B, D offset 0 mode +
         prp p, q on rail, up -> Q offsets (0.001, 0.002)
         guide axis on ground through A towards D
         rpp pin, yoke on B, axis slot 1.5707963267948966 offsets (0, 0)
         output AB = AB.angle
         output B = point B
         output body = body.angle
         output ram = ram.angle+slide
         output P = point P
         output BC = BC.angle
         output piston = piston.angle+slide
         output C = point C
         output block = block.angle+slide
         output bar = bar.angle
         output p = p.angle+slide
         output q = q.angle+slide
         output Q = point Q
         output pin = pin.angle+slide
         output yoke = yoke.angle+slide",
    );
}

#[test]
fn points_and_guides_of_links_resolve() {
    means(
        "input t: angle; ground A(0, 0), D(4m, 0); crank AB(A) -> B { length: 1m, angle: t }
         rrr BC(B), DC(D) -> C { lengths: (3m, 3m), mode: right }
         point P on BC at polar (2m, 30deg);
         point Q on DC at distances (2m, 1.5m) right;
         point R on ground at (1m * cos(t), 0);
         point S at polar (1m, 0);
         guide slot on BC through P towards C;
         guide tilted on BC through (0, 1mm) along 10deg + DC.angle;
         guide fixed through S towards D;",
        "input t: an angle
         ground A(0, 0)
         ground D(4, 0)
         crank AB(A) -> B at 1 `length of AB` turned t from ground
         rrr BC, DC on B, D -> C lengths 3 `length of BC`, 3 `length of DC` mode -
         point P on BC at polar (2, 0.5235987755982989) by rrr BC, DC
         point Q on DC at distances (2 `first distance of Q`, 1.5 `second distance of Q`) of 3 - by rrr BC, DC
         point R on ground at ((1 * cos(t)), 0) by point R
         point S on ground at polar (1, 0) by point S
         guide slot on BC through P towards C
         guide tilted on BC through (0, 0.001) along 1*DC.angle + 0.17453292519943295
         guide fixed on ground through S towards D
         output AB = AB.angle
         output B = point B
         output BC = BC.angle
         output DC = DC.angle
         output C = point C
         output P = point P
         output Q = point Q
         output R = point R",
    );
}

#[test]
fn parameters_carry_their_dimension() {
    means(
        "input t: angle; param l = 632mm; param k = 2; param tilt: angle = 0.5;
         param elbow: mode = right; param reach: mode = ahead; param m = 3kg;
         ground A(0, 0), D(k, 0); guide rail through D along tilt;
         crank AB(A) -> B { length: l, angle: t / k }
         rrr BC(B), DC(D) -> C { lengths: (l * 2, k), mode: elbow }
         rrp CE(C), block(rail) -> E { length: 5m, mode: reach }",
        "input t: an angle
         param l: a length 0.632
         param k: a number 2
         param tilt: an angle 0.5
         param elbow: side -
         param reach: sense +
         param m: a mass 3
         ground A(0, 0)
         ground D(k, 0)
         guide rail on ground through D along tilt
         crank AB(A) -> B at l `l` turned (t / k) from ground
         rrr BC, DC on B, D -> C lengths (l * 2) `length of BC`, k `k` mode elbow
         rrp CE, block on C, rail -> E length 5 `length of CE` offset 0 mode reach
         output AB = AB.angle
         output B = point B
         output BC = BC.angle
         output DC = DC.angle
         output C = point C
         output CE = CE.angle
         output block = block.angle+slide
         output E = point E",
    );
}

#[test]
fn expressions_become_sums_of_link_angles_and_a_number() {
    means(
        "input t: angle; input s: length; let half = s / 2; let two = 1m + 1m;
         ground A(0, 0); guide rail through A along 0deg;
         crank AB(A) -> B { length: two, angle: t }
         slider ram(rail) { slide: half }
         let fold = 2 * AB.angle - (AB.angle - ram.slide / 20mm);
         let gone = fold - AB.angle;
         crank gear(A) { angle: -2 * fold + 15deg }
         crank other(A) { angle: 4 * gear.angle / 2 + 0 * AB.angle }
         output fold, gone, turned = 3 * other.angle - 1rad, area = s * half, ratio = two / 3m,
                length = hypot(s, 2) + sqrt(s * 1m);",
        "input t: an angle
         input s: a length
         let 0 = (s / 2)
         let 1 = 2
         let 2 = 1*AB.angle + (ram.slide / 0.02)
         let 3 = let2
         ground A(0, 0)
         guide rail on ground through A along 0
         crank AB(A) -> B at 2 `two` turned t from ground
         slider ram(rail) let0 offset 0
         crank gear(A) turned -2*AB.angle + ((let2 * -2) + 0.26179938779914946) from ground
         crank other(A) turned 2*gear.angle + 0 from ground
         output fold = turn 1*AB.angle + (ram.slide / 0.02)
         output gone = an angle let2
         output turned = turn 3*other.angle + -1
         output area = an area (s * let0)
         output ratio = a number 0.6666666666666666
         output length = a length (hypot(s, 2) + sqrt((s * 1)))",
    );
}

#[test]
fn outputs_are_what_was_asked_for() {
    let asked = "output E, block.slide, BC.margin, CE, block.angle, BC.transmission, A;";
    means(
        &format!("{asked} {SIX_BAR}"),
        "input t: an angle
         ground A(0, 0)
         ground D(4, 0)
         guide rail on ground through D along 0
         crank AB(A) -> B at 1 `length of AB` turned t from ground
         rrr BC, DC on B, D -> C lengths 3 `length of BC`, 3 `length of DC` mode +
         rrp CE, block on C, rail -> E length 5 `length of CE` offset 0 mode +
         output E = point E
         output block = block.angle+slide
         output BC_margin = margin of rrr BC, DC
         output CE = CE.angle
         output BC_transmission = transmission of rrr BC, DC
         output A = point A",
    );
}

#[test]
fn what_stands_still_is_no_default_output() {
    means(
        "input t: angle; ground A(0, 0), D(1m, 0); crank AB(A) -> B { length: 1m, angle: 30deg }
         point P on AB at (1m, 0); point Q on ground at (0, 1m); point R at (t * 1m, 0);
         rrr BC(B), DC(D) -> C { lengths: (1m, 1m), mode: left }",
        "input t: an angle
         ground A(0, 0)
         ground D(1, 0)
         crank AB(A) -> B at 1 `length of AB` turned 0.5235987755982989 from ground
         point P on AB at (1, 0) by crank AB
         point Q on ground at (0, 1) by point Q
         point R on ground at ((t * 1), 0) by point R
         rrr BC, DC on B, D -> C lengths 1 `length of BC`, 1 `length of DC` mode +
         output AB = AB.angle
         output R = point R
         output BC = BC.angle
         output DC = DC.angle",
    );
}

#[test]
fn settings_are_kept() {
    let (mechanism, _) =
        resolved(&format!("{CRANK} numerics compensated; crate = ::linkage; export c;"));
    let mechanism = mechanism.expect("nothing was reported");
    assert_eq!(mechanism.numerics, Numerics::Compensated);
    assert!(mechanism.export_c && mechanism.crate_path.is_some());
}

#[test]
fn doc_comments_are_kept_and_makers_named() {
    let (mechanism, _) = resolved(&format!(
        "{GUIDE} /// The rod.\n rrr BC(B), DC(D) -> C {{ lengths: (3m, 3m), mode: left }} \
         /// The blade.\n point P on BC at (1m, 0); point R on ground at (0, 0);"
    ));
    let mechanism = mechanism.expect("nothing was reported");
    let points: Vec<_> = mechanism
        .points
        .iter()
        .enumerate()
        .map(|(id, point)| {
            let maker = mechanism.maker(PointId(id as u32));
            format!("{} {maker} {}", point.name, point.docs.len())
        })
        .collect();
    assert_eq!(
        points,
        [
            "A ground 0",
            "D ground 0",
            "B crank AB 0",
            "C rrr BC, DC 1",
            "P point on BC 1",
            "R driven point 0"
        ]
    );
    let documented = |name: &str| {
        mechanism.outputs.iter().find(|output| output.field == name).map(|o| o.docs.len())
    };
    assert_eq!(documented("BC"), Some(1));
    assert_eq!(documented("P"), Some(1));
    assert_eq!(documented("AB"), Some(0));
}
