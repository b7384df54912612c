//! The stretch of a motion that two sets of inputs share: from the drawing either way until the one or the other is at an
//! end of its own.

use syn::ext::IdentExt;

use super::{at_defaults, program};
use crate::codegen::DrivenSet;
use crate::interface::Interface;
use crate::interface::carried_over::{Assembled, CarriedOver, PlaceInPose, SideLine};
use crate::interface::entries::Analysis;
use crate::interface::quantity::{Order, Quantity};
use crate::ir::graph::Id;
use crate::ir::interpret::straight;
use crate::ir::program::{Liveness, Program};
use crate::model::mechanism::{Input, Mechanism};
use crate::reach::turn::degrees;

/// Steps of a turn, and of the machine's size. A motion that goes on beyond four sizes has no end that is looked for.
const OF_TURN: u32 = 360;
const OF_SIZE: u32 = 180;
const SIZES: u32 = 4;
/// Halvings of the step in which a motion ends: what is left is far below the last digit that is shown.
const HALVINGS: u32 = 40;

/// A line for each two sets of one input that are solved without a search.
pub(super) fn lines(sets: &[DrivenSet<'_>]) -> Vec<String> {
    let pairs = sets.iter().enumerate().flat_map(|(nth, one)| {
        let others = sets[nth + 1..].iter();
        others.filter_map(|other| line(one.mechanism, other.mechanism)).collect::<Vec<_>>()
    });
    pairs.collect()
}

fn line(one: &Mechanism, other: &Mechanism) -> Option<String> {
    let motion = SharedMotion::between(one, other)?;
    let ends = motion.ends()?;
    let [from, to] = ends.map(|q| motion.numbers(q).map(|numbers| [q, motion.other(&numbers, q)]));
    let ([own, others], [own_to, others_to]) = (from?, to?);
    let part = |input: &Input, ends: [f64; 2]| {
        let [from, to] = ends.map(|end| match input.dimension.angle {
            true => degrees(end.to_degrees()),
            false => format!("{} m", short(end)),
        });
        format!("`{}` from {from} to {to}", input.name.unraw())
    };
    let (own, others) =
        (part(&one.inputs[0], [own, own_to]), part(&other.inputs[0], [others, others_to]));
    let others = others.replacen("` from ", "` is from ", 1);
    let where_so = if one.params.is_empty() { "" } else { ", with the parameters as declared" };
    Some(format!(" Both ways: {own}, where {others}{where_so}."))
}

/// Four digits.
fn short(value: f64) -> String {
    let text = format!("{value:.3e}");
    text.parse::<f64>().map_or(text, |rounded| (rounded + 0.0).to_string())
}

/// The motion of one set's solver, with what tells the other's assembly.
struct SharedMotion<'a> {
    mechanism: &'a Mechanism,
    program: Program,
    sinks: Vec<Id>,
    is_needed: Vec<bool>,
    /// The first number of each row, and whether it is the cosine of an angle.
    rows: Vec<(usize, bool)>,
    carried: CarriedOver,
    drawn: f64,
}

impl<'a> SharedMotion<'a> {
    /// Nothing where one of them has several inputs or a search, where the drawing tells no pose, or where a side of the
    /// other is not known by a sign.
    fn between(one: &'a Mechanism, other: &Mechanism) -> Option<Self> {
        let is_simple = |of: &Mechanism| of.inputs.len() == 1 && of.unknowns.is_empty();
        if !is_simple(one) || !is_simple(other) {
            return None;
        }
        let carried = CarriedOver::between(one, other);
        let drawn = *one.drawn.as_ref()?.first()?;
        if !carried.compared.is_empty() || other.drawn.is_none() {
            return None;
        }
        let (program, interface) = (program(one), Interface::of(one));
        let point = interface.entry(interface.find(Analysis::Position.by_value())?).point;
        let answer = program.answers.iter().find(|answer| answer.entry == Some(point))?;
        let sinks = answer.sinks.clone();
        let is_needed = Liveness::of(&program, &sinks).fast;
        let (mut rows, mut at) = (Vec::new(), 0);
        for output in &one.outputs {
            for is_angle in Quantity::of(&output.kind).layout(Order::Position).are_angles() {
                rows.push((at, is_angle));
                at += if is_angle { 2 } else { 1 };
            }
        }
        Some(Self { mechanism: one, program, sinks, is_needed, rows, carried, drawn })
    }

    /// The numbers of the position, or nothing where there is no pose.
    fn numbers(&self, q: f64) -> Option<Vec<f64>> {
        let given = at_defaults(self.mechanism, &[q]);
        let numbers = straight(&self.program, &given, (&self.sinks, &self.is_needed));
        numbers.iter().all(|number| number.is_finite()).then_some(numbers)
    }

    fn found(&self, place: &PlaceInPose, numbers: &[f64], q: f64) -> f64 {
        match place {
            PlaceInPose::Input(_) => q,
            PlaceInPose::Fixed(value) => *value,
            PlaceInPose::Row(row, drawn) => match self.rows[*row] {
                (at, false) => numbers[at],
                (at, true) => {
                    let (angle, drawn) = (numbers[at + 1].atan2(numbers[at]), drawn.unwrap_or(0.0));
                    let turn = std::f64::consts::TAU;
                    angle - turn * ((angle - drawn) / turn).round()
                }
            },
        }
    }

    /// The other's input.
    fn other(&self, numbers: &[f64], q: f64) -> f64 {
        self.found(&self.carried.coordinates[0], numbers, q)
    }

    /// True if both solvers have this pose.
    fn is_of_both(&self, q: f64) -> bool {
        let Some(numbers) = self.numbers(q) else { return false };
        let at = |place: &[PlaceInPose; 2]| place.each_ref().map(|x| self.found(x, &numbers, q));
        self.carried.sides.iter().all(|Assembled { from, line, pin, is_positive, .. }| {
            let ([x, y], [pin_x, pin_y]) = (at(from), at(pin));
            let (right, up) = (pin_x - x, pin_y - y);
            let across = match line {
                SideLine::Towards(to) => {
                    let [to_x, to_y] = at(to);
                    (to_x - x) * up - (to_y - y) * right
                }
                SideLine::Along([along_x, along_y]) => along_x * right + along_y * up,
            };
            (across > 0.0) == *is_positive
        })
    }

    /// The ends of the motion, the lower one first; nothing where it has none.
    fn ends(&self) -> Option<[f64; 2]> {
        if !self.is_of_both(self.drawn) {
            return None;
        }
        let (step, count) = if self.mechanism.inputs[0].dimension.angle {
            (std::f64::consts::TAU / f64::from(OF_TURN), OF_TURN)
        } else {
            let sizes = self.numbers(self.drawn)?.into_iter().map(f64::abs);
            let size = sizes.fold(self.drawn.abs(), f64::max);
            (size / f64::from(OF_SIZE), SIZES * OF_SIZE)
        };
        Some([self.end(-step, count)?, self.end(step, count)?])
    }

    /// The last pose of both so many steps from the drawing.
    fn end(&self, step: f64, count: u32) -> Option<f64> {
        let beyond = (1..=count).find(|&k| !self.is_of_both(self.drawn + f64::from(k) * step))?;
        let [mut within, mut beyond] =
            [beyond - 1, beyond].map(|k| self.drawn + f64::from(k) * step);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (within + beyond);
            *(if self.is_of_both(middle) { &mut within } else { &mut beyond }) = middle;
        }
        Some(within)
    }
}
