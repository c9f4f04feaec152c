//! Restraint check: rejects scenes in which a free motion meets no resistance, before anything is
//! solved.
//!
//! The contact forces of an involute mesh act along one line, regardless of the number of teeth in
//! contact; on general axes they act about along the common normal at the first contact. Each mesh
//! therefore constrains one combination of DOFs in one sense. Whether these constraints can balance
//! the load is a small contact problem of its own.
//!
//! See `docs/theory/equilibrium.md`.

mod one_sided;
mod unresisted;

use calyx_contact::problem::{ContactError, FreeMotion};
use calyx_contact::unloaded_equilibrium::{UnloadedEquilibrium, unloaded_equilibrium};
use calyx_model::bearing::{Bearing, springs};
use calyx_model::connection::add_connection_stiffness;
use calyx_model::connection_building::connections_as_links;
use calyx_model::dof::DOF_NAMES;
use calyx_model::dof::Dof;
use calyx_model::flanks::{add_flanks, spline_contacts};
use calyx_model::frames::{axes, loads_on, number_dofs, solid_pose};
use calyx_model::ids::BodyId;
use calyx_model::mechanism::Mechanism;
use calyx_model::mesh_carrier::MeshAxes;
use calyx_model::motion::axle;
use calyx_model::pairs::{FirstContact, SurfacePair};
use calyx_model::plan::Plan;
use calyx_numerics::error::{EngineError, Subject};
use calyx_numerics::interrupt::Interrupt;
use calyx_numerics::vec3::{cross, dot, minus};
use std::f64::consts::PI;
use unresisted::Teeth;

/// Other parts of a rotation about the own axis, relative to it, that count as rounding.
const SPIN_ROUNDING: f64 = 1e-9;

/// Checks that nominal contact resists every free motion of the planned bodies under the loads at a
/// time (s), that of the first position to solve.
///
/// # Errors
/// Those that solving this position would return: E0714 if a load drives a body away, E0715 if
/// nothing resists a motion, E0729 if a body can leave its bearings along the axis, E0723 if a load
/// is NaN. Also those of the interrupt, because the check of many bodies takes long.
pub fn check(scene: &Mechanism, plan: &Plan, time: f64, interrupt: &Interrupt) -> Result<(), EngineError> {
    let dofs = number_dofs(scene, plan);
    if dofs.is_empty() {
        return Ok(());
    }
    one_sided::check(scene, plan, &dofs, time)?;
    let mut springs = {
        let planned = plan.modelled_bearings();
        springs(&scene.bodies, &scene.bearings, &planned, &dofs, |_| 1.0, time, &[])?
    };
    // Elastic bodies are not condensed for the check.
    let connections = connections_as_links(scene)?;
    let connections = (&scene.bodies[..], &connections[..]);
    let planned = plan.modelled_connections();
    add_connection_stiffness(&mut springs.stiffness, connections, &planned, &dofs, |_| 1.0, time)?;
    for (body, contact) in &spline_contacts(scene, plan) {
        add_flanks(&mut springs, scene, (*body, contact), &dofs, time, None)?;
    }
    let mut load = loads_on(scene, &dofs, time, 1.0)?;
    for (load, own) in load.iter_mut().zip(&springs.load) {
        *load += own;
    }
    let unloaded = unloaded_equilibrium(&springs.stiffness, &load);
    // Resistance of teeth against axial and out-of-plane motion depends on the distribution of
    // contact along the face, which only the solution shows. Some motions meet no teeth at all.
    let out_of_plane = |free: &Vec<f64>| {
        dofs.iter().zip(free).any(|(dof, part)| (2..5).contains(&dof.component) && *part != 0.0)
    };
    if plan.three_dimensional && unloaded.free.iter().any(out_of_plane) {
        let teeth = Teeth { scene, plan, dofs: &dofs, stops: &springs.arms, time };
        if let Some(motion) = teeth.unresisted_motion(&unloaded.free, &load)? {
            return Err(explain(scene, &dofs, &unresisted::error(motion, &dofs, &load)));
        }
        let driven = if unloaded.balanced { None } else { teeth.driven(&unloaded, &load, interrupt)? };
        return driven.map_or(Ok(()), |error| Err(explain(scene, &dofs, &error)));
    }
    if unloaded.balanced
        && springs.gaps.is_empty()
        && spins_freely(scene, &left_out(plan), &dofs, &unloaded.free)
    {
        return Ok(());
    }
    // Count stops of bearings as closed: behind their clearances they resist like teeth.
    let mut arms = springs.arms;
    let mut contacts = springs.gaps.len();
    let taking_part = |pair: &&SurfacePair| pair.bodies.iter().all(|body| !plan.bodies[body.0].left_out);
    for pair in scene.pairs.iter().filter(taking_part) {
        // Surfaces that are not gear flanks have no nominal contact; only the solution shows their
        // resistance.
        let Some(row) = nominal_arms(scene, pair, &dofs, time)? else { return Ok(()) };
        arms.extend(row);
        contacts += 1;
    }
    if unloaded.balanced {
        load = drive_direction(scene, &dofs);
    }
    let without_motion = UnloadedEquilibrium { motion: vec![0.0; dofs.len()], ..unloaded };
    match without_motion.rigid_limit(&vec![0.0; contacts], &arms, &load, interrupt) {
        Err(
            error @ (ContactError::Infeasible(_)
            | ContactError::Unconstrained(_)
            | ContactError::Interrupted(_)),
        ) => Err(explain(scene, &dofs, &error)),
        // Any other result depends on the positions of the teeth.
        _ => Ok(()),
    }
}

fn left_out(plan: &Plan) -> Vec<bool> {
    plan.bodies.iter().map(|body| body.left_out).collect()
}

/// Returns whether motions that strain no spring are rotations of bodies about their own axes, and
/// no surface pair takes part: a rotor rotates freely in its bearings. Its angle has no effect on
/// anything else.
pub fn spins_freely(scene: &Mechanism, left_out: &[bool], dofs: &[Dof], free: &[Vec<f64>]) -> bool {
    let takes_part = |pair: &SurfacePair| pair.bodies.iter().all(|body| !left_out[body.0]);
    let spins = |motion: &Vec<f64>| {
        let largest = |of_axis: bool| {
            let parts = dofs.iter().zip(motion).filter(|(dof, _)| (dof.component == 5) == of_axis);
            parts.map(|(_, part)| part.abs()).fold(0.0, f64::max)
        };
        // Rotations in radians against displacements in metres and tilts.
        largest(false) <= SPIN_ROUNDING * largest(true)
    };
    !scene.pairs.iter().any(takes_part) && free.iter().all(spins)
}

/// Returns the work of a unit force along the line of action on each DOF, at a time (s).
fn nominal_arms(
    scene: &Mechanism,
    pair: &SurfacePair,
    dofs: &[Dof],
    time: f64,
) -> Result<Option<Vec<f64>>, EngineError> {
    let Some(mesh) = &pair.mesh else { return Ok(None) };
    let bodies = pair.bodies.map(|body| body.0);
    if let Some(first_contact) = mesh.first_contact {
        let contact = match mesh.carrier == [0.0; 3] {
            true => first_contact,
            false => carried_contact(scene, pair, first_contact, time)?,
        };
        return arms_along_normal(scene, bodies, dofs, time, contact).map(Some);
    }
    let [first, second] =
        [solid_pose(scene, bodies[0], time)?.origin, solid_pose(scene, bodies[1], time)?.origin];
    let [x, y, _] = axes(scene, bodies[0], time);
    let across = [x, y].map(|direction| dot(direction, minus(second, first)));
    let [radius, mate] = mesh.base_radii;
    let cosine = (radius + mesh.sign * mate).abs() / across[0].hypot(across[1]);
    if !(0.0..=1.0).contains(&cosine) {
        return Ok(None);
    }
    // A gear that drives counter-clockwise pushes its mate at a right angle to the line of centres,
    // inclined outwards by the pressure angle. In an internal mesh the teeth touch on the side of
    // the planet away from the ring's axis.
    let sense = mesh.drive_sense;
    let contact = across[1].atan2(across[0]) + if mesh.sign < 0.0 { PI } else { 0.0 };
    let angle = contact + sense * cosine.asin();
    let normal = [angle.cos(), angle.sin()];
    let arm = |dof: &Dof| {
        let (side, turn) = match dof.body {
            body if body == bodies[0] => (-1.0, -sense * radius),
            body if body == bodies[1] => (1.0, -sense * mesh.sign * mate),
            _ => return 0.0,
        };
        match dof.component {
            component @ 0..2 => side * normal[component],
            5 => turn,
            _ => 0.0,
        }
    };
    Ok(Some(dofs.iter().map(arm).collect()))
}

/// Returns the contact of rigid flanks at time 0 where the carrier of the mesh has moved it at a
/// time (s).
fn carried_contact(
    scene: &Mechanism,
    pair: &SurfacePair,
    first_contact: FirstContact,
    time: f64,
) -> Result<FirstContact, EngineError> {
    let motions = pair.bodies.map(|body| scene.bodies[body.0].motion.as_ref());
    let [start, now] =
        [MeshAxes::at(motions, 0.0)?.carrier_pose(), MeshAxes::at(motions, time)?.carrier_pose()];
    let on_carrier = |v: [f64; 3]| [0, 1, 2].map(|k: usize| dot(start.rotation.map(|row| row[k]), v));
    Ok(FirstContact {
        point: now.point(on_carrier(minus(first_contact.point, start.origin))),
        normal: now.direction(on_carrier(first_contact.normal)),
    })
}

/// Returns the work of a unit force at a point (m) along a normal out of the first of two bodies on
/// each DOF, at a time (s).
fn arms_along_normal(
    scene: &Mechanism,
    bodies: [usize; 2],
    dofs: &[Dof],
    time: f64,
    FirstContact { point, normal }: FirstContact,
) -> Result<Vec<f64>, EngineError> {
    let arm = |dof: &Dof| {
        let Some(side) = bodies.iter().position(|body| *body == dof.body) else { return Ok(0.0) };
        let origin = solid_pose(scene, dof.body, time)?.point(axle(scene.bodies[dof.body].motion.as_ref()));
        let axis = axes(scene, dof.body, time)[dof.component % 3];
        let direction = if dof.component < 3 { axis } else { cross(axis, minus(point, origin)) };
        let along = dot(normal, direction);
        Ok(if side == 0 { -along } else { along })
    };
    dofs.iter().map(arm).collect()
}

/// Returns the load direction of the rigid-body limit of an unloaded system: the drive direction of
/// the meshes.
pub fn drive_direction(scene: &Mechanism, dofs: &[Dof]) -> Vec<f64> {
    let mut direction = vec![0.0; dofs.len()];
    for pair in &scene.pairs {
        // Coast flanks do not drive a mesh.
        let Some(mesh) = pair.mesh.as_ref().filter(|_| pair.front.is_none()) else { continue };
        for (side, sign) in [(0, 1.0), (1, mesh.sign)] {
            let turn = Dof { body: pair.bodies[side].0, component: 5 };
            if let Some(at) = dofs.iter().position(|dof| *dof == turn) {
                direction[at] = sign * mesh.drive_sense;
            }
        }
    }
    direction
}

/// DOFs with less than this fraction of the largest motion are not named in messages.
const TAKES_PART: f64 = 1e-3;

/// Converts an error of the contact solver into terms of the model.
pub fn explain(scene: &Mechanism, dofs: &[Dof], error: &ContactError) -> EngineError {
    let named = |motion: &FreeMotion| motion_name(scene, dofs, &motion.motion);
    // If an elastic body of any shape moves, bodies on it move along.
    let on_elastic_body =
        |dof: &Dof| scene.connections_of(BodyId(dof.body)).any(|connection| connection.body.is_some());
    let about = |error: EngineError, motion: &FreeMotion| {
        let moving = moving_dofs(scene, dofs, &motion.motion);
        let first = moving.into_iter().map(|at| &dofs[at]).find(|dof| on_elastic_body(dof));
        match first.or(dofs.get(motion.dof)) {
            Some(dof) => error.about(Subject::Body(dof.body)).blame("free"),
            None => error,
        }
    };
    let help = |motion: &FreeMotion, other: &str| {
        let moving = moving_dofs(scene, dofs, &motion.motion);
        // Along its helix a gear rotates as well.
        let is_axial = moving.iter().all(|&at| matches!(dofs[at].component, 2 | 5))
            && moving.iter().any(|&at| dofs[at].component == 2);
        let on_bearings =
            |bearing: &Bearing| bearing.bodies().any(|body| moving.iter().any(|&at| dofs[at].body == body.0));
        let tilts = moving.iter().any(|&at| matches!(dofs[at].component, 3 | 4));
        if tilts && is_on_one_bearing(scene, &moving.iter().map(|&at| dofs[at].body).collect::<Vec<_>>()) {
            return "add a second radial bearing at a distance from the first one, or `tilting_stiffness` of the bearing: a radial bearing supports no tilting. Or remove \"theta_x\" and \"theta_y\" from `free`".to_owned();
        }
        match is_axial && scene.bearings.iter().any(on_bearings) {
            true => "support the body along its axis by a bearing that carries axial force: `axial_stiffness` of a `bearing`, or a ball or tapered roller bearing; cylindrical roller and needle bearings carry none. Or remove \"u_z\" from `free`".to_owned(),
            false => other.to_owned(),
        }
    };
    match error {
        ContactError::Infeasible(motion) => about(
            EngineError::new(
                "E0714",
                format!("no contact can balance the load: it drives {}", named(motion)),
                help(
                    motion,
                    "constrain this degree of freedom (remove it from `free`) or add a bearing, or check the sign of the load and that the teeth are in mesh; a reversing load needs `coast_side_contact = TRUE` in `gears.mesh`",
                ),
            ),
            motion,
        ),
        ContactError::Unconstrained(motion) => about(
            EngineError::new(
                "E0715",
                format!("nothing constrains {}", named(motion)),
                help(
                    motion,
                    "constrain this degree of freedom (remove it from `free`), add a bearing, or apply a load",
                ),
            ),
            motion,
        ),
        ContactError::DependentCells { cell } => EngineError::new(
            "E0716",
            format!("the gap equations are not independent of each other at contact cell {cell}"),
            "let at least one of the two bodies be elastic, and let no two surface pairs describe the same contact",
        ),
        ContactError::Jammed => EngineError::new(
            "E0717",
            "the bodies overlap in every position",
            "move the frames apart; look at centre distance, thickness and pitch errors",
        ),
        ContactError::Invalid(what) => {
            EngineError::new("E0718", format!("the contact problem is unusable: {what}"), "")
        }
        ContactError::Interrupted(error) => error.clone(),
        ContactError::NotConverged => EngineError::new(
            "E0719",
            "the contact solver found no solution",
            "please report the model: this should not happen",
        ),
    }
}

/// Returns whether all bearings of these bodies, and there is one, are at one position.
fn is_on_one_bearing(scene: &Mechanism, bodies: &[usize]) -> bool {
    let moves = |bearing: &&Bearing| bearing.bodies().any(|body| bodies.contains(&body.0));
    let mut places = scene.bearings.iter().filter(moves).map(|bearing| (bearing.body, bearing.at));
    let Some(first) = places.next() else { return false };
    places.all(|place| place == first)
}

/// Returns the DOFs that take part in a motion.
fn moving_dofs(scene: &Mechanism, dofs: &[Dof], motion: &[f64]) -> Vec<usize> {
    // Compare rotations with displacements by the displacement at the rim.
    let size = |at: usize| {
        let Dof { body, component } = dofs[at];
        let radius = scene.bodies[body].prototype.enclosing_radius();
        motion[at].abs() * if component < 3 { 1.0 } else { radius }
    };
    let largest = (0..motion.len()).map(size).fold(0.0, f64::max);
    (0..motion.len()).filter(|&at| size(at) > TAKES_PART * largest).collect()
}

/// Describes a motion in words: every DOF that takes part, with its sense.
fn motion_name(scene: &Mechanism, dofs: &[Dof], motion: &[f64]) -> String {
    let moving = moving_dofs(scene, dofs, motion);
    // One section of a shaft stands for the others that move in the same sense.
    let repeated = |at: usize| {
        let Dof { body, component } = dofs[at];
        let first = scene.connections_of(BodyId(body)).find_map(|connection| connection.bodies().next());
        let same = |other: usize| {
            let named = Dof { body: first.map_or(body, |first| first.0), component };
            dofs[other] == named && moving.contains(&other) && motion[other] * motion[at] > 0.0
        };
        first.is_some_and(|first| first.0 != body) && (0..motion.len()).any(same)
    };
    let parts: Vec<String> = moving
        .iter()
        .copied()
        .filter(|&at| !repeated(at))
        .map(|at| {
            let sense = if motion[at] > 0.0 { "positive" } else { "negative" };
            let Dof { body, component } = dofs[at];
            format!("{} of body \"{}\" in the {sense} sense", DOF_NAMES[component], scene.bodies[body].name)
        })
        .collect();
    parts.join(" and ")
}
