//! Extraction of a page's content from a syntax tree.

use calyx_lang::ast::*;
use calyx_lang::dimension::{Dimension, Rational};
use calyx_lang::ir::{Param, SourceFile};
use calyx_lang::parser::parse;
use calyx_lang::span::{FileId, Span};
use calyx_lang::units::UnitSystem;
use std::collections::BTreeMap;

/// Documented module or model.
#[derive(Clone, Debug, Default)]
pub struct Page {
    pub name: String,
    pub doc: String,
    /// True for a library module, false for a user's file.
    pub library: bool,
    /// Entries in source order.
    pub entries: Vec<Entry>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    Param,
    Output,
    Function,
    Constant,
    /// Its fields are its parameters, params and outputs.
    Component,
    Record,
    Enumeration,
    Dimension,
    Unit,
}

/// Documented declaration.
#[derive(Clone, Debug)]
pub struct Entry {
    pub kind: Kind,
    pub name: String,
    /// Former name, which is deprecated.
    pub former: Option<String>,
    pub doc: String,
    /// Usage: a call or a declaration.
    pub signature: String,
    /// Result type of a function, as written.
    pub result: Option<Type>,
    /// Parameters of a function, fields of a record; for a param the param itself.
    pub fields: Vec<Field>,
    /// Side effect of an engine function, in words; empty for others.
    pub effect: &'static str,
}

/// Parameter, field, choice or param.
#[derive(Clone, Debug, Default)]
pub struct Field {
    pub name: String,
    /// Former name, which is deprecated.
    pub former: Option<String>,
    /// `in`, `out` or `inout` for parameters, `param` or `output` for those of components, empty
    /// for others.
    pub mode: &'static str,
    pub doc: String,
    pub ty: Option<Type>,
    pub default: Option<String>,
    /// Allowed values, in words.
    pub domain: String,
    /// True if the field accepts an expression, with `:=`.
    pub symbolic: bool,
}

/// Type as written.
#[derive(Clone, Debug)]
pub struct Type {
    pub text: String,
    /// Unit of its numbers in each system, if they have one: `mm`, `inch`.
    pub units: Vec<String>,
    /// Names of types in it that are not dimensions: handles and records.
    pub names: Vec<String>,
}

/// Extracts the page of a text. `types` are the inferred types of a model's params and outputs, as
/// shown to users.
pub fn page(name: &str, text: &str, library: bool, types: &BTreeMap<String, String>) -> Page {
    let (module, _) = parse(FileId(0), text);
    let reader = Reader { text, types };
    let first_doc = module.statements.first().and_then(|statement| match statement.kind {
        StmtKind::Import(_) | StmtKind::Units(_) => statement.doc.clone(),
        _ => None,
    });
    Page {
        name: name.to_owned(),
        doc: module.doc.clone().or(first_doc).unwrap_or_default(),
        library,
        entries: module
            .statements
            .iter()
            .filter(|s| !s.private)
            .filter_map(|s| reader.entry(s, name, library))
            .collect(),
    }
}

/// Returns the params of component instances, such as `low.torque`, among the `params` of a model
/// whose sources are `files`. The declaration in the component has their defaults and ranges.
pub fn instance_params(params: &[Param], files: &[SourceFile]) -> Vec<Entry> {
    let types = BTreeMap::new();
    let mut parsed = BTreeMap::new();
    let instances = params.iter().filter(|param| param.name.contains('.'));
    let entry = |param: &Param| {
        let file = param.span.file;
        let text = &files.get(file.0 as usize)?.text;
        let module = parsed.entry(file.0).or_insert_with(|| parse(file, text).0);
        let components = module.statements.iter().flat_map(members);
        let declared = components.filter_map(|member| match &member.kind {
            StmtKind::Param(decl) => Some(decl),
            _ => None,
        });
        let decl = declared.into_iter().find(|decl| decl.name.span.start == param.span.start)?;
        let reader = Reader { text, types: &types };
        let field = Field {
            name: param.name.clone(),
            default: Some(reader.slice(decl.default.span)),
            domain: reader.domain(&decl.domain),
            ..Field::default()
        };
        Some(Entry {
            kind: Kind::Param,
            name: param.name.clone(),
            former: None,
            doc: param.doc.clone(),
            signature: format!("--set \"{}={}\"", param.name, reader.given(&decl.default)),
            result: None,
            fields: vec![field],
            effect: "",
        })
    };
    instances.filter_map(entry).collect()
}

/// Returns the statements of a component's body; nothing for other statements.
fn members(statement: &Stmt) -> &[Stmt] {
    let StmtKind::Function(component) = &statement.kind else { return &[] };
    match &component.body {
        FunctionBody::Statement(body) if component.is_component => match &body.kind {
            StmtKind::Block(statements) => statements,
            _ => &[],
        },
        _ => &[],
    }
}

fn is_literal(e: &Expr) -> bool {
    matches!(
        e.kind,
        ExprKind::Number(_) | ExprKind::Quantity { .. } | ExprKind::Bool(_) | ExprKind::Measured { .. }
    )
}

struct Reader<'t> {
    text: &'t str,
    types: &'t BTreeMap<String, String>,
}

impl Reader<'_> {
    fn inferred(&self, name: &Ident) -> Option<Type> {
        let text = self.types.get(name.name.as_str())?.clone();
        // An output is an observable or a number over time: show its dimension.
        let inner =
            text.strip_prefix("Observable(").and_then(|inner| inner.strip_suffix(')')).unwrap_or(&text);
        let units = Dimension::from_name(inner).map(units).unwrap_or_default();
        Some(Type { text: inner.to_owned(), units, names: Vec::new() })
    }

    /// Returns a default as a value on a command line; `...` if it is computed.
    fn given(&self, default: &Expr) -> String {
        match &default.kind {
            ExprKind::Paren(inner) => self.given(inner),
            ExprKind::String(parts) => match parts.as_slice() {
                [] => String::new(),
                [StringPart::Text(text)] => text.clone(),
                _ => "...".into(),
            },
            // A choice of an enumeration.
            ExprKind::Field { field, .. } => field.name.to_string(),
            ExprKind::Unary { operand, .. } if is_literal(operand) => self.slice(default.span),
            ExprKind::List(elements) if elements.iter().all(is_literal) => self.slice(default.span),
            _ if is_literal(default) => self.slice(default.span),
            _ => "...".into(),
        }
    }

    fn entry(&self, statement: &Stmt, module: &str, library: bool) -> Option<Entry> {
        let entry = |kind, name: &Ident, signature: String| Entry {
            kind,
            name: name.name.to_string(),
            former: former(statement).map(|former| former.name.to_string()),
            doc: statement.doc.clone().unwrap_or_default(),
            signature,
            result: None,
            fields: Vec::new(),
            effect: "",
        };
        Some(match &statement.kind {
            StmtKind::Param(param) => {
                let default = self.slice(param.default.span);
                let field = Field {
                    name: param.name.name.to_string(),
                    former: None,
                    mode: "",
                    doc: String::new(),
                    ty: self.inferred(&param.name),
                    default: Some(default.clone()),
                    domain: self.domain(&param.domain),
                    symbolic: false,
                };
                let signature = format!("--set \"{}={}\"", param.name.name, self.given(&param.default));
                Entry { fields: vec![field], ..entry(Kind::Param, &param.name, signature) }
            }
            StmtKind::Output { name, value, .. } => {
                Entry { result: self.inferred(name), ..entry(Kind::Output, name, self.slice(value.span)) }
            }
            StmtKind::Const { name, value } => entry(Kind::Constant, name, self.slice(value.span)),
            StmtKind::Dimension { name, value } => {
                let written = value.as_ref().map(|value| self.slice(value.span)).unwrap_or_default();
                entry(Kind::Dimension, name, written)
            }
            StmtKind::Unit(unit) => {
                let written = match &unit.meaning {
                    UnitMeaning::Coherent(ty) => self.slice(ty.span),
                    UnitMeaning::Equal(value) => self.slice(value.span),
                };
                entry(Kind::Unit, &unit.name, written)
            }
            StmtKind::Enum(decl) => {
                let fields = decl.choices.iter().map(|choice| Field {
                    name: choice.name.name.to_string(),
                    doc: choice.doc.clone().unwrap_or_default(),
                    ..Field::default()
                });
                let names: Vec<&str> = decl.choices.iter().map(|choice| choice.name.name.as_str()).collect();
                let written = format!("{} {{ {} }}", decl.name.name, names.join(", "));
                Entry { fields: fields.collect(), ..entry(Kind::Enumeration, &decl.name, written) }
            }
            StmtKind::Record(record) => {
                let fields: Vec<Field> = record.fields.iter().map(|field| self.field(field)).collect();
                let signature = call(&record.name.name, &fields);
                Entry { fields, ..entry(Kind::Record, &record.name, signature) }
            }
            StmtKind::Function(component) if component.is_component => {
                let parameters = component.parameters.iter().map(|p| Field { mode: "", ..self.parameter(p) });
                let parameters: Vec<Field> = parameters.collect();
                let signature = call(&component.name.name, &parameters);
                let members = members(statement).iter().filter_map(|statement| self.member(statement));
                let fields = parameters.into_iter().chain(members).collect();
                Entry { fields, ..entry(Kind::Component, &component.name, signature) }
            }
            StmtKind::Function(function) if !function.is_test => {
                let fields: Vec<Field> = function.parameters.iter().map(|p| self.parameter(p)).collect();
                // Names of the prelude need no module prefix.
                let prefix = if library && module != "std" { format!("{module}.") } else { String::new() };
                let signature = call(&format!("{prefix}{}", function.name.name), &fields);
                let result = function.result.as_ref().map(|ty| self.ty(ty));
                Entry {
                    fields,
                    result,
                    effect: effect(function),
                    ..entry(Kind::Function, &function.name, signature)
                }
            }
            _ => return None,
        })
    }

    /// Returns a param or output of a component.
    fn member(&self, statement: &Stmt) -> Option<Field> {
        let (name, mode, default, domain) = match &statement.kind {
            StmtKind::Param(param) => {
                (&param.name, "param", Some(self.slice(param.default.span)), self.domain(&param.domain))
            }
            StmtKind::Output { name, .. } => (name, "output", None, String::new()),
            _ => return None,
        };
        Some(Field {
            name: name.name.to_string(),
            former: None,
            mode,
            doc: statement.doc.clone().unwrap_or_default(),
            ty: None,
            default,
            domain,
            symbolic: false,
        })
    }

    fn parameter(&self, parameter: &Parameter) -> Field {
        let (symbolic, default) = match &parameter.default {
            Some((bind, value)) => (*bind == Bind::Symbolic, value.as_ref().map(|e| self.slice(e.span))),
            None => (false, None),
        };
        Field {
            name: parameter.name.name.to_string(),
            former: parameter.former.as_ref().map(|former| former.name.to_string()),
            mode: match parameter.mode {
                Mode::In => "in",
                Mode::Out => "out",
                Mode::InOut => "inout",
            },
            doc: parameter.doc.clone().unwrap_or_default(),
            ty: parameter.annotation.as_ref().map(|ty| self.ty(ty)),
            default,
            domain: self.domain(&parameter.domain),
            symbolic,
        }
    }

    fn field(&self, field: &RecordField) -> Field {
        Field {
            name: field.name.name.to_string(),
            former: field.former.as_ref().map(|former| former.name.to_string()),
            mode: "",
            doc: field.doc.clone().unwrap_or_default(),
            ty: field.annotation.as_ref().map(|ty| self.ty(ty)),
            default: field.default.as_ref().map(|value| self.slice(value.span)),
            domain: String::new(),
            symbolic: false,
        }
    }

    fn domain(&self, domain: &Option<Domain>) -> String {
        let written = |e: &Option<Expr>| e.as_ref().map(|e| self.slice(e.span));
        match domain {
            None => String::new(),
            Some(Domain::Range { low, high, .. }) => match (written(low), written(high)) {
                (Some(low), Some(high)) => format!("{low} to {high}"),
                (Some(low), None) => format!("{low} or more"),
                (None, Some(high)) => format!("{high} or less"),
                (None, None) => String::new(),
            },
            Some(Domain::Choices { values, .. }) => {
                let values: Vec<String> = values.iter().map(|e| self.slice(e.span)).collect();
                values.join(" or ")
            }
        }
    }

    fn ty(&self, ty: &TypeExpr) -> Type {
        let mut names = Vec::new();
        type_names(ty, &mut names);
        let units = dimension(ty).map(units);
        Type { text: self.slice(ty.span), units: units.unwrap_or_default(), names }
    }

    /// Returns the source text of a span, on one line.
    fn slice(&self, span: Span) -> String {
        let written = self.text.get(span.start as usize..span.end as usize).unwrap_or_default();
        written.split_whitespace().collect::<Vec<_>>().join(" ")
    }
}

/// Returns the former name of a function or record.
fn former(statement: &Stmt) -> Option<&Ident> {
    match &statement.kind {
        StmtKind::Function(function) => function.former.as_ref(),
        StmtKind::Record(record) => record.former.as_ref(),
        _ => None,
    }
}

/// Returns the unit of a dimension in each system.
fn units(dimension: Dimension) -> Vec<String> {
    let systems = [UnitSystem::MmNS, UnitSystem::InchLbfS];
    let names = systems.map(|system| system.unit_of(dimension).name);
    let mut units: Vec<String> = names.into_iter().filter(|unit| !unit.is_empty()).collect();
    units.dedup();
    units
}

/// Returns a call with the required arguments, and the optional ones in brackets.
fn call(name: &str, fields: &[Field]) -> String {
    let argument = |field: &Field| {
        let bind = if field.symbolic { ":=" } else { "=" };
        match &field.default {
            Some(default) => format!("{} {bind} {default}", field.name),
            None if field.symbolic => format!("{} := ...", field.name),
            None => field.name.clone(),
        }
    };
    format!("{name}({})", fields.iter().map(argument).collect::<Vec<_>>().join(", "))
}

fn effect(function: &FunctionDecl) -> &'static str {
    match &function.body {
        FunctionBody::Extern { purity: Some(word), .. } if word.name == "pure" => "",
        FunctionBody::Extern { purity: Some(word), .. } if word.name == "scene" => "adds to the scene",
        FunctionBody::Extern { .. } => "solves; not called by check",
        FunctionBody::Statement(_) if function.is_host => "an embedding program may provide it",
        FunctionBody::Statement(_) | FunctionBody::Symbolic(_) => "",
    }
}

/// Returns the dimension of the numbers in a type, if there is one.
fn dimension(ty: &TypeExpr) -> Option<Dimension> {
    match &ty.kind {
        TypeKind::Name(name) => Dimension::from_name(&name.name),
        TypeKind::Apply(_, arguments) => dimension(arguments.first()?),
        TypeKind::Product(a, b) => Some(dimension(a)?.times(dimension(b)?)),
        TypeKind::Quotient(a, b) => Some(dimension(a)?.over(dimension(b)?)),
        TypeKind::Power(base, numerator, denominator) => {
            dimension(base)?.power(Rational::new(i64::from(*numerator), i64::from(*denominator))?)
        }
        TypeKind::Member(..) | TypeKind::Function(..) | TypeKind::Error => None,
    }
}

fn type_names(ty: &TypeExpr, names: &mut Vec<String>) {
    const OF_THE_LANGUAGE: [&str; 4] = ["Bool", "String", "Vector", "Transform"];
    match &ty.kind {
        TypeKind::Name(name) => {
            let known =
                OF_THE_LANGUAGE.contains(&name.name.as_str()) || Dimension::from_name(&name.name).is_some();
            if !known {
                names.push(name.name.to_string());
            }
        }
        TypeKind::Member(_, name) => names.push(name.name.to_string()),
        TypeKind::Apply(_, arguments) => arguments.iter().for_each(|ty| type_names(ty, names)),
        TypeKind::Product(a, b) | TypeKind::Quotient(a, b) => {
            type_names(a, names);
            type_names(b, names);
        }
        TypeKind::Power(base, ..) => type_names(base, names),
        TypeKind::Function(parameters, result) => {
            parameters.iter().for_each(|ty| type_names(ty, names));
            type_names(result, names);
        }
        TypeKind::Error => {}
    }
}
