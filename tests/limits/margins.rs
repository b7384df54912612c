//! Margins and transmission angles: signed metres with slope one at every limit, there also where
//! the pose is not, smooth, with rates, and free for those who do not ask.

use core::f64::consts::{FRAC_PI_2, PI};

use linkage_core::{Real, SolveError};
use linkage_tests::in_both_widths;
use linkage_tests::mechanisms::margins::*;
use linkage_tests::widths::{list, number};

/// `margin` as a function of what is left to the limit, negative beyond it: slope one there, and
/// the sign of what is left everywhere on the way. `curvature` bounds the second derivative; the
/// margin is made of numbers of the order of one, in some ten roundings.
fn assert_signed_distance<T: Real>(curvature: f64, margin: impl Fn(f64) -> f64) {
    let rounding = 10.0 * T::EPSILON;
    for exponent in 1..=15 {
        for sign in [1.0, -1.0] {
            let left = sign * 10.0_f64.powi(-exponent);
            let found = margin(left);
            let error = (found - left).abs();
            assert!(error <= curvature * left * left + rounding, "{found:e} for {left:e}");
            // The data lose less than eight of their last places of the distance.
            assert!(left.abs() < 10.0 * T::EPSILON || found * left > 0.0, "{found:e} for {left:e}");
        }
    }
    assert!(margin(0.0).abs() <= rounding);
}

/// Bars 3 and 2 along (0.6, 0.8) from (0.5, −0.25), `d` apart.
fn rrr_margin<T: Real>(d: f64) -> f64 {
    let q = list::<T, 4>([0.5, -0.25, 0.5 + 0.6 * d, -0.25 + 0.8 * d]);
    MarginRrr::default().margins(q).unwrap().DC_margin.value()
}

fn bars<T: Real>() {
    // sin² μ · 3/d, twice differentiated at d = 5 and d = 1, is below 1.3.
    assert_signed_distance::<T>(1.3, |left| rrr_margin::<T>(5.0 - left));
    assert_signed_distance::<T>(1.3, |left| rrr_margin::<T>(1.0 + left));
}

fn bar_and_guide<T: Real>() {
    let group = MarginRrp::<T>::default();
    let (l, e, turn) = (2.0, 0.3, 0.4_f64);
    for side in [1.0, -1.0] {
        assert_signed_distance::<T>(0.3, |left| {
            // e − y = ± (l − left), 1.25 along the guide.
            let (x, y) = (1.25, e - side * (l - left));
            let (sin, cos) = turn.sin_cos();
            let q = [0.5 + x * cos - y * sin, -0.2 + x * sin + y * cos, turn];
            group.margins(list(q)).unwrap().block_margin.value()
        });
    }
}

fn block_and_bar<T: Real>() {
    let group = MarginRpr::<T>::default();
    assert_signed_distance::<T>(0.01, |left| {
        let b = 0.7 + left;
        let q = [0.25 + 0.6 * b, 0.5 - 0.8 * b, 0.25, 0.5];
        group.margins(list(q)).unwrap().bar_margin.value()
    });
    let centric = MarginCentricRpr::<T>::default();
    let margin = centric.margins(list([0.2 + 0.3, 0.1 - 0.4])).unwrap();
    assert!((margin.bar_margin.value() - 0.5).abs() <= 2.0 * T::EPSILON);
    assert_eq!(margin.bar_transmission.value(), T::num(FRAC_PI_2).value());
}

/// The angle between the bars at their pin, between bar and guide's normal, between the bar's normal and the line to B,
/// between two guides; 0 or π out of reach. It is compared with the arc cosine of two directions, whose rounding a sine
/// divides.
fn transmission<T: Real>() {
    let close = |found: T, cosine: f64| {
        let cosine = cosine.clamp(-1.0, 1.0);
        let (found, sine) = (found.value(), (1.0 - cosine * cosine).sqrt());
        let allowed = 8.0 * T::EPSILON / sine.max(1e-3) + 4.0 * T::EPSILON;
        assert!((found - cosine.acos()).abs() <= allowed, "{found} {}", cosine.acos());
        found
    };
    let dot = |x: T, y: T, u: T, v: T| x.value() * u.value() + y.value() * v.value();
    let group = MarginRrr::<T>::default();
    let mut last = 0.0;
    for d in [1.0 + 1e-4, 1.25, 2.0, 3.0, 4.0, 4.75, 5.0 - 1e-4] {
        let p = group.position(list([0.5, -0.25, 0.5 + d, -0.25])).unwrap();
        let (a, b) = (p.BC, p.DC);
        // It grows from the folded bars to the stretched ones.
        let angle = close(p.DC_transmission, dot(a.cos, a.sin, b.cos, b.sin));
        assert!(angle > last, "{d}");
        last = angle;
    }
    assert!(last > 3.1);
    for (d, at) in [(0.5, 0.0), (5.5, PI)] {
        let beyond = group.margins(list([0.0, 0.0, d, 0.0])).unwrap();
        assert!(beyond.DC_margin.value() < -0.4);
        assert_eq!(beyond.DC_transmission.value(), T::num(at).value());
        let pose = group.position(list([0.0, 0.0, d, 0.0]));
        assert!(matches!(pose, Err(SolveError::OutOfReach { group: "BC, DC", .. })));
    }
    // B below the guide, and above it: the bar leans to either side of the normal.
    for (y, is_blunt) in [(-0.5, false), (1.5, true)] {
        let p = MarginRrp::<T>::default().position(list([0.75, y, 0.4])).unwrap();
        let angle = close(p.block_transmission, dot(p.BC.cos, p.BC.sin, -p.block.sin, p.block.cos));
        assert_eq!(angle > FRAC_PI_2, is_blunt);
    }
    for (e, is_blunt) in [(0.7, false), (-0.7, true)] {
        let group = MarginRpr { e: T::num(e) };
        let p = group.position(list([1.25, 0.5, 0.25, 0.5])).unwrap();
        let angle = close(p.bar_transmission, -p.bar.sin.value());
        assert_eq!(angle > FRAC_PI_2, is_blunt);
    }
    let p = TransmissionPrp::<T>::default().position(list([0.3, 2.4])).unwrap();
    close(p.q_transmission, (2.1_f64).cos());
    for slot in [-0.5_f64, 1.75] {
        let p = TransmissionRpp::<T>::default().position(number(slot)).unwrap();
        close(p.yoke_transmission, number::<T>(slot).value().cos());
    }
}

fn moved<const N: usize>(q: [f64; N], rate: [f64; N], t: f64) -> [f64; N] {
    core::array::from_fn(|i| q[i] + t * rate[i])
}

/// Rates against central differences over h: h²/6 of a third derivative below 100, and two
/// roundings of numbers of the order of one over 2 h or h².
macro_rules! assert_rates {
    ($group:expr, $q:expr, $rate:expr, $margin:ident, $transmission:ident) => {{
        let (group, h) = ($group, 1e-4);
        let zero = $rate.map(|_| 0.0);
        let at = |t: f64| moved($q, $rate, t);
        let m = group.motion($q, $rate, zero).unwrap();
        let pose = |t: f64| group.position(at(t)).unwrap();
        let (a, b, c) = (pose(-h), pose(0.0), pose(h));
        let (v, w) = (m.velocity, m.acceleration);
        let first = (c.$margin - a.$margin) / (2.0 * h);
        let second = (c.$margin - 2.0 * b.$margin + a.$margin) / (h * h);
        assert!((v.$margin - first).abs() <= 1e-6, "{} {first}", v.$margin);
        assert!((w.$margin - second).abs() <= 1e-5, "{} {second}", w.$margin);
        let first = (c.$transmission - a.$transmission) / (2.0 * h);
        let second = (c.$transmission - 2.0 * b.$transmission + a.$transmission) / (h * h);
        assert!((v.$transmission - first).abs() <= 1e-6, "{} {first}", v.$transmission);
        assert!((w.$transmission - second).abs() <= 1e-5, "{} {second}", w.$transmission);
    }};
}

#[test]
fn margins_have_rates() {
    let (q, rate) = ([0.5, -0.25, 3.5, 1.0], [0.3, -0.4, 0.5, 0.2]);
    assert_rates!(MarginRrr::new(), q, rate, DC_margin, DC_transmission);
    let (q, rate) = ([0.75, 0.5, 0.4], [0.3, -0.4, 0.5]);
    assert_rates!(MarginRrp::new(), q, rate, block_margin, block_transmission);
    let (q, rate) = ([1.0, 0.5, 0.25, -0.5], [0.3, -0.4, 0.5, 0.2]);
    assert_rates!(MarginRpr::new(), q, rate, bar_margin, bar_transmission);
}

#[test]
fn margins_are_free_for_those_who_do_not_ask() {
    let (watched, without) = (WatchedFourBar::COST, UnwatchedFourBar::COST);
    assert!(watched.position.total() > without.position.total());
    // A crank and a group: what the budgets of the group and the crank add up to.
    assert!(without.position.total() <= 40, "{}", without.position);
    let theta = 0.7;
    let (a, b) = (WatchedFourBar::new().position(theta), UnwatchedFourBar::new().position(theta));
    assert_eq!(a.unwrap().C, b.unwrap().C);
}

in_both_widths! { bars bar_and_guide block_and_bar transmission }
