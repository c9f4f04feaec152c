//! Dimensions of a planet carrier.

use crate::error::ElementError;
use std::f64::consts::PI;

/// Dimensions of a planet carrier, m and rad.
#[derive(Clone, Debug, PartialEq)]
pub struct CarrierShape {
    /// Number of planets, equally spaced.
    pub planets: usize,
    /// Diameter of the circle of the pins.
    pub pin_circle_diameter: f64,
    /// Outside diameter of the pins and of their seats.
    pub pin_diameter: f64,
    /// Diameter of the bore of the pins; 0 for solid pins.
    pub pin_bore: f64,
    /// Outside diameter of the plates.
    pub outside_diameter: f64,
    /// Diameter of the bore of the plates; that of the first plate is the hub.
    pub bore_diameter: f64,
    /// Thickness of each plate; the first one has the hub. One plate or two.
    pub thickness: Vec<f64>,
    /// Distance between the inner faces of two plates. A single plate is at half of this distance
    /// from the middle of the planets.
    pub gap: f64,
    /// True if the plate with the hub is on the side of negative z.
    pub hub_at_negative_z: bool,
    /// Webs between two plates.
    pub webs: Option<Webs>,
    /// Largest length of an element in the plane of the plates and along the axis.
    pub element_size: f64,
}

/// Webs between two plates: sectors of a ring between neighbouring planets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Webs {
    /// Inside diameter, m.
    pub inside_diameter: f64,
    /// Outside diameter, m.
    pub outside_diameter: f64,
    /// Angle that each web takes up, rad.
    pub angle: f64,
}

/// Part of the height of a carrier between two levels of its mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Layer {
    /// Lowest and highest position, m.
    pub(super) ends: [f64; 2],
    /// Index of the plate, or `None` between the plates.
    pub(super) plate: Option<usize>,
}

/// Smallest wall around a seat, relative to its radius.
const WALL: f64 = 0.05;
/// Largest number of elements in a direction.
const MOST: f64 = 1e4;
/// Largest number of elements, by volume. Their mesh takes about a second.
const MOST_ELEMENTS: f64 = 1e5;

/// Returns the number of elements along a length.
pub(super) fn count(length: f64, size: f64) -> usize {
    ((length / size - 1e-9).ceil().clamp(1.0, MOST) as usize).max(1)
}

impl CarrierShape {
    /// Returns the side of a plate along z: 1 or -1.
    pub(super) fn side(&self, plate: usize) -> f64 {
        if (plate == 0) == self.hub_at_negative_z { -1.0 } else { 1.0 }
    }

    /// Returns the index of the plate with the hub.
    pub(super) fn hub_plate(&self) -> usize {
        0
    }

    /// Returns the layers of the mesh by ascending position, each above the one before.
    pub(super) fn layers(&self) -> Vec<Layer> {
        let mut layers = Vec::new();
        let mut add = |from: f64, to: f64, plate| {
            let parts = count(to - from, self.element_size);
            let at = |k: usize| if k == parts { to } else { from + (to - from) * (k as f64 / parts as f64) };
            layers.extend((0..parts).map(|k| Layer { ends: [at(k), at(k + 1)], plate }));
        };
        let half = 0.5 * self.gap;
        for plate in (0..self.thickness.len()).filter(|&plate| self.side(plate) < 0.0) {
            add(-half - self.thickness[plate], -half, Some(plate));
        }
        if self.webs.is_some() {
            add(-half, half, None);
        }
        for plate in (0..self.thickness.len()).filter(|&plate| self.side(plate) > 0.0) {
            add(half, half + self.thickness[plate], Some(plate));
        }
        layers
    }

    /// Half of the angle between neighbouring planets.
    pub(super) fn half_pitch(&self) -> f64 {
        PI / self.planets as f64
    }

    /// Half of the angle of a sector that is free of webs.
    pub(super) fn free_angle(&self) -> f64 {
        self.half_pitch() - self.webs.map_or(0.0, |webs| 0.5 * webs.angle)
    }

    /// Checks the dimensions.
    ///
    /// # Errors
    /// A dimension is not positive, or parts overlap. With the name of the field to correct.
    pub fn check(&self) -> Result<(), (&'static str, ElementError)> {
        let refused = |field, message: String, help: &str| Err(refused(field, message, help));
        let mm = |metres: f64| (metres * 1e9).round() / 1e6;
        let mut positive = vec![
            ("pin_circle_diameter", "the circle of the pins", self.pin_circle_diameter),
            ("pin_diameter", "the pins", self.pin_diameter),
            ("outside_diameter", "the plates", self.outside_diameter),
            ("bore_diameter", "the bore", self.bore_diameter),
            ("gap", "the distance between the plates", self.gap),
            ("element_size", "the size of the elements", self.element_size),
        ];
        positive.extend(
            self.thickness.iter().map(|thickness| ("thickness", "the thickness of a plate", *thickness)),
        );
        if let Some((field, what, value)) =
            positive.into_iter().find(|(_, _, value)| !(value.is_finite() && *value > 0.0))
        {
            return refused(
                field,
                format!("{what} cannot measure {} mm", mm(value)),
                "give a positive length",
            );
        }
        if self.planets < 2 {
            let message = format!("a carrier cannot have {} planets", self.planets);
            return refused("planets", message, "give at least two planets");
        }
        if !(self.pin_bore >= 0.0 && self.pin_bore < self.pin_diameter) {
            let message = format!("the bore of {} mm leaves no wall in the pins", mm(self.pin_bore));
            return refused("pin_bore", message, "give a bore smaller than the diameter of the pins");
        }
        if self.thickness.len() != 1 && self.thickness.len() != 2 {
            let message = format!("a carrier cannot have {} plates", self.thickness.len());
            return refused("thickness", message, "give one plate, or two with webs between them");
        }
        self.check_seats(&mm)?;
        self.check_webs(&mm)?;
        // The number of elements is limited before a mesh of this size is created.
        let volume = self.volume_of_disc();
        if volume / self.element_size.powi(3) > MOST_ELEMENTS {
            let message = format!(
                "elements of {} mm are too small for the carrier: there would be more than {MOST_ELEMENTS}",
                mm(self.element_size)
            );
            let help = format!("use elements of at least {} mm", mm((volume / MOST_ELEMENTS).cbrt() * 1.001));
            return refused("element_size", message, &help);
        }
        Ok(())
    }

    /// Returns the volume of the solid disc that contains plates and webs, m³.
    fn volume_of_disc(&self) -> f64 {
        let height = self.thickness.iter().sum::<f64>() + self.webs.map_or(0.0, |_| self.gap);
        0.25 * PI * self.outside_diameter.powi(2) * height
    }

    fn check_seats(&self, mm: &dyn Fn(f64) -> f64) -> Result<(), (&'static str, ElementError)> {
        let (centre, seat) = (0.5 * self.pin_circle_diameter, 0.5 * (1.0 + WALL) * self.pin_diameter);
        if centre - seat <= 0.5 * self.bore_diameter {
            return Err(refused(
                "bore_diameter",
                format!("the pins reach the bore of {} mm", mm(self.bore_diameter)),
                "reduce the bore or the pins, or enlarge the circle of the pins",
            ));
        }
        if centre + seat >= 0.5 * self.outside_diameter {
            return Err(refused(
                "pin_diameter",
                format!("the pins reach the outside diameter of {} mm", mm(self.outside_diameter)),
                "enlarge the plates, or reduce the pins or their circle",
            ));
        }
        if (seat / centre).asin() >= self.free_angle() {
            return Err(refused(
                "pin_diameter",
                "neighbouring pins, or pins and webs, overlap",
                "reduce the pins or the angle of the webs, or enlarge the circle of the pins",
            ));
        }
        Ok(())
    }

    fn check_webs(&self, mm: &dyn Fn(f64) -> f64) -> Result<(), (&'static str, ElementError)> {
        let Some(webs) = self.webs else {
            return match self.thickness.len() {
                1 => Ok(()),
                _ => Err(refused(
                    "web_angle",
                    "two plates have no webs between them",
                    "give the dimensions of the webs, or one plate",
                )),
            };
        };
        if self.thickness.len() == 1 {
            return Err(refused("web_angle", "webs need two plates", "give two plates, or no webs"));
        }
        let [inside, outside] = [webs.inside_diameter, webs.outside_diameter];
        let within = |d: f64| d.is_finite() && (self.bore_diameter..=self.outside_diameter).contains(&d);
        if !(within(inside) && within(outside) && inside < outside) {
            return Err(refused(
                "web_outside_diameter",
                format!(
                    "webs from {} mm to {} mm in diameter are not on the plates",
                    mm(inside),
                    mm(outside)
                ),
                "give diameters between those of the bore and of the plates",
            ));
        }
        if !(webs.angle.is_finite() && webs.angle > 0.0) {
            return Err(refused(
                "web_angle",
                format!("webs cannot have an angle of {} degrees", webs.angle.to_degrees()),
                "give a positive angle",
            ));
        }
        Ok(())
    }
}

/// Returns an error about a field.
fn refused(
    field: &'static str,
    message: impl Into<String>,
    help: impl Into<String>,
) -> (&'static str, ElementError) {
    (field, ElementError::new(message, help))
}
