//! Nodes, elements and sets: *NODE, *ELEMENT, *NSET, *ELSET, *SURFACE.
//!
//! Source: Abaqus Keywords Reference Guide, entries of these names; Abaqus Analysis User's Guide,
//! element library (node ordering and face numbering).

use super::super::geometry::{Vector, cross, norm, sub};
use super::super::origin::Problem;
use super::super::source::{Place, most_references};
use super::keyword::{Block, DataLine, Result, integer_at, normalized, real_at};
use crate::model::{ShellShape, SolidShape};
use std::cell::Cell;
use std::collections::{BTreeMap, HashMap};

/// Kind of an element type.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Kind {
    Solid(SolidShape),
    Shell(ShellShape),
    Beam,
    Truss,
    Mass,
    /// Spring with this number of nodes.
    Spring,
}

/// Element type: name, kind and number of nodes.
#[derive(Clone, Copy, Debug)]
pub(super) struct ElementType {
    pub name: &'static str,
    pub kind: Kind,
    pub count: usize,
}

const fn element_type(name: &'static str, kind: Kind, count: usize) -> ElementType {
    ElementType { name, kind, count }
}

const TYPES: &[ElementType] = &[
    element_type("C3D4", Kind::Solid(SolidShape::Tetrahedron4), 4),
    element_type("C3D6", Kind::Solid(SolidShape::Wedge6), 6),
    element_type("C3D8", Kind::Solid(SolidShape::Hexahedron8), 8),
    element_type("C3D8R", Kind::Solid(SolidShape::Hexahedron8), 8),
    element_type("C3D8I", Kind::Solid(SolidShape::IncompatibleHexahedron8), 8),
    element_type("C3D10", Kind::Solid(SolidShape::Tetrahedron10), 10),
    element_type("C3D10M", Kind::Solid(SolidShape::Tetrahedron10), 10),
    element_type("C3D15", Kind::Solid(SolidShape::Wedge15), 15),
    element_type("C3D20", Kind::Solid(SolidShape::Hexahedron20), 20),
    element_type("C3D20R", Kind::Solid(SolidShape::Hexahedron20), 20),
    element_type("S3", Kind::Shell(ShellShape::Triangle3), 3),
    element_type("S3R", Kind::Shell(ShellShape::Triangle3), 3),
    element_type("S4", Kind::Shell(ShellShape::Quadrilateral4), 4),
    element_type("S4R", Kind::Shell(ShellShape::Quadrilateral4), 4),
    element_type("S6", Kind::Shell(ShellShape::Triangle6), 6),
    element_type("STRI65", Kind::Shell(ShellShape::Triangle6), 6),
    element_type("S8", Kind::Shell(ShellShape::Quadrilateral8), 8),
    element_type("S8R", Kind::Shell(ShellShape::Quadrilateral8), 8),
    element_type("B31", Kind::Beam, 2),
    element_type("T3D2", Kind::Truss, 2),
    element_type("MASS", Kind::Mass, 1),
    element_type("SPRING1", Kind::Spring, 1),
    element_type("SPRING2", Kind::Spring, 2),
];

/// Element of the input file, with its nodes in the order of [`SolidShape`] and [`ShellShape`].
pub(super) struct MeshElement {
    pub kind: ElementType,
    pub nodes: Vec<u64>,
    pub place: Place,
}

/// Set of labels with its name as written.
#[derive(Default)]
pub(super) struct Set {
    pub name: String,
    pub labels: Vec<u64>,
}

/// Surface: nodes with weights.
pub(super) struct Surface {
    pub name: String,
    pub nodes: Vec<(u64, f64)>,
}

/// Nodes, elements and sets of an input file.
#[derive(Default)]
pub(super) struct Mesh {
    pub nodes: BTreeMap<u64, Vector>,
    pub elements: BTreeMap<u64, MeshElement>,
    pub node_sets: HashMap<String, Set>,
    pub element_sets: HashMap<String, Set>,
    pub surfaces: HashMap<String, Surface>,
    /// Number of labels that references to sets have given so far.
    expanded: Cell<usize>,
}

impl Mesh {
    pub fn read(blocks: &[Block]) -> Result<Self> {
        let mut mesh = Self::default();
        for block in blocks {
            match block.keyword.as_str() {
                "NODE" => mesh.read_nodes(block)?,
                "ELEMENT" => mesh.read_elements(block)?,
                _ => {}
            }
        }
        for block in blocks {
            match block.keyword.as_str() {
                "NSET" | "ELSET" => mesh.read_set(block)?,
                _ => {}
            }
        }
        for block in blocks.iter().filter(|block| block.keyword == "SURFACE") {
            mesh.read_surface(block)?;
        }
        for (label, element) in &mesh.elements {
            if let Some(missing) = element.nodes.iter().find(|node| !mesh.nodes.contains_key(node)) {
                return Err(Problem::new(
                    element.place,
                    format!(
                        "element {} {label} refers to node {missing}, which is not defined",
                        element.kind.name
                    ),
                    format!("define node {missing}, or correct the reference"),
                ));
            }
        }
        Ok(mesh)
    }

    fn read_nodes(&mut self, block: &Block) -> Result<()> {
        block.without(&["SYSTEM", "INPUT"])?;
        let mut labels = Vec::with_capacity(block.data.len());
        for line in &block.data {
            let values = line.values();
            let label = integer_at(line, &values, 0, "the label of the node")?;
            let mut position = [0.0; 3];
            for (i, x) in position.iter_mut().enumerate() {
                *x = real_at(line, &values, i + 1, &format!("coordinate {} of node {label}", i + 1))?;
            }
            if let Some(known) = self.nodes.insert(label, position)
                && known != position
            {
                return Err(line.problem(
                    format!("node {label} is defined again at another position"),
                    "renumber one of the nodes; export the model without parts and assemblies",
                ));
            }
            labels.push(label);
        }
        if let Some(name) = block.parameter("NSET") {
            extend(&mut self.node_sets, name, labels);
        }
        Ok(())
    }

    fn read_elements(&mut self, block: &Block) -> Result<()> {
        block.without(&["INPUT"])?;
        let name = normalized(block.required("TYPE")?);
        let Some(kind) = TYPES.iter().find(|kind| kind.name == name) else {
            return Err(block.problem(
                format!("the element type {name} is not supported"),
                format!("use one of {}", TYPES.iter().map(|kind| kind.name).collect::<Vec<_>>().join(", ")),
            ));
        };
        let mut labels = Vec::new();
        let mut numbers: Vec<u64> = Vec::new();
        let mut start = block.place;
        for line in &block.data {
            if numbers.is_empty() {
                start = line.place;
            }
            let values = line.values();
            for index in 0..values.len() {
                numbers.push(integer_at(line, &values, index, "a label of the element or its nodes")?);
            }
            if numbers.len() > kind.count {
                let label = numbers[0];
                self.add_element(label, *kind, &numbers[1..], start)?;
                labels.push(label);
                numbers.clear();
            }
        }
        if let Some(label) = numbers.first() {
            return Err(wrong_count(start, kind, *label, numbers.len() - 1));
        }
        if let Some(name) = block.parameter("ELSET") {
            extend(&mut self.element_sets, name, labels);
        }
        Ok(())
    }

    fn add_element(&mut self, label: u64, kind: ElementType, nodes: &[u64], place: Place) -> Result<()> {
        if nodes.len() != kind.count {
            return Err(wrong_count(place, &kind, label, nodes.len()));
        }
        // Abaqus lists the midside nodes of the second face before those between the faces.
        let mut nodes = nodes.to_vec();
        match kind.kind {
            Kind::Solid(SolidShape::Hexahedron20) => nodes[12..20].rotate_left(4),
            Kind::Solid(SolidShape::Wedge15) => nodes[9..15].rotate_left(3),
            _ => {}
        }
        let known = self.elements.get(&label);
        if let Some(known) = known.filter(|known| known.kind.name != kind.name || known.nodes != nodes) {
            return Err(Problem::new(
                place,
                format!(
                    "element {} {label} is defined again with different content; the first is in line {}",
                    kind.name, known.place.line
                ),
                "renumber one of the elements; export the model without parts and assemblies",
            ));
        }
        self.elements.insert(label, MeshElement { kind, nodes, place });
        Ok(())
    }

    fn read_set(&mut self, block: &Block) -> Result<()> {
        let is_nodes = block.keyword == "NSET";
        let name = block.required(&block.keyword)?;
        let mut labels = Vec::new();
        for line in &block.data {
            let values = line.values();
            if block.parameter("GENERATE").is_some() {
                let from = integer_at(line, &values, 0, "the first label")?;
                let to = integer_at(line, &values, 1, "the last label")?;
                let step = if values.len() > 2 { integer_at(line, &values, 2, "the increment")? } else { 1 };
                if to < from {
                    return Err(
                        line.problem(format!("the range {from} to {to} is empty"), "exchange the labels")
                    );
                }
                let chosen = |label: &u64| (label - from).is_multiple_of(step);
                match is_nodes {
                    true => {
                        labels.extend(self.nodes.range(from..=to).map(|(label, _)| *label).filter(chosen))
                    }
                    false => {
                        labels.extend(self.elements.range(from..=to).map(|(label, _)| *label).filter(chosen))
                    }
                }
            } else {
                for value in values.into_iter().filter(|value| !value.is_empty()) {
                    match is_nodes {
                        true => labels.extend(self.nodes_of(value, line)?),
                        false => labels.extend(self.elements_of(value, line)?),
                    }
                }
            }
        }
        if is_nodes && let Some(elements) = block.parameter("ELSET") {
            let line = DataLine::new(elements, block.place);
            for element in self.elements_of(elements, &line)? {
                labels.extend(self.elements[&element].nodes.iter());
            }
        }
        let sets = if is_nodes { &mut self.node_sets } else { &mut self.element_sets };
        extend(sets, name, labels);
        Ok(())
    }

    /// Labels of nodes that a value states: a label or the name of a set.
    pub fn nodes_of(&self, value: &str, line: &DataLine) -> Result<Vec<u64>> {
        if let Some(label) = label_of(value) {
            return match self.nodes.contains_key(&label) {
                true => Ok(vec![label]),
                false => Err(line.problem(
                    format!("node {label} is not defined"),
                    format!("define node {label}, or correct the reference"),
                )),
            };
        }
        self.labels_of(&self.node_sets, "node set", value, line)
    }

    /// Labels of a set. Sets may be referred to often, so their total is limited.
    fn labels_of(
        &self,
        sets: &HashMap<String, Set>,
        what: &str,
        name: &str,
        line: &DataLine,
    ) -> Result<Vec<u64>> {
        let set = find(sets, name).ok_or_else(|| missing(line, what, name))?;
        let expanded = self.expanded.get().saturating_add(set.labels.len());
        self.expanded.set(expanded);
        if expanded > most_references(self.nodes.len() + self.elements.len()) {
            return Err(line.problem(
                format!("the {what} `{name}` and others are referred to too often"),
                "remove repeated references to large sets",
            ));
        }
        Ok(set.labels.clone())
    }

    /// Single node that a value states.
    pub fn node_of(&self, value: &str, line: &DataLine) -> Result<u64> {
        match self.nodes_of(value, line)?[..] {
            [node] => Ok(node),
            _ => Err(line.problem(
                format!("`{value}` must be one node, but is a set of several or none"),
                "state the label of the node",
            )),
        }
    }

    /// Labels of elements that a value states: a label or the name of a set.
    pub fn elements_of(&self, value: &str, line: &DataLine) -> Result<Vec<u64>> {
        if let Some(label) = label_of(value) {
            return match self.elements.contains_key(&label) {
                true => Ok(vec![label]),
                false => Err(line.problem(
                    format!("element {label} is not defined"),
                    format!("define element {label}, or correct the reference"),
                )),
            };
        }
        self.labels_of(&self.element_sets, "element set", value, line)
    }

    pub fn surface(&self, name: &str, block: &Block) -> Result<&Surface> {
        let line = DataLine::new(name, block.place);
        find(&self.surfaces, name).ok_or_else(|| missing(&line, "surface", name))
    }

    fn read_surface(&mut self, block: &Block) -> Result<()> {
        let name = block.required("NAME")?;
        block.without(&["COMBINE", "CROP", "REGIONTYPE"])?;
        let is_nodes = match block.parameter("TYPE").map(normalized).as_deref() {
            None | Some("ELEMENT") => false,
            Some("NODE") => true,
            Some(other) => {
                return Err(block.problem(
                    format!("*SURFACE: the type {other} is not supported"),
                    "use TYPE=ELEMENT or TYPE=NODE",
                ));
            }
        };
        let mut weights: BTreeMap<u64, f64> = BTreeMap::new();
        for line in &block.data {
            let values = line.values();
            let Some(first) = values.first() else { continue };
            if is_nodes {
                let weight = if values.len() > 1 { real_at(line, &values, 1, "the weight")? } else { 1.0 };
                if weight < 0.0 {
                    return Err(line.problem("the weight is negative", "use positive weights"));
                }
                for node in self.nodes_of(first, line)? {
                    weights.insert(node, weight);
                }
            } else {
                let face = values.get(1).copied().unwrap_or_default();
                for element in self.elements_of(first, line)? {
                    let nodes = self.face(element, face, line)?;
                    let share = self.area(&nodes) / nodes.len() as f64;
                    nodes.into_iter().for_each(|node| *weights.entry(node).or_default() += share);
                }
            }
        }
        let surface = Surface { name: name.to_owned(), nodes: weights.into_iter().collect() };
        self.surfaces.insert(normalized(name), surface);
        Ok(())
    }

    /// Nodes of a face of an element: corners, then midside nodes.
    fn face(&self, label: u64, face: &str, line: &DataLine) -> Result<Vec<u64>> {
        let element = &self.elements[&label];
        let face = face.to_ascii_uppercase();
        let unsupported = || {
            line.problem(
                format!("element {} {label} has no face `{face}` that is supported", element.kind.name),
                "state a face of the element, S1 to S6, or SPOS or SNEG for shells",
            )
        };
        let Kind::Solid(shape) = element.kind.kind else {
            let whole = matches!(face.as_str(), "" | "SPOS" | "SNEG" | "S1" | "S2" | "SP" | "SN");
            return match element.kind.kind {
                Kind::Shell(_) if whole => Ok(element.nodes.clone()),
                _ => Err(unsupported()),
            };
        };
        let (faces, edges) = topology(shape);
        let number = face.strip_prefix('S').and_then(|digits| digits.parse::<usize>().ok());
        let corners = number.and_then(|number| faces.get(number.wrapping_sub(1))).ok_or_else(unsupported)?;
        let mut nodes: Vec<u64> = corners.iter().map(|corner| element.nodes[*corner]).collect();
        let corner_count = edges.iter().flatten().max().map_or(0, |last| last + 1);
        for (at, edge) in edges.iter().enumerate() {
            if edge.iter().all(|end| corners.contains(end))
                && let Some(node) = element.nodes.get(corner_count + at)
            {
                nodes.push(*node);
            }
        }
        Ok(nodes)
    }

    /// Area of a face from its corners.
    fn area(&self, nodes: &[u64]) -> f64 {
        let corners = if matches!(nodes.len(), 3 | 6) { 3 } else { 4 };
        let at: Option<Vec<Vector>> =
            nodes[..corners].iter().map(|node| self.nodes.get(node).copied()).collect();
        let Some(at) = at else { return 0.0 };
        let last = at[corners - 1];
        match corners {
            3 => 0.5 * norm(cross(sub(at[1], at[0]), sub(last, at[0]))),
            _ => 0.5 * norm(cross(sub(at[2], at[0]), sub(last, at[1]))),
        }
    }
}

/// Corners of the faces, and ends of the edges in the order of the midside nodes.
fn topology(shape: SolidShape) -> (&'static [&'static [usize]], &'static [[usize; 2]]) {
    match shape {
        SolidShape::Hexahedron8 | SolidShape::IncompatibleHexahedron8 | SolidShape::Hexahedron20 => (
            &[&[0, 1, 2, 3], &[4, 7, 6, 5], &[0, 4, 5, 1], &[1, 5, 6, 2], &[2, 6, 7, 3], &[3, 7, 4, 0]],
            &[[0, 1], [1, 2], [2, 3], [3, 0], [0, 4], [1, 5], [2, 6], [3, 7], [4, 5], [5, 6], [6, 7], [7, 4]],
        ),
        SolidShape::Wedge6 | SolidShape::Wedge15 => (
            &[&[0, 1, 2], &[3, 5, 4], &[0, 3, 4, 1], &[1, 4, 5, 2], &[2, 5, 3, 0]],
            &[[0, 1], [1, 2], [2, 0], [0, 3], [1, 4], [2, 5], [3, 4], [4, 5], [5, 3]],
        ),
        SolidShape::Tetrahedron4 | SolidShape::Tetrahedron10 => (
            &[&[0, 1, 2], &[0, 3, 1], &[1, 3, 2], &[2, 3, 0]],
            &[[0, 1], [1, 2], [2, 0], [0, 3], [1, 3], [2, 3]],
        ),
    }
}

/// Label that a value states, possibly after the name of an instance.
fn label_of(value: &str) -> Option<u64> {
    value.rsplit('.').next()?.parse().ok()
}

/// Entry with a name, possibly after the name of an instance.
fn find<'m, T>(map: &'m HashMap<String, T>, name: &str) -> Option<&'m T> {
    let name = normalized(name);
    map.get(&name).or_else(|| map.get(name.rsplit('.').next()?))
}

fn missing(line: &DataLine, what: &str, name: &str) -> Problem {
    line.problem(
        format!("the {what} `{name}` is not defined"),
        format!("define the {what}, or correct its name"),
    )
}

fn extend(sets: &mut HashMap<String, Set>, name: &str, labels: Vec<u64>) {
    let set = sets.entry(normalized(name)).or_default();
    if set.name.is_empty() {
        name.clone_into(&mut set.name);
    }
    set.labels.extend(labels);
    set.labels.sort_unstable();
    set.labels.dedup();
}

fn wrong_count(place: Place, kind: &ElementType, label: u64, found: usize) -> Problem {
    Problem::new(
        place,
        format!("element {} {label} has {found} nodes, but needs {}", kind.name, kind.count),
        "check the data lines of the element",
    )
}
