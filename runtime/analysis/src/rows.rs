//! Rows of results: a solved position each.

use calyx_contact::problem::Certificate;
use calyx_model::observed::{Observed, OutputRequest};
use calyx_model::position::Position;
use serde::{Deserialize, Serialize};

/// A solved position, as reported.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct StepRow {
    /// Where it was solved.
    pub position: Position,
    /// One per output.
    pub outputs: Vec<Observed>,
    /// What should be known about the position, in sentences.
    pub warnings: Vec<String>,
}

impl StepRow {
    /// The row of a position from the values of all observables of the scene.
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

/// A solved position and how well it was solved: what a later run needs of it to go on behind it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Solved {
    /// As reported.
    pub row: StepRow,
    /// How well it is solved.
    pub certificate: Certificate,
    /// Of a step in time: the state of its coordinates, from which the next one goes on; empty in equilibrium.
    pub state: Vec<f64>,
}
