//! Constructors of expressions, which simplify as they build.
//!
//! The rules are few, cheap and local. `x y` are arbitrary expressions, `c d` are constants. No
//! rule changes which values are NaN or infinite, except the rules marked *finite*: these are exact
//! for finite operands but drop a NaN (`0 * inf`). The sign of a zero is not preserved. Rules that
//! combine constants, and integer powers written as products, may change the last bit.
//!
//! | expression | result | condition |
//! |---|---|---|
//! | any operation on constants | its value, by [`calyx_abi::math`] | |
//! | `x + y`, `x * y`, `x == y`, `x & y`, `x \| y` | operands in order of age | |
//! | `x + 0`, `x - 0`, `1 * x`, `x / 1` | `x` | |
//! | `-1 * x`, `0 - x`, `x / -1` | `-x` | |
//! | `0 * x`, `0 / x` | `0` | finite, and divisor not zero |
//! | `x - x`, `c*x + d*x`, `c*x - d*x` | `(c + d) * x` ... | finite |
//! | `(x + c) + d`, `x - c` | `x + (c + d)`, `x + (-c)` | |
//! | `c * (d * x)` | `(c * d) * x` | |
//! | `-(-x)`, `-(x - y)`, `-(c * x)` | `x`, `y - x`, `(-c) * x` | |
//! | `x + (-y)`, `x - (-y)`, `(-x) - y` | `x - y`, `x + y`, `-(x + y)` | |
//! | `(-x) * y`, `(-x) / y`, `x / (-y)` | sign outside | |
//! | `sin(x)*sin(x) + cos(x)*cos(x)` | `1` | finite |
//! | `sin(-x)`, `tan(-x)`, `asin(-x)`, `atan(-x)` | sign outside | |
//! | `cos(-x)`, `abs(-x)` | sign dropped | |
//! | `abs(abs(x))`, `min(x, x)`, `max(x, x)` | `abs(x)`, `x`, `x` | |
//! | `x^-2`, `x^-1`, `x^0`, `x^1`, `x^2`, `x^3`, `x^4` | products, `1 / ...` | |
//! | `x^5`, `x^6`, `x^7`, `x^8` | products | |
//! | `!!(x < y)`, `true & (x < y)`, `false \| (x < y)` | the truth value | |
//! | `false & x`, `true \| x` | the constant | |
//! | `select(true, x, y)`, `select(false, x, y)`, `select(c, x, x)` | the arm | |
//! | `select(!c, x, y)` | `select(c, y, x)` | |

use crate::graph::{Binary, Graph, Node, NodeId, Unary};

impl Graph {
    pub fn unary(&mut self, operation: Unary, x: NodeId) -> NodeId {
        if self.constant_value(x).is_some() {
            return self.fold(Node::Unary(operation, x));
        }
        match (operation, self.node(x)) {
            (Unary::Negate, _) => self.negate(x),
            (Unary::Not, Node::Unary(Unary::Not, y)) if self.is_truth(y) => y,
            (Unary::Sin | Unary::Tan | Unary::Asin | Unary::Atan, Node::Unary(Unary::Negate, y)) => {
                let positive = self.unary(operation, y);
                self.negate(positive)
            }
            (Unary::Cos | Unary::Abs, Node::Unary(Unary::Negate, y)) => self.unary(operation, y),
            (Unary::Abs, Node::Unary(Unary::Abs, _)) => x,
            _ => self.intern(Node::Unary(operation, x)),
        }
    }

    pub fn binary(&mut self, operation: Binary, x: NodeId, y: NodeId) -> NodeId {
        match operation {
            _ if self.constant_value(x).is_some() && self.constant_value(y).is_some() => {
                self.fold(Node::Binary(operation, x, y))
            }
            Binary::Add => self.add(x, y),
            Binary::Subtract => self.subtract(x, y),
            Binary::Multiply => self.multiply(x, y),
            Binary::Divide => self.divide(x, y),
            Binary::Power => self.power(x, y),
            Binary::Min | Binary::Max if x == y => x,
            Binary::And | Binary::Or => self.logic(operation, x, y),
            Binary::Equal => self.intern(Node::Binary(operation, x.min(y), x.max(y))),
            // The derivative of `min` and `max` at a tie is that of the first operand, so the order
            // stays.
            Binary::Atan2 | Binary::Min | Binary::Max | Binary::Less | Binary::LessEqual => {
                self.intern(Node::Binary(operation, x, y))
            }
        }
    }

    pub fn negate(&mut self, x: NodeId) -> NodeId {
        match self.node(x) {
            Node::Constant(_) => self.fold(Node::Unary(Unary::Negate, x)),
            Node::Unary(Unary::Negate, y) => y,
            Node::Binary(Binary::Subtract, a, b) => self.subtract(b, a),
            Node::Binary(Binary::Multiply, a, b) => match self.constant_value(a) {
                Some(c) => self.scale(-c, b),
                None => self.intern(Node::Unary(Unary::Negate, x)),
            },
            _ => self.intern(Node::Unary(Unary::Negate, x)),
        }
    }

    pub fn add(&mut self, x: NodeId, y: NodeId) -> NodeId {
        // A constant is the second operand; otherwise the older operand comes first.
        let (x, y) = if self.constant_value(x).is_some() || self.constant_value(y).is_none() && y < x {
            (y, x)
        } else {
            (x, y)
        };
        if let Some(c) = self.constant_value(y) {
            return match self.node(x) {
                Node::Constant(_) => self.fold(Node::Binary(Binary::Add, x, y)),
                _ if c == 0.0 => x,
                Node::Binary(Binary::Add, a, b) if self.constant_value(b).is_some() => {
                    let sum = self.fold(Node::Binary(Binary::Add, b, y));
                    self.add(a, sum)
                }
                _ => self.intern(Node::Binary(Binary::Add, x, y)),
            };
        }
        if let Some(sum) = self.like_terms(x, y, 1.0) {
            return sum;
        }
        if self.is_sine_and_cosine_squared(x, y) || self.is_sine_and_cosine_squared(y, x) {
            return self.constant(1.0);
        }
        match (self.node(x), self.node(y)) {
            (_, Node::Unary(Unary::Negate, b)) => self.subtract(x, b),
            (Node::Unary(Unary::Negate, a), _) => self.subtract(y, a),
            _ => self.intern(Node::Binary(Binary::Add, x, y)),
        }
    }

    pub fn subtract(&mut self, x: NodeId, y: NodeId) -> NodeId {
        match (self.node(x), self.node(y)) {
            (Node::Constant(_), Node::Constant(_)) => self.fold(Node::Binary(Binary::Subtract, x, y)),
            (_, Node::Constant(_)) => {
                let negative = self.negate(y);
                self.add(x, negative)
            }
            (Node::Constant(bits), _) if f64::from_bits(bits) == 0.0 => self.negate(y),
            (_, Node::Unary(Unary::Negate, b)) => self.add(x, b),
            _ => {
                if let Some(difference) = self.like_terms(x, y, -1.0) {
                    return difference;
                }
                match self.node(x) {
                    Node::Unary(Unary::Negate, a) => {
                        let sum = self.add(a, y);
                        self.negate(sum)
                    }
                    _ => self.intern(Node::Binary(Binary::Subtract, x, y)),
                }
            }
        }
    }

    pub fn multiply(&mut self, x: NodeId, y: NodeId) -> NodeId {
        if self.constant_value(x).is_some() && self.constant_value(y).is_some() {
            return self.fold(Node::Binary(Binary::Multiply, x, y));
        }
        if let Some(c) = self.constant_value(x) {
            return self.scale(c, y);
        }
        if let Some(c) = self.constant_value(y) {
            return self.scale(c, x);
        }
        match (self.node(x), self.node(y)) {
            (Node::Unary(Unary::Negate, a), _) => {
                let product = self.multiply(a, y);
                self.negate(product)
            }
            (_, Node::Unary(Unary::Negate, b)) => {
                let product = self.multiply(x, b);
                self.negate(product)
            }
            _ => self.intern(Node::Binary(Binary::Multiply, x.min(y), x.max(y))),
        }
    }

    /// Returns a constant times an expression; the constant is the first operand.
    pub fn scale(&mut self, c: f64, x: NodeId) -> NodeId {
        let factor = self.constant(c);
        match self.node(x) {
            Node::Constant(_) => self.fold(Node::Binary(Binary::Multiply, factor, x)),
            _ if c == 0.0 => self.constant(0.0),
            _ if c == 1.0 => x,
            Node::Unary(Unary::Negate, y) => self.scale(-c, y),
            _ if c == -1.0 => self.negate(x),
            Node::Binary(Binary::Multiply, a, b) => match self.constant_value(a) {
                Some(d) => self.scale(c * d, b),
                None => self.intern(Node::Binary(Binary::Multiply, factor, x)),
            },
            _ => self.intern(Node::Binary(Binary::Multiply, factor, x)),
        }
    }

    pub fn divide(&mut self, x: NodeId, y: NodeId) -> NodeId {
        let (numerator, denominator) = (self.constant_value(x), self.constant_value(y));
        match (self.node(x), self.node(y)) {
            (Node::Constant(_), Node::Constant(_)) => self.fold(Node::Binary(Binary::Divide, x, y)),
            _ if numerator == Some(0.0) => self.constant(0.0),
            _ if denominator == Some(1.0) => x,
            _ if denominator == Some(-1.0) => self.negate(x),
            (Node::Unary(Unary::Negate, a), _) => {
                let quotient = self.divide(a, y);
                self.negate(quotient)
            }
            (_, Node::Unary(Unary::Negate, b)) => {
                let quotient = self.divide(x, b);
                self.negate(quotient)
            }
            _ => self.intern(Node::Binary(Binary::Divide, x, y)),
        }
    }

    pub fn power(&mut self, x: NodeId, y: NodeId) -> NodeId {
        if self.constant_value(x).is_some() && self.constant_value(y).is_some() {
            return self.fold(Node::Binary(Binary::Power, x, y));
        }
        let Some(exponent) = self.constant_value(y) else {
            return self.intern(Node::Binary(Binary::Power, x, y));
        };
        if exponent == 0.0 {
            return self.constant(1.0);
        }
        if exponent == 1.0 {
            return x;
        }
        // Matches the order of products in `calyx_abi::math::whole_power`.
        if ![-2.0, -1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0].contains(&exponent) {
            return self.intern(Node::Binary(Binary::Power, x, y));
        }
        let one = self.constant(1.0);
        if exponent == -1.0 {
            return self.divide(one, x);
        }
        let square = self.multiply(x, x);
        if exponent == -2.0 {
            return self.divide(one, square);
        }
        if exponent < 4.0 {
            return if exponent == 2.0 { square } else { self.multiply(square, x) };
        }
        let fourth = self.multiply(square, square);
        match exponent {
            5.0 => self.multiply(fourth, x),
            6.0 => self.multiply(fourth, square),
            7.0 => {
                let sixth = self.multiply(fourth, square);
                self.multiply(sixth, x)
            }
            8.0 => self.multiply(fourth, fourth),
            _ => fourth,
        }
    }

    /// Returns the second operand if the condition is true, otherwise the third. The value of the
    /// other arm does not affect the result, even if it is NaN. The same applies to derivatives.
    pub fn select(&mut self, condition: NodeId, x: NodeId, y: NodeId) -> NodeId {
        match self.node(condition) {
            Node::Constant(bits) if f64::from_bits(bits) != 0.0 => x,
            Node::Constant(_) => y,
            _ if x == y => x,
            Node::Unary(Unary::Not, inner) => self.select(inner, y, x),
            _ => self.intern(Node::Select(condition, x, y)),
        }
    }

    pub fn sin(&mut self, x: NodeId) -> NodeId {
        self.unary(Unary::Sin, x)
    }

    pub fn cos(&mut self, x: NodeId) -> NodeId {
        self.unary(Unary::Cos, x)
    }

    pub fn sqrt(&mut self, x: NodeId) -> NodeId {
        self.unary(Unary::Sqrt, x)
    }

    pub fn is_zero(&self, x: NodeId) -> bool {
        self.constant_value(x) == Some(0.0)
    }

    pub fn is_one(&self, x: NodeId) -> bool {
        self.constant_value(x) == Some(1.0)
    }

    /// Returns the value of an operation on constants.
    fn fold(&mut self, node: Node) -> NodeId {
        // Operands of this instruction are node ids, so their values come from the graph.
        let value_of = |place: u32| match self.node(NodeId::at(place)) {
            Node::Constant(bits) => f64::from_bits(bits),
            _ => f64::NAN,
        };
        let value = node.instruction(NodeId::place).evaluate(&[], value_of);
        self.constant(value)
    }

    /// Returns `x` as a constant factor times an expression.
    fn coefficient(&self, x: NodeId) -> (f64, NodeId) {
        match self.node(x) {
            Node::Unary(Unary::Negate, a) => {
                let (c, b) = self.coefficient(a);
                (-c, b)
            }
            Node::Binary(Binary::Multiply, a, b) => match self.constant_value(a) {
                Some(c) => (c, b),
                None => (1.0, x),
            },
            _ => (1.0, x),
        }
    }

    /// Returns `x + sign * y` if both are multiples of the same expression.
    fn like_terms(&mut self, x: NodeId, y: NodeId, sign: f64) -> Option<NodeId> {
        let ((c, a), (d, b)) = (self.coefficient(x), self.coefficient(y));
        (a == b).then(|| self.scale(c + sign * d, a))
    }

    fn is_sine_and_cosine_squared(&self, x: NodeId, y: NodeId) -> bool {
        let square = |id| match self.node(id) {
            Node::Binary(Binary::Multiply, a, b) if a == b => Some(self.node(a)),
            _ => None,
        };
        matches!((square(x), square(y)),
            (Some(Node::Unary(Unary::Sin, a)), Some(Node::Unary(Unary::Cos, b))) if a == b)
    }

    /// Returns `true` if a node is always 0 or 1.
    fn is_truth(&self, x: NodeId) -> bool {
        match self.node(x) {
            Node::Unary(Unary::Not, _) => true,
            Node::Binary(operation, ..) => {
                use Binary::{And, Equal, Less, LessEqual, Or};
                matches!(operation, Less | LessEqual | Equal | And | Or)
            }
            _ => false,
        }
    }

    fn logic(&mut self, operation: Binary, x: NodeId, y: NodeId) -> NodeId {
        for (constant, other) in [(x, y), (y, x)] {
            let Some(value) = self.constant_value(constant) else { continue };
            // `true` decides an `or` and `false` decides an `and`; the opposite value leaves the
            // other operand.
            if (value != 0.0) == (operation == Binary::Or) {
                return self.constant(if operation == Binary::Or { 1.0 } else { 0.0 });
            }
            if self.is_truth(other) {
                return other;
            }
        }
        self.intern(Node::Binary(operation, x.min(y), x.max(y)))
    }
}
