//! QR of a tall matrix by blocks of its rows, so that a million rows take no memory.

use nalgebra::DMatrix;

/// Rows that are triangulated at a time: few enough to stay in a processor's first cache.
const BLOCK: usize = 128;

/// R of [J | r]: the Jacobian's triangle, and the residual turned likewise.
pub(super) struct Triangle {
    columns: usize,
    rows: DMatrix<f64>,
    filled: usize,
}

impl Triangle {
    /// For so many parameters.
    pub(super) fn new(parameters: usize) -> Self {
        let columns = parameters + 1;
        Triangle { columns, rows: DMatrix::zeros(columns + BLOCK, columns), filled: columns }
    }

    /// Adds a row of J and its residual.
    pub(super) fn push(&mut self, row: impl IntoIterator<Item = f64>) {
        for (j, x) in row.into_iter().take(self.columns).enumerate() {
            self.rows[(self.filled, j)] = x;
        }
        self.filled += 1;
        if self.filled == self.rows.nrows() {
            self.reduce();
        }
    }

    /// Householder's reflections put everything into the first rows.
    fn reduce(&mut self) {
        let r = self.rows.clone().qr().r();
        self.rows.fill(0.0);
        self.rows.rows_mut(0, self.columns).copy_from(&r);
        self.filled = self.columns;
    }

    /// The system R x = z, and the length of what no x can take away.
    pub(super) fn solve(mut self) -> System {
        self.reduce();
        let p = self.columns - 1;
        System {
            r: self.rows.view((0, 0), (p, p)).into_owned(),
            z: (0..p).map(|i| self.rows[(i, p)]).collect(),
            rest: self.rows[(p, p)].abs(),
        }
    }
}

/// A least-squares problem in triangular form.
pub(super) struct System {
    r: DMatrix<f64>,
    z: Vec<f64>,
    /// |r| perpendicular to every column.
    pub(super) rest: f64,
}

/// A column that stands in the others' space but for this part of its length, or that is so short beside the longest,
/// is told apart by rounding alone.
const SINGULAR: f64 = 1e-9;

impl System {
    /// The length of the residual's part along the columns: 0 at a stationary point.
    pub(super) fn along(&self) -> f64 {
        self.z.iter().map(|z| z * z).sum::<f64>().sqrt()
    }

    /// R⁻¹, if the columns are independent.
    fn inverse(&self) -> Option<DMatrix<f64>> {
        let p = self.z.len();
        let lengths: Vec<f64> = self.r.column_iter().map(|column| column.norm()).collect();
        let longest = lengths.iter().copied().fold(0.0, f64::max);
        for (j, &length) in lengths.iter().enumerate() {
            // Of NaN neither is greater.
            let is_apart = self.r[(j, j)].abs() > SINGULAR * length && length > SINGULAR * longest;
            if !is_apart {
                return None;
            }
        }
        let inverse = self.r.solve_upper_triangular(&DMatrix::identity(p, p))?;
        inverse.iter().all(|x| x.is_finite()).then_some(inverse)
    }

    /// The step that takes away what the columns can, to the first order.
    pub(super) fn step(&self) -> Option<Vec<f64>> {
        let inverse = self.inverse()?;
        let p = self.z.len();
        Some((0..p).map(|i| (i..p).map(|j| inverse[(i, j)] * self.z[j]).sum()).collect())
    }

    /// (JᵀJ)⁻¹ = R⁻¹ R⁻ᵀ, row by row.
    pub(super) fn covariance(&self) -> Option<Vec<Vec<f64>>> {
        let inverse = self.inverse()?;
        let p = self.z.len();
        let entry = |i: usize, j: usize| (i.max(j)..p).map(|k| inverse[(i, k)] * inverse[(j, k)]).sum();
        Some((0..p).map(|i| (0..p).map(|j| entry(i, j)).collect()).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A line through whole numbers, whose normal equations are solved in whole numbers: N = 1000 points x = i,
    /// y = 3 x + 1 + (-1)^i.
    #[test]
    fn blocks_give_the_normal_equations_solution() {
        let mut triangle = Triangle::new(2);
        let (mut s, mut sx, mut sxx, mut sy, mut sxy) = (0_i64, 0_i64, 0_i64, 0_i64, 0_i64);
        for i in 0..1000_i64 {
            let y = 3 * i + 1 + if i % 2 == 0 { 1 } else { -1 };
            triangle.push([1.0, i as f64, y as f64]);
            (s, sx, sxx, sy, sxy) = (s + 1, sx + i, sxx + i * i, sy + y, sxy + i * y);
        }
        let determinant = s * sxx - sx * sx;
        let exact =
            [(sxx * sy - sx * sxy) as f64, (s * sxy - sx * sy) as f64].map(|x| x / determinant as f64);
        let system = triangle.solve();
        let step = system.step().unwrap();
        let covariance = system.covariance().unwrap();
        // The condition number is about 1000.
        for (found, exact) in step.iter().zip(exact) {
            assert!((found - exact).abs() < 1e-12, "{found} {exact}");
        }
        let inverse = [[sxx, -sx], [-sx, s]];
        for (i, j) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
            let exact = inverse[i][j] as f64 / determinant as f64;
            assert!((covariance[i][j] / exact - 1.0).abs() < 1e-12);
        }
        // The alternating part is nearly perpendicular to both columns: its length is √1000.
        assert!((system.rest - 1000.0_f64.sqrt()).abs() < 1e-3, "{}", system.rest);
    }

    #[test]
    fn equal_columns_have_no_answer() {
        let mut triangle = Triangle::new(2);
        for i in 0..10 {
            let x = 0.1 + f64::from(i);
            triangle.push([x, 2.0 * x, 1.0]);
        }
        let system = triangle.solve();
        assert!(system.step().is_none() && system.covariance().is_none());
    }
}
