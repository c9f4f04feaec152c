//! Rows of results, one per solved position.

use calyx_contact::problem::Certificate;
use calyx_model::observed::{Observed, OutputRequest};
use calyx_model::position::Position;
use serde::{Deserialize, Serialize};

/// Reported row of a solved position.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct StepRow {
    /// The position.
    pub position: Position,
    /// Values by output.
    pub outputs: Vec<Observed>,
    /// Warnings about the position, in sentences.
    pub warnings: Vec<String>,
}

impl StepRow {
    /// Creates the row of a position from the values of all observables of the scene.
    pub fn new(
        position: Position,
        requests: &[OutputRequest],
        observed: &[Observed],
        warnings: Vec<String>,
    ) -> Self {
        let outputs = requests.iter().map(|request| request.evaluate(position.time, observed)).collect();
        StepRow { position, outputs, warnings }
    }
}

/// Solved position with its certificate: all that a later run needs to resume after it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Solved {
    /// Reported row.
    pub row: StepRow,
    /// Certificate: residuals of the contact solution.
    pub certificate: Certificate,
    /// State of the coordinates after a time step, from which the next step starts; empty for an
    /// equilibrium.
    pub state: Vec<f64>,
}
