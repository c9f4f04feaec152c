//! Tables of what every position looks like: pressures, loads along the lines of contact, stresses in fillets, places of maxima.
//!
//! Rows of a position are on disk before its line of the journal, so that a run that goes on finds them; SI throughout.

use calyx_abi::description::OutputDescription;
use calyx_runtime::observe::{ContactField, Fields, FilletField};
use calyx_runtime::results::{Place, StepRow};
use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};

const PRESSURE: &str = "pressure.csv";
const LINE_LOAD: &str = "line_load.csv";
const ROOT_STRESS: &str = "root_stress.csv";
const PLACES: &str = "places.csv";

/// Their names in a run directory.
pub const NAMES: [&str; 4] = [PRESSURE, LINE_LOAD, ROOT_STRESS, PLACES];

/// Columns of the patch that a row belongs to.
const PATCH: [&str; 5] = ["step", "first_body", "first_tooth", "second_body", "second_tooth"];

/// The tables of a run, being written.
pub struct FieldTables {
    pressure: csv::Writer<File>,
    line_load: csv::Writer<File>,
    root_stress: csv::Writer<File>,
    places: csv::Writer<File>,
}

impl FieldTables {
    /// Begins them with their headers.
    pub fn create(directory: &Path) -> io::Result<FieldTables> {
        let begin = |name: &str, columns: Vec<&str>| -> io::Result<csv::Writer<File>> {
            let mut writer = csv::Writer::from_path(directory.join(name))?;
            writer.write_record(columns)?;
            writer.flush()?;
            Ok(writer)
        };
        let on_flanks = ["first_radius", "first_roll_angle", "second_radius", "second_roll_angle", "axial"];
        let patch = |columns: &[&'static str]| [&PATCH[..], &on_flanks, columns].concat();
        let at = ["body", "tooth", "radius", "roll_angle", "axial"];
        Ok(FieldTables {
            pressure: begin(PRESSURE, patch(&["pressure"]))?,
            line_load: begin(LINE_LOAD, patch(&["length", "force", "line_load"]))?,
            root_stress: begin(
                ROOT_STRESS,
                [&["step"][..], &at, &["along_profile", "along_face", "shear", "largest", "smallest"]]
                    .concat(),
            )?,
            places: begin(PLACES, [&["step", "output"][..], &at].concat())?,
        })
    }

    /// Begins them with what an earlier run has written of its first positions; `None` if it has written no such tables.
    pub fn go_on(directory: &Path, solved: usize) -> io::Result<Option<FieldTables>> {
        if !are_in(directory) {
            return Ok(None);
        }
        for name in NAMES {
            keep_first(&directory.join(name), solved)?;
        }
        let append = |name: &str| -> io::Result<csv::Writer<File>> {
            Ok(csv::Writer::from_writer(File::options().append(true).open(directory.join(name))?))
        };
        Ok(Some(FieldTables {
            pressure: append(PRESSURE)?,
            line_load: append(LINE_LOAD)?,
            root_stress: append(ROOT_STRESS)?,
            places: append(PLACES)?,
        }))
    }

    /// Adds a position.
    pub fn write(
        &mut self,
        step: usize,
        row: &StepRow,
        outputs: &[OutputDescription],
        fields: &Fields,
    ) -> io::Result<()> {
        for contact in &fields.contacts {
            self.contact(step, contact)?;
        }
        for fillet in &fields.fillets {
            self.fillet(step, fillet)?;
        }
        for (output, observed) in outputs.iter().zip(&row.outputs) {
            if let Some(place) = &observed.place {
                let named =
                    [step.to_string(), output.name.clone(), place.body.clone(), place.tooth.to_string()];
                self.places.write_record(named.into_iter().chain(coordinates(place)))?;
            }
        }
        for table in [&mut self.pressure, &mut self.line_load, &mut self.root_stress, &mut self.places] {
            table.flush()?;
        }
        Ok(())
    }

    fn contact(&mut self, step: usize, contact: &ContactField) -> io::Result<()> {
        let [first, second] = &contact.bodies;
        let [first_tooth, second_tooth] = contact.teeth.map(|tooth| tooth.to_string());
        let patch = [step.to_string(), first.clone(), first_tooth, second.clone(), second_tooth];
        let flanks = |first: &Place, second: &Place| {
            let [radius, roll, axial] = coordinates(first);
            let [second_radius, second_roll, _] = coordinates(second);
            [radius, roll, second_radius, second_roll, axial]
        };
        for cell in contact.cells.iter().filter(|cell| cell.pressure > 0.0) {
            let [first, second] = &cell.places;
            let record = patch.iter().cloned().chain(flanks(first, second));
            self.pressure.write_record(record.chain([cell.pressure.to_string()]))?;
        }
        for slice in contact.slices.iter().filter(|slice| slice.force > 0.0) {
            let [Some(first), Some(second)] = &slice.places else { continue };
            let record = patch.iter().cloned().chain(flanks(first, second));
            let load = [slice.length, slice.force, slice.line_load()].map(|number| number.to_string());
            self.line_load.write_record(record.chain(load))?;
        }
        Ok(())
    }

    fn fillet(&mut self, step: usize, fillet: &FilletField) -> io::Result<()> {
        for stress in fillet.sections.iter().flatten() {
            let named = [step.to_string(), fillet.body.clone(), fillet.tooth.to_string()];
            let ([along, across, shear], [largest, smallest]) = (stress.components, stress.principal);
            let stresses = [along, across, shear, largest, smallest].map(|number| number.to_string());
            self.root_stress
                .write_record(named.into_iter().chain(coordinates(&stress.place)).chain(stresses))?;
        }
        Ok(())
    }
}

/// Whether a run has written its tables into a directory.
pub fn are_in(directory: &Path) -> bool {
    NAMES.iter().all(|name| directory.join(name).exists())
}

/// Radius, roll angle and axial place; what a place does not have is left empty.
fn coordinates(place: &Place) -> [String; 3] {
    let optional = |number: Option<f64>| number.map(|number| number.to_string()).unwrap_or_default();
    [place.radius.to_string(), optional(place.roll_angle), optional(place.axial)]
}

/// Leaves of a table its header and the rows of the first positions.
fn keep_first(path: &PathBuf, positions: usize) -> io::Result<()> {
    let text = fs::read_to_string(path)?;
    let belongs = |line: &&str| {
        let step = line.split(',').next().and_then(|step| step.parse::<usize>().ok());
        // What was being written when the run ended has no end of line.
        line.ends_with('\n') && step.is_none_or(|step| step < positions)
    };
    fs::write(path, text.split_inclusive('\n').filter(belongs).collect::<String>())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_behind_the_last_complete_position_go() {
        let directory = tempfile::tempdir().unwrap();
        let path = directory.path().join(PRESSURE);
        fs::write(&path, "step,pressure\n0,1\n0,2\n1,3\n2,4\n2,").unwrap();
        keep_first(&path, 2).unwrap();
        assert_eq!(fs::read_to_string(&path).unwrap(), "step,pressure\n0,1\n0,2\n1,3\n");
        assert!(FieldTables::go_on(directory.path(), 2).unwrap().is_none(), "the other tables are missing");
    }
}
