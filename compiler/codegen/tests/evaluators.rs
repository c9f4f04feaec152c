//! Tests that machine code and the interpreter produce the same correct bits, errors and source
//! locations.

#[allow(dead_code, reason = "shared by several tests")]
mod common;

use calyx_abi::display::{Display, NumberStyle};
use calyx_abi::{Purity, Repr, Slot};
use calyx_lang::ir::*;
use calyx_lang::span::Span;
use common::*;

/// Returns the result of both evaluators as text.
fn shown(program: &Program) -> String {
    let outcome = both(program, &Start::default());
    assert!(outcome.result.is_ok(), "{:?}", outcome.result);
    outcome.shown
}

/// Returns the code and the location of the error of both evaluators.
fn failure(program: &Program) -> (String, Option<u32>) {
    let outcome = both(program, &Start::default());
    let (code, place) = outcome.failure();
    (code.into(), place)
}

const SPECIAL: [f64; 16] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    0.5,
    -2.5,
    2.5,
    3.7,
    1e300,
    -1e-300,
    5e-324,
    0.49999999999999994,
    4503599627370497.5,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::NAN,
];

const OPERATIONS: [Op; 48] = {
    use Op::*;
    [
        Add,
        Subtract,
        Multiply,
        Divide,
        Power,
        Negate,
        Not,
        Less,
        LessEqual,
        Greater,
        GreaterEqual,
        Equal,
        NotEqual,
        Sqrt,
        Abs,
        Sin,
        Cos,
        Tan,
        Asin,
        Acos,
        Atan,
        Exp,
        Log,
        Floor,
        Ceil,
        Round,
        Atan2,
        Min,
        Max,
        Vector,
        X,
        Y,
        Z,
        Norm,
        AddVector,
        SubtractVector,
        Cross,
        NegateVector,
        Scale,
        Dot,
        Translate,
        Rotate,
        Compose,
        Apply,
        Inverse,
        Origin,
        Direction,
        Equal,
    ]
};

/// Runs one program that applies an operation to its arguments, for many arguments in each
/// evaluator.
#[test]
fn every_operation_has_the_same_bits() {
    for (position, operation) in OPERATIONS.into_iter().enumerate() {
        let (mut operands, result) = signature(operation);
        if position == OPERATIONS.len() - 1 {
            operands = vec![V, V];
        }
        let arguments = (0..).zip(&operands).map(|(index, repr)| local(index, repr.clone())).collect();
        let value = expr(ExprKind::Op(operation, arguments), result.clone());
        let modes = vec![Mode::In; operands.len()];
        let program =
            program(vec![function(&modes, operands.clone(), result, vec![block(vec![], ret(value))])]);
        let module = calyx_codegen::compile_jit(&program, &[]).unwrap();
        let interpreter = calyx_lower::interpret::Interpreter::new(&program, &[], Purity::Pure).unwrap();
        let slots: usize = operands.iter().map(Repr::slots).sum();
        for first in 0..SPECIAL.len() {
            // All pairs of two numbers; a selection for more operands.
            for step in 0..if slots <= 2 { SPECIAL.len() } else { 5 } {
                let number = |slot: usize| SPECIAL[(first + slot * step) % SPECIAL.len()].to_bits();
                let arguments: Vec<Slot> = if operation == Op::Not {
                    vec![(first % 2) as Slot]
                } else {
                    (0..slots).map(number).collect()
                };
                let mut ctx = calyx_abi::Context::new(Box::new(()));
                let run = |result: Result<Vec<Slot>, _>| -> Vec<Slot> {
                    let canonical = |slot: Slot| if f64::from_bits(slot).is_nan() { u64::MAX } else { slot };
                    result
                        .map_err(|error: calyx_abi::RuntimeError| panic!("{error:?}"))
                        .unwrap()
                        .into_iter()
                        .map(canonical)
                        .collect()
                };
                let compiled = run(module.run_function(FunctionId(0), &arguments, &mut ctx));
                let expected = run(interpreter.run_function(FunctionId(0), &arguments, &mut ctx));
                assert_eq!(compiled, expected, "{operation:?} {arguments:x?}");
            }
        }
    }
}

#[test]
fn frames_are_read_right_to_left() {
    // In A * B, B is applied first; X * p returns the coordinates of p in the frame X.
    let vector = |x, y, z| op(Op::Vector, vec![number(x), number(y), number(z)]);
    let quarter = number(std::f64::consts::FRAC_PI_2);
    let turn = op(Op::Rotate, vec![quarter, vector(0.0, 0.0, 1.0)]);
    let moved = op(Op::Translate, vec![vector(2.0, 0.0, 0.0)]);
    let frame = op(Op::Compose, vec![moved, turn]);
    let round = |value: Expr| {
        let component = |axis| op(Op::Round, vec![op(axis, vec![value.clone()])]);
        tuple(vec![component(Op::X), component(Op::Y), component(Op::Z)])
    };
    let cases = [
        // Rotated by 90 degrees, then translated by 2 along its own first axis, which is ground's
        // e2.
        (op(Op::Origin, vec![frame.clone()]), "[0, 2, 0]"),
        (op(Op::Direction, vec![frame.clone(), vector(1.0, 0.0, 0.0)]), "[0, 1, 0]"),
        (op(Op::Apply, vec![frame.clone(), vector(0.0, 5.0, 1.0)]), "[3, 0, 1]"),
        (op(Op::Apply, vec![op(Op::Inverse, vec![frame]), vector(3.0, 0.0, 1.0)]), "[0, 5, 1]"),
    ];
    for (value, expected) in cases {
        let text = shown(&evaluates(vec![], vec![], round(value)));
        assert_eq!(text.replace("-0", "0"), expected);
    }
}

/// `while (i < limit) { sum = sum + i * i; i = i + 1; }`
fn loop_program(limit: f64) -> Program {
    let square = op(Op::Multiply, vec![n(0), n(0)]);
    let body = vec![assign(1, add(n(1), square)), assign(0, add(n(0), number(1.0)))];
    let blocks = vec![
        block(vec![], jump(1)),
        block(vec![], branch(less(n(0), number(limit)), 2, 3)),
        block(body, jump(1)),
        block(vec![], ret(n(1))),
    ];
    program(vec![function(&[], vec![N, N], N, blocks)])
}

#[test]
fn loops() {
    assert_eq!(shown(&loop_program(101.0)), "338350");
    assert_eq!(shown(&loop_program(0.0)), "0");
}

#[test]
fn an_endless_loop_is_stopped() {
    let endless = loop_program(f64::INFINITY);
    for fuel in [0, 1, 7, 4096, 10_000] {
        let start = Start { fuel: Some(fuel), ..Start::default() };
        assert_eq!(both(&endless, &start).failure(), ("E0703", Some(800)), "{fuel}");
    }
    let start = Start { cancelled: true, ..Start::default() };
    assert_eq!(both(&endless, &start).failure().0, "E0704");
}

#[test]
fn both_sides_are_evaluated_only_if_needed() {
    // Evaluating the right side would fail.
    let fails = || less(index(array(N, vec![]), at(5, number(0.0))), number(0.0));
    let and = |a, b| expr(ExprKind::And(Box::new(a), Box::new(b)), B);
    let or = |a, b| expr(ExprKind::Or(Box::new(a), Box::new(b)), B);
    let choose = |c, a: Expr, b| {
        let repr = a.repr.clone();
        expr(ExprKind::If(Box::new(c), Box::new(a), Box::new(b)), repr)
    };
    let pair = |a, b| tuple(vec![number(a), string(b)]);
    let values = tuple(vec![
        and(truth(false), fails()),
        and(truth(true), truth(true)),
        or(truth(true), fails()),
        or(truth(false), truth(false)),
        choose(truth(true), truth(true), fails()),
        choose(less(number(2.0), number(1.0)), pair(1.0, "one"), pair(2.0, "two")),
    ]);
    assert_eq!(shown(&evaluates(vec![], vec![], values)), "[FALSE, TRUE, TRUE, FALSE, TRUE, [2, two]]");
    let taken = and(truth(true), fails());
    assert_eq!(failure(&evaluates(vec![], vec![], taken)), ("E0701".into(), Some(5)));
}

#[test]
fn arrays_are_values() {
    // a = [[1, 2], [3]]; b = copy a; b[0][1] = 7; push b[1], 8; push b, [9];
    let numbers = |values: &[f64]| array(N, values.iter().map(|&value| number(value)).collect());
    let rows = array_of(array_of(N));
    let (a, b) = (|| local(0, rows.clone()), || local(1, rows.clone()));
    let copy = expr(ExprKind::Copy(Box::new(a())), rows.clone());
    let push = |place, value| Statement::Push { place, value, span: Span::default() };
    let statements = vec![
        assign(0, array(array_of(N), vec![numbers(&[1.0, 2.0]), numbers(&[3.0])])),
        assign(1, copy),
        assign_element(1, vec![number(0.0), number(1.0)], number(7.0)),
        push(place(1, vec![number(1.0)], array_of(N)), number(8.0)),
        push(place(1, vec![], rows.clone()), numbers(&[9.0])),
    ];
    let len = |array| expr(ExprKind::Len(Box::new(array)), N);
    let equal = |a, b| op(Op::Equal, vec![a, b]);
    let value = tuple(vec![
        a(),
        b(),
        len(b()),
        len(index(b(), number(1.0))),
        equal(a(), b()),
        equal(index(b(), number(1.0)), numbers(&[3.0, 8.0])),
        op(Op::NotEqual, vec![tuple(vec![number(1.0), string("x")]), tuple(vec![number(1.0), string("x")])]),
    ]);
    let program = evaluates(vec![rows.clone(), rows.clone()], statements, value);
    assert_eq!(shown(&program), "[[[1, 2], [3]], [[1, 7], [3, 8], [9]], 3, 2, FALSE, TRUE, FALSE]");
}

#[test]
fn elements_of_several_slots() {
    // Vectors and pairs are stored inline in their arrays.
    let vector = |x| op(Op::Vector, vec![number(x), number(x + 1.0), number(x + 2.0)]);
    let pair = Repr::Tuple(vec![V, S]);
    let pairs = array_of(pair.clone());
    let make = |x, text| tuple(vec![vector(x), string(text)]);
    let element = |position| index(local(0, pairs.clone()), number(position));
    let part =
        |tuple: Expr, position: usize, repr| expr(ExprKind::TupleElement(Box::new(tuple), position), repr);
    let program = evaluates(
        vec![pairs.clone()],
        vec![
            assign(0, array(pair, vec![make(1.0, "a"), make(10.0, "b")])),
            assign_element(0, vec![number(0.0)], make(4.0, "c")),
        ],
        tuple(vec![part(element(1.0), 0, V), part(element(0.0), 1, S), element(0.0)]),
    );
    assert_eq!(shown(&program), "[[10, 11, 12], c, [[4, 5, 6], c]]");
}

#[test]
fn elements_of_tuples_are_places() {
    // t = [1, [v, "a"], [[2, "b"], [3, "c"]]]; t[1][1] = "x"; t[2][1][0] = 7; t[2][0] = [8, "y"];
    // push t[2], [9, "z"];
    let vector = op(Op::Vector, vec![number(1.0), number(2.0), number(3.0)]);
    let pair = Repr::Tuple(vec![N, S]);
    let make = |x, text| tuple(vec![number(x), string(text)]);
    let value = tuple(vec![
        number(1.0),
        tuple(vec![vector, string("a")]),
        array(pair.clone(), vec![make(2.0, "b"), make(3.0, "c")]),
    ]);
    let whole = value.repr.clone();
    let place = |steps, repr| Place { local: LocalId(0), steps, repr };
    let set = |steps, value: Expr| Statement::Assign {
        place: place(steps, value.repr.clone()),
        value,
        span: Span::default(),
    };
    let at_index = |position| Step::Index(at(3, number(position)));
    let program = |bad: f64| {
        let statements = vec![
            assign(0, value.clone()),
            set(vec![Step::Element(1), Step::Element(1)], string("x")),
            set(vec![Step::Element(2), at_index(1.0), Step::Element(0)], number(7.0)),
            set(vec![Step::Element(2), at_index(bad)], make(8.0, "y")),
            Statement::Push {
                place: place(vec![Step::Element(2)], array_of(pair.clone())),
                value: make(9.0, "z"),
                span: Span::default(),
            },
        ];
        evaluates(vec![whole.clone()], statements, local(0, whole.clone()))
    };
    assert_eq!(shown(&program(0.0)), "[1, [[1, 2, 3], x], [[8, y], [7, c], [9, z]]]");
    assert_eq!(failure(&program(2.0)), ("E0701".into(), Some(3)));
}

#[test]
fn indices_outside_fail_at_the_index() {
    let three = || array(N, vec![number(1.0), number(2.0), number(3.0)]);
    for bad in [3.0, -1.0, 0.5, f64::NAN] {
        let read = evaluates(vec![], vec![], index(three(), at(7, number(bad))));
        assert_eq!(failure(&read), ("E0701".into(), Some(7)), "{bad}");
        let statements = vec![assign(0, three()), assign_element(0, vec![at(8, number(bad))], number(0.0))];
        let write = evaluates(vec![array_of(N)], statements, number(0.0));
        assert_eq!(failure(&write), ("E0701".into(), Some(8)), "{bad}");
    }
}

#[test]
fn strings_show_values_in_their_units() {
    let plain = || Display::Number(NumberStyle::default());
    let inch = Display::Number(NumberStyle::in_unit(0.0254, "inch"));
    let format = |parts| expr(ExprKind::Format(parts), S);
    let text = |text: &str| FormatPart::Text(text.into());
    let inner = format(vec![text("<"), FormatPart::Value(number(0.1), plain()), text(">")]);
    let value = format(vec![
        text("d = "),
        FormatPart::Value(number(3.0 * 0.0254), inch),
        text(", "),
        FormatPart::Value(inner, Display::Plain),
        FormatPart::Value(truth(true), Display::Text { width: 6 }),
        FormatPart::Value(
            array(N, vec![number(1e300), number(f64::NEG_INFINITY)]),
            Display::Array(Box::new(plain())),
        ),
    ]);
    let same = op(Op::Equal, vec![string("é"), format(vec![text("é")])]);
    let program = evaluates(vec![], vec![], tuple(vec![value, same]));
    assert_eq!(shown(&program), "[d = 3 inch, <0.1>TRUE  [1e300, -inf], TRUE]");
}

#[test]
fn out_and_inout_copy_back() {
    // f(inout a, out b, in c) = a + c, with a := 10 a and b := c + 1.
    let f = function(
        &[Mode::InOut, Mode::Out, Mode::In],
        vec![N, N, N, N],
        N,
        vec![block(
            vec![
                assign(3, add(n(0), n(2))),
                assign(0, op(Op::Multiply, vec![number(10.0), n(0)])),
                assign(1, add(n(2), number(1.0))),
            ],
            ret(n(3)),
        )],
    );
    let numbers = array_of(N);
    let call = |result, a: Place, b: Place, argument| Statement::Call {
        result,
        function: FunctionId(1),
        arguments: vec![argument, number(f64::NAN), number(5.0)],
        copy_back: vec![a, b],
        span: span(20),
    };
    let element = |position: u32, at_place: u32| place(1, vec![at(at_place, number(f64::from(position)))], N);
    let main = |bad: u32| {
        let statements = vec![
            assign(0, number(2.0)),
            assign(1, array(N, vec![number(0.0), number(0.0), number(0.0)])),
            call(Some(element(0, 30)), place(0, vec![], N), element(1, 31), n(0)),
            // The result is not used.
            call(None, element(bad, 32), place(2, vec![], N), number(4.0)),
        ];
        let value = tuple(vec![n(0), local(1, numbers.clone()), n(2)]);
        let result = value.repr.clone();
        let main = function(&[], vec![N, numbers.clone(), N], result, vec![block(statements, ret(value))]);
        program(vec![main, f.clone()])
    };
    assert_eq!(shown(&main(2)), "[20, [7, 6, 40], 6]");
    assert_eq!(failure(&main(3)), ("E0701".into(), Some(32)));
}

/// `fib(x) = if (x < 2) x else fib(x - 1) + fib(x - 2)`, with a base case at `base`.
fn fibonacci(argument: f64, base: f64) -> Program {
    let smaller = |by| op(Op::Subtract, vec![n(0), number(by)]);
    let again = |by| at(40, call(1, vec![smaller(by)], N));
    let value = ExprKind::If(
        Box::new(less(n(0), number(base))),
        Box::new(n(0)),
        Box::new(add(again(1.0), again(2.0))),
    );
    let fibonacci = function(&[Mode::In], vec![N], N, vec![block(vec![], ret(expr(value, N)))]);
    let main = function(&[], vec![], N, vec![block(vec![], ret(call(1, vec![number(argument)], N)))]);
    program(vec![main, fibonacci])
}

#[test]
fn recursion_has_a_limit() {
    assert_eq!(shown(&fibonacci(15.0, 2.0)), "610");
    assert_eq!(failure(&fibonacci(1.0, f64::NEG_INFINITY)), ("E0702".into(), Some(40)));
}

/// Returns a handler that stores the code, the message and the value of the error in locals 0, 1
/// and 2.
fn handler(then: Terminator) -> Block {
    let fields = expr(ExprKind::CaughtFields(Box::new(local(3, Repr::Handle))), error_repr());
    let part = |at, repr| expr(ExprKind::TupleElement(Box::new(fields.clone()), at), repr);
    let caught = assign(3, expr(ExprKind::Catch, Repr::Handle));
    block(vec![caught, assign(0, part(0, S)), assign(1, part(1, S)), assign(2, part(3, N))], then)
}

/// Returns `try { statements } catch (e) { 0 = e.code; 1 = e.message; 2 = e.value; }`, then an
/// expression in a fifth local.
fn tries(tried: Vec<Statement>, then: Terminator, after: Expr, others: Vec<Function>) -> Program {
    let value = tuple(vec![local(0, S), local(1, S), n(2), n(4)]);
    let blocks = vec![
        block(vec![assign(0, string("none")), assign(1, string("")), assign(4, number(1.0))], jump(1)),
        Block { handler: Some(BlockId(2)), ..block(tried, jump(3)) },
        handler(then),
        block(vec![assign(4, add(n(4), after))], ret(value.clone())),
    ];
    let main = function(&[], vec![S, S, N, Repr::Handle, N], value.repr, blocks);
    with_externs(program([vec![main], others].concat()))
}

fn throw(place: u32, code: &str, value: Expr) -> Terminator {
    let error = tuple(vec![string(code), string("thrown"), string(""), value, string("")]);
    Terminator::Throw { error, help: String::new(), span: span(place) }
}

/// Returns a function that throws its argument if it is positive, and returns it otherwise.
fn thrower() -> Function {
    let blocks = vec![
        block(vec![], branch(less(number(0.0), n(0)), 1, 2)),
        block(vec![], throw(70, "MINE", n(0))),
        block(vec![], ret(n(0))),
    ];
    Function { name: "thrower".into(), ..function(&[Mode::In], vec![N], N, blocks) }
}

#[test]
fn errors_are_caught() {
    let thrown = |x| assign(4, at(71, call(1, vec![number(x)], N)));
    let run = |statement| {
        shown(&tries(vec![statement, assign(4, number(50.0))], jump(3), number(1.0), vec![thrower()]))
    };
    // The target of the failed assignment keeps its value.
    assert_eq!(run(thrown(2.5)), "[MINE, thrown, 2.5, 2]");
    assert_eq!(run(thrown(0.0)), "[none, , 0, 51]");
    let outside = index(array(N, vec![]), at(72, number(3.0)));
    assert_eq!(run(assign(4, outside)), "[E0701, index 3 of an array of 0 elements, nan, 2]");
    let root = call_extern(0, vec![number(1.0), at(73, number(-1.0))], N);
    assert_eq!(run(assign(4, root)), "[E0999, negative, nan, 2]");
    let endless = Function {
        name: "endless".into(),
        ..function(&[Mode::In], vec![N], N, vec![block(vec![], ret(at(40, call(1, vec![n(0)], N))))])
    };
    let deep = tries(vec![assign(4, call(1, vec![number(0.0)], N))], jump(3), number(1.0), vec![endless]);
    assert!(shown(&deep).starts_with("[E0702, "));
    // The call depth is correct afterwards.
    let tried = vec![assign(4, call(2, vec![number(1.0)], N))];
    let others = vec![fibonacci(15.0, 2.0).functions.remove(1), thrower()];
    let again = tries(tried, jump(3), call(1, vec![number(10.0)], N), others);
    assert_eq!(shown(&again), "[MINE, thrown, 1, 56]");
}

#[test]
fn errors_are_passed_on_with_their_place_and_calls() {
    let again = Terminator::Rethrow(local(3, Repr::Handle));
    let tried = || vec![assign(4, at(71, call(1, vec![number(2.0)], N)))];
    let outcome = both(&tries(tried(), again, number(0.0), vec![thrower()]), &Start::default());
    let error = outcome.result.unwrap_err();
    assert_eq!((error.code.as_str(), error.place.map(|place| place.1)), ("MINE", Some(70)));
    let calls: Vec<_> =
        error.details.calls.iter().map(|call| (call.function.as_str(), call.place.1)).collect();
    assert_eq!(calls, [("thrower", 71)]);
    let other = throw(74, "", number(1.0));
    let outcome = both(&tries(tried(), other, number(0.0), vec![thrower()]), &Start::default());
    assert_eq!(outcome.failure(), ("E0720", Some(74)));
}

#[test]
fn what_stops_a_run_cannot_be_caught() {
    let spin = function(&[], vec![], N, vec![block(vec![], jump(1)), block(vec![], jump(0))]);
    let program = |others| tries(vec![assign(4, at(71, call(1, vec![], N)))], jump(3), number(0.0), others);
    let endless = program(vec![spin.clone()]);
    assert_eq!(
        both(&endless, &Start { fuel: Some(9000), ..Start::default() }).failure(),
        ("E0703", Some(800))
    );
    assert_eq!(both(&endless, &Start { cancelled: true, ..Start::default() }).failure().0, "E0704");
    let start = Start { memory: Some(1_000_000), ..Start::default() };
    let grows = vec![
        block(vec![assign(0, array(N, vec![]))], jump(1)),
        block(
            vec![Statement::Push {
                place: place(0, vec![], array_of(N)),
                value: number(1.0),
                span: span(75),
            }],
            jump(1),
        ),
    ];
    let grows = function(&[], vec![array_of(N)], N, grows);
    assert_eq!(both(&program(vec![grows]), &start).failure().0, "E0707");
    let doubles = Statement::Assign {
        place: place(0, vec![], S),
        value: expr(
            ExprKind::Format(vec![
                FormatPart::Value(local(0, S), Display::Plain),
                FormatPart::Value(local(0, S), Display::Plain),
            ]),
            S,
        ),
        span: span(76),
    };
    let doubles = vec![block(vec![assign(0, string("text"))], jump(1)), block(vec![doubles], jump(1))];
    let doubles = function(&[], vec![S], N, doubles);
    assert_eq!(both(&program(vec![doubles]), &start).failure().0, "E0707");
}

#[test]
fn nothing_is_handed_back_by_a_call_that_fails() {
    // f(inout a) { a = 5; throw }
    let f = function(
        &[Mode::InOut],
        vec![N],
        Repr::Unit,
        vec![block(vec![assign(0, number(5.0))], throw(70, "F", number(0.0)))],
    );
    let call = Statement::Call {
        result: None,
        function: FunctionId(1),
        arguments: vec![n(4)],
        copy_back: vec![place(4, vec![], N)],
        span: span(71),
    };
    assert_eq!(shown(&tries(vec![call], jump(3), number(10.0), vec![f])), "[F, thrown, 0, 11]");
}

#[test]
fn provided_functions_fail_where_the_argument_is_written() {
    let root = |x: f64| {
        let arguments = vec![at(51, number(2.0)), at(52, number(x))];
        let call = Expr { span: Span { end: 60, ..span(50) }, ..call_extern(0, arguments, N) };
        with_externs(evaluates(vec![], vec![], call))
    };
    assert_eq!(shown(&root(9.0)), "6");
    assert_eq!(failure(&root(-1.0)), ("E0999".into(), Some(52)));
    let panics = Statement::Eval(at(53, call_extern(1, vec![], Repr::Unit)));
    let outcome = failure(&with_externs(evaluates(vec![], vec![panics], number(0.0))));
    assert!(outcome.0.starts_with("E079") && outcome.1 == Some(53), "{outcome:?}");
}

#[test]
fn print_and_assert() {
    let assert = |condition| {
        Statement::Eval(at(61, call_extern(4, vec![truth(condition), string("why")], Repr::Unit)))
    };
    let print = |text| Statement::Eval(call_extern(3, vec![string(text)], Repr::Unit));
    let run = |condition| {
        let statements = vec![print("one"), assert(condition), print("two")];
        both(&with_externs(evaluates(vec![], statements, number(0.0))), &Start::default())
    };
    assert_eq!(run(true).printed, ["one", "two"]);
    let failed = run(false);
    assert_eq!((failed.failure(), failed.printed.len()), (("E0705", Some(61)), 1));
}

#[test]
fn effects_are_skipped_where_they_are_not_allowed() {
    let program = with_externs(evaluates(vec![], vec![], call_extern(2, vec![string("line")], S)));
    assert_eq!(shown(&program), "done");
    let checked = interpreted(&program, &Start::default(), Purity::Scene);
    assert!(checked.result.is_ok() && checked.shown.is_empty() && checked.printed.is_empty());
}

#[test]
fn params_and_symbolic_values() {
    // position := scale * Time * direction + (if (mirrored) -param else param) * e1, captured and
    // evaluated.
    let sym = |kind, repr| SymExpr { kind, repr, span: Span::default() };
    let capture = |index, repr| sym(SymKind::Capture(index), repr);
    let sym_op = |operation, operands| sym(SymKind::Op(operation, operands), signature(operation).1);
    let one = |value| sym(SymKind::Number(value), N);
    let param = sym(SymKind::Param(1), N);
    let factor = sym_op(Op::Multiply, vec![capture(0, N), sym(SymKind::Time, N)]);
    let along = sym_op(Op::Scale, vec![factor, capture(1, V)]);
    let negative = sym_op(Op::Negate, vec![param.clone()]);
    let chosen = sym(SymKind::If(Box::new(capture(2, B)), Box::new(negative), Box::new(param)), N);
    let offset = sym_op(Op::Vector, vec![chosen, one(0.0), one(0.0)]);
    let captured = |name: &str, repr| Capture { name: name.into(), repr, observable: false };
    let site = Site {
        name: "position".into(),
        shared: Vec::new(),
        expr: sym_op(Op::AddVector, vec![along, offset]),
        captures: vec![captured("scale", N), captured("direction", V), captured("mirrored", B)],
        repr: V,
        order: 0,
        part: false,
        span: Span::default(),
    };
    let symbolic = Repr::Symbolic(Box::new(V));
    let direction = op(Op::Vector, vec![number(0.0), number(1.0), number(2.0)]);
    let captures = vec![number(3.0), direction, truth(true)];
    let make = expr(ExprKind::MakeSymbolic { site: SiteId(0), captures }, symbolic.clone());
    let time = Box::new(number(0.5));
    let value = expr(ExprKind::EvalSymbolic { value: Box::new(local(0, symbolic.clone())), time }, V);
    let first = expr(ExprKind::Param(0), N);
    let mut program = evaluates(vec![symbolic], vec![assign(0, make)], tuple(vec![value, first]));
    program.sites.push(site);
    let param = |name: &str| Param {
        name: name.into(),
        doc: String::new(),
        repr: N,
        default: FunctionId(0),
        low: None,
        high: None,
        choices: vec![],
        unit: DisplayUnit { name: String::new(), factor: 1.0, dimension: [(0, 1); 8] },
        integral: false,
        span: Span::default(),
    };
    program.params = vec![param("first"), param("second")];
    let start = Start { params: vec![8.0, 4.0], ..Start::default() };
    assert_eq!(both(&program, &start).shown, "[[-4, 1.5, 3], 8]");
    let unset = both(&program, &Start::default());
    assert_eq!(unset.failure().0, "E0799");
}

#[test]
fn missing_functions_are_found_before_anything_runs() {
    let mut program = with_externs(evaluates(vec![], vec![], number(0.0)));
    program.externs[0].symbol = "getenv".into();
    let error = calyx_codegen::compile_jit(&program, &externs()).err().unwrap();
    assert!(error.to_string().contains("getenv"), "{error}");
    program.externs[0] = ExternDecl { result: S, parameters: vec![], ..program.externs[1].clone() };
    assert!(calyx_codegen::compile_jit(&program, &externs()).is_err());
}

#[test]
fn programs_that_contradict_themselves_are_refused() {
    for value in [n(3), call(9, vec![], N), call_extern(9, vec![], N), expr(ExprKind::Param(0), N)] {
        let program = evaluates(vec![], vec![], value);
        assert!(calyx_codegen::compile_jit(&program, &[]).is_err());
        assert_eq!(interpreted(&program, &Start::default(), Purity::Effect).failure().0, "E0799");
    }
}
