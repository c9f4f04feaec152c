//! Sensitivities of a run with what is needed to show them.

use crate::results::Results;
use calyx_report::sensitivity::SensitivityTable;
use calyx_report::sweep::{Column, Statistics};

impl Results {
    /// Returns the derivatives that the model requests with `gears.sensitivity`; `None` without
    /// any.
    pub fn model_sensitivities(&self) -> Option<SensitivityTable> {
        let is_requested = self.are_derivatives_of_model() && !self.sensitivities().is_empty();
        is_requested.then(|| self.sensitivity_table(self.differentiated().to_vec()))
    }

    /// Returns the requested derivatives in the units of the model. `shown` are the indices of the
    /// outputs to show.
    pub fn sensitivity_table(&self, shown: Vec<usize>) -> SensitivityTable {
        let description = self.description();
        let sensitivities = self.sensitivities().to_vec();
        let params = sensitivities.iter().map(|own| Column::from(&description.params[own.param.index]));
        SensitivityTable {
            model: description.name.clone(),
            doc: description.doc.clone(),
            params: params.collect(),
            outputs: description.outputs.iter().map(Column::from).collect(),
            shown,
            statistics: self.summaries().iter().map(Statistics::of).collect(),
            positions: self.rows().iter().map(|row| row.position.clone()).collect(),
            sensitivities,
        }
    }
}
