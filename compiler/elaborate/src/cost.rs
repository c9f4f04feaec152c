//! Predicted cost of a planned analysis on a machine with known rates.

use crate::plan::{Planned, PlannedWork};
use calyx_runtime::cost::{AnalysisCost, Rates};
use calyx_runtime::estimate::Estimates;
use calyx_runtime::settings_override::Grid;
use calyx_runtime::tolerance::{SearchCost, search_cost};

/// The costs of the parts of a plan.
#[derive(Clone, Debug, PartialEq)]
pub struct PlannedCost {
    /// Cost of the analysis with the model's own setting.
    pub analysis: AnalysisCost,
    /// The tolerance and the cost of the search for a setting that meets it, if the model requests
    /// a tolerance.
    pub search: Option<(f64, SearchCost)>,
    estimates: Estimates,
}

/// Number of positions at which settings are compared for a tolerance: some are spread over all
/// positions, the others are the characteristic points of a mesh cycle.
const COMPARED: usize = 8;

impl PlannedCost {
    fn of(work: &PlannedWork, rates: &Rates) -> PlannedCost {
        let task = work.task();
        // The scene was planned before, so planning cannot fail here.
        let analysis = task.cost(rates).unwrap_or_default();
        let search = work.tolerance().map(|tolerance| (tolerance, search_cost(&task, COMPARED, rates)));
        PlannedCost { analysis, search, estimates: work.estimates() }
    }

    /// Returns the time, s. For a tolerance search, this is an upper bound.
    pub fn time(&self) -> f64 {
        self.search.as_ref().map_or(self.analysis.time(), |(_, search)| search.most)
    }

    /// Returns the time of a run of a study, s: it does not compute the derivatives that the model
    /// requests.
    pub fn time_in_study(&self) -> f64 {
        self.time() - if self.search.is_none() { self.analysis.derivatives.time } else { 0.0 }
    }

    /// Returns the peak memory use, bytes.
    pub fn memory(&self) -> f64 {
        let candidates = self.search.iter().flat_map(|(_, search)| &search.candidates);
        candidates.map(|candidate| candidate.memory).fold(self.analysis.memory(), f64::max)
    }

    /// Returns the predictions as a section of a plan.
    pub fn text(&self) -> String {
        let lines = match &self.search {
            Some((tolerance, search)) => search_lines(*tolerance, search),
            None => self.analysis_lines(),
        };
        lines.join("\n  ") + "\n"
    }

    fn analysis_lines(&self) -> Vec<String> {
        let AnalysisCost {
            structures,
            positions,
            count,
            of_load_factors,
            of_forced_response,
            sounds,
            errors,
            derivatives,
        } = &self.analysis;
        let mut lines = vec!["Predicted for this machine, without cached structures".to_owned()];
        for (bodies, cost) in structures {
            let names: Vec<String> = bodies.iter().map(|name| format!("\"{name}\"")).collect();
            lines.push(format!(
                "structure of {}: {}, {} during condensation",
                names.join(", "),
                seconds(cost.time),
                bytes(cost.memory)
            ));
        }
        if *count > 0 {
            let each = positions.time / (count + of_load_factors + of_forced_response) as f64;
            let mut more = String::new();
            if *of_load_factors > 0 {
                more += &format!(", and {of_load_factors} over mesh cycles for load factors");
            }
            if *of_forced_response > 0 {
                more += &format!(", and {of_forced_response} for the forced response");
            }
            lines.push(format!(
                "{count} positions{more}: {}, {} each",
                seconds(positions.time),
                seconds(each)
            ));
        }
        for (body, cost) in sounds {
            lines.push(format!(
                "radiated sound of \"{body}\": {}, {}",
                seconds(cost.time),
                bytes(cost.memory)
            ));
        }
        if self.estimates != Estimates::None {
            lines.push(format!("\"{}\" error estimates: {}", self.estimates.name(), seconds(errors.time)));
        }
        if derivatives.time > 0.0 {
            lines.push(format!(
                "derivatives: {}; params that change structures take longer",
                seconds(derivatives.time)
            ));
        }
        lines.push(format!("total {}, peak memory {}", seconds(self.time()), bytes(self.memory())));
        lines
    }
}

fn search_lines(tolerance: f64, search: &SearchCost) -> Vec<String> {
    let percent = (1e6 * tolerance).round() / 1e4;
    let mut lines = vec![
        format!("Predicted for this machine, to a tolerance of {percent} %"),
        "settings are tried in this order until the estimated error meets it; error estimates included"
            .into(),
    ];
    for candidate in &search.candidates {
        lines.push(format!(
            "{}: {} to compare at a few positions, {} for all positions",
            candidate.setting.describe(),
            seconds(candidate.few),
            seconds(candidate.all)
        ));
    }
    lines.push("finer contact grids or more positions take longer, if they are needed".into());
    lines
        .push(format!("at most {}; the search then ends with the best results so far", seconds(search.most)));
    lines
}

/// Formats a number of bytes with about two digits, the precision of the prediction.
fn bytes(count: f64) -> String {
    match count {
        count if count < 1e6 => "below 1 MB".to_owned(),
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
    /// Returns half the cells of the contact grids, the maximum over all meshes; `None` without
    /// meshes.
    pub fn grid(&self) -> Option<Grid> {
        self.meshes.iter().map(|mesh| mesh.grid).max_by_key(|grid| grid.half_cells)
    }

    /// Returns `true` if the analysis may skip positions.
    pub fn is_sampled(&self) -> bool {
        !self.in_time && self.positions.iter().sum::<usize>() >= 8
    }

    /// Predicts the cost.
    pub fn cost(&self, rates: &Rates) -> PlannedCost {
        PlannedCost::of(&self.work, rates)
    }
}
