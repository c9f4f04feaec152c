//! Completion from closed lists: types, modules, unit systems, labels, components and fields,
//! allowed values.

use super::context::Value;
use super::item::{Insert, Item, ItemKind, Rank, Subject};
use super::request::Request;
use crate::ide::callee;
use crate::ide::cursor::BlockKind;
use crate::ide::shape::Shape;
use calyx_lang::analysis::NameKind;
use calyx_lang::ast::{Stmt, StmtKind};
use calyx_lang::declared::{Declared, find};
use calyx_lang::dimension::Dimension;
use calyx_lang::lexer::Kind;
use calyx_lang::units::UnitSystem;
use std::collections::BTreeSet;

/// Types other than dimensions, with their description.
const TYPES: &[(&str, &str)] = &[
    ("Bool", "TRUE or FALSE"),
    ("String", "a text"),
    ("Vector", "three numbers of one dimension"),
    ("Transform", "a frame"),
    ("Array", "elements of one type"),
    ("Observable", "what the engine observes at each step"),
];

/// Common dimensions in gear models.
const USUAL: &[&str] =
    &["Length", "Number", "Angle", "Force", "Moment", "Pressure", "AngularVelocity", "Time", "Stiffness"];

/// Offers types and dimensions.
pub fn types(request: &Request<'_>, items: &mut Vec<Item>) {
    let around = &request.context.around;
    // Only dimensions have products.
    let product = matches!(around.previous(around.before), Some(Kind::Star | Kind::Slash | Kind::Assign));
    let rank = |origin, order: usize| Rank { fit: 1, origin, order: order as u32 };
    for (order, known) in request.visible.iter().enumerate() {
        let record = matches!(known.kind, NameKind::Record | NameKind::Component)
            && !product
            && !request.is_around(known);
        if known.kind == NameKind::Dimension || record {
            // `Error` is visible everywhere and seldom meant.
            let origin = if known.level.is_some() { 0 } else { 3 };
            let mut item = Item::new(known.name.to_string(), ItemKind::Type, rank(origin, order));
            item.detail = known.kind.describe().to_string();
            item.subject = known.declared.clone().map(Subject::Declaration);
            items.push(item);
        }
        if known.kind == NameKind::Module && !product {
            items.push(Item::new(known.name.to_string(), ItemKind::Module, rank(4, order)).detail("module"));
        }
    }
    let usual = USUAL.iter().copied();
    let others = Dimension::names().filter(|name| !USUAL.contains(name));
    for (order, name) in usual.chain(others).enumerate() {
        let dimension = Dimension::from_name(name);
        let unit = dimension.map(|dimension| request.system.unit_of(dimension).name).unwrap_or_default();
        let detail = if unit.is_empty() { "a pure number".to_string() } else { format!("in {unit}") };
        items.push(Item::new(name, ItemKind::Type, rank(1, order)).detail(detail));
    }
    if product {
        return;
    }
    for (order, (name, detail)) in TYPES.iter().enumerate() {
        let mut item = Item::new(*name, ItemKind::Type, rank(2, order)).detail(*detail);
        if matches!(*name, "Array" | "Observable") {
            item.insert = Insert::snippet(*name, format!("{name}($0)"));
        }
        items.push(item);
    }
    for (order, name) in handles(request).into_iter().enumerate() {
        items.push(Item::new(name, ItemKind::Type, rank(3, order)).detail("made by the library"));
    }
}

/// Returns the types of handles that functions of imported modules return.
fn handles(request: &Request<'_>) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    for module in request.visible.iter().filter(|known| known.kind == NameKind::Module) {
        let Some(path) = callee::module_path(request.database, &request.visible, &module.name) else {
            continue;
        };
        for known in request.database.members(&path).iter().filter(|known| known.kind == NameKind::Extern) {
            if let Shape::Named(name) = Shape::result(known.ty.as_deref().unwrap_or_default())
                && !matches!(name.as_str(), "Bool" | "String" | "Transform" | "nothing")
            {
                found.insert(name);
            }
        }
    }
    found
}

/// Offers records and dimensions of a module: `module.` in a type.
pub fn types_of(request: &Request<'_>, module: &str, items: &mut Vec<Item>) {
    let Some(path) = callee::module_path(request.database, &request.visible, module) else { return };
    for (order, known) in request.database.members(&path).iter().enumerate() {
        if matches!(known.kind, NameKind::Record | NameKind::Enum | NameKind::Component | NameKind::Dimension)
        {
            let rank = Rank { order: order as u32, ..Rank::default() };
            let mut item =
                Item::new(known.name.to_string(), ItemKind::Type, rank).detail(known.kind.describe());
            item.subject = known.declared.clone().map(Subject::Declaration);
            items.push(item);
        }
    }
}

/// Offers modules after `import ` that exist and are not imported yet, below the written part of
/// the path.
pub fn modules(request: &Request<'_>, written: &[String], beside: &[String], items: &mut Vec<Item>) {
    let around = &request.context.around;
    let imported = super::imports::imported(around);
    let own = request.database.module_of(request.file);
    let above = written.iter().fold(String::new(), |path, name| path + name + ".");
    let mut paths = request.database.modules();
    paths.extend_from_slice(beside);
    paths.sort();
    paths.dedup();
    for path in paths {
        let Some(rest) = path.strip_prefix(&above).filter(|rest| !rest.is_empty()) else { continue };
        if imported.contains(&path) || own.as_deref() == Some(&*path) {
            continue;
        }
        let mut item = Item::new(rest, ItemKind::Module, Rank::default());
        let file = request.database.file_of(&path);
        let doc = file.and_then(|file| request.database.module_doc(&file)).unwrap_or_default();
        item.detail = doc.lines().next().unwrap_or("module").to_string();
        if around.kind(around.next()) != Some(Kind::Semicolon) {
            item.insert = Insert::plain(format!("{rest};"));
        }
        items.push(item);
    }
}

/// Offers unit systems after `units `.
pub fn systems(request: &Request<'_>, items: &mut Vec<Item>) {
    let around = &request.context.around;
    let systems = [UnitSystem::MmNS, UnitSystem::InchLbfS, UnitSystem::Si];
    for (order, system) in systems.into_iter().enumerate() {
        let unit =
            |name: &str| Dimension::from_name(name).map(|d| system.unit_of(d).name).unwrap_or_default();
        let rank = Rank { order: order as u32, ..Rank::default() };
        let mut item = Item::new(system.name(), ItemKind::Value, rank);
        item.detail = [unit("Length"), unit("Force"), unit("Pressure"), unit("Moment")].join(", ");
        if around.kind(around.next()) != Some(Kind::Semicolon) {
            item.insert = Insert::plain(format!("{};", system.name()));
        }
        items.push(item);
    }
}

/// Offers labels after `goto `: those of the function around the cursor, or of the top level.
pub fn labels(request: &Request<'_>, items: &mut Vec<Item>) {
    let around = &request.context.around;
    let function =
        |at: usize| around.blocks(at).find(|block| block.kind == BlockKind::Function).map(|b| b.head);
    let own = function(around.before);
    let mut at = 0;
    while let Some(kind) = around.kind(at) {
        let begins = matches!(
            around.previous(at),
            None | Some(Kind::Semicolon | Kind::OpenBrace | Kind::CloseBrace | Kind::Colon)
        );
        if kind == Kind::Identifier
            && around.kind(at + 1) == Some(Kind::Colon)
            && (begins || around.begins_line(at))
            && around.block(at).is_none_or(|block| block.kind != BlockKind::Record)
            && function(at) == own
        {
            let order = at.abs_diff(around.before) as u32;
            items.push(Item::new(around.source(at), ItemKind::Label, Rank { order, ..Rank::default() }));
        }
        at += 1;
    }
}

/// Offers components of a vector and fields of a record.
pub fn parts(request: &Request<'_>, shape: &Shape, items: &mut Vec<Item>) {
    if let Shape::Vector(dimension) = shape {
        let detail = dimension.map(|dimension| dimension.to_string()).unwrap_or_default();
        for (order, name) in ["x", "y", "z"].into_iter().enumerate() {
            let rank = Rank { order: order as u32, ..Rank::default() };
            items.push(Item::new(name, ItemKind::Field, rank).detail(detail.clone()));
        }
        return;
    }
    for (order, field) in request.fields(shape).unwrap_or_default().iter().enumerate() {
        let fit = request.expected.shape.fit(&Shape::read(&field.ty)) as u8;
        let rank = Rank { fit, origin: 0, order: order as u32 };
        let mut item = Item::new(field.name.to_string(), ItemKind::Field, rank);
        item.detail = super::arguments::detail(request, field);
        item.subject = field.declared.clone().map(Subject::Declaration);
        items.push(item);
    }
}

/// Offers the choices of an enumeration, `Name` or `module.Name`. Returns false for other names.
pub fn choices_of_enumeration(request: &Request<'_>, name: &str, items: &mut Vec<Item>) -> bool {
    let (module, own) = name.rsplit_once('.').map_or((None, name), |(module, own)| (Some(module), own));
    let declared = match module {
        None => request.find(own).filter(|known| known.kind == NameKind::Enum).cloned(),
        Some(module) => callee::module_path(request.database, &request.visible, module).and_then(|path| {
            let members = request.database.members(&path);
            members.into_iter().find(|known| known.kind == NameKind::Enum && *known.name == *own)
        }),
    };
    let Some(place) = declared.and_then(|known| known.declared) else { return false };
    let Some(tree) = request.database.around(&place.file, place.start) else { return false };
    let Some((_, Declared::Statement(Stmt { kind: StmtKind::Enum(decl), .. }))) =
        find(&tree.module, place.start)
    else {
        return false;
    };
    for (order, choice) in decl.choices.iter().enumerate() {
        let rank = Rank { order: order as u32, ..Rank::default() };
        let mut item = Item::new(choice.name.name.to_string(), ItemKind::Value, rank);
        item.detail = choice.doc.as_deref().and_then(|doc| doc.lines().next()).unwrap_or(own).to_string();
        items.push(item);
    }
    true
}

/// Offers the allowed texts, with quotes if the cursor is not between quotes.
pub fn choices(request: &Request<'_>, quoted: bool, items: &mut Vec<Item>) {
    // Texts already in the same list are not offered again.
    for (order, choice) in request.expected.choices.iter().enumerate() {
        let label = if quoted { format!("\"{choice}\"") } else { choice.clone() };
        let rank = Rank { order: order as u32, ..Rank::default() };
        let mut item = Item::new(label, ItemKind::Value, rank).detail("allowed value");
        item.filter = Some(choice.clone());
        items.push(item);
    }
}

/// Prefers `TRUE` and `FALSE` if nothing else is expected.
pub fn truths(items: &mut [Item], request: &Request<'_>, value: &Value) {
    if super::keywords::is_truth(value, request) {
        for item in items.iter_mut().filter(|item| matches!(item.label.as_str(), "TRUE" | "FALSE")) {
            item.rank = Rank { fit: 0, origin: 2, order: 0 };
        }
    }
}
