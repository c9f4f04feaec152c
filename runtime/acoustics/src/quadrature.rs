//! Quadrature on triangles and on pairs of triangles.
//!
//! Pairs that share a vertex, an edge or all vertices have singular integrands. The transformations
//! of Sauter and Schwab (*Boundary Element Methods*, 2011, section 5.2) remove the singularity.

use calyx_numerics::quadrature::gauss_legendre;
use wide::f64x4;

/// Barycentric coordinates of a point in a triangle.
pub(crate) type Barycentric = [f64; 3];

/// Rule on a triangle: points and weights, whose sum is 1.
pub(crate) type TriangleRule = Vec<(Barycentric, f64)>;

/// Returns the rule with 3, 6 or 12 points, exact to the degree 2, 4 or 6 (Dunavant 1985).
pub(crate) fn triangle_rule(points: usize) -> TriangleRule {
    let mut rule = TriangleRule::new();
    let mut three = |a: f64, weight: f64| {
        let b = 1.0 - 2.0 * a;
        rule.extend([[b, a, a], [a, b, a], [a, a, b]].map(|point| (point, weight)));
    };
    match points {
        3 => three(1.0 / 6.0, 1.0 / 3.0),
        6 => {
            three(0.445_948_490_915_965, 0.223_381_589_678_011);
            three(0.091_576_213_509_771, 0.109_951_743_655_322);
        }
        _ => {
            three(0.249_286_745_170_910, 0.116_786_275_726_379);
            three(0.063_089_014_491_502, 0.050_844_906_370_207);
            let [a, b, c] = [0.053_145_049_844_817, 0.310_352_451_033_784, 0.636_502_499_121_399];
            let all = [[a, b, c], [b, c, a], [c, a, b], [a, c, b], [c, b, a], [b, a, c]];
            rule.extend(all.map(|point| (point, 0.082_851_075_618_374)));
        }
    }
    rule
}

/// Four points of a pair of triangles.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PairPoints {
    /// Barycentric coordinates in the first triangle.
    pub first: [f64x4; 3],
    /// Barycentric coordinates in the second triangle.
    pub second: [f64x4; 3],
    /// Weights.
    pub weights: f64x4,
}

/// Rule on a pair of triangles. The sum of the weights is 1.
pub(crate) type PairRule = Vec<PairPoints>;

/// Packs points of pairs into groups of four; the last group repeats its last point with weight 0.
fn packed(points: &[(Barycentric, Barycentric, f64)]) -> PairRule {
    points
        .chunks(4)
        .map(|chunk| {
            let at = |lane: usize| chunk[lane.min(chunk.len() - 1)];
            let lanes = |value: &dyn Fn(usize) -> f64| f64x4::from([0, 1, 2, 3].map(value));
            PairPoints {
                first: [0, 1, 2].map(|axis| lanes(&|lane| at(lane).0[axis])),
                second: [0, 1, 2].map(|axis| lanes(&|lane| at(lane).1[axis])),
                weights: lanes(&|lane| if lane < chunk.len() { at(lane).2 } else { 0.0 }),
            }
        })
        .collect()
}

/// Returns the product of a rule for separate triangles.
pub(crate) fn product_rule(rule: &TriangleRule) -> PairRule {
    let pairs = rule.iter().flat_map(|x| rule.iter().map(|y| (x.0, y.0, x.1 * y.1)));
    packed(&pairs.collect::<Vec<_>>())
}

/// Vertices that two triangles share; the rules expect the shared ones first, in the same order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Contact {
    Vertex,
    Edge,
    Same,
}

/// Returns the rule for triangles in contact, with this number of Gauss points along each of the
/// four coordinates.
pub(crate) fn singular_rule(contact: Contact, points: usize) -> PairRule {
    let gauss: Vec<(f64, f64)> =
        gauss_legendre(points).into_iter().map(|(x, weight)| (0.5 * (x + 1.0), 0.5 * weight)).collect();
    let mut all = Vec::new();
    for &(xi, w0) in &gauss {
        for &(e1, w1) in &gauss {
            for &(e2, w2) in &gauss {
                for &(e3, w3) in &gauss {
                    for (jacobian, x, y) in transformed(contact, [e1, e2, e3]) {
                        // On the simplex 0 <= x2 <= x1 <= 1; the measure of the pair is 1/4.
                        let weight = 4.0 * w0 * w1 * w2 * w3 * xi * xi * xi * jacobian;
                        let point = |[x1, x2]: [f64; 2]| [1.0 - xi * x1, xi * (x1 - x2), xi * x2];
                        all.push((point(x), point(y), weight));
                    }
                }
            }
        }
    }
    packed(&all)
}

/// Regions of the transformation: Jacobian without ξ³, and both points divided by ξ.
fn transformed(contact: Contact, [a, b, c]: [f64; 3]) -> Vec<(f64, [f64; 2], [f64; 2])> {
    match contact {
        Contact::Vertex => {
            let (x, y) = ([1.0, a], [b, b * c]);
            vec![(b, x, y), (b, y, x)]
        }
        Contact::Edge => {
            let j = a * a;
            vec![
                (j, [1.0, a * c], [1.0 - a * b, a * (1.0 - b)]),
                (j * b, [1.0, a], [1.0 - a * b * c, a * b * (1.0 - c)]),
                (j * b, [1.0 - a * b, a * (1.0 - b)], [1.0, a * b * c]),
                (j * b, [1.0 - a * b * c, a * b * (1.0 - c)], [1.0, a]),
                (j * b, [1.0 - a * b * c, a * (1.0 - b * c)], [1.0, a * b]),
            ]
        }
        Contact::Same => {
            let j = a * a * b;
            let regions = [
                ([1.0, 1.0 - a + a * b], [1.0 - a * b * c, 1.0 - a]),
                ([1.0, a * (1.0 - b + b * c)], [1.0 - a * b, a * (1.0 - b)]),
                ([1.0 - a * b * c, a * (1.0 - b * c)], [1.0, a * (1.0 - b)]),
            ];
            regions.into_iter().flat_map(|(x, y)| [(j, x, y), (j, y, x)]).collect()
        }
    }
}
