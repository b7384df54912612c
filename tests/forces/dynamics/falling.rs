//! Free motion over a long time: loops stay closed because positions are solved, not integrated.

use linkage_tests::integration::step;
use linkage_tests::mechanisms::dynamics::{FallingLeg, FallingLegPosition, leg_opening};
use linkage_tests::mechanisms::forces::ShakenFourBar;

fn opening(p: &FallingLegPosition<f64>) -> f64 {
    leg_opening([p.B, p.U, p.L, p.E, p.F, p.foot])
}

fn largest(p: &FallingLegPosition<f64>) -> f64 {
    let points = [p.B, p.U, p.L, p.E, p.F, p.foot];
    points.iter().flat_map(|at| [at.x.abs(), at.y.abs()]).fold(0.38, f64::max)
}

/// Lets the leg move freely, and gives the largest change of its energy over the largest that moved.
fn drift(mut state: [f64; 2], seconds: f64, steps_a_second: f64) -> f64 {
    let leg = FallingLeg::new();
    let rates = |state: [f64; 2]| leg.state_rates(state, 0.0);
    let energy = |[q, dq]: [f64; 2]| {
        let e = leg.energy(q, dq).expect("every pose is there");
        (e.kinetic, e.kinetic + e.potential)
    };
    let (_, start) = energy(state);
    let (mut moving, mut drift) = (0.0_f64, 0.0_f64);
    for count in 1..=(seconds * steps_a_second) as u32 {
        state = step(rates, state, 1.0 / steps_a_second).expect("every pose is there");
        assert!(state.iter().all(|x| x.is_finite()), "{state:?} after {count} steps");
        let p = leg.position(state[0]).expect("every pose is there");
        let ulp = f64::EPSILON * largest(&p).log2().floor().exp2();
        assert!(opening(&p) <= 8.0 * ulp, "{} ulp after {count} steps", opening(&p) / ulp);
        let (kinetic, total) = energy(state);
        moving = moving.max(kinetic);
        drift = drift.max((total - start).abs());
    }
    assert!(moving > 1.0, "it falls: {moving} J");
    drift / moving
}

#[test]
fn a_leg_that_falls_for_a_minute_keeps_its_loops_closed_and_its_energy() {
    // From rest it swings; pushed, it turns.
    let (swinging, turning) = (drift([0.4, 0.0], 60.0, 250.0), drift([0.4, 25.0], 10.0, 1000.0));
    println!("energy: {swinging:.1e} in a minute, {turning:.1e} in ten seconds");
    assert!(swinging < 1e-6 && turning < 1e-6, "{swinging} {turning}");
    // The method is of fourth order over a given time: half the step leaves a sixteenth of the drift.
    let [coarse, fine] = [125.0, 250.0].map(|steps| drift([0.4, 0.0], 4.0, steps));
    assert!((10.0..40.0).contains(&(coarse / fine)), "{coarse} {fine}");
}

#[test]
fn what_swings_keeps_its_energy() {
    // Two thousand steps of the fifth order.
    let four_bar = ShakenFourBar::new();
    let total = |[q, dq]: [f64; 2]| {
        let e = four_bar.energy(q, dq).unwrap();
        e.kinetic + e.potential
    };
    let mut state = [1.0, 14.0];
    let start = total(state);
    for _ in 0..2000 {
        state = step(|state| four_bar.state_rates(state, 0.0), state, 1e-3).unwrap();
    }
    assert!((total(state) - start).abs() < 1e-6 * start.abs(), "{} {start}", total(state));
}
