//! Tests of the sequence of settings, from prescribed errors.

use super::*;
use crate::results::ErrorEstimate;
use std::cmp::Ordering;
use std::iter;

#[test]
fn positions_double_but_for_jumps() {
    let at = |time: f64, name: &'static str| Position { name: Cow::Borrowed(name), ..Position::at(time) };
    let all = [at(0.0, ""), at(1.0, "A"), at(1.000001, "B"), at(2.0, "")];
    let times: Vec<f64> = doubled(&all).iter().map(|position| position.time).collect();
    assert_eq!(times, [0.0, 0.5, 1.0, 1.000001, 1.5000005, 2.0]);
}

/// Errors of a scene's outputs, relative to their largest magnitude.
#[derive(Clone, Copy)]
struct Errors {
    /// Model errors: rigid, analytic, plane, and all three-dimensional levels.
    levels: [f64; 4],
    /// Mesh errors of plane and three-dimensional models with the model's own elements;
    /// proportional to the square of the element size.
    meshes: [f64; 2],
    /// Error of the contact grid with the model's own cells.
    grid: f64,
    /// Error between the model's own positions.
    between: f64,
}

impl Errors {
    /// Returns the errors of a setting, and the total.
    fn of(&self, setting: &Setting) -> (Shortfall, f64) {
        let rank = match setting.fidelity {
            Fidelity::Rigid => 0,
            Fidelity::Analytic => 1,
            Fidelity::Plane => 2,
            Fidelity::Solid(_) => 3,
        };
        let mesh = if rank < 2 { 0.0 } else { self.meshes[rank - 2] / setting.refinement.powi(2) };
        let cells = LEFT_OF_GRID.powi(setting.cells.ilog2() as i32);
        let grid = if rank == 0 { 0.0 } else { self.grid * cells };
        let between = self.between / (setting.positions * setting.positions) as f64;
        // The comparison with the next level includes the mesh error of this one.
        let level = self.levels[rank] + mesh;
        let wanting = Shortfall { values: false, level, beyond_mesh: level - mesh, grid, between };
        (wanting, level + grid + between)
    }
}

/// Scene that a plane model represents well.
const FLAT: Errors =
    Errors { levels: [1.0, 0.1, 0.005, 0.0], meshes: [0.03, 0.01], grid: 4e-3, between: 1e-3 };
/// Scene with crowning.
const CROWNED: Errors = Errors { levels: [1.0, 0.1, 0.2, 0.0], ..FLAT };

#[test]
fn what_is_tried_follows_from_what_is_wrong() {
    let climbs: [(&str, f64, Errors, &[&str], bool); 8] = [
        ("closed forms will do", 0.15, FLAT, &["\"rigid\"", "\"analytic\""], true),
        (
            "a finer plane mesh before three-dimensional elements",
            0.02,
            FLAT,
            &[
                "\"rigid\"",
                "\"analytic\"",
                "\"plane\" with 0.5 times the elements along every direction",
                "\"plane\"",
                "\"plane\" with 2 times the elements along every direction",
            ],
            true,
        ),
        (
            "no finer mesh of a section that leaves out too much",
            0.02,
            CROWNED,
            &[
                "\"rigid\"",
                "\"analytic\"",
                "\"plane\" with 0.5 times the elements along every direction",
                "\"medium\"",
            ],
            true,
        ),
        (
            "contact cells at the cheapest level that has them",
            0.02,
            Errors { grid: 0.05, ..CROWNED },
            &[
                "\"rigid\"",
                "\"analytic\"",
                "\"analytic\", 2 times the cells of contact across and along",
                "\"plane\" with 0.5 times the elements along every direction, 2 times the cells of contact across and along",
                "\"medium\", 2 times the cells of contact across and along",
                "\"medium\", 4 times the cells of contact across and along",
            ],
            true,
        ),
        (
            "no number of cells will do",
            0.02,
            Errors { grid: 1.0, ..CROWNED },
            &["\"rigid\"", "\"analytic\""],
            false,
        ),
        (
            "positions before anything else",
            0.15,
            Errors { between: 0.1, ..FLAT },
            &["\"rigid\"", "\"rigid\", 2 times the positions", "\"analytic\", 2 times the positions"],
            true,
        ),
        (
            "no number of positions will do",
            0.15,
            Errors { between: 20.0, ..FLAT },
            &[
                "\"rigid\"",
                "\"rigid\", 2 times the positions",
                "\"rigid\", 4 times the positions",
                "\"rigid\", 8 times the positions",
            ],
            false,
        ),
        (
            "to the top",
            2e-4,
            Errors { grid: 0.0, between: 0.0, ..CROWNED },
            &[
                "\"rigid\"",
                "\"analytic\"",
                "\"plane\" with 0.5 times the elements along every direction",
                "\"medium\"",
                "\"fineroot\"",
                "\"finest\"",
                "\"finest\" with 1.4 times the elements along every direction",
            ],
            false,
        ),
    ];
    for (name, tolerance, errors, expected, kept) in climbs {
        let fidelity = Fidelity::Rigid;
        let setting = Setting { fidelity, refinement: meshes(fidelity)[0], cells: 1, positions: 1 };
        let mut ladder = Ladder { tolerance, setting, levels: fidelity.all_above().collect() };
        let is_kept = |ladder: &Ladder| errors.of(&ladder.setting).1 <= tolerance;
        let settings: Vec<Setting> = iter::from_fn(|| {
            let better = !is_kept(&ladder) && ladder.better(errors.of(&ladder.setting).0);
            better.then_some(ladder.setting)
        })
        .collect();
        let tried: Vec<String> = iter::once(setting).chain(settings).map(|s| s.describe()).collect();
        assert_eq!(
            (tried, is_kept(&ladder)),
            (expected.iter().map(|&s| s.to_owned()).collect(), kept),
            "{name}"
        );
    }
}

/// A level at which an output has no value is left for the next one, regardless of other errors;
/// without a next one the search fails.
#[test]
fn a_level_without_values_is_left() {
    let wanting = Shortfall {
        values: true,
        level: f64::INFINITY,
        beyond_mesh: f64::NAN,
        grid: f64::INFINITY,
        between: 1.0,
    };
    let setting = Setting { fidelity: Fidelity::Rigid, refinement: 1.0, cells: 2, positions: 4 };
    let mut ladder = Ladder { tolerance: 0.1, setting, levels: vec![Fidelity::Plane] };
    assert!(ladder.better(wanting));
    let Setting { fidelity, refinement, cells, positions } = ladder.setting;
    assert_eq!((fidelity, refinement, cells, positions), (Fidelity::Plane, 0.5, 2, 4));
    assert!(!ladder.better(wanting));
}

/// An output without an error estimate fails the tolerance, unless there is nothing to estimate.
#[test]
fn what_is_not_estimated_is_not_taken_for_exact() {
    let of = |missing: Part, fidelity: Fidelity, several: bool| {
        let parts = vec![(Part::Discretization, Statistics { max: 0.01, ..Statistics::default() })];
        let not_estimated = vec![(missing, "it was not to be had".to_owned())];
        let error = ErrorEstimate { parts, not_estimated, ..ErrorEstimate::default() };
        let summary = OutputSummary { min: 0.0, max: 1.0, error: Some(error), ..OutputSummary::none() };
        relative(&summary, &Part::ALL, fidelity, several)
    };
    let solid = Fidelity::Solid(Template::Medium);
    for (missing, fidelity, several, expected) in [
        (Part::ContactGrid, Fidelity::Plane, true, f64::INFINITY),
        (Part::Positions, Fidelity::Plane, true, f64::INFINITY),
        (Part::Positions, Fidelity::Plane, false, 0.01),
        (Part::Level, Fidelity::Analytic, true, f64::INFINITY),
        (Part::Level, solid, true, 0.01),
    ] {
        assert_eq!(
            of(missing, fidelity, several).total_cmp(&expected),
            Ordering::Equal,
            "{missing:?} {fidelity:?} {several}"
        );
    }
}
