//! Rigid body between attachments, as very stiff links.

use calyx_numerics::vec3::{Vector, minus};

/// Returns the stiffness of links that join all attachments at these positions (m) to the first
/// one, row-major: `stiffness` (N/m) against displacements, and times `size` squared (m) against
/// rotations. Rigid-body motions cause no forces.
pub fn rigid_links(positions: &[Vector], stiffness: f64, size: f64) -> Vec<f64> {
    let rows = 6 * positions.len();
    let mut matrix = vec![0.0; rows * rows];
    for (index, position) in positions.iter().enumerate().skip(1) {
        // Strain of the link: motion of the attachment minus that of the first one carried along.
        let carried = carried(minus(*position, positions[0]));
        for component in 0..6 {
            let mut strain = vec![(6 * index + component, 1.0)];
            strain.extend((0..6).map(|k| (k, -carried[component][k])).filter(|(_, part)| *part != 0.0));
            let weight = if component < 3 { stiffness } else { stiffness * size * size };
            for &(row, one) in &strain {
                for &(column, other) in &strain {
                    matrix[row * rows + column] += weight * one * other;
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
