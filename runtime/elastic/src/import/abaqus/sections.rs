//! Materials and sections: *MATERIAL, *ELASTIC, *DENSITY, *DAMPING, *SOLID SECTION, *SHELL SECTION,
//! *BEAM SECTION, *MASS, *SPRING.
//!
//! Source: Abaqus Keywords Reference Guide, entries of these names; Abaqus Analysis User's Guide,
//! "Beam cross-section library" and "Choosing a beam element" (transverse shear stiffness).

use super::super::builder::Builder;
use super::super::geometry::cross;
use super::super::origin::Origin;
use super::super::section::{circle, composed, hollow_box, rectangle, rectangle_torsion, tube};
use super::keyword::{Block, DataLine, Result, integer_at, normalized, positive_at, real_at};
use super::mesh::{Kind, Mesh};
use crate::model::{BeamProperties, BeamSection, Element, ElementKind, Material};
use std::collections::HashMap;

/// Section of elements, with the index of its material.
#[derive(Clone)]
enum Section {
    Solid { material: usize, area: f64 },
    Shell { material: usize, thickness: f64, offset: f64 },
    Beam { material: usize, section: BeamSection, first_axis: [f64; 3] },
    Mass(f64),
    Spring { components: [usize; 2], stiffness: f64 },
}

/// Materials by name: index, and location for messages.
pub(super) fn materials(blocks: &[Block], builder: &mut Builder) -> Result<HashMap<String, usize>> {
    let mut names = HashMap::new();
    let mut at = 0;
    while at < blocks.len() {
        let block = &blocks[at];
        at += 1;
        if block.keyword != "MATERIAL" {
            continue;
        }
        let name = block.required("NAME")?;
        let (mut elastic, mut density, mut damping) = (None, 0.0, 0.0);
        while let Some(part) = blocks.get(at).filter(|part| PARTS.contains(&part.keyword.as_str())) {
            at += 1;
            match part.keyword.as_str() {
                "ELASTIC" => elastic = Some(elastic_constants(part)?),
                "DENSITY" => {
                    let line = part.line(0, "the density")?;
                    density = real_at(line, &line.values(), 0, "the density")?;
                    if density < 0.0 || part.data.len() > 1 {
                        let message =
                            format!("material {name}: the density must be one value that is not negative");
                        return Err(line.problem(message, "state one density"));
                    }
                }
                "DAMPING" => {
                    if let Some(text) = part.parameter("STRUCTURAL") {
                        let line = DataLine::new(text, part.place);
                        damping = real_at(&line, &line.values(), 0, "the structural damping")?;
                    }
                }
                // Thermal and plastic properties do not change the elastic body.
                other => builder.skipped.add(&format!("*{other}"), part.place),
            }
        }
        let Some([e, nu]) = elastic else {
            return Err(
                block.problem(format!("material {name} has no *ELASTIC"), "write *ELASTIC after *MATERIAL")
            );
        };
        if names.insert(normalized(name), builder.model.materials.len()).is_some() {
            return Err(
                block.problem(format!("material {name} is defined again"), "rename one of the materials")
            );
        }
        builder.model.materials.push(Material {
            youngs_modulus: e,
            poissons_ratio: nu,
            shear_modulus: e / (2.0 * (1.0 + nu)),
            density,
            structural_damping: damping,
        });
    }
    Ok(names)
}

/// Keywords that belong to a material.
pub(super) const PARTS: [&str; 9] = [
    "ELASTIC",
    "DENSITY",
    "DAMPING",
    "EXPANSION",
    "CONDUCTIVITY",
    "SPECIFICHEAT",
    "PLASTIC",
    "DEPVAR",
    "USERDEFINEDFIELD",
];

fn elastic_constants(block: &Block) -> Result<[f64; 2]> {
    if let Some(kind) = block.parameter("TYPE").map(normalized).filter(|kind| !kind.starts_with("ISO")) {
        return Err(
            block.problem(format!("*ELASTIC: the type {kind} is not supported"), "use an isotropic material")
        );
    }
    if block.data.len() > 1 {
        return Err(block.problem(
            "*ELASTIC depends on temperature, which is not supported",
            "state the constants at one temperature",
        ));
    }
    let line = block.line(0, "Young's modulus and Poisson's ratio")?;
    let values = line.values();
    let e = positive_at(line, &values, 0, "Young's modulus")?;
    let nu = real_at(line, &values, 1, "Poisson's ratio")?;
    if !(nu > -1.0 && nu < 0.5) {
        let message = format!("Poisson's ratio is {nu}, but must be between -1 and 0.5");
        return Err(line.problem(message, "correct the material"));
    }
    Ok([e, nu])
}

/// Reads the sections and converts all elements.
pub(super) fn elements(
    blocks: &[Block],
    mesh: &Mesh,
    materials: &HashMap<String, usize>,
    builder: &mut Builder,
) -> Result<()> {
    let mut sections: HashMap<u64, (usize, Section)> = HashMap::new();
    for (at, block) in blocks.iter().enumerate() {
        let section = match block.keyword.as_str() {
            "SOLIDSECTION" => solid(block, materials)?,
            "SHELLSECTION" => shell(block, materials)?,
            "BEAMSECTION" => beam(block, materials)?,
            "MASS" => {
                let line = block.line(0, "the mass")?;
                Section::Mass(positive_at(line, &line.values(), 0, "the mass")?)
            }
            "SPRING" => spring(block)?,
            _ => continue,
        };
        let name = block.required("ELSET")?;
        for element in mesh.elements_of(name, &DataLine::new(name, block.place))? {
            if let Some((other, _)) = sections.insert(element, (at, section.clone())) {
                return Err(block.problem(
                    format!(
                        "element {element} has two sections; the first is in line {}",
                        blocks[other].place.line
                    ),
                    "let each element belong to the set of one section",
                ));
            }
        }
    }
    for (label, element) in &mesh.elements {
        let origin = Origin { name: element.kind.name, place: element.place };
        let problem = |message: &str, help: &str| {
            let message = format!("element {} {label} {message}", element.kind.name);
            super::super::origin::Problem::new(element.place, message, help)
        };
        let Some((at, section)) = sections.get(label) else {
            return Err(problem("has no section", "add it to the element set of a section"));
        };
        let owner = format!("element {} {label}", element.kind.name);
        let nodes = builder.nodes(&element.nodes, &owner, element.place)?;
        let (kind, material) = match (element.kind.kind, section) {
            (Kind::Solid(shape), Section::Solid { material, .. }) => {
                (ElementKind::Solid(shape), Some(*material))
            }
            (Kind::Truss, Section::Solid { material, area }) => {
                if *area <= 0.0 {
                    return Err(problem("has no area", "state the area in the data line of *SOLID SECTION"));
                }
                (ElementKind::Rod { area: *area, torsion_constant: 0.0, added_mass: 0.0 }, Some(*material))
            }
            (Kind::Shell(shape), Section::Shell { material, thickness, offset }) => {
                let thickness = vec![*thickness; super::super::geometry::shell_corners(shape)];
                (ElementKind::Shell { shape, thickness, offset: *offset, added_mass: 0.0 }, Some(*material))
            }
            (Kind::Beam, Section::Beam { material, section, first_axis }) => {
                let properties = BeamProperties {
                    orientation: *first_axis,
                    sections: [*section; 2],
                    offsets: [[0.0; 3]; 2],
                    released: [[false; 6]; 2],
                };
                (ElementKind::Beam(Box::new(properties)), Some(*material))
            }
            (Kind::Mass, Section::Mass(mass)) => {
                let kind = ElementKind::Mass { mass: *mass, offset: [0.0; 3], inertia: [[0.0; 3]; 3] };
                (kind, None)
            }
            (Kind::Spring, Section::Spring { components, stiffness }) => {
                (ElementKind::Spring { components: *components, stiffness: *stiffness }, None)
            }
            _ => {
                let message =
                    format!("does not fit *{} in line {}", blocks[*at].keyword, blocks[*at].place.line);
                return Err(problem(&message, "use the section that its type needs"));
            }
        };
        builder.element(origin, Element { label: *label, kind, nodes, material })?;
    }
    Ok(())
}

fn material(block: &Block, materials: &HashMap<String, usize>) -> Result<usize> {
    let name = block.required("MATERIAL")?;
    materials.get(&normalized(name)).copied().ok_or_else(|| {
        block.problem(
            format!("*{} refers to material `{name}`, which is not defined", block.keyword),
            "add the *MATERIAL, or correct its name",
        )
    })
}

fn solid(block: &Block, materials: &HashMap<String, usize>) -> Result<Section> {
    block.without(&["COMPOSITE"])?;
    let area = match block.data.first() {
        Some(line) => real_at(line, &line.values(), 0, "the area")?,
        None => 0.0,
    };
    Ok(Section::Solid { material: material(block, materials)?, area })
}

fn shell(block: &Block, materials: &HashMap<String, usize>) -> Result<Section> {
    block.without(&["COMPOSITE", "NODALTHICKNESS", "SHELLTHICKNESS", "STIFFNESSFACTOR"])?;
    let line = block.line(0, "the thickness")?;
    let thickness = positive_at(line, &line.values(), 0, "the thickness")?;
    // The offset is the distance from the mid-surface to the nodes over the thickness.
    let nodes = match block.parameter("OFFSET").map(normalized).as_deref() {
        None => 0.0,
        Some("SPOS") => 0.5,
        Some("SNEG") => -0.5,
        Some(text) => real_at(&DataLine::new(text, block.place), &[text], 0, "OFFSET")?,
    };
    Ok(Section::Shell { material: material(block, materials)?, thickness, offset: -nodes * thickness })
}

/// Section of a beam. The local y axis of the model is the first axis of the section; its z axis is
/// the second. The shear factors are those of Abaqus.
fn beam(block: &Block, materials: &HashMap<String, usize>) -> Result<Section> {
    let kind = normalized(block.required("SECTION")?);
    let line = block.line(0, "the dimensions of the section")?;
    let values = line.values();
    let count = match kind.as_str() {
        "CIRC" => 1,
        "RECT" | "PIPE" => 2,
        "BOX" => 6,
        _ => {
            return Err(block.problem(
                format!("*BEAM SECTION: the section {kind} is not supported"),
                "use RECT, CIRC, PIPE or BOX",
            ));
        }
    };
    let mut d = Vec::with_capacity(count);
    for index in 0..count {
        d.push(positive_at(line, &values, index, &format!("dimension {} of the section", index + 1))?);
    }
    let fits = match kind.as_str() {
        "PIPE" => d[1] <= d[0],
        "BOX" => d[2] + d[4] < d[0] && d[3] + d[5] < d[1],
        _ => true,
    };
    if !fits {
        return Err(
            line.problem(format!("the dimensions of section {kind} do not fit together"), "correct them")
        );
    }
    // `rectangle` and `hollow_box` take the width along z first.
    let section = match kind.as_str() {
        "CIRC" => circle(d[0], 0.89),
        "PIPE" => tube(d[0], d[0] - d[1], 0.53),
        "RECT" => composed(&[rectangle(d[1], d[0], 0.0, 0.0)], rectangle_torsion(d[0], d[1]), [0.85; 2]),
        // Walls: 1 right, 2 top, 3 left, 4 bottom, with the first axis to the right.
        _ => hollow_box(d[1], d[0], [d[2], d[4], d[5], d[3]], Some([0.44; 2])),
    };
    let first_axis = match block.data.get(1) {
        None => [0.0, 0.0, -1.0],
        Some(line) => {
            let values = line.values();
            let mut axis = [0.0; 3];
            for (i, x) in axis.iter_mut().enumerate() {
                *x = real_at(line, &values, i, "the first axis of the section")?;
            }
            axis
        }
    };
    Ok(Section::Beam { material: material(block, materials)?, section, first_axis })
}

fn spring(block: &Block) -> Result<Section> {
    block.without(&["NONLINEAR", "COMPLEXSTIFFNESS", "ORIENTATION"])?;
    let line = block.line(0, "the components")?;
    let values = line.values();
    let first = integer_at(line, &values, 0, "the component")?;
    let second = if values.len() > 1 { integer_at(line, &values, 1, "the component")? } else { first };
    if first > 6 || second > 6 || (first > 3) != (second > 3) {
        let message = "the components must be two of 1 to 3, or two of 4 to 6";
        return Err(line.problem(message, "correct the components of the spring"));
    }
    let line = block.line(1, "the stiffness")?;
    let stiffness = real_at(line, &line.values(), 0, "the stiffness")?;
    Ok(Section::Spring { components: [first as usize - 1, second as usize - 1], stiffness })
}

/// Unit vectors of *TRANSFORM with TYPE=R from a point on the x axis and one in the x-y plane.
pub(super) fn rectangular_axes(a: [f64; 3], b: [f64; 3]) -> Option<[[f64; 3]; 3]> {
    let x = super::super::geometry::unit(a)?;
    let z = super::super::geometry::unit(cross(a, b))?;
    Some([x, cross(z, x), z])
}
