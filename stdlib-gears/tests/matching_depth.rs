//! Independence of the discretization: the matching depth of near and far field, the refinement of
//! the mesh, the order of its elements. Contact pressure near the tips is most sensitive to a wrong
//! split of the fields.

use crate::common::pair::{Member, PLAIN, PairOptions, Values, pair, steel};
use crate::common::{INCH, built, chapter_5_data, resources};
use calyx_gears::blank::Rim;
use calyx_gears::external::ExternalGear;
use calyx_gears::prototype::GearPrototype;
use calyx_runtime::analysis::mesh_cycle;
use calyx_runtime::contact::pressure::{hertz_half_width, peak};
use calyx_runtime::interrupt::Interrupt;
use calyx_runtime::plan::Plan;
use calyx_runtime::scene::{Fidelity, Prototype, StructureOptions};
use calyx_runtime::structure::BoreSupport;
use calyx_runtime::system::System;
use std::f64::consts::PI;

fn with(change: impl Fn(&mut StructureOptions)) -> StructureOptions {
    let mut options = StructureOptions::default();
    change(&mut options);
    options
}

/// Largest values over the cycle, and the mean of the transmission error.
struct Summary {
    mean_error: f64,
    root_stress: [f64; 2],
    pressure: f64,
}

impl Summary {
    fn of(gears: &[Member; 2], structure: StructureOptions) -> Self {
        let (scene, mesh) = pair(&PairOptions::chapter_5(gears));
        let system = built(&scene, Fidelity::Plane, structure);
        let values: Vec<Values> = mesh_cycle(&mesh, 16)
            .iter()
            .map(|position| {
                let step = system.solve(position.time).expect("it is in equilibrium");
                Values::of(&system, &step)
            })
            .collect();
        let largest = |value: &dyn Fn(&Values) -> f64| values.iter().map(value).fold(0.0, f64::max);
        Self {
            mean_error: values.iter().map(|v| v.transmission_error).sum::<f64>() / values.len() as f64,
            root_stress: [0, 1].map(|body| largest(&|v| v.root_stress[body])),
            pressure: largest(&|v| v.contact_pressure),
        }
    }
}

fn change(value: f64, reference: f64) -> f64 {
    (value / reference - 1.0).abs()
}

#[test]
fn matching_depth_hardly_matters() {
    let reference = Summary::of(&PLAIN, StructureOptions::default());
    for depth in [0.7, 1.4] {
        let other = Summary::of(&PLAIN, with(|options| options.matching_depth = depth));
        let error = change(other.mean_error, reference.mean_error);
        assert!(error < 5e-3, "depth times {depth}: transmission error changes by {error:.1e}");
        for body in 0..2 {
            let stress = change(other.root_stress[body], reference.root_stress[body]);
            assert!(stress < 2e-3, "depth times {depth}: root stress of {body} changes by {stress:.1e}");
        }
        let pressure = change(other.pressure, reference.pressure);
        assert!(pressure < 5e-3, "depth times {depth}: pressure changes by {pressure:.1e}");
    }
}

/// Ratio of the peak pressure to that of a Hertzian contact of the same load, with the distance of
/// the contact from the nearer tip in Hertzian half-widths: for each patch at the given fractions
/// of a cycle.
fn pressures_over_hertz(edges: bool, structure: StructureOptions, cycles: &[f64]) -> Vec<[f64; 2]> {
    let (scene, mesh) = pair(&PairOptions { edges, ..PairOptions::chapter_5(&PLAIN) });
    let plan = Plan::new(&scene, Fidelity::Plane, structure).expect("it can be planned");
    let system = System::with(&scene, &plan, &resources()).expect("it can be built");
    let profiles = [0, 1].map(|body: usize| {
        let built =
            PLAIN[body].build(&plan.bodies[body].options, &Interrupt::never()).expect("it was built before");
        built.profile(scene.pairs[0].surfaces[body])
    });
    let material = steel();
    let contact_modulus =
        0.5 * material.youngs_modulus / (1.0 - material.poissons_ratio * material.poissons_ratio);
    let mut found = Vec::new();
    for cycle in cycles {
        let step = system.solve(mesh.start + cycle * mesh.period).expect("it is in equilibrium");
        for patch in step.patches.iter().filter(|patch| patch.force() > 0.0) {
            let of_cells = patch.pressures();
            let Some(largest) = peak(patch.cells(), &of_cells) else { continue };
            // Involutes touch at the middle of the grid.
            let middle = patch.cells().iter().min_by(|a, b| a.center().abs().total_cmp(&b.center().abs()));
            let s = middle.expect("a loaded patch has cells").s;
            let curvature: f64 = (0..2).map(|side| profiles[side].at(s[side]).curvature).sum();
            let half_width = hertz_half_width(patch.force(), contact_modulus, curvature);
            let hertz = 2.0 * patch.force() / (PI * half_width);
            let tip = |side: usize| profiles[side].edge_from().expect("a gear has a tip edge") - s[side];
            found.push([tip(0).min(tip(1)) / half_width, largest.pressure / hertz]);
        }
    }
    found
}

#[test]
fn pressure_is_hertzian_up_to_the_tips() {
    // Positions are densest where a pair enters and leaves.
    let mut cycles: Vec<f64> = (0..40).map(|i| (f64::from(i) + 0.37) / 40.0).collect();
    cycles.extend((1..20).map(|i| 0.003 * f64::from(i)));
    cycles.extend((1..20).map(|i| 0.5225 - 0.003 * f64::from(i)));
    for edges in [false, true] {
        let found = pressures_over_hertz(edges, StructureOptions::default(), &cycles);
        let (mut inside, mut near) = (0, 0);
        for [distance, ratio] in found {
            if distance > 2.0 {
                // The whole patch is at least a half-width away from the tip.
                assert!((ratio - 1.0).abs() < 0.01, "{distance} half-widths from a tip: {ratio}");
                inside += 1;
            } else if distance > 1.0 {
                // Closer to the tip, the tip is more compliant than the flank, so the pressure
                // moves away from it. Finer meshes agree.
                assert!((ratio - 1.0).abs() < 0.03, "{distance} half-widths from a tip: {ratio}");
                near += 1;
            }
        }
        assert!(inside > 50 && near > 2, "{inside} {near}");
    }
}

#[test]
fn results_converge_under_refinement() {
    let refined = |factor: f64| Summary::of(&PLAIN, with(|options| options.refinement = factor));
    let [coarse, default, fine] = [0.7, 1.0, 1.5].map(refined);
    let errors = [&coarse, &default].map(|mesh| change(mesh.mean_error, fine.mean_error));
    assert!(errors[0] < 3e-4 && errors[1] < 0.5 * errors[0], "transmission error: {errors:?}");
    for body in 0..2 {
        let errors = [&coarse, &default].map(|mesh| change(mesh.root_stress[body], fine.root_stress[body]));
        assert!(errors[0] < 3e-3 && errors[1] < 1.5e-3, "root stress of {body}: {errors:?}");
    }
    let pressure = change(default.pressure, fine.pressure);
    assert!(pressure < 2e-3, "pressure: {pressure}");

    // Meshes agree even where the compliance of the tip determines the contact.
    let at_tip = [1.0, 1.5].map(|factor| {
        let structure = with(|options| options.refinement = factor);
        pressures_over_hertz(false, structure, &[0.0145, 0.02, 0.03])
    });
    for (default, fine) in at_tip[0].iter().zip(&at_tip[1]) {
        assert!(default[0] > 1.0 && change(default[1], fine[1]) < 5e-3, "{default:?} {fine:?}");
    }
}

#[test]
fn lower_orders_converge_to_the_same_transmission_error() {
    let reference = Summary::of(&PLAIN, StructureOptions::default()).mean_error;
    let error = |order: usize, refinement: f64| {
        let structure = with(|options| {
            options.order = order;
            options.refinement = refinement;
        });
        change(Summary::of(&PLAIN, structure).mean_error, reference)
    };
    let (linear, finer, quadratic) = (error(1, 1.0), error(1, 1.5), error(2, 1.0));
    assert!(linear < 2e-2 && finer < 0.7 * linear, "order 1: {linear}, {finer}");
    assert!(quadratic < 2e-3, "order 2: {quadratic}");
}

#[test]
fn root_stress_is_that_of_a_fine_mesh() {
    // Largest fillet stress of pinion and gear at two positions, psi, on the default mesh refined
    // 2.5 times, by tip radius of the rack and tooth thickness in inches.
    let rows = [(0.010, 0.15708, [36749.3, 30483.4]), (0.020, 0.10, [52978.9, 36116.2])];
    for (tip_radius, thickness, expected) in rows {
        let gears = [(20, [0.7, 0.6]), (40, [1.7, 1.2])].map(|(teeth, rim)| {
            let gear = ExternalGear::new(chapter_5_data(teeth, tip_radius, thickness)).expect("a sound gear");
            let [radius, fixed_radius] = rim.map(|radius: f64| radius * INCH);
            let rim = Rim { radius, fixed_radius, web: None, support: BoreSupport::Rigid };
            Member::new(GearPrototype::new(gear, Vec::new(), steel(), rim, INCH, Vec::new()).expect("a gear"))
        });
        let (scene, mesh) = pair(&PairOptions::chapter_5(&gears));
        let system = built(&scene, Fidelity::Plane, StructureOptions::default());
        let mut largest = [0.0_f64; 2];
        for cycle in [0.95, 0.9999] {
            let step = system.solve(mesh.start + cycle * mesh.period).expect("it is in equilibrium");
            let values = Values::of(&system, &step);
            largest =
                [0, 1].map(|body| largest[body].max(values.root_stress[body] / crate::common::pair::PSI));
        }
        for body in 0..2 {
            let error = largest[body] / expected[body] - 1.0;
            assert!(error.abs() < 1.5e-3, "{tip_radius}, {thickness}, body {body}: {error:.1e}");
        }
    }
}
