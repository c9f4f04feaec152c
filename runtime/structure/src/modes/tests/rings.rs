//! Tests with plain rings.

use super::{Annulus, sector_of};
use crate::modes::cyclic::ring_modes;
use calyx_fe::material::{Material, Plane};
use calyx_numerics::interrupt::Interrupt;

const STEEL: Material = Material { youngs_modulus: 2.10e11, poissons_ratio: 0.3, density: 7850.0 };

/// Returns the frequency by equation 4.1 of the report: in-plane inextensional bending of a thin
/// ring with `n` nodal diameters.
fn thin_ring(n: u32, bending: f64, mass: f64, radius: f64) -> f64 {
    let n = f64::from(n);
    n * (n * n - 1.0) / (n * n + 1.0).sqrt() * (bending / (mass * radius.powi(4))).sqrt()
}

/// Returns a ring of rectangular section in plane stress, from its mean radius and its radial
/// thickness.
fn ring(thickness: f64, radius: f64) -> Annulus {
    Annulus {
        radii: [radius - 0.5 * thickness, radius + 0.5 * thickness],
        sectors: 20,
        elements: [1, 2],
        order: 3,
        material: STEEL,
        plane: Plane::Stress,
        turned: 0.0,
    }
}

/// Returns the frequencies of two to six nodal diameters of a free ring, without the rigid-body
/// motions.
fn bending(ring: Annulus, highest: f64) -> Vec<f64> {
    let all = ring.frequencies(false, highest);
    assert!(all[..3].iter().all(|&omega| omega < 1e-3 * all[3]), "{:?}", &all[..4]);
    assert!(all[3] > 0.0);
    all[3..]
        .chunks(2)
        .map(|pair| {
            assert!((pair[1] / pair[0] - 1.0).abs() < 1e-9, "a pair of one frequency: {pair:?}");
            pair[0]
        })
        .collect()
}

#[test]
fn a_thin_free_ring_bends_as_theory_has_it() {
    let (thickness, radius) = (0.02_f64, 1.0);
    let (stiffness, mass) = (STEEL.youngs_modulus * thickness.powi(3) / 12.0, STEEL.density * thickness);
    let theory = |n| thin_ring(n, stiffness, mass, radius);
    let found = bending(ring(thickness, radius), 1.05 * theory(6));
    assert_eq!(found.len(), 5);
    for (n, omega) in (2..).zip(found) {
        let error = omega / theory(n) - 1.0;
        assert!(error.abs() < 0.003 && error < 0.0, "{n} waves: {error:.5}");
    }
}

/// Table 4.4 gives the bending stiffness of the section and its mass; for steel they are those of a
/// rectangle of this thickness.
#[test]
fn the_ring_of_the_report_lies_below_the_formula_for_thin_rings() {
    let (inertia, mass, radius) = (1.21e-9, 1.8926, 0.17088_f64);
    let thickness = (12.0 * inertia * STEEL.density / mass).sqrt();
    let theory = |n| thin_ring(n, STEEL.youngs_modulus * inertia, mass, radius);
    let found = bending(ring(thickness, radius), 1.05 * theory(6));
    for ((n, omega), below) in (2..).zip(found).zip([0.10, 0.26, 0.50, 0.80, 1.16]) {
        let measured = 100.0 * (1.0 - omega / theory(n));
        assert!((measured - below).abs() < 0.05, "{n} waves: {measured:.3} % below, {below} expected");
    }
}

#[test]
fn a_free_body_has_three_rigid_motions() {
    for (sectors, turned) in [(1, 0.3), (2, 0.0), (3, 0.1), (8, 0.0)] {
        let ring = Annulus { sectors, elements: [1, 24 / sectors as usize], turned, ..ring(0.2, 1.0) };
        let all = ring.frequencies(false, 4000.0);
        let rigid = all.iter().filter(|&&omega| omega < 1.0).count();
        assert_eq!(rigid, 3, "{sectors} sectors: {all:?}");
        assert!(all.len() > 5, "{all:?}");
    }
}

#[test]
fn a_sector_is_of_any_size() {
    // Any number of sectors makes the same ring.
    let of = |sectors: u32| Annulus { sectors, elements: [1, 24 / sectors as usize], ..ring(0.2, 1.0) };
    let one = of(1).frequencies(true, 60_000.0);
    assert!(one.len() > 10);
    for sectors in [2, 3, 4, 6, 12, 24] {
        let other = of(sectors).frequencies(true, 60_000.0);
        assert_eq!(one.len(), other.len(), "{sectors} sectors");
        for (a, b) in one.iter().zip(&other) {
            assert!((a / b - 1.0).abs() < 1e-9, "{sectors} sectors: {a} {b}");
        }
    }
}

#[test]
fn units_and_turns_change_nothing() {
    let plain = ring(0.2, 1.0);
    let frequencies = plain.frequencies(true, 60_000.0);
    assert!(frequencies.len() > 10);
    let turned = Annulus { turned: 1.234, ..plain }.frequencies(true, 60_000.0);
    // Lengths in millimetres, masses in tonnes: stresses in megapascals.
    let small =
        Material { youngs_modulus: 1e-6 * STEEL.youngs_modulus, density: 1e-12 * STEEL.density, ..STEEL };
    let small = Annulus { radii: plain.radii.map(|radius| 1e3 * radius), material: small, ..plain };
    let small = small.frequencies(true, 60_000.0);
    assert_eq!([turned.len(), small.len()], [frequencies.len(); 2]);
    for (k, omega) in frequencies.iter().enumerate() {
        assert!((turned[k] / omega - 1.0).abs() < 1e-9);
        assert!((small[k] / omega - 1.0).abs() < 1e-9);
    }
}

#[test]
fn the_same_bits_at_any_number_of_threads() {
    let sector = sector_of(&ring(0.2, 1.0).sector(), 20, true);
    let modes = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let found = pool.install(|| ring_modes(&sector, 60_000.0, &Interrupt::never())).unwrap();
        found.into_iter().map(|modes| (modes.squares, modes.fields.parts)).collect::<Vec<_>>()
    };
    assert!(modes(1) == modes(3));
}

/// Plane strain, clamped at half of its outer radius of 1 m: roots of the determinant of the exact
/// solution in Bessel functions (potentials `J_n, Y_n` of `k_l r` and `k_t r`; clamped inside, free
/// outside), computed to 25 digits for each number of nodal diameters.
const CLAMPED: [(u32, &[f64]); 5] = [
    (0, &[6329.240670147, 19599.21006923]),
    (1, &[8440.204237568, 19265.67321643]),
    (2, &[12296.5077772, 19443.76168905]),
    (3, &[15294.48184567]),
    (4, &[17437.22927044]),
];

#[test]
fn a_clamped_ring_is_that_of_the_exact_solution() {
    let exact = |highest: f64| {
        let all = CLAMPED.iter().flat_map(|&(n, roots)| {
            roots.iter().flat_map(move |&root| vec![root; if n > 0 { 2 } else { 1 }])
        });
        let mut all: Vec<f64> = all.filter(|&root| root < highest).collect();
        all.sort_by(f64::total_cmp);
        all
    };
    let highest = 17_500.0;
    let exact = exact(highest);
    let error = |order: u8, elements: usize| {
        let ring = Annulus {
            radii: [0.5, 1.0],
            sectors: 12,
            elements: [2 * elements, elements],
            order,
            material: STEEL,
            plane: Plane::Strain,
            turned: 0.0,
        };
        let found = ring.frequencies(true, highest);
        assert_eq!(found.len(), exact.len(), "{found:?}");
        let errors = found.iter().zip(&exact).map(|(found, exact)| found / exact - 1.0);
        errors.fold(0.0_f64, |worst, error| worst.max(error.abs()))
    };
    // Frequencies converge with twice the order of the displacements.
    for (order, elements) in [(1, 8), (2, 2), (3, 2)] {
        let [coarse, fine] = [elements, 2 * elements].map(|elements| error(order, elements));
        let rate = (coarse / fine).log2();
        assert!(
            (rate - 2.0 * f64::from(order)).abs() < 0.3,
            "order {order}: {coarse:.1e} {fine:.1e}, rate {rate:.2}"
        );
        assert!(fine < 2e-3);
    }
    assert!(error(3, 8) < 1e-8);
}
