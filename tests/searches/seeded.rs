//! Sweeps whose searches begin where the pose before was found, against single calls: in order, by jumps, with
//! poses that have no root or no number between the others, in both widths. An ordinary run samples the places of
//! `.ci/nightly`.

use linkage_core::find::Trend;
use linkage_core::{Status, mechanism};
use linkage_tests::mechanisms::unknowns::{InLine, InLineMotion, Wishbone, WishboneMotion};
use linkage_tests::random::{Random, cases};

mechanism! {
    /// An equation with several roots of each trend.
    struct Rippled {
        input x: length;
        param way: mode = rising;
        ground A(0, 0);
        unknown theta: angle between (-2rad, 3rad);
        crank AB(A) -> B { length: 1m, angle: theta }
        solve theta { sin(3 * theta) + theta / 8 = x / 1m, mode: way }
        output theta, B;
    }
}

mechanism! {
    /// Two unknowns: what the first one moves, the second one is searched by at every pose from both ends.
    struct Chained {
        input x, h: length;
        ground A(0, 0);
        guide bed through (0, 0) along 0deg;
        guide post through (0, 0) along 90deg;
        unknown theta: angle between (5deg, 175deg);
        crank AB(A) -> B           { length: 80mm, angle: theta }
        rrp   BC(B), ram(bed) -> C { length: 250mm, mode: ahead }
        solve theta { x = ram.slide, mode: rising }
        unknown phi: angle between (-60deg, 60deg);
        crank CE(C) -> E { length: 300mm, angle: phi }
        solve phi { E.y = h + B.y / 10, mode: rising }
        output theta, phi, E;
    }
}

/// The distance of two numbers; zero if both are the same or both are NaN.
fn apart(a: f64, b: f64) -> f64 {
    if a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan() { 0.0 } else { (a - b).abs() }
}

/// Places from `low` to `high`, in order and then at random. Some are NaN, infinite or beyond the ends.
fn places(count: usize, low: f64, high: f64, seed: u64) -> Vec<f64> {
    let (mut random, count) = (Random::new(seed), count as u32);
    let step = (high - low) / f64::from(count);
    let rising = (0..count).map(|i| low + step * f64::from(i));
    let mut all: Vec<f64> = rising.collect();
    all.extend((0..count).map(|_| random.anywhere(low, high)));
    for nth in (0..all.len()).step_by(97) {
        all[nth] = [f64::NAN, f64::INFINITY, high + 1.0, -1e300][nth / 97 % 4];
    }
    all
}

/// Sweeps motions and asks single calls for the same; gives the statuses met, and the largest difference of
/// the first number over `allowed`, given the rate of it.
macro_rules! compared {
    ($solver:expr, $record:ident, $numbers:literal, $T:ty, $places:expr, $allowed:expr) => {{
        let solver = $solver;
        let places: Vec<$T> = $places.into_iter().map(|x| x as $T).collect();
        let count = places.len();
        let mut columns: [Vec<$T>; $numbers] = std::array::from_fn(|_| vec![0.0; count]);
        let mut status = vec![Status::Invalid; count];
        let out =
            linkage_core::Record::from_array(columns.each_mut().map(|column| &mut column[..]));
        solver
            .sweep_motion(&places, 0.5, 0.25, out, &mut status, ())
            .expect("slices of one length");
        let (mut met, mut worst, mut same) = (std::collections::BTreeMap::new(), 0.0_f64, 0);
        for (nth, &x) in places.iter().enumerate() {
            let single: Result<$record<$T>, _> = solver.motion(x, 0.5, 0.25);
            let expected = single.map_or_else(Status::from, |_| Status::Solved);
            assert_eq!(status[nth], expected, "{x} {single:?}");
            *met.entry(format!("{expected:?}")).or_insert(0) += 1;
            let Ok(single) = single else {
                assert!(columns.iter().all(|column| column[nth].is_nan()));
                continue;
            };
            let rate = f64::from(single.velocity.theta) / 0.5;
            let off = apart(single.position.theta.into(), columns[0][nth].into());
            same += usize::from(off == 0.0);
            worst = worst.max(off / $allowed(rate.abs()));
        }
        println!("{met:?} {worst:.2} of what is allowed, {same} the same");
        (met, worst, same)
    }};
}

/// The ram of an in-line press, beyond both ends of its stroke: Newton's steps from the root before.
#[test]
fn a_press_is_swept_as_it_is_solved() {
    // Each of both roots is off by ε/2 of the larger end, and by the rounding of the sides, 4 ε of them,
    // over the slope.
    let allowed = |epsilon: f64| {
        move |rate: f64| epsilon * core::f64::consts::PI + 2.0 * 4.0 * epsilon * 0.66 * rate
    };
    let count = cases(3000, 20_000);
    let places = || places(count, 0.165, 0.335, 1);
    let wide = compared!(InLine::new(), InLineMotion, 9, f64, places(), allowed(f64::EPSILON));
    let narrow = compared!(
        InLine::<f32>::default(),
        InLineMotion,
        9,
        f32,
        places(),
        allowed(f32::EPSILON.into())
    );
    for (met, worst, same) in [wide, narrow] {
        assert!(met["Solved"] > count * 9 / 5 && met["NoSolution"] > count / 20);
        assert!(met["NotFinite"] > count / 200);
        assert!(worst <= 1.0, "{worst}");
        // Some roots come from their neighbours: otherwise nothing is compared here.
        assert!(same < met["Solved"]);
    }
}

/// Where nothing is proved of the roots, ends are remembered: every bit is that of a single call.
#[test]
fn remembered_ends_change_no_bit() {
    let bits = |_| f64::MIN_POSITIVE;
    let count = cases(700, 4000);
    let heights = || places(count, -0.4, 0.4, 2);
    let softer = Wishbone { upper_length: 0.285 };
    let narrow = Wishbone { upper_length: 0.285_f32 };
    let wide = compared!(softer, WishboneMotion, 13, f64, heights(), bits);
    let narrow = compared!(narrow, WishboneMotion, 13, f32, heights(), bits);
    for (met, worst, same) in [wide, narrow] {
        assert!(met["Solved"] > count / 4 && met["NoSolution"] > count / 4);
        assert!(worst == 0.0 && same == met["Solved"]);
    }
    for way in [Trend::Rising, Trend::Falling] {
        let rippled = Rippled { way, ..Rippled::new() };
        let found = compared!(rippled, RippledMotion, 9, f64, places(count, -1.6, 1.6, 3), bits);
        assert!(
            found.0["Solved"] > count * 5 / 4 && found.1 == 0.0 && found.2 == found.0["Solved"]
        );
    }
}

/// The second search is given what the first one has found, and nothing of it stays.
#[test]
fn unknowns_are_searched_one_after_the_other() {
    let (mut random, count) = (Random::new(4), cases(1000, 5000));
    let mut column = |low: f64, high: f64| -> Vec<f64> {
        (0..count).map(|_| random.anywhere(low, high)).collect()
    };
    let (x, h) = (column(0.17, 0.33), column(-0.25, 0.25));
    let mut columns: [Vec<f64>; 4] = std::array::from_fn(|_| vec![0.0; x.len()]);
    let mut status = vec![Status::Invalid; x.len()];
    let out = linkage_core::Record::from_array(columns.each_mut().map(|column| &mut column[..]));
    let input = ChainedInput { x: (&x).into(), h: (&h).into() };
    Chained::new().sweep_position(input, out, &mut status, ()).expect("slices of one length");
    let mut solved = 0;
    for nth in 0..x.len() {
        let single = Chained::new().position([x[nth], h[nth]]);
        assert_eq!(status[nth], single.map_or_else(Status::from, |_| Status::Solved));
        let Ok(single) = single else { continue };
        solved += 1;
        assert!((columns[0][nth] - single.theta).abs() < 1e-13);
        assert!((columns[1][nth] - single.phi).abs() < 1e-13);
    }
    assert!(solved > count * 4 / 5, "{solved}");
}
