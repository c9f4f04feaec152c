//! What a `:=` name stands for, for people: its simplified expression, the symbols it is free in, its size. Computed when
//! somebody asks, from the typed program alone.

use crate::infix::{Infix, infix};
use calyx_lang::ir::{Program, SiteId, SymExpr, SymKind, SymbolicFunctionId};
use calyx_lang::span::Span;
use calyx_lower::kernels::{DefinitionId, SymbolKind, definition_expressions, definition_graph};
use calyx_symbolic::Node;
use std::collections::{BTreeSet, HashMap, HashSet};

/// Source of a literal longer than this is not shown in its place.
const LONGEST_LITERAL: usize = 24;
/// Expressions larger than this are not looked at: nobody waits for them, and nobody reads them.
const MOST_NODES: usize = 20_000;

/// What a `:=` name stands for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Binding {
    /// In the notation of the language, simplified; `None` if it is too long to be read.
    pub expression: Option<Infix>,
    /// The symbols it depends on, those of the language first. What it does not depend on any more after simplification
    /// is not among them.
    pub symbols: Vec<FreeSymbol>,
    /// Distinct operations of its value.
    pub operations: usize,
    /// Of the definition's expression.
    pub span: Span,
}

/// A symbol that an expression depends on.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct FreeSymbol {
    pub kind: SymbolKind,
    pub name: String,
}

/// The definition written within a range of a file, such as that of a `:=` statement or of an argument: the largest
/// expression there. `None` if there is none, or if nothing uses it.
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

/// What a definition stands for. `None` if it cannot be made a formula; checking says why.
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
            Node::Unary(..) | Node::Binary(..) | Node::Select(..) => operations += 1,
        }
    }
    Some(Binding {
        expression: infix(&definition, &literals),
        symbols: symbols.into_iter().collect(),
        operations,
        span: expr.span,
    })
}

/// Constants of a definition as the source writes them (`3 rpm`, or the name of a `const`), by the bits of their number.
/// `None` if the definition is too large to be looked at.
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
                        // Two of one number but perhaps of different dimensions: which of them this is, nobody knows.
                        *known = None;
                    }
                }
            }
            SymKind::Call(function, _) if functions.insert(*function) => {
                let (body, shared) = definition_expressions(program, DefinitionId::Function(*function))?;
                pending.extend(shared.iter().chain([body]));
            }
            _ => {}
        }
        pending.extend(expr.operands());
    }
    // Derivatives and rules of simplification bring in these.
    let of_algebra = [0.0, 1.0, 2.0, -1.0].map(f64::to_bits);
    let sure = literals.into_iter().filter(|(bits, _)| !of_algebra.contains(bits));
    Some(sure.filter_map(|(bits, text)| Some((bits, text?.to_owned()))).collect())
}

/// The source of a number, if it is a literal or a name.
fn literal(program: &Program, span: Span) -> Option<&str> {
    let file = program.files.get(span.file.0 as usize)?;
    let text = file.text.get(span.start as usize..span.end as usize)?.trim();
    let of_words = |c: char| c.is_alphanumeric() || matches!(c, '.' | ' ' | '_' | '^');
    (!text.is_empty() && text.len() <= LONGEST_LITERAL && text.chars().all(of_words)).then_some(text)
}
