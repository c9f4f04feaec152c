//! From the typed tree to the typed program: one function per representation of its arguments, control flow as a graph.

mod assertions;
mod body;
mod calls;
mod closures;
mod errors;
mod jumps;
mod sequence;
mod sites;
mod symbolic_functions;
mod values;

use super::tree::{self, FuncId, UseId};
use super::typed::Typed;
use super::types::{Substitution, Type};
use crate::ast::{Mode, StmtKind};
use crate::diagnostic::Diagnostic;
use crate::dimension::Dimension;
use crate::ir::{ExternDecl, ExternId, Function, FunctionId, Output, Param, Program, SiteId, SourceFile};
use crate::span::{FileId, Span};
use crate::units::UnitSystem;
use body::Body;
use calyx_abi::{Purity, Repr};
use closures::Closure;
use std::collections::HashMap;

/// A function to be lowered for given types of its scheme's unknowns.
struct Wanted {
    function: FuncId,
    types: Substitution,
    target: FunctionId,
}

pub(super) struct Lowering<'c> {
    checker: &'c Typed,
    program: Program,
    /// In which the model shows numbers.
    system: UnitSystem,
    instances: HashMap<(FuncId, Vec<Repr>, Vec<String>), FunctionId>,
    wanted: Vec<Wanted>,
    closures: HashMap<FuncId, Closure>,
    symbolic_functions: symbolic_functions::Instances,
    externs: HashMap<String, ExternId>,
    diagnostics: Vec<Diagnostic>,
}

/// What the model's file says of the model as a whole.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Model {
    pub system: UnitSystem,
    pub doc: String,
}

impl Model {
    pub fn of(module: &super::ModuleData) -> Model {
        Model { system: module.system.unwrap_or_default(), doc: model_doc(module) }
    }
}

/// What the flow of control shows to be wrong with some functions of a program that has errors elsewhere.
pub fn flow(checker: &Typed, functions: &[FuncId]) -> Vec<Diagnostic> {
    let mut lowering = Lowering::new(checker, UnitSystem::default(), Program::default());
    for id in functions {
        lowering.instance(*id, Substitution::default());
    }
    lowering.work();
    let of_flow = |d: &Diagnostic| ["E02", "W02", "E03"].iter().any(|group| d.code.starts_with(group));
    lowering.diagnostics.retain(of_flow);
    lowering.diagnostics
}

/// The typed program, and what only the flow of control shows to be wrong.
pub fn lower(checker: &Typed, model: Model, files: Vec<SourceFile>) -> (Program, Vec<Diagnostic>) {
    let system = model.system;
    let program = Program { files, units: system.name().into(), doc: model.doc, ..Program::default() };
    let mut lowering = Lowering::new(checker, system, program);
    lowering.params();
    for output in &checker.outputs {
        let dimension = known_dimension(checker, &output.ty);
        lowering.program.outputs.push(Output {
            name: output.name.clone(),
            doc: output.doc.clone(),
            // Set when the statement is lowered.
            site: SiteId(0),
            unit: system.unit_of(dimension),
            si: UnitSystem::Si.unit_of(dimension).name,
            span: output.span,
        });
    }
    let main = lowering.instance(FuncId(0), Substitution::default());
    lowering.program.main = main;
    lowering.work();
    lowering.export_symbolic_functions();
    // What nobody calls is still checked for its flow of control; only the model's own is reported.
    let called: Vec<FuncId> = lowering.instances.keys().map(|(id, ..)| *id).collect();
    let kept = lowering.program.clone();
    for (&id, function) in &checker.functions {
        if !called.contains(&id) && function.span.file == FileId(0) && function.definition.is_none() {
            lowering.instance(id, Substitution::default());
        }
    }
    lowering.work();
    (kept, lowering.diagnostics)
}

/// The comment that opens a file documents the file, also where an import or units follow without a blank line.
fn model_doc(module: &super::ModuleData) -> String {
    let first = module.tree.statements.first();
    let first = first.filter(|s| matches!(s.kind, StmtKind::Import(_) | StmtKind::Units(_)));
    module.tree.doc.clone().or_else(|| first?.doc.clone()).unwrap_or_default()
}

fn known_dimension(checker: &Typed, ty: &Type) -> Dimension {
    match checker.store.resolve(ty) {
        Type::Number(dim) | Type::Vector(dim) | Type::Observable(dim) => dim.as_known().unwrap_or(dim.fixed),
        _ => Dimension::NONE,
    }
}

impl<'c> Lowering<'c> {
    fn new(checker: &'c Typed, system: UnitSystem, program: Program) -> Self {
        let owner = |id: tree::VarId| checker.variable(id).owner;
        Lowering {
            checker,
            system,
            program,
            instances: HashMap::new(),
            wanted: Vec::new(),
            closures: closures::closures(&checker.functions, &checker.defs, &owner),
            symbolic_functions: Default::default(),
            externs: HashMap::new(),
            diagnostics: Vec::new(),
        }
    }
}

impl Lowering<'_> {
    fn work(&mut self) {
        while let Some(wanted) = self.wanted.pop() {
            let function = Body::lower(self, wanted.function, wanted.types);
            self.program.functions[wanted.target.0 as usize] = function;
        }
    }

    fn params(&mut self) {
        let checker = self.checker;
        for (index, param) in checker.params.iter().enumerate() {
            let repr = checker.store.repr(&param.ty);
            let mut function = |what: &str, e: &tree::Expr| {
                let name = format!("{}.{what}", param.name);
                let lowered = Body::lower_expression(self, &name, e);
                self.program.functions.push(lowered);
                FunctionId(self.program.functions.len() as u32 - 1)
            };
            let default = function("default", &param.default);
            let low = param.low.as_ref().map(|e| function("low", e));
            let high = param.high.as_ref().map(|e| function("high", e));
            let unit = param.unit.clone().unwrap_or_else(|| UnitSystem::Si.unit_of(Dimension::NONE));
            debug_assert_eq!(index, self.program.params.len());
            self.program.params.push(Param {
                name: param.name.clone(),
                doc: param.doc.clone(),
                repr,
                default,
                low,
                high,
                choices: param.choices.clone(),
                unit,
                integral: param.whole,
                span: param.span,
            });
        }
    }

    /// The function for the given types of a scheme's unknowns.
    fn instance(&mut self, function: FuncId, types: Substitution) -> FunctionId {
        let checker = self.checker;
        let scheme = checker.functions.get(&function).map(|f| f.scheme.clone()).unwrap_or_default();
        let reprs = scheme
            .types
            .iter()
            .map(|v| checker.store.repr(&types.types.get(v).cloned().unwrap_or(Type::number())));
        // A field stands elsewhere in another record of the same representation.
        let records = scheme.types.iter().filter_map(|v| types.types.get(v));
        let mut shown: Vec<String> = records
            .filter(|ty| checker.store.has_record(ty))
            .map(|ty| format!("{:?}", checker.store.resolve(ty)))
            .collect();
        // Dimensions matter only to text that shows units; a function that makes none is shared by all of them.
        if self.shows_units(function) {
            shown.extend(
                scheme.types.iter().filter_map(|v| types.types.get(v)).map(|ty| checker.store.show(ty)),
            );
            shown.extend(
                scheme.dims.iter().filter_map(|v| types.dims.get(v)).map(|d| checker.store.show_dim(d)),
            );
        }
        let key = (function, reprs.collect(), shown);
        if let Some(known) = self.instances.get(&key) {
            return *known;
        }
        let target = FunctionId(self.program.functions.len() as u32);
        self.program.functions.push(Function {
            name: String::new(),
            parameters: Vec::new(),
            result: Repr::Unit,
            locals: Vec::new(),
            blocks: Vec::new(),
            span: Default::default(),
        });
        self.instances.insert(key, target);
        self.wanted.push(Wanted { function, types, target });
        target
    }

    /// Whether a function, or one it calls, writes numbers into text.
    fn shows_units(&self, function: FuncId) -> bool {
        let mut stack = vec![function];
        let mut seen = std::collections::HashSet::new();
        while let Some(id) = stack.pop() {
            if !seen.insert(id) {
                continue;
            }
            let Some(function) = self.checker.functions.get(&id) else { continue };
            let mut found = false;
            for statement in &function.body {
                statement.walk(&mut |s| {
                    for e in s.expressions() {
                        found |= formats(e, &mut stack);
                    }
                });
            }
            if found {
                return true;
            }
        }
        false
    }

    /// The function used at `instance`, seen from a body whose own unknowns are `types`.
    fn used(&mut self, function: FuncId, instance: UseId, types: &Substitution) -> FunctionId {
        let concrete = self.types_of_use(function, instance, types);
        self.instance(function, concrete)
    }

    /// What stands for the unknowns of the scheme of the function used at `instance`.
    fn types_of_use(&self, function: FuncId, instance: UseId, types: &Substitution) -> Substitution {
        let checker = self.checker;
        let store = &checker.store;
        let scheme = checker.functions.get(&function).map(|f| f.scheme.clone()).unwrap_or_default();
        let at_use = checker.instances.get(instance.0 as usize).cloned().unwrap_or_default();
        let mut concrete = Substitution::default();
        for variable in scheme.types {
            let ty = at_use.types.get(&variable).cloned().unwrap_or(Type::Unknown(variable));
            concrete.types.insert(variable, types.ty(store, &ty));
        }
        for variable in scheme.dims {
            let dim =
                at_use.dims.get(&variable).cloned().unwrap_or_else(|| super::dim::Dim::unknown(variable));
            concrete.dims.insert(variable, types.dim(store, &dim));
        }
        concrete
    }

    /// The engine's function by its index among the declarations.
    fn extern_id(&mut self, index: u32) -> (ExternId, Repr) {
        let decl = self.checker.externs[index as usize].clone();
        let result = decl.result.clone();
        (self.add_extern(decl), result)
    }

    fn standard(&mut self, name: &str, purity: Purity, parameters: &[(&str, Repr)]) -> ExternId {
        self.add_extern(ExternDecl {
            symbol: format!("calyx_std_{name}"),
            name: name.into(),
            purity,
            parameters: parameters.iter().map(|(name, repr)| (name.to_string(), repr.clone())).collect(),
            result: Repr::Unit,
            span: Span::default(),
        })
    }

    fn add_extern(&mut self, decl: ExternDecl) -> ExternId {
        if let Some(known) = self.externs.get(&decl.symbol) {
            return *known;
        }
        let id = ExternId(self.program.externs.len() as u32);
        self.externs.insert(decl.symbol.clone(), id);
        self.program.externs.push(decl);
        id
    }

    fn report(&mut self, diagnostic: Diagnostic) {
        if !self.diagnostics.contains(&diagnostic) {
            self.diagnostics.push(diagnostic);
        }
    }

    /// A function's parameters as the typed program has them: its own, then what it sees around it.
    fn modes(&self, function: FuncId) -> Vec<(tree::VarId, Mode)> {
        let own = self.checker.functions.get(&function).map(|f| f.parameters.clone()).unwrap_or_default();
        let outer = self.closures.get(&function).into_iter().flatten();
        let outer = outer.map(|(id, assigned)| (*id, if *assigned { Mode::InOut } else { Mode::In }));
        own.into_iter().chain(outer).collect()
    }
}

fn formats(e: &tree::Expr, called: &mut Vec<FuncId>) -> bool {
    match &e.kind {
        tree::Kind::Format(..) | tree::Kind::Print(..) => return true,
        tree::Kind::Call(call) => called.push(call.function),
        _ => {}
    }
    e.children().into_iter().any(|child| formats(child, called))
}

/// The representation an annotation of an extern function stands for; `declared` knows the program's own types.
pub(super) fn annotated_repr(
    annotation: &crate::ast::TypeExpr,
    declared: &dyn Fn(&crate::ast::Ident) -> Option<Repr>,
) -> Repr {
    use crate::ast::TypeKind;
    match &annotation.kind {
        TypeKind::Member(_, name) => declared(name).unwrap_or(Repr::Number),
        TypeKind::Name(name) => match name.name.as_str() {
            "Bool" => Repr::Bool,
            "String" => Repr::String,
            "Vector" => Repr::Vector,
            "Transform" => Repr::Transform,
            "Array" => Repr::Array(Box::new(Repr::Number)),
            other if Dimension::from_name(other).is_some() => Repr::Number,
            _ => declared(name).unwrap_or(Repr::Handle),
        },
        TypeKind::Apply(name, arguments) => {
            let inner = arguments.first().map_or(Repr::Number, |argument| annotated_repr(argument, declared));
            match name.name.as_str() {
                "Array" => Repr::Array(Box::new(inner)),
                "Vector" => Repr::Vector,
                "Observable" => Repr::Symbolic(Box::new(Repr::Number)),
                "Symbolic" => Repr::Symbolic(Box::new(inner)),
                _ => inner,
            }
        }
        TypeKind::Product(..) | TypeKind::Quotient(..) | TypeKind::Power(..) | TypeKind::Error => {
            Repr::Number
        }
    }
}
