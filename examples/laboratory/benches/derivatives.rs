//! The cost of exact derivatives: `cargo bench -p laboratory --bench derivatives`.
//!
//! Every way to a mechanism's derivatives runs on the same inputs, all ways in turn, round after
//! round. Reported is the median over the rounds of a way's time over that of the position in the
//! same round, so that what else the machine does cancels out.

use laboratory::race::{Race, calls};
use linkage_core::nalgebra::SVector;
use linkage_core::num_dual::{Derivative, Dual64, DualSVec};
use linkage_core::{Real, Scalar, SolveError, differentiate_twice, mechanism};

mechanism! {
    /// A crank-rocker with a coupler point; its four lengths are parameters.
    pub struct FourBar {
        input theta: angle;
        param crank = 1m;
        param coupler = 3.2m;
        param rocker = 2.4m;
        param base = 3m;

        ground A(0, 0), D(base, 0.4m);
        crank AB(A) -> B        { length: crank, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (coupler, rocker), mode: left }
        point P on BC at (1.7m, -0.4m);
        output P, DC;
    }
}

mechanism! {
    /// The inverse of a two-link arm: joint angles from the hand's place.
    pub struct Arm {
        input x, y: length;
        param upper = 1m;
        param fore = 1.25m;

        ground A(0, 0);
        point P at (x, y);
        rrr AC(A), PC(P) -> C { lengths: (upper, fore), mode: left }
        output AC, PC;
    }
}

mechanism! {
    /// A Stephenson six-bar whose coupler point drives a second rocker.
    pub struct SixBar {
        input theta: angle;
        param crank = 80mm;
        param coupler = 260mm;
        param rocker = 200mm;
        param ex = 150mm;
        param ey = 110mm;
        param link = 180mm;
        param lever = 140mm;
        param zero = 0deg;

        ground A(0, 0), D(300mm, 0), G(150mm, 350mm);
        crank AB(A) -> B        { length: crank, angle: theta + zero }
        rrr   BC(B), DC(D) -> C { lengths: (coupler, rocker), mode: left }
        point E on BC at (ex, ey);
        rrr   EF(E), GF(G) -> F { lengths: (link, lever), mode: right }
        output E, F, GF;
    }
}

/// Inputs of one round.
const INPUTS: u32 = 256;

const ROUNDS: usize = 400;

/// A central difference's step that balances its truncation and its rounding.
const STEP: f64 = 6e-6;

/// One way: a name, and what it sums up of its results at one input.
type Way = (&'static str, Box<dyn Fn(f64) -> Result<f64, SolveError>>);

/// Runs the ways in turn and prints their times over the first one's.
fn compare<const WAYS: usize>(title: &str, ways: [Way; WAYS]) {
    let mut race = Race::default();
    let inputs: Vec<f64> = (0..INPUTS).map(|input| 0.02 * f64::from(input)).collect();
    for (name, way) in ways {
        assert!(way(0.5).is_ok(), "{title}: {name}");
        race.enter(name, calls(inputs.clone(), way));
    }
    println!("{title}");
    for timing in race.run(ROUNDS, |_| {}) {
        println!("  {:42} {:6.2}  {:8.1} ns", timing.name, timing.ratio, timing.nanoseconds);
    }
}

/// The sum of all slopes of the rows by N numbers, each by a central difference.
fn by_differences<const N: usize, const OUT: usize>(
    at: [f64; N],
    rows: impl Fn([f64; N]) -> Result<[f64; OUT], SolveError>,
) -> Result<f64, SolveError> {
    let mut sum = 0.0;
    for column in 0..N {
        let [mut ahead, mut behind] = [at, at];
        ahead[column] += STEP;
        behind[column] -= STEP;
        let (ahead, behind) = (rows(ahead)?, rows(behind)?);
        for row in 0..OUT {
            sum += (ahead[row] - behind[row]) / (2.0 * STEP);
        }
    }
    Ok(sum)
}

/// A dual number with one derivative.
trait One: Real {
    fn new(value: f64, slope: f64) -> Self;
    fn slope(self) -> f64;
}

impl One for Dual64 {
    #[inline]
    fn new(value: f64, slope: f64) -> Self {
        Self::new(value, slope)
    }
    #[inline]
    fn slope(self) -> f64 {
        self.eps
    }
}

impl One for DualSVec<f64, 1> {
    #[inline]
    fn new(value: f64, slope: f64) -> Self {
        Self::new(value, Derivative::some(SVector::from([slope])))
    }
    #[inline]
    fn slope(self) -> f64 {
        self.eps.unwrap()
    }
}

/// The same with a dual number of one derivative for each number in turn.
fn by_columns<D: One, const N: usize, const OUT: usize>(
    at: [f64; N],
    rows: impl Fn([D; N]) -> Result<[D; OUT], SolveError>,
) -> Result<f64, SolveError> {
    let mut sum = 0.0;
    for column in 0..N {
        let seed = |i| D::new(at[i], if i == column { 1.0 } else { 0.0 });
        sum += rows(core::array::from_fn(seed))?.iter().map(|row| row.slope()).sum::<f64>();
    }
    Ok(sum)
}

fn four_bar() {
    let bars = FourBar::new();
    let FourBar { crank, coupler, rocker, base } = bars;
    let lengths = [crank, coupler, rocker, base];
    compare(
        "four-bar: 3 outputs, 1 input, 4 parameters",
        [
            (
                "position, its angle included",
                Box::new(move |t| Ok(bars.position(t)?.rows().iter().sum())),
            ),
            ("velocity", Box::new(move |t| Ok(bars.velocity(t, 1.0)?.rows().iter().sum()))),
            ("coefficients", Box::new(move |t| Ok(bars.coefficients(t)?.iter().flatten().sum()))),
            ("jacobian", Box::new(move |t| Ok(bars.jacobian(t)?.sum()))),
            (
                "  with Dual64",
                Box::new(move |t| {
                    by_columns::<Dual64, _, _>([t], |[t]| Ok(bars.lift().position(t)?.rows()))
                }),
            ),
            (
                "  by central differences",
                Box::new(move |t| by_differences([t], |[t]| Ok(bars.position(t)?.rows()))),
            ),
            ("sensitivity", Box::new(move |t| Ok(bars.sensitivity(t)?.sum()))),
            (
                "  with Dual64, column by column",
                Box::new(move |t| {
                    by_columns::<Dual64, _, _>(lengths, |[crank, coupler, rocker, base]| {
                        let bars = FourBar { crank, coupler, rocker, base };
                        Ok(bars.position(t.into())?.rows())
                    })
                }),
            ),
            (
                "  by central differences",
                Box::new(move |t| {
                    by_differences(lengths, |[crank, coupler, rocker, base]| {
                        Ok(FourBar { crank, coupler, rocker, base }.position(t)?.rows())
                    })
                }),
            ),
            (
                "P.x twice, by input and parameters",
                Box::new(move |t| {
                    let at = [t, crank, coupler, rocker, base];
                    let found = differentiate_twice(at, |[t, crank, coupler, rocker, base]| {
                        Ok(FourBar { crank, coupler, rocker, base }.position(t)?.P.x)
                    })?;
                    Ok(found.hessian.sum())
                }),
            ),
        ],
    );
}

fn arm() {
    let arm = Arm::new();
    let at = |t: f64| [1.2 + 0.15 * t, 0.3];
    compare(
        "arm: 2 outputs, 2 inputs",
        [
            (
                "position, its angles included",
                Box::new(move |t| Ok(arm.position(at(t))?.rows().iter().sum())),
            ),
            (
                "coefficients",
                Box::new(move |t| Ok(arm.coefficients(at(t))?.iter().flatten().sum())),
            ),
            ("jacobian", Box::new(move |t| Ok(arm.jacobian(at(t))?.sum()))),
            (
                "  with Dual64, column by column",
                Box::new(move |t| {
                    by_columns::<Dual64, _, _>(at(t), |at| Ok(arm.lift().position(at)?.rows()))
                }),
            ),
            (
                "  by central differences",
                Box::new(move |t| by_differences(at(t), |at| Ok(arm.position(at)?.rows()))),
            ),
        ],
    );
}

fn six_bar() {
    let bars = SixBar::new();
    let SixBar { crank, coupler, rocker, ex, ey, link, lever, zero } = bars;
    let dimensions = [crank, coupler, rocker, ex, ey, link, lever, zero];
    compare(
        "six-bar: 5 outputs, 1 input, 8 parameters",
        [
            (
                "position, its angle included",
                Box::new(move |t| Ok(bars.position(t)?.rows().iter().sum())),
            ),
            ("coefficients", Box::new(move |t| Ok(bars.coefficients(t)?.iter().flatten().sum()))),
            ("jacobian", Box::new(move |t| Ok(bars.jacobian(t)?.sum()))),
            ("sensitivity", Box::new(move |t| Ok(bars.sensitivity(t)?.sum()))),
            (
                "  with Dual64, column by column",
                Box::new(move |t| {
                    by_columns::<Dual64, _, _>(
                        dimensions,
                        |[crank, coupler, rocker, ex, ey, link, lever, zero]| {
                            let bars = SixBar { crank, coupler, rocker, ex, ey, link, lever, zero };
                            Ok(bars.position(t.into())?.rows())
                        },
                    )
                }),
            ),
            (
                "  with DualSVec64<1>, column by column",
                Box::new(move |t| {
                    by_columns::<DualSVec<f64, 1>, _, _>(
                        dimensions,
                        |[crank, coupler, rocker, ex, ey, link, lever, zero]| {
                            let bars = SixBar { crank, coupler, rocker, ex, ey, link, lever, zero };
                            Ok(bars.position(Scalar::lit(t, t as f32))?.rows())
                        },
                    )
                }),
            ),
            (
                "  by central differences",
                Box::new(move |t| {
                    by_differences(
                        dimensions,
                        |[crank, coupler, rocker, ex, ey, link, lever, zero]| {
                            let bars = SixBar { crank, coupler, rocker, ex, ey, link, lever, zero };
                            Ok(bars.position(t)?.rows())
                        },
                    )
                }),
            ),
        ],
    );
}

fn main() {
    println!("time over the position's, and median time");
    four_bar();
    arm();
    six_bar();
}
