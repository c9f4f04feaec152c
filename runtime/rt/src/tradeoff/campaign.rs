//! The settings of a model run one after the other, each in a directory of its own: what is finished is kept, what was ended goes on.
//!
//! Times are those of a first analysis: structures are condensed here, and none is taken from where the user keeps them. Settings that differ
//! in grids or positions alone share the structures of their mesh, and with them the time to condense these.

use super::measurement::Measurement;
use super::settings::Setting;
use crate::directory::head;
use crate::engine::{Engine, EngineConfig};
use crate::error::Error;
use crate::instance::Instance;
use crate::param_assignment::ParamAssignment;
use crate::program::Program;
use crate::progress::ProgressFormat;
use crate::resume::{self, EarlierRun};
use crate::run::{RunError, RunOptions, run};
use calyx_abi::{Cancel, Status};
use calyx_runtime::cache::Store;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Structures of one mesh at a time are kept, however large they are.
const KEPT: u64 = 1 << 40;

/// A model whose settings are run.
pub struct Campaign {
    pub program: Arc<dyn Program>,
    /// Values given for params.
    pub given: Vec<ParamAssignment>,
    /// Where everything goes.
    pub directory: PathBuf,
    /// Threads of each analysis; 0 is one per core.
    pub threads: usize,
    /// Ends the setting under way and all that follow.
    pub cancel: Cancel,
}

/// What became of a setting.
pub enum Outcome {
    Measured(Box<Measurement>),
    /// It cannot be analysed so; why, in one line.
    Refused(String),
    /// Somebody ended it; the same campaign goes on there.
    Ended,
}

impl Campaign {
    /// The run directory of a setting.
    pub fn runs(&self, setting: &Setting) -> PathBuf {
        self.directory.join("runs").join(setting.folder())
    }

    fn store(&self) -> Store {
        Store::new(self.directory.join("structures"), KEPT)
    }

    /// Runs a setting, unless an earlier run has done it. `known` are settings measured before, whose structures it may share.
    ///
    /// # Errors
    /// What was given is refused, or a directory cannot be written.
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
            // The time to condense them is to be measured, and those of other meshes are not needed any more.
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
        // It was ended when all positions were solved and their time was not written: that is known of a run as a whole only.
        let again = RunOptions { resume: false, ..options };
        run(self.program.clone(), &again)?;
        Ok(match self.read(setting, predicted, &directory, sharing)? {
            Some(measured) => Outcome::Measured(Box::new(measured)),
            None => Outcome::Refused("the model analyses nothing".into()),
        })
    }

    /// What of the setting an earlier run has done; nothing of a run with another model, other params or by another version.
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

    /// Removes what only running needs.
    ///
    /// # Errors
    /// It is there and cannot be removed.
    pub fn tidy(&self) -> io::Result<()> {
        self.store().clear()
    }
}
