//! Sizes of the contact grids at one position, which are corrected until they suit the forces.
//!
//! A first size that rarely suits is corrected on grids with half as many cells along every
//! direction, whose compliance has a sixteenth of the entries.

use super::contact_geometry::Resolution;

/// Maximum number of corrections of grid sizes at a position, at half and at full resolution.
const HALF_CORRECTIONS: usize = 6;
const CORRECTIONS: usize = 3;
/// Maximum number of further corrections in three dimensions, which only enlarge grids: pressures
/// on a truncated grid are too high, and a correction that makes a grid smaller could truncate it.
const GROWTHS: usize = 3;

/// Sizes and resolutions of the grids of all patches.
pub(super) struct GridSizes<Z> {
    /// Sizes by correction; `None` for those of the model or derived from the force.
    pub(super) sizes: Vec<Option<Z>>,
    pub(super) resolutions: Vec<Resolution>,
    /// Number of corrections that may follow, and of those that only enlarge grids.
    left: usize,
    growths: usize,
}

impl<Z: Copy> GridSizes<Z> {
    /// Creates the first sizes. Grids that `may_grow` have further corrections.
    pub(super) fn new(resolutions: Vec<Resolution>, may_grow: bool) -> Self {
        let growths = if may_grow { GROWTHS } else { 0 };
        let halved = resolutions.contains(&Resolution::Half);
        let left = if halved { HALF_CORRECTIONS } else { CORRECTIONS } + growths;
        Self { sizes: vec![None; resolutions.len()], resolutions, left, growths }
    }

    /// Returns whether the next correction only enlarges grids.
    pub(super) fn only_grow(&self) -> bool {
        self.left <= self.growths
    }

    /// Takes the `better` sizes of grids that are unsuitable, or the full resolution if all suit.
    /// Returns the patches whose grids change; none at the end.
    pub(super) fn correct(&mut self, better: &[Option<Z>]) -> Vec<usize> {
        let all = 0..better.len();
        let unsuitable: Vec<usize> = all.clone().filter(|&patch| better[patch].is_some()).collect();
        if self.left > 0 && !unsuitable.is_empty() {
            self.left -= 1;
            unsuitable.iter().for_each(|&patch| self.sizes[patch] = better[patch]);
            return unsuitable;
        }
        let halved = all.filter(|&patch| self.resolutions[patch] == Resolution::Half).collect();
        self.resolutions.fill(Resolution::Full);
        self.left = CORRECTIONS + self.growths;
        halved
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use Resolution::{Full, Half};

    #[test]
    fn sizes_are_corrected_at_half_resolution_first() {
        let mut sizes = GridSizes::new(vec![Half, Full, Half], false);
        assert_eq!(sizes.correct(&[Some(1.0), None, None]), [0]);
        assert_eq!(sizes.resolutions, [Half, Full, Half]);
        assert_eq!(sizes.correct(&[None; 3]), [0, 2]);
        assert_eq!((sizes.resolutions, sizes.sizes), (vec![Full; 3], vec![Some(1.0), None, None]));
    }

    #[test]
    fn corrections_end_at_each_resolution() {
        let mut sizes = GridSizes::new(vec![Half], true);
        let unsuitable = [Some(2.0)];
        for (resolution, corrections) in [(Half, HALF_CORRECTIONS), (Full, CORRECTIONS)] {
            for left in (1..=corrections + GROWTHS).rev() {
                assert_eq!(sizes.only_grow(), left <= GROWTHS);
                assert_eq!(sizes.correct(&unsuitable), [0]);
            }
            let last: &[usize] = if resolution == Half { &[0] } else { &[] };
            assert_eq!(sizes.correct(&unsuitable), last);
        }
    }
}
