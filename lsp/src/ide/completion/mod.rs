//! Completion.
//!
//! [`context`] determines the syntactic category at the cursor from the tokens, and [`request`] the
//! expected type. Each source of items has a file, and offers few suitable items rather than many.
//! [`ranking`] sorts them.

mod arguments;
pub mod context;
mod documentation;
mod imports;
mod item;
mod keywords;
mod names;
mod operands;
mod ranking;
mod request;
mod units;
mod words;

pub use documentation::{documentation, parameter_text};
pub use item::{AfterInsert, Completions, Insert, Item, ItemKind, Rank, Subject};

use super::{Position, Snapshot};
use calyx_lang::analysis::NameKind;
use calyx_lang::lexer::Kind;
use context::{CompletionSite, Context, Operator, Slot};
use request::Request;

/// Characters that trigger completion.
pub const TRIGGERS: &[&str] = &[".", "\"", " ", "("];

/// Origin of a completion request.
pub struct CompletionTrigger<'a> {
    /// Character that triggered the request; `None` for an explicit request.
    pub typed: Option<char>,
    /// Dotted paths of importable files, in addition to those in the database.
    pub beside: &'a dyn Fn() -> Vec<String>,
}

/// Returns the completions at a cursor.
pub fn complete(snapshot: &Snapshot, position: &Position, asked: &CompletionTrigger<'_>) -> Completions {
    let database = &snapshot.database;
    let file = &*position.file;
    let (Some(text), Some(tokens)) = (database.text(file), database.tokens(file)) else {
        return Completions::default();
    };
    let offset = position.offset as usize;
    if !text.is_char_boundary(offset.min(text.len())) || offset > text.len() {
        return Completions::default();
    }
    let context = Context::new(text, &tokens, offset);
    if !answers(&context, asked.typed) {
        return Completions::default();
    }
    let request = Request::new(database, file, context, position.offset);
    let mut items = Vec::new();
    offer(&request, asked, &mut items);
    let around = &request.context.around;
    let (mut start, mut end, mut prefix) = (around.word.start, around.word.end, around.prefix());
    if let CompletionSite::Text(_, range) = &request.context.spot {
        (start, end) = (range.start, range.end);
        prefix = text.get(range.start..offset).unwrap_or_default();
    }
    let incomplete = ranking::rank(&mut items, prefix);
    Completions { start: start as u32, end: end as u32, items, incomplete }
}

/// Returns true if the trigger character is valid in this context: a blank is in few.
fn answers(context: &Context<'_>, typed: Option<char>) -> bool {
    let around = &context.around;
    let last = around.previous(around.before);
    match typed {
        Some(' ') => match &context.spot {
            CompletionSite::Unit(..)
            | CompletionSite::Import(_)
            | CompletionSite::System
            | CompletionSite::Label
            | CompletionSite::Symbol
            | CompletionSite::FormatUnit(_) => true,
            CompletionSite::Value(value) => match &value.slot {
                Slot::Argument { name: None, .. } => last == Some(Kind::Comma),
                Slot::Argument { name: Some(_), .. } => matches!(last, Some(Kind::Assign | Kind::Bind)),
                _ => false,
            },
            _ => false,
        },
        Some('"') => matches!(context.spot, CompletionSite::Text(..)),
        Some('.') => matches!(
            context.spot,
            CompletionSite::Member(..) | CompletionSite::Import(_) | CompletionSite::TypeMember(_)
        ),
        Some('(') => {
            matches!(&context.spot, CompletionSite::Value(value) if matches!(value.slot, Slot::Argument { .. }))
        }
        _ => context.spot != CompletionSite::Nothing,
    }
}

fn offer(request: &Request<'_>, asked: &CompletionTrigger<'_>, items: &mut Vec<Item>) {
    match &request.context.spot {
        CompletionSite::Nothing => {}
        CompletionSite::Statement => {
            keywords::statements(request, items);
            names::statements(request, items);
            imports::not_imported(request, items);
        }
        CompletionSite::Words(words) | CompletionSite::After(words) => keywords::words(request, words, items),
        CompletionSite::Import(path) => words::modules(request, path, &(asked.beside)(), items),
        CompletionSite::System => words::systems(request, items),
        CompletionSite::Label => words::labels(request, items),
        CompletionSite::Symbol => names::symbols(request, items, true),
        CompletionSite::Type => words::types(request, items),
        CompletionSite::TypeMember(module) => words::types_of(request, module, items),
        CompletionSite::Member(base, value) => {
            let name = request.source(base);
            match request.find(name) {
                Some(known) if known.kind == NameKind::Module => names::members(request, name, value, items),
                _ if words::choices_of_enumeration(request, name, items) => {}
                _ => words::parts(request, &request.shape_of(base), items),
            }
        }
        CompletionSite::Unit(_, words) => {
            units::units(request, items);
            keywords::words(request, words, items);
        }
        CompletionSite::FormatUnit(shown) => units::format_units(request, &request.shape_of(shown), items),
        CompletionSite::Text(..) => words::choices(request, false, items),
        CompletionSite::Value(value) => {
            arguments::arguments(request, items);
            if !names::wanted(request) {
                return;
            }
            if is_differentiated_by(value) {
                names::symbols(request, items, false);
                return;
            }
            units::units(request, items);
            if matches!(value.operator, Operator::None | Operator::Alike(_)) {
                words::choices(request, true, items);
            }
            names::values(request, items);
            words::truths(items, request, value);
            keywords::values(request, items);
            imports::not_imported(request, items);
        }
    }
}

/// Returns true for the second argument of `derivative`.
fn is_differentiated_by(value: &context::Value) -> bool {
    matches!(&value.slot, Slot::Argument { call, name: None }
        if call.active == 1 && call.path.last().is_some_and(|name| name == "derivative"))
}
