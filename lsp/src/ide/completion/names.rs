//! Completion of names in scope, and of qualified names of imported modules.

use super::context::{CompletionSite, Operator, Slot, Value};
use super::item::{AfterInsert, Insert, Item, ItemKind, Rank, Subject};
use super::request::Request;
use crate::ide::callee;
use crate::ide::shape::{Fit, Shape};
use calyx_lang::analysis::{NameKind, Visible};
use calyx_lang::lexer::Kind;

/// Builtin functions that create frames and take expressions.
const FRAMES: &[&str] = &["Rotate", "Translate"];

/// Functions whose argument is an expression, even without `:=`.
pub const TAKE_EXPRESSIONS: &[&str] =
    &["derivative", "gradient", "velocity", "acceleration", "angular_velocity", "angular_acceleration"];

/// Rank of names with a wrong type: shown only after typing their first letters.
pub const UNFIT: u8 = 4;

/// Offers names for a value.
pub fn values(request: &Request<'_>, items: &mut Vec<Item>) {
    let top = top_level(request);
    for (index, known) in request.visible.iter().enumerate() {
        if let Some(fit) = fit(request, known) {
            items.push(item(request, known, None, rank(request, known, fit, top, index)));
        }
    }
    qualified(request, items, &|known| fit(request, known));
}

/// Offers names that a statement may start with, for calls and assignments.
pub fn statements(request: &Request<'_>, items: &mut Vec<Item>) {
    let top = top_level(request);
    let fit = |known: &Visible| match known.kind {
        NameKind::Function | NameKind::Extern | NameKind::Builtin => {
            let nothing = known.ty.as_deref().is_some_and(|ty| Shape::result(ty).is("nothing"));
            // A function with a result is seldom called as a statement.
            Some(if nothing { 2 } else { UNFIT })
        }
        NameKind::Variable | NameKind::Parameter | NameKind::Symbolic => Some(3),
        NameKind::Module => Some(3),
        _ => None,
    };
    for (index, known) in request.visible.iter().enumerate() {
        if let Some(fit) = fit(known) {
            items.push(item(request, known, None, rank(request, known, fit, top, index)));
        }
    }
    qualified(request, items, &fit);
}

/// Offers the members of imported modules, as `module.name`. Before the first typed letter, offers
/// only members of exactly the expected type.
fn qualified(request: &Request<'_>, items: &mut Vec<Item>, fit: &dyn Fn(&Visible) -> Option<u8>) {
    let typed = !request.context.around.prefix().is_empty();
    for module in request.visible.iter().filter(|known| known.kind == NameKind::Module) {
        let Some(path) = callee::module_path(request.database, &request.visible, &module.name) else {
            continue;
        };
        for (order, known) in request.database.members(&path).iter().enumerate() {
            let Some(fit) = fit(known).filter(|fit| typed || *fit == 0) else { continue };
            let rank = Rank { fit, origin: 3, order: order as u32 };
            items.push(item(request, known, Some(&module.name), rank));
        }
    }
}

/// Offers params, parameters of symbolic functions, and `Time`: the names that may follow `at` and
/// the variables of differentiation.
pub fn symbols(request: &Request<'_>, items: &mut Vec<Item>, assigned: bool) {
    for (order, known) in request.visible.iter().enumerate() {
        let shape = shape(known);
        let fit = match known.kind {
            NameKind::Constant if &*known.name == "Time" => 0,
            NameKind::Param if matches!(shape, Shape::Number(_)) => 1,
            NameKind::Parameter if !assigned && matches!(shape, Shape::Number(_) | Shape::Unknown) => 0,
            _ => continue,
        };
        let mut item = item(request, known, None, Rank { fit, origin: 0, order: order as u32 });
        if assigned {
            item.insert = Insert::plain(format!("{} = ", known.name));
        }
        items.push(item);
    }
}

/// Offers the members of a module.
pub fn members(request: &Request<'_>, module: &str, value: &Value, items: &mut Vec<Item>) {
    let Some(path) = callee::module_path(request.database, &request.visible, module) else { return };
    let statement = value.slot == Slot::Free && value.operator == Operator::None;
    for (order, known) in request.database.members(&path).iter().enumerate() {
        let fit = match statement {
            true if matches!(known.kind, NameKind::Dimension | NameKind::Unit) => None,
            true => Some(1),
            false => fit(request, known),
        };
        if let Some(fit) = fit {
            items.push(item(request, known, None, Rank { fit, origin: 3, order: order as u32 }));
        }
    }
}

/// Returns how well a name matches the value at the cursor, 0 is best; `None` if it is invalid
/// there.
pub fn fit(request: &Request<'_>, known: &Visible) -> Option<u8> {
    let expected = &request.expected;
    let shape = shape(known);
    let symbolic = expected.symbolic || request.context.takes_expression(TAKE_EXPRESSIONS);
    match known.kind {
        NameKind::Dimension | NameKind::Unit | NameKind::Field => return None,
        // An output depends on the steps of the analysis, so it is valid in expressions only.
        NameKind::Output if !symbolic => return None,
        NameKind::Module => return Some(3),
        _ if shape.is("nothing") => return None,
        _ => {}
    }
    let known_shape = expected.shape != Shape::Unknown;
    let local =
        known.kind == NameKind::Parameter || known.level.is_some_and(|level| level < top_level(request));
    let mut fit = match expected.shape.fit(&shape) {
        // Names rank before functions that must be called, except for frames, which are usually
        // created by a call.
        Fit::Exactly if known.kind == NameKind::Builtin && !shape.is("Transform") => 1,
        Fit::Exactly => 0,
        Fit::Perhaps if known_shape && local => 0,
        // `solve` and `sum` give numbers, vectors and arrays, but no objects of the library.
        Fit::Perhaps if known.declared.is_none() && matches!(expected.shape, Shape::Named(_)) => UNFIT,
        // `abs` has the type of its argument.
        Fit::Perhaps if known_shape && known.declared.is_none() => 2,
        Fit::Perhaps => 1,
        Fit::InPart => 2,
        // In a comparison or an index it may have the expected type.
        Fit::Not
            if expected.weak && matches!(shape, Shape::Number(_) | Shape::Vector(_) | Shape::Array(_)) =>
        {
            2
        }
        Fit::Not if expected.weak && shape.is("String") => 3,
        Fit::Not => UNFIT,
    };
    let is_symbol = matches!(known.kind, NameKind::Symbolic | NameKind::SymbolicFunction)
        || (known.kind == NameKind::Param && matches!(shape, Shape::Number(_)))
        || (known.declared.is_none() && (&*known.name == "Time" || FRAMES.contains(&&*known.name)));
    if symbolic && expected.shape == Shape::Unknown && is_symbol {
        fit = 0;
    }
    if !symbolic {
        match known.kind {
            NameKind::Constant if &*known.name == "Time" => return Some(5),
            // Frames are usually expressions.
            NameKind::Symbolic if !shape.is("Transform") => fit += 1,
            _ => {}
        }
    }
    // A recursive call is unlikely.
    if request.is_around(known) {
        fit += 1;
    }
    Some(fit)
}

/// Returns the type of the value of a name; for a function, of its result.
pub fn shape(known: &Visible) -> Shape {
    let ty = known.ty.as_deref().unwrap_or_default();
    match known.kind {
        NameKind::Record | NameKind::Component => Shape::Named(known.name.to_string()),
        kind if callee::is_called(kind) && ty.contains(')') => Shape::result(ty),
        // Has any dimension.
        NameKind::Constant if matches!(&*known.name, "inf" | "nan") => Shape::Number(None),
        _ => Shape::read(ty),
    }
}

/// Returns the scope level of the file's own top-level names.
fn top_level(request: &Request<'_>) -> u32 {
    request.visible.iter().filter_map(|known| known.level).max().unwrap_or_default()
}

fn rank(request: &Request<'_>, known: &Visible, fit: u8, top: u32, index: usize) -> Rank {
    let symbolic = request.expected.symbolic;
    let is_number =
        matches!(shape(known), Shape::Number(_) | Shape::Vector(_)) || shape(known).is("Transform");
    let origin = match (known.level, known.kind) {
        (None, NameKind::Constant) if symbolic && &*known.name == "Time" => 1,
        (Some(_), NameKind::Module) => 4,
        (Some(level), _) if level < top || known.kind == NameKind::Parameter => 1,
        // A captured value, next to expressions that depend on symbols.
        (Some(_), NameKind::Variable) if symbolic && is_number => 4,
        (Some(_), _) => 2,
        (None, _) if known.declared.is_some() => 4,
        (None, _) if symbolic && FRAMES.contains(&&*known.name) => 3,
        (None, _) => 5,
    };
    // Nearer declarations come first; builtin names keep their order.
    let near = known.declared.as_ref().filter(|place| *place.file == *request.file);
    let order =
        near.map_or(index as u32, |place| (request.context.around.offset as u32).abs_diff(place.start));
    Rank { fit, origin, order }
}

/// Creates the item of a name; `module` is its prefix.
pub fn item(request: &Request<'_>, known: &Visible, module: Option<&str>, rank: Rank) -> Item {
    let label = match module {
        Some(module) => format!("{module}.{}", known.name),
        None => known.name.to_string(),
    };
    let ty = known.ty.as_deref().unwrap_or_default();
    let mut item = Item::new(label.clone(), ItemKind::Name(known.kind), rank);
    item.filter = module.map(|_| known.name.to_string());
    item.detail = match known.kind {
        NameKind::Symbolic => format!(":= {ty}").trim_end().to_string(),
        NameKind::Module | NameKind::Record | NameKind::Enum | NameKind::Component => {
            known.kind.describe().to_string()
        }
        _ => signature(ty),
    };
    item.subject = Some(match &known.declared {
        Some(place) => Subject::Declaration(place.clone()),
        None => Subject::Builtin(known.name.to_string()),
    });
    if callee::is_called(known.kind) {
        let around = &request.context.around;
        let followed =
            around.kind(around.next()) == Some(Kind::OpenParen) && !around.begins_line(around.next());
        if !followed {
            let empty = ty.starts_with("()");
            let snippet = if empty { format!("{label}()") } else { format!("{label}($0)") };
            item.insert = Insert::snippet(label, snippet);
            item.then = if empty { AfterInsert::Nothing } else { AfterInsert::Signature };
        }
    }
    item
}

/// Formats a signature, `(x: Length) -> Area`, without trivial parts and shortened to one line.
pub fn signature(ty: &str) -> String {
    const WIDEST: usize = 48;
    let ty = ty.split(" where ").next().unwrap_or(ty);
    let ty = ty.replace("(in ", "(").replace(", in ", ", ");
    let (parameters, result) = ty.split_once(") -> ").unwrap_or((&ty, ""));
    if parameters.len() <= WIDEST {
        return ty;
    }
    let mut shown = String::new();
    for parameter in parameters.split(", ") {
        if shown.len() + parameter.len() > WIDEST {
            break;
        }
        shown.push_str(parameter);
        shown.push_str(", ");
    }
    match result {
        "" => format!("{shown}...)"),
        result => format!("{shown}...) -> {result}"),
    }
}

/// Returns false after named arguments, where positional values are invalid.
pub fn wanted(request: &Request<'_>) -> bool {
    match &request.context.spot {
        CompletionSite::Value(Value {
            slot: Slot::Argument { name: None, .. },
            operator: Operator::None,
        }) => request.call.as_ref().is_none_or(|call| call.in_order),
        _ => true,
    }
}
