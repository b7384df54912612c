//! The functions of expressions in whole mechanisms: values, rates, derivatives, widths, lanes, and refusals.

use linkage_core::{Float, Record, SolveError, Status, differentiate_twice, mechanism, unwanted};
use linkage_tests::double_double::DoubleDouble;
use linkage_tests::random::Random;

mechanism! {
    /// Every function that a library computes, in dimensions and in outputs.
    pub struct Laws {
        input q: angle;
        input s: length;
        param k = 1.3;

        ground A(0, 0), D(900mm, 150mm);
        guide rail through (200mm, -100mm) along 20deg;
        crank  AB(A) -> B      { length: 300mm, angle: q }
        slider ram(rail) -> P  { slide: 300mm * tanh(q) + s }
        crank  wheel(D) -> W   { length: 1m * exp(-q / 2), angle: ln(s / 100mm) }

        output W, bent = tanh(q), grown = exp(q), log = ln(s / 1m), law = pow(s / 100mm, k), cube = pow(q, 3),
               inverse = pow(s, -2) * 1(m^3), ram.slide;
    }
}

mechanism! {
    /// Those with a corner.
    pub struct Corners {
        input q: angle;
        input s: length;
        ground A(0, 0);
        crank AB(A) -> B { length: 300mm, angle: q }
        output size = abs(s), side = sign(s), lower = min(B.x, s), upper = max(B.x, s);
    }
}

#[test]
fn values_and_rates_are_those_of_closed_forms() {
    let (q, s, k) = (0.7_f64, 0.21_f64, 1.3);
    let (dq, ds, ddq, dds) = (1.1, -0.4, 0.3, 0.9);
    let motion = Laws::new().motion([q, s], [dq, ds], [ddq, dds]).unwrap();
    let (at, rate, accel) = (motion.position, motion.velocity, motion.acceleration);
    // First and second derivatives of each by its own input.
    let (t, e, r) = (q.tanh(), q.exp(), s / 0.1);
    let power = |less: f64| r.powf(k - less);
    let table = [
        ([at.bent, rate.bent, accel.bent], [t, 1.0 - t * t, -2.0 * t * (1.0 - t * t)], false),
        ([at.grown, rate.grown, accel.grown], [e; 3], false),
        ([at.log, rate.log, accel.log], [s.ln(), 1.0 / s, -1.0 / (s * s)], true),
        (
            [at.law, rate.law, accel.law],
            [power(0.0), 10.0 * k * power(1.0), 100.0 * k * (k - 1.0) * power(2.0)],
            true,
        ),
        ([at.cube, rate.cube, accel.cube], [q * q * q, 3.0 * q * q, 6.0 * q], false),
        (
            [at.inverse, rate.inverse, accel.inverse],
            [s.powi(-2), -2.0 * s.powi(-3), 6.0 * s.powi(-4)],
            true,
        ),
    ];
    for (nth, (found, [value, first, second], is_of_s)) in table.into_iter().enumerate() {
        let (rate, accel) = if is_of_s { (ds, dds) } else { (dq, ddq) };
        let terms = [value, first * rate, second * rate * rate, first * accel];
        let sought = [value, terms[1], terms[2] + terms[3]];
        // A dozen operations of that size.
        let scale = terms.iter().fold(1.0_f64, |most, x| most.max(x.abs()));
        for (found, sought) in found.into_iter().zip(sought) {
            let off = (found - sought).abs();
            assert!(off <= 16.0 * f64::EPSILON * scale, "{nth}: {found} for {sought}");
        }
    }
    let (length, angle) = ((-q / 2.0).exp(), r.ln());
    assert!((at.W.x - 0.9 - length * angle.cos()).abs() < 1e-15);
    assert!((at.W.y - 0.15 - length * angle.sin()).abs() < 1e-15);
}

/// Against 31 digits. Rounding of an argument x changes eˣ by x ε of itself, xᵏ by k ε, and of the exponents here
/// by 3 ε at most; a dozen last places of the largest number hold the rest.
fn values_are_right<T: Float, const NARROW: bool>() {
    let mut random = Random::new(5);
    for _ in 0..5_000 {
        let given = [random.between(-3.0, 3.0), random.between(0.01, 1.0)];
        let given = given.map(|x| T::lit(x, x as f32));
        let found = Laws::<T>::default().position(given).unwrap().into_array();
        let exact = given.map(|x| DoubleDouble::<NARROW>::new(x.value()));
        let (truth, _) = Laws::<T>::default().lift::<DoubleDouble<NARROW>>().solve_position(exact);
        for (nth, (found, truth)) in found.into_iter().zip(truth.into_array()).enumerate() {
            let off = (DoubleDouble::<NARROW>::new(found.value()) - truth).high.abs();
            let allowed = 12.0 * T::EPSILON * truth.high.abs().max(1.0);
            assert!(off <= allowed, "{nth} at {given:?}: {off:e}, {allowed:e}");
        }
    }
}

#[test]
fn values_are_right_to_the_last_places_in_both_widths() {
    values_are_right::<f64, false>();
    values_are_right::<f32, true>();
}

/// By two inputs and the exponent, which is a parameter: x^k has the derivative x^k ln x.
#[test]
fn derivatives_to_the_second_order_are_those_of_closed_forms() {
    let (q, s, k) = (0.7_f64, 0.21_f64, 1.3_f64);
    let of = |name: fn(&LawsPosition<_>) -> _| {
        differentiate_twice([q, s, k], |[q, s, k]| Ok(name(&Laws { k }.position([q, s])?))).unwrap()
    };
    let close = |found: f64, sought: f64| {
        assert!(
            (found - sought).abs() <= 32.0 * f64::EPSILON * sought.abs(),
            "{found} for {sought}"
        );
    };
    let (r, log) = (s / 0.1, (s / 0.1).ln());
    let law = of(|at| at.law);
    let value = r.powf(k);
    close(law.gradient[1], k * value / s);
    close(law.gradient[2], value * log);
    close(law.hessian[(1, 1)], k * (k - 1.0) * value / (s * s));
    close(law.hessian[(1, 2)], value / s * (1.0 + k * log));
    close(law.hessian[(2, 2)], value * log * log);
    let t = q.tanh();
    let bent = of(|at| at.bent);
    close(bent.gradient[0], 1.0 - t * t);
    close(bent.hessian[(0, 0)], -2.0 * t * (1.0 - t * t));
    let grown = of(|at| at.grown);
    close(grown.hessian[(0, 0)], q.exp());
    let logarithm = of(|at| at.log);
    close(logarithm.hessian[(1, 1)], -1.0 / (s * s));
    let cube = of(|at| at.cube);
    close(cube.hessian[(0, 0)], 6.0 * q);
}

/// Poses with and without an answer, of inputs that leave every domain.
fn poses<T: Float>() -> [Vec<T>; 2] {
    let mut random = Random::new(9);
    let mut draw = |odd: &[f64], from: f64, to: f64| -> Vec<T> {
        let number = |_| {
            let x = match random.between(0.0, 1.0) {
                share if share < 0.2 => odd[(share * 5.0 * odd.len() as f64) as usize],
                _ => random.between(from, to),
            };
            T::lit(x, x as f32)
        };
        (0..4_003).map(number).collect()
    };
    [
        draw(&[-2000.0, 2000.0, 0.0, 800.0, -95.0], -3.0, 3.0),
        draw(&[0.0, -0.0, -0.3, 1e-30, 1e30, -1e-300], -0.1, 1.0),
    ]
}

/// A sweep's poses are those of single calls, to the bit, and answers are numbers.
fn sweeps_agree<T: Float>() {
    let [q, s] = poses::<T>();
    let zero = T::lit(0.0, 0.0);
    let (laws, corners) = (Laws::<T>::default(), Corners::<T>::default());
    let mut columns = [(); 4].map(|()| vec![zero; q.len()]);
    let mut status = [vec![Status::default(); q.len()], vec![Status::default(); q.len()]];
    let [bent, log, law, size] = &mut columns;
    let [bent, log, law] = [bent, log, law].map(|column| &mut column[..]);
    let out = LawsPosition { bent, log, law, ..unwanted() };
    laws.sweep_position([(&q[..]).into(), (&s[..]).into()], out, &mut status[0], ()).unwrap();
    let out = CornersPosition { size: &mut size[..], ..unwanted() };
    corners.sweep_position([(&q[..]).into(), (&s[..]).into()], out, &mut status[1], ()).unwrap();
    let (mut solved, mut refused) = (0, [0; 2]);
    for at in 0..q.len() {
        let found = laws.position([q[at], s[at]]);
        let expected = found.map_or_else(Status::from, |_| Status::Solved);
        assert_eq!(status[0][at], expected, "{:?} {:?}", q[at], s[at]);
        match found {
            Ok(found) => {
                solved += 1;
                assert!(found.into_array().into_iter().all(|x| x.value().is_finite()));
                // A target with fused operations changes nothing before these outputs.
                let [bent, log, law] = [0, 1, 2].map(|of| columns[of][at].value());
                assert_eq!([bent, log, law], [found.bent, found.log, found.law].map(T::value));
            }
            Err(SolveError::Invalid { group: "ln", name }) => {
                assert!(s[at].value() <= 0.0);
                assert_eq!(name, "s / 100mm");
                refused[0] += 1;
            }
            // Its length is an exponential that has underflown.
            Err(SolveError::Invalid { group: "wheel", .. }) => assert!(q[at].value() > 200.0),
            Err(SolveError::NotFinite { .. }) => refused[1] += 1,
            Err(error) => panic!("{error}"),
        }
        let (x, y) = (corners.position([q[at], s[at]]).unwrap().size, columns[3][at]);
        assert_eq!(x.value().to_bits(), y.value().to_bits(), "{:?} {:?}", q[at], s[at]);
    }
    assert!(solved > 2000 && refused.iter().all(|&count| count > 50), "{solved} {refused:?}");
}

#[test]
fn sweeps_give_the_bits_and_refusals_of_single_calls() {
    sweeps_agree::<f64>();
    sweeps_agree::<f32>();
}

/// The four corners in lanes: both sides, the corner itself, and equal numbers.
#[test]
fn corners_are_exact_in_lanes() {
    let s = [-2.0, -0.0, 0.0, 0.3, 0.25, 7.0];
    let q = [0.0; 6];
    let mut columns = [[0.0; 6]; 4];
    let [size, side, lower, upper] = columns.each_mut().map(|column| &mut column[..]);
    let out = CornersPosition { size, side, lower, upper };
    Corners::new()
        .sweep_position([(&q[..]).into(), (&s[..]).into()], out, &mut [Status::default(); 6], ())
        .unwrap();
    assert_eq!(columns[0], [2.0, 0.0, 0.0, 0.3, 0.25, 7.0]);
    assert_eq!(columns[1], [-1.0, 0.0, 0.0, 1.0, 1.0, 1.0]);
    assert_eq!(columns[2], [-2.0, 0.0, 0.0, 0.3, 0.25, 0.3]);
    assert_eq!(columns[3], [0.3, 0.3, 0.3, 0.3, 0.3, 7.0]);
}

#[test]
fn refusals_name_the_argument_that_is_not_above_zero() {
    let error = Laws::new().position([0.0, -0.1]).unwrap_err();
    assert_eq!(error.to_string(), "ln: `s / 100mm` must be greater than zero");
    let overflown = Laws::new().position([800.0, 0.1]).unwrap_err();
    assert!(matches!(overflown, SolveError::NotFinite { .. }), "{overflown}");
}
