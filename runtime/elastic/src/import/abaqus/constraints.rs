//! Supports, loads and constraints: *TRANSFORM, *BOUNDARY, *CLOAD, *EQUATION, *RIGID BODY,
//! *COUPLING with *KINEMATIC or *DISTRIBUTING.
//!
//! Source: Abaqus Keywords Reference Guide, entries of these names. The weights of a distributing
//! coupling to faces are equal shares of the area of each face.

use super::super::builder::Builder;
use super::super::geometry::{Vector, cross, dot, scale, sub, unit};
use super::super::origin::Origin;
use super::keyword::{Block, DataLine, Result, integer_at, normalized, real_at};
use super::mesh::{Kind, Mesh};
use super::sections::rectangular_axes;
use crate::model::{Components, Constraint};
use std::collections::BTreeSet;

const BASIC: [Vector; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// Sets the displacement axes of nodes.
pub(super) fn transform(block: &Block, mesh: &Mesh, builder: &mut Builder) -> Result<()> {
    let name = block.required("NSET")?;
    let line = block.line(0, "six coordinates")?;
    let values = line.values();
    let mut points = [[0.0; 3]; 2];
    for (i, x) in points.iter_mut().flatten().enumerate() {
        *x = real_at(line, &values, i, "a coordinate of *TRANSFORM")?;
    }
    let [a, b] = points;
    let degenerate = || line.problem("*TRANSFORM: its points determine no axes", "correct the points");
    let kind = block.parameter("TYPE").map_or_else(|| "R".to_owned(), normalized);
    for label in mesh.nodes_of(name, &DataLine::new(name, block.place))? {
        let node = builder.node(label, "*TRANSFORM", block.place)?;
        let position = builder.model.nodes[node].position;
        builder.model.nodes[node].axes = match kind.as_str() {
            "R" => rectangular_axes(a, b).ok_or_else(degenerate)?,
            "C" => {
                let axis = unit(sub(b, a)).ok_or_else(degenerate)?;
                let offset = sub(position, a);
                let across = sub(offset, scale(axis, dot(offset, axis)));
                let radial = unit(across).ok_or_else(|| {
                    line.problem(
                        format!("node {label} is on the axis of its cylindrical *TRANSFORM"),
                        "leave the node out of the set",
                    )
                })?;
                [radial, cross(axis, radial), axis]
            }
            other => {
                let message = format!("*TRANSFORM: the type {other} is not supported");
                return Err(block.problem(message, "use TYPE=R or TYPE=C"));
            }
        };
    }
    Ok(())
}

/// Range of components from two values of a line; the second is the first by default.
fn components(line: &DataLine, values: &[&str], at: usize) -> Result<Components> {
    let first = integer_at(line, values, at, "the first component")?;
    let is_blank = values.get(at + 1).is_none_or(|value| value.is_empty());
    let last = if is_blank { first } else { integer_at(line, values, at + 1, "the last component")? };
    if first > last || last > 6 {
        let message = format!("the components {first} to {last} are not a range from 1 to 6");
        return Err(line.problem(message, "state components from 1 to 6"));
    }
    Ok(std::array::from_fn(|c| (first..=last).contains(&(c as u64 + 1))))
}

pub(super) fn boundary(block: &Block, mesh: &Mesh, builder: &mut Builder) -> Result<()> {
    block.without(&["USER", "SUBMODEL", "FIXED", "BASEMOTION"])?;
    if block.parameter("TYPE").is_some_and(|kind| normalized(kind) != "DISPLACEMENT") {
        return Err(block.problem("*BOUNDARY: only displacements are supported", "remove the parameter TYPE"));
    }
    let origin = Origin { name: "*BOUNDARY", place: block.place };
    for line in &block.data {
        let values = line.values();
        let origin = Origin { place: line.place, ..origin };
        let nodes = mesh.nodes_of(values.first().copied().unwrap_or_default(), line)?;
        let named = match normalized(values.get(1).copied().unwrap_or_default()).as_str() {
            "ENCASTRE" => Some("123456"),
            "PINNED" => Some("123"),
            "XSYMM" => Some("156"),
            "YSYMM" => Some("246"),
            "ZSYMM" => Some("345"),
            "XASYMM" => Some("234"),
            "YASYMM" => Some("135"),
            "ZASYMM" => Some("126"),
            _ => None,
        };
        let (components, value) = match named {
            Some(digits) => (std::array::from_fn(|c| digits.contains(char::from(b'1' + c as u8))), 0.0),
            None => (components(line, &values, 1)?, real_at(line, &values, 3, "the value")?),
        };
        for label in nodes {
            let node = builder.node(label, "*BOUNDARY", line.place)?;
            builder.fix(origin, node, &components, value)?;
        }
    }
    Ok(())
}

pub(super) fn load(block: &Block, mesh: &Mesh, builder: &mut Builder) -> Result<()> {
    block.without(&["USER", "FOLLOWER", "LOADCASE", "SECTOR"])?;
    for line in &block.data {
        let values = line.values();
        let nodes = mesh.nodes_of(values.first().copied().unwrap_or_default(), line)?;
        let component = integer_at(line, &values, 1, "the component")? as usize;
        if component > 6 {
            return Err(line.problem(format!("component {component} is not supported"), "use 1 to 6"));
        }
        let value = real_at(line, &values, 2, "the load")?;
        for label in nodes {
            let node = builder.node(label, "*CLOAD", line.place)?;
            let axis = builder.model.nodes[node].axes[(component - 1) % 3];
            let first = (component - 1) / 3 * 3;
            let mut load = [0.0; 6];
            (0..3).for_each(|i| load[first + i] = value * axis[i]);
            builder.load(node, load);
        }
    }
    Ok(())
}

pub(super) fn equation(block: &Block, mesh: &Mesh, builder: &mut Builder, count: &mut u64) -> Result<()> {
    let mut lines = block.data.iter();
    while let Some(first) = lines.next() {
        let terms = integer_at(first, &first.values(), 0, "the number of terms")?;
        let mut parsed: Vec<(Vec<u64>, usize, f64)> = Vec::new();
        while (parsed.len() as u64) < terms {
            let Some(line) = lines.next() else {
                let message = format!("*EQUATION has {} of {terms} terms", parsed.len());
                return Err(
                    first.problem(message, "state a node, a component and a coefficient for each term")
                );
            };
            let values = line.values();
            for term in values.chunks(3) {
                let nodes = mesh.nodes_of(term[0], line)?;
                let component = integer_at(line, term, 1, "the component")? as usize;
                if component > 6 || parsed.len() as u64 == terms {
                    return Err(line
                        .problem("*EQUATION: the terms are not valid", "check their number and components"));
                }
                parsed.push((nodes, component - 1, real_at(line, term, 2, "the coefficient")?));
            }
        }
        let size = parsed.iter().map(|(nodes, ..)| nodes.len()).max().unwrap_or(0);
        if parsed.iter().any(|(nodes, ..)| nodes.len() != 1 && nodes.len() != size) {
            return Err(first.problem("*EQUATION: the sets have different sizes", "use sets of one size"));
        }
        if parsed.first().is_none_or(|(_, _, factor)| *factor == 0.0) {
            let message = "*EQUATION: the coefficient of the first term is zero";
            return Err(first.problem(message, "begin with the dependent component"));
        }
        for at in 0..size {
            let mut terms = Vec::with_capacity(parsed.len());
            for (nodes, component, factor) in &parsed {
                let label = nodes[if nodes.len() == 1 { 0 } else { at }];
                terms.push((builder.node(label, "*EQUATION", first.place)?, *component, *factor));
            }
            *count += 1;
            let origin = Origin { name: "*EQUATION", place: first.place };
            builder.constraint(origin, Constraint::Equation { label: *count, terms });
        }
    }
    Ok(())
}

/// Reference node of a constraint.
fn reference(block: &Block, mesh: &Mesh, builder: &Builder) -> Result<(usize, u64)> {
    let name = block.required("REFNODE")?;
    let label = mesh.node_of(name, &DataLine::new(name, block.place))?;
    Ok((builder.node(label, &format!("*{}", block.keyword), block.place)?, label))
}

/// Nodes of elements that have rotations.
fn rotating(mesh: &Mesh) -> BTreeSet<u64> {
    let has_rotations = |kind: Kind| matches!(kind, Kind::Shell(_) | Kind::Beam);
    let elements = mesh.elements.values().filter(|element| has_rotations(element.kind.kind));
    elements.flat_map(|element| element.nodes.iter().copied()).collect()
}

pub(super) fn rigid_body(block: &Block, mesh: &Mesh, builder: &mut Builder, count: &mut u64) -> Result<()> {
    block.without(&["ROTNODE", "ANALYTICALSURFACE", "ISOTHERMAL", "DENSITY"])?;
    let (reference, own) = reference(block, mesh, builder)?;
    let mut pinned: BTreeSet<u64> = BTreeSet::new();
    let mut tied: BTreeSet<u64> = BTreeSet::new();
    let rotating = rotating(mesh);
    for name in ["NSET", "TIENSET", "PINNSET"] {
        if let Some(value) = block.parameter(name) {
            let nodes = mesh.nodes_of(value, &DataLine::new(value, block.place))?;
            if name == "PINNSET" { pinned.extend(nodes) } else { tied.extend(nodes) }
        }
    }
    if let Some(value) = block.parameter("ELSET") {
        for element in mesh.elements_of(value, &DataLine::new(value, block.place))? {
            tied.extend(mesh.elements[&element].nodes.iter());
        }
    }
    let mut dependents = Vec::new();
    for label in tied.union(&pinned).filter(|label| **label != own) {
        let node = builder.node(*label, "*RIGID BODY", block.place)?;
        // Nodes of solids have no rotations.
        let rotates = tied.contains(label) && rotating.contains(label);
        dependents.push((node, std::array::from_fn(|c| c < 3 || rotates)));
    }
    if dependents.is_empty() {
        return Err(block.problem("*RIGID BODY has no nodes", "state NSET or ELSET"));
    }
    *count += 1;
    let origin = Origin { name: "*RIGID BODY", place: block.place };
    builder.constraint(origin, Constraint::Rigid { label: *count, reference, dependents });
    Ok(())
}

/// Reads a coupling with the keyword that follows it.
pub(super) fn coupling(
    block: &Block,
    kind: Option<&Block>,
    mesh: &Mesh,
    builder: &mut Builder,
    count: &mut u64,
) -> Result<()> {
    block.without(&["ORIENTATION", "INFLUENCERADIUS", "ALPHA"])?;
    let kind = kind.filter(|kind| matches!(kind.keyword.as_str(), "KINEMATIC" | "DISTRIBUTING"));
    let Some(kind) = kind else {
        return Err(
            block.problem("*COUPLING is not followed by *KINEMATIC or *DISTRIBUTING", "add one of them")
        );
    };
    let structural = kind.parameter("COUPLING").is_some_and(|value| normalized(value) != "CONTINUUM");
    let weighted = kind.parameter("WEIGHTINGMETHOD").is_some_and(|value| normalized(value) != "UNIFORM");
    if structural || weighted {
        return Err(kind
            .problem("*DISTRIBUTING: only continuum coupling with uniform weights is supported", "use it"));
    }
    let (reference, own) = reference(block, mesh, builder)?;
    let surface = mesh.surface(block.required("SURFACE")?, block)?;
    let mut coupled = [false; 6];
    for line in &kind.data {
        let chosen = components(line, &line.values(), 0)?;
        (0..6).for_each(|c| coupled[c] |= chosen[c]);
    }
    if kind.data.is_empty() {
        coupled = [true; 6];
    }
    let mut nodes = Vec::new();
    for (label, weight) in surface.nodes.iter().filter(|(label, _)| *label != own) {
        let node = builder.node(*label, "*COUPLING", block.place)?;
        // Components of a coupling are global.
        if builder.model.nodes[node].axes != BASIC && coupled != [true; 6] {
            let message = format!("*COUPLING: node {label} has a *TRANSFORM, and the coupling is partial");
            return Err(block.problem(message, "couple all components, or remove the *TRANSFORM"));
        }
        nodes.push((*label, node, *weight));
    }
    if !nodes.iter().any(|(.., weight)| *weight > 0.0) {
        return Err(block.problem("*COUPLING has no nodes with a weight", "check its surface"));
    }
    *count += 1;
    let origin = Origin { name: "*COUPLING", place: block.place };
    let constraint = match kind.keyword.as_str() {
        "KINEMATIC" => {
            let rotating = rotating(mesh);
            let own =
                |label: &u64| std::array::from_fn(|c| coupled[c] && (c < 3 || rotating.contains(label)));
            let dependents = nodes.iter().map(|(label, node, _)| (*node, own(label))).collect();
            Constraint::Rigid { label: *count, reference, dependents }
        }
        _ => Constraint::WeightedAverage {
            label: *count,
            reference,
            components: coupled,
            terms: nodes
                .iter()
                .map(|(_, node, weight)| (*weight, *node, [true, true, true, false, false, false]))
                .collect(),
        },
    };
    builder.constraint(origin, constraint);
    Ok(())
}
