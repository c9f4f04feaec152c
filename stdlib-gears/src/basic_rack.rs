//! Standard basic racks by name, and the generating rack as a model states it.

use crate::error::GeometryError;
use crate::rack::{Plane, Rack};
use crate::roughing::RoughingTool;
use calyx_abi::math;
use std::f64::consts::FRAC_PI_4;

/// Generating rack as a model states it: with its lengths, or by the name of a standard basic rack,
/// whose lengths are coefficients of the gear's normal module.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StatedRack {
    /// Name of a standard basic rack; `None` for a rack with lengths.
    pub name: Option<&'static str>,
    /// Addendum coefficient `h_aP*` of the basic rack.
    pub addendum: f64,
    /// Dedendum coefficient `h_fP*` of the basic rack: addendum of the tool, with its tip rounding.
    pub dedendum: f64,
    /// Flanks and tip rounding.
    pub form: RackForm,
}

/// Flanks and tip rounding of a [`StatedRack`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum RackForm {
    /// Rack with lengths.
    Sized(Rack),
    /// Coefficients in normal modules, in the normal plane.
    Basic {
        /// Pressure angle, rad.
        pressure_angle: f64,
        /// Root fillet radius coefficient `rho_fP*`.
        fillet_radius: f64,
        /// Roughing tool; without protuberance, the rack generates the flank too.
        tool: RoughingTool,
    },
}

/// Addendum and dedendum coefficients of a rack that states neither: those of ISO 53 A.
pub const USUAL_ADDENDUM: f64 = 1.0;
/// See [`USUAL_ADDENDUM`].
pub const USUAL_DEDENDUM: f64 = 1.25;

/// Basic racks with their coefficients of addendum, dedendum and fillet radius. All have a pressure
/// angle of 20 degrees.
///
/// ISO 53:1998, DIN 867:1986 (with a tip clearance of 0.25), DIN 58400, AGMA 201.02. The last one
/// has the depth of ISO 53 A and the largest fillet radius.
const BASIC: [(&str, [f64; 3]); 8] = [
    ("ISO 53 A", [1.0, 1.25, 0.38]),
    ("ISO 53 B", [1.0, 1.25, 0.3]),
    ("ISO 53 C", [1.0, 1.25, 0.25]),
    ("ISO 53 D", [1.0, 1.4, 0.39]),
    ("DIN 867", [1.0, 1.25, 0.38]),
    ("DIN 58400", [1.1, 1.5, 0.2]),
    ("AGMA coarse pitch", [1.0, 1.25, 0.3]),
    ("full fillet", [1.0, 1.25, f64::NAN]),
];

/// Pressure angle of the standard basic racks, degrees.
const PRESSURE_ANGLE: f64 = 20.0;

/// Largest root fillet radius coefficient, at which the fillets of both flanks meet:
/// `(pi/4 - h_fP* tan alpha_P) cos alpha_P / (1 - sin alpha_P)`.
fn full_fillet_radius(dedendum: f64, pressure_angle: f64) -> f64 {
    let (sine, cosine) = math::sincos(pressure_angle);
    (FRAC_PI_4 - dedendum * math::tan(pressure_angle)) * cosine / (1.0 - sine)
}

impl StatedRack {
    /// Returns the standard basic rack with a name.
    pub fn named(name: &str) -> Option<StatedRack> {
        let (name, [addendum, dedendum, radius]) = BASIC.into_iter().find(|(known, _)| *known == name)?;
        let pressure_angle = PRESSURE_ANGLE.to_radians();
        let fillet_radius =
            if radius.is_nan() { full_fillet_radius(dedendum, pressure_angle) } else { radius };
        let form = RackForm::Basic { pressure_angle, fillet_radius, tool: RoughingTool::default() };
        Some(StatedRack { name: Some(name), addendum, dedendum, form })
    }

    /// Returns a rack with lengths. Addendum and dedendum of the basic rack are lengths, m; `None`
    /// selects [`USUAL_ADDENDUM`] and [`USUAL_DEDENDUM`].
    pub fn sized(rack: Rack, addendum: Option<f64>, dedendum: Option<f64>) -> StatedRack {
        StatedRack {
            name: None,
            addendum: addendum.map_or(USUAL_ADDENDUM, |length| length / rack.module),
            dedendum: dedendum.map_or(USUAL_DEDENDUM, |length| length / rack.module),
            form: RackForm::Sized(rack),
        }
    }

    /// Names of the standard basic racks.
    pub fn names() -> impl Iterator<Item = &'static str> {
        BASIC.into_iter().map(|(name, _)| name)
    }

    /// Returns the rack for a normal module, m, which a rack with lengths does not need.
    ///
    /// # Errors
    /// E0933: the roughing tool does not fit the rack.
    pub fn with_module(&self, normal_module: f64) -> Result<Rack, GeometryError> {
        match self.form {
            RackForm::Sized(rack) => Ok(rack),
            RackForm::Basic { pressure_angle, fillet_radius, tool } => tool.shape(Rack {
                module: normal_module,
                pressure_angle,
                tip_radius: fillet_radius * normal_module,
                plane: Plane::Normal,
                tip_stretch: 1.0,
                residual_undercut: 0.0,
                protuberance_angle: 0.0,
            }),
        }
    }

    /// Returns true if a protuberance of the roughing tool cuts below the finished flank.
    pub fn has_protuberance(&self) -> bool {
        match self.form {
            RackForm::Sized(rack) => rack.residual_undercut > 0.0,
            RackForm::Basic { tool, .. } => {
                tool.protuberance.is_some_and(|depth| depth > tool.allowance.unwrap_or(0.0))
            }
        }
    }

    /// Returns the rack of a gear that is roughed by a tool with protuberance and then ground. The
    /// dedendum does not change.
    ///
    /// # Errors
    /// E0933: the tool does not fit the rack. The height of the protuberance on a rack without
    /// lengths is checked with its module.
    pub fn roughed_by(self, tool: RoughingTool) -> Result<StatedRack, GeometryError> {
        let form = match self.form {
            RackForm::Sized(rack) => RackForm::Sized(tool.shape(rack)?),
            RackForm::Basic { pressure_angle, fillet_radius, .. } => {
                // Everything except the height can be checked without a module.
                let form = RackForm::Basic {
                    pressure_angle,
                    fillet_radius,
                    tool: RoughingTool { height: None, ..tool },
                };
                StatedRack { form, ..self }.with_module(1.0)?;
                RackForm::Basic { pressure_angle, fillet_radius, tool }
            }
        };
        Ok(StatedRack { form, ..self })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_largest_fillet_radius_is_that_of_iso_53() {
        // ISO 53:1998, 5.2: 0.39 for a dedendum of 1.4 is nearly a full fillet.
        let angle = PRESSURE_ANGLE.to_radians();
        assert!((full_fillet_radius(1.4, angle) - 0.393).abs() < 5e-3, "{}", full_fillet_radius(1.4, angle));
        for name in StatedRack::names() {
            let Some(StatedRack { dedendum, form: RackForm::Basic { fillet_radius, .. }, .. }) =
                StatedRack::named(name)
            else {
                panic!("{name} has no coefficients")
            };
            assert!(fillet_radius <= full_fillet_radius(dedendum, angle), "{name}");
        }
    }
}
