//! Stress tensors, and their averages at the nodes of a mesh with an estimate of the error.

use crate::vec3::{Vector, minus};
use nalgebra::{Matrix3, SMatrix, SVector, Vector3};

/// Second moments below this fraction of the largest are those of a plane element.
const FLAT: f64 = 1e-6;

/// Stresses xx, yy, zz, yz, zx, xy, Pa.
pub type Stress = [f64; 6];

/// Computes the von Mises stress.
pub fn von_mises([xx, yy, zz, yz, zx, xy]: Stress) -> f64 {
    let direct = (xx - yy).powi(2) + (yy - zz).powi(2) + (zz - xx).powi(2);
    (0.5 * direct + 3.0 * (yz * yz + zx * zx + xy * xy)).sqrt()
}

/// Transforms stresses to new axes; the rows of `rotation` are the new axes along the old ones.
pub fn rotated(rotation: &[[f64; 3]; 3], [xx, yy, zz, yz, zx, xy]: Stress) -> Stress {
    let tensor = [[xx, xy, zx], [xy, yy, yz], [zx, yz, zz]];
    let at = |a: usize, b: usize| {
        (0..3)
            .flat_map(|k| (0..3).map(move |l| (k, l)))
            .map(|(k, l)| rotation[a][k] * tensor[k][l] * rotation[b][l])
            .sum()
    };
    [at(0, 0), at(1, 1), at(2, 2), at(1, 2), at(2, 0), at(0, 1)]
}

/// Stresses at the nodes of a mesh.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct NodalStresses {
    /// Mean of the elements at each node, Pa; NaN at nodes without elements.
    pub stresses: Vec<Stress>,
    /// Estimated error of each as a von Mises stress, Pa; NaN where there is no estimate.
    pub errors: Vec<f64>,
}

/// Stresses of an element at its nodes.
#[derive(Clone, Copy, Debug)]
pub struct ElementStresses<'a> {
    /// Nodes of the element.
    pub nodes: &'a [usize],
    /// Stress at each, Pa.
    pub stresses: &'a [Stress],
    /// True if displacements are quadratic, so that stresses are linear within the element.
    pub quadratic: bool,
}

/// Error of quadratic elements relative to the difference between an element and the linear fields
/// of its neighbours at its centre. It is 1/6 for two equal elements in a row, and 0.29 for eight
/// around a node.
const OF_LINEAR_FIELDS: f64 = 1.0 / 3.0;

impl NodalStresses {
    /// Averages the stresses of elements on a mesh with these points, m.
    ///
    /// The error is estimated by the difference between averaged stresses and those of the elements
    /// (Zienkiewicz and Zhu 1987): for an element the largest von Mises stress of the difference at
    /// its nodes, for a node the largest of its elements. A node of a single element, such as a
    /// corner, has no difference of its own, and takes it from the other nodes of the element. An
    /// element that shares no node has no estimate.
    ///
    /// Neighbouring quadratic elements err alike at their nodes, so their difference is smaller
    /// than the error. Their estimate is at least a fraction of the difference between the stress
    /// at the centre of an element and the linear fields of its neighbours there.
    pub fn averaged<'a>(
        points: &[Vector],
        elements: impl Iterator<Item = ElementStresses<'a>> + Clone,
    ) -> NodalStresses {
        let mut sums = vec![([0.0; 6], 0_u32); points.len()];
        let mut fields = vec![LinearField::default(); points.len()];
        for ElementStresses { nodes, stresses, quadratic } in elements.clone() {
            let own = if quadratic { LinearField::of(points, nodes, stresses) } else { None };
            for (&node, stress) in nodes.iter().zip(stresses) {
                let (sum, number) = &mut sums[node];
                sum.iter_mut().zip(stress).for_each(|(sum, part)| *sum += part);
                *number += 1;
                if let Some(own) = own {
                    fields[node].add(&own);
                }
            }
        }
        let mean = |(sum, number): &(Stress, u32)| match number {
            0 => [f64::NAN; 6],
            _ => sum.map(|part| part / f64::from(*number)),
        };
        let stresses: Vec<Stress> = sums.iter().map(mean).collect();
        let mut errors = vec![f64::NAN; points.len()];
        for ElementStresses { nodes, stresses: own, quadratic } in elements {
            if nodes.iter().all(|&node| sums[node].1 < 2) {
                continue;
            }
            let differences = nodes.iter().zip(own).map(|(&node, own)| {
                let mean = &stresses[node];
                von_mises(std::array::from_fn(|k| own[k] - mean[k]))
            });
            let mut error = differences.fold(0.0, f64::max);
            if let (true, Some(field)) = (quadratic, LinearField::of(points, nodes, own)) {
                let apart = nodes.iter().filter_map(|&node| fields[node].difference_at_centre_of(&field));
                error = apart.fold(error, |most, apart| most.max(OF_LINEAR_FIELDS * apart));
            }
            // `max` ignores NaN.
            nodes.iter().for_each(|&node| errors[node] = errors[node].max(error));
        }
        NodalStresses { stresses, errors }
    }
}

/// Linear stress field of an element, or the sum of several.
#[derive(Clone, Copy, Default)]
struct LinearField {
    count: f64,
    /// Mean position of the nodes, m.
    centre: Vector,
    /// Value at the origin.
    constant: Stress,
    /// Derivatives along x, y and z, 1/m.
    gradient: [Stress; 3],
}

impl LinearField {
    /// Fits a field to the stresses at the nodes of an element; `None` without volume or area. A
    /// plane element has no derivative along its normal.
    fn of(points: &[Vector], nodes: &[usize], stresses: &[Stress]) -> Option<LinearField> {
        let count = nodes.len() as f64;
        let centre: Vector =
            std::array::from_fn(|axis| nodes.iter().map(|&node| points[node][axis]).sum::<f64>() / count);
        let mean: Stress = std::array::from_fn(|k| stresses.iter().map(|own| own[k]).sum::<f64>() / count);
        let mut moments = Matrix3::zeros();
        let mut products = SMatrix::<f64, 3, 6>::zeros();
        for (&node, own) in nodes.iter().zip(stresses) {
            let by = Vector3::from(minus(points[node], centre));
            moments += by * by.transpose();
            products += by * SVector::<f64, 6>::from(*own).transpose();
        }
        let inverse = moments.pseudo_inverse(FLAT * moments.norm()).ok()?;
        let slopes = inverse * products;
        let gradient: [Stress; 3] = std::array::from_fn(|axis| std::array::from_fn(|k| slopes[(axis, k)]));
        let constant = std::array::from_fn(|k| {
            mean[k] - (0..3).map(|axis| gradient[axis][k] * centre[axis]).sum::<f64>()
        });
        Some(LinearField { count: 1.0, centre, constant, gradient })
    }

    fn add(&mut self, other: &LinearField) {
        self.count += other.count;
        self.constant.iter_mut().zip(other.constant).for_each(|(sum, part)| *sum += part);
        let parts = self.gradient.iter_mut().flatten().zip(other.gradient.as_flattened());
        parts.for_each(|(sum, part)| *sum += part);
    }

    /// Returns the von Mises stress of the difference between an element and the mean of the other
    /// fields in this sum at the element's centre, Pa; `None` without others.
    fn difference_at_centre_of(&self, own: &LinearField) -> Option<f64> {
        let at = |field: &LinearField, k: usize| {
            field.constant[k] + (0..3).map(|axis| field.gradient[axis][k] * own.centre[axis]).sum::<f64>()
        };
        let others = self.count - own.count;
        let difference = |k: usize| (at(self, k) - at(own, k)) / others - at(own, k);
        (others > 0.0).then(|| von_mises(std::array::from_fn(difference)))
    }
}
