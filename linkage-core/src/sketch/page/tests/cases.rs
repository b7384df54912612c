//! Questions with the crate's own answers.

use core::fmt;
use std::format;
use std::string::{String, ToString};
use std::vec;
use std::vec::Vec;

use crate::diagnosis::{
    Diagnosis, Nonzero, NotNegative, Positive, ReachCircles, ReachDistances, ReachLine,
    ReachOffset, ShareOfCentres, Square, SquareOfCentres,
};
use crate::kernels::{Native, det, exact_sum, mul_err, two_sum};
use crate::{Scalar, SolveError};

/// A function of the script, its arguments and the expected answer.
pub(super) struct Case {
    pub name: &'static str,
    pub given: Vec<f64>,
    pub answer: String,
}

impl fmt::Display for Case {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name)?;
        self.given.iter().try_for_each(|x| write!(f, " {:016x}", x.to_bits()))?;
        write!(f, " : {}", self.answer)
    }
}

pub(super) fn bits(x: f64) -> String {
    if x.is_nan() { "NaN".to_string() } else { format!("{:016x}", x.to_bits()) }
}

/// Random numbers by a multiplicative congruence.
pub(super) struct Random(u64);

impl Random {
    pub(super) fn new(seed: u64) -> Self {
        Self(seed)
    }

    pub(super) fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        // The low bits of a congruence have short periods.
        self.0.rotate_left(32)
    }

    /// From 0 to 1.
    pub(super) fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// A number of any sign and of a size from 2^−`range` to 2^`range`.
    fn wide(&mut self, range: f64) -> f64 {
        let size = ((2.0 * self.unit() - 1.0) * range).exp2() * (1.0 + self.unit());
        if self.bits() & 1 == 0 { size } else { -size }
    }

    /// The number up to eight units in the last place away.
    pub(super) fn beside(&mut self, x: f64) -> f64 {
        f64::from_bits(x.to_bits().wrapping_add(self.bits() % 17).wrapping_sub(8))
    }

    fn angle(&mut self) -> (f64, f64) {
        (core::f64::consts::TAU * self.unit()).sin_cos()
    }
}

const SPECIAL: [f64; 10] =
    [0.0, -0.0, 1.0, -1.0, 0.5, -0.5, f64::INFINITY, f64::NEG_INFINITY, f64::NAN, 5e-324];

/// Functions of one or two numbers, sums and products.
pub(super) fn kernels() -> impl Iterator<Item = Case> {
    let mut random = Random(7);
    let mut cases = Vec::new();
    for nth in 0..20_000 {
        let x = match nth % 4 {
            0 => SPECIAL[nth / 4 % SPECIAL.len()],
            1 => random.wide(19.9),
            // Next to quarter turns sine or cosine cancel.
            2 => {
                let quarter = (random.unit() * 4000.0).floor() * core::f64::consts::FRAC_PI_2;
                random.beside(quarter)
            }
            _ => random.wide(600.0),
        };
        let y = if nth % 5 == 0 { SPECIAL[nth / 5 % SPECIAL.len()] } else { random.wide(30.0) };
        let (sin, cos) = x.sin_cos_of_the_crate();
        cases.push(Case::of("sinCos", [x], [sin, cos]));
        let share = if nth % 4 == 0 { x } else { 2.0 * random.unit() - 1.0 };
        cases.push(Case::of("asin", [share], [Scalar::asin(share)]));
        cases.push(Case::of("acos", [share], [Scalar::acos(share)]));
        cases.push(Case::of("atan", [y], [Scalar::atan(y)]));
        cases.push(Case::of("atan2", [y, x], [Scalar::atan2(y, x)]));
        cases.push(Case::of("hypot", [x, y], [Scalar::hypot(x, y)]));
        let power = if nth % 4 == 3 { 800.0 * random.unit() - 400.0 } else { x };
        cases.push(Case::of("exp", [power], [Scalar::exp(power)]));
        cases.push(Case::of("tanh", [power], [Scalar::tanh(power)]));
        cases.push(Case::of("ln", [x], [Scalar::ln(x)]));
        cases.push(Case::of("pow", [x.abs(), 3.0 * share], [Scalar::pow(x.abs(), 3.0 * share)]));
        let [a, b, c] = core::array::from_fn(|_| random.wide(40.0));
        let d = random.beside(a * b / c);
        cases.push(Case::of("mulErr", [a, b], [mul_err::<f64, Native>(a, b)]));
        cases.push(Case::of("addErr", [a, b], [two_sum(a, b).1]));
        cases.push(Case::of("det", [a, b, c, d], [det::<f64, Native>(a, b, c, d)]));
        let terms = [a * b, -c * d, a, -a, c, b, -c];
        cases.push(Case::of("exactSum", terms, [exact_sum(terms)]));
    }
    cases.into_iter()
}

/// The crate's function beside the standard library's of the same name.
trait OfTheCrate {
    fn sin_cos_of_the_crate(self) -> (f64, f64);
}

impl OfTheCrate for f64 {
    fn sin_cos_of_the_crate(self) -> (f64, f64) {
        Scalar::sin_cos(self)
    }
}

impl Case {
    fn of<const N: usize, const M: usize>(
        name: &'static str,
        given: [f64; N],
        answer: [f64; M],
    ) -> Self {
        let answer: Vec<String> = answer.into_iter().map(bits).collect();
        Self { name, given: given.into(), answer: answer.join(" ") }
    }

    /// A condition on a value.
    fn asked<const N: usize>(
        name: &'static str,
        value: f64,
        operands: [f64; N],
        diagnosis: impl Diagnosis<f64>,
    ) -> Self {
        let answer = match diagnosis.diagnose(value) {
            Ok(value) => bits(value),
            Err(SolveError::OutOfReach { group, by }) => format!("OutOfReach {group} {}", bits(by)),
            Err(SolveError::Singular { group }) => format!("Singular {group}"),
            Err(SolveError::Invalid { group, .. }) => format!("Invalid {group}"),
            Err(SolveError::NotFinite { name }) => format!("NotFinite {name}"),
            Err(other) => panic!("{other:?}"),
        };
        let given = [&[value][..], &operands].concat();
        Self { name, given, answer }
    }
}

const GROUP: &str = "group";

/// Every condition, mostly within eight units in the last place of its limit, of lengths of all sizes.
pub(super) fn conditions() -> impl Iterator<Item = Case> {
    let mut random = Random(11);
    (0..10_000).flat_map(move |nth| {
        // Most machines are of metres; subnormal and enormous lengths have to be scaled.
        let size = if nth % 8 == 0 { random.wide(500.0).abs() } else { random.wide(3.0).abs() };
        let mut cases = about_circles(&mut random, size);
        cases.extend(about_lines(&mut random, size));
        cases.extend(about_sizes(&mut random));
        cases
    })
}

fn about_circles(random: &mut Random, size: f64) -> Vec<Case> {
    let l1 = size * (0.1 + random.unit());
    // Equal radii meet where the centres coincide.
    let l2 = if random.bits().is_multiple_of(5) { l1 } else { size * (0.1 + random.unit()) };
    let (sin, cos) = random.angle();
    let apart = match random.bits() % 6 {
        0 => l1 + l2 + size * random.unit(),
        1 | 2 => (l1 - l2).abs(),
        _ => l1 + l2,
    };
    let [dx, dy] = [apart * cos, apart * sin].map(|x| random.beside(x));
    let d2 = dx * dx + dy * dy;
    let four = 4.0 * l1 * l2;
    let unit = if random.bits().is_multiple_of(2) { 1.0 } else { 2.0 * l1 * l2 };
    let of = |unit: f64| {
        (d2 - (l1 - l2) * (l1 - l2)) / four * (((l1 + l2) * (l1 + l2) - d2) / four) * unit * unit
    };
    let (value, spread) = (of(unit), d2 / four * unit * unit);
    let share = 0.5 * ((d2 + (l1 - l2) * (l1 + l2)) / d2);
    let height = of(1.0);
    let (r1, r2) = (l1, l2);
    let l = random.beside(apart);
    let square = of(1.0) * 4.0 * r1 * r1 * (r2 / l) * (r2 / l);
    let wide = random.unit() * spread;
    vec![
        Case::asked(
            "ReachCircles",
            value,
            [dx, dy, l1, l2, unit, spread],
            ReachCircles([dx, dy, l1, l2, unit, spread], GROUP),
        ),
        Case::asked(
            "ShareOfCentres",
            share,
            [height, dx, dy, l1, l2, wide],
            ShareOfCentres([height, dx, dy, l1, l2, wide], GROUP),
        ),
        Case::asked(
            "ReachDistances",
            square,
            [l, r1, r2, l * l],
            ReachDistances([l, r1, r2, l * l], GROUP),
        ),
        Case::asked(
            "SquareOfCentres",
            d2,
            [dx, dy, l1, l2],
            SquareOfCentres([dx, dy, l1, l2], GROUP),
        ),
    ]
}

fn about_lines(random: &mut Random, size: f64) -> Vec<Case> {
    let l = size * (0.1 + random.unit());
    let sign = if random.bits().is_multiple_of(2) { 1.0 } else { -1.0 };
    let t = random.beside(sign * l);
    let (sin, cos) = random.angle();
    let [bx, by] = [l * cos, l * sin].map(|x| random.beside(x));
    vec![
        Case::asked("ReachLine", (l - t) * (l + t), [t, l], ReachLine([t, l], GROUP)),
        Case::asked(
            "ReachOffset",
            bx * bx + by * by - t * t,
            [bx, by, t],
            ReachOffset([bx, by, t], GROUP),
        ),
    ]
}

/// Numbers of any bits: also infinite, subnormal and not a number.
fn about_sizes(random: &mut Random) -> Vec<Case> {
    let x = match random.bits() % 3 {
        0 => SPECIAL[(random.bits() % 10) as usize],
        1 => f64::from_bits(random.bits()),
        _ => random.beside(f64::smallest_square()),
    };
    let circles = [x, random.unit(), random.wide(500.0), random.unit(), 1.0, 1.0];
    vec![
        Case::asked("Square", x, [], Square(GROUP)),
        Case::asked("Nonzero", x, [], Nonzero(GROUP)),
        Case::asked("Positive", x, [], Positive(GROUP, GROUP)),
        Case::asked("NotNegative", x, [], NotNegative(GROUP, GROUP)),
        Case::asked("ReachLine", x, [x, 1.0], ReachLine([x, 1.0], GROUP)),
        Case::asked("ReachCircles", x, circles, ReachCircles(circles, GROUP)),
    ]
}
