//! Plane meshes of quadrilaterals, with separate displacement and coordinate nodes, and chains of
//! edges.

use super::interpolation::{ElementOrder, Shape, side_point};
use calyx_numerics::quadrature::gauss_legendre;
use std::collections::BTreeMap;

/// Plane mesh. Elements share the nodes of shared sides, both displacement and coordinate nodes.
///
/// Degrees of freedom are `2 * node` (x) and `2 * node + 1` (y) of the displacement nodes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PlaneMesh {
    /// Displacement nodes at the positions of the coordinate interpolation, m.
    pub nodes: Vec<[f64; 2]>,
    /// Coordinate nodes, m.
    pub coordinate_nodes: Vec<[f64; 2]>,
    /// Elements in no particular order.
    pub elements: Vec<Element>,
    /// Named sets of element edges: `"bore"`, `"cut_left"`, `"flank_0"`.
    pub chains: BTreeMap<String, EdgeChain>,
}

/// Quadrilateral element. If the coordinates are nowhere of higher order than the displacements,
/// the element represents rigid-body motions exactly; a curved element with linear displacements
/// does not (its rotation causes strain).
#[derive(Clone, Debug, PartialEq)]
pub struct Element {
    /// Order of the displacements.
    pub order: ElementOrder,
    /// Indices into [`PlaneMesh::nodes`], in the numbering of [`ElementOrder`].
    pub nodes: Vec<usize>,
    /// Order of the coordinates.
    pub coordinate_order: ElementOrder,
    /// Indices into [`PlaneMesh::coordinate_nodes`].
    pub coordinates: Vec<usize>,
}

/// Point in an element, by its local coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ElementPoint {
    /// Index in [`PlaneMesh::elements`].
    pub element: usize,
    /// Local coordinate, from -1 to 1.
    pub xi: f64,
    /// Local coordinate, from -1 to 1.
    pub eta: f64,
}

/// Side of an element as a part of a chain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ElementEdge {
    /// Index in [`PlaneMesh::elements`].
    pub element: usize,
    /// Side 0 to 3, see [`ElementOrder`].
    pub side: usize,
    /// True if the chain runs against the direction of the side, which is counter-clockwise around
    /// the element.
    pub reversed: bool,
    /// Arc lengths at the start and the end in the direction of the chain; ascending, m.
    pub s: [f64; 2],
}

/// Measure of arc length along a chain.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ArcLength {
    /// Arc length of the true profile: within an edge it is proportional to the local coordinate,
    /// by construction of the mesh.
    Profile,
    /// Arc length of the interpolated coordinates, from 0 at the start of the chain.
    Mesh,
}

/// Edges in order of arc length. Chains measured on the mesh run with the material on the left
/// (counter-clockwise around the body); those on a profile have the direction of the profile.
#[derive(Clone, Debug, PartialEq)]
pub struct EdgeChain {
    /// Edges in order along the chain.
    pub edges: Vec<ElementEdge>,
    /// Measure of arc length.
    pub measure: ArcLength,
}

/// Point of a chain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EdgePoint {
    /// Element and local coordinates.
    pub place: ElementPoint,
    /// Position, m.
    pub position: [f64; 2],
    /// Unit tangent, towards increasing arc length.
    pub tangent: [f64; 2],
    /// Unit normal, out of the element.
    pub normal: [f64; 2],
    /// Length of the interpolated curve per unit of the edge's coordinate `t`, m.
    pub speed: f64,
}

impl EdgeChain {
    /// Returns the arc lengths of the two ends; zeros for an empty chain.
    pub fn range(&self) -> [f64; 2] {
        match (self.edges.first(), self.edges.last()) {
            (Some(first), Some(last)) => [first.s[0], last.s[1]],
            _ => [0.0; 2],
        }
    }
}

impl PlaneMesh {
    /// Returns the number of displacement unknowns, two for each node.
    pub fn dof_count(&self) -> usize {
        2 * self.nodes.len()
    }

    /// Returns the chain of that name, if any.
    pub fn chain(&self, name: &str) -> Option<&EdgeChain> {
        self.chains.get(name)
    }

    /// Returns the displacement nodes along a chain in its order, with the node at each joint once.
    pub fn chain_nodes(&self, chain: &EdgeChain) -> Vec<usize> {
        let mut nodes = Vec::new();
        for edge in &chain.edges {
            let element = &self.elements[edge.element];
            let mut on_edge = element.order.side_nodes(edge.side);
            if edge.reversed {
                on_edge.reverse();
            }
            for node in on_edge.into_iter().map(|local| element.nodes[local]) {
                if nodes.last() != Some(&node) {
                    nodes.push(node);
                }
            }
        }
        // A closed chain ends at its first node.
        if nodes.len() > 1 && nodes.first() == nodes.last() {
            nodes.pop();
        }
        nodes
    }

    /// Returns the area and its polar second moment about the origin, m² and m⁴.
    pub fn area_and_polar_moment(&self) -> [f64; 2] {
        let mut sums = [0.0; 2];
        let mut tables = BTreeMap::new();
        for element in &self.elements {
            let points = tables.entry(element.coordinate_order).or_insert_with_key(integration_points);
            for (weight, shapes) in points {
                let ([x, y], [[a, b], [c, d]]) = self.map_with(element, shapes);
                let area = *weight * (a * d - b * c);
                sums[0] += area;
                sums[1] += area * (x * x + y * y);
            }
        }
        sums
    }

    /// Returns the position of a point, m.
    pub fn position(&self, place: ElementPoint) -> [f64; 2] {
        self.map(place).0
    }

    /// Returns the Jacobian `[[dx/dxi, dx/deta], [dy/dxi, dy/deta]]` at a point, m.
    pub fn jacobian(&self, place: ElementPoint) -> [[f64; 2]; 2] {
        self.map(place).1
    }

    fn map(&self, place: ElementPoint) -> ([f64; 2], [[f64; 2]; 2]) {
        let element = &self.elements[place.element];
        self.map_with(element, &element.coordinate_order.shapes(place.xi, place.eta))
    }

    /// Returns position and Jacobian from evaluated coordinate shape functions.
    pub(super) fn map_with(&self, element: &Element, shapes: &[Shape]) -> ([f64; 2], [[f64; 2]; 2]) {
        let (mut position, mut jacobian) = ([0.0; 2], [[0.0; 2]; 2]);
        for (shape, &node) in shapes.iter().zip(&element.coordinates) {
            let point = self.coordinate_nodes[node];
            for axis in 0..2 {
                position[axis] += shape[0] * point[axis];
                jacobian[axis][0] += shape[1] * point[axis];
                jacobian[axis][1] += shape[2] * point[axis];
            }
        }
        (position, jacobian)
    }

    /// Returns the point of an edge at `t` in -1 ..= 1, in the direction of the chain.
    pub fn edge_point(&self, edge: &ElementEdge, t: f64) -> EdgePoint {
        let direction = if edge.reversed { -1.0 } else { 1.0 };
        let [xi, eta] = side_point(edge.side, direction * t);
        let place = ElementPoint { element: edge.element, xi, eta };
        let (position, jacobian) = self.map(place);
        // d(xi, eta)/dt along the counter-clockwise direction of the side.
        let [a, b] = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]][edge.side];
        let along = [jacobian[0][0] * a + jacobian[0][1] * b, jacobian[1][0] * a + jacobian[1][1] * b];
        let speed = along[0].hypot(along[1]);
        let tangent = [along[0] / speed, along[1] / speed];
        EdgePoint {
            place,
            position,
            tangent: tangent.map(|part| direction * part),
            // The material is on the left of the side's direction.
            normal: [tangent[1], -tangent[0]],
            speed,
        }
    }

    /// Returns the arc length at `t` on an edge.
    pub fn arc_length(&self, measure: ArcLength, edge: &ElementEdge, t: f64) -> f64 {
        let fraction = 0.5 * (1.0 + t);
        match measure {
            ArcLength::Profile => edge.s[0] + fraction * (edge.s[1] - edge.s[0]),
            ArcLength::Mesh => edge.s[0] + self.length_to(edge, t),
        }
    }

    /// Returns the length of the interpolated edge from its start to `t`, m.
    pub(super) fn length_to(&self, edge: &ElementEdge, t: f64) -> f64 {
        let half = 0.5 * (1.0 + t);
        gauss_legendre(8)
            .iter()
            .map(|&(x, weight)| weight * half * self.edge_point(edge, -1.0 + half * (1.0 + x)).speed)
            .sum()
    }

    /// Locates arc length `s` on a chain: the index of the edge and `t`. At a joint, the earlier
    /// edge. `None` outside the chain by more than rounding, or in a gap.
    pub fn locate(&self, chain: &EdgeChain, s: f64) -> Option<(usize, f64)> {
        let [start, end] = chain.range();
        let slack = 1e-9 * (end - start);
        let index = chain.edges.iter().position(|edge| s <= edge.s[1] + slack)?;
        let edge = &chain.edges[index];
        if s < edge.s[0] - slack {
            return None;
        }
        Some((index, self.edge_parameter(chain.measure, edge, s)))
    }

    /// Returns the coordinate `t` in -1 ..= 1 at which an edge has arc length `s`, clamped to its
    /// ends.
    pub fn edge_parameter(&self, measure: ArcLength, edge: &ElementEdge, s: f64) -> f64 {
        let mut t = (2.0 * (s - edge.s[0]) / (edge.s[1] - edge.s[0]) - 1.0).clamp(-1.0, 1.0);
        if measure == ArcLength::Mesh {
            // Newton's method: the speed varies little along a valid edge.
            for _ in 0..20 {
                let step = (s - self.arc_length(measure, edge, t)) / self.edge_point(edge, t).speed;
                t = (t + step).clamp(-1.0, 1.0);
                if step.abs() < 1e-14 {
                    break;
                }
            }
        }
        t
    }

    /// Returns the point of a chain at arc length `s`; `None` as in [`PlaneMesh::locate`].
    pub fn chain_point(&self, chain: &EdgeChain, s: f64) -> Option<EdgePoint> {
        let (index, t) = self.locate(chain, s)?;
        Some(self.edge_point(&chain.edges[index], t))
    }
}

/// Returns weights and shape functions at the points of the rule that integrates the area and its
/// second moment of an element exactly: the integrand has degree 4q - 1 in each direction, q the
/// order of the coordinates.
fn integration_points(order: &ElementOrder) -> Vec<(f64, Vec<Shape>)> {
    let rule = gauss_legendre(2 * usize::from(order.highest()));
    let mut points = Vec::with_capacity(rule.len() * rule.len());
    for (eta, of_eta) in &rule {
        for (xi, of_xi) in &rule {
            points.push((of_xi * of_eta, order.shapes(*xi, *eta)));
        }
    }
    points
}
