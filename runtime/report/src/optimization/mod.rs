//! Results of an optimization: the best design found, its constraints, the local searches from
//! several starts, and how the objective changes near the optimum. All numbers are in SI.

mod files;
mod text;

pub use files::{DESIGNS, OPTIMUM, OPTIMUM_HEADER, write_designs, write_optimum};
pub use text::text;
#[cfg(feature = "pages")]
pub(crate) use text::{agreement, influence, missing};

use crate::sample::{Objective, Statistic};
use crate::sweep::Column;
use calyx_abi::units::{from_si, shortest};
use std::cmp::Ordering;
use std::fmt;

/// Measure of a value over several load cases or samples.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Measure {
    /// The worst value: the largest one of what is minimized or has an upper bound.
    Worst,
    Mean,
    /// Percentile, counted towards the worst value.
    Percentile(f64),
}

impl Measure {
    /// Parses `worst`, `mean` or `percentile P`.
    pub fn named(text: &str) -> Option<Measure> {
        match text.split_whitespace().collect::<Vec<_>>()[..] {
            ["worst"] => Some(Measure::Worst),
            ["mean"] => Some(Measure::Mean),
            ["percentile", percent] => {
                let percent = percent.parse().ok().filter(|percent: &f64| (0.0..=100.0).contains(percent));
                percent.map(Measure::Percentile)
            }
            _ => None,
        }
    }

    /// Returns the measure of some values, of which larger ones are worse; infinite without values.
    pub fn of(self, values: &[f64]) -> f64 {
        if values.is_empty() || values.iter().any(|value| value.is_nan()) {
            return f64::INFINITY;
        }
        match self {
            Measure::Worst => values.iter().copied().fold(f64::NEG_INFINITY, f64::max),
            Measure::Mean => values.iter().sum::<f64>() / values.len() as f64,
            Measure::Percentile(percent) => {
                let mut sorted = values.to_vec();
                sorted.sort_by(f64::total_cmp);
                // Linear between the order statistics: continuous in all values.
                let at = percent / 100.0 * (sorted.len() - 1) as f64;
                let (below, part) = (at.floor() as usize, at.fract());
                let above = (below + 1).min(sorted.len() - 1);
                sorted[below] + part * (sorted[above] - sorted[below])
            }
        }
    }
}

impl fmt::Display for Measure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Measure::Worst => f.write_str("worst"),
            Measure::Mean => f.write_str("mean"),
            Measure::Percentile(percent) => write!(f, "percentile {percent}"),
        }
    }
}

/// Bound of a statistic of an output.
#[derive(Clone, Debug, PartialEq)]
pub struct Constraint {
    pub output: String,
    pub statistic: Statistic,
    /// True for an upper bound.
    pub at_most: bool,
    pub bound: f64,
}

/// Variable of a design, with its bounds.
#[derive(Clone, Debug, PartialEq)]
pub struct Variable {
    pub column: Column,
    pub low: f64,
    pub high: f64,
    /// Value of the initial design.
    pub initial: f64,
}

impl Variable {
    pub fn shown(&self, si: f64) -> String {
        shortest(from_si(si, self.column.factor))
    }
}

/// Values of a design.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Values {
    /// Objective over all load cases.
    pub objective: f64,
    /// Objective by load case.
    pub cases: Vec<f64>,
    /// Constrained values by constraint and load case.
    pub constraints: Vec<Vec<f64>>,
    /// Largest violation of a constraint, relative to its bound; zero or less if all are met.
    pub violation: f64,
}

/// Design that was evaluated.
#[derive(Clone, Debug, PartialEq)]
pub struct Design {
    /// Number of the local search, from 1; 0 for the designs from which the starts are chosen, and
    /// for those near the optimum.
    pub search: usize,
    /// Values of the variables.
    pub variables: Vec<f64>,
    /// Values, or the reason of a failure.
    pub values: Result<Values, String>,
}

/// Local search from a start.
#[derive(Clone, Debug, PartialEq)]
pub struct Search {
    /// Number from 1.
    pub number: usize,
    /// Variables of the start.
    pub start: Vec<f64>,
    /// Best design found: its variables and values; `None` if all designs failed.
    pub best: Option<(Vec<f64>, Values)>,
    /// Number of evaluated designs.
    pub designs: usize,
    /// True if the search ended by itself and not at the limit of the number of designs.
    pub converged: bool,
}

/// Change of the values when one variable of the optimum moves by [`STEP`] of its range.
#[derive(Clone, Debug, PartialEq)]
pub struct Influence {
    /// Values after a step downwards and upwards, or the reason of a failure; `None` outside of the
    /// range.
    pub steps: [Option<Result<Values, String>>; 2],
}

/// Step of a variable near the optimum, relative to its range.
pub const STEP: f64 = 0.01;

/// Largest relative violation of a constraint that counts as met.
pub const FEASIBLE: f64 = 1e-6;
/// Relative distance from a bound below which a constraint or variable is active.
pub const ACTIVE: f64 = 1e-3;

/// Function that determines the optimum: a value of a load case, or a constraint.
#[derive(Clone, Debug, PartialEq)]
pub struct Multiplier {
    /// Constraint; `None` for the objective.
    pub constraint: Option<usize>,
    pub case: usize,
    /// For a load case of the objective its share, which add up to one; for a constraint the change
    /// of the objective per change of the bound, both relative to their own magnitudes.
    pub value: f64,
}

/// Certificate of a local optimum: weights of the active functions whose gradients balance.
#[derive(Clone, Debug, PartialEq)]
pub struct Optimality {
    pub multipliers: Vec<Multiplier>,
    /// Length of the unbalanced gradient: the change of the objective, relative to its magnitude, per
    /// range of the variables; zero at an optimum of a smooth problem.
    pub residual: f64,
}

/// Result of an optimization.
#[derive(Clone, Debug, PartialEq)]
pub struct Optimization {
    pub model: String,
    pub doc: String,
    pub variables: Vec<Variable>,
    pub objective: Objective,
    /// Column of the output of the objective.
    pub column: Column,
    pub over_cases: Measure,
    /// Measure over the samples of toleranced params, and their number; `None` without a sample.
    pub over_samples: Option<(Measure, usize)>,
    pub constraints: Vec<Constraint>,
    /// Columns of the outputs of the constraints.
    pub constraint_columns: Vec<Column>,
    /// Labels of the load cases.
    pub cases: Vec<String>,
    /// Values of the initial design, or the reason of its failure.
    pub initial: Result<Values, String>,
    pub searches: Vec<Search>,
    /// All evaluated designs.
    pub designs: Vec<Design>,
    /// Influence by variable; empty if the optimization was interrupted.
    pub influences: Vec<Influence>,
    pub optimality: Option<Optimality>,
    /// True if the optimization was interrupted.
    pub interrupted: bool,
}

/// Relative difference of objectives below which two searches have the same optimum.
pub const SAME_OBJECTIVE: f64 = 1e-3;
/// Part of the improvement below which an objective counts as zero.
pub const SMALL: f64 = 1e-3;
/// Difference of variables, relative to their ranges, below which they agree.
pub const SAME_VARIABLE: f64 = 0.01;

/// Orders designs from good to bad: first those that meet all constraints, by their objective, then
/// the others, by their violation.
pub fn compare(objective: &Objective, one: &Values, other: &Values) -> Ordering {
    let key = |values: &Values| {
        let feasible = values.violation <= FEASIBLE;
        let cost = if objective.maximize { -values.objective } else { values.objective };
        (!feasible, if feasible { cost } else { values.violation })
    };
    let (one, other) = (key(one), key(other));
    one.0.cmp(&other.0).then(one.1.total_cmp(&other.1))
}

impl Optimization {
    /// Returns whether a design is better than another one.
    pub fn is_better(&self, one: &Values, other: &Values) -> bool {
        compare(&self.objective, one, other) == Ordering::Less
    }

    /// Returns the index of the best search; `None` if all designs failed.
    pub fn best_search(&self) -> Option<usize> {
        let known = (0..self.searches.len()).filter(|&k| self.searches[k].best.is_some());
        known.reduce(|best, k| match (&self.searches[k].best, &self.searches[best].best) {
            (Some(one), Some(other)) if self.is_better(&one.1, &other.1) => k,
            _ => best,
        })
    }

    /// Returns the best design: variables and values.
    pub fn best(&self) -> Option<&(Vec<f64>, Values)> {
        self.searches[self.best_search()?].best.as_ref()
    }

    /// Returns whether the search `k` has the objective of the best one, and whether its variables
    /// agree too.
    pub fn agreement(&self, k: usize) -> [bool; 2] {
        let (Some(best), Some(own)) = (self.best(), &self.searches[k].best) else { return [false; 2] };
        let off = (own.1.objective - best.1.objective).abs();
        let same = off <= SAME_OBJECTIVE * self.scale() && own.1.violation <= FEASIBLE.max(best.1.violation);
        let near = |(variable, (one, other)): (&Variable, (&f64, &f64))| {
            (one - other).abs() <= SAME_VARIABLE * (variable.high - variable.low)
        };
        [same, same && self.variables.iter().zip(own.0.iter().zip(&best.0)).all(near)]
    }

    /// Returns the magnitude of the objective: that of the best design, but not less than a small part
    /// of the improvement, for an objective that becomes zero.
    pub fn scale(&self) -> f64 {
        let Some((_, best)) = self.best() else { return 0.0 };
        let initial = self.initial.as_ref().ok().map(|values| values.objective);
        let searches = self.searches.iter().filter_map(|search| Some(search.best.as_ref()?.1.objective));
        let others = initial.into_iter().chain(searches.filter(|_| initial.is_none()));
        let improvement = others.map(|other| (other - best.objective).abs()).fold(0.0, f64::max);
        best.objective.abs().max(SMALL * improvement)
    }

    /// Returns whether a constraint of a design is violated or active, as a word.
    pub fn state_of(&self, values: &Values, constraint: usize) -> &'static str {
        let Some((_, value)) = self.governing(values, constraint) else { return "" };
        let own = &self.constraints[constraint];
        let off = if own.at_most { value - own.bound } else { own.bound - value };
        match () {
            () if off > FEASIBLE * own.magnitude(&self.constraint_columns[constraint]) => "violated",
            () if self.is_active(values, constraint) => "active",
            () => "",
        }
    }

    /// Returns the load case in which a constraint of a design is nearest to its bound, with the
    /// value there.
    pub fn governing(&self, values: &Values, constraint: usize) -> Option<(usize, f64)> {
        let at_most = self.constraints.get(constraint)?.at_most;
        let all = values.constraints.get(constraint)?.iter().copied().enumerate();
        all.reduce(|worst, one| if (one.1 > worst.1) == at_most { one } else { worst })
    }

    /// Returns whether a constraint is active at a design.
    pub fn is_active(&self, values: &Values, constraint: usize) -> bool {
        let Some((_, value)) = self.governing(values, constraint) else { return false };
        let own = &self.constraints[constraint];
        (value - own.bound).abs() <= ACTIVE * own.magnitude(&self.constraint_columns[constraint])
    }

    /// Returns the bound at which a variable is, if any.
    pub fn bound_of(&self, index: usize, value: f64) -> Option<&'static str> {
        let Variable { low, high, .. } = &self.variables[index];
        let near = ACTIVE * (high - low);
        match () {
            () if value - low <= near => Some("lower bound"),
            () if high - value <= near => Some("upper bound"),
            () => None,
        }
    }

    /// Describes the objective in a sentence.
    pub fn goal(&self) -> String {
        let verb = if self.objective.maximize { "maximize" } else { "minimize" };
        let mut goal = format!("{verb} {}, {}", self.objective.output, self.objective.statistic.described());
        if self.cases.len() > 1 {
            goal += &format!(", {} of {} load cases", self.over_cases, self.cases.len());
        }
        if let Some((measure, count)) = &self.over_samples {
            goal += &format!(", {measure} of {count} samples");
        }
        goal
    }
}

impl Constraint {
    /// Returns the magnitude by which a violation is divided: that of the bound, or the unit of the
    /// output if the bound is zero.
    pub fn magnitude(&self, column: &Column) -> f64 {
        if self.bound == 0.0 { column.factor.abs() } else { self.bound.abs() }
    }

    /// Returns the constraint as text, with the bound in the unit of its output.
    pub fn shown(&self, column: &Column) -> String {
        let sign = if self.at_most { "<=" } else { ">=" };
        let unit = if column.unit.is_empty() || column.unit == "1" {
            String::new()
        } else {
            format!(" {}", column.unit)
        };
        let bound = shortest(from_si(self.bound, column.factor));
        format!("{}.{} {sign} {bound}{unit}", self.output, self.statistic.name())
    }
}
