//! Surface pairs: surfaces that may come into contact, their contact grids and their gear mesh
//! data.

use crate::ids::{BodyId, PairId};
use crate::lubrication::Lubrication;
use std::f64::consts::TAU;

/// Two surfaces that may come into contact: surface `surfaces[0]` of every tooth of the first body
/// and `surfaces[1]` of every tooth of the second.
#[derive(Clone)]
pub struct SurfacePair {
    /// The two bodies.
    pub bodies: [BodyId; 2],
    /// Index of the surface of each body, as numbered by its
    /// [`Structure`](calyx_structure::Structure).
    pub surfaces: [u32; 2],
    /// Discretization of the contact.
    pub grid: GridOptions,
    /// Coefficient of friction: a sliding surface carries a traction of this fraction of its
    /// pressure, opposite to the sliding velocity of the prescribed motions.
    pub friction: f64,
    /// Gear mesh data, if the two bodies are gears in mesh.
    pub mesh: Option<GearMesh>,
    /// Pair of the drive flanks, if this pair consists of the coast flanks; `None` otherwise. Both
    /// belong to one mesh with one transmission error.
    pub front: Option<PairId>,
    /// Lubrication, for observables of friction, temperature and film thickness; it does not affect
    /// the solution.
    pub lubrication: Option<Lubrication>,
}

impl SurfacePair {
    /// Creates a pair of surfaces that are not gear flanks, with the default grid and without
    /// friction.
    pub fn new(bodies: [BodyId; 2], surfaces: [u32; 2]) -> SurfacePair {
        SurfacePair {
            bodies,
            surfaces,
            grid: GridOptions::default(),
            friction: 0.0,
            mesh: None,
            front: None,
            lubrication: None,
        }
    }
}

/// Options of the contact grid of a surface pair.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GridOptions {
    /// M: a grid has 2M + 1 cells across the contact line before refinement at edges. `None` uses
    /// the default of the fidelity, see [`GridOptions::solid_half_cells`].
    pub half_cells: Option<usize>,
    /// N: a three-dimensional grid has 2N + 1 slices along the face.
    pub half_slices: usize,
    /// Total width, m. `None` derives it from the Hertzian half-width under the full load.
    pub width: Option<f64>,
    /// Enables contact on rounded edges and outside the nominal path of contact. If false, surfaces
    /// end sharply at their nominal ends, and gear teeth touch only on the nominal path, even where
    /// tip relief would extend the contact slightly beyond it.
    pub edges: bool,
}

impl GridOptions {
    /// Former name of [`GridOptions::plane_half_cells`].
    #[deprecated(since = "0.1.0", note = "use `plane_half_cells`")]
    pub fn half_cells_in_plane(&self) -> usize {
        self.plane_half_cells()
    }

    /// Former name of [`GridOptions::solid_half_cells`].
    #[deprecated(since = "0.1.0", note = "use `solid_half_cells`")]
    pub fn half_cells_in_space(&self) -> usize {
        self.solid_half_cells()
    }

    /// Returns M of two-dimensional models, where a cell costs little.
    pub fn plane_half_cells(&self) -> usize {
        self.half_cells.unwrap_or(24)
    }

    /// Returns M of three-dimensional models, where each slice has its own cells. The relative
    /// error of peak pressures is a few thousandths.
    pub fn solid_half_cells(&self) -> usize {
        self.half_cells.unwrap_or(10)
    }
}

impl Default for GridOptions {
    fn default() -> Self {
        GridOptions { half_cells: None, half_slices: 8, width: None, edges: true }
    }
}

/// Gear mesh data of a surface pair, sufficient for the transmission error and the mesh cycle.
#[derive(Clone, Debug, PartialEq)]
pub struct GearMesh {
    /// Numbers of teeth.
    pub teeth: [u32; 2],
    /// Base radii, m. On general axes, the moment arms of the common normal at the
    /// [`GearMesh::first_contact`] about the two axes: force along the normal times arm is torque.
    pub base_radii: [f64; 2],
    /// +1 if the first body drives counter-clockwise, -1 if it drives clockwise.
    pub drive_sense: f64,
    /// +1 for external, -1 for internal meshes: a positive rotation of the first body rotates the
    /// second by `-sign`. On general axes it follows from the directions of the axes.
    pub sign: f64,
    /// Teeth of the pair that enters contact at the start of the mesh cycle.
    pub entering: [u32; 2],
    /// Start of the mesh cycle, s.
    pub start: f64,
    /// Duration of the mesh cycle (one pitch), s.
    pub period: f64,
    /// Characteristic points of the path of contact, in order of time.
    pub characteristic: Vec<CharacteristicPoint>,
    /// Roll angles of the first gear's tooth of the entering pair at the start and at the end of
    /// the cycle, rad. On general axes, the rotation of the first gear in its drive sense from the
    /// position at which this pair enters contact.
    pub roll: [f64; 2],
    /// Nominal path of contact: least and greatest roll angle of the first gear, rad, with the
    /// overlap of helical teeth. On general axes, that of unloaded contact between the flanks of
    /// one pair of teeth.
    pub path: [f64; 2],
    /// Overlap ratio: common face width in axial pitches; 0 for spur teeth.
    pub overlap_ratio: f64,
    /// Rotation of the first gear's transverse section per length along z, rad/m: positive for a
    /// right-hand helix, 0 for spur teeth and on general axes.
    pub twist: f64,
    /// Roll angle of the contact on tooth 0 of the first gear (extrapolated if out of contact) at
    /// gear angle 0 and with the line of centres in its position at time 0, rad.
    pub roll_at_zero: f64,
    /// Angular velocity of the carrier of both axes at time 0, along ground axes, rad/s: that of
    /// the line of centres of parallel axes. Zero if both axes are fixed.
    pub carrier: [f64; 3],
    /// Angle, not a distance: rotation of the second gear from its prescribed position that brings
    /// rigid teeth into contact, rad. Zero for a mesh that determined the phase of a gear. A mesh
    /// that closes a loop may have a gap due to misplaced axes and thin teeth.
    pub phase_offset: f64,
    /// Contact of rigid flanks at time 0, of gears on general axes; `None` for involute gears on
    /// parallel axes, whose contact follows from the base radii.
    pub first_contact: Option<FirstContact>,
}

/// Contact of rigid flanks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FirstContact {
    /// Point of contact in ground coordinates, m.
    pub point: [f64; 3],
    /// Common unit normal, out of the first gear.
    pub normal: [f64; 3],
}

impl GearMesh {
    /// Former name of the field [`GearMesh::phase_offset`].
    #[deprecated(since = "0.1.0", note = "use the field `phase_offset`")]
    pub fn center_offset(&self) -> f64 {
        self.phase_offset
    }

    /// Returns the transverse contact ratio: length of the nominal path of contact at one
    /// transverse section, in pitches.
    pub fn transverse_contact_ratio(&self) -> f64 {
        (self.path[1] - self.path[0]) * f64::from(self.teeth[0]) / TAU - self.overlap_ratio
    }

    /// Returns whether a tooth of the first gear is on the nominal path of contact. `angle` is the
    /// angle of the gear's body, including its phase, minus the rotation of the line of centres
    /// since time 0.
    pub fn on_path(&self, tooth: u32, angle: f64) -> bool {
        let turned = angle + TAU * f64::from(tooth) / f64::from(self.teeth[0]);
        let roll = self.roll_at_zero + self.drive_sense * turned;
        // Choose the whole revolution that brings the tooth nearest to the middle of the path.
        let middle = 0.5 * (self.path[0] + self.path[1]);
        let roll = roll - TAU * ((roll - middle) / TAU).round();
        (self.path[0]..=self.path[1]).contains(&roll)
    }
}

/// Point of the path of contact where a tooth pair enters or leaves contact. The load on rigid
/// teeth jumps there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CharacteristicPoint {
    /// `SAP` and `EAP`: start and end of active profile; `LPSTC` and `HPSTC`: lowest and highest
    /// point of single tooth contact.
    pub name: &'static str,
    /// Time since the start of the mesh cycle, s.
    pub time: f64,
    /// True if the position of interest is just after the jump, false if it is just before.
    pub after: bool,
}
