//! Three-dimensional contact on grids of up to some thousand cells: a crowned cylinder between free
//! side faces. Prints the times of the grid, its compliance and the solution as fractions of one
//! dense factorization of that size, which every solution needs.

use calyx_contact::active_set::solve_until;
use calyx_contact::problem::ContactProblem;
use calyx_contact::solid::{
    Entries, Grid, GridOptions, GridSize, PatchCells, PlacedSurface, Pose, Side, build_grid, compliance,
    find_contact_line, first_guess,
};
use calyx_numerics::interrupt::Interrupt;
use calyx_structure::Chart;
use calyx_structure::solid::{HalfSpaceBody, Mirror};
use calyx_structure::surface::{Surface, SurfacePoint};
use faer::Mat;
use faer::linalg::solvers::Llt;
use std::hint::black_box;
use std::time::Instant;

const MODULUS: f64 = 1.1e11;
const FORCE: f64 = 5000.0;

fn main() {
    println!(
        "{:>6} {:>14} {:>10} {:>8} {:>12} {:>10} {:>10} {:>10}",
        "cells", "factor, ms", "ridge", "grid", "compliance", "guess", "guessed", "cold"
    );
    for (half_count, half_slices) in [(8, 8), (12, 12), (16, 20), (24, 30)] {
        measure(half_count, half_slices);
    }
}

fn measure(half_count: usize, half_slices: usize) {
    let half_length = 0.0125;
    let surfaces = [
        Cylinder { radius: 1e6, crown: 0.0, faces: 1.0, half_length },
        Cylinder { radius: 0.01, crown: 0.06, faces: -1.0, half_length },
    ];
    let placed = [0, 1].map(|side| PlacedSurface { surface: &surfaces[side], pose: Pose::IDENTITY });
    let contact_line = || find_contact_line(placed[0], placed[1], true);
    let Some(found) = contact_line() else { return };
    let options = GridOptions {
        half_count,
        half_slices,
        size: GridSize::default(),
        force: FORCE,
        contact_modulus: MODULUS,
        search_edges: true,
        local_normals: false,
        under_load: false,
    };
    let grid = build_grid(placed[0], placed[1], &found, &options, &Interrupt::never()).unwrap();
    let faces = [-half_length, half_length].map(|y| Mirror { point: [0.0, y, 0.0], normal: [0.0, 1.0, 0.0] });
    let body = HalfSpaceBody::half_space(Vec::new(), 1, 2.0 * MODULUS).between(faces.to_vec());
    let problem = problem(&grid, &body);
    let n = grid.cells.len();
    let matrix = Mat::from_fn(n, n, |i, j| problem.compliance[i * n + j]);
    let never = Interrupt::never();

    let factor = fastest(3, || Llt::new(matrix.as_ref(), faer::Side::Lower).is_ok());
    let parts = [
        fastest(3, || contact_line().is_some()),
        fastest(3, || {
            !build_grid(placed[0], placed[1], &found, &options, &Interrupt::never()).unwrap().cells.is_empty()
        }),
        fastest(3, || !self::problem(&grid, &body).compliance.is_empty()),
        fastest(3, || !first_guess(&problem, &[&grid], &never).is_empty()),
        fastest(2, || {
            let guess = first_guess(&problem, &[&grid], &never);
            solve_until(&problem, Some(&guess), &never).is_ok()
        }),
        fastest(2, || solve_until(&problem, None, &never).is_ok()),
    ]
    .map(|seconds| seconds / factor);
    let [contact_line, grid, compliance, guess, guessed, cold] = parts;
    println!(
        "{n:>6} {:>14.2} {contact_line:>10.2} {grid:>8.2} {compliance:>12.2} {guess:>10.2} {guessed:>10.2} {cold:>10.2}",
        1e3 * factor
    );
}

fn problem(grid: &Grid, body: &HalfSpaceBody) -> ContactProblem {
    let chart = Chart { tooth: 0, surface: 0 };
    let side = |number| Side { body: number, structure: body, chart, pose: Pose::IDENTITY };
    let patch = PatchCells {
        sides: [side(0), side(1)],
        frame: &grid.frame,
        cells: &grid.cells,
        beside_faces: grid.beside_faces,
    };
    ContactProblem {
        compliance: compliance(&[patch], Entries::All, &Interrupt::never()).expect("nothing interrupts it"),
        arms: vec![1.0; grid.cells.len()],
        gaps: grid.cells.iter().map(|cell| cell.gap).collect(),
        stiffness: vec![0.0],
        load: vec![-FORCE],
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

/// Along y, its lowest or highest generator through the origin, with a crown along it (1/m).
struct Cylinder {
    radius: f64,
    crown: f64,
    faces: f64,
    half_length: f64,
}

impl Surface for Cylinder {
    fn range(&self) -> [[f64; 2]; 2] {
        let half = (0.2 * self.radius).min(0.002);
        [[-half, half], [-self.half_length, self.half_length]]
    }

    fn at(&self, u: f64, v: f64) -> SurfacePoint {
        let depth = 0.5 * u * u / self.radius + self.crown * v * v;
        let slopes = [u / self.radius, 2.0 * self.crown * v];
        let size = (1.0 + slopes[0] * slopes[0] + slopes[1] * slopes[1]).sqrt();
        SurfacePoint {
            position: [u, v, -self.faces * depth],
            tangents: [[1.0, 0.0, -self.faces * slopes[0]], [0.0, 1.0, -self.faces * slopes[1]]],
            normal: [slopes[0] / size, slopes[1] / size, self.faces / size],
        }
    }
}
