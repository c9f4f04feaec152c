//! Elastic half-plane: closed form of the singular part of the Green's function of a surface.
//!
//! A normal line force of 1 N/m on the surface lowers it at distance x by `G(x) = -2 / (pi E')
//! ln(|x| / L)` (Johnson, Contact Mechanics, eq. 2.18 with 2.19); `L` sets the free constant of the
//! plane problem. Cells carry uniform pressure, and displacements are averages over a cell, so the
//! compliance between two cells is symmetric for any widths.

use std::f64::consts::PI;

/// Distance of the centres, in sums of the half-widths, beyond which a series replaces the closed
/// form, which is a difference of large terms. At this distance the series converges by a factor of
/// 36 per term.
const SERIES_FROM: f64 = 6.0;

/// Surface stiffness and reference length of one body, as [`crate::Structure`] gives them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HalfPlane {
    /// E', Pa; infinite for a rigid body.
    pub surface_modulus: f64,
    /// L, m.
    pub reference_length: f64,
}

impl HalfPlane {
    /// Returns the average normal displacement of the cell `observe` (its ends, m, in either order)
    /// under a force of 1 N/m distributed uniformly over the cell `load`, m/(N/m). Exchanging the
    /// cells gives the same bits.
    ///
    /// The relative accuracy for neighbouring cells is about 1e-15 times the ratio of their widths.
    pub fn cell_compliance(&self, observe: [f64; 2], load: [f64; 2]) -> f64 {
        if self.surface_modulus.is_infinite() {
            return 0.0;
        }
        -2.0 / (PI * self.surface_modulus) * (mean_log_distance(observe, load) - self.reference_length.ln())
    }
}

/// Returns the average of ln|x - y| for x and y in two intervals.
///
/// With `F'' = ln|x|` it is the second difference of F over the ends of the intervals. Far away,
/// the moments of the sum of two uniform variables give the series of `ln D + E[ln(1 + u/D)]`.
fn mean_log_distance(first: [f64; 2], second: [f64; 2]) -> f64 {
    let half = |cell: [f64; 2]| 0.5 * (cell[1] - cell[0]).abs();
    let distance = (0.5 * (first[0] + first[1]) - 0.5 * (second[0] + second[1])).abs();
    mean_log_apart(distance, half(first), half(second))
}

/// Returns the average of ln|x - y| from the distance of the centres and the half-widths.
pub fn mean_log_apart(distance: f64, a: f64, b: f64) -> f64 {
    let reach = a + b;
    if distance > SERIES_FROM * reach {
        return distance.ln() + far_series(a / distance, b / distance);
    }
    // Lengths in units of the largest argument: F is of order one, and its logarithm is separated
    // exactly.
    let unit = distance + reach;
    let (d, sum, difference) = (distance / unit, reach / unit, (a - b).abs() / unit);
    let corners = (second_integral_of_log(1.0) - second_integral_of_log(d + difference))
        + (second_integral_of_log(d - sum) - second_integral_of_log(d - difference));
    unit.ln() + corners / (4.0 * (a / unit) * (b / unit))
}

/// Second integral of the logarithm: F with F'' = ln|x|.
fn second_integral_of_log(x: f64) -> f64 {
    if x == 0.0 { 0.0 } else { x * x * (0.5 * x.abs().ln() - 0.75) }
}

/// Returns E[ln(1 + u)] for the sum u of variables uniform over ±a and ±b, a + b <= 1 /
/// SERIES_FROM: the sum over even n of -E[u^n] / n. With X = a + b and Y = a - b the moments are `2
/// (X^(n+2) - Y^(n+2)) / ((X² - Y²) (n+1) (n+2))`. The quotient of powers is a sum of positive
/// terms `X^(n-2j) Y^(2j)` with a recurrence, so cells of very different widths lose no digits.
fn far_series(a: f64, b: f64) -> f64 {
    let (x_squared, y_squared) = ((a + b) * (a + b), (a - b) * (a - b));
    let (mut quotient, mut x_power, mut y_power) = (1.0, 1.0, 1.0);
    let mut series = 0.0;
    let mut n = 0.0;
    while x_power > 1e-18 {
        n += 2.0;
        x_power *= x_squared;
        y_power *= y_squared;
        quotient = x_squared * quotient + y_power;
        series -= 2.0 * quotient / ((n + 1.0) * (n + 2.0) * n);
    }
    series
}

/// Returns the stresses `[sigma_x, sigma_z, tau_xz]` (tension positive, z into the body) at `(x,
/// z)`, z > 0, under a uniform `pressure` on the strip |x| < `half_width` (Johnson, eq. 2.23 with
/// figure 2.6).
pub fn strip_stress(pressure: f64, half_width: f64, x: f64, z: f64) -> [f64; 3] {
    // Angles of the strip's ends seen from the point, from the inward normal.
    let (from_left, from_right) = (((x + half_width) / z).atan(), ((x - half_width) / z).atan());
    let spread = from_left - from_right;
    let sines = (2.0 * from_left).sin() - (2.0 * from_right).sin();
    let cosines = (2.0 * from_left).cos() - (2.0 * from_right).cos();
    let scale = pressure / (2.0 * PI);
    [-scale * (2.0 * spread - sines), -scale * (2.0 * spread + sines), scale * cosines]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rows x, z, sigma_x, sigma_z, tau_xz for pressure 1000 and half-width 1, by Johnson's eq.
    /// 2.23.
    const STRESSES: [[f64; 5]; 6] = [
        [0.0, 0.5, -450.184855752101, -959.480673646166, 0.0],
        [0.0, 1.0, -181.690113816209, -818.309886183791, 0.0],
        [1.0, 0.5, -347.12442581468, -496.917313430581, -299.585775231803],
        [0.5, 0.25, -620.906151783642, -978.789699492985, -55.0590073398989],
        [2.0, 1.0, -211.245594887191, -83.9216404136751, -127.323954473516],
        [3.0, 0.2, -31.4632916924075, -0.183240656346937, -2.35779279166285],
    ];

    /// Rows x, displacement minus that at x = 0, of the same strip for E = 3e7, nu = 0.3, by
    /// Johnson's eq. 2.30a.
    const DISPLACEMENTS: [[f64; 2]; 4] = [
        [0.5, -5.05217006498971e-06],
        [1.0, -2.67704528185217e-05],
        [2.0, -6.36452457670229e-05],
        [5.0, -0.000100520038715524],
    ];

    #[test]
    fn stresses_under_a_strip() {
        for [x, z, expected @ ..] in STRESSES {
            let stress = strip_stress(1000.0, 1.0, x, z);
            for k in 0..3 {
                assert!((stress[k] - expected[k]).abs() < 1e-11 * 1000.0, "at {x}, {z}: {stress:?}");
            }
        }
    }

    #[test]
    fn displacement_of_a_strip() {
        // A very narrow cell observes the displacement at a point.
        let body = HalfPlane { surface_modulus: 3e7 / (1.0 - 0.09), reference_length: 0.7 };
        let at = |x: f64| 2000.0 * body.cell_compliance([x - 1e-4, x + 1e-4], [-1.0, 1.0]);
        for [x, expected] in DISPLACEMENTS {
            // The slope is infinite at the end of the strip, so averaging over h has an error of h
            // ln h.
            let tolerance = if x == 1.0 { 1e-4 } else { 1e-7 };
            assert!((at(x) - at(0.0) - expected).abs() < tolerance * expected.abs(), "at {x}");
        }
    }

    #[test]
    fn symmetric_bit_for_bit_and_smooth_across_the_switch() {
        let body = HalfPlane { surface_modulus: 1.0, reference_length: 1.0 };
        let cells =
            [[0.0, 1.0], [1.0, 1.25], [1.25, 1.26], [-30.0, -20.0], [6.0, 8.0], [900.0, 901.0], [40.0, 39.0]];
        for a in cells {
            for b in cells {
                assert_eq!(body.cell_compliance(a, b).to_bits(), body.cell_compliance(b, a).to_bits());
            }
        }
        // Both forms are exact, so they must agree on either side of the switch.
        for (a, b) in [(0.5, 0.5), (0.5, 0.05), (0.5, 0.002)] {
            let at = |d: f64| mean_log_distance([-a, a], [d - b, d + b]);
            let switch = SERIES_FROM * (a + b);
            let slope = (at(switch * (1.0 + 2e-6)) - at(switch * (1.0 + 1e-6))) / 1e-6;
            let jump = at(switch * (1.0 + 1e-9)) - at(switch * (1.0 - 1e-9));
            assert!((jump - slope * 2e-9).abs() < 1e-13 * a / b, "{a} {b}: {jump:e} {slope}");
        }
    }

    #[test]
    fn agrees_with_quadrature() {
        // Separate cells: a 4 x 4 Gauss product rule on sixteenths of the cells is exact to
        // rounding.
        let node = [
            -0.861_136_311_594_052_6,
            -0.339_981_043_584_856_3,
            0.339_981_043_584_856_3,
            0.861_136_311_594_052_6,
        ];
        let weight = [
            0.347_854_845_137_453_9,
            0.652_145_154_862_546_1,
            0.652_145_154_862_546_1,
            0.347_854_845_137_453_9,
        ];
        let points = |c: [f64; 2]| -> Vec<(f64, f64)> {
            let w = (c[1] - c[0]) / 16.0;
            (0..16)
                .flat_map(|k| (0..4).map(move |g| (k, g)))
                .map(|(k, g)| (c[0] + w * (f64::from(k) + 0.5 + 0.5 * node[g]), weight[g] / 32.0))
                .collect()
        };
        for (a, b) in [([0.0, 1.0], [1.5, 1.7]), ([0.0, 1.0], [5.0, 7.0]), ([0.0, 1.0], [12.0, 12.5])] {
            let mut expected = 0.0;
            for (x, wx) in points(a) {
                for (y, wy) in points(b) {
                    expected += wx * wy * (x - y).abs().ln();
                }
            }
            assert!((mean_log_distance(a, b) - expected).abs() < 1e-13, "{a:?} {b:?}");
        }
    }
}
