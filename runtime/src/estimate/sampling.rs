//! What lies between positions.
//!
//! In every interval between two positions an output is continued from the left and from the right, by parabolas through the positions on
//! either side alone: so neither a smooth maximum between positions is missed, nor one where slopes jump, as where a pair of teeth takes up
//! load. Where loads of rigid teeth jump, positions stand on both sides, and nothing is continued across.
//!
//! Continuations miss what begins and ends inside an interval. So the middles of a few intervals, beside the extremes and where continuations rise
//! above them, are solved as well ([`Course::promising`]): what they show is measured, and continuations begin from there.

use super::{Ends, Statistics};
use crate::analysis::Position;
use crate::results::StepRow;
use std::borrow::Cow;

/// Named positions nearer to each other than this part of a cycle stand on both sides of a jump.
const BESIDE: f64 = 1e-5;
/// Positions nearer to each other than this part of the interval that they are continued into do not make a parabola: what little they differ by would
/// be carried too far.
const APART: f64 = 0.6;
/// A jump anywhere in an interval is off the chord by this part of itself, on average.
const JUMP: f64 = 0.25;
/// Places inside an interval that are looked at.
const PLACES: usize = 16;

/// Intervals shorter than this part of an average one are not halved.
const SHORTEST: f64 = 0.2;

/// Where the positions are.
pub(crate) struct Course {
    /// Ascending: parts of a mesh cycle, or s.
    at: Vec<f64>,
    /// Of a closed course: a cycle.
    period: f64,
    /// Whether nothing is continued from a position to the next.
    breaks: Vec<bool>,
}

impl Course {
    /// `None` of rows that do not go anywhere.
    pub(crate) fn of(rows: &[StepRow]) -> Option<Course> {
        let positions = || rows.iter().map(|row| &row.position);
        let cyclic = positions().any(|position| position.cycle != 0.0);
        let at: Vec<f64> = positions().map(|p| if cyclic { p.cycle } else { p.time }).collect();
        if at.len() < 2 || !at.windows(2).all(|pair| pair[1] > pair[0]) {
            return None;
        }
        let named = |index: usize| !rows[index % rows.len()].position.name.is_empty();
        let mut course = Course { at, period: 1.0, breaks: Vec::new() };
        course.breaks = (0..rows.len())
            .map(|i| {
                cyclic && named(i) && named(i + 1) && course.place(i as isize + 1) - course.at[i] < BESIDE
            })
            .collect();
        Some(course)
    }

    /// Of a position counted on round the cycle.
    fn place(&self, index: isize) -> f64 {
        let count = self.at.len() as isize;
        self.at[index.rem_euclid(count) as usize] + self.period * index.div_euclid(count) as f64
    }

    /// Positions from one on, away from the interval behind it (`step` is their direction), that make a parabola over an interval so long.
    fn stencil(&self, from: isize, step: isize, length: f64, closed: bool) -> Vec<isize> {
        let count = self.at.len() as isize;
        let apart = APART * length;
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

    fn span(&self, closed: bool) -> f64 {
        if closed { self.period } else { self.at[self.at.len() - 1] - self.at[0] }
    }

    /// Intervals between neighbours of which something is to be known, by the position they begin with.
    fn intervals(&self, closed: bool) -> impl Iterator<Item = isize> + '_ {
        let count = self.at.len() as isize;
        (0..if closed { count } else { count - 1 }).filter(|&interval| !self.breaks[interval as usize])
    }

    /// What continues a course into an interval from the left and from the right.
    fn stencils(&self, interval: isize, closed: bool) -> [Vec<isize>; 2] {
        let length = self.place(interval + 1) - self.place(interval);
        let mut stencils =
            [self.stencil(interval, -1, length, closed), self.stencil(interval + 1, 1, length, closed)];
        // A single position beside a jump or an end continues nothing: it is met from the other side.
        for side in 0..2 {
            if stencils[side].len() < 2 {
                let others = stencils[1 - side].iter().take(2).copied().collect::<Vec<_>>();
                stencils[side].extend(others);
            }
        }
        stencils
    }

    /// Both continuations at a place inside an interval.
    fn continued(&self, stencils: &[Vec<isize>; 2], of: impl Fn(isize) -> f64, x: f64) -> [f64; 2] {
        [0, 1].map(|side: usize| {
            let points: Vec<_> = stencils[side].iter().map(|&i| (self.place(i), of(i))).collect();
            lagrange(&points, x)
        })
    }

    /// What the positions, and what lies between them, come to.
    fn seen(&self, ends: &[Ends], closed: bool) -> Seen {
        let count = self.at.len() as isize;
        let at = |index: isize| &ends[index.rem_euclid(count) as usize];
        let mut seen = Seen {
            most: ends.iter().map(|end| end.high).fold(f64::NEG_INFINITY, f64::max),
            least: ends.iter().map(|end| end.low).fold(f64::INFINITY, f64::min),
            ..Seen::default()
        };
        (seen.above, seen.below) = (seen.most, seen.least);
        let intervals = if closed { count } else { count - 1 };
        for interval in 0..intervals {
            let [from, to] = [self.place(interval), self.place(interval + 1)];
            let [start, end] = [interval, interval + 1].map(|i| at(i).value);
            seen.chords += 0.5 * (start + end) * (to - from);
            if self.breaks[interval as usize] {
                continue;
            }
            let stencils = self.stencils(interval, closed);
            for place in 1..=PLACES {
                let part = (place as f64 - 0.5) / PLACES as f64;
                let x = from + part * (to - from);
                let [left, right] = self.continued(&stencils, |i| at(i).high, x);
                seen.above = seen.above.max(left.min(right));
                let [left, right] = self.continued(&stencils, |i| at(i).low, x);
                seen.below = seen.below.min(left.max(right));
                let [left, right] = self.continued(&stencils, |i| at(i).value, x);
                let chord = start + part * (end - start);
                let share = (to - from) / PLACES as f64;
                // Where slopes jump the course is the lower of both continuations or the upper one, whichever is nearer to the chord.
                seen.area += common_to(left - chord, right - chord) * share;
                if (left - chord) * (right - chord) < 0.0 {
                    seen.doubt += JUMP * (left - right).abs().min((end - start).abs()) * share;
                }
            }
        }
        seen
    }

    /// How far what lies between positions is from what they say themselves. `known` is the course of the positions and of others between
    /// them, with its values.
    pub(crate) fn errors(&self, ends: &[Ends], known: (&Course, &[Ends]), closed: bool) -> Statistics {
        let own = self.seen(ends, closed);
        let seen = known.0.seen(known.1, closed);
        let [above, below] = [seen.above - own.most, own.least - seen.below];
        let mean = ((seen.chords + seen.area - own.chords).abs() + seen.doubt) / self.span(closed);
        Statistics { min: below, max: above, mean, peak_to_peak: above + below }
    }

    /// The intervals whose middles are most worth knowing for the largest value of an output and for its least: beside the extreme, or where
    /// continuations rise above it. That of the extreme of larger magnitude comes first.
    pub(crate) fn promising(&self, ends: &[Ends], closed: bool) -> Vec<usize> {
        if !ends.iter().all(|end| (end.low + end.high).is_finite()) {
            return Vec::new();
        }
        let highest = |of: &dyn Fn(&Ends) -> f64| {
            let extreme = (0..ends.len()).max_by(|&a, &b| of(&ends[a]).total_cmp(&of(&ends[b])))?;
            Some((of(&ends[extreme]), self.most_promising(extreme, |i| of(&ends[i]), closed)))
        };
        let mut both = [highest(&|end| end.high), highest(&|end| -end.low)];
        let magnitude = |one: &Option<(f64, _)>| one.as_ref().map_or(0.0, |(value, _)| value.abs());
        if magnitude(&both[1]) > magnitude(&both[0]) {
            both.reverse();
        }
        both.into_iter().flatten().filter_map(|(_, interval)| interval).collect()
    }

    /// The interval in which the largest value is continued highest, of those beside it and those where that is above it.
    fn most_promising(&self, extreme: usize, of: impl Fn(usize) -> f64, closed: bool) -> Option<usize> {
        let count = self.at.len() as isize;
        let of = |index: isize| of(index.rem_euclid(count) as usize);
        let (most, extreme) = (of(extreme as isize), extreme as isize);
        let shortest = SHORTEST * self.span(closed) / count as f64;
        let score = |interval: isize| {
            let stencils = self.stencils(interval, closed);
            let [from, to] = [self.place(interval), self.place(interval + 1)];
            let highest = (1..=PLACES).map(|place| {
                let x = from + (place as f64 - 0.5) / PLACES as f64 * (to - from);
                let [left, right] = self.continued(&stencils, of, x);
                left.min(right)
            });
            highest.fold(f64::NEG_INFINITY, f64::max)
        };
        let is_beside = |interval: isize| interval == extreme || (interval + 1).rem_euclid(count) == extreme;
        let long = self.intervals(closed).filter(|&i| self.place(i + 1) - self.place(i) > shortest);
        long.map(|interval| (interval, score(interval)))
            .filter(|&(interval, score)| is_beside(interval) || score > most)
            .max_by(|a, b| a.1.total_cmp(&b.1))
            .map(|(interval, _)| interval as usize)
    }
}

/// What positions come to, and what lies between them.
#[derive(Clone, Copy, Debug, Default)]
struct Seen {
    /// At the positions.
    most: f64,
    least: f64,
    /// There and between them.
    above: f64,
    below: f64,
    /// Below the chords from position to position.
    chords: f64,
    /// Between them and the continuations.
    area: f64,
    /// Of that.
    doubt: f64,
}

/// The position in the middle between a row and the next one, round the end of a cycle behind the last.
pub(crate) fn middle(rows: &[StepRow], interval: usize) -> Position {
    let (first, last) = (&rows[0].position, &rows[rows.len() - 1].position);
    let one = &rows[interval].position;
    // By what the next one is later: a row, or the first one of the next cycle.
    let later = |of: fn(&Position) -> f64| match rows.get(interval + 1) {
        Some(next) => of(&next.position) - of(one),
        None => (of(last) - of(first)) / (last.cycle - first.cycle) * (first.cycle + 1.0 - last.cycle),
    };
    let middle = |of: fn(&Position) -> f64| of(one) + 0.5 * later(of);
    Position {
        time: middle(|at| at.time),
        cycle: middle(|at| at.cycle),
        roll: middle(|at| at.roll),
        name: Cow::Borrowed(""),
    }
}

/// The smaller of two departures to one side; departures to either side say nothing.
fn common_to(one: f64, other: f64) -> f64 {
    if one * other > 0.0 { one.signum() * one.abs().min(other.abs()) } else { 0.0 }
}

/// The polynomial through a few points.
fn lagrange(points: &[(f64, f64)], x: f64) -> f64 {
    let term = |(index, &(own, value)): (usize, &(f64, f64))| {
        let others = points.iter().enumerate().filter(|(other, _)| *other != index);
        others.fold(value, |product, (_, (other, _))| product * (x - other) / (own - other))
    };
    points.iter().enumerate().map(term).sum()
}
