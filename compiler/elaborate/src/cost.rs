//! What a planned analysis will cost on a machine of known rates.

use crate::plan::Planned;
use calyx_runtime::cost::{Cost, Rates, positions, structure};
use calyx_runtime::overriding::Grid;

/// The costs of a plan's parts.
#[derive(Clone, Debug, PartialEq)]
pub struct PlannedCost {
    /// Each structure with the bodies that share it.
    pub structures: Vec<(Vec<String>, Cost)>,
    /// All positions, or steps in time.
    pub positions: Cost,
    /// Positions that are analysed.
    pub count: usize,
}

impl PlannedCost {
    /// s
    pub fn time(&self) -> f64 {
        self.positions.time + self.structures.iter().map(|(_, cost)| cost.time).sum::<f64>()
    }

    /// The most that is taken at once, bytes: structures are condensed side by side, and positions solved beside all that is kept.
    pub fn memory(&self) -> f64 {
        self.positions.memory.max(self.structures.iter().map(|(_, cost)| cost.memory).sum())
    }
}

impl PlannedCost {
    /// The predictions as a section of a plan.
    pub fn text(&self) -> String {
        let mut lines = vec!["Predicted for this machine, structures condensed anew".to_owned()];
        for (bodies, cost) in &self.structures {
            let names: Vec<String> = bodies.iter().map(|name| format!("\"{name}\"")).collect();
            lines.push(format!(
                "structure of {}: {}, {} while it is condensed",
                names.join(", "),
                seconds(cost.time),
                bytes(cost.memory)
            ));
        }
        if self.count > 0 {
            let each = self.positions.time / self.count as f64;
            lines.push(format!(
                "{} positions: {}, {} each",
                self.count,
                seconds(self.positions.time),
                seconds(each)
            ));
        }
        lines.push(format!("together {}, at most {}", seconds(self.time()), bytes(self.memory())));
        lines.join("\n  ") + "\n"
    }
}

/// In two digits or so: more would be a promise.
fn bytes(count: f64) -> String {
    match count {
        count if count < 1e9 => format!("{:.0} MB", (1e-6 * count).ceil()),
        count => format!("{:.1} GB", 1e-9 * count),
    }
}

fn seconds(time: f64) -> String {
    match time {
        time if time < 0.095 => format!("{:.0} ms", (1e3 * time).ceil()),
        time if time < 9.5 => format!("{time:.1} s"),
        time if time < 600.0 => format!("{time:.0} s"),
        time if time < 7200.0 => format!("{:.0} min", time / 60.0),
        time => format!("{:.1} h", time / 3600.0),
    }
}

impl Planned {
    /// Half the cells of the contact grids, the largest of all meshes; `None` if nothing meshes.
    pub fn grid(&self) -> Option<Grid> {
        self.meshes.iter().map(|mesh| mesh.grid).max_by_key(|grid| grid.half_cells)
    }

    /// Whether positions can be left out of its analysis.
    pub fn is_sampled(&self) -> bool {
        !self.in_time && self.positions.iter().sum::<usize>() >= 8
    }

    /// What it will cost.
    pub fn cost(&self, rates: &Rates) -> PlannedCost {
        let sizes = self.sizes();
        let structures = sizes.iter().map(|(names, size)| {
            (names.iter().map(|name| (*name).to_owned()).collect(), structure(size, self.in_space, rates))
        });
        let count = self.positions.iter().copied().max().unwrap_or(0);
        let twisted = self.in_space && sizes.iter().any(|(_, size)| !size.mirrored);
        let side_by_side = !self.in_time;
        PlannedCost {
            structures: structures.collect(),
            positions: positions(self.cells_in_contact(), twisted, count, side_by_side, rates),
            count,
        }
    }
}
