//! A model instance: a program with values of its params, which can be run repeatedly.

mod neighbours;

#[cfg(feature = "command")]
pub(crate) use neighbours::NO_PARAMS;

use crate::adapted::AdaptedProgram;
use crate::engine::Engine;
use crate::error::Error;
use crate::host::{Host, ResolvedHost};
use crate::names::{Names, Output, Param, ParamName, shape};
use crate::nan_log::NanLog;
use crate::param_assignment::{AssignedValue, ParamAssignment};
use crate::params::{self, Setting};
use crate::program::Program;
use crate::results::Results;
use crate::stepping::{Run, Steps};
use crate::watcher::{Watcher, interrupt};
#[cfg(feature = "command")]
use calyx_abi::description::FileDescription;
use calyx_abi::description::{ModelDescription, ParamValue};
use calyx_abi::limits::Limits;
use calyx_abi::{Cancel, Context, Status, stack};
use calyx_gears::calculation;
#[cfg(feature = "command")]
use calyx_gears::files::ModelFile;
use calyx_gears::host::ModelHost;
use calyx_gears::sensitivity_externs;
use calyx_runtime::analysis::Event;
use calyx_runtime::error::EngineError;
use calyx_runtime::observables::Fields;
use calyx_runtime::results::Solved;
use calyx_runtime::sensitivity::SensitivityStore;
use calyx_runtime::settings_override::Override;
use calyx_runtime::tolerance::SearchProgress;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

/// Progress of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Progress {
    /// Current stage: `structures` or `positions`.
    pub stage: &'static str,
    /// Number of positions solved.
    pub done: usize,
    /// Number of positions to solve; unknown during the stage `structures`.
    pub total: Option<usize>,
}

pub(crate) type ProgressSink = Arc<Mutex<dyn FnMut(Progress) + Send>>;
pub(crate) type RecordSink =
    Arc<Mutex<dyn FnMut(usize, &Solved, Option<&Fields>) -> Result<(), EngineError> + Send>>;
pub(crate) type SearchProgressSink = Arc<Mutex<dyn FnMut(&SearchProgress) + Send>>;
type PrintSink = Arc<Mutex<dyn FnMut(&str) + Send>>;

/// A model with its own values of the params.
///
/// Creating an instance copies no code and computes nothing. A model may have any number of
/// instances, on any threads. Each run takes the values at its start; later changes do not affect
/// it.
pub struct Instance {
    setup: Setup,
    time_limit: Option<Duration>,
    memory_limit: Option<u64>,
    cancel: Cancel,
}

/// Inputs of a run. Each run has a copy.
#[derive(Clone)]
struct Setup {
    engine: Engine,
    program: Arc<dyn Program>,
    shape: u64,
    /// Settings by param index.
    settings: Vec<Option<Setting>>,
    /// Functions that the embedding program provides.
    host: ResolvedHost,
    print: Option<PrintSink>,
    progress: Option<ProgressSink>,
    record: Option<RecordSink>,
    choosing: Option<SearchProgressSink>,
    solved: Vec<Solved>,
    fields: usize,
    bodies: bool,
    parts: bool,
    component_loads: bool,
    /// Indices of the params with respect to which outputs are differentiated; `None`: those that
    /// the model requests.
    sensitivities: Option<Vec<usize>>,
    /// Names of the outputs whose derivatives the program requests; empty for all.
    differentiated_outputs: Vec<String>,
    /// Storage of derivatives.
    sensitivity_store: Option<Arc<dyn SensitivityStore>>,
    overrides: Override,
}

impl Instance {
    /// Creates an instance with all params at their defaults.
    pub fn new(engine: &Engine, program: Arc<dyn Program>) -> Instance {
        let description = program.description();
        let (shape, settings) = (shape(description), vec![None; description.params.len()]);
        let setup = Setup {
            engine: engine.clone(),
            program,
            shape,
            settings,
            host: ResolvedHost::default(),
            print: None,
            progress: None,
            record: None,
            choosing: None,
            solved: Vec::new(),
            fields: 0,
            bodies: false,
            parts: false,
            component_loads: false,
            sensitivities: None,
            differentiated_outputs: Vec::new(),
            sensitivity_store: None,
            overrides: Override::default(),
        };
        Instance { setup, time_limit: None, memory_limit: None, cancel: Cancel::default() }
    }

    pub fn engine(&self) -> &Engine {
        &self.setup.engine
    }

    /// Sets the engine of future runs.
    #[cfg(feature = "command")]
    pub(crate) fn set_engine(&mut self, engine: &Engine) {
        self.setup.engine = engine.clone();
    }

    /// Returns names, units, ranges and docs of the params and outputs.
    pub fn description(&self) -> &ModelDescription {
        self.setup.program.description()
    }

    /// Determines the outputs of the current params. If some outputs are arrays, this builds the
    /// model, without solving it. Otherwise each run does this.
    ///
    /// # Errors
    /// As for [`Instance::params`].
    #[cfg(feature = "command")]
    pub(crate) fn fix_outputs(&mut self) -> Result<(), Error> {
        let job = self.job();
        let program = stack::with_stack(|| job.described())??;
        self.setup.shape = shape(program.description());
        self.setup.program = program;
        Ok(())
    }

    /// Returns the program, with the outputs of the current params after
    /// [`Instance::fix_outputs`].
    #[cfg(feature = "command")]
    pub(crate) fn program(&self) -> &Arc<dyn Program> {
        &self.setup.program
    }

    fn names(&self) -> Names<'_> {
        Names { description: self.setup.program.description(), shape: self.setup.shape }
    }

    /// Returns the handle of a param.
    ///
    /// # Errors
    /// The model has no such param.
    pub fn param(&self, name: &str) -> Result<Param, Error> {
        Param::named(self.description(), name)
    }

    /// Returns the handle of an output.
    ///
    /// # Errors
    /// The model has no such output.
    pub fn output(&self, name: &str) -> Result<Output, Error> {
        Output::named(self.description(), name)
    }

    /// Sets a param to a number in the unit of its default, to a number with a unit, to a Boolean,
    /// or to a text as after `--set`.
    ///
    /// # Errors
    /// There is no such param, or it does not accept the value.
    pub fn set(&mut self, param: impl ParamName, value: impl Into<AssignedValue>) -> Result<(), Error> {
        let index = param.index_in(self.names())?;
        let setting = Setting::new(self.setup.program.description(), index, &value.into(), None)?;
        self.setup.settings[index] = Some(setting);
        Ok(())
    }

    /// Sets a param to a value from a command line or a file; errors report the location in the
    /// file.
    ///
    /// # Errors
    /// As for [`Instance::set`].
    pub fn give(&mut self, given: &ParamAssignment) -> Result<(), Error> {
        let (name, origin) = (given.name.as_str(), given.origin.as_ref());
        let index = name.index_in(self.names()).map_err(|error| error.placed(given.name_origin.as_ref()))?;
        let setting = Setting::new(self.setup.program.description(), index, &given.value, origin)?;
        self.setup.settings[index] = Some(setting);
        Ok(())
    }

    /// Sets a param to a number in the coherent SI unit.
    ///
    /// # Errors
    /// As for [`Instance::set`].
    pub fn set_si(&mut self, param: impl ParamName, si: f64) -> Result<(), Error> {
        self.set(param, AssignedValue::Si(si))
    }

    /// Resets a param to its default.
    ///
    /// # Errors
    /// There is no such param.
    pub fn reset(&mut self, param: impl ParamName) -> Result<(), Error> {
        let index = param.index_in(self.names())?;
        self.setup.settings[index] = None;
        Ok(())
    }

    /// Returns the value that a param would have in a run, in SI.
    ///
    /// # Errors
    /// There is no such param; or an error of [`Instance::params`], if the param is not set.
    pub fn get(&self, param: impl ParamName) -> Result<ParamValue, Error> {
        let index = param.index_in(self.names())?;
        let param = &self.description().params[index];
        match (&self.setup.settings[index], &param.default) {
            (Some(setting), _) => Ok(setting.value.clone()),
            (None, Some(default)) if param.independent => Ok(default.clone()),
            (None, _) => Ok(self.params()?.swap_remove(index)),
        }
    }

    /// Returns the values that all params would have in a run, in SI. Defaults may depend on other
    /// params, so this evaluates them.
    ///
    /// # Errors
    /// A set value is out of its param's range, or a default or range cannot be computed.
    pub fn params(&self) -> Result<Vec<ParamValue>, Error> {
        let mut context = self.job().context();
        params::resolve(self.setup.program.as_ref(), &self.setup.settings, &mut context)?;
        Ok(params::values(self.description(), &context))
    }

    /// Sets the functions of the embedding program that the model may call.
    ///
    /// # Errors
    /// The model declares no function of that name, or one with other arguments or another result.
    pub fn set_host(&mut self, host: &Host) -> Result<(), Error> {
        self.setup.host = host.fitted(self.description())?;
        Ok(())
    }

    /// Limits the duration of each run; unlimited by default.
    pub fn limit_time(&mut self, limit: Option<Duration>) {
        self.time_limit = limit;
    }

    /// Limits memory in bytes: of a run's own values, and of the whole process during the analysis;
    /// unlimited by default.
    pub fn limit_memory(&mut self, limit: Option<u64>) {
        self.memory_limit = limit;
    }

    /// Returns the handle that cancels every run of this instance, from any thread. It stays
    /// cancelled: to run the instance again, replace it with [`Instance::set_cancel`].
    pub fn cancel_handle(&self) -> Cancel {
        self.cancel.clone()
    }

    /// Sets the handle that cancels future runs. Several instances may share one.
    pub fn set_cancel(&mut self, cancel: Cancel) {
        self.cancel = cancel;
    }

    /// Sets the function that receives the lines that the model prints. Without it they are
    /// discarded.
    pub fn on_print(&mut self, sink: impl FnMut(&str) + Send + 'static) {
        self.setup.print = Some(Arc::new(Mutex::new(sink)));
    }

    /// Sets the function that receives the progress at the start of a stage and after each
    /// position, on the thread of the run.
    pub fn on_progress(&mut self, sink: impl FnMut(Progress) + Send + 'static) {
        self.setup.progress = Some(Arc::new(Mutex::new(sink)));
    }

    /// Sets the function that receives each setting before the tolerance search tries it. It is
    /// called on the thread of the run.
    pub fn on_choosing(&mut self, sink: impl FnMut(&SearchProgress) + Send + 'static) {
        self.setup.choosing = Some(Arc::new(Mutex::new(sink)));
    }

    /// Sets the function that receives each solved position with its index, its certificate and, if
    /// requested by [`Instance::request_fields`], its fields. It is called on the thread of the
    /// run. Unlike the iterator of [`Instance::run`], it blocks the run until it returns. An error
    /// from it ends the analysis.
    pub fn on_solved(
        &mut self,
        sink: impl FnMut(usize, &Solved, Option<&Fields>) -> Result<(), EngineError> + Send + 'static,
    ) {
        self.setup.record = Some(Arc::new(Mutex::new(sink)));
    }

    /// Sets the first positions as solved by an earlier run with the same values. Runs start after
    /// them; their results equal those of a run that solves all positions.
    pub fn resume_after(&mut self, solved: Vec<Solved>) {
        self.setup.solved = solved;
    }

    /// Former name of [`Instance::resume_after`].
    #[deprecated(since = "0.1.0", note = "use `resume_after`")]
    pub fn begin_after(&mut self, solved: Vec<Solved>) {
        self.resume_after(solved);
    }

    /// Requests the fields of at most this many positions for [`Instance::on_solved`], evenly
    /// spaced from the first one. Each takes a little time.
    pub fn request_fields(&mut self, positions: usize) {
        self.setup.fields = positions;
    }

    /// Former name of [`Instance::request_fields`].
    #[deprecated(since = "0.1.0", note = "use `request_fields`")]
    pub fn tell_fields(&mut self, positions: usize) {
        self.request_fields(positions);
    }

    /// Requests the meshes of elastic bodies with their displacements as part of the fields.
    pub fn request_bodies(&mut self, bodies: bool) {
        self.setup.bodies = bodies;
    }

    /// Requests the outer surfaces of all parts, their poses and the forces between them as part of
    /// the fields.
    pub fn request_parts(&mut self, parts: bool) {
        self.setup.parts = parts;
    }

    /// Former name of [`Instance::request_bodies`].
    #[deprecated(since = "0.1.0", note = "use `request_bodies`")]
    pub fn tell_bodies(&mut self, bodies: bool) {
        self.request_bodies(bodies);
    }

    /// Requests the loads of all meshes and bearings as part of the results of the analysis.
    pub fn request_component_loads(&mut self, requested: bool) {
        self.setup.component_loads = requested;
    }

    /// Sets the overrides of the model's analysis settings for future runs.
    pub fn override_analysis(&mut self, overrides: Override) {
        self.setup.overrides = overrides;
    }

    /// Returns the overrides of the model's analysis settings.
    #[cfg(feature = "command")]
    pub(crate) fn overrides(&self) -> &Override {
        &self.setup.overrides
    }

    /// Runs the model on its own thread, position by position: the next position starts when the
    /// iterator has returned the previous one.
    ///
    /// # Errors
    /// The thread cannot be created. The iterator returns errors of the model.
    pub fn run(&self) -> Result<Run, Error> {
        let job = self.job();
        Run::begin(job.cancel.clone(), |steps| stack::beside(move || job.execute(Some(steps))))
    }

    /// Runs the model to its end.
    ///
    /// # Errors
    /// A param is out of its range, the model or its analysis failed, the run was cancelled, or a
    /// limit was reached.
    pub fn solve(&self) -> Result<Results, Error> {
        let job = self.job();
        stack::with_stack(|| job.execute(None))?
    }

    /// Builds the model without solving it. Returns the files that it has read, and the error that
    /// ended it, if any.
    #[cfg(feature = "command")]
    pub(crate) fn build(&self) -> (Vec<FileDescription>, Option<Error>) {
        let job = self.job();
        stack::with_stack(|| job.build()).unwrap_or_else(|error| (Vec::new(), Some(error.into())))
    }

    fn job(&self) -> Job {
        Job {
            setup: self.setup.clone(),
            limits: Limits::from_now(self.time_limit, self.memory_limit),
            cancel: self.cancel.child(),
        }
    }
}

/// One run, independent of later changes of its instance.
struct Job {
    setup: Setup,
    limits: Limits,
    cancel: Cancel,
}

impl Job {
    fn context(&self) -> Context {
        let mut context = Context::new(Box::new(ModelHost::new(self.setup.program.description())));
        context.limits = self.limits;
        context.cancel = self.cancel.clone();
        let print = self.setup.print.clone();
        context.print = Box::new(move |line| {
            if let Some(print) = &print {
                print.lock().unwrap_or_else(PoisonError::into_inner)(line);
            }
        });
        self.setup.host.provide(&mut context);
        context
    }

    /// Returns the program with the outputs of the params. If some outputs are arrays, this builds
    /// the model, without solving it.
    fn described(&self) -> Result<Arc<dyn Program>, Error> {
        if self.setup.program.description().declared_outputs.is_empty() {
            return Ok(self.setup.program.clone());
        }
        let (mut context, built) = self.built();
        // The run reports other errors of the model.
        if let Err(error @ Error::Given(_)) = built {
            return Err(error);
        }
        let host = context.host::<ModelHost>();
        let names = host.iter().flat_map(|host| &host.outputs).map(|output| output.name.as_str());
        Ok(Arc::new(AdaptedProgram::with_outputs(self.setup.program.clone(), names)))
    }

    /// Builds the model, without solving or printing anything.
    fn built(&self) -> (Context, Result<(), Error>) {
        let mut context = self.context();
        context.print = Box::new(|_| {});
        context.kernels = self.setup.program.kernels();
        let resolved = params::resolve(self.setup.program.as_ref(), &self.setup.settings, &mut context);
        if let Some(host) = context.host::<ModelHost>() {
            (host.checking, host.overrides) = (true, self.setup.overrides);
        }
        let built = resolved.and_then(|()| self.setup.program.main(&mut context).map_err(Error::Model));
        (context, built)
    }

    /// Returns another run with the same values and limits.
    fn again(&self) -> Job {
        Job { setup: self.setup.clone(), limits: self.limits, cancel: self.cancel.clone() }
    }

    /// Returns the files that the model reads, and the error that ends it, if any.
    #[cfg(feature = "command")]
    fn build(&self) -> (Vec<FileDescription>, Option<Error>) {
        let (mut context, built) = self.built();
        let host = context.host::<ModelHost>();
        let files = host.into_iter().flat_map(|host| std::mem::take(&mut host.files));
        let file = |file: ModelFile| FileDescription { name: file.name, text: file.text.to_string() };
        (files.map(file).collect(), built.err())
    }

    /// Runs the program and sends its positions to `hand_over`.
    fn execute(mut self, hand_over: Option<Steps>) -> Result<Results, Error> {
        self.setup.program = self.described()?;
        self.setup.shape = shape(self.setup.program.description());
        let seen = NanLog::new(self.cancel.clone(), self.limits);
        let (program, settings) = (self.setup.program.clone(), self.setup.settings.clone());
        self.watched(hand_over, &seen).map_err(|error| match error {
            Error::Model(mut error) => {
                let params = program.description().params.iter().zip(settings);
                let given: Vec<ParamAssignment> = params
                    .filter_map(|(param, setting)| Some(ParamAssignment::value(&param.name, setting?.value)))
                    .collect();
                program.explain(&mut error, &given, &seen);
                Error::Model(error)
            }
            given => given,
        })
    }

    fn watched(self, hand_over: Option<Steps>, seen: &NanLog) -> Result<Results, Error> {
        let mut context = self.context();
        context.kernels = seen.watched(self.setup.program.kernels());
        params::resolve(self.setup.program.as_ref(), &self.setup.settings, &mut context)?;
        let params = params::values(self.setup.program.description(), &context);
        self.provide_sensitivities(&mut context)?;
        let again = self.again();
        if let Some(host) = context.host::<ModelHost>() {
            host.observer = Some(Box::new(Watcher {
                program: self.setup.program.clone(),
                shape: self.setup.shape,
                hand_over,
                progress: self.setup.progress,
                record: self.setup.record,
                choosing: self.setup.choosing,
            }));
            let interrupt = interrupt(self.cancel, self.limits);
            host.analysis.resources = self.setup.engine.resources(interrupt)?;
            host.analysis.solved = self.setup.solved;
            host.analysis.fields = self.setup.fields;
            host.analysis.bodies = self.setup.bodies;
            host.analysis.parts = self.setup.parts;
            host.analysis.component_loads = self.setup.component_loads;
            host.overrides = self.setup.overrides;
        }
        let started = Instant::now();
        let outcome = self.setup.program.main(&mut context);
        // An interrupt that ends the tolerance search also stops the program, but the results are
        // available.
        let ended = |host: &mut ModelHost| host.result.as_ref()?.tolerance_search.as_ref()?.ended.clone();
        if let Err(error) = outcome {
            let searched = context.host::<ModelHost>().and_then(ended).is_some();
            if error.status() != Status::Cancelled || !searched {
                return Err(error.into());
            }
        }
        let calculated = calculate(&mut context)?;
        let requested = context
            .host::<ModelHost>()
            .and_then(|host| Some((sensitivity_externs::requested(host)?, host.outputs.clone())));
        let derivatives = match (&calculated, requested) {
            (Some(solved), Some((requested, outputs))) => {
                again.differentiated(&requested, (solved, &outputs))?
            }
            _ => Vec::new(),
        };
        let time = started.elapsed();
        let calculated = calculated.map(|solved| (solved, derivatives));
        Ok(Results::of(self.setup.program, self.setup.shape, params, &mut context, (calculated, time)))
    }
}

/// Computes the outputs of a model without an analysis, and passes them on as its only position.
fn calculate(context: &mut Context) -> Result<Option<Solved>, Error> {
    let Some(host) = context.host::<ModelHost>().filter(|host| host.result.is_none()) else {
        return Ok(None);
    };
    host.instance.clear();
    host.library_call = None;
    let calculated = calculation::calculate(host)?;
    if let (Some(solved), Some(mut observer)) = (&calculated, host.observer.take()) {
        let event = Event::Step { index: 0, count: 1, solved, fields: None };
        observer.observe(event).map_err(|error| host.engine_error(error))?;
    }
    Ok(calculated)
}
