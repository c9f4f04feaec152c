//! Vectorizes the sines and cosines of a kernel that is evaluated at one point: one call computes
//! up to eight angles at little more than the cost of one. The tape is reordered like a batch tape,
//! in which each stage ends with its angles.

use calyx_symbolic::batch::{BatchTape, Source};
use calyx_symbolic::{Instruction, Tape};
use std::borrow::Cow;
use std::ops::Range;

/// Smallest number of angles for which one vector call is faster than scalar calls.
const WORTH_IT: usize = 3;

/// Number of angles of the widest function; missing angles are filled with zeros.
pub const WIDTH: usize = 8;

/// Consecutive sines and cosines on a tape.
pub struct Run {
    /// Index of the first one.
    pub start: usize,
    /// Their distinct angles.
    pub angles: Vec<u32>,
}

/// Returns the tape with independent sines and cosines grouped, if there are enough of them.
pub fn gathered(tape: &Tape) -> Cow<'_, Tape> {
    // All inputs are treated as varying.
    let batch = BatchTape::new(tape.clone(), &vec![true; tape.inputs]);
    if batch.angles.iter().all(|angles| angles.len() < WORTH_IT) {
        return Cow::Borrowed(tape);
    }
    let is_first = |source: &Source| matches!(source, Source::Uniform(_) | Source::Column(_));
    let ids = || (0u32..).zip(&batch.sources);
    let mut order: Vec<u32> = ids().filter(|(_, source)| is_first(source)).map(|(id, _)| id).collect();
    // The sines and cosines that follow each stage, in order of the tape.
    let mut after: Vec<Vec<u32>> = vec![Vec::new(); batch.stages.len()];
    for (id, source) in ids() {
        if let Source::Sine { stage, .. } | Source::Cosine { stage, .. } = source {
            after[*stage as usize].push(id);
        }
    }
    for (operations, after) in batch.stages.iter().zip(&after) {
        order.extend(operations);
        order.extend(after);
    }
    let mut places = vec![0; tape.instructions.len()];
    (0..).zip(&order).for_each(|(place, &id)| places[id as usize] = place);
    let place = |id: u32| places[id as usize];
    Cow::Owned(Tape {
        inputs: tape.inputs,
        instructions: order.iter().map(|&id| tape.instructions[id as usize].with_operands(place)).collect(),
        outputs: tape.outputs.iter().map(|&id| place(id)).collect(),
        tables: tape.tables.clone(),
        solves: tape.solves.iter().map(|solve| solve.with_operands(place)).collect(),
    })
}

/// Returns the runs in a range of a tape that are worth a common call.
pub fn runs(tape: &Tape, range: &Range<usize>) -> Vec<Run> {
    let mut runs: Vec<Run> = Vec::new();
    let mut end = None;
    for index in range.clone() {
        let (Instruction::Sin(angle) | Instruction::Cos(angle)) = tape.instructions[index] else { continue };
        // A sine of another sine in the same run must start a new run.
        let run = runs.last_mut().filter(|run| end == Some(index) && (angle as usize) < run.start);
        match run {
            Some(run) if run.angles.last() == Some(&angle) || run.angles.contains(&angle) => {}
            Some(run) => run.angles.push(angle),
            None => runs.push(Run { start: index, angles: vec![angle] }),
        }
        end = Some(index + 1);
    }
    runs.retain(|run| run.angles.len() >= WORTH_IT);
    runs
}
