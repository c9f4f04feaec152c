//! Largest contact pressures of the flank and of the edge zone over finer and finer contact grids, where a contact line ends at a tip
//! edge.

use super::suite::Row;
use super::*;

/// As `examples/helical_pair.cx` nearly, without tip relief: edges carry load. See `data/effectivity.txt`.
const PAIR: &str = "ends no analytic 24 49 2.5 20 20 0 0 25 0 4 250 yes 1 3 12 4 2 1 3 12 4 2";

/// The same with tip relief.
const RELIEVED_PAIR: &str = "ends no analytic 24 49 2.5 20 20 0 0 25 12 4 250 yes 1 3 12 4 2 1 3 12 4 2";

/// Largest pressures of the flank and of the edge zone at a named position, Pa.
fn at(pair: &'static str, name: &str, cells: [usize; 2]) -> [f64; 2] {
    let row = Row::of(pair);
    let (mut scene, cycle, _) = row.scene();
    (scene.pairs[0].grid.half_cells, scene.pairs[0].grid.half_slices) = (Some(cells[0]), cells[1]);
    let mesh = calyx_runtime::scene::PairId(0);
    let outputs = vec![
        OutputRequest::observing("flank", scene.observe(calyx_runtime::observe::MaxContactPressure(mesh))),
        OutputRequest::observing("edge", scene.observe(calyx_runtime::observe::MaxEdgePressure(mesh))),
    ];
    let positions =
        mesh_cycle(&cycle, 2).into_iter().filter(|position| position.name == name).collect::<Vec<_>>();
    let options = AnalysisOptions {
        fidelity: Fidelity::Analytic,
        resources: resources(),
        ..AnalysisOptions::default()
    };
    let result = quasi_static(&scene, &positions, &outputs, &options, &mut ()).expect("it runs");
    [0, 1].map(|output: usize| result.summaries[output].max)
}

/// Without tip relief tip edges carry tens of GPa, more on every finer grid: the flank has nothing of it. Its slices carry load or not by
/// single cells, which leaves some hundredths.
#[test]
fn the_largest_contact_pressure_converges_where_a_contact_line_ends_at_a_tip_edge() {
    let found = [6, 12, 24, 48].map(|cells| at(PAIR, "HPSTC", [cells, 4]));
    println!("{found:?}");
    let off = [0, 1, 2].map(|grid: usize| (found[grid][0] / found[3][0] - 1.0).abs());
    assert!(off.iter().all(|off| *off < 0.03), "{off:?}");
    // The edge has the rest, which is singular.
    assert!(
        (0..3).all(|grid| found[grid][1] > found[grid][0] && found[grid + 1][1] > found[grid][1]),
        "{found:?}"
    );
}

/// With relief edges carry next to nothing, and every finer grid is better.
#[test]
fn the_largest_contact_pressure_converges_on_relieved_flanks() {
    let found = [6, 12, 24].map(|cells| at(RELIEVED_PAIR, "HPSTC", [cells, 4])[0]);
    println!("{found:?}");
    let off = [0, 1].map(|grid: usize| (found[grid] / found[2] - 1.0).abs());
    assert!(off[0] < 0.04 && off[1] < 0.01, "{off:?}");
}
