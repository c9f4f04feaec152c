//! Skins of shells: openings, ribs, inner parts, and refusals; rims on solids; impedances of
//! patterns.

use crate::shapes::cuboid;
use calyx_acoustics::openings::selected_rims;
use calyx_acoustics::radiation::{equivalent_impedance, equivalent_radiated_power};
use calyx_acoustics::shells::{ShellProblem, ShellSkin};
use calyx_acoustics::{Face, Fluid, rayleigh};
use calyx_numerics::interrupt::Interrupt;
use calyx_numerics::vec3::Vector;
use faer::c64;
use std::collections::BTreeSet;

/// A box of 4 x 4 x 4 shells of unit size with normals of alternating sense.
fn shells() -> (Vec<Vector>, Vec<Face>) {
    let (nodes, mut faces) = cuboid([4.0; 3], [4; 3]);
    for face in faces.iter_mut().step_by(3) {
        match face {
            Face::Triangle(corners) => corners.reverse(),
            Face::Quadrilateral(corners) => corners.reverse(),
        }
    }
    (nodes, faces)
}

/// Nodes in a box.
fn within(nodes: &[Vector], low: Vector, high: Vector) -> BTreeSet<usize> {
    let inside = |at: &Vector| (0..3).all(|k| (low[k] - 1e-9..=high[k] + 1e-9).contains(&at[k]));
    (0..nodes.len()).filter(|&node| inside(&nodes[node])).collect()
}

fn without(nodes: &[Vector], faces: &[Face], low: Vector, high: Vector) -> Vec<Face> {
    let removed = within(nodes, low, high);
    faces.iter().filter(|face| !face.vertices().iter().all(|v| removed.contains(v))).copied().collect()
}

#[test]
fn shells_are_closed_over_named_openings() {
    let (nodes, faces) = shells();
    let low = nodes.iter().fold([f64::INFINITY; 3], |low, at| [0, 1, 2].map(|k: usize| low[k].min(at[k])));
    let top = low[2] + 4.0;
    let window = ([low[0] + 1.0, low[1] + 1.0, top], [low[0] + 3.0, low[1] + 3.0, top]);
    let open = without(&nodes, &faces, window.0, window.1);
    assert_eq!(open.len(), faces.len() - 4);
    let opening = within(&nodes, window.0, window.1);
    let (found, closed) = ShellSkin::new(&nodes, &open, &[opening], None).expect("closed");
    assert_eq!((closed, found.left_out), (vec![1], 0));
    let mesh = &found.skin.mesh;
    assert!((mesh.area() - 96.0).abs() < 1e-9 && (mesh.volume() - 64.0).abs() < 1e-9, "{}", mesh.volume());
    assert_eq!(found.skin.nodes.iter().filter(|nodes| nodes.len() == 8).count(), 1);

    match ShellSkin::new(&nodes, &open, &[], None).expect_err("open") {
        ShellProblem::Open { rims, edges } => assert_eq!((rims.len(), rims[0].len(), edges), (1, 8, 8)),
        other => panic!("{other:?}"),
    }
    // Two openings have the rim only together.
    let ([x, y, z], [far, ..]) = window;
    let halves = [0.0, 1.0].map(|from| within(&nodes, [x, y + from, z], [far, y + from + 1.0, z]));
    match ShellSkin::new(&nodes, &open, &halves, None).expect_err("no opening has the whole rim") {
        ShellProblem::Open { rims, .. } => assert_eq!((rims.len(), rims[0].len()), (1, 8)),
        other => panic!("{other:?}"),
    }
}

#[test]
fn ribs_and_inner_parts_are_left_out() {
    let (mut nodes, mut faces) = shells();
    let at = |nodes: &[Vector], x: Vector| {
        let near = |node: &Vector| (0..3).all(|k| (node[k] - x[k]).abs() < 1e-9);
        nodes.iter().position(near).expect("a node")
    };
    let low = nodes.iter().fold([f64::INFINITY; 3], |low, at| [0, 1, 2].map(|k: usize| low[k].min(at[k])));
    // A rib on the top, along its middle.
    for k in 0..3 {
        let foot = |k: usize| [low[0] + k as f64, low[1] + 2.0, low[2] + 4.0];
        let (a, b) = (at(&nodes, foot(k)), at(&nodes, foot(k + 1)));
        let high = |[x, y, z]: Vector| [x, y, z + 1.0];
        let index = nodes.len();
        nodes.extend([high(nodes[b]), high(nodes[a])]);
        faces.push(Face::Quadrilateral([a, b, index, index + 1]));
    }
    let (small, inner) = cuboid([1.0; 3], [1; 3]);
    let first = nodes.len();
    let middle = [0, 1, 2].map(|k: usize| low[k] + 2.0);
    nodes.extend(small.iter().map(|at| [0, 1, 2].map(|k: usize| at[k] + middle[k])));
    let moved = |face: &Face| match *face {
        Face::Triangle(corners) => Face::Triangle(corners.map(|corner| corner + first)),
        Face::Quadrilateral(corners) => Face::Quadrilateral(corners.map(|corner| corner + first)),
    };
    faces.extend(inner.iter().map(moved));
    let (found, _) = ShellSkin::new(&nodes, &faces, &[], None).expect("closed");
    assert_eq!(found.left_out, 3 + inner.len());
    assert!((found.skin.mesh.volume() - 64.0).abs() < 1e-9);

    // A bulkhead between all walls.
    let (mut nodes, mut faces) = shells();
    let mut corner = |j: usize, k: usize| {
        let x = [low[0] + 2.0, low[1] + j as f64, low[2] + k as f64];
        let near = |node: &Vector| (0..3).all(|k| (node[k] - x[k]).abs() < 1e-9);
        nodes.iter().position(near).unwrap_or_else(|| {
            nodes.push(x);
            nodes.len() - 1
        })
    };
    for (j, k) in (0..16).map(|cell| (cell % 4, cell / 4)) {
        let corners = [corner(j, k), corner(j + 1, k), corner(j + 1, k + 1), corner(j, k + 1)];
        faces.push(Face::Quadrilateral(corners));
    }
    let problem = ShellSkin::new(&nodes, &faces, &[], None).map(drop).expect_err("a junction");
    assert!(matches!(problem, ShellProblem::Junction { shells: 3, .. }), "{problem:?}");
}

/// The boundary of the faces of a bore are its two ends; a line of nodes is one rim.
#[test]
fn rims_are_boundaries_of_selected_faces_or_lines() {
    let (nodes, faces) = cuboid([4.0; 3], [4; 3]);
    let low = nodes.iter().fold([f64::INFINITY; 3], |low, at| [0, 1, 2].map(|k: usize| low[k].min(at[k])));
    let ring = |from: f64, to: f64| {
        let all = within(&nodes, [low[0], low[1], low[2] + from], [low[0] + 4.0, low[1] + 4.0, low[2] + to]);
        selected_rims(&faces, &all)
    };
    let lengths =
        |rims: Option<Vec<Vec<usize>>>| rims.map(|rims| rims.iter().map(Vec::len).collect::<Vec<_>>());
    assert_eq!(lengths(ring(1.0, 1.0)), Some(vec![16]));
    assert_eq!(lengths(ring(1.0, 3.0)), Some(vec![16, 16]));
    assert_eq!(lengths(selected_rims(&faces, &BTreeSet::from([0, 1]))), None);
    assert_eq!(lengths(selected_rims(&faces, &BTreeSet::new())), None);
}

/// The quadratic forms of patterns give the powers of their combinations.
#[test]
fn impedances_of_patterns_give_the_power_of_combinations() {
    let (nodes, faces) = cuboid([0.4; 3], [3; 3]);
    let mesh = calyx_acoustics::SurfaceMesh::new(nodes, &faces, None).expect("closed");
    let count = mesh.triangles().len();
    let pattern = |rate: f64| (0..count).map(|k| (rate * k as f64).sin()).collect::<Vec<f64>>();
    let patterns = [pattern(0.3), pattern(1.1), vec![1.0; count]];
    let amplitudes = [c64::new(0.2, 0.7), c64::new(-1.0, 0.4), c64::new(0.1, -0.3)];
    let velocity = |k: usize| patterns.iter().zip(amplitudes).map(|(pattern, a)| a * pattern[k]).sum::<c64>();
    let velocities: Vec<c64> = (0..count).map(velocity).collect();
    let (fluid, interrupt) = (Fluid::AIR, Interrupt::never());
    let triangles: Vec<[Vector; 3]> = (0..count).map(|k| mesh.corners(k)).collect();
    for frequency in [50.0, 400.0] {
        let expected =
            rayleigh::power(&triangles, &velocities, &fluid, frequency, &interrupt).expect("a power");
        // Two panels that share the triangles, and all of them.
        let part = |k: usize| (k % 5) as f64 / 4.0;
        let panels: [Vec<f64>; 3] =
            [(0..count).map(part).collect(), (0..count).map(|k| 1.0 - part(k)).collect(), vec![1.0; count]];
        let found =
            rayleigh::panel_impedances(&triangles, &patterns, &panels, (&fluid, frequency), &interrupt);
        let found: Vec<f64> =
            found.expect("impedances").iter().map(|panel| panel.power(&amplitudes)).collect();
        assert!((found[2] / expected - 1.0).abs() < 1e-10, "{found:?} {expected}");
        assert!(((found[0] + found[1]) / expected - 1.0).abs() < 1e-10, "{found:?} {expected}");
        let of_triangles = rayleigh::triangle_powers(&triangles, &velocities, &fluid, frequency, &interrupt)
            .expect("powers");
        let first: f64 = of_triangles.iter().enumerate().map(|(k, power)| part(k) * power).sum();
        assert!((found[0] - first).abs() < 1e-10 * expected, "{found:?} {first}");
    }
    let expected = equivalent_radiated_power(&mesh, &fluid, &velocities);
    let found = equivalent_impedance(mesh.areas(), &fluid, &patterns).power(&amplitudes);
    assert!((found / expected - 1.0).abs() < 1e-12, "{found} {expected}");
    let invalid = rayleigh::panel_impedances(&triangles, &[vec![1.0; 2]], &[], (&fluid, 50.0), &interrupt);
    assert!(invalid.is_err());
}
