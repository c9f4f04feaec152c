//! Assembly of gears in a scene: bodies that carry gears, and the meshes between them.
//!
//! The functions `body` and `mesh` of the language's library call these functions, so a pair built
//! in Rust and one described in Calyx are the same scene, bit for bit.

use crate::axes::{Axes, rotates_about_own_axis};
use crate::error::{GeometryError, Refusal, sentence};
use crate::gear::Gear;
use crate::mesh_geometry::{HelicalTeeth, MeshGeometry};
use crate::mounting::{Mounting, mesh_as_placed, phase_offset};
use crate::phase_check;
use crate::prototype::GearPrototype;
use calyx_runtime::bearing::Support;
use calyx_runtime::error::{EngineError, Subject};
use calyx_runtime::lubrication::Lubrication;
use calyx_runtime::motion::{PlanePose, angular_velocity, axle, rotation_speed, spatial_pose};
use calyx_runtime::scene::{Body, BodyId, Component, GearMesh, GridOptions, PairId, Scene, SurfacePair};
use calyx_runtime::vec3::{dot, minus};
use std::any::Any;
use std::sync::Arc;

/// Adds a body to a scene.
///
/// # Errors
/// E0671: the scene has a body of that name. E0710: its frame is NaN or infinite at time 0. E0723:
/// its load is.
pub fn add_body(scene: &mut Scene, body: Body) -> Result<BodyId, Refusal> {
    spatial_pose(body.motion.as_ref(), 0.0)?;
    if scene.bodies.iter().any(|other| other.name == body.name) {
        return Err(EngineError::new(
            "E0671",
            format!("there are two bodies called \"{}\"", body.name),
            "give each body a name of its own: results refer to bodies by name",
        )
        .blame("name")
        .into());
    }
    Ok(scene.add_body(body))
}

/// Contact options of a gear mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeshOptions {
    /// Enables contact of the tip edges beyond the nominal path of contact.
    pub tip_corner_contact: bool,
    /// M: a contact grid has 2M + 1 cells across the contact line; `None` selects a number that
    /// suits the fidelity.
    pub half_cells: Option<usize>,
    /// N: in three dimensions a contact grid has 2N + 1 slices along the face.
    pub half_slices: usize,
    /// Width of a contact grid, m; `None` derives it from the Hertz half-width.
    pub grid_width: Option<f64>,
    /// Coefficient of friction.
    pub friction: f64,
    /// Misalignment of the second gear.
    pub misalignment: Misalignment,
    /// Enables contact of the back (coast) flanks as well.
    pub coast_side_contact: bool,
    /// Lubrication, for observables of friction, temperature and film thickness.
    pub lubrication: Option<Lubrication>,
    /// Expected torque of the mesh on the first gear about its axis, N m; its sign selects the
    /// drive flanks. Zero if they follow from the loads.
    pub torque_on_first: f64,
}

/// Misalignment of the second gear's axis relative to the first one's, given by two angles (rad)
/// about the middle of the common face.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Misalignment {
    /// Inclination in the plane of action; a positive angle brings the drive flanks together at the
    /// end of the face towards +e3.
    pub in_action: f64,
    /// Inclination in the plane perpendicular to it, which has little effect on contact; a positive
    /// angle brings the axes together at that end.
    pub off_action: f64,
}

impl Default for MeshOptions {
    fn default() -> Self {
        let GridOptions { half_cells, half_slices, width, edges } = GridOptions::default();
        MeshOptions {
            tip_corner_contact: edges,
            half_cells,
            half_slices,
            grid_width: width,
            friction: 0.0,
            misalignment: Misalignment::default(),
            coast_side_contact: false,
            lubrication: None,
            torque_on_first: 0.0,
        }
    }
}

/// Mesh of two gears.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshResult {
    /// Surface pair of the mesh in the scene, for use by observables. Its [`SurfacePair::mesh`]
    /// contains the mesh cycle.
    pub pair: PairId,
    /// Surface pair of the back flanks, if they may touch as well.
    pub back: Option<PairId>,
    /// Geometry of the mesh: path of contact, contact ratio, backlash.
    pub geometry: MeshGeometry,
    /// Warnings about the pair.
    pub warnings: Vec<GeometryError>,
}

/// Puts two gear bodies of a scene in mesh. The mesh consists of the flanks that the load presses
/// together. The second gear is phased so that they touch; if it already has a mesh, the first gear
/// is phased; if both have one, neither is.
///
/// The drive flanks follow from [`MeshOptions::torque_on_first`], if it is given, and otherwise
/// from the first gear's moment about z at time 0. If it is zero, they follow from the second
/// gear's moment, which the first gear resists; otherwise from the effect of an earlier mesh on
/// either gear that is free to rotate; otherwise from the first gear's speed.
///
/// # Errors
/// See [`Pairing::of`] and [`Pairing::mesh`].
pub fn mesh(
    scene: &mut Scene,
    first: BodyId,
    second: BodyId,
    options: &MeshOptions,
) -> Result<MeshResult, Refusal> {
    Pairing::of(scene, [first, second])?.mesh(scene, options)
}

/// Two gear bodies that are to be meshed, with their relative position.
#[derive(Clone, Debug)]
pub struct Pairing {
    bodies: [BodyId; 2],
    axes: Axes,
    /// Angular velocity of the line of centres, rad/s.
    orbit: f64,
    /// Angular velocities relative to the line of centres, rad/s.
    speeds: [f64; 2],
}

impl Pairing {
    /// Determines the relative position of two bodies of a scene.
    ///
    /// # Errors
    /// E0610: one of them does not rotate about its own axis. E0648: their axes cross. E0652: they
    /// are one body, or already in mesh. E0653: one of them is not in the scene or carries no gear.
    /// E0658: their axes approach each other. E0692: one of
    /// them rotates about an axis far from its own. E0710: a frame is NaN or infinite.
    pub fn of(scene: &Scene, bodies: [BodyId; 2]) -> Result<Pairing, Refusal> {
        let mut half_widths = [0.0; 2];
        for ((id, argument), half) in bodies.into_iter().zip(["first", "second"]).zip(&mut half_widths) {
            let gear = gear_of(scene, id).ok_or_else(|| {
                EngineError::new(
                    "E0653",
                    format!("body {} of the scene carries no gear", id.0),
                    "mesh bodies whose prototype is a `GearPrototype`",
                )
                .blame(argument)
            })?;
            *half = 0.5 * gear.face_width;
        }
        meet_once(scene, bodies)?;
        let motion = |id: BodyId| scene.bodies[id.0].motion.as_ref();
        for id in bodies {
            rotates_about_own_axis(motion(id)).map_err(|error| error.about(Subject::Body(id.0)))?;
        }
        let poses = [spatial_pose(motion(bodies[0]), 0.0)?, spatial_pose(motion(bodies[1]), 0.0)?];
        let speeds = [rotation_speed(motion(bodies[0]), 0.0)?, rotation_speed(motion(bodies[1]), 0.0)?];
        let axes = Axes::of(&poses, half_widths)?;
        centred(scene, bodies)?;
        let orbit = phase_check::orbit(scene, bodies, speeds)?;
        Ok(Pairing { bodies, axes, orbit, speeds: speeds.map(|speed| speed - orbit) })
    }

    /// Distance of the two axes at the middle of the common face, m.
    pub fn center_distance(&self) -> f64 {
        let [first, second] = self.axes.sections.map(|section| section.origin);
        (second[0] - first[0]).hypot(second[1] - first[1])
    }

    /// Geometry of the mesh, even if the pair cannot run; `None` if the gears cannot touch.
    pub fn geometry(&self, scene: &Scene) -> Option<MeshGeometry> {
        let [first, second] = self.bodies.map(|id| gear_of(scene, id));
        let (prototypes, distance) = ([first?, second?], self.center_distance());
        let first = prototypes[0].gear.external()?;
        let geometry = match &prototypes[1].gear {
            Gear::External(second) => MeshGeometry::external(first, second, distance),
            Gear::Internal(second) => MeshGeometry::internal(first, second, distance),
        };
        let wound = HelicalTeeth { first: prototypes[0].helix, width: self.axes.common_width.max(0.0) };
        Some(geometry.ok()?.across(first, &wound))
    }

    /// Puts the gears in mesh: phases the second one, or the first if the second already has a
    /// mesh, and adds the surface pair.
    ///
    /// # Errors
    /// All errors of the pair: E0630 to E0637. E0650 and E0651: the speeds do not match the numbers
    /// of teeth. E0653 as for [`Pairing::of`]. E0723: a load is NaN or infinite at time 0. E0750:
    /// the mesh closes a loop whose teeth do not fit. E0751: one of the gears overlaps a
    /// neighbouring one.
    pub fn mesh(&self, scene: &mut Scene, options: &MeshOptions) -> Result<MeshResult, Refusal> {
        let [first, second] = self.bodies;
        let (Some(driver), Some(mate)) = (gear_of(scene, first), gear_of(scene, second)) else {
            let error = EngineError::new("E0653", "a body of the mesh carries no gear", "");
            return Err(error.into());
        };
        let (geometry, mut warnings) = check(driver, mate, self.center_distance(), self.axes.common_width)?;
        phase_check::clears_neighbours(scene, self.bodies).map_err(|error| vec![error])?;
        let gears = [driver.form(), mate.form()];
        let sense = match options.torque_on_first {
            0.0 => drive_sense(scene, self.bodies, gears[1].sense(), self.speeds[0])?,
            torque => -torque.signum(),
        };
        // Teeth are phased by their positions at the middle of the common face.
        let twists = [driver.twist_per_length(), mate.twist_per_length()];
        let [first_section, second_section] = [0, 1].map(|member| {
            let section = self.axes.sections[member];
            PlanePose { angle: section.angle + twists[member] * self.axes.along[member], ..section }
        });
        let mounted = |phase_of_first: f64| Mounting {
            first: PlanePose { angle: first_section.angle + phase_of_first, ..first_section },
            second: second_section,
            angular_velocity: self.speeds,
            sense,
        };
        let mut phases = self.bodies.map(|body| scene.bodies[body.0].phase);
        let needed = phase_offset(gears, &geometry, &mounted(phases[0]));
        // Phase of the second gear, to the nearest of its teeth.
        let pitch = gears[1].pitch_angle();
        let off = (needed - phases[1]) - ((needed - phases[1]) / pitch).round() * pitch;
        let mut left = 0.0;
        match phase_check::may_rotate(scene, self.bodies) {
            Some(1) => phases[1] = needed,
            Some(_) => {
                phases[0] += gears[1].sense() * off * f64::from(gears[1].teeth) / f64::from(gears[0].teeth)
            }
            None => {
                left = off;
                let judged = phase_check::judge(scene, self.bodies, &gears[1], &geometry, off);
                warnings.extend(judged.map_err(|error| vec![error])?);
            }
        }
        let mounting = mounted(phases[0]);
        let placed = |mounting: &Mounting| {
            let mesh = mesh_as_placed(gears, &geometry, mounting, phases[1]);
            mesh.map_err(|error| self.about_speeds(error))
        };
        let carrier = self.axes.normal().map(|part| part * self.orbit);
        let mut mesh = GearMesh { carrier, phase_offset: left, ..placed(&mounting)? };
        // Refers to the zero of the body's own angle instead of that of its section.
        let off_section = first_section.angle - self.axes.angles[0];
        mesh.roll_at_zero += sense * off_section;
        scene.bodies[first.0].phase = phases[0];
        let body = &mut scene.bodies[second.0];
        body.phase = phases[1];
        if options.misalignment != Misalignment::default() {
            // The shaft of the gear is misaligned with it.
            let mut tilted = vec![second];
            tilted.extend(scene.connections_of(second).flat_map(|connection| connection.bodies()));
            tilted.sort_by_key(|body| body.0);
            tilted.dedup();
            for body in tilted.into_iter().map(|body| body.0) {
                let motion = scene.bodies[body].motion.clone();
                let moved = self.axes.misaligned(motion, &geometry, sense, options.misalignment);
                scene.bodies[body].motion = Arc::new(moved);
            }
        }
        let surface = if sense > 0.0 { 0 } else { 1 };
        // On an internal gear the opposite sides of the teeth touch.
        let surfaces = [surface, if gears[1].internal { 1 - surface } else { surface }];
        let back = match options.coast_side_contact {
            // Back flanks push the other way and have their own mesh cycle.
            true => {
                let mesh = placed(&Mounting { sense: -sense, ..mounting })?;
                Some(GearMesh { carrier, phase_offset: left, ..mesh })
            }
            false => None,
        };
        if back.is_some() {
            // Teeth that fill the spaces carry load on both sides: a mesh without backlash.
            warnings.retain(|warning| warning.code != "E0635");
        }
        let grid = GridOptions {
            half_cells: options.half_cells,
            half_slices: options.half_slices,
            width: options.grid_width,
            edges: options.tip_corner_contact,
        };
        let (bodies, friction, lubrication) = (self.bodies, options.friction, options.lubrication);
        let pair = scene.add_pair(SurfacePair {
            bodies,
            surfaces,
            grid,
            friction,
            mesh: Some(mesh),
            front: None,
            lubrication,
        });
        let back = back.map(|mut mesh| {
            mesh.roll_at_zero -= sense * off_section;
            let surfaces = surfaces.map(|surface| 1 - surface);
            scene.add_pair(SurfacePair {
                bodies,
                surfaces,
                grid,
                friction,
                mesh: Some(mesh),
                front: Some(pair),
                lubrication,
            })
        });
        Ok(MeshResult { pair, back, geometry, warnings })
    }

    /// Rewords an error about speeds for axes that move.
    fn about_speeds(&self, error: GeometryError) -> Refusal {
        if self.orbit == 0.0 {
            return error.into();
        }
        let help = sentence![
            "speeds are relative to the line of centres, which rotates too: read from ground, the frame of a planet rotates with the carrier, translates to its pin, and rotates relative to the carrier, like `Rotate(own * Time, e3) * Translate(distance * e1) * Rotate(carrier * Time, e3)`"
        ];
        GeometryError { help, ..error }.into()
    }
}

/// Checks that the two gears can run and returns their mesh geometry.
fn check(
    driver: &GearPrototype,
    mate: &GearPrototype,
    center_distance: f64,
    width: f64,
) -> Result<(MeshGeometry, Vec<GeometryError>), Vec<GeometryError>> {
    let mut errors: Vec<GeometryError> = check_helices(driver, mate).err().into_iter().collect();
    if width.is_nan() || width <= 0.0 {
        errors.push(GeometryError::error(
            "E0647",
            "second",
            sentence!["the faces of the gears pass each other along the axis by ", length -width],
            sentence!["place the frames so that the middles of the faces, their origins, lie less than half of both face widths apart"],
        ));
    }
    let wound = HelicalTeeth { first: driver.helix, width };
    let checked = match (&driver.gear, &mate.gear) {
        (Gear::External(first), Gear::External(second)) => {
            MeshGeometry::check_external(first, second, center_distance, &wound)
        }
        (Gear::External(first), Gear::Internal(second)) => {
            MeshGeometry::check_internal(first, second, center_distance, &wound)
        }
        (Gear::Internal(_), _) => Err(vec![GeometryError::error(
            "E0639",
            "first",
            sentence!["the first gear of a mesh has internal teeth"],
            sentence![
                "give the gear inside of the ring as `first`, and the ring as `second`; two rings cannot mesh"
            ],
        )]),
    };
    match checked {
        Ok(mesh) if errors.is_empty() => Ok(mesh),
        Ok(_) => Err(errors),
        Err(more) => {
            errors.extend(more);
            Err(errors)
        }
    }
}

/// Checks that teeth on parallel axes touch along their length, which requires equal base helix
/// angles.
fn check_helices(first: &GearPrototype, second: &GearPrototype) -> Result<(), GeometryError> {
    let [own, other] = [first, second].map(|gear| gear.helix.signed_angle());
    let internal = first.form().internal || second.form().internal;
    let fitting = if internal { own } else { -own };
    if (other - fitting).abs() <= SAME_HELIX {
        return Ok(());
    }
    if (other + fitting).abs() <= SAME_HELIX {
        let help = if internal {
            sentence!["give an internal gear and the gear in it the same `hand`"]
        } else {
            sentence!["give one of two external gears `hand = \"left\"`, the other `hand = \"right\"`"]
        };
        let message = sentence![
            "the first gear's teeth are ", text first.helix.hand().name(), "-handed and the second's ",
            text second.helix.hand().name(), "-handed: they would cross"
        ];
        return Err(GeometryError::error("E0645", "second", message, help));
    }
    Err(GeometryError::error(
        "E0646",
        "second",
        sentence!["the gears have different helix angles, ", angle own.abs(), " and ", angle other.abs()],
        sentence!["give both the same `helix_angle`; crossed axes are not modelled"],
    ))
}

/// Largest difference of equal helix angles, rad: a hundredth of the smallest manufacturing
/// tolerance.
const SAME_HELIX: f64 = 1e-9;

/// Returns the gear that a body carries, if any.
pub fn gear_of(scene: &Scene, body: BodyId) -> Option<&GearPrototype> {
    let prototype: &dyn Any = scene.bodies.get(body.0)?.prototype.as_ref();
    prototype.downcast_ref()
}

/// Rejects a gear that rotates about an axis more than a module away from its own. Such a motion is
/// no runout: the factors of the frame are in reverse order. A planet rotates about its pin, which
/// moves with the carrier.
fn centred(scene: &Scene, bodies: [BodyId; 2]) -> Result<(), Refusal> {
    let mut found = Vec::new();
    for id in bodies {
        let Some(gear) = gear_of(scene, id) else { continue };
        let motion = scene.bodies[id.0].motion.as_ref();
        let [x, y, _] = axle(motion);
        let runout = x.hypot(y);
        if runout > gear.form().module {
            let at = spatial_pose(motion, 0.0)?.origin;
            found.push(reversed_frame(runout, at).about(Subject::Body(id.0)));
        }
    }
    if found.is_empty() { Ok(()) } else { Err(found.into()) }
}

/// Error about a frame that rotates a gear about an axis at this distance (m) from its own; `at` is
/// the position of the gear at time 0, m.
fn reversed_frame(runout: f64, at: [f64; 3]) -> GeometryError {
    let mut help = sentence![
        "frames are read from right to left, beginning at ground: translate first, then rotate, like `Rotate(speed * Time, e3) * Translate("
    ];
    // Coordinates that are rounding errors are zero.
    let axes = ["* e1", "* e2", "* e3"];
    let shown = at.into_iter().zip(axes).filter(|(part, _)| part.abs() > 1e-9 * runout);
    for (index, (part, axis)) in shown.enumerate() {
        let between = if index == 0 { "" } else { " + " };
        help.0.extend(sentence![text between, length part, " ", text axis].0);
    }
    help.0.extend(sentence![")`"].0);
    GeometryError::error(
        "E0692",
        "frame",
        sentence![
            "this gear rotates about an axis that is ", length runout,
            " away from its own, so it moves around that axis instead of rotating in position"
        ],
        help,
    )
}

/// Rejects a second mesh of the same bodies: the distribution of load between the two would be
/// indeterminate.
pub(crate) fn meet_once(scene: &Scene, ids: [BodyId; 2]) -> Result<(), EngineError> {
    if ids[0] == ids[1] {
        return Err(EngineError::new(
            "E0652",
            "a body cannot mesh with itself",
            "give the other body; several bodies may share one gear",
        )
        .blame("second"));
    }
    if scene.pairs.iter().any(|pair| ids.iter().all(|id| pair.bodies.contains(id))) {
        let [first, second] = ids.map(|id| scene.bodies.get(id.0).map_or("", |body| &body.name));
        return Err(EngineError::new(
            "E0652",
            format!("\"{first}\" and \"{second}\" are in mesh already"),
            "store the first mesh in a variable, and use it wherever the mesh is needed",
        )
        .blame("second"));
    }
    Ok(())
}

/// Direction in which the first body pushes: along its own moment; otherwise against the second
/// body's moment; otherwise so that it transmits the loads and earlier meshes on the shaft of
/// either gear; otherwise along its motion. `sign` is -1 if the second gear is internal.
pub(crate) fn drive_sense(
    scene: &Scene,
    bodies: [BodyId; 2],
    sign: f64,
    speed: f64,
) -> Result<f64, EngineError> {
    for (id, sign) in bodies.into_iter().zip([1.0, sign]) {
        let body = &scene.bodies[id.0];
        let moment = own_moment(scene, id)?;
        if moment.is_nan() {
            return Err(EngineError::new(
                "E0723",
                format!("the load on body \"{}\" is not a number at Time = 0 s", body.name),
                "check the function that gives the load; it determines which flanks drive",
            )
            .about(Subject::Body(id.0)));
        }
        // External gears rotate in opposite directions, so a moment on the second one selects the
        // same surfaces. An internal gear rotates in the same direction, and what drives it drives
        // its mate from the other side.
        if moment != 0.0 {
            return Ok(sign * moment.signum());
        }
    }
    for (id, sign) in bodies.into_iter().zip([1.0, sign]) {
        let driven = driven(scene, id);
        if driven != 0.0 {
            return Ok(sign * driven.signum());
        }
    }
    Ok(if speed == 0.0 { 1.0 } else { speed.signum() })
}

/// Moment of a body's load about its own axis at time 0, N m.
fn own_moment(scene: &Scene, id: BodyId) -> Result<f64, EngineError> {
    let body = &scene.bodies[id.0];
    let axis = spatial_pose(body.motion.as_ref(), 0.0)?.axis();
    Ok(dot(body.load.at(0.0).moment, axis))
}

/// Sense of a body's axis relative to that of another one on its shaft.
fn same_way(scene: &Scene, id: BodyId, other: BodyId) -> f64 {
    let axis = |id: BodyId| spatial_pose(scene.bodies[id.0].motion.as_ref(), 0.0).map(|pose| pose.axis());
    match (axis(id), axis(other)) {
        (Ok(one), Ok(other)) if dot(one, other) < 0.0 => -1.0,
        _ => 1.0,
    }
}

/// Direction in which loads and earlier meshes drive a freely rotating gear with its shaft and all
/// gears on it, as a sum of signs. An idler or a planet transmits it to the next gear.
///
/// Meshes that supply power to the shaft decide before those that take power from it, whose number
/// does not matter: a sun that a bevel stage drives loads all its planets in the same direction.
fn driven(scene: &Scene, id: BodyId) -> f64 {
    let free = |id: &BodyId| scene.bodies[id.0].free[Component::ThetaZ as usize];
    let on_shaft: Vec<BodyId> = on_shaft(scene, id).into_iter().filter(free).collect();
    let moments = on_shaft
        .iter()
        .map(|other| same_way(scene, id, *other) * own_moment(scene, *other).unwrap_or(f64::NAN));
    let moment: f64 = moments.filter(|moment| !moment.is_nan()).sum();
    if moment != 0.0 {
        return moment.signum();
    }
    let driving = scene.pairs.iter().filter(|pair| pair.front.is_none());
    // Without any load, the first gear of each mesh drives, and the reaction does not drive it.
    let unloaded = (0..scene.bodies.len()).all(|body| own_moment(scene, BodyId(body)) == Ok(0.0));
    // Sign of the torque on the shaft, and whether it supplies power.
    let torque = |pair: &SurfacePair| {
        let mesh = pair.mesh.as_ref()?;
        let side = pair.bodies.iter().position(|body| on_shaft.contains(body))?;
        let on_body = match side {
            0 if unloaded => return None,
            0 => -mesh.drive_sense,
            _ => -mesh.drive_sense * mesh.sign,
        };
        let body = pair.bodies[side];
        let speed = own_speed(scene, body, mesh.carrier);
        Some((same_way(scene, id, body) * on_body, on_body * speed > 0.0))
    };
    let torques: Vec<(f64, bool)> = driving.filter_map(torque).collect();
    let supplied: f64 = torques.iter().filter(|(_, supplies)| *supplies).map(|(torque, _)| torque).sum();
    if supplied != 0.0 { supplied } else { torques.iter().map(|(torque, _)| torque).sum() }
}

/// Angular velocity of a body about its own axis at time 0 relative to a carrier with an angular
/// velocity, rad/s; 0 for an invalid frame.
fn own_speed(scene: &Scene, id: BodyId, carrier: [f64; 3]) -> f64 {
    let motion = scene.bodies[id.0].motion.as_ref();
    let relative = minus(angular_velocity(motion, 0.0), carrier);
    spatial_pose(motion, 0.0).map_or(0.0, |pose| dot(pose.axis(), relative))
}

/// A body and those that torsionally stiff bearings or shafts join to it: all bodies on one shaft.
fn on_shaft(scene: &Scene, id: BodyId) -> Vec<BodyId> {
    let mut found = vec![id];
    let mut next = 0;
    while let Some(&body) = found.get(next) {
        for bearing in scene.bearings.iter().filter(|bearing| bearing.stiffness[5][5] > 0.0) {
            let Support::Body(to) = bearing.to else { continue };
            for (one, other) in [(bearing.body, to), (to, bearing.body)] {
                if one == body && !found.contains(&other) {
                    found.push(other);
                }
            }
        }
        for other in scene.connections_of(body).flat_map(|connection| connection.bodies()) {
            if !found.contains(&other) {
                found.push(other);
            }
        }
        next += 1;
    }
    found
}
