//! Curvature of flanks across a contact line.

use super::placement::PlacedSurface;
use calyx_numerics::vec3::{Vector, dot, minus};

/// Step of the finite difference of normals, relative to the extent of a surface.
const DIFFERENCE: f64 = 1e-6;

/// Number of Gauss-Newton steps to the foot of a point, which starts within a slice of a grid.
const STEPS: usize = 4;

/// Returns the sum of the normal curvatures of two surfaces along a tangent direction (unit vector)
/// at a point of their contact line, 1/m: the relative curvature if the direction is across the
/// contact line. `guess` contains the coordinates of a nearby point by side. A point on a rounded
/// edge counts as the end of the flank next to it.
pub fn relative_curvature_along(
    placed: &[PlacedSurface<'_>; 2],
    guess: [[f64; 2]; 2],
    point: Vector,
    direction: Vector,
) -> f64 {
    let curvature = |side: usize| {
        let place = foot(&placed[side], guess[side], point);
        normal_curvature(&placed[side], place, direction)
    };
    curvature(0) + curvature(1)
}

/// Returns the coordinates of the foot of the perpendicular from a point on a surface.
fn foot(placed: &PlacedSurface<'_>, guess: [f64; 2], point: Vector) -> [f64; 2] {
    (0..STEPS).fold(guess, |[u, v], _| {
        let at = placed.at([u, v]);
        let [du, dv] = rates(at.tangents, minus(point, at.position));
        [u + du, v + dv]
    })
}

/// Returns the coordinates of a tangent vector with respect to the tangents by u and by v.
fn rates([by_u, by_v]: [Vector; 2], vector: Vector) -> [f64; 2] {
    let [uu, uv, vv] = [dot(by_u, by_u), dot(by_u, by_v), dot(by_v, by_v)];
    let [along_u, along_v] = [dot(by_u, vector), dot(by_v, vector)];
    let determinant = uu * vv - uv * uv;
    [(along_u * vv - along_v * uv) / determinant, (along_v * uu - along_u * uv) / determinant]
}

/// Returns the normal curvature of a flank in a tangent direction (unit vector), 1/m, positive
/// where convex.
fn normal_curvature(placed: &PlacedSurface<'_>, [u, v]: [f64; 2], direction: Vector) -> f64 {
    let extent = placed.surface.range().map(|[first, last]| last - first);
    let u = placed.surface.edge_from().map_or(u, |start| u.min(start - DIFFERENCE * extent[0]));
    let [du, dv] = rates(placed.at([u, v]).tangents, direction);
    let step = DIFFERENCE * (extent[0] / du.abs()).min(extent[1] / dv.abs());
    let [behind, ahead] = [-step, step].map(|step| placed.at([u + step * du, v + step * dv]).normal);
    dot(minus(ahead, behind), direction) / (2.0 * step)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solid::Pose;
    use crate::solid::test_surfaces::{Cap, Helicoid};

    /// Euler's theorem at the apex of a paraboloid.
    #[test]
    fn curvatures_are_those_of_eulers_theorem() {
        let cap = Cap { radii: [0.02, 0.5], faces: 1.0, half: [0.005; 2], turn: 0.3 };
        let placed = PlacedSurface { surface: &cap, pose: Pose::IDENTITY.rotated_first(0.4) };
        for angle in [0.0f64, 0.5, 1.5] {
            // The direction of the smaller radius is rotated by both angles.
            let from_principal = angle - (0.4 + 0.3);
            let expected = from_principal.cos().powi(2) / 0.02 + from_principal.sin().powi(2) / 0.5;
            let found = normal_curvature(&placed, [0.0; 2], [angle.cos(), angle.sin(), 0.0]);
            assert!((found / expected - 1.0).abs() < 1e-6, "{angle}: {found} {expected}");
        }
    }

    /// Across the generator of an involute helicoid, the radius of curvature is that of the
    /// transverse section over the cosine of the base helix angle.
    #[test]
    fn the_curvature_of_a_helicoid_is_that_of_iso_21771() {
        let helicoid = Helicoid {
            base_radius: 0.03,
            twist: 8.0,
            u: [0.004, 0.014],
            v: [-0.01, 0.01],
            crown: 0.0,
            hand: 1.0,
        };
        let placed = PlacedSurface { surface: &helicoid, pose: Pose::IDENTITY };
        let at = [0.009, 0.002];
        let point = placed.at(at);
        // Transverse direction in the surface: the derivative along the profile.
        let [by_u, _] = point.tangents;
        let across = by_u.map(|part| part / dot(by_u, by_u).sqrt());
        let base_helix_angle = (0.03f64 * 8.0).atan();
        let expected = base_helix_angle.cos() / 0.009;
        let found = normal_curvature(&placed, at, across);
        assert!((found / expected - 1.0).abs() < 1e-6, "{found} {expected}");
        // The foot of a point above the surface.
        let above = [0, 1, 2].map(|k: usize| point.position[k] + 1e-6 * point.normal[k]);
        let foot = foot(&placed, [0.0085, 0.001], above);
        assert!((0..2).all(|k| (foot[k] - at[k]).abs() < 1e-9), "{foot:?}");
    }
}
