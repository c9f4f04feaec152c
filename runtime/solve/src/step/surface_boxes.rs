//! Boxes that enclose strips of a surface, for a quick search for near teeth.

use calyx_contact::solid::Pose;
use calyx_structure::surface::Surface;

/// Number of strips of a surface along its length, and of samples of each along and across.
const STRIPS: usize = 4;
const SAMPLES: [usize; 2] = [3, 5];
/// Margin of boxes beyond their samples, relative to the profile's length, for bulges between
/// samples and for gaps.
const BOX_MARGIN: f64 = 0.25;

/// Samples of a surface in its body's coordinates, in strips, for a quick search for near teeth.
pub(super) struct Shape {
    strips: Vec<Vec<[f64; 3]>>,
    /// Length of the profile at mid-face, m.
    pub(super) across: f64,
}

impl Shape {
    pub(super) fn of(surface: &dyn Surface) -> Shape {
        let [[u0, u1], [v0, v1]] = surface.range();
        let part = |ends: [f64; 2], k: usize, of: usize| ends[0] + (ends[1] - ends[0]) * k as f64 / of as f64;
        let sample = |strip: usize, index: usize| {
            let (along, across) = (index / SAMPLES[1], index % SAMPLES[1]);
            let v = part([v0, v1], strip * (SAMPLES[0] - 1) + along, STRIPS * (SAMPLES[0] - 1));
            surface.at(part([u0, u1], across, SAMPLES[1] - 1), v).position
        };
        let of_strip = |strip| (0..SAMPLES[0] * SAMPLES[1]).map(|index| sample(strip, index)).collect();
        let strips: Vec<Vec<[f64; 3]>> = (0..STRIPS).map(of_strip).collect();
        let middle = &strips[STRIPS / 2][..SAMPLES[1]];
        let length =
            |ends: &[[f64; 3]]| (0..3).map(|k| (ends[1][k] - ends[0][k]).powi(2)).sum::<f64>().sqrt();
        let across = middle.windows(2).map(length).sum();
        Shape { strips, across }
    }

    /// Returns boxes along the ground axes that enclose the surface at a pose.
    pub(super) fn boxes(&self, pose: &Pose) -> Vec<Box3> {
        let around = |points: &Vec<[f64; 3]>| {
            let mut ends = [[f64::INFINITY, f64::NEG_INFINITY]; 3];
            for point in points.iter().map(|&point| pose.point(point)) {
                for (end, x) in ends.iter_mut().zip(point) {
                    *end = [end[0].min(x), end[1].max(x)];
                }
            }
            let margin = BOX_MARGIN * self.across;
            Box3(ends.map(|[low, high]| [low - margin, high + margin]))
        };
        self.strips.iter().map(around).collect()
    }
}

/// Range along each axis, m.
pub(super) struct Box3([[f64; 2]; 3]);

impl Box3 {
    pub(super) fn meets(&self, other: &Box3) -> bool {
        self.0.iter().zip(&other.0).all(|(one, other)| one[0] <= other[1] && other[0] <= one[1])
    }
}
