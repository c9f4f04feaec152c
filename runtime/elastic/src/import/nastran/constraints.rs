//! Constraints and supports: RBE2, RBE3, MPC, MPCADD, SPC, SPC1, SPCADD.
//!
//! Source: NASTRAN Quick Reference Guide, entries of these names.

use super::super::builder::Builder;
use super::super::origin::Problem;
use super::super::source::Place;
use super::card::{Range, Result};
use super::deck::Card;
use super::fields::{integer, real};
use super::systems::repeated;
use crate::model::{Components, Constraint};
use std::collections::{BTreeMap, HashMap};

/// Reads rigid elements.
pub(super) fn rigid(cards: &[Card], builder: &mut Builder, labels: &HashMap<u64, Place>) -> Result<()> {
    let mut own: HashMap<u64, Place> = HashMap::new();
    for card in repeated(cards.iter().filter(|card| matches!(card.name.as_str(), "RBE2" | "RBE3")))? {
        let label = card.id(1, "EID")?;
        if let Some(place) = labels.get(&label).or(own.get(&label)) {
            let message = format!("{} has the label of an element in line {}", card.subject(), place.line);
            return Err(card.problem(message, "give each element its own label"));
        }
        let (name, constraint) = match card.name.as_str() {
            "RBE2" => ("RBE2", rigid_body(card, label, builder)?),
            _ => ("RBE3", weighted_average(card, label, builder)?),
        };
        builder.constraint(card.origin(name), constraint);
        own.insert(label, card.place);
    }
    Ok(())
}

fn rigid_body(card: &Card, label: u64, builder: &Builder) -> Result<Constraint> {
    let owner = format!("element {}", card.subject());
    let reference = builder.node(card.id(2, "GN")?, &owner, card.place)?;
    let components = card.components(3, "CM")?;
    // A real number at the end is the coefficient of thermal expansion.
    let last = card.text(card.len());
    let has_alpha = integer(last).is_none() && real(last).is_some();
    let end = card.len() - usize::from(has_alpha && card.len() > 4);
    let mut dependents = Vec::new();
    for field in (4..=end).filter(|field| !card.is_blank(*field)) {
        let node = builder.node(card.id(field, "GM")?, &owner, card.place)?;
        if node == reference {
            let message = format!("{owner} has its reference GRID {} among its dependents", card.text(2));
            return Err(card.problem(message, "remove the grid point from the list"));
        }
        dependents.push((node, components));
    }
    if dependents.is_empty() {
        return Err(card.problem(format!("{owner} has no dependent grid points"), "list them after CM"));
    }
    Ok(Constraint::Rigid { label, reference, dependents })
}

fn weighted_average(card: &Card, label: u64, builder: &Builder) -> Result<Constraint> {
    let owner = format!("element {}", card.subject());
    let reference = builder.node(card.id(3, "REFGRID")?, &owner, card.place)?;
    let components = card.components(4, "REFC")?;
    let mut terms: Vec<(f64, usize, Components)> = Vec::new();
    let mut group: Option<(f64, Option<Components>)> = None;
    for field in (5..=card.len()).filter(|field| !card.is_blank(*field)) {
        let text = card.text(field);
        // UM only selects the dependent components of the same equations; ALPHA is thermal
        // expansion.
        if matches!(text, "UM" | "ALPHA") {
            break;
        }
        let is_integer = integer(text).is_some();
        match group {
            Some((weight, None)) => group = Some((weight, Some(card.components(field, "C")?))),
            Some((weight, Some(components))) if is_integer => {
                let node = builder.node(card.id(field, "G")?, &owner, card.place)?;
                terms.push((weight, node, components));
            }
            _ => {
                let weight = card.real(field, "WT")?;
                if weight < 0.0 {
                    return Err(
                        card.problem(format!("{owner} has the weight {weight}"), "use positive weights")
                    );
                }
                group = Some((weight, None));
            }
        }
    }
    if !terms.iter().any(|(weight, ..)| *weight > 0.0) {
        let message = format!("{owner} has no grid points with a positive weight");
        return Err(card.problem(message, "write WT, C and the grid points from field 6 on"));
    }
    Ok(Constraint::WeightedAverage { label, reference, components, terms })
}

/// Sets of a kind that are selected.
pub(super) struct Selected {
    pub sets: Vec<u64>,
}

impl Selected {
    /// Resolves a selection. `add` is the card that unites sets, and `cards` are those that define
    /// them. Without case control, the only set of the deck is selected.
    pub fn new(
        cards: &[Card],
        names: &[&str],
        add: &str,
        selection: Option<(u64, Place)>,
        has_case_control: bool,
    ) -> Result<Self> {
        let mut unions: BTreeMap<u64, (Vec<u64>, Place)> = BTreeMap::new();
        for card in repeated(cards.iter().filter(|card| card.name == add))? {
            unions.insert(card.id(1, "SID")?, (card.ids(2, "S")?, card.place));
        }
        let mut defined: BTreeMap<u64, Place> = BTreeMap::new();
        for card in cards.iter().filter(|card| names.contains(&card.name.as_str())) {
            defined.entry(card.id(1, "SID")?).or_insert(card.place);
        }
        let (selected, place) = match selection {
            Some((id, place)) => (Some(id), place),
            None if has_case_control => (None, Place { file: 0, line: 1 }),
            None => match (unions.iter().next(), defined.iter().next()) {
                (Some((id, (_, place))), _) if unions.len() == 1 => (Some(*id), *place),
                (None, Some((id, place))) if defined.len() == 1 => (Some(*id), *place),
                (None, None) => (None, Place { file: 0, line: 1 }),
                _ => {
                    let place = defined.values().nth(1).or_else(|| defined.values().next());
                    let ids: Vec<String> = defined.keys().map(u64::to_string).collect();
                    return Err(Problem::new(
                        place.copied().unwrap_or(Place { file: 0, line: 1 }),
                        format!(
                            "the deck has {} sets {}, and no case control selects one",
                            names[0],
                            ids.join(", ")
                        ),
                        format!("write `CEND`, `{} = n` and `BEGIN BULK` before the bulk data", names[0]),
                    ));
                }
            },
        };
        let sets = match selected {
            None => Vec::new(),
            Some(id) => unions.get(&id).map_or_else(|| vec![id], |(sets, _)| sets.clone()),
        };
        if let Some(missing) = sets.iter().find(|id| !defined.contains_key(id)) {
            return Err(Problem::new(
                place,
                format!("{} set {missing} is selected, but no card defines it", names[0]),
                "correct the number of the set in case control",
            ));
        }
        Ok(Self { sets })
    }
}

/// Reads the selected equations.
pub(super) fn equations(cards: &[Card], selected: &Selected, builder: &mut Builder) -> Result<()> {
    for card in cards.iter().filter(|card| card.name == "MPC") {
        let label = card.id(1, "SID")?;
        if !selected.sets.contains(&label) {
            continue;
        }
        let mut terms = Vec::new();
        for line in 0..=card.len() / 8 {
            for first in [8 * line + 2, 8 * line + 5] {
                if (first..first + 3).all(|field| card.is_blank(field)) {
                    continue;
                }
                let node = builder.node(card.id(first, "G")?, &card.subject(), card.place)?;
                terms.push((node, card.component(first + 1, "C")?, card.real(first + 2, "A")?));
            }
        }
        if terms.first().is_none_or(|term| term.2 == 0.0) {
            let message = format!("{}: the coefficient of the first term is zero", card.subject());
            return Err(card.problem(message, "begin with the dependent component and its coefficient"));
        }
        builder.constraint(card.origin("MPC"), Constraint::Equation { label, terms });
    }
    Ok(())
}

/// Indices of the nodes in a range. A single number must be a grid point; in a range, numbers
/// without one are skipped.
pub(super) fn in_range(card: &Card, range: Range, builder: &Builder) -> Result<Vec<usize>> {
    if range.is_single() {
        return Ok(vec![builder.node(range.from, &card.subject(), card.place)?]);
    }
    let nodes = &builder.model.nodes;
    let all = builder.range(range.from, range.to, card.place)?;
    Ok(all.filter(|at| range.contains(nodes[*at].label)).collect())
}

/// Reads the selected supports.
pub(super) fn supports(cards: &[Card], selected: &Selected, builder: &mut Builder) -> Result<()> {
    for card in cards {
        match card.name.as_str() {
            "SPC" if selected.sets.contains(&card.id(1, "SID")?) => {
                for first in [2, 5] {
                    if first == 5 && card.is_blank(first) {
                        continue;
                    }
                    let node = builder.node(card.id(first, "G")?, &card.subject(), card.place)?;
                    let components = card.components(first + 1, "C")?;
                    let value = card.real_or(first + 2, 0.0, "D")?;
                    builder.fix(card.origin("SPC"), node, &components, value)?;
                }
            }
            "SPC1" if selected.sets.contains(&card.id(1, "SID")?) => {
                let components = card.components(2, "C")?;
                for range in card.ranges(3, "G")? {
                    for node in in_range(card, range, builder)? {
                        builder.fix(card.origin("SPC1"), node, &components, 0.0)?;
                    }
                }
            }
            _ => {}
        }
    }
    Ok(())
}
