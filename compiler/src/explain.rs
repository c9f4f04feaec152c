//! Explanation pages of all diagnostic codes, of the language and of the engine: the meaning, and
//! an incorrect program next to a correct one.

mod engine;

use calyx_lang::codes::{self, Explanation};

/// Incorrect and correct programs, by code. The head of the file describes its format.
const EXAMPLES: &str = include_str!("explain/examples.md");

/// Returns the explanations of all codes, in order.
pub fn all() -> Vec<Explanation> {
    let mut all: Vec<Explanation> = codes::all().iter().chain(engine::CODES).copied().collect();
    all.sort_by_key(|explanation| (&explanation.code[1..], &explanation.code[..1]));
    all
}

/// Returns the explanation of a code. A warning of the library without its own page has the page of
/// its error.
pub fn explanation(code: &str) -> Option<Explanation> {
    let code = code.trim().to_ascii_uppercase();
    let find = |code: &str| all().into_iter().find(|explanation| explanation.code == code);
    find(&code).or_else(|| code.strip_prefix('W').and_then(|number| find(&format!("E{number}"))))
}

/// Returns the page of a code in upper or lower case; it ends with a line break.
pub fn page(code: &str) -> Option<String> {
    let explanation = explanation(code)?;
    let mut page = format!("{}: {}\n\n", explanation.code, explanation.title);
    page += &wrapped(explanation.text, 80);
    if let Some(example) = example(explanation.code) {
        page += &format!("\nThis is reported:\n\n{}", indented(example.wrong));
        page += &format!("\nThis is right:\n\n{}", indented(example.fixed));
    }
    Some(page)
}

/// Returns the codes closest in spelling to an unknown one.
pub fn similar_codes(code: &str) -> Vec<&'static str> {
    let code = code.trim().to_ascii_uppercase();
    let distance = |other: &str| strsim::damerau_levenshtein(&code, other);
    let known: Vec<(usize, &str)> = all().iter().map(|e| (distance(e.code), e.code)).collect();
    let nearest = known.iter().map(|(distance, _)| *distance).min().unwrap_or(usize::MAX);
    let near = known.into_iter().filter(|(distance, _)| *distance == nearest && nearest <= 2);
    near.map(|(_, code)| code).take(3).collect()
}

/// Program that produces a code, and the same program with the error fixed.
#[derive(Clone, Copy, Debug)]
pub struct Example {
    pub code: &'static str,
    pub wrong: &'static str,
    pub fixed: &'static str,
}

/// Returns the example of a code.
pub fn example(code: &str) -> Option<Example> {
    examples().find(|example| example.code == code)
}

/// Returns all examples, in order of the file.
pub fn examples() -> impl Iterator<Item = Example> {
    let sections = EXAMPLES.split("\n## ").skip(1);
    sections.filter_map(|section| {
        let (code, rest) = section.split_once('\n')?;
        let mut blocks = rest.split("```cx\n").skip(1).filter_map(|block| block.split("```").next());
        Some(Example { code: code.trim(), wrong: blocks.next()?, fixed: blocks.next()? })
    })
}

fn indented(text: &str) -> String {
    text.lines().map(|line| format!("    {line}").trim_end().to_owned() + "\n").collect()
}

/// Breaks a text at blanks into lines of at most `width` characters.
fn wrapped(text: &str, width: usize) -> String {
    let mut lines = String::new();
    let mut column = 0;
    for word in text.split_whitespace() {
        let length = word.chars().count();
        if column > 0 && column + 1 + length > width {
            lines.push('\n');
            column = 0;
        } else if column > 0 {
            lines.push(' ');
            column += 1;
        }
        lines += word;
        column += length;
    }
    lines + "\n"
}
