//! Hover text with the derived geometry of a gear or mesh, from the latest elaboration.

use crate::ide::Snapshot;
use crate::ide::elaborated::Elaborated;
use crate::ide::enclosing::EnclosingNodes;
use crate::ide::symbol_dependencies::value_at;
use calyx_elaborate::shown::value;
use calyx_elaborate::{CreatedAt, GearGeometry, MeshGeometry, Quantity};
use calyx_lang::analysis::{Name, NameKind, SourceRange};
use calyx_lang::ast::ExprKind;
use calyx_lang::units::UnitSystem;

/// Largest number of meshes shown for a gear.
const MOST_MESHES: usize = 3;

/// Returns the derived geometry of the gear or mesh that a named call creates, or that a variable
/// is initialized with; `None` if it is unknown, or an edit has touched the call since.
pub(super) fn of(snapshot: &Snapshot, file: &str, name: &Name, system: UnitSystem) -> Option<String> {
    let (file, offset) = call(snapshot, file, name)?;
    let each = snapshot.elaborated.values();
    each.into_iter().find_map(|elaborated| {
        let gear = elaborated.gear_at(&snapshot.database, &file, offset);
        let is_this = |span| {
            let now = elaborated.now(&snapshot.database, span);
            // The smallest call around may have this call as an argument.
            now.is_some_and(|place| callee_end(snapshot, &place) == Some(offset))
        };
        if let Some(gear) = gear.filter(|gear| is_this(gear.span)) {
            return Some(of_gear(elaborated, gear, system));
        }
        let mesh = elaborated.mesh_at(&snapshot.database, &file, offset)?;
        is_this(mesh.span).then(|| of_mesh(mesh, system))
    })
}

/// Returns file and end of the name of the callee.
fn call(snapshot: &Snapshot, file: &str, name: &Name) -> Option<(String, u32)> {
    match (name.kind, &name.declared) {
        (NameKind::Extern | NameKind::Function, _) => Some((file.to_string(), name.end)),
        (NameKind::Variable, Some(place)) => {
            let tree = snapshot.database.around(&place.file, place.start)?;
            let value = value_at(&tree.module, place.start)?;
            let ExprKind::Call { callee, .. } = &value.kind else { return None };
            Some((place.file.to_string(), callee.span.end))
        }
        _ => None,
    }
}

/// Returns the end of the callee's name in the call at a position.
fn callee_end(snapshot: &Snapshot, place: &SourceRange) -> Option<u32> {
    let tree = snapshot.database.around(&place.file, place.start)?;
    let around = EnclosingNodes::new(&tree.module, place.start..place.end);
    let e = around.expressions().find(|e| (e.span.start, e.span.end) == (place.start, place.end))?;
    let ExprKind::Call { callee, .. } = &e.kind else { return None };
    Some(callee.span.end)
}

fn of_gear(elaborated: &Elaborated, made: &CreatedAt<GearGeometry>, system: UnitSystem) -> String {
    let Some(gear) = made.first.first() else { return String::new() };
    let mut rows = rows(gear.quantities.iter().filter(|quantity| quantity.essential), system);
    for membership in gear.meshes.iter().take(MOST_MESHES) {
        let Some(mesh) = elaborated.elaboration.geometry.mesh(*membership) else { continue };
        let [first, second] = &mesh.bodies;
        let mate = if membership.member == 0 { second } else { first };
        let own = |quantity: &&Quantity| match quantity.member {
            Some(member) => quantity.essential && member == membership.member,
            None => quantity.symbol == "epsilon_alpha",
        };
        let title = format!("with \"{mate}\"");
        rows += &format!("| *{title}* | |\n");
        rows += &self::rows(mesh.quantities.iter().filter(own), system);
    }
    let bodies = gear.bodies.iter().map(|body| format!("\"{body}\"")).collect::<Vec<_>>().join(" and ");
    let of = if bodies.is_empty() { String::new() } else { format!(" of {bodies}") };
    table(&format!("Geometry{of}{}", first_of(made.count)), &rows)
}

fn of_mesh(made: &CreatedAt<MeshGeometry>, system: UnitSystem) -> String {
    let Some(mesh) = made.first.first() else { return String::new() };
    let [first, second] = &mesh.bodies;
    let of_both = |quantity: &&Quantity| quantity.essential && quantity.member.is_none();
    let mut rows = rows(mesh.quantities.iter().filter(of_both), system);
    for (member, body) in [first, second].into_iter().enumerate() {
        let own = |quantity: &&Quantity| quantity.essential && quantity.member == Some(member);
        let of_member = self::rows(mesh.quantities.iter().filter(own), system);
        if !of_member.is_empty() {
            rows += &format!("| *\"{body}\"* | |\n{of_member}");
        }
    }
    table(&format!("\"{first}\" with \"{second}\"{}", first_of(made.count)), &rows)
}

fn first_of(count: usize) -> String {
    if count > 1 { format!(", the first of {count} that this makes") } else { String::new() }
}

fn rows<'q>(quantities: impl Iterator<Item = &'q Quantity>, system: UnitSystem) -> String {
    let each = quantities.map(|quantity| {
        let note = if quantity.note.is_empty() { String::new() } else { format!(" ({})", quantity.note) };
        format!("| {} | {}{note} |\n", quantity.name, value(quantity, system.name()))
    });
    each.collect()
}

/// Formats a table; the title is above the header rule.
fn table(title: &str, rows: &str) -> String {
    format!("| {title} | |\n|---|---|\n{}", rows.trim_end())
}
