//! Implicit functions: the unknowns at which residuals vanish, as functions of everything else in
//! the residuals.
//!
//! The residuals are stored as a *template*: expressions of the unknowns and of arguments. The
//! arguments stand for the largest subexpressions that do not contain an unknown, so these are
//! evaluated once and not in each iteration. A template is closed; it is applied to a guess and to
//! the values of its arguments. Substitution and dependence therefore concern these operands only,
//! as for any other operation.
//!
//! The derivatives follow from the implicit function theorem. With the residuals `f(x, a) = 0`, the
//! unknowns `x` and the arguments `a`,
//!
//! ```text
//! dx/ds = -(df/dx)^-1 (df/da) (da/ds).
//! ```
//!
//! The right side is an expression of the solution, so higher derivatives follow by differentiating
//! it again. The guess does not affect the solution and has no part in its derivatives.

use crate::graph::{Graph, Node, NodeId};
use crate::tape::{Instruction, Solve, System, Tape};
use calyx_abi::newton::{MOST_UNKNOWNS, Search};
use std::collections::HashMap;
use std::sync::Arc;

/// The first symbol of templates: unknowns, then arguments. Kernels have fewer inputs.
const LOCAL: u32 = 1 << 31;

/// Residuals as expressions of local symbols.
#[derive(Clone, Debug)]
struct Template {
    residuals: Vec<NodeId>,
    /// The derivatives of the residuals with respect to the unknowns, row by row.
    jacobian: Vec<NodeId>,
    system: Arc<System>,
}

/// A template with its guess and its arguments.
#[derive(Clone, Debug)]
struct Applied {
    template: u32,
    operands: Vec<NodeId>,
}

/// The implicit functions of a graph.
#[derive(Clone, Debug, Default)]
pub(crate) struct Implicit {
    templates: Vec<Template>,
    /// Templates by their residuals, number of arguments and kind.
    known: HashMap<(Vec<NodeId>, usize, Search), u32>,
    applied: Vec<Applied>,
    ids: HashMap<(u32, Vec<NodeId>), u32>,
}

impl Implicit {
    /// Returns the operands of a solution; none for other nodes.
    pub(crate) fn operands(&self, node: Node) -> &[NodeId] {
        match node {
            Node::Solution(applied, _) => {
                self.applied.get(applied as usize).map_or(&[], |applied| applied.operands.as_slice())
            }
            _ => &[],
        }
    }
}

impl Graph {
    /// Returns the unknowns at which the residuals vanish, found from a guess. `unknowns` are
    /// symbols that only the residuals contain; their numbers must be equal, at most
    /// [`MOST_UNKNOWNS`]. Returns `None` if they are not.
    pub fn solve(&mut self, unknowns: &[u32], residuals: &[NodeId], guess: &[NodeId]) -> Option<Vec<NodeId>> {
        self.search(Search::Root, unknowns, residuals, guess)
    }

    /// Returns the unknowns at which an expression has a local minimum, found from a guess: its
    /// gradient vanishes there and its Hessian is positive definite. The derivatives of the minimum
    /// are those of the root of the gradient. Otherwise as [`Graph::solve`].
    pub fn minimize(&mut self, unknowns: &[u32], objective: NodeId, guess: &[NodeId]) -> Option<Vec<NodeId>> {
        let gradient: Vec<NodeId> =
            unknowns.iter().map(|&unknown| self.derivative(objective, unknown)).collect();
        self.search(Search::Minimum, unknowns, &gradient, guess)
    }

    fn search(
        &mut self,
        search: Search,
        unknowns: &[u32],
        residuals: &[NodeId],
        guess: &[NodeId],
    ) -> Option<Vec<NodeId>> {
        let count = unknowns.len();
        if !(1..=MOST_UNKNOWNS).contains(&count) || residuals.len() != count || guess.len() != count {
            return None;
        }
        let arguments = self.arguments(unknowns, residuals);
        let mut replacements = Vec::new();
        for (&unknown, local) in unknowns.iter().zip(LOCAL..) {
            replacements.push((self.symbol(unknown), self.symbol(local)));
        }
        for (&argument, local) in arguments.iter().zip(LOCAL + MOST_UNKNOWNS as u32..) {
            replacements.push((argument, self.symbol(local)));
        }
        let residuals = self.replace_all(residuals, &replacements);
        let template = self.template(search, residuals, arguments.len());
        let operands: Vec<NodeId> = guess.iter().copied().chain(arguments).collect();
        Some((0..count as u32).map(|unknown| self.applied(template, unknown, operands.clone())).collect())
    }

    /// Returns the largest subexpressions of the residuals that contain no unknown, except
    /// constants.
    fn arguments(&self, unknowns: &[u32], residuals: &[NodeId]) -> Vec<NodeId> {
        let order = self.reachable(residuals, |_| true);
        let mut varies = vec![false; order.len()];
        let place = |id: NodeId| order.binary_search(&id).unwrap_or(0);
        let mut arguments = Vec::new();
        for (at, &id) in order.iter().enumerate() {
            varies[at] = match self.node(id) {
                Node::Symbol(symbol) => unknowns.contains(&symbol),
                _ => self.operands(id).any(|operand| varies[place(operand)]),
            };
            if varies[at] {
                arguments.extend(self.operands(id).filter(|operand| !varies[place(*operand)]));
            }
        }
        arguments.extend(residuals.iter().filter(|residual| !varies[place(**residual)]));
        arguments.retain(|argument| self.constant_value(*argument).is_none());
        arguments.sort_unstable();
        arguments.dedup();
        arguments
    }

    /// Returns the template with these residuals in local symbols.
    fn template(&mut self, search: Search, residuals: Vec<NodeId>, arguments: usize) -> u32 {
        let key = (residuals.clone(), arguments, search);
        if let Some(&known) = self.implicit.known.get(&key) {
            return known;
        }
        let unknowns = residuals.len();
        let mut jacobian = Vec::with_capacity(unknowns * unknowns);
        for &residual in &residuals {
            for unknown in 0..unknowns as u32 {
                jacobian.push(self.derivative(residual, LOCAL + unknown));
            }
        }
        let outputs: Vec<NodeId> = residuals.iter().chain(&jacobian).copied().collect();
        let tape = self.schedule(unknowns + arguments, &outputs);
        let input = |symbol: u32| match symbol.wrapping_sub(LOCAL) as usize {
            unknown if unknown < MOST_UNKNOWNS => unknown,
            argument => argument - MOST_UNKNOWNS + unknowns,
        };
        let local = |instruction: &Instruction| match *instruction {
            Instruction::Input(symbol) => Instruction::Input(input(symbol) as u32),
            other => other,
        };
        let instructions = tape.instructions.iter().map(local).collect();
        let system = Arc::new(System { search, unknowns, residual: Tape { instructions, ..tape } });
        let id = self.implicit.templates.len() as u32;
        self.implicit.templates.push(Template { residuals, jacobian, system });
        self.implicit.known.insert(key, id);
        id
    }

    fn applied(&mut self, template: u32, unknown: u32, operands: Vec<NodeId>) -> NodeId {
        let next = self.implicit.applied.len() as u32;
        let applied = *self.implicit.ids.entry((template, operands.clone())).or_insert(next);
        if applied == next {
            self.implicit.applied.push(Applied { template, operands });
        }
        self.intern(Node::Solution(applied, unknown))
    }

    /// Returns an unknown of an applied system with other operands.
    pub(crate) fn solution(&mut self, applied: u32, unknown: u32, operands: Vec<NodeId>) -> NodeId {
        let template = self.implicit.applied[applied as usize].template;
        self.applied(template, unknown, operands)
    }

    /// Returns the system of a solution.
    pub fn system(&self, id: NodeId) -> Option<&System> {
        let Node::Solution(applied, _) = self.node(id) else { return None };
        let template = self.implicit.applied.get(applied as usize)?.template;
        self.implicit.templates.get(template as usize).map(|template| &*template.system)
    }

    /// Returns the applied system as part of a tape, on which `place(operand)` computes the
    /// operands.
    pub(crate) fn solve_at(&self, applied: u32, place: impl Fn(NodeId) -> u32) -> Solve {
        let applied = &self.implicit.applied[applied as usize];
        Solve {
            system: self.implicit.templates[applied.template as usize].system.clone(),
            operands: applied.operands.iter().map(|&operand| place(operand)).collect(),
        }
    }

    /// Returns the derivative of an unknown, given those of the operands.
    pub(crate) fn solution_derivative(
        &mut self,
        applied: u32,
        unknown: u32,
        derivatives: &[NodeId],
    ) -> NodeId {
        let Applied { template, operands } = self.implicit.applied[applied as usize].clone();
        let Template { residuals, jacobian, .. } = self.implicit.templates[template as usize].clone();
        let count = residuals.len();
        let (_, arguments) = operands.split_at(count);
        let zero = self.constant(0.0);
        // The solution and the arguments in place of the local symbols.
        let mut values = Vec::new();
        for k in 0..count as u32 {
            values.push((LOCAL + k, self.intern(Node::Solution(applied, k))));
        }
        values.extend((LOCAL + MOST_UNKNOWNS as u32..).zip(arguments.iter().copied()));
        // The derivatives of the residuals at fixed unknowns.
        let mut right = vec![zero; count];
        for (local, &derivative) in (LOCAL + MOST_UNKNOWNS as u32..).zip(derivatives.iter().skip(count)) {
            if self.is_zero(derivative) {
                continue;
            }
            let by: Vec<NodeId> =
                residuals.iter().map(|&residual| self.derivative(residual, local)).collect();
            let by = self.substitute_all(&by, &values);
            for (sum, by) in right.iter_mut().zip(by) {
                let term = self.multiply(by, derivative);
                *sum = self.add(*sum, term);
            }
        }
        if right.iter().all(|&sum| self.is_zero(sum)) {
            return zero;
        }
        let jacobian = self.substitute_all(&jacobian, &values);
        let rows: Vec<usize> = (0..count).collect();
        let determinant = self.minor(&jacobian, count, &rows, &rows);
        // Cramer's rule: the numerator is the determinant with the right side as the column of the
        // unknown. The minors are shared by all derivatives of the solution.
        let unknown = unknown as usize;
        let columns: Vec<usize> = rows.iter().copied().filter(|&column| column != unknown).collect();
        let mut numerator = zero;
        for (i, &sum) in right.iter().enumerate() {
            let others: Vec<usize> = rows.iter().copied().filter(|&row| row != i).collect();
            let minor = self.minor(&jacobian, count, &others, &columns);
            let term = self.multiply(minor, sum);
            numerator = match (i + unknown) % 2 {
                0 => self.add(numerator, term),
                _ => self.subtract(numerator, term),
            };
        }
        let quotient = self.divide(numerator, determinant);
        self.negate(quotient)
    }

    /// Returns the determinant of some rows and columns of a square matrix, expanded along the
    /// first row; 1 for none.
    fn minor(&mut self, matrix: &[NodeId], size: usize, rows: &[usize], columns: &[usize]) -> NodeId {
        let Some((&first, rows)) = rows.split_first() else { return self.constant(1.0) };
        let mut sum = self.constant(0.0);
        for (position, &column) in columns.iter().enumerate() {
            let entry = matrix[first * size + column];
            if self.is_zero(entry) {
                continue;
            }
            let others: Vec<usize> = columns.iter().copied().filter(|&other| other != column).collect();
            let minor = self.minor(matrix, size, rows, &others);
            let term = self.multiply(entry, minor);
            sum = if position % 2 == 0 { self.add(sum, term) } else { self.subtract(sum, term) };
        }
        sum
    }
}
