//! Surfaces that may touch: how contact between them is discretised, and what makes two of them a gear mesh.

use crate::ids::{BodyId, PairId};
use std::f64::consts::TAU;

/// Two surfaces that may touch: surface `surfaces[0]` of every tooth of the first body and `surfaces[1]` of the second.
#[derive(Clone)]
pub struct SurfacePair {
    /// The two bodies.
    pub bodies: [BodyId; 2],
    /// Index of the surface of each, as its [`Structure`](calyx_structure::Structure) counts them.
    pub surfaces: [u32; 2],
    /// How contact between them is discretised.
    pub grid: GridOptions,
    /// Coefficient of friction: beside its pressure a surface that slides carries this part of it, against the sliding of the prescribed
    /// motions.
    pub friction: f64,
    /// Present when the two bodies are gears in mesh.
    pub mesh: Option<GearMesh>,
    /// Of the surfaces on the back sides of teeth, the pair of those that drive: both are one mesh, with one transmission error.
    pub front: Option<PairId>,
}

impl SurfacePair {
    /// Two surfaces that are no gears', with the default grid and without friction.
    pub fn new(bodies: [BodyId; 2], surfaces: [u32; 2]) -> SurfacePair {
        SurfacePair { bodies, surfaces, grid: GridOptions::default(), friction: 0.0, mesh: None, front: None }
    }
}

/// The contact grid of a surface pair.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GridOptions {
    /// M: a grid has 2M + 1 cells across before refinement at edges; `None` takes what suits the fidelity, see
    /// [`GridOptions::half_cells_in_space`].
    pub half_cells: Option<usize>,
    /// N: in space a grid has 2N + 1 slices along the face.
    pub half_slices: usize,
    /// Total width, m; `None` takes it from the Hertz half-width under the full load.
    pub width: Option<f64>,
    /// Search for contact on rounded edges and beyond the nominal path of contact. Otherwise surfaces end sharply at
    /// their nominal ends, and gear teeth touch on the nominal path only, even where a relief would let them touch a
    /// little before and after.
    pub edges: bool,
}

impl GridOptions {
    /// M in the plane, where a cell costs little.
    pub fn half_cells_in_plane(&self) -> usize {
        self.half_cells.unwrap_or(24)
    }

    /// M in space, where every cell is there once for each slice: peaks of pressure are right to a few thousandths by it.
    pub fn half_cells_in_space(&self) -> usize {
        self.half_cells.unwrap_or(10)
    }
}

impl Default for GridOptions {
    fn default() -> Self {
        GridOptions { half_cells: None, half_slices: 8, width: None, edges: true }
    }
}

/// What makes a surface pair a gear mesh: enough to speak of transmission error and of its cycle.
#[derive(Clone, Debug, PartialEq)]
pub struct GearMesh {
    /// Numbers of teeth.
    pub teeth: [u32; 2],
    /// m.
    pub base_radii: [f64; 2],
    /// +1 if the first body pushes counter-clockwise, -1 if clockwise.
    pub drive_sense: f64,
    /// +1 external, -1 internal: a positive turn of the first body turns the second by `-sign`.
    pub sign: f64,
    /// Teeth of the pair that enters contact at the start of the cycle.
    pub entering: [u32; 2],
    /// Time at which it does, s.
    pub start: f64,
    /// Time of one pitch, s.
    pub period: f64,
    /// The characteristic points of the path of contact, in order of time.
    pub characteristic: Vec<CharacteristicPoint>,
    /// Roll angle of the entering pair's first tooth at the start and at the end of the cycle, rad.
    pub roll: [f64; 2],
    /// The nominal path of contact: least and greatest roll angle of the first gear, rad.
    pub path: [f64; 2],
    /// Roll angle of the first gear's tooth 0, were it in contact, where that gear's angle is zero and the line of centres is where it is
    /// at time 0, rad.
    pub roll_at_zero: f64,
    /// How fast the line of centres turns at time 0, rad/s: of a planet, with its carrier. 0 where both axes rest.
    pub orbit: f64,
    /// How far the second gear would have to turn, from where it is meant to be, for rigid teeth to touch, rad. Of a mesh that phased a gear
    /// there is none; one that closes a loop may stand off by what axes are out of place and teeth too thin.
    pub stand_off: f64,
}

impl GearMesh {
    /// Whether a tooth of the first gear, whose body stands at `angle` (with its phase, less what the line of centres has turned since time
    /// 0), is on the nominal path of contact.
    pub fn on_path(&self, tooth: u32, angle: f64) -> bool {
        let turned = angle + TAU * f64::from(tooth) / f64::from(self.teeth[0]);
        let roll = self.roll_at_zero + self.drive_sense * turned;
        // Of all whole turns, the one that brings the tooth nearest to the middle of the path.
        let middle = 0.5 * (self.path[0] + self.path[1]);
        let roll = roll - TAU * ((roll - middle) / TAU).round();
        (self.path[0]..=self.path[1]).contains(&roll)
    }
}

/// A point of the path of contact where a pair of teeth enters or leaves, so that the load jumps on rigid teeth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CharacteristicPoint {
    /// `SAP` and `EAP`, start and end of active profile; `LPSTC` and `HPSTC`, lowest and highest point of single-tooth
    /// contact.
    pub name: &'static str,
    /// s from the start of the cycle.
    pub time: f64,
    /// Whether the position of interest is just after the jump, or just before it.
    pub after: bool,
}
