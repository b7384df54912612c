//! Newton's and Euler's equations of bodies in a plane: every joint force an unknown of one matrix.

pub(super) type Vector = [f64; 2];

/// A force on a body, at a point, and a couple.
pub(super) struct Acts(pub usize, pub Vector, pub Vector, pub f64);

/// Equations of bodies: two of forces and one of moments about the centre, each.
pub(super) struct Bodies {
    centres: Vec<Vector>,
    /// The work of a unit of each unknown in the equations.
    columns: Vec<Vec<f64>>,
    /// The sums that unknowns have to make: of all that is known, and of a unit of each friction.
    right: Vec<Vec<f64>>,
}

impl Bodies {
    /// Bodies of mass, centre and its acceleration, inertia and angular acceleration, under weight.
    pub(super) fn new(bodies: &[(f64, Vector, Vector, f64, f64)], gravity: Vector) -> Self {
        let needed = bodies.iter().flat_map(|(mass, _, a, inertia, alpha)| {
            [mass * (a[0] - gravity[0]), mass * (a[1] - gravity[1]), inertia * alpha]
        });
        let centres = bodies.iter().map(|body| body.1).collect();
        Self { centres, columns: Vec::new(), right: vec![needed.collect()] }
    }

    fn done(&self, acts: &[Acts]) -> Vec<f64> {
        let mut done = vec![0.0; 3 * self.centres.len()];
        for Acts(body, at, force, couple) in acts {
            let arm = minus(*at, self.centres[*body]);
            done[3 * body] += force[0];
            done[3 * body + 1] += force[1];
            done[3 * body + 2] += cross(arm, *force) + couple;
        }
        done
    }

    pub(super) fn unknown(&mut self, acts: &[Acts]) {
        self.columns.push(self.done(acts));
    }

    /// A force of two unknown components between two bodies, on the first; none stands for the ground.
    pub(super) fn joint(&mut self, at: Vector, first: usize, second: Option<usize>) {
        for force in [[1.0, 0.0], [0.0, 1.0]] {
            let mut acts = vec![Acts(first, at, force, 0.0)];
            acts.extend(second.map(|second| Acts(second, at, minus([0.0; 2], force), 0.0)));
            self.unknown(&acts);
        }
    }

    pub(super) fn known(&mut self, acts: &[Acts]) {
        let done = self.done(acts);
        self.right[0].iter_mut().zip(done).for_each(|(needed, done)| *needed -= done);
    }

    pub(super) fn friction(&mut self, acts: &[Acts]) {
        let done = self.done(acts);
        self.right.push(done.into_iter().map(|done| -done).collect());
    }

    /// The unknowns without friction, and what a unit of each friction adds to them.
    pub(super) fn solved(self) -> Vec<Vec<f64>> {
        let count = self.columns.len();
        let all = self.columns.iter().chain(&self.right);
        let mut rows: Vec<Vec<f64>> =
            (0..count).map(|row| all.clone().map(|column| column[row]).collect()).collect();
        for k in 0..count {
            let pivot = (k..count).max_by(|&a, &b| rows[a][k].abs().total_cmp(&rows[b][k].abs()));
            rows.swap(k, pivot.expect("a row is left"));
            let top = rows[k].clone();
            for (at, row) in rows.iter_mut().enumerate().filter(|(at, _)| *at != k) {
                let factor = row[k] / top[k];
                let _ = at;
                row.iter_mut().zip(&top).for_each(|(entry, top)| *entry -= factor * top);
            }
        }
        let column =
            |right: usize| (0..count).map(|k| rows[k][count + right] / rows[k][k]).collect();
        (0..self.right.len()).map(column).collect()
    }
}

/// Amounts x of x = c ‖reaction‖, the reactions under them, and the spectral radius of what comes back. `pressing` is where
/// a contact's two components stand among the unknowns, its share, and for a guide the factor of its couple.
pub(super) fn rubbed(
    solved: &[Vec<f64>],
    pressing: &[(usize, f64, Option<f64>)],
) -> (Vec<f64>, Vec<f64>, f64) {
    let size = |unknowns: &[f64], &(at, share, by): &(usize, f64, Option<f64>)| {
        let [x, y] = [unknowns[at], unknowns[at + 1]];
        share * by.map_or(x.hypot(y), |by| x.abs().max(by * y.abs()))
    };
    let under = |amounts: &[f64]| -> Vec<f64> {
        let sum = |at: usize| {
            let added = solved[1..].iter().zip(amounts).map(|(by, amount)| by[at] * amount);
            solved[0][at] + added.sum::<f64>()
        };
        (0..solved[0].len()).map(sum).collect()
    };
    let share = |vector: &[f64]| -> Vec<f64> {
        let of =
            |contact| (1..solved.len()).map(|k| size(&solved[k], contact) * vector[k - 1]).sum();
        pressing.iter().map(of).collect()
    };
    let (mut vector, mut radius) = (vec![1.0; pressing.len()], 0.0);
    for _ in 0..60 {
        // With the unit matrix added, no power is periodic.
        let next: Vec<f64> = share(&vector).iter().zip(&vector).map(|(a, b)| a + b).collect();
        radius = next.iter().copied().fold(0.0, f64::max) - 1.0;
        vector = next.iter().map(|x| x / (radius + 1.0)).collect();
    }
    let mut amounts = vec![0.0; pressing.len()];
    // A repetition gains ρ at least.
    for _ in 0..80 {
        let reactions = under(&amounts);
        amounts = pressing.iter().map(|contact| size(&reactions, contact)).collect();
    }
    let reactions = under(&amounts);
    (amounts, reactions, radius)
}

pub(super) fn minus(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1]]
}

pub(super) fn plus(a: Vector, b: Vector) -> Vector {
    [a[0] + b[0], a[1] + b[1]]
}

pub(super) fn times(factor: f64, a: Vector) -> Vector {
    [factor * a[0], factor * a[1]]
}

pub(super) fn cross(a: Vector, b: Vector) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

pub(super) fn normal([x, y]: Vector) -> Vector {
    [-y, x]
}

/// The two factors of two vectors that make a third.
pub(super) fn parts(a: Vector, b: Vector, of: Vector) -> [f64; 2] {
    [cross(of, b) / cross(a, b), cross(a, of) / cross(a, b)]
}

/// A place in a body that turns about a point, and its acceleration.
pub(super) fn carried(
    [origin, acceleration]: [Vector; 2],
    direction: Vector,
    [omega, alpha]: [f64; 2],
    [x, y]: Vector,
) -> [Vector; 2] {
    let arm = plus(times(x, direction), times(y, normal(direction)));
    let turned = plus(times(alpha, normal(arm)), times(-omega * omega, arm));
    [plus(origin, arm), plus(acceleration, turned)]
}
