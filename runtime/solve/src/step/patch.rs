//! Contact patch of a solved position: teeth, cells and forces.

use super::friction;
use calyx_contact::grid::{Cell, pressures};
use calyx_contact::load_boundary::participations;
use calyx_contact::pressure::{Peak, half_width, peak};
use calyx_contact::zone::{self, Edges, FlankEnds, Zone};
use calyx_contact::{ContactFrame, solid};
use calyx_numerics::vec3::{cross, dot, minus};
use std::ops::Range;

/// Pair of tooth surfaces in (possible) contact at a position.
#[derive(Clone, Debug)]
pub struct ContactPatch {
    /// Index of the surface pair in the scene.
    pub pair: usize,
    /// Tooth of each body.
    pub teeth: [u32; 2],
    /// Surface of each body.
    pub surfaces: [u32; 2],
    /// Position and cells of the patch; no cells without pressure.
    pub grid: ContactGrid,
    /// Force by cell: N, in a plane model N per metre of face width.
    pub forces: Vec<f64>,
    /// Friction force on the first body per unit normal force, by cell, along ground axes; empty
    /// without friction.
    pub friction_vectors: Vec<[f64; 3]>,
}

/// Cells of a patch with their frame.
#[derive(Clone, Debug)]
pub enum ContactGrid {
    /// Cells along the common tangent.
    Plane {
        /// Position of the patch, and its common normal.
        frame: ContactFrame,
        /// Intervals of the tangent.
        cells: Vec<Cell>,
        /// Ends of the flanks.
        flank: FlankEnds,
        /// Hertzian half-width of a line load of 1 N/m, m.
        unit_half_width: f64,
    },
    /// Cells on the common tangent plane.
    Solid(solid::Grid),
}

impl ContactPatch {
    /// Returns the normal force: N, in a plane model N per metre of face width.
    pub fn force(&self) -> f64 {
        self.forces.iter().sum()
    }

    /// Returns the cells of a plane patch; none for a three-dimensional one.
    pub fn cells(&self) -> &[Cell] {
        match &self.grid {
            ContactGrid::Plane { cells, .. } => cells,
            ContactGrid::Solid(_) => &[],
        }
    }

    /// Returns the grid of a three-dimensional patch; `None` for a plane one.
    pub fn solid(&self) -> Option<&solid::Grid> {
        match &self.grid {
            ContactGrid::Plane { .. } => None,
            ContactGrid::Solid(grid) => Some(grid),
        }
    }

    /// Returns the mean pressure on each cell, Pa.
    pub fn pressures(&self) -> Vec<f64> {
        match &self.grid {
            ContactGrid::Plane { cells, .. } => pressures(cells, &self.forces),
            ContactGrid::Solid(grid) => solid::pressures(&grid.cells, &self.forces),
        }
    }

    /// Returns the cells of each row across the patch: of each slice, or all of a plane patch.
    fn rows(&self) -> Vec<Range<usize>> {
        match &self.grid {
            ContactGrid::Plane { cells, .. } => std::iter::once(0..cells.len()).collect(),
            ContactGrid::Solid(grid) => grid.slices.iter().map(|slice| slice.cells.clone()).collect(),
        }
    }

    /// Returns the participation of each cell in the tangent stiffness of the patch, from 0 to 1.
    pub(super) fn participations(&self, is_active: impl Fn(usize) -> bool) -> Vec<f64> {
        participations(self.rows(), &self.pressures(), is_active)
    }

    /// Returns the largest pressure, from a parabola through the squares of neighbouring pressures
    /// across the patch, which is exact for Hertzian contact; `None` without load.
    pub fn peak(&self) -> Option<Peak> {
        match &self.grid {
            ContactGrid::Plane { cells, .. } => peak(cells, &self.pressures()),
            ContactGrid::Solid(grid) => {
                let solid::Peak { pressure, at: [x, _], cell } = solid::peak(grid, &self.pressures())?;
                Some(Peak { pressure, x, cell })
            }
        }
    }

    /// Returns the largest pressure in a zone; `None` if no cell of it is loaded.
    pub fn peak_in(&self, zone: Zone) -> Option<Peak> {
        match &self.grid {
            ContactGrid::Plane { cells, flank, unit_half_width, .. } => {
                let half_width = unit_half_width * self.force().max(0.0).sqrt();
                // Cell coordinates have their origin at the closest approach.
                zone.peak(cells, &self.pressures(), &Edges::parallel(*flank, 0.0), half_width)
            }
            ContactGrid::Solid(grid) => {
                let solid::Peak { pressure, at: [x, _], cell } =
                    solid::peak_in(grid, &self.pressures(), zone)?;
                Some(Peak { pressure, x, cell })
            }
        }
    }

    /// Returns the zone of each cell by its centre; `None` for cells next to a side face, in which
    /// [`ContactPatch::peak_in`] finds no peak.
    pub fn zones(&self) -> Vec<Option<Zone>> {
        match &self.grid {
            ContactGrid::Plane { cells, flank, unit_half_width, .. } => {
                let half_width = unit_half_width * self.force().max(0.0).sqrt();
                let edges = Edges::parallel(*flank, 0.0);
                let zones = zone::of_cells(cells, &self.pressures(), &edges, half_width);
                zones.into_iter().map(Some).collect()
            }
            ContactGrid::Solid(grid) => solid::zones(grid, &self.pressures()),
        }
    }

    /// Returns the loaded half-width of a plane patch, m, from the zeros of such a parabola; `None`
    /// with fewer than five loaded cells.
    pub fn half_width(&self) -> Option<f64> {
        half_width(self.cells(), &self.pressures())
    }

    /// Returns the point of action of a cell, in ground coordinates, m.
    fn point(&self, cell: usize) -> [f64; 3] {
        match &self.grid {
            ContactGrid::Plane { frame, .. } => [frame.point[0], frame.point[1], 0.0],
            ContactGrid::Solid(grid) => grid.cells[cell].point,
        }
    }

    /// Returns the force of the patch on the body of a side and its moment about `origin` (m),
    /// along ground axes: N and N m, in the order of [`calyx_model::dof::DOF_NAMES`]. `width` is
    /// that of a plane model's face, m, and 1 in three dimensions.
    pub fn wrench(&self, side: usize, origin: [f64; 3], width: f64) -> [f64; 6] {
        let mut wrench = match &self.grid {
            ContactGrid::Plane { frame, .. } => {
                let force = width * self.force();
                let [x, y] = [[1.0, 0.0], [0.0, 1.0]].map(|axis| force * frame.translation_arm(side, axis));
                [x, y, 0.0, 0.0, 0.0, force * frame.rotation_arm(side, [origin[0], origin[1]])]
            }
            ContactGrid::Solid(grid) => {
                let mut wrench = [0.0; 6];
                for (cell, &force) in grid.cells.iter().zip(&self.forces).filter(|(_, force)| **force != 0.0)
                {
                    for (component, sum) in wrench.iter_mut().enumerate() {
                        let action = grid.frame.action(cell.slope);
                        *sum += force * solid_arm(action, side, component, &GROUND, origin, cell.point);
                    }
                }
                wrench
            }
        };
        for (cell, (friction_vectors, &force)) in self.friction_vectors.iter().zip(&self.forces).enumerate() {
            for (component, sum) in wrench.iter_mut().enumerate() {
                *sum += width
                    * force
                    * friction::work(*friction_vectors, side, component, &GROUND, origin, self.point(cell));
            }
        }
        wrench
    }
}

/// Ground axes.
const GROUND: [[f64; 3]; 3] = solid::Pose::IDENTITY.rotation;

/// Returns the growth of the gap at `point` by a component of a body's motion, in the order of
/// [`calyx_model::dof::DOF_NAMES`], along `axes`: m per m, or m per rad about one of them through
/// `origin`. `action` is the direction of the force out of the first body.
pub(super) fn solid_arm(
    action: [f64; 3],
    side: usize,
    component: usize,
    axes: &[[f64; 3]; 3],
    origin: [f64; 3],
    point: [f64; 3],
) -> f64 {
    let axis = axes[component % 3];
    let direction = if component < 3 { axis } else { cross(axis, minus(point, origin)) };
    let along = dot(action, direction);
    if side == 0 { -along } else { along }
}
