//! Content of the files of meshes, and the values of a position at their nodes.
//!
//! A mesh is written once. Positions refer to it by its name, which is a hash of the shape of its
//! part and of its connectivity. Both are exactly the same at all positions, unlike the points,
//! which are known in ground coordinates: so a run that is resumed finds the meshes of the earlier
//! one, and meshes of runs with other shapes have other names. All teeth of a gear share a mesh.

use crate::array_file::{Arrays, VERSION};
use calyx_runtime::contact::solid::Pose;
use calyx_runtime::observables::{DisplacedSector, ElasticBodyField, Fields, Part, PartOf, SectorField};
use calyx_runtime::stress::rotated;
use calyx_runtime::structure::outer_surface::{Cell, CellKind, OuterSurface, Skin};
use calyx_runtime::vec3::{Vector, dot, minus};
use serde_json::{Value, json};
use std::borrow::Cow;
use std::collections::hash_map::DefaultHasher;
use std::collections::{BTreeMap, HashMap};
use std::f64::consts::TAU;
use std::hash::{Hash, Hasher};

/// Bytes that a position stores for each point of a mesh: three displacements, six stresses, and
/// the estimated error of the stresses.
pub const BYTES_PER_POINT: usize = (3 + 6 + 1) * size_of::<f32>();
/// Bytes that a position stores for each point of a plane model, whose mesh is extruded: two
/// displacements, four stresses, and their error.
pub const BYTES_PER_PLANE_POINT: usize = (2 + 4 + 1) * size_of::<f32>();

/// Coordinates below this fraction of the size of a mesh are zero but for rounding.
const ROUNDING: f64 = 1e-12;

/// Points that differ by this fraction of the size of a mesh are the same.
const SAME_POINT: f64 = 1e-6;

/// Beginning and end of the names of meshes.
const NAME: [&str; 2] = ["mesh-", ".bin"];

/// Returns true if a mesh may have this file name.
pub fn is_name(name: &str) -> bool {
    let hash = name.strip_prefix(NAME[0]).and_then(|rest| rest.strip_suffix(NAME[1]));
    let is_digit = |byte: u8| byte.is_ascii_digit() || (b'a'..=b'f').contains(&byte);
    hash.is_some_and(|hash| hash.len() == 16 && hash.bytes().all(is_digit))
}

/// Returns the names of the meshes that a position refers to, in order, with repetitions.
pub fn names(fields: &Fields) -> Vec<String> {
    deformed(fields).iter().map(Deformed::name).collect()
}

/// Meshes of a run.
#[derive(Debug, Default)]
pub struct Meshes {
    /// Points of each mesh, as nodes of its cells, by file name.
    nodes: BTreeMap<String, Vec<usize>>,
    /// Files of meshes that have been added and not been taken.
    new: Vec<(String, Vec<u8>)>,
}

impl Meshes {
    /// Returns the names and contents of the meshes that were added since the last call.
    pub fn take_new(&mut self) -> Vec<(String, Vec<u8>)> {
        std::mem::take(&mut self.new)
    }

    /// Adds the values of a position at the points of its meshes to `arrays`, and returns the
    /// references to them.
    pub(crate) fn values(&mut self, arrays: &mut Arrays, fields: &Fields) -> Vec<Value> {
        let of_mesh = |mesh: &Deformed<'_>| {
            let name = mesh.name();
            let nodes = self.nodes.entry(name.clone()).or_insert_with(|| {
                let (nodes, file) = mesh.file();
                self.new.push((name.clone(), file));
                nodes
            });
            mesh.values(&name, nodes, arrays)
        };
        deformed(fields).iter().map(of_mesh).collect()
    }
}

/// Mesh of a part at a position, in ground coordinates.
struct Deformed<'a> {
    part: usize,
    shape: &'a OuterSurface,
    /// Copy of the shape of the part that this mesh replaces.
    copy: u32,
    /// Angle of the points of `field` about the z axis of the part from those of copy 0, rad.
    angle: f64,
    /// Displacements of a copy without stresses, in place of those of `field`.
    displaced: Option<&'a DisplacedSector>,
    /// True for a plane mesh extruded over the face width. Positions have the values of its first
    /// end, because plane strain is the same in all sections.
    extruded: bool,
    pose: &'a Pose,
    field: Field<'a>,
}

enum Field<'a> {
    Sector(Cow<'a, SectorField>),
    Body(&'a ElasticBodyField),
}

/// Returns the meshes of a position.
fn deformed(fields: &Fields) -> Vec<Deformed<'_>> {
    let placed = |is_own: &dyn Fn(&Part) -> bool| {
        let part = fields.parts.iter().position(is_own)?;
        Some((part, fields.poses.get(part)?.as_ref()?))
    };
    let mut all = Vec::new();
    for body in &fields.bodies {
        let Some((part, pose)) = placed(&|part| part.of == PartOf::Body(body.number)) else { continue };
        let shape = &fields.parts[part];
        let pitch = TAU / f64::from(shape.surface.copies.max(1));
        all.extend(body.sectors.iter().map(|sector| {
            let is_plane = sector.cells.iter().any(|cell| cell.len() == 4);
            let shown =
                if is_plane { Cow::Owned(extruded(sector, ends(shape))) } else { Cow::Borrowed(sector) };
            let angle = f64::from(sector.tooth) * pitch;
            Deformed {
                part,
                shape: &shape.surface,
                copy: sector.tooth,
                angle,
                displaced: None,
                extruded: is_plane,
                pose,
                field: Field::Sector(shown),
            }
        }));
        // Sectors without stresses have the mesh of the others.
        let Some(first) = body.sectors.first() else { continue };
        all.extend(body.displaced.iter().map(|sector| Deformed {
            part,
            shape: &shape.surface,
            copy: sector.tooth,
            angle: f64::from(first.tooth) * pitch,
            displaced: Some(sector),
            extruded: false,
            pose,
            field: Field::Sector(Cow::Borrowed(first)),
        }));
    }
    for body in &fields.elastic_bodies {
        let is_own = |part: &Part| matches!(part.of, PartOf::Connection(_)) && part.name == body.body;
        let Some((part, pose)) = placed(&is_own) else { continue };
        let shape = &fields.parts[part].surface;
        let field = Field::Body(body);
        all.push(Deformed {
            part,
            shape,
            copy: 0,
            angle: 0.0,
            displaced: None,
            extruded: false,
            pose,
            field,
        });
    }
    all
}

impl Deformed<'_> {
    fn cells(&self) -> Vec<Cell<'_>> {
        match &self.field {
            Field::Sector(sector) => {
                let all = sector.cells.iter().zip(&sector.elements);
                let kind = CellKind::Hexahedron;
                all.map(|(corners, &element)| Cell { kind, corners, element }).collect()
            }
            Field::Body(body) => {
                let all = body.cells.iter().enumerate();
                all.map(|(index, (shape, nodes))| shape.cell(nodes, index)).collect()
            }
        }
    }

    fn points(&self) -> &[[f64; 3]] {
        match &self.field {
            Field::Sector(sector) => &sector.points,
            Field::Body(body) => &body.points,
        }
    }

    fn name(&self) -> String {
        let mut hasher = DefaultHasher::new();
        (VERSION, self.part, self.shape.copies, self.extruded).hash(&mut hasher);
        self.shape.points.as_flattened().iter().for_each(|part| part.to_bits().hash(&mut hasher));
        for cell in self.cells() {
            (cell.kind as u8, cell.corners, cell.element).hash(&mut hasher);
        }
        format!("{}{:016x}{}", NAME[0], hasher.finish(), NAME[1])
    }

    /// Returns the matrix from ground coordinates to those of the part.
    fn to_part(&self) -> [Vector; 3] {
        [0, 1, 2].map(|axis: usize| self.pose.rotation.map(|row| row[axis]))
    }

    /// Returns the nodes of the points of the mesh, and its file.
    fn file(&self) -> (Vec<usize>, Vec<u8>) {
        let cells = self.cells();
        let mut nodes: Vec<usize> = cells.iter().flat_map(|cell| cell.corners).copied().collect();
        nodes.sort_unstable();
        nodes.dedup();
        let place = |node: usize| nodes.partition_point(|&other| other < node) as u32;
        let (sine, cosine) = self.angle.sin_cos();
        let to_part = self.to_part();
        let in_copy = |node: usize| {
            let [x, y, z] = product(&to_part, minus(self.points()[node], self.pose.origin));
            [cosine * x + sine * y, cosine * y - sine * x, z]
        };
        let mut points: Vec<Vector> = nodes.iter().map(|&node| in_copy(node)).collect();
        let size = points.as_flattened().iter().fold(0.0_f64, |size, part| size.max(part.abs()));
        for part in points.as_flattened_mut() {
            if part.abs() < ROUNDING * size {
                *part = 0.0;
            }
        }
        // Faces between neighbouring copies are inside the body.
        let cuts = match self.shape.copies {
            0 | 1 => Vec::new(),
            copies => cuts(&points, TAU / f64::from(copies), SAME_POINT * size).to_vec(),
        };
        let on_cut = |corners: &[usize]| {
            cuts.iter().any(|on_cut| corners.iter().all(|&node| on_cut[place(node) as usize]))
        };
        let skin = Skin::new(cells.iter().copied(), on_cut);
        let of_skin = |point: u32| place(skin.nodes[point as usize]);
        let mut arrays = Arrays::default();
        let header = json!({
            "open": skin.open,
            "extruded": self.extruded,
            "points": arrays.single(points),
            "triangles": arrays.indices(skin.triangles.iter().map(|row| row.map(of_skin))),
            "edges": arrays.indices(skin.edges.iter().map(|row| row.map(of_skin))),
            "tetrahedra": arrays.indices(corners::<4>(&cells, CellKind::Tetrahedron, place)),
            "wedges": arrays.indices(corners::<6>(&cells, CellKind::Wedge, place)),
            "hexahedra": arrays.indices(corners::<8>(&cells, CellKind::Hexahedron, place)),
        });
        (nodes, arrays.file(&header))
    }

    /// Adds the values at nodes to `arrays`, and returns the references to them.
    fn values(&self, name: &str, nodes: &[usize], arrays: &mut Arrays) -> Value {
        let (displacements, stresses, errors) = match &self.field {
            Field::Sector(sector) => (&sector.displacements, &sector.stresses, &sector.stress_errors),
            Field::Body(body) => (&body.displacements, &body.stresses, &body.stress_errors),
        };
        let displacements = self.displaced.map_or(displacements, |sector| &sector.displacements);
        // The points of the second end of an extruded mesh follow those of the first end.
        let nodes = if self.extruded { &nodes[..nodes.len() / 2] } else { nodes };
        let (to_part, nodes) = (self.to_part(), || nodes.iter());
        let displacements = nodes().map(|&node| product(&to_part, displacements[node]));
        let displacements = match self.extruded {
            true => arrays.single(displacements.map(|[x, y, _]| [x, y])),
            false => arrays.single(displacements),
        };
        let mut header = json!({
            "mesh": name,
            "part": self.part,
            "copy": self.copy,
            "displacements": displacements,
        });
        if self.displaced.is_none() {
            let stresses = nodes().map(|&node| rotated(&to_part, stresses[node]));
            header["stresses"] = match self.extruded {
                true => arrays.single(stresses.map(|[xx, yy, zz, _, _, xy]| [xx, yy, zz, xy])),
                false => arrays.single(stresses),
            };
            header["stress_errors"] = arrays.single(nodes().map(|&node| [errors[node]]));
        }
        header
    }
}

/// Returns for each point whether it is on the cut between a sector and the previous one, and on
/// the cut between the sector and the next one: the rotation by the pitch (rad) takes one cut to
/// the other.
fn cuts(points: &[Vector], pitch: f64, tolerance: f64) -> [Vec<bool>; 2] {
    let (sine, cosine) = pitch.sin_cos();
    // Cells are four times as wide as the tolerance: points that are the same are in the cells of
    // their coordinates more or less a quarter of a cell.
    let cell = |at: Vector, shift: Vector| -> [i64; 3] {
        std::array::from_fn(|axis| (0.25 * at[axis] / tolerance + shift[axis]).round() as i64)
    };
    let shifts: [Vector; 8] =
        std::array::from_fn(|bits| [0, 1, 2].map(|axis| if bits & (1 << axis) == 0 { 0.25 } else { -0.25 }));
    let mut grid: HashMap<[i64; 3], Vec<usize>> = HashMap::new();
    for (index, &point) in points.iter().enumerate() {
        grid.entry(cell(point, [0.0; 3])).or_default().push(index);
    }
    let mut on = [vec![false; points.len()], vec![false; points.len()]];
    for (index, &[x, y, z]) in points.iter().enumerate() {
        let at = [cosine * x - sine * y, sine * x + cosine * y, z];
        let mut near = shifts.iter().filter_map(|&shift| grid.get(&cell(at, shift))).flatten();
        let same = |&&other: &&usize| {
            let [x, y, z] = minus(points[other], at);
            x.abs().max(y.abs()).max(z.abs()) <= tolerance
        };
        // A point on the axis is its own image.
        if let Some(&other) = near.find(same).filter(|other| **other != index) {
            on[0][index] = true;
            on[1][other] = true;
        }
    }
    on
}

/// Returns the corners of all cells of a kind, as indices of points.
fn corners<const N: usize>(
    cells: &[Cell<'_>],
    kind: CellKind,
    place: impl Fn(usize) -> u32,
) -> impl Iterator<Item = [u32; N]> {
    let of_kind = cells.iter().filter(move |cell| cell.kind == kind && cell.corners.len() == N);
    of_kind.map(move |cell| std::array::from_fn(|k| place(cell.corners[k])))
}

fn product(rows: &[Vector; 3], v: Vector) -> Vector {
    rows.map(|row| dot(row, v))
}

/// Returns the axial ends of a part in its coordinates, m.
fn ends(part: &Part) -> [f64; 2] {
    let z = part.surface.points.iter().map(|point| point[2]);
    z.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], z| [low.min(z), high.max(z)])
}

/// Extrudes the points and cells of a plane sector between two axial positions. The values remain
/// those of one section.
fn extruded(sector: &SectorField, ends: [f64; 2]) -> SectorField {
    let count = sector.points.len();
    let points = ends.iter().flat_map(|&z| sector.points.iter().map(move |&[x, y, _]| [x, y, z])).collect();
    let cell =
        |cell: &Vec<usize>| cell.iter().copied().chain(cell.iter().map(|corner| corner + count)).collect();
    SectorField {
        tooth: sector.tooth,
        points,
        cells: sector.cells.iter().map(cell).collect(),
        elements: sector.elements.clone(),
        displacements: sector.displacements.clone(),
        stresses: sector.stresses.clone(),
        stress_errors: sector.stress_errors.clone(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Points on both cuts of a sector of a twisted ring, of which neither is at a fixed angle.
    #[test]
    fn points_on_cuts_are_those_that_a_rotation_by_the_pitch_takes_to_each_other() {
        let pitch = TAU / 7.0;
        let mut points = Vec::new();
        for step in 0..=4 {
            for (radius, z) in [(1.0, 0.0), (2.0, 0.0), (1.0, 0.5), (2.0, 0.5)] {
                let (sine, cosine) = (pitch * f64::from(step) / 4.0 + 0.3 * z + 0.1 * radius).sin_cos();
                points.push([radius * cosine, radius * sine, z]);
            }
        }
        // A point on the axis is on no cut.
        points.push([0.0, 0.0, 0.5]);
        let found = cuts(&points, pitch, SAME_POINT);
        for (side, own) in found.iter().zip([0..4, 16..20]) {
            let marked: Vec<usize> = (0..points.len()).filter(|&index| side[index]).collect();
            assert_eq!(marked, own.collect::<Vec<_>>());
        }
    }
}
