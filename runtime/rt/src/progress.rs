//! Progress with the time that remains: a bar on a terminal, or one JSON object a line for programs.

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
    /// When a stage begins, and after each position. What is not known is null.
    Json,
}

/// Shows the stage under way and, once positions are being solved, how many are left.
pub struct Progress {
    bar: ProgressBar,
    quiet: bool,
    /// Standard output is for something else than what the program prints.
    print_to_error: bool,
    /// The stage under way and when it began, for programs that watch.
    lines: Option<Mutex<(&'static str, Instant)>>,
}

impl Progress {
    /// Draws on standard error; draws no bar if `quiet` or if that is no terminal. What the program prints goes to standard
    /// output, or with `print_to_error` to standard error.
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

    /// Shows a setting that is tried for a tolerance, and the best one before it.
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

    pub fn finish(&self) {
        self.bar.finish_and_clear();
    }

    /// Prints what the program prints, without disturbing the bar.
    pub fn print(&self, line: &str) {
        self.bar.suspend(|| match self.print_to_error {
            true => eprintln!("{line}"),
            false => println!("{line}"),
        });
    }

    /// Says what people want to know, on standard error.
    pub fn note(&self, text: &str) {
        if !self.quiet {
            self.bar.suspend(|| eprintln!("{text}"));
        }
    }
}

/// Shows which of several runs is under way, and how long all that are left will take: as predicted, corrected by what those before took.
pub struct CampaignProgress {
    bar: ProgressBar,
    json: bool,
    /// Time of each, s.
    predicted: Vec<f64>,
    began: Instant,
    /// The run under way.
    index: Cell<usize>,
}

impl CampaignProgress {
    /// Draws on standard error as [`Progress`] does.
    pub fn new(format: ProgressFormat, quiet: bool, predicted: Vec<f64>) -> CampaignProgress {
        let json = format == ProgressFormat::Json;
        let target = if quiet || json { ProgressDrawTarget::hidden() } else { ProgressDrawTarget::stderr() };
        let bar = ProgressBar::with_draw_target(Some(predicted.len() as u64), target);
        bar.set_style(style("{spinner} [{bar:32}] {pos}/{len} {msg}"));
        bar.enable_steady_tick(Duration::from_millis(100));
        CampaignProgress { bar, json, predicted, began: Instant::now(), index: Cell::new(0) }
    }

    /// A run begins.
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

/// What is left of runs of these predicted times when the first `done` have taken `elapsed`, s.
fn seconds_left(predicted: &[f64], done: usize, elapsed: f64) -> f64 {
    let (before, after) = predicted.split_at(done.min(predicted.len()));
    let (before, after): (f64, f64) = (before.iter().sum(), after.iter().sum());
    // A prediction is told by more than its first moments.
    let scale = if before > 0.0 && elapsed > 0.5 { elapsed / before } else { 1.0 };
    after * scale
}

/// A line for programs; what is left takes as long as what was done.
fn line(stage: &str, done: usize, total: Option<usize>, elapsed: Option<Duration>) -> serde_json::Value {
    let left = elapsed.zip(total).filter(|_| done > 0);
    let left =
        left.map(|(elapsed, total)| elapsed.as_secs_f64() / done as f64 * total.saturating_sub(done) as f64);
    json!({ "stage": stage, "done": done, "total": total, "seconds_left": left })
}

fn style(template: &str) -> ProgressStyle {
    ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_left_follows_what_was_predicted_and_what_it_took() {
        assert_eq!(seconds_left(&[1.0, 2.0, 3.0], 0, 0.0), 6.0);
        assert_eq!(seconds_left(&[1.0, 2.0, 3.0], 2, 6.0), 6.0);
        assert_eq!(seconds_left(&[1.0, 2.0, 3.0], 3, 6.0), 0.0);
    }

    #[test]
    fn lines_say_what_is_left() {
        assert_eq!(
            line("structures", 0, None, None).to_string(),
            r#"{"stage":"structures","done":0,"total":null,"seconds_left":null}"#
        );
        assert_eq!(
            line("positions", 3, Some(9), Some(Duration::from_secs(6))).to_string(),
            r#"{"stage":"positions","done":3,"total":9,"seconds_left":12.0}"#
        );
    }
}
