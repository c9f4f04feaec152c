//! Raceways in the bores of rings: condensed rings against whole meshes under the same tractions.

use super::bodies::{Divisions, STEEL, toothed_ring, toothed_sector};
use super::bore::{Direct, dot, force};
use super::spline_clearance::TEETH;
use super::spline_teeth::{PLANE_POINTS, Ring, SMALL, plane_means};
use crate::BoreSupport;
use crate::bore::BoreMeans;
use crate::condense::Assembled;
use calyx_fe::material::Plane;
use calyx_fe::{PlaneModel, SparseVector};
use calyx_numerics::quadrature::gauss_legendre;
use faer::{Mat, MatRef};
use std::f64::consts::{PI, TAU};

const RACEWAY: BoreSupport = BoreSupport::Raceway { harmonics: 9, degree: 0 };

/// The displacements of rollers, those by gear teeth and stresses by rollers are those of the whole
/// mesh under the same tractions, with constrained rigid-body means only.
#[test]
fn a_raceway_moves_as_on_the_whole_mesh() {
    let (sector, _) = toothed_sector(TEETH, 1.0, SMALL);
    let whole = PlaneModel::new(toothed_ring(TEETH, SMALL), STEEL, Plane::Strain);
    let ring = Ring::plane(&sector, RACEWAY, TEETH, &PLANE_POINTS).unwrap();
    let means = plane_means(&whole, RACEWAY);
    assert_eq!(means.constrained, 3);
    let equations = Assembled::plane(&whole);
    let constrained: Vec<SparseVector> = means.forms[..means.constrained].to_vec();
    let direct = Direct::new(&equations, &whole.rigid_body_modes(), &constrained);
    let interface = ring.coupling.interface.as_ref().unwrap();
    let raceway = interface.raceway.unwrap();
    let size = equations.stiffness.nrows();
    let coefficients = &means.raceway.as_ref().unwrap().coefficients;
    // Force of a roller at an angle: the traction of its terms.
    let form = |terms: &[f64]| {
        let mut form = vec![0.0; size];
        for (place, mean) in means.forms.iter().enumerate() {
            let amount: f64 = (0..terms.len()).map(|term| terms[term] * coefficients[(term, place)]).sum();
            form.iter_mut().zip(mean.to_full(size)).for_each(|(sum, part)| *sum += amount * part);
        }
        form
    };
    let rollers = [0.1, 0.9, 2.0, 4.4].map(|angle| raceway.terms_along(angle, 0.0, 1.0)[0].clone());
    let column = |terms: &[f64]| Mat::from_fn(terms.len(), 1, |row, _| terms[row]);
    let scale = (rollers[0].iter().zip((&interface.compliance * column(&rollers[0])).col(0).iter()))
        .map(|(term, moved)| term * moved)
        .sum::<f64>();
    for (loaded, terms) in rollers.iter().enumerate() {
        let (displacement, _) = direct.solve(&form(terms));
        let moved = &interface.compliance * column(terms);
        for observer in &rollers {
            let expected = dot(&form(observer), &displacement);
            let found: f64 = observer.iter().zip(moved.col(0).iter()).map(|(a, b)| a * b).sum();
            assert!((found - expected).abs() < 1e-9 * scale, "roller {loaded}: {found} {expected}");
        }
        for tooth in 0..TEETH {
            let angle = ring.coupling.pitch * f64::from(tooth);
            let forces = MatRef::from_column_major_slice(terms, terms.len(), 1);
            let by_rows = ring.coupling.stresses_by_interface(0, tooth, forces).unwrap();
            for (point, &(at, along)) in PLANE_POINTS.iter().enumerate() {
                let expected = force(&equations, at, along, angle).dot(&displacement);
                let by_tooth = ring.coupling.interface_displacements(tooth, &ring.constraint_forces(point));
                let moved: f64 = terms.iter().zip(by_tooth.col(0).iter()).map(|(a, b)| a * b).sum();
                for found in [moved, by_rows[(point, 0)]] {
                    assert!((found - expected).abs() < 1e-9 * scale, "tooth {tooth}: {found} {expected}");
                }
            }
        }
    }
}

/// The series resolves its own terms: at the same angle along a line, the mean of a polynomial of
/// even degree is that of the polynomial, and the line is the nearest one.
#[test]
fn rollers_observe_means_and_slopes() {
    let raceway = crate::Raceway { radius: 0.02, ends: [-0.01, 0.03], harmonics: 1, degree: 3 };
    let [means, slopes] = raceway.terms_along(0.0, 0.015, 0.008);
    // The cosine of harmonic 1 of each degree is 1 at the angle 0.
    let (zeta, half) = (0.25, 0.2);
    let mean = |degree: usize| means[3 * degree + 1];
    let slope = |degree: usize| slopes[3 * degree + 1];
    let close =
        |found: f64, expected: f64| assert!((found - expected).abs() < 1e-12 * expected.abs().max(1.0));
    close(mean(0), 1.0);
    close(mean(1), zeta);
    close(mean(2), 1.5 * (zeta * zeta + half * half / 3.0) - 0.5);
    close(mean(3), 2.5 * (zeta.powi(3) + zeta * half * half) - 1.5 * zeta);
    close(slope(0), 0.0);
    close(slope(1), 50.0);
    close(slope(2), 150.0 * zeta);
}

/// Means of the displacement of a half-plane, `-2 ln(x / R) / (pi E')` per unit line load, over a
/// load of the form `1 + cos` within `half` (rad) and weighted alike.
fn half_plane_bump(half: f64) -> f64 {
    // The distance of two points with this weight has the autocorrelation of the weight.
    let points = gauss_legendre(40);
    let weight =
        |angle: f64| if angle.abs() < half { (1.0 + (PI * angle / half).cos()) / (2.0 * half) } else { 0.0 };
    let correlation = |distance: f64| -> f64 {
        let (low, high) = (distance - half, half);
        let at = |node: f64| 0.5 * (low + high) + 0.5 * (high - low) * node;
        let value = |node: f64| weight(at(node)) * weight(at(node) - distance);
        points.iter().map(|&(node, part)| 0.5 * (high - low) * part * value(node)).sum()
    };
    let log = |(node, part): &(f64, f64)| {
        let s = 0.5 * (1.0 + node);
        let distance = 2.0 * half * s.powi(3);
        0.5 * part * 6.0 * half * s * s * 2.0 * correlation(distance) * -distance.ln()
    };
    2.0 / PI * points.iter().map(log).sum::<f64>()
}

/// The same displacement in a series up to a harmonic.
fn half_plane_series(harmonics: u16) -> f64 {
    let panels = 4 * usize::from(harmonics);
    let mut sum = 0.0;
    for panel in 0..panels {
        for (node, part) in gauss_legendre(12) {
            let s = 0.5 * (1.0 + node);
            let (within, slope) = if panel == 0 { (s.powi(3), 3.0 * s * s) } else { (s, 1.0) };
            let angle = PI * (panel as f64 + within) / panels as f64;
            let dirichlet = 1.0 + 2.0 * (1..=harmonics).map(|k| (f64::from(k) * angle).cos()).sum::<f64>();
            sum += 0.5 * part * slope * PI / panels as f64 * dirichlet * -angle.ln();
        }
    }
    2.0 / PI * sum / PI
}

/// Without the half-plane's displacement in the same load, a raceway moves under a series of the
/// force of a roller as under a force that is distributed otherwise: the part that depends on the
/// distribution is that of the half-plane, whose contact has it.
#[test]
fn displacements_beyond_the_half_plane_do_not_depend_on_the_distribution_of_forces() {
    const FINE: Divisions = Divisions { rim: 6, tooth_root: 3, flank: 2, thickness: 14, grading: 1.0 };
    const ANGLES: [f64; 3] = [0.2, 0.6, 1.7];
    let whole = PlaneModel::new(toothed_ring(TEETH, FINE), STEEL, Plane::Strain);
    let equations = Assembled::plane(&whole);
    let modulus = STEEL.youngs_modulus / (1.0 - STEEL.poissons_ratio.powi(2));
    let means = plane_means(&whole, RACEWAY);
    let constrained: Vec<SparseVector> = means.forms[..means.constrained].to_vec();
    let direct = Direct::new(&equations, &whole.rigid_body_modes(), &constrained);
    let bore = whole.mesh.chain("bore").unwrap();
    let bump = |half: f64, angle: f64| {
        let load = whole.edge_load(bore, |_, point| {
            let [x, y] = point.position;
            let radius = x.hypot(y);
            let apart = (y.atan2(x) - angle + PI).rem_euclid(TAU) - PI;
            let weight = if apart.abs() < half { 1.0 + (PI * apart / half).cos() } else { 0.0 };
            [x, y].map(|part| part / radius * weight / (2.0 * half * radius))
        });
        load.to_full(equations.stiffness.nrows())
    };
    let series = |means: &BoreMeans, angle: f64| {
        let raceway = means.raceway.as_ref().unwrap();
        let coefficients = &raceway.coefficients;
        let terms = raceway.raceway.terms_along(angle, 0.0, 1.0)[0].clone();
        let size = equations.stiffness.nrows();
        let mut form = vec![0.0; size];
        for (place, mean) in means.forms.iter().enumerate().skip(means.constrained) {
            let amount: f64 = (0..terms.len()).map(|term| terms[term] * coefficients[(term, place)]).sum();
            form.iter_mut().zip(mean.to_full(size)).for_each(|(sum, part)| *sum += amount * part);
        }
        form
    };
    let table = |load: &dyn Fn(f64) -> Vec<f64>, half_plane: f64| -> Vec<f64> {
        let loads = ANGLES.map(load);
        let moved = loads.each_ref().map(|load| direct.solve(load).0);
        let entry = |(i, j): (usize, usize)| {
            dot(&loads[i], &moved[j]) - if i == j { half_plane / modulus } else { 0.0 }
        };
        (0..3).flat_map(|i| (0..3).map(move |j| (i, j))).map(entry).collect()
    };
    let bumps = [0.04, 0.08].map(|half| table(&|angle| bump(half, angle), half_plane_bump(half)));
    for harmonics in [20, 28, 42] {
        let support = BoreSupport::Raceway { harmonics, degree: 0 };
        let means = plane_means(&whole, support);
        let found = table(&|angle| series(&means, angle), half_plane_series(harmonics));
        for ((narrow, wide), found) in bumps[0].iter().zip(&bumps[1]).zip(found) {
            // The ring's smooth displacement is averaged over the load: an error of second order.
            let expected = modulus * (narrow + (narrow - wide) / 3.0);
            let found = modulus * found;
            // Half-planes move by 2.3 to 2.9 in these loads. The tolerance was set afterwards.
            assert!((found - expected).abs() < 0.1, "{harmonics} harmonics: {found} {expected}");
        }
    }
}
