//! Tests of the reuse of results of earlier calls.

use calyx_abi::{Context, Kernel, Purity, standard};
use calyx_lang::check::Loader;
use calyx_lang::check_program;
use calyx_lower::interpret::{CallContent, CallResult, CallResults, Interpreter};
use calyx_lower::kernels::{SiteContent, lower_sites};
use calyx_lower::recently_used::RecentlyUsed;
use calyx_lower::repeatable::RepeatableFunctions;
use calyx_symbolic::TapeKernel;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex};

/// Library with one module, of this text.
struct Library(String);

impl Loader for Library {
    fn module(&self, path: &[String]) -> Option<(String, String)> {
        (path == ["roots"]).then(|| ("<library>/roots.cx".into(), self.0.clone()))
    }
    fn prelude(&self) -> (String, String) {
        ("<library>/prelude.cx".into(), PRELUDE.into())
    }
}

const PRELUDE: &str = include_str!("../../../stdlib-gears/calyx/prelude.cx");

const ROOTS: &str = r#"
/// Roots.
record Roots {
    /// Name.
    name: String;
    /// Roots.
    roots: Array(Number);
    /// Pairs of number and root.
    pairs: Array(Array(Number));
    /// Sum of the roots.
    sum: Number;
}
/// Zero at a root.
private function condition(in x, in a) := x^2 - a;
/// Roots of numbers.
function roots(in numbers: Array(Number), in name: String, inout count: Number) -> Roots {
    var found = Roots("{name}, {len(numbers)}", [], [], 0);
    for (a in numbers) {
        var x = solve(condition, a, a);
        push(found.roots, x);
        push(found.pairs, [a, x]);
        found.sum = found.sum + x;
        count = count + 1;
    }
    return found;
}
/// The same without results of its own: errors are caught.
function first_root(in numbers: Array(Number)) -> Number {
    for (a in numbers) {
        try return solve(condition, 1, a);
        catch (problem) {
            if (problem.code != "E0863") throw;
        }
    }
    return 0;
}
"#;

const MODEL: &str = r#"
import roots;
param last = 100 in 1 .. 1000;
var numbers = [k + 1 for k in 0 .. last], count = 5;
var found = roots.roots(numbers, "the first", count);
print("{found.name}: {found.sum}, {found.roots[2]}, {found.pairs[8]}, {count}");
// The result is a value of its own.
found.roots[2] = 7;
push(found.pairs[8], 1);
"#;

/// Results of earlier runs.
struct Store(Mutex<RecentlyUsed<CallContent, Arc<CallResult>>>);

impl Store {
    fn new() -> Store {
        Store(Mutex::new(RecentlyUsed::new(1_000_000)))
    }
}

impl CallResults for Store {
    fn find(&self, call: CallContent) -> Option<Arc<CallResult>> {
        self.0.lock().unwrap().find(call)
    }
    fn store(&self, call: CallContent, result: CallResult) {
        let size = result.size();
        self.0.lock().unwrap().store(call, Arc::new(result), size);
    }
}

struct Counted(TapeKernel, Arc<AtomicUsize>);

impl Kernel for Counted {
    fn eval(&self, inputs: &[f64], outputs: &mut [f64]) {
        self.1.fetch_add(1, Ordering::Relaxed);
        self.0.eval(inputs, outputs);
    }
    fn inputs(&self) -> usize {
        self.0.inputs()
    }
    fn outputs(&self) -> usize {
        self.0.outputs()
    }
}

/// Outcome of a run.
#[derive(Debug, PartialEq)]
struct Outcome {
    lines: Vec<String>,
    error: Option<String>,
    blocks: u64,
    bytes: u64,
}

/// Checks that a run with earlier results has the outcome of one without. The model changes arrays
/// of the result, which takes more memory if they share elements with copies.
fn assert_same(reused: &Outcome, first: &Outcome) {
    let without_bytes = |outcome: &Outcome| Outcome {
        lines: outcome.lines.clone(),
        error: outcome.error.clone(),
        bytes: 0,
        ..*outcome
    };
    assert_eq!(without_bytes(reused), without_bytes(first));
    assert!(
        reused.bytes <= first.bytes && reused.bytes > first.bytes / 2,
        "{} {}",
        reused.bytes,
        first.bytes
    );
}

const FUEL: u64 = 1_000_000;

/// Runs a model with a library, and returns the outcome and the number of evaluations of kernels.
fn run(model: &str, library: &str, store: &Store, fuel: u64) -> (Outcome, usize) {
    let checked = check_program("model.cx", model, &Library(library.into()));
    let program = checked.program.unwrap_or_else(|| panic!("{:#?}", checked.diagnostics));
    let sites: Vec<SiteContent> = program.sites.iter().map(|site| SiteContent::of(&program, site)).collect();
    let repeatable = RepeatableFunctions::of(&program, &sites);
    let interpreter = Interpreter::new(&program, standard::EXTERNS, Purity::Scene).expect("known functions");
    let interpreter = interpreter.recovering().reusing(store, &repeatable);
    let mut context = Context::new(Box::new(()));
    let evaluations = Arc::new(AtomicUsize::new(0));
    let kernels = lower_sites(&program).expect("kernels").into_iter();
    let counted = |tape| Arc::new(Counted(TapeKernel(tape), evaluations.clone())) as Arc<dyn Kernel>;
    context.kernels = kernels.map(counted).collect();
    let lines = Arc::new(Mutex::new(Vec::new()));
    let printed = lines.clone();
    context.print = Box::new(move |line| printed.lock().unwrap().push(line.to_owned()));
    context.fuel = fuel;
    for param in &program.params {
        let slots = interpreter.run_function(param.default, &[], &mut context).expect("a default");
        context.params.push(f64::from_bits(slots[0]));
        context.param_slots.extend(slots);
    }
    let error = interpreter.run_main(&mut context).err().map(|error| error.code.clone());
    let lines = lines.lock().unwrap().clone();
    let blocks = fuel - context.fuel - context.granted;
    let outcome = Outcome { lines, error, blocks, bytes: context.heap.bytes() };
    (outcome, evaluations.load(Ordering::Relaxed))
}

#[test]
fn equal_calls_of_the_library_are_evaluated_once() {
    let store = Store::new();
    let (first, evaluated) = run(MODEL, ROOTS, &store, FUEL);
    assert_eq!(evaluated, 100);
    assert_eq!(first.lines.len(), 1, "{first:?}");
    assert!(first.lines[0].starts_with("the first, 100: 671.46"), "{first:?}");
    assert!(first.lines[0].ends_with(", [9, 3], 105"), "{first:?}");
    // Again, after an edit above and one of what the call does not depend on.
    let edited = format!("// Roots.\nparam other = 3 in 0 .. 4;\n{MODEL}print(other);");
    for (model, printed) in [(MODEL, 1), (&edited, 2)] {
        let (again, evaluated) = run(model, ROOTS, &Store::new(), FUEL);
        assert_eq!(evaluated, 100);
        let (reused, evaluated) = run(model, ROOTS, &store, FUEL);
        // Every param is an input of each kernel, so another number of them gives other kernels.
        assert_eq!(evaluated, if printed == 1 { 0 } else { 100 });
        assert_eq!((reused.lines.len(), &reused.lines[0]), (printed, &first.lines[0]));
        assert_same(&reused, &again);
    }
    let (reused, evaluated) = run(&format!("// Roots.\n{MODEL}"), ROOTS, &store, FUEL);
    assert_eq!(evaluated, 0);
    assert_same(&reused, &first);
}

#[test]
fn other_arguments_and_other_functions_are_evaluated() {
    let store = Store::new();
    run(MODEL, ROOTS, &store, FUEL);
    let changes = [
        (MODEL.replace("last = 100", "last = 99"), ROOTS.to_owned()),
        (MODEL.replace("k + 1", "k + 2"), ROOTS.to_owned()),
        (MODEL.replace("the first", "another"), ROOTS.to_owned()),
        (MODEL.replace("count = 5", "count = 6"), ROOTS.to_owned()),
        (MODEL.to_owned(), ROOTS.replace("x^2 - a", "x^3 - a")),
        (MODEL.to_owned(), ROOTS.replace("count + 1", "count + 2")),
        (MODEL.to_owned(), ROOTS.replace("{name}, ", "{name}; ")),
    ];
    for (model, library) in changes {
        let (found, evaluated) = run(&model, &library, &store, FUEL);
        assert!(evaluated >= 99, "{evaluated}: {model} {library}");
        assert_eq!(found, run(&model, &library, &Store::new(), FUEL).0);
    }
}

#[test]
fn a_result_does_not_exceed_the_limits_of_its_call() {
    let store = Store::new();
    let (whole, _) = run(MODEL, ROOTS, &store, FUEL);
    for fuel in [whole.blocks / 2, whole.blocks - 1, whole.blocks] {
        let (limited, _) = run(MODEL, ROOTS, &store, fuel);
        assert_same(&limited, &run(MODEL, ROOTS, &Store::new(), fuel).0);
        assert_eq!(limited.error.is_some(), fuel < whole.blocks, "{limited:?}");
    }
}

/// A function of the model may catch an error whose location changes with the text above it.
#[test]
fn functions_of_a_model_are_evaluated() {
    let function = ROOTS.replace("function roots(", "function own(");
    let model = MODEL.replace("roots.roots(", "own(").replace("import roots;", &function);
    let store = Store::new();
    for _ in 0..2 {
        assert_eq!(run(&model, ROOTS, &store, FUEL).1, 100);
    }
}

/// A call that catches the failures of searches is repeatable; one that fails is executed.
#[test]
fn failures_inside_of_a_call_do_not_prevent_its_reuse() {
    let model = "import roots;\nprint(roots.first_root([k - 150 for k in 0 .. 200]));";
    let store = Store::new();
    let (first, evaluated) = run(model, ROOTS, &store, FUEL);
    assert!(evaluated > 100 && first.lines.len() == 1, "{evaluated} {first:?}");
    assert_eq!(run(model, ROOTS, &store, FUEL), (first, 0));
}

/// Values of symbolic functions that the program does not bind are not stored, nor are the choices
/// with which it compares.
#[test]
fn evaluations_and_comparisons_take_no_memory() {
    let model = "function f(in x: Number) := sin(x)^2;\nenum Way { up, down }\nvar sum = 0, way = Way.up;\n\
                 for (k in 0 .. COUNT) { if (way == \"up\") sum += f(k) / COUNT; }";
    let bytes = [10, 1000].map(|count| {
        let (outcome, evaluated) =
            run(&model.replace("COUNT", &count.to_string()), ROOTS, &Store::new(), FUEL);
        assert_eq!((evaluated, &outcome.error), (count, &None));
        outcome.bytes
    });
    assert_eq!(bytes[0], bytes[1]);
}
