//! Linear equations of a few unknowns.

/// Solves A X = B in place of B for a small matrix by elimination with partial pivoting, and
/// returns whether the matrix is regular.
pub(crate) fn solve<const N: usize, const M: usize>(mut a: [[f64; N]; N], b: &mut [[f64; M]; N]) -> bool {
    let scale = a.iter().flatten().fold(0.0f64, |largest, entry| largest.max(entry.abs()));
    if !(scale > 0.0 && scale.is_finite()) {
        return false;
    }
    for column in 0..N {
        let pivot =
            (column..N).max_by(|&i, &j| a[i][column].abs().total_cmp(&a[j][column].abs())).unwrap_or(column);
        if a[pivot][column].abs() <= 1e-30 * scale {
            return false;
        }
        a.swap(pivot, column);
        b.swap(pivot, column);
        for row in column + 1..N {
            let factor = a[row][column] / a[column][column];
            for k in column..N {
                a[row][k] -= factor * a[column][k];
            }
            for k in 0..M {
                b[row][k] -= factor * b[column][k];
            }
        }
    }
    for column in (0..N).rev() {
        for k in 0..M {
            let mut sum = b[column][k];
            for j in column + 1..N {
                sum -= a[column][j] * b[j][k];
            }
            b[column][k] = sum / a[column][column];
        }
    }
    b.iter().flatten().all(|entry| entry.is_finite())
}

/// Returns the scalar product of two vectors.
pub(crate) fn dot<const N: usize>(a: &[f64; N], b: &[f64; N]) -> f64 {
    let mut sum = 0.0;
    for k in 0..N {
        sum += a[k] * b[k];
    }
    sum
}

/// Returns the scalar product of two vectors of any length, in four sums.
#[inline]
pub(crate) fn product(a: &[f64], b: &[f64]) -> f64 {
    let mut sums = [0.0; 4];
    let (heads, tails) = (a.chunks_exact(4), b.chunks_exact(4));
    let rest: f64 = heads.remainder().iter().zip(tails.remainder()).map(|(x, y)| x * y).sum();
    for (x, y) in heads.zip(tails) {
        for k in 0..4 {
            sums[k] += x[k] * y[k];
        }
    }
    (sums[0] + sums[1]) + (sums[2] + sums[3]) + rest
}

/// Replaces a symmetric matrix, row by row, by its Cholesky factor in the lower triangle. Returns
/// whether the matrix is positive definite.
pub(crate) fn cholesky(matrix: &mut [f64], size: usize) -> bool {
    for i in 0..size {
        let (above, row) = matrix.split_at_mut(i * size);
        for j in 0..i {
            let other = &above[j * size..j * size + j + 1];
            row[j] = (row[j] - product(&row[..j], &other[..j])) / other[j];
        }
        let pivot = row[i] - product(&row[..i], &row[..i]);
        if pivot.is_nan() || pivot <= 1e-14 * row[i] {
            return false;
        }
        row[i] = pivot.sqrt();
    }
    true
}

/// Solves L x = b in place of b with the Cholesky factor L.
pub(crate) fn solve_lower(factor: &[f64], right: &mut [f64]) {
    let size = right.len();
    for i in 0..size {
        let row = &factor[i * size..i * size + i + 1];
        right[i] = (right[i] - product(&row[..i], &right[..i])) / row[i];
    }
}

/// Solves Lᵀ x = b in place of b with the Cholesky factor L.
pub(crate) fn solve_upper(factor: &[f64], right: &mut [f64]) {
    let size = right.len();
    for i in (0..size).rev() {
        let row = &factor[i * size..i * size + i + 1];
        right[i] /= row[i];
        let value = right[i];
        for (entry, factor) in right[..i].iter_mut().zip(row) {
            *entry -= factor * value;
        }
    }
}
