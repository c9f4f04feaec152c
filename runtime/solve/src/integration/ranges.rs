//! Over which times a dynamic analysis goes: ranges one after the other, each with its step and its part of the loads.

use calyx_model::position::Position;
use calyx_numerics::error::EngineError;

/// A range of equal steps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TimeRange {
    /// s
    pub duration: f64,
    /// How many steps it is gone through in.
    pub steps: usize,
    /// The part of all external loads at its beginning and at its end; between them it changes smoothly.
    pub load: [f64; 2],
    /// Every so many steps a row is kept; the last one of the range always is.
    pub keep: usize,
}

impl TimeRange {
    /// Under the full load, every step kept.
    pub const fn steady(duration: f64, steps: usize) -> TimeRange {
        TimeRange { duration, steps, load: [1.0; 2], keep: 1 }
    }

    /// The part of the loads after a part of the range has passed: a cubic with no slope at both ends.
    pub fn load_at(&self, passed: f64) -> f64 {
        let [from, to] = self.load;
        from + (to - from) * passed * passed * (3.0 - 2.0 * passed)
    }

    /// Whether it can be gone through.
    ///
    /// # Errors
    /// E0763: a number of it is out of its range.
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

/// A step to be taken.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    /// s, at its end.
    pub time: f64,
    /// Its length, s.
    pub length: f64,
    /// Of the external loads at its end.
    pub load: f64,
    /// Whether a row is kept of its end.
    pub kept: bool,
}

/// All steps from `start` (s) on, one after the other.
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

/// The same in steps that are two of these each, range by range; an odd one at the end of a range stays as it is.
pub fn in_pairs(all: &[Step], ranges: &[TimeRange]) -> Vec<Step> {
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

/// A step is at least so many times as long as times are apart that numbers can tell.
const RESOLVED: f64 = 1e3;

/// That the times of steps differ by enough of their digits. The steps of a range are equally long,
/// so the last one, or the one farthest from zero, decides.
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

/// Times of which rows are kept: the start, in equilibrium, and the ends of kept steps.
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
        let longer = in_pairs(&all, &ranges);
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
