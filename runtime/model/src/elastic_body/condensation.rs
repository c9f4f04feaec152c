//! Condensation of a finite-element model onto its attachment nodes.

use super::MassReduction;
use super::rigid_links::carried;
use calyx_elastic::assembly::System;
use calyx_elastic::condensation::{CondensedBody, Synthesis, component_modes, guyan, static_condensation};
use calyx_elastic::{ElasticError, ElasticModel, NodalLoad, Node, Resources};
use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::{Interrupt, MemoryReservation};
use calyx_structure::{AttachmentMatrices, ComponentModes, RacewayMatrices};
use faer::Mat;
use nalgebra::DMatrix;

/// Condenses a model onto attachment nodes, exactly for statics, with all six components of each
/// along the basic axes, and reduces its mass. If `grounded`, the model has supports of its own,
/// and ground is a further attachment at the origin. `cases` are the loads that are conjugate to
/// the coefficients of raceways.
///
/// # Errors
/// E0992: an attachment has no stiffness in a component, the body has a mechanism, it needs more
/// memory than the limit, or its modes do not converge. Otherwise those of the interrupt.
pub fn condense_model(
    model: &ElasticModel,
    attachments: &[usize],
    cases: &[Vec<NodalLoad>],
    (grounded, mass): (bool, MassReduction),
    interrupt: &Interrupt,
) -> Result<AttachmentMatrices, EngineError> {
    let resources = Resources { interrupt: interrupt.clone(), ..Resources::default() };
    let system = System::new(model, &resources).map_err(engine_error)?;
    let condense = |cases: &[Vec<NodalLoad>], mass: MassReduction| {
        Condensation::new(&system, model, (attachments, cases), mass, &resources)
    };
    let (now, later) = if mass.has_mass() { (&[][..], cases) } else { (cases, &[][..]) };
    let condensation = condense(now, mass)?;
    // Raceways have no inertia: static displacements are sufficient.
    let raceways = match later.is_empty() {
        true => condensation.raceways(grounded),
        false => condense(later, MassReduction::None)?.raceways(grounded),
    };
    let Condensation { condensed, places, placed } = condensation;
    let transformed = |matrix: &Mat<f64>| {
        let ordered =
            DMatrix::from_fn(places.len(), places.len(), |row, column| matrix[(places[row], places[column])]);
        on_attachments(&ordered, &placed, grounded)
    };
    let modes = match &condensed.mass {
        Some(mass) => {
            let eigenvalues = condensed.eigenvalues.clone();
            let coupling = coupling(mass, &places, &relative_motions(&placed, grounded));
            ComponentModes { eigenvalues, coupling, ..ComponentModes::default() }
        }
        None => ComponentModes::default(),
    };
    Ok(AttachmentMatrices {
        stiffness: transformed(&condensed.stiffness),
        mass: condensed.mass.as_ref().map_or_else(Vec::new, transformed),
        modes,
        raceways,
    })
}

/// Displacements of nodes by units of the unknowns of a condensed body.
#[derive(Debug)]
pub struct MotionShapes {
    /// Displacements along the axes of the body by unknown and node, m: by unit displacements (m)
    /// and rotations (rad) of each attachment, then by component modes (m kg^(1/2)).
    pub displacements: Vec<Vec<[f64; 3]>>,
    /// Squared angular frequencies of the component modes, (rad/s)².
    pub eigenvalues: Vec<f64>,
    /// Mass between attachment components (rows) and component modes (columns), row-major, as in
    /// the condensed matrices of a body without supports of its own.
    pub coupling: Vec<f64>,
    _room: MemoryReservation,
}

/// Returns the mass between attachment components and component modes, row-major.
fn coupling(mass: &Mat<f64>, places: &[usize], motions: &DMatrix<f64>) -> Vec<f64> {
    let first = places.len();
    let modes = mass.ncols() - first;
    by_row(
        &(motions.transpose()
            * DMatrix::from_fn(first, modes, |row, mode| mass[(places[row], first + mode)])),
    )
}

/// Condensed body with the order of its attachment components.
struct Condensation {
    condensed: CondensedBody,
    /// Row of each component of each attachment, along the displacement axes of its node.
    places: Vec<usize>,
    /// Positions (m) and displacement axes of the attachments.
    placed: Vec<([f64; 3], [[f64; 3]; 3])>,
}

impl Condensation {
    fn new(
        system: &System<'_>,
        model: &ElasticModel,
        (attachments, cases): (&[usize], &[Vec<NodalLoad>]),
        mass: MassReduction,
        resources: &Resources,
    ) -> Result<Condensation, EngineError> {
        let condensed = match mass {
            MassReduction::None => static_condensation(system, attachments, cases, resources),
            MassReduction::Static => guyan(system, attachments, resources),
            MassReduction::ComponentModes(highest) => {
                component_modes(system, attachments, &[], Synthesis::FixedInterface, highest, resources)
            }
        };
        let condensed = condensed.map_err(engine_error)?;
        if let Some((node, component)) = (0..6 * attachments.len())
            .map(|row| (attachments[row / 6], row % 6))
            .find(|dof| !condensed.components.contains(dof))
        {
            return Err(EngineError::new(
                "E0992",
                format!(
                    "the attachment node {} has no stiffness in component {}",
                    model.nodes[node].label,
                    component + 1
                ),
                "attach a region whose nodes are not on a line",
            ));
        }
        let place = |row: usize| {
            let dof = (attachments[row / 6], row % 6);
            condensed.components.iter().position(|other| *other == dof).unwrap_or_default()
        };
        let places = (0..6 * attachments.len()).map(place).collect();
        let node = |&node: &usize| (model.nodes[node].position, model.nodes[node].axes);
        let placed = attachments.iter().map(node).collect();
        Ok(Condensation { condensed, places, placed })
    }

    /// Returns the matrices of raceways, if the load cases are those of their coefficients.
    fn raceways(&self, grounded: bool) -> RacewayMatrices {
        let loads = &self.condensed.loads;
        let ordered =
            DMatrix::from_fn(self.places.len(), loads.ncols(), |row, case| loads[(self.places[row], case)]);
        raceway_matrices(&ordered, &self.condensed.between_loads, &relative_motions(&self.placed, grounded))
    }
}

/// Returns the matrices of the raceways of a body: `loads` are those on the attachment components
/// (rows, along the displacement axes of their nodes) of unit coefficients, `compliance` the
/// displacements between these with fixed attachments, and `motions` the motions of the nodes by
/// those of the attachments.
fn raceway_matrices(loads: &DMatrix<f64>, compliance: &Mat<f64>, motions: &DMatrix<f64>) -> RacewayMatrices {
    let count = compliance.nrows();
    let compliance = DMatrix::from_fn(count, count, |row, column| compliance[(row, column)]);
    RacewayMatrices { motions: by_row(&(loads.transpose() * motions)), compliance: by_row(&compliance) }
}

/// Returns the displacements of nodes by units of the unknowns onto which [`condense_model`]
/// condenses a model: of the components of all attachments along the basic axes, and of the
/// component modes.
///
/// # Errors
/// Those of [`condense_model`].
pub(super) fn shapes_of_model(
    model: &ElasticModel,
    attachments: &[usize],
    mass: MassReduction,
    nodes: &[usize],
    interrupt: &Interrupt,
) -> Result<MotionShapes, EngineError> {
    let resources = Resources { interrupt: interrupt.clone(), ..Resources::default() };
    let system = System::new(model, &resources).map_err(engine_error)?;
    let Condensation { condensed, places, placed } =
        Condensation::new(&system, model, (attachments, &[]), mass, &resources)?;
    let modes = condensed.eigenvalues.len();
    let count = places.len() + modes;
    let room = interrupt.reserve_memory((2 * 24 * count * nodes.len()) as u64)?;
    let moved = |unknown: usize| -> Vec<[f64; 3]> {
        let mut unit = vec![0.0; condensed.unknown_count()];
        unit[unknown] = 1.0;
        let all = condensed.displacements(&system, &unit).unwrap_or_default();
        let at = |&node: &usize| {
            let motion = all.get(node).copied().unwrap_or_default();
            let [x, y, z, ..] = in_basic_axes((&motion, &model.nodes[node]));
            [x, y, z]
        };
        nodes.iter().map(at).collect()
    };
    let along_axes: Vec<Vec<[f64; 3]>> = places.iter().map(|&place| moved(place)).collect();
    let motions = relative_motions(&placed, false);
    let of_attachment = |column: usize| {
        let mut sum = vec![[0.0; 3]; nodes.len()];
        for (row, own) in along_axes.iter().enumerate().filter(|(row, _)| motions[(*row, column)] != 0.0) {
            let factor = motions[(row, column)];
            for (sum, own) in sum.iter_mut().zip(own) {
                (0..3).for_each(|k| sum[k] += factor * own[k]);
            }
        }
        sum
    };
    let attached = condensed.components.len();
    let mut displacements: Vec<Vec<[f64; 3]>> = (0..places.len()).map(of_attachment).collect();
    displacements.extend((0..modes).map(|mode| moved(attached + mode)));
    let coupling = condensed.mass.as_ref().map_or_else(Vec::new, |mass| coupling(mass, &places, &motions));
    Ok(MotionShapes { displacements, eigenvalues: condensed.eigenvalues, coupling, _room: room })
}

/// Returns the entries of a matrix by row.
pub(crate) fn by_row(matrix: &DMatrix<f64>) -> Vec<f64> {
    matrix.transpose().as_slice().to_vec()
}

/// Transforms a matrix along the displacement axes of nodes at these positions (m) to the basic
/// axes, row-major. If `grounded`, ground at the origin is a further attachment, relative to which
/// the nodes move.
pub(super) fn on_attachments(
    matrix: &DMatrix<f64>,
    nodes: &[([f64; 3], [[f64; 3]; 3])],
    grounded: bool,
) -> Vec<f64> {
    let motions = relative_motions(nodes, grounded);
    let product = motions.transpose() * matrix * &motions;
    by_row(&(0.5 * (&product + product.transpose())))
}

/// Returns the motions of nodes along their displacement axes (rows) by those of the attachments
/// along the basic axes (columns), of which the last one is ground if `grounded`.
pub(super) fn relative_motions(nodes: &[([f64; 3], [[f64; 3]; 3])], grounded: bool) -> DMatrix<f64> {
    let rows = 6 * nodes.len();
    let columns = rows + if grounded { 6 } else { 0 };
    let mut motions = DMatrix::zeros(rows, columns);
    for (index, (position, axes)) in nodes.iter().enumerate() {
        let carried = carried(*position);
        for component in 0..6 {
            for (k, part) in axes[component % 3].into_iter().enumerate() {
                let along = 3 * (component / 3) + k;
                motions[(6 * index + component, 6 * index + along)] = part;
                if grounded {
                    for (of_ground, moved) in carried[along].into_iter().enumerate() {
                        motions[(6 * index + component, rows + of_ground)] -= part * moved;
                    }
                }
            }
        }
    }
    motions
}

/// Converts an error of an elastic body.
pub(super) fn engine_error(error: ElasticError) -> EngineError {
    match error {
        ElasticError::Interrupted(error) => error,
        ElasticError::Model(error) => EngineError::new("E0992", error.message, error.help),
        ElasticError::Mechanism { message, help, .. } | ElasticError::Memory { message, help } => {
            EngineError::new("E0992", message, help)
        }
        ElasticError::Convergence(message) => {
            EngineError::new("E0992", message, "please report the body: this should not happen")
        }
    }
}

/// Transforms the motion of a node from its displacement axes to the basic axes.
pub(super) fn in_basic_axes((motion, node): (&[f64; 6], &Node)) -> [f64; 6] {
    std::array::from_fn(|k| {
        let first = 3 * (k / 3);
        (0..3).map(|axis| motion[first + axis] * node.axes[axis][k % 3]).sum()
    })
}
