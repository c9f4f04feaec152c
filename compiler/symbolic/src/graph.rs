//! The arena of expressions. Every distinct expression is stored once (hash-consing), so two
//! expressions are equal if their ids are equal.
//!
//! Sharing keeps derivatives small: the second derivative of a chain of eight joints has a few
//! hundred operations as a graph and tens of thousands as a tree. Operands are created before their
//! users, so ascending ids are a topological order. Every pass over the graph is a loop without
//! recursion, however deep the expressions are.

use crate::implicit::Implicit;
use crate::piecewise::Tables;
use crate::tape::{Instruction, ValueId};
use std::collections::{HashMap, HashSet};

/// The id of an expression in a [`Graph`]. Ids of different graphs must not be mixed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct NodeId(u32);

impl NodeId {
    pub(crate) fn index(self) -> usize {
        self.0 as usize
    }

    /// Converts the id to its index in the arena.
    pub(crate) fn place(self) -> ValueId {
        self.0
    }

    pub(crate) fn at(place: ValueId) -> Self {
        NodeId(place)
    }
}

/// Operations on one number. Each is defined by the function of the same name in
/// [`calyx_abi::math`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Unary {
    Negate,
    Abs,
    Sqrt,
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Exp,
    Log,
    Floor,
    Ceil,
    Round,
    Not,
}

/// Operations on two numbers. Each is defined by the function of the same name in
/// [`calyx_abi::math`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Binary {
    Add,
    Subtract,
    Multiply,
    Divide,
    Power,
    Atan2,
    Min,
    Max,
    Less,
    LessEqual,
    Equal,
    And,
    Or,
}

impl Unary {
    /// All unary operations, for exhaustive tests.
    pub const ALL: [Unary; 15] = [
        Unary::Negate,
        Unary::Abs,
        Unary::Sqrt,
        Unary::Sin,
        Unary::Cos,
        Unary::Tan,
        Unary::Asin,
        Unary::Acos,
        Unary::Atan,
        Unary::Exp,
        Unary::Log,
        Unary::Floor,
        Unary::Ceil,
        Unary::Round,
        Unary::Not,
    ];
}

impl Binary {
    /// All binary operations, for exhaustive tests.
    pub const ALL: [Binary; 13] = [
        Binary::Add,
        Binary::Subtract,
        Binary::Multiply,
        Binary::Divide,
        Binary::Power,
        Binary::Atan2,
        Binary::Min,
        Binary::Max,
        Binary::Less,
        Binary::LessEqual,
        Binary::Equal,
        Binary::And,
        Binary::Or,
    ];
}

/// An operation and its operands. Truth values are 1.0 and 0.0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Node {
    /// A number, stored as its bits so that nodes can be compared.
    Constant(u64),
    /// Returns an input of the kernel, by index.
    Symbol(u32),
    Unary(Unary, NodeId),
    Binary(Binary, NodeId, NodeId),
    /// The second operand if the first is true, otherwise the third.
    Select(NodeId, NodeId, NodeId),
    /// The value of a table of the graph, by index. See [`Graph::piecewise`].
    Piecewise(u32, NodeId),
    /// The derivative of this order of a registered table, whose number is the first operand, at
    /// the second operand. See [`Graph::lookup`].
    Lookup(u8, NodeId, NodeId),
    /// An unknown of an implicit function: an index of the graph's applied systems, and the index
    /// of the unknown. See [`Graph::solve`].
    Solution(u32, u32),
}

impl Node {
    /// Returns the operands in order, except those of a solution, which only the graph contains;
    /// unused entries are `None`.
    fn own_operands(self) -> [Option<NodeId>; 3] {
        match self {
            Node::Constant(_) | Node::Symbol(_) | Node::Solution(..) => [None; 3],
            Node::Unary(_, a) | Node::Piecewise(_, a) => [Some(a), None, None],
            Node::Binary(_, a, b) | Node::Lookup(_, a, b) => [Some(a), Some(b), None],
            Node::Select(c, a, b) => [Some(c), Some(a), Some(b)],
        }
    }

    /// Returns the instruction that computes this node from the values at `place(operand)`. Those
    /// of solutions and tables have the indices of the graph.
    pub(crate) fn instruction(self, place: impl Fn(NodeId) -> ValueId) -> Instruction {
        use Instruction as I;
        match self {
            Node::Constant(bits) => I::Constant(f64::from_bits(bits)),
            Node::Symbol(index) => I::Input(index),
            Node::Unary(operation, a) => {
                let make = match operation {
                    Unary::Negate => I::Negate,
                    Unary::Abs => I::Abs,
                    Unary::Sqrt => I::Sqrt,
                    Unary::Sin => I::Sin,
                    Unary::Cos => I::Cos,
                    Unary::Tan => I::Tan,
                    Unary::Asin => I::Asin,
                    Unary::Acos => I::Acos,
                    Unary::Atan => I::Atan,
                    Unary::Exp => I::Exp,
                    Unary::Log => I::Log,
                    Unary::Floor => I::Floor,
                    Unary::Ceil => I::Ceil,
                    Unary::Round => I::Round,
                    Unary::Not => I::Not,
                };
                make(place(a))
            }
            Node::Binary(operation, a, b) => {
                let make = match operation {
                    Binary::Add => I::Add,
                    Binary::Subtract => I::Subtract,
                    Binary::Multiply => I::Multiply,
                    Binary::Divide => I::Divide,
                    Binary::Power => I::Power,
                    Binary::Atan2 => I::Atan2,
                    Binary::Min => I::Min,
                    Binary::Max => I::Max,
                    Binary::Less => I::Less,
                    Binary::LessEqual => I::LessEqual,
                    Binary::Equal => I::Equal,
                    Binary::And => I::And,
                    Binary::Or => I::Or,
                };
                make(place(a), place(b))
            }
            Node::Select(c, a, b) => I::Select(place(c), place(a), place(b)),
            Node::Piecewise(table, a) => I::Piecewise(table, place(a)),
            Node::Lookup(order, table, x) => I::Lookup(order, place(table), place(x)),
            Node::Solution(applied, unknown) => I::Solution(applied, unknown),
        }
    }
}

/// An arena of expressions. [`crate::simplify`] documents the functions that build expressions.
#[derive(Clone, Debug, Default)]
pub struct Graph {
    nodes: Vec<Node>,
    ids: HashMap<Node, NodeId>,
    /// The origin mark of each node, and the current mark. See [`Graph::set_origin`].
    origins: Vec<u32>,
    origin: u32,
    /// Cached derivatives: for each node used as a variable, the derivatives of all nodes from it
    /// on.
    pub(crate) derivatives: HashMap<NodeId, Vec<Option<NodeId>>>,
    /// Cached total derivatives, by expression and symbol.
    pub(crate) total_derivatives: HashMap<(NodeId, u32), NodeId>,
    /// Dependent symbols: the derivative of the first symbol with respect to the second.
    pub(crate) rates: HashMap<(u32, u32), NodeId>,
    /// Symbols with respect to which another symbol has a declared derivative.
    pub(crate) moving: HashSet<u32>,
    pub(crate) implicit: Implicit,
    pub(crate) tables: Tables,
}

impl Graph {
    pub fn new() -> Self {
        Self::default()
    }

    /// Returns the number of distinct expressions created so far, including unused ones.
    pub fn len(&self) -> usize {
        self.nodes.len()
    }

    pub fn is_empty(&self) -> bool {
        self.nodes.is_empty()
    }

    pub fn node(&self, id: NodeId) -> Node {
        self.nodes[id.index()]
    }

    /// Returns the operands of a node in order. Those of a solution are the guess of each unknown,
    /// then the arguments of the equations.
    pub fn operands(&self, id: NodeId) -> impl Iterator<Item = NodeId> + '_ {
        let node = self.node(id);
        node.own_operands().into_iter().flatten().chain(self.implicit.operands(node).iter().copied())
    }

    /// Returns the value of a node if it is a constant.
    pub fn constant_value(&self, id: NodeId) -> Option<f64> {
        match self.node(id) {
            Node::Constant(bits) => Some(f64::from_bits(bits)),
            _ => None,
        }
    }

    /// Returns the index of a node's symbol if it is a symbol.
    pub fn symbol_index(&self, id: NodeId) -> Option<u32> {
        match self.node(id) {
            Node::Symbol(index) => Some(index),
            _ => None,
        }
    }

    pub fn constant(&mut self, value: f64) -> NodeId {
        self.intern(Node::Constant(value.to_bits()))
    }

    /// Returns an input of the kernel, by index.
    pub fn symbol(&mut self, index: u32) -> NodeId {
        self.intern(Node::Symbol(index))
    }

    /// Returns the id of a node, without simplification.
    pub(crate) fn intern(&mut self, node: Node) -> NodeId {
        if let Some(&id) = self.ids.get(&node) {
            return id;
        }
        let id = NodeId(self.nodes.len() as u32);
        self.nodes.push(node);
        self.origins.push(self.origin);
        self.ids.insert(node, id);
        id
    }

    /// Sets the origin mark of nodes created from now on, in the caller's own numbering, so that a
    /// NaN can be traced to it ([`Graph::first_nan`]). Returns the previous mark.
    pub fn set_origin(&mut self, origin: u32) -> u32 {
        std::mem::replace(&mut self.origin, origin)
    }

    /// Returns the mark that was set when the node was created.
    pub fn origin(&self, id: NodeId) -> u32 {
        self.origins[id.index()]
    }

    /// Returns every node on which the roots depend, including the roots, for which `wanted`
    /// returns `true`; operands precede their users. The search does not continue past a node that
    /// is not wanted.
    pub fn reachable(&self, roots: &[NodeId], wanted: impl Fn(NodeId) -> bool) -> Vec<NodeId> {
        let mut seen = vec![false; self.nodes.len()];
        let mut found = Vec::new();
        let mut pending: Vec<NodeId> = roots.to_vec();
        while let Some(id) = pending.pop() {
            if !std::mem::replace(&mut seen[id.index()], true) && wanted(id) {
                found.push(id);
                pending.extend(self.operands(id));
            }
        }
        found.sort_unstable();
        found
    }

    /// Returns `true` if any root contains a symbol for which `is_wanted` returns `true`.
    pub fn depends_on(&self, roots: &[NodeId], is_wanted: impl Fn(u32) -> bool) -> bool {
        self.reachable(roots, |_| true)
            .into_iter()
            .any(|id| matches!(self.node(id), Node::Symbol(index) if is_wanted(index)))
    }
}
