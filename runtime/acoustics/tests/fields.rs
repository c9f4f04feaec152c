//! Field meshes around bodies: power by intensity, and the sound power level of ISO 3744.

use crate::shapes::{cuboid, sphere, sphere_and_half};
use crate::spheres::frequency;
use calyx_acoustics::field::FieldMesh;
use calyx_acoustics::levels::{REFERENCE_PRESSURE, sound_power_level};
use calyx_acoustics::shares::panel_shares;
use calyx_acoustics::{Equations, Fluid, Radiation, RadiationModel, Settings, SurfaceMesh};
use calyx_numerics::interrupt::Interrupt;
use calyx_numerics::vec3::{Vector, plus, scaled};
use faer::c64;
use std::f64::consts::TAU;

/// Active power through a field mesh, W: ∫ ½ Re(p v*) dS with v = i/(ωρ) ∂p/∂n from differences.
fn power_through(equations: &Equations<'_>, radiation: &Radiation, field: &FieldMesh) -> f64 {
    // The error of central differences is (kh)²/6, 2e-5 for the largest wavenumber below.
    let step = 5e-3;
    let at = |along: f64| {
        let moved = |(point, normal): (&Vector, &Vector)| plus(*point, scaled(*normal, along));
        let points: Vec<Vector> = field.points.iter().zip(&field.normals).map(moved).collect();
        equations.pressures(radiation, &points, &Interrupt::never()).expect("in the fluid")
    };
    let (inner, middle, outer) = (at(-step), at(0.0), at(step));
    let factor = c64::new(0.0, 1.0 / (TAU * equations.frequency() * Fluid::AIR.density));
    (0..middle.len())
        .map(|k| {
            let velocity = factor * (outer[k] - inner[k]) / (2.0 * step);
            0.5 * (middle[k] * velocity.conj()).re * field.areas[k]
        })
        .sum()
}

/// The power through any field mesh around a body is that on its surface: spheres that are not
/// concentric, near and far, of a source with reactive parts; and a hemisphere on a rigid plane.
#[test]
fn the_intensity_through_a_field_mesh_is_the_radiated_power() {
    let interrupt = Interrupt::never();
    let velocity = |mesh: &SurfaceMesh| -> Vec<c64> {
        let at = |t: usize| {
            let [x, y, z] = mesh.centroid(t);
            c64::new(1.0 + y, (2.0 * x * z) + 0.5 * z)
        };
        (0..mesh.triangles().len()).map(at).collect()
    };
    let [_, half] = sphere_and_half(2, 1.0);
    for (mesh, normal) in [(sphere(2, 1.0), None), (half, Some([0.0, 0.0, 1.0]))] {
        let model = RadiationModel { mesh, fluid: Fluid::AIR };
        for ka in [0.5, 2.0] {
            let equations =
                model.equations(frequency(ka), &Settings::default(), &interrupt).expect("assembled");
            let radiation = equations.solve(&[velocity(&model.mesh)], &interrupt).expect("solved").remove(0);
            let power = equations.far_field_power(&radiation, 12, &interrupt).expect("rings");
            let fields = match normal {
                None => [([0.1, -0.2, 0.0], 1.6), ([0.0; 3], 5.0)]
                    .map(|(center, radius)| FieldMesh::sphere(center, radius, 10)),
                Some(normal) => [([0.1, -0.2, 0.0], 1.6), ([0.0; 3], 5.0)]
                    .map(|(center, radius)| FieldMesh::hemisphere(center, normal, radius, 8)),
            };
            for field in fields {
                let found = power_through(&equations, &radiation, &field.expect("valid"));
                assert!((found / power - 1.0).abs() < 0.005, "ka {ka}: {found} {power}");
            }
        }
    }
}

/// A pulsating half-sphere has the same pressure everywhere at a distance, so that the mean level
/// of the microphones and the area give its exact power. The reference values of ISO 3744 belong to
/// an impedance of 400 Ns/m³.
#[test]
fn microphones_give_the_sound_power_of_a_pulsating_half_sphere() {
    let interrupt = Interrupt::never();
    let [_, mesh] = sphere_and_half(2, 0.2);
    let velocities = vec![c64::new(1e-4, 0.0); mesh.triangles().len()];
    let model = RadiationModel { mesh, fluid: Fluid::AIR };
    let equations = model.equations(300.0, &Settings::default(), &interrupt).expect("assembled");
    let radiation = equations.solve(&[velocities], &interrupt).expect("solved").remove(0);
    let power = radiation.power(&model.mesh);
    let normal = [0.0, 0.0, 1.0];
    let level = |field: FieldMesh| {
        let pressures = equations.pressures(&radiation, &field.points, &interrupt).expect("in the fluid");
        let square = field.mean(pressures.iter().map(|pressure| 0.5 * pressure.norm_sqr()));
        10.0 * (square / REFERENCE_PRESSURE.powi(2) * field.area()).log10()
    };
    let expected = sound_power_level(power) + 10.0 * (Fluid::AIR.impedance() / 400.0).log10();
    let found = level(FieldMesh::iso_3744([0.0; 3], normal, 2.0).expect("valid"));
    assert!((found - expected).abs() < 0.02, "{found} {expected}");
    // On a box distances differ, which the standard accepts: its levels are higher by up to 1.5 dB.
    let found = level(FieldMesh::iso_3744_box([0.0; 3], normal, [0.4, 0.4, 0.2], 1.0).expect("small"));
    assert!((-0.5..1.5).contains(&(found - expected)), "{found} {expected}");
}

#[test]
fn positions_on_a_box_are_those_of_the_standard() {
    let field =
        FieldMesh::iso_3744_box([1.0, 2.0, 3.0], [0.0, 0.0, 2.0], [0.6, 0.4, 0.5], 1.0).expect("small");
    assert_eq!(field.points.len(), 9);
    // a = 1.3 m, b = 1.2 m, c = 1.5 m.
    assert!((field.area() - 4.0 * (1.3 * 1.2 + 1.2 * 1.5 + 1.5 * 1.3)).abs() < 1e-12);
    for (index, expected) in
        [(0, [2.3, 2.0, 3.75]), (1, [1.0, 3.2, 3.75]), (6, [-0.3, 0.8, 4.5]), (8, [1.0, 2.0, 4.5])]
    {
        (0..3).for_each(|k| assert!((field.points[index][k] - expected[k]).abs() < 1e-12, "{index}"));
    }
    for (sides, distance) in [([1.2, 0.4, 0.5], 1.0), ([0.2, 0.2, 2.1], 1.0), ([0.2, 0.0, 0.2], 1.0)] {
        let error = FieldMesh::iso_3744_box([0.0; 3], [0.0, 0.0, 1.0], sides, distance).expect_err("refused");
        assert!(!error.help().is_empty(), "{error}");
    }
}

/// A panel keeps its area on a coarser surface, whose edges do not follow its rim.
#[test]
fn panels_keep_their_areas_on_a_coarser_surface() {
    let size = [1.0, 0.8, 0.6];
    let mesh = |counts: [usize; 3]| {
        let (vertices, faces) = cuboid(size, counts);
        SurfaceMesh::new(vertices, &faces, None).expect("closed")
    };
    let (fine, coarse) = (mesh([16, 12, 10]), mesh([3, 3, 2]));
    let top = fine.vertices().iter().map(|vertex| vertex[2]).fold(f64::NEG_INFINITY, f64::max);
    let left = fine.vertices().iter().map(|vertex| vertex[0]).fold(f64::INFINITY, f64::min);
    let panel = |t: usize| {
        let [x, _, z] = fine.centroid(t);
        match fine.normals()[t] {
            [_, _, normal] if normal > 0.9 && x - left < 0.4 => Some(0),
            [normal, _, _] if normal < -0.9 && top - z < 0.3 => Some(1),
            _ => None,
        }
    };
    let panels: Vec<Option<usize>> = (0..fine.triangles().len()).map(panel).collect();
    let shares = panel_shares(&fine, &panels, &coarse, 2);
    for (panel, shares) in shares.iter().enumerate() {
        let area = |mesh: &SurfaceMesh, share: &dyn Fn(usize) -> f64| -> f64 {
            mesh.areas().iter().enumerate().map(|(t, area)| area * share(t)).sum()
        };
        let expected = area(&fine, &|t| f64::from(u8::from(panels[t] == Some(panel))));
        let found = area(&coarse, &|t| shares[t]);
        // Centroids assign the fine triangles, so areas are rounded to some of these.
        assert!((found / expected - 1.0).abs() < 0.1, "{panel}: {found} {expected}");
        for (t, share) in shares.iter().enumerate() {
            let is_side = coarse.normals()[t][[2, 0][panel]].abs() > 0.9;
            assert!((0.0..=1.0).contains(share) && (*share == 0.0 || is_side), "{panel} {t}: {share}");
        }
    }
    let own = panel_shares(&fine, &panels, &fine, 2);
    assert!((0..panels.len()).all(|t| own[0][t] == f64::from(u8::from(panels[t] == Some(0)))));
}
