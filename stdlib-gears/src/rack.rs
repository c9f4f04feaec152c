//! The basic rack, whose teeth cut the gear's spaces by rolling on its pitch circle.

use crate::error::{GeometryError, sentence};
use crate::helix::Helix;
use calyx_abi::math;
use std::f64::consts::PI;

/// The section in which a tool's numbers are given.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Plane {
    /// Across the gear's axis.
    #[default]
    Transverse,
    /// Across the teeth at the pitch circle.
    Normal,
}

impl Plane {
    /// `"transverse"` or `"normal"`.
    pub fn named(name: &str) -> Option<Plane> {
        match name {
            "transverse" => Some(Plane::Transverse),
            "normal" => Some(Plane::Normal),
            _ => None,
        }
    }
}

/// A basic rack with straight flanks and rounded tooth tips. SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rack {
    /// Pitch divided by pi: in the transverse plane the pitch diameter divided by number of teeth, m.
    pub module: f64,
    /// Inclination of the flanks, rad.
    pub pressure_angle: f64,
    /// Rounding of the tooth tip, m. Zero is a sharp corner.
    pub tip_radius: f64,
    /// The section all this is given in.
    pub plane: Plane,
    /// How many times longer the rounding is along the pitch line than [`Self::tip_radius`], which it is across: above 1 in the
    /// transverse section of a rack that is round in its normal section, an ellipse there.
    pub tip_stretch: f64,
}

impl Rack {
    /// A rack in the transverse plane, if its numbers make sense. (Whether the rounding fits depends on the gear that is cut.)
    ///
    /// # Errors
    /// E0601 to E0603.
    pub fn new(module: f64, pressure_angle: f64, tip_radius: f64) -> Result<Self, GeometryError> {
        check_tool("rack", module, pressure_angle, tip_radius)?;
        Ok(Self { module, pressure_angle, tip_radius, plane: Plane::Transverse, tip_stretch: 1.0 })
    }

    /// The rack with its numbers taken as those of another section.
    #[must_use]
    pub fn in_plane(self, plane: Plane) -> Rack {
        Rack { plane, ..self }
    }

    /// The rack as the transverse section of a gear with this helix sees it: exactly, the tip's rounding being an ellipse there if it
    /// is a circle in the normal section.
    #[must_use]
    pub fn transverse(&self, helix: &Helix) -> Rack {
        let cosine = match self.plane {
            Plane::Transverse => return *self,
            Plane::Normal => math::cos(helix.angle()),
        };
        Rack {
            module: self.module / cosine,
            pressure_angle: math::atan(math::tan(self.pressure_angle) / cosine),
            tip_radius: self.tip_radius,
            plane: Plane::Transverse,
            tip_stretch: self.tip_stretch / cosine,
        }
    }

    /// The module in the plane that the rack was given in: of a rack that was given in the normal
    /// plane and is seen in the transverse one, the normal module, as the tip is stretched by `1 /
    /// cos(helix angle)` there. Profile shift coefficients count these modules.
    pub fn own_module(&self) -> f64 {
        self.module / self.tip_stretch
    }

    /// A thickness given in the rack's plane as it is in the transverse section, m.
    pub fn transverse_thickness(&self, thickness: f64, helix: &Helix) -> f64 {
        match self.plane {
            Plane::Transverse => thickness,
            Plane::Normal => thickness / math::cos(helix.angle()),
        }
    }

    /// Pitch, from one tooth to the next, m.
    pub fn pitch(&self) -> f64 {
        PI * self.module
    }

    /// Thickness at the pitch circle of a gear cut with a profile shift, `m (pi/2 + 2 x tan(alpha))`, m.
    pub fn thickness_of_shift(&self, profile_shift: f64) -> f64 {
        self.module * (0.5 * PI + 2.0 * profile_shift * math::tan(self.pressure_angle))
    }

    /// The inverse of [`Rack::thickness_of_shift`].
    pub fn shift_of_thickness(&self, tooth_thickness: f64) -> f64 {
        (tooth_thickness / self.module - 0.5 * PI) / (2.0 * math::tan(self.pressure_angle))
    }

    /// Distance from the centre of the tip's rounding to its tangent whose normal is inclined by `inclination` to the pitch
    /// line, m.
    pub(crate) fn tip_support(&self, inclination: f64) -> f64 {
        let (sine, cosine) = math::sincos(inclination);
        if self.tip_stretch == 1.0 {
            return self.tip_radius;
        }
        self.tip_radius * (self.tip_stretch * cosine).hypot(sine)
    }

    /// Depth below that centre of the point where this tangent touches the rounding, m.
    pub(crate) fn tip_touch_depth(&self, inclination: f64) -> f64 {
        let (sine, cosine) = math::sincos(inclination);
        if self.tip_stretch == 1.0 {
            return self.tip_radius * sine;
        }
        self.tip_radius * sine / (self.tip_stretch * cosine).hypot(sine)
    }
}

/// What racks and shapers have in common.
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
