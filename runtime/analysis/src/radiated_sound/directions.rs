//! Directions of the far field in the coordinate planes of ground, for directivities.

use calyx_numerics::vec3::{Vector, dot};
use std::f64::consts::TAU;

/// Number of directions in a plane: every 5 degrees.
const COUNT: usize = 72;
/// Cosine of the angle to the rigid plane behind which a direction is.
const BEHIND: f64 = -1e-9;

/// Coordinate plane of ground.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CoordinatePlane {
    /// From x to y.
    Xy,
    /// From y to z.
    Yz,
    /// From z to x.
    Zx,
}

impl CoordinatePlane {
    /// All planes.
    pub const ALL: [CoordinatePlane; 3] = [Self::Xy, Self::Yz, Self::Zx];

    /// Returns the name: the axis of the angle zero, and that of the right angle.
    pub fn name(self) -> &'static str {
        ["xy", "yz", "zx"][self as usize]
    }

    /// Returns the direction at an angle, rad.
    fn direction(self, angle: f64) -> Vector {
        let first = self as usize;
        let mut direction = [0.0; 3];
        direction[first] = angle.cos();
        direction[(first + 1) % 3] = angle.sin();
        direction
    }
}

/// Direction of the far field.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Direction {
    /// Plane.
    pub plane: CoordinatePlane,
    /// Angle from the first axis of the plane, rad.
    pub angle: f64,
    /// Unit vector in ground coordinates.
    pub vector: Vector,
}

/// Returns the directions into the fluid: all, or those in front of a rigid plane with this normal.
pub(super) fn directions(normal: Option<Vector>) -> Vec<Direction> {
    let of_plane = |plane: CoordinatePlane| {
        (0..COUNT).map(move |k| {
            let angle = TAU * k as f64 / COUNT as f64;
            Direction { plane, angle, vector: plane.direction(angle) }
        })
    };
    let all = CoordinatePlane::ALL.into_iter().flat_map(of_plane);
    all.filter(|at| normal.is_none_or(|normal| dot(at.vector, normal) >= BEHIND)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn directions_turn_from_the_first_axis_to_the_second() {
        let all = directions(None);
        assert_eq!(all.len(), 3 * COUNT);
        for plane in CoordinatePlane::ALL {
            let own: Vec<&Direction> = all.iter().filter(|at| at.plane == plane).collect();
            let axis = |name: char| ['x', 'y', 'z'].iter().position(|own| *own == name).expect("an axis");
            for (index, name) in [0, COUNT / 4].into_iter().zip(plane.name().chars()) {
                assert!((own[index].vector[axis(name)] - 1.0).abs() < 1e-15, "{name}");
            }
        }
        let half = directions(Some([0.0, 1.0, 0.0]));
        assert!(half.iter().all(|at| at.vector[1] > -1e-9));
        // All of zx, and half of the others with both ends.
        assert_eq!(half.len(), COUNT + 2 * (COUNT / 2 + 1));
    }
}
