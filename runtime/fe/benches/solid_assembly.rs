//! Times of the setup of a swept mesh of the size of a gear's sector: stiffness, mass, loads, rows
//! of recovered stress. They are printed relative to the time of the element matrices' products (`H
//! = G G'`) in the same run on one thread, because ratios are comparable between machines.

use calyx_fe::material::Material;
use calyx_fe::solid::{SolidMesh, SolidModel, SurfaceStressRecovery};
use calyx_fe::{Block, Curve, ElementOrder, MeshBuilder, uniform};
use calyx_fe::{Side, SparseVector};
use faer::linalg::matmul::triangular::{BlockStructure, matmul};
use faer::{Accum, Mat, Par};
use std::hint::black_box;
use std::time::Instant;

fn main() {
    println!(
        "{:>28} {:>8} {:>13} {:>10} {:>6} {:>10} {:>11}",
        "elements", "unknowns", "products, ms", "stiffness", "mass", "1000 loads", "1000 stresses"
    );
    for (across, along, layers, order) in [(10, 5, 4, 2), (10, 5, 4, 3), (16, 12, 4, 3), (16, 12, 8, 3)] {
        let model = sector(across, along, layers, order);
        let elements = model.mesh.elements.len();
        let nodes = model.mesh.elements[0].nodes.len();
        let points = [order + order.div_ceil(2); 2].map(|points| points.max(order + 1));
        let points = points[0] * points[0] * points[1];
        let gradients = Mat::from_fn(3 * nodes, points, |row, column| ((row * 7 + column * 3) % 11) as f64);
        let products = fastest(3, || {
            let mut sums = Mat::<f64>::zeros(3 * nodes, 3 * nodes);
            for _ in 0..elements {
                matmul(
                    sums.as_mut(),
                    BlockStructure::TriangularLower,
                    Accum::Add,
                    black_box(gradients.as_ref()),
                    BlockStructure::Rectangular,
                    gradients.transpose(),
                    BlockStructure::Rectangular,
                    1.0,
                    Par::Seq,
                );
            }
            sums[(0, 0)]
        });
        let stiffness = fastest(3, || model.stiffness().val()[0]);
        let mass = fastest(3, || model.mass().val()[0]);
        let set = model.mesh.face_set("flank").expect("named");
        let [from, to] = set.chart.as_ref().expect("charted").s_range();
        // As wide as a matching depth of a third of the flank, a tenth of the face.
        let at = |k: usize| from + (0.2 + 0.006 * k as f64) * (to - from);
        let loads = fastest(3, || {
            let width = [0.15 * (to - from), 1.3e-3];
            let load = |k: usize| {
                let support = [[at(k) - width[0], at(k) + width[0]], [-width[1], width[1]]];
                model.face_load_between(set, support, |s, z, point| point.normal.map(|part| part * (s + z)))
            };
            (0..100).map(|k| load(k).map_or(0.0, |load: SparseVector| load.entries[0].1)).sum::<f64>()
        });
        let recovery = SurfaceStressRecovery::new(&model).expect("swept");
        let stresses = fastest(3, || {
            (0..100)
                .map(|k| recovery.rows(set, at(k), 1e-3).map_or(0.0, |rows| rows.rows[0].entries[0].1))
                .sum::<f64>()
        });
        println!(
            "{:>28} {:>8} {:>13.1} {:>10.2} {:>6.2} {:>10.2} {:>11.2}",
            format!("{across} x {along} x {layers}, order {order}"),
            model.dof_count(),
            1e3 * products,
            stiffness / products,
            mass / products,
            10.0 * loads / products,
            10.0 * stresses / products,
        );
    }
}

/// Seconds of the fastest of some runs: the one least disturbed.
fn fastest(runs: usize, run: impl Fn() -> f64) -> f64 {
    (0..runs)
        .map(|_| {
            let start = Instant::now();
            black_box(run());
            start.elapsed().as_secs_f64()
        })
        .fold(f64::INFINITY, f64::min)
}

/// A twisted sector of a ring 25 mm wide.
fn sector(across: usize, along: usize, layers: usize, order: usize) -> SolidModel {
    let (inner, outer, angle) = (0.02, 0.03, 0.3);
    let end = |angle: f64| [inner, outer].map(|radius| [radius * f64::cos(angle), radius * f64::sin(angle)]);
    let ([a, b], [d, c]) = (end(0.0), end(angle));
    let block = Block::new(
        Curve::line(a, b),
        Curve::arc([0.0; 2], outer, 0.0, angle),
        Curve::line(d, c),
        Curve::arc([0.0; 2], inner, 0.0, angle),
    )
    .divided(uniform(along), uniform(across))
    .on_profile(Side::Right, "flank", [0.0, outer * angle]);
    let section = MeshBuilder::new().block(block).finish(ElementOrder::full(order as u8)).expect("one block");
    let stations = uniform(layers).into_iter().map(|part| 0.025 * (part - 0.5)).collect::<Vec<_>>();
    let place = |[x, y]: [f64; 2], z: f64| {
        let (sin, cos) = (14.0 * z).sin_cos();
        [x * cos - y * sin, x * sin + y * cos, z]
    };
    SolidModel::new(SolidMesh::swept(&section, &stations, order, &place).expect("sound"), Material::STEEL)
}
