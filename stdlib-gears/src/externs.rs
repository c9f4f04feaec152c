//! The library's functions as programs call them: the Rust side of `gears.cx` and `prelude.cx`.

use crate::error::{GeometryError, Severity};
use crate::external::{ExternalGear, ExternalGearData, check_rim};
use crate::host::{Finding, Meeting, ModelHost, Rim, keep};
use crate::mesh_geometry::MeshGeometry;
use crate::modification::{Modification, ReliefShape, TipRelief};
use crate::mounting::{Mounting, mount_external};
use crate::prototype::GearPrototype;
use crate::rack::Rack;
use calyx_abi::externs::{Handle, SymbolicNumber, SymbolicTransform};
use calyx_abi::{Context, RuntimeError, SymbolicValue};
use calyx_runtime::analysis::{AnalysisOptions, mesh_cycle, quasi_static};
use calyx_runtime::error::{EngineError, Subject};
use calyx_runtime::holding;
use calyx_runtime::material::Material;
use calyx_runtime::motion::{Motion, PlanePose};
use calyx_runtime::plan::Plan;
use calyx_runtime::results::OutputRequest;
use calyx_runtime::scene::{
    Body, BodyId, FREEDOMS, Fidelity, GridOptions, Observable, PairId, Scene, StructureOptions, SurfacePair,
};
use std::sync::Arc;

calyx_abi::externs! {
    Pure fn calyx_gears_material(context, youngs_modulus: f64, poissons_ratio: f64, density: f64) -> Handle {
        if !(youngs_modulus > 0.0 && youngs_modulus.is_finite()) {
            return Err(refusal("E0660", "youngs_modulus", "Young's modulus must be positive",
                "steel has about 206 GPa, or 3e7 psi"));
        }
        if !(0.0..0.5).contains(&poissons_ratio) {
            return Err(refusal("E0661", "poissons_ratio", "Poisson's ratio must be at least 0 and less than 0.5",
                "steel has 0.3"));
        }
        if !(density >= 0.0 && density.is_finite()) {
            return Err(refusal("E0662", "density", "the density cannot be negative", "steel has 7850 kg/m^3"));
        }
        Ok(keep(&mut host(context)?.materials, Material { youngs_modulus, poissons_ratio, density }))
    }

    Pure fn calyx_gears_rack(
        context, module: f64, diametral_pitch: f64, pressure_angle: f64, tip_radius: f64,
    ) -> Handle {
        let module = match (module != 0.0, diametral_pitch != 0.0) {
            (true, false) => module,
            (false, true) => 1.0 / diametral_pitch,
            (true, true) => return Err(refusal("E0663", "diametral_pitch",
                "the rack has both a module and a diametral pitch", "give one of them; they are each other's inverse")),
            (false, false) => return Err(refusal("E0664", "module",
                "the rack has neither a module nor a diametral pitch",
                "give its size, like `module = 2.5 mm` or `diametral_pitch = 10 / inch`")),
        };
        let (place, host) = (context.place, host(context)?);
        let rack = Rack::new(module, pressure_angle, tip_radius).map_err(|error| host.told(&error, place))?;
        Ok(keep(&mut host.racks, rack))
    }

    Pure fn calyx_gears_simple_rim(context, diameter: f64, inner_diameter: f64) -> Handle {
        if !(inner_diameter > 0.0 && inner_diameter < diameter) {
            return Err(refusal("E0665", "inner_diameter",
                "the rim's inner diameter must be positive and smaller than its diameter",
                "the body is held at the inner diameter"));
        }
        Ok(keep(&mut host(context)?.rims, Rim { radius: 0.5 * diameter, inner_radius: 0.5 * inner_diameter }))
    }

    Pure fn calyx_gears_tip_relief(context, depth: f64, start_roll: f64, shape: String) -> Handle {
        let shape = if shape == "linear" { ReliefShape::Linear } else { ReliefShape::Quadratic };
        Ok(keep(&mut host(context)?.modifications, Modification::TipRelief(TipRelief { depth, start_roll, shape })))
    }

    Pure fn calyx_gears_lead_crown(context, depth: f64) -> Handle {
        if depth.is_nan() || depth < 0.0 {
            return Err(refusal("E0666", "depth", "a crown cannot be negative",
                "it is the depth taken off at the ends of the face"));
        }
        Ok(keep(&mut host(context)?.modifications, Modification::LeadCrown { depth }))
    }

    Pure fn calyx_gears_external(
        context, teeth: f64, rack: Handle, face_width: f64, outer_diameter: f64, root_diameter: f64,
        material: Handle, rim: Handle, tooth_thickness: f64, profile_shift: f64, tip_edge_radius: f64,
        modifications: Vec<Handle>, pitch_errors: Vec<f64>,
    ) -> Handle {
        if !(teeth.fract() == 0.0 && (3.0..=1e6).contains(&teeth)) {
            return Err(refusal("E0667", "teeth", &format!("a gear cannot have {teeth} teeth"),
                "give a whole number of at least 3"));
        }
        if !(face_width > 0.0 && face_width.is_finite()) {
            return Err(refusal("E0668", "face_width", "the face width must be positive",
                "give the width of the toothed part along the axis"));
        }
        let (place, host) = (context.place, host(context)?);
        let (rack, rim) = (*entry(&host.racks, rack)?, *entry(&host.rims, rim)?);
        let material = *entry(&host.materials, material)?;
        let tooth_thickness =
            if tooth_thickness > 0.0 { tooth_thickness } else { rack.thickness_of_shift(profile_shift) };
        let gear = ExternalGear::new(ExternalGearData {
            teeth: teeth as u32,
            rack,
            tooth_thickness,
            outer_radius: 0.5 * outer_diameter,
            root_radius: 0.5 * root_diameter,
            tip_edge_radius: (tip_edge_radius > 0.0).then_some(tip_edge_radius),
        })
        .map_err(|errors| refused(host, &errors, place))?;
        check_rim(gear.root_radius, rim.radius, rim.inner_radius).map_err(|error| host.told(&error, place))?;
        let modifications: Vec<Modification> = modifications
            .into_iter()
            .map(|handle| entry(&host.modifications, handle).copied())
            .collect::<Result<_, _>>()?;
        let pitch_errors = pitch_errors.iter().map(|error| error / gear.pitch_radius).collect();
        host.note(&gear.warnings, place);
        let prototype = GearPrototype::new(gear, modifications, material, rim, face_width, pitch_errors)
            .map_err(|errors| refused(host, &of_modifications(errors), place))?;
        host.gear_places.push(place);
        Ok(keep(&mut host.gears, Arc::new(prototype)))
    }

    Scene fn calyx_gears_body(
        context, name: String, blank: Handle, frame: SymbolicTransform, free: Vec<String>, force: [f64; 3],
        moment: [f64; 3],
    ) -> Handle {
        let mut freedoms = [false; 6];
        for freedom in &free {
            let Some(at) = FREEDOMS.iter().position(|known| known == freedom) else {
                return Err(refusal("E0670", "free", &format!("\"{freedom}\" is not a freedom of a frame"),
                    "the freedoms are \"u_x\", \"u_y\", \"u_z\", \"theta_x\", \"theta_y\" and \"theta_z\""));
            };
            freedoms[at] = true;
        }
        let motion = Arc::new(FrameMotion { value: frame.0, params: context.params.clone() });
        PlanePose::of(motion.as_ref(), 0.0).map_err(engine)?;
        turns_in_the_plane(motion.as_ref())?;
        let (place, host) = (context.place, host(context)?);
        if host.scene.bodies.iter().any(|body| body.name == name) {
            return Err(refusal("E0671", "name", &format!("there are two bodies called \"{name}\""),
                "results speak of bodies by name; give each its own"));
        }
        let prototype = entry(&host.gears, blank)?.clone();
        host.body_gears.push(blank.0 as usize);
        host.body_places.push(place);
        let id = host.scene.add_body(Body { name, prototype, motion, phase: 0.0, free: freedoms, force, moment });
        Ok(Handle(id.0 as u64))
    }

    Scene fn calyx_gears_mesh(
        context, first: Handle, second: Handle, tip_corner_contact: bool, cells: f64, grid_width: f64,
    ) -> Handle {
        if cells.fract() != 0.0 {
            return Err(refusal("E0672", "cells", "the number of cells must be whole",
                "it is half the number of cells of a grid; 24 is usual"));
        }
        let (place, host) = (context.place, host(context)?);
        let ids = [BodyId(first.0 as usize), BodyId(second.0 as usize)];
        let gears = [body_gear(host, ids[0])?, body_gear(host, ids[1])?];
        meet_once(&host.scene, ids)?;
        let poses = [pose(host, ids[0])?, pose(host, ids[1])?];
        let across = [0, 1].map(|i| poses[1].0.origin[i] - poses[0].0.origin[i]);
        let center_distance = across[0].hypot(across[1]);
        // What can touch has a geometry, also where it cannot run.
        if let Ok(geometry) = MeshGeometry::external(&gears[0].gear, &gears[1].gear, center_distance) {
            host.meetings.push(Meeting { bodies: ids.map(|id| id.0), geometry, place });
        }
        let (found, warnings) =
            MeshGeometry::check_external(&gears[0].gear, &gears[1].gear, center_distance)
                .map_err(|errors| refused(host, &errors, place))?;
        host.note(&warnings, place);
        let sense = drive_sense(&host.scene.bodies[ids[0].0], &host.scene.bodies[ids[1].0], poses[0].1);
        let mounting = Mounting {
            first: PlanePose { angle: poses[0].0.angle + host.scene.bodies[ids[0].0].phase, ..poses[0].0 },
            second: poses[1].0,
            angular_velocity: [poses[0].1, poses[1].1],
            sense,
        };
        let (phase, mesh) = mount_external([&gears[0].gear, &gears[1].gear], &found, &mounting)
            .map_err(|error| host.told(&error, place))?;
        host.scene.bodies[ids[1].0].phase = phase;
        let surface = if sense > 0.0 { 0 } else { 1 };
        let pair = SurfacePair {
            bodies: ids,
            surfaces: [surface; 2],
            grid: GridOptions {
                half_cells: cells as usize,
                width: (grid_width > 0.0).then_some(grid_width),
                edges: tip_corner_contact,
            },
            mesh: Some(mesh),
        };
        Ok(Handle(host.scene.add_pair(pair).0 as u64))
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

    Pure fn calyx_gears_base_radius(context, gear: Handle) -> f64 {
        Ok(entry(&host(context)?.gears, gear)?.gear.base_radius)
    }

    Scene fn calyx_gears_transmission_error(context, mesh: Handle) -> Handle {
        observe(context, Observable::TransmissionError(PairId(mesh.0 as usize)))
    }

    Scene fn calyx_gears_load_share(context, mesh: Handle) -> Handle {
        observe(context, Observable::LoadShare(PairId(mesh.0 as usize)))
    }

    Scene fn calyx_gears_mesh_stiffness(context, mesh: Handle) -> Handle {
        observe(context, Observable::MeshStiffness(PairId(mesh.0 as usize)))
    }

    Scene fn calyx_gears_max_contact_pressure(context, mesh: Handle) -> Handle {
        observe(context, Observable::MaxContactPressure(PairId(mesh.0 as usize)))
    }

    Scene fn calyx_gears_max_edge_pressure(context, mesh: Handle) -> Handle {
        observe(context, Observable::MaxEdgePressure(PairId(mesh.0 as usize)))
    }

    Scene fn calyx_gears_max_root_stress(context, body: Handle) -> Handle {
        observe(context, Observable::MaxRootStress(BodyId(body.0 as usize)))
    }

    /// Registers an output of the model.
    Scene fn calyx_std_output(context, name: String, value: SymbolicNumber) -> () {
        let params = context.params.clone().into();
        let (place, host) = (context.place, host(context)?);
        host.outputs.push(OutputRequest { name, value: value.0, params });
        host.output_places.push(place);
        Ok(())
    }

    Effect fn calyx_std_analyze(context, method: String, over: Handle, fidelity: String) -> () {
        if method != "quasi_static" {
            return Err(refusal("E0679", "method", &format!("there is no analysis called \"{method}\""),
                "choose \"quasi_static\""));
        }
        let host = host(context)?;
        if host.result.is_some() {
            return Err(RuntimeError::new("E0680", "the model has a second analysis, and a run holds the results of one",
                "keep one `analyze`; run the model twice with different params instead"));
        }
        analyze(host, over, &fidelity)
    }
}

/// Plans and runs an analysis of the scene, and keeps its result.
fn analyze(host: &mut ModelHost, over: Handle, fidelity: &str) -> Result<(), RuntimeError> {
    let options =
        AnalysisOptions { fidelity: fidelity_named(fidelity)?, structure: StructureOptions::default() };
    let positions = entry(&host.positions, over)?.clone();
    check_unheld(host);
    let mut observer = host.observer.take();
    let mut unobserved = ();
    let result = quasi_static(
        &host.scene,
        &positions,
        &host.outputs,
        &options,
        observer.as_mut().map_or(&mut unobserved, |observer| observer.as_mut()),
    );
    host.observer = observer;
    host.failed_analyses += usize::from(result.is_err());
    host.result = Some(result.map_err(|error| host.engine_error(error))?);
    Ok(())
}

/// What `check` does in place of an analysis: everything short of solving.
///
/// # Errors
/// What the analysis would fail with before its first position is solved. If `stopped` says that nobody wants to know any
/// more, the answer means nothing.
pub fn check_plan(host: &ModelHost, stopped: &dyn Fn() -> bool) -> Result<Plan, RuntimeError> {
    let plan = Plan::new(&host.scene, Fidelity::Plane, StructureOptions::default());
    let checked = plan.and_then(|plan| holding::check_until(&host.scene, &plan, stopped).map(|()| plan));
    checked.map_err(|error| host.engine_error(error))
}

/// Bodies that may move, and that no mesh holds: an analysis leaves them out.
pub fn check_unheld(host: &mut ModelHost) {
    let meshed = |body: usize| host.scene.pairs.iter().any(|pair| pair.bodies.contains(&BodyId(body)));
    let free = |body: &Body| FREEDOMS.iter().zip(body.free).find(|(_, free)| *free).map(|(name, _)| *name);
    let bodies = host.scene.bodies.iter().enumerate().filter(|(index, _)| !meshed(*index));
    let unheld: Vec<Finding> = bodies
        .filter_map(|(index, body)| {
            let error = EngineError::new(
                "E0715",
                format!("nothing holds body \"{}\" in {}, so it is left out", body.name, free(body)?),
                "mesh it with another body, or hold it (take the freedom out of `free`)",
            );
            let error = host.engine_error(error.about(Subject::Body(index)).blame("free"));
            Some(Finding { severity: Severity::Warning, error })
        })
        .collect();
    host.findings.extend(unheld);
}

fn fidelity_named(name: &str) -> Result<Fidelity, RuntimeError> {
    Fidelity::named(name).ok_or_else(|| {
        refusal("E0674", "fidelity", &format!("there is no fidelity called \"{name}\""), "choose \"plane\"")
    })
}

/// A compiled frame as a motion.
struct FrameMotion {
    value: Arc<SymbolicValue>,
    params: Vec<f64>,
}

impl FrameMotion {
    /// Frame and rate, 12 numbers each.
    fn eval(&self, time: f64) -> Vec<f64> {
        let mut outputs = self.value.evaluate(time, &self.params, &|_| f64::NAN).unwrap_or_default();
        outputs.resize(outputs.len().max(24), f64::NAN);
        outputs
    }
}

impl Motion for FrameMotion {
    fn frame(&self, time: f64) -> [f64; 12] {
        let outputs = self.eval(time);
        std::array::from_fn(|i| outputs[i])
    }

    fn rate(&self, time: f64) -> [f64; 12] {
        let outputs = self.eval(time);
        std::array::from_fn(|i| outputs[12 + i])
    }
}

/// A frame that is upright at Time = 0 may tilt later.
fn turns_in_the_plane(motion: &dyn Motion) -> Result<(), RuntimeError> {
    let rate = motion.rate(0.0);
    // Row and column of e3 in the rotation: its rate is perpendicular to it, so these four hold all tilting.
    let fastest = rate[..9].iter().fold(0.0, |most: f64, entry| most.max(entry.abs()));
    if [2, 5, 6, 7].iter().any(|&entry| rate[entry].abs() > 1e-9 * fastest) {
        return Err(refusal(
            "E0610",
            "frame",
            "a plane model needs every body to turn about an axis parallel to e3",
            "let the frame use rotations about e3 and translations in the plane only",
        ));
    }
    Ok(())
}

/// Two meshes of the same bodies would share one load in no determined way.
fn meet_once(scene: &Scene, ids: [BodyId; 2]) -> Result<(), RuntimeError> {
    if ids[0] == ids[1] {
        return Err(refusal(
            "E0652",
            "second",
            "a body cannot mesh with itself",
            "give the other body; several bodies may share one gear",
        ));
    }
    if scene.pairs.iter().any(|pair| ids.iter().all(|id| pair.bodies.contains(id))) {
        let [first, second] = ids.map(|id| scene.bodies.get(id.0).map_or("", |body| &body.name));
        return Err(refusal(
            "E0652",
            "second",
            &format!("\"{first}\" and \"{second}\" are in mesh already"),
            "keep the mesh that was made before in a variable, and use it again",
        ));
    }
    Ok(())
}

/// Which way the first body pushes: as its moment turns it, else against the second one's moment, else as it moves.
fn drive_sense(first: &Body, second: &Body, speed: f64) -> f64 {
    let moments = [first.moment[2], second.moment[2], speed];
    // External gears turn against each other, so a moment on the second one asks for the same surfaces.
    moments.into_iter().find(|&moment| moment != 0.0).map_or(1.0, f64::signum)
}

fn pose(host: &ModelHost, body: BodyId) -> Result<(PlanePose, f64), RuntimeError> {
    let motion = entry(&host.scene.bodies, Handle(body.0 as u64))?.motion.as_ref();
    Ok((PlanePose::of(motion, 0.0).map_err(engine)?, PlanePose::angular_velocity(motion, 0.0)))
}

fn body_gear(host: &ModelHost, body: BodyId) -> Result<Arc<GearPrototype>, RuntimeError> {
    let gear = entry(&host.body_gears, Handle(body.0 as u64))?;
    Ok(entry(&host.gears, Handle(*gear as u64))?.clone())
}

fn observe(context: &mut Context, observable: Observable) -> Result<Handle, RuntimeError> {
    Ok(Handle(host(context)?.scene.observe(observable).0 as u64))
}

fn host(context: &mut Context) -> Result<&mut ModelHost, RuntimeError> {
    context.host().ok_or_else(|| defect("the gear library was called without its state"))
}

fn entry<T>(table: &[T], handle: Handle) -> Result<&T, RuntimeError> {
    table.get(handle.0 as usize).ok_or_else(|| defect("a handle refers to nothing"))
}

fn defect(message: &str) -> RuntimeError {
    RuntimeError::new("E0799", message, "this is a defect of Calyx; please report it with the model")
}

fn refusal(code: &str, argument: &str, message: &str, help: &str) -> RuntimeError {
    RuntimeError::new(code, message, help).of_argument(argument)
}

/// Findings that stop the model: the first goes to the program, the others to the host.
fn refused(host: &mut ModelHost, errors: &[GeometryError], place: (u32, u32, u32)) -> RuntimeError {
    host.refuse(errors, place).unwrap_or_else(|| defect("a gear was refused without a reason"))
}

/// Findings about a relief are known only where it meets its gear, whose argument for it is `modifications`.
fn of_modifications(errors: Vec<GeometryError>) -> Vec<GeometryError> {
    errors.into_iter().map(|error| GeometryError { argument: "modifications", ..error }).collect()
}

fn engine(error: EngineError) -> RuntimeError {
    let argument = error.argument.map(str::to_owned);
    RuntimeError { argument, ..RuntimeError::new(error.code, error.message, error.help) }
}
