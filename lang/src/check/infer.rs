//! Inference of types and dimensions: its state, and the inference of a whole program.
//!
//! The method is that of Hindley and Milner, with type variables and dimension variables. A
//! function's scheme follows from its body and the schemes of the functions it uses. Mutually
//! recursive functions form a group and are monomorphic within the group.

use super::ModuleData;
use super::branches::OutputCaptures;
use super::dim::Dim;
use super::excerpt::Layout;
use super::generalise::recursive_groups;
use super::instances::FixedMembers;
use super::symbols::{Names, Resolution, VarKind, Variable};
use super::tree::*;
use super::types::{Store, Substitution, Type};
use crate::ast;
use crate::diagnostic::Diagnostic;
use crate::dimension::Dimension;
use crate::hashed::{HashMap, HashSet};
use crate::ir::DisplayUnit;
use crate::span::{FileId, Span};
use crate::units::UnitSystem;
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

/// The `:=` definition of a symbolic name at a point of the program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reaching {
    One(DefId),
    Several,
}

/// A function's type, known before its body is checked.
#[derive(Clone, Debug)]
pub struct Signature {
    pub parameters: Vec<Type>,
    pub result: Type,
    /// The type scheme; `None` while its group is being inferred.
    pub scheme: Option<Scheme>,
}

pub struct Checker<'a> {
    pub modules: &'a [ModuleData],
    /// The positions of the items.
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
    /// Dependences between values, for derivatives with respect to params.
    pub dependence: super::dependence::Dependence,
    pub(super) signatures: HashMap<FuncId, Signature>,
    pub(super) pending: Vec<Constraint>,
    pub(super) reaching: HashMap<VarId, Reaching>,
    /// Symbolic names whose expression is selected at run time, and the definitions of every
    /// symbolic name.
    pub(super) graphs: super::runtime_definitions::RuntimeDefinitions,
    /// Symbolic names that are bound more than once.
    pub(super) rebound: HashSet<VarId>,
    /// Definitions of outputs, which later expressions may use.
    pub(super) output_defs: HashMap<u32, DefId>,
    /// Variables with the observables of outputs that are arrays.
    pub(super) output_arrays: HashMap<u32, VarId>,
    /// Hidden variables with what a passed function captures, and the parameters or hidden
    /// variables that they copy.
    pub(super) environments: HashMap<VarId, VarId>,
    /// `true` inside a `:=` expression.
    pub(super) symbolic: bool,
    /// Description of an expression that is evaluated before the program runs, such as `a param's
    /// default`.
    pub(super) constant_place: Option<&'static str>,
    /// Set while the definition of an output is made.
    pub(super) output_captures: Option<OutputCaptures>,
    /// The components, in order of declaration.
    pub(super) components: Vec<FuncId>,
    /// Members of components that other units check.
    pub(super) imported_members: HashMap<FuncId, Vec<(String, Type)>>,
    /// Params and outputs of components: their values in an instance cannot be assigned.
    pub(super) fixed_members: HashMap<FuncId, FixedMembers>,
    /// `true` for the default and the range of a param.
    pub(super) declaring_param: bool,
    /// Calls that may instantiate a component.
    pub(super) instance_sites: HashSet<Span>,
    /// Requests of an earlier check of the same program.
    pub(super) given: Requests,
    /// Further requests, which this check has found.
    pub requested: Requests,
    /// Parameters of components that the default or range of a param uses.
    pub(super) static_parameters: HashSet<VarId>,
    /// Enclosing `switch` statements, innermost last: the value and the cases so far.
    pub(super) switches: Vec<(Expr, Vec<Expr>)>,
    /// Number of enclosing `catch` sections in the current function.
    pub(super) handlers: usize,
    /// Ranges and choices to be checked once types are known.
    pub(super) domains: Vec<super::domains::Check>,
    /// Values of constants; `None` while a constant is being computed.
    pub(super) consts: HashMap<u32, Option<Expr>>,
    /// Number of constants being computed, each for the previous one.
    pub(super) open_consts: usize,
    /// Declared dimensions and units; `None` if they are invalid or being computed.
    pub(super) own_dimensions: HashMap<u32, Option<Dimension>>,
    pub(super) own_units: HashMap<u32, Option<DisplayUnit>>,
    /// Dimensions and units being computed.
    pub(super) opening: Vec<Resolution>,
    /// Records whose defaults are being inserted, outermost first.
    pub(super) making: Vec<RecordId>,
    /// Assignments of the computed records that the arguments of the current call spread.
    pub(super) spread_records: Vec<Stmt>,
    pub(super) function: FuncId,
    pub(super) file: FileId,
    /// Paths of optional values that are present at the current position.
    pub(super) present: super::optional::Present,
    /// `true` if the next expression may be an optional value.
    pub(super) may_be_absent: bool,
    /// `true` if the next expression is the operand of `is none`.
    pub(super) tests_presence: bool,
    /// Variables whose first value is the literal `0`, and its location.
    pub(super) zero_starts: HashMap<VarId, Span>,
    /// The only variable that starts with the number 0, by function that another unit checks.
    pub(super) sums: HashMap<FuncId, String>,
    /// Variables of the enclosing comprehensions, and the hidden variables that stand for them. A
    /// comprehension in a default belongs to the function that evaluates the default.
    pub(super) elements: HashMap<VarId, VarId>,
    /// Variables of the enclosing comprehensions of instances, and their values in the current
    /// pass.
    pub(super) unrolled: HashMap<VarId, Expr>,
    /// Lengths of arrays that are declared with brackets.
    pub(super) array_lengths: HashMap<VarId, usize>,
    /// Names of arguments, and the declarations of the parameters or fields that they refer to.
    pub(super) named_parts: Vec<(Span, Span)>,
    /// Current names of arguments that are written with former names.
    pub(super) current_names: HashMap<Span, String>,
    /// Types of the parameters of the checked engine functions.
    pub(super) parameter_types: HashMap<Span, Type>,
    /// Field accesses, and the types of their records.
    pub(super) named_fields: Vec<(ast::Ident, Type)>,
    /// `true` if the type of a literal or field in a declaration depends on its uses.
    pub(super) unsettled: bool,
    /// Data for the lints of cycles and angles.
    pub(super) turns: super::angles::AngleChecks,
    pub(super) groups: HashMap<FuncId, Rc<[FuncId]>>,
    /// Nested functions, by the enclosing function.
    pub(super) nested: HashMap<FuncId, Vec<FuncId>>,
    pub(super) variable_types: HashMap<VarId, Type>,
    /// Variables whose types may still be unknown.
    pub(super) open_variables: Vec<VarId>,
    /// Evidence for the dimensions of variables.
    pub(super) evidence: super::evidence::DimensionEvidence,
    reported: HashSet<(String, Span, String)>,
}

/// Facts that a check needs in advance. If it finds requests, the program is checked again.
#[derive(Clone, Debug, Default)]
pub struct Requests {
    /// Variables and functions, by the location of their name, that have observables although they
    /// start with numbers.
    pub(super) observables: HashSet<Span>,
    /// Anonymous functions, by the location of their name, that compute values because they capture
    /// arrays or texts, and the location of such a value.
    pub(super) computed: HashMap<Span, Span>,
}

impl Requests {
    pub fn is_empty(&self) -> bool {
        self.observables.is_empty() && self.computed.is_empty()
    }

    /// Adds further requests.
    pub fn extend(&mut self, others: Requests) {
        self.observables.extend(others.observables);
        self.computed.extend(others.computed);
    }
}

impl<'a> Checker<'a> {
    /// Creates a checker. `given` are the requests of an earlier check of the same program.
    pub fn new(modules: &'a [ModuleData], mut names: Names<'a>, layout: &'a Layout, given: Requests) -> Self {
        for info in &mut names.functions {
            let captured = info.decl.and_then(|decl| given.computed.get(&decl.name.span));
            info.computed = info.computed.or(captured.copied());
        }
        let groups = recursive_groups(&names.functions);
        let components = (0..).map(FuncId).zip(&names.functions).filter(|(_, info)| info.is_component());
        let components = components.map(|(id, _)| id).collect();
        let mut nested: HashMap<FuncId, Vec<FuncId>> = HashMap::default();
        for (id, function) in (0..).map(FuncId).zip(&names.functions) {
            if let Some(around) = function.parent {
                nested.entry(around).or_default().push(id);
            }
        }
        Checker {
            modules,
            layout,
            names,
            store: Store::default(),
            diagnostics: Vec::new(),
            functions: HashMap::default(),
            instances: Vec::new(),
            defs: Vec::new(),
            params: Vec::new(),
            outputs: Vec::new(),
            handles: BTreeSet::new(),
            dependence: Default::default(),
            signatures: HashMap::default(),
            pending: Vec::new(),
            reaching: HashMap::default(),
            graphs: Default::default(),
            rebound: HashSet::default(),
            output_defs: HashMap::default(),
            output_arrays: HashMap::default(),
            environments: HashMap::default(),
            symbolic: false,
            constant_place: None,
            output_captures: None,
            components,
            imported_members: HashMap::default(),
            fixed_members: HashMap::default(),
            declaring_param: false,
            instance_sites: HashSet::default(),
            given,
            requested: Requests::default(),
            static_parameters: HashSet::default(),
            switches: Vec::new(),
            handlers: 0,
            domains: Vec::new(),
            consts: HashMap::default(),
            open_consts: 0,
            own_dimensions: HashMap::default(),
            own_units: HashMap::default(),
            opening: Vec::new(),
            making: Vec::new(),
            spread_records: Vec::new(),
            function: FuncId(0),
            file: FileId(0),
            present: Default::default(),
            may_be_absent: false,
            tests_presence: false,
            zero_starts: HashMap::default(),
            sums: HashMap::default(),
            elements: HashMap::default(),
            unrolled: HashMap::default(),
            array_lengths: HashMap::default(),
            named_parts: Vec::new(),
            current_names: HashMap::default(),
            parameter_types: HashMap::default(),
            named_fields: Vec::new(),
            unsettled: false,
            turns: Default::default(),
            groups,
            nested,
            variable_types: HashMap::default(),
            open_variables: Vec::new(),
            evidence: Default::default(),
            reported: HashSet::default(),
        }
    }

    /// Infers the whole program. Afterwards, `functions[0]` is the model's top level.
    pub fn program(&mut self) {
        let modules = self.modules;
        let Some(model) = modules.first() else { return };
        self.declare_vocabulary();
        self.declare_records();
        self.declare_consts();
        self.unsettled = self.store.has_open_literals() || self.has_open_records();
        self.declare_params();
        self.find_rebound(&model.tree.statements);
        self.find_foreign(&model.tree.statements);
        self.note_instance_sites(&model.tree.statements);
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
                component: None,
                scheme: Scheme::default(),
                span,
            },
        );
        for index in 1..self.names.functions.len() {
            self.ensure_inferred(FuncId(index as u32));
        }
        self.check_extern_declarations();
        self.store.compress();
        self.finish_constraints();
        self.report_former_fields();
        self.finish_turns();
        self.check_result_types();
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
        // A nested function may use an optional parameter before its function is inferred.
        let ty = if self.is_optional_parameter(id) { Type::optional(ty) } else { ty };
        self.set_variable_type(id, ty.clone());
        ty
    }

    pub(super) fn set_variable_type(&mut self, id: VarId, ty: Type) {
        self.variable_types.insert(id, ty);
        self.open_variables.push(id);
    }

    /// Creates a variable for a value that a `:=` captures; messages call it `name`.
    pub fn hidden_variable(&mut self, name: &str, span: Span, ty: Type) -> VarId {
        let id = VarId(self.names.variables.len() as u32);
        self.names.variables.push(Variable {
            name: name.into(),
            span,
            kind: VarKind::Hidden,
            owner: self.function,
            reads: 1,
        });
        self.set_variable_type(id, ty);
        id
    }

    /// Returns the unit system declared in the current file.
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

    /// Reports a diagnostic, once even if the code is visited repeatedly.
    pub fn report(&mut self, diagnostic: Diagnostic) {
        let key = (diagnostic.code.clone(), diagnostic.primary.span, diagnostic.message.clone());
        if self.reported.insert(key) {
            self.diagnostics.push(diagnostic);
        }
    }

    /// Returns the types of the model's top-level declarations, as displayed.
    pub fn shown_types(&self) -> BTreeMap<String, String> {
        let variables = self.names.variables.iter().enumerate().filter_map(|(index, variable)| {
            let ty = self.variable_types.get(&VarId(index as u32))?;
            let shown = variable.owner == FuncId(0)
                && variable.kind != VarKind::Hidden
                && variable.span.file == FileId(0);
            shown.then(|| (variable.name.to_string(), self.store.show(ty)))
        });
        let params = self.params.iter().filter(|param| param.owner == FuncId(0));
        let params = params.map(|param| (param.name.clone(), self.store.show(&param.ty)));
        let outputs = self.outputs.iter().filter(|output| output.owner == FuncId(0));
        let outputs = outputs.map(|output| (output.name.clone(), self.store.show(&output.ty)));
        variables.chain(params).chain(outputs).collect()
    }

    pub fn fresh_number(&mut self) -> Type {
        Type::Number(self.store.fresh_dim())
    }

    pub fn fresh_vector(&mut self) -> (Type, Dim) {
        let dim = self.store.fresh_dim();
        (Type::Vector(dim.clone()), dim)
    }
}
