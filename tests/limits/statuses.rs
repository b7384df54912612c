//! The status of an answer: a sweep beside the single call, margins behind a group that cannot be assembled,
//! inputs that nothing depends on.

#![allow(clippy::needless_update, reason = "a mechanism may have one parameter or several")]

use linkage_core::{Float, Point, Series, Slide, SolveError, Status, unwanted};
use linkage_tests::in_both_widths;
use linkage_tests::mechanisms::statuses::*;
use linkage_tests::mechanisms::unknowns::{Press, PressPosition};
use linkage_tests::random::{Random, cases};
use linkage_tests::widths::number;

/// The status and the slide's rate of one pose of a sweep.
macro_rules! swept {
    ($t:ty, $theta:expr, $rate:expr) => {{
        let (mut slide, mut status) = ([0.0; 16], [Status::default(); 16]);
        let out = TurningGuideVelocity { q: Slide { slide: &mut slide[..] } };
        let (theta, rate) = ([$theta; 16], [$rate; 16]);
        TurningGuide::<$t>::default().sweep_velocity(&theta, &rate, out, &mut status, ()).unwrap();
        assert!(status.iter().all(|one| *one == status[0]));
        (status[0], slide[0])
    }};
}

/// A rate beyond 2¹¹⁵ is more than an exact product can be split from without a fused operation: the
/// single call refuses it, and a sweep on a machine that fuses need not. What it calls solved is
/// right, and below that both say the same.
#[test]
fn a_sweep_refuses_nothing_that_a_single_call_solves_and_is_right_where_it_solves_more() {
    let (narrow, wide) = (TurningGuide::<f32>::default(), TurningGuide::<f64>::default());
    let (mut same, mut more) = (0, 0);
    for step in 0..800 {
        let (theta, rate) = (0.3_f32, 10_f32.powf(30.0 + 0.01 * step as f32));
        let single = narrow.velocity(theta, rate).map(|v| v.q.slide);
        let (status, slide) = swept!(f32, theta, rate);
        let told = single.map_or_else(Status::from, |_| Status::Solved);
        if status == told {
            same += 1;
        } else {
            assert!(matches!(single, Err(SolveError::NotFinite { .. })), "{status:?} {rate:e}");
            assert!(status == Status::Solved && rate > 2_f32.powi(115), "{status:?} {rate:e}");
            more += 1;
        }
        if status == Status::Solved {
            let truth = wide.velocity(theta.into(), rate.into()).unwrap().q.slide;
            let error = (f64::from(slide) - truth).abs();
            assert!(error <= 16.0 * f64::from(f32::EPSILON) * truth.abs(), "{slide:e} {truth:e}");
        } else {
            assert!(slide.is_nan());
        }
    }
    println!("{same} alike, {more} solved by the sweep alone");
    assert!(same > 400, "{same}");
}

/// The group in front has no pose, so what is behind it has no joints to measure between. How far the one in
/// front is beyond its limit is in its margin, and in the error of whoever asks for more.
#[test]
fn margins_behind_a_group_without_a_pose_are_no_numbers() {
    let (both, front) = (WatchedChain::new(), WatchedFront::new());
    let within = both.margins(1.0).unwrap();
    assert!(within.DC_margin > 0.0 && within.CE_margin > 0.0);
    assert_eq!(front.margins(1.0).unwrap().DC_margin, within.DC_margin);
    for beyond in [1e-9, 1e-6, 1e-3] {
        // |BD| is 2.8 m at half a turn.
        let coupler = 1.4 - beyond;
        let theta = core::f64::consts::PI;
        let chain = WatchedChain { coupler, ..both };
        let answer = chain.position(theta);
        let Err(SolveError::OutOfReach { group: "BC, DC", by }) = answer.map(|_| ()) else {
            panic!("{answer:?}");
        };
        assert!((by - beyond).abs() <= 1e-15, "{by:e}");
        let told = chain.margins(theta).unwrap();
        assert!(told.CE_margin.is_nan(), "{told:?}");
        let margin = WatchedFront { coupler, ..front }.margins(theta).unwrap().DC_margin;
        // The slow path's length may differ from the fast one's by a last place.
        assert!((margin - told.DC_margin).abs() <= 2.0 * f64::EPSILON * by);
        // Slope one at the limit, with a curvature below one.
        assert!((margin + by).abs() <= by * by + 1e-15, "{margin:e} {by:e}");
    }
}

/// Answers are judged by what comes out: what depends on no input is right at every one.
#[test]
fn coefficients_do_not_look_at_inputs_that_they_do_not_depend_on() {
    for nothing in [f64::NAN, f64::INFINITY] {
        let expected = [[2.0, 0.0], [0.0, 3.0]];
        assert_eq!(Table::new().coefficients([nothing, nothing]), Ok(expected));
        let narrow = Table::<f32>::default().coefficients([nothing as f32; 2]);
        assert_eq!(narrow, Ok([[2.0, 0.0], [0.0, 3.0]]));
        let error = Err(SolveError::NotFinite { name: "y" });
        assert_eq!(Table::new().position([0.0, nothing]).map(|_| ()), error);
        assert_eq!(Table::new().jacobian([0.0, nothing]).map(|_| ()), error);
    }
}

/// Beyond 170 000 turns (`f32`: 8192) the fast path takes no angle, and a sweep asks for each pose by itself:
/// B is at (0.5 + s) (cos θ, sin θ), its rates those of θ and s in their order. An angle of 2²⁵ has a sine
/// right within an ulp, and some ten roundings follow; the largest number here is 40.
fn slow_poses_are_given_their_inputs_in_order<T: Float>() {
    let (spiral, far, small) = (Spiral::<T>::default(), 33_554_432.0, 1e3 * T::EPSILON);
    let close = |found: T, truth: f64| {
        assert!((found.value() - truth).abs() <= small, "{found:?} {truth}");
    };
    let thetas = [0.0, 2.0, 4.0, 16.0].map(|more| number::<T>(far + 4.0 * more));
    let lengths = [0.25, 0.5, 0.75, 1.0].map(number::<T>);
    let [rates, speeds] =
        [[0.5, -1.0, 1.5, 2.0], [3.0, 4.0, 5.0, 6.0]].map(|of| of.map(number::<T>));
    let (inputs, moving) =
        ([(&thetas).into(), (&lengths).into()], [(&rates).into(), (&speeds).into()]);
    let growing = [number::<T>(7.0).into(), number::<T>(-8.0).into()];
    let mut numbers = [[number::<T>(0.0); 4]; 6];
    let mut status = [[Status::default(); 4]; 3];
    let [x, y, dx, dy, ddx, ddy] = numbers.each_mut();
    let out = SpiralPosition { B: Point { x: &mut x[..], y: &mut y[..] } };
    spiral.sweep_position(inputs, out, &mut status[0], ()).unwrap();
    let out = SpiralVelocity { B: Point { x: &mut dx[..], y: &mut dy[..] } };
    spiral.sweep_velocity(inputs, moving, out, &mut status[1], ()).unwrap();
    let acceleration = SpiralAcceleration { B: Point { x: &mut ddx[..], y: &mut ddy[..] } };
    let out = SpiralMotion { acceleration, ..unwanted() };
    spiral.sweep_motion(inputs, moving, growing, out, &mut status[2], ()).unwrap();
    assert_eq!(status, [[Status::Solved; 4]; 3]);
    for pose in 0..4 {
        let (_, usable) = spiral.solve_position([thetas[pose], lengths[pose]]);
        assert!(!usable, "the fast path takes no such angle");
        let (sin, cos) = thetas[pose].value().sin_cos();
        let [r, omega, speed] = [lengths[pose], rates[pose], speeds[pose]].map(T::value);
        let r = 0.5 + r;
        let (along, across) = (-8.0 - r * omega * omega, 7.0 * r + 2.0 * speed * omega);
        let truths = [[r, 0.0], [speed, r * omega], [along, across]];
        let found = numbers.map(|of| of[pose]);
        for (found, [along, across]) in found.chunks(2).zip(truths) {
            close(found[0], along * cos - across * sin);
            close(found[1], along * sin + across * cos);
        }
    }
}

/// The ram at 0.4 m is beyond its rod, and so is every crank.
fn a_sweep_says_where_there_is_no_solution<T: Float>() {
    let (mut theta, mut status) = ([number::<T>(0.0); 3], [Status::default(); 3]);
    let out = PressPosition { theta: &mut theta[..], ..unwanted() };
    let x = [0.25, 0.4, 0.3].map(number::<T>);
    Press::<T>::default().sweep_position(&x, out, &mut status, ()).unwrap();
    assert_eq!(status, [Status::Solved, Status::NoSolution, Status::Solved]);
    assert!(theta[1].value().is_nan() && theta[0].value().is_finite());
}

/// Each by its own name.
#[test]
fn every_error_has_a_status() {
    let (group, name, by) = ("BC", "lift", 0.5);
    for (error, status) in [
        (SolveError::OutOfReach { group, by }, Status::OutOfReach),
        (SolveError::Singular { group }, Status::Singular),
        (SolveError::Invalid { group, name }, Status::Invalid),
        (SolveError::NotFinite { name }, Status::NotFinite),
        (SolveError::OffCircle { name, amplitude: 0.5 }, Status::OffCircle),
        (
            SolveError::NoSolution { unknown: "theta", by, unit: "m", other: None },
            Status::NoSolution,
        ),
        (SolveError::SeveralDeadPoints { unknown: "theta" }, Status::SeveralDeadPoints),
        (SolveError::Jams { joint: "ram" }, Status::Jams),
    ] {
        assert_eq!(Status::from(error), status);
    }
}

in_both_widths! { slow_poses_are_given_their_inputs_in_order a_sweep_says_where_there_is_no_solution
    compensated_poses_at_their_limit_are_solved_in_sweeps
}

/// Where the square of a distance is out of range, it is made with more care; at zero it is zero.
fn a_distance_may_be_of_any_size<T: Float>(sizes: [f64; 5]) {
    let passing = Passing::<T>::default();
    let x = sizes.map(number::<T>);
    let (mut reach, mut status) = ([number(7.0); 5], [Status::NotFinite; 5]);
    let out = PassingPosition { reach: &mut reach[..], ..unwanted() };
    passing.sweep_position(&x, out, &mut status, ()).unwrap();
    for (at, &x) in x.iter().enumerate() {
        let magnitude = x.value().abs();
        assert_eq!(passing.position(x).unwrap().reach.value(), magnitude, "{x:?}");
        assert_eq!((reach[at].value(), status[at]), (magnitude, Status::Solved), "{x:?}");
    }
}

#[test]
fn distances_may_be_of_any_size() {
    a_distance_may_be_of_any_size::<f64>([0.0, -1.0, 1e-200, -3e-308, 1e200]);
    a_distance_may_be_of_any_size::<f32>([0.0, -1.0, 1e-25, -3e-38, 1e25]);
}

/// Poses about the limits of two dyads: one of a group's by up to 10,000 last places, or anywhere; with bars
/// of zero, negative and no length among them. Every status is the single call's, and numbers are none where it
/// is no `Solved`.
fn statuses_are_the_kinds_of_single_calls<T: Float>(poses: usize) {
    let (mut random, mut counts) = (Random::new(31), [0_usize; 4]);
    for _ in 0..poses / 240 {
        let mut bars = [2.0, 2.5, 1.0].map(|bar| bar * random.between(0.2, 1.4));
        match random.between(0.0, 40.0) as u32 {
            0 => bars[random.between(0.0, 3.0) as usize] = 0.0,
            1 => bars[random.between(0.0, 3.0) as usize] = -1.0,
            2 => bars[random.between(0.0, 3.0) as usize] = f64::NAN,
            _ => {}
        }
        let [l1, l2, l3] = bars.map(number::<T>);
        let dyads = TwoDyads { l1, l2, l3, ..TwoDyads::<T>::default() };
        let place = |random: &mut Random| {
            let anywhere = [random.anywhere(-2.0, 6.0), random.anywhere(-4.0, 4.0)];
            if random.between(0.0, 1.0) < 0.5 {
                return anywhere;
            }
            let limit =
                if random.between(0.0, 1.0) < 0.5 { bars[0] + bars[1] } else { bars[0] - bars[1] };
            let by = 1.0 + random.between(-1e4, 1e4).round() * T::EPSILON;
            let (sin, cos) = random.anywhere(0.0, 6.3).sin_cos();
            [4.0 + limit * by * cos, limit * by * sin]
        };
        let at: Vec<[T; 2]> = (0..240).map(|_| place(&mut random).map(number::<T>)).collect();
        let [x, y] = [0, 1].map(|axis| at.iter().map(|at| at[axis]).collect::<Vec<T>>());
        let (mut ex, mut status) = (vec![number::<T>(7.0); 240], vec![Status::NotFinite; 240]);
        let (mut ey, mut reach) = (ex.clone(), ex.clone());
        let e = Point { x: &mut ex[..], y: &mut ey[..] };
        let out = TwoDyadsPosition { E: e, reach: &mut reach[..], ..unwanted() };
        dyads.sweep_position([Series::from(&x), Series::from(&y)], out, &mut status, ()).unwrap();
        for (nth, &at) in at.iter().enumerate() {
            let single = dyads.position(at).map(|_| ());
            let expected = single.map_or_else(Status::from, |()| Status::Solved);
            let found = status[nth];
            // A rounding of C decides where the second dyad is next to its limit, see `Status`.
            let is_rounding = match single {
                Err(SolveError::OutOfReach { group: "CE, FE", by }) => {
                    found == Status::Solved && by < 1e3 * T::EPSILON
                }
                _ => false,
            };
            assert!(found == expected || is_rounding, "{bars:?} {at:?}: {found:?} {single:?}");
            let is_none = [ex[nth], ey[nth], reach[nth]].map(|number| number.value().is_nan());
            assert_eq!(is_none, [found != Status::Solved; 3], "{bars:?} {at:?}");
            counts[match single {
                Ok(()) => 0,
                Err(SolveError::OutOfReach { group: "BC, DC", .. }) => 1,
                Err(SolveError::OutOfReach { .. }) => 2,
                _ => 3,
            }] += 1;
        }
    }
    assert!(counts.iter().all(|&count| count > poses / 200), "{counts:?}");
}

/// A guide at the end of the range, where a difference of products would overflow if it were made exactly without
/// a fused operation: behind a pose that is out of reach a sweep and a single call say the same.
#[test]
fn a_guide_at_the_end_of_the_range_is_refused_alike() {
    use linkage_tests::mechanisms::driven_groups::{DrivenRrp, DrivenRrpPosition};
    let solver = DrivenRrp::<f32>::default();
    let poses = [[0.0, 2.0, 0.0, 0.0, 0.0], [0.0, -2.8e-13, -3.4e38, 68.3, 3.5e-39]];
    let columns: [Vec<f32>; 5] =
        std::array::from_fn(|input| (0..16).map(|at| poses[at % 2][input]).collect());
    let (mut x, mut y, mut status) = ([0.0; 16], [0.0; 16], [Status::default(); 16]);
    let out = DrivenRrpPosition { C: Point { x: &mut x[..], y: &mut y[..] }, ..unwanted() };
    let given = columns.each_ref().map(|column| Series::from(&column[..]));
    solver.sweep_position(given, out, &mut status, ()).unwrap();
    let single = poses.map(|pose| Status::from(solver.position(pose).unwrap_err()));
    assert_eq!(single, [Status::OutOfReach; 2]);
    for (at, status) in status.iter().enumerate() {
        assert_eq!(*status, single[at % 2]);
        assert!(x[at].is_nan() && y[at].is_nan());
    }
}

/// Compensated values have no spread, and beside them up to four last places beyond a limit count as the limit:
/// behind a pose that is far beyond, which vectors tell, they are left to single calls.
fn compensated_poses_at_their_limit_are_solved_in_sweeps<T: Float>() {
    use linkage_tests::mechanisms::near_limits::{CompensatedRrr, CompensatedRrrPosition};
    let solver = CompensatedRrr::<T> { l1: number(0.625), ..CompensatedRrr::default() };
    let ulp = T::EPSILON;
    let beyond = (-8..=8).map(|ulps| 1.625 + f64::from(ulps) * ulp);
    let within = (-8..=8).map(|ulps| 0.375 + f64::from(ulps) * ulp);
    let dx: Vec<T> = [1.75, 0.25].into_iter().chain(beyond).chain(within).map(number).collect();
    let zero = number::<T>(0.0);
    let mut status = vec![Status::NotFinite; dx.len()];
    let given = [zero.into(), zero.into(), Series::from(&dx), zero.into()];
    let mut y = vec![zero; dx.len()];
    let mut x = y.clone();
    let c = Point { x: &mut x[..], y: &mut y[..] };
    let out = CompensatedRrrPosition { C: c, ..unwanted() };
    solver.sweep_position(given, out, &mut status, ()).unwrap();
    let single = |&dx: &T| {
        let answer = solver.position([zero, zero, dx, zero]);
        answer.map_or_else(Status::from, |_| Status::Solved)
    };
    assert_eq!(status, dx.iter().map(single).collect::<Vec<_>>());
    let solved = status.iter().filter(|status| **status == Status::Solved).count();
    // Each stretch has eight poses within, the limit, and four beyond.
    assert_eq!(solved, 26);
}

/// An ordinary run samples a hundred machines of the five hundred of `.ci/nightly`.
#[test]
fn statuses_about_limits_are_the_kinds_of_single_calls() {
    let poses = cases(24_000, 120_000);
    statuses_are_the_kinds_of_single_calls::<f64>(poses);
    statuses_are_the_kinds_of_single_calls::<f32>(poses);
}

/// `cargo test --release -p linkage-tests --test reach -- --ignored ten_million`
#[test]
#[ignore = "takes a minute"]
fn ten_million_statuses_are_the_kinds_of_single_calls() {
    statuses_are_the_kinds_of_single_calls::<f64>(5_000_000);
    statuses_are_the_kinds_of_single_calls::<f32>(5_000_000);
}
