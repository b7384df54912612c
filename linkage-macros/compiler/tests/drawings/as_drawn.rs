//! Frames, slides and drives as statements say them: the numbers of a drawing, each against what the statement means.

use super::answers::Answers;
use super::machine::{Machine, machine};
use crate::ir::interpret::Searched;

/// Sums of a few products of lengths of a metre and forces of some newtons.
const OFF: f64 = 1e-12;

fn of(statements: &str) -> Machine {
    machine(&format!("pub struct M {{ {statements} }}")).unwrap_or_else(|told| panic!("{told:?}"))
}

fn at_rest(machine: &Machine, values: &[f64]) -> Answers {
    let inputs: Vec<_> = values.iter().map(|&value| [value, 0.0, 0.0]).collect();
    machine.answers("position", &inputs)
}

fn place(answers: &Answers, point: &str) -> [f64; 2] {
    ["x", "y"].map(|part| answers.named(&format!("{point}.{part}")))
}

fn minus(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] - b[0], a[1] - b[1]]
}

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

fn cross(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

fn unit(a: [f64; 2]) -> [f64; 2] {
    a.map(|part| part / a[0].hypot(a[1]))
}

#[track_caller]
fn near(found: f64, wanted: f64, off: f64) {
    assert!((found - wanted).abs() <= off, "{found} in place of {wanted}");
}

/// A yoke on a rail whose pin is drawn on it, a millionth of a millimetre off it, and 20 mm off it. Slide, reaction, friction
/// and drive are those at the pin, from the equilibrium of the yoke under its slot's force λ n and the rail's at the pin.
#[test]
fn a_yoke_is_told_of_its_pin() {
    for off in [0.0, 1e-9, 0.02] {
        let yoke = of(&format!(
            "input t: angle; ground A(0.5m, 0); guide rail through (0, 0) along 0deg; pin B(0.5m, 0.1m), Y0(0.2m, {off:?}m);
             link AB(A, B); link yoke(Y0) on rail; guide slot on yoke through (0.3m, 0) along 60deg;
             link block(B) on slot; drive AB.angle = t; mass 2kg on yoke at (0, 0) inertia 0.01(kg*m^2);
             gravity (0, -9.81); friction 0.04 on yoke length 0.02m; output t.drive, yoke.rail, yoke.slide, yoke.rail.friction;"
        ));
        let input = [[0.7, 1.2, 0.3]];
        let of_width = [
            (OFF, yoke.answers("forces", &input), yoke.answers("position", &input)),
            // Thirty newtons in single precision, over some operations.
            (1e-4, single(&yoke, "forces", &input), single(&yoke, "position", &input)),
        ];
        let [t, omega, alpha] = input[0];
        let (arm, normal) = ([0.1 * t.cos(), 0.1 * t.sin()], [-0.75_f64.sqrt(), 0.5]);
        // The block keeps the distance 0.05 m − off/2 from the slot's line.
        let from_slot = 0.5 * (0.1 - off);
        let slide = 0.5 + arm[0] - 0.3 + (0.5 * (arm[1] - off) - from_slot) / normal[0];
        // ẍ of the yoke: n·(a_B − a) = 0 along the normal.
        let rate = dot(normal, [-omega * arm[1], omega * arm[0]]) / normal[0];
        let at_pin =
            [0, 1].map(|axis| [-alpha * arm[1], alpha * arm[0]][axis] - omega * omega * arm[axis]);
        let accel = dot(normal, at_pin) / normal[0];
        let lever = minus([0.5 + arm[0], arm[1]], [slide, off]);
        let pressed = |friction: f64| {
            let force = (2.0 * accel + rate.signum() * friction) / normal[0];
            let (by_rail, couple) = (2.0 * 9.81 - force * normal[1], -force * cross(lever, normal));
            (force, by_rail, couple, 0.04 * by_rail.abs().max(2.0 * couple.abs() / 0.02))
        };
        let (mut least, mut most) = (0.0, 1e3);
        for _ in 0..200 {
            let middle = 0.5 * (least + most);
            let is_more = pressed(middle).3 > middle;
            (least, most) = if is_more { (middle, most) } else { (least, middle) };
        }
        let (force, by_rail, couple, _) = pressed(least);
        assert!(2.0 * couple.abs() / 0.02 > by_rail.abs(), "the couple decides");
        for (off, forces, position) in of_width {
            near(position.named("yoke.slide"), slide, off);
            near(forces.named("yoke.rail.normal"), by_rail, 10.0 * off);
            near(forces.named("yoke.rail.couple"), couple, off);
            near(forces.named("yoke.rail.friction"), -rate.signum() * least, 10.0 * off);
            near(forces.named("t.drive"), cross(arm, normal) * force, off);
        }
    }
}

/// The same numbers in single precision.
fn single(machine: &Machine, entry: &str, inputs: &[[f64; 3]]) -> Answers {
    machine.answers_in::<f32>(entry, inputs, |value: &f32| f64::from(value.point()))
}

/// A yoke on a rail of a link that a dyad places: its slide, and the stop on it, are along that rail.
#[test]
fn a_slide_is_along_the_guide_of_its_statement() {
    let turned = of(
        "input t: angle; ground P3(0, 0), P7(0.6m, 0.3m); pin P4(0.4m, 0.1m), Y(0.3m, 0); link L(P3, P4);
         guide rail on L through P3 towards P4; link yoke(Y) on rail; guide slot on yoke through (0.2m, 0.1m) along 70deg;
         link block(P7) on slot; drive block.angle = t; stop end yoke.slide between (0.1m, 0.2m) { stiffness: 1000(N/m) }
         output yoke, block, Y, P4, end.force;",
    );
    for step in [-0.1, 0.0, 0.1] {
        let input = [[turned.drawn_inputs()[0] + step, 0.0, 0.0]];
        let [position, forces] = ["position", "forces"].map(|entry| turned.answers(entry, &input));
        let slide = dot(place(&position, "Y"), unit(place(&position, "P4")));
        near(position.named("yoke.slide"), slide, OFF);
        near(forces.named("end.force"), -1000.0 * (slide - 0.2).max(0.0), 1000.0 * OFF);
        assert!(slide > 0.22, "the stop pushes");
    }
    let told = machine(
        "pub struct M { input t: angle; ground P3(0, 0), P7(0.6m, 0.3m); pin P4(0.4m, 0.1m), Y(0.3m, 0);
         link L(P3, P4); guide rail on L through P3 towards P4; link yoke(Y) on rail;
         guide slot on yoke through (0.2m, 0.1m) along 70deg; link block(P7) on slot; drive block.angle = t;
         output L.slide; }",
    );
    let told = told.err().expect("`L` slides on nothing");
    assert_eq!(
        told,
        ["`L` does not slide\nwhat slides is declared on a guide: `link L(…) on GUIDE;`"]
    );
}

/// A ram's frame has its x from its first pin to its second: 65.81°, where its guide is at 30°.
#[test]
fn a_ram_has_one_angle_whatever_else_is_asked() {
    for output in ["", "output ram.angle;", "output ram.slide, ram.angle;", "output ram;"] {
        let ram = of(&format!(
            "input t: angle; ground A(0, 0), D(665.7mm, 0); pin B(80mm, 0), C(600mm, 360mm), C2(1m, 0.57735m), E2(1.1m, 0.8m);
             guide bed through (0, 0) along 30deg; link AB(A, B), BC(B, C), DC(D, C), CC(C, C2); link ram(C2, E2) on bed;
             drive AB.angle = t; {output}"
        ));
        let angle = at_rest(&ram, &ram.drawn_inputs()).angle("ram.angle");
        near(angle, 0.22265_f64.atan2(0.1), OFF);
    }
}

/// A block that is driven, and the slot of the bar that a dyad places on it.
#[test]
fn what_is_drawn_as_a_slide_is_one() {
    let inverted = of(
        "input t: angle; ground B(0, 0), D(0.6m, 0.6m); pin P(0.3m, 0.35m), Q(-0.2m, -0.2333333333333m);
         link bar(P, Q); guide slot on bar through P towards Q; link block(B) on slot; link DP(D, P);
         drive block.angle = t; mass 1kg on bar at (0.2m, 0.05m) inertia 0.05(kg*m^2);
         friction 0.1 on block; stop end block.slide between (-0.1m, 0.1m) { stiffness: 100(N/m) }
         force (0.5(N*s/m) * rate(block.slide), 0) on Q;
         output block.slide, P, Q, block.slot, block.slot.friction, end.force;",
    );
    for step in [-0.05, 0.0, 0.02] {
        let input = [[inverted.drawn_inputs()[0] + step, 0.3, 0.0]];
        let [position, forces] =
            ["position", "forces"].map(|entry| inverted.answers(entry, &input));
        let [p, q] = ["P", "Q"].map(|point| place(&position, point));
        let slide = dot(minus([0.0; 2], p), unit(minus(q, p)));
        near(position.named("block.slide"), slide, OFF);
        near(forces.named("end.force"), -100.0 * (slide - 0.1), 100.0 * OFF);
        let [normal, friction] =
            ["normal", "friction"].map(|part| forces.named(&format!("block.slot.{part}")).abs());
        near(friction, 0.1 * normal, 1e-9 * normal);
    }
}

/// One rack in one pose, driven at its left end and at its right: its first pin is 0.3 m behind the guide's point.
#[test]
fn a_rack_has_one_slide() {
    let rack = |ground: &str, wheel: &str| {
        of(&format!(
            "input t: angle; ground {ground}; guide rack through (0, -0.12m) along 0deg;
             pin {wheel}, p(-0.3m, -0.12m), q(0.3m, -0.12m); drive wheel.angle = t; output s = bar.slide, p;"
        ))
    };
    let left = "l(-0.56m, -0.14m)";
    let right = "r(0.56m, -0.14m)";
    let both = [
        rack("L(-0.6m, 0); link bar(p, q) on rack, rod(p, l), wheel(L, l)", left),
        rack("R(0.6m, 0); link bar(p, q) on rack, rod(q, r), wheel(R, r)", right),
    ];
    for machine in both {
        let position = at_rest(&machine, &machine.drawn_inputs());
        near(position.named("s"), -0.3, OFF);
        near(position.named("p.x"), -0.3, OFF);
    }
}

/// Lengths that differ from the drawing, of links that their groups have from the far end.
#[test]
fn declared_lengths_are_measured_from_the_first_pin() {
    let crank = of("input t: angle; ground A(0, 0); pin B(80mm, 0); link AB(B, A) { length: 90mm }
         point E on AB at (20mm, 30mm); drive AB.angle = t; output B, E;");
    let position = at_rest(&crank, &[2.0]);
    let [b, e] = ["B", "E"].map(|point| place(&position, point));
    near(b[0].hypot(b[1]), 0.09, OFF);
    let along = unit(minus([0.0; 2], b));
    near(dot(minus(e, b), along), 0.02, OFF);
    near(cross(along, minus(e, b)), 0.03, OFF);
    // The ram is pinned at its second pin; its first is drawn above the guide.
    let ram = of(
        "input t: angle; ground A(0, 0); guide bed through (0, 0) along 0deg; pin B(0.1m, 0.05m), C(0.5m, 0.02m), F(0.4m, 0.1m);
         link AB(A, B), BC(B, C); link ram(F, C) on bed { length: 0.15m } drive AB.angle = t; output ram, F, C;",
    );
    let position = at_rest(&ram, &ram.drawn_inputs());
    let [f, c] = ["F", "C"].map(|point| place(&position, point));
    let along = unit([0.1, -0.08]);
    near(dot(minus(c, f), along), 0.15, OFF);
    near(cross(minus(c, f), along), 0.0, OFF);
    near(position.named("ram.slide"), f[0], OFF);
    near(position.angle("ram.angle"), (-0.08_f64).atan2(0.1), OFF);
}

/// Distances are those from the first two pins of the statement, on the side as seen from the first.
#[test]
fn distances_are_measured_from_the_first_two_pins() {
    for (link, [from, to]) in
        [("BC(B, C, P)", ["B", "C"]), ("BC(C, B, P)", ["C", "B"]), ("BC(P, B, C)", ["P", "B"])]
    {
        for side in ["left", "right"] {
            let four_bar = of(&format!(
                "input t: angle; ground A(0, 0), D(665.7mm, 0); pin B(80mm, 0), C(600mm, 360mm), P(570mm, 90mm);
                 link AB(A, B), {link}, DC(D, C); drive AB.angle = t;
                 point E on BC at distances (300mm, 450mm) {side}; output B, C, P, E;"
            ));
            let position = at_rest(&four_bar, &[0.4]);
            let [from, to, e] = [from, to, "E"].map(|point| place(&position, point));
            let [a, b] = [minus(e, from), minus(e, to)];
            near(a[0].hypot(a[1]), 0.3, OFF);
            near(b[0].hypot(b[1]), 0.45, OFF);
            assert_eq!(cross(minus(to, from), a) > 0.0, side == "left", "{link}");
        }
    }
}

#[test]
fn distances_that_do_not_meet_are_told() {
    for link in ["BC(B, C, P)", "BC(P, B, C)"] {
        let told = machine(&format!(
            "pub struct M {{ input t: angle; ground A(0, 0), D(665.7mm, 0); pin B(80mm, 0), C(600mm, 360mm), P(570mm, 90mm);
             link AB(A, B), {link}, DC(D, C); drive AB.angle = t; point E on BC at distances (30mm, 45mm) left; }}"
        ));
        let told = told.err().expect("they do not meet");
        let [told] = &told[..] else { panic!("{told:?}") };
        assert!(
            told.starts_with("no point has the distances of `E`; change them\n`BC` is"),
            "{told}"
        );
    }
}

/// A parameter may bring them together.
#[test]
fn distances_of_which_one_is_a_parameter_are_not_told() {
    for distances in ["(a, 45mm)", "(30mm, a)"] {
        let made = machine(&format!(
            "pub struct M {{ input t: angle; param a = 40mm; ground A(0, 0), D(665.7mm, 0); pin B(80mm, 0), C(600mm, 360mm), P(570mm, 90mm);
             link AB(A, B), BC(P, B, C), DC(D, C); drive AB.angle = t; point E on BC at distances {distances} left; }}"
        ));
        assert_eq!(made.err(), None, "{distances}");
    }
}

const TRIAD: &str = "input t: angle; ground A(0, 0), D(3m, 0), F(1.5m, -1m);
    pin B(0.5m, 0.2m), C1(0.8m, 1m), C2(2m, 1.2m), C3(1.5m, 0.5m);
    link AB(A, B), bar1(B, C1), plate(C1, C2, C3), bar2(D, C2), bar3(F, C3); drive AB.angle = t; gravity (0, -9.81);";

/// A mass on the bar that a search leaves out, at its pin: the mass of that pin.
#[test]
fn a_bar_that_is_left_out_has_mass_at_its_pins() {
    for link in ["bar1 at C1", "bar2 at C2", "bar2 at D", "bar3 at C3"] {
        let (_, pin) = link.split_once(" at ").expect("a pin");
        let on_link = of(&format!("{TRIAD} mass 1kg on {link}; mass 1kg on AB uniform;"));
        let on_pin = match pin {
            "D" => "mass 0kg on C2;".to_string(),
            pin => format!("mass 1kg on {pin};"),
        };
        let on_pin = of(&format!("{TRIAD} {on_pin} mass 1kg on AB uniform;"));
        let input = [[on_link.drawn_inputs()[0] + 0.02, 0.7, -0.4]];
        let [one, other] =
            [&on_link, &on_pin].map(|machine| machine.answers("forces", &input).named("t.drive"));
        near(one, other, 1e-9);
    }
}

/// The kinetic energy of a bar about a ground pin is m v²/6.
#[test]
fn a_bar_that_is_left_out_is_uniform() {
    for (bar, pin) in [("bar2", "C2"), ("bar3", "C3")] {
        let uniform = of(&format!("{TRIAD} mass 3kg on {bar} uniform; output {pin}, energy;"));
        let input = [[uniform.drawn_inputs()[0] + 0.02, 0.7, 0.0]];
        let [velocity, energy] = ["velocity", "energy"].map(|entry| uniform.answers(entry, &input));
        let [x, y] = ["x", "y"].map(|part| velocity.named(&format!("velocity of {pin}.{part}")));
        near(energy.named("kinetic energy"), 0.5 * (x * x + y * y), OFF);
    }
}
