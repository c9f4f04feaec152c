//! Tests that machine code and the interpreter produce the same correct bits, errors and source
//! locations.

mod errors;

use crate::common::*;
use calyx_abi::display::{Display, NumberStyle};
use calyx_abi::{Purity, Repr, Slot};
use calyx_lang::ir::*;
use calyx_lang::span::Span;

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
        given: None,
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
