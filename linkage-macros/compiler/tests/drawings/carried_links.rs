//! Links of given angle between two bars: dyads, whatever turns them, one alone or several in a row.

use super::machine::{Machine, Places, machine};

/// Sums of a few products of lengths of a few units, and two square roots beside them.
const CLOSED: f64 = 1e-12;

fn of(statements: &str) -> Machine {
    machine(&format!("pub struct M {{ {statements} }}"))
        .unwrap_or_else(|told| panic!("{statements}: {told:?}"))
}

fn at(pins: &Places<f64>, name: &str) -> [f64; 2] {
    pins.iter().find(|(known, _)| known == name).unwrap_or_else(|| panic!("no {name}")).1
}

/// The angle of a line between two pins.
fn angle(pins: &Places<f64>, line: &str) -> f64 {
    let (from, to) = line.split_once(' ').expect("two pins");
    let ([x0, y0], [x1, y1]) = (at(pins, from), at(pins, to));
    (y1 - y0).atan2(x1 - x0)
}

/// Both bars of a dyad, each from its outer pin, on one side of each other: the sine between them.
fn side(pins: &Places<f64>, [first, second]: [&str; 2]) -> f64 {
    (angle(pins, second) - angle(pins, first)).sin()
}

const KNEE: &str = "input q: angle; ground A(0, 0), D(-0.35, 0.1); pin B(0.12, -0.7), C(-0.25, -0.62), ankle(0, -4.5);
    link front(A, B), rear(D, C), shank(B, C, ankle); drive shank.angle = q;";

const ROW: &str = "input u, v: angle; ground A(0, 0), D(3, 0.2); pin B(0.4, 1), P(1.3, 1.4), C(2.4, 1.1), X(1, 2);
    link front(A, B), first(B, P, X), second(P, C), rear(D, C);";

/// A machine, the lines whose angles are driven, what they are at given inputs, and the two bars.
struct Case {
    statements: String,
    lines: &'static [&'static str],
    values: fn(&[f64]) -> Vec<f64>,
    bars: [&'static str; 2],
}

fn case(
    statements: impl Into<String>,
    lines: &'static [&'static str],
    values: fn(&[f64]) -> Vec<f64>,
    bars: [&'static str; 2],
) -> Case {
    Case { statements: statements.into(), lines, values, bars }
}

fn cases() -> Vec<Case> {
    let of_knee = ["A B", "D C"];
    let row = |drives: &str| format!("{ROW} {drives}");
    let of_row = &["B P", "P C"];
    vec![
        case(KNEE, &["B C"], |q| vec![q[0]], of_knee),
        case(KNEE.replace("shank(B, C, ankle)", "shank(C, ankle, B)"), &["C ankle"], |q| vec![q[0]], of_knee),
        case(
            KNEE.replace("front(A, B), rear(D, C)", "rear(C, D), front(B, A)"),
            &["B C"],
            |q| vec![q[0]],
            of_knee,
        ),
        // By several inputs, the other of which turns a crank that carries one of the bars.
        case(
            "input u, v: angle; ground O(-1, 0), D(3, 0.2); pin A(0, 0.3), B(0.4, 1.2), C(1.7, 1.4);
             link crank_(O, A), front(A, B), shank(B, C), rear(D, C);
             drive crank_.angle = v; drive shank.angle = u - 2 * v + 0.3;",
            &["O A", "B C"],
            |q| vec![q[1], q[0] - 2.0 * q[1] + 0.3],
            ["A B", "D C"],
        ),
        // Against a crank that is placed, and on points of it.
        case(
            "input u, v: angle; ground O(-1, 0), D(3, 0.2); pin A(0, 0.3), B(0.4, 1.2), C(1.7, 1.4);
             link crank_(O, A), front(A, B), shank(B, C), rear(D, C);
             drive crank_.angle = v; drive crank_.angle - shank.angle = u;",
            &["O A", "B C"],
            |q| vec![q[1], q[1] - q[0]],
            ["A B", "D C"],
        ),
        case(row("drive first.angle = u; drive second.angle = v;"), of_row, |q| vec![q[0], q[1]], of_knee),
        case(row("drive first.angle = u; drive second.angle - first.angle = v;"), of_row, |q| vec![q[0], q[0] + q[1]], of_knee),
        case(row("drive first.angle - second.angle = u; drive second.angle = v;"), of_row, |q| vec![q[0] + q[1], q[1]], of_knee),
        // A length that is driven as well.
        case(
            "input q: angle; input s: length; ground A(0, 0), D(3, 0.2); pin B(0.4, 1), C(2.4, 1.3);
             link front(A, B), rear(D, C); link shank(C, B) { length: s } drive shank.angle = q;",
            &["C B"],
            |q| vec![q[0]],
            of_knee,
        ),
    ]
}

/// No search, no error of a joint, and all that is driven as it is driven; in the drawing as it is drawn.
#[test]
fn links_of_given_angle_are_carried_by_a_dyad() {
    for Case { statements, lines, values, bars } in cases() {
        let machine = of(&statements);
        assert!(machine.mechanism.unknowns.is_empty(), "{statements}");
        let drawn = [machine.drawn::<f64>(false), machine.drawn::<f64>(true)].concat();
        let inputs = machine.drawn_inputs();
        for step in -4..=4 {
            let step = 0.01 * f64::from(step);
            let inputs: Vec<f64> = inputs
                .iter()
                .enumerate()
                .map(|(nth, q)| q + step * (1.0 - 1.7 * nth as f64))
                .collect();
            let pins = machine.rigid(&inputs, CLOSED);
            let pins = pins.unwrap_or_else(|| panic!("{statements} at {inputs:?}"));
            for (line, value) in lines.iter().zip(values(&inputs)) {
                let off = (angle(&pins, line) - value).sin();
                assert!(off.abs() < CLOSED, "{statements} at {inputs:?}: {line} {off:e}");
            }
            assert!(side(&pins, bars) * side(&drawn, bars) > 0.0, "{statements}");
            if step == 0.0 {
                for (name, [x, y]) in &drawn {
                    let [now_x, now_y] = at(&pins, name);
                    // An angle of a drawing is an arc tangent, and back.
                    let off = (now_x - x).hypot(now_y - y);
                    assert!(off < 0.3, "{statements}: {name} {off:e}");
                }
            }
        }
    }
}

/// A length that is driven keeps its bar, and the pins that hang on it.
#[test]
fn a_carried_link_has_its_driven_length() {
    let statements = &cases().pop().expect("the last one").statements;
    let machine = of(statements);
    let drawn = machine.drawn_inputs();
    for change in [-0.2, 0.0, 0.15] {
        let pins = machine.pins::<f64>(&[drawn[0], drawn[1] + change]);
        let ([x0, y0], [x1, y1]) = (at(&pins, "B"), at(&pins, "C"));
        let off = (x1 - x0).hypot(y1 - y0) - drawn[1] - change;
        assert!(off.abs() < CLOSED, "{change}: {off:e}");
    }
}

/// The group by hand: B is on a circle about A and on one about D less the shank's vector.
#[test]
fn a_knee_is_what_a_dyad_by_hand_says() {
    let by_hand = of("input q: angle; ground A(0, 0), D(-0.35, 0.1); let l = hypot(0.37m, 0.08m);
        point V at (-0.35m - l * cos(q), 0.1m - l * sin(q));
        rrr front(A), ghost(V) -> B { lengths: (hypot(0.12m, 0.7m), hypot(0.1m, 0.72m)), mode: right }
        crank shank(B) -> C { length: l, angle: q } output A, B, C;");
    let knee = of(KNEE);
    let drawn = knee.drawn_inputs()[0];
    for degrees in [-100, -60, -20, 0, 1] {
        let q = drawn - f64::from(degrees).to_radians();
        let [own, other] = [&knee, &by_hand].map(|machine| machine.pins::<f64>(&[q]));
        for pin in ["B", "C"] {
            let ([x0, y0], [x1, y1]) = (at(&own, pin), at(&other, pin));
            let is_same = (x1 - x0).hypot(y1 - y0) < CLOSED || (x0.is_nan() && x1.is_nan());
            assert!(is_same, "{pin} at {degrees}: {x0} {y0}, {x1} {y1}");
        }
    }
}

/// Beyond its range the group is the answer, by the names of the drawing; parallel bars are no drawing.
#[test]
fn the_limit_of_a_carried_link_is_told_by_the_links_that_are_drawn() {
    let knee = of(KNEE);
    assert_eq!(knee.mechanism.titles()[1], "front, rear, shank");
    let parallel = KNEE.replace("C(-0.25, -0.62)", "C(-0.23, -0.6)");
    let told = machine(&format!("pub struct M {{ {parallel} }}")).err().expect("it is at a limit");
    assert!(
        told[0]
            .starts_with("in the drawing `front` and `rear` are parallel: `left` and `right` come"),
        "{told:?}"
    );
}

/// Links of given angle, in a row and on each other, whichever links the drives read: in the drawing every angle is the one
/// that is drawn, within half a turn.
#[test]
fn carried_links_count_no_turn_in_the_drawing() {
    let [tau, pi] = [std::f64::consts::TAU, std::f64::consts::PI];
    let on = |[x, y]: [f64; 2], size: f64, degrees: f64| {
        let (sin, cos) = degrees.to_radians().sin_cos();
        [x + size * cos, y + size * sin]
    };
    let drives = [
        "drive second.angle = v; drive second.angle - first.angle = u;",
        "drive first.angle = v; drive first.angle - second.angle = u;",
        "drive second.angle = v; drive first.angle - second.angle = u;",
    ];
    for case in 0..36 {
        let [first, second, arm] = [(7, -163.0), (5, 91.0), (11, 14.0)]
            .map(|(step, from)| from + 30.0 * f64::from(step * case));
        let b = [0.4, 1.0];
        let p = on(b, 0.6, first);
        let c = on(p, 0.7, second);
        let (d, x) = (on(c, 1.3, -20.0), on(p, 0.5, arm));
        let pin = |name: &str, [x, y]: [f64; 2]| format!("pin {name}({x:?}m, {y:?}m);");
        let statements = format!(
            "input u, v, w: angle; ground A(0, 0), D({:?}m, {:?}m); {} {} {} {} {}
             link front(A, B), first(B, P), second(P, C), rear(D, C), arm(X, P);
             drive arm.angle - first.angle = w; output first.angle, second.angle, arm.angle;",
            d[0],
            d[1],
            pin("B", b),
            pin("P", p),
            pin("C", c),
            pin("X", x),
            drives[case as usize % 3],
        );
        let machine = of(&statements);
        assert!(machine.mechanism.unknowns.is_empty(), "{statements}");
        let drawn = machine.drawn_inputs();
        let inputs: Vec<_> = drawn.iter().map(|&drawn| [drawn, 0.0, 0.0]).collect();
        let answers = machine.answers("motion", &inputs);
        for (name, degrees) in [("first", first), ("second", second), ("arm", arm + 180.0)] {
            let found = answers.angle(&format!("{name}.angle"));
            let wanted = degrees.to_radians();
            let off = found - (wanted - tau * (wanted / tau).round());
            assert!(
                found.abs() < pi + CLOSED && off.abs() < CLOSED,
                "{statements} {name}: {found}"
            );
        }
    }
}
