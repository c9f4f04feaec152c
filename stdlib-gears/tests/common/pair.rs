//! Pairs of gears as scenes of the engine, without the language: the second gear phased, and the
//! mesh found.

use super::{INCH, built, chapter_5_data};
use calyx_gears::blank::Rim;
use calyx_gears::external::{ExternalGear, ExternalGearData};
use calyx_gears::gear::{Gear, ToothForm};
use calyx_gears::mesh_geometry::MeshGeometry;
use calyx_gears::modification::{Modification, ReliefShape};
use calyx_gears::mounting::{Mounting, mount};
use calyx_gears::prototype::GearPrototype;
use calyx_runtime::error::EngineError;
use calyx_runtime::inertia::Inertia;
use calyx_runtime::interrupt::Interrupt;
use calyx_runtime::load::Wrench;
use calyx_runtime::material::Material;
use calyx_runtime::motion::{PlanePose, SteadyRotation};
use calyx_runtime::observables::Observe;
use calyx_runtime::observables::{
    LoadShare, MaxContactPressure, MaxEdgePressure, MaxRootStress, MeshStiffness, Observable,
    TransmissionError,
};
use calyx_runtime::scene::{
    Body, BodyId, BodyModel, Component, Fidelity, GearMesh, GridOptions, Ignored, PairId, Prototype, Scene,
    StructureOptions, SurfacePair, Template,
};
use calyx_runtime::step::StepResult;
use calyx_runtime::structure::{BodyModes, BoreSupport, Structure};
use calyx_runtime::system::System;
use std::f64::consts::TAU;
use std::sync::{Arc, LazyLock, Mutex};

pub const PSI: f64 = 6894.757293168361;
pub const LBF: f64 = 4.4482216152605;
/// Torque on the pinion, 1000 lbf in.
pub const TORQUE: f64 = 1000.0 * LBF * INCH;
pub const MESH: PairId = PairId(0);
pub const FIRST: BodyId = BodyId(0);
pub const SECOND: BodyId = BodyId(1);

type Structures = Arc<Mutex<Vec<(StructureOptions, Arc<dyn Structure>)>>>;

/// Gear whose structures are built once for all scenes that use it.
#[derive(Clone)]
pub struct Member {
    pub prototype: Arc<GearPrototype>,
    /// Pitch deviations in place of the prototype's, rad; they do not change the structure.
    pitch_errors: Vec<f64>,
    structures: Structures,
}

impl Member {
    pub fn new(prototype: GearPrototype) -> Self {
        let pitch_errors = prototype.pitch_errors.clone();
        Self { prototype: Arc::new(prototype), pitch_errors, structures: Structures::default() }
    }

    /// Returns the same gear with a pitch deviation of one tooth, rad.
    pub fn with_pitch_error(&self, tooth: u32, error: f64) -> Self {
        let mut pitch_errors = vec![0.0; self.form().teeth as usize];
        pitch_errors[tooth as usize] = error;
        Self { pitch_errors, ..self.clone() }
    }

    /// Returns the gear on the structures of another gear that has the same structural data.
    pub fn sharing(self, other: &Member) -> Self {
        Self { structures: other.structures.clone(), ..self }
    }

    pub fn gear(&self) -> &ExternalGear {
        self.prototype.gear.external().expect("an external gear")
    }

    pub fn form(&self) -> ToothForm {
        self.prototype.form()
    }
}

impl Prototype for Member {
    fn build(
        &self,
        options: &StructureOptions,
        interrupt: &Interrupt,
    ) -> Result<Arc<dyn Structure>, EngineError> {
        let known = || {
            let structures = self.structures.lock().expect("nothing panics under the lock");
            structures.iter().find(|(known, _)| known == options).map(|(_, built)| built.clone())
        };
        // Built without the lock: a thread that waits for its share of the work may have to build
        // the same gear.
        let built = match known() {
            Some(built) => return Ok(built),
            None => self.prototype.build(options, interrupt)?,
        };
        self.structures.lock().expect("nothing panics under the lock").push((*options, built.clone()));
        Ok(built)
    }

    fn shape(
        &self,
        shared: Arc<dyn Structure>,
        options: &StructureOptions,
    ) -> Result<Arc<dyn Structure>, EngineError> {
        self.prototype.shape(shared, options)
    }

    fn enclosing_radius(&self) -> f64 {
        self.prototype.enclosing_radius()
    }

    fn roll_angle(&self, radius: f64) -> Option<f64> {
        self.prototype.roll_angle(radius)
    }

    fn face_width(&self) -> f64 {
        self.prototype.face_width()
    }

    fn inertia(&self) -> Inertia {
        self.prototype.inertia()
    }

    fn modes(
        &self,
        options: &StructureOptions,
        highest: f64,
        interrupt: &Interrupt,
    ) -> Result<Option<Arc<BodyModes>>, EngineError> {
        self.prototype.modes(options, highest, interrupt)
    }

    fn pitch_error(&self, tooth: u32) -> f64 {
        self.pitch_errors.get(tooth as usize).copied().unwrap_or(0.0)
    }

    fn ignored(&self, fidelity: Fidelity) -> Vec<Ignored> {
        self.prototype.ignored(fidelity)
    }
}

pub fn steel() -> Material {
    Material { youngs_modulus: 3e7 * PSI, poissons_ratio: 0.3, density: 7850.0 }
}

/// Scale factors of the chapter 5 pair: lengths and Young's modulus.
#[derive(Clone, Copy)]
pub struct Scale {
    pub length: f64,
    pub modulus: f64,
}

/// Member of the scaled chapter 5 pair with a quadratic tip relief of this depth in inches (0 for
/// none).
pub fn chapter_5_member(teeth: u32, relief: f64, scale: Scale) -> Member {
    let Scale { length, modulus } = scale;
    let mut data = chapter_5_data(teeth, 0.02, 0.15708);
    data.rack.module *= length;
    data.rack.tip_radius *= length;
    data.tooth_thickness *= length;
    data.outer_radius *= length;
    data.root_radius *= length;
    let (rim, start_roll) = if teeth == 20 { ([0.7, 0.6], 27.25) } else { ([1.7, 1.2], 19.60) };
    let relief = (relief > 0.0).then(|| {
        let start_roll = f64::to_radians(start_roll);
        Modification::tip_relief(relief * INCH * length, start_roll, ReliefShape::Quadratic)
    });
    let material = Material { youngs_modulus: modulus * steel().youngs_modulus, ..steel() };
    let [radius, fixed_radius] = rim.map(|radius| radius * INCH * length);
    let gear = ExternalGear::new(data).expect("a sound gear");
    let modifications = relief.into_iter().collect();
    let rim = Rim { radius, fixed_radius, web: None, support: BoreSupport::Rigid };
    let face_width = INCH * length;
    Member::new(
        GearPrototype::new(gear, modifications, material, rim, face_width, Vec::new()).expect("a gear"),
    )
}

/// Steel gear on a rim three modules thick.
pub fn member(data: ExternalGearData, face_width: f64) -> Member {
    let rim = Rim {
        radius: data.root_radius - data.rack.module,
        fixed_radius: data.root_radius - 3.0 * data.rack.module,
        web: None,
        support: BoreSupport::Rigid,
    };
    let gear = ExternalGear::new(data).expect("a sound gear");
    Member::new(GearPrototype::new(gear, Vec::new(), steel(), rim, face_width, Vec::new()).expect("a gear"))
}

pub const UNSCALED: Scale = Scale { length: 1.0, modulus: 1.0 };

/// Chapter 5 pair without modifications, and with its quadratic tip relief.
pub static PLAIN: LazyLock<[Member; 2]> =
    LazyLock::new(|| [20, 40].map(|teeth| chapter_5_member(teeth, 0.0, UNSCALED)));
pub static RELIEVED: LazyLock<[Member; 2]> =
    LazyLock::new(|| [20, 40].map(|teeth| chapter_5_member(teeth, 0.0005, UNSCALED)));

/// Options of a pair. The loaded gear is free to rotate, the other one is fixed.
#[derive(Clone)]
pub struct PairOptions {
    pub gears: [Member; 2],
    pub center_distance: f64,
    /// Index of the loaded, free gear.
    pub loaded: usize,
    /// Moment on the loaded gear, counter-clockwise, N m. Its sign selects the flanks that touch; 0
    /// acts like a vanishing positive moment.
    pub moment: f64,
    /// Angle of the first gear at time 0, and its speed, counter-clockwise.
    pub start: f64,
    pub speed: f64,
    pub edges: bool,
    pub grid_width: Option<f64>,
    /// Position of the first gear's axis, and the direction from it to the second one.
    pub origin: [f64; 2],
    pub direction: f64,
}

impl PairOptions {
    /// The chapter 5 pair at 3 rpm, with contact on the nominal path only.
    pub fn chapter_5(gears: &[Member; 2]) -> Self {
        Self {
            gears: gears.clone(),
            center_distance: 3.0 * INCH,
            loaded: 0,
            moment: TORQUE,
            start: 0.0,
            speed: 0.05 * TAU,
            edges: false,
            grid_width: None,
            origin: [0.0; 2],
            direction: 0.0,
        }
    }
}

/// All observables of a pair, in the order of [`Values`].
const OBSERVED: [&dyn Observable; 7] = [
    &TransmissionError(MESH),
    &LoadShare(MESH),
    &MeshStiffness(MESH),
    &MaxContactPressure(MESH),
    &MaxEdgePressure(MESH),
    &MaxRootStress(FIRST),
    &MaxRootStress(SECOND),
];

/// Scene of a pair with all observables, and its mesh.
pub fn pair(options: &PairOptions) -> (Scene, GearMesh) {
    let [first, second] = [0, 1].map(|i| options.gears[i].form());
    let external = options.gears[0].gear();
    let geometry = match &options.gears[1].prototype.gear {
        Gear::External(second) => MeshGeometry::external(external, second, options.center_distance),
        Gear::Internal(second) => MeshGeometry::internal(external, second, options.center_distance),
    };
    let geometry = geometry.expect("they mesh");
    let (sin, cos) = options.direction.sin_cos();
    let across = [cos, sin].map(|part| part * options.center_distance);
    let origins = [options.origin, [0, 1].map(|axis| options.origin[axis] + across[axis])];
    let speeds =
        [options.speed, -second.sense() * options.speed * f64::from(first.teeth) / f64::from(second.teeth)];
    // As in the language, the moment selects the flanks that touch.
    let sense = if options.moment < 0.0 { -1.0 } else { 1.0 };
    let sense = if options.loaded == 1 { sense * second.sense() } else { sense };
    let mounting = Mounting {
        first: PlanePose { origin: origins[0], angle: options.start },
        second: PlanePose { origin: origins[1], angle: 0.0 },
        angular_velocity: speeds,
        sense,
    };
    let (phase, mesh) = mount([first, second], &geometry, &mounting).expect("they fit");

    let mut scene = Scene::default();
    for side in 0..2 {
        let loaded = side == options.loaded;
        let motion =
            SteadyRotation { origin: origins[side], start: [options.start, 0.0][side], speed: speeds[side] };
        let mut body = Body::new(["first", "second"][side], Arc::new(options.gears[side].clone()), motion);
        body.phase = [0.0, phase][side];
        if loaded {
            body = body.free_in(&[Component::ThetaZ]).loaded(Wrench::of_moment([0.0, 0.0, options.moment]));
        }
        scene.add_body(body);
    }
    let surface = if sense > 0.0 { 0 } else { 1 };
    scene.add_pair(SurfacePair {
        friction: 0.0,
        bodies: [FIRST, SECOND],
        surfaces: [surface, if second.internal { 1 - surface } else { surface }],
        grid: GridOptions { width: options.grid_width, edges: options.edges, ..GridOptions::default() },
        mesh: Some(mesh.clone()),
        front: None,
        lubrication: None,
    });
    // In the order of `Values`.
    scene.add_observable(TransmissionError(MESH));
    scene.add_observable(LoadShare(MESH));
    scene.add_observable(MeshStiffness(MESH));
    scene.add_observable(MaxContactPressure(MESH));
    scene.add_observable(MaxEdgePressure(MESH));
    scene.add_observable(MaxRootStress(FIRST));
    scene.add_observable(MaxRootStress(SECOND));
    (scene, mesh)
}

/// Observed values of a solved pair, SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Values {
    pub transmission_error: f64,
    pub load_share: f64,
    pub mesh_stiffness: f64,
    pub contact_pressure: f64,
    pub edge_pressure: f64,
    pub root_stress: [f64; 2],
}

impl Values {
    pub fn of(system: &System<'_>, step: &StepResult) -> Self {
        let [transmission_error, load_share, mesh_stiffness, contact_pressure, edge_pressure, first, second] =
            OBSERVED.map(|observable| system.value(step, observable).value);
        Self {
            transmission_error,
            load_share,
            mesh_stiffness,
            contact_pressure,
            edge_pressure,
            root_stress: [first, second],
        }
    }

    /// Largest relative difference of any value. Zero only equals zero.
    pub fn difference(&self, other: &Self) -> f64 {
        let list = |v: &Self| {
            let [a, b] = v.root_stress;
            [v.transmission_error, v.load_share, v.mesh_stiffness, v.contact_pressure, v.edge_pressure, a, b]
        };
        let pairs = list(self).into_iter().zip(list(other));
        pairs.map(|(a, b)| if a == b { 0.0 } else { (a - b).abs() / a.abs().max(b.abs()) }).fold(
            0.0,
            |worst, d| {
                // NaN must not count as a small difference.
                if d.is_nan() { f64::INFINITY } else { d.max(worst) }
            },
        )
    }
}

/// Coarse mesh that is built quickly, for properties that hold on any mesh.
pub const COARSE: StructureOptions = StructureOptions {
    refinement: 0.5,
    order: 2,
    model: BodyModel::Elements,
    template: Template::Medium,
    face_elements: None,
    axial_order: None,
    matching_depth: 1.0,
    stresses: true,
    sharp_edges: false,
    raceway_degrees: 0,
};

/// System of the scene on a coarse mesh.
pub fn system(scene: &Scene) -> System<'_> {
    system_of(scene, COARSE)
}

pub fn system_of(scene: &Scene, structure: StructureOptions) -> System<'_> {
    built(scene, Fidelity::Plane, structure)
}

/// Values of a pair at fractions of its mesh cycle, on a coarse mesh.
pub fn solve_at(options: &PairOptions, cycles: &[f64]) -> Vec<Values> {
    let (scene, mesh) = pair(options);
    let system = system(&scene);
    cycles
        .iter()
        .map(|cycle| {
            let step = system.solve(mesh.start + cycle * mesh.period).expect("it is in equilibrium");
            Values::of(&system, &step)
        })
        .collect()
}
