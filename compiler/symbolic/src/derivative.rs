//! Derivatives by a symbol, and replacement of a symbol.
//!
//! All other symbols are constants. Each node is differentiated once per symbol and remembered, so a second
//! derivative costs as much as the first. Conventions where a derivative does not exist:
//!
//! - `abs(x)` at 0: that of the branch `x >= 0`. `min(x, y)`, `max(x, y)` at `x = y`: that of `x`.
//! - `floor`, `ceil`, `round`, comparisons and logic: 0 everywhere, also at their steps.
//! - `sqrt` at 0, `asin` and `acos` at -1 and 1: infinite where the argument moves, NaN where it rests, as IEEE
//!   arithmetic has it; `atan2` at the origin: NaN. A conditional expression around them is a guard: the derivative
//!   of `select(c, x, y)` is `select(c, x', y')`, so that nothing of the arm not taken can reach the result.
//! - `x ^ y` with `x = 0`: the term `x^y log(x) y'` is 0, its limit for `y > 0`.

use crate::graph::{Binary, Graph, Node, NodeId, Unary};

impl Graph {
    /// The derivative of an expression by a symbol.
    pub fn derivative(&mut self, root: NodeId, symbol: u32) -> NodeId {
        let found =
            self.derivatives.get(&symbol).and_then(|known| known.get(root.index()).copied().flatten());
        if let Some(found) = found {
            return found;
        }
        let zero = self.constant(0.0);
        let mut known = self.derivatives.remove(&symbol).unwrap_or_default();
        if known.len() <= root.index() {
            known.resize(root.index() + 1, None);
        }
        let origin = self.set_origin(0);
        for id in self.reachable(&[root], |id| known[id.index()].is_none()) {
            let of = |operand: NodeId| known[operand.index()].unwrap_or(zero);
            self.set_origin(self.origin(id));
            let derivative = match self.node(id) {
                Node::Constant(_) => zero,
                Node::Symbol(index) => self.constant(if index == symbol { 1.0 } else { 0.0 }),
                Node::Unary(operation, a) => self.unary_derivative(operation, id, a, of(a)),
                Node::Binary(operation, a, b) => {
                    self.binary_derivative(operation, id, (a, of(a)), (b, of(b)))
                }
                Node::Select(c, a, b) => self.select(c, of(a), of(b)),
            };
            known[id.index()] = Some(derivative);
        }
        self.set_origin(origin);
        let result = known[root.index()].unwrap_or(zero);
        self.derivatives.insert(symbol, known);
        result
    }

    /// The expression with a symbol replaced by another expression.
    pub fn substitute(&mut self, root: NodeId, symbol: u32, replacement: NodeId) -> NodeId {
        let mut replaced: Vec<NodeId> = Vec::new();
        let order = self.reachable(&[root], |_| true);
        let place = |id: NodeId, order: &[NodeId]| order.binary_search(&id).unwrap_or(0);
        let origin = self.set_origin(0);
        for &id in &order {
            let of = |operand: NodeId| replaced[place(operand, &order)];
            self.set_origin(self.origin(id));
            let node = match self.node(id) {
                Node::Constant(_) => id,
                Node::Symbol(index) if index == symbol => replacement,
                Node::Symbol(_) => id,
                Node::Unary(operation, a) => self.unary(operation, of(a)),
                Node::Binary(operation, a, b) => self.binary(operation, of(a), of(b)),
                Node::Select(c, a, b) => self.select(of(c), of(a), of(b)),
            };
            replaced.push(node);
        }
        self.set_origin(origin);
        replaced.last().copied().unwrap_or(root)
    }

    /// Derivative of `node = operation(x)`, where `dx` is that of `x`.
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
                // (1 - x)(1 + x) keeps its digits near the ends, 1 - x^2 does not.
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

    /// Derivative of `node = operation(x, y)`, where each operand comes with its derivative.
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
                // atan2(x, y): x is the ordinate, y the abscissa.
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
