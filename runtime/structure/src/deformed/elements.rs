//! Output elements of a mesh: its cells ([`crate::mesh_cells`]) and nodal stresses.
//!
//! Stress is sampled where that of the displacements is most accurate, at the
//! Gauss points of the elements' order (Barlow 1976). It is extrapolated to the nodes by the
//! polynomials through these points, and averaged over the elements that share a node (Hinton and
//! Campbell 1974).

use crate::mesh_cells::{Outline, cells};
use calyx_fe::material::Plane;
use calyx_fe::solid::{SolidElementPoint, SolidModel};
use calyx_fe::{ElementPoint, PlaneModel};
use calyx_numerics::quadrature::gauss_legendre;
use calyx_numerics::stress::{ElementStresses, NodalStresses, Stress};
use std::collections::BTreeMap;
use std::sync::Arc;

/// Data that elements of one type share.
struct Kind {
    /// Node indices of the cells of the element, and of its single cell in coarse output.
    cells: [Vec<Vec<usize>>; 2],
    /// Local coordinates of the stress sampling points.
    samples: Vec<[f64; 3]>,
    /// Weight of each sampling point at each node.
    weights: Vec<Vec<f64>>,
    /// True if stresses are at most linear along every coordinate.
    quadratic: bool,
}

/// Element with the derivatives of its shape functions at the sampling points.
struct Element {
    kind: Arc<Kind>,
    nodes: Vec<usize>,
    /// Derivatives along x, y and z, by point and node, 1/m.
    gradients: Vec<Vec<[f64; 3]>>,
}

/// Lamé's constants, Pa, and the out-of-plane strain by the in-plane strains.
struct Law {
    lame: [f64; 2],
    across: f64,
}

/// Elements of a mesh. See the module documentation.
pub(super) struct Elements {
    /// Nodes of the mesh, m; z = 0 in a plane mesh.
    points: Vec<[f64; 3]>,
    dofs_per_node: usize,
    law: Law,
    elements: Vec<Element>,
}

impl Elements {
    /// Builds the elements of a plane mesh.
    pub fn plane(model: &PlaneModel) -> Self {
        let mut kinds = BTreeMap::new();
        let element = |(number, element): (usize, &calyx_fe::Element)| {
            let kind = kinds.entry(element.order).or_insert_with(|| {
                let places =
                    element.order.node_coordinates().into_iter().map(|[xi, eta]| [xi, eta, 0.0]).collect();
                let points = usize::from(element.order.lowest_side());
                Arc::new(Kind::new(places, [points, points, 1]))
            });
            let gradients = kind.samples.iter().map(|&[xi, eta, _]| {
                let [[x_xi, x_eta], [y_xi, y_eta]] =
                    model.mesh.jacobian(ElementPoint { element: number, xi, eta });
                let area = x_xi * y_eta - x_eta * y_xi;
                let shapes = element.order.shapes(xi, eta).into_iter();
                shapes
                    .map(|[_, a, b]| [(y_eta * a - y_xi * b) / area, (x_xi * b - x_eta * a) / area, 0.0])
                    .collect()
            });
            Element { kind: kind.clone(), nodes: element.nodes.clone(), gradients: gradients.collect() }
        };
        let elements = model.mesh.elements.iter().enumerate().map(element).collect();
        let ratio = model.material.poissons_ratio;
        let across = match model.plane {
            Plane::Strain => 0.0,
            Plane::Stress => -ratio / (1.0 - ratio),
        };
        let law = Law { lame: lame(model.material.youngs_modulus, ratio), across };
        let points = model.mesh.nodes.iter().map(|&[x, y]| [x, y, 0.0]).collect();
        Self { points, dofs_per_node: 2, law, elements }
    }

    /// Builds the elements of a three-dimensional mesh, without those that have no material.
    pub fn solid(model: &SolidModel) -> Self {
        let mut kinds = BTreeMap::new();
        let mut elements = Vec::new();
        for (number, element) in model.mesh.elements.iter().enumerate() {
            if model.mesh.absent.contains(&number) {
                continue;
            }
            let kind = kinds.entry(&element.interpolation).or_insert_with(|| {
                let [across, along] = element.interpolation.lowest().map(usize::from);
                Arc::new(Kind::new(element.interpolation.node_coordinates(), [across, across, along]))
            });
            let at = |&local: &[f64; 3]| model.gradients(SolidElementPoint { element: number, local });
            let gradients = kind.samples.iter().map(at).collect();
            elements.push(Element { kind: kind.clone(), nodes: element.nodes.clone(), gradients });
        }
        let law = Law { lame: model.lame(), across: 0.0 };
        Self { points: model.mesh.nodes.clone(), dofs_per_node: 3, law, elements }
    }

    /// Returns all elements by their cells, and by one cell each.
    pub fn outlines(&self) -> [Outline; 2] {
        [0, 1].map(|coarse| {
            let elements =
                self.elements.iter().map(|element| (&element.nodes[..], &element.kind.cells[coarse][..]));
            Outline::new(elements)
        })
    }

    /// Returns the stresses at all nodes under displacements.
    pub fn stresses(&self, displacements: &[f64]) -> NodalStresses {
        let at_nodes = |element: &Element| -> Vec<Stress> {
            let samples: Vec<Stress> = element
                .gradients
                .iter()
                .map(|shapes| self.stress(&element.nodes, shapes, displacements))
                .collect();
            let extrapolated = |weights: &Vec<f64>| {
                let mut stress = [0.0; 6];
                for (weight, sample) in weights.iter().zip(&samples) {
                    stress.iter_mut().zip(sample).for_each(|(sum, part)| *sum += weight * part);
                }
                stress
            };
            element.kind.weights.iter().map(extrapolated).collect()
        };
        let of_elements: Vec<Vec<Stress>> = self.elements.iter().map(at_nodes).collect();
        let elements = self.elements.iter().zip(&of_elements).map(|(element, stresses)| ElementStresses {
            nodes: &element.nodes,
            stresses,
            quadratic: element.kind.quadratic,
        });
        NodalStresses::averaged(&self.points, elements)
    }

    fn stress(&self, nodes: &[usize], shapes: &[[f64; 3]], displacements: &[f64]) -> Stress {
        let mut g = [[0.0; 3]; 3];
        for (&node, shape) in nodes.iter().zip(shapes) {
            let moved = &displacements[self.dofs_per_node * node..][..self.dofs_per_node];
            for (row, moved) in g.iter_mut().zip(moved) {
                row.iter_mut().zip(shape).for_each(|(sum, part)| *sum += moved * part);
            }
        }
        if self.dofs_per_node == 2 {
            g[2][2] = self.law.across * (g[0][0] + g[1][1]);
        }
        let [lambda, mu] = self.law.lame;
        let mean = lambda * (g[0][0] + g[1][1] + g[2][2]);
        let direct = |a: usize| mean + 2.0 * mu * g[a][a];
        let shear = |a: usize, b: usize| mu * (g[a][b] + g[b][a]);
        [direct(0), direct(1), direct(2), shear(1, 2), shear(2, 0), shear(0, 1)]
    }
}

fn lame(young: f64, ratio: f64) -> [f64; 2] {
    [young * ratio / ((1.0 + ratio) * (1.0 - 2.0 * ratio)), 0.5 * young / (1.0 + ratio)]
}

impl Kind {
    /// Builds the data of an element with nodes at these local coordinates, and a number of
    /// sampling points along each coordinate; one along a coordinate that the element does not
    /// have.
    fn new(places: Vec<[f64; 3]>, points: [usize; 3]) -> Self {
        let lines = points.map(|count| gauss_legendre(count).into_iter().map(|(x, _)| x).collect::<Vec<_>>());
        let tensor = |line: [&[f64]; 3]| {
            let mut all = Vec::new();
            for &zeta in line[2] {
                for &eta in line[1] {
                    all.extend(line[0].iter().map(|&xi| [xi, eta, zeta]));
                }
            }
            all
        };
        let samples = tensor([0, 1, 2].map(|axis| lines[axis].as_slice()));
        let weights = |place: &[f64; 3]| {
            let along = [0, 1, 2].map(|axis| through(&lines[axis], place[axis]));
            let factors = tensor([0, 1, 2].map(|axis| along[axis].as_slice()));
            factors.into_iter().map(|[a, b, c]| a * b * c).collect()
        };
        let quadratic = points.contains(&2) && points.iter().all(|&count| count <= 2);
        Kind { cells: cells(&places), weights: places.iter().map(weights).collect(), samples, quadratic }
    }
}

/// Returns the weights of values at points in the polynomial through them at `x`.
fn through(points: &[f64], x: f64) -> Vec<f64> {
    let others = |k: usize| points.iter().enumerate().filter(move |(other, _)| *other != k);
    (0..points.len())
        .map(|k| others(k).map(|(_, other)| (x - other) / (points[k] - other)).product())
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tests::bodies::{COARSE, Divisions, STEEL, toothed_sector};
    use calyx_numerics::stress::von_mises;

    /// Stretched plate in plane stress: the elements have an out-of-plane strain, and no
    /// out-of-plane stress. In plane strain there is such a stress.
    #[test]
    fn a_stretched_plate_has_no_stress_across_it() {
        let (sector, _) = toothed_sector(12, 1.0, COARSE);
        let moved: Vec<f64> = sector.mesh.nodes.iter().flat_map(|&[x, _]| [1e-4 * x, 0.0]).collect();
        let (young, ratio) = (STEEL.youngs_modulus * 1e-4, STEEL.poissons_ratio);
        let constrained = young / ((1.0 + ratio) * (1.0 - 2.0 * ratio));
        for (plane, [along, beside, across]) in [
            (Plane::Stress, [1.0, ratio, 0.0].map(|part| part * young / (1.0 - ratio * ratio))),
            (Plane::Strain, [1.0 - ratio, ratio, ratio].map(|part| part * constrained)),
        ] {
            let plate = PlaneModel::new(sector.mesh.clone(), STEEL, plane);
            for found in Elements::plane(&plate).stresses(&moved).stresses {
                let expected = [along, beside, across, 0.0, 0.0, 0.0];
                assert!(
                    found
                        .iter()
                        .zip(expected)
                        .all(|(found, expected)| (found - expected).abs() < 1e-9 * along)
                );
            }
        }
    }

    /// On a sector in which a smooth field is interpolated, the largest estimated error is at least
    /// the largest error, and no more than twice as large.
    #[test]
    fn estimated_errors_of_stresses_bound_the_errors() {
        for divisions in [COARSE, Divisions { rim: 6, tooth_root: 6, flank: 20, thickness: 16, ..COARSE }] {
            let (sector, _) = toothed_sector(12, 1.0, divisions);
            let size = sector.mesh.nodes.iter().fold(0.0_f64, |size, [x, y]| size.max(x.hypot(*y)));
            let [kx, ky] = [7.0 / size, 5.0 / size];
            let field = |[x, y]: [f64; 2]| [(kx * x + ky * y).sin(), (ky * x - kx * y).cos()];
            let moved: Vec<f64> = sector.mesh.nodes.iter().flat_map(|&at| field(at)).collect();
            let elements = Elements::plane(&PlaneModel::new(sector.mesh.clone(), STEEL, Plane::Strain));
            let found = elements.stresses(&moved);
            let [lambda, mu] = elements.law.lame;
            let [mut largest, mut estimated, mut ratio] = [0.0_f64; 3];
            for (&[x, y], (stress, estimate)) in
                sector.mesh.nodes.iter().zip(found.stresses.iter().zip(&found.errors))
            {
                let (along, across) = ((kx * x + ky * y).cos(), -(ky * x - kx * y).sin());
                let [xx, xy, yx, yy] = [kx * along, ky * along, ky * across, -kx * across];
                let mean = lambda * (xx + yy);
                let exact = [mean + 2.0 * mu * xx, mean + 2.0 * mu * yy, mean, 0.0, 0.0, mu * (xy + yx)];
                let error = von_mises(std::array::from_fn(|k| stress[k] - exact[k]));
                largest = largest.max(error);
                estimated = estimated.max(*estimate);
                ratio = ratio.max(error / estimate);
            }
            assert!((1.0..2.0).contains(&(estimated / largest)), "{largest:e} {estimated:e}");
            assert!(ratio < 1.0, "{ratio}");
        }
    }
}
