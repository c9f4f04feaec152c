//! Segments of a shaft and their sections.

use super::Six;
use calyx_fe::material::Material;
use calyx_numerics::error::EngineError;
use std::f64::consts::PI;

/// Segment of a shaft: cylindrical or conical, with a coaxial bore.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShaftSegment {
    /// Length, m.
    pub length: f64,
    /// Outside diameter at the start and at the end, m.
    pub diameter: [f64; 2],
    /// Diameter of the bore at the start and at the end, m; 0 for a solid shaft.
    pub bore: [f64; 2],
    /// Outside diameter that carries load, m, if it differs from [`ShaftSegment::diameter`]: the
    /// root circle of a spline or a thread. The mass is that of the whole segment.
    pub stiffness_diameter: Option<f64>,
}

impl ShaftSegment {
    /// Checks the dimensions.
    ///
    /// # Errors
    /// E0858: a dimension is not positive, the bore is as large as the diameter that carries load,
    /// or that diameter is larger than the outside one.
    pub fn check(&self) -> Result<(), EngineError> {
        let refused = |argument, message: String, help: &str| {
            Err(EngineError::new("E0858", message, help).blame(argument))
        };
        let mm = |metres: f64| (metres * 1e9).round() / 1e6;
        let positive = |value: f64| value.is_finite() && value > 0.0;
        if !positive(self.length) {
            let message = format!("a segment of a shaft cannot be {} mm long", mm(self.length));
            return refused("length", message, "give a positive length");
        }
        let named = [("diameter", self.diameter[0]), ("end_diameter", self.diameter[1])];
        let stated = self.stiffness_diameter.map(|diameter| ("stiffness_diameter", diameter));
        for (argument, diameter) in named.into_iter().chain(stated) {
            if !positive(diameter) {
                let message = format!("a segment of a shaft cannot have a diameter of {} mm", mm(diameter));
                return refused(argument, message, "give a positive diameter");
            }
        }
        if let Some(carrying) = self.stiffness_diameter {
            if let Some(outside) = self.diameter.into_iter().find(|&outside| carrying > outside) {
                let message = format!(
                    "a `stiffness_diameter` of {} mm is larger than the diameter of {} mm",
                    mm(carrying),
                    mm(outside)
                );
                return refused("stiffness_diameter", message, "give the root diameter, or leave it out");
            }
            if let Some(bore) = self.bore.into_iter().find(|&bore| bore >= carrying) {
                let message = format!(
                    "the bore of {} mm leaves no wall inside the `stiffness_diameter` of {} mm",
                    mm(bore),
                    mm(carrying)
                );
                return refused(
                    "stiffness_diameter",
                    message,
                    "reduce the bore, or enlarge the root diameter",
                );
            }
        }
        for (end, argument) in ["bore", "end_bore"].into_iter().enumerate() {
            let (bore, outside) = (self.bore[end], self.diameter[end]);
            if !(bore.is_finite() && bore >= 0.0) {
                let message = format!("the bore of a shaft cannot have a diameter of {} mm", mm(bore));
                return refused(argument, message, "give a positive diameter, or 0 for a solid shaft");
            }
            if bore >= outside {
                let message =
                    format!("the bore of {} mm leaves no wall in a segment of {} mm", mm(bore), mm(outside));
                return refused(argument, message, "reduce the bore, or enlarge the diameter");
            }
        }
        Ok(())
    }

    /// Returns whether the sections vary along the segment.
    pub(super) fn is_tapered(&self) -> bool {
        self.diameter[0] != self.diameter[1] || self.bore[0] != self.bore[1]
    }

    /// Returns the section at a fraction of the length.
    pub(super) fn section(&self, part: f64) -> Section {
        let between =
            |[start, end]: [f64; 2]| if start == end { start } else { start + part * (end - start) };
        let outside = between(self.diameter);
        Section { outside, carrying: self.stiffness_diameter.unwrap_or(outside), bore: between(self.bore) }
    }
}

impl Section {
    /// Returns the outside diameter and the bore, m.
    pub(super) fn diameters(self) -> [f64; 2] {
        [self.outside, self.bore]
    }
}

/// Circular section with a bore, m.
#[derive(Clone, Copy, Debug)]
pub(super) struct Section {
    outside: f64,
    /// Outside diameter that carries load.
    carrying: f64,
    bore: f64,
}

/// Returns the shear coefficient of a circular section with a bore of `ratio` of its diameter
/// (Cowper 1966).
pub fn shear_coefficient(poissons_ratio: f64, ratio: f64) -> f64 {
    let (square, sum) = (ratio * ratio, (1.0 + ratio * ratio).powi(2));
    6.0 * (1.0 + poissons_ratio) * sum
        / ((7.0 + 6.0 * poissons_ratio) * sum + (20.0 + 12.0 * poissons_ratio) * square)
}

fn area([outside, bore]: [f64; 2]) -> f64 {
    0.25 * PI * (outside * outside - bore * bore)
}

fn second_moment([outside, bore]: [f64; 2]) -> f64 {
    PI / 64.0 * (outside.powi(4) - bore.powi(4))
}

impl Section {
    /// Returns the area that carries load, m².
    pub(super) fn area(&self) -> f64 {
        area([self.carrying, self.bore])
    }

    /// Returns the radii of the bore and of the outside that carries load, m.
    pub(super) fn carrying_radii(&self) -> [f64; 2] {
        [0.5 * self.bore, 0.5 * self.carrying]
    }

    /// Returns the section modulus of bending, m³; that of torsion is twice as large.
    pub(super) fn bending_modulus(&self) -> f64 {
        2.0 * second_moment([self.carrying, self.bore]) / self.carrying
    }

    /// Returns `1 / EA`, `1 / kappa G A`, `1 / EI` and `1 / GJ`.
    pub(super) fn compliances(&self, material: &Material) -> [f64; 4] {
        let Material { youngs_modulus: e, poissons_ratio: nu, .. } = *material;
        let g = 0.5 * e / (1.0 + nu);
        let (area, inertia) = (self.area(), second_moment([self.carrying, self.bore]));
        let shear = shear_coefficient(nu, self.bore / self.carrying);
        [e * area, shear * g * area, e * inertia, 2.0 * g * inertia].map(f64::recip)
    }

    /// Returns mass and moments of inertia per length along and about the three axes.
    pub(super) fn inertia(&self, material: &Material) -> Six {
        let mass = material.density * area([self.outside, self.bore]);
        let across = material.density * second_moment([self.outside, self.bore]);
        [mass, mass, mass, across, across, 2.0 * across]
    }
}
