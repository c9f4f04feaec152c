//! Seats of elastic bodies that are the raceways of bearings: their radial displacement as a
//! series.
//!
//! The coefficients `r` of the series fit the radial displacement of the nodes of a seat in the
//! mean square, with the areas of the nodes as weights. The motion of the attachment is subtracted,
//! so that rigid-body motion leaves `r` at zero. Conjugate to a coefficient are radial forces on
//! the nodes with the opposite resultant on the attachment. With the motions `u` of the attachments
//! and the forces `f` on the coefficients, the body has
//!
//! ```text
//! r = A u + C f,    forces of the attachments = K u - A' f .
//! ```
//!
//! See `docs/theory/rolling-bearings.md`.

use super::extent::CylinderAxis;
use calyx_elastic::attachment::{Connection, transverse};
use calyx_elastic::surface::node_areas;
use calyx_elastic::{ElasticModel, ElementError, NodalLoad};
use calyx_numerics::vec3::{Vector, cross, dot, minus, scaled};
use calyx_structure::Raceway;
use nalgebra::{DMatrix, DVector, SymmetricEigen};
use std::collections::HashSet;

/// Least eigenvalue of the products of the terms over the nodes, relative to those over the
/// cylinder, with which the nodes resolve the series.
const RESOLVED: f64 = 0.2;
/// Least highest harmonic of a raceway: it becomes oval.
const LEAST_HARMONICS: u16 = 2;
/// Largest highest harmonic that is chosen for a raceway, and that may be requested.
const MOST_HARMONICS: u16 = 20;
const HIGHEST_HARMONIC: u16 = 60;
/// Largest degree of the polynomials along a raceway.
const MOST_DEGREE: u8 = 3;
/// Distance of a node from the axis, relative to the radius, from which it belongs to a raceway.
const NEAR_AXIS: f64 = 0.5;
/// Distance of the attachment from the axis of its cylinder, relative to the radius, up to which it
/// is on the axis.
const ON_AXIS: f64 = 1e-6;

/// Width of a raceway, relative to the radius, below which its nodes are on a circle.
const ON_CIRCLE: f64 = 1e-6;

/// Raceway in the region of an attachment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SeatRaceway {
    /// Series of the radial displacement. Its ends are axial distances from the attachment.
    pub raceway: Raceway,
    /// Axes of the raceway along those of the body: from the axis to the angle 0, to a quarter
    /// turn, and along the axis.
    pub axes: [Vector; 3],
    /// Plane-strain modulus `E / (1 - nu²)` of the elements at the raceway, Pa: their
    /// harmonic mean.
    pub modulus: f64,
}

/// Nodes of an attachment.
pub(super) struct SeatRegion<'a> {
    /// Indices of the nodes.
    pub nodes: &'a [usize],
    /// Position of the attachment node, m.
    pub position: Vector,
    /// Axis and radius (m), if they are on a cylinder.
    pub cylinder: Option<(CylinderAxis, f64)>,
}

/// Fit of the series of a seat to the displacements of its nodes.
pub(super) struct Fit {
    pub seat: SeatRaceway,
    /// Directions of the radial displacements of the nodes.
    radial: Vec<Vector>,
    /// Coefficients by radial displacements: terms by nodes.
    coefficients: DMatrix<f64>,
}

impl Fit {
    /// Fits the series of an attachment. `None` without a raceway.
    ///
    /// # Errors
    /// The region is no cylinder, or its nodes do not resolve the series.
    pub fn new(
        model: &ElasticModel,
        region: &SeatRegion<'_>,
        connection: &Connection,
    ) -> Result<Option<Fit>, ElementError> {
        let Connection::Raceway { harmonics, degree } = *connection else { return Ok(None) };
        let SeatRegion { nodes, position, cylinder } = *region;
        let is_possible = harmonics.is_none_or(|own| (LEAST_HARMONICS..=HIGHEST_HARMONIC).contains(&own));
        if degree > MOST_DEGREE || !is_possible {
            return Err(ElementError::new(
                format!(
                    "the series of a raceway has {LEAST_HARMONICS} to {HIGHEST_HARMONIC} harmonics and a degree of at most {MOST_DEGREE}"
                ),
                "correct `raceway_harmonics` or `raceway_degree`",
            ));
        }
        let cylinder = cylinder.filter(|_| nodes.len() > 1);
        let Some((axis, radius)) = cylinder else {
            return Err(ElementError::new(
                "a raceway needs a cylinder",
                "give its nodes by `gears.cylinder_region`",
            ));
        };
        if axis.distance(position) > ON_AXIS * radius {
            return Err(ElementError::new(
                "the position of a raceway is not on its axis",
                "leave `position` out, or give a point on the axis of the cylinder",
            ));
        }
        let [start, side] = transverse(axis.direction.into());
        let axes = [start.into(), side.into(), axis.direction];
        let from = |&node: &usize| minus(model.nodes[node].position, position);
        let local = |node: &usize| axes.map(|axis| dot(axis, from(node)));
        let places: Vec<Vector> = nodes.iter().map(local).collect();
        if places.iter().any(|[x, y, _]| x.hypot(*y) < NEAR_AXIS * radius) {
            return Err(ElementError::new(
                "a node of the raceway is near its axis",
                "reduce the tolerance of the region, so that it contains the nodes of the bore only",
            ));
        }
        let heights = || places.iter().map(|[_, _, z]| *z);
        let mut ends = [heights().fold(f64::INFINITY, f64::min), heights().fold(f64::NEG_INFINITY, f64::max)];
        if ends[1] - ends[0] < ON_CIRCLE * radius {
            ends = [0.5 * (ends[0] + ends[1]); 2];
        }
        let areas = node_areas(model, nodes);
        // Nodes on a line, such as the edge of a shell, have no area.
        let has_area = areas.iter().any(|&area| area != 0.0);
        let weights = if has_area { areas } else { vec![1.0; places.len()] };
        let series = |harmonics| Raceway { radius, ends, harmonics, degree };
        let fitted = match harmonics {
            Some(harmonics) => {
                coefficients(&series(harmonics), &places, &weights).map(|found| (harmonics, found))
            }
            None => (LEAST_HARMONICS..=MOST_HARMONICS).rev().find_map(|harmonics| {
                Some((harmonics, coefficients(&series(harmonics), &places, &weights)?))
            }),
        };
        let Some((harmonics, coefficients)) = fitted else {
            return Err(ElementError::new(
                format!(
                    "its {} nodes do not resolve a raceway of {} harmonics around and the degree {degree} along the axis",
                    places.len(),
                    harmonics.unwrap_or(LEAST_HARMONICS)
                ),
                "reduce `raceway_harmonics` or `raceway_degree`, or refine the mesh of the seat",
            ));
        };
        let radial = places.iter().map(|[x, y, _]| {
            let size = x.hypot(*y);
            std::array::from_fn(|k| (x * axes[0][k] + y * axes[1][k]) / size)
        });
        Ok(Some(Fit {
            seat: SeatRaceway { raceway: series(harmonics), axes, modulus: surface_modulus(model, nodes) },
            radial: radial.collect(),
            coefficients,
        }))
    }

    /// Returns the load case conjugate to each coefficient; `reference` is the attachment node.
    pub fn cases(&self, model: &ElasticModel, nodes: &[usize], reference: usize) -> Vec<Vec<NodalLoad>> {
        let about = model.nodes[reference].position;
        let case = |term: usize| {
            let mut opposite = [0.0; 6];
            let mut loads = Vec::with_capacity(nodes.len() + 1);
            for (place, &node) in nodes.iter().enumerate() {
                let force = scaled(self.radial[place], self.coefficients[(term, place)]);
                let moment = cross(minus(model.nodes[node].position, about), force);
                for k in 0..3 {
                    opposite[k] -= force[k];
                    opposite[3 + k] -= moment[k];
                }
                let [x, y, z] = force;
                loads.push(NodalLoad { node, load: [x, y, z, 0.0, 0.0, 0.0] });
            }
            loads.push(NodalLoad { node: reference, load: opposite });
            loads
        };
        (0..self.coefficients.nrows()).map(case).collect()
    }
}

/// Returns the harmonic mean of the plane-strain moduli of the elements at some nodes, Pa, each
/// weighted by its number of these nodes.
fn surface_modulus(model: &ElasticModel, nodes: &[usize]) -> f64 {
    let within: HashSet<usize> = nodes.iter().copied().collect();
    let [mut compliance, mut count] = [0.0; 2];
    for element in &model.elements {
        let Some(material) = element.material.and_then(|material| model.materials.get(material)) else {
            continue;
        };
        let shared = element.nodes.iter().filter(|node| within.contains(node)).count() as f64;
        let lateral = material.poissons_ratio * material.poissons_ratio;
        compliance += shared * (1.0 - lateral) / material.youngs_modulus;
        count += shared;
    }
    // Without elements nothing is subtracted.
    if count > 0.0 { count / compliance } else { f64::INFINITY }
}

/// Returns the coefficients of a series that fits values at places along the axes of a seat (terms
/// by places), with these weights; `None` if the places do not resolve it.
fn coefficients(raceway: &Raceway, places: &[Vector], weights: &[f64]) -> Option<DMatrix<f64>> {
    let columns = places.iter().map(|[x, y, z]| raceway.terms_at(y.atan2(*x), *z).into());
    let terms = DMatrix::from_columns(&columns.collect::<Vec<DVector<f64>>>());
    let whole: f64 = weights.iter().sum();
    let weighted = DMatrix::from_fn(terms.nrows(), terms.ncols(), |term, place| {
        terms[(term, place)] * weights[place] / whole
    });
    let products = &weighted * terms.transpose();
    let norms = raceway.mean_squares();
    let relative = DMatrix::from_fn(norms.len(), norms.len(), |row, column| {
        0.5 * (products[(row, column)] + products[(column, row)]) / (norms[row] * norms[column]).sqrt()
    });
    let least = SymmetricEigen::new(relative).eigenvalues.min();
    let inverse = products.try_inverse().filter(|_| least >= RESOLVED)?;
    Some(inverse * weighted)
}
