//! Tests extreme sizes: texts with a million nested brackets, or many thousand operators, dots or
//! letters pass through all stages without a panic or stack overflow. `CALYX_SIZE=1000000` sets the
//! size of all texts; the times are printed.

use crate::library::{Library, improper};
use calyx_lang::check_program;
use calyx_lang::format::format;
use std::sync::Mutex;
use std::time::Instant;

/// Texts of repeated brackets, very long names and similar inputs terminate in all stages.
#[test]
fn endless_texts_have_an_answer() {
    let library = Library::read();
    let million = 1_000_000;
    let many = std::env::var("CALYX_SIZE").ok().and_then(|n| n.parse().ok()).unwrap_or(4_000);
    let repeated = |begin: &str, part: &str, end: &str| format!("{begin}{}{end}", part.repeat(many));
    let texts = [
        format!("x = {}", "(".repeat(million)),
        format!("x = {}1{};", "(".repeat(million), ")".repeat(million)),
        repeated("x = ", "[", ""),
        repeated("", "{", ""),
        repeated("", "}", ""),
        repeated("x = ", "-", "1;"),
        repeated("x = ", "!", "a;"),
        repeated("x = a", ".b", ";"),
        repeated("x = a", "[0]", ";"),
        repeated("x = f", "()", ";"),
        repeated("x = 1", " + 1", ";"),
        repeated("x = 2", "^2", ";"),
        repeated("", "if (a) ; else ", ";"),
        repeated("x = ", "if (a) b else ", "c;"),
        repeated("", "\"{", ""),
        repeated("x = ", "\"{a}", "\";"),
        repeated("x = \"", "{a}", "\";"),
        repeated("", "a: ", ";"),
        repeated("", "case 1: ", ";"),
        repeated("function f(in a: ", "Array(", ""),
        repeated("function f(in a: L", "*L", ") ;"),
        repeated("", "n", " = 1;"),
        repeated("x = \"", "n", "\";"),
        repeated("x = 0.", "1", ";"),
        repeated("", "\n", "x = 1"),
        repeated("//", "/", "\n"),
        repeated("", "/* */", ""),
        repeated("", "///\n", ""),
        repeated("x = 1 ", "//\n", ";"),
        repeated("", "$ ", ""),
        repeated("", "x ", ""),
        repeated("", "1 ", ""),
        repeated("", "\"", ""),
        repeated("f(", "a, ", ");"),
        repeated("f(", "a = 1, ", ");"),
        repeated("x = [", "1, ", "];"),
        "x = 1;\n".repeat(20_000),
        "var x = 1;\n".repeat(20_000),
        "{ var x = 1; print(x); }\n".repeat(5_000),
        "function f() { }\n".repeat(4_000),
        (0..20_000).map(|i| format!("var x{i} = {};\n", i.max(1) - 1)).collect(),
        (1..5_000).fold("var x0 = 1;\n".into(), |text, i| text + &format!("var x{i} = 2*x{};\n", i - 1)),
        (1..500).fold("function f0() { }\n".into(), |text, i| {
            text + &format!("function f{i}() {{ f{}(); }}\n", i - 1)
        }),
    ];
    // Chains of declarations and of types, in dependence order and in reverse.
    let chain = |first: &str, next: &str| -> [String; 2] {
        let first = first.replace('#', "0");
        let rest = (1..10_000).map(|i| next.replace('#', &i.to_string()).replace('@', &(i - 1).to_string()));
        let mut lines: Vec<String> = std::iter::once(first).chain(rest).collect();
        let forwards = lines.concat();
        lines.reverse();
        [forwards, lines.concat()]
    };
    let chains = [
        chain("const c# = 1;\n", "const c# = c@ + 1;\n"),
        chain("unit u# = 2 mm;\n", "unit u# = 2 u@;\n"),
        chain("dimension D# = Length;\n", "dimension D# = D@;\n"),
        chain("record R# { x: Number; }\n", "record R# { x: R@; }\n"),
        chain("record R# { x = 1; y = 2; }\n", "record R# { x = R@(); y = R@(); }\n"),
        chain("function f#(in a) { return a; }\n", "function f#(in a) { return f@([a]); }\n"),
        chain("var x#;\n", "var x#; x# = x@;\n"),
        chain("var x#;\n", "var x#; x@ = [x#];\n"),
        chain("units SI; var x# = 1;\n", "var x# = 1; x# = x@;\n"),
        chain(
            "var s = 1; function f#(in a) { return a + s; }\n",
            "function f#(in a) { return f@(a) + s; }\n",
        ),
    ];
    let texts: Vec<String> = texts.into_iter().chain(chains.into_iter().flatten()).collect();
    // The longest text takes seconds, so two run in parallel.
    let texts = Mutex::new(texts.into_iter());
    let next = || texts.lock().expect("no panic").next();
    std::thread::scope(|scope| {
        for _ in 0..2 {
            scope.spawn(|| std::iter::from_fn(next).for_each(|text| has_an_answer(&text, &library)));
        }
    });
}

/// Runs all stages.
fn has_an_answer(text: &str, library: &Library) {
    let begin: String = text.chars().take(30).collect();
    let started = Instant::now();
    let checked = check_program("model.cx", text, library);
    let checking = started.elapsed();
    let formatted = format(text);
    eprintln!(
        "{checking:>10.1?} {:>10.1?} {:>8} {begin:?}",
        started.elapsed() - checking,
        checked.diagnostics.len()
    );
    assert_eq!(improper(&checked.diagnostics, text), None, "{begin}");
    // A text without syntax errors can be formatted.
    assert!(checked.diagnostics.iter().any(|d| d.code.starts_with("E01")) || formatted.is_ok(), "{begin}");
}
