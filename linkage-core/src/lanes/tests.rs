use super::*;
use crate::kernels::Native;
use crate::{Fused, Real};

const ARGUMENTS: [f64; 8] = [0.3, -1.25, 2.0, 7e4, -0.0, 1e6, 3e-9, -12.5];
const OTHERS: [f64; 8] = [1.7, 0.25, -3.5, 2e-7, 1.0, -1.0, 5.0, 12.5];

/// Bits, with all numbers that are none taken for the same.
fn bits<T: Real>(x: T) -> u64 {
    if x.value().is_nan() { u64::MAX } else { x.value().to_bits() }
}

#[track_caller]
fn assert_same<T: Float, F: Fusion>(lanes: Lanes<T, 8, F>, single: impl Fn(usize) -> T) {
    for (i, lane) in lanes.to_array().into_iter().enumerate() {
        assert_eq!(bits(lane), bits(single(i)), "lane {i}: {lane:?} {:?}", single(i));
    }
}

/// Every operation, against the single number's with `F` as its way of fusing.
fn agrees_with_single_numbers<T: Float, F: Fusion>() {
    let t = |x: f64| T::lit(x, x as f32);
    let [x, y] = [ARGUMENTS.map(t), OTHERS.map(t)];
    let [lx, ly] = [Lanes::<T, 8, F>::new(x), Lanes::new(y)];
    assert_same(lx + ly, |i| x[i] + y[i]);
    assert_same(lx - ly, |i| x[i] - y[i]);
    assert_same(lx * ly, |i| x[i] * y[i]);
    assert_same(lx / ly, |i| x[i] / y[i]);
    assert_same(-lx, |i| -x[i]);
    assert_same(lx.sqrt(), |i| x[i].sqrt());
    assert_same(lx.tan(), |i| x[i].tan());
    assert_same(lx.asin(), |i| x[i].asin_kernel::<F>());
    assert_same(lx.acos(), |i| x[i].acos_kernel::<F>());
    assert_same(lx.atan(), |i| x[i].atan_kernel::<F>());
    assert_same(lx.atan2(ly), |i| x[i].atan2_kernel::<F>(y[i]));
    assert_same(lx.hypot(ly), |i| x[i].hypot(y[i]));
    for function in LibraryFunction::ALL {
        assert_same(lx.apply(function), |i| x[i].apply(function));
    }
    assert_same(lx.exp(), |i| x[i].exp());
    assert_same(lx.ln(), |i| x[i].ln());
    assert_same(lx.tanh(), |i| x[i].tanh());
    assert_same(lx.pow(ly), |i| x[i].pow(y[i]));
    let hypot = |i: usize| x[i].hypot_near(y[i], t(1.0));
    if F::FUSED == Native::FUSED {
        assert_same(lx.hypot_near(ly, Lanes::splat(t(1.0))).0, |i| hypot(i).0);
    }
    assert_eq!(
        lx.hypot_near(ly, Lanes::splat(t(1.0))).1.to_array(),
        core::array::from_fn(|i| hypot(i).1)
    );
    assert_same(lx.sin_cos_near().0, |i| x[i].sin_cos_near_kernel::<F, true>().0);
    assert_same(lx.sin_cos_near().1, |i| x[i].sin_cos_near_kernel::<F, true>().1);
    let full = |x: T| if x.is_near() { x.sin_cos_kernel::<F>() } else { x.sin_cos() };
    assert_same(lx.sin_cos().0, |i| full(x[i]).0);
    assert_same(lx.sin_cos().1, |i| full(x[i]).1);
    assert_same(Scalar::det(lx, ly, ly, lx + ly), |i| {
        kernels::det::<T, F>(x[i], y[i], y[i], x[i] + y[i])
    });
    assert_same(Scalar::mul_err(lx, ly), |i| kernels::mul_err::<T, F>(x[i], y[i]));
    assert_same(Scalar::add_err(lx, ly), |i| T::add_err(x[i], y[i]));
    assert_same(Scalar::fused(lx, ly, lx), |i| T::fused_by::<F>(x[i], y[i], x[i]));
    assert_eq!(lx.ge(ly).to_array(), core::array::from_fn(|i| x[i].ge(y[i])));
    assert_eq!(lx.gt(ly).to_array(), core::array::from_fn(|i| x[i].gt(y[i])));
    assert_eq!(lx.is_near().to_array(), x.map(Scalar::is_near));
    assert_eq!(lx.is_within(ly).to_array(), core::array::from_fn(|i| x[i].is_within(y[i])));
    assert_eq!(
        (ly / lx).is_finite().to_array(),
        core::array::from_fn(|i| Scalar::is_finite(y[i] / x[i]))
    );
    assert_same(Scalar::select(lx.gt(ly), lx, ly), |i| if x[i].gt(y[i]) { x[i] } else { y[i] });
    assert_same::<T, F>(Scalar::smallest_square(), |_| T::smallest_square());
    assert_same::<T, F>(Scalar::lit(1.0 / 3.0, 0.2), |_| T::lit(1.0 / 3.0, 0.2));
}

#[test]
fn lanes_agree_with_single_numbers_bit_for_bit() {
    agrees_with_single_numbers::<f64, Plain>();
    agrees_with_single_numbers::<f64, Fused>();
    agrees_with_single_numbers::<f32, Plain>();
    agrees_with_single_numbers::<f32, Fused>();
}

#[test]
fn lanes_fused_like_the_target_are_the_single_numbers() {
    fn check<T: Float>() {
        let t = |x: f64| T::lit(x, x as f32);
        let [x, y] = [ARGUMENTS.map(t), OTHERS.map(t)];
        let [lx, ly] = [Lanes::<T, 8, Native>::new(x), Lanes::new(y)];
        assert_same(lx.sin_cos().0, |i| x[i].sin_cos().0);
        assert_same(lx.sin_cos_near().1, |i| x[i].sin_cos_near().1);
        assert_same(Scalar::det(lx, ly, ly, lx), |i| T::det(x[i], y[i], y[i], x[i]));
        assert_same(Scalar::fused(lx, ly, lx), |i| T::fused(x[i], y[i], x[i]));
    }
    check::<f64>();
    check::<f32>();
}

#[test]
fn a_mask_speaks_for_every_lane() {
    let x = Lanes::<f64, 3>::new([1.0, 2.0, 3.0]);
    let one = Lanes::splat(1.0);
    assert!(x.ge(one).all() && !x.gt(one).all());
    assert_eq!((x.ge(one) & x.gt(one)).to_array(), [false, true, true]);
    assert_eq!(LaneMask::<3>::ALL.to_array(), [true; 3]);
    assert_eq!(<[f64; 3]>::from(Lanes::from([1.0, 2.0, 3.0]) - one), [0.0, 1.0, 2.0]);
}

/// Lanes behind the eighth have a loop of their own.
#[test]
fn eleven_lanes_have_their_sines() {
    let angles: [f64; 11] = core::array::from_fn(|lane| 0.37 * lane as f64 - 1.9);
    let (sines, cosines) = Lanes::<f64, 11, Native>::new(angles).sin_cos_near();
    let found = sines.to_array().into_iter().zip(cosines.to_array());
    for (angle, found) in angles.into_iter().zip(found) {
        let (sines, cosines) = Lanes::<f64, 1, Native>::new([angle]).sin_cos_near();
        assert_eq!(found, (sines.to_array()[0], cosines.to_array()[0]), "{angle}");
    }
}
