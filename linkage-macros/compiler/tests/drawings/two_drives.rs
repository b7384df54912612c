//! One machine, driven at one link and at another: in the pose that both reach everything has the same numbers.
//!
//! Nothing but the drive tells the two apart, and a drive exerts something. So the effort of the first is taken from it
//! and put on the machine as a load: then neither drive has anything to do, and all reactions, frictions and stops are
//! the same as well.

use super::answers::Answers;
use super::machine::{Machine, machine};
use crate::cases::cases;

/// The links of the machines are about a metre long, their masses and forces about one: sums of some hundred products.
const OFF: f64 = 1e-10;

/// A machine and two ways to drive it.
struct Driven {
    name: &'static str,
    statements: &'static str,
    /// The links, each with what is driven of it.
    drives: [[&'static str; 2]; 2],
    /// The load that does what the first drive does, of the effort in place of `E`.
    load: &'static str,
}

/// A value with its first two rates.
type Motion = [f64; 3];

fn of(statements: &str, [link, member]: [&str; 2]) -> Machine {
    let kind = if member == "angle" { "angle" } else { "length" };
    let source =
        format!("pub struct M {{ input t: {kind}; {statements} drive {link}.{member} = t; }}");
    machine(&source).unwrap_or_else(|told| panic!("{source}\n{told:?}"))
}

/// The motion of what a drive gives.
fn motion(answers: &Answers, [link, member]: [&str; 2]) -> Motion {
    match member {
        "angle" => {
            let [omega, alpha] = ["omega", "alpha"].map(|rate| format!("{link}.{rate}"));
            [answers.angle(&format!("{link}.angle")), answers.named(&omega), answers.named(&alpha)]
        }
        _ => ["", "velocity of ", "acceleration of "]
            .map(|rate| answers.named(&format!("{rate}{link}.slide"))),
    }
}

/// Every number that both know by one name is the same, but for the efforts of the drives. The count of them.
fn are_equal(machine: &str, [one, other]: [&Answers; 2], off: f64) -> usize {
    let scale = one.iter().fold(1.0_f64, |scale, (_, value)| scale.max(value.abs()));
    let mut compared = 0;
    let mut seen = std::collections::HashMap::new();
    for (name, value) in one.iter() {
        let nth = seen.entry(name.to_string()).or_insert(0);
        let found = other.iter().filter(|(known, _)| *known == name).nth(*nth);
        *nth += 1;
        let Some((_, found)) = found else { continue };
        assert!((found - value).abs() <= off * scale, "{machine}: {name} is {value} and {found}");
        compared += 1;
    }
    compared
}

/// Everything that an entry point gives, by both drives, in poses about the drawing.
fn agree(driven: &Driven, off: f64, moved: impl Fn(&str) -> String) -> usize {
    let Driven { name, statements, drives, load } = driven;
    let statements = moved(statements);
    let plain = of(&statements, drives[0]);
    let drawn = plain.drawn_inputs()[0];
    let mut compared = 0;
    for (step, rate, accel) in [(0.0, 1.3, -0.7), (0.04, -0.9, 0.4), (-0.05, 0.6, 2.1)] {
        let input = [drawn + step, rate, accel];
        let effort = plain.answers("forces", &[input]).named("t.drive");
        let loaded = format!("{statements} {}", load.replace('E', &format!("{effort:?}")));
        let [one, other] = drives.map(|drive| of(&loaded, drive));
        let before = one.answers("motion", &[input]);
        let there = motion(&before, drives[1]);
        compared += are_equal(name, [&before, &other.answers("motion", &[there])], off);
        let forces = [one.answers("forces", &[input]), other.answers("forces", &[there])];
        compared += are_equal(name, [&forces[0], &forces[1]], off);
    }
    compared
}

const MACHINES: [Driven; 8] = [
    Driven {
        name: "a block in the slot of a rocker",
        statements: "ground B(0, 0), D(0.6m, 0.6m); pin P(0.3m, 0.35m), Q(-0.2m, -0.233m);
            link bar(P, Q), DP(D, P); guide slot on bar through (0.02m, 0.01m) along 5deg;
            link block(B) on slot;
            mass 1kg on bar at (0.2m, 0.05m) inertia 0.05(kg*m^2); mass 2kg on DP uniform; gravity (0, -9.81);
            friction 0.1 on block length 0.1m; friction 0.05 on DP at D radius 10mm;
            stop end block.slide between (-0.1m, 0.1m) { stiffness: 30(N/m), damping: 4(N*s/m) }
            spring coil between bar and DP { stiffness: 2(N*m/rad), free_angle: 20deg, damping: 0.3(N*m*s/rad) }
            point tip on bar at (0.1m, 0.2m); force (-2(N*s/m) * rate(block.slide), 3N) on tip;",
        drives: [["DP", "angle"], ["block", "angle"]],
        load: "torque E on DP;",
    },
    Driven {
        name: "a yoke between a moving rail and a turning block",
        statements: "ground P3(0, 0), P7(0.6m, 0.3m); pin P4(0.4m, 0.1m), Y(0.3m, 0.075m); link L(P3, P4);
            guide rail on L through P3 towards P4; link yoke(Y) on rail;
            guide slot on yoke through (0.2m, 0.1m) along 70deg; link block(P7) on slot;
            mass 1kg on yoke at (0.1m, 0.05m) inertia 0.01(kg*m^2); mass 2kg on L uniform; gravity (0, -9.81);
            friction 0.1 on yoke length 0.15m; friction 0.2 on block;
            stop end yoke.slide between (0.1m, 0.2m) { stiffness: 100(N/m) }
            stop other block.slide between (-0.1m, 0.1m) { stiffness: 50(N/m), damping: 3(N*s/m) }",
        drives: [["L", "angle"], ["block", "angle"]],
        load: "torque E on L;",
    },
    Driven {
        name: "a rack between two wheels",
        statements: "ground L(-0.6m, 0), R(0.6m, 0); guide rack through (0, -0.12m) along 0deg;
            pin l(-0.56m, -0.14m), p(-0.3m, -0.12m), q(0.3m, -0.12m), r(0.56m, -0.14m);
            link bar(p, q) on rack, one(p, l), first(L, l), two(q, r), last(R, r);
            mass 3kg on bar at (0.2m, 0.1m) inertia 0.1(kg*m^2); mass 1kg on first uniform; mass 1kg on two uniform;
            gravity (0, -9.81); friction 0.1 on bar length 0.2m;
            stop end bar.slide between (-0.2m, 0.3m) { stiffness: 100(N/m) }
            spring coil between bar and last { stiffness: 1(N*m/rad), free_angle: -60deg }
            point E on bar at polar (0.2m, 30deg);",
        drives: [["first", "angle"], ["last", "angle"]],
        load: "torque E on first;",
    },
    Driven {
        name: "a crank and a yoke on a rail",
        statements: "ground A(0.5m, 0); guide rail through (0.1m, 0.03m) along 0deg;
            pin B(0.45m, 0.1m), Y(0.2m, 0.03m); link AB(A, B), yoke(Y) on rail;
            guide slot on yoke through (0.3m, 0) along 60deg; link block(B) on slot;
            mass 2kg on yoke at (0.05m, 0.1m) inertia 0.01(kg*m^2); mass 1kg on AB uniform; gravity (0, -9.81);
            friction 0.1 on yoke length 0.2m; friction 0.1 on block length 50mm;
            stop end yoke.slide between (-0.1m, 0.05m) { stiffness: 100(N/m) }",
        drives: [["AB", "angle"], ["yoke", "slide"]],
        load: "torque E on AB;",
    },
    Driven {
        name: "a four-bar whose coupler begins elsewhere",
        statements: "ground A(0, 0), D(0.6657m, 0); pin B(80mm, 10mm), C(0.6m, 0.36m), P(0.57m, 90mm);
            link AB(B, A), BC(P, B, C), DC(C, D);
            mass 1kg on BC at (0.1m, -0.05m) inertia 0.02(kg*m^2); mass 1kg on AB uniform; mass 2kg on DC uniform;
            mass 0.5kg on BC uniform; gravity (1, -9.81); force (3N, 1N) in BC on P;
            friction 0.1 on BC at C radius 20mm; friction 0.1 on AB at A radius 20mm;
            spring coil between AB and BC { stiffness: 3(N*m/rad), free_angle: 10deg, damping: 0.2(N*m*s/rad) }
            stop end BC.angle between (0deg, 40deg) { stiffness: 5(N*m/rad), damping: 1(N*m*s/rad) }
            point E on BC at (20mm, 30mm); point F on BC at distances (0.2m, 0.4m) right; guide slot on BC through E along 20deg;",
        drives: [["AB", "angle"], ["DC", "angle"]],
        load: "torque E on AB;",
    },
    Driven {
        name: "a cross slide on a moving slide",
        statements: "ground A(0, 0); guide floor through (0, -0.2m) along 0deg; pin B(0.1m, 0.12m), C(0.3m, -0.1m);
            link AB(A, B), cart(C) on floor; guide way on cart through C along 75deg; link tool(B) on way;
            mass 2kg on cart at (0.01m, 0.1m) inertia 0.01(kg*m^2); mass 1kg on AB uniform; gravity (0, -9.81);
            mass 1kg on tool at (0.03m, 0.02m) inertia 0.02(kg*m^2);
            friction 0.1 on cart length 0.1m; friction 0.1 on tool;
            stop end tool.slide between (-0.1m, 0.02m) { stiffness: 100(N/m) }",
        drives: [["AB", "angle"], ["cart", "slide"]],
        load: "torque E on AB;",
    },
    Driven {
        name: "a four-bar with loads on its joints",
        statements: "ground A(0, 0), D(0.6657m, 0); pin B(80mm, 10mm), C(0.6m, 0.36m), P(0.57m, 90mm);
            link AB(A, B), BC(B, C, P), DC(D, C); mass 1kg on B; mass 2kg on C; force (5N, -2N) on C; gravity (0, -9.81);
            force (-1(N*s/m) * rate(B.x), 3N) on B; friction 0.1 on BC at C radius 20mm;
            friction 0.1 on BC at B radius 20mm; mass 1kg on P; stop end distance(A, C) between (0, 0.69m) { stiffness: 50(N/m) }
            spring tie between D and B { stiffness: 15(N/m), free_length: 0.3m, damping: 1.5(N*s/m) }",
        drives: [["AB", "angle"], ["DC", "angle"]],
        load: "torque E on AB;",
    },
    Driven {
        name: "a disc that slides on two turning hubs",
        statements: "ground A(0, 0), E(0.05m, 0.02m); pin P(0.3m, 0.1m), Q(0.1m, 0.4m), R(0.2m, 0.15m);
            link one(A, P), two(E, Q); guide g on one through A along 10deg; guide h on two through E along 25deg;
            link disc(R) on g, h; mass 2kg on disc at (0.1m, 0.05m) inertia 0.02(kg*m^2); mass 1kg on one uniform;
            mass 1kg on two uniform; gravity (0, -9.81); friction 0.1 on disc length 0.3m;
            stop end disc.slide between (-0.1m, 0.1m) { stiffness: 100(N/m), damping: 2(N*s/m) }",
        drives: [["one", "angle"], ["two", "angle"]],
        load: "torque E on one;",
    },
];

/// The statements with the pins of the drawing moved by one, two or three of these either way.
fn moved(statements: &str, by: &str) -> String {
    let mut parts = statements.split("pin ");
    let before = parts.next().expect("there is a beginning").to_string();
    let mut ways = [" + 1", " - 2", " + 3", " - 1", " + 2"].into_iter().cycle();
    parts.fold(before, |text, part| {
        let (pins, rest) = part.split_once(';').expect("a statement ends");
        let pins = pins.split("), ").map(|pin| {
            let (name, at) = pin.trim_end_matches(')').split_once('(').expect("a place begins");
            let number = |number: &str| format!("{number}{}{by}", ways.next().unwrap_or_default());
            format!("{name}({})", at.split(", ").map(number).collect::<Vec<_>>().join(", "))
        });
        format!("{text}pin {};{rest}", pins.collect::<Vec<_>>().join(", "))
    })
}

#[test]
fn what_is_driven_changes_no_number_of_a_pose() {
    for driven in &MACHINES {
        for by in ["mm", "e-9m"].into_iter().take(cases(1, 2)) {
            let compared = agree(driven, OFF, |statements| moved(statements, by));
            assert!(compared > 120, "{}: {compared}", driven.name);
        }
        agree(driven, OFF, str::to_string);
    }
}

/// A millionth of a millimetre changes nothing by more: 1e-9 m times slopes of some tens, of lengths to forces of
/// springs of a hundred newtons a metre.
#[test]
fn the_last_digits_of_a_drawing_change_no_meaning() {
    for Driven { name, statements, drives, .. } in &MACHINES {
        for drive in *drives {
            let [one, other] = [(*statements).to_string(), moved(statements, "e-9m")]
                .map(|statements| of(&statements, drive));
            let drawn = one.drawn_inputs()[0];
            let input = [[drawn + 0.03, 0.8, -0.4]];
            for entry in ["motion", "forces"] {
                let answers = [one.answers(entry, &input), other.answers(entry, &input)];
                let compared = are_equal(name, [&answers[0], &answers[1]], 1e-6);
                assert_eq!(compared, answers[0].iter().count(), "{name}, {entry}");
            }
        }
    }
}

/// A bar that is drawn against the way of its rack, to the last digits on either side of it, is turned by half a turn and
/// not by minus that: a spring to a crank, whose angle no half turn ends, is wound alike.
#[test]
fn a_link_against_its_guide_is_turned_one_way() {
    let wound = |by: &str, against: &str| {
        let statements = format!(
            "ground L(-0.6m, 0); guide rack through (0, -0.12m) along 0deg; pin l(-0.56m, -0.14m),
             p(-0.3m, -0.12m{by}), q(0.3m, -0.12m); link bar(q, p) on rack, rod(p, l), wheel(L, l);
             mass 1kg on wheel uniform; spring coil between {against} {{ stiffness: 1(N*m/rad), free_angle: 20deg }}"
        );
        let rack = of(&statements, ["wheel", "angle"]);
        rack.answers("forces", &[[-1.3, 0.0, 0.0]]).named("coil.torque")
    };
    for against in ["bar and wheel", "wheel and bar"] {
        let [below, on, above] = [" - 1e-9m", "", " + 1e-9m"].map(|by| wound(by, against));
        assert!((below - on).abs() < 1e-8 && (above - on).abs() < 1e-8, "{below} {on} {above}");
    }
}

/// In single precision each drive gives the numbers of double precision, to a thousand units in the last place.
#[test]
fn single_precision_follows_both_drives() {
    const OFF_IN_SINGLE: f64 = 1e3 * f32::EPSILON as f64;
    for Driven { name, statements, drives, .. } in &MACHINES {
        for drive in *drives {
            let machine = of(statements, drive);
            let drawn = machine.drawn_inputs()[0];
            let input = [[drawn + 0.03, 0.8, -0.4].map(|value| f64::from(value as f32))];
            for entry in ["motion", "forces"] {
                let single = machine.answers_in::<f32>(entry, &input, |value| f64::from(*value));
                are_equal(name, [&machine.answers(entry, &input), &single], OFF_IN_SINGLE);
            }
        }
    }
}

/// A four-bar by its crank is two bars; by its coupler it is a group of class III, whose left-out bar has mass.
#[test]
fn a_search_gives_the_numbers_of_dyads() {
    let four_bar = "ground A(0, 0), D(0.6657m, 0); pin B(80mm, 10mm), C(0.6m, 0.36m), P(0.57m, 90mm);
        link AB(A, B), BC(B, C, P), DC(D, C); mass 1kg on AB uniform; mass 2kg on DC uniform;
        mass 1kg on AB at B; mass 0.4kg on DC at C; mass 0.7kg on BC at (0.1m, -0.05m) inertia 0.02(kg*m^2);
        gravity (1, -9.81); force (3N, 1N) in BC on P;
        stop end BC.angle between (0deg, 30deg) { stiffness: 5(N*m/rad) }";
    let driven = Driven {
        name: "a four-bar by its crank and by its coupler",
        statements: four_bar,
        drives: [["AB", "angle"], ["BC", "angle"]],
        load: "torque E on AB;",
    };
    let searched = of(four_bar, driven.drives[1]);
    assert_eq!(searched.mechanism.unknowns.len(), 1);
    // An equation is closed to some units in the last place, over the slope in its unknown.
    let compared = agree(&driven, 1e-9, str::to_string);
    assert!(compared > 130, "{compared}");
}

/// A shear whose cross slide is given is a group of class III, by its crank all of it is dyads.
#[test]
fn a_search_gives_slides_and_reactions_of_guides() {
    let shear = Driven {
        name: "a shear by its crank and by its cross slide",
        statements: "ground A(0, 0), D(0.6657m, 0); guide floor through (0, 0) along 0deg;
            pin B(-30mm, 70mm), C(560mm, -360mm), blade(500mm, -410mm);
            link AB(A, B), BC(B, C, blade), DC(D, C), cross() on floor; guide way on cross through blade along 80deg;
            link ride(blade) on way; mass 1kg on AB uniform; mass 2kg on cross at (0.1m, 0.05m); mass 1kg on BC uniform;
            mass 0.5kg on ride at (0.02m, 0.01m) inertia 0.01(kg*m^2); gravity (1, -9.81);
            stop end ride.slide between (-0.1m, -0.05m) { stiffness: 100(N/m) }
            stop other cross.slide between (0.2m, 0.3m) { stiffness: 100(N/m) }",
        drives: [["AB", "angle"], ["cross", "slide"]],
        load: "torque E on AB;",
    };
    let searched = of(shear.statements, shear.drives[1]);
    assert_eq!(searched.mechanism.unknowns.len(), 1);
    let compared = agree(&shear, 1e-9, str::to_string);
    assert!(compared > 130, "{compared}");
}

/// A drive between two links is told of the one that its statement names first, whichever of them is known.
#[test]
fn a_drive_is_that_of_the_link_that_it_names() {
    let arm = |drive: &str| {
        let source = format!(
            "pub struct M {{ input a, b: angle; ground A(0, 0), D(4m, 0); pin B(0, 1m), C(3m, 2m), E(3.5m, 3m);
             link AB(A, B), BC(B, C), DC(D, C), CE(C, E); drive AB.angle = a; drive {drive};
             mass 1kg on CE uniform; gravity (0, -9.81); }}"
        );
        machine(&source).unwrap_or_else(|told| panic!("{told:?}"))
    };
    let input = [[1.5, 1.0, -0.3], [0.7, -0.5, 0.2]];
    let [first, second, both] =
        ["CE.angle - DC.angle = b", "DC.angle - CE.angle = -b", "AB.angle - CE.angle = -b"]
            .map(|drive| arm(drive).answers("forces", &input));
    // The couple on CE, which lifts its weight, and its opposite on DC.
    assert!(first.named("CE.drive").abs() > 1.0);
    assert!((first.named("CE.drive") + second.named("DC.drive")).abs() < 1e-12);
    assert!(second.iter().all(|(name, _)| name != "CE.drive"));
    // AB has a drive of its own.
    assert!(both.named("CE.drive").abs() > 1.0);
    assert!(both.iter().filter(|(name, _)| *name == "AB.drive").count() == 1);
}
