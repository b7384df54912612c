//! The table of joints: which bodies each connects, and how many freedoms a group leaves.

use super::mechanism::{Body, Mechanism, Slideway};
use super::*;

/// A group of every kind, one on a moving link.
const EVERY_KIND: &str = "input t: angle; input s: length;
    ground A(0, 0), D(4m, 0);
    guide rail through A along 0deg; guide wall through D along 90deg;
    crank AB(A) -> B { length: 1m, angle: t }
    guide slope on AB through B along 40deg;
    slider ram(slope) -> S { slide: s }
    rrr b1(B), b2(D) -> C { lengths: (3m, 3m), mode: left }
    rrp b3(C), block(rail) -> E { length: 5m, mode: ahead }
    rpr sleeve(E), bar(D) { }
    prp p(slope), w(wall) -> F { }
    rpp die(S), yoke(rail) { slot: 90deg }";

fn every_kind() -> Mechanism {
    let (mechanism, mistakes) = resolved(EVERY_KIND);
    assert_eq!(mistakes, "");
    mechanism.expect("nothing was reported")
}

fn name(mechanism: &Mechanism, body: Body) -> String {
    match body {
        Body::Ground => "ground".to_string(),
        Body::Link(link) => mechanism.links[link.index()].name.to_string(),
        Body::Pin(pin) => format!("pin {}", mechanism.points[pin.index()].name),
    }
}

#[test]
fn a_joint_connects_a_link_with_the_body_that_carries_it() {
    let mechanism = every_kind();
    let joints = mechanism.joints().map(|joint| {
        let [on, link] = joint.bodies.map(|body| name(&mechanism, body));
        let at = match (joint.point(), joint.slideway()) {
            (Some(point), _) => format!("at {}", mechanism.points[point.index()].name),
            (None, Some(Slideway::Guide(guide))) => {
                format!("along {}", mechanism.guides[guide.index()].name)
            }
            (None, _) => "in it".to_string(),
        };
        format!("{link} on {on} {at}")
    });
    let expected = [
        "AB on ground at A",
        "ram on AB along slope",
        "b1 on AB at B",
        "b2 on ground at D",
        "b1 on pin C at C",
        "b2 on pin C at C",
        "b3 on pin C at C",
        "block on ground along rail",
        "b3 on pin E at E",
        "block on pin E at E",
        "sleeve on pin E at E",
        "bar on ground at D",
        "sleeve on bar in it",
        "p on AB along slope",
        "w on ground along wall",
        "p on pin F at F",
        "w on pin F at F",
        "die on ram at S",
        "yoke on ground along rail",
        "die on yoke in it",
    ];
    assert_eq!(joints.collect::<Vec<_>>(), expected);
}

/// Three freedoms a link, two a pin between links, two taken by every joint.
#[test]
fn a_dyad_leaves_no_freedom_and_a_driver_that_of_its_drive() {
    let mechanism = every_kind();
    let mobilities = mechanism.group_steps().map(|group| {
        let pins = group.inner.iter().filter_map(|joint| joint.point()).take(1).count();
        3 * group.links.len() + 2 * pins - 2 * group.joints().count()
    });
    assert_eq!(mobilities.collect::<Vec<_>>(), [1, 1, 0, 0, 0, 0, 0]);
    let drives = mechanism.joints().filter(|joint| joint.drive.is_some()).count();
    assert_eq!(drives, 2);
}

#[test]
fn the_angle_of_what_slides_is_carried_and_that_of_a_bar_is_its_own() {
    let mechanism = every_kind();
    let carried = mechanism.link_ids().map(|link| {
        let own = mechanism.links[link.index()].name.to_string();
        match mechanism.carried_angle(link) {
            Some((on, turn)) => {
                let turned = turn.map_or("", |_| ", turned");
                format!("{own}: {}{turned}", name(&mechanism, on.into()))
            }
            None => format!("{own}: itself"),
        }
    });
    let expected = [
        "AB: ground, turned",
        "ram: AB, turned",
        "b1: itself",
        "b2: itself",
        "b3: itself",
        "block: ground, turned",
        "sleeve: bar",
        "bar: itself",
        "p: AB, turned",
        "w: ground, turned",
        "die: yoke, turned",
        "yoke: ground, turned",
    ];
    assert_eq!(carried.collect::<Vec<_>>(), expected);
}

/// A dyad makes a parallelogram of its crank, whichever bar is written first; with the lengths of
/// coupler and rocker exchanged it makes none.
#[test]
fn a_parallelogram_is_known_whichever_bar_hangs_on_the_crank() {
    let is_parallelogram = |dyad: &str| {
        let (mechanism, mistakes) = resolved(&format!("{CRANK} {dyad}"));
        assert_eq!(mistakes, "", "{dyad}");
        let found = &mechanism.expect("nothing was reported").rotatabilities;
        assert_eq!(found.len(), 1, "{dyad}");
        found[0].is_parallelogram
    };
    assert!(is_parallelogram("rrr BC(B), DC(D) -> C { lengths: (4m, 1m), mode: left }"));
    assert!(is_parallelogram("rrr DC(D), BC(B) -> C { lengths: (1m, 4m), mode: left }"));
    assert!(!is_parallelogram("rrr BC(B), DC(D) -> C { lengths: (1m, 4m), mode: left }"));
    assert!(!is_parallelogram("rrr DC(D), BC(B) -> C { lengths: (4m, 1m), mode: left }"));
}
