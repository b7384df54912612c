//! Cost of the equations of motion: operations before products are contracted into sums.

use crate::ir::cost::{Operations, operations};
use crate::ir::graph::{Check, Node};
use crate::ir::liveness::{Path, live, live_nodes};
use crate::oracle::mechanism;
use crate::passes::{RULES, shortened};
use crate::{equations, passes};

fn written(source: &str, entry: &str) -> Operations {
    let program = shortened(&equations::derive(&mechanism(source), RULES));
    let entry = program.answer(entry).expect("the entry exists");
    operations(&program.graph, &entry.sinks)
}

fn total(of: Operations) -> u32 {
    of.additions + of.multiplications + of.divisions + of.roots + of.sines
}

/// A four-bar of three uniform bars under gravity.
const FOUR_BAR: &str = "struct M { input q: angle; ground A(0, 0), D(0.75, 0);
    gravity (0, -9.81);
    crank AB(A) -> B { length: 0.25, angle: q }
    rrr BC(B), DC(D) -> C { lengths: (0.51, 0.5), mode: left }
    mass 0.05221 on AB uniform; mass 0.10421 on BC uniform; mass 0.10221 on DC uniform;
    output q.drive, AB, BC, DC; }";

#[test]
fn a_four_bar_moves_in_a_hundred_operations() {
    let forward = written(FOUR_BAR, "forward_dynamics");
    assert!(total(forward) <= 100, "{forward:?}");
    // The same divisions as the motion's, and the one by the mass.
    let motion = written(FOUR_BAR, "motion");
    assert_eq!((forward.divisions, forward.roots, forward.sines), (3, 1, 1));
    // The motion is computed from the given cosine and sine of the angle.
    assert_eq!((motion.divisions, motion.roots, motion.sines), (2, 1, 0));
}

/// Andrews' squeezer, seven bodies: Mazzia and Magherini, Test Set for Initial Value Problem
/// Solvers, release 2.4, problem 9. K4, K5 and K6, K7 are both assemblies of one triangle.
pub(super) const SQUEEZER: &str = "struct M { input beta: angle;
    ground O(0, 0), A(-69.34mm, -2.27mm), B(-36.35mm, 32.73mm), C(14mm, 72mm);
    crank K1(O) -> Q        { length: 7mm, angle: beta }
    rrr   K2(Q), K3(B) -> P { lengths: (28mm, 35mm), mode: left }
    rrr   K4(P), K5(A) -> E { lengths: (20mm, 40mm), mode: right }
    rrr   K6(P), K7(A) -> F { lengths: (20mm, 40mm), mode: left }
    point D on K3 at (18mm, 20mm);
    mass 43.25g on K1 at (0.92mm, 0) inertia 2.194e-6;
    mass 3.65g on K2 at (11.5mm, 0) inertia 4.41e-7;
    mass 23.73g on K3 at (10.43mm, 18.74mm) inertia 5.255e-6;
    mass 7.06g on K4 at (14.21mm, 0) inertia 5.667e-7;
    mass 70.5g on K5 at (23.08mm, 9.16mm) inertia 1.169e-5;
    mass 7.06g on K6 at (14.21mm, 0) inertia 5.667e-7;
    mass 54.98g on K7 at (12.28mm, 4.49mm) inertia 1.912e-5;
    spring between D and C { stiffness: 4530(N/m), free_length: 77.85mm } }";

#[test]
fn a_squeezer_of_seven_bodies_moves_in_275_operations() {
    let forward = written(SQUEEZER, "forward_dynamics");
    assert!(total(forward) <= 275, "{} {forward:?}", total(forward));
    assert_eq!((forward.divisions, forward.roots, forward.sines), (6, 3, 1), "{forward:?}");
}

/// Two parallelogram four-bars in a row of five equal links (IFToMM benchmark A02): one pendulum.
const PARALLELOGRAMS: &str = "struct M { input q: angle; ground A(0, 0), C(1, 0), E(2, 0);
    crank AB(A) -> B { length: 1m, angle: q }
    crank CD(C) -> D { length: 1m, angle: 0, relative_to: AB }
    crank EF(E) -> F { length: 1m, angle: 0, relative_to: AB }
    crank BD(B) { angle: 0 } crank DF(D) { angle: 0 }
    gravity (0, -9.81);
    mass 1kg on AB uniform; mass 1kg on CD uniform; mass 1kg on EF uniform;
    mass 1kg on BD at (0.5m, 0); mass 1kg on DF at (0.5m, 0); }";

#[test]
fn parallelograms_are_seen_to_be_one_pendulum() {
    // q'' = (τ − 34.335 cos q)/3
    let program = passes::optimise(&equations::derive(&mechanism(PARALLELOGRAMS), RULES));
    let forward = program.answer("forward_dynamics").expect("the entry exists");
    let of = operations(&program.graph, &forward.sinks);
    let expected =
        Operations { additions: 1, multiplications: 1, divisions: 1, roots: 0, sines: 1 };
    assert_eq!(of, expected);
    assert_eq!(written(PARALLELOGRAMS, "forward_dynamics"), expected);
}

/// A five-bar that carries a load between its rods: the mass of one of two inputs is a sum of squares,
/// and the other pivot alone is compared with its rounding.
const FIVE_BAR: &str = "struct M { input a, b: angle; ground A(0, 0), D(0.4m, 0);
    crank AB(A) -> B { length: 0.3m, angle: a } crank DE(D) -> E { length: 0.3m, angle: b }
    rrr BC(B), EC(E) -> C { lengths: (0.5m, 0.5m), mode: left }
    mass 0.8kg on AB uniform; mass 0.8kg on DE uniform; mass 0.7kg on C;
    output a.drive, b.drive, C; }";

#[test]
fn a_five_bar_is_asked_for_one_pivot_in_130_operations() {
    let program = shortened(&equations::derive(&mechanism(FIVE_BAR), RULES));
    let forward = program.answer("forward_dynamics").expect("the entry exists");
    let live = live(&program.graph, &forward.sinks, Path::Fast);
    let is_pivot = |node| match node {
        Node::Guard(_, guard) => program.graph.condition(guard).check == Check::Moving,
        _ => false,
    };
    let pivots = live_nodes(&program.graph, &live).filter(|&(_, node)| is_pivot(node));
    assert_eq!(pivots.count(), 1);
    let forward = written(FIVE_BAR, "forward_dynamics");
    assert!(total(forward) <= 130, "{} {forward:?}", total(forward));
}
