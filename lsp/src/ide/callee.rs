//! What a call calls, by the names before its bracket, and which of its parameters have arguments. Works where the statement has no
//! tree yet.

use super::cursor::Call;
use super::shape::Shape;
use calyx_lang::analysis::{CallParameter, Callable, NameKind, Visible};
use calyx_lang::db::Database;

/// What can be called by the names of a path: `sin`, `Size`, `gears.external`.
pub fn callable(database: &Database, visible: &[Visible], path: &[String]) -> Option<Callable> {
    let (name, modules) = path.split_last()?;
    match modules.last() {
        None => of(database, visible.iter().find(|known| *known.name == **name)?),
        Some(module) => {
            let path = module_path(database, visible, module)?;
            let members = database.members(&path);
            of(database, members.iter().find(|known| *known.name == **name)?)
        }
    }
}

/// How a visible name is called, if it can be.
pub fn of(database: &Database, known: &Visible) -> Option<Callable> {
    match (&known.declared, known.kind) {
        (Some(place), kind) if is_called(kind) => database.callable_as_seen(place),
        (None, NameKind::Builtin) => database.builtin(&known.name),
        _ => None,
    }
}

/// Whether a name of this kind is followed by arguments.
pub fn is_called(kind: NameKind) -> bool {
    matches!(
        kind,
        NameKind::Function
            | NameKind::SymbolicFunction
            | NameKind::Extern
            | NameKind::Builtin
            | NameKind::Record
    )
}

/// The dotted path of the module that a name stands for.
pub fn module_path(database: &Database, visible: &[Visible], name: &str) -> Option<String> {
    let module = visible.iter().find(|known| *known.name == *name && known.kind == NameKind::Module)?;
    database.module_of(&module.declared.as_ref()?.file)
}

/// The fields of a record that is the value of a name.
pub fn fields_of(database: &Database, visible: &[Visible], name: &str) -> Option<Vec<CallParameter>> {
    let known = visible.iter().find(|known| *known.name == *name)?;
    fields(database, visible, &Shape::read(known.ty.as_deref()?))
}

/// The fields of a record type.
pub fn fields(database: &Database, visible: &[Visible], shape: &Shape) -> Option<Vec<CallParameter>> {
    let Shape::Named(record) = shape else { return None };
    let seen = visible.iter().find(|known| *known.name == **record && known.kind == NameKind::Record);
    let callable = match seen {
        Some(known) => of(database, known),
        None => {
            // A value of a module's record is shown by the record's own name.
            let exported = database.exported(record.rsplit('.').next().unwrap_or(record));
            exported
                .iter()
                .find(|(_, known)| known.kind == NameKind::Record)
                .and_then(|(_, known)| of(database, known))
        }
    };
    Some(callable?.parameters)
}

/// How arguments meet parameters.
pub struct Matched {
    /// Parameters without an argument; the one that the cursor gives is among them.
    pub left: Vec<usize>,
    /// No argument before the cursor has a name.
    pub in_order: bool,
}

/// Which parameters of what is called have no argument yet.
pub fn matched(callable: &Callable, call: &Call, fields: &dyn Fn(&str) -> Vec<CallParameter>) -> Matched {
    let mut given = vec![false; callable.parameters.len()];
    let mut in_order = true;
    let mut mark = |name: &str| {
        if let Some(at) = callable.parameters.iter().position(|parameter| *parameter.name == *name)
            && let Some(slot) = given.get_mut(at)
        {
            *slot = true;
        }
    };
    let mut positions = Vec::new();
    for (at, argument) in call.arguments.iter().enumerate() {
        if at == call.active {
            continue;
        }
        match (&argument.name, &argument.spread) {
            (Some(name), _) => mark(name),
            (_, Some(record)) => fields(record).iter().for_each(|field| mark(&field.name)),
            _ if argument.empty => {}
            _ => positions.push(at),
        }
        if at < call.active && (argument.name.is_some() || argument.spread.is_some()) {
            in_order = false;
        }
    }
    for at in positions {
        if let Some(slot) = given.get_mut(at) {
            *slot = true;
        }
    }
    let left = given.iter().enumerate().filter(|(_, given)| !**given).map(|(at, _)| at).collect();
    Matched { left, in_order }
}

/// The parameter of an argument given in order.
pub fn position(callable: &Callable, at: usize) -> Option<usize> {
    let last = callable.parameters.len().checked_sub(1)?;
    if at <= last { Some(at) } else { callable.open.then_some(last) }
}
