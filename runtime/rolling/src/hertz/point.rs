//! Hertz contact on an ellipse.

use super::elliptic::Elliptic;
use libm::{cbrt, exp, log};
use std::f64::consts::PI;

/// Point contact of two bodies whose undeformed gap is A x² + B y².
///
/// The load is Q = k δ^{3/2}. All lengths of the ellipse grow with Q^{1/3}.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointContact {
    /// Stiffness k, N/m^{3/2}.
    pub stiffness: f64,
    /// Semi-axis along x at unit load, m/N^{1/3}.
    pub unit_x: f64,
    /// Semi-axis along y at unit load, m/N^{1/3}.
    pub unit_y: f64,
}

/// Ellipse and pressure of a loaded contact.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Ellipse {
    /// Semi-axis along x, m.
    pub x: f64,
    /// Semi-axis along y, m.
    pub y: f64,
    /// Largest pressure, Pa.
    pub pressure: f64,
}

impl PointContact {
    /// Solves the contact of positive curvature coefficients A and B, 1/m, and composite modulus
    /// E*, Pa.
    ///
    /// Source: Johnson, Contact Mechanics (1985), section 4.2(b). The ratio of the semi-axes k'
    /// solves A/B = k'² D/(K-D) for A <= B, with the complete elliptic integrals of the
    /// complementary modulus k'. The relative error is about 1e-14.
    pub fn new(a: f64, b: f64, modulus: f64) -> Self {
        if a > b {
            let other = Self::new(b, a, modulus);
            return Self { unit_x: other.unit_y, unit_y: other.unit_x, ..other };
        }
        let (ratio, integrals) = axis_ratio(a / b);
        let Elliptic { first, difference, .. } = integrals;
        // Long semi-axis: A = 3Q D / (2π E* a³).
        let unit_x = cbrt(1.5 * difference / (PI * modulus * a));
        let approach = 1.5 * first / (PI * unit_x * modulus);
        Self { stiffness: 1.0 / (approach * approach.sqrt()), unit_x, unit_y: ratio * unit_x }
    }

    /// Returns the compliance c = k^{-2/3}, m/N^{2/3}: the approach is c Q^{2/3}.
    pub fn compliance(&self) -> f64 {
        1.0 / cbrt(self.stiffness * self.stiffness)
    }

    /// Returns the derivative of the compliance with respect to B.
    ///
    /// The approach is the derivative of the complementary energy with respect to the load, and the
    /// derivative of this energy with respect to B is the load times the mean of y², a fifth of the
    /// square of the semi-axis.
    pub fn compliance_by_b(&self) -> f64 {
        self.unit_y * self.unit_y / 3.0
    }

    /// Returns ellipse and pressure under a load, N.
    pub fn ellipse(&self, load: f64) -> Ellipse {
        if load <= 0.0 {
            return Ellipse::default();
        }
        let size = cbrt(load);
        let (x, y) = (self.unit_x * size, self.unit_y * size);
        Ellipse { x, y, pressure: 1.5 * load / (PI * x * y) }
    }

    /// Returns the load of a largest pressure, N.
    pub fn load_of_pressure(&self, pressure: f64) -> f64 {
        let root = pressure * PI * self.unit_x * self.unit_y / 1.5;
        root * root * root
    }
}

/// Returns the ratio of the short to the long semi-axis, with its elliptic integrals, from the
/// ratio A/B <= 1.
fn axis_ratio(curvatures: f64) -> (f64, Elliptic) {
    let target = log(curvatures);
    // The exponent 2/3 is exact near the circle; Newton's method on the logarithms corrects it.
    let mut ratio = exp(0.64 * target);
    let mut integrals = Elliptic::of_complementary_modulus(ratio);
    for _ in 0..30 {
        let Elliptic { first, difference: d, .. } = integrals;
        let rest = first - d;
        let residual = log(ratio * ratio * d / rest) - target;
        let square = ratio * ratio;
        let parameter = (1.0 - ratio) * (1.0 + ratio);
        let slope = if parameter < 1e-3 {
            1.5
        } else {
            // Derivatives with respect to m, and dm/dln k' = -2k'².
            let first_by = 0.5 * rest / square;
            let d_by = (rest / square - d) / (2.0 * parameter);
            2.0 - 2.0 * square * (d_by / d - (first_by - d_by) / rest)
        };
        let step = -residual / slope;
        ratio = (ratio * exp(step)).min(1.0);
        integrals = Elliptic::of_complementary_modulus(ratio);
        if step.abs() < 1e-15 || (step.abs() < 1e-9 && parameter >= 1e-3) {
            break;
        }
    }
    (ratio, integrals)
}
