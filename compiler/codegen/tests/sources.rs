//! Tests the compiler from text to output: small models print the same lines in both evaluators,
//! and the example compiles.

use crate::common::text::{check, read};
use crate::common::*;
use calyx_abi::Fingerprint;
use calyx_codegen::ObjectOptions;

/// Models with the lines they print, or the code of their error.
const MODELS: &[(&str, &[&str])] = &[
    ("units inch_lbf_s; var x = 3 inch; print(\"{x} and {2 * x}\");", &["3 inch and 6 inch"]),
    (
        "var sum = 0; var i = 0; while (i < 5) { i = i + 1; if (i != 3) sum = sum + i^2; } print(\"{sum}\");",
        &["46"],
    ),
    ("function f(in n) { return if (n < 2) 1 else n * f(n - 1); } print(\"{f(10)}\");", &["3628800"]),
    (
        "function swap(inout a, inout b) { var t = a; a = b; b = t; }
         var v = [1, 2, 3]; swap(v[0], v[2]); push(v, 4); print(\"{v} {len(v)}\");",
        &["[3, 2, 1, 4] 4"],
    ),
    ("var a = [1, 2]; var b = a; b[0] = 9; print(\"{a} {b} {a == b}\");", &["[1, 2] [9, 2] FALSE"]),
    (
        "var c = 2; var x := c * Time^2; var y = x at Time = 3 s; print(\"{y}\");
         var v = velocity(Translate(3 m/s * Time * e1)) at Time = 1 s; print(\"{v.x}\");",
        &["18 s^2", "3 m/s"],
    ),
    (
        "record Gear { teeth = 20; width = 2 mm; marks = [1, 2]; }
         record Pair { a = Gear(); b = Gear(teeth = 31); names = [\"p\"]; }
         function turn(inout pair, in by) { pair.a.teeth = pair.a.teeth + by; pair.a.marks[1] = by; }
         function area(in teeth, in width, in marks) { return teeth*width*len(marks); }
         const more = 2*4;
         var p = Pair(); var q = p; turn(p, more);
         var all = [p, q]; all[1].b.width = 3 mm; push(all[1].names, \"q\"); p.b = all[1].b;
         print(p.a.teeth, p.a.marks, q.a.marks, all[0] == p, all[1].names, q.names, p.b.width == 3 mm);
         print(area(..p.a, width = 1 mm) == 56 mm, p.b == Gear(..p.b), p.b != Gear(..p.b, marks = []));",
        &["28 [1, 8] [1, 2] FALSE [p, q] [p] TRUE", "TRUE TRUE TRUE"],
    ),
    (
        "record P { x = 1; } record Q { name = \"n\"; x = 2; } record R { x = 3; name = \"m\"; }
         function first(in p) { return p.x; } function set(inout p, in x) { p.x = x; }
         var q = Q(); set(q, 7); var r = R(); set(r, 8);
         print(first(P()), first(q), first(r), first(4*e1), q.name, r.name);",
        &["1 7 8 4 n m"],
    ),
    (
        "units mm_N_s; dimension Cost; unit euro: Cost; unit cent = 0.01 euro;
         record Part { n = 3; at = -0*e1; price = 2 euro; tags = [\"a\"]; }
         var all = [Part(), Part(n = 4, at = 2 mm * e2)];
         print(all[0], all); print([3 N, \"x\", 10 um], Translate(1 inch * e1), -(0 mm * e1));
         function wide(in v) { return \"{v : 9.2 inch}|{v : e}|{v : .1e}\"; }
         print(wide(1 inch), wide(10 um), \"{[1 mm, 2 mm] : .3 um} {all[0].price : cent} {all[0] : .1}\");
         print(\"{\"ab\" : 4}|{TRUE : 6}|{1/3 : .3}|{1/3 : 8.1 %}|{5% : %}\");",
        &[
            "Part(n = 3, at = [0 mm, 0 mm, 0 mm], price = 2 euro, tags = [a]) \
             [Part(n = 3, at = [0 mm, 0 mm, 0 mm], price = 2 euro, tags = [a]), \
             Part(n = 4, at = [0 mm, 2 mm, 0 mm], price = 2 euro, tags = [a])]",
            "[3 N, x, 0.01 mm] [[1, 0, 0], [0, 1, 0], [0, 0, 1], [-25.4 mm, 0 mm, 0 mm]] [0 mm, 0 mm, 0 mm]",
            "     1.00 inch|2.54e1 mm|2.5e1 mm      0.00 inch|1e-2 mm|1.0e-2 mm \
             [1000.000 um, 2000.000 um] 200 cent \
             Part(n = 3.0, at = [0.0 mm, 0.0 mm, 0.0 mm], price = 2.0 euro, tags = [a])",
            "ab  |TRUE  |0.333|    33.3 %|5 %",
        ],
    ),
    (
        "var xs = [0 mm, 1 mm, 3 mm, 4 mm]; var ys = [0 N, 2 N, 2 N, 6 N];
         print(interpolate(xs, ys, 2 mm) == 2 N, interpolate(xs, ys, 0.5 mm), interpolate(xs, ys, 4 mm));
         print(interpolate(xs, ys, 2 mm, \"monotone\"), interpolate(xs, ys, 0.25 mm, \"monotone\") > 0.5 N);
         print(interpolate(xs, ys, 5 mm));",
        &["TRUE 1 N 6 N", "2 N TRUE", "E0821"],
    ),
    ("print(\"before\"); var a = [1]; print(\"{a[1]}\");", &["before", "E0701"]),
];

#[test]
fn models_print_the_same_by_both_evaluators() {
    for (text, expected) in MODELS {
        let outcome = both(&check(text), &Start::default());
        let mut lines = outcome.printed.clone();
        if outcome.result.is_err() {
            lines.push(outcome.failure().0.into());
        }
        assert_eq!(lines, *expected, "{text}\n{:?}", outcome.result);
    }
}

#[test]
fn the_example_compiles() {
    let program = check(&read("examples/spur_pair.cx"));
    let abi = Fingerprint::of(&[&externs()]);
    let description =
        calyx_lang::description::to_json(&calyx_lang::description::describe(&program, abi)).unwrap();
    let options = ObjectOptions::new("spur_pair", &description, abi);
    let object = calyx_codegen::compile_object(&program, &options).unwrap();
    assert!(object.len() > description.len());
}
