//! Items: the top-level statements of a file, each with its own text.
//!
//! Locations in an item are relative to its start, so edits above an item do not change it.

use crate::ast::{Domain, Expr, ExprKind, FunctionBody, FunctionDecl, Stmt, StmtKind};
use crate::hashed::HashSet;
use crate::relocate;
use crate::span::{FileId, Span};
use smol_str::SmolStr;
use std::sync::Arc;

/// The role of a top-level statement in other checks. Editing its text does not change the role.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum ItemKind {
    /// A function with a body. It is checked on its own unless it uses the model's state.
    Function,
    /// An engine function.
    Extern,
    /// An import, which names a module by its dotted path.
    Import(String),
    /// A declaration without run-time effect, included in every check that uses the name.
    Declaration,
    /// A variable, param or output of the model.
    State,
    /// A statement that runs, or that applies to the whole file.
    Other,
}

#[derive(Debug, PartialEq)]
pub struct Item {
    /// The statement, starting at byte 0 of file 0. Documentation that the program does not need is
    /// removed.
    pub statement: Stmt,
    pub text: String,
    /// Names in the header of a function; for other items, all names.
    pub header_names: HashSet<SmolStr>,
    pub names: HashSet<SmolStr>,
}

/// A statement as an item, with its role and the name it declares.
#[derive(Debug)]
pub struct Split {
    pub kind: ItemKind,
    /// The declared name, or an empty string. For several names, the first; the others, and the
    /// former name of a function or record, are in `more`.
    pub name: String,
    pub more: Vec<String>,
    /// `true` if importers do not see it.
    pub private: bool,
    /// Start in the text from which it was split.
    pub start: u32,
    pub item: Arc<Item>,
}

/// Converts a statement of a text to an item.
pub fn split(mut statement: Stmt, text: &str) -> Split {
    let Span { start, end, .. } = statement.span;
    relocate::to(&mut statement, FileId(0), 0);
    let private = statement.private;
    let (mut header_names, mut names) = (HashSet::default(), HashSet::default());
    let mut more = Vec::new();
    let (kind, name) = match &mut statement.kind {
        StmtKind::Function(decl) => {
            relocate::names(&mut header_names, |visit| relocate::function_header(decl, visit));
            names = header_names.clone();
            relocate::names(&mut names, |visit| relocate::function_body(decl, visit));
            let kind = match decl.body {
                FunctionBody::Extern { .. } => ItemKind::Extern,
                _ => ItemKind::Function,
            };
            more.extend(decl.former.iter().map(|former| former.name.to_string()));
            (kind, decl.name.name.to_string())
        }
        StmtKind::Import(path) => {
            let name = path.name().map(|ident| ident.name.to_string()).unwrap_or_default();
            let path: Vec<&str> = path.iter().map(|ident| ident.name.as_str()).collect();
            (ItemKind::Import(path.join(".")), name)
        }
        StmtKind::Const { name, .. } | StmtKind::Dimension { name, .. } => {
            (ItemKind::Declaration, name.name.to_string())
        }
        StmtKind::Record(decl) => {
            more.extend(decl.former.iter().map(|former| former.name.to_string()));
            (ItemKind::Declaration, decl.name.name.to_string())
        }
        StmtKind::Enum(decl) => (ItemKind::Declaration, decl.name.name.to_string()),
        StmtKind::Unit(decl) => (ItemKind::Declaration, decl.name.name.to_string()),
        StmtKind::Param(decl) => (ItemKind::State, decl.name.name.to_string()),
        StmtKind::Output { name, .. } => (ItemKind::State, name.name.to_string()),
        StmtKind::Var(decls) => {
            let mut all = decls.iter().map(|decl| decl.name.name.to_string());
            let first = all.next().unwrap_or_default();
            more.extend(all);
            (ItemKind::State, first)
        }
        _ => (ItemKind::Other, String::new()),
    };
    if !matches!(kind, ItemKind::Function) {
        relocate::names(&mut names, |visit| relocate::statement(&mut statement, visit));
        header_names = names.clone();
    }
    without_docs(&mut statement);
    let text = text.get(start as usize..end as usize).unwrap_or_default().to_string();
    let item = Arc::new(Item { statement, text, header_names, names });
    Split { kind, name, more, private, start, item }
}

/// Length of the longest symbol or name of a quantity in the documentation of a parameter, such as
/// `pressure_angle`.
const LONGEST_SYMBOL: usize = 14;

/// Returns the symbols in backticks of a parameter's documentation, as `x` or `m_n`: those of its
/// first sentence, a full stop, and the others; `None` if there are none.
fn symbols(doc: &str) -> Option<String> {
    let is_name = |code: &str| code.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
    let in_text = |text: &str| {
        let code = text.split('`').skip(1).step_by(2);
        code.filter(|code| (1..=LONGEST_SYMBOL).contains(&code.len()) && is_name(code))
            .collect::<Vec<_>>()
            .join(" ")
    };
    // A symbol has no full stop.
    let (first, others) = doc.split_once(". ").or(doc.split_once(".\n")).unwrap_or((doc, ""));
    let (first, others) = (in_text(first), in_text(others));
    (!first.is_empty() || !others.is_empty()).then(|| format!("{first}. {others}"))
}

/// Returns the other names of choices in a parameter's documentation, each with its choice. They
/// follow the choice in parentheses: `"left" (LH, L)`.
fn choice_names(doc: &str) -> Vec<(String, String)> {
    let doc = doc.split_whitespace().collect::<Vec<_>>().join(" ");
    let mut names = Vec::new();
    let mut rest = doc.as_str();
    while let Some((before, after)) = rest.split_once("\" (") {
        rest = after;
        if let (Some((_, choice)), Some((listed, _))) = (before.rsplit_once('"'), after.split_once(')')) {
            names.extend(listed.split(", ").map(|name| (name.to_owned(), choice.to_owned())));
        }
    }
    names
}

fn without_docs(statement: &mut Stmt) {
    match &mut statement.kind {
        StmtKind::Function(decl) => {
            // A call with an unknown argument name is compared with the symbols of the parameters.
            for parameter in &mut decl.parameters {
                if let (Some(doc), Some(Domain::Choices { other_names, .. })) =
                    (&parameter.doc, &mut parameter.domain)
                {
                    *other_names = choice_names(doc);
                }
                parameter.doc = parameter.doc.take().and_then(|doc| symbols(&doc));
            }
            // Embedding programs can list symbolic functions and host functions, with their
            // documentation.
            if !matches!(decl.body, FunctionBody::Symbolic(_)) && !decl.is_host {
                statement.doc = None;
            }
        }
        StmtKind::Record(decl) => {
            decl.fields.iter_mut().for_each(|field| field.doc = None);
            statement.doc = None;
        }
        StmtKind::Enum(decl) => {
            decl.choices.iter_mut().for_each(|choice| choice.doc = None);
            statement.doc = None;
        }
        // The program contains the documentation of params and outputs.
        StmtKind::Param(_) | StmtKind::Output { .. } => {}
        _ => statement.doc = None,
    }
}

impl Item {
    /// Returns a function without its body, as other checks see it; other items are returned
    /// unchanged.
    pub fn header(&self) -> Item {
        let none = HashSet::default;
        let whole = || Item {
            statement: self.statement.clone(),
            text: self.text.clone(),
            header_names: none(),
            names: none(),
        };
        let StmtKind::Function(decl) = &self.statement.kind else { return whole() };
        let span = decl.name.span;
        let (body, start) = match &decl.body {
            FunctionBody::Statement(body) => {
                let empty = Stmt { kind: StmtKind::Empty, span, doc: None, private: false };
                (FunctionBody::Statement(Box::new(empty)), body.span.start)
            }
            FunctionBody::Symbolic(e) => {
                (FunctionBody::Symbolic(Expr { kind: ExprKind::Error, span }), e.span.start)
            }
            FunctionBody::Extern { .. } => return whole(),
        };
        let header = FunctionDecl {
            name: decl.name.clone(),
            former: decl.former.clone(),
            parameters: decl.parameters.clone(),
            result: decl.result.clone(),
            body,
            is_test: decl.is_test,
            is_host: decl.is_host,
            is_component: decl.is_component,
        };
        let text = self.text.get(..start as usize).unwrap_or(&self.text).to_string();
        let span = Span::new(self.statement.span.file, 0, text.len());
        let private = self.statement.private;
        let statement = Stmt { kind: StmtKind::Function(header), span, doc: None, private };
        Item { statement, text, header_names: none(), names: none() }
    }
}
