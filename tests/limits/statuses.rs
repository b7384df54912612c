//! What an answer says of itself: a sweep beside the single call, margins behind a group that cannot
//! be assembled, inputs that nothing depends on.

#![allow(clippy::needless_update, reason = "a mechanism may have one parameter or several")]

use linkage_core::{Slide, SolveError, Status};
use linkage_tests::mechanisms::statuses::*;

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

/// The group in front has no pose, so what is behind it has no joints to measure between. How far
/// the one in front is beyond its limit is in the error, and in its margin where that alone is asked.
#[test]
fn margins_behind_a_group_without_a_pose_are_refused_with_its_own() {
    let (both, front) = (WatchedChain::new(), WatchedFront::new());
    let within = both.margins(1.0).unwrap();
    assert!(within.DC_margin > 0.0 && within.CE_margin > 0.0);
    assert_eq!(front.margins(1.0).unwrap().DC_margin, within.DC_margin);
    for beyond in [1e-9, 1e-6, 1e-3] {
        // |BD| is 2.8 m at half a turn.
        let coupler = 1.4 - beyond;
        let theta = core::f64::consts::PI;
        let answer = WatchedChain { coupler, ..both }.margins(theta);
        let Err(SolveError::OutOfReach { group: "BC, DC", by }) = answer.map(|_| ()) else {
            panic!("{answer:?}");
        };
        assert!((by - beyond).abs() <= 1e-15, "{by:e}");
        let margin = WatchedFront { coupler, ..front }.margins(theta).unwrap().DC_margin;
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
