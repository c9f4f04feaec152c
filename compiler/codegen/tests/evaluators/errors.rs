//! Errors that a program throws, catches and passes on.

use super::*;

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
