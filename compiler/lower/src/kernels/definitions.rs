//! The simplified graph of a `:=` definition, for display: a site, an expression shared within a
//! site, or a symbolic function. The graphs contain values only, without the time derivatives of
//! the kernels.

use super::functions::Scope;
use super::value::Value;
use super::{KernelError, Lowering, broken};
use calyx_abi::Repr;
use calyx_lang::ir::{Capture, Program, SiteId, SymExpr, SymbolicFunctionId};
use calyx_lang::span::Span;
use calyx_symbolic::{Factor, Graph, NodeId};

/// An expression of the program that is named with `:=`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DefinitionId {
    Site(SiteId),
    /// A definition that is inlined into a site: an index of the site's shared expressions.
    Shared(SiteId, u32),
    Function(SymbolicFunctionId),
}

/// A symbolic value as graph nodes.
#[derive(Clone, Debug)]
pub enum Shape {
    /// A number or a truth value.
    Number(NodeId),
    Vector([NodeId; 3]),
    /// Factors in order of application, from ground.
    Frame(Vec<Factor>),
    Brackets(Vec<Shape>),
}

impl Shape {
    fn of(value: &Value) -> Shape {
        match value {
            Value::Number(number) => Shape::Number(*number),
            Value::Vector(vector) => Shape::Vector(*vector),
            Value::Frame(frame) => Shape::Frame(frame.factors().to_vec()),
            Value::Brackets(parts) => Shape::Brackets(parts.iter().map(Shape::of).collect()),
        }
    }

    /// Returns every node of the value.
    pub fn nodes(&self) -> Vec<NodeId> {
        let factor = |factor: &Factor| match factor {
            Factor::Translate(vector) => vector.to_vec(),
            Factor::Rotate { angle, axis } => [&[*angle], axis.as_slice()].concat(),
            Factor::Rigid { rotation, translation } => [rotation.concat().as_slice(), translation].concat(),
        };
        match self {
            Shape::Number(node) => vec![*node],
            Shape::Vector(vector) => vector.to_vec(),
            Shape::Frame(factors) => factors.iter().flat_map(factor).collect(),
            Shape::Brackets(parts) => parts.iter().flat_map(Shape::nodes).collect(),
        }
    }
}

/// The kind of a graph symbol.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum SymbolKind {
    Time,
    Param,
    /// An argument of a symbolic function.
    Argument,
    /// A value captured when the definition was executed.
    Captured,
    /// A value observed by the engine.
    Observable,
}

/// A symbol of the graph.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct InputSymbol {
    /// The name in the program.
    pub name: String,
    /// The name of this component, such as `p.x` or `derivative(X, Time)[9]`.
    pub text: String,
    pub kind: SymbolKind,
}

/// A definition as a graph.
pub struct DefinitionGraph {
    pub graph: Graph,
    pub shape: Shape,
    /// The inputs, by index of their symbol.
    pub inputs: Vec<InputSymbol>,
}

/// Returns the expression of a definition and the shared expressions of the same site or function.
pub fn definition_expressions(program: &Program, id: DefinitionId) -> Option<(&SymExpr, &[SymExpr])> {
    match id {
        DefinitionId::Site(site) => {
            let site = program.sites.get(site.0 as usize)?;
            Some((&site.expr, &site.shared))
        }
        DefinitionId::Shared(site, index) => {
            let site = program.sites.get(site.0 as usize)?;
            Some((site.shared.get(index as usize)?, &site.shared))
        }
        DefinitionId::Function(function) => {
            let function = program.symbolic_functions.get(function.0 as usize)?;
            Some((&function.body, &function.shared))
        }
    }
}

/// Returns the graph of a definition.
///
/// # Errors
/// As for [`super::lower_site`]; also if the program has no such definition.
pub fn definition_graph(program: &Program, id: DefinitionId) -> Result<DefinitionGraph, KernelError> {
    let missing = || broken("no such definition", Span::default());
    let (expr, shared) = definition_expressions(program, id).ok_or_else(missing)?;
    let mut inputs = vec![symbol("Time", "Time".into(), SymbolKind::Time)];
    inputs.extend(
        program.params.iter().map(|param| symbol(&param.name, param.name.clone(), SymbolKind::Param)),
    );
    let captures: &[Capture] = match id {
        DefinitionId::Site(site) | DefinitionId::Shared(site, _) => {
            program.sites.get(site.0 as usize).map_or(&[], |site| &site.captures)
        }
        DefinitionId::Function(_) => &[],
    };
    for capture in captures {
        let kind = if capture.observable { SymbolKind::Observable } else { SymbolKind::Captured };
        let texts = (0..capture.inputs(program)).map(|slot| part_text(program, capture, slot));
        inputs.extend(texts.map(|text| symbol(&capture.name, text, kind)));
    }
    let mut lowering = Lowering::new(program, captures);
    let value = match id {
        DefinitionId::Function(function) => {
            let function = program.symbolic_functions.get(function.0 as usize).ok_or_else(missing)?;
            for parameter in &function.parameters {
                let texts = element_texts(&parameter.name, &parameter.repr);
                inputs.extend(
                    texts.into_iter().map(|text| symbol(&parameter.name, text, SymbolKind::Argument)),
                );
            }
            lowering.free_body(function)?
        }
        DefinitionId::Site(_) | DefinitionId::Shared(..) => {
            lowering.scopes.push(Scope::new(shared, Vec::new()));
            lowering.value(expr)?
        }
    };
    Ok(DefinitionGraph { shape: Shape::of(&value), graph: lowering.graph, inputs })
}

fn symbol(name: &str, text: String, kind: SymbolKind) -> InputSymbol {
    InputSymbol { name: name.to_owned(), text, kind }
}

/// Returns the names of a value's components.
fn element_texts(name: &str, repr: &Repr) -> Vec<String> {
    match repr {
        Repr::Vector => ["x", "y", "z"].map(|axis| format!("{name}.{axis}")).to_vec(),
        Repr::Transform => (0..12).map(|at| format!("{name}[{at}]")).collect(),
        Repr::Tuple(parts) => {
            let parts = parts.iter().enumerate();
            parts.flat_map(|(at, part)| element_texts(&format!("{name}[{at}]"), part)).collect()
        }
        _ => vec![name.to_owned()],
    }
}

/// Returns the name of one of a capture's inputs. The inputs of an expression include its
/// derivatives; see [`super::parts`].
fn part_text(program: &Program, capture: &Capture, slot: usize) -> String {
    let Repr::Symbolic(inner) = &capture.repr else {
        return element_texts(&capture.name, &capture.repr).get(slot).cloned().unwrap_or_default();
    };
    if capture.observable {
        return capture.name.clone();
    }
    let size = inner.slots();
    let (by, order) = (slot / (3 * size), slot / size % 3);
    let mut name = capture.name.clone();
    for _ in 0..order {
        name = format!("derivative({name}, Time)");
    }
    let param = by.checked_sub(1).and_then(|at| program.graph_params.get(at));
    if let Some(param) = param.and_then(|param| program.params.get(*param as usize)) {
        name = format!("derivative({name}, {})", param.name);
    }
    element_texts(&name, inner).get(slot % size).cloned().unwrap_or_default()
}
