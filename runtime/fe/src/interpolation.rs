//! Interpolation on the square -1 <= xi, eta <= 1 with optional nodes: four corners, any order up
//! to cubic on each edge, optional interior nodes (report 3.1.3, figure 3.6). Used for
//! displacements and coordinates.

use calyx_numerics::interpolation::lagrange_polynomial;

/// Order of interpolation on each part of a quadrilateral.
///
/// Corners are (-1,-1), (1,-1), (1,1), (-1,1), counter-clockwise; side `k` runs from corner `k` to
/// the next. Nodes are numbered corners first, then the inner nodes of sides 0 to 3, each along its
/// side, then the interior ones with `xi` running fastest. Nodes are equally spaced.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct ElementOrder {
    /// Order of each side: 1 (no inner node), 2 (one) or 3 (two).
    pub sides: [u8; 4],
    /// Order of the grid of interior nodes along `xi` and `eta`: `(a - 1) * (b - 1)` nodes.
    pub interior: [u8; 2],
}

/// Shape function at a point: value, derivative by `xi`, derivative by `eta`.
pub type Shape = [f64; 3];

impl ElementOrder {
    /// Bilinear element with four nodes.
    pub const LINEAR: Self = Self::full(1);
    /// Biquadratic element with nine nodes.
    pub const QUADRATIC: Self = Self::full(2);
    /// Bicubic element with sixteen nodes.
    pub const CUBIC: Self = Self::full(3);

    /// Returns the complete tensor product of order 1, 2 or 3.
    pub const fn full(order: u8) -> Self {
        Self { sides: [order; 4], interior: [order; 2] }
    }

    /// Returns a serendipity element with boundary nodes only (8-node quadratic, 12-node cubic).
    pub const fn serendipity(order: u8) -> Self {
        Self { sides: [order; 4], interior: [1; 2] }
    }

    /// Returns true if every order is 1, 2 or 3.
    pub fn is_valid(&self) -> bool {
        self.sides.iter().chain(&self.interior).all(|order| (1..=3).contains(order))
    }

    /// Returns the highest order of the element and its sides.
    pub fn highest(&self) -> u8 {
        self.sides.iter().chain(&self.interior).copied().max().unwrap_or(1)
    }

    /// Returns the lowest order of a side: the highest order to which the whole element can be
    /// complete.
    pub fn lowest_side(&self) -> u8 {
        self.sides.iter().copied().min().unwrap_or(1)
    }

    /// Returns the number of nodes: 4 (linear) to 16 (cubic).
    pub fn node_count(&self) -> usize {
        self.boundary_count() + self.interior_count()
    }

    fn boundary_count(&self) -> usize {
        4 + self.sides.iter().map(|&order| usize::from(order) - 1).sum::<usize>()
    }

    fn interior_count(&self) -> usize {
        (usize::from(self.interior[0]) - 1) * (usize::from(self.interior[1]) - 1)
    }

    /// Returns the indices of the nodes of a side, in its direction, including the ends.
    pub fn side_nodes(&self, side: usize) -> Vec<usize> {
        let first = 4 + self.sides[..side].iter().map(|&order| usize::from(order) - 1).sum::<usize>();
        let mut nodes = vec![side];
        nodes.extend(first..first + usize::from(self.sides[side]) - 1);
        nodes.push((side + 1) % 4);
        nodes
    }

    /// Returns the local coordinates of the nodes.
    pub fn node_coordinates(&self) -> Vec<[f64; 2]> {
        let mut places = (0..4).map(|corner| side_point(corner, -1.0)).collect::<Vec<_>>();
        for (side, &order) in self.sides.iter().enumerate() {
            places.extend((1..order).map(|node| side_point(side, spaced(order, node))));
        }
        places.extend(self.interior_coordinates());
        places
    }

    fn interior_coordinates(&self) -> Vec<[f64; 2]> {
        let [a, b] = self.interior;
        (1..b).flat_map(|j| (1..a).map(move |i| [spaced(a, i), spaced(b, j)])).collect()
    }

    /// Returns all shape functions at a point, in the numbering of the nodes.
    ///
    /// Boundary functions blend the side's Lagrange functions linearly across the element. Interior
    /// nodes add tensor products that vanish on the boundary; these are subtracted from the
    /// boundary functions so that the latter vanish at the interior nodes. With equal orders
    /// everywhere this is the Lagrange tensor product.
    pub fn shapes(&self, xi: f64, eta: f64) -> Vec<Shape> {
        let mut shapes = self.boundary_shapes(xi, eta);
        if self.interior_count() == 0 {
            return shapes;
        }
        let [a, b] = self.interior;
        let (along_xi, along_eta) = (lagrange(a, xi), lagrange(b, eta));
        let mut interior = Vec::with_capacity(self.interior_count());
        for (f, df) in &along_eta[1..usize::from(b)] {
            for (g, dg) in &along_xi[1..usize::from(a)] {
                interior.push([g * f, dg * f, g * df]);
            }
        }
        for (bubble, place) in interior.iter().zip(self.interior_coordinates()) {
            let at_node = self.boundary_shapes(place[0], place[1]);
            for (shape, at) in shapes.iter_mut().zip(at_node) {
                for part in 0..3 {
                    shape[part] -= at[0] * bubble[part];
                }
            }
        }
        shapes.extend(interior);
        shapes
    }

    fn boundary_shapes(&self, xi: f64, eta: f64) -> Vec<Shape> {
        let mut shapes = vec![[0.0; 3]; self.boundary_count()];
        let mut next = 4;
        for side in 0..4 {
            let order = self.sides[side];
            // Coordinate along the side, and the linear function that is 1 on it and 0 on the
            // opposite side.
            let (t, dt, blend, dblend) = match side {
                0 => (xi, [1.0, 0.0], 0.5 * (1.0 - eta), [0.0, -0.5]),
                1 => (eta, [0.0, 1.0], 0.5 * (1.0 + xi), [0.5, 0.0]),
                2 => (-xi, [-1.0, 0.0], 0.5 * (1.0 + eta), [0.0, 0.5]),
                _ => (-eta, [0.0, -1.0], 0.5 * (1.0 - xi), [-0.5, 0.0]),
            };
            let along = lagrange(order, t);
            for (node, (value, slope)) in along.iter().take(usize::from(order) + 1).enumerate() {
                let index = if node == 0 {
                    side
                } else if node == usize::from(order) {
                    (side + 1) % 4
                } else {
                    next += 1;
                    next - 1
                };
                shapes[index][0] += value * blend;
                for part in 0..2 {
                    shapes[index][1 + part] += slope * dt[part] * blend + value * dblend[part];
                }
            }
        }
        // Both sides of a corner contribute its bilinear function: subtract it once.
        for corner in 0..4 {
            let [x, y] = side_point(corner, -1.0);
            let (f, g) = (0.5 * (1.0 + x * xi), 0.5 * (1.0 + y * eta));
            shapes[corner][0] -= f * g;
            shapes[corner][1] -= 0.5 * x * g;
            shapes[corner][2] -= 0.5 * y * f;
        }
        shapes
    }
}

/// Returns the point of a side at `t` in -1 ..= 1 along its direction.
pub fn side_point(side: usize, t: f64) -> [f64; 2] {
    match side {
        0 => [t, -1.0],
        1 => [1.0, t],
        2 => [-t, 1.0],
        _ => [-1.0, -t],
    }
}

/// Returns node `node` of `order + 1` equally spaced ones on -1 ..= 1.
fn spaced(order: u8, node: u8) -> f64 {
    f64::from(2 * i16::from(node) - i16::from(order)) / f64::from(order)
}

/// Returns values and derivatives of the Lagrange polynomials on equally spaced nodes; the first
/// `order + 1` are used.
fn lagrange(order: u8, x: f64) -> [(f64, f64); 4] {
    let nodes = [0, 1, 2, 3].map(|node| spaced(order, node));
    let used = &nodes[..=usize::from(order)];
    let mut functions = [(0.0, 0.0); 4];
    for (node, function) in functions[..used.len()].iter_mut().enumerate() {
        *function = lagrange_polynomial(used, node, x);
    }
    functions
}
