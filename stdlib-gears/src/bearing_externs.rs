//! Bearings for programs: the Rust side of `bearing` and its observables in `gears.cx`.

use crate::externs::{self, before_analysis, entry, host, refusal};
use crate::host::ModelHost;
use crate::observable_externs::observe;
use crate::shaft_externs::{as_shaft, bearing_mounting, bearing_seat};
use calyx_abi::externs::Handle;
use calyx_abi::{Context, RuntimeError};
use calyx_runtime::bearing::{
    Bearing, BearingMatrix, LoadCurve, LoadCurves, NonlinearLoad, Stop, Support, axisymmetric,
};
use calyx_runtime::error::EngineError;
use calyx_runtime::observables::{
    BearingDeflection, BearingForce, BearingMoment, BearingStiffness, BearingTilt, Direction,
};
use calyx_runtime::scene::{BearingId, BodyId};
use std::sync::Arc;

/// Handle of ground, which is not a body of the scene.
pub(crate) const GROUND: Handle = Handle(u64::MAX);

calyx_abi::externs! {
    Pure fn calyx_gears_ground(_context) -> Handle {
        Ok(GROUND)
    }

    Scene fn calyx_gears_bearing(
        context, name: String, body: Handle, to: Handle, at: [f64; 3], radial_stiffness: f64, axial_stiffness: f64,
        tilting_stiffness: f64, torsional_stiffness: f64, radial_clearance: f64, axial_clearance: f64,
        translation_stiffness: Vec<[f64; 3]>, coupling_stiffness: Vec<[f64; 3]>, rotation_stiffness: Vec<[f64; 3]>,
        radial_damping: f64, axial_damping: f64, tilting_damping: f64, torsional_damping: f64,
        unloaded_displacement: [f64; 3], unloaded_rotation: [f64; 3], force: [f64; 3], moment: [f64; 3],
        gap_clearances: Vec<f64>, gap_directions: Vec<[f64; 3]>, gap_arms: Vec<[f64; 3]>, gap_stiffness: f64,
        radial_displacements: Vec<f64>, radial_forces: Vec<f64>, axial_displacements: Vec<f64>, axial_forces: Vec<f64>,
    ) -> Handle {
        let Mounting { name, body, to, at, .. } = Mounting::new(context, name, body, to, at)?;
        for (argument, clearance) in [("radial_clearance", radial_clearance), ("axial_clearance", axial_clearance)] {
            if clearance < 0.0 {
                return Err(refusal("E0688", argument, "a clearance of the bearing is negative",
                    "press the races together by `force`, or by `gap_clearances` below zero"));
            }
        }
        // A bearing with clearance has no stiffness within it.
        let open = |clearance: f64, stiffness: f64| if clearance > 0.0 { 0.0 } else { stiffness };
        let mut stiffness = axisymmetric(
            open(radial_clearance, radial_stiffness),
            open(axial_clearance, axial_stiffness),
            tilting_stiffness,
            torsional_stiffness,
        );
        let blocks = [
            ("translation_stiffness", &translation_stiffness, [0, 0]),
            ("coupling_stiffness", &coupling_stiffness, [0, 3]),
            ("rotation_stiffness", &rotation_stiffness, [3, 3]),
        ];
        for (argument, rows, corner) in blocks {
            add_block(&mut stiffness, argument, rows, corner)?;
        }
        let mut stops = clearances([radial_clearance, axial_clearance], [radial_stiffness, axial_stiffness]);
        stops.extend(gaps(&gap_clearances, &gap_directions, &gap_arms, gap_stiffness)?);
        let curves = LoadCurves {
            radial: radial_curve(radial_displacements, radial_forces)?,
            axial: axial_curve(axial_displacements, axial_forces)?,
            origin: unloaded_displacement,
        };
        let replaced = [
            ("radial_forces", "radial_stiffness", curves.radial.is_some() && radial_stiffness > 0.0),
            ("axial_forces", "axial_stiffness", curves.axial.is_some() && axial_stiffness > 0.0),
        ];
        for (curve, argument, twice) in replaced {
            if twice {
                let message = format!("the bearing has both `{argument}` and a load curve, `{curve}`");
                return Err(refusal("E0996", argument, &message, "give one of them: the curve contains the whole force"));
            }
        }
        let nonlinear = match (&curves.radial, &curves.axial) {
            (None, None) => None,
            _ => Some(NonlinearLoad::Curves(Arc::new(curves))),
        };
        let bearing = Bearing {
            name,
            body,
            to,
            at,
            stiffness,
            damping: axisymmetric(radial_damping, axial_damping, tilting_damping, torsional_damping),
            unloaded: six(unloaded_displacement, unloaded_rotation),
            load: six(force, moment),
            stops,
            nonlinear,
            linearization: None,
        };
        add(context, bearing)
    }

    Scene fn calyx_gears_bearing_force(context, bearing: Handle, axis: String) -> Handle {
        let bearing = self::bearing(context, bearing)?;
        observe(context, BearingForce(bearing, direction(&axis)))
    }

    Scene fn calyx_gears_bearing_moment(context, bearing: Handle, axis: String) -> Handle {
        let bearing = self::bearing(context, bearing)?;
        observe(context, BearingMoment(bearing, direction(&axis)))
    }

    Scene fn calyx_gears_bearing_deflection(context, bearing: Handle, axis: String) -> Handle {
        let bearing = self::bearing(context, bearing)?;
        observe(context, BearingDeflection(bearing, direction(&axis)))
    }

    Scene fn calyx_gears_bearing_tilt(context, bearing: Handle, axis: String) -> Handle {
        let bearing = self::bearing(context, bearing)?;
        observe(context, BearingTilt(bearing, direction(&axis)))
    }

    Scene fn calyx_gears_bearing_stiffness(context, bearing: Handle, force: String, displacement: String) -> Handle {
        stiffness(context, bearing, [component(&force), component(&displacement)])
    }

    Scene fn calyx_gears_bearing_coupling_stiffness(context, bearing: Handle, force: String, rotation: String) -> Handle {
        stiffness(context, bearing, [component(&force), 3 + component(&rotation)])
    }

    Scene fn calyx_gears_bearing_tilting_stiffness(context, bearing: Handle, moment: String, rotation: String) -> Handle {
        stiffness(context, bearing, [3 + component(&moment), 3 + component(&rotation)])
    }
}

/// Checks that the planets that a bearing mounts on a carrier fit into it.
///
/// # Errors
/// Those of [`ModelCarrier::check_planet`](crate::carriers::ModelCarrier::check_planet).
fn check_planets(host: &ModelHost, bearing: &Bearing) -> Result<(), EngineError> {
    let bodies: Vec<BodyId> = bearing.bodies().collect();
    for carrier in host.carriers.iter().filter(|carrier| bodies.iter().any(|&body| carrier.carries(body))) {
        for &body in &bodies {
            let gear = host.body_gears.get(body.0).copied().flatten();
            let gear = gear.and_then(|gear| host.gears.get(gear)?.cylindrical());
            gear.map_or(Ok(()), |gear| carrier.check_planet(&host.scene, body, gear))?;
        }
    }
    Ok(())
}

/// Position of a bearing between a body and its mounting.
pub(crate) struct Mounting {
    /// Name in results.
    pub(crate) name: String,
    /// Body of the first race.
    pub(crate) body: BodyId,
    /// Body or ground of the second race.
    pub(crate) to: Support,
    /// Origin in the coordinates of the first body's frame, m.
    pub(crate) at: [f64; 3],
    /// Index of the shaft that the first body is a section of, and the position on it, m.
    pub(crate) shaft: Option<(usize, f64)>,
    /// Index of the shaft that the second body is a section of.
    pub(crate) to_shaft: Option<usize>,
}

impl Mounting {
    /// Converts the arguments of a bearing.
    ///
    /// # Errors
    /// E0685: both races are on one body. E0859: the position is off the axis of a shaft. A body
    /// does not belong to the scene.
    pub(crate) fn new(
        context: &mut Context,
        name: String,
        body: Handle,
        to: Handle,
        at: [f64; 3],
    ) -> Result<Mounting, RuntimeError> {
        before_analysis(context, format_args!("the bearing \"{name}\""))?;
        if to == body && body != GROUND {
            let message = format!("bearing \"{name}\" has both races on one body");
            let help = "give the other body, or leave `to` out: then the second race is on ground";
            return Err(refusal("E0685", "to", &message, help));
        }
        let [shaft, to_shaft] = [as_shaft(host(context)?, body), as_shaft(host(context)?, to)];
        let shaft = shaft.map(|index| (index, at[2]));
        let (first, at) = bearing_seat(context, body, at)?;
        let to = match to == GROUND {
            true => Support::Ground,
            false => Support::Body(bearing_mounting(context, to, (first, at))?),
        };
        Ok(Mounting { name: context.name_in_instance(name), body: first, to, at, shaft, to_shaft })
    }
}

/// Adds a bearing to the scene.
///
/// # Errors
/// Those of [`Bearing::check`].
pub(crate) fn add(context: &mut Context, bearing: Bearing) -> Result<Handle, RuntimeError> {
    let place = context.place;
    let host = host(context)?;
    let misplaced = host.scene.misplaced(&bearing).map_err(|error| host.rejected(error.into(), place))?;
    let id = host.scene.add_bearing(bearing).map_err(|error| host.rejected(error.into(), place))?;
    check_planets(host, &host.scene.bearings[id.0]).map_err(externs::engine)?;
    if let Some(EngineError { code, message, help, .. }) = misplaced.map(|found| found.error) {
        host.warn(code, message, &help, place);
    }
    host.bearing_places.push(place);
    Ok(Handle(id.0 as u64))
}

/// Returns the bearing of a handle.
pub(crate) fn bearing(context: &mut Context, bearing: Handle) -> Result<BearingId, RuntimeError> {
    entry(&host(context)?.scene.bearings, bearing)?;
    Ok(BearingId(bearing.0 as usize))
}

/// Adds the observable of an entry of the stiffness matrix.
///
/// # Errors
/// E0698: the bearing has stops, whose stiffness changes as they close.
fn stiffness(
    context: &mut Context,
    bearing: Handle,
    [row, column]: [usize; 2],
) -> Result<Handle, RuntimeError> {
    let id = self::bearing(context, bearing)?;
    let own = &host(context)?.scene.bearings[id.0];
    if !own.stops.is_empty() {
        let message = format!("the stiffness of bearing \"{}\" changes as its clearances close", own.name);
        let help =
            "divide forces by deflections instead: `gears.bearing_force` and `gears.bearing_deflection`";
        return Err(refusal("E0698", "bearing", &message, help));
    }
    observe(context, BearingStiffness { bearing: id, row, column })
}

/// Index of an axis by its declared name.
fn component(axis: &str) -> usize {
    match axis {
        "x" => 0,
        "y" => 1,
        _ => 2,
    }
}

/// Direction by its declared name.
pub(crate) fn direction(axis: &str) -> Direction {
    match axis {
        "axial" => Direction::Axial,
        "radial" => Direction::Radial,
        "x" => Direction::Ground(0),
        "y" => Direction::Ground(1),
        _ => Direction::Ground(2),
    }
}

fn six([a, b, c]: [f64; 3], [d, e, f]: [f64; 3]) -> [f64; 6] {
    [a, b, c, d, e, f]
}

/// Adds a block of three rows, and its transpose off the diagonal.
fn add_block(
    matrix: &mut BearingMatrix,
    argument: &str,
    rows: &[[f64; 3]],
    [top, left]: [usize; 2],
) -> Result<(), RuntimeError> {
    if !(rows.is_empty() || rows.len() == 3) {
        let message = format!("`{argument}` has {} rows", rows.len());
        let help = "a block of a bearing's matrix has three rows, one for each axis, each a vector";
        return Err(refusal("E0686", argument, &message, help));
    }
    for (i, row) in rows.iter().enumerate() {
        for (j, entry) in row.iter().enumerate() {
            matrix[top + i][left + j] += entry;
            if top != left {
                matrix[left + j][top + i] += entry;
            }
        }
    }
    Ok(())
}

/// Stops from the total clearance between both sides; half of it lies on either side of the middle.
fn clearances([radial, axial]: [f64; 2], [radial_stiffness, axial_stiffness]: [f64; 2]) -> Vec<Stop> {
    let mut stops = Vec::new();
    if radial > 0.0 {
        stops.push(Stop::Ring { clearance: 0.5 * radial, stiffness: radial_stiffness });
    }
    if axial > 0.0 {
        for side in [1.0, -1.0] {
            let direction = [0.0, 0.0, side, 0.0, 0.0, 0.0];
            stops.push(Stop::Wall { clearance: 0.5 * axial, direction, stiffness: axial_stiffness });
        }
    }
    stops
}

/// Returns the load curve across the axis; `None` without points.
fn radial_curve(displacements: Vec<f64>, forces: Vec<f64>) -> Result<Option<LoadCurve>, RuntimeError> {
    if displacements.is_empty() && forces.is_empty() {
        return Ok(None);
    }
    let curve =
        LoadCurve::new(displacements, forces).map_err(|error| of_curve(error, "radial_displacements"))?;
    // A curve for all directions is one for both sides.
    curve.mirrored().map_err(|error| of_curve(error, "radial_displacements"))?;
    Ok(Some(curve))
}

/// Returns the load curve along the axis: as given, or for both sides if no displacement is
/// negative; `None` without points.
fn axial_curve(displacements: Vec<f64>, forces: Vec<f64>) -> Result<Option<LoadCurve>, RuntimeError> {
    if displacements.is_empty() && forces.is_empty() {
        return Ok(None);
    }
    let both_sides = !displacements.iter().any(|displacement| *displacement < 0.0);
    let curve = LoadCurve::new(displacements, forces);
    let curve = if both_sides { curve.and_then(|curve| curve.mirrored()) } else { curve };
    curve.map(Some).map_err(|error| of_curve(error, "axial_displacements"))
}

fn of_curve(error: EngineError, argument: &str) -> RuntimeError {
    refusal(error.code, argument, &error.message, &error.help)
}

fn gaps(
    clearances: &[f64],
    directions: &[[f64; 3]],
    arms: &[[f64; 3]],
    stiffness: f64,
) -> Result<Vec<Stop>, RuntimeError> {
    let refuse = |argument, count: usize| {
        let message =
            format!("`{argument}` has {count} entries, and `gap_clearances` has {}", clearances.len());
        Err(refusal(
            "E0688",
            argument,
            &message,
            "each gap has a clearance and a direction, and an arm if any has one",
        ))
    };
    if directions.len() != clearances.len() {
        return refuse("gap_directions", directions.len());
    }
    if !(arms.is_empty() || arms.len() == clearances.len()) {
        return refuse("gap_arms", arms.len());
    }
    let wall = |(index, (&clearance, &direction)): (usize, (&f64, &[f64; 3]))| {
        let arm = arms.get(index).copied().unwrap_or_default();
        Stop::Wall { clearance, direction: six(direction, arm), stiffness }
    };
    Ok(clearances.iter().zip(directions).enumerate().map(wall).collect())
}
