//! Displacement of a roller on a half-space in the series of a raceway, against quadrature of
//! Boussinesq's solution.

use calyx_model::bearing::half_space_share;
use calyx_rolling::bearing::Row;
use calyx_rolling::{Material, Profile, RollerGeometry, RollerKind, RollerRow};
use calyx_structure::Raceway;
use std::f64::consts::PI;

const LENGTH: f64 = 0.018;
const RADIUS: f64 = 0.025;
const HARMONICS: u16 = 12;

/// Sums over cells of a roller whose load is uniform (`linear` false) or linear along its length:
/// weighted mean of `1 / r` between all cells at a distance around the raceway.
fn mean(x: f64, linear: bool) -> f64 {
    const CELLS: usize = 240;
    let step = LENGTH / CELLS as f64;
    let at = |k: usize| (k as f64 + 0.5) * step - 0.5 * LENGTH;
    let weight = |z: f64| if linear { 12.0 * z / LENGTH.powi(3) } else { 1.0 / LENGTH };
    let mut sum = 0.0;
    for one in 0..CELLS {
        for other in 0..CELLS {
            // Exact along the other cell.
            let apart = at(other) - at(one);
            let inverse = (((apart + 0.5 * step) / x).asinh() - ((apart - 0.5 * step) / x).asinh()) / step;
            sum += weight(at(one)) * weight(at(other)) * inverse * step * step;
        }
    }
    sum
}

#[test]
fn the_half_space_share_is_that_of_quadrature() {
    let row = Row::new(
        RollerRow::new(RollerGeometry {
            kind: RollerKind::Cylindrical { clearance: 0.0 },
            count: 20,
            roller_diameter: 4e-3,
            length: LENGTH,
            pitch_diameter: 2.0 * RADIUS - 4e-3,
            profile: Profile::Logarithmic,
            laminae: 21,
            rings: Material::STEEL,
            rollers: Material::STEEL,
            raceway_widths: [None; 2],
        })
        .expect("sound rollers"),
    );
    let raceway = Raceway { radius: RADIUS, ends: [-0.01, 0.01], harmonics: HARMONICS, degree: 1 };
    let found = half_space_share(&row, &raceway);
    let modulus = Material::STEEL.youngs_modulus / (1.0 - Material::STEEL.poissons_ratio.powi(2));
    for (linear, found) in [false, true].into_iter().zip(found) {
        // Cells in the cube root of the angle: the displacement is logarithmic at the roller.
        const CELLS: usize = 300;
        let sum: f64 = (0..CELLS)
            .map(|k| {
                let s = (k as f64 + 0.5) / CELLS as f64;
                let (angle, slope) = (PI * s.powi(3), 3.0 * PI * s * s / CELLS as f64);
                let dirichlet =
                    1.0 + 2.0 * (1..=HARMONICS).map(|k| (f64::from(k) * angle).cos()).sum::<f64>();
                dirichlet * mean(RADIUS * angle, linear) * slope
            })
            .sum();
        let expected = sum / PI / (PI * modulus);
        assert!((found / expected - 1.0).abs() < 2e-3, "{linear}: {found:e} {expected:e}");
    }
}
