//! Rolling bearings for programs: the Rust side of `ball_bearing`, `tapered_roller_bearing` and the
//! other rolling bearings of `gears.cx`.

use crate::bearing_externs::{Mounting, bearing};
use crate::bearing_sizes::{self, Boundary};
use crate::externs::{self, entry, host, refusal};
use crate::observable_externs::observe;
use calyx_abi::externs::Handle;
use calyx_abi::{Context, RuntimeError};
use calyx_runtime::bearing::{Bearing, BearingState, NonlinearLoad, RollingElements, Support};
use calyx_runtime::motion::angular_velocity;
use calyx_runtime::observables::{
    BearingFriction, BearingLife, BearingPressure, LoadedElements, MaxElementLoad, RollingElementLoad,
    StaticSafety,
};
use calyx_runtime::rolling::rating::{FrictionCoefficients, LifeConditions, LoadDirection};
use calyx_runtime::rolling::{
    Arrangement, BallGeometry, BallKind, BallRow, Elements, Material, Motion, Profile, Rib, RollerGeometry,
    RollerKind, RollerRow, RollingBearing, RollingError, Row,
};
use calyx_runtime::scene::{BearingId, BodyId};
use calyx_runtime::vec3::dot;
use std::f64::consts::TAU;
use std::sync::Arc;

calyx_abi::externs! {
    Scene fn calyx_gears_ball_bearing(
        context, name: String, body: Handle, to: Handle, at: [f64; 3], count: f64, ball_diameter: f64,
        pitch_diameter: f64, inner_conformity: f64, outer_conformity: f64, clearance: f64, ring: String,
        azimuth: f64, inner_speed: f64, outer_speed: f64, ring_material: Option<Handle>,
        element_material: Option<Handle>, linearized_at: Option<[f64; 3]>,
    ) -> Handle {
        let mounting = Mounting::new(context, name, body, to, at)?;
        let conformities = [inner_conformity, outer_conformity];
        let kind = BallKind::DeepGroove { clearance };
        let size = (count, ball_diameter, pitch_diameter);
        let row = balls(context, kind, size, conformities, [ring_material, element_material])?;
        let operation = Operation::new(&ring, azimuth, [inner_speed, outer_speed], "clearance").linearized(linearized_at);
        add(context, mounting, RollingBearing::single(row), &operation, None)
    }

    Scene fn calyx_gears_angular_contact_bearing(
        context, name: String, body: Handle, to: Handle, at: [f64; 3], count: f64, ball_diameter: f64,
        pitch_diameter: f64, contact_angle: f64, inner_conformity: f64, outer_conformity: f64,
        thrust: Option<String>, arrangement: String, row_distance: Option<f64>, axial_preload: f64,
        ring: String, azimuth: f64, inner_speed: f64, outer_speed: f64, ring_material: Option<Handle>,
        element_material: Option<Handle>, linearized_at: Option<[f64; 3]>,
    ) -> Handle {
        let mounting = Mounting::new(context, name, body, to, at)?;
        let conformities = [inner_conformity, outer_conformity];
        let kind = BallKind::AngularContact { angle: contact_angle };
        let size = (count, ball_diameter, pitch_diameter);
        let row = balls(context, kind, size, conformities, [ring_material, element_material])?;
        warn_about_arrangement(context, &mounting, (&arrangement, row_distance), thrust.as_deref())?;
        let senses = (thrust.as_deref(), ring.as_str());
        let rows = arranged(row.into(), (&arrangement, row_distance), senses, axial_preload)?;
        let operation = Operation::new(&ring, azimuth, [inner_speed, outer_speed], "axial_preload").linearized(linearized_at);
        add(context, mounting, rows, &operation, None)
    }

    Scene fn calyx_gears_four_point_bearing(
        context, name: String, body: Handle, to: Handle, at: [f64; 3], count: f64, ball_diameter: f64,
        pitch_diameter: f64, contact_angle: f64, inner_conformity: f64, outer_conformity: f64, clearance: f64,
        ring: String, azimuth: f64, inner_speed: f64, outer_speed: f64, ring_material: Option<Handle>,
        element_material: Option<Handle>, linearized_at: Option<[f64; 3]>,
    ) -> Handle {
        let mounting = Mounting::new(context, name, body, to, at)?;
        let conformities = [inner_conformity, outer_conformity];
        let kind = BallKind::FourPoint { angle: contact_angle, clearance };
        let size = (count, ball_diameter, pitch_diameter);
        let row = balls(context, kind, size, conformities, [ring_material, element_material])?;
        let operation = Operation::new(&ring, azimuth, [inner_speed, outer_speed], "clearance").linearized(linearized_at);
        add(context, mounting, RollingBearing::single(row), &operation, None)
    }

    Scene fn calyx_gears_cylindrical_roller_bearing(
        context, name: String, body: Handle, to: Handle, at: [f64; 3], count: f64, roller_diameter: f64,
        roller_length: f64, pitch_diameter: f64, clearance: f64, profile: String, crown_radius: Option<f64>,
        profile_positions: Vec<f64>, profile_relief: Vec<f64>, laminae: f64, ring: String, azimuth: f64,
        inner_speed: f64, outer_speed: f64, ring_material: Option<Handle>, element_material: Option<Handle>, linearized_at: Option<[f64; 3]>,
        inner_raceway_width: Option<f64>, outer_raceway_width: Option<f64>,
    ) -> Handle {
        let mounting = Mounting::new(context, name, body, to, at)?;
        let profile = profile_of(&profile, crown_radius, (&profile_positions, &profile_relief))?;
        let size = (count, roller_diameter, roller_length, pitch_diameter);
        let operation = Operation::new(&ring, azimuth, [inner_speed, outer_speed], "clearance").linearized(linearized_at);
        let profile = (profile, laminae, [inner_raceway_width, outer_raceway_width]);
        let materials = [ring_material, element_material];
        cylindrical(context, mounting, (size, clearance), profile, materials, &operation)
    }

    /// Needles are thin cylindrical rollers.
    Scene fn calyx_gears_needle_bearing(
        context, name: String, body: Handle, to: Handle, at: [f64; 3], count: f64, roller_diameter: f64,
        roller_length: f64, pitch_diameter: f64, clearance: f64, profile: String, crown_radius: Option<f64>,
        profile_positions: Vec<f64>, profile_relief: Vec<f64>, laminae: f64, ring: String, azimuth: f64,
        inner_speed: f64, outer_speed: f64, ring_material: Option<Handle>, element_material: Option<Handle>, linearized_at: Option<[f64; 3]>,
        inner_raceway_width: Option<f64>, outer_raceway_width: Option<f64>,
    ) -> Handle {
        let mounting = Mounting::new(context, name, body, to, at)?;
        let profile = profile_of(&profile, crown_radius, (&profile_positions, &profile_relief))?;
        let size = (count, roller_diameter, roller_length, pitch_diameter);
        let operation = Operation::new(&ring, azimuth, [inner_speed, outer_speed], "clearance").linearized(linearized_at);
        let profile = (profile, laminae, [inner_raceway_width, outer_raceway_width]);
        let materials = [ring_material, element_material];
        cylindrical(context, mounting, (size, clearance), profile, materials, &operation)
    }

    Scene fn calyx_gears_tapered_roller_bearing(
        context, name: String, body: Handle, to: Handle, at: [f64; 3], count: f64, roller_diameter: f64,
        roller_length: f64, pitch_diameter: f64, contact_angle: f64, rib_end_radius: Option<f64>,
        rib_height: Option<f64>, thrust: Option<String>, arrangement: String, row_distance: Option<f64>,
        axial_preload: f64, profile: String, crown_radius: Option<f64>, profile_positions: Vec<f64>,
        profile_relief: Vec<f64>, laminae: f64, ring: String, azimuth: f64, inner_speed: f64,
        outer_speed: f64, ring_material: Option<Handle>, element_material: Option<Handle>, linearized_at: Option<[f64; 3]>,
        inner_raceway_width: Option<f64>, outer_raceway_width: Option<f64>,
    ) -> Handle {
        let mounting = Mounting::new(context, name, body, to, at)?;
        let rib = rib(roller_diameter, pitch_diameter, contact_angle);
        let rib = Rib {
            end_radius: rib_end_radius.unwrap_or(rib.end_radius),
            height: rib_height.unwrap_or(rib.height),
        };
        let profile = profile_of(&profile, crown_radius, (&profile_positions, &profile_relief))?;
        let kind = RollerKind::Tapered { outer_angle: contact_angle, rib };
        let size = (count, roller_diameter, roller_length, pitch_diameter);
        let profile = (profile, laminae, [inner_raceway_width, outer_raceway_width]);
        let row = rollers(context, kind, size, profile, [ring_material, element_material])?;
        warn_about_arrangement(context, &mounting, (&arrangement, row_distance), thrust.as_deref())?;
        let senses = (thrust.as_deref(), ring.as_str());
        let rows = arranged(row.into(), (&arrangement, row_distance), senses, axial_preload)?;
        let operation = Operation::new(&ring, azimuth, [inner_speed, outer_speed], "axial_preload").linearized(linearized_at);
        add(context, mounting, rows, &operation, None)
    }

    Scene fn calyx_gears_spherical_roller_bearing(
        context, name: String, body: Handle, to: Handle, at: [f64; 3], count: f64, roller_diameter: f64,
        roller_length: f64, pitch_diameter: f64, contact_angle: f64, inner_osculation: f64,
        outer_osculation: f64, clearance: f64, laminae: f64, ring: String, azimuth: f64, inner_speed: f64,
        outer_speed: f64, ring_material: Option<Handle>, element_material: Option<Handle>, linearized_at: Option<[f64; 3]>,
    ) -> Handle {
        let mounting = Mounting::new(context, name, body, to, at)?;
        let kind = RollerKind::Spherical { angle: contact_angle, outer_osculation, inner_osculation, clearance };
        let size = (count, roller_diameter, roller_length, pitch_diameter);
        let materials = [ring_material, element_material];
        let row = rollers(context, kind, size, (Profile::Straight, laminae, [None; 2]), materials)?;
        // Both rows have the centre of the outer sphere in common.
        let distance = pitch_diameter * contact_angle.tan();
        let rows = RollingBearing::pair(row, Arrangement::FaceToFace, distance, 0.0).map_err(rejected)?;
        let operation = Operation::new(&ring, azimuth, [inner_speed, outer_speed], "clearance").linearized(linearized_at);
        add(context, mounting, rows, &operation, None)
    }

    Scene fn calyx_gears_max_bearing_pressure(context, bearing: Handle) -> Handle {
        let bearing = rolling(context, bearing)?.0;
        observe(context, BearingPressure(bearing))
    }

    Scene fn calyx_gears_max_rolling_element_load(context, bearing: Handle) -> Handle {
        let bearing = rolling(context, bearing)?.0;
        observe(context, MaxElementLoad(bearing))
    }

    Scene fn calyx_gears_rolling_element_load(context, bearing: Handle, element: f64) -> Handle {
        let (bearing, elements) = rolling(context, bearing)?;
        let number = whole("element", element)?;
        let count: usize = elements.bearing.rows().iter().map(Row::count).sum();
        if number > count {
            let message = format!("the bearing has {count} rolling elements and none of number {number}");
            let help = "elements have the numbers from 1, row by row";
            return Err(refusal("E0698", "element", &message, help));
        }
        observe(context, RollingElementLoad(bearing, number - 1))
    }

    Scene fn calyx_gears_loaded_rolling_elements(context, bearing: Handle) -> Handle {
        let bearing = rolling(context, bearing)?.0;
        observe(context, LoadedElements(bearing))
    }

    Scene fn calyx_gears_bearing_static_safety(context, bearing: Handle) -> Handle {
        let bearing = rolling(context, bearing)?.0;
        observe(context, StaticSafety(bearing))
    }

    Scene fn calyx_gears_bearing_life(
        context, bearing: Handle, dynamic_rating: Option<f64>, rotating_ring: Option<String>,
    ) -> Handle {
        let conditions = LifeConditions {
            dynamic_rating,
            direction: load_direction(context, bearing, rotating_ring.as_deref())?,
            ..LifeConditions::default()
        };
        life(context, bearing, conditions, false)
    }

    Scene fn calyx_gears_modified_bearing_life(
        context, bearing: Handle, viscosity_ratio: f64, contamination: f64, reliability: f64,
        dynamic_rating: Option<f64>, fatigue_limit: Option<f64>, rotating_ring: Option<String>,
    ) -> Handle {
        let conditions = LifeConditions {
            dynamic_rating,
            fatigue_limit,
            reliability,
            viscosity_ratio,
            contamination,
            direction: load_direction(context, bearing, rotating_ring.as_deref())?,
        };
        life(context, bearing, conditions, true)
    }

    Scene fn calyx_gears_bearing_friction_torque(
        context, bearing: Handle, viscosity: f64, viscous_coefficient: Option<f64>, load_coefficient: Option<f64>,
    ) -> Handle {
        bearing_friction(context, bearing, viscosity, [viscous_coefficient, load_coefficient], false)
    }

    Scene fn calyx_gears_bearing_friction_loss(
        context, bearing: Handle, viscosity: f64, viscous_coefficient: Option<f64>, load_coefficient: Option<f64>,
    ) -> Handle {
        bearing_friction(context, bearing, viscosity, [viscous_coefficient, load_coefficient], true)
    }
}

/// Arguments of all rolling bearings about their rings and motion.
pub(crate) struct Operation<'a> {
    ring: &'a str,
    motion: Motion,
    /// Argument that presses the elements without load.
    cause: &'static str,
    /// External force on the body at which the bearing is linearized, N.
    linearized_at: Option<[f64; 3]>,
}

impl<'a> Operation<'a> {
    pub(crate) fn new(
        ring: &'a str,
        azimuth: f64,
        [inner_speed, outer_speed]: [f64; 2],
        cause: &'static str,
    ) -> Self {
        let motion = Motion { inner_speed, outer_speed, azimuth, gyroscopic: true, ..Motion::REST };
        Self { ring, motion, cause, linearized_at: None }
    }

    /// Linearizes the bearing at an external force on the body (N), if there is one.
    pub(crate) fn linearized(self, force: Option<[f64; 3]>) -> Self {
        Self { linearized_at: force, ..self }
    }
}

/// Creates a row of balls: number, ball and pitch diameter, conformities of the inner and the outer
/// groove, and materials of rings and balls.
fn balls(
    context: &mut Context,
    kind: BallKind,
    (count, ball_diameter, pitch_diameter): (f64, f64, f64),
    [inner_conformity, outer_conformity]: [f64; 2],
    [rings, balls]: [Option<Handle>; 2],
) -> Result<BallRow, RuntimeError> {
    let geometry = BallGeometry {
        kind,
        count: whole("count", count)?,
        ball_diameter,
        pitch_diameter,
        inner_conformity,
        outer_conformity,
        rings: material(context, rings)?,
        balls: material(context, balls)?,
    };
    BallRow::new(geometry).map_err(rejected)
}

/// Creates a row of rollers: number, diameter, length and pitch diameter, profile and number of
/// laminae with the widths of both raceways, and materials of rings and rollers.
fn rollers(
    context: &mut Context,
    kind: RollerKind,
    (count, roller_diameter, length, pitch_diameter): RollerSize,
    (profile, laminae, raceway_widths): RollerProfile,
    [rings, rollers]: [Option<Handle>; 2],
) -> Result<RollerRow, RuntimeError> {
    let geometry = RollerGeometry {
        kind,
        count: whole("count", count)?,
        roller_diameter,
        length,
        raceway_widths,
        pitch_diameter,
        profile,
        laminae: whole("laminae", laminae)?,
        rings: material(context, rings)?,
        rollers: material(context, rollers)?,
    };
    RollerRow::new(geometry).map_err(rejected)
}

/// Dimensions of a row of rollers: number, diameter, length and pitch diameter.
type RollerSize = (f64, f64, f64, f64);

/// Profile of rollers with the number of laminae, and the widths of the inner and outer raceways.
type RollerProfile = (Profile, f64, [Option<f64>; 2]);

/// Adds a bearing with a row of cylindrical rollers.
fn cylindrical(
    context: &mut Context,
    mounting: Mounting,
    (size, clearance): (RollerSize, f64),
    profile: RollerProfile,
    materials: [Option<Handle>; 2],
    operation: &Operation<'_>,
) -> Result<Handle, RuntimeError> {
    let row = rollers(context, RollerKind::Cylindrical { clearance }, size, profile, materials)?;
    add(context, mounting, RollingBearing::single(row), operation, None)
}

/// Adds a rolling bearing, with its boundary dimensions if a catalogue states them.
pub(crate) fn add(
    context: &mut Context,
    mounting: Mounting,
    rows: RollingBearing,
    operation: &Operation<'_>,
    boundary: Option<Boundary>,
) -> Result<Handle, RuntimeError> {
    let place = context.place;
    let found = bearing_sizes::check(host(context)?, &mounting, (&rows, operation.ring), boundary);
    for (message, help) in found {
        host(context)?.warn("E0669", message, help, place);
    }
    let elements = RollingElements::new(rows, operation.motion).map_err(|error| {
        let is_located = error.argument.is_some();
        externs::engine(if is_located { error } else { error.blame(operation.cause) })
    })?;
    let elements = if operation.ring == "outer" { elements.inverted() } else { elements };
    let none = [[0.0; 6]; 6];
    let Mounting { name, body, to, at, .. } = mounting;
    let elements = Arc::new(elements);
    let bearing = Bearing { to, at, ..Bearing::new(name, body, 0.0, none) };
    let bearing = match operation.linearized_at {
        None => Bearing { nonlinear: Some(NonlinearLoad::Rolling(elements)), ..bearing },
        Some(force) => {
            let linearized = elements.linearized(force);
            let (tangent, at) = linearized.map_err(|error| externs::engine(error.blame("linearized_at")))?;
            Bearing { stiffness: tangent.stiffness, load: tangent.load, linearization: Some(at), ..bearing }
        }
    };
    let added = crate::bearing_externs::add(context, bearing)?;
    warn_about_speeds(context, added, operation)?;
    Ok(added)
}

/// Largest difference between the speeds of the rings and of the bodies without a warning, relative
/// to the larger one: speeds are often rounded to whole revolutions per minute.
const SAME_SPEED: f64 = 0.01;

/// Warns of speeds of the rings that differ from the motion of both bodies at time 0. Bodies that
/// are at rest there may start to rotate, and are not compared.
fn warn_about_speeds(
    context: &mut Context,
    bearing: Handle,
    operation: &Operation<'_>,
) -> Result<(), RuntimeError> {
    let Motion { inner_speed, outer_speed, .. } = operation.motion;
    if inner_speed == 0.0 && outer_speed == 0.0 {
        return Ok(());
    }
    let is_outer = operation.ring == "outer";
    let stated = if is_outer { outer_speed - inner_speed } else { inner_speed - outer_speed };
    let id = self::bearing(context, bearing)?;
    let host = host(context)?;
    let own = &host.scene.bearings[id.0];
    let Ok(state) = BearingState::at(&host.scene.bodies, own, 0.0) else { return Ok(()) };
    let about_axis = |body: BodyId| {
        host.scene
            .bodies
            .get(body.0)
            .map_or(0.0, |body| dot(angular_velocity(body.motion.as_ref(), 0.0), state.axes[2]))
    };
    let second = match own.to {
        Support::Ground => 0.0,
        Support::Body(body) => about_axis(body),
    };
    let first = about_axis(own.body);
    let (moved, scale) = (first - second, first.abs().max(second.abs()).max(stated.abs()));
    // Frames that do not move relative to each other have a difference of rounding.
    let is_at_rest = moved.abs() <= 1e-9 * scale;
    if is_at_rest || (stated - moved).abs() <= SAME_SPEED * stated.abs().max(moved.abs()) {
        return Ok(());
    }
    let rpm = |speed: f64| (speed * 60.0 / TAU * 10.0).round() / 10.0;
    let message = format!(
        "`inner_speed` and `outer_speed` of bearing \"{}\" give a relative speed of {} rpm, and the frames of the bodies give {} rpm at time 0",
        own.name,
        rpm(stated),
        rpm(moved)
    );
    let (argument, other) =
        if is_outer { ("outer_speed", "inner_speed") } else { ("inner_speed", "outer_speed") };
    let help =
        format!("give `{argument} = {} rpm` and leave out `{other}`, or correct the frames", rpm(moved));
    let place = context.place;
    self::host(context)?.warn_of_argument(("E0727", argument), message, &help, place);
    Ok(())
}

/// Warns of arguments that an arrangement of rows does not use.
fn warn_about_arrangement(
    context: &mut Context,
    mounting: &Mounting,
    (arrangement, distance): (&str, Option<f64>),
    thrust: Option<&str>,
) -> Result<(), RuntimeError> {
    if arrangement == "single" && distance.is_some() {
        let reason = "it has a single row";
        unused(context, mounting, "row_distance", reason, "choose an `arrangement` of two rows")?;
    }
    if matches!(arrangement, "back_to_back" | "face_to_face") && thrust.is_some() {
        let reason = "its two rows carry axial force in both senses";
        unused(context, mounting, "thrust", reason, "choose the `arrangement` \"single\" or \"tandem\"")?;
    }
    Ok(())
}

/// Warns of an argument that a bearing does not use.
pub(crate) fn unused(
    context: &mut Context,
    mounting: &Mounting,
    argument: &str,
    reason: &str,
    other: &str,
) -> Result<(), RuntimeError> {
    let message = format!("bearing \"{}\" does not use `{argument}`: {reason}", mounting.name);
    let help = format!("leave `{argument}` out, or {other}");
    let place = context.place;
    host(context)?.warn_of_argument(("E0700", argument), message, &help, place);
    Ok(())
}

/// Returns a bearing with its rolling elements.
fn rolling(context: &mut Context, handle: Handle) -> Result<(BearingId, Arc<RollingElements>), RuntimeError> {
    let id = bearing(context, handle)?;
    let own = &host(context)?.scene.bearings[id.0];
    match own.rolling() {
        Some(elements) => Ok((id, elements.clone())),
        None if own.linearization.is_some() => {
            let message =
                format!("bearing \"{}\" is linearized, so the loads of its elements are unknown", own.name);
            Err(refusal("E0698", "bearing", &message, "remove `linearized_at`, or this output"))
        }
        None => {
            let message = format!("bearing \"{}\" has no rolling elements", own.name);
            let help = "create it by `ball_bearing`, `tapered_roller_bearing` or another rolling bearing";
            Err(refusal("E0698", "bearing", &message, help))
        }
    }
}

fn life(
    context: &mut Context,
    bearing: Handle,
    conditions: LifeConditions,
    modified: bool,
) -> Result<Handle, RuntimeError> {
    let (bearing, elements) = rolling(context, bearing)?;
    // That of its catalogue includes the quality of steel and finish.
    let stated = host(context)?.bearing_ratings.get(&bearing.0).map(|[dynamic, _]| *dynamic);
    let dynamic_rating = conditions.dynamic_rating.or(stated);
    let conditions = LifeConditions { dynamic_rating, ..conditions };
    let life = BearingLife { bearing, conditions, modified };
    // Conditions are checked before any solution.
    life.check(&elements).map_err(rejected)?;
    observe(context, life)
}

/// Observes the friction of a rolling bearing, with the coefficients of its type if they are not
/// given.
fn bearing_friction(
    context: &mut Context,
    bearing: Handle,
    viscosity: f64,
    [viscous, load]: [Option<f64>; 2],
    is_loss: bool,
) -> Result<Handle, RuntimeError> {
    let (bearing, elements) = rolling(context, bearing)?;
    let own = FrictionCoefficients::of(&elements.bearing);
    let coefficients =
        FrictionCoefficients { viscous: viscous.unwrap_or(own.viscous), load: load.unwrap_or(own.load) };
    observe(context, BearingFriction { bearing, viscosity, coefficients, is_loss })
}

/// Returns the ring relative to which the load is steady: the one that does not rotate, or the one
/// of [`RollingElements::load_direction`] if that is not stated.
fn load_direction(
    context: &mut Context,
    bearing: Handle,
    rotating_ring: Option<&str>,
) -> Result<LoadDirection, RuntimeError> {
    let elements = rolling(context, bearing)?.1;
    Ok(match rotating_ring {
        Some("outer") => LoadDirection::InnerRing,
        Some(_) => LoadDirection::OuterRing,
        None => elements.load_direction(),
    })
}

/// Converts an error of a rolling bearing, located at the argument of the same name.
pub(crate) fn rejected(error: RollingError) -> RuntimeError {
    let message = error.to_string();
    match error.invalid_input() {
        Some("distance_of_the_rows") => refusal("E0697", "row_distance", &message, error.help()),
        Some("radius_of_the_roller_end") => refusal("E0697", "rib_end_radius", &message, error.help()),
        Some("dynamic_load_rating") => refusal("E0697", "dynamic_rating", &message, error.help()),
        Some("fatigue_load_limit") => refusal("E0697", "fatigue_limit", &message, error.help()),
        Some(input) => refusal("E0697", input, &message, error.help()),
        None => RuntimeError::new("E0697", message, error.help()),
    }
}

/// Returns a positive number without a fraction.
fn whole(argument: &str, number: f64) -> Result<usize, RuntimeError> {
    if number.fract() == 0.0 && (1.0..=1e6).contains(&number) {
        return Ok(number as usize);
    }
    let message = format!("`{argument}` of a rolling bearing is {number}");
    Err(refusal("E0697", argument, &message, "give a whole number of at least 1"))
}

/// Returns a material; bearing steel if none is given.
fn material(context: &mut Context, material: Option<Handle>) -> Result<Material, RuntimeError> {
    let Some(material) = material else { return Ok(Material::STEEL) };
    let given = *entry(&host(context)?.materials, material)?;
    Ok(Material {
        youngs_modulus: given.youngs_modulus,
        poissons_ratio: given.poissons_ratio,
        density: given.density,
    })
}

/// Returns a rib at usual proportions: the radius of the roller end is 0.95 of the distance to the
/// apex, and the contact is at a third of the roller diameter from the roller axis.
pub(crate) fn rib(roller_diameter: f64, pitch_diameter: f64, contact_angle: f64) -> Rib {
    let apex = 0.5 * pitch_diameter / contact_angle.sin();
    Rib { end_radius: 0.95 * apex, height: roller_diameter / 3.0 }
}

fn profile_of(
    profile: &str,
    crown_radius: Option<f64>,
    (positions, relief): (&[f64], &[f64]),
) -> Result<Profile, RuntimeError> {
    match (profile, crown_radius) {
        ("straight", _) => Ok(Profile::Straight),
        ("crowned", Some(radius)) => Ok(Profile::Crowned { radius }),
        ("crowned", None) => {
            let message = "crowned rollers have no crown radius";
            Err(refusal("E0697", "profile", message, "give `crown_radius`, or another profile"))
        }
        ("table", _) => {
            if positions.len() != relief.len() {
                let message = format!(
                    "`profile_relief` has {} entries, and `profile_positions` has {}",
                    relief.len(),
                    positions.len()
                );
                let help = "give the relief at each position";
                return Err(refusal("E0697", "profile_relief", &message, help));
            }
            let points = positions.iter().zip(relief).map(|(&position, &relief)| [position, relief]);
            Ok(Profile::Table { points: points.collect() })
        }
        _ => Ok(Profile::Logarithmic),
    }
}

/// Arranges one or two equal rows that carry axial load.
pub(crate) fn arranged(
    elements: Elements,
    (arrangement, distance): (&str, Option<f64>),
    (thrust, ring): (Option<&str>, &str),
    offset: f64,
) -> Result<RollingBearing, RuntimeError> {
    // The inner ring carries axial load towards +z; the opposite acts on the outer ring.
    let mirrored = (thrust == Some("-z")) != (ring == "outer");
    let arrangement = match arrangement {
        "back_to_back" => Arrangement::BackToBack,
        "face_to_face" => Arrangement::FaceToFace,
        "tandem" => Arrangement::Tandem,
        _ => {
            let row = Row { mirrored, offset, ..Row::new(elements) };
            return RollingBearing::new(vec![row]).map_err(rejected);
        }
    };
    let Some(distance) = distance else {
        let message = "a bearing of two rows has no distance between them";
        let help = "give `row_distance`, the axial distance between the centres of the elements";
        return Err(refusal("E0697", "arrangement", message, help));
    };
    let pair = RollingBearing::pair(elements, arrangement, distance, offset).map_err(rejected)?;
    if arrangement != Arrangement::Tandem {
        return Ok(pair);
    }
    let rows = pair.rows().iter().map(|row| Row { mirrored, ..row.clone() });
    RollingBearing::new(rows.collect()).map_err(rejected)
}
