//! Joints of shells and solids: bending passes through.

use super::support::{DirectorMesh, Mesh, Model, SHAPES, assert_close, material, uniform};
use calyx_elastic::model::ShellShape;
use calyx_elastic::shell::{DirectorNode, DirectorShape, DirectorShell, Integration, ShellElement, coupling};
use calyx_fe::material::Material;
use calyx_fe::solid::{Cell, SolidMesh, SolidModel};
use nalgebra::DMatrix;

const THICKNESS: f64 = 0.2;
const WIDTH: f64 = 1.0;
const YOUNGS_MODULUS: f64 = 1e6;

/// Block 0 <= x <= 1 of quadratic hexahedra, two across its thickness.
fn block(poissons_ratio: f64) -> SolidModel {
    let (xs, ys, zs) = ([0.0, 0.5, 1.0], [0.0, 0.5 * WIDTH, WIDTH], [-0.5, 0.0, 0.5].map(|z| z * THICKNESS));
    let mut points = Vec::new();
    for z in zs {
        for y in ys {
            points.extend(xs.map(|x| [x, y, z]));
        }
    }
    let mut cells = Vec::new();
    for k in 0..2 {
        for j in 0..2 {
            for i in 0..2 {
                let at = |a: usize, b: usize, c: usize| 9 * (k + c) + 3 * (j + b) + i + a;
                let corner = |n: usize| at(n % 2, n / 2 % 2, n / 4);
                cells.push((Cell::Hexahedron, (0..8).map(corner).collect()));
            }
        }
    }
    let mesh = SolidMesh::of_cells(&points, &cells, 2, 1, &|at| at).unwrap();
    SolidModel::new(mesh, Material { youngs_modulus: YOUNGS_MODULUS, poissons_ratio, density: 0.0 })
}

/// Adds the solid: its nodes on the joint follow the rows of `joint` over components of the shell.
/// The end x = 0 is clamped, or free to contract.
fn add_block(
    model: &mut Model,
    solid: &SolidModel,
    clamped: bool,
    joint: impl Fn([f64; 3]) -> (Vec<usize>, DMatrix<f64>),
) {
    let first = model.load.len() / 6;
    let mut terms = Vec::new();
    for (node, at) in solid.mesh.nodes.iter().enumerate() {
        model.axes.push(nalgebra::Matrix3::identity());
        model.load.extend([0.0; 6]);
        let own = first + node;
        if at[0] > 1.0 - 1e-9 {
            let (nodes, rows) = joint(*at);
            for axis in 0..3 {
                let term = |column: usize| (6 * nodes[column / 6] + column % 6, rows[(axis, column)]);
                terms.push((0..rows.ncols()).map(term).filter(|term| term.1 != 0.0).collect());
            }
            model.fix(own, &[0, 1, 2, 3, 4, 5]);
        } else {
            (0..3).for_each(|axis| terms.push(vec![(6 * own + axis, 1.0)]));
            model.fix(own, &[3, 4, 5]);
            for axis in 0..3 {
                if (clamped || at[axis].abs() < 1e-9) && at[0].abs() < 1e-9 {
                    model.fix(own, &[axis]);
                }
            }
        }
    }
    for entry in solid.stiffness().triplet_iter() {
        for &(row, a) in &terms[entry.row] as &Vec<(usize, f64)> {
            for &(column, b) in &terms[entry.col] {
                model.stiffness.push((column, row, a * b * entry.val));
            }
        }
    }
}

/// Load at the end x = 3 of a strip.
#[derive(Clone, Copy, PartialEq)]
enum Load {
    Moment,
    Tension,
}

/// Returns the displacement and the thickness derivative of the middle of the end x = 3 of the
/// report's shell joined to the block, under a unit load.
fn director_joint(poissons_ratio: f64, load: Load) -> [f64; 6] {
    let steel = material(YOUNGS_MODULUS, poissons_ratio, 0.0);
    let half = 0.5 * THICKNESS;
    let mesh = DirectorMesh::grid(false, 2, &uniform(4), &uniform(2), |[u, v]| DirectorNode {
        position: [1.0 + 2.0 * u, WIDTH * v, 0.0],
        half_thickness: [0.0, 0.0, half],
        offset: 0.0,
    });
    let mut model = Model::new(mesh.nodes.len());
    mesh.each(&steel, Integration::SelectivelyReduced, |nodes, element| {
        model.add_stiffness(nodes, element.stiffness().unwrap());
    });
    for (node, &[u, v]) in mesh.parameters.iter().enumerate() {
        match load {
            Load::Moment => model.fix(node, &[5]),
            Load::Tension if v == 0.0 => model.fix(node, &[1]),
            Load::Tension => {}
        }
        if u == 1.0 {
            let share = if v == 0.0 || v == 1.0 {
                1.0 / 12.0
            } else if v == 0.5 {
                1.0 / 6.0
            } else {
                1.0 / 3.0
            };
            let (component, value) = if load == Load::Moment { (3, -1.0 / half) } else { (0, 1.0) };
            model.load[6 * node + component] = share * value;
        }
    }
    add_block(&mut model, &block(poissons_ratio), load == Load::Moment, |at| {
        let joined = mesh.elements.iter().find_map(|(shape, indices)| {
            let nodes = indices.iter().map(|&node| mesh.nodes[node]).collect::<Vec<_>>();
            let integration = Integration::Full;
            let element = DirectorShell { shape: *shape, nodes: &nodes, material: &steel, integration };
            Some((indices.clone(), element.coupling(at).ok()?))
        });
        joined.expect("the point is on the edge of an element")
    });
    let found = model.solve();
    let tip = mesh.nodes_where(|at| at == [1.0, 0.5])[0];
    std::array::from_fn(|component| found[6 * tip + component])
}

/// Returns deflection and slope.
fn bent([_, _, deflection, across, ..]: [f64; 6]) -> [f64; 2] {
    [deflection, -across / (0.5 * THICKNESS)]
}

/// Without the constraint of its thickness, the shell follows the solid's lateral contraction.
#[test]
fn tension_passes_through_a_joint_exactly() {
    let strain = 1.0 / (YOUNGS_MODULUS * WIDTH * THICKNESS);
    let found = director_joint(0.3, Load::Tension);
    assert_close(found[0], 3.0 * strain, 1e-9, "elongation");
    assert_close(found[1], -0.3 * 0.5 * WIDTH * strain, 1e-9, "contraction of the width");
    assert_close(found[5], -0.3 * 0.5 * THICKNESS * strain, 1e-9, "contraction of the thickness");
}

#[test]
fn bending_passes_through_a_joint_exactly() {
    let curvature = 12.0 / (YOUNGS_MODULUS * WIDTH * THICKNESS.powi(3));
    let [deflection, slope] = bent(director_joint(0.0, Load::Moment));
    assert_close(deflection, curvature * 4.5, 1e-9, "deflection");
    assert_close(slope, curvature * 3.0, 1e-9, "slope");
}

/// With lateral contraction, the joint and the clamped end of the solid suppress its curved
/// thickness strain. The disturbance is local: it stiffens the strip by less than a quarter of the
/// thickness at each of them.
#[test]
fn a_joint_disturbs_bending_locally() {
    let steel = material(YOUNGS_MODULUS, 0.3, 0.0);
    let mesh =
        Mesh::grid(ShellShape::Quadrilateral9, &uniform(12), &uniform(4), |[u, v]| [3.0 * u, WIDTH * v, 0.0]);
    let mut model = Model::of_mesh(&mesh, THICKNESS, 0.0, &steel);
    model.fix_all(&mesh.nodes(|[u, _]| u == 0.0), &[0, 1, 2, 3, 4, 5]);
    for node in mesh.nodes(|[u, _]| u == 1.0) {
        let v = mesh.parameters[node][1];
        let eighth = (8.0 * v).round() as usize;
        let share = if v == 0.0 || v == 1.0 { 1.0 } else { [2.0, 4.0][eighth % 2] };
        model.load[6 * node + 4] = -share / 24.0;
    }
    let found = model.solve();
    let tip = mesh.node([1.0, 0.5]);
    let reference = [found[6 * tip + 2], -found[6 * tip + 4]];
    for (value, reference) in bent(director_joint(0.3, Load::Moment)).into_iter().zip(reference) {
        assert_close(value, reference, 2.0 * 0.25 * THICKNESS / 3.0, "end of the strip");
    }
}

#[test]
fn bending_passes_from_rotations_to_a_solid() {
    let curvature = 12.0 / (YOUNGS_MODULUS * WIDTH * THICKNESS.powi(3));
    let steel = material(YOUNGS_MODULUS, 0.0, 0.0);
    for (shape, offset) in SHAPES.into_iter().flat_map(|shape| [(shape, 0.0), (shape, 0.15)]) {
        // The nodes are below the mid-surface by the offset.
        let mesh = Mesh::grid(shape, &uniform(4), &uniform(2), |[u, v]| [1.0 + 2.0 * u, WIDTH * v, -offset]);
        let mut model = Model::of_mesh(&mesh, THICKNESS, offset, &steel);
        let quadratic = shape.node_count() > 4;
        for node in mesh.nodes(|[u, _]| u == 1.0) {
            let v = mesh.parameters[node][1];
            let share = match (quadratic, v == 0.0 || v == 1.0) {
                (false, true) => 0.25,
                (false, false) => 0.5,
                (true, true) => 1.0 / 12.0,
                (true, false) => {
                    if v == 0.5 {
                        1.0 / 6.0
                    } else {
                        1.0 / 3.0
                    }
                }
            };
            model.load[6 * node + 4] = -share;
        }
        let thickness = vec![THICKNESS; shape.corner_count()];
        add_block(&mut model, &block(0.0), true, |at| {
            let joined = mesh.each().find_map(|(nodes, positions)| {
                let element = ShellElement {
                    shape,
                    positions: &positions,
                    thickness: &thickness,
                    offset,
                    material: &steel,
                    added_mass: 0.0,
                };
                Some((nodes.to_vec(), coupling(&element, at).ok()?))
            });
            joined.expect("the point is on the edge of an element")
        });
        let found = model.solve();
        let tip = mesh.node([1.0, 0.5]);
        assert_close(found[6 * tip + 2], curvature * 4.5, 1e-8, &format!("{shape:?} deflection"));
        assert_close(-found[6 * tip + 4], curvature * 3.0, 1e-8, &format!("{shape:?} slope"));
    }
}

#[test]
fn points_outside_are_rejected() {
    let steel = material(1.0, 0.3, 0.0);
    let nodes = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]].map(|[x, y]| DirectorNode {
        position: [x, y, 0.0],
        half_thickness: [0.0, 0.0, 0.1],
        offset: 0.0,
    });
    let element = DirectorShell {
        shape: DirectorShape::Quadrilateral(1),
        nodes: &nodes,
        material: &steel,
        integration: Integration::Full,
    };
    assert!(element.coupling([1.0, 0.3, 0.1]).is_ok());
    for point in [[1.1, 0.3, 0.0], [1.0, 0.3, 0.2], [f64::NAN, 0.0, 0.0]] {
        let error = element.coupling(point).unwrap_err();
        assert!(error.message.contains("not within the shell element"), "{}", error.message);
    }
}
