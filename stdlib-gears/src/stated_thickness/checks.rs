//! Checks of the statements of tooth thickness: measurements that no tooth has, and unusual
//! allowances.

use super::{Geometry, Limit, SAME_THICKNESS, ThicknessStatements, incomplete};
use crate::blank::Tool;
use crate::error::{GeometryError, Sentence, sentence};
use crate::helix::Helix;
use crate::plausibility::meant;
use calyx_abi::math;
use std::f64::consts::{FRAC_PI_2, PI};
use std::ops::RangeInclusive;

/// Largest magnitude of a profile shift coefficient that a measurement may mean. One tooth more or
/// less in a span changes it by about 4.
const LARGEST_SHIFT: f64 = 1.5;
/// Largest usual magnitude of an allowance of the normal tooth thickness, in normal modules: more
/// than the backlash of coarse gears.
const LARGEST_ALLOWANCE: f64 = 0.3;
/// Allowances that a message suggests, in normal modules.
const USUAL_ALLOWANCES: RangeInclusive<f64> = 2e-3..=0.15;

impl ThicknessStatements {
    /// Returns a warning for each allowance that is larger than those of any backlash.
    ///
    /// # Errors
    /// E0928: the allowance is as large as the tooth, as with micrometres stated as millimetres.
    pub(super) fn large_allowances(
        &self,
        geometry: &Geometry<'_>,
    ) -> Result<Vec<GeometryError>, GeometryError> {
        let normal_module = geometry.pitch * math::cos(geometry.helix.angle()) / PI;
        let mut warnings = Vec::new();
        for (allowance, name) in self.allowances.iter().zip(["upper_allowance", "lower_allowance"]) {
            let Some(value) = *allowance else { continue };
            let modules = value.abs() / normal_module;
            if modules <= LARGEST_ALLOWANCE {
                continue;
            }
            let impossible = modules >= FRAC_PI_2;
            let message = match impossible {
                true => sentence![
                    "an allowance of ", length value, " is as large as a tooth: half a normal pitch is ",
                    length FRAC_PI_2 * normal_module
                ],
                false => sentence![
                    "an allowance of ", length value, " is unusually large: it changes the tooth thickness by ",
                    number (100.0 * modules).round() / 100.0, " normal modules"
                ],
            };
            let help = match meant(modules, &USUAL_ALLOWANCES) {
                Some(meant) => sentence![
                    "is `", text name, " = ", length value.signum() * meant * normal_module,
                    "` meant? Allowances of 0.02 to 0.1 modules are usual"
                ],
                None => {
                    sentence!["check the number and the unit; allowances of 0.02 to 0.1 modules are usual"]
                }
            };
            if impossible {
                return Err(GeometryError::error("E0928", name, message, help));
            }
            warnings.push(GeometryError::warning("W0843", name, message, help));
        }
        Ok(warnings)
    }

    /// Warns about positive allowances, and about an allowance without the other one.
    pub(super) fn unusual_allowances(&self) -> Option<GeometryError> {
        let names = ["upper_allowance", "lower_allowance"];
        if let [Some(upper), Some(lower)] = self.allowances
            && lower > 0.0
        {
            return Some(GeometryError::warning(
                "W0848",
                "upper_allowance",
                sentence![
                    "allowances of ", length upper, " and ", length lower, " make the teeth thicker than nominal"
                ],
                negative_allowances(upper, lower),
            ));
        }
        let mut stated = self.allowances.iter().zip(names);
        if let Some((value, name)) =
            stated.clone().find_map(|(allowance, name)| Some((allowance.filter(|value| *value > 0.0)?, name)))
        {
            return Some(GeometryError::warning(
                "W0848",
                name,
                sentence!["an allowance of ", length value, " makes the teeth thicker than nominal"],
                sentence![
                    "is `", text name, " = ", length -value, "` meant? Allowances for backlash are negative"
                ],
            ));
        }
        let (_, missing) = stated.find(|(allowance, _)| allowance.is_none())?;
        let (value, name) =
            self.allowances.iter().zip(names).find_map(|(allowance, name)| Some(((*allowance)?, name)))?;
        Some(GeometryError::warning(
            "W0848",
            name,
            sentence!["the tooth thickness has an allowance of ", length value, ", but no `", text missing, "`"],
            sentence!["give `", text missing, "`, too: a tolerance has two limits"],
        ))
    }

    /// Limit of the allowances at which a measurement agrees with the nominal thickness, if it
    /// exceeds that by `difference`, m.
    pub(super) fn agreeing_limit(&self, geometry: &Geometry<'_>, difference: f64) -> Option<Limit> {
        if self.stated_at != Limit::Nominal {
            return None;
        }
        [Limit::Upper, Limit::Lower, Limit::Mean].into_iter().find(|limit| {
            let allowance = self.allowance(*limit).map_or(0.0, |allowance| geometry.of_normal(allowance));
            allowance != 0.0 && (difference - allowance).abs() <= SAME_THICKNESS * geometry.tool.module()
        })
    }

    /// Checks that a span or a dimension over balls belongs to a tooth that the tool can generate.
    ///
    /// # Errors
    /// E0917.
    pub(super) fn check_measurement(
        &self,
        geometry: &Geometry<'_>,
        argument: &'static str,
        thickness: f64,
        dedendum: Option<f64>,
    ) -> Result<(), GeometryError> {
        let (name, _) = self.over_balls;
        let (is_span, is_over_balls) = (argument == "span", argument == name);
        let shift = geometry.shift_of(thickness);
        let possible = |thickness: f64| {
            let shift = geometry.shift_of(thickness);
            let reaches = dedendum.is_none_or(|dedendum| geometry.sense() * shift < dedendum);
            (0.0..PI * geometry.tool.module()).contains(&thickness) && shift.abs() <= LARGEST_SHIFT && reaches
        };
        if (!is_span && !is_over_balls) || possible(thickness) {
            return Ok(());
        }
        let half_pitch = 0.5 * geometry.pitch;
        if let (true, Some(span), Some(count)) = (is_span, self.span, self.span_teeth) {
            let thickness = |count: u32| geometry.of_transverse(geometry.of_span(span, f64::from(count)));
            let counts = 1..(geometry.teeth as u32);
            let fitting = counts.filter(|count| possible(thickness(*count))).min_by(|a, b| {
                let shift = |count: u32| geometry.shift_of(thickness(count)).abs();
                shift(*a).total_cmp(&shift(*b))
            });
            return Err(incomplete(
                "span_teeth",
                sentence![
                    "a span of ", length span, " over ", number count, " teeth is impossible: the profile shift coefficient would be ",
                    number shift
                ],
                match fitting {
                    Some(count) => sentence![
                        "is `span_teeth = ", number f64::from(count), "` meant? It makes the profile shift coefficient ",
                        number geometry.shift_of(thickness(count))
                    ],
                    None => sentence!["check the span, the module and the number of teeth"],
                },
            ));
        }
        let ball = self.ball.unwrap_or_default();
        Err(incomplete(
            "ball",
            sentence![
                "`", text argument, "` of ", length self.over_balls.1.unwrap_or_default(), " with balls of ", length ball,
                " is impossible: the profile shift coefficient would be ", number shift
            ],
            match geometry.balls_of(half_pitch, ball) {
                Some(usual) => sentence![
                    "check both diameters: without profile shift, `", text argument, "` with these balls is ", length usual
                ],
                None => sentence![
                    "check the diameter of the balls; ", length 1.75 * geometry.tool.module(), " is usual"
                ],
            },
        ))
    }

    /// Checks that the balls of a dimension over balls touch the flanks below the tips, and that
    /// they are not themselves below the tip circle, where nothing can measure them. `thickness` is
    /// the nominal thickness in the plane of the tool, m.
    ///
    /// # Errors
    /// E0917.
    pub fn check_ball(
        &self,
        tool: &Tool,
        (teeth, thickness): (u32, f64),
        helix: &Helix,
        tip_diameter: f64,
    ) -> Result<(), GeometryError> {
        let ((argument, dimension), Some(ball)) = (self.over_balls, self.ball) else { return Ok(()) };
        let geometry = Geometry::new(tool, helix, teeth);
        let measured = dimension.or_else(|| geometry.balls_of(geometry.transverse(thickness), ball));
        let Some(dimension) = measured else {
            return Err(incomplete(
                "ball",
                sentence!["balls of ", length ball, " do not touch both flanks of a tooth space"],
                sentence!["measure with other balls, such as `ball = ", length 1.75 * tool.module(), "`"],
            ));
        };
        let centers = (dimension - geometry.sense() * ball) / geometry.odd();
        let contact = geometry.contact_diameter(centers, ball);
        if geometry.sense() * (contact - tip_diameter) > SAME_THICKNESS * tool.module() {
            return Err(incomplete(
                "ball",
                sentence![
                    "balls of ", length ball, " touch the flanks at a diameter of ", length contact,
                    ", beyond the tip circle of ", length tip_diameter, ": they rest on the tips of the teeth"
                ],
                sentence!["measure with smaller balls, such as `ball = ", length 1.75 * tool.module(), "`"],
            ));
        }
        let end = centers + geometry.sense() * ball;
        if geometry.sense() * (end - tip_diameter) > 0.0 {
            return Ok(());
        }
        Err(incomplete(
            "ball",
            sentence![
                "balls of ", length ball, " end at a diameter of ", length end, " and do not project over the tip circle of ",
                length tip_diameter, ", so that `", text argument, "` cannot be measured"
            ],
            sentence!["measure with larger balls, such as `ball = ", length 1.75 * tool.module(), "`"],
        ))
    }
}

/// Error for an upper allowance below the lower one.
pub(super) fn reversed_allowances(upper: f64, lower: f64) -> GeometryError {
    let help = match upper > 0.0 {
        true => negative_allowances(upper, lower),
        false => sentence![
            "exchange them: `upper_allowance = ", length lower, ", lower_allowance = ", length upper,
            "`; the upper allowance belongs to the thickest teeth"
        ],
    };
    incomplete(
        "upper_allowance",
        sentence![
            "the upper allowance of the tooth thickness, ", length upper, ", is below the lower one, ", length lower
        ],
        help,
    )
}

/// Help for two positive allowances, which state by how much the teeth are thinner than nominal.
fn negative_allowances(one: f64, other: f64) -> Sentence {
    sentence![
        "is `upper_allowance = ",
        length - one.min(other),
        ", lower_allowance = ",
        length - one.max(other),
        "` meant? Allowances that make the teeth thinner are negative, and the upper one is nearer to zero"
    ]
}
