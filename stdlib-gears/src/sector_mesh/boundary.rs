//! The boundary of a half tooth, and the strip of elements that follows it.

use super::STRIP_DEPTH;
use crate::fillet::RootFillet;
use crate::flank::Flank;
use calyx_abi::math;
use calyx_runtime::profile::{Profile, ProfilePoint};
use std::f64::consts::TAU;
use std::sync::Arc;

/// Boundary of a half tooth with one coordinate `p` that increases from the root centre to the
/// middle of the tip edge's arc, and the inner side of the strip along it.
#[derive(Clone)]
pub(super) struct Boundary {
    pub fillet: RootFillet,
    pub flank: Arc<Flank>,
    /// `p` at which the root circle ends and the fillet begins.
    pub fillet_from: f64,
    /// `p` at which the flank begins.
    pub form: f64,
    /// `p` at which the tip edge's arc begins.
    pub edge: f64,
    /// Thickness of the strip and direction into the material at points between which both are
    /// interpolated linearly.
    pub anchors: Vec<Anchor>,
    /// `p` at which the strip begins to make room for the tip's strip, and the depth of that room
    /// at the end, m.
    pub tip_start: f64,
    pub tip_end: f64,
    pub tip_depth: f64,
    /// +1, or -1 for an internal gear, whose material lies outside.
    pub sense: f64,
}

#[derive(Clone, Copy)]
pub(super) struct Anchor {
    pub p: f64,
    pub depth: f64,
    /// Angle of the outward direction, rad.
    pub angle: f64,
}

impl Boundary {
    /// Exact boundary.
    pub fn outer(&self, p: f64) -> ProfilePoint {
        if p < self.form { self.fillet.at(self.form - p) } else { self.flank_at(p - self.form) }
    }

    /// Flank mapped to the counter-clockwise side.
    pub fn flank_at(&self, s: f64) -> ProfilePoint {
        self.flank.side().place(self.flank.at(s))
    }

    pub fn inner(&self, p: f64) -> [f64; 2] {
        // Below the tip edge's arc the strip continues along the flank: if it followed the arc, the
        // core of a thin tip would have no corner.
        let beyond = (p - self.edge).max(0.0);
        let start = self.outer(p.min(self.edge));
        let [x, y] = [0, 1].map(|axis| start.position[axis] + 0.7 * beyond * start.tangent[axis]);
        let after = self.anchors.partition_point(|anchor| anchor.p <= p).clamp(1, self.anchors.len() - 1);
        let (a, b) = (self.anchors[after - 1], self.anchors[after]);
        let part = (p - a.p) / (b.p - a.p);
        let depth = a.depth + part * (b.depth - a.depth);
        let (sine, cosine) = math::sincos(a.angle + part * (b.angle - a.angle));
        let into_tip = ((p - self.tip_start) / (self.tip_end - self.tip_start)).max(0.0);
        [x - depth * cosine - self.sense * self.tip_depth * into_tip * into_tip, y - depth * sine]
    }
}

impl Boundary {
    /// Chooses thickness and direction of the strip.
    pub fn place_strip(&mut self, module: f64, rim: f64) {
        let (fillet_from, form, edge) = (self.fillet_from, self.form, self.edge);
        // On an internal gear the direction rotates from the flank's normal to the one that points
        // at the axis.
        let internal = self.sense < 0.0;
        let angle_of = |[x, y]: [f64; 2]| {
            let angle = math::atan2(y, x);
            if internal && angle < 0.0 { angle + TAU } else { angle }
        };
        let below = angle_of(self.fillet.at(0.0).normal);
        let above = angle_of(self.flank_at(0.0).normal);
        // An undercut tooth has a corner at its form circle.
        let at_form = 0.5 * (below + above);
        let half_width = self.flank_at(0.0).position[1];
        let tip_half_width = self.flank_at(edge - form).position[1];
        let depth = (STRIP_DEPTH * module).min(0.3 * rim).min(0.3 * half_width);
        let tip_depth = depth.min(0.35 * tip_half_width);
        let at_fraction = |fraction: f64| form + fraction * (edge - form);
        let flank_anchor = |fraction: f64| {
            let p = at_fraction(fraction);
            Anchor {
                p,
                depth: depth + fraction * (tip_depth - depth),
                angle: angle_of(self.flank_at(p - form).normal),
            }
        };
        let mut anchors = vec![
            Anchor { p: 0.0, depth, angle: angle_of(self.outer(0.0).normal) },
            Anchor { p: fillet_from, depth, angle: angle_of(self.outer(fillet_from).normal) },
            Anchor { p: form, depth, angle: at_form },
            flank_anchor(0.25),
            flank_anchor(0.5),
            flank_anchor(1.0),
        ];
        if self.tip_end > edge {
            // Over the arc the strip keeps the flank's direction.
            anchors.push(Anchor { p: self.tip_end, ..flank_anchor(1.0) });
        }
        self.anchors = anchors;
        self.tip_depth = tip_depth.min(0.06 * (edge - form));
        // The transition is gradual because the flank of a small gear is strongly inclined at its
        // tip.
        self.tip_start = self.tip_end - 8.0 * self.tip_depth;
    }
}
