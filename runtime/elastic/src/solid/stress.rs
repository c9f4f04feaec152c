//! Stresses of solid elements at their nodes.

use super::{SolidElement, mode_coefficients, with_incompatible_modes};
use crate::error::ElementError;
use crate::model::SolidShape;
use nalgebra::{DVector, Matrix3, Vector3};

/// Returns the stresses xx, yy, zz, yz, zx, xy at each node, Pa, from the displacements of the
/// nodes, m, along the basic axes. Linear elements without incompatible modes have those of their
/// centre at all nodes.
///
/// # Errors
/// The element is degenerate.
pub fn nodal_stresses(
    element: &SolidElement<'_>,
    displacements: &[[f64; 3]],
) -> Result<Vec<[f64; 6]>, ElementError> {
    let points = sampling_points(element.shape);
    let mut moved = displacements.to_vec();
    if element.shape == SolidShape::IncompatibleHexahedron8 {
        moved.extend(mode_amplitudes(element, displacements)?);
    }
    let stresses = points.iter().map(|&point| stress_at(element, &moved, point));
    let stresses = stresses.collect::<Result<Vec<_>, _>>()?;
    if element.shape == SolidShape::IncompatibleHexahedron8 {
        return Ok(extrapolated(&stresses));
    }
    Ok(match stresses[..] {
        [single] => vec![single; element.positions.len()],
        _ => stresses,
    })
}

/// Returns the amplitudes of the incompatible modes, m.
fn mode_amplitudes(
    element: &SolidElement<'_>,
    displacements: &[[f64; 3]],
) -> Result<Vec<[f64; 3]>, ElementError> {
    let components = DVector::from_iterator(3 * displacements.len(), displacements.iter().flatten().copied());
    let coefficients = mode_coefficients(&with_incompatible_modes(element)?, components.len())?;
    let amplitudes = coefficients * components;
    Ok(amplitudes.as_slice().chunks_exact(3).map(|mode| [mode[0], mode[1], mode[2]]).collect())
}

/// Returns the stresses at the corners of a hexahedron, from those at the Gauss points next to
/// them. The Jacobian of a distorted element may be singular at a corner.
fn extrapolated(at_points: &[[f64; 6]]) -> Vec<[f64; 6]> {
    let corners = SolidShape::IncompatibleHexahedron8.corners();
    let at = |corner: &[f64; 3]| {
        let mut stress = [0.0; 6];
        for (point, own) in corners.iter().zip(at_points) {
            let weight: f64 = (0..3).map(|k| 0.5 * (1.0 + 3.0_f64.sqrt() * corner[k] * point[k])).product();
            (0..6).for_each(|k| stress[k] += weight * own[k]);
        }
        stress
    };
    corners.iter().map(at).collect()
}

/// Returns the nodes of quadratic elements, the Gauss points next to the corners of those with
/// incompatible modes, and the centre of other linear ones, whose strains at the nodes include
/// those of a parasitic shear.
fn sampling_points(shape: SolidShape) -> Vec<[f64; 3]> {
    match shape {
        SolidShape::Hexahedron8 => vec![[0.0; 3]],
        SolidShape::IncompatibleHexahedron8 => {
            shape.corners().iter().map(|corner| corner.map(|x| x / 3.0_f64.sqrt())).collect()
        }
        SolidShape::Wedge6 => vec![[1.0 / 3.0, 1.0 / 3.0, 0.0]],
        SolidShape::Tetrahedron4 => vec![[0.25; 3]],
        SolidShape::Hexahedron20 | SolidShape::Wedge15 | SolidShape::Tetrahedron10 => {
            let corners = shape.corners();
            let middle = |&[one, other]: &[usize; 2]| -> [f64; 3] {
                std::array::from_fn(|axis| 0.5 * (corners[one][axis] + corners[other][axis]))
            };
            corners.iter().copied().chain(shape.midside_edges().iter().map(middle)).collect()
        }
    }
}

fn stress_at(
    element: &SolidElement<'_>,
    displacements: &[[f64; 3]],
    point: [f64; 3],
) -> Result<[f64; 6], ElementError> {
    let gradients = element.at(point, 1.0)?.gradients;
    let mut gradient = Matrix3::zeros();
    for (shape, displacement) in gradients.iter().zip(displacements) {
        gradient += Vector3::from(*displacement) * shape.transpose();
    }
    let strain = 0.5 * (gradient + gradient.transpose());
    let (modulus, ratio) = (element.material.youngs_modulus, element.material.poissons_ratio);
    let lame = modulus * ratio / ((1.0 + ratio) * (1.0 - 2.0 * ratio));
    let stress = Matrix3::identity() * (lame * strain.trace()) + strain * (modulus / (1.0 + ratio));
    Ok([stress[(0, 0)], stress[(1, 1)], stress[(2, 2)], stress[(1, 2)], stress[(2, 0)], stress[(0, 1)]])
}
