//! Machines of which one group is solved by all its unknowns at once, where the certificate has to refuse: fits that are off,
//! drives beyond the stretch that was followed, and drawings at dead points.

use super::certified_reach::{CLOSED, OFF, Traced, traced};
use super::freely_placed::Links;
use super::machine::machine;
use super::tracked::of_several_unknowns;
use super::variants::Random;
use crate::cases::cases;

/// The machine with every unknown off by so much where the steps begin, one way or the other.
fn spoiled(mut traced: Traced, by: f64, random: &mut Random) -> Traced {
    traced.machine = traced.machine.changed(|mechanism| {
        for piece in &mut mechanism.tracked[0].fit.pieces {
            for powers in &mut piece.powers {
                powers[0] += by * if random.below(2) == 0 { 1.0 } else { -1.0 };
            }
        }
    });
    traced
}

/// Four steps behind a product of at most 1/32 leave nothing, so that whatever is certified is exact; K is about thirty
/// here, so that a start that is off by two thousandths is certified nowhere.
#[test]
fn a_fit_that_is_off_leads_to_the_motion_or_is_refused() {
    let list = of_several_unknowns();
    let mut random = Random(0x2545_f491_4f6c_dd1d);
    let mut counts = Vec::new();
    for part in (0..24).step_by(cases(2, 1)) {
        let by = 1e-4 * 1.5_f64.powi(part);
        let traced = spoiled(traced(3, &list).0, by, &mut random);
        let [from, to] = traced.ends();
        let mut certified = 0;
        for part in 0..40 {
            let drive = from + (to - from) * (f64::from(part) + 0.5) / 40.0;
            let found = traced.judged::<f64>(drive, |value| *value, CLOSED[0]);
            let Some(judged) = found else { continue };
            assert!(judged.rigid && judged.off < OFF[0], "{by:e} at {drive}: {:e}", judged.off);
            certified += 1;
        }
        counts.push(certified);
        assert!(by < 2e-3 || certified == 0, "{certified} at {by}");
    }
    println!("{counts:?}");
    assert!(counts[0] > 30 && counts.contains(&0), "{counts:?}");
}

/// Rounding of single precision over a stretch is let through, and no more.
#[test]
fn beyond_its_stretch_a_machine_is_refused() {
    let list = of_several_unknowns();
    let Traced { machine, drawn, .. } = traced(3, &list).0;
    assert!(!machine.mechanism.tracked[0].fit.closes);
    let [from, to] = machine.mechanism.tracked[0].fit.stretch();
    let whole = to - from;
    for (end, outwards) in [(from, -1.0), (to, 1.0)] {
        let at = |beyond: f64| [drawn + end + outwards * beyond * whole];
        for inside in [-0.1, -1e-3, -1e-5, 5e-7] {
            assert!(machine.is_certified(&at(inside)), "{inside} beyond {end}");
        }
        for beyond in [5e-6, 1e-5, 1e-4, 1e-3, 0.1] {
            assert!(!machine.is_certified(&at(beyond)), "{beyond} beyond {end}");
        }
    }
}

/// The pose of the motion next to its end, as near as Newton's method goes.
#[test]
fn a_drawing_at_a_dead_point_is_refused() {
    let list = of_several_unknowns();
    let Traced { bar, poses, .. } = traced(3, &list).0;
    let links = Links::of(&bar.driven, &bar.places);
    let declared = |at: &[f64]| {
        let pins = bar.driven.joints.iter().enumerate();
        let places: Vec<_> = pins.map(|(joint, &[link, _])| links.place(link, joint, at)).collect();
        machine(&format!("pub struct M {{ {} }}", bar.driven.statements(&places)))
    };
    let (mut drive, mut last) = poses[poses.len() - 1].clone();
    let before = declared(&poses[poses.len() * 3 / 4].1);
    assert!(before.is_ok(), "{:?}", before.err());
    let mut step = 1e-5;
    while step > 1e-15 {
        match links.beside(drive + step, &last) {
            Some(at) => (drive, last) = (drive + step, at),
            None => step /= 2.0,
        }
    }
    let told = declared(&last).err().expect("it is at a dead point");
    assert!(
        told[0].contains("at a dead point") && told[0].contains("draw another pose"),
        "{told:?}"
    );
}

/// A block that slides on a link which an unknown turns: all links stay rigid, and the block stays on its way.
#[test]
fn a_block_slides_on_a_link_that_an_unknown_turns() {
    let machine = machine(
        "pub struct M { input theta: angle; ground P26(0.885, 0.043), P67(0.743, 0.312);
         pin P01(0.102, 0.069), P02(0.935, 0.827), P13(0.6, 0.124), P34(0.207, 0.988), P15(0.884, 0.368),
             P25(0.535, 0.864), P37(0.703, 0.282);
         link L0(P01, P02), L1(P01, P13, P15), L2(P02, P25, P26), L3(P13, P34, P37);
         guide rail on L0 through P02 towards P01;
         link L4(P34) on rail, L5(P15, P25), L7(P37, P67); drive L7.angle = theta; }",
    );
    let machine = machine.unwrap_or_else(|told| panic!("{told:?}"));
    let unknowns = &machine.mechanism.tracked[0].fit.unknowns;
    assert_eq!(unknowns.iter().filter(|unknown| !unknown.is_angle).count(), 1);
    let drawn = machine.drawn_inputs()[0];
    let beside_the_way = |pins: &[(String, [f64; 2])]| {
        let at = |name: &str| pins.iter().find(|(pin, _)| pin == name).expect("it is an output").1;
        let [a, b, c] = ["P02", "P01", "P34"].map(at);
        let along = [b[0] - a[0], b[1] - a[1]];
        along[0] * (c[1] - a[1]) - along[1] * (c[0] - a[0])
    };
    let right = beside_the_way(&machine.drawn::<f64>(false));
    for part in 0..200 {
        let theta = drawn + std::f64::consts::TAU * f64::from(part) / 200.0;
        let pins = machine.certified::<f64>(&[theta]);
        let pins = pins.unwrap_or_else(|| panic!("{theta} is not certified"));
        assert!(machine.are_rigid(&pins, CLOSED[0]), "{theta}");
        let off = beside_the_way(&pins) - right;
        assert!(off.abs() < CLOSED[0], "{off:e} at {theta}");
    }
}
