//! Elastic bodies of any shape that take part in a scene: they are condensed onto their attachments
//! when structures are built, and then act as elastic connections.
//!
//! [`FiniteElementBody`] is a finite-element model with attachments, imported or generated;
//! [`MatrixBody`] is given by its condensed matrices. Another kind of body implements
//! [`ElasticBody`]. A scene gets the body with
//! [`ElasticConnection::of_body`](crate::connection::ElasticConnection::of_body) over the bodies of
//! its attachments.
//!
//! See `docs/theory/elastic-bodies.md`.

mod condensation;
mod extent;
mod finite_elements;
mod given_matrices;
mod raceway;
mod radiating;
mod recovery;
mod rigid_links;
mod supports;

pub(crate) use condensation::by_row;
pub use condensation::{MotionShapes, condense_model};
pub use extent::{AttachmentExtent, CylinderAxis};
pub use finite_elements::{BodyAttachment, FiniteElementBody};
pub use given_matrices::MatrixBody;
pub use raceway::SeatRaceway;
pub use radiating::{BodyMesh, Opening, Panel};
pub use recovery::{CellShape, DeformedElasticBody, Recovery};
pub use rigid_links::rigid_links;
pub use supports::SupportRow;

use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::Interrupt;
use calyx_structure::AttachmentMatrices;
use calyx_structure::cache::Key;
use calyx_structure::outer_surface::OuterSurface;
use std::any::Any;
use std::fmt;
use std::sync::Arc;

/// Size of an attachment that is given as a point, relative to the size of its body.
const POINT: f64 = 0.25;

/// Reduction of the mass of an elastic body to its attachments.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum MassReduction {
    /// No mass: for statics.
    #[default]
    None,
    /// Reduction by the static displacements (Guyan 1965).
    Static,
    /// In addition, modes with fixed attachments up to this frequency, Hz (Craig and Bampton 1968),
    /// and pseudo-modes for the omitted ones (Dickens, Nakagawa and Wittbrodt 1997).
    ComponentModes(f64),
}

impl MassReduction {
    /// Returns whether there is mass.
    pub fn has_mass(self) -> bool {
        self != MassReduction::None
    }

    /// Returns the highest frequency of component modes, Hz; 0 without them.
    pub fn highest_frequency(self) -> f64 {
        match self {
            MassReduction::ComponentModes(highest) => highest,
            MassReduction::None | MassReduction::Static => 0.0,
        }
    }
}

/// Size of an elastic body, for the display of a plan.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ElasticBodySize {
    /// Number of elements.
    pub elements: usize,
    /// Number of nodes.
    pub nodes: usize,
    /// Number of degrees of freedom, before condensation.
    pub dofs: usize,
    /// Number of attachment components, which remain.
    pub retained: usize,
    /// True for a solid of revolution, which is meshed in its axial section.
    pub revolved: bool,
    /// Mass, kg; `None` if it is unknown.
    pub mass: Option<f64>,
    /// Centre of mass in the coordinates of the body, m.
    pub centre: [f64; 3],
}

impl ElasticBodySize {
    /// Returns the estimated number of multiplications of the condensation: that of a nested
    /// dissection in three dimensions, or in two, and of the retained components.
    pub fn operations(&self) -> f64 {
        let (all, retained) = (self.dofs as f64, self.retained as f64);
        if self.revolved {
            return 100.0 * all.powf(1.5) + 100.0 * all * retained;
        }
        20.0 * all * all + 60.0 * all.powf(4.0 / 3.0) * retained
    }

    /// Returns the estimated largest memory of the condensation, bytes: stiffness matrix and
    /// fronts.
    pub fn bytes(&self) -> f64 {
        let all = self.dofs as f64;
        if self.revolved {
            return 16.0 * 100.0 * all;
        }
        16.0 * 80.0 * all + 8.0 * 6.0 * all.powf(4.0 / 3.0)
    }
}

/// Elastic body that is condensed onto attachments.
///
/// The coordinates of the body are those of its placement frame. The motions of each attachment are
/// three displacements and three rotations along and about these axes.
pub trait ElasticBody: Any + Send + Sync {
    /// Returns the positions of the attachments in the coordinates of the body, m.
    fn positions(&self) -> Vec<[f64; 3]>;

    /// Returns the extents of the attachments, in their order. By default they are points, and the
    /// distances between them are unknown.
    fn extents(&self) -> Vec<AttachmentExtent> {
        let size = POINT * self.typical_size();
        self.positions().into_iter().map(|position| AttachmentExtent::of_point(position, size)).collect()
    }

    /// Returns the raceways in the attachments, in their order; `None` for an attachment
    /// without one. By default there are none.
    fn raceways(&self) -> Vec<Option<SeatRaceway>> {
        Vec::new()
    }

    /// Returns whether the body itself is supported on ground. Ground is then an attachment after
    /// the others, at the origin of the body's coordinates.
    fn is_grounded(&self) -> bool {
        false
    }

    /// Returns an orthonormal basis of the rigid-body motions that the supports of a grounded body
    /// resist, with rotations times [`ElasticBody::typical_size`]; `None` if they resist all six.
    fn resisted_motions(&self) -> Option<Vec<SupportRow>> {
        None
    }

    /// Returns a key of everything that the matrices depend on. Bodies with equal keys share their
    /// matrices; a body without a key is condensed for each analysis.
    fn key(&self) -> Option<Key>;

    /// Checks whether the body with its attachments can be condensed, as far as this is known
    /// before the condensation.
    ///
    /// # Errors
    /// E0992: a part of the body can move freely.
    fn check(&self) -> Result<(), EngineError> {
        Ok(())
    }

    /// Condenses the body onto its attachments, with ground as the last one if it is grounded, and
    /// reduces its mass.
    ///
    /// # Errors
    /// E0992: the body cannot be condensed. Otherwise those of the interrupt.
    fn condense(&self, mass: MassReduction, interrupt: &Interrupt)
    -> Result<AttachmentMatrices, EngineError>;

    /// Prepares the recovery of displacements and stresses within the body; `None` if only its
    /// attachments are known.
    ///
    /// # Errors
    /// Those of [`Recovery::new`].
    fn recovery(&self, _interrupt: &Interrupt) -> Result<Option<Recovery>, EngineError> {
        Ok(None)
    }

    /// Returns the outer surface of the body in its coordinates, to display it; `None` if only its
    /// attachments are known.
    fn outer_surface(&self) -> Option<OuterSurface> {
        None
    }

    /// Returns the mesh of the body, whose surface radiates sound; `None` if only its attachments
    /// are known.
    fn mesh(&self) -> Option<BodyMesh> {
        None
    }

    /// Returns the displacements of nodes of its mesh by units of the unknowns of
    /// [`ElasticBody::condense`]; `None` if only its attachments are known.
    ///
    /// # Errors
    /// Those of [`ElasticBody::condense`].
    fn motion_shapes(
        &self,
        _mass: MassReduction,
        _nodes: &[usize],
        _interrupt: &Interrupt,
    ) -> Result<Option<MotionShapes>, EngineError> {
        Ok(None)
    }

    /// Returns whether the body has mass.
    fn has_mass(&self) -> bool {
        true
    }

    /// Returns a stiffness of the order of that of the body, N/m, such as Young's modulus times its
    /// size.
    fn typical_stiffness(&self) -> f64;

    /// Returns a typical size of the body, m.
    fn typical_size(&self) -> f64;

    /// Returns the size of the body; `None` if it is unknown before the condensation.
    fn size(&self) -> Option<ElasticBodySize> {
        None
    }

    /// Returns inputs of the body that no analysis takes into account, one sentence each.
    fn ignored(&self) -> Vec<String> {
        Vec::new()
    }
}

/// Elastic body that a connection shares with its copies.
#[derive(Clone)]
pub struct SharedElasticBody(pub Arc<dyn ElasticBody>);

impl SharedElasticBody {
    /// Returns the number of attachments, with ground if the body is grounded.
    pub fn attachments(&self) -> usize {
        self.0.positions().len() + usize::from(self.0.is_grounded())
    }
}

impl PartialEq for SharedElasticBody {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

impl fmt::Debug for SharedElasticBody {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("SharedElasticBody").field("attachments", &self.attachments()).finish()
    }
}
