//! Tables of the fields of positions: line loads along the contact lines and, if requested,
//! pressures by cell, stresses in fillets and locations of maxima.
//!
//! The rows of a position are on disk before its line of the journal, so that a resumed run finds
//! them. All columns are in SI.

use calyx_abi::description::OutputDescription;
use calyx_runtime::observables::{ContactField, Fields, FilletField, LocalState};
use calyx_runtime::results::{Location, StepRow};
use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};

const PRESSURE: &str = "pressure.csv";
const ROOT_STRESS: &str = "root_stress.csv";
const MAX_LOCATIONS: &str = "max_locations.csv";
/// Former name of [`MAX_LOCATIONS`], with the same rows; written until version 0.2.
const PLACES: &str = "places.csv";

/// Table of line loads along the contact lines. It is small and the report needs it, so every run
/// writes it.
pub const LINE_LOAD: &str = "line_load.csv";
/// File names of the optional tables in a run directory.
const OPTIONAL: [&str; 4] = [PRESSURE, ROOT_STRESS, MAX_LOCATIONS, PLACES];

/// File names of all tables in a run directory.
pub const NAMES: [&str; 5] = [LINE_LOAD, PRESSURE, ROOT_STRESS, MAX_LOCATIONS, PLACES];

/// Columns that identify the contact patch of a row.
const PATCH: [&str; 6] = ["step", "first_body", "first_tooth", "second_body", "second_tooth", "side"];
/// Columns of sliding, rolling and lubrication of a point of a contact line: m/s, m, W/m, K. The
/// last four are empty for a mesh without lubrication.
const STATE: [&str; 8] = [
    "first_rolling_velocity",
    "second_rolling_velocity",
    "sliding_velocity",
    "relative_radius",
    "friction_coefficient",
    "friction_power",
    "flash_temperature",
    "film_thickness",
];
/// Last column of the tables of contact patches: [`DRIVE`] or [`COAST`].
const FLANK: &str = "flank";
/// Entry of the column `flank` for the drive side of a tooth.
pub const DRIVE: &str = "drive";
/// Entry of the column `flank` for the coast side.
pub const COAST: &str = "coast";
/// Entries of the column `side`, the former name of `flank`, for [`DRIVE`] and [`COAST`]; written
/// until version 0.2.
pub const FORMER_SIDES: [&str; 2] = ["driving", "back"];

/// Writers of the tables of a run.
pub struct FieldTables {
    line_load: csv::Writer<File>,
    optional: Option<OptionalTables>,
}

/// Writers of the large tables, which are written on request.
struct OptionalTables {
    pressure: csv::Writer<File>,
    root_stress: csv::Writer<File>,
    max_locations: csv::Writer<File>,
    places: csv::Writer<File>,
}

impl FieldTables {
    /// Creates the tables with their headers; the optional ones if `optional`.
    pub fn create(directory: &Path, optional: bool) -> io::Result<FieldTables> {
        let begin = |name: &str, columns: Vec<&str>| -> io::Result<csv::Writer<File>> {
            let mut writer = csv::Writer::from_path(directory.join(name))?;
            writer.write_record(columns)?;
            writer.flush()?;
            Ok(writer)
        };
        let on_flanks = ["first_radius", "first_roll_angle", "second_radius", "second_roll_angle", "axial"];
        let patch = |columns: &[&'static str]| [&PATCH[..], &on_flanks, columns, &[FLANK]].concat();
        let at = ["body", "tooth", "radius", "roll_angle", "axial"];
        let tables = || -> io::Result<OptionalTables> {
            let stresses = ["along_profile", "along_face", "shear", "largest", "smallest"];
            Ok(OptionalTables {
                pressure: begin(PRESSURE, patch(&["pressure"]))?,
                root_stress: begin(ROOT_STRESS, [&["step"][..], &at, &stresses].concat())?,
                max_locations: begin(MAX_LOCATIONS, [&["step", "output"][..], &at].concat())?,
                places: begin(PLACES, [&["step", "output"][..], &at].concat())?,
            })
        };
        Ok(FieldTables {
            line_load: begin(
                LINE_LOAD,
                patch(&[&["length", "force", "line_load", "pressure", "edge_pressure"], &STATE[..]].concat()),
            )?,
            optional: optional.then(tables).transpose()?,
        })
    }

    /// Continues the tables of an earlier run after its first `solved` positions; [`are_in`] must
    /// be true.
    pub fn resume(directory: &Path, solved: usize, optional: bool) -> io::Result<FieldTables> {
        let append = |name: &str| -> io::Result<csv::Writer<File>> {
            let path = directory.join(name);
            keep_first(&path, solved)?;
            Ok(csv::Writer::from_writer(File::options().append(true).open(path)?))
        };
        let tables = || -> io::Result<OptionalTables> {
            Ok(OptionalTables {
                pressure: append(PRESSURE)?,
                root_stress: append(ROOT_STRESS)?,
                max_locations: append(MAX_LOCATIONS)?,
                places: append(PLACES)?,
            })
        };
        Ok(FieldTables { line_load: append(LINE_LOAD)?, optional: optional.then(tables).transpose()? })
    }

    /// Appends a position.
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
        self.line_load.flush()?;
        self.optional.as_mut().map_or(Ok(()), |tables| tables.write(step, row, outputs, fields))
    }

    fn contact(&mut self, step: usize, contact: &ContactField) -> io::Result<()> {
        for (slice, state) in contact.slices.iter().zip(&contact.states) {
            let [Some(first), Some(second)] = &slice.locations else { continue };
            if slice.force <= 0.0 {
                continue;
            }
            let numbers = [slice.length, slice.force, slice.line_load(), slice.pressure, slice.edge_pressure];
            let load = numbers.map(|number| number.to_string());
            let record = patch(step, contact).into_iter().chain(on_flanks(first, second));
            let record = record.chain(load).chain(state_columns(state.as_ref()));
            self.line_load.write_record(record.chain([flank(contact)]))?;
        }
        Ok(())
    }
}

/// Returns the columns of a contact patch.
fn patch(step: usize, contact: &ContactField) -> [String; 6] {
    let [first, second] = &contact.bodies;
    let [first_tooth, second_tooth] = contact.teeth.map(|tooth| tooth.to_string());
    let side = FORMER_SIDES[usize::from(contact.back)];
    [step.to_string(), first.clone(), first_tooth, second.clone(), second_tooth, side.into()]
}

/// Returns the entry of the column [`FLANK`].
fn flank(contact: &ContactField) -> String {
    flank_name(contact.back).into()
}

/// Returns the name of the coast flanks (`back`) or of the drive flanks.
pub(crate) fn flank_name(back: bool) -> &'static str {
    if back { COAST } else { DRIVE }
}

/// Returns the columns of [`STATE`]; a quantity that the point lacks is empty.
fn state_columns(state: Option<&LocalState>) -> [String; 8] {
    let Some(LocalState { contact, lubricated }) = state else { return Default::default() };
    let [first, second] = contact.rolling.map(|velocity| velocity.to_string());
    let motion = [first, second, contact.sliding.to_string(), contact.curvature.recip().to_string()];
    let local = lubricated.map(|local| {
        [local.friction, local.friction_power, local.flash_temperature, local.film_thickness]
            .map(|number| number.to_string())
    });
    let ([first, second, sliding, radius], [friction, power, flash, film]) =
        (motion, local.unwrap_or_default());
    [first, second, sliding, radius, friction, power, flash, film]
}

/// Returns the columns of a location on both flanks.
fn on_flanks(first: &Location, second: &Location) -> [String; 5] {
    let [radius, roll, axial] = coordinates(first);
    let [second_radius, second_roll, _] = coordinates(second);
    [radius, roll, second_radius, second_roll, axial]
}

impl OptionalTables {
    fn write(
        &mut self,
        step: usize,
        row: &StepRow,
        outputs: &[OutputDescription],
        fields: &Fields,
    ) -> io::Result<()> {
        for contact in &fields.contacts {
            for cell in contact.cells.iter().filter(|cell| cell.pressure > 0.0) {
                let [first, second] = &cell.locations;
                let record = patch(step, contact).into_iter().chain(on_flanks(first, second));
                self.pressure.write_record(record.chain([cell.pressure.to_string(), flank(contact)]))?;
            }
        }
        for fillet in &fields.fillets {
            self.fillet(step, fillet)?;
        }
        for (output, observed) in outputs.iter().zip(&row.outputs) {
            if let Some(place) = &observed.location {
                let named =
                    [step.to_string(), output.name.clone(), place.body.clone(), place.tooth.to_string()];
                let record: Vec<String> = named.into_iter().chain(coordinates(place)).collect();
                self.max_locations.write_record(&record)?;
                self.places.write_record(&record)?;
            }
        }
        [&mut self.pressure, &mut self.root_stress, &mut self.max_locations, &mut self.places]
            .into_iter()
            .try_for_each(csv::Writer::flush)
    }

    fn fillet(&mut self, step: usize, fillet: &FilletField) -> io::Result<()> {
        for stress in fillet.sections.iter().flatten() {
            let named = [step.to_string(), fillet.body.clone(), fillet.tooth.to_string()];
            let ([along, across, shear], [largest, smallest]) = (stress.components, stress.principal);
            let stresses = [along, across, shear, largest, smallest].map(|number| number.to_string());
            self.root_stress
                .write_record(named.into_iter().chain(coordinates(&stress.location)).chain(stresses))?;
        }
        Ok(())
    }
}

/// Returns true if a run has written its tables into a directory, including the optional ones if
/// `optional`.
pub fn are_in(directory: &Path, optional: bool) -> bool {
    let requested = OPTIONAL.iter().filter(|_| optional);
    requested.chain([&LINE_LOAD]).all(|name| directory.join(name).exists())
}

/// Returns radius, roll angle and axial coordinate; a coordinate that the location lacks is empty.
fn coordinates(place: &Location) -> [String; 3] {
    let optional = |number: Option<f64>| number.map(|number| number.to_string()).unwrap_or_default();
    [place.radius.to_string(), optional(place.roll_angle), optional(place.axial)]
}

/// Truncates a table to its header and the rows of the first positions.
fn keep_first(path: &PathBuf, positions: usize) -> io::Result<()> {
    let text = fs::read_to_string(path)?;
    let belongs = |line: &&str| {
        let step = line.split(',').next().and_then(|step| step.parse::<usize>().ok());
        // An incomplete last line has no line break.
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
        fs::write(directory.path().join(LINE_LOAD), "step\n").unwrap();
        assert!(are_in(directory.path(), false) && !are_in(directory.path(), true), "the others are missing");
    }
}
