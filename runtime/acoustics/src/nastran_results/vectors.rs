//! Vectors at grid points, and their collection from files in any order.

use faer::c64;
use std::collections::{BTreeMap, HashMap};
use std::f64::consts::TAU;

/// Quantity of vectors.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Motion {
    /// Displacement, or eigenvector.
    Displacement,
    /// Velocity.
    Velocity,
    /// Acceleration.
    Acceleration,
}

/// Analysis of vectors.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Analysis {
    /// Frequency response.
    Response,
    /// Normal mode of this number.
    Mode(i64),
}

/// Axes along which vectors have their components.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum VectorAxes {
    /// Displacement coordinate system of each grid point (field CD).
    Displacement,
    /// Basic coordinate system.
    Basic,
}

/// Vectors at grid points at one frequency.
#[derive(Clone, Debug, PartialEq)]
pub struct GridVectors {
    /// Location in the file, such as `table OUGV1 at byte 1200` or `line 12`.
    pub place: String,
    /// Identification number of the subcase.
    pub subcase: i64,
    /// Analysis.
    pub analysis: Analysis,
    /// Quantity.
    pub motion: Motion,
    /// Frequency, Hz; 0 for modes whose eigenvalue is not positive.
    pub frequency: f64,
    /// Axes of the components.
    pub axes: VectorAxes,
    /// Labels of the grid points, with the complex amplitudes of their translations.
    pub values: Vec<(i64, [c64; 3])>,
}

/// Motions of grid points that a file of results has.
#[derive(Clone, Debug, PartialEq)]
pub struct NastranResults {
    /// Vectors in the order of the file.
    pub vectors: Vec<GridVectors>,
    /// Reasons why parts of the file were skipped, with how often.
    pub skipped: BTreeMap<String, usize>,
    /// False if an OP2 file lacks its end mark: some programs do not write it, or the last tables
    /// are missing.
    pub is_complete: bool,
}

impl Default for NastranResults {
    fn default() -> Self {
        Self { vectors: Vec::new(), skipped: BTreeMap::new(), is_complete: true }
    }
}

/// Reason why a file of results is rejected, with its location and a remedy.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{place}: {message}")]
pub struct NastranResultsError {
    /// Location in the file: a table with its byte, a byte, or a line.
    pub place: String,
    /// Statement of the problem.
    pub message: String,
    /// Remedy, in the imperative.
    pub help: String,
}

/// Result with the errors of files of results.
pub(super) type Result<T> = std::result::Result<T, NastranResultsError>;

pub(super) fn error<T>(
    place: impl Into<String>,
    message: impl Into<String>,
    help: impl Into<String>,
) -> Result<T> {
    Err(NastranResultsError { place: place.into(), message: message.into(), help: help.into() })
}

/// Form of complex numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Form {
    Real,
    /// Real and imaginary parts.
    Cartesian,
    /// Magnitudes and phases in degrees.
    Polar,
}

impl Form {
    pub fn value(self, first: f64, second: f64) -> c64 {
        match self {
            Self::Real => c64::new(first, 0.0),
            Self::Cartesian => c64::new(first, second),
            Self::Polar => c64::from_polar(first, second.to_radians()),
        }
    }
}

/// Returns the frequency of a mode, Hz; 0 if the eigenvalue (rad²/s²) is not positive.
pub(super) fn mode_frequency(eigenvalue: f64) -> f64 {
    match eigenvalue > 0.0 {
        true => eigenvalue.sqrt() / TAU,
        false => 0.0,
    }
}

/// Vectors under construction.
#[derive(Default)]
pub(super) struct Collector {
    results: NastranResults,
    /// Vectors of the current section that are sorted by point, by the bits of their frequency.
    by_frequency: HashMap<(i64, Motion, u64), usize>,
}

impl Collector {
    pub fn skip(&mut self, reason: impl Into<String>, count: usize) {
        if count > 0 {
            *self.results.skipped.entry(reason.into()).or_default() += count;
        }
    }

    /// Adds vectors of one frequency. Drops vectors without values, such as those of scalar points.
    pub fn add(&mut self, vectors: GridVectors) {
        if !vectors.values.is_empty() {
            self.results.vectors.push(vectors);
        }
    }

    /// Ends a section of results that are sorted by point: later values do not join its vectors.
    pub fn end_section(&mut self) {
        self.by_frequency.clear();
    }

    /// Adds values of results that are sorted by point: `head` lacks them, and its frequency.
    pub fn add_by_point(&mut self, head: &GridVectors, label: i64, values: &[(f64, [c64; 3])]) {
        for (frequency, value) in values {
            let key = (head.subcase, head.motion, frequency.to_bits());
            let all = &mut self.results.vectors;
            let at = *self.by_frequency.entry(key).or_insert_with(|| {
                all.push(GridVectors { frequency: *frequency, values: Vec::new(), ..head.clone() });
                all.len() - 1
            });
            all[at].values.push((label, *value));
        }
    }

    pub fn set_complete(&mut self, is_complete: bool) {
        self.results.is_complete = is_complete;
    }

    pub fn finish(self) -> NastranResults {
        self.results
    }
}
