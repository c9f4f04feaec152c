//! Tests functions that the embedding program provides. The interpreter, code in memory and stored
//! code call them with the right values. Their errors are errors of the model, and nothing else in
//! the model changes.

use crate::common::text::check;
use crate::common::*;
use calyx_abi::error::codes;
use calyx_abi::host::HostFunctions;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

fn provided(add: impl FnOnce(&mut HostFunctions)) -> Start {
    let mut host = HostFunctions::default();
    add(&mut host);
    Start { host, ..Start::default() }
}

/// Returns the lines that a model prints in all evaluators.
fn printed(text: &str, start: &Start) -> Vec<String> {
    let outcome = both(&check(text), start);
    assert!(outcome.result.is_ok(), "{:?}", outcome.result);
    outcome.printed
}

const FRICTION: &str = "units mm_N_s; host function friction(in v: Velocity) -> Number { return 0.05; }";

#[test]
fn a_closure_takes_the_place_of_the_body() {
    let text = format!("{FRICTION} print(friction(2 m/s), friction(v = -1 mm/s));");
    assert_eq!(printed(&text, &Start::default()), ["0.05 0.05"]);
    // Values are in SI units.
    assert_eq!(printed(&text, &provided(|host| host.add("friction", |v: f64| 0.5 + v))), ["2.5 0.499"]);
}

#[test]
fn values_of_every_type_cross() {
    let text = "units mm_N_s;
        host function mixed(in name: String, in on: Bool, in v: Vector(Length), in all: Array(Array(Length))) -> Array(Vector(Length)) {
            return [v];
        }
        host function label(in n: Number) -> String { return \"none\"; }
        host function on() -> Bool { return FALSE; }
        var all = [[1 mm, 2 mm], [3 mm]];
        print(mixed(\"é\", TRUE, 1 mm*e2, all), label(3), on(), all);";
    let start = provided(|host| {
        host.add("mixed", |name: String, on: bool, v: [f64; 3], mut all: Vec<Vec<f64>>| {
            assert_eq!((name.as_str(), on), ("é", true));
            // The function receives a copy, so the model's own array does not change.
            all[0][0] = 9.0;
            vec![v, [all[0][1], all[1][0], 0.0]]
        });
        host.add("label", |n: f64| format!("<{n}>"));
        host.add("on", || true);
    });
    assert_eq!(
        printed(text, &start),
        ["[[0 mm, 1 mm, 0 mm], [2 mm, 3 mm, 0 mm]] <3> TRUE [[1 mm, 2 mm], [3 mm]]"]
    );
    assert_eq!(printed(text, &Start::default()), ["[[0 mm, 1 mm, 0 mm]] none FALSE [[1 mm, 2 mm], [3 mm]]"]);
}

#[test]
fn errors_carry_place_and_calls() {
    let text = format!("{FRICTION} function force(in v) {{ return 2*friction(v); }} print(force(3 m/s));");
    let program = check(&text);
    let at = |what: &str| text.rfind(what).unwrap() as u32;
    for start in [
        provided(|host| host.add("friction", |v: f64| if v < 0.0 { Ok(v) } else { Err("it slips") })),
        provided(|host| host.add("friction", |v: f64| if v < 0.0 { v } else { panic!("it slips") })),
    ] {
        let error = both(&program, &start).result.unwrap_err();
        assert_eq!(error.code, "E0725");
        assert!(error.message.ends_with("it slips"), "{}", error.message);
        // The location of the function's declaration; then the calls that lead to it, innermost
        // first.
        assert_eq!(error.place.map(|place| place.1), Some(text.find("friction").unwrap() as u32));
        let calls = error.details.calls.iter();
        let calls: Vec<_> = calls.map(|call| (call.function.as_str(), call.place.1)).collect();
        assert_eq!(calls, [("friction", at("friction(v)")), ("force", at("force(3"))]);
    }
}

#[test]
fn errors_can_be_caught() {
    let text = format!(
        "{FRICTION} try {{ print(friction(1 m/s)); }} catch (error) {{ print(error.code, error.message); }}
         print(\"on\");"
    );
    let start = provided(|host| host.add("friction", |v: f64| if v < 0.0 { Ok(v) } else { Err("it slips") }));
    assert_eq!(printed(&text, &start), ["E0725 it slips", "on"]);
}

#[test]
fn recursion_keeps_its_limit_and_cancelling_its_effect() {
    let text = "host function deep(in n: Number) -> Number { return 1 + step(n); }
        function step(in n) { return if (n < 1) 0 else deep(n - 1); }
        print(deep(3)); print(step(5000));";
    let program = check(text);
    let outcome = both(&program, &Start::default());
    assert_eq!(
        (outcome.printed, outcome.result.unwrap_err().code.as_str()),
        (vec!["4".into()], codes::DEPTH)
    );
    // The closure ends the recursion.
    let start = provided(|host| host.add("deep", |n: f64| n));
    assert_eq!(both(&program, &start).printed, ["3", "4999"]);
    let start = Start { cancelled: true, ..provided(|host| host.add("deep", |_: f64| 0.0)) };
    assert_eq!(both(&program, &start).failure().0, codes::CANCELLED);
}

/// A function sees the surrounding variables also if another program provides it.
#[test]
fn variables_of_the_model_stay_as_they_are() {
    let text = "var calls = 0; host function f(in n: Number) -> Number { calls = calls + 1; return n; }
        print(f(1) + f(2), calls);";
    assert_eq!(printed(text, &Start::default()), ["3 2"]);
    assert_eq!(printed(text, &provided(|host| host.add("f", |n: f64| 10.0 * n))), ["30 0"]);
}

#[test]
fn they_are_listed_in_the_order_of_the_text() {
    let program = check(
        "host function b() -> Number { return 1; } /// First.\nhost function a() -> Number { return b(); }",
    );
    let names: Vec<_> = program.host_functions.iter().map(|f| (f.name.as_str(), f.doc.as_str())).collect();
    assert_eq!(names, [("b", ""), ("a", "First.")]);
}

#[test]
fn fifty_threads_call_one_closure() {
    let text = format!(
        "{FRICTION} var sum = 0; for (var i = 0; i < 20; i = i + 1) sum = sum + friction(i*1 m/s); print(sum);"
    );
    let program = check(&text);
    let module = kept(&program, calyx_codegen::TargetCpu::Native);
    let calls = Arc::new(AtomicUsize::new(0));
    let mut host = HostFunctions::default();
    let counted = calls.clone();
    host.add("friction", move |v: f64| {
        counted.fetch_add(1, Ordering::Relaxed);
        v
    });
    let described = calyx_lang::description::describe(&program, Default::default()).host_functions;
    let functions = host.resolve(&described).unwrap();
    std::thread::scope(|scope| {
        for _ in 0..50 {
            scope.spawn(|| {
                let mut context = calyx_abi::Context::new(Box::new(()));
                context.host_functions = functions.clone();
                let (sent, lines) = std::sync::mpsc::channel();
                context.print = Box::new(move |line| sent.send(line.to_owned()).unwrap());
                module.run_main(&mut context).unwrap();
                assert_eq!(lines.try_recv().as_deref(), Ok("190"));
            });
        }
    });
    assert_eq!(calls.load(Ordering::Relaxed), 1000);
}
