//! Checks of VTU files of runs by independent readers: vtkio in Rust, and meshio in Python.
//!
//! Without meshio, the Python part is skipped with a message; with `CALYX_CI_STRICT=1`, which
//! `.ci/run` sets after installing meshio, it fails.

use crate::python::python_with;
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::process::Command;
use vtkio::Vtk;
use vtkio::model::{Attribute, Attributes, CellType, DataSet, Piece, UnstructuredGridPiece};

/// Values by name.
type Values = BTreeMap<String, Vec<f64>>;

/// Expected VTU files of a run.
#[derive(Clone, Copy)]
pub struct Expected {
    pub positions: usize,
    /// True if an output requests root stress.
    pub stress: bool,
    /// True if bodies have meshes.
    pub bodies: bool,
}

/// Reads all VTU files of a run.
///
/// # Panics
/// If a file is missing, is not a grid of the expected cells, contains implausible values, or
/// differs in meshio.
pub fn check(directory: &Path, expected: Expected) {
    let folder = directory.join("vtu");
    let Expected { positions, stress, bodies } = expected;
    let mut found = BTreeMap::new();
    for (kind, there) in [("contact", true), ("root_stress", stress), ("bodies", bodies)] {
        let list = folder.join(format!("{kind}.pvd"));
        assert_eq!(list.exists(), there, "{}", list.display());
        if !there {
            continue;
        }
        let list = std::fs::read_to_string(list).expect("a list of pictures");
        let entries: Vec<&str> = list.lines().filter(|line| line.starts_with("<DataSet ")).collect();
        assert_eq!(entries.len(), positions, "{list}");
        let mut last = f64::NEG_INFINITY;
        for entry in entries {
            let attribute = |name: &str| {
                let (_, rest) = entry.split_once(&format!("{name}=\"")).expect("an attribute");
                rest.split_once('"').expect("its end").0
            };
            let time: f64 = attribute("timestep").parse().expect("a time");
            assert!(time > last, "{list}");
            last = time;
            let file = attribute("file");
            let grid = read(&folder.join(file));
            match kind {
                "bodies" => grid.check_bodies(),
                _ => grid.check_surfaces(kind),
            }
            found.insert(file.to_owned(), grid);
        }
    }
    check_by_meshio(&folder, &found);
}

/// Grid as read by vtkio.
struct Grid {
    shown: String,
    points: Vec<f64>,
    kinds: Vec<CellType>,
    corners: Vec<u64>,
    on_points: Values,
    on_cells: Values,
}

fn read(path: &Path) -> Grid {
    let shown = path.display().to_string();
    let file = Vtk::import(path).unwrap_or_else(|error| panic!("{shown}: {error:?}"));
    let DataSet::UnstructuredGrid { pieces, .. } = file.data else { panic!("{shown} is no grid") };
    let [Piece::Inline(piece)] = &pieces[..] else { panic!("{shown} is not of one piece") };
    let UnstructuredGridPiece { points, cells, data: Attributes { point, cell } } = &**piece;
    let points = points.cast_into::<f64>().expect("coordinates");
    assert!(!points.is_empty() && points.iter().all(|x| x.is_finite() && x.abs() < 10.0));
    let (corners, ends) = cells.cell_verts.clone().into_xml();
    assert_eq!(ends.len(), cells.types.len(), "{shown}");
    let [on_points, on_cells] = [point, cell].map(|attributes| values(attributes));
    Grid { shown, points, kinds: cells.types.clone(), corners, on_points, on_cells }
}

fn whole(number: &f64) -> bool {
    *number >= 0.0 && number.fract() == 0.0
}

impl Grid {
    fn point(&self, number: u64) -> [f64; 3] {
        [0, 1, 2].map(|axis| self.points[3 * number as usize + axis])
    }

    /// Checks a grid of contact pressure or root stress.
    fn check_surfaces(&self, kind: &str) {
        let shown = &self.shown;
        // In a plane model a fillet is a line.
        let count = match self.kinds.first() {
            Some(CellType::Line) if kind == "root_stress" => 2,
            _ => 4,
        };
        let kind_of_cell = if count == 2 { CellType::Line } else { CellType::Quad };
        assert!(!self.kinds.is_empty() && self.kinds.iter().all(|cell| *cell == kind_of_cell), "{shown}");
        assert_eq!(self.corners.len(), count * self.kinds.len());
        // Corners are in cyclic order: the diagonals cross, so the area from them is at least that
        // of either triangle.
        for cell in self.corners.chunks(count).filter(|cell| cell.len() == 4) {
            let side = |a: usize, b: usize| minus(self.point(cell[b]), self.point(cell[a]));
            let area = |a: [f64; 3], b: [f64; 3]| 0.5 * dot(cross(a, b), cross(a, b)).sqrt();
            let (whole, half) = (area(side(0, 2), side(1, 3)), area(side(0, 1), side(0, 2)));
            assert!(whole > 0.0 && half < whole * (1.0 + 1e-9), "{shown}: {whole} {half}");
        }
        let (on_points, on_cells) = (&self.on_points, &self.on_cells);
        if kind == "contact" {
            let pressure = &on_cells["pressure"];
            assert_eq!(pressure.len(), self.kinds.len());
            let largest = pressure.iter().copied().fold(0.0, f64::max);
            assert!(
                pressure.iter().all(|p| *p >= 0.0) && (1e7..1e10).contains(&largest),
                "{shown}: {largest}"
            );
            assert!(on_cells["first_tooth"].iter().chain(&on_cells["second_tooth"]).all(whole));
        } else {
            let (largest, smallest) = (&on_points["largest_principal"], &on_points["smallest_principal"]);
            assert_eq!([largest.len(), smallest.len()], [self.points.len() / 3; 2]);
            for (index, along) in on_points["along_profile"].iter().enumerate() {
                let slack = 1e-9 * largest[index].abs().max(smallest[index].abs());
                assert!(
                    *along <= largest[index] + slack && *along >= smallest[index] - slack,
                    "{shown}: {along}"
                );
            }
            let most = largest.iter().copied().fold(0.0, f64::max);
            assert!((1e6..1e10).contains(&most), "{shown}: {most}");
            assert!(on_points["tooth"].iter().all(whole));
        }
    }

    /// Checks that no cell is inverted, and that displacements and stresses are plausible for
    /// steel.
    fn check_bodies(&self) {
        let (shown, points) = (&self.shown, self.points.len() / 3);
        let mut cells = &self.corners[..];
        for kind in &self.kinds {
            let count = match kind {
                CellType::Quad => 4,
                CellType::Hexahedron => 8,
                other => panic!("{shown}: {other:?}"),
            };
            let (cell, rest) = cells.split_at(count);
            cells = rest;
            let side = |a: usize, b: usize| minus(self.point(cell[b]), self.point(cell[a]));
            let across = cross(side(0, 2), side(1, 3));
            // The plane as seen against the z axis.
            let up = if count == 4 { [0.0, 0.0, 1.0] } else { side(0, 4) };
            assert!(dot(across, up) > 0.0, "{shown}: a cell is turned over");
        }
        let [displacement, stress, von_mises] =
            ["displacement", "stress", "von_mises"].map(|name| &self.on_points[name]);
        assert_eq!([displacement.len(), stress.len(), von_mises.len()], [3 * points, 6 * points, points]);
        let most = |values: &[f64]| values.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
        assert!((1e-8..1e-3).contains(&most(displacement)), "{shown}: {}", most(displacement));
        assert!((1e6..1e11).contains(&most(von_mises)), "{shown}: {}", most(von_mises));
        for (tensor, equivalent) in stress.chunks_exact(6).zip(von_mises) {
            let [xx, yy, zz, xy, yz, zx] = [0, 1, 2, 3, 4, 5].map(|part| tensor[part]);
            let mean = (xx + yy + zz) / 3.0;
            let direct: f64 = [xx, yy, zz].iter().map(|part| (part - mean).powi(2)).sum();
            let expected = (1.5 * (direct + 2.0 * (xy * xy + yz * yz + zx * zx))).sqrt();
            let scale = most(tensor);
            assert!((expected - equivalent).abs() <= 1e-5 * scale, "{shown}: {expected} {equivalent}");
        }
        for name in ["body", "tooth"] {
            let numbers = &self.on_cells[name];
            assert!(numbers.len() == self.kinds.len() && numbers.iter().all(whole), "{shown}");
        }
    }
}

fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|axis| a[axis] - b[axis])
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn cross([a, b, c]: [f64; 3], [x, y, z]: [f64; 3]) -> [f64; 3] {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}

/// Checks that meshio reads the same points, cells and values in every file of the lists.
fn check_by_meshio(folder: &Path, expected: &BTreeMap<String, Grid>) {
    let Some(python) = python_with("meshio") else { return };
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/read_vtu.py");
    let output = Command::new(python).arg(script).arg(folder).output().expect("Python starts");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let found: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    let files = found["files"].as_object().expect("files by their names");
    assert_eq!(files.keys().collect::<BTreeSet<_>>(), expected.keys().collect());
    for (name, grid) in expected {
        let file = &files[name];
        let mut cells: BTreeMap<&str, u64> = BTreeMap::new();
        for kind in &grid.kinds {
            let kind = match kind {
                CellType::Line => "line",
                CellType::Quad => "quad",
                CellType::Hexahedron => "hexahedron",
                other => panic!("{name}: {other:?}"),
            };
            *cells.entry(kind).or_default() += 1;
        }
        assert_eq!(file["cells"], serde_json::to_value(cells).expect("numbers"), "{name}");
        check_numbers(&format!("{name}: points"), &file["points"], &grid.points, grid.points.len() / 3);
        for (part, values, count) in [
            ("point_data", &grid.on_points, grid.points.len() / 3),
            ("cell_data", &grid.on_cells, grid.kinds.len()),
        ] {
            let arrays = file[part].as_object().expect("arrays by their names");
            assert_eq!(arrays.keys().collect::<BTreeSet<_>>(), values.keys().collect(), "{name}");
            for (array, numbers) in arrays {
                check_numbers(&format!("{name}: {array}"), numbers, &values[array], count);
            }
        }
    }
}

fn check_numbers(shown: &str, found: &Value, expected: &[f64], count: usize) {
    assert_eq!(found["count"], count, "{shown}");
    assert_eq!(found["components"], expected.len() / count, "{shown}");
    let size: f64 = expected.iter().map(|value| value.abs()).sum();
    let least = expected.iter().copied().fold(f64::INFINITY, f64::min);
    let largest = expected.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    for (name, value) in [("sum", expected.iter().sum()), ("least", least), ("largest", largest)] {
        let found = found[name].as_f64().expect("a number");
        assert!((found - value).abs() <= 1e-12 * size, "{shown}: {name} {found} {value}");
    }
}

fn values(attributes: &[Attribute]) -> Values {
    let array = |attribute: &Attribute| match attribute {
        Attribute::DataArray(array) => (array.name.clone(), array.data.cast_into::<f64>().expect("numbers")),
        other => panic!("{other:?}"),
    };
    attributes.iter().map(array).collect()
}
