//! The system of linear equations, and its solution.

use std::collections::HashMap;

use super::{
    Applied, Motion, Pair, Part, cross, driven_length, held_point, is_moving, negative, whole,
};
use crate::equations::kinematics::Kinematics;
use crate::ir::interpret::Number;
use crate::model::acting::{Effort, MassPlace};
use crate::model::mechanism::{Body, GuideId, LinkId, PointId, Scalar, Slideway, UnknownId};
use crate::oracle::Digits;

/// One unknown: what one unit of it puts on every part's equations.
pub(super) type Column = HashMap<usize, Digits>;

pub(in crate::equations) struct Matrix<'k, 's> {
    pub(super) kinematics: &'k Kinematics<'s>,
    pub(super) motion: &'k Motion<Digits>,
    pub(super) given: &'k dyn Fn(&Scalar) -> Digits,
    /// Where the equations of a part begin: two of forces, and of what turns one of moments.
    rows: HashMap<Part, usize>,
    count: usize,
    pub(super) columns: Vec<Column>,
    /// Each effort with the column of its first component.
    pub(super) names: Vec<(Effort, usize)>,
}

impl<'k, 's> Matrix<'k, 's> {
    /// Every reaction and drive, from one system of linear equations.
    pub(in crate::equations) fn solved(
        kinematics: &'k Kinematics<'s>,
        motion: &'k Motion<Digits>,
        given: &'k dyn Fn(&Scalar) -> Digits,
    ) -> Vec<(Effort, Vec<Digits>)> {
        let mut matrix = Self {
            kinematics,
            motion,
            given,
            rows: HashMap::new(),
            count: 0,
            columns: Vec::new(),
            names: Vec::new(),
        };
        matrix.number_rows();
        for step in &kinematics.mechanism.steps {
            matrix.carry(step);
            matrix.joints(step);
        }
        matrix.carry_masses();
        matrix.equations();
        assert_eq!(matrix.columns.len(), matrix.count, "as many unknowns as equations");
        matrix.solve()
    }

    fn number_rows(&mut self) {
        let mechanism = self.kinematics.mechanism;
        for index in 0..mechanism.links.len() as u32 {
            let link = LinkId(index);
            self.add_part(Part::Link(link), 3);
            if driven_length(mechanism, link).is_some() {
                self.add_part(Part::Rod(link), 3);
            }
        }
        for point in (0..mechanism.points.len() as u32).map(PointId) {
            if mechanism.owner(point) == Some(Body::Pin(point)) {
                self.add_part(Part::Pin(point), 2);
            }
            if held_point(mechanism, point) {
                self.add_part(Part::Held(point), 2);
            }
        }
        for guide in (0..mechanism.guides.len() as u32).map(GuideId) {
            self.add_part(Part::Guide(guide), 3);
        }
        for joint in mechanism.joints() {
            if matches!(joint.slideway(), Some(Slideway::Slot { .. })) {
                self.add_part(Part::Slot(joint.link()), 3);
            }
        }
        for (index, mass) in mechanism.dynamics.masses.iter().enumerate() {
            if let MassPlace::At(_, place) = &mass.place
                && is_moving(mechanism, place)
            {
                self.add_part(Part::Mass(index), 2);
            }
        }
        for index in 0..mechanism.unknowns.len() as u32 {
            self.add_part(Part::Sought(UnknownId(index)), 1);
        }
    }

    fn add_part(&mut self, part: Part, equations: usize) {
        self.rows.insert(part, self.count);
        self.count += equations;
    }

    pub(super) fn act(
        &self,
        column: &mut Column,
        part: Part,
        at: &Pair<Digits>,
        force: &Pair<Digits>,
        couple: &Digits,
    ) {
        let Some(&row) = self.rows.get(&part) else { return };
        let mut add = |row: usize, value: Digits| {
            let sum = column.get(&row).map_or(value.clone(), |known| known.add(&value));
            column.insert(row, sum);
        };
        add(row, force[0].clone());
        if matches!(part, Part::Sought(_)) {
            return;
        }
        add(row + 1, force[1].clone());
        match part {
            Part::Pin(_) | Part::Held(_) | Part::Mass(_) => {
                assert!(couple.to_f64() == 0.0, "nothing turns {part:?}");
            }
            _ => add(row + 2, cross(at, force).add(couple)),
        }
    }

    /// A pair of opposite forces at a point and opposite couples.
    pub(super) fn pair(
        &self,
        [on, by]: [Part; 2],
        at: &Pair<Digits>,
        force: &Pair<Digits>,
        couple: i64,
    ) -> Column {
        let mut column = Column::new();
        self.act(&mut column, on, at, force, &whole(couple));
        self.act(&mut column, by, at, &negative(force), &whole(-couple));
        column
    }

    pub(super) fn axes() -> [Pair<Digits>; 2] {
        [[whole(1), whole(0)], [whole(0), whole(1)]]
    }

    pub(super) fn drive(&mut self, effort: Effort, column: Column) -> usize {
        self.names.push((effort, self.columns.len()));
        self.columns.push(column);
        self.columns.len() - 1
    }

    /// Gauss's elimination with the largest pivot of each column.
    fn solve(&self) -> Vec<(Effort, Vec<Digits>)> {
        let n = self.count;
        let zero = whole(0);
        let mut right = Column::new();
        for applied in &self.motion.applied {
            let Applied { part, at, force, couple, .. } = applied;
            self.act(&mut right, *part, at, &negative(force), &couple.neg());
        }
        let entry = |column: &Column, row: usize| column.get(&row).cloned().unwrap_or(zero.clone());
        let mut rows: Vec<Vec<Digits>> = (0..n)
            .map(|row| {
                let columns = self.columns.iter().chain([&right]);
                columns.map(|column| entry(column, row)).collect()
            })
            .collect();
        for k in 0..n {
            let sizes = (k..n).map(|row| (row, rows[row][k].to_f64().abs()));
            let largest = sizes.max_by(|(_, a), (_, b)| a.total_cmp(b));
            let (pivot, _) = largest.expect("rows are left");
            rows.swap(k, pivot);
            let (above, below) = rows.split_at_mut(k + 1);
            let top = &above[k];
            let filled: Vec<usize> = (k..=n).filter(|&j| top[j].to_f64() != 0.0).collect();
            for row in below.iter_mut().filter(|row| row[k].to_f64() != 0.0) {
                let factor = row[k].div(&top[k]);
                for &j in &filled {
                    row[j] = row[j].sub(&factor.mul(&top[j]));
                }
            }
        }
        let mut solution = vec![zero.clone(); n];
        for k in (0..n).rev() {
            let known = (k + 1..n)
                .fold(rows[k][n].clone(), |sum, j| sum.sub(&rows[k][j].mul(&solution[j])));
            solution[k] = known.div(&rows[k][k]);
        }
        let count = |effort: &Effort| match effort {
            Effort::Pin(..) | Effort::Guide(_) => 2,
            _ => 1,
        };
        let found = self.names.iter();
        found.map(|(effort, at)| (*effort, solution[*at..*at + count(effort)].to_vec())).collect()
    }
}
