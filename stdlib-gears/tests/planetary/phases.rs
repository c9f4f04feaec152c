//! Assembly and phasing: feasible spacings, and the mesh harmonics that rotate or shift the sun.

use super::set::{PLANET_TEETH, RING_TEETH, SUN_SPEED, SUN_TEETH, Set, SetOptions};
use calyx_gears::error::Refusal;
use std::f64::consts::TAU;

/// Complex numbers.
fn unit(angle: f64) -> [f64; 2] {
    [angle.cos(), angle.sin()]
}

fn times([a, b]: [f64; 2], [c, d]: [f64; 2]) -> [f64; 2] {
    [a * c - b * d, a * d + b * c]
}

fn size([a, b]: [f64; 2]) -> f64 {
    a.hypot(b)
}

fn sum(parts: impl Iterator<Item = [f64; 2]>) -> [f64; 2] {
    parts.fold([0.0; 2], |[a, b], [c, d]| [a + c, b + d])
}

/// A tooth of the sun that has entered the mesh with the first planet rotates by the spacing until
/// it enters the next planet's mesh. The ring rotates in the opposite direction, so its teeth reach
/// the planets in the opposite order.
#[test]
fn planets_enter_one_after_the_other_as_they_are_spaced() {
    let options = SetOptions::four();
    let set = Set::of(&options).expect("it goes together");
    for (teeth, sense, pairs) in [(SUN_TEETH, 1.0, &set.sun_meshes), (RING_TEETH, -1.0, &set.ring_meshes)] {
        let first = set.mesh(pairs[0]);
        for (pair, spacing) in pairs.iter().zip(&options.spacing) {
            let later = (set.mesh(*pair).start - first.start) / first.period;
            let expected = sense * f64::from(teeth) * spacing / TAU;
            let off = later - expected;
            assert!((off - off.round()).abs() < 1e-9, "{teeth} {spacing}: {later} {expected}");
        }
    }
}

/// The mesh forces of planet `n` repeat with the phase `Zs psi_n` and point in the direction of the
/// planet. Harmonic `l` of the moments on the sun is therefore proportional to the sum of
/// `exp(i l Zs psi_n)`. For the forces on it, as complex numbers in the carrier, `exp(+-i l w t)`
/// has the sum of `exp(i (1 -+ l Zs) psi_n)`: a planet at a larger angle is in the phase of an
/// earlier time.
#[test]
fn harmonics_turn_the_sun_or_move_it_as_the_planets_are_phased() {
    const SAMPLES: usize = 16;
    for options in [SetOptions::three(), SetOptions::four()] {
        let set = Set::of(&SetOptions { floating: true, ..options.clone() }).expect("it goes together");
        let system = set.system();
        let period = set.mesh(set.sun_meshes[0]).period;
        let motions: Vec<[f64; 3]> = (0..SAMPLES)
            .map(|sample| {
                let step = system.solve(sample as f64 / SAMPLES as f64 * period).expect("equilibrium");
                // Degrees of freedom of the sun, which is the first body: u_x, u_y, theta_z.
                [step.motion[0], step.motion[1], step.motion[2]]
            })
            .collect();
        let part = |harmonic: f64, of: &dyn Fn(&[f64; 3]) -> [f64; 2]| {
            let term = |(sample, motion): (usize, &[f64; 3])| {
                times(of(motion), unit(-TAU * harmonic * sample as f64 / SAMPLES as f64))
            };
            size(sum(motions.iter().enumerate().map(term))) / SAMPLES as f64
        };
        let scale = part(0.0, &|motion| [motion[2], 0.0]);
        let radius = 0.0388;
        for harmonic in 1..=5 {
            let order = f64::from(harmonic) * f64::from(SUN_TEETH);
            let turning = size(sum(options.spacing.iter().map(|psi| unit(order * psi)))) > 1e-9;
            let found = part(f64::from(harmonic), &|motion| [motion[2], 0.0]) / scale;
            assert_eq!(found > 1e-8, turning, "harmonic {harmonic} turns the sun by {found:e}");
            for sense in [1.0, -1.0] {
                let moving =
                    size(sum(options.spacing.iter().map(|psi| unit((1.0 - sense * order) * psi)))) > 1e-9;
                let found =
                    part(sense * f64::from(harmonic), &|motion| [motion[0], motion[1]]) / (scale * radius);
                assert_eq!(found > 1e-8, moving, "harmonic {harmonic} ({sense}) moves the sun by {found:e}");
            }
        }
    }
}

fn refused(spacing: Vec<f64>) -> (&'static str, String) {
    match Set::of(&SetOptions::of(spacing)) {
        Err(Refusal::Geometry(errors)) => (errors[0].code, errors[0].help.to_string()),
        Err(Refusal::Engine(error)) => (error.code, error.help),
        Ok(set) => (set.warnings.first().copied().unwrap_or("none"), String::new()),
    }
}

#[test]
fn planets_go_together_where_teeth_meet_spaces() {
    let places = f64::from(SUN_TEETH + RING_TEETH);
    // Every feasible position, as long as planets do not overlap.
    for place in [40.0, 41.0, 63.0, 85.0] {
        assert_eq!(refused(vec![0.0, TAU * place / places]).0, "none", "{place}");
    }
    let (code, help) = refused((0..4).map(|k| TAU * f64::from(k) / 4.0).collect());
    assert_eq!(code, "E0750");
    assert!(
        help.contains("/ 126 apart") && help.contains("91.429 deg") | help.contains("88.571 deg"),
        "{help}"
    );
    // The teeth would permit seven planets if they had room.
    assert_eq!(refused((0..7).map(|k| TAU * f64::from(k) / 7.0).collect()).0, "E0751");
    // A spacing error of a twentieth of a degree is reported, a spacing with five correct digits is
    // not.
    assert_eq!(refused(vec![0.0, 88.63_f64.to_radians()]).0, "E0752");
    assert_eq!(refused(vec![0.0, 88.5714_f64.to_radians()]).0, "none");
}

/// The order of meshes is the model's choice: a planet that meshes with the ring first is phased by
/// it.
#[test]
fn a_planet_is_phased_by_whatever_it_meshes_with_first() {
    let set = Set::of(&SetOptions::four()).expect("it goes together");
    let mut scene = set.scene.clone();
    scene.pairs.clear();
    for body in &mut scene.bodies {
        body.phase = 0.0;
    }
    let options = SetOptions::four().mesh;
    let mut pairs = Vec::new();
    for (index, &planet) in set.planets.iter().enumerate() {
        let mut mesh = |first, second| {
            let meshed =
                calyx_gears::assembly::mesh(&mut scene, first, second, &options).expect("it goes together");
            assert!(meshed.warnings.is_empty());
            meshed.pair
        };
        // The first planet in the usual order, which determines the drive flanks. The others with
        // the ring before the sun.
        let [with_sun, with_ring] = if index == 0 {
            let with_sun = mesh(set.sun, planet);
            [with_sun, mesh(planet, set.ring)]
        } else {
            let with_ring = mesh(planet, set.ring);
            [mesh(set.sun, planet), with_ring]
        };
        pairs.push([with_sun, with_ring]);
    }
    let pitch = TAU / f64::from(PLANET_TEETH);
    for (planet, [with_sun, with_ring]) in set.planets.iter().zip(&pairs) {
        let off = (scene.bodies[planet.0].phase - set.scene.bodies[planet.0].phase) / pitch;
        assert!((off - off.round()).abs() < 1e-9, "{off}");
        for pair in [with_sun, with_ring] {
            let mesh = scene.pairs[pair.0].mesh.as_ref().expect("a mesh");
            assert!(mesh.phase_offset.abs() < 1e-12);
            // Relative to the carrier the sun rotates in the direction of its drive.
            assert!((mesh.period * SUN_SPEED * f64::from(SUN_TEETH) / TAU - 1.0).abs() < 1e-9);
        }
    }
}
