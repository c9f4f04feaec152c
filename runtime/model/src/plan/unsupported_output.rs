//! Outputs that require more than a fidelity level provides.

use crate::fidelity::{Fidelity, Needs};
use crate::observed::OutputRequest;
use crate::target::Examined;
use calyx_numerics::error::{EngineError, Subject};

/// Largest number of outputs that one error names in addition to the first.
const NAMED: usize = 5;

/// Output without a value at the chosen fidelity.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnsupportedOutput {
    /// Index of the output.
    pub output: usize,
    /// Name in results.
    pub name: String,
    /// Requirements of the output.
    pub needs: Needs,
}

impl UnsupportedOutput {
    /// Returns the error that reports this output.
    pub fn error(&self, fidelity: Fidelity) -> EngineError {
        self.error_with(&[], fidelity)
    }

    /// Returns the error that reports this output together with others of the same requirements.
    pub fn error_with(&self, others: &[&UnsupportedOutput], fidelity: Fidelity) -> EngineError {
        let first = &self.name;
        let (outputs, needs, help) = match others {
            [] => (format!("output `{first}` has"), "it needs", "leave the output out"),
            _ => {
                let mut outputs = format!("outputs `{first}`");
                for (index, other) in others.iter().take(NAMED).enumerate() {
                    let is_last = index + 1 == others.len();
                    outputs.push_str(if is_last { " and `" } else { ", `" });
                    outputs.push_str(&other.name);
                    outputs.push('`');
                }
                if others.len() > NAMED {
                    outputs.push_str(&format!(" and {} more", others.len() - NAMED));
                }
                outputs.push_str(" have");
                (outputs, "they need", "leave the outputs out")
            }
        };
        let (needed, fidelity) = (self.needs.name(), fidelity.name());
        EngineError::new(
            "E0780",
            format!("{outputs} no value: {needs} {needed}, which the fidelity \"{fidelity}\" does not have"),
            help,
        )
        .about(Subject::Output(self.output))
    }

    /// Returns those of the outputs that require more than a fidelity provides.
    pub fn of(scene: &dyn Examined, outputs: &[OutputRequest], fidelity: Fidelity) -> Vec<UnsupportedOutput> {
        let targets = scene.targets();
        let needs = |observable: usize| targets.get(observable).map(|target| target.needs);
        let refused = |(output, request): (usize, &OutputRequest)| {
            let needs = request.value.observes().into_iter().filter_map(needs).max()?;
            let name = request.name.clone();
            (needs > fidelity.supports()).then_some(UnsupportedOutput { output, name, needs })
        };
        outputs.iter().enumerate().filter_map(refused).collect()
    }
}
