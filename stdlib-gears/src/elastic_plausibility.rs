//! Warnings about imported elastic bodies that are valid but probably not meant: materials in other
//! units, parts that are not connected, and solids that lock.

use crate::error::Severity;
use crate::host::Finding;
use calyx_abi::RuntimeError;
use calyx_runtime::elastic::connectivity::parts_with_elements;
use calyx_runtime::elastic::import::Units;
use calyx_runtime::elastic::model::SolidShape;
use calyx_runtime::elastic::{ElasticModel, ElementKind, Material};
use std::ops::RangeInclusive;

/// Young's moduli of structural materials, Pa: from rubber-like plastics to ceramics.
const YOUNGS_MODULI: RangeInclusive<f64> = 1e8..=1e12;
/// Densities of structural materials, kg/m³: from foams to tungsten.
const DENSITIES: RangeInclusive<f64> = 100.0..=30e3;
/// Largest number of parts that a message lists.
const LISTED: usize = 3;

/// Returns warnings about a body that was read in units of this name, if the file states its
/// materials.
pub(crate) fn of_elastic_body(
    name: &str,
    model: &ElasticModel,
    units: Option<&(String, Units)>,
    place: (u32, u32, u32),
) -> Vec<Finding> {
    let mut found = Vec::new();
    let mut warn = |argument: &str, message: String, help: String| {
        let error = RuntimeError::new("E0994", message, help).of_argument(argument);
        let error = RuntimeError { place: Some(place), ..error };
        found.push(Finding { severity: Severity::Warning, error });
    };
    if let Some((named, units)) = units
        && let Some(problem) = used_materials(model).find_map(implausible)
    {
        warn("units", format!("the elastic body \"{name}\" has {problem}"), units_help(model, named, units));
    }
    let parts = parts_with_elements(model);
    if parts.len() > 1 {
        let listed: Vec<String> = parts
            .iter()
            .take(LISTED)
            .map(|nodes| format!("{} nodes with node {}", nodes.len(), model.nodes[nodes[0]].label))
            .collect();
        let more = if parts.len() > LISTED { " and others" } else { "" };
        let message = format!(
            "the elastic body \"{name}\" has {} parts that neither elements nor constraints connect: {}{more}",
            parts.len(),
            listed.join(", ")
        );
        let help = "merge coincident nodes, or connect the parts by a rigid element or by attachments";
        warn("path", message, help.into());
    }
    let [locking, solids] = count_solids(model);
    if 2 * locking > solids {
        let message = format!(
            "{locking} of the {solids} solids of the elastic body \"{name}\" are linear: a wall with one layer of them is at least 40 % too stiff in bending"
        );
        let help = "use solids with midside nodes, shells, or hexahedra with incompatible modes: IN = BUBBLE in a PSOLID of NASTRAN, type C3D8I of Abaqus";
        warn("path", message, help.into());
    }
    found
}

/// Returns the number of solids that lock in bending, and of all solids.
fn count_solids(model: &ElasticModel) -> [usize; 2] {
    let mut counts = [0, 0];
    for element in &model.elements {
        let ElementKind::Solid(shape) = element.kind else { continue };
        counts[1] += 1;
        counts[0] += match shape {
            SolidShape::Hexahedron8 | SolidShape::Wedge6 | SolidShape::Tetrahedron4 => 1,
            SolidShape::IncompatibleHexahedron8
            | SolidShape::Hexahedron20
            | SolidShape::Wedge15
            | SolidShape::Tetrahedron10 => 0,
        };
    }
    counts
}

/// Returns the materials of the elements of a model.
fn used_materials(model: &ElasticModel) -> impl Iterator<Item = &Material> {
    let mut used = vec![false; model.materials.len()];
    model.elements.iter().filter_map(|element| element.material).for_each(|material| used[material] = true);
    model.materials.iter().zip(used).filter(|(_, used)| *used).map(|(material, _)| material)
}

/// Densities of metals, kg/m^3, of which none is softer than [`SOFTEST_METAL`].
const METAL_DENSITIES: RangeInclusive<f64> = 2500.0..=12_000.0;
/// Smallest Young's modulus of a structural metal, Pa: lead has 16 GPa.
const SOFTEST_METAL: f64 = 10e9;

/// Returns what is implausible about a material, in words. A density of zero means no mass.
fn implausible(material: &Material) -> Option<String> {
    let Material { youngs_modulus, density, .. } = *material;
    let is_soft_metal = METAL_DENSITIES.contains(&density) && youngs_modulus < SOFTEST_METAL;
    if !YOUNGS_MODULI.contains(&youngs_modulus) || is_soft_metal {
        return Some(format!("a Young's modulus of {} GPa", shown(1e-9 * youngs_modulus)));
    }
    let has_mass = density != 0.0;
    (has_mass && !DENSITIES.contains(&density)).then(|| format!("a density of {} kg/m^3", shown(density)))
}

/// Returns the remedy: the system of units in which all materials are plausible, if there is one,
/// and the values of steel in the units of the file.
fn units_help(model: &ElasticModel, named: &str, units: &Units) -> String {
    let stress = |units: &Units| units.force / units.length.powi(2);
    let density = |units: &Units| units.mass() / units.length.powi(3);
    let plausible_in = |other: &Units| {
        used_materials(model).all(|material| {
            let converted = Material {
                youngs_modulus: material.youngs_modulus * stress(other) / stress(units),
                density: material.density * density(other) / density(units),
                ..material.clone()
            };
            implausible(&converted).is_none()
        })
    };
    let known = Units::NAMES.iter().filter(|other| **other != named);
    let meant = known.into_iter().find(|other| Units::named(other).is_some_and(|units| plausible_in(&units)));
    let steel = format!(
        "in the units \"{named}\" steel has E = {} and a density of {}",
        shown(206e9 / stress(units)),
        shown(7850.0 / density(units))
    );
    match meant {
        Some(meant) => format!("is `units = \"{meant}\"` meant? {steel}"),
        None => format!("correct the materials of the file: {steel}"),
    }
}

/// Rounds a number to the digits of a message.
fn shown(value: f64) -> String {
    let rounded: f64 = format!("{value:.3e}").parse().unwrap_or(value);
    match rounded.abs() {
        size if (1e-3..1e7).contains(&size) => rounded.to_string(),
        _ => format!("{rounded:e}"),
    }
}
