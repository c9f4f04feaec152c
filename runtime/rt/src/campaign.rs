//! Runs the settings that a trade-off compares, one after the other, each in its own directory.
//! Finished runs are reused, interrupted ones resume.
//!
//! Times are those of a first analysis: structures are condensed here, without the user's structure
//! cache. Settings that differ only in contact grids or positions share the structures of their
//! mesh, and the time to condense them.

use crate::engine::{Engine, EngineConfig};
use crate::error::Error;
use crate::instance::Instance;
use crate::param_assignment::ParamAssignment;
use crate::program::Program;
use crate::progress::ProgressFormat;
use crate::resume::{self, EarlierRun};
use crate::run::{RunError, RunOptions, run};
use calyx_abi::{Cancel, Status};
use calyx_report::directory::head;
use calyx_report::tradeoff::{Measurement, Setting};
use calyx_runtime::cache::Store;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Limit of the structure cache in bytes: large enough for the structures of one mesh.
const KEPT: u64 = 1 << 40;

/// A model whose settings are run.
pub struct Campaign {
    pub program: Arc<dyn Program>,
    /// Values assigned to params.
    pub given: Vec<ParamAssignment>,
    /// Directory of the campaign.
    pub directory: PathBuf,
    /// Number of threads of each analysis; 0 is one per core.
    pub threads: usize,
    /// Cancels the current setting and all later ones.
    pub cancel: Cancel,
}

/// Outcome of a setting.
pub enum Outcome {
    Measured(Box<Measurement>),
    /// The setting is not supported; the reason in one line.
    Refused(String),
    /// The run was cancelled; the same campaign resumes there.
    Ended,
}

impl Campaign {
    /// Returns the run directory of a setting.
    pub fn runs(&self, setting: &Setting) -> PathBuf {
        self.directory.join("runs").join(setting.folder())
    }

    fn store(&self) -> Store {
        Store::new(self.directory.join("structures"), KEPT)
    }

    /// Runs a setting, unless an earlier run has finished it. `known` are settings measured before,
    /// whose structures it may share.
    ///
    /// # Errors
    /// An assigned value is invalid, or a directory cannot be written.
    pub fn run(
        &self,
        setting: &Setting,
        predicted: Option<f64>,
        known: &[Measurement],
    ) -> Result<Outcome, RunError> {
        let directory = self.runs(setting);
        let unwritable = |error| RunError::Io { path: directory.clone(), error };
        let shared =
            |measured: &&Measurement| measured.setting.mesh() == setting.mesh() && measured.built > 0;
        let sharing = known.iter().find(shared);
        let begun = self.begun(setting, &directory)?;
        if let EarlierRun::Finished = begun
            && let Some(measured) = self.read(setting, predicted, &directory, sharing)?
        {
            return Ok(Outcome::Measured(Box::new(measured)));
        }
        if sharing.is_none() {
            // The time to condense the structures is measured, and those of other meshes are not
            // needed any more.
            self.store().clear().map_err(unwritable)?;
        }
        let options = RunOptions {
            engine: Engine::new(EngineConfig {
                threads: self.threads,
                store: Some(self.store()),
                ..EngineConfig::default()
            }),
            directory: directory.clone(),
            given: self.given.clone(),
            // The time of a setting is that of its positions.
            without_derivatives: true,
            quiet: true,
            progress: ProgressFormat::Human,
            print_to_error: true,
            resume: matches!(begun, EarlierRun::Unfinished(_)),
            overrides: setting.overrides,
            cancel: self.cancel.clone(),
            ..RunOptions::default()
        };
        match run(self.program.clone(), &options) {
            Ok(_) => {}
            Err(RunError::Ended { .. }) => return Ok(Outcome::Ended),
            Err(RunError::Run(Error::Model(error))) if error.status() == Status::Cancelled => {
                return Ok(Outcome::Ended);
            }
            Err(RunError::Run(Error::Model(error))) => {
                return Ok(Outcome::Refused(format!("{}: {}", error.code, error.message)));
            }
            Err(error) => return Err(error),
        }
        if let Some(measured) = self.read(setting, predicted, &directory, sharing)? {
            return Ok(Outcome::Measured(Box::new(measured)));
        }
        // The run was ended after its last position, before its times were written. Times are known
        // for a complete run only.
        let again = RunOptions { resume: false, ..options };
        run(self.program.clone(), &again)?;
        Ok(match self.read(setting, predicted, &directory, sharing)? {
            Some(measured) => Outcome::Measured(Box::new(measured)),
            None => Outcome::Refused("the model analyses nothing".into()),
        })
    }

    /// Finds the state of an earlier run of the setting; nothing if that has another model, other
    /// params or another version.
    fn begun(&self, setting: &Setting, directory: &Path) -> Result<EarlierRun, RunError> {
        let mut instance = Instance::new(&Engine::default(), self.program.clone());
        for given in &self.given {
            instance.give(given).map_err(RunError::Run)?;
        }
        let params = instance.params().map_err(RunError::Run)?;
        match resume::find(directory, &head(self.program.description(), &params, &setting.overrides)) {
            Ok(begun) => Ok(begun),
            Err(resume::ResumeError::Other(_)) => Ok(EarlierRun::Nothing),
            Err(resume::ResumeError::Io(error)) => Err(RunError::Io { path: directory.to_owned(), error }),
        }
    }

    fn read(
        &self,
        setting: &Setting,
        predicted: Option<f64>,
        directory: &Path,
        sharing: Option<&Measurement>,
    ) -> Result<Option<Measurement>, RunError> {
        let read = Measurement::read(setting, predicted, directory);
        let mut measured = read.map_err(|error| RunError::Io { path: directory.to_owned(), error })?;
        if let (Some(measured), Some(sharing)) = (&mut measured, sharing)
            && measured.built == 0
        {
            measured.structures = sharing.structures;
            measured.memory = measured.memory.max(sharing.memory);
        }
        Ok(measured)
    }

    /// Removes the files that only running needs.
    ///
    /// # Errors
    /// A file exists and cannot be removed.
    pub fn tidy(&self) -> io::Result<()> {
        self.store().clear()
    }
}
