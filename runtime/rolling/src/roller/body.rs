//! Compliance of a roller's body between two raceways, beyond that of half-spaces.

use libm::log2;

/// Compliance of cylinders with free ends, one row for each ratio of length to diameter.
///
/// After the ratio, a row has the lower triangles of the coefficients of even and of odd Legendre
/// polynomials for a load on the same line, then those for a load on the opposite line. They are
/// for Poisson's ratio 0.3; the theory manual states how they were computed, and tests compare them
/// with the plane disc and with an independent computation.
const TABLE: &str = include_str!("body.csv");
/// Number of Legendre polynomials.
const ORDERS: usize = 8;
/// Ratio of length to diameter of the first row.
const FIRST: f64 = 0.4;
/// Number of rows by which the ratio doubles.
const PER_DOUBLING: f64 = 2.0;

/// Symmetric kernel of a body: deflection at one position by a force at another.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct BodyCompliance {
    /// Coefficients of products of Legendre polynomials on the same and on the opposite line, by
    /// row.
    coefficients: [[[f64; ORDERS]; ORDERS]; 2],
    length: f64,
    /// Deflection per force of the coefficient one, m/N.
    unit: f64,
}

impl BodyCompliance {
    /// Compliance of a cylinder of this length and diameter, m, and plane strain modulus, Pa.
    /// Ratios beyond the table are those of its ends.
    pub fn new(length: f64, diameter: f64, plane_strain_modulus: f64) -> Self {
        let rows: Vec<Vec<f64>> = TABLE
            .lines()
            .map(|line| line.split(',').filter_map(|entry| entry.trim().parse().ok()).collect())
            .collect();
        let last = rows.len() - 1;
        let at = (PER_DOUBLING * log2(length / diameter / FIRST)).clamp(0.0, last as f64);
        let first = (at.floor() as usize).saturating_sub(1).min(last - 3);
        let points: Vec<f64> = (first..first + 4).map(|row| row as f64).collect();
        let weights = calyx_numerics::interpolation::lagrange(&points, at);
        let value = |column: usize| {
            weights.iter().zip(&rows[first..]).map(|(weight, row)| weight * row[column]).sum::<f64>()
        };
        let mut coefficients = [[[0.0; ORDERS]; ORDERS]; 2];
        let mut column = 1;
        for line in &mut coefficients {
            for parity in 0..2 {
                for i in (parity..ORDERS).step_by(2) {
                    for j in (parity..=i).step_by(2) {
                        (line[i][j], line[j][i]) = (value(column), value(column));
                        column += 1;
                    }
                }
            }
        }
        Self { coefficients, length, unit: 1.0 / (std::f64::consts::PI * plane_strain_modulus * length) }
    }

    /// Returns the deflection at a position by a force at another one, m/N; positions from the
    /// middle, m.
    pub fn deflection(&self, opposite: bool, position: f64, other: f64) -> f64 {
        let [own, others] = [position, other].map(|x| legendre(2.0 * x / self.length));
        let coefficients = &self.coefficients[usize::from(opposite)];
        let mut sum = 0.0;
        for i in 0..ORDERS {
            for j in 0..ORDERS {
                sum += own[i] * coefficients[i][j] * others[j];
            }
        }
        self.unit * sum
    }
}

/// Returns the first Legendre polynomials.
fn legendre(x: f64) -> [f64; ORDERS] {
    let mut values = [1.0; ORDERS];
    values[1] = x;
    for k in 2..ORDERS {
        let n = k as f64;
        values[k] = ((2.0 * n - 1.0) * x * values[k - 1] - (n - 1.0) * values[k - 2]) / n;
    }
    values
}
