//! Ground points, guides, points of links.

use super::*;

#[test]
fn a_ground_point_is_fixed() {
    check(&[
        (
            INPUT,
            "ground A(t, 0);",
            "t: a ground point is fixed; it cannot depend on an input / a point that is driven \
             is declared `point A at (x, y);`",
        ),
        (
            INPUT,
            "let x = 2 * t * 1m; ground A(x, 0);",
            "x#2: a ground point is fixed; it cannot depend on an input / a point that is driven \
             is declared `point A at (x, y);`",
        ),
        (
            CRANK,
            "ground E(AB.angle, 0);",
            "AB.angle: a ground point is fixed; it cannot depend on an input / a point that is \
             driven is declared `point E at (x, y);`",
        ),
    ]);
}

#[test]
fn a_guide_goes_through_points_of_its_body() {
    check(&[
        (
            CRANK,
            "guide g through A towards A;",
            "g: `g` has no direction; choose two points that differ / it goes through `A` and towards `A`",
        ),
        (
            CRANK,
            "guide g through (4m, 0) towards D;",
            "g: `g` has no direction; choose two points that differ / it already goes through \
             `D`",
        ),
        (
            CRANK,
            "guide g through A towards B;",
            "B: `B` is no ground point, and the guide is fixed in the ground / declare the \
             guide on a link: `guide … on AB …`",
        ),
        (
            CRANK,
            "guide g on AB through D towards B;",
            "D: `D` is no point of `AB` / its points are `A`, `B`",
        ),
        (CRANK, "guide g on AB through A towards B;", ""),
        (
            CRANK,
            "guide g through A along 20mm;",
            "20mm: a length where an angle belongs / write `20deg`",
        ),
        (CRANK, "guide g through A along AB.angle + t;", ""),
        (CRANK, "guide g on ground through A along t;", ""),
        (
            CRANK,
            "ground E(0, 0); guide g through A towards E;",
            "g: `g` has no direction; choose two points that differ / `A` and `E` coincide",
        ),
        (
            CRANK,
            "point P on AB at (1m, 0); guide g on AB through B towards P;",
            "g: `g` has no direction; choose two points that differ / `B` and `P` coincide",
        ),
        (
            CRANK,
            "point P on AB at distances (0.6m, 0.8m) right; point Q on AB at polar (0.6m, \
             -acos(0.6)); guide g on AB through P towards Q;",
            "g: `g` has no direction; choose two points that differ / `P` and `Q` coincide",
        ),
    ]);
}

#[test]
fn a_point_has_a_place_on_its_link() {
    check(&[
        (CRANK, "point P on AB at distances (2m, 2m) left;", ""),
        (
            CRANK,
            "point P on AB at distances (0.2m, 0.2m) left;",
            "P: no point has the distances of `P`; change them / `AB` is 1 m, distances 0.2 m + \
             0.2 m reach 0.4 m",
        ),
        (
            CRANK,
            "point P on AB at distances (2m, 2m) ahead;",
            "ahead: no side named `ahead`; write `left` or `right` / the side of `P` seen from \
             the link's first joint to its pin",
        ),
        (
            CRANK,
            "point P on AB at distances (2m, 0) left;",
            "0: the second distance of `P` is 0 m; make it greater than zero",
        ),
        (
            CRANK,
            "point P at distances (2m, 2m) left;",
            "P: distances need a bar; write `point … on BC at distances …` / they are measured \
             from the bar's outer joint and from its pin",
        ),
        (
            GUIDE,
            "slider ram(rail) -> P { slide: 1m } point Q on ram at distances (2m, 2m) left;",
            "Q: `ram` is no bar with two joints; give coordinates instead / write `point Q on \
             ram at (x, y);`",
        ),
        (
            CRANK,
            "point P on AB at polar (2m, 30);",
            "30: an angle of 30 without a unit; write `30deg` / a bare number is SI; if radians \
             are meant, write `30rad`",
        ),
        (
            CRANK,
            "point P on AB at polar (2deg, 30m);",
            "2deg: an angle where a length belongs / write `2mm`\n\
             30m: a length where an angle belongs / write `30deg`",
        ),
        (CRANK, "point P at (t * 1m, 0);", ""),
        (
            CRANK,
            "point P on B at (1m, 0);",
            "B: `B` is a point, not a link / it is the pin of `crank AB`: name the link",
        ),
    ]);
}

#[test]
fn places_are_written_as_what_they_are() {
    check(&[
        (
            CRANK,
            "point P at (500mm, -60mm);",
            "P: `P` does not move; name its link, as in `point P on AB at …` / a fixed point is \
             declared by `ground P(x, y);`",
        ),
        (CRANK, "point P at (t * 500mm, -60mm); point Q on ground at (1m, 0);", ""),
        (
            CRANK,
            "point P on AB at (500mm, 20deg);",
            "20deg: an angle where a length belongs / a distance and an angle are written \
             `at polar (r, 20deg)`",
        ),
        (
            CRANK,
            "guide up through A along y; guide flat through A along horizontal;",
            "y: write `along 90deg` / a direction is an angle from +x\n\
             horizontal: write `along 0deg` / a direction is an angle from +x",
        ),
    ]);
}
