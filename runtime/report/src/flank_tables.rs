//! Tables of the flanks of gears on general axes, from the surfaces alone: outline of the teeth on
//! their projection plane, unloaded contact, and ease-off.
//!
//! Points of a flank have the coordinates of [`crate::contact_pattern`]: fractions of the range of
//! its surface along the face and along the profile.

use crate::contact_pattern::{read, write};
use serde::{Deserialize, Serialize};
use std::io;
use std::path::Path;

/// File name of the table of outlines in a run directory.
pub const FLANKS: &str = "tooth_flanks.csv";
/// File name of the table of unloaded contact.
pub const UNLOADED: &str = "unloaded_contact.csv";
/// File name of the table of the ease-off.
pub const EASE_OFF: &str = "ease_off.csv";
/// Names of the files that a run may write.
pub const FILES: [&str; 6] =
    [FLANKS, UNLOADED, EASE_OFF, "tooth_flanks.csv.part", "unloaded_contact.csv.part", "ease_off.csv.part"];

/// Entry of [`FlankRow::part`] for a point of the flank.
pub const ON_FLANK: &str = "flank";
/// Entry of [`FlankRow::part`] for a point of the rounded tip edge.
pub const ON_EDGE: &str = "tip_edge";
/// Entry of [`FlankRow::part`] for a point of the root.
pub const ON_ROOT: &str = "root";

/// Point of a flank or of the root next to it on the projection plane, SI.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct FlankRow {
    pub body: String,
    pub mate: String,
    /// `drive` or `coast`.
    pub flank: String,
    /// 0 for the counter-clockwise flank, 1 for the clockwise one.
    pub surface: u32,
    /// `concave`, `convex` or `straight` along the face.
    pub shape: String,
    /// True on a cone, whose distances run from the toe to the heel.
    pub conical: bool,
    /// [`ON_FLANK`], [`ON_EDGE`] or [`ON_ROOT`].
    pub part: String,
    pub column: usize,
    pub row: usize,
    pub along_face: f64,
    pub along_profile: f64,
    /// Axial position in the coordinates of the body, m.
    pub axial: f64,
    /// Radius, m.
    pub radius: f64,
    /// Distance from the toe along the pitch cone, m.
    pub distance: f64,
    /// Height above the root at mid-face, normal to the pitch cone, m.
    pub height: f64,
}

/// Unloaded contact of a tooth pair at a position, SI.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct UnloadedRow {
    pub first_body: String,
    pub second_body: String,
    /// `drive` or `coast`.
    pub flank: String,
    /// Pitch angle of the first gear, rad: other tooth pairs are in the same contact this angle
    /// later or earlier.
    pub pitch: f64,
    /// Rotation of the first gear in its drive sense from time 0, rad.
    pub rotation: f64,
    /// Rotation by which the second gear lags, rad, if this tooth pair alone is in contact.
    pub transmission_error: f64,
    /// True if the pair touches before its neighbours.
    pub touches: bool,
    /// True if an edge touches.
    pub edge: bool,
    pub first_along_face: f64,
    pub first_along_profile: f64,
    pub second_along_face: f64,
    pub second_along_profile: f64,
}

/// Ease-off at a point of the first flank, SI.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct EaseOffRow {
    pub first_body: String,
    pub second_body: String,
    /// `drive` or `coast`.
    pub flank: String,
    pub column: usize,
    pub row: usize,
    pub first_along_face: f64,
    pub first_along_profile: f64,
    pub second_along_face: f64,
    pub second_along_profile: f64,
    /// Normal distance from the surface conjugate to the second flank, m.
    pub ease_off: f64,
    /// Smallest normal distance from the second flank while the unloaded pair rotates, m.
    pub gap: f64,
}

/// All tables.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FlankTables {
    pub flanks: Vec<FlankRow>,
    pub unloaded: Vec<UnloadedRow>,
    pub ease_off: Vec<EaseOffRow>,
}

impl FlankTables {
    /// Writes the tables that have rows.
    pub fn write(&self, directory: &Path) -> io::Result<()> {
        if !self.flanks.is_empty() {
            write(&directory.join(FLANKS), self.flanks.iter())?;
        }
        if !self.unloaded.is_empty() {
            write(&directory.join(UNLOADED), self.unloaded.iter())?;
        }
        if !self.ease_off.is_empty() {
            write(&directory.join(EASE_OFF), self.ease_off.iter())?;
        }
        Ok(())
    }

    /// Reads the tables of a run; missing ones are empty.
    pub fn read(directory: &Path) -> io::Result<FlankTables> {
        Ok(FlankTables {
            flanks: read(&directory.join(FLANKS))?,
            unloaded: read(&directory.join(UNLOADED))?,
            ease_off: read(&directory.join(EASE_OFF))?,
        })
    }
}
