//! Lowers symbolic sites to kernels: builds the expression graph, differentiates it with respect to
//! time, and schedules the result.

use crate::nan::{self, NanSource};
use calyx_abi::Repr;
use calyx_lang::ir::{
    Capture, Op, Program, Site, SiteId, SymExpr, SymKind, Symbol, SymbolicFunctionId, captured_inputs,
};
use calyx_lang::span::Span;
use calyx_symbolic::{Binary, Frame, Graph, Node, NodeId, Pose, Tape, Unary, Vector3};
use functions::{Free, Scope};
use motion::{Motion, TransformedQuantity};
use std::collections::HashMap;
use std::fmt;

mod content;
mod definitions;
mod functions;
mod motion;
mod parts;
mod value;

pub use content::SiteContent;
pub use definitions::{
    DefinitionGraph, DefinitionId, InputSymbol, Shape, SymbolKind, definition_expressions, definition_graph,
};
pub use functions::lower_kernel;
use value::Value;

/// Index of time among the inputs of every kernel; the params follow.
const TIME: u32 = 0;

/// The reason why a site has no kernel.
#[derive(Clone, Debug, PartialEq)]
pub struct KernelError {
    pub message: String,
    /// A suggested fix; may be empty.
    pub help: String,
    pub span: Span,
}

impl fmt::Display for KernelError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for KernelError {}

/// Returns the kernels of all sites, in order of the sites.
///
/// # Errors
/// As for [`lower_site`].
pub fn lower_sites(program: &Program) -> Result<Vec<Tape>, KernelError> {
    program.sites.iter().map(|site| lower(program, site)).collect()
}

/// Returns the kernel of one site.
///
/// Inputs: time; every param of the program by index (1 or 0 for a truth value; NaN for text, which
/// no expression reads); the captured values in order. A captured number, truth value or observable
/// takes one input, a vector 3, a transform 12, and an expression takes all outputs of its own
/// kernel.
///
/// Outputs: the value (1, 3 or 12 numbers), followed by its time derivatives up to [`Site::order`]
/// in the same layout. For a [`Site::part`], the same numbers follow for the derivative with
/// respect to each of [`Program::graph_params`].
///
/// # Errors
/// The expression has no kernel (an unsupported derivative, for example) or is too large.
pub fn lower_site(program: &Program, site: SiteId) -> Result<Tape, KernelError> {
    match program.sites.get(site.0 as usize) {
        Some(site) => lower(program, site),
        None => Err(KernelError {
            message: format!("the program has no symbolic site {}", site.0),
            help: String::new(),
            span: Span::default(),
        }),
    }
}

fn lower(program: &Program, site: &Site) -> Result<Tape, KernelError> {
    let mut lowering = Lowering::of_site(program, site);
    let outputs = outputs(&mut lowering, site)?;
    Ok(lowering.graph.schedule(lowering.inputs, &outputs))
}

/// Returns the outputs of the kernel as nodes.
fn outputs<'a>(lowering: &mut Lowering<'a>, site: &'a Site) -> Result<Vec<NodeId>, KernelError> {
    let value = lowering.value(&site.expr)?;
    if site.order > 0 {
        lowering.reject_observables(&value, site.span)?;
    }
    let outputs = lowering.rates(&value, site)?;
    let outputs = lowering.with_params(outputs, site);
    lowering.reject_beyond(&outputs, site.span)?;
    Ok(outputs)
}

impl Lowering<'_> {
    /// Returns a site's value and its time derivatives.
    fn rates(&mut self, value: &Value, site: &Site) -> Result<Vec<NodeId>, KernelError> {
        let graph = &mut self.graph;
        let order = usize::from(site.order);
        Ok(match value {
            Value::Frame(frame) => {
                let poses = frame.pose_with_derivatives(graph, TIME, order);
                if poses.len() <= order {
                    return Err(broken("a frame has at most two time derivatives", site.span));
                }
                poses.concat()
            }
            value => {
                let value = value.flat(graph);
                with_derivatives(graph, &value, order)
            }
        })
    }
}

/// The expression of a site as a graph, for display.
pub struct SiteGraph {
    pub graph: Graph,
    /// The nodes that the outputs need in ascending order, so operands precede their users.
    pub nodes: Vec<NodeId>,
    pub outputs: Vec<NodeId>,
    /// Names of the inputs, by index of their symbol.
    pub inputs: Vec<String>,
}

/// Returns the graph from which a site's kernel is built.
///
/// # Errors
/// As for [`lower_site`].
pub fn site_graph(program: &Program, id: SiteId) -> Result<SiteGraph, KernelError> {
    let site = program.sites.get(id.0 as usize);
    let site = site.ok_or_else(|| broken("no such site", Span::default()))?;
    let mut lowering = Lowering::of_site(program, site);
    let outputs = outputs(&mut lowering, site)?;
    let mut inputs = vec!["Time".to_owned()];
    inputs.extend(program.params.iter().map(|param| param.name.clone()));
    for capture in &site.captures {
        let slots = capture.inputs(program);
        let part = |at| if slots == 1 { capture.name.clone() } else { format!("{}.{at}", capture.name) };
        inputs.extend((0..slots).map(part));
    }
    let nodes = lowering.graph.reachable(&outputs, |_| true);
    Ok(SiteGraph { graph: lowering.graph, nodes, outputs, inputs })
}

/// Evaluates a site's expression as its kernel does, and traces the first NaN to the expression
/// that produced it.
pub fn trace_nan(program: &Program, site: SiteId, inputs: &[f64]) -> Option<NanSource> {
    let site = program.sites.get(site.0 as usize)?;
    let mut lowering = Lowering::of_site(program, site);
    let outputs = outputs(&mut lowering, site).ok()?;
    if inputs.len() < lowering.inputs {
        return None;
    }
    let found = lowering.graph.first_nan(&outputs, inputs)?;
    let span = lowering.spans.get(found.origin as usize).copied().unwrap_or(site.span);
    let input = match found.node {
        Node::Symbol(index) => Some(index),
        _ => None,
    };
    let equation = lowering.equations.get(&found.origin).filter(|_| found.search.is_some());
    let equation = equation.and_then(|id| program.symbolic_functions.get(id.0 as usize));
    let equation = equation.map(|function| function.name.clone());
    Some(NanSource { span, made_by: nan::node_text(&found), input, equation })
}

/// Returns the numbers, followed by all their first time derivatives, and so on up to `order`.
fn with_derivatives(graph: &mut Graph, value: &[NodeId], order: usize) -> Vec<NodeId> {
    let mut outputs = value.to_vec();
    for at in 0..value.len() * order {
        let next = graph.derivative(outputs[at], TIME);
        outputs.push(next);
    }
    outputs
}

/// Limit of the nesting depth; larger than the limit of the checker.
const MOST_LEVELS: usize = 5000;
/// Limit of the operations in a kernel. Only repeated derivatives of long products reach it.
const MOST_OPERATIONS: usize = 2_000_000;

struct Lowering<'a> {
    graph: Graph,
    program: &'a Program,
    site_captures: &'a [Capture],
    /// For each capture, the index of its first number among the inputs.
    captures: Vec<u32>,
    inputs: usize,
    /// The source ranges of the lowered expressions, by the origin mark of their nodes.
    spans: Vec<Span>,
    /// The functions of `solve` and `minimize`, by the index of the span of the call.
    equations: HashMap<u32, SymbolicFunctionId>,
    /// The scopes of the expression being lowered: the site, then the called functions, innermost
    /// last.
    scopes: Vec<Scope<'a>>,
    /// Lowered bodies of symbolic functions, with free symbols for the arguments.
    functions: HashMap<SymbolicFunctionId, Vec<Free>>,
    /// Vectors that a frame transforms, with that frame.
    motions: HashMap<Vector3, Motion>,
    /// Input ranges of the captured expressions.
    parts: Vec<std::ops::Range<u32>>,
    /// The next symbol that is not an input: an argument of a symbolic function, substituted in
    /// calls.
    next_symbol: u32,
    level: usize,
}

impl<'a> Lowering<'a> {
    fn new(program: &'a Program, site_captures: &'a [Capture]) -> Self {
        let mut inputs = 1 + program.params.len();
        let mut captures = Vec::with_capacity(site_captures.len());
        for capture in site_captures {
            captures.push(inputs as u32);
            inputs += capture.inputs(program);
        }
        Lowering {
            graph: Graph::new(),
            program,
            site_captures,
            captures,
            inputs,
            spans: Vec::new(),
            equations: HashMap::new(),
            scopes: Vec::new(),
            functions: HashMap::new(),
            motions: HashMap::new(),
            parts: Vec::new(),
            next_symbol: inputs as u32,
            level: 0,
        }
    }

    fn of_site(program: &'a Program, site: &'a Site) -> Self {
        let mut lowering = Lowering::new(program, &site.captures);
        lowering.scopes.push(Scope::new(&site.shared, Vec::new()));
        lowering
    }

    fn value(&mut self, expr: &'a SymExpr) -> Result<Value, KernelError> {
        if self.level > MOST_LEVELS || self.graph.len() > MOST_OPERATIONS {
            return Err(KernelError {
                message: "this symbolic expression is too large to be compiled".into(),
                help: "differentiate less often, or compute parts of it with `=`".into(),
                span: expr.span,
            });
        }
        self.level += 1;
        let around = self.graph.set_origin(self.spans.len() as u32);
        self.spans.push(expr.span);
        let value = self.value_of(expr);
        self.graph.set_origin(around);
        self.level -= 1;
        value
    }

    fn value_of(&mut self, expr: &'a SymExpr) -> Result<Value, KernelError> {
        Ok(match &expr.kind {
            SymKind::Number(value) => Value::Number(self.graph.constant(*value)),
            SymKind::Bool(value) => Value::Number(self.graph.constant(if *value { 1.0 } else { 0.0 })),
            SymKind::Time => Value::Number(self.graph.symbol(TIME)),
            SymKind::Param(index) => {
                let symbol = self.symbol(Symbol::Param(*index), expr.span)?;
                Value::Number(self.graph.symbol(symbol))
            }
            SymKind::Capture(index) => self.capture(*index, expr.span)?,
            SymKind::Argument(index) => self.argument(*index, expr.span)?,
            SymKind::Shared(index) => self.shared(*index, expr.span)?,
            SymKind::Call(function, arguments) => {
                let arguments = arguments.iter().map(|a| self.value(a)).collect::<Result<Vec<_>, _>>()?;
                self.call(*function, &arguments, expr.span)?
            }
            SymKind::Solve(search, function, arguments) => {
                let arguments = arguments.iter().map(|a| self.value(a)).collect::<Result<Vec<_>, _>>()?;
                self.solution(*search, *function, &arguments, expr.span)?
            }
            SymKind::Table(table, x) => {
                let x = self.number(x)?;
                Value::Number(self.graph.piecewise(table, x))
            }
            SymKind::Brackets(parts) => {
                Value::Brackets(parts.iter().map(|part| self.value(part)).collect::<Result<_, _>>()?)
            }
            SymKind::Element(base, at) => match self.value(base)? {
                Value::Brackets(mut parts) if (*at as usize) < parts.len() => parts.swap_remove(*at as usize),
                _ => return Err(broken("no such element", expr.span)),
            },
            SymKind::Op(op, operands) => {
                let values = operands.iter().map(|o| self.value(o)).collect::<Result<Vec<_>, _>>()?;
                self.operation(*op, &values, expr.span)?
            }
            SymKind::If(condition, then, otherwise) => {
                let condition = self.number(condition)?;
                let (then, otherwise) = (self.value(then)?, self.value(otherwise)?);
                self.select(condition, then, otherwise, expr.span)?
            }
            SymKind::Derivative(inner, symbol) => {
                let value = self.value(inner)?;
                self.reject_observables(&value, inner.span)?;
                let symbol = self.symbol(*symbol, expr.span)?;
                self.derivative(value, symbol, expr.span)?
            }
            SymKind::At(inner, symbol, replacement) => {
                let (value, replacement) = (self.value(inner)?, self.number(replacement)?);
                let symbol = self.symbol(*symbol, expr.span)?;
                self.reject_parts_at(&value, symbol, inner.span)?;
                value.substituted(&mut self.graph, &[(symbol, replacement)])
            }
        })
    }

    fn number(&mut self, expr: &'a SymExpr) -> Result<NodeId, KernelError> {
        match self.value(expr)? {
            Value::Number(number) => Ok(number),
            _ => Err(broken("a number is needed here", expr.span)),
        }
    }

    fn derivative(&mut self, value: Value, symbol: u32, span: Span) -> Result<Value, KernelError> {
        Ok(match value {
            Value::Number(number) => Value::Number(self.graph.derivative(number, symbol)),
            Value::Vector(vector) => Value::Vector(self.vector_derivative(vector, symbol)),
            Value::Brackets(parts) => {
                let parts = parts.into_iter().map(|part| self.derivative(part, symbol, span));
                Value::Brackets(parts.collect::<Result<_, _>>()?)
            }
            Value::Frame(_) => {
                return Err(KernelError {
                    message: "the derivative of a frame is not a frame".into(),
                    help: "differentiate its origin(...) or direction(...), or use velocity(...), \
                           acceleration(...), angular_velocity(...)"
                        .into(),
                    span,
                });
            }
        })
    }

    fn symbol(&self, symbol: Symbol, span: Span) -> Result<u32, KernelError> {
        match symbol {
            Symbol::Time => Ok(TIME),
            Symbol::Argument(index) => self.argument_symbol(index, span),
            Symbol::Param(index) if (index as usize) < self.program.params.len() => Ok(1 + index),
            Symbol::Param(_) => Err(broken("no such param", span)),
        }
    }

    fn capture(&mut self, index: u32, span: Span) -> Result<Value, KernelError> {
        let place = index as usize;
        let (Some(capture), Some(&first)) = (self.site_captures.get(place), self.captures.get(place)) else {
            return Err(broken("no such capture", span));
        };
        if capture.observable {
            return Ok(Value::Number(self.graph.symbol(first)));
        }
        self.captured(&capture.repr, first, span)
    }

    /// Returns a captured value whose numbers are the inputs from `first` on.
    fn captured(&mut self, repr: &Repr, first: u32, span: Span) -> Result<Value, KernelError> {
        match repr {
            // No expression reads the text of a record.
            Repr::Number | Repr::Bool | Repr::String => Ok(Value::Number(self.graph.symbol(first))),
            Repr::Vector => Ok(Value::Vector([0, 1, 2].map(|i| self.graph.symbol(first + i)))),
            Repr::Symbolic(inner) => self.part(inner, first, span),
            Repr::Transform => {
                let pose: Pose = std::array::from_fn(|i| self.graph.symbol(first + i as u32));
                Ok(Value::Frame(Frame::from_pose(pose)))
            }
            Repr::Tuple(parts) => {
                let mut first = first;
                let mut values = Vec::with_capacity(parts.len());
                for part in parts {
                    values.push(self.captured(part, first, span)?);
                    first += captured_inputs(part, self.program) as u32;
                }
                Ok(Value::Brackets(values))
            }
            _ => Err(broken("a capture must be a number, truth value, vector, transform or record", span)),
        }
    }

    fn select(
        &mut self,
        condition: NodeId,
        then: Value,
        otherwise: Value,
        span: Span,
    ) -> Result<Value, KernelError> {
        let graph = &mut self.graph;
        Ok(match (then, otherwise) {
            (Value::Number(a), Value::Number(b)) => Value::Number(graph.select(condition, a, b)),
            (Value::Vector(a), Value::Vector(b)) => {
                Value::Vector([0, 1, 2].map(|i| graph.select(condition, a[i], b[i])))
            }
            (Value::Frame(a), Value::Frame(b)) => Value::Frame(Frame::select(graph, condition, &a, &b)),
            (Value::Brackets(a), Value::Brackets(b)) if a.len() == b.len() => {
                let parts = a.into_iter().zip(b).map(|(a, b)| self.select(condition, a, b, span));
                Value::Brackets(parts.collect::<Result<_, _>>()?)
            }
            _ => return Err(broken("both branches must be of one kind", span)),
        })
    }

    fn operation(&mut self, op: Op, operands: &[Value], span: Span) -> Result<Value, KernelError> {
        use Value::{Frame as F, Number as N, Vector as V};
        if matches!(op, Op::Velocity | Op::Acceleration | Op::AngularVelocity | Op::AngularAcceleration) {
            for operand in operands {
                self.reject_observables(operand, span)?;
            }
        }
        let carried = match (op, operands) {
            (Op::Apply, [F(frame), V(point)]) => Some((frame, TransformedQuantity::Point(*point))),
            (Op::Origin, [F(frame)]) => Some((frame, TransformedQuantity::Origin)),
            (Op::Direction, [F(frame), V(vector)]) => Some((frame, TransformedQuantity::Direction(*vector))),
            _ => None,
        };
        if let Some((frame, carried)) = carried {
            return Ok(V(self.carried(frame, carried)));
        }
        let g = &mut self.graph;
        let value = match (op, operands) {
            (_, [N(a)]) if let Some(unary) = unary(op) => N(g.unary(unary, *a)),
            (_, [N(a), N(b)]) if let Some(binary) = binary(op) => N(g.binary(binary, *a, *b)),
            (Op::Spline, [N(table), N(x)]) => N(g.lookup(0, *table, *x)),
            (Op::Greater, [N(a), N(b)]) => N(g.binary(Binary::Less, *b, *a)),
            (Op::GreaterEqual, [N(a), N(b)]) => N(g.binary(Binary::LessEqual, *b, *a)),
            (Op::Equal, [a, b]) if let Some(equal) = equal(g, a, b) => N(equal),
            (Op::NotEqual, [a, b]) if let Some(equal) = equal(g, a, b) => N(g.unary(Unary::Not, equal)),
            (Op::Vector, [N(a), N(b), N(c)]) => V([*a, *b, *c]),
            (Op::X, [V(a)]) => N(a[0]),
            (Op::Y, [V(a)]) => N(a[1]),
            (Op::Z, [V(a)]) => N(a[2]),
            (Op::Norm, [V(a)]) => N(g.norm(*a)),
            (Op::AddVector, [V(a), V(b)]) => V(g.add_vectors(*a, *b)),
            (Op::SubtractVector, [V(a), V(b)]) => V(g.subtract_vectors(*a, *b)),
            (Op::Cross, [V(a), V(b)]) => V(g.cross(*a, *b)),
            (Op::NegateVector, [V(a)]) => V(g.negate_vector(*a)),
            (Op::Scale, [N(a), V(b)]) => V(g.scale_vector(*a, *b)),
            (Op::Dot, [V(a), V(b)]) => N(g.dot(*a, *b)),
            (Op::Translate, [V(v)]) => F(Frame::translate(*v)),
            (Op::Rotate, [N(angle), V(axis)]) => F(Frame::rotate(*angle, *axis)),
            (Op::Compose, [F(a), F(b)]) => F(a.after(b)),
            (Op::Inverse, [F(frame)]) => F(frame.inverse(g)),
            (Op::Velocity, [F(frame)]) => V(frame.velocity(g, TIME)),
            (Op::Acceleration, [F(frame)]) => V(frame.acceleration(g, TIME)),
            (Op::AngularVelocity, [F(frame)]) => V(frame.angular_velocity(g, TIME)),
            (Op::AngularAcceleration, [F(frame)]) => V(frame.angular_acceleration(g, TIME)),
            _ => return Err(broken(&format!("operands do not fit {op:?}"), span)),
        };
        Ok(value)
    }

    /// Rejects the derivative of an expression with observables. Their values are updated at time
    /// steps and have no known derivative, so the result would silently be zero.
    fn reject_observables(&self, value: &Value, span: Span) -> Result<(), KernelError> {
        let observables: Vec<(u32, &str)> = self
            .site_captures
            .iter()
            .zip(&self.captures)
            .filter(|(capture, _)| capture.observable)
            .map(|(capture, &first)| (first, capture.name.as_str()))
            .collect();
        if observables.is_empty() {
            return Ok(());
        }
        let mut nodes = Vec::new();
        value.for_each(|node| nodes.push(node));
        for (input, name) in observables {
            if self.graph.depends_on(&nodes, |symbol| symbol == input) {
                return Err(KernelError {
                    message: format!(
                        "`{name}` has values only at solved steps, so it has no derivative here"
                    ),
                    help: "differentiate the series of results instead".into(),
                    span,
                });
            }
        }
        Ok(())
    }
}

/// Compares two values component by component. Returns `None` if they cannot be compared.
fn equal(graph: &mut Graph, a: &Value, b: &Value) -> Option<NodeId> {
    match (a, b) {
        (Value::Number(a), Value::Number(b)) => Some(graph.binary(Binary::Equal, *a, *b)),
        (Value::Vector(a), Value::Vector(b)) => {
            let [x, y, z] = [0, 1, 2].map(|i| graph.binary(Binary::Equal, a[i], b[i]));
            let first = graph.binary(Binary::And, x, y);
            Some(graph.binary(Binary::And, first, z))
        }
        _ => None,
    }
}

fn unary(op: Op) -> Option<Unary> {
    Some(match op {
        Op::Negate => Unary::Negate,
        Op::Not => Unary::Not,
        Op::Sqrt => Unary::Sqrt,
        Op::Abs => Unary::Abs,
        Op::Sin => Unary::Sin,
        Op::Cos => Unary::Cos,
        Op::Tan => Unary::Tan,
        Op::Asin => Unary::Asin,
        Op::Acos => Unary::Acos,
        Op::Atan => Unary::Atan,
        Op::Exp => Unary::Exp,
        Op::Log => Unary::Log,
        Op::Floor => Unary::Floor,
        Op::Ceil => Unary::Ceil,
        Op::Round => Unary::Round,
        _ => return None,
    })
}

fn binary(op: Op) -> Option<Binary> {
    Some(match op {
        Op::Add => Binary::Add,
        Op::Subtract => Binary::Subtract,
        Op::Multiply => Binary::Multiply,
        Op::Divide => Binary::Divide,
        Op::Power => Binary::Power,
        Op::Less => Binary::Less,
        Op::LessEqual => Binary::LessEqual,
        Op::Atan2 => Binary::Atan2,
        Op::Min => Binary::Min,
        Op::Max => Binary::Max,
        _ => return None,
    })
}

/// Returns the error for a program that the checker should have rejected.
fn broken(message: &str, span: Span) -> KernelError {
    KernelError { message: format!("ill-typed symbolic expression: {message}"), help: String::new(), span }
}
