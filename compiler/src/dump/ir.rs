//! Text of the typed program: params, externs, functions as graphs of basic blocks. Numbers are in
//! SI units, without dimensions.

use calyx_abi::Repr;
use calyx_abi::display::Display;
use calyx_abi::text::number;
use calyx_lang::ir::*;
use calyx_lang::render::line_column;
use std::fmt::Write;

pub fn print(program: &Program, files: &[SourceFile], only: Option<&str>) -> String {
    let printer = Printer { program, files };
    let mut out = String::new();
    if only.is_none() {
        for param in &program.params {
            let default = printer.function_name(param.default);
            let _ = writeln!(out, "param {}: {} = {default}()", param.name, repr(&param.repr));
        }
        for output in &program.outputs {
            let _ = writeln!(out, "output {} := site {}", output.name, output.site.0);
        }
        for decl in &program.externs {
            let parameters: Vec<String> =
                decl.parameters.iter().map(|(name, r)| format!("{name}: {}", repr(r))).collect();
            let purity = format!("{:?}", decl.purity).to_lowercase();
            let (name, result) = (&decl.name, repr(&decl.result));
            let _ = writeln!(out, "extern {purity} {name}({}) -> {result}", parameters.join(", "));
        }
        if !out.is_empty() {
            out.push('\n');
        }
    }
    for (index, function) in program.functions.iter().enumerate() {
        if only.is_none_or(|only| function.name == only) {
            printer.function(FunctionId(index as u32), function, &mut out);
        }
    }
    out
}

struct Printer<'p> {
    program: &'p Program,
    files: &'p [SourceFile],
}

impl Printer<'_> {
    /// Instances of one function are distinguished by their number.
    fn function_name(&self, id: FunctionId) -> String {
        match self.program.functions.get(id.0 as usize) {
            Some(function) if !function.name.is_empty() => format!("{}#{}", function.name, id.0),
            _ => format!("#{}", id.0),
        }
    }

    fn function(&self, id: FunctionId, function: &Function, out: &mut String) {
        let parameters: Vec<String> = function
            .parameters
            .iter()
            .map(|(local, mode)| {
                let mode = format!("{mode:?}").to_lowercase();
                let shown = function.locals.get(local.0 as usize).map(|l| repr(&l.repr)).unwrap_or_default();
                format!("{mode} {}: {shown}", local_name(function, *local))
            })
            .collect();
        let place = self.files.get(function.span.file.0 as usize).map_or(String::new(), |file| {
            let (line, _) = line_column(&file.text, function.span.start as usize);
            format!("  // {}:{line}", file.name)
        });
        let (name, result) = (self.function_name(id), repr(&function.result));
        let _ = writeln!(out, "function {name}({}) -> {result} {{{place}", parameters.join(", "));
        for (index, local) in function.locals.iter().enumerate() {
            let id = LocalId(index as u32);
            if function.parameters.iter().all(|(parameter, _)| *parameter != id) {
                let _ = writeln!(out, "  var {}: {}", local_name(function, id), repr(&local.repr));
            }
        }
        for (index, block) in function.blocks.iter().enumerate() {
            let handler = block.handler.map(|handler| format!(" on error {}", handler.0));
            let _ = writeln!(out, "block {index}{}:", handler.unwrap_or_default());
            for statement in &block.statements {
                let _ = writeln!(out, "  {}", self.statement(function, statement));
            }
            let _ = writeln!(out, "  {}", self.terminator(function, &block.terminator));
        }
        out.push_str("}\n\n");
    }

    fn statement(&self, function: &Function, statement: &Statement) -> String {
        match statement {
            Statement::Assign { place, value, .. } => {
                format!("{} = {}", self.place(function, place), self.expr(function, value))
            }
            Statement::Eval(value) => self.expr(function, value),
            Statement::Call { result, function: callee, arguments, copy_back, .. } => {
                let places: Vec<String> =
                    result.iter().chain(copy_back).map(|place| self.place(function, place)).collect();
                let call = format!("{}({})", self.function_name(*callee), self.list(function, arguments));
                if places.is_empty() { call } else { format!("{} = {call}", places.join(", ")) }
            }
            Statement::Host { function: host, arguments, result, provided, .. } => {
                let name = self.program.host_functions.get(host.0 as usize).map_or("", |host| &host.name);
                let places = [provided, result].map(|place| self.place(function, place)).join(", ");
                format!("{places} = host {name}({})", self.list(function, arguments))
            }
            Statement::Push { place, value, .. } => {
                format!("push {}, {}", self.place(function, place), self.expr(function, value))
            }
        }
    }

    fn place(&self, function: &Function, place: &Place) -> String {
        place.steps.iter().fold(local_name(function, place.local), |text, step| match step {
            Step::Index(index) => format!("{text}[{}]", self.expr(function, index)),
            Step::Element(element) => format!("{text}.{element}"),
        })
    }

    fn terminator(&self, function: &Function, terminator: &Terminator) -> String {
        match terminator {
            Terminator::Jump(to) => format!("jump {}", to.0),
            Terminator::Branch { condition, then, otherwise } => {
                format!("branch {} {} {}", self.expr(function, condition), then.0, otherwise.0)
            }
            Terminator::Return(None) => "return".into(),
            Terminator::Return(Some(value)) => format!("return {}", self.expr(function, value)),
            Terminator::Throw { error, .. } => format!("throw {}", self.expr(function, error)),
            Terminator::Rethrow(caught) => format!("throw again {}", self.expr(function, caught)),
        }
    }

    fn list(&self, function: &Function, all: &[Expr]) -> String {
        all.iter().map(|e| self.expr(function, e)).collect::<Vec<_>>().join(", ")
    }

    fn expr(&self, function: &Function, expr: &Expr) -> String {
        let one = |e: &Expr| self.expr(function, e);
        match &expr.kind {
            ExprKind::Number(value) => number(*value),
            ExprKind::Bool(value) => if *value { "TRUE" } else { "FALSE" }.into(),
            ExprKind::String(text) => format!("{text:?}"),
            ExprKind::Local(local) => local_name(function, *local),
            ExprKind::Param(index) => {
                let name = self.program.params.get(*index as usize).map(|param| param.name.as_str());
                format!("param {}", name.unwrap_or("?"))
            }
            ExprKind::Op(op, operands) => {
                format!("{}({})", format!("{op:?}").to_lowercase(), self.list(function, operands))
            }
            ExprKind::And(a, b) => format!("and({}, {})", one(a), one(b)),
            ExprKind::Or(a, b) => format!("or({}, {})", one(a), one(b)),
            ExprKind::If(c, a, b) => format!("if({}, {}, {})", one(c), one(a), one(b)),
            ExprKind::Call(callee, arguments) => {
                format!("{}({})", self.function_name(*callee), self.list(function, arguments))
            }
            ExprKind::CallExtern(id, arguments) => {
                let name = self.program.externs.get(id.0 as usize).map_or("?", |decl| decl.name.as_str());
                format!("{name}({})", self.list(function, arguments))
            }
            ExprKind::Array(elements) => format!("[{}]", self.list(function, elements)),
            ExprKind::Index(base, index) => format!("{}[{}]", one(base), one(index)),
            ExprKind::Tuple(elements) => format!("tuple({})", self.list(function, elements)),
            ExprKind::TupleElement(base, index) => format!("{}.{index}", one(base)),
            ExprKind::Copy(value) => format!("copy({})", one(value)),
            ExprKind::Len(array) => format!("len({})", one(array)),
            ExprKind::Format(parts) => {
                let part = |part: &FormatPart| match part {
                    FormatPart::Text(text) => format!("{text:?}"),
                    FormatPart::Value(value, Display::Number(style)) if !style.unit.is_empty() => {
                        format!("{} in {}", one(value), style.unit)
                    }
                    FormatPart::Value(value, _) => one(value),
                };
                format!("text({})", parts.iter().map(part).collect::<Vec<_>>().join(", "))
            }
            ExprKind::Catch => "catch".into(),
            ExprKind::CaughtFields(caught) => format!("fields({})", one(caught)),
            ExprKind::MakeSymbolic { site, captures } => {
                format!("site {}({})", site.0, self.list(function, captures))
            }
            ExprKind::EvalSymbolic { value, time } => format!("{} at {}", one(value), one(time)),
        }
    }
}

fn local_name(function: &Function, local: LocalId) -> String {
    match function.locals.get(local.0 as usize) {
        Some(known) if !known.name.is_empty() => format!("{}.{}", known.name, local.0),
        _ => format!("t.{}", local.0),
    }
}

fn repr(repr: &Repr) -> String {
    match repr {
        Repr::Unit => "nothing".into(),
        Repr::Array(element) => format!("array({})", self::repr(element)),
        Repr::Tuple(parts) => {
            format!("tuple({})", parts.iter().map(self::repr).collect::<Vec<_>>().join(", "))
        }
        Repr::Symbolic(content) => format!("symbolic({})", self::repr(content)),
        plain => format!("{plain:?}").to_lowercase(),
    }
}
