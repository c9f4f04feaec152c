//! Swept meshes: charts, loads and stresses on them, rigid-body motions under a twist.

use crate::solid::convergence::{cylinder, solved};
use crate::solid::shapes::Kind;
use crate::solid::{GRADIENT, MATERIAL, dot, linear_field, residual, traction};
use calyx_fe::dissection::Dissection;
use calyx_fe::material::Plane;
use calyx_fe::solid::{SolidMesh, SolidModel, SurfaceStressRecovery, SweepError, coordinate_stations};
use calyx_fe::{
    Block, Curve, ElementOrder, MeshBuilder, PlaneMesh, PlaneModel, Side, StressRecovery, uniform,
};

const STATIONS: [f64; 4] = [-0.011, -0.004, 0.002, 0.011];

/// A bent block with one side a profile.
fn section(order: ElementOrder, coordinates: ElementOrder) -> PlaneMesh {
    let block = Block::new(
        Curve::line([0.030, -0.004], [0.040, -0.003]),
        Curve::arc([0.030, 0.0], (0.01_f64).hypot(0.003), -(0.3_f64).atan(), (0.3_f64).atan()),
        Curve::line([0.030, 0.004], [0.040, 0.003]),
        Curve::line([0.030, -0.004], [0.030, 0.004]),
    )
    .divided(uniform(2), uniform(3))
    .named(Side::Top, "cut_last")
    .named(Side::Bottom, "cut_first")
    .named(Side::Left, "bore")
    .on_profile(Side::Right, "flank", [0.001, 0.001 + 2.0 * (0.3_f64).atan() * (0.01_f64).hypot(0.003)]);
    let mut builder = MeshBuilder::new();
    builder.block(block);
    builder.coordinate_order(coordinates);
    builder.finish(order).expect("one sound block")
}

/// Turns with `z` as a helical gear does.
fn twisted([x, y]: [f64; 2], z: f64) -> [f64; 3] {
    let (sin, cos) = (12.0 * z).sin_cos();
    [x * cos - y * sin, x * sin + y * cos, z]
}

fn model(order: u8, coordinates: u8, axial: usize) -> SolidModel {
    let section = section(ElementOrder::full(order), ElementOrder::full(coordinates));
    SolidModel::new(SolidMesh::swept(&section, &STATIONS, axial, &twisted).expect("sound"), MATERIAL)
}

#[test]
fn constant_strain_and_rigid_motions_are_exact_under_a_twist() {
    for (order, coordinates, axial) in [(1, 1, 1), (2, 2, 2), (3, 2, 3), (3, 3, 4), (2, 1, 5)] {
        let model = model(order, coordinates, axial);
        let zero = vec![0.0; model.dof_count()];
        for mode in model.rigid_body_modes() {
            let left = residual(&model, &mode, &zero);
            assert!(left < 1e-13, "orders {order}, {coordinates}, {axial}: a rigid motion strains, {left:e}");
        }
        let field = model.mesh.nodes.iter().flat_map(|&node| linear_field(node)).collect::<Vec<_>>();
        let stress = model.stress_of(GRADIENT);
        // Tractions on all faces balance the stress: stiffness and loads integrate alike.
        let mut load = zero;
        for name in ["cut_first", "cut_last", "bore", "flank", "face_start", "face_end"] {
            let set = model.mesh.face_set(name).expect("named");
            model.face_load(set, |point| traction(stress, point.normal)).add_to(1.0, &mut load);
        }
        let left = residual(&model, &field, &load);
        assert!(left < 1e-12, "orders {order}, {coordinates}, {axial}: residual {left:e}");
    }
}

#[test]
fn recovered_surface_stress_of_constant_strain_is_exact() {
    for (order, coordinates, axial) in [(1, 1, 1), (2, 2, 2), (3, 3, 3), (3, 2, 5)] {
        let model = model(order, coordinates, axial);
        let field = model.mesh.nodes.iter().flat_map(|&node| linear_field(node)).collect::<Vec<_>>();
        let stress = model.stress_of(GRADIENT);
        let recovery = SurfaceStressRecovery::new(&model).expect("swept");
        let set = model.mesh.face_set("flank").expect("named");
        let [from, to] = set.chart.as_ref().expect("charted").s_range();
        for (s, z) in [(0.0, 0.0), (0.4, 0.3), (1.0, 1.0), (0.7, 0.5)] {
            let (s, z) = (from + s * (to - from), STATIONS[0] + z * (STATIONS[3] - STATIONS[0]));
            let found = recovery.rows(set, s, z).expect("on the chart");
            let [a, b] = found.point.tangents;
            let exact = [(a, a), (b, b), (a, b)].map(|(p, q)| dot(traction(stress, p), q));
            for (row, exact) in found.rows.iter().zip(exact) {
                let found = row.dot(&field);
                assert!(
                    (found - exact).abs() < 1e-9 * MATERIAL.youngs_modulus * 1e-3,
                    "{found} is not {exact}"
                );
            }
        }
    }
}

#[test]
fn loads_on_charts_have_the_total_and_the_moment_of_their_density() {
    let model = model(3, 3, 3);
    let set = model.mesh.face_set("flank").expect("named");
    let [from, to] = set.chart.as_ref().expect("charted").s_range();
    // Ends inside of elements.
    let rectangle = [[from + 0.11 * (to - from), from + 0.83 * (to - from)], [-0.0063, 0.0049]];
    let density = |s: f64, z: f64| [1e9 * s * z * z, 2e6 * (s - from), -3e6 + 1e8 * z];
    let load = model
        .face_load_between(set, rectangle, |s, z, _| density(s, z))
        .expect("charted")
        .to_full(model.dof_count());
    let integral =
        |from: f64, to: f64, power: i32| (to.powi(power + 1) - from.powi(power + 1)) / f64::from(power + 1);
    let [s, z] = rectangle;
    let (s0, s1) = (integral(s[0], s[1], 0), integral(s[0], s[1], 1));
    let (z0, z1, z2) = (integral(z[0], z[1], 0), integral(z[0], z[1], 1), integral(z[0], z[1], 2));
    let exact = [1e9 * s1 * z2, 2e6 * (s1 - from * s0) * z0, s0 * (-3e6 * z0 + 1e8 * z1)];
    for axis in 0..3 {
        let total = load.iter().skip(axis).step_by(3).sum::<f64>();
        assert!((total - exact[axis]).abs() < 1e-12 * exact[axis].abs(), "{total} is not {}", exact[axis]);
    }
    // The mean of z under the density along z.
    let moment =
        (0..model.mesh.nodes.len()).map(|node| load[3 * node + 2] * model.mesh.nodes[node][2]).sum::<f64>();
    let exact = s0 * (-3e6 * z1 + 1e8 * z2);
    assert!((moment - exact).abs() < 1e-12 * exact.abs(), "{moment} is not {exact}");
}

#[test]
fn charts_have_their_nodes_in_order_and_their_points_on_them() {
    let model = model(3, 3, 3);
    let mesh = &model.mesh;
    let swept = mesh.swept.as_ref().expect("swept");
    let [first, last] = ["cut_first", "cut_last"].map(|name| {
        let set = mesh.face_set(name).expect("named");
        let axodes = swept.axodes_on(set.chart.as_ref().expect("charted"));
        assert_eq!(mesh.nodes_on(set), axodes.concat());
        axodes
    });
    assert_eq!((first.len(), first[0].len()), (7, 10));
    // Mirror images in the section; both run counter-clockwise around it.
    for (first, last) in first.iter().zip(last.iter().rev()) {
        for (&first, &last) in first.iter().zip(last) {
            let [a, b] = [first, last].map(|node| mesh.nodes[node]);
            assert!((a[0].hypot(a[1]) - b[0].hypot(b[1])).abs() < 1e-12 && (a[2] - b[2]).abs() < 1e-15);
        }
        assert!(first.windows(2).all(|pair| mesh.nodes[pair[0]][2] < mesh.nodes[pair[1]][2]));
    }
    let set = mesh.face_set("flank").expect("named");
    let [from, to] = set.chart.as_ref().expect("charted").s_range();
    let step = 1e-6;
    for s in [from + 0.2 * (to - from), 0.5 * (from + to)] {
        for z in [-0.008, 0.0, 0.003] {
            let point = mesh.surface_point(set, s, z).expect("on it");
            let ahead = mesh.surface_point(set, s + step, z).expect("on it");
            let beside = mesh.surface_point(set, s, z + step).expect("on it");
            let by_s = [0, 1, 2].map(|axis| (ahead.position[axis] - point.position[axis]) / step);
            let by_z = [0, 1, 2].map(|axis| (beside.position[axis] - point.position[axis]) / step);
            assert!((dot(by_s, point.tangents[0]) - 1.0).abs() < 1e-3);
            assert!(dot(by_z, point.tangents[1]) > 0.9 && dot(by_z, point.normal).abs() < 1e-3);
            // sqrt(1 + (twist times x . t)²) for a twist of 12 rad/m.
            let [x, y, z_there] = point.position;
            let turning = dot([-y, x, 0.0], point.normal) * 12.0;
            let exact = (1.0 + turning * turning / (1.0 - point.normal[2].powi(2))).sqrt();
            assert!((point.area - exact).abs() < 2e-3, "area {} is not {exact} at z = {z_there}", point.area);
        }
    }
}

#[test]
fn without_change_along_the_axis_recovered_stress_is_that_of_the_plane() {
    for (order, axial) in [(1, 1), (2, 3), (3, 3)] {
        let section = section(ElementOrder::full(order), ElementOrder::full(order));
        let mesh = SolidMesh::swept(&section, &STATIONS, axial, &|[x, y], z| [x, y, z]).expect("sound");
        let (plane, solid) =
            (PlaneModel::new(section, MATERIAL, Plane::Strain), SolidModel::new(mesh, MATERIAL));
        // Any field that does not depend on z, rough enough that smoothing matters.
        let field = |x: f64, y: f64| {
            [1e-5 * (900.0 * x).sin() * (700.0 * y).cos(), 1e-5 * (800.0 * x * y / 0.03).cos()]
        };
        let in_plane = plane.mesh.nodes.iter().flat_map(|&[x, y]| field(x, y)).collect::<Vec<_>>();
        let three_dimensional = solid.mesh.nodes.iter().flat_map(|&[x, y, _]| {
            let [u, v] = field(x, y);
            [u, v, 0.0]
        });
        let three_dimensional = three_dimensional.collect::<Vec<_>>();
        let (flat, recovery) =
            (StressRecovery::new(&plane), SurfaceStressRecovery::new(&solid).expect("swept"));
        let (chain, set) =
            (plane.mesh.chain("flank").expect("named"), solid.mesh.face_set("flank").expect("named"));
        let [from, to] = chain.range();
        for (part, z) in [(0.0, -0.011), (0.13, 0.0), (0.5, 0.002), (0.92, 0.01)] {
            let s = from + part * (to - from);
            let expected = flat.surface_row(chain, s).expect("on it").dot(&in_plane);
            let found = recovery.rows(set, s, z).expect("on it").rows.map(|row| row.dot(&three_dimensional));
            let scale = expected.abs().max(1e-6 * MATERIAL.youngs_modulus);
            assert!(
                (found[0] - expected).abs() < 1e-10 * scale,
                "order {order}: {} is not {expected}",
                found[0]
            );
            assert!(found[2].abs() < 1e-10 * scale, "order {order}: shear {}", found[2]);
        }
    }
}

#[test]
fn a_mirrored_field_has_the_mirrored_stress_also_where_layers_meet() {
    let section = section(ElementOrder::full(2), ElementOrder::full(2));
    let mesh = SolidMesh::swept(&section, &[-0.01, 0.0, 0.01], 2, &|[x, y], z| [x, y, z]).expect("sound");
    let model = SolidModel::new(mesh, MATERIAL);
    let recovery = SurfaceStressRecovery::new(&model).expect("swept");
    let set = model.mesh.face_set("flank").expect("named");
    let [from, to] = set.chart.as_ref().expect("charted").s_range();
    // Far from polynomial within an element, and larger at one end.
    let field = |[x, y, z]: [f64; 3]| {
        [
            1e-5 * (90.0 * z).exp(),
            1e-5 * (70.0 * z + 200.0 * x).sin(),
            1e-5 * (110.0 * z).exp() * (100.0 * y).cos(),
        ]
    };
    let displaced = model.mesh.nodes.iter().flat_map(|&node| field(node)).collect::<Vec<_>>();
    let mirrored = model.mesh.nodes.iter().flat_map(|&[x, y, z]| {
        let [u, v, w] = field([x, y, -z]);
        [u, v, -w]
    });
    let mirrored = mirrored.collect::<Vec<_>>();
    for z in [-0.01, -0.003, 0.0, 0.004, 0.01] {
        let at = |z: f64, field: &[f64]| {
            recovery.rows(set, 0.5 * (from + to), z).expect("on it").rows.map(|row| row.dot(field))
        };
        let (found, image) = (at(z, &displaced), at(-z, &mirrored));
        // Shear changes its sign.
        for (found, image) in [(found[0], image[0]), (found[1], image[1]), (found[2], -image[2])] {
            assert!((found - image).abs() < 1e-9 * found.abs().max(1e5), "z = {z}: {found} and {image}");
        }
    }
}

#[test]
fn recovered_surface_stress_converges_at_the_order_of_the_elements() {
    // Hoop stress in the bore of a thick cylinder, up to the side faces.
    let problem = cylinder(MATERIAL);
    for (kind, coarse) in
        [(Kind::Swept(1, 1), [4, 8, 2]), (Kind::Swept(2, 2), [3, 6, 1]), (Kind::Swept(3, 3), [3, 5, 1])]
    {
        let errors = [1, 2].map(|finer| {
            let (model, displacements) = solved(&problem, kind, coarse.map(|count| count * finer));
            let recovery = SurfaceStressRecovery::new(&model).expect("swept");
            let set = model.mesh.face_set("x = 0").expect("named");
            let [from, to] = set.chart.as_ref().expect("charted").s_range();
            let mut worst = 0.0_f64;
            for s in 0..=16 {
                for z in [0.0, 0.23, 0.5, 1.0] {
                    let s = from + (to - from) * f64::from(s) / 16.0;
                    let found = recovery.rows(set, s, z).expect("on it");
                    let stress = (problem.stress)(found.point.position);
                    let [a, b] = found.point.tangents;
                    for (row, (p, q)) in found.rows.iter().zip([(a, a), (b, b), (a, b)]) {
                        worst = worst.max((row.dot(&displacements) - dot(traction(stress, p), q)).abs());
                    }
                }
            }
            worst / 2.6e6
        });
        let rate = (errors[0] / errors[1]).log2();
        println!("recovered stress in the bore, {kind:?}: {errors:?}, rate {rate:.2}");
        assert!(rate > f64::from(kind.order()) - 0.3, "{kind:?}: at {rate}");
    }
}

#[test]
fn charts_follow_the_true_surface_at_the_order_of_the_coordinates() {
    // Coordinate nodes lie on the twisted arc; between them the mesh departs from it.
    let (radius, half) = ((0.01_f64).hypot(0.003), (0.3_f64).atan());
    for order in 1..=3 {
        let section = section(ElementOrder::full(order), ElementOrder::full(order));
        let departures = [1, 2].map(|finer: usize| {
            let stations =
                uniform(3 * finer).into_iter().map(|part| 0.022 * (part - 0.5)).collect::<Vec<_>>();
            let mesh = SolidMesh::swept(&section, &stations, order.into(), &twisted).expect("sound");
            let set = mesh.face_set("flank").expect("named");
            let mut worst = 0.0_f64;
            for part in 0..40 {
                // At a coordinate node of the section, so that only the twist departs.
                let (s, z) = (0.001, 0.022 * (f64::from(part) / 39.0 - 0.5));
                let angle = -half;
                let exact = twisted([0.030 + radius * angle.cos(), radius * angle.sin()], z);
                let found = mesh.surface_point(set, s, z).expect("on it").position;
                let off = [0, 1, 2].map(|axis| found[axis] - exact[axis]);
                worst = worst.max(dot(off, off).sqrt());
            }
            worst
        });
        let rate = (departures[0] / departures[1]).log2();
        println!("coordinates of order {order}: off the surface by {departures:?} m, rate {rate:.2}");
        assert!((rate - f64::from(order + 1)).abs() < 0.2, "order {order}: at {rate}");
    }
}

#[test]
fn a_loft_through_rotated_sections_is_the_sweep() {
    let section = section(ElementOrder::full(3), ElementOrder::full(2));
    let swept = SolidMesh::swept(&section, &STATIONS, 3, &twisted).expect("sound");
    let sections: Vec<Vec<[f64; 3]>> = coordinate_stations(&STATIONS, 3)
        .into_iter()
        .map(|z| section.coordinate_nodes.iter().map(|&point| twisted(point, z)).collect())
        .collect();
    assert_eq!(SolidMesh::lofted(&section, &STATIONS, 3, &sections), Ok(swept));
    let lofted = |sections: &[Vec<[f64; 3]>]| SolidMesh::lofted(&section, &STATIONS, 3, sections);
    assert_eq!(lofted(&sections[1..]), Err(SweepError::Sections));
    let mut short = sections.clone();
    short[4].pop();
    assert_eq!(lofted(&short), Err(SweepError::Sections));
    // A section that lies behind the one before it folds an element.
    let mut folded = sections;
    folded.swap(4, 5);
    assert!(matches!(lofted(&folded), Err(SweepError::Folded { .. })));
}

#[test]
fn a_twist_does_not_make_elimination_more_expensive() {
    let block = Block::new(
        Curve::line([0.10, -0.02], [0.14, -0.02]),
        Curve::line([0.14, -0.02], [0.14, 0.02]),
        Curve::line([0.10, 0.02], [0.14, 0.02]),
        Curve::line([0.10, -0.02], [0.10, 0.02]),
    );
    let mut builder = MeshBuilder::new();
    builder.block(block.divided(uniform(4), uniform(4)));
    let section = builder.finish(ElementOrder::full(2)).expect("one sound block");
    let stations: Vec<f64> = (0..=12).map(|layer| 0.005 * f64::from(layer)).collect();
    let cost = |per_length: f64, by_position: bool| {
        let place = |[x, y]: [f64; 2], z: f64| {
            let (sin, cos) = (per_length * z).sin_cos();
            [cos * x - sin * y, sin * x + cos * y, z]
        };
        let mesh = SolidMesh::swept(&section, &stations, 2, &place).expect("a mesh");
        let coordinates = if by_position { mesh.nodes.clone() } else { mesh.ordering_coordinates() };
        let stiffness = SolidModel::new(mesh, MATERIAL).stiffness();
        Dissection::new(&stiffness, &coordinates, &[], &[]).cost().0
    };
    assert_eq!(cost(10.0, false), cost(0.0, false));
    assert!(cost(10.0, true) > 1.2 * cost(10.0, false));
    assert!(cost(0.0, false) < 1.1 * cost(0.0, true));
}
