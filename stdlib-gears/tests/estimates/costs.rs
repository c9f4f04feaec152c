//! Cost of error estimates relative to the run: the positions solved for them, each weighted by the
//! square of its number of contact cells, in proportion to its cost. The test counts them instead
//! of measuring time.

use super::*;
use calyx_runtime::observables::{Equilibrium, Observable, Quantity};
use calyx_runtime::results::Observed;
use std::sync::{Arc, Mutex};

/// Number of contact cells across half a patch, for every solved position.
#[derive(Clone, Debug, Default)]
struct Solved(Arc<Mutex<Vec<usize>>>);

impl PartialEq for Solved {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

impl Observable for Solved {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("solved", "1")
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        let cells = at.scene().pairs[0].grid.plane_half_cells();
        self.0.lock().expect("nothing panics under the lock").push(cells);
        Observed::number(1.0)
    }
}

/// "cheap" estimates cost no more than about the run itself, however few positions it has.
#[test]
fn estimates_cost_no_more_than_the_run() {
    const CELLS: usize = 12;
    let structure = StructureOptions { refinement: 0.5, order: 2, ..MESH };
    for steps in [2, 4, 12] {
        let count = |estimates| {
            let (mut scene, cycle, mut outputs) = PLAIN.scene();
            let solved = Solved::default();
            outputs.push(OutputRequest::observing("solved", scene.add_observable(solved.clone())));
            let setting = Setting { structure, cells: Some([CELLS, 8]), steps, estimates, ..PLANE };
            let (result, _) = analyse_scene((scene, &cycle), &outputs, &setting);
            let cells = solved.0.lock().expect("nothing panics under the lock").clone();
            let effort: f64 = cells.iter().map(|&own| (own as f64 / CELLS as f64).powi(2)).sum();
            (result.rows.len(), effort)
        };
        let (rows, alone) = count(Estimates::None);
        assert_eq!(alone, rows as f64);
        let (_, judged) = count(Estimates::Cheap);
        let ratio = judged / alone - 1.0;
        println!("{rows} positions: estimates take {ratio:.2} of what they take");
        assert!((0.1..=1.2).contains(&ratio), "{rows} positions: {ratio}");
    }
}
