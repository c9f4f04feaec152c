//! Test programs as text.

use super::externs;
use calyx_abi::{Context, Purity};
use calyx_lang::check::Loader;
use calyx_lang::check_program;
use calyx_lang::ir::Program;
use calyx_lower::interpret::Interpreter;
use std::path::Path;

/// The library's own sources.
struct Library;

/// Reads a file of this project.
pub fn read(path: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(path);
    std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

impl Loader for Library {
    fn module(&self, path: &[String]) -> Option<(String, String)> {
        (path == ["gears"]).then(|| ("<library>/gears.cx".into(), read("stdlib-gears/calyx/gears.cx")))
    }

    fn prelude(&self) -> (String, String) {
        ("<library>/prelude.cx".into(), read("stdlib-gears/calyx/prelude.cx"))
    }
}

pub fn check(text: &str) -> Program {
    let checked = check_program("model.cx", text, &Library);
    checked.program.unwrap_or_else(|| {
        let messages: Vec<_> = checked.diagnostics.iter().map(|d| (&d.message, &d.help)).collect();
        panic!("{text}\n{messages:#?}")
    })
}

/// Returns the defaults of numeric params.
pub fn defaults(program: &Program) -> Vec<f64> {
    let externs = externs();
    let interpreter = Interpreter::new(program, &externs, Purity::Pure).unwrap();
    let mut ctx = Context::new(Box::new(()));
    for param in &program.params {
        let slots = interpreter.run_function(param.default, &[], &mut ctx).unwrap();
        ctx.param_slots.push(slots[0]);
    }
    ctx.param_slots.iter().map(|slot| f64::from_bits(*slot)).collect()
}
