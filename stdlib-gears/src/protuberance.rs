//! Root of external gears that a tool with protuberance has roughed: the fillet belongs to the
//! roughing tool, the involute to the finished flank. Both meet where they intersect.
//!
//! The tool cuts by `pr - q` below the finished flank: protuberance `pr` minus grinding allowance
//! `q` (ISO 21771; ISO 6336-3, residual undercut `s_pr`).

use crate::error::{GeometryError, sentence};
use crate::external::ExternalGear;
use crate::fillet::RootGeneration;
use crate::involute::roll_at_radius;
use crate::root_finding::solve_bracketed;
use calyx_abi::math;
use std::f64::consts::FRAC_PI_2;

/// Number of inclinations at which the fillet is compared with the involute before the intersection
/// is refined.
const STEPS: u32 = 256;
/// Least inclination of the tip rounding that is searched, rad.
const LEAST_INCLINATION: f64 = 1e-6;

/// Start of the finished involute.
struct FormPoint {
    inclination: f64,
    /// See [`ExternalGear::protuberance_curvature`].
    protuberance_curvature: Option<f64>,
    position: [f64; 2],
}

impl ExternalGear {
    /// Begins the involute where it leaves the fillet of the tool with protuberance.
    ///
    /// # Errors
    /// E0934: the fillet does not leave the involute below the tip circle.
    pub(crate) fn begin_above_protuberance(&mut self) -> Result<(), GeometryError> {
        let form = self.protuberance_form().ok_or_else(|| self.protuberance_error())?;
        let [x, y] = form.position;
        self.form_inclination = form.inclination;
        self.protuberance_curvature = form.protuberance_curvature;
        self.form_radius = x.hypot(y);
        self.form_roll = roll_at_radius(self.base_radius, self.form_radius);
        // The tip of the tool would undercut the teeth also without its protuberance.
        if self.undercut {
            self.warnings.push(self.undercut_warning());
        }
        self.undercut = true;
        Ok(())
    }

    /// Angle by which a point is outside the region between the two involutes, rad.
    fn outside_flank(&self, [x, y]: [f64; 2]) -> f64 {
        math::atan2(y, x) - self.half_angle_at_roll(roll_at_radius(self.base_radius, x.hypot(y)))
    }

    /// Finds the outermost intersection of the finished involute with the fillet: with the part
    /// that the tip rounding generates, or with that of the flank of the protuberance.
    fn protuberance_form(&self) -> Option<FormPoint> {
        let generation = RootGeneration::Rack(self.generation);
        let outside = |inclination: f64| self.outside_flank(generation.at(inclination).position);
        // The radius decreases towards the root.
        let beyond_tip = |inclination: f64| {
            let [x, y] = generation.at(inclination).position;
            x.hypot(y) - self.outer_radius
        };
        let at_tip = solve_bracketed(beyond_tip, LEAST_INCLINATION, FRAC_PI_2);
        let angle = self.rack.protuberance_angle;
        let first = angle.max(at_tip);
        if outside(first) < 0.0 {
            return if angle > at_tip { self.flank_form(angle) } else { None };
        }
        let step = (FRAC_PI_2 - first) / f64::from(STEPS);
        let at = |index: u32| first + step * f64::from(index);
        let crossed = (1..=STEPS).find(|&index| outside(at(index)) < 0.0)?;
        let inclination = solve_bracketed(outside, at(crossed - 1), at(crossed));
        let position = generation.at(inclination).position;
        let [x, y] = position;
        let form = FormPoint { inclination, protuberance_curvature: None, position };
        (x.hypot(y) > self.base_radius).then_some(form)
    }

    /// Finds the intersection of the finished involute with the involute that the flank of the
    /// protuberance generates. `None` if the tip rounding undercuts that involute, or if both meet
    /// only beyond the tip circle.
    fn flank_form(&self, inclination: f64) -> Option<FormPoint> {
        let generation = RootGeneration::Rack(self.generation);
        let start = generation.protuberance_start(inclination);
        let base_radius = self.pitch_radius * math::cos(inclination);
        let end = ((self.outer_radius - base_radius) * (self.outer_radius + base_radius)).max(0.0).sqrt();
        let outside =
            |curvature: f64| self.outside_flank(generation.on_protuberance(inclination, curvature).position);
        if start <= 0.0 || start >= end || outside(end) <= 0.0 {
            return None;
        }
        let curvature = solve_bracketed(outside, end, start);
        let position = generation.on_protuberance(inclination, curvature).position;
        Some(FormPoint { inclination, protuberance_curvature: Some(curvature), position })
    }

    fn protuberance_error(&self) -> GeometryError {
        GeometryError::error(
            "E0934",
            "rack",
            sentence![
                "the protuberance cuts ", length self.rack.residual_undercut,
                " below the finished flank, so deep that no involute begins between the fillet and the tip circle of diameter ",
                length 2.0 * self.outer_radius
            ],
            sentence![
                "reduce `protuberance` of the rack, or enlarge its `protuberance_angle` or the `grinding_allowance`"
            ],
        )
    }
}
