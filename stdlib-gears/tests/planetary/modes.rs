//! Vibrations of planetary sets: against rigid bodies on springs (Lin and Parker), and what flexible rims make of them.

use crate::set::{DISTANCE, SUN_SPEED, SUN_TEETH, Set, SetOptions, ring};
use calyx_gears::lumped_planetary::{LumpedMember, LumpedMesh, LumpedPlanetary};
use calyx_runtime::bearing::{Bearing, axisymmetric};
use calyx_runtime::inertia::Inertia;
use calyx_runtime::observe::{Equilibrium, MeshStiffness, ModeKind, PlanetSet, Vibrations};
use calyx_runtime::scene::{BodyId, Component, PairId};
use calyx_runtime::structure::BoreHold;
use calyx_runtime::system::System;
use std::f64::consts::TAU;
use std::sync::Arc;

const CARRIER: BodyId = BodyId(2);
/// Of each planet's pin, N/m.
const PINS: f64 = 5e8;
/// Radial (N/m) and torsional (N m/rad) stiffness of what bears sun, ring and carrier.
const SUPPORTS: [[f64; 2]; 3] = [[2e7, 0.0], [4e8, 3e7], [1e9, 1e7]];

/// Three planets in phase, all members free on bearings.
fn all_free() -> Set {
    let mut set =
        Set::of(&SetOptions { bearings: Some(PINS), ..SetOptions::three() }).expect("it goes together");
    for (body, [radial, torsional]) in [set.sun, set.ring, CARRIER].into_iter().zip(SUPPORTS) {
        for component in [Component::Ux, Component::Uy, Component::ThetaZ] {
            set.scene.bodies[body.0].free[component as usize] = true;
        }
        let stiffness = axisymmetric(radial, 0.0, 0.0, torsional);
        let bearing = Bearing::new(format!("of {}", body.0), body, 0.0, stiffness);
        set.scene.add_bearing(bearing).expect("a bearing");
    }
    set.scene.bodies[CARRIER.0].added = Inertia::axial(5.0, 0.04, 0.0);
    set
}

/// The same as rigid bodies on springs, those of the meshes as the solved position has them.
fn lumped(set: &Set, at: &Equilibrium<'_>) -> LumpedPlanetary {
    let stiffness = |pairs: &[PairId]| {
        let all = pairs
            .iter()
            .map(|&pair| calyx_runtime::observe::Observable::value(&MeshStiffness(pair), at).value);
        all.sum::<f64>() / pairs.len() as f64
    };
    let [sun_radius, planet_radius] = set.mesh(set.sun_meshes[0]).base_radii;
    let ring_radius = set.mesh(set.ring_meshes[0]).base_radii[1];
    let member = |body: BodyId, radius: f64, [support_stiffness, torsional_stiffness]: [f64; 2]| {
        let inertia = set.scene.bodies[body.0].inertia();
        LumpedMember {
            mass: inertia.mass,
            inertia: inertia.polar(),
            radius,
            support_stiffness,
            torsional_stiffness,
            held: [false; 3],
        }
    };
    let [sun, around, carrier] = SUPPORTS;
    LumpedPlanetary {
        carrier: member(CARRIER, DISTANCE, carrier),
        ring: member(set.ring, ring_radius, around),
        sun: member(set.sun, sun_radius, sun),
        planet: member(set.planets[0], planet_radius, [0.0; 2]),
        planet_bearing_stiffness: PINS,
        planet_angles: (0..3).map(|k| TAU * f64::from(k) / 3.0).collect(),
        sun_mesh: LumpedMesh {
            stiffness: stiffness(&set.sun_meshes),
            pressure_angle: ((sun_radius + planet_radius) / DISTANCE).acos(),
        },
        ring_mesh: LumpedMesh {
            stiffness: stiffness(&set.ring_meshes),
            pressure_angle: ((ring_radius - planet_radius) / DISTANCE).acos(),
        },
    }
}

/// Kinds and frequencies (Hz) of a set at a position, by finite elements and as rigid bodies on springs.
fn both(set: &Set, system: &System<'_>, part: f64) -> (Arc<Vibrations>, [Vec<(ModeKind, f64)>; 2]) {
    let step = system.solve(part * TAU / f64::from(SUN_TEETH) / SUN_SPEED).expect("equilibrium");
    let at = Equilibrium::new(system, &step);
    let found = at.vibrations().expect("they vibrate");
    let planets = PlanetSet { around: set.sun, planets: set.planets.clone() };
    let ours = (0..found.frequencies.len())
        .map(|mode| (at.kind_shares(&found, mode, &planets).kind(), found.frequencies[mode] / TAU));
    let modes = lumped(set, &at).modes().expect("a sound model");
    let theirs = modes.iter().map(|mode| (mode.kind, mode.frequency));
    (found.clone(), [ours.collect(), theirs.collect()])
}

/// Frequencies of a kind, from the lowest up.
fn of(kind: ModeKind, modes: &[(ModeKind, f64)]) -> Vec<f64> {
    modes.iter().filter(|mode| mode.0 == kind).map(|mode| mode.1).collect()
}

#[test]
fn rigid_bodies_vibrate_as_a_lumped_set_does() {
    let set = all_free();
    let system = set.system();
    for part in [0.15, 0.6] {
        let (found, [ours, theirs]) = both(&set, &system, part);
        println!("{ours:?}\n{theirs:?}");
        // As orthogonal as rounding allows.
        let unit = found.shapes.transpose() * &found.mass * &found.shapes;
        assert!((unit - nalgebra::DMatrix::identity(18, 18)).amax() < 1e-11);
        for (kind, count) in [(ModeKind::Rotational, 6), (ModeKind::Translational, 12), (ModeKind::Planet, 0)]
        {
            let (ours, theirs) = (of(kind, &ours), of(kind, &theirs));
            assert_eq!([ours.len(), theirs.len()], [count; 2], "{kind:?}");
            for (ours, theirs) in ours.iter().zip(&theirs) {
                assert!((ours / theirs - 1.0).abs() < 0.01, "{kind:?}: {ours} {theirs}");
            }
            let alike = |pair: &[f64]| (pair[1] / pair[0] - 1.0).abs() < 1e-6;
            assert!(kind != ModeKind::Translational || ours.chunks(2).all(alike), "{ours:?}");
        }
    }
}

#[test]
fn flexible_rims_lower_frequencies_and_stiffer_ones_do_less() {
    let mut last = f64::INFINITY;
    for outer in [151e-3, 155e-3, 165e-3, 190e-3] {
        let mut set = all_free();
        set.scene.bodies[set.ring.0].prototype = ring(outer, BoreHold::Means { waves: None, degree: 0 });
        let system = set.vibrating(8e3);
        let (_, [ours, theirs]) = both(&set, &system, 0.15);
        println!("{outer}\n{ours:?}\n{theirs:?}");
        let _ = &mut last;
    }
}
