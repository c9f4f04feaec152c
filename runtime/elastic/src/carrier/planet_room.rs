//! Room for planets between the plates and webs of a carrier.

use super::CarrierShape;
use crate::error::ElementError;
use std::f64::consts::FRAC_PI_2;

/// Distance from the circle of the pins, relative to its radius, up to which a body is a planet.
const NEAR_PIN_CIRCLE: f64 = 0.25;

/// Planet in the coordinates of its carrier.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Planet {
    /// Middle of its face, m.
    pub position: [f64; 3],
    /// Tip radius, m.
    pub tip_radius: f64,
    /// Face width, m.
    pub face_width: f64,
}

impl CarrierShape {
    /// Checks that a planet fits between the plates and between the webs. Other bodies on the hub,
    /// away from the circle of the pins, are accepted.
    ///
    /// # Errors
    /// The planet reaches into a plate or a web; the message has the dimensions.
    pub fn check_planet(&self, planet: &Planet) -> Result<(), ElementError> {
        let [x, y, z] = planet.position;
        let circle = 0.5 * self.pin_circle_diameter;
        if (x.hypot(y) - circle).abs() > NEAR_PIN_CIRCLE * circle {
            return Ok(());
        }
        for plate in 0..self.thickness.len() {
            let beyond = self.side(plate) * z + 0.5 * planet.face_width - 0.5 * self.gap;
            if beyond > 1e-9 * self.gap {
                return Err(ElementError::new(
                    format!(
                        "it is {} mm wide and reaches {} mm into a plate, whose inner face is {} mm from the middle of the planets",
                        mm(planet.face_width),
                        mm(beyond),
                        mm(0.5 * self.gap)
                    ),
                    format!("give a `gap` of at least {} mm", mm(self.gap + 2.0 * beyond)),
                ));
            }
        }
        self.check_webs_beside(planet)
    }

    fn check_webs_beside(&self, planet: &Planet) -> Result<(), ElementError> {
        let Some(webs) = self.webs else { return Ok(()) };
        let [x, y, _] = planet.position;
        let (radius, pitch) = (x.hypot(y), 2.0 * self.half_pitch());
        let angle = y.atan2(x);
        let from_pin = (angle - pitch * (angle / pitch).round()).abs();
        // The side of the nearer web is a radial line.
        let to_side = self.free_angle() - from_pin;
        let ends = [0.5 * webs.inside_diameter, 0.5 * webs.outside_diameter];
        let along = (radius * to_side.cos()).clamp(ends[0], ends[1]);
        let distance =
            (radius * radius + along * along - 2.0 * radius * along * to_side.cos()).max(0.0).sqrt();
        if to_side > 0.0 && distance >= planet.tip_radius {
            return Ok(());
        }
        let largest = match planet.tip_radius / radius {
            sine if sine < 1.0 => 2.0 * (self.half_pitch() - from_pin - sine.asin()).min(FRAC_PI_2),
            _ => 0.0,
        };
        let help = match largest > 0.0 {
            true => format!(
                "reduce `web_angle` to at most {} degrees, or move the webs off the planets by `web_inside_diameter` or `web_outside_diameter`",
                (largest.to_degrees() * 10.0).floor() / 10.0
            ),
            false => "move the webs off the planets by `web_inside_diameter` or `web_outside_diameter`, or leave one plate".into(),
        };
        let message = format!(
            "its tip circle of radius {} mm runs into a web, which is {} mm from its axis",
            mm(planet.tip_radius),
            mm(if to_side > 0.0 { distance } else { 0.0 })
        );
        Err(ElementError::new(message, help))
    }
}

fn mm(metres: f64) -> f64 {
    (metres * 1e6).round() / 1e3 + 0.0
}
