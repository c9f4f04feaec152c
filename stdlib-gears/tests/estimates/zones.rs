//! Convergence of the largest contact pressures of the flank zone and the edge zone under
//! refinement of the contact grid, where a contact line ends at a tip edge, and the extent of the
//! grid there.

use super::suite::Row;
use super::*;

/// Similar to `examples/helical_pair.cx`, without tip relief: edges carry load. See
/// `data/effectivity.txt`.
const PAIR: &str = "ends no analytic 24 49 2.5 20 20 0 0 25 0 4 250 yes 1 3 12 4 2 1 3 12 4 2";

/// The same with tip relief.
const RELIEVED_PAIR: &str = "ends no analytic 24 49 2.5 20 20 0 0 25 12 4 250 yes 1 3 12 4 2 1 3 12 4 2";

/// Both on grids of 12 and 10, compared with 24 and 20 and twice as many positions.
const PAIR_TWICE: &str = "ends no analytic 24 49 2.5 20 20 0 0 25 0 4 250 yes 1 3 12 10 8 1 3 24 20 16";
const RELIEVED_PAIR_TWICE: &str =
    "relieved no analytic 24 49 2.5 20 20 0 0 25 12 4 250 yes 1 3 12 10 8 1 3 24 20 16";

/// Largest pressures of the flank and of the edge zone at a named position, Pa.
fn at(pair: &'static str, name: &str, cells: [usize; 2]) -> [f64; 2] {
    largest(pair, cells, 2, |position| position.name == name)
}

/// Largest pressures of the flank and of the edge zone at some of the `steps` positions of the mesh
/// cycle, Pa.
fn largest(
    pair: &'static str,
    cells: [usize; 2],
    steps: usize,
    wanted: impl Fn(&Position) -> bool,
) -> [f64; 2] {
    let row = Row::of(pair);
    let (mut scene, cycle, _) = row.scene();
    (scene.pairs[0].grid.half_cells, scene.pairs[0].grid.half_slices) = (Some(cells[0]), cells[1]);
    let mesh = PairId(0);
    let outputs = vec![
        OutputRequest::observing(
            "flank",
            scene.add_observable(calyx_runtime::observables::MaxContactPressure(mesh)),
        ),
        OutputRequest::observing(
            "edge",
            scene.add_observable(calyx_runtime::observables::MaxEdgePressure(mesh)),
        ),
    ];
    let positions: Vec<Position> = mesh_cycle(&cycle, steps).into_iter().filter(wanted).collect();
    let options = AnalysisOptions {
        fidelity: Fidelity::Analytic,
        resources: resources(),
        ..AnalysisOptions::default()
    };
    let result = quasi_static(&scene, &positions, &outputs, &options, &mut ()).expect("it runs");
    [0, 1].map(|output: usize| result.summaries[output].max)
}

/// M and N of the compared grids; a finer one takes minutes.
const GRIDS: [[usize; 2]; 3] = [[6, 5], [12, 10], [12, 20]];

/// Deviation of the largest pressure of the flank zone from that of the finest grid, relative to
/// it.
fn deviations(found: &[[f64; 2]; 3]) -> [f64; 2] {
    println!("{found:?}");
    [0, 1].map(|grid: usize| (found[grid][0] / found[2][0] - 1.0).abs())
}

/// Without tip relief, tip edges carry many times the pressure of the flank. The pressure rises
/// towards the edge, and finer grids in both directions resolve it increasingly well.
#[test]
fn the_largest_contact_pressure_converges_where_a_contact_line_ends_at_a_tip_edge() {
    for (position, limits) in [("HPSTC", [0.12, 0.05]), ("LPSTC", [0.05, 0.025])] {
        let found = GRIDS.map(|cells| at(PAIR, position, cells));
        let off = deviations(&found);
        assert!(off[0] < limits[0] && off[1] < limits[1], "{position}: {off:?}");
        // The edge zone carries the rest.
        assert!(found.iter().all(|[flank, edge]| *edge > 2.0 * flank), "{position}: {found:?}");
    }
}

#[test]
fn the_largest_contact_pressure_converges_on_relieved_flanks() {
    for position in ["HPSTC", "LPSTC"] {
        let off = deviations(&GRIDS.map(|cells| at(RELIEVED_PAIR, position, cells)));
        assert!(off[0] < 0.015 && off[1] < 0.01, "{position}: {off:?}");
    }
}

/// A pair of teeth enters at a corner of the face: the contact line is a millimetre long, and its
/// pressure at the side face is singular.
#[test]
fn the_largest_contact_pressure_converges_where_a_contact_line_begins_at_a_side_face() {
    const ENTERING: &str = "entering no analytic 19 61 4.5 20 25 0.1 -0.1 40 12 0 900 no 1 3 6 6 6 1 3 6 6 6";
    let grids = [[6, 6], [6, 12], [6, 24], [6, 36]];
    let found = grids.map(|cells| largest(ENTERING, cells, 64, |position| position.cycle == 27.0 / 64.0)[0]);
    println!("{found:?}");
    let finest = found[3];
    for (own, limit) in found.into_iter().zip([0.1, 0.05, 0.01]) {
        assert!((own / finest - 1.0).abs() < limit, "{found:?}");
    }
}

/// The finer run has twice as many cells across and along, and twice as many positions.
#[test]
#[ignore = "takes minutes: .ci/full runs it"]
fn the_estimate_covers_the_change_on_a_finer_grid() {
    for pair in [RELIEVED_PAIR_TWICE, PAIR_TWICE] {
        let all = Row::of(pair).measured();
        all.iter().for_each(|one| println!("{}", one.line()));
        let of_pressure = all.iter().filter(|one| one.output == "pressure" && one.statistic == "max");
        assert!(of_pressure.map(suite::Measured::effectivity).all(|ratio| ratio > 0.5));
    }
}

/// Transmission error at one of the `steps` positions of the mesh cycle, rad.
fn transmission_error_at(row: &Row, steps: usize, cycle: f64, cells: [usize; 2]) -> f64 {
    let (mut scene, mesh, outputs) = row.scene();
    (scene.pairs[0].grid.half_cells, scene.pairs[0].grid.half_slices) = (Some(cells[0]), cells[1]);
    let positions: Vec<Position> =
        mesh_cycle(&mesh, steps).into_iter().filter(|position| position.cycle == cycle).collect();
    let options = AnalysisOptions {
        fidelity: Fidelity::Analytic,
        resources: resources(),
        ..AnalysisOptions::default()
    };
    quasi_static(&scene, &positions, &outputs[..1], &options, &mut ()).expect("it runs").summaries[0].max
}

/// A contact line that ends at a tip edge has its closest approach there. A grid that is made wider
/// must still cover all of it: at this position it covered half, and the transmission error was
/// larger by 5 %.
#[test]
fn a_wider_grid_covers_a_contact_line_that_ends_at_a_tip_edge() {
    let row = Row::of("wider no analytic 19 31 5 25 20 0 0 33 6 0 875 no 1 3 6 5 8 1 3 6 5 8");
    let [coarse, fine] = [[3, 3], [6, 5]].map(|cells| transmission_error_at(&row, 8, 0.875, cells));
    println!("{coarse} {fine}");
    assert!((coarse / fine - 1.0).abs() < 0.005, "{coarse} {fine}");
}

/// At this position a pair of teeth enters at a corner of the face, on a contact line of half a
/// millimetre. An oblique side face ends its grid, which a wider one cannot change. The grid was
/// made eight times wider than needed instead, none of its cells touched, and the transmission
/// error was larger by 2 %.
#[test]
fn a_grid_that_an_oblique_side_face_ends_is_not_made_wider() {
    let row = Row::of("entering no analytic 22 29 2.5 20 22 0 0 18 0 3 90 no 1 3 6 5 3 1 3 12 10 32");
    let [coarse, fine] = [[6, 5], [12, 10]].map(|cells| transmission_error_at(&row, 32, 0.59375, cells));
    println!("{coarse} {fine}");
    assert!((coarse / fine - 1.0).abs() < 0.001, "{coarse} {fine}");
}
