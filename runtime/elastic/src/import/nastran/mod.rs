//! Reader of NASTRAN bulk data.
//!
//! Source: NASTRAN Quick Reference Guide: "Executive Control Statements", "Case Control Commands",
//! "Format of Bulk Data Entries", and the bulk data entries that `known` lists.
//!
//! Deviations: a continuation must follow its card or be named by it in field 10; integers are
//! valid where the guide requires real numbers; blanks are no separators of free-field format.

mod beam_properties;
mod card;
mod constraints;
mod control;
mod deck;
mod elements;
mod fields;
mod known;
mod loads;
mod mesh;
mod pbeam;
mod properties;
mod systems;

pub(super) use deck::Card;

use super::builder::Builder;
use super::error::ImportError;
use super::origin::Problem;
use super::source::{OpenFile, Place, Sources};
use super::{Import, NastranMesh, Units};
use constraints::Selected;
use known::{HARMLESS, LOADS, READ, SCALING_PARAMETERS, remedy};
use properties::Properties;
use std::collections::HashMap;
use systems::Geometry;

/// Arguments of [`read_nastran`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NastranOptions {
    /// Units of the deck.
    pub units: Units,
    /// Subcase that selects constraints and loads; `None` for the first.
    pub subcase: Option<u64>,
}

/// Reads a body from NASTRAN bulk data.
///
/// # Errors
/// The deck is not valid, or has a card that changes the body and is not supported.
pub fn read_nastran(
    path: &str,
    options: &NastranOptions,
    open: &mut OpenFile,
) -> Result<Import, ImportError> {
    let mut sources = Sources::new(open);
    let deck = deck::read(path, &mut sources)?;
    let files = sources.names;
    if !options.units.is_valid() {
        let place = Place { file: 0, line: 1 };
        return Err(Problem::new(place, "the units are not positive", "state positive units").located(&files));
    }
    let (builder, mass_factor) = build(&deck, options).map_err(|problem| problem.located(&files))?;
    builder.finish(&files, &options.units, mass_factor)
}

/// Reads the mesh of NASTRAN bulk data, for results on it: grid points with their displacement
/// coordinate systems, and the corners of shell and solid elements. The deck may have any cards.
/// Elements of fluids are left out.
///
/// Lengths stay in the unit of the deck.
///
/// # Errors
/// A grid point, coordinate system or element is not valid, or the deck has pyramids or
/// superelements.
pub fn read_nastran_mesh(path: &str, open: &mut OpenFile) -> Result<NastranMesh, ImportError> {
    mesh::read(path, open)
}

/// Cards of a file of matrices, for condensed bodies.
pub(super) fn cards(path: &str, sources: &mut Sources) -> Result<Vec<Card>, ImportError> {
    deck::read(path, sources).map(|deck| deck.cards)
}

/// Positions of the grid points of a file of matrices. Matrices in other displacement systems than
/// the basic one are rejected.
pub(super) fn positions(cards: &[Card]) -> Result<HashMap<u64, [f64; 3]>, Problem> {
    let basic = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let nodes = Geometry::read(cards)?.nodes()?;
    for card in cards.iter().filter(|card| card.name == "GRID") {
        let id = card.id(1, "ID")?;
        let at = nodes.binary_search_by_key(&id, |node| node.label);
        if at.is_ok_and(|at| nodes[at].axes != basic) {
            let message =
                format!("GRID {id} has a displacement system (CD), which is not supported for matrices");
            return Err(card.problem(message, "export the matrices in basic coordinates"));
        }
    }
    Ok(nodes.into_iter().map(|node| (node.label, node.position)).collect())
}

/// Converts the cards of a deck. Returns the model and the value of PARAM,WTMASS.
fn build(deck: &deck::Deck, options: &NastranOptions) -> Result<(Builder, f64), Problem> {
    let cards = &deck.cards;
    let selection = control::read(&deck.control, options.subcase)?;
    check_names(cards)?;
    let mass_factor = mass_factor(cards)?;
    let mut geometry = Geometry::read(cards)?;
    let mut builder = Builder::new(geometry.nodes()?, "GRID");
    builder.title.clone_from(&selection.title);
    let mut properties = Properties::read(cards)?;
    builder.notes.append(&mut properties.notes);
    elements::read(cards, &mut builder, &properties, &mut geometry)?;
    builder.model.materials = properties.materials;
    let labels: HashMap<u64, Place> = cards
        .iter()
        .filter(|card| elements::NAMES.contains(&card.name.as_str()) && card.name != "CONM2")
        .filter_map(|card| Some((card.text(1).parse().ok()?, card.place)))
        .collect();
    constraints::rigid(cards, &mut builder, &labels)?;
    let case_control = deck.has_case_control;
    let equations = Selected::new(cards, &["MPC"], "MPCADD", selection.mpc, case_control)?;
    constraints::equations(cards, &equations, &mut builder)?;
    let supports = Selected::new(cards, &["SPC", "SPC1"], "SPCADD", selection.spc, case_control)?;
    constraints::supports(cards, &supports, &mut builder)?;
    for (label, components, place) in std::mem::take(&mut geometry.fixed) {
        let node = builder.node(label, "GRID", place)?;
        builder.fix(super::origin::Origin { name: "GRID", place }, node, &components, 0.0)?;
    }
    loads::read(cards, selection.load, case_control, &mut builder, &mut geometry)?;
    loads::sets(cards, &mut builder)?;
    if selection.other_subcases > 0 {
        let read = selection.subcase.map_or_else(String::new, |id| format!(" {id}"));
        builder
            .notes
            .push(format!("only subcase{read} is read; {} others are not", selection.other_subcases));
    }
    report_skipped(cards, &equations, &supports, &mut builder);
    Ok((builder, mass_factor))
}

/// Rejects cards that change the body and are not supported.
fn check_names(cards: &[Card]) -> Result<(), Problem> {
    for card in cards {
        let name = card.name.as_str();
        if ![READ, HARMLESS, LOADS].iter().any(|names| names.contains(&name)) {
            let message = format!("card {} is not supported", card.subject());
            return Err(card.problem(message, remedy(name)));
        }
    }
    Ok(())
}

/// Value of PARAM,WTMASS; rejects parameters that scale the body.
fn mass_factor(cards: &[Card]) -> Result<f64, Problem> {
    let mut factor = 1.0;
    for card in cards.iter().filter(|card| card.name == "PARAM") {
        match card.text(1) {
            "WTMASS" => factor = card.positive(2, "V1")?,
            name if SCALING_PARAMETERS.contains(&name) && card.real(2, "V1")? != 1.0 => {
                let message =
                    format!("{} scales matrices of the body, which is not supported", card.subject());
                return Err(card.problem(message, "scale the materials or the properties instead"));
            }
            _ => {}
        }
    }
    Ok(factor)
}

/// Lists the input that was skipped.
fn report_skipped(cards: &[Card], equations: &Selected, supports: &Selected, builder: &mut Builder) {
    for card in cards {
        let set = card.text(1).parse().unwrap_or(0);
        let name = match card.name.as_str() {
            "PARAM" if card.text(1) != "WTMASS" => card.subject(),
            "ASET" | "ASET1" => continue,
            name if HARMLESS.contains(&name) || LOADS.contains(&name) => name.to_owned(),
            "MPC" if !equations.sets.contains(&set) => card.subject(),
            "SPC" | "SPC1" if !supports.sets.contains(&set) => card.subject(),
            _ => continue,
        };
        builder.skipped.add(&name, card.place);
    }
}
