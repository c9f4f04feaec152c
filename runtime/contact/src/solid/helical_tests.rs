//! Tests of involute helicoids: aligned flanks touch along a straight generator; modified and
//! misaligned ones where their gap requires.

use super::test_surfaces::{HELICAL, Helicoid, Pair};
use super::*;
use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::Interrupt;
use calyx_numerics::vec3::{cross, unit};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

impl Pair {
    /// Flanks of both in the coordinates of their bodies, and the poses: in contact at mid-face.
    fn flanks(&self) -> ([Helicoid; 2], [Pose; 2]) {
        let (flanks, turns) = self.turned();
        let pose = |turn: f64, x: f64| Pose { origin: [x, 0.0, 0.0], ..Pose::IDENTITY }.rotated_first(turn);
        (flanks, [pose(turns[0], 0.0), pose(turns[1], self.center())])
    }
}

#[test]
fn aligned_helicoids_touch_along_their_generator() {
    for helix in [0.0, 0.3, -0.2] {
        for phase in [-0.003, 0.0, 0.004] {
            let pair = Pair { base_helix: helix, phase, ..HELICAL };
            let (flanks, poses) = pair.flanks();
            let placed = [0, 1].map(|side| PlacedSurface { surface: &flanks[side], pose: poses[side] });
            let contact_line = find_contact_line(placed[0], placed[1], true).expect("they touch");
            assert!(contact_line.gap.abs() < 1e-16, "{:e}", contact_line.gap);
            for point in &contact_line.points {
                assert!(point.gap.abs() < 1e-16 && point.at[0].abs() < 1e-14, "{point:?}");
            }
            // The contact line is the generator: at the base helix angle to the axes, in the plane
            // of action.
            let [x, y, z] = contact_line.frame.normal;
            let alpha = pair.pressure_angle;
            let expected = unit([alpha.sin() * helix.cos(), alpha.cos() * helix.cos(), -helix.sin()]);
            assert!((x - expected[0]).abs() + (y - expected[1]).abs() + (z - expected[2]).abs() < 1e-14);
            let full = 2.0 * pair.half_face / helix.cos();
            let [low, high] = contact_line.extent();
            assert!(((high - low) / full - 1.0).abs() < 1e-12);
        }
    }
}

/// The work between two checkpoints of a grid is one slice, whatever its number of slices.
#[test]
fn every_slice_of_a_grid_is_a_checkpoint() {
    let (flanks, poses) = HELICAL.flanks();
    let placed = [0, 1].map(|side| PlacedSurface { surface: &flanks[side], pose: poses[side] });
    let contact_line = find_contact_line(placed[0], placed[1], true).expect("they touch");
    let options = GridOptions {
        half_count: 2,
        half_slices: 6,
        size: GridSize { width: Some(4e-4), along: None },
        force: 1000.0,
        contact_modulus: 1.1e11,
        search_edges: true,
        local_normals: false,
        under_load: false,
    };
    let counted = |last: usize| {
        let asked = Arc::new(AtomicUsize::new(0));
        let counter = asked.clone();
        let interrupt = Interrupt::new(move || match counter.fetch_add(1, Ordering::Relaxed) {
            number if number == last => Err(EngineError::new("E0704", "enough", "")),
            _ => Ok(()),
        });
        let grid = build_grid(placed[0], placed[1], &contact_line, &options, &interrupt);
        (grid, asked.load(Ordering::Relaxed))
    };
    let (grid, asked) = counted(usize::MAX);
    let grid = grid.unwrap();
    assert!(grid.slices.len() >= 13 && asked >= grid.slices.len(), "{asked} checkpoints");
    assert!(counted(5).0.is_err() && counted(5).1 == 6);
    // The automatic width does not need the cells.
    let derived = GridOptions { size: GridSize::default(), ..options };
    let whole = build_grid(placed[0], placed[1], &contact_line, &derived, &Interrupt::never()).unwrap();
    assert_eq!(grid_width(placed[0], placed[1], &contact_line, &derived), whole.width);
}

#[test]
fn cells_of_aligned_helicoids_have_the_base_radii_as_arms() {
    let (flanks, poses) = HELICAL.flanks();
    let placed = [0, 1].map(|side| PlacedSurface { surface: &flanks[side], pose: poses[side] });
    let contact_line = find_contact_line(placed[0], placed[1], true).expect("they touch");
    let options = GridOptions {
        half_count: 8,
        half_slices: 8,
        size: GridSize { width: Some(4e-4), along: None },
        force: 1000.0,
        contact_modulus: 1.1e11,
        search_edges: true,
        local_normals: false,
        under_load: false,
    };
    let grid = build_grid(placed[0], placed[1], &contact_line, &options, &Interrupt::never()).unwrap();
    // All cells except those at the side faces are whole.
    let longest = grid.cells.iter().map(|cell| cell.size[1]).fold(0.0, f64::max);
    assert!(grid.cells.iter().filter(|cell| (cell.size[1] / longest - 1.0).abs() < 1e-12).count() >= 17 * 15);
    let axis = [0.0, 0.0, 1.0];
    let helix = HELICAL.base_helix;
    for cell in &grid.cells {
        let arm = grid.frame.rotation_arm(0, axis, poses[0].origin, cell.point);
        assert!((arm.abs() / (HELICAL.base_radii[0] * helix.cos()) - 1.0).abs() < 1e-12);
        let arm = grid.frame.rotation_arm(1, axis, poses[1].origin, cell.point);
        assert!((arm.abs() / (HELICAL.base_radii[1] * helix.cos()) - 1.0).abs() < 1e-12);
        // The gap is that of the relative curvature across, averaged over the cell; the next terms
        // are of third order. Along the generator both surfaces move along the line of action.
        let shift = cell.point[2] * helix.tan();
        let path = HELICAL.base_radii.map(|rb| rb * HELICAL.pressure_angle.tan());
        let curvature = helix.cos() * ((path[0] + shift).recip() + (path[1] - shift).recip());
        let [x, width] = [cell.center[0], cell.size[0]];
        let expected = 0.5 * curvature * (x * x + width * width / 12.0);
        assert!((cell.gap - expected).abs() < 0.05 * expected, "{x}: {:e} {expected:e}", cell.gap);
    }
    // The surface between the side faces is covered exactly once: areas add up, cells of
    // neighbouring slices join.
    let area: f64 = grid.cells.iter().map(Cell::area).sum();
    assert!((area / (grid.width * (grid.along[1] - grid.along[0])) - 1.0).abs() < 1e-4);
}

#[test]
fn a_crown_opens_the_gap_as_a_parabola() {
    let pair = Pair { crown: 0.05, ..HELICAL };
    let (flanks, poses) = pair.flanks();
    let placed = [0, 1].map(|side| PlacedSurface { surface: &flanks[side], pose: poses[side] });
    let contact_line = find_contact_line(placed[0], placed[1], true).expect("they touch");
    assert!(contact_line.gap.abs() < 1e-15 && contact_line.frame.point[2].abs() < 1e-9, "{contact_line:?}");
    for point in &contact_line.points {
        let z = contact_line.frame.at(point.at)[2];
        let expected = 2.0 * pair.crown * z * z;
        // The slopes of the crowning tilt the surfaces slightly.
        assert!((point.gap - expected).abs() < 2e-3 * expected + 1e-12, "{z}: {:e} {expected:e}", point.gap);
    }
}

#[test]
fn misaligned_flanks_meet_at_a_face() {
    let pair = Pair { base_helix: 0.0, ..HELICAL };
    let (flanks, mut poses) = pair.flanks();
    // The second gear is inclined by a thousandth of a radian in the plane of action.
    let lean: f64 = 1e-3;
    let normal = [pair.pressure_angle.sin(), pair.pressure_angle.cos(), 0.0];
    let axis = cross(normal, [0.0, 0.0, 1.0]);
    let turned = |v: [f64; 3]| {
        let across = cross(axis, v);
        let twice = cross(axis, across);
        [0, 1, 2].map(|k: usize| v[k] + lean.sin() * across[k] + (1.0 - lean.cos()) * twice[k])
    };
    let columns = [0, 1, 2].map(|k: usize| turned(poses[1].rotation.map(|row| row[k])));
    poses[1].rotation = [0, 1, 2].map(|row: usize| columns.map(|column| column[row]));
    let placed = [0, 1].map(|side| PlacedSurface { surface: &flanks[side], pose: poses[side] });
    let contact_line = find_contact_line(placed[0], placed[1], true).expect("they face each other");
    let gaps = [contact_line.points[0].gap, contact_line.points[contact_line.points.len() - 1].gap];
    let opening = (gaps[1] - gaps[0]).abs();
    assert!((opening / (2.0 * pair.half_face * lean) - 1.0).abs() < 1e-3, "{gaps:?}");
    assert!(
        (contact_line.gap - gaps[0].min(gaps[1])).abs() < 1e-12 && contact_line.gap < -1e-5,
        "{gaps:?} {}",
        contact_line.gap
    );
}

#[test]
fn faces_that_overlap_in_part_touch_where_both_are() {
    let (flanks, mut poses) = HELICAL.flanks();
    // The second gear is displaced along its axis by 10 mm and rotated with its helix.
    let shift = 0.01;
    poses[1].origin[2] += shift;
    poses[1] = poses[1].rotated_first(flanks[1].twist * shift);
    let placed = [0, 1].map(|side| PlacedSurface { surface: &flanks[side], pose: poses[side] });
    let contact_line = find_contact_line(placed[0], placed[1], true).expect("they touch");
    assert!(contact_line.gap.abs() < 1e-14);
    let expected = (2.0 * HELICAL.half_face - shift) / HELICAL.base_helix.cos();
    assert!(
        ((contact_line.extent()[1] - contact_line.extent()[0]) / expected - 1.0).abs() < 1e-6,
        "{:?}",
        contact_line.extent()
    );
}

#[test]
fn a_generator_that_leaves_the_flank_ends_there() {
    // Near the end of the path of contact the generator of a helical pair leaves the tip of the
    // first gear, here a sharp one.
    let (mut flanks, poses) = HELICAL.flanks();
    let path = HELICAL.base_radii[0] * HELICAL.pressure_angle.tan();
    // On the generator the distance along the line of action grows by tan(base helix angle) per
    // axial length.
    flanks[0].u[1] = path + 0.4 * HELICAL.half_face * HELICAL.base_helix.tan();
    let placed = [0, 1].map(|side| PlacedSurface { surface: &flanks[side], pose: poses[side] });
    let nominal = find_contact_line(placed[0], placed[1], false).expect("they touch");
    let length = nominal.extent()[1] - nominal.extent()[0];
    let expected = 1.4 * HELICAL.half_face / HELICAL.base_helix.cos();
    assert!((length / expected - 1.0).abs() < 1e-6, "{length} {expected}");
    assert!(nominal.gap.abs() < 1e-15 && nominal.points.iter().all(|point| !point.at_end));
    // With edges searched, the contact line continues along the edge of the tip, and the gap opens.
    let whole = find_contact_line(placed[0], placed[1], true).expect("they touch");
    assert!(whole.gap.abs() < 1e-15);
    assert!(whole.points.iter().any(|point| point.at_end && point.gap > 1e-6), "{:?}", whole.points);
    let count = |search_edges: bool, contact_line: &ContactLine| {
        let options = GridOptions {
            half_count: 6,
            half_slices: 10,
            size: GridSize { width: Some(4e-4), along: Some([-0.5, 0.5]) },
            force: 1000.0,
            contact_modulus: 1.1e11,
            search_edges,
            local_normals: false,
            under_load: false,
        };
        let grid = build_grid(placed[0], placed[1], contact_line, &options, &Interrupt::never()).unwrap();
        assert!(grid.cells.iter().all(|cell| cell.gap > -1e-12));
        (
            grid.cells.len(),
            grid.slices.iter().filter(|slice| slice.surface_ends[1] || slice.surface_ends[0]).count(),
        )
    };
    assert!(count(false, &nominal).1 <= 3);
    assert!(count(true, &whole).1 >= 5);
}
