//! Matrices of the whirl of rotating bodies: gyroscopic moment, and the form of the sense of whirl.
//!
//! See `docs/theory/modes.md`.

use calyx_numerics::vec3::{Vector, cross, dot};

/// Returns the skew-symmetric part of `sign M P` for a mass matrix of six rows a point, where `P`
/// rotates displacements and rotations by a right angle about the third axis. It is `M P` for a
/// mass matrix that is symmetric about this axis.
///
/// A point on a circle that moves with `Re(x exp(i w t))` in the sense of the rotation has `P x = i
/// x`. So `x* M P x / i` is twice the kinetic energy per `w²` of a forward whirl, and minus that of
/// a backward whirl.
pub fn quarter_turn_momentum(mass: &[f64], size: usize, sign: f64) -> Vec<f64> {
    // P maps the components x to y and y to -x. So the columns of M P are columns of M.
    let product = |row: usize, column: usize| match column % 3 {
        0 => mass[row * size + column + 1],
        1 => -mass[row * size + column - 1],
        _ => 0.0,
    };
    let mut matrix = vec![0.0; size * size];
    for row in 0..size {
        for column in 0..row {
            let entry = 0.5 * sign * (product(row, column) - product(column, row));
            matrix[row * size + column] = entry;
            matrix[column * size + row] = -entry;
        }
    }
    matrix
}

/// Gyroscopic moment on a body: returns the skew-symmetric matrix between rotations about three
/// axes for the spin momentum `momentum` (kg m²/s) along `axis`, by row.
pub fn gyroscopic_moment(axes: &[Vector; 3], axis: Vector, momentum: f64) -> [[f64; 3]; 3] {
    let triple = |i: usize, j: usize| {
        let [a, b] = [axes[i], axes[j]];
        momentum * dot(a, cross(b, axis))
    };
    let mut matrix = [[0.0; 3]; 3];
    for row in 0..3 {
        for column in 0..row {
            let entry = triple(row, column);
            matrix[row][column] = entry;
            matrix[column][row] = -entry;
        }
    }
    matrix
}
