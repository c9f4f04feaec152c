//! Estimate of the internal geometry of a bearing from its catalogue data.
//!
//! Catalogues give boundary dimensions and load ratings, which depend on the internal geometry
//! through ISO 281 and ISO 76. The estimate inverts these formulas. It is no substitute for data of
//! the manufacturer: contact angle, groove radii and profiles are assumptions.

use crate::ball::{BallGeometry, BallKind, BallRow};
use crate::bearing::Row;
use crate::error::{RollingError, positive};
use crate::material::Material;
use crate::rating::capacity;
use crate::roller::{Profile, RollerGeometry, RollerKind, RollerRow};
use std::f64::consts::PI;

/// Data of a bearing with one row in a catalogue.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CatalogueData {
    /// Bore diameter d, m.
    pub bore: f64,
    /// Outside diameter D, m.
    pub outside_diameter: f64,
    /// Width B (T of tapered roller bearings), m.
    pub width: f64,
    /// Basic dynamic load rating C, N.
    pub dynamic_rating: f64,
    /// Basic static load rating C₀, N.
    pub static_rating: f64,
}

/// Internal geometry that was estimated, with its agreement with the catalogue.
#[derive(Clone, Debug, PartialEq)]
pub struct Estimated<G> {
    /// Estimated geometry.
    pub geometry: G,
    /// Computed dynamic load rating divided by that of the catalogue, less one.
    pub dynamic_deviation: f64,
    /// Computed static load rating divided by that of the catalogue, less one.
    pub static_deviation: f64,
}

/// Largest deviation of a load rating that the estimate accepts.
const MOST: f64 = 0.25;
/// Conformity of both grooves.
const CONFORMITY: f64 = 0.52;
/// Part of the pitch circle that rollers in a cage usually fill.
const FILLING: f64 = 0.85;

impl CatalogueData {
    fn check(&self) -> Result<(), RollingError> {
        positive("bore diameter", self.bore)?;
        positive("outside diameter", self.outside_diameter)?;
        positive("width", self.width)?;
        positive("dynamic load rating", self.dynamic_rating)?;
        positive("static load rating", self.static_rating)?;
        if self.outside_diameter <= 1.05 * self.bore {
            return Err(RollingError::input(
                format!(
                    "the catalogue data have an outside diameter of {:.4} mm and a bore of {:.4} mm",
                    self.outside_diameter * 1e3,
                    self.bore * 1e3
                ),
                "give an outside diameter that exceeds the bore by both rings and the rolling elements",
            )
            .of("outside_diameter"));
        }
        Ok(())
    }

    fn pitch_diameter(&self) -> f64 {
        0.5 * (self.bore + self.outside_diameter)
    }

    /// Returns half of the difference of the diameters, m.
    fn section(&self) -> f64 {
        0.5 * (self.outside_diameter - self.bore)
    }

    fn contradiction(&self, elements: &str) -> RollingError {
        RollingError::input(
            format!(
                "no {elements} between a bore of {:.4} mm and an outside diameter of {:.4} mm, {:.4} mm wide, have the load ratings C = {} N and C0 = {} N",
                self.bore * 1e3,
                self.outside_diameter * 1e3,
                self.width * 1e3,
                self.dynamic_rating,
                self.static_rating
            ),
            "check dimensions and load ratings, which must be those of one row, or give the internal geometry",
        )
.of("dynamic_rating")
    }
}

/// Estimates number and diameter of the balls, with steel and conformities of 0.52.
///
/// # Errors
/// [`RollingError::Input`] if no balls that fit have both load ratings within 25 %.
pub fn estimate_balls(data: &CatalogueData, kind: BallKind) -> Result<Estimated<BallGeometry>, RollingError> {
    data.check()?;
    let geometry = |count: usize, ball_diameter: f64| BallGeometry {
        kind,
        count,
        ball_diameter,
        pitch_diameter: data.pitch_diameter(),
        inner_conformity: CONFORMITY,
        outer_conformity: CONFORMITY,
        rings: Material::STEEL,
        balls: Material::STEEL,
    };
    let widest = (0.8 * data.section()).min(0.95 * data.width);
    let mut best: Option<Estimated<BallGeometry>> = None;
    for count in 3..=200 {
        let fitting = 0.98 * data.pitch_diameter() * libm::sin(PI / count as f64);
        let (least, most) = (0.2 * data.section(), widest.min(fitting));
        if most <= least {
            break;
        }
        let ratings = |diameter: f64| {
            let row = BallRow::new(geometry(count, diameter))?;
            Ok::<_, RollingError>(capacity(&Row::new(row)))
        };
        // The static rating grows with the square of the diameter.
        let diameter =
            bisect(least, most, |diameter| Ok(ratings(diameter)?.static_load), data.static_rating)?;
        let found = ratings(diameter)?;
        let estimate = Estimated {
            geometry: geometry(count, diameter),
            dynamic_deviation: found.dynamic / data.dynamic_rating - 1.0,
            static_deviation: found.static_load / data.static_rating - 1.0,
        };
        if best.as_ref().is_none_or(|best| estimate.deviation() < best.deviation()) {
            best = Some(estimate);
        }
    }
    best.filter(|estimate| estimate.deviation() <= MOST).ok_or_else(|| data.contradiction("balls"))
}

/// Estimates number, diameter and length of the rollers, with steel and logarithmic profile. The
/// number fills about 85 % of the pitch circle.
///
/// # Errors
/// [`RollingError::Input`] if no rollers that fit have both load ratings.
pub fn estimate_rollers(
    data: &CatalogueData,
    kind: RollerKind,
) -> Result<Estimated<RollerGeometry>, RollingError> {
    data.check()?;
    let geometry = |count: usize, roller_diameter: f64, length: f64| RollerGeometry {
        kind,
        count,
        roller_diameter,
        length,
        pitch_diameter: data.pitch_diameter(),
        profile: Profile::Logarithmic,
        laminae: 41,
        rings: Material::STEEL,
        rollers: Material::STEEL,
    };
    let mut best: Option<(f64, Estimated<RollerGeometry>)> = None;
    for count in 5..=200 {
        let fitting = 0.99 * data.pitch_diameter() * libm::sin(PI / count as f64);
        let (least, most) = (0.15 * data.section(), (0.75 * data.section()).min(fitting));
        if most <= least {
            break;
        }
        let ratings = |diameter: f64, length: f64| {
            let row = RollerRow::new(geometry(count, diameter, length))?;
            Ok::<_, RollingError>(capacity(&Row::new(row)))
        };
        // The static rating is proportional to the length; the dynamic one then grows with the
        // diameter.
        let reference = 0.25 * data.width;
        let length = |diameter: f64| {
            Ok::<_, RollingError>(reference * data.static_rating / ratings(diameter, reference)?.static_load)
        };
        let dynamic = |diameter: f64| {
            let scale = length(diameter)? / reference;
            Ok(ratings(diameter, reference)?.dynamic * libm::pow(scale, 7.0 / 9.0))
        };
        let Ok(diameter) = bisect(least, most, dynamic, data.dynamic_rating) else { continue };
        let length = length(diameter)?;
        let Ok(found) = ratings(diameter, length) else { continue };
        let estimate = Estimated {
            geometry: geometry(count, diameter, length),
            dynamic_deviation: found.dynamic / data.dynamic_rating - 1.0,
            static_deviation: found.static_load / data.static_rating - 1.0,
        };
        if length > 0.98 * data.width || estimate.deviation() > 0.01 {
            continue;
        }
        let filling = (count as f64 * diameter / (PI * data.pitch_diameter()) - FILLING).abs();
        if best.as_ref().is_none_or(|(least, _)| filling < *least) {
            best = Some((filling, estimate));
        }
    }
    best.map(|(_, estimate)| estimate).ok_or_else(|| data.contradiction("rollers"))
}

impl<G> Estimated<G> {
    /// Returns the larger of both deviations.
    fn deviation(&self) -> f64 {
        self.dynamic_deviation.abs().max(self.static_deviation.abs())
    }
}

/// Returns the argument within bounds at which an increasing function comes nearest to a value.
fn bisect(
    mut low: f64,
    mut high: f64,
    function: impl Fn(f64) -> Result<f64, RollingError>,
    value: f64,
) -> Result<f64, RollingError> {
    for _ in 0..50 {
        let middle = 0.5 * (low + high);
        if function(middle)? < value {
            low = middle;
        } else {
            high = middle;
        }
    }
    Ok(0.5 * (low + high))
}
