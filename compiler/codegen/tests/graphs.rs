//! Tests expressions that are chosen at run time: built in loops, on one of several branches,
//! passed to functions. They have the values and derivatives of the same expression written in
//! full, in the interpreter and in machine code.

use crate::common::text::{check, defaults};
use crate::common::{Start, both};
use calyx_lang::ir::Program;
use calyx_lower::kernels::lower_sites;

/// Returns the lines printed by both evaluators.
#[track_caller]
fn printed(program: &Program) -> Vec<String> {
    let start = Start { params: defaults(program), ..Start::default() };
    let outcome = both(program, &start);
    if outcome.result.is_err() {
        panic!("{:?}", outcome.failure());
    }
    outcome.printed
}

#[track_caller]
fn assert_prints(text: &str, lines: &[&str]) {
    assert_eq!(printed(&check(text)), lines, "{text}");
}

#[test]
fn a_chain_built_in_a_loop_is_the_chain_written_out() {
    let joint =
        |k: &str| format!("Translate(lengths[{k}]*e1) * Rotate(rates[{k}]*Time + {k}*0.1 rad, axes[{k}])");
    let written: Vec<String> = (0..12).map(|k| joint(&k.to_string())).collect();
    let text = format!(
        "var axes = [e1, e2, e3]; var rates = [0.1 rad/s]; var lengths = [0.2 m];
         for (var i = 1; i < 12; i = i + 1) {{
             push(rates, (0.3 - 0.05*i)*1 rad/s); push(lengths, (0.2 + 0.01*i)*1 m); push(axes, axes[i - 1]);
         }}
         var built := Translate(0*e1);
         for (var i = 0; i < 12; i = i + 1) {{ built := built * {}; }}
         var direct := {};
         for (var k = 0; k < 5; k = k + 1) {{
             var t = (0.3 + 0.7*k)*1 s;
             print(norm((origin(built) at Time = t) - (origin(direct) at Time = t)) < 1e-13*2 m,
                 norm((direction(built, e1) at Time = t) - (direction(direct, e1) at Time = t)) < 1e-13,
                 norm((velocity(built) at Time = t) - (velocity(direct) at Time = t)) < 1e-13*2 m/s,
                 norm((acceleration(built) at Time = t) - (acceleration(direct) at Time = t)) < 1e-13*2 m/s^2,
                 norm((angular_velocity(built) at Time = t) - (angular_velocity(direct) at Time = t)) < 1e-13/s,
                 norm((angular_acceleration(built) at Time = t) - (angular_acceleration(direct) at Time = t))
                     < 1e-13/s^2);
         }}
         print(norm(acceleration(direct) at Time = 1 s) > 0.01 m/s^2);",
        joint("i"),
        written.join(" * "),
    );
    let mut lines = vec!["TRUE TRUE TRUE TRUE TRUE TRUE"; 5];
    lines.push("TRUE");
    assert_prints(&text, &lines);
}

#[test]
fn planets_in_a_loop_are_one_kernel() {
    let program = check(
        "var carrier := Rotate(2 rad/s*Time, e3);
         var places = [0 m];
         for (var i = 0; i < 4; i = i + 1) {
             var planet := Rotate(3 rad/s*Time, e3) * Translate(10 m*e2) * Rotate(i*pi/2, e3) * carrier;
             push(places, origin(planet).y at Time = 0 s);
         }
         print(round(places[1]/1 m), round(places[2]/1 m), round(places[3]/1 m), round(places[4]/1 m) + 0);",
    );
    assert_eq!(
        program.sites.iter().filter(|site| site.name.contains("at")).count(),
        1,
        "{:#?}",
        program.sites
    );
    assert_eq!(program.sites.len(), 1);
    assert_eq!(printed(&program), ["10 0 -10 0"]);
}

#[test]
fn derivatives_go_through_expressions_chosen_at_run_time() {
    // 5*p^3*Time^3
    assert_prints(
        "param p = 2; param q = 3;
         var x := 5*p^0*(Time/1 s)^0;
         for (var i = 0; i < 3; i = i + 1) x := x*p*Time/1 s;
         var v := derivative(x, Time);
         print(x at Time = 2 s, v at Time = 2 s, (derivative(v, Time)*1 s^2) at Time = 2 s, derivative(x, p) at Time = 2 s,
             derivative(derivative(x, Time), p) at Time = 2 s, derivative(x, q) at Time = 2 s);",
        &["320 480 1/s 480 480 720 1/s 0"],
    );
    assert_prints(
        "param fast = TRUE;
         var x := 2 m; var y := x;
         if (fast) x := 3 m/s*Time; else x := 1 m/s*Time;
         y := x + y;
         print(x at Time = 2 s, y at Time = 2 s, derivative(y, Time) at Time = 0 s);",
        &["6 m 8 m 3 m/s"],
    );
}

#[test]
fn functions_take_expressions() {
    assert_prints(
        "function speed(in frame :=, in at_time) { return norm(velocity(frame) at Time = at_time); }
         function moved(in frame := Translate(1 m*e1), in by = 2 m) {
             var on := Translate(by*e1) * frame;
             return origin(on) at Time = 1 s;
         }
         var turning := Translate(2 m*e1) * Rotate(3 rad/s*Time, e3);
         print(round(speed(frame := turning, at_time = 1 s)/1 m*1 s), moved(), moved(frame := turning * Rotate(0, e1)).z);
         function twice(in x :=) { return inner(x := 2*x); }
         function inner(in x :=) { return derivative(x, Time) at Time = 3 s; }
         print(twice(x := Time^2));",
        &["6 [3 m, 0 m, 0 m] 0 m", "12 s"],
    );
}

#[test]
fn the_side_not_taken_leaves_no_trace() {
    // Value and derivatives at the singular point, where the guard selects the other arm.
    for (guarded, expected) in [
        ("if (x > 0) sqrt(x) else 3*x", "0 3"),
        ("if (x != 0) 1/x else x", "0 1"),
        ("if (x != 0) sin(x)/x else 1", "1 0"),
        ("if (x != 0) sin(atan2(x, x*x)) else 2*x", "0 2"),
        ("if (x > 0) x^0.5 + x^x else 5*x", "0 5"),
        ("if (x > 0) log(x)*sin(acos(x + 1)) else x^2", "0 0"),
        ("(if (x > 0) sqrt(x) else 3*x)^2 + (if (x != 0) 1/x else x)*x", "0 0"),
    ] {
        assert_prints(
            &format!(
                "function f(in x) := {guarded}; function g(in x) := derivative(f(x), x);
                 var moving := f(Time/1 s);
                 print(f(0), g(0)); print(moving at Time = 0 s, (derivative(moving, Time)*1 s) at Time = 0 s);"
            ),
            &[expected, expected],
        );
    }
}

#[test]
fn derivatives_follow_their_conventions_where_they_do_not_exist() {
    for (expression, at, slope) in [
        ("abs(x)", "0", "1"),
        ("max(x, 2*x)", "0", "1"),
        ("min(x, 2*x)", "0", "1"),
        ("floor(x) + ceil(x) + round(x)", "1", "0"),
        ("sqrt(x)", "0", "inf"),
        ("asin(x)", "1", "inf"),
        ("acos(x)", "1", "-inf"),
        ("x^0.5", "0", "inf"),
        ("x^1", "0", "1"),
        ("x^0", "0", "0"),
        ("atan2(x, x*x)", "0", "nan"),
        ("norm(x*e1)", "0", "nan"),
    ] {
        let text = format!(
            "function f(in x) := {expression}; function g(in x) := derivative(f(x), x); print(\"{{g({at})}}\");"
        );
        let found = printed(&check(&text));
        // Angles include their unit.
        let found: Vec<&str> = found.iter().filter_map(|line| line.split(' ').next()).collect();
        assert_eq!(found, [slope], "{expression}");
    }
}

#[test]
fn ordinary_functions_become_part_of_expressions() {
    assert_prints(
        "function decay(in x) { var y = x^2; return y + 2*y^2; }
         function twice(in x) { return 2*decay(x); }
         var moving := twice(Time/1 s);
         function around(in u) := derivative(decay(u)*u, u);
         print(moving at Time = 1 s, (derivative(moving, Time)*1 s) at Time = 1 s, around(1));",
        &["6 20 13"],
    );
}

#[test]
fn other_functions_bind_names_too() {
    assert_prints(
        "var f := 2*Time;
         function rebind(in k) { f := k*f; }
         print(f at Time = 1 s); rebind(3); rebind(5); print(f at Time = 1 s, derivative(f, Time) at Time = 0 s);",
        &["2 s", "30 s 30"],
    );
}

#[test]
fn what_lies_beyond_is_an_error_and_never_zero() {
    let program = check(
        "var x := Time^5; for (var i = 0; i < 2; i = i + 1) x := 2*x;
         print(derivative(derivative(derivative(x, Time), Time), Time) at Time = 1 s);",
    );
    let error = lower_sites(&program).unwrap_err();
    assert!(error.message.contains("only two derivatives"), "{error}");
    let program = check(
        "param p = 2; var x := p^5; for (var i = 0; i < 2; i = i + 1) x := 2*x;
         print(derivative(derivative(x, p), p));",
    );
    assert!(lower_sites(&program).is_err());
}

#[test]
fn expressions_one_inside_another_are_limited() {
    let program =
        check("var x := Time; for (var i = 0; i < 5000; i = i + 1) x := x + 1 s; print(x at Time = 0 s);");
    let outcome = both(&program, &Start::default());
    assert_eq!(outcome.failure().0, "E0702");
}
