//! Contact line of two surfaces: for each position along the patch, the point across it where the
//! surfaces are closest.
//!
//! Gaps are measured along the normal of one frame, whose origin is the point of closest approach.
//! The normals there are opposite, unless a surface ends first. If the gap is constant along a
//! line, the frame lies in the middle of that line; for example, aligned involute helicoids touch
//! along a straight generator and have one tangent plane along it. y runs along the contact line:
//! in the direction of that line, or of the least relative curvature.
//!
//! Samples of both surfaces provide starting points. Then frame and contact line are improved
//! alternately. Across the patch the slope of the gap is monotonic, so its zero is bracketed and
//! computed to rounding. Along it, the least gap is searched among points of the contact line.
//!
//! See `docs/theory/contact.md`.

use super::height_field::HeightField;
use super::placement::{PatchFrame, PlacedSurface};
use super::transverse_approach::{TransverseApproach, closest_across, closest_between, closest_near};
use calyx_numerics::vec3::{Vector, dot, length, minus, plus, scaled, unit};

/// Point of the contact line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactLinePoint {
    /// x and y in the frame, m.
    pub at: [f64; 2],
    /// Gap along the normal of the frame, m; negative for overlap.
    pub gap: f64,
    /// Slopes along x and y of the surface between both flanks.
    pub slope: [f64; 2],
    /// True if either surface is on its rounded edge here.
    pub on_edge: bool,
    /// True if a surface ends here before the minimum of the gap.
    pub at_end: bool,
}

/// Contact line: points of closest approach of two surfaces along the patch.
#[derive(Clone, Debug, PartialEq)]
pub struct ContactLine {
    /// Frame at the closest approach.
    pub frame: PatchFrame,
    /// Least gap, along the common normal, m; negative for overlap.
    pub gap: f64,
    /// Surface coordinates of the closest approach, by side.
    pub places: [[f64; 2]; 2],
    /// True if it lies on the rounded edge of the surface, by side.
    pub on_edge: [bool; 2],
    /// True if a surface ends there, because no point within has a normal opposite to that of the
    /// other surface.
    pub at_end: bool,
    /// Points of the contact line, ascending in y, from end to end.
    pub points: Vec<ContactLinePoint>,
}

impl ContactLine {
    /// Returns whether a point of the first surface belongs to this contact line: its distance is
    /// much smaller than the length of the line.
    fn passes(&self, position: Vector) -> bool {
        let [x, y, _] = self.frame.coordinates(position);
        let [low, high] = self.extent();
        let other_loads =
            self.points.iter().min_by(|a, b| (a.at[1] - y).abs().total_cmp(&(b.at[1] - y).abs()));
        other_loads.is_some_and(|point| (point.at[0] - x).abs() < BESIDE * (high - low))
    }

    /// Returns y of the start and the end, where a surface ends, m.
    pub fn extent(&self) -> [f64; 2] {
        match (self.points.first(), self.points.last()) {
            (Some(first), Some(last)) => [first.at[1], last.at[1]],
            _ => [0.0; 2],
        }
    }
}

/// Numbers of samples per smooth piece of a surface along u, and of the whole surface along v.
const SAMPLES: [usize; 2] = [8, 6];
/// Fraction of the length of a contact line within which nearby samples lead to the same line.
const BESIDE: f64 = 0.1;
/// Number of points of a contact line, from end to end.
const STATIONS: usize = 17;
/// Maximum number of alternating improvements of frame and contact line.
const ROUNDS: usize = 12;
/// Gaps that differ by less than this fraction of the patch's length are equal to rounding.
const SAME_GAP: f64 = 1e-12;
/// Points of least gap whose distance is below this fraction of the patch's length belong to the
/// same contact line, if the frame has changed by less.
const SAME_POINT: f64 = 1e-3;
/// The direction of the contact line is determined where the gap exceeds the least by less than
/// this fraction of the patch's length.
const DIRECTION_DEPTH: f64 = 1e-3;
/// If a flank and its edge meet at the least gap, the direction of the other one is used if it is
/// near over a length larger by this factor.
const PASSES_INTO: f64 = 4.0;
/// Convergence: the last change of the frame is below this, translation (relative to the patch's
/// length) and rotation. The next one is a few percent of it.
const SETTLED: f64 = 1e-12;
/// Gap, relative to the size of the first surface, beyond which deflections do not close it; the
/// frame is not refined there, and the gap is accurate to a few percent.
const FAR: f64 = 0.02;
/// Principal curvatures that differ by less than this fraction of their sum are equal.
const ROUND: f64 = 1e-6;
/// Step of a finite difference, relative to the extent of a surface.
const DIFFERENCE: f64 = 1e-4;

/// Finds the contact line of two surfaces; `None` if they do not face each other anywhere.
///
/// With `search_edges` the search includes the whole surfaces, and the end of a surface that ends
/// before the minimum of the gap. Otherwise only contact below rounded edges counts.
pub fn find_contact_line(
    first: PlacedSurface,
    second: PlacedSurface,
    search_edges: bool,
) -> Option<ContactLine> {
    find_contact_line_within(first, second, search_edges, f64::INFINITY)
}

/// Finds the contact line as [`find_contact_line`] does. If the gap exceeds `far` (m), it is
/// accurate to a few percent.
pub fn find_contact_line_within(
    first: PlacedSurface,
    second: PlacedSurface,
    search_edges: bool,
    far: f64,
) -> Option<ContactLine> {
    let mut best: Option<ContactLine> = None;
    for start in starts([first, second], search_edges) {
        if best.as_ref().is_some_and(|best| best.passes(first.at(start[0]).position)) {
            continue;
        }
        let search = Search { placed: [first, second], search_edges, far };
        let Some(contact_line) = search.settle(start, best.as_ref()) else { continue };
        // Nearly equal gaps mean that the same contact line was found again.
        let reach = contact_line.extent()[1] - contact_line.extent()[0];
        if best.as_ref().is_none_or(|best| contact_line.gap < best.gap - SAME_GAP * reach) {
            best = Some(contact_line);
        }
    }
    best
}

/// Pair of surface coordinates, one on each surface.
type Places = [[f64; 2]; 2];

/// Returns starting points: for each position along the first surface, the pair of samples that
/// face each other at the smallest distance; the nearest pair first, and no two with the same point
/// of the second surface.
fn starts(placed: [PlacedSurface; 2], search_edges: bool) -> Vec<Places> {
    let samples = placed.map(|placed| samples(&placed, search_edges));
    let mut nearest: Vec<(f64, Places)> = Vec::new();
    for row in &samples[0] {
        let mut best: Option<(f64, Places)> = None;
        for (place, position, normal) in row {
            for (other, other_position, other_normal) in samples[1].iter().flatten() {
                if dot(*normal, *other_normal) >= 0.0 {
                    continue;
                }
                let join = minus(*other_position, *position);
                let distance = dot(join, join);
                if best.is_none_or(|(least, _)| distance < least) {
                    best = Some((distance, [*place, *other]));
                }
            }
        }
        nearest.extend(best);
    }
    nearest.sort_by(|a, b| a.0.total_cmp(&b.0));
    // Take the nearest, and the one farthest from it along the surface: minima of the gap are
    // elongated, and rarely more than two.
    let count = nearest.len();
    let chosen: Vec<Places> = nearest.into_iter().map(|(_, places)| places).collect();
    match count {
        0 | 1 => chosen,
        _ => vec![chosen[0], chosen[count - 1]],
    }
}

/// Samples in rows of constant v: coordinates, position and normal.
fn samples(placed: &PlacedSurface, search_edges: bool) -> Vec<Vec<([f64; 2], Vector, Vector)>> {
    let [u_range, v_range] = placed.range(search_edges);
    let mut knots = vec![u_range[0]];
    knots.extend(placed.surface.breaks().iter().copied().filter(|&u| u > u_range[0] && u < u_range[1]));
    knots.push(u_range[1]);
    let between = |ends: [f64; 2], k: usize, count: usize| {
        ends[0] + (ends[1] - ends[0]) * (k as f64 + 0.5) / count as f64
    };
    (0..SAMPLES[1])
        .map(|row| {
            let v = between(v_range, row, SAMPLES[1]);
            knots
                .windows(2)
                .flat_map(|piece| (0..SAMPLES[0]).map(move |k| between([piece[0], piece[1]], k, SAMPLES[0])))
                .map(|u| {
                    let point = placed.at([u, v]);
                    ([u, v], point.position, point.normal)
                })
                .collect()
        })
        .collect()
}

struct Search<'a> {
    placed: [PlacedSurface<'a>; 2],
    search_edges: bool,
    /// Gap beyond which the contact line is not refined, m.
    far: f64,
}

/// Contact line in one frame.
struct Stations {
    /// Points, ascending in y.
    found: Vec<TransverseApproach>,
    /// Point of the least gap.
    least: TransverseApproach,
}

impl<'a> Search<'a> {
    /// Improves frame and contact line alternately from a pair of near points until they converge.
    /// `None` if the surfaces do not face each other, and if it converges to a known contact line.
    fn settle(&self, start: Places, known: Option<&ContactLine>) -> Option<ContactLine> {
        let [first, second] = [0, 1].map(|side| self.placed[side].at(start[side]));
        let tangent = first.tangents[0];
        let normal = unit(minus(first.normal, second.normal));
        let middle = scaled(plus(first.position, second.position), 0.5);
        let frame = PatchFrame::new(middle, normal, tangent);
        let mut frame = self.along_least_curvature(frame, start);
        let mut places = start;
        let [[from_u, to_u], [from_v, to_v]] = self.placed[0].surface.range();
        let corners = [[from_u, from_v], [to_u, to_v]].map(|corner| self.placed[0].at(corner).position);
        let far = self.far.min(FAR * length(minus(corners[1], corners[0])));
        for round in 0..ROUNDS {
            let height_fields = self.height_fields(frame, places);
            let stations = self.stations(&height_fields, places)?;
            let next = self.improved(&frame, &stations);
            let reach = stations.reach();
            let shift = length(minus(next.point, frame.point)) / reach;
            let turn = length(minus(next.normal, frame.normal)).max(length(minus(next.along, frame.along)));
            let change = shift.max(turn);
            if change <= SAME_POINT && known.is_some_and(|known| self.is_least_of(known, &stations)) {
                return None;
            }
            let is_far = round > 0 && stations.least.gap() > far;
            if is_far || change <= SETTLED {
                return self.contact_line(frame, &height_fields, &stations);
            }
            frame = next;
            places = stations.least.places();
        }
        let height_fields = self.height_fields(frame, places);
        let stations = self.stations(&height_fields, places)?;
        self.contact_line(frame, &height_fields, &stations)
    }

    /// Returns whether the point of the least gap is that of a known contact line.
    fn is_least_of(&self, known: &ContactLine, stations: &Stations) -> bool {
        let places = stations.least.places();
        let is_alike = |side: usize| {
            let [own, other] = [places[side], known.places[side]].map(|at| self.placed[side].at(at).position);
            self.placed[side].on_edge(places[side]) == known.on_edge[side]
                && length(minus(own, other)) <= SAME_POINT * stations.reach()
        };
        stations.least.end.is_some() == known.at_end && is_alike(0) && is_alike(1)
    }

    /// Returns the contact line with these points in its frame.
    fn contact_line(
        &self,
        frame: PatchFrame,
        height_fields: &[HeightField; 2],
        stations: &Stations,
    ) -> Option<ContactLine> {
        let places = stations.least.places();
        let on_edge = [0, 1].map(|side| self.placed[side].on_edge(places[side]));
        let points = stations.found.iter().map(|closest| self.point(closest)).collect();
        let center = closest_across(height_fields, 0.0, places)?;
        Some(ContactLine { frame, gap: center.gap(), places, on_edge, at_end: center.end.is_some(), points })
    }

    fn height_fields(&self, frame: PatchFrame, places: Places) -> [HeightField<'a>; 2] {
        [0, 1].map(|side| HeightField::new(self.placed[side], frame, places[side], self.search_edges))
    }

    fn point(&self, closest: &TransverseApproach) -> ContactLinePoint {
        let places = closest.places();
        let on_edge = (0..2).any(|side| self.placed[side].on_edge(places[side]));
        let (slope, at_end) = (closest.common_slope(), closest.end.is_some());
        ContactLinePoint { at: closest.at(), gap: closest.gap(), slope, on_edge, at_end }
    }

    /// Rotates y of the frame into the direction of the least relative curvature.
    fn along_least_curvature(&self, frame: PatchFrame, places: Places) -> PatchFrame {
        let height_fields = self.height_fields(frame, places);
        let Some([[xx, xy], [yx, yy]]) = relative_curvature(&height_fields, places) else { return frame };
        let skew = xy + yx;
        // Nearly equal principal curvatures: any direction is suitable.
        if skew.hypot(xx - yy) <= ROUND * (xx + yy).abs() {
            return frame;
        }
        frame.turned(0.5 * skew.atan2(xx - yy))
    }

    /// Computes closest approaches from end to end.
    fn stations(&self, height_fields: &[HeightField; 2], places: Places) -> Option<Stations> {
        let center = closest_across(height_fields, 0.0, places)?;
        let mut ends = ends_along(height_fields, center.at()[0], center.places())?;
        // The end of a curved contact line is not below its middle.
        for _ in 0..2 {
            for end in 0..2 {
                if let Some(closest) = closest_near(height_fields, ends[end], &center) {
                    ends[end] = ends_along(height_fields, closest.at()[0], closest.places())?[end];
                }
            }
        }
        let usable = |closest: &TransverseApproach| self.search_edges || closest.end.is_none();
        let y = |station: usize| ends[0] + (ends[1] - ends[0]) * station as f64 / (STATIONS - 1) as f64;
        let mut found: Vec<TransverseApproach> = Vec::with_capacity(STATIONS + 2);
        // Proceed upwards from the middle, then downwards, each starting from the previous point.
        let middle = (0..STATIONS).find(|&station| y(station) >= center.at()[1]).unwrap_or(STATIONS);
        let mut near = center;
        for station in middle..STATIONS {
            let Some(closest) = closest_near(height_fields, y(station), &near) else { break };
            near = closest;
            found.push(closest);
        }
        found.reverse();
        near = center;
        for station in (0..middle).rev() {
            let Some(closest) = closest_near(height_fields, y(station), &near) else { break };
            near = closest;
            found.push(closest);
        }
        found.sort_by(|a, b| a.at()[1].total_cmp(&b.at()[1]));
        let found = self.within_ends(height_fields, found, usable);
        let least = self.least(height_fields, &found)?;
        Some(Stations { found, least })
    }

    /// Returns the longest usable range of the points found, with its ends searched between points.
    fn within_ends(
        &self,
        height_fields: &[HeightField; 2],
        found: Vec<TransverseApproach>,
        usable: impl Fn(&TransverseApproach) -> bool,
    ) -> Vec<TransverseApproach> {
        let mut best = 0..0;
        let mut first = 0;
        for last in 0..=found.len() {
            if last == found.len() || !usable(&found[last]) {
                if last - first > best.len() {
                    best = first..last;
                }
                first = last + 1;
            }
        }
        if best.len() == found.len() || best.is_empty() {
            return found[best].to_vec();
        }
        let sought = |inside: &TransverseApproach, outside: &TransverseApproach| {
            let (mut kept, mut ended, mut beyond) = (*inside, *outside, outside.at()[1]);
            for _ in 0..40 {
                let middle = 0.5 * (kept.at()[1] + beyond);
                match closest_between(height_fields, middle, [&kept, &ended]) {
                    Some(closest) if usable(&closest) => kept = closest,
                    Some(closest) => (ended, beyond) = (closest, middle),
                    None => beyond = middle,
                }
            }
            kept
        };
        let mut stretch = Vec::with_capacity(best.len() + 2);
        if best.start > 0 {
            stretch.push(sought(&found[best.start], &found[best.start - 1]));
        }
        stretch.extend_from_slice(&found[best.clone()]);
        if best.end < found.len() {
            stretch.push(sought(&found[best.end - 1], &found[best.end]));
        }
        stretch
    }

    /// Returns the point of the least gap; the middle of the line if the gap is constant.
    fn least(
        &self,
        height_fields: &[HeightField; 2],
        found: &[TransverseApproach],
    ) -> Option<TransverseApproach> {
        let lowest = found.iter().map(TransverseApproach::gap).min_by(f64::total_cmp)?;
        let reach = reach(found);
        let same = |closest: &TransverseApproach| closest.gap() <= lowest + SAME_GAP * reach;
        let first = found.iter().position(same)?;
        let last = found.iter().rposition(same)?;
        if first < last {
            let y = 0.5 * (found[first].at()[1] + found[last].at()[1]);
            let near = &found[(first + last) / 2];
            return closest_near(height_fields, y, near).or(Some(found[first]));
        }
        // Between neighbours at which the slope of the gap along the contact line changes its sign.
        let slope = |closest: &TransverseApproach| closest.slope()[1];
        let mut low = found[first.saturating_sub(1)];
        let mut high = found[(first + 1).min(found.len() - 1)];
        let mut middle = found[first];
        if (first == 0 && slope(&middle) >= 0.0) || (first + 1 == found.len() && slope(&middle) <= 0.0) {
            return Some(middle);
        }
        for round in 0..60 {
            if slope(&middle) == 0.0 {
                break;
            }
            if slope(&middle) > 0.0 {
                high = middle
            } else {
                low = middle
            }
            let [a, b] = [low.at()[1], high.at()[1]];
            let secant = a - slope(&low) * (b - a) / (slope(&high) - slope(&low));
            let inside = round % 3 != 2 && secant > a && secant < b;
            let y = if inside { secant } else { 0.5 * (a + b) };
            if (b - a).abs() <= 4.0 * f64::EPSILON * reach {
                break;
            }
            let Some(closest) = closest_near(height_fields, y, &middle) else { break };
            let moved = (closest.at()[1] - middle.at()[1]).abs();
            middle = closest;
            if moved <= 4.0 * f64::EPSILON * reach {
                break;
            }
        }
        Some(middle)
    }

    /// Returns the frame at the least gap, with y along the contact line.
    fn improved(&self, frame: &PatchFrame, stations: &Stations) -> PatchFrame {
        let least = &stations.least;
        let places = least.places();
        let [first, second] = [0, 1].map(|side| self.placed[side].at(places[side]));
        let normal = match least.end {
            // The end of a surface has no tangent plane; it presses along the normal of the other
            // surface.
            Some(0) => scaled(second.normal, -1.0),
            Some(_) => first.normal,
            None => unit(minus(first.normal, second.normal)),
        };
        let middle = scaled(plus(first.position, second.position), 0.5);
        let upright = PatchFrame::new(middle, normal, frame.across);
        // Without edges, surfaces end at the start of the edge, and rounding could put the last
        // point on it.
        let on_edge = |closest: &TransverseApproach| self.search_edges && self.point(closest).on_edge;
        match stations.direction(|closest| on_edge(closest) || closest.end.is_some()) {
            Some(angle) => upright.turned(-angle),
            None => self.along_least_curvature(upright, places),
        }
    }
}

impl Stations {
    fn reach(&self) -> f64 {
        reach(&self.found)
    }

    /// Returns the angle from y to the contact line, towards x, rad: through the farthest points on
    /// either side that resemble the least gap's point and are about as near. If a flank passes
    /// into its edge at the least gap, as on misaligned teeth, the part along which the bodies are
    /// near determines the direction. `None` if there is only one such point.
    fn direction(&self, special: impl Fn(&TransverseApproach) -> bool) -> Option<f64> {
        let kind = special(&self.least);
        let depth = DIRECTION_DEPTH * self.reach();
        let y = self.least.at()[1];
        let stretch = |kind: bool| {
            let like = |closest: &&TransverseApproach| {
                special(closest) == kind && closest.gap() <= self.least.gap() + depth
            };
            let above = self.found.iter().filter(|c| c.at()[1] > y).take_while(like).last();
            let below = self.found.iter().rev().filter(|c| c.at()[1] < y).take_while(like).last();
            [below.unwrap_or(&self.least).at(), above.unwrap_or(&self.least).at()]
        };
        let length = |[from, to]: [[f64; 2]; 2]| to[1] - from[1];
        let (own, other) = (stretch(kind), stretch(!kind));
        let [from, to] = if length(other) > PASSES_INTO * length(own) { other } else { own };
        (to[1] > from[1]).then(|| (to[0] - from[0]).atan2(to[1] - from[1]))
    }
}

fn reach(found: &[TransverseApproach]) -> f64 {
    match (found.first(), found.last()) {
        (Some(first), Some(last)) if last.at()[1] > first.at()[1] => last.at()[1] - first.at()[1],
        _ => f64::MIN_POSITIVE,
    }
}

/// Returns y of the ends along the patch at `x`, where either surface ends first; `None` if the
/// surfaces do not face each other.
pub(super) fn ends_along(height_fields: &[HeightField; 2], x: f64, guess: Places) -> Option<[f64; 2]> {
    let mut ends = [f64::NEG_INFINITY, f64::INFINITY];
    for (height_field, guess) in height_fields.iter().zip(guess) {
        let along = height_field.roles[1];
        let mut own = [0.0; 2];
        for (end, value) in own.iter_mut().zip(height_field.range[along]) {
            *end = height_field.towards(along, value, 0, x, guess[1 - along]).0.at[1];
        }
        ends = [ends[0].max(own[0].min(own[1])), ends[1].min(own[0].max(own[1]))];
    }
    (ends[0] < ends[1]).then_some(ends)
}

/// Returns the second derivatives of the gap by x and y, 1/m, at opposite points; `None` if the
/// surfaces end too near.
pub(super) fn relative_curvature(height_fields: &[HeightField; 2], places: Places) -> Option<[[f64; 2]; 2]> {
    let span = |height_field: &HeightField, place: [f64; 2]| {
        let [u, v] = [0, 1].map(|k| {
            let mut moved = place;
            moved[k] += DIFFERENCE * (height_field.range[k][1] - height_field.range[k][0]);
            let (from, to) = (height_field.foot(place).at, height_field.foot(moved).at);
            (to[0] - from[0]).hypot(to[1] - from[1])
        });
        u.min(v)
    };
    let step = span(&height_fields[0], places[0]).min(span(&height_fields[1], places[1]));
    let [x, y] = height_fields[0].foot(places[0]).at;
    let slope = |at: [f64; 2]| -> Option<[f64; 2]> {
        let feet = [height_fields[0].over(at, places[0])?, height_fields[1].over(at, places[1])?];
        Some([0, 1].map(|axis| feet[1].slope[axis] - feet[0].slope[axis]))
    };
    let difference = |ahead: [f64; 2], behind: [f64; 2]| -> Option<[f64; 2]> {
        let (ahead, behind) = (slope(ahead)?, slope(behind)?);
        Some([0, 1].map(|axis| (ahead[axis] - behind[axis]) / (2.0 * step)))
    };
    Some([difference([x + step, y], [x - step, y])?, difference([x, y + step], [x, y - step])?])
}
