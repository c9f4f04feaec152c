//! Projection of normal velocities from a surface to a coarser one of the same body.
//!
//! The sound of a body that is small against the wavelength is that of its volume flow: what its
//! walls displace in opposite directions cancels. Values of a coarse surface that are samples of
//! the velocity change this small difference by more than the coarse elements themselves. So the
//! projection conserves the volume flow: each part of the fine surface adds its flow to the coarse
//! triangle that is nearest.

use crate::mesh::SurfaceMesh;
use crate::nearest::NearestTriangle;
use calyx_numerics::vec3::{Vector, length, minus, plus, scaled};
use rayon::prelude::*;

/// Parts of a fine triangle along an edge per ratio of the lengths of fine and coarse edges.
const PARTS: f64 = 6.0;
/// Largest number of parts along an edge.
const MOST_PARTS: usize = 8;

/// Projection of normal velocities. It is the identity between equal surfaces.
#[derive(Clone, Debug)]
pub struct Projection {
    /// Coarse triangles of each fine one, with the part of its area that each receives, m².
    parts: Vec<Vec<(usize, f64)>>,
    /// Areas of the coarse triangles, m².
    areas: Vec<f64>,
}

impl Projection {
    /// Finds the projection between two surfaces of a body.
    pub fn new(fine: &SurfaceMesh, coarse: &SurfaceMesh) -> Projection {
        let areas = coarse.areas().to_vec();
        if fine.vertices() == coarse.vertices() && fine.triangles() == coarse.triangles() {
            let parts = areas.iter().enumerate().map(|(triangle, &area)| vec![(triangle, area)]).collect();
            return Projection { parts, areas };
        }
        let targets = NearestTriangle::new(coarse);
        let mean_edge = (coarse.area() / coarse.triangles().len().max(1) as f64).sqrt();
        let of_triangle = |triangle: usize| {
            let corners = fine.corners(triangle);
            let [a, b, c] = corners;
            let edge = [minus(a, b), minus(b, c), minus(c, a)].map(length).into_iter().fold(0.0, f64::max);
            let count = ((PARTS * edge / mean_edge).ceil() as usize).clamp(1, MOST_PARTS);
            let area = fine.areas()[triangle] / (count * count) as f64;
            let mut own: Vec<(usize, f64)> = Vec::new();
            for at in centroids(corners, count) {
                let target = targets.find(at, fine.normals()[triangle]);
                match own.iter_mut().find(|(other, _)| *other == target) {
                    Some((_, sum)) => *sum += area,
                    None => own.push((target, area)),
                }
            }
            own
        };
        let parts = (0..fine.triangles().len()).into_par_iter().map(of_triangle).collect();
        Projection { parts, areas }
    }

    /// Returns the normal velocities of the coarse triangles from those of the fine ones, m/s. The
    /// volume flows are equal.
    pub fn normal_velocities(&self, fine: &[f64]) -> Vec<f64> {
        let mut flows = vec![0.0; self.areas.len()];
        for (parts, velocity) in self.parts.iter().zip(fine) {
            parts.iter().for_each(|(target, area)| flows[*target] += velocity * area);
        }
        flows.iter().zip(&self.areas).map(|(flow, area)| flow / area).collect()
    }
}

/// Returns the centroids of the equal parts of a triangle whose edges are divided `count` times.
fn centroids([a, b, c]: [Vector; 3], count: usize) -> impl Iterator<Item = Vector> {
    let [first, second] = [minus(b, a), minus(c, a)].map(|edge| scaled(edge, 1.0 / count as f64));
    let at = move |i: f64, j: f64| plus(a, plus(scaled(first, i), scaled(second, j)));
    (0..count).flat_map(move |i| {
        (0..count - i).flat_map(move |j| {
            let (x, y) = (i as f64, j as f64);
            let upper = (i + j + 1 < count).then(|| at(x + 2.0 / 3.0, y + 2.0 / 3.0));
            [Some(at(x + 1.0 / 3.0, y + 1.0 / 3.0)), upper].into_iter().flatten()
        })
    })
}
