//! Reference rating life of ISO/TS 16281 and static safety.

use super::capacity::{ball_race_ratio, bearing_capacity, capacity, nominal_angle};
use crate::ball::{BallRow, BallState};
use crate::bearing::{Contacts, ElementState, Elements, RollingBearing};
use crate::error::{RollingError, positive};
use crate::roller::{LineContact, RollerRow, RollerState};
use libm::{cos, log, pow};

/// Ring relative to which the load has a constant direction.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum LoadDirection {
    /// The load does not rotate with respect to the outer ring: a shaft that rotates under a steady
    /// load.
    #[default]
    OuterRing,
    /// The load does not rotate with respect to the inner ring.
    InnerRing,
}

/// Conditions of the rating life.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LifeConditions {
    /// Dynamic load rating of the whole bearing from its catalogue, N; computed from the internal
    /// geometry without one.
    pub dynamic_rating: Option<f64>,
    /// Fatigue load limit of the whole bearing, N; estimated without one.
    pub fatigue_limit: Option<f64>,
    /// Reliability, from 0.9 to 0.99.
    pub reliability: f64,
    /// Viscosity ratio κ of the lubricant.
    pub viscosity_ratio: f64,
    /// Contamination factor e_C, from 0 to 1.
    pub contamination: f64,
    /// Ring relative to which the load is steady.
    pub direction: LoadDirection,
}

impl Default for LifeConditions {
    fn default() -> Self {
        Self {
            dynamic_rating: None,
            fatigue_limit: None,
            reliability: 0.9,
            viscosity_ratio: 1.0,
            contamination: 0.5,
            direction: LoadDirection::OuterRing,
        }
    }
}

/// Rating life of a bearing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Life {
    /// Basic reference rating life L₁₀ᵣ, revolutions; infinite without load.
    pub basic: f64,
    /// Modified reference rating life Lₙₘᵣ, revolutions.
    pub modified: f64,
    /// Life modification factor a_ISO.
    pub modification: f64,
    /// Dynamic equivalent reference load, N.
    pub equivalent_load: f64,
    /// Dynamic load rating of the whole bearing, N.
    pub dynamic_rating: f64,
}

/// Computes the reference rating life from the states of all elements.
///
/// Source: ISO/TS 16281. The races of several rows are combined as those of one.
///
/// # Errors
/// [`RollingError::Input`] if a condition is out of its range.
pub fn rating_life(
    bearing: &RollingBearing,
    states: &[ElementState],
    conditions: &LifeConditions,
) -> Result<Life, RollingError> {
    let reliability = reliability_factor(conditions.reliability)?;
    let is_ball = matches!(bearing.rows()[0].elements, Elements::Balls(_));
    let whole = bearing_capacity(bearing);
    let dynamic_rating = conditions.dynamic_rating.unwrap_or(whole.dynamic);
    positive("dynamic load rating", dynamic_rating)?;
    let slope = if is_ball { 10.0 / 9.0 } else { 9.0 / 8.0 };
    let mut failures = 0.0;
    for (index, row) in bearing.rows().iter().enumerate() {
        let rating = capacity(row).dynamic * dynamic_rating / whole.dynamic;
        let states = states.iter().filter(|state| state.row == index);
        failures += match &row.elements {
            Elements::Balls(balls) => {
                let states: Vec<_> = states.filter_map(ElementState::ball).collect();
                ball_failures(balls, &states, rating, conditions.direction)
            }
            Elements::Rollers(rollers) => {
                let states: Vec<_> = states.filter_map(ElementState::roller).collect();
                roller_failures(rollers, &states, rating, conditions.direction)
            }
        };
    }
    let basic = 1e6 * pow(failures, -1.0 / slope);
    let power = if is_ball { 1.0 / 3.0 } else { 0.3 };
    let equivalent_load = dynamic_rating * pow(basic * 1e-6, -power);
    let limit = conditions.fatigue_limit.unwrap_or(whole.fatigue_limit);
    positive("fatigue load limit", limit)?;
    let modification = if equivalent_load > 0.0 {
        let ratio = conditions.contamination * limit / equivalent_load;
        life_modification(is_ball, conditions.viscosity_ratio, ratio)?
    } else {
        50.0
    };
    let modified = reliability * modification * basic;
    Ok(Life { basic, modified, modification, equivalent_load, dynamic_rating })
}

/// Returns the life modification factor a_ISO of radial bearings, from the viscosity ratio κ and
/// from e_C C_u / P.
///
/// Source: ISO 281:2007, equations 31 to 36. κ above 4 counts as 4, and the factor is at most 50.
///
/// # Errors
/// [`RollingError::Input`] if κ is less than 0.1 or the load ratio is negative.
pub fn life_modification(balls: bool, viscosity_ratio: f64, load_ratio: f64) -> Result<f64, RollingError> {
    let viscosity = viscosity_ratio.min(4.0);
    if viscosity.is_nan() || viscosity < 0.1 {
        return Err(RollingError::input(
            format!("the rating life of ISO 281 has no factor for the viscosity ratio {viscosity_ratio}"),
            "give a viscosity ratio of at least 0.1, by a more viscous lubricant or a higher speed",
        )
        .of("viscosity_ratio"));
    }
    if load_ratio.is_nan() || load_ratio < 0.0 {
        return Err(RollingError::input(
            format!("the product of contamination factor and fatigue limit is {load_ratio} of the load"),
            "give a contamination factor from 0 to 1",
        )
        .of("contamination"));
    }
    let (first, seconds, powers, root, exponent) = if balls {
        (2.5671, [2.2649, 1.9987, 1.9987], 0.83, 1.0 / 3.0, -9.3)
    } else {
        (1.5859, [1.3993, 1.2348, 1.2348], 1.0, 0.4, -9.185)
    };
    let (second, power) = if viscosity < 0.4 {
        (seconds[0], 0.054381)
    } else if viscosity < 1.0 {
        (seconds[1], 0.19087)
    } else {
        (seconds[2], 0.071739)
    };
    let lubrication = pow((first - second / pow(viscosity, power)).max(0.0), powers);
    let base = 1.0 - lubrication * pow(load_ratio, root);
    if base <= 0.0 {
        return Ok(50.0);
    }
    Ok((0.1 * pow(base, exponent)).min(50.0))
}

/// Returns the factor a₁ of ISO 281:2007, table 12.
fn reliability_factor(reliability: f64) -> Result<f64, RollingError> {
    const TABLE: [[f64; 2]; 6] =
        [[0.90, 1.0], [0.95, 0.64], [0.96, 0.55], [0.97, 0.47], [0.98, 0.37], [0.99, 0.25]];
    if !(0.9..=0.99).contains(&reliability) {
        return Err(RollingError::input(
            format!("the rating life has no factor for the reliability {reliability}"),
            "give a reliability from 0.9 to 0.99",
        )
        .of("reliability"));
    }
    let at = TABLE.partition_point(|row| row[0] < reliability).clamp(1, TABLE.len() - 1);
    let ([from, first], [to, second]) = (TABLE[at - 1], TABLE[at]);
    // Linear in the logarithm of the probability of failure, as the table nearly is.
    let part = (log(1.0 - reliability) - log(1.0 - from)) / (log(1.0 - to) - log(1.0 - from));
    Ok(first + part * (second - first))
}

/// Returns the exponents of the mean load of both races: 1 for the race that rotates relative to
/// the load.
fn rotating(direction: LoadDirection, rotating: f64, steady: f64) -> [f64; 2] {
    match direction {
        LoadDirection::OuterRing => [rotating, steady],
        LoadDirection::InnerRing => [steady, rotating],
    }
}

fn ball_failures(row: &BallRow, states: &[&BallState], rating: f64, direction: LoadDirection) -> f64 {
    let angle = nominal_angle(row);
    let ratio = row.geometry.ball_diameter * cos(angle) / row.geometry.pitch_diameter;
    let races = pow(1.044 * ball_race_ratio(row, ratio), 10.0 / 3.0);
    let count = row.geometry.count as f64;
    let shared = rating / (count * pow(cos(angle), 0.7));
    let capacities = [shared / 0.407 * pow(1.0 + races, 0.3), shared / 0.389 * pow(1.0 + 1.0 / races, 0.3)];
    let exponents = rotating(direction, 3.0, 10.0 / 3.0);
    let mut failures = 0.0;
    for side in 0..2 {
        // Each arc of a four-point bearing is a race of its own.
        let arcs = row.grooves.len() / 2;
        for arc in 0..arcs {
            let load = |state: &&BallState| [&state.inner, &state.outer][side][arc].load;
            let sum: f64 = states.iter().map(|state| pow(load(state), exponents[side])).sum();
            let mean = pow(sum / count, 1.0 / exponents[side]);
            failures += pow(mean / capacities[side], 10.0 / 3.0);
        }
    }
    failures
}

fn roller_failures(row: &RollerRow, states: &[&RollerState], rating: f64, direction: LoadDirection) -> f64 {
    let cosine = cos(row.angles[1]);
    let ratio = row.geometry.roller_diameter * cosine / row.geometry.pitch_diameter;
    let races = pow(1.038 * pow((1.0 - ratio) / (1.0 + ratio), 143.0 / 108.0), 4.5);
    let count = row.geometry.count as f64;
    let shared = rating / (0.83 * count * pow(cosine, 7.0 / 9.0));
    let laminae = row.geometry.laminae;
    let share = pow(laminae as f64, -7.0 / 9.0);
    let capacities = [
        share * shared / 0.378 * pow(1.0 + races, 2.0 / 9.0),
        share * shared / 0.364 * pow(1.0 + 1.0 / races, 2.0 / 9.0),
    ];
    let exponents = rotating(direction, 4.0, 4.5);
    let length = row.geometry.length / laminae as f64;
    let mut failures = 0.0;
    for side in 0..2 {
        for lamina in 0..laminae {
            let riser = stress_riser(lamina, laminae);
            let load = |state: &&RollerState| {
                let contact: &LineContact = [&state.inner, &state.outer][side];
                riser * length * contact.laminae[lamina]
            };
            let sum: f64 = states.iter().map(|state| pow(load(state), exponents[side])).sum();
            let mean = pow(sum / count, 1.0 / exponents[side]);
            failures += pow(mean / capacities[side], 4.5);
        }
    }
    failures
}

/// Returns the stress riser at the edges of a roller, ISO/TS 16281: 1 - 0.01 / ln(1.985 |2k - n -
/// 1| / 2n) for lamina k of n.
fn stress_riser(lamina: usize, laminae: usize) -> f64 {
    let (k, n) = (lamina as f64 + 1.0, laminae as f64);
    let distance = (2.0 * k - n - 1.0).abs() / (2.0 * n);
    if distance == 0.0 { 1.0 } else { 1.0 - 0.01 / log(1.985 * distance) }
}

/// Computes the static safety factor: the smallest ratio of the element load that causes the
/// pressure of ISO 76 (4200 MPa for balls, 4000 MPa for rollers) to the element load. Infinite
/// without load.
pub fn static_safety(states: &[ElementState]) -> f64 {
    let safety = states.iter().map(|state| match state.contacts {
        Contacts::Ball(_) => {
            let ratio = crate::ball::STATIC_PRESSURE / state.pressure();
            ratio * ratio * ratio
        }
        Contacts::Roller(_) => {
            let ratio = crate::roller::STATIC_PRESSURE / state.pressure();
            ratio * ratio
        }
    });
    safety.fold(f64::INFINITY, f64::min)
}
