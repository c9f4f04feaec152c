//! Row of rollers with checked dimensions.

use super::contact_model::ContactModel;
use super::elastic::Elastic;
use super::geometry::{Lamina, RibContact, RollerGeometry, RollerKind};
use crate::ball::Motion;
use crate::error::{RollingError, finite, for_message, positive};
use crate::hertz::line;
use crate::material::composite_modulus;
use std::f64::consts::PI;
use std::sync::Arc;

/// Smallest ratio of length to diameter of a roller.
const SHORTEST: f64 = 0.1;

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
    /// Radii of the middles of the inner and the outer contact, and their axial positions from the
    /// centre of the roller, m.
    pub(crate) raceway_contacts: [[f64; 2]; 2],
    /// Strips of the contact lines in place of the laminae, at this contact model.
    pub(crate) elastic: Option<Arc<Elastic>>,
    /// The row with laminae, if this one has elastic contacts.
    pub(super) plain: Option<Arc<RollerRow>>,
    /// Inverse of the sum of `roller rollerᵀ`, for the first position of a roller.
    pub(crate) start: [[f64; 3]; 3],
}

/// Checks that a raceway is at least as wide as its rollers.
fn check_raceway(ring: &str, width: Option<f64>, length: f64) -> Result<(), RollingError> {
    let Some(width) = width else { return Ok(()) };
    positive(&format!("width of the {ring} raceway"), width)?;
    if width < length {
        return Err(RollingError::input(
            format!(
                "the {ring} raceway has a width of {:.4} mm, less than the rollers of {:.4} mm",
                width * 1e3,
                length * 1e3
            ),
            format!("give a width of at least {:.4} mm, or an effective length of the contact", length * 1e3),
        )
        .of(format!("{ring}_raceway_width")));
    }
    Ok(())
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
        if g.length < SHORTEST * g.roller_diameter {
            return Err(RollingError::input(
                format!("rollers of {:.4} mm x {:.4} mm are discs", g.roller_diameter * 1e3, g.length * 1e3),
                format!("give a roller length of at least {:.4} mm", SHORTEST * g.roller_diameter * 1e3),
            )
            .of("roller_length"));
        }
        for (ring, width) in ["inner", "outer"].into_iter().zip(g.raceway_widths) {
            check_raceway(ring, width, g.length)?;
        }
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
        let shape = geometry.shape(&geometry.laminae_sections())?;
        let mut row = Self {
            laminae: shape.laminae,
            rib: shape.rib,
            coefficient,
            modulus,
            free_axially: matches!(geometry.kind, RollerKind::Cylindrical { .. }),
            cage_ratio: shape.cage_ratio,
            mass_diameter: shape.mass_diameter,
            angles: shape.angles,
            raceway_contacts: shape.raceway_contacts,
            elastic: None,
            plain: None,
            start: [[0.0; 3]; 3],
            geometry,
        };
        row.start = row.start_matrix();
        row.check_interference()?;
        Ok(row)
    }

    /// Returns the row with another model of the contacts of its rollers. Without one, a row has
    /// laminae.
    ///
    /// # Errors
    /// [`RollingError::Input`] if the number of strips is not within 8 and 200.
    pub fn with_contact(self, model: ContactModel) -> Result<Self, RollingError> {
        let mut row = self;
        if let Some(plain) = row.plain.take() {
            row = plain.as_ref().clone();
        }
        let ContactModel::Elastic(settings) = model else { return Ok(row) };
        let elastic = Elastic::new(&row.geometry, row.modulus, settings)?;
        row.plain = Some(Arc::new(row.clone()));
        row.elastic = Some(Arc::new(elastic));
        row.start = row.start_matrix();
        Ok(row)
    }

    /// Returns the model of the contacts of its rollers.
    pub fn contact(&self) -> ContactModel {
        self.elastic.as_ref().map_or(ContactModel::Laminae, |elastic| ContactModel::Elastic(elastic.settings))
    }

    /// Inverts the sum of `roller rollerᵀ` over all contacts.
    fn start_matrix(&self) -> [[f64; 3]; 3] {
        let mut sum = [[0.0; 3]; 3];
        let weight = self.rib_weight();
        let ribs = self.rib.iter().map(|rib| (&rib.roller, weight));
        for (roller, weight) in self.sections().iter().map(|lamina| (&lamina.roller, 1.0)).chain(ribs) {
            for i in 0..3 {
                for j in 0..3 {
                    sum[i][j] += weight * roller[i] * roller[j];
                }
            }
        }
        if self.free_axially {
            sum[1] = [0.0, self.sections().len() as f64, 0.0];
            sum[0][1] = 0.0;
            sum[2][1] = 0.0;
        }
        let mut inverse = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        crate::linear::solve(sum, &mut inverse);
        inverse
    }

    /// Returns the weight of the rib among laminae of weight one in the first position of a roller.
    pub(super) fn rib_weight(&self) -> f64 {
        0.1 * self.sections().len() as f64
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
                    for_message(-clearance * 1e3)
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
