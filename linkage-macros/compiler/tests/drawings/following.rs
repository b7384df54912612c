//! Intervals that follow the drive.

use super::machine::{Machine, machine};
use super::{Case, cases};

/// A class III machine whose crank turns fully.
fn stephenson() -> Case {
    cases().into_iter().find(|case| case.name == "stephenson_g0_d01").expect("it is a case")
}

fn of(statements: &str) -> Machine {
    machine(&format!("pub struct M {{ {statements} }}")).expect("it is a machine")
}

/// The drive's stretch about the drawing, from the documentation.
fn stretch(machine: &Machine) -> [f64; 2] {
    let text: String = machine.docs();
    let [from, to] = ["goes from ", " to "].map(|word| {
        let rest = text.rsplit_once("goes from ").expect("it says how far").1;
        let rest = if word == " to " { rest.split_once(word).expect("two ends").1 } else { rest };
        let end = rest.find(['°', ' ']).expect("a unit");
        let value: f64 = rest[..end].parse().expect("a number");
        if rest[end..].starts_with('°') { value.to_radians() } else { value }
    });
    [from, to]
}

/// The drive at equal steps over the stretch that is documented, but for its last hundredth: it is
/// written to a tenth of a degree.
fn along(machine: &Machine) -> Vec<f64> {
    let [from, to] = stretch(machine);
    let drawn = machine.drawn_inputs()[0];
    (0..=STEPS)
        .map(|i| drawn + 0.99 * (from + (to - from) * f64::from(i) / f64::from(STEPS)))
        .collect()
}

/// The count of steps along a stretch.
const STEPS: i32 = 36;

/// The equation of an unknown is closed to some units in the last place over the slope in it.
const CLOSED: f64 = 1e-12;

#[test]
fn a_crank_that_turns_fully_does_so_turn_after_turn() {
    let machine = of(stephenson().statements);
    assert_eq!(stretch(&machine).map(|end| end.to_degrees().round()), [-180.0, 180.0]);
    for at in along(&machine) {
        let turn = std::f64::consts::TAU;
        let poses = [at, at + turn, at - 3.0 * turn]
            .map(|at| machine.rigid(&[at], CLOSED).unwrap_or_else(|| panic!("{at}")));
        let [first, rest @ ..] = &poses;
        for ((name, a), (_, b)) in rest.iter().flat_map(|pose| first.iter().zip(pose)) {
            let off = (a[0] - b[0]).hypot(a[1] - b[1]);
            assert!(off < CLOSED, "{name} is off by {off:e} a turn on from {at}");
        }
    }
}

/// A plate whose bars on the ground turn fully with the crank, as in a drag-link.
const DRAG_LINK: &str = "input t: angle; ground A(-0.3, 0), D(0, 0), E(-0.1, 0.4); \
                         pin B(-0.6, 1.9), P(-1.6, 1.5), Q(-2, 0.3), R(-1.6, -1.2); \
                         link AB(A, B), BP(B, P), plate(P, Q, R), DQ(D, Q), ER(E, R); drive AB.angle = t;";

/// With the distance of its ground pins as a parameter the same machine is not followed by what was found at one of its
/// values: at another one it is solved as well, within its interval, with bars of the lengths that the parameter gives.
#[test]
fn a_machine_with_a_parameter_is_solved_beside_its_default() {
    let statements =
        DRAG_LINK.replace("ground A", "param w = 0.4m; ground A").replace("0.4)", "w)");
    let machine = of(&statements);
    let drawn = machine.drawn_inputs()[0];
    // The unknown is the angle of BP from AB, in an interval with constant ends.
    let docs = machine.docs();
    assert!(docs.contains("angle: phi, relative_to: AB"), "{docs}");
    let (_, ends) = docs.split_once("unknown phi: angle between (").expect("an interval");
    let ends = ends.split_once(')').expect("two ends").0.split(", ");
    let ends: Vec<f64> = ends.filter_map(|end| end.strip_suffix("deg")?.parse().ok()).collect();
    for w in [0.3, 0.4, 0.5] {
        let found = machine.answers_at("position", &[drawn], &[w]);
        let place = |pin: &str| ["x", "y"].map(|axis| found.named(&format!("{pin}.{axis}")));
        let apart = |[a, b]: [[f64; 2]; 2]| (a[0] - b[0]).hypot(a[1] - b[1]);
        let [b, p, q, r] = ["B", "P", "Q", "R"].map(place);
        let vectors = [[b[0] + 0.3, b[1]], [p[0] - b[0], p[1] - b[1]]];
        let [against, turned] = vectors.map(|[x, y]| y.atan2(x).to_degrees());
        let unknown = (turned - against).rem_euclid(360.0);
        assert!(ends[0] < unknown && unknown < ends[1], "{unknown} is beyond {ends:?} at {w}");
        let lengths = [
            (apart([b, [-0.6, 1.9]]), 0.0),
            (apart([b, p]), 0.4_f64.hypot(1.0)),
            (apart([p, q]), 1.2_f64.hypot(0.4)),
            (apart([q, r]), 1.5_f64.hypot(0.4)),
            (apart([p, r]), 2.7),
            (apart([q, [0.0, 0.0]]), 0.3_f64.hypot(2.0)),
            (apart([r, [-0.1, w]]), (w + 1.2).hypot(1.5)),
        ];
        for (length, wanted) in lengths {
            assert!((length - wanted).abs() < CLOSED, "{length} in place of {wanted} at {w}");
        }
    }
}

/// True if the machine follows its drawing: all of the stretch that is documented is solved then.
pub(super) fn all_of_the_stretch_is_solved(name: &str, machine: &Machine) -> bool {
    let follows = !machine.mechanism.unknowns.is_empty() && machine.docs().contains("_traced`");
    let stretch = if follows { along(machine) } else { Vec::new() };
    for at in stretch {
        assert!(machine.rigid(&[at], CLOSED).is_some(), "{name} at {at}");
    }
    follows
}

/// The same machine driven along a rail, and by a gear.
#[test]
fn a_stretch_is_one_of_whatever_drives() {
    let statements = stephenson().statements;
    let slides = statements
        .replace("input theta: angle;", "input s: length;")
        .replace("link L1(P01, P15);", "guide rail through P01 along 40deg; link L1(P15) on rail;")
        .replace("drive L1.angle = theta;", "drive L1.slide = s;");
    let geared = statements.replace("= theta;", "= 1.5rad - 2 * theta;");
    for statements in [slides, geared] {
        let machine = of(&statements);
        assert!(machine.docs().contains("_traced`"), "{statements}");
        let ends = stretch(&machine);
        assert!(ends[0] < 0.0 && ends[1] > 0.0, "{ends:?}");
        // A slide is told in metres.
        let docs = machine.docs();
        let told = docs.rsplit_once("goes from ").expect("it says how far").1;
        // The line behind it tells of an angle, whatever drives.
        let told = told.lines().next().unwrap_or_default();
        assert_eq!(told.contains('°'), !statements.contains(".slide"), "{told}");
        let poses = along(&machine);
        let poses = match statements.contains("1.5rad") {
            // The stretch is one of the drive.
            true => {
                let drawn = machine.drawn_inputs()[0];
                poses.iter().map(|at| drawn - (at - drawn) / 2.0).collect()
            }
            false => poses,
        };
        for at in poses {
            assert!(machine.rigid(&[at], CLOSED).is_some(), "{statements} at {at}");
        }
    }
}

/// The bar that is left out, or another one, is longer than drawn: the motion is that of the machine with
/// the declared length. `.ci/nightly` has each of them shorter and longer.
#[test]
fn a_motion_is_followed_with_declared_lengths() {
    followed_with_lengths([1.05, 0.9].map(|share| vec![share]));
}

#[test]
#[ignore = "minutes: `.ci/nightly` takes it"]
fn a_motion_is_followed_with_shorter_and_longer_bars() {
    followed_with_lengths([(); 2].map(|()| vec![0.9, 1.05]));
}

/// By the lengths of either bar, as shares of those drawn.
fn followed_with_lengths(shares: [Vec<f64>; 2]) {
    let bars = [("L2", "P24", "P25", 0.405_928_5), ("L3", "P34", "P35", 0.924_153_7)];
    for ((link, from, to, drawn), shares) in bars.into_iter().zip(shares) {
        for share in shares {
            let length = drawn * share;
            let line = format!("link {link}({from}, {to})");
            let longer = format!("{line} {{ length: {length:?} }}");
            let statements = stephenson().statements.replace(&format!("{line};"), &longer);
            let machine = of(&statements);
            assert!(machine.docs().contains("_traced`"), "{statements}");
            for at in along(&machine) {
                let pins =
                    machine.rigid(&[at], CLOSED).unwrap_or_else(|| panic!("{at} {statements}"));
                let place = |name| pins.iter().find(|(pin, _)| pin == name).expect("a pin").1;
                let [p, q] = [from, to].map(place);
                let off = (p[0] - q[0]).hypot(p[1] - q[1]) - length;
                assert!(off.abs() < CLOSED, "{link} is off by {off:e} at {at}");
            }
        }
    }
}

/// A drive between two links that are both unknown holds them together: the same machine as one that
/// is driven at the ground, told by the angle between two others.
#[test]
fn a_drive_between_moving_links_moves_the_same_machine() {
    // A four-bar, a Watt chain of dyads, and a machine of class III; the two links and their pin.
    let four_bar = "ground A(0, 0), D(4, 0); pin B(0.5, 0.9), C(3.2, 2.6); \
                    link AB(A, B), BC(B, C), DC(D, C);";
    let watt = "ground A(0, 0), D(4, 0); pin B(0.5, 0.9), C(3.2, 2.6), E(5.4, 2.1), F(6.5, 3.3), G(2.9, 4.5); \
                link AB(A, B), BC(B, C, G), DC(D, C, E), EF(E, F), GF(G, F);";
    let machines = [
        (four_bar, "AB", "BC"),
        (four_bar, "DC", "BC"),
        (watt, "EF", "DC"),
        (watt, "GF", "EF"),
        (watt, "BC", "GF"),
    ];
    for (text, first, second) in machines {
        let statements =
            format!("input q: angle; {text} drive {first}.angle - {second}.angle = q;");
        let machine = of(&statements);
        let drawn = machine.drawn_inputs();
        let at = machine.rigid(&drawn, CLOSED).unwrap_or_else(|| panic!("{statements}"));
        for (name, place) in machine.drawn::<f64>(false) {
            let now = at.iter().find(|(pin, _)| *pin == name).expect("a pin").1;
            let off = (now[0] - place[0]).hypot(now[1] - place[1]);
            assert!(off < CLOSED, "{statements}: {name} is off by {off:e}");
        }
        // Beside the drawing, the angle between the links is what the input says.
        for change in [-0.05, -0.01, 0.02, 0.05] {
            let now = machine.rigid(&[drawn[0] + change], CLOSED);
            let now = now.unwrap_or_else(|| panic!("{statements} at {change}"));
            let between = angle(&machine, &now, first) - angle(&machine, &now, second);
            let off = (between - drawn[0] - change).sin().abs();
            assert!(off < CLOSED, "{statements} at {change}: {off:e}");
        }
    }
}

/// The angle of a link's first two pins.
fn angle(machine: &Machine, pins: &[(String, [f64; 2])], link: &str) -> f64 {
    let links = machine.links();
    let (_, ends) = links.iter().find(|(name, _)| name == link).expect("it is a link");
    let [from, to] = [0, 1].map(|i| place(pins, &ends[i]));
    (to[1] - from[1]).atan2(to[0] - from[0])
}

fn place(pins: &[(String, [f64; 2])], pin: &str) -> [f64; 2] {
    pins.iter().find(|(name, _)| name == pin).expect("a pin").1
}

/// Links that a drive turns against each other, one of them between a block and a crank, one that slides itself, and two
/// with other links between them.
#[test]
fn drives_between_moving_links_hold_them_beside_slides_and_other_links() {
    let on_a_bed = "ground A(0, 0); guide bed through A along 0; pin B(0.5, 0.9), C(3.2, 0.4); \
                    link AB(A, B), BC(B, C), ram(C) on bed;";
    let through_a_pivot = "ground A(0, 0), D(3, 0); pin B(0.5, 0.9), X(2.5, 0.6); link AB(A, B), BX(B, X); \
                           guide slot on BX through B towards X; link pivot(D) on slot;";
    let five_bar = "input t: angle; ground A(0, 0), E(4, 0); pin B(0.2, 1), C(1.7, 2.1), D(3.6, 1.2); \
                    link AB(A, B), BC(B, C), CD(C, D), ED(E, D); drive ED.angle = t;";
    let opposite =
        "ground A(0, 0), D(4, 0); pin B(0.5, 0.9), C(3.2, 2.6); link AB(A, B), BC(B, C), DC(D, C);";
    // The gap in a joint that no body shows.
    type Opened = fn(&Machine, &[(String, [f64; 2])]) -> f64;
    let bed: Opened = |_, pins| place(pins, "C")[1] - 0.4;
    let slot: Opened = |machine, pins| {
        // The pivot keeps its distance from the line through B and X.
        let beside = |b: [f64; 2], along: f64| (3.0 - b[0]) * along.sin() + b[1] * along.cos();
        let drawn = beside([0.5, 0.9], (-0.3_f64).atan2(2.0));
        beside(place(pins, "B"), angle(machine, pins, "BX")) - drawn
    };
    let rocker: Opened = |machine, pins| (angle(machine, pins, "ED") - 1.2_f64.atan2(-0.4)).sin();
    let nothing: Opened = |_, _| 0.0;
    let machines = [
        (on_a_bed, "AB", "BC", bed),
        (through_a_pivot, "AB", "BX", slot),
        (five_bar, "AB", "CD", rocker),
        (opposite, "AB", "DC", nothing),
    ];
    for (text, first, second, opened) in machines {
        let statements =
            format!("input q: angle; {text} drive {first}.angle - {second}.angle = q;");
        let machine = of(&statements);
        let drawn = machine.drawn_inputs();
        for change in [-0.04, -0.01, 0.0, 0.01, 0.04] {
            let mut inputs = drawn.clone();
            inputs[0] += change;
            let now = machine.rigid(&inputs, CLOSED);
            let now = now.unwrap_or_else(|| panic!("{statements} at {change}"));
            let between = angle(&machine, &now, first) - angle(&machine, &now, second);
            let off = (between - inputs[0]).sin().abs();
            assert!(off < CLOSED, "{statements} at {change}: {off:e}");
            let open = opened(&machine, &now).abs();
            assert!(open < CLOSED, "{statements} at {change}: open by {open:e}");
            let moved = now.iter().zip(machine.rigid(&drawn, CLOSED).expect("the drawing"));
            let moved = moved.map(|((_, a), (_, b))| (a[0] - b[0]).hypot(a[1] - b[1]));
            let moved = moved.fold(0.0, f64::max);
            assert!((moved > 1e-3) == (change != 0.0), "{statements} moves by {moved}");
        }
    }
}

/// A slot on a link that an unknown drives is made within the search, for the groups in it stand on it.
#[test]
fn a_slot_that_a_search_stands_on_is_made_within_it() {
    let boom = of(
        "input s: length; ground A(0, 0), C(0.7, -0.2); pin B(1.5, 1.1), D(1.02, 0.32); \
                   link AB(A, B), CR(C, D); guide slot on CR through C towards D; link rod(B) on slot; \
                   drive rod.slide = s;",
    );
    let drawn = boom.drawn_inputs()[0];
    for change in [-0.2, 0.0, 0.1, 0.3] {
        let pins = boom.rigid(&[drawn + change], CLOSED).unwrap_or_else(|| panic!("{change}"));
        let b = pins.iter().find(|(name, _)| name == "B").expect("a pin").1;
        // The slot begins at C and goes through B.
        let off = (b[0] - 0.7).hypot(b[1] + 0.2) - drawn - change;
        assert!(off.abs() < CLOSED, "{change}: off by {off:e}");
    }
}
