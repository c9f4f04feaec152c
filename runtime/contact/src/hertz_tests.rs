//! Tests of two cylinders against Hertz, from profiles to peak pressure.

use super::Placement;
use super::active_set::solve;
use super::approach::{PlacedProfile, closest_approach};
use super::assembly::{Entries, PatchCells, Side, compliance};
use super::grid::{Grid, GridOptions, Width, assess, build_grid, contact_modulus, pressures};
use super::pressure::{half_width, peak};
use super::problem::ContactProblem;
use super::test_profiles::{Arcs, HalfPlaneBody};
use super::zone::{Edges, Zone};
use calyx_numerics::interrupt::Interrupt;
use calyx_structure::Chart;
use std::f64::consts::PI;

// Johnson, eqs. 4.43 to 4.45: steel cylinders of 50 and 100 mm radius, 500 N/mm.
const FORCE: f64 = 5e5;
const RADII: [f64; 2] = [0.05, 0.1];
const HALF_WIDTH: f64 = 0.000432993640638256;
const PEAK: f64 = 735137554.710006;

fn steel() -> HalfPlaneBody {
    HalfPlaneBody { surface_modulus: 206e9 / (1.0 - 0.09) }
}

fn cylinders() -> [Arcs; 2] {
    [
        Arcs::new([0.0, 0.0], 0.5 * PI - 0.2, &[(RADII[0], 0.4)], false),
        Arcs::new([0.0, 0.0], 1.5 * PI - 0.2, &[(RADII[1], 0.4)], false),
    ]
}

/// Returns the grid and the pressures of two placed profiles pressed together by `FORCE`.
fn press(
    profiles: &[Arcs; 2],
    shift: [f64; 2],
    half_count: usize,
    width: Width,
    edges: bool,
) -> (Grid, Vec<f64>) {
    let body = steel();
    let placed = [
        PlacedProfile { profile: &profiles[0], placement: Placement::new(0.0, [0.0, 0.0]) },
        PlacedProfile { profile: &profiles[1], placement: Placement::new(0.0, shift) },
    ];
    let approach = closest_approach(placed[0], placed[1], edges).expect("they face each other");
    let contact_modulus = contact_modulus(&steel(), &steel());
    let options = GridOptions { half_count, width, contact_modulus, search_edges: edges };
    let grid = build_grid(placed[0], placed[1], &approach, &options);
    let chart = Chart { tooth: 0, surface: 0 };
    let side = |body_number| Side { body: body_number, structure: &body, chart };
    let patch = PatchCells { sides: [side(0), side(1)], cells: &grid.cells };
    let n = grid.cells.len();
    let problem = ContactProblem {
        compliance: compliance(&[patch], Entries::All, &Interrupt::never()).expect("no interrupt"),
        arms: vec![grid.frame.translation_arm(1, grid.frame.normal); n],
        gaps: grid.cells.iter().map(|cell| cell.gap).collect(),
        stiffness: vec![0.0],
        load: vec![-FORCE],
    };
    let solution = solve(&problem, None).expect("it is well posed");
    assert!(solution.certificate.largest() <= 1e-12, "{:?}", solution.certificate);
    let pressures = pressures(&grid.cells, &solution.forces);
    (grid, pressures)
}

fn automatic() -> Width {
    Width::Hertz { force: FORCE }
}

#[test]
fn cylinders_converge_to_hertz() {
    let profiles = cylinders();
    let mut errors = Vec::new();
    for half_count in [7, 14, 28, 56] {
        let (grid, pressures) = press(&profiles, [0.0, 0.15 + 1e-5], half_count, automatic(), true);
        assert_eq!(grid.cells.len(), 2 * half_count + 1);
        let report = assess(&grid, &pressures);
        assert_eq!((report.truncated, report.under_resolved), ([false; 2], false));
        let peak = peak(&grid.cells, &pressures).unwrap();
        let half_width = half_width(&grid.cells, &pressures).unwrap();
        errors.push([(peak.pressure / PEAK - 1.0).abs(), (half_width / HALF_WIDTH - 1.0).abs()]);
    }
    println!("{errors:?}");
    assert!(errors[0][0] < 5e-3 && errors[0][1] < 1e-2, "{errors:?}");
    // Three halvings. Convergence is of first order at the ends of the patch, which lie anywhere in
    // a cell, so compare over all three.
    assert!(errors[3][0] < errors[0][0] / 8.0 && errors[3][1] < errors[0][1] / 4.0, "{errors:?}");
}

#[test]
fn grids_too_narrow_and_too_wide_are_reported() {
    let profiles = cylinders();
    let total = |factor: f64| Width::Total(2.0 * HALF_WIDTH * factor);
    for factor in [0.3, 0.7, 0.95] {
        let mut width = total(factor);
        let (grid, pressures) = press(&profiles, [0.0, 0.15], 10, width, true);
        assert_eq!(assess(&grid, &pressures).truncated, [true, true], "{factor}");
        // Repeated recommendations must converge to a suitable grid.
        for _ in 0..4 {
            let (grid, pressures) = press(&profiles, [0.0, 0.15], 10, width, true);
            if let Some(better) = assess(&grid, &pressures).recommended_width {
                width = Width::Total(better);
            }
        }
        let (grid, pressures) = press(&profiles, [0.0, 0.15], 10, width, true);
        assert_eq!(assess(&grid, &pressures).recommended_width, None, "{factor}");
        let ratio = peak(&grid.cells, &pressures).unwrap().pressure / PEAK;
        assert!((ratio - 1.0).abs() < 1e-2, "{ratio}");
    }
    let (grid, pressures) = press(&profiles, [0.0, 0.15], 10, total(12.0), true);
    let report = assess(&grid, &pressures);
    assert!(report.under_resolved && report.loaded_cells < 5);
    let better = Width::Total(report.recommended_width.unwrap());
    let (grid, pressures) = press(&profiles, [0.0, 0.15], 10, better, true);
    assert_eq!(assess(&grid, &pressures).recommended_width, None);
}

#[test]
fn a_patch_on_an_edge_is_resolved_like_one_on_the_flank() {
    // A flank of 50 mm radius ends in an edge of 0.5 mm radius. A shifted cylinder touches the edge
    // well inside its arc.
    let radius = 5e-4;
    let profiles = [
        Arcs::new([0.0, 0.0], 0.5 * PI - 0.2, &[(RADII[0], 0.2), (radius, 0.8)], true),
        Arcs::new([0.0, 0.0], 1.5 * PI - 0.6, &[(RADII[1], 1.2)], false),
    ];
    let angle = 0.5 * PI + 0.3;
    let center = RADII[0] - radius;
    let reach = radius + RADII[1];
    let shift = [reach * angle.cos(), center + reach * angle.sin()];
    let (grid, pressures) = press(&profiles, shift, 14, automatic(), true);
    let relative_curvature = radius.recip() + RADII[1].recip();
    let modulus = contact_modulus(&steel(), &steel());
    let expected = (FORCE * modulus * relative_curvature / PI).sqrt();
    let found = peak(&grid.cells, &pressures).unwrap();
    // Hertz assumes parabolas; at a/R = 0.1 the next term of the circle adds about (a/R)²/4 to the
    // curvature.
    assert!((found.pressure / expected - 1.0).abs() < 5e-3, "{} {expected}", found.pressure);
    let report = assess(&grid, &pressures);
    assert!(!report.under_resolved && report.truncated == [false; 2], "{report:?}");
    assert_eq!(in_zones(&grid, &pressures), [0.0, found.pressure]);
}

/// Returns the largest pressures of the flank zone and of the edge zone.
fn in_zones(grid: &Grid, pressures: &[f64]) -> [f64; 2] {
    let half_width = grid.unit_half_width * FORCE.sqrt();
    [Zone::Flank, Zone::Edge].map(|zone| {
        zone.peak(&grid.cells, pressures, &Edges::parallel(grid.flank, 0.0), half_width)
            .map_or(0.0, |peak| peak.pressure)
    })
}

#[test]
fn a_patch_across_the_start_of_an_edge() {
    // Contact just short of the edge: flank and edge are loaded and resolved, and refinement
    // changes little.
    let profiles = [
        Arcs::new([0.0, 0.0], 0.5 * PI - 0.2, &[(RADII[0], 0.2), (1e-3, 0.8)], true),
        Arcs::new([0.0, 0.0], 1.5 * PI - 0.2, &[(RADII[1], 0.4)], false),
    ];
    let angle = 0.5 * PI - 0.002;
    let shift = [0.15 * angle.cos(), 0.15 * angle.sin()];
    let edge_peak = |half_count| {
        let (grid, pressures) = press(&profiles, shift, half_count, automatic(), true);
        let zones = in_zones(&grid, &pressures);
        assert_eq!(zones[1], peak(&grid.cells, &pressures).unwrap().pressure);
        zones
    };
    let (coarse, fine) = (edge_peak(10), edge_peak(40));
    for (coarse, fine) in coarse.into_iter().zip(fine) {
        assert!((coarse / fine - 1.0).abs() < 0.03, "{coarse} {fine}");
    }
    // Without edges the cells end at the start of the edge.
    let (grid, _) = press(&profiles, shift, 10, automatic(), false);
    assert!(grid.cells.iter().all(|cell| !cell.edge));
    assert_eq!(grid.surface_ends, [true, false]);
}
