//! Generalized minimal residual method (Saad and Schultz 1986) with right preconditioning.

use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::Interrupt;
use faer::c64;

/// Linear map of a vector.
pub(crate) type Map<'f> = &'f dyn Fn(&[c64]) -> Vec<c64>;

/// Solution of a linear system, or the relative residual that remains.
pub(crate) enum Outcome {
    Converged(Vec<c64>),
    Stalled(f64),
}

fn norm(values: &[c64]) -> f64 {
    values.iter().map(|value| value.norm_sqr()).sum::<f64>().sqrt()
}

/// Solves A x = b to a residual relative to b. `preconditioner` is an approximate inverse of
/// `matrix`; `iterations` is the largest dimension of the Krylov space, which is not restarted.
pub(crate) fn gmres(
    matrix: Map<'_>,
    preconditioner: Map<'_>,
    right: &[c64],
    tolerance: f64,
    iterations: usize,
    interrupt: &Interrupt,
) -> Result<Outcome, EngineError> {
    let zero = c64::new(0.0, 0.0);
    let scale = norm(right);
    if scale == 0.0 {
        return Ok(Outcome::Converged(vec![zero; right.len()]));
    }
    let mut basis: Vec<Vec<c64>> = vec![right.iter().map(|value| value / scale).collect()];
    // Columns of the triangular factor, rotations, and the rotated right-hand side.
    let mut columns: Vec<Vec<c64>> = Vec::new();
    let mut rotations: Vec<(f64, c64)> = Vec::new();
    let mut rest = vec![c64::new(1.0, 0.0)];
    let mut residual = 1.0;
    while residual > tolerance && columns.len() < iterations {
        interrupt.check()?;
        let step = columns.len();
        let mut next = matrix(&preconditioner(&basis[step]));
        let mut column = vec![zero; step + 2];
        // The second pass restores the orthogonality that rounding lost.
        for _ in 0..2 {
            for (entry, vector) in column.iter_mut().zip(&basis) {
                let part: c64 = vector.iter().zip(&next).map(|(a, b)| a.conj() * b).sum();
                *entry += part;
                next.iter_mut().zip(vector).for_each(|(value, own)| *value -= part * own);
            }
        }
        let length = norm(&next);
        if !length.is_finite() {
            return Ok(Outcome::Stalled(f64::NAN));
        }
        column[step + 1] = c64::new(length, 0.0);
        for (i, &(cosine, sine)) in rotations.iter().enumerate() {
            let (a, b) = (column[i], column[i + 1]);
            column[i] = cosine * a + sine * b;
            column[i + 1] = cosine * b - sine.conj() * a;
        }
        let pivot = column[step];
        let radius = pivot.norm().hypot(length);
        if radius == 0.0 {
            return Ok(Outcome::Stalled(residual));
        }
        let (cosine, sine) = if pivot.norm() == 0.0 {
            (0.0, c64::new(1.0, 0.0))
        } else {
            (pivot.norm() / radius, pivot / pivot.norm() * (length / radius))
        };
        column[step] = cosine * pivot + sine * length;
        column.truncate(step + 1);
        columns.push(column);
        rotations.push((cosine, sine));
        let last = rest[step];
        rest[step] = cosine * last;
        rest.push(-sine.conj() * last);
        residual = rest[step + 1].norm();
        if length == 0.0 {
            break;
        }
        basis.push(next.iter().map(|value| value / length).collect());
    }
    if residual > tolerance {
        return Ok(Outcome::Stalled(residual));
    }
    let mut weights = rest;
    weights.truncate(columns.len());
    for i in (0..columns.len()).rev() {
        let solved = weights[i] / columns[i][i];
        weights[i] = solved;
        for j in 0..i {
            weights[j] -= columns[i][j] * solved;
        }
    }
    let mut sum = vec![zero; right.len()];
    for (weight, vector) in weights.iter().zip(&basis) {
        let factor = weight * scale;
        sum.iter_mut().zip(vector).for_each(|(value, own)| *value += factor * own);
    }
    Ok(Outcome::Converged(preconditioner(&sum)))
}
