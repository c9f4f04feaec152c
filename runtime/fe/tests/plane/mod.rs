//! The finite elements against what theory says of them.

mod builder;
mod convergence;
mod elements;
mod invariance;
mod loads;
mod patch;
mod recovery;

use calyx_fe::material::Material;

/// Material similar to steel; no test depends on its values.
const MATERIAL: Material = Material { youngs_modulus: 2.1e11, poissons_ratio: 0.3, density: 7800.0 };

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}
