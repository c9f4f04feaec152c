//! The page behind every diagnostic code, of the language and of the engine: what it means, and a program that shows it
//! beside one that is right.

mod engine;

use calyx_lang::codes::{self, Explanation};

/// Programs that are wrong and right, by code. See the head of the file.
const EXAMPLES: &str = include_str!("explain/examples.md");

/// Every code with its explanation, in order.
pub fn all() -> Vec<Explanation> {
    let mut all: Vec<Explanation> = codes::all().iter().chain(engine::CODES).copied().collect();
    all.sort_by_key(|explanation| (&explanation.code[1..], &explanation.code[..1]));
    all
}

/// A code's explanation. A warning of the library that has no page of its own has that of its error.
pub fn explanation(code: &str) -> Option<Explanation> {
    let code = code.trim().to_ascii_uppercase();
    let find = |code: &str| all().into_iter().find(|explanation| explanation.code == code);
    find(&code).or_else(|| code.strip_prefix('W').and_then(|number| find(&format!("E{number}"))))
}

/// The page of a code, in any case; ends with a line end.
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

/// Codes spelt most like one that is not there.
pub fn similar_codes(code: &str) -> Vec<&'static str> {
    let code = code.trim().to_ascii_uppercase();
    let distance = |other: &str| strsim::damerau_levenshtein(&code, other);
    let known: Vec<(usize, &str)> = all().iter().map(|e| (distance(e.code), e.code)).collect();
    let nearest = known.iter().map(|(distance, _)| *distance).min().unwrap_or(usize::MAX);
    let near = known.into_iter().filter(|(distance, _)| *distance == nearest && nearest <= 2);
    near.map(|(_, code)| code).take(3).collect()
}

/// A program that shows a code, and the same mended.
#[derive(Clone, Copy, Debug)]
pub struct Example {
    pub code: &'static str,
    pub wrong: &'static str,
    pub fixed: &'static str,
}

/// The example of a code.
pub fn example(code: &str) -> Option<Example> {
    examples().find(|example| example.code == code)
}

/// All examples, in order of the file.
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

/// Text in lines of at most `width` characters, broken at blanks.
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
