//! Attribution of errors: from the location where an error arose to the argument of the program
//! that caused it.

use crate::RuntimeError;
use crate::description::CallDescription;
use crate::error::{Call, Place, codes};

/// Moves an error to the argument at fault.
///
/// If the error names an argument of the call at its location, the location becomes that of the
/// argument. If that is in the library, the error moves on, call by call, to the program: to the
/// argument that the failing one was computed from, or to the call if there is no such argument or
/// there are several. The library's location remains as a note.
///
/// Arguments with default values have no location: the error stays at the call.
///
/// An error in the body of a component moves on to the declaration of the outermost instance, and
/// its location remains as a note with the path of the instance.
pub fn attribute<'c>(
    error: &mut RuntimeError,
    calls: impl Iterator<Item = &'c CallDescription> + Clone,
    is_library: impl Fn(u32) -> bool,
) {
    attribute_argument(error, calls.clone(), is_library);
    let call = calls.clone().find(|call| Some(call.place) == error.place);
    error.details.function = call.map_or_else(String::new, |call| call.function.clone());
    attribute_instance(error);
}

/// Returns what is wrong at the location of an error that concerns no single argument.
pub fn cause(error: &RuntimeError) -> String {
    match error.details.function.as_str() {
        _ if error.code == codes::ASSERTION => "this assertion fails".into(),
        // An `output` is a declaration, although the engine receives it as a call.
        "" | "output" => "the error occurs here".into(),
        function => format!("this call of `{function}` fails"),
    }
}

/// Moves an error from the body of a component to the declaration of the instance.
fn attribute_instance(error: &mut RuntimeError) {
    let calls = &error.details.calls;
    let innermost = calls.iter().find_map(Call::instance);
    let outermost = calls.iter().rfind(|call| call.instance().is_some());
    let (Some(place), Some(path), Some(outermost)) = (error.place, innermost, outermost) else { return };
    if place == outermost.place {
        return;
    }
    let cause = match error.argument {
        Some(_) => "caused by this argument".into(),
        None => cause(error),
    };
    let note = format!("{cause}, in `{path}`");
    error.place = Some(outermost.place);
    error.argument = None;
    error.details.notes.push((place, note));
}

fn attribute_argument<'c>(
    error: &mut RuntimeError,
    calls: impl Iterator<Item = &'c CallDescription> + Clone,
    is_library: impl Fn(u32) -> bool,
) {
    let call_at = |place: Place| calls.clone().find(|call| call.place == place);
    let Some(mut place) = error.place else { return };
    let mut carried: Vec<String>;
    match &error.argument {
        Some(name) => match call_at(place).filter(|call| call.has(name)) {
            Some(call) => {
                carried = call.carried(name).to_vec();
                place = call.argument(name).unwrap_or(place);
            }
            // The error has already been moved to the argument.
            None => {
                let call = calls.clone().find(|call| call.argument(name) == Some(place));
                carried = call.map_or_else(Vec::new, |call| call.carried(name).to_vec());
            }
        },
        // For a `throw` or an `assert`: the first parameter that its message names.
        None => {
            let names = call_at(place).into_iter().flat_map(|call| &call.carried);
            carried = names.flat_map(|(_, names)| names.clone()).collect();
        }
    }
    error.place = Some(place);
    if !is_library(place.0) {
        return;
    }
    let is_thrown = error.argument.is_none();
    for (index, passed) in error.details.calls.iter().enumerate() {
        let call = call_at(passed.place);
        let names: Vec<&String> = carried.iter().filter(|name| call.is_some_and(|c| c.has(name))).collect();
        let name = match names.as_slice() {
            [name] => Some((*name).clone()),
            [name, ..] if is_thrown => Some((*name).clone()),
            _ => None,
        };
        if !is_library(passed.place.0) {
            let argument = name.and_then(|name| Some((call?.argument(&name)?, name)));
            let (at, name) = argument.map_or((passed.place, None), |(at, name)| (at, Some(name)));
            error
                .details
                .notes
                .push((place, format!("raised here, in `{}` of the library", passed.function)));
            error.place = Some(at);
            error.argument = name;
            error.details.calls.drain(..=index);
            return;
        }
        carried = match (call, name) {
            (Some(call), Some(name)) => call.carried(&name).to_vec(),
            (Some(call), None) => carried.iter().flat_map(|name| call.carried(name).to_vec()).collect(),
            (None, _) => Vec::new(),
        };
    }
}

impl CallDescription {
    /// Returns the location of an argument that is written in the call.
    fn argument(&self, name: &str) -> Option<Place> {
        self.arguments.iter().find(|(argument, _)| argument == name).map(|(_, place)| *place)
    }

    /// Returns whether the call provides an argument, explicitly or from variables of the enclosing
    /// function.
    fn has(&self, name: &str) -> bool {
        self.argument(name).is_some() || !self.carried(name).is_empty()
    }

    /// Returns the parameters of the enclosing function that an argument is computed from.
    fn carried(&self, name: &str) -> &[String] {
        self.carried.iter().find(|(argument, _)| argument == name).map_or(&[], |(_, names)| names)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const LIBRARY: u32 = 1;

    fn described(place: Place, arguments: &[(&str, Place)], carried: &[(&str, &[&str])]) -> CallDescription {
        let texts = |all: &[&str]| all.iter().map(|name| name.to_string()).collect();
        CallDescription {
            place,
            arguments: arguments.iter().map(|(name, at)| (name.to_string(), *at)).collect(),
            carried: carried.iter().map(|(name, all)| (name.to_string(), texts(all))).collect(),
            function: String::new(),
        }
    }

    /// `set(cells = 9, more = 8)` calls `inner(n = cells)`, which calls the engine's
    /// `mesh(cells = n)`.
    #[test]
    fn an_error_in_the_library_moves_to_the_argument_that_led_to_it() {
        let user = described((0, 0, 30), &[("cells", (0, 4, 5)), ("more", (0, 8, 9))], &[]);
        let user = CallDescription { function: "gears.set".into(), ..user };
        let outer = described((LIBRARY, 50, 60), &[("n", (LIBRARY, 55, 59))], &[("n", &["cells"])]);
        let inner = described((LIBRARY, 20, 30), &[("cells", (LIBRARY, 25, 26))], &[("cells", &["n"])]);
        let calls = [&user, &outer, &inner];
        let blamed = |argument: Option<&str>, at: Place| {
            let mut error = RuntimeError::new("E0672", "", "");
            error.argument = argument.map(str::to_owned);
            error.place = Some(at);
            error.passed("inner", outer.place);
            error.passed("set", user.place);
            attribute(&mut error, calls.into_iter(), |file| file == LIBRARY);
            error
        };
        let error = blamed(Some("cells"), inner.place);
        assert_eq!((error.place, error.argument.as_deref()), (Some((0, 4, 5)), Some("cells")));
        assert_eq!(
            error.details.notes,
            [((LIBRARY, 25, 26), "raised here, in `set` of the library".to_string())]
        );
        assert!(error.details.calls.is_empty());
        assert_eq!(blamed(Some("cells"), (LIBRARY, 25, 26)), error);
        // The cause is unknown.
        let error = blamed(None, (LIBRARY, 22, 23));
        assert_eq!((error.place, &error.argument), (Some(user.place), &None));
        assert_eq!(cause(&error), "this call of `gears.set` fails");
    }
}
