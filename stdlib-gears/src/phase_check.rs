//! Phase check of gears in loops, such as sun, planet and ring: selects the gear that can still be
//! rotated into mesh, and checks the assembly condition if neither can.
//!
//! The first mesh of a gear determines its phase. A mesh of two gears that both have meshes closes
//! a loop, and the assembly condition decides whether teeth meet tooth spaces there. For planets on
//! one carrier that mesh with two coaxial gears, the angle between planets must be a multiple of
//! `2 pi / Z`, where `Z` is the sum of the teeth of sun and ring. Small deviations have physical
//! causes, such as a misplaced pin or thin teeth, and are left to the contact problem.

use crate::assembly::gear_of;
use crate::error::{GeometryError, sentence};
use crate::gear::ToothForm;
use crate::mesh_geometry::MeshGeometry;
use calyx_runtime::error::EngineError;
use calyx_runtime::motion::{Orientation, axle, spatial_pose};
use calyx_runtime::scene::{BodyId, Scene};
use calyx_runtime::vec3::{dot, minus};
use std::f64::consts::TAU;

/// Largest misplacement of teeth in a loop beyond the backlash, in modules. It is a hundred times
/// the usual position error of pins, and half of the misplacement that a wrong spacing of up to
/// nine planets causes.
const OUT_OF_PLACE: f64 = 0.1;
/// Misplacement in modules above which a warning is issued; pins and teeth are made more
/// accurately.
const TELLING: f64 = 0.05;
/// Largest distance of coaxial axes, relative to the distance to a planet.
const COAXIAL: f64 = 1e-2;

/// Index of the body that has no mesh yet and may be rotated: 1 for the second, 0 for the first;
/// `None` if both have one.
pub(crate) fn may_rotate(scene: &Scene, bodies: [BodyId; 2]) -> Option<usize> {
    [1, 0].into_iter().find(|&side: &usize| partners(scene, bodies[side]).next().is_none())
}

/// Judges a gear that would have to rotate by an angle (rad) for its teeth to touch those of its
/// mate. Returns nothing, a warning, or an error if the gears cannot be assembled.
///
/// # Errors
/// E0750.
pub(crate) fn judge(
    scene: &Scene,
    bodies: [BodyId; 2],
    second: &ToothForm,
    geometry: &MeshGeometry,
    phase_offset: f64,
) -> Result<Option<GeometryError>, GeometryError> {
    let off = phase_offset.abs() * geometry.base_radius[1] / geometry.operating_pressure_angle.cos();
    if off <= TELLING * second.module {
        return Ok(None);
    }
    let spacing = PlanetSpacing::of(scene, bodies);
    // The planet is to blame, whatever its position in the call.
    let argument = match &spacing {
        Some(spacing) if spacing.planet == bodies[1] => "second",
        _ => "first",
    };
    let impossible = off > geometry.backlash.max(0.0) + OUT_OF_PLACE * second.module;
    let message = if impossible {
        sentence![
            "these gears cannot be assembled: both are phased by earlier meshes, and here their teeth are ", length off,
            " away from the spaces of the mating gear, along the pitch circle"
        ]
    } else {
        sentence![
            "both gears are phased by earlier meshes, and here their teeth are ", length off,
            " away from contact, along the pitch circle: they carry more or less load than those of other planets"
        ]
    };
    let help = match spacing {
        Some(PlanetSpacing { feasible, given, teeth, .. }) if (feasible - given).abs() > 1e-9 => sentence![
            "planets are integer multiples of 360 deg / ", number teeth, " apart, the sum of teeth of both coaxial gears: place this one ",
            angle feasible, " from the one that is in mesh already, instead of ", angle given
        ],
        _ => {
            sentence![
                "check the numbers of teeth, the tooth thicknesses and the positions of the axes in the loop"
            ]
        }
    };
    match impossible {
        true => Err(GeometryError::error("E0750", argument, message, help)),
        false => Ok(Some(GeometryError::warning("E0752", argument, message, help))),
    }
}

/// Checks that a gear does not overlap the other gears in mesh with its mate.
///
/// # Errors
/// E0751: their tip circles overlap.
pub(crate) fn clears_neighbours(scene: &Scene, bodies: [BodyId; 2]) -> Result<(), GeometryError> {
    for (side, argument) in [(0, "first"), (1, "second")] {
        let (own, mate) = (bodies[side], bodies[1 - side]);
        for other in
            partners(scene, mate).filter(|other| !partners(scene, own).any(|partner| partner == *other))
        {
            let overlap = overlap(scene, [own, other]).unwrap_or(0.0);
            if overlap > 0.0 {
                return Err(GeometryError::error(
                    "E0751",
                    argument,
                    sentence![
                        "the tips of this gear run ", length overlap, " into those of another one that is in mesh with the same gear"
                    ],
                    sentence!["place the two farther apart, use fewer planets, or reduce `outer_diameter`"],
                ));
            }
        }
    }
    Ok(())
}

/// Overlap of the tip circles of two external gears whose faces overlap, m; negative if the circles
/// are apart.
fn overlap(scene: &Scene, bodies: [BodyId; 2]) -> Option<f64> {
    let [one, other] = bodies.map(|body| gear_of(scene, body));
    let gears = [one?, other?];
    let axes = directions(scene, bodies[0])?;
    let [first, second] = [axis(scene, bodies[0], axes)?, axis(scene, bodies[1], axes)?];
    let beside = (first[2] - second[2]).abs() >= 0.5 * (gears[0].face_width + gears[1].face_width);
    if beside || gears.iter().any(|gear| gear.form().internal) {
        return None;
    }
    let tips: f64 = gears.iter().map(|gear| gear.form().tip_radius).sum();
    Some(tips - (first[0] - second[0]).hypot(first[1] - second[1]))
}

/// Angular position of a planet relative to another planet in mesh with the same two coaxial gears,
/// and the nearest feasible one.
struct PlanetSpacing {
    planet: BodyId,
    /// Given angle, rad.
    given: f64,
    /// Nearest angle at which teeth meet spaces, rad.
    feasible: f64,
    /// Numbers of teeth of both coaxial gears, signed by the sense in which they rotate planets.
    teeth: f64,
}

impl PlanetSpacing {
    /// Spacing of the planet among two bodies that close a loop; `None` for other kinds of loop.
    fn of(scene: &Scene, bodies: [BodyId; 2]) -> Option<PlanetSpacing> {
        let [first, second] = bodies;
        [(first, second), (second, first)].into_iter().find_map(|(planet, centre)| {
            let axes = directions(scene, centre)?;
            let middle = axis(scene, centre, axes)?;
            let away = |body: BodyId| {
                let at = axis(scene, body, axes)?;
                Some([at[0] - middle[0], at[1] - middle[1]])
            };
            let size = |[x, y]: [f64; 2]| x.hypot(y);
            let own = away(planet)?;
            let coaxial = |body: &BodyId| away(*body).is_some_and(|away| size(away) < COAXIAL * size(own));
            let other = partners(scene, planet).find(|partner| *partner != centre && coaxial(partner))?;
            let earlier = partners(scene, centre)
                .find(|body| *body != planet && partners(scene, other).any(|partner| partner == *body))?;
            let turns = |body: BodyId| {
                let form = gear_of(scene, body)?.form();
                Some(form.sense() * f64::from(form.teeth))
            };
            let teeth = (turns(centre)? - turns(other)?).abs();
            let reference = away(earlier)?;
            let given = (reference[0] * own[1] - reference[1] * own[0])
                .atan2(reference[0] * own[0] + reference[1] * own[1])
                .rem_euclid(TAU);
            let feasible = (given * teeth / TAU).round() * TAU / teeth;
            (teeth > 0.0).then_some(PlanetSpacing { planet, given, feasible, teeth })
        })
    }
}

/// Bodies in mesh with a body, in the order of their meshes.
pub(crate) fn partners(scene: &Scene, body: BodyId) -> impl Iterator<Item = BodyId> {
    let meshes = scene.pairs.iter().filter(|pair| pair.mesh.is_some() && pair.front.is_none());
    meshes.filter_map(move |pair| match pair.bodies {
        [first, second] if first == body => Some(second),
        [first, second] if second == body => Some(first),
        _ => None,
    })
}

/// Directions of a body's DOFs at time 0: its axis and two directions in its transverse plane.
fn directions(scene: &Scene, body: BodyId) -> Option<[[f64; 3]; 3]> {
    let motion = scene.bodies.get(body.0)?.motion.as_ref();
    Some(Orientation::of(&spatial_pose(motion, 0.0).ok()?).axes)
}

/// Position of a body's axis at time 0 along three directions, m.
fn axis(scene: &Scene, body: BodyId, directions: [[f64; 3]; 3]) -> Option<[f64; 3]> {
    let motion = scene.bodies.get(body.0)?.motion.as_ref();
    let at = spatial_pose(motion, 0.0).ok()?.point(axle(motion));
    Some(directions.map(|direction| dot(direction, at)))
}

/// Angular velocity of the line between two parallel axes at time 0 about the first axis, rad/s.
///
/// # Errors
/// E0658: the axes approach each other or separate. E0710: a frame is NaN or infinite.
pub(crate) fn orbit(scene: &Scene, bodies: [BodyId; 2], speeds: [f64; 2]) -> Result<f64, EngineError> {
    let at = |body: BodyId| {
        let motion = scene.bodies[body.0].motion.as_ref();
        let place = spatial_pose(motion, 0.0)?.point(axle(motion));
        Ok::<_, EngineError>((place, calyx_runtime::motion::point_velocity(motion, 0.0, place)))
    };
    let ((from, velocity), (to, other)) = (at(bodies[0])?, at(bodies[1])?);
    let pose = spatial_pose(scene.bodies[bodies[0].0].motion.as_ref(), 0.0)?;
    let [x, y, _] = Orientation::of(&pose).axes;
    let in_plane = |v: [f64; 3]| [dot(x, v), dot(y, v)];
    let (across, moving) = (in_plane(minus(to, from)), in_plane(minus(other, velocity)));
    let square = across[0].powi(2) + across[1].powi(2);
    let fastest = speeds.iter().fold(0.0, |most: f64, speed| most.max(speed.abs()));
    let turning = (across[0] * moving[1] - across[1] * moving[0]) / square;
    let parting = (across[0] * moving[0] + across[1] * moving[1]) / square;
    if parting.abs() > STEADY * fastest.max(turning.abs()) {
        return Err(EngineError::new(
            "E0658",
            format!(
                "the centre distance of the two gears is not constant: it changes by {:.3e} of its value per second",
                parting.abs()
            ),
            "let planets move on a circle about the axis of their mate, like `Rotate(own * Time, e3) * Translate(distance * e1) * Rotate(carrier * Time, e3)`",
        )
        .blame("second"));
    }
    // Rounding errors of fixed axes count as zero.
    Ok(if turning.abs() > 1e-3 * STEADY * fastest { turning } else { 0.0 })
}

/// Relative tolerance of speeds.
const STEADY: f64 = 1e-9;
