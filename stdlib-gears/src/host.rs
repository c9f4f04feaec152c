//! State of the library for a running model: all gears, racks and materials that the program has
//! created, and the scene.

use crate::basic_rack::StatedRack;
use crate::bearing_sizes::BearingSpace;
use crate::blank::Rim;
use crate::carriers::ModelCarrier;
use crate::deviation::Deviation;
use crate::elastic_bodies::{AttachedPart, ModelElasticBody};
use crate::error::{GeometryError, Refusal, Severity};
use crate::externs::entry;
use crate::files::ModelFile;
use crate::lubrication_externs::StatedLubrication;
use crate::lumped_planetary::{LumpedMember, Mode};
use crate::mesh_geometry::MeshGeometry;
use crate::modification::Modification;
use crate::power_flow::PowerFlow;
use crate::prototype::GearPrototype;
use crate::shafts::ModelShaft;
use crate::shaper::Shaper;
use crate::tables::Table;
use crate::tabulated::prototype::TabulatedGear;
use calyx_abi::description::{ModelDescription, ParamDescription};
use calyx_abi::externs::Handle;
use calyx_abi::{RuntimeError, SymbolicValue};
use calyx_runtime::analyses::Analysis;
use calyx_runtime::analysis::{AnalysisOptions, Observer, Position};
use calyx_runtime::bearing::Support;
use calyx_runtime::dynamics::TimeRange;
use calyx_runtime::elastic::import::GmshPart;
use calyx_runtime::error::{EngineError, Subject};
use calyx_runtime::estimate::Estimates;
use calyx_runtime::load::Load;
use calyx_runtime::material::Material;
use calyx_runtime::observables::Gauge;
use calyx_runtime::radiated_sound::FieldRequest;
use calyx_runtime::results::{AnalysisResult, OutputRequest};
use calyx_runtime::scene::{BodyId, Fidelity, Prototype, Scene, StructureOptions};
use calyx_runtime::sensitivity::SensitivityRequest;
use calyx_runtime::settings_override::Override;
use calyx_runtime::shaft::ShaftSegment;
use calyx_runtime::signal::{Signal, SignalRequest};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

/// Unit of lengths in diagnostics.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LengthUnit {
    /// Name in diagnostics.
    pub name: &'static str,
    /// Size in metres.
    pub metres: f64,
}

impl LengthUnit {
    /// Millimetres, or inches for models whose results are printed in inches.
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

/// Gear of a model: the entry behind a handle of the type `Gear`.
#[derive(Clone)]
pub enum GearModel {
    /// Cylindrical gear, cut by a rack or a shaper cutter.
    Cylindrical(Arc<GearPrototype>),
    /// Gear whose teeth are given by tables of points.
    Tabulated(Arc<TabulatedGear>),
}

impl GearModel {
    /// Returns the gear as a prototype of bodies.
    pub fn prototype(&self) -> Arc<dyn Prototype> {
        match self {
            GearModel::Cylindrical(gear) => gear.clone(),
            GearModel::Tabulated(gear) => gear.clone(),
        }
    }

    /// Returns the gear if it is cylindrical.
    pub fn cylindrical(&self) -> Option<&Arc<GearPrototype>> {
        match self {
            GearModel::Cylindrical(gear) => Some(gear),
            GearModel::Tabulated(_) => None,
        }
    }

    /// Returns the axial position at which the gear is joined to a shaft, relative to its origin,
    /// m: the middle of the face, or of the bore.
    pub(crate) fn mid_bore(&self) -> f64 {
        match self {
            GearModel::Cylindrical(_) => 0.0,
            GearModel::Tabulated(gear) => gear.mid_bore(),
        }
    }

    /// Returns the number of teeth.
    pub fn teeth(&self) -> u32 {
        match self {
            GearModel::Cylindrical(gear) => gear.gear.teeth(),
            GearModel::Tabulated(gear) => gear.teeth(),
        }
    }

    /// Returns the ratio of the height of the teeth to the face width.
    pub(crate) fn depth_ratio(&self) -> f64 {
        match self {
            GearModel::Cylindrical(gear) => {
                let form = gear.gear.form();
                (form.tip_radius - form.root_radius).abs() / gear.face_width
            }
            GearModel::Tabulated(gear) => gear.tooth_height() / gear.face_width(),
        }
    }

    /// Returns the material.
    pub fn material(&self) -> Material {
        match self {
            GearModel::Cylindrical(gear) => gear.material,
            GearModel::Tabulated(gear) => gear.data.material,
        }
    }
}

/// Error for data that only cylindrical gears have.
fn only_cylindrical(argument: &str, what: String) -> RuntimeError {
    RuntimeError::new(
        "E0976",
        format!("{what} has tabulated teeth, which have no such data"),
        "ask this of a gear from `external` or `internal`",
    )
    .of_argument(argument)
}

/// Inputs that the host program provides, by the names under which the model requests them.
#[derive(Clone, Default)]
pub struct Provided {
    /// Loads for `gears.body(..., host_load = "name")`.
    pub loads: BTreeMap<String, Arc<dyn Load>>,
    /// Deviations for `gears.host_modification("name")`.
    pub modifications: BTreeMap<String, Deviation>,
}

/// State behind a model's handles.
#[derive(Default)]
pub struct ModelHost {
    /// Inputs that the host program provides.
    pub provided: Provided,
    /// Unit of lengths in diagnostics.
    pub length_unit: LengthUnit,
    /// Materials, by handle like all tables here.
    pub materials: Vec<Material>,
    /// Names of the materials that have one, by their handles.
    pub material_names: BTreeMap<u64, &'static str>,
    /// Racks.
    pub racks: Vec<StatedRack>,
    /// Shaper cutters.
    pub shapers: Vec<Shaper>,
    /// Rims.
    pub rims: Vec<Rim>,
    /// Modifications of flanks.
    pub modifications: Vec<Modification>,
    /// Segments of shafts.
    pub shaft_segments: Vec<ShaftSegment>,
    /// Shafts.
    pub shafts: Vec<ModelShaft>,
    /// Elastic bodies of any shape.
    pub elastic_bodies: Vec<ModelElasticBody>,
    /// Planet carriers.
    pub carriers: Vec<ModelCarrier>,
    /// Materials of physical groups of meshes.
    pub mesh_parts: Vec<GmshPart>,
    /// Parts of elastic bodies to which attachments refer.
    pub regions: Vec<AttachedPart>,
    /// Field meshes for sound pressures.
    pub sound_fields: Vec<FieldRequest>,
    /// Gears.
    pub gears: Vec<GearModel>,
    /// Source locations of the calls that created each gear.
    pub gear_places: Vec<(u32, u32, u32)>,
    /// Gear of each body of the scene, in order; `None` for a body without teeth.
    pub body_gears: Vec<Option<usize>>,
    /// For each body, the expression of its frame.
    pub body_frames: Vec<Arc<SymbolicValue>>,
    /// Source locations of the calls that created each body.
    pub body_places: Vec<(u32, u32, u32)>,
    /// Bodies whose load the host program provides, or may provide.
    pub host_loaded: BTreeSet<usize>,
    /// Source locations of the calls that created each bearing.
    pub bearing_places: Vec<(u32, u32, u32)>,
    /// Spaces that rolling bearings take.
    pub bearing_spaces: Vec<BearingSpace>,
    /// Load ratings C and C0 that catalogues state, by the indices of the bearings, N.
    pub bearing_ratings: BTreeMap<usize, [f64; 2]>,
    /// Source locations of the calls that created each output.
    pub output_places: Vec<(u32, u32, u32)>,
    /// Source location of the call that requested the forced response.
    pub forced_response_place: Option<(u32, u32, u32)>,
    /// Source locations of the calls that requested each sound, its points and its field meshes.
    pub sound_places: BTreeMap<Subject, (u32, u32, u32)>,
    /// Requested gear meshes, including rejected ones.
    pub mesh_records: Vec<MeshRecord>,
    /// Angular backlash of the second gear of meshes on general axes, rad, by surface pair.
    pub general_backlash: BTreeMap<usize, f64>,
    /// Files that have been read.
    pub files: Vec<ModelFile>,
    /// Tables that have been read.
    pub tables: Vec<Table>,
    /// Lists of positions to analyse.
    pub positions: Vec<Vec<Position>>,
    /// Ranges of time.
    pub time_ranges: Vec<TimeRange>,
    /// Lists of positions within ranges of time, by their handle: the start of the ranges (s), and
    /// the ranges.
    pub histories: BTreeMap<u64, (f64, Vec<TimeRange>)>,
    /// Lubrications of meshes.
    pub lubrications: Vec<StatedLubrication>,
    /// Power flow of gear trains, for the report.
    pub power_flows: Vec<PowerFlow>,
    /// Strain gauges.
    pub gauges: Vec<Gauge>,
    /// Bodies of lumped-parameter models.
    pub lumped_members: Vec<LumpedMember>,
    /// Modes of free vibration, one list per system.
    pub modes: Vec<Vec<Mode>>,
    /// Bodies, surface pairs and observables.
    pub scene: Scene,
    /// Requested outputs.
    pub outputs: Vec<OutputRequest>,
    /// Requested signals: outputs in the frequency domain.
    pub asked_signals: Vec<RequestedSignal>,
    /// Results of these requests, after the analysis.
    pub signals: Vec<Signal>,
    /// Requested derivatives.
    pub requested_sensitivities: Vec<RequestedSensitivity>,
    /// The model at other values of its params, and all params with respect to which outputs can be
    /// differentiated; `None` if the model is only checked.
    pub differentiable: Option<SensitivityRequest>,
    /// Params of the model.
    pub params: Vec<ParamDescription>,
    /// Findings in addition to the one that stopped the model, if any.
    pub findings: Vec<Finding>,
    /// Observer of the analysis, if any.
    pub observer: Option<Box<dyn Observer + Send>>,
    /// Options of an analysis, except those that the program sets.
    pub analysis: AnalysisOptions,
    /// Settings that override those of the program.
    pub overrides: Override,
    /// True if the model is only checked: it requests an analysis, which is not run.
    pub checking: bool,
    /// Model of the scene that the program requests, if it has requested an analysis.
    pub asked: Option<AnalysisRequest>,
    /// That analysis, while the model is checked.
    pub requested: Option<Arc<dyn Analysis>>,
    /// Result of the last analysis.
    pub result: Option<AnalysisResult>,
    /// Number of analyses that ended with an error, which the program may have caught.
    pub failed_analyses: usize,
    /// Path of the instance of a component that is being built; empty outside of components.
    pub instance: String,
    /// Innermost active call of a library function by the program.
    pub library_call: Option<(u32, u32, u32)>,
}

impl ModelHost {
    /// Creates the state of a model with these params and this unit system.
    pub fn new(model: &ModelDescription) -> ModelHost {
        ModelHost {
            length_unit: LengthUnit::of_system(&model.units),
            params: model.params.clone(),
            ..ModelHost::default()
        }
    }

    /// Returns the gear of the body that is given as an argument.
    ///
    /// # Errors
    /// E0659: it carries no gear. E0976: the teeth of its gear are given by tables.
    pub(crate) fn gear_on(&self, argument: &str, body: BodyId) -> Result<&Arc<GearPrototype>, RuntimeError> {
        self.gear_model_on(argument, body)?.cylindrical().ok_or_else(|| {
            let name = self.scene.bodies.get(body.0).map_or("", |body| &body.name);
            only_cylindrical(argument, format!("the gear of \"{name}\""))
        })
    }

    /// Returns the gear, of any kind, of the body that is given as an argument.
    ///
    /// # Errors
    /// E0659: it carries no gear.
    pub(crate) fn gear_model_on(&self, argument: &str, body: BodyId) -> Result<&GearModel, RuntimeError> {
        let gear = self.body_gears.get(body.0).copied().flatten();
        gear.and_then(|gear| self.gears.get(gear)).ok_or_else(|| {
            let name = self.scene.bodies.get(body.0).map_or("", |body| &body.name);
            RuntimeError::new(
                "E0659",
                format!("\"{name}\" carries no gear"),
                "ask this of a body that `gears.body` made with a gear",
            )
            .of_argument(argument)
        })
    }

    /// Returns the cylindrical gear that is given as an argument.
    ///
    /// # Errors
    /// E0976: its teeth are given by tables.
    pub(crate) fn cylindrical(
        &self,
        argument: &str,
        gear: Handle,
    ) -> Result<&Arc<GearPrototype>, RuntimeError> {
        let gear = entry(&self.gears, gear)?;
        gear.cylindrical().ok_or_else(|| only_cylindrical(argument, "this gear".into()))
    }

    /// Converts an error of the engine, located at the call that created the object in question.
    pub fn engine_error(&self, error: EngineError) -> RuntimeError {
        let error = self.about_attachment(error);
        let analysis = || self.asked.map(|asked| asked.place);
        self.in_instance(RuntimeError {
            argument: error.argument.map(str::to_owned),
            place: error.subject.and_then(|subject| self.place_of(subject)).or_else(analysis),
            ..RuntimeError::new(error.code, error.message, error.help)
        })
    }

    /// Replaces the remedy of an error about a free body that is an attachment of an elastic body:
    /// such a body has no argument `free`.
    fn about_attachment(&self, error: EngineError) -> EngineError {
        let Some(Subject::Body(body)) = error.subject else { return error };
        if !matches!(error.code, "E0714" | "E0715") {
            return error;
        }
        let body = BodyId(body);
        let Some(elastic) = self.elastic_bodies.iter().find(|elastic| elastic.attached.contains(&body))
        else {
            return error;
        };
        let fixed = |body: &BodyId| self.scene.bodies.get(body.0).is_some_and(|body| body.free == [false; 6]);
        let on_ground = |body: &BodyId| {
            let bearings = self.scene.bearings.iter();
            bearings.filter(|bearing| bearing.to == Support::Ground).any(|bearing| bearing.body == *body)
        };
        let has_feet = elastic.attached.iter().any(|body| fixed(body) || on_ground(body));
        let is_grounded = self.is_grounded(&elastic.attached);
        // A body without feet moves as a whole, in all degrees of freedom of its attachments.
        let message = match has_feet || is_grounded {
            true => error.message.clone(),
            false => format!(
                "the elastic body \"{}\" has no feet: none of its attachments is fixed or mounted on ground",
                elastic.name
            ),
        };
        let own = if is_grounded { "the supports of its file do not resist this motion; " } else { "" };
        let help = format!(
            "{own}support the elastic body \"{}\" in this direction: attach its feet with `fixed = TRUE`, or mount them on ground by bearings with stiffness in all directions at several points",
            elastic.name
        );
        EngineError { message, help, argument: None, ..error }
    }

    /// Returns whether the elastic body of these attachments has supports of its own.
    fn is_grounded(&self, attached: &[BodyId]) -> bool {
        let mut connections = attached.iter().flat_map(|&body| self.scene.connections_of(body));
        connections.any(|connection| connection.body.as_ref().is_some_and(|body| body.0.is_grounded()))
    }

    /// Records the instance of a component that is being built, and the call of the library.
    fn in_instance(&self, mut error: RuntimeError) -> RuntimeError {
        error.details.instance.clone_from(&self.instance);
        error.details.library_call = self.library_call;
        error
    }

    /// Returns the source location of the call that created an object of the scene.
    fn place_of(&self, subject: Subject) -> Option<(u32, u32, u32)> {
        let place = match subject {
            Subject::Body(body) => self.body_places.get(body),
            Subject::Prototype(body) => match self.body_gears.get(body) {
                Some(Some(gear)) => self.gear_places.get(*gear),
                _ => self.body_places.get(body),
            },
            Subject::Bearing(bearing) => self.bearing_places.get(bearing),
            Subject::Output(output) => self.output_places.get(output),
            Subject::ForcedResponse => self.forced_response_place.as_ref(),
            Subject::Sound(_) | Subject::SoundPoint(..) | Subject::SoundField(..) => {
                self.sound_places.get(&subject)
            }
        };
        place.copied()
    }

    /// Reports a name for which the host program provides nothing.
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
        let error = self.in_instance(RuntimeError { place: Some(place), ..error.of_argument(argument) });
        let finding = Finding { severity: Severity::Warning, error };
        if !self.findings.contains(&finding) {
            self.findings.push(finding);
        }
    }

    /// Reports a warning of a module in Calyx, once.
    pub(crate) fn warn(&mut self, code: &str, message: String, help: &str, place: (u32, u32, u32)) {
        let error = RuntimeError { place: Some(place), ..RuntimeError::new(code, message, help) };
        let finding = Finding { severity: Severity::Warning, error: self.in_instance(error) };
        if !self.findings.contains(&finding) {
            self.findings.push(finding);
        }
    }

    /// Reports a warning about an argument of a call, once.
    pub(crate) fn warn_of_argument(
        &mut self,
        (code, argument): (&str, &str),
        message: String,
        help: &str,
        place: (u32, u32, u32),
    ) {
        let error = RuntimeError::new(code, message, help).of_argument(argument);
        let error = self.in_instance(RuntimeError { place: Some(place), ..error });
        let finding = Finding { severity: Severity::Warning, error };
        if !self.findings.contains(&finding) {
            self.findings.push(finding);
        }
    }

    /// Converts a refusal to a diagnostic. The first of several findings stops the model; the
    /// others are stored.
    pub(crate) fn rejected(&mut self, refusal: Refusal, place: (u32, u32, u32)) -> RuntimeError {
        match refusal {
            Refusal::Engine(error) => {
                let argument = error.argument.map(str::to_owned);
                RuntimeError { argument, ..RuntimeError::new(error.code, error.message, error.help) }
            }
            Refusal::Geometry(errors) => self.refuse(&errors, place),
        }
    }

    /// Converts a finding about a gear or a pair to a diagnostic at the call that created its
    /// subject, or at the call in `place`.
    pub(crate) fn runtime_error(&self, error: &GeometryError, place: (u32, u32, u32)) -> RuntimeError {
        let LengthUnit { name, metres } = self.length_unit;
        let [message, help] =
            [&error.message, &error.help].map(|text| text.in_unit(name, metres).to_string());
        let reported = RuntimeError::new(error.code, message, help).of_argument(error.argument);
        let place = error.subject.and_then(|subject| self.place_of(subject)).unwrap_or(place);
        self.in_instance(RuntimeError { place: Some(place), ..reported })
    }

    /// Stores findings that do not stop the model.
    pub(crate) fn note(&mut self, errors: &[GeometryError], place: (u32, u32, u32)) {
        for error in errors {
            let finding = Finding { severity: error.severity, error: self.runtime_error(error, place) };
            // Both flanks of a tooth often cause the same finding.
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

/// Requested signal with the location of its call.
#[derive(Clone, Debug, PartialEq)]
pub struct RequestedSignal {
    /// The request.
    pub request: SignalRequest,
    /// Source location of the call.
    pub place: (u32, u32, u32),
}

/// Requested derivative of an output with respect to a param, with the location of its call.
#[derive(Clone, Debug, PartialEq)]
pub struct RequestedSensitivity {
    /// Name of the output.
    pub output: String,
    /// Name of the param.
    pub param: String,
    /// Source location of the call.
    pub place: (u32, u32, u32),
}

/// Requested analysis: its model of the bodies and its settings.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AnalysisRequest {
    /// Fidelity level.
    pub fidelity: Fidelity,
    /// Discretization of the structures.
    pub structure: StructureOptions,
    /// True if the analysis includes inertia and damping.
    pub in_time: bool,
    /// Number of contact problems solved in sequence: positions, or time steps.
    pub problems: usize,
    /// Highest natural frequency of the modes of bodies, Hz.
    pub highest_frequency: f64,
    /// Requested error estimates.
    pub estimates: Estimates,
    /// Tolerance of the tolerance search, if requested.
    pub tolerance: Option<f64>,
    /// Source location of the call.
    pub place: (u32, u32, u32),
}

/// Two bodies whose gears mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshRecord {
    /// Indices in the scene.
    pub bodies: [usize; 2],
    /// Geometry of the mesh.
    pub geometry: MeshGeometry,
    /// Source location of the call.
    pub place: (u32, u32, u32),
}

/// Finding with the source location of the call and the argument to blame.
#[derive(Clone, Debug, PartialEq)]
pub struct Finding {
    /// Severity, which decides whether it stops the model.
    pub severity: Severity,
    /// The finding and its location.
    pub error: RuntimeError,
}

/// Stores an object in its table and returns its handle.
pub fn keep<T>(table: &mut Vec<T>, thing: T) -> Handle {
    table.push(thing);
    Handle((table.len() - 1) as u64)
}

/// Formats a length in the model's unit.
pub(crate) fn shown(metres: f64, LengthUnit { name, metres: unit }: LengthUnit) -> String {
    let value = (metres / unit * 1e6).round() / 1e6;
    // No negative zero.
    format!("{} {name}", value + 0.0)
}
