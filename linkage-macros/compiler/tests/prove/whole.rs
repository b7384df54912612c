//! Whole programs: no error is above its bound, and no bound is far above the worst error.

use super::computed::computed;
use super::machines::{Case, MACHINES, case};
use crate::cases::cases;
use crate::equations::declarations::VARIANTS;
use crate::equations::parallelograms::PARALLELOGRAMS;
use crate::ir::interpret::{Number, ProgramValues, interpret};
use crate::oracle::{Digits, defaults, mechanism};
use crate::prove::boxes::{Budget, Proof, prove};
use crate::prove::goal::{Goal, Unproved};
use crate::prove::one_box::OneBox;
use crate::prove::sloped::InputBox;
use crate::prove::width::Precision;

pub(super) const BUDGET: Budget = Budget { boxes: 4096, smallest: 1.0 / 32768.0 };

/// Poses all over the range, and as many around the places where the bounds are largest.
fn tried(proof: &Proof, ranges: &[[f64; 2]], count: usize) -> Vec<Vec<f64>> {
    // Weyl sequences go through every part of the range alike.
    const STEPS: [f64; 3] = [0.618_033_988_749_895, 0.754_877_666_246_693, 0.569_840_290_998_053];
    // A peak may be narrow.
    const WIDTHS: [f64; 3] = [2e-3, 2e-4, 2e-5];
    let mut places: Vec<&[f64]> =
        proof.bounds.iter().flatten().map(|bound| &bound.at[..]).collect();
    places.sort_by(|a, b| a.partial_cmp(b).expect("numbers"));
    places.dedup();
    let share = |pose: usize, input: usize| ((pose + 1) as f64 * STEPS[input]).fract();
    let within = |value: f64, [from, to]: [f64; 2]| {
        // The ends are no numbers of the width.
        let value = value as f32;
        f64::from(match () {
            () if f64::from(value) < from => value.next_up(),
            () if f64::from(value) > to => value.next_down(),
            () => value,
        })
    };
    let all_over = (0..count).map(|pose| {
        let at = |(input, &[from, to]): (usize, &[f64; 2])| {
            within(from + (to - from) * share(pose, input), [from, to])
        };
        ranges.iter().enumerate().map(at).collect()
    });
    let around = (0..count).map(|pose| {
        let place = places[pose % places.len()];
        let at = |(input, &[from, to]): (usize, &[f64; 2])| {
            let width = (to - from) * WIDTHS[pose / places.len() % WIDTHS.len()];
            let near = place[input] + width * (share(pose, input) - 0.5);
            within(near.clamp(from, to), [from, to])
        };
        ranges.iter().enumerate().map(at).collect()
    });
    all_over.chain(around).collect()
}

/// The bound of each result over the largest error that is seen, where that is not nothing.
fn over_what_is_seen(name: &str, case: &Case, poses: usize) -> Vec<f64> {
    let subject =
        Goal::new(&case.program.graph, (&case.sinks, &[]), &case.given, Precision::SINGLE);
    let wide = Goal::new(&case.program.graph, (&case.sinks, &[]), &case.given, Precision::DOUBLE);
    let proof = prove(&subject, BUDGET);
    if let Some(open) = proof.open.first() {
        let values = OneBox::new(&subject, InputBox::new(open));
        let unknown = values.values.iter().position(|jet| !jet.range().is_finite());
        let node = unknown.map(|place| subject.nodes[place]);
        panic!("{name}: {} boxes are open, the first is {open:?}, {node:?}", proof.open.len());
    }
    // Nobody states the errors of a library's functions.
    let bounds: Vec<f64> = (proof.bounds.iter())
        .map(|bound| match bound {
            Ok(bound) => bound.error,
            Err(why) => {
                let is_librarys =
                    matches!(why, Unproved::Function(of) if of.last_places().is_none());
                assert!(is_librarys, "{name}: {why:?}");
                f64::INFINITY
            }
        })
        .collect();
    let mut seen = vec![0.0f64; case.sinks.len()];
    for pose_at in tried(&proof, &case.given.ranges, poses) {
        let exact = computed::<f64>(&wide, &pose_at, false, None);
        for is_fused in [false, true] {
            let found = computed::<f32>(&subject, &pose_at, is_fused, None);
            for (at, &sink) in case.sinks.iter().enumerate() {
                let error = (f64::from(found[subject.place(sink)]) - exact[wide.place(sink)]).abs();
                // The error of f64 is 2⁻²⁹ of that of f32.
                assert!(
                    error <= bounds[at] * (1.0 + 1e-6),
                    "{name}: result {at} at {pose_at:?}: {error:e} is above {:e}",
                    bounds[at]
                );
                seen[at] = seen[at].max(error);
            }
        }
    }
    let over = bounds.iter().zip(&seen).filter(|(bound, seen)| bound.is_finite() && **seen > 0.0);
    let ratios: Vec<f64> = over.map(|(bound, seen)| bound / seen).collect();
    let worst = ratios.iter().copied().fold(0.0, f64::max);
    let (count, nodes) = (ratios.len(), subject.nodes.len());
    let mut sorted = ratios.clone();
    sorted.sort_by(f64::total_cmp);
    let median = sorted.get(count / 2).copied().unwrap_or(0.0);
    println!(
        "{name}: {nodes} nodes, {} boxes, {count} results: bound over seen {median:.2}, at most {worst:.2}",
        proof.boxes
    );
    ratios
}

/// Machines at rates of one and at accelerations of one. So that a bound cannot rot, none is far above what is
/// seen.
fn of_machines(poses: usize) {
    let mut all = Vec::new();
    for machine in MACHINES {
        let rates: &[[f64; 2]] =
            if machine.entry == "motion" { &[[1.0, 0.0], [0.0, 1.0]] } else { &[[3.0, -2.0]] };
        for &rates in rates {
            let case = machine.case(rates);
            let ratios = over_what_is_seen(machine.name, &case, poses);
            // Two hundred roundings do not all point one way in so few poses.
            let most = if case.given.ranges.len() == 1 && machine.dyads < 3 { 6.0 } else { 10.0 };
            let worst = ratios.iter().copied().fold(0.0, f64::max);
            assert!(worst <= most, "{}: {worst}", machine.name);
            all.extend(ratios);
        }
    }
    all.sort_by(f64::total_cmp);
    let median = all[all.len() / 2];
    println!("{} results: median {median:.2}", all.len());
    assert!(median <= 2.5, "{median}");
}

#[test]
fn no_error_is_above_its_bound_and_no_bound_is_far_above() {
    of_machines(cases(1_500, 6_000));
}

#[test]
#[ignore = "minutes: `.ci/nightly` takes it"]
fn no_error_of_many_poses_is_above_its_bound() {
    of_machines(60_000);
}

/// Every third variant of a group, and with `LINKAGE_WHOLE` every one, has bounds around its pose, and no error is above them.
#[test]
fn variants_of_groups_are_proved() {
    for variant in VARIANTS.iter().chain(PARALLELOGRAMS).step_by(cases(3, 1)) {
        // Where two lengths are equal, as at 0.2, a selection jumps.
        let around = |[value, ..]: &[f64; 3]| [*value, value + 0.01];
        let ranges: Vec<[f64; 2]> = variant.inputs.iter().map(around).collect();
        let case = case(variant.source, &ranges, "motion", [1.0, 0.5]);
        over_what_is_seen(variant.name, &case, 60);
    }
}

/// `f64` against a hundred digits.
#[test]
fn no_error_of_double_precision_is_above_its_bound() {
    for machine in MACHINES.iter().filter(|machine| machine.entry == "motion") {
        let case = machine.case([1.0, 0.5]);
        let subject =
            Goal::new(&case.program.graph, (&case.sinks, &[]), &case.given, Precision::DOUBLE);
        let proof = prove(&subject, BUDGET);
        for pose in tried(&proof, &case.given.ranges, 4) {
            let input = |at: &f64| [*at, 1.0, 0.5].map(Digits::float);
            let given = ProgramValues {
                inputs: pose.iter().map(input).collect(),
                params: defaults(&mechanism(machine.source)),
                loads: Vec::new(),
                drives: Vec::new(),
                unit: None,
            };
            let exact = interpret(&case.program, &given);
            for is_fused in [false, true] {
                let found = computed::<f64>(&subject, &pose, is_fused, None);
                for (bound, &sink) in proof.bounds.iter().zip(&case.sinks) {
                    let found = Digits::float(found[subject.place(sink)]);
                    let error = found.sub(&exact[sink.index()]).to_f64().abs();
                    let bound = bound.as_ref().expect("proved").error;
                    assert!(
                        error <= bound,
                        "{}: {error:e} is above {bound:e} at {pose:?}",
                        machine.name
                    );
                }
            }
        }
    }
}

/// Velocities' bounds are multiples of the rates, and accelerations' of their squares, as long as no square
/// underflows.
#[test]
fn bounds_are_multiples_of_rates() {
    let machine = &MACHINES[0];
    let unit = machine.case([1.0, 0.0]);
    let of = |case: &Case| {
        let subject =
            Goal::new(&case.program.graph, (&case.sinks, &[]), &case.given, Precision::SINGLE);
        prove(&subject, BUDGET)
    };
    let proof = of(&unit);
    // Positions, velocities and accelerations of three links, two pins and a point.
    let powers = [vec![0; 12], vec![1; 9], vec![2; 9]].concat();
    assert_eq!(powers.len(), unit.sinks.len());
    for rate in [3.7_f32, 250.0, 1e-15].map(f64::from) {
        let case = machine.case([rate, 0.0]);
        let subject =
            Goal::new(&case.program.graph, (&case.sinks, &[]), &case.given, Precision::SINGLE);
        let wide =
            Goal::new(&case.program.graph, (&case.sinks, &[]), &case.given, Precision::DOUBLE);
        for pose in tried(&proof, &case.given.ranges, 2_000) {
            let exact = computed::<f64>(&wide, &pose, false, None);
            let found = computed::<f32>(&subject, &pose, true, None);
            for (at, &sink) in case.sinks.iter().enumerate() {
                let error = (f64::from(found[subject.place(sink)]) - exact[wide.place(sink)]).abs();
                let bound = proof.bounds[at].as_ref().expect("proved").error;
                let bound = bound * rate.powi(powers[at]) * (1.0 + 1e-6);
                assert!(error <= bound, "{at} at {pose:?}: {error:e} is above {bound:e}");
            }
        }
    }
}
