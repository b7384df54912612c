//! Poses beside the drawing: joints closed and drives obeyed, by the motions of the bodies alone.

use super::count::groups;
use super::cutting::{Placed, steps};
use super::machine::{Driven, Driving, GROUND, RigidBody, Slide};
use super::*;
use super::{cut, options};
use crate::chain::plane::Displaced;
pub(crate) use linkage_compiler::chain::pose::*;

fn body(pins: &[usize]) -> RigidBody {
    RigidBody { pins: pins.to_vec(), ..RigidBody::default() }
}

fn machine(places: &[[f64; 2]], bodies: &[&[usize]]) -> Machine {
    Machine {
        pins: places.iter().map(|&[x, y]| Complex::new(x, y)).collect(),
        bodies: bodies.iter().map(|pins| body(pins)).collect(),
        ..Machine::default()
    }
}

fn slide(body: usize, carrier: usize, [x, y]: [f64; 2], degrees: f64) -> Slide {
    let along = Complex::turned(degrees.to_radians());
    Slide { body, carrier, through: Complex::new(x, y), along }
}

fn driving(kind: Driven, bodies: [usize; 2]) -> Driving {
    Driving { kind, bodies, reads: Vec::new() }
}

/// The largest distance by which a pin, a slide or a drive is missed by bodies that are moved from the drawing. All
/// of them are placed. A motion is a shift and a turn, so that the bodies are rigid.
fn missed(posed: &Posed<'_>, changes: &[f64]) -> f64 {
    let machine = posed.machine;
    let motions: Vec<_> = posed.of.iter().map(|of| of.expect("it is placed")).collect();
    let turned = motions.iter().map(|motion| (motion.turn.length() - 1.0).abs());
    let mut missed: Vec<f64> = turned.collect();
    for (pin, &place) in machine.pins.iter().enumerate() {
        let at: Vec<_> = machine.at(pin).map(|body| motions[body].of(place)).collect();
        missed.extend(at.iter().map(|other| (*other - at[0]).length()));
    }
    // A point of the line on both bodies: how far one is from the other, along and across the line.
    let apart = |slide: &Slide| {
        let [own, on] = [slide.body, slide.carrier].map(|body| motions[body]);
        let seen =
            (on.turn * slide.along).conjugate() * (own.of(slide.through) - on.of(slide.through));
        (seen, (own.turn - on.turn).length())
    };
    for slide in &machine.slides {
        let (seen, turned) = apart(slide);
        missed.extend([seen.y.abs(), turned]);
    }
    for (drive, change) in machine.drives.iter().zip(changes) {
        let [own, to] = drive.bodies.map(|body| motions[body].turn);
        missed.push(match drive.kind {
            Driven::Angle => (own - to * Complex::turned(*change)).length(),
            Driven::Slide(slide) => (apart(&machine.slides[slide]).0.x - change).abs(),
        });
    }
    missed.into_iter().fold(0.0, |most, off| if off.is_nan() { f64::NAN } else { off.max(most) })
}

/// All ways to solve a machine whose last group is the only one of class III, each with the steps before it; the cut
/// itself where it has none.
fn ways(machine: &Machine) -> Vec<Vec<Found>> {
    let (mut known, mut before) = (Placed::at_first(machine), Vec::new());
    for group in groups(machine) {
        match steps(machine, &known, &group) {
            Some(found) => before.extend(found),
            None => {
                let options = options::options(machine, &known, &group);
                let way = |search| [before.clone(), vec![Found::Search(Box::new(search))]].concat();
                return options.into_iter().map(way).collect();
            }
        }
        known.add(machine, &group);
    }
    vec![before]
}

/// By every way to solve the machine, all of its joints are closed and its drives obeyed beside the drawing, about which
/// each drive goes both ways. There are `least` ways or more.
fn is_closed_beside_its_drawing(name: &str, machine: &Machine, least: usize) {
    // The last step to a root is below 1e-11 of the unknown's unit, which is at most the size of six, and the slopes of
    // equations are of the order of ten: what is left open is of the order of a rounding where Newton's method doubles
    // the digits, and less than this where it does not.
    const CLOSED: f64 = 1e-9;
    let ways = ways(machine);
    assert!(ways.len() >= least, "{name}: {}", ways.len());
    for steps in &ways {
        for drive in 0..machine.drives.len() {
            for change in [-0.002, 0.003] {
                let mut changes = vec![0.0; machine.drives.len()];
                changes[drive] = change;
                let unknowns = vec![0.0; machine.bodies.len()];
                let drives = changes.clone();
                let mut given = PoseChanges { drives, unknowns, ..PoseChanges::default() };
                let mut posed = Posed::new(machine);
                posed.run(steps, &mut given, 0.0).unwrap_or_else(|| panic!("{name}: {steps:?}"));
                let off = missed(&posed, &changes);
                assert!(off < CLOSED, "{name}: off by {off:e} at {changes:?}, {steps:?}");
                // The pose beside the drawing, not one on another side.
                let turned = posed.of.iter().flatten().map(|motion| motion.turn.x);
                assert!(turned.fold(1.0, f64::min) > 0.9, "{name}: {changes:?}, {steps:?}");
            }
        }
    }
}

/// Two links that a drive holds together push a block on the ground: they turn against each other as the
/// drive says, and all joints stay closed.
#[test]
fn held_links_of_a_dyad_with_a_block_follow_their_drive() {
    let machine = Machine {
        pins: [[0.0, 0.0], [0.4, 0.9], [1.7, 0.2]].map(|[x, y]| Complex::new(x, y)).into(),
        bodies: vec![body(&[0]), body(&[0, 1]), body(&[1, 2]), body(&[2])],
        slides: vec![Slide {
            body: 3,
            carrier: GROUND,
            through: Complex::new(0.0, 0.2),
            along: Complex::new(1.0, 0.0),
        }],
        drives: vec![Driving { kind: Driven::Angle, bodies: [2, 1], reads: Vec::new() }],
        ..Machine::default()
    };
    let steps = cut(&machine).expect("it is a machine");
    for change in [-0.2, 0.1, 0.3] {
        let mut given = PoseChanges { drives: vec![change], ..PoseChanges::default() };
        let mut posed = Posed::new(&machine);
        posed.run(&steps, &mut given, 0.0).expect("it assembles");
        let [first, second, block] = [1, 2, 3].map(|body| posed.of[body].expect("it is placed"));
        let at = |motion: Displaced, pin: usize| motion.of(machine.pins[pin]);
        let off = [
            (second.turn - first.turn * Complex::turned(change)).length(),
            at(first, 0).length(),
            (at(first, 1) - at(second, 1)).length(),
            (at(second, 2) - at(block, 2)).length(),
            (block.turn - Complex::new(1.0, 0.0)).length(),
            (at(block, 2).y - 0.2).abs(),
        ];
        // A dozen roundings of lengths of two.
        assert!(off.iter().all(|off| *off < 1e-14), "{change}: {off:?}");
    }
}

/// A machine of class III between whose last two links a drive is, in both orders.
#[test]
fn a_drive_between_moving_links_of_a_searched_group_is_obeyed() {
    let places =
        [[0.0, 0.0], [3.2, 0.2], [6.0, 0.1], [0.4, 1.0], [2.9, 2.2], [2.4, 3.4], [5.4, 2.3]];
    let bodies: [&[usize]; 6] = [&[0, 1, 2], &[0, 3], &[3, 4, 5], &[1, 4], &[5, 6], &[2, 6]];
    for ends in [[4, 5], [5, 4]] {
        let mut turned = machine(&places, &bodies);
        turned.drives.push(driving(Driven::Angle, ends));
        is_closed_beside_its_drawing("two links", &turned, 6);
    }
}

/// Blocks whose pins are beside their guides, in a dyad and as what is left out.
#[test]
fn blocks_of_a_searched_group_keep_the_distance_of_their_pins() {
    let mut ram = machine(
        &[[0.0, 0.0], [6.0, 0.1], [0.4, 1.0], [2.9, 2.2], [2.4, 3.4], [5.4, 2.3]],
        &[&[0, 1], &[0, 2], &[2, 3, 4], &[3], &[4, 5], &[1, 5]],
    );
    ram.slides.push(slide(3, GROUND, [0.0, 2.0], 5.0));
    ram.drives.push(driving(Driven::Angle, [5, GROUND]));
    is_closed_beside_its_drawing("a ram", &ram, 8);
    let mut block = machine(
        &[[0.0, 0.0], [4.6, 0.2], [0.5, 0.9], [1.6, 1.6], [3.0, 1.9], [2.4, 3.0]],
        &[&[0, 1], &[0, 2], &[2, 3], &[3, 4, 5], &[1, 4], &[5]],
    );
    block.slides.push(slide(5, GROUND, [0.2, 3.2], 4.0));
    block.drives.push(driving(Driven::Angle, [1, GROUND]));
    is_closed_beside_its_drawing("a block", &block, 8);
}

/// Dyads with slides, no pin of which is on its line, and a boom that takes the link which carries its guide along.
#[test]
fn dyads_with_slides_are_closed_beside_the_drawing() {
    let places = [[0.0, 0.0], [3.0, 0.4], [0.6, 0.9]];
    let crank = driving(Driven::Angle, [1, GROUND]);
    // A block at the crank's end in the slot of a rocker.
    let mut rocker = machine(&places, &[&[0, 1], &[0, 2], &[1], &[2]]);
    rocker.slides.push(slide(3, 2, [1.1, 1.2], -20.0));
    // The same block in the slot of a yoke on a rail.
    let mut yoke = machine(&places, &[&[0, 1], &[0, 2], &[], &[2]]);
    yoke.slides = vec![slide(3, 2, [0.9, 0.7], 70.0), slide(2, GROUND, [0.2, 0.3], 10.0)];
    // A pin on a rail of the ground and on one of the crank.
    let mut rails = machine(&[places[0], [1.4, 1.1]], &[&[0], &[0], &[1], &[1]]);
    rails.slides = vec![slide(2, GROUND, [0.3, 1.3], 8.0), slide(3, 1, [0.1, 0.4], 50.0)];
    // A boom that turns, with a jib that has the guide.
    let mut boom = machine(&[places[0], [1.5, 0.9], [2.4, 1.2]], &[&[0], &[0, 1], &[2]]);
    boom.slides.push(slide(1, 2, [1.1, 0.7], 30.0));
    for machine in [&mut rocker, &mut yoke, &mut rails, &mut boom] {
        machine.drives.push(crank.clone());
    }
    boom.drives.push(driving(Driven::Slide(0), [1, 2]));
    let machines = [("a rocker", rocker), ("a yoke", yoke), ("two rails", rails), ("a boom", boom)];
    for (name, machine) in machines {
        is_closed_beside_its_drawing(name, &machine, 1);
    }
}

/// Links of given angle between two bars are carried without being turned: one, two behind each other, and one that keeps
/// its angle to a rocker.
#[test]
fn links_that_bars_carry_are_closed_beside_the_drawing() {
    let places = [[0.0, 0.0], [3.1, 0.2], [0.5, 1.1], [2.2, 1.4]];
    let mut plate = machine(&places, &[&[0, 1], &[0, 2], &[2, 3], &[3, 1]]);
    plate.drives.push(driving(Driven::Angle, [2, GROUND]));
    let longer = [&places[..], &[[2.9, 2.3]]].concat();
    let mut plates = machine(&longer, &[&[0, 1], &[0, 2], &[2, 3], &[3, 4], &[4, 1]]);
    plates.drives = [2, 3].map(|link| driving(Driven::Angle, [link, GROUND])).into();
    let far = [&places[..], &[[4.4, 0.1]]].concat();
    let mut level = machine(&far, &[&[0, 1, 4], &[0, 2], &[2, 3], &[3, 1], &[4]]);
    level.drives = [[4, GROUND], [2, 4]].map(|ends| driving(Driven::Angle, ends)).into();
    for (name, machine) in [("a plate", plate), ("two plates", plates), ("a level", level)] {
        is_closed_beside_its_drawing(name, &machine, 1);
    }
}
