//! The contact problem of the loaded ranges has the solution of that of the whole grid.

use super::test_surfaces::Cap;
use super::*;
use crate::active_set::solve;
use crate::problem::{ContactProblem, Solution};
use calyx_numerics::interrupt::Interrupt;
use calyx_structure::Chart;
use calyx_structure::solid::HalfSpaceBody;
use calyx_structure::surface::{Surface, SurfacePoint};

const MODULUS: f64 = 1.1e11;

/// Bottom of a body that touches a plane along two ridges, 0.5 mm apart.
#[derive(Clone, Copy)]
struct Ridges {
    /// Half of the gap by which the ridge at positive x is higher, m.
    apart: f64,
    /// Slope of the other ridge along y.
    oblique: f64,
}

impl Surface for Ridges {
    fn range(&self) -> [[f64; 2]; 2] {
        [[-0.6e-3, 0.6e-3], [-5e-3, 5e-3]]
    }

    fn at(&self, x: f64, y: f64) -> SurfacePoint {
        // (x² - a²)² / 8 R a² has the curvature 1 / R at x = -a and x = a.
        let (a, radius, barrel) = (0.25e-3_f64, 0.02, 40.0);
        let product = x * x - a * a;
        let (part, slope) = (0.5 * (1.0 - x / a), self.oblique);
        let height = product * product / (8.0 * radius * a * a)
            + self.apart * x / a
            + y * y / (2.0 * barrel)
            + part * slope * y;
        let by_x = product * x / (2.0 * radius * a * a) + (self.apart - 0.5 * slope * y) / a;
        let by_y = y / barrel + part * slope;
        let size = (1.0 + by_x * by_x + by_y * by_y).sqrt();
        SurfacePoint {
            position: [x, y, height],
            tangents: [[1.0, 0.0, by_x], [0.0, 1.0, by_y]],
            normal: [by_x / size, by_y / size, -1.0 / size],
        }
    }
}

/// A grid of a surface on a plane, 1.6 mm wide and of this length, m.
fn grid(surface: &dyn Surface, length: f64, [half_count, half_slices]: [usize; 2]) -> Grid {
    let flat = Cap { radii: [f64::INFINITY; 2], faces: 1.0, half: [0.01; 2], turn: 0.0 };
    let placed = [&flat, surface].map(|surface| PlacedSurface { surface, pose: Pose::IDENTITY });
    let contact_line = find_contact_line(placed[0], placed[1], true).expect("they face each other");
    let options = GridOptions {
        half_count,
        half_slices,
        size: GridSize { width: Some(1.6e-3), along: Some([-0.5 * length, 0.5 * length]) },
        force: 1.0,
        contact_modulus: MODULUS,
        search_edges: true,
        local_normals: false,
        under_load: false,
    };
    build_grid(placed[0], placed[1], &contact_line, &options, &Interrupt::never()).expect("no interrupt")
}

/// Presses the surface of a grid onto the plane by a force, N.
fn pressed(grid: &Grid, force: f64) -> Solution {
    let body = HalfSpaceBody::half_space(Vec::new(), 1, 2.0 * MODULUS);
    let chart = Chart { tooth: 0, surface: 0 };
    let side = |k: usize| Side { body: k, structure: &body, chart, pose: Pose::IDENTITY };
    let patch = PatchCells {
        sides: [side(0), side(1)],
        frame: &grid.frame,
        cells: &grid.cells,
        beside_faces: grid.beside_faces,
    };
    let problem = ContactProblem {
        compliance: compliance(&[patch], Entries::All, &Interrupt::never()).expect("no interrupt"),
        arms: vec![grid.frame.translation_arm(1, grid.frame.normal); grid.cells.len()],
        gaps: grid.cells.iter().map(|cell| cell.gap).collect(),
        stiffness: vec![0.0],
        load: vec![-force],
    };
    solve(&problem, None).expect("it is well posed")
}

/// Extends ranges until all cells beyond it are open, and compares with the whole grid. Returns the
/// parts of the cells and the number of extensions.
fn compare(grid: &Grid, mut ranges: LoadedRanges, force: f64) -> ([f64; 2], usize) {
    let whole = pressed(grid, force);
    for extensions in 0.. {
        let part = within_ranges(grid, &ranges);
        let solution = pressed(&part, force);
        let loaded = (&solution.forces[..], &solution.gaps[..]);
        if let Some(extended) = extended_ranges(grid, &ranges, loaded, MODULUS) {
            assert!(
                extended
                    .iter()
                    .zip(&ranges)
                    .all(|(now, before)| { now.start <= before.start && before.end <= now.end })
            );
            ranges = extended;
            continue;
        }
        let cells: Vec<usize> = ranges.iter().cloned().flatten().collect();
        let active: Vec<usize> = solution.active.iter().map(|&cell| cells[cell]).collect();
        assert_eq!(active, whole.active, "{force} N");
        let largest = whole.forces.iter().copied().fold(0.0, f64::max);
        for (&cell, found) in cells.iter().zip(&solution.forces) {
            assert!((found - whole.forces[cell]).abs() < 1e-8 * largest, "{force} N, cell {cell}");
        }
        let part = |count: usize| count as f64 / grid.cells.len() as f64;
        return ([part(cells.len()), part(active.len())], extensions);
    }
    unreachable!("ranges are at most the grid")
}

const PARALLEL: Ridges = Ridges { apart: 0.0, oblique: 0.0 };

/// From a light touch to a load that fills the grid.
const FORCES: [f64; 6] = [1e-3, 1.0, 30.0, 300.0, 1500.0, 6000.0];

fn estimate(grid: &Grid, force: f64) -> (LoadedRanges, Vec<usize>) {
    let slices = with_a_cell_for_each_slice(grid);
    estimated_ranges(grid, &pressed(&slices, force).forces)
}

#[test]
fn the_estimate_contains_the_load_and_little_more() {
    let grid = grid(&Cap { radii: [0.02, 0.4], faces: -1.0, half: [4.5e-3; 2], turn: 0.0 }, 8e-3, [20, 6]);
    for force in FORCES {
        let (estimated, loaded) = estimate(&grid, force);
        // The cells that presumably carry load: all but those at the ends of a slice are right.
        let active = pressed(&within_ranges(&grid, &estimated), force).active;
        let wrong = loaded.iter().filter(|cell| !active.contains(cell)).count();
        let missing = active.iter().filter(|cell| !loaded.contains(cell)).count();
        assert!(wrong + missing <= 2 * grid.slices.len(), "{force} N: {wrong} wrong, {missing} missing");
        let ([ranges, active], extensions) = compare(&grid, estimated, force);
        assert_eq!(extensions, 0, "{force} N");
        // Up to three cells on either side of the load.
        let margin = 6.0 / 41.0;
        assert!(ranges <= active + margin, "{force} N: {ranges} of the cells in the ranges, {active} loaded");
    }
}

#[test]
fn any_range_is_extended_until_it_contains_the_load() {
    let barrel = Cap { radii: [0.02, 0.4], faces: -1.0, half: [4.5e-3; 2], turn: 0.0 };
    for surface in [&barrel as &dyn Surface, &PARALLEL, &Ridges { apart: 2e-8, ..PARALLEL }] {
        let grid = grid(surface, 8e-3, [20, 6]);
        let least = estimated_ranges(&grid, &vec![0.0; grid.slices.len()]).0;
        for force in FORCES {
            for ranges in [least.clone(), estimate(&grid, force).0] {
                compare(&grid, ranges, force);
            }
        }
    }
}

/// The load on the second ridge is beyond a range about the first one whose outermost cells are
/// open.
#[test]
fn the_load_may_be_in_two_parts_of_a_slice() {
    let (grid, force) = (grid(&Ridges { apart: 1e-8, ..PARALLEL }, 8e-3, [20, 6]), 30.0);
    let (ranges, middle) = (estimate(&grid, force).0, grid.slices.len() / 2);
    let solution = pressed(&within_ranges(&grid, &ranges), force);
    let first: usize = ranges[..middle].iter().map(ExactSizeIterator::len).sum();
    let forces = &solution.forces[first..first + ranges[middle].len()];
    assert!(forces[0] == 0.0 && forces[forces.len() - 1] == 0.0, "{forces:?}");
    let loaded = (&solution.forces[..], &solution.gaps[..]);
    let extended = extended_ranges(&grid, &ranges, loaded, MODULUS).expect("load beyond the ranges");
    assert!(extended[middle].len() > ranges[middle].len() + 4, "{:?} {:?}", ranges[middle], extended[middle]);
}

/// A slice without load may be next to a loaded one, whose load displaces its middle most.
#[test]
fn the_loads_of_other_slices_displace_cells_beyond_the_ranges() {
    let barrel = Cap { radii: [0.02, 0.4], faces: -1.0, half: [4.5e-3; 2], turn: 0.0 };
    let grid = grid(&barrel, 8e-3, [20, 6]);
    let ranges = estimated_ranges(&grid, &vec![0.0; grid.slices.len()]).0;
    let cells: Vec<usize> = ranges.iter().cloned().flatten().collect();
    let middle = grid.slices.len() / 2;
    let is_extended = |force: f64| {
        let in_middle = |cell: &usize| grid.slices[middle].cells.contains(cell);
        let forces: Vec<f64> = cells.iter().map(|cell| if in_middle(cell) { force } else { 0.0 }).collect();
        let gaps = vec![1e-9; cells.len()];
        let extended = extended_ranges(&grid, &ranges, (&forces, &gaps), MODULUS).expect("load at the end");
        extended[middle + 1] != ranges[middle + 1]
    };
    assert!(!is_extended(10.0) && is_extended(2e4));
}

/// Oblique ridges cross, as a tip edge and a contact line do.
#[test]
fn ranges_about_oblique_ridges_contain_the_load() {
    for oblique in [2e-4, 4e-4, 8e-4] {
        let grid = grid(&Ridges { oblique, ..PARALLEL }, 2e-3, [15, 8]);
        for step in 0..24 {
            let force = 1.3_f64.powi(step);
            compare(&grid, estimate(&grid, force).0, force);
        }
    }
}

#[test]
fn cells_keep_their_identity_in_extended_ranges() {
    // Two slices; the first range grows at both ends, the second at its end.
    assert_eq!(renumbered(&[3..5, 10..12], &[1..6, 10..13]), [2, 3, 5, 6]);
}
