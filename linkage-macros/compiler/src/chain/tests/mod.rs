//! Cuts of machines by their indices alone.

use std::time::Instant;

use super::cutting::Found;
use super::machine::{Driven, Driving, Machine, RigidBody};
use super::plane::Complex;
use super::{Trouble, cut};

fn body(pins: &[usize]) -> RigidBody {
    RigidBody { pins: pins.to_vec(), ..RigidBody::default() }
}

fn driving(body: usize, against: usize) -> Driving {
    Driving { kind: Driven::Angle, bodies: [body, against], reads: Vec::new() }
}

/// A crank and a row of dyads, each from the pin of the one before to a pin of the ground.
fn row(dyads: usize) -> Machine {
    let mut machine = Machine::default();
    // Pin 2 i is of the ground, pin 2 i + 1 moves.
    for index in 0..=dyads {
        let x = index as f64;
        machine.pins.push(Complex::new(x, 0.0));
        machine.pins.push(Complex::new(x + 0.3, 0.8 + 0.1 * (index % 3) as f64));
    }
    machine.bodies.push(body(&(0..=dyads).map(|index| 2 * index).collect::<Vec<_>>()));
    machine.bodies.push(body(&[0, 1]));
    for index in 1..=dyads {
        machine.bodies.push(body(&[2 * index - 1, 2 * index + 1]));
        machine.bodies.push(body(&[2 * index, 2 * index + 1]));
    }
    machine.drives.push(driving(1, 0));
    machine
}

#[test]
fn a_row_of_dyads_is_cut_one_after_the_other() {
    let machine = row(10);
    let start = Instant::now();
    let steps = cut(&machine).expect("it is a machine");
    println!("{} links in {:?}", machine.bodies.len() - 1, start.elapsed());
    assert_eq!(steps.len(), 11);
    assert!(matches!(steps[0], Found::Crank { body: 1, pivot: 0, .. }));
    for (index, step) in steps.iter().enumerate().skip(1) {
        let Found::Dyad(dyad) = step else { panic!("{step:?}") };
        assert_eq!(dyad.letters(), "rrr");
        assert_eq!(dyad.legs.each_ref().map(|leg| leg.bodies[0]), [2 * index, 2 * index + 1]);
    }
}

#[test]
fn a_bar_beside_another_is_too_many_wherever_it_floats() {
    let mut machine = row(2);
    machine.bodies.push(body(&[1, 3]));
    let troubles = cut(&machine).expect_err("two bars hold one distance");
    let Trouble::TooMany { bodies, drives, freedoms } = &troubles[0] else {
        panic!("{troubles:?}")
    };
    // Two links through the same two pins are one body, whatever the ground does.
    assert_eq!((&bodies[..], &drives[..], *freedoms), (&[2, 6][..], &[][..], 0));
}

#[test]
fn a_dyad_without_a_drive_moves_with_all_that_hangs_on_it() {
    let mut machine = row(3);
    machine.drives.clear();
    let all: Vec<_> = (1..machine.bodies.len()).collect();
    assert_eq!(cut(&machine).unwrap_err(), [Trouble::Loose { bodies: all, freedoms: 1 }]);
}
