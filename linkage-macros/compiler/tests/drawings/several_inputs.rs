//! Groups of class III that several inputs move: drives, lengths of cylinders, gears.

use super::machine::{Machine, machine};

/// The equation of an unknown is closed to some units in the last place over the slope in it.
const CLOSED: f64 = 1e-12;
/// The count of steps along a stretch.
const STEPS: i32 = 24;

fn of(statements: &str) -> Machine {
    machine(&format!("pub struct M {{ {statements} }}")).unwrap_or_else(|told| panic!("{told:?}"))
}

/// The stretch of an input about the drawing, in its own unit, from the documentation.
fn stretch(machine: &Machine, input: &str) -> [f64; 2] {
    let docs = machine.docs();
    let start = format!("`{input}` goes from ");
    let (_, rest) = docs.split_once(&start).unwrap_or_else(|| panic!("no `{input}` in {docs}"));
    let (from, rest) = rest.split_once(" to ").expect("two ends");
    let to = rest.split_once(" about").expect("it goes on").0;
    let to = to.split_once(',').map_or(to, |(to, _)| to);
    [from, to].map(|end| match end.strip_suffix('°') {
        Some(degrees) => degrees.parse::<f64>().expect("a number").to_radians(),
        None => end.trim_end_matches(" m").parse().expect("a number"),
    })
}

/// Equal steps along a stretch, whose ends are written to a tenth of a degree or a millimetre.
fn along([from, to]: [f64; 2]) -> impl Iterator<Item = f64> {
    const WRITTEN: f64 = 1e-3;
    let [from, to] = [from + WRITTEN, to - WRITTEN];
    (0..=STEPS).map(move |step| from + (to - from) * f64::from(step) / f64::from(STEPS))
}

/// Every pose along the stretch of an input is solved, the others as drawn: the bodies are rigid, and so say
/// `others` of the pins.
fn is_solved_along(
    machine: &Machine,
    index: usize,
    ends: [f64; 2],
    others: impl Fn(&[f64], &dyn Fn(&str) -> [f64; 2]),
) {
    let drawn = machine.drawn_inputs();
    for change in along(ends) {
        let mut inputs = drawn.clone();
        inputs[index] += change;
        let pins = machine
            .rigid(&inputs, CLOSED)
            .unwrap_or_else(|| panic!("{inputs:?}\n{}", machine.docs()));
        let place = |name: &str| pins.iter().find(|(pin, _)| pin == name).expect("a pin").1;
        others(&inputs, &place);
    }
}

const TRIAD: &str = "ground A(-1, 0), D(4, 0), E(2, 5); pin B(-0.5, 0.6), P(0.8, 1.2), Q(3, 0.6), R(1.9, 3.1); \
                     link AB(A, B), BP(B, P), plate(P, Q, R), DQ(D, Q), ER(E, R);";

/// The input that moves the group comes second, and the first moves nothing of it.
#[test]
fn a_group_is_followed_along_the_input_that_moves_it() {
    let alone = of(&format!("input t: angle; {TRIAD} drive AB.angle = t;"));
    let beside = of(&format!(
        "input u, t: angle; ground Z(-3, 0); pin Y(-3.4, 0.5); link ZY(Z, Y); drive ZY.angle = u; \
         {TRIAD} drive AB.angle = t;"
    ));
    assert!(!alone.mechanism.unknowns.is_empty());
    let [t, u] = ["t", "u"].map(|input| stretch(&beside, input));
    assert!(t[1] - t[0] > 0.6, "{t:?}");
    assert!(u[1] - u[0] > 6.2, "{u:?}");
    is_solved_along(&beside, 1, t, |_, _| {});
    is_solved_along(&beside, 0, u, |_, _| {});
}

/// An input that drives nothing is none of those that the group is followed along, and changes nothing of its interval.
#[test]
fn an_input_that_drives_nothing_is_not_told() {
    let crank =
        "ground Z(-3, 0); pin Y(-3.4, 0.5); link ZY(Z, Y); drive ZY.angle = u; drive AB.angle = t;";
    let beside = of(&format!("input u, t: angle; {TRIAD} {crank}")).docs();
    let idle = of(&format!("input u, t, v: angle; {TRIAD} {crank} output twice = 2 * v;")).docs();
    let told = |docs: &str| docs.split_once("goes from ").expect("it says how far").1.to_string();
    assert_eq!(told(&beside), told(&idle));
    let unknown =
        |docs: &str| docs.split_once("unknown ").expect("an interval").1[..60].to_string();
    assert_eq!(unknown(&beside), unknown(&idle));
}

/// A crank against the ground, and one that a gear turns against it.
#[test]
fn a_group_on_two_geared_cranks_is_followed() {
    let geared = of("input t: angle; ground A(-1, 0), D(4.6, -0.2), E(2, 5); \
         pin B(-0.5, 0.6), P(0.8, 1.2), Q(3, 0.6), R(1.9, 3.1), D2(4, 0); \
         link AB(A, B), DD(D, D2), BP(B, P), plate(P, Q, R), DQ(D2, Q), ER(E, R); \
         drive AB.angle = t; drive DD.angle = atan2(0.2, -0.6) + atan2(0.6, 0.5) - AB.angle;");
    let t = stretch(&geared, "t");
    assert!(t[1] - t[0] > 0.15, "{t:?}");
    is_solved_along(&geared, 0, t, |inputs, place| {
        let [d, d2] = [[4.6, -0.2], place("D2")];
        let turned = (d2[1] - d[1]).atan2(d2[0] - d[0])
            - (0.2_f64.atan2(-0.6) + 0.6_f64.atan2(0.5) - inputs[0]);
        assert!(turned.sin().abs() < CLOSED, "{turned}");
    });
}

/// A plate on three cylinders: no drive at all.
#[test]
fn a_plate_on_three_cylinders_is_followed_along_each() {
    let platform = of(
        "input a, b, c: length; ground A(0, 0), B(4, 0), C(2, 5); pin P(0.6, 1.3), Q(2.9, 1), R(1.7, 2.6); \
         link la(A, P) { length: a } link lb(B, Q) { length: b } link lc(C, R) { length: c } \
         link plate(P, Q, R);",
    );
    assert_eq!(platform.mechanism.unknowns.len(), 1);
    let docs = platform.docs();
    let (_, told) = docs.split_once("`a` goes from ").expect("it says how far");
    // The line behind it tells of an angle, whatever drives.
    let told = told.lines().next().unwrap_or_default();
    assert!(!told.contains('°'), "lengths are told in metres: {told}");
    let legs = [("P", [0.0, 0.0]), ("Q", [4.0, 0.0]), ("R", [2.0, 5.0])];
    for (index, input) in ["a", "b", "c"].into_iter().enumerate() {
        let ends = stretch(&platform, input);
        assert!(ends[1] - ends[0] > 0.1, "{input}: {ends:?}");
        is_solved_along(&platform, index, ends, |inputs, place| {
            for ((pin, foot), length) in legs.iter().zip(inputs) {
                let [x, y] = place(pin);
                let off = (x - foot[0]).hypot(y - foot[1]) - length;
                assert!(off.abs() < CLOSED, "{pin}: {off:e}");
            }
        });
    }
}

/// The group stands on a crank that is declared by hand.
#[test]
fn a_group_stands_on_one_that_is_declared() {
    let declared = of(
        "input t: angle; ground A(-1, 0), D(4, 0), E(2, 5); crank AB(A) -> B { length: hypot(0.5, 0.6), angle: t } \
         pin B(-0.5, 0.6), P(0.8, 1.2), Q(3, 0.6), R(1.9, 3.1); \
         link BP(B, P), plate(P, Q, R), DQ(D, Q), ER(E, R);",
    );
    // No drive says where the input is drawn.
    let drawn = 0.6_f64.atan2(0.5);
    let ends = stretch(&declared, "t");
    assert!(ends[1] - ends[0] > 0.6, "{ends:?}");
    for change in along(ends) {
        let at = drawn + change;
        assert!(declared.rigid(&[at], CLOSED).is_some(), "{at}");
    }
}

/// The group hangs on a point that the inputs move.
#[test]
fn a_group_stands_on_a_driven_point() {
    let declared = of(
        "input x, y: length; ground D(4, 0), E(2, 5); pin P(0.8, 1.2), Q(3, 0.6), R(1.9, 3.1), B(-0.5, 0.6); \
         point B at (x, y - 1); link BP(B, P), plate(P, Q, R), DQ(D, Q), ER(E, R);",
    );
    for (index, input) in ["x", "y"].into_iter().enumerate() {
        let ends = stretch(&declared, input);
        assert!(ends[1] - ends[0] > 0.2, "{ends:?}");
        for change in along(ends) {
            let mut inputs = [-0.5, 1.6];
            inputs[index] += change;
            assert!(declared.rigid(&inputs, CLOSED).is_some(), "{inputs:?}");
        }
    }
}

/// The angle of a bar and that between two others move a group of which one way to solve it ends where it is drawn,
/// whichever input goes on. One that goes on both ways along both is taken, and both are told.
#[test]
fn a_way_to_solve_a_group_that_ends_in_the_drawing_is_not_chosen() {
    let machine = of(
        "input q, r: angle; ground G0(0.2932, 0.0307), G3(0.3162, 0.6308), G6(-0.402, 0.0311); \
         pin P1(0.2867, -0.1206), P2(0.1699, -0.2644), P4(0.4436, -0.2449), P7(0.2923, -0.4754), \
         P8(-0.1627, -0.0193), P12(0.1562, -0.2529), P14(0.5294, -0.5475), P15(0.2793, -0.0262), \
         P16(-0.0033, 0.1841), E13(0.1762, 0.1815); \
         link L0(P1, G0, P2, E13), L1(P2, P4), L2(G3, P4), L3(P1, P7), L4(P7, P8, P12), L5(P8, G6), L8(P12, P14), \
         L9(P2, P15), L10(E13, P16), L11(P15, P16, P14); \
         drive L9.angle = q; drive L4.angle - L5.angle = r;",
    );
    for (index, input) in ["q", "r"].into_iter().enumerate() {
        let ends = stretch(&machine, input);
        assert!(ends[0] < -0.2 && ends[1] > 0.2, "{input}: {ends:?}");
        is_solved_along(&machine, index, ends, |_, _| {});
    }
}
