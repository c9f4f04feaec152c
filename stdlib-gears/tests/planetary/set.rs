//! The planetary set of the tests: the final stage of a helicopter transmission, 27/35/99 teeth, as
//! a scene of the engine.

use crate::common::{built, resources};
use calyx_gears::assembly::{MeshOptions, add_body, mesh};
use calyx_gears::blank::{Rim, SplineSupport};
use calyx_gears::error::Refusal;
use calyx_gears::external::{ExternalGear, ExternalGearData};
use calyx_gears::internal::{InternalGear, InternalGearData};
use calyx_gears::prototype::GearPrototype;
use calyx_gears::rack::Rack;
use calyx_gears::shaper::Shaper;
use calyx_runtime::bearing::{Bearing, axisymmetric};
use calyx_runtime::load::Wrench;
use calyx_runtime::material::Material;
use calyx_runtime::motion::Motion;
use calyx_runtime::plan::Plan;
use calyx_runtime::rigid::RigidBody;
use calyx_runtime::scene::{
    Body, BodyId, BodyModel, Component, Fidelity, GearMesh, PairId, Scene, StructureOptions, Template,
};
use calyx_runtime::structure::BoreSupport;
use calyx_runtime::system::System;
use std::f64::consts::TAU;
use std::sync::{Arc, LazyLock};

pub const SUN_TEETH: u32 = 27;
pub const PLANET_TEETH: u32 = 35;
pub const RING_TEETH: u32 = 99;
/// Centre distance, m.
pub const DISTANCE: f64 = 88.90e-3;
const FACE: f64 = 30e-3;
/// Torque on the sun, N m.
pub const TORQUE: f64 = 1800.0;

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

fn steel() -> Material {
    Material::new(206e9, 0.3, 7850.0).expect("steel")
}

/// Sun or planet with a rigid bore; lengths in m.
pub fn external(teeth: u32, thickness: f64, bore: f64) -> Arc<GearPrototype> {
    let module = 25.4e-3 / 8.857;
    let pitch_radius = 0.5 * f64::from(teeth) * module;
    let rack = Rack::new(module, 24.6_f64.to_radians(), 0.2 * module).expect("a rack");
    let root_radius = pitch_radius - 1.25 * module;
    let gear = ExternalGear::new(ExternalGearData {
        teeth,
        rack,
        tooth_thickness: thickness,
        outer_radius: pitch_radius + module,
        root_radius,
        tip_edge_radius: None,
    })
    .expect("a valid gear");
    let rim =
        Rim { radius: root_radius - module, fixed_radius: bore, web: None, support: BoreSupport::Rigid };
    Arc::new(GearPrototype::new(gear, Vec::new(), steel(), rim, FACE, Vec::new()).expect("a gear"))
}

static SUN: LazyLock<Arc<GearPrototype>> = LazyLock::new(|| external(SUN_TEETH, 4.45e-3, 22e-3));
static PLANET: LazyLock<Arc<GearPrototype>> = LazyLock::new(|| external(PLANET_TEETH, 4.45e-3, 32e-3));
static RING: LazyLock<Arc<GearPrototype>> = LazyLock::new(|| ring(155e-3, BoreSupport::Rigid));

/// Ring gear supported at its outer radius (m).
pub fn ring(outer: f64, support: BoreSupport) -> Arc<GearPrototype> {
    // The operating pitch circle of the mesh with the planets is the ring's pitch circle: the base
    // pitch is that of the rack.
    let module = 2.0 * DISTANCE / f64::from(RING_TEETH - PLANET_TEETH);
    let angle = (25.4e-3 / 8.857 * 24.6_f64.to_radians().cos() / module).acos();
    let gear = InternalGear::new(InternalGearData {
        teeth: RING_TEETH,
        shaper: Shaper::new(33, module, angle, 1.9 * module, 0.2 * module).expect("a shaper"),
        tooth_thickness: 3.04e-3,
        minor_radius: 136.3e-3,
        root_radius: 142.8e-3,
        tip_edge_radius: None,
    })
    .expect("a valid ring gear");
    let rim = Rim { radius: 145.5e-3, fixed_radius: outer, web: None, support };
    Arc::new(GearPrototype::new(gear, Vec::new(), steel(), rim, FACE, Vec::new()).expect("a gear"))
}

/// The default ring on spline teeth.
fn splined(spline: &SplineSupport) -> Arc<GearPrototype> {
    let rim = Rim { radius: 145.5e-3, fixed_radius: 155e-3, web: None, support: BoreSupport::Rigid };
    ring(155e-3, rim.splined(spline).expect("a valid spline").support)
}

/// Steady rotation on a pin that revolves about the origin of ground.
#[derive(Clone, Copy, Debug, Default)]
pub struct Planet {
    /// Position of the pin relative to the carrier's axis, in the carrier, m.
    pub pin: [f64; 2],
    /// Angle of the carrier at time 0, rad, and its speed, rad/s.
    pub carrier: [f64; 2],
    /// Angle and speed of the body relative to the carrier.
    pub own: [f64; 2],
    /// Position of the body's origin relative to its pin, in body coordinates, m.
    pub off: [f64; 2],
}

impl Planet {
    /// Frame, its rate and its second derivative.
    fn at(&self, time: f64) -> [[f64; 12]; 3] {
        let [carrier, own] = [self.carrier, self.own].map(|[start, speed]| start + speed * time);
        let (sine, cosine) = (carrier + own).sin_cos();
        // Ground to body: x' = R(carrier + own) x - R(own) pin - off.
        let (own_sine, own_cosine) = own.sin_cos();
        let [px, py] = self.pin;
        let pin = [own_cosine * px + own_sine * py, -own_sine * px + own_cosine * py];
        let speed = self.carrier[1] + self.own[1];
        let turned = [cosine, sine, 0.0, -sine, cosine, 0.0, 0.0, 0.0, 1.0];
        let rate = [-sine, cosine, 0.0, -cosine, -sine, 0.0, 0.0, 0.0, 0.0].map(|entry| entry * speed);
        let place = [-pin[0] - self.off[0], -pin[1] - self.off[1], 0.0];
        let moving = [-pin[1] * self.own[1], pin[0] * self.own[1], 0.0];
        let join = |r: [f64; 9], t: [f64; 3]| std::array::from_fn(|k| if k < 9 { r[k] } else { t[k - 9] });
        let turning = turned.map(|entry| -entry * speed * speed);
        let turning = std::array::from_fn(|k| if k == 8 { 0.0 } else { turning[k] });
        let falling = [pin[0] * self.own[1].powi(2), pin[1] * self.own[1].powi(2), 0.0];
        [join(turned, place), join(rate, moving), join(turning, falling)]
    }
}

impl Motion for Planet {
    fn frame(&self, time: f64) -> [f64; 12] {
        self.at(time)[0]
    }

    fn rate(&self, time: f64) -> [f64; 12] {
        self.at(time)[1]
    }

    fn acceleration(&self, time: f64) -> [f64; 12] {
        self.at(time)[2]
    }
}

/// Options of a set. Planets rotate freely on fixed pins unless they have bearings.
#[derive(Clone)]
pub struct SetOptions {
    /// Angular positions of the pins, rad.
    pub spacing: Vec<f64>,
    /// Position errors of each pin, radial and circumferential, m.
    pub pin_errors: Vec<[f64; 2]>,
    /// Runout of each planet relative to its rotation axis, in its own axes, m.
    pub runouts: Vec<[f64; 2]>,
    /// Angular velocity of the observer's frame relative to the carrier, rad/s.
    pub seen_from: f64,
    /// Angular velocity of the sun relative to the carrier, rad/s.
    pub speed: f64,
    /// True if the sun may move in the plane.
    pub floating: bool,
    /// Stiffness of the bearings between planets and carrier, N/m.
    pub bearings: Option<f64>,
    pub moment: f64,
    pub mesh: MeshOptions,
    /// Tooth thickness of each planet in place of the default one, m.
    pub thicknesses: Vec<Option<f64>>,
    /// Spline teeth of the ring, which is rigidly supported without; with clearance the spline
    /// teeth are its only support.
    pub ring: Option<SplineSupport>,
}

impl SetOptions {
    pub fn of(spacing: Vec<f64>) -> SetOptions {
        SetOptions {
            pin_errors: vec![[0.0; 2]; spacing.len()],
            thicknesses: vec![None; spacing.len()],
            runouts: vec![[0.0; 2]; spacing.len()],
            spacing,
            seen_from: 0.0,
            speed: SUN_SPEED,
            floating: false,
            bearings: None,
            ring: None,
            moment: TORQUE,
            mesh: MeshOptions { tip_corner_contact: false, half_cells: Some(8), ..MeshOptions::default() },
        }
    }

    pub fn three() -> SetOptions {
        SetOptions::of((0..3).map(|k| TAU * f64::from(k) / 3.0).collect())
    }

    /// Four planets at multiples of a rotation divided by 126, as close to quarters as possible.
    pub fn four() -> SetOptions {
        SetOptions::of([0.0, 31.0, 63.0, 94.0].map(|k| TAU * k / 126.0).to_vec())
    }
}

/// Sun, planets, ring and carrier.
#[derive(Clone)]
pub struct Set {
    pub scene: Scene,
    pub sun: BodyId,
    pub planets: Vec<BodyId>,
    pub ring: BodyId,
    /// Meshes with the sun.
    pub sun_meshes: Vec<PairId>,
    pub ring_meshes: Vec<PairId>,
    pub warnings: Vec<&'static str>,
}

/// Default angular velocity of the sun relative to the carrier, rad/s.
pub const SUN_SPEED: f64 = 100.0;

impl Set {
    pub fn of(options: &SetOptions) -> Result<Set, Refusal> {
        let mut scene = Scene::default();
        let ratio = |teeth: u32| f64::from(SUN_TEETH) / f64::from(teeth);
        // Motion of the carrier in the observer's frame.
        let carrier = [0.0, -options.seen_from];
        let central = |speed: f64| Planet { carrier, own: [0.0, speed], ..Planet::default() };
        let mut free = vec![Component::ThetaZ];
        if options.floating {
            free.extend([Component::Ux, Component::Uy]);
        }
        let moment = Wrench::of_moment([0.0, 0.0, options.moment]);
        let sun = Body::new("sun", SUN.clone(), central(options.speed)).free_in(&free).loaded(moment);
        let sun = add_body(&mut scene, sun)?;
        let blank = options.ring.as_ref().map_or_else(|| RING.clone(), splined);
        let mut ring = Body::new("ring", blank, central(-options.speed * ratio(RING_TEETH)));
        if options.ring.is_some_and(|spline| spline.clearance > 0.0) {
            ring = ring.free_in(&[Component::Ux, Component::Uy, Component::ThetaZ]);
        }
        let ring = add_body(&mut scene, ring)?;
        let constrained = add_body(&mut scene, Body::new("carrier", Arc::new(RigidBody), central(0.0)))?;
        let mut set = Set {
            scene,
            sun,
            planets: Vec::new(),
            ring,
            sun_meshes: Vec::new(),
            ring_meshes: Vec::new(),
            warnings: Vec::new(),
        };
        for (index, &angle) in options.spacing.iter().enumerate() {
            let (sine, cosine) = angle.sin_cos();
            let [out, around] = options.pin_errors[index];
            let radius = DISTANCE + out;
            let pin = [radius * cosine - around * sine, radius * sine + around * cosine];
            let own = [angle, -options.speed * ratio(PLANET_TEETH)];
            let motion = Planet { pin, carrier, own, off: options.runouts[index] };
            let blank = match options.thicknesses[index] {
                Some(thickness) => external(PLANET_TEETH, thickness, 32e-3),
                None => PLANET.clone(),
            };
            let mut body = Body::new(format!("planet {}", index + 1), blank, motion);
            body = match options.bearings {
                Some(_) => body.free_in(&[Component::Ux, Component::Uy, Component::ThetaZ]),
                None => body.free_in(&[Component::ThetaZ]),
            };
            let planet = add_body(&mut set.scene, body)?;
            if let Some(stiffness) = options.bearings {
                let matrix = axisymmetric(stiffness, 0.0, 0.0, 0.0);
                let bearing = Bearing::new(format!("bearing {}", index + 1), planet, 0.0, matrix);
                set.scene.add_bearing(bearing.between(constrained))?;
            }
            let with_sun = mesh(&mut set.scene, sun, planet, &options.mesh)?;
            let with_ring = mesh(&mut set.scene, planet, ring, &options.mesh)?;
            set.planets.push(planet);
            set.sun_meshes.push(with_sun.pair);
            set.ring_meshes.push(with_ring.pair);
            set.warnings
                .extend(with_sun.warnings.iter().chain(&with_ring.warnings).map(|warning| warning.code));
        }
        Ok(set)
    }

    pub fn system(&self) -> System<'_> {
        self.system_at(Fidelity::Plane)
    }

    pub fn system_at(&self, fidelity: Fidelity) -> System<'_> {
        built(&self.scene, fidelity, COARSE)
    }

    /// The same with the modes of its bodies up to a natural frequency, Hz.
    pub fn with_modes(&self, highest: f64) -> System<'_> {
        let plan = Plan::new(&self.scene, Fidelity::Plane, COARSE).expect("it can be planned");
        self.system().with_modes(&plan, &resources(), highest).expect("bodies have modes")
    }

    pub fn mesh(&self, pair: PairId) -> &GearMesh {
        self.scene.pairs[pair.0].mesh.as_ref().expect("a mesh")
    }
}
