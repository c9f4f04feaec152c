//! Exact solutions approached at the rates of theory: energy 2p, displacement p + 1, stress p.

use crate::solid::shapes::{Kind, cube, kinds};
use crate::solid::{MATERIAL, dot, solve};
use calyx_fe::Constraints;
use calyx_fe::material::Material;
use calyx_fe::solid::{SolidElementPoint, SolidModel};
use std::collections::BTreeSet;

/// Observed orders may miss those of theory by this.
const SLACK: f64 = 0.3;

pub type Map<'a> = &'a dyn Fn([f64; 3]) -> [f64; 3];
pub type Stress<'a> = &'a dyn Fn([f64; 3]) -> [f64; 6];

/// A body with its exact solution.
pub struct Problem<'a> {
    /// Map of the unit cube.
    pub shape: Map<'a>,
    pub displacement: Map<'a>,
    pub stress: Stress<'a>,
    /// Axes along which the displacement is prescribed on each face of the unit cube (at x = 0, x =
    /// 1, y = 0 ... z = 1). Tractions act along the others.
    pub constrained: [&'a [usize]; 6],
    pub material: Material,
}

/// Relative errors of a solution.
struct Errors {
    energy: f64,
    displacement: f64,
    stress: f64,
}

/// Solves on the unit cube's image; tractions and displacements are those of the exact solution.
pub fn solved(problem: &Problem<'_>, kind: Kind, divisions: [usize; 3]) -> (SolidModel, Vec<f64>) {
    // Named while straight, then bent: the faces are the same.
    let straight = cube(kind, 1, divisions, &|at| at);
    let mesh = cube(kind, kind.order(), divisions, problem.shape);
    let model = SolidModel::new(mesh, problem.material);
    let mut load = vec![0.0; model.dof_count()];
    let mut constrained = BTreeSet::new();
    for face in straight.boundary() {
        let cell = straight.elements[face.element].interpolation.cell();
        let at = if cell.is_triangle(face.face) { [0.3, 0.3] } else { [0.0; 2] };
        let normal = straight.face_point(face, at).normal;
        let axis = (0..3).find(|&axis| normal[axis].abs() > 0.9).expect("a face of the cube");
        let side = 2 * axis + usize::from(normal[axis] > 0.0);
        if problem.constrained[side].is_empty() {
            let set = calyx_fe::solid::FaceSet { faces: vec![face], chart: None };
            let traction = |position, normal| crate::solid::traction((problem.stress)(position), normal);
            model.face_load(&set, |point| traction(point.position, point.normal)).add_to(1.0, &mut load);
        } else {
            let element = &model.mesh.elements[face.element];
            for local in element.interpolation.face_nodes(face.face) {
                constrained
                    .extend(problem.constrained[side].iter().map(|&axis| (element.nodes[local], axis)));
            }
        }
    }
    let mut constraints = Constraints::new();
    for (node, axis) in constrained {
        constraints.prescribe(3 * node + axis, (problem.displacement)(model.mesh.nodes[node])[axis]);
    }
    let displacements = solve(&model, constraints, &load);
    (model, displacements)
}

fn errors(problem: &Problem<'_>, kind: Kind, divisions: [usize; 3]) -> Errors {
    let (model, solved) = solved(problem, kind, divisions);
    let [_, mu] = model.lame();
    let (e, nu) = (problem.material.youngs_modulus, problem.material.poissons_ratio);
    let energy_of = |s: [f64; 6]| {
        let direct = s[0] * s[0] + s[1] * s[1] + s[2] * s[2];
        let mixed = s[0] * s[1] + s[1] * s[2] + s[2] * s[0];
        (direct - 2.0 * nu * mixed) / (2.0 * e) + (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]) / (2.0 * mu)
    };
    let square = |parts: &[f64]| parts.iter().map(|part| part * part).sum::<f64>();
    let (mut wrong, mut whole) = ([0.0; 3], [0.0; 3]);
    for (index, element) in model.mesh.elements.iter().enumerate() {
        let [p, q] = element.interpolation.highest().map(|order| usize::from(order) + 3);
        for (local, weight) in element.interpolation.cell().quadrature([p, q]) {
            let place = SolidElementPoint { element: index, local };
            let [a, b, c] = model.mesh.jacobian(place);
            let cross = [b[1] * c[2] - b[2] * c[1], b[2] * c[0] - b[0] * c[2], b[0] * c[1] - b[1] * c[0]];
            let weight = weight * dot(a, cross);
            let at = model.mesh.position(place);
            let (u, sigma) = ((problem.displacement)(at), (problem.stress)(at));
            let (found_u, found) = (model.displacement(place, &solved), model.stress(place, &solved));
            let off: [f64; 6] = std::array::from_fn(|part| found[part] - sigma[part]);
            let u_off: [f64; 3] = std::array::from_fn(|part| found_u[part] - u[part]);
            for (sums, values) in [
                (&mut wrong, [energy_of(off), square(&u_off), square(&off)]),
                (&mut whole, [energy_of(sigma), square(&u), square(&sigma)]),
            ] {
                for (sum, value) in sums.iter_mut().zip(values) {
                    *sum += weight * value;
                }
            }
        }
    }
    Errors {
        energy: wrong[0] / whole[0],
        displacement: (wrong[1] / whole[1]).sqrt(),
        stress: (wrong[2] / whole[2]).sqrt(),
    }
}

/// Solves on two meshes, the second twice as fine, and compares the observed orders with theory.
fn check_rates(name: &str, problem: &Problem<'_>, divisions: impl Fn(u8) -> [usize; 3]) {
    for kind in kinds() {
        let coarse = divisions(kind.order());
        let runs = [1, 2].map(|finer| errors(problem, kind, coarse.map(|count| count * finer)));
        let p = f64::from(kind.order());
        let rates = [
            // A square, in which the order misses by twice as much.
            ("energy", runs[0].energy / runs[1].energy, 2.0 * p, 2.0 * SLACK),
            ("displacement", runs[0].displacement / runs[1].displacement, p + 1.0, SLACK),
            ("stress", runs[0].stress / runs[1].stress, p, SLACK),
        ];
        println!(
            "{name} {kind:?}: stress error {:.2e}, rates {:?}",
            runs[1].stress,
            rates.map(|rate| rate.1.log2())
        );
        for (quantity, ratio, theory, slack) in rates {
            let rate = ratio.log2();
            // Theory does not promise one order more. If the order along or across is higher, the
            // rate may be higher, too.
            let faster = matches!(kind, Kind::Swept(section, axial) if section != axial);
            assert!(
                rate > theory - slack && (faster || rate < theory + 1.0),
                "{name} {kind:?}: {quantity} at {rate:.3}, not {theory}"
            );
        }
    }
}

/// All axes.
const ALL: &[usize] = &[0, 1, 2];

/// A part of a sphere of radii 1 and 1.5 under internal pressure, held as the rest of it would.
pub fn sphere(material: Material) -> Problem<'static> {
    let Material { youngs_modulus: e, poissons_ratio: nu, .. } = material;
    let pressure = 1e6;
    let outer = 1.5_f64.powi(3);
    let share = pressure / (outer - 1.0);
    let displacement = move |at: [f64; 3]| {
        let cube = dot(at, at).powf(1.5);
        at.map(|part| part * share / e * ((1.0 - 2.0 * nu) + 0.5 * (1.0 + nu) * outer / cube))
    };
    let stress = move |at: [f64; 3]| {
        let square = dot(at, at);
        let cube = square.powf(1.5);
        let (radial, hoop) = (share * (1.0 - outer / cube), share * (1.0 + 0.5 * outer / cube));
        let part = |a: usize, b: usize| {
            let both = at[a] * at[b] / square;
            both * radial + if a == b { (1.0 - both) * hoop } else { -both * hoop }
        };
        [part(0, 0), part(1, 1), part(2, 2), part(1, 2), part(2, 0), part(0, 1)]
    };
    let shape = |[u, v, w]: [f64; 3]| {
        let direction = [0.6 * u - 0.1, 0.5 * v, 1.0];
        let length = dot(direction, direction).sqrt();
        direction.map(|part| part * (1.0 + 0.5 * w) / length)
    };
    Problem {
        shape: Box::leak(Box::new(shape)),
        displacement: Box::leak(Box::new(displacement)),
        stress: Box::leak(Box::new(stress)),
        constrained: [ALL, ALL, ALL, ALL, &[], &[]],
        material,
    }
}

/// Quarter of a cylinder with radii 1 and 1.5 under internal pressure. It slides in its planes of
/// symmetry and keeps its length.
pub fn cylinder(material: Material) -> Problem<'static> {
    let Material { youngs_modulus: e, poissons_ratio: nu, .. } = material;
    let pressure = 1e6;
    let outer = 1.5_f64.powi(2);
    let share = pressure / (outer - 1.0);
    let displacement = move |[x, y, _]: [f64; 3]| {
        let factor = share * (1.0 + nu) / e * ((1.0 - 2.0 * nu) + outer / (x * x + y * y));
        [x * factor, y * factor, 0.0]
    };
    let stress = move |[x, y, _]: [f64; 3]| {
        let square = x * x + y * y;
        let (mean, differing) = (share, share * outer / square);
        let (cos2, sin2) = ((x * x - y * y) / square, 2.0 * x * y / square);
        [mean - differing * cos2, mean + differing * cos2, 2.0 * nu * mean, 0.0, 0.0, -differing * sin2]
    };
    // Graded along the axis, so that its elements are not all alike.
    let shape = |[u, v, w]: [f64; 3]| {
        let angle = std::f64::consts::FRAC_PI_2 * v;
        [(1.0 + 0.5 * u) * angle.cos(), (1.0 + 0.5 * u) * angle.sin(), w * (0.4 + 0.1 * w)]
    };
    Problem {
        shape: Box::leak(Box::new(shape)),
        displacement: Box::leak(Box::new(displacement)),
        stress: Box::leak(Box::new(stress)),
        constrained: [&[], &[], &[1], &[0], &[2], &[2]],
        material,
    }
}

#[test]
fn lame_sphere() {
    check_rates("sphere", &sphere(MATERIAL), |order| if order == 1 { [4, 4, 4] } else { [2, 2, 2] });
}

#[test]
fn lame_cylinder() {
    check_rates("cylinder", &cylinder(MATERIAL), |order| {
        [[4, 8, 1], [3, 6, 1], [3, 5, 1]][usize::from(order) - 1]
    });
}

/// Relative error of the deflection at the end of a cantilever of unit depth and width and
/// `length`. A shear force acts there, and Poisson's ratio is zero, so the plane solution is exact
/// (Timoshenko and Goodier, Theory of Elasticity, art. 21).
fn cantilever(kind: Kind, length: f64, divisions: [usize; 3]) -> f64 {
    let material = Material { poissons_ratio: 0.0, ..MATERIAL };
    let e = material.youngs_modulus;
    // Inertia 1/12, half depth 1/2; x from the loaded end, depth along y.
    let (force, inertia, shear) = (1e3, 1.0 / 12.0, 0.5 * e);
    let displacement = move |[x, y, _]: [f64; 3]| {
        let (ei, gi) = (e * inertia, shear * inertia);
        // The axis of the end x = length neither moves nor turns.
        let u = -force * x * x * y / (2.0 * ei)
            + force * y.powi(3) / (6.0 * gi)
            + (force * length * length / (2.0 * ei) - force * 0.25 / (2.0 * gi)) * y;
        let v = force * x.powi(3) / (6.0 * ei) - force * length * length * x / (2.0 * ei)
            + force * length.powi(3) / (3.0 * ei);
        [u, v, 0.0]
    };
    let stress = move |[x, y, _]: [f64; 3]| {
        [-force * x * y / inertia, 0.0, 0.0, 0.0, 0.0, -force / (2.0 * inertia) * (0.25 - y * y)]
    };
    let problem = Problem {
        shape: &|[u, v, w]| [length * u, v - 0.5, w],
        displacement: &displacement,
        stress: &stress,
        constrained: [&[], ALL, &[], &[], &[], &[]],
        material,
    };
    let (model, solved) = solved(&problem, kind, divisions);
    let tip = |&(_, at): &(usize, &[f64; 3])| at[0].abs() < 1e-9;
    let on_end = model.mesh.nodes.iter().enumerate().filter(tip).collect::<Vec<_>>();
    let sum =
        |of: &dyn Fn(usize, [f64; 3]) -> f64| on_end.iter().map(|&(node, &at)| of(node, at)).sum::<f64>();
    sum(&|node, _| solved[3 * node + 1]) / sum(&|_, at| displacement(at)[1]) - 1.0
}

#[test]
fn cantilevers_thick_and_thin() {
    // Elements along the beam and error of the end deflection: the table changes with any change of
    // an element.
    let mut table = Vec::new();
    for kind in kinds() {
        let errors = [2.0, 20.0, 100.0].map(|length| cantilever(kind, length, [4, 1, 1]));
        println!("cantilever {kind:?}: {errors:.5?}");
        table.push((kind, errors));
    }
    for (kind, [thick, thin, thinnest]) in table {
        match kind.order() {
            // Linear elements lock in shear: the thinner, the stiffer.
            1 if !matches!(kind, Kind::Swept(2.., _)) => {
                assert!(thick < -0.05 && thin < -0.75 && thinnest < -0.98, "{kind:?} does not lock");
            }
            1 => {}
            2 => assert!(thick.abs() < 0.06 && thin.abs() < 0.25, "{kind:?}: {thick} {thin}"),
            _ => assert!(
                thick.abs() < 1e-9 && thin.abs() < 1e-7 && thinnest.abs() < 1e-6,
                "{kind:?}: {thick} {thin}"
            ),
        }
    }
}

#[test]
fn nearly_incompressible_limit() {
    // Relative L2 error of the displacement of a cylinder under pressure as Poisson's ratio
    // approaches 1/2. Linear elements lock, quadratic ones lose their accuracy, cubic ones most of
    // it. The table is in the documentation of `fe::solid`.
    let ratios = [0.3, 0.49, 0.499, 0.4999, 0.49999];
    for kind in kinds() {
        let divisions = if kind.order() == 1 { [4, 8, 1] } else { [2, 4, 1] };
        let found = ratios.map(|nu| {
            errors(&cylinder(Material { poissons_ratio: nu, ..MATERIAL }), kind, divisions).displacement
        });
        println!("incompressible {kind:?}: {:?}", found.map(|error| format!("{error:.1e}")));
        let in_section = match kind {
            Kind::Cells(_, order) | Kind::Swept(order, _) => order,
        };
        // At 0.3 and at 0.4999: at most, at least, at most.
        let [compressible, locked, limit] =
            [[2e-2, 1e-1, 1.0], [2e-3, 3e-2, 2e-1], [5e-5, 0.0, 2e-3]][usize::from(in_section) - 1];
        assert!(found[0] < compressible, "{kind:?}: {:e}", found[0]);
        assert!(found[3] > locked && found[3] < limit, "{kind:?}: {:e}", found[3]);
    }
}
