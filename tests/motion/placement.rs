//! Where a mechanism stands and how large it is must not matter: guides along the axes are exact,
//! a change of size by a power of two changes no rounding, and being far away costs what the
//! coordinates' spacing costs and no more.

use linkage_core::Real;
use linkage_tests::in_both_widths;
use linkage_tests::mechanisms::placement::*;
use linkage_tests::random::Random;
use linkage_tests::widths::number;

fn guides_along_the_axes<T: Real>() {
    let mut random = Random::new(90);
    for _ in 0..1000 {
        let (x, y) = (random.between(-1.0e3, 1.0e3), random.between(-1.0, 1.0));
        let rates = [number::<T>(y), number(x)];
        let motion =
            StackedSliders::default().motion([number(x), number(y)], rates, rates).unwrap();
        // No 6e-17 anywhere: the numbers come out as they went in.
        assert_eq!((motion.position.Q.x.value(), motion.position.Q.y.value()), (x, y));
        assert_eq!((motion.velocity.Q.x.value(), motion.velocity.Q.y.value()), (y, x));
        assert_eq!((motion.acceleration.Q.x.value(), motion.acceleration.Q.y.value()), (y, x));
        assert_eq!(
            (motion.position.quill.cos.value(), motion.position.quill.sin.value()),
            (0.0, 1.0)
        );

        let turned = TurnedSliders::default().motion([number(x), number(y)], rates, rates).unwrap();
        assert_eq!((turned.position.Q.x.value(), turned.position.Q.y.value()), (-x, -y));
        assert_eq!((turned.velocity.Q.x.value(), turned.velocity.Q.y.value()), (-y, -x));
        assert_eq!(
            (turned.position.quill.cos.value(), turned.position.quill.sin.value()),
            (0.0, -1.0)
        );
    }
}

/// The rows of a motion with everything that is a length divided by the size.
macro_rules! unit_rows {
    ($mechanism:ident, $t:ty, $size:expr, $theta:expr) => {{
        let mechanism = $mechanism::<$t> { size: number($size) };
        let motion = mechanism.motion(number($theta), number(1.5), number(-0.75)).unwrap();
        let orders = [motion.position.rows(), motion.velocity.rows(), motion.acceleration.rows()];
        let names = $mechanism::OUTPUTS;
        orders.map(|rows| {
            rows.iter()
                .zip(names)
                .map(|(row, name)| row.value() / if name.ends_with("angle") { 1.0 } else { $size })
                .collect::<Vec<f64>>()
        })
    }};
}

macro_rules! check_sizes {
    ($mechanism:ident, $t:ty) => {{
        for step in 0..64 {
            let theta = -3.0 + f64::from(step) * 0.09375;
            let unit = unit_rows!($mechanism, $t, 1.0, theta);
            for power in [-30, -9, 7, 30] {
                let size = 2.0_f64.powi(power);
                // Every operation scales by a power of the size exactly, and so does its rounding.
                assert_eq!(unit_rows!($mechanism, $t, size, theta), unit, "2^{power} at {theta}");
            }
            for size in [1.0e-9, 1.0e9] {
                let scaled = unit_rows!($mechanism, $t, size, theta);
                for order in 0..3 {
                    for (value, wanted) in scaled[order].iter().zip(&unit[order]) {
                        // The dimensions round differently at another size. The tables give such
                        // groups conditions up to 20 for poses, 100 for velocities and 500 for
                        // accelerations; twenty roundings of them.
                        let allowed = 10.0 * [20.0, 100.0, 500.0][order] * <$t as Real>::EPSILON;
                        let error = (value - wanted).abs();
                        assert!(error <= allowed, "size {size} at {theta}: {value} for {wanted}");
                    }
                }
            }
        }
    }};
}

fn any_size<T: Real>() {
    check_sizes!(AnySize, T);
}

fn any_size_of_guides<T: Real>() {
    check_sizes!(AnySizeGuides, T);
}

fn far_away<T: Real>() {
    let near = FarAway::<T>::default();
    for (east, north) in [(1048576.0, 0.0), (-1048576.0, 524288.0), (1.0e6, 1.0e6)] {
        let far = FarAway { east: number::<T>(east), north: number(north) };
        for step in 0..64 {
            let theta = number(-3.0 + f64::from(step) * 0.09375);
            let here = near.motion(theta, number(1.5), number(-0.75)).unwrap();
            let there = far.motion(theta, number(1.5), number(-0.75)).unwrap();
            // B and D are rounded to the spacing at 2²⁰ m, one rounding each and one for the pin;
            // the bars are at least 2 m, the angle at C is between 43° and 132°.
            let spacing = 1048576.0 * T::EPSILON;
            let turned = there.position.DC.angle_from(here.position.DC).value().abs();
            assert!(turned <= 4.0 * spacing / 2.0 / 0.68, "{turned:e}");
            let omega = (there.velocity.DC.omega.value() - here.velocity.DC.omega.value()).abs();
            assert!(omega <= 3.0 * 4.0 * spacing / 2.0 / 0.68, "{omega:e}");
            let x = (there.position.C.x.value() - east - here.position.C.x.value()).abs();
            assert!(x <= 6.0 * spacing / 0.68, "{x:e}");
        }
    }
}

in_both_widths! { guides_along_the_axes any_size any_size_of_guides far_away }
