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
