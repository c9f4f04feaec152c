//! Sites that capture expressions, and captured sites: the chain rule between kernels.
//!
//! The kernel of a captured expression returns its value, its first two time derivatives, and the
//! same three of its derivative with respect to each of [`Program::graph_params`]. In the kernel
//! that captures it, these numbers are symbols, each declared as the derivative of another one, so
//! the chain rule applies to all operations on them. A derivative that would need more than these
//! numbers is an error.
//!
//! [`Program::graph_params`]: calyx_lang::ir::Program::graph_params

use super::value::Value;
use super::{KernelError, Lowering, TIME, broken};
use calyx_abi::Repr;
use calyx_lang::ir::Site;
use calyx_lang::span::Span;
use calyx_symbolic::{Frame, NodeId};

/// A symbol for unavailable derivatives. No kernel has that many inputs.
const BEYOND: u32 = u32::MAX;
/// Value, first and second time derivative.
const ORDERS: u32 = 3;

impl Lowering<'_> {
    /// Returns the derivative with respect to a symbol that is not available.
    pub(super) fn unknown_rate(&mut self, by: u32) -> NodeId {
        let beyond = self.graph.symbol(BEYOND);
        self.graph.set_rate(BEYOND, by, beyond);
        beyond
    }

    /// Returns a captured expression whose numbers are the inputs from `first` on.
    pub(super) fn part(&mut self, repr: &Repr, first: u32, span: Span) -> Result<Value, KernelError> {
        let size = repr.slots() as u32;
        let params = &self.program.graph_params;
        let block = size * ORDERS;
        let end = first + block * (1 + params.len() as u32);
        let declared = self.parts.iter().any(|part| part.start == first);
        let by = if declared { 0 } else { 1 + self.program.params.len() as u32 };
        let by: Vec<u32> = (0..by).collect();
        let beyond = self.graph.symbol(BEYOND);
        for &symbol in &by {
            self.graph.set_rate(BEYOND, symbol, beyond);
        }
        for input in 0..end - first {
            let (basis, order) = (input / block, input % block / size);
            for &symbol in &by {
                let place = match symbol {
                    TIME => (order + 1 < ORDERS).then_some(input + size),
                    param => params
                        .iter()
                        .position(|known| 1 + known == param)
                        .filter(|_| basis == 0)
                        .map(|position| input + block * (1 + position as u32)),
                };
                let rate = match place {
                    Some(place) => self.graph.symbol(first + place),
                    None => beyond,
                };
                self.graph.set_rate(first + input, symbol, rate);
            }
        }
        if !declared {
            self.parts.push(first..end);
        }
        let symbol = |lowering: &mut Self, i: usize| lowering.graph.symbol(first + i as u32);
        Ok(match repr {
            Repr::Number => Value::Number(symbol(self, 0)),
            Repr::Vector => Value::Vector([0, 1, 2].map(|i| symbol(self, i))),
            Repr::Transform => Value::Frame(Frame::from_pose(std::array::from_fn(|i| symbol(self, i)))),
            _ => return Err(broken("an expression must be a number, vector or transform", span)),
        })
    }

    /// Appends the derivatives with respect to the params to the outputs of a site that may be
    /// captured.
    pub(super) fn with_params(&mut self, outputs: Vec<NodeId>, site: &Site) -> Vec<NodeId> {
        let mut all = outputs.clone();
        if site.part {
            for &param in &self.program.graph_params {
                all.extend(outputs.iter().map(|&output| self.graph.derivative(output, 1 + param)));
            }
        }
        all
    }

    /// Rejects outputs that need a derivative that a captured expression does not provide.
    pub(super) fn reject_beyond(&self, outputs: &[NodeId], span: Span) -> Result<(), KernelError> {
        if self.parts.is_empty() || !self.graph.depends_on(outputs, |symbol| symbol == BEYOND) {
            return Ok(());
        }
        Err(KernelError {
            message: "an expression selected at run time has only two derivatives with respect to `Time`, \
                      and one with respect to a param"
                .into(),
            help:
                "differentiate the expression before it is selected, or write it as a conditional expression"
                    .into(),
            span,
        })
    }

    /// Rejects evaluation of a captured expression at other times or params: its numbers are valid
    /// only for the current ones.
    pub(super) fn reject_parts_at(&self, value: &Value, by: u32, span: Span) -> Result<(), KernelError> {
        if self.parts.is_empty() || by as usize > self.program.params.len() {
            return Ok(());
        }
        let mut nodes = Vec::new();
        value.for_each(|node| nodes.push(node));
        if !self.graph.depends_on(&nodes, |symbol| self.parts.iter().any(|part| part.contains(&symbol))) {
            return Ok(());
        }
        Err(KernelError {
            message: "within an expression, one that is selected at run time cannot be evaluated with `at`"
                .into(),
            help: "evaluate it separately, with `=`".into(),
            span,
        })
    }
}
