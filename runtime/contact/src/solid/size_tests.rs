//! Tests of the sizes of grids with independent ends along the contact line.

use super::test_surfaces::Cap;
use super::*;
use calyx_numerics::interrupt::Interrupt;

/// A grid with 17 slices along the contact line of a barrel on a flat surface, from -10 to 10 mm.
fn grid(along: [f64; 2]) -> Grid {
    pressed_grid(Some(along), 0.0, false)
}

/// Such a grid of a barrel that is moved into the surface by a distance, m.
fn pressed_grid(along: Option<[f64; 2]>, overlap: f64, under_load: bool) -> Grid {
    let half = [0.01; 2];
    let caps = [
        Cap { radii: [f64::INFINITY; 2], faces: 1.0, half, turn: 0.0 },
        Cap { radii: [0.02, 0.4], faces: -1.0, half, turn: 0.0 },
    ];
    let pressed = Pose { origin: [0.0, 0.0, -overlap], ..Pose::IDENTITY };
    let poses = [Pose::IDENTITY, pressed];
    let placed = [0, 1].map(|side: usize| PlacedSurface { surface: &caps[side], pose: poses[side] });
    let contact_line = find_contact_line(placed[0], placed[1], true).expect("they face each other");
    let options = GridOptions {
        half_count: 6,
        half_slices: 8,
        size: GridSize { width: Some(1e-3), along },
        force: 1.0,
        contact_modulus: 1e11,
        search_edges: true,
        local_normals: false,
        under_load,
    };
    build_grid(placed[0], placed[1], &contact_line, &options, &Interrupt::never()).expect("no interrupt")
}

/// Pressures on the middle cells of the slices whose middles are between two places, m.
fn pressures_between(grid: &Grid, [from, to]: [f64; 2]) -> Vec<f64> {
    let loaded = |cell: &Cell| cell.center[0].abs() < 0.3e-3 && (from..to).contains(&cell.center[1]);
    grid.cells.iter().map(|cell| if loaded(cell) { 1e9 } else { 0.0 }).collect()
}

#[test]
fn a_grid_need_not_contain_the_closest_approach() {
    for along in [[0.003, 0.009], [-0.009, -0.003], [-0.002, 0.008]] {
        let grid = grid(along);
        assert_eq!((grid.slices.len(), grid.along), (17, along));
        for cell in &grid.cells {
            // Means of the squares over the cell.
            let [x, y] = [0, 1].map(|axis: usize| cell.center[axis].powi(2) + cell.size[axis].powi(2) / 12.0);
            let gap = x / 0.04 + y / 0.8;
            assert!((cell.gap / gap - 1.0).abs() < 1e-3, "{cell:?} {gap:e}");
        }
    }
}

/// The approach of half-spaces under 1 N is far less than the overlap, whose ends are where the gap
/// y² / 2 R - overlap is zero.
#[test]
fn a_grid_under_load_covers_the_overlap() {
    let [low, high] = pressed_grid(None, 2e-5, true).along;
    let end = (0.8 * 2e-5_f64).sqrt();
    assert!((low / -end - 1.0).abs() < 0.01 && (high / end - 1.0).abs() < 0.01, "{low} {high}");
    let [low, high] = pressed_grid(None, 2e-5, false).along;
    assert!(high - low < end, "{low} {high}");
}

#[test]
fn ends_follow_a_load_on_one_side() {
    let grid = grid([-0.008, 0.008]);
    let [from, to] =
        fitting_size(&grid, &pressures_between(&grid, [0.001, 0.005])).along.expect("it is long");
    // Four slices of 0.94 mm carry load, from 1.41 to 5.18 mm, and the margin is 0.75 slices.
    assert!((from - 0.706e-3).abs() < 1e-6 && (to - 5.882e-3).abs() < 1e-6, "{from} {to}");
    let suits = pressures_between(&grid, [-0.006, 0.006]);
    assert_eq!(fitting_size(&grid, &suits).along, None);
}

#[test]
fn only_the_end_that_truncates_the_load_moves() {
    let grid = grid([-0.008, 0.008]);
    let report = assess(&grid, &pressures_between(&grid, [0.003, 0.01]));
    let [low, high] = report.recommended.along.expect("it is truncated");
    assert!(report.truncated[1] && low == -0.008 && high > 0.0085, "{low} {high}");
    // The surfaces end at 10 mm.
    let whole = self::grid([-0.008, high]);
    assert_eq!((whole.along, whole.surface_ends), ([-0.008, 0.01], [false, true]));
    assert!(!assess(&whole, &pressures_between(&whole, [0.003, 0.01])).truncated[1]);
}
