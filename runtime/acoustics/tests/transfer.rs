//! Transfer vectors, radiation impedance, panel contributions and the far field.

use crate::shapes::{cuboid, sphere};
use crate::spheres::frequency;
use calyx_acoustics::field::FieldMesh;
use calyx_acoustics::sweep::{ImpedanceSweep, TransferSweep};
use calyx_acoustics::{Fluid, Method, RadiationModel, RigidPlane, Settings, SolvedPatterns, SurfaceMesh};
use calyx_numerics::interrupt::Interrupt;
use calyx_numerics::vec3::{Vector, scaled};
use faer::{Mat, c64};

const POINTS: [Vector; 3] = [[0.0, 0.2, 1.4], [2.0, 1.0, 0.5], [-3.0, 0.5, 2.0]];

fn patterns(mesh: &SurfaceMesh) -> Vec<Vec<c64>> {
    let pattern = |k: usize| {
        let at = |t: usize| {
            let [x, y, z] = mesh.centroid(t);
            let phase = (k + 1) as f64;
            c64::new((phase * x + y).sin(), (z * phase).cos())
        };
        (0..mesh.triangles().len()).map(at).collect()
    };
    (0..3).map(pattern).collect()
}

fn box_on_plane() -> SurfaceMesh {
    let (mut vertices, faces) = cuboid([1.0, 0.8, 0.6], [5, 4, 3]);
    vertices.iter_mut().for_each(|vertex| vertex[2] += 0.1);
    let plane = RigidPlane::new([0.0; 3], [0.0, 0.0, 1.0]).expect("valid");
    SurfaceMesh::new(vertices, &faces, Some(plane)).expect("closed")
}

/// The transfer vector of a point, from the transposed equations, and the pressure there of a
/// direct solution.
#[test]
fn transfer_vectors_are_reciprocal() {
    let interrupt = Interrupt::never();
    for mesh in [sphere(1, 1.0), box_on_plane()] {
        let model = RadiationModel { mesh, fluid: Fluid::AIR };
        let patterns = patterns(&model.mesh);
        for (method, accuracy, bound) in [(Method::Dense, 1e-4, 1e-10), (Method::Hierarchical, 1e-7, 1e-6)] {
            let settings = Settings { method, accuracy, ..Settings::default() };
            let equations = model.equations(frequency(2.5), &settings, &interrupt).expect("assembled");
            let transfer = equations.transfer_vectors(&POINTS, &interrupt).expect("in the fluid");
            let velocities =
                Mat::from_fn(model.mesh.triangles().len(), patterns.len(), |i, j| patterns[j][i]);
            let found = transfer.pressures(velocities.as_ref());
            let solutions = equations.solve(&patterns, &interrupt).expect("solved");
            for (case, radiation) in solutions.iter().enumerate() {
                let direct = equations.pressures(radiation, &POINTS, &interrupt).expect("in the fluid");
                for (point, exact) in direct.iter().enumerate() {
                    let error = (found[(point, case)] - exact).norm() / exact.norm();
                    assert!(error < bound, "{method:?}, case {case}, point {point}: {error:e}");
                }
            }
            let panels: Vec<usize> = (0..model.mesh.triangles().len()).map(|t| t % 4).collect();
            let parts = transfer.panel_contributions(1, &patterns[0], &panels, 4);
            let sum: c64 = parts.iter().sum();
            assert!((sum - found[(1, 0)]).norm() < 1e-12 * found[(1, 0)].norm());
        }
    }
}

#[test]
fn radiation_impedance_gives_the_power_of_combinations() {
    let interrupt = Interrupt::never();
    let model = RadiationModel { mesh: box_on_plane(), fluid: Fluid::AIR };
    let patterns = patterns(&model.mesh);
    let equations = model.equations(frequency(2.0), &Settings::default(), &interrupt).expect("assembled");
    let solved = SolvedPatterns::new(&equations, &patterns, &interrupt).expect("solved");
    let amplitudes = [c64::new(1.0, 0.5), c64::new(-0.3, 0.2), c64::new(0.0, 2.0)];
    let velocities: Vec<c64> = (0..model.mesh.triangles().len())
        .map(|t| amplitudes.iter().zip(&patterns).map(|(a, pattern)| a * pattern[t]).sum())
        .collect();
    let radiation = equations.solve(&[velocities], &interrupt).expect("solved").remove(0);
    let power = radiation.power(&model.mesh);
    assert!((solved.impedance().power(&amplitudes) / power - 1.0).abs() < 1e-10);
    let far_power = equations.far_field_power(&radiation, 12, &interrupt).expect("rings");
    let far = solved.far_impedance(12, &interrupt).expect("solved");
    assert!((far.power(&amplitudes) / far_power - 1.0).abs() < 1e-10);
    let combined = |rows: Mat<c64>| -> Vec<c64> {
        (0..rows.nrows()).map(|i| (0..3).map(|j| rows[(i, j)] * amplitudes[j]).sum()).collect()
    };
    let direct = equations.pressures(&radiation, &POINTS, &interrupt).expect("in the fluid");
    let found = combined(solved.pressures(&POINTS, &interrupt).expect("in the fluid"));
    for (found, expected) in found.iter().zip(direct) {
        assert!((found - expected).norm() < 1e-10 * expected.norm(), "{found} {expected}");
    }
    // The far field is the limit of the pressure.
    let (direction, distance) = ([0.6, 0.0, 0.8], 2e3);
    let far = combined(solved.far_field(&[direction], &interrupt).expect("solved"))[0];
    let at = [scaled(direction, distance)];
    let pressure = equations.pressures(&radiation, &at, &interrupt).expect("in the fluid")[0];
    let phase = std::f64::consts::TAU * frequency(2.0) / Fluid::AIR.speed_of_sound * distance;
    let expected = pressure * c64::from_polar(distance, phase);
    assert!((far - expected).norm() < 1e-3 * expected.norm(), "{far} {expected}");
    let panels: Vec<usize> = model.mesh.faces().iter().map(|face| face % 3).collect();
    let parts = radiation.panel_powers(&model.mesh, &panels, 3);
    assert!((parts.iter().sum::<f64>() / power - 1.0).abs() < 1e-10);
    for (panel, expected) in parts.iter().enumerate() {
        let shares: Vec<f64> = panels.iter().map(|own| f64::from(u8::from(*own == panel))).collect();
        let found = solved.panel_impedance(&shares).power(&amplitudes);
        assert!((found - expected).abs() < 1e-10 * power, "{found} {expected}");
    }
}

/// Power on the surface, in the far field, and through a distant hemisphere of field points.
#[test]
fn power_is_the_integral_over_the_far_field() {
    let interrupt = Interrupt::never();
    let model = RadiationModel { mesh: box_on_plane(), fluid: Fluid::AIR };
    for ka in [1.0, 3.0] {
        let equations = model.equations(frequency(ka), &Settings::default(), &interrupt).expect("assembled");
        let velocities = vec![c64::new(1.0, 0.0); model.mesh.triangles().len()];
        let radiation = equations.solve(&[velocities], &interrupt).expect("solved").remove(0);
        let power = radiation.power(&model.mesh);
        let far = equations.far_field_power(&radiation, 12, &interrupt).expect("rings");
        assert!((far / power - 1.0).abs() < 0.005, "ka {ka}: {far} {power}");
        let field = FieldMesh::hemisphere([0.0; 3], [0.0, 0.0, 1.0], 60.0, 12).expect("valid");
        let pressures = equations.pressures(&radiation, &field.points, &interrupt).expect("in the fluid");
        let distant = field.far_field_power(&pressures, Fluid::AIR.impedance());
        assert!((distant / far - 1.0).abs() < 0.002, "ka {ka}: {distant} {far}");
    }
}

/// Pressures and powers between the frequencies of the interpolation, and direct solutions.
#[test]
fn sweeps_interpolate_over_the_frequency() {
    let interrupt = Interrupt::never();
    let model = RadiationModel { mesh: box_on_plane(), fluid: Fluid::AIR };
    let mesh = &model.mesh;
    let patterns = patterns(mesh);
    let at = |ka: f64| model.equations(frequency(ka), &Settings::default(), &interrupt).expect("assembled");
    let (mut vectors, mut impedances) = (Vec::new(), Vec::new());
    for ka in [1.0, 1.4, 1.8, 2.2, 2.6] {
        let equations = at(ka);
        vectors.push(equations.transfer_vectors(&POINTS, &interrupt).expect("in the fluid"));
        impedances.push(SolvedPatterns::new(&equations, &patterns, &interrupt).expect("solved").impedance());
    }
    let too_few = TransferSweep::new(vectors[..3].to_vec(), mesh, &model.fluid, &interrupt);
    assert!(too_few.is_err() && ImpedanceSweep::new(impedances[1..2].to_vec()).is_err());
    let vectors = TransferSweep::new(vectors, mesh, &model.fluid, &interrupt).expect("ascending");
    let impedances = ImpedanceSweep::new(impedances).expect("ascending");

    let amplitudes = [c64::new(1.0, 0.0), c64::new(0.0, 0.0), c64::new(0.0, 0.0)];
    for ka in [1.4, 1.57, 2.5] {
        let equations = at(ka);
        let radiation = equations.solve(&patterns[..1], &interrupt).expect("solved").remove(0);
        let exact = equations.pressures(&radiation, &POINTS, &interrupt).expect("in the fluid");
        let largest = exact.iter().map(|p| p.norm()).fold(0.0, f64::max);
        let found = vectors.pressures(frequency(ka), &patterns[0]).expect("in the range");
        for (found, exact) in found.iter().zip(&exact) {
            let error = (found - exact).norm() / largest;
            assert!(error < 3e-3, "ka {ka}: {error:e}");
        }
        let power = impedances.power(frequency(ka), &amplitudes).expect("in the range");
        let error = power / radiation.power(mesh) - 1.0;
        assert!(error.abs() < 3e-3, "ka {ka}: {error:e}");
    }
    assert!(vectors.pressures(frequency(0.9), &patterns[0]).is_err());
    assert!(vectors.pressures(frequency(2.0), &patterns[0][1..]).is_err());
    assert!(impedances.power(frequency(2.7), &amplitudes).is_err());
    assert!(impedances.power(frequency(2.0), &amplitudes[1..]).is_err());
}
