//! Materials and properties: MAT1, PSHELL, PSOLID, PROD, PELAS.
//!
//! Source: NASTRAN Quick Reference Guide, entries of these names.

use super::card::Result;
use super::deck::Card;
use super::systems::repeated;
use super::{beam_properties, pbeam};
use crate::model::{BeamSection, Material};
use std::collections::HashMap;

/// Family of properties: identification numbers are unique within it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Family {
    Shell,
    Solid,
    Bar,
    Beam,
    Rod,
    Spring,
}

impl Family {
    fn of(card: &str) -> Option<Self> {
        Some(match card {
            "PSHELL" => Self::Shell,
            "PSOLID" => Self::Solid,
            "PBAR" | "PBARL" => Self::Bar,
            "PBEAM" | "PBEAML" => Self::Beam,
            "PROD" => Self::Rod,
            "PELAS" => Self::Spring,
            _ => return None,
        })
    }

    /// Names of the property cards of the family.
    fn cards(self) -> &'static str {
        match self {
            Self::Shell => "PSHELL",
            Self::Solid => "PSOLID",
            Self::Bar => "PBAR or PBARL",
            Self::Beam => "PBEAM or PBEAML",
            Self::Rod => "PROD",
            Self::Spring => "PELAS",
        }
    }
}

/// Property of elements, with the index of its material.
#[derive(Clone, Debug)]
pub(super) enum Property {
    Shell {
        material: usize,
        thickness: Option<f64>,
        added_mass: f64,
    },
    /// `bubble` is true if hexahedra of 8 nodes have incompatible modes (bubble functions).
    Solid {
        material: usize,
        bubble: bool,
    },
    Beam {
        material: usize,
        sections: Box<[BeamSection; 2]>,
    },
    Rod {
        material: usize,
        area: f64,
        torsion_constant: f64,
        added_mass: f64,
    },
    Spring {
        stiffness: f64,
    },
}

/// Materials and properties of a deck.
#[derive(Default)]
pub(super) struct Properties {
    pub materials: Vec<Material>,
    material_index: HashMap<u64, usize>,
    properties: HashMap<(Family, u64), Property>,
    pub notes: Vec<String>,
}

impl Properties {
    pub fn read(cards: &[Card]) -> Result<Self> {
        let mut all = Self::default();
        for card in repeated(cards.iter().filter(|card| card.name == "MAT1"))? {
            let material = material(card)?;
            all.material_index.insert(card.id(1, "MID")?, all.materials.len());
            all.materials.push(material);
        }
        let cards = repeated(cards.iter().filter(|card| Family::of(&card.name).is_some()))?;
        for card in cards {
            let Some(family) = Family::of(&card.name) else { continue };
            if family == Family::Spring {
                all.springs(card)?;
                continue;
            }
            let id = card.id(1, "PID")?;
            let property = match family {
                Family::Shell => all.shell(card)?,
                Family::Solid => all.solid(card)?,
                Family::Rod => all.rod(card)?,
                Family::Bar => Property::Beam {
                    material: all.material(card, 2, "MID")?,
                    sections: Box::new([beam_properties::bar(card)?; 2]),
                },
                Family::Beam | Family::Spring => Property::Beam {
                    material: all.material(card, 2, "MID")?,
                    sections: Box::new(pbeam::beam(card)?),
                },
            };
            if all.properties.insert((family, id), property).is_some() {
                let message = format!("{} is defined by two cards", card.subject());
                return Err(card.problem(message, "remove one of the two, or renumber it"));
            }
        }
        Ok(all)
    }

    /// Index of the material that a field refers to.
    pub fn material(&self, card: &Card, field: usize, what: &str) -> Result<usize> {
        let id = card.id(field, what)?;
        self.material_index.get(&id).copied().ok_or_else(|| {
            card.problem(
                format!("{} refers to material {id} ({what}), which no MAT1 card defines", card.subject()),
                format!("add MAT1 {id}, or correct the reference"),
            )
        })
    }

    /// Property that an element refers to.
    pub fn of(&self, card: &Card, field: usize, family: Family) -> Result<&Property> {
        // A blank property number is that of the element.
        let id = match card.is_blank(field) {
            true => card.id(1, "EID")?,
            false => card.id(field, "PID")?,
        };
        self.properties.get(&(family, id)).ok_or_else(|| {
            card.problem(
                format!(
                    "element {} refers to property {id}, which no {} card defines",
                    card.subject(),
                    family.cards()
                ),
                format!("add {} {id}, or correct the reference", family.cards()),
            )
        })
    }

    fn shell(&mut self, card: &Card) -> Result<Property> {
        let material = self.material(card, 2, "MID1")?;
        let thickness = match card.is_blank(3) {
            true => None,
            false => Some(card.positive(3, "T")?),
        };
        if card.is_blank(4) {
            return Err(card.problem(
                format!(
                    "{} has no MID2: a membrane without bending stiffness is not supported",
                    card.subject()
                ),
                "write the number of the material as MID2",
            ));
        }
        for (field, what) in [(4, "MID2"), (6, "MID3")] {
            if !card.is_blank(field) && self.material(card, field, what)? != material {
                let message = format!("{}: {what} differs from MID1, which is not supported", card.subject());
                return Err(
                    card.problem(message, "use one material for membrane, bending and transverse shear")
                );
            }
        }
        let expect = |field: usize, what: &str, expected: f64| -> Result<()> {
            let value = card.real_or(field, expected, what)?;
            if (value - expected).abs() <= 1e-3 * expected {
                return Ok(());
            }
            let message =
                format!("{}: {what} is {value}, but only {expected:.4} is supported", card.subject());
            Err(card.problem(message, "leave the field blank, or change the thickness"))
        };
        expect(5, "12I/T**3", 1.0)?;
        expect(7, "TS/T", 5.0 / 6.0)?;
        card.unsupported([11], "MID4")?;
        if card.is_blank(6) {
            self.notes.push(format!(
                "{} has no MID3: the model includes the transverse shear flexibility that NASTRAN neglects",
                card.subject()
            ));
        }
        Ok(Property::Shell { material, thickness, added_mass: card.not_negative(8, "NSM")? })
    }

    fn solid(&mut self, card: &Card) -> Result<Property> {
        if !card.is_blank(7) && card.text(7) != "SMECH" {
            let message = format!("{} is a fluid (FCTN = {})", card.subject(), card.text(7));
            return Err(card.problem(message, "export the structure only"));
        }
        let bubble = match card.text(4) {
            "" | "1" | "2" | "3" | "GAUSS" | "TWO" | "THREE" | "REDUCED" | "FULL" => false,
            "0" | "BUBBLE" => true,
            other => {
                let message = format!("{} has the integration network {other}", card.subject());
                return Err(card.problem(message, "leave IN blank, or state BUBBLE, TWO or THREE"));
            }
        };
        if !bubble && matches!(card.text(6), "0" | "REDUCED") {
            self.notes.push(format!(
                "{} asks for reduced shear integration (ISOP), and the model integrates fully, which is stiffer in bending",
                card.subject()
            ));
        }
        Ok(Property::Solid { material: self.material(card, 2, "MID")?, bubble })
    }

    fn rod(&self, card: &Card) -> Result<Property> {
        Ok(Property::Rod {
            material: self.material(card, 2, "MID")?,
            area: card.positive(3, "A")?,
            torsion_constant: card.not_negative(4, "J")?,
            added_mass: card.not_negative(6, "NSM")?,
        })
    }

    fn springs(&mut self, card: &Card) -> Result<()> {
        for first in [1, 5] {
            if first == 5 && card.is_blank(first) {
                break;
            }
            let id = card.id(first, "PID")?;
            let property = Property::Spring { stiffness: card.real(first + 1, "K")? };
            if self.properties.insert((Family::Spring, id), property).is_some() {
                let message = format!("PELAS {id} is defined again");
                return Err(card.problem(message, "remove one of the two, or renumber it"));
            }
        }
        Ok(())
    }
}

/// Material of a MAT1 card. One of E, G and NU may be blank: E = 2 (1 + NU) G.
fn material(card: &Card) -> Result<Material> {
    let e = card.optional_real(2, "E")?;
    let g = card.optional_real(3, "G")?;
    let nu = card.optional_real(4, "NU")?;
    let (e, g, nu) = match (e, g, nu) {
        (Some(e), None, Some(nu)) => (e, e / (2.0 * (1.0 + nu)), nu),
        (None, Some(g), Some(nu)) => (2.0 * (1.0 + nu) * g, g, nu),
        (Some(e), Some(g), None) => (e, g, e / (2.0 * g) - 1.0),
        (Some(e), Some(g), Some(nu)) => (e, g, nu),
        // NASTRAN would use a material without shear stiffness.
        (Some(_), None, None) | (None, ..) => {
            let message = format!("{} states less than two of E, G and NU", card.subject());
            return Err(card.problem(message, "write E and NU"));
        }
    };
    let rejected = |quantity: &str, value: f64, range: &str| {
        Err(card.problem(
            format!("{}: {quantity} is {value}, but must be {range}", card.subject()),
            "correct the material",
        ))
    };
    if !(e > 0.0 && e.is_finite()) {
        return rejected("Young's modulus E", e, "positive");
    }
    if !(nu > -1.0 && nu < 0.5) {
        return rejected("Poisson's ratio NU", nu, "between -1 and 0.5");
    }
    if !(g > 0.0 && g.is_finite()) {
        return rejected("the shear modulus G", g, "positive");
    }
    let density = card.not_negative(5, "RHO")?;
    let structural_damping = card.real_or(8, 0.0, "GE")?;
    Ok(Material { youngs_modulus: e, poissons_ratio: nu, shear_modulus: g, density, structural_damping })
}
