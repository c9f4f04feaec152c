//! Sector meshes over the whole range of tooth shapes: valid elements (the builder rejects folds),
//! conforming cuts, chains on the exact profiles, and the correct area.

use crate::common::{INCH, chapter_5, chapter_5_data, standard_data};
use calyx_gears::external::{ExternalGear, ExternalGearData};
use calyx_gears::fillet::Side;
use calyx_gears::flank::Flank;
use calyx_gears::rack::Rack;
use calyx_gears::sector_mesh::{Refinement, THINNEST_RIM, sector_mesh};
use calyx_runtime::fe::{ElementPoint, PlaneMesh};
use calyx_runtime::profile::Profile;
use std::sync::Arc;

fn flanks(gear: &ExternalGear) -> [Arc<Flank>; 2] {
    [Side::CounterClockwise, Side::Clockwise]
        .map(|side| Arc::new(Flank::new(gear, &[], side).expect("a flank")))
}

/// Smallest ratio of an element's least Jacobian determinant to its mean, over all elements.
fn worst_distortion(mesh: &PlaneMesh) -> f64 {
    let points = [-1.0, -0.6, 0.0, 0.6, 1.0];
    let mut worst = 1.0_f64;
    for element in 0..mesh.elements.len() {
        let mut values = Vec::new();
        for xi in points {
            for eta in points {
                let [[a, b], [c, d]] = mesh.jacobian(ElementPoint { element, xi, eta });
                values.push(a * d - b * c);
            }
        }
        let mean = values.iter().sum::<f64>() / values.len() as f64;
        worst = values.iter().fold(worst, |worst, value| worst.min(value / mean));
    }
    worst
}

/// Checks a gear's mesh with its own tip edge and with a nearly sharp one.
fn check(name: &str, gear: &ExternalGear, rim: f64, refinement: &Refinement) {
    let bore = gear.root_radius - rim;
    let sharp = gear.tip_edge_radius.min(5e-3 * gear.rack.module);
    for tip_edge_radius in [gear.tip_edge_radius, sharp] {
        let edged = ExternalGear::new(ExternalGearData {
            teeth: gear.teeth,
            rack: gear.rack,
            tooth_thickness: gear.tooth_thickness,
            outer_radius: gear.outer_radius,
            root_radius: gear.root_radius,
            tip_edge_radius: Some(tip_edge_radius),
        })
        .expect("a valid gear");
        let mesh = sector_mesh(&gear.clone().into(), flanks(&edged), bore, refinement)
            .unwrap_or_else(|error| panic!("{name}, rim {} modules: {error}", rim / gear.rack.module));
        let worst = worst_distortion(&mesh);
        // The Jacobian determinant of an element nowhere falls below a fifth of its mean.
        assert!(worst > 0.2, "{name}, rim {} modules: distortion {worst}", rim / gear.rack.module);
    }
}

#[test]
fn every_gear_of_the_examples_ranges_is_meshed() {
    for teeth in [20, 40] {
        for tip_radius in [0.005, 0.02, 0.045] {
            for thickness in [0.086, 0.1, 0.16] {
                let gear = match ExternalGear::new(chapter_5_data(teeth, tip_radius, thickness)) {
                    Ok(gear) => gear,
                    Err(errors) => panic!("{errors:?}"),
                };
                let name = format!("{teeth} teeth, tip radius {tip_radius}, thickness {thickness}");
                for (rim, refinement) in [(0.03, Refinement::COARSE), (0.6, Refinement::MEDIUM)] {
                    check(&name, &gear, rim * INCH, &refinement);
                }
            }
        }
    }
}

#[test]
fn small_large_shifted_and_undercut_gears_are_meshed() {
    for (teeth, shift, tip_radius) in [
        (8, 0.5, 0.3),
        (9, 0.0, 0.3),
        (12, 0.3, 0.2),
        (14, 0.0, 0.25),
        (17, 0.35, 0.38),
        (30, 0.5, 0.3),
        (80, 0.0, 0.3),
        (300, -0.3, 0.3),
        (2000, 0.0, 0.38),
    ] {
        let gear = ExternalGear::new(standard_data(teeth, shift, tip_radius)).expect("a valid gear");
        let module = gear.rack.module;
        let (coarse, medium) = (Refinement::COARSE, Refinement::MEDIUM);
        for (rim, refinement) in [(THINNEST_RIM, coarse), (3.0, medium), (100.0, coarse)] {
            if rim * module < 0.95 * gear.root_radius {
                let name = format!("{teeth} teeth, shift {shift}, tip radius {tip_radius}");
                check(&name, &gear, rim * module, &refinement);
            }
        }
    }
    for tip_edge_radius in [0.01, 0.1, 0.2] {
        let data = standard_data(25, 0.0, 0.3);
        let tip_edge_radius = Some(tip_edge_radius * data.rack.module);
        let gear = ExternalGear::new(ExternalGearData { tip_edge_radius, ..data }).expect("a valid gear");
        check("rounded tips", &gear, 2.0 * gear.rack.module, &Refinement::COARSE);
    }
    // The shifted pair of the reference geometry, in metres.
    let rack = Rack::new(3e-3, 20.0_f64.to_radians(), 1.14e-3).expect("a rack");
    for (teeth, thickness, outer, root) in
        [(17, 5.47672647234371e-3, 29.55e-3, 22.8e-3), (42, 4.49400683982497e-3, 65.7e-3, 58.95e-3)]
    {
        let gear = ExternalGear::new(ExternalGearData {
            teeth,
            rack,
            tooth_thickness: thickness,
            outer_radius: outer,
            root_radius: root,
            tip_edge_radius: None,
        })
        .expect("a valid gear");
        for refinement in [Refinement::COARSE, Refinement::MEDIUM, Refinement::FINE] {
            check("shifted pair", &gear, 9e-3, &refinement);
        }
    }
}

#[test]
fn cuts_are_rotated_images_and_chains_lie_on_the_profiles() {
    let gear = chapter_5(20);
    let flanks = flanks(&gear);
    let mesh =
        sector_mesh(&gear.clone().into(), flanks.clone(), 0.6 * INCH, &Refinement::MEDIUM).expect("a mesh");
    let nodes = |name: &str| {
        let chain = mesh.chain(name).unwrap_or_else(|| panic!("a chain {name}"));
        mesh.chain_nodes(chain).into_iter().map(|node| mesh.nodes[node]).collect::<Vec<_>>()
    };
    // Counter-clockwise around the sector, the left cut runs inwards and the right one outwards.
    let (left, mut right) = (nodes("cut_left"), nodes("cut_right"));
    right.reverse();
    assert_eq!(left.len(), right.len());
    let (sine, cosine) = gear.pitch_angle().sin_cos();
    for ([x, y], [right_x, right_y]) in left.into_iter().zip(right) {
        let rotated = [cosine * right_x - sine * right_y, sine * right_x + cosine * right_y];
        assert!((rotated[0] - x).hypot(rotated[1] - y) < 1e-16 + 1e-14 * gear.root_radius);
    }

    for (surface, side) in [Side::CounterClockwise, Side::Clockwise].into_iter().enumerate() {
        let fillet = gear.root_fillet(side);
        let flank = flanks[surface].as_ref();
        let [edge_from, edge_to] = flank.edge_range();
        let profiles: [(&str, &dyn Profile, [f64; 2]); 3] = [
            ("flank", flank, [0.0, edge_from]),
            ("edge", flank, [edge_from, edge_to]),
            ("fillet", &fillet, [0.0, fillet.length()]),
        ];
        for (name, profile, [from, to]) in profiles {
            let name = format!("{name}_{surface}");
            let chain = mesh.chain(&name).unwrap_or_else(|| panic!("a chain {name}"));
            let [start, end] = chain.range();
            assert!((start - from).abs() < 1e-17 && (end - to).abs() < 1e-17, "{name}: {start} to {end}");
            for pair in chain.edges.windows(2) {
                assert!((pair[0].s[1] - pair[1].s[0]).abs() < 1e-17, "{name} has a gap");
            }
            for k in 0..=200 {
                let s = from + (to - from) * f64::from(k) / 200.0;
                let point = mesh.chain_point(chain, s).expect("a point of the chain");
                let exact = profile.at(s);
                let gap =
                    (point.position[0] - exact.position[0]).hypot(point.position[1] - exact.position[1]);
                // Cubic interpolation of a curved edge; the error is largest near the base circle,
                // where the involute has a cusp.
                assert!(gap < 1e-4 * gear.rack.module, "{name} at {s}: {gap}");
                let cosine = (0..2).map(|axis| point.normal[axis] * exact.normal[axis]).sum::<f64>();
                assert!(cosine > 0.9999, "{name} at {s}: cosine {cosine} between the normals");
            }
        }
    }
}
