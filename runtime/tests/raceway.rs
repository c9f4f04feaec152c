//! Rollers between a rigid pin and the bore of an elastic ring, against the mesh of the whole ring:
//! the displacement of the raceway by the loads of all rollers and of a tooth, the law of each
//! roller, and equilibrium.

use calyx_runtime::bearing::{Bearing, NonlinearLoad, RollingElements};
use calyx_runtime::error::EngineError;
use calyx_runtime::fe::{Constraints, PlaneModel, Solver};
use calyx_runtime::interrupt::Interrupt;
use calyx_runtime::load::Wrench;
use calyx_runtime::material::Plane;
use calyx_runtime::motion::SteadyRotation;
use calyx_runtime::plan::Plan;
use calyx_runtime::rolling::{
    Material, Motion, Profile as RollerProfile, RollerGeometry, RollerKind, RollerRow, RollingBearing,
};
use calyx_runtime::scene::{Body, Component, Fidelity, Prototype, Scene, StructureOptions, SurfacePair};
use calyx_runtime::step::StepResult;
use calyx_runtime::structure::tests::bodies::{
    Arc2, BORE, Divisions, STEEL, ring_source, toothed_ring, toothed_sector,
};
use calyx_runtime::structure::tests::bore::bore_means;
use calyx_runtime::structure::{
    BoreSupport, ElasticStructure, RigidStructure, RingSource, SplitOptions, Structure,
};
use calyx_runtime::system::System;
use faer::{Mat, MatRef};
use nalgebra::{Matrix3, Vector3};
use std::f64::consts::{PI, TAU};
use std::sync::Arc;

const FINE: Divisions = Divisions { rim: 6, tooth_root: 3, flank: 12, thickness: 14, grading: 1.0 };
const TEETH: u32 = 7;
const WIDTH: f64 = 0.2;
const ROLLERS: usize = 16;
const DIAMETER: f64 = 0.12;
const CLEARANCE: f64 = 1e-4;
/// Force that presses the ring against a fixed cylinder of this radius, N and m.
const FORCE: f64 = 1e6;
const CYLINDER: f64 = 0.3;

struct Ring;

impl Prototype for Ring {
    fn build(&self, _: &StructureOptions, stop: &Interrupt) -> Result<Arc<dyn Structure>, EngineError> {
        let (model, surfaces) = toothed_sector(TEETH, 1.0, FINE);
        let support = BoreSupport::Raceway { harmonics: 28, degree: 0 };
        let source = RingSource { support, ..ring_source(TEETH) };
        let ring = ElasticStructure::ring(&model, &source, &surfaces, &SplitOptions::default(), stop);
        Ok(Arc::new(ring.expect("a sound ring")))
    }

    fn enclosing_radius(&self) -> f64 {
        1.5
    }

    fn face_width(&self) -> f64 {
        WIDTH
    }
}

struct Cylinder;

impl Prototype for Cylinder {
    fn build(&self, _: &StructureOptions, _: &Interrupt) -> Result<Arc<dyn Structure>, EngineError> {
        let circle = Arc2 { radius: CYLINDER, from: 0.0, angle: TAU };
        Ok(Arc::new(RigidStructure::new(vec![Arc::new(circle)], 1)))
    }

    fn enclosing_radius(&self) -> f64 {
        CYLINDER
    }

    fn face_width(&self) -> f64 {
        WIDTH
    }
}

fn rollers(count: usize) -> RollingBearing {
    let row = RollerRow::new(RollerGeometry {
        kind: RollerKind::Cylindrical { clearance: CLEARANCE },
        count,
        roller_diameter: DIAMETER,
        length: WIDTH,
        pitch_diameter: 2.0 * BORE - DIAMETER,
        profile: RollerProfile::Logarithmic,
        laminae: 21,
        rings: Material::STEEL,
        rollers: Material::STEEL,
        raceway_widths: [None; 2],
    });
    RollingBearing::single(row.expect("sound rollers"))
}

/// Middle of the loaded flank, and the normal out of the ring.
fn flank() -> ([f64; 2], [f64; 2], f64) {
    let (_, surfaces) = toothed_sector(TEETH, 1.0, FINE);
    let middle = 0.5 * surfaces[0].profile.length();
    let at = surfaces[0].profile.at(middle);
    (at.position, at.normal, middle)
}

fn solved(azimuth: f64) -> (Scene, StepResult) {
    let (position, normal, _) = flank();
    let mut scene = Scene::default();
    let ring = Body::new("ring", Arc::new(Ring), SteadyRotation::at_rest([0.0; 2]))
        .free_in(&[Component::Ux, Component::Uy])
        .loaded(Wrench::of_force([FORCE * normal[0], FORCE * normal[1], 0.0]));
    let ring = scene.add_body(ring);
    let center = [0, 1].map(|k| position[k] + CYLINDER * normal[k]);
    let cylinder = Body::new("cylinder", Arc::new(Cylinder), SteadyRotation::at_rest(center));
    let cylinder = scene.add_body(cylinder);
    scene.add_pair(SurfacePair::new([ring, cylinder], [0, 0]));
    let motion = Motion { azimuth, ..Motion::REST };
    let elements = RollingElements::new(rollers(ROLLERS), motion).expect("sound rollers").inverted();
    let bearing = Bearing::new("rollers", ring, 0.0, [[0.0; 6]; 6]);
    let nonlinear = Some(NonlinearLoad::Rolling(Arc::new(elements)));
    scene.add_bearing(Bearing { nonlinear, ..bearing }).expect("a bearing");
    let plan = Plan::new(&scene, Fidelity::Plane, StructureOptions::default()).expect("a plan");
    let step = System::new(&scene, &plan).expect("a system").solve(0.0).expect("equilibrium");
    (scene, step)
}

/// Displacement of a half-space on the line of a roller, mean along it, at a distance around the
/// raceway per unit force, without 1 / (pi E').
fn half_space(x: f64) -> f64 {
    let ratio = x / WIDTH;
    2.0 / WIDTH * ((1.0 / ratio).asinh() - ratio.hypot(1.0) + ratio)
}

/// Weight of a force that is distributed over an angle.
fn bump(half: f64, apart: f64) -> f64 {
    if apart.abs() < half { (1.0 + (PI * apart / half).cos()) / (2.0 * half) } else { 0.0 }
}

/// Mean of the half-space displacement over a distributed force, weighted alike.
fn half_space_bump(half: f64) -> f64 {
    const STEPS: usize = 400;
    let step = 2.0 * half / STEPS as f64;
    let at = |k: usize| -half + (k as f64 + 0.5) * step;
    let mut sum = 0.0;
    // The distance of two cells of the same place is a third of their width in the mean of its
    // logarithm: ln(step) - 3/2.
    for one in 0..STEPS {
        for other in 0..STEPS {
            let apart = if one == other { step * (-1.5f64).exp() } else { (at(one) - at(other)).abs() };
            sum += bump(half, at(one)) * bump(half, at(other)) * half_space(BORE * apart) * step * step;
        }
    }
    sum
}

/// Displacements of the whole mesh under forces per width, without mean motion of the bore.
fn displacements(model: &PlaneModel, load: &[f64]) -> Vec<f64> {
    let (forms, motions) = (bore_means(model), model.rigid_body_modes());
    let dot = |one: &[f64], other: &[f64]| one.iter().zip(other).map(|(a, b)| a * b).sum::<f64>();
    let seen = Matrix3::from_fn(|form, motion| dot(&forms[form], &motions[motion]));
    // Tractions of the frame balance the load.
    let work = Vector3::from_fn(|motion, _| dot(load, &motions[motion]));
    let carried = seen.transpose().try_inverse().expect("independent means") * work;
    let balanced: Vec<f64> = (0..load.len())
        .map(|dof| load[dof] - (0..3).map(|form| carried[form] * forms[form][dof]).sum::<f64>())
        .collect();
    let bore = model.mesh.chain_nodes(model.mesh.chain("bore").expect("a bore"));
    let mut constrained = Constraints::new();
    constrained.fix_node(bore[0]);
    let far = bore[bore.len() / 2];
    let tangential = usize::from(model.mesh.nodes[far][0].abs() > model.mesh.nodes[far][1].abs());
    constrained.prescribe(2 * far + tangential, 0.0);
    let solver = Solver::new(&model.stiffness(), constrained).expect("supported");
    let load = MatRef::from_column_major_slice(&balanced, balanced.len(), 1);
    let moved: Mat<f64> = solver.solve(load).expect("solved");
    let mut moved = moved.col_as_slice(0).to_vec();
    let mean = Vector3::from_fn(|form, _| dot(&forms[form], &moved));
    let rigid = seen.try_inverse().expect("independent means") * mean;
    for (dof, moved) in moved.iter_mut().enumerate() {
        *moved -= (0..3).map(|motion| rigid[motion] * motions[motion][dof]).sum::<f64>();
    }
    moved
}

#[test]
fn rollers_displace_the_raceway_as_on_the_whole_mesh() {
    let model = PlaneModel::new(toothed_ring(TEETH, FINE), STEEL, Plane::Strain);
    let (_, normal, middle) = flank();
    for azimuth in [0.0, 0.1] {
        let (_, step) = solved(azimuth);
        assert!(step.certificate.largest() < 1e-10, "{:?}", step.certificate);
        let [raceway] = &step.raceways[..] else { panic!("one raceway") };
        let angle = |roller: usize| azimuth + TAU * roller as f64 / ROLLERS as f64;
        let forces: Vec<f64> = raceway.loads.chunks(3).map(|load| load[0]).collect();
        let moved: Vec<f64> = raceway.displacement.iter().map(|moved| moved[0]).collect();
        let largest = forces.iter().copied().fold(0.0, f64::max);
        let loaded = forces.iter().filter(|force| **force > 0.0).count();
        assert!((3..ROLLERS).contains(&loaded), "{loaded} rollers carry load");

        // Equilibrium of the ring.
        let tooth: f64 = WIDTH * step.patches.iter().flat_map(|patch| &patch.forces).sum::<f64>();
        assert!(tooth > 0.1 * FORCE, "{tooth}");
        for (axis, direction) in [f64::cos, f64::sin].into_iter().enumerate() {
            let by_rollers: f64 = (0..ROLLERS).map(|roller| forces[roller] * direction(angle(roller))).sum();
            let rest = (FORCE - tooth) * normal[axis] + by_rollers;
            assert!(rest.abs() < 1e-8 * FORCE, "axis {axis}: {rest} N");
        }

        // Law of a roller: its load on rigid rings at the local approach.
        let laminae = rollers(ROLLERS);
        for roller in 0..ROLLERS {
            let (sine, cosine) = angle(roller).sin_cos();
            let approach = -(step.motion[0] * cosine + step.motion[1] * sine) - moved[roller];
            let ring = [approach * cosine, approach * sine, 0.0, 0.0, 0.0];
            let elastic =
                laminae.with_contact(calyx_runtime::rolling::ContactModel::Elastic(Default::default()));
            let states = elastic.expect("strips").elements(&ring, &Motion { azimuth, ..Motion::REST });
            let state = states.expect("finite").swap_remove(roller);
            let load = state.roller().expect("a roller").outer.load;
            assert!((load - forces[roller]).abs() < 1e-8 * largest, "{roller}: {} {load}", forces[roller]);
        }

        // Displacement of the raceway by all loads.
        let bore = model.mesh.chain("bore").expect("a bore");
        let distributed = |half: f64, roller: usize| {
            let load = model.edge_load(bore, |_, point| {
                let [x, y] = point.position;
                let apart = (y.atan2(x) - angle(roller) + PI).rem_euclid(TAU) - PI;
                [x, y].map(|part| part / x.hypot(y) * bump(half, apart) / BORE)
            });
            load.to_full(model.dof_count())
        };
        let chain = model.mesh.chain("flank_0").expect("a flank");
        let point = model.mesh.chain_point(chain, middle).expect("on the flank");
        let pressed = model.displacement_row(point.place, normal.map(|part| -part));
        let expected = [0.04, 0.08].map(|half| {
            let on: Vec<Vec<f64>> = (0..ROLLERS).map(|roller| distributed(half, roller)).collect();
            let mut load = vec![0.0; model.dof_count()];
            pressed.add_to(tooth / WIDTH, &mut load);
            for (on, force) in on.iter().zip(&forces) {
                load.iter_mut().zip(on).for_each(|(sum, part)| *sum += force / WIDTH * part);
            }
            let by_all = displacements(&model, &load);
            let modulus = STEEL.youngs_modulus / (1.0 - STEEL.poissons_ratio.powi(2));
            let own = half_space_bump(half) / (PI * modulus);
            let of = |(on, force): (&Vec<f64>, &f64)| {
                on.iter().zip(&by_all).map(|(a, b)| a * b).sum::<f64>() - own * force
            };
            on.iter().zip(&forces).map(of).collect::<Vec<f64>>()
        });
        let scale = moved.iter().fold(0.0, |most: f64, moved| most.max(moved.abs()));
        for roller in 0..ROLLERS {
            let [narrow, wide] = [expected[0][roller], expected[1][roller]];
            let found = moved[roller];
            let limit = narrow + (narrow - wide) / 3.0;
            println!("{roller}: {:.5} {:.5} {:.0} N", 1e3 * found, 1e3 * limit, forces[roller]);
            assert!((found - limit).abs() < 5e-3 * scale, "roller {roller}: {found} {limit}");
        }
    }
}
