//! Solid meshes that are swept from a plane section along an axis.
//!
//! Each quadrilateral of the section becomes one element per layer. Each of its nodes becomes an
//! axode: a line of nodes along the axis. Each chain of edges becomes a set of faces, a chart with
//! the coordinates `s` (arc length of the chain, m) and `z` (axial coordinate, m).
//!
//! See `docs/theory/finite-elements.md`.

use super::interpolation::Interpolation;
use super::line_interpolation::{equispaced, lobatto};
use super::mesh::{ElementFace, FacePoint, FaceSet, SolidElement, SolidElementPoint, SolidMesh};
use super::swept::{FaceChart, Swept};
use crate::interpolation::side_point;
use crate::mesh::{ArcLength, EdgeChain, ElementEdge, PlaneMesh};
use calyx_numerics::interpolation::lagrange_with_slopes;
use std::collections::{BTreeMap, BTreeSet};

/// Name of the set of faces at the first station.
pub const FACE_START: &str = "face_start";
/// Name of the set of faces at the last station.
pub const FACE_END: &str = "face_end";

/// Errors of a sweep.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[allow(missing_docs, reason = "the messages describe the variants")]
pub enum SweepError {
    #[error("the stations must be at least two axial coordinates in ascending order")]
    Stations,
    #[error(
        "every axode must have an order of at least 1, and every node of the section must have one order"
    )]
    Orders,
    #[error("a loft needs the positions of all nodes of the section at each of its coordinate stations")]
    Sections,
    #[error("element {element} is folded or inverted at ({}, {}, {}) m", at[0], at[1], at[2])]
    Folded { element: usize, at: [f64; 3] },
}

/// Returns the axial coordinates of the coordinate nodes of a swept mesh: the Gauss-Lobatto points
/// of each layer, ascending, with those that layers share once.
pub fn coordinate_stations(stations: &[f64], order: u8) -> Vec<f64> {
    let line = lobatto(order);
    let mut all = Vec::new();
    for (layer, pair) in stations.windows(2).enumerate() {
        let at = |&zeta: &f64| 0.5 * ((1.0 - zeta) * pair[0] + (1.0 + zeta) * pair[1]);
        all.extend(line[usize::from(layer > 0)..].iter().map(at));
    }
    all
}

impl SolidMesh {
    /// Sweeps a plane section between the stations (axial ends of the elements), with axodes of one
    /// order.
    ///
    /// `place` maps a point of the section and an axial coordinate to three dimensions, for example
    /// onto a helix. It must preserve the orientation. The coordinates are interpolated with the
    /// orders of the section and with `axial_order`, so that rigid-body motions are as exact as in
    /// the section. Each chain of the section becomes a set of faces of the same name. The ends of
    /// the mesh are the sets [`FACE_START`] and [`FACE_END`].
    ///
    /// # Errors
    /// The stations do not ascend, the order is zero or above 255, or an element is folded.
    pub fn swept(
        section: &PlaneMesh,
        stations: &[f64],
        axial_order: usize,
        place: &dyn Fn([f64; 2], f64) -> [f64; 3],
    ) -> Result<Self, SweepError> {
        let order = u8::try_from(axial_order).map_err(|_| SweepError::Orders)?;
        Self::swept_with(section, stations, &vec![order; section.nodes.len()], order, place)
    }

    /// Sweeps as [`SolidMesh::swept`] does, with one order per axode (`orders`, by displacement
    /// node of the section) and an axial order of the coordinates (`coordinate_order`). Rigid-body
    /// motions are exact if `coordinate_order` does not exceed any of `orders`, or if the mesh is
    /// straight along the axis.
    ///
    /// # Errors
    /// As for [`SolidMesh::swept`].
    pub fn swept_with(
        section: &PlaneMesh,
        stations: &[f64],
        orders: &[u8],
        coordinate_order: u8,
        place: &dyn Fn([f64; 2], f64) -> [f64; 3],
    ) -> Result<Self, SweepError> {
        let positions = |at: &[f64]| {
            let of_node = |&point: &[f64; 2]| at.iter().map(move |&z| place(point, z));
            section.coordinate_nodes.iter().flat_map(of_node).collect()
        };
        Self::swept_through(section, stations, orders, coordinate_order, &positions)
    }

    /// Builds a mesh through sections of different shape: a loft. `section` is one of them and
    /// determines the elements, the chains and their arc lengths. `sections` contains the positions
    /// of all its coordinate nodes at each of [`coordinate_stations`]. The axodes have one order.
    ///
    /// # Errors
    /// As for [`SolidMesh::swept`]; the number of sections or of their positions is wrong.
    pub fn lofted(
        section: &PlaneMesh,
        stations: &[f64],
        axial_order: usize,
        sections: &[Vec<[f64; 3]>],
    ) -> Result<Self, SweepError> {
        let order = u8::try_from(axial_order).map_err(|_| SweepError::Orders)?;
        let count = section.coordinate_nodes.len();
        let sound = sections.iter().all(|positions| positions.len() == count);
        let positions = |at: &[f64]| -> Vec<[f64; 3]> {
            if !sound || at.len() != sections.len() {
                return Vec::new();
            }
            (0..count).flat_map(|node| sections.iter().map(move |positions| positions[node])).collect()
        };
        Self::swept_through(section, stations, &vec![order; section.nodes.len()], order, &positions)
    }

    /// Builds the mesh from the positions of all coordinate nodes: for each node of the section,
    /// those at given axial coordinates.
    fn swept_through(
        section: &PlaneMesh,
        stations: &[f64],
        orders: &[u8],
        coordinate_order: u8,
        positions: &dyn Fn(&[f64]) -> Vec<[f64; 3]>,
    ) -> Result<Self, SweepError> {
        // The comparison is negated so that NaN fails it.
        let ascending = stations.len() > 1 && stations.windows(2).all(|pair| pair[0] < pair[1]);
        if !ascending {
            return Err(SweepError::Stations);
        }
        if coordinate_order == 0 || orders.contains(&0) || orders.len() != section.nodes.len() {
            return Err(SweepError::Orders);
        }
        let layers = stations.len() - 1;
        let mut axode_starts = vec![0];
        for &order in orders {
            axode_starts.push(axode_starts[axode_starts.len() - 1] + layers * usize::from(order) + 1);
        }
        let node_count = axode_starts[orders.len()];
        let swept = Swept {
            section: section.clone(),
            stations: stations.to_vec(),
            orders: orders.to_vec(),
            axode_starts,
        };

        let along = usize::from(coordinate_order);
        let coordinate_nodes = positions(&coordinate_stations(stations, coordinate_order));
        if coordinate_nodes.len() != section.coordinate_nodes.len() * (layers * along + 1) {
            return Err(SweepError::Sections);
        }

        let mut elements = Vec::with_capacity(layers * section.elements.len());
        for layer in 0..layers {
            for flat in &section.elements {
                let axial = flat.nodes.iter().map(|&node| orders[node]).collect::<Vec<_>>();
                let nodes = flat.nodes.iter().flat_map(|&node| {
                    let order = usize::from(orders[node]);
                    let start = swept.axode_starts[node] + layer * order;
                    start..=start + order
                });
                let coordinates = flat.coordinates.iter().flat_map(|&node| {
                    let start = node * (layers * along + 1) + layer * along;
                    start..=start + along
                });
                elements.push(SolidElement {
                    nodes: nodes.collect(),
                    coordinates: coordinates.collect(),
                    interpolation: Interpolation::Axodes { section: flat.order, axial: axial.into() },
                    coordinate_interpolation: Interpolation::axodes(flat.coordinate_order, coordinate_order),
                });
            }
        }

        let count = section.elements.len();
        let face = |layer: usize, element: usize, face: usize| ElementFace {
            element: layer * count + element,
            face,
        };
        let mut faces = BTreeMap::new();
        for (name, chain) in &section.chains {
            let of_layer = |layer| chain.edges.iter().map(move |edge| face(layer, edge.element, edge.side));
            let chart = FaceChart { measure: chain.measure, edges: chain.edges.clone() };
            faces.insert(
                name.clone(),
                FaceSet { faces: (0..layers).flat_map(of_layer).collect(), chart: Some(chart) },
            );
        }
        for (name, layer, side) in [(FACE_START, 0, 4), (FACE_END, layers - 1, 5)] {
            let faces_there = (0..count).map(|element| face(layer, element, side)).collect();
            faces.insert(name.to_owned(), FaceSet { faces: faces_there, chart: None });
        }

        let mut mesh = Self {
            nodes: vec![[0.0; 3]; node_count],
            coordinate_nodes,
            elements,
            faces,
            node_sets: BTreeMap::new(),
            swept: Some(swept),
            absent: BTreeSet::new(),
        };
        mesh.place_nodes();
        match mesh.folded() {
            Some((element, at)) => Err(SweepError::Folded { element, at }),
            None => Ok(mesh),
        }
    }

    /// Places the displacement nodes on the interpolated coordinates of their elements.
    pub(super) fn place_nodes(&mut self) {
        let mut tables = BTreeMap::new();
        let mut positions = vec![None; self.nodes.len()];
        for element in &self.elements {
            let kinds = element.kinds();
            let table = tables.entry(kinds).or_insert_with(|| {
                let values =
                    |place| kinds.1.shapes(place).into_iter().map(|shape| shape[0]).collect::<Vec<_>>();
                kinds.0.node_coordinates().into_iter().map(values).collect::<Vec<_>>()
            });
            for (&node, shapes) in element.nodes.iter().zip(&*table) {
                positions[node].get_or_insert_with(|| {
                    let mut position = [0.0; 3];
                    for (shape, &from) in shapes.iter().zip(&element.coordinates) {
                        for axis in 0..3 {
                            position[axis] += shape * self.coordinate_nodes[from][axis];
                        }
                    }
                    position
                });
            }
        }
        for (node, position) in self.nodes.iter_mut().zip(positions) {
            *node = position.unwrap_or(*node);
        }
    }

    /// Returns the point of a set of faces at arc length `s` and axial coordinate `z`, with its
    /// area per unit of both. `None` outside the chart, or if the set has no chart.
    pub fn surface_point(&self, set: &FaceSet, s: f64, z: f64) -> Option<FacePoint> {
        let (chart, swept) = (set.chart.as_ref()?, self.swept.as_ref()?);
        let chain = EdgeChain { edges: chart.edges.clone(), measure: chart.measure };
        let (edge, t) = swept.section.locate(&chain, s)?;
        let (layer, zeta) = swept.locate_z(z)?;
        Some(self.face(chart, swept, edge, layer).point(t, zeta))
    }

    /// Returns the face of a chart at an edge of its chain and a layer.
    pub(super) fn face<'a>(
        &'a self,
        chart: &'a FaceChart,
        swept: &'a Swept,
        edge: usize,
        layer: usize,
    ) -> SweptFace<'a> {
        let of_section = &chart.edges[edge];
        let element = layer * swept.section.elements.len() + of_section.element;
        let flat = &swept.section.elements[of_section.element];
        let side = flat.coordinate_order.side_nodes(of_section.side);
        let along = match &self.elements[element].coordinate_interpolation {
            Interpolation::Axodes { axial, .. } => axial.first().copied().unwrap_or(1),
            _ => 1,
        };
        SweptFace {
            mesh: self,
            swept,
            measure: chart.measure,
            edge: of_section,
            element,
            layer,
            lines: [equispaced((side.len() - 1) as u8), lobatto(along)],
            side,
        }
    }
}

/// Face of one element, with the coordinates `t` (along the chain) and `zeta` (along the axis),
/// both from -1 to 1.
pub(super) struct SweptFace<'a> {
    mesh: &'a SolidMesh,
    swept: &'a Swept,
    measure: ArcLength,
    pub edge: &'a ElementEdge,
    pub element: usize,
    layer: usize,
    /// Interpolation points of the coordinates along the side and along `zeta`.
    lines: [Vec<f64>; 2],
    /// Coordinate nodes of the section's side.
    side: Vec<usize>,
}

impl SweptFace<'_> {
    /// Returns the coordinate `t` at an arc length, clamped to the ends.
    pub fn parameter(&self, s: f64) -> f64 {
        self.swept.section.edge_parameter(self.measure, self.edge, s)
    }

    /// Returns the arc length per unit of `t`.
    fn arc_per_t(&self, t: f64) -> f64 {
        match self.measure {
            ArcLength::Profile => 0.5 * (self.edge.s[1] - self.edge.s[0]),
            ArcLength::Mesh => self.swept.section.edge_point(self.edge, t).speed,
        }
    }

    /// Returns the axial coordinate per unit of `zeta`.
    pub fn z_per_zeta(&self) -> f64 {
        0.5 * (self.swept.stations[self.layer + 1] - self.swept.stations[self.layer])
    }

    /// Returns the coordinate of the side, counter-clockwise around the section's element.
    pub fn side_coordinate(&self, t: f64) -> f64 {
        if self.edge.reversed { -t } else { t }
    }

    /// Returns the point at `t` and `zeta`.
    pub fn point(&self, t: f64, zeta: f64) -> FacePoint {
        self.point_of(&self.at_chain(t), &self.at_axis(zeta))
    }

    /// Evaluates everything that depends on `t` only, for use in all layers.
    pub fn at_chain(&self, t: f64) -> AtChain {
        let own = self.side_coordinate(t);
        AtChain {
            s: self.swept.section.arc_length(self.measure, self.edge, t),
            arc_per_t: self.arc_per_t(t),
            speed: self.swept.section.edge_point(self.edge, t).speed,
            local: side_point(self.edge.side, own),
            shapes: lagrange_with_slopes(&self.lines[0], own),
        }
    }

    /// Evaluates everything that depends on `zeta` only, for use at all edges.
    pub fn at_axis(&self, zeta: f64) -> AtAxis {
        AtAxis { zeta, z: self.swept.z(self.layer, zeta), shapes: lagrange_with_slopes(&self.lines[1], zeta) }
    }

    /// Returns the point at evaluated coordinates.
    pub fn point_of(&self, across: &AtChain, along: &AtAxis) -> FacePoint {
        let coordinates = &self.mesh.elements[self.element].coordinates;
        let (mut position, mut by_t, mut by_zeta) = ([0.0; 3], [0.0; 3], [0.0; 3]);
        for (&axode, (f, df)) in self.side.iter().zip(&across.shapes) {
            for (node, (g, dg)) in along.shapes.iter().enumerate() {
                let at = self.mesh.coordinate_nodes[coordinates[axode * along.shapes.len() + node]];
                for axis in 0..3 {
                    position[axis] += f * g * at[axis];
                    by_t[axis] += df * g * at[axis];
                    by_zeta[axis] += f * dg * at[axis];
                }
            }
        }
        let [xi, eta] = across.local;
        let place = SolidElementPoint { element: self.element, local: [xi, eta, along.zeta] };
        let mut point = FacePoint::new(place, position, [by_t, by_zeta]);
        // The chart's `s` may be the arc length of the exact profile instead of the mesh. The area
        // per unit of `s` is then that per unit of length on the mesh.
        point.area /= across.speed * self.z_per_zeta();
        if self.edge.reversed {
            // The first tangent has the direction of the chain, the second one that of increasing
            // z.
            point.tangents[0] = point.tangents[0].map(|part| -part);
        }
        point
    }
}

/// Values at a coordinate `t`, see [`SweptFace::at_chain`].
pub(super) struct AtChain {
    /// Arc length, m.
    pub s: f64,
    /// Arc length per unit of `t`, m.
    pub arc_per_t: f64,
    /// Length on the mesh per unit of `t`, m.
    speed: f64,
    /// Local coordinates in the section.
    local: [f64; 2],
    /// Coordinate shape functions along the side.
    shapes: Vec<(f64, f64)>,
}

/// Values at a coordinate `zeta`, see [`SweptFace::at_axis`].
pub(super) struct AtAxis {
    zeta: f64,
    /// Axial coordinate, m.
    pub z: f64,
    /// Coordinate shape functions along the axis.
    shapes: Vec<(f64, f64)>,
}
