//! Unloaded contact of two rigid flanks on general axes, from the surfaces alone.
//!
//! A point of the first flank needs a rotation of the second body to meet the point of the second
//! flank with the same radius and axial position. Contact is where this rotation is an extreme over
//! the first flank: in its interior the normals are parallel there, otherwise a flank ends
//! (Stadtfeld calls the function the ease-off). The extreme exists for point and for line contact.
//!
//! See `docs/theory/gear-geometry.md`.

use super::bounded_step::{Bound, Quadratic};
use calyx_runtime::contact::solid::Pose;
use calyx_runtime::surface::{Surface, SurfacePoint};
use calyx_runtime::vec3::{cross, dot, length, minus};
use std::f64::consts::TAU;

/// Numbers of samples of a flank along either coordinate.
const SAMPLES: usize = 11;
/// Largest difference of the normals at a contact in the interior of both flanks.
const PARALLEL: f64 = 1e-6;
/// Maximum number of steps of the iterations.
const STEPS: usize = 60;
/// Step of finite differences, relative to the range of a coordinate.
const DIFFERENCE: f64 = 1e-6;
/// Least increase of the rotation beyond an end of a flank, rad per range of the coordinate, at
/// which the contact is at this end.
const OUTWARDS: f64 = 1e-6;
/// Maximum number of corrections of a step to the end of the second flank.
const CORRECTIONS: usize = 4;
/// Step of a coordinate, relative to its range, at which an iteration ends.
const SETTLED: f64 = 1e-13;
/// Part of its range by which a coordinate may be outside: rounding.
const ROUNDING: f64 = 1e-9;
/// Margin of the radial and axial range of the second flank in the search for near teeth, relative
/// to its size.
const NEAR: f64 = 0.05;
/// Distance of a coordinate from its range, relative to the range, beyond which the linearization
/// at the nearest sample excludes that a flank has a point: 2.5 times the distance of samples.
const OFF: f64 = 0.25;
/// Step of a coordinate, relative to its range, after which a search among samples accepts a
/// point. It decides only where the search for the contact starts.
const ROUGH: f64 = 1e-3;

/// Contact of a flank of the first body with flanks of the second.
#[derive(Clone, Copy, Debug)]
pub(super) struct FlankContact {
    /// Rotation of the second body that brings tooth 0 into contact, rad; up to whole revolutions.
    pub rotation: f64,
    /// Surface coordinates on the first flank.
    pub place: [f64; 2],
    /// Point of contact in the coordinates of the second body before its rotation, m.
    pub point: [f64; 3],
    /// Unit normal of the first flank there.
    pub normal: [f64; 3],
    /// True if the normals are parallel, so that neither flank ends.
    pub inside: bool,
    /// True if the rotation has an extreme here because a flank ends.
    pub at_end: bool,
}

/// Flank of the second body about its axis, the z axis of its coordinates.
pub(super) struct Mate<'a> {
    surface: &'a dyn Surface,
    range: [[f64; 2]; 2],
    /// Sense in which the flank is pushed about the axis: +1 is counter-clockwise.
    pub pushed: f64,
    samples: Vec<Sample>,
    /// Ranges of radius and axial position with a margin, m.
    reach: [[f64; 2]; 2],
}

/// Sample of a flank of the second body.
struct Sample {
    place: [f64; 2],
    /// Radius and axial position.
    at: [f64; 2],
    /// Derivatives of the coordinates by radius and axial position.
    inverse: [[f64; 2]; 2],
}

/// Flank of the first body at a pose in the coordinates of the second.
pub(super) struct Driver<'a> {
    pub surface: &'a dyn Surface,
    pub pose: Pose,
}

/// Rotation of the second body to a point of the first flank, and its derivatives by the
/// coordinates of that flank.
struct Ray {
    contact: FlankContact,
    slope: [f64; 2],
    /// Coordinates on the second flank, and their derivatives by both coordinates.
    mate: [f64; 2],
    mate_by: [[f64; 2]; 2],
    arm: f64,
}

/// Rotation near a point of the first flank, in the sense of the push, as a function of steps of
/// its coordinates relative to their ranges.
struct Local {
    rotation: Quadratic,
    /// Ends of the first flank, then those of the second one, by steps.
    bounds: [Bound; 4],
}

/// Rotation of the second body to a point of the first flank.
#[derive(Clone, Copy, Debug)]
pub(super) struct PointRay {
    /// Rotation, rad; up to whole revolutions.
    pub rotation: f64,
    /// Surface coordinates on the second flank.
    pub mate: [f64; 2],
    /// Arm of the normal of the second flank about its axis, m.
    pub arm: f64,
}

/// Returns the ranges of the coordinates of a flank, without its rounded edge.
pub(super) fn flank_range(surface: &dyn Surface) -> [[f64; 2]; 2] {
    let [[first, last], v] = surface.range();
    [[first, surface.edge_from().map_or(last, |edge| edge.min(last))], v]
}

/// Returns points on a regular grid over the ranges, from end to end.
fn grid([u, v]: [[f64; 2]; 2]) -> impl Iterator<Item = [f64; 2]> {
    // The last point is not beyond the end, where the edge begins.
    let at =
        |[low, high]: [f64; 2], k: usize| (low + (high - low) * k as f64 / (SAMPLES - 1) as f64).min(high);
    (0..SAMPLES).flat_map(move |i| (0..SAMPLES).map(move |j| [at(u, i), at(v, j)]))
}

/// Returns the vector after a rotation about the z axis by an angle, rad.
fn about_z(angle: f64, [x, y, z]: [f64; 3]) -> [f64; 3] {
    let (sine, cosine) = angle.sin_cos();
    [cosine * x - sine * y, sine * x + cosine * y, z]
}

/// Returns radius and axial position of a point, and the derivatives of the coordinates of the
/// surface by them.
fn meridian(point: &SurfacePoint) -> ([f64; 2], [[f64; 2]; 2]) {
    let [x, y, z] = point.position;
    let radius = x.hypot(y);
    let radial = point.tangents.map(|[tx, ty, _]| (x * tx + y * ty) / radius);
    let axial = point.tangents.map(|[.., tz]| tz);
    let determinant = radial[0] * axial[1] - radial[1] * axial[0];
    let inverse = [[axial[1], -radial[1]], [-axial[0], radial[0]]];
    ([radius, z], inverse.map(|row| row.map(|entry| entry / determinant)))
}

impl Sample {
    /// Returns the step of the coordinates to a radius and axial position, to first order.
    fn step_to(&self, target: [f64; 2]) -> [f64; 2] {
        let short = [target[0] - self.at[0], target[1] - self.at[1]];
        self.inverse.map(|row| row[0] * short[0] + row[1] * short[1])
    }
}

/// Returns an angle moved by whole turns next to another one, rad.
pub(super) fn nearest(angle: f64, to: f64, turn: f64) -> f64 {
    angle - ((angle - to) / turn).round() * turn
}

impl<'a> Mate<'a> {
    /// Creates the flank from its surface in the coordinates of its body.
    pub fn new(surface: &'a dyn Surface) -> Mate<'a> {
        let range = flank_range(surface);
        let middle = surface.at(0.5 * (range[0][0] + range[0][1]), 0.5 * (range[1][0] + range[1][1]));
        let [x, y, _] = middle.position;
        let outward = middle.normal[1] * x - middle.normal[0] * y;
        let samples: Vec<Sample> = grid(range)
            .map(|place| {
                let (at, inverse) = meridian(&surface.at(place[0], place[1]));
                Sample { place, at, inverse }
            })
            .collect();
        let reach = [0, 1].map(|k: usize| {
            let values = samples.iter().map(|sample| sample.at[k]);
            let low = values.clone().fold(f64::INFINITY, f64::min);
            let high = values.fold(f64::NEG_INFINITY, f64::max);
            let margin = NEAR * (high - low);
            [low - margin, high + margin]
        });
        Mate { surface, range, pushed: -outward.signum(), samples, reach }
    }

    /// Returns the coordinates of a radius and axial position by the linearization at the nearest
    /// sample; `None` if they are far outside of the flank.
    fn estimate(&self, target: [f64; 2]) -> Option<[f64; 2]> {
        let distance = |at: &[f64; 2]| (at[0] - target[0]).powi(2) + (at[1] - target[1]).powi(2);
        let distances = self.samples.iter().map(|sample| (sample, distance(&sample.at)));
        let (sample, _) = distances.min_by(|a, b| a.1.total_cmp(&b.1))?;
        let step = sample.step_to(target);
        let place = [0, 1].map(|k: usize| sample.place[k] + step[k]);
        let is_near = |k: usize| {
            let [low, high] = self.range[k];
            let margin = OFF * (high - low);
            // A sample at which the coordinates are singular excludes nothing.
            !(place[k] < low - margin || place[k] > high + margin)
        };
        if !step[0].is_finite() || !step[1].is_finite() {
            return Some(sample.place);
        }
        (is_near(0) && is_near(1)).then(|| [0, 1].map(|k| self.clamped(k, place[k])))
    }

    /// Limits a coordinate: the surface continues slightly beyond its ends.
    fn clamped(&self, k: usize, coordinate: f64) -> f64 {
        let [low, high] = self.range[k];
        let beyond = NEAR * (high - low);
        coordinate.clamp(low - beyond, high + beyond)
    }

    /// Returns whether coordinates are on the flank, but for a part of its ranges.
    fn contains(&self, place: [f64; 2], margin: f64) -> bool {
        (0..2).all(|k| {
            let [low, high] = self.range[k];
            let margin = margin * (high - low);
            (low - margin..=high + margin).contains(&place[k])
        })
    }

    /// Returns the point with this radius and axial position and its coordinates; `None` if the
    /// flank and its continuation end before.
    fn partner(&self, target: [f64; 2], guess: Option<[f64; 2]>) -> Option<([f64; 2], SurfacePoint)> {
        let mut place = guess.or_else(|| self.estimate(target))?;
        let spans = self.range.map(|[low, high]| high - low);
        let mut previous = f64::INFINITY;
        let mut beyond = 0;
        for _ in 0..STEPS {
            let point = self.surface.at(place[0], place[1]);
            let (at, inverse) = meridian(&point);
            let step = Sample { place, at, inverse }.step_to(target);
            let size = (step[0] / spans[0]).abs().max((step[1] / spans[1]).abs());
            if !size.is_finite() {
                return None;
            }
            if size <= SETTLED || (size <= 1e3 * SETTLED && size >= 0.5 * previous) {
                // Beyond an end, the derivatives are those of the edge.
                let nearest = [0, 1].map(|k: usize| place[k].clamp(self.range[k][0], self.range[k][1]));
                let is_rounded = nearest != place && self.contains(place, 10.0 * SETTLED);
                return Some(if is_rounded {
                    (nearest, self.surface.at(nearest[0], nearest[1]))
                } else {
                    (place, point)
                });
            }
            let next = [0, 1].map(|k: usize| self.clamped(k, place[k] + step[k]));
            // The iteration does not return from the end of the continuation if it stays there.
            let stays = |k: usize| next[k] == place[k] && !self.contains(place, ROUNDING);
            beyond += usize::from(stays(0) || stays(1));
            if next == place || beyond > 1 {
                return None;
            }
            previous = size;
            place = next;
        }
        None
    }

    /// Returns the approximate rotation to a point of the first flank; `None` if this flank has no
    /// point with its radius and axial position, or faces the same way.
    fn rough_rotation(&self, driver: &Driver<'_>, place: [f64; 2]) -> Option<f64> {
        let own = driver.surface.at(place[0], place[1]);
        let [x, y, z] = driver.pose.point(own.position);
        let target = [x.hypot(y), z];
        let mut mate = self.estimate(target)?;
        let mut beyond = 0;
        for _ in 0..STEPS {
            let point = self.surface.at(mate[0], mate[1]);
            let (at, inverse) = meridian(&point);
            let step = Sample { place: mate, at, inverse }.step_to(target);
            let next = [0, 1].map(|k: usize| self.clamped(k, mate[k] + step[k]));
            let size = [0, 1].map(|k: usize| (step[k] / (self.range[k][1] - self.range[k][0])).abs());
            if size[0].max(size[1]) <= ROUGH {
                let [ox, oy, _] = [0, 1, 2].map(|l: usize| {
                    point.position[l] + step[0] * point.tangents[0][l] + step[1] * point.tangents[1][l]
                });
                let rotation = (ox * y - oy * x).atan2(ox * x + oy * y);
                let turned = about_z(rotation, point.normal);
                let facing = dot(driver.pose.direction(own.normal), turned) < 0.0;
                return (facing && self.contains(next, ROUGH)).then_some(rotation);
            }
            beyond += usize::from((next[0] == mate[0] || next[1] == mate[1]) && !self.contains(mate, ROUGH));
            if next == mate || beyond > 1 || !(size[0] + size[1]).is_finite() {
                return None;
            }
            mate = next;
        }
        None
    }

    /// Returns the rotation to a point of the first flank; `None` if this flank and its
    /// continuation have no point with its radius and axial position, or face the same way.
    fn ray(&self, driver: &Driver<'_>, place: [f64; 2], guess: Option<[f64; 2]>) -> Option<Ray> {
        let own = driver.surface.at(place[0], place[1]);
        let (point, normal) = (driver.pose.point(own.position), driver.pose.direction(own.normal));
        let [x, y, z] = point;
        let (mate, other) = self.partner([x.hypot(y), z], guess)?;
        let [ox, oy, _] = other.position;
        // The angle between the two radii, to rounding also where it is small.
        let rotation = (ox * y - oy * x).atan2(ox * x + oy * y);
        let turned = about_z(rotation, other.normal);
        let facing = dot(normal, turned) < 0.0;
        let arm = turned[1] * x - turned[0] * y;
        let tangents = own.tangents.map(|tangent| driver.pose.direction(tangent));
        let slope = tangents.map(|tangent| dot(turned, tangent) / arm);
        let (at, inverse) = meridian(&other);
        let radius = at[0];
        let by = tangents.map(|[tx, ty, tz]| [(x * tx + y * ty) / radius, tz]);
        let mate_by = inverse.map(|row| by.map(|by| row[0] * by[0] + row[1] * by[1]));
        let sum = [0, 1, 2].map(|k: usize| normal[k] + turned[k]);
        let inside = length(sum) < PARALLEL;
        let contact = FlankContact { rotation, place, point, normal, inside, at_end: false };
        (facing && slope[0].is_finite() && slope[1].is_finite()).then_some(Ray {
            contact,
            slope,
            mate,
            mate_by,
            arm,
        })
    }

    /// Returns the rotation to a point of the first flank, near a guess on this flank; `None` if
    /// this flank ends before, or faces the same way.
    pub fn ray_at(&self, driver: &Driver<'_>, place: [f64; 2], guess: Option<[f64; 2]>) -> Option<PointRay> {
        let ray = self.ray(driver, place, guess).filter(|ray| self.contains(ray.mate, ROUNDING));
        let Ray { contact, mate, arm, .. } = ray?;
        Some(PointRay { rotation: contact.rotation, mate, arm })
    }

    /// Returns whether a flank may have points in the radial and axial range of this one.
    fn is_near(&self, driver: &Driver<'_>) -> bool {
        let range = flank_range(driver.surface);
        let mut ends = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
        for (index, place) in grid(range).enumerate() {
            if (index / SAMPLES) % 2 == 1 || (index % SAMPLES) % 2 == 1 {
                continue;
            }
            let [x, y, z] = driver.pose.point(driver.surface.at(place[0], place[1]).position);
            for (end, value) in ends.iter_mut().zip([x.hypot(y), z]) {
                *end = [end[0].min(value), end[1].max(value)];
            }
        }
        (0..2).all(|k| ends[k][0] <= self.reach[k][1] && self.reach[k][0] <= ends[k][1])
    }

    /// Returns the contact with a flank of the first body; `None` if they do not face each other
    /// anywhere.
    pub fn contact(&self, driver: &Driver<'_>) -> Option<FlankContact> {
        if !self.is_near(driver) {
            return None;
        }
        let mut rotations: Vec<([f64; 2], f64)> = grid(flank_range(driver.surface))
            .filter_map(|place| Some((place, self.rough_rotation(driver, place)?)))
            .collect();
        let &(_, first) = rotations.first()?;
        let pushed = |rotation: f64| self.pushed * (nearest(rotation, first, TAU) - first);
        rotations.sort_by(|a, b| pushed(b.1).total_cmp(&pushed(a.1)));
        let ray =
            |place: [f64; 2]| self.ray(driver, place, None).filter(|ray| self.contains(ray.mate, ROUNDING));
        let best = rotations.iter().find_map(|(place, _)| ray(*place));
        self.climb(driver, best?)
    }

    /// Returns the contact near one at a neighbouring position.
    pub fn contact_near(&self, driver: &Driver<'_>, place: [f64; 2]) -> Option<FlankContact> {
        let start = self.ray(driver, place, None)?;
        self.climb(driver, start)
    }

    /// Moves to the extreme rotation within both flanks by Newton's method with a trust region. At
    /// an end of a flank, beyond which the rotation grows, it moves along this end. `None` if this
    /// flank has no point near the start.
    fn climb(&self, driver: &Driver<'_>, start: Ray) -> Option<FlankContact> {
        let range = flank_range(driver.surface);
        let spans = range.map(|[low, high]| high - low);
        let pushed = self.pushed;
        let (mut here, mut damping, mut previous, mut at_end) = (start, 1e-3, f64::INFINITY, false);
        for _ in 0..STEPS {
            let Some(local) = self.local(driver, &here) else { break };
            let (own, place) = (local.rotation.slope, here.contact.place);
            let is_inside = self.contains(here.mate, ROUNDING);
            let mut next = None;
            while damping < 1e12 {
                let Some(found) = local.rotation.damped(damping).largest(&local.bounds) else {
                    damping *= 10.0;
                    continue;
                };
                let size = found.step[0].abs().max(found.step[1].abs());
                if size <= SETTLED || (size <= 1e3 * SETTLED && size >= 0.5 * previous) {
                    at_end = found.is_limited && own[0].abs().max(own[1].abs()) > OUTWARDS;
                    break;
                }
                let target = [0, 1].map(|k: usize| place[k] + found.step[k] * spans[k]);
                let there = self.reached(driver, target, here.mate);
                let gained = |there: &Ray| {
                    let rotation = nearest(there.contact.rotation, here.contact.rotation, TAU);
                    !is_inside || pushed * (rotation - here.contact.rotation) >= -1e-15
                };
                next = there.filter(gained);
                if next.is_some() {
                    previous = size;
                    break;
                }
                damping *= 10.0;
            }
            let Some(there) = next else { break };
            here = there;
            damping = (damping * 0.05).max(1e-14);
        }
        let contact = FlankContact { at_end, ..here.contact };
        self.contains(here.mate, ROUNDING).then_some(contact)
    }

    /// Returns the rotation near a point as a function of steps, by differences of its slopes.
    fn local(&self, driver: &Driver<'_>, here: &Ray) -> Option<Local> {
        let range = flank_range(driver.surface);
        let spans = range.map(|[low, high]| high - low);
        let place = here.contact.place;
        // The slopes of the rotation, then those of both coordinates on the other flank.
        let slopes = |ray: &Ray| -> [[f64; 2]; 3] {
            let of = |slopes: [f64; 2], factor: f64| [0, 1].map(|k: usize| factor * slopes[k] * spans[k]);
            let [first, second] = ray.mate_by;
            [of(ray.slope, self.pushed), of(first, 1.0 / self.span(0)), of(second, 1.0 / self.span(1))]
        };
        let own = slopes(here);
        let column = |k: usize| -> Option<[[f64; 2]; 3]> {
            // Beyond an end of either flank the slopes are those of its edge.
            let is_inside = |sense: &f64| {
                let step = sense * DIFFERENCE;
                let at_mate = |l: usize| here.mate[l] + own[1 + l][k] * step * self.span(l);
                (range[k][0]..=range[k][1]).contains(&(place[k] + step * spans[k]))
                    && self.contains([at_mate(0), at_mate(1)], 0.0)
            };
            let inward = [1.0, -1.0].into_iter().find(is_inside).unwrap_or(1.0);
            [inward, -inward].into_iter().find_map(|sense| {
                let mut moved = place;
                moved[k] += sense * DIFFERENCE * spans[k];
                let there = slopes(&self.ray(driver, moved, Some(here.mate))?);
                let by = |m: usize, l: usize| (there[m][l] - own[m][l]) / (sense * DIFFERENCE);
                Some([0, 1, 2].map(|m: usize| [0, 1].map(|l: usize| by(m, l))))
            })
        };
        let (by_u, by_v) = (column(0)?, column(1)?);
        let second = |m: usize| [by_u[m][0], 0.5 * (by_u[m][1] + by_v[m][0]), by_v[m][1]];
        let own_end = |k: usize| Bound {
            normal: if k == 0 { [1.0, 0.0] } else { [0.0, 1.0] },
            limits: range[k].map(|end| (end - place[k]) / spans[k]),
        };
        let other_end = |l: usize| Bound {
            normal: own[1 + l],
            limits: self.range[l].map(|end| (end - here.mate[l]) / self.span(l)),
        };
        let mut rotation = Quadratic { slope: own[0], second: second(0) };
        for l in 0..2 {
            if let Some(end) = other_end(l).reached_by(rotation.slope) {
                rotation = rotation.along(end, second(1 + l));
            }
        }
        Some(Local { rotation, bounds: [own_end(0), own_end(1), other_end(0), other_end(1)] })
    }

    /// Returns the rotation to a point near a target whose mate is on this flank. `mate` is the
    /// guess of the mate.
    fn reached(&self, driver: &Driver<'_>, target: [f64; 2], mate: [f64; 2]) -> Option<Ray> {
        let range = flank_range(driver.surface);
        let spans = range.map(|[low, high]| high - low);
        let within = |place: [f64; 2]| [0, 1].map(|k: usize| place[k].clamp(range[k][0], range[k][1]));
        let mut ray = self.ray(driver, within(target), Some(mate))?;
        for _ in 0..CORRECTIONS {
            let beyond = [0, 1].map(|l: usize| {
                (ray.mate[l] - ray.mate[l].clamp(self.range[l][0], self.range[l][1])) / self.span(l)
            });
            if beyond[0].abs().max(beyond[1].abs()) <= SETTLED {
                break;
            }
            let by = |l: usize| [0, 1].map(|k: usize| ray.mate_by[l][k] * spans[k] / self.span(l));
            let (first, second) = (by(0), by(1));
            let back = |normal: [f64; 2], beyond: f64| {
                let size = normal[0] * normal[0] + normal[1] * normal[1];
                normal.map(|part| -beyond * part / size)
            };
            let step = match beyond.map(|part| part != 0.0) {
                [true, true] => {
                    let determinant = first[0] * second[1] - first[1] * second[0];
                    [
                        (beyond[1] * first[1] - beyond[0] * second[1]) / determinant,
                        (beyond[0] * second[0] - beyond[1] * first[0]) / determinant,
                    ]
                }
                [true, false] => back(first, beyond[0]),
                _ => back(second, beyond[1]),
            };
            let place = ray.contact.place;
            let moved = within([0, 1].map(|k: usize| place[k] + step[k] * spans[k]));
            if moved == place {
                break;
            }
            ray = self.ray(driver, moved, Some(ray.mate))?;
        }
        self.contains(ray.mate, ROUNDING).then_some(ray)
    }

    /// Returns the length of the range of a coordinate.
    fn span(&self, k: usize) -> f64 {
        self.range[k][1] - self.range[k][0]
    }
}

/// Returns the moment arm of a normal about the z axis through the origin, m.
pub(super) fn arm_about_z(point: [f64; 3], normal: [f64; 3]) -> f64 {
    cross(point, normal)[2]
}

/// Returns the pose of a body in the coordinates of another one.
pub(super) fn seen_from(pose: &Pose, other: &Pose) -> Pose {
    let back = |[x, y, z]: [f64; 3]| {
        let [a, b, c] = other.rotation;
        [0, 1, 2].map(|k: usize| x * a[k] + y * b[k] + z * c[k])
    };
    let columns = [0, 1, 2].map(|k: usize| back(pose.rotation.map(|row| row[k])));
    let rotation = [0, 1, 2].map(|k: usize| columns.map(|column| column[k]));
    Pose { rotation, origin: back(minus(pose.origin, other.origin)) }
}
