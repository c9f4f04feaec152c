//! Shape functions and quadrature rules of shell elements over the reference square
//! -1 <= xi, eta <= 1 and the reference triangle xi, eta >= 0, xi + eta <= 1.

use crate::model::ShellShape;
use calyx_fe::solid::interpolation::Interpolation;
use calyx_fe::solid::line_interpolation::equispaced;
use calyx_numerics::interpolation::lagrange_with_slopes;
use calyx_numerics::quadrature::gauss_legendre;

/// Shape function at a point: value, derivatives by xi and eta.
pub(super) type Shape = [f64; 3];

/// Point of a quadrature rule and its weight.
pub(super) type Weighted = ([f64; 2], f64);

/// Signs of the local coordinates of the corners of a quadrilateral.
const CORNERS: [[f64; 2]; 4] = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];

impl ShellShape {
    /// Returns the number of nodes.
    pub fn node_count(self) -> usize {
        match self {
            Self::Triangle3 => 3,
            Self::Quadrilateral4 => 4,
            Self::Triangle6 => 6,
            Self::Quadrilateral8 => 8,
            Self::Quadrilateral9 => 9,
        }
    }

    /// Returns the number of corners.
    pub fn corner_count(self) -> usize {
        if self.is_triangle() { 3 } else { 4 }
    }

    /// Returns true for triangles.
    pub fn is_triangle(self) -> bool {
        matches!(self, Self::Triangle3 | Self::Triangle6)
    }

    /// Returns the local coordinates of the nodes.
    pub fn node_coordinates(self) -> Vec<[f64; 2]> {
        let corners: &[[f64; 2]] =
            if self.is_triangle() { &[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]] } else { &CORNERS };
        let mut nodes = corners.to_vec();
        if self.node_count() > corners.len() {
            for (side, from) in corners.iter().enumerate() {
                let to = corners[(side + 1) % corners.len()];
                nodes.push([0.5 * (from[0] + to[0]), 0.5 * (from[1] + to[1])]);
            }
        }
        if self == Self::Quadrilateral9 {
            nodes.push([0.0; 2]);
        }
        nodes
    }

    /// Returns the shape functions, in the order of the nodes.
    pub(super) fn shapes(self, at: [f64; 2]) -> Vec<Shape> {
        match self {
            Self::Triangle3 => linear_triangle(at).to_vec(),
            Self::Triangle6 => quadratic_triangle(at),
            Self::Quadrilateral4 => CORNERS.iter().map(|corner| bilinear(*corner, at)).collect(),
            Self::Quadrilateral8 => serendipity(at),
            Self::Quadrilateral9 => biquadratic(at),
        }
    }

    /// Returns the shape functions of the corners only: linear or bilinear.
    pub(super) fn corner_shapes(self, at: [f64; 2]) -> Vec<Shape> {
        if self.is_triangle() { Self::Triangle3.shapes(at) } else { Self::Quadrilateral4.shapes(at) }
    }
}

fn linear_triangle([xi, eta]: [f64; 2]) -> [Shape; 3] {
    [[1.0 - xi - eta, -1.0, -1.0], [xi, 1.0, 0.0], [eta, 0.0, 1.0]]
}

fn quadratic_triangle(at: [f64; 2]) -> Vec<Shape> {
    let linear = linear_triangle(at);
    let corner = |[l, dx, dy]: Shape| [l * (2.0 * l - 1.0), (4.0 * l - 1.0) * dx, (4.0 * l - 1.0) * dy];
    let side = |a: Shape, b: Shape| {
        [4.0 * a[0] * b[0], 4.0 * (a[1] * b[0] + a[0] * b[1]), 4.0 * (a[2] * b[0] + a[0] * b[2])]
    };
    let mut shapes = linear.map(corner).to_vec();
    shapes.extend((0..3).map(|first| side(linear[first], linear[(first + 1) % 3])));
    shapes
}

fn bilinear([a, b]: [f64; 2], [xi, eta]: [f64; 2]) -> Shape {
    let (f, g) = (1.0 + a * xi, 1.0 + b * eta);
    [0.25 * f * g, 0.25 * a * g, 0.25 * b * f]
}

fn serendipity(at: [f64; 2]) -> Vec<Shape> {
    let [xi, eta] = at;
    let mut shapes = Vec::with_capacity(8);
    for [a, b] in CORNERS {
        // Bilinear function times (a xi + b eta - 1).
        let [value, dx, dy] = bilinear([a, b], at);
        let factor = a * xi + b * eta - 1.0;
        shapes.push([value * factor, dx * factor + value * a, dy * factor + value * b]);
    }
    for side in 0..4 {
        let ([a, b], [c, d]) = (CORNERS[side], CORNERS[(side + 1) % 4]);
        let [x, y] = [0.5 * (a + c), 0.5 * (b + d)];
        shapes.push(if x == 0.0 {
            let (f, g) = (1.0 - xi * xi, 1.0 + y * eta);
            [0.5 * f * g, -xi * g, 0.5 * f * y]
        } else {
            let (f, g) = (1.0 + x * xi, 1.0 - eta * eta);
            [0.5 * f * g, 0.5 * x * g, -f * eta]
        });
    }
    shapes
}

fn biquadratic([xi, eta]: [f64; 2]) -> Vec<Shape> {
    let points = [-1.0, 0.0, 1.0];
    let (f, g) = (lagrange_with_slopes(&points, xi), lagrange_with_slopes(&points, eta));
    let product = |[x, y]: [f64; 2]| {
        let ((f, df), (g, dg)) = (f[(x + 1.5) as usize], g[(y + 1.5) as usize]);
        [f * g, df * g, f * dg]
    };
    ShellShape::Quadrilateral9.node_coordinates().into_iter().map(product).collect()
}

/// Returns (1 - xi²) (1 - eta²).
pub(super) fn square_bubble([xi, eta]: [f64; 2]) -> Shape {
    let (f, g) = (1.0 - xi * xi, 1.0 - eta * eta);
    [f * g, -2.0 * xi * g, -2.0 * eta * f]
}

/// Returns 27 xi eta (1 - xi - eta).
pub(super) fn triangle_bubble([xi, eta]: [f64; 2]) -> Shape {
    let rest = 1.0 - xi - eta;
    [27.0 * xi * eta * rest, 27.0 * eta * (rest - xi), 27.0 * xi * (rest - eta)]
}

/// Returns the shape functions of Lagrange quadrilaterals on equally spaced nodes; xi runs fastest.
pub(super) fn lagrange_quadrilateral(order: u8, [xi, eta]: [f64; 2]) -> Vec<Shape> {
    let points = equispaced(order);
    let (f, g) = (lagrange_with_slopes(&points, xi), lagrange_with_slopes(&points, eta));
    g.iter().flat_map(|&(g, dg)| f.iter().map(move |&(f, df)| [f * g, df * g, f * dg])).collect()
}

/// Returns the shape functions of Lagrange triangles on equally spaced nodes; xi runs fastest.
pub(super) fn lagrange_triangle(order: u8, [xi, eta]: [f64; 2]) -> Vec<Shape> {
    let n = usize::from(order);
    // On its first face, a pentahedron has the functions of the triangle.
    let shapes = Interpolation::Pentahedron(order).shapes([xi, eta, -1.0]);
    shapes.into_iter().take((n + 1) * (n + 2) / 2).map(|[f, dx, dy, _]| [f, dx, dy]).collect()
}

/// Returns the product of two Gauss rules over the square, exact to degree `2 * points - 1` in each
/// coordinate.
pub(super) fn square_rule(points: usize) -> Vec<Weighted> {
    let line = gauss_legendre(points);
    line.iter().flat_map(|&(y, b)| line.iter().map(move |&(x, a)| ([x, y], a * b))).collect()
}

/// Returns a rule over the triangle that is exact to a total degree. Rules to degree 4 are
/// symmetric with 1, 3 and 6 points (Dunavant 1985); above, a square is collapsed onto the
/// triangle.
pub(super) fn triangle_rule(degree: usize) -> Vec<Weighted> {
    let orbit = |a: f64, weight: f64| {
        [[a, a], [1.0 - 2.0 * a, a], [a, 1.0 - 2.0 * a]].map(|point| (point, 0.5 * weight))
    };
    match degree {
        0 | 1 => vec![([1.0 / 3.0; 2], 0.5)],
        2 => orbit(1.0 / 6.0, 1.0 / 3.0).to_vec(),
        3 | 4 => {
            let ten = 10.0_f64.sqrt();
            let root = (38.0 - 44.0 * 0.4_f64.sqrt()).sqrt();
            let spread = (213_125.0 - 53_320.0 * ten).sqrt();
            let place = |sign: f64| (8.0 - ten + sign * root) / 18.0;
            let weight = |sign: f64| (620.0 + sign * spread) / 3720.0;
            [orbit(place(1.0), weight(1.0)), orbit(place(-1.0), weight(-1.0))].concat()
        }
        _ => {
            let mut rule = Vec::new();
            // The determinant of the collapse adds one degree.
            for (y, b) in gauss_legendre((degree + 3) / 2) {
                let (v, height) = (0.5 * (1.0 + y), 0.5 * (1.0 - y));
                for (x, a) in gauss_legendre((degree + 3) / 2) {
                    rule.push(([0.5 * (1.0 + x) * height, v], 0.25 * a * b * height));
                }
            }
            rule
        }
    }
}
