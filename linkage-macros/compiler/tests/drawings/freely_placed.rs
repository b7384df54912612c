//! Eight-bars by three coordinates a link: an independent truth of their poses, which knows no groups.

use super::chains_of_eight::Driven;

/// A machine as links that lie freely in the plane, the ground among them at rest.
pub(super) struct Links<'d> {
    driven: &'d Driven,
    places: &'d [[f64; 2]],
    moving: Vec<usize>,
}

/// By moving link its shift along x and y and its turn, from the drawing.
pub(super) type Coordinates = Vec<f64>;

impl<'d> Links<'d> {
    pub(super) fn of(driven: &'d Driven, places: &'d [[f64; 2]]) -> Self {
        let links = driven.joints.iter().flatten().max().map_or(0, |last| last + 1);
        let moving = (0..links).filter(|&link| link != driven.ground).collect();
        Self { driven, places, moving }
    }

    fn first(&self, link: usize) -> Option<usize> {
        self.moving.iter().position(|&moving| moving == link).map(|index| 3 * index)
    }

    fn turn(&self, link: usize, at: &[f64]) -> f64 {
        self.first(link).map_or(0.0, |first| at[first + 2])
    }

    /// A joint where a link has it.
    pub(super) fn place(&self, link: usize, joint: usize, at: &[f64]) -> [f64; 2] {
        let [x, y] = self.places[joint];
        let Some(first) = self.first(link) else { return [x, y] };
        let (sin, cos) = at[first + 2].sin_cos();
        [at[first] + cos * x - sin * y, at[first + 1] + sin * x + cos * y]
    }

    /// The pose at a drive from the drawing that Newton's method finds from another one; none where that is far off, or on
    /// the other side of a dead point.
    pub(super) fn beside(&self, drive: f64, near: &[f64]) -> Option<Coordinates> {
        let (mut at, mut sign) = (near.to_vec(), None);
        for _ in 0..12 {
            let (now, step) = solved(self.equations(drive, &at))?;
            let sign = *sign.get_or_insert(now);
            at.iter_mut().zip(&step).for_each(|(at, step)| *at -= step);
            if step.iter().all(|step| step.abs() < 1e-11) {
                let is_near = at.iter().zip(near).all(|(at, near)| (at - near).abs() < 0.1);
                return (is_near && now == sign).then_some(at);
            }
        }
        None
    }

    /// The equations, a row each, with what they miss last: two links have each joint at one place, and the drive has its
    /// angle.
    fn equations(&self, drive: f64, at: &[f64]) -> Vec<Vec<f64>> {
        let count = 3 * self.moving.len();
        let mut rows = Vec::new();
        for (joint, &links) in self.driven.joints.iter().enumerate() {
            let mut both = [vec![0.0; count + 1], vec![0.0; count + 1]];
            for (link, sign) in links.into_iter().zip([1.0, -1.0]) {
                let [x, y] = self.place(link, joint, at);
                both[0][count] += sign * x;
                both[1][count] += sign * y;
                if let Some(first) = self.first(link) {
                    both[0][first] += sign;
                    both[1][first + 1] += sign;
                    both[0][first + 2] -= sign * (y - at[first + 1]);
                    both[1][first + 2] += sign * (x - at[first]);
                }
            }
            rows.extend(both);
        }
        let [a, b] = self.driven.joints[self.driven.drive];
        let (a, b) = if a == self.driven.ground { (b, a) } else { (a, b) };
        let mut turned = vec![0.0; count + 1];
        for (link, sign) in [(a, 1.0), (b, -1.0)] {
            if let Some(first) = self.first(link) {
                turned[first + 2] = sign;
            }
        }
        turned[count] = self.turn(a, at) - self.turn(b, at) - drive;
        rows.push(turned);
        rows
    }

    /// The poses from the drawing on, each with its drive, in these steps and smaller ones in front of an end, as far as
    /// half a turn.
    pub(super) fn followed(&self, step: f64) -> Vec<(f64, Coordinates)> {
        let mut poses = vec![(0.0, vec![0.0; 3 * self.moving.len()])];
        let mut part = step;
        while part.abs() > 1e-5 {
            let (drive, from) = &poses[poses.len() - 1];
            let next = (drive + part).clamp(-std::f64::consts::PI, std::f64::consts::PI);
            if next == *drive {
                break;
            }
            match self.beside(next, from) {
                Some(at) => poses.push((next, at)),
                None => part /= 2.0,
            }
        }
        poses
    }
}

/// The solution of linear equations, a row each with its right side last, behind the sign of their determinant; none where
/// there is none.
pub(super) fn solved(mut rows: Vec<Vec<f64>>) -> Option<(bool, Vec<f64>)> {
    let count = rows.len();
    let mut is_positive = true;
    for column in 0..count {
        let size = |row: &usize| rows[*row][column].abs();
        let best = (column..count).max_by(|a, b| size(a).total_cmp(&size(b)))?;
        if rows[best][column] == 0.0 {
            return None;
        }
        is_positive ^= best != column;
        rows.swap(best, column);
        is_positive ^= rows[column][column] < 0.0;
        let pivot = rows[column].clone();
        for row in &mut rows[column + 1..] {
            let factor = row[column] / pivot[column];
            row.iter_mut().zip(&pivot).skip(column).for_each(|(value, by)| *value -= factor * by);
        }
    }
    let mut solution = vec![0.0; count];
    for column in (0..count).rev() {
        let known: f64 =
            (column + 1..count).map(|other| rows[column][other] * solution[other]).sum();
        solution[column] = (rows[column][count] - known) / rows[column][column];
    }
    Some((is_positive, solution))
}
