//! Reader of Gmsh meshes in the MSH format, version 4.1, text and binary.
//!
//! Source: Gmsh Reference Manual, "MSH file format" (version 4.1) and "Node ordering".

mod reader;

use super::Import;
use super::Units;
use super::builder::Builder;
use super::error::ImportError;
use super::origin::{Origin, Problem};
use super::source::{OpenFile, Place, Sources};
use crate::model::{Element, ElementKind, Material, Node, ShellShape, SolidShape};
use reader::{Form, Reader, Result as ReadResult};
use std::collections::{BTreeMap, BTreeSet, HashMap};

/// Arguments of [`read_gmsh`]: a mesh has neither units nor materials.
#[derive(Clone, Debug, PartialEq)]
pub struct GmshOptions {
    /// Unit of length of the mesh, m.
    pub length: f64,
    /// Materials and thicknesses of physical groups.
    pub parts: Vec<GmshPart>,
}

/// Material of a physical group.
#[derive(Clone, Debug, PartialEq)]
pub struct GmshPart {
    /// Name of the physical group; `None` for all elements without another part.
    pub physical: Option<String>,
    /// Material.
    pub material: Material,
    /// Thickness of shells, m. Surface elements are shells if their part has a thickness and either
    /// names their group or the mesh has no solid elements. Other surface elements only define node
    /// sets.
    pub thickness: Option<f64>,
}

/// Kind of an element type.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    Solid(SolidShape),
    Shell(ShellShape),
    /// Points, lines, and types of more dimensions that are not supported.
    Other,
}

/// Element type: number, name, dimension, nodes, kind.
type ElementType = (i32, &'static str, i32, usize, Kind);

const TYPES: &[ElementType] = &[
    (1, "line", 1, 2, Kind::Other),
    (2, "triangle", 2, 3, Kind::Shell(ShellShape::Triangle3)),
    (3, "quadrangle", 2, 4, Kind::Shell(ShellShape::Quadrilateral4)),
    (4, "tetrahedron", 3, 4, Kind::Solid(SolidShape::Tetrahedron4)),
    (5, "hexahedron", 3, 8, Kind::Solid(SolidShape::Hexahedron8)),
    (6, "prism", 3, 6, Kind::Solid(SolidShape::Wedge6)),
    (7, "5-node pyramid", 3, 5, Kind::Other),
    (8, "3-node line", 1, 3, Kind::Other),
    (9, "6-node triangle", 2, 6, Kind::Shell(ShellShape::Triangle6)),
    (10, "9-node quadrangle", 2, 9, Kind::Shell(ShellShape::Quadrilateral9)),
    (11, "10-node tetrahedron", 3, 10, Kind::Solid(SolidShape::Tetrahedron10)),
    (12, "27-node hexahedron", 3, 27, Kind::Other),
    (13, "18-node prism", 3, 18, Kind::Other),
    (14, "14-node pyramid", 3, 14, Kind::Other),
    (15, "point", 0, 1, Kind::Other),
    (16, "8-node quadrangle", 2, 8, Kind::Shell(ShellShape::Quadrilateral8)),
    (17, "20-node hexahedron", 3, 20, Kind::Solid(SolidShape::Hexahedron20)),
    (18, "15-node prism", 3, 15, Kind::Solid(SolidShape::Wedge15)),
    (19, "13-node pyramid", 3, 13, Kind::Other),
];

/// Indices of Gmsh's nodes in the order of [`SolidShape`].
fn order(kind: Kind) -> &'static [usize] {
    match kind {
        Kind::Solid(SolidShape::Hexahedron20) => {
            &[0, 1, 2, 3, 4, 5, 6, 7, 8, 11, 13, 9, 10, 12, 14, 15, 16, 18, 19, 17]
        }
        Kind::Solid(SolidShape::Wedge15) => &[0, 1, 2, 3, 4, 5, 6, 9, 7, 8, 10, 11, 12, 14, 13],
        Kind::Solid(SolidShape::Tetrahedron10) => &[0, 1, 2, 3, 4, 5, 6, 7, 9, 8],
        _ => &[],
    }
}

/// Largest number of physical groups of an entity.
const MOST_GROUPS: u64 = 100;

/// Dimension and tag of an entity.
type Entity = (i32, i32);

/// Element of a mesh.
struct MeshElement {
    label: u64,
    kind: ElementType,
    entity: Entity,
    nodes: Vec<u64>,
    place: Place,
}

#[derive(Default)]
struct Mesh {
    names: HashMap<Entity, String>,
    /// Physical tags of entities.
    physical: HashMap<Entity, Vec<i32>>,
    nodes: BTreeMap<u64, [f64; 3]>,
    elements: Vec<MeshElement>,
    skipped: Vec<(String, Place)>,
}

/// Reads a body from a Gmsh mesh.
///
/// # Errors
/// The file is not a valid mesh of version 4.1, or an element has no material.
pub fn read_gmsh(path: &str, options: &GmshOptions, open: &mut OpenFile) -> Result<Import, ImportError> {
    let mut sources = Sources::new(open);
    let (_, content) = sources.bytes(path, None)?;
    let files = sources.names;
    let builder = Mesh::read(&content)
        .and_then(|mesh| build(&mesh, options))
        .map_err(|problem| problem.located(&files))?;
    builder.finish(&files, &Units::N_M_S, 1.0)
}

impl Mesh {
    fn read(content: &[u8]) -> ReadResult<Self> {
        let mut mesh = Self::default();
        let mut reader = Reader::new(content);
        let mut form = None;
        while let Some(name) = reader.next_section()? {
            let place = reader.place();
            if name == "MeshFormat" {
                form = Some(format(&mut reader)?);
                reader.end_section()?;
                continue;
            }
            let Some(form) = form else {
                return Err(
                    reader.problem("the file does not begin with $MeshFormat", "export the mesh as MSH 4.1")
                );
            };
            if matches!(name.as_str(), "Entities" | "Nodes" | "Elements") {
                reader.form = form;
            }
            match name.as_str() {
                "PhysicalNames" => mesh.read_names(&mut reader)?,
                "Entities" => mesh.read_entities(&mut reader)?,
                "Nodes" => mesh.read_nodes(&mut reader)?,
                "Elements" => mesh.read_elements(&mut reader)?,
                "PartitionedEntities" | "GhostElements" => {
                    return Err(
                        reader.problem("a partitioned mesh is not supported", "export the whole mesh")
                    );
                }
                _ => {
                    mesh.skipped.push((format!("${name}"), place));
                    reader.skip_section()?;
                    continue;
                }
            }
            reader.end_section()?;
        }
        if form.is_none() {
            return Err(reader.problem("the file has no $MeshFormat", "export the mesh as MSH 4.1"));
        }
        Ok(mesh)
    }

    fn read_names(&mut self, reader: &mut Reader) -> ReadResult<()> {
        let count = reader.size("the number of physical names")?;
        reader.line();
        for _ in 0..count {
            let place = reader.counted_place();
            let line = reader.line().unwrap_or_default();
            let mut words = line.splitn(3, char::is_whitespace);
            let mut number = || words.next()?.parse::<i32>().ok();
            let entity = number().zip(number());
            let name = words.next().map(|name| name.trim().trim_matches('"').to_owned());
            let (Some(entity), Some(name)) = (entity, name) else {
                let message = "a physical name must have a dimension, a tag and a name in quotes";
                return Err(Problem::new(place, message, "export the mesh again"));
            };
            self.names.insert(entity, name);
        }
        Ok(())
    }

    fn read_entities(&mut self, reader: &mut Reader) -> ReadResult<()> {
        let mut counts = [0; 4];
        for count in &mut counts {
            *count = reader.size("the number of entities")?;
        }
        for (dimension, count) in counts.into_iter().enumerate() {
            for _ in 0..count {
                let tag = reader.int("the tag of an entity")?;
                for _ in 0..if dimension == 0 { 3 } else { 6 } {
                    reader.double("the bounding box of an entity")?;
                }
                let mut physical = Vec::new();
                let count = reader.size("the number of physical tags")?;
                if count > MOST_GROUPS {
                    let message = format!("an entity belongs to {count} physical groups");
                    return Err(
                        reader.problem(message, format!("use at most {MOST_GROUPS} groups for an entity"))
                    );
                }
                for _ in 0..count {
                    // The sign is the orientation.
                    physical.push(reader.int("a physical tag")?.saturating_abs());
                }
                if dimension > 0 {
                    for _ in 0..reader.size("the number of bounding entities")? {
                        reader.int("the tag of a bounding entity")?;
                    }
                }
                self.physical.insert((dimension as i32, tag), physical);
            }
        }
        Ok(())
    }

    fn read_nodes(&mut self, reader: &mut Reader) -> ReadResult<()> {
        let blocks = reader.size("the number of blocks")?;
        for what in ["the number of nodes", "the smallest tag", "the largest tag"] {
            reader.size(what)?;
        }
        for _ in 0..blocks {
            let dimension = reader.int("the dimension of an entity")?;
            reader.int("the tag of an entity")?;
            let parametric = reader.int("the flag of parametric coordinates")?;
            let count = reader.size("the number of nodes of a block")?;
            let mut tags = Vec::new();
            for _ in 0..count {
                tags.push(reader.size("the tag of a node")?);
            }
            for tag in tags {
                let mut position = [0.0; 3];
                for x in &mut position {
                    *x = reader.double(&format!("a coordinate of node {tag}"))?;
                }
                if parametric != 0 {
                    for _ in 0..dimension.clamp(0, 3) {
                        reader.double("a parametric coordinate")?;
                    }
                }
                if self.nodes.insert(tag, position).is_some_and(|known| known != position) {
                    let message = format!("node {tag} is defined again at another position");
                    return Err(reader.problem(message, "renumber the mesh"));
                }
            }
        }
        Ok(())
    }

    fn read_elements(&mut self, reader: &mut Reader) -> ReadResult<()> {
        let blocks = reader.size("the number of blocks")?;
        for what in ["the number of elements", "the smallest tag", "the largest tag"] {
            reader.size(what)?;
        }
        for _ in 0..blocks {
            let dimension = reader.int("the dimension of an entity")?;
            let entity = (dimension, reader.int("the tag of an entity")?);
            let number = reader.int("the element type")?;
            let Some(kind) = TYPES.iter().find(|kind| kind.0 == number) else {
                return Err(reader.problem(
                    format!("the element type {number} is not supported"),
                    "mesh with order 1, or with order 2 and `Mesh.SecondOrderIncomplete = 1`",
                ));
            };
            for _ in 0..reader.size("the number of elements of a block")? {
                let label = reader.size("the tag of an element")?;
                let place = reader.counted_place();
                let mut nodes = Vec::with_capacity(kind.3);
                for _ in 0..kind.3 {
                    nodes.push(reader.size(&format!("a node of {} {label}", kind.1))?);
                }
                if let Some(missing) = nodes.iter().find(|node| !self.nodes.contains_key(node)) {
                    return Err(reader.problem(
                        format!("{} {label} refers to node {missing}, which is not defined", kind.1),
                        "export the mesh with all of its nodes",
                    ));
                }
                self.elements.push(MeshElement { label, kind: *kind, entity, nodes, place });
            }
        }
        Ok(())
    }

    /// Names of the physical groups of an entity.
    fn groups(&self, entity: Entity) -> Vec<String> {
        let tags = self.physical.get(&entity).map_or(&[][..], Vec::as_slice);
        let name = |tag: &i32| {
            let unnamed = || format!("group {} {tag}", entity.0);
            self.names.get(&(entity.0, *tag)).cloned().unwrap_or_else(unnamed)
        };
        tags.iter().map(name).collect()
    }
}

/// Reads $MeshFormat.
fn format(reader: &mut Reader) -> ReadResult<Form> {
    let version = reader.double("the version")?;
    let kind = reader.int("the file type")?;
    let size = reader.size("the size of integers")?;
    if version != 4.1 {
        let message = format!("the version of the mesh is {version}, but only 4.1 is supported");
        return Err(reader.problem(message, "export the mesh with `Mesh.MshFileVersion = 4.1`"));
    }
    match (kind, size) {
        (0, _) => Ok(Form::Text),
        (1, 8) => {
            reader.line();
            reader.byte_order().map(Form::Binary)
        }
        (1, size) => Err(reader
            .problem(format!("integers of {size} bytes are not supported"), "export on a 64-bit system")),
        (kind, _) => {
            Err(reader
                .problem(format!("the file type is {kind}, but must be 0 or 1"), "export the mesh again"))
        }
    }
}

fn build(mesh: &Mesh, options: &GmshOptions) -> ReadResult<Builder> {
    let start = Place { file: 0, line: 1 };
    check_options(mesh, options).map_err(|(message, help)| Problem::new(start, message, help))?;
    let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let nodes = mesh.nodes.iter().map(|(label, position)| Node {
        label: *label,
        position: position.map(|x| x * options.length),
        axes,
    });
    let mut builder = Builder::new(nodes, "node");
    builder.model.materials = options.parts.iter().map(|part| part.material.clone()).collect();
    let has_solids = mesh.elements.iter().any(|element| element.kind.2 == 3);
    // Without any thickness, the mesh as a whole is at fault.
    let is_shell_mesh = has_solids || options.parts.iter().any(|part| part.thickness.is_some());
    let mut sets: BTreeMap<String, BTreeSet<usize>> = BTreeMap::new();
    for element in &mesh.elements {
        let (_, name, dimension, _, kind) = element.kind;
        let groups = mesh.groups(element.entity);
        let nodes = builder.nodes(&element.nodes, name, element.place)?;
        for group in &groups {
            sets.entry(group.clone()).or_default().extend(nodes.iter().copied());
        }
        let named =
            |part: &GmshPart| part.physical.as_ref().is_some_and(|physical| groups.contains(physical));
        let part = options.parts.iter().position(named);
        let part = part.or_else(|| options.parts.iter().position(|part| part.physical.is_none()));
        let problem = |message: String, help: &str| {
            Err(Problem::new(element.place, format!("{name} {} {message}", element.label), help))
        };
        let thickness = part.and_then(|part| {
            let part = &options.parts[part];
            part.thickness.filter(|_| named(part) || !has_solids)
        });
        // Surfaces of a mesh with solids are sets of nodes, unless their group is a part.
        let is_part = part.is_some_and(|part| named(&options.parts[part])) || !has_solids;
        if matches!(kind, Kind::Shell(_)) && thickness.is_none() && is_part && is_shell_mesh {
            return problem(
                "needs a thickness to be a shell".into(),
                "state the thickness of its part (`thickness`), or leave the part out",
            );
        }
        let kind = match (kind, thickness) {
            (Kind::Solid(shape), _) => ElementKind::Solid(shape),
            (Kind::Shell(shape), Some(thickness)) => ElementKind::Shell {
                shape,
                thickness: vec![thickness; super::geometry::shell_corners(shape)],
                offset: 0.0,
                added_mass: 0.0,
            },
            (Kind::Other, _) if dimension == 3 => {
                return problem(
                    "is of a type that is not supported".into(),
                    "mesh without pyramids, and with `Mesh.SecondOrderIncomplete = 1`",
                );
            }
            _ => continue,
        };
        let Some(material) = part else {
            let message = match groups.first() {
                Some(group) => format!("of the physical group `{group}` has no material"),
                None => "of no physical group has no material".into(),
            };
            return problem(message, "state the material of its physical group, or of all elements");
        };
        let nodes = match order(element.kind.4) {
            [] => nodes,
            order => order.iter().map(|at| nodes[*at]).collect(),
        };
        let element_of_model = Element { label: element.label, kind, nodes, material: Some(material) };
        builder.element(Origin { name, place: element.place }, element_of_model)?;
    }
    let surface = mesh.elements.iter().find(|element| element.kind.2 == 2);
    if let Some(first) = surface.filter(|_| builder.model.elements.is_empty()) {
        let count = mesh.elements.iter().filter(|element| element.kind.2 == 2).count();
        return Err(Problem::new(
            first.place,
            format!(
                "the mesh has {count} surface elements, which need a thickness to be shells, and no solids"
            ),
            "state the thickness of the shells (`thickness`), or mesh the volume",
        ));
    }
    builder.model.sets = sets.into_iter().map(|(name, nodes)| (name, nodes.into_iter().collect())).collect();
    mesh.skipped.iter().for_each(|(name, place)| builder.skipped.add(name, *place));
    Ok(builder)
}

/// Returns the defect of the arguments, with a remedy.
fn check_options(mesh: &Mesh, options: &GmshOptions) -> Result<(), (String, String)> {
    let positive = |value: f64| value > 0.0 && value.is_finite();
    if !positive(options.length) {
        return Err(("the unit of length is not positive".into(), "state a positive unit of length".into()));
    }
    let mut known: Vec<String> = mesh.physical.keys().flat_map(|entity| mesh.groups(*entity)).collect();
    known.sort();
    known.dedup();
    for part in &options.parts {
        let Material { youngs_modulus, poissons_ratio, shear_modulus, density, .. } = part.material;
        let valid = positive(youngs_modulus)
            && positive(shear_modulus)
            && poissons_ratio > -1.0
            && poissons_ratio < 0.5
            && density >= 0.0
            && density.is_finite();
        if !valid || part.thickness.is_some_and(|thickness| !positive(thickness)) {
            let name = part.physical.as_deref().unwrap_or("all elements");
            return Err((
                format!("the material or the thickness of `{name}` is not valid"),
                "correct it".into(),
            ));
        }
        if let Some(name) = part.physical.as_ref().filter(|name| !known.contains(name)) {
            let help = match known.is_empty() {
                true => "define physical groups in Gmsh, or state a material for all elements".into(),
                false => format!("use one of {}", known.join(", ")),
            };
            return Err((format!("the mesh has no physical group `{name}`"), help));
        }
    }
    Ok(())
}
