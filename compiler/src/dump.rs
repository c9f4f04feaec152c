//! Text of a model at each stage of compilation (`calyx dump`).

mod graph;
mod ir;
mod tokens;

pub use graph::Format;

use calyx_codegen::{CodegenError, Listing, list};
use calyx_gears::library::externs;
use calyx_lang::ir::{Program, SourceFile};
use calyx_lang::parser::parse;
use calyx_lang::span::FileId;
use calyx_lang::tree_text;
use std::collections::BTreeMap;

/// Stage that requires the text only.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TextStage {
    Tokens,
    Tree,
}

/// Stage of a checked program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ProgramStage {
    Ir,
    Graph(Format),
    Clif,
    Asm,
}

/// Prints tokens or syntax tree of a text, with or without errors.
pub fn of_text(stage: TextStage, text: &str) -> String {
    match stage {
        TextStage::Tokens => tokens::print(text),
        TextStage::Tree => tree_text::print(&parse(FileId(0), text).0),
    }
}

/// Prints the types of the model's names, one per line.
pub fn types(types: &BTreeMap<String, String>) -> String {
    types.iter().map(|(name, ty)| format!("{name}: {ty}\n")).collect()
}

/// Prints the program at a stage. With `only`, prints the functions or symbolic expressions of that
/// name.
///
/// # Errors
/// If the program cannot be compiled.
pub fn of_program(
    stage: ProgramStage,
    program: &Program,
    files: &[SourceFile],
    only: Option<&str>,
) -> Result<String, CodegenError> {
    match stage {
        ProgramStage::Ir => Ok(ir::print(program, files, only)),
        ProgramStage::Graph(format) => graph::print(program, only, format).map_err(CodegenError::Kernel),
        ProgramStage::Clif => listings(program, only, |listing| &listing.clif),
        ProgramStage::Asm => listings(program, only, |listing| &listing.asm),
    }
}

/// Returns the names that `only` accepts.
pub fn names(program: &Program) -> Vec<String> {
    let functions = program.functions.iter().map(|function| function.name.clone());
    let mut names: Vec<String> =
        functions.chain(program.sites.iter().map(|site| site.name.clone())).collect();
    names.retain(|name| !name.is_empty());
    names.sort();
    names.dedup();
    names
}

fn listings(
    program: &Program,
    only: Option<&str>,
    part: impl Fn(&Listing) -> &String,
) -> Result<String, CodegenError> {
    let mut text = String::new();
    for listing in list(program, externs())? {
        let name = source_name(program, &listing.symbol);
        if only.is_some_and(|only| name != Some(only)) {
            continue;
        }
        let shown = name.map(|name| format!(" {name}")).unwrap_or_default();
        text += &format!("; {}{shown}\n{}\n\n", listing.symbol, part(&listing).trim_end());
    }
    Ok(text)
}

/// Returns the source name of the function or symbolic expression of a link symbol.
fn source_name<'p>(program: &'p Program, symbol: &str) -> Option<&'p str> {
    let index = |prefix: &str| symbol.strip_prefix(prefix)?.parse::<usize>().ok();
    let function = index("calyx_function_").and_then(|at| program.functions.get(at)).map(|f| f.name.as_str());
    function.or_else(|| index("calyx_kernel_").and_then(|at| program.sites.get(at)).map(|s| s.name.as_str()))
}
