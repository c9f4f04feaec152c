//! Stresses of a deformed model at its nodes.

use crate::error::ElementError;
use crate::model::{ElasticModel, Element, ElementKind, ShellShape, SolidShape};
use crate::shell::{ShellElement, surface_stresses};
use crate::solid::{SolidElement, nodal_stresses};
use calyx_numerics::stress::{ElementStresses, NodalStresses, Stress, von_mises};
use rayon::prelude::*;

/// Returns the stresses at the nodes of a model and their estimated errors, from the displacements
/// and rotations of the nodes, m and rad, along the basic axes. NaN at nodes without solids and
/// shells.
///
/// At a node of shells it is the stress on the outer surface with the larger von Mises stress, with
/// the larger error of both. If solids and shells share a node, the stress is that of the solids.
///
/// # Errors
/// An element is degenerate.
pub fn nodal_stresses_of(
    model: &ElasticModel,
    displacements: &[[f64; 6]],
) -> Result<NodalStresses, ElementError> {
    let of_elements: Vec<Option<OfElement>> = model
        .elements
        .par_iter()
        .map(|element| {
            of_element(model, element, displacements)
                .map_err(|error| error.within(format_args!("element {}", element.label)))
        })
        .collect::<Result<_, _>>()?;
    let points: Vec<[f64; 3]> = model.nodes.iter().map(|node| node.position).collect();
    let elements = || model.elements.iter().zip(&of_elements);
    let solids = elements().filter_map(|(element, found)| match found {
        Some(OfElement::Solid(stresses)) => Some(at_nodes_of(element, stresses)),
        _ => None,
    });
    let mut found = NodalStresses::averaged(&points, solids);
    let [below, above] = [0, 1].map(|surface: usize| {
        let shells = elements().filter_map(|(element, found)| match found {
            Some(OfElement::Shell(surfaces)) => Some(at_nodes_of(element, &surfaces[surface])),
            _ => None,
        });
        NodalStresses::averaged(&points, shells)
    });
    for (node, stress) in found.stresses.iter_mut().enumerate() {
        let [lower, upper] = [&below, &above].map(|surface| surface.stresses[node]);
        if stress[0].is_nan() {
            *stress = if von_mises(lower) > von_mises(upper) { lower } else { upper };
            found.errors[node] = below.errors[node].max(above.errors[node]);
        }
    }
    Ok(found)
}

fn at_nodes_of<'a>(element: &'a Element, stresses: &'a [Stress]) -> ElementStresses<'a> {
    let quadratic = match &element.kind {
        ElementKind::Solid(shape) => {
            matches!(shape, SolidShape::Hexahedron20 | SolidShape::Wedge15 | SolidShape::Tetrahedron10)
        }
        ElementKind::Shell { shape, .. } => {
            matches!(shape, ShellShape::Triangle6 | ShellShape::Quadrilateral8 | ShellShape::Quadrilateral9)
        }
        _ => false,
    };
    ElementStresses { nodes: &element.nodes, stresses, quadratic }
}

/// Stresses at the nodes of an element; of a shell on both surfaces.
enum OfElement {
    Solid(Vec<Stress>),
    Shell([Vec<Stress>; 2]),
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
            let both = surface_stresses(&shell, &moved)?;
            Ok(Some(OfElement::Shell(
                [0, 1].map(|surface: usize| both.iter().map(|own| own[surface]).collect()),
            )))
        }
        _ => Ok(None),
    }
}
