//! Search for the teeth of a surface pair that are near each other, and for their contact lines.

use super::{Site, Solid, has_local_normals};
use crate::step::contact_geometry::{Approach, Candidate, Search};
use crate::step::contact_layout::SEARCH_DEPTH;
use crate::step::surface_boxes::Shape;
use calyx_contact::solid::{ContactLine, PlacedSurface, Pose, find_contact_line_within};
use calyx_model::motion::Orientation;
use calyx_model::pairs::SurfacePair;
use calyx_numerics::error::EngineError;
use calyx_structure::solid::SolidStructure;
use calyx_structure::surface::Surface;
use std::f64::consts::{PI, TAU};
use std::sync::Arc;

/// Surfaces of a pair in the position of its bodies.
pub(super) struct PlacedPair<'a> {
    index: usize,
    pair: &'a SurfacePair,
    bodies: [usize; 2],
    structures: [&'a dyn SolidStructure; 2],
    surfaces: [Arc<dyn Surface>; 2],
    shapes: [Shape; 2],
    /// Poses of the bodies' frames.
    frames: [Pose; 2],
    /// Axis positions of the bodies.
    origins: [[f64; 3]; 2],
    /// Directions of the DOFs of either body.
    axes: [[[f64; 3]; 3]; 2],
}

/// Tooth with its pose.
pub(super) type ToothAt = (u32, Pose);

impl Solid<'_> {
    /// Places a surface pair; `None` if a body has no three-dimensional structure.
    pub(super) fn placed_pair(
        &self,
        index: usize,
        time: f64,
        moved: &[f64],
    ) -> Result<Option<PlacedPair<'_>>, EngineError> {
        let pair = &self.system.scene.pairs[index];
        let bodies = pair.bodies.map(|body| body.0);
        let frames = [
            self.system.displaced_pose(bodies[0], time, moved)?,
            self.system.displaced_pose(bodies[1], time, moved)?,
        ];
        let [Some(first), Some(second)] = bodies.map(|body| self.bodies.structures[body].as_deref()) else {
            return Ok(None);
        };
        let structures: [&dyn SolidStructure; 2] = [first, second];
        let surfaces = [0, 1].map(|side: usize| structures[side].surface(pair.surfaces[side]));
        let shapes = [0, 1].map(|side: usize| Shape::of(surfaces[side].as_ref()));
        let origins = [0, 1].map(|side: usize| frames[side].point(self.system.axle(bodies[side])));
        // Springs and loads refer to the axes of the prescribed orientation, regardless of where
        // the contact grid is created.
        let axes = bodies.map(|body| self.system.axes(body, time));
        Ok(Some(PlacedPair { index, pair, bodies, structures, surfaces, shapes, frames, origins, axes }))
    }

    /// Returns the teeth that may be near each other, in a fixed order.
    pub(super) fn near_teeth(&self, placed: &PlacedPair<'_>, time: f64) -> Vec<[ToothAt; 2]> {
        let PlacedPair { index, pair, bodies, structures, surfaces, shapes, frames, .. } = placed;
        let scene = self.system.scene;
        let teeth = [0, 1].map(|side: usize| {
            let phase = scene.bodies[bodies[side]].phase;
            let place = |tooth| {
                let error = self.system.pitch_error(bodies[side], tooth);
                let pose = frames[side].rotated_first(phase + structures[side].tooth_angle(tooth) + error);
                (tooth, pose, shapes[side].boxes(&pose))
            };
            (0..structures[side].teeth()).map(place).collect::<Vec<_>>()
        });
        let nominal = pair.mesh.as_ref().filter(|_| !pair.grid.edges && !has_local_normals(pair));
        let angle = Orientation::of(&frames[0]).angle + scene.bodies[bodies[0]].phase
            - self.system.rotated_line_of_centres(*index, time);
        let turns = turns_along(surfaces[0].as_ref());
        let on_path = |tooth: u32| {
            nominal.is_none_or(|mesh| turns.iter().any(|turn| mesh.on_path(tooth, angle + turn)))
        };
        let mut near = Vec::new();
        for (first, first_pose, first_boxes) in teeth[0].iter().filter(|(tooth, ..)| on_path(*tooth)) {
            for (second, second_pose, second_boxes) in &teeth[1] {
                if first_boxes.iter().any(|one| second_boxes.iter().any(|other| one.meets(other))) {
                    near.push([(*first, *first_pose), (*second, *second_pose)]);
                }
            }
        }
        near
    }

    /// Finds the contact line of two teeth; `None` if they do not face each other.
    pub(super) fn candidate(
        &self,
        placed_pair: &PlacedPair<'_>,
        [(first, first_pose), (second, second_pose)]: [ToothAt; 2],
        search: Search,
    ) -> Option<Candidate<Site>> {
        let PlacedPair { index, pair, bodies, structures, surfaces, shapes, origins, axes, .. } = placed_pair;
        let (poses, local_normals) = ([first_pose, second_pose], has_local_normals(pair));
        let placed = |side: usize| PlacedSurface { surface: surfaces[side].as_ref(), pose: poses[side] };
        let far = match search {
            Search::Near => SEARCH_DEPTH * shapes[0].across,
            Search::All => f64::INFINITY,
        };
        let contact_line = find_contact_line_within(placed(0), placed(1), pair.grid.edges, far)
            .filter(|contact_line| faces(contact_line, &poses, *structures))?;
        let frame = &contact_line.frame;
        let at = |gap, action, point| Approach {
            gap,
            arms: self.arms_at(*bodies, (*origins, *axes), action, point),
        };
        let action = |slope| if local_normals { frame.action(slope) } else { frame.normal };
        Some(Candidate {
            teeth: (*index, [first, second]),
            length: shapes[0].across,
            nearest: at(contact_line.gap, frame.normal, frame.point),
            others: contact_line.points.iter().map(|p| at(p.gap, action(p.slope), frame.at(p.at))).collect(),
            site: Site { surfaces: surfaces.clone(), poses, origins: *origins, axes: *axes, contact_line },
        })
    }
}

/// Returns whether surfaces with this approach face each other. If they overlap by half a pitch of
/// either body, one has passed the other and belongs to its neighbour.
fn faces(contact_line: &ContactLine, poses: &[Pose; 2], structures: [&dyn SolidStructure; 2]) -> bool {
    let half_pitch = |side: usize| {
        let (from, to) = (poses[side].origin, contact_line.frame.point);
        let distance = (0..3).map(|k| (to[k] - from[k]).powi(2)).sum::<f64>().sqrt();
        PI / f64::from(structures[side].teeth()) * distance
    };
    contact_line.gap > -half_pitch(0).min(half_pitch(1))
}

/// Number of transverse sections in which a tooth is tested against the nominal path of contact.
const SECTIONS: usize = 9;

/// Returns the angles of sections of a surface about the z axis relative to mid-face, rad: some
/// sections of a helical tooth may be on the path of contact while others are not.
fn turns_along(surface: &dyn Surface) -> [f64; SECTIONS] {
    let [[u0, u1], [v0, v1]] = surface.range();
    let angle = |part: f64| {
        let [x, y, _] = surface.at(0.5 * (u0 + u1), (1.0 - part) * v0 + part * v1).position;
        y.atan2(x)
    };
    // Measure from end to end: crowning rotates both ends alike and is not a helix.
    let turn = angle(1.0) - angle(0.0);
    let turn = turn - TAU * (turn / TAU).round();
    std::array::from_fn(|k| turn * (k as f64 / (SECTIONS - 1) as f64 - 0.5))
}
