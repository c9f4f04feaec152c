//! Exact solutions approached at the rates of theory: energy 2p, displacement p + 1, stress p.

use crate::plane::MATERIAL;
use calyx_fe::material::Plane;
use calyx_fe::{
    Block, Constraints, Curve, ElementOrder, ElementPoint, MeshBuilder, PlaneModel, Side, Solver,
    StressRecovery, quadrature::gauss_legendre, uniform,
};
use std::f64::consts::FRAC_PI_2;

/// Observed orders may miss those of theory by this.
const SLACK: f64 = 0.25;

/// E and nu that make the formulas of plane stress those of the plane.
fn plane_constants(plane: Plane) -> (f64, f64) {
    let (e, nu) = (MATERIAL.youngs_modulus, MATERIAL.poissons_ratio);
    match plane {
        Plane::Stress => (e, nu),
        Plane::Strain => (e / (1.0 - nu * nu), nu / (1.0 - nu)),
    }
}

/// Relative errors of a solution.
#[derive(Clone, Copy, Debug)]
struct Errors {
    /// Energy of the error.
    energy: f64,
    displacement: f64,
    stress: f64,
    /// Smoothed stress along a surface, the worst of some points.
    surface: f64,
}

type Field<'a, const N: usize> = &'a dyn Fn([f64; 2]) -> [f64; N];

fn errors(
    model: &PlaneModel,
    solved: &[f64],
    displacement: Field<'_, 2>,
    stress: Field<'_, 3>,
    surface: &str,
) -> Errors {
    let mesh = &model.mesh;
    let (e, nu) = plane_constants(model.plane);
    let energy_of = |[xx, yy, xy]: [f64; 3]| {
        (xx * xx + yy * yy - 2.0 * nu * xx * yy + 2.0 * (1.0 + nu) * xy * xy) / (2.0 * e)
    };
    let size = |parts: &[f64]| parts.iter().map(|part| part * part).sum::<f64>();
    let (mut wrong, mut whole) = ([0.0; 3], [0.0; 3]);
    for (index, element) in mesh.elements.iter().enumerate() {
        let rule = gauss_legendre(usize::from(element.order.highest()) + 3);
        for (xi, eta, weight) in rule.iter().flat_map(|a| rule.iter().map(move |b| (a.0, b.0, a.1 * b.1))) {
            let place = ElementPoint { element: index, xi, eta };
            let [[a, b], [c, d]] = mesh.jacobian(place);
            let (at, weight) = (mesh.position(place), weight * (a * d - b * c));
            let (u, sigma) = (displacement(at), stress(at));
            let (found_u, found) = (model.displacement(place, solved), model.stress(place, solved));
            let sigma_error = [0, 1, 2].map(|part| found[part] - sigma[part]);
            wrong[0] += weight * energy_of(sigma_error);
            wrong[1] += weight * size(&[found_u[0] - u[0], found_u[1] - u[1]]);
            wrong[2] += weight * size(&sigma_error);
            whole[0] += weight * energy_of(sigma);
            whole[1] += weight * size(&u);
            whole[2] += weight * size(&sigma);
        }
    }
    let recovery = StressRecovery::new(model);
    let chain = mesh.chain(surface).expect("named");
    let [start, end] = chain.range();
    let (mut worst, mut largest) = (0.0_f64, 0.0_f64);
    for part in 1..20 {
        let s = start + (end - start) * f64::from(part) / 20.0;
        let point = mesh.chain_point(chain, s).expect("on the chain");
        let [x, y] = point.tangent;
        let [xx, yy, xy] = stress(point.position);
        let exact = x * x * xx + y * y * yy + 2.0 * x * y * xy;
        let found = recovery.surface_row(chain, s).expect("on the chain").dot(solved);
        worst = worst.max((found - exact).abs());
        largest = largest.max(exact.abs());
    }
    Errors {
        energy: wrong[0] / whole[0],
        displacement: (wrong[1] / whole[1]).sqrt(),
        stress: (wrong[2] / whole[2]).sqrt(),
        surface: worst / largest,
    }
}

/// Solves on meshes refined by two and compares observed orders with theory.
fn check_rates(name: &str, order: u8, coarsest: usize, solve: impl Fn(usize) -> Errors) {
    let runs = [1, 2, 4].map(|refined| solve(coarsest * refined));
    for pair in runs.windows(2) {
        let rate = |of: fn(&Errors) -> f64| (of(&pair[0]) / of(&pair[1])).log2();
        let p = f64::from(order);
        let observed = [
            ("energy", rate(|e| e.energy), 2.0 * p),
            ("displacement", rate(|e| e.displacement), p + 1.0),
            ("stress", rate(|e| e.stress), p),
        ];
        for (quantity, rate, theory) in observed {
            assert!(
                (rate - theory).abs() < SLACK,
                "{name} p = {order}: {quantity} at {rate:.3}, not {theory}"
            );
        }
    }
    // Smoothing must not lose an order; where it gains one, it may.
    let rate = 0.5 * (runs[0].surface / runs[2].surface).log2();
    assert!(rate > f64::from(order) - SLACK, "{name} p = {order}: surface stress at {rate:.3}");
}

/// Lamé: a quarter of a cylinder of radii 1 and 2 under internal pressure.
fn cylinder(order: u8, plane: Plane, divisions: usize) -> Errors {
    let (inner, outer, pressure) = (1.0, 2.0, 1e6);
    let block = Block::new(
        Curve::line([inner, 0.0], [outer, 0.0]),
        Curve::arc([0.0; 2], outer, 0.0, FRAC_PI_2),
        Curve::line([0.0, inner], [0.0, outer]),
        Curve::arc([0.0; 2], inner, 0.0, FRAC_PI_2),
    )
    .divided(uniform(divisions), uniform(divisions))
    .named(Side::Bottom, "on_x")
    .named(Side::Top, "on_y")
    .on_profile(Side::Left, "bore", [0.0, inner * FRAC_PI_2]);
    let mesh = MeshBuilder::new().block(block).finish(ElementOrder::full(order)).expect("one block");
    let model = PlaneModel::new(mesh, MATERIAL, plane);
    let mesh = &model.mesh;
    let mut constraints = Constraints::new();
    for node in mesh.chain_nodes(mesh.chain("on_x").expect("named")) {
        constraints.prescribe(2 * node + 1, 0.0);
    }
    for node in mesh.chain_nodes(mesh.chain("on_y").expect("named")) {
        constraints.prescribe(2 * node, 0.0);
    }
    let load = model.edge_load(mesh.chain("bore").expect("named"), |s, _| {
        let (sin, cos) = (s / inner).sin_cos();
        [pressure * cos, pressure * sin]
    });
    let solver = Solver::new(&model.stiffness(), constraints).expect("held");
    let solved = solver.solve_one(&load.to_full(model.dof_count())).expect("solves");

    let (e, nu) = plane_constants(plane);
    let share = pressure * inner * inner / (outer * outer - inner * inner);
    let displacement = |[x, y]: [f64; 2]| {
        let square = x * x + y * y;
        [x, y].map(|part| part * share / e * ((1.0 - nu) + (1.0 + nu) * outer * outer / square))
    };
    let stress = |[x, y]: [f64; 2]| {
        let square = x * x + y * y;
        let differing = share * outer * outer / square;
        let (cos2, sin2) = ((x * x - y * y) / square, 2.0 * x * y / square);
        [share - differing * cos2, share + differing * cos2, -differing * sin2]
    };
    errors(&model, &solved, &displacement, &stress, "bore")
}

/// Cantilever with a parabolic shear load at its end (Timoshenko and Goodier, Theory of Elasticity,
/// art. 21).
fn cantilever(order: u8, plane: Plane, divisions: usize) -> Errors {
    // Short: in a slender beam the displacement first converges with the energy, faster than p + 1.
    let (length, depth, force) = (1.0, 1.0, 1e6);
    let (e, nu) = plane_constants(plane);
    let inertia = depth * depth * depth / 12.0;
    let half = 0.5 * depth;
    let displacement = |[x, y]: [f64; 2]| {
        let scale = force / (6.0 * e * inertia);
        [
            -scale * y * ((6.0 * length - 3.0 * x) * x + (2.0 + nu) * (y * y - half * half)),
            scale
                * (3.0 * nu * y * y * (length - x)
                    + (4.0 + 5.0 * nu) * half * half * x
                    + (3.0 * length - x) * x * x),
        ]
    };
    let stress = |[x, y]: [f64; 2]| {
        [-force * (length - x) * y / inertia, 0.0, 0.5 * force * (half * half - y * y) / inertia]
    };
    // The solution is a cubic: only a curvilinear mesh leaves cubic elements an error to converge.
    let curved = move |u: f64, v: f64| {
        let wave = 0.08 * (2.0 * std::f64::consts::PI * u).sin() * (2.0 * std::f64::consts::PI * v).sin();
        [length * (u + wave), depth * (v + wave) - half]
    };
    let corners = [[0.0, -half], [length, -half], [length, half], [0.0, half]];
    let block = Block::quadrilateral(corners)
        .divided(uniform(divisions), uniform(divisions))
        .mapped(curved)
        .named(Side::Left, "wall")
        .named(Side::Right, "end")
        .named(Side::Top, "top");
    let mesh = MeshBuilder::new().block(block).finish(ElementOrder::full(order)).expect("one block");
    let model = PlaneModel::new(mesh, MATERIAL, plane);
    let mesh = &model.mesh;
    let mut constraints = Constraints::new();
    for node in mesh.chain_nodes(mesh.chain("wall").expect("named")) {
        constraints.prescribe_node(node, displacement(mesh.nodes[node]));
    }
    let load = model.edge_load(mesh.chain("end").expect("named"), |_, point| {
        let [xx, _, xy] = stress(point.position);
        [xx, xy]
    });
    let solver = Solver::new(&model.stiffness(), constraints).expect("held");
    let solved = solver.solve_one(&load.to_full(model.dof_count())).expect("solves");
    errors(&model, &solved, &displacement, &stress, "top")
}

#[test]
fn thick_cylinder() {
    for order in 1..=3 {
        for plane in [Plane::Strain, Plane::Stress] {
            check_rates(&format!("cylinder {plane:?}"), order, 4, |divisions| {
                cylinder(order, plane, divisions)
            });
        }
    }
}

#[test]
fn end_loaded_cantilever() {
    for (order, coarsest, plane) in [(1, 8, Plane::Stress), (2, 8, Plane::Strain), (3, 6, Plane::Stress)] {
        check_rates(&format!("cantilever {plane:?}"), order, coarsest, |divisions| {
            cantilever(order, plane, divisions)
        });
    }
}
