//! Motions that are followed from the drawing, pose by pose.

use std::f64::consts::{PI, TAU};
use std::iter;

use super::following::band;
use super::pose::Posed;
use super::trace::{Trace, Way, closing, drawn};
use super::*;

/// The triad with its moving pins at other places.
fn drawn_at(places: [[f64; 2]; 4]) -> Machine {
    let mut machine = triad();
    for (pin, [x, y]) in places.into_iter().enumerate() {
        machine.pins[3 + pin] = Complex::new(x, y);
    }
    machine
}

/// Triads whose moving pins lie anywhere about the ground.
fn random_machines(mut seed: u64) -> impl Iterator<Item = Machine> {
    let mut random = move || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        (seed >> 11) as f64 / (1_u64 << 53) as f64
    };
    iter::repeat_with(move || drawn_at([(); 4].map(|()| [5.0 * random() - 0.5, 4.0 * random()])))
}

/// The ways to solve it, each with the trend that its equation has in the drawing.
fn with_trends(machine: &Machine) -> (Vec<Found>, Vec<SearchedGroup>) {
    let (crank, mut all) = ways(machine);
    for search in &mut all {
        let (mut given, mut posed) = (drawn(machine), Posed::new(machine));
        let slope =
            posed.run(&crank, &mut given, 0.0).and_then(|()| posed.slope(search, &mut given, 0.0));
        search.rises = slope.unwrap_or(0.0) > 0.0;
    }
    (crank, all)
}

/// From pose to pose an unknown changes by less than a part of its unit and its equation keeps the trend: what is
/// followed is one motion, which ends at a dead point and does not go on in another way to assemble the group.
#[test]
fn a_motion_does_not_jump_to_another_root() {
    let (mut followed, mut ended) = (0, 0);
    for machine in random_machines(5).take(40) {
        let (crank, all) = with_trends(&machine);
        let [way] = &Way::all(&machine)[..] else { panic!("a crank alone drives it") };
        for search in all.iter().step_by(4) {
            let trace = Trace::of(&machine, &crank, search, way);
            followed += 1;
            ended += usize::from(trace.closes.is_none());
            for pair in trace.samples.windows(2) {
                let jump = (pair[1].unknown - pair[0].unknown).abs() / search.unit(&machine);
                assert!(jump < 0.4, "{search:?} jumps by {jump} at {}", pair[1].drive);
                assert!(pair[1].drive > pair[0].drive);
            }
            for sample in &trace.samples {
                assert_eq!(sample.slope > 0.0, search.rises, "{search:?} at {}", sample.drive);
            }
        }
    }
    assert!(followed > 60 && ended > 50, "{ended} of {followed}");
}

/// A small crank turns fully, and the bars about the ground come back; one that is measured against the crank has
/// turned once against it.
#[test]
fn a_motion_of_a_full_turn_closes() {
    let machine = drawn_at([[-0.98, 0.03], [0.8, 1.7], [3.0, 0.6], [1.9, 3.1]]);
    let (crank, all) = with_trends(&machine);
    let [way] = &Way::all(&machine)[..] else { panic!("a crank alone drives it") };
    let turns: Vec<_> =
        all.iter().map(|search| Trace::of(&machine, &crank, search, way).closes).collect();
    assert!(turns.contains(&Some(0)) && turns.contains(&Some(-1)), "{turns:?}");
    assert!(turns.iter().flatten().all(|turns| [0, -1].contains(turns)), "{turns:?}");
}

/// A pose that comes back after a turn of the drive, with the unknown where it was or whole turns on.
#[test]
fn a_turn_closes_where_the_unknown_is_back() {
    let (_, all) = ways(&triad());
    let crank = all.into_iter().find(|search| !matches!(search.steps[0], Found::Slider { .. }));
    let crank = crank.expect("an angle is searched");
    for (first, last, turns) in [
        ([-PI, 0.3], [PI, 0.3], Some(0)),
        ([-PI, 0.3], [PI, 0.3 + TAU], Some(1)),
        ([0.0, 0.3], [TAU, 0.3 - 2.0 * TAU], Some(-2)),
        ([-PI, 0.3], [PI, 0.3 + 1e-6], None),
        ([-PI, 0.3], [PI, 0.3 - 1e-6 + TAU], None),
        ([-PI, 0.3], [PI - 1e-6, 0.3], None),
        ([-PI, 0.3], [PI + 1e-6, 0.3], None),
        ([0.0, 0.3], [PI, 0.3], None),
        ([0.0, 0.3], [-TAU, 0.3], None),
    ] {
        assert_eq!(closing(&crank, first, last), turns, "{first:?} to {last:?}");
    }
}

/// A motion that goes from 156° behind the drawing to 180° before it and does not close: over nearly a turn sin x is
/// zero at both ends, so that it is followed over 324° at most. The end farther from the drawing is given up, by whole
/// steps of 3°, and so in its mirror image, where the crank goes the other way.
#[test]
fn the_farther_end_of_a_motion_of_nearly_a_turn_is_cut() {
    let mut machine = drawn_at([[-0.23, 0.68], [1.1, 3.38], [0.08, 0.42], [1.96, 0.02]]);
    machine.pins[1] = Complex::new(4.0, 0.0);
    let mut mirrored = machine.clone();
    mirrored.pins.iter_mut().for_each(|pin| *pin = pin.conjugate());
    for (machine, whole, wanted) in
        [(machine, [-156.0, 180.0], [-156.0, 168.0]), (mirrored, [-180.0, 156.0], [-168.0, 156.0])]
    {
        let (crank, all) = with_trends(&machine);
        let [way] = &Way::all(&machine)[..] else { panic!("a crank alone drives it") };
        let search = &all[4];
        let trace = Trace::of(&machine, &crank, search, way);
        let [.., last] = &trace.samples[..] else { panic!("it moves") };
        let found = [trace.samples[0].drive, last.drive];
        let stretch = band(&trace, search).expect("it is followed").stretch;
        for (found, wanted) in found.into_iter().chain(stretch).zip([whole, wanted].concat()) {
            // Multiples of a step, to roundings of a turn.
            assert!((found.to_degrees() - wanted).abs() < 1e-9, "{found} in place of {wanted}");
        }
        assert!(trace.closes.is_none());
    }
}

/// The widths about a root that are looked at on either side.
const PARTS: u32 = 400;

/// On one side of a root: the least width at which something cannot be assembled or another root of the trend lies, and
/// whether it is such a root, behind a stretch against the trend that steps of 15 % do not miss.
fn end_beside(
    mut residual: impl FnMut(f64) -> Option<f64>,
    (root, side, rises): (f64, f64, bool),
    most: f64,
) -> (f64, bool) {
    let mut turned_back: Option<f64> = None;
    for width in (1..PARTS).map(|part| most * f64::from(part) / f64::from(PARTS)) {
        let Some(now) = residual(root + side * width) else { return (width, false) };
        let has_its_sign = (now > 0.0) == ((side > 0.0) == rises);
        match turned_back {
            Some(from) if has_its_sign && width > 1.4 * from => return (width, true),
            // Too narrow a stretch to be asked for.
            Some(_) if has_its_sign => return (f64::NAN, false),
            None if !has_its_sign => turned_back = Some(width),
            _ => {}
        }
    }
    (most, false)
}

/// A root is alone up to the next one of its trend on either side, and no nearer: the one between, where the equation
/// turns back, is told apart by its slope.
#[test]
fn a_root_is_alone_up_to_the_next_of_its_trend() {
    let (mut asked, mut by_a_root) = (0, 0);
    for (nth, machine) in random_machines(17).take(84).enumerate() {
        // Those of few machines lie so near, and are not too near to be told.
        if nth % 12 != 0 && ![38, 73, 80].contains(&nth) {
            continue;
        }
        let (crank, all) = with_trends(&machine);
        let [way] = &Way::all(&machine)[..] else { panic!("a crank alone drives it") };
        for search in all.iter().step_by(3) {
            let trace = Trace::of(&machine, &crank, search, way);
            for sample in trace.samples.iter().step_by(3) {
                let most = 0.3 * search.unit(&machine);
                let alone = trace.width_alone(search, sample);
                let ends = [-1.0, 1.0].map(|side| {
                    let from = (sample.unknown, side, search.rises);
                    end_beside(trace.residuals(search, sample), from, most)
                });
                if alone == 0.0 || ends.iter().any(|(end, _)| end.is_nan()) {
                    continue;
                }
                let (end, is_root) = if ends[0].0 < ends[1].0 { ends[0] } else { ends[1] };
                // Widths grow by 15 %, and the ends are found to a part of the greatest one.
                let off = most / f64::from(PARTS);
                assert!(alone < end + off, "{search:?} at {}: {alone} of {end}", sample.drive);
                assert!(
                    alone > end / 1.16 - off,
                    "{search:?} at {}: {alone} of {end}",
                    sample.drive
                );
                asked += 1;
                by_a_root += usize::from(is_root);
            }
        }
    }
    assert!(asked > 300 && by_a_root > 5, "{by_a_root} of {asked}");
}
