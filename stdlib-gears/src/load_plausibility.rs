//! Plausibility of the loads of a scene: whether they reach its teeth, and whether the teeth can
//! carry them. Checks and runs report it before they solve anything.

use crate::error::Severity;
use crate::host::{Finding, ModelHost};
use calyx_abi::RuntimeError;
use calyx_runtime::analyses::Analysis;
use calyx_runtime::error::{EngineError, Subject};
use calyx_runtime::motion::{Orientation, spatial_pose};
use calyx_runtime::observables::Needs;
use calyx_runtime::scene::{BodyId, DOF_NAMES, Fidelity, Scene};

/// Components of a load below this fraction of the largest are rounding errors.
const ROUNDING: f64 = 1e-12;
/// Number of times at which variable loads are sampled.
const SAMPLES: usize = 8;
/// Mesh stiffness of a tooth pair divided by face width and Young's modulus: 14 N/(mm um) for steel
/// teeth (ISO 6336-1) over 206 GPa.
const STIFFNESS: f64 = 14e9 / 206e9;
/// Deflection in modules above which teeth of any material are overloaded.
const OVERLOADED: f64 = 0.25;
/// Deflection in modules above which teeth leave the mesh.
const CRUSHED: f64 = 1.0;

/// Checks the loads of the bodies of a scene for an analysis, and adds warnings to the findings.
///
/// # Errors
/// E0800: a load reaches no tooth. E0806: an output observes a gear that is in no mesh. E0807: the
/// load would deflect the teeth out of mesh.
pub(crate) fn check_loads(
    host: &mut ModelHost,
    analysis: &dyn Analysis,
    fidelity: Fidelity,
) -> Result<(), RuntimeError> {
    let mut found = unmeshed(host)?;
    let times = analysis.sample_times(SAMPLES);
    for group in groups(&host.scene) {
        let loads = LoadGroups::on(host, &group, &times, analysis);
        found.extend(loads.finding(host, &group, analysis)?);
    }
    if fidelity != Fidelity::Rigid {
        found.extend(overloaded(host, &times)?);
    }
    for finding in found {
        if !host.findings.contains(&finding) {
            host.findings.push(finding);
        }
    }
    Ok(())
}

fn warning(host: &ModelHost, error: EngineError) -> Finding {
    Finding { severity: Severity::Warning, error: host.engine_error(error) }
}

/// Bodies that meshes, bearings and shafts connect: one list for each connected component with a
/// mesh.
fn groups(scene: &Scene) -> Vec<Vec<usize>> {
    let mut left: Vec<bool> = vec![true; scene.bodies.len()];
    let mut groups = Vec::new();
    for pair in &scene.pairs {
        let mut group: Vec<usize> = Vec::new();
        let mut next: Vec<usize> = vec![pair.bodies[0].0];
        while let Some(body) = next.pop() {
            if !std::mem::replace(&mut left[body], false) {
                continue;
            }
            group.push(body);
            let pairs = scene.pairs.iter().filter(|pair| pair.bodies.contains(&BodyId(body)));
            next.extend(pairs.flat_map(|pair| pair.bodies).map(|other| other.0));
            let bearings = scene.bearings.iter().filter(|b| b.bodies().any(|other| other.0 == body));
            next.extend(bearings.flat_map(|bearing| bearing.bodies()).map(|other| other.0));
            let connections = scene.connections_of(BodyId(body));
            next.extend(connections.flat_map(|connection| connection.bodies()).map(|other| other.0));
        }
        if !group.is_empty() {
            group.sort_unstable();
            groups.push(group);
        }
    }
    groups
}

/// Loads on a connected group of bodies.
struct LoadGroups {
    /// True if any body is free to move.
    free: bool,
    /// True if a load acts, or may act, along a free component: a load from the host program, a
    /// bearing with a load of its own, or an impulse.
    on_free: bool,
    /// A body whose load acts along fully constrained components only.
    on_constrained: Option<(usize, &'static str)>,
}

impl LoadGroups {
    fn on(host: &ModelHost, group: &[usize], times: &[f64], analysis: &dyn Analysis) -> LoadGroups {
        let scene = &host.scene;
        let bearings = scene.bearings.iter().filter(|b| b.bodies().any(|other| group.contains(&other.0)));
        let mut loads = LoadGroups {
            free: false,
            on_free: bearings
                .into_iter()
                .any(|b| b.linearization.is_none() && !b.is_unloaded_without_motion()),
            on_constrained: None,
        };
        for &index in group {
            let body = &scene.bodies[index];
            loads.free |= body.free.contains(&true);
            loads.on_free |= !body.impulses.is_empty();
            // Loads from the host program are only evaluated at positions.
            if host.host_loaded.contains(&index) {
                loads.on_free = true;
                continue;
            }
            for &time in times {
                let along = body.load.at(time).along(&own_axes(scene, index, time));
                // Parts of a load on an inclined axis that are rounding errors do not count.
                let size = |from: usize| (from..from + 3).map(|k| along[k].abs()).fold(0.0, f64::max);
                let sizes = [size(0), size(3)];
                let components = along.into_iter().enumerate();
                for (component, _) in components.filter(|(k, part)| part.abs() > ROUNDING * sizes[k / 3]) {
                    match body.free[component] {
                        true => loads.on_free = true,
                        false => {
                            loads.on_constrained =
                                loads.on_constrained.or(Some((index, DOF_NAMES[component])))
                        }
                    }
                }
            }
        }
        // In a dynamic analysis inertia loads the teeth too if anything moves.
        loads.on_free |= analysis.has_inertia() && loads.free;
        loads
    }

    fn finding(
        &self,
        host: &ModelHost,
        group: &[usize],
        analysis: &dyn Analysis,
    ) -> Result<Option<Finding>, RuntimeError> {
        let scene = &host.scene;
        let name = |index: usize| &scene.bodies[index].name;
        match self.on_constrained {
            _ if self.on_free => Ok(None),
            Some((index, component)) => {
                let message = format!(
                    "the load on body \"{}\" reaches no tooth: its frame constrains {component}, and no body that it meshes with is free under a load",
                    name(index)
                );
                let help = match component {
                    // A body that is free to tilt would not transmit this load either.
                    "theta_x" | "theta_y" => {
                        "gears transmit a moment about their axis: give it along the axis, such as `moment = 100 N*m * e3` for an axis along e3".to_string()
                    }
                    _ => format!(
                        "let the load move the body, `free = [\"{component}\"]`, or put the load on a body that is free"
                    ),
                };
                let error =
                    EngineError::new("E0800", message, help).about(Subject::Body(index)).blame("free");
                Err(host.engine_error(error))
            }
            None => {
                let forces = scene.observables.iter().any(|observable| observable.needs() > Needs::Motions);
                let first = group.first().copied().unwrap_or_default();
                if !forces || !self.free || analysis.has_inertia() {
                    return Ok(None);
                }
                let names: Vec<String> = group.iter().map(|&index| format!("\"{}\"", name(index))).collect();
                let message =
                    format!("no load acts on {}: forces, pressures and stresses are zero", names.join(", "));
                let help = "give a body that is free a `moment`, such as `moment = 100 N*m * e3`";
                let error = EngineError::new("E0801", message, help).about(Subject::Body(first));
                Ok(Some(warning(host, error)))
            }
        }
    }
}

/// Warns of gears in no mesh.
fn unmeshed(host: &ModelHost) -> Result<Vec<Finding>, RuntimeError> {
    let scene = &host.scene;
    let meshed = |body: BodyId| scene.pairs.iter().any(|pair| pair.bodies.contains(&body));
    for (index, output) in host.outputs.iter().enumerate() {
        let observed = output.value.observes().into_iter().filter_map(|at| scene.observables.get(at));
        let alone = observed.filter_map(|observable| observable.stresses_of()).find(|body| !meshed(*body));
        if let Some(body) = alone {
            let message = format!(
                "output `{}` asks for the stress of body \"{}\", which is in no mesh",
                output.name, scene.bodies[body.0].name
            );
            let help = "let it touch another gear with `gears.mesh`, or leave the output out";
            return Err(
                host.engine_error(EngineError::new("E0806", message, help).about(Subject::Output(index)))
            );
        }
    }
    let gears =
        host.body_gears.iter().enumerate().filter(|(index, gear)| gear.is_some() && !meshed(BodyId(*index)));
    // Free gears without constraints are reported elsewhere.
    let constrained = gears.filter(|(index, _)| !scene.bodies[*index].free.contains(&true));
    let warn = |(index, _): (usize, _)| {
        let message =
            format!("the gear of body \"{}\" is in no mesh, so it is left out", scene.bodies[index].name);
        let help = "let it touch another gear with `gears.mesh`, or leave the body out";
        warning(host, EngineError::new("E0806", message, help).about(Subject::Body(index)))
    };
    Ok(constrained.map(warn).collect())
}

/// Finds meshes whose load is out of proportion to their teeth, using a mesh stiffness that is
/// accurate to a factor of two.
fn overloaded(host: &ModelHost, times: &[f64]) -> Result<Vec<Finding>, RuntimeError> {
    let scene = &host.scene;
    let mut found = Vec::new();
    for pair in scene.pairs.iter().filter(|pair| pair.front.is_none()) {
        let Some(mesh) = &pair.mesh else { continue };
        let gears = pair.bodies.map(|body| host.gear_on("first", body).ok());
        let [Some(first), Some(second)] = gears else { continue };
        let force = |side: usize| {
            let body = pair.bodies[side];
            let meshes = scene.pairs.iter().filter(|p| p.front.is_none() && p.bodies.contains(&body)).count();
            if host.host_loaded.contains(&body.0) {
                return 0.0;
            }
            let load = |time: &f64| {
                scene.bodies[body.0].load.at(*time).along(&own_axes(scene, body.0, *time))[5].abs()
            };
            let moment = times.iter().map(load).fold(0.0, f64::max);
            let moment = if scene.bodies[body.0].free[5] { moment } else { 0.0 };
            moment / mesh.base_radii[side] / meshes.max(1) as f64
        };
        let force = force(0).max(force(1));
        let width = first.face_width.min(second.face_width);
        let modulus = 2.0 / (first.material.youngs_modulus.recip() + second.material.youngs_modulus.recip());
        let module = first.form().module.min(second.form().module);
        let deflection = force / (width * STIFFNESS * modulus) / module;
        if !deflection.is_finite() || deflection < OVERLOADED {
            continue;
        }
        let [one, other] = pair.bodies.map(|body| &scene.bodies[body.0].name);
        let message = format!(
            "a force of {} on a face of {} mm bends the teeth of \"{one}\" and \"{other}\" by about {} modules",
            if force < 1e3 { format!("{} N", shown(force)) } else { format!("{} kN", shown(1e-3 * force)) },
            shown(1e3 * width),
            shown(deflection)
        );
        let help = "check the units of the torque, of `face_width` and of `youngs_modulus`: a slip is often a factor of 1000";
        let error = EngineError::new("E0807", message, help).about(Subject::Body(pair.bodies[0].0));
        match deflection > CRUSHED {
            true => return Err(host.engine_error(error)),
            false => found.push(warning(host, error)),
        }
    }
    Ok(found)
}

/// Directions of a body's degrees of freedom, to which its loads refer.
fn own_axes(scene: &Scene, body: usize, time: f64) -> [[f64; 3]; 3] {
    spatial_pose(scene.bodies[body].motion.as_ref(), time)
        .map_or([[f64::NAN; 3]; 3], |pose| Orientation::of(&pose).axes)
}

/// Rounds a number to two digits for display.
fn shown(value: f64) -> f64 {
    format!("{value:.1e}").parse().unwrap_or(value)
}
