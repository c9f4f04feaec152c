//! Surface meshes and sound fields as datasets.

use super::dataset::{Element, LocatedValues, NodalData, Node, ResultKind, Units, UnvDataset, UnvFile};
use crate::error::AcousticError;
use crate::mesh::{Face, SurfaceMesh};
use crate::plane::RigidPlane;
use crate::radiation::Radiation;
use std::collections::HashMap;

/// Creates a surface mesh from the linear triangles and quadrilaterals of a file (descriptors 41,
/// 44, 91 and 94), with the labels of its vertices and faces. Nodes of no such element are omitted.
///
/// # Errors
/// A node has two positions or is missing, the file has no such element, or the surface does not
/// enclose a body.
pub fn surface_mesh(
    file: &UnvFile,
    plane: Option<RigidPlane>,
) -> Result<(SurfaceMesh, Vec<i64>, Vec<i64>), AcousticError> {
    let factor = file.length_factor();
    let mut positions: HashMap<i64, [f64; 3]> = HashMap::new();
    let mut elements: Vec<&Element> = Vec::new();
    for dataset in &file.datasets {
        match dataset {
            UnvDataset::Nodes(nodes) => {
                for node in nodes {
                    let position = node.position.map(|x| x / factor);
                    if positions.insert(node.label, position).is_some_and(|other| other != position) {
                        return Err(AcousticError::mesh(
                            format!("node {}", node.label),
                            "the file has two positions for it",
                            "remove one of the nodes",
                        ));
                    }
                }
            }
            UnvDataset::Elements(found) => {
                elements.extend(found.iter().filter(|element| corners(element.descriptor).is_some()));
            }
            _ => {}
        }
    }
    if elements.is_empty() {
        return Err(AcousticError::mesh(
            "file",
            "it has no linear triangles or quadrilaterals (descriptors 41, 44, 91, 94)",
            "export the skin of the body as shell elements",
        ));
    }
    let mut numbers: HashMap<i64, usize> = HashMap::new();
    let (mut vertices, mut labels, mut faces) = (Vec::new(), Vec::new(), Vec::new());
    for element in &elements {
        let place = || format!("element {}", element.label);
        let mut own = Vec::new();
        for label in &element.nodes {
            let Some(position) = positions.get(label) else {
                let message = format!("its node {label} is not in the file");
                return Err(AcousticError::mesh(place(), message, "export the nodes with the elements"));
            };
            own.push(*numbers.entry(*label).or_insert_with(|| {
                vertices.push(*position);
                labels.push(*label);
                vertices.len() - 1
            }));
        }
        faces.push(match (corners(element.descriptor), own.as_slice()) {
            (Some(3), &[a, b, c]) => Face::Triangle([a, b, c]),
            (Some(4), &[a, b, c, d]) => Face::Quadrilateral([a, b, c, d]),
            _ => {
                let message = format!("it has {} nodes, which its descriptor does not permit", own.len());
                return Err(AcousticError::mesh(place(), message, "correct the number of nodes"));
            }
        });
    }
    let mesh = SurfaceMesh::new(vertices, &faces, plane)?;
    Ok((mesh, labels, elements.iter().map(|element| element.label).collect()))
}

/// Number of corners of a linear surface element.
fn corners(descriptor: i64) -> Option<usize> {
    match descriptor {
        41 | 91 => Some(3),
        44 | 94 => Some(4),
        _ => None,
    }
}

/// Returns the units, nodes and triangles of a mesh. Labels are indices plus 1.
pub fn mesh_datasets(mesh: &SurfaceMesh) -> Vec<UnvDataset> {
    triangle_datasets(mesh.vertices(), mesh.triangles())
}

/// Returns the units, nodes (m) and triangles of a surface. Labels are indices plus 1.
pub fn triangle_datasets(vertices: &[[f64; 3]], triangles: &[[usize; 3]]) -> Vec<UnvDataset> {
    let node = |(index, position): (usize, &[f64; 3])| Node {
        label: index as i64 + 1,
        attributes: [1, 1, 11],
        position: *position,
    };
    let element = |(index, triangle): (usize, &[usize; 3])| Element {
        label: index as i64 + 1,
        descriptor: 91,
        attributes: [1, 1, 7],
        beam: None,
        nodes: triangle.iter().map(|vertex| *vertex as i64 + 1).collect(),
    };
    vec![
        UnvDataset::Units(Units::si()),
        UnvDataset::Nodes(vertices.iter().enumerate().map(node).collect()),
        UnvDataset::Elements(triangles.iter().enumerate().map(element).collect()),
    ]
}

/// Returns the surface pressure as results of a frequency response at the nodes of
/// [`mesh_datasets`]. `step` is the number of the frequency, from 1.
pub fn pressure_dataset(radiation: &Radiation, step: i64) -> UnvDataset {
    let values = radiation
        .pressures()
        .iter()
        .enumerate()
        .map(|(index, pressure)| LocatedValues { label: index as i64 + 1, values: vec![*pressure] });
    UnvDataset::NodalData(NodalData {
        names: vec!["Sound pressure on the surface, Pa".into()],
        // Frequency response of scalars; 15 is pressure.
        kind: ResultKind { model: 1, analysis: 5, characteristic: 1, quantity: 15 },
        is_complex: true,
        integers: vec![1, step],
        reals: vec![radiation.frequency()],
        values: values.collect(),
    })
}
