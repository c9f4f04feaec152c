//! A tape split for many points at once: what is the same at all of them, and what follows in which stage.
//!
//! Of a kernel's inputs some *vary* from point to point, the others are one number for the whole batch. Whatever depends
//! on the latter alone is computed once. Sines and cosines of varying angles are taken of whole tiles of points, by
//! instructions wider than the code around them can use; so the rest falls into stages, each computing the angles
//! of which sine and cosine are taken before the next one runs. A value is computed in the last stage that can: then
//! few values wait in memory for later ones.

use crate::tape::{Instruction, Tape, ValueId};

/// Where the value of an instruction comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Source {
    /// The same at all points: an output of the uniform tape.
    Uniform(u32),
    /// An input that varies.
    Column(u32),
    /// The sine of an angle, taken after a stage. `angle` counts in [`BatchTape::angles`] of that stage.
    Sine { stage: u32, angle: u32 },
    /// The cosine, likewise.
    Cosine { stage: u32, angle: u32 },
    /// Computed in a stage.
    Stage(u32),
}

/// A tape and the order of its evaluation at many points.
#[derive(Clone, Debug)]
pub struct BatchTape {
    pub tape: Tape,
    /// For each input, whether it varies.
    pub varying: Vec<bool>,
    /// What is computed once; its inputs are those of the tape.
    pub uniform: Tape,
    /// For each instruction.
    pub sources: Vec<Source>,
    /// What each stage computes, in order.
    pub stages: Vec<Vec<ValueId>>,
    /// After each stage but the last, the angles of which sine and cosine are taken.
    pub angles: Vec<Vec<ValueId>>,
}

impl BatchTape {
    /// Splits a well-formed tape ([`Tape::is_well_formed`]). Inputs beyond `varying` do not vary.
    pub fn new(tape: Tape, varying: &[bool]) -> Self {
        let varying: Vec<bool> =
            (0..tape.inputs).map(|input| varying.get(input).copied().unwrap_or(false)).collect();
        let count = tape.instructions.len();
        let mut varies = vec![false; count];
        // The number of times sines and cosines must have been taken before a value can be computed.
        let mut earliest = vec![0_u32; count];
        for (index, &instruction) in tape.instructions.iter().enumerate() {
            varies[index] = match instruction {
                Instruction::Input(input) => varying[input as usize],
                other => other.operands().any(|operand| varies[operand as usize]),
            };
            let after = instruction.operands().map(|operand| earliest[operand as usize]).max().unwrap_or(0);
            earliest[index] = after + u32::from(varies[index] && takes_sine_or_cosine(instruction));
        }
        let last = earliest.iter().copied().max().unwrap_or(0);

        // Backwards: the last stage that is early enough for everybody.
        let mut stage = vec![last; count];
        for (index, &instruction) in tape.instructions.iter().enumerate().rev() {
            let needed = if varies[index] && takes_sine_or_cosine(instruction) {
                stage[index] = earliest[index];
                earliest[index] - 1
            } else {
                stage[index]
            };
            for operand in instruction.operands() {
                let operand = operand as usize;
                stage[operand] = stage[operand].min(needed);
            }
        }

        let mut batch = BatchTape {
            varying,
            uniform: Tape { inputs: tape.inputs, ..Tape::default() },
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
        // Uniform values that something varying, or an output, reads.
        let mut read = vec![false; count];
        for (index, instruction) in self.tape.instructions.iter().enumerate() {
            if varies[index] {
                instruction.operands().for_each(|operand| read[operand as usize] = true);
            }
        }
        self.tape.outputs.iter().for_each(|&output| read[output as usize] = true);

        let mut places = vec![0; count];
        let mut angle_index = vec![None; count];
        for (index, &instruction) in self.tape.instructions.iter().enumerate() {
            if !varies[index] {
                places[index] = self.uniform.instructions.len() as ValueId;
                self.uniform.instructions.push(instruction.with_operands(|operand| places[operand as usize]));
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

    /// Operations per point, sines and cosines not counted.
    pub fn varying_operations(&self) -> usize {
        self.stages.iter().map(Vec::len).sum()
    }
}

fn takes_sine_or_cosine(instruction: Instruction) -> bool {
    matches!(instruction, Instruction::Sin(_) | Instruction::Cos(_))
}
