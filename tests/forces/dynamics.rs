//! From forces to motion: equations that agree with the efforts they come from, closed forms, and
//! energy.

mod agreement;
mod falling;
mod frequencies;
mod refused;
mod singular;
mod sweeps;
mod told;

use linkage_tests::mechanisms::forces::TwoParallelograms;

#[test]
fn parallelograms_fall_like_one_pendulum() {
    let machine = TwoParallelograms::new();
    for step in 0..60 {
        let (q, dq) = (0.2 * f64::from(step), 1.5);
        let expected = -7.0 / 6.0 * 9.81 * q.cos();
        let found = machine.forward_dynamics(q, dq, 0.0).unwrap();
        assert!((found - expected).abs() < 4e-15, "{q}: {found} {expected}");
    }
    // (drive − 34.335 cos q)/3
    let cost = TwoParallelograms::COST.forward_dynamics;
    assert!(cost.total() <= 4 && cost.roots == 0 && cost.sines == 1, "{cost}");
}
