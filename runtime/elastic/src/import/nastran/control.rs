//! Executive and case control, as far as they select sets.
//!
//! Source: NASTRAN Quick Reference Guide, "Case Control Commands": SUBCASE, LOAD, SPC, MPC, TITLE.

use super::super::origin::Problem;
use super::super::source::Place;
use super::deck::keyword;

/// Sets that case control selects.
#[derive(Clone, Debug, Default)]
pub(super) struct Selection {
    pub load: Option<(u64, Place)>,
    pub spc: Option<(u64, Place)>,
    pub mpc: Option<(u64, Place)>,
    pub title: String,
    /// Number of subcases after the one that is read.
    pub other_subcases: usize,
    /// Identification number of the subcase that is read.
    pub subcase: Option<u64>,
}

/// Commands that add matrices of the bulk data to the body.
const MATRICES: [&str; 8] = ["K2GG", "M2GG", "B2GG", "K42GG", "K2PP", "M2PP", "B2PP", "P2G"];

/// Reads the selection of a subcase: the one with this identification number, or the first.
pub(super) fn read(lines: &[(String, Place)], wanted: Option<u64>) -> Result<Selection, Problem> {
    let mut selection = Selection::default();
    // Subcase of the current line: none before the first one.
    let mut current: Option<u64> = None;
    for (line, place) in lines {
        let word = keyword(line);
        let value = || -> Option<u64> {
            let rest = line.split('$').next()?.split_once('=').map(|(_, value)| value);
            let rest = rest.or_else(|| line.split_once([' ', '\t']).map(|(_, value)| value))?;
            rest.split_whitespace().next()?.parse().ok()
        };
        let number = || {
            value().ok_or_else(|| {
                Problem::new(
                    *place,
                    format!("case control: {word} has no identification number"),
                    format!("write `{word} = n` with the number of the set"),
                )
            })
        };
        match word.as_str() {
            "SUBCASE" => {
                let id = number()?;
                current = Some(id);
                let taken = wanted.or(selection.subcase).is_none_or(|wanted| wanted == id);
                match taken {
                    true => selection.subcase = Some(id),
                    false => selection.other_subcases += 1,
                }
            }
            "SUBCOM" | "SYM" | "SYMCOM" | "REPCASE" => {
                return Err(Problem::new(
                    *place,
                    format!("case control: {word} is not supported"),
                    "select the sets in a SUBCASE",
                ));
            }
            "TITLE" if selection.title.is_empty() => {
                selection.title = line.split_once('=').map_or("", |(_, title)| title).trim().to_owned();
            }
            _ if MATRICES.contains(&word.as_str()) => {
                return Err(Problem::new(
                    *place,
                    format!("case control: {word} adds a matrix to the body, which is not supported"),
                    "import the matrices as a condensed body",
                ));
            }
            "LOAD" | "SPC" | "MPC" if current.is_none() || current == selection.subcase => {
                let set = Some((number()?, *place)).filter(|(id, _)| *id > 0);
                match word.as_str() {
                    "LOAD" => selection.load = set,
                    "SPC" => selection.spc = set,
                    _ => selection.mpc = set,
                }
            }
            _ => {}
        }
    }
    if let Some(id) = wanted
        && selection.subcase != Some(id)
    {
        return Err(Problem::new(
            Place { file: 0, line: 1 },
            format!("case control has no SUBCASE {id}"),
            "state the number of a subcase of the deck",
        ));
    }
    Ok(selection)
}
