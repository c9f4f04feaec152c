//! Scheduling: selects the operations that the outputs need and orders them on a tape.

use crate::graph::{Graph, Node, NodeId, Unary};
use crate::tape::{Instruction, Tape, ValueId};
use std::collections::HashMap;

/// Marks a node that is not on the tape yet.
const UNPLACED: ValueId = ValueId::MAX;

impl Graph {
    /// Returns the operations that `outputs` need, each once, as a kernel with the given number of
    /// inputs.
    ///
    /// The order is depth-first from the outputs. Of two operands, the one that needs more
    /// registers is computed first (Sethi and Ullman 1970; optimal for trees), which keeps live
    /// ranges short for the register allocator. The cosine of an angle directly follows its sine,
    /// so that one call can compute both.
    pub fn schedule(&self, inputs: usize, outputs: &[NodeId]) -> Tape {
        let live = self.reachable(outputs, |_| true);
        let mut schedule = Schedule {
            graph: self,
            live: &live,
            registers: Vec::new(),
            places: vec![UNPLACED; self.len()],
            partner: vec![None; self.len()],
            solves: HashMap::new(),
            tables: HashMap::new(),
            tape: Tape { inputs, ..Tape::default() },
        };
        schedule.count_registers();
        schedule.find_partners();
        for &output in outputs {
            schedule.emit(output);
        }
        let places = schedule.places;
        let mut tape = schedule.tape;
        tape.outputs = outputs.iter().map(|id| places[id.index()]).collect();
        tape
    }
}

struct Schedule<'a> {
    graph: &'a Graph,
    live: &'a [NodeId],
    /// Registers needed to compute a node, if nothing were shared.
    registers: Vec<u32>,
    places: Vec<ValueId>,
    /// Maps the sine of an angle to its cosine and vice versa, where both are live.
    partner: Vec<Option<NodeId>>,
    /// The indices on the tape of the graph's applied systems.
    solves: HashMap<u32, u32>,
    /// The indices on the tape of the graph's tables.
    tables: HashMap<u32, u32>,
    tape: Tape,
}

impl Schedule<'_> {
    fn count_registers(&mut self) {
        self.registers = vec![1; self.graph.len()];
        for &id in self.live {
            let mut needs: Vec<u32> =
                self.graph.operands(id).map(|operand| self.registers[operand.index()]).collect();
            needs.sort_unstable_by(|a, b| b.cmp(a));
            let need =
                (0u32..).zip(needs).filter(|&(_, need)| need > 0).map(|(held, need)| need + held).max();
            self.registers[id.index()] = need.unwrap_or(1);
        }
    }

    fn find_partners(&mut self) {
        // The sine and cosine of each angle, if they occur.
        let mut by_angle: Vec<[Option<NodeId>; 2]> = vec![[None; 2]; self.graph.len()];
        for &id in self.live {
            let (angle, which) = match self.graph.node(id) {
                Node::Unary(Unary::Sin, angle) => (angle, 0),
                Node::Unary(Unary::Cos, angle) => (angle, 1),
                _ => continue,
            };
            by_angle[angle.index()][which] = Some(id);
            if let [Some(sine), Some(cosine)] = by_angle[angle.index()] {
                self.partner[sine.index()] = Some(cosine);
                self.partner[cosine.index()] = Some(sine);
            }
        }
    }

    /// Places a node and everything that it needs on the tape.
    fn emit(&mut self, root: NodeId) {
        // A node is popped twice: first to push its operands above it, then to place it.
        let mut pending = vec![(root, false)];
        while let Some((id, operands_are_placed)) = pending.pop() {
            if self.places[id.index()] != UNPLACED {
                continue;
            }
            if operands_are_placed {
                match (self.graph.node(id), self.partner[id.index()]) {
                    (Node::Unary(Unary::Cos, _), Some(sine)) => {
                        self.place(sine);
                        self.place(id);
                    }
                    (_, Some(cosine)) => {
                        self.place(id);
                        self.place(cosine);
                    }
                    _ => self.place(id),
                }
                continue;
            }
            pending.push((id, true));
            let mut operands: Vec<NodeId> = self.graph.operands(id).collect();
            // The last operand pushed is placed first; of equals, this is the first operand.
            operands.reverse();
            operands.sort_by_key(|operand| self.registers[operand.index()]);
            pending.extend(operands.into_iter().map(|operand| (operand, false)));
        }
    }

    fn place(&mut self, id: NodeId) {
        let places = &self.places;
        let place = |operand: NodeId| places[operand.index()];
        let instruction = match self.graph.node(id) {
            Node::Solution(applied, unknown) => {
                let next = self.tape.solves.len() as u32;
                let solve = *self.solves.entry(applied).or_insert(next);
                if solve == next {
                    self.tape.solves.push(self.graph.solve_at(applied, place));
                }
                Instruction::Solution(solve, unknown)
            }
            Node::Piecewise(table, x) => {
                let next = self.tape.tables.len() as u32;
                let id = *self.tables.entry(table).or_insert(next);
                if id == next {
                    self.tape.tables.push(self.graph.tables.get(table).clone());
                }
                Instruction::Piecewise(id, place(x))
            }
            node => node.instruction(place),
        };
        self.places[id.index()] = self.tape.instructions.len() as ValueId;
        self.tape.instructions.push(instruction);
    }
}
