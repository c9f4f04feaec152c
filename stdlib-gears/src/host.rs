//! What the library keeps for a running model: every gear, rack and material the program made, and the scene.

use crate::blank::Rim;
use crate::deviation::Deviation;
use crate::error::{GeometryError, Refusal, Severity};
use crate::lumped_planetary::{LumpedMember, Mode};
use crate::mesh_geometry::MeshGeometry;
use crate::modification::Modification;
use crate::prototype::GearPrototype;
use crate::rack::Rack;
use crate::shaper::Shaper;
use crate::tables::Table;
use calyx_abi::RuntimeError;
use calyx_abi::externs::Handle;
use calyx_runtime::analysis::{AnalysisOptions, Observer, Position};
use calyx_runtime::dynamics::{DynamicOptions, TimeRange};
use calyx_runtime::error::{EngineError, Subject};
use calyx_runtime::estimate::Estimates;
use calyx_runtime::load::Load;
use calyx_runtime::material::Material;
use calyx_runtime::observables::Gauge;
use calyx_runtime::results::{AnalysisResult, OutputRequest};
use calyx_runtime::scene::{BodyId, Fidelity, Scene, StructureOptions};
use calyx_runtime::settings_override::Override;
use calyx_runtime::signal::{Signal, SignalRequest};
use calyx_runtime::validate::Method;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

/// The unit in which messages to the model's author give lengths.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LengthUnit {
    /// As messages write it.
    pub name: &'static str,
    /// Its size.
    pub metres: f64,
}

impl LengthUnit {
    /// Millimetres, but for models that results print in inches.
    pub fn of_system(system: &str) -> LengthUnit {
        match system {
            "inch_lbf_s" => LengthUnit { name: "inch", metres: 0.0254 },
            _ => LengthUnit::default(),
        }
    }
}

impl Default for LengthUnit {
    fn default() -> Self {
        LengthUnit { name: "mm", metres: 1e-3 }
    }
}

/// What the program that runs a model provides, by the names the model asks for it.
#[derive(Clone, Default)]
pub struct Provided {
    /// For `gears.body(..., host_load = "name")`.
    pub loads: BTreeMap<String, Arc<dyn Load>>,
    /// For `gears.host_modification("name")`.
    pub modifications: BTreeMap<String, Deviation>,
}

/// The state behind a model's handles.
#[derive(Default)]
pub struct ModelHost {
    /// What the program around the model provides.
    pub provided: Provided,
    /// For messages.
    pub length_unit: LengthUnit,
    /// By handle, like all tables here.
    pub materials: Vec<Material>,
    /// Racks.
    pub racks: Vec<Rack>,
    /// Shapers.
    pub shapers: Vec<Shaper>,
    /// Rims.
    pub rims: Vec<Rim>,
    /// Modifications of flanks.
    pub modifications: Vec<Modification>,
    /// Gears.
    pub gears: Vec<Arc<GearPrototype>>,
    /// Places of the calls that made each gear.
    pub gear_places: Vec<(u32, u32, u32)>,
    /// The gear of each body of the scene, in order; `None` of a body without teeth.
    pub body_gears: Vec<Option<usize>>,
    /// Places of the calls that made each body.
    pub body_places: Vec<(u32, u32, u32)>,
    /// Bodies whose load the program around the model provides, or may.
    pub host_loaded: BTreeSet<usize>,
    /// Places of the calls that made each bearing.
    pub bearing_places: Vec<(u32, u32, u32)>,
    /// Places of the calls that made each output.
    pub output_places: Vec<(u32, u32, u32)>,
    /// Pairs of gears that were to mesh, those refused among them.
    pub mesh_records: Vec<MeshRecord>,
    /// Tables that were read.
    pub tables: Vec<Table>,
    /// Lists of positions to analyse.
    pub positions: Vec<Vec<Position>>,
    /// Ranges of time.
    pub time_ranges: Vec<TimeRange>,
    /// Of those positions that stand in ranges of time, by their handle: when these begin (s), and which they are.
    pub histories: BTreeMap<u64, (f64, Vec<TimeRange>)>,
    /// Strain gauges.
    pub gauges: Vec<Gauge>,
    /// Bodies of lumped models.
    pub lumped_members: Vec<LumpedMember>,
    /// Free vibrations, a list for each system.
    pub modes: Vec<Vec<Mode>>,
    /// Bodies, pairs and observables.
    pub scene: Scene,
    /// What the model wants to know.
    pub outputs: Vec<OutputRequest>,
    /// What it wants to know of outputs in the frequency domain.
    pub asked_signals: Vec<RequestedSignal>,
    /// The answers, once the analysis is done.
    pub signals: Vec<Signal>,
    /// Findings beside the one that stopped the model, if any did.
    pub findings: Vec<Finding>,
    /// Watches the analysis; without one it runs unobserved.
    pub observer: Option<Box<dyn Observer + Send>>,
    /// How an analysis is done, but for what the program says of it.
    pub analysis: AnalysisOptions,
    /// What counts more than what the program says of it.
    pub overrides: Override,
    /// The model is checked: an analysis is asked for, and not done.
    pub checking: bool,
    /// How the program wants the scene to be modelled, if it has asked for an analysis.
    pub asked: Option<AnalysisRequest>,
    /// Positions or ranges of time of that analysis, while the model is checked.
    pub requested: Option<AnalysisKind>,
    /// What the last analysis yielded.
    pub result: Option<AnalysisResult>,
    /// Analyses that ended with an error, which the program may have caught.
    pub failed_analyses: usize,
}

impl ModelHost {
    /// The state of a model whose results print in this unit system.
    pub fn new(system: &str) -> ModelHost {
        ModelHost { length_unit: LengthUnit::of_system(system), ..ModelHost::default() }
    }

    /// The gear that a body carries which is given as an argument.
    ///
    /// # Errors
    /// E0659: it carries none.
    pub(crate) fn gear_on(&self, argument: &str, body: BodyId) -> Result<&Arc<GearPrototype>, RuntimeError> {
        let gear = self.body_gears.get(body.0).copied().flatten();
        gear.and_then(|gear| self.gears.get(gear)).ok_or_else(|| {
            let name = self.scene.bodies.get(body.0).map_or("", |body| &body.name);
            RuntimeError::new(
                "E0659",
                format!("\"{name}\" is a rigid body, and carries no gear"),
                "ask this of a body that `gears.body` made with a gear",
            )
            .of_argument(argument)
        })
    }

    /// A failure of the engine, placed at the call that made what it is about.
    pub fn engine_error(&self, error: EngineError) -> RuntimeError {
        let place = match error.subject {
            Some(Subject::Body(body)) => self.body_places.get(body),
            Some(Subject::Prototype(body)) => match self.body_gears.get(body) {
                Some(Some(gear)) => self.gear_places.get(*gear),
                _ => self.body_places.get(body),
            },
            Some(Subject::Bearing(bearing)) => self.bearing_places.get(bearing),
            Some(Subject::Output(output)) => self.output_places.get(output),
            None => None,
        };
        let analysis = || self.asked.map(|asked| asked.place);
        RuntimeError {
            argument: error.argument.map(str::to_owned),
            place: place.copied().or_else(analysis),
            ..RuntimeError::new(error.code, error.message, error.help)
        }
    }

    /// Tells the model's author that something was asked for by a name of which the program around the model provides nothing.
    pub(crate) fn note_unprovided(
        &mut self,
        argument: &str,
        what: &str,
        instead: &str,
        name: &str,
        place: (u32, u32, u32),
    ) {
        let error = RuntimeError::new(
            "E0681",
            format!("nobody provides a {what} called \"{name}\", so {instead}"),
            "it comes from a Rust program that embeds the model; `calyx run`, `calyx check` and executables know none",
        );
        let error = RuntimeError { place: Some(place), ..error.of_argument(argument) };
        let finding = Finding { severity: Severity::Warning, error };
        if !self.findings.contains(&finding) {
            self.findings.push(finding);
        }
    }

    /// A refusal in words for the model's author; of several findings the first stops the model, the others are kept.
    pub(crate) fn rejected(&mut self, refusal: Refusal, place: (u32, u32, u32)) -> RuntimeError {
        match refusal {
            Refusal::Engine(error) => {
                let argument = error.argument.map(str::to_owned);
                RuntimeError { argument, ..RuntimeError::new(error.code, error.message, error.help) }
            }
            Refusal::Geometry(errors) => self.refuse(&errors, place),
        }
    }

    /// A finding about a gear or a pair in words for the model's author, who finds it at the call in `place`.
    pub(crate) fn runtime_error(&self, error: &GeometryError, place: (u32, u32, u32)) -> RuntimeError {
        let LengthUnit { name, metres } = self.length_unit;
        let [message, help] =
            [&error.message, &error.help].map(|text| text.in_unit(name, metres).to_string());
        let told = RuntimeError::new(error.code, message, help).of_argument(error.argument);
        RuntimeError { place: Some(place), ..told }
    }

    /// Keeps findings that do not stop the model.
    pub(crate) fn note(&mut self, errors: &[GeometryError], place: (u32, u32, u32)) {
        for error in errors {
            let finding = Finding { severity: error.severity, error: self.runtime_error(error, place) };
            // Both flanks of a tooth often have the same to say.
            if !self.findings.contains(&finding) {
                self.findings.push(finding);
            }
        }
    }

    fn refuse(&mut self, errors: &[GeometryError], place: (u32, u32, u32)) -> RuntimeError {
        let Some((first, others)) = errors.split_first() else {
            return RuntimeError::new(
                "E0799",
                "a gear was refused without a reason",
                "this is a defect of Calyx; please report it with the model",
            );
        };
        others
            .iter()
            .filter(|other| *other != first)
            .for_each(|other| self.note(std::slice::from_ref(other), place));
        self.runtime_error(first, place)
    }
}

/// A request for a signal, with the place of its call.
#[derive(Clone, Debug, PartialEq)]
pub struct RequestedSignal {
    /// What is asked.
    pub request: SignalRequest,
    /// Place of the call.
    pub place: (u32, u32, u32),
}

/// How an analysis models bodies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AnalysisRequest {
    /// By kind.
    pub fidelity: Fidelity,
    /// How finely.
    pub structure: StructureOptions,
    /// Whether with inertia and damping.
    pub in_time: bool,
    /// Contact problems that it solves one after the other: positions, or steps in time.
    pub problems: usize,
    /// Natural frequency up to which bodies have modes, Hz.
    pub highest_frequency: f64,
    /// Which errors it estimates.
    pub estimates: Estimates,
    /// The tolerance that the setting is searched for, if it is.
    pub tolerance: Option<f64>,
    /// Place of the call.
    pub place: (u32, u32, u32),
}

/// Method of an analysis, with its positions or ranges of time.
#[derive(Clone, Debug, PartialEq)]
pub enum AnalysisKind {
    /// Equilibrium at these positions.
    QuasiStatic(Vec<Position>),
    /// Motion in time.
    Dynamic(DynamicOptions),
}

impl AnalysisKind {
    /// The same as the engine takes it.
    pub fn method(&self) -> Method<'_> {
        match self {
            AnalysisKind::QuasiStatic(positions) => Method::QuasiStatic(positions),
            AnalysisKind::Dynamic(dynamics) => Method::Dynamic(dynamics),
        }
    }
}

/// Two bodies whose gears meet.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshRecord {
    /// Indices in the scene.
    pub bodies: [usize; 2],
    /// How the gears touch.
    pub geometry: MeshGeometry,
    /// Place of the call.
    pub place: (u32, u32, u32),
}

/// Something an engineer should know, with the place of the call it arose in and the argument to blame.
#[derive(Clone, Debug, PartialEq)]
pub struct Finding {
    /// Whether it stopped the model.
    pub severity: Severity,
    /// What was found, and where.
    pub error: RuntimeError,
}

/// Puts a thing into its table and hands out its handle.
pub fn keep<T>(table: &mut Vec<T>, thing: T) -> Handle {
    table.push(thing);
    Handle((table.len() - 1) as u64)
}
