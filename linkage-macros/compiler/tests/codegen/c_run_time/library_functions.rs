//! Functions that the run-time in C takes from `<math.h>`.

use super::{Call, Program, Random, answers, arguments, expected};
use linkage_core::Fusion;

/// Exponentials and their kin are those of `<math.h>`, which is within an ulp, as the crate's are: two apart.
pub(super) fn agree<F: Fusion>(programs: &[Program], count: usize) {
    let mut random = Random(11);
    for is_single in [false, true] {
        for which in 15..19 {
            let scale = if is_single { 100.0 } else { 800.0 };
            let mut call = || {
                let mut x = arguments(&mut random, which, is_single);
                if random.below(2) == 0 {
                    // The exponents that do not overflow, and bases above zero.
                    x[0] = f64::from(((random.unit() - 0.5) * scale) as f32);
                    x[1] = f64::from((random.unit() * 20.0 - 10.0) as f32);
                    x[0] = if which == 18 { x[0].abs() } else { x[0] };
                }
                Call { which, is_single, x }
            };
            let calls: Vec<Call> = (0..count).map(|_| call()).collect();
            let expected = |call: &Call| match is_single {
                false => expected::<f64, F>(call, |x| x)[2],
                true => expected::<f32, F>(call, f64::from)[2],
            };
            let (epsilon, least) = match is_single {
                false => (f64::EPSILON, 5e-324),
                true => (f64::from(f32::EPSILON), f64::from(f32::from_bits(1))),
            };
            let expected: Vec<f64> = calls.iter().map(expected).collect();
            let finite = expected.iter().filter(|b| b.is_finite() && **b != 0.0).count();
            assert!(finite > count / 4, "{which}: {finite}");
            for program in programs {
                let found = answers(program, &calls);
                for ((call, found), &b) in calls.iter().zip(&found).zip(&expected) {
                    let a = found[2];
                    let is_near = (a - b).abs() <= (2.0 * epsilon * b.abs()).max(least);
                    let is_alike = is_near || a == b || a.is_nan() && b.is_nan();
                    assert!(is_alike, "{call:?}: {a:e} for {b:e}");
                }
            }
        }
    }
}
