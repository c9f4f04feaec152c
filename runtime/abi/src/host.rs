//! Host functions: functions that the embedding program provides in place of the model's own.
//!
//! A model declares `host function friction(in v: Velocity) -> Number { return 0.05; }`. A call
//! first queries the context ([`HostFunctions`]); if the function is not provided, its body runs.
//! Closures of ordinary types are host functions:
//!
//! ```
//! use calyx_abi::host::HostFunctions;
//! let mut functions = HostFunctions::default();
//! functions.add("friction", |v: f64| 0.05 / (1.0 + v.abs()));
//! functions.add("lookup", |name: String, at: Vec<f64>| match name.as_str() {
//!     "steel" => Ok(at.iter().sum::<f64>()),
//!     other => Err(format!("there is no material `{other}`")),
//! });
//! assert_eq!(functions.names().collect::<Vec<_>>(), ["friction", "lookup"]);
//! ```
//!
//! Numbers are in coherent SI units. An error or a panic of the closure is an error of the model at
//! the call, which the model may catch.

use crate::call::{Repr, Slot};
use crate::context::{Context, RuntimeError, codes};
use crate::description::{HostFunctionDescription, HostValueDescription};
use crate::externs::Value;
use crate::helpers::malformed;
use crate::limits;
use std::collections::BTreeMap;
use std::fmt;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;

/// Call of a host function.
pub struct HostCall<'c> {
    context: &'c mut Context,
    arguments: &'c [Slot],
    result: &'c mut [Slot],
}

impl HostCall<'_> {
    /// Returns the next argument, in order of the declaration.
    ///
    /// # Errors
    /// Internal if it has another type.
    pub fn argument<T: Value>(&mut self) -> Result<T, RuntimeError> {
        let split = self.arguments.split_at_checked(T::SHAPE.slots());
        let (now, rest) = split.ok_or_else(|| malformed("a host function with fewer arguments"))?;
        self.arguments = rest;
        T::read(self.context, now).ok_or_else(|| malformed("an argument of another type"))
    }

    /// Sets the result.
    ///
    /// # Errors
    /// Internal if it has another type.
    pub fn give<T: Value>(&mut self, value: T) -> Result<(), RuntimeError> {
        if self.result.len() != T::SHAPE.slots() {
            return Err(malformed("a host function with another result"));
        }
        value.write(self.context, self.result);
        Ok(())
    }

    /// Returns the slots of all arguments that were not taken, and those of the result, for callers
    /// whose types are known only at run time. A number is the bits of an `f64`, a Boolean 0 or 1,
    /// a vector three numbers.
    pub fn slots(&mut self) -> (&[Slot], &mut [Slot]) {
        (self.arguments, self.result)
    }
}

/// Host function of the embedding program. [`HostClosure`] creates one from a closure.
pub trait HostFunction: Send + Sync {
    /// Takes the arguments and sets the result.
    ///
    /// # Errors
    /// The reason why there is no result: an error of the model at the call.
    fn call(&self, call: &mut HostCall) -> Result<(), RuntimeError>;
}

/// Returns the error of a host function.
pub fn failed(message: impl Into<String>) -> RuntimeError {
    RuntimeError::new(codes::HOST, message, "the program that runs the model provides this function")
}

/// Return type of a closure: a value, or a `Result` whose error implements `Display`.
pub trait HostResult {
    type Value: Value;

    /// Converts to the value.
    ///
    /// # Errors
    /// The error of the closure.
    fn into_value(self) -> Result<Self::Value, RuntimeError>;
}

impl<T: Value> HostResult for T {
    type Value = T;
    fn into_value(self) -> Result<T, RuntimeError> {
        Ok(self)
    }
}

impl<T: Value, E: fmt::Display> HostResult for Result<T, E> {
    type Value = T;
    fn into_value(self) -> Result<T, RuntimeError> {
        self.map_err(|error| failed(error.to_string()))
    }
}

/// Closure of up to six arguments (`f64`, `bool`, `String`, `[f64; 3]`, or a `Vec` of these) that
/// returns one of these or a `Result` of one. The compiler infers `Signature`.
pub trait HostClosure<Signature>: Send + Sync + 'static {
    /// Returns the closure with its types.
    fn provided(self) -> Provided;
}

/// Host function with its types.
#[derive(Clone)]
pub struct Provided {
    parameters: Vec<Repr>,
    result: Repr,
    call: Arc<dyn HostFunction>,
}

impl Provided {
    /// Creates a function whose types are known only at run time.
    pub fn new(parameters: Vec<Repr>, result: Repr, call: Arc<dyn HostFunction>) -> Provided {
        Provided { parameters, result, call }
    }
}

/// Formats the types like a closure: `|f64, Vec<f64>| -> f64`.
impl fmt::Display for Provided {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write_closure(f, &self.parameters, &self.result)
    }
}

fn write_closure(f: &mut impl fmt::Write, parameters: &[Repr], result: &Repr) -> fmt::Result {
    let parameters: Vec<String> = parameters.iter().map(rust_type).collect();
    write!(f, "|{}| -> {}", parameters.join(", "), rust_type(result))
}

/// Returns the Rust type of a representation.
fn rust_type(repr: &Repr) -> String {
    match repr {
        Repr::Unit => "()".into(),
        Repr::Number => "f64".into(),
        Repr::Bool => "bool".into(),
        Repr::String => "String".into(),
        Repr::Vector => "[f64; 3]".into(),
        Repr::Array(element) => format!("Vec<{}>", rust_type(element)),
        other => format!("{other:?}"),
    }
}

macro_rules! closures {
    ($(($($argument:ident),*))+) => { $(
        impl<F, R, $($argument),*> HostClosure<fn($($argument),*) -> R> for F
        where
            F: Fn($($argument),*) -> R + Send + Sync + 'static,
            R: HostResult + 'static,
            $($argument: Value + 'static),*
        {
            fn provided(self) -> Provided {
                struct Typed<F, S>(F, std::marker::PhantomData<S>);
                impl<F, R, $($argument),*> HostFunction for Typed<F, fn($($argument),*) -> R>
                where
                    F: Fn($($argument),*) -> R + Send + Sync,
                    R: HostResult,
                    $($argument: Value),*
                {
                    #[allow(non_snake_case, reason = "values are named after their types")]
                    fn call(&self, call: &mut HostCall) -> Result<(), RuntimeError> {
                        $(let $argument: $argument = call.argument()?;)*
                        let value = (self.0)($($argument),*).into_value()?;
                        call.give(value)
                    }
                }
                Provided {
                    parameters: vec![$(<$argument as Value>::SHAPE.repr()),*],
                    result: <R::Value as Value>::SHAPE.repr(),
                    call: Arc::new(Typed::<F, fn($($argument),*) -> R>(self, std::marker::PhantomData)),
                }
            }
        }
    )+ };
}

closures! { () (A) (A, B) (A, B, C) (A, B, C, D) (A, B, C, D, E) (A, B, C, D, E, G) }

/// Host functions of an embedding program, by name. Cheap to clone.
#[derive(Clone, Default)]
pub struct HostFunctions(Arc<BTreeMap<String, Provided>>);

/// Mismatch between provided functions and a model.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct HostMismatch {
    pub message: String,
    /// Remedy.
    pub help: String,
}

/// Provided host functions of a model, in the order of its description.
pub type Resolved = Arc<[Option<Arc<dyn HostFunction>>]>;

impl HostFunctions {
    /// Provides a closure in place of the model's function of this name, and of one provided
    /// before.
    pub fn add<S>(&mut self, name: impl Into<String>, closure: impl HostClosure<S>) {
        self.add_provided(name, closure.provided());
    }

    /// Provides a function whose types are known only at run time, like [`HostFunctions::add`].
    pub fn add_provided(&mut self, name: impl Into<String>, function: Provided) {
        Arc::make_mut(&mut self.0).insert(name.into(), function);
    }

    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.0.keys().map(String::as_str)
    }

    /// Selects the functions that a model calls.
    ///
    /// # Errors
    /// The model has no such function, or one with other arguments or another result.
    pub fn resolve(&self, functions: &[HostFunctionDescription]) -> Result<Resolved, HostMismatch> {
        for (name, provided) in self.0.iter() {
            match functions.iter().find(|function| function.name == *name) {
                Some(function) => fits(function, provided)?,
                None => return Err(unknown(name, functions)),
            }
        }
        let provided = functions.iter().map(|function| Some(self.0.get(&function.name)?.call.clone()));
        Ok(provided.collect())
    }
}

fn unknown(name: &str, functions: &[HostFunctionDescription]) -> HostMismatch {
    let names: Vec<String> = functions.iter().map(|function| format!("`{}`", function.name)).collect();
    let help = match names.as_slice() {
        [] => format!("declare it in the model: `host function {name}(...) -> ... {{ ... }}`"),
        names => format!("its host functions are {}", names.join(", ")),
    };
    HostMismatch { message: format!("the model has no host function `{name}`"), help }
}

fn fits(function: &HostFunctionDescription, provided: &Provided) -> Result<(), HostMismatch> {
    let declared: Vec<Repr> = function.parameters.iter().map(|parameter| parameter.repr.clone()).collect();
    if declared == provided.parameters && function.result.repr == provided.result {
        return Ok(());
    }
    let mut expected = String::new();
    // Writing to a string cannot fail.
    let _ = write_closure(&mut expected, &declared, &function.result.repr);
    Err(HostMismatch {
        message: format!("`{}` is given as `{provided}`, and the model declares `{function}`", function.name),
        help: format!("give a closure `{expected}`; numbers are in SI units"),
    })
}

/// Formats the declaration: `host function friction(in v: Velocity) -> Number`.
impl fmt::Display for HostFunctionDescription {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let parameter = |value: &HostValueDescription| format!("in {}: {}", value.name, value.ty);
        let parameters: Vec<String> = self.parameters.iter().map(parameter).collect();
        write!(f, "host function {}({}) -> {}", self.name, parameters.join(", "), self.result.ty)
    }
}

/// Calls a host function if it is provided; returns whether it was called. Otherwise the result is
/// unchanged.
///
/// # Errors
/// Those of the function, including its panics, or the cancellation of the run.
pub fn ask(
    context: &mut Context,
    function: usize,
    arguments: &[Slot],
    result: &mut [Slot],
) -> Result<bool, RuntimeError> {
    let Some(Some(provided)) = context.host_functions.get(function).cloned() else { return Ok(false) };
    limits::check(context)?;
    let mut call = HostCall { context, arguments, result };
    // A panic may leave only the closure's own state inconsistent; it accesses the context only
    // through the call.
    let called = catch_unwind(AssertUnwindSafe(|| provided.call(&mut call)));
    called.unwrap_or_else(|payload| {
        Err(failed(format!("the function panicked: {}", crate::stack::panic_message(payload.as_ref()))))
    })?;
    limits::check_memory(context)?;
    Ok(true)
}

#[cfg(test)]
#[path = "host_tests.rs"]
mod tests;
