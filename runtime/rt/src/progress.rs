//! Progress with the remaining time: a bar on a terminal, or one JSON object per line for programs.

use crate::console::{eprintln, println};
use calyx_runtime::tolerance::SearchProgress;
use clap::ValueEnum;
use indicatif::{HumanDuration, ProgressBar, ProgressDrawTarget, ProgressStyle};
use serde_json::json;
use std::cell::Cell;
use std::sync::Mutex;
use std::time::{Duration, Instant};

/// How progress is shown.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum ProgressFormat {
    /// Progress bar, if standard error is a terminal
    #[default]
    Human,
    /// One JSON object per line: stage, done, total, seconds_left
    ///
    /// Printed at the start of a stage and after each position. Unknown values are null.
    Json,
}

/// Display of the current stage and, during the stage `positions`, of the remaining ones.
pub struct Progress {
    bar: ProgressBar,
    quiet: bool,
    /// Redirects the text that the program prints to standard error.
    print_to_error: bool,
    /// Current stage and its start time, for JSON lines.
    lines: Option<Mutex<(&'static str, Instant)>>,
}

impl Progress {
    /// Creates a display on standard error; without a bar if `quiet` or if that is no terminal. The
    /// text that the program prints goes to standard output, or with `print_to_error` to standard
    /// error.
    pub fn new(format: ProgressFormat, quiet: bool, print_to_error: bool) -> Progress {
        let json = format == ProgressFormat::Json;
        let target = if quiet || json { ProgressDrawTarget::hidden() } else { ProgressDrawTarget::stderr() };
        let bar = ProgressBar::with_draw_target(None, target);
        bar.set_style(style("{spinner} {msg}"));
        bar.enable_steady_tick(Duration::from_millis(100));
        Progress { bar, quiet, print_to_error, lines: json.then(|| Mutex::new(("", Instant::now()))) }
    }

    pub fn stage(&self, name: &'static str) {
        self.bar.set_message(name);
        if let Some(Ok(mut stage)) = self.lines.as_ref().map(Mutex::lock) {
            *stage = (name, Instant::now());
            eprintln!("{}", line(name, 0, None, None));
        }
    }

    /// Shows the setting that the tolerance search tries, and the best one before it.
    pub fn choosing(&self, choosing: &SearchProgress) {
        if let Some(lines) = &self.lines {
            let mut line = line("choosing", 0, None, None);
            line["setting"] = json!(choosing.setting.describe());
            line["all_positions"] = json!(choosing.whole);
            line["work_done"] = json!(choosing.part);
            if let Some(best) = &choosing.best {
                line["best"] = json!(best.setting.describe());
                line["best_error"] = json!(best.worst.1);
            }
            let _order = lines.lock();
            eprintln!("{line}");
        } else {
            self.note(&choosing.describe());
        }
    }

    pub fn step(&self, index: usize, count: usize) {
        if self.bar.length() != Some(count as u64) {
            self.bar.set_length(count as u64);
            self.bar.set_style(style("{spinner} {msg} [{bar:32}] {pos}/{len}, {eta} left"));
        }
        self.bar.set_position(index as u64 + 1);
        if let Some(Ok(stage)) = self.lines.as_ref().map(Mutex::lock) {
            let (name, began) = *stage;
            eprintln!("{}", line(name, index + 1, Some(count), Some(began.elapsed())));
        }
    }

    /// Shows the state of a search whose end is unknown, and how many steps it has done.
    pub fn searching(&self, state: &str, done: usize) {
        self.bar.set_message(state.to_owned());
        if let Some(Ok(stage)) = self.lines.as_ref().map(Mutex::lock) {
            eprintln!("{}", line(stage.0, done, None, None));
        }
    }

    pub fn finish(&self) {
        self.bar.finish_and_clear();
    }

    /// Prints a line of the program without disturbing the bar.
    pub fn print(&self, line: &str) {
        self.bar.suspend(|| match self.print_to_error {
            true => eprintln!("{line}"),
            false => println!("{line}"),
        });
    }

    /// Prints a note for the user on standard error.
    pub fn note(&self, text: &str) {
        if !self.quiet {
            self.bar.suspend(|| eprintln!("{text}"));
        }
    }
}

/// Display of a campaign of runs: the current run, and the remaining time of all runs, predicted
/// and corrected by the measured duration of the completed ones.
pub struct CampaignProgress {
    bar: ProgressBar,
    json: bool,
    /// Predicted duration of each run, s.
    predicted: Vec<f64>,
    began: Instant,
    /// Index of the current run.
    index: Cell<usize>,
}

impl CampaignProgress {
    /// Creates a display on standard error, as [`Progress::new`] does.
    pub fn new(format: ProgressFormat, quiet: bool, predicted: Vec<f64>) -> CampaignProgress {
        let json = format == ProgressFormat::Json;
        let target = if quiet || json { ProgressDrawTarget::hidden() } else { ProgressDrawTarget::stderr() };
        let bar = ProgressBar::with_draw_target(Some(predicted.len() as u64), target);
        bar.set_style(style("{spinner} [{bar:32}] {pos}/{len} {msg}"));
        bar.enable_steady_tick(Duration::from_millis(100));
        CampaignProgress { bar, json, predicted, began: Instant::now(), index: Cell::new(0) }
    }

    /// Starts a run.
    pub fn begin(&self, index: usize, name: &str) {
        self.index.set(index);
        let left = seconds_left(&self.predicted, index, self.began.elapsed().as_secs_f64());
        self.bar.set_position(index as u64);
        self.bar.set_message(format!(
            "{name}, about {} left",
            HumanDuration(Duration::from_secs_f64(left.max(0.0)))
        ));
        if self.json {
            let count = self.predicted.len();
            eprintln!("{}", json!({ "stage": name, "done": index, "total": count, "seconds_left": left }));
        }
    }

    pub fn finish(&self) {
        self.bar.finish_and_clear();
    }
}

/// Estimates the remaining time from the predicted durations, when the first `done` runs have taken
/// `elapsed`, s.
pub fn seconds_left(predicted: &[f64], done: usize, elapsed: f64) -> f64 {
    let (before, after) = predicted.split_at(done.min(predicted.len()));
    let (before, after): (f64, f64) = (before.iter().sum(), after.iter().sum());
    // The first moments of a run are too short to correct the prediction.
    let scale = if before > 0.0 && elapsed > 0.5 { elapsed / before } else { 1.0 };
    after * scale
}

/// Formats a JSON line; the remaining time is extrapolated from the elapsed one.
pub fn line(stage: &str, done: usize, total: Option<usize>, elapsed: Option<Duration>) -> serde_json::Value {
    let left = elapsed.zip(total).filter(|_| done > 0);
    let left =
        left.map(|(elapsed, total)| elapsed.as_secs_f64() / done as f64 * total.saturating_sub(done) as f64);
    json!({ "stage": stage, "done": done, "total": total, "seconds_left": left })
}

fn style(template: &str) -> ProgressStyle {
    ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar())
}
