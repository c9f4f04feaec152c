//! Ease-off and path of unloaded contact of meshes on general axes, from the surfaces of the flanks
//! alone.
//!
//! The *lead* of a point of the first flank at a position is the rotation of the second gear that
//! would bring its flank into contact there, relative to the rotation by the ratio of the teeth, in
//! the sense in which the flank is pushed. Where the lead is greatest over the flank, the flanks
//! touch. Where the lead of a point is greatest over the positions, the point meets the surface
//! that is conjugate to the second flank. Its difference from the greatest lead of all points,
//! times the arm of the normal, is the ease-off: the normal distance of the flank from that surface
//! (Stadtfeld; Litvin and Fuentes, *Gear Geometry and Applied Theory*, 2004, chapter 9).
//!
//! Points have the coordinates of their surface as fractions of its range: along the face, and
//! along the profile from the fillet over the rounded tip edge.

use super::Bodies;
use super::flank_contact::{Driver, FlankContact, Mate, flank_range, nearest};
use crate::host::ModelHost;
use calyx_runtime::scene::{BodyId, GearMesh, Scene};
use calyx_runtime::surface::Surface;

/// Positions per pitch of a path of contact.
const STEPS: usize = 24;
/// Pitches by which a path extends beyond the contact in the interior of both flanks. Edges touch
/// there until the next pair overtakes, also where the contact ratio is less than one.
const BEYOND: f64 = 1.25;
/// Distance of the outermost points of the ease-off from the ends of the face, as a fraction: the
/// other flank may end slightly before.
const INSET: f64 = 0.005;
/// Numbers of points of an ease-off along the face and along the profile.
pub const EASE_OFF_POINTS: [usize; 2] = [25, 17];
/// Pitches on both sides of the first contact among which the conjugate position of a point is
/// searched, and steps per pitch of the search.
const SEARCH: [f64; 2] = [2.5, 8.0];
/// Leads that differ by less are equal: conjugate pairs touch together, rad.
const TOGETHER: f64 = 1e-9;
/// Positions on both sides of the conjugate one at which the gap is evaluated, and their distance
/// in steps of the path.
const GAPS: [usize; 2] = [6, 2];
/// Neighbouring tooth pairs that are compared.
const NEIGHBOURS: i32 = 4;

/// Unloaded contact of a tooth pair at a position.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UnloadedContact {
    /// Rotation of the first gear in its drive sense from time 0, rad.
    pub rotation: f64,
    /// Rotation by which the second gear lags behind the first one, rad, if this pair alone is in
    /// contact.
    pub transmission_error: f64,
    /// True if this pair leads its neighbours, so that it touches.
    pub touches: bool,
    /// True if a flank ends at the contact, so that an edge touches.
    pub edge: bool,
    /// Coordinates on both flanks.
    pub places: [[f64; 2]; 2],
}

/// Ease-off at a point of the first flank.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EaseOffPoint {
    /// Coordinates on both flanks.
    pub places: [[f64; 2]; 2],
    /// Normal distance from the surface conjugate to the second flank, m; zero at the point nearest
    /// to it.
    pub ease_off: f64,
    /// Smallest normal distance from the second flank while the unloaded pair rotates, m; infinite
    /// far from the path of contact.
    pub gap: f64,
}

/// Ease-off and unloaded contact of one pair of flanks.
#[derive(Clone, Debug, PartialEq)]
pub struct Topography {
    /// Pitch angle of the first gear, rad.
    pub pitch: f64,
    /// Path of contact of one tooth pair.
    pub path: Vec<UnloadedContact>,
    /// Points of the ease-off with their column along the face and row along the profile. Points
    /// opposite to which the second flank ends are missing.
    pub ease_off: Vec<([usize; 2], EaseOffPoint)>,
}

/// Pair of flanks of a mesh on general axes.
pub struct FlankPair {
    bodies: Bodies,
    /// Names of the bodies.
    pub names: [String; 2],
    /// Flank of each body: 0 is the counter-clockwise one.
    pub surfaces: [usize; 2],
    /// True for the coast flanks of the mesh.
    pub coast: bool,
    mesh: GearMesh,
    /// Phases of both bodies, with the rotation that a loop leaves, rad.
    phases: [f64; 2],
}

/// Returns the flank pairs of all meshes on general axes of a model.
pub fn flank_pairs(host: &ModelHost) -> Vec<FlankPair> {
    let scene = &host.scene;
    let pair = |pair: &calyx_runtime::scene::SurfacePair| {
        let mesh = pair.mesh.clone().filter(|mesh| mesh.first_contact.is_some())?;
        FlankPair::new(scene, pair.bodies, (pair.surfaces, pair.front.is_some()), mesh)
    };
    scene.pairs.iter().filter_map(pair).collect()
}

/// Position of a point on the first flank at its conjugate position.
#[derive(Clone, Copy)]
struct Conjugate {
    rotation: f64,
    lead: f64,
    arm: f64,
    mate: [f64; 2],
}

/// Flank pair with its search data.
struct Search<'a> {
    pair: &'a FlankPair,
    mate: Mate<'a>,
    surface: &'a dyn Surface,
    tooth: u32,
}

impl FlankPair {
    fn new(
        scene: &Scene,
        ids: [BodyId; 2],
        (surfaces, coast): ([u32; 2], bool),
        mesh: GearMesh,
    ) -> Option<FlankPair> {
        let phases = ids.map(|id| scene.bodies[id.0].phase);
        Some(FlankPair {
            bodies: Bodies::of(scene, ids).ok()?,
            names: ids.map(|id| scene.bodies[id.0].name.clone()),
            surfaces: surfaces.map(|surface| surface as usize),
            coast,
            phases: [phases[0], phases[1] + mesh.phase_offset],
            mesh,
        })
    }

    /// Returns the surface of a side.
    pub fn surface(&self, side: usize) -> &dyn Surface {
        self.bodies.flanks[side].surfaces[self.surfaces[side]].as_ref()
    }

    /// Computes ease-off and unloaded contact; `None` if the flanks do not touch.
    pub fn topography(&self) -> Option<Topography> {
        let touching = self.bodies.first_contact(self.surfaces, self.phases[0])?;
        let search = Search {
            pair: self,
            mate: Mate::new(self.surface(1)),
            surface: self.surface(0),
            tooth: touching.tooth,
        };
        let sense = self.mesh.drive_sense;
        let pitch = self.bodies.pitches[0];
        let ends = self.bodies.path(self.surfaces, self.phases[0], sense, &touching).ends;
        let path = search.path(ends.unwrap_or([-0.5 * pitch, 0.5 * pitch]), &touching.contact);
        let ease_off = search.ease_off(&path);
        Some(Topography { pitch, path, ease_off })
    }

    /// Coordinates of a point on the surface of a side, as fractions.
    fn fractions(&self, side: usize, place: [f64; 2]) -> [f64; 2] {
        let [u, v] = self.surface(side).range();
        let fraction = |value: f64, [low, high]: [f64; 2]| (value - low) / (high - low);
        [fraction(place[1], v), fraction(place[0], u)]
    }
}

impl Search<'_> {
    fn driver(&self, rotation: f64) -> Driver<'_> {
        let FlankPair { bodies, mesh, phases, .. } = self.pair;
        let pose = bodies.tooth_pose(self.tooth, phases[0] + mesh.drive_sense * rotation);
        Driver { surface: self.surface, pose }
    }

    /// Lead of a rotation of the second gear, with the first one rotated in its drive sense.
    fn lead(&self, rotation: f64, second: f64) -> f64 {
        let FlankPair { bodies, mesh, phases, .. } = self.pair;
        let ratio = f64::from(mesh.teeth[0]) / f64::from(mesh.teeth[1]);
        let by_ratio = phases[1] - mesh.sign * ratio * mesh.drive_sense * rotation;
        self.mate.pushed * (nearest(second, by_ratio, bodies.pitches[1]) - by_ratio)
    }

    /// Follows the contact of the tooth from before it enters to after it leaves contact in the
    /// interior of the flanks.
    fn path(&self, [begin, end]: [f64; 2], start: &FlankContact) -> Vec<UnloadedContact> {
        let step = self.pair.bodies.pitches[0] / STEPS as f64;
        let beyond = BEYOND * STEPS as f64;
        let low = (begin / step - beyond).floor() as i32;
        let high = (end / step + beyond).ceil() as i32;
        let mut found: Vec<(i32, UnloadedContact)> = Vec::new();
        let middle = (low + high) / 2;
        let range: [Vec<i32>; 2] = [(middle..=high).collect(), (low..middle).rev().collect()];
        for steps in range {
            let mut place = start.place;
            for k in steps {
                let rotation = f64::from(k) * step;
                let driver = self.driver(rotation);
                let near = self.mate.contact_near(&driver, place).filter(|contact| contact.inside);
                let Some(contact) = near.or_else(|| self.mate.contact(&driver)) else { continue };
                place = contact.place;
                let Some(mate) = self.mate.ray_at(&driver, place, None) else { continue };
                let lead = self.lead(rotation, contact.rotation);
                let places = [self.pair.fractions(0, place), self.pair.fractions(1, mate.mate)];
                let edge = !contact.inside;
                let transmission_error = -lead;
                found
                    .push((k, UnloadedContact { rotation, transmission_error, touches: true, edge, places }));
            }
        }
        found.sort_by_key(|(k, _)| *k);
        let errors: std::collections::BTreeMap<i32, f64> =
            found.iter().map(|(k, contact)| (*k, contact.transmission_error)).collect();
        // A contact that was not found between two others lies between them.
        let error = |k: i32| {
            let between = || Some(0.5 * (errors.get(&(k - 1))? + errors.get(&(k + 1))?));
            errors.get(&k).copied().or_else(between)
        };
        for (k, contact) in &mut found {
            let mut others = (-NEIGHBOURS..=NEIGHBOURS).filter(|pair| *pair != 0);
            contact.touches = others.all(|pair| {
                error(*k + pair * STEPS as i32)
                    .is_none_or(|other| other >= contact.transmission_error - TOGETHER)
            });
        }
        found.into_iter().map(|(_, contact)| contact).collect()
    }

    /// Greatest lead of a path and its neighbours at a rotation; `None` beyond the path.
    fn carried(&self, path: &[UnloadedContact], rotation: f64) -> Option<f64> {
        let pitch = self.pair.bodies.pitches[0];
        let at = |rotation: f64| {
            let behind = path.partition_point(|contact| contact.rotation < rotation);
            let (from, to) = (path.get(behind.checked_sub(1)?)?, path.get(behind)?);
            let part = (rotation - from.rotation) / (to.rotation - from.rotation);
            Some(-from.transmission_error - part * (to.transmission_error - from.transmission_error))
        };
        (-NEIGHBOURS..=NEIGHBOURS)
            .filter_map(|pair| at(rotation + f64::from(pair) * pitch))
            .max_by(f64::total_cmp)
    }

    fn ease_off(&self, path: &[UnloadedContact]) -> Vec<([usize; 2], EaseOffPoint)> {
        let [u, [first, last]] = flank_range(self.surface);
        let inset = INSET * (last - first);
        let v = [first + inset, last - inset];
        let [columns, rows] = EASE_OFF_POINTS;
        let at = |[low, high]: [f64; 2], k: usize, count: usize| {
            low + (high - low) * k as f64 / (count - 1) as f64
        };
        let mut points: Vec<([usize; 2], [f64; 2], Conjugate)> = Vec::new();
        let mut before: Vec<Option<f64>> = vec![None; rows];
        for column in 0..columns {
            let mut below = None;
            for (row, left) in before.iter_mut().enumerate() {
                let place = [at(u, row, rows), at(v, column, columns)];
                let near = below.or(*left);
                let found = near.and_then(|near| self.conjugate(place, near));
                let found = found.or_else(|| self.conjugate(place, self.scan(place)?));
                (below, *left) = (found.map(|one| one.rotation), found.map(|one| one.rotation));
                points.extend(found.map(|one| ([column, row], place, one)));
            }
        }
        let largest = points.iter().map(|(.., one)| one.lead).fold(f64::NEG_INFINITY, f64::max);
        let point = |(index, place, one): ([usize; 2], [f64; 2], Conjugate)| {
            let places = [self.pair.fractions(0, place), self.pair.fractions(1, one.mate)];
            let ease_off = (largest - one.lead) * one.arm.abs();
            let gap = self.smallest_gap(path, place, &one);
            (index, EaseOffPoint { places, ease_off, gap })
        };
        points.into_iter().map(point).collect()
    }

    /// Smallest normal distance of a point from the second flank over the positions near that of
    /// its greatest lead, m.
    fn smallest_gap(&self, path: &[UnloadedContact], place: [f64; 2], at: &Conjugate) -> f64 {
        let [count, steps] = GAPS;
        let step = self.pair.bodies.pitches[0] * steps as f64 / STEPS as f64;
        let gap =
            |one: &Conjugate| Some(((self.carried(path, one.rotation)? - one.lead) * one.arm.abs()).max(0.0));
        let mut smallest = gap(at).unwrap_or(f64::INFINITY);
        for sense in [-1.0, 1.0] {
            let mut guess = at.mate;
            for k in 1..=count {
                let rotation = at.rotation + sense * k as f64 * step;
                let Some(one) = self.lead_of(place, rotation, Some(guess)) else { break };
                guess = one.mate;
                smallest = smallest.min(gap(&one).unwrap_or(f64::INFINITY));
            }
        }
        smallest
    }

    /// Lead of a point at a rotation; `None` if the second flank ends before.
    fn lead_of(&self, place: [f64; 2], rotation: f64, guess: Option<[f64; 2]>) -> Option<Conjugate> {
        let ray = self.mate.ray_at(&self.driver(rotation), place, guess)?;
        let lead = self.lead(rotation, ray.rotation);
        Some(Conjugate { rotation, lead, arm: ray.arm, mate: ray.mate })
    }

    /// Rotation of the greatest lead of a point among equally spaced ones.
    fn scan(&self, place: [f64; 2]) -> Option<f64> {
        let [pitches, per_pitch] = SEARCH;
        let most = (pitches * per_pitch) as i32;
        let step = self.pair.bodies.pitches[0] / per_pitch;
        let leads = (-most..=most).filter_map(|k| self.lead_of(place, f64::from(k) * step, None));
        leads.max_by(|a, b| a.lead.total_cmp(&b.lead)).map(|one| one.rotation)
    }

    /// Moves to the greatest lead of a point near a rotation, by parabolas through three positions;
    /// `None` if the second flank ends before.
    fn conjugate(&self, place: [f64; 2], near: f64) -> Option<Conjugate> {
        let pitch = self.pair.bodies.pitches[0];
        let mut here = self.lead_of(place, near, None)?;
        let mut step = pitch / 16.0;
        for _ in 0..24 {
            let guess = Some(here.mate);
            let around = [-1.0, 1.0].map(|sense| self.lead_of(place, here.rotation + sense * step, guess));
            let [Some(low), Some(high)] = around else {
                // The second flank ends within the step.
                step *= 0.25;
                if step < 1e-6 * pitch {
                    return None;
                }
                continue;
            };
            let slope = 0.5 * (high.lead - low.lead);
            let bend = high.lead + low.lead - 2.0 * here.lead;
            if bend >= 0.0 {
                // Not near the extreme: moves on in the direction of ascent.
                here = if high.lead > low.lead { high } else { low };
                continue;
            }
            let moved = (-slope / bend).clamp(-2.0, 2.0);
            let next = self.lead_of(place, here.rotation + moved * step, guess);
            match next {
                Some(next) => here = next,
                None => {
                    step *= 0.25;
                    if step < 1e-6 * pitch {
                        return None;
                    }
                    continue;
                }
            }
            if moved.abs() < 1.0 {
                if step < 1e-3 * pitch {
                    return Some(here);
                }
                step *= 0.125;
            }
        }
        None
    }
}
