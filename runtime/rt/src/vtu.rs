//! Pictures of positions for ParaView: the pressed cells of the flanks and the stresses in fillets, as VTK's XML files of unstructured
//! grids, with a collection that gives each its time.
//!
//! The files are tags around numbers, written here: the crates that write them read much more, and are not kept up.

use calyx_runtime::observe::Fields;
use std::fmt::{Display, Write as _};
use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// VTK's numbers of the kinds of cells used here.
const VERTEX: u8 = 1;
const LINE: u8 = 3;
const QUADRILATERAL: u8 = 9;

/// The two kinds of pictures of a position.
const KINDS: [&str; 2] = ["contact", "root_stress"];

/// The pictures of a run, being written into `vtu` of its directory.
pub struct Pictures {
    folder: PathBuf,
    times: Vec<f64>,
}

impl Pictures {
    /// Begins behind positions of an earlier run, at these times (s).
    pub fn begin(directory: &Path, times: Vec<f64>) -> io::Result<Pictures> {
        let folder = folder(directory);
        fs::create_dir_all(&folder)?;
        Ok(Pictures { folder, times })
    }

    /// Adds a position at a time (s). Of stress there is no picture where none is recovered: readers take a grid without points for a
    /// broken file.
    pub fn write(&mut self, step: usize, time: f64, fields: &Fields) -> io::Result<()> {
        fs::write(self.folder.join(name(KINDS[0], step)), contact(fields).text())?;
        let stress = root_stress(fields);
        if !stress.points.is_empty() {
            fs::write(self.folder.join(name(KINDS[1], step)), stress.text())?;
        }
        self.times.push(time);
        KINDS.iter().try_for_each(|kind| self.collect(kind))
    }

    /// The list of the pictures of a kind, if there are any.
    fn collect(&self, kind: &str) -> io::Result<()> {
        let there = |step: usize| self.folder.join(name(kind, step)).exists();
        let steps = self.times.iter().enumerate().filter(|(step, _)| there(*step));
        let steps: Vec<(usize, &f64)> = steps.collect();
        if steps.is_empty() {
            return Ok(());
        }
        let mut file = File::create(self.folder.join(format!("{kind}.pvd")))?;
        writeln!(
            file,
            "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n<Collection>"
        )?;
        for (step, time) in steps {
            writeln!(file, "<DataSet timestep=\"{time}\" file=\"{}\"/>", name(kind, step))?;
        }
        writeln!(file, "</Collection>\n</VTKFile>")
    }
}

fn folder(directory: &Path) -> PathBuf {
    directory.join("vtu")
}

fn name(kind: &str, step: usize) -> String {
    format!("{kind}-{step:04}.vtu")
}

/// Whether a run has written the pictures of its first positions into a directory.
pub fn are_in(directory: &Path, positions: usize) -> bool {
    positions == 0 || folder(directory).join(name(KINDS[0], positions - 1)).exists()
}

/// Removes the pictures of an earlier run.
pub fn remove(directory: &Path) -> io::Result<()> {
    let folder = folder(directory);
    let ours = |name: &str| {
        KINDS.iter().any(|kind| {
            name.strip_prefix(kind)
                .is_some_and(|rest| rest == ".pvd" || (rest.starts_with('-') && rest.ends_with(".vtu")))
        })
    };
    let entries = match fs::read_dir(&folder) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(()),
        entries => entries?,
    };
    for entry in entries {
        let entry = entry?;
        if entry.file_name().to_str().is_some_and(ours) {
            fs::remove_file(entry.path())?;
        }
    }
    // Somebody else's files stay, and their folder with them.
    let _ = fs::remove_dir(&folder);
    Ok(())
}

/// Points, cells over them, and values of either.
#[derive(Default)]
struct Grid {
    points: Vec<[f64; 3]>,
    cells: Vec<(u8, Vec<usize>)>,
    point_values: Vec<(&'static str, Vec<f64>)>,
    cell_values: Vec<(&'static str, Vec<f64>)>,
}

/// Every cell of every patch, with its pressure and the teeth it lies on.
fn contact(fields: &Fields) -> Grid {
    let mut grid = Grid::default();
    let (mut pressures, mut first_teeth, mut second_teeth) = (Vec::new(), Vec::new(), Vec::new());
    for contact in &fields.contacts {
        for cell in &contact.cells {
            let first = grid.points.len();
            grid.points.extend(cell.corners);
            grid.cells.push((QUADRILATERAL, (first..first + 4).collect()));
            pressures.push(cell.pressure);
            let [first_tooth, second_tooth] = contact.teeth.map(f64::from);
            first_teeth.push(first_tooth);
            second_teeth.push(second_tooth);
        }
    }
    grid.cell_values =
        vec![("pressure", pressures), ("first_tooth", first_teeth), ("second_tooth", second_teeth)];
    grid
}

/// The points of fillets at which stress is recovered: joined to quadrilaterals where sections along the face have as many
/// points each, to lines where there is one section.
fn root_stress(fields: &Fields) -> Grid {
    let mut grid = Grid::default();
    let mut values: [Vec<f64>; 4] = Default::default();
    for fillet in &fields.fillets {
        let first = grid.points.len();
        for stress in fillet.sections.iter().flatten() {
            grid.points.push(stress.point);
            let [largest, smallest] = stress.principal;
            let numbers = [largest, smallest, stress.components[0], f64::from(fillet.tooth)];
            values.iter_mut().zip(numbers).for_each(|(values, number)| values.push(number));
        }
        let across = fillet.sections.first().map_or(0, Vec::len);
        let even = fillet.sections.iter().all(|section| section.len() == across);
        let at = |section: usize, point: usize| first + section * across + point;
        match fillet.sections.len() {
            1 => grid.cells.extend((1..across).map(|point| (LINE, vec![at(0, point - 1), at(0, point)]))),
            sections if even => {
                for section in 1..sections {
                    let cell = |point: usize| {
                        let corners = [
                            (section - 1, point - 1),
                            (section - 1, point),
                            (section, point),
                            (section, point - 1),
                        ];
                        (QUADRILATERAL, corners.map(|(section, point)| at(section, point)).to_vec())
                    };
                    grid.cells.extend((1..across).map(cell));
                }
            }
            _ => grid.cells.extend((first..grid.points.len()).map(|point| (VERTEX, vec![point]))),
        }
    }
    let names = ["largest_principal", "smallest_principal", "along_profile", "tooth"];
    grid.point_values = names.into_iter().zip(values).collect();
    grid
}

impl Grid {
    fn text(&self) -> String {
        let mut text = format!(
            "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\">\n<UnstructuredGrid>\n\
             <Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n",
            self.points.len(),
            self.cells.len()
        );
        for (tag, values) in [("PointData", &self.point_values), ("CellData", &self.cell_values)] {
            let _ = writeln!(text, "<{tag}>");
            for (name, values) in values {
                array(&mut text, "Float64", &format!("Name=\"{name}\""), values);
            }
            let _ = writeln!(text, "</{tag}>");
        }
        text += "<Points>\n";
        array(&mut text, "Float64", "NumberOfComponents=\"3\"", self.points.as_flattened());
        text += "</Points>\n<Cells>\n";
        let corners: Vec<usize> = self.cells.iter().flat_map(|(_, corners)| corners).copied().collect();
        array(&mut text, "Int64", "Name=\"connectivity\"", &corners);
        let mut end = 0;
        let ends: Vec<usize> = self
            .cells
            .iter()
            .map(|(_, corners)| {
                end += corners.len();
                end
            })
            .collect();
        array(&mut text, "Int64", "Name=\"offsets\"", &ends);
        let kinds: Vec<u8> = self.cells.iter().map(|(kind, _)| *kind).collect();
        array(&mut text, "UInt8", "Name=\"types\"", &kinds);
        text + "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n"
    }
}

/// Numbers in their shortest decimals that read back to the same bits. Writing to a text cannot fail.
fn array(text: &mut String, kind: &str, attribute: &str, numbers: &[impl Display]) {
    let _ = writeln!(text, "<DataArray type=\"{kind}\" {attribute} format=\"ascii\">");
    for (index, number) in numbers.iter().enumerate() {
        let _ = write!(text, "{number}{}", if index % 9 == 8 { '\n' } else { ' ' });
    }
    text.push_str("\n</DataArray>\n");
}

#[cfg(test)]
mod tests {
    use super::*;
    use calyx_runtime::observe::{ContactField, FilletField, FilletStress, PressedCell};
    use calyx_runtime::results::Place;

    fn place() -> Place {
        Place { body: "pinion".into(), tooth: 2, roll_angle: None, radius: 0.02, axial: None }
    }

    fn fields(sections: usize) -> Fields {
        let cell = PressedCell {
            corners: [[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]],
            places: [place(), place()],
            pressure: 0.1 + 0.2,
        };
        let stress = |s: usize, z: usize| FilletStress {
            point: [s as f64, 0.0, z as f64],
            place: place(),
            depth: s as f64,
            components: [1.0, 0.0, 0.0],
            principal: [1.0, 0.0],
        };
        let sections = (0..sections).map(|z| (0..3).map(|s| stress(s, z)).collect()).collect();
        Fields {
            contacts: vec![ContactField {
                bodies: ["pinion".into(), "gear".into()],
                teeth: [2, 5],
                back: false,
                cells: vec![cell],
                slices: Vec::new(),
            }],
            fillets: vec![FilletField { body: "pinion".into(), tooth: 2, flank: 0, sections }],
        }
    }

    #[test]
    fn grids_hold_every_cell_with_its_values() {
        let text = contact(&fields(1)).text();
        assert!(text.contains("NumberOfPoints=\"4\" NumberOfCells=\"1\""), "{text}");
        assert!(text.contains("Name=\"pressure\" format=\"ascii\">\n0.30000000000000004 \n"), "{text}");
        assert!(text.contains("Name=\"types\" format=\"ascii\">\n9 \n"), "{text}");
        // Two lines along one section; two rows of two quadrilaterals between three.
        assert_eq!(root_stress(&fields(1)).cells, [(LINE, vec![0, 1]), (LINE, vec![1, 2])]);
        let quadrilaterals = root_stress(&fields(3)).cells;
        assert_eq!(quadrilaterals.len(), 4);
        assert_eq!(quadrilaterals[3], (QUADRILATERAL, vec![4, 5, 8, 7]));
    }

    /// Readers take a grid without points for a broken file.
    #[test]
    fn positions_without_stress_have_no_picture_of_it() {
        let directory = tempfile::tempdir().unwrap();
        let mut pictures = Pictures::begin(directory.path(), Vec::new()).unwrap();
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
        // A run that goes on behind them lists the same.
        let mut pictures = Pictures::begin(directory.path(), vec![0.25, 0.5, 0.75]).unwrap();
        pictures.write(3, 1.0, &none).unwrap();
        assert_eq!((list("contact"), list("root_stress")), (4, 1));
    }

    #[test]
    fn only_pictures_are_removed() {
        let directory = tempfile::tempdir().unwrap();
        let mut pictures = Pictures::begin(directory.path(), Vec::new()).unwrap();
        pictures.write(0, 0.25, &fields(1)).unwrap();
        assert!(are_in(directory.path(), 1) && !are_in(directory.path(), 2));
        let list = fs::read_to_string(folder(directory.path()).join("contact.pvd")).unwrap();
        assert!(list.contains("timestep=\"0.25\" file=\"contact-0000.vtu\""), "{list}");
        let own = folder(directory.path()).join("notes.txt");
        fs::write(&own, "").unwrap();
        remove(directory.path()).unwrap();
        assert!(own.exists() && !are_in(directory.path(), 1));
        fs::remove_file(&own).unwrap();
        remove(directory.path()).unwrap();
        assert!(!folder(directory.path()).exists());
        remove(directory.path()).unwrap();
    }
}
