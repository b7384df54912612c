//! The inputs at which constants bring groups to their limit exactly: found by poses over a turn of the only input, and
//! noted.

use std::f64::consts::{PI, TAU};

use crate::diagnostics::Diagnostics;
use crate::ir::posing::{Conditions, GuardedValue, Placing, SoughtRoot, UnknownWords};
use crate::model::mechanism::{Carrier, Mechanism, Touching};
use crate::model::touching;
use crate::reach::turn::degrees;

use super::{at_defaults, unknown_words};

/// The poses of a turn, and the halvings between two of them.
const POSES: u32 = 720;
const HALVINGS: u32 = 40;
/// The angle by which two inputs differ that are one.
const NEAR: f64 = 1e-6;

/// Finds the inputs of all of them, and notes where there are any.
pub(super) fn found(mechanism: &mut Mechanism, diagnostics: &mut Diagnostics) {
    let touchings = std::mem::take(&mut mechanism.touchings);
    if touchings.is_empty() || !turns_alone(mechanism) {
        return;
    }
    let program = super::placing(mechanism);
    let turn = PosedTurn::of(mechanism, Placing::new(&program));
    let with_inputs = |touching| Touching { inputs: turn.inputs(&touching), ..touching };
    let reached = touchings.into_iter().map(with_inputs);
    let reached: Vec<_> = reached.filter(|touching| !touching.inputs.is_empty()).collect();
    for found in &reached {
        let [message, reason] = touching::in_words(
            mechanism,
            found.group,
            &at(mechanism, found),
            found.is_parallelogram,
            mechanism.as_drawn.is_found,
        );
        let keyword = &mechanism.groups[found.group.index()].keyword;
        diagnostics.note_because(keyword.span(), message, reason);
    }
    mechanism.touchings = reached;
}

/// True if one angle is all that moves the machine.
fn turns_alone(mechanism: &Mechanism) -> bool {
    matches!(&mechanism.inputs[..], [input] if input.dimension.angle)
}

/// The input and its values.
fn at(mechanism: &Mechanism, found: &Touching) -> String {
    let angles: Vec<_> = found.inputs.iter().copied().map(degrees).collect();
    format!("`{}` = {}", mechanism.inputs[0].name, angles.join(" and "))
}

/// A mechanism in poses over a turn of its input.
struct PosedTurn<'a> {
    mechanism: &'a Mechanism,
    placing: Placing<'a>,
    unknowns: Vec<UnknownWords>,
    /// The numbers of each pose.
    poses: Vec<Vec<f64>>,
}

impl<'a> PosedTurn<'a> {
    fn of(mechanism: &'a Mechanism, placing: Placing<'a>) -> Self {
        let unknowns = unknown_words(mechanism);
        let mut turn = Self { mechanism, placing, unknowns, poses: Vec::new() };
        turn.poses = (0..=POSES).map(|pose| turn.numbers(input_at(pose))).collect();
        turn
    }

    fn numbers(&self, input: f64) -> Vec<f64> {
        let given = at_defaults(self.mechanism, &[input]);
        self.placing.numbers(&given, &self.unknowns, &mut AsComputed)
    }

    /// The values of the input over a turn at which the two bodies stand so to each other, in degrees.
    fn inputs(&self, touching: &Touching) -> Vec<f64> {
        let mut found = Vec::new();
        for &angle in &touching.angles {
            let off = |numbers: &[f64]| off(self.mechanism, touching, angle.to_radians(), numbers);
            let seen: Vec<f64> = self.poses.iter().map(|numbers| off(numbers)).collect();
            for (pose, ends) in (0..POSES).zip(seen.windows(2)) {
                let between = [pose, pose + 1].map(input_at);
                found.extend(crossing(
                    |input| off(&self.numbers(input)),
                    between,
                    [ends[0], ends[1]],
                ));
            }
        }
        // Half a turn is the same forwards and backwards.
        let forwards = |input: f64| if input < NEAR - PI { input + TAU } else { input };
        let mut found: Vec<f64> = found.into_iter().map(forwards).collect();
        found.sort_by(f64::total_cmp);
        found.dedup_by(|a, b| (*a - *b).abs() < NEAR);
        found.into_iter().map(f64::to_degrees).collect()
    }
}

fn input_at(pose: u32) -> f64 {
    (f64::from(pose) / f64::from(POSES) - 0.5) * TAU
}

/// Where an angle passes zero between two inputs, or is zero at the first; it is known at both.
fn crossing(
    off: impl Fn(f64) -> f64,
    [mut from, mut to]: [f64; 2],
    [start, end]: [f64; 2],
) -> Option<f64> {
    /// A quarter of a turn: what jumps by more passes half a turn.
    const QUARTER: f64 = 0.5 * PI;
    let is_passed = (start <= 0.0 && end > 0.0) || (start >= 0.0 && end < 0.0);
    if !(is_passed && start.abs() < QUARTER && end.abs() < QUARTER) {
        return None;
    }
    for _ in 0..HALVINGS {
        let middle = 0.5 * (from + to);
        match off(middle) {
            value if value.is_nan() => return None,
            value if (value > 0.0) == (end > 0.0) => to = middle,
            _ => from = middle,
        }
    }
    Some(0.5 * (from + to))
}

/// The angle between both bodies less that at the limit, within half a turn; not a number where there is no pose.
fn off(mechanism: &Mechanism, touching: &Touching, angle: f64, numbers: &[f64]) -> f64 {
    let [[x0, y0], [x1, y1]] = [touching.hinge, touching.on]
        .map(|point| [numbers[2 * point.index()], numbers[2 * point.index() + 1]]);
    let (dx, dy) = (x1 - x0, y1 - y0);
    let [cos, sin] = match touching.against {
        Carrier::Ground => [1.0, 0.0],
        Carrier::Link(link) => {
            let first = 2 * mechanism.points.len() + 5 * link.index() + 2;
            [numbers[first], numbers[first + 1]]
        }
    };
    let seen = (cos * dy - sin * dx).atan2(cos * dx + sin * dy) - angle;
    seen - TAU * (seen / TAU).round()
}

/// Conditions that are not asked: where a pose does not exist its numbers are none.
struct AsComputed;

impl Conditions for AsComputed {
    fn guard(&mut self, condition: &GuardedValue<'_>) -> f64 {
        condition.value
    }

    fn closed(&mut self, _: &GuardedValue<'_>) {}

    /// By halving, in the first of some parts of the interval that holds a root of the trend.
    fn root(
        &mut self,
        sought: &SoughtRoot<'_>,
        sides: &mut dyn FnMut(f64) -> [f64; 3],
    ) -> [f64; 2] {
        const PARTS: u32 = 32;
        let [from, to] = sought.between;
        let sign = if sought.rises { 1.0 } else { -1.0 };
        let mut difference = |x: f64| {
            let [left, right, _] = sides(x);
            sign * (left - right)
        };
        let at = |part: u32| from + (to - from) * f64::from(part) / f64::from(PARTS);
        let rises = (0..PARTS).map(|part| [at(part), at(part + 1)]).find(|ends| {
            let [a, b] = ends.map(&mut difference);
            a <= 0.0 && b > 0.0
        });
        let Some([mut low, mut high]) = rises else { return [f64::NAN; 2] };
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            let is_above = difference(middle) > 0.0;
            *(if is_above { &mut high } else { &mut low }) = middle;
        }
        [0.5 * (low + high), 1.0]
    }

    fn bound(
        &mut self,
        _: &SoughtRoot<'_>,
        _: usize,
        _: &mut dyn FnMut(f64) -> [f64; 3],
    ) -> [f64; 2] {
        [f64::NAN; 2]
    }
}
