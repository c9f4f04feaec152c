//! The published case of Lin and Parker (1999), and properties implied by the symmetry of the
//! model.

use super::*;
use serde_json::Value;

fn published() -> Value {
    let text = include_str!("../../tests/data/planetary_modes.json");
    serde_json::from_str(text).expect("published frequencies")
}

/// The published gear set. `ring_torsion` is the torsional stiffness of the ring as a spring along
/// its base circle, N/m.
fn gear_set(planets: usize, ring_torsion: f64) -> LumpedPlanetary {
    let published = published();
    let number = |value: &Value| value.as_f64().expect("a number");
    let parameters = &published["parameters"];
    let support = number(&parameters["bearing_k"]);
    let member = |name: &str, support_stiffness: f64, torsion: f64| {
        let of = &parameters[name];
        let radius = 0.5 * number(&of["base_dia"]);
        LumpedMember {
            mass: number(&of["m"]),
            inertia: number(&of["I_over_r2"]) * radius * radius,
            radius,
            support_stiffness,
            torsional_stiffness: torsion * radius * radius,
            fixed: [false; 3],
        }
    };
    let pressure_angle = number(&parameters["pressure_angle_deg"]).to_radians();
    let mesh = LumpedMesh { stiffness: number(&parameters["mesh_k"]), pressure_angle };
    LumpedPlanetary {
        carrier: member("carrier", support, 0.0),
        ring: member("ring", support, ring_torsion),
        sun: member("sun", support, 0.0),
        planet: member("planet", 0.0, 0.0),
        planet_bearing_stiffness: support,
        planet_angles: equally_spaced(planets),
        sun_mesh: mesh,
        ring_mesh: mesh,
    }
}

fn frequencies(set: &LumpedPlanetary) -> Vec<f64> {
    set.modes().expect("a sound model").iter().map(|mode| mode.frequency).collect()
}

fn agree(set: &LumpedPlanetary, published: &Value) {
    let found = frequencies(set);
    let expected: Vec<f64> = serde_json::from_value(published.clone()).expect("frequencies");
    assert_eq!(found.len(), expected.len());
    let first = expected.iter().copied().find(|&frequency| frequency > 1.0).expect("one that is not zero");
    for (found, expected) in found.iter().zip(&expected) {
        let error = (found - expected).abs() / expected.max(first);
        assert!(error < 1e-6, "{found} for {expected}");
    }
}

#[test]
fn frequencies_are_those_published() {
    let published = published();
    agree(&gear_set(4, 1e9), &published["N4_ring_torsion_1e9_Hz"]);
    let mut fixed = gear_set(4, 0.0);
    fixed.ring.fixed = [true; 3];
    fixed.carrier.fixed[2] = true;
    agree(&fixed, &published["N4_ring_fixed_carrier_rotation_fixed_Hz"]);
}

#[test]
fn equally_spaced_planets_have_modes_of_three_kinds_in_known_numbers() {
    for planets in 3..=9 {
        let modes = gear_set(planets, 1e9).modes().expect("a sound model");
        let of = |kind| {
            modes.iter().filter(|mode| mode.kind == kind).map(|mode| mode.frequency).collect::<Vec<_>>()
        };
        let first = modes[1].frequency;
        assert!(modes[0].frequency < 1e-9 * first, "a free set turns as a whole: {}", modes[0].frequency);
        assert_eq!(of(ModeKind::Mixed), [0.0; 0], "{planets}");
        assert_eq!(of(ModeKind::Rotational).len(), 6, "{planets}");
        let close =
            |pair: &[f64]| (pair[0] - pair[pair.len() - 1]).abs() < 1e-12 * modes[modes.len() - 1].frequency;
        let translational = of(ModeKind::Translational);
        assert_eq!(translational.len(), 12, "{planets}");
        assert!(translational.chunks(2).all(close), "{planets}: {translational:?}");
        let planet = of(ModeKind::Planet);
        assert_eq!(planet.len(), 3 * (planets - 3), "{planets}");
        assert!(planets == 3 || planet.chunks(planets - 3).all(close), "{planets}: {planet:?}");
    }
}

#[test]
fn modes_are_orthogonal_and_share_out_their_energy() {
    let set = gear_set(5, 1e9);
    let (modes, members) = (set.modes().expect("a sound model"), set.members());
    for (first, one) in modes.iter().enumerate() {
        assert!((one.shares.iter().sum::<f64>() - 1.0).abs() < 1e-12);
        for (second, other) in modes.iter().enumerate() {
            let product: f64 = members
                .iter()
                .zip(one.shape.iter().zip(&other.shape))
                .map(|(of, (a, b))| of.mass * (a[0] * b[0] + a[1] * b[1]) + of.inertia * a[2] * b[2])
                .sum();
            let expected = f64::from(u8::from(first == second));
            assert!((product - expected).abs() < 1e-11, "{first}, {second}: {product}");
        }
    }
}

/// An independent derivation of the equations of motion: the energy of a spring follows from the
/// velocities of its two ends along the line of action, with planet motions in ground axes.
/// Rayleigh's quotient of every mode is the square of its frequency.
#[test]
fn strain_energy_in_ground_axes_gives_the_same_frequencies() {
    let mut set = gear_set(4, 0.0);
    set.planet_angles = [0.0, 88.571_f64, 180.0, 268.571].map(f64::to_radians).to_vec();
    set.sun_mesh.pressure_angle = 24.6_f64.to_radians();
    set.ring_mesh.pressure_angle = 20.19_f64.to_radians();
    for mode in set.modes().expect("a sound model") {
        let [carrier, ring, sun] = [mode.shape[0], mode.shape[1], mode.shape[2]];
        let mut energy = 0.0;
        for (of, [x, y, turn]) in [(set.carrier, carrier), (set.ring, ring), (set.sun, sun)] {
            energy += of.support_stiffness * (x * x + y * y) + of.torsional_stiffness * turn * turn;
        }
        for (index, angle) in set.planet_angles.iter().enumerate() {
            let [radial, tangential, turn] = mode.shape[3 + index];
            let planet = [
                radial * angle.cos() - tangential * angle.sin(),
                radial * angle.sin() + tangential * angle.cos(),
            ];
            let pin = [
                carrier[0] - carrier[2] * set.carrier.radius * angle.sin(),
                carrier[1] + carrier[2] * set.carrier.radius * angle.cos(),
            ];
            energy +=
                set.planet_bearing_stiffness * ((planet[0] - pin[0]).powi(2) + (planet[1] - pin[1]).powi(2));
            for (of, central, mesh, way) in
                [(set.sun, sun, set.sun_mesh, -1.0), (set.ring, ring, set.ring_mesh, 1.0)]
            {
                // Tangent points of the line of action on the base circles: on opposite sides of
                // the line of centres for external gears, on the same side for internal gears.
                let across = angle + way * mesh.pressure_angle;
                let line = [-across.sin(), across.cos()];
                let along = |velocity: [f64; 2]| velocity[0] * line[0] + velocity[1] * line[1];
                let at_central = along([central[0], central[1]]) + of.radius * central[2];
                let at_planet = along(planet) + way * set.planet.radius * turn;
                energy += mesh.stiffness * (at_central - at_planet).powi(2);
            }
        }
        let circular = (TAU * mode.frequency).powi(2);
        assert!((energy - circular).abs() < 1e-11 * (TAU * 13e3_f64).powi(2), "{energy} for {circular}");
    }
}

#[test]
fn planets_that_are_opposite_in_pairs_keep_turning_and_moving_sideways_apart() {
    let mut set = gear_set(4, 0.0);
    set.planet_angles = [0.0, 88.571_f64, 180.0, 268.571].map(f64::to_radians).to_vec();
    assert!(set.modes().expect("sound").iter().all(|mode| mode.kind != ModeKind::Mixed));
    set.planet_angles[1] += 0.05;
    assert!(set.modes().expect("sound").iter().any(|mode| mode.kind == ModeKind::Mixed));
}

#[test]
fn impossible_numbers_are_refused_by_name() {
    let mut set = gear_set(4, 0.0);
    set.sun.mass = 0.0;
    assert_eq!(
        set.modes().expect_err("no mass").to_string(),
        "mass of the sun is 0, and must be greater than 0"
    );
    let mut set = gear_set(4, 0.0);
    set.ring_mesh.stiffness = -1.0;
    assert!(set.modes().is_err());
}
