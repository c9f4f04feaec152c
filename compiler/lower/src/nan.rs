//! Description of a NaN: the expression and the operation that produced it.

use calyx_abi::newton::Search;
use calyx_abi::text::number;
use calyx_lang::ir::Op;
use calyx_lang::span::Span;
use calyx_symbolic::{Binary, FailedSearch, FirstNan, Node, Unary};

/// The origin of a NaN.
#[derive(Clone, Debug, PartialEq)]
pub struct NanSource {
    /// The expression that produced the NaN.
    pub span: Span,
    /// The operation and its operands in SI units, like `sqrt(-3)`; `None` if the NaN is a literal
    /// or an input.
    pub made_by: Option<String>,
    /// The NaN input of the kernel, if the NaN is an input.
    pub input: Option<u32>,
    /// The function of a `solve` or `minimize` that found nothing.
    pub equation: Option<String>,
}

/// Returns the text of a program operation with the values of its operands.
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

/// Returns the text of the graph operation that produced a NaN, with the values of its operands;
/// `None` for constants and inputs.
pub fn node_text(found: &FirstNan) -> Option<String> {
    let operands = found.operands.as_slice();
    let name = match found.node {
        Node::Constant(_) | Node::Symbol(_) => return None,
        Node::Unary(Unary::Negate, _) | Node::Binary(Binary::Subtract, ..) => "-".to_owned(),
        Node::Unary(operation, _) => format!("{operation:?}").to_lowercase(),
        Node::Binary(Binary::Add, ..) => "+".into(),
        Node::Binary(Binary::Multiply, ..) => "*".into(),
        Node::Binary(Binary::Divide, ..) => "/".into(),
        Node::Binary(Binary::Power, ..) => "^".into(),
        Node::Binary(operation, ..) => format!("{operation:?}").to_lowercase(),
        Node::Select(..) => "if".into(),
        Node::Piecewise(..) | Node::Lookup(..) => "spline".into(),
        Node::Solution(..) => return found.search.as_ref().map(failed_search),
    };
    Some(text(&name, operands))
}

/// Describes a search that failed: its guess, and the last point with its residuals.
fn failed_search(found: &FailedSearch) -> String {
    let (point, values) = match found.search {
        Search::Root if found.residuals.len() == 1 => ("solution", "residual is"),
        Search::Root => ("solution", "residuals are"),
        Search::Minimum => ("minimum", "gradient is"),
    };
    format!(
        "no {point} was found from the guess {}; the search ended at {}, where the {values} {} (SI units)",
        rounded(&found.guess),
        rounded(&found.reached),
        rounded(&found.residuals),
    )
}

/// Writes a number, or several in brackets, with five significant digits.
fn rounded(values: &[f64]) -> String {
    let all: Vec<String> =
        values.iter().map(|value| number(format!("{value:.4e}").parse().unwrap_or(*value))).collect();
    match all.as_slice() {
        [one] => one.clone(),
        all => format!("[{}]", all.join(", ")),
    }
}

/// Writes operators between their operands and function names before them.
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
