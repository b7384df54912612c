//! Driven dimensions that read earlier links: what drives them pushes back on what they read.

use super::friction::under;
use super::matrix::{Column, Matrix};
use super::readings::{readings, slope};
use super::{Pair, Part, negative, normal, part_of, whole};
use crate::ir::interpret::{Number, Searched};
use crate::model::mechanism::{AngleSum, Axis, Equation, Group, Scalar, UnknownId};
use crate::oracle::Digits;
use crate::syntax::anatomy::Class;

impl Matrix<'_, '_> {
    /// One unknown an equation: it pushes on all that its sides read. Where the bar or the block that holds it is
    /// drawn, that is what slides in it, clamped.
    pub(super) fn equations(&mut self) {
        let mechanism = self.kinematics.mechanism;
        for (index, unknown) in mechanism.unknowns.iter().enumerate() {
            let push = self.columns.len();
            let clamp = mechanism.left_out(UnknownId(index as u32)).map(|group| self.clamp(group));
            let is_clamped = clamp.is_some();
            self.columns.push(clamp.unwrap_or_default());
            match &unknown.equation {
                Equation::Difference([left, right]) if is_clamped => {
                    // The clamp pushes along the normal of the guide.
                    let is_left = matches!(left, Scalar::Offset(..));
                    let (rest, sign) = if is_left { (right, 1) } else { (left, -1) };
                    self.transmit(rest, &[(push, whole(sign))]);
                }
                Equation::Difference([left, right]) => {
                    self.transmit(left, &[(push, whole(-1))]);
                    self.transmit(right, &[(push, whole(1))]);
                }
                Equation::Turn(turn) => self.transmit_turn(turn, &[(push, whole(-1))]),
                Equation::Distance { points, length, is_left } => {
                    let sign = if *is_left { 1 } else { -1 };
                    if !is_clamped {
                        self.transmit(&Scalar::Distance(*points), &[(push, whole(-sign))]);
                    }
                    self.transmit(&length.value, &[(push, whole(sign))]);
                }
            }
        }
    }

    /// A push on a block along what it slides on, and its opposite on that.
    fn clamp(&self, group: &Group) -> Column {
        let [block, by] = [0, 1].map(|leg| group.links[leg]);
        let at = &self.motion.points[group.stands_on(0).index()];
        let u = &self.motion.directions[by.index()];
        let along = match group.kind {
            Class::Rpr => u.clone(),
            _ => normal(u),
        };
        self.pair([Part::Link(block), Part::Link(by)], at, &along, 0)
    }

    /// An effort, a sum of unknowns with factors, of an angle.
    pub(super) fn transmit_turn(&mut self, turn: &AngleSum, effort: &[(usize, Digits)]) {
        let zero = [whole(0), whole(0)];
        for &(link, times) in &turn.links {
            for (unknown, factor) in effort {
                let couple = factor.mul(&whole(-i64::from(times)));
                let mut column = std::mem::take(&mut self.columns[*unknown]);
                self.act(&mut column, Part::Link(link), &zero, &zero, &couple);
                self.columns[*unknown] = column;
            }
        }
        self.transmit(&turn.rest, effort);
    }

    /// The same of any dimension: what it reads of earlier links is pushed back.
    pub(super) fn transmit(&mut self, expr: &Scalar, effort: &[(usize, Digits)]) {
        let mut leaves = Vec::new();
        readings(self.kinematics.mechanism, expr, &mut leaves);
        for leaf in leaves {
            let slope = slope(self.kinematics.mechanism, expr, &leaf, self.given);
            for (unknown, factor) in effort {
                let push = slope.mul(factor).neg();
                let mut column = std::mem::take(&mut self.columns[*unknown]);
                self.push_reading(&mut column, &leaf, &push);
                self.columns[*unknown] = column;
            }
        }
    }

    fn push_reading(&self, column: &mut Column, leaf: &Scalar, push: &Digits) {
        let scaled = |v: &Pair<Digits>, by: &Digits| [v[0].mul(by), v[1].mul(by)];
        let none = whole(0);
        match leaf {
            Scalar::Slide(link) => {
                let u = &self.motion.directions[link.index()];
                let at = &self.motion.origins[link.index()];
                let force = scaled(u, push);
                self.act(column, Part::Link(*link), at, &force, &none);
                self.act(column, under(self.kinematics, *link), at, &negative(&force), &none);
            }
            Scalar::Coordinate(point, axis) => {
                let [x, y] = Self::axes();
                let axis = if *axis == Axis::X { x } else { y };
                let part = part_of(self.kinematics, *point);
                let at = &self.motion.points[point.index()];
                self.act(column, part, at, &scaled(&axis, push), &none);
            }
            Scalar::Distance([p, q]) => {
                let [a, b] = [p, q].map(|point| &self.motion.points[point.index()]);
                let d = [b[0].sub(&a[0]), b[1].sub(&a[1])];
                let force = scaled(&d, &push.div(&d[0].hypot(&d[1])));
                let [on_p, on_q] = [p, q].map(|point| part_of(self.kinematics, *point));
                self.act(column, on_q, b, &force, &none);
                self.act(column, on_p, a, &negative(&force), &none);
            }
            Scalar::Offset(point, guide) => {
                let u = &self.motion.guides[guide.index()].1;
                let at = &self.motion.points[point.index()];
                let force = scaled(&normal(u), push);
                self.act(column, part_of(self.kinematics, *point), at, &force, &none);
                self.act(column, Part::Guide(*guide), at, &negative(&force), &none);
            }
            Scalar::Unknown(unknown) => {
                let effort = [push.clone(), whole(0)];
                self.act(column, Part::Sought(*unknown), &[whole(0), whole(0)], &effort, &none);
            }
            _ => unreachable!("only readings are leaves"),
        }
    }
}
