//! Square matrices.

#[derive(Clone, Debug)]
pub(super) struct Matrix {
    pub count: usize,
    /// Row by row.
    pub parts: Vec<f64>,
}

impl Matrix {
    pub(super) fn zero(count: usize) -> Self {
        Self { count, parts: vec![0.0; count * count] }
    }

    pub(super) fn row(&self, row: usize) -> &[f64] {
        &self.parts[row * self.count..][..self.count]
    }

    /// The product with a vector.
    pub(super) fn times(&self, vector: &[f64]) -> Vec<f64> {
        let product = |row| self.row(row).iter().zip(vector).map(|(a, b)| a * b).sum();
        (0..self.count).map(product).collect()
    }

    /// The product of the transposed matrix with a vector.
    pub(super) fn transposed_times(&self, vector: &[f64]) -> Vec<f64> {
        let mut product = vec![0.0; self.count];
        for (row, by) in vector.iter().enumerate().filter(|(_, by)| **by != 0.0) {
            for (sum, part) in product.iter_mut().zip(self.row(row)) {
                *sum += part * by;
            }
        }
        product
    }

    /// The largest sum of magnitudes in a row.
    pub(super) fn norm(&self) -> f64 {
        let sum = |row| self.row(row).iter().map(|part: &f64| part.abs()).sum::<f64>();
        (0..self.count).map(sum).fold(0.0, f64::max)
    }

    /// The inverse, and whether the determinant is positive.
    pub(super) fn inverse(&self) -> Option<(Self, bool)> {
        let count = self.count;
        let unit = |row: usize| {
            let mut unit = vec![0.0; count];
            unit[row] = 1.0;
            unit
        };
        let (rows, is_positive) = self.reduced((0..count).map(unit).collect())?;
        Some((Self { count, parts: rows.concat() }, is_positive))
    }

    /// The vector that the matrix takes to another one.
    pub(super) fn solved(&self, right: &[f64]) -> Option<Vec<f64>> {
        let (rows, _) = self.reduced(right.iter().map(|&part| vec![part]).collect())?;
        Some(rows.concat())
    }

    /// The right sides after the elimination by Gauss and Jordan with the largest pivot of each column, and whether the
    /// determinant is positive.
    fn reduced(&self, right: Vec<Vec<f64>>) -> Option<(Vec<Vec<f64>>, bool)> {
        let count = self.count;
        let mut rows: Vec<Vec<f64>> = right
            .into_iter()
            .enumerate()
            .map(|(row, right)| [self.row(row), &right].concat())
            .collect();
        let mut is_positive = true;
        for column in 0..count {
            let largest =
                |a: &usize, b: &usize| rows[*a][column].abs().total_cmp(&rows[*b][column].abs());
            let pivot = (column..count).max_by(largest)?;
            if rows[pivot][column].abs() < 1e-12 {
                return None;
            }
            is_positive ^= (rows[pivot][column] < 0.0) != (pivot != column);
            rows.swap(pivot, column);
            let by = 1.0 / rows[column][column];
            rows[column].iter_mut().for_each(|part| *part *= by);
            let pivot_row = std::mem::take(&mut rows[column]);
            // Rows are sparse at first; that of the pivot is away.
            for row in rows.iter_mut().filter(|row| !row.is_empty() && row[column] != 0.0) {
                let by = row[column];
                for (part, of_pivot) in row[column..].iter_mut().zip(&pivot_row[column..]) {
                    *part -= by * of_pivot;
                }
            }
            rows[column] = pivot_row;
        }
        let right = rows.into_iter().map(|mut row| row.split_off(count)).collect();
        Some((right, is_positive))
    }
}
