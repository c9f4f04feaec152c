//! The results hardly depend on the matching depth of near and far field in three dimensions: by
//! the same bounds as in the plane.

use super::pair::{AT_HIGHEST, AT_LOWEST, PLAIN, Values};
use calyx_runtime::scene::StructureOptions;

/// From near one end of the path of contact to near the other, degrees.
const ROLLS: [f64; 6] = [7.2, 11.0, AT_LOWEST, 20.0, AT_HIGHEST, 30.0];

fn largest(values: &[Values], value: impl Fn(&Values) -> f64) -> f64 {
    values.iter().map(value).fold(0.0, f64::max)
}

#[test]
#[ignore = "takes half a minute: .ci/full runs it"]
fn matching_depth_hardly_matters_in_solid_models() {
    let at = |matching_depth: f64| {
        PLAIN.solve("medium", StructureOptions { matching_depth, ..StructureOptions::default() }, &ROLLS)
    };
    let usual = at(1.0);
    for depth in [0.7, 1.4] {
        let found = at(depth);
        let near = |what: &str, found: f64, usual: f64, tolerance: f64| {
            let error = found / usual - 1.0;
            assert!(error.abs() < tolerance, "depth times {depth}: {what} {found} for {usual}, {error:+.1e}");
        };
        for ((roll, found), usual) in ROLLS.iter().zip(&found).zip(&usual) {
            let what = format!("transmission error at roll {roll}");
            near(&what, found.transmission_error, usual.transmission_error, 5e-3);
        }
        for member in 0..2 {
            let stress = |values: &[Values]| largest(values, |values| values.root_stress[member]);
            near("root stress", stress(&found), stress(&usual), 2e-3);
        }
        let pressure = |values: &[Values]| largest(values, |values| values.contact_pressure);
        near("pressure", pressure(&found), pressure(&usual), 5e-3);
    }
}
