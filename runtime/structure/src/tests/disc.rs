//! Free disc under opposite loads, whose exact solution is known as a series and in closed form.
//! This test detects an incorrect far field.

use super::bodies::{STEEL, disc};
use crate::{Chart, ElasticStructure, MeshSupport, SplitOptions, Structure};
use calyx_fe::material::Plane;
use calyx_numerics::interrupt::Interrupt;
use calyx_numerics::quadrature::gauss_legendre;
use std::f64::consts::{FRAC_PI_4, PI};

const SIDES: [Chart; 2] = [Chart { tooth: 0, surface: 0 }, Chart { tooth: 0, surface: 1 }];

fn single(structure: &ElasticStructure, observe: Chart, s: f64, load: Chart, at: f64) -> f64 {
    let mut value = [0.0];
    structure.add_compliance(observe, &[s], load, &[at], &mut value);
    value[0]
}

/// Returns the inward displacement at angle `theta` from the load by unit inward loads at 0 and pi
/// on a disc. The loads are opposite, so there is no rigid-body motion. The Fourier series of
/// `[(k + 1)/n + (1 - k)/n² + ...]/(4 mu)` is evaluated with its slowly converging parts summed in
/// closed form.
fn exact(theta: f64, plane: Plane) -> f64 {
    let (young, nu) = (STEEL.youngs_modulus, STEEL.poissons_ratio);
    let mu = 0.5 * young / (1.0 + nu);
    let kolosov = match plane {
        Plane::Strain => 3.0 - 4.0 * nu,
        Plane::Stress => (3.0 - nu) / (1.0 + nu),
    };
    let doubled = 2.0 * theta;
    let mut series = -0.5 * (kolosov + 1.0) * (2.0 * theta.sin().abs()).ln()
        + 0.25 * (1.0 - kolosov) * (PI * PI / 6.0 - 0.5 * PI * doubled + 0.25 * doubled * doubled);
    for half in 1..2000 {
        let n = 2.0 * f64::from(half);
        let rest = kolosov / (n + 1.0) + 1.0 / (n - 1.0) - (kolosov + 1.0) / n - (1.0 - kolosov) / (n * n);
        series += rest * (n * theta).cos();
    }
    ((kolosov - 1.0) / PI + 2.0 / PI * series) / (4.0 * mu)
}

#[test]
fn opposite_loads_agree_with_the_exact_solution_everywhere() {
    let radius = 0.02;
    let worst = |plane: Plane, divisions: usize| {
        let (mut model, surfaces) = disc(radius, divisions);
        model.plane = plane;
        let structure = ElasticStructure::single(
            &model,
            MeshSupport::Free,
            &surfaces,
            &SplitOptions::default(),
            &Interrupt::never(),
        )
        .unwrap();
        let (modulus, length) = (structure.surface_modulus(), structure.reference_length());
        let mut worst = 0.0_f64;
        for load in [-0.4, -0.1, 0.0, 0.3] {
            for theta in [1e-4, 0.003, 0.02, 0.1, 0.3] {
                let (s, at) = (radius * (FRAC_PI_4 + load + theta), radius * (FRAC_PI_4 + load));
                let half_plane = -2.0 / (PI * modulus) * ((s - at).abs() / length).ln();
                // The opposite load lies on the other arc at the same arc length.
                let value = half_plane
                    + single(&structure, SIDES[0], s, SIDES[0], at)
                    + single(&structure, SIDES[0], s, SIDES[1], at);
                worst = worst.max((value - exact(theta, plane)).abs() * modulus);
            }
        }
        worst
    };
    for plane in [Plane::Strain, Plane::Stress] {
        // In units of 1/E'; the compliance itself is 1 to 7 of them.
        let (coarse, fine) = (worst(plane, 10), worst(plane, 20));
        assert!(coarse < 1e-2 && fine < 2.5e-3, "{plane:?}: {coarse:.1e} {fine:.1e}");
    }
}

#[test]
fn squeezed_disc_has_the_known_approach() {
    let radius = 0.02;
    let (model, surfaces) = disc(radius, 20);
    let structure = ElasticStructure::single(
        &model,
        MeshSupport::Free,
        &surfaces,
        &SplitOptions::default(),
        &Interrupt::never(),
    )
    .unwrap();
    let (modulus, length) = (structure.surface_modulus(), structure.reference_length());
    let middle = radius * FRAC_PI_4;
    for half_width in [0.03 * radius, 0.003 * radius] {
        // Hertzian pressure of unit force; its logarithmic mean at the middle is ln(a / 2) - 1/2.
        let mut inward = -2.0 / (PI * modulus) * ((0.5 * half_width / length).ln() - 0.5);
        for (x, weight) in gauss_legendre(40) {
            // s = a sin(pi x / 2) removes the square root from the pressure.
            let angle = 0.5 * PI * x;
            let force = weight * angle.cos().powi(2);
            let at = middle + half_width * angle.sin();
            inward += force * single(&structure, SIDES[0], middle, SIDES[0], at);
            inward += force * single(&structure, SIDES[0], middle, SIDES[1], at);
        }
        let approach = 2.0 * inward;
        let known = 2.0 / (PI * modulus) * (2.0 * (4.0 * radius / half_width).ln() - 1.0);
        // The published approach neglects terms of the order of (a / R) / (4 pi): the tangential
        // displacement of the half-plane.
        assert!((approach / known - 1.0).abs() < 1e-3, "{approach} against {known}");
    }
}

#[test]
fn scaling_modulus_and_lengths_scales_the_answer() {
    let options = SplitOptions { samples: 12, ..SplitOptions::default() };
    let answer = |radius: f64, modulus_factor: f64| {
        let (mut model, surfaces) = disc(radius, 8);
        model.material.youngs_modulus *= modulus_factor;
        let structure =
            ElasticStructure::single(&model, MeshSupport::Free, &surfaces, &options, &Interrupt::never())
                .unwrap();
        let points: Vec<f64> = [0.2, 0.7, 1.1].map(|angle| radius * angle).to_vec();
        let mut block = vec![0.0; 9];
        structure.add_compliance(SIDES[0], &points, SIDES[0], &points, &mut block);
        structure.add_compliance(SIDES[1], &points, SIDES[0], &points, &mut block);
        block.iter().map(|value| value * STEEL.youngs_modulus * modulus_factor).collect::<Vec<_>>()
    };
    let reference = answer(0.02, 1.0);
    for (length, modulus) in [(3.7e4, 1.0), (3.7e-4, 1.0), (1.0, 3.7e4), (3.7e-4, 3.7e4)] {
        for (value, reference) in answer(0.02 * length, modulus).iter().zip(&reference) {
            assert!((value - reference).abs() < 1e-9 * reference.abs().max(1.0), "{value} {reference}");
        }
    }
}
