//! The report's chapter 5 pair compared with independent plane-strain models, with contact on the
//! nominal path only.

use crate::common::INCH;
use crate::common::pair::{Member, PLAIN, PSI, PairOptions, RELIEVED, Values, pair, system_of};
use calyx_runtime::analysis::mesh_cycle;
use calyx_runtime::scene::{GearMesh, StructureOptions};
use serde_json::Value;

/// Enough positions to resolve the peak of root stress to 0.1 %. With relief, the peak lies beyond
/// the nominal single-tooth contact.
const POSITIONS: usize = 128;

fn reference() -> Value {
    serde_json::from_str(include_str!("../data/spur_pair.json")).expect("sound data")
}

/// Values at the positions of a cycle, with the roll angle of the entering pair, degrees.
fn cycle(gears: &[Member; 2], positions: impl Fn(&GearMesh) -> Vec<f64>) -> Vec<(f64, Values)> {
    let (scene, mesh) = pair(&PairOptions::chapter_5(gears));
    let system = system_of(&scene, StructureOptions::default());
    positions(&mesh)
        .into_iter()
        .map(|time| {
            let step = system.solve(time).expect("equilibrium");
            let part = (time - mesh.start) / mesh.period;
            let roll = mesh.roll[0] + part * (mesh.roll[1] - mesh.roll[0]);
            (roll.to_degrees(), Values::of(&system, &step))
        })
        .collect()
}

#[test]
fn contact_pressure_follows_hertz_where_one_pair_carries() {
    let reference = reference();
    let rows = reference["hertz_line_single_pair_psi"].as_array().expect("rows");
    let rolls: Vec<f64> = rows.iter().map(|row| row[0].as_f64().expect("a roll angle")).collect();
    let times = |mesh: &GearMesh| {
        let rate = mesh.roll[1] - mesh.roll[0];
        rolls
            .iter()
            .map(|roll| mesh.start + (roll.to_radians() - mesh.roll[0]) / rate * mesh.period)
            .collect()
    };
    for (row, (roll, values)) in rows.iter().zip(cycle(&PLAIN, times)) {
        let expected = row[1].as_f64().expect("a pressure");
        let found = values.contact_pressure.max(values.edge_pressure) / PSI;
        assert!((found / expected - 1.0).abs() < 0.01, "roll {roll}: {found} {expected}");
    }
}

#[test]
fn fillet_stress_and_transmission_error_agree_with_independent_models() {
    let reference = reference();
    for (name, gears) in [("no_modification", &PLAIN), ("quadratic_tip_relief", &RELIEVED)] {
        let expected =
            |key: &str| reference["independent_plane_strain"][name][key].as_f64().expect("a number");
        let rows = cycle(gears, |mesh| mesh_cycle(mesh, POSITIONS).into_iter().map(|p| p.time).collect());
        let largest = |value: fn(&Values) -> f64| {
            rows.iter().map(|(_, values)| value(values)).fold(f64::NEG_INFINITY, f64::max)
        };
        let smallest_error = -largest(|v| -v.transmission_error);
        let gear_base_radius = gears[1].gear().base_radius;
        let peak_to_peak = (largest(|v| v.transmission_error) - smallest_error) * gear_base_radius / INCH;
        for (key, found, tolerance) in [
            ("max_root_stress_pinion", largest(|v| v.root_stress[0]) / PSI, 0.01),
            ("max_root_stress_gear", largest(|v| v.root_stress[1]) / PSI, 0.01),
            // Single-tooth contact only: near the ends of the path of contact, edges raise the
            // pressure.
            (
                "max_hertz_pressure",
                largest(|v| if v.load_share == 1.0 { v.contact_pressure } else { 0.0 }) / PSI,
                0.01,
            ),
            ("te_peak_to_peak_inch", peak_to_peak, 0.02),
        ] {
            let error = found / expected(key) - 1.0;
            assert!(error.abs() < tolerance, "{name}, {key}: {found} for {}, {error:+.4}", expected(key));
        }
    }
}
