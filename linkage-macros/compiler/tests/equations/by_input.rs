//! Ratios of rates and poles in a hundred digits, against differences of positions: the formulas of rates are no part
//! of what they are compared with.

use std::collections::HashMap;

use crate::equations::declarations::Variant;
use crate::equations::rates::motion_is_derived_from_the_position;
use crate::interface::entries::Analysis;
use crate::interface::{Interface, labels};
use crate::ir::interpret::{Number, ProgramValues};
use crate::ir::program::Program;
use crate::model::mechanism::{Mechanism, OutputKind};
use crate::oracle::{Digits, defaults, derivatives, mechanism, values};
use crate::{equations, passes};

const Q: &[[f64; 3]] = &[[0.7, 1.3, -0.6]];

/// Each asks for links `L` with a point `on_L`, for their poles, and for two numbers `a` and `b` with b′/(3 a′) as `r`.
const WORDS: &[Variant] = &[
    Variant {
        name: "a six-bar with a slide",
        source: concat!(
            "pub struct M { input q: angle; param l = 0.8; ground A(0, 0), D(0.9, 0.15), G(1.5, 0.3);",
            "guide rail through (0.2, -0.1) along 20deg; crank AB(A) -> B { length: 0.3, angle: q }",
            "rrr BC(B), DC(D) -> C { lengths: (l, 0.5), mode: left }",
            "point on_BC on BC at (0.3, 0.2); rrr XF(on_BC), GF(G) -> F { lengths: (0.9, 0.6), mode: right }",
            "rrp CE(C), ram(rail) -> E { length: 1.2, mode: behind }",
            "point on_XF on XF at (0.2, -0.3); point on_CE on CE at (0.1, 0.1); point on_AB on AB at (0.1, 0.2);",
            "let b = distance(F, A) * sin(q); let a = ram.slide + 0.1m * q; let twice = rate(a) + rate(a);",
            "output a, b, r = rate(b) / (1.5 * twice), AB, BC, XF, CE, on_AB, on_BC, on_XF, on_CE,",
            "i = pole(BC), j = pole(XF), k = pole(CE), m = pole(AB),",
            "ij = pole(BC, XF), jk = pole(XF, CE), ki = pole(CE, BC), im = pole(BC, AB); }"
        ),
        inputs: Q,
    },
    Variant {
        name: "blocks and bars on moving guides",
        source: concat!(
            "pub struct M { input q: angle; ground A(0.1, -0.2), D(1.1, 0.3);",
            "crank AB(A) -> B { length: 0.5, angle: q } crank body(B) { angle: 3 * q + 0.2, relative_to: AB }",
            "guide way on body through (0.05, -0.15) along 65deg; guide tilt on body through (0.1, 0) along 0.3 * q;",
            "slider ram(tilt) -> S { slide: 0.4m * q, offset: 0.05 } rpr block(S), bar(D) { offset: 0.1 }",
            "rrp rod(D), shoe(way) -> E { length: 2.1, mode: ahead }",
            "point on_ram on ram at (0.1, 0.2); point on_bar on bar at (0.2, 0.1); point on_rod on rod at (0.3, 0);",
            "let a = block.slide + 0m; let b = E.x; let share = rate(b) / rate(a);",
            "output a, b, r = share / 3, ram.angle, bar, rod, on_ram, on_bar, on_rod,",
            "i = pole(ram), j = pole(bar), k = pole(rod), ij = pole(ram, bar), jk = pole(bar, rod), ki = pole(rod, ram); }"
        ),
        inputs: Q,
    },
    Variant {
        name: "a suspension by the wheel's travel",
        source: concat!(
            "pub struct M { input z: length; unknown theta: angle between (-25deg, 25deg);",
            "ground A(0, 0.2), D(0.05, 0.45); crank lower(A) -> B { length: 0.38, angle: theta }",
            "rrr kingpin(B), upper(D) -> C { lengths: (0.25, 0.28), mode: right }",
            "point W on kingpin at (0.12, -0.06); solve theta { W.y = z, mode: rising }",
            "point on_kingpin on kingpin at (0, 0.1); point on_upper on upper at (0.1, 0);",
            "let a = theta * 1m; let b = distance(C, A); output a, b, kingpin, upper, on_kingpin, on_upper,",
            "r = rate(b) / 3 / rate(theta * 1m), i = pole(kingpin), j = pole(upper), ij = pole(kingpin, upper); }"
        ),
        inputs: &[[0.36, 0.7, 2.3]],
    },
];

/// A declaration with its numbers by name.
struct Machine {
    mechanism: Mechanism,
    program: Program,
    names: Vec<String>,
}

/// Numbers by the names of `OUTPUTS`; of an angle its cosine and sine, by that name and the field's.
type Pose = HashMap<String, Digits>;

impl Machine {
    fn of(source: &str) -> Self {
        let mechanism = mechanism(source);
        let program = passes::optimise(&equations::derive(&mechanism, passes::RULES));
        let interface = Interface::of(&mechanism);
        let entry = interface.find(Analysis::Position.by_value()).expect("it is offered");
        let mut names = labels::of_result(&interface, &mechanism, interface.entry(entry));
        // The second number of an angle is its sine.
        for index in 1..names.len() {
            if names[index] == names[index - 1] {
                names[index] = format!("sine {}", names[index]);
            }
        }
        Self { mechanism, program, names }
    }

    fn at(&self, q: &Digits) -> Pose {
        let zero = Digits::float(0.0);
        let given = ProgramValues {
            inputs: vec![[q.clone(), zero.clone(), zero]],
            params: defaults(&self.mechanism),
            loads: Vec::new(),
            drives: Vec::new(),
            unit: None,
        };
        self.names.iter().cloned().zip(values(&self.program, "position", &given)).collect()
    }

    /// The first derivative by the input at q of numbers of the pose.
    fn slopes(&self, q: f64, numbers: impl Fn(&Pose) -> Vec<Digits>) -> Vec<Digits> {
        let q = Digits::float(q);
        derivatives(|t| numbers(&self.at(&q.add(t)))).0
    }
}

/// Where the point of a link's plane that is at `place` in the pose `now` is in another.
fn carried(link: &str, place: &[Digits; 2], now: &Pose, then: &Pose) -> [Digits; 2] {
    let part = |pose: &Pose, name: String| pose[&name].clone();
    let of = |pose: &Pose| {
        let point = ["x", "y"].map(|axis| part(pose, format!("on_{link}.{axis}")));
        let unit = ["", "sine "].map(|word| part(pose, format!("{word}{link}.angle")));
        (point, unit)
    };
    let (([px, py], [c, s]), ([tx, ty], [d, t])) = (of(now), of(then));
    let (x, y) = (place[0].sub(&px), place[1].sub(&py));
    let (along, across) = (x.mul(&c).add(&y.mul(&s)), y.mul(&c).sub(&x.mul(&s)));
    [tx.add(&along.mul(&d)).sub(&across.mul(&t)), ty.add(&along.mul(&t)).add(&across.mul(&d))]
}

fn place(pose: &Pose, pole: &str) -> [Digits; 2] {
    ["x", "y"].map(|axis| pose[&format!("{pole}.{axis}")].clone())
}

/// Differences are good to 2⁻²⁴⁰ times a seventh derivative of these mechanisms.
#[track_caller]
fn same(a: &Digits, b: &Digits, what: &str) {
    assert!(a.apart(b) < 1e-50, "{what}: {} is not {}", a.to_f64(), b.to_f64());
}

#[test]
fn a_ratio_of_rates_is_that_of_differences() {
    for variant in WORDS {
        let machine = Machine::of(variant.source);
        let q = variant.inputs[0][0];
        let of = |name: &'static str| move |pose: &Pose| pose[name].clone();
        let slopes = machine.slopes(q, |pose| vec![of("a")(pose), of("b")(pose)]);
        let now = machine.at(&Digits::float(q));
        let three = Digits::float(3.0);
        same(&now["r"].mul(&three).mul(&slopes[0]), &slopes[1], variant.name);
        assert!(now["r"].to_f64().abs() > 1e-3, "{}: {}", variant.name, now["r"].to_f64());
    }
}

#[test]
fn a_pole_has_one_velocity_in_both_planes() {
    let mut poles = 0;
    for variant in WORDS {
        let machine = Machine::of(variant.source);
        let q = variant.inputs[0][0];
        let now = machine.at(&Digits::float(q));
        for output in &machine.mechanism.outputs {
            let OutputKind::Pole(links) = &output.kind else { continue };
            let at = place(&now, &output.field.to_string());
            let zero = Digits::float(0.0);
            let velocities = links.iter().map(|(_, link)| {
                let (link, now) = (link.to_string(), &now);
                machine.slopes(q, |then| carried(&link, &at, now, then).into())
            });
            let mut velocities: Vec<_> = velocities.collect();
            velocities.push(vec![zero.clone(), zero]);
            for axis in [0, 1] {
                let what = format!("{}: {}", variant.name, output.field);
                same(&velocities[0][axis], &velocities[1][axis], &what);
            }
            poles += 1;
        }
    }
    assert_eq!(poles, 17);
}

/// Kennedy: the three poles of two links and the ground lie in one line.
#[test]
fn three_poles_lie_in_one_line() {
    for (variant, triples) in WORDS.iter().zip([
        &[
            ["i", "j", "ij"],
            ["j", "k", "jk"],
            ["i", "k", "ki"],
            ["i", "m", "im"],
            ["ij", "jk", "ki"],
        ][..],
        &[["i", "j", "ij"], ["j", "k", "jk"], ["i", "k", "ki"], ["ij", "jk", "ki"]],
        &[["i", "j", "ij"]],
    ]) {
        let now = Machine::of(variant.source).at(&Digits::float(variant.inputs[0][0]));
        for triple in triples {
            let [[ax, ay], [bx, by], [cx, cy]] = triple.map(|pole| place(&now, pole));
            let (left, right) = (bx.sub(&ax).mul(&cy.sub(&ay)), by.sub(&ay).mul(&cx.sub(&ax)));
            same(&left, &right, &format!("{}: {triple:?}", variant.name));
        }
    }
}

#[test]
fn ratios_and_poles_move_as_the_motion_says() {
    WORDS.iter().for_each(motion_is_derived_from_the_position);
}

/// A link on a pin of the ground has its pole there, also where it stands still, at no cost.
#[test]
fn a_pole_on_a_pin_of_the_ground_is_that_pin() {
    let machine = Machine::of(
        "pub struct M { input q: angle; ground A(0, 0), D(0.9, 0.15); crank AB(A) -> B { length: 0.3, angle: q }
         rrr BC(B), DC(D) -> C { lengths: (0.8, 0.5), mode: left }
         output m = pole(AB), n = pole(DC), c = pole(BC, DC), C; }",
    );
    let now = machine.at(&Digits::float(0.4));
    for (name, expected) in [("m.x", 0.0), ("m.y", 0.0), ("n.x", 0.9), ("n.y", 0.15)] {
        assert_eq!(now[name].to_f64(), expected, "{name}");
    }
    for axis in ["x", "y"] {
        same(&now[&format!("c.{axis}")], &now[&format!("C.{axis}")], axis);
    }
    let entry = machine.program.answer("position").expect("it is offered");
    let fixed = &entry.sinks[..4];
    assert!(fixed.iter().all(|&sink| machine.program.graph.as_constant(sink).is_some()));
}
