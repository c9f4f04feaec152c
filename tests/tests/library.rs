//! Checks that the declarations of the library in Calyx match the functions that the engine
//! provides in Rust.

use calyx_abi::{Purity, Repr};
use calyx_gears::analyses;
use calyx_gears::library::{MODULES, PRELUDE, externs};
use calyx_lang::ast::{Domain, Expr, ExprKind, FunctionBody, FunctionDecl, StmtKind, TypeExpr, TypeKind};
use calyx_lang::dimension::Dimension;
use calyx_lang::parser::parse;
use calyx_lang::span::FileId;
use std::collections::BTreeSet;

/// Functions that the language itself calls: `print`, `assert` and `output` have special syntax or
/// types.
const OF_THE_LANGUAGE: &[&str] = &[
    "calyx_std_print",
    "calyx_std_instance",
    "calyx_std_assert",
    "calyx_std_output",
    "calyx_std_unit_axis",
    "calyx_std_first_outside",
    "calyx_std_first_vector_outside",
    "calyx_std_first_unknown",
    "calyx_std_range_start",
    "calyx_std_range_end",
    "calyx_std_slice_end",
    "calyx_std_same_length",
    "calyx_std_smallest",
    "calyx_std_largest",
    "calyx_std_sorted",
    "calyx_std_spline_table",
    "calyx_std_body_frame",
];

/// Returns link symbol, declaration and doc comment of every extern function of the library.
fn declared() -> Vec<(String, FunctionDecl, Option<String>)> {
    let modules = std::iter::once(&PRELUDE).chain(MODULES);
    let functions = modules.flat_map(|module| {
        let (tree, found) = parse(FileId(0), module.text);
        assert!(found.is_empty(), "{}: {found:?}", module.file);
        let functions = tree.statements.into_iter().filter_map(|statement| match statement.kind {
            StmtKind::Function(decl) => Some((decl, statement.doc)),
            _ => None,
        });
        let externs = functions.filter(|(decl, _)| matches!(decl.body, FunctionBody::Extern { .. }));
        let prefix = module.path.replace('.', "_");
        externs
            .map(move |(decl, doc)| (format!("calyx_{prefix}_{}", decl.name.name), decl, doc))
            .collect::<Vec<_>>()
    });
    functions.collect()
}

/// Returns the engine's representation of a declared type.
fn repr(ty: &TypeExpr) -> Repr {
    let inner = |arguments: &[TypeExpr]| Box::new(repr(&arguments[0]));
    match &ty.kind {
        TypeKind::Name(name) => match name.name.as_str() {
            "Bool" => Repr::Bool,
            "String" => Repr::String,
            "Vector" => Repr::Vector,
            "Transform" => Repr::Transform,
            name if name == "Number" || Dimension::from_name(name).is_some() => Repr::Number,
            _ => Repr::Handle,
        },
        TypeKind::Apply(name, arguments) => match name.name.as_str() {
            "Array" => Repr::Array(inner(arguments)),
            "Symbolic" => Repr::Symbolic(inner(arguments)),
            "Vector" => Repr::Vector,
            // The engine returns an index, which the program converts to a symbol.
            "Observable" => Repr::Handle,
            other => panic!("what is {other}(...)?"),
        },
        // A handle of another module.
        TypeKind::Member(..) => Repr::Handle,
        // Combined dimensions.
        _ => Repr::Number,
    }
}

#[test]
fn every_analysis_is_a_choice_of_analyze() {
    let analyze = declared().into_iter().find(|(symbol, ..)| symbol == "calyx_std_analyze");
    let (_, analyze, _) = analyze.expect("the prelude declares `analyze`");
    let method = analyze.parameters.iter().find(|parameter| parameter.name.name == "method");
    let Some(Domain::Choices { values, .. }) = method.and_then(|method| method.domain.as_ref()) else {
        panic!("`method` has no choices");
    };
    let text = |value: &Expr| PRELUDE.text[value.span.start as usize..value.span.end as usize].to_owned();
    let choices: Vec<String> = values.iter().map(text).collect();
    let known: Vec<String> = analyses::names().map(|name| format!("\"{name}\"")).collect();
    assert_eq!(choices, known);
}

#[test]
fn every_declared_function_is_provided_as_declared() {
    for (symbol, decl, _) in declared() {
        let row = externs().iter().find(|row| row.symbol == symbol);
        let row = row.unwrap_or_else(|| panic!("the engine has no {symbol}"));
        let provided: Vec<(String, Repr)> =
            row.params.iter().map(|(name, shape)| ((*name).into(), shape.repr())).collect();
        let wanted = decl.parameters.iter().map(|parameter| {
            let ty =
                parameter.annotation.as_ref().unwrap_or_else(|| panic!("{symbol}: {}", parameter.name.name));
            let none = |value: &Expr| matches!(&value.kind, ExprKind::Name(name) if name.name == "none");
            let optional = matches!(&parameter.default, Some((_, Some(value))) if none(value));
            let value = repr(ty);
            // Presence precedes the value.
            let value = if optional { Repr::Tuple(vec![Repr::Bool, value]) } else { value };
            (parameter.name.name.to_string(), value)
        });
        assert_eq!(provided, wanted.collect::<Vec<_>>(), "{symbol}");
        assert_eq!(row.result.repr(), decl.result.as_ref().map_or(Repr::Unit, repr), "{symbol}");
        let FunctionBody::Extern { purity, .. } = &decl.body else { unreachable!("only externs are listed") };
        let purity = match purity.as_ref().map(|purity| purity.name.as_str()) {
            Some("pure") => Purity::Pure,
            Some("scene") => Purity::Scene,
            _ => Purity::Effect,
        };
        assert_eq!(row.purity, purity, "{symbol}");
    }
}

#[test]
fn every_provided_function_is_declared_once() {
    let mut known: BTreeSet<String> = OF_THE_LANGUAGE.iter().map(|symbol| (*symbol).into()).collect();
    for (symbol, ..) in declared() {
        assert!(known.insert(symbol.clone()), "{symbol} is declared twice");
    }
    let provided: BTreeSet<String> = externs().iter().map(|row| row.symbol.to_owned()).collect();
    assert_eq!(provided.len(), externs().len(), "a symbol is provided twice");
    assert_eq!(provided, known);
}

#[test]
fn every_function_of_the_library_is_documented() {
    for (symbol, _, doc) in declared() {
        let doc = doc.unwrap_or_default();
        assert!(doc.ends_with(['.', '`']) && doc.starts_with(char::is_uppercase), "{symbol}: {doc:?}");
    }
}
