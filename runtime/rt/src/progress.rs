//! Progress with the time that remains, on a terminal only.

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::time::Duration;

/// Shows the stage under way and, once positions are being solved, how many are left.
pub struct Progress {
    bar: ProgressBar,
}

impl Progress {
    /// Draws on standard error; draws nothing if `quiet` or if that is no terminal.
    pub fn new(quiet: bool) -> Progress {
        let target = if quiet { ProgressDrawTarget::hidden() } else { ProgressDrawTarget::stderr() };
        let bar = ProgressBar::with_draw_target(None, target);
        bar.set_style(style("{spinner} {msg}"));
        bar.enable_steady_tick(Duration::from_millis(100));
        Progress { bar }
    }

    pub fn stage(&self, name: &'static str) {
        self.bar.set_message(name);
    }

    pub fn step(&self, index: usize, count: usize) {
        if self.bar.length() != Some(count as u64) {
            self.bar.set_length(count as u64);
            self.bar.set_style(style("{spinner} {msg} [{bar:32}] {pos}/{len}, {eta} left"));
        }
        self.bar.set_position(index as u64 + 1);
    }

    pub fn finish(&self) {
        self.bar.finish_and_clear();
    }

    /// Prints what the program prints, on standard output, without disturbing the bar.
    pub fn print(&self, line: &str) {
        self.bar.suspend(|| println!("{line}"));
    }
}

fn style(template: &str) -> ProgressStyle {
    ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar())
}
