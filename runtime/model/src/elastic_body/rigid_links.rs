//! Rigid body between attachments, as very stiff links.

use super::supports::SupportRow;
use calyx_numerics::vec3::{Vector, minus};

/// Returns the stiffness of links that join all attachments at these positions (m) to the first
/// one, row-major: `stiffness` (N/m) against displacements, and times `size` squared (m) against
/// rotations. Rigid-body motions cause no forces. The link of the last attachment resists only the
/// motions of an orthonormal basis, if there is one, with rotations times `size`.
pub fn rigid_links(
    positions: &[Vector],
    stiffness: f64,
    size: f64,
    last_resists: Option<&[SupportRow]>,
) -> Vec<f64> {
    let rows = 6 * positions.len();
    let mut matrix = vec![0.0; rows * rows];
    for (index, position) in positions.iter().enumerate().skip(1) {
        // Strain of the link: motion of the attachment minus that of the first one carried along.
        let carried = carried(minus(*position, positions[0]));
        let strain_of = |component: usize, factor: f64| {
            let own = [(6 * index + component, factor)];
            let first = (0..6).map(move |k| (k, -factor * carried[component][k]));
            own.into_iter().chain(first.filter(|(_, part)| *part != 0.0))
        };
        let mut add = |strain: &[(usize, f64)], weight: f64| {
            for &(row, one) in strain {
                for &(column, other) in strain {
                    matrix[row * rows + column] += weight * one * other;
                }
            }
        };
        match last_resists.filter(|_| index + 1 == positions.len()) {
            Some(resisted) => {
                for motion in resisted {
                    let scaled = |k: usize| motion[k] * if k < 3 { 1.0 } else { size };
                    let strain: Vec<_> = (0..6).flat_map(|k| strain_of(k, scaled(k))).collect();
                    add(&strain, stiffness);
                }
            }
            None => {
                for component in 0..6 {
                    let weight = if component < 3 { stiffness } else { stiffness * size * size };
                    add(&strain_of(component, 1.0).collect::<Vec<_>>(), weight);
                }
            }
        }
    }
    matrix
}

/// Returns the motion of a point at `arm` (m) from the origin, by row, from the motion of a rigid
/// body at the origin.
pub(super) fn carried([x, y, z]: Vector) -> [[f64; 6]; 6] {
    let mut motion = [[0.0; 6]; 6];
    for (k, row) in motion.iter_mut().enumerate() {
        row[k] = 1.0;
    }
    // u + theta x r
    motion[0][4] = z;
    motion[0][5] = -y;
    motion[1][3] = -z;
    motion[1][5] = x;
    motion[2][3] = y;
    motion[2][4] = -x;
    motion
}
