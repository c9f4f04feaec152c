//! Journal of derivatives: one line of JSON per param, written as soon as its derivatives are
//! found.
//!
//! An interrupted run, or one that requests further params, does not compute them again. A journal
//! of another model, other values or settings is replaced.

use crate::error::Error;
use crate::instance::Instance;
use crate::run_directory::RunDirectory;
use crate::sweep::journal::Journal;
use calyx_report::directory::head;
use calyx_report::journal::ExactNumber;
use calyx_runtime::sensitivity::{Derivative, Kind, Sensitivity, SensitivityStore, VariedParam};
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};
use std::io;
use std::sync::{Arc, Mutex, PoisonError};

/// File name of the journal.
pub const SENSITIVITY_JOURNAL: &str = "sensitivities.jsonl";
/// Version of the line format; a journal of another format is replaced.
const FORMAT: u32 = 1;

/// Journal of derivatives in a directory of results.
pub struct SensitivityJournal {
    directory: Arc<RunDirectory>,
    /// First line: what the derivatives belong to.
    subject: Value,
    /// The journal and its lines once it is opened, which the first access does: a new run removes
    /// the files of an earlier one first.
    opened: Mutex<Option<(Journal, Vec<Line>)>>,
}

/// Line of a param.
#[derive(Clone, Serialize, Deserialize)]
struct Line {
    param: String,
    value: ExactNumber,
    width: ExactNumber,
    /// True if the param changes structures.
    new_structures: bool,
    /// Numbers of [`Derivative::to_array`] by position and output.
    positions: Vec<Vec<Numbers>>,
    means: Vec<Numbers>,
}

type Numbers = [ExactNumber; 6];

impl SensitivityJournal {
    /// Creates the journal of a run, whose subject is `head` (see
    /// [`calyx_report::directory::head`]). `outputs` are the names of the differentiated outputs.
    pub fn new(directory: Arc<RunDirectory>, head: &Value, outputs: &[String]) -> SensitivityJournal {
        let subject = json!({ "sensitivities": FORMAT, "run": head, "of": outputs });
        SensitivityJournal { directory, subject, opened: Mutex::new(None) }
    }

    /// Creates the journal of an instance with all its values and settings.
    ///
    /// # Errors
    /// As for [`Instance::params`].
    pub fn of_instance(
        instance: &Instance,
        directory: Arc<RunDirectory>,
        outputs: &[String],
    ) -> Result<SensitivityJournal, Error> {
        let head = head(instance.description(), &instance.params()?, instance.overrides());
        Ok(SensitivityJournal::new(directory, &head, outputs))
    }

    /// Returns the number of params whose stored derivatives belong to another model, or to other
    /// values, settings or outputs, and are replaced.
    pub fn replaced(&self) -> usize {
        Journal::replaced(&self.directory.path().join(SENSITIVITY_JOURNAL), &self.subject)
    }

    /// Calls a function with the opened journal.
    fn with<T>(&self, call: impl FnOnce(&Journal, &[Line]) -> io::Result<T>) -> io::Result<T> {
        let mut opened = self.opened.lock().unwrap_or_else(PoisonError::into_inner);
        let (journal, lines) = match opened.take() {
            Some(opened) => opened,
            None => Journal::open(&self.directory.claim(SENSITIVITY_JOURNAL)?, &self.subject)?,
        };
        let (journal, lines) = opened.insert((journal, lines));
        call(journal, lines)
    }
}

impl SensitivityStore for SensitivityJournal {
    fn find(&self, param: &VariedParam) -> Option<Sensitivity> {
        let is_same =
            |line: &&Line| line.param == param.name && line.value.0.to_bits() == param.value.to_bits();
        // A journal that cannot be opened is reported when derivatives are stored.
        let line = self.with(|_, lines| Ok(lines.iter().rfind(is_same).cloned())).ok()??;
        Some(line.sensitivity(param))
    }

    fn store(&self, found: &Sensitivity) -> io::Result<()> {
        self.with(|journal, _| journal.write(&Line::of(found)))
    }
}

impl Line {
    fn of(found: &Sensitivity) -> Line {
        let numbers = |derivative: &Derivative| derivative.to_array().map(ExactNumber);
        Line {
            param: found.param.name.clone(),
            value: ExactNumber(found.param.value),
            width: ExactNumber(found.width),
            new_structures: found.kind == Kind::ChangedStructures,
            positions: found.positions.iter().map(|row| row.iter().map(numbers).collect()).collect(),
            means: found.means.iter().map(numbers).collect(),
        }
    }

    fn sensitivity(self, param: &VariedParam) -> Sensitivity {
        let derivative = |numbers: Numbers| Derivative::from_array(numbers.map(|ExactNumber(number)| number));
        let derivatives = |row: Vec<Numbers>| row.into_iter().map(derivative).collect();
        Sensitivity {
            param: param.clone(),
            width: self.width.0,
            kind: if self.new_structures { Kind::ChangedStructures } else { Kind::SameStructures },
            positions: self.positions.into_iter().map(derivatives).collect(),
            means: derivatives(self.means),
            statistics: Vec::new(),
            failure: None,
        }
    }
}
