//! Interpretation of tapes.
//!
//! All values of an evaluation are in one workspace: those of the tape, then the solutions of its
//! systems, then the workspace of the system that is being solved. An evaluation therefore does not
//! allocate, except for a workspace that is larger than any before.

use crate::tape::{Instruction, Solve, Tape};
use calyx_abi::math::sincos;
use calyx_abi::newton::{MOST_UNKNOWNS, MOST_VALUES, newton};
use calyx_abi::piecewise::piecewise;

/// Numbers of a system's solution in a workspace: 1 if it is known, otherwise 0, and the unknowns.
const SOLUTION: usize = 1 + MOST_UNKNOWNS;

impl Tape {
    /// Interprets the tape. `scratch` is a buffer that saves an allocation per call; its contents
    /// do not matter.
    ///
    /// `inputs` holds [`Tape::inputs`] numbers; `outputs` receives one number per element of
    /// [`Tape::outputs`].
    pub fn eval(&self, inputs: &[f64], scratch: &mut Vec<f64>, outputs: &mut [f64]) {
        let size = self.workspace();
        if scratch.len() < size {
            scratch.resize(size, 0.0);
        }
        self.eval_in(scratch, inputs, outputs);
    }

    /// Returns the number of values of an evaluation.
    fn workspace(&self) -> usize {
        let solves = self.solves.iter();
        let below = solves.map(|solve| solve.operands.len() + solve.system.residual.workspace()).max();
        self.instructions.len() + SOLUTION * self.solves.len() + below.unwrap_or(0)
    }

    fn eval_in(&self, workspace: &mut [f64], inputs: &[f64], outputs: &mut [f64]) {
        let (values, rest) = workspace.split_at_mut(self.instructions.len());
        let (solutions, rest) = rest.split_at_mut(SOLUTION * self.solves.len());
        solutions.iter_mut().step_by(SOLUTION).for_each(|known| *known = 0.0);
        let mut index = 0;
        while let Some(&instruction) = self.instructions.get(index) {
            let (operands, results) = values.split_at_mut(index);
            results[0] = match instruction {
                // The cosine of an angle follows its sine, so one call computes both.
                Instruction::Sin(angle) => {
                    let (sine, cosine) = sincos(operands[angle as usize]);
                    if self.instructions.get(index + 1) == Some(&Instruction::Cos(angle)) {
                        results[1] = cosine;
                        index += 1;
                    }
                    sine
                }
                Instruction::Solution(solve, unknown) => {
                    let at = solve as usize;
                    let solution = &mut solutions[SOLUTION * at..SOLUTION * (at + 1)];
                    if solution[0] == 0.0 {
                        solution[0] = 1.0;
                        self.solves[at].evaluate(operands, rest, &mut solution[1..]);
                    }
                    solution[1 + unknown as usize]
                }
                Instruction::Piecewise(table, x) => {
                    piecewise(&self.tables[table as usize], operands[x as usize])
                }
                _ => instruction.evaluate(inputs, |id| operands[id as usize]),
            };
            index += 1;
        }
        for (output, &id) in outputs.iter_mut().zip(&self.outputs) {
            *output = values[id as usize];
        }
    }
}

impl Solve {
    /// Computes the unknowns, given the values of the tape's instructions.
    fn evaluate(&self, values: &[f64], workspace: &mut [f64], unknowns: &mut [f64]) {
        let (inputs, workspace) = workspace.split_at_mut(self.operands.len());
        for (input, &operand) in inputs.iter_mut().zip(&self.operands) {
            *input = values[operand as usize];
        }
        let system = &*self.system;
        newton(system.search, system.unknowns, inputs, |inputs, values: &mut [f64; MOST_VALUES]| {
            system.residual.eval_in(workspace, inputs, values);
        });
        let solution = inputs.iter().copied().chain(std::iter::repeat(f64::NAN));
        unknowns.iter_mut().zip(solution).for_each(|(unknown, value)| *unknown = value);
    }
}
