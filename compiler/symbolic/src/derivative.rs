//! Partial derivatives with respect to a symbol, and substitution of symbols.
//!
//! All other symbols are constants. The graph caches the derivative of each node with respect to
//! each symbol, so a second derivative costs as much as the first. Conventions where a derivative
//! does not exist:
//!
//! - `abs(x)` at 0: the derivative of the branch `x >= 0`. `min(x, y)`, `max(x, y)` at `x = y`: the
//!   derivative of `x`.
//! - `floor`, `ceil`, `round`, comparisons and logic: 0 everywhere, also at their steps.
//! - `sqrt` at 0, `asin` and `acos` at -1 and 1: infinite if the derivative of the argument is not
//!   zero, otherwise NaN, following IEEE arithmetic. `atan2` at the origin: NaN. A conditional
//!   expression guards against these: the derivative of `select(c, x, y)` is `select(c, x', y')`,
//!   so the arm that is not selected cannot affect the result.
//! - `x ^ y` with `x = 0`: the term `x^y log(x) y'` is 0, its limit for `y > 0`.
//!
//! Implicit functions are differentiated by the implicit function theorem (module `implicit`).

use crate::graph::{Binary, Graph, Node, NodeId, Unary};
use std::collections::HashMap;

impl Graph {
    /// Returns the derivative of an expression with respect to a symbol.
    ///
    /// If every path from the expression to the symbol leads through one shared node, the chain
    /// rule is applied at that node. An example is an angle that is used by a sine, a cosine and a
    /// coefficient. All derivatives of expressions in that angle then share the derivative of the
    /// angle.
    pub fn derivative(&mut self, root: NodeId, symbol: u32) -> NodeId {
        if let Some(&known) = self.total_derivatives.get(&(root, symbol)) {
            return known;
        }
        if self.moving.contains(&symbol) {
            return self.derivative_of_moving(root, symbol);
        }
        let variable = self.symbol(symbol);
        let waypoints = self.waypoints(root, variable);
        // From the symbol upwards: each waypoint with the derivative of its successor.
        let origin = self.set_origin(0);
        let mut result: Option<NodeId> = None;
        for (place, &waypoint) in waypoints.iter().enumerate().rev() {
            let above = if place == 0 { root } else { waypoints[place - 1] };
            let factor = self.derivative_by(above, waypoint);
            self.set_origin(self.origin(above));
            result = Some(match result {
                Some(below) => self.multiply(factor, below),
                None => factor,
            });
        }
        self.set_origin(origin);
        let result = result.unwrap_or_else(|| self.constant(0.0));
        self.total_derivatives.insert((root, symbol), result);
        result
    }

    /// Declares the derivative of a symbol with respect to another symbol.
    pub fn set_rate(&mut self, symbol: u32, by: u32, rate: NodeId) {
        if self.rates.insert((symbol, by), rate) == Some(rate) {
            return;
        }
        self.moving.insert(by);
        self.total_derivatives.retain(|(_, known), _| *known != by);
    }

    /// Returns the derivative with respect to a symbol on which other symbols depend.
    fn derivative_of_moving(&mut self, root: NodeId, symbol: u32) -> NodeId {
        let zero = self.constant(0.0);
        let order = self.reachable(&[root], |id| !self.total_derivatives.contains_key(&(id, symbol)));
        let origin = self.set_origin(0);
        for id in order {
            let node = self.node(id);
            let derivatives: Vec<NodeId> = self
                .operands(id)
                .map(|operand| self.total_derivatives.get(&(operand, symbol)).copied().unwrap_or(zero))
                .collect();
            let [a, b, c] = [0, 1, 2].map(|at| derivatives.get(at).copied().unwrap_or(zero));
            self.set_origin(self.origin(id));
            let derivative = match node {
                Node::Solution(applied, unknown) => self.solution_derivative(applied, unknown, &derivatives),
                Node::Piecewise(table, x) => self.piecewise_derivative(table, x, a),
                Node::Lookup(order, table, x) => self.lookup_derivative(order, table, x, b),
                Node::Constant(_) => zero,
                Node::Symbol(index) if index == symbol => self.constant(1.0),
                Node::Symbol(index) => self.rates.get(&(index, symbol)).copied().unwrap_or(zero),
                Node::Unary(operation, x) => self.unary_derivative(operation, id, x, a),
                Node::Binary(operation, x, y) => self.binary_derivative(operation, id, (x, a), (y, b)),
                Node::Select(condition, ..) => self.select(condition, b, c),
            };
            self.total_derivatives.insert((id, symbol), derivative);
        }
        self.set_origin(origin);
        self.total_derivatives.get(&(root, symbol)).copied().unwrap_or(zero)
    }

    /// Returns the derivative with respect to a node that is treated as an independent variable.
    fn derivative_by(&mut self, root: NodeId, variable: NodeId) -> NodeId {
        let zero = self.constant(0.0);
        let mut known = self.derivatives.remove(&variable).unwrap_or_default();
        // Operands have smaller ids than their users, so older nodes do not contain the variable.
        let place = |id: NodeId| id.index().checked_sub(variable.index());
        let Some(last) = place(root) else { return zero };
        if known.len() <= last {
            known.resize(last + 1, None);
        }
        let origin = self.set_origin(0);
        for id in self.reachable(&[root], |id| place(id).is_some_and(|place| known[place].is_none())) {
            let of = |operand: NodeId| place(operand).and_then(|place| known[place]).unwrap_or(zero);
            self.set_origin(self.origin(id));
            let derivative = match self.node(id) {
                _ if id == variable => self.constant(1.0),
                Node::Constant(_) | Node::Symbol(_) => zero,
                Node::Unary(operation, a) => self.unary_derivative(operation, id, a, of(a)),
                Node::Binary(operation, a, b) => {
                    self.binary_derivative(operation, id, (a, of(a)), (b, of(b)))
                }
                Node::Select(c, a, b) => self.select(c, of(a), of(b)),
                Node::Piecewise(table, a) => self.piecewise_derivative(table, a, of(a)),
                Node::Lookup(order, table, x) => self.lookup_derivative(order, table, x, of(x)),
                Node::Solution(applied, unknown) => {
                    let derivatives: Vec<NodeId> = self.operands(id).map(of).collect();
                    self.solution_derivative(applied, unknown, &derivatives)
                }
            };
            if let Some(place) = place(id) {
                known[place] = Some(derivative);
            }
        }
        self.set_origin(origin);
        let result = known[last].unwrap_or(zero);
        self.derivatives.insert(variable, known);
        result
    }

    /// Returns the shared nodes that lie on every path from the root to the variable, root first,
    /// followed by the variable itself. The result is empty if there is no path.
    ///
    /// A waypoint never lies below a conditional expression: `select(c, x', y')` blocks a NaN of
    /// the arm that is not selected, a product of derivatives would not.
    fn waypoints(&self, root: NodeId, variable: NodeId) -> Vec<NodeId> {
        let place = |id: NodeId| id.index().checked_sub(variable.index());
        let Some(last) = place(root) else { return Vec::new() };
        let order = self.reachable(&[root], |id| id >= variable);
        let mut depends = vec![false; last + 1];
        for &id in &order {
            let Some(at) = place(id) else { continue };
            let mut operands = self.operands(id);
            depends[at] = at == 0 || operands.any(|operand| place(operand).is_some_and(|at| depends[at]));
        }
        if !depends[last] {
            return Vec::new();
        }
        let mut found = Vec::new();
        let mut uses = vec![0_u32; last + 1];
        // Nodes that were reached but not visited. If there is only one, all paths pass through it.
        let mut pending = 1;
        for &id in order.iter().rev() {
            let Some(at) = place(id).filter(|&at| depends[at]) else { continue };
            pending -= 1;
            if id != root && pending == 0 && uses[at] > 1 || at == 0 {
                found.push(id);
            }
            if self.is_choice(id) && id != variable {
                found.push(variable);
                return found;
            }
            for operand in self.operands(id) {
                if let Some(at) = place(operand).filter(|&at| depends[at]) {
                    pending += usize::from(uses[at] == 0);
                    uses[at] += 1;
                }
            }
        }
        found
    }

    /// Returns `true` if the derivative of a node selects between terms.
    fn is_choice(&self, id: NodeId) -> bool {
        match self.node(id) {
            Node::Select(..) | Node::Unary(Unary::Abs, _) | Node::Binary(Binary::Min | Binary::Max, ..) => {
                true
            }
            Node::Binary(Binary::Power, _, exponent) => self.constant_value(exponent).is_none(),
            _ => false,
        }
    }

    /// Returns the expression with a symbol replaced by another expression.
    pub fn substitute(&mut self, root: NodeId, symbol: u32, replacement: NodeId) -> NodeId {
        self.substitute_all(&[root], &[(symbol, replacement)]).first().copied().unwrap_or(root)
    }

    /// Returns the expressions with all given symbols replaced simultaneously. Replacements are not
    /// searched for further symbols.
    pub fn substitute_all(&mut self, roots: &[NodeId], replacements: &[(u32, NodeId)]) -> Vec<NodeId> {
        let symbols: Vec<(NodeId, NodeId)> =
            replacements.iter().map(|&(symbol, replacement)| (self.symbol(symbol), replacement)).collect();
        self.replace_all(roots, &symbols)
    }

    /// Returns the expressions with all given expressions in them replaced simultaneously.
    pub(crate) fn replace_all(&mut self, roots: &[NodeId], replacements: &[(NodeId, NodeId)]) -> Vec<NodeId> {
        // The first of several replacements counts.
        let known: HashMap<NodeId, NodeId> = replacements.iter().rev().copied().collect();
        let order = self.reachable(roots, |_| true);
        let mut replaced: Vec<NodeId> = Vec::with_capacity(order.len());
        let place = |id: NodeId| order.binary_search(&id).unwrap_or(0);
        let origin = self.set_origin(0);
        for &id in &order {
            let of = |operand: NodeId| replaced[place(operand)];
            self.set_origin(self.origin(id));
            let node = match self.node(id) {
                _ if known.contains_key(&id) => known.get(&id).copied().unwrap_or(id),
                Node::Constant(_) | Node::Symbol(_) => id,
                Node::Unary(operation, a) => self.unary(operation, of(a)),
                Node::Binary(operation, a, b) => self.binary(operation, of(a), of(b)),
                Node::Select(c, a, b) => self.select(of(c), of(a), of(b)),
                Node::Piecewise(table, a) => self.piecewise_of(table, of(a)),
                Node::Lookup(order, table, x) => self.lookup(order, of(table), of(x)),
                Node::Solution(applied, unknown) => {
                    let operands = self.operands(id).map(of).collect();
                    self.solution(applied, unknown, operands)
                }
            };
            replaced.push(node);
        }
        self.set_origin(origin);
        roots.iter().map(|root| replaced[place(*root)]).collect()
    }

    /// Returns the derivative of `node = operation(x)`, where `dx` is the derivative of `x`.
    fn unary_derivative(&mut self, operation: Unary, node: NodeId, x: NodeId, dx: NodeId) -> NodeId {
        if self.is_zero(dx) {
            return dx;
        }
        match operation {
            Unary::Negate => self.negate(dx),
            Unary::Abs => {
                let zero = self.constant(0.0);
                let positive = self.binary(Binary::LessEqual, zero, x);
                let negated = self.negate(dx);
                self.select(positive, dx, negated)
            }
            Unary::Sqrt => {
                let twice = self.scale(2.0, node);
                self.divide(dx, twice)
            }
            Unary::Sin => {
                let cosine = self.cos(x);
                self.multiply(cosine, dx)
            }
            Unary::Cos => {
                let sine = self.sin(x);
                let product = self.multiply(sine, dx);
                self.negate(product)
            }
            Unary::Tan => {
                let square = self.multiply(node, node);
                let one = self.constant(1.0);
                let slope = self.add(square, one);
                self.multiply(slope, dx)
            }
            Unary::Asin | Unary::Acos => {
                // `(1 - x)(1 + x)` is accurate near ±1; `1 - x^2` suffers from cancellation.
                let one = self.constant(1.0);
                let (below, above) = (self.subtract(one, x), self.add(one, x));
                let product = self.multiply(below, above);
                let root = self.sqrt(product);
                let quotient = self.divide(dx, root);
                if operation == Unary::Asin { quotient } else { self.negate(quotient) }
            }
            Unary::Atan => {
                let square = self.multiply(x, x);
                let one = self.constant(1.0);
                let denominator = self.add(square, one);
                self.divide(dx, denominator)
            }
            Unary::Exp => self.multiply(node, dx),
            Unary::Log => self.divide(dx, x),
            Unary::Floor | Unary::Ceil | Unary::Round | Unary::Not => self.constant(0.0),
        }
    }

    /// Returns the derivative of `node = operation(x, y)`; each operand is paired with its
    /// derivative.
    fn binary_derivative(
        &mut self,
        operation: Binary,
        node: NodeId,
        (x, dx): (NodeId, NodeId),
        (y, dy): (NodeId, NodeId),
    ) -> NodeId {
        if self.is_zero(dx) && self.is_zero(dy) {
            return dx;
        }
        match operation {
            Binary::Add => self.add(dx, dy),
            Binary::Subtract => self.subtract(dx, dy),
            Binary::Multiply => {
                let (first, second) = (self.multiply(dx, y), self.multiply(x, dy));
                self.add(first, second)
            }
            Binary::Divide => {
                // (x' - (x/y) y') / y reuses the quotient.
                let product = self.multiply(node, dy);
                let difference = self.subtract(dx, product);
                self.divide(difference, y)
            }
            Binary::Power => {
                let one = self.constant(1.0);
                let lowered = self.subtract(y, one);
                let slope = self.power(x, lowered);
                let by_base = self.multiply(y, slope);
                let by_base = self.multiply(by_base, dx);
                if self.is_zero(dy) {
                    return by_base;
                }
                let zero = self.constant(0.0);
                let logarithm = self.unary(Unary::Log, x);
                let by_exponent = self.multiply(node, logarithm);
                let by_exponent = self.multiply(by_exponent, dy);
                let at_zero = self.binary(Binary::Equal, x, zero);
                let by_exponent = self.select(at_zero, zero, by_exponent);
                self.add(by_base, by_exponent)
            }
            Binary::Atan2 => {
                // In `atan2(x, y)`, x is the ordinate and y the abscissa.
                let (first, second) = (self.multiply(y, dx), self.multiply(x, dy));
                let numerator = self.subtract(first, second);
                let (xx, yy) = (self.multiply(x, x), self.multiply(y, y));
                let denominator = self.add(xx, yy);
                self.divide(numerator, denominator)
            }
            Binary::Min => {
                let first = self.binary(Binary::LessEqual, x, y);
                self.select(first, dx, dy)
            }
            Binary::Max => {
                let first = self.binary(Binary::LessEqual, y, x);
                self.select(first, dx, dy)
            }
            Binary::Less | Binary::LessEqual | Binary::Equal | Binary::And | Binary::Or => self.constant(0.0),
        }
    }
}
