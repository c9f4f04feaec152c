//! Spheres against closed forms: power, surface pressure and pressure at points, including the
//! frequencies at which the equation without normal derivative has no unique solution.

use crate::shapes::sphere;
use crate::special_functions::{cap, legendre, sphere_power, sphere_pressure};
use calyx_acoustics::{Fluid, Method, RadiationModel, Settings, SurfaceMesh};
use calyx_numerics::interrupt::Interrupt;
use calyx_numerics::vec3::{Vector, length, plus, scaled, unit};
use faer::c64;
use std::f64::consts::{PI, TAU};

/// Relative errors of a case: power on the surface and in the far field; largest errors of the
/// pressure on the surface and at points, relative to the largest amplitude at the same distance.
#[derive(Clone, Copy, Debug)]
struct Errors {
    power: f64,
    far_power: f64,
    surface: f64,
    field: f64,
}

impl Errors {
    fn largest(&self) -> f64 {
        self.power.max(self.far_power).max(self.surface).max(self.field)
    }
}

/// Points at distances from 1.06 to 10 radii.
const POINTS: [Vector; 5] =
    [[0.2, 0.3, 1.0], [1.5, -0.3, 0.8], [-2.0, 1.0, -1.0], [0.1, 0.2, -3.0], [7.0, 5.0, 5.0]];

/// Coefficients of the Legendre polynomial of an order.
fn mode(order: usize) -> Vec<f64> {
    let mut values = vec![0.0; order + 1];
    values[order] = 1.0;
    values
}

/// Velocities that are a sum of Legendre polynomials at the centroids.
fn velocities(mesh: &SurfaceMesh, coefficients: &[f64]) -> Vec<c64> {
    let at = |triangle: usize| {
        let p = legendre(coefficients.len(), unit(mesh.centroid(triangle))[2]);
        c64::new(coefficients.iter().zip(&p).map(|(a, b)| a * b).sum(), 0.0)
    };
    (0..mesh.triangles().len()).map(at).collect()
}

/// Mean velocities of triangles that a cap of this polar angle covers in part.
fn cap_velocities(mesh: &SurfaceMesh, half_angle: f64) -> Vec<c64> {
    let parts = 24;
    let covered = |triangle: usize| {
        let [a, b, c] = mesh.corners(triangle);
        let mut count = 0;
        for i in 0..parts {
            for j in 0..parts - i {
                for k in 0..if j + 1 < parts - i { 2 } else { 1 } {
                    // Centroids of the small triangles.
                    let shift = f64::from(k + 1) / 3.0;
                    let [u, v] = [i, j].map(|at| (f64::from(at) + shift) / f64::from(parts));
                    let at = plus(scaled(a, 1.0 - u - v), plus(scaled(b, u), scaled(c, v)));
                    count += i32::from(unit(at)[2] > half_angle.cos());
                }
            }
        }
        c64::new(f64::from(count) / f64::from(parts * parts), 0.0)
    };
    (0..mesh.triangles().len()).map(covered).collect()
}

/// Solves for several velocities of a unit sphere, and compares each with the closed form of its
/// coefficients.
fn compare(mesh: &SurfaceMesh, ka: f64, cases: &[(Vec<f64>, Vec<c64>)], settings: &Settings) -> Vec<Errors> {
    let model = RadiationModel { mesh: mesh.clone(), fluid: Fluid::AIR };
    let impedance = model.fluid.impedance();
    let interrupt = Interrupt::never();
    let equations = model.equations(frequency(ka), settings, &interrupt).expect("assembled");
    let velocities: Vec<Vec<c64>> = cases.iter().map(|(_, velocities)| velocities.clone()).collect();
    let solutions = equations.solve(&velocities, &interrupt).expect("solved");
    let errors = cases.iter().zip(&solutions).map(|((coefficients, _), radiation)| {
        let power = sphere_power(coefficients, ka, 1.0) * impedance;
        let far_power = equations.far_field_power(radiation, 14, &interrupt).expect("rings");
        let exact = |r: f64, cosine: f64| sphere_pressure(coefficients, ka, 1.0, r, cosine) * impedance;
        let deviation = |p: &c64, r: f64, cosine: f64| {
            let largest = (0..=20).map(|k| exact(r, 0.1 * f64::from(k) - 1.0).norm()).fold(0.0, f64::max);
            let deviation = (p - exact(r, cosine)).norm() / largest;
            assert!(deviation.is_finite());
            deviation
        };
        let vertices = model.mesh.vertices().iter().zip(radiation.pressures());
        let surface = vertices.map(|(at, p)| deviation(p, 1.0, unit(*at)[2]));
        let pressures = equations.pressures(radiation, &POINTS, &interrupt).expect("in the fluid");
        let field = POINTS.iter().zip(&pressures).map(|(at, p)| deviation(p, length(*at), unit(*at)[2]));
        Errors {
            power: (radiation.power(&model.mesh) / power - 1.0).abs(),
            far_power: (far_power / power - 1.0).abs(),
            surface: surface.fold(0.0, f64::max),
            field: field.fold(0.0, f64::max),
        }
    });
    errors.collect()
}

/// Frequency for a sphere of unit radius, Hz.
pub fn frequency(ka: f64) -> f64 {
    ka * Fluid::AIR.speed_of_sound / TAU
}

fn modes(mesh: &SurfaceMesh, ka: f64, orders: usize, settings: &Settings) -> Vec<Errors> {
    let cases = (0..orders).map(|order| (mode(order), velocities(mesh, &mode(order))));
    compare(mesh, ka, &cases.collect::<Vec<_>>(), settings)
}

/// Every error falls with the square of the element size. At ka = 1 the equations are uncoupled, at
/// ka = 3 they are those of Burton and Miller.
#[test]
fn errors_converge_at_second_order() {
    for ka in [1.0, 3.0] {
        let [coarse, fine] = [1, 2].map(|level| modes(&sphere(level, 1.0), ka, 3, &Settings::default()));
        for (order, (coarse, fine)) in coarse.iter().zip(&fine).enumerate() {
            for (name, a, b) in [
                ("far power", coarse.far_power, fine.far_power),
                ("surface", coarse.surface, fine.surface),
                ("field", coarse.field, fine.field),
            ] {
                let rate = (a / b).log2();
                assert!(rate > 1.6, "ka {ka}, order {order}, {name}: {a:.2e} and {b:.2e}");
            }
        }
    }
}

/// 320 elements, up to the frequency with six of them per wavelength.
#[test]
fn modes_of_a_coarse_sphere_match_closed_forms() {
    for ka in [0.1, 1.9, 2.1, 4.0] {
        for (order, errors) in modes(&sphere(2, 1.0), ka, 3, &Settings::default()).iter().enumerate() {
            let bound = [0.01, 0.018, 0.034][order];
            assert!(errors.largest() < bound, "ka {ka}, order {order}: {errors:?}");
        }
    }
}

/// The interior of the sphere has its first Dirichlet eigenvalues at π, 4.4934 and 2π. Errors are
/// as small there as next to them.
#[test]
fn irregular_frequencies_have_no_effect() {
    let mesh = sphere(2, 1.0);
    for ka in [PI, 4.4934, TAU] {
        let [at, beside] = [ka, ka + 0.2].map(|ka| modes(&mesh, ka, 2, &Settings::default()));
        for (order, (at, beside)) in at.iter().zip(&beside).enumerate() {
            assert!(at.power < 0.005 && at.far_power < 0.005, "ka {ka}, order {order}: {at:?}");
            assert!(at.largest() < 1.3 * beside.largest(), "ka {ka}, order {order}: {at:?}, {beside:?}");
        }
    }
}

/// The rules of quadrature contribute little to the error.
#[test]
fn finer_quadrature_changes_little() {
    let mesh = sphere(1, 1.0);
    let fine = Settings { fine_quadrature: true, ..Settings::default() };
    for ka in [0.5, 2.5] {
        let [standard, fine] = [Settings::default(), fine].map(|settings| modes(&mesh, ka, 3, &settings));
        for (standard, fine) in standard.iter().zip(&fine) {
            let change = (standard.surface - fine.surface).abs();
            assert!(change < 0.05 * fine.surface, "ka {ka}: {standard:?}, {fine:?}");
        }
    }
}

#[test]
fn hierarchical_matrices_give_the_same_solution() {
    let mesh = sphere(2, 1.0);
    for ka in [1.0, 5.0] {
        let [dense, compressed] = [Method::Dense, Method::Hierarchical]
            .map(|method| modes(&mesh, ka, 3, &Settings { method, ..Settings::default() }));
        for (dense, compressed) in dense.iter().zip(&compressed) {
            assert!((dense.surface - compressed.surface).abs() < 3e-4, "{dense:?}, {compressed:?}");
            assert!((dense.field - compressed.field).abs() < 1e-4, "{dense:?}, {compressed:?}");
        }
    }
}

/// 5,120 elements: power and pressures of modes to 1 %, and of a vibrating cap. The velocity of the
/// cap is discontinuous, so its surface pressure converges slowly at the edge, and only its power
/// and the pressure at points are compared.
#[test]
#[ignore = "several minutes: run by .ci/full"]
fn fine_sphere_is_accurate_to_one_percent() {
    let mesh = sphere(4, 1.0);
    let half_angle = 0.7;
    let mut cases: Vec<(Vec<f64>, Vec<c64>)> =
        (0..4).map(|order| (mode(order), velocities(&mesh, &mode(order)))).collect();
    cases.push((cap(half_angle, 60), cap_velocities(&mesh, half_angle)));
    println!("| ka | case | power | far field | surface | points |\n|---|---|---|---|---|---|");
    for ka in [0.1, 1.0, PI, 4.4934, TAU, 10.0] {
        for (case, errors) in compare(&mesh, ka, &cases, &Settings::default()).iter().enumerate() {
            let Errors { power, far_power, surface, field } = *errors;
            let name = ["n = 0", "n = 1", "n = 2", "n = 3", "cap"][case];
            let [a, b, c, d] = [power, far_power, surface, field].map(|error| 100.0 * error);
            println!("| {ka:.4} | {name} | {a:.3} % | {b:.3} % | {c:.3} % | {d:.3} % |");
            let surface = if case == 4 { 0.0 } else { surface };
            let largest = power.max(far_power).max(surface).max(field);
            assert!(largest < 0.01, "ka {ka}, {name}: {errors:?}");
        }
    }
}
