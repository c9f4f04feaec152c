//! The value of a symbolic expression, as graph nodes.

use calyx_symbolic::{Frame, Graph, NodeId, Vector3};

#[derive(Clone, Debug)]
pub(super) enum Value {
    /// A number or a truth value.
    Number(NodeId),
    Vector(Vector3),
    Frame(Frame),
    Brackets(Vec<Value>),
}

impl Value {
    pub(super) fn map(&self, replace: &mut dyn FnMut(NodeId) -> NodeId) -> Value {
        match self {
            Value::Number(number) => Value::Number(replace(*number)),
            Value::Vector(vector) => Value::Vector(vector.map(replace)),
            Value::Frame(frame) => Value::Frame(frame.map(replace)),
            Value::Brackets(parts) => Value::Brackets(parts.iter().map(|part| part.map(replace)).collect()),
        }
    }

    pub(super) fn for_each(&self, mut visit: impl FnMut(NodeId)) {
        self.map(&mut |node| {
            visit(node);
            node
        });
    }

    /// Visits the components of everything except frames.
    pub(super) fn for_each_number(&self, visit: &mut dyn FnMut(NodeId)) {
        match self {
            Value::Number(number) => visit(*number),
            Value::Vector(vector) => vector.iter().for_each(|component| visit(*component)),
            Value::Frame(_) => {}
            Value::Brackets(parts) => parts.iter().for_each(|part| part.for_each_number(visit)),
        }
    }

    /// Collects the frames.
    pub(super) fn frames(&self, found: &mut Vec<Frame>) {
        match self {
            Value::Number(_) | Value::Vector(_) => {}
            Value::Frame(frame) => found.push(frame.clone()),
            Value::Brackets(parts) => parts.iter().for_each(|part| part.frames(found)),
        }
    }

    /// Returns the value with all given symbols replaced simultaneously.
    pub(super) fn substituted(&self, graph: &mut Graph, replacements: &[(u32, NodeId)]) -> Value {
        let mut nodes = Vec::new();
        self.for_each(|node| nodes.push(node));
        let mut replaced = graph.substitute_all(&nodes, replacements).into_iter();
        // `map` visits the nodes in the order of `for_each`.
        self.map(&mut |node| replaced.next().unwrap_or(node))
    }

    /// Returns the components: 1 or 3 numbers, or the 12 of a frame's pose; the elements of
    /// brackets one after the other.
    pub(super) fn flat(&self, graph: &mut Graph) -> Vec<NodeId> {
        match self {
            Value::Number(number) => vec![*number],
            Value::Vector(vector) => vector.to_vec(),
            Value::Frame(frame) => frame.pose(graph).to_vec(),
            Value::Brackets(parts) => parts.iter().flat_map(|part| part.flat(graph)).collect(),
        }
    }
}
