//! Elastic constants and densities of gear materials by name.
//!
//! Strength data are those of ISO 6336-5, in the library module `iso6336_5`.

use calyx_runtime::material::Material;

const STEEL: Material = Material::STEEL;
/// Cast steel (ISO 6336-2:2006, 7).
const CAST_STEEL: Material = Material { youngs_modulus: 202e9, poissons_ratio: 0.3, density: 7850.0 };
/// Spheroidal graphite cast iron (ISO 6336-2:2006, 7; density: EN 1563).
const SPHEROIDAL_IRON: Material = Material { youngs_modulus: 173e9, poissons_ratio: 0.3, density: 7100.0 };
/// Grey cast iron (ISO 6336-2:2006, 7; density: EN 1561).
const GREY_IRON: Material = Material { youngs_modulus: 118e9, poissons_ratio: 0.3, density: 7200.0 };
/// Sintered steel of a density of 7.0 g/cm³: 206 GPa times (7.0/7.86)^3.4 (Beiss).
const SINTERED_STEEL: Material = Material { youngs_modulus: 139e9, poissons_ratio: 0.27, density: 7000.0 };
/// Polyoxymethylene at room temperature. Modulus and density of both plastics: Encyclopedia of
/// Physical Science and Technology, third edition, "Plastics engineering", table I.
const POM: Material = Material { youngs_modulus: 2.9e9, poissons_ratio: 0.35, density: 1410.0 };
/// Polyamide 66, dry, at room temperature.
const PA66: Material = Material { youngs_modulus: 3e9, poissons_ratio: 0.39, density: 1140.0 };

/// Materials by name. Steels of all grades have the same elastic constants.
const MATERIALS: [(&str, Material); 21] = [
    ("steel", STEEL),
    ("16MnCr5", STEEL),
    ("20MnCr5", STEEL),
    ("18CrNiMo7-6", STEEL),
    ("17CrNi6-6", STEEL),
    ("20NiCrMo2-2", STEEL),
    ("31CrMoV9", STEEL),
    ("34CrNiMo6", STEEL),
    ("42CrMo4", STEEL),
    ("C45", STEEL),
    ("cast steel", CAST_STEEL),
    ("GJS", SPHEROIDAL_IRON),
    ("GJS-400-15", SPHEROIDAL_IRON),
    ("GJS-600-3", SPHEROIDAL_IRON),
    ("GJS-700-2", SPHEROIDAL_IRON),
    ("GJL", GREY_IRON),
    ("GJL-200", GREY_IRON),
    ("GJL-250", GREY_IRON),
    ("sintered steel", SINTERED_STEEL),
    ("POM", POM),
    ("PA66", PA66),
];

/// Steel numbers (EN 10027-2) with the names of the steels: EN ISO 683-1 (C45), EN ISO 683-2
/// (quenched and tempered), EN ISO 683-3 (case-hardening), EN ISO 683-5 (nitriding).
const STEEL_NUMBERS: [(&str, &str); 9] = [
    ("1.7131", "16MnCr5"),
    ("1.7147", "20MnCr5"),
    ("1.6587", "18CrNiMo7-6"),
    ("1.5918", "17CrNi6-6"),
    ("1.6523", "20NiCrMo2-2"),
    ("1.8519", "31CrMoV9"),
    ("1.6582", "34CrNiMo6"),
    ("1.7225", "42CrMo4"),
    ("1.0503", "C45"),
];

/// Returns the material with a name or a steel number, and its name.
pub fn named(name: &str) -> Option<(&'static str, Material)> {
    let numbered = STEEL_NUMBERS.into_iter().find(|(number, _)| *number == name);
    let name = numbered.map_or(name, |(_, name)| name);
    MATERIALS.into_iter().find(|(known, _)| *known == name)
}

/// Names of the materials, then the steel numbers.
pub fn names() -> impl Iterator<Item = &'static str> {
    let numbers = STEEL_NUMBERS.into_iter().map(|(number, _)| number);
    MATERIALS.into_iter().map(|(name, _)| name).chain(numbers)
}
