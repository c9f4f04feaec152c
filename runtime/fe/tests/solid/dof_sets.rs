//! DOF sets: rigid regions, and meshes that do not conform joined by a series on a surface of
//! revolution.

use crate::solid::convergence::{Stress, cylinder};
use crate::solid::shapes::parts as box_parts;
use crate::solid::{GRADIENT, MATERIAL, dot, linear_field, traction};
use calyx_fe::solid::{
    Cell, Component, DofError, DofKind, DofSets, Reduced, RevolutionSurface, Series, SolidMesh, SolidModel,
};
use calyx_fe::{Constraints, Solver};
use std::f64::consts::PI;

/// Between both parts, m.
const SEAT: f64 = 1.5;
/// Half of the length of both, m.
const HALF: f64 = 0.4;

/// A closed ring of elements around the z axis: sectors, layers outward and along.
fn ring(cell: Cell, order: u8, radii: [f64; 2], [around, outward, along]: [usize; 3]) -> SolidModel {
    let half_angle = PI / around as f64;
    let at = |i: usize, j: usize, k: usize| (k * (outward + 1) + j) * around + i % around;
    let mut points = Vec::new();
    for k in 0..=along {
        for j in 0..=outward {
            let radius = radii[0] + (radii[1] - radii[0]) * j as f64 / outward as f64;
            points.extend((0..around).map(|i| {
                let (sin, cos) = (2.0 * half_angle * i as f64).sin_cos();
                [radius * cos, radius * sin, HALF * (2.0 * k as f64 / along as f64 - 1.0)]
            }));
        }
    }
    let mut cells = Vec::new();
    for k in 0..along {
        for j in 0..outward {
            for i in 0..around {
                // Outward, around, along, so that it is right-handed.
                let corner = |c: usize| at(i + c / 2 % 2, j + c % 2, k + c / 4);
                cells.extend(
                    box_parts(cell).iter().map(|part| (cell, part.iter().map(|&c| corner(c)).collect())),
                );
            }
        }
    }
    // From the chords to the circles, equal steps to equal angles.
    let bend = |[x, y, z]: [f64; 3]| {
        let (angle, distance) = (y.atan2(x), x.hypot(y));
        let sector = (angle / (2.0 * half_angle)).floor();
        let middle = (2.0 * sector + 1.0) * half_angle;
        let off = angle - middle;
        let radius = distance * off.cos() / half_angle.cos();
        let angle = middle + half_angle * off.tan() / half_angle.tan();
        [radius * angle.cos(), radius * angle.sin(), z]
    };
    let mut mesh = SolidMesh::of_cells(&points, &cells, order, order, &bend).expect("sound");
    let radius = |at: [f64; 3]| at[0].hypot(at[1]);
    let [inner, outer] = radii;
    mesh.name_faces("inside", |point| radius(point.position) < inner + 1e-2 && point.normal[2].abs() < 0.1);
    mesh.name_faces("outside", |point| radius(point.position) > outer - 1e-2 && point.normal[2].abs() < 0.1);
    mesh.name_faces("sides", |point| point.normal[2].abs() > 0.9);
    SolidModel::new(mesh, MATERIAL)
}

fn nodes(model: &SolidModel, name: &str) -> Vec<usize> {
    model.mesh.nodes_on(model.mesh.face_set(name).expect("named"))
}

fn seat(harmonics: u16, degree: u8) -> Series {
    Series::new(RevolutionSurface::cylinder(SEAT, [-HALF, HALF]), harmonics, degree)
        .expect("it has an extent")
}

/// A web inside of a rim, by a series between; finer by a factor.
fn parts(finer: usize) -> [SolidModel; 2] {
    [
        ring(Cell::Pentahedron, 2, [1.0, SEAT], [7 * finer, finer, finer]),
        ring(Cell::Hexahedron, 3, [SEAT, 2.0], [6 * finer, finer, finer]),
    ]
}

fn joined<'a>(parts: &'a [SolidModel; 2], series: Series) -> DofSets<'a> {
    let mut sets = DofSets::new(parts.iter().collect());
    sets.series("seat", series).expect("new");
    sets.attach("seat", 0, &nodes(&parts[0], "outside")).expect("free");
    sets.attach("seat", 1, &nodes(&parts[1], "inside")).expect("free");
    sets
}

/// Unknowns of a rigid-body motion of the whole: those of the seat, whose centre is the origin, are
/// its translations and rotations.
fn rigid_motion(reduced: &Reduced<'_>, parts: &[SolidModel; 2], mode: usize) -> Vec<f64> {
    let mut unknowns = vec![f64::NAN; reduced.count()];
    // Values that every single displacement has to have.
    for (part, model) in parts.iter().enumerate() {
        let motion = &model.rigid_body_modes()[mode];
        for (dof, value) in motion.iter().enumerate() {
            let row = reduced.load(part, &std::iter::once((dof, 1.0)).collect());
            if let [(unknown, factor)] = row.entries[..] {
                unknowns[unknown] = value / factor;
            }
        }
    }
    for unknown in reduced.set("seat").expect("named").unknowns() {
        unknowns[unknown] = 0.0;
    }
    let first = reduced.set("seat").expect("named").unknowns().start;
    unknowns[first + mode] = 1.0;
    unknowns
}

#[test]
fn rigid_motions_pass_a_seat_exactly() {
    let parts = parts(1);
    for (harmonics, degree) in [(0, 0), (1, 0), (0, 2), (1, 1), (4, 3)] {
        let sets = joined(&parts, seat(harmonics, degree));
        let reduced = sets.reduce();
        let stiffness = reduced.stiffness();
        for mode in 0..6 {
            let unknowns = rigid_motion(&reduced, &parts, mode);
            for (part, model) in parts.iter().enumerate() {
                let moved = reduced.displacements(part, &unknowns);
                for (found, exact) in moved.iter().zip(&model.rigid_body_modes()[mode]) {
                    assert!(
                        (found - exact).abs() < 1e-13,
                        "{harmonics}, {degree}: motion {mode}: {found} {exact}"
                    );
                }
            }
            let (mut forces, mut largest) = (vec![0.0; reduced.count()], 0.0_f64);
            for entry in stiffness.triplet_iter() {
                let force = entry.val * unknowns[entry.col];
                forces[entry.row] += force;
                largest = largest.max(force.abs());
            }
            let left = forces.iter().map(|force| force.abs()).fold(0.0, f64::max) / largest;
            assert!(left < 1e-12, "{harmonics}, {degree}: motion {mode} strains, {left:e}");
        }
    }
}

#[test]
fn terms_of_a_series_are_independent_and_without_rigid_part() {
    let cone = RevolutionSurface {
        generator: [[1.0, -0.2], [1.4, 0.3]],
        ..RevolutionSurface::cylinder(1.0, [-1.0, 1.0])
    };
    let plane = RevolutionSurface { generator: [[0.5, 0.0], [1.4, 0.0]], ..cone.clone() };
    for surface in [RevolutionSurface::cylinder(SEAT, [-HALF, HALF]), cone, plane] {
        for (harmonics, degree) in [(0, 0), (1, 0), (0, 1), (2, 2), (3, 1)] {
            let series = Series::new(surface.clone(), harmonics, degree).expect("it has an extent");
            let size = 6 + series.terms().len();
            // All products over the surface, by sums that resolve the trigonometric functions and
            // the other polynomials.
            let mut gram = nalgebra::DMatrix::<f64>::zeros(size, size);
            for (zeta, weight) in calyx_fe::quadrature::gauss_legendre(8) {
                let [[r0, z0], [r1, z1]] = surface.generator;
                let mix = |a: f64, b: f64| 0.5 * ((1.0 - zeta) * a + (1.0 + zeta) * b);
                let (radius, z) = (mix(r0, r1), mix(z0, z1));
                for step in 0..24 {
                    let angle = 2.0 * PI * f64::from(step) / 24.0;
                    let at = [radius * angle.cos(), radius * angle.sin(), z];
                    let rows = series.displacements(at);
                    for a in 0..size {
                        for b in 0..size {
                            gram[(a, b)] += weight * radius * dot(rows[a], rows[b]);
                        }
                    }
                }
            }
            let largest = gram.amax();
            for rigid in 0..6 {
                for term in 6..size {
                    assert!(gram[(rigid, term)].abs() < 1e-12 * largest, "{:?}", series.terms()[term - 6]);
                }
            }
            let least = gram.symmetric_eigenvalues().min();
            assert!(least > 1e-4 * largest, "{harmonics}, {degree}: dependent, {least:e} of {largest:e}");
        }
    }
}

/// Largest displacement error of the parts, relative to the largest displacement, for a field that
/// is prescribed on the outside and the inside of both.
fn constrained_field_error(
    parts: &[SolidModel; 2],
    series: Series,
    field: &dyn Fn([f64; 3]) -> [f64; 3],
    stress: Stress<'_>,
) -> f64 {
    let mut sets = joined(parts, series);
    for (part, side) in [(0, "inside"), (1, "outside")] {
        sets.nodes(side, part, &nodes(&parts[part], side)).expect("free");
        sets.constrain(side, |kind| match *kind {
            DofKind::Displacement { part, node, axis } => Some(field(parts[part].mesh.nodes[node])[axis]),
            _ => None,
        })
        .expect("named");
    }
    let reduced = sets.reduce();
    let mut load = vec![0.0; reduced.count()];
    for (part, model) in parts.iter().enumerate() {
        let set = model.mesh.face_set("sides").expect("named");
        let forces = model.face_load(set, |point| traction(stress(point.position), point.normal));
        reduced.load(part, &forces).add_to(1.0, &mut load);
    }
    let solver = Solver::new(&reduced.stiffness(), reduced.constraints().clone()).expect("held");
    let solved = solver.solve_one(&load).expect("there is memory");
    let (mut worst, mut largest) = (0.0_f64, 0.0_f64);
    for (part, model) in parts.iter().enumerate() {
        let found = reduced.displacements(part, &solved);
        for (node, &at) in model.mesh.nodes.iter().enumerate() {
            for (axis, exact) in field(at).into_iter().enumerate() {
                worst = worst.max((found[3 * node + axis] - exact).abs());
                largest = largest.max(exact.abs());
            }
        }
    }
    worst / largest
}

#[test]
fn constant_strain_passes_a_seat_up_to_what_the_meshes_see_of_its_circle() {
    // Strain requires two harmonics around and a slope along. Nodes represent it exactly. Between
    // its nodes each mesh has its own seat, which approaches the circle with refinement.
    let constant = |_: [f64; 3]| parts(1)[0].stress_of(GRADIENT);
    let stress = constant([0.0; 3]);
    let errors =
        [1, 2].map(|finer| constrained_field_error(&parts(finer), seat(2, 1), &linear_field, &|_| stress));
    println!("constant strain: errors {errors:?}");
    assert!(errors[0] < 2e-3 && errors[0] / errors[1] > 6.0, "{errors:?}");
    // Too few terms hold it back.
    let poor = constrained_field_error(&parts(1), seat(1, 1), &linear_field, &|_| stress);
    assert!(poor > 10.0 * errors[0], "{poor} {errors:?}");
}

#[test]
fn a_pressed_cylinder_of_two_meshes_converges() {
    // The displacement is radial, so the series without harmonics represents it, and the error is
    // that of the meshes.
    let exact = cylinder_of_two();
    let errors = [1, 2].map(|finer| constrained_field_error(&parts(finer), seat(0, 0), &exact.0, &exact.1));
    println!("cylinder of two meshes: errors {errors:?}");
    assert!(errors[0] / errors[1] > 5.0, "{errors:?}");
}

type Solution = (Box<dyn Fn([f64; 3]) -> [f64; 3]>, Box<dyn Fn([f64; 3]) -> [f64; 6]>);

fn cylinder_of_two() -> Solution {
    let problem = cylinder(MATERIAL);
    (Box::new(move |at| (problem.displacement)(at)), Box::new(move |at| (problem.stress)(at)))
}

/// Displacement under a load at one side of the rim, with the web fixed at its bore, by the orders
/// of the seat's series. In the last one both meshes have the same nodes at the seat and are joined
/// node by node.
fn deflections(orders: &[(u16, u8)]) -> (Vec<f64>, f64) {
    let parts = [
        ring(Cell::Hexahedron, 2, [1.0, SEAT], [8, 1, 2]),
        ring(Cell::Hexahedron, 2, [SEAT, 2.0], [8, 1, 2]),
    ];
    let set = parts[1].mesh.face_set("outside").expect("named");
    let load = parts[1].face_load(set, |point| {
        let [x, y, z] = point.position;
        let near = (-4.0 * ((x - 2.0).powi(2) + y * y)).exp() * (1.0 + z);
        [-1e6 * near, 3e5 * near, 2e5 * near]
    });
    let solve = |reduced: &Reduced<'_>| {
        let on_unknowns = reduced.load(1, &load);
        let solver = Solver::new(&reduced.stiffness(), reduced.constraints().clone()).expect("held");
        on_unknowns.dot(&solver.solve_one(&on_unknowns.to_full(reduced.count())).expect("there is memory"))
    };
    let constrained = |sets: &mut DofSets<'_>| {
        sets.nodes("bore", 0, &nodes(&parts[0], "inside")).expect("free");
        sets.constrain("bore", |_| Some(0.0)).expect("named");
    };
    let found = orders.iter().map(|&(harmonics, degree)| {
        let mut sets = joined(&parts, seat(harmonics, degree));
        constrained(&mut sets);
        solve(&sets.reduce())
    });
    let found = found.collect();
    // Node by node: every pair is a rigid region without rotation, with three unknowns.
    let mut sets = DofSets::new(parts.iter().collect());
    let near = |a: [f64; 3], b: [f64; 3]| (0..3).all(|axis| (a[axis] - b[axis]).abs() < 1e-9);
    for (index, node) in nodes(&parts[0], "outside").into_iter().enumerate() {
        let at = parts[0].mesh.nodes[node];
        let mates = nodes(&parts[1], "inside");
        let mate =
            mates.into_iter().find(|&mate| near(parts[1].mesh.nodes[mate], at)).expect("the meshes conform");
        let name = format!("pair {index}");
        sets.rigid(&name, at).expect("new");
        sets.attach(&name, 0, &[node]).expect("free").attach(&name, 1, &[mate]).expect("free");
        sets.constrain(&name, |kind| matches!(kind, DofKind::Rotation(_)).then_some(0.0)).expect("named");
    }
    constrained(&mut sets);
    (found, solve(&sets.reduce()))
}

#[test]
fn more_terms_come_down_to_the_conforming_mesh_from_the_stiff_side() {
    let orders = [(1, 1), (2, 1), (3, 2), (5, 3), (7, 4)];
    let (found, conforming) = deflections(&orders);
    let missing = found.iter().map(|value| 1.0 - value / conforming).collect::<Vec<_>>();
    println!("seat of orders {orders:?}: missing of the deflection {missing:?}");
    assert!(missing.windows(2).all(|pair| pair[1] < pair[0]), "{missing:?}");
    assert!(missing[0] > 0.05 && missing[4] < 2e-3 && missing[4] > -1e-9, "{missing:?}");
}

#[test]
fn a_surface_constrained_as_a_whole_deforms_as_if_it_were_free() {
    // A load in equilibrium: whatever holds the body without straining it, it strains alike.
    let model = ring(Cell::Hexahedron, 2, [1.0, SEAT], [8, 1, 1]);
    let pressed = model.mesh.face_set("outside").expect("named");
    let load = model.face_load(pressed, |point| {
        let [x, y, z] = point.position;
        let wave = 1e6 * (x * x - y * y) * (1.0 + z * z);
        point.normal.map(|part| part * wave)
    });
    let inside = nodes(&model, "inside");
    let mut sets = DofSets::new(vec![&model]);
    // As many terms as the nodes can follow: the surface deforms as it likes.
    let surface = RevolutionSurface::cylinder(1.0, [-HALF, HALF]);
    sets.series("bore", Series::new(surface, 7, 2).expect("it has an extent")).expect("new");
    sets.attach("bore", 0, &inside).expect("free").constrain_rigid_motion("bore").expect("named");
    let reduced = sets.reduce();
    let solver = Solver::new(&reduced.stiffness(), reduced.constraints().clone()).expect("held as a whole");
    let full = reduced.load(0, &load).to_full(reduced.count());
    let energy = load.dot(&reduced.displacements(0, &solver.solve_one(&full).expect("there is memory")));

    // Three points, six displacements.
    let at = |x: f64, y: f64| {
        let near = |&&node: &&usize| {
            let [a, b, z] = model.mesh.nodes[node];
            (a - x).abs() + (b - y).abs() + (z + HALF).abs() < 1e-9
        };
        *inside.iter().find(near).expect("a node")
    };
    let mut constraints = Constraints::new();
    let [east, west, north] = [at(1.0, 0.0), at(-1.0, 0.0), at(0.0, 1.0)];
    for dof in [3 * east, 3 * east + 1, 3 * east + 2, 3 * west + 1, 3 * west + 2, 3 * north + 2] {
        constraints.prescribe(dof, 0.0);
    }
    let solver = Solver::new(&model.stiffness(), constraints).expect("held");
    let free = load.dot(&solver.solve_one(&load.to_full(model.dof_count())).expect("there is memory"));
    // The sine of eight harmonics is zero at all sixteen nodes, and the series omits its cosine,
    // which has a small stiffness.
    assert!((energy / free - 1.0).abs() < 1e-4 && energy <= free * (1.0 + 1e-9), "{energy} is not {free}");
}

#[test]
fn a_rigid_region_turns_its_nodes() {
    let model = ring(Cell::Hexahedron, 2, [1.0, SEAT], [6, 1, 1]);
    let (bore, outside) = (nodes(&model, "inside"), nodes(&model, "outside"));
    let (center, turn, shift) = ([0.2, 0.1, 0.0], [1e-4, -2e-4, 3e-4], [1e-5, 2e-5, -1e-5]);
    let mut sets = DofSets::new(vec![&model]);
    sets.rigid("race", center).expect("new").attach("race", 0, &bore).expect("free");
    sets.constrain("race", |kind| match *kind {
        DofKind::Translation(axis) => Some(shift[axis]),
        DofKind::Rotation(axis) => Some(turn[axis]),
        _ => None,
    })
    .expect("named");
    sets.nodes("rim", 0, &outside).expect("free").constrain("rim", |_| Some(0.0)).expect("named");
    let reduced = sets.reduce();
    let solver = Solver::new(&reduced.stiffness(), reduced.constraints().clone()).expect("held");
    let found =
        reduced.displacements(0, &solver.solve_one(&vec![0.0; reduced.count()]).expect("there is memory"));

    let mut constraints = Constraints::new();
    for &node in &outside {
        (0..3).for_each(|axis| {
            constraints.prescribe(3 * node + axis, 0.0);
        });
    }
    for &node in &bore {
        let [x, y, z] = [0, 1, 2].map(|axis| model.mesh.nodes[node][axis] - center[axis]);
        let turned = [turn[1] * z - turn[2] * y, turn[2] * x - turn[0] * z, turn[0] * y - turn[1] * x];
        for axis in 0..3 {
            constraints.prescribe(3 * node + axis, shift[axis] + turned[axis]);
        }
    }
    let exact = crate::solid::solve(&model, constraints, &vec![0.0; model.dof_count()]);
    for (found, exact) in found.iter().zip(&exact) {
        assert!((found - exact).abs() < 1e-16, "{found} is not {exact}");
    }
}

#[test]
fn sets_that_cannot_be_are_refused() {
    let model = ring(Cell::Hexahedron, 1, [1.0, SEAT], [6, 1, 1]);
    let mut sets = DofSets::new(vec![&model]);
    sets.nodes("bore", 0, &[0, 1]).expect("free");
    let name = || "bore".to_owned();
    assert_eq!(sets.rigid("bore", [0.0; 3]).err(), Some(DofError::Taken { name: name() }));
    assert_eq!(sets.attach("rim", 0, &[5]).err(), Some(DofError::NoSet { name: "rim".to_owned() }));
    assert_eq!(sets.attach("bore", 0, &[9999]).err(), Some(DofError::NoNode { part: 0, node: 9999 }));
    assert_eq!(sets.attach("bore", 3, &[1]).err(), Some(DofError::NoNode { part: 3, node: 1 }));
    let twice = DofError::Twice { part: 0, node: 1, first: name(), second: "race".to_owned() };
    assert_eq!(sets.rigid("race", [0.0; 3]).expect("new").attach("race", 0, &[1]).err(), Some(twice));
    assert!(Series::new(RevolutionSurface::cylinder(0.0, [0.0, 1.0]), 2, 1).is_none());
    assert!(Series::new(RevolutionSurface::cylinder(1.0, [1.0, 1.0]), 2, 1).is_none());
    let component = Component::Radial;
    assert!(seat(2, 1).terms().iter().any(|term| term.component == component && term.sine));
}
