//! Geometry of a row of rollers.

use super::profile::Profile;
use crate::error::{RollingError, for_message};
use crate::material::Material;
use std::f64::consts::FRAC_PI_2;

/// Form of the rollers and raceways.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum RollerKind {
    /// Cylindrical rollers or needles, free in the axial direction.
    Cylindrical {
        /// Diametral clearance, m; interference is negative.
        clearance: f64,
    },
    /// Tapered rollers whose large end is supported by a rib of the inner ring. The apex of the
    /// cones is on +z, so that a displacement of the inner ring to +z loads the bearing.
    Tapered {
        /// Contact angle of the outer raceway, rad.
        outer_angle: f64,
        /// Rib of the inner ring.
        rib: Rib,
    },
    /// One row of barrel-shaped rollers in a spherical outer raceway, whose centre is on the axis
    /// at `z = -pitch_diameter/2 tan(angle)` from the roller centres.
    Spherical {
        /// Contact angle, rad.
        angle: f64,
        /// Profile radius of the roller divided by the radius of the outer sphere, less than 1.
        outer_osculation: f64,
        /// Profile radius of the roller divided by that of the inner raceway, less than 1.
        inner_osculation: f64,
        /// Diametral clearance, m; interference is negative.
        clearance: f64,
    },
}

/// Rib at the large end of tapered rollers: the spherical end of the roller touches a surface that
/// is locally flat. Friction is neglected.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rib {
    /// Radius of the spherical end of the roller, m.
    pub end_radius: f64,
    /// Distance of the contact from the roller axis towards the bearing axis, m.
    pub height: f64,
}

/// Dimensions of a row of rollers.
#[derive(Clone, Debug, PartialEq)]
pub struct RollerGeometry {
    /// Form of the rollers.
    pub kind: RollerKind,
    /// Number of rollers.
    pub count: usize,
    /// Roller diameter at mid-length, normal to the roller axis, m.
    pub roller_diameter: f64,
    /// Effective length of the contact lines, m.
    pub length: f64,
    /// Widths of the inner and the outer raceway along the contact lines, m, with the rollers in
    /// their middle; `None` for a raceway that extends far beyond the rollers. Elastic contacts
    /// depend on them, and laminae do not.
    pub raceway_widths: [Option<f64>; 2],
    /// Pitch diameter of the roller centres, m.
    pub pitch_diameter: f64,
    /// Profile of the rollers, on both contacts.
    pub profile: Profile,
    /// Number of laminae per contact; ISO/TS 16281 requires at least 30.
    pub laminae: usize,
    /// Material of the rings.
    pub rings: Material,
    /// Material of the rollers.
    pub rollers: Material,
}

/// One lamina of a contact line. Its approach is `ring·u - relief + roller·w`, with the
/// displacements u of the ring and w of the roller; zero `ring` for contacts with the outer ring.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Lamina {
    pub ring: [f64; 3],
    pub roller: [f64; 3],
    pub relief: f64,
    /// Position along the contact line, m.
    pub position: f64,
    /// Effective radius in the normal section, m.
    pub radius: f64,
}

/// Contact of the roller end with the rib: load `stiffness δ^{3/2}`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct RibContact {
    pub ring: [f64; 3],
    pub roller: [f64; 3],
    pub stiffness: f64,
}

/// Checks that a contact angle is positive, or zero if that is allowed, and less than 90°.
pub(super) fn check_angle(angle: f64, zero: bool) -> Result<(), RollingError> {
    if (angle > 0.0 || zero && angle == 0.0) && angle < FRAC_PI_2 {
        return Ok(());
    }
    let least = if zero { "at least" } else { "more than" };
    Err(RollingError::input(
        format!("the contact angle of the roller bearing is {}°", for_message(angle.to_degrees())),
        format!("give a contact angle of {least} 0° and less than 90°"),
    )
    .of("contact_angle"))
}
