//! Library functions for programs: the Rust side of `gears.cx` and `prelude.cx`.

use crate::analyses::{self, Arguments};
use crate::assembly::{MeshOptions, Misalignment, Pairing};
use crate::bearing_externs::GROUND;
use crate::elastic_externs::has_no_motion;
use crate::error::Severity;
use crate::general_mesh::{general_mesh, is_general};
use crate::host::{AnalysisRequest, Finding, MeshRecord, ModelHost, keep};
use crate::load_plausibility::check_loads;
use crate::lubrication_externs::of_mesh;
use crate::plausibility::{of_material, pitch_line, unequal_planet_spacing};
use crate::raceway_checks::check_raceways;
use crate::shaft_externs::as_shaft;
use calyx_abi::externs::{Handle, SymbolicNumber};
use calyx_abi::{Context, RuntimeError};
use calyx_runtime::analyses::{Analysis, without_tolerance};
use calyx_runtime::analysis::{AnalysisOptions, Observer, Position, mesh_cycle};
use calyx_runtime::error::{EngineError, Subject};
use calyx_runtime::estimate::Estimates;
use calyx_runtime::interrupt::Interrupt;
use calyx_runtime::material::Material;
use calyx_runtime::method::QuasiStatic;
use calyx_runtime::motion::rotation_speed;
use calyx_runtime::plan::Plan;
use calyx_runtime::results::OutputRequest;
use calyx_runtime::scene::{Body, BodyId, DOF_NAMES, Fidelity, PairId, StructureOptions, Template};
use calyx_runtime::structure::BoreSupport;
use calyx_runtime::system::check_content;
use calyx_runtime::tolerance::{ToleranceOutcome, check_tolerance};
use calyx_runtime::validate::Request;
use std::borrow::Cow;
use std::sync::Arc;

calyx_abi::externs! {
    Pure fn calyx_gears_material(context, youngs_modulus: f64, poissons_ratio: f64, density: f64) -> Handle {
        let material = Material::new(youngs_modulus, poissons_ratio, density).map_err(engine)?;
        let (place, host) = (context.place, host(context)?);
        host.findings.extend(of_material(&material, place));
        Ok(keep(&mut host.materials, material))
    }

    Scene fn calyx_gears_mesh(
        context, first: Handle, second: Handle, tip_corner_contact: bool, contact_cells: Option<f64>,
        grid_width: Option<f64>, contact_slices: f64, friction: f64, misalignment: f64,
        misalignment_out_of_plane: f64, coast_side_contact: bool, lubrication: Option<Handle>,
        torque_on_first: Option<f64>,
    ) -> Handle {
        before_analysis(context, "the mesh")?;
        for (argument, count) in [("contact_cells", contact_cells), ("contact_slices", Some(contact_slices))] {
            if count.is_some_and(|count| count.fract() != 0.0 || count < 1.0) {
                return Err(refusal("E0672", argument, "the number of cells must be whole",
                    "a grid has twice as many cells plus one; 24 across are usual in two dimensions, 10 across and 8 along in three"));
            }
        }
        if let Some(width) = grid_width.filter(|width| !(*width > 0.0 && width.is_finite())) {
            return Err(refusal("E0672", "grid_width", &format!("a contact grid cannot be {width} m wide"),
                "give a positive width, or leave it out to take it from the Hertz half-width"));
        }
        let ids = [body(context, "first", first)?, body(context, "second", second)?];
        let (place, host) = (context.place, host(context)?);
        for (argument, id) in ["first", "second"].into_iter().zip(ids) {
            if host.scene.bodies.get(id.0).is_none_or(|body| body.prototype.tooth_flanks().is_none()) {
                host.gear_on(argument, id)?;
            }
        }
        let lubrication = of_mesh(host, lubrication, ids, place)?;
        let options = MeshOptions {
            tip_corner_contact,
            half_cells: contact_cells.map(|cells| cells as usize),
            half_slices: contact_slices as usize,
            grid_width,
            friction,
            misalignment: Misalignment { in_action: misalignment, off_action: misalignment_out_of_plane },
            coast_side_contact,
            lubrication,
            torque_on_first: torque_on_first.unwrap_or(0.0),
        };
        if is_general(&host.scene, ids).map_err(engine)? {
            let meshed = general_mesh(&mut host.scene, ids, &options);
            let meshed = meshed.map_err(|refusal| host.rejected(refusal, place))?;
            host.note(&meshed.warnings, place);
            host.general_backlash.extend(meshed.backlash.map(|angle| (meshed.pair.0, angle)));
            return Ok(Handle(meshed.pair.0 as u64));
        }
        let pairing = Pairing::of(&host.scene, ids).map_err(|refusal| host.rejected(refusal, place))?;
        // A pair that can touch has a geometry even if it cannot run.
        if let Some(geometry) = pairing.geometry(&host.scene) {
            host.mesh_records.push(MeshRecord { bodies: ids.map(|id| id.0), geometry, place });
        }
        let meshed = pairing.mesh(&mut host.scene, &options).map_err(|refusal| host.rejected(refusal, place))?;
        host.note(&meshed.warnings, place);
        let speed = rotation_speed(host.scene.bodies[ids[0].0].motion.as_ref(), 0.0).unwrap_or(0.0);
        let radius = host.gear_on("first", ids[0])?.form().pitch_radius;
        host.note(&pitch_line(speed, radius).into_iter().collect::<Vec<_>>(), place);
        Ok(Handle(meshed.pair.0 as u64))
    }

    Pure fn calyx_gears_coast_side(context, mesh: Handle) -> Handle {
        let pairs = &host(context)?.scene.pairs;
        let front = entry(pairs, mesh)?.front.unwrap_or(PairId(mesh.0 as usize));
        match pairs.iter().position(|pair| pair.front == Some(front)) {
            Some(back) => Ok(Handle(back as u64)),
            None => Err(refusal("E0654", "mesh", "contact of the back sides is not searched in this mesh",
                "make it with `gears.mesh(..., coast_side_contact = TRUE)`")),
        }
    }

    Scene fn calyx_gears_check_spacing(context, planets: f64, teeth: f64) -> () {
        let (place, host) = (context.place, host(context)?);
        host.note(&unequal_planet_spacing(planets, teeth).into_iter().collect::<Vec<_>>(), place);
        Ok(())
    }

    Pure fn calyx_gears_mesh_cycle(context, mesh: Handle, steps: f64) -> Handle {
        if !(steps.fract() == 0.0 && steps >= 2.0) {
            return Err(refusal("E0673", "steps", &format!("a mesh cycle cannot have {steps} positions"),
                "give a whole number of at least 2"));
        }
        let host = host(context)?;
        let pair = entry(&host.scene.pairs, mesh)?;
        let positions = pair.mesh.as_ref().map(|mesh| mesh_cycle(mesh, steps as usize)).unwrap_or_default();
        Ok(keep(&mut host.positions, positions))
    }

    Pure fn calyx_gears_times(context, from: f64, to: f64, count: f64) -> Handle {
        let whole = count.fract() == 0.0 && (1.0..=MOST_TIMES).contains(&count);
        let range = from.is_finite() && to.is_finite() && (count == 1.0 || to > from);
        if !(whole && range) {
            return Err(refusal("E0753", if whole { "to" } else { "count" },
                &format!("there are no {count} positions from {from} s to {to} s"),
                "give a whole number of positions, at least 1, and an end after the beginning"));
        }
        let last = (count - 1.0).max(1.0);
        let at = |index: usize| Position::at(from + (to - from) * (index as f64 / last));
        Ok(keep(&mut host(context)?.positions, (0..count as usize).map(at).collect()))
    }

    Pure fn calyx_gears_teeth(context, gear: Handle) -> f64 {
        Ok(f64::from(entry(&host(context)?.gears, gear)?.teeth()))
    }

    Pure fn calyx_gears_base_radius(context, gear: Handle) -> f64 {
        Ok(host(context)?.cylindrical("gear", gear)?.form().base_radius)
    }

    /// Registers an output of the model.
    Scene fn calyx_std_output(context, name: String, value: SymbolicNumber) -> () {
        let params = context.params.clone().into();
        before_analysis(context, format_args!("the output `{name}`"))?;
        let (place, host) = (context.place, host(context)?);
        host.outputs.push(OutputRequest { name, value: value.0, params });
        host.output_places.push(place);
        Ok(())
    }

    /// Function of the scene, although it solves: a check plans the analysis and stops there.
    Scene fn calyx_std_analyze(
        context, method: String, over: Handle, fidelity: String, face_elements: Option<f64>,
        displacement_order: Option<f64>, newmark: String, rayleigh_mass: f64, rayleigh_stiffness: f64,
        highest_frequency: f64, start: String, error_estimates: String, tolerance: Option<f64>,
    ) -> () {
        let own_fidelity = fidelity_named(&fidelity)?;
        let face_elements = count_or_default("face_elements", face_elements)?;
        let axial_order = count_or_default("displacement_order", displacement_order)?;
        let error_estimates = Estimates::named(&error_estimates).ok_or_else(|| {
            let known = Estimates::ALL.map(|(name, _)| format!("\"{name}\""));
            refusal("E0790", "error_estimates", &format!("there are no error estimates called \"{error_estimates}\""),
                &format!("choose one of {}", known.join(", ")))
        })?;
        let (place, host) = (context.place, host(context)?);
        let overrides = host.overrides;
        let fidelity = overrides.fidelity.unwrap_or(own_fidelity);
        let error_estimates = overrides.error_estimates.unwrap_or(error_estimates);
        let asked = host.asked.is_some() && host.checking;
        if asked || host.result.is_some() {
            return Err(RuntimeError::new("E0680", "the model has a second analysis, and a run has the results of one",
                "keep one `analyze`; run the model twice with different params instead"));
        }
        let structure = StructureOptions { face_elements, axial_order, ..host.analysis.structure };
        structure.check().map_err(engine)?;
        let structure = overrides.structure(structure);
        overrides.override_grids(&mut host.scene);
        let sensitivities = crate::sensitivity_externs::requested(host);
        let options = AnalysisOptions {
            fidelity, structure, highest_frequency, error_estimates, sensitivities, ..host.analysis.clone()
        };
        let positions = overrides.sample(entry(&host.positions, over)?.clone());
        let rayleigh = [rayleigh_mass, rayleigh_stiffness];
        let arguments = Arguments { over, positions, newmark: &newmark, rayleigh, start: &start };
        let analysis = analyses::create(host, &method, arguments)?;
        crate::signal_externs::check(host)?;
        crate::sensitivity_externs::check(host)?;
        let in_time = analysis.has_inertia();
        if in_time && overrides.every.is_some() {
            return Err(RuntimeError::new("E0795", "of a motion in time no step can be left out",
                "leave `every` to quasi-static analyses; the model's `output_every` says which steps results have"));
        }
        // A settings override of the searched setting disables the tolerance search.
        let searched = tolerance.filter(|_| overrides.keeps_setting());
        host.asked = Some(AnalysisRequest {
            fidelity,
            structure,
            in_time,
            problems: analysis.problems(),
            highest_frequency,
            estimates: error_estimates,
            tolerance: searched,
            place,
        });
        if let Some(tolerance) = tolerance {
            check_tolerance(tolerance).map_err(engine)?;
            if !analysis.supports_tolerance() {
                return Err(engine(without_tolerance()));
            }
        }
        if options.sensitivities.is_some() || !host.requested_sensitivities.is_empty() {
            check_differentiable(in_time, searched.is_some()).map_err(engine)?;
        }
        if host.checking {
            host.requested = Some(analysis);
            return Ok(());
        }
        analyze(host, analysis.as_ref(), searched, (&options, place))
    }
}

/// Maximum number of positions in a list; the results of more would not fit.
const MOST_TIMES: f64 = 1e6;

/// Rejects derivatives of an analysis that has none.
fn check_differentiable(in_time: bool, is_search: bool) -> Result<(), EngineError> {
    let refuse = |message: &str, help: &str| Err(EngineError::new("E0792", message, help));
    match (in_time, is_search) {
        (true, _) => refuse(
            "the outputs of a motion in time have no derivatives",
            "analyse quasi-statically; to vary a param of a motion in time use `calyx sweep`",
        ),
        (_, true) => refuse(
            "the outputs of a tolerance search have no derivatives, because its settings may differ next to the values of the params",
            "give `analyze` a `fidelity` in place of `tolerance`, or run the model with `--fidelity`",
        ),
        _ => Ok(()),
    }
}

/// Plans and runs an analysis of the scene, and stores its result.
fn analyze(
    host: &mut ModelHost,
    analysis: &dyn Analysis,
    tolerance: Option<f64>,
    (options, place): (&AnalysisOptions, (u32, u32, u32)),
) -> Result<(), RuntimeError> {
    check_unrestrained(host);
    check_loads(host, analysis, options.fidelity)?;
    check_raceways(host, analysis)?;
    let request = Request::new(&host.scene, &host.outputs, analysis, options);
    host.findings.extend(without_value(host, &request));
    let mut observer = host.observer.take();
    let mut unobserved = ();
    let watching =
        observer.as_mut().map_or(&mut unobserved as &mut dyn Observer, |observer| observer.as_mut());
    let (scene, outputs) = (&host.scene, &host.outputs);
    let result = match tolerance {
        Some(tolerance) => analysis.run_within(tolerance, scene, outputs, options, watching),
        None => analysis.run(scene, outputs, options, watching),
    };
    host.observer = observer;
    host.failed_analyses += usize::from(result.is_err());
    let result = result.map_err(|error| host.engine_error(host.overrides.list(error)))?;
    if let Some(missed) = result.tolerance_search.as_ref().and_then(ToleranceOutcome::missed) {
        let error = RuntimeError { place: Some(place), ..host.engine_error(missed) };
        host.findings.push(Finding { severity: Severity::Warning, error });
    }
    let warnings = partly_fixed_bearings(host, &result.plan);
    host.findings.extend(warnings);
    host.result = Some(result);
    crate::signal_externs::answer(host);
    Ok(())
}

/// Warnings about bearings that resist displacements in which their bodies are fixed.
fn partly_fixed_bearings(host: &ModelHost, plan: &Plan) -> Vec<Finding> {
    let warn = |error| Finding { severity: Severity::Warning, error: host.engine_error(error) };
    plan.partly_fixed_bearings(&host.scene).into_iter().map(warn).collect()
}

/// Warnings about outputs that have no value at the fidelity, while others have one.
fn without_value(host: &ModelHost, request: &Request<'_>) -> Vec<Finding> {
    let warn = |error| {
        let error = host.engine_error(host.overrides.list(error));
        Finding { severity: Severity::Warning, error }
    };
    request.without_value().into_iter().map(warn).collect()
}

/// Converts a positive integer; `None` selects the default of the fidelity.
fn count_or_default(argument: &str, count: Option<f64>) -> Result<Option<usize>, RuntimeError> {
    let Some(count) = count else { return Ok(None) };
    if count.fract() != 0.0 || count < 1.0 {
        return Err(refusal(
            "E0691",
            argument,
            &format!("`{argument}` cannot be {count}"),
            "give a whole number, or leave it out to take that of the fidelity",
        ));
    }
    Ok(Some(count as usize))
}

/// Validates the requested analysis by the rules of a run, without building or solving anything.
///
/// # Errors
/// The errors that end a run before it builds a structure, and the interrupt's.
pub fn check_plan(host: &mut ModelHost, interrupt: &Interrupt) -> Result<Plan, RuntimeError> {
    // A model without an analysis is checked at the start of its mesh cycle.
    let analysis = host.requested.take().unwrap_or_else(|| {
        let starts = host.scene.pairs.iter().filter_map(|pair| Some(pair.mesh.as_ref()?.start));
        let start = starts.fold(f64::INFINITY, f64::min);
        let start = Position::at(if start.is_finite() { start } else { 0.0 });
        Arc::new(QuasiStatic { positions: Cow::Owned(vec![start]) })
    });
    if let Some(asked) = host.asked {
        check_loads(host, analysis.as_ref(), asked.fidelity)?;
    }
    check_raceways(host, analysis.as_ref())?;
    let unasked = host.overrides.fidelity.unwrap_or(Fidelity::Plane);
    let request = Request {
        scene: &host.scene,
        outputs: &host.outputs,
        method: analysis.as_ref(),
        fidelity: host.asked.map_or(unasked, |asked| asked.fidelity),
        structure: host
            .asked
            .map_or_else(|| host.overrides.structure(host.analysis.structure), |asked| asked.structure),
        highest_frequency: host.asked.map_or(0.0, |asked| asked.highest_frequency),
    };
    let plan = request.plan(interrupt).or_else(|error| {
        // Helical gears are only rejected by plane models, so the error waits until the model
        // requests an analysis.
        let unasked = host.asked.is_none() && host.overrides.fidelity.is_none() && error.code == "E0623";
        let three_dimensional = Request { fidelity: Fidelity::Solid(Template::Medium), ..request };
        if unasked { three_dimensional.plan(interrupt).map_err(|_| error) } else { Err(error) }
    });
    let content = |plan: Plan| match host.asked {
        Some(_) => check_content(&host.scene, &plan).map(|()| plan),
        None => Ok(plan),
    };
    let plan = plan.and_then(content).map_err(|error| host.engine_error(host.overrides.list(error)))?;
    let mut warnings = without_value(host, &request);
    warnings.extend(partly_fixed_bearings(host, &plan));
    host.findings.extend(warnings);
    Ok(plan)
}

/// Reports movable bodies without a mesh or a bearing as a constraint: an analysis leaves them out.
pub fn check_unrestrained(host: &mut ModelHost) {
    let meshed = |body: usize| host.scene.pairs.iter().any(|pair| pair.bodies.contains(&BodyId(body)));
    let supported = |body: usize| host.scene.bearings.iter().any(|b| b.bodies().any(|other| other.0 == body));
    let free = |body: &Body| DOF_NAMES.iter().zip(body.free).find(|(_, free)| *free).map(|(name, _)| *name);
    // The sections of a shaft are restrained together, and its first body stands for them.
    let joined = |body: usize| {
        host.scene.connections_of(BodyId(body)).any(|connection| {
            let first = connection.bodies().next() == Some(BodyId(body));
            !first || connection.bodies().any(|other| meshed(other.0) || supported(other.0))
        })
    };
    let bodies = host
        .scene
        .bodies
        .iter()
        .enumerate()
        .filter(|(index, _)| !meshed(*index) && !supported(*index) && !joined(*index));
    let unrestrained: Vec<Finding> = bodies
        .filter_map(|(index, body)| {
            let error = EngineError::new(
                "E0715",
                format!("nothing constrains body \"{}\" in {}, so it is left out", body.name, free(body)?),
                "mesh it with another body, add a bearing, or constrain it (remove the degree of freedom from `free`)",
            );
            let error = host.engine_error(error.about(Subject::Body(index)).blame("free"));
            Some(Finding { severity: Severity::Warning, error })
        })
        .collect();
    host.findings.extend(unrestrained);
}

fn fidelity_named(name: &str) -> Result<Fidelity, RuntimeError> {
    Fidelity::named(name).ok_or_else(|| {
        let known: Vec<String> = Fidelity::ALL.iter().map(|known| format!("\"{}\"", known.name())).collect();
        let help = format!("choose one of {}", known.join(", "));
        refusal("E0674", "fidelity", &format!("there is no fidelity called \"{name}\""), &help)
    })
}

pub(crate) fn host(context: &mut Context) -> Result<&mut ModelHost, RuntimeError> {
    let instance = context.instance.clone();
    let library_call = Some(context.library_call).filter(|call| *call != (0, 0, 0));
    let host: Option<&mut ModelHost> = context.host();
    let host = host.ok_or_else(|| defect("the gear library was called without its state"))?;
    host.instance = instance;
    host.library_call = library_call;
    Ok(host)
}

/// Checks that a part of the model, or a request to the analysis, comes before `analyze`.
///
/// # Errors
/// E0980: it comes after.
pub(crate) fn before_analysis(
    context: &mut Context,
    what: impl std::fmt::Display,
) -> Result<(), RuntimeError> {
    match host(context)?.asked {
        None => Ok(()),
        Some(_) => Err(RuntimeError::new(
            "E0980",
            format!("{what} is declared after the analysis, whose results would not contain it"),
            "declare it before `analyze`",
        )),
    }
}

pub(crate) fn entry<T>(table: &[T], handle: Handle) -> Result<&T, RuntimeError> {
    table.get(handle.0 as usize).ok_or_else(|| defect("a handle refers to nothing"))
}

/// Body of the scene; ground is not one.
pub(crate) fn body(context: &mut Context, argument: &str, body: Handle) -> Result<BodyId, RuntimeError> {
    if body == GROUND {
        let help = "ground carries bearings, as in `gears.bearing(..., to = gears.ground())`; give a body that `gears.body` made";
        return Err(refusal("E0684", argument, "ground is not a body", help));
    }
    if let Some(shaft) = as_shaft(host(context)?, body) {
        return Ok(host(context)?.shafts[shaft].body);
    }
    if let Some(refused) = has_no_motion(host(context)?, argument, body) {
        return Err(refused);
    }
    entry(&host(context)?.scene.bodies, body)?;
    Ok(BodyId(body.0 as usize))
}

pub(crate) fn defect(message: &str) -> RuntimeError {
    RuntimeError::new("E0799", message, "this is a defect of Calyx; please report it with the model")
}

/// Tooth of a body's gear.
pub(crate) fn tooth_number(host: &ModelHost, body: BodyId, tooth: f64) -> Result<u32, RuntimeError> {
    let teeth = host.gear_model_on("body", body)?.teeth();
    match tooth.fract() == 0.0 && (0.0..f64::from(teeth)).contains(&tooth) {
        true => Ok(tooth as u32),
        false => Err(refusal(
            "E0682",
            "tooth",
            &format!("there is no tooth {tooth}"),
            &format!("teeth are counted counter-clockwise from 0 to {}", teeth - 1),
        )),
    }
}

/// Checks the number of a spline tooth of a body's rim.
pub(crate) fn spline_tooth_number(host: &ModelHost, body: BodyId, tooth: f64) -> Result<u32, RuntimeError> {
    let count = match host.gear_on("body", body)?.rim.support {
        BoreSupport::SplineTeeth(spline_teeth) | BoreSupport::SplineWithClearance { spline_teeth, .. } => {
            u32::from(spline_teeth.count)
        }
        BoreSupport::Rigid | BoreSupport::Means { .. } | BoreSupport::Raceway { .. } => 0,
    };
    match tooth.fract() == 0.0 && (0.0..f64::from(count)).contains(&tooth) {
        true => Ok(tooth as u32),
        false if count == 0 => Err(refusal(
            "E0657",
            "body",
            "the rim of this body has no spline teeth",
            "support it with `splined`",
        )),
        false => Err(refusal(
            "E0657",
            "tooth",
            &format!("there is no spline tooth {tooth}"),
            &format!("spline teeth are numbered counter-clockwise from 0 to {}", count - 1),
        )),
    }
}

pub(crate) fn refusal(code: &str, argument: &str, message: &str, help: &str) -> RuntimeError {
    RuntimeError::new(code, message, help).of_argument(argument)
}

pub(crate) fn engine(error: EngineError) -> RuntimeError {
    let argument = error.argument.map(str::to_owned);
    RuntimeError { argument, ..RuntimeError::new(error.code, error.message, error.help) }
}
