//! Load ratings of a row, from its internal geometry.

use crate::ball::{BallKind, BallRow};
use crate::bearing::{Elements, RollingBearing, Row};
use crate::roller::{RollerKind, RollerRow};
use libm::{cos, pow};

/// Load ratings of a row of a radial bearing, or of all its rows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Capacity {
    /// Basic dynamic radial load rating C of ISO 281, N.
    pub dynamic: f64,
    /// Basic static radial load rating C₀ of ISO 76, N.
    pub static_load: f64,
    /// Fatigue load limit of ISO 281, simplified estimation, N.
    pub fatigue_limit: f64,
}

/// Computes the load ratings of a row.
///
/// Sources: ISO 281 with ISO/TR 1281-1 for C, ISO 76 for C₀. The static rating of balls is that of
/// a pressure of 4200 MPa at the inner race under the most loaded ball, five times the mean load.
pub fn capacity(row: &Row) -> Capacity {
    match &row.elements {
        Elements::Balls(row) => balls(row),
        Elements::Rollers(row) => rollers(row),
    }
}

/// Computes the load ratings of all rows together: with i equal rows, C is i^0.7 (balls) or i^(7/9)
/// (rollers) times that of one row, and the others are sums (ISO 281, ISO 76).
pub fn bearing_capacity(bearing: &RollingBearing) -> Capacity {
    let rows: Vec<Capacity> = bearing.rows().iter().map(capacity).collect();
    let is_ball = bearing.rows().iter().any(|row| matches!(row.elements, Elements::Balls(_)));
    let exponent = if is_ball { 0.7 } else { 7.0 / 9.0 };
    let largest = rows.iter().fold(0.0f64, |most, row| most.max(row.dynamic));
    Capacity {
        dynamic: largest * pow(rows.len() as f64, exponent),
        static_load: rows.iter().map(|row| row.static_load).sum(),
        fatigue_limit: rows.iter().map(|row| row.fatigue_limit).sum(),
    }
}

/// Returns the nominal contact angle of a row of balls, rad.
pub(super) fn nominal_angle(row: &BallRow) -> f64 {
    match row.geometry.kind {
        BallKind::DeepGroove { .. } => 0.0,
        BallKind::AngularContact { angle } | BallKind::FourPoint { angle, .. } => angle,
    }
}

/// Returns 1.04 ((1-γ)/(1+γ))^1.72 times the factor of the groove radii, the ratio of the
/// capacities of both races of a row of balls without the factor 1.04.
pub(super) fn ball_race_ratio(row: &BallRow, ratio: f64) -> f64 {
    let (inner, outer) = (row.geometry.inner_conformity, row.geometry.outer_conformity);
    let grooves = inner / outer * (2.0 * outer - 1.0) / (2.0 * inner - 1.0);
    pow((1.0 - ratio) / (1.0 + ratio), 1.72) * pow(grooves, 0.41)
}

fn balls(row: &BallRow) -> Capacity {
    let g = &row.geometry;
    let cosine = cos(nominal_angle(row));
    let ratio = g.ball_diameter * cosine / g.pitch_diameter;
    let races = 1.04 * ball_race_ratio(row, ratio);
    // Factor f_c of ISO/TR 1281-1 with the reduction factor 0.95 of bearings with one row.
    let factor =
        0.95 * 39.9 * pow(1.0 + pow(races, 10.0 / 3.0), -0.3) * pow(ratio, 0.3) * pow(1.0 - ratio, 1.39)
            / libm::cbrt(1.0 + ratio)
            * pow(2.0 * g.inner_conformity / (2.0 * g.inner_conformity - 1.0), 0.41);
    let millimetres = 1e3 * g.ball_diameter;
    let size = if millimetres <= 25.4 { pow(millimetres, 1.8) } else { 3.647 * pow(millimetres, 1.4) };
    let count = g.count as f64;
    let dynamic = 1.3 * factor * pow(cosine, 0.7) * pow(count, 2.0 / 3.0) * size;
    let contact = row.contact(&row.grooves[0], cosine);
    let static_load = 0.2 * count * cosine * contact.load_of_pressure(crate::ball::STATIC_PRESSURE);
    Capacity { dynamic, static_load, fatigue_limit: fatigue_limit(static_load, 22.0, g.pitch_diameter, 0.5) }
}

fn rollers(row: &RollerRow) -> Capacity {
    let g = &row.geometry;
    let cosine = cos(row.angles[1]);
    let ratio = g.roller_diameter * cosine / g.pitch_diameter;
    let races = 1.04 * pow((1.0 - ratio) / (1.0 + ratio), 143.0 / 108.0);
    let factor = 207.9
        * 0.83
        * pow(1.0 + pow(races, 4.5), -2.0 / 9.0)
        * pow(ratio, 2.0 / 9.0)
        * pow(1.0 - ratio, 29.0 / 27.0)
        / pow(1.0 + ratio, 0.25);
    let quality = if matches!(g.kind, RollerKind::Spherical { .. }) { 1.15 } else { 1.1 };
    let (diameter, length, count) = (1e3 * g.roller_diameter, 1e3 * g.length, g.count as f64);
    let dynamic =
        quality * factor * pow(length * cosine, 7.0 / 9.0) * pow(count, 0.75) * pow(diameter, 29.0 / 27.0);
    let static_load = 44.0 * (1.0 - ratio) * count * length * diameter * cosine;
    Capacity { dynamic, static_load, fatigue_limit: fatigue_limit(static_load, 8.2, g.pitch_diameter, 0.3) }
}

/// Returns the fatigue load limit from the static rating: ISO 281, annex B.
fn fatigue_limit(static_load: f64, divisor: f64, pitch_diameter: f64, exponent: f64) -> f64 {
    let size = if pitch_diameter > 0.1 { pow(0.1 / pitch_diameter, exponent) } else { 1.0 };
    static_load / divisor * size
}
