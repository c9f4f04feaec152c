//! The model at other values of its params, for its derivatives.

use super::{Instance, Job, Setup};
use crate::error::Error;
use crate::names::ParamName;
use crate::param_assignment::AssignedValue;
use crate::params::{self, Setting};
use crate::watcher::interrupt;
use calyx_abi::description::ParamDescription;
use calyx_abi::error::codes;
use calyx_abi::limits::Limits;
use calyx_abi::{Cancel, Context, RuntimeError, Status, stack};
use calyx_gears::calculation;
use calyx_gears::host::ModelHost;
use calyx_runtime::error::EngineError;
use calyx_runtime::results::{OutputRequest, Solved};
use calyx_runtime::sensitivity::{
    Neighbour, Neighbours, Sensitivity, SensitivityRequest, SensitivityStore, VariedParam, of_calculation,
};
use std::sync::Arc;

/// No params, for [`Instance::request_sensitivities`].
#[cfg(feature = "command")]
pub(crate) const NO_PARAMS: [&str; 0] = [];

impl Instance {
    /// Requests the derivatives of all outputs with respect to params as part of the results of a
    /// quasi-static analysis, in place of those that the model requests with `gears.sensitivity`.
    ///
    /// # Errors
    /// There is no such param, or it takes no decimal numbers.
    pub fn request_sensitivities<P: ParamName>(
        &mut self,
        params: impl IntoIterator<Item = P>,
    ) -> Result<(), Error> {
        let mut requested = Vec::new();
        for param in params {
            let index = param.index_in(self.names())?;
            let param = &self.description().params[index];
            if !param.is_continuous() {
                return Err(Error::given(
                    format!("`{}` takes no decimal numbers, so no derivatives exist", param.name),
                    differentiable(&self.description().params),
                ));
            }
            requested.push(index);
        }
        self.setup.sensitivities = Some(requested);
        Ok(())
    }

    /// Limits the derivatives that [`Instance::request_sensitivities`] requests to the outputs of
    /// some names, which takes less time; those of others may be NaN. The name of an array stands
    /// for all its elements. Without names, all outputs are differentiated.
    ///
    /// # Errors
    /// There is no such output. Which elements an array has is known after the run only.
    pub fn limit_sensitivities<S: Into<String>>(
        &mut self,
        outputs: impl IntoIterator<Item = S>,
    ) -> Result<(), Error> {
        let outputs: Vec<String> = outputs.into_iter().map(Into::into).collect();
        let declared = &self.description().declared_outputs;
        let array = |name: &str| name.split('[').next().unwrap_or_default().to_owned();
        let is_array =
            |name: &str| declared.iter().any(|output| output.is_array && output.name == array(name));
        let others = outputs.iter().filter(|name| !is_array(name));
        others.map(|name| self.output(name.as_str())).try_for_each(|found| found.map(drop))?;
        self.setup.differentiated_outputs = outputs;
        Ok(())
    }

    /// Stores derivatives of an analysis as soon as they are found, and takes those that are
    /// already stored. The store must belong to the values and settings of this instance.
    pub fn store_sensitivities(&mut self, store: Arc<dyn SensitivityStore>) {
        self.setup.sensitivity_store = Some(store);
    }
}

fn differentiable(params: &[ParamDescription]) -> String {
    let names: Vec<&str> =
        params.iter().filter(|param| param.is_continuous()).map(|param| param.name.as_str()).collect();
    match names.as_slice() {
        [] => "the model has no params with decimal numbers".to_owned(),
        names => format!("choose among {}", names.join(", ")),
    }
}

/// The model with the settings of a run, except for one param.
struct ModelNeighbours {
    setup: Setup,
    limits: Limits,
    cancel: Cancel,
}

impl Job {
    /// Provides the requested derivatives, or all params for the requests of the model. The context
    /// has the values of the params.
    pub(super) fn provide_sensitivities(&self, context: &mut Context) -> Result<(), Error> {
        let program = self.setup.program.clone();
        let params = &program.description().params;
        let indices = match &self.setup.sensitivities {
            Some(requested) => requested.clone(),
            None => (0..params.len()).filter(|&index| params[index].is_continuous()).collect(),
        };
        if indices.is_empty() {
            return Ok(());
        }
        let mut varied = Vec::new();
        for index in indices {
            let (low, high) = params::range(program.as_ref(), index, &params[index], context)?;
            let range = [low.unwrap_or(f64::NEG_INFINITY), high.unwrap_or(f64::INFINITY)];
            let (name, value) = (params[index].name.clone(), context.params[index]);
            varied.push(VariedParam { index, name, value, range });
        }
        let (setup, limits, cancel) = (self.setup.clone(), self.limits, self.cancel.clone());
        let neighbours = Arc::new(ModelNeighbours { setup, limits, cancel });
        let outputs = self.setup.differentiated_outputs.clone();
        let store = self.setup.sensitivity_store.clone();
        let request = Some(SensitivityRequest { neighbours, params: varied, outputs, store });
        if let Some(host) = context.host::<ModelHost>() {
            match self.setup.sensitivities {
                Some(_) => host.analysis.sensitivities = request,
                None => host.differentiable = request,
            }
        }
        Ok(())
    }
}

impl Neighbours for ModelNeighbours {
    fn at(&self, param: usize, value: f64) -> Result<Neighbour, EngineError> {
        let job = self.job(param, value)?;
        stack::with_stack(|| job.neighbour()).map_err(|error| converted(&error.into()))?
    }
}

impl ModelNeighbours {
    fn job(&self, param: usize, value: f64) -> Result<Job, EngineError> {
        let mut setup = self.setup.clone();
        let description = setup.program.description();
        let setting = Setting::new(description, param, &AssignedValue::Si(value), None);
        setup.settings[param] = Some(setting.map_err(|error| converted(&error))?);
        Ok(Job { setup, limits: self.limits, cancel: self.cancel.clone() })
    }
}

impl Job {
    /// Differentiates the outputs of a model without an analysis.
    pub(super) fn differentiated(
        self,
        request: &SensitivityRequest,
        (solved, outputs): (&Solved, &[OutputRequest]),
    ) -> Result<Vec<Sensitivity>, Error> {
        let (limits, cancel) = (self.limits, self.cancel.clone());
        let neighbours = ModelNeighbours { setup: self.setup, limits, cancel: cancel.clone() };
        let at = |param: usize, value: f64| {
            let job = neighbours.job(param, value)?;
            let (mut context, built) = job.built();
            built.map_err(|error| converted(&error))?;
            let host = context.host::<ModelHost>().ok_or_else(no_analysis)?;
            host.checking = false;
            Ok(calculation::values(host))
        };
        let requested = request.differentiated(outputs);
        let interrupt = interrupt(cancel, limits);
        let found =
            of_calculation(&request.params, (&solved.row.outputs, &requested), at, || interrupt.check());
        found.map_err(|error| RuntimeError::new(error.code, error.message, error.help).into())
    }

    fn neighbour(&self) -> Result<Neighbour, EngineError> {
        let (mut context, built) = self.built();
        built.map_err(|error| converted(&error))?;
        let Some(host) = context.host::<ModelHost>() else { return Err(no_analysis()) };
        let positions = host.requested.take().and_then(|analysis| analysis.positions().map(<[_]>::to_vec));
        let Some(positions) = positions else { return Err(no_analysis()) };
        let (scene, outputs) = (std::mem::take(&mut host.scene), std::mem::take(&mut host.outputs));
        Ok(Neighbour { scene, positions, outputs })
    }
}

fn no_analysis() -> EngineError {
    EngineError::new("E0792", "the model requests no quasi-static analysis", "")
}

/// Converts an error of the program to one of the engine.
fn converted(error: &Error) -> EngineError {
    match error {
        Error::Model(error) if error.status() == Status::Cancelled => {
            EngineError::new(codes::CANCELLED, error.message.clone(), "")
        }
        Error::Model(RuntimeError { message, help, .. }) => {
            EngineError::new("E0792", message.clone(), help.clone())
        }
        Error::Given(invalid) => EngineError::new("E0792", invalid.message.clone(), invalid.help.clone()),
    }
}
