//! Kernels of symbolic functions, and calls of symbolic functions in other expressions.
//!
//! A body is lowered once per graph, with free symbols for the numbers of its arguments. A call
//! substitutes the symbols. A derivative with respect to an argument inside the body is computed
//! before the substitution. An argument is therefore an independent variable within the function,
//! and the chain rule applies at the call, because the graph differentiates the substituted
//! expressions.
//!
//! A frame is passed as it is, with its factors. The body is lowered once for each frame, so its
//! velocity and its derivatives are those of rigid-body kinematics.

use super::{KernelError, Lowering, TIME, Value, broken};
use calyx_abi::Repr;
use calyx_abi::newton::Search;
use calyx_lang::ir::{Program, SymExpr, SymbolicFunction, SymbolicFunctionId};
use calyx_lang::span::Span;
use calyx_symbolic::{Frame, NodeId, Pose, Tape};

/// The site or function that contains an expression.
pub(super) struct Scope<'a> {
    shared: &'a [SymExpr],
    /// Values of the shared expressions lowered so far.
    values: Vec<Option<Value>>,
    arguments: Vec<Value>,
}

/// The body of a function, with free symbols for the numbers of its arguments.
#[derive(Clone)]
pub(super) struct Free {
    /// The frames among the arguments.
    frames: Vec<Frame>,
    /// The symbols of the numbers, in order.
    symbols: Vec<u32>,
    body: Value,
}

impl<'a> Scope<'a> {
    pub(super) fn new(shared: &'a [SymExpr], arguments: Vec<Value>) -> Self {
        Scope { shared, values: vec![None; shared.len()], arguments }
    }
}

/// Returns the kernel of a symbolic function.
///
/// Inputs: time; every param of the program by index (1 or 0 for a truth value; NaN for text, which
/// no expression reads); the arguments in order (a number or truth value takes one, a vector 3).
///
/// Outputs: the values of [`SymbolicFunction::result`] in order, the elements of brackets one after
/// the other (a number or truth value takes one, a vector 3, a transform 12: rotation row by row,
/// then translation).
///
/// # Errors
/// The expression has no meaning (the derivative of a frame, for example) or is too large.
pub fn lower_kernel(program: &Program, id: SymbolicFunctionId) -> Result<Tape, KernelError> {
    let function = program
        .symbolic_functions
        .get(id.0 as usize)
        .ok_or_else(|| broken("no such symbolic function", Span::default()))?;
    let mut lowering = Lowering::new(program, &[]);
    let body = lowering.free_body(function)?;
    let outputs = body.flat(&mut lowering.graph);
    Ok(lowering.graph.schedule(lowering.inputs, &outputs))
}

impl<'a> Lowering<'a> {
    /// Returns an argument with free symbols for its numbers, from `next_symbol` on. A frame is the
    /// given one; without one, it is a pose of free symbols, whose motion is unknown.
    fn free_argument(&mut self, repr: &Repr, given: Option<&Value>, symbols: &mut Vec<u32>) -> Value {
        let mut symbol = |lowering: &mut Self| {
            let symbol = lowering.next_symbol;
            lowering.next_symbol += 1;
            symbols.push(symbol);
            lowering.graph.symbol(symbol)
        };
        match (repr, given) {
            (Repr::Vector, _) => Value::Vector([(); 3].map(|()| symbol(self))),
            (Repr::Transform, Some(frame)) => frame.clone(),
            (Repr::Transform, None) => {
                let pose: Pose = [(); 12].map(|()| symbol(self));
                let unknown = self.unknown_rate(TIME);
                let parts: Vec<u32> = pose.iter().filter_map(|part| self.graph.symbol_index(*part)).collect();
                for part in parts {
                    self.graph.set_rate(part, TIME, unknown);
                }
                Value::Frame(Frame::from_pose(pose))
            }
            (Repr::Tuple(parts), given) => {
                let given = match given {
                    Some(Value::Brackets(given)) => given.as_slice(),
                    _ => &[],
                };
                let parts = parts.iter().enumerate();
                let parts = parts.map(|(at, part)| self.free_argument(part, given.get(at), symbols));
                Value::Brackets(parts.collect())
            }
            _ => Value::Number(symbol(self)),
        }
    }

    /// Lowers the body of a function for its own kernel: its arguments are the inputs that follow
    /// the existing ones.
    pub(super) fn free_body(&mut self, function: &'a SymbolicFunction) -> Result<Value, KernelError> {
        self.next_symbol = self.inputs as u32;
        let mut symbols = Vec::new();
        let arguments = function
            .parameters
            .iter()
            .map(|parameter| self.free_argument(&parameter.repr, None, &mut symbols))
            .collect();
        self.inputs += symbols.len();
        self.body(function, arguments)
    }

    fn body(&mut self, function: &'a SymbolicFunction, arguments: Vec<Value>) -> Result<Value, KernelError> {
        self.scopes.push(Scope::new(&function.shared, arguments));
        let value = self.value(&function.body);
        self.scopes.pop();
        value
    }

    /// Lowers a call of a symbolic function.
    pub(super) fn call(
        &mut self,
        id: SymbolicFunctionId,
        arguments: &[Value],
        span: Span,
    ) -> Result<Value, KernelError> {
        let mut frames = Vec::new();
        arguments.iter().for_each(|argument| argument.frames(&mut frames));
        let known = self.functions.get(&id).into_iter().flatten().find(|free| free.frames == frames);
        let free = match known {
            Some(free) => free.clone(),
            None => {
                let program = self.program;
                let function = program
                    .symbolic_functions
                    .get(id.0 as usize)
                    .ok_or_else(|| broken("no such symbolic function", span))?;
                let mut symbols = Vec::new();
                let parameters = function.parameters.iter().zip(arguments);
                let free = parameters
                    .map(|(parameter, given)| self.free_argument(&parameter.repr, Some(given), &mut symbols));
                let free = free.collect();
                let body = self.body(function, free)?;
                let free = Free { frames, symbols, body };
                self.functions.entry(id).or_default().push(free.clone());
                free
            }
        };
        let mut given = Vec::new();
        arguments.iter().for_each(|argument| argument.for_each_number(&mut |node| given.push(node)));
        if given.len() != free.symbols.len() {
            return Err(broken("arguments that do not fit the function", span));
        }
        let replacements: Vec<_> = free.symbols.iter().copied().zip(given).collect();
        let value = free.body.substituted(&mut self.graph, &replacements);
        self.carry_motion(&free.body, &value, &replacements);
        Ok(value)
    }

    /// Lowers `solve(f, guess, ...)` and `minimize(f, guess, ...)`: the unknown for which a
    /// symbolic function is zero or has a minimum. `given` are the guess and the other arguments of
    /// the function.
    pub(super) fn solution(
        &mut self,
        search: Search,
        id: SymbolicFunctionId,
        given: &[Value],
        span: Span,
    ) -> Result<Value, KernelError> {
        let (guess, others) = given.split_first().ok_or_else(|| broken("no guess", span))?;
        let origin = self.graph.set_origin(0);
        self.graph.set_origin(origin);
        self.equations.insert(origin, id);
        let mut symbols = Vec::new();
        let unknown = guess.map(&mut |_| {
            symbols.push(self.next_symbol);
            self.next_symbol += 1;
            self.graph.symbol(self.next_symbol - 1)
        });
        let arguments: Vec<Value> = std::iter::once(unknown).chain(others.iter().cloned()).collect();
        let residuals = self.call(id, &arguments, span)?.flat(&mut self.graph);
        let mut start = Vec::new();
        guess.for_each(|node| start.push(node));
        let independent = |residual: &NodeId| !self.graph.depends_on(&[*residual], |s| symbols.contains(&s));
        if residuals.iter().any(independent) {
            let what = match search {
                Search::Root => "equation",
                Search::Minimum => "function to minimize",
            };
            return Err(KernelError {
                message: format!("the {what} does not depend on the unknown"),
                help: "the first parameter of the function is the unknown; use it in the result".into(),
                span,
            });
        }
        let found = match (search, residuals.as_slice()) {
            (Search::Root, residuals) => self.graph.solve(&symbols, residuals, &start),
            (Search::Minimum, [objective]) => self.graph.minimize(&symbols, *objective, &start),
            (Search::Minimum, _) => None,
        };
        let mut found =
            found.ok_or_else(|| broken("equations and unknowns differ in number", span))?.into_iter();
        Ok(guess.map(&mut |node| found.next().unwrap_or(node)))
    }

    pub(super) fn argument(&self, index: u32, span: Span) -> Result<Value, KernelError> {
        let scope = self.scopes.last();
        scope
            .and_then(|scope| scope.arguments.get(index as usize))
            .cloned()
            .ok_or_else(|| broken("no such argument", span))
    }

    /// Returns the symbol of an argument that is a number.
    pub(super) fn argument_symbol(&self, index: u32, span: Span) -> Result<u32, KernelError> {
        match self.argument(index, span)? {
            Value::Number(node) => {
                self.graph.symbol_index(node).ok_or_else(|| broken("an argument that is not a symbol", span))
            }
            _ => Err(broken("an argument that is not a number", span)),
        }
    }

    /// Returns the value of a shared expression, which is lowered on first use.
    pub(super) fn shared(&mut self, index: u32, span: Span) -> Result<Value, KernelError> {
        let missing = || broken("no such shared expression", span);
        let scope = self.scopes.last().ok_or_else(missing)?;
        let shared = scope.shared;
        if let Some(known) = scope.values.get(index as usize).ok_or_else(missing)? {
            return Ok(known.clone());
        }
        let value = self.value(shared.get(index as usize).ok_or_else(missing)?)?;
        if let Some(place) = self.scopes.last_mut().and_then(|scope| scope.values.get_mut(index as usize)) {
            *place = Some(value.clone());
        }
        Ok(value)
    }
}
