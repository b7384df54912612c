//! Where a coordinate of a pin, the line it lies on, or the sum of two lengths is known without
//! rounding, nothing of it is lost.

use linkage_core::Real;
use linkage_tests::double_double::DoubleDouble;
use linkage_tests::mechanisms::driven_groups::DrivenRrp;
use linkage_tests::mechanisms::slides::*;
use linkage_tests::random::Random;
use linkage_tests::widths::number;

type Wide = DoubleDouble<false>;

/// A pin on two guides along the axes takes x from one guide and y from the other, however far away their
/// origins are. Computed from the slides, it would be wrong by the last place of 3 km.
fn a_pin_of_guides_along_the_axes_is_exact<T: Real>() {
    let mut random = Random::new(3);
    for _ in 0..200 {
        let [x, y] = [(); 2].map(|()| number::<T>(random.anywhere(-1.0, 1.0)));
        let away = number::<T>(random.anywhere(1000.0, 9000.0));
        let zero = number::<T>(0.0);
        let first = CrossedAxes { x, y, away }.position(zero).unwrap().C;
        assert_eq!((first.x.value(), first.y.value()), (x.value(), y.value()));
        let second = AxesCrossed { x, y, away }.position(zero).unwrap().C;
        assert_eq!((second.x.value(), second.y.value()), (x.value(), y.value()));
        // From a slope only the other coordinate is computed.
        assert_eq!(RampAndPost { x, away }.position(zero).unwrap().C.x.value(), x.value());
        assert_eq!(RampAndLevel { y, away }.position(zero).unwrap().C.y.value(), y.value());
    }
}

/// The pin of a guide that moves and one that stands is on the one that stands, and moves along it.
fn a_pin_is_carried_by_the_guide_that_stands<T: Real>() {
    let far = FarPivot::<T>::default();
    // tan of the rail's 20°.
    let (sin, cos) = 20_f64.to_radians().sin_cos();
    for step in -20..=20 {
        // The spoke meets the rail within a few metres of its origin.
        let theta = number::<T>(core::f64::consts::PI + f64::from(step) * 1e-4);
        let motion = far.motion(theta, number(1e-3), number(1e-3)).unwrap();
        let across = |x: T, y: T| (cos * y.value() - sin * x.value()).abs();
        let (c, v, a) = (motion.position.C, motion.velocity.C, motion.acceleration.C);
        // From (0.2, 0.1) up to two metres along the rail, whose direction is rounded.
        let off = across(c.x - number(0.2), c.y - number(0.1));
        assert!(off <= 4.0 * T::EPSILON, "{off:e} at {step}");
        let along = v.x.value().hypot(v.y.value());
        assert!(across(v.x, v.y) <= 2.0 * T::EPSILON * along, "{v:?}");
        let along = a.x.value().hypot(a.y.value());
        assert!(across(a.x, a.y) <= 4.0 * T::EPSILON * along, "{a:?}");
    }
}

/// Next to the limit at the share g of the length, what a sum loses would change the slide by ε/4g of
/// itself; what is put back leaves its last places.
fn sums_of_lengths_lose_nothing_at_a_limit<T: Real>() {
    let mut random = Random::new(5);
    let last_bit = |random: &mut Random, low, high| number::<T>(random.anywhere(low, high)).value();
    let gap = 64.0 * T::EPSILON;
    let mut sums = 0;
    for _ in 0..400 {
        let [l1, l2] = [last_bit(&mut random, 0.5, 1.0), last_bit(&mut random, 0.1, 0.3)];
        let [e1, e2] = [last_bit(&mut random, 0.5, 1.0), last_bit(&mut random, 0.1, 0.3)];
        let y = number::<T>(e1 + e2 - (l1 + l2) * (1.0 - gap)).value();
        let [lengths, offsets] = [[l1, l2], [e1, e2]].map(|[a, b]| Wide::new(a) + Wide::new(b));
        let of_width = |sum: Wide| number::<T>(sum.high).value() == sum.high && sum.low == 0.0;
        sums += u32::from(!of_width(lengths) && !of_width(offsets));
        let group =
            SummedRrp { l1: number::<T>(l1), l2: number(l2), e1: number(e1), e2: number(e2) };
        let found = group.position([number(0.0), number(y)]).unwrap().block.slide.value();
        let truth = DrivenRrp { l: lengths, e: offsets, ..Default::default() };
        let q = [0.0, y, 0.0, 0.0, 0.0].map(Wide::new);
        let (truth, ok) = truth.solve_position(q);
        let slide = truth.block.slide;
        assert!(ok, "{l1} {l2} {e1} {e2}");
        let error = ((found - slide.high) - slide.low).abs();
        assert!(error <= 2.5 * T::EPSILON * slide.high, "{found:e} {slide:?}");
    }
    assert!(sums > 50, "{sums} of the sums are rounded");
}

mod double {
    #[test]
    fn a_pin_of_guides_along_the_axes_is_exact() {
        super::a_pin_of_guides_along_the_axes_is_exact::<f64>();
    }
    #[test]
    fn a_pin_is_carried_by_the_guide_that_stands() {
        super::a_pin_is_carried_by_the_guide_that_stands::<f64>();
    }
    #[test]
    fn sums_of_lengths_lose_nothing_at_a_limit() {
        super::sums_of_lengths_lose_nothing_at_a_limit::<f64>();
    }
}

mod single {
    #[test]
    fn a_pin_of_guides_along_the_axes_is_exact() {
        super::a_pin_of_guides_along_the_axes_is_exact::<f32>();
    }
    #[test]
    fn a_pin_is_carried_by_the_guide_that_stands() {
        super::a_pin_is_carried_by_the_guide_that_stands::<f32>();
    }
    #[test]
    fn sums_of_lengths_lose_nothing_at_a_limit() {
        super::sums_of_lengths_lose_nothing_at_a_limit::<f32>();
    }
}
