//! Accelerations of machines with five and six frictions, put back into the full matrix of all bodies.
//!
//! All amounts depend on each other there. At the acceleration that a drive brings about, the matrix with all
//! friction has to give the drive back.

use crate::equations::derive;
use crate::equations::forces::{Walk, accelerations, evaluated, with_every_input_asked};
use crate::equations::friction::{Jamming, check_declared};
use crate::equations::kinematics::{InputMotion, Kinematics};
use crate::equations::symbol::GraphBuilder;
use crate::interface::entries::Analysis;
use crate::oracle::mechanism;
use crate::passes;

/// The drive that `evaluated` gives to every input.
const DRIVE: f64 = 0.65;

const PRESS: &str = "struct M { input q: angle; ground A(0, 0), D(0.9, -0.1);
    guide rail through (0, 0.9) along 5deg; gravity (0.7, -9.81);
    crank AB(A) -> B { length: 0.2, angle: q }
    rrr BC(B), DC(D) -> C { lengths: (0.8, 0.5), mode: left }
    rrp CK(C), ram(rail) -> K { length: 0.9, mode: ahead }
    mass 2 on BC at (0.4, 0.02) inertia 0.1; mass 3 on DC at (0.2, 0) inertia 0.1; mass 5 on ram at (0, 0.03);
    force (-30, 4) on K; torque 3 on DC;
    friction 0.1 at A radius 0.02; friction 0.12 on BC at C radius 0.02; friction 0.2 at D radius 0.015;
    friction 0.15 between CK and BC at C radius 0.01; friction 0.08 on ram length 0.12;";

const QUICK_RETURN: &str = "struct M { input q: angle; ground A(0, 0), F(-0.7, 0.3);
    guide rail through (0, 0.9) along 5deg; gravity (0.7, -9.81);
    crank AB(A) -> B { length: 0.2, angle: q }
    rpr block(B), rod(F) { offset: 0.03 } point E on rod at (0.9, 0.1);
    rpp slider(E), yoke(rail) { slot: 70deg, offsets: (0.02, -0.01) }
    mass 1 on block at (0.01, 0) inertia 0.01; mass 2 on rod at (0.4, 0) inertia 0.2;
    mass 4 on yoke at (0.1, -0.2) inertia 0.1; inertia 0.1 on AB;
    force (-30, 4) on E;
    friction 0.1 at A radius 0.02; friction 0.12 on block at B radius 0.02; friction 0.1 on block length 0.08;
    friction 0.2 at F radius 0.015; friction 0.09 on slider;";

/// Each machine with either number of frictions in one of the poses; `.ci/nightly` takes both.
#[test]
fn second_rates_with_five_and_six_frictions_give_the_drive_back() {
    drives_come_back(0);
}

#[test]
#[ignore = "minutes: `.ci/nightly` takes it"]
fn second_rates_in_other_poses_give_the_drive_back() {
    drives_come_back(1);
}

fn drives_come_back(first: usize) {
    let poses = [[0.7, 1.3], [2.9, -4.0]];
    let machines = [
        ("press", PRESS, "friction 0.2 on CK at K radius 0.01; }"),
        ("quick return", QUICK_RETURN, "friction 0.06 on yoke length 0.5; }"),
    ];
    for (nth, (name, five, sixth)) in machines.into_iter().enumerate() {
        for (more, count) in [("}", 5), (sixth, 6)] {
            let [q, rate] = poses[(first + nth + count) % 2];
            let source = format!("{five} {more}");
            let motion = [[q, rate, second_rate(&source, [q, rate])]];
            assert!(motion[0][2].abs() > 1e-3, "{name}");
            let found = check_declared(name, &source, &motion, false, &Jamming::LeftOut);
            assert_eq!(found, count, "{name}");
            let drive = drive(&source, &motion);
            // The acceleration is rounded once; masses of some kilograms take that over a metre.
            let rounding = 1e-13 * (30.0 + motion[0][2].abs());
            assert!((drive - DRIVE).abs() < rounding, "{name}: {drive}");
        }
    }
}

fn second_rate(source: &str, [q, rate]: [f64; 2]) -> f64 {
    let mechanism = with_every_input_asked(mechanism(source));
    let builder = GraphBuilder::new(passes::RULES);
    let moving = Kinematics::of(&builder, &mechanism, InputMotion::free(&mechanism, &builder));
    let found = accelerations(&moving)[0];
    let (_, values) = evaluated(&mechanism, builder.graph(), &[[q, rate, 0.0]]);
    values[found.index()].to_f64()
}

/// The effort of the input in a motion.
fn drive(source: &str, motion: &[[f64; 3]]) -> f64 {
    let mechanism = with_every_input_asked(mechanism(source));
    let builder = GraphBuilder::new(passes::RULES);
    let moving = Kinematics::of(&builder, &mechanism, InputMotion::free(&mechanism, &builder));
    let effort = Walk::of(&moving).input_efforts()[0].id;
    let (_, values) = evaluated(&mechanism, builder.graph(), motion);
    values[effort.index()].to_f64()
}

/// Up to eight amounts that depend on each other; with several inputs, of smooth signs alone.
#[test]
fn second_rates_are_offered_where_it_is_known_what_sticks() {
    let is_offered = |inputs: &str, second: &str, count: usize, smooth: &str| {
        let cranks = (1..count).map(|nth| {
            format!(
                "crank L{nth}(A) -> P{nth} {{ length: 1, angle: q }}
                 friction 0.1 on L{nth} at A radius 0.01 {smooth};"
            )
        });
        let source = format!(
            "struct M {{ input {inputs}: angle; ground A(0, 0); crank AB(A) -> B {{ length: 1, angle: q }}
             {second} mass 1 on B; {} friction 0.2 on AB at A radius 0.01 {smooth}; }}",
            cranks.collect::<String>()
        );
        let answers = derive(&mechanism(&source), passes::RULES).answers;
        let points = answers.iter().filter_map(|answer| answer.entry);
        points.into_iter().any(|point| point.analysis == Analysis::ForwardDynamics)
    };
    assert!(is_offered("q", "", 8, "") && !is_offered("q", "", 9, ""));
    let two = "crank BC(B) -> C { length: 1, angle: r } mass 1 on C;";
    let smooth = "smooth 0.1(rad/s)";
    assert!(!is_offered("q, r", two, 1, "") && is_offered("q, r", two, 1, smooth));
    assert!(is_offered("q, r", two, 8, smooth) && !is_offered("q, r", two, 9, smooth));
}
