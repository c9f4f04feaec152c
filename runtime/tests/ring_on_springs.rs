//! Tests of a body on springs, modelled by its modes and its frame motion, against its whole mesh
//! on the same springs.

use calyx_fe::PlaneModel;
use calyx_numerics::dense::{cholesky, solve_lower};
use calyx_runtime::bearing::{Bearing, axisymmetric};
use calyx_runtime::disc::{Facing, Platen};
use calyx_runtime::error::EngineError;
use calyx_runtime::inertia::Inertia;
use calyx_runtime::interrupt::Interrupt;
use calyx_runtime::material::Plane;
use calyx_runtime::motion::SteadyRotation;
use calyx_runtime::observables::Observe;
use calyx_runtime::observables::{Equilibrium, ModeShare};
use calyx_runtime::plan::Plan;
use calyx_runtime::resources::Resources;
use calyx_runtime::scene::{
    Body, BodyId, Component, Fidelity, Prototype, Scene, StructureOptions, SurfacePair,
};
use calyx_runtime::structure::tests::bodies::{
    Divisions, Line, STEEL, ring_source, toothed_ring, toothed_sector,
};
use calyx_runtime::structure::tests::bore::bore_means;
use calyx_runtime::structure::{
    BodyModes, BoreSupport, RigidStructure, RingSource, SplitOptions, Structure, StructureError,
};
use calyx_runtime::system::System;
use faer::{Mat, Side};
use nalgebra::{Matrix3, Vector3};
use std::sync::Arc;

const SMALL: Divisions = Divisions { rim: 1, tooth_root: 1, flank: 2, thickness: 2, grading: 1.0 };
const TEETH: u32 = 6;
const WIDTH: f64 = 0.2;
/// Mean constraints: frame and deformation are coupled by inertia only.
const SUPPORT: BoreSupport = BoreSupport::Means { harmonics: None, degree: 0 };
/// Spring constants of the bearing along both axes and about the third, per metre of width,
/// comparable with the stiffness of the ring.
const SPRINGS: [f64; 3] = [2e10, 2e10, 1e10];

/// A ring whose contact surface is rigid.
struct Ring;

fn modes_up_to(highest: f64) -> Result<BodyModes, StructureError> {
    let (model, _) = toothed_sector(TEETH, 1.0, SMALL);
    let source = RingSource { support: SUPPORT, ..ring_source(TEETH) };
    BodyModes::ring(&model, &source, &[], &SplitOptions::default(), highest, &Interrupt::never())
}

impl Prototype for Ring {
    fn build(&self, _: &StructureOptions, _: &Interrupt) -> Result<Arc<dyn Structure>, EngineError> {
        let flank = Line { from: [1.0, 0.1], to: [1.2, 0.1], material_on_left: false };
        Ok(Arc::new(RigidStructure::new(vec![Arc::new(flank)], 1)))
    }

    fn modes(
        &self,
        _: &StructureOptions,
        highest: f64,
        _: &Interrupt,
    ) -> Result<Option<Arc<BodyModes>>, EngineError> {
        Ok(Some(Arc::new(modes_up_to(highest)?)))
    }

    fn inertia(&self) -> Inertia {
        let mass = modes_up_to(0.0).expect("a ring weighs").rigid_mass;
        Inertia::axial(WIDTH * mass[0][0], WIDTH * mass[2][2], 0.0)
    }

    fn enclosing_radius(&self) -> f64 {
        1.5
    }

    fn face_width(&self) -> f64 {
        WIDTH
    }
}

/// Returns the natural frequencies of the whole mesh, rad/s, with the mean displacement of its bore
/// on springs.
fn of_whole() -> Vec<f64> {
    let model = PlaneModel::new(toothed_ring(TEETH, SMALL), STEEL, Plane::Strain);
    let (mass, mut stiffness) = (model.mass().to_dense(), model.stiffness().to_dense());
    let forms = bore_means(&model);
    assert_eq!(forms.len(), 3);
    // The value of each form for the motions of a frame gives the frame motion of a bore
    // displacement.
    let motions = |dof: usize| {
        let [x, y] = model.mesh.nodes[dof / 2];
        [[1.0, 0.0, -y], [0.0, 1.0, x]][dof % 2]
    };
    let seen = Matrix3::from_fn(|form, motion| {
        (0..model.dof_count()).map(|dof| forms[form][dof] * motions(dof)[motion]).sum()
    });
    let frame = seen.try_inverse().unwrap();
    let rows: Vec<Vector3<f64>> =
        (0..model.dof_count()).map(|dof| frame * Vector3::from_fn(|form, _| forms[form][dof])).collect();
    for (i, one) in rows.iter().enumerate() {
        for (j, other) in rows.iter().enumerate() {
            stiffness[(i, j)] += (0..3).map(|k| SPRINGS[k] * one[k] * other[k]).sum::<f64>();
        }
    }
    let factor = cholesky(mass).unwrap();
    let half = solve_lower(factor.as_ref(), stiffness);
    let whole: Mat<f64> = solve_lower(factor.as_ref(), half.transpose().to_owned());
    whole.self_adjoint_eigenvalues(Side::Lower).unwrap().into_iter().map(f64::sqrt).collect()
}

/// Returns a scene with the ring on its bearing, rotated slightly, and a body far from it.
fn scene() -> Scene {
    let mut scene = Scene::default();
    let motion = SteadyRotation { origin: [0.3, -0.1], start: 0.4, speed: 1.0 };
    let ring =
        Body::new("ring", Arc::new(Ring), motion).free_in(&[Component::Ux, Component::Uy, Component::ThetaZ]);
    let ring = scene.add_body(ring);
    let [radial, _, torsional] = SPRINGS.map(|spring| WIDTH * spring);
    let bearing = Bearing::new("springs", ring, 0.0, axisymmetric(radial, 0.0, 0.0, torsional));
    scene.add_bearing(bearing).unwrap();
    let far = Platen::new(0.1, WIDTH, Facing::Up);
    let far = scene.add_body(Body::new("far", Arc::new(far), SteadyRotation::at_rest([100.0, 0.0])));
    scene.add_pair(SurfacePair::new([ring, far], [0, Platen::SURFACE]));
    scene
}

#[test]
fn a_ring_on_springs_vibrates_as_its_whole_mesh_does() {
    let (whole, scene) = (of_whole(), scene());
    let plan = Plan::new(&scene, Fidelity::Plane, StructureOptions::default()).unwrap();
    let mut last = f64::INFINITY;
    for number in [12, 30, 80] {
        let highest = whole[number] / std::f64::consts::TAU;
        let system = System::new(&scene, &plan).unwrap();
        let system = system.with_modes(&plan, &Resources::default(), highest).unwrap();
        let step = system.solve(0.7).unwrap();
        let at = Equilibrium::new(&system, &step);
        let found = at.vibrations().unwrap();
        // Ritz approximation: upper bounds that converge with more modes.
        let mut worst = 0.0_f64;
        for (found, exact) in found.frequencies.iter().zip(&whole).take(8) {
            assert!(*found > exact * (1.0 - 1e-7), "{found} {exact}");
            worst = worst.max(found / exact - 1.0);
        }
        assert!(worst < last, "{worst:e} after {last:e}");
        last = worst;
        // Frame and ring have comparable shares of the energy.
        for mode in 0..8 {
            let share = |components, elastic| {
                system.value(&step, &ModeShare { mode, body: BodyId(0), components, elastic }).value
            };
            let [frame, elastic] = [share([true; 6], false), share([false; 6], true)];
            assert!((frame + elastic - 1.0).abs() < 1e-9, "{mode}: {frame} {elastic}");
            assert!((share([true; 6], true) - 1.0).abs() < 1e-9);
        }
    }
    assert!(last < 1e-3, "{last:e}");
}
