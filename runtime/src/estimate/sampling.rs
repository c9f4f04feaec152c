//! What lies between positions.
//!
//! In every interval between two positions an output is continued from the left and from the right, by parabolas through the positions on
//! either side alone: so neither a smooth maximum between positions is missed, nor one where slopes jump, as where a pair of teeth takes up
//! load. Where loads of rigid teeth jump, positions stand on both sides, and nothing is continued across.

use super::{Ends, Statistics};
use crate::results::StepRow;

/// Named positions nearer to each other than this part of a cycle stand on both sides of a jump.
const BESIDE: f64 = 1e-5;
/// Positions nearer to each other than this part of an average step do not make a parabola.
const APART: f64 = 0.25;
/// A jump anywhere in an interval is off the chord by this part of itself, on average.
const JUMP: f64 = 0.25;
/// Places inside an interval that are looked at.
const PLACES: usize = 16;

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

    /// Positions from one on, away from the interval behind it (`step` is their direction), that make a parabola.
    fn stencil(&self, from: isize, step: isize, closed: bool) -> Vec<isize> {
        let count = self.at.len() as isize;
        let span = if closed { self.period } else { self.at[self.at.len() - 1] - self.at[0] };
        let apart = APART * span / count as f64;
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

    /// How far what lies between positions is from what they say themselves.
    pub(crate) fn errors(&self, ends: &[Ends], closed: bool) -> Statistics {
        let count = self.at.len() as isize;
        let intervals = if closed { count } else { count - 1 };
        let span = if closed { self.period } else { self.at[self.at.len() - 1] - self.at[0] };
        let value = |of: fn(&Ends) -> f64, index: isize| of(&ends[index.rem_euclid(count) as usize]);
        let most = ends.iter().map(|end| end.high).fold(f64::NEG_INFINITY, f64::max);
        let least = ends.iter().map(|end| end.low).fold(f64::INFINITY, f64::min);
        let (mut above, mut below, mut area, mut doubt) = (0.0_f64, 0.0_f64, 0.0, 0.0);
        for interval in (0..intervals).filter(|&interval| !self.breaks[interval as usize]) {
            let mut stencils = [self.stencil(interval, -1, closed), self.stencil(interval + 1, 1, closed)];
            // A single position beside a jump or an end continues nothing.
            for side in 0..2 {
                if stencils[side].len() < 2 {
                    stencils[side] = stencils[1 - side].clone();
                }
            }
            let [from, to] = [self.place(interval), self.place(interval + 1)];
            let continued = |of: fn(&Ends) -> f64, x: f64| {
                [0, 1].map(|side: usize| {
                    let points = stencils[side].iter().map(|&i| (self.place(i), value(of, i)));
                    lagrange(&points.collect::<Vec<_>>(), x)
                })
            };
            let [start, end] = [interval, interval + 1].map(|i| value(|end| end.value, i));
            for place in 1..=PLACES {
                let part = (place as f64 - 0.5) / PLACES as f64;
                let x = from + part * (to - from);
                let [left, right] = continued(|end| end.high, x);
                above = above.max(left.min(right) - most);
                let [left, right] = continued(|end| end.low, x);
                below = below.max(least - left.max(right));
                let [left, right] = continued(|end| end.value, x);
                let chord = start + part * (end - start);
                let share = (to - from) / PLACES as f64;
                // Where slopes jump the course is the lower of both continuations or the upper one, whichever is nearer to the chord.
                area += common_to(left - chord, right - chord) * share;
                if (left - chord) * (right - chord) < 0.0 {
                    doubt += JUMP * (left - right).abs().min((end - start).abs()) * share;
                }
            }
        }
        let mean = (area.abs() + doubt) / span;
        Statistics { min: below, max: above, mean, peak_to_peak: above + below }
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
