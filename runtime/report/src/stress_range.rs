//! Extreme stresses at each point of the fillets over a run: the input of a fatigue assessment, a
//! thousandth of the size of the stresses of all positions.
//!
//! All teeth of a gear have the same shape, so a point is the same on all of them. The complete
//! table is on disk before the journal records a position. A resumed run starts with the table, and
//! may add a position a second time, which does not change the extremes.

use calyx_runtime::observables::{Fields, FilletStress};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// File name in a run directory.
pub const NAME: &str = "root_stress_range.csv";

/// Extreme stresses at a point of the fillets of a body, in SI.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct StressExtremes {
    pub body: String,
    /// Flank next to the fillet: 0 or 1.
    pub flank: u32,
    /// Index along the face, from 0; a plane model has one section.
    pub section: usize,
    /// Index along the profile from the end of the flank, from 0.
    pub point: usize,
    /// Distance along the profile from the end of the flank towards the root, m.
    pub depth: f64,
    /// Radius, m.
    pub radius: f64,
    /// Axial coordinate from the middle of the face, m; `None` in a plane model.
    pub axial: Option<f64>,
    /// Maximum of the largest principal stress, Pa.
    pub largest: f64,
    /// Minimum of the smallest principal stress, Pa.
    pub smallest: f64,
}

type Key = (String, u32, usize, usize);

/// Extreme stresses of the fillets of a run.
pub struct StressRange {
    path: PathBuf,
    places: BTreeMap<Key, StressExtremes>,
}

impl StressRange {
    /// Starts an empty table.
    pub fn create(directory: &Path) -> io::Result<StressRange> {
        let path = directory.join(NAME);
        match fs::remove_file(&path) {
            Err(error) if error.kind() != io::ErrorKind::NotFound => Err(error),
            _ => Ok(StressRange { path, places: BTreeMap::new() }),
        }
    }

    /// Starts with the table that an earlier run has written into the directory.
    pub fn resume(directory: &Path) -> io::Result<StressRange> {
        let seen = read(directory)?.into_iter();
        let key = |seen: &StressExtremes| (seen.body.clone(), seen.flank, seen.section, seen.point);
        Ok(StressRange { path: directory.join(NAME), places: seen.map(|seen| (key(&seen), seen)).collect() })
    }

    /// Adds a position. If there are no stresses, no table is written.
    pub fn add(&mut self, fields: &Fields) -> io::Result<()> {
        for fillet in &fields.fillets {
            for (section, stresses) in fillet.sections.iter().enumerate() {
                for (point, stress) in stresses.iter().enumerate() {
                    self.see((fillet.body.clone(), fillet.flank, section, point), stress);
                }
            }
        }
        if self.places.is_empty() { Ok(()) } else { self.write() }
    }

    fn see(&mut self, key: Key, stress: &FilletStress) {
        let [largest, smallest] = stress.principal;
        let seen =
            self.places.entry(key).or_insert_with_key(|(body, flank, section, point)| StressExtremes {
                body: body.clone(),
                flank: *flank,
                section: *section,
                point: *point,
                depth: stress.depth,
                radius: stress.location.radius,
                axial: stress.location.axial,
                largest,
                smallest,
            });
        seen.largest = seen.largest.max(largest);
        seen.smallest = seen.smallest.min(smallest);
    }

    /// Writes to a temporary file and renames it, so that readers never see a partial table.
    fn write(&self) -> io::Result<()> {
        let unfinished = self.path.with_extension("csv.part");
        let mut writer = csv::Writer::from_path(&unfinished)?;
        self.places.values().try_for_each(|seen| writer.serialize(seen))?;
        writer.flush()?;
        fs::rename(unfinished, &self.path)
    }
}

/// Reads the table of a run; empty if there is none.
pub fn read(directory: &Path) -> io::Result<Vec<StressExtremes>> {
    let path = directory.join(NAME);
    if !path.exists() {
        return Ok(Vec::new());
    }
    Ok(csv::Reader::from_path(path)?.deserialize().collect::<Result<_, _>>()?)
}

#[cfg(test)]
mod tests {
    use super::*;
    use calyx_runtime::observables::FilletField;
    use calyx_runtime::results::Location;

    fn fields(tooth: u32, principal: [f64; 2]) -> Fields {
        let location = Location { body: "pinion".into(), tooth, roll_angle: None, radius: 0.02, axial: None };
        let stress = FilletStress {
            point: [0.0; 3],
            location,
            depth: 1e-4,
            components: [principal[0], 0.0, 0.0],
            principal,
        };
        let sections = vec![vec![stress]];
        Fields {
            fillets: vec![FilletField { body: "pinion".into(), tooth, flank: 1, sections }],
            ..Fields::default()
        }
    }

    #[test]
    fn teeth_fall_together_and_a_position_may_be_added_twice() {
        let directory = tempfile::tempdir().unwrap();
        let directory = directory.path();
        StressRange::create(directory).unwrap().add(&Fields::default()).unwrap();
        assert!(!directory.join(NAME).exists(), "a table of nothing");
        let positions = [fields(0, [1.0 / 3.0, 0.0]), fields(1, [7e6, -1e-3]), fields(2, [2.0, -5e6])];
        let mut whole = StressRange::create(directory).unwrap();
        positions.iter().for_each(|position| whole.add(position).unwrap());
        let expected = fs::read_to_string(directory.join(NAME)).unwrap();
        let [seen] = &read(directory).unwrap()[..] else { panic!("{expected}") };
        assert_eq!((seen.largest, seen.smallest, seen.flank), (7e6, -5e6, 1));
        // Interrupted after the second position, which is solved again.
        let mut ended = StressRange::create(directory).unwrap();
        positions[..2].iter().for_each(|position| ended.add(position).unwrap());
        let mut again = StressRange::resume(directory).unwrap();
        positions[1..].iter().for_each(|position| again.add(position).unwrap());
        assert_eq!(fs::read_to_string(directory.join(NAME)).unwrap(), expected);
    }
}
