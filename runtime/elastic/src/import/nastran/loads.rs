//! Loads and sets of grid points: FORCE, MOMENT, LOAD, SET1, ASET, ASET1.
//!
//! Source: NASTRAN Quick Reference Guide, entries of these names.

use super::super::builder::Builder;
use super::super::origin::Problem;
use super::super::source::Place;
use super::card::Result;
use super::constraints::in_range;
use super::deck::Card;
use super::known::LOADS;
use super::systems::{Geometry, repeated};
use std::collections::BTreeMap;

/// Reads the selected loads.
pub(super) fn read(
    cards: &[Card],
    selection: Option<(u64, Place)>,
    has_case_control: bool,
    builder: &mut Builder,
    geometry: &mut Geometry,
) -> Result<()> {
    let is_load = |card: &&Card| {
        matches!(card.name.as_str(), "FORCE" | "MOMENT") || LOADS.contains(&card.name.as_str())
    };
    let mut defined: BTreeMap<u64, Place> = BTreeMap::new();
    for card in cards.iter().filter(is_load) {
        defined.entry(card.id(1, "SID")?).or_insert(card.place);
    }
    let mut combinations: BTreeMap<u64, &Card> = BTreeMap::new();
    for card in repeated(cards.iter().filter(|card| card.name == "LOAD"))? {
        combinations.insert(card.id(1, "SID")?, card);
    }
    let selected = match selection {
        Some(selected) => Some(selected),
        None if has_case_control => None,
        None => match (combinations.len(), defined.len()) {
            (1, _) => combinations.iter().next().map(|(id, card)| (*id, card.place)),
            (0, 1) => defined.iter().next().map(|(id, place)| (*id, *place)),
            (0, 0) => None,
            _ => {
                builder
                    .notes
                    .push("the deck has several load sets and no case control: no load is read".into());
                None
            }
        },
    };
    let Some((id, place)) = selected else {
        return Ok(());
    };
    let factors = match combinations.get(&id) {
        None => vec![(1.0, id)],
        Some(card) => {
            let overall = card.real(2, "S")?;
            let pairs = (3..=card.len()).step_by(2).filter(|field| !card.is_blank(field + 1));
            pairs
                .map(|field| Ok((overall * card.real(field, "S")?, card.id(field + 1, "L")?)))
                .collect::<Result<_>>()?
        }
    };
    if let Some((_, missing)) = factors.iter().find(|(_, set)| !defined.contains_key(set)) {
        return Err(Problem::new(
            place,
            format!("load set {missing} is selected, but no card defines it"),
            "correct the number of the set",
        ));
    }
    for card in cards.iter().filter(is_load) {
        let set = card.id(1, "SID")?;
        let factor: f64 = factors.iter().filter(|(_, id)| *id == set).map(|(factor, _)| factor).sum();
        if factors.iter().any(|(_, id)| *id == set) {
            load(card, factor, builder, geometry)?;
        }
    }
    Ok(())
}

fn load(card: &Card, factor: f64, builder: &mut Builder, geometry: &mut Geometry) -> Result<()> {
    if LOADS.contains(&card.name.as_str()) {
        return Err(card.problem(
            format!("{} is a load that is not supported, and its set is selected", card.subject()),
            "convert the load to FORCE and MOMENT cards, or select another set",
        ));
    }
    let node = builder.node(card.id(2, "G")?, &card.subject(), card.place)?;
    let system = geometry.system(card.system(3, "CID")?, &card.subject(), card.place)?;
    let value = factor * card.real(4, if card.name == "FORCE" { "F" } else { "M" })?;
    let direction = system.vector(card.vector(5, "N1, N2, N3")?, builder.model.nodes[node].position);
    let first = if card.name == "FORCE" { 0 } else { 3 };
    let mut load = [0.0; 6];
    (0..3).for_each(|i| load[first + i] = value * direction[i]);
    if !load.iter().all(|value| value.is_finite()) {
        return Err(card.problem(format!("{}: the load overflows", card.subject()), "correct the load"));
    }
    builder.load(node, load);
    Ok(())
}

/// Reads sets of grid points: `SET1 n` for each SET1 whose members are grid points, and `ASET`.
pub(super) fn sets(cards: &[Card], builder: &mut Builder) -> Result<()> {
    for card in cards {
        let mut members = Vec::new();
        let name = match card.name.as_str() {
            "SET1" => {
                let ranges = card.ranges(2, "ID")?;
                if ranges.iter().any(|range| range.is_single() && builder.find(range.from).is_none()) {
                    builder.notes.push(format!("{} is no set of grid points", card.subject()));
                    continue;
                }
                for range in ranges {
                    members.extend(in_range(card, range, builder)?);
                }
                format!("SET1 {}", card.text(1))
            }
            "ASET1" => {
                for range in card.ranges(2, "ID")? {
                    members.extend(in_range(card, range, builder)?);
                }
                "ASET".to_owned()
            }
            "ASET" => {
                for field in (1..=card.len()).step_by(2).filter(|field| !card.is_blank(*field)) {
                    members.push(builder.node(card.id(field, "ID")?, &card.subject(), card.place)?);
                }
                "ASET".to_owned()
            }
            _ => continue,
        };
        let set = builder.model.sets.entry(name).or_default();
        set.extend(members);
        set.sort_unstable();
        set.dedup();
    }
    Ok(())
}
