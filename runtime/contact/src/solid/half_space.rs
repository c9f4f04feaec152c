//! Elastic half-space: closed form of the singular part of the Green's function of a surface.
//!
//! A normal force of 1 N lowers the surface at distance r by `1 / (pi E' r)` (Johnson, Contact
//! Mechanics, eq. 3.22a). Cells carry uniform pressure, and displacements are averages over a cell.
//! For coplanar rectangles with parallel sides the average of 1/r is a second difference, in both
//! directions, of
//!
//! ```text
//! F(x, y) = x² y asinh(y / x) / 2 + x y² asinh(x / y) / 2 - r³ / 6,   F_xxyy = 1 / r
//! ```
//!
//! in which all digits may cancel. It is therefore evaluated in steps. Along the longer direction
//! the second difference of `F_xx = H = y asinh(y / x) - r` is used. Across it, H is averaged: near
//! its singular point H behaves as `-y ln x`, whose average is known in closed form as for the
//! half-plane, and the Gauss rule for the distribution of `x - x'` integrates the remainder to
//! rounding. For distant rectangles this rule suffices in both directions.

use super::close_strips::CloseStrips;
use super::grid::Cell;
use super::interval_averages::{Rule, SHORT_RULE_FROM, Sides};
use super::strips::{Strip, StripInfluence, StripPoints};
use calyx_structure::half_plane::mean_log_apart;
use std::cell::OnceCell;

/// Distance from a singular point, in sums of both half-sizes, beyond which the Gauss rule of five
/// points is exact to about 1e-12.
const RULE_FROM: f64 = 7.0;

/// Half-spaces of both bodies of a patch.
pub struct HalfSpace {
    /// Surface displacement per 1/r, `1 / (pi E')`, summed over the bodies, m²/N.
    pub softness: f64,
}

impl HalfSpace {
    /// Returns the displacement of a cell by a force of 1 N on another, m/N. `close` are their
    /// strips, if known.
    pub fn influence(&self, first: &Cell, second: &Cell, close: Option<&CloseStrips>) -> f64 {
        if let Some(mean) = close.and_then(|close| close.mean_inverse_distance(first, second)) {
            return self.softness * mean;
        }
        let offset = [0, 1].map(|k| first.center[k] - second.center[k]);
        let halves = [first, second].map(|cell| cell.size.map(|size| 0.5 * size));
        self.softness * mean_inverse_distance(offset, halves[0], halves[1])
    }
}

impl StripInfluence for HalfSpace {
    type Close = CloseStrips;

    fn close(&self, observe: &Strip, load: &Strip) -> Option<CloseStrips> {
        CloseStrips::new(observe, load)
    }

    fn distance(&self, observe: &Strip, load: &Strip) -> f64 {
        let gap =
            |k: usize| ((observe.center[k] - load.center[k]).abs() - observe.half[k] - load.half[k]).max(0.0);
        gap(0).hypot(gap(1))
    }

    fn between_lines(&self, observe: &StripPoints, load: &StripPoints) -> Vec<f64> {
        let in_plane = |[x, y]: [f64; 2]| [x, y, 0.0];
        let mut means = observe.mean_inverse_distances(load, in_plane, in_plane);
        means.iter_mut().for_each(|mean| *mean *= self.softness);
        means
    }
}

/// Returns the average of 1/r between the points of two coplanar rectangles with parallel sides,
/// 1/m: `offset` between their centres, `first` and `second` their half-sizes. Exchanging the
/// rectangles gives the same bits.
pub fn mean_inverse_distance(offset: [f64; 2], first: [f64; 2], second: [f64; 2]) -> f64 {
    let [x, y] = [0, 1].map(|k| Sides::new(offset[k], first[k], second[k]));
    // The longer direction is integrated exactly.
    let (x, y) = if x.sum > y.sum { (y, x) } else { (x, y) };
    let square = |a: f64, b: f64| a * a + b * b;
    let apart = square(x.distance, y.distance);
    if apart > RULE_FROM * RULE_FROM * square(x.sum, y.sum) {
        return far(&x, &y, apart.sqrt());
    }
    // Scale by the largest length, so that the functions are of order one.
    let unit = (x.distance + x.sum).max(y.distance + y.sum);
    let (x, y) = (x.scaled(unit.recip()), y.scaled(unit.recip()));
    let across = Across::new(x);
    y.second_difference(|y| across.mean(y)) / unit
}

/// Returns the potential of a uniform rectangle, `∬ dA / r`, m, at a point `at` in the coordinates
/// of the rectangle: from its centre, along its sides of half-lengths `half`, and above its plane
/// (Love 1929; in the plane Johnson's eq. 3.25).
///
/// With the corners at `u_i`, `v_j` from the foot of the point, it is the second difference of
/// `u asinh(v / a) + v asinh(u / b) - z atan(u v / (z r))`, `a² = u² + z²`, `b² = v² + z²`. The
/// terms of the two corners of a side have one logarithm and one angle in common.
pub fn rectangle_potential(half: [f64; 2], [x, y, z]: [f64; 3]) -> f64 {
    let z = z.abs();
    let (u, v) = ([x + half[0], x - half[0]], [y + half[1], y - half[1]]);
    let r = u.map(|u| v.map(|v| (u * u + v * v + z * z).sqrt()));
    let along_v = |i: usize| u[i] * log_ratio(v, r[i], u[i] * u[i] + z * z);
    let along_u = |j: usize| v[j] * log_ratio(u, [r[0][j], r[1][j]], v[j] * v[j] + z * z);
    let angle =
        if z > 0.0 { z * (angle_between(u[0], v, r[0], z) - angle_between(u[1], v, r[1], z)) } else { 0.0 };
    along_v(0) - along_v(1) + along_u(0) - along_u(1) - angle
}

/// Returns `asinh(s_0 / a) - asinh(s_1 / a)` for points at `s` along a side, `r` from the observer,
/// with the square of `a`, the distance of the observer from the line of the side. For `a = 0` the
/// result is 0: there its factor vanishes.
fn log_ratio(s: [f64; 2], r: [f64; 2], square: f64) -> f64 {
    if square == 0.0 {
        return 0.0;
    }
    // (s_0 + r_0) / (s_1 + r_1) without cancellation; s_0 is the larger one.
    let ratio = match (s[0] >= 0.0, s[1] >= 0.0) {
        (true, true) => (s[0] + r[0]) / (s[1] + r[1]),
        (false, false) => (r[1] - s[1]) / (r[0] - s[0]),
        _ => (s[0] + r[0]) * (r[1] - s[1]) / square,
    };
    ratio.ln()
}

/// Returns `atan(u v_0 / (z r_0)) - atan(u v_1 / (z r_1))`, between -π and π.
fn angle_between(u: f64, v: [f64; 2], r: [f64; 2], z: f64) -> f64 {
    let [one, other] = [0, 1].map(|k| [z * r[k], u * v[k]]);
    (one[1] * other[0] - one[0] * other[1]).atan2(one[0] * other[0] + one[1] * other[1])
}

/// Returns the average of 1/r for intervals that are `reach` apart.
fn far(x: &Sides, y: &Sides, reach: f64) -> f64 {
    let rules = [x, y].map(|sides| sides.rule(reach));
    y.average(&rules[1], |y| {
        let square = y * y;
        x.average(&rules[0], |x| (x * x + square).sqrt().recip())
    })
}

/// Average of `H(x, y) = y asinh(y / x) - r` over x - x'.
struct Across {
    x: Sides,
    rule: OnceCell<Rule>,
    /// Average of ln|x - x'|.
    log: OnceCell<f64>,
}

impl Across {
    fn new(x: Sides) -> Self {
        Self { x, rule: OnceCell::new(), log: OnceCell::new() }
    }

    fn mean(&self, y: f64) -> f64 {
        let x = &self.x;
        let apart = x.distance * x.distance + y * y;
        if apart <= RULE_FROM * RULE_FROM * x.sum * x.sum {
            return x.second_difference(|x| fourth_integral(x, y));
        }
        let smooth = |x: f64| {
            let r = (x * x + y * y).sqrt();
            y * (y + r).ln() - r
        };
        let log = self.log.get_or_init(|| mean_log_apart(x.distance, x.halves[0], x.halves[1]));
        let average = if apart > SHORT_RULE_FROM * SHORT_RULE_FROM * x.sum * x.sum {
            x.average(&x.rule(f64::INFINITY), smooth)
        } else {
            x.average(self.rule.get_or_init(|| x.rule(0.0)), smooth)
        };
        average - y * log
    }
}

/// Returns F, even in both arguments.
fn fourth_integral(x: f64, y: f64) -> f64 {
    let r = (x * x + y * y).sqrt();
    let part = |a: f64, b: f64| if a == 0.0 || b == 0.0 { 0.0 } else { a * a * b * ((b + r) / a).ln() };
    0.5 * (part(x, y) + part(y, x)) - r * r * r / 6.0
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns nodes and weights of the double-exponential rule on 0 .. 1, as distances from the
    /// nearer end: it converges for endpoint singularities.
    fn double_exponential() -> Vec<(f64, bool, f64)> {
        let step = 1.0 / 12.0;
        (-48..=48)
            .map(|k| {
                let t = step * f64::from(k);
                let decay = (std::f64::consts::PI * t.abs().sinh()).exp();
                let weight = step * std::f64::consts::PI * t.cosh() * decay / (1.0 + decay).powi(2);
                ((1.0 + decay).recip(), t > 0.0, weight)
            })
            .filter(|(_, _, weight)| *weight > 1e-18)
            .collect()
    }

    /// Returns the average of the potential of the second rectangle over the first, split at the
    /// sides of the second.
    fn by_quadrature(offset: [f64; 2], first: [f64; 2], second: [f64; 2]) -> f64 {
        let rule = double_exponential();
        let pieces = |k: usize| -> Vec<[f64; 2]> {
            let (low, high) = (offset[k] - first[k], offset[k] + first[k]);
            let mut stops = vec![low, high];
            stops.extend([-second[k], 0.0, second[k]].into_iter().filter(|&s| s > low && s < high));
            stops.sort_by(f64::total_cmp);
            stops.windows(2).map(|stop| [stop[0], stop[1]]).collect()
        };
        // Keep distances to the sides from ends that are sides, to avoid cancellation.
        let at = |[low, high]: [f64; 2], (from_end, upper, _): (f64, bool, f64)| {
            let length = high - low;
            if upper { high - length * from_end } else { low + length * from_end }
        };
        let mut sum = 0.0;
        for x in pieces(0) {
            for y in pieces(1) {
                let area = (x[1] - x[0]) * (y[1] - y[0]);
                for &u in &rule {
                    for &v in &rule {
                        sum += area * u.2 * v.2 * rectangle_potential(second, [at(x, u), at(y, v), 0.0]);
                    }
                }
            }
        }
        sum / (16.0 * first[0] * first[1] * second[0] * second[1])
    }

    #[test]
    fn agrees_with_quadrature() {
        // The potential itself cancels at large distances: there the other forms are compared with
        // one another below.
        for aspect in [1.0, 30.0, 1000.0] {
            let whole = [1.0, aspect];
            for (offset, first, second) in [
                ([0.0, 0.0], whole, whole),
                ([2.0, 0.0], whole, whole),
                ([0.0, 2.0 * aspect], whole, whole),
                ([2.0, 2.0 * aspect], whole, whole),
                ([0.3, 0.7 * aspect], whole, [0.4, 0.6 * aspect]),
                ([1.1, aspect], whole, [0.1, 0.4 * aspect]),
                ([9.0, 0.5 * aspect], whole, [0.7, aspect]),
                ([0.0, 0.0], [aspect, 1.0], [1.0, 0.5]),
            ] {
                let closed = mean_inverse_distance(offset, first, second);
                let expected = by_quadrature(offset, first, second);
                assert!(
                    (closed / expected - 1.0).abs() < 1e-10,
                    "{offset:?} {first:?} {second:?}: {closed:e} {expected:e}"
                );
            }
        }
    }

    /// Offset, half-sizes of both, average of 1/r: the sixteen corners of F in sixty digits.
    #[rustfmt::skip]
    const FAR: [[f64; 7]; 27] = [
        [37.9292577188548, 0.0, 3.3870762926611557, 0.29224633725791677, 1.3215248013557979, 0.109267653750336, 0.02644583645390121],
        [0.04335131185689678, 9.92523129181455, 0.09710243901784266, 0.8543405106818679, 0.02108709738439618, 0.5547316012236422, 0.10110725822435465],
        [20.403899531274604, 4626.725929492336, 0.5976768576769277, 468.14303973241385, 0.5679766219820714, 189.86871107339527, 0.00021699954053601225],
        [0.0005894129241789997, 0.10984393218640462, 0.001364112185299397, 0.009380576448225224, 0.0010630816630445342, 0.006078189032025599, 9.134983133173352],
        [0.0020343176648094435, 0.5420337990934223, 0.005075626587601436, 0.05402729787573875, 0.003812463873445668, 0.021312062966415725, 1.8519642382176027],
        [0.0, 12000.0, 1.0, 2.0, 1.0, 2.0, 8.333333468364203e-05],
        [0.0, 18000.0, 1.0, 300.0, 1.0, 300.0, 5.556584813937698e-05],
        [10.0, 600.0, 1.0, 300.0, 1.0, 300.0, 0.0022828875847706155],
        [0.0, 4.0, 1.0, 2.0, 1.0, 2.0, 0.30875480655513843],
        [30000.0, 6000.0, 1.0, 5.0, 1.0, 5.0, 3.268602228753802e-05],
        [200.0, 1800.0, 1.0, 300.0, 1.0, 300.0, 0.0005625142673436154],
        [0.0, 6000.0, 1.0, 30.0, 1.0, 30.0, 0.00016666944301219733],
        [1800000.0, 6000.0, 1.0, 300.0, 1.0, 300.0, 5.555524640178611e-07],
        [27.1, 600.0, 1.0, 300.0, 0.1, 300.0, 0.0022364880186971302],
        [26.0, 1.4, 1.0, 1.0, 1.0, 0.4, 0.03843268112121545],
        [60000.0, 200.0, 1.0, 300.0, 1.0, 300.0, 1.6666435200153133e-05],
        [4.0, 2.0, 1.0, 1.0, 1.0, 1.0, 0.22764746383096274],
        [60.0, 42.0, 1.0, 30.0, 1.0, 12.0, 0.01360811997522421],
        [2.0, 10.0, 1.0, 5.0, 1.0, 5.0, 0.12036062976512049],
        [0.0, 0.0, 0.47182470739208016, 36.58610542349725, 0.25654737188959115, 16.533598336734364, 0.16281483376397735],
        [0.02623717414866879, 21.944139020585943, 0.14470857424209216, 13.146220143842086, 0.09992542148418676, 5.639494887131217, 0.055458357529621784],
        [555.2362110637404, 0.0, 189.41615308939302, 0.20895028277077915, 205.61978612458884, 0.16299958309241827, 0.0019964997932181375],
        [0.0, 0.0, 0.014420228257663792, 1.3845563680744335, 0.011945963763940692, 1.0091447886581075, 4.351761005352075],
        [0.0, 0.0, 0.0020056449012801933, 0.7929190388745654, 0.0005794383338037261, 0.40787193248654036, 9.598393801475922],
        [0.30837136528710957, 0.0, 6.112892815059127, 0.1089726545254339, 4.66609944598145, 0.07681052814152045, 0.9010636318009144],
        [0.0, 0.0, 0.048069088552845654, 5.047572175966642, 0.035734897406912165, 3.0632349947200606, 1.2241983579860205],
        [61.90883715706241, 19.14663714062105, 0.061335816635475715, 0.9352352947384234, 0.019858569274180723, 0.9765450699732351, 0.01543080297587484],
    ];

    #[test]
    fn agrees_with_sixty_digits_where_corners_cancel() {
        for [x, y, a, b, c, d, expected] in FAR {
            let found = mean_inverse_distance([x, y], [a, b], [c, d]);
            assert!((found / expected - 1.0).abs() < 1e-11, "{x} {y}: {found:e} {expected:e}");
            // From the other side, rotated by a right angle, and in other units.
            assert_eq!(found.to_bits(), mean_inverse_distance([-x, y], [c, d], [a, b]).to_bits());
            assert_eq!(found.to_bits(), mean_inverse_distance([y, x], [b, a], [d, c]).to_bits());
            let large = mean_inverse_distance([8.0 * x, 8.0 * y], [8.0 * a, 8.0 * b], [8.0 * c, 8.0 * d]);
            assert_eq!(found, 8.0 * large);
        }
    }

    /// Half-sides, point on the surface, displacement for a pressure of 1000 on E = 3e7, nu = 0.3
    /// (Johnson, eq. 3.25).
    const LOVE: [[f64; 5]; 9] = [
        [1.0, 1.0, 0.0, 0.0, 6.80801154171539e-05],
        [1.0, 1.0, 1.0, 1.0, 3.40400577085769e-05],
        [1.0, 1.0, 0.0, 1.5, 2.74076227374601e-05],
        [1.0, 3.0, 0.0, 0.0, 0.000108171256602881],
        [1.0, 3.0, 1.0, 3.0, 5.40856283014403e-05],
        [1.0, 3.0, 0.0, 4.5, 3.04539983744015e-05],
        [1.0, 20.0, 0.0, 0.0, 0.000181100066136464],
        [1.0, 20.0, 1.0, 20.0, 9.05500330682318e-05],
        [1.0, 20.0, 0.0, 30.0, 3.10641206231555e-05],
    ];

    #[test]
    fn the_potential_is_love_s() {
        let softness = 1000.0 * (1.0 - 0.09) / (std::f64::consts::PI * 3e7);
        for [a, b, x, y, expected] in LOVE {
            let found = softness * rectangle_potential([a, b], [x, y, 0.0]);
            assert!((found / expected - 1.0).abs() < 1e-12, "{a} {b} {x} {y}: {found:e}");
        }
    }

    #[test]
    fn the_potential_above_the_plane() {
        // Composite Gauss rule, far enough above the plane.
        let (half, at) = ([0.7, 1.9], [0.4, -1.1, 0.35]);
        let (mut sum, pieces) = (0.0, 400);
        for i in 0..pieces {
            for j in 0..pieces {
                let middle =
                    |k: i32, half: f64| half * ((2.0 * f64::from(k) + 1.0) / f64::from(pieces) - 1.0);
                let (u, v) = (middle(i, half[0]) - at[0], middle(j, half[1]) - at[1]);
                sum += 4.0 * half[0] * half[1]
                    / f64::from(pieces * pieces)
                    / (u * u + v * v + at[2] * at[2]).sqrt();
            }
        }
        assert!((rectangle_potential(half, at) / sum - 1.0).abs() < 1e-5);
        assert_eq!(rectangle_potential(half, at), rectangle_potential(half, [at[0], at[1], -at[2]]));
    }
}
