//! Tests of the equilibrium of two involute helicoids on half-spaces: torques, axial forces,
//! friction.

#[allow(dead_code)]
#[path = "../contact/src/solid/test_surfaces.rs"]
mod test_surfaces;

use calyx_runtime::error::EngineError;
use calyx_runtime::interrupt::Interrupt;
use calyx_runtime::load::Wrench;
use calyx_runtime::motion::SteadyRotation;
use calyx_runtime::observables::Observe;
use calyx_runtime::plan::Plan;
use calyx_runtime::scene::{
    Body, Component, Fidelity, Prototype, Scene, StructureOptions, SurfacePair, Template,
};
use calyx_runtime::structure::Structure;
use calyx_runtime::structure::solid::{HalfSpaceBody, Mirror, SolidStructure};
use calyx_runtime::surface::Surface;
use calyx_runtime::system::System;
use std::sync::Arc;
use test_surfaces::{HELICAL, Helicoid, Pair};

impl Pair {
    /// Scene with both as half-space bodies between side faces, the first driven by a torque and
    /// the second fixed.
    fn scene(&self, torque: f64, friction: f64) -> Scene {
        let (flanks, turns) = self.turned();
        let speeds = [10.0, -10.0 * self.base_radii[0] / self.base_radii[1]];
        let mut scene = Scene::default();
        let ids = [0, 1].map(|side: usize| {
            let origin = [[0.0, self.center()][side], 0.0];
            let motion = SteadyRotation { origin, start: turns[side], speed: speeds[side] };
            let mut body = Body::new(["first", "second"][side], Arc::new(Tooth(flanks[side])), motion);
            if side == 0 {
                body = body.free_in(&[Component::ThetaZ]).loaded(Wrench::of_moment([0.0, 0.0, torque]));
            }
            scene.add_body(body)
        });
        let mut pair = SurfacePair::new(ids, [0, 0]);
        (pair.grid.half_cells, pair.grid.half_slices, pair.friction) = (Some(6), 4, friction);
        scene.add_pair(pair);
        scene
    }

    /// Contact forces and moments on both bodies at time 0.
    fn reactions(&self, torque: f64, friction: f64) -> [[f64; 6]; 2] {
        let scene = self.scene(torque, friction);
        let fidelity = Fidelity::Solid(Template::Medium);
        let plan = Plan::new(&scene, fidelity, StructureOptions::default()).expect("it can be planned");
        let system = System::new(&scene, &plan).expect("it can be built");
        let step = system.solve(0.0).expect("equilibrium");
        assert!(step.certificate.largest() < 1e-12, "{:?}", step.certificate);
        [0, 1].map(|side| system.contact_force(&step, scene.pairs[0].bodies[side]))
    }
}

/// Flank on half-spaces between side faces.
struct Tooth(Helicoid);

impl Prototype for Tooth {
    fn build(&self, _: &StructureOptions, _: &Interrupt) -> Result<Arc<dyn Structure>, EngineError> {
        Err(EngineError::new("E0678", "it has no section", ""))
    }

    fn build_solid(
        &self,
        _: &StructureOptions,
        _: &Interrupt,
    ) -> Result<Arc<dyn SolidStructure>, EngineError> {
        let faces = self.0.v.map(|z| Mirror { point: [0.0, 0.0, z], normal: [0.0, 0.0, 1.0] });
        let surface: Arc<dyn Surface> = Arc::new(self.0);
        Ok(Arc::new(HalfSpaceBody::half_space(vec![surface], 1, 2.2e11).between(faces.to_vec())))
    }

    fn enclosing_radius(&self) -> f64 {
        2.0 * self.0.base_radius
    }

    fn face_width(&self) -> f64 {
        self.0.v[1] - self.0.v[0]
    }
}

#[test]
fn friction_moves_the_torques_of_a_spur_pair() {
    let (torque, friction) = (50.0, 0.07);
    for phase in [-0.004, -1e-4, 1e-4, 0.003] {
        let pair = Pair { base_helix: 0.0, phase, ..HELICAL };
        let [first, second] = pair.reactions(torque, friction).map(|reaction| reaction[5]);
        assert!((first / -torque - 1.0).abs() < 1e-12);
        let path = pair.base_radii.map(|rb| rb * pair.pressure_angle.tan());
        let (rho1, rho2) = (path[0] + phase, path[1] - phase);
        // Before the pitch point the profiles slide towards it, after it away from it.
        let s = phase.signum();
        let expected =
            (pair.base_radii[1] + s * friction * rho2) / (pair.base_radii[0] + s * friction * rho1);
        assert!((second / first / expected - 1.0).abs() < 1e-9, "{phase}: {} {expected}", second / first);
        // Friction dissipates power in both directions.
        assert!(second / first < pair.base_radii[1] / pair.base_radii[0]);
    }
}

#[test]
fn helical_pairs_push_along_their_axes() {
    for helix in [0.3, -0.2, 0.05] {
        let pair = Pair { base_helix: helix, ..HELICAL };
        let [first, second] = pair.reactions(50.0, 0.0);
        assert!((second[5] / first[5] / 2.0 - 1.0).abs() < 1e-9);
        // The axial force is tan(helix angle) times the tangential force at the same radius.
        let axial = first[5] * helix.tan() / pair.base_radii[0];
        assert!((first[2].abs() / axial.abs() - 1.0).abs() < 1e-9, "{first:?}");
        // The sign of the axial force depends on the hand of the helix for the same sense of
        // rotation.
        assert_eq!(first[2] > 0.0, helix > 0.0, "{first:?}");
        for axis in 0..3 {
            assert!((first[axis] + second[axis]).abs() < 1e-10 * first[1].abs());
        }
    }
}
