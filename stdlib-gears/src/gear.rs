//! A gear of either kind, and what its teeth are to everything that does not ask how they were cut.

use crate::error::GeometryError;
use crate::external::ExternalGear;
use crate::fillet::{RootFillet, Side};
use crate::internal::InternalGear;
use crate::involute::{involute_of_roll, radius_at_roll, roll_at_radius};
use std::f64::consts::PI;

/// The transverse section of a tooth: two involutes between a root and a tip. SI units; angles in rad.
///
/// Roll angles are counted so that they grow from the root to the tip: on an internal gear they are negative. With that the
/// formulas of flanks are the same for both kinds: the tooth's flanks stand at the polar angles `+-(half_base_angle - inv(roll))`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ToothForm {
    /// Whether the teeth point inwards.
    pub internal: bool,
    /// Number of teeth.
    pub teeth: u32,
    /// Transverse.
    pub module: f64,
    /// Module of the tool in the plane in which the model gives it: the normal module of a rack in
    /// the normal plane.
    pub tool_module: f64,
    /// Transverse, at the pitch circle.
    pub pressure_angle: f64,
    /// Transverse, along the pitch circle.
    pub tooth_thickness: f64,
    /// `teeth * module / 2`.
    pub pitch_radius: f64,
    /// Of the circle whose involutes the flanks are.
    pub base_radius: f64,
    /// Half the angle that the tooth's two involutes enclose at the base circle; it may be negative on an internal gear.
    pub half_base_angle: f64,
    /// Of the circle through the tips: the outer one, or the minor one of an internal gear.
    pub tip_radius: f64,
    /// Of the circle on which the spaces end.
    pub root_radius: f64,
    /// Where the involute begins beside the fillet.
    pub form_radius: f64,
    /// Roll angle there, negative on an internal gear.
    pub form_roll: f64,
    /// Roll angle at the tip circle, negative on an internal gear.
    pub tip_roll: f64,
    /// Rounding of the tip edge.
    pub tip_edge_radius: f64,
}

impl ToothForm {
    /// +1 for teeth that point outwards, -1 for those that point inwards.
    pub fn sense(&self) -> f64 {
        if self.internal { -1.0 } else { 1.0 }
    }

    /// Angle from one tooth to the next.
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

    /// Half the angle that the tooth's flanks enclose at a roll angle.
    pub fn half_angle_at_roll(&self, roll: f64) -> f64 {
        self.half_base_angle - involute_of_roll(roll)
    }

    /// Circular thickness of the tooth at a radius not below the base circle, m.
    pub fn thickness_at(&self, radius: f64) -> f64 {
        2.0 * radius * self.half_angle_at_roll(self.roll_at_radius(radius))
    }

    /// Thickness at the tip circle, between the flanks prolonged, m.
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
            tool_module: gear.rack.own_module(),
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
            tip_edge_radius: gear.tip_edge_radius,
        }
    }
}

impl From<&Gear> for ToothForm {
    fn from(gear: &Gear) -> Self {
        gear.form()
    }
}

/// A gear of either kind.
#[derive(Clone, Debug, PartialEq)]
pub enum Gear {
    /// Teeth that point outwards, cut by a rack.
    External(ExternalGear),
    /// Teeth that point inwards, cut by a shaper.
    Internal(InternalGear),
}

impl Gear {
    /// What its teeth are.
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

    /// The gear, if its teeth point outwards.
    pub fn external(&self) -> Option<&ExternalGear> {
        match self {
            Gear::External(gear) => Some(gear),
            Gear::Internal(_) => None,
        }
    }

    /// The gear, if its teeth point inwards.
    pub fn internal(&self) -> Option<&InternalGear> {
        match self {
            Gear::External(_) => None,
            Gear::Internal(gear) => Some(gear),
        }
    }

    /// What an engineer should know of it.
    pub fn warnings(&self) -> &[GeometryError] {
        match self {
            Gear::External(gear) => &gear.warnings,
            Gear::Internal(gear) => &gear.warnings,
        }
    }

    /// The root of one side of a tooth, from the form circle to the middle of the space.
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
