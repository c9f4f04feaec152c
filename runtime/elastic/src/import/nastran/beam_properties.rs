//! Sections of bars: PBAR, PBARL, and the dimensions of section types.
//!
//! Source: NASTRAN Quick Reference Guide, entries PBAR and PBARL (figure of cross-section types).
//! The shear factors of section types: solid and tube by R. J. Roark; thin-walled sections have the
//! area of the walls along the force over the whole area, and five sixths of it for flanges of open
//! sections.

use super::super::origin::Problem;
use super::super::section::{circle, composed, hollow_box, open_torsion, rectangle, rectangle_torsion, tube};
use super::card::Result;
use super::deck::Card;
use crate::model::BeamSection;

/// Section of PBAR or PBARL.
pub(super) fn bar(card: &Card) -> Result<BeamSection> {
    if card.name == "PBARL" {
        let (kind, count) = section_type(card)?;
        let dimensions = dimensions(card, 9, count)?;
        let added_mass = card.not_negative(9 + count, "NSM")?;
        let section = typed(card, kind, &dimensions)?;
        return valid(card, BeamSection { added_mass, ..section });
    }
    let product_of_inertia = card.real_or(19, 0.0, "I12")?;
    let section = BeamSection {
        area: card.positive(3, "A")?,
        second_moment_z: card.not_negative(4, "I1")?,
        second_moment_y: card.not_negative(5, "I2")?,
        product_of_inertia,
        torsion_constant: card.not_negative(6, "J")?,
        // Blank or zero: no shear deformation. With I12, the shear factors are ignored.
        shear_factors: match product_of_inertia {
            0.0 => [shear_factor(card, 17, "K1", 0.0)?, shear_factor(card, 18, "K2", 0.0)?],
            _ => [f64::INFINITY; 2],
        },
        added_mass: card.not_negative(7, "NSM")?,
    };
    valid(card, section)
}

/// Shear factor: infinite if the field states zero.
pub(super) fn shear_factor(card: &Card, field: usize, what: &str, default: f64) -> Result<f64> {
    let value = card.real_or(field, default, what)?;
    if value < 0.0 {
        return Err(invalid_section(card, &format!("{what} is {value}, but must not be negative")));
    }
    Ok(if value == 0.0 { f64::INFINITY } else { value })
}

/// Checks that I1 I2 exceeds I12 squared and that all properties are finite.
pub(super) fn valid(card: &Card, section: BeamSection) -> Result<BeamSection> {
    let BeamSection { area, second_moment_z: i1, second_moment_y: i2, product_of_inertia: i12, .. } = section;
    let finite = [area, i1, i2, i12, section.torsion_constant, section.added_mass];
    if !finite.iter().all(|value| value.is_finite()) {
        return Err(invalid_section(card, "the properties of the section overflow"));
    }
    if area <= 0.0 {
        return Err(invalid_section(card, "the area of the section is not positive"));
    }
    if i12 != 0.0 && i1 * i2 <= i12 * i12 {
        return Err(invalid_section(card, &format!("I1 I2 = {} is not larger than I12 squared", i1 * i2)));
    }
    Ok(section)
}

/// Section type of PBARL or PBEAML with its number of dimensions.
pub(super) fn section_type(card: &Card) -> Result<(&'static str, usize)> {
    const TYPES: [(&str, usize); 14] = [
        ("ROD", 1),
        ("TUBE", 2),
        ("TUBE2", 2),
        ("BAR", 2),
        ("BOX", 4),
        ("BOX1", 6),
        ("I", 6),
        ("I1", 4),
        ("T", 4),
        ("T2", 4),
        ("CHAN", 4),
        ("CHAN1", 4),
        ("H", 4),
        ("CROSS", 4),
    ];
    let group = card.text(3);
    let known = TYPES.iter().find(|(name, _)| *name == card.text(4));
    match known {
        Some(entry) if group.is_empty() || group == "MSCBML0" || group == "MSCBMLO" => Ok(*entry),
        _ => {
            let names: Vec<&str> = TYPES.iter().map(|(name, _)| *name).collect();
            Err(card.problem(
                format!("{}: the section type `{}` is not supported", card.subject(), card.text(4)),
                format!("use one of {}, or state A, I1, I2 and J", names.join(", ")),
            ))
        }
    }
}

/// Dimensions of a section type, from a field on.
pub(super) fn dimensions(card: &Card, first: usize, count: usize) -> Result<Vec<f64>> {
    (0..count)
        .map(|i| {
            let what = format!("DIM{}", i + 1);
            let value = card.real(first + i, &what)?;
            // Only the inner radius of a tube may be zero.
            let may_vanish = card.text(4) == "TUBE" && i == 1;
            if value > 0.0 || (may_vanish && value == 0.0) {
                return Ok(value);
            }
            Err(invalid_section(card, &format!("{what} is {value}, but must be positive")))
        })
        .collect()
}

/// Section of a type with its dimensions. The local y axis points up in the figures of the guide.
pub(super) fn typed(card: &Card, kind: &str, d: &[f64]) -> Result<BeamSection> {
    let fits = match kind {
        "TUBE" => d[1] < d[0],
        "TUBE2" => d[1] <= d[0],
        "BOX" => 2.0 * d[2] < d[1] && 2.0 * d[3] < d[0],
        "BOX1" => d[2] + d[3] < d[1] && d[4] + d[5] < d[0],
        "I" => d[4] + d[5] < d[0] && d[3] <= d[1].min(d[2]),
        "I1" => d[2] < d[3],
        "T" | "T2" => d[2] < d[1] && d[3] <= d[0],
        "CHAN" => 2.0 * d[3] < d[1] && d[2] < d[0],
        "CHAN1" => d[2] < d[3],
        "H" => d[3] <= d[2],
        "CROSS" => d[3] <= d[2],
        _ => true,
    };
    if !fits {
        return Err(invalid_section(card, &format!("the dimensions of section {kind} do not fit together")));
    }
    Ok(match kind {
        "ROD" => circle(d[0], 0.9),
        "TUBE" => tube(d[0], d[1], 0.5),
        "TUBE2" => tube(d[0], d[0] - d[1], 0.5),
        "BAR" => composed(&[rectangle(d[0], d[1], 0.0, 0.0)], rectangle_torsion(d[0], d[1]), [5.0 / 6.0; 2]),
        "BOX" => hollow_box(d[0], d[1], [d[2], d[2], d[3], d[3]], None),
        "BOX1" => hollow_box(d[0], d[1], [d[2], d[3], d[4], d[5]], None),
        "I" => flanged(d[0], d[1], d[2], d[3], d[4], d[5]),
        "I1" => {
            let flange = 0.5 * (d[3] - d[2]);
            flanged(d[3], d[0] + d[1], d[0] + d[1], d[1], flange, flange)
        }
        "T" | "T2" => {
            let (web, flange) = (d[1] - d[2], d[0] * d[2]);
            let parts = [rectangle(d[0], d[2], 0.5 * d[1], 0.0), rectangle(d[3], web, 0.0, 0.0)];
            let area = flange + web * d[3];
            let torsion = open_torsion(&[[d[0], d[2]], [d[1] - 0.5 * d[2], d[3]]]);
            composed(&parts, torsion, [d[1] * d[3] / area, 5.0 / 6.0 * flange / area])
        }
        "CHAN" => channel(d[0], d[1], d[2], d[3]),
        "CHAN1" => channel(d[0] + d[1], d[3], d[1], 0.5 * (d[3] - d[2])),
        "H" => {
            let leg = 0.5 * d[1];
            let at = 0.5 * (d[0] + leg);
            let parts = [
                rectangle(leg, d[2], 0.0, at),
                rectangle(leg, d[2], 0.0, -at),
                rectangle(d[0], d[3], 0.0, 0.0),
            ];
            let area = d[1] * d[2] + d[0] * d[3];
            let torsion = open_torsion(&[[2.0 * d[2], leg], [d[0], d[3]]]);
            composed(&parts, torsion, [5.0 / 6.0 * d[1] * d[2] / area, d[0] * d[3] / area])
        }
        _ => {
            // The horizontal arms are on both sides of the vertical wall.
            let arm = 0.5 * d[0];
            let at = 0.5 * (d[1] + arm);
            let parts = [
                rectangle(d[1], d[2], 0.0, 0.0),
                rectangle(arm, d[3], 0.0, at),
                rectangle(arm, d[3], 0.0, -at),
            ];
            let area = d[1] * d[2] + d[0] * d[3];
            let torsion = open_torsion(&[[d[2], d[1]], [d[0], d[3]]]);
            composed(&parts, torsion, [5.0 / 6.0 * d[1] * d[2] / area, 5.0 / 6.0 * d[0] * d[3] / area])
        }
    })
}

/// I section: height, widths of the bottom and top flange, web, thickness of the bottom and top
/// flange.
pub(super) fn flanged(height: f64, bottom: f64, top: f64, web: f64, below: f64, above: f64) -> BeamSection {
    let clear = height - below - above;
    let parts = [
        rectangle(bottom, below, 0.5 * (below - height), 0.0),
        rectangle(top, above, 0.5 * (height - above), 0.0),
        rectangle(web, clear, 0.5 * (below - above), 0.0),
    ];
    let flanges = bottom * below + top * above;
    let area = flanges + web * clear;
    let between = height - 0.5 * (below + above);
    let torsion = open_torsion(&[[bottom, below], [top, above], [between, web]]);
    composed(&parts, torsion, [height * web / area, 5.0 / 6.0 * flanges / area])
}

/// Channel: width of the flanges, height, thickness of the web and of the flanges.
fn channel(width: f64, height: f64, web: f64, flange: f64) -> BeamSection {
    let at = 0.5 * (height - flange);
    let parts = [
        rectangle(web, height, 0.0, 0.5 * web),
        rectangle(width - web, flange, at, 0.5 * (width + web)),
        rectangle(width - web, flange, -at, 0.5 * (width + web)),
    ];
    let area = web * height + 2.0 * (width - web) * flange;
    let torsion = open_torsion(&[[height - flange, web], [2.0 * (width - 0.5 * web), flange]]);
    composed(&parts, torsion, [web * height / area, 5.0 / 6.0 * 2.0 * width * flange / area])
}

/// Error for a section without extent.
pub(super) fn invalid_section(card: &Card, reason: &str) -> Problem {
    card.problem(format!("{}: {reason}", card.subject()), "correct the dimensions of the section")
}
