//! Stresses of a deformed model at its nodes.

use crate::error::ElementError;
use crate::model::{ElasticModel, Element, ElementKind};
use crate::shell::{ShellElement, surface_stresses};
use crate::solid::{SolidElement, nodal_stresses};
use rayon::prelude::*;

/// Stresses xx, yy, zz, yz, zx, xy, Pa, along the basic axes.
pub type Stress = [f64; 6];

/// Returns the stress at each node of a model, the mean of those of the elements at the node, from
/// the displacements and rotations of the nodes, m and rad, along the basic axes. `None` for nodes
/// without solids and shells.
///
/// At a node of shells it is the stress on the outer surface with the larger von Mises stress. If
/// solids and shells share a node, the stress is that of the solids.
///
/// # Errors
/// An element is degenerate.
pub fn nodal_stresses_of(
    model: &ElasticModel,
    displacements: &[[f64; 6]],
) -> Result<Vec<Option<Stress>>, ElementError> {
    let of_elements: Vec<Option<OfElement>> = model
        .elements
        .par_iter()
        .map(|element| {
            of_element(model, element, displacements)
                .map_err(|error| error.within(format_args!("element {}", element.label)))
        })
        .collect::<Result<_, _>>()?;
    let count = model.nodes.len();
    let mut solids = vec![([0.0; 6], 0_usize); count];
    let mut shells = vec![([[0.0; 6]; 2], 0_usize); count];
    for (element, found) in model.elements.iter().zip(of_elements) {
        match found {
            Some(OfElement::Solid(stresses)) => {
                for (&node, stress) in element.nodes.iter().zip(stresses) {
                    add(&mut solids[node].0, &stress);
                    solids[node].1 += 1;
                }
            }
            Some(OfElement::Shell(stresses)) => {
                for (&node, surfaces) in element.nodes.iter().zip(stresses) {
                    surfaces.iter().zip(&mut shells[node].0).for_each(|(stress, sum)| add(sum, stress));
                    shells[node].1 += 1;
                }
            }
            None => {}
        }
    }
    let mean = |sum: &Stress, count: usize| sum.map(|part| part / count as f64);
    let at_node = |(solid, shell): (&(Stress, usize), &([Stress; 2], usize))| match (solid.1, shell.1) {
        (0, 0) => None,
        (0, count) => {
            let [below, above] = shell.0.each_ref().map(|sum| mean(sum, count));
            Some(if von_mises(below) > von_mises(above) { below } else { above })
        }
        (count, _) => Some(mean(&solid.0, count)),
    };
    Ok(solids.iter().zip(&shells).map(at_node).collect())
}

/// Computes the von Mises stress.
pub fn von_mises([xx, yy, zz, yz, zx, xy]: Stress) -> f64 {
    let direct = (xx - yy).powi(2) + (yy - zz).powi(2) + (zz - xx).powi(2);
    (0.5 * direct + 3.0 * (yz * yz + zx * zx + xy * xy)).sqrt()
}

/// Stresses at the nodes of an element; of a shell on both surfaces.
enum OfElement {
    Solid(Vec<Stress>),
    Shell(Vec<[Stress; 2]>),
}

fn of_element(
    model: &ElasticModel,
    element: &Element,
    displacements: &[[f64; 6]],
) -> Result<Option<OfElement>, ElementError> {
    let Some(material) = element.material.and_then(|material| model.materials.get(material)) else {
        return Ok(None);
    };
    let positions: Vec<[f64; 3]> = element.nodes.iter().map(|&node| model.nodes[node].position).collect();
    let moved = element.nodes.iter().map(|&node| displacements[node]);
    match &element.kind {
        ElementKind::Solid(shape) => {
            let solid = SolidElement { shape: *shape, positions: &positions, material };
            let moved: Vec<[f64; 3]> = moved.map(|[x, y, z, ..]| [x, y, z]).collect();
            nodal_stresses(&solid, &moved).map(|stresses| Some(OfElement::Solid(stresses)))
        }
        ElementKind::Shell { shape, thickness, offset, added_mass } => {
            let shell = ShellElement {
                shape: *shape,
                positions: &positions,
                thickness,
                offset: *offset,
                material,
                added_mass: *added_mass,
            };
            let moved: Vec<[f64; 6]> = moved.collect();
            surface_stresses(&shell, &moved).map(|stresses| Some(OfElement::Shell(stresses)))
        }
        _ => Ok(None),
    }
}

fn add(sum: &mut Stress, stress: &Stress) {
    sum.iter_mut().zip(stress).for_each(|(sum, part)| *sum += part);
}
