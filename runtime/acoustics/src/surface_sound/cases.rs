//! Motions at one frequency, and what their readers share.

use calyx_numerics::error::EngineError;
use calyx_numerics::vec3::Vector;
use faer::c64;
use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::f64::consts::TAU;

/// Quantities of results: velocity, displacement and acceleration, the preferred one first.
pub(super) const QUANTITIES: [i64; 3] = [11, 8, 12];

/// Kind of a vibration.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum CaseKind {
    /// Frequency response of a load case; its name is empty if the file has only one.
    Response(String),
    /// Normal mode of this number.
    Mode(i64),
}

/// Vibration at one frequency.
#[derive(Clone, Debug, PartialEq)]
pub struct VibrationCase {
    /// Kind.
    pub kind: CaseKind,
    /// Frequency, Hz.
    pub frequency: f64,
    /// Location in the file, such as `dataset 55 at line 12`.
    pub place: String,
    /// Complex amplitudes of the velocities of the nodes, m/s, with the time factor exp(iωt); NaN
    /// at nodes without a result.
    pub velocities: Vec<[c64; 3]>,
}

/// Returns the error of a file whose sound cannot be computed.
pub(super) fn refused(message: impl Into<String>, help: impl Into<String>) -> EngineError {
    EngineError::new("E0784", message, help)
}

/// Reasons why parts of a file are skipped, with how often.
#[derive(Default)]
pub(super) struct Skipped(BTreeMap<String, usize>);

impl Skipped {
    /// Counts a reason.
    pub fn add(&mut self, reason: impl Into<String>) {
        self.add_many(reason, 1);
    }

    /// Counts a reason several times.
    pub fn add_many(&mut self, reason: impl Into<String>, count: usize) {
        *self.0.entry(reason.into()).or_default() += count;
    }

    /// Returns all reasons; `None` without any.
    pub fn text(&self) -> Option<String> {
        let part = |(reason, count): (&String, &usize)| match count {
            1 => reason.clone(),
            count => format!("{count} times {reason}"),
        };
        let all: Vec<String> = self.0.iter().map(part).collect();
        (!all.is_empty()).then(|| all.join(", "))
    }
}

/// Nodes of a file.
pub(super) struct Nodes<'f> {
    /// Positions by label, in the units of the file.
    pub positions: &'f HashMap<i64, Vector>,
    /// Indices of the nodes of elements by label.
    pub index: &'f HashMap<i64, usize>,
    /// Factor by which lengths of the file are divided to be in m.
    pub factor: f64,
    /// Noun for the file of the nodes in messages.
    pub owner: &'static str,
    /// Remedy for results of nodes that the file lacks.
    pub help: &'static str,
}

/// Clears the name of the load case if there is only one.
pub(super) fn name_single_load(cases: &mut [VibrationCase]) {
    let is_response = |case: &&VibrationCase| matches!(case.kind, CaseKind::Response(_));
    let loads: BTreeSet<CaseKind> = cases.iter().filter(is_response).map(|case| case.kind.clone()).collect();
    for case in cases {
        if let CaseKind::Response(load) = &mut case.kind
            && loads.len() == 1
        {
            load.clear();
        }
    }
}

/// Returns the factor that makes a displacement, velocity or acceleration a velocity.
pub(super) fn to_velocity(quantity: i64, frequency: f64) -> c64 {
    let omega = TAU * frequency;
    match quantity {
        8 => c64::new(0.0, omega),
        12 => c64::new(0.0, -omega.recip()),
        _ => c64::new(1.0, 0.0),
    }
}
