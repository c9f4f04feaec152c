//! Consistent loads on faces of elements.

use super::interpolation::Interpolation;
use super::line_interpolation::{equispaced, lobatto};
use super::mesh::{FacePoint, FaceSet};
use super::model::SolidModel;
use crate::sparse::SparseVector;
use calyx_numerics::interpolation::lagrange_with_slopes;
use calyx_numerics::quadrature::gauss_legendre;

/// Quadrature points across a smooth piece of a chart: exact for a cubic shape function times a
/// density of degree 12.
const POINTS: usize = 8;

impl SolidModel {
    /// Returns the load vector of a traction (Pa) on a whole set of faces, over the area of the
    /// mesh, N.
    ///
    /// `traction(point)` must be smooth within each face.
    pub fn face_load(&self, set: &FaceSet, mut traction: impl FnMut(&FacePoint) -> [f64; 3]) -> SparseVector {
        self.face_loads(set, |point| [traction(point)]).pop().unwrap_or_default()
    }

    /// Returns load vectors as [`SolidModel::face_load`], one for each of the tractions that
    /// `tractions(point)` returns, the same number everywhere; none if the set has no faces. The
    /// surface is evaluated once for all of them.
    pub fn face_loads<T: AsRef<[[f64; 3]]>>(
        &self,
        set: &FaceSet,
        mut tractions: impl FnMut(&FacePoint) -> T,
    ) -> Vec<SparseVector> {
        let mut entries: Vec<Vec<(usize, f64)>> = Vec::new();
        for &face in &set.faces {
            let element = &self.mesh.elements[face.element];
            let cell = element.interpolation.cell();
            let orders =
                [element.interpolation.highest(), element.coordinate_interpolation.highest()].concat();
            // The integrand contains the shape function, the area and a traction of similar degree.
            let points = 3 + 2 * usize::from(orders.into_iter().max().unwrap_or(1));
            // Forces on the nodes of the element, for each traction.
            let mut forces: Vec<Vec<[f64; 3]>> = Vec::new();
            for (at, weight) in cell.face_quadrature(face.face, points) {
                let point = self.mesh.face_point(face, at);
                let shapes = element.interpolation.shapes(point.place.local);
                let tractions = tractions(&point);
                forces.resize_with(tractions.as_ref().len(), || vec![[0.0; 3]; shapes.len()]);
                for (forces, traction) in forces.iter_mut().zip(tractions.as_ref()) {
                    let force = traction.map(|part| part * weight * point.area);
                    for (sum, shape) in forces.iter_mut().zip(&shapes) {
                        for axis in 0..3 {
                            sum[axis] += shape[0] * force[axis];
                        }
                    }
                }
            }
            entries.resize_with(forces.len(), Vec::new);
            for (entries, forces) in entries.iter_mut().zip(&forces) {
                for (force, &node) in
                    forces.iter().zip(&element.nodes).filter(|(force, _)| **force != [0.0; 3])
                {
                    entries.extend([0, 1, 2].map(|axis| (3 * node + axis, force[axis])));
                }
            }
        }
        entries.into_iter().map(|entries| entries.into_iter().collect()).collect()
    }

    /// Returns the load vector of a force per unit of arc length and of axial coordinate on the
    /// part of a chart with `s` and `z` between two values each, N. The density is in N/m²; a
    /// traction over the surface is the density divided by [`FacePoint::area`]. The total load is
    /// the integral of the density over the rectangle, independently of the mesh.
    ///
    /// `density(s, z, point)` must be smooth within the rectangle. `None` if the set has no chart.
    pub fn face_load_between(
        &self,
        set: &FaceSet,
        rectangle: [[f64; 2]; 2],
        density: impl FnMut(f64, f64, &FacePoint) -> [f64; 3],
    ) -> Option<SparseVector> {
        self.face_loads_between(set, rectangle, density, |_| vec![1.0])?.pop()
    }

    /// Returns load vectors as [`SolidModel::face_load_between`], one for each of the factors that
    /// `factors(z)` returns; each multiplies the density. The surface is evaluated once for all of
    /// them.
    pub fn face_loads_between(
        &self,
        set: &FaceSet,
        [[s_from, s_to], [z_from, z_to]]: [[f64; 2]; 2],
        mut density: impl FnMut(f64, f64, &FacePoint) -> [f64; 3],
        mut factors: impl FnMut(f64) -> Vec<f64>,
    ) -> Option<Vec<SparseVector>> {
        let (chart, swept) = (set.chart.as_ref()?, self.mesh.swept.as_ref()?);
        let rule = gauss_legendre(POINTS);
        let mut layers = Vec::new();
        for layer in 0..swept.stations.len() - 1 {
            let (start, end) = (z_from.max(swept.stations[layer]), z_to.min(swept.stations[layer + 1]));
            if start < end {
                layers.push((layer, piece(&rule, swept.zeta(layer, start), swept.zeta(layer, end))));
            }
        }
        let count = factors(0.5 * (z_from + z_to)).len();
        let mut entries = vec![Vec::new(); count];
        for (index, edge) in chart.edges.iter().enumerate() {
            let (start, end) = (s_from.max(edge.s[0]), s_to.min(edge.s[1]));
            if start >= end {
                continue;
            }
            // Data that depend on the position across the surface are computed once for all layers.
            let first = self.mesh.face(chart, swept, index, 0);
            let Interpolation::Axodes { section, axial } = &self.mesh.elements[first.element].interpolation
            else {
                return None;
            };
            // Only the axodes of the side contribute.
            let side = section.side_nodes(edge.side);
            let line = equispaced((side.len() - 1) as u8);
            let across = piece(&rule, first.parameter(start), first.parameter(end));
            let across = across
                .iter()
                .map(|&(t, weight)| {
                    let at = first.at_chain(t);
                    (weight * at.arc_per_t, lagrange_with_slopes(&line, first.side_coordinate(t)), at)
                })
                .collect::<Vec<_>>();
            let firsts = axial.iter().scan(0, |next, &order| {
                let first = *next;
                *next += usize::from(order) + 1;
                Some(first)
            });
            let firsts = firsts.collect::<Vec<_>>();
            let lines = side.iter().map(|&axode| lobatto(axial[axode])).collect::<Vec<_>>();
            for (layer, zetas) in &layers {
                let face = self.mesh.face(chart, swept, index, *layer);
                // Forces on the nodes of each axode, for each factor.
                let none = lines.iter().map(|line| vec![[0.0; 3]; line.len()]).collect::<Vec<_>>();
                let mut forces = vec![none; count];
                for &(zeta, z_weight) in zetas {
                    let along = face.at_axis(zeta);
                    let mut on_axode = vec![[0.0; 3]; side.len()];
                    for (s_weight, shapes, at) in &across {
                        let force = density(at.s, along.z, &face.point_of(at, &along));
                        let weight = s_weight * z_weight * face.z_per_zeta();
                        for (sum, (shape, _)) in on_axode.iter_mut().zip(shapes) {
                            for axis in 0..3 {
                                sum[axis] += shape * weight * force[axis];
                            }
                        }
                    }
                    let shapes =
                        lines.iter().map(|line| lagrange_with_slopes(line, zeta)).collect::<Vec<_>>();
                    for (factor, forces) in factors(along.z).into_iter().zip(&mut forces) {
                        for ((shapes, forces), force) in shapes.iter().zip(forces).zip(&on_axode) {
                            for (sum, (shape, _)) in forces.iter_mut().zip(shapes) {
                                for axis in 0..3 {
                                    sum[axis] += shape * factor * force[axis];
                                }
                            }
                        }
                    }
                }
                let nodes = &self.mesh.elements[face.element].nodes;
                for (entries, forces) in entries.iter_mut().zip(&forces) {
                    for (&axode, forces) in side.iter().zip(forces) {
                        for (node, force) in forces.iter().enumerate() {
                            let node = nodes[firsts[axode] + node];
                            entries.extend([0, 1, 2].map(|axis| (3 * node + axis, force[axis])));
                        }
                    }
                }
            }
        }
        Some(entries.into_iter().map(|entries| entries.into_iter().collect()).collect())
    }
}

/// Returns a quadrature rule on a piece of -1 ..= 1.
fn piece(rule: &[(f64, f64)], from: f64, to: f64) -> Vec<(f64, f64)> {
    let half = 0.5 * (to - from);
    rule.iter().map(|(x, weight)| (from + half * (1.0 + x), weight * half)).collect()
}
