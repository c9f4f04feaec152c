//! Bearings: what connects bodies to each other and to ground besides contact (report, section 3.1.8).
//!
//! A bearing has two races, each a rigid part of a body or of ground. Its *deflection* x is how far the first race has moved against the
//! second: three displacements of the bearing's origin and three turns, along and about the bearing's axes. The second race is pushed by
//! `f = K (x - x0) - f_ext` and the first one by as much the other way, so that K takes load and motion as an unloaded deformation x0 and
//! a load f_ext of its own would have it. Stops add unilateral springs: where `delta + a . x` would be negative a force along a opposes it.
//!
//! The bearing's origin and z axis lie on the first body: `at` in the coordinates of its frame, and that frame's z axis. Its x and y
//! axes do not turn with the first body: they belong to the second race, being that frame's (or ground's) x axis, made square to z, and
//! what completes them. So a shaft turns in a bearing whose housing has a stiffer side, and the side stays where it is; the pin of a planet
//! goes round with its carrier. With an axisymmetric matrix it makes no difference. Both races have to keep their origin and axis in
//! common: the first body may only turn about the bearing's axis, as seen from the second.

mod placed;
mod springs;

pub use placed::Placed;
pub use springs::{Springs, damping, springs};

use crate::body::Body;
use crate::freedom::FREEDOMS;
use crate::ids::BodyId;
use calyx_numerics::error::EngineError;
use nalgebra::{Matrix6, SymmetricEigen};
use std::f64::consts::TAU;

/// Row by row, in the order of [`FREEDOMS`]: N/m, N (per rad, or N m per m) and N m/rad for stiffness, these times s for damping.
pub type BearingMatrix = [[f64; 6]; 6];

/// What carries the second race of a bearing.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Support {
    /// What does not move.
    Ground,
    /// Another body.
    Body(BodyId),
}

/// A bearing between a body and ground or another body.
#[derive(Clone, Debug, PartialEq)]
pub struct Bearing {
    /// What results and messages call it.
    pub name: String,
    /// Carries the first race.
    pub body: BodyId,
    /// Carries the second race.
    pub to: Support,
    /// The bearing's origin in the coordinates of the first body's frame, m. It lies on the axis about which that body turns.
    pub at: [f64; 3],
    /// K, symmetric and positive semidefinite.
    pub stiffness: BearingMatrix,
    /// C, the same of rates, which a quasi-static analysis leaves out.
    pub damping: BearingMatrix,
    /// x0, the deflection at which the springs bear nothing: m and rad.
    pub unloaded: [f64; 6],
    /// f_ext, what pushes the first race away from the second besides: N and N m.
    pub load: [f64; 6],
    /// What the bearing bears beyond clearances.
    pub stops: Vec<Stop>,
}

/// A clearance, and the spring that is met where it is used up.
#[derive(Clone, Debug, PartialEq)]
pub enum Stop {
    /// `clearance + direction . x >= 0` (report, eq. 3.4): one wall.
    Wall {
        /// delta; negative where the wall presses from the beginning. m if the direction's displacements are pure numbers.
        clearance: f64,
        /// a, by freedom: of displacements 1, of turns m.
        direction: [f64; 6],
        /// Of the wall, N/m.
        stiffness: f64,
    },
    /// The displacement across the axis is at most `clearance`, in whichever direction: a ring.
    Ring {
        /// From the middle outwards, m.
        clearance: f64,
        /// Of the ring on its seat, N/m: the same in all directions.
        stiffness: f64,
    },
}

/// A ring is a polygon of so many walls with its corners on the circle, two of them on each axis. A load that is not exactly square to a
/// wall presses into a corner, so the clearance is exact; its direction is right to half a side, 2.8 degrees.
const SIDES: usize = 64;
/// The walls of a ring have this part of its compliance each for themselves, so that no three of them share a load at a corner in no
/// determined way; the rest of it is the seat's, which they have in common.
const OWN: f64 = 1e-6;

/// Rows of a stop's gap equations and the compliance between them.
pub struct Walls {
    /// Clearance and direction of each.
    pub rows: Vec<(f64, [f64; 6])>,
    /// m/N, row-major.
    pub compliance: Vec<f64>,
}

impl Stop {
    /// Returns the gap equations of the stop and the compliance between them.
    pub fn walls(&self) -> Walls {
        match *self {
            Stop::Wall { clearance, direction, stiffness } => {
                Walls { rows: vec![(clearance, direction)], compliance: vec![stiffness.recip()] }
            }
            Stop::Ring { clearance, stiffness } => {
                let angle = |side: usize| TAU * (side as f64 + 0.5) / SIDES as f64;
                let depth = clearance * (0.5 * TAU / SIDES as f64).cos();
                let wall = |side: usize| {
                    let (sine, cosine) = angle(side).sin_cos();
                    (depth, [-cosine, -sine, 0.0, 0.0, 0.0, 0.0])
                };
                // A ring on a seat that gives alike in all directions: pushed along one wall's normal, another one moves by the cosine
                // between them.
                let of = |entry: usize| {
                    let (one, other) = (entry / SIDES, entry % SIDES);
                    let between = TAU * (one.abs_diff(other) as f64) / SIDES as f64;
                    let own = if one == other { OWN } else { 0.0 };
                    ((1.0 - OWN) * between.cos() + own) / stiffness
                };
                Walls {
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

    /// Whether it presses where nothing has moved.
    fn presses_at_rest(&self) -> bool {
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

/// A matrix that is the same whichever way the bearing is turned about its axis: across it, along it, against tilting, against turning
/// about it. Units as [`BearingMatrix`].
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
    /// A bearing of this stiffness on ground at a place on the body's axis (m from its frame's origin).
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
        }
    }

    /// The bearing with its second race on a body.
    pub fn between(mut self, other: BodyId) -> Bearing {
        self.to = Support::Body(other);
        self
    }

    /// The bodies it connects, the first race's before the second's.
    pub fn bodies(&self) -> impl Iterator<Item = BodyId> {
        let second = match self.to {
            Support::Ground => None,
            Support::Body(body) => Some(body),
        };
        [Some(self.body), second].into_iter().flatten()
    }

    /// How many gap equations its stops are.
    pub fn walls(&self) -> usize {
        self.stops.iter().map(Stop::count).sum()
    }

    /// Whether it bears nothing where nothing has moved.
    pub fn is_unloaded_at_rest(&self) -> bool {
        let still = self.unloaded.iter().chain(&self.load).all(|&entry| entry == 0.0);
        still && !self.stops.iter().any(Stop::presses_at_rest)
    }

    /// Whether it can be had on these bodies, beside these other bearings.
    ///
    /// # Errors
    /// E0685: both races are on one body; E0686: a matrix is not symmetric, or gives energy; E0687: the races do not stay together;
    /// E0688: a stop has no stiffness or no direction; E0653: the scene has no such body; E0671: it has a bearing of that name; E0710: a
    /// frame is not a number.
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
        placed::check_races(bodies, self)
    }
}

/// Asymmetry and negative eigenvalues beyond this, beside what the diagonal says of size, are no rounding of printed digits.
const ROUNDING: f64 = 1e-6;

/// What is wrong with a matrix, and what to do.
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
                    FREEDOMS[i], FREEDOMS[j]
                );
                return Err((message, SYMMETRIC));
            }
        }
    }
    const ENERGY: &str = "a bearing takes up energy in every motion, so no eigenvalue of its matrix is negative; look at the signs of entries off the diagonal";
    // In units in which every freedom is as stiff as every other.
    let scaled = |i: usize, j: usize| {
        let (value, scale) = (matrix[i][j], size[i] * size[j]);
        if value == 0.0 { 0.0 } else { value / scale }
    };
    if let Some(k) = (0..6).find(|&k| matrix[k][k] < 0.0) {
        return Err((format!("gives energy: its entry for {} is negative", FREEDOMS[k]), ENERGY));
    }
    if let Some(k) = (0..6).find(|&k| size[k] == 0.0 && matrix[k].iter().any(|&entry| entry != 0.0)) {
        let message =
            format!("gives energy: {} is coupled to others but has no stiffness itself", FREEDOMS[k]);
        return Err((message, ENERGY));
    }
    let eigen = SymmetricEigen::new(Matrix6::from_fn(|i, j| 0.5 * (scaled(i, j) + scaled(j, i))));
    let (least, at) = (0..6).fold((f64::INFINITY, 0), |(least, at), k| {
        if eigen.eigenvalues[k] < least { (eigen.eigenvalues[k], k) } else { (least, at) }
    });
    if least < -ROUNDING {
        let motion = eigen.eigenvectors.column(at);
        let parts: Vec<&str> = (0..6).filter(|&k| motion[k].abs() > 0.1).map(|k| FREEDOMS[k]).collect();
        return Err((
            format!("has a negative eigenvalue: moved in {}, it gives energy", parts.join(" and ")),
            ENERGY,
        ));
    }
    Ok(())
}
