//! Elements: CQUAD4/8, CTRIA3/6, CHEXA, CPENTA, CTETRA, CBAR, CBEAM, CROD, CONROD, CELAS1/2, CONM2.
//!
//! Source: NASTRAN Quick Reference Guide, entries of these names.

use super::super::builder::Builder;
use super::super::geometry::{Vector, add, scale, sub};
use super::card::Result;
use super::deck::Card;
use super::fields::integer;
use super::properties::{Family, Properties, Property};
use super::systems::{Geometry, repeated};
use crate::model::{BeamProperties, Element, ElementKind, Node, ShellShape, SolidShape};

/// Names of element cards.
pub(super) const NAMES: [&str; 14] = [
    "CQUAD4", "CQUAD8", "CTRIA3", "CTRIA6", "CHEXA", "CPENTA", "CTETRA", "CBAR", "CBEAM", "CROD", "CONROD",
    "CELAS1", "CELAS2", "CONM2",
];

/// Tables that elements refer to.
struct Tables<'t> {
    builder: &'t Builder,
    properties: &'t Properties,
    geometry: &'t mut Geometry,
}

/// Reads all elements of a deck.
pub(super) fn read(
    cards: &[Card],
    builder: &mut Builder,
    properties: &Properties,
    geometry: &mut Geometry,
) -> Result<()> {
    for card in repeated(cards.iter().filter(|card| NAMES.contains(&card.name.as_str())))? {
        let Some(name) = NAMES.into_iter().find(|name| *name == card.name) else { continue };
        let mut tables = Tables { builder, properties, geometry };
        let element = tables.element(card, name)?;
        builder.element(card.origin(name), element)?;
    }
    Ok(())
}

impl Tables<'_> {
    fn element(&mut self, card: &Card, name: &str) -> Result<Element> {
        match name {
            "CHEXA" => self.solid(card, [(8, SolidShape::Hexahedron8), (20, SolidShape::Hexahedron20)]),
            "CPENTA" => self.solid(card, [(6, SolidShape::Wedge6), (15, SolidShape::Wedge15)]),
            "CTETRA" => self.solid(card, [(4, SolidShape::Tetrahedron4), (10, SolidShape::Tetrahedron10)]),
            "CQUAD4" | "CTRIA3" | "CQUAD8" | "CTRIA6" => self.shell(card, name),
            "CBAR" => self.beam(card, Family::Bar),
            "CBEAM" => self.beam(card, Family::Beam),
            "CROD" | "CONROD" => self.rod(card),
            "CELAS1" | "CELAS2" => self.spring(card),
            _ => self.mass(card),
        }
    }

    /// Subject of messages about an element.
    fn nodes(&self, card: &Card, labels: &[u64]) -> Result<Vec<usize>> {
        self.builder.nodes(labels, &format!("element {}", card.subject()), card.place)
    }

    /// Labels of the grid points in consecutive fields. Midside nodes may be left out altogether.
    /// Returns true as well if they are there.
    fn labels(&self, card: &Card, first: usize, counts: [usize; 2]) -> Result<(Vec<u64>, bool)> {
        let [corners, all] = counts;
        let filled = (first..first + all).filter(|field| !card.is_blank(*field)).count();
        let has_corners = (first..first + corners).all(|field| !card.is_blank(field));
        if !has_corners || (filled != corners && filled != all) {
            let needed = if all == corners { corners.to_string() } else { format!("{corners} or {all}") };
            return Err(card.problem(
                format!("element {} has {filled} grid points, but needs {needed}", card.subject()),
                "check the continuation lines of the card and their columns",
            ));
        }
        let labels =
            (first..first + filled).map(|field| card.id(field, "grid point")).collect::<Result<_>>()?;
        Ok((labels, filled == all))
    }

    fn solid(&self, card: &Card, shapes: [(usize, SolidShape); 2]) -> Result<Element> {
        let [(corners, linear), (all, quadratic)] = shapes;
        let (labels, has_midsides) = self.labels(card, 3, [corners, all])?;
        if card.len() > 2 + all {
            let message = format!("element {} has more than {all} grid points", card.subject());
            return Err(card.problem(message, "check the continuation lines of the card and their columns"));
        }
        let Property::Solid { material, bubble } = self.properties.of(card, 2, Family::Solid)? else {
            return Err(card.problem("the property is not solid", "refer to a PSOLID"));
        };
        let linear = match linear {
            SolidShape::Hexahedron8 if *bubble => SolidShape::IncompatibleHexahedron8,
            other => other,
        };
        Ok(Element {
            label: card.id(1, "EID")?,
            kind: ElementKind::Solid(if has_midsides { quadratic } else { linear }),
            nodes: self.nodes(card, &labels)?,
            material: Some(*material),
        })
    }

    fn shell(&self, card: &Card, name: &str) -> Result<Element> {
        // Fields of the first thickness, ZOFFS and TFLAG.
        let (counts, [thickness, offset, flag]) = match name {
            "CTRIA3" => ([3, 3], [11, 7, 10]),
            "CTRIA6" => ([3, 6], [11, 10, 14]),
            "CQUAD8" => ([4, 8], [11, 16, 17]),
            _ => ([4, 4], [11, 8, 10]),
        };
        let (labels, has_midsides) = self.labels(card, 3, counts)?;
        let shape = match (counts[0], has_midsides && counts[1] > counts[0]) {
            (3, false) => ShellShape::Triangle3,
            (3, true) => ShellShape::Triangle6,
            (_, false) => ShellShape::Quadrilateral4,
            (_, true) => ShellShape::Quadrilateral8,
        };
        let Property::Shell { material, thickness: default, added_mass } =
            self.properties.of(card, 2, Family::Shell)?
        else {
            return Err(card.problem("the property is not a shell", "refer to a PSHELL"));
        };
        let relative = match card.optional_integer(flag, "TFLAG")?.unwrap_or(0) {
            0 => 1.0,
            _ => default.unwrap_or(0.0),
        };
        let mut corners = Vec::with_capacity(counts[0]);
        for i in 0..counts[0] {
            let stated = card.optional_real(thickness + i, "corner thickness")?.map(|value| value * relative);
            let Some(value) = stated.or(*default).filter(|value| *value > 0.0) else {
                return Err(card.problem(
                    format!("element {} has no positive thickness at corner {}", card.subject(), i + 1),
                    "write T on the PSHELL, or T1 to T4 on the element",
                ));
            };
            corners.push(value);
        }
        let kind = ElementKind::Shell {
            shape,
            thickness: corners,
            offset: card.real_or(offset, 0.0, "ZOFFS")?,
            added_mass: *added_mass,
        };
        let nodes = self.nodes(card, &labels)?;
        Ok(Element { label: card.id(1, "EID")?, kind, nodes, material: Some(*material) })
    }

    fn node(&self, index: usize) -> &Node {
        &self.builder.model.nodes[index]
    }

    fn beam(&self, card: &Card, family: Family) -> Result<Element> {
        let Property::Beam { material, sections } = self.properties.of(card, 2, family)? else {
            return Err(card.problem("the property is not a beam", "refer to a PBAR or a PBEAM"));
        };
        let nodes = self.nodes(card, &[card.id(3, "GA")?, card.id(4, "GB")?])?;
        let flag = if card.is_blank(8) { "GGG" } else { card.text(8) };
        let bytes = flag.as_bytes();
        if bytes.len() != 3 || !matches!(bytes[0], b'G' | b'B') || bytes[1..] != *b"GG" {
            return Err(card.problem(
                format!("element {}: OFFT = `{flag}` is not supported", card.subject()),
                "state the orientation and the offsets in the displacement systems (GGG)",
            ));
        }
        let along_axes = |node: usize, vector: Vector| {
            let axes = self.node(node).axes;
            (0..3).fold([0.0; 3], |sum, i| add(sum, scale(axes[i], vector[i])))
        };
        let is_grid =
            !card.is_blank(5) && integer(card.text(5)).is_some() && card.is_blank(6) && card.is_blank(7);
        let orientation = if is_grid {
            let target = self.nodes(card, &[card.id(5, "G0")?])?[0];
            sub(self.node(target).position, self.node(nodes[0]).position)
        } else {
            let vector = card.vector(5, "X1, X2, X3")?;
            if bytes[0] == b'B' { vector } else { along_axes(nodes[0], vector) }
        };
        if family == Family::Beam {
            card.unsupported([17, 18], "warping (SA, SB)")?;
        }
        let properties = BeamProperties {
            orientation,
            sections: **sections,
            offsets: [
                along_axes(nodes[0], card.vector(11, "W1A, W2A, W3A")?),
                along_axes(nodes[1], card.vector(14, "W1B, W2B, W3B")?),
            ],
            released: [card.optional_components(9, "PA")?, card.optional_components(10, "PB")?],
        };
        let kind = ElementKind::Beam(Box::new(properties));
        Ok(Element { label: card.id(1, "EID")?, kind, nodes, material: Some(*material) })
    }

    fn rod(&self, card: &Card) -> Result<Element> {
        let label = card.id(1, "EID")?;
        if card.name == "CONROD" {
            let nodes = self.nodes(card, &[card.id(2, "G1")?, card.id(3, "G2")?])?;
            let kind = ElementKind::Rod {
                area: card.positive(5, "A")?,
                torsion_constant: card.not_negative(6, "J")?,
                added_mass: card.not_negative(8, "NSM")?,
            };
            return Ok(Element {
                label,
                kind,
                nodes,
                material: Some(self.properties.material(card, 4, "MID")?),
            });
        }
        let Property::Rod { material, area, torsion_constant, added_mass } =
            self.properties.of(card, 2, Family::Rod)?
        else {
            return Err(card.problem("the property is not a rod", "refer to a PROD"));
        };
        let nodes = self.nodes(card, &[card.id(3, "G1")?, card.id(4, "G2")?])?;
        let kind =
            ElementKind::Rod { area: *area, torsion_constant: *torsion_constant, added_mass: *added_mass };
        Ok(Element { label, kind, nodes, material: Some(*material) })
    }

    fn spring(&self, card: &Card) -> Result<Element> {
        let stiffness = match self.properties.of(card, 2, Family::Spring) {
            _ if card.name == "CELAS2" => card.real(2, "K")?,
            Ok(Property::Spring { stiffness }) => *stiffness,
            Ok(_) => return Err(card.problem("the property is not a spring", "refer to a PELAS")),
            Err(problem) => return Err(problem),
        };
        let mut ends = Vec::new();
        for field in [3, 5] {
            // A blank or zero grid point is ground.
            if card.optional_integer(field, "grid point")?.unwrap_or(0) != 0 {
                ends.push((card.id(field, "grid point")?, card.component(field + 1, "component")?));
            }
        }
        let kinds = ends.iter().map(|(_, component)| component / 3).collect::<Vec<_>>();
        if ends.is_empty() || kinds.iter().any(|kind| *kind != kinds[0]) {
            let reason = match ends.is_empty() {
                true => "connects no grid point",
                false => "connects a translation with a rotation, which is not supported",
            };
            return Err(
                card.problem(format!("element {} {reason}", card.subject()), "correct its grid points")
            );
        }
        let labels: Vec<u64> = ends.iter().map(|(label, _)| *label).collect();
        let components = [ends[0].1, ends[ends.len() - 1].1];
        let kind = ElementKind::Spring { components, stiffness };
        Ok(Element { label: card.id(1, "EID")?, kind, nodes: self.nodes(card, &labels)?, material: None })
    }

    fn mass(&mut self, card: &Card) -> Result<Element> {
        let nodes = self.nodes(card, &[card.id(2, "G")?])?;
        let position = self.node(nodes[0]).position;
        let stated = card.vector(5, "X1, X2, X3")?;
        let absolute = card.optional_integer(3, "CID")? == Some(-1);
        let system = if absolute { 0 } else { card.system(3, "CID")? };
        let owner = format!("element {}", card.subject());
        let system = self.geometry.system(system, &owner, card.place)?;
        let offset = if absolute { sub(stated, position) } else { system.vector(stated, position) };
        let entry = |i: usize, what: &str| card.real_or(9 + i, 0.0, what);
        let diagonal =
            [card.not_negative(9, "I11")?, card.not_negative(11, "I22")?, card.not_negative(14, "I33")?];
        // The card states products of inertia; the tensor has their negatives.
        let [i21, i31, i32] = [-entry(1, "I21")?, -entry(3, "I31")?, -entry(4, "I32")?];
        let local = [[diagonal[0], i21, i31], [i21, diagonal[1], i32], [i31, i32, diagonal[2]]];
        let axes = system.axes_at(position);
        let mut inertia = [[0.0; 3]; 3];
        for (i, row) in inertia.iter_mut().enumerate() {
            for (j, value) in row.iter_mut().enumerate() {
                for k in 0..3 {
                    for l in 0..3 {
                        *value += axes[k][i] * local[k][l] * axes[l][j];
                    }
                }
            }
        }
        let kind = ElementKind::Mass { mass: card.not_negative(4, "M")?, offset, inertia };
        Ok(Element { label: card.id(1, "EID")?, kind, nodes, material: None })
    }
}
