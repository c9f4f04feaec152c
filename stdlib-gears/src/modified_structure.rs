//! Modified flanks on the structure of the gear without modifications.
//!
//! A relief takes micrometres off flanks that are millimetres long. Contact sees it in full: the profiles given here are the true,
//! modified curves, pressed along their own normals. The body behind them hardly changes, so mesh and condensed operators are those of the
//! unmodified gear and serve all its reliefs.

use crate::deviation::CubicSpline;
use crate::flank::Flank;
use calyx_runtime::structure::ModifiedSurface;
use std::sync::Arc;

/// How arc lengths of a modified flank map to those of the flank without modifications: a point stands for the one at the same
/// roll angle, with the tip edge on the tip edge, as compliance near it goes by the logarithm of the distance.
struct ArcLengthMap {
    /// Where the tip edge begins and ends, on either flank.
    edge: [f64; 2],
    plain_edge: [f64; 2],
    /// From here to the tip edge the flank is modified.
    from: f64,
    /// How much farther along the unmodified flank a point of the modified part stands.
    shift: CubicSpline,
}

/// Part of the flank's range of roll over which the places of the tip edges are brought together.
const STRETCHED: f64 = 0.15;
/// Steps between samples of the shift along a flank, which is smooth and small.
const SHIFTS: usize = 128;

/// The modified flank in place of the plain one.
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
        // By roll angle, stretched a little before the tip edges so that they begin together.
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

    /// The arc length of the unmodified flank that stands for one of the modified flank.
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
