//! Displacement of the inner ring under a load.

use crate::ball::Motion;
use crate::bearing::{Displacement, Evaluation, Load, RollingBearing, Start};
use crate::error::{RollingError, finite};
use crate::linear::{dot, solve};

/// Largest number of steps of Newton's method.
const STEPS: usize = 200;
/// Residual relative to the loads of the elements.
const TOLERANCE: f64 = 1e-13;
/// Residual at which rounding may stop the iteration.
const STALLED: f64 = 1e-10;

/// Displacement of the inner ring that balances a load.
#[derive(Clone, Debug, PartialEq)]
pub struct Equilibrium {
    /// Displacement of the inner ring.
    pub displacement: Displacement,
    /// Load and stiffness there.
    pub evaluation: Evaluation,
    /// Number of evaluations. Elastic contacts start from the equilibrium of laminae, whose
    /// evaluations do not count.
    pub evaluations: usize,
}

/// Condition on a displacement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Conditions {
    /// Load on the inner ring, N and N m; not used for prescribed components.
    pub load: Load,
    /// Components of the displacement that keep their value in `start`.
    pub prescribed: [bool; 5],
    /// First displacement. Where the load leaves the ring free, as within a clearance, the result
    /// is near it.
    pub start: Displacement,
}

/// Evaluation scaled to forces: moments divided by the radius of the bearing.
struct Point {
    evaluation: Evaluation,
    residual: [f64; 5],
    size: f64,
}

impl RollingBearing {
    /// Computes the displacement of the inner ring under a load, from zero displacement.
    ///
    /// # Errors
    /// See [`RollingBearing::equilibrium`].
    pub fn displacement(&self, load: &Load, motion: &Motion) -> Result<Equilibrium, RollingError> {
        self.equilibrium(&Conditions { load: *load, prescribed: [false; 5], start: [0.0; 5] }, motion)
    }

    /// Computes the displacement of the inner ring under a load with prescribed components.
    ///
    /// Newton's method with a line search for the zero of the residual's component along the step.
    /// The potential energy is convex (nearly so for balls, whose stiffness depends on the contact
    /// angle), so that the search finds each opening or closing clearance.
    ///
    /// # Errors
    /// [`RollingError::Input`] if a value is not finite; [`RollingError::Equilibrium`] if the
    /// bearing cannot carry the load.
    pub fn equilibrium(&self, conditions: &Conditions, motion: &Motion) -> Result<Equilibrium, RollingError> {
        for value in conditions.load {
            finite("load", value)?;
        }
        // Elastic contacts change as laminae do, and an evaluation takes much longer.
        let laminae = self.laminae().and_then(|bearing| bearing.equilibrium(conditions, motion).ok());
        if let Some(Equilibrium { displacement: start, .. }) = laminae
            && let Ok(found) = self.newton(&Conditions { start, ..*conditions }, motion)
        {
            return Ok(found);
        }
        self.newton(conditions, motion)
    }

    /// Newton's method from the first displacement.
    fn newton(&self, conditions: &Conditions, motion: &Motion) -> Result<Equilibrium, RollingError> {
        let radius = self.radius();
        let scales = [1.0, 1.0, 1.0, 1.0 / radius, 1.0 / radius];
        let mut start = Start::default();
        let mut evaluations = 0;
        let mut evaluate = |displacement: &Displacement| {
            evaluations += 1;
            let evaluation = self.evaluate(displacement, motion, &mut start)?;
            let mut residual = [0.0; 5];
            for k in (0..5).filter(|&k| !conditions.prescribed[k]) {
                residual[k] = scales[k] * (conditions.load[k] - evaluation.load[k]);
            }
            let size = dot(&residual, &residual).sqrt();
            Ok::<_, RollingError>(Point { evaluation, residual, size })
        };
        let external = [0, 1, 2, 3, 4].map(|k| scales[k] * conditions.load[k]);
        let external = dot(&external, &external).sqrt();
        let mut displacement = conditions.start;
        let mut point = evaluate(&displacement)?;
        for _ in 0..STEPS {
            let scale = external + point.evaluation.scale;
            if point.size <= TOLERANCE * scale {
                break;
            }
            let step = self.step(&point, conditions, &scales);
            let at = |fraction: f64| {
                let mut next = displacement;
                for k in 0..5 {
                    next[k] += fraction * scales[k] * step[k];
                }
                next
            };
            let (fraction, trial) =
                line_search(&point, &step, STALLED * scale, |fraction| evaluate(&at(fraction)))?;
            let next = at(fraction);
            if trial.size >= 0.5 * point.size && point.size <= STALLED * scale {
                break;
            }
            (displacement, point) = (next, trial);
            let extent =
                displacement.iter().zip(&scales).fold(0.0f64, |most, (q, s)| most.max((q / s).abs()));
            if extent > radius + conditions.start.iter().fold(0.0f64, |most, q| most.max(q.abs())) {
                break;
            }
        }
        if point.size <= STALLED * (external + point.evaluation.scale) && point.evaluation.unconverged == 0 {
            return Ok(Equilibrium { displacement, evaluation: point.evaluation, evaluations });
        }
        Err(RollingError::equilibrium(
            format!(
                "the rolling bearing cannot carry the load {:?} N and N m: {:.3e} N is not balanced",
                conditions.load, point.size
            ),
            "remove the load in directions that the bearing does not support, or prescribe the displacement there",
        ))
    }

    /// Returns Newton's step in scaled components, limited to a fraction of the radius. A small
    /// stiffness is added, since a bearing within its clearance has none.
    fn step(&self, point: &Point, conditions: &Conditions, scales: &[f64; 5]) -> [f64; 5] {
        let mut matrix = [[0.0; 5]; 5];
        let mut right = [[0.0; 1]; 5];
        let mut largest = 0.0f64;
        for i in 0..5 {
            for j in 0..5 {
                if !conditions.prescribed[i] && !conditions.prescribed[j] {
                    matrix[i][j] = scales[i] * scales[j] * point.evaluation.stiffness[i][j];
                }
            }
            largest = largest.max(matrix[i][i]);
            right[i][0] = point.residual[i];
        }
        let least = 1e-12 * largest + 1e-9 * self.typical_stiffness();
        for k in 0..5 {
            matrix[k][k] += least;
        }
        if !solve(matrix, &mut right) {
            right = point.residual.map(|force| [force / self.typical_stiffness()]);
        }
        let step = right.map(|[x]| x);
        let length = dot(&step, &step).sqrt();
        let limit = 0.01 * self.radius();
        if length > limit { step.map(|x| x * limit / length) } else { step }
    }
}

/// Finds a fraction of a step at which the residual's component along the step is small, or at
/// which the residual is at most `small`, and the forces there.
fn line_search(
    point: &Point,
    step: &[f64; 5],
    small: f64,
    mut evaluate: impl FnMut(f64) -> Result<Point, RollingError>,
) -> Result<(f64, Point), RollingError> {
    let along = |point: &Point| dot(&point.residual, step);
    let first = along(point);
    let (mut low, mut high) = ((0.0, first), None);
    let mut fraction = 1.0;
    let mut trial = evaluate(fraction)?;
    for _ in 0..60 {
        let value = along(&trial);
        // Rounding may hide the sign of a small residual.
        if trial.size < 0.5 * point.size || trial.size <= small || value.abs() <= 0.3 * first.abs() {
            break;
        }
        if value > 0.0 {
            low = (fraction, value);
        } else {
            high = Some((fraction, value));
        }
        if let Some((end, end_value)) = high {
            let (begin, begin_value): (f64, f64) = low;
            if end - begin < 1e-12 * end {
                break;
            }
            let zero = begin + (end - begin) * begin_value / (begin_value - end_value);
            let margin = 0.1 * (end - begin);
            fraction = zero.clamp(begin + margin, end - margin);
        } else if fraction < 4.0 {
            fraction *= 2.0;
        } else {
            // The step does not reach the next contact.
            break;
        }
        trial = evaluate(fraction)?;
    }
    Ok((fraction, trial))
}
