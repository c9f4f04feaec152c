//! `--help` of an executable: the docs of the model, its params and its outputs.

use crate::params::{domain, shown, shown_list};
use calyx_abi::Repr;
use calyx_abi::description::{ModelDescription, OutputDescription, ParamDescription, ParamValue};
use calyx_abi::units::{from_si, shortest};
use clap::builder::styling::{AnsiColor, Style};
use std::fmt::Write;

/// Largest width of text in columns, as in `clap`.
const WIDEST: usize = 100;

/// Style of headings, as for options.
const HEADING: Style = Style::new().bold().underline();
/// Style of names, as for options.
const NAME: Style = Style::new().bold();
const ASIDE: Style = AnsiColor::BrightBlack.on_default();

/// Lists params and outputs, one per line.
pub fn short(description: &ModelDescription) -> String {
    text(description, false)
}

/// Lists params and outputs with their full docs.
pub fn long(description: &ModelDescription) -> String {
    text(description, true)
}

fn text(description: &ModelDescription, long: bool) -> String {
    let params = description.params.iter().map(|param| Entry {
        name: &param.name,
        facts: [default(param), range(param)],
        doc: &param.doc,
    });
    let outputs = description.outputs.iter().map(|output| Entry {
        name: &output.name,
        facts: [unit(output), String::new()],
        doc: &output.doc,
    });
    let mut text = section("Params of the model, their defaults and ranges", params.collect(), long);
    text += &section("Outputs and their units", outputs.collect(), long);
    text.truncate(text.trim_end().len());
    text
}

/// A param or an output.
struct Entry<'d> {
    name: &'d str,
    /// Summary on the line of the entry.
    facts: [String; 2],
    doc: &'d str,
}

fn section(title: &str, entries: Vec<Entry>, long: bool) -> String {
    if entries.is_empty() {
        return String::new();
    }
    let widest = |cell: &dyn Fn(&Entry) -> usize| entries.iter().map(cell).max().unwrap_or(0);
    let width = widest(&|entry| entry.name.chars().count());
    let widths = [0, 1].map(|fact| widest(&|entry| entry.facts[fact].chars().count()));
    let columns = columns();
    let mut text = format!("{HEADING}{title}:{HEADING:#}\n");
    for Entry { name, facts: [first, second], doc } in entries {
        let [first_width, second_width] = widths;
        let line = format!(
            "  {NAME}{name}{NAME:#}{}  {first:first_width$}  {ASIDE}{second}{ASIDE:#}",
            " ".repeat(width - name.chars().count())
        );
        let fill = " ".repeat(second_width - second.chars().count());
        if long {
            let _ = writeln!(text, "{}", line.trim_end());
            for line in wrapped(doc, columns.saturating_sub(6)) {
                let _ = writeln!(text, "{}", format!("      {line}").trim_end());
            }
            text.push('\n');
        } else {
            let before = 2 + width + 2 + first_width + 2 + second_width + 2;
            // Headings group the params of a form.
            let first = doc.lines().find(|line| !line.is_empty() && !line.starts_with("# "));
            let said = cut(first.unwrap_or_default(), columns.saturating_sub(before));
            let gap = if second_width == 0 { "" } else { "  " };
            let _ = writeln!(text, "{}", format!("{line}{fill}{gap}{said}").trim_end());
        }
    }
    if !long {
        text.push('\n');
    }
    text
}

/// Describes the range of a param, in the unit of its default.
fn range(param: &ParamDescription) -> String {
    let shown = |si: f64| shortest(from_si(si, param.unit.factor));
    let range = match (&param.repr, param.low, param.high) {
        (Repr::Number, Some(low), Some(high)) => format!("{} .. {}", shown(low), shown(high)),
        (Repr::Number, Some(low), None) => format!("from {}", shown(low)),
        (Repr::Number, None, Some(high)) => format!("up to {}", shown(high)),
        _ => return domain(param, None, None),
    };
    if param.integral { format!("{range}, whole") } else { range }
}

fn default(param: &ParamDescription) -> String {
    match &param.default {
        Some(ParamValue::Number(si)) => shown(param, *si),
        Some(ParamValue::Bool(truth)) => (if *truth { "TRUE" } else { "FALSE" }).into(),
        Some(ParamValue::String(text)) => format!("\"{text}\""),
        Some(ParamValue::Numbers(numbers)) => shown_list(param, numbers),
        None => "?".into(),
    }
}

fn unit(output: &OutputDescription) -> String {
    match output.unit.name.as_str() {
        _ if !output.choices.is_empty() => "choice".into(),
        "" => "number".into(),
        unit => unit.into(),
    }
}

/// Returns the width of the terminal in columns, as `clap` determines it.
fn columns() -> usize {
    let terminal = terminal_size::terminal_size().map(|(terminal_size::Width(width), _)| usize::from(width));
    let variable = || std::env::var("COLUMNS").ok()?.parse().ok();
    terminal.or_else(variable).unwrap_or(WIDEST).clamp(40, WIDEST)
}

/// Wraps a doc comment to a number of columns, paragraph by paragraph.
fn wrapped(doc: &str, columns: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for paragraph in doc.split("\n\n") {
        let words: Vec<&str> = paragraph.split_whitespace().collect();
        lines.extend(textwrap::wrap(&words.join(" "), columns).into_iter().map(String::from));
        lines.push(String::new());
    }
    lines.pop();
    lines
}

/// Truncates a text to a number of columns.
fn cut(text: &str, columns: usize) -> String {
    if text.chars().count() <= columns {
        return text.into();
    }
    let kept: String = text.chars().take(columns.saturating_sub(3)).collect();
    match kept.rsplit_once(' ') {
        Some((words, _)) => format!("{words} ..."),
        None => "...".into(),
    }
}
