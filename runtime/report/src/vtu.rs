//! VTU files of positions for ParaView: contact pressure on the flanks, stresses in fillets and
//! meshes of elastic bodies, as unstructured grids of VTK's XML format, with a PVD collection that
//! assigns the times.

mod content;
mod grid;
mod sound;

pub use sound::{sound_files, write_sound};

use calyx_runtime::observables::Fields;
use grid::Grid;
use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// Folder of the files in a run directory.
pub const FOLDER: &str = "vtu";

/// Kind of VTU file.
struct Kind {
    name: &'static str,
    of: fn(&Fields) -> Grid,
    /// True if every position has a file of this kind. Other kinds omit files without points, which
    /// readers reject as broken.
    always: bool,
}

const KINDS: [Kind; 3] = [
    Kind { name: "contact", of: content::contact, always: true },
    Kind { name: "root_stress", of: content::root_stress, always: false },
    Kind { name: "bodies", of: content::bodies, always: false },
];

/// Writer of the VTU files of a run, in folder [`FOLDER`] of its directory.
pub struct VtuFiles {
    folder: PathBuf,
    times: Vec<f64>,
}

impl VtuFiles {
    /// Continues after the positions of an earlier run, at these times (s).
    pub fn begin(directory: &Path, times: Vec<f64>) -> io::Result<VtuFiles> {
        let folder = folder(directory);
        fs::create_dir_all(&folder)?;
        Ok(VtuFiles { folder, times })
    }

    /// Writes the files of a position at a time (s).
    pub fn write(&mut self, step: usize, time: f64, fields: &Fields) -> io::Result<()> {
        self.times.push(time);
        for kind in &KINDS {
            let grid = (kind.of)(fields);
            if kind.always || !grid.points.is_empty() {
                fs::write(self.folder.join(name(kind.name, step)), grid.text()?)?;
            }
            self.collect(kind.name)?;
        }
        Ok(())
    }

    /// Writes the PVD collection of a kind, if it has files.
    fn collect(&self, kind: &str) -> io::Result<()> {
        let files = self.times.iter().enumerate().map(|(step, &time)| (time, name(kind, step)));
        let files: Vec<(f64, String)> = files.filter(|(_, name)| self.folder.join(name).exists()).collect();
        if files.is_empty() {
            return Ok(());
        }
        write_collection(&self.folder.join(format!("{kind}.pvd")), &files)
    }
}

/// Writes a PVD collection of files with their times, or what takes the place of a time.
fn write_collection(path: &Path, files: &[(f64, String)]) -> io::Result<()> {
    let mut file = File::create(path)?;
    writeln!(
        file,
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n<Collection>"
    )?;
    for (time, name) in files {
        writeln!(file, "<DataSet timestep=\"{time}\" file=\"{name}\"/>")?;
    }
    writeln!(file, "</Collection>\n</VTKFile>")
}

fn folder(directory: &Path) -> PathBuf {
    directory.join(FOLDER)
}

fn name(kind: &str, step: usize) -> String {
    format!("{kind}-{step:04}.vtu")
}

/// Returns true if a run has written the files of its first positions into a directory.
pub fn are_in(directory: &Path, positions: usize) -> bool {
    positions == 0 || folder(directory).join(name(KINDS[0].name, positions - 1)).exists()
}

/// Returns the names of the files that may exist for a position, relative to the run directory.
pub fn files_of(step: usize) -> impl Iterator<Item = String> {
    KINDS.iter().flat_map(move |kind| {
        [format!("{FOLDER}/{}", name(kind.name, step)), format!("{FOLDER}/{}.pvd", kind.name)]
    })
}

/// Returns true if a run may write a file of this name into [`FOLDER`].
pub fn is_name_of_a_run(name: &str) -> bool {
    sound::is_name(name)
        || KINDS.iter().any(|kind| {
            name.strip_prefix(kind.name)
                .is_some_and(|rest| rest == ".pvd" || (rest.starts_with('-') && rest.ends_with(".vtu")))
        })
}

/// Returns the files in [`FOLDER`] that a run may have written, relative to the run directory.
pub fn files_in(directory: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder(directory)).into_iter().flatten().flatten();
    let names = entries.filter_map(|entry| entry.file_name().into_string().ok());
    names.filter(|name| is_name_of_a_run(name)).map(|name| format!("{FOLDER}/{name}")).collect()
}

#[cfg(test)]
mod tests {
    use super::content::{bodies, contact, root_stress};
    use super::grid::written::numbers;
    use super::grid::{HEXAHEDRON, LINE, QUADRILATERAL, Values};
    use super::*;
    use calyx_runtime::elastic::model::{ShellShape, SolidShape};
    use calyx_runtime::elastic_body::CellShape;
    use calyx_runtime::observables::{
        BodyField, ContactField, ElasticBodyField, FilletField, FilletStress, PressedCell, SectorField,
    };
    use calyx_runtime::results::Location;

    fn place() -> Location {
        Location { body: "pinion".into(), tooth: 2, roll_angle: None, radius: 0.02, axial: None }
    }

    fn fields(sections: usize) -> Fields {
        let cell = PressedCell {
            corners: [[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]],
            locations: [place(), place()],
            pressure: 0.1 + 0.2,
            edge: false,
            zone: None,
            flank_corners: None,
        };
        let stress = |s: usize, z: usize| FilletStress {
            point: [s as f64, 0.0, z as f64],
            location: place(),
            depth: s as f64,
            components: [1.0, 0.0, 0.0],
            principal: [1.0, 0.0],
        };
        let sections = (0..sections).map(|z| (0..3).map(|s| stress(s, z)).collect()).collect();
        Fields {
            contacts: vec![ContactField {
                bodies: ["pinion".into(), "gear".into()],
                teeth: [2, 5],
                surfaces: [0, 0],
                back: false,
                cells: vec![cell],
                slices: Vec::new(),
                states: Vec::new(),
            }],
            fillets: vec![FilletField { body: "pinion".into(), tooth: 2, flank: 0, sections }],
            ..Fields::default()
        }
    }

    #[test]
    fn grids_hold_every_cell_with_its_values() {
        let text = contact(&fields(1)).text().unwrap();
        assert!(text.contains("NumberOfPoints=\"4\" NumberOfCells=\"1\""), "{text}");
        assert_eq!(numbers(&text, "Name=\"pressure\""), [0.30000000000000004]);
        assert_eq!(numbers(&text, "Name=\"types\""), [9.0]);
        assert_eq!(numbers(&text, "Name=\"connectivity\""), [0.0, 1.0, 2.0, 3.0]);
        // Two lines along one section; two rows of two quadrilaterals between three sections.
        assert_eq!(root_stress(&fields(1)).cells, [(LINE, vec![0, 1]), (LINE, vec![1, 2])]);
        let quadrilaterals = root_stress(&fields(3)).cells;
        assert_eq!(quadrilaterals.len(), 4);
        assert_eq!(quadrilaterals[3], (QUADRILATERAL, vec![4, 5, 8, 7]));
    }

    #[test]
    fn meshes_have_their_displacements_and_stresses() {
        let sector = |tooth: u32, cell: Vec<usize>| SectorField {
            tooth,
            points: (0..cell.len()).map(|k| [0.1 * k as f64, 0.0, 0.0]).collect(),
            displacements: vec![[1e-6, 0.0, -2.5e-7]; cell.len()],
            stresses: vec![[1.0, 2.0, 3.0, 4.0, 5.0, 6.0]; cell.len()],
            stress_errors: vec![0.25; cell.len()],
            cells: vec![cell],
            elements: vec![0],
        };
        let sectors = vec![sector(0, vec![3, 2, 1, 0]), sector(7, (0..8).collect())];
        let body = BodyField { body: "gear".into(), number: 2, sectors, displaced: Vec::new() };
        let grid = bodies(&Fields { bodies: vec![body], ..fields(1) });
        assert_eq!(grid.cells, [(QUADRILATERAL, vec![3, 2, 1, 0]), (HEXAHEDRON, (4..12).collect())]);
        let text = grid.text().unwrap();
        // Displacements are small compared to positions: the sum of both keeps all their digits.
        assert_eq!(
            numbers(&text, "Float64\" NumberOfComponents=\"3\"")[..12],
            *grid.points[..4].as_flattened()
        );
        let single =
            |numbers: &[f64]| numbers.iter().map(|&number| f64::from(number as f32)).collect::<Vec<_>>();
        assert_eq!(numbers(&text, "Name=\"displacement\"")[..3], single(&[1e-6, 0.0, -2.5e-7]));
        // VTK stores the in-plane shear before the other shear components.
        assert_eq!(numbers(&text, "Name=\"stress\"")[..6], [1.0, 2.0, 3.0, 6.0, 4.0, 5.0]);
        let von_mises = (0.5 * (1.0 + 1.0 + 4.0) + 3.0 * (16.0 + 25.0 + 36.0_f64)).sqrt();
        assert_eq!(numbers(&text, "Name=\"von_mises\"")[..1], single(&[von_mises]));
        assert_eq!(numbers(&text, "Name=\"stress_error\"")[..2], [0.25, 0.25]);
        assert_eq!(numbers(&text, "Name=\"body\""), [2.0, 2.0]);
        assert_eq!(numbers(&text, "Name=\"tooth\""), [0.0, 7.0]);
        assert_eq!(numbers(&text, "Name=\"offsets\""), [4.0, 12.0]);
    }

    /// The midside nodes of every quadratic cell are in the middle of the edges of VTK's cell.
    #[test]
    fn elastic_bodies_have_cells_in_the_order_of_vtk() {
        let shape = SolidShape::Hexahedron20;
        let corners = shape.corners();
        let middle = |&[one, other]: &[usize; 2]| -> [f64; 3] {
            std::array::from_fn(|axis| 0.5 * (corners[one][axis] + corners[other][axis]))
        };
        let points: Vec<[f64; 3]> =
            corners.iter().copied().chain(shape.midside_edges().iter().map(middle)).collect();
        let stress = [3.0, 0.0, 0.0, 0.0, 0.0, 0.0];
        let mut stresses = vec![stress; 20];
        stresses[19] = [f64::NAN; 6];
        let body = ElasticBodyField {
            body: "housing".into(),
            number: 4,
            cells: vec![
                (CellShape::Solid(shape), (0..20).collect()),
                (CellShape::Shell(ShellShape::Quadrilateral4), vec![3, 2, 1, 0]),
                (CellShape::Line, vec![0, 6]),
            ],
            displacements: vec![[1e-6, 2e-6, 3e-6]; 20],
            stresses,
            stress_errors: vec![f64::NAN; 20],
            points,
        };
        let grid = bodies(&Fields { elastic_bodies: vec![body], ..fields(1) });
        let kinds: Vec<u8> = grid.cells.iter().map(|cell| cell.0).collect();
        assert_eq!(kinds, [25, QUADRILATERAL, LINE]);
        let nodes = &grid.cells[0].1;
        // VTK File Formats, quadratic hexahedron: edges of the bottom, of the top, between both.
        let edges =
            [[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 7], [7, 4], [0, 4], [1, 5], [2, 6], [3, 7]];
        for (at, [one, other]) in edges.into_iter().enumerate() {
            let [found, one, other] = [nodes[8 + at], nodes[one], nodes[other]].map(|node| grid.points[node]);
            for axis in 0..3 {
                assert_eq!(found[axis], 0.5 * (one[axis] + other[axis]), "edge {at}");
            }
        }
        let text = grid.text().unwrap();
        assert_eq!(numbers(&text, "Name=\"von_mises\"")[..19], [3.0; 19]);
        assert!(numbers(&text, "Name=\"von_mises\"")[19].is_nan());
        assert_eq!(numbers(&text, "Name=\"body\""), [4.0; 3]);
        assert_eq!(numbers(&text, "Name=\"tooth\""), [-1.0; 3]);
    }

    /// Zero, one and several blocks, the last one full or not.
    #[test]
    fn arrays_of_any_length_are_whole() {
        for count in [1, 7, 16384, 16385, 40000] {
            let expected: Vec<f64> = (0..count).map(|k| (k as f64).sqrt()).collect();
            let values = vec![Values::scalars("roots", expected.clone())];
            let text = Grid { point_values: values, ..Grid::default() }.text().unwrap();
            assert_eq!(numbers(&text, "Name=\"roots\""), expected, "{count}");
        }
        let text = Grid::default().text().unwrap();
        assert_eq!(text.matches("format=\"ascii\"></DataArray>").count(), 4, "{text}");
    }

    /// Readers reject a grid without points as a broken file.
    #[test]
    fn positions_without_stress_have_no_picture_of_it() {
        let directory = tempfile::tempdir().unwrap();
        let mut pictures = VtuFiles::begin(directory.path(), Vec::new()).unwrap();
        let there = |name: &str| folder(directory.path()).join(name).exists();
        let none = Fields { fillets: Vec::new(), ..fields(1) };
        pictures.write(0, 0.25, &none).unwrap();
        assert!(there("contact-0000.vtu") && !there("root_stress-0000.vtu") && !there("root_stress.pvd"));
        assert!(are_in(directory.path(), 1));
        pictures.write(1, 0.5, &fields(1)).unwrap();
        pictures.write(2, 0.75, &none).unwrap();
        let list = |kind: &str| {
            let text = fs::read_to_string(folder(directory.path()).join(format!("{kind}.pvd"))).unwrap();
            text.matches("<DataSet").count()
        };
        assert_eq!((list("contact"), list("root_stress")), (3, 1));
        // A resumed run lists the same files.
        let mut pictures = VtuFiles::begin(directory.path(), vec![0.25, 0.5, 0.75]).unwrap();
        pictures.write(3, 1.0, &none).unwrap();
        assert_eq!((list("contact"), list("root_stress")), (4, 1));
    }

    #[test]
    fn names_of_files_are_known() {
        let directory = tempfile::tempdir().unwrap();
        let mut pictures = VtuFiles::begin(directory.path(), Vec::new()).unwrap();
        pictures.write(0, 0.25, &fields(1)).unwrap();
        assert!(are_in(directory.path(), 1) && !are_in(directory.path(), 2));
        let list = fs::read_to_string(folder(directory.path()).join("contact.pvd")).unwrap();
        assert!(list.contains("timestep=\"0.25\" file=\"contact-0000.vtu\""), "{list}");
        fs::write(folder(directory.path()).join("notes.txt"), "").unwrap();
        let (mut found, known) = (files_in(directory.path()), files_of(0).collect::<Vec<_>>());
        found.sort();
        let expected = ["contact-0000.vtu", "contact.pvd", "root_stress-0000.vtu", "root_stress.pvd"];
        assert_eq!(found, expected.map(|name| format!("{FOLDER}/{name}")));
        assert!(found.iter().all(|name| known.contains(name)), "{known:?}");
    }
}
