//! Radiated sound in the display of a plan: the links from the teeth to the fluid, each with its
//! fidelity.

use crate::shown::{grouped, rounded};
use calyx_gears::host::ModelHost;
use calyx_runtime::acoustics::SoundMethod;
use calyx_runtime::cost::{SoundSize, sound_size};
use calyx_runtime::plan::Plan;
use std::f64::consts::TAU;

/// Returns the links of all requested sounds, as lines.
pub(crate) fn lines(host: &ModelHost, plan: &Plan) -> Vec<String> {
    let Some(response) = &host.scene.forced_response else { return Vec::new() };
    let highest = host.asked.map_or(0.0, |asked| asked.highest_frequency);
    let link = |size: &SoundSize| {
        let rpm = |speed: f64| rounded((speed * 60.0 / TAU * 1e6).round() / 1e6);
        let [lowest, fastest] = response.speeds.map(rpm);
        let last = match size.method {
            SoundMethod::EquivalentPower => {
                "equivalent radiated power (\"erp\"), without equations".to_owned()
            }
            SoundMethod::Rayleigh => {
                format!("Rayleigh integral (\"rayleigh\") at about {} frequencies", size.frequencies)
            }
            SoundMethod::BoundaryElements => {
                format!("boundary elements (\"boundary_elements\") at about {} frequencies", size.frequencies)
            }
        };
        [
            format!("\"{}\"", size.body),
            format!(
                "  transmission error and mesh force: static equilibria at the fidelity \"{}\"",
                plan.fidelity.name()
            ),
            format!(
                "  bearing forces: harmonic balance with {} harmonics of each mesh frequency, {} speeds from {lowest} to {fastest} rpm",
                response.harmonics, response.count
            ),
            format!("  velocity of the walls: component modes up to {} Hz", rounded(highest)),
            format!(
                "  sound: {last}, {} triangles on {} cm2",
                grouped(size.triangles),
                rounded((size.area * 1e5).round() / 10.0)
            ),
        ]
    };
    sound_size(&host.scene, plan.fidelity, highest).iter().flat_map(link).collect()
}
