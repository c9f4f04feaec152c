//! Force of a bearing as a table over its deflection: stiffness that depends on the load.
//!
//! Between the points of the table the force is a monotone cubic (Fritsch and Butland, SIAM J. Sci.
//! Stat. Comput. 5, 1984), so it never decreases and its derivative is continuous. Beyond the last
//! point it continues with the last slope.

use super::BearingMatrix;
use super::nonlinear_state::NonlinearState;
use calyx_numerics::error::EngineError;
use calyx_rolling::{Displacement, Evaluation, Start};

/// Monotone force over a displacement.
#[derive(Clone, Debug, PartialEq)]
pub struct LoadCurve {
    displacements: Vec<f64>,
    forces: Vec<f64>,
    slopes: Vec<f64>,
}

impl LoadCurve {
    /// Creates a curve through points with ascending displacements (m) and forces (N) that do not
    /// decrease.
    ///
    /// # Errors
    /// E0996: there are fewer than two points, their numbers differ, one is not finite, or they do
    /// not ascend, or all forces are equal.
    pub fn new(displacements: Vec<f64>, forces: Vec<f64>) -> Result<LoadCurve, EngineError> {
        let refused = |message: String, help: &str| Err(EngineError::new("E0996", message, help));
        if displacements.len() != forces.len() || forces.len() < 2 {
            return refused(
                format!(
                    "a load curve of a bearing has {} displacements and {} forces",
                    displacements.len(),
                    forces.len()
                ),
                "give one force for each displacement, and two points or more",
            );
        }
        if !displacements.iter().chain(&forces).all(|value| value.is_finite()) {
            return refused(
                "a point of a load curve of a bearing is not a number".into(),
                "look for a division by zero",
            );
        }
        for k in 1..forces.len() {
            if displacements[k] <= displacements[k - 1] {
                return refused(
                    format!(
                        "the displacements of a load curve do not ascend: point {} is not beyond point {k}",
                        k + 1
                    ),
                    "sort the points by displacement, and leave out repeated ones",
                );
            }
            if forces[k] < forces[k - 1] {
                return refused(
                    format!(
                        "the force of a load curve decreases from {:.6} N to {:.6} N between points {k} and {}",
                        forces[k - 1],
                        forces[k],
                        k + 1
                    ),
                    "a bearing pushes back more strongly the farther it is deflected; check the order and the signs of the forces",
                );
            }
        }
        if forces[0] == forces[forces.len() - 1] {
            return refused(
                "the force of a load curve is constant".into(),
                "give forces that increase with the displacement",
            );
        }
        let slopes = monotone_slopes(&displacements, &forces);
        Ok(LoadCurve { displacements, forces, slopes })
    }

    /// Returns the curve of a bearing that is equal on both sides of zero from its positive side,
    /// whose first point is without displacement and force.
    ///
    /// # Errors
    /// E0996: the first point is another one.
    pub fn mirrored(&self) -> Result<LoadCurve, EngineError> {
        if (self.displacements[0], self.forces[0]) != (0.0, 0.0) {
            return Err(EngineError::new(
                "E0996",
                "a load curve for both sides starts with another point than zero displacement and zero force",
                "start with (0, 0); a clearance is a second point with zero force",
            ));
        }
        let both = |values: &[f64]| -> Vec<f64> {
            let negative = values.iter().skip(1).rev().map(|value| -value);
            negative.chain(values.iter().copied()).collect()
        };
        // The slope at zero is that of the positive side.
        let slopes = self.slopes.iter().skip(1).rev().chain(&self.slopes).copied().collect();
        Ok(LoadCurve { displacements: both(&self.displacements), forces: both(&self.forces), slopes })
    }

    /// Returns the force at a displacement and its derivative.
    pub fn at(&self, x: f64) -> [f64; 2] {
        let last = self.displacements.len() - 1;
        let beyond =
            |k: usize| [self.forces[k] + self.slopes[k] * (x - self.displacements[k]), self.slopes[k]];
        if x <= self.displacements[0] {
            return beyond(0);
        }
        if x >= self.displacements[last] {
            return beyond(last);
        }
        let k = self.displacements.partition_point(|&known| known <= x) - 1;
        let width = self.displacements[k + 1] - self.displacements[k];
        let t = (x - self.displacements[k]) / width;
        let rise = self.forces[k + 1] - self.forces[k];
        let [start, end] = [width * self.slopes[k], width * self.slopes[k + 1]];
        // Hermite's cubic about the start, so that rounding is relative to the rise.
        let [second, third] = [3.0 * rise - 2.0 * start - end, start + end - 2.0 * rise];
        let force = self.forces[k] + t * (start + t * (second + t * third));
        [force, (start + t * (2.0 * second + 3.0 * t * third)) / width]
    }

    /// Returns whether a displacement is within the points.
    fn contains(&self, x: f64) -> bool {
        (self.displacements[0]..=self.displacements[self.displacements.len() - 1]).contains(&x)
    }

    /// Returns the largest displacement of a point, m.
    fn reach(&self) -> f64 {
        self.displacements.iter().fold(0.0, |most: f64, x| most.max(x.abs()))
    }

    /// Returns the largest force of a point, N.
    fn largest_force(&self) -> f64 {
        self.forces.iter().fold(0.0, |most: f64, force| most.max(force.abs()))
    }

    /// Returns the mean stiffness over all points, N/m.
    fn mean_stiffness(&self) -> f64 {
        let last = self.forces.len() - 1;
        (self.forces[last] - self.forces[0]) / (self.displacements[last] - self.displacements[0])
    }
}

/// Returns the slopes at the points of a monotone cubic interpolation: weighted harmonic means of
/// the slopes on both sides, and at the ends a quadratic estimate within the bounds of monotony.
fn monotone_slopes(x: &[f64], y: &[f64]) -> Vec<f64> {
    let widths: Vec<f64> = x.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let secants: Vec<f64> =
        y.windows(2).zip(&widths).map(|(pair, width)| (pair[1] - pair[0]) / width).collect();
    let last = secants.len() - 1;
    let at_end = |near: usize, next: Option<usize>| {
        let Some(next) = next else { return secants[near] };
        let [h, g] = [widths[near], widths[next]];
        (((2.0 * h + g) * secants[near] - h * secants[next]) / (h + g)).clamp(0.0, 3.0 * secants[near])
    };
    let inner = |k: usize| {
        let [before, after] = [secants[k - 1], secants[k]];
        if before == 0.0 || after == 0.0 {
            return 0.0;
        }
        let [first, second] = [2.0 * widths[k] + widths[k - 1], widths[k] + 2.0 * widths[k - 1]];
        (first + second) / (first / before + second / after)
    };
    (0..x.len())
        .map(|k| match k {
            0 => at_end(0, (last > 0).then_some(1)),
            k if k == last + 1 => at_end(last, last.checked_sub(1)),
            k => inner(k),
        })
        .collect()
}

/// Load curves of a bearing: across its axis, equal in all directions, and along it.
#[derive(Clone, Debug, PartialEq)]
pub struct LoadCurves {
    /// Radial force over the radial displacement, both not negative.
    pub radial: Option<LoadCurve>,
    /// Axial force over the axial displacement.
    pub axial: Option<LoadCurve>,
    /// Deflection at which the displacements of the curves are zero, m.
    pub origin: [f64; 3],
}

impl LoadCurves {
    /// Returns the mean stiffness of the curves.
    pub fn typical_stiffness(&self) -> BearingMatrix {
        let of = |curve: &Option<LoadCurve>| curve.as_ref().map_or(0.0, LoadCurve::mean_stiffness);
        super::axisymmetric(of(&self.radial), of(&self.axial), 0.0, 0.0)
    }

    /// Returns a length of the order of the deflections under load, m.
    pub fn reach(&self) -> f64 {
        [&self.radial, &self.axial].into_iter().flatten().map(LoadCurve::reach).fold(0.0, f64::max)
    }

    /// Returns whether displacements to +z and to -z are resisted, however long they are.
    pub fn axial_supports(&self) -> [bool; 2] {
        let Some(curve) = &self.axial else { return [false; 2] };
        [curve.slopes[curve.slopes.len() - 1] > 0.0, curve.slopes[0] > 0.0]
    }

    /// Returns the largest force of a point, N.
    pub fn largest_force(&self) -> f64 {
        [&self.radial, &self.axial].into_iter().flatten().map(LoadCurve::largest_force).fold(0.0, f64::max)
    }

    /// Returns whether the curves carry load without deflection.
    pub fn is_preloaded(&self) -> bool {
        self.state([0.0; 5]).is_ok_and(|state| state.evaluation.scale > 0.0)
    }

    /// Returns a warning if a deflection is beyond the points of a curve, as the end of a sentence
    /// about the bearing.
    pub fn warnings(&self, deflection: &Displacement) -> Vec<&'static str> {
        let [x, y, z] = self.relative(deflection);
        let mut found = Vec::new();
        if self.radial.as_ref().is_some_and(|curve| !curve.contains(x.hypot(y))) {
            found.push("is deflected beyond the last point of its radial load curve, which is extrapolated by its last slope");
        }
        if self.axial.as_ref().is_some_and(|curve| !curve.contains(z)) {
            found.push("is deflected beyond the points of its axial load curve, which is extrapolated by its last slope");
        }
        found
    }

    fn relative(&self, deflection: &Displacement) -> [f64; 3] {
        std::array::from_fn(|k| deflection[k] - self.origin[k])
    }

    /// Returns the force that opposes a deflection, and its derivatives.
    ///
    /// # Errors
    /// E0697: the deflection is not finite.
    pub fn state(&self, deflection: Displacement) -> Result<NonlinearState, EngineError> {
        if !deflection.iter().all(|part| part.is_finite()) {
            return Err(EngineError::new(
                "E0697",
                "the deflection of a bearing with load curves is not finite",
                "look for a division by zero in the loads and frames of its bodies",
            ));
        }
        let [x, y, z] = self.relative(&deflection);
        let mut evaluation =
            Evaluation { load: [0.0; 5], stiffness: [[0.0; 5]; 5], scale: 0.0, unconverged: 0 };
        if let Some(curve) = &self.radial {
            let r = x.hypot(y);
            let [force, along] = curve.at(r);
            // Without displacement, all directions have the first slope.
            let (unit, across) = if r > 0.0 { ([x / r, y / r], force / r) } else { ([1.0, 0.0], along) };
            for i in 0..2 {
                evaluation.load[i] = if r > 0.0 { force * unit[i] } else { 0.0 };
                for j in 0..2 {
                    let identity = f64::from(i == j);
                    let outer = unit[i] * unit[j];
                    evaluation.stiffness[i][j] = along * outer + across * (identity - outer);
                }
            }
            evaluation.scale += evaluation.load[0].hypot(evaluation.load[1]);
        }
        if let Some(curve) = &self.axial {
            let [force, along] = curve.at(z);
            evaluation.load[2] = force;
            evaluation.stiffness[2][2] = along;
            evaluation.scale += force.abs();
        }
        Ok(NonlinearState {
            deflection,
            evaluation,
            raceway: Vec::new(),
            raceway_loads: Vec::new(),
            start: Start::default(),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn hertzian(points: usize) -> LoadCurve {
        let x: Vec<f64> = (0..=points).map(|k| 1e-5 * k as f64 / points as f64).collect();
        let f = x.iter().map(|x| 1e11 * x.powf(1.5)).collect();
        LoadCurve::new(x, f).expect("a curve")
    }

    /// Points are exact, and between them the error of a smooth curve falls with the third power of
    /// the distance or faster.
    #[test]
    fn a_smooth_curve_converges() {
        let error = |points: usize| {
            let curve = hertzian(points);
            (20..=100)
                .map(|k| {
                    let x = 1e-7 * f64::from(k);
                    (curve.at(x)[0] / (1e11 * x.powf(1.5)) - 1.0).abs()
                })
                .fold(0.0, f64::max)
        };
        let [coarse, fine] = [error(10), error(20)];
        assert!(coarse < 3e-3 && fine < coarse / 6.0, "{coarse:e} {fine:e}");
        assert_eq!(hertzian(4).at(5e-6)[0], 1e11 * 5e-6_f64.powf(1.5));
    }

    /// Derivatives are those of differences, also beyond the points; forces never decrease, also
    /// with a clearance and a sharp bend.
    #[test]
    fn curves_are_monotone_and_smooth() {
        let bent = LoadCurve::new(vec![0.0, 1e-5, 2e-5, 2.1e-5, 5e-5], vec![0.0, 0.0, 100.0, 5000.0, 5100.0]);
        for curve in [hertzian(5), bent.expect("a curve")] {
            let curve = curve.mirrored().expect("both sides");
            let mut before = f64::NEG_INFINITY;
            for k in -700..700 {
                let x = 1e-7 * f64::from(k) + 3e-9;
                let [force, slope] = curve.at(x);
                assert!(force >= before && slope >= 0.0, "{x:e}");
                before = force;
                let step = 1e-11;
                let difference = (curve.at(x + step)[0] - curve.at(x - step)[0]) / (2.0 * step);
                assert!((slope - difference).abs() < 1e-5 * (slope + 1e7), "{x:e}: {slope:e} {difference:e}");
                // Rounding is relative to the rise between two points.
                assert!((curve.at(-x)[0] + force).abs() <= 1e-14 * curve.largest_force());
            }
        }
    }

    /// A deflection that is not finite is an error, and one sense may be without support.
    #[test]
    fn invalid_deflections_and_one_sided_curves() {
        let axial = LoadCurve::new(vec![-1e-5, 0.0, 2e-5], vec![0.0, 0.0, 4e3]).expect("a curve");
        let curves = LoadCurves { radial: Some(hertzian(4)), axial: Some(axial), origin: [0.0; 3] };
        assert_eq!(curves.axial_supports(), [true, false]);
        for deflection in [[f64::NAN, 0.0, 0.0, 0.0, 0.0], [0.0, 0.0, f64::INFINITY, 0.0, 0.0]] {
            assert_eq!(curves.state(deflection).expect_err("not finite").code, "E0697");
        }
    }

    #[test]
    fn impossible_curves_are_refused() {
        for (x, f, text) in [
            (vec![0.0], vec![0.0], "1 displacements and 1 forces"),
            (vec![0.0, 1.0, 2.0], vec![0.0, 1.0], "3 displacements and 2 forces"),
            (vec![0.0, 1.0, 1.0], vec![0.0, 1.0, 2.0], "point 3 is not beyond point 2"),
            (vec![0.0, 1.0, 2.0], vec![0.0, 3.0, 2.0], "decreases from 3"),
            (vec![0.0, 1.0], vec![2.0, 2.0], "is constant"),
            (vec![0.0, f64::NAN], vec![0.0, 2.0], "is not a number"),
        ] {
            let error = LoadCurve::new(x, f).expect_err(text);
            assert!(error.code == "E0996" && error.message.contains(text), "{}", error.message);
        }
        let shifted = LoadCurve::new(vec![1.0, 2.0], vec![0.0, 1.0]).expect("a curve");
        assert_eq!(shifted.mirrored().expect_err("no zero").code, "E0996");
    }
}
