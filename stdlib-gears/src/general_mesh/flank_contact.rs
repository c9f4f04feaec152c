//! Unloaded contact of two rigid flanks on general axes, from the surfaces alone.
//!
//! A point of the first flank needs a rotation of the second body to meet the point of the second
//! flank with the same radius and axial position. Contact is where this rotation is an extreme over
//! the first flank: in its interior the normals are parallel there, otherwise a flank ends
//! (Stadtfeld calls the function the ease-off). The extreme exists for point and for line contact.
//!
//! See `docs/theory/gear-geometry.md`.

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
/// Step of a coordinate, relative to its range, at which an iteration ends.
const SETTLED: f64 = 1e-13;
/// Part of its range by which a coordinate may be outside: rounding.
const ROUNDING: f64 = 1e-9;
/// Margin of the radial and axial range of the second flank in the search for near teeth, relative
/// to its size.
const NEAR: f64 = 0.05;

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
    /// True if the rotation has an extreme here because a flank of the first body ends.
    pub at_end: bool,
}

/// Flank of the second body about its axis, the z axis of its coordinates.
pub(super) struct Mate<'a> {
    surface: &'a dyn Surface,
    range: [[f64; 2]; 2],
    /// Sense in which the flank is pushed about the axis: +1 is counter-clockwise.
    pub pushed: f64,
    /// Samples: coordinates, radius and axial position.
    samples: Vec<([f64; 2], [f64; 2])>,
    /// Ranges of radius and axial position with a margin, m.
    reach: [[f64; 2]; 2],
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
    mate: [f64; 2],
    arm: f64,
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
    let at = |[low, high]: [f64; 2], k: usize| low + (high - low) * k as f64 / (SAMPLES - 1) as f64;
    (0..SAMPLES).flat_map(move |i| (0..SAMPLES).map(move |j| [at(u, i), at(v, j)]))
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
        let samples: Vec<([f64; 2], [f64; 2])> = grid(range)
            .map(|place| {
                let [x, y, z] = surface.at(place[0], place[1]).position;
                (place, [x.hypot(y), z])
            })
            .collect();
        let reach = [0, 1].map(|k: usize| {
            let values = samples.iter().map(|(_, at)| at[k]);
            let low = values.clone().fold(f64::INFINITY, f64::min);
            let high = values.fold(f64::NEG_INFINITY, f64::max);
            let margin = NEAR * (high - low);
            [low - margin, high + margin]
        });
        Mate { surface, range, pushed: -outward.signum(), samples, reach }
    }

    /// Returns the coordinates of the sample next to a radius and axial position.
    fn nearest_sample(&self, target: [f64; 2]) -> Option<[f64; 2]> {
        let distance = |at: &[f64; 2]| (at[0] - target[0]).powi(2) + (at[1] - target[1]).powi(2);
        let distances = self.samples.iter().map(|(place, at)| (*place, distance(at)));
        distances.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(place, _)| place)
    }

    /// Returns the point with this radius and axial position and its coordinates; `None` if the
    /// flank ends before.
    fn partner(&self, target: [f64; 2], guess: Option<[f64; 2]>) -> Option<([f64; 2], SurfacePoint)> {
        let mut place = match guess {
            Some(guess) => guess,
            None => self.nearest_sample(target)?,
        };
        let spans = self.range.map(|[low, high]| high - low);
        let mut previous = f64::INFINITY;
        for _ in 0..STEPS {
            let point = self.surface.at(place[0], place[1]);
            let [x, y, z] = point.position;
            let radius = x.hypot(y);
            let short = [target[0] - radius, target[1] - z];
            let radial = point.tangents.map(|[tx, ty, _]| (x * tx + y * ty) / radius);
            let axial = point.tangents.map(|[.., tz]| tz);
            let determinant = radial[0] * axial[1] - radial[1] * axial[0];
            let step = [
                (short[0] * axial[1] - short[1] * radial[1]) / determinant,
                (short[1] * radial[0] - short[0] * axial[0]) / determinant,
            ];
            let size = (step[0] / spans[0]).abs().max((step[1] / spans[1]).abs());
            if !size.is_finite() {
                return None;
            }
            if size <= SETTLED || (size <= 1e3 * SETTLED && size >= 0.5 * previous) {
                let inside = |k: usize| {
                    let margin = ROUNDING * spans[k];
                    (self.range[k][0] - margin..=self.range[k][1] + margin).contains(&place[k])
                };
                return (inside(0) && inside(1)).then_some((place, point));
            }
            // The surface continues slightly beyond its ends.
            let next = [0, 1].map(|k: usize| {
                let beyond = NEAR * spans[k];
                (place[k] + step[k]).clamp(self.range[k][0] - beyond, self.range[k][1] + beyond)
            });
            if next == place {
                return None;
            }
            previous = size;
            place = next;
        }
        None
    }

    /// Returns the rotation to a point of the first flank; `None` if this flank has no point with
    /// its radius and axial position, or faces the same way.
    fn ray(&self, driver: &Driver<'_>, place: [f64; 2], guess: Option<[f64; 2]>) -> Option<Ray> {
        let own = driver.surface.at(place[0], place[1]);
        let (point, normal) = (driver.pose.point(own.position), driver.pose.direction(own.normal));
        let [x, y, z] = point;
        let (mate, other) = self.partner([x.hypot(y), z], guess)?;
        let [ox, oy, _] = other.position;
        // The angle between the two radii, to rounding also where it is small.
        let rotation = (ox * y - oy * x).atan2(ox * x + oy * y);
        let (sine, cosine) = rotation.sin_cos();
        let [nx, ny, nz] = other.normal;
        let turned = [cosine * nx - sine * ny, sine * nx + cosine * ny, nz];
        let facing = dot(normal, turned) < 0.0;
        let arm = turned[1] * x - turned[0] * y;
        let slope = own.tangents.map(|tangent| dot(turned, driver.pose.direction(tangent)) / arm);
        let sum = [0, 1, 2].map(|k: usize| normal[k] + turned[k]);
        let inside = length(sum) < PARALLEL;
        let contact = FlankContact { rotation, place, point, normal, inside, at_end: false };
        (facing && slope[0].is_finite() && slope[1].is_finite()).then_some(Ray { contact, slope, mate, arm })
    }

    /// Returns the rotation to a point of the first flank, near a guess on this flank; `None` if
    /// this flank ends before, or faces the same way.
    pub fn ray_at(&self, driver: &Driver<'_>, place: [f64; 2], guess: Option<[f64; 2]>) -> Option<PointRay> {
        let Ray { contact, mate, arm, .. } = self.ray(driver, place, guess)?;
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
        let mut best: Option<Ray> = None;
        let mut neighbour = None;
        for place in grid(flank_range(driver.surface)) {
            let near = neighbour.and_then(|mate| self.ray(driver, place, Some(mate)));
            let Some(ray) = near.or_else(|| self.ray(driver, place, None)) else {
                neighbour = None;
                continue;
            };
            neighbour = Some(ray.mate);
            let further = |best: &Ray| {
                let rotation = nearest(ray.contact.rotation, best.contact.rotation, TAU);
                self.pushed * (rotation - best.contact.rotation) > 0.0
            };
            if best.as_ref().is_none_or(further) {
                best = Some(ray);
            }
        }
        Some(self.climb(driver, best?))
    }

    /// Returns the contact near one at a neighbouring position.
    pub fn contact_near(&self, driver: &Driver<'_>, place: [f64; 2]) -> Option<FlankContact> {
        let start = self.ray(driver, place, None)?;
        Some(self.climb(driver, start))
    }

    /// Moves to the extreme rotation by Newton's method with a trust region.
    fn climb(&self, driver: &Driver<'_>, start: Ray) -> FlankContact {
        let range = flank_range(driver.surface);
        let spans = range.map(|[low, high]| high - low);
        let pushed = self.pushed;
        // Derivatives of the rotation in the sense of the push, by coordinates relative to their
        // ranges.
        let slope = |ray: &Ray| [0, 1].map(|k: usize| pushed * ray.slope[k] * spans[k]);
        let mut here = start;
        let mut damping = 1e-3;
        for _ in 0..STEPS {
            let own = slope(&here);
            let place = here.contact.place;
            let column = |k: usize| -> Option<[f64; 2]> {
                let inward = if place[k] + DIFFERENCE * spans[k] <= range[k][1] { 1.0 } else { -1.0 };
                [inward, -inward].into_iter().find_map(|sense| {
                    let mut moved = place;
                    moved[k] += sense * DIFFERENCE * spans[k];
                    let there = slope(&self.ray(driver, moved, Some(here.mate))?);
                    Some([0, 1].map(|l: usize| (there[l] - own[l]) / (sense * DIFFERENCE)))
                })
            };
            let (Some(by_u), Some(by_v)) = (column(0), column(1)) else { break };
            let mixed = 0.5 * (by_u[1] + by_v[0]);
            let size = by_u[0].abs().max(by_v[1].abs()).max(mixed.abs());
            if size == 0.0 {
                break;
            }
            let mut next = None;
            while damping < 1e12 {
                let (a, b) = (by_u[0] - damping * size, by_v[1] - damping * size);
                let determinant = a * b - mixed * mixed;
                let mut step = [
                    (mixed * own[1] - b * own[0]) / determinant,
                    (mixed * own[0] - a * own[1]) / determinant,
                ];
                if !(determinant > 0.0 && a < 0.0) {
                    damping *= 10.0;
                    continue;
                }
                let target = [0, 1].map(|k: usize| {
                    let free = place[k] + step[k] * spans[k];
                    let clamped = free.clamp(range[k][0], range[k][1]);
                    step[k] = (clamped - place[k]) / spans[k];
                    clamped
                });
                if step[0].abs().max(step[1].abs()) <= SETTLED {
                    break;
                }
                let there = self.ray(driver, target, Some(here.mate));
                let gained = |there: &Ray| {
                    let rotation = nearest(there.contact.rotation, here.contact.rotation, TAU);
                    pushed * (rotation - here.contact.rotation) >= -1e-15
                };
                next = there.filter(gained);
                if next.is_some() {
                    break;
                }
                damping *= 10.0;
            }
            let Some(there) = next else { break };
            here = there;
            damping = (damping * 0.05).max(1e-14);
        }
        let (place, own) = (here.contact.place, slope(&here));
        // 1 if the rotation grows beyond an end, and 0 if it does not change.
        let grows = [0, 1].map(|k: usize| match () {
            () if place[k] <= range[k][0] && own[k] < -OUTWARDS => Some(1),
            () if place[k] >= range[k][1] && own[k] > OUTWARDS => Some(1),
            () if own[k].abs() <= OUTWARDS => Some(0),
            () => None,
        });
        let at_end = matches!(grows, [Some(1), Some(_)] | [Some(_), Some(1)]);
        FlankContact { at_end, ..here.contact }
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
