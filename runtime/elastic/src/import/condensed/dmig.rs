//! Direct matrix input at grid points (DMIG), as NASTRAN writes it to the punch file.
//!
//! Source: NASTRAN Quick Reference Guide, entry DMIG. Positions come from GRID entries in the file.

use super::super::error::ImportError;
use super::super::nastran::{self, Card};
use super::super::origin::Problem;
use super::super::source::{Place, Sources};
use super::{CondensedNode, CondensedOptions, Dof, Entries, Parts, Result, assemble, entry_name};
use std::collections::{BTreeMap, BTreeSet};

/// Reads a condensed body from DMIG entries.
pub(super) fn read(
    path: &str,
    options: &CondensedOptions,
    sources: &mut Sources,
) -> std::result::Result<Parts, ImportError> {
    let cards = nastran::cards(path, sources)?;
    convert(&cards, options).map_err(|problem| problem.located(&sources.names))
}

/// Name of a matrix: the stated one, or the only one with an initial.
fn name<'c>(cards: &[&'c Card], stated: Option<&str>, initial: char, what: &str) -> Result<Option<&'c str>> {
    let names: BTreeSet<&str> = cards.iter().map(|card| card.text(1)).collect();
    let start = Place { file: 0, line: 1 };
    if let Some(stated) = stated {
        return names.get(stated.to_ascii_uppercase().as_str()).map(|name| Some(*name)).ok_or_else(|| {
            let known = names.iter().copied().collect::<Vec<_>>().join(", ");
            Problem::new(start, format!("no DMIG is called `{stated}`"), format!("use one of: {known}"))
        });
    }
    let fitting: Vec<&str> = names.into_iter().filter(|name| name.starts_with(initial)).collect();
    match fitting[..] {
        [] => Ok(None),
        [name] => Ok(Some(name)),
        _ => Err(Problem::new(
            start,
            format!("several DMIG may be the {what}: {}", fitting.join(", ")),
            format!("state the name of the {what} matrix"),
        )),
    }
}

fn convert(cards: &[Card], options: &CondensedOptions) -> Result<Parts> {
    let matrices: Vec<&Card> = cards.iter().filter(|card| card.name == "DMIG").collect();
    let positions = nastran::positions(cards)?;
    let start = Place { file: 0, line: 1 };
    let Some(stiffness_name) = name(&matrices, options.stiffness.as_deref(), 'K', "stiffness")? else {
        return Err(Problem::new(start, "the file has no stiffness matrix", "state the name of its DMIG"));
    };
    let mass_name = name(&matrices, options.mass.as_deref(), 'M', "mass")?;
    // Grid points of the matrices in ascending order.
    let mut labels: BTreeMap<u64, usize> = BTreeMap::new();
    for card in
        matrices.iter().filter(|card| Some(card.text(1)) == mass_name || card.text(1) == stiffness_name)
    {
        for (grid, ..) in terms(card)?.iter().chain(&column(card)?) {
            labels.insert(*grid, 0);
        }
    }
    labels.values_mut().enumerate().for_each(|(at, index)| *index = at);
    let stiffness = entries(&matrices, stiffness_name, &labels)?;
    let mass = mass_name.map(|name| entries(&matrices, name, &labels)).transpose()?;
    let nodes = labels
        .keys()
        .map(|label| CondensedNode { label: label.to_string(), position: positions.get(label).copied() });
    assemble(nodes.collect(), &stiffness, mass.as_ref())
}

/// True for the card that states the form of a matrix.
fn is_header(card: &Card) -> bool {
    card.text(2) == "0"
}

/// Grid point, component and value; the value of a column is one.
type Term = (u64, usize, f64);

/// Column of a card.
fn column(card: &Card) -> Result<Vec<Term>> {
    if is_header(card) {
        Ok(Vec::new())
    } else {
        Ok(vec![(card.id(2, "GJ")?, card.component(3, "CJ")?, 1.0)])
    }
}

/// Terms of a card.
fn terms(card: &Card) -> Result<Vec<Term>> {
    let mut terms = Vec::new();
    if is_header(card) {
        return Ok(terms);
    }
    for first in (5..=card.len()).step_by(4).filter(|first| !card.is_blank(*first)) {
        card.unsupported([first + 3], "an imaginary part")?;
        terms.push((card.id(first, "G")?, card.component(first + 1, "C")?, card.real(first + 2, "A")?));
    }
    Ok(terms)
}

fn entries(cards: &[&Card], name: &str, labels: &BTreeMap<u64, usize>) -> Result<Entries> {
    let mut entries = Entries::default();
    let dof = |term: &Term| -> Dof { (labels[&term.0], term.1) };
    for card in cards.iter().filter(|card| card.text(1) == name) {
        if is_header(card) {
            match card.optional_integer(3, "IFO")? {
                Some(6) => entries.is_triangle = true,
                Some(1) => {}
                _ => {
                    let message =
                        format!("{}: the form of the matrix is not square or symmetric", card.subject());
                    return Err(card.problem(message, "export a symmetric matrix (IFO = 6)"));
                }
            }
            if !matches!(card.optional_integer(4, "TIN")?, Some(1 | 2)) {
                let message = format!("{}: the matrix is not real (TIN)", card.subject());
                return Err(card.problem(message, "export the real matrix"));
            }
            continue;
        }
        for column in column(card)? {
            for term in terms(card)? {
                let label = |term: &Term| term.0.to_string();
                let named = || entry_name(name, (&label(&term), term.1), (&label(&column), column.1));
                entries.add(named, (dof(&term), dof(&column)), term.2, card.place)?;
            }
        }
    }
    Ok(entries)
}
