//! Geometry of a row of balls.

use crate::error::{RollingError, finite, for_message, positive};
use crate::hertz::point::PointContact;
use crate::material::{Material, composite_modulus};
use crate::raceway::Ring;
use libm::{acos, cos, sin};
use std::f64::consts::{FRAC_PI_2, PI};

/// Groove geometry of a ball bearing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum BallKind {
    /// Symmetric grooves. Each ring can move radially by half of the diametral clearance to either
    /// side; interference is negative.
    DeepGroove {
        /// Diametral clearance, m.
        clearance: f64,
    },
    /// Grooves with one contact each at a contact angle. The unloaded balls just touch both rings.
    AngularContact {
        /// Contact angle, rad.
        angle: f64,
    },
    /// Two arcs per ring. At zero clearance, the balls of the centred bearing touch all four arcs
    /// at the contact angle.
    FourPoint {
        /// Contact angle, rad.
        angle: f64,
        /// Diametral clearance, m; interference is negative.
        clearance: f64,
    },
}

/// Dimensions of a row of balls.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BallGeometry {
    /// Groove geometry.
    pub kind: BallKind,
    /// Number of balls.
    pub count: usize,
    /// Ball diameter D, m.
    pub ball_diameter: f64,
    /// Pitch diameter of the ball centres, m.
    pub pitch_diameter: f64,
    /// Groove radius of the inner ring divided by the ball diameter, more than 0.5.
    pub inner_conformity: f64,
    /// Groove radius of the outer ring divided by the ball diameter, more than 0.5.
    pub outer_conformity: f64,
    /// Material of the rings.
    pub rings: Material,
    /// Material of the balls.
    pub balls: Material,
}

/// One of the grooves: its centre of curvature in the axial plane of a ball.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Groove {
    /// Radial and axial position of the centre of curvature of the centred bearing from the pitch
    /// circle, m. Positions on the scale of the grooves keep more digits than radii.
    pub center: [f64; 2],
    /// Distance between the centres of groove and ball at a contact without load, m.
    pub free: f64,
    /// Coefficient A of the gap across the groove, 1/m.
    pub curvature: f64,
    /// The groove is on the inner ring.
    pub inner: bool,
}

/// A row of balls between rigid rings, with checked dimensions.
#[derive(Clone, Debug, PartialEq)]
pub struct BallRow {
    pub(crate) geometry: BallGeometry,
    pub(crate) grooves: Vec<Groove>,
    pub(crate) modulus: f64,
    pub(crate) free_angle: f64,
}

/// Pressure of ISO 76 at which a ball contact has a permanent deformation of 1e-4 of the diameter,
/// Pa.
pub(crate) const STATIC_PRESSURE: f64 = 4.2e9;

impl BallRow {
    /// Checks the dimensions and derives the grooves.
    ///
    /// # Errors
    /// [`RollingError::Input`] if the balls do not fit on the pitch circle, if a groove is not
    /// wider than the ball, if the clearance leaves no contact, or if the interference would indent
    /// the raceways.
    pub fn new(geometry: BallGeometry) -> Result<Self, RollingError> {
        let g = &geometry;
        positive("ball diameter", g.ball_diameter)?;
        positive("pitch diameter", g.pitch_diameter)?;
        g.rings.check()?;
        g.balls.check()?;
        check_circle("balls", g.count, g.ball_diameter, g.pitch_diameter)?;
        for (ring, conformity) in [("inner", g.inner_conformity), ("outer", g.outer_conformity)] {
            if !(conformity > 0.5 && conformity < 1.0) {
                return Err(RollingError::input(
                    format!(
                        "the {ring} groove has the conformity {conformity}: its radius must exceed the radius of the ball"
                    ),
                    format!(
                        "give a conformity of the {ring} groove between 0.5 and 1; usual is 0.51 to 0.53"
                    ),
                )
.of(format!("{ring}_conformity")));
            }
        }
        let (angle, clearance) = g.kind.angle_and_clearance();
        finite("clearance", clearance)?;
        if !(0.0..FRAC_PI_2).contains(&angle) {
            return Err(RollingError::input(
                format!("the contact angle of the ball bearing is {}°", for_message(angle.to_degrees())),
                "give a contact angle of at least 0° and less than 90°",
            )
            .of("contact_angle"));
        }
        let row = Self::build(geometry, angle, clearance)?;
        row.check_interference(clearance)?;
        Ok(row)
    }

    fn build(geometry: BallGeometry, angle: f64, clearance: f64) -> Result<Self, RollingError> {
        let diameter = geometry.ball_diameter;
        let reach = [geometry.inner_conformity, geometry.outer_conformity].map(|f| (f - 0.5) * diameter);
        let spread = reach[0] + reach[1];
        if clearance >= 2.0 * spread * cos(angle) {
            return Err(RollingError::input(
                format!(
                    "with a clearance of {} mm, the balls cannot touch both grooves",
                    for_message(clearance * 1e3)
                ),
                format!("reduce the clearance to less than {:.4} mm", 2e3 * spread * cos(angle)),
            )
            .of("clearance"));
        }
        let groove = |inner: bool, side: f64| {
            let (sign, conformity) =
                if inner { (1.0, geometry.inner_conformity) } else { (-1.0, geometry.outer_conformity) };
            let free = reach[usize::from(!inner)];
            Groove {
                center: [sign * (free * cos(angle) - 0.25 * clearance), sign * side * free * sin(angle)],
                free,
                curvature: (1.0 - 0.5 / conformity) / diameter,
                inner,
            }
        };
        let grooves = match geometry.kind {
            BallKind::FourPoint { .. } => {
                vec![groove(true, 1.0), groove(true, -1.0), groove(false, 1.0), groove(false, -1.0)]
            }
            _ => vec![groove(true, 1.0), groove(false, 1.0)],
        };
        let free_angle = match geometry.kind {
            BallKind::DeepGroove { clearance } if clearance > 0.0 => acos(1.0 - 0.5 * clearance / spread),
            _ => angle,
        };
        let modulus = composite_modulus(&geometry.rings, &geometry.balls);
        Ok(Self { geometry, grooves, modulus, free_angle })
    }

    /// Returns the ratio of the orbital speed to the speed of the inner ring at a fixed outer ring,
    /// for rolling at the contact angle without load.
    pub(crate) fn cage_ratio(&self) -> f64 {
        self.cage_ratio_at(self.free_angle)
    }

    /// Returns the same ratio for rolling at the contact angle of the drawing: 0 for deep grooves.
    pub(crate) fn orbit_ratio(&self) -> f64 {
        self.cage_ratio_at(self.geometry.kind.angle_and_clearance().0)
    }

    fn cage_ratio_at(&self, angle: f64) -> f64 {
        0.5 * (1.0 - self.geometry.ball_diameter / self.geometry.pitch_diameter * cos(angle))
    }

    /// Rejects an interference whose pressure in the centred bearing exceeds the limit of ISO 76.
    fn check_interference(&self, clearance: f64) -> Result<(), RollingError> {
        if clearance >= 0.0 {
            return Ok(());
        }
        // Each side of the ring presses the ball by half of the interference, times the cosine of
        // the angle of the contacts; the inner contact has the larger pressure.
        let angle = self.geometry.kind.angle_and_clearance().0;
        let inner = self.contact(&self.grooves[0], cos(angle));
        let outer = self.contact(&self.grooves[self.grooves.len() / 2], cos(angle));
        let compliance = inner.compliance() + outer.compliance();
        let limit = inner.load_of_pressure(STATIC_PRESSURE);
        let allowed = 2.0 * compliance * libm::pow(limit, 2.0 / 3.0) / cos(angle);
        if -clearance > allowed {
            return Err(RollingError::input(
                format!(
                    "an interference of {} mm would indent the raceways: the pressure exceeds 4200 MPa",
                    for_message(-clearance * 1e3)
                ),
                format!("reduce the interference to at most {:.4} mm", allowed * 1e3),
            )
            .of("clearance"));
        }
        Ok(())
    }

    /// Returns the radius of the contact with the raceway of a ring and its axial position from the
    /// centre of the ball, m, and the contact angle (rad). The two contacts of four-point bearings,
    /// and those of deep grooves under load of either sense, have the bottom of the groove between
    /// them.
    pub(crate) fn raceway_contact(&self, ring: Ring) -> ([f64; 2], f64) {
        let outwards = if ring == Ring::Outer { 0.5 } else { -0.5 };
        let (pitch, radius) = (0.5 * self.geometry.pitch_diameter, outwards * self.geometry.ball_diameter);
        match self.geometry.kind {
            BallKind::AngularContact { angle } => ([pitch + radius * cos(angle), radius * sin(angle)], angle),
            BallKind::DeepGroove { .. } | BallKind::FourPoint { .. } => ([pitch + radius, 0.0], 0.0),
        }
    }

    /// Returns the dimensions.
    pub fn geometry(&self) -> &BallGeometry {
        &self.geometry
    }

    /// Returns the contact angle of the unloaded bearing whose inner ring is pushed axially, rad.
    pub fn free_contact_angle(&self) -> f64 {
        self.free_angle
    }

    /// Returns the Hertz contact of a groove at a contact angle of this cosine.
    pub(crate) fn contact(&self, groove: &Groove, cosine: f64) -> PointContact {
        PointContact::new(groove.curvature, self.rolling_curvature(groove, cosine), self.modulus)
    }

    /// Returns the coefficient B of the gap in the rolling direction, 1/m.
    pub(crate) fn rolling_curvature(&self, groove: &Groove, cosine: f64) -> f64 {
        let diameter = self.geometry.ball_diameter;
        let ratio = diameter * cosine / self.geometry.pitch_diameter;
        1.0 / (diameter * if groove.inner { 1.0 - ratio } else { 1.0 + ratio })
    }

    /// Returns the derivative of [`BallRow::rolling_curvature`] with respect to the cosine, 1/m.
    pub(crate) fn rolling_curvature_by_cosine(&self, groove: &Groove, curvature: f64) -> f64 {
        let diameter = self.geometry.ball_diameter;
        let slope = diameter * diameter / self.geometry.pitch_diameter * curvature * curvature;
        if groove.inner { slope } else { -slope }
    }

    /// Returns the diametral clearance, m.
    pub(crate) fn clearance(&self) -> f64 {
        self.geometry.kind.angle_and_clearance().1
    }

    /// Returns the mass of a ball, kg.
    pub fn ball_mass(&self) -> f64 {
        let d = self.geometry.ball_diameter;
        self.geometry.balls.density * PI / 6.0 * d * d * d
    }
}

impl BallKind {
    /// Returns the contact angle, rad, and the diametral clearance, m.
    fn angle_and_clearance(self) -> (f64, f64) {
        match self {
            Self::DeepGroove { clearance } => (0.0, clearance),
            Self::AngularContact { angle } => (angle, 0.0),
            Self::FourPoint { angle, clearance } => (angle, clearance),
        }
    }
}

/// Checks that elements of a diameter fit next to each other on a circle.
pub(crate) fn check_circle(
    elements: &str,
    count: usize,
    diameter: f64,
    pitch_diameter: f64,
) -> Result<(), RollingError> {
    if count == 0 || count > 10_000 {
        return Err(RollingError::input(
            format!("the bearing has {count} {elements} per row"),
            format!("give a number of {elements} from 1 to 10000"),
        )
        .of("count"));
    }
    if diameter >= pitch_diameter {
        return Err(RollingError::input(
            format!(
                "{elements} of {:.4} mm leave no space for the inner ring at a pitch diameter of {:.4} mm",
                diameter * 1e3,
                pitch_diameter * 1e3
            ),
            "reduce the diameter of the rolling elements or enlarge the pitch diameter",
        )
        .of("pitch_diameter"));
    }
    let spacing = pitch_diameter * sin(PI / count as f64);
    if count > 1 && spacing < diameter {
        let most = (PI / libm::asin(diameter / pitch_diameter)).floor();
        return Err(RollingError::input(
            format!(
                "{count} {elements} of {:.4} mm do not fit on a pitch circle of {:.4} mm",
                diameter * 1e3,
                pitch_diameter * 1e3
            ),
            format!(
                "reduce the number of {elements} to at most {most}, or their diameter to {:.4} mm",
                spacing * 1e3
            ),
        )
        .of("count"));
    }
    Ok(())
}
