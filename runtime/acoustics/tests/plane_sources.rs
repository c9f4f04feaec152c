//! Baffled pistons by the Rayleigh integral, bodies on a rigid plane, and the agreement of the
//! three levels: equivalent radiated power, Rayleigh integral and boundary elements.

use crate::shapes::{disc, faces, sphere, sphere_and_half};
use crate::spheres::frequency;
use calyx_acoustics::{Fluid, RadiationModel, RigidPlane, Settings, SurfaceMesh, rayleigh};
use calyx_numerics::interrupt::Interrupt;
use calyx_numerics::vec3::Vector;
use faer::c64;
use std::f64::consts::PI;

/// Bessel function J₁ by its integral, with the trapezoidal rule, which converges exponentially.
fn bessel_j1(x: f64) -> f64 {
    let count = 64;
    let sum: f64 = (0..2 * count)
        .map(|k| {
            let angle = PI * f64::from(k) / f64::from(count);
            (angle - x * angle.sin()).cos()
        })
        .sum();
    sum / f64::from(2 * count)
}

/// Power of a piston of unit radius and velocity in a baffle: ½ρcπ (1 - J₁(2ka)/(ka)).
fn piston_power(ka: f64) -> f64 {
    0.5 * Fluid::AIR.impedance() * PI * (1.0 - bessel_j1(2.0 * ka) / ka)
}

fn corners(vertices: &[Vector], triangles: &[[usize; 3]]) -> Vec<[Vector; 3]> {
    triangles.iter().map(|triangle| triangle.map(|vertex| vertices[vertex])).collect()
}

#[test]
fn a_baffled_piston_matches_closed_forms() {
    let (vertices, triangles) = disc(12, 1.0);
    let corners = corners(&vertices, &triangles);
    let velocities = vec![c64::new(1.0, 0.0); corners.len()];
    let fluid = Fluid::AIR;
    let interrupt = Interrupt::never();
    let points = [0.05, 0.5, 2.0, 20.0].map(|z| [0.0, 0.0, z]);
    for ka in [0.1, 1.0, 3.0, 10.0] {
        let power = rayleigh::power(&corners, &velocities, &fluid, frequency(ka), &interrupt);
        let error = power.expect("valid") / piston_power(ka) - 1.0;
        assert!(error.abs() < 0.003, "ka {ka}: {error:e}");
        let found = rayleigh::pressures(&corners, &velocities, &fluid, frequency(ka), &points, &interrupt);
        for (point, pressure) in points.iter().zip(found.expect("valid")) {
            let z = point[2];
            let wave = |path: f64| c64::new((ka * path).cos(), -(ka * path).sin());
            let exact = (wave(z) - wave(z.hypot(1.0))) * fluid.impedance();
            let error = (pressure - exact).norm() / (2.0 * fluid.impedance()).min(exact.norm().max(1.0));
            assert!(error < 0.005, "ka {ka}, z {z}: {error:e}");
        }
    }
}

/// A half-sphere on a rigid plane is the upper half of a whole sphere with a symmetric velocity.
#[test]
fn a_body_on_a_rigid_plane_is_half_of_a_symmetric_one() {
    let meshes = sphere_and_half(2, 1.0);
    let interrupt = Interrupt::never();
    let point = [[0.3, 0.9, 1.1]];
    for ka in [1.0, 3.0] {
        let [whole, half] = [0, 1].map(|index| {
            let model = RadiationModel { mesh: meshes[index].clone(), fluid: Fluid::AIR };
            let mesh = &model.mesh;
            let velocity = |triangle: usize| {
                let [x, _, z] = mesh.centroid(triangle);
                c64::new(1.0 + z * z, x)
            };
            let velocities: Vec<c64> = (0..mesh.triangles().len()).map(velocity).collect();
            let equations = model.equations(frequency(ka), &Settings::default(), &interrupt);
            let equations = equations.expect("assembled");
            let radiation = equations.solve(&[velocities], &interrupt).expect("solved").remove(0);
            let far = equations.far_field_power(&radiation, 12, &interrupt).expect("rings");
            let pressure = equations.pressures(&radiation, &point, &interrupt).expect("in the fluid")[0];
            (radiation.power(mesh), far, pressure)
        });
        assert!((whole.0 / half.0 - 2.0).abs() < 1e-4, "{whole:?}, {half:?}");
        assert!((whole.1 / half.1 - 2.0).abs() < 1e-4, "{whole:?}, {half:?}");
        assert!((whole.2 - half.2).norm() < 1e-4 * whole.2.norm(), "{whole:?}, {half:?}");
    }
}

/// A pulsating sphere radiates plane waves if it is large: its efficiency is (ka)²/(1 + (ka)²).
#[test]
fn boundary_elements_approach_the_equivalent_radiated_power() {
    let model = RadiationModel { mesh: sphere(2, 1.0), fluid: Fluid::AIR };
    let velocities = vec![c64::new(0.0, 1.0); model.mesh.triangles().len()];
    let interrupt = Interrupt::never();
    for (ka, bound) in [(0.3, 0.005), (8.0, 0.01)] {
        let equations = model.equations(frequency(ka), &Settings::default(), &interrupt).expect("assembled");
        let radiation =
            equations.solve(std::slice::from_ref(&velocities), &interrupt).expect("solved").remove(0);
        let exact = ka * ka / (1.0 + ka * ka);
        let error = radiation.efficiency(&model.mesh) / exact - 1.0;
        assert!(error.abs() < bound, "ka {ka}: {error:e}");
    }
}

/// Low cylinder on a rigid plane whose top moves: in the limit of no height, a baffled piston.
fn low_cylinder(rings: usize, height: f64) -> SurfaceMesh {
    let (mut vertices, mut triangles) = disc(rings, 1.0);
    vertices.iter_mut().for_each(|vertex| vertex[2] = height);
    let count = 6 * rings;
    let first = vertices.len() - count;
    let base = vertices.len();
    for k in 0..count {
        let [x, y, _] = vertices[first + k];
        vertices.push([x, y, 0.0]);
    }
    for k in 0..count {
        let next = (k + 1) % count;
        let [a, b, c, d] = [first + k, first + next, base + next, base + k];
        triangles.extend([[a, c, b], [a, d, c]]);
    }
    let plane = RigidPlane::new([0.0; 3], [0.0, 0.0, 1.0]).expect("valid");
    SurfaceMesh::new(vertices, &faces(&triangles), Some(plane)).expect("closed by the plane")
}

/// Boundary elements of low cylinders, extrapolated to no height, and the closed form of a piston.
#[test]
#[ignore = "a minute: run by .ci/full"]
fn boundary_elements_of_a_baffled_piston() {
    let interrupt = Interrupt::never();
    for ka in [0.1, 1.0, 3.0, 5.0] {
        let powers = [0.04, 0.02].map(|height| {
            let model = RadiationModel { mesh: low_cylinder(12, height), fluid: Fluid::AIR };
            let mesh = &model.mesh;
            let velocities: Vec<c64> = mesh.normals().iter().map(|n| c64::new(n[2], 0.0)).collect();
            let equations =
                model.equations(frequency(ka), &Settings::default(), &interrupt).expect("assembled");
            let radiation = equations.solve(&[velocities], &interrupt).expect("solved").remove(0);
            equations.far_field_power(&radiation, 12, &interrupt).expect("rings")
        });
        let error = (2.0 * powers[1] - powers[0]) / piston_power(ka) - 1.0;
        let single = powers.map(|power| power / piston_power(ka) - 1.0);
        println!("ka {ka}: error of the power {error:.2e}; at the heights {single:.3?}");
        assert!(error.abs() < 0.01, "ka {ka}: {error:e}");
    }
}
