//! Inference of types and dimensions: the state of it, and functions as a whole.
//!
//! Hindley and Milner's method with two kinds of unknowns. A function's scheme follows from its own body and the
//! schemes of the functions it names; functions that name each other form a group and have one type inside it.

use super::ModuleData;
use super::dim::Dim;
use super::elsewhere;
use super::excerpt::Layout;
use super::rules::{self, Rule};
use super::symbols::{FunctionInfo, Names, Res, VarKind, Variable, with_article};
use super::tree::*;
use super::types::{Mismatch, Store, Substitution, Type};
use crate::ast;
use crate::diagnostic::Diagnostic;
use crate::dimension::Dimension;
use crate::ir::DisplayUnit;
use crate::span::{FileId, Span};
use crate::units::UnitSystem;
use std::collections::{BTreeMap, BTreeSet, HashMap, HashSet};

/// Which `:=` a symbolic name has at some point of the text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reaching {
    One(DefId),
    Several,
}

/// A function's type, known before its body is.
#[derive(Clone, Debug)]
pub struct Signature {
    pub parameters: Vec<Type>,
    pub result: Type,
    /// `None` while its group is being inferred.
    pub scheme: Option<Scheme>,
}

pub struct Checker<'a> {
    pub modules: &'a [ModuleData],
    /// Which item lies where.
    pub(super) layout: &'a Layout,
    pub names: Names<'a>,
    pub store: Store,
    pub diagnostics: Vec<Diagnostic>,
    pub functions: HashMap<FuncId, Function>,
    pub instances: Vec<Substitution>,
    pub defs: Vec<Def>,
    pub params: Vec<Param>,
    pub outputs: Vec<Output>,
    pub handles: BTreeSet<String>,
    /// Who depends on whom, for derivatives by params of values.
    pub dependence: super::dependence::Dependence,
    pub(super) signatures: HashMap<FuncId, Signature>,
    pub(super) pending: Vec<Constraint>,
    pub(super) reaching: HashMap<VarId, Reaching>,
    /// Symbolic names whose expression is chosen at run time, and what every symbolic name is bound to.
    pub(super) graphs: super::graphs::Graphs,
    /// Symbolic names that are bound in more than one place.
    pub(super) rebound: HashSet<VarId>,
    /// Definitions of outputs, which may be named in later expressions.
    pub(super) output_defs: HashMap<u32, DefId>,
    /// Inside a `:=` expression.
    pub(super) symbolic: bool,
    /// In an expression that is evaluated before the program runs (`a param's default`).
    pub(super) constant_place: Option<&'static str>,
    /// `switch` statements around, innermost last: the value and the cases so far.
    pub(super) switches: Vec<(Expr, Vec<Expr>)>,
    /// `catch` sections around, in the function being checked.
    pub(super) handlers: usize,
    /// Ranges and choices to check once types are known.
    pub(super) domains: Vec<super::domains::Check>,
    /// Values of constants; `None` while one is computed.
    pub(super) consts: HashMap<u32, Option<Expr>>,
    /// Declared dimensions and units that are known; `None` for those that make no sense or are being found out.
    pub(super) own_dimensions: HashMap<u32, Option<Dimension>>,
    pub(super) own_units: HashMap<u32, Option<DisplayUnit>>,
    /// Dimensions and units being found out.
    pub(super) opening: Vec<Res>,
    /// Records whose defaults are being put in, outermost first.
    pub(super) making: Vec<RecordId>,
    pub(super) function: FuncId,
    pub(super) file: FileId,
    /// Names of arguments, and where the parameters or fields they mean are declared.
    pub(super) named_parts: Vec<(Span, Span)>,
    /// Types of the parameters of the engine's functions that are checked.
    pub(super) parameter_types: HashMap<Span, Type>,
    /// Fields of values, and the types of the values.
    pub(super) named_fields: Vec<(ast::Ident, Type)>,
    /// A literal in a declaration has a dimension that uses decide.
    pub(super) unsettled: bool,
    /// Notes for the lints of cycles and angles.
    pub(super) turns: super::turns::Turns,
    groups: HashMap<FuncId, Vec<FuncId>>,
    pub(super) variable_types: HashMap<VarId, Type>,
    reported: HashSet<(String, Span, String)>,
}

impl<'a> Checker<'a> {
    pub fn new(modules: &'a [ModuleData], names: Names<'a>, layout: &'a Layout) -> Self {
        let groups = recursive_groups(&names.functions);
        Checker {
            modules,
            layout,
            names,
            store: Store::default(),
            diagnostics: Vec::new(),
            functions: HashMap::new(),
            instances: Vec::new(),
            defs: Vec::new(),
            params: Vec::new(),
            outputs: Vec::new(),
            handles: BTreeSet::new(),
            dependence: Default::default(),
            signatures: HashMap::new(),
            pending: Vec::new(),
            reaching: HashMap::new(),
            graphs: Default::default(),
            rebound: HashSet::new(),
            output_defs: HashMap::new(),
            symbolic: false,
            constant_place: None,
            switches: Vec::new(),
            handlers: 0,
            domains: Vec::new(),
            consts: HashMap::new(),
            own_dimensions: HashMap::new(),
            own_units: HashMap::new(),
            opening: Vec::new(),
            making: Vec::new(),
            function: FuncId(0),
            file: FileId(0),
            named_parts: Vec::new(),
            parameter_types: HashMap::new(),
            named_fields: Vec::new(),
            unsettled: false,
            turns: Default::default(),
            groups,
            variable_types: HashMap::new(),
            reported: HashSet::new(),
        }
    }

    /// Infers the whole program. `functions[0]` is the model's top level afterwards.
    pub fn program(&mut self) {
        let modules = self.modules;
        let Some(model) = modules.first() else { return };
        self.declare_vocabulary();
        self.declare_records();
        self.declare_consts();
        self.unsettled = self.store.has_open_literals();
        self.declare_params();
        self.find_rebound(&model.tree.statements);
        self.find_foreign(&model.tree.statements);
        let body = self.statements(&model.tree.statements);
        let span = Span::new(FileId(0), 0, model.text.len());
        self.functions.insert(
            FuncId(0),
            Function {
                name: "main".into(),
                parameters: Vec::new(),
                result: Type::Unit,
                body,
                definition: None,
                host: None,
                scheme: Scheme::default(),
                span,
            },
        );
        for index in 1..self.names.functions.len() {
            self.ensure_inferred(FuncId(index as u32));
        }
        self.check_extern_declarations();
        self.finish_constraints();
        self.finish_turns();
        self.finish_params();
        self.finish_definitions();
        self.finish_graphs();
        self.check_domains();
    }

    pub fn variable(&self, id: VarId) -> &Variable {
        &self.names.variables[id.0 as usize]
    }

    pub fn variable_type(&mut self, id: VarId) -> Type {
        if let Some(ty) = self.variable_types.get(&id) {
            return ty.clone();
        }
        let ty = self.store.fresh();
        self.variable_types.insert(id, ty.clone());
        ty
    }

    /// A variable that holds a value captured by a `:=`, shown to people as `name`.
    pub fn hidden_variable(&mut self, name: &str, span: Span, ty: Type) -> VarId {
        let id = VarId(self.names.variables.len() as u32);
        self.names.variables.push(Variable {
            name: name.into(),
            span,
            kind: VarKind::Hidden,
            owner: self.function,
            reads: 1,
        });
        self.variable_types.insert(id, ty);
        id
    }

    /// The unit system declared in the file being checked.
    pub fn system(&self) -> Option<UnitSystem> {
        self.modules.get(self.file.0 as usize).and_then(|module| module.system)
    }

    pub fn text(&self, span: Span) -> &'a str {
        let modules = self.modules;
        modules
            .get(span.file.0 as usize)
            .and_then(|module| module.text.get(span.start as usize..span.end as usize))
            .unwrap_or("")
    }

    /// Reports once, however often a place is visited.
    pub fn report(&mut self, diagnostic: Diagnostic) {
        let key = (diagnostic.code.clone(), diagnostic.primary.span, diagnostic.message.clone());
        if self.reported.insert(key) {
            self.diagnostics.push(diagnostic);
        }
    }

    /// Demands that a checked expression has a type. `what` names the place it is put in (`argument `teeth``), `cause`
    /// is where that place got its type.
    pub fn expect(&mut self, expected: &Type, found: &Expr, what: &str, cause: Option<(Span, String)>) {
        self.check_turns(expected, &found.ty, found.span, cause.as_ref().map(|(span, _)| *span));
        self.note_literal(expected, found);
        if let Err(mismatch) = self.store.unify(expected, &found.ty) {
            self.mismatch(mismatch, expected, found, what, cause);
        }
    }

    fn mismatch(
        &mut self,
        mismatch: Mismatch,
        expected: &Type,
        found: &Expr,
        what: &str,
        cause: Option<(Span, String)>,
    ) {
        let (wanted, got) = (self.store.show(expected), self.store.show(&found.ty));
        if let Mismatch::Dimension(dims) = &mismatch {
            let (wanted, got) = &**dims;
            return self.dimension_mismatch(wanted, got, found, what, cause);
        }
        let resolved = (self.store.shallow(expected), self.store.shallow(&found.ty));
        let mut diagnostic = match (&mismatch, &resolved) {
            (Mismatch::Infinite, _) => Diagnostic::error(
                "E0302",
                "a value cannot contain itself, nor more than 100 arrays inside one another or 1000 parts",
                found.span,
                "its type would be infinite or too large",
            )
            .help("use another variable, or an array of parts of one type"),
            (_, (_, Type::Observable(_))) => self.observable_as_value(found.span),
            (_, (_, Type::Unit)) => Diagnostic::error(
                "E0303",
                format!("{what} needs a value, and this call returns nothing"),
                found.span,
                "no value here",
            )
            .help("call it as a statement, or give the function a `return` with a value"),
            _ => Diagnostic::error(
                "E0301",
                format!("{what} must be {}, not {}", with_article(&wanted), with_article(&got)),
                found.span,
                format!("this is {}", with_article(&got)),
            )
            .help(self.kind_help(&resolved.0, &resolved.1)),
        };
        if diagnostic.code == "E0301" {
            diagnostic = self.converted(diagnostic, &resolved.0, found, &resolved.1);
        }
        if let Some((span, message)) = cause {
            diagnostic = diagnostic.label(span, message);
        }
        self.report(diagnostic);
    }

    fn kind_help(&self, expected: &Type, found: &Type) -> String {
        match (expected, found) {
            (Type::String, _) => "put it into a string: `\"{...}\"`".into(),
            (Type::Array(_), _) => "put it into brackets: `[...]`".into(),
            (Type::Vector(_), Type::Number(_)) => "multiply it by a basis vector: `... * e3`".into(),
            (Type::Number(_), Type::Vector(_)) => "take a component (`.x`, `.y`, `.z`) or `norm(...)`".into(),
            (Type::Bool, Type::Number(_)) => "compare it: `... != 0`".into(),
            (Type::Transform, Type::Vector(_)) => "make a frame of it: `Translate(...)`".into(),
            (Type::Handle(name), _) => {
                let makers = self.names.around.map(|around| around.makers(name)).unwrap_or_default();
                elsewhere::handle(&makers, name, &self.store.show(found))
            }
            _ => format!("give {}", with_article(&self.store.show(expected))),
        }
    }

    pub(super) fn observable_as_value(&self, span: Span) -> Diagnostic {
        Diagnostic::error(
            "E0505",
            "an observable has a value only at each step of an analysis",
            span,
            "this is an observable",
        )
        .help("bind the expression with `:=`, or declare it as an `output`")
    }

    // Functions.

    /// Infers a function and its group if that has not been done.
    pub fn ensure_inferred(&mut self, id: FuncId) {
        if self.signatures.contains_key(&id) {
            return;
        }
        let Some(group) = self.groups.get(&id).cloned() else { return };
        for &member in &group {
            let callees: Vec<_> = self.names.functions[member.0 as usize].callees.iter().copied().collect();
            for callee in callees.into_iter().filter(|callee| !group.contains(callee)) {
                self.ensure_inferred(callee);
            }
        }
        // A callee's body may have been reached through its enclosing function, which is in this group.
        if self.signatures.contains_key(&id) {
            return;
        }
        let outer_constraints = std::mem::take(&mut self.pending);
        self.check_symbolic_recursion(&group);
        for &member in &group {
            self.declare_signature(member);
        }
        for &member in &group {
            self.function_body(member);
        }
        self.solve_constraints();
        let inner = std::mem::replace(&mut self.pending, outer_constraints);
        self.generalise(&group, inner);
    }

    fn declare_signature(&mut self, id: FuncId) {
        let Some(decl) = self.names.functions[id.0 as usize].decl else { return };
        let file = std::mem::replace(&mut self.file, self.names.functions[id.0 as usize].file);
        let variables = self.names.functions[id.0 as usize].parameters.clone();
        let mut parameters = Vec::new();
        for (parameter, variable) in decl.parameters.iter().zip(variables) {
            let ty = self.variable_type(variable);
            let symbolic = self.variable(variable).kind == VarKind::Symbolic;
            let ty = if symbolic { Type::Symbolic(Box::new(ty)) } else { ty };
            if let Some(annotation) = &parameter.annotation {
                let annotated = self.annotation(annotation, symbolic);
                // A fresh unknown takes any type.
                let _ = self.store.unify(&ty, &annotated);
            }
            parameters.push(ty);
        }
        let result = match &decl.result {
            Some(annotation) => self.annotation(annotation, false),
            None => self.store.fresh(),
        };
        self.signatures.insert(id, Signature { parameters, result, scheme: None });
        self.file = file;
    }

    fn function_body(&mut self, id: FuncId) {
        let Some(decl) = self.names.functions[id.0 as usize].decl else { return };
        let file = std::mem::replace(&mut self.file, self.names.functions[id.0 as usize].file);
        let function = std::mem::replace(&mut self.function, id);
        let symbolic = std::mem::replace(&mut self.symbolic, false);
        let handlers = std::mem::take(&mut self.handlers);
        let around = self.dependence.enter(id);
        let reaching = self.reaching.clone();
        let variables = self.names.functions[id.0 as usize].parameters.clone();
        for (parameter, &variable) in decl.parameters.iter().zip(&variables) {
            if parameter.mode != ast::Mode::In {
                self.dependence.function_on_variable(id, variable);
            }
            match &parameter.default {
                Some((ast::Bind::Evaluate, Some(default))) => {
                    let ty = self.variable_type(variable);
                    self.parameter_default(&ty, &parameter.name, default);
                }
                Some((ast::Bind::Symbolic, default)) if self.variable(variable).kind == VarKind::Symbolic => {
                    self.symbolic_parameter(variable);
                    if let Some(default) = default {
                        let ty = self.variable_type(variable);
                        let value = self.as_symbolic(|c| c.whole(default));
                        self.expect(&ty, &value, "the default", None);
                    }
                }
                _ => {}
            }
            let ty = self.variable_type(variable);
            self.parameter_domain(&ty, parameter);
        }
        let host = decl.is_host.then(|| self.host_function(id, decl));
        let (mut body, mut definition) = (Vec::new(), None);
        match &decl.body {
            ast::FunctionBody::Statement(statement) => match &statement.kind {
                ast::StmtKind::Block(statements) => {
                    self.find_rebound(statements);
                    self.find_foreign(statements);
                    body = self.statements(statements);
                }
                _ => body.push(self.statement(statement)),
            },
            ast::FunctionBody::Symbolic(e) => definition = Some(self.symbolic_body(id, decl, e)),
            ast::FunctionBody::Extern { .. } => {}
        }
        let returns = definition.is_some() || body.iter().any(returns_value);
        let result = self.signatures.get(&id).map_or(Type::Unit, |signature| signature.result.clone());
        if !returns && matches!(self.store.shallow(&result), Type::Unknown(_)) {
            let _ = self.store.unify(&result, &Type::Unit);
        }
        self.functions.insert(
            id,
            Function {
                name: decl.name.name.clone(),
                parameters: variables.iter().copied().zip(decl.parameters.iter().map(|p| p.mode)).collect(),
                result,
                body,
                definition,
                host,
                scheme: Scheme::default(),
                span: decl.name.span,
            },
        );
        self.reaching = reaching;
        self.symbolic = symbolic;
        self.handlers = handlers;
        self.dependence.leave(around);
        self.function = function;
        self.file = file;
    }

    /// Closes the types of a group over what nothing outside can still decide.
    fn generalise(&mut self, group: &[FuncId], constraints: Vec<Constraint>) {
        let (mut types, mut dims) = (BTreeSet::new(), BTreeSet::new());
        for &member in group {
            let Some(signature) = self.signatures.get(&member) else { continue };
            for ty in signature.parameters.iter().chain([&signature.result]) {
                self.store.unknowns(ty, &mut types, &mut dims);
            }
        }
        // Unknowns of local variables that no parameter decides: they become defaults per instance.
        let inside: BTreeSet<FuncId> = self.inside(group);
        let (mut outer_types, mut outer_dims) = (BTreeSet::new(), BTreeSet::new());
        for (id, ty) in &self.variable_types {
            if !inside.contains(&self.names.variables[id.0 as usize].owner) {
                self.store.unknowns(ty, &mut outer_types, &mut outer_dims);
            }
        }
        for param in &self.params {
            self.store.unknowns(&param.ty, &mut outer_types, &mut outer_dims);
        }
        let sees_unknown = !types.is_disjoint(&outer_types) || !dims.is_disjoint(&outer_dims);
        types.retain(|v| !outer_types.contains(v));
        dims.retain(|v| !outer_dims.contains(v) && !self.store.is_literal(*v));
        // A constraint on a quantified type quantifies what else it mentions.
        let mut own = Vec::new();
        let mut rest = constraints;
        loop {
            let (taken, left): (Vec<_>, Vec<_>) = rest.into_iter().partition(|constraint| {
                let (mut t, mut d) = (BTreeSet::new(), BTreeSet::new());
                constraint.types().iter().for_each(|ty| self.store.unknowns(ty, &mut t, &mut d));
                !t.is_disjoint(&types)
            });
            rest = left;
            if taken.is_empty() {
                break;
            }
            for constraint in taken {
                let (mut t, mut d) = (BTreeSet::new(), BTreeSet::new());
                constraint.types().iter().for_each(|ty| self.store.unknowns(ty, &mut t, &mut d));
                types.extend(t.into_iter().filter(|v| !outer_types.contains(v)));
                dims.extend(d.into_iter().filter(|v| !outer_dims.contains(v) && !self.store.is_literal(*v)));
                own.push(constraint);
            }
        }
        self.pending.extend(rest);
        let applied = [
            (!types.is_empty(), Rule::GeneraliseType),
            (!dims.is_empty(), Rule::GeneraliseDimension),
            (!own.is_empty(), Rule::GeneraliseConstraint),
            (group.len() > 1, Rule::RecursiveGroup),
            (sees_unknown, Rule::OuterUnknown),
        ];
        applied.iter().filter(|(holds, _)| *holds).for_each(|(_, rule)| rules::applied(*rule));
        let scheme =
            Scheme { types: types.into_iter().collect(), dims: dims.into_iter().collect(), constraints: own };
        for member in group {
            if let Some(signature) = self.signatures.get_mut(member) {
                signature.scheme = Some(scheme.clone());
            }
            if let Some(function) = self.functions.get_mut(member) {
                function.scheme = scheme.clone();
            }
        }
    }

    /// The functions of a group and those nested in them.
    fn inside(&self, group: &[FuncId]) -> BTreeSet<FuncId> {
        let mut inside: BTreeSet<FuncId> = group.iter().copied().collect();
        // A nested function has a higher number than the one around it only within one block; look up the chain.
        for index in 0..self.names.functions.len() {
            let mut at = Some(FuncId(index as u32));
            while let Some(id) = at {
                if group.contains(&id) {
                    inside.insert(FuncId(index as u32));
                    break;
                }
                at = self.names.functions[id.0 as usize].parent;
            }
        }
        inside
    }

    /// A use of a function: its parameter types and result with fresh unknowns.
    pub fn instantiate(&mut self, id: FuncId, span: Span) -> (Vec<Type>, Type, UseId) {
        self.ensure_inferred(id);
        let Some(signature) = self.signatures.get(&id).cloned() else {
            return (Vec::new(), Type::Error, UseId(0));
        };
        let mut substitution = Substitution::default();
        if let Some(scheme) = &signature.scheme {
            rules::applied(Rule::Instantiate);
            for &variable in &scheme.types {
                let fresh = self.store.fresh();
                substitution.types.insert(variable, fresh);
            }
            for &variable in &scheme.dims {
                let fresh = self.store.fresh_dim();
                substitution.dims.insert(variable, fresh);
            }
            for constraint in &scheme.constraints {
                self.pending
                    .push(Constraint { kind: constraint.map(|ty| substitution.ty(&self.store, ty)), span });
            }
        }
        let parameters = signature.parameters.iter().map(|ty| substitution.ty(&self.store, ty)).collect();
        let result = substitution.ty(&self.store, &signature.result);
        self.instances.push(substitution);
        (parameters, result, UseId(self.instances.len() as u32 - 1))
    }

    /// Types of what the model declares at its top level.
    pub fn shown_types(&self) -> BTreeMap<String, String> {
        let variables = self.names.variables.iter().enumerate().filter_map(|(index, variable)| {
            let ty = self.variable_types.get(&VarId(index as u32))?;
            let shown = variable.owner == FuncId(0)
                && variable.kind != VarKind::Hidden
                && variable.span.file == FileId(0);
            shown.then(|| (variable.name.clone(), self.store.show(ty)))
        });
        let params = self.params.iter().map(|param| (param.name.clone(), self.store.show(&param.ty)));
        let outputs = self.outputs.iter().map(|output| (output.name.clone(), self.store.show(&output.ty)));
        variables.chain(params).chain(outputs).collect()
    }

    /// The result type of the function being checked; `Unit` at the top level.
    pub fn current_result(&self) -> Type {
        self.signatures.get(&self.function).map_or(Type::Unit, |signature| signature.result.clone())
    }

    pub fn fresh_number(&mut self) -> Type {
        Type::Number(self.store.fresh_dim())
    }

    pub fn fresh_vector(&mut self) -> (Type, Dim) {
        let dim = self.store.fresh_dim();
        (Type::Vector(dim.clone()), dim)
    }
}

fn returns_value(statement: &Stmt) -> bool {
    let mut found = false;
    statement.walk(&mut |s| found |= matches!(s.kind, StmtKind::Return(Some(_))));
    found
}

/// Functions that name each other, by Tarjan's algorithm. The top level belongs to none.
fn recursive_groups(functions: &[FunctionInfo<'_>]) -> HashMap<FuncId, Vec<FuncId>> {
    struct Search<'s, 'a> {
        functions: &'s [FunctionInfo<'a>],
        index: HashMap<FuncId, (usize, usize)>,
        stack: Vec<FuncId>,
        groups: HashMap<FuncId, Vec<FuncId>>,
    }
    impl Search<'_, '_> {
        fn visit(&mut self, id: FuncId) -> usize {
            let own = self.index.len();
            self.index.insert(id, (own, own));
            self.stack.push(id);
            let mut low = own;
            let functions = self.functions;
            for &callee in &functions[id.0 as usize].callees {
                match self.index.get(&callee) {
                    None => low = low.min(self.visit(callee)),
                    Some(&(index, _)) if self.stack.contains(&callee) => low = low.min(index),
                    _ => {}
                }
            }
            if low == own {
                let at = self.stack.iter().position(|other| *other == id).unwrap_or(0);
                let mut group = self.stack.split_off(at);
                group.sort();
                for &member in &group {
                    self.groups.insert(member, group.clone());
                }
            }
            low
        }
    }
    let mut search = Search { functions, index: HashMap::new(), stack: Vec::new(), groups: HashMap::new() };
    for index in 1..functions.len() {
        let id = FuncId(index as u32);
        if !search.index.contains_key(&id) {
            search.visit(id);
        }
    }
    search.groups
}
