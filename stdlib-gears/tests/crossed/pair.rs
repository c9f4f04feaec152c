//! Crossed helical gears for these tests: half-spaces behind the exact flanks, and their contact in
//! closed form.

use calyx_gears::assembly::{MeshOptions, add_body};
use calyx_gears::blank::{GearBlank, Rim};
use calyx_gears::general_mesh::general_mesh;
use calyx_gears::helix::{Hand, Helix};
use calyx_gears::prototype::GearPrototype;
use calyx_gears::rack::Rack;
use calyx_runtime::error::EngineError;
use calyx_runtime::interrupt::Interrupt;
use calyx_runtime::load::Wrench;
use calyx_runtime::material::{Material, Plane};
use calyx_runtime::motion::{RelocatedMotion, SteadyRotation};
use calyx_runtime::scene::{Body, Component, GearMesh, Prototype, Scene, StructureOptions, ToothFlanks};
use calyx_runtime::structure::Structure;
use calyx_runtime::structure::solid::{HalfSpaceBody, SolidStructure};
use calyx_runtime::surface::Surface;
use calyx_runtime::vec3::{cross, dot, length, minus, plus, scaled, unit};
use std::f64::consts::TAU;
use std::sync::Arc;

pub const TEETH: [u32; 2] = [18, 29];
/// Normal module, m, and normal pressure angle.
pub const MODULE: f64 = 2e-3;
pub const PRESSURE_ANGLE: f64 = 0.349_065_850_398_866;

/// Gear whose flanks are half-spaces.
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
        Ok(Arc::new(HalfSpaceBody::half_space(surfaces.to_vec(), self.0.gear.teeth(), modulus())))
    }

    fn tooth_flanks(&self) -> Option<ToothFlanks> {
        self.0.tooth_flanks()
    }

    fn enclosing_radius(&self) -> f64 {
        self.0.enclosing_radius()
    }

    fn face_width(&self) -> f64 {
        self.0.face_width
    }
}

/// Modulus E/(1 - nu^2) of one gear, Pa.
pub fn modulus() -> f64 {
    Material::STEEL.surface_modulus(Plane::Strain)
}

/// Options of a pair of right-handed gears.
#[derive(Clone, Copy)]
pub struct Options {
    /// Helix angles, rad, right-handed if positive.
    pub helix: [f64; 2],
    /// Relative increase of the centre distance over that of zero profile shift.
    pub apart: f64,
    /// Increase of the shaft angle over the sum of the helix angles, rad.
    pub inclined: f64,
    /// Torque about the first gear's axis, N m.
    pub torque: f64,
    pub half_cells: [usize; 2],
    pub face_width: f64,
}

impl Default for Options {
    fn default() -> Options {
        Options {
            helix: [0.9, TAU / 4.0 - 0.9],
            apart: 1e-3,
            inclined: 0.0,
            torque: 20.0,
            half_cells: [10, 8],
            face_width: 24e-3,
        }
    }
}

impl Options {
    pub fn gear(&self, member: usize) -> Arc<GearPrototype> {
        let angle: f64 = self.helix[member];
        let hand = if angle < 0.0 { Hand::Left } else { Hand::Right };
        let transverse = (PRESSURE_ANGLE.tan() / angle.cos()).atan();
        let rack = Rack::new(MODULE / angle.cos(), transverse, 0.2 * MODULE).expect("a rack");
        let radius = self.pitch_radius(member);
        let blank = GearBlank {
            helix: Helix::new(angle.abs(), hand).expect("a helix"),
            tip_diameter: 2.0 * (radius + MODULE),
            root_diameter: 2.0 * (radius - 1.25 * MODULE),
            ..GearBlank::standard(TEETH[member], rack)
        };
        let root = 0.5 * blank.root_diameter;
        let rim = Rim::new(2.0 * (root - 0.5 * MODULE), 2.0 * (root - 2.0 * MODULE)).expect("a rim");
        blank.face_width(self.face_width).rim(rim).cut().expect("a gear")
    }

    pub fn pitch_radius(&self, member: usize) -> f64 {
        0.5 * MODULE * f64::from(TEETH[member]) / self.helix[member].cos()
    }

    pub fn distance(&self) -> f64 {
        (self.pitch_radius(0) + self.pitch_radius(1)) * (1.0 + self.apart)
    }

    /// Direction of the second axis: rotated about the line of centres, e1.
    pub fn second_axis(&self) -> [f64; 3] {
        let (sine, cosine) = (-(self.helix[0] + self.helix[1] + self.inclined)).sin_cos();
        [0.0, -sine, cosine]
    }

    pub fn scene(&self) -> (Scene, GearMesh) {
        let gears = [0, 1].map(|member| self.gear(member));
        let speeds = [TAU, -TAU * f64::from(TEETH[0]) / f64::from(TEETH[1])];
        let mut scene = Scene::default();
        let steady = |member: usize| {
            let origin = [[0.0, self.distance()][member], 0.0];
            Arc::new(SteadyRotation { origin, start: 0.0, speed: speeds[member] })
        };
        let [_, y, z] = self.second_axis();
        let tilt = [[1.0, 0.0, 0.0], [0.0, z, y], [0.0, -y, z]];
        let second = RelocatedMotion::rotated_about(steady(1), tilt, [self.distance(), 0.0, 0.0]);
        let drive = if self.torque == 0.0 { 1.0 } else { self.torque };
        let first = add_body(
            &mut scene,
            Body::new("first", Arc::new(Backed(gears[0].clone())), *steady(0))
                .free_in(&[Component::ThetaZ])
                .loaded(Wrench::of_moment([0.0, 0.0, drive])),
        )
        .expect("a body");
        let second = add_body(&mut scene, Body::new("second", Arc::new(Backed(gears[1].clone())), second))
            .expect("a body");
        let options = MeshOptions {
            half_cells: Some(self.half_cells[0]),
            half_slices: self.half_cells[1],
            ..MeshOptions::default()
        };
        let meshed = general_mesh(&mut scene, [first, second], &options).expect("they mesh");
        assert!(meshed.warnings.is_empty(), "{:?}", meshed.warnings);
        scene.bodies[0].load = Arc::new(Wrench::of_moment([0.0, 0.0, self.torque]));
        let mesh = scene.pairs[meshed.pair.0].mesh.clone().expect("gears are in mesh");
        (scene, mesh)
    }

    /// Moment arm of the common normal of a member: that of its base cylinder, at its base helix
    /// angle.
    pub fn normal_arm(&self, member: usize) -> f64 {
        let gear = self.gear(member);
        let base = gear.form().base_radius;
        base * (self.helix[member].sin() * PRESSURE_ANGLE.cos()).asin().cos()
    }
}

/// Involute helicoid at a contact: radius of curvature (m) and direction of its generator.
fn curvature(axis: [f64; 3], origin: [f64; 3], point: [f64; 3], normal: [f64; 3]) -> (f64, [f64; 3]) {
    let away = |vector: [f64; 3]| minus(vector, scaled(axis, dot(vector, axis)));
    let (direction, offset) = (away(normal), away(minus(origin, point)));
    // The normal touches the base cylinder where it is closest to the axis.
    let along = dot(offset, direction) / dot(direction, direction);
    let radial = away(minus(plus(point, scaled(normal, along)), origin));
    (along.abs(), unit(cross(normal, radial)))
}

/// Principal radii of relative curvature at a contact, ascending, m.
pub fn relative_radii(options: &Options, point: [f64; 3], normal: [f64; 3]) -> [f64; 2] {
    let (one, along) = curvature([0.0, 0.0, 1.0], [0.0; 3], point, normal);
    let (other, across) = curvature(options.second_axis(), [options.distance(), 0.0, 0.0], point, normal);
    let angle = length(cross(along, across)).atan2(dot(along, across).abs());
    let [a, b] = [one.recip(), other.recip()];
    let difference = (a * a + b * b + 2.0 * a * b * (2.0 * angle).cos()).sqrt();
    [2.0 / (a + b + difference), 2.0 / (a + b - difference)]
}
