//! Bearings: linear connections between bodies, or between a body and ground, with optional stops
//! (report, section 3.1.8).
//!
//! A bearing has two races, each a rigid part of a body or of ground. Its *deflection* x is the
//! motion of the first race relative to the second: three displacements of the bearing's origin and
//! three rotations, along and about the bearing's axes. The force `f = K (x - x0) - f_ext` acts on
//! the second race, its opposite on the first. x0 is the deflection at which the springs carry no
//! load, and f_ext an additional load. Stops add unilateral springs: where `delta + a . x` would be
//! negative, a force along a opposes it.
//!
//! The origin and the z axis of the bearing belong to the first body: the origin is `at` in the
//! coordinates of its frame, and z is the z axis of that frame. The x axis belongs to the second
//! race: it is the x axis of that body's frame (or of ground), projected normal to z; y completes
//! the triad. Hence a shaft rotates in a bearing whose anisotropic housing remains fixed, and a
//! planet pin's directions rotate with the carrier. An axisymmetric matrix does not depend on this
//! choice. Both races must keep their origin and axis in common: relative to the second body, the
//! first may only rotate about the bearing's axis.
//!
//! See `docs/theory/bearings.md`.

mod bearing_state;
mod immobile;
mod linearization;
mod load_curve;
mod nonlinear;
mod nonlinear_state;
mod raceway;
mod rolling;
mod springs;
mod surface;
mod tangent;

pub use bearing_state::BearingState;
pub use immobile::Mobility;
pub use linearization::{Linearization, RANGE_TOLERANCE};
pub use load_curve::{LoadCurve, LoadCurves};
pub use nonlinear::NonlinearLoad;
pub use nonlinear_state::NonlinearState;
pub use raceway::{
    BodyRaceway, ElasticRaceways, HalfSpaceShare, PlacedRaceway, PositionOnCylinder, RacewayCylinder,
    RacewayOwner, SeatTerms, by_element, half_space_share, half_space_shares,
};
pub use rolling::{RollingElements, five, rejected};
pub use springs::{Springs, damping, springs};
pub use surface::marker;
pub use tangent::{RacewayTangent, Tangent};

pub use calyx_rolling::{RacewayDisplacement, Ring};

use crate::body::Body;
use crate::dof::DOF_NAMES;
use crate::ids::BodyId;
use calyx_numerics::error::EngineError;
use nalgebra::{Matrix6, SymmetricEigen};
use std::f64::consts::TAU;

/// Bearing matrix by rows, in the order of [`DOF_NAMES`]. Units of stiffness: N/m, N (per rad, or N
/// m per m) and N m/rad; damping: these times s.
pub type BearingMatrix = [[f64; 6]; 6];

/// Carrier of the second race of a bearing.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Support {
    /// Ground.
    Ground,
    /// Another body.
    Body(BodyId),
}

/// Bearing between a body and ground or another body.
#[derive(Clone, Debug, PartialEq)]
pub struct Bearing {
    /// Name in results and messages.
    pub name: String,
    /// Body of the first race.
    pub body: BodyId,
    /// Body or ground of the second race.
    pub to: Support,
    /// Origin of the bearing in the coordinates of the first body's frame, m. It lies on the axis
    /// of rotation of that body.
    pub at: [f64; 3],
    /// K, the stiffness matrix, symmetric and positive semidefinite.
    pub stiffness: BearingMatrix,
    /// C, the damping matrix. Quasi-static analyses ignore it.
    pub damping: BearingMatrix,
    /// x0, the deflection at which the springs carry no load, m and rad.
    pub unloaded: [f64; 6],
    /// f_ext, additional load that pushes the first race away from the second, N and N m.
    pub load: [f64; 6],
    /// Stops: unilateral springs behind clearances.
    pub stops: Vec<Stop>,
    /// Nonlinear load, which adds to that of the springs and stops.
    pub nonlinear: Option<NonlinearLoad>,
    /// Operating point of a rolling bearing whose linearized load is `stiffness` and `load`.
    pub linearization: Option<Linearization>,
}

/// Unilateral spring with a clearance.
#[derive(Clone, Debug, PartialEq)]
pub enum Stop {
    /// One wall: `clearance + direction . x >= 0` (report, eq. 3.4).
    Wall {
        /// delta; negative for a preloaded wall. Its unit is m if the direction's coefficients of
        /// displacements are dimensionless.
        clearance: f64,
        /// a, by DOF: dimensionless for displacements, m for rotations.
        direction: [f64; 6],
        /// Stiffness of the wall, N/m.
        stiffness: f64,
    },
    /// Ring: the radial displacement is at most `clearance` in all directions.
    Ring {
        /// Radial clearance, m.
        clearance: f64,
        /// Stiffness of the seat of the ring, N/m, equal in all directions.
        stiffness: f64,
    },
}

/// Number of walls of a ring, which is a polygon with its corners on the clearance circle and two
/// corners on each axis. A load that is not exactly normal to a wall presses into a corner, so the
/// clearance is exact. The direction of the force is exact to half a side, 2.8 degrees.
const SIDES: usize = 64;
/// Fraction of the compliance of a ring that each wall has separately. Without it, the distribution
/// of a load on three walls at a corner would be indeterminate. The rest of the compliance belongs
/// to the seat, which all walls share.
const OWN: f64 = 1e-6;

/// Gap equations of a stop and the compliance matrix between them.
pub struct StopEquations {
    /// Clearance and direction of each row.
    pub rows: Vec<(f64, [f64; 6])>,
    /// Compliance matrix, m/N, row-major.
    pub compliance: Vec<f64>,
}

impl Stop {
    /// Returns the gap equations of the stop and the compliance between them.
    pub fn walls(&self) -> StopEquations {
        match *self {
            Stop::Wall { clearance, direction, stiffness } => {
                StopEquations { rows: vec![(clearance, direction)], compliance: vec![stiffness.recip()] }
            }
            Stop::Ring { clearance, stiffness } => {
                let angle = |side: usize| TAU * (side as f64 + 0.5) / SIDES as f64;
                let depth = clearance * (0.5 * TAU / SIDES as f64).cos();
                let wall = |side: usize| {
                    let (sine, cosine) = angle(side).sin_cos();
                    (depth, [-cosine, -sine, 0.0, 0.0, 0.0, 0.0])
                };
                // On an isotropic seat, a unit force along the normal of one wall displaces another
                // wall by the cosine of the angle between their normals.
                let of = |entry: usize| {
                    let (one, other) = (entry / SIDES, entry % SIDES);
                    let between = TAU * (one.abs_diff(other) as f64) / SIDES as f64;
                    let own = if one == other { OWN } else { 0.0 };
                    ((1.0 - OWN) * between.cos() + own) / stiffness
                };
                StopEquations {
                    rows: (0..SIDES).map(wall).collect(),
                    compliance: (0..SIDES * SIDES).map(of).collect(),
                }
            }
        }
    }

    fn count(&self) -> usize {
        match self {
            Stop::Wall { .. } => 1,
            Stop::Ring { .. } => SIDES,
        }
    }

    /// Returns whether the stop carries load at zero deflection.
    fn is_preloaded(&self) -> bool {
        matches!(self, Stop::Wall { clearance, .. } if *clearance < 0.0)
    }

    fn check(&self) -> Result<(), EngineError> {
        let (clearance, stiffness, sees) = match *self {
            Stop::Wall { clearance, direction, stiffness } => {
                let finite = direction.iter().all(|entry| entry.is_finite());
                (clearance, stiffness, finite && direction.iter().any(|entry| *entry != 0.0))
            }
            Stop::Ring { clearance, stiffness } => (clearance, stiffness, clearance >= 0.0),
        };
        if clearance.is_finite() && stiffness.is_finite() && stiffness > 0.0 && sees {
            return Ok(());
        }
        Err(EngineError::new(
            "E0688",
            "a clearance of the bearing has no stiffness behind it, no direction, or is not a number",
            "give the positive stiffness that acts once the clearance is closed; for a hard stop, that of the surrounding parts",
        ))
    }
}

/// Returns a matrix that is invariant under rotation about the bearing's axis, from its radial,
/// axial, tilting and torsional coefficients. Units as in [`BearingMatrix`].
pub const fn axisymmetric(radial: f64, axial: f64, tilting: f64, torsional: f64) -> BearingMatrix {
    let mut matrix = [[0.0; 6]; 6];
    matrix[0][0] = radial;
    matrix[1][1] = radial;
    matrix[2][2] = axial;
    matrix[3][3] = tilting;
    matrix[4][4] = tilting;
    matrix[5][5] = torsional;
    matrix
}

impl Bearing {
    /// Returns whether it has a force or moment along or about one of its axes.
    pub fn resists(&self, component: usize) -> bool {
        let mut entries = self.stiffness[component].iter().chain(&self.damping[component]);
        self.nonlinear.is_some() || self.linearization.is_some() || entries.any(|&entry| entry != 0.0)
    }

    /// Creates a bearing to ground with this stiffness, at the axial position `at` on the body's
    /// axis (m from the origin of its frame).
    pub fn new(name: impl Into<String>, body: BodyId, at: f64, stiffness: BearingMatrix) -> Bearing {
        Bearing {
            name: name.into(),
            body,
            to: Support::Ground,
            at: [0.0, 0.0, at],
            stiffness,
            damping: [[0.0; 6]; 6],
            unloaded: [0.0; 6],
            load: [0.0; 6],
            stops: Vec::new(),
            nonlinear: None,
            linearization: None,
        }
    }

    /// Moves the second race to another body.
    pub fn between(mut self, other: BodyId) -> Bearing {
        self.to = Support::Body(other);
        self
    }

    /// Returns the bodies that the bearing connects, that of the first race first.
    pub fn bodies(&self) -> impl Iterator<Item = BodyId> {
        let second = match self.to {
            Support::Ground => None,
            Support::Body(body) => Some(body),
        };
        [Some(self.body), second].into_iter().flatten()
    }

    /// Returns the number of gap equations of the stops.
    pub fn walls(&self) -> usize {
        self.stops.iter().map(Stop::count).sum()
    }

    /// Returns whether the bearing carries no load at zero deflection.
    pub fn is_unloaded_without_motion(&self) -> bool {
        let still = self.unloaded.iter().chain(&self.load).all(|&entry| entry == 0.0);
        let nonlinear = self.nonlinear.as_ref().is_some_and(NonlinearLoad::is_preloaded);
        still && !nonlinear && !self.stops.iter().any(Stop::is_preloaded)
    }

    /// Checks whether these bodies can have this bearing in addition to the other bearings.
    ///
    /// # Errors
    /// - E0653: the scene has no such body.
    /// - E0671: the scene has a bearing of the same name.
    /// - E0685: both races are on one body.
    /// - E0686: a matrix is not symmetric, or is not positive semidefinite.
    /// - E0687: the races do not keep their origin and axis in common.
    /// - E0688: a stop has no stiffness or no direction.
    /// - E0710: a frame is NaN.
    pub fn check(&self, bodies: &[Body], others: &[Bearing]) -> Result<(), EngineError> {
        if others.iter().any(|other| other.name == self.name) {
            let message = format!("there are two bearings called \"{}\"", self.name);
            return Err(EngineError::new(
                "E0671",
                message,
                "results speak of bearings by name; give each its own",
            )
            .blame("name"));
        }
        if self.to == Support::Body(self.body) {
            return Err(EngineError::new(
                "E0685",
                format!("bearing \"{}\" has both races on one body", self.name),
                "give the other body, or leave `to` out: then the second race is on ground",
            )
            .blame("to"));
        }
        for (name, matrix) in [("stiffness", &self.stiffness), ("damping", &self.damping)] {
            check_matrix(matrix).map_err(|(message, help)| {
                EngineError::new("E0686", format!("the {name} of bearing \"{}\" {message}", self.name), help)
            })?;
        }
        let numbers = self.at.iter().chain(&self.unloaded).chain(&self.load);
        if !numbers.copied().all(f64::is_finite) {
            let message = format!("a place or a load of bearing \"{}\" is not a number", self.name);
            return Err(EngineError::new("E0688", message, "look for a division by zero"));
        }
        self.stops.iter().try_for_each(Stop::check)?;
        bearing_state::check_races(bodies, self)
    }
}

/// Tolerance of asymmetry and of negative eigenvalues, relative to the diagonal; covers rounding of
/// printed digits.
const ROUNDING: f64 = 1e-6;

/// Checks a matrix. The error is a pair of problem and remedy.
fn check_matrix(matrix: &BearingMatrix) -> Result<(), (String, &'static str)> {
    const SYMMETRIC: &str = "the matrix is symmetric: entries i, j and j, i are equal";
    if !matrix.iter().flatten().all(|entry| entry.is_finite()) {
        return Err(("has an entry that is not a finite number".into(), "look for a division by zero"));
    }
    let size: [f64; 6] = std::array::from_fn(|k| matrix[k][k].max(0.0).sqrt());
    for i in 0..6 {
        for j in 0..i {
            let (one, other) = (matrix[i][j], matrix[j][i]);
            if (one - other).abs() > ROUNDING * (size[i] * size[j]).max(one.abs().min(other.abs())) {
                let message = format!(
                    "is not symmetric: between {} and {} it has {one} and {other}",
                    DOF_NAMES[i], DOF_NAMES[j]
                );
                return Err((message, SYMMETRIC));
            }
        }
    }
    const ENERGY: &str = "a bearing takes up energy in every motion, so no eigenvalue of its matrix is negative; look at the signs of entries off the diagonal";
    // Scale the DOFs to equal stiffness.
    let scaled = |i: usize, j: usize| {
        let (value, scale) = (matrix[i][j], size[i] * size[j]);
        if value == 0.0 { 0.0 } else { value / scale }
    };
    if let Some(k) = (0..6).find(|&k| matrix[k][k] < 0.0) {
        return Err((format!("gives energy: its entry for {} is negative", DOF_NAMES[k]), ENERGY));
    }
    if let Some(k) = (0..6).find(|&k| size[k] == 0.0 && matrix[k].iter().any(|&entry| entry != 0.0)) {
        let message =
            format!("gives energy: {} is coupled to others but has no stiffness itself", DOF_NAMES[k]);
        return Err((message, ENERGY));
    }
    let eigen = SymmetricEigen::new(Matrix6::from_fn(|i, j| 0.5 * (scaled(i, j) + scaled(j, i))));
    let (least, at) = (0..6).fold((f64::INFINITY, 0), |(least, at), k| {
        if eigen.eigenvalues[k] < least { (eigen.eigenvalues[k], k) } else { (least, at) }
    });
    if least < -ROUNDING {
        let motion = eigen.eigenvectors.column(at);
        let parts: Vec<&str> = (0..6).filter(|&k| motion[k].abs() > 0.1).map(|k| DOF_NAMES[k]).collect();
        return Err((
            format!("has a negative eigenvalue: moved in {}, it gives energy", parts.join(" and ")),
            ENERGY,
        ));
    }
    Ok(())
}
