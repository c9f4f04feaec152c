//! Modified flanks on the structure of the gear without modifications.
//!
//! A relief removes micrometres from flanks that are millimetres long. The contact problem includes
//! it in full: these profiles are the exact modified curves, loaded along their own normals. The
//! body hardly changes, so the mesh and the condensed operators of the unmodified gear serve all of
//! its reliefs.

use crate::deviation::CubicSpline;
use crate::flank::Flank;
use calyx_runtime::structure::ModifiedSurface;
use std::sync::Arc;

/// Map from arc lengths of a modified flank to those of the unmodified flank. A point maps to the
/// one at the same roll angle, and the tip edge maps to the tip edge, because the compliance near
/// it varies with the logarithm of the distance.
struct ArcLengthMap {
    /// Start and end of the tip edge on either flank.
    edge: [f64; 2],
    plain_edge: [f64; 2],
    /// Arc length from which the flank is modified, up to the tip edge.
    from: f64,
    /// Difference of arc length of the corresponding point on the unmodified flank, over the
    /// modified part.
    shift: CubicSpline,
}

/// Fraction of the flank's roll range over which the positions of the tip edges are matched.
const STRETCHED: f64 = 0.15;
/// Steps between samples of the shift along a flank, which is smooth and small.
const SHIFTS: usize = 128;

/// Replaces the plain flank by the modified one.
pub(crate) fn modified_structure(modified: &Arc<Flank>, plain: &Flank) -> ModifiedSurface {
    let onto = ArcLengthMap::new(modified, plain);
    ModifiedSurface { profile: modified.clone(), onto: Arc::new(move |s| onto.at(s)) }
}

impl ArcLengthMap {
    fn new(modified: &Flank, plain: &Flank) -> Self {
        let from_roll = modified.first_modified_roll();
        let (edge, plain_edge) = (modified.edge_range(), plain.edge_range());
        let from = modified.s_at_roll(from_roll);
        let step = (edge[0] - from) / SHIFTS as f64;
        // Matches points by roll angle, stretched slightly before the tip edges so that both edges
        // begin together.
        let (end, plain_end) = (modified.edge_roll(), plain.edge_roll());
        let stretched_from = from_roll.max(end - STRETCHED * (end - modified.form_roll()));
        let stretch = (plain_end - stretched_from) / (end - stretched_from);
        let shift = |sample: usize| {
            let s = from + step * sample as f64;
            let roll = modified.roll_at(s);
            plain.s_at_roll(roll + (stretch - 1.0) * (roll - stretched_from).max(0.0)) - s
        };
        let shift = CubicSpline::new(from, step, (0..=SHIFTS).map(shift).collect());
        Self { edge, plain_edge, from, shift }
    }

    /// Arc length of the unmodified flank that corresponds to one of the modified flank.
    fn at(&self, s: f64) -> f64 {
        let ([edge, end], [plain_edge, plain_end]) = (self.edge, self.plain_edge);
        if s <= self.from {
            s
        } else if s < edge {
            s + self.shift.at(s)[0]
        } else {
            let on_edge = ((s - edge) / (end - edge)).min(1.0);
            plain_edge + on_edge * (plain_end - plain_edge) + (s - end).max(0.0)
        }
    }
}
