//! Lowers symbolic functions: one expression per representation of the arguments, and the exported
//! functions of the model.

use super::body::Body;
use super::function_values::Passed;
use super::instances::Around;
use super::sites::Captures;
use super::{Lowering, known_dimension};
use crate::ast::{ANONYMOUS, Mode};
use crate::check::function_values::computed_index;
use crate::check::symbols::with_article;
use crate::check::tree::{Call, ConstraintKind, Expr, FuncId, Function, StmtKind, SymbolicBody, VarId};
use crate::check::types::{Store, Substitution, Type};
use crate::diagnostic::Diagnostic;
use crate::dimension::Dimension;
use crate::hashed::HashMap;
use crate::ir::{DisplayUnit, SymbolicFunction, SymbolicFunctionId, SymbolicParameter};
use crate::span::{FileId, Span};
use calyx_abi::Repr;

/// Limit of the nesting depth of calls of symbolic functions.
const MOST_NESTED: usize = 64;

/// The functions lowered so far, by function, representation of the arguments and passed functions.
#[derive(Default)]
pub(super) struct Instances {
    known: HashMap<(usize, FuncId, Vec<Repr>, Around, Passed), SymbolicFunctionId>,
    /// An ordinary function that cannot be inlined, and whether it is a host function.
    refused: Option<(String, bool)>,
    /// Number of functions being lowered, each within the previous one.
    depth: usize,
    /// Number of nested expressions being lowered, over all these functions.
    pub(super) level: usize,
}

/// The body of a function in a symbolic expression.
enum FunctionText<'c> {
    Symbolic(&'c SymbolicBody),
    /// An ordinary function that only declares variables and returns a value: the variables with
    /// their values, and the result.
    Plain(Vec<(VarId, &'c Expr)>, &'c Expr),
}

impl<'c> FunctionText<'c> {
    fn of(function: &'c Function) -> Option<Self> {
        if let Some(definition) = &function.definition {
            return Some(FunctionText::Symbolic(definition));
        }
        if function.host.is_some() {
            return None;
        }
        if function.parameters.iter().any(|(_, mode)| *mode != Mode::In) {
            return None;
        }
        let (mut variables, mut pending) = (Vec::new(), Vec::new());
        pending.extend(function.body.iter().rev());
        while let Some(statement) = pending.pop() {
            match &statement.kind {
                StmtKind::Nothing => {}
                // A declaration of several variables.
                StmtKind::Block(inner) => pending.extend(inner.iter().rev()),
                StmtKind::Assign(place, value) if place.steps.is_empty() => {
                    let again = variables.iter().any(|(variable, _)| *variable == place.variable);
                    let parameter = function.parameters.iter().any(|(id, _)| *id == place.variable);
                    if again || parameter {
                        return None;
                    }
                    variables.push((place.variable, value));
                }
                StmtKind::Return(Some(value)) if pending.is_empty() => {
                    return Some(FunctionText::Plain(variables, value));
                }
                _ => return None,
            }
        }
        None
    }
}

fn not_plain(name: &str, host: bool, called: Span) -> Diagnostic {
    if host {
        return Diagnostic::error(
            "E0516",
            format!("the host function `{name}` cannot be differentiated"),
            called,
            "called with symbolic arguments here",
        )
        .help("call it with values and bind the result, or interpolate its values");
    }
    Diagnostic::error(
        "E0514",
        format!("`{name}` cannot be called with symbolic arguments"),
        called,
        "called with symbolic arguments here",
    )
    .help("reduce its body to `var` declarations and a `return`, or write it as a symbolic function")
}

impl Body<'_, '_> {
    /// Returns the called function, instantiated for the types of the call and the representations
    /// of its arguments.
    pub(super) fn symbolic_callee(
        &mut self,
        call: &Call,
        given: &[Repr],
        span: Span,
    ) -> Option<SymbolicFunctionId> {
        let (unit, function, types) = self.lowering.callee(call.function, call.instance, &self.types)?;
        let passed = self.passed_functions(&call.arguments);
        let found = self
            .lowering
            .within(unit, |lowering| lowering.symbolic_function(function, types, (given, &passed), span));
        // The function may be in another unit; the error is reported at the call.
        if let Some((name, host)) = self.lowering.symbolic_functions.refused.take() {
            self.lowering.report(not_plain(&name, host, span));
        }
        found
    }
}

impl Lowering<'_> {
    /// Lowers a symbolic function. Returns `None` if it is invalid, which is reported.
    pub(super) fn symbolic_function(
        &mut self,
        id: FuncId,
        types: Substitution,
        (reprs, passed): (&[Repr], &Passed),
        span: Span,
    ) -> Option<SymbolicFunctionId> {
        let checker = self.checker;
        let function = checker.functions.get(&id)?;
        // Functions outside of components do not depend on the instance.
        let around = self.around.filter(|_| function.component.is_some());
        let body = FunctionText::of(function);
        let parameter_types: Vec<Type> = function
            .parameters
            .iter()
            .map(|(variable, _)| types.ty(&checker.store, &checker.type_of(*variable)))
            .collect();
        if reprs.len() != parameter_types.len() {
            return None;
        }
        let key = (self.unit, id, reprs.to_vec(), around, passed.clone());
        if let Some(known) = self.symbolic_functions.known.get(&key) {
            return Some(*known);
        }
        for ((variable, _), (repr, ty)) in function.parameters.iter().zip(reprs.iter().zip(&parameter_types))
        {
            if !is_symbolic_argument(repr) {
                let variable = checker.variable(*variable);
                if function.definition.is_none() && function.name.ends_with(ANONYMOUS) {
                    self.report(computed_index(variable.span, "its elements are selected by an argument"));
                    continue;
                }
                self.report(
                    Diagnostic::error(
                        "E0512",
                        format!(
                            "the argument `{}` of a function in a symbolic expression cannot be {}",
                            variable.name,
                            with_article(&checker.store.show(ty))
                        ),
                        variable.span,
                        "must be a number, a truth value, a vector, a frame, or a record or brackets of them",
                    )
                    .label(span, "called here")
                    .help(match repr {
                        Repr::Array(_) => {
                            "write the elements at the call, `[a[0], a[1]]`: the number of elements of an array \
                             is known only when the program runs"
                        }
                        _ if matches!(checker.store.known(ty), Type::Function(..)) => {
                            "the function captures an array or a text, which a symbolic expression cannot \
                             use: declare the elements with `const`, and interpolate them with `spline`"
                        }
                        _ => "pass the values that the function needs one by one",
                    }),
                );
            }
        }
        if !reprs.iter().all(is_symbolic_argument) {
            return None;
        }
        if self.symbolic_functions.depth >= MOST_NESTED {
            self.report(
                Diagnostic::error(
                    "E0510",
                    format!("calls of symbolic functions are nested more than {MOST_NESTED} deep"),
                    span,
                    "called here",
                )
                .help("merge some of these functions"),
            );
            return None;
        }
        let Some(body) = body else {
            self.symbolic_functions.refused = Some((function.name.clone(), function.host.is_some()));
            return None;
        };
        self.symbolic_functions.depth += 1;
        let outside = std::mem::replace(&mut self.around, around);
        let lowered = Body::lower_symbolic(self, (id, passed), &body, types, (&parameter_types, reprs));
        self.around = outside;
        self.symbolic_functions.depth -= 1;
        let target = SymbolicFunctionId(self.program.symbolic_functions.len() as u32);
        self.program.symbolic_functions.push(lowered);
        self.symbolic_functions.known.insert(key, target);
        Some(target)
    }

    /// Lowers every top-level symbolic function of the model, with numbers for types that are not
    /// determined.
    pub(super) fn export_symbolic_functions(&mut self) {
        let mut own: Vec<(u32, usize, FuncId)> = Vec::new();
        for (unit, typed) in self.linked.typed.iter().enumerate() {
            let Some(places) = self.linked.places(unit) else { continue };
            let symbolic = typed
                .functions
                .iter()
                .filter(|(_, function)| function.definition.is_some() && function.component.is_none())
                .filter(|(_, function)| function.span.file == FileId(0));
            own.extend(symbolic.map(|(id, function)| (places.span(function.span).start, unit, *id)));
        }
        own.sort();
        own.dedup_by_key(|(start, ..)| *start);
        for (_, unit, id) in own {
            self.within(unit, |lowering| lowering.export_symbolic_function(id));
        }
    }

    fn export_symbolic_function(&mut self, id: FuncId) {
        let checker = self.checker;
        let Some(found) = checker.functions.get(&id) else { return };
        let reprs: Vec<Repr> = found
            .parameters
            .iter()
            .map(|(variable, _)| checker.store.repr(&checker.type_of(*variable)))
            .collect();
        // An argument of an unknown type with elements or fields is not a scalar.
        let generic = |ty: &Type| matches!(checker.store.known(ty), Type::Unknown(_));
        let has_parts = found.scheme.constraints.iter().any(|constraint| {
            matches!(&constraint.kind,
                ConstraintKind::Index(base, ..) | ConstraintKind::Field(base, ..) if generic(base))
        });
        if has_parts {
            return;
        }
        // Embedding programs pass numbers; a function of frames, records or arrays is instantiated
        // by its calls.
        if !reprs.iter().all(|repr| matches!(repr, Repr::Number | Repr::Bool | Repr::Vector)) {
            return;
        }
        let exported = self.symbolic_function(id, Substitution::default(), (&reprs, &Vec::new()), found.span);
        let function = exported.and_then(|id| self.program.symbolic_functions.get_mut(id.0 as usize));
        if let (Some(function), Some(body)) = (function, &found.definition) {
            function.exported = body.exported;
            function.doc = body.doc.clone();
        }
    }
}

impl<'l, 'c> Body<'l, 'c> {
    /// Lowers the expression of a symbolic function for given types of its scheme's variables.
    fn lower_symbolic(
        lowering: &'l mut Lowering<'c>,
        (id, passed): (FuncId, &Passed),
        text: &FunctionText<'_>,
        types: Substitution,
        (parameter_types, reprs): (&[Type], &[Repr]),
    ) -> SymbolicFunction {
        let checker = lowering.checker;
        let function = &checker.functions[&id];
        let mut captures = Captures::default();
        for ((index, (variable, _)), repr) in (0..).zip(&function.parameters).zip(reprs) {
            captures.arguments.insert(*variable, (index, repr.clone()));
        }
        let mut body = Body::new(lowering, id, types);
        body.receive(passed);
        let result = match text {
            FunctionText::Symbolic(definition) => &checker.defs[definition.def.0 as usize].expr,
            FunctionText::Plain(variables, result) => {
                captures.plain = true;
                for (variable, value) in variables {
                    let value = body.symbolic(value, &mut captures);
                    captures.shared.push(value);
                    captures.locals.insert(*variable, captures.shared.len() as u32 - 1);
                }
                result
            }
        };
        let expr = body.symbolic(result, &mut captures);
        if captures.outside {
            body.lowering.symbolic_functions.refused = Some((function.name.clone(), false));
        }
        body.report_size(&function.name, function.span, &captures);
        let system = body.lowering.system;
        // For a frame, the unit of its translation.
        let unit = |ty: &Type| match checker.store.resolve(ty) {
            Type::Transform => system.unit_of(Dimension::whole([1, 0, 0, 0, 0])),
            _ => system.unit_of(known_dimension(checker, ty)),
        };
        let parameters = function
            .parameters
            .iter()
            .zip(parameter_types.iter().zip(reprs))
            .map(|((variable, _), (ty, repr))| SymbolicParameter {
                name: checker.variable(*variable).name.to_string(),
                repr: repr.clone(),
                unit: unit(ty),
            })
            .collect();
        let result_type = body.types.ty(&checker.store, &function.result);
        let mut units = Vec::new();
        result_units(&result_type, &expr.repr, (&checker.store, &unit), &mut units);
        SymbolicFunction {
            name: function.name.clone(),
            doc: String::new(),
            parameters,
            shared: captures.shared,
            result: expr.repr.clone(),
            body: expr,
            units,
            exported: false,
            span: function.span,
        }
    }
}

/// Returns `true` if an argument of a function in a symbolic expression may have a representation.
fn is_symbolic_argument(repr: &Repr) -> bool {
    match repr {
        Repr::Number | Repr::Bool | Repr::Vector | Repr::Transform => true,
        // No expression can use the text of a record.
        Repr::Tuple(parts) => parts.iter().all(|part| *part == Repr::String || is_symbolic_argument(part)),
        _ => false,
    }
}

/// Returns one unit per value that is not a tuple.
fn result_units(
    ty: &Type,
    repr: &Repr,
    (store, unit): (&Store, &dyn Fn(&Type) -> DisplayUnit),
    units: &mut Vec<DisplayUnit>,
) {
    match (ty, repr) {
        (Type::Record(id), Repr::Tuple(parts)) => {
            let fields = store.record(*id).into_iter().flat_map(|record| &record.fields);
            fields.zip(parts).for_each(|((_, ty), part)| {
                result_units(&store.shallow(ty), part, (store, unit), units);
            });
        }
        (Type::Array(element), Repr::Tuple(parts)) => {
            parts.iter().for_each(|part| result_units(element, part, (store, unit), units));
        }
        (Type::Tuple(types), Repr::Tuple(parts)) => {
            types.iter().zip(parts).for_each(|(ty, part)| result_units(ty, part, (store, unit), units));
        }
        _ => units.push(unit(ty)),
    }
}
