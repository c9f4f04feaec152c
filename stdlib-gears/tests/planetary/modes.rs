//! Modes of planetary sets, compared with the lumped-parameter model (Lin and Parker), and the
//! effect of flexible rims.

use super::set::{DISTANCE, PLANET_TEETH, SUN_SPEED, SUN_TEETH, Set, SetOptions, external, ring};
use calyx_gears::lumped_planetary::LumpedPlanetary;
use calyx_gears::lumped_scene::LumpedSet;
use calyx_runtime::bearing::{Bearing, axisymmetric};
use calyx_runtime::inertia::Inertia;
use calyx_runtime::observables::{Equilibrium, ModeKind, PlanetSet, Vibrations};
use calyx_runtime::scene::{BodyId, Component};
use calyx_runtime::structure::BoreSupport;
use calyx_runtime::system::System;
use std::f64::consts::TAU;
use std::sync::Arc;

/// Rim whose bearing supports it by a mean constraint.
const FLOATING: BoreSupport = BoreSupport::Means { harmonics: None, degree: 0 };
const CARRIER: BodyId = BodyId(2);
/// Stiffness of each planet's pin, N/m.
const PINS: f64 = 5e8;
/// Radial (N/m) and torsional (N m/rad) stiffness of the supports of sun, ring and carrier.
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

/// The lumped-parameter model of the set, with the mesh stiffnesses of the solved position.
fn lumped(set: &Set, at: &Equilibrium<'_>) -> LumpedPlanetary {
    let lumped = LumpedSet {
        sun: set.sun,
        ring: set.ring,
        carrier: CARRIER,
        planets: set.planets.clone(),
        sun_meshes: set.sun_meshes.clone(),
        ring_meshes: set.ring_meshes.clone(),
    };
    let found = lumped.at(at).expect("a planetary set");
    assert_eq!(
        [found.sun.support_stiffness, found.ring.torsional_stiffness],
        [SUPPORTS[0][0], SUPPORTS[1][1]]
    );
    assert!((found.carrier.radius / DISTANCE - 1.0).abs() < 0.01 && found.planet_bearing_stiffness == PINS);
    found
}

/// At a fraction of a pitch: the modes of a set, the types and frequencies (Hz) of its modes, and
/// those of the lumped-parameter model.
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

/// Natural frequencies of a mode type, ascending.
fn of(kind: ModeKind, modes: &[(ModeKind, f64)]) -> Vec<f64> {
    modes.iter().filter(|mode| mode.0 == kind).map(|mode| mode.1).collect()
}

/// With rigid supports close to the teeth, only the teeth are elastic, and the meshes of a gear are
/// independent: both models agree mode by mode to rounding.
#[test]
fn rigid_rims_vibrate_as_a_lumped_set_does() {
    let mut set = all_free();
    set.scene.bodies[set.sun.0].prototype = external(SUN_TEETH, 4.45e-3, 32e-3);
    for planet in &set.planets {
        set.scene.bodies[planet.0].prototype = external(PLANET_TEETH, 4.45e-3, 43.4e-3);
    }
    set.scene.bodies[set.ring.0].prototype = ring(147e-3, BoreSupport::Rigid);
    let system = set.system();
    for part in [0.15, 0.6] {
        let (found, [ours, theirs]) = both(&set, &system, part);
        let unit = found.shapes.transpose() * &found.mass * &found.shapes;
        assert!((unit - nalgebra::DMatrix::identity(18, 18)).amax() < 1e-11);
        for (kind, count) in [(ModeKind::Rotational, 6), (ModeKind::Translational, 12), (ModeKind::Planet, 0)]
        {
            let (ours, theirs) = (of(kind, &ours), of(kind, &theirs));
            assert_eq!([ours.len(), theirs.len()], [count; 2], "{kind:?}");
            for (ours, theirs) in ours.iter().zip(&theirs) {
                // The coupling of distant teeth, which vanishes here, has a rounding error of 1e-8.
                assert!((ours / theirs - 1.0).abs() < 1e-7, "{kind:?}: {ours} {theirs}");
            }
            let alike = |pair: &[f64]| (pair[1] / pair[0] - 1.0).abs() < 1e-9;
            assert!(kind != ModeKind::Translational || ours.chunks(2).all(alike), "{ours:?}");
        }
    }
}

/// A ring of increasing thickness on a floating bearing, with its own modes, compared with the same
/// masses on the elastic teeth alone.
#[test]
fn flexible_rims_lower_frequencies_and_stiffer_ones_do_less() {
    let mut last = [f64::INFINITY; 2];
    for outer in [155e-3, 165e-3, 190e-3] {
        let mut set = all_free();
        set.scene.bodies[set.ring.0].prototype = ring(outer, BoreSupport::Rigid);
        let lowest =
            |modes: &[(ModeKind, f64)], kind| of(kind, modes).first().copied().expect("there is one");
        let (_, [_, on_teeth]) = both(&set, &set.system(), 0.15);
        set.scene.bodies[set.ring.0].prototype = ring(outer, FLOATING);
        let (_, [flexible, _]) = both(&set, &set.with_modes(6e3), 0.15);
        // The lowest rotational mode, and the lowest of all translational or bending modes.
        let turning = ModeKind::Rotational;
        let first = |modes: &[(ModeKind, f64)]| modes[0].1;
        let gaps = [
            1.0 - lowest(&flexible, turning) / lowest(&on_teeth, turning),
            1.0 - first(&flexible) / first(&on_teeth),
        ];
        for (gap, last) in gaps.into_iter().zip(&mut last) {
            assert!(gap > 0.0 && gap < *last, "{outer}: {gap} after {last}");
            *last = gap;
        }
    }
    assert!(last[0] < 0.1, "{last:?}");
}
