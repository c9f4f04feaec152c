//! What of a position has a dimension, behind one seam: [`Space`], once in the plane and once in space.

use super::Patch;
use super::drag::Action;
use crate::modal::Modes;
use crate::system::Teeth;
use calyx_contact::problem::ContactProblem;
use calyx_model::mechanism::Mechanism;
use calyx_model::pairs::SurfacePair;
use calyx_numerics::error::EngineError;
use faer::Mat;

/// A pair of teeth that could touch: what is known before anything is solved.
pub(super) struct Candidate<S> {
    pub(super) teeth: Teeth,
    /// Of the profiles, m: what gaps are small or large against.
    pub(super) length: f64,
    /// Where the surfaces come closest.
    pub(super) nearest: Approach,
    /// Further places at which the gap may close; none in the plane.
    pub(super) others: Vec<Approach>,
    /// Where it is, and on what.
    pub(super) site: S,
}

/// A gap that rigid motions open and close.
pub(super) struct Approach {
    /// m; negative where the bodies overlap.
    pub(super) gap: f64,
    /// Growth of the gap by each freedom.
    pub(super) arms: Vec<f64>,
}

impl Approach {
    /// The gap that motions leave, m.
    pub(super) fn opened_by(&self, motion: &[f64]) -> f64 {
        let rigid: f64 = self.arms.iter().zip(motion).map(|(arm, motion)| arm * motion).sum();
        self.gap + rigid
    }

    pub(super) fn closed_by(&self, motion: &[f64]) -> bool {
        self.opened_by(motion) < 0.0
    }
}

impl<S> Candidate<S> {
    pub(super) fn approaches(&self) -> impl Iterator<Item = &Approach> {
        std::iter::once(&self.nearest).chain(&self.others)
    }
}
/// What of a position has a dimension.
pub(super) trait Space {
    /// Where a pair of teeth approach each other.
    type Site;
    /// The cells of a patch.
    type Grid;
    /// How large a grid is.
    type Size: Copy;

    /// Every pair of teeth near enough to face each other, in a fixed order, where bodies are off their prescribed motions by
    /// `moved`, m or rad by freedom.
    fn candidates(&self, time: f64, moved: &[f64]) -> Result<Vec<Candidate<Self::Site>>, EngineError>;

    /// The order of the force that presses surfaces flat that overlap by so much (m), in the unit of loads.
    fn force_of_overlap(&self, candidate: &Candidate<Self::Site>, overlap: f64) -> f64;

    /// Lays the grid of a patch: of the size that is given, else of the model's, else of one that suits the force.
    fn lay(&self, candidate: &Candidate<Self::Site>, force: f64, size: Option<Self::Size>) -> Self::Grid;

    /// How many cells a grid has.
    fn count(&self, grid: &Self::Grid) -> usize;

    /// Its width across, m.
    fn width(&self, grid: &Self::Grid) -> f64;

    /// Whether a grid that should be wider ends on either side because a surface does.
    fn is_cut_off(&self, _grid: &Self::Grid) -> bool {
        false
    }

    /// The gap of each cell, m.
    fn gaps(&self, grid: &Self::Grid) -> Vec<f64>;

    /// Growth of the gap of each cell by each freedom, row by row.
    fn arms(&self, candidate: &Candidate<Self::Site>, grid: &Self::Grid) -> Vec<f64>;

    /// Where cells act, and along which normal: what friction is made of.
    fn action(&self, candidate: &Candidate<Self::Site>, grid: &Self::Grid) -> Action;

    /// The same of the closest approach, where no grid is laid.
    fn approaching(&self, candidate: &Candidate<Self::Site>) -> Action;

    /// Growth of gaps by the forces on cells, see [`ContactProblem::compliance`].
    fn compliance(&self, laid: &[(&Candidate<Self::Site>, &Self::Grid)]) -> Result<Vec<f64>, EngineError>;

    /// Growth of the gap of each cell by the forces on the flanks of all lugs; none in space.
    fn by_lugs(&self, _laid: &[(&Candidate<Self::Site>, &Self::Grid)]) -> Mat<f64> {
        Mat::zeros(0, 0)
    }

    /// Cells that probably carry force, by index in the problem, to begin the search with: no more than time depends on it.
    fn guess(&self, _problem: &ContactProblem, _grids: &[Self::Grid]) -> Vec<usize> {
        Vec::new()
    }

    /// A better size for a grid whose size was left open and turns out to be unsuitable; where `wide` ones are as they should be, a wider one.
    fn better_size(
        &self,
        candidate: &Candidate<Self::Site>,
        grid: &Self::Grid,
        forces: &[f64],
        wide: bool,
    ) -> Option<Self::Size>;

    /// What the solution says against its grid (report figures 3.40 to 3.42).
    /// Where loads come and go, `wide` grids are as they should be.
    fn judge(
        &self,
        candidate: &Candidate<Self::Site>,
        grid: &Self::Grid,
        forces: &[f64],
        wide: bool,
    ) -> Option<String>;

    /// Growth of the gap of each cell by each modal coordinate of the bodies; none in space.
    fn modal_arms(&self, _laid: &[(&Candidate<Self::Site>, &Self::Grid)], _modes: &Modes) -> Mat<f64> {
        Mat::zeros(0, 0)
    }

    /// The patch as results show it, without a grid where nothing is pressed.
    fn patch(&self, candidate: &Candidate<Self::Site>, laid: Option<(Self::Grid, Vec<f64>)>) -> Patch;
}
/// That a grid does not suit its patch, and which width (m) would.
pub(super) fn unsuitable(scene: &Mechanism, pair: &SurfacePair, too_wide: bool, better: f64) -> String {
    let bodies = pair.bodies.map(|body| scene.bodies[body.0].name.as_str());
    let trouble = if too_wide {
        "is too wide: only a few of its cells carry load"
    } else {
        "is too narrow: the pressure does not fall to zero inside it"
    };
    // To two digits, so that the positions of a cycle say the same.
    let better: f64 = format!("{:.1e}", better * 1e3).parse().unwrap_or(better * 1e3);
    format!(
        "the contact grid of \"{}\" and \"{}\" {trouble}; `grid_width = {better} mm` suits it",
        bodies[0], bodies[1]
    )
}
