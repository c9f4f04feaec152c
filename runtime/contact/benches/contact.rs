//! The contact solver, cold and warm, against Clarabel on the same problem: a Hertzian patch of n
//! cells, of which about three quarters are loaded. Prints ratios, which are comparable between
//! machines; times are not.

use calyx_contact::active_set::solve;
use calyx_contact::half_plane::HalfPlane;
use calyx_contact::interior_point;
use calyx_contact::problem::ContactProblem;
use std::hint::black_box;
use std::time::Instant;

fn main() {
    println!("{:>6} {:>12} {:>14} {:>14}", "cells", "cold, ms", "cold/Clarabel", "warm/Clarabel");
    for n in [100, 300, 1000] {
        let problem = patch(n, 1.0);
        // From the active set of a load 2 % smaller, as from the step before.
        let before = solve(&patch(n, 0.98), None).map(|solution| solution.active).unwrap_or_default();
        let cold = fastest(10, || solve(black_box(&problem), None).is_ok());
        let warm = fastest(10, || solve(black_box(&problem), Some(&before)).is_ok());
        let clarabel = fastest(2, || interior_point::solve(black_box(&problem)).is_ok());
        println!("{n:>6} {:>12.3} {:>14.4} {:>14.4}", 1e3 * cold, cold / clarabel, warm / clarabel);
    }
}

/// Seconds of the fastest of some runs: the one least disturbed.
fn fastest(runs: usize, run: impl Fn() -> bool) -> f64 {
    (0..runs)
        .map(|_| {
            let start = Instant::now();
            assert!(black_box(run()), "a solution exists");
            start.elapsed().as_secs_f64()
        })
        .fold(f64::INFINITY, f64::min)
}

/// Steel on steel, radius 33 mm, on a grid 1.3 times as wide as the contact at load 1.
fn patch(n: usize, load: f64) -> ContactProblem {
    let body = HalfPlane { surface_modulus: 226e9, reference_length: 1.0 };
    let (grid, curvature, force) = (1.13e-3, 30.0, 5e5 * load);
    let bound = |i: usize| grid * (i as f64 / n as f64 - 0.5);
    let cell = |i: usize| [bound(i), bound(i + 1)];
    ContactProblem {
        compliance: (0..n * n).map(|e| 2.0 * body.cell_compliance(cell(e / n), cell(e % n))).collect(),
        arms: vec![1.0; n],
        gaps: (0..n).map(|i| 0.5 * curvature * (0.5 * (bound(i) + bound(i + 1))).powi(2)).collect(),
        stiffness: vec![0.0],
        load: vec![-force],
    }
}
