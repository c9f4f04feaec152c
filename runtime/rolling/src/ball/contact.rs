//! Force between a ball and a groove, with derivatives.

use super::geometry::{BallRow, Groove};

/// Force that draws the ball towards the centre of curvature of a groove.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct GrooveForce {
    /// Contact load, N.
    pub load: f64,
    /// Compression δ, m; negative without contact.
    pub compression: f64,
    /// Distance between the centres of curvature, m.
    pub distance: f64,
    /// Unit vector at the contact angle: outwards, and towards +z at a positive angle.
    pub direction: [f64; 2],
    /// Stiffness k, N/m^{3/2}; zero without contact.
    pub stiffness: f64,
    /// Force on the ball, N.
    pub force: [f64; 2],
    /// Derivative of the force with respect to the vector from ball to groove centre, at a fixed k.
    pub frozen: [[f64; 2]; 2],
    /// Derivative of the force with the change of k at the operating contact angle.
    pub exact: [[f64; 2]; 2],
}

impl BallRow {
    /// Computes the force of a groove with its centre at `center` on a ball at `ball`. A given
    /// stiffness replaces the one at the operating contact angle.
    pub(super) fn groove_force(
        &self,
        groove: &Groove,
        center: [f64; 2],
        ball: [f64; 2],
        frozen: Option<f64>,
    ) -> GrooveForce {
        let sign = if groove.inner { 1.0 } else { -1.0 };
        let v = [center[0] - ball[0], center[1] - ball[1]];
        let distance = libm::hypot(v[0], v[1]);
        let compression = distance - groove.free;
        if distance <= 1e-9 * groove.free {
            return GrooveForce { compression, distance, direction: [1.0, 0.0], ..GrooveForce::default() };
        }
        let unit = [v[0] / distance, v[1] / distance];
        let direction = [sign * unit[0], sign * unit[1]];
        let mut result = GrooveForce { compression, distance, direction, ..GrooveForce::default() };
        if compression <= 0.0 {
            return result;
        }
        let power = compression * compression.sqrt();
        let mut change = 0.0;
        result.stiffness = frozen.unwrap_or_else(|| {
            let cosine = direction[0];
            let contact = self.contact(groove, cosine);
            let curvature = self.rolling_curvature(groove, cosine);
            let by_cosine = contact.compliance_by_b() * self.rolling_curvature_by_cosine(groove, curvature);
            change = -1.5 * contact.stiffness / contact.compliance() * by_cosine;
            contact.stiffness
        });
        result.load = result.stiffness * power;
        result.force = [result.load * unit[0], result.load * unit[1]];
        let normal = 1.5 * result.stiffness * compression.sqrt();
        result.frozen = central_stiffness(unit, normal, result.load / distance);
        result.exact = result.frozen;
        // The cosine of the contact angle is direction·e_r, and the direction turns with
        // 1/distance.
        let turn = [1.0 - unit[0] * unit[0], -unit[0] * unit[1]];
        for i in 0..2 {
            for j in 0..2 {
                result.exact[i][j] += power * change * sign * unit[i] * turn[j] / distance;
            }
        }
        result
    }

    /// Computes the force between the two grooves of a ball without inertia: both contacts are on
    /// the line of the groove centres and carry the same load. `v` leads from the outer to the
    /// inner centre.
    pub(super) fn series_force(&self, v: [f64; 2]) -> GrooveForce {
        let (inner, outer) = (&self.grooves[0], &self.grooves[1]);
        let distance = libm::hypot(v[0], v[1]);
        let compression = distance - inner.free - outer.free;
        if compression <= 0.0 {
            let direction = if distance > 0.0 { [v[0] / distance, v[1] / distance] } else { [1.0, 0.0] };
            return GrooveForce { compression, distance, direction, ..GrooveForce::default() };
        }
        let unit = [v[0] / distance, v[1] / distance];
        let (mut compliance, mut by_cosine) = (0.0, 0.0);
        for groove in [inner, outer] {
            let contact = self.contact(groove, unit[0]);
            let curvature = self.rolling_curvature(groove, unit[0]);
            compliance += contact.compliance();
            by_cosine += contact.compliance_by_b() * self.rolling_curvature_by_cosine(groove, curvature);
        }
        let stiffness = 1.0 / (compliance * compliance.sqrt());
        let power = compression * compression.sqrt();
        let load = stiffness * power;
        let frozen = central_stiffness(unit, 1.5 * stiffness * compression.sqrt(), load / distance);
        let change = -1.5 * load / compliance * by_cosine / distance;
        let mut exact = frozen;
        let turn = [1.0 - unit[0] * unit[0], -unit[0] * unit[1]];
        for i in 0..2 {
            for j in 0..2 {
                exact[i][j] += change * unit[i] * turn[j];
            }
        }
        GrooveForce {
            load,
            compression,
            distance,
            direction: unit,
            stiffness,
            force: [load * unit[0], load * unit[1]],
            frozen,
            exact,
        }
    }
}

/// Returns the stiffness of a central force: along the line of the centres, and across it.
fn central_stiffness(unit: [f64; 2], normal: f64, across: f64) -> [[f64; 2]; 2] {
    let mut stiffness = [[0.0; 2]; 2];
    for i in 0..2 {
        for j in 0..2 {
            let identity = if i == j { across } else { 0.0 };
            stiffness[i][j] = identity + (normal - across) * unit[i] * unit[j];
        }
    }
    stiffness
}
