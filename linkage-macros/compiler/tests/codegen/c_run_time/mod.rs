//! The run-time in C beside the run-time crate: the same bits, the same refusals.
//!
//! Numbers are random in sign and magnitude, and those of conditions lie next to limits, where a decision hangs
//! on the last bit. Both widths; compiled as strict C99, as C++17, and for a machine with fused operations under
//! a standard that lets the compiler contract products into sums unless it is told.

pub(crate) mod angles;
pub(crate) mod library_functions;

use std::collections::BTreeSet;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

use super::c_program::{self, Program, STRICT};
use super::c_roots::roots_agree;
use super::skipped::skipped;
use crate::codegen::c::run_time;
use linkage_core::private::{
    Certified, Diagnosis, Moving, Nonzero, NotNegative, Positive, ReachCircles, ReachDistances,
    ReachLine, ReachOffset, ShareOfCentres, Square, SquareOfCentres, diagnose_all, on_circle,
};
use linkage_core::{Float, Fused, Fusion, Lanes, Mask, Plain, Real, Scalar, SolveError};

const CONTRACTING: [&str; 3] = ["-std=gnu17", "-march=x86-64-v3", "-Wall"];

/// A stream of random numbers, by a multiplicative congruence.
pub(super) struct Random(pub(super) u64);

impl Random {
    fn bits(&mut self) -> u64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        self.0 ^ (self.0 >> 29)
    }

    /// In [0, 1).
    pub(super) fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub(super) fn below(&mut self, count: u64) -> u64 {
        (self.bits() >> 20) % count
    }

    pub(super) fn pick<T: Copy>(&mut self, list: &[T]) -> T {
        list[self.below(list.len() as u64) as usize]
    }

    /// A number of either sign and some binades around one.
    fn number(&mut self, binades: f64) -> f64 {
        let size = ((self.unit() - 0.5) * 2.0 * binades).exp2();
        if self.below(2) == 0 { size } else { -size }
    }

    /// Sometimes no number at all, or one at the end of the range.
    fn any(&mut self, binades: f64) -> f64 {
        const ODD: [f64; 10] = [
            0.0,
            -0.0,
            f64::NAN,
            f64::INFINITY,
            f64::NEG_INFINITY,
            1.0,
            -1.0,
            5e-324,
            1e-310,
            f64::MAX,
        ];
        if self.below(12) == 0 { self.pick(&ODD) } else { self.number(binades) }
    }
}

/// A call: the function's number, and its operands.
#[derive(Clone, Copy, Debug)]
pub(super) struct Call {
    pub(super) which: i32,
    pub(super) is_single: bool,
    pub(super) x: [f64; 9],
}

/// A status, what is missing, and two results.
pub(super) type EntryOutputs = [f64; 4];

/// The program that answers calls, compiled with these flags; none without a compiler.
fn program(compiler: &str, name: &str, flags: &[&str]) -> Option<Program> {
    let part = ("linkage_root.c", run_time::root_source());
    Program::compiled(compiler, name, flags, "run_time.c", part)
}

/// The answers of a program to calls.
pub(super) fn answers(program: &Program, calls: &[Call]) -> Vec<EntryOutputs> {
    let mut bytes = Vec::new();
    for call in calls {
        bytes.extend(call.which.to_ne_bytes());
        bytes.extend(i32::from(call.is_single).to_ne_bytes());
        call.x.iter().for_each(|x| bytes.extend(x.to_ne_bytes()));
    }
    let numbers = program.numbers(bytes);
    numbers.chunks(4).map(|x| x.try_into().expect("four numbers")).collect()
}

fn bits(answer: &EntryOutputs) -> [u64; 4] {
    answer.map(c_program::bits)
}

/// Expected answers to the calls, which every program gives.
pub(super) fn compare(
    programs: &[Program],
    calls: &[Call],
    expected: impl Fn(&Call) -> EntryOutputs,
) -> Vec<EntryOutputs> {
    let expected: Vec<_> = calls.iter().map(expected).collect();
    for (nth, program) in programs.iter().enumerate() {
        let found = answers(program, calls);
        assert_eq!(found.len(), calls.len());
        for ((call, found), expected) in calls.iter().zip(&found).zip(&expected) {
            let is_alike = bits(found) == bits(expected);
            assert!(is_alike, "program {nth}, {call:?}: {found:?} in place of {expected:?}");
        }
    }
    expected
}

/// The numbers of one function's arguments.
fn arguments(random: &mut Random, which: i32, is_single: bool) -> [f64; 9] {
    let mut x = [0.0; 9];
    let near = if is_single { 51_471.0 } else { 1_048_576.0 };
    let binades = if is_single { 50.0 } else { 400.0 };
    for to in &mut x[..4] {
        *to = match which {
            0 if random.below(4) == 0 => {
                random.pick(&[FRAC_PI_4, FRAC_PI_2, PI]) * random.unit().round()
            }
            0 | 11 => (random.unit() - 0.5) * 2.0 * near,
            // Numbers of any size, and sometimes none.
            1 if random.below(2) == 0 => random.any(if is_single { 128.0 } else { 1024.0 }),
            1 => (random.unit() - 0.5) * 4.0 * near,
            2 | 3 if random.below(10) > 0 => (random.unit() - 0.5) * 2.0,
            12 => (random.unit() - 0.5) * 2.2,
            10 => random.number(20.0),
            _ => {
                let binades = random.pick(&[3.0, binades]);
                random.any(binades)
            }
        };
        if is_single {
            *to = f64::from(*to as f32);
        }
    }
    x
}

fn expected<T: Float, F: Fusion>(call: &Call, widen: impl Fn(T) -> f64) -> EntryOutputs {
    type One<T, F> = Lanes<T, 1, F>;
    let x: [One<T, F>; 4] = [0, 1, 2, 3].map(|i| Lanes::splat(T::lit(call.x[i], call.x[i] as f32)));
    let number = |x: One<T, F>| widen(x.to_array()[0]);
    let one = |y: One<T, F>| [0.0, 0.0, number(y), 0.0];
    let two = |(y, z): (One<T, F>, One<T, F>)| [0.0, 0.0, number(y), number(z)];
    let yes = |mask: bool| f64::from(u8::from(mask));
    match call.which {
        0 => two(x[0].sin_cos_near()),
        1 => two(x[0].sin_cos()),
        2 => one(x[0].asin()),
        3 => one(x[0].acos()),
        4 => one(x[0].atan()),
        5 => one(x[0].atan2(x[1])),
        6 => one(x[0].hypot(x[1])),
        7 => one(Scalar::det(x[0], x[1], x[2], x[3])),
        8 => one(Scalar::mul_err(x[0], x[1])),
        9 => one(Scalar::add_err(x[0], x[1])),
        10 => one(Scalar::fused(x[0], x[1], x[2])),
        11 => [yes(x[0].is_near().all()), 0.0, 0.0, 0.0],
        12 => {
            let (cos, sin, is_near) = on_circle(x[0], x[1]);
            [yes(is_near.all()), 0.0, number(cos), number(sin)]
        }
        13 => {
            let (length, is_near) = x[0].hypot_near(x[1], x[2]);
            [yes(is_near.all()), 0.0, number(length), 0.0]
        }
        15 => one(x[0].exp()),
        16 => one(x[0].ln()),
        17 => one(x[0].tanh()),
        18 => one(x[0].pow(x[1])),
        _ => one(Scalar::select(x[0].ge(x[1]), x[2], x[3])),
    }
}

fn functions_agree<F: Fusion>(programs: &[Program], count: usize) {
    let mut random = Random(7);
    for is_single in [false, true] {
        for which in 0..15 {
            let call = |_| Call { which, is_single, x: arguments(&mut random, which, is_single) };
            let calls: Vec<Call> = (0..count).map(call).collect();
            compare(programs, &calls, |call| match is_single {
                false => expected::<f64, F>(call, |x| x),
                true => expected::<f32, F>(call, f64::from),
            });
        }
    }
}

/// Lengths and a distance within some last places of one of both limits, and a value that may have lost its
/// sign.
fn circles(random: &mut Random, is_single: bool) -> [f64; 6] {
    let width = |x: f64| if is_single { f64::from(x as f32) } else { x };
    let epsilon = if is_single { f64::from(f32::EPSILON) } else { f64::EPSILON };
    let scale = random.number(random_scale(is_single)).abs();
    let [l1, l2] = [(); 2].map(|()| width(scale * random.number(2.0).abs()));
    let l2 = if random.below(8) == 0 { l1 } else { l2 };
    let limit = if random.below(2) == 0 { l1 + l2 } else { (l1 - l2).abs() };
    let ulps = random.below(17) as f64 - 8.0;
    let longest = l1.max(l2).max(limit);
    let d = match random.below(6) {
        0 => limit * random.unit() * 2.0,
        _ => limit + ulps * epsilon * longest.log2().floor().exp2(),
    };
    let (sin, cos) = match random.below(3) {
        0 => (0.0, 1.0),
        _ => (random.unit() * 2.0 * PI).sin_cos(),
    };
    let value = match random.below(6) {
        0 => random.any(3.0),
        _ => random.number(2.0) * epsilon,
    };
    [value, d * cos, d * sin, l1, l2, random.pick(&[1.0, 2.5, 1e20, 1e-3])].map(width)
}

fn random_scale(is_single: bool) -> f64 {
    if is_single { 125.0 } else { 1020.0 }
}

/// The operands of a condition.
fn operands(random: &mut Random, which: i32, is_single: bool) -> [f64; 9] {
    let [value, dx, dy, l1, l2, spread] = circles(random, is_single);
    let (d, unit) = (dx.hypot(dy), random.pick(&[1.0, 2.0 * l1 * l2, 0.5]));
    let x: [f64; 7] = match which {
        20 => [value, dx, dy, l1, l2, unit, spread],
        21 => [value, random.number(2.0) * f64::EPSILON, dx, dy, l1, l2, spread],
        22 => [value, d, l1, l2, spread, 0.0, 0.0],
        23 => [value, dx, dy, l1, l2, 0.0, 0.0],
        // As long as a bar is, or longer by rounding.
        24 => {
            let ulps = random.below(17) as f64 - 8.0;
            [
                value,
                l1 * (1.0 + ulps * if is_single { 1.2e-7 } else { 2.3e-16 }),
                l1,
                0.0,
                0.0,
                0.0,
                0.0,
            ]
        }
        25 => {
            let ulps = random.below(17) as f64 - 8.0;
            [
                value,
                dx,
                dy,
                d * (1.0 + ulps * if is_single { 1.2e-7 } else { 2.3e-16 }),
                0.0,
                0.0,
                0.0,
            ]
        }
        29 => [random.any(random_scale(is_single)).abs(), 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        31 => blamed(random, is_single),
        _ => [random.any(20.0), spread, 0.0, 0.0, 0.0, 0.0, 0.0],
    };
    let mut all = [0.0; 9];
    for (to, &x) in all.iter_mut().zip(&x) {
        let x = if random.below(60) == 0 { random.any(900.0) } else { x };
        *to = if is_single { f64::from(x as f32) } else { x };
    }
    all
}

/// Three numbers that are given, about the root of fourth order of the largest number, and a result that is none.
fn blamed(random: &mut Random, is_single: bool) -> [f64; 7] {
    let largest = if is_single { f64::from(f32::MAX) } else { f64::MAX };
    let [a, b, c] = [(); 3].map(|()| largest.powf(0.25) * random.number(1.0));
    let given =
        random.pick(&[[a, b, c], [a, a, -a], [a, b, f64::INFINITY], [1.0, b, -b], [0.0; 3]]);
    let result = random.pick(&[f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1.0]);
    [given[0], given[1], given[2], result, 0.0, 0.0, 0.0]
}

/// The first of the numbers that is to blame, by its name.
fn blame<T: Real>([a, b, c, result]: [T; 4]) -> EntryOutputs {
    let given = [(a, "0"), (b, "1"), (c, "2")];
    match diagnose_all(&given, |_| result, |result| [(result, "3")]) {
        Ok(_) => [0.0, 0.0, 0.0, -1.0],
        Err(SolveError::NotFinite { name }) => [4.0, 0.0, 0.0, name.parse().expect("a digit")],
        Err(error) => panic!("{error}"),
    }
}

fn diagnosed<T: Real>(call: &Call) -> EntryOutputs {
    let x: [T; 7] = [0, 1, 2, 3, 4, 5, 6].map(|i| T::lit(call.x[i], call.x[i] as f32));
    if call.which == 31 {
        return blame([x[0], x[1], x[2], x[3]]);
    }
    let [value, rest @ ..] = x;
    let [a, b, c, d, e, f] = rest;
    let found = match call.which {
        20 => ReachCircles([a, b, c, d, e, f], "group").diagnose(value),
        21 => ShareOfCentres([a, b, c, d, e, f], "group").diagnose(value),
        22 => ReachDistances([a, b, c, d], "group").diagnose(value),
        23 => SquareOfCentres([a, b, c, d], "group").diagnose(value),
        24 => ReachLine([a, b], "group").diagnose(value),
        25 => ReachOffset([a, b, c], "group").diagnose(value),
        26 => Nonzero("group").diagnose(value),
        27 => Positive("group", "name").diagnose(value),
        28 => NotNegative("group", "name").diagnose(value),
        29 => Square("group").diagnose(value),
        32 => Certified("group").diagnose(value),
        _ => Moving([a], "group").diagnose(value),
    };
    match found {
        Ok(y) => [0.0, 0.0, y.value(), 0.0],
        Err(SolveError::OutOfReach { by, .. }) => [1.0, by, 0.0, 0.0],
        Err(SolveError::Singular { .. }) => [2.0, 0.0, 0.0, 0.0],
        Err(SolveError::Invalid { .. }) => [3.0, 0.0, 0.0, 0.0],
        Err(SolveError::NotFinite { .. }) => [4.0, 0.0, 0.0, 0.0],
        Err(SolveError::NotCertified { .. }) => [12.0, 0.0, 0.0, 0.0],
        Err(error) => panic!("{error}"),
    }
}

fn conditions_agree(programs: &[Program], count: usize) {
    let mut random = Random(11);
    for is_single in [false, true] {
        let mut statuses = BTreeSet::new();
        for which in 20..=32 {
            let call = |_| Call { which, is_single, x: operands(&mut random, which, is_single) };
            let calls: Vec<Call> = (0..count).map(call).collect();
            let expected = compare(programs, &calls, |call| match is_single {
                false => diagnosed::<f64>(call),
                true => diagnosed::<f32>(call),
            });
            statuses.extend(expected.iter().map(|answer| answer[0] as i32));
        }
        assert_eq!(statuses, BTreeSet::from([0, 1, 2, 3, 4, 12]));
    }
}

/// As strict C99, by a part of the calls that `.ci/nightly` makes, which also takes C++17.
#[test]
fn strict_c_agrees() {
    let programs = programs(&[("cc", "strict", &STRICT)]);
    all_agree::<Plain>(&programs, 8);
    angles::agree(&programs, 20_000);
    library_functions::agree::<Plain>(&programs, 2_500);
}

#[test]
#[ignore = "minutes: `.ci/nightly` takes it"]
fn strict_c_and_cpp_agree_at_length() {
    let cpp =
        ["-x", "c++", "-std=c++17", "-pedantic", "-Wall", "-Wextra", "-Wshadow", "-Wconversion"];
    let programs = programs(&[
        ("cc", "strict_at_length", &STRICT),
        ("clang", "clang", &STRICT),
        ("g++", "cpp", &cpp),
    ]);
    all_agree::<Plain>(&programs, 1);
    library_functions::agree::<Plain>(&programs, 20_000);
}

/// Also where the compiler may contract a product into a sum, and where operations are fused.
#[test]
#[ignore = "minutes: `.ci/nightly` takes it"]
fn fused_c_agrees() {
    if !cfg!(target_arch = "x86_64") || !std::is_x86_feature_detected!("fma") {
        skipped("fused C: no fused operations");
        return;
    }
    let compilers = [("cc", "fused", &CONTRACTING[..]), ("clang", "clang_fused", &CONTRACTING)];
    all_agree::<Fused>(&programs(&compilers), 1);
}

fn programs(compilers: &[(&str, &str, &[&str])]) -> Vec<Program> {
    compilers.iter().filter_map(|(cc, name, flags)| program(cc, name, flags)).collect()
}

/// All but the library's functions, by a share of the calls.
fn all_agree<F: Fusion>(programs: &[Program], share: usize) {
    functions_agree::<F>(programs, 20_000 / share);
    conditions_agree(programs, 20_000 / share);
    roots_agree(programs, 5_000 / share.min(4));
}
