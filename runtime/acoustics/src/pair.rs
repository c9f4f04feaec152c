//! Integrals of the kernels over pairs of triangles.

use crate::panel::Panel;
use crate::quadrature::{Barycentric, Contact, PairRule, product_rule, singular_rule, triangle_rule};
use calyx_numerics::vec3::{Vector, length, minus, plus, scaled};
use faer::c64;
use wide::f64x4;

/// Integrals of a pair of triangles, by the shape functions of the first and the second.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PairMoments {
    /// ∬ φ_i(x) φ_j(y) G.
    pub single: [[c64; 3]; 3],
    /// ∬ φ_i(x) φ_j(y) ∂G/∂n(y).
    pub double: [[c64; 3]; 3],
    /// ∬ φ_i(x) φ_j(y) ∂G/∂n(x).
    pub adjoint: [[c64; 3]; 3],
}

impl PairMoments {
    const ZERO: Self = {
        let zero = [[c64::new(0.0, 0.0); 3]; 3];
        Self { single: zero, double: zero, adjoint: zero }
    };

    fn map(self, mut change: impl FnMut([[c64; 3]; 3]) -> [[c64; 3]; 3]) -> Self {
        Self { single: change(self.single), double: change(self.double), adjoint: change(self.adjoint) }
    }

    fn add(&mut self, other: &Self) {
        for i in 0..3 {
            for j in 0..3 {
                self.single[i][j] += other.single[i][j];
                self.double[i][j] += other.double[i][j];
                self.adjoint[i][j] += other.adjoint[i][j];
            }
        }
    }
}

/// Quadrature rules for pairs of triangles by their distance.
#[derive(Debug)]
pub(crate) struct PairQuadrature {
    /// `None` for the product of the rule of three points.
    far: Option<PairRule>,
    middle: PairRule,
    near: PairRule,
    vertex: PairRule,
    edge: PairRule,
    same: PairRule,
    /// Least distances of the centroids for the rules `far` and `middle`, relative to the sum of
    /// the radii.
    limits: [f64; 2],
}

/// Least distance of sample points for the rule `near`, relative to the largest edge; closer pairs
/// are subdivided.
const NEAR: f64 = 0.4;
/// Largest number of subdivisions of a pair.
const DEPTH: usize = 6;

impl PairQuadrature {
    /// Creates the rules for elements of at least six per wavelength.
    pub fn standard() -> Self {
        Self::new([3, 6, 12], 4, [3.0, 1.7])
    }

    /// Creates finer rules, to estimate the error of the standard ones.
    pub fn fine() -> Self {
        Self::new([12, 12, 12], 7, [3.0, 3.0])
    }

    fn new(points: [usize; 3], gauss: usize, limits: [f64; 2]) -> Self {
        let [far, middle, near] = points.map(|count| product_rule(&triangle_rule(count)));
        let far = (points[0] > 3).then_some(far);
        let [vertex, edge, same] =
            [Contact::Vertex, Contact::Edge, Contact::Same].map(|contact| singular_rule(contact, gauss));
        Self { far, middle, near, vertex, edge, same, limits }
    }

    /// Integrates over a pair of triangles.
    pub fn moments(&self, wavenumber: f64, first: &Panel, second: &Panel) -> PairMoments {
        let distance = length(minus(first.centroid, second.centroid));
        let reach = first.radius + second.radius;
        let whole = |rule: &PairRule| {
            integrate(rule, wavenumber, first, second, &first.corners, &second.corners, 1.0)
        };
        if distance >= self.limits[0] * reach {
            return match &self.far {
                Some(rule) => whole(rule),
                None => three_points(wavenumber, first, second),
            };
        }
        if distance >= self.limits[1] * reach {
            return whole(&self.middle);
        }
        match shared(first, second) {
            Shared { count: 0, .. } => {
                let unit = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
                let mut sum = PairMoments::ZERO;
                self.subdivided(wavenumber, [first, second], [unit, unit], DEPTH, 1.0, &mut sum);
                sum
            }
            Shared { count, orders } => {
                let rule = [&self.vertex, &self.edge, &self.same][count - 1];
                let [from, to] = orders;
                let corners = [from.map(|c| first.corners[c]), to.map(|c| second.corners[c])];
                let mut found = integrate(rule, wavenumber, first, second, &corners[0], &corners[1], 1.0);
                if count == 3 {
                    // The normal derivatives vanish in the plane of the triangle.
                    found = PairMoments { single: found.single, ..PairMoments::ZERO };
                }
                found.map(|part| {
                    let mut ordered = [[c64::new(0.0, 0.0); 3]; 3];
                    for i in 0..3 {
                        for j in 0..3 {
                            ordered[from[i]][to[j]] = part[i][j];
                        }
                    }
                    ordered
                })
            }
        }
    }

    /// Adds the integrals over parts of two separate triangles, which are given by the barycentric
    /// coordinates of their corners.
    fn subdivided(
        &self,
        wavenumber: f64,
        panels: [&Panel; 2],
        parts: [[Barycentric; 3]; 2],
        depth: usize,
        weight: f64,
        sum: &mut PairMoments,
    ) {
        let corners = [0, 1].map(|side| parts[side].map(|point| position(panels[side], point)));
        let edges = corners.map(longest_edge);
        let largest = edges[0].max(edges[1]);
        if depth == 0 || sample_distance(&corners) >= NEAR * largest {
            let [a, b] = panels;
            let found = integrate(&self.near, wavenumber, a, b, &corners[0], &corners[1], weight);
            let [p, q] = parts;
            sum.add(&found.map(|part| {
                let mut whole = [[c64::new(0.0, 0.0); 3]; 3];
                for (i, row) in part.iter().enumerate() {
                    for (j, value) in row.iter().enumerate() {
                        for (m, line) in whole.iter_mut().enumerate() {
                            for (n, entry) in line.iter_mut().enumerate() {
                                *entry += *value * (p[i][m] * q[j][n]);
                            }
                        }
                    }
                }
                whole
            }));
            return;
        }
        let divided = [0, 1]
            .map(|side| if edges[side] > 0.6 * largest { quartered(parts[side]) } else { vec![parts[side]] });
        let share = weight / (divided[0].len() * divided[1].len()) as f64;
        for first in &divided[0] {
            for second in &divided[1] {
                self.subdivided(wavenumber, panels, [*first, *second], depth - 1, share, sum);
            }
        }
    }
}

/// Number of shared corners, and the orders of the corners of both triangles with these first.
struct Shared {
    count: usize,
    orders: [[usize; 3]; 2],
}

fn shared(first: &Panel, second: &Panel) -> Shared {
    let mut orders = [Vec::with_capacity(3), Vec::with_capacity(3)];
    for (i, key) in first.keys.iter().enumerate() {
        if let Some(j) = second.keys.iter().position(|other| other == key) {
            orders[0].push(i);
            orders[1].push(j);
        }
    }
    let count = orders[0].len();
    let orders = orders.map(|mut order| {
        (0..3).for_each(|corner| {
            if !order.contains(&corner) {
                order.push(corner);
            }
        });
        [order[0], order[1], order[2]]
    });
    Shared { count, orders }
}

fn position(panel: &Panel, [a, b, c]: Barycentric) -> Vector {
    let [p, q, r] = panel.corners;
    plus(plus(scaled(p, a), scaled(q, b)), scaled(r, c))
}

fn longest_edge([a, b, c]: [Vector; 3]) -> f64 {
    [minus(a, b), minus(b, c), minus(c, a)].map(length).into_iter().fold(0.0, f64::max)
}

/// Least distance of the corners, the midpoints of the edges and the centroids of two triangles.
fn sample_distance(corners: &[[Vector; 3]; 2]) -> f64 {
    let samples = corners.map(|[a, b, c]| {
        let middle = |p, q| scaled(plus(p, q), 0.5);
        [a, b, c, middle(a, b), middle(b, c), middle(c, a), scaled(plus(plus(a, b), c), 1.0 / 3.0)]
    });
    let [from, to] = &samples;
    from.iter().flat_map(|x| to.iter().map(|y| length(minus(*x, *y)))).fold(f64::INFINITY, f64::min)
}

/// Returns the four quarters of a triangle.
pub(crate) fn quartered([a, b, c]: [Barycentric; 3]) -> Vec<[Barycentric; 3]> {
    let middle = |p: Barycentric, q: Barycentric| [0, 1, 2].map(|axis| 0.5 * (p[axis] + q[axis]));
    let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
    vec![[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
}

/// Integrates with a rule over triangles with these corners, in the planes of the panels. `weight`
/// is the area of the pair relative to that of the panels.
fn integrate(
    rule: &PairRule,
    wavenumber: f64,
    first: &Panel,
    second: &Panel,
    from: &[Vector; 3],
    to: &[Vector; 3],
    weight: f64,
) -> PairMoments {
    let splat = f64x4::splat;
    let at = |corners: &[Vector; 3]| corners.map(|corner| corner.map(splat));
    let (from, to) = (at(from), at(to));
    let (n, m) = (first.normal.map(splat), second.normal.map(splat));
    let k = splat(wavenumber);
    let zero = [[splat(0.0); 3]; 3];
    let mut sums = [zero; 6];
    for points in rule {
        let r = [0, 1, 2].map(|axis| {
            let sum = |corners: &[[f64x4; 3]; 3], at: &[f64x4; 3]| {
                corners[0][axis] * at[0] + corners[1][axis] * at[1] + corners[2][axis] * at[2]
            };
            sum(&from, &points.first) - sum(&to, &points.second)
        });
        let kernel = kernel(&r, k);
        let [re, im, slope_re, slope_im] = kernel.map(|value| value * points.weights);
        let along = |normal: &[f64x4; 3]| r[0] * normal[0] + r[1] * normal[1] + r[2] * normal[2];
        let (p, q) = (along(&n), -along(&m));
        let values = [re, im, slope_re * q, slope_im * q, slope_re * p, slope_im * p];
        for (sum, value) in sums.iter_mut().zip(values) {
            for i in 0..3 {
                let row = value * points.first[i];
                for j in 0..3 {
                    sum[i][j] += row * points.second[j];
                }
            }
        }
    }
    let scale = weight * first.area * second.area / (4.0 * std::f64::consts::PI);
    let value = |at: usize| {
        [0, 1, 2].map(|i| {
            [0, 1, 2].map(|j| {
                c64::new(sums[at][i][j].reduce_add() * scale, sums[at + 1][i][j].reduce_add() * scale)
            })
        })
    };
    PairMoments { single: value(0), double: value(2), adjoint: value(4) }
}

/// Returns 4πG and 4π (dG/dr)/r, real and imaginary parts, at four distances.
#[inline]
fn kernel(r: &[f64x4; 3], k: f64x4) -> [f64x4; 4] {
    let distance = (r[0] * r[0] + r[1] * r[1] + r[2] * r[2]).sqrt();
    let inverse = f64x4::splat(1.0) / distance;
    let phase = k * distance;
    let (sine, cosine) = phase.sin_cos();
    let (re, im) = (cosine * inverse, -sine * inverse);
    let factor = inverse * inverse;
    [re, im, (phase * im - re) * factor, -(phase * re + im) * factor]
}

/// Integrates with three points in each triangle. The shape functions at the points are
/// ½ δ_ij + 1/6, so their products with the kernel are sums.
fn three_points(wavenumber: f64, first: &Panel, second: &Panel) -> PairMoments {
    let splat = f64x4::splat;
    let points = |panel: &Panel| {
        let shift = scaled(panel.centroid, 0.5);
        panel.corners.map(|corner| plus(scaled(corner, 0.5), shift))
    };
    let (from, to) = (points(first), points(second));
    // The fourth lane repeats a point and is not used.
    let to = [0, 1, 2].map(|axis| f64x4::from([to[0][axis], to[1][axis], to[2][axis], to[2][axis]]));
    let (n, m) = (first.normal.map(splat), second.normal.map(splat));
    let k = splat(wavenumber);
    let rows = from.map(|at| {
        let r = [0, 1, 2].map(|axis| splat(at[axis]) - to[axis]);
        let along = |normal: &[f64x4; 3]| r[0] * normal[0] + r[1] * normal[1] + r[2] * normal[2];
        let (p, q) = (along(&n), -along(&m));
        let [re, im, slope_re, slope_im] = kernel(&r, k);
        [re, im, slope_re * q, slope_im * q, slope_re * p, slope_im * p]
    });
    let scale = first.area * second.area / (36.0 * std::f64::consts::PI);
    let (half, sixth) = (splat(0.5 * scale), splat(scale / 6.0));
    let part = |at: usize| {
        let sum = (rows[0][at] + rows[1][at] + rows[2][at]) * sixth;
        [0, 1, 2].map(|i| {
            let [a, b, c, _] = (rows[i][at] * half + sum).to_array();
            let sum = (a + b + c) / 6.0;
            [0.5 * a + sum, 0.5 * b + sum, 0.5 * c + sum]
        })
    };
    let value = |at: usize| {
        let (re, im) = (part(at), part(at + 1));
        [0, 1, 2].map(|i| [0, 1, 2].map(|j| c64::new(re[i][j], im[i][j])))
    };
    PairMoments { single: value(0), double: value(2), adjoint: value(4) }
}
