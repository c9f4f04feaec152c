//! Inlay hints: types, parameter names, units of bare numbers, and results.

use super::Snapshot;
use super::formatting::Change;
use super::source::Source;
use calyx_lang::analysis::{Callable, Name, SourceRange};
use calyx_lang::ast::*;
use calyx_lang::units::UnitSystem;
use calyx_lang::walk::Node;
use std::collections::HashMap;
use std::ops::Range;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HintKind {
    Type,
    Parameter,
    /// Unit of a number without one.
    Unit,
    /// Result of the last run.
    Result,
}

#[derive(Clone, Debug, PartialEq)]
pub struct Hint {
    /// The hint is before this byte.
    pub offset: u32,
    pub label: String,
    pub kind: HintKind,
    /// Declaration that the label refers to.
    pub declared: Option<SourceRange>,
    /// Edit that inserts the hint into the text.
    pub change: Option<Change>,
    pub tooltip: Option<String>,
}

/// Enabled kinds of hints.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct HintSettings {
    pub types: bool,
    pub parameters: bool,
    pub units: bool,
    pub results: bool,
}

impl Default for HintSettings {
    fn default() -> HintSettings {
        HintSettings { types: true, parameters: true, units: true, results: true }
    }
}

/// Results of the last run of a model.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Results {
    pub outputs: HashMap<String, OutputResult>,
    /// True if the model has changed since.
    pub outdated: bool,
}

/// Summary of an output.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct OutputResult {
    /// `12.5 .. 14.1 MPa`
    pub shown: String,
    /// Details in Markdown.
    pub details: Option<String>,
}

/// Returns the hints in a range, sorted by position.
pub fn hints(
    snapshot: &Snapshot,
    source: &Source<'_>,
    file: &str,
    range: Range<u32>,
    wanted: HintSettings,
    results: &Results,
) -> Vec<Hint> {
    let statements = &source.tree.module.statements;
    let first = statements.partition_point(|statement| statement.span.end < range.start);
    let touched = statements.iter().skip(first).take_while(|statement| statement.span.start <= range.end);
    let names = snapshot.database.names_in(file, range.clone());
    let mut hints = Hints {
        snapshot,
        source,
        names: &names,
        wanted,
        results,
        bare: HashMap::new(),
        callables: HashMap::new(),
        found: Vec::new(),
    };
    if wanted.units || wanted.types {
        hints.find_bare(file, &range);
    }
    for statement in touched {
        Node::Statement(statement).walk(&mut |node| hints.node(node));
    }
    let mut found = hints.found;
    found.retain(|hint| range.start <= hint.offset && hint.offset <= range.end);
    found.sort_by_key(|hint| hint.offset);
    found
}

struct Hints<'a> {
    snapshot: &'a Snapshot,
    source: &'a Source<'a>,
    /// Sorted by position.
    names: &'a [Name],
    wanted: HintSettings,
    results: &'a Results,
    /// Numbers in the unit of the file: start, end and unit.
    bare: HashMap<u32, (u32, String)>,
    callables: HashMap<SourceRange, Option<Callable>>,
    found: Vec<Hint>,
}

impl<'a> Hints<'a> {
    fn name_at(&self, start: u32) -> Option<&'a Name> {
        let at = self.names.binary_search_by_key(&start, |name| name.start).ok()?;
        self.names.get(at)
    }

    /// Finds numbers without units that have a dimension.
    fn find_bare(&mut self, file: &str, range: &Range<u32>) {
        let system = self.source.tree.module.statements.iter().find_map(|statement| match &statement.kind {
            StmtKind::Units(name) => UnitSystem::from_name(&name.name),
            _ => None,
        });
        let Some(system) = system else { return };
        for typed in self.snapshot.database.expressions(file, range.clone()) {
            let dimension = typed.dimension.filter(|dimension| typed.bare && !dimension.is_none());
            let Some(dimension) = dimension.filter(|dimension| *dimension == dimension.without_own()) else {
                continue;
            };
            let unit = system.unit_of(dimension).name;
            let plain = self.source.slice(typed.start, typed.end).parse::<f64>();
            // Zero is the same in all units.
            if !unit.is_empty() && plain.is_ok_and(|value| value != 0.0) {
                self.bare.insert(typed.start, (typed.end, unit));
            }
        }
    }

    fn node(&mut self, node: Node<'_>) {
        match node {
            Node::Statement(Stmt { kind: StmtKind::Output { name, .. }, span, .. }) => {
                self.declared_type(name, None);
                self.result(name, span.end);
            }
            Node::Statement(Stmt { kind: StmtKind::Const { name, value }, .. }) => {
                self.declared_type(name, Some(value));
            }
            Node::Variable(VarDecl { name, init: Some((_, value)) }) => self.declared_type(name, Some(value)),
            Node::Parameter(parameter) if parameter.annotation.is_none() => {
                let value = parameter.default.as_ref().and_then(|(_, value)| value.as_ref());
                self.declared_type(&parameter.name, value);
            }
            Node::Expression(Expr { kind: ExprKind::Call { callee, arguments }, .. }) => {
                self.parameters(callee, arguments);
            }
            Node::Expression(Expr { kind: ExprKind::Number(_), span }) => self.unit(span.start),
            _ => {}
        }
    }

    /// Adds the type of a name if its value does not show it.
    fn declared_type(&mut self, name: &Ident, value: Option<&Expr>) {
        let Some(known) = self.name_at(name.span.start).filter(|_| self.wanted.types) else { return };
        let Some(ty) = known.ty.as_ref().filter(|ty| is_known(ty)) else { return };
        if value.is_some_and(|value| self.shows_type(value, ty)) || alike(&name.name, ty) {
            return;
        }
        self.found.push(Hint {
            offset: name.span.end,
            label: format!(": {ty}"),
            kind: HintKind::Type,
            declared: None,
            change: None,
            tooltip: None,
        });
    }

    /// Returns true if a value shows its type.
    fn shows_type(&self, value: &Expr, ty: &str) -> bool {
        match &value.kind {
            ExprKind::Number(_) => ty == "Number" || self.bare.contains_key(&value.span.start),
            ExprKind::Quantity { .. } | ExprKind::Bool(_) | ExprKind::String(_) => true,
            ExprKind::Unary { operand: inner, .. } | ExprKind::Paren(inner) => self.shows_type(inner, ty),
            ExprKind::Binary { op, .. } => op.compares() || matches!(op, BinaryOp::And | BinaryOp::Or),
            ExprKind::List(items) => {
                match ty.strip_prefix("Array(").and_then(|rest| rest.strip_suffix(')')) {
                    Some(element) => items.first().is_some_and(|first| self.shows_type(first, element)),
                    None => false,
                }
            }
            // `gears.rack(...)` is a Rack.
            ExprKind::Call { callee, .. } => match &callee.kind {
                ExprKind::Name(name) | ExprKind::Field { field: name, .. } => alike(&name.name, ty),
                _ => false,
            },
            // A name similar to the type, which shows it equally well.
            ExprKind::Error => true,
            _ => false,
        }
    }

    /// Adds the names of parameters before positional arguments.
    fn parameters(&mut self, callee: &Expr, arguments: &[Argument]) {
        if !self.wanted.parameters || arguments.iter().all(|argument| argument.name.is_some()) {
            return;
        }
        let name = match &callee.kind {
            ExprKind::Name(name) | ExprKind::Field { field: name, .. } => name,
            _ => return,
        };
        // Builtin functions are known, and functions with one parameter are clear by name.
        let Some(place) = self.name_at(name.span.start).and_then(|name| name.declared.clone()) else {
            return;
        };
        let database = &self.snapshot.database;
        let callable = self.callables.entry(place.clone()).or_insert_with(|| database.callable(&place));
        let Some(callable) = callable.as_ref().filter(|callable| callable.parameters.len() > 1) else {
            return;
        };
        let places = arguments.iter().take_while(|argument| argument.name.is_none() && !argument.spread);
        for (argument, parameter) in places.zip(&callable.parameters) {
            let long = parameter.name.chars().count() > 1;
            if !long
                || matches!(argument.value.kind, ExprKind::Error)
                || says(&argument.value, &parameter.name)
            {
                continue;
            }
            self.found.push(Hint {
                offset: argument.value.span.start,
                label: format!("{}:", parameter.name),
                kind: HintKind::Parameter,
                declared: parameter.declared.clone(),
                change: None,
                tooltip: parameter.doc.clone(),
            });
        }
    }

    fn unit(&mut self, start: u32) {
        let Some((end, unit)) = self.bare.get(&start).filter(|_| self.wanted.units) else { return };
        let shown = unit.clone();
        self.found.push(Hint {
            offset: *end,
            label: shown.clone(),
            kind: HintKind::Unit,
            declared: None,
            change: simple(&shown).then(|| Change {
                start: *end,
                end: *end,
                replacement: format!(" {shown}"),
            }),
            tooltip: Some("from `units` at the top of the file".to_string()),
        });
    }

    fn result(&mut self, name: &Ident, end: u32) {
        let Some(result) = self.results.outputs.get(name.name.as_str()).filter(|_| self.wanted.results)
        else {
            return;
        };
        let when = if self.results.outdated { "was " } else { "" };
        let details = result.details.clone();
        let outdated = self.results.outdated.then(|| "The model has changed since this run.".to_string());
        let tooltip: Vec<String> = details.into_iter().chain(outdated).collect();
        self.found.push(Hint {
            offset: end,
            label: format!("{when}{}", result.shown),
            kind: HintKind::Result,
            declared: None,
            change: None,
            tooltip: (!tooltip.is_empty()).then(|| tooltip.join("\n\n")),
        });
    }
}

/// Returns true if a unit can be written after a number.
fn simple(unit: &str) -> bool {
    unit.split_once('^').map_or(unit, |(name, _)| name).chars().all(char::is_alphanumeric)
}

/// Returns true if a type is known; `_` is an unknown type.
fn is_known(ty: &str) -> bool {
    let mut words = ty.split(|c: char| !c.is_alphanumeric() && c != '_');
    !ty.is_empty() && words.all(|word| word != "_")
}

/// Returns true if a name shows the type: `rack` and `Rack`.
fn alike(name: &str, ty: &str) -> bool {
    let folded = |text: &str| text.replace('_', "").to_lowercase();
    let ty = ty.rsplit('.').next().unwrap_or(ty);
    folded(name) == folded(ty)
}

/// Returns true if an argument shows its parameter: `center_distance` for `distance`.
fn says(value: &Expr, parameter: &str) -> bool {
    let name = match &value.kind {
        ExprKind::Name(name) | ExprKind::Field { field: name, .. } => name,
        ExprKind::Call { callee, .. } => return says(callee, parameter),
        ExprKind::Unary { operand: inner, .. }
        | ExprKind::Paren(inner)
        | ExprKind::Index { base: inner, .. } => {
            return says(inner, parameter);
        }
        _ => return false,
    };
    let (name, parameter) = (name.name.to_lowercase(), parameter.to_lowercase());
    let words = |text: &str| text.split('_').map(str::to_string).collect::<Vec<_>>();
    let holds = |all: &[String], part: &[String]| all.starts_with(part) || all.ends_with(part);
    let (name, parameter) = (words(&name), words(&parameter));
    holds(&name, &parameter) || holds(&parameter, &name)
}
