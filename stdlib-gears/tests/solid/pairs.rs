//! Pairs for these tests: with finite elements of the teeth, or as half-spaces behind the exact
//! flanks. Half-spaces cost nothing to build, and all exact properties of contact hold for them as
//! well.

use crate::common::built;
use calyx_gears::assembly::{MeshOptions, Misalignment, add_body, mesh};
use calyx_gears::blank::{GearBlank, Rim};
use calyx_gears::helix::{Hand, Helix};
use calyx_gears::modification::Modification;
use calyx_gears::prototype::GearPrototype;
use calyx_gears::rack::Rack;
use calyx_runtime::contact::solid::Pose;
use calyx_runtime::error::EngineError;
use calyx_runtime::interrupt::Interrupt;
use calyx_runtime::load::Wrench;
use calyx_runtime::material::{Material, Plane};
use calyx_runtime::motion::{Motion, RelocatedMotion, SteadyRotation};
use calyx_runtime::scene::{
    Body, BodyId, Component, Fidelity, GearMesh, PairId, Prototype, Scene, StructureOptions, Template,
};
use calyx_runtime::structure::Structure;
use calyx_runtime::structure::solid::{HalfSpaceBody, Mirror, SolidStructure};
use calyx_runtime::surface::Surface;
use calyx_runtime::system::System;
use std::f64::consts::TAU;
use std::sync::Arc;

pub const MODULE: f64 = 2.5e-3;
pub const FIRST: BodyId = BodyId(0);
pub const SECOND: BodyId = BodyId(1);
pub const MESH: PairId = PairId(0);
pub const TORQUE: f64 = 100.0;
pub const TEETH: [u32; 2] = [20, 31];

/// Gear whose flanks are half-spaces between its side faces.
struct Backed(Arc<GearPrototype>);

impl Prototype for Backed {
    fn build(&self, _: &StructureOptions, _: &Interrupt) -> Result<Arc<dyn Structure>, EngineError> {
        Err(EngineError::new("E0678", "it has no section", ""))
    }

    fn build_solid(
        &self,
        options: &StructureOptions,
        _: &Interrupt,
    ) -> Result<Arc<dyn SolidStructure>, EngineError> {
        let surfaces = self.0.surfaces(options)?.map(|surface| surface as Arc<dyn Surface>);
        let face =
            |end: f64| Mirror { point: [0.0, 0.0, 0.5 * end * self.0.face_width], normal: [0.0, 0.0, end] };
        let modulus = Material::STEEL.surface_modulus(Plane::Strain);
        let solid = HalfSpaceBody::half_space(surfaces.to_vec(), self.0.gear.teeth(), modulus);
        Ok(Arc::new(solid.between(vec![face(-1.0), face(1.0)])))
    }

    fn enclosing_radius(&self) -> f64 {
        self.0.enclosing_radius()
    }

    fn face_width(&self) -> f64 {
        self.0.face_width
    }
}

/// Gear mounted eccentrically on its shaft.
struct Eccentric {
    shaft: SteadyRotation,
    /// Eccentricity of the gear's axis along its x axis, m.
    by: f64,
}

impl Motion for Eccentric {
    fn frame(&self, time: f64) -> [f64; 12] {
        let mut frame = self.shaft.frame(time);
        frame[9] -= self.by;
        frame
    }

    fn rate(&self, time: f64) -> [f64; 12] {
        self.shaft.rate(time)
    }

    fn acceleration(&self, time: f64) -> [f64; 12] {
        self.shaft.acceleration(time)
    }
}

/// Options of a pair.
#[derive(Clone)]
pub struct Options {
    /// Helix of the first gear, with its hand.
    pub helix: Helix,
    pub face_width: f64,
    /// Torque about the first gear's axis, N m.
    pub torque: f64,
    pub half_cells: [usize; 2],
    /// Free components of the first gear in addition to the rotation about its axis.
    pub free: Vec<Component>,
    pub edges: bool,
    /// True for half-spaces instead of finite elements.
    pub backed: bool,
    pub misalignment: Misalignment,
    pub coast_side_contact: bool,
    /// Pose of the whole pair, including its load.
    pub place: Pose,
    /// Eccentricity of each gear on its shaft, m: along the gear's x axis.
    pub eccentricity: [f64; 2],
    /// Relative increase of the centre distance over the standard one.
    pub apart: f64,
    /// Modification of the first gear's flanks.
    pub modification: Option<Modification>,
}

impl Options {
    pub fn spur() -> Options {
        Options {
            helix: Helix::SPUR,
            face_width: 8.0 * MODULE,
            torque: TORQUE,
            half_cells: [6, 4],
            free: Vec::new(),
            edges: false,
            backed: true,
            misalignment: Misalignment::default(),
            coast_side_contact: false,
            place: Pose::IDENTITY,
            eccentricity: [0.0; 2],
            apart: 1e-3,
            modification: None,
        }
    }

    pub fn helical(angle: f64, hand: Hand) -> Options {
        Options { helix: Helix::new(angle, hand).expect("a helix"), ..Options::spur() }
    }

    pub fn scene(&self) -> (Scene, GearMesh) {
        let rack = Rack::new(MODULE, 20_f64.to_radians(), 0.2 * MODULE).expect("a rack");
        let other = Helix::new(self.helix.angle(), self.helix.hand().mirrored()).expect("a helix");
        let gear = |teeth: u32, helix, modification: &Option<Modification>| {
            let blank = GearBlank { helix, ..GearBlank::standard(teeth, rack) };
            let blank = match modification {
                Some(modification) => blank.modified(modification.clone()),
                None => blank,
            };
            let root = 0.5 * blank.root_diameter;
            let rim = Rim::new(2.0 * (root - 0.5 * MODULE), 2.0 * (root - 2.0 * MODULE)).expect("a rim");
            blank.face_width(self.face_width).rim(rim).cut().expect("a gear")
        };
        let gears = [gear(TEETH[0], self.helix, &self.modification), gear(TEETH[1], other, &None)];
        let distance = 0.5 * MODULE * f64::from(TEETH[0] + TEETH[1]) * (1.0 + self.apart);
        let speeds = [TAU, -TAU * f64::from(TEETH[0]) / f64::from(TEETH[1])];
        let motion = |member: usize| {
            let origin = [[0.0, distance][member], 0.0];
            let shaft = SteadyRotation { origin, start: 0.0, speed: speeds[member] };
            let gear = Eccentric { shaft, by: self.eccentricity[member] };
            RelocatedMotion { motion: Arc::new(gear), pose: self.place }
        };
        let moment = |torque: f64| Wrench::of_moment(self.place.direction([0.0, 0.0, torque]));
        let mut scene = Scene::default();
        let mut free = vec![Component::ThetaZ];
        free.extend(&self.free);
        let first = add_body(
            &mut scene,
            Body::new("first", gears[0].clone(), motion(0))
                .free_in(&free)
                .loaded(moment(if self.torque == 0.0 { 1.0 } else { self.torque })),
        )
        .expect("a body");
        let second = add_body(&mut scene, Body::new("second", gears[1].clone(), motion(1))).expect("a body");
        let options = MeshOptions {
            tip_corner_contact: self.edges,
            half_cells: Some(self.half_cells[0]),
            half_slices: self.half_cells[1],
            misalignment: self.misalignment,
            coast_side_contact: self.coast_side_contact,
            ..MeshOptions::default()
        };
        let meshed = mesh(&mut scene, first, second, &options).expect("they mesh");
        scene.bodies[0].load = Arc::new(moment(self.torque));
        if self.backed {
            for (body, gear) in scene.bodies.iter_mut().zip(gears) {
                body.prototype = Arc::new(Backed(gear));
            }
        }
        let mesh = scene.pairs[meshed.pair.0].mesh.clone().expect("gears are in mesh");
        (scene, mesh)
    }
}

/// System of a three-dimensional scene.
pub fn system(scene: &Scene, structure: StructureOptions) -> System<'_> {
    built(scene, Fidelity::Solid(Template::Medium), structure)
}
