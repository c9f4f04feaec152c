//! External and internal gears behind one interface, independent of the tool that generates them.

use crate::error::GeometryError;
use crate::external::ExternalGear;
use crate::fillet::{RootFillet, Side};
use crate::internal::InternalGear;
use crate::involute::{involute_of_roll, radius_at_roll, roll_at_radius};
use std::f64::consts::PI;

/// Transverse section of a tooth: two involutes between root and tip. SI units; angles in rad.
///
/// Roll angles increase from the root to the tip, so on an internal gear they are negative. With
/// this convention the flank formulas are the same for both kinds of gear: the flanks lie at the
/// polar angles `+-(half_base_angle - inv(roll))`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ToothForm {
    /// True for an internal gear.
    pub internal: bool,
    /// Number of teeth.
    pub teeth: u32,
    /// Transverse module.
    pub module: f64,
    /// Module of the tool in the plane in which the model gives it; the normal module for a rack in
    /// the normal plane.
    pub tool_module: f64,
    /// Transverse pressure angle at the pitch circle.
    pub pressure_angle: f64,
    /// Transverse tooth thickness, an arc of the pitch circle.
    pub tooth_thickness: f64,
    /// Pitch radius, `teeth * module / 2`.
    pub pitch_radius: f64,
    /// Base radius.
    pub base_radius: f64,
    /// Half the angle between the two involutes of a tooth at the base circle. On an internal gear
    /// it may be negative.
    pub half_base_angle: f64,
    /// Tip radius: the outer radius, or the minor radius of an internal gear.
    pub tip_radius: f64,
    /// Root radius.
    pub root_radius: f64,
    /// Form radius, at which the involute meets the fillet.
    pub form_radius: f64,
    /// Roll angle at the form circle, negative on an internal gear.
    pub form_roll: f64,
    /// Roll angle at the tip circle, negative on an internal gear.
    pub tip_roll: f64,
    /// Roll angle at the tip form circle, negative on an internal gear: at a stated tip edge,
    /// otherwise at the tip circle.
    pub tip_form_roll: f64,
    /// Radius of the rounded tip edge.
    pub tip_edge_radius: f64,
}

impl ToothForm {
    /// +1 for an external gear, -1 for an internal gear.
    pub fn sense(&self) -> f64 {
        if self.internal { -1.0 } else { 1.0 }
    }

    /// Angular pitch, the angle between adjacent teeth.
    pub fn pitch_angle(&self) -> f64 {
        2.0 * PI / f64::from(self.teeth)
    }

    /// Roll angle at a radius (m), negative on an internal gear; 0 below the base circle.
    pub fn roll_at_radius(&self, radius: f64) -> f64 {
        self.sense() * roll_at_radius(self.base_radius, radius)
    }

    /// Radius at a roll angle, m.
    pub fn radius_at_roll(&self, roll: f64) -> f64 {
        radius_at_roll(self.base_radius, roll)
    }

    /// Half the angle between the flanks of a tooth at a roll angle.
    pub fn half_angle_at_roll(&self, roll: f64) -> f64 {
        self.half_base_angle - involute_of_roll(roll)
    }

    /// Circular thickness of the tooth at a radius not below the base circle, m.
    pub fn thickness_at(&self, radius: f64) -> f64 {
        2.0 * radius * self.half_angle_at_roll(self.roll_at_radius(radius))
    }

    /// Tooth thickness at the tip circle between the extended flanks, m.
    pub fn tip_thickness(&self) -> f64 {
        self.thickness_at(self.tip_radius)
    }
}

impl From<&ExternalGear> for ToothForm {
    fn from(gear: &ExternalGear) -> Self {
        ToothForm {
            internal: false,
            teeth: gear.teeth,
            module: gear.rack.module,
            tool_module: gear.rack.tool_module(),
            pressure_angle: gear.rack.pressure_angle,
            tooth_thickness: gear.tooth_thickness,
            pitch_radius: gear.pitch_radius,
            base_radius: gear.base_radius,
            half_base_angle: gear.half_base_angle,
            tip_radius: gear.outer_radius,
            root_radius: gear.root_radius,
            form_radius: gear.form_radius,
            form_roll: gear.form_roll,
            tip_roll: gear.tip_roll,
            tip_form_roll: gear.tip_form_roll,
            tip_edge_radius: gear.tip_edge_radius,
        }
    }
}

impl From<&InternalGear> for ToothForm {
    fn from(gear: &InternalGear) -> Self {
        ToothForm {
            internal: true,
            teeth: gear.teeth,
            module: gear.shaper.module,
            tool_module: gear.shaper.module,
            pressure_angle: gear.shaper.pressure_angle,
            tooth_thickness: gear.tooth_thickness,
            pitch_radius: gear.pitch_radius,
            base_radius: gear.base_radius,
            half_base_angle: gear.half_base_angle(),
            tip_radius: gear.minor_radius,
            root_radius: gear.root_radius,
            form_radius: gear.form_radius,
            form_roll: -gear.form_roll,
            tip_roll: -gear.tip_roll,
            tip_form_roll: -gear.tip_form_roll,
            tip_edge_radius: gear.tip_edge_radius,
        }
    }
}

impl From<&Gear> for ToothForm {
    fn from(gear: &Gear) -> Self {
        gear.form()
    }
}

/// External or internal gear.
#[derive(Clone, Debug, PartialEq)]
pub enum Gear {
    /// Gear with external teeth, generated by a rack.
    External(ExternalGear),
    /// Gear with internal teeth, generated by a shaper cutter.
    Internal(InternalGear),
}

impl Gear {
    /// Returns the transverse section of the teeth.
    pub fn form(&self) -> ToothForm {
        match self {
            Gear::External(gear) => gear.into(),
            Gear::Internal(gear) => gear.into(),
        }
    }

    /// Number of teeth.
    pub fn teeth(&self) -> u32 {
        match self {
            Gear::External(gear) => gear.teeth,
            Gear::Internal(gear) => gear.teeth,
        }
    }

    /// Returns the external gear, if it is one.
    pub fn external(&self) -> Option<&ExternalGear> {
        match self {
            Gear::External(gear) => Some(gear),
            Gear::Internal(_) => None,
        }
    }

    /// Returns the internal gear, if it is one.
    pub fn internal(&self) -> Option<&InternalGear> {
        match self {
            Gear::External(_) => None,
            Gear::Internal(gear) => Some(gear),
        }
    }

    /// Warnings about the gear's geometry.
    pub fn warnings(&self) -> &[GeometryError] {
        match self {
            Gear::External(gear) => &gear.warnings,
            Gear::Internal(gear) => &gear.warnings,
        }
    }

    /// Returns the root of one side of a tooth, from the form circle to the middle of the tooth
    /// space.
    pub fn root_fillet(&self, side: Side) -> RootFillet {
        match self {
            Gear::External(gear) => gear.root_fillet(side),
            Gear::Internal(gear) => gear.root_fillet(side),
        }
    }
}

impl From<ExternalGear> for Gear {
    fn from(gear: ExternalGear) -> Self {
        Gear::External(gear)
    }
}

impl From<InternalGear> for Gear {
    fn from(gear: InternalGear) -> Self {
        Gear::Internal(gear)
    }
}
