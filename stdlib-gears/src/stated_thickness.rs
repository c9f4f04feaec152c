//! Tooth thickness from the statements of a drawing: profile shift, thickness in the normal or
//! transverse section, span measurement, or dimension over balls (ISO 21771:2007; DIN 21773:2014).
//!
//! The library module `iso21771` has the same relations for gear data without a tooth form; tests
//! compare both.

mod checks;

use self::checks::reversed_allowances;
use crate::blank::{Thickness, Tool};
use crate::data_block::StatedData;
use crate::error::{GeometryError, sentence};
use crate::helix::Helix;
use crate::involute::{involute, involute_of_roll, radius_at_roll, roll_at_radius, roll_of_involute};
use crate::rack::Plane;
use calyx_abi::math;
use std::f64::consts::{FRAC_PI_2, PI};

/// Largest difference of two statements of the thickness that count as equal, in modules: more than
/// the rounding of a drawing.
const SAME_THICKNESS: f64 = 1e-3;

/// Limit of the allowances of tooth thickness.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Limit {
    Nominal,
    Upper,
    Mean,
    Lower,
}

impl Limit {
    /// Returns the limit called `"nominal"`, `"upper"`, `"mean"` or `"lower"`.
    pub fn named(name: &str) -> Limit {
        match name {
            "upper" => Limit::Upper,
            "mean" => Limit::Mean,
            "lower" => Limit::Lower,
            _ => Limit::Nominal,
        }
    }

    /// Name of the limit.
    pub fn name(self) -> &'static str {
        match self {
            Limit::Nominal => "nominal",
            Limit::Upper => "upper",
            Limit::Mean => "mean",
            Limit::Lower => "lower",
        }
    }
}

/// Statements of the tooth thickness. Lengths in m.
#[derive(Clone, Debug)]
pub(crate) struct ThicknessStatements {
    pub profile_shift: Option<f64>,
    /// Circular thickness at the reference circle, in the plane of the tool.
    pub tooth_thickness: Option<f64>,
    pub normal_thickness: Option<f64>,
    pub transverse_thickness: Option<f64>,
    pub span: Option<f64>,
    pub span_teeth: Option<f64>,
    /// Dimension over or between balls with its argument.
    pub over_balls: (&'static str, Option<f64>),
    pub ball: Option<f64>,
    /// Upper and lower allowance of the normal thickness.
    pub allowances: [Option<f64>; 2],
    /// Limit at which the thickness, span or dimension over balls is stated.
    pub stated_at: Limit,
    /// Limit that the gear has.
    pub limit: Limit,
}

/// Tooth thickness that follows from the statements.
#[derive(Clone, Debug)]
pub(crate) struct StatedThickness {
    pub thickness: Thickness,
    /// Nominal profile shift coefficient, in modules of the tool.
    pub shift: f64,
    /// Profile shift coefficient at the limit that the gear has, in modules of the tool.
    pub generated_shift: f64,
    /// Allowance of the transverse thickness that the gear has, m.
    pub allowance: f64,
    pub warnings: Vec<GeometryError>,
}

/// The transverse section, which relates measurements to thickness.
struct Geometry<'t> {
    tool: &'t Tool,
    helix: &'t Helix,
    teeth: f64,
    internal: bool,
    normal_plane: bool,
    /// Reference diameter, base diameter, transverse pitch and base pitch, m.
    diameter: f64,
    base_diameter: f64,
    pitch: f64,
    base_pitch: f64,
    pressure_angle: f64,
    base_cosine: f64,
}

impl<'t> Geometry<'t> {
    fn new(tool: &'t Tool, helix: &'t Helix, teeth: u32) -> Geometry<'t> {
        let (internal, normal_plane, module, pressure_angle) = match tool {
            Tool::Rack(rack) => {
                let section = rack.transverse(helix);
                let normal = rack.plane == Plane::Normal && !helix.is_spur();
                (false, normal, section.module, section.pressure_angle)
            }
            Tool::Shaper(shaper) => (true, false, shaper.module, shaper.pressure_angle),
        };
        let (teeth, cosine) = (f64::from(teeth), math::cos(pressure_angle));
        let diameter = teeth * module;
        Geometry {
            tool,
            helix,
            teeth,
            internal,
            normal_plane,
            diameter,
            base_diameter: diameter * cosine,
            pitch: PI * module,
            base_pitch: PI * module * cosine,
            pressure_angle,
            base_cosine: math::cos(helix.base_angle(pressure_angle)),
        }
    }

    fn of_normal(&self, thickness: f64) -> f64 {
        let inclined = !self.normal_plane && !self.helix.is_spur();
        if inclined { thickness / math::cos(self.helix.angle()) } else { thickness }
    }

    fn of_transverse(&self, thickness: f64) -> f64 {
        if self.normal_plane { thickness * math::cos(self.helix.angle()) } else { thickness }
    }

    /// Transverse thickness of a thickness in the plane of the tool.
    fn transverse(&self, thickness: f64) -> f64 {
        if self.normal_plane { thickness / math::cos(self.helix.angle()) } else { thickness }
    }

    /// Transverse thickness of a tooth from half the angle between the involutes of a tooth at the
    /// base circle, or of a space of an internal gear.
    fn of_half_base_angle(&self, half_base_angle: f64) -> f64 {
        let arc = self.diameter * (half_base_angle - involute(self.pressure_angle));
        if self.internal { self.pitch - arc } else { arc }
    }

    /// Returns the diameter of the circle on which balls touch both flanks of a tooth space, from
    /// that of their centres: the normal of the flank at the point of contact passes through the
    /// centre.
    fn contact_diameter(&self, centers: f64, ball: f64) -> f64 {
        let tangent = ((centers / self.base_diameter).powi(2) - 1.0).max(0.0).sqrt();
        let along = tangent - self.sense() * ball * self.base_cosine / self.base_diameter;
        self.base_diameter * (1.0 + along * along).sqrt()
    }

    fn of_span(&self, span: f64, teeth: f64) -> f64 {
        let arc = span / self.base_cosine - (teeth - 1.0) * self.base_pitch;
        self.of_half_base_angle(arc / self.base_diameter)
    }

    /// As [`crate::external::ExternalGear::over_pins`] and
    /// [`crate::internal::InternalGear::between_pins`]; `None` if the balls would be inside the
    /// base circle.
    fn of_balls(&self, dimension: f64, ball: f64) -> Option<f64> {
        let centres = (dimension - self.sense() * ball) / self.odd();
        if centres.is_nan() || centres < self.base_diameter {
            return None;
        }
        let value = involute_of_roll(roll_at_radius(0.5 * self.base_diameter, 0.5 * centres));
        let along_base = ball / (self.base_diameter * self.base_cosine);
        Some(self.of_half_base_angle(match self.internal {
            false => value - along_base + PI / self.teeth,
            true => value + along_base,
        }))
    }

    /// Dimension over balls of teeth of a transverse thickness, m; the inverse of
    /// [`Geometry::of_balls`].
    fn balls_of(&self, thickness: f64, ball: f64) -> Option<f64> {
        let arc = if self.internal { self.pitch - thickness } else { thickness };
        let half_base_angle = arc / self.diameter + involute(self.pressure_angle);
        let along_base = ball / (self.base_diameter * self.base_cosine);
        let value = match self.internal {
            false => half_base_angle + along_base - PI / self.teeth,
            true => half_base_angle - along_base,
        };
        let center = || 2.0 * radius_at_roll(0.5 * self.base_diameter, roll_of_involute(value));
        (value > 0.0).then(|| center() * self.odd() + self.sense() * ball)
    }

    /// Ratio of the distance of two opposite ball centres to the diameter of their circle.
    fn odd(&self) -> f64 {
        if self.teeth % 2.0 == 1.0 { math::cos(FRAC_PI_2 / self.teeth) } else { 1.0 }
    }

    /// +1 for an external gear, -1 for an internal gear.
    fn sense(&self) -> f64 {
        if self.internal { -1.0 } else { 1.0 }
    }

    fn shift_of(&self, thickness: f64) -> f64 {
        match self.tool {
            Tool::Rack(rack) => rack.shift_of_thickness(thickness),
            Tool::Shaper(shaper) => shaper.shift_of_thickness(thickness),
        }
    }
}

impl ThicknessStatements {
    /// First argument that states the tooth thickness, if any.
    pub fn stated(&self) -> Option<&'static str> {
        let (over_balls, dimension) = self.over_balls;
        let stated = [
            ("tooth_thickness", self.tooth_thickness.is_some()),
            ("profile_shift", self.profile_shift.is_some()),
            ("normal_thickness", self.normal_thickness.is_some()),
            ("transverse_thickness", self.transverse_thickness.is_some()),
            ("span", self.span.is_some()),
            (over_balls, dimension.is_some()),
        ];
        stated.into_iter().find(|(_, stated)| *stated).map(|(argument, _)| argument)
    }

    /// Returns the allowances and the measurement of the data block.
    pub fn drawing(&self) -> StatedData {
        StatedData {
            allowances: self.allowances,
            thickness_limit: Some(self.limit.name()),
            span_teeth: self.span_teeth.map(|count| count as u32),
            ball: self.ball,
            ..StatedData::default()
        }
    }

    /// Returns the tooth thickness. `dedendum` is the dedendum coefficient of the tool if the root
    /// diameter follows from it.
    ///
    /// # Errors
    /// E0805: `tooth_thickness` and `profile_shift` contradict each other. E0916: other statements
    /// do. E0917: a measurement is incomplete or impossible, or the allowances are in the wrong
    /// order. E0928: an allowance is as large as a tooth.
    pub fn resolve(
        &self,
        tool: &Tool,
        teeth: u32,
        helix: &Helix,
        dedendum: Option<f64>,
    ) -> Result<StatedThickness, GeometryError> {
        let geometry = Geometry::new(tool, helix, teeth);
        let mut warnings = self.large_allowances(&geometry)?;
        let stated_at = geometry.of_normal(self.allowance(self.stated_at)?);
        let others = self.measured(&geometry)?;
        let others: Vec<(&'static str, f64)> =
            others.into_iter().map(|(argument, thickness)| (argument, thickness - stated_at)).collect();
        for &(argument, thickness) in &others {
            self.check_measurement(&geometry, argument, thickness, dedendum)?;
        }
        let circular = self.tooth_thickness.map(|thickness| thickness - stated_at);
        let (first, nominal) = match (circular, self.profile_shift) {
            (Some(thickness), shift) => {
                warnings.extend(self.agree_with_shift(&geometry, thickness, shift)?);
                ("tooth_thickness", Thickness::Circular(thickness))
            }
            (None, Some(shift)) => ("profile_shift", Thickness::ProfileShift(shift)),
            (None, None) => match others.first() {
                Some(&(argument, thickness)) => (argument, Thickness::Circular(thickness)),
                None => ("profile_shift", Thickness::ProfileShift(0.0)),
            },
        };
        let (thickness, shift) = match nominal {
            Thickness::Circular(thickness) => (thickness, geometry.shift_of(thickness)),
            Thickness::ProfileShift(shift) => (tool.thickness_of_shift(shift), shift),
        };
        let known = self.profile_shift.is_some() || circular.is_some() || !others.is_empty();
        let contradiction = others
            .iter()
            .find(|(_, other)| known && (other - thickness).abs() > SAME_THICKNESS * tool.module());
        if let Some(&(argument, other)) = contradiction {
            return Err(GeometryError::error(
                "E0916",
                argument,
                sentence![
                    "`", text argument, "` contradicts `", text first, "`: it makes the profile shift coefficient ",
                    number geometry.shift_of(other), ", and `", text first, "` makes it ", number shift
                ],
                match self.agreeing_limit(&geometry, other - thickness) {
                    Some(limit) => sentence![
                        "add `stated_at = \"", text limit.name(), "\"`: `", text argument, "` agrees with `", text first,
                        "` if it is stated at this limit of the allowances"
                    ],
                    None => sentence!["give one of them only, or correct one"],
                },
            ));
        }
        warnings.extend(self.unused_allowance());
        warnings.extend(self.unusual_allowances());
        let normal = self.allowance(self.limit)?;
        if normal == 0.0 {
            let (thickness, generated_shift) = (nominal, shift);
            return Ok(StatedThickness { thickness, shift, generated_shift, allowance: 0.0, warnings });
        }
        let generated = thickness + geometry.of_normal(normal);
        let generated_shift = geometry.shift_of(generated);
        let allowance = normal / math::cos(helix.angle());
        let thickness = Thickness::Circular(generated);
        Ok(StatedThickness { thickness, shift, generated_shift, allowance, warnings })
    }

    /// Warns about allowances that change nothing: the gear has the nominal thickness unless a
    /// limit is stated.
    fn unused_allowance(&self) -> Option<GeometryError> {
        if self.limit != Limit::Nominal || self.stated_at != Limit::Nominal {
            return None;
        }
        let names = ["upper_allowance", "lower_allowance"];
        let (_, name) = self.allowances.iter().zip(names).find(|(allowance, _)| allowance.is_some())?;
        Some(GeometryError::warning(
            "W0847",
            name,
            sentence!["the teeth have their nominal thickness, so the allowances have no effect"],
            sentence!["state the limit that the gear has, such as `thickness_limit = \"mean\"`"],
        ))
    }

    /// Compares a thickness with a profile shift coefficient. A shift of zero, which meant "not
    /// given" in earlier versions, only causes a warning.
    fn agree_with_shift(
        &self,
        geometry: &Geometry<'_>,
        thickness: f64,
        shift: Option<f64>,
    ) -> Result<Option<GeometryError>, GeometryError> {
        let Some(shift) = shift else { return Ok(None) };
        let shifted = geometry.tool.thickness_of_shift(shift);
        if (thickness - shifted).abs() <= SAME_THICKNESS * geometry.tool.module() {
            return Ok(None);
        }
        let message = sentence![
            "a profile shift of ", number shift, " makes teeth ", length shifted,
            " thick, but `tooth_thickness` is ", length thickness
        ];
        let meant = geometry.shift_of(thickness);
        if shift == 0.0 {
            return Ok(Some(GeometryError::warning(
                "W0846",
                "profile_shift",
                message,
                sentence![
                    "leave `profile_shift` out; 0 no longer means \"not given\", and the thickness is that of a profile shift of ",
                    number meant
                ],
            )));
        }
        Err(GeometryError::error(
            "E0805",
            "profile_shift",
            message,
            sentence![
                "leave one of them out; the thickness alone is that of a profile shift of ", number meant
            ],
        ))
    }

    /// Tooth thicknesses in the plane of the tool by the other statements, in order.
    fn measured(&self, geometry: &Geometry<'_>) -> Result<Vec<(&'static str, f64)>, GeometryError> {
        let mut found = Vec::new();
        found.extend(self.normal_thickness.map(|value| ("normal_thickness", geometry.of_normal(value))));
        found.extend(
            self.transverse_thickness.map(|value| ("transverse_thickness", geometry.of_transverse(value))),
        );
        match (self.span, self.span_teeth) {
            (Some(span), Some(count)) => {
                check_span_teeth(count, geometry)?;
                found.push(("span", geometry.of_transverse(geometry.of_span(span, count))));
            }
            (Some(span), None) => {
                return Err(incomplete(
                    "span",
                    sentence!["the span measurement of ", length span, " lacks its number of teeth"],
                    sentence!["give the number of teeth that are spanned, such as `span_teeth = 3`"],
                ));
            }
            // The number of teeth selects the span measurement of the gear data.
            (None, Some(count)) => check_span_teeth(count, geometry)?,
            (None, None) => {}
        }
        let (argument, dimension) = self.over_balls;
        match (dimension, self.ball) {
            (Some(dimension), Some(ball)) => match geometry.of_balls(dimension, ball) {
                Some(thickness) => found.push((argument, geometry.of_transverse(thickness))),
                None => {
                    return Err(incomplete(
                        argument,
                        sentence![
                            "`", text argument, "` of ", length dimension, " with balls of ", length ball,
                            " is impossible: the centres of the balls would be inside the base circle of diameter ",
                            length geometry.base_diameter
                        ],
                        sentence!["check the dimension, the diameter of the balls and the number of teeth"],
                    ));
                }
            },
            (Some(dimension), None) => {
                return Err(incomplete(
                    argument,
                    sentence!["`", text argument, "` of ", length dimension, " lacks the diameter of the balls"],
                    sentence!["give the diameter of the balls or pins, such as `ball = ", length 1.75 * geometry.tool.module(), "`"],
                ));
            }
            // The diameter selects the dimension over balls of the gear data; see `check_ball`.
            (None, _) => {}
        }
        Ok(found)
    }

    /// Allowance of the normal thickness at a limit, m.
    fn allowance(&self, limit: Limit) -> Result<f64, GeometryError> {
        let [upper, lower] = self.allowances;
        let [upper_value, lower_value] = [upper.unwrap_or(0.0), lower.unwrap_or(0.0)];
        if upper.is_some() && lower.is_some() && upper_value < lower_value {
            return Err(reversed_allowances(upper_value, lower_value));
        }
        let needed = match limit {
            Limit::Nominal => [false, false],
            Limit::Upper => [true, false],
            Limit::Mean => [true, true],
            Limit::Lower => [false, true],
        };
        let names = ["upper_allowance", "lower_allowance"];
        let missing = needed.into_iter().zip([upper, lower]).zip(names);
        if let Some((_, name)) = missing.into_iter().find(|((needed, given), _)| *needed && given.is_none()) {
            return Err(incomplete(
                if self.limit == limit { "thickness_limit" } else { "stated_at" },
                sentence!["this limit of the tooth thickness needs `", text name, "`, which is not given"],
                sentence!["give `", text name, "`, such as `", text name, " = -0.05 mm`"],
            ));
        }
        Ok(match limit {
            Limit::Nominal => 0.0,
            Limit::Upper => upper_value,
            Limit::Mean => 0.5 * (upper_value + lower_value),
            Limit::Lower => lower_value,
        })
    }
}

fn incomplete(
    argument: &'static str,
    message: crate::error::Sentence,
    help: crate::error::Sentence,
) -> GeometryError {
    GeometryError::error("E0917", argument, message, help)
}

/// Checks that a span measurement over a number of teeth exists.
fn check_span_teeth(count: f64, geometry: &Geometry<'_>) -> Result<(), GeometryError> {
    let whole = count.fract() == 0.0 && count >= 1.0 && count < geometry.teeth;
    match whole && (!geometry.internal || geometry.helix.is_spur()) {
        true => Ok(()),
        false => Err(impossible_span(count, geometry)),
    }
}

fn impossible_span(count: f64, geometry: &Geometry<'_>) -> GeometryError {
    if geometry.internal && !geometry.helix.is_spur() {
        return incomplete(
            "span",
            sentence!["a helical internal gear has no span measurement"],
            sentence!["give a dimension between balls: `between_balls` with `ball`"],
        );
    }
    incomplete(
        "span_teeth",
        sentence!["a span measurement cannot span ", number count, " teeth of ", number geometry.teeth],
        sentence!["give a whole number of at least 1, below the number of teeth"],
    )
}
