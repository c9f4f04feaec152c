//! System of a planned scene: condensed structures, numbered DOFs and loads. All positions share
//! it.

use crate::derived::DerivedResults;
use crate::modal::Modes;
use crate::raceways::{self, RacewaySet, dense};
use calyx_contact::solid::Pose;
use calyx_fe::inertia::Inertia;
use calyx_model::bearing::{ElasticRaceways, NonlinearLoad, Springs, Tangent, springs};
use calyx_model::connection::{
    ElasticConnection, add_connection_mass, add_connection_stiffness, add_mode_coupling,
};
use calyx_model::connection_building::build_connections;
use calyx_model::fidelity::Fidelity;
use calyx_model::flanks::{add_flanks, spline_contacts};
use calyx_model::frames::{axes, loads_on, number_dofs, pose, solid_pose};
use calyx_model::mechanism::Mechanism;
use calyx_model::mesh_carrier::MovingAxes;
use calyx_model::motion::{Orientation, PlanePose, axle, moved_by, point_velocity};
use calyx_model::plan::{BodyPlan, Plan, face_widths};
use calyx_model::resources::Resources;
use calyx_model::spline_contact::SplineContact;
use calyx_model::structure_building::StructureCounts;
use calyx_model::structure_building::{Structures, build_structures};
use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::Interrupt;
use calyx_structure::solid::SolidStructure;
use calyx_structure::{AnyStructure, Raceway, Structure};
use nalgebra::DMatrix;
use std::sync::{Arc, OnceLock};

pub use calyx_model::dof::Dof;

/// Surface pair and a pair of its teeth.
pub type Teeth = (usize, [u32; 2]);

/// Data that all positions share.
pub struct System<'s> {
    /// Simulated mechanism.
    pub scene: &'s Mechanism,
    /// Models of the bodies.
    pub bodies: Bodies,
    /// Free components of the frames of bodies, in the order of the unknowns.
    pub dofs: Vec<Dof>,
    /// Axis positions by body, see [`axle`].
    axles: Vec<[f64; 3]>,
    /// Moving axes of every pair; `None` for fixed ones.
    pub(crate) moving_axes: Vec<Option<MovingAxes>>,
    /// Modelled bearings, by index in the scene.
    pub bearings: Vec<usize>,
    /// Modelled elastic connections, by index in the scene.
    pub connections: Vec<usize>,
    /// Elastic connections of the scene with the matrices of condensed bodies.
    pub elastic_connections: Arc<Vec<ElasticConnection>>,
    /// Bearings on elastic raceways.
    pub(crate) raceways: RacewaySet,
    /// Spline teeth with clearance, by the index of the body that they support.
    pub spline_teeth: Vec<(usize, SplineContact)>,
    /// Callback at every checkpoint.
    pub interrupt: Interrupt,
    /// True for rigid bodies, which touch as the load vanishes.
    pub rigid: bool,
    /// True if rollers of bearings have elastic contacts, false if they have laminae.
    elastic_rollers: bool,
    /// Modes of bodies, in transient analyses or vibrations about an equilibrium; empty unless
    /// requested ([`System::with_modes`]).
    pub modes: Modes,
    structure_counts: StructureCounts,
    /// Inertias of all bodies about their axes of rotation, computed on request, because those of
    /// gears require their meshes.
    inertias: OnceLock<Vec<Inertia>>,
    /// True for bodies that the plan leaves out.
    pub left_out: Vec<bool>,
    /// Results that observables derive from other positions than their own.
    pub derived: DerivedResults,
}

/// Models of the bodies of a scene, in order; `None` for a body that the plan leaves out.
#[derive(Clone)]
pub enum Bodies {
    /// Plane strain, per metre of face width.
    Plane(PlaneBodies),
    /// Three-dimensional.
    Solid(SolidBodies),
}

impl Bodies {
    /// Returns the raceway in the bore of a body, by its index, with the plane-strain modulus of
    /// the body (Pa) and the compliance of its terms.
    fn raceway(&self, body: usize) -> Option<(Raceway, f64, DMatrix<f64>)> {
        match self {
            Bodies::Plane(bodies) => {
                let structure = bodies.structures.get(body)?.as_deref()?;
                let compliance = dense(structure.interface_compliance()?);
                Some((structure.raceway()?, structure.surface_modulus(), compliance))
            }
            Bodies::Solid(bodies) => {
                let structure = bodies.structures.get(body)?.as_deref()?;
                let compliance = dense(structure.interface_compliance()?);
                Some((structure.raceway()?, structure.surface_modulus(), compliance))
            }
        }
    }

    /// Adds the structures, which must be of the kind that the plan requires.
    fn with(self, structures: Structures) -> Bodies {
        match self {
            Bodies::Plane(bodies) => {
                let plane = |structure| match structure {
                    Some(AnyStructure::Plane(structure)) => Some(structure),
                    _ => None,
                };
                Bodies::Plane(PlaneBodies {
                    structures: structures.into_iter().map(plane).collect(),
                    ..bodies
                })
            }
            Bodies::Solid(bodies) => {
                let solid = |structure| match structure {
                    Some(AnyStructure::Solid(structure)) => Some(structure),
                    _ => None,
                };
                Bodies::Solid(SolidBodies {
                    structures: structures.into_iter().map(solid).collect(),
                    ..bodies
                })
            }
        }
    }
}

/// Checks that a plan has something to solve: surfaces that touch, or free bodies on bearings.
///
/// # Errors
/// E0713: the scene has neither.
pub fn check_content(scene: &Mechanism, plan: &Plan) -> Result<(), EngineError> {
    if plan.bodies.iter().any(BodyPlan::is_elastic) || !number_dofs(scene, plan).is_empty() {
        return Ok(());
    }
    Err(EngineError::new(
        "E0713",
        "the scene has neither surfaces that touch nor free bodies on bearings",
        "mesh two bodies, like `gears.mesh(pinion, gear)`, or mount a body that is `free` on bearings",
    ))
}

/// Bodies of a plane model.
#[derive(Clone)]
pub struct PlaneBodies {
    /// Elastic behaviour by body; `None` of a body that has no structure.
    pub structures: Vec<Option<Arc<dyn Structure>>>,
    /// Width of each body in the plane model, m.
    face_widths: Vec<f64>,
    /// Poses at time 0, the origin of kinematic angles.
    initial: Vec<PlanePose>,
}

/// Bodies of a three-dimensional model.
#[derive(Clone)]
pub struct SolidBodies {
    /// Elastic behaviour by body; `None` of a body that has no structure.
    pub structures: Vec<Option<Arc<dyn SolidStructure>>>,
    /// Rotation angles at time 0, rad.
    initial: Vec<f64>,
}

impl<'s> System<'s> {
    /// Builds the planned system, without a cache and without an interrupt.
    ///
    /// # Errors
    /// Those of [`System::with`].
    pub fn new(scene: &'s Mechanism, plan: &Plan) -> Result<Self, EngineError> {
        Self::with(scene, plan, &Resources::default())
    }

    /// Builds the planned system. Bodies with equal structures share one.
    ///
    /// # Errors
    /// Those of [`check_content`]; a frame is invalid, a structure cannot be built, or those of the
    /// interrupt.
    pub fn with(scene: &'s Mechanism, plan: &Plan, resources: &Resources) -> Result<Self, EngineError> {
        let dofs = number_dofs(scene, plan);
        check_content(scene, plan)?;
        let all = 0..scene.bodies.len();
        // Check the frames before the expensive work.
        let bodies = match plan.three_dimensional {
            false => {
                let initial = all.map(|body| pose(scene, body, 0.0)).collect::<Result<_, _>>()?;
                Bodies::Plane(PlaneBodies {
                    structures: Vec::new(),
                    face_widths: face_widths(scene),
                    initial,
                })
            }
            true => {
                let angle = |body| solid_pose(scene, body, 0.0).map(|pose| Orientation::of(&pose).angle);
                let initial = all.map(angle).collect::<Result<_, _>>()?;
                Bodies::Solid(SolidBodies { structures: Vec::new(), initial })
            }
        };
        let (structures, structure_counts) = build_structures(scene, plan, resources)?;
        let bodies = bodies.with(structures);
        let (elastic_connections, condensed) = build_connections(scene, plan, resources)?;
        let structure_counts = structure_counts + condensed;
        let interrupt = resources.interrupt.clone();
        let (bearings, connections) = (plan.modelled_bearings(), plan.modelled_connections());
        let axles = scene.bodies.iter().map(|body| axle(body.motion.as_ref())).collect();
        let (spline_teeth, modes) = (spline_contacts(scene, plan), Modes::default());
        let elastic_rollers = plan.fidelity.has_elastic_rollers();
        // Laminae have rigid raceways.
        let seats = if elastic_rollers { &elastic_connections[..] } else { &[] };
        let raceways = raceways::find(scene, &bearings, seats, |body| bodies.raceway(body));
        let mut system = System {
            scene,
            bodies,
            dofs,
            axles,
            moving_axes: Vec::new(),
            bearings,
            connections,
            elastic_connections: Arc::new(elastic_connections),
            raceways,
            spline_teeth,
            interrupt,
            rigid: plan.fidelity == Fidelity::Rigid,
            elastic_rollers,
            modes,
            structure_counts,
            inertias: OnceLock::new(),
            left_out: plan.bodies.iter().map(|body| body.left_out).collect(),
            derived: DerivedResults::default(),
        };
        system.moving_axes = system.find_moving_axes()?;
        Ok(system)
    }

    /// Adds the modes of the bodies up to a natural frequency (Hz), for vibrations about an
    /// equilibrium; 0 adds none.
    ///
    /// # Errors
    /// E0764: the frequency is invalid. E0771: the system is three-dimensional and has no
    /// elastic body. Those of
    /// [`Resources::modes`].
    pub fn with_modes(
        mut self,
        plan: &Plan,
        resources: &Resources,
        highest_frequency: f64,
    ) -> Result<Self, EngineError> {
        self.modes = Modes::find(self.scene, plan, resources, highest_frequency)?;
        Ok(self)
    }

    /// Returns a system with the same structures and modes for a scene that differs only in data
    /// that they do not depend on, such as contact grids.
    pub fn on<'t>(&self, scene: &'t Mechanism) -> System<'t> {
        System {
            scene,
            bodies: self.bodies.clone(),
            dofs: self.dofs.clone(),
            axles: self.axles.clone(),
            moving_axes: self.moving_axes.clone(),
            bearings: self.bearings.clone(),
            connections: self.connections.clone(),
            elastic_connections: self.elastic_connections.clone(),
            raceways: self.raceways.clone(),
            spline_teeth: self.spline_teeth.clone(),
            interrupt: self.interrupt.clone(),
            modes: self.modes.clone(),
            structure_counts: self.structure_counts,
            rigid: self.rigid,
            elastic_rollers: self.elastic_rollers,
            inertias: OnceLock::new(),
            left_out: self.left_out.clone(),
            derived: DerivedResults::default(),
        }
    }

    /// Returns the nonlinear load of a bearing by its index in the scene, at the contact model of
    /// this fidelity and at a time, s. `None` without one.
    pub fn nonlinear_load(&self, bearing: usize, time: f64) -> Option<NonlinearLoad> {
        let nonlinear = self.scene.bearings.get(bearing)?.nonlinear.as_ref()?;
        // Elements that orbit share the contacts of those at time 0.
        Some(match self.elastic_rollers {
            true => nonlinear.with_elastic_rollers().at_time(time),
            false => nonlinear.at_time(time),
        })
    }

    /// Returns the elastic raceways of a bearing by its index in the scene at a time (s); `None`
    /// for one between rigid rings.
    ///
    /// # Errors
    /// Those of [`ElasticRaceways::at`].
    pub fn elastic_raceways(
        &self,
        bearing: usize,
        time: f64,
    ) -> Result<Option<ElasticRaceways>, EngineError> {
        let on = self.raceways.bearings.iter().find(|on| on.bearing == bearing);
        let load = on.and_then(|_| self.nonlinear_load(bearing, time));
        let (Some(on), Some(NonlinearLoad::Rolling(elements))) = (on, load) else {
            return Ok(None);
        };
        on.at(self.scene, &elements, |body| self.width(body), time).map(Some)
    }

    /// Returns the inertias of all bodies about their axes of rotation.
    pub fn inertias(&self) -> &[Inertia] {
        self.inertias.get_or_init(|| {
            let bodies = self.scene.bodies.iter().enumerate();
            bodies.map(|(index, body)| body.inertia().from(self.axle(index))).collect()
        })
    }

    /// Returns the number of teeth of a body; `None` if it has no surfaces.
    pub fn teeth(&self, body: usize) -> Option<u32> {
        match &self.bodies {
            Bodies::Plane(bodies) => bodies.structures[body].as_deref().map(Structure::teeth),
            Bodies::Solid(bodies) => bodies.structures[body].as_deref().map(SolidStructure::teeth),
        }
    }

    /// Returns the numbers of structures that were built and reused for this system.
    pub fn structure_counts(&self) -> StructureCounts {
        self.structure_counts
    }

    /// Returns the width to which contact forces on a body refer, by the body's index: the face
    /// width of a plane model, m; 1 in three dimensions. Bodies connected by contact or bearings
    /// have equal widths.
    pub fn width(&self, body: usize) -> f64 {
        match &self.bodies {
            Bodies::Plane(bodies) => bodies.face_widths[body],
            Bodies::Solid(_) => 1.0,
        }
    }

    /// Returns the elastic connections with component modes, and the index of the first mode of
    /// each among those of all.
    pub fn connection_modes(&self) -> Vec<(&ElasticConnection, usize)> {
        let mut first = 0;
        let planned = self.connections.iter().filter_map(|&index| self.elastic_connections.get(index));
        let with_modes = planned.filter(|connection| connection.modes.count() > 0);
        let numbered = with_modes.map(|connection| {
            first += connection.modes.count();
            (connection, first - connection.modes.count())
        });
        numbered.collect()
    }

    /// Returns the number of modal coordinates in vibrations: modes of gears, and component modes
    /// of elastic bodies.
    pub fn mode_count(&self) -> usize {
        let connections = self.connection_modes();
        self.modes.count() + connections.iter().map(|(connection, _)| connection.modes.count()).sum::<usize>()
    }

    /// Returns the modes of all modal coordinates of [`System::mode_count`]. Those of elastic
    /// connections move no contact cell.
    pub fn all_modes(&self) -> Modes {
        let connections = self.connection_modes();
        let of_connections = connections.iter().flat_map(|(connection, _)| &connection.modes.eigenvalues);
        self.modes.followed_by(of_connections)
    }

    /// Returns the mass between the DOFs (rows) and the component modes of all elastic connections
    /// at a time (s), row-major.
    ///
    /// # Errors
    /// A frame is invalid.
    pub fn connection_mode_coupling(&self, time: f64) -> Result<Vec<f64>, EngineError> {
        let mut coupling = vec![0.0; self.dofs.len() * (self.mode_count() - self.modes.count())];
        let parts = (&self.scene.bodies[..], &self.elastic_connections[..]);
        add_mode_coupling(&mut coupling, parts, &self.connections, &self.dofs, time)?;
        Ok(coupling)
    }

    /// Returns the external generalized forces on the DOFs at a time, per [`System::width`].
    pub fn load_at(&self, time: f64) -> Result<Vec<f64>, EngineError> {
        self.scaled_load(time, 1.0)
    }

    /// Returns the external forces with the loads scaled by `part` and all impulses unscaled.
    pub fn scaled_load(&self, time: f64, part: f64) -> Result<Vec<f64>, EngineError> {
        let loads = loads_on(self.scene, &self.dofs, time, part)?;
        Ok(loads.iter().zip(&self.dofs).map(|(load, on)| load / self.width(on.body)).collect())
    }

    /// Returns stiffness and forces of bearings, elastic connections and spline teeth with
    /// clearance at a time, per [`System::width`].
    /// Nonlinear bearings have their typical stiffness.
    pub fn springs_at(&self, time: f64) -> Result<Springs, EngineError> {
        self.springs_with(time, &[])
    }

    /// Returns the springs of [`System::springs_at`] with linearized nonlinear loads, by
    /// bearing of the scene.
    pub fn springs_with(&self, time: f64, tangents: &[Option<Tangent>]) -> Result<Springs, EngineError> {
        let mut springs = {
            let Mechanism { bodies, bearings, .. } = self.scene;
            let width = |body| self.width(body);
            springs(bodies, bearings, &self.bearings, &self.dofs, width, time, tangents)?
        };
        add_connection_stiffness(
            &mut springs.stiffness,
            (&self.scene.bodies, &self.elastic_connections),
            &self.connections,
            &self.dofs,
            |body| self.width(body),
            time,
        )?;
        for (body, contact) in &self.spline_teeth {
            let structure = match &self.bodies {
                Bodies::Plane(bodies) => bodies.structures.get(*body).and_then(Option::as_deref),
                Bodies::Solid(_) => None,
            };
            let between = structure.and_then(Structure::interface_compliance);
            add_flanks(&mut springs, self.scene, (*body, contact), &self.dofs, time, between)?;
        }
        Ok(springs)
    }

    /// Returns the forces of the linear or linearized stiffness of bearings and elastic connections
    /// on all six components of each body by motions of the DOFs: along and about the directions of
    /// its DOFs, N and N m.
    ///
    /// # Errors
    /// Those of [`System::springs_with`].
    pub fn spring_forces(
        &self,
        time: f64,
        tangents: &[Option<Tangent>],
        motion: &[f64],
    ) -> Result<Vec<[f64; 6]>, EngineError> {
        let bodies = 0..self.scene.bodies.len();
        let all: Vec<Dof> =
            bodies.flat_map(|body| (0..6).map(move |component| Dof { body, component })).collect();
        let Mechanism { bodies, bearings, .. } = self.scene;
        let mut stiffness =
            springs(bodies, bearings, &self.bearings, &all, |_| 1.0, time, tangents)?.stiffness;
        let parts = (&bodies[..], &self.elastic_connections[..]);
        add_connection_stiffness(&mut stiffness, parts, &self.connections, &all, |_| 1.0, time)?;
        let mut whole = vec![0.0; all.len()];
        for (dof, moved) in self.dofs.iter().zip(motion) {
            whole[6 * dof.body + dof.component] = *moved;
        }
        let force =
            |row: &[f64]| 0.0 - row.iter().zip(&whole).map(|(entry, moved)| entry * moved).sum::<f64>();
        let forces: Vec<f64> = stiffness.chunks_exact(all.len().max(1)).map(force).collect();
        Ok(forces.chunks_exact(6).map(|six| std::array::from_fn(|k| six[k])).collect())
    }

    /// Adds the mass of elastic connections at a time to a mass matrix of the DOFs, row-major, per
    /// `width` of a body.
    ///
    /// # Errors
    /// Those of [`calyx_model::connection::ConnectionState::at`].
    pub fn add_connection_mass(
        &self,
        mass: &mut [f64],
        width: impl Fn(usize) -> f64,
        time: f64,
    ) -> Result<(), EngineError> {
        let parts = (&self.scene.bodies[..], &self.elastic_connections[..]);
        add_connection_mass(mass, parts, &self.connections, &self.dofs, width, time)
    }

    /// Returns the number of gap equations of bearing stops; those of spline teeth follow them.
    pub fn stops(&self) -> usize {
        self.bearings.iter().map(|&bearing| self.scene.bearings[bearing].walls()).sum()
    }

    /// Returns the number of gap equations of spline tooth flanks.
    pub fn flanks(&self) -> usize {
        self.spline_teeth.iter().map(|(_, contact)| contact.flanks()).sum()
    }

    /// Returns the pitch deviation of a tooth as an angle, rad.
    pub fn pitch_error(&self, body: usize, tooth: u32) -> f64 {
        self.scene.bodies[body].prototype.pitch_error(tooth)
    }

    /// Returns the prescribed rotation of a body about its own axis since time 0, rad, modulo whole
    /// revolutions; NaN if the motion is NaN.
    pub fn turned(&self, body: usize, time: f64) -> f64 {
        match &self.bodies {
            Bodies::Plane(bodies) => {
                pose(self.scene, body, time).map_or(f64::NAN, |pose| pose.angle - bodies.initial[body].angle)
            }
            Bodies::Solid(bodies) => solid_pose(self.scene, body, time)
                .map_or(f64::NAN, |pose| Orientation::of(&pose).angle - bodies.initial[body]),
        }
    }

    /// Extracts the deviations of a body from its prescribed motion from the vector of all DOFs, in
    /// the order of [`calyx_model::dof::DOF_NAMES`]; m and rad.
    pub fn moved(&self, body: usize, motion: &[f64]) -> [f64; 6] {
        let mut by = [0.0; 6];
        for (dof, &moved) in self.dofs.iter().zip(motion).filter(|(dof, _)| dof.body == body) {
            by[dof.component] = moved;
        }
        by
    }

    /// Returns the directions of a body's DOFs: the ground axes under the minimal rotation to the
    /// body's axis.
    pub fn axes(&self, body: usize, time: f64) -> [[f64; 3]; 3] {
        match &self.bodies {
            Bodies::Plane(_) => Pose::IDENTITY.rotation,
            Bodies::Solid(_) => axes(self.scene, body, time),
        }
    }

    /// Returns the position of a body's axis of rotation in the body's coordinates, m, see
    /// [`axle`].
    pub fn axle(&self, body: usize) -> [f64; 3] {
        self.axles[body]
    }

    /// Returns the prescribed position of a body's axis of rotation, m: the origin of its frame
    /// unless the body is eccentric; NaN if its motion is NaN.
    pub fn origin(&self, body: usize, time: f64) -> [f64; 3] {
        let axle = self.axle(body);
        match &self.bodies {
            Bodies::Plane(_) => {
                let [x, y] = pose(self.scene, body, time).map_or([f64::NAN; 2], |pose| pose.point(axle));
                [x, y, 0.0]
            }
            Bodies::Solid(_) => {
                solid_pose(self.scene, body, time).map_or([f64::NAN; 3], |pose| pose.point(axle))
            }
        }
    }

    /// Returns the position of the axis of rotation with the deviations `moved` from the prescribed
    /// motions, m or rad by DOF.
    pub fn displaced_origin(&self, body: usize, time: f64, moved: &[f64]) -> [f64; 3] {
        let (origin, shift) = (self.origin(body, time), self.shift(body, time, moved));
        [0, 1, 2].map(|k: usize| origin[k] + shift[k])
    }

    /// Returns the pose of a body's frame at a time with the deviations `moved` from the prescribed
    /// motion: rotated about its own axis first, then tilted about one axis, which is exact for
    /// rotations of any size.
    ///
    /// # Errors
    /// Those of [`solid_pose`].
    pub fn displaced_pose(&self, body: usize, time: f64, moved: &[f64]) -> Result<Pose, EngineError> {
        let pose = solid_pose(self.scene, body, time)?;
        let by = self.moved(body, moved);
        if by == [0.0; 6] {
            return Ok(pose);
        }
        let axle = self.axle(body);
        let moved = moved_by(&Pose { origin: pose.point(axle), ..pose }, by);
        Ok(Pose { origin: moved.point(axle.map(|part| -part)), ..moved })
    }

    /// Returns the displacement of a body's axis in `moved`, along ground axes, m.
    fn shift(&self, body: usize, time: f64, moved: &[f64]) -> [f64; 3] {
        let [x, y, z, ..] = self.moved(body, moved);
        let axes = self.axes(body, time);
        [0, 1, 2].map(|k: usize| x * axes[0][k] + y * axes[1][k] + z * axes[2][k])
    }

    /// Returns the velocity of the material point of a body at a point in ground coordinates (m),
    /// m/s: the prescribed motion about an axis through the body's displaced origin, with the
    /// deviations `moved`.
    pub fn velocity(&self, body: usize, time: f64, moved: &[f64], point: [f64; 3]) -> [f64; 3] {
        let shift = self.shift(body, time, moved);
        let point = [0, 1, 2].map(|k: usize| point[k] - shift[k]);
        point_velocity(self.scene.bodies[body].motion.as_ref(), time, point)
    }
}
