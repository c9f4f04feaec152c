//! Extrusion of the plane mesh of a carrier along its axis.

use super::plane_mesh::{PlaneCell, PlaneMesh, PlaneNode};
use super::shape::Layer;
use std::collections::BTreeMap;

/// Nodes of a plane mesh at the levels of a carrier; odd levels are in the middle of layers.
pub(super) struct Extrusion<'p> {
    plane: &'p PlaneMesh,
    layers: Vec<Layer>,
    known: BTreeMap<(usize, usize), usize>,
    positions: Vec<[f64; 3]>,
}

impl<'p> Extrusion<'p> {
    /// Creates an extrusion without nodes; each layer begins where the one before ends.
    pub(super) fn new(plane: &'p PlaneMesh, layers: Vec<Layer>) -> Extrusion<'p> {
        Extrusion { plane, layers, known: BTreeMap::new(), positions: Vec::new() }
    }

    fn node(&mut self, index: usize, layer: usize, half: usize) -> usize {
        let key = (index, 2 * layer + half);
        if let Some(&known) = self.known.get(&key) {
            return known;
        }
        let ([x, y], [low, high]) = (self.plane.nodes[index], self.layers[layer].ends);
        let z = [low, 0.5 * (low + high), high][half];
        self.positions.push([x, y, z]);
        self.known.insert(key, self.positions.len() - 1);
        self.positions.len() - 1
    }

    /// Returns the nodes of the hexahedron of a cell in a layer.
    pub(super) fn hexahedron(&mut self, cell: &PlaneCell, layer: usize) -> Vec<usize> {
        let faces = [
            (&cell.corners, 0),
            (&cell.corners, 2),
            (&cell.midsides, 0),
            (&cell.corners, 1),
            (&cell.midsides, 2),
        ];
        let mut nodes = Vec::with_capacity(20);
        for (plane, half) in faces {
            nodes.extend(plane.iter().map(|&index| self.node(index, layer, half)));
        }
        nodes
    }

    /// Returns the positions of all nodes, m.
    pub(super) fn positions(&self) -> Vec<[f64; 3]> {
        self.positions.clone()
    }

    /// Returns the nodes of a curve through the thickness of a plate, ascending.
    pub(super) fn nodes_of(&self, curve: &[PlaneNode], plate: usize) -> Vec<usize> {
        let mut nodes = Vec::new();
        let own = self.layers.iter().enumerate().filter(|(_, layer)| layer.plate == Some(plate));
        for (layer, _) in own {
            for half in 0..3 {
                let at = curve.iter().filter(|node| half != 1 || node.corner);
                nodes.extend(at.filter_map(|node| self.known.get(&(node.index, 2 * layer + half)).copied()));
            }
        }
        nodes.sort_unstable();
        nodes.dedup();
        nodes
    }
}
