//! Consistent loads of tractions along chains of element edges.

use super::mesh::{ArcLength, EdgeChain, EdgePoint};
use super::model::PlaneModel;
use super::sparse::SparseVector;
use calyx_numerics::quadrature::gauss_legendre;

/// Quadrature points on a smooth piece of an edge: exact for a cubic shape function times a
/// traction of degree 20.
const POINTS: usize = 12;

impl PlaneModel {
    /// Returns the load vector of a traction (Pa, x and y) along a whole chain, N per metre of face
    /// width.
    ///
    /// `traction(s, point)` must be smooth within each edge. On a profile the integral is over the
    /// profile's arc length, so the total load is the integral over the true curve, independently
    /// of the mesh.
    pub fn edge_load(
        &self,
        chain: &EdgeChain,
        traction: impl FnMut(f64, &EdgePoint) -> [f64; 2],
    ) -> SparseVector {
        self.edge_load_between(chain, chain.range(), traction)
    }

    /// Returns the load vector as [`PlaneModel::edge_load`], on the part of the chain between two
    /// arc lengths. For a traction with kinks, call it piece by piece.
    pub fn edge_load_between(
        &self,
        chain: &EdgeChain,
        range: [f64; 2],
        mut traction: impl FnMut(f64, &EdgePoint) -> [f64; 2],
    ) -> SparseVector {
        self.edge_loads_between(chain, range, |s, point| [traction(s, point)]).pop().unwrap_or_default()
    }

    /// Returns load vectors as [`PlaneModel::edge_load`], one for each of the tractions that
    /// `tractions(s, point)` returns, the same number everywhere; none if the chain has no edges.
    pub fn edge_loads<T: AsRef<[[f64; 2]]>>(
        &self,
        chain: &EdgeChain,
        tractions: impl FnMut(f64, &EdgePoint) -> T,
    ) -> Vec<SparseVector> {
        self.edge_loads_between(chain, chain.range(), tractions)
    }

    fn edge_loads_between<T: AsRef<[[f64; 2]]>>(
        &self,
        chain: &EdgeChain,
        [from, to]: [f64; 2],
        mut tractions: impl FnMut(f64, &EdgePoint) -> T,
    ) -> Vec<SparseVector> {
        let rule = gauss_legendre(POINTS);
        let mut entries: Vec<Vec<(usize, f64)>> = Vec::new();
        for edge in &chain.edges {
            let (start, end) = (from.max(edge.s[0]), to.min(edge.s[1]));
            if start >= end {
                continue;
            }
            let start = self.mesh.edge_parameter(chain.measure, edge, start);
            let half = 0.5 * (self.mesh.edge_parameter(chain.measure, edge, end) - start);
            for (x, weight) in &rule {
                let t = start + half * (1.0 + x);
                let point = self.mesh.edge_point(edge, t);
                let per_t = match chain.measure {
                    ArcLength::Profile => 0.5 * (edge.s[1] - edge.s[0]),
                    ArcLength::Mesh => point.speed,
                };
                let s = self.mesh.arc_length(chain.measure, edge, t);
                let tractions = tractions(s, &point);
                entries.resize_with(tractions.as_ref().len(), Vec::new);
                for (entries, traction) in entries.iter_mut().zip(tractions.as_ref()) {
                    let force = traction.map(|part| part * weight * half * per_t);
                    entries.extend(self.displacement_row(point.place, force).entries);
                }
            }
        }
        entries.into_iter().map(|entries| entries.into_iter().collect()).collect()
    }
}
