//! Hertzian contact ellipse (Johnson, Contact Mechanics, eqs. 4.24 to 4.26).

use std::f64::consts::PI;

#[derive(Debug)]
pub struct Ellipse {
    /// Largest pressure, Pa.
    pub peak: f64,
}

/// Complete elliptic integrals K and E by the arithmetic-geometric mean, for the complementary
/// modulus.
fn elliptic(complement: f64) -> [f64; 2] {
    let (mut a, mut b, mut power) = (1.0, complement, 0.5);
    let mut sum = power * (1.0 - complement * complement);
    while f64::abs(a - b) > 1e-15 * a {
        let c: f64 = 0.5 * (a - b);
        (a, b) = (0.5 * (a + b), f64::sqrt(a * b));
        power *= 2.0;
        sum += power * c * c;
    }
    let k = PI / (2.0 * a);
    [k, k * (1.0 - sum)]
}

impl Ellipse {
    /// `radii` of the relative curvatures, ascending, m; contact modulus, Pa; force, N.
    pub fn new(radii: [f64; 2], modulus: f64, force: f64) -> Self {
        let curvatures = |ratio: f64| {
            let [k, e] = elliptic(ratio);
            (e / (ratio * ratio) - k) / (k - e)
        };
        let requested = radii[1] / radii[0];
        let (mut low, mut high) = (1e-6f64, 1.0 - 1e-7);
        for _ in 0..200 {
            let middle = (low * high).sqrt();
            if curvatures(middle) > requested { low = middle } else { high = middle }
        }
        let ratio = low;
        let [k, e] = elliptic(ratio);
        let shape = (k - e) / (1.0 - ratio * ratio);
        let a = (3.0 * force * shape * radii[1] / (PI * modulus)).cbrt();
        Ellipse { peak: 3.0 * force / (2.0 * PI * a * a * ratio) }
    }
}
