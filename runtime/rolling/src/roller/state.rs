//! State of a roller, and the sums of its contacts.

use super::strips::{StripLoads, Work};

/// One contact line of a roller.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LineContact {
    /// Contact load, N.
    pub load: f64,
    /// Moment of the load about the middle of the contact line, N m.
    pub moment: f64,
    /// Positions of the laminae or strips from the middle of the contact line, m; away from the
    /// apex of tapered rollers, and towards -z for cylindrical ones.
    pub positions: Vec<f64>,
    /// Loads per length of the laminae or strips, N/m.
    pub loads: Vec<f64>,
    /// Pressures of the laminae or strips, Pa.
    pub pressures: Vec<f64>,
    /// Largest pressure of the laminae or strips, Pa.
    pub pressure: f64,
    /// Position of the largest pressure, m.
    pub pressure_position: f64,
    /// Loads per length of the laminae of ISO/TS 16281 under the load and the moment, N/m, for the
    /// rating life.
    pub laminae: Vec<f64>,
}

/// State of one roller.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RollerState {
    /// Contact with the inner raceway.
    pub inner: LineContact,
    /// Contact with the outer raceway.
    pub outer: LineContact,
    /// Load of the rib, N.
    pub rib: f64,
    /// Displacement of the roller: radial, m; axial, m; rotation from radial to axial, rad.
    pub displacement: [f64; 3],
}

/// Displacement of a roller and the loads of its strips, from which the next equilibrium starts.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct RollerStart {
    pub(super) displacement: Option<[f64; 3]>,
    pub(super) strips: StripLoads,
    /// Displacement between laminae at the same displacement of the ring, if they carry load.
    pub(super) laminae: Option<[f64; 3]>,
}

/// Memory of an equilibrium, and the loads of the strips.
#[derive(Default)]
pub(crate) struct Memory {
    pub strips: StripLoads,
    pub work: Work,
    pub approaches: Vec<f64>,
}

/// Potential energy of a roller with its derivatives with respect to the displacement of the
/// roller.
pub(crate) struct Energy {
    pub energy: f64,
    pub gradient: [f64; 3],
    pub hessian: [[f64; 3]; 3],
    /// Sum of the magnitudes of all forces, N.
    pub scale: f64,
}

/// Forces of all contacts conjugate to the displacements of ring and roller, and their derivatives.
#[derive(Default)]
pub(crate) struct Tangent {
    /// Load on the ring.
    pub force: [f64; 3],
    /// Derivatives of the load with respect to the displacement of the ring.
    pub ring: [[f64; 3]; 3],
    /// Derivatives with respect to the displacement of the roller.
    pub roller: [[f64; 3]; 3],
    /// Mixed derivatives: rows of the roller, columns of the ring.
    pub coupling: [[f64; 3]; 3],
}

impl LineContact {
    /// Adds a lamina or strip: its position, m, load, N, load per length, N/m, and pressure, Pa.
    pub(super) fn add(&mut self, position: f64, load: f64, per_length: f64, pressure: f64) {
        self.load += load;
        self.moment += load * position;
        self.positions.push(position);
        self.loads.push(per_length);
        self.pressures.push(pressure);
        if pressure > self.pressure {
            (self.pressure, self.pressure_position) = (pressure, position);
        }
    }
}

impl Energy {
    /// Potential energy of a radial force, N, at a displacement of the roller.
    pub fn of_force(force: f64, roller: &[f64; 3]) -> Self {
        Self {
            energy: -force * roller[0],
            gradient: [-force, 0.0, 0.0],
            hessian: [[0.0; 3]; 3],
            scale: force.abs(),
        }
    }

    /// Adds a contact with the derivatives of its approach, its load, N, stiffness, N/m, and
    /// energy, N m; of the Hessian the lower triangle.
    #[inline]
    pub fn add(&mut self, approach: &[f64; 3], load: f64, slope: f64, energy: f64) {
        self.energy += energy;
        self.scale += load;
        for i in 0..3 {
            self.gradient[i] += load * approach[i];
            for j in 0..=i {
                self.hessian[i][j] += slope * approach[i] * approach[j];
            }
        }
    }
}
