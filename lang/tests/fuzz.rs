//! Fuzz tests with programs from the grammar, valid and mutated, and with arbitrary texts. No stage
//! may panic or overflow the stack, diagnostics must be within the text, and formatting must
//! preserve valid programs.
//!
//! `CALYX_FUZZ=100000 cargo test -p calyx-lang --test all fuzz` makes that many of each kind;
//! `CALYX_FUZZ_SEED` changes the random seed.

use crate::formatting::judge;
use crate::grammar::{Grammar, Piece, Random, written};
use crate::library::{Library, folder, improper};
use calyx_lang::check_program;
use calyx_lang::diagnostic::Severity;
use calyx_lang::lexer::lex;
use calyx_lang::parser::parse;
use calyx_lang::span::FileId;
use std::collections::BTreeSet;
use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// Returns the number of cases of each kind.
fn count(few: usize) -> usize {
    std::env::var("CALYX_FUZZ").ok().and_then(|n| n.parse().ok()).unwrap_or(few)
}

fn random(stream: u64) -> Random {
    let seed = std::env::var("CALYX_FUZZ_SEED").ok().and_then(|n| n.parse().ok()).unwrap_or(0_u64);
    Random((0x9E37_79B9_7F4A_7C15 ^ stream).wrapping_add(seed.wrapping_mul(0xD134_2543_DE82_EF95)) | 1)
}

/// Returns a description of the failure of any stage on a text; `None` without a failure.
fn trouble(text: &str, library: &Library) -> Option<String> {
    let stages = AssertUnwindSafe(|| {
        let tokens = lex(FileId(0), text);
        let mut places = tokens.tokens.iter().map(|t| t.span).chain(tokens.comments.iter().map(|c| c.span));
        if places.any(|span| text.get(span.start as usize..span.end as usize).is_none()) {
            return Some("a token lies outside the text".into());
        }
        let (_, diagnostics) = parse(FileId(0), text);
        if let Some(problem) = improper(&diagnostics, text) {
            return Some(problem);
        }
        if let Err(problem) = judge(text) {
            return Some(problem);
        }
        improper(&check_program("model.cx", text, library).diagnostics, text)
    });
    catch_unwind(stages).unwrap_or_else(|_| Some("panic".into()))
}

/// Returns the smallest failing part of a failing text, found by removing pieces.
fn shrunk(text: &str, troublesome: impl Fn(&str) -> bool) -> String {
    let mut characters: Vec<char> = text.chars().collect();
    let mut length = characters.len() / 2;
    while length > 0 {
        let mut start = 0;
        while start < characters.len() {
            let mut shorter = characters.clone();
            shorter.drain(start..(start + length).min(characters.len()));
            if troublesome(&shorter.iter().collect::<String>()) {
                characters = shorter;
            } else {
                start += length;
            }
        }
        length /= 2;
    }
    characters.into_iter().collect()
}

fn survives(text: &str, library: &Library) {
    if trouble(text, library).is_some() {
        let small = shrunk(text, |text| trouble(text, library).is_some());
        let problem = trouble(&small, library).unwrap_or_default();
        panic!("{problem}\n--- the text\n{small}\n--- was part of\n{text}");
    }
}

/// Returns the variants of an enumeration in `src/ast.rs`.
fn variants(name: &str) -> BTreeSet<String> {
    let source = fs::read_to_string(folder("src/ast.rs")).expect("the tree");
    let begin = source.find(&format!("pub enum {name} {{")).expect("the enumeration");
    let body = source[begin..].split("\n}").next().expect("it ends");
    let variant = |line: &str| {
        let name: String = line.strip_prefix("    ")?.chars().take_while(|c| c.is_alphanumeric()).collect();
        name.starts_with(char::is_uppercase).then_some(name)
    };
    body.lines().filter_map(variant).collect()
}

#[test]
fn programs_of_the_grammar_are_read_and_formatted() {
    let grammar = Grammar::of_the_reference();
    let mut random = random(1);
    let mut kinds = BTreeSet::new();
    for round in 0..count(2500) {
        // A call with an argument is 28 rules deep.
        let pieces = grammar.program(&mut random, 4 + round % 32);
        let text = written(&pieces, &mut random);
        let (module, diagnostics) = parse(FileId(0), &text);
        let errors: Vec<_> = diagnostics.iter().filter(|d| d.severity == Severity::Error).collect();
        let too_deep = errors.iter().any(|d| d.code == "E0106");
        if let Some(error) = errors.first().filter(|_| !too_deep) {
            let (before, after) = text.split_at(error.primary.span.start as usize);
            let before: String = before.chars().rev().take(200).collect::<Vec<_>>().iter().rev().collect();
            panic!("{}: {}\n{before}<-- here -->{after:.100}", error.code, error.message);
        }
        if judge(&text).is_err() {
            let small = shrunk(&text, |text| judge(text).is_err());
            let problem = judge(&small).err().unwrap_or_default();
            panic!("{problem}\n--- the text\n{small}\n--- was part of\n{text}");
        }
        if kinds.len() < 200 && round < 3000 {
            let shown = format!("{module:?}");
            kinds.extend(
                shown
                    .split("kind: ")
                    .skip(1)
                    .map(|rest| rest.chars().take_while(|c| c.is_alphanumeric()).collect::<String>()),
            );
        }
    }
    for name in ["StmtKind", "ExprKind", "TypeKind"] {
        for variant in variants(name).iter().filter(|v| *v != "Error") {
            assert!(kinds.contains(variant), "the grammar of the reference makes no {name}::{variant}");
        }
    }
}

/// Deletes, duplicates, exchanges or inserts tokens, or truncates the text.
fn mutate(pieces: &mut Vec<Piece>, words: &[&str], random: &mut Random) {
    for _ in 0..1 + random.below(4) {
        let at = random.below(pieces.len());
        match random.below(6) {
            _ if pieces.is_empty() => return,
            0 | 1 => drop(pieces.remove(at)),
            2 => pieces.insert(at, pieces[at].clone()),
            3 => {
                let other = random.below(pieces.len());
                pieces.swap(at, other);
            }
            4 => pieces.insert(at, Piece { text: random.pick(words).into(), same_line: false }),
            _ => pieces.truncate(at + pieces.len() / 2),
        }
    }
}

const WORDS: &[&str] = &[
    "var",
    "if",
    "else",
    "for",
    "while",
    "do",
    "switch",
    "case",
    "default",
    "break",
    "return",
    "goto",
    "throw",
    "try",
    "catch",
    "function",
    "in",
    "out",
    "TRUE",
    "import",
    "units",
    "param",
    "output",
    "extern",
    "private",
    "test",
    "host",
    "at",
    "const",
    "record",
    "component",
    "unit",
    "dimension",
    "(",
    ")",
    "[",
    "]",
    "{",
    "}",
    ",",
    ";",
    ":",
    ".",
    "..",
    "=",
    ":=",
    "->",
    "+",
    "-",
    "^",
    "<",
    "&&",
    "!",
    "\"",
    "1",
    "x",
    "true",
    "$",
    "/*",
    "///",
    "#",
    "'",
];

#[test]
fn broken_programs_do_no_harm() {
    let grammar = Grammar::of_the_reference();
    let library = Library::read();
    let mut random = random(2);
    for round in 0..count(1000) {
        let mut pieces = grammar.program(&mut random, 4 + round % 16);
        mutate(&mut pieces, WORDS, &mut random);
        survives(&written(&pieces, &mut random), &library);
    }
}

/// Mutates a few tokens of handwritten programs, which are meaningful to the checker.
#[test]
fn broken_models_do_no_harm() {
    let library = Library::read();
    let mut random = random(3);
    let mut models = Vec::new();
    for name in ["../examples/spur_pair.cx", "../docs/reference.md", "tests/check", "tests/syntax"] {
        let path = folder(name);
        let files = if path.is_dir() {
            fs::read_dir(&path).expect("pages").map(|e| e.expect("a page").path()).collect()
        } else {
            vec![path]
        };
        for file in files {
            let text = fs::read_to_string(&file).expect("readable");
            if name.ends_with(".cx") {
                models.push(text);
            } else {
                let blocks = text.split("```cx").skip(1).filter_map(|block| block.split("```").next());
                models.extend(blocks.filter_map(|block| Some(block.split_once('\n')?.1.to_string())));
            }
        }
    }
    models.sort();
    assert!(models.len() > 80, "only {} models", models.len());
    for _ in 0..count(1500) {
        let text = &models[random.below(models.len())];
        let tokens = lex(FileId(0), text).tokens;
        let mut pieces: Vec<Piece> = tokens
            .iter()
            .map(|t| Piece { text: text[t.span.start as usize..t.span.end as usize].into(), same_line: true })
            .collect();
        // Tokens from other positions, which fit more likely than single words.
        let names: Vec<String> = pieces.iter().map(|p| p.text.clone()).collect();
        let mut words: Vec<&str> = names.iter().map(String::as_str).collect();
        words.extend(WORDS);
        mutate(&mut pieces, &words, &mut random);
        let joined: String = pieces.iter().map(|p| format!("{} ", p.text)).collect();
        survives(&joined, &library);
    }
}

/// Picks a text and replaces `#` by a record, `@` by a function and `$` by an expression.
fn random_of(choices: &[&str], depth: usize, random: &mut Random) -> String {
    const EXPRESSIONS: &[&str] = &[
        "p",
        "q",
        "v",
        "#()",
        "1",
        "2 mm",
        "[]",
        "p.x",
        "p.next",
        "q.x",
        "p.all[0]",
        "v.next.x",
        "$.x",
        "$.next",
        "$[0]",
        "#(x = $)",
        "#($, $)",
        "@($, $)",
        "[$, $]",
        "[$]",
        "$ + $",
        "$*$",
        "$/$",
        "$ == $",
        "\"{$}\"",
        "if (TRUE) $ else $",
        "len($)",
    ];
    let mut text = String::new();
    for c in random.pick(choices).chars() {
        match c {
            '#' => text.push_str(random.pick(&["P", "Q", "R"])),
            '@' => text.push_str(random.pick(&["f", "g", "h"])),
            // The first choices are leaves.
            '$' if depth == 0 => text += &random_of(&EXPRESSIONS[..12], 0, random),
            '$' => text += &random_of(EXPRESSIONS, depth - 1, random),
            c => text.push(c),
        }
    }
    text
}

/// Returns a program of records whose fields have types, defaults, both or neither, and of
/// functions that use the fields in random ways.
fn half_typed_records(random: &mut Random) -> String {
    const FIELDS: &[&str] = &[
        ";",
        ";",
        ": #;",
        ": Array(#);",
        ": Number;",
        ": Length;",
        ": Array;",
        " = #();",
        " = [];",
        " = [#()];",
        " = [[], 1];",
        " = 1;",
        " = 2 mm;",
        ": # = #();",
        ": Array(#) = [];",
        " = $;",
    ];
    const STATEMENTS: &[&str] = &[
        "return $;",
        "return $;",
        "return p;",
        "p = $;",
        "p.x = $;",
        "p.next = $;",
        "p.all[0] = $;",
        "v = $;",
        "push(p.all, $);",
        "push(v, $);",
        "if ($ == $) return $;",
        "print($);",
        "@($, $);",
        "@(p, q);",
        "throw $;",
    ];
    let mut text = String::new();
    for name in ["P", "Q", "R"] {
        text += &format!("record {name} {{ ");
        for field in ["x", "next", "all"].iter().take(1 + random.below(3)) {
            text += &format!("{field}{} ", random_of(FIELDS, 1, random));
        }
        text += "}\n";
    }
    for name in ["f", "g", "h"] {
        let header = random_of(
            &["(in p, in q)", "(inout p, in q)", "(in p: #, in q)", "(in p, in q = #())"],
            0,
            random,
        );
        text += &format!("function {name}{header} {{ var v; ");
        for _ in 0..1 + random.below(4) {
            text += &random_of(STATEMENTS, 2, random);
        }
        text += "}\n";
    }
    text += "var p = #(); var q = #(); var v; ";
    (0..1 + random.below(6)).for_each(|_| text += &random_of(STATEMENTS, 2, random));
    random_of(&[&text.replace('$', "1").replace('@', "f")], 0, random)
}

#[test]
fn half_typed_records_do_no_harm() {
    let library = Library::read();
    let mut random = random(5);
    for _ in 0..count(600) {
        survives(&half_typed_records(&mut random), &library);
    }
}

#[test]
fn any_text_does_no_harm() {
    let library = Library::read();
    let mut random = random(4);
    for round in 0..count(2500) {
        let length = random.below(80);
        let text: String = match round % 3 {
            0 => {
                let bytes: Vec<u8> = (0..length).map(|_| random.below(256) as u8).collect();
                String::from_utf8_lossy(&bytes).into_owned()
            }
            1 => (0..length).filter_map(|_| char::from_u32(random.below(0x3000) as u32)).collect(),
            _ => (0..length).map(|_| random.pick(WORDS)).collect(),
        };
        survives(&text, &library);
    }
}
