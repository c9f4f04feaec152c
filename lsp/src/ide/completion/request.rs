//! What the sources of items know of a cursor: the names it sees, and what is expected there.

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

/// A cursor and what is known around it.
pub struct Request<'a> {
    pub database: &'a Database,
    pub file: &'a str,
    pub context: Context<'a>,
    pub visible: Vec<Visible>,
    /// The one the file names, or SI.
    pub system: UnitSystem,
    /// The call the cursor is in, its parameters, and the one the cursor gives.
    pub call: Option<Called>,
    pub expected: Expected,
}

/// The innermost call.
pub struct Called {
    pub callable: Callable,
    /// Of the parameters.
    pub active: Option<usize>,
    /// Parameters that have no argument yet but for the one the cursor is in.
    pub left: Vec<usize>,
    /// An argument in order may stand here: none before it has a name.
    pub in_order: bool,
}

/// What is expected of the value at the cursor.
#[derive(Clone, Debug, PartialEq)]
pub struct Expected {
    pub shape: Shape,
    /// `:=` keeps the expression.
    pub symbolic: bool,
    /// The texts it may be.
    pub choices: Vec<String>,
    /// A number that only hints at its dimension by its name.
    pub hint: Option<Dimension>,
    /// `shape` is of the whole value; the operand at the cursor may be something else.
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

    /// Whether the cursor is in what a name declares: a function's body, a record's fields.
    pub fn is_around(&self, known: &Visible) -> bool {
        let around = &self.context.around;
        let Some(place) = known.declared.as_ref().filter(|place| *place.file == *self.file) else {
            return false;
        };
        let mut heads = self.context.blocks.iter().map(|block| block.head + 1);
        heads.any(|name| around.range(name).start == place.start as usize)
    }

    /// A name the cursor sees.
    pub fn find(&self, name: &str) -> Option<&Visible> {
        self.visible.iter().find(|known| *known.name == *name)
    }

    /// The text of some tokens.
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
            Some((name, _)) => callable.parameters.iter().position(|parameter| *parameter.name == **name),
            None => matched.in_order.then_some(call.active).and_then(|at| position(&callable, at)),
        };
        Some(Called { active, left: matched.left, in_order: matched.in_order, callable })
    }

    /// What is expected of a value's operand at the cursor.
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

    /// What is expected of a whole value.
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

    /// What the function around the cursor says it returns.
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

    /// The value of the `switch` around the cursor.
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

    /// The texts that a param or parameter may be, as its declaration says.
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

/// What a parameter expects.
fn parameter(parameter: &CallParameter) -> Expected {
    let shape = match (Shape::read(&parameter.ty), parameter.dimension) {
        (Shape::Number(_), Some(dimension)) => Shape::Number(Some(dimension)),
        (shape, _) => shape,
    };
    let choices = match parameter.choices.is_empty() && holds_text(&shape) {
        // What the engine allows stands in the documentation alone.
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

/// The texts between double quotes.
fn quoted(text: &str) -> Vec<String> {
    text.split('"').skip(1).step_by(2).map(str::to_string).collect()
}

/// The factor that makes a product with `left` what is wanted.
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

/// The unit system that the file names.
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

/// What a gear engineer calls lengths, and other words that say a dimension.
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

/// The dimension that a name suggests: the last word of `tip_radius` is a length.
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
