//! Statements of the roughing tool of a ground gear: protuberance, grinding allowance and addendum.

use crate::error::{GeometryError, sentence};
use crate::rack::Rack;
use crate::root_finding::solve_bracketed;
use calyx_abi::math;

/// Largest difference of the stated height of a protuberance from that of its angle, in modules.
const SAME_HEIGHT: f64 = 0.01;
/// Largest difference of two statements of the dedendum, in modules.
const SAME_DEDENDUM: f64 = 1e-4;

/// Roughing tool as a model states it. Lengths in m, in the plane of the rack.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RoughingTool {
    /// Protuberance `pr_P0`: distance of the tangent to the tip rounding from the parallel flank.
    pub protuberance: Option<f64>,
    /// Pressure angle `alpha_prP0` of the protuberance's flank, rad.
    pub angle: Option<f64>,
    /// Height `h_prP0` of the protuberance: distance from the tip of the tool to the point where
    /// its flank begins.
    pub height: Option<f64>,
    /// Grinding allowance `q`, normal to the flank.
    pub allowance: Option<f64>,
    /// Addendum `h_aP0` of the tool.
    pub addendum: Option<f64>,
}

impl RoughingTool {
    /// Adds the protuberance to a rack.
    ///
    /// # Errors
    /// E0933: the statements are incomplete, contradict each other, or the allowance exceeds the
    /// protuberance.
    pub fn shape(&self, rack: Rack) -> Result<Rack, GeometryError> {
        let Some(protuberance) = self.protuberance else {
            let other = [
                (self.angle.is_some(), "protuberance_angle"),
                (self.height.is_some(), "protuberance_height"),
                (self.allowance.is_some_and(|allowance| allowance > 0.0), "grinding_allowance"),
            ];
            return match other.into_iter().find(|(stated, _)| *stated) {
                None => Ok(rack),
                Some((_, name)) => Err(GeometryError::error(
                    "E0933",
                    name,
                    sentence!["`", text name, "` belongs to a roughing tool with protuberance, which is not stated"],
                    sentence!["give `protuberance`, or leave out `", text name, "`"],
                )),
            };
        };
        let angle = self.angle_of(protuberance, &rack)?;
        rack.with_protuberance(protuberance - self.allowance.unwrap_or(0.0), angle)
    }

    /// Pressure angle of the protuberance's flank, rad; 0 if neither angle nor height are stated.
    fn angle_of(&self, protuberance: f64, rack: &Rack) -> Result<f64, GeometryError> {
        let height_of = |angle| protuberance_height(rack, protuberance, angle);
        let Some(height) = self.height else { return Ok(self.angle.unwrap_or(0.0)) };
        if let Some(angle) = self.angle.filter(|angle| *angle < rack.pressure_angle) {
            let expected = height_of(angle);
            if (height - expected).abs() <= SAME_HEIGHT * rack.module {
                return Ok(angle);
            }
            return Err(GeometryError::error(
                "E0933",
                "protuberance_height",
                sentence![
                    "`protuberance_height` contradicts `protuberance_angle`: it is ", length height,
                    ", and the angle makes the protuberance ", length expected, " high"
                ],
                sentence!["give one of them only, or correct one"],
            ));
        }
        let least = height_of(0.0);
        if height < least {
            return Err(GeometryError::error(
                "E0933",
                "protuberance_height",
                sentence![
                    "the protuberance of ", length protuberance, " does not fit into a height of ", length height,
                    ": with this tip radius it is at least ", length least, " high"
                ],
                sentence!["enlarge `protuberance_height`, or give `protuberance_angle` instead"],
            ));
        }
        // The height grows without bound towards the pressure angle.
        let steepest = rack.pressure_angle * (1.0 - 1e-9);
        Ok(solve_bracketed(|angle| height_of(angle) - height, 0.0, steepest))
    }

    /// Dedendum of the basic rack, m: as stated, or that of a tool withdrawn by the profile shift
    /// of the grinding allowance, `h_aP0 - q / sin(alpha)` (DIN 3960; ISO 21771).
    ///
    /// # Errors
    /// E0933: both are stated and contradict each other.
    pub fn dedendum(&self, dedendum: Option<f64>, rack: &Rack) -> Result<Option<f64>, GeometryError> {
        let Some(addendum) = self.addendum else { return Ok(dedendum) };
        let withdrawn = self.allowance.unwrap_or(0.0) / math::sin(rack.pressure_angle);
        let generated = addendum - withdrawn;
        match dedendum.filter(|stated| (stated - generated).abs() > SAME_DEDENDUM * rack.module) {
            None => Ok(Some(generated)),
            Some(stated) => Err(GeometryError::error(
                "E0933",
                "tool_addendum",
                sentence![
                    "`tool_addendum` contradicts `dedendum`: withdrawn by ", length withdrawn,
                    " for the grinding allowance, the tool cuts ", length generated, " below the datum line, not ",
                    length stated
                ],
                sentence!["give one of them only, or correct one"],
            )),
        }
    }
}

/// Height of a protuberance above the tip of the tool, m: the tangent of the tip rounding with the
/// pressure angle `angle` (rad) meets the flank of the rack there.
fn protuberance_height(rack: &Rack, protuberance: f64, angle: f64) -> f64 {
    let radius = rack.tip_radius;
    let [(flank_tangent, flank_cosine), (tangent, cosine)] =
        [rack.pressure_angle, angle].map(|angle| (math::tan(angle), math::cos(angle)));
    let below_centre = ((radius - protuberance) / flank_cosine - radius / cosine) / (flank_tangent - tangent);
    radius - below_centre
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn height_and_angle_of_a_protuberance_determine_each_other() {
        let rack = Rack::new(4e-3, 20_f64.to_radians(), 1.6e-3).expect("a rack");
        for degrees in [0.0_f64, 8.0, 12.0, 18.0] {
            let angle = degrees.to_radians();
            let height = protuberance_height(&rack, 0.3e-3, angle);
            let tool =
                RoughingTool { protuberance: Some(0.3e-3), height: Some(height), ..Default::default() };
            let shaped = tool.shape(rack).expect("a tool");
            assert!((shaped.protuberance_angle - angle).abs() < 1e-12, "{degrees}");
            // The point lies on both lines: on the tangent of the rounding and on the flank.
            let y = 1.6e-3 - height;
            let on = |angle: f64, support: f64| (support - y * angle.sin()) / angle.cos();
            assert!((on(angle, 1.6e-3) - on(rack.pressure_angle, 1.3e-3)).abs() < 1e-15);
        }
        let low = RoughingTool { protuberance: Some(0.3e-3), height: Some(0.5e-3), ..Default::default() };
        assert_eq!(low.shape(rack).expect_err("too low").code, "E0933");
    }

    #[test]
    fn statements_of_a_roughing_tool_must_agree() {
        let rack = Rack::new(4e-3, 20_f64.to_radians(), 1.6e-3).expect("a rack");
        let refused = |tool: RoughingTool, argument: &str| {
            let error = tool.shape(rack).expect_err(argument);
            assert_eq!((error.code, error.argument), ("E0933", argument));
        };
        let full = RoughingTool { protuberance: Some(0.3e-3), ..Default::default() };
        refused(RoughingTool { allowance: Some(0.1e-3), ..Default::default() }, "grinding_allowance");
        refused(RoughingTool { angle: Some(0.1), ..Default::default() }, "protuberance_angle");
        refused(RoughingTool { allowance: Some(0.4e-3), ..full }, "grinding_allowance");
        refused(RoughingTool { angle: Some(0.4), ..full }, "protuberance_angle");
        refused(RoughingTool { angle: Some(0.2), height: Some(9e-3), ..full }, "protuberance_height");
        let withdrawn = RoughingTool { allowance: Some(0.1e-3), addendum: Some(5.6e-3), ..full };
        let dedendum = withdrawn.dedendum(None, &rack).expect("one statement").expect("a dedendum");
        assert!((dedendum - (5.6e-3 - 0.1e-3 / 20_f64.to_radians().sin())).abs() < 1e-17);
        assert!(withdrawn.dedendum(Some(5.6e-3), &rack).is_err());
    }
}
