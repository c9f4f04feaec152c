//! Properties of all texts, including those with errors.

use super::changed;
use calyx_lang::check::Loader;
use calyx_lang::db::Database;
use calyx_lang::lexer::CommentKind;
use calyx_lsp::ide::call_hierarchy::{incoming, outgoing, prepare};
use calyx_lsp::ide::code_lenses::lenses;
use calyx_lsp::ide::document_links::links;
use calyx_lsp::ide::folding::folds;
use calyx_lsp::ide::formatting::{format_file, format_selection};
use calyx_lsp::ide::inlay_hints::{HintSettings, Results, hints};
use calyx_lsp::ide::on_type_formatting::typed;
use calyx_lsp::ide::selection::selections;
use calyx_lsp::ide::semantic_tokens::{SemanticToken, difference, tokens};
use calyx_lsp::ide::source::Source;
use calyx_lsp::ide::symbols::{Symbol, Types, symbols};
use calyx_lsp::ide::{Position, Snapshot};
use std::fs;
use std::path::{Path, PathBuf};

/// Xorshift64* generator: reproducible on every machine.
struct Random(u64);

impl Random {
    fn below(&mut self, limit: usize) -> usize {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        (self.0.wrapping_mul(0x2545_F491_4F6C_DD1D) >> 33) as usize % limit.max(1)
    }
}

/// Returns the models of the repository and the library.
fn programs() -> Vec<String> {
    fn collect(folder: &Path, found: &mut Vec<PathBuf>) {
        let mut entries: Vec<PathBuf> =
            fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
        entries.sort();
        for path in entries {
            if path.is_dir() {
                collect(&path, found);
            } else if path.extension().is_some_and(|extension| extension == "cx") {
                found.push(path);
            }
        }
    }
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut paths = Vec::new();
    collect(&root.join("examples"), &mut paths);
    collect(&root.join("stdlib-gears/calyx"), &mut paths);
    assert!(paths.len() >= 5);
    let mut texts: Vec<String> = paths.iter().map(|path| fs::read_to_string(path).unwrap()).collect();
    texts.push(EVERYTHING.to_string());
    texts
}

/// Statements of all kinds, with multi-byte characters.
const EVERYTHING: &str = r#"/// Größe und Maß.

import gears;
import util.more;
units mm_N_s;
dimension Cost;
unit euro: Cost;
const größe = 3 mm; // ∅ außen
record Blank { /// Breite
    width = 25 mm;
    teeth: Number; label: String = "größer {größe : .2 mm} ∅"; }
private function f(in a: Length/Time = 2 mm/s, in b := Time, inout c, in d = 3 in 2 .. 4) -> Length {
    var x = if (a > 1 mm/s) 2 else 3, y := b^2;
    for (var i = 0; i < 10; i = i + 1) { if (i == 3) break; else { continue; } }
    switch (x) {
        case 1:
        case 2:
            c = c + 1;
            break;
        default:
            do c = 2; while (c < 3);
    }
    retry: while (TRUE) { try { throw; } catch (problem) { print(problem.message); } }
    /* over
       lines */
    return [a, b, (c * -2 + 1)^2][1] * größe; goto retry;
}
function p(in u, in th) := u * e1 + th * e2;
test function einfach() { assert(1 < 2, "é {1 + 2}"); }
param torque = 1000 N*m in 0 N*m .. 5000 N*m; param mode = "a" in ["a", "b"];
output out := p(..Blank(teeth = 20), th := Time at Time = 0.1 s);
"#;

const SNIPPETS: [&str; 32] = [
    "(",
    ")",
    "{",
    "}",
    "[",
    "]",
    ";",
    ",",
    "\"",
    "\n",
    " ",
    "=",
    ":=",
    "var ",
    "if (",
    "else ",
    "case 1:",
    "///",
    "// x\n",
    "/*",
    "*/",
    "é",
    "f(a = 2 mm, ",
    "function g(in x) {",
    "import a;",
    "..",
    ".",
    "10 ",
    "mm",
    "test ",
    "record R { a: ",
    "at ",
];

/// Returns a text with random edits; mostly with errors.
fn edited(text: &str, random: &mut Random) -> String {
    let mut text = text.to_string();
    for _ in 0..1 + random.below(4) {
        let mut place = |text: &str| {
            let mut at = random.below(text.len() + 1);
            while !text.is_char_boundary(at) {
                at -= 1;
            }
            at
        };
        let (a, b) = (place(&text), place(&text));
        match random.below(3) {
            0 => {
                let end = text[a..].char_indices().nth(random.below(12)).map_or(text.len(), |(at, _)| a + at);
                text.replace_range(a..end, "");
            }
            1 => text.insert_str(a, SNIPPETS[random.below(SNIPPETS.len())]),
            _ => {
                let end = text[b..].char_indices().nth(random.below(30)).map_or(text.len(), |(at, _)| b + at);
                let piece = text[b..end].to_string();
                text.insert_str(a, &piece);
            }
        }
    }
    text
}

/// Runs a check on the programs and on many randomly edited versions.
fn for_all(check: impl Fn(&Source<'_>, &mut Random)) {
    let mut random = Random(0x9E37_79B9_7F4A_7C15);
    for text in programs() {
        check(&Source::new(&text), &mut random);
        // Fewer versions of long texts, which take longer.
        for _ in 0..(20_000 / text.len()).clamp(2, 40) {
            check(&Source::new(&edited(&text, &mut random)), &mut random);
        }
    }
}

fn line_of(source: &Source<'_>, offset: u32) -> usize {
    source.text[..offset as usize].matches('\n').count()
}

fn place(source: &Source<'_>, random: &mut Random) -> u32 {
    let mut at = random.below(source.text.len() + 1);
    while !source.text.is_char_boundary(at) {
        at -= 1;
    }
    at as u32
}

#[test]
fn folds_nest() {
    for_all(|source, _| {
        let lines: Vec<(usize, usize)> = folds(source)
            .iter()
            .map(|fold| (line_of(source, fold.start), line_of(source, fold.end)))
            .collect();
        let mut around: Vec<(usize, usize)> = Vec::new();
        for (start, end) in lines {
            assert!(start < end, "{}", source.text);
            while around.last().is_some_and(|outer| outer.1 < start) {
                around.pop();
            }
            if let Some(outer) = around.last() {
                assert!(outer.0 < start && end <= outer.1, "{outer:?} {start} {end}\n{}", source.text);
            }
            around.push((start, end));
        }
    });
}

#[test]
fn symbols_nest() {
    fn check(source: &Source<'_>, symbols: &[Symbol], (start, end): (u32, u32)) {
        let mut from = start;
        for symbol in symbols {
            assert!(from <= symbol.start && symbol.end <= end, "{symbol:?}\n{}", source.text);
            assert!(symbol.start <= symbol.name_start && symbol.name_end <= symbol.end, "{symbol:?}");
            assert_eq!(source.slice(symbol.name_start, symbol.name_end), symbol.name);
            check(source, &symbol.children, (symbol.start, symbol.end));
            from = symbol.end;
        }
    }
    for_all(|source, _| {
        check(source, &symbols(source, &Types::new()), (0, source.text.len() as u32));
    });
}

#[test]
fn selections_grow_to_the_file() {
    for_all(|source, random| {
        for _ in 0..20 {
            let offset = place(source, random);
            let ranges = selections(source, offset);
            for pair in ranges.windows(2) {
                let (inner, outer) = (pair[0], pair[1]);
                assert!(
                    outer.0 <= inner.0 && inner.1 <= outer.1 && inner != outer,
                    "{ranges:?}\n{}",
                    source.text
                );
            }
            assert!(ranges.iter().all(|(start, end)| *start <= offset && offset <= *end));
            assert!(
                ranges.iter().all(|(start, end)| source.text.get(*start as usize..*end as usize).is_some())
            );
            assert_eq!(ranges.last(), Some(&(0, source.text.len() as u32)));
        }
    });
}

/// Returns the tokens with their texts, which determine the meaning of a program.
fn meaning(text: &str) -> Vec<String> {
    let source = Source::new(text);
    source.tokens.tokens.iter().map(|token| format!("{:?} {}", token.kind, source.word(token))).collect()
}

#[test]
fn changes_give_the_canonical_layout() {
    let mut formatted = 0;
    for text in programs() {
        // The same program in a bad layout.
        let spoilt = text.replace("    ", " ").replace(" = ", "=").replace(", ", " ,  ");
        let source = Source::new(&spoilt);
        let Ok(expected) = calyx_lang::format::format(&spoilt) else { continue };
        formatted += 1;
        assert_eq!(changed(&spoilt, &format_file(&source)), expected);
        let all = format_selection(&source, 0..spoilt.len() as u32);
        assert_eq!(changed(&spoilt, &all).trim_end(), expected.trim_end());
    }
    assert!(formatted >= 5);
}

#[test]
fn layout_of_a_selection_is_part_of_that_of_the_file_and_keeps_the_meaning() {
    for_all(|source, random| {
        let (a, b) = (place(source, random), place(source, random));
        let changes = format_selection(source, a.min(b)..a.max(b));
        let text = changed(source.text, &changes);
        assert_same_meaning(source.text, &text);
        if let Ok(expected) = calyx_lang::format::format(source.text) {
            let after = calyx_lang::format::format(&text);
            assert_eq!(after, Ok(expected), "{}\nbecomes\n{text}", source.text);
        }
    });
}

/// Removes trailing commas, which the formatter may change.
fn without_last_commas(words: Vec<String>) -> Vec<String> {
    let closes = |word: &String| word.starts_with("CloseParen") || word.starts_with("CloseBracket");
    let kept = |at: usize| !(words[at].starts_with("Comma") && words.get(at + 1).is_some_and(closes));
    (0..words.len()).filter(|at| kept(*at)).map(|at| words[at].clone()).collect()
}

#[test]
fn typing_keeps_the_meaning() {
    for_all(|source, random| {
        let mut places: Vec<usize> = source.text.match_indices([';', '}']).map(|(at, _)| at + 1).collect();
        for _ in 0..8.min(places.len()) {
            let offset = places.swap_remove(random.below(places.len()));
            let character = source.text[..offset].chars().next_back().unwrap();
            let changes = typed(source, offset as u32, character);
            assert_same_meaning(source.text, &changed(source.text, &changes));
        }
        for _ in 0..8 {
            let at = place(source, random) as usize;
            let mut broken = source.text.to_string();
            broken.insert(at, '\n');
            let changes = typed(&Source::new(&broken), at as u32 + 1, '\n');
            let text = changed(&broken, &changes);
            // A line break in a comment splits it, and is the only one that may change the meaning.
            let in_comment = source.tokens.comments.iter().any(|comment| {
                comment.kind != CommentKind::Block
                    && comment.span.start as usize + 2 <= at
                    && at <= comment.span.end as usize
            });
            assert_same_meaning(if in_comment && !changes.is_empty() { source.text } else { &broken }, &text);
        }
    });
}

fn assert_same_meaning(before: &str, after: &str) {
    let words = (without_last_commas(meaning(before)), without_last_commas(meaning(after)));
    let first = words.0.iter().zip(&words.1).find(|(a, b)| a != b);
    let line = before.lines().zip(after.lines()).find(|(a, b)| a != b);
    assert!(words.0 == words.1, "{first:?} in {line:?}");
}

fn all_tokens(source: &Source<'_>) -> Vec<SemanticToken> {
    tokens(source, &[], 0..source.text.len() as u32)
}

#[test]
fn tokens_are_in_order_and_apart() {
    for_all(|source, random| {
        let all = all_tokens(source);
        for pair in all.windows(2) {
            assert!(pair[0].end <= pair[1].start, "{pair:?}");
        }
        for token in &all {
            let text = source.slice(token.start, token.end);
            assert!(!text.is_empty() && !text.contains('\n'), "{token:?} is `{text}`");
        }
        // The tokens of a range include those that overlap its start and end.
        let (a, b) = (place(source, random), place(source, random));
        let range = a.min(b)..a.max(b);
        let part = tokens(source, &[], range.clone());
        let inside: Vec<_> = all.iter().filter(|t| range.start <= t.start && t.end <= range.end).collect();
        assert!(inside.iter().all(|token| part.contains(token)));
        assert!(part.iter().all(|token| all.iter().any(|t| t.start <= token.start && token.end <= t.end)));
    });
}

#[test]
fn the_difference_of_tokens_makes_the_new_of_the_old() {
    let kinds = |text: &str| {
        // Encoded by length as for clients, so that few tokens change after an edit.
        let source = Source::new(text);
        all_tokens(&source).iter().map(|t| (t.end - t.start, t.kind, t.modifiers)).collect::<Vec<_>>()
    };
    let mut random = Random(0x1234_5678_9ABC_DEF1);
    for text in programs().iter().filter(|text| text.len() < 10_000) {
        let old = kinds(text);
        assert_eq!(difference(&old, &old), None);
        for _ in 0..20 {
            let new = kinds(&edited(text, &mut random));
            let mut made = old.clone();
            if let Some(change) = difference(&old, &new) {
                made.splice(change.start..change.start + change.removed, change.inserted);
            }
            assert_eq!(made, new);
        }
    }
}

/// A loader with the library only.
struct LibraryAlone;

impl LibraryAlone {
    fn file(name: &str) -> Option<(String, String)> {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../stdlib-gears/calyx");
        Some((format!("<library>/{name}"), fs::read_to_string(folder.join(name)).ok()?))
    }
}

impl Loader for LibraryAlone {
    fn module(&self, path: &[String]) -> Option<(String, String)> {
        LibraryAlone::file(&format!("{}.cx", path.join("/")))
    }

    fn prelude(&self) -> (String, String) {
        LibraryAlone::file("prelude.cx").expect("the library has a prelude")
    }
}

#[test]
fn checked_texts_are_answered_however_broken() {
    const MODEL: &str = "model.cx";
    let mut random = Random(0x0BAD_5EED_0BAD_5EED);
    let pair =
        fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples/spur_pair.cx")).unwrap();
    let mut database = Database::new(&LibraryAlone);
    for round in 0..60 {
        let text = edited(if round % 2 == 0 { &pair } else { EVERYTHING }, &mut random);
        database.set_model(MODEL, &text);
        database.load_imports(MODEL, &LibraryAlone);
        let snapshot = Snapshot::new(database.clone());
        let source = Source::of(&snapshot, MODEL).expect("a model");
        let whole = 0..text.len() as u32;
        let names = snapshot.database.names(MODEL);
        let all = tokens(&source, &names, whole.clone());
        assert!(all.windows(2).all(|pair| pair[0].end <= pair[1].start), "{text}");
        let found =
            hints(&snapshot, &source, MODEL, whole.clone(), HintSettings::default(), &Results::default());
        assert!(found.windows(2).all(|pair| pair[0].offset <= pair[1].offset));
        assert!(found.iter().all(|hint| text.is_char_boundary(hint.offset as usize)), "{found:?}");
        let range = place(&source, &mut random)..place(&source, &mut random);
        let range = range.start.min(range.end)..range.start.max(range.end);
        let part =
            hints(&snapshot, &source, MODEL, range.clone(), HintSettings::default(), &Results::default());
        let expected = found.iter().filter(|hint| range.start <= hint.offset && hint.offset <= range.end);
        assert_eq!(part.iter().collect::<Vec<_>>(), expected.collect::<Vec<_>>(), "{range:?}\n{text}");
        let places = lenses(&source, &MODEL.into()).into_iter().map(|lens| lens.start);
        let places = places.chain(links(&snapshot, &source).into_iter().map(|link| link.end));
        for offset in places.chain(names.iter().map(|name| name.start)) {
            let position = Position { file: MODEL.into(), offset };
            let Some(item) = prepare(&snapshot, &position) else { continue };
            for caller in incoming(&snapshot, &item.place) {
                // Every reported caller calls the function.
                let callees = outgoing(&snapshot, &caller.item.place);
                assert!(callees.iter().any(|callee| callee.item.place == item.place), "{caller:?}\n{text}");
            }
        }
    }
}
