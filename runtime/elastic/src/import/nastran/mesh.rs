//! Mesh of a deck: grid points and the corners of shell and solid elements. Materials, properties,
//! constraints and loads do not matter for it, so all other cards are permitted.
//!
//! Source: NASTRAN Quick Reference Guide, entries of the elements; PSOLID for fluids.

use super::super::error::ImportError;
use super::super::source::{OpenFile, Skipped, Sources};
use super::card::Result;
use super::deck::{self, Card};
use super::systems::{Geometry, repeated};
use crate::import::{NastranMesh, NastranMeshElement, NastranMeshShape};
use crate::model::Node;
use std::collections::BTreeSet;

/// Element cards, their shapes, and the field of the first corner.
const ELEMENTS: [(&str, NastranMeshShape); 11] = [
    ("CTRIA3", NastranMeshShape::Triangle),
    ("CTRIA6", NastranMeshShape::Triangle),
    ("CTRIAR", NastranMeshShape::Triangle),
    ("CQUAD", NastranMeshShape::Quadrilateral),
    ("CQUAD4", NastranMeshShape::Quadrilateral),
    ("CQUAD8", NastranMeshShape::Quadrilateral),
    ("CQUADR", NastranMeshShape::Quadrilateral),
    ("CSHEAR", NastranMeshShape::Quadrilateral),
    ("CTETRA", NastranMeshShape::Tetrahedron),
    ("CPENTA", NastranMeshShape::Wedge),
    ("CHEXA", NastranMeshShape::Hexahedron),
];
/// Field of the first corner of an element.
const FIRST: usize = 3;
/// Solid elements that are not supported: the skin would be open without them.
const PYRAMIDS: [&str; 2] = ["CPYRAM", "CPYRA"];
/// Cards that begin with C and are no elements.
const OTHERS: [&str; 14] = [
    "CORD1R", "CORD1C", "CORD1S", "CORD2R", "CORD2C", "CORD2S", "CORD3G", "CSET", "CSET1", "CSUPER",
    "CSUPEXT", "CYJOIN", "CYSYM", "CREEP",
];

/// Reads the mesh of a deck: see [`crate::import::read_nastran_mesh`].
pub(super) fn read(path: &str, open: &mut OpenFile) -> std::result::Result<NastranMesh, ImportError> {
    let mut sources = Sources::new(open);
    let deck = deck::read(path, &mut sources)?;
    let files = sources.names;
    let mut skipped = Skipped::default();
    let found = mesh(&deck.cards, &mut skipped).map_err(|problem| problem.located(&files))?;
    Ok(NastranMesh { skipped: skipped.finish(&files), files, ..found })
}

fn mesh(cards: &[Card], skipped: &mut Skipped) -> Result<NastranMesh> {
    let nodes = Geometry::of_mesh(cards)?.nodes()?;
    let is_fluid = |card: &&Card| card.name == "PSOLID" && card.text(7) == "PFLUID";
    let fluids: BTreeSet<&str> = cards.iter().filter(is_fluid).map(|card| card.text(1)).collect();
    let shape = |card: &Card| ELEMENTS.iter().find(|(name, _)| *name == card.name).map(|(_, shape)| *shape);
    let mut elements = Vec::new();
    for card in repeated(cards.iter().filter(|card| shape(card).is_some()))? {
        match shape(card) {
            Some(shape) if shape.is_solid() && fluids.contains(card.text(2)) => {
                skipped.add("fluid element", card.place);
            }
            Some(shape) => elements.push(element(card, shape, &nodes)?),
            None => {}
        }
    }
    for card in cards.iter().filter(|card| card.name.starts_with('C') && shape(card).is_none()) {
        if PYRAMIDS.contains(&card.name.as_str()) {
            return Err(card.problem(
                format!("element {} is a pyramid, which is not supported", card.subject()),
                "mesh the part with CHEXA, CPENTA and CTETRA, or give its skin as shell elements",
            ));
        }
        if !OTHERS.contains(&card.name.as_str()) {
            skipped.add(&card.name, card.place);
        }
    }
    Ok(NastranMesh { nodes, elements, files: Vec::new(), skipped: Vec::new() })
}

/// Reads the corners of an element. Quadrilaterals with two equal corners are triangles.
fn element(card: &Card, shape: NastranMeshShape, nodes: &[Node]) -> Result<NastranMeshElement> {
    let label = card.id(1, "EID")?;
    let mut corners = Vec::with_capacity(shape.corners());
    for field in FIRST..FIRST + shape.corners() {
        let grid = card.id(field, "grid point")?;
        match nodes.binary_search_by_key(&grid, |node| node.label) {
            Ok(at) => corners.push(at),
            Err(_) => {
                return Err(card.problem(
                    format!("element {} refers to GRID {grid}, which is not defined", card.subject()),
                    format!("define GRID {grid}, or give the deck with all files that it includes"),
                ));
            }
        }
    }
    let mut shape = shape;
    if shape == NastranMeshShape::Quadrilateral {
        corners.dedup();
        if corners.len() == 4 && corners.first() == corners.last() {
            corners.pop();
        }
        if corners.len() == 3 {
            shape = NastranMeshShape::Triangle;
        }
    }
    let distinct: BTreeSet<usize> = corners.iter().copied().collect();
    if distinct.len() != shape.corners() {
        return Err(card.problem(
            format!("element {} has the same grid point twice", card.subject()),
            "correct its grid points, or remove the element",
        ));
    }
    Ok(NastranMeshElement { label, shape, nodes: corners })
}
