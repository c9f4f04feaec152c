//! Kernels of symbolic functions, and calls of symbolic functions in other expressions.
//!
//! A body is lowered once per graph, with free symbols for its arguments. A call substitutes the
//! symbols. A derivative with respect to an argument inside the body is computed before the
//! substitution. An argument is therefore an independent variable within the function, and the
//! chain rule applies at the call, because the graph differentiates the substituted expressions.

use super::{KernelError, Lowering, Value, broken};
use calyx_abi::Repr;
use calyx_lang::ir::{Program, SymExpr, SymbolicFunction, SymbolicFunctionId, SymbolicParameter};
use calyx_lang::span::Span;
use calyx_symbolic::Tape;

/// The site or function that contains an expression.
pub(super) struct Scope<'a> {
    shared: &'a [SymExpr],
    /// Values of the shared expressions lowered so far.
    values: Vec<Option<Value>>,
    arguments: Vec<Value>,
}

/// The body of a function, with free symbols for its arguments.
#[derive(Clone)]
pub(super) struct Free {
    /// The symbols of its arguments' components, in order.
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
    /// Creates symbols from `first` on for arguments, and returns them together with the arguments
    /// as values.
    fn free_arguments(&mut self, parameters: &[SymbolicParameter], first: u32) -> (Vec<u32>, Vec<Value>) {
        let mut symbols = Vec::new();
        let mut symbol = |graph: &mut calyx_symbolic::Graph| {
            let symbol = first + symbols.len() as u32;
            symbols.push(symbol);
            graph.symbol(symbol)
        };
        let graph = &mut self.graph;
        let arguments = parameters.iter().map(|parameter| match parameter.repr {
            Repr::Vector => Value::Vector([(); 3].map(|()| symbol(graph))),
            _ => Value::Number(symbol(graph)),
        });
        let arguments = arguments.collect();
        (symbols, arguments)
    }

    /// Lowers the body of a function for its own kernel: its arguments are the inputs that follow
    /// the existing ones.
    pub(super) fn free_body(&mut self, function: &'a SymbolicFunction) -> Result<Value, KernelError> {
        let first = self.inputs as u32;
        let (symbols, arguments) = self.free_arguments(&function.parameters, first);
        self.inputs += symbols.len();
        self.next_symbol = self.inputs as u32;
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
        let free = match self.functions.get(&id) {
            Some(free) => free.clone(),
            None => {
                let program = self.program;
                let function = program
                    .symbolic_functions
                    .get(id.0 as usize)
                    .ok_or_else(|| broken("no such symbolic function", span))?;
                let (symbols, free) = self.free_arguments(&function.parameters, self.next_symbol);
                self.next_symbol += symbols.len() as u32;
                let body = self.body(function, free)?;
                let free = Free { symbols, body };
                self.functions.insert(id, free.clone());
                free
            }
        };
        let mut given = Vec::new();
        arguments.iter().for_each(|argument| argument.for_each(|node| given.push(node)));
        if given.len() != free.symbols.len() {
            return Err(broken("arguments that do not fit the function", span));
        }
        let replacements: Vec<_> = free.symbols.iter().copied().zip(given).collect();
        let value = free.body.substituted(&mut self.graph, &replacements);
        self.carry_motion(&free.body, &value, &replacements);
        Ok(value)
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
