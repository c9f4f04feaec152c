//! Tests that no text makes the parser panic, overflow the stack or take long: mutated programs,
//! random tokens, deep nesting.

use calyx_lang::diagnostic::Severity;
use calyx_lang::parser::parse;
use calyx_lang::span::FileId;
use std::fs;
use std::path::Path;

/// The xorshift64* generator, the same on every machine.
struct Random(u64);

impl Random {
    fn below(&mut self, limit: usize) -> usize {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        (self.0.wrapping_mul(0x2545_F491_4F6C_DD1D) >> 33) as usize % limit.max(1)
    }
}

fn corpus() -> Vec<String> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut texts = Vec::new();
    for folder in ["../examples", "../stdlib-gears/calyx", "tests/syntax"] {
        let mut paths: Vec<_> = fs::read_dir(root.join(folder)).unwrap().map(|e| e.unwrap().path()).collect();
        paths.sort();
        texts.extend(paths.iter().filter(|p| p.is_file()).map(|p| fs::read_to_string(p).unwrap()));
    }
    texts
}

/// Asserts that every span is within the text and on character boundaries, which renderers and
/// editors require.
fn check(text: &str) {
    let (module, diagnostics) = parse(FileId(0), text);
    let inside = |start: u32, end: u32| {
        assert!(start <= end, "{start}..{end} of {text:?}");
        assert!(text.get(start as usize..end as usize).is_some(), "{start}..{end} of {text:?}");
    };
    for d in &diagnostics {
        inside(d.primary.span.start, d.primary.span.end);
        for label in &d.labels {
            inside(label.span.start, label.span.end);
        }
        for fix in d.fix.iter().chain(&d.suggestions) {
            inside(fix.span.start, fix.span.end);
        }
    }
    for statement in &module.statements {
        inside(statement.span.start, statement.span.end);
    }
}

#[test]
fn mutated_programs_do_not_panic() {
    let mut random = Random(0x9E37_79B9_7F4A_7C15);
    let corpus = corpus();
    let insertions = [
        "(", ")", "[", "]", "{", "}", "\"", "{{", ";", ",", "..", ":=", "é", "/*", "if ", "\\", "\n", "3 ",
        "at ",
    ];
    for _ in 0..3000 {
        let text = &corpus[random.below(corpus.len())];
        // A limited window keeps each case short.
        let characters: Vec<char> = text.chars().collect();
        let length = 1 + random.below(400);
        let start = random.below(characters.len());
        let mut window: Vec<char> = characters[start..(start + length).min(characters.len())].to_vec();
        for _ in 0..1 + random.below(4) {
            let at = random.below(window.len());
            match random.below(4) {
                0 if !window.is_empty() => {
                    window.remove(at);
                }
                1 => {
                    let insertion = insertions[random.below(insertions.len())];
                    window.splice(at..at, insertion.chars());
                }
                2 if !window.is_empty() => window.truncate(at),
                _ => {
                    let other = random.below(window.len());
                    if at < window.len() && other < window.len() {
                        window.swap(at, other);
                    }
                }
            }
        }
        check(&window.into_iter().collect::<String>());
    }
}

#[test]
fn token_soup_does_not_panic() {
    let mut random = Random(42);
    let words = [
        "var", "if", "else", "for", "while", "do", "switch", "case", "default", "break", "return", "goto",
        "throw", "try", "catch", "function", "in", "out", "inout", "TRUE", "import", "units", "param",
        "output", "extern", "at", "a", "b", "Time", "inch", "1", "2.5", "1e3", "\"s\"", "\"{\"", "}\"", "\"",
        "(", ")", "[", "]", "{", "}", ",", ";", ":", ".", "..", "=", ":=", "->", "+", "-", "*", "/", "%",
        "^", "<", "<=", "==", "!=", "&", "&&", "|", "||", "!", "\n", "///d\n", "//c\n", "/*", "*/", "$", "µ",
        "#",
    ];
    for _ in 0..3000 {
        let mut text = String::new();
        for _ in 0..random.below(60) {
            text.push_str(words[random.below(words.len())]);
            if random.below(4) > 0 {
                text.push(' ');
            }
        }
        check(&text);
    }
}

#[test]
fn any_characters_do_not_panic() {
    let mut random = Random(7);
    for _ in 0..2000 {
        let length = random.below(60);
        let text: String = (0..length).filter_map(|_| char::from_u32(random.below(0x500) as u32)).collect();
        check(&text);
    }
    for text in [
        "",
        "\u{feff}",
        "\u{feff}x = 1;",
        "\0",
        "\r\n",
        "x = \"\r\n",
        "/",
        "/*",
        "/*/",
        ".",
        "\"{",
        "1e",
        "1.",
    ] {
        check(text);
    }
}

#[test]
fn nesting_has_a_limit_and_an_error() {
    let many = 20_000;
    for text in [
        "(".repeat(1_000_000),
        "x = ".to_string() + &"[".repeat(many),
        "{".repeat(many),
        "x = ".to_string() + &"-".repeat(many) + "1;",
        "x = 1".to_string() + &" + 1".repeat(many) + ";",
        "x = 2".to_string() + &"^2".repeat(many) + ";",
        "x = a".to_string() + &"[0]".repeat(many) + ";",
        "x = f".to_string() + &"()".repeat(many) + ";",
        "x = a".to_string() + &".b".repeat(many) + ";",
        "if (a) ".repeat(many),
        "if (a) ; else ".repeat(many),
        "if (a) {} else ".repeat(many),
        "while (a) ".repeat(many),
        "do ".repeat(many),
        "try ; catch () ".repeat(many),
        "a: ".repeat(many),
        "case 1: ".repeat(many),
        "default: ".repeat(many),
        "for (;;) ".repeat(many),
        "function f() ".repeat(many),
        "\"{".repeat(many),
        "x = if (a) b else ".repeat(many),
        "x = a at b = ".repeat(many),
        "function f(in a: ".to_string() + &"Array(".repeat(many),
        "function f(in a: A".to_string() + &"^2".repeat(many),
    ] {
        let (_, diagnostics) = parse(FileId(0), &text);
        let start: String = text.chars().take(20).collect();
        assert!(
            diagnostics.iter().any(|d| d.code == "E0106" || d.code == "E0103"),
            "{start}: {diagnostics:?}"
        );
        assert!(diagnostics.len() < 4, "{start}");
    }
}

/// The deepest accepted nesting must not overflow an ordinary stack in any traversal.
#[test]
fn nesting_below_the_limit_parses() {
    for text in [
        "x = ".to_string() + &"(".repeat(250) + "1" + &")".repeat(250) + ";",
        "x = ".to_string() + &"-".repeat(390) + "1;",
        "x = 1".to_string() + &" + 1".repeat(390) + ";",
        "x = 2".to_string() + &"^2".repeat(390) + ";",
        "{".repeat(250) + &"}".repeat(250),
        "if (a) ; else ".repeat(120) + ";",
        "a: ".repeat(390) + ";",
        "x = ".to_string() + &"[".repeat(250) + &"]".repeat(250) + ";",
        "x = [".to_string() + &"1, ".repeat(100_000) + "];",
        "x = 1;\n".repeat(10_000),
    ] {
        let (module, diagnostics) = parse(FileId(0), &text);
        let start: String = text.chars().take(20).collect();
        assert!(diagnostics.is_empty(), "{start}: {diagnostics:?}");
        assert_eq!(module.clone(), module);
    }
}

/// A file full of errors is parsed in linear time.
#[test]
fn many_errors_are_all_reported() {
    for broken in ["x = ;\n", "f(1 2);\n", "var = 3;\n", "x = $;\n", "} \n", "y = [1 2];\n"] {
        let text = broken.repeat(5_000);
        let (_, diagnostics) = parse(FileId(0), &text);
        assert!(diagnostics.len() >= 5_000, "{broken}: {}", diagnostics.len());
        assert!(diagnostics.iter().all(|d| d.severity == Severity::Error));
    }
}
