//! Cells of contact patches in the coordinates of the flanks, for contact patterns of gears on
//! general axes.

use super::Contact;
use calyx_contact::solid::Pose;
use calyx_numerics::vec3::{dot, minus};
use calyx_solve::step::ContactGrid;
use calyx_solve::system::Bodies;
use calyx_structure::surface::Surface;
use std::f64::consts::TAU;

/// Corners of a cell on a flank, in order around the cell: fractions of the range of the surface
/// along the face (`v`) and along the profile (`u`), each from 0 to 1. Corners beyond the ends of
/// the flank are outside of that range.
pub type FlankCorners = [[f64; 2]; 4];

impl Contact<'_> {
    /// Returns the corners of a cell on both flanks, from its corners in ground coordinates (m);
    /// `None` for meshes on parallel axes, whose flanks have roll angles instead.
    ///
    /// The corners are in the tangent plane of the patch. Each is projected onto the tangent plane
    /// of the flank at the cell's centre.
    pub(super) fn flank_corners(&self, cell: usize, corners: &[[f64; 3]; 4]) -> Option<[FlankCorners; 2]> {
        let (mesh, _) = self.at.mesh(self.pair())?;
        mesh.first_contact?;
        let (Bodies::Solid(bodies), ContactGrid::Solid(grid)) = (&self.at.system.bodies, &self.patch.grid)
        else {
            return None;
        };
        let middle = grid.frame.at(grid.cells[cell].center);
        let on_side = |side: usize| {
            let body = self.bodies()[side];
            let surface = bodies.structures[body.0].as_ref()?.surface(self.patch.surfaces[side]);
            let pose = self.tooth_pose(side, mesh.teeth[side])?;
            let moved = corners.map(|corner| minus(corner, middle));
            Some(projected(surface.as_ref(), &pose, grid.cells[cell].places[side], moved))
        };
        Some([on_side(0)?, on_side(1)?])
    }

    /// Returns the pose of the tooth of a side; the pitch error is neglected.
    fn tooth_pose(&self, side: usize, teeth: u32) -> Option<Pose> {
        let body = self.bodies()[side].0;
        let frame = self.at.system.displaced_pose(body, self.at.time(), &self.at.step.start).ok()?;
        let pitch = TAU / f64::from(teeth);
        let phase = self.at.scene().bodies[body].phase;
        Some(frame.rotated_first(phase + f64::from(self.patch.teeth[side]) * pitch))
    }
}

/// Projects displacements from a point of a flank (ground coordinates, m) onto its tangents.
fn projected(surface: &dyn Surface, pose: &Pose, place: [f64; 2], moved: [[f64; 3]; 4]) -> FlankCorners {
    let [u_range, v_range] = surface.range();
    let tangents = surface.at(place[0], place[1]).tangents.map(|tangent| pose.direction(tangent));
    let [uu, uv, vv] = [[0, 0], [0, 1], [1, 1]].map(|[a, b]: [usize; 2]| dot(tangents[a], tangents[b]));
    let determinant = uu * vv - uv * uv;
    let fraction = |value: f64, [low, high]: [f64; 2]| (value - low) / (high - low);
    moved.map(|by| {
        let [along_u, along_v] = tangents.map(|tangent| dot(tangent, by));
        let u = place[0] + (vv * along_u - uv * along_v) / determinant;
        let v = place[1] + (uu * along_v - uv * along_u) / determinant;
        [fraction(v, v_range), fraction(u, u_range)]
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use calyx_structure::surface::SurfacePoint;

    /// Oblique coordinates on a plane.
    struct Oblique;

    impl Surface for Oblique {
        fn range(&self) -> [[f64; 2]; 2] {
            [[0.0, 2.0], [-1.0, 1.0]]
        }

        fn at(&self, u: f64, v: f64) -> SurfacePoint {
            let tangents = [[1.0, 0.0, 0.0], [0.5, 2.0, 0.0]];
            SurfacePoint { position: [u + 0.5 * v, 2.0 * v, 0.0], tangents, normal: [0.0, 0.0, 1.0] }
        }
    }

    #[test]
    fn displacements_on_a_plane_become_exact_coordinates() {
        let pose = Pose { origin: [3.0, 1.0, -2.0], ..Pose::IDENTITY }.rotated_first(0.7);
        let place = [0.4, 0.2];
        let point = |u: f64, v: f64| pose.point(Oblique.at(u, v).position);
        let wanted = [[0.1, 0.0], [1.9, -0.9], [0.4, 0.2], [1.0, 0.7]];
        // A part along the normal has no effect.
        let off = pose.direction([0.0, 0.0, 0.3]);
        let moved = wanted.map(|[u, v]: [f64; 2]| {
            let by = minus(point(u, v), point(place[0], place[1]));
            [0, 1, 2].map(|k: usize| by[k] + off[k])
        });
        for ([v, u], [wanted_u, wanted_v]) in projected(&Oblique, &pose, place, moved).into_iter().zip(wanted)
        {
            assert!((u - 0.5 * wanted_u).abs() < 1e-14, "{u}");
            assert!((v - 0.5 * (wanted_v + 1.0)).abs() < 1e-14, "{v}");
        }
    }
}
