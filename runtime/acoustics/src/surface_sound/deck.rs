//! Mesh of a NASTRAN deck with the motion of its grid points.

use super::cases::{CaseKind, Nodes, Skipped, name_single_load, refused};
use super::motions::{NodalMotion, motion_cases};
use super::vibration::Vibration;
use crate::mesh::Face;
use crate::nastran_results::{Analysis, GridVectors, Motion, NastranResults, VectorAxes};
use crate::skin::Solid;
use calyx_numerics::error::EngineError;
use calyx_numerics::vec3::Vector;
use faer::c64;
use std::collections::{BTreeSet, HashMap};

/// Frequency up to which a mode is rigid-body motion, Hz: its eigenvalue is a rounding error, and
/// it has no audible sound.
const RIGID: f64 = 0.1;

/// Largest label of a grid point in a deck. Programs give larger ones to points that they generate
/// for connectors.
const LARGEST_LABEL: i64 = 100_000_000;

/// Grid point of a deck.
#[derive(Clone, Debug, PartialEq)]
pub struct GridPoint {
    /// Label.
    pub label: i64,
    /// Position in basic coordinates, in the unit of length of the deck.
    pub position: Vector,
    /// Unit vectors of its displacement coordinate system.
    pub axes: [Vector; 3],
}

/// Mesh of a deck. Elements have indices of grid points.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DeckMesh {
    /// Grid points.
    pub points: Vec<GridPoint>,
    /// Solid elements.
    pub solids: Vec<Solid>,
    /// Surface elements.
    pub shells: Vec<Face>,
    /// Unit of length of the deck, m.
    pub length: f64,
    /// How the deck was read, in sentences.
    pub notes: Vec<String>,
}

impl Vibration {
    /// Joins the mesh of a NASTRAN deck with the motion of its grid points: displacements,
    /// velocities or accelerations of frequency responses, or normal modes. Those along the
    /// displacement coordinate systems of the grid points are converted to the basic system. If a
    /// case has several quantities, the velocity is used, or else the displacement.
    ///
    /// # Errors
    /// E0784: the deck has no elements, an element has a grid point that does not exist, there are
    /// no motions, or they have an unknown or repeated grid point, a frequency that is not positive
    /// or a value that is not finite.
    pub fn of_nastran(mesh: &DeckMesh, results: &NastranResults) -> Result<Vibration, EngineError> {
        if !(mesh.length > 0.0 && mesh.length.is_finite()) {
            return Err(refused(
                format!("the unit of length of the deck is {} m", mesh.length),
                "give a positive unit of length",
            ));
        }
        let Used { points, solids, shells } = Used::of(mesh)?;
        let by_label: HashMap<i64, &GridPoint> =
            mesh.points.iter().map(|point| (point.label, point)).collect();
        let positions = mesh.points.iter().map(|point| (point.label, point.position)).collect();
        let index = points.iter().enumerate().map(|(index, point)| (point.label, index)).collect();
        let nodes = Nodes {
            positions: &positions,
            index: &index,
            factor: mesh.length.recip(),
            owner: "deck",
            help: "give the deck of these results, with all files that it includes",
        };
        let mut skipped = Skipped::default();
        results.skipped.iter().for_each(|(reason, count)| skipped.add_many(reason.as_str(), *count));
        let is_generated = |label: i64| label > LARGEST_LABEL && !by_label.contains_key(&label);
        let mut motions = Vec::new();
        for vectors in &results.vectors {
            if let Some(reason) = still(vectors)? {
                skipped.add(reason);
                continue;
            }
            motions.push(NodalMotion {
                place: vectors.place.clone(),
                kind: match vectors.analysis {
                    Analysis::Mode(number) => CaseKind::Mode(number),
                    Analysis::Response => CaseKind::Response(vectors.subcase.to_string()),
                },
                frequency: vectors.frequency,
                quantity: match vectors.motion {
                    Motion::Displacement => 8,
                    Motion::Velocity => 11,
                    Motion::Acceleration => 12,
                },
                values: Box::new(|| {
                    let mut values = in_basic_axes(vectors, &by_label);
                    values.retain(|(label, _)| !is_generated(*label));
                    values
                }),
            });
            let generated = vectors.values.iter().filter(|(label, _)| is_generated(*label)).count();
            if generated > 0 {
                skipped.add_many("values of generated grid points", generated);
            }
        }
        let mut cases = motion_cases(motions, &nodes, &mut skipped)?;
        if cases.is_empty() {
            let found = skipped.text().map_or(String::new(), |text| format!("; skipped: {text}"));
            return Err(refused(
                format!("the results have no motion of a frequency response or of normal modes{found}"),
                "request DISPLACEMENT = ALL, or VELOCITY, of a frequency response (SOL 108, 111) or of normal modes (SOL 103)",
            ));
        }
        let mut notes = vec![match mesh.length {
            1.0 => "lengths and motions of the deck are in m".into(),
            length => format!("lengths and motions of the deck are multiplied by {length} to be in m"),
        }];
        notes.extend(mesh.notes.iter().cloned());
        notes.extend(skipped.text().map(|text| format!("skipped: {text}")));
        if !results.is_complete {
            notes.push("the results have no end mark: the last tables may be missing".into());
        }
        name_single_load(&mut cases);
        Ok(Vibration {
            labels: points.iter().map(|point| point.label).collect(),
            nodes: points.iter().map(|point| point.position.map(|x| x * mesh.length)).collect(),
            solids,
            shells,
            cases,
            notes,
            warnings: Vec::new(),
        })
    }
}

/// Elements with indices of the grid points that they have.
struct Used<'d> {
    points: Vec<&'d GridPoint>,
    solids: Vec<Solid>,
    shells: Vec<Face>,
}

impl<'d> Used<'d> {
    fn of(mesh: &'d DeckMesh) -> Result<Self, EngineError> {
        if mesh.solids.is_empty() && mesh.shells.is_empty() {
            return Err(refused(
                "the deck has no surface: neither triangles, quadrilaterals nor solid elements",
                "give the deck of the body, with all files that it includes",
            ));
        }
        let solids = mesh.solids.iter().flat_map(|solid| match solid {
            Solid::Tetrahedron(nodes) => nodes.to_vec(),
            Solid::Wedge(nodes) => nodes.to_vec(),
            Solid::Hexahedron(nodes) => nodes.to_vec(),
        });
        let shells = mesh.shells.iter().flat_map(|shell| match shell {
            Face::Triangle(nodes) => nodes.to_vec(),
            Face::Quadrilateral(nodes) => nodes.to_vec(),
        });
        let used: BTreeSet<usize> = solids.chain(shells).collect();
        if let Some(missing) = used.iter().find(|node| **node >= mesh.points.len()) {
            return Err(refused(
                format!("an element has the grid point of the index {missing}, which does not exist"),
                "correct the elements",
            ));
        }
        // In the order of their labels, as for other files.
        let mut used: Vec<usize> = used.into_iter().collect();
        used.sort_by_key(|node| mesh.points[*node].label);
        let mut new = vec![0; mesh.points.len()];
        used.iter().enumerate().for_each(|(index, node)| new[*node] = index);
        let solids = mesh.solids.iter().map(|solid| match solid {
            Solid::Tetrahedron(nodes) => Solid::Tetrahedron(nodes.map(|node| new[node])),
            Solid::Wedge(nodes) => Solid::Wedge(nodes.map(|node| new[node])),
            Solid::Hexahedron(nodes) => Solid::Hexahedron(nodes.map(|node| new[node])),
        });
        let shells = mesh.shells.iter().map(|shell| match shell {
            Face::Triangle(nodes) => Face::Triangle(nodes.map(|node| new[node])),
            Face::Quadrilateral(nodes) => Face::Quadrilateral(nodes.map(|node| new[node])),
        });
        Ok(Used {
            points: used.into_iter().map(|node| &mesh.points[node]).collect(),
            solids: solids.collect(),
            shells: shells.collect(),
        })
    }
}

/// Returns why vectors have no sound; `None` if they have.
///
/// # Errors
/// E0784: the frequency is negative or not finite.
fn still(vectors: &GridVectors) -> Result<Option<String>, EngineError> {
    let GridVectors { place, frequency, analysis, .. } = vectors;
    match analysis {
        Analysis::Mode(_) if (0.0..RIGID).contains(frequency) => Ok(Some(format!("mode below {RIGID} Hz"))),
        Analysis::Response if *frequency == 0.0 => Ok(Some("response at 0 Hz".into())),
        _ if *frequency > 0.0 && frequency.is_finite() => Ok(None),
        _ => Err(refused(
            format!("{place}: the frequency of the results is {frequency} Hz"),
            "export results at frequencies above zero",
        )),
    }
}

/// Returns vectors along the axes of the basic coordinate system.
fn in_basic_axes(vectors: &GridVectors, points: &HashMap<i64, &GridPoint>) -> Vec<(i64, [c64; 3])> {
    let converted = |(label, value): &(i64, [c64; 3])| match (vectors.axes, points.get(label)) {
        (VectorAxes::Displacement, Some(GridPoint { axes, .. })) => {
            let component = |k: usize| (0..3).fold(c64::new(0.0, 0.0), |sum, i| sum + value[i] * axes[i][k]);
            (*label, [0, 1, 2].map(component))
        }
        _ => (*label, *value),
    };
    vectors.values.iter().map(converted).collect()
}
