//! Tests of bodies of revolution against closed forms: rigid-body motions, uniform strain, rings
//! after Lamé and Michell.

use calyx_fe::material::Material;
use calyx_fe::{Constraints, ElementOrder, RevolutionModel, Section, Solver, Station};
use faer::Mat;
use faer::linalg::solvers::Solve;
use faer::sparse::SparseColMat;
use std::f64::consts::TAU;

const STEEL: Material = Material::STEEL;

/// Returns a hub, a dished web with decreasing thickness, and a seat: with steps on both sides.
fn wheel() -> Section {
    let at = |radius, from, to| Station { radius, ends: [from, to] };
    Section::new(vec![
        at(0.3, -0.3, 0.4),
        at(0.5, -0.3, 0.4),
        at(0.5, -0.1, 0.1),
        at(0.8, 0.1, 0.25),
        at(1.0, 0.12, 0.24),
        at(1.0, 0.0, 0.5),
        at(1.1, 0.0, 0.5),
    ])
    .expect("a section")
}

fn model(section: &Section, order: ElementOrder, fineness: usize) -> RevolutionModel {
    RevolutionModel { mesh: section.mesh(order, fineness).expect("a mesh"), material: STEEL }
}

fn times(matrix: &SparseColMat<usize, f64>, vector: &[f64]) -> Vec<f64> {
    let mut product = vec![0.0; vector.len()];
    for entry in matrix.triplet_iter() {
        product[entry.row] += entry.val * vector[entry.col];
    }
    product
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Two rigid-body motions in harmonic zero, two in harmonic one, the latter in two families: six,
/// and no others.
#[test]
fn the_whole_moves_in_six_ways_without_strain() {
    for order in [ElementOrder::QUADRATIC, ElementOrder::CUBIC] {
        let wheel = model(&wheel(), order, 1);
        for harmonic in 0..4 {
            let stiffness = wheel.stiffness(harmonic);
            let largest = stiffness.triplet_iter().fold(0.0_f64, |most, entry| most.max(entry.val.abs()));
            for motion in wheel.rigid_motions(harmonic) {
                let forces = times(&stiffness, &motion);
                let left = forces.iter().fold(0.0_f64, |most, force| most.max(force.abs()));
                assert!(left < 1e-12 * largest, "{harmonic}: {left:e} of {largest:e}");
            }
        }
    }
    // All other motions cause strain: counted by the eigenvalues of the stiffness.
    let at = |radius| Station { radius, ends: [-0.2, 0.1] };
    let ring = model(&Section::new(vec![at(0.6), at(1.0)]).expect("a ring"), ElementOrder::QUADRATIC, 1);
    let free = |harmonic| {
        let stiffness = ring.stiffness(harmonic).to_dense();
        let values = stiffness.self_adjoint_eigenvalues(faer::Side::Lower).expect("values");
        let largest = values.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
        assert!(values.iter().all(|value| *value > -1e-11 * largest));
        values.iter().filter(|value| **value < 1e-9 * largest).count()
    };
    assert_eq!([0, 1, 2, 3].map(free), [2, 2, 0, 0]);
}

/// Uniform strain is exact on any mesh: interior forces vanish, and the work is stress by strain by
/// volume.
#[test]
fn uniform_strain_is_exact() {
    let section = wheel();
    let volume: f64 = section
        .stations()
        .windows(2)
        .map(|pair| {
            // A trapezium in r, times 2 pi r, by Simpson's rule, which is exact.
            let width = |station: Station| station.ends[1] - station.ends[0];
            let middle = 0.25 * (pair[0].radius + pair[1].radius) * (width(pair[0]) + width(pair[1]));
            let ends = pair[0].radius * width(pair[0]) + pair[1].radius * width(pair[1]);
            TAU * (pair[1].radius - pair[0].radius) * (ends + 4.0 * middle) / 6.0
        })
        .sum();
    let shear = 0.5 * STEEL.youngs_modulus / (1.0 + STEEL.poissons_ratio);
    let lame = 2.0 * shear * STEEL.poissons_ratio / (1.0 - 2.0 * STEEL.poissons_ratio);
    let wheel = model(&section, ElementOrder::QUADRATIC, 1);
    type Field = fn([f64; 2]) -> [f64; 3];
    // Radial expansion, axial extension, axial shear twice, transverse shear.
    let cases: [(u16, Field, f64); 4] = [
        (0, |[r, _]| [r, 0.0, 0.0], 4.0 * (lame + shear)),
        (0, |[_, z]| [0.0, 0.0, z], lame + 2.0 * shear),
        (1, |[_, z]| [z, -z, 0.0], shear),
        (2, |[r, _]| [0.5 * r, -0.5 * r, 0.0], shear),
    ];
    for (harmonic, field, density) in cases {
        let displacements: Vec<f64> = wheel.mesh.nodes.iter().flat_map(|&at| field(at)).collect();
        let forces = times(&wheel.stiffness(harmonic), &displacements);
        let work = dot(&forces, &displacements) / (density * volume);
        assert!((work - 1.0).abs() < 1e-12, "{harmonic}: {work}");
        let largest = forces.iter().fold(0.0_f64, |most, force| most.max(force.abs()));
        // Points well inside the web and the hub.
        let inside = |[r, z]: [f64; 2]| (r - 0.4).abs() < 0.05 && z.abs() < 0.2;
        for (node, _) in wheel.mesh.nodes.iter().enumerate().filter(|(_, at)| inside(**at)) {
            for component in 0..3 {
                let left = forces[3 * node + component].abs();
                assert!(left < 1e-11 * largest, "{harmonic}: {left:e} of {largest:e}");
            }
        }
    }
}

/// Returns the largest nodal error of a plane-strain ring with the exact displacements prescribed
/// inside and outside.
fn error_in_plane(
    harmonic: u16,
    order: ElementOrder,
    fineness: usize,
    exact: &dyn Fn(f64) -> [f64; 2],
) -> f64 {
    let at = |radius| Station { radius, ends: [0.0, 0.4] };
    let ring = model(&Section::new(vec![at(0.5), at(1.0)]).expect("a ring"), order, fineness);
    let mut constraints = Constraints::new();
    for (node, &[radius, _]) in ring.mesh.nodes.iter().enumerate() {
        constraints.prescribe(3 * node + 2, 0.0);
        if [0.5, 1.0].iter().any(|end| (radius - end).abs() < 1e-12) {
            for (component, value) in exact(radius).into_iter().enumerate() {
                constraints.prescribe(3 * node + component, value);
            }
        }
    }
    let solver = Solver::new(&ring.stiffness(harmonic), constraints).expect("held");
    let found = solver.solve_one(&vec![0.0; ring.dof_count()]).expect("solved");
    let nodes = ring.mesh.nodes.iter().enumerate();
    nodes
        .flat_map(|(node, &[radius, _])| {
            let exact = exact(radius);
            [0, 1].map(|component| (found[3 * node + component] - exact[component]).abs())
        })
        .fold(0.0, f64::max)
}

/// Lamé's ring, and Michell's with harmonics two and five, fixed inside: in Muskhelishvili's form
/// `2 G (u_r + i u_t) = e^-it (kappa phi - z conj(phi') - conj(psi))` with powers of z for phi and
/// psi. The convergence order of displacements in the element size is one higher than the element
/// order.
#[test]
fn rings_of_plane_strain_converge_to_closed_forms() {
    let kappa = 3.0 - 4.0 * STEEL.poissons_ratio;
    let lame = |r: f64| [(r - 0.25 / r) / 0.75, 0.0];
    let michell = |n: f64| {
        let terms = move |r: f64| {
            let (m, k) = (n + 1.0, 1.0 - n);
            [
                [r.powf(m) * (kappa - m), r.powf(m) * (kappa + m)],
                [r.powf(k) * (kappa - k), -r.powf(k) * (kappa + k)],
                [-r.powf(n - 1.0), r.powf(n - 1.0)],
                [-r.powf(-n - 1.0), -r.powf(-n - 1.0)],
            ]
        };
        let conditions = Mat::from_fn(4, 4, |row, term| terms([0.5, 1.0][row / 2])[term][row % 2]);
        // Fixed inside, expanded outside.
        let right = Mat::from_fn(4, 1, |row, _| if row == 2 { 1.0 } else { 0.0 });
        let amounts = conditions.full_piv_lu().solve(&right);
        move |r: f64| {
            [0, 1].map(|part| (0..4).map(|term| amounts[(term, 0)] * terms(r)[term][part]).sum::<f64>())
        }
    };
    let (two, five) = (michell(2.0), michell(5.0));
    type Exact<'a> = &'a dyn Fn(f64) -> [f64; 2];
    for (harmonic, exact) in [(0, &lame as Exact<'_>), (2, &two), (5, &five)] {
        for (order, rate) in [(ElementOrder::QUADRATIC, 3), (ElementOrder::CUBIC, 4)] {
            let [coarse, fine] = [3, 6].map(|fineness| error_in_plane(harmonic, order, fineness, exact));
            let ratio = coarse / fine;
            assert!(ratio > 0.7 * 2.0_f64.powi(rate), "{harmonic}: {coarse:.1e}, {fine:.1e}");
            assert!(fine < 1e-3, "{harmonic}: {fine:.1e}");
        }
    }
}

#[test]
fn sections_that_are_none_are_refused() {
    let at = |radius, from, to| Station { radius, ends: [from, to] };
    assert!(Section::new(vec![at(0.5, 0.0, 1.0)]).is_none(), "one station");
    assert!(Section::new(vec![at(0.5, 0.0, 1.0), at(0.4, 0.0, 1.0)]).is_none(), "inwards");
    assert!(Section::new(vec![at(0.5, 1.0, 0.0), at(0.6, 0.0, 1.0)]).is_none(), "no width");
    let step = |from, to| {
        Section::new(vec![at(0.3, 0.0, 1.0), at(0.5, 0.0, 1.0), at(0.5, from, to), at(0.6, from, to)])
    };
    assert!(step(1.0, 2.0).is_none(), "a step that does not overlap");
    assert!(step(0.5, 2.0).is_some(), "one that does");
    assert!(
        Section::new(vec![at(0.3, 0.0, 1.0), at(0.5, 0.0, 1.0), at(0.5, 0.2, 0.4)]).is_none(),
        "a step at an end"
    );
}
