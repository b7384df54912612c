//! Groups that are solved by all their unknowns at once: in both widths, by dual numbers, and beyond their ends.

use linkage_core::find::{OutputError, Search, Trend};
use linkage_core::range::{Stop, limits};
use linkage_core::{Lanes, Point, SolveError, Status, Tracker, mechanism, unwanted};
use linkage_tests::random::cases;
use num_dual::{Dual2_64, Dual64};

include!("../../linkage-macros/command/tests/data/gripper.rs");

/// The way of the cylinder out of the drawing, and the places of S, X and D there in millimetres, by Newton's method in
/// another program.
const RIGHT: [[f64; 7]; 4] = [
    [0.5, 148.739291, 39.324834, 148.397944, -26.407577, 29.147207, -0.066206],
    [1.0, 148.879788, 39.071359, 148.366003, -27.095933, 29.364394, -2.547499],
    [2.0, 149.165302, 57.78403, 148.629141, -11.615846, 30.952455, 10.712523],
    [4.0, 149.17747, 73.281595, 148.684102, 2.264195, 31.37037, 23.618006],
];

const DRAWN: f64 = Gripper::DRAWN[0];
/// The way out that was followed, to 0.2 % of it.
const WHOLE: f64 = 0.158;

#[test]
fn a_gripper_is_right_to_the_last_printed_digit() {
    for [out, sx, sy, xx, xy, dx, dy] in RIGHT {
        let found = Gripper::new().position(DRAWN + out * 1e-3).expect("it is on its way");
        let off = [
            (found.S.x, sx),
            (found.S.y, sy),
            (found.X.x, xx),
            (found.X.y, xy),
            (found.D.x, dx),
            (found.D.y, dy),
        ];
        for (found, right) in off {
            // Half a unit of the last digit.
            assert!((found * 1e3 - right).abs() < 0.51e-6, "{found} for {right} at {out} mm");
        }
    }
}

/// In steps of a thousandth of the way. The rates are those of the fourth step on dual numbers, whose first and second
/// derivatives miss what three and two steps leave; the certificate bounds that by 1e-14 and 1e-7, and most starts are
/// nearer. Rates are up to 3 and accelerations up to 1e5 per metre.
#[test]
fn rates_are_the_derivatives() {
    let (plain, first, second) =
        (Gripper::new(), Gripper::<Dual64>::default(), Gripper::<Dual2_64>::default());
    for part in 1..1000 {
        let s = DRAWN + WHOLE * f64::from(part) / 1000.0;
        let moved = plain.motion(s, 1.0, 0.0).expect("it is on its way");
        let once = first.position(Dual64::new(s, 1.0)).expect("it is on its way").S;
        let twice = second.position(Dual2_64::new(s, 1.0, 0.0)).expect("it is on its way").S;
        let (rate, accel) = (moved.velocity.S, moved.acceleration.S);
        let (most, most_accel) = (1.0 + rate.x.hypot(rate.y), 1.0 + accel.x.hypot(accel.y));
        let off = (once.x.eps - rate.x).hypot(once.y.eps - rate.y);
        assert!(off < 1e-11 * most, "{off:e} of {most} at {s}");
        let off = (twice.x.v2 - accel.x).hypot(twice.y.v2 - accel.y);
        assert!(off < 1e-7 * most_accel, "{off:e} of {most_accel} at {s}");
    }
}

/// In single precision the last place of the largest coordinate is 1.5e-8 m, and the slopes of the equations magnify some of
/// these at most a thousand times, but next to the end.
#[test]
fn single_precision_is_certified_by_its_own_numbers() {
    let (wide, narrow) = (Gripper::new(), Gripper::<f32>::default());
    let (mut answered, mut most) = (0, 0.0_f64);
    for part in 0..10_000 {
        let s = (DRAWN + WHOLE * f64::from(part) / 10_000.0) as f32;
        let Ok(found) = narrow.position(s) else { continue };
        let right = wide.position(f64::from(s)).expect("it is certified in double precision").S;
        let off = (f64::from(found.S.x) - right.x).hypot(f64::from(found.S.y) - right.y);
        (answered, most) = (answered + 1, most.max(off));
    }
    println!("{answered} of 10000, off by {most:e}");
    assert!(answered > 9_500 && most < 2e-5, "{answered} {most:e}");
}

#[test]
fn beyond_its_way_a_gripper_is_not_certified() {
    let group = "AB, CD, plate, GM, HQ, upper, IT, JV, lower, block_M, block_Q, block_T, block_V";
    for beyond in [-1.0, -1e-5, 0.16, 1.0] {
        let refused = Gripper::new().position(DRAWN + beyond);
        assert_eq!(
            refused.map(|found| found.S),
            Err(SolveError::NotCertified { group }),
            "{beyond}"
        );
    }
    assert_eq!(Status::from(SolveError::NotCertified { group }), Status::NotCertified);
    let found = limits(&Gripper::new(), [DRAWN - 0.01, DRAWN + 0.3]).expect("an interval");
    let [way] = &found[..] else { panic!("{found:?}") };
    assert_eq!([way.from.stop, way.to.stop], [Stop::Limit { group }; 2]);
    // The drawing is 0.006 mm from the end.
    assert!((way.from.at - DRAWN + 6e-6).abs() < 1e-6, "{way:?}");
    assert!(way.to.at - DRAWN > WHOLE, "{way:?}");
    for at in [way.from.at, way.to.at] {
        assert!(Gripper::new().position(at).is_ok(), "{at}");
    }
}

/// From a millimetre in front of the way to one behind it.
fn ways<const N: usize>() -> [f64; N] {
    core::array::from_fn(|part| DRAWN - 1e-3 + (WHOLE + 3e-3) * part as f64 / (N - 1) as f64)
}

/// No number and none that a machine could have.
const NONE: [f64; 6] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, f64::MAX, -f64::MAX, 1e200];

/// A plain lane has the bits of a single call without fused products, a tracker those of the call; a sweep may fuse
/// products, whose roots are some units in the last place of the largest coordinate away, times the slopes of the equations.
/// Without optimisation the numbers of lanes need more than the 2 MB of a test's thread.
#[test]
fn sweeps_lanes_and_trackers_answer_as_single_calls() {
    let thread = std::thread::Builder::new().stack_size(16 << 20);
    let asked = thread.spawn(asked_in_every_way).expect("it starts").join();
    asked.unwrap_or_else(|panic| std::panic::resume_unwind(panic));
}

fn asked_in_every_way() {
    let machine = Gripper::new();
    let mut tracker = Tracker::new(machine);
    let given: Vec<f64> = ways::<1002>().into_iter().chain(NONE).collect();
    let (mut x, mut y) = (vec![0.0; given.len()], vec![0.0; given.len()]);
    let mut status = vec![Status::default(); given.len()];
    let out = GripperPosition { S: Point { x: &mut x[..], y: &mut y[..] }, ..unwanted() };
    machine.sweep_position(&given, out, &mut status, ()).expect("slices of one length");
    let mut solved = 0;
    for (four, index) in given.chunks_exact(4).zip((0..).step_by(4)) {
        let four = Lanes::new([four[0], four[1], four[2], four[3]]);
        let (lanes, mask) = Gripper::<Lanes<f64, 4>>::default().solve_position(four);
        let (lane_x, mask) = (lanes.S.x.to_array(), mask.to_array());
        for lane in 0..4 {
            let (index, at) = (index + lane, given[index + lane]);
            let single = machine.position(at);
            assert_eq!(single.is_ok(), mask[lane], "{at}");
            assert_eq!(status[index], single.map_or_else(Status::from, |_| Status::Solved), "{at}");
            assert_eq!(tracker.position(at).is_ok(), single.is_ok(), "{at}");
            let Ok(single) = single else {
                assert!(x[index].is_nan() && y[index].is_nan(), "{at}");
                continue;
            };
            let followed = tracker.position(at).expect("it was answered before");
            assert_eq!(followed.S, single.S, "{at}");
            let off = [x[index] - single.S.x, y[index] - single.S.y, lane_x[lane] - single.S.x];
            assert!(off.iter().all(|off| off.abs() < 1e-12), "{off:?} at {at}");
            solved += 1;
        }
    }
    // All but the millimetre in front of the way and what is behind it.
    assert!(solved > 970, "{solved}");
}

/// Between a fifth less and a fifth more of the way out the height rises or falls.
#[test]
fn the_way_out_is_found_by_the_height_of_a_jaw() {
    let machine = Gripper::new();
    for out in [2e-3, 10e-3, 30e-3, 70e-3] {
        let at = machine.motion(DRAWN + out, 1.0, 0.0).expect("it is on its way");
        let (wanted, slope) = (at.position.S.y, at.velocity.S.y);
        let trend = if slope > 0.0 { Trend::Rising } else { Trend::Falling };
        let between = [DRAWN + 0.8 * out, DRAWN + 1.2 * out];
        let found = Search::new(between, trend).find_output(&machine, "S.y", wanted);
        let off = found.expect("it is between").at - (DRAWN + out);
        // Rounding of the height over its slope.
        assert!(off.abs() < 1e-13 * (1.0 + 1.0 / slope.abs()), "{off:e} at {out}");
    }
    let beyond = Search::new([DRAWN + 0.1, DRAWN + 0.2], Trend::Rising);
    let refused = beyond.find_output(&machine, "S.y", 0.0);
    assert!(
        matches!(refused, Err(OutputError::Solve(SolveError::NotCertified { .. }))),
        "{refused:?}"
    );
}

/// Beside no numbers, whatever bits an input and a rate have: an answer has numbers alone.
#[test]
fn what_is_no_number_is_an_error() {
    fn answers(s: f64, rate: f64) -> [Result<Vec<f64>, SolveError>; 3] {
        let machine = Gripper::new();
        let narrow = Gripper::<f32>::default();
        let parts = |at: [Point<f64>; 3]| at.iter().flat_map(|at| [at.x, at.y]).collect();
        let wide = |at: Point<f32>| Point { x: f64::from(at.x), y: f64::from(at.y) };
        [
            machine.position(s).map(|at| parts([at.S, at.X, at.D])),
            machine
                .motion(s, rate, rate)
                .map(|at| parts([at.position.S, at.velocity.S, at.acceleration.S])),
            narrow
                .motion(s as f32, rate as f32, rate as f32)
                .map(|at| parts([at.position.S, at.velocity.S, at.acceleration.S].map(wide))),
        ]
    }
    for none in NONE {
        assert!(answers(none, 1.0).iter().all(Result::is_err), "{none}");
    }
    for none in &NONE[..3] {
        let [at, moved, narrow] = answers(DRAWN + 1e-3, *none);
        assert!(at.is_ok());
        for refused in [moved, narrow] {
            assert!(matches!(refused, Err(SolveError::NotFinite { .. })), "{refused:?} at {none}");
        }
    }
    // Marsaglia's xorshift.
    let mut bits = 0x9e37_79b9_7f4a_7c15_u64;
    let mut random = || {
        bits ^= bits << 13;
        bits ^= bits >> 7;
        bits ^= bits << 17;
        bits
    };
    let mut answered = 0;
    let cases = cases(2_500, 20_000);
    for _ in 0..cases {
        let s = match random() % 2 {
            0 => f64::from_bits(random()),
            _ => DRAWN + WHOLE * (random() >> 11) as f64 / 2_f64.powi(53),
        };
        for answer in answers(s, f64::from_bits(random())).into_iter().flatten() {
            assert!(answer.iter().all(|part| part.is_finite()), "{answer:?} at {s}");
            answered += 1;
        }
    }
    assert!(answered > cases / 2, "{answered}");
}

/// Within some units in the last place of an end of the way an answer is that of the way, or there is none.
#[test]
fn next_to_an_end_what_is_answered_is_the_way() {
    let machine = Gripper::new();
    let found = limits(&machine, [DRAWN - 0.01, DRAWN + 0.3]).expect("an interval");
    for (end, inwards) in [(found[0].from.at, 1e-12), (found[0].to.at, -1e-12)] {
        let inside = machine.motion(end + inwards, 1.0, 0.0).expect("it is inside");
        let mut at = end;
        (0..20).for_each(|_| at = at.next_down());
        for _ in 0..40 {
            at = at.next_up();
            let Ok(next) = machine.position(at) else { continue };
            let ahead = at - end - inwards;
            let along = inside.position.S.x + inside.velocity.S.x * ahead;
            // The end is 1e-8 m or more from a dead point, where S moves 1e4 times as fast as the cylinder and another way to
            // assemble it is 1e-4 m away: rounding of 1e-17 m, and the second order of 1e-12 m, are below this.
            let off = (next.S.x - along).abs();
            assert!(off < 1e-10, "{off:e} at {at}");
        }
    }
}

mechanism! {
    /// Six links of an eight-bar behind a crank that turns fully: no two make a dyad, and no single unknown solves them.
    pub struct EightBar {
        input theta: angle;
        ground P26(0.885, 0.043), P67(0.743, 0.312);
        pin P01(0.102, 0.069), P02(0.935, 0.827), P13(0.6, 0.124), P04(0.09, 0.631), P34(0.207, 0.988), P15(0.884, 0.368),
            P25(0.535, 0.864), P37(0.703, 0.282);
        link L0(P01, P02, P04), L1(P01, P13, P15), L2(P02, P25, P26), L3(P13, P34, P37);
        link L4(P04, P34), L5(P15, P25), L7(P37, P67);
        drive L7.angle = theta;
    }
}

/// Every bar is as long as drawn, whatever the turn. Newton's fourth step ends at the rounding of places of about one, times
/// the slopes of the equations' inverse.
#[test]
fn a_crank_turns_a_group_of_several_unknowns_fully() {
    let machine = EightBar::new();
    let lengths = |theta: f64| {
        let at = machine.position(theta).unwrap_or_else(|refused| panic!("{refused} at {theta}"));
        let apart = |p: Point<f64>, q: Point<f64>| (p.x - q.x).hypot(p.y - q.y);
        [
            apart(at.P01, at.P02),
            apart(at.P02, at.P04),
            apart(at.P01, at.P04),
            apart(at.P01, at.P13),
            apart(at.P13, at.P15),
            apart(at.P01, at.P15),
            apart(at.P02, at.P25),
            apart(at.P13, at.P34),
            apart(at.P34, at.P37),
            apart(at.P13, at.P37),
            apart(at.P04, at.P34),
            apart(at.P15, at.P25),
        ]
    };
    let drawn = lengths(EightBar::DRAWN[0]);
    for part in 0..4_000 {
        let theta = f64::from(part - 2_000) * 0.01;
        for (drawn, now) in drawn.iter().zip(lengths(theta)) {
            assert!((drawn - now).abs() < 1e-13, "{now} for {drawn} at {theta}");
        }
        let [here, ahead] = [theta, theta + 1e-3].map(|at| machine.position(at).expect("a pose"));
        // It moves on without a jump: no pin is faster than ten times the crank's.
        let moved = (ahead.P25.x - here.P25.x).hypot(ahead.P25.y - here.P25.y);
        assert!(moved < 10.0 * 0.05 * 1e-3, "{moved} at {theta}");
    }
}
