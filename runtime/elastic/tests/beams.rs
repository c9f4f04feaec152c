//! Beams and rods against closed forms.

use crate::meshes::{assert_close, beam, chain, circular, clamped, load, nodes, rotated, steel};
use calyx_elastic::assembly::System;
use calyx_elastic::beam::{rod_stiffness, stiffness};
use calyx_elastic::model::{BeamProperties, BeamSection};
use calyx_elastic::{
    Constraint, ElasticModel, Element, ElementKind, FixedComponents, NodalLoad, Resources, statics,
};

/// Orientation of the beams: local y along y.
const UP: [f64; 3] = [0.0, 1.0, 0.0];
const LENGTH: f64 = 0.8;

fn solve(model: &ElasticModel, loads: Vec<NodalLoad>) -> statics::StaticSolution {
    let resources = Resources::default();
    let system = System::new(model, &resources).expect("valid");
    statics::solve(&system, &[loads], &resources).expect("supported").remove(0)
}

/// Returns an unsymmetric section.
fn section() -> BeamSection {
    BeamSection {
        area: 2e-3,
        second_moment_z: 3e-6,
        second_moment_y: 1e-6,
        product_of_inertia: 0.0,
        torsion_constant: 2e-6,
        shear_factors: [0.8, 0.5],
        added_mass: 0.0,
    }
}

#[test]
fn cantilever_with_shear() {
    let material = steel();
    let (e, g) = (material.youngs_modulus, material.shear_modulus);
    for count in [1, 3] {
        let mut model = chain(&beam(section(), UP), LENGTH, count);
        model.fixed.push(clamped(0));
        let end = solve(&model, vec![load(count, [5e3, 7e2, -3e2, 40.0, 50.0, 60.0])]).displacements[count];
        let s = section();
        let (l, iz, iy) = (LENGTH, s.second_moment_z, s.second_moment_y);
        let expected = [
            5e3 * l / (e * s.area),
            7e2 * l.powi(3) / (3.0 * e * iz) + 7e2 * l / (g * s.area * 0.8) + 60.0 * l * l / (2.0 * e * iz),
            -3e2 * l.powi(3) / (3.0 * e * iy) - 3e2 * l / (g * s.area * 0.5) - 50.0 * l * l / (2.0 * e * iy),
            40.0 * l / (g * s.torsion_constant),
            3e2 * l * l / (2.0 * e * iy) + 50.0 * l / (e * iy),
            7e2 * l * l / (2.0 * e * iz) + 60.0 * l / (e * iz),
        ];
        for component in 0..6 {
            assert_close(end[component], expected[component], 1e-9);
        }
    }
}

#[test]
fn tapered_cantilever_by_quadrature_of_its_flexibility() {
    // I(x) = I0 (1 + c x / L), A(x) = A0 (1 + a x / L), both smaller at the end.
    let (mut first, mut second) = (section(), section());
    first.shear_factors = [f64::INFINITY; 2];
    second.shear_factors = [f64::INFINITY; 2];
    let (c, a) = (-0.85_f64, -0.6_f64);
    second.second_moment_z *= 1.0 + c;
    second.torsion_constant *= 1.0 + c;
    second.area *= 1.0 + a;
    let properties = BeamProperties { sections: [first, second], ..beam(section(), UP) };
    let mut model = chain(&properties, LENGTH, 1);
    model.fixed.push(clamped(0));
    let end = solve(&model, vec![load(1, [1e3, 1e3, 0.0, 30.0, 0.0, 0.0])]).displacements[1];
    let (e, g, l) = (206e9, 206e9 / 2.6, LENGTH);
    assert_close(end[0], 1e3 * l / (e * first.area) * (1.0 + a).ln() / a, 1e-9);
    assert_close(end[3], 30.0 * l / (g * first.torsion_constant) * (1.0 + c).ln() / c, 1e-9);
    // Integral of (1 - t)^2 / (1 + c t): with s = 1 + c t, ((1 + c) - s)^2 / (c^3 s).
    let b = 1.0 + c;
    let integral = (b * b * b.ln() - 2.0 * b * (b - 1.0) + 0.5 * (b * b - 1.0)) / c.powi(3);
    assert_close(end[1], 1e3 * l.powi(3) / (e * first.second_moment_z) * integral, 1e-9);
    // A series of uniform beams converges to the tapered one.
    let deflection = |count: usize| {
        let mut model = chain(&properties, LENGTH, count);
        for (k, element) in model.elements.iter_mut().enumerate() {
            let at = (k as f64 + 0.5) / count as f64;
            let mut uniform = first;
            uniform.area *= 1.0 + a * at;
            uniform.second_moment_z *= 1.0 + c * at;
            uniform.torsion_constant *= 1.0 + c * at;
            element.kind = ElementKind::Beam(Box::new(beam(uniform, UP)));
        }
        model.fixed.push(clamped(0));
        solve(&model, vec![load(count, [0.0, 1e3, 0.0, 0.0, 0.0, 0.0])]).displacements[count][1]
    };
    let errors = [32, 64].map(|count| (deflection(count) - end[1]).abs());
    assert!(errors[1] < 0.3 * errors[0] && errors[1] < 1e-3 * end[1], "{errors:?}");
}

#[test]
fn product_of_inertia_is_that_of_rotated_axes() {
    // The same section in its principal axes and in axes rotated by 0.5 rad about x.
    let principal = BeamSection { shear_factors: [f64::INFINITY; 2], ..section() };
    let (iz, iy) = (principal.second_moment_z, principal.second_moment_y);
    let (sin, cos) = 0.5_f64.sin_cos();
    // Principal axes are rotated by 0.5 rad against the axes of the skew section.
    let skew = BeamSection {
        second_moment_z: iz * cos * cos + iy * sin * sin,
        second_moment_y: iz * sin * sin + iy * cos * cos,
        product_of_inertia: (iz - iy) * sin * cos,
        ..principal
    };
    let ends = [[0.0; 3], [LENGTH, 0.0, 0.0]];
    let one = stiffness(&beam(principal, [0.0, cos, sin]), &steel(), ends).expect("valid");
    let other = stiffness(&beam(skew, UP), &steel(), ends).expect("valid");
    assert!((&one - &other).amax() < 1e-12 * one.amax(), "{}", (&one - &other).amax() / one.amax());
}

#[test]
fn beams_and_rods_have_exact_rigid_body_motions() {
    let ends = [rotated([0.1, 0.2, 0.3]), rotated([0.9, 0.1, 0.5])];
    let mut properties = beam(section(), [0.0, 0.3, 1.0]);
    properties.sections[1].area *= 0.5;
    properties.offsets = [[0.01, 0.02, -0.03], [0.0, 0.05, 0.01]];
    let with_beam = stiffness(&properties, &steel(), ends).expect("valid");
    let with_rod = rod_stiffness([1e-3, 1e-6], &steel(), ends).expect("valid");
    for (matrix, zero) in [(with_beam, 6), (with_rod, 10)] {
        let mut values: Vec<f64> = matrix.clone().symmetric_eigenvalues().iter().copied().collect();
        values.sort_by(f64::total_cmp);
        let largest = values[11];
        assert!(values[zero - 1].abs() < 1e-13 * largest, "{values:?}");
        assert!(values[zero] > 1e-9 * largest, "{values:?}");
        for k in 0..6 {
            let motion = nalgebra::DVector::from_fn(12, |row, _| {
                let node = &nodes(&ends)[row / 6];
                calyx_elastic::constraint::rigid_row(node, row % 6, [0.0; 3])[k]
            });
            assert!((&matrix * motion).amax() < 1e-13 * largest);
        }
    }
}

#[test]
fn offset_equals_rigid_link() {
    let offset = [0.0, 0.04, -0.02];
    let mut direct = chain(&BeamProperties { offsets: [offset; 2], ..beam(section(), UP) }, LENGTH, 1);
    direct.fixed.push(clamped(0));
    let mut linked = chain(&beam(section(), UP), LENGTH, 1);
    let ends = [[0.0, 0.0, 0.0], [LENGTH, 0.0, 0.0]];
    let moved = ends.map(|end| [0, 1, 2].map(|axis| end[axis] + offset[axis]));
    linked.nodes = nodes(&[ends[0], ends[1], moved[0], moved[1]]);
    linked.elements[0].nodes = vec![2, 3];
    for (label, reference) in [(1, 0), (2, 1)] {
        let dependents = vec![(reference + 2, [true; 6])];
        linked.constraints.push(Constraint::Rigid { label, reference, dependents });
    }
    linked.fixed.push(clamped(0));
    let loads = vec![load(1, [1e3, 2e3, 3e3, 4.0, 5.0, 6.0])];
    let [one, other] = [direct, linked].map(|model| solve(&model, loads.clone()).displacements[1]);
    for component in 0..6 {
        assert_close(one[component], other[component], 1e-10);
    }
}

#[test]
fn released_rotation_is_a_hinge() {
    // Two cantilevers share the load on the hinge that joins their ends.
    let mut model = chain(&beam(section(), UP), 2.0 * LENGTH, 2);
    if let ElementKind::Beam(properties) = &mut model.elements[0].kind {
        properties.released[1][5] = true;
    }
    model.fixed.extend([clamped(0), clamped(2)]);
    let middle = solve(&model, vec![load(1, [0.0, 1e3, 0.0, 0.0, 0.0, 0.0])]).displacements[1];
    let s = section();
    let compliance =
        LENGTH.powi(3) / (3.0 * 206e9 * s.second_moment_z) + LENGTH / (206e9 / 2.6 * s.area * 0.8);
    assert_close(middle[1], 0.5 * 1e3 * compliance, 1e-9);
    // Torsion released at both ends is a mechanism.
    let mut properties = beam(section(), UP);
    properties.released = [[false, false, false, true, false, false]; 2];
    let error = stiffness(&properties, &steel(), [[0.0; 3], [1.0, 0.0, 0.0]]).expect_err("mechanism");
    assert!(error.message.contains("released"), "{error}");
}

/// Returns the stepped shaft of the reference data with springs in place of its bearings.
fn shaft(data: &serde_json::Value) -> ElasticModel {
    let list = |name: &str| -> Vec<f64> {
        data[name].as_array().expect("a list").iter().map(|x| x.as_f64().expect("a number")).collect()
    };
    let (x, diameters) = (list("x"), list("dia"));
    let positions: Vec<[f64; 3]> = x.iter().map(|&z| [0.0, 0.0, z]).collect();
    let mut model =
        ElasticModel { nodes: nodes(&positions), materials: vec![steel()], ..ElasticModel::default() };
    for (k, &diameter) in diameters.iter().enumerate() {
        let kind = ElementKind::Beam(Box::new(beam(circular(diameter), [1.0, 0.0, 0.0])));
        model.elements.push(Element { label: k as u64 + 1, kind, nodes: vec![k, k + 1], material: Some(0) });
    }
    for (node, stiffness) in [(1, 5e7), (7, 8e7)] {
        for component in 0..2 {
            let kind = ElementKind::Spring { components: [component; 2], stiffness };
            model.elements.push(Element { label: 100, kind, nodes: vec![node], material: None });
        }
    }
    model
}

/// Reference data of shafts.
const SHAFT: &str = include_str!("data/shaft.json");

#[test]
fn stepped_shaft_under_a_gear_load() {
    let data: serde_json::Value = serde_json::from_str(SHAFT).expect("valid");
    let mut model = shaft(&data);
    let mut fix = |node: usize, component: usize| {
        let mut components = [false; 6];
        components[component] = true;
        model.fixed.push(FixedComponents { node, components, value: 0.0 });
    };
    fix(1, 2);
    fix(8, 5);
    let (tangential, radial, axial, radius) = (4000.0, 1500.0, 900.0, 0.06);
    let force = [-radial, tangential, axial, 0.0, -radius * axial, radius * tangential];
    let solution = solve(&model, vec![load(3, force)]);
    let reference = &data["static"]["elastic_bearings"];
    for (axis, name) in ["x", "y"].into_iter().enumerate() {
        let of = &reference[name];
        for (node, found) in solution.displacements.iter().enumerate() {
            assert_close(found[axis], of["defl"][node].as_f64().expect("a number"), 1e-8);
            let slope = if axis == 0 { found[4] } else { -found[3] };
            assert!((slope - of["slope"][node].as_f64().expect("a number")).abs() < 1e-11, "{name} {node}");
        }
        for (node, position, stiffness) in [(1, "0.05", 5e7), (7, "0.56", 8e7)] {
            let reaction = -stiffness * solution.displacements[node][axis];
            assert_close(reaction, of["reaction_on_shaft"][position].as_f64().expect("a number"), 1e-9);
        }
    }
    let expected = [(1, 2, -axial), (8, 5, -radius * tangential)];
    assert_eq!(solution.reactions.len(), 2);
    for ((node, component, found), (at, of, value)) in solution.reactions.into_iter().zip(expected) {
        assert_eq!((node, component), (at, of));
        assert_close(found, value, 1e-9);
    }
}
