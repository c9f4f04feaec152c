//! Vibration in the files that the command line names.

use calyx_runtime::acoustics::nastran_results::{
    FileKind, NastranResults, NastranResultsError, read_op2, read_punch, recognize,
};
use calyx_runtime::acoustics::surface_sound::Vibration;
use calyx_runtime::acoustics::unv;
use calyx_runtime::deck_mesh::deck_mesh;
use calyx_runtime::elastic::import::Unreadable;
use calyx_runtime::error::EngineError;
use std::path::Path;

/// Usage of decks, for remedies.
const USAGE: &str = "`calyx sound housing.bdf --results housing.op2`";
/// How to write results that can be read.
const EXPORT: &str =
    "write an OP2 file with PARAM,POST,-1, or a punch file with DISP(PUNCH)=ALL in case control";

/// File with its content.
#[derive(Clone, Copy)]
pub(super) struct File<'c> {
    pub path: &'c Path,
    pub content: &'c [u8],
}

/// Error of a file.
pub(super) struct Refused {
    pub file: String,
    pub error: EngineError,
}

impl File<'_> {
    fn refused(&self, message: impl Into<String>, help: impl Into<String>) -> Refused {
        Refused { file: self.path.display().to_string(), error: EngineError::new("E0784", message, help) }
    }
}

/// Reads the vibration in a universal file.
pub(super) fn of_universal_file(file: File<'_>) -> Result<Vibration, Refused> {
    match recognize(file.content) {
        FileKind::Deck => {
            return Err(file.refused(
                "the file is a NASTRAN deck, which has no motion",
                format!("add its results, as an OP2 or a punch file: {USAGE}"),
            ));
        }
        FileKind::Op2 | FileKind::Punch => {
            return Err(file.refused(
                "the file has results of NASTRAN without their mesh",
                format!("give the deck of the results as well: {USAGE}"),
            ));
        }
        kind => {
            if let Some(name) = unsupported(kind) {
                let help = format!("{EXPORT}, and give it with the deck: {USAGE}");
                return Err(file.refused(format!("the file is {name}, which is not supported"), help));
            }
        }
    }
    let read = unv::read(file.content)
        .map_err(|error| file.refused(format!("line {}: {}", error.line, error.message), error.help))?;
    Vibration::of_unv(&read).map_err(|error| Refused { file: file.path.display().to_string(), error })
}

/// Reads the vibration of a deck with results; `length` is the unit of length of the deck, m.
pub(super) fn of_deck(deck: File<'_>, results: File<'_>, length: f64) -> Result<Vibration, Refused> {
    match recognize(deck.content) {
        FileKind::Deck | FileKind::Other => {}
        FileKind::Universal => {
            return Err(deck.refused(
                "a universal file has results of its own",
                "leave out `--results`, or give the NASTRAN deck of the results in place of the universal file",
            ));
        }
        _ => {
            let help = format!("give the deck first, and its results with `--results`: {USAGE}");
            return Err(deck.refused("the file is no NASTRAN deck", help));
        }
    }
    let motions = nastran_results(results)?;
    let mut open = |path: &str| {
        std::fs::read(path).map_err(|error| {
            Unreadable::new(error.to_string(), "put the file there, or correct the INCLUDE statement")
        })
    };
    let mesh = deck_mesh(&deck.path.to_string_lossy(), length, &mut open).map_err(|error| {
        let message = format!("line {}: {}", error.line, error.message);
        Refused { file: error.file, error: EngineError::new("E0784", message, error.help) }
    })?;
    if mesh.shells.is_empty() && mesh.solids.is_empty() {
        return Err(deck.refused(
            "the deck has no surface: neither triangles, quadrilaterals nor solid elements",
            "give the deck of the body, with all files that it includes",
        ));
    }
    let name = results.path.display().to_string();
    match Vibration::of_nastran(&mesh, &motions) {
        Ok(mut vibration) => {
            vibration.notes.insert(0, format!("the motion is that of {name}"));
            Ok(vibration)
        }
        Err(error) => Err(Refused { file: name, error }),
    }
}

fn nastran_results(file: File<'_>) -> Result<NastranResults, Refused> {
    let refused =
        |NastranResultsError { place, message, help }| file.refused(format!("{place}: {message}"), help);
    match recognize(file.content) {
        FileKind::Op2 => read_op2(file.content).map_err(refused),
        FileKind::Punch => read_punch(&String::from_utf8_lossy(file.content)).map_err(refused),
        kind => {
            let message = match unsupported(kind) {
                Some(name) => format!("the file is {name}, which is not supported"),
                None => "the file is neither an OP2 nor a punch file of NASTRAN".into(),
            };
            Err(file.refused(message, EXPORT))
        }
    }
}

/// Returns the name of files of results that are not supported.
fn unsupported(kind: FileKind) -> Option<&'static str> {
    Some(match kind {
        FileKind::Printed => "printed output of NASTRAN (F06)",
        FileKind::Hdf5 => "an HDF5 database",
        FileKind::FormattedOp2 => "a formatted OP2 file, which is text",
        _ => return None,
    })
}
