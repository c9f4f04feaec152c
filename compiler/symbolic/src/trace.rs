//! NaN tracing: finds the operation that first produced a NaN from operands that are not NaN.
//!
//! Kernels do not check for NaN, because that would cost time in every evaluation. When an output
//! is NaN, its expression is evaluated again with all intermediate values stored, and the NaN is
//! followed back through its operands.

use crate::graph::{Graph, Node, NodeId};
use calyx_abi::newton::Search;

/// The operation that produced a NaN.
#[derive(Clone, Debug, PartialEq)]
pub struct FirstNan {
    pub node: Node,
    /// For a solution, the search that failed.
    pub search: Option<FailedSearch>,
    /// The mark set by [`Graph::set_origin`].
    pub origin: u32,
    /// Values of the operands; none of them is NaN.
    pub operands: Vec<f64>,
}

/// A search of a root or minimum that failed.
#[derive(Clone, Debug, PartialEq)]
pub struct FailedSearch {
    /// The kind of point that was not found.
    pub search: Search,
    pub guess: Vec<f64>,
    /// The unknowns at the last iterate.
    pub reached: Vec<f64>,
    /// The residuals, or the gradient of the function, at the last iterate.
    pub residuals: Vec<f64>,
}

impl Graph {
    /// Evaluates the outputs and follows the first NaN among them to its origin. Returns `None` if
    /// no output is NaN.
    ///
    /// If an input was NaN, the node is that [`Node::Symbol`]. If the expression contains a literal
    /// NaN, the node is a [`Node::Constant`].
    pub fn first_nan(&self, outputs: &[NodeId], inputs: &[f64]) -> Option<FirstNan> {
        let order = self.reachable(outputs, |_| true);
        let tape = self.schedule(inputs.len(), &order);
        let mut values = vec![0.0; order.len()];
        tape.eval(inputs, &mut Vec::new(), &mut values);
        let value = |id: NodeId| order.binary_search(&id).map_or(0.0, |place| values[place]);
        let mut at = *outputs.iter().find(|id| value(**id).is_nan())?;
        loop {
            let node = self.node(at);
            let operands = match node {
                // The arm that is not selected does not affect the result.
                Node::Select(c, a, b) => vec![c, if value(c) != 0.0 { a } else { b }],
                _ => self.operands(at).collect(),
            };
            // Operands have smaller ids, so the loop terminates.
            match operands.iter().find(|operand| value(**operand).is_nan()) {
                Some(operand) => at = *operand,
                None => {
                    let operands: Vec<f64> = operands.into_iter().map(value).collect();
                    let search = self.system(at).map(|system| {
                        let mut inputs = operands.clone();
                        let residuals = system.last_iterate(&mut inputs);
                        let unknowns = |inputs: &[f64]| inputs[..system.unknowns.min(inputs.len())].to_vec();
                        FailedSearch {
                            search: system.search,
                            guess: unknowns(&operands),
                            reached: unknowns(&inputs),
                            residuals,
                        }
                    });
                    return Some(FirstNan { node, search, origin: self.origin(at), operands });
                }
            }
        }
    }
}
