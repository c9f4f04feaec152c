//! Resolution of the callee of a call by the path before its parenthesis, and of the parameters
//! without arguments. Works without a syntax tree of the statement.

use super::cursor::Call;
use super::shape::Shape;
use calyx_lang::analysis::{CallParameter, Callable, NameKind, Visible};
use calyx_lang::ast::Mode;
use calyx_lang::check::HANDLE_FIELDS;
use calyx_lang::db::Database;

/// Resolves a path to a callable: `sin`, `Size`, `gears.external`.
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

/// Returns the signature of a visible name, if it can be called.
pub fn of(database: &Database, known: &Visible) -> Option<Callable> {
    match (&known.declared, known.kind) {
        (Some(place), kind) if is_called(kind) => database.callable_as_seen(place),
        (None, NameKind::Builtin) => database.builtin(&known.name),
        _ => None,
    }
}

/// Returns true if names of this kind take arguments.
pub fn is_called(kind: NameKind) -> bool {
    matches!(
        kind,
        NameKind::Function
            | NameKind::SymbolicFunction
            | NameKind::Extern
            | NameKind::Builtin
            | NameKind::Record
            | NameKind::Component
    )
}

/// Returns the dotted path of the module that a name refers to.
pub fn module_path(database: &Database, visible: &[Visible], name: &str) -> Option<String> {
    let module = visible.iter().find(|known| *known.name == *name && known.kind == NameKind::Module)?;
    database.module_of(&module.declared.as_ref()?.file)
}

/// Returns the fields of a name whose value is a record.
pub fn fields_of(database: &Database, visible: &[Visible], name: &str) -> Option<Vec<CallParameter>> {
    let known = visible.iter().find(|known| *known.name == *name)?;
    fields(database, visible, &Shape::read(known.ty.as_deref()?))
}

/// Returns the fields of a record type.
pub fn fields(database: &Database, visible: &[Visible], shape: &Shape) -> Option<Vec<CallParameter>> {
    let Shape::Named(record) = shape else { return None };
    let is_type = |known: &Visible| matches!(known.kind, NameKind::Record | NameKind::Component);
    let seen = visible.iter().find(|known| *known.name == **record && is_type(known));
    let fields = |known: &Visible| match (known.kind, &known.declared) {
        (NameKind::Component, Some(place)) => database.members_of_component(place),
        _ => of(database, known).map(|callable| callable.parameters),
    };
    match seen {
        Some(known) => fields(known),
        None => {
            // The type of a record of a module is its unqualified name.
            let name = record.rsplit('.').next().unwrap_or(record);
            let exported = database.exported(name);
            let declared = exported.iter().find(|(_, known)| is_type(known));
            declared.and_then(|(_, known)| fields(known)).or_else(|| handle_fields(name))
        }
    }
}

/// Returns the fields of an object of the library.
fn handle_fields(handle: &str) -> Option<Vec<CallParameter>> {
    let own: Vec<CallParameter> = HANDLE_FIELDS
        .iter()
        .filter(|(known, ..)| *known == handle)
        .map(|(_, name, doc)| CallParameter {
            name: (*name).into(),
            former: None,
            mode: Mode::In,
            symbolic: true,
            ty: "Transform".into(),
            dimension: None,
            default: None,
            range: None,
            choices: Vec::new(),
            doc: Some((*doc).into()),
            declared: None,
        })
        .collect();
    (!own.is_empty()).then_some(own)
}

/// Assignment of arguments to parameters.
pub struct Matched {
    /// Parameters without an argument; the argument at the cursor does not count.
    pub left: Vec<usize>,
    /// True if no argument before the cursor is named.
    pub in_order: bool,
}

/// Determines which parameters have no argument yet.
pub fn matched(callable: &Callable, call: &Call, fields: &dyn Fn(&str) -> Vec<CallParameter>) -> Matched {
    let mut given = vec![false; callable.parameters.len()];
    let mut in_order = true;
    let mut mark = |name: &str| {
        if let Some(at) = callable.parameters.iter().position(|parameter| parameter.is_called(name))
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

/// Returns the index of the parameter of a positional argument.
pub fn position(callable: &Callable, at: usize) -> Option<usize> {
    let last = callable.parameters.len().checked_sub(1)?;
    if at <= last { Some(at) } else { callable.open.then_some(last) }
}
