//! Formats simplified expressions in the notation of the language. Subexpressions that occur
//! repeatedly are named.

use crate::shown::rounded;
use calyx_abi::newton::Search;
use calyx_lower::kernels::{DefinitionGraph, Shape};
use calyx_symbolic::{Binary, Factor, Node, NodeId, Unary};
use std::collections::HashMap;

/// A subexpression longer than this is named, to limit the length of lines.
const LONGEST: usize = 90;
/// A repeated subexpression longer than this is named.
const WORTH_A_NAME: usize = 20;
/// Limit of the named subexpressions.
const MOST_PARTS: usize = 12;
/// Limit of the operations; larger expressions are not formatted.
const MOST_OPERATIONS: usize = 300;

/// An expression in the notation of the language.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Infix {
    /// The whole expression, in terms of the named parts.
    pub value: String,
    /// Named parts, each in terms of earlier parts.
    pub parts: Vec<(String, String)>,
    /// `true` if it contains computed numbers, which are in SI units and have lost their unit.
    pub bare: bool,
}

/// Precedence of the outermost operation of a text, lowest first.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Binding {
    Choice,
    Or,
    And,
    Comparison,
    Sum,
    Product,
    Sign,
    Power,
    Atom,
}

/// A text with the properties that determine whether it needs brackets.
#[derive(Clone)]
struct InfixText {
    text: String,
    binding: Binding,
}

impl InfixText {
    fn atom(text: impl Into<String>) -> InfixText {
        InfixText { text: text.into(), binding: Binding::Atom }
    }

    /// Returns the text, in brackets if its precedence is lower than `least`.
    fn within(&self, least: Binding) -> String {
        if self.binding >= least { self.text.clone() } else { format!("({})", self.text) }
    }
}

/// Returns the expression as text; `None` if it is too long to read. `literals` maps the bits of a
/// number to its text in the source.
pub(crate) fn infix(definition: &DefinitionGraph, literals: &HashMap<u64, String>) -> Option<Infix> {
    let roots = definition.shape.nodes();
    let nodes = definition.graph.reachable(&roots, |_| true);
    if nodes.len() > MOST_OPERATIONS {
        return None;
    }
    let mut writer = Writer {
        definition,
        literals,
        uses: HashMap::new(),
        powers: HashMap::new(),
        pieces: HashMap::new(),
        out: Infix::default(),
        prefix: prefix(definition),
    };
    writer.count(&nodes, &roots);
    for id in nodes {
        writer.write(id);
        if writer.out.parts.len() > MOST_PARTS {
            return None;
        }
    }
    writer.out.value = writer.shape(&definition.shape)?.text;
    (writer.out.value.len() <= LONGEST * MOST_PARTS).then_some(writer.out)
}

/// Returns the prefix for names of parts: one that no input's name starts with.
fn prefix(definition: &DefinitionGraph) -> &'static str {
    let taken = |prefix: &&str| {
        let numbered = |name: &str| {
            name.strip_prefix(*prefix).is_some_and(|rest| rest.chars().all(|c| c.is_ascii_digit()))
        };
        !definition.inputs.iter().any(|input| numbered(&input.text))
    };
    ["u", "v", "w"].into_iter().find(taken).unwrap_or("part")
}

struct Writer<'a> {
    definition: &'a DefinitionGraph,
    literals: &'a HashMap<u64, String>,
    uses: HashMap<NodeId, usize>,
    /// Repeated products: the base and the exponent.
    powers: HashMap<NodeId, (NodeId, u32)>,
    pieces: HashMap<NodeId, InfixText>,
    out: Infix,
    prefix: &'static str,
}

impl Writer<'_> {
    /// Counts how often each node would be written if no part were named.
    fn count(&mut self, nodes: &[NodeId], roots: &[NodeId]) {
        for root in roots {
            *self.uses.entry(*root).or_default() += 1;
        }
        for id in nodes {
            if let Node::Binary(Binary::Multiply, a, b) = self.definition.graph.node(*id) {
                let power = |id| self.powers.get(&id).copied().unwrap_or((id, 1));
                let ((base, m), (other, n)) = (power(a), power(b));
                if base == other {
                    self.powers.insert(*id, (base, m + n));
                    *self.uses.entry(base).or_default() += 1;
                    continue;
                }
            }
            for operand in self.definition.graph.operands(*id) {
                *self.uses.entry(operand).or_default() += 1;
            }
        }
    }

    fn piece(&self, id: NodeId) -> InfixText {
        self.pieces.get(&id).cloned().unwrap_or_else(|| InfixText::atom("..."))
    }

    fn write(&mut self, id: NodeId) {
        let node = self.definition.graph.node(id);
        let piece = match self.powers.get(&id) {
            Some((base, times)) => InfixText {
                text: format!("{}^{times}", self.piece(*base).within(Binding::Atom)),
                binding: Binding::Power,
            },
            None => self.node(id),
        };
        let leaf = matches!(node, Node::Constant(_) | Node::Symbol(_));
        let uses = self.uses.get(&id).copied().unwrap_or(0);
        let named = !leaf && (piece.text.len() > LONGEST || uses > 1 && piece.text.len() > WORTH_A_NAME);
        let piece = if named {
            let name = format!("{}{}", self.prefix, self.out.parts.len() + 1);
            self.out.parts.push((name.clone(), piece.text));
            InfixText::atom(name)
        } else {
            piece
        };
        self.pieces.insert(id, piece);
    }

    fn node(&mut self, id: NodeId) -> InfixText {
        match self.definition.graph.node(id) {
            Node::Constant(bits) => self.constant(bits),
            Node::Symbol(index) => {
                let input = self.definition.inputs.get(index as usize);
                InfixText::atom(input.map_or("?", |input| input.text.as_str()))
            }
            Node::Unary(operation, a) => self.unary(operation, a),
            Node::Binary(operation, a, b) => self.binary(operation, a, b),
            Node::Select(c, a, b) => {
                let [c, a] = [c, a].map(|id| self.piece(id));
                InfixText {
                    text: format!("if ({}) {} else {}", c.text, a.within(Binding::Or), self.piece(b).text),
                    binding: Binding::Choice,
                }
            }
            Node::Piecewise(_, x) | Node::Lookup(_, _, x) => {
                InfixText::atom(format!("spline({})", self.piece(x).text))
            }
            Node::Solution(_, unknown) => {
                let operands = self.definition.graph.operands(id).map(|operand| self.piece(operand).text);
                let operands: Vec<String> = operands.collect();
                let system = self.definition.graph.system(id);
                let unknowns = system.map_or(1, |system| system.unknowns);
                let function = match system.map(|system| system.search) {
                    Some(Search::Minimum) => "minimize",
                    _ => "solve",
                };
                let element = if unknowns > 1 { format!("[{unknown}]") } else { String::new() };
                InfixText::atom(format!("{function}({}){element}", operands.join(", ")))
            }
        }
    }

    fn constant(&mut self, bits: u64) -> InfixText {
        if let Some(literal) = self.literals.get(&bits) {
            return InfixText::atom(literal);
        }
        let value = f64::from_bits(bits);
        if let Some(literal) = self.literals.get(&(-value).to_bits()) {
            return InfixText { text: format!("-{literal}"), binding: Binding::Sign };
        }
        // Small integers are exponents, orders and counts and have no unit.
        self.out.bare |= value.fract() != 0.0 || value.abs() >= 100.0;
        if value < 0.0 {
            return InfixText { text: rounded(value), binding: Binding::Sign };
        }
        InfixText::atom(rounded(value))
    }

    fn unary(&mut self, operation: Unary, a: NodeId) -> InfixText {
        let inner = self.piece(a);
        let name = match operation {
            Unary::Negate => {
                let text = format!("-{}", inner.within(Binding::Product));
                return InfixText { text, binding: Binding::Sign };
            }
            Unary::Not => {
                let equality = match self.definition.graph.node(a) {
                    Node::Binary(Binary::Equal, x, y) => Some((x, y)),
                    _ => None,
                };
                if let Some((x, y)) = equality {
                    return self.between(x, "!=", y, Binding::Comparison);
                }
                return InfixText {
                    text: format!("!{}", inner.within(Binding::Atom)),
                    binding: Binding::Sign,
                };
            }
            Unary::Abs => "abs",
            Unary::Sqrt => "sqrt",
            Unary::Sin => "sin",
            Unary::Cos => "cos",
            Unary::Tan => "tan",
            Unary::Asin => "asin",
            Unary::Acos => "acos",
            Unary::Atan => "atan",
            Unary::Exp => "exp",
            Unary::Log => "log",
            Unary::Floor => "floor",
            Unary::Ceil => "ceil",
            Unary::Round => "round",
        };
        InfixText::atom(format!("{name}({})", inner.text))
    }

    fn binary(&mut self, operation: Binary, a: NodeId, b: NodeId) -> InfixText {
        let call =
            |name: &str| InfixText::atom(format!("{name}({}, {})", self.piece(a).text, self.piece(b).text));
        match operation {
            Binary::Add => {
                let second = self.piece(b);
                // A negative constant is the second operand.
                if let Some(positive) =
                    second.text.strip_prefix('-').filter(|_| second.binding == Binding::Sign)
                {
                    let text = format!("{} - {positive}", self.piece(a).within(Binding::Sum));
                    return InfixText { text, binding: Binding::Sum };
                }
                self.between(a, "+", b, Binding::Sum)
            }
            Binary::Subtract => self.between(a, "-", b, Binding::Sum),
            Binary::Multiply => self.between(a, "*", b, Binding::Product),
            Binary::Divide => self.between(a, "/", b, Binding::Product),
            Binary::Power => {
                let [a, b] = [self.piece(a).within(Binding::Atom), self.piece(b).within(Binding::Power)];
                InfixText { text: format!("{a}^{b}"), binding: Binding::Power }
            }
            Binary::Less => self.between(a, "<", b, Binding::Comparison),
            Binary::LessEqual => self.between(a, "<=", b, Binding::Comparison),
            Binary::Equal => self.between(a, "==", b, Binding::Comparison),
            Binary::And => self.between(a, "&", b, Binding::And),
            Binary::Or => self.between(a, "|", b, Binding::Or),
            Binary::Atan2 => call("atan2"),
            Binary::Min => call("min"),
            Binary::Max => call("max"),
        }
    }

    /// Formats a binary operation. The right operand needs a higher precedence, unless the
    /// operation is associative.
    fn between(&self, a: NodeId, sign: &str, b: NodeId, binding: Binding) -> InfixText {
        let tighter = match binding {
            Binding::Sum => Binding::Product,
            Binding::Product => Binding::Power,
            Binding::Comparison => Binding::Sum,
            same => same,
        };
        let left = if binding == Binding::Comparison { tighter } else { binding };
        // Sums of sums and products of products need no brackets.
        let right = if matches!(sign, "+" | "*") { binding } else { tighter };
        let text = format!("{} {sign} {}", self.piece(a).within(left), self.piece(b).within(right));
        InfixText { text, binding }
    }

    fn shape(&self, shape: &Shape) -> Option<InfixText> {
        Some(match shape {
            Shape::Number(node) => self.piece(*node),
            Shape::Vector(vector) => self.vector(*vector),
            Shape::Frame(factors) => self.frame(factors)?,
            Shape::Brackets(parts) => {
                let parts: Vec<String> =
                    parts.iter().map(|part| self.shape(part).map(|part| part.text)).collect::<Option<_>>()?;
                InfixText::atom(format!("[{}]", parts.join(", ")))
            }
        })
    }

    /// Formats a vector as a sum over the axes.
    fn vector(&self, vector: [NodeId; 3]) -> InfixText {
        let whole: Vec<String> = vector.iter().map(|id| self.piece(*id).text).collect();
        if let [Some(x), Some(y), Some(z)] =
            [(0, ".x"), (1, ".y"), (2, ".z")].map(|(at, end)| whole[at].strip_suffix(end))
            && x == y
            && y == z
        {
            return InfixText::atom(x);
        }
        let graph = &self.definition.graph;
        let mut text = String::new();
        let mut terms = 0;
        for (id, axis) in vector.into_iter().zip(["e1", "e2", "e3"]) {
            if graph.is_zero(id) {
                continue;
            }
            let term = if graph.is_one(id) {
                axis.to_owned()
            } else {
                format!("{} * {axis}", self.piece(id).within(Binding::Product))
            };
            match (terms, term.strip_prefix('-')) {
                (0, _) => text += &term,
                (_, Some(positive)) => text += &format!(" - {positive}"),
                (_, None) => text += &format!(" + {term}"),
            }
            terms += 1;
        }
        match terms {
            0 => InfixText { text: "0 * e1".into(), binding: Binding::Product },
            1 if !text.contains(' ') => InfixText::atom(text),
            1 => InfixText { text, binding: Binding::Product },
            _ => InfixText { text, binding: Binding::Sum },
        }
    }

    /// Formats a chain of transformations, from right to left starting at ground. Returns `None` if
    /// a factor has no notation.
    fn frame(&self, factors: &[Factor]) -> Option<InfixText> {
        let factor = |factor: &Factor| match factor {
            Factor::Translate(vector) => Some(format!("Translate({})", self.vector(*vector).text)),
            Factor::Rotate { angle, axis } => {
                Some(format!("Rotate({}, {})", self.piece(*angle).text, self.vector(*axis).text))
            }
            // A captured frame is an input of twelve numbers.
            Factor::Rigid { rotation, .. } => {
                let first = self.piece(rotation[0][0]).text;
                first.strip_suffix("[0]").map(str::to_owned)
            }
        };
        let texts: Vec<String> = factors.iter().rev().map(factor).collect::<Option<_>>()?;
        match texts.len() {
            0 => Some(InfixText::atom("Translate(0 * e1)")),
            1 => Some(InfixText::atom(texts.concat())),
            _ => Some(InfixText { text: texts.join(" * "), binding: Binding::Product }),
        }
    }
}
