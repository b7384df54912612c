//! The answer of a group at a pose, its error, and the error that its data allow.
//!
//! The truth is the same code on numbers of twice the width; that the formulas are right is shown
//! elsewhere. What the data allow: every input, rate and dimension changed by half a unit in its
//! last place, effects added up, and half a unit in the last place of the answer. The effects come
//! from dual numbers, the largest within a unit of the data. Where they double within a unit, so
//! close to a limit, the data do not determine an answer, and none is measured.
#![allow(dead_code, reason = "each user measures some of the groups")]

pub mod families;
pub mod poses;

use core::array::from_fn;
use linkage_core::{Record, Scalar, Sense, Side};
use num_dual::{Derivative, DualSVec};

use crate::double_double::DoubleDouble;
use crate::mechanisms::driven_groups::*;
use crate::mechanisms::heavy_groups::*;
use crate::mechanisms::near_limits::*;

/// Inputs with their rates, the dimensions, and the mode.
#[derive(Clone, Copy, Debug)]
pub struct Pose<const I: usize, const P: usize> {
    pub q: [f64; I],
    pub rate: [f64; I],
    pub second: [f64; I],
    pub params: [f64; P],
    /// `left` or `ahead`.
    pub plus: bool,
}

/// One number of an answer.
#[derive(Clone, Copy, Debug, Default)]
pub struct Measured {
    pub error: f64,
    pub achievable: f64,
}

impl Measured {
    pub fn ratio(self) -> f64 {
        if self.error == 0.0 { 0.0 } else { self.error / self.achievable }
    }
}

/// The width of the numbers that are measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Width {
    Double,
    Single,
}

impl Width {
    /// The nearest number of this width.
    pub fn round(self, value: f64) -> f64 {
        match self {
            Self::Double => value,
            Self::Single => f64::from(value as f32),
        }
    }

    /// Half the distance from 1 to the next number.
    pub fn half_unit(self) -> f64 {
        match self {
            Self::Double => f64::EPSILON / 2.0,
            Self::Single => f64::from(f32::EPSILON) / 2.0,
        }
    }
}

impl<const I: usize, const P: usize> Pose<I, P> {
    /// The pose with all its numbers rounded to a width.
    pub fn rounded(self, width: Width) -> Self {
        let list = |values: [f64; I]| values.map(|value| width.round(value));
        let (q, rate, second) = (list(self.q), list(self.rate), list(self.second));
        Self { q, rate, second, params: self.params.map(|value| width.round(value)), ..self }
    }

    fn all<T>(&self, mut number: impl FnMut(usize, f64) -> T) -> Numbers<T, I, P> {
        Numbers {
            q: from_fn(|i| number(i, self.q[i])),
            rate: from_fn(|i| number(I + i, self.rate[i])),
            second: from_fn(|i| number(2 * I + i, self.second[i])),
            params: from_fn(|i| number(3 * I + i, self.params[i])),
        }
    }
}

struct Numbers<T, const I: usize, const P: usize> {
    q: [T; I],
    rate: [T; I],
    second: [T; I],
    params: [T; P],
}

/// A point is one quantity: a component may be small by chance, and then it may be wrong by what
/// the data allow the other.
fn join_points(outputs: &[&str], rows: &mut [Measured]) {
    for (row, _) in outputs.iter().enumerate().filter(|(_, output)| output.ends_with(".x")) {
        let (x, y) = (rows[row], rows[row + 1]);
        let point = Measured {
            error: x.error.hypot(y.error),
            achievable: x.achievable.hypot(y.achievable),
        };
        (rows[row], rows[row + 1]) = (point, point);
    }
}

/// By how many units a number moves: at turn 0 it stays, then all of them move at once, each its
/// own way.
fn moved(number: usize, turn: usize) -> f64 {
    let bits = (number + 1).wrapping_mul(0x9e37_79b9).wrapping_mul(2 * turn + 1) >> 7;
    if turn == 0 { 0.0 } else { [-1.0, 1.0][bits % 2] }
}

fn total<const ROWS: usize>(effects: &[[f64; ROWS]; 3]) -> f64 {
    effects.iter().flatten().sum()
}

/// The gradient's effect of half a unit in the last place of everything.
fn allowed<const N: usize>(value: &DualSVec<f64, N>, data: &[f64; N], half_unit: f64) -> f64 {
    let effects = match &value.eps {
        Derivative(Some(gradient)) => {
            data.iter().enumerate().map(|(i, x)| (gradient[i] * x).abs()).sum()
        }
        _ => 0.0,
    };
    half_unit * (effects + value.re.abs())
}

/// One input is given as itself, several as a list.
macro_rules! given {
    (input $list:ident) => {
        $list[0]
    };
    (inputs $list:ident) => {
        $list
    };
}

macro_rules! labels {
    (motion $mechanism:ident) => {
        $mechanism::OUTPUTS
    };
    (forces $mechanism:ident) => {
        $mechanism::FORCES
    };
}

/// The three rows of results: positions, velocities and accelerations of a motion; the forces at rest, twice,
/// and those in motion.
macro_rules! orders {
    (motion $solver:ident, $q:expr, $rate:expr, $second:expr) => {{
        let (m, ok) = $solver.solve_motion($q, $rate, $second);
        ok.then(|| [m.position.rows(), m.velocity.rows(), m.acceleration.rows()])
    }};
    (forces $solver:ident, $q:expr, $rate:expr, $second:expr) => {{
        let (resting, still) = $solver.solve_statics($q);
        let (moving, ok) = $solver.solve_forces($q, $rate, $second);
        let resting = resting.into_array();
        (still && ok).then(|| [resting, resting, moving.into_array()])
    }};
}

macro_rules! measured {
    ($(#[$doc:meta])* $function:ident: $kind:ident of $mechanism:ident, $inputs:literal $count:ident,
     $params:literal $(params)? $(param)? { $($param:ident)* } $(, $mode:ident $Mode:ident $plus:ident $minus:ident)?) => {
        $(#[$doc])*
        pub mod $function {
            use super::*;

            /// The names of the rows.
            pub const LABELS: &[&str] = &labels!($kind $mechanism);
            pub const ROWS: usize = LABELS.len();

            /// The measured results, if the solver answers.
            fn rows<T: Scalar<Mask = bool>>(
                numbers: Numbers<T, $inputs, $params>,
                plus: bool,
            ) -> Option<[[T; ROWS]; 3]> {
                let [$($param),*] = numbers.params;
                let solver = $mechanism::<T> {
                    $($param,)*
                    $($mode: if plus { $Mode::$plus } else { $Mode::$minus },)?
                };
                let _ = plus;
                let Numbers { q, rate, second, .. } = numbers;
                orders!($kind solver, given!($count q), given!($count rate), given!($count second))
            }

            /// The change of every row by half a unit in the last place of every number, at data moved by
            /// units.
            fn effects(
                pose: &Pose<$inputs, $params>,
                half_unit: f64,
                turn: usize,
            ) -> Option<[[f64; ROWS]; 3]> {
                const DATA: usize = 3 * $inputs + $params;
                let seed = |i: usize, x: f64| {
                    let x = x * (1.0 + 2.0 * half_unit * moved(i, turn));
                    DualSVec::<f64, DATA>::from_re(x).derivative(i)
                };
                let mut data = [0.0; DATA];
                pose.all(|i, x| data[i] = x);
                let duals = rows(pose.all(seed), pose.plus)?;
                Some(duals.map(|rows| rows.map(|row| allowed(&row, &data, half_unit))))
            }

            /// The truth of every row, rounded.
            pub fn truth(pose: &Pose<$inputs, $params>) -> Option<[[f64; ROWS]; 3]> {
                let orders = rows(pose.all(|_, x| DoubleDouble::<false>::new(x)), pose.plus)?;
                Some(orders.map(|rows| rows.map(|row| row.high)))
            }

            /// Every row of position, velocity and acceleration; none where there is no pose or no
            /// velocity, or none that the data determine.
            pub fn measure(
                pose: &Pose<$inputs, $params>,
                width: Width,
            ) -> Option<[[Measured; ROWS]; 3]> {
                let duals = effects(pose, width.half_unit(), 0)?;
                let (found, truth): ([[f64; ROWS]; 3], [[[f64; 2]; ROWS]; 3]) = match width {
                    Width::Double => (
                        rows(pose.all(|_, x| x), pose.plus)?,
                        rows(pose.all(|_, x| DoubleDouble::<false>::new(x)), pose.plus)?
                            .map(|order| order.map(|row| [row.high, row.low])),
                    ),
                    Width::Single => (
                        rows(pose.all(|_, x| x as f32), pose.plus)?
                            .map(|order| order.map(f64::from)),
                        rows(pose.all(|_, x| DoubleDouble::<true>::new(x)), pose.plus)?
                            .map(|order| order.map(|row| [row.high, row.low])),
                    ),
                };
                let mut orders = from_fn(|order| {
                    from_fn(|row| {
                        let [high, low] = truth[order][row];
                        let is_angle = order == 0 && LABELS[row].ends_with("angle");
                        let away = found[order][row] - high;
                        let turns = if is_angle { (away / core::f64::consts::TAU).round() } else { 0.0 };
                        Measured {
                            error: (away - turns * core::f64::consts::TAU - low).abs(),
                            achievable: duals[order][row],
                        }
                    })
                });
                let joined = |mut orders: [[Measured; ROWS]; 3]| {
                    orders.iter_mut().for_each(|rows| join_points(LABELS, rows));
                    orders
                };
                let is_large = |row: &Measured| row.ratio() > 2.0;
                if joined(orders).iter().flatten().any(is_large) {
                    for turn in 1..5 {
                        let moved = effects(pose, width.half_unit(), turn)?;
                        if !(0.5..2.0).contains(&(total(&moved) / total(&duals))) {
                            return None;
                        }
                        for (row, dual) in orders.iter_mut().flatten().zip(moved.iter().flatten()) {
                            row.achievable = row.achievable.max(*dual);
                        }
                    }
                }
                Some(joined(orders))
            }
        }
    };
}

measured! {
    /// Two bars between driven points.
    rrr: motion of DrivenRrr, 4 inputs, 2 params { l1 l2 }, elbow Side Left Right
}
measured! {
    /// A bar between a driven point and a driven guide.
    rrp: motion of DrivenRrp, 5 inputs, 2 params { l e }, side Sense Ahead Behind
}
measured! {
    /// A bar about a driven point through a block on another.
    rpr: motion of DrivenRpr, 4 inputs, 1 param { e }, side Sense Ahead Behind
}
measured! {
    /// A pin between two driven guides.
    prp: motion of DrivenPrp, 6 inputs, 2 params { e1 e2 }
}
measured! {
    /// A yoke on a driven guide, its slot on a driven point.
    rpp: motion of DrivenRpp, 5 inputs, 3 params { slot e1 e2 }
}
measured! {
    /// Reactions of two bars.
    rrr_forces: forces of HeavyRrr, 4 inputs, 2 params { l1 l2 }, elbow Side Left Right
}
measured! {
    /// Reactions of a bar and a block.
    rrp_forces: forces of HeavyRrp, 5 inputs, 2 params { l e }, side Sense Ahead Behind
}
measured! {
    /// Reactions of a block on a bar.
    rpr_forces: forces of HeavyRpr, 4 inputs, 1 param { e }, side Sense Ahead Behind
}
measured! {
    /// Reactions of two blocks.
    prp_forces: forces of HeavyPrp, 6 inputs, 2 params { e1 e2 }
}
measured! {
    /// Reactions of a yoke.
    rpp_forces: forces of HeavyRpp, 5 inputs, 3 params { slot e1 e2 }
}
measured! {
    /// A press behind a crank-rocker.
    chained_press: motion of ChainedPress, 1 input, 12 params
        { rod dx dy kx ky slope crank_length coupler rocker ex ey e }
}
measured! {
    /// A four-bar on the rocker of another.
    chained_bars: motion of ChainedBars, 1 input, 9 params
        { l1 l2 dx dy gx gy crank_length coupler rocker }
}
measured! {
    /// Two bars with products carried to twice the width.
    compensated_rrr: motion of CompensatedRrr, 4 inputs, 2 params { l1 l2 }, elbow Side Left Right
}
