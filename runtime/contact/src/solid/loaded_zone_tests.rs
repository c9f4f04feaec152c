//! The contact problem of a zone has the solution of that of the whole grid.

use super::test_surfaces::Cap;
use super::*;
use crate::active_set::solve;
use crate::problem::{ContactProblem, Solution};
use calyx_numerics::interrupt::Interrupt;
use calyx_structure::Chart;
use calyx_structure::solid::HalfSpaceBody;
use calyx_structure::surface::{Surface, SurfacePoint};

const MODULUS: f64 = 1.1e11;

/// Bottom of a body that touches a plane along two parallel ridges, 0.5 mm apart. The gap of the one
/// at positive x is larger by twice this length, m.
struct Ridges {
    apart: f64,
}

impl Surface for Ridges {
    fn range(&self) -> [[f64; 2]; 2] {
        [[-0.6e-3, 0.6e-3], [-5e-3, 5e-3]]
    }

    fn at(&self, x: f64, y: f64) -> SurfacePoint {
        // (x² - a²)² / 8 R a² has the curvature 1 / R at x = -a and x = a.
        let (a, radius, barrel) = (0.25e-3_f64, 0.02, 40.0);
        let product = x * x - a * a;
        let height = product * product / (8.0 * radius * a * a) + self.apart * x / a + y * y / (2.0 * barrel);
        let (by_x, by_y) = (product * x / (2.0 * radius * a * a) + self.apart / a, y / barrel);
        let size = (1.0 + by_x * by_x + by_y * by_y).sqrt();
        SurfacePoint {
            position: [x, y, height],
            tangents: [[1.0, 0.0, by_x], [0.0, 1.0, by_y]],
            normal: [by_x / size, by_y / size, -1.0 / size],
        }
    }
}

/// A grid of a surface on a plane, 1.6 mm wide.
fn grid(surface: &dyn Surface) -> Grid {
    let flat = Cap { radii: [f64::INFINITY; 2], faces: 1.0, half: [0.01; 2], turn: 0.0 };
    let placed = [&flat, surface].map(|surface| PlacedSurface { surface, pose: Pose::IDENTITY });
    let contact_line = find_contact_line(placed[0], placed[1], true).expect("they face each other");
    let options = GridOptions {
        half_count: 20,
        half_slices: 6,
        size: GridSize { width: Some(1.6e-3), along: Some([-4e-3, 4e-3]) },
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
    let patch = PatchCells { sides: [side(0), side(1)], frame: &grid.frame, cells: &grid.cells };
    let problem = ContactProblem {
        compliance: compliance(&[patch], Entries::All, &Interrupt::never()).expect("no interrupt"),
        arms: vec![grid.frame.translation_arm(1, grid.frame.normal); grid.cells.len()],
        gaps: grid.cells.iter().map(|cell| cell.gap).collect(),
        stiffness: vec![0.0],
        load: vec![-force],
    };
    solve(&problem, None).expect("it is well posed")
}

/// Extends a zone until all cells beyond it are open, and compares with the whole grid. Returns the
/// parts of the cells and the number of extensions.
fn compare(grid: &Grid, mut zone: LoadedZone, force: f64) -> ([f64; 2], usize) {
    let whole = pressed(grid, force);
    for extensions in 0.. {
        let part = within_zone(grid, &zone);
        let solution = pressed(&part, force);
        let loaded = (&solution.forces[..], &solution.gaps[..]);
        if let Some(extended) = extended_zone(grid, &zone, loaded, MODULUS) {
            assert!(
                extended
                    .iter()
                    .zip(&zone)
                    .all(|(now, before)| { now.start <= before.start && before.end <= now.end })
            );
            zone = extended;
            continue;
        }
        let cells: Vec<usize> = zone.iter().cloned().flatten().collect();
        let active: Vec<usize> = solution.active.iter().map(|&cell| cells[cell]).collect();
        assert_eq!(active, whole.active, "{force} N");
        let largest = whole.forces.iter().copied().fold(0.0, f64::max);
        for (&cell, found) in cells.iter().zip(&solution.forces) {
            assert!((found - whole.forces[cell]).abs() < 1e-8 * largest, "{force} N, cell {cell}");
        }
        let part = |count: usize| count as f64 / grid.cells.len() as f64;
        return ([part(cells.len()), part(active.len())], extensions);
    }
    unreachable!("a zone is at most the grid")
}

/// From a light touch to a load that fills the grid.
const FORCES: [f64; 6] = [1e-3, 1.0, 30.0, 300.0, 1500.0, 6000.0];

fn estimate(grid: &Grid, force: f64) -> LoadedZone {
    let slices = with_a_cell_for_each_slice(grid);
    estimated_zone(grid, &pressed(&slices, force).forces).0
}

#[test]
fn the_estimate_contains_the_load_and_little_more() {
    let grid = grid(&Cap { radii: [0.02, 0.4], faces: -1.0, half: [4.5e-3; 2], turn: 0.0 });
    for force in FORCES {
        let ([zone, active], extensions) = compare(&grid, estimate(&grid, force), force);
        assert_eq!(extensions, 0, "{force} N");
        // Up to three cells on either side of the load.
        let margin = 6.0 / 41.0;
        assert!(zone <= active + margin, "{force} N: {zone} of the cells in the zone, {active} loaded");
    }
}

#[test]
fn any_zone_is_extended_until_it_contains_the_load() {
    let barrel = Cap { radii: [0.02, 0.4], faces: -1.0, half: [4.5e-3; 2], turn: 0.0 };
    for surface in [&barrel as &dyn Surface, &Ridges { apart: 0.0 }, &Ridges { apart: 2e-8 }] {
        let grid = grid(surface);
        let least = estimated_zone(&grid, &vec![0.0; grid.slices.len()]).0;
        for force in FORCES {
            for zone in [least.clone(), estimate(&grid, force)] {
                compare(&grid, zone, force);
            }
        }
    }
}

/// The load on the second ridge is beyond a zone about the first one whose outermost cells are
/// open.
#[test]
fn the_load_may_be_in_two_parts_of_a_slice() {
    let (grid, force) = (grid(&Ridges { apart: 1e-8 }), 30.0);
    let (zone, middle) = (estimate(&grid, force), grid.slices.len() / 2);
    let solution = pressed(&within_zone(&grid, &zone), force);
    let first: usize = zone[..middle].iter().map(ExactSizeIterator::len).sum();
    let forces = &solution.forces[first..first + zone[middle].len()];
    assert!(forces[0] == 0.0 && forces[forces.len() - 1] == 0.0, "{forces:?}");
    let loaded = (&solution.forces[..], &solution.gaps[..]);
    let extended = extended_zone(&grid, &zone, loaded, MODULUS).expect("load beyond the zone");
    assert!(extended[middle].len() > zone[middle].len() + 4, "{:?} {:?}", zone[middle], extended[middle]);
}
