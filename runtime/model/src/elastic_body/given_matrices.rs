//! Elastic body that is given by its stiffness and mass at nodes.

use super::condensation::{by_row, on_attachments, relative_motions};
use super::finite_elements::extent;
use super::rigid_links::carried;
use super::supports::{SupportRow, resisted};
use super::{ElasticBody, ElasticBodySize, MassReduction};
use crate::interior_modes::InteriorModes;
use calyx_elastic::import::CondensedMatrices;
use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::Interrupt;
use calyx_numerics::vec3::Vector;
use calyx_structure::cache::Key;
use calyx_structure::{AttachmentMatrices, ComponentModes, RacewayMatrices};
use nalgebra::DMatrix;
use std::sync::Arc;

/// Forces due to rigid-body motions, relative to those of the same motions of single components,
/// above which the body is supported.
const SUPPORTED: f64 = 1e-6;
/// Axes of the components of nodes.
const BASIC: [Vector; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// Body with given matrices, attached at some of its nodes. The others carry no load. Copies share
/// the matrices.
#[derive(Clone)]
pub struct MatrixBody {
    matrices: Arc<CondensedMatrices>,
    content: Key,
    /// Motions that the supports of the body resist; none for a body without supports.
    supports: Vec<SupportRow>,
    /// Index and position of the attached nodes.
    attachments: Vec<(usize, Vector)>,
}

impl MatrixBody {
    /// Creates a body without attachments. Matrices with equal `content` keys must be equal. If a
    /// common rigid-body motion of all nodes causes forces, the body is supported on ground.
    pub fn new(matrices: Arc<CondensedMatrices>, content: Key) -> MatrixBody {
        let supports = support_rows(&matrices);
        MatrixBody { matrices, content, supports, attachments: Vec::new() }
    }

    /// Returns the matrices.
    pub fn matrices(&self) -> &CondensedMatrices {
        &self.matrices
    }

    /// Adds an attachment at the node of this label. `position` (m) applies if the source does not
    /// state that of the node.
    ///
    /// # Errors
    /// E0991: the body has no such node, the node is attached already, it lacks one of the six
    /// components, or its position is unknown.
    pub fn attach(
        &mut self,
        name: &str,
        label: &str,
        position: Option<Vector>,
    ) -> Result<Vector, EngineError> {
        let refused = |message: String, help: String| {
            Err(EngineError::new("E0991", format!("attachment \"{name}\": {message}"), help))
        };
        let Some(node) = self.matrices.nodes.iter().position(|node| node.label == label) else {
            let labels: Vec<&str> = self.matrices.nodes.iter().take(20).map(|node| &*node.label).collect();
            let more = if self.matrices.nodes.len() > labels.len() { " and others" } else { "" };
            let help = format!("name one of its nodes: {}{more}", labels.join(", "));
            return refused(format!("the body has no node \"{label}\""), help);
        };
        if self.attachments.iter().any(|(other, _)| *other == node) {
            return refused(
                format!("node \"{label}\" is an attachment already"),
                "use that attachment".into(),
            );
        }
        let missing = (0..6).find(|component| !self.matrices.components.contains(&(node, *component)));
        if let Some(component) = missing {
            return refused(
                format!("node \"{label}\" has no component {}", component + 1),
                "condense the body to nodes with three translations and three rotations".into(),
            );
        }
        let Some(at) = self.matrices.nodes[node].position.or(position) else {
            return refused(
                format!("the file does not state the position of node \"{label}\""),
                "give `position`, or add the node to the file".into(),
            );
        };
        self.attachments.push((node, at));
        Ok(at)
    }

    /// Returns the rows of the attachments, and all others with stiffness.
    fn rows(&self) -> (Vec<usize>, Vec<usize>) {
        let row = |dof: (usize, usize)| self.matrices.components.iter().position(|other| *other == dof);
        let attached: Vec<usize> = self
            .attachments
            .iter()
            .flat_map(|(node, _)| (0..6).filter_map(move |component| row((*node, component))))
            .collect();
        let stiff = |row: &usize| self.matrices.stiffness[(*row, *row)] > 0.0;
        let all = 0..self.matrices.components.len();
        let others = all.filter(|row| !attached.contains(row)).filter(stiff).collect();
        (attached, others)
    }
}

impl ElasticBody for MatrixBody {
    fn positions(&self) -> Vec<Vector> {
        self.attachments.iter().map(|(_, position)| *position).collect()
    }

    fn is_grounded(&self) -> bool {
        !self.supports.is_empty()
    }

    fn resisted_motions(&self) -> Option<Vec<SupportRow>> {
        resisted(&self.supports, self.typical_size())
    }

    fn key(&self) -> Option<Key> {
        let key = Key::of("given matrices").text(crate::SOURCE).key(&self.content);
        let written = self.attachments.iter();
        Some(written.fold(key, |key, (node, at)| key.count(*node as u64).numbers(at)).finish())
    }

    fn condense(
        &self,
        reduction: MassReduction,
        interrupt: &Interrupt,
    ) -> Result<AttachmentMatrices, EngineError> {
        let (attached, others) = self.rows();
        // Modes need several matrices more.
        let copies = if reduction.highest_frequency() > 0.0 { 12 } else { 4 };
        let bytes = 8 * copies * (self.matrices.components.len() as u64).pow(2);
        let _room = interrupt.reserve_memory(bytes)?;
        let block = |matrix: &DMatrix<f64>, rows: &[usize], columns: &[usize]| {
            DMatrix::from_fn(rows.len(), columns.len(), |row, column| matrix[(rows[row], columns[column])])
        };
        // Motions of the other components from those of the attachments.
        let stiffness = &self.matrices.stiffness;
        let coupling = block(stiffness, &others, &attached);
        let inner = block(stiffness, &others, &others);
        let Some(factor) = inner.cholesky() else {
            return Err(EngineError::new(
                "E0992",
                "with its attachments fixed, the body can move without deforming",
                "attach the body at nodes that support it, or correct its stiffness matrix",
            ));
        };
        let moved = -factor.solve(&coupling);
        let own = block(stiffness, &attached, &attached) + coupling.transpose() * &moved;
        let mass = self.matrices.mass.as_ref().filter(|_| reduction.has_mass());
        let mut modes = ComponentModes::default();
        let placed: Vec<_> = self.attachments.iter().map(|(_, position)| (*position, BASIC)).collect();
        let mut reduced = None;
        if let Some(mass) = mass {
            let between = block(mass, &others, &attached);
            let inner = block(mass, &others, &others);
            let inertia = &between + &inner * &moved;
            if let MassReduction::ComponentModes(highest) = reduction {
                interrupt.check()?;
                let found = InteriorModes::find(&factor, &inner, &inertia, highest).ok_or_else(|| {
                    EngineError::new(
                        "E0992",
                        "the modes of the body with fixed attachments cannot be computed",
                        "check its mass matrix, or leave `highest_frequency` at 0",
                    )
                })?;
                let motions = relative_motions(&placed, self.is_grounded());
                modes.coupling = by_row(&(motions.transpose() * found.coupling));
                modes.eigenvalues = found.eigenvalues;
            }
            let own = block(mass, &attached, &attached);
            reduced = Some(own + between.transpose() * &moved + moved.transpose() * inertia);
        }
        let rows = 6 * (placed.len() + usize::from(self.is_grounded()));
        Ok(AttachmentMatrices {
            stiffness: on_attachments(&own, &placed, self.is_grounded()),
            mass: match reduced {
                Some(mass) => on_attachments(&mass, &placed, self.is_grounded()),
                None if reduction.has_mass() => vec![0.0; rows * rows],
                None => Vec::new(),
            },
            modes,
            raceways: RacewayMatrices::default(),
        })
    }

    fn has_mass(&self) -> bool {
        self.matrices.mass.as_ref().is_some_and(|mass| mass.diagonal().iter().any(|entry| *entry > 0.0))
    }

    fn typical_stiffness(&self) -> f64 {
        let own = |(row, (_, component)): (usize, &(usize, usize))| {
            if *component < 3 { self.matrices.stiffness[(row, row)] } else { 0.0 }
        };
        self.matrices.components.iter().enumerate().map(own).fold(0.0, f64::max)
    }

    fn typical_size(&self) -> f64 {
        let stated = self.matrices.nodes.iter().filter_map(|node| node.position);
        extent(stated.chain(self.positions()))
    }

    fn size(&self) -> Option<ElasticBodySize> {
        Some(ElasticBodySize {
            nodes: self.matrices.nodes.len(),
            dofs: self.matrices.components.len(),
            retained: 6 * self.attachments.len(),
            ..ElasticBodySize::default()
        })
    }
}

/// Returns the forces on the components, relative to the root of their own stiffness, by rigid-body
/// motions of all nodes: one row per component with a force. A body with nodes of unknown position
/// counts as free.
fn support_rows(matrices: &CondensedMatrices) -> Vec<SupportRow> {
    let positions: Option<Vec<Vector>> = matrices.nodes.iter().map(|node| node.position).collect();
    let Some(positions) = positions else { return Vec::new() };
    let carried: Vec<_> = positions.into_iter().map(carried).collect();
    let count = matrices.components.len();
    let moved = |column: usize, motion: usize| {
        let (node, component) = matrices.components[column];
        carried[node][component][motion]
    };
    let own = |k: usize| matrices.stiffness[(k, k)].max(0.0).sqrt();
    // Entries of components that do not couple are rounding errors, relative to the diagonal.
    let scale: [f64; 6] = std::array::from_fn(|motion| {
        (0..count).map(|column| own(column) * moved(column, motion).abs()).sum()
    });
    let force = |row: usize, motion: usize| {
        let terms = (0..count).map(|column| matrices.stiffness[(row, column)] * moved(column, motion));
        let force = terms.sum::<f64>();
        if force.abs() > SUPPORTED * own(row) * scale[motion] { force / own(row) } else { 0.0 }
    };
    let stiff = (0..count).filter(|&row| own(row) > 0.0);
    let rows = stiff.map(|row| std::array::from_fn(|motion| force(row, motion)));
    rows.filter(|row: &SupportRow| row.iter().any(|&force| force != 0.0)).collect()
}
