//! Shafts for programs: the Rust side of `shaft`, `mount` and the observables of shafts in
//! `gears.cx`.

use crate::bearing_externs::{GROUND, direction};
use crate::body_externs::{BodyPlacement, named_components};
use crate::dynamics_externs::lumped;
use crate::externs::{self, entry, host, refusal};
use crate::host::{LengthUnit, ModelHost, keep, shown};
use crate::observable_externs::observe;
use crate::shafts::{ModelShaft, Mounted, position_on};
use calyx_abi::externs::{Handle, SymbolicTransform};
use calyx_abi::{Context, RuntimeError};
use calyx_runtime::inertia::Inertia;
use calyx_runtime::load::Wrench;
use calyx_runtime::motion::spatial_pose;
use calyx_runtime::observables::{
    Direction, NominalStress, SectionComponent, ShaftDisplacement, ShaftMoment, ShaftPosition, ShaftReaction,
    ShaftRotation, ShaftStress,
};
use calyx_runtime::scene::BodyId;
use calyx_runtime::shaft::{Shaft, ShaftSegment};
use std::sync::Arc;

/// Distance of a bearing from the axis of a shaft that it is mounted on, relative to the radius of
/// the shaft, from which it is reported.
const BESIDE: f64 = 0.05;
/// First handle of shafts, beyond those of bodies: a shaft is a body to a program.
const SHAFTS: u64 = 1 << 62;

calyx_abi::externs! {
    Pure fn calyx_gears_shaft_segment(
        context, length: f64, diameter: f64, end_diameter: Option<f64>, bore: f64, end_bore: Option<f64>,
        stiffness_diameter: Option<f64>,
    ) -> Handle {
        let segment = ShaftSegment {
            length,
            diameter: [diameter, end_diameter.unwrap_or(diameter)],
            bore: [bore, end_bore.unwrap_or(bore)],
            stiffness_diameter,
        };
        segment.check().map_err(externs::engine)?;
        Ok(keep(&mut host(context)?.shaft_segments, segment))
    }

    Scene fn calyx_gears_shaft(
        context, name: String, segments: Vec<Handle>, material: Handle, frame: SymbolicTransform,
        free: Vec<String>, elastic: bool, prescribed_rotation_at: Option<f64>, sections: Vec<f64>,
    ) -> Handle {
        externs::before_analysis(context, format_args!("the shaft \"{name}\""))?;
        let free = named_components(&free)?;
        let name = context.name_in_instance(name);
        let (place, params) = (context.place, context.params.clone());
        let host = host(context)?;
        let material = *entry(&host.materials, material)?;
        let segments = segments
            .into_iter()
            .map(|segment| entry(&host.shaft_segments, segment).copied())
            .collect::<Result<Vec<_>, _>>()?;
        let shaft = Arc::new(Shaft::new(segments, material).map_err(externs::engine)?);
        let expression = frame.0.clone();
        let motion = BodyPlacement::motion(frame, params);
        let unit = host.length_unit;
        let checked = |at| on_shaft("prescribed_rotation_at", &name, &shaft, at, unit);
        let prescribed = prescribed_rotation_at.map(checked).transpose()?;
        let added = ModelShaft::add(&mut host.scene, name, (shaft, !elastic), motion, (free, prescribed));
        let shaft = added.map_err(|refused| host.rejected(refused, place))?;
        host.body_frames.push(expression);
        host.body_gears.push(None);
        host.body_places.push(place);
        host.shafts.push(shaft);
        let index = host.shafts.len() - 1;
        complete_bodies(host, index, place);
        for at in sections {
            let at = checked_position(host, index, "sections", at)?;
            section(host, index, at, place)?;
        }
        Ok(Handle(SHAFTS + index as u64))
    }

    /// Position on a shaft of the origin of its body's frame.
    Scene fn calyx_gears_shaft_origin(context, shaft: Handle) -> f64 {
        let index = shaft_index(context, "on", shaft)?;
        Ok(host(context)?.shafts[index].origin)
    }

    Scene fn calyx_gears_mounted_gear(
        context, name: String, blank: Handle, on: Handle, at: f64, hub_width: f64, force: [f64; 3],
        moment: [f64; 3], mass: f64, inertia: f64, host_load: Option<String>, frame: SymbolicTransform,
    ) -> Handle {
        externs::before_analysis(context, format_args!("the gear \"{name}\""))?;
        let index = shaft_index(context, "on", on)?;
        let gear = entry(&host(context)?.gears, blank)?.clone();
        let (prototype, added) = (gear.prototype(), lumped(mass, inertia)?);
        let name = context.name_in_instance(name);
        let (place, host) = (context.place, host(context)?);
        let load = BodyPlacement::load(host, Wrench { force, moment }, host_load.as_deref(), place);
        let unit = host.length_unit;
        let joint = at + gear.mid_bore();
        let mounted = Mounted { name: name.clone(), prototype, at, joint, hub_width, load, added };
        let ModelHost { scene, shafts, body_gears, .. } = host;
        let toothed = |body: BodyId| body_gears.get(body.0).is_some_and(Option::is_some);
        let result = shafts[index].mount(scene, mounted, toothed, |metres| shown(metres, unit));
        let mounted = result.map_err(|refused| host.rejected(refused, place))?;
        if let Some(gear) = gear.cylindrical() {
            let face = (at, gear.face_width);
            let added = host.shafts[index].add_face((&name, &gear.form()), face, |metres| shown(metres, unit));
            added.map_err(|error| host.rejected(error.into(), place))?;
        }
        complete_bodies(host, index, place);
        let BodyId(body) = mounted.body;
        host.body_gears[body] = Some(blank.0 as usize);
        host.body_frames[body] = frame.0;
        host.body_places[body] = place;
        if host_load.is_some() {
            host.host_loaded.insert(body);
        }
        Ok(Handle(body as u64))
    }

    Scene fn calyx_gears_shaft_load(
        context, shaft: Handle, at: f64, force: [f64; 3], moment: [f64; 3], host_load: Option<String>,
    ) -> () {
        externs::before_analysis(context, "a load on the shaft")?;
        let index = shaft_index(context, "shaft", shaft)?;
        let (place, host) = (context.place, host(context)?);
        let at = checked_position(host, index, "at", at)?;
        let load = BodyPlacement::load(host, Wrench { force, moment }, host_load.as_deref(), place);
        let (unit, shaft) = (host.length_unit, host.shafts[index].clone());
        let loaded = shaft.load(&mut host.scene, (at, load), |metres| shown(metres, unit));
        let BodyId(body) = loaded.map_err(|refused| host.rejected(refused, place))?;
        complete_bodies(host, index, place);
        if host_load.is_some() {
            host.host_loaded.insert(body);
        }
        Ok(())
    }

    Scene fn calyx_gears_shaft_disc(
        context, shaft: Handle, at: f64, mass: f64, inertia: f64, diametral_inertia: Option<f64>,
    ) -> () {
        externs::before_analysis(context, "a disc on the shaft")?;
        let index = shaft_index(context, "shaft", shaft)?;
        lumped(mass, inertia)?;
        let (place, host) = (context.place, host(context)?);
        let at = checked_position(host, index, "at", at)?;
        let disc = Inertia::axial(mass, inertia, diametral_inertia.unwrap_or(0.5 * inertia));
        let (unit, shaft) = (host.length_unit, host.shafts[index].clone());
        let added = shaft.disc(&mut host.scene, (at, disc), |metres| shown(metres, unit));
        added.map_err(|refused| host.rejected(refused, place))?;
        complete_bodies(host, index, place);
        Ok(())
    }

    Scene fn calyx_gears_shaft_displacement(context, shaft: Handle, at: f64, axis: String) -> Handle {
        let position = shaft_position(context, shaft, at)?;
        observe(context, ShaftDisplacement(position, direction(&axis)))
    }

    Scene fn calyx_gears_shaft_rotation(context, shaft: Handle, at: f64, axis: String) -> Handle {
        let position = shaft_position(context, shaft, at)?;
        observe(context, ShaftRotation(position, direction(&axis)))
    }

    Scene fn calyx_gears_shaft_moment(context, shaft: Handle, at: f64, component: String) -> Handle {
        elastic(context, shaft)?;
        let position = shaft_position(context, shaft, at)?;
        let component =
            if component == "torque" { SectionComponent::Torque } else { SectionComponent::Bending };
        observe(context, ShaftMoment(position, component))
    }

    Scene fn calyx_gears_shaft_stress(context, shaft: Handle, at: Option<f64>, component: String) -> Handle {
        elastic(context, shaft)?;
        let ShaftPosition { shaft, body, at: position } = shaft_position(context, shaft, at.unwrap_or(0.0))?;
        let stress = match component.as_str() {
            "bending" => NominalStress::Bending,
            "torsion" => NominalStress::Torsion,
            _ => NominalStress::Equivalent,
        };
        observe(context, ShaftStress { shaft, body, at: at.map(|_| position), stress })
    }
}

fn on_shaft(
    argument: &'static str,
    name: &str,
    shaft: &Shaft,
    at: f64,
    unit: LengthUnit,
) -> Result<f64, RuntimeError> {
    position_on(shaft, name, (argument, at), |metres| shown(metres, unit)).map_err(externs::engine)
}

/// Returns the index of the shaft that is given as an argument.
///
/// # Errors
/// E0949: the body is not a shaft.
fn shaft_index(context: &mut Context, argument: &str, handle: Handle) -> Result<usize, RuntimeError> {
    if let Some(index) = as_shaft(host(context)?, handle) {
        return Ok(index);
    }
    let name = match handle == GROUND {
        true => "ground".to_owned(),
        false => {
            let BodyId(body) = externs::body(context, argument, handle)?;
            format!("\"{}\"", host(context)?.scene.bodies[body].name)
        }
    };
    let message = format!("{name} is not a shaft");
    Err(refusal("E0949", argument, &message, "give what `gears.shaft` returned"))
}

/// Returns the index of a shaft by its handle; `None` for the handle of another body.
pub(crate) fn as_shaft(host: &ModelHost, handle: Handle) -> Option<usize> {
    let index = usize::try_from(handle.0.checked_sub(SHAFTS)?).ok()?;
    (handle != GROUND && index < host.shafts.len()).then_some(index)
}

/// Checks that a shaft is modelled as elastic.
fn elastic(context: &mut Context, shaft: Handle) -> Result<(), RuntimeError> {
    let index = shaft_index(context, "shaft", shaft)?;
    let shaft = &host(context)?.shafts[index];
    if !shaft.rigid {
        return Ok(());
    }
    let message = format!("the shaft \"{}\" is rigid, so the forces in its sections are unknown", shaft.name);
    Err(refusal("E0949", "shaft", &message, "model it as elastic, `elastic = TRUE`, or leave the output out"))
}

fn checked_position(
    host: &ModelHost,
    index: usize,
    argument: &'static str,
    at: f64,
) -> Result<f64, RuntimeError> {
    let ModelShaft { name, shaft, .. } = &host.shafts[index];
    on_shaft(argument, name, shaft, at, host.length_unit)
}

fn shaft_position(context: &mut Context, shaft: Handle, at: f64) -> Result<ShaftPosition, RuntimeError> {
    let index = shaft_index(context, "shaft", shaft)?;
    let host = host(context)?;
    let at = checked_position(host, index, "at", at)?;
    let ModelShaft { body, connection, .. } = host.shafts[index];
    Ok(ShaftPosition { shaft: connection, body, at })
}

/// Completes the tables of bodies after a shaft has added sections.
fn complete_bodies(host: &mut ModelHost, index: usize, place: (u32, u32, u32)) {
    let expression = host.body_frames[host.shafts[index].body.0].clone();
    let count = host.scene.bodies.len();
    host.body_frames.resize(count, expression);
    host.body_gears.resize(count, None);
    host.body_places.resize(count, place);
}

/// Returns the body at a position of a shaft, and the position in its frame along the axis.
fn section(
    host: &mut ModelHost,
    index: usize,
    at: f64,
    place: (u32, u32, u32),
) -> Result<(BodyId, f64), RuntimeError> {
    let (unit, shaft) = (host.length_unit, host.shafts[index].clone());
    let found = shaft.section(&mut host.scene, at, |metres| shown(metres, unit));
    let found = found.map_err(|refused| host.rejected(refused, place))?;
    complete_bodies(host, index, place);
    Ok(found)
}

/// Body and position of the first race of a bearing: on a shaft it is the section at `at`.
pub(crate) fn bearing_seat(
    context: &mut Context,
    body: Handle,
    at: [f64; 3],
) -> Result<(BodyId, [f64; 3]), RuntimeError> {
    let place = context.place;
    let Some(index) = as_shaft(host(context)?, body) else {
        return Ok((externs::body(context, "body", body)?, at));
    };
    let host = host(context)?;
    let [x, y, z] = at;
    if x != 0.0 || y != 0.0 {
        let message = format!("the bearing is beside the axis of the shaft \"{}\"", host.shafts[index].name);
        return Err(refusal(
            "E0859",
            "at",
            &message,
            "give the position along e3, such as `at = 10 mm * e3`",
        ));
    }
    let z = checked_position(host, index, "at", z)?;
    let (body, offset) = section(host, index, z, place)?;
    Ok((body, [0.0, 0.0, offset]))
}

/// Body of the second race of a bearing whose first race is at a position in the frame of a body:
/// on a shaft it is the section next to it.
pub(crate) fn bearing_mounting(
    context: &mut Context,
    to: Handle,
    (first, at): (BodyId, [f64; 3]),
) -> Result<BodyId, RuntimeError> {
    let place = context.place;
    let Some(index) = as_shaft(host(context)?, to) else { return externs::body(context, "to", to) };
    let host = host(context)?;
    let pose = spatial_pose(host.scene.bodies[first.0].motion.as_ref(), 0.0).map_err(externs::engine)?;
    let point = host.shafts[index].position_of(&host.scene, pose.point(at)).map_err(externs::engine)?;
    let z = checked_position(host, index, "to", point.position)?;
    let ModelShaft { name, shaft, .. } = &host.shafts[index];
    let radius = 0.5 * shaft.largest_diameter();
    if point.beside > BESIDE * radius {
        let message = format!(
            "the bearing is {} off the axis of the shaft \"{name}\", whose largest radius is {}",
            shown(point.beside, host.length_unit),
            shown(radius, host.length_unit)
        );
        let help = "correct the frames or `at`, unless a rigid arm of this length on the shaft is intended";
        host.warn("E0993", message, help, place);
    }
    Ok(section(host, index, z, place)?.0)
}

/// Displacement or rotation of a shaft at its origin along a ground axis, if the handle is that of
/// a shaft: its body may have another origin.
pub(crate) fn observe_shaft(
    context: &mut Context,
    handle: Handle,
    axis: usize,
    rotation: bool,
) -> Result<Option<Handle>, RuntimeError> {
    if as_shaft(host(context)?, handle).is_none() {
        return Ok(None);
    }
    let position = shaft_position(context, handle, 0.0)?;
    let axis = Direction::Ground(axis);
    match rotation {
        true => observe(context, ShaftRotation(position, axis)).map(Some),
        false => observe(context, ShaftDisplacement(position, axis)).map(Some),
    }
}

/// Reaction of the constraints of a shaft along or about a ground axis, if the handle is that of a
/// shaft.
pub(crate) fn observe_reaction(
    context: &mut Context,
    handle: Handle,
    axis: usize,
    moment: bool,
) -> Result<Option<Handle>, RuntimeError> {
    if as_shaft(host(context)?, handle).is_none() {
        return Ok(None);
    }
    let about = shaft_position(context, handle, 0.0)?;
    observe(context, ShaftReaction { about, moment, axis }).map(Some)
}
