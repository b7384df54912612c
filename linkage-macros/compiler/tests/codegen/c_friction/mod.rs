//! The equations of friction in C beside those of the run-time crate: the same amounts, or the same joint that jams.
//!
//! Systems of one to eight amounts, their spectral radius on both sides of one; systems of absolute values alone,
//! some of which send Newton's steps round in a circle; some numbers are none, zero or out of range.

pub(crate) mod planted;

use std::collections::BTreeMap;

use super::c_program::{Program, STRICT, bits};
use super::c_run_time::Random;
use crate::codegen::c::run_time;
use linkage_core::private::{AllMet, Amounts, Checks, FirstError, Nonzero, System};
use linkage_core::{Real, SolveError};

const MOST: usize = 8;
const PLACES: usize = MOST * (3 + 2 * MOST);
const JOINTS: [&str; MOST] = ["0", "1", "2", "3", "4", "5", "6", "7"];

#[derive(Clone, Debug)]
struct Call {
    count: usize,
    guides: u32,
    is_single: bool,
    /// True if something else has failed before.
    has_failed: bool,
    rows: Vec<f64>,
    start: Vec<f64>,
}

/// An answer: `met` if straight-line steps end, their amounts, a status, the joint it names, the slow path's amounts.
#[derive(Debug, PartialEq)]
struct Answer {
    met: bool,
    fast: Vec<u64>,
    status: i32,
    joint: i32,
    found: Vec<u64>,
}

fn expected<T: Real<Mask = bool>, const W: usize, const M: usize>(call: &Call) -> Answer {
    let number = |x: f64| T::lit(x, x as f32);
    let rows = std::array::from_fn(|j| std::array::from_fn(|i| number(call.rows[j * W + i])));
    let start: [T; M] = std::array::from_fn(|j| number(call.start[j]));
    let system = System::<T, W, M> { rows, guides: call.guides };
    let amounts = Amounts { system, joints: std::array::from_fn(|j| JOINTS[j]) };
    let (mut compared, mut diagnosed) = (AllMet::<bool>::new(), FirstError::new());
    if call.has_failed {
        diagnosed.guard(number(0.0), Nonzero("group"));
    }
    let of = |amounts: [T; M]| amounts.map(|amount| bits(amount.value())).to_vec();
    let (fast, found) =
        (of(compared.amounts(start, amounts)), of(diagnosed.amounts(start, amounts)));
    let (status, joint) = match diagnosed.first() {
        Ok(()) => (0, "/"),
        Err(SolveError::Singular { .. }) => (2, "/"),
        Err(SolveError::NotFinite { name }) => (4, name),
        Err(SolveError::Jams { joint }) => (10, joint),
        Err(error) => panic!("{error}"),
    };
    let joint = i32::from(joint.as_bytes()[0]) - i32::from(b'0');
    Answer { met: compared.all(), fast, status, joint, found }
}

fn expected_of_any(call: &Call) -> Answer {
    match (call.count, call.is_single) {
        (1, false) => expected::<f64, 5, 1>(call),
        (1, true) => expected::<f32, 5, 1>(call),
        (2, false) => expected::<f64, 7, 2>(call),
        (2, true) => expected::<f32, 7, 2>(call),
        (3, false) => expected::<f64, 9, 3>(call),
        (3, true) => expected::<f32, 9, 3>(call),
        (4, false) => expected::<f64, 11, 4>(call),
        (4, true) => expected::<f32, 11, 4>(call),
        (_, false) => expected::<f64, 19, 8>(call),
        (_, true) => expected::<f32, 19, 8>(call),
    }
}

fn signed(random: &mut Random) -> f64 {
    2.0 * random.unit() - 1.0
}

/// An upper bound of the spectral radius, Collatz's: the largest growth of a component.
fn radius_at_most(call: &Call) -> f64 {
    let (count, width) = (call.count, call.rows.len() / call.count);
    let bound = |j: usize, k: usize| {
        let row = &call.rows[j * width..];
        let [x, y] = [row[3 + 2 * k], row[4 + 2 * k]];
        let size = if call.guides >> j & 1 == 1 { x.abs().max(y.abs()) } else { x.hypot(y) };
        row[0] * size
    };
    let (mut vector, mut largest) = (vec![1.0; count], 0.0);
    for _ in 0..40 {
        let grown = |j| (0..count).map(|k| bound(j, k) * vector[k]).sum::<f64>();
        let next: Vec<f64> = (0..count).map(grown).collect();
        let growth = next.iter().zip(&vector).map(|(next, last)| next / last);
        largest = growth.fold(0.0, f64::max);
        let size = next.iter().copied().fold(f64::MIN_POSITIVE, f64::max);
        vector = next.iter().map(|x| x / size).collect();
    }
    largest
}

/// A system of so many amounts; `of_values` if they are absolute values alone.
fn call(random: &mut Random, count: usize, is_single: bool, of_values: bool) -> Call {
    let width = 3 + 2 * count;
    let mut rows: Vec<f64> = (0..count * width).map(|_| signed(random)).collect();
    for row in rows.chunks_mut(width) {
        row[0] = row[0].abs();
        if of_values {
            row.iter_mut().skip(2).step_by(2).for_each(|second| *second = 0.0);
        }
    }
    let all = (1 << count) - 1;
    let guides = if of_values { all } else { random.below(all + 1) } as u32;
    let start = vec![0.0; count];
    let mut call = Call { count, guides, is_single, has_failed: false, rows, start };
    let rho = match of_values {
        true => 0.95 + 0.049 * random.unit(),
        false => random.pick(&[0.05, 0.4, 0.9, 0.999, 1.001, 1.5]) * (0.9 + 0.1 * random.unit()),
    };
    let scale = rho / radius_at_most(&call);
    for j in 0..count {
        call.rows[j * width] *= scale;
    }
    if random.below(12) == 0 {
        let at = random.below((count * width) as u64) as usize;
        call.rows[at] = random.pick(&[f64::NAN, f64::INFINITY, 0.0, -0.0, 1e300, 1e-310, 1e30]);
    }
    if is_single {
        call.rows.iter_mut().for_each(|x| *x = f64::from(*x as f32));
    }
    for j in 0..count {
        let row = &call.rows[j * width..];
        let [share, x, y] = [row[0], row[1], row[2]];
        let size =
            if call.guides >> j & 1 == 1 { x.abs().max(y.abs()) } else { (x * x + y * y).sqrt() };
        // Mostly where the steps begin; any other place is as good.
        let start = share * size * random.pick(&[1.0, 1.0, 1.0, 3.0]);
        call.start[j] = if is_single { f64::from(start as f32) } else { start };
    }
    call
}

fn answers(program: &Program, calls: &[Call]) -> Vec<Answer> {
    let mut bytes = Vec::new();
    for call in calls {
        let flags = [call.is_single, call.has_failed].map(i32::from);
        let head = [call.count as i32, call.guides as i32, flags[0], flags[1]];
        head.iter().for_each(|x| bytes.extend(x.to_ne_bytes()));
        for (numbers, places) in [(&call.rows, PLACES), (&call.start, MOST)] {
            let filled = numbers.iter().copied().chain(std::iter::repeat(0.0)).take(places);
            filled.for_each(|x| bytes.extend(x.to_ne_bytes()));
        }
    }
    let numbers = program.numbers(bytes);
    let answer = |(x, call): (&[f64], &Call)| {
        let amounts = |from: usize| x[from..from + call.count].iter().map(|&x| bits(x)).collect();
        Answer {
            met: x[0] == 1.0,
            fast: amounts(1),
            status: x[1 + MOST] as i32,
            joint: x[2 + MOST] as i32,
            found: amounts(3 + MOST),
        }
    };
    numbers.chunks(3 + 2 * MOST).zip(calls).map(answer).collect()
}

/// The statuses of the answers, which are the expected ones in every program.
fn statuses(programs: &[Program], calls: &[Call]) -> Vec<(i32, bool)> {
    let expected: Vec<_> = calls.iter().map(expected_of_any).collect();
    for (nth, program) in programs.iter().enumerate() {
        let found = answers(program, calls);
        assert_eq!(found.len(), calls.len());
        for ((call, found), expected) in calls.iter().zip(&found).zip(&expected) {
            assert_eq!(found, expected, "program {nth}, {call:?}");
        }
    }
    expected.iter().map(|answer| (answer.status, answer.met)).collect()
}

/// Also that every kind of answer is often met.
fn amounts_agree(programs: &[Program], share: usize) {
    let mut random = Random(29);
    let mut counts = BTreeMap::new();
    for (count, of_values, calls) in [
        (1, false, 6_000),
        (2, false, 6_000),
        (3, false, 8_000),
        (4, true, 30_000),
        (8, false, 4_000),
    ] {
        let calls: Vec<Call> = (0..calls / share)
            .map(|nth| call(&mut random, count, nth % 2 == 1, of_values))
            .collect();
        for status in statuses(programs, &calls) {
            *counts.entry(status).or_insert(0) += 1;
        }
    }
    let kinds = [(0, true), (0, false), (4, false), (10, false)];
    assert!(kinds.iter().all(|kind| counts[kind] > 500 / share), "{counts:?}");
    for is_single in [false, true] {
        statuses(programs, &planted::calls(is_single));
    }
}

fn program(compiler: &str, name: &str, flags: &[&str]) -> Option<Program> {
    let part = ("linkage_friction.c", run_time::friction_source());
    Program::compiled(compiler, &format!("friction_{name}"), flags, "friction.c", part)
}

/// As strict C99, by a quarter of the random systems that `.ci/nightly` solves.
#[test]
fn friction_in_c_agrees() {
    let programs: Vec<_> = program("cc", "cc", &STRICT).into_iter().collect();
    amounts_agree(&programs, 4);
}

#[test]
#[ignore = "minutes: `.ci/nightly` takes it"]
fn friction_in_c_of_every_compiler_agrees() {
    let strict = [("cc", "cc_at_length"), ("clang", "clang")];
    let strict = strict.into_iter().filter_map(|(compiler, name)| program(compiler, name, &STRICT));
    let mut programs: Vec<_> = strict.collect();
    // A compiler that may contract products into sums, whose run-time is told that nothing is fused.
    if cfg!(target_arch = "x86_64") && std::is_x86_feature_detected!("fma") {
        let contracting =
            ["-std=gnu17", "-march=x86-64-v3", "-U__FMA__", "-U__FP_FAST_FMA", "-U__FP_FAST_FMAF"];
        programs.extend(program("cc", "fused", &contracting));
    }
    amounts_agree(&programs, 1);
}
