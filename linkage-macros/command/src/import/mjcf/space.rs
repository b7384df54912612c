//! Places and turns in space.

pub(super) type Vector = [f64; 3];

/// A turn, row by row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Turn(pub [Vector; 3]);

/// A frame in the world's.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Frame {
    pub at: Vector,
    pub turn: Turn,
}

pub(super) fn dot(a: Vector, b: Vector) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

pub(super) fn cross([a, b, c]: Vector, [x, y, z]: Vector) -> Vector {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}

pub(super) fn plus(a: Vector, b: Vector) -> Vector {
    [0, 1, 2].map(|axis| a[axis] + b[axis])
}

pub(super) fn unit(a: Vector) -> Option<Vector> {
    let length = dot(a, a).sqrt();
    (length > 0.0).then(|| a.map(|part| part / length))
}

impl Turn {
    pub(super) const NONE: Self = Self([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);

    /// About an axis of length one.
    pub(super) fn about([x, y, z]: Vector, angle: f64) -> Self {
        let (sin, cos) = (angle / 2.0).sin_cos();
        Self::of_quaternion([cos, x * sin, y * sin, z * sin])
    }

    pub(super) fn of_quaternion(q: [f64; 4]) -> Self {
        let length = q.iter().map(|part| part * part).sum::<f64>().sqrt();
        let [w, x, y, z] = q.map(|part| part / length);
        Self([
            [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
            [2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)],
            [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)],
        ])
    }

    /// The turn whose columns these are.
    pub(super) fn of_axes(x: Vector, y: Vector, z: Vector) -> Self {
        Self([0, 1, 2].map(|row| [x[row], y[row], z[row]]))
    }

    pub(super) fn of(self, vector: Vector) -> Vector {
        self.0.map(|row| dot(row, vector))
    }

    pub(super) fn then(self, inner: Self) -> Self {
        let columns = [0, 1, 2].map(|column| self.of(inner.0.map(|row| row[column])));
        Self([0, 1, 2].map(|row| [0, 1, 2].map(|column| columns[column][row])))
    }
}

impl Frame {
    pub(super) const WORLD: Self = Self { at: [0.0; 3], turn: Turn::NONE };

    pub(super) fn place(self, local: Vector) -> Vector {
        plus(self.at, self.turn.of(local))
    }

    pub(super) fn then(self, inner: Self) -> Self {
        Self { at: self.place(inner.at), turn: self.turn.then(inner.turn) }
    }
}
