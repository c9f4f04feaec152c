//! Tolerance search among the fidelity levels of a pair of gears: a loose tolerance selects a cheap
//! level, a tight one an expensive level, and both meet their tolerance.

use crate::chapter_5_solid::pair::{PLAIN, Pair};
use crate::common::resources;
use calyx_runtime::analysis::{AnalysisOptions, mesh_cycle, quasi_static};
use calyx_runtime::results::AnalysisResult;
use calyx_runtime::scene::Fidelity;
use calyx_runtime::tolerance::quasi_static_within;

/// Transmission error and root stress at few positions, with a tolerance search from the cheapest
/// level up, or at a given level.
fn analyse(pair: &Pair, tolerance: Option<f64>, fidelity: &str, steps: usize) -> AnalysisResult {
    let (scene, cycle, outputs) = pair.scene();
    let outputs = outputs.into_iter().filter(|output| ["te", "pinion"].contains(&output.name.as_str()));
    let outputs: Vec<_> = outputs.collect();
    let options = AnalysisOptions {
        fidelity: Fidelity::named(fidelity).expect("a fidelity"),
        resources: resources(),
        ..AnalysisOptions::default()
    };
    let positions = mesh_cycle(&cycle, steps);
    let result = match tolerance {
        Some(part) => quasi_static_within(part, &scene, &positions, &outputs, &options, &mut ()),
        None => quasi_static(&scene, &positions, &outputs, &options, &mut ()),
    };
    result.expect("it can be had")
}

/// Closed forms are compared with plane finite elements, and these with three-dimensional ones. The
/// selected level meets the tolerance relative to the whole cycle at a higher level than closed
/// forms and sections.
#[test]
fn a_loose_tolerance_takes_closed_forms_and_a_tight_one_elements() {
    let exact = analyse(&PLAIN, None, "medium", 8);
    for (tolerance, takes_closed_forms) in [(0.3, true), (0.06, false)] {
        let result = analyse(&PLAIN, Some(tolerance), "rigid", 2);
        let outcome = result.tolerance_search.clone().expect("an outcome of the search");
        println!("{}", outcome.describe());
        assert_eq!(
            outcome.setting.fidelity == Fidelity::Analytic,
            takes_closed_forms,
            "{}",
            outcome.describe()
        );
        assert!(outcome.attempts.iter().any(|attempt| attempt.setting.fidelity == Fidelity::Rigid));
        assert!(outcome.attempts.last().is_some_and(|attempt| attempt.whole && attempt.worst.1 <= tolerance));
        for (own, exact) in result.summaries.iter().zip(&exact.summaries) {
            let off = (own.max - exact.max).abs().max((own.min - exact.min).abs());
            let scale = exact.max.abs().max(exact.min.abs());
            println!("{tolerance}: {:.2e}", off / scale);
            assert!(off <= tolerance * scale, "{tolerance}: {off} of {scale}");
        }
    }
}
