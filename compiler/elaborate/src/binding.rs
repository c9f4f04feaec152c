//! Display form of a `:=` definition: its simplified expression, the symbols it depends on, and its
//! size. It is computed on demand, from the typed program alone.

use crate::infix::{Infix, infix};
use calyx_lang::ir::{Program, SiteId, SymExpr, SymKind, SymbolicFunctionId};
use calyx_lang::span::Span;
use calyx_lower::kernels::{DefinitionId, SymbolKind, definition_expressions, definition_graph};
use calyx_symbolic::Node;
use std::collections::{BTreeSet, HashMap, HashSet};

/// The longest literal, in bytes, that is shown as written.
const LONGEST_LITERAL: usize = 24;
/// The largest expression, in nodes, that is analysed for display.
const MOST_NODES: usize = 20_000;

/// The display form of a `:=` definition.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Binding {
    /// The simplified expression in the notation of the language; `None` if it is too long to read.
    pub expression: Option<Infix>,
    /// The symbols on which the expression depends, with those of the language first. Symbols that
    /// simplification removes are not included.
    pub symbols: Vec<FreeSymbol>,
    /// Number of distinct operations of its value.
    pub operations: usize,
    /// Source range of the definition's expression.
    pub span: Span,
}

/// A symbol that an expression depends on.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct FreeSymbol {
    pub kind: SymbolKind,
    pub name: String,
}

/// Returns the definition within a range of a file, such as the range of a `:=` statement or of an
/// argument: the largest expression there. Returns `None` if there is no definition, or if nothing
/// uses it.
pub fn definition_in(program: &Program, file: u32, start: u32, end: u32) -> Option<DefinitionId> {
    let size = |expr: &SymExpr| {
        let Span { file: of, start: from, end: to } = expr.span;
        (of.0 == file && start <= from && to <= end && from < to).then(|| to - from)
    };
    let mut found: Option<(u32, DefinitionId)> = None;
    let mut offer = |expr: &SymExpr, id: DefinitionId| {
        if let Some(size) = size(expr)
            && found.is_none_or(|(largest, _)| size > largest)
        {
            found = Some((size, id));
        }
    };
    for (index, site) in (0..).zip(&program.sites) {
        offer(&site.expr, DefinitionId::Site(SiteId(index)));
    }
    for (index, function) in (0..).zip(&program.symbolic_functions) {
        offer(&function.body, DefinitionId::Function(SymbolicFunctionId(index)));
    }
    for (index, site) in (0..).zip(&program.sites) {
        for (at, shared) in (0..).zip(&site.shared) {
            offer(shared, DefinitionId::Shared(SiteId(index), at));
        }
    }
    found.map(|(_, id)| id)
}

/// Returns the display form of a definition. Returns `None` if it cannot be written as a formula;
/// checking reports the reason.
pub fn binding(program: &Program, id: DefinitionId) -> Option<Binding> {
    let (expr, _) = definition_expressions(program, id)?;
    let literals = literals(program, id)?;
    let definition = definition_graph(program, id).ok()?;
    let nodes = definition.graph.reachable(&definition.shape.nodes(), |_| true);
    let (mut symbols, mut operations) = (BTreeSet::new(), 0);
    for id in nodes {
        match definition.graph.node(id) {
            Node::Constant(_) => {}
            Node::Symbol(index) => {
                if let Some(input) = definition.inputs.get(index as usize) {
                    symbols.insert(FreeSymbol { kind: input.kind, name: input.name.clone() });
                }
            }
            Node::Unary(..)
            | Node::Binary(..)
            | Node::Select(..)
            | Node::Piecewise(..)
            | Node::Lookup(..)
            | Node::Solution(..) => operations += 1,
        }
    }
    Some(Binding {
        expression: infix(&definition, &literals),
        symbols: symbols.into_iter().collect(),
        operations,
        span: expr.span,
    })
}

/// Returns the constants of a definition as the source writes them (`3 rpm`, or the name of a
/// `const`), by the bits of their number. Returns `None` if the definition is too large.
fn literals(program: &Program, id: DefinitionId) -> Option<HashMap<u64, String>> {
    let mut literals: HashMap<u64, Option<&str>> = HashMap::new();
    let (mut functions, mut seen) = (HashSet::new(), 0);
    let (expr, shared) = definition_expressions(program, id)?;
    let mut pending: Vec<&SymExpr> = shared.iter().chain([expr]).collect();
    while let Some(expr) = pending.pop() {
        seen += 1;
        if seen > MOST_NODES {
            return None;
        }
        match &expr.kind {
            SymKind::Number(value) => {
                if let Some(text) = literal(program, expr.span) {
                    let known = literals.entry(value.to_bits()).or_insert(Some(text));
                    if *known != Some(text) {
                        // Two constants with the same number may have different dimensions, so
                        // neither text is used.
                        *known = None;
                    }
                }
            }
            SymKind::Call(function, _) | SymKind::Solve(_, function, _) if functions.insert(*function) => {
                let (body, shared) = definition_expressions(program, DefinitionId::Function(*function))?;
                pending.extend(shared.iter().chain([body]));
            }
            _ => {}
        }
        pending.extend(expr.operands());
    }
    // Differentiation and simplification introduce these constants.
    let of_algebra = [0.0, 1.0, 2.0, -1.0].map(f64::to_bits);
    let sure = literals.into_iter().filter(|(bits, _)| !of_algebra.contains(bits));
    Some(sure.filter_map(|(bits, text)| Some((bits, text?.to_owned()))).collect())
}

/// Returns the source text of a number if it is a literal or a name.
fn literal(program: &Program, span: Span) -> Option<&str> {
    let file = program.files.get(span.file.0 as usize)?;
    let text = file.text.get(span.start as usize..span.end as usize)?.trim();
    let of_words = |c: char| c.is_alphanumeric() || matches!(c, '.' | ' ' | '_' | '^');
    (!text.is_empty() && text.len() <= LONGEST_LITERAL && text.chars().all(of_words)).then_some(text)
}
