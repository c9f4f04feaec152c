//! Contact lines of cylindrical, tapered and spherical rollers.

use super::geometry::{Lamina, Rib, RibContact, RollerGeometry, RollerKind, check_angle};
use crate::error::{RollingError, finite, for_message, positive};
use crate::material::composite_modulus;
use calyx_numerics::quadrature::gauss_legendre;
use libm::{cos, sin, tan};

/// Contacts of a roller and what depends on the form of the rollers.
pub(super) struct Shape {
    pub laminae: Vec<Lamina>,
    pub rib: Option<RibContact>,
    pub cage_ratio: f64,
    pub mass_diameter: f64,
    pub angles: [f64; 2],
    /// Radii of the middles of the inner and the outer contact, and their axial positions, m.
    pub raceway_contacts: [[f64; 2]; 2],
}

/// Section of a contact line: a point, or an interval over which the relief is averaged.
#[derive(Clone, Copy, Debug)]
pub(super) struct Section {
    /// Middle, m.
    pub position: f64,
    /// Length of the interval, m; zero for a point.
    pub length: f64,
}

/// Surface element of a contact in the axial plane of the roller.
struct Spot {
    /// Radius and axial position, m.
    point: [f64; 2],
    /// Unit normal from the inner to the outer ring.
    normal: [f64; 2],
    relief: f64,
    radius: f64,
}

impl RollerGeometry {
    /// Derives the contacts of a roller at the sections of each contact line.
    pub(super) fn shape(&self, sections: &[Section]) -> Result<Shape, RollingError> {
        match self.kind {
            RollerKind::Cylindrical { clearance } => {
                finite("clearance", clearance)?;
                Ok(self.cylindrical(sections, clearance))
            }
            RollerKind::Tapered { outer_angle, rib } => self.tapered(sections, outer_angle, rib),
            RollerKind::Spherical { angle, outer_osculation, inner_osculation, clearance } => {
                self.spherical(sections, angle, [inner_osculation, outer_osculation], clearance)
            }
        }
    }

    /// Returns the middles of the laminae of a contact line.
    pub(super) fn laminae_sections(&self) -> Vec<Section> {
        let middle = |k| self.length * ((k as f64 + 0.5) / self.laminae as f64 - 0.5);
        (0..self.laminae).map(|k| Section { position: middle(k), length: 0.0 }).collect()
    }

    /// Collects the sections of both contacts; `spot` gives the contact point at a position of the
    /// inner or outer contact.
    fn contacts(&self, sections: &[Section], spot: impl Fn(f64, bool) -> Spot) -> Vec<Lamina> {
        let mut laminae = Vec::with_capacity(2 * sections.len());
        for inner in [true, false] {
            for &Section { position, length } in sections {
                let Spot { point, normal, relief, radius } = spot(position, inner);
                let relief = if length > 0.0 {
                    let at = |(x, weight)| 0.5 * weight * spot(position + 0.5 * length * x, inner).relief;
                    gauss_legendre(4).into_iter().map(at).sum()
                } else {
                    relief
                };
                let roller = self.roller_approach(point, normal);
                let ring = if inner { ring_approach(point, normal) } else { [0.0; 3] };
                let sign = if inner { -1.0 } else { 1.0 };
                laminae.push(Lamina { ring, roller: roller.map(|x| sign * x), relief, position, radius });
            }
        }
        laminae
    }

    /// Returns the motion of a point of the roller along a normal for radial and axial displacement
    /// and for rotation from radial to axial.
    fn roller_approach(&self, point: [f64; 2], normal: [f64; 2]) -> [f64; 3] {
        let arm = [point[0] - 0.5 * self.pitch_diameter, point[1]];
        [normal[0], normal[1], arm[0] * normal[1] - arm[1] * normal[0]]
    }

    fn relief(&self, position: f64) -> f64 {
        self.profile.relief(position, self.length, self.roller_diameter)
    }

    fn cylindrical(&self, sections: &[Section], clearance: f64) -> Shape {
        let radius = 0.5 * self.roller_diameter;
        let pitch = 0.5 * self.pitch_diameter;
        let laminae = self.contacts(sections, |position, inner| {
            let side = if inner { -1.0 } else { 1.0 };
            Spot {
                point: [pitch + side * radius, -position],
                normal: [1.0, 0.0],
                relief: self.relief(position) + if inner { 0.5 * clearance } else { 0.0 },
                radius: 1.0 / (1.0 / radius - side / (pitch + side * radius)),
            }
        });
        let ratio = self.roller_diameter / self.pitch_diameter;
        Shape {
            laminae,
            rib: None,
            cage_ratio: 0.5 * (1.0 - ratio),
            mass_diameter: self.roller_diameter,
            angles: [0.0; 2],
            raceway_contacts: [[pitch - radius, 0.0], [pitch + radius, 0.0]],
        }
    }

    /// Cones of both raceways and of the rollers with a common apex on the bearing axis, at
    /// distance l from the roller centre.
    fn tapered(&self, sections: &[Section], outer_angle: f64, rib: Rib) -> Result<Shape, RollingError> {
        check_angle(outer_angle, false)?;
        positive("radius of the roller end", rib.end_radius)?;
        let pitch = 0.5 * self.pitch_diameter;
        let taper = self.half_taper(outer_angle);
        let axis = outer_angle - taper;
        if axis - taper <= 0.0 {
            return Err(RollingError::input(
                format!(
                    "tapered rollers of {:.4} mm at a contact angle of {:.4}° leave no cone for the inner ring",
                    self.roller_diameter * 1e3,
                    outer_angle.to_degrees()
                ),
                "reduce the roller diameter or enlarge the contact angle or pitch diameter",
            )
.of("roller_diameter"));
        }
        let apex = pitch / sin(axis);
        let slant = apex * cos(taper);
        if 0.5 * self.length >= slant {
            return Err(RollingError::input(
                "the tapered rollers extend beyond the apex of their cones",
                "reduce the roller length or the contact angle",
            )
            .of("roller_length"));
        }
        let (apex_z, angles) = (apex * cos(axis), [axis - taper, outer_angle]);
        let laminae = self.contacts(sections, |position, inner| {
            let angle = angles[usize::from(!inner)];
            let along = slant + position;
            let race = along * tan(angle);
            let curvature = 1.0 / (apex * sin(taper) * along / slant);
            Spot {
                point: [along * sin(angle), apex_z - along * cos(angle)],
                normal: [cos(angle), sin(angle)],
                relief: self.relief(position),
                radius: 1.0 / (curvature + if inner { 1.0 / race } else { -1.0 / race }),
            }
        });
        Ok(Shape {
            laminae,
            rib: Some(self.rib_contact(axis, rib)?),
            cage_ratio: 0.5 * (1.0 - tan(taper) / tan(axis)),
            mass_diameter: self.roller_diameter,
            angles,
            raceway_contacts: angles.map(|angle| [slant * sin(angle), apex_z - slant * cos(angle)]),
        })
    }

    /// Solves tan ε = D sin(α - ε) / dₘ for the half taper angle ε of the roller.
    fn half_taper(&self, outer_angle: f64) -> f64 {
        let ratio = self.roller_diameter / self.pitch_diameter;
        let mut taper = ratio * sin(outer_angle) / (1.0 + ratio * cos(outer_angle));
        // The residual increases with ε, and Newton's method converges in three steps.
        for _ in 0..20 {
            let tangent = tan(taper);
            let slope = 1.0 + tangent * tangent + ratio * cos(outer_angle - taper);
            let step = (tangent - ratio * sin(outer_angle - taper)) / slope;
            taper -= step;
            if step.abs() < 1e-16 {
                break;
            }
        }
        taper
    }

    fn rib_contact(&self, axis: f64, rib: Rib) -> Result<RibContact, RollingError> {
        if rib.height.is_nan() || rib.height.abs() >= 0.5 * self.roller_diameter {
            return Err(RollingError::input(
                format!(
                    "the rib touches the roller end {} mm from its axis, outside the end",
                    for_message(rib.height * 1e3)
                ),
                format!("give a height of at most {:.4} mm", 0.45e3 * self.roller_diameter),
            )
            .of("rib_height"));
        }
        if rib.end_radius <= 0.5 * self.roller_diameter {
            return Err(RollingError::input(
                format!(
                    "the roller end has a radius of {} mm, less than that of the roller",
                    for_message(rib.end_radius * 1e3)
                ),
                "give a larger radius of the roller end, usually 0.9 of the distance to the apex",
            )
            .of("rib_end_radius"));
        }
        // Unit vectors: along the roller axis to the large end, and across it, outwards.
        let along = [sin(axis), -cos(axis)];
        let across = [cos(axis), sin(axis)];
        let sine = rib.height / rib.end_radius;
        let cosine = (1.0 - sine * sine).sqrt();
        let to_contact = [0, 1].map(|k| along[k] * cosine - across[k] * sine);
        let back = 0.5 * self.length - rib.end_radius;
        let center = [0.5 * self.pitch_diameter + back * along[0], back * along[1]];
        let point = [0, 1].map(|k| center[k] + rib.end_radius * to_contact[k]);
        let normal = to_contact.map(|x| -x);
        Ok(RibContact {
            ring: ring_approach(point, normal),
            roller: self.roller_approach(point, normal).map(|x| -x),
            stiffness: 4.0 / 3.0 * composite_modulus(&self.rings, &self.rollers) * rib.end_radius.sqrt(),
        })
    }

    fn spherical(
        &self,
        sections: &[Section],
        angle: f64,
        osculation: [f64; 2],
        clearance: f64,
    ) -> Result<Shape, RollingError> {
        check_angle(angle, true)?;
        finite("clearance", clearance)?;
        for (ring, osculation) in ["inner", "outer"].into_iter().zip(osculation) {
            if !(osculation > 0.5 && osculation < 1.0) {
                return Err(RollingError::input(
                    format!("the {ring} osculation of the spherical rollers is {osculation}"),
                    "give a ratio of roller to raceway radius between 0.5 and 1; usual is 0.96 to 0.99",
                )
                .of(format!("{ring}_osculation")));
            }
        }
        let pitch = 0.5 * self.pitch_diameter;
        let radius = 0.5 * self.roller_diameter;
        let sphere = pitch / cos(angle) + radius;
        let profile = osculation[1] * sphere;
        let race = profile / osculation[0];
        if 0.5 * self.length >= 0.9 * profile {
            return Err(RollingError::input(
                "the spherical rollers are longer than their profile permits",
                format!("reduce the roller length to less than {:.4} mm", 1.8e3 * profile),
            )
            .of("roller_length"));
        }
        let normal = [cos(angle), sin(angle)];
        let tangent = [sin(angle), -cos(angle)];
        let ring_radius = (pitch - radius * cos(angle)) / cos(angle);
        let laminae = self.contacts(sections, |position, inner| {
            // Both contact lines are arcs; the normal of the inner one points to the centre of the
            // arc.
            let (arc, bend, offset) = if inner { (race, -1.0, -radius) } else { (sphere, 1.0, radius) };
            let (sine, cosine) = (sin(position / arc), cos(position / arc));
            let sag = -bend * arc * (1.0 - cosine);
            let crown = 0.5 * position * position * (1.0 / profile - 1.0 / arc);
            Spot {
                point: [0, 1].map(|k| [pitch, 0.0][k] + (offset + sag) * normal[k] + arc * sine * tangent[k]),
                normal: [0, 1].map(|k| cosine * normal[k] + bend * sine * tangent[k]),
                relief: self.relief(position)
                    + crown
                    + if inner { 0.5 * clearance * cos(angle) } else { 0.0 },
                radius: 1.0 / (1.0 / radius + if inner { 1.0 / ring_radius } else { -1.0 / sphere }),
            }
        });
        let ratio = self.roller_diameter * cos(angle) / self.pitch_diameter;
        Ok(Shape {
            laminae,
            rib: None,
            cage_ratio: 0.5 * (1.0 - ratio),
            mass_diameter: self.roller_diameter,
            angles: [angle; 2],
            raceway_contacts: [-radius, radius]
                .map(|radius| [pitch + radius * cos(angle), radius * sin(angle)]),
        })
    }
}

/// Returns the motion of a point of the inner ring along a normal for its displacement.
fn ring_approach(point: [f64; 2], normal: [f64; 2]) -> [f64; 3] {
    [normal[0], normal[1], point[1] * normal[0] - point[0] * normal[1]]
}
