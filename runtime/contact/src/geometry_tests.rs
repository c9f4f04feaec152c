//! Tests of closest approaches and grids of circles and involutes against closed forms.

use super::Placement;
use super::approach::{PlacedProfile, closest_approach};
use super::assembly::{Entries, FormerCompliance, PatchCells, Side, compliance};
use super::grid::{Cell, GridOptions, Width, assess, build_grid};
use super::test_profiles::{Arcs, HalfPlaneBody, Involute};
use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::Interrupt;
use calyx_structure::Chart;
use calyx_structure::profile::Profile;
use std::f64::consts::PI;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

/// Pair of involutes with base radii 47 and 94 mm and a centre distance of 150.3 mm. The second is
/// rotated so that the flanks are `gap` apart at a point given by the rotation of the first.
struct Pair {
    first: Involute,
    second: Involute,
    turns: [f64; 2],
    center: [f64; 2],
    pressure_angle: f64,
}

impl Pair {
    fn new(first_turn: f64, gap: f64) -> Self {
        let (rb1, rb2, distance) = (0.047f64, 0.094, 0.1503);
        let pressure_angle = ((rb1 + rb2) / distance).acos();
        // Along the line of action: distance * sin(alpha) = rb1 roll1 + gap + rb2 roll2.
        let roll1 = pressure_angle - first_turn;
        let roll2 = (distance * pressure_angle.sin() - gap - rb1 * roll1) / rb2;
        Self {
            first: Involute { base_radius: rb1, roll: [0.05, 0.7] },
            second: Involute { base_radius: rb2, roll: [0.1, 0.6] },
            turns: [first_turn, pressure_angle + PI - roll2],
            center: [distance, 0.0],
            pressure_angle,
        }
    }

    /// Returns the pair rotated by `turn` about the first centre.
    fn placed(&self, turn: f64) -> [PlacedProfile<'_>; 2] {
        let center = Placement::new(turn, [0.0, 0.0]).point(self.center);
        [
            PlacedProfile {
                profile: &self.first,
                placement: Placement::new(self.turns[0] + turn, [0.0, 0.0]),
            },
            PlacedProfile { profile: &self.second, placement: Placement::new(self.turns[1] + turn, center) },
        ]
    }
}

#[test]
fn involutes_on_the_line_of_action() {
    for first_turn in [0.1, -0.05, -0.2] {
        for gap in [0.0, 2e-5, -3e-5] {
            for scene_turn in [0.0, 37f64.to_radians()] {
                let pair = Pair::new(first_turn, gap);
                let [first, second] = pair.placed(scene_turn);
                let approach = closest_approach(first, second, true).expect("the flanks face each other");
                assert!((approach.gap - gap).abs() < 1e-13 * 0.15, "{} {gap}", approach.gap);
                let roll = pair.pressure_angle - first_turn;
                let s = 0.5 * 0.047 * (roll * roll - 0.05 * 0.05);
                assert!((approach.s[0] - s).abs() < 1e-13 * 0.15, "{} {s}", approach.s[0]);
                // The arms equal the base radii for any centre distance.
                let center = second.placement.origin();
                assert!((approach.frame.rotation_arm(0, [0.0, 0.0]).abs() / 0.047 - 1.0).abs() < 1e-13);
                assert!((approach.frame.rotation_arm(1, center).abs() / 0.094 - 1.0).abs() < 1e-13);
                assert_eq!((approach.at_end, approach.on_edge), ([false; 2], [false; 2]));
                // Exchanged bodies give the same point, mirrored.
                let swapped = closest_approach(second, first, true).unwrap();
                assert!((swapped.gap - approach.gap).abs() < 1e-15);
                assert!((swapped.s[1] - approach.s[0]).abs() < 1e-14);
            }
        }
    }
}

#[test]
fn arms_are_the_gap_s_derivatives() {
    let gap_at = |turn1: f64, turn2: f64| {
        let mut pair = Pair::new(0.05, 1e-5);
        pair.turns[0] += turn1;
        pair.turns[1] += turn2;
        let [first, second] = pair.placed(0.0);
        let approach = closest_approach(first, second, true).unwrap();
        (
            approach.gap,
            [approach.frame.rotation_arm(0, [0.0, 0.0]), approach.frame.rotation_arm(1, pair.center)],
        )
    };
    let (gap, arms) = gap_at(0.0, 0.0);
    assert!(((gap_at(1e-4, 0.0).0 - gap) / 1e-4 - arms[0]).abs() < 1e-9);
    assert!(((gap_at(0.0, 1e-4).0 - gap) / 1e-4 - arms[1]).abs() < 1e-9);
}

fn circle(center_normal: f64, radius: f64) -> Arcs {
    Arcs::new([0.0, 0.0], center_normal - 0.3, &[(radius, 0.6)], false)
}

#[test]
fn circles_on_the_line_of_centres() {
    let (lower, upper) = (circle(0.5 * PI, 0.05), circle(1.5 * PI, 0.02));
    for (dx, gap) in [(0.0, 1e-6), (0.003, -1e-6), (-0.01, 1e-4)] {
        let distance: f64 = 0.07 + gap;
        let dy = (distance * distance - dx * dx).sqrt();
        let first = PlacedProfile { profile: &lower, placement: Placement::new(0.0, [0.0, 0.0]) };
        let second = PlacedProfile { profile: &upper, placement: Placement::new(0.0, [dx, dy]) };
        let approach = closest_approach(first, second, true).unwrap();
        assert!((approach.gap - gap).abs() < 1e-15);
        let s = 0.05 * (dy.atan2(dx) - (0.5 * PI - 0.3));
        assert!((approach.s[0] - s).abs() < 1e-15);
        let expected = 1.0 / 0.05 + 1.0 / 0.02 + gap / (0.05 * 0.02);
        assert!((approach.relative_curvature - expected).abs() < 1e-11 * expected);
    }
}

#[test]
fn contact_beyond_an_end() {
    // The upper circle lies beyond the end of the lower arc (0.3 rad to the left of its top).
    let (lower, upper) =
        (circle(0.5 * PI, 0.05), Arcs::new([0.0, 0.0], 1.2 * PI, &[(0.02, 0.6 * PI)], false));
    let angle = 0.5 * PI + 0.4;
    let first = PlacedProfile { profile: &lower, placement: Placement::new(0.0, [0.0, 0.0]) };
    let shift = [0.071 * angle.cos(), 0.071 * angle.sin()];
    let second = PlacedProfile { profile: &upper, placement: Placement::new(0.0, shift) };
    assert!(closest_approach(first, second, false).is_none());
    let approach = closest_approach(first, second, true).unwrap();
    assert_eq!(approach.at_end, [true, false]);
    let end = lower.at(lower.length()).position;
    let expected = f64::hypot(end[0] - shift[0], end[1] - shift[1]) - 0.02;
    assert!((approach.gap - expected).abs() < 1e-15);
    // Exchanged bodies give the same corner.
    let swapped = closest_approach(second, first, true).unwrap();
    assert_eq!(swapped.at_end, [false, true]);
    assert!((swapped.gap - approach.gap).abs() < 1e-15);
    assert!((swapped.frame.normal[0] + approach.frame.normal[0]).abs() < 1e-15);
}

#[test]
fn curvature_jumps_do_not_stop_the_search() {
    // Sample points around the jump with incommensurate steps: each must be found on the right
    // piece.
    let lower = Arcs::new([0.0, 0.0], 0.5 * PI - 0.2, &[(0.05, 0.2), (0.001, 0.5)], true);
    let upper = Arcs::new([0.0, 0.0], 1.5 * PI - 0.7, &[(0.1, 1.4)], false);
    for k in -20i32..=40 {
        let turn = f64::from(k) * 7.3e-3;
        let angle = 0.5 * PI + turn;
        let (center, radius) = if turn < 0.0 { (0.0, 0.05) } else { (0.049, 0.001) };
        let reach = radius + 0.1 + 1e-6;
        let shift = [reach * angle.cos(), center + reach * angle.sin()];
        let first = PlacedProfile { profile: &lower, placement: Placement::new(0.0, [0.0, 0.0]) };
        let second = PlacedProfile { profile: &upper, placement: Placement::new(0.0, shift) };
        let approach = closest_approach(first, second, true).unwrap_or_else(|| panic!("none at {turn}"));
        assert!((approach.gap - 1e-6).abs() < 1e-15, "at {turn}: {approach:?}");
        assert_eq!(closest_approach(first, second, false).is_some(), turn <= 0.0, "at {turn}");
        if k != 0 {
            assert_eq!(approach.on_edge, [turn > 0.0, false]);
        }
    }
}

#[test]
fn gaps_are_those_of_the_parabola_nearby() {
    let pair = Pair::new(0.05, 1e-5);
    let [first, second] = pair.placed(0.3);
    let approach = closest_approach(first, second, true).unwrap();
    let options =
        GridOptions { half_count: 8, width: Width::Total(2e-4), contact_modulus: 1e11, search_edges: true };
    let grid = build_grid(first, second, &approach, &options);
    assert_eq!(grid.cells.len(), 17);
    assert_eq!(grid.surface_ends, [false; 2]);
    for cell in &grid.cells {
        let (x, h) = (cell.center(), cell.width());
        // Average over the cell; curvature along a straight line between the surfaces, without the
        // effect of the gap.
        let curvature = first.at(approach.s[0]).curvature + second.at(approach.s[1]).curvature;
        let parabola = approach.gap + 0.5 * curvature * (x * x + h * h / 12.0);
        // The next term is cubic: the change of an involute's curvature, about x³ k² cot / 6.
        assert!((cell.gap - parabola).abs() < curvature * curvature * (x.abs() + h).powi(3), "{cell:?}");
        for side in 0..2 {
            let direction = (cell.arc[side][1] - cell.arc[side][0]).signum();
            assert!((cell.s[side] - approach.s[side] - direction * x).abs() < 1e-8);
        }
    }
}

#[test]
fn cells_end_where_a_surface_does() {
    let lower = Arcs::new([0.0, 0.0], 0.5 * PI - 0.01, &[(0.05, 0.6)], false);
    let upper = circle(1.5 * PI, 0.1);
    let first = PlacedProfile { profile: &lower, placement: Placement::new(0.0, [0.0, 0.0]) };
    let second = PlacedProfile { profile: &upper, placement: Placement::new(0.0, [0.0, 0.15]) };
    let approach = closest_approach(first, second, true).unwrap();
    let options =
        GridOptions { half_count: 10, width: Width::Total(2e-3), contact_modulus: 1e11, search_edges: true };
    let grid = build_grid(first, second, &approach, &options);
    assert_eq!(grid.surface_ends, [false, true]);
    let last = grid.cells.last().unwrap();
    assert!((last.x[1] - 0.05 * 0.01f64.sin()).abs() < 1e-15);
    assert!(last.arc[0][1].abs() < 1e-15);
    assert_eq!(grid.cells.len(), 16);
}

#[test]
fn a_grid_is_wider_than_rounding_errors() {
    let pair = Pair::new(0.05, 0.0);
    let [first, second] = pair.placed(0.3);
    let approach = closest_approach(first, second, true).unwrap();
    let body = HalfPlaneBody { surface_modulus: 2e11 };
    let side = |number| Side { body: number, structure: &body, chart: Chart { tooth: 0, surface: 0 } };
    for width in [Width::Total(1e-22), Width::Hertz { force: 1e-30 }] {
        let options = GridOptions { half_count: 24, width, contact_modulus: 1e11, search_edges: true };
        let grid = build_grid(first, second, &approach, &options);
        let patches = [PatchCells { sides: [side(0), side(1)], cells: &grid.cells }];
        let matrix = compliance(&patches, Entries::All, &Interrupt::never()).expect("no interrupt");
        assert!(grid.cells.len() == 49 && matrix.iter().all(|value| value.is_finite()), "{width:?}");
        // One loaded cell asks for a narrower grid, but not for one below the smallest width.
        let mut pressures = vec![0.0; 49];
        pressures[24] = 1.0;
        let report = assess(&grid, &pressures);
        assert!(report.under_resolved && report.recommended_width.is_none(), "{report:?}");
    }
    let options = GridOptions {
        half_count: 24,
        width: Width::Hertz { force: 0.0 },
        contact_modulus: 1e11,
        search_edges: true,
    };
    assert!(build_grid(first, second, &approach, &options).cells.is_empty());
}

#[test]
fn cells_shrink_towards_an_edge() {
    let lower = Arcs::new([0.0, 0.0], 0.5 * PI - 0.2, &[(0.05, 0.2), (1e-4, 0.8)], true);
    let upper = circle(1.5 * PI, 0.1);
    let angle = 0.5 * PI - 0.005;
    let first = PlacedProfile { profile: &lower, placement: Placement::new(0.0, [0.0, 0.0]) };
    let second = PlacedProfile {
        profile: &upper,
        placement: Placement::new(0.0, [0.15 * angle.cos(), 0.15 * angle.sin()]),
    };
    let approach = closest_approach(first, second, true).unwrap();
    let options =
        GridOptions { half_count: 10, width: Width::Total(1e-3), contact_modulus: 1e11, search_edges: true };
    let grid = build_grid(first, second, &approach, &options);
    let flank_cell = 1e-3 / 21.0;
    // The relative curvature is 30 on the flank and 10010 on the edge.
    let edge_cell = flank_cell * (30.0f64 / 10010.0).sqrt();
    let edge_cells: Vec<_> = grid.cells.iter().filter(|c| c.edge).collect();
    assert!(edge_cells.len() >= 10, "{}", edge_cells.len());
    for cell in &edge_cells {
        assert!((cell.width() / edge_cell - 1.0).abs() < 0.1);
    }
    for pair in grid.cells.windows(2) {
        assert_eq!(pair[0].x[1], pair[1].x[0]);
        assert!((0..2).all(|side| (pair[0].arc[side][1] - pair[1].arc[side][0]).abs() < 1e-15));
        let ratio = pair[1].width() / pair[0].width();
        assert!((0.7..1.4).contains(&ratio), "{ratio}");
    }
    assert!(grid.cells.iter().any(|c| (c.width() / flank_cell - 1.0).abs() < 0.1));
    assert!(grid.cells.len() < 60);
    // Forces on the edge are applied at its start.
    for cell in &grid.cells {
        let expected = if cell.edge { 0.01 } else { cell.s[0] };
        assert!((cell.loaded_at[0] - expected).abs() < 1e-12 && cell.loaded_at[1] == cell.s[1], "{cell:?}");
    }
    // A cell ends at the start of the edge.
    assert!(grid.cells.iter().any(|c| (c.arc[0][1] - 0.01).abs() < 1e-12));
}

/// The largest permitted number of cells takes seconds, so each row of each block is a checkpoint.
#[test]
fn the_compliance_of_many_cells_can_be_interrupted() {
    let pair = Pair::new(0.05, 0.0);
    let [first, second] = pair.placed(0.0);
    let approach = closest_approach(first, second, true).unwrap();
    let options =
        GridOptions { half_count: 60, width: Width::Total(3e-4), contact_modulus: 1e11, search_edges: true };
    let grid = build_grid(first, second, &approach, &options);
    let body = HalfPlaneBody { surface_modulus: 2e11 };
    let side =
        |body_number| Side { body: body_number, structure: &body, chart: Chart { tooth: 0, surface: 0 } };
    let patches = [PatchCells { sides: [side(0), side(1)], cells: &grid.cells }];
    let asked = Arc::new(AtomicUsize::new(0));
    let counting = |most: usize| {
        let asked = asked.clone();
        asked.store(0, Relaxed);
        Interrupt::new(move || match asked.fetch_add(1, Relaxed) < most {
            true => Ok(()),
            false => Err(EngineError::new("E0704", "enough", "")),
        })
    };
    compliance(&patches, Entries::All, &counting(usize::MAX)).expect("nothing ends it");
    let rows = asked.load(Relaxed);
    assert!(rows >= 2 * grid.cells.len(), "{rows} checkpoints for {} cells", grid.cells.len());
    let ended = compliance(&patches, Entries::All, &counting(10)).expect_err("it is ended");
    assert_eq!((ended.code, asked.load(Relaxed)), ("E0704", 11));
}

#[test]
fn compliance_is_symmetric_bit_for_bit_across_patches() {
    let pair = Pair::new(0.05, 0.0);
    let [first, second] = pair.placed(0.0);
    let approach = closest_approach(first, second, true).unwrap();
    let lay = |half_count, width| {
        build_grid(
            first,
            second,
            &approach,
            &GridOptions {
                half_count,
                width: Width::Total(width),
                contact_modulus: 1e11,
                search_edges: true,
            },
        )
    };
    let (one, other) = (lay(4, 3e-4), lay(6, 5e-4));
    let body = HalfPlaneBody { surface_modulus: 2e11 };
    let side =
        |body_number, tooth| Side { body: body_number, structure: &body, chart: Chart { tooth, surface: 0 } };
    let patches = [
        PatchCells { sides: [side(0, 0), side(1, 0)], cells: &one.cells },
        // Shares a surface with the first patch on body 0; another tooth of body 1.
        PatchCells { sides: [side(0, 0), side(1, 1)], cells: &other.cells },
        // Shares no body, although the structure is the same.
        PatchCells { sides: [side(2, 0), side(3, 0)], cells: &one.cells },
    ];
    let matrix = compliance(&patches, Entries::All, &Interrupt::never()).expect("no interrupt");
    let n = 9 + 13 + 9;
    for i in 0..n {
        for j in 0..n {
            assert_eq!(matrix[i * n + j].to_bits(), matrix[j * n + i].to_bits());
        }
    }
    assert!(matrix[10] > 0.0);
    // The cells of the second patch are coupled to the first through one body only.
    assert!((matrix[9] / matrix[5] - 0.5).abs() < 0.2, "{} {}", matrix[9], matrix[5]);
    assert!((22..n).all(|j| matrix[j] == 0.0));
    assert_eq!(matrix[22 * n + 22], matrix[0]);
}

/// The first of three patches gets another grid: only its blocks are computed again.
#[test]
fn blocks_of_unchanged_patches_are_kept() {
    let pair = Pair::new(0.05, 0.0);
    let [first, second] = pair.placed(0.0);
    let approach = closest_approach(first, second, true).unwrap();
    let grid = |half_count| {
        let options =
            GridOptions { half_count, width: Width::Total(3e-4), contact_modulus: 1e11, search_edges: true };
        build_grid(first, second, &approach, &options).cells
    };
    let [before, after, second, third] = [4, 5, 6, 7].map(grid);
    let body = HalfPlaneBody { surface_modulus: 2e11 };
    let side = |number| Side { body: number, structure: &body, chart: Chart { tooth: 0, surface: 0 } };
    let compliance = |cells: [&[Cell]; 3], entries: Entries| {
        let patches = cells.map(|cells| PatchCells { sides: [side(0), side(1)], cells });
        compliance(&patches, entries, &Interrupt::never()).expect("no interrupt")
    };
    let mut known = compliance([&before, &second, &third], Entries::All);
    let fresh = compliance([&after, &second, &third], Entries::All);
    let (sizes, unchanged) = ([9, 13, 15], [false, true, true]);
    let again = |matrix: &[f64]| {
        compliance(
            [&after, &second, &third],
            Entries::Changed(FormerCompliance { matrix, sizes: &sizes, unchanged: &unchanged }),
        )
    };
    assert_eq!(again(&known), fresh);
    // A mark in the block of the second and third patch is still there.
    known[9 * 37 + 9 + 13] = 7.0;
    assert_eq!(again(&known)[11 * 39 + 11 + 13], 7.0);
    // Entries between some cells of each patch are those of the whole matrix.
    let wanted = [11, 13, 15].map(|count| (0..count).map(|cell| cell % 3 == 1).collect::<Vec<bool>>());
    let some = compliance([&after, &second, &third], Entries::Between(&wanted));
    let wanted: Vec<bool> = wanted.concat();
    for (entry, value) in some.iter().enumerate() {
        let [row, column] = [entry / 39, entry % 39];
        match wanted[row] && wanted[column] {
            true => assert_eq!(*value, fresh[entry], "{row} {column}"),
            false => assert_eq!(*value > 0.0, row == column, "{row} {column}"),
        }
    }
}
