//! Builds a plane mesh from blocks: merges their common corners, assigns shared nodes to shared
//! sides, orders named chains, and rejects invalid meshes.

use super::block::{Block, NamedSide};
use super::interpolation::{ElementOrder, Shape, side_point};
use super::mesh::{ArcLength, EdgeChain, Element, ElementEdge, PlaneMesh};
use calyx_numerics::quadrature::gauss_legendre;
use calyx_numerics::vec2::distance;
use std::collections::{BTreeMap, BTreeSet, HashMap};

/// Tolerance for coincident points, relative to the diagonal of the mesh's bounding box.
const COINCIDENT: f64 = 1e-7;

/// Reasons why blocks do not form a mesh. Blocks are numbered from 0 in the order of addition;
/// positions in m.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[allow(missing_docs, reason = "each says itself in its message")]
pub enum MeshError {
    #[error("there are no blocks")]
    Empty,
    #[error("block {block}: divisions must ascend from 0 to 1")]
    Divisions { block: usize },
    #[error("block {block}: interpolation orders must be 1, 2 or 3")]
    Order { block: usize },
    #[error("block {block}: its sides do not meet at ({}, {})", at[0], at[1])]
    OpenCorner { block: usize, at: [f64; 2] },
    #[error("block {block}: an element has coinciding corners at ({}, {})", at[0], at[1])]
    Degenerate { block: usize, at: [f64; 2] },
    #[error("blocks {} and {} share an edge but not its curve, near ({}, {})", blocks[0], blocks[1], at[0], at[1])]
    Mismatch { blocks: [usize; 2], at: [f64; 2] },
    #[error("block {block}: elements overlap along an edge, or one is turned over, near ({}, {})", at[0], at[1])]
    Overlap { block: usize, at: [f64; 2] },
    #[error("block {block}: a corner of another element lies on an edge at ({}, {}); the divisions must agree", at[0], at[1])]
    Hanging { block: usize, at: [f64; 2] },
    #[error("block {block}: an element is folded or turned over at ({}, {})", at[0], at[1])]
    Folded { block: usize, at: [f64; 2] },
    #[error("block {block}: its part of the profile of `{name}` has no length")]
    EmptyProfile { block: usize, name: String },
    #[error("the edges of `{name}` lie partly on a profile and partly not")]
    MixedChain { name: String },
}

/// Builder of a mesh from blocks; [`MeshBuilder::finish`] builds the mesh.
#[derive(Clone, Default)]
pub struct MeshBuilder {
    blocks: Vec<Block>,
    coordinate_order: Option<ElementOrder>,
}

/// Element before its nodes are numbered.
struct Cell {
    block: usize,
    u: [f64; 2],
    v: [f64; 2],
    corners: [usize; 4],
    order: ElementOrder,
}

impl Cell {
    /// Returns the block's point at local coordinates of the element.
    fn at(&self, blocks: &[Block], [xi, eta]: [f64; 2]) -> [f64; 2] {
        blocks[self.block].at(within(self.u, xi), within(self.v, eta))
    }

    fn side_corners(&self, side: usize) -> (usize, usize) {
        (self.corners[side], self.corners[(side + 1) % 4])
    }
}

/// Interpolates between two bounds at local coordinate `x` of -1 ..= 1, exact at both.
fn within([from, to]: [f64; 2], x: f64) -> f64 {
    0.5 * ((1.0 - x) * from + (1.0 + x) * to)
}

/// Sides of the mesh: the cells that share each, with their side numbers.
type Sides = BTreeMap<(usize, usize), Vec<(usize, usize)>>;

impl MeshBuilder {
    /// Creates a builder without blocks.
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds a block.
    pub fn block(&mut self, block: Block) -> &mut Self {
        self.blocks.push(block);
        self
    }

    /// Sets one order of coordinate interpolation for all elements. By default, coordinates are
    /// interpolated like the displacements, which represents the rigid-body motions of curved
    /// elements exactly.
    pub fn coordinate_order(&mut self, order: ElementOrder) -> &mut Self {
        self.coordinate_order = Some(order);
        self
    }

    /// Builds the mesh, with displacements of the given order in all blocks without an order of
    /// their own.
    ///
    /// # Errors
    /// A [`MeshError`] if blocks are folded, not closed or do not conform.
    pub fn finish(&self, order: ElementOrder) -> Result<PlaneMesh, MeshError> {
        let tolerance = COINCIDENT * self.check_blocks(order)?;
        let (mut cells, corner_count) = self.cells(order, tolerance)?;
        let sides = self.sides(&cells, tolerance)?;
        raise_shared_sides(&mut cells, &sides);

        let orders = cells.iter().map(|cell| cell.order).collect::<Vec<_>>();
        let coordinate_orders = match self.coordinate_order {
            Some(order) => vec![order; cells.len()],
            None => orders.clone(),
        };
        let (coordinate_nodes, coordinates) =
            self.number_nodes(&cells, &sides, corner_count, &coordinate_orders);
        let (_, numbers) = self.number_nodes(&cells, &sides, corner_count, &orders);

        let mut mesh = PlaneMesh { coordinate_nodes, ..PlaneMesh::default() };
        for (((order, nodes), coordinate_order), coordinates) in
            orders.into_iter().zip(numbers).zip(coordinate_orders).zip(coordinates)
        {
            mesh.elements.push(Element { order, nodes, coordinate_order, coordinates });
        }
        place_displacement_nodes(&mut mesh);
        check_jacobians(&mesh, &cells)?;
        self.check_hanging(&mesh, &cells, &sides)?;
        self.name_chains(&mut mesh, &cells)?;
        Ok(mesh)
    }

    /// Checks each block separately; returns the diagonal of the bounding box of all corners.
    fn check_blocks(&self, order: ElementOrder) -> Result<f64, MeshError> {
        if self.blocks.is_empty() {
            return Err(MeshError::Empty);
        }
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for (index, block) in self.blocks.iter().enumerate() {
            let sound = |at: &[f64]| {
                at.first() == Some(&0.0)
                    && at.last() == Some(&1.0)
                    && at.windows(2).all(|pair| pair[0] < pair[1])
            };
            if !sound(&block.u) || !sound(&block.v) {
                return Err(MeshError::Divisions { block: index });
            }
            let coordinate_order = self.coordinate_order.unwrap_or(order);
            if !block.order.unwrap_or(order).is_valid() || !coordinate_order.is_valid() {
                return Err(MeshError::Order { block: index });
            }
            for corner in [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]] {
                let point = block.at(corner[0], corner[1]);
                for axis in 0..2 {
                    low[axis] = low[axis].min(point[axis]);
                    high[axis] = high[axis].max(point[axis]);
                }
            }
        }
        let diagonal = distance(low, high);
        for (index, block) in self.blocks.iter().enumerate() {
            let [bottom, right, top, left] = &block.sides;
            for (one, other) in [
                (bottom.at(0.0), left.at(0.0)),
                (bottom.at(1.0), right.at(0.0)),
                (top.at(1.0), right.at(1.0)),
                (top.at(0.0), left.at(1.0)),
            ] {
                // The comparison is negated so that curves with NaN fail it.
                let meets = distance(one, other) <= COINCIDENT * diagonal;
                if !meets {
                    return Err(MeshError::OpenCorner { block: index, at: one });
                }
            }
        }
        Ok(diagonal)
    }

    /// Returns the cells of all blocks with merged corners, and the number of corners.
    fn cells(&self, order: ElementOrder, tolerance: f64) -> Result<(Vec<Cell>, usize), MeshError> {
        let mut corners = PointMerger::new(tolerance);
        let mut cells = Vec::new();
        for (block_index, block) in self.blocks.iter().enumerate() {
            let grid = block
                .v
                .iter()
                .map(|&v| block.u.iter().map(|&u| corners.number(block.at(u, v))).collect::<Vec<_>>())
                .collect::<Vec<_>>();
            for (j, v) in block.v.windows(2).enumerate() {
                for (i, u) in block.u.windows(2).enumerate() {
                    let cell = Cell {
                        block: block_index,
                        u: [u[0], u[1]],
                        v: [v[0], v[1]],
                        corners: [grid[j][i], grid[j][i + 1], grid[j + 1][i + 1], grid[j + 1][i]],
                        order: block.order.unwrap_or(order),
                    };
                    let mut distinct = cell.corners;
                    distinct.sort_unstable();
                    if distinct.windows(2).any(|pair| pair[0] == pair[1]) {
                        let at = cell.at(&self.blocks, [0.0, 0.0]);
                        return Err(MeshError::Degenerate { block: block_index, at });
                    }
                    cells.push(cell);
                }
            }
        }
        Ok((cells, corners.points.len()))
    }

    fn sides(&self, cells: &[Cell], tolerance: f64) -> Result<Sides, MeshError> {
        let mut sides = Sides::new();
        for (index, cell) in cells.iter().enumerate() {
            for side in 0..4 {
                let (a, b) = cell.side_corners(side);
                sides.entry((a.min(b), a.max(b))).or_default().push((index, side));
            }
        }
        for shared in sides.values() {
            let [(first, side), others @ ..] = shared.as_slice() else { continue };
            let at = cells[*first].at(&self.blocks, side_point(*side, 0.0));
            if others.len() > 1 {
                return Err(MeshError::Overlap { block: cells[*first].block, at });
            }
            for &(other, other_side) in others {
                // Compare both curves away from the middle, where a different parametrization shows
                // too.
                let one = cells[*first].at(&self.blocks, side_point(*side, 1.0 / 3.0));
                // Neighbours run along their common edge in opposite directions.
                if cells[*first].side_corners(*side) == cells[other].side_corners(other_side) {
                    return Err(MeshError::Overlap { block: cells[other].block, at });
                }
                let theirs = cells[other].at(&self.blocks, side_point(other_side, -1.0 / 3.0));
                let agrees = distance(one, theirs) <= tolerance;
                if !agrees {
                    return Err(MeshError::Mismatch {
                        blocks: [cells[*first].block, cells[other].block],
                        at,
                    });
                }
            }
        }
        Ok(sides)
    }

    /// Numbers the nodes of every cell for the given orders: corners first, then inner nodes of
    /// sides (shared), then interiors. Positions are those of the blocks.
    fn number_nodes(
        &self,
        cells: &[Cell],
        sides: &Sides,
        corner_count: usize,
        orders: &[ElementOrder],
    ) -> (Vec<[f64; 2]>, Vec<Vec<usize>>) {
        let mut points = vec![[0.0; 2]; corner_count];
        let mut numbers =
            cells.iter().zip(orders).map(|(_, order)| vec![0; order.node_count()]).collect::<Vec<_>>();
        // In reverse order, so that the first cell with a corner sets its position.
        for (cell, nodes) in cells.iter().zip(&mut numbers).rev() {
            for (corner, &number) in cell.corners.iter().enumerate() {
                nodes[corner] = number;
                points[number] = cell.at(&self.blocks, side_point(corner, -1.0));
            }
        }
        for shared in sides.values() {
            let (first, side) = shared[0];
            let ends = cells[first].side_corners(side);
            let locals = orders[first].side_nodes(side);
            let places = orders[first].node_coordinates();
            let start = points.len();
            let inner = &locals[1..locals.len() - 1];
            points.extend(inner.iter().map(|&local| cells[first].at(&self.blocks, places[local])));
            for &(cell, side) in shared {
                let mut locals = orders[cell].side_nodes(side);
                if cells[cell].side_corners(side) != ends {
                    locals.reverse();
                }
                for (offset, &local) in locals[1..locals.len() - 1].iter().enumerate() {
                    numbers[cell][local] = start + offset;
                }
            }
        }
        for ((cell, order), nodes) in cells.iter().zip(orders).zip(&mut numbers) {
            let [a, b] = order.interior;
            let count = (usize::from(a) - 1) * (usize::from(b) - 1);
            let first_local = nodes.len() - count;
            for (node, place) in nodes[first_local..].iter_mut().zip(&order.node_coordinates()[first_local..])
            {
                *node = points.len();
                points.push(cell.at(&self.blocks, *place));
            }
        }
        (points, numbers)
    }

    /// Rejects hanging nodes: blocks with different divisions along a common line leave corners of
    /// one on the edges of the other.
    fn check_hanging(&self, mesh: &PlaneMesh, cells: &[Cell], sides: &Sides) -> Result<(), MeshError> {
        let boundary = || sides.iter().filter(|(_, shared)| shared.len() == 1);
        let corners = boundary().flat_map(|(&(a, b), _)| [a, b]).collect::<BTreeSet<_>>();
        for (&(a, b), shared) in boundary() {
            let (element, side) = shared[0];
            let edge = ElementEdge { element, side, reversed: false, s: [0.0; 2] };
            let length = distance(mesh.nodes[a], mesh.nodes[b]);
            let middle = mesh.edge_point(&edge, 0.0).position;
            for &corner in corners.iter().filter(|&&corner| corner != a && corner != b) {
                let point = mesh.nodes[corner];
                if distance(point, middle) > length {
                    continue;
                }
                // Newton's method for the foot of the perpendicular, from the middle.
                let mut t = 0.0;
                for _ in 0..8 {
                    let at = mesh.edge_point(&edge, t);
                    let along = (0..2).map(|axis| (point[axis] - at.position[axis]) * at.tangent[axis]);
                    t = (t + along.sum::<f64>() / at.speed).clamp(-1.0, 1.0);
                }
                if distance(mesh.edge_point(&edge, t).position, point) < 1e-4 * length {
                    return Err(MeshError::Hanging { block: cells[element].block, at: point });
                }
            }
        }
        Ok(())
    }

    fn name_chains(&self, mesh: &mut PlaneMesh, cells: &[Cell]) -> Result<(), MeshError> {
        let mut named = BTreeMap::<&str, (ArcLength, Vec<ElementEdge>)>::new();
        for (block_index, block) in self.blocks.iter().enumerate() {
            for NamedSide { side, name, profile } in &block.names {
                let length = profile.map_or(1.0, |[from, to]| (to - from).abs());
                if !(length.is_finite() && length > 0.0) {
                    return Err(MeshError::EmptyProfile { block: block_index, name: name.clone() });
                }
                let measure = if profile.is_some() { ArcLength::Profile } else { ArcLength::Mesh };
                let (known, edges) = named.entry(name.as_str()).or_insert((measure, Vec::new()));
                if *known != measure {
                    return Err(MeshError::MixedChain { name: name.clone() });
                }
                for (element, cell) in cells.iter().enumerate().filter(|(_, cell)| cell.block == block_index)
                {
                    let (across, bound, along) = match side.index() {
                        0 => (cell.v[0], 0.0, cell.u),
                        1 => (cell.u[1], 1.0, cell.v),
                        2 => (cell.v[1], 1.0, cell.u),
                        _ => (cell.u[0], 0.0, cell.v),
                    };
                    if across != bound {
                        continue;
                    }
                    let (mut s, mut reversed) = ([0.0; 2], false);
                    if let Some([from, to]) = *profile {
                        s = along.map(|u| (1.0 - u) * from + u * to);
                        reversed = side.opposes_element();
                        if s[0] > s[1] {
                            (s, reversed) = ([s[1], s[0]], !reversed);
                        }
                    }
                    edges.push(ElementEdge { element, side: side.index(), reversed, s });
                }
            }
        }
        for (name, (measure, mut edges)) in named {
            match measure {
                ArcLength::Profile => edges.sort_by(|a, b| a.s[0].total_cmp(&b.s[0])),
                ArcLength::Mesh => {
                    edges = chained(edges, cells);
                    let mut s = 0.0;
                    for edge in &mut edges {
                        let length = mesh.length_to(edge, 1.0);
                        edge.s = [s, s + length];
                        s += length;
                    }
                }
            }
            mesh.chains.insert(name.to_owned(), EdgeChain { edges, measure });
        }
        Ok(())
    }
}

/// Raises shared sides to the highest order of their cells.
fn raise_shared_sides(cells: &mut [Cell], sides: &Sides) {
    for shared in sides.values() {
        let highest = shared.iter().map(|&(cell, side)| cells[cell].order.sides[side]).max().unwrap_or(1);
        for &(cell, side) in shared {
            cells[cell].order.sides[side] = highest;
        }
    }
}

fn place_displacement_nodes(mesh: &mut PlaneMesh) {
    let count = mesh.elements.iter().flat_map(|element| &element.nodes).max().map_or(0, |&node| node + 1);
    let mut nodes = vec![[0.0; 2]; count];
    // Most elements have the same order.
    let mut tables = BTreeMap::new();
    for element in mesh.elements.iter().rev() {
        let (order, coordinate) = (element.order, element.coordinate_order);
        let shapes: &Vec<Vec<Shape>> = tables.entry((order, coordinate)).or_insert_with(|| {
            order.node_coordinates().into_iter().map(|[xi, eta]| coordinate.shapes(xi, eta)).collect()
        });
        for (&node, shapes) in element.nodes.iter().zip(shapes) {
            nodes[node] = mesh.map_with(element, shapes).0;
        }
    }
    mesh.nodes = nodes;
}

/// Checks that the Jacobian determinant is positive at all integration points, and at the corners,
/// where a fold appears first.
fn check_jacobians(mesh: &PlaneMesh, cells: &[Cell]) -> Result<(), MeshError> {
    let mut tables = BTreeMap::new();
    for (element, cell) in mesh.elements.iter().zip(cells) {
        let coordinate = element.coordinate_order;
        let order = element.order.highest().max(coordinate.highest());
        let points: &Vec<Vec<Shape>> = tables.entry((order, coordinate)).or_insert_with(|| {
            let mut ends = vec![-1.0, 1.0];
            ends.extend(gauss_legendre(usize::from(order) + 1).iter().map(|point| point.0));
            let at = |eta: f64| ends.iter().map(move |&xi| coordinate.shapes(xi, eta));
            ends.iter().flat_map(|&eta| at(eta)).collect()
        });
        for shapes in points {
            let (at, [[a, b], [c, d]]) = mesh.map_with(element, shapes);
            // The comparison is negated so that NaN fails it.
            let sound = a * d - b * c > 1e-6 * (a * a + b * b + c * c + d * d);
            if !sound {
                return Err(MeshError::Folded { block: cell.block, at });
            }
        }
    }
    Ok(())
}

/// Joins edges end to end, counter-clockwise around their elements. Separate pieces follow in their
/// original order.
fn chained(edges: Vec<ElementEdge>, cells: &[Cell]) -> Vec<ElementEdge> {
    let ends = edges.iter().map(|edge| cells[edge.element].side_corners(edge.side)).collect::<Vec<_>>();
    let mut left = vec![true; edges.len()];
    let mut ordered = Vec::with_capacity(edges.len());
    while ordered.len() < edges.len() {
        let open = |index: usize| left[index];
        let is_start =
            |index: usize| (0..edges.len()).all(|other| !left[other] || ends[other].1 != ends[index].0);
        let unused = || (0..edges.len()).filter(|&index| open(index));
        // A closed chain has no start: it begins with the edge that was named first.
        let mut next = unused().find(|&index| is_start(index)).or_else(|| unused().next());
        while let Some(index) = next {
            left[index] = false;
            ordered.push(edges[index]);
            next = (0..edges.len()).find(|&other| left[other] && ends[other].0 == ends[index].1);
        }
    }
    ordered
}

/// Assigns one index to points that coincide within the tolerance.
struct PointMerger {
    tolerance: f64,
    points: Vec<[f64; 2]>,
    /// Indices by square of a grid; only looked up, so the hash order has no effect.
    squares: HashMap<[i64; 2], Vec<usize>>,
}

impl PointMerger {
    fn new(tolerance: f64) -> Self {
        Self { tolerance, points: Vec::new(), squares: HashMap::new() }
    }

    fn number(&mut self, point: [f64; 2]) -> usize {
        let square = point.map(|part| (part / (2.0 * self.tolerance)).floor() as i64);
        for dx in -1..=1 {
            for dy in -1..=1 {
                let near = self.squares.get(&[square[0].saturating_add(dx), square[1].saturating_add(dy)]);
                let found = near.and_then(|numbers| {
                    numbers.iter().find(|&&number| distance(self.points[number], point) <= self.tolerance)
                });
                if let Some(&number) = found {
                    return number;
                }
            }
        }
        self.points.push(point);
        self.squares.entry(square).or_default().push(self.points.len() - 1);
        self.points.len() - 1
    }
}
