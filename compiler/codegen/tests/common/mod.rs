//! Typed programs written by hand, run by the interpreter and as machine code, and compared bit by
//! bit.

pub mod text;

use calyx_abi::host::HostFunctions;
use calyx_abi::{Context, Extern, Kernel, Purity, Repr, RuntimeError, Slot};
use calyx_codegen::{JitModule, TargetCpu, compile_code, compile_jit, load_code};
use calyx_lang::ir::*;
use calyx_lang::span::{FileId, Span};
use calyx_lower::interpret::Interpreter;
use calyx_lower::kernels::lower_sites;
use calyx_symbolic::TapeKernel;
use std::sync::{Arc, Mutex};

pub const N: Repr = Repr::Number;
pub const B: Repr = Repr::Bool;
pub const S: Repr = Repr::String;
pub const V: Repr = Repr::Vector;
pub const T: Repr = Repr::Transform;

pub fn array_of(element: Repr) -> Repr {
    Repr::Array(Box::new(element))
}

pub fn span(start: u32) -> Span {
    Span { file: FileId(0), start, end: start + 1 }
}

pub fn expr(kind: ExprKind, repr: Repr) -> Expr {
    Expr { kind, repr, span: Span::default() }
}

/// Returns the expression with a source location.
pub fn at(start: u32, expr: Expr) -> Expr {
    Expr { span: span(start), ..expr }
}

pub fn number(value: f64) -> Expr {
    expr(ExprKind::Number(value), N)
}

pub fn truth(value: bool) -> Expr {
    expr(ExprKind::Bool(value), B)
}

pub fn string(text: &str) -> Expr {
    expr(ExprKind::String(text.into()), S)
}

pub fn local(index: u32, repr: Repr) -> Expr {
    expr(ExprKind::Local(LocalId(index)), repr)
}

/// Returns the value of a number local.
pub fn n(index: u32) -> Expr {
    local(index, N)
}

pub fn op(op: Op, operands: Vec<Expr>) -> Expr {
    let result = signature(op).1;
    expr(ExprKind::Op(op, operands), result)
}

pub fn add(a: Expr, b: Expr) -> Expr {
    op(Op::Add, vec![a, b])
}

pub fn less(a: Expr, b: Expr) -> Expr {
    op(Op::Less, vec![a, b])
}

pub fn array(element: Repr, elements: Vec<Expr>) -> Expr {
    expr(ExprKind::Array(elements), array_of(element))
}

pub fn index(array: Expr, index: Expr) -> Expr {
    let Repr::Array(element) = array.repr.clone() else { panic!("not an array") };
    expr(ExprKind::Index(Box::new(array), Box::new(index)), *element)
}

pub fn tuple(elements: Vec<Expr>) -> Expr {
    let repr = Repr::Tuple(elements.iter().map(|element| element.repr.clone()).collect());
    expr(ExprKind::Tuple(elements), repr)
}

pub fn call(function: u32, arguments: Vec<Expr>, result: Repr) -> Expr {
    expr(ExprKind::Call(FunctionId(function), arguments), result)
}

pub fn call_extern(index: u32, arguments: Vec<Expr>, result: Repr) -> Expr {
    expr(ExprKind::CallExtern(ExternId(index), arguments), result)
}

pub fn place(index: u32, indices: Vec<Expr>, repr: Repr) -> Place {
    Place { local: LocalId(index), steps: indices.into_iter().map(Step::Index).collect(), repr }
}

pub fn assign(target: u32, value: Expr) -> Statement {
    Statement::Assign { place: place(target, vec![], value.repr.clone()), value, span: Span::default() }
}

pub fn assign_element(target: u32, indices: Vec<Expr>, value: Expr) -> Statement {
    Statement::Assign { place: place(target, indices, value.repr.clone()), value, span: Span::default() }
}

pub fn jump(block: u32) -> Terminator {
    Terminator::Jump(BlockId(block))
}

pub fn branch(condition: Expr, then: u32, otherwise: u32) -> Terminator {
    Terminator::Branch { condition, then: BlockId(then), otherwise: BlockId(otherwise) }
}

pub fn ret(value: Expr) -> Terminator {
    Terminator::Return(Some(value))
}

pub fn block(statements: Vec<Statement>, terminator: Terminator) -> Block {
    Block { statements, terminator, handler: None, span: span(800) }
}

/// Returns a function whose first locals are its parameters.
pub fn function(parameters: &[Mode], locals: Vec<Repr>, result: Repr, blocks: Vec<Block>) -> Function {
    let name = |(index, repr)| Local { name: format!("x{index}"), repr };
    Function {
        name: "f".into(),
        parameters: (0..).map(LocalId).zip(parameters.iter().copied()).collect(),
        result,
        locals: locals.into_iter().enumerate().map(name).collect(),
        blocks,
        span: span(900),
    }
}

/// Returns a program that starts with its first function.
pub fn program(functions: Vec<Function>) -> Program {
    Program { functions, ..Program::default() }
}

/// Returns a program whose only function runs some statements and then evaluates an expression.
pub fn evaluates(locals: Vec<Repr>, statements: Vec<Statement>, value: Expr) -> Program {
    let result = value.repr.clone();
    program(vec![function(&[], locals, result, vec![block(statements, ret(value))])])
}

/// Returns the representations of an operation's operands and result.
pub fn signature(op: Op) -> (Vec<Repr>, Repr) {
    use Op::*;
    match op {
        Add | Subtract | Multiply | Divide | Power | Spline | Atan2 | Min | Max => (vec![N, N], N),
        Negate | Sqrt | Abs | Sin | Cos | Tan | Asin | Acos | Atan | Exp | Log | Floor | Ceil | Round => {
            (vec![N], N)
        }
        Not => (vec![B], B),
        Less | LessEqual | Greater | GreaterEqual | Equal | NotEqual => (vec![N, N], B),
        Vector => (vec![N, N, N], V),
        X | Y | Z | Norm => (vec![V], N),
        AddVector | SubtractVector | Cross => (vec![V, V], V),
        NegateVector => (vec![V], V),
        Scale => (vec![N, V], V),
        Dot => (vec![V, V], N),
        Translate => (vec![V], T),
        Rotate => (vec![N, V], T),
        Compose => (vec![T, T], T),
        Apply | Direction => (vec![T, V], V),
        Inverse => (vec![T], T),
        Origin => (vec![T], V),
        Velocity | Acceleration | AngularVelocity | AngularAcceleration => (vec![T], V),
    }
}

calyx_abi::externs! {
    /// Fails for negative numbers, with the error at the argument.
    Pure fn calyx_test_root(_context, scale: f64, x: f64) -> f64 {
        if x < 0.0 {
            let error = RuntimeError::new("E0999", "negative", "");
            return Err(RuntimeError { argument: Some("x".into()), ..error });
        }
        Ok(scale * x.sqrt())
    }

    /// Panics.
    Scene fn calyx_test_panic(_context) -> () { panic!("broken") }

    /// Has an effect, and a result on the heap.
    Effect fn calyx_test_effect(context, line: String) -> String {
        (context.print)(&line);
        Ok("done".into())
    }
}

/// Returns the functions that the engine of these tests provides.
pub fn externs() -> Vec<Extern> {
    [EXTERNS, calyx_abi::standard::EXTERNS].concat()
}

/// Declares all of [`externs`] in a program, in order.
pub fn with_externs(mut program: Program) -> Program {
    let declare = |row: Extern| ExternDecl {
        symbol: row.symbol.into(),
        name: row.symbol.into(),
        purity: row.purity,
        parameters: row.params.iter().map(|(name, shape)| (name.to_string(), shape.repr())).collect(),
        result: row.result.repr(),
        span: Span::default(),
    };
    program.externs = externs().into_iter().map(declare).collect();
    program
}

/// The result of a run, in comparable form.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// Slots of the results, with all NaNs normalized.
    pub result: Result<Vec<Slot>, RuntimeError>,
    /// The results as text.
    pub shown: String,
    pub printed: Vec<String>,
    /// Number of basic blocks and source location at the end, which both evaluators share.
    pub state: (u64, u64, (u32, u32, u32)),
}

impl Outcome {
    /// Returns the code and the start of the source location of the error.
    pub fn failure(&self) -> (&str, Option<u32>) {
        match &self.result {
            Ok(_) => ("", None),
            Err(error) => (&error.code, error.place.map(|place| place.1)),
        }
    }
}

/// The initial state of a run.
#[derive(Clone, Default)]
pub struct Start {
    pub arguments: Vec<Slot>,
    pub params: Vec<f64>,
    pub fuel: Option<u64>,
    pub cancelled: bool,
    pub memory: Option<u64>,
    /// Functions of the embedding program.
    pub host: HostFunctions,
}

fn run(
    program: &Program,
    start: &Start,
    kernels: Vec<Arc<dyn Kernel>>,
    evaluate: impl FnOnce(&mut Context) -> Result<Vec<Slot>, RuntimeError>,
) -> Outcome {
    let mut ctx = Context::new(Box::new(()));
    let printed = Arc::new(Mutex::new(Vec::new()));
    let lines = printed.clone();
    ctx.print = Box::new(move |line| lines.lock().unwrap().push(line.to_string()));
    ctx.kernels = kernels;
    ctx.params = start.params.clone();
    ctx.param_slots = start.params.iter().map(|x| x.to_bits()).collect();
    ctx.fuel = start.fuel.unwrap_or(1_000_000);
    ctx.limits.memory = start.memory;
    let described = calyx_lang::description::describe(program, Default::default()).host_functions;
    ctx.host_functions = start.host.resolve(&described).unwrap();
    if start.cancelled {
        ctx.cancel.cancel();
    }
    let result = evaluate(&mut ctx);
    let mut shown = String::new();
    if let Ok(slots) = &result {
        let repr = &program.functions[program.main.0 as usize].result;
        calyx_abi::text::BoundedText::new(&mut shown, &|_| Ok(()))
            .append(&ctx.heap, repr, slots, &calyx_abi::display::Display::Plain)
            .unwrap();
    }
    let canonical = |slot: Slot| if f64::from_bits(slot).is_nan() { f64::NAN.to_bits() } else { slot };
    let result = result.map(|slots| slots.into_iter().map(canonical).collect());
    let printed = printed.lock().unwrap().clone();
    Outcome { result, shown, printed, state: (ctx.fuel, ctx.granted, ctx.place) }
}

/// Interprets the first function.
pub fn interpreted(program: &Program, start: &Start, allow: Purity) -> Outcome {
    let externs = externs();
    let tapes = lower_sites(program).unwrap();
    let kernels = tapes.into_iter().map(|tape| Arc::new(TapeKernel(tape)) as Arc<dyn Kernel>).collect();
    let interpreter = Interpreter::new(program, &externs, allow).unwrap();
    run(program, start, kernels, |ctx| interpreter.run_function(program.main, &start.arguments, ctx))
}

/// Compiles the program for a processor, stores the code as bytes and loads it again.
pub fn kept(program: &Program, cpu: TargetCpu) -> JitModule {
    let bytes = postcard::to_stdvec(&compile_code(program, cpu).unwrap()).unwrap();
    let code = postcard::from_bytes(&bytes).unwrap();
    // SAFETY: the same compiler just produced the code.
    unsafe { load_code(&code, &externs()) }.unwrap()
}

/// Runs the first function with the interpreter, as code in memory, and as code that was stored and
/// loaded again. Asserts that the outcomes are equal.
pub fn both(program: &Program, start: &Start) -> Outcome {
    let expected = interpreted(program, start, Purity::Effect);
    let modules = [
        ("machine code", compile_jit(program, &externs()).unwrap()),
        ("code that was kept", kept(program, TargetCpu::Native)),
        ("code for any processor", kept(program, TargetCpu::Baseline)),
    ];
    for (name, module) in modules {
        let compiled = run(program, start, module.kernels(), |ctx| {
            module.run_function(program.main, &start.arguments, ctx)
        });
        assert_eq!(compiled, expected, "{name} (left) and interpreter (right) differ");
    }
    expected
}
