//! Cells that resist small motions about an equilibrium.

use super::StepResult;
use faer::Mat;

/// Cells and stops with their participation in the tangent stiffness.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Participating {
    /// Indices in the contact problem, ascending.
    pub cells: Vec<usize>,
    /// Participation of each, above 0 and up to 1, for
    /// [`calyx_contact::load_boundary::added_compliances`].
    pub participations: Vec<f64>,
}

impl StepResult {
    /// Returns the cells and stops of the contact problem that resist small motions, out of those
    /// that are wanted. Besides the active set these are cells next to it that the load reaches in
    /// part.
    pub fn participating(&self, is_wanted: impl Fn(usize) -> bool) -> Participating {
        let mut is_active = vec![false; self.problem.cells()];
        self.active.iter().for_each(|&cell| is_active[cell] = true);
        let mut all: Vec<f64> = is_active.iter().map(|&active| f64::from(u8::from(active))).collect();
        let mut first = 0;
        for patch in &self.patches {
            let own = patch.participations(|cell| is_active[first + cell]);
            all[first..first + own.len()].copy_from_slice(&own);
            first += patch.forces.len();
        }
        let cells: Vec<usize> = (0..all.len()).filter(|&cell| all[cell] > 0.0 && is_wanted(cell)).collect();
        let participations = cells.iter().map(|&cell| all[cell]).collect();
        Participating { cells, participations }
    }

    /// Returns the compliance matrix of some cells, m/N, in a plane model per metre of face width.
    pub fn compliance_of(&self, cells: &[usize]) -> Mat<f64> {
        let n = self.problem.cells();
        Mat::from_fn(cells.len(), cells.len(), |i, j| self.problem.compliance[cells[i] * n + cells[j]])
    }
}
