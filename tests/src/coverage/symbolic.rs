//! Coverage of derivative rules and simplifications of the expression graph.
//!
//! Their tests are in Rust, next to the graph: differences at random points, and random evaluation.
//! The covered rows are read from the names of the cases in the test sources.

use super::{Table, rows};
use crate::root;
use calyx_symbolic::{Binary, Unary};
use std::fs;

rows!(unary(Unary) {
    Unary::Negate => "negate",
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
    Unary::Not => "not",
});

rows!(binary(Binary) {
    Binary::Add => "add",
    Binary::Subtract => "subtract",
    Binary::Multiply => "multiply",
    Binary::Divide => "divide",
    Binary::Power => "power",
    Binary::Atan2 => "atan2",
    Binary::Min => "min",
    Binary::Max => "max",
    Binary::Less => "less",
    Binary::LessEqual => "less or equal",
    Binary::Equal => "equal",
    Binary::And => "and",
    Binary::Or => "or",
});

const DERIVATIVE_TESTS: &str = "compiler/symbolic/tests/derivatives.rs";
const SIMPLIFICATIONS: &str = "compiler/symbolic/src/simplify.rs";
const SIMPLIFICATION_TESTS: &str = "compiler/symbolic/tests/simplification.rs";

/// Returns all operations of the graph, covered by the derivative tests whose names begin with
/// them.
pub fn derivatives() -> Table {
    let rows = [unary::ALL, binary::ALL, &["select"]].concat();
    let mut table = Table::new("Derivative rules", rows.clone());
    let source = read(DERIVATIVE_TESTS);
    for name in named_cases(&source) {
        let operation = name.split(',').next().unwrap_or_default();
        if let Some(row) = rows.iter().copied().find(|row| *row == operation) {
            table.cover([row]);
        }
    }
    table
}

/// Returns all left sides in the table at the head of `simplify.rs`, covered by the case of the
/// same name.
pub fn simplifications() -> Table {
    let rules = simplification_rules();
    let mut table = Table::new("Simplifications", rules.clone());
    let source = read(SIMPLIFICATION_TESTS);
    for line in source.lines() {
        let Some((name, _)) = line.trim().strip_prefix('"').and_then(|rest| rest.split_once("\": |")) else {
            continue;
        };
        let plain = |text: &str| text.replace([' ', '`', '\\'], "");
        if let Some(rule) = rules.iter().find(|rule| plain(rule) == plain(name)) {
            table.cover([rule.as_str()]);
        }
    }
    table
}

/// Returns the first column of the table of rules, one row for each expression in it.
fn simplification_rules() -> Vec<String> {
    let source = read(SIMPLIFICATIONS);
    let rows = source.lines().filter_map(|line| line.strip_prefix("//! | ")).skip(1);
    // A `|` inside a cell is written `\|`.
    let made = rows.filter_map(|row| row.split(" | ").next());
    made.flat_map(outside_code).collect()
}

/// Splits a cell at its commas outside of backquotes.
fn outside_code(cell: &str) -> Vec<String> {
    let mut parts = vec![String::new()];
    let mut in_code = false;
    for c in cell.chars() {
        in_code ^= c == '`';
        match (c, in_code) {
            (',', false) => parts.push(String::new()),
            _ => parts.iter_mut().next_back().into_iter().for_each(|part| part.push(c)),
        }
    }
    parts.iter().map(|part| part.trim().to_owned()).collect()
}

/// Returns the name of each `Case { name: "...", ... }` of a test.
fn named_cases(source: &str) -> Vec<&str> {
    let after = source.lines().filter_map(|line| line.split_once("name: \"")).map(|(_, rest)| rest);
    after.filter_map(|rest| rest.split_once('"')).map(|(name, _)| name).collect()
}

fn read(file: &str) -> String {
    fs::read_to_string(root().join(file)).unwrap_or_else(|error| panic!("{file}: {error}"))
}
