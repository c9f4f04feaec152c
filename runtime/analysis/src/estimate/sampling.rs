//! Error estimates of the variation between positions: extremes and means.
//!
//! In every interval between two positions an output is continued from the left and from the right,
//! by parabolas through the positions on that side, in two ways ([`super::continuation`]). The
//! error of an extreme is the excess of the largest expected value in the intervals over the
//! largest value at the positions. It depends only on the interval and the positions next to it: an
//! extreme on a plateau has no error, however much the output varies elsewhere. Where loads of
//! rigid teeth jump, positions lie on both sides of the jump, and nothing is continued across it.
//! Elastic teeth do not jump there, so their time histories are continued through both positions.
//!
//! Continuations miss events that begin and end inside an interval. Therefore a few intervals are
//! divided ([`most_promising`]), alternately the one with the largest expected extreme and the one
//! whose continuations fit worst. The values at the new positions are known, and continuations
//! start from them.

use super::continuation::{Bend, Continuations, Point, Side, is_straight, second_difference, slope_change};
use super::{Ends, Statistics, ends};
use crate::results::DirectedErrors;
use crate::rows::StepRow;
use calyx_model::position::Position;
use std::borrow::Cow;
use std::collections::BTreeMap;

/// Distance of named positions, as a fraction of a cycle, below which they lie on both sides of a
/// jump of the loads of rigid teeth.
const BESIDE: f64 = 1e-5;
/// An output jumps there if its change exceeds this fraction of its peak-to-peak value; outputs of
/// elastic teeth do not.
const JUMP: f64 = 0.01;
/// Least distance of positions for a parabola, relative to the interval of the extrapolation:
/// smaller distances amplify small differences too much.
const APART: f64 = 0.3;
/// The same for a stencil whose ends are that far apart, and for the slope if there is no other
/// position.
const CLOSE: f64 = 0.1;
/// Intervals shorter than this fraction of the analysis's average are not divided.
const SHORTEST: f64 = 0.02;
/// Point of division of an interval with a named position at one end, as a fraction from that end.
/// No interval is divided closer to an end.
const BESIDE_NAMES: f64 = 0.25;
/// Larger miss distance of both continuations of an output, relative to peak-to-peak, above which
/// they meet at a kink: smooth histories are continued with smaller errors.
const KINKED: f64 = 0.3;
/// Fraction of an interval's miss distance that is added to its extreme while intervals are
/// selected, relative to peak-to-peak.
const HIDDEN: f64 = 0.25;
/// Estimated error of the mean over an interval, relative to the miss distances of the
/// continuations at its ends: the standard deviation of the mean of a history that jumps by that
/// distance at a uniformly distributed location, `1 / sqrt(12)`.
const MISSED_MEAN: f64 = 0.288_675;
/// Rises below this fraction of peak-to-peak divide no interval.
const RISING: f64 = 1e-3;
/// Outputs that vary by at most this fraction of their magnitude select no intervals.
const CHANGING: f64 = 1e-3;

/// Positions of a curve.
pub(crate) struct SamplingContext {
    /// Ascending positions: fractions of a mesh cycle, or time, s.
    at: Vec<f64>,
    /// Period of a closed curve: one cycle.
    period: f64,
    /// True if a position and the next one lie on both sides of a point.
    beside: Vec<bool>,
    /// True if there is no extrapolation from a position to the next, because the output jumps.
    breaks: Vec<bool>,
    /// True if a position has a name.
    named: Vec<bool>,
}

/// Evaluation of the largest value in an interval.
#[derive(Clone, Copy, Debug)]
struct Extrapolation {
    /// Root mean square of the rise above a level.
    rise: f64,
    /// Miss distance of the better extrapolation at the opposite end.
    missed: f64,
    /// Miss distance of the other one; 0 if there is only one.
    missed_more: f64,
    /// Expected location of a kink, as a fraction of the interval.
    kink: Option<f64>,
}

impl SamplingContext {
    /// Creates the curve, with the jumps of an output if given; `None` if the positions of the rows
    /// do not advance.
    pub(crate) fn of(rows: &[StepRow], output: Option<usize>) -> Option<SamplingContext> {
        let positions = || rows.iter().map(|row| &row.position);
        let cyclic = positions().any(|position| position.cycle != 0.0);
        let at: Vec<f64> = positions().map(|p| if cyclic { p.cycle } else { p.time }).collect();
        if at.len() < 2 || !at.windows(2).all(|pair| pair[1] > pair[0]) {
            return None;
        }
        let named: Vec<bool> = positions().map(|position| !position.name.is_empty()).collect();
        let mut course = SamplingContext { at, period: 1.0, beside: Vec::new(), breaks: Vec::new(), named };
        let is_beside = |i: usize| {
            let both = course.named[i] && course.named[(i + 1) % rows.len()];
            cyclic && both && course.place(i as isize + 1) - course.at[i] < BESIDE
        };
        course.beside = (0..rows.len()).map(is_beside).collect();
        let values: Vec<f64> =
            output.map_or_else(Vec::new, |output| ends(rows, output).iter().map(|end| end.value).collect());
        let finite = || values.iter().copied().filter(|value| value.is_finite());
        let spread = finite().fold(f64::NEG_INFINITY, f64::max) - finite().fold(f64::INFINITY, f64::min);
        let jumps = |i: usize| {
            let ends = values.get(i).zip(values.get((i + 1) % rows.len()));
            ends.is_some_and(|(one, next)| (next - one).abs() > JUMP * spread)
        };
        course.breaks = (0..rows.len()).map(|i| course.beside[i] && jumps(i)).collect();
        Some(course)
    }

    /// Returns the position of an index that continues around the cycle.
    fn place(&self, index: isize) -> f64 {
        let count = self.at.len() as isize;
        self.at[index.rem_euclid(count) as usize] + self.period * index.div_euclid(count) as f64
    }

    /// Returns up to three positions from one on, away from the interval behind it (`step` is their
    /// direction), that are at least this far apart.
    fn stencil(&self, from: isize, step: isize, apart: f64, closed: bool) -> Vec<isize> {
        let count = self.at.len() as isize;
        let mut stencil = vec![from];
        let mut last = from;
        for _ in 1..count {
            let next = last + step;
            let between = if step > 0 { last } else { next };
            let is_end = !closed && !(0..count).contains(&next);
            if is_end || self.breaks[between.rem_euclid(count) as usize] || stencil.len() == 3 {
                break;
            }
            last = next;
            let nearest = stencil.last().map_or(from, |&nearest| nearest);
            if (self.place(next) - self.place(nearest)).abs() >= apart {
                stencil.push(next);
            }
        }
        stencil
    }

    /// Returns the average length of an interval.
    pub(crate) fn average(&self) -> f64 {
        self.span(false) / (self.at.len() - 1) as f64
    }

    fn span(&self, closed: bool) -> f64 {
        if closed { self.period } else { self.at[self.at.len() - 1] - self.at[0] }
    }

    /// Returns the intervals between neighbours that are evaluated, by their first position.
    fn intervals(&self, closed: bool) -> impl Iterator<Item = isize> + '_ {
        let count = self.at.len() as isize;
        (0..if closed { count } else { count - 1 }).filter(|&interval| !self.beside[interval as usize])
    }

    /// Returns both sides of an interval, and which of them is sufficient on its own.
    fn sides(&self, interval: isize, of: impl Fn(isize) -> f64, closed: bool) -> ([Side; 2], [bool; 2]) {
        let [start, end] = [interval, interval + 1].map(|end| self.place(end));
        let length = end - start;
        let own = |part: f64| {
            [(interval, -1), (interval + 1, 1)]
                .map(|(from, step)| self.stencil(from, step, part * length, closed))
        };
        let [mut apart, close] = [APART, CLOSE].map(own);
        for (apart, close) in apart.iter_mut().zip(&close).filter(|(apart, _)| apart.len() == 1) {
            apart.extend(close.get(1));
        }
        let alone = [0, 1].map(|side: usize| apart[side].len() > 1);
        let point = |&index: &isize| (self.place(index), of(index));
        let spans = |stencil: &[Point; 3]| (stencil[2].0 - stencil[0].0).abs() >= APART * length;
        let behind = [0, 1].map(|side: usize| {
            let stencils = [&apart[side], &close[side]].into_iter();
            let own = stencils.filter_map(|stencil| match stencil[..] {
                [one, two, three] => Some([one, two, three].map(|index| point(&index))),
                _ => None,
            });
            own.collect::<Vec<_>>()
        });
        let across = [0, 1].map(|side: usize| match apart[side][..] {
            [one, two, ..] => Some([interval + 1 - side as isize, one, two].map(|index| point(&index))),
            _ => None,
        });
        let is_smoother_across = |side: usize| {
            let changes = behind[side].iter().map(slope_change).reduce(f64::min);
            across[side].zip(changes).is_some_and(|(across, least)| slope_change(&across) < least)
        };
        // The history is smooth in the interval if it bends in the same direction at both ends, and
        // its slope changes less there than behind them.
        let bends_alike = across[0]
            .zip(across[1])
            .is_some_and(|(left, right)| second_difference(&left) * second_difference(&right) > 0.0);
        let is_smooth = bends_alike && [0, 1].into_iter().all(is_smoother_across);
        let side = |side: usize| {
            // In a smooth interval and on a plateau the positions on both sides of the interval
            // define a stencil of this side.
            let across = across[side].filter(|across| is_smooth || is_straight(across));
            let stencils = behind[side].iter().copied().chain(across);
            // A single position next to a jump or an end defines no extrapolation; the other side
            // provides it.
            let other = if alone[side] { &[] } else { &apart[1 - side][..] };
            let points = apart[side].iter().chain(other.iter().take(2)).map(point).collect();
            Side { points, stencils: stencils.filter(spans).collect() }
        };
        ([side(0), side(1)], alone)
    }

    /// Returns the continuations into an interval from both sides, for each kind of bend, and which
    /// side has two positions of its own.
    fn continued(
        &self,
        interval: isize,
        of: impl Fn(isize) -> f64,
        closed: bool,
    ) -> ([Continuations; 2], [bool; 2]) {
        let (sides, alone) = self.sides(interval, of, closed);
        let ends = [interval, interval + 1].map(|end| self.place(end));
        (Bend::ALL.map(|bend| Continuations::new(&sides, ends, bend)), alone)
    }

    /// Evaluates the largest value in an interval relative to a level, by the continuations that
    /// accelerate: an interval is divided if it may hide something.
    fn look(&self, interval: isize, of: impl Fn(isize) -> f64, closed: bool, level: f64) -> Extrapolation {
        let ([_, continued], alone) = self.continued(interval, of, closed);
        let missed = missed(&continued, alone);
        let both = alone.iter().all(|&alone| alone);
        let more = continued.misses().into_iter().map(f64::abs).fold(0.0, f64::max);
        Extrapolation {
            rise: continued.largest(level).rise,
            missed,
            missed_more: if both { more } else { 0.0 },
            kink: continued.kink(),
        }
    }

    /// Returns the excess of the estimated maximum between positions over the largest value at the
    /// positions.
    fn above(&self, values: &[f64], closed: bool) -> f64 {
        let count = values.len() as isize;
        let of = |index: isize| values[index.rem_euclid(count) as usize];
        let most = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let largest = |interval| {
            let (continued, _) = self.continued(interval, of, closed);
            average(continued.map(|continued| continued.largest(most).expected.max(most)))
        };
        self.intervals(closed).map(largest).fold(most, f64::max)
    }

    /// Returns the area below the chords between positions.
    pub(super) fn chords(&self, values: &[f64], closed: bool) -> f64 {
        let count = values.len() as isize;
        let of = |index: isize| values[index.rem_euclid(count) as usize];
        let all = 0..if closed { count } else { count - 1 };
        all.map(|i| 0.5 * (of(i) + of(i + 1)) * (self.place(i + 1) - self.place(i))).sum()
    }

    /// Returns the area between chords and continuations.
    pub(super) fn area(&self, values: &[f64], closed: bool) -> f64 {
        let count = values.len() as isize;
        let of = |index: isize| values[index.rem_euclid(count) as usize];
        let above_chord = |interval| {
            let (continued, _) = self.continued(interval, of, closed);
            let above_chord = average(continued.map(|continued| continued.above_chord()));
            above_chord * (self.place(interval + 1) - self.place(interval))
        };
        self.intervals(closed).map(above_chord).sum()
    }

    /// Returns the area that extrapolations may miss; its sign varies between intervals.
    fn missed_area(&self, values: &[f64], closed: bool) -> f64 {
        let count = values.len() as isize;
        let of = |index: isize| values[index.rem_euclid(count) as usize];
        let most = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let least = values.iter().copied().fold(f64::INFINITY, f64::min);
        let square = |interval: isize| {
            let (continued, alone) = self.continued(interval, of, closed);
            let length = self.place(interval + 1) - self.place(interval);
            average(continued.map(|own| (missed(&own, alone).min(most - least) * length).powi(2)))
        };
        self.intervals(closed).map(square).sum::<f64>().sqrt()
    }

    /// Estimates the errors of the statistics due to the variation between positions. `known` is
    /// the curve of the positions and of others between them, with its values.
    pub(crate) fn errors(
        &self,
        ends: &[Ends],
        known: (&SamplingContext, &[Ends]),
        closed: bool,
    ) -> DirectedErrors {
        let beyond = |of: &dyn Fn(&Ends) -> f64| {
            let most = ends.iter().map(of).fold(f64::NEG_INFINITY, f64::max);
            known.0.above(&known.1.iter().map(of).collect::<Vec<_>>(), closed) - most
        };
        let [above, below] = [beyond(&|end| end.high), beyond(&|end| -end.low)];
        let [own, more] = [ends, known.1].map(|ends| ends.iter().map(|end| end.value).collect::<Vec<_>>());
        let course = known.0;
        let beside = course.chords(&more, closed) + course.area(&more, closed) - self.chords(&own, closed);
        let missed = MISSED_MEAN * course.missed_area(&more, closed);
        let [mean, beside] = [beside.hypot(missed), beside].map(|area| area / self.span(closed));
        let peak_to_peak = above + below;
        // Positions miss extremes; they never exceed them.
        let directed = Statistics { min: below, max: -above, mean: -beside, peak_to_peak: -peak_to_peak };
        DirectedErrors::new(Statistics { min: below, max: above, mean, peak_to_peak }, directed)
    }
}

fn average([one, other]: [f64; 2]) -> f64 {
    0.5 * (one + other)
}

/// Returns the smaller miss distance of the continuations that have two positions of their own, at
/// the position at their other end.
fn missed(continued: &Continuations, alone: [bool; 2]) -> f64 {
    let missed = continued.misses().into_iter().zip(alone).filter(|(_, alone)| *alone);
    let missed = missed.map(|(missed, _)| missed.abs()).fold(f64::INFINITY, f64::min);
    if missed.is_finite() { missed } else { 0.0 }
}

/// Output with its known values.
pub(crate) struct SampledOutput<'a> {
    pub course: &'a SamplingContext,
    pub ends: Vec<Ends>,
    pub closed: bool,
    /// Smallest and largest possible value.
    pub bounds: [f64; 2],
}

/// Interval that is worth dividing.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Promising {
    /// Position at its start.
    pub interval: usize,
    /// Expected location of a kink, as a fraction of the interval.
    pub kink: Option<f64>,
    /// The same of the output with the most distinct kink in the interval.
    pub event: Option<f64>,
}

/// Sorts the intervals by the merit of dividing them for the extremes of all outputs, in descending
/// order. Omits those shorter than a small fraction of `average`, the average interval of the
/// analysis.
///
/// Two orders alternate, the first one if `turn` is even. The first is by the expected rise above
/// the extreme, relative to peak-to-peak. The second adds the misfit of continuations in any
/// output: an event that shows in one output, such as a tooth pair that takes up load, affects
/// others. For the same reason each interval has the kink of the output that shows it best. A load
/// share, for example, is straight up to the point where a tooth pair leaves contact, which other
/// outputs with curved time histories do not show.
pub(crate) fn most_promising(all: &[SampledOutput<'_>], average: f64, turn: usize) -> Vec<Promising> {
    // Interval, rise relative to peak-to-peak, and evaluation, for every output and either sign.
    let mut looks: Vec<(usize, f64, Extrapolation)> = Vec::new();
    let mut hidden: BTreeMap<usize, f64> = BTreeMap::new();
    // Larger miss distance relative to peak-to-peak, and location, of the most distinct kink.
    let mut events: BTreeMap<usize, (f64, f64)> = BTreeMap::new();
    for SampledOutput { course, ends, closed, bounds: [lowest, highest] } in all {
        if !ends.iter().all(|end| (end.low + end.high).is_finite()) {
            continue;
        }
        let high: Vec<f64> = ends.iter().map(|end| end.high).collect();
        let low: Vec<f64> = ends.iter().map(|end| -end.low).collect();
        let [most, least] =
            [&high, &low].map(|values| values.iter().copied().fold(f64::NEG_INFINITY, f64::max));
        let (spread, magnitude) = (most + least, most.abs().max(least.abs()));
        if spread <= CHANGING * magnitude {
            continue;
        }
        for (values, most, bound) in [(&high, most, *highest), (&low, least, -lowest)] {
            let of = |index: isize| values[index.rem_euclid(values.len() as isize) as usize];
            let long = |&i: &isize| course.place(i + 1) - course.place(i) > SHORTEST * average;
            for interval in course.intervals(*closed).filter(long) {
                let look = course.look(interval, of, *closed, most);
                let interval = interval as usize;
                let rise = if most < bound { look.rise } else { 0.0 };
                looks.push((interval, rise / spread, look));
                let part = (look.missed / spread).min(1.0);
                hidden.entry(interval).and_modify(|most| *most = most.max(part)).or_insert(part);
                let distinct = look.missed_more / spread;
                if let Some(kink) = look.kink.filter(|_| distinct > KINKED) {
                    let event = events.entry(interval).or_insert((distinct, kink));
                    if distinct > event.0 {
                        *event = (distinct, kink);
                    }
                }
            }
        }
    }
    let in_order = |promise: &dyn Fn(usize, f64) -> f64, least: f64| {
        let mut best: BTreeMap<usize, (f64, Option<f64>)> = BTreeMap::new();
        for &(interval, rise, look) in &looks {
            let own = (promise(interval, rise), look.kink);
            let best = best.entry(interval).or_insert(own);
            if own.0 > best.0 {
                *best = own;
            }
        }
        let mut in_order: Vec<(usize, (f64, Option<f64>))> =
            best.into_iter().filter(|(_, (promise, _))| *promise > least).collect();
        in_order.sort_by(|a, b| b.1.0.total_cmp(&a.1.0));
        let event = |interval: &usize| events.get(interval).map(|(_, event)| *event);
        let all = in_order.into_iter();
        all.map(|(interval, (_, kink))| Promising { interval, kink, event: event(&interval) })
            .collect::<Vec<_>>()
            .into_iter()
    };
    let mut orders = [
        in_order(&|_, rise| rise, RISING),
        in_order(&|interval, rise| rise + HIDDEN * hidden[&interval], f64::NEG_INFINITY),
    ];
    let mut promising: Vec<Promising> = Vec::new();
    let mut turn = turn;
    loop {
        let own = turn % 2;
        let is_new = |next: &Promising| promising.iter().all(|old| old.interval != next.interval);
        let next = orders[own].find(is_new);
        let Some(next) = next.or_else(|| orders[1 - own].find(is_new)) else { return promising };
        promising.push(next);
        turn += 1;
    }
}

/// Returns the position that divides an interval after a row; the last interval extends over the
/// end of the cycle. The position is at the expected kink of the output or of another one, close to
/// a named row, or in the middle.
pub(crate) fn divided(rows: &[StepRow], Promising { interval, kink, event }: Promising) -> Position {
    let (first, last) = (&rows[0].position, &rows[rows.len() - 1].position);
    let one = &rows[interval].position;
    let named = [one, &rows[(interval + 1) % rows.len()].position].map(|at| !at.name.is_empty());
    let part = match (kink.or(event), named) {
        (Some(kink), _) => kink.clamp(BESIDE_NAMES, 1.0 - BESIDE_NAMES),
        (None, [true, false]) => BESIDE_NAMES,
        (None, [false, true]) => 1.0 - BESIDE_NAMES,
        _ => 0.5,
    };
    // Increment to the next row, or to the first one of the next cycle.
    let later = |of: fn(&Position) -> f64| match rows.get(interval + 1) {
        Some(next) => of(&next.position) - of(one),
        None => (of(last) - of(first)) / (last.cycle - first.cycle) * (first.cycle + 1.0 - last.cycle),
    };
    let between = |of: fn(&Position) -> f64| of(one) + part * later(of);
    Position {
        time: between(|at| at.time),
        cycle: between(|at| at.cycle),
        roll: between(|at| at.roll),
        name: Cow::Borrowed(""),
    }
}
