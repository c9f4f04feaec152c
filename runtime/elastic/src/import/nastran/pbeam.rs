//! Sections of beams: PBEAM, PBEAML.
//!
//! Source: NASTRAN Quick Reference Guide, entries PBEAM and PBEAML. The model has the centroid of
//! the section on the line between the ends, so offsets of the neutral axis from the shear centre,
//! offsets of non-structural mass, warping and intermediate stations are rejected.

use super::beam_properties::{dimensions, invalid_section, section_type, shear_factor, typed, valid};
use super::card::Result;
use super::deck::Card;
use crate::model::BeamSection;

/// Sections at both ends of a PBEAM or PBEAML.
pub(super) fn beam(card: &Card) -> Result<[BeamSection; 2]> {
    if card.name == "PBEAML" { by_dimensions(card) } else { by_properties(card) }
}

/// Station of a beam: the second end, or an error for an intermediate one.
fn station(card: &Card, field: usize) -> Result<()> {
    let at = card.real_or(field, 1.0, "X/XB")?;
    match at == 1.0 {
        true => Ok(()),
        false => Err(card.problem(
            format!("{} has an intermediate station at X/XB = {at}, which is not supported", card.subject()),
            "divide the beam into elements, each with sections at its two ends",
        )),
    }
}

fn is_station(card: &Card, field: usize) -> bool {
    matches!(card.text(field), "YES" | "YESA" | "NO")
}

fn by_properties(card: &Card) -> Result<[BeamSection; 2]> {
    let first = BeamSection {
        area: card.positive(3, "A")?,
        second_moment_z: card.not_negative(4, "I1")?,
        second_moment_y: card.not_negative(5, "I2")?,
        product_of_inertia: card.real_or(6, 0.0, "I12")?,
        torsion_constant: card.not_negative(7, "J")?,
        shear_factors: [1.0; 2],
        added_mass: card.not_negative(8, "NSM")?,
    };
    let mut second = first;
    // The line of stress recovery points at end A may be left out before a station.
    let mut at = if is_station(card, 9) { 9 } else { 17 };
    while is_station(card, at) {
        station(card, at + 1)?;
        let value = |offset: usize, default: f64, what: &str| card.real_or(at + offset, default, what);
        second = BeamSection {
            area: value(2, first.area, "A(B)")?,
            second_moment_z: value(3, first.second_moment_z, "I1(B)")?,
            second_moment_y: value(4, first.second_moment_y, "I2(B)")?,
            product_of_inertia: value(5, first.product_of_inertia, "I12(B)")?,
            torsion_constant: value(6, first.torsion_constant, "J(B)")?,
            added_mass: value(7, first.added_mass, "NSM(B)")?,
            ..first
        };
        at += if card.text(at) == "YES" { 16 } else { 8 };
    }
    let shear_factors = [shear_factor(card, at, "K1", 1.0)?, shear_factor(card, at + 1, "K2", 1.0)?];
    card.unsupported([at + 2, at + 3], "shear relief by taper")?;
    card.unsupported([at + 4, at + 5], "rotary inertia of non-structural mass")?;
    card.unsupported([at + 6, at + 7], "warping")?;
    card.unsupported(at + 8..at + 12, "an offset of non-structural mass")?;
    card.unsupported(at + 12..at + 16, "an offset of the neutral axis from the shear centre")?;
    let negative =
        [second.second_moment_z, second.second_moment_y, second.torsion_constant, second.added_mass];
    if negative.iter().any(|value| *value < 0.0) {
        return Err(invalid_section(card, "a property at end B is negative"));
    }
    Ok([
        valid(card, BeamSection { shear_factors, ..first })?,
        valid(card, BeamSection { shear_factors, ..second })?,
    ])
}

fn by_dimensions(card: &Card) -> Result<[BeamSection; 2]> {
    let (kind, count) = section_type(card)?;
    let mut at = 9;
    let mut sections = Vec::new();
    loop {
        let dimensions = dimensions(card, at, count)?;
        let symmetric = match kind {
            "ROD" | "TUBE" | "TUBE2" | "BAR" | "BOX" | "I1" | "H" | "CROSS" => true,
            "BOX1" => dimensions[2] == dimensions[3] && dimensions[4] == dimensions[5],
            "I" => dimensions[1] == dimensions[2] && dimensions[4] == dimensions[5],
            _ => false,
        };
        if !symmetric {
            let reason =
                format!("the shear centre of section {kind} is not its centroid, which is not supported");
            return Err(invalid_section(card, &reason));
        }
        let added_mass = card.not_negative(at + count, "NSM")?;
        sections.push(valid(card, BeamSection { added_mass, ..typed(card, kind, &dimensions)? })?);
        at += count + 1;
        if !is_station(card, at) {
            break;
        }
        station(card, at + 1)?;
        at += 2;
        // Without dimensions, the section at end B is that at end A.
        if (at..at + count).all(|field| card.is_blank(field)) {
            break;
        }
    }
    Ok([sections[0], sections[sections.len() - 1]])
}
