//! Natural frequencies: closed forms, repeated ones, free bodies, Sturm counts.

use crate::meshes::{assert_close, beam, block, chain, circular, clamped, steel};
use calyx_elastic::assembly::System;
use calyx_elastic::model::SolidShape;
use calyx_elastic::modes::{Modes, Problem, Request, count_below, natural_modes};
use calyx_elastic::{ElasticModel, Element, ElementKind, Resources};
use std::f64::consts::TAU;

fn modes(model: &ElasticModel, is_free: bool, request: Request) -> Modes {
    let resources = Resources::default();
    let system = System::new(model, &resources).expect("valid");
    let mass = system.mass(&resources).expect("valid");
    let constrained = system.constrained();
    let problem = Problem {
        stiffness: &system.stiffness,
        mass: &mass,
        positions: &system.positions,
        constrained: &constrained,
        forms: &[],
        is_free,
    };
    let found = natural_modes(&system, &mass, request, &resources).expect("converges");
    // The Sturm count just above each mode, outside of clusters, equals its number.
    for (k, pair) in found.eigenvalues.windows(2).enumerate() {
        if pair[0] > 1.0 && pair[1] - pair[0] > 1e-3 * pair[1] {
            let between = 0.5 * (pair[0] + pair[1]);
            assert_eq!(count_below(&problem, between, &resources).expect("counted"), k + 1);
        }
    }
    found
}

#[test]
fn fixed_fixed_beam_converges_to_the_closed_form() {
    // Slender enough for Euler and Bernoulli: shear and rotary inertia are below 1e-5.
    let (length, diameter) = (1.0, 1e-3);
    let section = circular(diameter);
    let rigidity = (206e9 * section.second_moment_z / (7850.0 * section.area)).sqrt();
    // cos x cosh x = 1
    let roots = [4.730_040_744_862_704, 7.853_204_624_095_838, 10.995_607_838_001_67];
    let errors = |count: usize| {
        let mut model = chain(&beam(section, [0.0, 1.0, 0.0]), length, count);
        model.fixed.extend([clamped(0), clamped(count)]);
        let found = modes(&model, false, Request::Count(6)).frequencies();
        roots
            .iter()
            .enumerate()
            .map(|(k, root)| {
                let exact = root * root * rigidity / (TAU * length * length);
                // Both planes have the same frequencies.
                assert_close(found[2 * k], found[2 * k + 1], 1e-8);
                found[2 * k] / exact - 1.0
            })
            .collect::<Vec<f64>>()
    };
    let (coarse, fine) = (errors(6), errors(12));
    for k in 0..3 {
        assert!(fine[k].abs() < 5e-4, "{fine:?}");
        assert!(coarse[k] / fine[k] > 10.0, "order below 3.3: {coarse:?} {fine:?}");
    }
}

#[test]
fn stepped_rotor_at_rest() {
    let data: serde_json::Value = serde_json::from_str(include_str!("data/shaft.json")).expect("valid");
    let number = |value: &serde_json::Value| value.as_f64().expect("a number");
    let stations: Vec<f64> = data["x"].as_array().expect("a list").iter().map(number).collect();
    let (mut positions, mut at_station) = (vec![[0.0, 0.0, 0.0]], vec![0]);
    let mut model = ElasticModel { materials: vec![steel()], ..ElasticModel::default() };
    let parts = 24;
    for (k, pair) in stations.windows(2).enumerate() {
        let section = circular(number(&data["dia"][k]));
        for part in 1..=parts {
            positions.push([0.0, 0.0, pair[0] + (pair[1] - pair[0]) * part as f64 / parts as f64]);
            let last = positions.len() - 1;
            let kind = ElementKind::Beam(Box::new(beam(section, [1.0, 0.0, 0.0])));
            model.elements.push(Element {
                label: last as u64,
                kind,
                nodes: vec![last - 1, last],
                material: Some(0),
            });
        }
        at_station.push(positions.len() - 1);
    }
    model.nodes = crate::meshes::nodes(&positions);
    let mut add = |kind, node: usize| {
        model.elements.push(Element { label: 1000, kind, nodes: vec![at_station[node]], material: None });
    };
    for (station, disc) in data["discs"].as_object().expect("discs") {
        let [mass, across, polar] = ["m", "Id", "Ip"].map(|name| number(&disc[name]));
        let inertia = [[across, 0.0, 0.0], [0.0, across, 0.0], [0.0, 0.0, polar]];
        add(ElementKind::Mass { mass, offset: [0.0; 3], inertia }, station.parse().expect("a station"));
    }
    for (node, stiffness) in [(1, 5e7), (7, 8e7)] {
        for component in 0..2 {
            add(ElementKind::Spring { components: [component; 2], stiffness }, node);
        }
    }
    // Only bending: no axial motion and no rotation about the axis.
    for node in 0..model.nodes.len() {
        let components = [false, false, true, false, false, true];
        model.fixed.push(calyx_elastic::FixedComponents { node, components, value: 0.0 });
    }
    let found = modes(&model, false, Request::Count(10));
    for (k, expected) in data["whirl_at_rest"].as_array().expect("a list").iter().take(5).enumerate() {
        for mode in [2 * k, 2 * k + 1] {
            assert_close(found.eigenvalues[mode].sqrt(), number(expected), 3e-6);
        }
    }
}

#[test]
fn free_body_has_six_rigid_body_modes_and_none_is_missed() {
    // A cube has modes of multiplicity two and three.
    let model = block(SolidShape::Hexahedron20, [2, 2, 2], |at| at.map(|x| 0.05 * x));
    let by_count = modes(&model, true, Request::Count(20));
    let frequencies = by_count.frequencies();
    assert!(frequencies[..6].iter().all(|&f| f < 1e-3 * frequencies[6]), "{frequencies:?}");
    assert_close(frequencies[6], frequencies[7], 1e-8);
    let limit = 0.5 * (frequencies[16] + frequencies[19]) + 1.0;
    let below = modes(&model, true, Request::Below(limit)).frequencies();
    assert_eq!(below.len(), frequencies.iter().filter(|&&f| f < limit).count());
    for (one, other) in below.iter().zip(&frequencies).skip(6) {
        assert_close(*one, *other, 1e-8);
    }
}

#[test]
fn repeated_modes_of_equal_parts_are_all_found() {
    // Ten equal cantilevers: each frequency has multiplicity twenty, more than a block.
    let mut model = ElasticModel { materials: vec![steel()], ..ElasticModel::default() };
    let mut positions = Vec::new();
    for k in 0..10 {
        for at in 0..3 {
            positions.push([0.1 * at as f64, 0.3 * k as f64, 0.0]);
        }
        for at in 0..2 {
            let kind = ElementKind::Beam(Box::new(beam(circular(0.01), [0.0, 1.0, 0.0])));
            let nodes = vec![3 * k + at, 3 * k + at + 1];
            model.elements.push(Element { label: (2 * k + at) as u64, kind, nodes, material: Some(0) });
        }
        model.fixed.push(clamped(3 * k));
    }
    model.nodes = crate::meshes::nodes(&positions);
    let found = modes(&model, false, Request::Count(25)).frequencies();
    for pair in found[..20].windows(2) {
        assert_close(pair[0], pair[1], 1e-7);
    }
    assert!(found[20] > 2.0 * found[19], "{found:?}");
}
