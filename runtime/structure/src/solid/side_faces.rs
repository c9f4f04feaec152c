//! Free side faces next to a surface of any shape: the planes in which the half-space has images.
//!
//! Side faces of bevel teeth are cones. The image of a load next to a side face is its reflection
//! in the plane that touches the face where the surface ends. The plane depends on `u`; for two
//! points it is that of their mean `u`, so that each is equally far from the image of the other.

use super::Mirror;
use crate::surface::Surface;
use calyx_fe::EdgeChain;
use calyx_fe::solid::{FaceSet, SolidElementPoint, SolidMesh};
use calyx_numerics::vec3::{Vector, cross, dot, minus, plus, scaled, unit};
use serde::{Deserialize, Serialize};

/// Number of intervals of the table of normals.
const INTERVALS: usize = 32;

/// Normals of the two side faces along the ends of a surface.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct SideFaces {
    /// First `u` of the table, and the distance of its entries.
    start: f64,
    step: f64,
    /// Unit normals, out of the body, at the start and at the end of `v`.
    normals: [Vec<Vector>; 2],
}

impl SideFaces {
    /// Reads the normals from a mesh that ends at the side faces. `None` if the set of faces has no
    /// chart.
    pub fn of(mesh: &SolidMesh, set: &FaceSet, surface: &dyn Surface) -> Option<Self> {
        let (chart, swept) = (set.chart.as_ref()?, mesh.swept.as_ref()?);
        let chain = EdgeChain { edges: chart.edges.clone(), measure: chart.measure };
        let [start, end] = chain.range();
        let step = (end - start) / INTERVALS as f64;
        let ends = surface.range()[1];
        let last_layer = (swept.stations.len() - 2) * swept.section.elements.len();
        let normal = |side: usize, u: f64| {
            let place = swept.section.chain_point(&chain, u)?.place;
            let (layer, zeta, sign) = [(0, -1.0, -1.0), (last_layer, 1.0, 1.0)][side];
            let place =
                SolidElementPoint { element: layer + place.element, local: [place.xi, place.eta, zeta] };
            let jacobian = mesh.jacobian(place);
            let [by_xi, by_eta] = [0, 1].map(|local| [0, 1, 2].map(|axis| jacobian[axis][local]));
            let outward = unit(scaled(cross(by_xi, by_eta), sign));
            // The end of the true surface lies in the plane to first order.
            let along = unit(surface.at(u, ends[side]).tangents[0]);
            Some(unit(minus(outward, scaled(along, dot(outward, along)))))
        };
        let table = |side: usize| {
            (0..=INTERVALS)
                .map(|index| normal(side, (start + step * index as f64).min(end)))
                .collect::<Option<Vec<_>>>()
        };
        Some(Self { start, step, normals: [table(0)?, table(1)?] })
    }

    /// Builds side faces with the same normals along the whole surface.
    #[cfg(test)]
    pub fn plane([start, end]: [f64; 2], normals: [Vector; 2]) -> Self {
        let step = (end - start) / INTERVALS as f64;
        Self { start, step, normals: normals.map(|normal| vec![normal; INTERVALS + 1]) }
    }

    /// Returns the unit normal at the start (0) or the end (1) of `v`, at `u`.
    pub fn normal(&self, side: usize, u: f64) -> Vector {
        let at = ((u - self.start) / self.step).clamp(0.0, INTERVALS as f64);
        let index = (at as usize).min(INTERVALS - 1);
        let share = at - index as f64;
        let [a, b] = [0, 1].map(|next| self.normals[side][index + next]);
        unit(plus(scaled(a, 1.0 - share), scaled(b, share)))
    }

    /// Returns the plane that touches the side face at the start (0) or the end (1) of the surface,
    /// at `u`.
    pub fn mirror(&self, surface: &dyn Surface, side: usize, u: f64) -> Mirror {
        let v = surface.range()[1][side];
        Mirror { point: surface.at(u, v).position, normal: self.normal(side, u) }
    }

    /// Returns the memory, in bytes.
    pub fn bytes(&self) -> usize {
        self.normals.iter().map(|normals| size_of_val(normals.as_slice())).sum()
    }

    /// Returns whether restored tables are complete.
    pub fn is_sound(&self) -> bool {
        self.step > 0.0 && self.normals.iter().all(|normals| normals.len() == INTERVALS + 1)
    }
}
