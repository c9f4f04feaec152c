//! Syntactic category at a cursor, from tokens alone: `tests/ide/completion_context.md`.

use crate::support;
use calyx_lang::ast::Bind;
use calyx_lang::lexer::lex;
use calyx_lang::span::FileId;
use calyx_lsp::ide::completion::context::{CompletionSite, Context, Operator, Slot, Value};
use std::ops::Range;

#[test]
fn contexts() {
    support::run("completion_context", |case| {
        let (_, text) = case.files.first().expect("a case has a file");
        let tokens = lex(FileId(0), text);
        let shown = case.cursors.iter().map(|cursor| {
            let context = Context::new(text, &tokens, cursor.offset as usize);
            Shown { context: &context, text }.spot()
        });
        shown.collect::<Vec<_>>().join("\n")
    });
}

struct Shown<'a> {
    context: &'a Context<'a>,
    text: &'a str,
}

impl Shown<'_> {
    fn spot(&self) -> String {
        let spot = match &self.context.spot {
            CompletionSite::Nothing => "nothing".into(),
            CompletionSite::Statement => {
                let blocks: Vec<String> = self
                    .context
                    .blocks
                    .iter()
                    .map(|block| format!("{:?}", block.kind).to_lowercase())
                    .collect();
                format!("statement ({})", blocks.join(" in "))
            }
            CompletionSite::Words(words) => format!("one of {}", words.join(", ")),
            CompletionSite::Import(path) => format!("module after `{}`", path.join(".")),
            CompletionSite::System => "unit system".into(),
            CompletionSite::Label => "label".into(),
            CompletionSite::Symbol => "symbol".into(),
            CompletionSite::Type => "type".into(),
            CompletionSite::TypeMember(module) => format!("type of `{module}`"),
            CompletionSite::Member(base, value) => {
                format!("member of `{}`{}", self.tokens(base), self.value(value))
            }
            CompletionSite::Unit(value, _) => format!("unit{}", self.value(value)),
            CompletionSite::FormatUnit(shown) => format!("unit for `{}`", self.tokens(shown)),
            CompletionSite::Text(value, range) => {
                format!("text `{}`{}", self.text.get(range.clone()).unwrap_or_default(), self.value(value))
            }
            CompletionSite::Value(value) => format!("value{}", self.value(value)),
            CompletionSite::After(words) => format!("behind a value: {}", words.join(", ")),
        };
        match self.context.around.prefix() {
            "" => spot,
            prefix => format!("{prefix}| {spot}"),
        }
    }

    fn tokens(&self, tokens: &Range<usize>) -> &str {
        let Some(last) = tokens.end.checked_sub(1).filter(|last| *last >= tokens.start) else { return "" };
        let around = &self.context.around;
        self.text.get(around.range(tokens.start).start..around.range(last).end).unwrap_or_default()
    }

    fn value(&self, value: &Value) -> String {
        let operator = match &value.operator {
            Operator::None => String::new(),
            Operator::Alike(left) => format!(", like `{}`", self.tokens(left)),
            Operator::Factor(left, false) => format!(", times `{}`", self.tokens(left)),
            Operator::Factor(left, true) => format!(", under `{}`", self.tokens(left)),
            Operator::Exponent => ", exponent".into(),
            Operator::Truth => ", truth".into(),
        };
        format!("{operator}{}{}", if value.is_symbolic() { " symbolic" } else { "" }, self.slot(&value.slot))
    }

    fn slot(&self, slot: &Slot) -> String {
        match slot {
            Slot::Argument { call, name } => {
                let given: Vec<String> = call
                    .arguments
                    .iter()
                    .map(|given| match (&given.name, &given.spread) {
                        (Some(name), _) => name.clone(),
                        (_, Some(record)) => format!("..{record}"),
                        _ if given.empty => "-".into(),
                        _ => "_".into(),
                    })
                    .collect();
                let name = name.as_ref().map_or_else(
                    || format!("{}", call.active),
                    |(name, bind)| format!("{name}{}", if *bind == Bind::Symbolic { " :=" } else { "" }),
                );
                format!(", argument {name} of {}({})", call.path.join("."), given.join(" "))
            }
            Slot::Element(value) => format!(", element{}", self.value(value)),
            Slot::Same(value) => format!(", in parentheses{}", self.value(value)),
            Slot::Condition => ", condition".into(),
            Slot::Count => ", count".into(),
            Slot::Initial { keyword, name, .. } => format!(", {keyword:?} `{name}`"),
            Slot::Bound { name, default } => format!(", bound of `{name}` = `{}`", self.tokens(default)),
            Slot::Assigned { place, .. } => format!(", assigned to `{}`", self.tokens(place)),
            Slot::Annotated { annotation, .. } => {
                format!(", of type `{}`", annotation.as_ref().map_or("", |tokens| self.tokens(tokens)))
            }
            Slot::SymbolicBody => ", symbolic body".into(),
            Slot::Returned => ", returned".into(),
            Slot::Thrown => ", thrown".into(),
            Slot::Case => ", case".into(),
            Slot::At(symbol) => format!(", of `{symbol}`"),
            Slot::Free => String::new(),
        }
    }
}
