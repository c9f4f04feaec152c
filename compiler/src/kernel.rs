//! Symbolic functions of a model as kernels of an embedding program: evaluation at one point or at
//! many.
//!
//! ```
//! let text = "
//! units mm_N_s;
//! param arm = 30 mm;
//! /// Position of the end of the arm, and its derivative by the angle.
//! function end(in turn) := [arm*cos(turn), derivative(arm*cos(turn), turn)];
//! ";
//! let checked = calyx::check_text("reach.cx", text);
//! assert!(!checked.has_errors(), "{}", checked.render());
//! let module = calyx::Module::from_checked(&calyx::Engine::default(), checked)?;
//! let end = module.kernel("end")?;
//! assert_eq!((end.arguments()[0].name.as_str(), end.outputs().len()), ("turn", 2));
//!
//! // Numbers are in coherent SI units; `unit` and `factor` describe the model's unit.
//! let params = module.param_values(&[("arm", "40 mm")])?;
//! assert_eq!(end.evaluate(&params, &[0.0])?, [0.04, 0.0]);
//! assert_eq!((end.outputs()[0].unit.as_str(), end.outputs()[0].factor), ("mm", 0.001));
//!
//! // Columns in, columns out: each point is bitwise equal to `evaluate`.
//! let turns = [0.0, 0.1, 0.2];
//! let (mut x, mut slope) = ([0.0; 3], [0.0; 3]);
//! end.batch(&params, &[&turns], &mut [&mut x, &mut slope])?;
//! assert_eq!([x[2], slope[2]], *end.evaluate(&params, &[0.2])?);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use crate::module::Module;
use calyx_abi::{Context, Kernel as CompiledKernel, Repr};
use calyx_codegen::{BatchError, BatchKernel, CodegenError, compile_batch, compile_kernel};
use calyx_gears::host::ModelHost;
use calyx_lang::ir::{DisplayUnit, SymbolicFunction, SymbolicFunctionId};
use calyx_lower::kernels::{KernelError as LoweringError, lower_kernel};
use calyx_rt::ParamAssignment;
use calyx_symbolic::{Instruction, Tape};
use std::fmt;
use std::sync::{Arc, OnceLock};

/// Component names of a vector, and of a transform: rotation row by row, then translation.
const COMPONENTS: [&str; 3] = ["e1", "e2", "e3"];
const ENTRIES: [&str; 12] = ["11", "12", "13", "21", "22", "23", "31", "32", "33", "t1", "t2", "t3"];

/// Error of the compilation or evaluation of a kernel.
#[derive(Debug)]
pub enum KernelError {
    /// The model has no symbolic function of this name; lists its kernels.
    Unknown {
        name: String,
        kernels: Vec<String>,
    },
    /// The function is not valid as an expression.
    Expression(LoweringError),
    Code(CodegenError),
    /// A param could not be set.
    Param(calyx_rt::Error),
    /// The number of params or arguments differs from that of the kernel.
    Count {
        what: &'static str,
        given: usize,
        expected: usize,
    },
    /// The sizes of columns are wrong.
    Batch(BatchError),
}

impl fmt::Display for KernelError {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            KernelError::Unknown { name, kernels } if kernels.is_empty() => {
                write!(f, "there is no symbolic function `{name}`; the model has none")
            }
            KernelError::Unknown { name, kernels } => {
                write!(f, "there is no symbolic function `{name}`; the model has {}", kernels.join(", "))
            }
            KernelError::Expression(error) => error.fmt(f),
            KernelError::Code(error) => error.fmt(f),
            KernelError::Param(error) => f.write_str(error.message()),
            KernelError::Count { what, given, expected } => {
                write!(f, "{given} {what} given, the kernel has {expected}")
            }
            KernelError::Batch(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for KernelError {}

impl From<CodegenError> for KernelError {
    fn from(error: CodegenError) -> Self {
        KernelError::Code(error)
    }
}

/// Number of the input or output, with its unit in the model: SI value = shown value * `factor`.
#[derive(Clone, Debug, PartialEq)]
pub struct Quantity {
    /// Name of an argument, or position of a result in the brackets, with the suffix `.e1` and so
    /// on for the components of a vector, `.11` ... `.33`, `.t1` ... for those of a transform
    /// (rotation row by row, then translation).
    pub name: String,
    /// Unit, such as `lbf*inch`; empty for a dimensionless number.
    pub unit: String,
    pub factor: f64,
}

/// Compiled symbolic function. Several threads can evaluate it at the same time, and it outlives
/// its module.
pub struct Kernel {
    name: String,
    doc: String,
    arguments: Vec<Quantity>,
    outputs: Vec<Quantity>,
    params: usize,
    /// True if the kernel depends on time, which is then the first argument.
    moves: bool,
    tape: Tape,
    compiled: Arc<dyn CompiledKernel>,
    /// Kernel for batches, created at the first batch.
    batch: OnceLock<Result<BatchKernel, String>>,
}

impl Module {
    /// Returns the names of the symbolic functions that [`Module::kernel`] accepts, in source
    /// order.
    pub fn kernel_names(&self) -> Vec<&str> {
        let functions = self.program().map_or(&[][..], |program| &program.symbolic_functions);
        functions.iter().filter(|f| f.exported).map(|f| f.name.as_str()).collect()
    }

    /// Compiles a symbolic function of the model's top level.
    ///
    /// # Errors
    /// If there is no function of this name, or it is not valid as an expression.
    pub fn kernel(&self, name: &str) -> Result<Kernel, KernelError> {
        let found = self.program().and_then(|program| {
            let mut functions = (0..).zip(&program.symbolic_functions);
            functions.find(|(_, f)| f.exported && f.name == name).map(|found| (program, found))
        });
        let Some((program, (index, function))) = found else {
            let kernels = self.kernel_names().into_iter().map(str::to_owned).collect();
            return Err(KernelError::Unknown { name: name.to_owned(), kernels });
        };
        let tape = lower_kernel(program, SymbolicFunctionId(index)).map_err(KernelError::Expression)?;
        Kernel::new(function, program.params.len(), tape)
    }

    /// Returns values of all params for [`Kernel::evaluate`]: those given by name and text, as for
    /// a run, and defaults. A string param is NaN.
    ///
    /// # Errors
    /// If a name is unknown, a value cannot be read or is out of range, or a default fails.
    pub fn param_values(&self, given: &[(&str, &str)]) -> Result<Vec<f64>, KernelError> {
        let given: Vec<_> = given.iter().map(|(name, text)| ParamAssignment::text(*name, *text)).collect();
        let mut context = Context::new(Box::new(ModelHost::new(self.description())));
        calyx_rt::apply(self.as_program().as_ref(), &given, &mut context).map_err(KernelError::Param)?;
        Ok(context.params)
    }
}

impl Kernel {
    fn new(function: &SymbolicFunction, params: usize, tape: Tape) -> Result<Self, KernelError> {
        let moves = tape.instructions.contains(&Instruction::Input(0));
        let second = Quantity { name: "Time".into(), unit: "s".into(), factor: 1.0 };
        let mut arguments = if moves { vec![second] } else { Vec::new() };
        for parameter in &function.parameters {
            quantities(&parameter.repr, &parameter.name, &mut [&parameter.unit].into_iter(), &mut arguments);
        }
        let mut outputs = Vec::new();
        quantities(&function.result, "", &mut function.units.iter(), &mut outputs);
        let compiled = compile_kernel(&tape)?;
        Ok(Kernel {
            name: function.name.clone(),
            doc: function.doc.clone(),
            arguments,
            outputs,
            params,
            moves,
            tape,
            compiled,
            batch: OnceLock::new(),
        })
    }

    pub fn name(&self) -> &str {
        &self.name
    }

    /// Returns the doc comment of the function; empty if it has none.
    pub fn doc(&self) -> &str {
        &self.doc
    }

    /// Returns the arguments, in order. The first is `Time` if the kernel depends on time.
    pub fn arguments(&self) -> &[Quantity] {
        &self.arguments
    }

    /// Returns the results, in order.
    pub fn outputs(&self) -> &[Quantity] {
        &self.outputs
    }

    /// Returns the number of arithmetic operations and calls of an evaluation.
    pub fn operations(&self) -> usize {
        self.tape.operations()
    }

    /// Evaluates at one point. All numbers are in coherent SI units; `params` is the result of
    /// [`Module::param_values`].
    ///
    /// # Errors
    /// If the number of params or arguments differs from that of the kernel.
    pub fn evaluate(&self, params: &[f64], arguments: &[f64]) -> Result<Vec<f64>, KernelError> {
        self.check(params, arguments.len())?;
        let mut inputs = Vec::with_capacity(self.tape.inputs);
        if !self.moves {
            inputs.push(0.0);
        }
        inputs.extend(arguments.iter().take(usize::from(self.moves)));
        inputs.extend(params);
        inputs.extend(arguments.iter().skip(usize::from(self.moves)));
        let mut outputs = vec![0.0; self.outputs.len()];
        self.compiled.eval(&inputs, &mut outputs);
        Ok(outputs)
    }

    /// Evaluates at many points, with one column of numbers per argument and one column to fill per
    /// output, all of equal length. Each point is bitwise equal to the result of
    /// [`Kernel::evaluate`]. To use several processors, divide the points among threads.
    ///
    /// # Errors
    /// If counts or lengths do not match; nothing is written in this case.
    pub fn batch(
        &self,
        params: &[f64],
        columns: &[&[f64]],
        outputs: &mut [&mut [f64]],
    ) -> Result<(), KernelError> {
        self.check(params, columns.len())?;
        let compiled = self.batch.get_or_init(|| {
            let mut varying = vec![false; 1 + self.params];
            varying[0] = self.moves;
            varying.resize(self.tape.inputs, true);
            compile_batch(&self.tape, &varying).map_err(|error| error.to_string())
        });
        let kernel = compiled
            .as_ref()
            .map_err(|message| KernelError::Code(CodegenError::Cranelift(message.clone())))?;
        // Time is a uniform argument even if nothing depends on it.
        let still = [0.0];
        let uniforms: Vec<f64> = still.iter().skip(usize::from(self.moves)).chain(params).copied().collect();
        kernel.evaluate(&uniforms, columns, outputs).map_err(KernelError::Batch)
    }

    fn check(&self, params: &[f64], arguments: usize) -> Result<(), KernelError> {
        for (what, given, expected) in
            [("params", params.len(), self.params), ("arguments", arguments, self.arguments.len())]
        {
            if given != expected {
                return Err(KernelError::Count { what, given, expected });
            }
        }
        Ok(())
    }
}

impl fmt::Debug for Kernel {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.debug_struct("Kernel")
            .field("name", &self.name)
            .field("arguments", &self.arguments)
            .field("outputs", &self.outputs)
            .finish_non_exhaustive()
    }
}

/// Returns the numbers of a value; `units` has one entry per component that is not a tuple.
fn quantities<'u>(
    repr: &Repr,
    name: &str,
    units: &mut impl Iterator<Item = &'u DisplayUnit>,
    into: &mut Vec<Quantity>,
) {
    // A stack instead of recursion: results may be nested brackets.
    let mut pending = vec![(repr, name.to_owned())];
    while let Some((repr, name)) = pending.pop() {
        if let Repr::Tuple(parts) = repr {
            let inner = |at: usize| if name.is_empty() { at.to_string() } else { format!("{name}.{at}") };
            pending.extend(parts.iter().enumerate().map(|(at, part)| (part, inner(at))).rev());
            continue;
        }
        let unit = units.next();
        let (unit, factor) = unit.map_or(("", 1.0), |unit| (unit.name.as_str(), unit.factor));
        let mut push = |name: String, unit: &str, factor| {
            into.push(Quantity { name, unit: unit.to_owned(), factor });
        };
        match repr {
            Repr::Vector => COMPONENTS.iter().for_each(|part| push(join(&name, part), unit, factor)),
            Repr::Transform => {
                for (at, part) in ENTRIES.iter().enumerate() {
                    let (unit, factor) = if at < 9 { ("", 1.0) } else { (unit, factor) };
                    push(join(&name, part), unit, factor);
                }
            }
            _ => push(name, unit, factor),
        }
    }
}

fn join(name: &str, part: &str) -> String {
    if name.is_empty() { part.to_owned() } else { format!("{name}.{part}") }
}
