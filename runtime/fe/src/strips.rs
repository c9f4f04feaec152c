//! Division of a plane section into four-sided cells: cuts across the section at positions along
//! it, straight lines between them, and steps where two cuts have the same position.
//!
//! The lines of one side of a step are continued on the other, so that the cells match everywhere.

/// Tolerance relative to the section: points nearer to a line of the mesh are on it.
const SAME: f64 = 1e-6;

/// Straight cut across a section.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Cut {
    /// Position along the section, m.
    pub at: f64,
    /// Coordinates across it of both ends of the cut, m.
    pub ends: [f64; 2],
}

/// Four-sided part of a section between two successive cuts and two lines.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Cell {
    /// Index of the first of the two cuts.
    pub cut: usize,
    /// Coordinates across the section of both lines on the first and on the second cut, m.
    pub lines: [[f64; 2]; 2],
}

/// Part of a section between steps, with its dividing lines.
struct Stretch<'a> {
    cuts: &'a [Cut],
    /// Positions from the start (0) to the end (1) of the cuts, ascending.
    lines: Vec<f64>,
}

impl Stretch<'_> {
    fn add(&mut self, cut: Cut, across: f64) {
        let [from, to] = cut.ends;
        let share = (across - from) / (to - from);
        let known = self.lines.iter().any(|line| (line - share).abs() < SAME);
        if share > 0.0 && share < 1.0 && !known {
            self.lines.push(share);
            self.lines.sort_by(f64::total_cmp);
        }
    }

    /// Returns the coordinates of its lines on a cut.
    fn places(&self, cut: Cut) -> Vec<f64> {
        self.lines.iter().map(|&line| between(cut.ends, line)).collect()
    }
}

fn between([from, to]: [f64; 2], share: f64) -> f64 {
    (1.0 - share) * from + share * to
}

/// Returns the stretches between steps, with the same divisions on both sides of each step.
fn stretches(cuts: &[Cut]) -> Vec<Stretch<'_>> {
    let mut stretches: Vec<Stretch<'_>> =
        cuts.chunk_by(|a, b| a.at != b.at).map(|cuts| Stretch { cuts, lines: vec![0.0, 1.0] }).collect();
    let steps: Vec<usize> = (1..stretches.len()).collect();
    // Forwards and back again: a line from a step is propagated to all stretches.
    for (step, forwards) in
        steps.iter().map(|&step| (step, true)).chain(steps.iter().rev().map(|&step| (step, false)))
    {
        let (before, after) = stretches.split_at_mut(step);
        let (Some(before), Some(after)) = (before.last_mut(), after.first_mut()) else { continue };
        let (Some(&end), Some(&start)) = (before.cuts.last(), after.cuts.first()) else { continue };
        let (from, from_cut, to, to_cut) =
            if forwards { (before, end, after, start) } else { (after, start, before, end) };
        for across in from.places(from_cut) {
            to.add(to_cut, across);
        }
    }
    stretches
}

/// Returns the cells between cuts in ascending order of their positions; steps are two cuts at one
/// position.
pub(crate) fn cells(cuts: &[Cut]) -> Vec<Cell> {
    let mut cells = Vec::new();
    let mut first = 0;
    for stretch in stretches(cuts) {
        for (index, pair) in stretch.cuts.windows(2).enumerate() {
            let lines = [pair[0], pair[1]].map(|cut| stretch.places(cut));
            for (start, end) in lines[0].windows(2).zip(lines[1].windows(2)) {
                cells.push(Cell { cut: first + index, lines: [[start[0], start[1]], [end[0], end[1]]] });
            }
        }
        first += stretch.cuts.len();
    }
    cells
}
