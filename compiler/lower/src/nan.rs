//! What is said about a NaN: where it arose, and of what.

use calyx_abi::text::number;
use calyx_lang::ir::Op;
use calyx_lang::span::Span;
use calyx_symbolic::{Binary, Node, Unary};

/// Where a NaN came from.
#[derive(Clone, Debug, PartialEq)]
pub struct NanSource {
    /// The expression in which it arose.
    pub span: Span,
    /// The operation and its operands in SI, like `sqrt(-3)`; `None` if a NaN was written or came in from outside.
    pub made_by: Option<String>,
    /// The kernel's input that was NaN, if it came in from outside.
    pub input: Option<u32>,
}

/// An operation of a program with its operands' values.
pub fn operation_text(op: Op, operands: &[f64]) -> String {
    let name = match op {
        Op::Add | Op::AddVector => "+",
        Op::Subtract | Op::SubtractVector => "-",
        Op::Multiply | Op::Scale => "*",
        Op::Divide => "/",
        Op::Power => "^",
        other => return call_text(&format!("{other:?}").to_lowercase(), operands),
    };
    text(name, operands)
}

/// An operation of a graph with its operands' values; `None` for constants and inputs.
pub fn node_text(node: Node, operands: &[f64]) -> Option<String> {
    let name = match node {
        Node::Constant(_) | Node::Symbol(_) => return None,
        Node::Unary(Unary::Negate, _) | Node::Binary(Binary::Subtract, ..) => "-".to_owned(),
        Node::Unary(operation, _) => format!("{operation:?}").to_lowercase(),
        Node::Binary(Binary::Add, ..) => "+".into(),
        Node::Binary(Binary::Multiply, ..) => "*".into(),
        Node::Binary(Binary::Divide, ..) => "/".into(),
        Node::Binary(Binary::Power, ..) => "^".into(),
        Node::Binary(operation, ..) => format!("{operation:?}").to_lowercase(),
        Node::Select(..) => "if".into(),
    };
    Some(text(&name, operands))
}

/// Signs between their operands, words before them.
fn text(name: &str, operands: &[f64]) -> String {
    match operands {
        [a, b] if !name.starts_with(char::is_alphabetic) => format!("{} {name} {}", number(*a), number(*b)),
        _ => call_text(name, operands),
    }
}

fn call_text(name: &str, operands: &[f64]) -> String {
    let operands: Vec<String> = operands.iter().map(|operand| number(*operand)).collect();
    format!("{name}({})", operands.join(", "))
}
