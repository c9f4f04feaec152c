//! Pictures of runs as an independent reader of VTK's files finds them.

use std::collections::BTreeMap;
use std::path::Path;
use vtkio::Vtk;
use vtkio::model::{Attribute, Attributes, CellType, DataSet, Piece, UnstructuredGridPiece};

/// Values by name.
type Values = BTreeMap<String, Vec<f64>>;

/// Reads all pictures of a run of so many positions; those of stress are there if an output asks for it.
///
/// # Panics
/// If a file is missing, is no grid of quadrilaterals (in section, of lines), or holds what cannot be.
pub fn check(directory: &Path, positions: usize, stress: bool) {
    let folder = directory.join("vtu");
    assert_eq!(folder.join("root_stress.pvd").exists(), stress, "{}", directory.display());
    for kind in ["contact", "root_stress"].into_iter().take(1 + usize::from(stress)) {
        let list = std::fs::read_to_string(folder.join(format!("{kind}.pvd"))).expect("a list of pictures");
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
            check_grid(kind, &folder.join(attribute("file")));
        }
    }
}

fn check_grid(kind: &str, path: &Path) {
    let shown = path.display();
    let file = Vtk::import(path).unwrap_or_else(|error| panic!("{shown}: {error:?}"));
    let DataSet::UnstructuredGrid { pieces, .. } = file.data else { panic!("{shown} is no grid") };
    let [Piece::Inline(piece)] = &pieces[..] else { panic!("{shown} is not of one piece") };
    let UnstructuredGridPiece { points, cells, data } = &**piece;
    let points = points.cast_into::<f64>().expect("coordinates");
    let points: Vec<&[f64]> = points.chunks(3).collect();
    assert!(
        !points.is_empty() && points.iter().flat_map(|point| *point).all(|x| x.is_finite() && x.abs() < 10.0)
    );
    // In section a fillet is a line.
    let count = match cells.types.first() {
        Some(CellType::Line) if kind == "root_stress" => 2,
        _ => 4,
    };
    let kind_of_cell = if count == 2 { CellType::Line } else { CellType::Quad };
    assert!(!cells.types.is_empty() && cells.types.iter().all(|cell| *cell == kind_of_cell), "{shown}");
    let (corners, ends) = cells.cell_verts.clone().into_xml();
    assert_eq!((ends.len(), corners.len()), (cells.types.len(), count * cells.types.len()));
    // Quadrilaterals go round: their diagonals cross, so the area by them is no less than that of either half.
    for cell in corners.chunks(count).filter(|cell| cell.len() == 4) {
        let corner = |k: usize| points[cell[k] as usize];
        let side = |a: usize, b: usize| [0, 1, 2].map(|axis| corner(b)[axis] - corner(a)[axis]);
        let area = |a: [f64; 3], b: [f64; 3]| {
            let [x, y, z] = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
            0.5 * (x * x + y * y + z * z).sqrt()
        };
        let (whole, half) = (area(side(0, 2), side(1, 3)), area(side(0, 1), side(0, 2)));
        assert!(whole > 0.0 && half < whole * (1.0 + 1e-9), "{shown}: {whole} {half}");
    }
    let Attributes { point, cell } = data;
    let [on_points, on_cells] = [values(point), values(cell)];
    let whole = |tooth: &f64| *tooth >= 0.0 && tooth.fract() == 0.0;
    if kind == "contact" {
        let pressure = &on_cells["pressure"];
        assert_eq!(pressure.len(), cells.types.len());
        let largest = pressure.iter().copied().fold(0.0, f64::max);
        assert!(pressure.iter().all(|p| *p >= 0.0) && (1e7..1e10).contains(&largest), "{shown}: {largest}");
        assert!(on_cells["first_tooth"].iter().chain(&on_cells["second_tooth"]).all(whole));
    } else {
        let (largest, smallest) = (&on_points["largest_principal"], &on_points["smallest_principal"]);
        assert_eq!([largest.len(), smallest.len()], [points.len(); 2]);
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

fn values(attributes: &[Attribute]) -> Values {
    let array = |attribute: &Attribute| match attribute {
        Attribute::DataArray(array) => (array.name.clone(), array.data.cast_into::<f64>().expect("numbers")),
        other => panic!("{other:?}"),
    };
    attributes.iter().map(array).collect()
}
