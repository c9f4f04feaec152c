//! Closest approach of two placed profiles: points with opposite normals, joined along the normal.
//!
//! With the tangents t, the outward normals n and the points P, the arc lengths satisfy `(P2 -
//! P1)·t1 = 0` and `t2·n1 = 0`. A scan over both profiles, piece by piece between the jumps of
//! their curvatures, brackets the sign changes of both residuals. Newton's method follows; its
//! Jacobian has the determinant `-(k1 + k2 + k1 k2 gap)`, so it converges to rounding unless the
//! surfaces are conforming.

use super::placement::{ContactFrame, Placement};
use calyx_numerics::vec2::{dot, minus};
use calyx_structure::profile::{Profile, ProfilePoint};

/// Profile in the position of its body.
#[derive(Clone, Copy)]
pub struct PlacedProfile<'a> {
    /// Profile in the coordinates of its body.
    pub profile: &'a dyn Profile,
    /// Position and rotation of these coordinates.
    pub placement: Placement,
}

impl PlacedProfile<'_> {
    /// Returns the point at arc length `s`, in the coordinates of the placement.
    pub fn at(&self, s: f64) -> ProfilePoint {
        let local = self.profile.at(s);
        ProfilePoint {
            position: self.placement.point(local.position),
            tangent: self.placement.direction(local.tangent),
            normal: self.placement.direction(local.normal),
            curvature: local.curvature,
        }
    }

    /// Returns the arc length at which the search ends: the end of the profile, or the start of its
    /// edge.
    pub(super) fn end(&self, search_edges: bool) -> f64 {
        match self.profile.edge_from() {
            Some(edge) if !search_edges => edge.min(self.profile.length()),
            _ => self.profile.length(),
        }
    }

    /// Returns the arc length at which a contact force at `s` is applied to the body. It acts along
    /// the normal of the other flank. Compliances of structures are those of forces along their own
    /// normals, which are rotated on a rounded edge, so there the force is applied at the start of
    /// the edge.
    pub(super) fn loaded_at(&self, s: f64) -> f64 {
        self.profile.edge_from().map_or(s, |start| s.min(start))
    }

    pub(super) fn on_edge(&self, s: f64) -> bool {
        self.profile.edge_from().is_some_and(|edge| s >= edge)
    }
}

/// Closest approach of two profiles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Approach {
    /// Distance along the common normal, m; negative where the bodies overlap.
    pub gap: f64,
    /// Arc length on each profile, m.
    pub s: [f64; 2],
    /// Reference point, common normal and tangent.
    pub frame: ContactFrame,
    /// Relative curvature, 1/m, including the effect of the gap: the gap grows by half of it times
    /// x².
    pub relative_curvature: f64,
    /// True if the point lies on the rounded edge of the profile.
    pub on_edge: [bool; 2],
    /// True if the point is the end of the profile, because no point within has a normal opposite
    /// to that of the other profile. The relative curvature is meaningless then.
    pub at_end: [bool; 2],
}

/// Number of samples per smooth piece of a profile. A piece is a flank, a relief or a rounded edge:
/// its normal rotates monotonically by less than about a right angle.
const SAMPLES_PER_PIECE: usize = 20;
const NEWTON_STEPS: usize = 100;
/// Number of full Newton steps. Later steps are halved, to avoid oscillation over a jump of
/// curvature.
const FULL_STEPS: usize = 20;

/// Finds the closest approach; `None` if no two points face each other.
///
/// With `search_edges` the search includes the whole profiles and, without a common normal, their
/// ends. Otherwise only contact with a common normal on both flanks below their edges counts: the
/// nominal path of contact.
pub fn closest_approach(first: PlacedProfile, second: PlacedProfile, search_edges: bool) -> Option<Approach> {
    let samples = [samples(&first, search_edges), samples(&second, search_edges)];
    let ends = [first.end(search_edges), second.end(search_edges)];
    let mut best: Option<Approach> = None;
    let closer = |candidate: Approach, best: Option<Approach>| match best {
        Some(b) if b.gap <= candidate.gap => Some(b),
        _ => Some(candidate),
    };
    for pair1 in samples[0].windows(2) {
        for pair2 in samples[1].windows(2) {
            if let Some(approach) = tangential_contact(&first, &second, pair1, pair2, ends) {
                best = closer(approach, best);
            }
        }
    }
    if best.is_some() || !search_edges {
        return best;
    }
    for (corner_side, (corner, smooth)) in [(first, second), (second, first)].into_iter().enumerate() {
        for at_length in [false, true] {
            if let Some(approach) =
                corner_contact(&corner, &smooth, at_length, &samples[1 - corner_side], corner_side)
            {
                best = closer(approach, best);
            }
        }
    }
    best
}

/// Returns the sample points, ascending in arc length.
fn samples(placed: &PlacedProfile, search_edges: bool) -> Vec<(f64, ProfilePoint)> {
    let end = placed.end(search_edges);
    let mut knots = vec![0.0];
    knots.extend(placed.profile.breaks().iter().copied().filter(|&s| s > 0.0 && s < end));
    knots.push(end);
    let mut arcs: Vec<f64> = knots
        .windows(2)
        .flat_map(|piece| {
            (0..SAMPLES_PER_PIECE)
                .map(move |k| piece[0] + (piece[1] - piece[0]) * k as f64 / SAMPLES_PER_PIECE as f64)
        })
        .collect();
    arcs.push(end);
    arcs.into_iter().map(|s| (s, placed.at(s))).collect()
}

/// Residuals of a common normal: join along the tangent, m, and sine of the angle between the
/// normals.
fn residuals(p1: &ProfilePoint, p2: &ProfilePoint) -> [f64; 2] {
    [dot(minus(p2.position, p1.position), p1.tangent), dot(p2.tangent, p1.normal)]
}

/// Finds a common normal in the rectangle between two neighbouring samples on each profile.
fn tangential_contact(
    first: &PlacedProfile,
    second: &PlacedProfile,
    pair1: &[(f64, ProfilePoint)],
    pair2: &[(f64, ProfilePoint)],
    ends: [f64; 2],
) -> Option<Approach> {
    let mut lowest = [f64::INFINITY; 2];
    let mut highest = [f64::NEG_INFINITY; 2];
    for (_, p1) in pair1 {
        for (_, p2) in pair2 {
            if dot(p1.normal, p2.normal) >= 0.0 {
                return None;
            }
            let r = residuals(p1, p2);
            for k in 0..2 {
                lowest[k] = lowest[k].min(r[k]);
                highest[k] = highest[k].max(r[k]);
            }
        }
    }
    // Extend the range slightly beyond the corners: the residuals are curved, and a root may lie on
    // the boundary of the rectangle.
    for k in 0..2 {
        let margin = 0.1 * (highest[k] - lowest[k]);
        if lowest[k] > margin || highest[k] < -margin {
            return None;
        }
    }
    let start = [0.5 * (pair1[0].0 + pair1[1].0), 0.5 * (pair2[0].0 + pair2[1].0)];
    let s = newton(first, second, start, ends)?;
    let (p1, p2) = (first.at(s[0]), second.at(s[1]));
    let gap = dot(minus(p2.position, p1.position), p1.normal);
    let relative_curvature = p1.curvature + p2.curvature + p1.curvature * p2.curvature * gap;
    // Only a minimum of the distance counts; other stationary points approach from inside.
    if dot(p1.normal, p2.normal) >= 0.0 || relative_curvature <= 0.0 {
        return None;
    }
    Some(Approach {
        gap,
        s,
        frame: frame_between(&p1, &p2, p1.normal),
        relative_curvature,
        on_edge: [first.on_edge(s[0]), second.on_edge(s[1])],
        at_end: [false, false],
    })
}

fn newton(
    first: &PlacedProfile,
    second: &PlacedProfile,
    start: [f64; 2],
    ends: [f64; 2],
) -> Option<[f64; 2]> {
    let mut s = start;
    // A step of this size is rounding of the arc lengths.
    let settled = 4.0 * f64::EPSILON * ends[0].max(ends[1]);
    let mut previous = f64::INFINITY;
    for iteration in 0..NEWTON_STEPS {
        let (p1, p2) = (first.at(s[0]), second.at(s[1]));
        let [along, turn] = residuals(&p1, &p2);
        let gap = dot(minus(p2.position, p1.position), p1.normal);
        let facing = dot(p1.tangent, p2.tangent);
        // Derivatives with dt/ds = -k n, dn/ds = k t.
        let [[a, b], [c, d]] = [
            [-1.0 - p1.curvature * gap, facing],
            [p1.curvature * facing, -p2.curvature * dot(p2.normal, p1.normal)],
        ];
        let determinant = a * d - b * c;
        if determinant == 0.0 || !determinant.is_finite() {
            return None;
        }
        let step = [(b * turn - d * along) / determinant, (c * along - a * turn) / determinant];
        let size = step[0].abs().max(step[1].abs());
        let part = if iteration < FULL_STEPS { 1.0 } else { 0.5 };
        let next = [(s[0] + part * step[0]).clamp(0.0, ends[0]), (s[1] + part * step[1]).clamp(0.0, ends[1])];
        // Limited at an end by more than rounding: the common normal lies outside.
        if next == s && size > 1e3 * settled {
            return None;
        }
        s = next;
        // Converged, or limited by rounding of the profile.
        if size <= settled || (size <= 1e3 * settled && size >= 0.5 * previous) {
            return Some(s);
        }
        previous = size;
    }
    None
}

/// Finds the contact of an end of one profile with the smooth part of the other; `corner_side` is
/// the side of the corner.
fn corner_contact(
    corner: &PlacedProfile,
    smooth: &PlacedProfile,
    at_length: bool,
    samples: &[(f64, ProfilePoint)],
    corner_side: usize,
) -> Option<Approach> {
    let corner_s = if at_length { corner.profile.length() } else { 0.0 };
    let end = corner.at(corner_s);
    let along = |p: &ProfilePoint| dot(minus(end.position, p.position), p.tangent);
    let mut best: Option<(f64, ProfilePoint, f64)> = None;
    for pair in samples.windows(2) {
        let [(mut low, p_low), (mut high, p_high)] = [pair[0], pair[1]];
        if along(&p_low) < 0.0 || along(&p_high) > 0.0 {
            continue;
        }
        // The distance along the tangent decreases with s: bisect to the last bit.
        while low < 0.5 * (low + high) && 0.5 * (low + high) < high {
            let middle = 0.5 * (low + high);
            if along(&smooth.at(middle)) > 0.0 { low = middle } else { high = middle }
        }
        let foot = smooth.at(low);
        let gap = dot(minus(end.position, foot.position), foot.normal);
        // The corner must face the surface, and the profile behind the corner must recede.
        let inward = if at_length { -1.0 } else { 1.0 };
        let recedes = inward * dot(end.tangent, foot.normal) > 0.0;
        if dot(end.normal, foot.normal) < 0.0 && recedes && best.is_none_or(|b| gap < b.2) {
            best = Some((low, foot, gap));
        }
    }
    let (smooth_s, foot, gap) = best?;
    let order = |at_corner: f64, at_smooth: f64| {
        if corner_side == 0 { [at_corner, at_smooth] } else { [at_smooth, at_corner] }
    };
    let normal = if corner_side == 0 { [-foot.normal[0], -foot.normal[1]] } else { foot.normal };
    let on_edge = [corner.on_edge(corner_s), smooth.on_edge(smooth_s)];
    Some(Approach {
        gap,
        s: order(corner_s, smooth_s),
        frame: frame_between(&end, &foot, normal),
        relative_curvature: end.curvature + foot.curvature,
        on_edge: [on_edge[corner_side], on_edge[1 - corner_side]],
        at_end: [corner_side == 0, corner_side == 1],
    })
}

fn frame_between(p1: &ProfilePoint, p2: &ProfilePoint, normal: [f64; 2]) -> ContactFrame {
    ContactFrame {
        point: [0.5 * (p1.position[0] + p2.position[0]), 0.5 * (p1.position[1] + p2.position[1])],
        normal,
        tangent: [normal[1], -normal[0]],
    }
}
