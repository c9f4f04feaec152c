//! Converts type annotations to types.

use super::dim::Dim;
use super::infer::Checker;
use super::symbols::{Resolution, similar};
use super::types::Type;
use crate::ast::{FunctionBody, FunctionDecl, Ident, Mode, Parameter, StmtKind, TypeExpr, TypeKind};
use crate::diagnostic::Diagnostic;
use crate::dimension::{Dimension, Rational};
use crate::span::Span;

/// Type names that are not dimensions.
const NAMES: &[&str] = &["Bool", "String", "Vector", "Transform", "Array", "Symbolic", "Observable"];

/// Returns the handle types in an `extern` declaration: capitalized names without another meaning
/// denote objects of the engine.
pub fn handles_of(decl: &FunctionDecl) -> Vec<String> {
    fn names(ty: &TypeExpr, handles: &mut Vec<String>) {
        match &ty.kind {
            TypeKind::Name(name) => handles.push(name.name.to_string()),
            TypeKind::Apply(_, parts) => parts.iter().for_each(|part| names(part, handles)),
            _ => {}
        }
    }
    let mut found = Vec::new();
    let annotations = decl.parameters.iter().filter_map(|p| p.annotation.as_ref());
    annotations.chain(&decl.result).for_each(|ty| names(ty, &mut found));
    found.retain(|name| {
        name.starts_with(char::is_uppercase)
            && !NAMES.contains(&name.as_str())
            && Dimension::from_name(name).is_none()
    });
    found
}

impl<'a> Checker<'a> {
    /// Returns the type of an annotation. `symbolic` allows types that only engine functions
    /// accept.
    pub(super) fn annotation(&mut self, annotation: &TypeExpr, symbolic: bool) -> Type {
        match &annotation.kind {
            TypeKind::Error => Type::Error,
            // A handle of a module.
            TypeKind::Member(_, name)
                if !self.names.uses.contains_key(&name.span) && self.handles.contains(name.name.as_str()) =>
            {
                Type::Handle(name.name.to_string())
            }
            TypeKind::Member(_, name) => self.declared_type(name).unwrap_or(Type::Error),
            TypeKind::Name(name) => match name.name.as_str() {
                _ if self.names.uses.contains_key(&name.span) => {
                    self.declared_type(name).unwrap_or(Type::Error)
                }
                "Bool" => Type::Bool,
                "String" => Type::String,
                "Transform" => Type::Transform,
                // A vector of any dimension.
                "Vector" => self.fresh_vector().0,
                "Array" => Type::array(self.store.fresh()),
                other if self.handles.contains(other) => Type::Handle(other.into()),
                other => match counted_dimension(other) {
                    Some(dimension) => Type::quantity(dimension),
                    None => self.unknown_type(other, name.span),
                },
            },
            TypeKind::Apply(name, arguments) => {
                let [argument] = arguments.as_slice() else {
                    return self.bad_annotation(
                        format!("`{}` takes one type in parentheses", name.name),
                        annotation.span,
                    );
                };
                match name.name.as_str() {
                    "Array" => Type::array(self.annotation(argument, symbolic)),
                    "Vector" => self.dimension(argument).map_or(Type::Error, |d| Type::Vector(Dim::known(d))),
                    "Observable" => {
                        self.dimension(argument).map_or(Type::Error, |d| Type::Observable(Dim::known(d)))
                    }
                    "Symbolic" if symbolic => Type::Symbolic(Box::new(self.annotation(argument, false))),
                    "Symbolic" => {
                        self.report(
                            Diagnostic::error(
                                "E0503",
                                "a symbolic expression is passed with `:=`",
                                annotation.span,
                                "declared as a value",
                            )
                            .help("write `in name: Symbolic(...) :=`"),
                        );
                        Type::Error
                    }
                    other => self.unknown_type(other, name.span),
                }
            }
            TypeKind::Product(..) | TypeKind::Quotient(..) | TypeKind::Power(..) => {
                self.dimension(annotation).map_or(Type::Error, Type::quantity)
            }
            TypeKind::Function(..) => {
                self.report(
                    Diagnostic::error(
                        "E0883",
                        "only a parameter of a function can be a function",
                        annotation.span,
                        "the type of a function",
                    )
                    .help("functions are not values: pass the function to each function that calls it"),
                );
                Type::Error
            }
        }
    }

    /// Returns the type for the annotation of a parameter of a function, which may be the type of a
    /// function.
    pub(super) fn parameter_annotation(
        &mut self,
        decl: &FunctionDecl,
        parameter: &Parameter,
        annotation: &TypeExpr,
        symbolic: bool,
    ) -> Type {
        let TypeKind::Function(parameters, result) = &annotation.kind else {
            return self.annotation(annotation, symbolic);
        };
        let has_default = parameter.default.is_some() || parameter.domain.is_some();
        if decl.is_component || decl.is_host || parameter.mode != Mode::In || has_default {
            return self.annotation(annotation, symbolic);
        }
        let parameters = parameters.iter().map(|part| self.annotation(part, false)).collect();
        Type::Function(parameters, Box::new(self.annotation(result, false)))
    }

    /// Returns the type for a name that the program declares.
    fn declared_type(&mut self, name: &Ident) -> Option<Type> {
        match self.names.uses.get(&name.span).copied()? {
            Resolution::Record(id) => Some(Type::Record(id)),
            Resolution::Enum(id) => Some(self.enum_type(id)),
            Resolution::Dimension(id) => self.own_dimension(id).map(Type::quantity),
            Resolution::Function(id) if self.component_record(id).is_some() => {
                self.ensure_inferred(id);
                self.component_record(id).map(Type::Record)
            }
            Resolution::Unknown => None,
            _ => Some(self.bad_annotation(format!("`{}` is not a type", name.name), name.span)),
        }
    }

    fn dimension(&mut self, annotation: &TypeExpr) -> Option<Dimension> {
        match &annotation.kind {
            TypeKind::Name(name) => {
                if let Some(Resolution::Dimension(id)) = self.names.uses.get(&name.span).copied() {
                    return self.own_dimension(id);
                }
                let found = counted_dimension(&name.name);
                if found.is_none() {
                    self.unknown_type(&name.name, name.span);
                }
                found
            }
            TypeKind::Product(a, b) => Some(self.dimension(a)?.times(self.dimension(b)?)),
            TypeKind::Quotient(a, b) => Some(self.dimension(a)?.over(self.dimension(b)?)),
            TypeKind::Power(base, n, d) => {
                let base = self.dimension(base)?;
                let power = Rational::new(i64::from(*n), i64::from(*d)).and_then(|e| base.power(e));
                if power.is_none() {
                    self.bad_annotation("this exponent is out of range".into(), annotation.span);
                }
                power
            }
            TypeKind::Member(_, name) => match self.declared_type(name)? {
                Type::Number(dim) => dim.as_known(),
                _ => {
                    self.bad_annotation("write a dimension, such as `Length`".into(), name.span);
                    None
                }
            },
            TypeKind::Apply(..) | TypeKind::Function(..) => {
                self.bad_annotation("write a dimension, such as `Length`".into(), annotation.span);
                None
            }
            TypeKind::Error => None,
        }
    }

    fn bad_annotation(&mut self, message: String, span: Span) -> Type {
        self.report(Diagnostic::error("E0308", message, span, "not a type").help(
            "types are dimensions, Bool, String, Vector(...), Transform, Array(...), and the library's own",
        ));
        Type::Error
    }

    fn unknown_type(&mut self, name: &str, span: Span) -> Type {
        let diagnostic =
            Diagnostic::error("E0309", format!("there is no type `{name}`"), span, "unknown type");
        let handles: Vec<String> = self.handles.iter().cloned().collect();
        let mut candidates: Vec<&str> = NAMES.iter().copied().chain(Dimension::names()).collect();
        candidates.extend(handles.iter().map(String::as_str));
        candidates.extend(self.names.records.iter().map(|record| record.decl.name.name.as_str()));
        candidates.extend(self.names.enums.iter().map(|declared| declared.decl.name.name.as_str()));
        let components = self.names.functions.iter().filter(|function| function.is_component());
        candidates.extend(components.map(|component| component.name.as_str()));
        candidates.extend(self.names.dimensions.iter().map(|own| own.decl.name.name.as_str()));
        let diagnostic = match similar(name, candidates.into_iter()) {
            Some(near) => {
                diagnostic.help(format!("did you mean `{near}`?")).fix(format!("change to `{near}`"), span, near)
            }
            None => diagnostic
                .help("types are dimensions (`Length`, `Force/Length`), Bool, String, Vector, Transform, Array(...), and the library's own"),
        };
        self.report(diagnostic);
        Type::Error
    }

    /// Checks the declarations of all engine functions once, including functions that are not
    /// called.
    pub(super) fn check_extern_declarations(&mut self) {
        let modules = self.modules;
        for module in modules {
            self.file = module.file;
            for statement in &module.tree.statements {
                if let StmtKind::Function(decl) = &statement.kind
                    && let FunctionBody::Extern { purity, unit } = &decl.body
                    && self.layout.is_own(decl.name.span)
                {
                    if let (Some(unit), Some(result)) = (unit, &decl.result) {
                        let ty = self.annotation(result, true);
                        if self.stated_choices(&ty, result.span, unit).is_none() {
                            self.output_unit(&ty, result.span, unit);
                        }
                    }
                    if let Some(purity) = purity
                        && !["pure", "scene", "effect"].contains(&purity.name.as_str())
                    {
                        self.report(
                            Diagnostic::error(
                                "E0213",
                                format!("`{}` is not a kind of function", purity.name),
                                purity.span,
                                "unknown kind",
                            )
                            .help("write `pure`, `scene` or `effect`"),
                        );
                    }
                    self.check_extern(decl);
                }
            }
        }
    }

    fn check_extern(&mut self, decl: &'a FunctionDecl) {
        for parameter in &decl.parameters {
            if parameter.mode != Mode::In {
                self.report(
                    Diagnostic::error(
                        "E0308",
                        format!(
                            "an extern function cannot have the `out` or `inout` parameter `{}`",
                            parameter.name.name
                        ),
                        parameter.name.span,
                        "engine functions have only `in` parameters",
                    )
                    .help("return the value instead"),
                );
            }
            let Some(annotation) = &parameter.annotation else {
                self.report(
                    Diagnostic::error(
                        "E0308",
                        format!("parameter `{}` of an extern function needs a type", parameter.name.name),
                        parameter.name.span,
                        "no type",
                    )
                    .help("write `in name: Type`"),
                );
                continue;
            };
            let ty = self.annotation(annotation, true);
            let ty = if self.is_optional(parameter) { Type::optional(ty) } else { ty };
            self.parameter_types.insert(parameter.name.span, ty.clone());
            if let Some((_, Some(default))) = &parameter.default {
                self.parameter_default(&ty, &parameter.name, default);
            }
            self.check_former_none(&ty, parameter);
            self.domain(&ty, parameter.domain.as_ref(), None, &parameter.name.name);
        }
        if let Some(result) = &decl.result {
            self.annotation(result, true);
        }
    }
}

/// Returns the dimension with a name in a type. A frequency is in cycles by time.
fn counted_dimension(name: &str) -> Option<Dimension> {
    let dimension = Dimension::from_name(name)?;
    Some(if name == "Frequency" { dimension.of_cycles() } else { dimension })
}
