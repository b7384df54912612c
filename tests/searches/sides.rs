//! The trend of an equation is that of its left side less its right one, whichever of them is a distance.

use linkage_core::Real;
use linkage_tests::in_both_widths;
use linkage_tests::mechanisms::sides::{DistanceOnTheLeft, DistanceOnTheRight};
use linkage_tests::widths::number;

/// d² = 1 + 0.4² − 0.8 cos θ grows on both sides of θ = 0: d rises on the one and falls on the other.
fn a_distance_on_either_side<T: Real>() {
    let (left, right) = (DistanceOnTheLeft::<T>::default(), DistanceOnTheRight::<T>::default());
    for step in 0..40 {
        let x = number::<T>(0.65 + 0.018 * f64::from(step));
        let exact = x.value();
        let theta = ((1.16 - exact * exact) / 0.8).acos();
        let rate = exact * 2.0 / (0.4 * theta.sin());
        let [rising, falling] = [
            left.velocity(x, number(2.0)).expect("in reach").theta.value(),
            right.velocity(x, number(2.0)).expect("in reach").theta.value(),
        ];
        let [above, below] = [
            left.position(x).expect("in reach").theta.value(),
            right.position(x).expect("in reach").theta.value(),
        ];
        // Some ulps of d² over the slope 0.8 sin θ, which is 0.3 at least; a rate goes as 1/sin θ, and is
        // off by 2.4 times as much of itself.
        let angle = 16.0 * T::EPSILON / 0.3;
        assert!((above - theta).abs() < angle && (below + theta).abs() < angle, "{above} {below}");
        let apart = [rising - rate, falling + rate].map(f64::abs);
        assert!(apart.iter().all(|apart| *apart < 4.0 * angle * rate.abs()), "{apart:?} {rate}");
    }
}

in_both_widths! { a_distance_on_either_side }
