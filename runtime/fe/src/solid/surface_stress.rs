//! Smoothed stresses on swept surfaces: a polynomial fitted through the stresses at superconvergent
//! points around a point (superconvergent patch recovery, Zienkiewicz and Zhu 1992), across the
//! section as in plane models and along the axis.
//!
//! The fit is the product of both: the weight of a sample is that of its position in the section
//! times that of its axial coordinate. The polynomials are functions of the section's coordinates,
//! so a twist does not affect them.

use super::interpolation::{Interpolation, SolidShape};
use super::mesh::{FacePoint, FaceSet};
use super::model::{Inverse, SolidModel};
use super::swept::Swept;
use crate::mesh::{EdgeChain, ElementPoint};
use crate::sparse::SparseVector;
use crate::stress::{elements_of, fit_weights, nearness, sample_weights};
use calyx_numerics::quadrature::gauss_legendre;
use rayon::prelude::*;
use std::collections::{BTreeMap, BTreeSet};

/// Recovered stress on a free surface, as rows of the displacements.
#[derive(Clone, Debug, PartialEq)]
pub struct SurfaceStressRows {
    /// Point, with the tangents that the rows refer to.
    pub point: FacePoint,
    /// Rows for the stress along the first tangent (along the profile), along the second (nearly
    /// axial), and shear between both, Pa. On a free surface the stress has no other components.
    pub rows: [SparseVector; 3],
}

/// Stress recovery on the charts of a swept model.
pub struct SurfaceStressRecovery<'a> {
    model: &'a SolidModel,
    swept: &'a Swept,
    /// Elements of the section by its displacement node, ascending.
    elements_of: Vec<Vec<usize>>,
    /// Shape functions at the superconvergent points, by the interpolations of an element and the
    /// number of points along the axis.
    tables: BTreeMap<TableKey<'a>, Vec<Sample>>,
    /// Inverse Jacobians of each element at its own superconvergent points.
    inverses: Vec<Vec<Inverse>>,
}

/// Interpolations of displacements and coordinates, points across and along.
type TableKey<'a> = (&'a Interpolation, &'a Interpolation, [usize; 2]);

/// Shape functions at a point, of displacements and of coordinates.
type Sample = (Vec<SolidShape>, Vec<SolidShape>);

/// Largest number of layers: two layers meet at a point, and each fit includes the adjacent ones.
const MOST_LAYERS: usize = 4;

impl<'a> SurfaceStressRecovery<'a> {
    /// Prepares the recovery. `None` if the mesh is not swept.
    pub fn new(model: &'a SolidModel) -> Option<Self> {
        let swept = model.mesh.swept.as_ref()?;
        let mut tables = BTreeMap::new();
        for element in &model.mesh.elements {
            let (displacement, coordinate) = element.kinds();
            for along in 1..=usize::from(displacement.highest()[1]) {
                let key = (displacement, coordinate, [usize::from(displacement.lowest()[0]), along]);
                tables.entry(key).or_insert_with(|| {
                    let rule = displacement.cell().quadrature(key.2);
                    rule.iter()
                        .map(|&(place, _)| (displacement.shapes(place), coordinate.shapes(place)))
                        .collect()
                });
            }
        }
        let inverses = model.mesh.elements.par_iter().map(|element| {
            let (displacement, coordinate) = element.kinds();
            let table: Option<&Vec<Sample>> =
                tables.get(&(displacement, coordinate, displacement.lowest().map(usize::from)));
            let inverse = |sample: &Sample| Inverse::new(model.mesh.jacobian_of(element, &sample.1));
            table.map(|samples| samples.iter().map(inverse).collect()).unwrap_or_default()
        });
        let inverses = inverses.collect();
        Some(Self { model, swept, elements_of: elements_of(&swept.section), tables, inverses })
    }

    /// Returns an upper bound of the memory of the rows of one point, bytes: as if no two elements
    /// shared a node.
    pub fn memory_per_point(&self) -> u64 {
        let section = &self.swept.section;
        let patch = |nodes: &[usize]| {
            nodes.iter().flat_map(|&node| &self.elements_of[node]).collect::<BTreeSet<_>>().len()
        };
        let patch = section.elements.iter().map(|element| patch(&element.nodes)).max().unwrap_or(0);
        let layers = (self.swept.stations.len() - 1).min(MOST_LAYERS);
        let nodes = self.model.mesh.elements.iter().map(|element| element.nodes.len()).max().unwrap_or(0);
        // Three stress components.
        (3 * patch * layers * 3 * nodes * size_of::<(usize, f64)>()) as u64
    }

    /// Returns the rows for the smoothed stress at arc length `s` and axial coordinate `z` of a set
    /// of faces. `None` outside its chart, or without one.
    pub fn rows(&self, set: &FaceSet, s: f64, z: f64) -> Option<SurfaceStressRows> {
        let chart = set.chart.as_ref()?;
        let chain = EdgeChain { edges: chart.edges.clone(), measure: chart.measure };
        let at = self.swept.section.chain_point(&chain, s)?;
        let (layer, zeta) = self.swept.locate_z(z)?;
        let point = self.model.mesh.surface_point(set, s, z)?;
        // At the interface of two layers the result is the mean of both fits.
        let meets_next = zeta > 1.0 - 1e-9 && layer + 2 < self.swept.stations.len();
        let layers = if meets_next { &[layer, layer + 1][..] } else { &[layer] };
        let terms = self.gradient(at.place, layers, z);
        let [a, b] = point.tangents;
        let tensor = |p: [f64; 3], q: [f64; 3]| {
            [0, 1, 2].map(|i| [0, 1, 2].map(|j| 0.5 * (p[i] * q[j] + p[j] * q[i])))
        };
        let rows =
            [tensor(a, a), tensor(b, b), tensor(a, b)].map(|tensor| self.model.stress_row(&terms, tensor));
        Some(SurfaceStressRows { point, rows })
    }

    /// Returns the smoothed displacement gradient as a sum over nodes of displacement times vector:
    /// the mean of the fits around some layers.
    fn gradient(&self, place: ElementPoint, layers: &[usize], z: f64) -> Vec<(usize, [f64; 3])> {
        let mesh = &self.model.mesh;
        let count = self.swept.section.elements.len();
        let across = sample_weights(&self.swept.section, &self.elements_of, place);
        let share = 1.0 / layers.len() as f64;
        let axial = layers.iter().flat_map(|&layer| {
            let along = usize::from(mesh.elements[layer * count + place.element].interpolation.lowest()[1]);
            self.axial_weights(layer, z, along).into_iter().map(move |of_layer| (along, of_layer))
        });
        let axial = axial.collect::<Vec<_>>();
        let mut terms = Vec::new();
        let mut first = 0;
        while first < across.len() {
            let of_section = across[first].0.element;
            let weights = across[first..].iter().take_while(|(sample, _)| sample.element == of_section);
            let weights = weights.map(|(_, weight)| *weight).collect::<Vec<_>>();
            first += weights.len();
            for (along, (layer, axial)) in &axial {
                let along = *along;
                let index = layer * count + of_section;
                let element = &mesh.elements[index];
                let (displacement, coordinate) = element.kinds();
                let [across, own_along] = displacement.lowest().map(usize::from);
                let Some(table) = self.tables.get(&(displacement, coordinate, [across, along])) else {
                    continue;
                };
                let mut sums = vec![[0.0; 3]; element.nodes.len()];
                let weights = axial.iter().flat_map(|z| weights.iter().map(move |weight| share * z * weight));
                for (place, ((displacement, coordinate), weight)) in table.iter().zip(weights).enumerate() {
                    let inverse = if own_along == along {
                        self.inverses[index][place]
                    } else {
                        Inverse::new(mesh.jacobian_of(element, coordinate))
                    };
                    let rows = inverse.rows.map(|row| row.map(|part| weight * part));
                    for (sum, &[_, x, y, z]) in sums.iter_mut().zip(displacement) {
                        for axis in 0..3 {
                            sum[axis] += rows[axis][0] * x + rows[axis][1] * y + rows[axis][2] * z;
                        }
                    }
                }
                terms.extend(element.nodes.iter().copied().zip(sums));
            }
        }
        // The sort is stable, so that entries of one node are added in the order of the elements.
        terms.sort_by_key(|term| term.0);
        terms.dedup_by(|next, sum| {
            let same = next.0 == sum.0;
            if same {
                for axis in 0..3 {
                    sum.1[axis] += next.1[axis];
                }
            }
            same
        });
        terms
    }

    /// Returns the weights in the smoothed value at `z` of the Gauss points of a layer and its
    /// neighbours, with a number of points for each layer.
    fn axial_weights(&self, layer: usize, z: f64, points: usize) -> Vec<(usize, Vec<f64>)> {
        let stations = &self.swept.stations;
        let layers = (layer.saturating_sub(1)..=(layer + 1).min(stations.len() - 2)).collect::<Vec<_>>();
        let middle = |layer: usize| 0.5 * (stations[layer] + stations[layer + 1]);
        let rule = gauss_legendre(points);
        let places = layers
            .iter()
            .flat_map(|&layer| {
                let half = 0.5 * (stations[layer + 1] - stations[layer]);
                rule.iter().map(move |(zeta, _)| middle(layer) + half * zeta)
            })
            .collect::<Vec<_>>();
        let center = middle(layer);
        let size = places.iter().map(|place| (place - center).abs()).fold(f64::MIN_POSITIVE, f64::max);
        let local = |z: f64| (z - center) / size.max(0.5 * (stations[layer + 1] - stations[layer]));
        let fit = |degree: usize| {
            let terms = |z: f64| (0..=degree).map(|power| z.powi(power as i32)).collect::<Vec<_>>();
            let samples = places.iter().map(|&place| local(place)).map(|x| (terms(x), nearness(x * x)));
            fit_weights(&samples.collect::<Vec<_>>(), terms(local(z)))
        };
        // Any number of points determines a constant.
        let weights = (0..=points).rev().find_map(fit).unwrap_or_default();
        layers.into_iter().zip(weights.chunks(points).map(<[f64]>::to_vec)).collect()
    }
}
