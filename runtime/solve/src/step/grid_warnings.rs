//! Warnings about contact grids that do not suit their patches.
//!
//! `grid_width` and `contact_cells` apply to all patches of a mesh, so the advice does too: an
//! advised width covers the whole load on any flank, not only the patch that needs a change.

use super::contact_geometry::{Candidate, ContactGeometry, WidthReport};
use super::contact_layout::Solver;

/// A prescribed width suits the patch with the largest force. Another patch may have few loaded
/// cells unless the width exceeds the advised one by this factor.
const SPARE: f64 = 2.0;
/// Largest ratio of an advised width to that of a truncated grid which is as wide as the whole load
/// needs.
const MOST_WIDENING: f64 = 2.0;
/// Part of the width for the whole load above which a truncated grid needs more than that width.
const NEARLY_WHOLE: f64 = 0.8;
/// Half the number of cells below which an automatic width cannot both cover a patch and have
/// enough loaded cells.
const FEW_CELLS: usize = 3;
/// Rounded widths, so that most positions of a cycle have the same message.
const ROUND: [f64; 11] = [1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0];

/// Loaded patch of a surface pair.
struct Loaded {
    report: WidthReport,
    /// Sum of its cell forces.
    force: f64,
    /// Width of its grid if it carries the whole load, m.
    whole: f64,
}

impl<S: ContactGeometry> Solver<'_, S> {
    /// Returns a warning for each surface pair whose grids do not suit its patches.
    pub(super) fn grid_warnings(
        &self,
        candidates: &[&Candidate<S::Site>],
        grids: &[S::Grid],
        forces: &[f64],
        largest_forces: &[f64],
    ) -> Vec<String> {
        let mut by_pair: Vec<Vec<Loaded>> = self.system.scene.pairs.iter().map(|_| Vec::new()).collect();
        let mut rest = forces;
        for ((candidate, grid), &largest) in candidates.iter().zip(grids).zip(largest_forces) {
            let (own, others) = rest.split_at(self.space.count(grid));
            rest = others;
            let force: f64 = own.iter().sum();
            if force > 0.0 {
                let mut report = self.space.assess_width(grid, own);
                report.under_resolved &= !self.under.in_time;
                let whole = self.space.automatic_width(candidate, largest);
                by_pair[candidate.teeth.0].push(Loaded { report, force, whole });
            }
        }
        let scene = self.system.scene;
        let pairs = scene.pairs.iter().zip(&by_pair);
        pairs
            .filter_map(|(pair, patches)| {
                let trouble = trouble(patches, pair.grid.width.is_some())?;
                let [first, second] = pair.bodies.map(|body| scene.bodies[body.0].name.as_str());
                Some(format!("the contact grid of \"{first}\" and \"{second}\" {trouble}"))
            })
            .collect()
    }
}

/// Returns the deficiency of the grids of a pair and its cure.
fn trouble(patches: &[Loaded], prescribed: bool) -> Option<String> {
    let main = patches.iter().max_by(|one, other| one.force.total_cmp(&other.force))?;
    let whole = patches.iter().map(|patch| patch.whole).fold(0.0, f64::max);
    let few = !prescribed && main.report.half_count < FEW_CELLS;
    let truncated: Vec<&Loaded> = patches.iter().filter(|patch| patch.report.truncated).collect();
    if !truncated.is_empty() && !few {
        // A grid that is much too narrow shows too little of the pressure for an estimate from it.
        let wide = |patch: &&&Loaded| patch.report.width > NEARLY_WHOLE * whole;
        let wider = truncated.iter().filter(wide).filter_map(|patch| {
            let most = MOST_WIDENING * patch.report.width;
            patch.report.recommended.map(|recommended| recommended.min(most))
        });
        let width = rounded(wider.fold(whole, f64::max));
        return Some(format!(
            "is too narrow: the pressure does not fall to zero inside it, and pressures are too high; \
             `grid_width = {width} mm` suits it"
        ));
    }
    if truncated.is_empty() && !patches.iter().any(|patch| patch.report.under_resolved) {
        return None;
    }
    let width = rounded(whole);
    let ratio = main.report.width / (1e-3 * width);
    if prescribed && (ratio > SPARE || main.report.under_resolved && ratio > 1.0) {
        return Some(format!(
            "is too wide: only a few of its cells carry load; `grid_width = {width} mm` suits it"
        ));
    }
    // Lightly loaded patches do not need the resolution of the main one on a width given for it.
    (main.report.under_resolved || !prescribed).then(|| {
        let cells = (2 * main.report.half_count).max(4);
        format!("has too few cells: only a few of them carry load; `contact_cells = {cells}` suits it")
    })
}

/// Rounds a width (m) up, mm.
fn rounded(width: f64) -> f64 {
    let width = 1e3 * width;
    let decade = width.log10().floor();
    // Divide by a power of ten: a product with 0.1 would have more than two digits.
    let scaled = |digits: f64| match decade < 0.0 {
        true => digits / 10f64.powf(-decade),
        false => digits * 10f64.powf(decade),
    };
    ROUND.into_iter().map(scaled).find(|&round| round >= width).unwrap_or(width)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn patch(width: f64, force: f64, whole: f64) -> Loaded {
        let report =
            WidthReport { width, half_count: 24, truncated: false, under_resolved: false, recommended: None };
        Loaded { report, force, whole }
    }

    /// An edge that requires a narrow grid does not reduce the recommended width for the adjacent
    /// flank.
    #[test]
    fn advice_suits_all_patches_of_a_pair() {
        let flank = patch(0.02e-3, 90.0, 0.24e-3);
        let mut edge = patch(0.02e-3, 10.0, 0.2e-3);
        edge.report.truncated = true;
        edge.report.recommended = Some(0.04e-3);
        let message = trouble(&[flank, edge], true).expect("a warning");
        assert!(message.ends_with("`grid_width = 0.25 mm` suits it"), "{message}");
        // On the advised width, the edge has few loaded cells.
        let mut edge = patch(0.25e-3, 10.0, 0.2e-3);
        edge.report.under_resolved = true;
        edge.report.recommended = Some(0.02e-3);
        assert_eq!(trouble(&[patch(0.25e-3, 90.0, 0.24e-3), edge], true), None);
    }

    #[test]
    fn widths_are_rounded_up() {
        assert_eq!([0.24e-3, 0.41e-3, 1.0e-3, 2.1, 9e-9].map(rounded), [0.25, 0.5, 1.0, 2500.0, 1e-5]);
    }
}
