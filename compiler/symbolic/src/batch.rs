//! Splits a tape for evaluation at many points: a uniform part that runs once, and stages that run
//! for every point.
//!
//! Some inputs of a kernel *vary* from point to point; the others have one value for the whole
//! batch. Instructions that depend only on the latter are computed once. Sines and cosines of
//! varying angles are computed for whole tiles of points with wide SIMD instructions. The other
//! instructions are therefore split into stages: each stage computes the angles whose sines and
//! cosines the next stage needs. An instruction is assigned to the last stage that can compute it,
//! so that few values have to be stored between stages.

use crate::tape::{Instruction, Tape, ValueId};
use std::collections::HashMap;

/// The source of an instruction's value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Source {
    /// An output of the uniform tape: the same at all points.
    Uniform(u32),
    /// An input that varies from point to point.
    Column(u32),
    /// The sine of an angle, computed after a stage. `angle` is an index into [`BatchTape::angles`]
    /// of that stage.
    Sine { stage: u32, angle: u32 },
    /// The cosine of an angle, with the same indices as [`Source::Sine`].
    Cosine { stage: u32, angle: u32 },
    /// An instruction of this stage.
    Stage(u32),
}

/// A tape and the order in which it is evaluated at many points.
#[derive(Clone, Debug)]
pub struct BatchTape {
    pub tape: Tape,
    /// `true` for each input that varies.
    pub varying: Vec<bool>,
    /// The part that is computed once per batch. It has the same inputs as `tape`.
    pub uniform: Tape,
    /// The source of each instruction's value.
    pub sources: Vec<Source>,
    /// The instructions of each stage, in order.
    pub stages: Vec<Vec<ValueId>>,
    /// The angles whose sines and cosines are computed after each stage except the last.
    pub angles: Vec<Vec<ValueId>>,
}

impl BatchTape {
    /// Splits a well-formed tape ([`Tape::is_well_formed`]). Inputs beyond `varying` do not vary.
    pub fn new(tape: Tape, varying: &[bool]) -> Self {
        let varying: Vec<bool> =
            (0..tape.inputs).map(|input| varying.get(input).copied().unwrap_or(false)).collect();
        let count = tape.instructions.len();
        let mut varies = vec![false; count];
        // Number of sine and cosine steps that must precede each value.
        let mut earliest = vec![0_u32; count];
        for (index, &instruction) in tape.instructions.iter().enumerate() {
            varies[index] = match instruction {
                Instruction::Input(input) => varying[input as usize],
                other => tape.operands(other).any(|operand| varies[operand as usize]),
            };
            let after =
                tape.operands(instruction).map(|operand| earliest[operand as usize]).max().unwrap_or(0);
            earliest[index] = after + u32::from(varies[index] && takes_sine_or_cosine(instruction));
        }
        let last = earliest.iter().copied().max().unwrap_or(0);

        // Walks backwards and assigns the last stage that is early enough for all users.
        let mut stage = vec![last; count];
        for (index, &instruction) in tape.instructions.iter().enumerate().rev() {
            let needed = if varies[index] && takes_sine_or_cosine(instruction) {
                stage[index] = earliest[index];
                earliest[index] - 1
            } else {
                stage[index]
            };
            for operand in tape.operands(instruction) {
                let operand = operand as usize;
                stage[operand] = stage[operand].min(needed);
            }
        }

        let mut batch = BatchTape {
            varying,
            uniform: Tape { inputs: tape.inputs, tables: tape.tables.clone(), ..Tape::default() },
            sources: Vec::with_capacity(count),
            stages: vec![Vec::new(); last as usize + 1],
            angles: vec![Vec::new(); last as usize],
            tape,
        };
        batch.split(&varies, &stage);
        batch
    }

    fn split(&mut self, varies: &[bool], stage: &[u32]) {
        let count = self.tape.instructions.len();
        // Uniform values that a varying instruction or an output reads.
        let mut read = vec![false; count];
        for (index, &instruction) in self.tape.instructions.iter().enumerate() {
            if varies[index] {
                self.tape.operands(instruction).for_each(|operand| read[operand as usize] = true);
            }
        }
        self.tape.outputs.iter().for_each(|&output| read[output as usize] = true);

        let mut places = vec![0; count];
        // The indices of the solves on the uniform tape.
        let mut solves = HashMap::new();
        let mut angle_index = vec![None; count];
        for (index, &instruction) in self.tape.instructions.iter().enumerate() {
            if !varies[index] {
                places[index] = self.uniform.instructions.len() as ValueId;
                let instruction = match instruction {
                    Instruction::Solution(solve, unknown) => {
                        let next = self.uniform.solves.len() as u32;
                        let uniform = *solves.entry(solve).or_insert(next);
                        if uniform == next {
                            let solve = &self.tape.solves[solve as usize];
                            self.uniform.solves.push(solve.with_operands(|operand| places[operand as usize]));
                        }
                        Instruction::Solution(uniform, unknown)
                    }
                    other => other.with_operands(|operand| places[operand as usize]),
                };
                self.uniform.instructions.push(instruction);
                let slot = self.uniform.outputs.len() as u32;
                if read[index] {
                    self.uniform.outputs.push(places[index]);
                }
                self.sources.push(Source::Uniform(slot));
                continue;
            }
            let source = match instruction {
                Instruction::Input(input) => Source::Column(input),
                Instruction::Sin(of) | Instruction::Cos(of) => {
                    let before = stage[index] - 1;
                    let angles = &mut self.angles[before as usize];
                    let angle = *angle_index[of as usize].get_or_insert_with(|| {
                        angles.push(of);
                        angles.len() as u32 - 1
                    });
                    match instruction {
                        Instruction::Sin(_) => Source::Sine { stage: before, angle },
                        _ => Source::Cosine { stage: before, angle },
                    }
                }
                _ => {
                    self.stages[stage[index] as usize].push(index as ValueId);
                    Source::Stage(stage[index])
                }
            };
            self.sources.push(source);
        }
    }

    /// Returns the number of operations per point, without sines and cosines.
    pub fn varying_operations(&self) -> usize {
        self.stages.iter().map(Vec::len).sum()
    }
}

fn takes_sine_or_cosine(instruction: Instruction) -> bool {
    matches!(instruction, Instruction::Sin(_) | Instruction::Cos(_))
}
