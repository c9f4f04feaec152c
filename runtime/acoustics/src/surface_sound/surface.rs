//! Closed surface of a vibrating body, from its shells or the skin of its solids.

use super::cases::{VibrationCase, refused};
use super::vibration::Vibration;
use crate::error::AcousticError;
use crate::plane::RigidPlane;
use crate::shells::{ShellProblem, ShellSkin};
use crate::skin::Skin;
use calyx_numerics::error::EngineError;
use calyx_numerics::vec3::Vector;
use faer::c64;
use std::collections::BTreeSet;

/// Largest number of openings that a message names.
const NAMED: usize = 4;

/// Closed surface.
pub(super) struct ClosedSurface {
    pub skin: Skin,
    /// Rims that lids close.
    pub rims: Vec<Vec<usize>>,
    /// Sentences about what was left out and closed.
    pub notes: Vec<String>,
}

fn open(message: impl Into<String>, help: impl Into<String>) -> EngineError {
    EngineError::new("E0785", message, help)
}

/// Converts an error of the acoustic solution.
pub(super) fn engine_error(error: AcousticError) -> EngineError {
    let help = error.help().to_owned();
    match error {
        AcousticError::Interrupted(error) => error,
        other => refused(format!("the radiated sound cannot be computed: {other}"), help),
    }
}

/// Returns the error of a surface that does not enclose a body.
fn degenerate(error: AcousticError) -> EngineError {
    match error {
        AcousticError::Mesh { message, .. } if message.contains("rigid plane") => refused(
            format!("the surface and the rigid plane: {message}"),
            "move the plane, or reverse its normal",
        ),
        AcousticError::Mesh { message, .. } => open(
            format!("the surface encloses no body: {message}"),
            "correct the mesh: its skin must be closed, without coincident nodes that are not merged, and without elements that touch in a node or an edge only",
        ),
        other => engine_error(other),
    }
}

/// Returns a point in mm, with micrometres.
fn shown([x, y, z]: Vector) -> String {
    let mm = |metres: f64| (metres * 1e6).round() / 1e3 + 0.0;
    format!("({}, {}, {}) mm", mm(x), mm(y), mm(z))
}

impl ClosedSurface {
    /// Closes the surface of a mesh.
    ///
    /// # Errors
    /// E0784: a part is behind the rigid plane. E0785: the surface is open, and openings are not to
    /// be closed, or it does not enclose a body.
    pub fn new(
        vibration: &Vibration,
        close_openings: bool,
        plane: Option<RigidPlane>,
    ) -> Result<ClosedSurface, EngineError> {
        let Vibration { nodes, solids, shells, .. } = vibration;
        if !solids.is_empty() {
            let skin = Skin::new(nodes, solids, &[], plane).map_err(degenerate)?;
            let mut notes = vec![format!("the surface is the skin of {} solid elements", solids.len())];
            if !shells.is_empty() {
                notes.push(format!("{} shell elements next to the solids are left out", shells.len()));
            }
            return Ok(ClosedSurface { skin, rims: Vec::new(), notes });
        }
        let mut rims: Vec<Vec<usize>> = Vec::new();
        let mut found = ShellSkin::new(nodes, shells, &[], plane);
        if let Err(ShellProblem::Open { rims: all, .. }) = &found
            && close_openings
            && !all.is_empty()
        {
            rims.clone_from(all);
            let openings: Vec<BTreeSet<usize>> =
                rims.iter().map(|rim| rim.iter().copied().collect()).collect();
            found = ShellSkin::new(nodes, shells, &openings, plane);
        }
        let label = |node: usize| vibration.labels[node];
        let (ShellSkin { skin, left_out }, _) = found.map_err(|problem| match problem {
            ShellProblem::Open { rims, edges } => is_open(vibration, &rims, (edges, close_openings)),
            ShellProblem::Junction { edge: [a, b], shells } => open(
                format!("{shells} elements meet at the edge of the nodes {} and {}", label(a), label(b)),
                "leave inner walls out of the file: only ribs that end in a free edge are recognized",
            ),
            ShellProblem::OneSided { edge: [a, b] } => open(
                format!(
                    "the surface has no outside, as seen at the edge of the nodes {} and {}",
                    label(a),
                    label(b)
                ),
                "correct the mesh: its elements must enclose a volume",
            ),
            ShellProblem::Intersection { node } => {
                let place = vibration.labels.get(node).map_or(String::new(), |label| {
                    format!(", as seen at the node {label} at {}", shown(vibration.nodes[node]))
                });
                open(
                    format!("two closed parts of the surface intersect{place}"),
                    "join the parts in the mesh, or leave one of them out of the file",
                )
            }
            ShellProblem::Mesh(error) => degenerate(error),
        })?;
        let mut notes: Vec<String> = rims
            .iter()
            .map(|rim| format!("closed by a lid that moves with its rim: {}", described(vibration, rim)))
            .collect();
        if left_out > 0 {
            notes.push(format!("{left_out} elements are left out: ribs with a free edge, and parts inside"));
        }
        Ok(ClosedSurface { skin, rims, notes })
    }

    /// Returns the normal velocities of the triangles in a case, m/s.
    ///
    /// # Errors
    /// E0784: a node of the surface has no result.
    pub fn normal_velocities(
        &self,
        vibration: &Vibration,
        case: &VibrationCase,
    ) -> Result<Vec<c64>, EngineError> {
        let is_unknown = |node: &&usize| case.velocities[**node][0].re.is_nan();
        let unknown: BTreeSet<usize> = self.skin.nodes.iter().flatten().filter(is_unknown).copied().collect();
        if let Some(&node) = unknown.first() {
            return Err(refused(
                format!(
                    "{}: {} nodes of the surface have no result, such as the node {} at {}",
                    case.place,
                    unknown.len(),
                    vibration.labels[node],
                    shown(vibration.nodes[node])
                ),
                "export the results of all nodes of the surface",
            ));
        }
        self.skin.normal_velocities(&case.velocities).map_err(engine_error)
    }
}

/// Describes an opening by the number of its nodes, its middle and one of its nodes.
fn described(vibration: &Vibration, rim: &[usize]) -> String {
    let middle = |k: usize| rim.iter().map(|&node| vibration.nodes[node][k]).sum::<f64>() / rim.len() as f64;
    let middle = [0, 1, 2].map(middle);
    format!(
        "opening of {} nodes around {} with the node {}",
        rim.len(),
        shown(middle),
        vibration.labels[rim[0]]
    )
}

/// Returns the error of a surface with free edges, with the places of the openings.
fn is_open(
    vibration: &Vibration,
    rims: &[Vec<usize>],
    (edges, close_openings): (usize, bool),
) -> EngineError {
    if rims.is_empty() || close_openings {
        return open(
            format!("the surface is open along {edges} edges that form no separate rims"),
            "correct the mesh: merge coincident nodes, or close the surface with elements",
        );
    }
    let mut places: Vec<String> = rims.iter().take(NAMED).map(|rim| described(vibration, rim)).collect();
    if rims.len() > NAMED {
        places.push(format!("{} more", rims.len() - NAMED));
    }
    open(
        format!("the surface is open: {}", places.join("; ")),
        "close all openings by lids that move with their rims (`--close-openings`), or export a closed surface",
    )
}

/// Returns the edges of the box that contains points, m.
pub(super) fn edges_of_box(points: &[Vector]) -> [f64; 3] {
    [0, 1, 2].map(|k: usize| {
        let ends = points.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], point| {
            [low.min(point[k]), high.max(point[k])]
        });
        (ends[1] - ends[0]).max(0.0)
    })
}
