//! Geometry of a row of rollers.

use super::profile::Profile;
use crate::ball::Motion;
use crate::error::{RollingError, finite, positive};
use crate::hertz::line;
use crate::material::{Material, composite_modulus};
use std::f64::consts::{FRAC_PI_2, PI};

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

/// A row of rollers between rigid rings, with checked dimensions.
#[derive(Clone, Debug, PartialEq)]
pub struct RollerRow {
    pub(crate) geometry: RollerGeometry,
    /// Laminae of the inner contact, then those of the outer contact.
    pub(crate) laminae: Vec<Lamina>,
    pub(crate) rib: Option<RibContact>,
    /// Coefficient of one lamina, N/m^{10/9}.
    pub(crate) coefficient: f64,
    pub(crate) modulus: f64,
    /// The roller slides axially without resistance.
    pub(crate) free_axially: bool,
    /// Ratio of the orbital speed to the speed of the inner ring at a fixed outer ring.
    pub(crate) cage_ratio: f64,
    /// Diameter of a cylinder with the mass of the roller, m.
    pub(crate) mass_diameter: f64,
    /// Contact angles of the inner and the outer raceway, rad.
    pub(crate) angles: [f64; 2],
    /// Inverse of the sum of `roller rollerᵀ`, for the first position of a roller.
    pub(crate) start: [[f64; 3]; 3],
}

/// Pressure of ISO 76 at which a line contact has a permanent deformation of 1e-4 of the diameter,
/// Pa.
pub(crate) const STATIC_PRESSURE: f64 = 4e9;

impl RollerRow {
    /// Checks the dimensions and derives the contacts.
    ///
    /// # Errors
    /// [`RollingError::Input`] if the rollers do not fit on the pitch circle, if the cones or ribs
    /// are impossible, or if the interference would indent the raceways.
    pub fn new(geometry: RollerGeometry) -> Result<Self, RollingError> {
        let g = &geometry;
        positive("roller diameter", g.roller_diameter)?;
        positive("roller length", g.length)?;
        positive("pitch diameter", g.pitch_diameter)?;
        g.rings.check()?;
        g.rollers.check()?;
        g.profile.check(g.length)?;
        crate::ball::check_circle("rollers", g.count, g.roller_diameter, g.pitch_diameter)?;
        if !(2..=1000).contains(&g.laminae) {
            return Err(RollingError::input(
                format!("a contact line of {} laminae", g.laminae),
                "give a number of laminae from 2 to 1000; ISO/TS 16281 requires at least 30",
            )
            .of("laminae"));
        }
        let modulus = composite_modulus(&g.rings, &g.rollers);
        let coefficient = line::coefficient(g.length, modulus) / g.laminae as f64;
        let shape = geometry.shape()?;
        let mut row = Self {
            laminae: shape.laminae,
            rib: shape.rib,
            coefficient,
            modulus,
            free_axially: matches!(geometry.kind, RollerKind::Cylindrical { .. }),
            cage_ratio: shape.cage_ratio,
            mass_diameter: shape.mass_diameter,
            angles: shape.angles,
            start: [[0.0; 3]; 3],
            geometry,
        };
        row.start = row.start_matrix();
        row.check_interference()?;
        Ok(row)
    }

    /// Inverts the sum of `roller rollerᵀ` over all contacts.
    fn start_matrix(&self) -> [[f64; 3]; 3] {
        let mut sum = [[0.0; 3]; 3];
        let weight = self.rib_weight();
        let ribs = self.rib.iter().map(|rib| (&rib.roller, weight));
        for (roller, weight) in self.laminae.iter().map(|lamina| (&lamina.roller, 1.0)).chain(ribs) {
            for i in 0..3 {
                for j in 0..3 {
                    sum[i][j] += weight * roller[i] * roller[j];
                }
            }
        }
        if self.free_axially {
            sum[1] = [0.0, self.laminae.len() as f64, 0.0];
            sum[0][1] = 0.0;
            sum[2][1] = 0.0;
        }
        let mut inverse = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        crate::linear::solve(sum, &mut inverse);
        inverse
    }

    /// Returns the weight of the rib among laminae of weight one in the first position of a roller.
    pub(super) fn rib_weight(&self) -> f64 {
        0.1 * self.laminae.len() as f64
    }

    fn check_interference(&self) -> Result<(), RollingError> {
        let clearance = match self.geometry.kind {
            RollerKind::Cylindrical { clearance } | RollerKind::Spherical { clearance, .. } => clearance,
            RollerKind::Tapered { .. } => return Ok(()),
        };
        finite("clearance", clearance)?;
        if clearance >= 0.0 {
            return Ok(());
        }
        // Half of the interference presses each roller, a quarter each contact.
        let approach = 0.25 * -clearance * libm::cos(self.angles[1]);
        let middle = self.geometry.laminae / 2;
        let radius = self.laminae[middle].radius;
        let per_length = self.geometry.laminae as f64 / self.geometry.length;
        let limit = line::load_of_pressure(STATIC_PRESSURE, radius, self.modulus);
        let most = libm::pow(limit / (self.coefficient * per_length), 0.9);
        if approach > most {
            return Err(RollingError::input(
                format!(
                    "an interference of {} mm would indent the raceways: the pressure exceeds 4000 MPa",
                    -clearance * 1e3
                ),
                format!(
                    "reduce the interference to at most {:.4} mm",
                    4e3 * most / libm::cos(self.angles[1])
                ),
            )
            .of("clearance"));
        }
        Ok(())
    }

    /// Returns the diametral clearance, m.
    pub(crate) fn clearance(&self) -> f64 {
        match self.geometry.kind {
            RollerKind::Cylindrical { clearance } | RollerKind::Spherical { clearance, .. } => clearance,
            RollerKind::Tapered { .. } => 0.0,
        }
    }

    /// Returns the dimensions.
    pub fn geometry(&self) -> &RollerGeometry {
        &self.geometry
    }

    /// Returns the contact angles of the inner and the outer raceway, rad.
    pub fn contact_angles(&self) -> [f64; 2] {
        self.angles
    }

    /// Returns the mass of a roller, kg: that of a cylinder of its effective length.
    pub fn roller_mass(&self) -> f64 {
        let d = self.mass_diameter;
        self.geometry.rollers.density * PI / 4.0 * d * d * self.geometry.length
    }

    /// Returns the centrifugal force of a roller that rolls without sliding, N.
    pub fn centrifugal_force(&self, motion: &Motion) -> f64 {
        if let Some(force) = motion.roller_force {
            return force;
        }
        if !motion.has_inertia() {
            return 0.0;
        }
        let speed = motion.orbital_speed(self.cage_ratio);
        0.5 * self.roller_mass() * self.geometry.pitch_diameter * speed * speed
    }
}

/// Checks that a contact angle is positive, or zero if that is allowed, and less than 90°.
pub(super) fn check_angle(angle: f64, zero: bool) -> Result<(), RollingError> {
    if (angle > 0.0 || zero && angle == 0.0) && angle < FRAC_PI_2 {
        return Ok(());
    }
    let least = if zero { "at least" } else { "more than" };
    Err(RollingError::input(
        format!("the contact angle of the roller bearing is {}°", angle.to_degrees()),
        format!("give a contact angle of {least} 0° and less than 90°"),
    )
    .of("contact_angle"))
}
