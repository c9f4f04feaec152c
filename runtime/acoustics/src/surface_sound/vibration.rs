//! Mesh of a vibrating body and the motion of its nodes, from a universal file.

use super::cases::{CaseKind, Nodes, QUANTITIES, Skipped, VibrationCase, name_single_load, refused};
use super::functions::function_cases;
use super::motions::{NodalMotion, motion_cases};
use crate::mesh::Face;
use crate::skin::Solid;
use crate::unv::{Element, Entity, LocatedValues, ResultKind, UnvDataset, UnvFile};
use calyx_numerics::error::EngineError;
use calyx_numerics::vec3::Vector;
use std::collections::{BTreeSet, HashMap};

/// Analysis types of results.
const MODES: i64 = 2;
const RESPONSE: i64 = 5;

/// Mesh of a body and the motion of its nodes.
#[derive(Clone, Debug, PartialEq)]
pub struct Vibration {
    /// Labels of the nodes in the file.
    pub labels: Vec<i64>,
    /// Positions of the nodes, m.
    pub nodes: Vec<Vector>,
    /// Solid elements.
    pub solids: Vec<Solid>,
    /// Surface elements.
    pub shells: Vec<Face>,
    /// Motions by kind and frequency.
    pub cases: Vec<VibrationCase>,
    /// How the file was read, in sentences.
    pub notes: Vec<String>,
    /// Warnings about values of the file whose meaning is not certain.
    pub warnings: Vec<String>,
}

impl Vibration {
    /// Reads the mesh and the motion of its nodes from a universal file: triangles, quadrilaterals,
    /// tetrahedra, wedges and hexahedra (2411, 2412), and displacements, velocities or
    /// accelerations of a frequency response or of normal modes (55, 2414), or functions of a
    /// frequency response (58). Midside nodes are left out. If a case has several quantities, the
    /// velocity is used, or else the displacement.
    ///
    /// # Errors
    /// E0784: an element has a node that is missing or has two positions, there are no elements or
    /// no results, or results have an unknown node, a wrong frequency or a value that is not
    /// finite.
    pub fn of_unv(file: &UnvFile) -> Result<Vibration, EngineError> {
        let factor = file.length_factor();
        let positions = positions(file)?;
        let mut skipped = Skipped::default();
        let elements = Elements::of(file, &positions, &mut skipped)?;
        let index: HashMap<i64, usize> =
            elements.labels.iter().enumerate().map(|(index, label)| (*label, index)).collect();
        let read = Nodes {
            positions: &positions,
            index: &index,
            factor,
            owner: "file",
            help: "export the nodes (dataset 2411) of all results",
        };
        let mut cases = result_cases(file, &read, &mut skipped)?;
        match cases.is_empty() {
            true => cases = function_cases(file, &read, &mut skipped)?,
            false => {
                let is_function = |dataset: &&UnvDataset| matches!(dataset, UnvDataset::Function(_));
                (0..file.datasets.iter().filter(is_function).count())
                    .for_each(|_| skipped.add("function (dataset 58) next to other results"));
            }
        }
        file.skipped.iter().for_each(|other| skipped.add(format!("dataset {}", other.number)));
        if cases.is_empty() {
            let found = skipped.text().map_or(String::new(), |text| format!("; skipped: {text}"));
            return Err(refused(
                format!("the file has no motion of nodes of a frequency response or of normal modes{found}"),
                "export displacements, velocities or accelerations of nodes as dataset 55 or 2414, analysis type 5 or 2",
            ));
        }
        let is_known = file.datasets.iter().any(|dataset| matches!(dataset, UnvDataset::Units(_)));
        let mut notes = vec![match is_known {
            true if factor == 1.0 => "the units of the file are SI".into(),
            true => format!("lengths and motions of the file are divided by {factor} to be in m"),
            false => "the file has no units (dataset 164): lengths and motions are taken as m".into(),
        }];
        notes.extend(skipped.text().map(|text| format!("skipped: {text}")));
        let warnings = coordinate_systems(file, &index).into_iter().collect();
        let nodes = elements.labels.iter().map(|label| positions[label].map(|x| x / factor)).collect();
        name_single_load(&mut cases);
        let Elements { labels, solids, shells } = elements;
        Ok(Vibration { labels, nodes, solids, shells, cases, notes, warnings })
    }
}

/// Positions of all nodes in the units of the file.
fn positions(file: &UnvFile) -> Result<HashMap<i64, Vector>, EngineError> {
    let mut positions: HashMap<i64, Vector> = HashMap::new();
    for (index, dataset) in file.datasets.iter().enumerate() {
        let UnvDataset::Nodes(nodes) = dataset else { continue };
        for node in nodes {
            let other = positions.insert(node.label, node.position);
            if other.is_some_and(|other| other != node.position) {
                return Err(refused(
                    format!("{}: the file has two positions for the node {}", file.place(index), node.label),
                    "remove one of the nodes",
                ));
            }
        }
    }
    Ok(positions)
}

/// Returns a warning if the motions of nodes may be in coordinate systems of their own.
fn coordinate_systems(file: &UnvFile, index: &HashMap<i64, usize>) -> Option<String> {
    let mut all: BTreeSet<i64> = BTreeSet::new();
    for dataset in &file.datasets {
        let UnvDataset::Nodes(nodes) = dataset else { continue };
        let own = nodes.iter().filter(|node| index.contains_key(&node.label));
        all.extend(own.map(|node| node.attributes[1]));
    }
    // Programs without local systems write 0 or 1 for all nodes.
    let is_local = all.len() > 1 || all.iter().any(|system| !(0..=1).contains(system));
    is_local.then(|| {
        let all: Vec<String> = all.iter().map(i64::to_string).collect();
        format!(
            "nodes have the displacement coordinate systems {}; all motions are taken along global axes. Export results along global axes if they are not",
            all.join(", ")
        )
    })
}

/// Elements with the indices of their nodes.
struct Elements {
    labels: Vec<i64>,
    solids: Vec<Solid>,
    shells: Vec<Face>,
}

/// Returns the places of the corners among the nodes of an element; `None` for other elements.
fn corners(descriptor: i64) -> Option<&'static [usize]> {
    Some(match descriptor {
        41 | 91 => &[0, 1, 2],
        44 | 94 => &[0, 1, 2, 3],
        42 | 92 => &[0, 2, 4],
        45 | 95 => &[0, 2, 4, 6],
        111 => &[0, 1, 2, 3],
        112 => &[0, 1, 2, 3, 4, 5],
        115 => &[0, 1, 2, 3, 4, 5, 6, 7],
        118 => &[0, 2, 4, 9],
        113 => &[0, 2, 4, 9, 11, 13],
        116 => &[0, 2, 4, 6, 12, 14, 16, 18],
        _ => return None,
    })
}

impl Elements {
    fn of(
        file: &UnvFile,
        positions: &HashMap<i64, Vector>,
        skipped: &mut Skipped,
    ) -> Result<Elements, EngineError> {
        let mut found: Vec<(bool, Vec<i64>)> = Vec::new();
        for (at, dataset) in file.datasets.iter().enumerate() {
            let UnvDataset::Elements(elements) = dataset else { continue };
            for element in elements {
                let Some(corners) = corners(element.descriptor) else {
                    skipped.add(format!("element with the descriptor {}", element.descriptor));
                    continue;
                };
                found.push(checked(element, corners, positions, &file.place(at))?);
            }
        }
        if found.is_empty() {
            return Err(refused(
                "the file has no surface: neither triangles, quadrilaterals nor solid elements (dataset 2412)",
                "export the mesh of the body, or its skin as shell elements, with the results",
            ));
        }
        let labels: BTreeSet<i64> = found.iter().flat_map(|(_, nodes)| nodes.iter().copied()).collect();
        let labels: Vec<i64> = labels.into_iter().collect();
        let index = |label: &i64| labels.binary_search(label).unwrap_or_default();
        let (mut solids, mut shells) = (Vec::new(), Vec::new());
        for (is_solid, nodes) in &found {
            let own: Vec<usize> = nodes.iter().map(index).collect();
            match (is_solid, own.as_slice()) {
                (false, &[a, b, c]) => shells.push(Face::Triangle([a, b, c])),
                (false, &[a, b, c, d]) => shells.push(Face::Quadrilateral([a, b, c, d])),
                (true, &[a, b, c, d]) => solids.push(Solid::Tetrahedron([a, b, c, d])),
                (true, &[a, b, c, d, e, f]) => solids.push(Solid::Wedge([a, b, c, d, e, f])),
                (true, &[a, b, c, d, e, f, g, h]) => solids.push(Solid::Hexahedron([a, b, c, d, e, f, g, h])),
                _ => {}
            }
        }
        Ok(Elements { labels, solids, shells })
    }
}

/// Returns whether an element is a solid, and the labels of its corners.
fn checked(
    element: &Element,
    corners: &[usize],
    positions: &HashMap<i64, Vector>,
    place: &str,
) -> Result<(bool, Vec<i64>), EngineError> {
    let label = element.label;
    let missing = |corner: usize| {
        refused(
            format!(
                "{place}: the element {label} has {} nodes, and the descriptor {} has more than {corner}",
                element.nodes.len(),
                element.descriptor
            ),
            "correct the element, or export the file again",
        )
    };
    let node = |&corner: &usize| element.nodes.get(corner).copied().ok_or_else(|| missing(corner));
    let nodes: Vec<i64> = corners.iter().map(node).collect::<Result<_, _>>()?;
    // Some programs write triangles as quadrilaterals with two equal nodes.
    let mut distinct = nodes.clone();
    distinct.dedup();
    if distinct.len() > 1 && distinct.first() == distinct.last() {
        distinct.pop();
    }
    let is_solid = element.descriptor > 100;
    let is_triangle = !is_solid && nodes.len() == 4 && distinct.len() == 3;
    let nodes = if is_triangle { distinct } else { nodes };
    if let Some(twice) =
        nodes.iter().enumerate().find_map(|(k, node)| nodes[..k].contains(node).then_some(node))
    {
        return Err(refused(
            format!("{place}: the element {label} has the node {twice} twice"),
            "correct the element, or leave it out",
        ));
    }
    match nodes.iter().find(|node| !positions.contains_key(node)) {
        Some(node) => Err(refused(
            format!("{place}: the node {node} of the element {label} is not in the file"),
            "export the nodes (dataset 2411) with the elements",
        )),
        None => Ok((is_solid, nodes)),
    }
}

/// Results of a dataset 55 or 2414.
struct Results<'f> {
    kind: ResultKind,
    load: String,
    mode: i64,
    frequency: Option<f64>,
    values: &'f [LocatedValues],
}

/// Returns the motions of all datasets 55 and 2414, one of each case and frequency.
fn result_cases(
    file: &UnvFile,
    nodes: &Nodes<'_>,
    skipped: &mut Skipped,
) -> Result<Vec<VibrationCase>, EngineError> {
    let mut motions = Vec::new();
    for (at, dataset) in file.datasets.iter().enumerate() {
        let Some(results) = results(dataset, skipped) else { continue };
        let place = file.place(at);
        let Some(frequency) = frequency(&results, &place, skipped)? else { continue };
        let kind = match results.kind.analysis {
            MODES => CaseKind::Mode(results.mode),
            _ => CaseKind::Response(results.load),
        };
        let translations = |own: &LocatedValues| (own.label, [own.values[0], own.values[1], own.values[2]]);
        motions.push(NodalMotion {
            place,
            kind,
            frequency,
            quantity: results.kind.quantity,
            values: Box::new(move || results.values.iter().map(translations).collect()),
        });
    }
    motion_cases(motions, nodes, skipped)
}

/// Returns the motion of a dataset; `None` for others, which are skipped with a reason.
fn results<'f>(dataset: &'f UnvDataset, skipped: &mut Skipped) -> Option<Results<'f>> {
    let integer = |all: &[i64], at: usize| all.get(at).copied().unwrap_or(0);
    let results = match dataset {
        UnvDataset::NodalData(data) => Results {
            kind: data.kind,
            load: integer(&data.integers, 0).to_string(),
            mode: integer(&data.integers, 1),
            frequency: data.reals.first().copied(),
            values: &data.values,
        },
        UnvDataset::AnalysisData(data) if data.entity == Entity::Elements => {
            skipped.add("results at elements");
            return None;
        }
        UnvDataset::AnalysisData(data) => Results {
            kind: data.kind,
            load: match (integer(&data.integers, 2), integer(&data.integers, 4)) {
                (0, load) => load.to_string(),
                (solution, load) => format!("{solution}/{load}"),
            },
            mode: integer(&data.integers, 5),
            frequency: data.reals.get(1).copied(),
            values: &data.values,
        },
        _ => return None,
    };
    let ResultKind { analysis, quantity, .. } = results.kind;
    if ![MODES, RESPONSE].contains(&analysis) {
        skipped.add(format!("results of the analysis type {analysis}"));
        return None;
    }
    if !QUANTITIES.contains(&quantity) {
        skipped.add(match quantity {
            15 => "results of pressure".into(),
            _ => format!("results of the quantity {quantity}, which is no motion"),
        });
        return None;
    }
    if results.values.is_empty() || results.values.iter().any(|own| own.values.len() < 3) {
        skipped.add("results with fewer than three components");
        return None;
    }
    Some(results)
}

/// Returns the frequency of results, Hz; `None` for rigid-body modes, which are skipped.
fn frequency(results: &Results<'_>, place: &str, skipped: &mut Skipped) -> Result<Option<f64>, EngineError> {
    let is_mode = results.kind.analysis == MODES;
    match results.frequency {
        Some(frequency) if frequency > 0.0 && frequency.is_finite() => Ok(Some(frequency)),
        Some(0.0) if is_mode => {
            skipped.add("mode at 0 Hz");
            Ok(None)
        }
        Some(frequency) => Err(refused(
            format!("{place}: the frequency of the results is {frequency} Hz"),
            "export results at frequencies above zero",
        )),
        None => Err(refused(
            format!("{place}: the results have no frequency"),
            "export the results with their frequency, in Hz",
        )),
    }
}
