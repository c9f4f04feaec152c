//! Instances of components: finds them before the program is lowered, and lowers their params and
//! outputs.
//!
//! Every instance has a path, such as `low` or `stages[0].pinion`, which is the prefix of the names
//! of its params and outputs. The functions of a component are lowered once per instance, because
//! they refer to the params of the instance.

use super::body::Body;
use super::function_values::Passed;
use super::{Linked, Lowering, known_dimension, relocation};
use crate::check::tree::{Call, Expr, FuncId, Kind, Stmt, StmtKind, UseId, VarId};
use crate::check::types::Substitution;
use crate::common_units::of_output;
use crate::hashed::HashMap;
use crate::ir::{self, ExprKind, FunctionId, Output, Param, SiteId, Statement};
use crate::span::Span;
use crate::units::UnitSystem;
use calyx_abi::{Purity, Repr};

/// The index of an instance.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(super) struct InstanceId(usize);

/// The instance whose code is being lowered; `None` outside of components.
pub(super) type Around = Option<InstanceId>;

/// An instance of a component.
struct Instance {
    /// Prefix of the names of its params and outputs: `stages[0].`.
    prefix: String,
    /// The prefix of the instance that contains it.
    outer: String,
    /// Params and outputs of the program, by their index in the unit of the component.
    params: HashMap<u32, u32>,
    outputs: HashMap<u32, u32>,
    /// Functions that compute the arguments of parameters that the defaults of params use.
    statics: HashMap<VarId, FunctionId>,
    /// The arguments of these parameters in the declaration at the top level that determines them.
    given: HashMap<VarId, Span>,
}

/// The instances of a program.
#[derive(Default)]
pub(super) struct Instances {
    all: Vec<Instance>,
    /// Instances by the enclosing instance, and the unit and the call that create them.
    by_call: HashMap<(Around, usize, UseId), InstanceId>,
    /// Params and outputs of the model's top level.
    params: HashMap<u32, u32>,
    outputs: HashMap<u32, u32>,
    /// Functions outside of components whose instances are listed.
    listed: Vec<(usize, FuncId)>,
}

impl<'c> Lowering<'c> {
    /// Lists the params and outputs of the model and of all its instances, in order.
    pub(super) fn interface(&mut self) {
        self.params_of(FuncId(0), "");
        self.list_instances(FuncId(0), "");
    }

    /// Lists the params of one unit by their own numbers, if it is lowered alone.
    pub(super) fn interface_alone(&mut self) {
        let checker = self.checker;
        for index in 0..checker.params.len() {
            self.add_param(index, "");
        }
    }

    /// Lists the instances that a function outside of components declares, such as a test.
    pub(super) fn list_instances_of(&mut self, function: FuncId) {
        let key = (self.unit, function);
        if self.alone() || self.around.is_some() || self.components.listed.contains(&key) {
            return;
        }
        self.components.listed.push(key);
        if function != FuncId(0) {
            self.list_instances(function, "");
        }
    }

    /// Adds the params of a component to the current instance, or those of the model.
    fn params_of(&mut self, owner: FuncId, prefix: &str) {
        let checker = self.checker;
        for (index, param) in checker.params.iter().enumerate() {
            if param.owner == owner {
                let number = self.add_param(index, prefix);
                match self.around {
                    Some(InstanceId(at)) => self.components.all[at].params.insert(index as u32, number),
                    None => self.components.params.insert(index as u32, number),
                };
            }
        }
    }

    /// Adds a param of the current unit, and returns its number in the program.
    fn add_param(&mut self, index: usize, prefix: &str) -> u32 {
        let checker = self.checker;
        let places = self.places();
        let param = &checker.params[index];
        let name = format!("{prefix}{}", param.name);
        let mut function = |what: &str, e: &Expr| self.constant_function(&format!("{name}.{what}"), e);
        let default = function("default", &param.default);
        let low = param.low.as_ref().map(|e| function("low", e));
        let high = param.high.as_ref().map(|e| function("high", e));
        let limits = param.low.iter().chain(&param.high);
        let given = std::iter::once(&param.default).chain(limits).find_map(|e| self.given_in(e));
        let unit =
            param.unit.clone().unwrap_or_else(|| UnitSystem::Si.unit_of(crate::dimension::Dimension::NONE));
        self.program.params.push(Param {
            name,
            doc: param.doc.clone(),
            repr: checker.store.repr(&param.ty),
            default,
            low,
            high,
            choices: param.choices.clone(),
            unit,
            integral: param.whole,
            span: places.map_or(param.span, |places| places.span(param.span)),
            given,
        });
        self.program.params.len() as u32 - 1
    }

    /// Returns the argument of the model on which an expression in a component depends.
    fn given_in(&self, e: &Expr) -> Option<Span> {
        let InstanceId(at) = self.around?;
        match &e.kind {
            Kind::Var(id) => self.components.all[at].given.get(id).copied(),
            _ => e.children().into_iter().find_map(|part| self.given_in(part)),
        }
    }

    /// Lowers an expression that is evaluated before the program runs.
    fn constant_function(&mut self, name: &str, e: &Expr) -> FunctionId {
        let mut lowered = Body::lower_expression(self, name, e);
        if let Some(places) = self.places() {
            relocation::function(&mut lowered, places);
        }
        self.program.functions.push(lowered);
        FunctionId(self.program.functions.len() as u32 - 1)
    }

    /// Lists the outputs and instances that the statements of a function declare.
    fn list_instances(&mut self, function: FuncId, prefix: &str) {
        let checker = self.checker;
        let Some(function) = checker.functions.get(&function) else { return };
        for statement in &function.body {
            self.list_statement(statement, prefix);
        }
    }

    fn list_statement(&mut self, statement: &'c Stmt, prefix: &str) {
        match &statement.kind {
            // A declaration of several variables.
            StmtKind::Block(all) => all.iter().for_each(|inner| self.list_statement(inner, prefix)),
            StmtKind::Output(index, _) => self.add_output(*index, prefix, false),
            StmtKind::ArrayOutput(index, _) => self.add_output(*index, prefix, true),
            StmtKind::Assign(place, value) if place.steps.is_empty() => {
                let name = &self.checker.variable(place.variable).name;
                self.list_value(value, &format!("{prefix}{name}"));
            }
            _ => {}
        }
    }

    fn list_value(&mut self, value: &'c Expr, path: &str) {
        match &value.kind {
            Kind::Array(all) | Kind::Tuple(all) => {
                for (index, element) in all.iter().enumerate() {
                    self.list_value(element, &format!("{path}[{index}]"));
                }
            }
            Kind::Call(call) if self.checker.is_component(call.function) => {
                self.add_instance(call, value.span, path);
            }
            // Arguments are kept for the defaults of others.
            Kind::Sequence(_, call) => self.list_value(call, path),
            _ => {}
        }
    }

    fn add_instance(&mut self, call: &'c Call, declared: Span, path: &str) {
        let linked: &'c Linked<'c> = self.linked;
        let Some((unit, function)) = self.resolve(call.function) else { return };
        let Some(typed) = linked.typed.get(unit) else { return };
        let Some(component) = typed.functions.get(&function) else { return };
        // The arguments are evaluated where the component is instantiated.
        let (mut statics, mut given) = (HashMap::default(), HashMap::default());
        for ((variable, _), argument) in component.parameters.iter().zip(&call.arguments) {
            if typed.statics.contains(variable) {
                let name = format!("{path}.{}", typed.variable(*variable).name);
                statics.insert(*variable, self.constant_function(&name, argument));
                // A default of the component is not given by the model.
                let is_written = declared.start <= argument.span.start && argument.span.end <= declared.end;
                let written = || self.places().map_or(argument.span, |places| places.span(argument.span));
                let found = self.given_in(argument).or_else(|| is_written.then(written));
                given.extend(found.map(|span| (*variable, span)));
            }
        }
        let id = InstanceId(self.components.all.len());
        let prefix = format!("{path}.");
        self.components.all.push(Instance {
            prefix: prefix.clone(),
            outer: self
                .around
                .map_or_else(String::new, |InstanceId(at)| self.components.all[at].prefix.clone()),
            params: HashMap::default(),
            outputs: HashMap::default(),
            statics,
            given,
        });
        self.components.by_call.insert((self.around, self.unit, call.instance), id);
        let outside = self.around.replace(id);
        self.within(unit, |lowering| {
            lowering.params_of(function, &prefix);
            lowering.list_instances(function, &prefix);
        });
        self.around = outside;
    }

    fn add_output(&mut self, index: u32, prefix: &str, is_array: bool) {
        let checker = self.checker;
        let Some(output) = checker.outputs.get(index as usize) else { return };
        let number = self.program.outputs.len() as u32;
        let dimension = known_dimension(checker, &output.ty);
        self.program.outputs.push(Output {
            name: format!("{prefix}{}", output.name),
            doc: output.doc.clone(),
            is_array,
            // Set when the statement is lowered.
            site: SiteId(0),
            unit: output
                .unit
                .clone()
                .or_else(|| of_output(dimension, self.system))
                .unwrap_or_else(|| checker.store.vocabulary.unit_of(self.system, dimension)),
            si: checker.store.vocabulary.unit_of(UnitSystem::Si, dimension).name,
            choices: output.choices.clone(),
            span: self.places().map_or(output.span, |places| places.span(output.span)),
        });
        match self.around {
            Some(InstanceId(at)) => self.components.all[at].outputs.insert(index, number),
            None => self.components.outputs.insert(index, number),
        };
    }

    /// Returns the number of a param in the program.
    pub(super) fn param_number(&self, index: u32) -> u32 {
        let map = match self.around {
            Some(InstanceId(at)) => &self.components.all[at].params,
            None => &self.components.params,
        };
        map.get(&index).copied().unwrap_or(index)
    }

    /// Returns the number of an output in the program.
    pub(super) fn output_number(&self, index: u32) -> Option<u32> {
        match self.around {
            Some(InstanceId(at)) => self.components.all[at].outputs.get(&index).copied(),
            None => self.components.outputs.get(&index).copied(),
        }
    }

    /// Returns the instance that a call creates.
    pub(super) fn instance_of(&self, call: UseId) -> Around {
        self.components.by_call.get(&(self.around, self.unit, call)).copied()
    }

    /// Returns the path of the current instance, and of the instance that contains it; empty
    /// outside of components.
    fn instance_paths(&self) -> (String, String) {
        let Some(InstanceId(at)) = self.around else { return Default::default() };
        let instance = &self.components.all[at];
        let path = |prefix: &str| prefix.trim_end_matches('.').to_owned();
        (path(&instance.prefix), path(&instance.outer))
    }

    /// Returns the name of a component's function in call stacks: `Stage low`.
    pub(super) fn instance_name(&self, component: &str) -> String {
        match self.around {
            Some(InstanceId(at)) => {
                let path = self.components.all[at].prefix.trim_end_matches('.');
                format!("{component} {path}")
            }
            None => component.to_owned(),
        }
    }

    /// Returns the function that computes the argument of a component's parameter before the
    /// program runs.
    pub(super) fn static_argument(&self, variable: VarId) -> Option<FunctionId> {
        let InstanceId(at) = self.around?;
        self.components.all[at].statics.get(&variable).copied()
    }

    /// Lowers a function of the current instance, or outside of components.
    pub(super) fn lower_around(
        &mut self,
        around: Around,
        function: FuncId,
        types: Substitution,
        passed: &Passed,
    ) -> ir::Function {
        let outside = std::mem::replace(&mut self.around, around);
        let mut lowered = Body::lower(self, function, types, passed);
        if let Some(places) = self.places() {
            relocation::function(&mut lowered, places);
        }
        self.around = outside;
        lowered
    }
}

impl Body<'_, '_> {
    /// Begins the body of a component: the parts that it adds to the scene are named by the path of
    /// the instance.
    pub(super) fn begin_instance(&mut self, span: Span) {
        let (path, _) = self.lowering.instance_paths();
        self.set_instance(path, span);
    }

    /// Ends the body of a component.
    pub(super) fn end_instance(&mut self, span: Span) {
        let (_, outer) = self.lowering.instance_paths();
        self.set_instance(outer, span);
    }

    fn set_instance(&mut self, path: String, span: Span) {
        if self.lowering.around.is_none() {
            return;
        }
        let id = self.lowering.standard("instance", Purity::Scene, &[("path", Repr::String)], Repr::Unit);
        let path = ir::Expr { kind: ExprKind::String(path), repr: Repr::String, span };
        let call = ir::Expr { kind: ExprKind::CallExtern(id, vec![path]), repr: Repr::Unit, span };
        self.push(Statement::Eval(call));
    }
}
