//! Tests of `chain/redrawn`.

use super::machine::RigidBody;
use crate::chain::machine::{Driven, Driving, Machine, Slide};
use crate::chain::plane::Complex;
pub(crate) use linkage_compiler::chain::redrawn::*;

/// A crank, a coupler with a rod, a block that is driven along it, and a rocker.
fn machine() -> Machine {
    let body = |pins: &[usize]| RigidBody { pins: pins.to_vec(), ..RigidBody::default() };
    let pins = [[0.0, 0.0], [4.0, 0.2], [0.5, 0.9], [3.2, 2.6], [1.9, 2.4]];
    Machine {
        pins: pins.map(|[x, y]| Complex::new(x, y)).into(),
        bodies: vec![body(&[0, 1]), body(&[0, 2]), body(&[2, 3]), body(&[1, 3]), body(&[4])],
        slides: vec![Slide {
            body: 4,
            carrier: 2,
            through: Complex::new(1.5, 2.0),
            along: Complex::new(0.6, 0.8),
        }],
        drives: vec![
            Driving { kind: Driven::Angle, bodies: [1, 0], reads: Vec::new() },
            Driving { kind: Driven::Slide(0), bodies: [4, 2], reads: Vec::new() },
        ],
        ..Machine::default()
    }
}

/// The slopes of every equation are its central differences, in a pose in which nothing is closed.
#[test]
fn slopes_are_those_of_the_equations() {
    const STEP: f64 = 1e-5;
    let machine = machine();
    let bars = [Resized { body: 2, pins: [2, 3], length: 3.0 }];
    let displacements = (0..5).map(|body| {
        let body = f64::from(body);
        let shift = Complex::new(0.3 * body, 0.5 - 0.2 * body);
        Displacement { shift, turn: 0.4 - 0.3 * body }
    });
    let displacements = displacements.collect();
    let mut relaxation = Relaxation { machine: &machine, bars: &bars, share: 0.7, displacements };
    let size = machine.size();
    let rows = relaxation.rows(size);
    assert_eq!(rows.len(), 8 + 2 + 2);
    for body in 0..5 {
        for axis in 0..3 {
            let mut moved = |step: f64| -> Vec<f64> {
                let before = relaxation.displacements[body];
                let now = &mut relaxation.displacements[body];
                match axis {
                    0 => now.shift.x += step * size,
                    1 => now.shift.y += step * size,
                    _ => now.turn += step,
                }
                let off = relaxation.rows(size).iter().map(|row| row.off).collect();
                relaxation.displacements[body] = before;
                off
            };
            let (more, less) = (moved(STEP), moved(-STEP));
            for (index, row) in rows.iter().enumerate() {
                let own = row.slopes.iter().filter(|(other, _)| *other == body);
                let slope: f64 = own.map(|(_, slopes)| slopes[axis]).sum();
                let wanted = (more[index] - less[index]) / (2.0 * STEP);
                // h² of sines of order one, and roundings over h: both below 1e-9.
                let off = (slope - wanted).abs();
                assert!(off < 1e-9, "row {index}, body {body}, axis {axis}: {slope} for {wanted}");
            }
        }
    }
}

/// The determinant by minors.
fn determinant(rows: &[Vec<f64>]) -> f64 {
    let [first, rest @ ..] = rows else { return 1.0 };
    let minor = |column: usize| -> Vec<Vec<f64>> {
        let without = |row: &Vec<f64>| {
            let others = row.iter().enumerate().filter(|(other, _)| *other != column);
            others.map(|(_, value)| *value).collect()
        };
        rest.iter().map(without).collect()
    };
    let sign = |column: usize| if column.is_multiple_of(2) { 1.0 } else { -1.0 };
    let parts = (0..first.len()).map(|i| sign(i) * first[i] * determinant(&minor(i)));
    parts.sum()
}

#[test]
fn the_sign_is_that_of_the_determinant() {
    let mut seed = 0x9e37_79b9_u64;
    let mut number = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        (seed >> 40) as f64 / (1_u64 << 23) as f64 - 1.0
    };
    let mut signs = [0, 0];
    for _ in 0..200 {
        let matrix: Vec<Vec<f64>> = (0..4).map(|_| (0..4).map(|_| number()).collect()).collect();
        let wanted: Vec<f64> = (0..4).map(|_| number()).collect();
        let mut rows = matrix.clone();
        for row in &mut rows {
            let right = row.iter().zip(&wanted).map(|(a, x)| a * x).sum();
            row.push(right);
        }
        let determinant = determinant(&matrix);
        let (solution, is_positive) = eliminated(&mut rows).expect("it is regular");
        assert_eq!(is_positive, determinant > 0.0, "{matrix:?}");
        for (found, wanted) in solution.iter().zip(&wanted) {
            // Roundings over the determinant of numbers of order one.
            assert!((found - wanted).abs() < 1e-13 / determinant.abs(), "{matrix:?}");
        }
        signs[usize::from(is_positive)] += 1;
    }
    assert!(signs[0] > 50 && signs[1] > 50, "{signs:?}");
}
