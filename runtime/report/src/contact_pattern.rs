//! Loaded contact patterns of gears on general axes: the largest pressure at each point of a flank
//! over a run, and the path of contact, the centre of pressure of each tooth pair at each position.
//!
//! Points of a flank have the coordinates of its surface, as fractions: `along_face` from one end
//! of the face to the other, `along_profile` from the fillet over the rounded tip edge. All teeth
//! of a gear have the same shape and share one pattern. [`crate::flank_tables`] has the positions
//! of these points on the gear.
//!
//! The complete tables are on disk before the journal records a position. A resumed run starts with
//! them, and may add a position a second time, which does not change them.

use calyx_runtime::observables::{ContactField, Fields, FlankCorners, PressedCell};
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// File name of the table of pressures in a run directory.
pub const PATTERN: &str = "contact_pattern.csv";
/// File name of the table of centres of pressure in a run directory.
pub const PATH: &str = "contact_path.csv";
/// Names of the files that a run may write.
pub const FILES: [&str; 4] = [PATTERN, PATH, "contact_pattern.csv.part", "contact_path.csv.part"];

/// Number of columns of a pattern along the face.
pub const COLUMNS: usize = 96;
/// Number of rows of a pattern along the profile.
pub const ROWS: usize = 64;

/// Largest pressure at a point of the flanks of a gear, SI.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct PressurePoint {
    /// Name of the body.
    pub body: String,
    /// Name of the other body.
    pub mate: String,
    /// `drive` or `coast`.
    pub flank: String,
    /// 0 for the counter-clockwise flank, 1 for the clockwise one.
    pub surface: u32,
    /// Index along the face.
    pub column: usize,
    /// Index along the profile.
    pub row: usize,
    /// Fraction of the range along the face at the centre of the point.
    pub along_face: f64,
    /// Fraction of the range along the profile at the centre of the point.
    pub along_profile: f64,
    /// Largest pressure away from edges, Pa.
    pub pressure: f64,
    /// Largest pressure on rounded edges, Pa.
    pub edge_pressure: f64,
}

/// Centre of pressure of a tooth pair at a position, SI.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct PathPoint {
    pub step: usize,
    pub first_body: String,
    pub first_tooth: u32,
    pub second_body: String,
    pub second_tooth: u32,
    /// `drive` or `coast`.
    pub flank: String,
    /// Normal force, N.
    pub force: f64,
    /// Part of the normal force on rounded edges, N.
    pub edge_force: f64,
    /// Coordinates on the flank of the first body, as fractions.
    pub first_along_face: f64,
    pub first_along_profile: f64,
    /// Coordinates on the flank of the second body, as fractions.
    pub second_along_face: f64,
    pub second_along_profile: f64,
}

/// Flank of a body in a mesh: body, mate, flank, surface.
type FlankKey = (String, String, String, u32);
type PathKey = (usize, String, String, String, u32, u32);

/// Contact patterns of a run.
pub struct ContactPattern {
    directory: PathBuf,
    /// Pressures away from edges and on edges, by row and column.
    flanks: BTreeMap<FlankKey, BTreeMap<(usize, usize), [f64; 2]>>,
    path: BTreeMap<PathKey, PathPoint>,
}

impl ContactPattern {
    /// Starts with empty tables.
    pub fn create(directory: &Path) -> io::Result<ContactPattern> {
        for name in [PATTERN, PATH] {
            match fs::remove_file(directory.join(name)) {
                Err(error) if error.kind() != io::ErrorKind::NotFound => return Err(error),
                _ => {}
            }
        }
        let directory = directory.to_owned();
        Ok(ContactPattern { directory, flanks: BTreeMap::new(), path: BTreeMap::new() })
    }

    /// Starts with the tables that an earlier run has written into the directory.
    pub fn resume(directory: &Path) -> io::Result<ContactPattern> {
        let mut flanks: BTreeMap<FlankKey, BTreeMap<(usize, usize), [f64; 2]>> = BTreeMap::new();
        for point in read_pattern(directory)? {
            let key = (point.body, point.mate, point.flank, point.surface);
            let pressures = [point.pressure, point.edge_pressure];
            flanks.entry(key).or_default().insert((point.row, point.column), pressures);
        }
        let path = read_path(directory)?.into_iter().map(|point| (key(&point), point)).collect();
        Ok(ContactPattern { directory: directory.to_owned(), flanks, path })
    }

    /// Adds a position. If no gears mesh on general axes, no tables are written.
    pub fn add(&mut self, step: usize, fields: &Fields) -> io::Result<()> {
        fields.contacts.iter().for_each(|contact| self.see(step, contact));
        if self.flanks.is_empty() {
            return Ok(());
        }
        let points = self.flanks.iter().flat_map(|(key, cells)| {
            cells.iter().map(move |(place, pressures)| pressure_point(key, *place, *pressures))
        });
        write(&self.directory.join(PATTERN), points)?;
        write(&self.directory.join(PATH), self.path.values())
    }

    fn see(&mut self, step: usize, contact: &ContactField) {
        let flank = crate::field_tables::flank_name(contact.back);
        let mut centre = Centre::default();
        for cell in &contact.cells {
            let Some(corners) = &cell.flank_corners else { continue };
            centre.add(cell, corners);
            for (side, corners) in corners.iter().enumerate() {
                let [body, mate] = [side, 1 - side].map(|side| contact.bodies[side].clone());
                let key = (body, mate, flank.to_owned(), contact.surfaces[side]);
                let cells = self.flanks.entry(key).or_default();
                for place in covered(corners) {
                    let seen = &mut cells.entry(place).or_insert([0.0; 2])[usize::from(cell.edge)];
                    *seen = seen.max(cell.pressure);
                }
            }
        }
        if let Some(point) = centre.point(step, contact, flank) {
            self.path.insert(key(&point), point);
        }
    }
}

/// Sums of the cells of a contact patch.
#[derive(Default)]
struct Centre {
    force: f64,
    edge_force: f64,
    moments: [[f64; 2]; 2],
}

impl Centre {
    fn add(&mut self, cell: &PressedCell, corners: &[FlankCorners; 2]) {
        let [a, b, _, d] = cell.corners;
        let sides = [b, d].map(|end| [0, 1, 2].map(|k: usize| end[k] - a[k]));
        let size = |[x, y, z]: [f64; 3]| x.hypot(y).hypot(z);
        let force = cell.pressure * size(sides[0]) * size(sides[1]);
        self.force += force;
        self.edge_force += if cell.edge { force } else { 0.0 };
        for (moment, corners) in self.moments.iter_mut().zip(corners) {
            let middle = middle(corners);
            *moment = [0, 1].map(|k: usize| moment[k] + force * middle[k]);
        }
    }

    fn point(&self, step: usize, contact: &ContactField, flank: &str) -> Option<PathPoint> {
        let Centre { force, edge_force, moments } = self;
        let [first, second] = moments.map(|moment| moment.map(|part| part / force));
        (*force > 0.0).then(|| PathPoint {
            step,
            first_body: contact.bodies[0].clone(),
            first_tooth: contact.teeth[0],
            second_body: contact.bodies[1].clone(),
            second_tooth: contact.teeth[1],
            flank: flank.to_owned(),
            force: *force,
            edge_force: *edge_force,
            first_along_face: first[0],
            first_along_profile: first[1],
            second_along_face: second[0],
            second_along_profile: second[1],
        })
    }
}

fn key(point: &PathPoint) -> PathKey {
    let bodies = (point.first_body.clone(), point.second_body.clone());
    (point.step, bodies.0, bodies.1, point.flank.clone(), point.first_tooth, point.second_tooth)
}

fn middle(corners: &FlankCorners) -> [f64; 2] {
    [0, 1].map(|k: usize| corners.iter().map(|corner| corner[k]).sum::<f64>() / 4.0)
}

/// Returns the centre of a point of the pattern, by row and column, as fractions of the ranges
/// along the face and along the profile.
pub fn centre((row, column): (usize, usize)) -> [f64; 2] {
    [(column as f64 + 0.5) / COLUMNS as f64, (row as f64 + 0.5) / ROWS as f64]
}

/// Returns the points of the pattern, by row and column, whose centres a cell covers, and those on
/// its middle lines: cells on edges are narrower than points.
fn covered(corners: &FlankCorners) -> BTreeSet<(usize, usize)> {
    let counts = [COLUMNS as f64, ROWS as f64];
    let index = |value: f64, k: usize| (value * counts[k]).floor().clamp(0.0, counts[k] - 1.0) as usize;
    let ends = [0, 1].map(|k: usize| {
        let values = || corners.iter().map(|corner| corner[k]);
        let (low, high) =
            (values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max));
        index(low, k)..=index(high, k)
    });
    let [columns, rows] = ends;
    let mut all: BTreeSet<(usize, usize)> = rows
        .flat_map(|row| columns.clone().map(move |column| (row, column)))
        .filter(|place| contains(corners, centre(*place)))
        .collect();
    let half_way = |a: usize, b: usize| [0, 1].map(|k: usize| 0.5 * (corners[a][k] + corners[b][k]));
    for [from, to] in [[half_way(0, 1), half_way(2, 3)], [half_way(1, 2), half_way(3, 0)]] {
        let points = (0..2).map(|k| (to[k] - from[k]).abs() * counts[k]).fold(1.0, f64::max);
        let parts = (2.0 * points).ceil().min(400.0) as usize;
        for part in 0..parts {
            let part = (part as f64 + 0.5) / parts as f64;
            let [x, y] = [0, 1].map(|k: usize| from[k] + part * (to[k] - from[k]));
            if (0.0..=1.0).contains(&x) && (0.0..=1.0).contains(&y) {
                all.insert((index(y, 1), index(x, 0)));
            }
        }
    }
    all
}

/// Returns whether a convex quadrilateral contains a point.
fn contains(corners: &FlankCorners, [x, y]: [f64; 2]) -> bool {
    let turns = [0, 1, 2, 3].map(|k: usize| {
        let ([ax, ay], [bx, by]) = (corners[k], corners[(k + 1) % 4]);
        (bx - ax) * (y - ay) - (by - ay) * (x - ax)
    });
    turns.iter().all(|turn| *turn >= 0.0) || turns.iter().all(|turn| *turn <= 0.0)
}

fn pressure_point(
    (body, mate, flank, surface): &FlankKey,
    place: (usize, usize),
    [pressure, edge_pressure]: [f64; 2],
) -> PressurePoint {
    let [along_face, along_profile] = centre(place);
    PressurePoint {
        body: body.clone(),
        mate: mate.clone(),
        flank: flank.clone(),
        surface: *surface,
        column: place.1,
        row: place.0,
        along_face,
        along_profile,
        pressure,
        edge_pressure,
    }
}

/// Writes to a temporary file and renames it, so that readers never see a partial table.
pub(crate) fn write<T: Serialize>(path: &Path, rows: impl Iterator<Item = T>) -> io::Result<()> {
    let unfinished = path.with_extension("csv.part");
    let mut writer = csv::Writer::from_path(&unfinished)?;
    for row in rows {
        writer.serialize(row)?;
    }
    writer.flush()?;
    fs::rename(unfinished, path)
}

/// Reads a table; empty if there is none.
pub(crate) fn read<T: DeserializeOwned>(path: &Path) -> io::Result<Vec<T>> {
    if !path.exists() {
        return Ok(Vec::new());
    }
    Ok(csv::Reader::from_path(path)?.deserialize().collect::<Result<_, _>>()?)
}

/// Reads the pressures of a run; empty if there are none.
pub fn read_pattern(directory: &Path) -> io::Result<Vec<PressurePoint>> {
    read(&directory.join(PATTERN))
}

/// Reads the centres of pressure of a run; empty if there are none.
pub fn read_path(directory: &Path) -> io::Result<Vec<PathPoint>> {
    read(&directory.join(PATH))
}

#[cfg(test)]
mod tests {
    use super::*;
    use calyx_runtime::results::Location;

    /// A cell of 1 mm by 2 mm around a point of both flanks.
    fn cell(at: [f64; 2], half: f64, pressure: f64, edge: bool) -> PressedCell {
        let place =
            || Location { body: String::new(), tooth: 0, roll_angle: None, radius: 0.02, axial: Some(0.0) };
        let around = [[-half, -half], [half, -half], [half, half], [-half, half]];
        let corners = around.map(|[x, y]: [f64; 2]| [at[0] + x, at[1] + y]);
        PressedCell {
            corners: [[0.0; 3], [1e-3, 0.0, 0.0], [1e-3, 2e-3, 0.0], [0.0, 2e-3, 0.0]],
            locations: [place(), place()],
            pressure,
            edge,
            zone: None,
            flank_corners: Some([corners, corners.map(|[x, y]| [1.0 - x, y])]),
        }
    }

    fn fields(cells: Vec<PressedCell>) -> Fields {
        let contact = ContactField {
            bodies: ["pinion".into(), "gear".into()],
            teeth: [1, 4],
            surfaces: [0, 1],
            back: false,
            cells,
            slices: Vec::new(),
            states: Vec::new(),
        };
        Fields { contacts: vec![contact], ..Fields::default() }
    }

    #[test]
    fn the_pattern_has_the_largest_pressures_of_both_flanks() {
        let directory = tempfile::tempdir().unwrap();
        let directory = directory.path();
        let parallel = PressedCell { flank_corners: None, ..cell([0.5; 2], 0.1, 1e9, false) };
        ContactPattern::create(directory).unwrap().add(0, &fields(vec![parallel])).unwrap();
        assert!(!directory.join(PATTERN).exists(), "a table of nothing");
        let positions = [
            fields(vec![cell([0.25, 0.5], 0.05, 1e9, false), cell([0.35, 0.5], 0.05, 3e9, true)]),
            fields(vec![cell([0.25, 0.5], 0.05, 2e9, false)]),
            fields(vec![cell([0.999, 0.3], 1e-5, 5e8, false)]),
        ];
        let mut whole = ContactPattern::create(directory).unwrap();
        positions.iter().enumerate().for_each(|(step, fields)| whole.add(step, fields).unwrap());
        let points = read_pattern(directory).unwrap();
        let of = |body: &str| points.iter().filter(|point| point.body == body).collect::<Vec<_>>();
        let largest = |at: [f64; 2]| {
            let near = |point: &&&PressurePoint| {
                (point.along_face - at[0]).abs() < 0.02 && (point.along_profile - at[1]).abs() < 0.02
            };
            let pinion = of("pinion");
            let found: Vec<[f64; 2]> =
                pinion.iter().filter(near).map(|point| [point.pressure, point.edge_pressure]).collect();
            assert!(!found.is_empty(), "{at:?}");
            found.into_iter().reduce(|a, b| [a[0].max(b[0]), a[1].max(b[1])]).unwrap()
        };
        assert_eq!(largest([0.25, 0.5]), [2e9, 0.0]);
        assert_eq!(largest([0.35, 0.5]), [0.0, 3e9]);
        assert_eq!(largest([0.99, 0.3]), [5e8, 0.0]);
        // A square of a fifth of the face by a tenth of the profile.
        let count = of("pinion").len() as f64 - 1.0;
        assert!((count / (0.02 * (COLUMNS * ROWS) as f64) - 1.0).abs() < 0.2, "{count}");
        assert!(of("gear").iter().all(|point| point.surface == 1 && point.along_face < 0.8));
        let path = read_path(directory).unwrap();
        assert_eq!(path.len(), 3);
        // Equal areas: three quarters of the force are on the edge.
        assert!((path[0].first_along_face - 0.325).abs() < 1e-12 && path[0].step == 0);
        assert!((path[0].edge_force / path[0].force - 0.75).abs() < 1e-12);
        assert!((path[0].force - 4e9 * 2e-6).abs() < 1e-6, "{}", path[0].force);
        assert!((path[0].second_along_face - 0.675).abs() < 1e-12);

        // Interrupted after the second position, which is solved again.
        let expected = [PATTERN, PATH].map(|name| fs::read_to_string(directory.join(name)).unwrap());
        let mut ended = ContactPattern::create(directory).unwrap();
        positions[..2].iter().enumerate().for_each(|(step, fields)| ended.add(step, fields).unwrap());
        let mut again = ContactPattern::resume(directory).unwrap();
        positions[1..].iter().enumerate().for_each(|(step, fields)| again.add(step + 1, fields).unwrap());
        assert_eq!([PATTERN, PATH].map(|name| fs::read_to_string(directory.join(name)).unwrap()), expected);
    }
}
