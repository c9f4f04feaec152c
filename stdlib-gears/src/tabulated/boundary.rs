//! Boundary of one half of a tooth in a developed section, and the strip of elements that follows
//! it.
//!
//! One coordinate `q` increases from the middle of the tooth space over root, fillet and flank to
//! the start of the tip edge. Its breaks are the same for both halves and all sections, so that
//! equal divisions of `q` make meshes with the same elements.

use super::section::SectionCones;
use super::tooth::{CurvePoint, Tooth};
use calyx_abi::math;
use std::f64::consts::FRAC_PI_2;
use std::sync::Arc;

/// Largest thickness of the strip, in equivalent modules.
const STRIP_DEPTH: f64 = 0.25;
/// Largest thickness of the strip relative to the rim, to half of the tooth's thickness at the
/// fillet, and of the room below the tip to half of the thickness there.
const OF_RIM: f64 = 0.3;
const OF_TOOTH: f64 = 0.3;
const OF_TIP: f64 = 0.35;
/// Parts of a fillet between which the direction of the strip is interpolated.
const FILLET_ANCHORS: [f64; 3] = [0.25, 0.5, 0.75];

/// Breaks of the coordinate `q`, m in the middle section.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Breaks {
    /// End of the root between the fillets; 0 if the root has no elements of its own.
    pub land: f64,
    /// Point of the fillet where the normal has rotated by half.
    pub knee: f64,
    /// Beginning of the flank.
    pub form: f64,
    /// Beginning of the tip edge.
    pub edge: f64,
}

/// Half of a tooth in the section at `v`. Points are mirrored to the counter-clockwise side.
#[derive(Clone)]
pub(super) struct Half {
    pub tooth: Arc<Tooth>,
    pub side: usize,
    pub v: f64,
    pub breaks: Breaks,
    /// Part of the fillet's length from the knee to the flank.
    pub knee_part: f64,
    /// Height of the root in the middle of the space, m.
    pub root_height: f64,
    /// Part of the boundary below the knee that belongs to the root between the fillets.
    land_part: f64,
    /// Azimuth of the cut, positive.
    pub cut: f64,
    /// Displacement that takes the lower end of the boundary to the middle of the space at that
    /// height.
    correction: [f64; 2],
    pub anchors: Vec<Anchor>,
    /// Depth of the room for the tip's strip, m, and the part of the flank in which it grows.
    pub tip_depth: f64,
    room_part: f64,
}

#[derive(Clone, Copy, Debug)]
pub(super) struct Anchor {
    pub q: f64,
    pub depth: f64,
    /// Angle of the outward direction, rad.
    pub angle: f64,
}

/// Thicknesses of the strip in a section, which both halves share.
#[derive(Clone, Copy, Debug)]
pub(super) struct StripDepths {
    pub root: f64,
    pub tip: f64,
}

pub(super) fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

impl Half {
    /// Creates a half without a strip.
    pub fn new(tooth: &Arc<Tooth>, side: usize, v: f64, breaks: Breaks, knee_part: f64) -> Self {
        let root_height = 0.5 * [0, 1].map(|side| root_end(tooth, side, v)[0]).iter().sum::<f64>();
        let mut half = Self {
            tooth: Arc::clone(tooth),
            side,
            v,
            breaks,
            knee_part,
            root_height,
            land_part: 0.0,
            cut: cut_azimuth(tooth, side, v),
            correction: [0.0; 2],
            anchors: Vec::new(),
            tip_depth: 0.0,
            room_part: 1.0,
        };
        let [land, fillet] = half.root_lengths();
        half.land_part = if breaks.land > 0.0 {
            breaks.land / breaks.knee
        } else {
            land / (land + (1.0 - knee_part) * fillet)
        };
        let [end, _] = half.outer(0.0);
        let wanted = half.at_height(root_height, half.cut);
        half.correction = [wanted[0] - end[0], wanted[1] - end[1]];
        half
    }

    pub fn cones(&self) -> &SectionCones {
        &self.tooth.cones
    }

    pub fn along(&self) -> f64 {
        self.tooth.along(self.v)
    }

    fn mirrored(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        if self.side == 0 { [x, y] } else { [x, -y] }
    }

    /// Point at a height and an azimuth from the middle of the tooth, positive towards the cut.
    pub fn at_height(&self, height: f64, azimuth: f64) -> [f64; 2] {
        self.cones().developed(self.along(), height, azimuth)
    }

    /// Height and azimuth of a point.
    pub fn rolled(&self, point: [f64; 2]) -> [f64; 2] {
        self.cones().rolled(self.along(), point)
    }

    /// Length of the root from the fillet to the middle of the space, and of the fillet, m.
    fn root_lengths(&self) -> [f64; 2] {
        let [height, azimuth] = root_end(&self.tooth, self.side, self.v);
        let radius = self.cones().radius(self.along(), height);
        let land = (radius * (self.cut - azimuth)).max(0.0);
        let parts = 16;
        let length = self.tooth.fillet_length(self.side);
        let speed = |part: usize| {
            let w = length * (part as f64 + 0.5) / f64::from(parts);
            let [x, y] = self.tooth.fillet_at(self.side, w, self.v).by_u;
            x.hypot(y)
        };
        let fillet = (0..parts as usize).map(speed).sum::<f64>() * length / f64::from(parts);
        [land, fillet]
    }

    /// Exact boundary: position, and the derivative by the curve's own coordinate towards the tip.
    pub fn outer(&self, q: f64) -> [[f64; 2]; 2] {
        let breaks = &self.breaks;
        let fillet = self.tooth.fillet_length(self.side);
        let knee = fillet * self.knee_part;
        let curve = |point: CurvePoint, sign: f64| {
            [point.position, point.by_u.map(|part| sign * part)].map(|part| self.mirrored(part))
        };
        if q >= breaks.form {
            let part = (q - breaks.form) / (breaks.edge - breaks.form);
            let u = part * self.tooth.edge_from(self.side);
            return curve(self.tooth.flank_at(self.side, u, self.v), 1.0);
        }
        let on_fillet = |w: f64| curve(self.tooth.fillet_at(self.side, w, self.v), -1.0);
        if q >= breaks.knee {
            return on_fillet(knee * (breaks.form - q) / (breaks.form - breaks.knee));
        }
        let part = q / breaks.knee;
        let share = self.land_part;
        let [position, tangent] = if part < share {
            self.land(part / share)
        } else {
            on_fillet(fillet - (fillet - knee) * (part - share) / (1.0 - share))
        };
        let fading = (1.0 - part) * (1.0 - part);
        [[0, 1].map(|axis: usize| position[axis] + fading * self.correction[axis]), tangent]
    }

    /// Root at the height of the fillet's end, between the middle of the space (0) and the fillet
    /// (1).
    fn land(&self, part: f64) -> [[f64; 2]; 2] {
        let [height, azimuth] = root_end(&self.tooth, self.side, self.v);
        let azimuth = (1.0 - part) * self.cut + part * azimuth;
        let (sine, cosine) = math::sincos(self.cones().radial_angle(azimuth));
        [self.at_height(height, azimuth), [sine, -cosine]]
    }

    /// Angle of the outward normal of the boundary, rad.
    pub fn normal_angle(&self, q: f64) -> f64 {
        let [_, [x, y]] = self.outer(q);
        math::atan2(y, x) + FRAC_PI_2
    }

    /// Inner side of the strip.
    pub fn inner(&self, q: f64) -> [f64; 2] {
        let [x, y] = self.outer(q)[0];
        let after = self.anchors.partition_point(|anchor| anchor.q <= q).clamp(1, self.anchors.len() - 1);
        let (a, b) = (self.anchors[after - 1], self.anchors[after]);
        let part = (q - a.q) / (b.q - a.q);
        let depth = a.depth + part * (b.depth - a.depth);
        let (sine, cosine) = math::sincos(a.angle + part * (b.angle - a.angle));
        // Near the tip the strip makes room for that of the tip land. The transition is gradual
        // because the flank of a small gear is strongly inclined at its tip.
        let scale = (self.breaks.edge - self.breaks.form) * self.room_part;
        let into_tip = (1.0 - (self.breaks.edge - q) / scale).max(0.0);
        [x - depth * cosine - self.tip_depth * into_tip * into_tip, y - depth * sine]
    }

    /// Chooses thickness and direction of the strip.
    pub fn place_strip(&mut self, depths: StripDepths) {
        let Breaks { land, form, edge, .. } = self.breaks;
        let StripDepths { root: depth, tip } = depths;
        let anchor = |q: f64, depth: f64| Anchor { q, depth, angle: self.normal_angle(q) };
        let end = 1e-6 * form;
        // The strip of the next tooth meets the cut from the other side.
        let at_cut = self.cones().radial_angle(self.cut);
        let mut anchors = vec![Anchor { q: 0.0, depth, angle: at_cut }];
        if land > 0.0 {
            anchors.push(anchor(land + end, depth));
        }
        let fillet = |part: f64| land + part * (form - land);
        anchors.extend(FILLET_ANCHORS.map(|part| anchor(fillet(part), depth)));
        // An undercut tooth has a corner at its form circle.
        let at_form = 0.5 * (self.normal_angle(form - end) + self.normal_angle(form));
        anchors.push(Anchor { q: form, depth, angle: at_form });
        let flank = |part: f64| anchor(form + part * (edge - form), depth + part * (tip - depth));
        anchors.extend([0.25, 0.5, 1.0].map(flank));
        let length = distance(self.outer(form)[0], self.outer(edge)[0]);
        self.anchors = anchors;
        self.tip_depth = tip.min(0.06 * length);
        self.room_part = 8.0 * self.tip_depth / length;
    }
}

/// Height and azimuth of the root end of a fillet, positive towards the cut.
pub(super) fn root_end(tooth: &Tooth, side: usize, v: f64) -> [f64; 2] {
    let point = tooth.fillet_at(side, tooth.fillet_length(side), v).position;
    let [height, azimuth] = tooth.cones.rolled(tooth.along(v), point);
    [height, if side == 0 { azimuth } else { -azimuth }]
}

/// Azimuth of the cut in the middle between the root ends of the fillets of neighbouring teeth,
/// positive from the middle of the tooth.
pub(super) fn cut_azimuth(tooth: &Tooth, side: usize, v: f64) -> f64 {
    let [left, right] = [0, 1].map(|side| root_end(tooth, side, v)[1]);
    let shift = 0.5 * (left - right);
    tooth.half_pitch() + if side == 0 { shift } else { -shift }
}

/// Chooses the thicknesses of the strip in a section from both halves and the thickness of the rim
/// (m). `scale` is the size of the section relative to the middle one.
pub(super) fn strip_depths(halves: [&Half; 2], rim: f64, scale: f64) -> StripDepths {
    let [form, edge] = [halves[0].breaks.form, halves[0].breaks.edge];
    let thickness = |q: f64| {
        let [left, right] = halves.map(|half| half.outer(q)[0]);
        distance(left, [right[0], -right[1]])
    };
    let module = scale * halves[0].tooth.module;
    let root = (STRIP_DEPTH * module).min(OF_RIM * rim).min(OF_TOOTH * 0.5 * thickness(form));
    StripDepths { root, tip: root.min(OF_TIP * 0.5 * thickness(edge)) }
}
