//! Rolling elements of bearings at the position with the largest element load, of those whose
//! fields are recorded: loads, contact angles and pressures of all elements, and pressures along
//! the most loaded rollers.
//!
//! The complete tables are on disk before the journal records a position. A resumed run starts with
//! them, and may add a position a second time, which does not change them.

use crate::contact_pattern::{read, write};
use calyx_runtime::observables::{Fields, RollingBearingField};
use calyx_runtime::rolling::ElementState;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// File name of the table of rolling elements in a run directory.
pub const ELEMENTS: &str = "rolling_elements.csv";
/// File name of the table of pressures along rollers in a run directory.
pub const ROLLERS: &str = "roller_pressure.csv";
/// Names of the files that a run may write.
pub const FILES: [&str; 4] = [ELEMENTS, ROLLERS, "rolling_elements.csv.part", "roller_pressure.csv.part"];

/// Rolling element at the position with the largest element load of its bearing, SI.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ElementLoad {
    /// Name of the bearing.
    pub bearing: String,
    /// Index of the position.
    pub step: usize,
    /// Time of the position, s.
    pub time: f64,
    /// Row of the bearing, from 0.
    pub row: usize,
    /// Element of the row, from 0.
    pub element: usize,
    /// Azimuth from the x axis of the bearing to its y axis, rad.
    pub azimuth: f64,
    /// Load on the inner raceway, N: of a ball with two contacts the larger one.
    pub inner_load: f64,
    /// Load on the outer raceway, N.
    pub outer_load: f64,
    /// Contact angle at the inner raceway, rad; `None` for rollers and unloaded balls.
    pub inner_contact_angle: Option<f64>,
    /// Contact angle at the outer raceway, rad.
    pub outer_contact_angle: Option<f64>,
    /// Load of the rib on a roller, N.
    pub rib_load: Option<f64>,
    /// Largest contact pressure, Pa.
    pub pressure: f64,
}

impl ElementLoad {
    /// Returns the larger of the loads on both raceways, N.
    pub fn load(&self) -> f64 {
        self.inner_load.max(self.outer_load)
    }
}

/// Lamina of the most loaded roller of a row, SI.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct RollerLamina {
    /// Name of the bearing.
    pub bearing: String,
    /// Row of the bearing, from 0.
    pub row: usize,
    /// Element of the row, from 0.
    pub element: usize,
    /// Distance from the middle of the roller, m: away from the apex of tapered rollers, and
    /// towards -z for cylindrical ones.
    pub position: f64,
    /// Pressure on the inner raceway, Pa.
    pub inner_pressure: f64,
    /// Pressure on the outer raceway, Pa.
    pub outer_pressure: f64,
}

/// Most loaded rolling elements of a run.
pub struct BearingLoads {
    directory: PathBuf,
    bearings: BTreeMap<String, (Vec<ElementLoad>, Vec<RollerLamina>)>,
}

impl BearingLoads {
    /// Starts with empty tables.
    pub fn create(directory: &Path) -> io::Result<BearingLoads> {
        for name in [ELEMENTS, ROLLERS] {
            match fs::remove_file(directory.join(name)) {
                Err(error) if error.kind() != io::ErrorKind::NotFound => return Err(error),
                _ => {}
            }
        }
        Ok(BearingLoads { directory: directory.to_owned(), bearings: BTreeMap::new() })
    }

    /// Starts with the tables that an earlier run has written into the directory.
    pub fn resume(directory: &Path) -> io::Result<BearingLoads> {
        let mut bearings: BTreeMap<String, (Vec<ElementLoad>, Vec<RollerLamina>)> = BTreeMap::new();
        for element in read_elements(directory)? {
            bearings.entry(element.bearing.clone()).or_default().0.push(element);
        }
        for lamina in read_rollers(directory)? {
            bearings.entry(lamina.bearing.clone()).or_default().1.push(lamina);
        }
        Ok(BearingLoads { directory: directory.to_owned(), bearings })
    }

    /// Adds a position. Without rolling bearings, no tables are written.
    pub fn add(&mut self, (step, time): (usize, f64), fields: &Fields) -> io::Result<()> {
        let mut changed = false;
        for bearing in &fields.rolling_bearings {
            let loads = element_loads((step, time), bearing);
            let largest = |loads: &[ElementLoad]| loads.iter().map(ElementLoad::load).fold(0.0, f64::max);
            let known = self.bearings.get(&bearing.bearing).map(|(known, _)| largest(known));
            if known.is_none_or(|known| largest(&loads) > known) {
                self.bearings.insert(bearing.bearing.clone(), (loads, laminae(bearing)));
                changed = true;
            }
        }
        if !changed {
            return Ok(());
        }
        // The elements decide whether a resumed run adds the position again, so they come last.
        if self.bearings.values().any(|(_, laminae)| !laminae.is_empty()) {
            let laminae = self.bearings.values().flat_map(|(_, laminae)| laminae);
            write(&self.directory.join(ROLLERS), laminae)?;
        }
        write(&self.directory.join(ELEMENTS), self.bearings.values().flat_map(|(loads, _)| loads))
    }
}

/// Returns the elements of a bearing with their indices within the row.
fn numbered(bearing: &RollingBearingField) -> impl Iterator<Item = (usize, &ElementState)> {
    bearing.elements.chunk_by(|one, other| one.row == other.row).flat_map(|row| row.iter().enumerate())
}

fn element_loads((step, time): (usize, f64), bearing: &RollingBearingField) -> Vec<ElementLoad> {
    let of = |(element, state): (usize, &ElementState)| {
        let [(inner_load, inner_contact_angle), (outer_load, outer_contact_angle)] =
            match (state.ball(), state.roller()) {
                (Some(ball), _) => [&ball.inner, &ball.outer].map(|contacts| {
                    let largest = contacts.iter().max_by(|one, other| one.load.total_cmp(&other.load));
                    let loaded = largest.filter(|contact| contact.load > 0.0);
                    (loaded.map_or(0.0, |contact| contact.load), loaded.map(|contact| contact.angle))
                }),
                (_, Some(roller)) => [&roller.inner, &roller.outer].map(|contact| (contact.load, None)),
                _ => [(0.0, None); 2],
            };
        ElementLoad {
            bearing: bearing.bearing.clone(),
            step,
            time,
            row: state.row,
            element,
            azimuth: state.azimuth,
            inner_load,
            outer_load,
            inner_contact_angle,
            outer_contact_angle,
            rib_load: state.roller().map(|roller| roller.rib),
            pressure: state.pressure(),
        }
    };
    numbered(bearing).map(of).collect()
}

/// Returns the laminae of the most loaded roller of each row.
fn laminae(bearing: &RollingBearingField) -> Vec<RollerLamina> {
    let mut all = Vec::new();
    let rows = bearing.elements.chunk_by(|one, other| one.row == other.row);
    for row in rows {
        let most = row.iter().enumerate().max_by(|(_, one), (_, other)| one.load().total_cmp(&other.load()));
        let Some((element, state)) = most else { continue };
        let Some(roller) = state.roller() else { continue };
        let pressures = roller.inner.pressures.iter().zip(&roller.outer.pressures);
        all.extend(roller.inner.positions.iter().zip(pressures).map(|(&position, (&inner, &outer))| {
            RollerLamina {
                bearing: bearing.bearing.clone(),
                row: state.row,
                element,
                position,
                inner_pressure: inner,
                outer_pressure: outer,
            }
        }));
    }
    all
}

/// Reads the table of rolling elements of a run; empty if there is none.
pub fn read_elements(directory: &Path) -> io::Result<Vec<ElementLoad>> {
    read(&directory.join(ELEMENTS))
}

/// Reads the table of pressures along rollers of a run; empty if there is none.
pub fn read_rollers(directory: &Path) -> io::Result<Vec<RollerLamina>> {
    read(&directory.join(ROLLERS))
}

#[cfg(test)]
mod tests {
    use super::*;
    use calyx_runtime::rolling::{
        Elements, Material, Profile, RollerGeometry, RollerKind, RollerRow, RollingBearing,
    };

    /// A cylindrical roller bearing at a radial displacement of its inner ring, m.
    fn fields(displacement: f64) -> Fields {
        let geometry = RollerGeometry {
            kind: RollerKind::Cylindrical { clearance: 0.0 },
            count: 12,
            roller_diameter: 8e-3,
            length: 10e-3,
            raceway_widths: [None; 2],
            pitch_diameter: 50e-3,
            profile: Profile::Logarithmic,
            laminae: 30,
            rings: Material::STEEL,
            rollers: Material::STEEL,
        };
        let row = RollerRow::new(geometry).expect("rollers");
        let bearing = RollingBearing::single(Elements::from(row));
        let elements = bearing.elements(&[displacement, 0.0, 0.0, 0.0, 0.0], &Default::default());
        Fields {
            rolling_bearings: vec![RollingBearingField {
                bearing: "left".into(),
                elements: elements.expect("elements"),
            }],
            ..Fields::default()
        }
    }

    #[test]
    fn the_position_with_the_largest_element_load_is_kept() {
        let directory = tempfile::tempdir().expect("a directory");
        let directory = directory.path();
        let mut loads = BearingLoads::create(directory).expect("tables");
        loads.add((0, 0.0), &Fields::default()).expect("no table");
        assert!(!directory.join(ELEMENTS).exists());
        for (step, displacement) in [(0, 5e-6), (1, 2e-5), (2, 1e-5)] {
            loads.add((step, 0.1 * step as f64), &fields(displacement)).expect("tables");
        }
        let elements = read_elements(directory).expect("elements");
        assert_eq!(elements.len(), 12);
        assert!(elements.iter().all(|element| element.step == 1 && element.time == 0.1));
        // The displacement of the inner ring loads the elements around the x axis.
        assert!(elements[0].load() > elements[1].load() && elements[1].load() > elements[2].load());
        assert!(elements[3..10].iter().all(|element| element.load() == 0.0));
        let rollers = read_rollers(directory).expect("rollers");
        assert_eq!(rollers.len(), 30);
        assert!(rollers.iter().all(|lamina| lamina.element == 0));
        let largest = rollers.iter().map(|lamina| lamina.inner_pressure).fold(0.0, f64::max);
        assert_eq!(largest.max(rollers[15].outer_pressure), elements[0].pressure);
        // A resumed run keeps the larger load.
        let mut resumed = BearingLoads::resume(directory).expect("tables");
        resumed.add((1, 0.1), &fields(2e-5)).expect("tables");
        resumed.add((3, 0.3), &fields(1.5e-5)).expect("tables");
        assert_eq!(read_elements(directory).expect("elements"), elements);
    }
}
