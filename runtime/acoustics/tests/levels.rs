//! Levels, A-weighting, equivalent radiated power and field meshes.

use crate::shapes::sphere;
use calyx_acoustics::field::FieldMesh;
use calyx_acoustics::levels::{a_weighting, level_sum, sound_power_level, sound_pressure_level};
use calyx_acoustics::{AcousticError, Fluid, equivalent_radiated_power};
use calyx_numerics::vec3::{dot, length, minus};
use faer::c64;
use std::f64::consts::PI;

/// Values of IEC 61672-1:2013, table 3.
#[test]
fn a_weighting_matches_the_standard() {
    for (frequency, level) in
        [(31.62, -39.4), (100.0, -19.1), (501.2, -3.2), (1000.0, 0.0), (2512.0, 1.3), (10_000.0, -2.5)]
    {
        let found: f64 = a_weighting(frequency);
        assert!((found - level).abs() < 0.06, "{frequency} Hz: {found}");
    }
    assert_eq!(a_weighting(0.0), f64::NEG_INFINITY);
}

#[test]
fn levels_have_their_references() {
    assert!((sound_power_level(1e-3) - 90.0).abs() < 1e-9);
    assert!((sound_pressure_level(2f64.sqrt() * 2e-5) - 0.0).abs() < 1e-9);
    assert!((level_sum([60.0, 60.0]) - 63.0103).abs() < 1e-4);
    assert_eq!(sound_power_level(0.0), f64::NEG_INFINITY);
}

#[test]
fn equivalent_radiated_power_is_that_of_plane_waves() {
    let mesh = sphere(1, 0.3);
    let velocity = c64::new(0.6e-3, 0.8e-3);
    let power = equivalent_radiated_power(&mesh, &Fluid::AIR, &vec![velocity; mesh.triangles().len()]);
    let exact = 0.5 * Fluid::AIR.impedance() * 1e-6 * 4.0 * PI * 0.09;
    assert!((power / exact - 1.0).abs() < 1e-12);
}

#[test]
fn field_meshes_have_their_areas() {
    let center = [0.1, 0.2, 0.3];
    let sphere = FieldMesh::sphere(center, 2.0, 6).expect("valid");
    assert!((sphere.areas.iter().sum::<f64>() / (16.0 * PI) - 1.0).abs() < 1e-12);
    // The rule integrates z² exactly.
    let square: f64 = sphere.normals.iter().zip(&sphere.areas).map(|(n, area)| n[2] * n[2] * area).sum();
    assert!((square / (16.0 * PI / 3.0) - 1.0).abs() < 1e-12);

    let normal = [0.0, 3.0, 0.0];
    for mesh in [
        FieldMesh::hemisphere(center, normal, 2.0, 4).expect("valid"),
        FieldMesh::iso_3744(center, normal, 2.0).expect("valid"),
    ] {
        assert!((mesh.areas.iter().sum::<f64>() / (8.0 * PI) - 1.0).abs() < 1e-12);
        for point in &mesh.points {
            let from = minus(*point, center);
            assert!((length(from) - 2.0).abs() < 1e-12 && dot(from, normal) > 0.0);
        }
    }

    let plane = FieldMesh::plane(center, [[2.0, 0.0, 0.0], [0.0, 3.0, 0.0]], [4, 5]).expect("valid");
    assert!((plane.areas.iter().sum::<f64>() - 6.0).abs() < 1e-12);
    assert_eq!((plane.points.len(), plane.faces.len(), plane.normals[0]), (20, 12, [0.0, 0.0, 1.0]));
}

#[test]
fn invalid_field_meshes_are_rejected() {
    let rejected = |result: Result<FieldMesh, AcousticError>| {
        let error = result.expect_err("invalid");
        assert!(!error.help().is_empty(), "{error}");
    };
    rejected(FieldMesh::sphere([0.0; 3], -1.0, 4));
    rejected(FieldMesh::sphere([0.0; 3], 1.0, 1));
    rejected(FieldMesh::hemisphere([0.0; 3], [0.0; 3], 1.0, 4));
    rejected(FieldMesh::iso_3744([0.0; 3], [f64::NAN, 0.0, 1.0], 1.0));
    rejected(FieldMesh::plane([0.0; 3], [[1.0, 0.0, 0.0], [2.0, 0.0, 0.0]], [2, 2]));
    rejected(FieldMesh::plane([0.0; 3], [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], [0, 2]));
}
