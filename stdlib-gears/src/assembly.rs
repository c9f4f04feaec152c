//! Gears put together in a scene: bodies that carry them, and the meshes in which they meet.
//!
//! These are the very functions behind `body` and `mesh` of the language's library, so a pair built in Rust and one described in
//! Calyx are the same scene, bit for bit.

use crate::error::{GeometryError, Refusal};
use crate::mesh_geometry::MeshGeometry;
use crate::mounting::{Mounting, mount_external};
use crate::prototype::GearPrototype;
use calyx_runtime::error::{EngineError, Subject};
use calyx_runtime::motion::{Motion, PlanePose};
use calyx_runtime::scene::{Body, BodyId, GridOptions, PairId, Scene, SurfacePair};
use std::any::Any;

/// Adds a body to a scene.
///
/// # Errors
/// E0610: its frame tilts out of the plane; E0671: the scene has a body of that name; E0710: its frame is not a number at time 0;
/// E0723: nor is its load.
pub fn add_body(scene: &mut Scene, body: Body) -> Result<BodyId, Refusal> {
    PlanePose::of(body.motion.as_ref(), 0.0)?;
    turns_in_the_plane(body.motion.as_ref())?;
    if scene.bodies.iter().any(|other| other.name == body.name) {
        return Err(EngineError::new(
            "E0671",
            format!("there are two bodies called \"{}\"", body.name),
            "results speak of bodies by name; give each its own",
        )
        .blame("name")
        .into());
    }
    Ok(scene.add_body(body))
}

/// How two gears touch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeshOptions {
    /// Search for contact of the tip edges beyond the nominal path of contact.
    pub tip_corner_contact: bool,
    /// M: a contact grid has 2M + 1 cells.
    pub half_cells: usize,
    /// Width of a contact grid, m; `None` takes it from the Hertz half-width.
    pub grid_width: Option<f64>,
}

impl Default for MeshOptions {
    fn default() -> Self {
        let GridOptions { half_cells, width, edges } = GridOptions::default();
        MeshOptions { tip_corner_contact: edges, half_cells, grid_width: width }
    }
}

/// Two gears in mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct Meshed {
    /// Their pair of surfaces in the scene: what observables refer to. Its [`SurfacePair::mesh`] knows the cycle.
    pub pair: PairId,
    /// Path of contact, contact ratio, backlash.
    pub geometry: MeshGeometry,
    /// What an engineer should know of the pair.
    pub warnings: Vec<GeometryError>,
}

/// Lets two gear bodies of a scene touch: the flanks that the load presses together, the second gear phased so that they do.
///
/// The first gear's moment about z at time 0 says which of its flanks drive; failing that the second one's, which it resists;
/// failing that the first one's speed.
///
/// # Errors
/// See [`Pairing::of`] and [`Pairing::mesh`].
pub fn mesh(
    scene: &mut Scene,
    first: BodyId,
    second: BodyId,
    options: &MeshOptions,
) -> Result<Meshed, Refusal> {
    Pairing::of(scene, [first, second])?.mesh(scene, options)
}

/// Two gear bodies that are to be in mesh: where they stand to each other.
#[derive(Clone, Debug)]
pub struct Pairing {
    bodies: [BodyId; 2],
    poses: [PlanePose; 2],
    /// rad/s
    speeds: [f64; 2],
}

impl Pairing {
    /// Looks at two bodies of a scene.
    ///
    /// # Errors
    /// E0652: they are one body, or in mesh already; E0653: one of them is not of the scene or carries no gear; E0710: a frame is
    /// not a number.
    pub fn of(scene: &Scene, bodies: [BodyId; 2]) -> Result<Pairing, Refusal> {
        for (id, argument) in bodies.into_iter().zip(["first", "second"]) {
            gear_of(scene, id).ok_or_else(|| {
                EngineError::new(
                    "E0653",
                    format!("body {} of the scene carries no gear", id.0),
                    "mesh bodies whose prototype is a `GearPrototype`",
                )
                .blame(argument)
            })?;
        }
        meet_once(scene, bodies)?;
        let motion = |id: BodyId| scene.bodies[id.0].motion.as_ref();
        let poses = [PlanePose::of(motion(bodies[0]), 0.0)?, PlanePose::of(motion(bodies[1]), 0.0)?];
        let speeds = bodies.map(|id| PlanePose::angular_velocity(motion(id), 0.0));
        Ok(Pairing { bodies, poses, speeds })
    }

    /// Between the two axes, m.
    pub fn center_distance(&self) -> f64 {
        let [first, second] = self.poses.map(|pose| pose.origin);
        (second[0] - first[0]).hypot(second[1] - first[1])
    }

    /// How the gears would touch, whether or not they can run; `None` where they cannot touch at all.
    pub fn geometry(&self, scene: &Scene) -> Option<MeshGeometry> {
        let [first, second] = self.bodies.map(|id| gear_of(scene, id));
        MeshGeometry::external(&first?.gear, &second?.gear, self.center_distance()).ok()
    }

    /// Puts the gears in mesh: phases the second one and adds the pair of surfaces.
    ///
    /// # Errors
    /// Everything that the two gears have against each other: E0630 to E0637; E0650 and E0651: their speeds make no mesh; E0653 as
    /// for [`Pairing::of`]; E0723: a load is not a number at time 0.
    pub fn mesh(&self, scene: &mut Scene, options: &MeshOptions) -> Result<Meshed, Refusal> {
        let [first, second] = self.bodies;
        let (Some(driver), Some(mate)) = (gear_of(scene, first), gear_of(scene, second)) else {
            let error = EngineError::new("E0653", "a body of the mesh carries no gear", "");
            return Err(error.into());
        };
        let gears = [&driver.gear, &mate.gear];
        let (geometry, warnings) = MeshGeometry::check_external(gears[0], gears[1], self.center_distance())?;
        let phase_of_first = scene.bodies[first.0].phase;
        let sense = drive_sense(scene, self.bodies, self.speeds[0])?;
        let mounting = Mounting {
            first: PlanePose { angle: self.poses[0].angle + phase_of_first, ..self.poses[0] },
            second: self.poses[1],
            angular_velocity: self.speeds,
            sense,
        };
        let (phase, mesh) = mount_external(gears, &geometry, &mounting)?;
        scene.bodies[second.0].phase = phase;
        let surface = if sense > 0.0 { 0 } else { 1 };
        let grid = GridOptions {
            half_cells: options.half_cells,
            width: options.grid_width,
            edges: options.tip_corner_contact,
        };
        let pair = SurfacePair { bodies: self.bodies, surfaces: [surface; 2], grid, mesh: Some(mesh) };
        Ok(Meshed { pair: scene.add_pair(pair), geometry, warnings })
    }
}

/// The gear that a body carries, if it does.
pub fn gear_of(scene: &Scene, body: BodyId) -> Option<&GearPrototype> {
    let prototype: &dyn Any = scene.bodies.get(body.0)?.prototype.as_ref();
    prototype.downcast_ref()
}

/// A frame that is upright at Time = 0 may tilt later.
fn turns_in_the_plane(motion: &dyn Motion) -> Result<(), EngineError> {
    let rate = motion.rate(0.0);
    // Row and column of e3 in the rotation: its rate is perpendicular to it, so these four hold all tilting.
    let fastest = rate[..9].iter().fold(0.0, |most: f64, entry| most.max(entry.abs()));
    if [2, 5, 6, 7].iter().any(|&entry| rate[entry].abs() > 1e-9 * fastest) {
        return Err(EngineError::new(
            "E0610",
            "a plane model needs every body to turn about an axis parallel to e3",
            "let the frame use rotations about e3 and translations in the plane only",
        )
        .blame("frame"));
    }
    Ok(())
}

/// Two meshes of the same bodies would share one load in no determined way.
fn meet_once(scene: &Scene, ids: [BodyId; 2]) -> Result<(), EngineError> {
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
            "keep the mesh that was made before in a variable, and use it again",
        )
        .blame("second"));
    }
    Ok(())
}

/// Which way the first body pushes: as its moment turns it, else against the second one's moment, else as it moves.
fn drive_sense(scene: &Scene, bodies: [BodyId; 2], speed: f64) -> Result<f64, EngineError> {
    for id in bodies {
        let body = &scene.bodies[id.0];
        let moment = body.load.at(0.0).moment[2];
        if moment.is_nan() {
            return Err(EngineError::new(
                "E0723",
                format!("the load on body \"{}\" is not a number at Time = 0 s", body.name),
                "look at what gives the load; it says which flanks drive",
            )
            .about(Subject::Body(id.0)));
        }
        // External gears turn against each other, so a moment on the second one asks for the same surfaces.
        if moment != 0.0 {
            return Ok(moment.signum());
        }
    }
    Ok(if speed == 0.0 { 1.0 } else { speed.signum() })
}
