//! Information about a cursor for the sources of items: visible names, and the expected type.

use super::context::{CompletionSite, Context, Operator, Slot, Value};
use crate::ide::callee::{self, matched, position};
use crate::ide::cursor::BlockKind;
use crate::ide::shape::{self, Shape};
use calyx_lang::analysis::{CallParameter, Callable, Visible};
use calyx_lang::db::Database;
use calyx_lang::dimension::Dimension;
use calyx_lang::lexer::Kind;
use calyx_lang::units::UnitSystem;
use std::ops::Range;

/// A cursor with its analysis.
pub struct Request<'a> {
    pub database: &'a Database,
    pub file: &'a str,
    pub context: Context<'a>,
    pub visible: Vec<Visible>,
    /// Unit system of the file, or SI.
    pub system: UnitSystem,
    /// Innermost call, its parameters, and the active one.
    pub call: Option<Called>,
    pub expected: Expected,
}

/// The innermost call.
pub struct Called {
    pub callable: Callable,
    /// Index of the active parameter.
    pub active: Option<usize>,
    /// Parameters without an argument; the argument at the cursor does not count.
    pub left: Vec<usize>,
    /// True if a positional argument is valid: no named argument precedes it.
    pub in_order: bool,
}

/// Expectation for the value at the cursor.
#[derive(Clone, Debug, PartialEq)]
pub struct Expected {
    pub shape: Shape,
    /// True if `:=` binds the expression.
    pub symbolic: bool,
    /// Allowed texts.
    pub choices: Vec<String>,
    /// Dimension suggested by the name only.
    pub hint: Option<Dimension>,
    /// True if `shape` is the type of the whole value, and the operand at the cursor may have
    /// another one.
    pub weak: bool,
}

impl Default for Expected {
    fn default() -> Self {
        Expected { shape: Shape::Unknown, symbolic: false, choices: Vec::new(), hint: None, weak: false }
    }
}

impl<'a> Request<'a> {
    pub fn new(database: &'a Database, file: &'a str, context: Context<'a>, offset: u32) -> Self {
        let visible = match context.spot {
            CompletionSite::Nothing
            | CompletionSite::Import(_)
            | CompletionSite::System
            | CompletionSite::Words(_)
            | CompletionSite::Label => Vec::new(),
            _ => database.seen(file, offset),
        };
        let mut request = Request {
            database,
            file,
            system: system(&context),
            context,
            visible,
            call: None,
            expected: Expected::default(),
        };
        request.infer();
        let value = match &request.context.spot {
            CompletionSite::Value(value)
            | CompletionSite::Unit(value, _)
            | CompletionSite::Text(value, _)
            | CompletionSite::Member(_, value) => Some(value.clone()),
            _ => None,
        };
        if let Some(value) = value {
            if let Slot::Argument { .. } = &value.slot {
                request.call = request.called(&value.slot);
            }
            request.expected = request.expected(&value);
        }
        request
    }

    /// Returns true if the cursor is inside the declaration of a name: a function's body, a
    /// record's fields.
    pub fn is_around(&self, known: &Visible) -> bool {
        let around = &self.context.around;
        let Some(place) = known.declared.as_ref().filter(|place| *place.file == *self.file) else {
            return false;
        };
        let mut heads = self.context.blocks.iter().map(|block| block.head + 1);
        heads.any(|name| around.range(name).start == place.start as usize)
    }

    /// Returns a visible name.
    pub fn find(&self, name: &str) -> Option<&Visible> {
        self.visible.iter().find(|known| *known.name == *name)
    }

    /// Returns the text of some tokens.
    pub fn source(&self, tokens: &Range<usize>) -> &'a str {
        let around = &self.context.around;
        let Some(last) = tokens.end.checked_sub(1).filter(|last| *last >= tokens.start) else { return "" };
        around.text.get(around.range(tokens.start).start..around.range(last).end).unwrap_or_default()
    }

    fn called(&self, slot: &Slot) -> Option<Called> {
        let Slot::Argument { call, name } = slot else { return None };
        let callable = callee::callable(self.database, &self.visible, &call.path)?;
        let fields = |record: &str| self.fields_of(record).unwrap_or_default();
        let matched = matched(&callable, call, &fields);
        let active = match name {
            Some((name, _)) => callable.parameters.iter().position(|parameter| parameter.is_called(name)),
            None => matched.in_order.then_some(call.active).and_then(|at| position(&callable, at)),
        };
        Some(Called { active, left: matched.left, in_order: matched.in_order, callable })
    }

    /// Returns the expectation for the operand at the cursor.
    fn expected(&self, value: &Value) -> Expected {
        let symbolic = self.context.is_symbolic()
            || self.call.as_ref().is_some_and(|call| {
                call.active.and_then(|at| call.callable.parameters.get(at)).is_some_and(|p| p.symbolic)
            });
        let whole = || Expected { symbolic, ..self.whole(&value.slot) };
        let of = |shape: Shape| Expected { shape, symbolic, ..Expected::default() };
        match &value.operator {
            Operator::None => whole(),
            Operator::Alike(left) => match self.shape_of(left) {
                Shape::Unknown => Expected { weak: true, ..whole() },
                shape => {
                    let choices = match &shape {
                        shape if shape.is("String") => self.choices_of(left),
                        _ => Vec::new(),
                    };
                    Expected { choices, ..of(shape) }
                }
            },
            Operator::Factor(left, divides) => {
                let whole = whole();
                let shape = other_factor(&whole.shape, &self.shape_of(left), *divides);
                let hint = whole
                    .hint
                    .zip(self.shape_of(left).dimension())
                    .map(|(whole, left)| if *divides { left.over(whole) } else { whole.over(left) });
                Expected { shape, hint, weak: true, choices: Vec::new(), ..whole }
            }
            Operator::Exponent => of(Shape::number()),
            Operator::Truth => of(Shape::truth()),
        }
    }

    /// Returns the expectation for a whole value.
    fn whole(&self, slot: &Slot) -> Expected {
        let of = |shape: Shape| Expected { shape, ..Expected::default() };
        match slot {
            Slot::Argument { .. } => match &self.call {
                Some(call) => call
                    .active
                    .and_then(|at| call.callable.parameters.get(at))
                    .map_or_else(Expected::default, parameter),
                None => self
                    .called(slot)
                    .and_then(|call| call.callable.parameters.get(call.active?).map(parameter))
                    .unwrap_or_default(),
            },
            Slot::Element(outer) => {
                let outer = self.expected(outer);
                let shape = match outer.shape {
                    Shape::Array(element) => *element,
                    Shape::Vector(_) | Shape::Number(_) | Shape::Named(_) => Shape::Unknown,
                    other => other,
                };
                Expected { shape, ..outer }
            }
            Slot::Same(outer) => {
                let outer = self.expected(outer);
                Expected { weak: true, ..outer }
            }
            Slot::Condition => Expected { weak: true, ..of(Shape::truth()) },
            Slot::Count => of(Shape::number()),
            Slot::Initial { keyword: Kind::Output, .. } => of(Shape::Observable(None)),
            Slot::Initial { name, .. } => Expected { hint: hint(name), ..Expected::default() },
            Slot::Bound { name, default } => {
                let shape = self.shape_of(default);
                let hint = if shape == Shape::Unknown { hint(name) } else { None };
                Expected { shape, hint, ..Expected::default() }
            }
            Slot::Assigned { place, .. } => {
                let choices = self.choices_of(place);
                Expected { choices, ..of(self.shape_of(place)) }
            }
            Slot::Annotated { annotation, .. } => {
                of(annotation.as_ref().map_or(Shape::Unknown, |tokens| Shape::read(self.source(tokens))))
            }
            Slot::Returned => of(self.returned()),
            Slot::Thrown => of(Shape::Named("Error".into())),
            Slot::Case => self.switched(),
            Slot::At(symbol) => match symbol.as_str() {
                "Time" => of(Shape::read("Time")),
                symbol => of(self
                    .find(symbol)
                    .and_then(|known| known.ty.as_deref())
                    .map_or(Shape::Unknown, Shape::read)),
            },
            Slot::SymbolicBody | Slot::Free => Expected::default(),
        }
    }

    /// Returns the declared result type of the function around the cursor.
    fn returned(&self) -> Shape {
        let around = &self.context.around;
        let mut blocks = self.context.blocks.iter();
        let Some(function) = blocks.find(|block| block.kind == BlockKind::Function) else {
            return Shape::Unknown;
        };
        let Some(open) = (function.head..self.context.statement.start)
            .find(|&at| around.kind(at) == Some(Kind::OpenBrace))
        else {
            return Shape::Unknown;
        };
        match (function.head..open).find(|&at| around.kind(at) == Some(Kind::Arrow)) {
            Some(arrow) => Shape::read(self.source(&(arrow + 1..open))),
            None => Shape::Unknown,
        }
    }

    /// Returns the expectation from the value of the `switch` around the cursor.
    fn switched(&self) -> Expected {
        let around = &self.context.around;
        let mut blocks = self.context.blocks.iter();
        let Some(switch) = blocks.find(|block| block.kind == BlockKind::Switch) else {
            return Expected::default();
        };
        let start = switch.head + 2;
        let Some(end) =
            (start..self.context.statement.start).find(|&at| around.kind(at) == Some(Kind::OpenBrace))
        else {
            return Expected::default();
        };
        let value = start..end.saturating_sub(1);
        Expected { shape: self.shape_of(&value), choices: self.choices_of(&value), ..Expected::default() }
    }

    /// Returns the allowed texts of a param or parameter, from its declaration.
    fn choices_of(&self, tokens: &Range<usize>) -> Vec<String> {
        let around = &self.context.around;
        let place = self.find(self.source(tokens)).and_then(|known| known.declared.as_ref());
        let Some(place) = place.filter(|place| *place.file == *self.file) else { return Vec::new() };
        let name = around.token_at(place.start as usize);
        let mut rest = (name..).map_while(|at| around.kind(at).map(|kind| (at, kind)));
        let domain = rest
            .find(|(_, kind)| matches!(kind, Kind::In | Kind::Comma | Kind::CloseParen | Kind::Semicolon));
        match domain {
            Some((at, Kind::In)) if around.kind(at + 1) == Some(Kind::OpenBracket) => {
                let texts =
                    (at..).take_while(|&at| around.kind(at).is_some_and(|kind| kind != Kind::CloseBracket));
                let texts = texts.filter(|&at| around.kind(at) == Some(Kind::StringText));
                texts.map(|at| around.source(at).to_string()).collect()
            }
            _ => Vec::new(),
        }
    }
}

/// Returns the expectation of a parameter.
fn parameter(parameter: &CallParameter) -> Expected {
    let shape = match (Shape::read(&parameter.ty), parameter.dimension) {
        (Shape::Number(_), Some(dimension)) => Shape::Number(Some(dimension)),
        (shape, _) => shape,
    };
    let choices = match parameter.choices.is_empty() && holds_text(&shape) {
        // Texts that only the engine checks are listed in the documentation.
        true => quoted(parameter.doc.as_deref().unwrap_or_default()),
        false => parameter.choices.clone(),
    };
    let hint = if shape == Shape::Unknown { hint(&parameter.name) } else { None };
    Expected { shape, choices, hint, ..Expected::default() }
}

fn holds_text(shape: &Shape) -> bool {
    match shape {
        Shape::Array(element) => element.is("String"),
        shape => shape.is("String"),
    }
}

/// Returns the texts between double quotes.
fn quoted(text: &str) -> Vec<String> {
    text.split('"').skip(1).step_by(2).map(str::to_string).collect()
}

/// Returns the type of the other factor in a product of type `wanted` with `left`.
fn other_factor(wanted: &Shape, left: &Shape, divides: bool) -> Shape {
    let quotient = |wanted: &Option<Dimension>, left: &Option<Dimension>| {
        wanted.zip(*left).map(|(wanted, left)| if divides { left.over(wanted) } else { wanted.over(left) })
    };
    match (wanted, left) {
        (Shape::Number(wanted), Shape::Number(left)) => Shape::Number(quotient(wanted, left)),
        (Shape::Observable(_), Shape::Observable(_)) => Shape::Number(None),
        (Shape::Vector(wanted), Shape::Number(left)) if !divides => Shape::Vector(quotient(wanted, left)),
        (Shape::Vector(wanted), Shape::Vector(left)) => Shape::Number(quotient(wanted, left)),
        (Shape::Named(_), Shape::Named(left)) if left == "Transform" => Shape::frame(),
        (wanted, Shape::Unknown) if wanted.is("Transform") => Shape::frame(),
        _ => Shape::Unknown,
    }
}

/// Returns the unit system of the file.
fn system(context: &Context<'_>) -> UnitSystem {
    let around = &context.around;
    let mut at = 0;
    while let Some(kind) = around.kind(at) {
        if kind == Kind::Units {
            return UnitSystem::from_name(around.source(at + 1)).unwrap_or_default();
        }
        at += 1;
    }
    UnitSystem::default()
}

/// Words for lengths and other quantities in gear engineering, by dimension.
const WORDS: &[(&str, &[&str])] = &[
    (
        "Length",
        &[
            "width",
            "diameter",
            "radius",
            "thickness",
            "distance",
            "depth",
            "height",
            "offset",
            "gap",
            "pitch",
            "relief",
            "crown",
            "backlash",
            "clearance",
            "module",
            "runout",
        ],
    ),
    ("Angle", &["roll", "phase"]),
    ("AngularVelocity", &["omega", "rpm"]),
    ("Pressure", &["modulus", "strength"]),
    ("Moment", &["moment"]),
    ("Force", &["load"]),
    ("Time", &["duration"]),
];

/// Returns the dimension that the last word of a name suggests: `tip_radius` is a length.
pub fn hint(name: &str) -> Option<Dimension> {
    let mut words = name.rsplit('_').filter(|word| word.chars().any(char::is_alphabetic));
    let word = words.next()?.to_lowercase();
    let mut capital = word.clone();
    if let Some(first) = capital.get_mut(..1) {
        first.make_ascii_uppercase();
    }
    if let Some(known) = Dimension::from_name(&capital).filter(|known| !known.is_none()) {
        return Some(known);
    }
    let (dimension, _) = WORDS.iter().find(|(_, words)| words.contains(&word.as_str()))?;
    shape::dimension(dimension)
}
