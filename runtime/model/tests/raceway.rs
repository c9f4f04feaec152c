//! Displacement of a roller on a half-space in the series of a raceway, against quadrature of
//! Boussinesq's solution.

use calyx_model::bearing::{Ring, half_space_share};
use calyx_rolling::bearing::Row;
use calyx_rolling::{Material, Profile, RollerGeometry, RollerKind, RollerRow};
use calyx_structure::Raceway;
use std::f64::consts::PI;

const LENGTH: f64 = 0.018;
const RADIUS: f64 = 0.025;
const HARMONICS: u16 = 12;

/// Axial coordinate of the middle of the roller in the raceway.
const MIDDLE: f64 = 5e-4;
const WIDTH: f64 = 0.02;

/// Mean of `1 / r` at a distance around the raceway between all cells over a width, which have
/// these weights per length.
fn mean(x: f64, width: f64, weights: [&dyn Fn(f64) -> f64; 2]) -> f64 {
    const CELLS: usize = 240;
    let step = width / CELLS as f64;
    let at = |k: usize| (k as f64 + 0.5) * step - 0.5 * width;
    let mut sum = 0.0;
    for one in 0..CELLS {
        for other in 0..CELLS {
            // Exact along the other cell.
            let apart = at(other) - at(one);
            let inverse = (((apart + 0.5 * step) / x).asinh() - ((apart - 0.5 * step) / x).asinh()) / step;
            sum += weights[0](at(one)) * weights[1](at(other)) * inverse * step * step;
        }
    }
    sum
}

fn share(width: f64, weights: [&dyn Fn(f64) -> f64; 2]) -> f64 {
    // Cells in the cube root of the angle: the displacement is logarithmic at the roller.
    const CELLS: usize = 300;
    let modulus = Material::STEEL.youngs_modulus / (1.0 - Material::STEEL.poissons_ratio.powi(2));
    let of_cell = |k: usize| {
        let s = (k as f64 + 0.5) / CELLS as f64;
        let (angle, slope) = (PI * s.powi(3), 3.0 * PI * s * s / CELLS as f64);
        let dirichlet = 1.0 + 2.0 * (1..=HARMONICS).map(|k| (f64::from(k) * angle).cos()).sum::<f64>();
        dirichlet * mean(RADIUS * angle, width, weights) * slope
    };
    (0..CELLS).map(of_cell).sum::<f64>() / PI / (PI * modulus)
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
    // The whole roller, and the distributions that linear polynomials over the raceway have.
    let uniform = |_: f64| 1.0 / LENGTH;
    let linear = |z: f64| 12.0 * z / LENGTH.powi(3);
    let of_force = |z: f64| (1.0 + 12.0 * MIDDLE * z / (WIDTH * WIDTH)) / WIDTH;
    let of_moment = |z: f64| 12.0 * z / WIDTH.powi(3);
    type Weights<'a> = [&'a dyn Fn(f64) -> f64; 2];
    let cases: [(f64, f64, Weights<'_>); 2] =
        [(0.0, LENGTH, [&uniform, &linear]), (WIDTH, WIDTH, [&of_force, &of_moment])];
    for (raceway_width, width, weights) in cases {
        let ends = [-0.5 * raceway_width, 0.5 * raceway_width];
        let raceway = Raceway { radius: RADIUS, ends, harmonics: HARMONICS, degree: 1 };
        let steel = Material::STEEL.youngs_modulus / (1.0 - Material::STEEL.poissons_ratio.powi(2));
        let found = half_space_share((&row, Ring::Outer), (&raceway, steel), MIDDLE);
        for i in 0..2 {
            for j in 0..2 {
                let expected = share(width, [weights[i], weights[j]]);
                let scale = (found[i][i] * found[j][j]).sqrt();
                let difference = (found[i][j] - expected).abs();
                assert!(difference < 2e-3 * scale, "{width} {i} {j}: {:e} {expected:e}", found[i][j]);
            }
        }
    }
}
