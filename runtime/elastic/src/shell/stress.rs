//! Stresses of shells on their outer surfaces.

use super::ShellElement;
use super::kinematics::{Sample, contravariant, conversion, lamina};
use crate::error::ElementError;
use crate::model::ShellShape;
use calyx_numerics::vec3::cross;
use nalgebra::{DMatrix, Matrix3, Vector3};

/// Returns the stresses xx, yy, zz, yz, zx, xy at each node, Pa, on the surface against the normal
/// and on the surface along it, from the displacements and rotations of the nodes, m and rad, along
/// the basic axes. Transverse shear vanishes on the surfaces. Linear elements have the stresses of
/// their centre at all nodes.
///
/// # Errors
/// The element is degenerate.
pub fn surface_stresses(
    element: &ShellElement<'_>,
    displacements: &[[f64; 6]],
) -> Result<Vec<[[f64; 6]; 2]>, ElementError> {
    let prepared = element.prepared()?;
    // Displacements of the mid-surface and their derivatives by the thickness coordinate.
    let mut motion = DMatrix::zeros(6 * displacements.len(), 1);
    for (node, &[ux, uy, uz, rx, ry, rz]) in displacements.iter().enumerate() {
        let by_offset = cross([rx, ry, rz], prepared.offsets[node]);
        let across = cross([rx, ry, rz], prepared.middle.half[node]);
        for axis in 0..3 {
            motion[(6 * node + axis, 0)] = [ux, uy, uz][axis] + by_offset[axis];
            motion[(6 * node + 3 + axis, 0)] = across[axis];
        }
    }
    let material = element.material;
    let (modulus, ratio) = (material.youngs_modulus, material.poissons_ratio);
    let plane = modulus / (1.0 - ratio * ratio);
    let on_surface = |at: [f64; 2], zeta: f64| -> Result<[f64; 6], ElementError> {
        let sample = Sample::isoparametric(element.shape.shapes(at));
        let base = prepared.middle.base(&sample, zeta);
        let dual = contravariant(&base)
            .ok_or_else(|| ElementError::new("the shell element is degenerate", "move its nodes apart"))?;
        let local = lamina(&base, base[0]);
        let strains = conversion(&dual, &local) * prepared.middle.covariant(&sample, zeta) * &motion;
        let [along, across] = [strains[0] + ratio * strains[1], strains[1] + ratio * strains[0]];
        let [along, across, shear] =
            [plane * along, plane * across, 0.5 * modulus / (1.0 + ratio) * strains[2]];
        let [r, s] = [local[0], local[1]].map(Vector3::from);
        let stress: Matrix3<f64> = along * r * r.transpose()
            + across * s * s.transpose()
            + shear * (r * s.transpose() + s * r.transpose());
        Ok([stress[(0, 0)], stress[(1, 1)], stress[(2, 2)], stress[(1, 2)], stress[(2, 0)], stress[(0, 1)]])
    };
    let points = sampling_points(element.shape);
    let both = |&at: &[f64; 2]| Ok([on_surface(at, -1.0)?, on_surface(at, 1.0)?]);
    let stresses = points.iter().map(both).collect::<Result<Vec<_>, ElementError>>()?;
    Ok(match stresses[..] {
        [single] => vec![single; displacements.len()],
        _ => stresses,
    })
}

/// Returns the nodes of quadratic elements and the centre of linear ones.
fn sampling_points(shape: ShellShape) -> Vec<[f64; 2]> {
    match shape {
        ShellShape::Triangle3 => vec![[1.0 / 3.0; 2]],
        ShellShape::Quadrilateral4 => vec![[0.0; 2]],
        ShellShape::Triangle6 | ShellShape::Quadrilateral8 | ShellShape::Quadrilateral9 => {
            shape.node_coordinates()
        }
    }
}
