//! Time ranges of a transient analysis: one after the other, each with its step and load factor.

use calyx_model::position::Position;
use calyx_numerics::error::EngineError;

/// Time range with equal steps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TimeRange {
    /// Duration, s.
    pub duration: f64,
    /// Number of steps.
    pub steps: usize,
    /// Load factor at its start and at its end, applied to all external loads; it varies smoothly
    /// in between.
    pub load: [f64; 2],
    /// Interval of recorded rows in steps; the last step of the range is always recorded.
    pub keep: usize,
}

impl TimeRange {
    /// Creates a range under full load with all steps recorded.
    pub const fn steady(duration: f64, steps: usize) -> TimeRange {
        TimeRange { duration, steps, load: [1.0; 2], keep: 1 }
    }

    /// Returns the load factor after a fraction of the range: a cubic with zero slope at both ends.
    pub fn load_at(&self, passed: f64) -> f64 {
        let [from, to] = self.load;
        from + (to - from) * passed * passed * (3.0 - 2.0 * passed)
    }

    /// Checks the range.
    ///
    /// # Errors
    /// E0763: a number is out of its range.
    pub fn check(&self) -> Result<(), EngineError> {
        let sound = self.duration.is_finite() && self.duration > 0.0 && self.steps > 0 && self.keep > 0;
        match sound && self.load.iter().all(|part| part.is_finite()) {
            true => Ok(()),
            false => Err(EngineError::new(
                "E0763",
                "a range of time needs a positive duration, at least one step, and finite parts of the load",
                "give it like `gears.time_range(duration = 10 ms, step = 5 us)`",
            )),
        }
    }
}

/// Time step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    /// Time at its end, s.
    pub time: f64,
    /// Length, s.
    pub length: f64,
    /// Load factor at its end.
    pub load: f64,
    /// True if a row is recorded at its end.
    pub kept: bool,
}

/// Returns all steps from `start` (s).
pub fn steps(start: f64, ranges: &[TimeRange]) -> impl Iterator<Item = Step> + '_ {
    let begin = move |range: usize| start + ranges[..range].iter().map(|range| range.duration).sum::<f64>();
    ranges.iter().enumerate().flat_map(move |(index, range)| {
        let from = begin(index);
        (1..=range.steps).map(move |step| {
            let passed = step as f64 / range.steps as f64;
            Step {
                time: from + passed * range.duration,
                length: range.duration / range.steps as f64,
                load: range.load_at(passed),
                kept: step % range.keep == 0 || step == range.steps,
            }
        })
    })
}

/// Merges pairs of steps, range by range; an odd one at the end of a range is kept.
pub fn doubled_steps(all: &[Step], ranges: &[TimeRange]) -> Vec<Step> {
    let mut rest = all;
    let mut longer = Vec::with_capacity(all.len().div_ceil(2));
    for range in ranges {
        let (own, behind) = rest.split_at(range.steps.min(rest.len()));
        longer.extend(own.chunks(2).map(|pair| {
            let last = pair[pair.len() - 1];
            Step { length: pair.iter().map(|step| step.length).sum(), ..last }
        }));
        rest = behind;
    }
    longer
}

/// Smallest length of a step relative to the resolution of floating-point times.
const RESOLVED: f64 = 1e3;

/// Checks that the times of steps differ by enough digits. The steps of a range are equally long,
/// so the last one, or the one farthest from zero, is decisive.
///
/// # Errors
/// E0763: a step is lost in the digits of its time.
pub fn check_resolved(from: f64, ranges: &[TimeRange]) -> Result<(), EngineError> {
    let mut end = from;
    for range in ranges {
        end += range.duration;
        let (length, farthest) = (range.duration / range.steps as f64, end.abs().max(from.abs()));
        if length < RESOLVED * f64::EPSILON * farthest {
            return Err(EngineError::new(
                "E0763",
                format!("a step of {length:e} s is lost in the digits of its time, {end} s"),
                "begin nearer to 0 s, or take longer steps",
            )
            .blame("over"));
        }
    }
    Ok(())
}

/// Returns the times of recorded rows: the start, in equilibrium, and the ends of recorded steps.
pub fn kept_positions(start: f64, ranges: &[TimeRange]) -> Vec<Position> {
    let kept = steps(start, ranges).filter(|step| step.kept).map(|step| Position::at(step.time));
    std::iter::once(Position::at(start)).chain(kept).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_follow_each_other() {
        let ramp = TimeRange { duration: 1.0, steps: 4, load: [0.0, 2.0], keep: 3 };
        let ranges = [ramp, TimeRange::steady(0.5, 2)];
        let all: Vec<Step> = steps(10.0, &ranges).collect();
        assert_eq!(
            all.iter().map(|step| step.time).collect::<Vec<_>>(),
            [10.25, 10.5, 10.75, 11.0, 11.25, 11.5]
        );
        assert_eq!(
            all.iter().map(|step| step.kept).collect::<Vec<_>>(),
            [false, false, true, true, true, true]
        );
        assert_eq!(all[1].load, 1.0);
        assert_eq!((all[3].load, all[4].load, all[4].length), (2.0, 1.0, 0.25));
        let kept: Vec<f64> = kept_positions(10.0, &ranges).iter().map(|position| position.time).collect();
        assert_eq!(kept, [10.0, 10.75, 11.0, 11.25, 11.5]);
    }

    #[test]
    fn steps_go_in_pairs_within_their_range() {
        let ramp = TimeRange { duration: 1.0, steps: 5, load: [0.0, 2.0], keep: 1 };
        let ranges = [ramp, TimeRange::steady(0.5, 2)];
        let all: Vec<Step> = steps(0.0, &ranges).collect();
        let longer = doubled_steps(&all, &ranges);
        assert_eq!(longer.iter().map(|step| step.time).collect::<Vec<_>>(), [0.4, 0.8, 1.0, 1.5]);
        let lengths = [0.4, 0.4, 0.2, 0.5];
        assert!(longer.iter().zip(lengths).all(|(step, length)| (step.length - length).abs() < 1e-15));
        assert_eq!(longer[1].load, all[3].load);
        assert!(longer.iter().all(|step| step.kept));
    }

    #[test]
    fn what_is_no_range_is_refused() {
        assert_eq!(TimeRange::steady(0.0, 3).check().expect_err("refused").code, "E0763");
        assert_eq!(TimeRange::steady(1.0, 0).check().expect_err("refused").code, "E0763");
        assert!(TimeRange::steady(1.0, 1).check().is_ok());
    }
}
