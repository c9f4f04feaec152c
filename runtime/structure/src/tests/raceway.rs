//! Raceways in the bores of rings: condensed rings against whole meshes under the same tractions.

use super::bodies::{STEEL, toothed_ring, toothed_sector};
use super::bore::{Direct, dot, force};
use super::spline_clearance::TEETH;
use super::spline_teeth::{PLANE_POINTS, Ring, SMALL, plane_means};
use crate::BoreSupport;
use crate::condense::Assembled;
use calyx_fe::material::Plane;
use calyx_fe::{PlaneModel, SparseVector};
use faer::{Mat, MatRef};

const RACEWAY: BoreSupport = BoreSupport::Raceway { harmonics: 9, degree: 0 };

/// The displacements of rollers, those by gear teeth and stresses by rollers are those of the whole
/// mesh under the same tractions, with constrained rigid-body means only.
#[test]
fn a_raceway_moves_as_on_the_whole_mesh() {
    let (sector, _) = toothed_sector(TEETH, 1.0, SMALL);
    let whole = PlaneModel::new(toothed_ring(TEETH, SMALL), STEEL, Plane::Strain);
    let ring = Ring::plane(&sector, RACEWAY, TEETH, &PLANE_POINTS).unwrap();
    let means = plane_means(&whole, RACEWAY, TEETH, TEETH);
    assert_eq!(means.constrained, 3);
    let equations = Assembled::plane(&whole);
    let constrained: Vec<SparseVector> = means.forms[..means.constrained].to_vec();
    let direct = Direct::new(&equations, &whole.rigid_body_modes(), &constrained);
    let interface = ring.coupling.interface.as_ref().unwrap();
    let raceway = interface.raceway.unwrap();
    let size = equations.stiffness.nrows();
    let coefficients = means.raceway.as_ref().unwrap().coefficients();
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
    let close = |found: f64, expected: f64| assert!((found - expected).abs() < 1e-12 * expected.abs().max(1.0));
    close(mean(0), 1.0);
    close(mean(1), zeta);
    close(mean(2), 1.5 * (zeta * zeta + half * half / 3.0) - 0.5);
    close(mean(3), 2.5 * (zeta.powi(3) + zeta * half * half) - 1.5 * zeta);
    close(slope(0), 0.0);
    close(slope(1), 50.0);
    close(slope(2), 150.0 * zeta);
}
