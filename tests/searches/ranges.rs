//! The range of a machine, against closed forms and against stepping.

use std::f64::consts::{PI, TAU};

use linkage_core::range::{RangeError, Stop, Stretches, Turn, extrema, limits};
use linkage_core::{Real, Side, SolveError};
use linkage_tests::mechanisms::change_points::{FourOneTwoThree, Parallelogram, TurningKite};
use linkage_tests::mechanisms::ranges::{Boom, Chain, FourBar, Geared, Guides, Telescope};
use linkage_tests::random::{Random, cases};
use num_dual::Dual64;

const GROUP: &str = "BC, DC";
const LIMIT: Stop = Stop::Limit { group: GROUP };
const CHANGE: Stop = Stop::ChangePoint { group: GROUP };

/// Where a four-bar's bars lie on one line, between −π and π, and what the angle's error is per
/// relative error of its cosine.
fn closed_form([crank, coupler, rocker, base]: [f64; 4]) -> Vec<(f64, f64)> {
    let mut angles = Vec::new();
    for reach in [coupler + rocker, coupler - rocker] {
        // d² − reach², split so that nothing cancels but what the data cancel.
        let down = (base - crank - reach) * (base - crank + reach);
        let up = (base + crank - reach) * (base + crank + reach);
        // sin² and cos² of the half angle, over 4·crank·base.
        if down < 0.0 && up > 0.0 {
            let angle = 2.0 * (-down).sqrt().atan2(up.sqrt());
            let squares =
                crank * crank + base * base + reach * reach + coupler * coupler + rocker * rocker;
            angles.push((angle, squares / (2.0 * crank * base) / angle.sin().abs()));
            angles.push((-angle, squares / (2.0 * crank * base) / angle.sin().abs()));
        }
    }
    angles.sort_by(|a, b| a.0.total_cmp(&b.0));
    angles
}

/// Random lengths, a fifth of them next to a change point.
fn lengths(random: &mut Random) -> [f64; 4] {
    let [crank, coupler, rocker, mut base] = [(); 4].map(|()| random.anywhere(0.2, 2.0));
    if random.anywhere(0.0, 1.0) < 0.2 && coupler + rocker - crank > 0.1 {
        let away = 10_f64.powf(random.anywhere(-9.0, -2.0));
        let sign = if random.anywhere(0.0, 1.0) < 0.5 { -1.0 } else { 1.0 };
        base = (coupler + rocker - crank) * (1.0 + sign * away);
    }
    [crank, coupler, rocker, base]
}

fn four_bar<T: Real>([crank, coupler, rocker, base]: [T; 4]) -> FourBar<T> {
    FourBar { crank, coupler, rocker, base, elbow: Side::Left }
}

/// The ends that are limits.
fn limits_of<T: Real>(stretches: &Stretches<T>) -> Vec<f64> {
    let ends = stretches.iter().flat_map(|stretch| [stretch.from, stretch.to]);
    ends.filter(|end| end.stop == LIMIT).map(|end| end.at.value()).collect()
}

/// A sample of the four-bars of `.ci/nightly`.
#[test]
fn limits_of_random_four_bars() {
    let mut random = Random::new(11);
    let mut worst = 0.0_f64;
    for _ in 0..cases(700, 2000) {
        let lengths = lengths(&mut random);
        let solver = four_bar(lengths);
        let expected = closed_form(lengths);
        // Seen from where no limit is near the edges.
        let stretches = limits(&solver, [-PI - 0.05, PI - 0.05]).expect("an interval");
        let mut found = limits_of(&stretches);
        assert_eq!(found.len(), expected.len(), "{lengths:?} {found:?} {expected:?}");
        found.iter_mut().for_each(|at| *at += if *at < -PI { TAU } else { 0.0 });
        found.sort_by(f64::total_cmp);
        for (&found, (angle, condition)) in found.iter().zip(expected) {
            worst = worst.max((found - angle).abs() / condition);
        }
        for stretch in &stretches {
            for part in [0.0, 1e-9, 0.1, 0.5, 0.999, 1.0] {
                let at = stretch.from.at + part * stretch.width();
                let pose = solver.position(at.clamp(stretch.from.at, stretch.to.at));
                assert!(pose.is_ok(), "{lengths:?} {stretch:?} {part}: {pose:?}");
            }
        }
    }
    println!("worst error over conditioning {worst:.1e}");
    assert!(worst <= 1e-14, "{worst:e}");
}

/// A sample of the four-bars of `.ci/nightly`.
#[test]
fn limits_of_random_four_bars_in_single_precision() {
    let mut random = Random::new(12);
    let mut worst = 0.0_f64;
    for _ in 0..cases(700, 2000) {
        let lengths = [(); 4].map(|()| random.between(0.2, 2.0));
        let expected = closed_form(lengths);
        let solver = four_bar(lengths.map(|length| length as f32));
        let stretches = limits(&solver, [-3.2, 3.08]).expect("an interval");
        let mut found = limits_of(&stretches);
        assert_eq!(found.len(), expected.len(), "{lengths:?} {found:?} {expected:?}");
        found.iter_mut().for_each(|at| *at += if *at < -PI { TAU } else { 0.0 });
        found.sort_by(f64::total_cmp);
        for (&found, (angle, condition)) in found.iter().zip(expected) {
            worst = worst.max((found - angle).abs() / condition);
        }
    }
    println!("worst error over conditioning {worst:.1e}");
    // As many units in the last place as 1e-14 is in double precision.
    assert!(worst <= 45.0 * f64::from(f32::EPSILON), "{worst:e}");
}

/// Six-bars, with a rod behind them, against stepping: every pose that can be computed lies in a
/// stretch, and no other does.
#[test]
fn limits_of_random_chains() {
    // A step takes some 50 µs without optimisation, most of them where a pose is refused.
    let (machines, per_machine) = if cfg!(debug_assertions) { (120, 500) } else { (2000, 2000) };
    let mut random = Random::new(13);
    let (mut partial, mut wrong, mut steps) = (0, Vec::new(), 0);
    let mut ended_by = [0; 3];
    for machine in 0..machines {
        let mut length = |low, high| random.anywhere(low, high);
        let chain = Chain {
            crank: length(0.5, 1.5),
            coupler: length(1.5, 3.5),
            rocker: length(1.5, 3.0),
            base: length(2.0, 4.0),
            link: length(0.8, 3.0),
            lever: length(0.8, 3.0),
            post: length(3.0, 6.0),
            rod: length(0.5, 3.0),
            elbow: if machine % 2 == 0 { Side::Left } else { Side::Right },
            knee: if machine % 3 == 0 { Side::Left } else { Side::Right },
        };
        let stretches = limits(&chain, [-PI, PI]).expect("an interval");
        partial += i32::from(!stretches.is_whole() && !stretches.is_empty());
        for stop in stretches.iter().flat_map(|stretch| [stretch.from.stop, stretch.to.stop]) {
            let groups = ["BC, DC", "CF, GF", "FH, ram"];
            if let Some(group) = groups.iter().position(|group| stop.group() == Some(group)) {
                ended_by[group] += 1;
            }
        }
        for step in 0..per_machine {
            let part = (f64::from(step) + random.anywhere(0.0, 1.0)) / f64::from(per_machine);
            let at = -PI + TAU * part;
            let inside = stretches.iter().any(|of| of.from.at <= at && at <= of.to.at);
            steps += 1;
            if chain.position(at).is_ok() != inside {
                wrong.push((machine, at, inside));
            }
        }
    }
    println!("{partial} of {machines} in part, ended by {ended_by:?}, {steps} steps");
    assert!(partial > machines / 8 && ended_by.iter().all(|&count| count > machines / 40));
    assert!(wrong.is_empty(), "{wrong:?}");
}

#[test]
fn change_points_separate_stretches() {
    let parallelogram = limits(&Parallelogram::new(), [-3.0, 6.0]).expect("an interval");
    let ends: Vec<_> = parallelogram.iter().map(|of| (of.from.at, of.to.at)).collect();
    assert_eq!(ends.len(), 3, "{parallelogram:?}");
    // A double root is known to the square root of its rounding.
    let near = |found: f64, expected: f64| assert!((found - expected).abs() < 1e-7, "{found}");
    near(ends[0].1, 0.0);
    near(ends[1].0, 0.0);
    near(ends[1].1, PI);
    near(ends[2].0, PI);
    let stops = |of: &Stretches<f64>| -> Vec<_> {
        of.iter().flat_map(|stretch| [stretch.from.stop, stretch.to.stop]).collect()
    };
    assert_eq!(stops(&parallelogram), [Stop::Edge, CHANGE, CHANGE, CHANGE, CHANGE, Stop::Edge]);
    let others = limits(&FourOneTwoThree::new(), [1.0, 1.0 + TAU]).expect("an interval");
    assert_eq!(stops(&others), [Stop::Edge, CHANGE, CHANGE, Stop::Edge]);
    near(others[0].to.at, PI);
    // There the joints meet, and no pose is determined.
    let kite = limits(&TurningKite::new(), [-1.0, 1.5]).expect("an interval");
    assert_eq!(stops(&kite), [Stop::Edge, CHANGE, CHANGE, Stop::Edge]);
    near(kite[0].to.at, 0.0);
    // An edge that lies on a change point or on a limit is that.
    let half = limits(&Parallelogram::new(), [0.0, PI]).expect("an interval");
    assert_eq!(stops(&half), [CHANGE, CHANGE]);
    let solver = four_bar([2.0, 3.0, 2.5, 4.0]);
    let end = closed_form([2.0, 3.0, 2.5, 4.0])[1].0;
    for between in [[0.0, end], [0.0, end.next_down()]] {
        let upto = limits(&solver, between).expect("an interval");
        assert_eq!(stops(&upto), [Stop::Edge, LIMIT], "{upto:?}");
    }
    assert!(limits(&solver, [end, 3.5]).expect("an interval").is_empty());
    // The smallest miss that the numbers can tell is none.
    for away in [1e-13, 1e-9, 1e-3] {
        let whole = four_bar([1.0, 2.0, 3.0, 4.0 - 4.0 * away]);
        assert!(limits(&whole, [-1.0, 4.0]).expect("an interval").is_whole(), "{away}");
        let gap = four_bar([1.0, 2.0, 3.0, 4.0 + 4.0 * away]);
        let stretches = limits(&gap, [-1.0, 4.0]).expect("an interval");
        assert_eq!(stops(&stretches), [Stop::Edge, LIMIT, LIMIT, Stop::Edge], "{away}");
    }
}

#[test]
fn limits_of_other_drivers_and_groups() {
    // The cylinder reaches from |DA| − 1.5 m to |DA| + 1.5 m.
    let base = 0.5_f64.hypot(2.0);
    let boom = limits(&Boom::new(), [-1.0, 9.0]).expect("an interval");
    assert_eq!(boom.len(), 1, "{boom:?}");
    assert!((boom[0].from.at - (base - 1.5)).abs() < 1e-15, "{boom:?}");
    assert!((boom[0].to.at - (base + 1.5)).abs() < 2e-15, "{boom:?}");
    assert_eq!(boom[0].to.stop.group(), Some("cyl, boom"));
    // The crank has no length up to zero, and the block stands off its pivot by 0.25 m.
    let telescope = limits(&Telescope::new(), [-1.0, 3.0]).expect("an interval");
    let ends: Vec<_> = telescope.iter().map(|of| (of.from.at, of.to.at)).collect();
    assert_eq!(ends.len(), 2, "{telescope:?}");
    assert_eq!(telescope[0].from.stop, Stop::Limit { group: "AB" });
    assert!(0.0 < ends[0].0 && ends[0].0 < 1e-15, "{ends:?}");
    assert!((ends[0].1 - 0.75).abs() < 1e-15 && (ends[1].0 - 1.25).abs() < 1e-15, "{ends:?}");
    assert_eq!(telescope[0].to.stop, Stop::Limit { group: "block, bar" });
    assert_eq!(telescope[1].to.stop, Stop::Edge);
    // Sixteen ends in a turn of what drives the crank.
    let geared = limits(&Geared::new(), [-PI / 8.0, TAU - PI / 8.0]).expect("an interval");
    assert_eq!(geared.len(), 8, "{geared:?}");
    for (count, stretch) in geared.iter().enumerate() {
        let middle = 0.5 * (stretch.from.at + stretch.to.at);
        assert!((middle - count as f64 * TAU / 8.0).abs() < 1e-14, "{stretch:?}");
    }
    assert!(limits(&Guides::new(), [-1.0, 1.0]).expect("an interval").is_whole());
}

/// The derivatives of a limit and of an extreme by a length, by dual numbers.
#[test]
fn limits_and_extremes_carry_derivatives() {
    let ends = [-PI, PI].map(Dual64::from_re);
    // At some of these lengths the rounded limit has no pose with a derivative, and is moved.
    for step in 0..40 {
        let lengths = [2.0, 2.7 + 0.01 * f64::from(step), 2.5, 4.0];
        let [crank, coupler, rocker, base] = lengths.map(Dual64::from_re);
        let coupler = Dual64::new(coupler.re, 1.0);
        let solver = four_bar([crank, coupler, rocker, base]);
        let stretches = limits(&solver, ends).expect("an interval");
        // cos θ = (r² + g² − (l + s)²) / 2rg, by l.
        let angle = closed_form(lengths)[1].0;
        let expected = (coupler.re + 2.5) / (2.0 * 4.0 * angle.sin());
        let [from, to] = [stretches[0].from.at, stretches[0].to.at];
        for (found, angle, expected) in [(from, -angle, -expected), (to, angle, expected)] {
            assert!((found.re - angle).abs() < 4e-15, "{found} {angle}");
            assert!((found.eps - expected).abs() < 2e-14, "{found} {expected}");
        }
    }
    let [rocker, base] = [2.5, 4.0].map(Dual64::from_re);
    let coupler = Dual64::new(3.0, 1.0);
    // A crank-rocker whose rocker stops where crank and coupler stretch out.
    let crank = Dual64::from_re(0.5);
    let solver = four_bar([crank, coupler, rocker, base]);
    let swing = extrema(ends, |theta| {
        let at = solver.motion(theta, Dual64::from_re(1.0), Dual64::from_re(0.0))?;
        let angle = at.position.DC.angle_near(Dual64::from_re(1.0));
        Ok([angle, at.velocity.DC.omega, at.acceleration.DC.alpha])
    })
    .expect("it turns fully");
    let [_, least] = swing.least();
    // cos ψ = ((r + l)² − s² − g²) / 2sg for the rocker's angle ψ from the ground.
    let angle = f64::acos((3.5 * 3.5 - 2.5 * 2.5 - 16.0) / (2.0 * 2.5 * 4.0));
    let expected = -3.5 / (2.5 * 4.0 * angle.sin());
    assert!((least.re - angle).abs() < 1e-15 && (least.eps - expected).abs() < 1e-14, "{least}");
}

#[test]
fn bad_intervals_and_parameters_are_errors() {
    let solver = FourBar::new();
    let nan = f64::NAN;
    let infinity = f64::INFINITY;
    let output = |at: f64| Ok([at, 1.0, 0.0]);
    for between in
        [[1.0, 0.0], [1.0, 1.0], [nan, 1.0], [0.0, nan], [-infinity, 1.0], [0.0, infinity]]
    {
        let refused = |error: RangeError| matches!(error, RangeError::Interval { .. });
        assert!(limits(&solver, between).is_err_and(refused), "{between:?}");
        assert!(extrema(between, output).is_err_and(refused), "{between:?}");
    }
    let of = |solver| limits(&solver, [-PI, PI]).map(|stretches| stretches.len());
    let error = of(FourBar { coupler: nan, ..solver });
    assert_eq!(error, Err(RangeError::Solve(SolveError::NotFinite { name: "coupler" })));
    let error = of(FourBar { rocker: infinity, ..solver });
    assert_eq!(error, Err(RangeError::Solve(SolveError::NotFinite { name: "rocker" })));
    let error = of(FourBar { rocker: -2.5, ..solver });
    let invalid = SolveError::Invalid { group: GROUP, name: "rocker" };
    assert_eq!(error, Err(RangeError::Solve(invalid)));
    // Out of reach at every angle is an answer.
    assert_eq!(of(FourBar { base: 90.0, ..solver }), Ok(0));
    // As many turns as make more stretches than there is room for.
    let dyads = FourBar { base: 4.0, crank: 2.0, ..solver };
    assert_eq!(of(dyads), Ok(1));
    let turns = limits(&dyads, [0.0, 100.0 * TAU]).map(|stretches| stretches.len());
    assert_eq!(turns, Err(RangeError::TooMany));
}

#[test]
fn extremes_of_random_rockers() {
    let mut random = Random::new(14);
    let (mut worst, mut count) = (0.0_f64, 0);
    while count < 300 {
        let lengths = lengths(&mut random);
        let [crank, coupler, rocker, base] = lengths;
        let longest = lengths.iter().fold(0.0_f64, |longest, &length| longest.max(length));
        let shortest = lengths.iter().fold(9.0_f64, |shortest, &length| shortest.min(length));
        if shortest < crank || lengths.iter().sum::<f64>() / 2.0 - (longest + crank) < 1e-3 {
            continue;
        }
        count += 1;
        let solver = four_bar(lengths);
        let swing = extrema([-PI - 0.05, PI - 0.05], |theta| {
            let at = solver.motion(theta, 1.0, 0.0)?;
            // C stays above the ground or below it: no jump on the way.
            let angle = at.position.DC.angle_near(PI / 2.0);
            Ok([angle, at.velocity.DC.omega, at.acceleration.DC.alpha])
        })
        .expect("a crank-rocker turns fully");
        // Crank and coupler on one line.
        let angle = |reach: f64| {
            let cos = (rocker * rocker + base * base - reach * reach) / (2.0 * rocker * base);
            PI - cos.acos()
        };
        let expected = [angle(coupler + crank), angle(coupler - crank)];
        assert_eq!(swing.len(), 2, "{lengths:?} {swing:?}");
        let [least, greatest] = [swing.least()[1], swing.greatest()[1]];
        let [low, high] = [expected[0].min(expected[1]), expected[0].max(expected[1])];
        let size = longest * longest / (rocker * base) / low.sin().min(high.sin());
        worst = worst.max((least - low).abs().max((greatest - high).abs()) / size);
        assert!(swing.iter().any(|of| of.turn == Turn::Maximum));
        assert!(swing.iter().any(|of| of.turn == Turn::Minimum));
    }
    println!("worst error over conditioning {worst:.1e}");
    assert!(worst <= 1e-14, "{worst:e}");
}

#[test]
fn extremes_at_ends_of_outputs_at_rest_and_of_failing_ones() {
    // Nothing turns where an output rests, to the rounding of its value, or only rises.
    let rest = Parallelogram::new();
    let coupler = extrema([0.5, 2.5], |theta| {
        let at = rest.motion(theta, 1.0, 0.0)?;
        let along = |c: f64, angle: f64| c - angle;
        let (sin, cos) = theta.sin_cos();
        Ok([
            along(at.position.C.x, cos),
            along(at.velocity.C.x, -sin),
            along(at.acceleration.C.x, -cos),
        ])
    });
    assert!(coupler.expect("it can be assembled").is_empty());
    let cubic = extrema([-1.0, 2.0], |x: f64| Ok([x * x * x, 3.0 * x * x, 6.0 * x]));
    let cubic = cubic.expect("a cubic is defined everywhere");
    assert!(cubic.is_empty());
    assert_eq!((cubic.least(), cubic.greatest(), cubic.stroke()), ([-1.0; 2], [2.0, 8.0], 9.0));
    // A failure on the way is the answer, at an end or between.
    let solver = four_bar([2.0, 3.0, 2.5, 4.0]);
    for between in [[0.0, 3.0], [-3.0, 3.0], [-3.0, 0.0]] {
        let error = extrema(between, |theta| {
            let at = solver.motion(theta, 1.0, 0.0)?;
            Ok([at.position.C.x, at.velocity.C.x, at.acceleration.C.x])
        });
        let is_reach = |error| matches!(error, RangeError::Solve(SolveError::OutOfReach { .. }));
        assert!(error.is_err_and(is_reach));
    }
    for bad in [[f64::NAN, 1.0, 1.0], [1.0, f64::NAN, 1.0], [1.0, 1.0, f64::INFINITY]] {
        let error = extrema([0.0, 1.0], |_| Ok(bad)).expect_err("no number");
        let not_finite = SolveError::NotFinite { name: "the output" };
        assert_eq!(error, RangeError::Solve(not_finite), "{bad:?}");
    }
}
