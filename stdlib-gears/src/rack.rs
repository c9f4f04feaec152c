//! The generating rack: the counterpart of the basic rack (ISO 53; ISO 21771:2007, 7.1). It
//! generates the tooth spaces by rolling on the reference circle of the gear.

use crate::error::{GeometryError, sentence};
use crate::helix::Helix;
use calyx_abi::math;
use std::f64::consts::PI;

/// Plane in which the dimensions of a tool are given.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Plane {
    /// Perpendicular to the gear's axis.
    #[default]
    Transverse,
    /// Perpendicular to the teeth at the pitch circle.
    Normal,
    /// Not given, which suffices for spur gears: both planes are the same.
    Unstated,
}

impl Plane {
    /// Returns the plane called `"transverse"` or `"normal"`.
    pub fn named(name: &str) -> Option<Plane> {
        match name {
            "transverse" => Some(Plane::Transverse),
            "normal" => Some(Plane::Normal),
            _ => None,
        }
    }
}

/// Generating rack with straight flanks and rounded tooth tips. SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rack {
    /// Pitch divided by pi, m. In the transverse plane, this is the pitch diameter divided by the
    /// number of teeth.
    pub module: f64,
    /// Pressure angle: inclination of the flanks, rad.
    pub pressure_angle: f64,
    /// Tip radius of the tool, m. Zero is a sharp corner.
    pub tip_radius: f64,
    /// Plane of these dimensions.
    pub plane: Plane,
    /// Ratio of the tip rounding's half-axis along the pitch line to [`Self::tip_radius`], the
    /// half-axis across it. It exceeds 1 in the transverse plane of a rack whose tip is round in
    /// the normal plane: the rounding is an ellipse there.
    pub tip_stretch: f64,
    /// Residual undercut `s_pr = pr - q`: depth of the cut by the protuberance of the roughing tool
    /// below the finished flank, normal to the flank, m. The normal plane has it unchanged where
    /// [`Self::tip_stretch`] exceeds 1. Zero for a tool without protuberance.
    pub residual_undercut: f64,
    /// Pressure angle `alpha_pr` of the protuberance's flank, rad.
    pub protuberance_angle: f64,
}

impl Rack {
    /// Creates a rack in the transverse plane. Whether the tip rounding fits depends on the gear
    /// and is checked with it.
    ///
    /// # Errors
    /// E0601 to E0603.
    pub fn new(module: f64, pressure_angle: f64, tip_radius: f64) -> Result<Self, GeometryError> {
        check_tool("rack", module, pressure_angle, tip_radius)?;
        Ok(Self {
            module,
            pressure_angle,
            tip_radius,
            plane: Plane::Transverse,
            tip_stretch: 1.0,
            residual_undercut: 0.0,
            protuberance_angle: 0.0,
        })
    }

    /// Returns the rack with the protuberance of its roughing tool. The tip rounding moves outwards
    /// from the finished flank by `residual_undercut` (m), see [`Self::residual_undercut`]. It
    /// continues in a straight flank of pressure angle `protuberance_angle` (rad).
    ///
    /// # Errors
    /// E0933: the residual undercut is negative, or the protuberance is not steeper than the flank.
    pub fn with_protuberance(
        self,
        residual_undercut: f64,
        protuberance_angle: f64,
    ) -> Result<Rack, GeometryError> {
        if !(residual_undercut.is_finite() && residual_undercut >= 0.0) {
            return Err(GeometryError::error(
                "E0933",
                "grinding_allowance",
                sentence![
                    "the grinding allowance exceeds the protuberance by ",
                    length - residual_undercut,
                    ": grinding would leave a notch in the fillet, which the tooth form does not include"
                ],
                sentence!["enlarge `protuberance`, or reduce `grinding_allowance` to it"],
            ));
        }
        if !(protuberance_angle >= 0.0 && protuberance_angle < self.pressure_angle) {
            return Err(GeometryError::error(
                "E0933",
                "protuberance_angle",
                sentence![
                    "the flank of the protuberance has a pressure angle of ", angle protuberance_angle,
                    ", not below that of the rack, ", angle self.pressure_angle
                ],
                sentence!["give an angle between 0 deg and the pressure angle; 8 deg to 12 deg is usual"],
            ));
        }
        Ok(Rack { residual_undercut, protuberance_angle, ..self })
    }

    /// Returns the rack with its dimensions assigned to another plane.
    #[must_use]
    pub fn in_plane(self, plane: Plane) -> Rack {
        Rack { plane, ..self }
    }

    /// Checks that the plane of the dimensions is given if the gear has a helix. The same numbers
    /// describe different gears in the two planes.
    ///
    /// # Errors
    /// E0693.
    pub(crate) fn check_plane(&self, helix: &Helix) -> Result<(), GeometryError> {
        if self.plane != Plane::Unstated || helix.is_spur() {
            return Ok(());
        }
        let cosine = math::cos(helix.angle());
        Err(GeometryError::error(
            "E0693",
            "rack",
            sentence![
                "the rack of this helical gear does not say in which section its module is: a transverse module of ",
                length self.module, " is a normal module of ", length self.module * cosine,
                ", and a normal module of ", length self.module, " is a transverse module of ",
                length self.module / cosine
            ],
            sentence![
                "add `plane = \"normal\"` to `gears.rack` if the drawing gives the normal module and pressure angle, as usual, or `plane = \"transverse\"`"
            ],
        ))
    }

    /// Returns the transverse section of the rack for a gear with this helix. The section is exact:
    /// a tip that is a circle in the normal plane becomes an ellipse.
    #[must_use]
    pub fn transverse(&self, helix: &Helix) -> Rack {
        let cosine = match self.plane {
            Plane::Transverse | Plane::Unstated => return *self,
            // Both planes of a spur gear are the same, to the last bit.
            Plane::Normal if helix.is_spur() => return self.in_plane(Plane::Transverse),
            Plane::Normal => math::cos(helix.angle()),
        };
        Rack {
            module: self.module / cosine,
            pressure_angle: math::atan(math::tan(self.pressure_angle) / cosine),
            tip_radius: self.tip_radius,
            plane: Plane::Transverse,
            tip_stretch: self.tip_stretch / cosine,
            residual_undercut: self.residual_undercut,
            protuberance_angle: math::atan(math::tan(self.protuberance_angle) / cosine),
        }
    }

    /// Module in the plane in which the rack was given. For the transverse section of a rack from
    /// the normal plane this is the normal module, because the tip is stretched by
    /// `1 / cos(helix angle)`. Profile shift coefficients count these modules.
    pub fn tool_module(&self) -> f64 {
        self.module / self.tip_stretch
    }

    /// Converts a tooth thickness from the rack's plane to the transverse plane, m.
    pub fn transverse_thickness(&self, thickness: f64, helix: &Helix) -> f64 {
        match self.plane {
            Plane::Transverse | Plane::Unstated => thickness,
            Plane::Normal => thickness / math::cos(helix.angle()),
        }
    }

    /// Pitch, the distance of adjacent teeth, m.
    pub fn pitch(&self) -> f64 {
        PI * self.module
    }

    /// Tooth thickness at the pitch circle of a gear with this profile shift coefficient,
    /// `m (pi/2 + 2 x tan(alpha))`, m.
    pub fn thickness_of_shift(&self, profile_shift: f64) -> f64 {
        self.module * (0.5 * PI + 2.0 * profile_shift * math::tan(self.pressure_angle))
    }

    /// Profile shift coefficient of a tooth thickness; the inverse of [`Rack::thickness_of_shift`].
    pub fn shift_of_thickness(&self, tooth_thickness: f64) -> f64 {
        (tooth_thickness / self.module - 0.5 * PI) / (2.0 * math::tan(self.pressure_angle))
    }

    /// Support function of the tip rounding: distance from its centre to the tangent whose normal
    /// is inclined by `inclination` to the pitch line, m.
    pub(crate) fn tip_support(&self, inclination: f64) -> f64 {
        self.tip_radius * self.stretched(inclination)
    }

    /// Distance in this plane of two tangents of this inclination whose distance is 1 where the tip
    /// rounding is a circle.
    fn stretched(&self, inclination: f64) -> f64 {
        if self.tip_stretch == 1.0 {
            return 1.0;
        }
        let (sine, cosine) = math::sincos(inclination);
        (self.tip_stretch * cosine).hypot(sine)
    }

    /// Depth of the protuberance's cut below the finished flank in this plane, m.
    pub(crate) fn undercut_depth(&self) -> f64 {
        self.residual_undercut * self.stretched(self.pressure_angle)
    }

    /// Depth of the tangent point of this tangent below the centre of the rounding, m.
    pub(crate) fn tip_touch_depth(&self, inclination: f64) -> f64 {
        let (sine, cosine) = math::sincos(inclination);
        if self.tip_stretch == 1.0 {
            return self.tip_radius * sine;
        }
        self.tip_radius * sine / (self.tip_stretch * cosine).hypot(sine)
    }
}

/// Checks the dimensions that racks and shapers have in common.
pub(crate) fn check_tool(
    tool: &'static str,
    module: f64,
    pressure_angle: f64,
    tip_radius: f64,
) -> Result<(), GeometryError> {
    if !(module.is_finite() && module > 0.0) {
        return Err(GeometryError::error(
            "E0601",
            "module",
            sentence!["the module of the ", text tool, " is ", length module],
            sentence!["give a positive `module`, or a positive `diametral_pitch`"],
        ));
    }
    let (least, most) = (5.0_f64.to_radians(), 45.0_f64.to_radians());
    if !(least..=most).contains(&pressure_angle) {
        return Err(GeometryError::error(
            "E0602",
            "pressure_angle",
            sentence!["the pressure angle is ", angle pressure_angle, ", not between ", angle least, " and ", angle most],
            sentence!["usual pressure angles are 14.5 deg, 20 deg and 25 deg; is a unit missing?"],
        ));
    }
    if !(tip_radius.is_finite() && tip_radius >= 0.0) {
        return Err(GeometryError::error(
            "E0603",
            "tip_radius",
            sentence!["the tip radius of the ", text tool, " is ", length tip_radius],
            sentence!["give a radius of zero (a sharp corner) or more; ", length 0.3 * module, " (0.3 modules) is usual"],
        ));
    }
    Ok(())
}
