//! Lowers the typed tree to the typed program: instantiates functions per representation of their
//! arguments, and converts control flow to a graph of basic blocks.

mod argument_ranges;
mod assertions;
mod body;
mod calls;
mod closures;
mod elementwise;
mod errors;
mod function_values;
mod hosts;
mod instances;
mod jumps;
mod linked;
mod observables;
mod outputs;
mod record_texts;
mod relocation;
mod sequence;
mod sites;
mod symbolic_functions;
mod symbolic_parts;
mod values;

use super::expected_type::too_large;
use super::tree::{self, FuncId, UseId};
use super::typed::Typed;
use super::types::{Substitution, Type};
use super::unit::Unit;
use crate::ast::{Mode, Stmt, StmtKind};
use crate::diagnostic::Diagnostic;
use crate::dimension::Dimension;
use crate::ir::{
    Capture, ExternDecl, ExternId, Function, FunctionId, Program, SourceFile, SymExpr, SymKind, Symbol,
};
use crate::span::{FileId, Span};
use crate::units::UnitSystem;

use crate::hashed::{HashMap, HashSet};
use calyx_abi::{Purity, Repr};
pub use closures::Closure;
use function_values::Passed;
use instances::Around;
pub use linked::{Linked, flow};
use std::collections::BTreeSet;
use std::sync::LazyLock;

/// A function to be lowered with given types of its scheme's variables.
struct PendingInstance {
    unit: usize,
    function: FuncId,
    types: Substitution,
    around: Around,
    passed: Passed,
    target: FunctionId,
}

/// A function of a unit, the representations of its scheme's variables, dimensions if they affect
/// the code, the instance of the component that contains it, and the functions that are passed.
type Instance = (usize, FuncId, Vec<Repr>, Vec<String>, Around, Passed);

pub(super) struct Lowering<'c> {
    linked: &'c Linked<'c>,
    /// The unit that is being lowered.
    unit: usize,
    checker: &'c Typed,
    closures: &'c HashMap<FuncId, Closure>,
    program: Program,
    /// The unit system in which the model displays numbers.
    system: UnitSystem,
    /// This system if the model declares it.
    declared_system: Option<UnitSystem>,
    instances: HashMap<Instance, FunctionId>,
    components: instances::Instances,
    /// The instance whose code is being lowered.
    around: Around,
    wanted: Vec<PendingInstance>,
    symbolic_functions: symbolic_functions::Instances,
    /// For each function, whether it or a callee formats numbers.
    showing: HashMap<(usize, FuncId), bool>,
    externs: HashMap<String, ExternId>,
    hosts: hosts::Hosts,
    diagnostics: Vec<Diagnostic>,
    /// Numbers of sites, symbolic functions and diagnostics whose locations are already converted
    /// to files.
    placed: (usize, usize, usize),
}

/// The function that returns the frame of a body.
const BODY_FRAME: &str = "calyx_std_body_frame";

/// Properties of the model that its file declares.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Model {
    /// The unit system of the model, if it declares one.
    pub system: Option<UnitSystem>,
    pub doc: String,
}

/// The result of lowering.
pub struct Lowered {
    pub program: Program,
    pub diagnostics: Vec<Diagnostic>,
    /// The lowered functions by unit, without those that were lowered for given types or given
    /// functions. The diagnostics include those of their control flow.
    pub functions: HashSet<(usize, FuncId)>,
}

/// Lowers a program.
pub fn lower(linked: &Linked<'_>, model: Model, files: Vec<SourceFile>) -> Lowered {
    let mut lowering = Lowering::new(linked);
    lowering.declared_system = model.system;
    lowering.system = model.system.unwrap_or_default();
    let text = files.first().map_or(0, |file| file.text.len());
    lowering.program = Program {
        files,
        units: lowering.system.name().into(),
        own_units: lowering.checker.store.vocabulary.units.clone(),
        own_dimensions: lowering.checker.store.vocabulary.own_dimensions(),
        doc: model.doc,
        ..Program::default()
    };
    lowering.within(0, |lowering| {
        lowering.interface();
    });
    lowering.host_functions();
    let main = lowering.instance(0, FuncId(0), Substitution::default(), (None, Vec::new()));
    lowering.program.main = main;
    lowering.work();
    lowering.export_symbolic_functions();
    if lowering.externs.contains_key(BODY_FRAME) {
        // Expressions capture the frame of any body.
        lowering.program.sites.iter_mut().for_each(|site| site.part |= site.repr == Repr::Transform);
    }
    lowering.program.graph_params = graph_params(&lowering.program);
    if let Some(main) = lowering.program.functions.get_mut(main.0 as usize) {
        main.span = Span::new(FileId(0), 0, text);
    }
    let functions = lowering.instances.into_keys().filter(|(.., passed)| passed.is_empty());
    let functions = functions.map(|(unit, function, ..)| (unit, function)).collect();
    Lowered { program: lowering.program, diagnostics: lowering.diagnostics, functions }
}

/// Returns the closures of the functions of a unit.
pub fn closures(typed: &Typed) -> HashMap<FuncId, Closure> {
    closures::closures(&typed.functions, &typed.defs, &typed.chosen, &|id| typed.variable(id).owner)
}

/// Returns the params with respect to which sites with captured expressions are differentiated.
fn graph_params(program: &Program) -> Vec<u32> {
    let mut found = BTreeSet::new();
    for site in &program.sites {
        if site.captures.iter().any(Capture::is_part) {
            let mut pending: Vec<&SymExpr> = site.shared.iter().chain([&site.expr]).collect();
            while let Some(e) = pending.pop() {
                if let SymKind::Derivative(_, Symbol::Param(param)) = e.kind {
                    found.insert(param);
                }
                pending.extend(e.operands());
            }
        }
    }
    found.into_iter().collect()
}

/// Returns the documentation of a file: the comment at its start, also if an import or units follow
/// without a blank line.
pub fn model_doc<'s>(file_doc: Option<&str>, mut statements: impl Iterator<Item = &'s Stmt>) -> String {
    let first = statements.next().filter(|s| matches!(s.kind, StmtKind::Import(_) | StmtKind::Units(_)));
    file_doc.or_else(|| first?.doc.as_deref()).unwrap_or_default().to_string()
}

fn known_dimension(checker: &Typed, ty: &Type) -> Dimension {
    match checker.store.resolve(ty) {
        Type::Number(dim) | Type::Vector(dim) | Type::Observable(dim) => dim.as_known().unwrap_or(dim.fixed),
        _ => Dimension::NONE,
    }
}

impl<'c> Lowering<'c> {
    fn new(linked: &'c Linked<'c>) -> Self {
        static NOTHING: LazyLock<(Unit, Typed)> = LazyLock::new(Default::default);
        let first: &'c Unit = linked.units().first().copied().unwrap_or(&NOTHING.0);
        Lowering {
            linked,
            unit: 0,
            checker: linked.typed.first().unwrap_or(&NOTHING.1),
            closures: &first.closures,
            program: Program::default(),
            instances: HashMap::default(),
            components: Default::default(),
            around: None,
            system: UnitSystem::default(),
            declared_system: None,
            wanted: Vec::new(),
            symbolic_functions: Default::default(),
            showing: HashMap::default(),
            externs: HashMap::default(),
            hosts: HashMap::default(),
            diagnostics: Vec::new(),
            placed: (0, 0, 0),
        }
    }

    fn work(&mut self) {
        while let Some(wanted) = self.wanted.pop() {
            let function = self.within(wanted.unit, |lowering| {
                lowering.lower_around(wanted.around, wanted.function, wanted.types, &wanted.passed)
            });
            self.program.functions[wanted.target.0 as usize] = function;
        }
    }

    /// Returns the instance of a function for the given, resolved types of its scheme's variables,
    /// the instance of the component that contains it, and the functions that are passed to it.
    fn instance(
        &mut self,
        unit: usize,
        function: FuncId,
        types: Substitution,
        (around, passed): (Around, Passed),
    ) -> FunctionId {
        let linked: &'c Linked<'c> = self.linked;
        let typed = linked.typed.get(unit).unwrap_or(self.checker);
        let scheme = typed.functions.get(&function).map(|f| f.scheme.clone()).unwrap_or_default();
        // Each function of a recursive chain may nest its argument in another array.
        if !types.types.values().all(|ty| typed.store.is_bounded(ty)) {
            let span = typed.functions.get(&function).map_or_else(Span::default, |f| f.span);
            self.within(unit, |lowering| lowering.report(too_large(span)));
            return FunctionId(0);
        }
        let reprs = scheme
            .types
            .iter()
            .map(|v| typed.store.repr(&types.types.get(v).cloned().unwrap_or(Type::number())));
        // Records with the same representation may store a field at different positions.
        let records = scheme.types.iter().filter_map(|v| types.types.get(v));
        let mut shown: Vec<String> = records
            .filter(|ty| typed.store.has_record(ty))
            .map(|ty| format!("{:?}", typed.store.resolve(ty)))
            .collect();
        // Dimensions matter only for text with units; other functions are shared between
        // dimensions.
        let general = !(scheme.types.is_empty() && scheme.dims.is_empty());
        if general && self.shows_units(unit, function) {
            shown.extend(
                scheme.types.iter().filter_map(|v| types.types.get(v)).map(|ty| typed.store.show(ty)),
            );
            shown.extend(
                scheme.dims.iter().filter_map(|v| types.dims.get(v)).map(|d| typed.store.show_dim(d)),
            );
        }
        let key = (unit, function, reprs.collect(), shown, around, passed.clone());
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
        self.wanted.push(PendingInstance { unit, function, types, around, passed, target });
        target
    }

    /// Returns `true` if a function, or a function that it calls, formats numbers.
    fn shows_units(&mut self, unit: usize, function: FuncId) -> bool {
        if let Some(known) = self.showing.get(&(unit, function)) {
            return *known;
        }
        let mut stack = vec![(unit, function)];
        let mut seen = HashSet::default();
        let mut shows = false;
        while let Some((unit, id)) = stack.pop() {
            if shows || !seen.insert((unit, id)) {
                continue;
            }
            if let Some(known) = self.showing.get(&(unit, id)) {
                shows |= known;
                continue;
            }
            let mut called = Vec::new();
            self.within(unit, |lowering| {
                let Some(function) = lowering.checker.functions.get(&id) else { return };
                for statement in &function.body {
                    statement.walk(&mut |s| {
                        for e in s.expressions() {
                            shows |= formats(e, &mut called);
                        }
                    });
                }
                stack.extend(called.into_iter().filter_map(|id| lowering.resolve(id)));
            });
        }
        if !shows {
            // None of the visited functions formats numbers.
            self.showing.extend(seen.into_iter().map(|id| (id, false)));
        }
        self.showing.insert((unit, function), shows);
        shows
    }

    /// Returns the instance of a function used at `instance`; `types` are those of the calling
    /// body.
    fn used(
        &mut self,
        function: FuncId,
        instance: UseId,
        types: &Substitution,
        passed: Passed,
    ) -> FunctionId {
        match self.callee(function, instance, types) {
            Some((unit, function, types)) if !self.alone() => {
                let around = self.around_callee(unit, function, instance);
                self.instance(unit, function, types, (around, passed))
            }
            // In a single unit, calls are not resolved.
            _ => FunctionId(0),
        }
    }

    /// Returns the instance of a component to which the code of a called function belongs.
    fn around_callee(&self, unit: usize, function: FuncId, call: UseId) -> Around {
        let called = self.linked.typed.get(unit).and_then(|typed| typed.functions.get(&function))?;
        match called.component? == function {
            true => self.instance_of(call),
            false => self.around,
        }
    }

    /// Returns an engine function by its index among the declarations.
    fn extern_id(&mut self, index: u32) -> (ExternId, Repr) {
        let mut decl = self.checker.externs[index as usize].clone();
        if let Some(places) = self.places() {
            decl.span = places.span(decl.span);
        }
        let result = decl.result.clone();
        (self.add_extern(decl), result)
    }

    pub(super) fn standard(
        &mut self,
        name: &str,
        purity: Purity,
        parameters: &[(&str, Repr)],
        result: Repr,
    ) -> ExternId {
        self.add_extern(ExternDecl {
            symbol: format!("calyx_std_{name}"),
            name: name.into(),
            purity,
            parameters: parameters.iter().map(|(name, repr)| (name.to_string(), repr.clone())).collect(),
            result,
            span: Span::default(),
        })
    }

    /// Returns the function that returns an axis of unit length and fails for any other.
    fn unit_axis(&mut self) -> ExternId {
        self.add_extern(ExternDecl {
            symbol: "calyx_std_unit_axis".into(),
            name: "Rotate".into(),
            purity: Purity::Pure,
            parameters: vec![("axis".into(), Repr::Vector)],
            result: Repr::Vector,
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
        self.diagnostics.push(diagnostic);
    }

    /// Returns a function's parameters in the typed program: its own, followed by its outer
    /// variables.
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

/// Returns the representation for an annotation of an extern function; `declared` resolves the
/// program's own types.
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
        TypeKind::Product(..)
        | TypeKind::Quotient(..)
        | TypeKind::Power(..)
        | TypeKind::Function(..)
        | TypeKind::Error => Repr::Number,
    }
}
