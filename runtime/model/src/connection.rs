//! Elastic connections: linear elastic parts between the frames of any number of bodies, such as
//! shafts.
//!
//! A connection has *attachments*: points that are rigid parts of bodies or of ground. Each has
//! three displacements and three rotations, along and about the axes of the reference, which is the
//! body (or ground) of the first attachment. The axes of a shaft do not rotate with it. The
//! connection is given by a symmetric positive semidefinite stiffness matrix between all these
//! components, under which rigid-body motions of all attachments cause no forces, and by a mass
//! matrix on the same components. It generalizes a bearing to several bodies, and enters the
//! equilibrium in the same way.
//!
//! The stiffness is linear about the prescribed motions of the bodies, so the attachments must keep
//! their positions relative to the reference. The bodies may rotate about their attachments
//! relative to each other, as planets on the pins of a carrier.
//!
//! A shaft and an elastic body of any shape are connections. The matrices of an elastic body are
//! computed when structures are built ([`crate::connection_building`]).
//!
//! See `docs/theory/shafts.md`.

mod connection_state;
mod gyroscopic;
mod terms;

pub use connection_state::ConnectionState;
pub use gyroscopic::{GyroscopicShaft, add_connection_gyroscopic, add_connection_whirl_form};
pub use terms::{add_connection_mass, add_connection_stiffness, add_mode_coupling};

use crate::bearing::Support;
use crate::body::Body;
use crate::elastic_body::{ElasticBody, MassReduction, SeatRaceway, SharedElasticBody, rigid_links};
use crate::fidelity::Fidelity;
use crate::ids::BodyId;
use crate::shaft::Shaft;
use calyx_numerics::error::{EngineError, Subject};
use calyx_structure::{AttachmentMatrices, ComponentModes, RacewayMatrices};
use nalgebra::{DMatrix, SymmetricEigen};
use std::sync::Arc;

/// Point of a body or of ground to which a connection is attached.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Attachment {
    /// The body, or ground.
    pub to: Support,
    /// Position in the coordinates of the body's frame, or of ground, m.
    pub at: [f64; 3],
}

/// Linear elastic part between bodies.
#[derive(Clone, Debug, PartialEq)]
pub struct ElasticConnection {
    /// Name in results and messages.
    pub name: String,
    /// Attachments; the axes of the first one's body are the reference axes. A body may have
    /// several.
    pub attachments: Vec<Attachment>,
    /// Stiffness matrix, six rows an attachment in the order of [`crate::dof::DOF_NAMES`],
    /// row-major; units as in [`crate::bearing::BearingMatrix`].
    pub stiffness: Vec<f64>,
    /// Mass matrix on the same components, kg, kg m and kg m²; empty for a connection without mass.
    pub mass: Vec<f64>,
    /// Modes of the part with fixed attachments, for vibrations about an equilibrium.
    pub modes: ComponentModes,
    /// The shaft of which this is the condensation, if any.
    pub shaft: Option<CondensedShaft>,
    /// The elastic body that is condensed onto the attachments when structures are built, if any.
    /// The matrices are empty before.
    pub body: Option<SharedElasticBody>,
    /// Raceways in the attachments of the elastic body; empty before its condensation, and where it
    /// is rigid.
    pub raceways: RacewayMatrices,
}

/// Shaft behind a connection, for displacements and forces between its stations.
#[derive(Clone, Debug, PartialEq)]
pub struct CondensedShaft {
    /// The shaft.
    pub shaft: Arc<Shaft>,
    /// Position of each attachment on the shaft, ascending, m.
    pub stations: Vec<f64>,
    /// True if the shaft is modelled as rigid: its forces are unknown.
    pub rigid: bool,
}

/// Tolerance of asymmetry, of negative eigenvalues and of forces due to rigid-body motions,
/// relative to the diagonal of the matrix; covers rounding of printed digits.
const ROUNDING: f64 = 1e-6;

/// Seat of an elastic body that is the raceway of bearings.
#[derive(Clone, Copy, Debug)]
pub struct Seat {
    /// Index of the body that represents the attachment.
    pub body: usize,
    /// Series with its axes and modulus.
    pub raceway: SeatRaceway,
    /// Index of its first term among those of all seats of the elastic body.
    pub first_term: usize,
}

impl ElasticConnection {
    /// Creates the connection of an elastic body between the bodies of its attachments. The frames
    /// of these bodies have their origins at the attachments and the axes of the elastic body.
    /// `origin` is the origin of its coordinates in those of ground, m.
    pub fn of_body(
        name: String,
        body: Arc<dyn ElasticBody>,
        attachments: &[BodyId],
        origin: [f64; 3],
    ) -> ElasticConnection {
        let on_body = |&id: &BodyId| Attachment { to: Support::Body(id), at: [0.0; 3] };
        let ground = body.is_grounded().then_some(Attachment { to: Support::Ground, at: origin });
        ElasticConnection {
            name,
            attachments: attachments.iter().map(on_body).chain(ground).collect(),
            stiffness: Vec::new(),
            mass: Vec::new(),
            modes: ComponentModes::default(),
            shaft: None,
            body: Some(SharedElasticBody(body)),
            raceways: RacewayMatrices::default(),
        }
    }

    /// Returns the seats of its elastic body that are raceways.
    pub fn seats(&self) -> Vec<Seat> {
        let raceways = self.body.as_ref().map_or_else(Vec::new, |body| body.0.raceways());
        let (mut seats, mut first_term) = (Vec::new(), 0);
        for (raceway, attachment) in raceways.into_iter().zip(&self.attachments) {
            let Some(raceway) = raceway else { continue };
            if let Support::Body(id) = attachment.to {
                seats.push(Seat { body: id.0, raceway, first_term });
            }
            first_term += raceway.raceway.terms();
        }
        seats
    }

    /// Returns the connection with the matrices of its elastic body.
    ///
    /// # Errors
    /// Those of [`ElasticConnection::check`].
    pub fn condensed(
        &self,
        bodies: &[Body],
        matrices: &AttachmentMatrices,
    ) -> Result<ElasticConnection, EngineError> {
        let AttachmentMatrices { stiffness, mass, modes, raceways } = matrices.clone();
        let condensed = ElasticConnection { stiffness, mass, modes, raceways, ..self.clone() };
        condensed.check_matrices(bodies)?;
        Ok(condensed)
    }

    /// Returns the connection with its elastic body as rigid, as links of this multiple of the
    /// typical stiffness of the body; without mass.
    ///
    /// # Errors
    /// Those of [`ConnectionState::at`].
    pub fn rigid(&self, bodies: &[Body], multiple: f64) -> Result<ElasticConnection, EngineError> {
        let Some(SharedElasticBody(body)) = &self.body else { return Ok(self.clone()) };
        let positions = ConnectionState::at(bodies, self, 0.0)?.positions();
        let resisted = body.is_grounded().then(|| body.resisted_motions()).flatten();
        let (stiffness, size) = (multiple * body.typical_stiffness(), body.typical_size());
        let stiffness = rigid_links(&positions, stiffness, size, resisted.as_deref());
        Ok(ElasticConnection { stiffness, ..self.clone() })
    }

    /// Returns the bodies that the connection joins, once each, in the order of the attachments.
    pub fn bodies(&self) -> impl Iterator<Item = BodyId> {
        let bodies = self.attachments.iter().map(|attachment| match attachment.to {
            Support::Ground => None,
            Support::Body(body) => Some(body),
        });
        let all: Vec<BodyId> = bodies.flatten().collect();
        (0..all.len())
            .filter(|&k| !all[..k].contains(&all[k]))
            .map(|k| all[k])
            .collect::<Vec<_>>()
            .into_iter()
    }

    /// Returns an error about the elastic body of the connection with its name, at the body of its
    /// first attachment.
    pub fn named(&self, error: EngineError) -> EngineError {
        self.about("elastic body", error)
    }

    /// Returns an error about the shaft of the connection with its name, at its first body.
    pub fn about_shaft(&self, error: EngineError) -> EngineError {
        self.about("shaft", error)
    }

    fn about(&self, what: &str, error: EngineError) -> EngineError {
        let message = format!("the {what} \"{}\": {}", self.name, error.message);
        let error = EngineError { message, ..error };
        match self.bodies().next() {
            Some(BodyId(body)) => error.about(Subject::Body(body)),
            None => error,
        }
    }

    /// Returns the connection with the component modes of its shaft, if these are requested and the
    /// shaft is elastic.
    ///
    /// # Errors
    /// Those of [`Shaft::component_modes`].
    pub(crate) fn with_shaft_modes(&self, mass: MassReduction) -> Result<ElasticConnection, EngineError> {
        let shaft = self.shaft.as_ref().filter(|shaft| !shaft.rigid && !shaft.stations.is_empty());
        let (MassReduction::ComponentModes(highest), Some(condensed)) = (mass, shaft) else {
            return Ok(self.clone());
        };
        let modes = condensed.shaft.component_modes(&condensed.stations, highest);
        let AttachmentMatrices { mass, modes, .. } = modes.map_err(|error| self.about_shaft(error))?;
        Ok(ElasticConnection { mass, modes, ..self.clone() })
    }

    /// Returns the shaft of the connection if it is modelled as a solid at this fidelity: elastic
    /// shafts at those of three-dimensional finite elements, otherwise they are beams.
    pub fn solid_shaft(&self, fidelity: Fidelity) -> Option<&CondensedShaft> {
        let elements = matches!(fidelity, Fidelity::Solid(_));
        self.shaft.as_ref().filter(|shaft| elements && !shaft.rigid && shaft.stations.len() > 1)
    }

    /// Returns whether the connection can have component modes: it is an elastic body or shaft.
    pub fn has_modes(&self) -> bool {
        self.body.is_some() || self.shaft.as_ref().is_some_and(|shaft| !shaft.rigid)
    }

    /// Returns the number of rows of the matrices.
    pub fn size(&self) -> usize {
        6 * self.attachments.len()
    }

    /// Checks whether these bodies can have this connection.
    ///
    /// # Errors
    /// - E0653: the scene has no such body.
    /// - E0869: a matrix has the wrong size, is not symmetric or not positive semidefinite; the
    ///   stiffness resists a rigid-body motion; or the attachments do not keep their positions.
    /// - E0710: a frame is NaN.
    pub fn check(&self, bodies: &[Body]) -> Result<(), EngineError> {
        let size = self.size();
        let refused = |problem: String, help: &str| {
            let message = format!("the elastic connection \"{}\" {problem}", self.name);
            Err(EngineError::new("E0869", message, help))
        };
        if size == 0 {
            return refused("has no attachments".into(), "attach it to at least two bodies");
        }
        match &self.body {
            None => self.check_matrices(bodies)?,
            Some(body) if 6 * body.attachments() != size => {
                return refused(
                    format!("has {} attachments, and its body {}", size / 6, body.attachments()),
                    "attach each attachment of the body to a body of the scene",
                );
            }
            Some(_) => {}
        }
        // The velocities of the attachments show whether they stay together.
        ConnectionState::at(bodies, self, 0.0)?.check_velocities(bodies, self)
    }

    fn check_matrices(&self, bodies: &[Body]) -> Result<(), EngineError> {
        let size = self.size();
        let refused = |problem: String, help: &str| {
            let message = format!("the elastic connection \"{}\" {problem}", self.name);
            Err(EngineError::new("E0869", message, help))
        };
        let mass = (!self.mass.is_empty()).then_some(("mass", &self.mass));
        for (what, matrix) in [("stiffness", &self.stiffness)].into_iter().chain(mass) {
            if let Err(problem) = check_matrix(matrix, size) {
                return refused(
                    format!("has a {what} matrix that {problem}"),
                    "give a symmetric matrix without negative eigenvalues, six rows for each attachment",
                );
            }
        }
        let state = ConnectionState::at(bodies, self, 0.0)?;
        if let Some(motion) = resisted_rigid_motion(&self.stiffness, &state.rigid_motions()) {
            return refused(
                format!("resists the rigid-body motion {}", crate::dof::DOF_NAMES[motion]),
                "give a stiffness matrix under which a common motion of all attachments causes no forces; attach the part to ground where it is supported",
            );
        }
        Ok(())
    }
}

/// Checks a matrix of a connection. The error is the rest of a sentence.
fn check_matrix(matrix: &[f64], size: usize) -> Result<(), String> {
    if matrix.len() != size * size {
        return Err(format!("has {} entries instead of {}", matrix.len(), size * size));
    }
    if !matrix.iter().all(|entry| entry.is_finite()) {
        return Err("has an entry that is not a finite number".into());
    }
    let scale: Vec<f64> = (0..size).map(|k| matrix[k * size + k].max(0.0).sqrt()).collect();
    for row in 0..size {
        for column in 0..row {
            let (one, other) = (matrix[row * size + column], matrix[column * size + row]);
            if (one - other).abs() > ROUNDING * (scale[row] * scale[column]).max(one.abs().min(other.abs())) {
                return Err(format!("is not symmetric in row {} and column {}", row + 1, column + 1));
            }
        }
        if matrix[row * size + row] < 0.0 {
            return Err(format!("has a negative diagonal entry in row {}", row + 1));
        }
    }
    let scaled = DMatrix::from_fn(size, size, |row, column| {
        let value = 0.5 * (matrix[row * size + column] + matrix[column * size + row]);
        if value == 0.0 { 0.0 } else { value / (scale[row] * scale[column]) }
    });
    if !scaled.iter().all(|entry| entry.is_finite()) {
        return Err("couples a component that has no stiffness itself".into());
    }
    match SymmetricEigen::new(scaled).eigenvalues.iter().any(|&value| value < -ROUNDING) {
        true => Err("has a negative eigenvalue".into()),
        false => Ok(()),
    }
}

/// Returns the first of these rigid-body motions (one entry per component each) under which the
/// stiffness gives forces.
fn resisted_rigid_motion(stiffness: &[f64], motions: &[Vec<f64>; 6]) -> Option<usize> {
    motions.iter().position(|motion| {
        // Rounding of a position counts relative to the size of the connection, which is the
        // largest displacement in this motion.
        let largest = |from: usize| {
            motion.iter().skip(from).step_by(6).fold(0.0, |most: f64, part| most.max(part.abs()))
        };
        let [shift, turn] = [0, 3].map(|from| (from..from + 3).map(largest).fold(0.0, f64::max));
        // Entries of components that do not couple are rounding errors themselves, relative to the
        // diagonal.
        let own = |k: usize| stiffness[k * motion.len() + k].max(0.0).sqrt();
        let scale: f64 = (0..motion.len()).map(|k| own(k) * if k % 6 < 3 { shift } else { turn }).sum();
        stiffness.chunks_exact(motion.len()).enumerate().any(|(k, row)| {
            let force: f64 = row.iter().zip(motion).map(|(entry, part)| entry * part).sum();
            force.abs() > ROUNDING * own(k) * scale
        })
    })
}
