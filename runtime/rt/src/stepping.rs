//! Position-by-position runs.

use crate::error::Error;
use crate::names::{Names, OutputName};
use crate::program::Program;
use crate::results::Results;
use calyx_abi::description::{ModelDescription, OutputDescription, UnitDescription};
use calyx_abi::stack::LargeStackThread;
use calyx_abi::units::from_si;
use calyx_abi::{Cancel, RuntimeError, quantity};
use calyx_runtime::analysis::Position;
use calyx_runtime::results::{Location, Observed, StepRow};
use std::iter::FusedIterator;
use std::sync::Arc;
use std::sync::mpsc::{Receiver, SyncSender, sync_channel};

/// Sender of solved positions; it blocks until each is received.
pub(crate) type Steps = SyncSender<Step>;

/// A run in progress: an iterator over its positions.
///
/// The model runs on its own thread, which waits after each position until that is received.
/// Dropping the iterator ends the run and waits for the thread.
///
/// ```no_run
/// # fn show(instance: &calyx_rt::Instance) -> Result<(), calyx_rt::Error> {
/// let error = instance.output("transmission_error")?;
/// let mut run = instance.run()?;
/// for step in &mut run {
///     let step = step?;
///     println!("{} s: {}", step.position().time, step.value(error)?);
/// }
/// println!("{:?}", run.finish()?.summary(error)?);
/// # Ok(())
/// # }
/// ```
pub struct Run {
    /// Receiver; `None` after the last position.
    steps: Option<Receiver<Step>>,
    /// Thread of the run; `None` after its end.
    thread: Option<LargeStackThread<Result<Results, Error>>>,
    cancel: Cancel,
    ended: Option<Result<Results, Error>>,
}

impl Run {
    pub(crate) fn begin(
        cancel: Cancel,
        thread: impl FnOnce(Steps) -> Result<LargeStackThread<Result<Results, Error>>, RuntimeError>,
    ) -> Result<Run, Error> {
        let (sender, steps) = sync_channel(0);
        Ok(Run { steps: Some(steps), thread: Some(thread(sender)?), cancel, ended: None })
    }

    /// Returns the handle that cancels this run, from any thread; other runs of the instance
    /// continue.
    pub fn cancel_handle(&self) -> Cancel {
        self.cancel.clone()
    }

    /// Solves the remaining positions and returns the results of all.
    ///
    /// # Errors
    /// The error of the run, also if the iterator has already returned it.
    pub fn finish(mut self) -> Result<Results, Error> {
        while self.taken().is_some() {}
        self.ended.take().unwrap_or_else(|| Err(Error::given("the run has no results", "")))
    }

    /// Receives the next position; `None` if the run has ended.
    fn taken(&mut self) -> Option<Step> {
        let step = self.steps.as_ref()?.recv().ok();
        if step.is_none() {
            self.end();
        }
        step
    }

    fn end(&mut self) {
        self.steps = None;
        if let Some(thread) = self.thread.take() {
            self.ended = Some(thread.join().unwrap_or_else(|panicked| Err(panicked.into())));
        }
    }
}

impl Iterator for Run {
    type Item = Result<Step, Error>;

    /// Returns the next position. If the run fails, the iterator returns its error once and then
    /// ends.
    fn next(&mut self) -> Option<Result<Step, Error>> {
        self.steps.as_ref()?;
        match self.taken() {
            Some(step) => Some(Ok(step)),
            None => self.ended.as_ref()?.as_ref().err().cloned().map(Err),
        }
    }
}

impl FusedIterator for Run {}

impl Drop for Run {
    fn drop(&mut self) {
        if self.thread.is_some() {
            self.cancel.cancel();
            self.end();
        }
    }
}

/// A solved position. A view that is cheap to clone and may outlive the run.
#[derive(Clone)]
pub struct Step {
    pub(crate) program: Arc<dyn Program>,
    pub(crate) shape: u64,
    pub(crate) index: usize,
    pub(crate) count: usize,
    pub(crate) row: Arc<StepRow>,
}

impl Step {
    /// Returns the index, from 0 to [`Step::count`] - 1.
    pub fn index(&self) -> usize {
        self.index
    }

    /// Returns the number of positions of the analysis.
    pub fn count(&self) -> usize {
        self.count
    }

    /// Returns time (s), fraction of the mesh cycle, roll angle (rad), and name if it is a
    /// characteristic point.
    pub fn position(&self) -> &Position {
        &self.row.position
    }

    /// Returns an output in the unit in which the model shows it.
    ///
    /// # Errors
    /// The model has no such output.
    pub fn value(&self, output: impl OutputName) -> Result<f64, Error> {
        let index = self.output(output)?;
        let unit = self.description().outputs.get(index).map_or(1.0, |output| output.unit.factor);
        Ok(from_si(self.observed(index), unit))
    }

    /// Returns an output in the coherent SI unit.
    ///
    /// # Errors
    /// The model has no such output.
    pub fn si(&self, output: impl OutputName) -> Result<f64, Error> {
        Ok(self.observed(self.output(output)?))
    }

    /// Returns an output in the given unit, like `N*m`.
    ///
    /// # Errors
    /// The model has no such output, or it has another dimension.
    pub fn in_unit(&self, output: impl OutputName, unit: &str) -> Result<f64, Error> {
        let index = self.output(output)?;
        Ok(from_si(self.observed(index), factor(self.description(), index, unit)?))
    }

    /// Returns the location of an output that is a maximum over a body.
    ///
    /// # Errors
    /// The model has no such output.
    pub fn location(&self, output: impl OutputName) -> Result<Option<&Location>, Error> {
        let index = self.output(output)?;
        Ok(self.row.outputs.get(index).and_then(|observed| observed.location.as_ref()))
    }

    /// Former name of [`Step::location`].
    ///
    /// # Errors
    /// As [`Step::location`].
    #[deprecated(since = "0.1.0", note = "use `location`")]
    pub fn place(&self, output: impl OutputName) -> Result<Option<&Location>, Error> {
        self.location(output)
    }

    /// Returns all outputs, in order, in SI.
    pub fn outputs(&self) -> &[Observed] {
        &self.row.outputs
    }

    /// Returns the warnings about this position.
    pub fn warnings(&self) -> &[String] {
        &self.row.warnings
    }

    /// Returns all data of the position.
    pub fn row(&self) -> &StepRow {
        &self.row
    }

    fn description(&self) -> &ModelDescription {
        self.program.description()
    }

    fn output(&self, output: impl OutputName) -> Result<usize, Error> {
        output.index_in(Names { description: self.description(), shape: self.shape })
    }

    fn observed(&self, index: usize) -> f64 {
        self.row.outputs.get(index).map_or(f64::NAN, |observed| observed.value)
    }
}

/// Returns the SI value of a unit, if it has the dimension of the output.
pub(crate) fn factor(description: &ModelDescription, output: usize, unit: &str) -> Result<f64, Error> {
    let Some(OutputDescription { name, unit: shown, .. }) = description.outputs.get(output) else {
        return Ok(1.0);
    };
    let UnitDescription { name: own, dimension, .. } = shown;
    let refused = |why: String| {
        let own = if own.is_empty() { "a pure number".to_owned() } else { format!("shown in {own}") };
        Error::given(format!("`{name}` cannot be shown in `{unit}`: {why}"), format!("`{name}` is {own}"))
    };
    let quantity = quantity::with_unit(1.0, unit, &description.known_units).map_err(refused)?;
    if !quantity::fits(quantity.dimension, *dimension) {
        return Err(refused("that is another kind of quantity".into()));
    }
    Ok(quantity.value)
}
