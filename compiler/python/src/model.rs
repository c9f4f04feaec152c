//! Compiled models.

use crate::describe::{Units, model_json};
use crate::engines::engine;
use crate::errors::{self, Problem, rendered};
use crate::host;
use crate::results::Results;
use crate::running::{Callbacks, Cancel, solve};
use crate::values;
use calyx::rt::Instance;
use calyx::rt::directory::Details;
use calyx::{Module, Override, TargetCpu, allowed_path, check_file_allowing, check_text};
use calyx_runtime::observables::Fields;
use calyx_runtime::results::Solved;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use std::path::PathBuf;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

/// Values of params by name.
type Assignments<'py> = Vec<(String, Bound<'py, PyAny>)>;

/// Compiled model; immutable.
#[pyclass(frozen, module = "calyx._calyx", name = "Model")]
pub struct Model {
    module: Module,
    /// Stages that preceded runs, for `timing.json`.
    before: Vec<(&'static str, Duration)>,
}

/// Options of a run.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
struct Options<'py> {
    /// Names and texts of overridden analysis settings.
    overrides: Vec<(String, String)>,
    /// Number of threads; 0 is the configured number.
    threads: usize,
    /// Seconds.
    time_limit: Option<f64>,
    /// Bytes.
    memory_limit: Option<u64>,
    /// 0: no fields; 1: contacts, fillets and outer surfaces; 2: meshes of elastic bodies as well.
    fields: u8,
    progress: Option<Bound<'py, PyAny>>,
    print: Option<Bound<'py, PyAny>>,
    cancel: Option<Py<Cancel>>,
    /// Functions that replace host functions of the model.
    host: host::Functions<'py>,
    /// Params with respect to which the outputs are differentiated.
    sensitivities: Vec<String>,
    /// Names of the outputs to differentiate; empty for all.
    sensitivities_of: Vec<String>,
}

#[pymethods]
impl Model {
    /// Compiles the model in a file, which may read the files and directories `allowed` outside of
    /// its folder.
    #[staticmethod]
    fn of_file(py: Python<'_>, path: PathBuf, allowed: Vec<String>) -> PyResult<Model> {
        let found: Result<Vec<PathBuf>, _> = allowed.iter().map(|path| allowed_path(path)).collect();
        let allowed: Arc<[PathBuf]> =
            found.map_err(|error| Problem::new(&error, "").raised(py, "ParamError"))?.into();
        let started = Instant::now();
        let compiled = py.detach(|| {
            let checked = check_file_allowing(&path, &allowed)?;
            let checked_after = started.elapsed();
            Ok((Module::from_checked(&engine(0), checked), checked_after))
        });
        let (compiled, check) =
            compiled.map_err(|error: std::io::Error| errors::unreadable(&path.display(), &error))?;
        let module = compiled.map_err(|error| errors::of_compilation(py, error))?;
        Ok(Model { module, before: vec![("check", check), ("compile", started.elapsed() - check)] })
    }

    /// Compiles a model given as text, which can import the library only.
    #[staticmethod]
    fn of_text(py: Python<'_>, name: &str, text: &str) -> PyResult<Model> {
        let started = Instant::now();
        let (compiled, check) = py.detach(|| {
            let checked = check_text(name, text);
            let check = started.elapsed();
            (Module::from_checked(&engine(0), checked), check)
        });
        let module = compiled.map_err(|error| errors::of_compilation(py, error))?;
        Ok(Model { module, before: vec![("check", check), ("compile", started.elapsed() - check)] })
    }

    /// Loads the bytes of `serialize` from a pickle, without compiling.
    #[staticmethod]
    fn deserialize(py: Python<'_>, bytes: &[u8]) -> PyResult<Model> {
        // SAFETY: the bytes come from a pickle, which can execute any code as well: the caller of
        // `pickle.loads` trusts its origin. Version, machine and checksum are compared.
        let read = py.detach(|| unsafe { Module::deserialize(&engine(0), bytes) });
        let module = read.map_err(|error| Problem::new(&error, error.help()).raised(py, "ModelError"))?;
        Ok(Model { module, before: Vec::new() })
    }

    /// Returns the compiled module for every processor of this architecture.
    fn serialize<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyBytes>> {
        let written = py.detach(|| self.module.serialize_for(TargetCpu::Baseline));
        written.map(|bytes| PyBytes::new(py, &bytes)).map_err(|error| errors::of_compilation(py, error))
    }

    /// Describes params and outputs as JSON.
    fn describe(&self) -> String {
        model_json(self.module.description()).to_string()
    }

    fn units(&self) -> Units {
        Units::new(self.module.description())
    }

    /// Returns the text of the model's own file.
    fn source(&self) -> &str {
        self.module.files().first().map_or("", |file| &file.text)
    }

    /// Returns the diagnostics of the check at the default params as text.
    fn diagnostics(&self) -> String {
        rendered(self.module.diagnostics(), &self.module)
    }

    /// Returns the values that all params have in a run, in the units of their defaults.
    fn values<'py>(
        &self,
        py: Python<'py>,
        params: Assignments<'py>,
    ) -> PyResult<Vec<(String, Bound<'py, PyAny>)>> {
        let instance = self.instance(py, params, 0)?;
        let values = py.detach(|| instance.params());
        let values = values.map_err(|error| errors::of_run(py, &self.module, &error))?;
        let described = self.module.description().params.iter().zip(&values);
        described
            .map(|(param, value)| Ok((param.name.clone(), values::shown(py, value, param.unit.factor)?)))
            .collect()
    }

    /// Runs the model to its end.
    fn run<'py>(
        &self,
        py: Python<'py>,
        params: Assignments<'py>,
        options: Options<'py>,
    ) -> PyResult<Results> {
        let mut instance = self.instance(py, params, options.threads)?;
        let provided = host::provide(&mut instance, options.host)?;
        provided.map_err(|error| errors::of_run(py, &self.module, &error))?;
        let overrides = overridden(py, &options.overrides)?;
        instance.override_analysis(overrides);
        instance.limit_time(options.time_limit.map(duration).transpose()?);
        instance.limit_memory(options.memory_limit);
        let cancel = options.cancel.map_or_else(calyx::Cancel::default, |above| above.get().0.child());
        instance.set_cancel(cancel.clone());
        let details = Details { tables: options.fields > 0, vtu: options.fields > 1, unv: false };
        if options.fields > 0 {
            instance.request_fields(details.positions());
            instance.request_parts(true);
            instance.request_bodies(details.vtu);
        }
        // Without names, the requests of the model remain.
        if !options.sensitivities.is_empty() {
            let requested = instance.request_sensitivities(&options.sensitivities);
            let requested = requested.and_then(|()| instance.limit_sensitivities(options.sensitivities_of));
            requested.map_err(|error| errors::of_run(py, &self.module, &error))?;
        }
        let positions = keep_positions(&mut instance);
        let callbacks = Callbacks { progress: options.progress, print: options.print };
        let solved = solve(py, instance, &cancel, &callbacks)?;
        let results = solved.map_err(|error| errors::of_run(py, &self.module, &error))?;
        let kept = std::mem::take(&mut *positions.lock().unwrap_or_else(PoisonError::into_inner));
        let findings = self.module.findings(results.findings());
        let before = self.before.clone();
        let findings = findings.iter().map(|finding| {
            let text = rendered(std::slice::from_ref(finding), &self.module);
            (finding.code.clone(), finding.message.clone(), text)
        });
        let findings = findings.collect();
        Ok(Results { results, positions: kept, overrides, details, before, findings })
    }
}

impl Model {
    fn instance(&self, py: Python<'_>, params: Assignments<'_>, threads: usize) -> PyResult<Instance> {
        let mut instance = Instance::new(&engine(threads), self.module.as_program());
        for (name, value) in params {
            let value = values::assigned(&value)?;
            instance.set(&name, value).map_err(|error| errors::of_run(py, &self.module, &error))?;
        }
        Ok(instance)
    }
}

/// Solved positions with their fields.
type Positions = Arc<Mutex<Vec<(Solved, Option<Fields>)>>>;

/// Keeps the solved positions of an instance in memory.
fn keep_positions(instance: &mut Instance) -> Positions {
    let positions = Positions::default();
    let kept = positions.clone();
    instance.on_solved(move |index, solved, fields| {
        let mut kept = kept.lock().unwrap_or_else(PoisonError::into_inner);
        // A model may continue after an analysis that failed, and start another.
        kept.truncate(index);
        kept.push((solved.clone(), fields.cloned()));
        Ok(())
    });
    positions
}

fn overridden(py: Python<'_>, settings: &[(String, String)]) -> PyResult<Override> {
    let mut overrides = Override::default();
    for (name, text) in settings {
        let set = overrides.set(name, text);
        set.map_err(|error| {
            let problem = Problem::new(&error.message, &error.help);
            Problem { code: error.code.to_string(), ..problem }.raised(py, "ParamError")
        })?;
    }
    Ok(overrides)
}

fn duration(seconds: f64) -> PyResult<Duration> {
    Duration::try_from_secs_f64(seconds).map_err(|_| {
        PyValueError::new_err(format!("time_limit is {seconds}: give a positive number of seconds"))
    })
}
