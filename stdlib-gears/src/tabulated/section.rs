//! Section surfaces of a gear: cones normal to its pitch cone, and their developments.
//!
//! The pitch cone has the angle `G` to the axis and opens towards +e3 (sense +1) or -e3 (-1). With
//! the radius `R` and the axial coordinate `Z`, a point has the coordinates
//!
//! `L = R sin G + sense Z cos G` along the pitch cone, `h = R cos G - sense Z sin G` normal to it.
//!
//! A section is the cone of constant `L` (the back cone; a plane for a cylindrical gear). It is
//! developable: its development is plane, with the polar coordinates `rho = R / cos G` and
//! `a = (azimuth) cos G` (Tredgold). Coordinates `x`, `y` of the development are relative to the
//! point `h = 0` of azimuth zero, so that they remain finite for a crown gear, whose sections are
//! cylinders.

use calyx_abi::math;

/// Family of section surfaces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SectionCones {
    sine: f64,
    cosine: f64,
    /// +1 if the pitch cone opens towards +e3, otherwise -1.
    pub sense: f64,
}

/// Coordinates of a point in the meridian plane, and its azimuth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Meridian {
    /// `sense L`: coordinate along the pitch cone, increasing towards +e3, m.
    pub along: f64,
    /// `h`: height normal to the pitch cone, m.
    pub height: f64,
    /// Azimuth, rad.
    pub azimuth: f64,
}

/// Position with its derivatives by the coordinates `x` and `y` of the development and by the
/// coordinate along the pitch cone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placed {
    /// Position, m.
    pub position: [f64; 3],
    /// Derivatives.
    pub derivatives: [[f64; 3]; 3],
}

/// `sin(a) / a`.
fn cardinal_sine(a: f64) -> f64 {
    cardinal(a, math::sin(a))
}

/// `sin(a) / a`, from `a` and its sine.
fn cardinal(a: f64, sine: f64) -> f64 {
    if a.abs() < 1e-4 { 1.0 - a * a / 6.0 } else { sine / a }
}

impl SectionCones {
    /// Creates the sections of a pitch cone of an angle of 0 to 90 degrees (rad).
    pub fn new(pitch_angle: f64, sense: f64) -> Self {
        let (sine, cosine) = math::sincos(pitch_angle);
        Self { sine, cosine: cosine.max(0.0), sense }
    }

    /// Unit vector along the pitch cone from its apex: axial and radial component.
    pub fn along(&self) -> [f64; 2] {
        [self.sense * self.cosine, self.sine]
    }

    /// Coordinates of a point.
    pub fn meridian(&self, [x, y, z]: [f64; 3]) -> Meridian {
        let radius = x.hypot(y);
        Meridian {
            along: self.sense * radius * self.sine + z * self.cosine,
            height: radius * self.cosine - self.sense * z * self.sine,
            azimuth: math::atan2(y, x),
        }
    }

    /// Distance from the axis of a point of a section, m.
    pub fn radius(&self, along: f64, height: f64) -> f64 {
        self.sense * along * self.sine + height * self.cosine
    }

    /// Height at which a section has this radius, m; `None` for a crown gear, whose sections are
    /// cylinders.
    pub fn height_at_radius(&self, along: f64, radius: f64) -> Option<f64> {
        (self.cosine > 1e-9).then(|| (radius - self.sense * along * self.sine) / self.cosine)
    }

    /// Point of the development at a height and an azimuth.
    pub fn developed(&self, along: f64, height: f64, azimuth: f64) -> [f64; 2] {
        let radius = self.radius(along, height);
        let angle = azimuth * self.cosine;
        let half = cardinal_sine(0.5 * angle);
        let x = height - 0.5 * radius * azimuth * azimuth * self.cosine * half * half;
        [x, radius * azimuth * cardinal_sine(angle)]
    }

    /// Angle of the outward radial direction of the development at an azimuth, rad.
    pub fn radial_angle(&self, azimuth: f64) -> f64 {
        azimuth * self.cosine
    }

    /// Height and azimuth of a point of the development.
    pub fn rolled(&self, along: f64, [x, y]: [f64; 2]) -> [f64; 2] {
        let from_axis = self.sense * along * self.sine;
        let (forward, left) = (x * self.cosine + from_axis, y * self.cosine);
        let radius = forward.hypot(left);
        let height = if from_axis > 0.0 {
            (2.0 * x * from_axis + self.cosine * (x * x + y * y)) / (radius + from_axis)
        } else {
            (radius - from_axis) / self.cosine
        };
        let azimuth =
            if self.cosine > 0.0 { math::atan2(left, forward) / self.cosine } else { y / from_axis };
        [height, azimuth]
    }

    /// Point of a body whose sections are rotated by an angle that varies along the pitch cone:
    /// `rotation` is the angle (rad) and its derivative.
    pub fn placed(&self, along: f64, point: [f64; 2], rotation: [f64; 2]) -> Placed {
        let [height, azimuth] = self.rolled(along, point);
        let radius = self.radius(along, height);
        let angle = azimuth * self.cosine;
        let (sine, cosine) = math::sincos(angle);
        let half = cardinal_sine(0.5 * angle);
        // Derivatives of height and azimuth by x, y and the coordinate along the pitch cone.
        let height_by =
            [cosine, sine, -0.5 * self.sense * azimuth * azimuth * self.cosine * self.sine * half * half];
        let azimuth_by = [
            -sine / radius,
            cosine / radius,
            rotation[1] - self.sense * azimuth * cardinal(angle, sine) * self.sine / radius,
        ];
        let along_by = [0.0, 0.0, 1.0];
        let (sine, cosine) = math::sincos(azimuth + rotation[0]);
        let z = along * self.cosine - self.sense * height * self.sine;
        let derivatives = [0, 1, 2].map(|k: usize| {
            let radius_by = self.sense * along_by[k] * self.sine + self.cosine * height_by[k];
            let around = radius * azimuth_by[k];
            [
                radius_by * cosine - around * sine,
                radius_by * sine + around * cosine,
                along_by[k] * self.cosine - self.sense * height_by[k] * self.sine,
            ]
        });
        Placed { position: [radius * cosine, radius * sine, z], derivatives }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn developing_and_rolling_up_are_inverse_and_isometric() {
        for degrees in [0.0_f64, 18.4, 45.0, 71.6, 89.9, 90.0] {
            for sense in [1.0, -1.0] {
                let cones = SectionCones::new(degrees.to_radians(), sense);
                let apart =
                    |a: [f64; 3], b: [f64; 3]| (0..3).map(|k| (a[k] - b[k]).powi(2)).sum::<f64>().sqrt();
                let (radius, depth, azimuth) = (0.08_f64, -0.004_f64, 0.21_f64);
                // A point near the pitch cone through this radius.
                let along =
                    sense * radius * degrees.to_radians().sin() + sense * 0.03 * degrees.to_radians().cos();
                let height = radius * degrees.to_radians().cos() - 0.03 * degrees.to_radians().sin() + depth;
                let point = cones.developed(along, height, azimuth);
                let [again, around] = cones.rolled(along, point);
                assert!((again - height).abs() < 1e-15, "{degrees} {again} {height}");
                assert!((around - azimuth).abs() < 1e-13, "{degrees} {around}");
                let rotation = |v: f64| [0.3 + 2.0 * (v - along), 2.0];
                let at = cones.placed(along, point, rotation(along));
                let back = cones.meridian(at.position);
                assert!((back.along - along).abs() < 1e-15 && (back.height - height).abs() < 1e-15);
                assert!((back.azimuth - azimuth - 0.3).abs() < 1e-14);
                // Derivatives, and lengths of the development.
                let h = 1e-7;
                for (k, step) in [[h, 0.0, 0.0], [0.0, h, 0.0], [0.0, 0.0, h]].into_iter().enumerate() {
                    let moved = |sign: f64| {
                        let v = along + sign * step[2];
                        let point = [point[0] + sign * step[0], point[1] + sign * step[1]];
                        cones.placed(v, point, rotation(v)).position
                    };
                    let [low, high] = [moved(-1.0), moved(1.0)];
                    for axis in 0..3 {
                        let slope = (high[axis] - low[axis]) / (2.0 * h);
                        assert!((at.derivatives[k][axis] - slope).abs() < 1e-7, "{degrees} {k} {axis}");
                    }
                    if k < 2 {
                        assert!((apart(low, high) / (2.0 * h) - 1.0).abs() < 1e-7);
                    }
                }
            }
        }
    }
}
