//! The section and the layers from which a solid mesh was swept.

use crate::mesh::{ArcLength, EdgeChain, ElementEdge, PlaneMesh};

/// Origin of a swept mesh. Element `layer * section.elements.len() + k` is element `k` of the
/// section between stations `layer` and `layer + 1`.
#[derive(Clone, Debug, PartialEq)]
pub struct Swept {
    /// Section in its own coordinates.
    pub section: PlaneMesh,
    /// Axial coordinates of the ends of the layers, ascending, m.
    pub stations: Vec<f64>,
    /// Order of the axode of each displacement node of the section.
    pub orders: Vec<u8>,
    /// First node of the axode of each displacement node of the section, and the number of all
    /// nodes. The nodes of an axode are consecutive with increasing axial coordinate: `order` for
    /// each layer, and one.
    pub axode_starts: Vec<usize>,
}

/// Coordinates (s, z) on a set of swept faces. Face `layer * edges.len() + k` is that of edge `k`
/// in the layer.
#[derive(Clone, Debug, PartialEq)]
pub struct FaceChart {
    /// Measure of arc length.
    pub measure: ArcLength,
    /// Edges of the section, in order along the chain.
    pub edges: Vec<ElementEdge>,
}

impl FaceChart {
    /// Returns the arc lengths of the two ends; zeros for an empty chart.
    pub fn s_range(&self) -> [f64; 2] {
        match (self.edges.first(), self.edges.last()) {
            (Some(first), Some(last)) => [first.s[0], last.s[1]],
            _ => [0.0; 2],
        }
    }
}

impl Swept {
    /// Returns the displacement nodes of the axode of a node of the section, with increasing axial
    /// coordinate.
    pub fn axode(&self, section_node: usize) -> Vec<usize> {
        (self.axode_starts[section_node]..self.axode_starts[section_node + 1]).collect()
    }

    /// Returns radius (m) and angle (rad) in the section, and the number of layers from the first
    /// station, of all displacement nodes. Angles count from the middle of the section's nodes.
    pub(super) fn polar_coordinates(&self) -> Vec<[f64; 3]> {
        let layers = self.stations.len() - 1;
        let nodes = &self.section.nodes;
        let [mx, my] = nodes.iter().fold([0.0; 2], |sum, node| [0, 1].map(|axis| sum[axis] + node[axis]));
        let of_axode = |(&[x, y], &order): (&[f64; 2], &u8)| {
            let order = usize::from(order);
            let (radius, angle) = (x.hypot(y), (mx * y - my * x).atan2(mx * x + my * y));
            (0..=layers * order).map(move |node| [radius, angle, node as f64 / order as f64])
        };
        nodes.iter().zip(&self.orders).flat_map(of_axode).collect()
    }

    /// Returns the displacement nodes of a chart: for each node of the chain, in its order, those
    /// of its axode.
    pub fn axodes_on(&self, chart: &FaceChart) -> Vec<Vec<usize>> {
        let chain = EdgeChain { edges: chart.edges.clone(), measure: chart.measure };
        self.section.chain_nodes(&chain).into_iter().map(|node| self.axode(node)).collect()
    }

    /// Returns the axial coordinates of the two side faces, m.
    pub fn z_range(&self) -> [f64; 2] {
        [self.stations[0], self.stations[self.stations.len() - 1]]
    }

    /// Returns the layer and `zeta` at an axial coordinate; at an interface, the earlier layer.
    /// `None` outside by more than rounding.
    pub fn locate_z(&self, z: f64) -> Option<(usize, f64)> {
        let [start, end] = self.z_range();
        let slack = 1e-9 * (end - start);
        if z < start - slack {
            return None;
        }
        let layer = self.stations[1..].iter().position(|&station| z <= station + slack)?;
        Some((layer, self.zeta(layer, z)))
    }

    /// Returns `zeta` of an axial coordinate in a layer, clamped to its ends.
    pub(super) fn zeta(&self, layer: usize, z: f64) -> f64 {
        let [from, to] = [self.stations[layer], self.stations[layer + 1]];
        (2.0 * (z - from) / (to - from) - 1.0).clamp(-1.0, 1.0)
    }

    pub(super) fn z(&self, layer: usize, zeta: f64) -> f64 {
        within([self.stations[layer], self.stations[layer + 1]], zeta)
    }
}

/// Interpolates between two bounds at local coordinate `x` of -1 ..= 1, exact at both.
fn within([from, to]: [f64; 2], x: f64) -> f64 {
    0.5 * ((1.0 - x) * from + (1.0 + x) * to)
}
