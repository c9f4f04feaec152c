//! Estimate of the internal geometry of a bearing from its catalogue data.
//!
//! Catalogues give boundary dimensions and load ratings, which depend on the internal geometry
//! through ISO 281 and ISO 76. The static rating C₀ is a function of the geometry alone, while
//! manufacturers state dynamic ratings C up to a fifth above the standard's formula for better
//! steel and finish. So the estimate has the static rating of the catalogue and usual proportions:
//! the diameter of the elements as a fraction of the section between bore and outside diameter, and
//! the part of the pitch circle that rollers fill. The deviation from C is a result. The estimate
//! is no substitute for data of the manufacturer: contact angle, groove radii and profiles are
//! assumptions.

use crate::ball::{BallGeometry, BallKind, BallRow};
use crate::bearing::Row;
use crate::error::{RollingError, positive};
use crate::material::Material;
use crate::rating::{Capacity, capacity};
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
    /// Estimated geometry, whose static load rating is that of the catalogue.
    pub geometry: G,
    /// Computed dynamic load rating divided by that of the catalogue, less one.
    pub dynamic_deviation: f64,
    /// Computed static load rating divided by that of the catalogue, less one.
    pub static_deviation: f64,
}

/// Largest deviation of the dynamic load rating that the estimate accepts.
const MOST: f64 = 0.25;
/// Largest deviation of the static load rating: more than rounding of catalogues.
const MOST_STATIC: f64 = 0.01;
/// Conformity of both grooves.
const CONFORMITY: f64 = 0.52;
/// Usual ball diameter divided by the section (D - d)/2.
const BALL_SHARE: f64 = 0.59;

/// Usual proportions of rollers and the bounds of their length.
struct Proportions {
    /// Roller diameter divided by the section (D - d)/2.
    share: f64,
    /// Part of the pitch circle that the rollers fill.
    filling: f64,
    /// Largest length divided by the width of the bearing.
    longest: f64,
}

impl Proportions {
    fn of(kind: RollerKind, data: &CatalogueData) -> Self {
        match kind {
            RollerKind::Tapered { .. } => Self { share: 0.5, filling: 0.9, longest: 0.75 },
            // Needles have at least three times the length of their diameter, so the bearing is
            // wide in comparison with its section.
            _ if data.width > NEEDLES * data.section() => Self { share: 0.41, filling: 0.75, longest: 0.85 },
            _ => Self { share: 0.55, filling: 0.8, longest: 0.85 },
        }
    }
}

/// Width divided by the section from which rollers without contact angle are needles.
const NEEDLES: f64 = 1.6;

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

    /// Returns the error about load ratings that elements of the space do not have. `nearest` has
    /// the static load rating if any do; `most` is the largest that does fit, N.
    fn contradiction<G>(&self, elements: &str, nearest: Option<&Estimated<G>>, most: f64) -> RollingError {
        let space = format!(
            "between a bore of {:.4} mm and an outside diameter of {:.4} mm, {:.4} mm wide",
            self.bore * 1e3,
            self.outside_diameter * 1e3,
            self.width * 1e3
        );
        // The smallest miniature bearings have ratings of about 100 N: smaller ones are in kN.
        let help = if self.static_rating.min(self.dynamic_rating) < 100.0 {
            "check the units of the load ratings: a number without a unit is in N"
        } else {
            "check dimensions and load ratings, which must be those of one row, or give the internal geometry"
        };
        let (message, input) = match nearest {
            Some(nearest) => (
                format!(
                    "the {elements} {space}, that have the static load rating C0 = {} kN, have C = {:.3} kN (ISO 281) and not {} kN",
                    kilo(self.static_rating),
                    1e-3 * self.dynamic_rating * (1.0 + nearest.dynamic_deviation),
                    kilo(self.dynamic_rating)
                ),
                "dynamic_rating",
            ),
            None if most < self.static_rating => (
                format!(
                    "no {elements} {space}, have the static load rating C0 = {} kN: the largest that fit have {:.3} kN",
                    kilo(self.static_rating),
                    1e-3 * most
                ),
                "static_rating",
            ),
            None => (
                format!(
                    "no {elements} {space}, have a static load rating as small as C0 = {} kN",
                    kilo(self.static_rating)
                ),
                "static_rating",
            ),
        };
        RollingError::input(message, help).of(input)
    }
}

/// Formats a load rating in kN.
fn kilo(newtons: f64) -> f64 {
    (newtons * 1e3).round() / 1e6
}

/// Estimates number and diameter of the balls, with steel and conformities of 0.52: those with the
/// static load rating whose diameter is nearest to 0.59 of the section.
///
/// # Errors
/// [`RollingError::Input`] if no balls that fit have the static load rating, or if theirs have a
/// dynamic load rating that deviates by more than 25 %.
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
    let usual = BALL_SHARE * data.section();
    let widest = (0.8 * data.section()).min(0.95 * data.width);
    let mut best: Option<(f64, Estimated<BallGeometry>)> = None;
    let mut most = 0.0f64;
    for count in 3..=200 {
        let fitting = 0.98 * data.pitch_diameter() * libm::sin(PI / count as f64);
        let (least, largest) = (0.2 * data.section(), widest.min(fitting));
        if largest <= least {
            break;
        }
        let ratings = |diameter: f64| {
            let row = BallRow::new(geometry(count, diameter))?;
            Ok::<_, RollingError>(capacity(&Row::new(row)))
        };
        most = most.max(ratings(largest)?.static_load);
        // The static rating grows with the square of the diameter.
        let diameter =
            bisect(least, largest, |diameter| Ok(ratings(diameter)?.static_load), data.static_rating)?;
        let estimate = Estimated::of(geometry(count, diameter), ratings(diameter)?, data);
        if estimate.static_deviation.abs() > MOST_STATIC {
            continue;
        }
        let distance = (diameter / usual - 1.0).abs();
        if best.as_ref().is_none_or(|(least, _)| distance < *least) {
            best = Some((distance, estimate));
        }
    }
    accepted(data, "balls", best, most)
}

/// Estimates number, diameter and length of the rollers, with steel and logarithmic profile: those
/// with the static load rating whose diameter and filling of the pitch circle are nearest to usual
/// proportions. These are 0.55 of the section and 0.8 for cylindrical rollers, 0.5 and 0.9 for
/// tapered ones, and 0.41 and 0.75 for needles.
///
/// # Errors
/// [`RollingError::Input`] if no rollers that fit have the static load rating, or if theirs have a
/// dynamic load rating that deviates by more than 25 %.
pub fn estimate_rollers(
    data: &CatalogueData,
    kind: RollerKind,
) -> Result<Estimated<RollerGeometry>, RollingError> {
    data.check()?;
    let usual = Proportions::of(kind, data);
    let pitch_diameter = data.pitch_diameter();
    let geometry = |count: usize, roller_diameter: f64, length: f64| RollerGeometry {
        kind,
        count,
        roller_diameter,
        length,
        raceway_widths: [None; 2],
        pitch_diameter,
        profile: Profile::Logarithmic,
        laminae: 41,
        rings: Material::STEEL,
        rollers: Material::STEEL,
    };
    let mut best: Option<(f64, Estimated<RollerGeometry>)> = None;
    let mut most = 0.0f64;
    // Other diameters than the usual one serve only if the length is out of its bounds.
    for share in (-STEPS..=STEPS).map(|step| usual.share * (1.0 + 0.4 * f64::from(step) / f64::from(STEPS))) {
        let diameter = share * data.section();
        for count in 5..=200 {
            if diameter > 0.99 * pitch_diameter * libm::sin(PI / count as f64) {
                break;
            }
            let filling = count as f64 * diameter / (PI * pitch_diameter);
            let distance = (share / usual.share - 1.0).abs() + (filling / usual.filling - 1.0).abs();
            let ratings = |length: f64| {
                RollerRow::new(geometry(count, diameter, length)).map(|row| capacity(&Row::new(row)))
            };
            // The static rating is proportional to the length.
            let longest = usual.longest * data.width;
            let Ok(of_longest) = ratings(longest) else { continue };
            most = most.max(of_longest.static_load);
            let length = longest * data.static_rating / of_longest.static_load;
            if length > longest
                || length < SHORTEST * data.width
                || best.as_ref().is_some_and(|(least, _)| distance >= *least)
            {
                continue;
            }
            let Ok(found) = ratings(length) else { continue };
            best = Some((distance, Estimated::of(geometry(count, diameter, length), found, data)));
        }
    }
    accepted(data, "rollers", best, most)
}

/// Number of diameters of rollers on either side of the usual one.
const STEPS: i32 = 16;
/// Least length of rollers divided by the width of the bearing.
const SHORTEST: f64 = 0.2;

/// Returns the estimate if its dynamic load rating is near that of the catalogue.
fn accepted<G>(
    data: &CatalogueData,
    elements: &str,
    best: Option<(f64, Estimated<G>)>,
    most: f64,
) -> Result<Estimated<G>, RollingError> {
    match best {
        Some((_, estimate)) if estimate.dynamic_deviation.abs() <= MOST => Ok(estimate),
        Some((_, estimate)) => Err(data.contradiction(elements, Some(&estimate), most)),
        None => Err(data.contradiction::<G>(elements, None, most)),
    }
}

impl<G> Estimated<G> {
    fn of(geometry: G, found: Capacity, data: &CatalogueData) -> Self {
        Self {
            geometry,
            dynamic_deviation: found.dynamic / data.dynamic_rating - 1.0,
            static_deviation: found.static_load / data.static_rating - 1.0,
        }
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
