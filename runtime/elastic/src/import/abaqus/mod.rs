//! Reader of input files of Abaqus and CalculiX.
//!
//! Sources: Abaqus Keywords Reference Guide; CalculiX CrunchiX User's Manual, "Input deck format".
//! The modules name the entries.
//!
//! Deviations: one part and one instance at most, without translation; beams are Timoshenko beams
//! also if CalculiX would expand them to solids; the first step only.

mod constraints;
mod keyword;
mod mesh;
mod sections;

use super::builder::Builder;
use super::error::ImportError;
use super::origin::Problem;
use super::source::{OpenFile, Place, Sources};
use super::{Import, Units};
use crate::model::Node;
use keyword::{Block, Result as ReadResult};
use mesh::Mesh;

/// Arguments of [`read_abaqus`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AbaqusOptions {
    /// Units of the input file.
    pub units: Units,
}

/// Keywords that the reader converts.
const READ: &[&str] = &[
    "BEAMSECTION",
    "BOUNDARY",
    "CLOAD",
    "COUPLING",
    "DISTRIBUTING",
    "ELEMENT",
    "ELSET",
    "EQUATION",
    "HEADING",
    "KINEMATIC",
    "MASS",
    "MATERIAL",
    "NODE",
    "NSET",
    "RIGIDBODY",
    "SHELLSECTION",
    "SOLIDSECTION",
    "SPRING",
    "SURFACE",
    "TRANSFORM",
    "ASSEMBLY",
    "ENDASSEMBLY",
    "ENDINSTANCE",
    "ENDPART",
    "INSTANCE",
    "PART",
    "ENDSTEP",
];

/// Keywords of analyses and output: they do not change the body.
const HARMLESS: &[&str] = &[
    "AMPLITUDE",
    "BUCKLE",
    "CONTACTFILE",
    "CONTACTOUTPUT",
    "CONTACTPRINT",
    "CONTROLS",
    "DISTRIBUTION",
    "DISTRIBUTIONTABLE",
    "DYNAMIC",
    "ELEMENTOUTPUT",
    "ELFILE",
    "ELPRINT",
    "ENERGYFILE",
    "ENERGYOUTPUT",
    "ENERGYPRINT",
    "FIELDOUTPUT",
    "FILEFORMAT",
    "FREQUENCY",
    "HISTORYOUTPUT",
    "MODALDAMPING",
    "MODALDYNAMIC",
    "MODALOUTPUT",
    "MODALPRINT",
    "MONITOR",
    "NODEFILE",
    "NODEOUTPUT",
    "NODEPRINT",
    "ORIENTATION",
    "OUTPUT",
    "PHYSICALCONSTANTS",
    "PREPRINT",
    "RESTART",
    "SECTIONPRINT",
    "SOLVERCONTROLS",
    "STATIC",
    "STEADYSTATEDYNAMICS",
    "STEP",
    "TIMEPOINTS",
    "VISCO",
    "SURFACEINTERACTION",
    "HOURGLASSSTIFFNESS",
    "SECTIONCONTROLS",
];

/// Reads a body from an input file of Abaqus or CalculiX.
///
/// # Errors
/// The file is not valid, or has a keyword that changes the body and is not supported.
pub fn read_abaqus(path: &str, options: &AbaqusOptions, open: &mut OpenFile) -> Result<Import, ImportError> {
    let mut sources = Sources::new(open);
    let blocks = keyword::read(path, &mut sources)?;
    let files = sources.names;
    if !options.units.is_valid() {
        let place = Place { file: 0, line: 1 };
        return Err(Problem::new(place, "the units are not positive", "state positive units").located(&files));
    }
    let builder = build(&blocks).map_err(|problem| problem.located(&files))?;
    builder.finish(&files, &options.units, 1.0)
}

fn build(blocks: &[Block]) -> ReadResult<Builder> {
    check_keywords(blocks)?;
    // Steps after the first are not read.
    let second = blocks.iter().enumerate().filter(|(_, block)| block.keyword == "STEP").nth(1);
    let (blocks, later) = blocks.split_at(second.map_or(blocks.len(), |(at, _)| at));
    let mesh = Mesh::read(blocks)?;
    let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let nodes = mesh.nodes.iter().map(|(label, position)| Node { label: *label, position: *position, axes });
    let mut builder = Builder::new(nodes, "node");
    let materials = sections::materials(blocks, &mut builder)?;
    sections::elements(blocks, &mesh, &materials, &mut builder)?;
    for block in blocks.iter().filter(|block| block.keyword == "TRANSFORM") {
        constraints::transform(block, &mesh, &mut builder)?;
    }
    let mut count = 0;
    for (at, block) in blocks.iter().enumerate() {
        match block.keyword.as_str() {
            "HEADING" if builder.title.is_empty() => {
                builder.title = block.data.first().map_or_else(String::new, |line| line.values().join(", "));
            }
            "BOUNDARY" => constraints::boundary(block, &mesh, &mut builder)?,
            "CLOAD" => constraints::load(block, &mesh, &mut builder)?,
            "EQUATION" => constraints::equation(block, &mesh, &mut builder, &mut count)?,
            "RIGIDBODY" => constraints::rigid_body(block, &mesh, &mut builder, &mut count)?,
            "COUPLING" => constraints::coupling(block, blocks.get(at + 1), &mesh, &mut builder, &mut count)?,
            name if HARMLESS.contains(&name) => builder.skipped.add(&format!("*{name}"), block.place),
            _ => {}
        }
    }
    if let Some(block) = later.first() {
        let steps = later.iter().filter(|block| block.keyword == "STEP").count();
        (0..steps).for_each(|_| builder.skipped.add("*STEP after the first", block.place));
    }
    node_sets(&mesh, &mut builder);
    Ok(builder)
}

/// Adds the node sets and the nodes of surfaces to the model.
fn node_sets(mesh: &Mesh, builder: &mut Builder) {
    let surfaces = mesh.surfaces.values().map(|surface| {
        (surface.name.clone(), surface.nodes.iter().map(|(label, _)| *label).collect::<Vec<u64>>())
    });
    let sets = mesh.node_sets.values().map(|set| (set.name.clone(), set.labels.clone()));
    // A surface does not replace a node set of its name.
    for (name, labels) in surfaces.chain(sets) {
        let nodes = labels.iter().filter_map(|label| builder.find(*label)).collect();
        builder.model.sets.insert(name, nodes);
    }
}

/// Rejects keywords that change the body and are not supported.
fn check_keywords(blocks: &[Block]) -> ReadResult<()> {
    for (at, block) in blocks.iter().enumerate() {
        let name = block.keyword.as_str();
        if sections::PARTS.contains(&name) {
            let follows =
                blocks[..at].iter().rfind(|block| !sections::PARTS.contains(&block.keyword.as_str()));
            if follows.is_none_or(|block| block.keyword != "MATERIAL") {
                return Err(
                    block.problem(format!("*{name} does not follow *MATERIAL"), "move it to its material")
                );
            }
        } else if ![READ, HARMLESS].iter().any(|names| names.contains(&name)) {
            return Err(block.problem(
                format!("the keyword *{name} is not supported"),
                "remove it if the body does not need it, or export the model without it",
            ));
        }
    }
    for name in ["PART", "INSTANCE"] {
        if let Some(second) = blocks.iter().filter(|block| block.keyword == name).nth(1) {
            return Err(second.problem(format!("the file has a second *{name}"), "merge the parts into one"));
        }
    }
    match blocks.iter().find(|block| block.keyword == "INSTANCE" && !block.data.is_empty()) {
        Some(block) => Err(block.problem("*INSTANCE has a translation", "move the part itself")),
        None => check_ends(blocks),
    }
}

/// Checks that a part, an instance and an assembly end: what follows would belong to them.
fn check_ends(blocks: &[Block]) -> ReadResult<()> {
    for (name, end) in [("PART", "ENDPART"), ("INSTANCE", "ENDINSTANCE"), ("ASSEMBLY", "ENDASSEMBLY")] {
        let Some(at) = blocks.iter().position(|block| block.keyword == name) else { continue };
        let after = &blocks[at + 1..];
        let closed = after.iter().position(|block| block.keyword == end);
        // A part ends before the assembly.
        let next = after.iter().position(|block| block.keyword == "ASSEMBLY").filter(|_| name == "PART");
        if closed.is_none_or(|closed| next.is_some_and(|next| next < closed)) {
            let spelled = format!("*END {name}");
            return Err(blocks[at].problem(
                format!("*{name} has no {spelled}"),
                format!("write {spelled} after its last block, or export the whole file again"),
            ));
        }
    }
    Ok(())
}
