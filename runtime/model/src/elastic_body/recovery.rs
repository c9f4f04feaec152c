//! Displacements and stresses within an elastic body from the motions of its attachments.
//!
//! The condensation keeps the attachments alone. The displacements of all nodes follow from the
//! forces of the attachments, which are their condensed stiffness times their motions: the body is
//! solved once under unit forces on each attachment, with a statically determinate support of each
//! part that can move freely. The forces are in equilibrium, so the support carries nothing. A
//! rigid-body motion of the part then takes its first attachment to its position.

use super::condensation::{engine_error, in_basic_axes};
use super::rigid_links::carried;
use calyx_elastic::assembly::System;
use calyx_elastic::check::{determinate_support, parts};
use calyx_elastic::model::{ShellShape, SolidShape};
use calyx_elastic::stress::nodal_stresses_of;
use calyx_elastic::{ElasticModel, Element, ElementKind, FixedComponents, NodalLoad, Resources, statics};
use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::{Interrupt, MemoryReservation};
use calyx_numerics::stress::{NodalStresses, Stress};
use calyx_numerics::vec3::{Vector, minus};
use calyx_structure::outer_surface::{Cell, CellKind};

/// Motion of a node along the axes of the body, m and rad.
type Six = [f64; 6];

/// Shape of a cell of a deformed body. Nodes are in the order of the shape.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CellShape {
    /// Beam or rod.
    Line,
    /// Shell.
    Shell(ShellShape),
    /// Solid.
    Solid(SolidShape),
}

impl CellShape {
    /// Returns the shape of an element of an elastic body; `None` for springs and masses.
    pub fn of(element: &Element) -> Option<CellShape> {
        match &element.kind {
            ElementKind::Solid(shape) => Some(CellShape::Solid(*shape)),
            ElementKind::Shell { shape, .. } => Some(CellShape::Shell(*shape)),
            ElementKind::Beam(_) | ElementKind::Rod { .. } => Some(CellShape::Line),
            ElementKind::Spring { .. } | ElementKind::Mass { .. } => None,
        }
    }

    /// Returns the cell with straight edges between the corners of an element of this shape.
    pub fn cell(self, nodes: &[usize], element: usize) -> Cell<'_> {
        let (kind, corners) = match self {
            CellShape::Line => (CellKind::Line, nodes.len()),
            CellShape::Shell(ShellShape::Triangle3 | ShellShape::Triangle6) => (CellKind::Face, 3),
            CellShape::Shell(
                ShellShape::Quadrilateral4 | ShellShape::Quadrilateral8 | ShellShape::Quadrilateral9,
            ) => (CellKind::Face, 4),
            CellShape::Solid(SolidShape::Tetrahedron4 | SolidShape::Tetrahedron10) => {
                (CellKind::Tetrahedron, 4)
            }
            CellShape::Solid(SolidShape::Wedge6 | SolidShape::Wedge15) => (CellKind::Wedge, 6),
            CellShape::Solid(
                SolidShape::Hexahedron8 | SolidShape::IncompatibleHexahedron8 | SolidShape::Hexahedron20,
            ) => (CellKind::Hexahedron, 8),
        };
        Cell { kind, corners: &nodes[..corners], element }
    }
}

/// Deformed elastic body in its own coordinates.
#[derive(Clone, Debug, PartialEq)]
pub struct DeformedElasticBody {
    /// Undeformed nodes, m.
    pub points: Vec<Vector>,
    /// Elements with their nodes, as indices of points.
    pub cells: Vec<(CellShape, Vec<usize>)>,
    /// Displacement of each node from its position in the undeformed and undisplaced body, m.
    pub displacements: Vec<Vector>,
    /// Stress at each node ([`nodal_stresses_of`]), Pa; NaN at nodes without solids and shells.
    pub stresses: Vec<Stress>,
    /// Estimated error of each stress as a von Mises stress, Pa; NaN where there is no estimate.
    pub stress_errors: Vec<f64>,
}

/// Solutions of a body under unit forces on its attachments.
pub struct Recovery {
    model: ElasticModel,
    /// Nodes of the attachments.
    attachments: Vec<usize>,
    /// Number of nodes that are not amplitudes or added for attachments.
    shown: usize,
    /// Motions of all nodes under a unit of each component of each attachment, then under each
    /// further load case.
    units: Vec<Vec<Six>>,
    /// Nodes of each part that can move freely.
    free_parts: Vec<Vec<usize>>,
    _room: MemoryReservation,
}

impl Recovery {
    /// Solves a model with attachments at these nodes and further load cases; the first `shown`
    /// nodes are recovered.
    ///
    /// # Errors
    /// E0992: the body has a mechanism, or needs more memory than the limit. Otherwise those of the
    /// interrupt.
    pub fn new(
        mut model: ElasticModel,
        attachments: Vec<usize>,
        further: &[Vec<NodalLoad>],
        shown: usize,
        interrupt: &Interrupt,
    ) -> Result<Recovery, EngineError> {
        let resources = Resources { interrupt: interrupt.clone(), ..Resources::default() };
        let columns = 6 * attachments.len();
        let all = columns + further.len();
        let room = interrupt.reserve_memory((3 * 8 * 6 * all * model.nodes.len()) as u64)?;
        // Supports of the body do not move.
        model.fixed.iter_mut().for_each(|fixed| fixed.value = 0.0);
        let (free_parts, support) = {
            let system = System::new(&model, &resources).map_err(engine_error)?;
            let mut all = parts(&system);
            all.retain(|part| !part.free_motions.is_empty());
            let motions: Vec<Vec<f64>> = all.iter().flat_map(|part| part.free_motions.clone()).collect();
            let support = determinate_support(&system, &motions);
            (all.into_iter().map(|part| part.nodes).collect(), support)
        };
        let held = |dof: usize| FixedComponents {
            node: dof / 6,
            components: std::array::from_fn(|component| component == dof % 6),
            value: 0.0,
        };
        let supports = model.fixed.len();
        model.fixed.extend(support.into_iter().map(held));
        let unit = |row: usize| {
            let load = std::array::from_fn(|component| if component == row % 6 { 1.0 } else { 0.0 });
            vec![NodalLoad { node: attachments[row / 6], load }]
        };
        let cases: Vec<Vec<NodalLoad>> = (0..columns).map(unit).chain(further.iter().cloned()).collect();
        let solved = System::new(&model, &resources)
            .and_then(|system| statics::solve(&system, &cases, &resources))
            .map_err(engine_error)?;
        let along_basic =
            |displacements: Vec<Six>| displacements.iter().zip(&model.nodes).map(in_basic_axes).collect();
        let units = solved.into_iter().map(|solution| along_basic(solution.displacements)).collect();
        model.fixed.truncate(supports);
        Ok(Recovery { model, attachments, shown, units, free_parts, _room: room })
    }

    /// Returns the deformed body from the motions of its attachments, the forces of these on it,
    /// and the amounts of the further load cases.
    ///
    /// # Errors
    /// An element is degenerate.
    pub fn deformed(
        &self,
        motions: &[Six],
        forces: &[Six],
        further: &[f64],
    ) -> Result<DeformedElasticBody, EngineError> {
        // Ground may be a last attachment, which has no unit.
        let columns = 6 * self.attachments.len();
        let amounts = forces.as_flattened()[..columns].iter().chain(further);
        let mut all = vec![[0.0; 6]; self.model.nodes.len()];
        for (&force, unit) in amounts.zip(&self.units) {
            for (sum, part) in all.iter_mut().zip(unit) {
                sum.iter_mut().zip(part).for_each(|(sum, part)| *sum += force * part);
            }
        }
        for part in &self.free_parts {
            self.carry(part, motions, &mut all);
        }
        let refused =
            |error: calyx_elastic::ElementError| EngineError::new("E0992", error.message, error.help);
        let NodalStresses { mut stresses, mut errors } =
            nodal_stresses_of(&self.model, &all).map_err(refused)?;
        stresses.truncate(self.shown);
        errors.truncate(self.shown);
        let shown = &self.model.nodes[..self.shown];
        Ok(DeformedElasticBody {
            points: shown.iter().map(|node| node.position).collect(),
            cells: self.cells(),
            displacements: all[..self.shown].iter().map(|&[x, y, z, ..]| [x, y, z]).collect(),
            stresses,
            stress_errors: errors,
        })
    }

    /// Adds the rigid-body motion of a part that takes its first attachment to its motion.
    fn carry(&self, part: &[usize], motions: &[Six], all: &mut [Six]) {
        let first = self.attachments.iter().position(|node| part.binary_search(node).is_ok());
        let Some(index) = first else { return };
        let reference = self.attachments[index];
        let (target, found) = (motions[index], all[reference]);
        let difference: Six = std::array::from_fn(|k| target[k] - found[k]);
        let about = self.model.nodes[reference].position;
        for &node in part {
            let rigid = carried(minus(self.model.nodes[node].position, about));
            for (sum, row) in all[node].iter_mut().zip(rigid) {
                *sum += row.iter().zip(difference).map(|(part, by)| part * by).sum::<f64>();
            }
        }
    }

    fn cells(&self) -> Vec<(CellShape, Vec<usize>)> {
        let cell = |element: &Element| Some((CellShape::of(element)?, element.nodes.clone()));
        self.model.elements.iter().filter_map(cell).collect()
    }
}
