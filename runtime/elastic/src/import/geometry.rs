//! Shape functions of the elements, their quadrature points, and checks of their geometry.
//!
//! Derivatives are central differences. All shape functions are polynomials of degree two at most
//! in each coordinate, so the differences are exact.
//!
//! Source: O. C. Zienkiewicz, R. L. Taylor, "The Finite Element Method", volume 1, chapter on shape
//! functions (serendipity family).

use crate::model::{Element, ElementKind, Node, ShellShape, SolidShape};
use std::sync::OnceLock;

pub(super) type Vector = [f64; 3];

pub(super) fn sub(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub(super) fn add(a: Vector, b: Vector) -> Vector {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

pub(super) fn scale(a: Vector, factor: f64) -> Vector {
    a.map(|x| x * factor)
}

pub(super) fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(super) fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub(super) fn norm(a: Vector) -> f64 {
    dot(a, a).sqrt()
}

/// Unit vector along `a`; `None` if its length is zero or not finite.
pub(super) fn unit(a: Vector) -> Option<Vector> {
    let length = norm(a);
    (length > 0.0 && length.is_finite()).then(|| scale(a, 1.0 / length))
}

/// Number of corners of a shell element.
pub(super) fn shell_corners(shape: ShellShape) -> usize {
    if matches!(shape, ShellShape::Triangle3 | ShellShape::Triangle6) { 3 } else { 4 }
}

/// Corners of the square from -1 to 1, counter-clockwise.
const SQUARE: [[f64; 2]; 4] = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];

/// Coordinates of the nodes of a hexahedron.
fn hexahedron(count: usize) -> Vec<Vector> {
    let face = |t: f64| SQUARE.map(|[r, s]| [r, s, t]);
    let middle = |t: f64| [[0.0, -1.0, t], [1.0, 0.0, t], [0.0, 1.0, t], [-1.0, 0.0, t]];
    let all = [face(-1.0), face(1.0), middle(-1.0), face(0.0), middle(1.0)];
    all.into_iter().flatten().take(count).collect()
}

fn hexahedron_shapes(count: usize, [r, s, t]: Vector) -> Vec<f64> {
    let shape = |[a, b, c]: Vector| {
        let (p, q, w) = (1.0 + r * a, 1.0 + s * b, 1.0 + t * c);
        if count == 8 {
            0.125 * p * q * w
        } else if a == 0.0 {
            0.25 * (1.0 - r * r) * q * w
        } else if b == 0.0 {
            0.25 * (1.0 - s * s) * p * w
        } else if c == 0.0 {
            0.25 * (1.0 - t * t) * p * q
        } else {
            0.125 * p * q * w * (r * a + s * b + t * c - 2.0)
        }
    };
    hexahedron(count).into_iter().map(shape).collect()
}

fn wedge_shapes(count: usize, [r, s, t]: Vector) -> Vec<f64> {
    let corner = [1.0 - r - s, r, s];
    let ends = [0.5 * (1.0 - t), 0.5 * (1.0 + t)];
    let linear = || ends.into_iter().flat_map(|end| corner.map(|l| l * end));
    if count == 6 {
        return linear().collect();
    }
    let bubble = 1.0 - t * t;
    let corners =
        ends.into_iter().flat_map(|end| corner.map(|l| l * (2.0 * l - 1.0) * end - 0.5 * l * bubble));
    let side = |end: f64| (0..3).map(move |i| 4.0 * corner[i] * corner[(i + 1) % 3] * end);
    corners.chain(side(ends[0])).chain(corner.map(|l| l * bubble)).chain(side(ends[1])).collect()
}

fn tetrahedron_shapes(count: usize, [r, s, t]: Vector) -> Vec<f64> {
    let l = [1.0 - r - s - t, r, s, t];
    if count == 4 {
        return l.to_vec();
    }
    let sides = [[0, 1], [1, 2], [2, 0], [0, 3], [1, 3], [2, 3]];
    let corners = l.into_iter().map(|l| l * (2.0 * l - 1.0));
    corners.chain(sides.into_iter().map(|[i, j]| 4.0 * l[i] * l[j])).collect()
}

fn solid_shapes(shape: SolidShape, at: Vector) -> Vec<f64> {
    match shape {
        SolidShape::Hexahedron8 | SolidShape::IncompatibleHexahedron8 => hexahedron_shapes(8, at),
        SolidShape::Hexahedron20 => hexahedron_shapes(20, at),
        SolidShape::Wedge6 => wedge_shapes(6, at),
        SolidShape::Wedge15 => wedge_shapes(15, at),
        SolidShape::Tetrahedron4 => tetrahedron_shapes(4, at),
        SolidShape::Tetrahedron10 => tetrahedron_shapes(10, at),
    }
}

fn shell_shapes(shape: ShellShape, [r, s, _]: Vector) -> Vec<f64> {
    let l = [1.0 - r - s, r, s];
    let along = |x: f64, a: f64| if a == 0.0 { 1.0 - x * x } else { 0.5 * x * a * (1.0 + x * a) };
    let middles = [[0.0, -1.0], [1.0, 0.0], [0.0, 1.0], [-1.0, 0.0]];
    match shape {
        ShellShape::Triangle3 => l.to_vec(),
        ShellShape::Triangle6 => {
            let corners = l.into_iter().map(|l| l * (2.0 * l - 1.0));
            corners.chain((0..3).map(|i| 4.0 * l[i] * l[(i + 1) % 3])).collect()
        }
        ShellShape::Quadrilateral4 => SQUARE.map(|[a, b]| 0.25 * (1.0 + r * a) * (1.0 + s * b)).to_vec(),
        ShellShape::Quadrilateral8 => {
            let corners =
                SQUARE.map(|[a, b]| 0.25 * (1.0 + r * a) * (1.0 + s * b) * (r * a + s * b - 1.0)).into_iter();
            let middle = |[a, b]: [f64; 2]| match a == 0.0 {
                true => 0.5 * (1.0 - r * r) * (1.0 + s * b),
                false => 0.5 * (1.0 - s * s) * (1.0 + r * a),
            };
            corners.chain(middles.map(middle)).collect()
        }
        ShellShape::Quadrilateral9 => {
            let nodes = SQUARE.into_iter().chain(middles).chain([[0.0, 0.0]]);
            nodes.map(|[a, b]| along(r, a) * along(s, b)).collect()
        }
    }
}

/// Quadrature points of [-1, 1] with weights: exact for degree five.
fn line() -> [(f64, f64); 3] {
    let x = 0.6_f64.sqrt();
    [(-x, 5.0 / 9.0), (0.0, 8.0 / 9.0), (x, 5.0 / 9.0)]
}

/// Quadrature points of the unit triangle with weights: exact for degree two.
const TRIANGLE: [([f64; 2], f64); 3] = [
    ([1.0 / 6.0, 1.0 / 6.0], 1.0 / 6.0),
    ([2.0 / 3.0, 1.0 / 6.0], 1.0 / 6.0),
    ([1.0 / 6.0, 2.0 / 3.0], 1.0 / 6.0),
];

/// Quadrature points of a solid element with weights.
fn solid_points(shape: SolidShape) -> Vec<(Vector, f64)> {
    let mut points = Vec::new();
    match shape {
        SolidShape::Hexahedron8 | SolidShape::IncompatibleHexahedron8 | SolidShape::Hexahedron20 => {
            for (t, c) in line() {
                points.extend(square_points().into_iter().map(|([r, s, _], w)| ([r, s, t], w * c)));
            }
        }
        SolidShape::Wedge6 | SolidShape::Wedge15 => {
            for (t, c) in line() {
                points.extend(TRIANGLE.iter().map(|([r, s], w)| ([*r, *s, t], w * c)));
            }
        }
        SolidShape::Tetrahedron4 | SolidShape::Tetrahedron10 => {
            let (a, b) = (0.138_196_601_125_010_5, 0.585_410_196_624_968_5);
            points.extend([[a, a, a], [b, a, a], [a, b, a], [a, a, b]].map(|at| (at, 1.0 / 24.0)));
        }
    }
    points
}

fn square_points() -> Vec<(Vector, f64)> {
    let row = |(s, b): (f64, f64)| line().map(|(r, a)| ([r, s, 0.0], a * b));
    line().into_iter().flat_map(row).collect()
}

/// Quadrature points of a shell element with weights.
fn shell_points(shape: ShellShape) -> Vec<(Vector, f64)> {
    match shell_corners(shape) {
        3 => TRIANGLE.iter().map(|([r, s], weight)| ([*r, *s, 0.0], *weight)).collect(),
        _ => square_points(),
    }
}

/// Sum of shape functions times positions.
pub(super) fn interpolate(shapes: &[f64], positions: &[Vector]) -> Vector {
    shapes.iter().zip(positions).fold([0.0; 3], |sum, (n, x)| add(sum, scale(*x, *n)))
}

/// Quadrature point of an element: shape functions, their derivatives and the weight.
pub(super) struct Point {
    pub shapes: Vec<f64>,
    derivatives: Vec<Vector>,
    pub weight: f64,
}

/// Points of a quadrature rule.
fn tabulated(
    points: Vec<(Vector, f64)>,
    dimensions: usize,
    shapes: impl Fn(Vector) -> Vec<f64>,
) -> Vec<Point> {
    let point = |(at, weight): (Vector, f64)| {
        let own = shapes(at);
        let mut derivatives = vec![[0.0; 3]; own.len()];
        for axis in 0..dimensions {
            let step = |h: f64| {
                let mut moved = at;
                moved[axis] += h;
                shapes(moved)
            };
            // A step of one half to either side: the difference is divided by one.
            for (derivative, (a, b)) in derivatives.iter_mut().zip(step(0.5).iter().zip(&step(-0.5))) {
                derivative[axis] = a - b;
            }
        }
        Point { shapes: own, derivatives, weight }
    };
    points.into_iter().map(point).collect()
}

/// Quadrature points of a solid element.
pub(super) fn solid_table(shape: SolidShape) -> &'static [Point] {
    static TABLES: [OnceLock<Vec<Point>>; 7] = [const { OnceLock::new() }; 7];
    TABLES[shape as usize].get_or_init(|| tabulated(solid_points(shape), 3, |at| solid_shapes(shape, at)))
}

/// Quadrature points of a shell element. Shapes with the same corners have the same points.
pub(super) fn shell_table(shape: ShellShape) -> &'static [Point] {
    static TABLES: [OnceLock<Vec<Point>>; 5] = [const { OnceLock::new() }; 5];
    TABLES[shape as usize].get_or_init(|| tabulated(shell_points(shape), 2, |at| shell_shapes(shape, at)))
}

impl Point {
    /// Derivatives of the position with respect to the coordinates of the element.
    fn tangents(&self, positions: &[Vector]) -> [Vector; 3] {
        let mut tangents = [[0.0; 3]; 3];
        for (derivative, position) in self.derivatives.iter().zip(positions) {
            for (tangent, factor) in tangents.iter_mut().zip(derivative) {
                (0..3).for_each(|i| tangent[i] += factor * position[i]);
            }
        }
        tangents
    }

    /// Determinant of the Jacobian matrix of a solid element.
    pub fn jacobian(&self, positions: &[Vector]) -> f64 {
        let [r, s, t] = self.tangents(positions);
        dot(cross(r, s), t)
    }

    /// Normal of a shell element; its length is the area per area of the reference element.
    pub fn normal(&self, positions: &[Vector]) -> Vector {
        let [r, s, _] = self.tangents(positions);
        cross(r, s)
    }
}

/// Smallest accepted ratio of the Jacobian to the size of the element to the third power, or to the
/// second power for shells.
const FLAT: f64 = 1e-10;

/// Returns the defect of an element's geometry, to follow the name of the element.
pub(super) fn defect(element: &Element, nodes: &[Node]) -> Option<String> {
    let positions: Vec<Vector> = element.nodes.iter().map(|node| nodes[*node].position).collect();
    let mut sorted = element.nodes.clone();
    sorted.sort_unstable();
    let repeated = sorted.windows(2).find(|pair| pair[0] == pair[1]);
    if let Some(pair) = repeated
        && !matches!(element.kind, ElementKind::Spring { .. })
    {
        return Some(format!("uses node {} twice", nodes[pair[0]].label));
    }
    let size = positions.iter().map(|x| norm(sub(*x, positions[0]))).fold(0.0, f64::max);
    match &element.kind {
        ElementKind::Solid(shape) => {
            let least = FLAT * size.powi(3);
            let values: Vec<f64> =
                solid_table(*shape).iter().map(|point| point.jacobian(&positions)).collect();
            jacobian_defect(&values, least)
        }
        ElementKind::Shell { shape, .. } => {
            let least = FLAT * size.powi(2);
            let points = shell_table(*shape);
            let mean = points.iter().fold([0.0; 3], |sum, point| add(sum, point.normal(&positions)));
            let Some(mean) = unit(mean) else {
                return Some("has no area".into());
            };
            let values: Vec<f64> = points.iter().map(|point| dot(point.normal(&positions), mean)).collect();
            if values.iter().all(|value| *value <= least) {
                return Some("has no area".into());
            }
            values.iter().any(|value| *value <= least).then(|| "is folded: its sides cross".into())
        }
        ElementKind::Beam(beam) => {
            let ends = [0, 1].map(|i| add(positions[i], beam.offsets[i]));
            let axis = sub(ends[1], ends[0]);
            let Some(direction) = unit(axis) else {
                return Some("has no length".into());
            };
            let across = cross(direction, beam.orientation);
            (norm(across) <= 1e-6 * norm(beam.orientation))
                .then(|| "has an orientation vector that is parallel to its axis, or zero".into())
        }
        ElementKind::Rod { .. } => (size <= 0.0).then(|| "has no length".into()),
        ElementKind::Spring { .. } | ElementKind::Mass { .. } => None,
    }
}

fn jacobian_defect(values: &[f64], least: f64) -> Option<String> {
    let lowest = values.iter().copied().fold(f64::INFINITY, f64::min);
    let highest = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    if lowest > least {
        None
    } else if highest < -least {
        Some("is inverted: the determinant of its Jacobian matrix is negative".into())
    } else if highest <= least {
        Some("is flat: it has no volume".into())
    } else {
        Some(
            "is distorted: the determinant of its Jacobian matrix is not positive at a quadrature point"
                .into(),
        )
    }
}
