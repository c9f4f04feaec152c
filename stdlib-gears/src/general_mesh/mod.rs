//! Meshes of toothed bodies on intersecting, offset or crossed axes, from the numbers of teeth, the
//! frames and the flanks alone.
//!
//! The second body is phased by bringing rigid flanks into contact at time 0. The mesh cycle starts
//! where a pair of teeth enters unloaded contact with both flanks, and lasts one pitch.
//!
//! See `docs/theory/gear-geometry.md`.

mod bounded_step;
mod checks;
#[cfg(test)]
mod contact_tests;
mod flank_contact;
pub mod tooth_chart;
pub mod topography;

use self::checks::{Carried, check_speeds, no_contact, trace_angle};
use self::flank_contact::{Driver, FlankContact, Mate, arm_about_z, nearest, seen_from};
use crate::assembly::{MeshOptions, Misalignment, drive_sense, meet_once};
use crate::error::{GeometryError, Refusal};
use crate::phase_check::may_rotate;
use calyx_runtime::contact::solid::Pose;
use calyx_runtime::error::EngineError;
use calyx_runtime::motion::spatial_pose;
use calyx_runtime::scene::{
    BodyId, FirstContact, GearMesh, GridOptions, PairId, Scene, SurfacePair, ToothFlanks,
};
use std::f64::consts::TAU;

pub(crate) use self::checks::is_general;

/// Steps per pitch of the search for the ends of contact, and the number of pitches searched.
const STEPS_PER_PITCH: f64 = 16.0;
const PITCHES: f64 = 4.0;
/// Bisections of the ends of contact.
const BISECTIONS: usize = 30;
/// Steps by which an end of contact is too early. Searches from different places agree to less.
const TOO_EARLY: f64 = 1e-6;
/// Largest deviation, in pitches, of the rotation for one tooth from that for another: beyond it,
/// flanks are far from contact.
const IN_MESH: f64 = 0.25;
/// Negative backlash up to this fraction of the pitch is attributed to rounded input data.
const ROUNDING_OF_DATA: f64 = 1e-4;
/// Backlash as a fraction of the pitch that is reported. Drawings state about a fiftieth; the
/// thinnest teeth of published test gears leave a fifth.
const LARGE_BACKLASH: f64 = 0.25;
/// Iterations of the phase of the first body, which moves the contact.
const PHASES: usize = 12;
/// Misplacement of teeth in a loop, in pitches, that is impossible; smaller ones are position
/// errors of axes and remain in the contact problem.
const IMPOSSIBLE: f64 = 0.1;

/// Mesh on general axes.
#[derive(Clone, Debug, PartialEq)]
pub struct GeneralMesh {
    /// Surface pair of the drive flanks.
    pub pair: PairId,
    /// Rotation of the second body between its flanks with the first one fixed at time 0, rad;
    /// `None` if its coast flanks do not come into contact.
    pub backlash: Option<f64>,
    /// Warnings about the pair.
    pub warnings: Vec<GeometryError>,
}

/// Two toothed bodies at time 0.
struct Bodies {
    flanks: [ToothFlanks; 2],
    poses: [Pose; 2],
    /// Pitch angles, rad.
    pitches: [f64; 2],
}

/// Contact of a tooth of the first body.
#[derive(Clone, Copy)]
struct ToothContact {
    tooth: u32,
    contact: FlankContact,
}

/// Path of unloaded contact of a pair of teeth.
struct Path {
    /// Rotations of the first body in the drive sense at which its reference tooth enters and
    /// leaves contact, rad; `None` if only edges touch.
    ends: Option<[f64; 2]>,
}

impl Bodies {
    fn of(scene: &Scene, ids: [BodyId; 2]) -> Result<Bodies, EngineError> {
        let flanks = |member: usize| {
            scene.bodies[ids[member].0].prototype.tooth_flanks().ok_or_else(|| {
                let message = format!("body {} of the scene carries no gear", ids[member].0);
                EngineError::new("E0653", message, "mesh bodies whose prototype has teeth")
                    .blame(["first", "second"][member])
            })
        };
        let flanks = [flanks(0)?, flanks(1)?];
        let pose = |member: usize| spatial_pose(scene.bodies[ids[member].0].motion.as_ref(), 0.0);
        let pitches = [0, 1].map(|member: usize| TAU / f64::from(flanks[member].teeth));
        Ok(Bodies { poses: [pose(0)?, pose(1)?], flanks, pitches })
    }

    /// Returns the pose of a tooth of the first body in the coordinates of the second, with the
    /// body rotated by an angle (rad).
    fn tooth_pose(&self, tooth: u32, angle: f64) -> Pose {
        let angle = angle + f64::from(tooth) * self.pitches[0];
        seen_from(&self.poses[0].rotated_first(angle), &self.poses[1])
    }

    /// Returns the contacts of all teeth of the first body, rotated by an angle (rad).
    fn contacts(&self, surfaces: [usize; 2], angle: f64) -> Vec<ToothContact> {
        let mate = Mate::new(self.flanks[1].surfaces[surfaces[1]].as_ref());
        let surface = self.flanks[0].surfaces[surfaces[0]].as_ref();
        (0..self.flanks[0].teeth)
            .filter_map(|tooth| {
                let driver = Driver { surface, pose: self.tooth_pose(tooth, angle) };
                mate.contact(&driver).map(|contact| ToothContact { tooth, contact })
            })
            .collect()
    }

    /// Returns the contact that stops the second body, and its rotation, rad; the tooth whose
    /// contact is in the interior of both flanks is the reference if there is one.
    fn first_contact(&self, surfaces: [usize; 2], angle: f64) -> Option<ToothContact> {
        let mate = Mate::new(self.flanks[1].surfaces[surfaces[1]].as_ref());
        let contacts = self.contacts(surfaces, angle);
        let reference = contacts.iter().find(|one| one.contact.inside).or(contacts.first())?;
        let at = reference.contact.rotation;
        let pitch = self.pitches[1];
        let aligned = |one: &ToothContact| nearest(one.contact.rotation, at, pitch);
        let in_mesh = contacts.iter().filter(|one| (aligned(one) - at).abs() < IN_MESH * pitch);
        let further = |a: &&ToothContact, b: &&ToothContact| {
            (mate.pushed * aligned(a)).total_cmp(&(mate.pushed * aligned(b)))
        };
        in_mesh.max_by(further).copied()
    }

    /// Follows the contact of one tooth while the first body rotates in its drive sense.
    fn path(&self, surfaces: [usize; 2], angle: f64, sense: f64, start: &ToothContact) -> Path {
        let mate = Mate::new(self.flanks[1].surfaces[surfaces[1]].as_ref());
        let surface = self.flanks[0].surfaces[surfaces[0]].as_ref();
        let at = |rolled: f64| Driver { surface, pose: self.tooth_pose(start.tooth, angle + sense * rolled) };
        let touches = |rolled: f64, place: [f64; 2]| -> Option<[f64; 2]> {
            let driver = at(rolled);
            let found = mate.contact_near(&driver, place).filter(|contact| contact.inside || contact.at_end);
            let found = found.or_else(|| mate.contact(&driver))?;
            found.inside.then_some(found.place)
        };
        let touches_near = |rolled: f64, place: [f64; 2]| {
            mate.contact_near(&at(rolled), place)
                .filter(|contact| contact.inside)
                .map(|contact| contact.place)
        };
        let step = self.pitches[0] / STEPS_PER_PITCH;
        let most = (PITCHES * STEPS_PER_PITCH) as i32;
        // Between contacts at edges the contact in the interior may begin some steps away.
        let begin = (0..=most / 2).flat_map(|k| [k, -k]).find_map(|k| {
            let rolled = f64::from(k) * step;
            touches(rolled, start.contact.place).map(|place| (rolled, place))
        });
        let Some((begin, place)) = begin else { return Path { ends: None } };
        let end = |towards: f64| {
            let (mut inside, mut place) = (begin, place);
            for _ in 0..most {
                let next = inside + towards * step;
                let Some(there) = touches(next, place) else {
                    // A search on the whole flank finds no contact beyond the end, at the cost of
                    // many searches near the last one. It is needed only where these end too early.
                    let [end, _] = bisected([inside, next], place, touches_near);
                    return match touches(end + towards * TOO_EARLY * step, place) {
                        Some(_) => bisected([inside, next], place, touches)[0],
                        None => end,
                    };
                };
                (inside, place) = (next, there);
            }
            inside
        };
        Path { ends: Some([end(-1.0), end(1.0)]) }
    }
}

/// Returns rotations before and beyond the end of contact, rad, from such rotations and the place
/// of the contact at the first one.
fn bisected(
    [mut inside, mut outside]: [f64; 2],
    mut place: [f64; 2],
    touches: impl Fn(f64, [f64; 2]) -> Option<[f64; 2]>,
) -> [f64; 2] {
    for _ in 0..BISECTIONS {
        let middle = 0.5 * (inside + outside);
        match touches(middle, place) {
            Some(there) => (inside, place) = (middle, there),
            None => outside = middle,
        }
    }
    [inside, outside]
}

/// Puts two toothed bodies on general axes in mesh, as [`crate::assembly::mesh`] does on parallel
/// ones.
///
/// # Errors
/// E0650, E0651: the speeds do not match the numbers of teeth. E0653: a body has no teeth. E0884:
/// the flanks do not come into contact. E0885: a misalignment is given. E0886: the axes move
/// relative to each other.
/// E0887: the mesh closes a loop whose teeth do not fit. E0648: the teeth of two helical gears
/// cross.
pub fn general_mesh(
    scene: &mut Scene,
    ids: [BodyId; 2],
    options: &MeshOptions,
) -> Result<GeneralMesh, Refusal> {
    if options.misalignment != Misalignment::default() {
        return Err(checks::misaligned().into());
    }
    meet_once(scene, ids)?;
    let bodies = Bodies::of(scene, ids)?;
    let carried = Carried::of(scene, ids)?;
    let carrier = carried.angular_velocity();
    trace_angle(scene, ids)?;
    let teeth = [0, 1].map(|member: usize| bodies.flanks[member].teeth);
    let speeds = check_speeds(&carried, teeth)?;
    let sign = -(speeds[0] * speeds[1]).signum();
    let sense = match options.torque_on_first {
        0.0 => drive_sense(scene, ids, sign, speeds[0])?,
        torque => -torque.signum(),
    };
    let surfaces = surfaces(sense, sign);
    let mut phases = ids.map(|id| scene.bodies[id.0].phase);
    let pitch = bodies.pitches[1];
    let needed = |phase: f64| {
        let touching = bodies.first_contact(surfaces, phase);
        touching.ok_or_else(|| no_contact(bodies.touches_reversed(sense, sign, phase)))
    };
    let mut touching = needed(phases[0])?;
    let mut warnings = Vec::new();
    let tabulated = checks::has_tabulated_teeth(scene, ids);
    let off = |touching: &ToothContact, phase: f64| nearest(touching.contact.rotation - phase, 0.0, pitch);
    let mut left = 0.0;
    match may_rotate(scene, ids) {
        Some(1) => phases[1] = nearest(touching.contact.rotation, 0.0, pitch),
        Some(_) => {
            for _ in 0..PHASES {
                let more = off(&touching, phases[1]);
                phases[0] += sign * more * f64::from(teeth[1]) / f64::from(teeth[0]);
                touching = needed(phases[0])?;
                if more.abs() <= 1e-15 {
                    break;
                }
            }
        }
        None => {
            left = off(&touching, phases[1]);
            if left.abs() > IMPOSSIBLE * pitch {
                return Err(checks::unfit_loop(left).into());
            }
        }
    }
    let cycle = Cycle { bodies: &bodies, teeth, speeds, carrier, sign, phases, left };
    let (mesh, contact_ratio) = cycle.mesh(surfaces, sense, &touching);
    warnings.extend(contact_ratio.and_then(|ratio| checks::low_contact_ratio(ratio, tabulated)));
    if contact_ratio.is_none() {
        warnings.push(checks::edge_contact(tabulated));
    }
    let coast_surfaces = surfaces.map(|surface| 1 - surface);
    let coast = bodies.first_contact(coast_surfaces, phases[0]);
    let backlash = coast.map(|coast| {
        let driven = phases[1] + left;
        let pushed = Mate::new(bodies.flanks[1].surfaces[surfaces[1]].as_ref()).pushed;
        // Backlash may exceed half a pitch, an overlap is a small part of it.
        nearest(pushed * (coast.contact.rotation - driven), 0.25 * pitch, pitch)
    });
    if !options.coast_side_contact
        && let Some(overlap) = backlash.filter(|backlash| *backlash < -ROUNDING_OF_DATA * pitch)
    {
        warnings.push(checks::no_backlash(-overlap * mesh.base_radii[1], tabulated));
    }
    if tabulated && let Some(large) = backlash.filter(|backlash| *backlash > LARGE_BACKLASH * pitch) {
        warnings.push(checks::large_backlash(large, pitch));
    }
    let back = coast
        .filter(|_| options.coast_side_contact)
        .map(|coast| cycle.mesh(coast_surfaces, -sense, &coast).0);
    for (member, phase) in phases.into_iter().enumerate() {
        scene.bodies[ids[member].0].phase = phase;
    }
    let grid = GridOptions {
        half_cells: options.half_cells,
        half_slices: options.half_slices,
        width: options.grid_width,
        edges: options.tip_corner_contact,
    };
    let (friction, lubrication) = (options.friction, options.lubrication);
    let pair = |mesh: GearMesh, surfaces: [usize; 2], front| SurfacePair {
        bodies: ids,
        surfaces: surfaces.map(|surface| surface as u32),
        grid,
        friction,
        mesh: Some(mesh),
        front,
        lubrication,
    };
    let front = scene.add_pair(pair(mesh, surfaces, None));
    if let Some(back) = back {
        scene.add_pair(pair(back, coast_surfaces, Some(front)));
    }
    Ok(GeneralMesh { pair: front, backlash, warnings })
}

/// Returns the flanks that a first body driving in a sense presses together.
fn surfaces(sense: f64, sign: f64) -> [usize; 2] {
    let surface = if sense > 0.0 { 0 } else { 1 };
    [surface, if sign > 0.0 { surface } else { 1 - surface }]
}

impl Bodies {
    /// Returns whether the flanks would touch if the second body rotated the other way.
    fn touches_reversed(&self, sense: f64, sign: f64, phase: f64) -> bool {
        self.first_contact(surfaces(sense, -sign), phase).is_some_and(|one| one.contact.inside)
    }
}

/// Data of a mesh cycle.
struct Cycle<'a> {
    bodies: &'a Bodies,
    teeth: [u32; 2],
    /// Speeds of both bodies relative to their carrier, rad/s.
    speeds: [f64; 2],
    /// Angular velocity of the carrier, rad/s.
    carrier: [f64; 3],
    sign: f64,
    phases: [f64; 2],
    left: f64,
}

impl Cycle<'_> {
    /// Returns the mesh of these flanks, and its contact ratio if flanks touch away from edges.
    fn mesh(&self, surfaces: [usize; 2], sense: f64, touching: &ToothContact) -> (GearMesh, Option<f64>) {
        let Cycle { bodies, teeth, speeds, carrier, sign, phases, left } = *self;
        let [pitch, second_pitch] = bodies.pitches;
        let path = bodies.path(surfaces, phases[0], sense, touching).ends;
        let [begin, end] = path.unwrap_or([-0.5 * pitch, 0.5 * pitch]);
        let rate = sense * speeds[0];
        let forward = rate > 0.0;
        let enters = if forward { begin } else { end };
        let period = pitch / speeds[0].abs();
        let start = (enters / rate).rem_euclid(period);
        // Pitches by which the entering tooth is ahead of the one that touches at time 0.
        let ahead = (sense * (enters - rate * start) / pitch).round();
        let mate = ((touching.contact.rotation - phases[1]) / second_pitch).round();
        let index = |tooth: f64, teeth: u32| tooth.rem_euclid(f64::from(teeth)) as u32;
        let roll = enters - begin;
        let length = end - begin;
        let second = &bodies.poses[1];
        let arm_about_first = {
            // The contact in ground coordinates.
            let point = second.point(touching.contact.point);
            let own = seen_from(&Pose { origin: point, ..*second }, &bodies.poses[0]);
            arm_about_z(own.origin, own.direction(touching.contact.normal))
        };
        let arm_about_second = arm_about_z(touching.contact.point, touching.contact.normal);
        let mesh = GearMesh {
            teeth,
            base_radii: [arm_about_first.abs(), arm_about_second.abs()],
            drive_sense: sense,
            sign,
            entering: [
                index(f64::from(touching.tooth) + ahead, teeth[0]),
                index(mate - sign * ahead, teeth[1]),
            ],
            start,
            period,
            characteristic: Vec::new(),
            roll: [roll, if forward { roll + pitch } else { roll - pitch }],
            path: [0.0, length],
            overlap_ratio: 0.0,
            twist: 0.0,
            roll_at_zero: 0.0,
            carrier,
            phase_offset: left,
            first_contact: Some(FirstContact {
                point: second.point(touching.contact.point),
                normal: second.direction(touching.contact.normal),
            }),
        };
        (mesh, path.map(|_| length / pitch))
    }
}
