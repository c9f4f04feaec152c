//! Extent of the attachments of an elastic body: where bearings on them can be.

use calyx_elastic::attachment::Region;
use calyx_elastic::{Constraint, ElasticModel, ElementKind};
use calyx_numerics::vec3::{Vector, dot, length, minus, unit};
use std::f64::consts::PI;

/// Region of a body that an attachment connects, in the coordinates of the body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AttachmentExtent {
    /// Smallest coordinates of its nodes, m.
    pub lowest: Vector,
    /// Largest coordinates of its nodes, m.
    pub highest: Vector,
    /// Size of the region, m: its largest side. That of a single node is the size of the elements
    /// at the node.
    pub size: f64,
    /// Axis and radius (m) of a cylinder.
    pub cylinder: Option<(CylinderAxis, f64)>,
}

/// Axis of a cylinder.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CylinderAxis {
    /// Point on the axis, m.
    pub point: Vector,
    /// Unit vector along the axis.
    pub direction: Vector,
}

impl AttachmentExtent {
    /// Creates the extent of a point with the size of what surrounds it, m.
    pub fn of_point(position: Vector, size: f64) -> AttachmentExtent {
        AttachmentExtent { lowest: position, highest: position, size, cylinder: None }
    }

    /// Returns the extent of a region that consists of these nodes.
    pub(super) fn of_nodes(model: &ElasticModel, region: &Region, nodes: &[usize]) -> AttachmentExtent {
        if let [node] = *nodes {
            return of_node(model, node);
        }
        let cylinder = match *region {
            Region::Cylinder { origin, axis, radius, .. } => {
                Some((CylinderAxis { point: origin, direction: unit(axis) }, radius))
            }
            _ => None,
        };
        AttachmentExtent { cylinder, ..of_positions(nodes.iter().map(|&node| model.nodes[node].position)) }
    }

    /// Returns the distance of a point from the region, m; 0 within its bounding box.
    pub fn distance(&self, point: Vector) -> f64 {
        let outside = |k: usize| (self.lowest[k] - point[k]).max(point[k] - self.highest[k]).max(0.0);
        length([0, 1, 2].map(outside))
    }
}

impl CylinderAxis {
    /// Returns the distance of a point from the axis, m.
    pub fn distance(&self, point: Vector) -> f64 {
        let from = minus(point, self.point);
        let along = dot(from, self.direction);
        length([0, 1, 2].map(|k: usize| from[k] - along * self.direction[k]))
    }
}

fn of_positions(positions: impl Iterator<Item = Vector>) -> AttachmentExtent {
    let (mut lowest, mut highest) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    for position in positions {
        for k in 0..3 {
            lowest[k] = lowest[k].min(position[k]);
            highest[k] = highest[k].max(position[k]);
        }
    }
    let size = (0..3).map(|k| highest[k] - lowest[k]).fold(0.0, f64::max);
    AttachmentExtent { lowest, highest, size, cylinder: None }
}

/// Returns the extent of a single node: the nodes of the constraints of which it is the reference,
/// or the node with the size of the elements at it. The size of a beam is its diameter, not its
/// length.
fn of_node(model: &ElasticModel, node: usize) -> AttachmentExtent {
    let position = model.nodes[node].position;
    let at = |other: usize| model.nodes[other].position;
    let connected = model.constraints.iter().filter_map(|constraint| match constraint {
        Constraint::Rigid { reference, dependents, .. } if *reference == node => {
            Some(dependents.iter().map(|(other, _)| at(*other)).collect::<Vec<_>>())
        }
        Constraint::WeightedAverage { reference, terms, .. } if *reference == node => {
            Some(terms.iter().map(|(_, other, _)| at(*other)).collect())
        }
        _ => None,
    });
    let connected: Vec<Vector> = connected.flatten().collect();
    if !connected.is_empty() {
        return of_positions(connected.into_iter().chain([position]));
    }
    let around = model.elements.iter().filter(|element| element.nodes.contains(&node));
    let sizes = around.map(|element| match &element.kind {
        ElementKind::Beam(beam) => 2.0 * (beam.sections[0].area / PI).sqrt(),
        _ => of_positions(element.nodes.iter().map(|&other| at(other))).size,
    });
    AttachmentExtent::of_point(position, sizes.fold(0.0, f64::max))
}
