//! Three-dimensional surfaces: exact shapes for contact, independent of any mesh.
//!
//! `u` and `v` are any regular coordinates. On gear teeth `u` runs along the profile from the root
//! to the tip and `v` along the face.

/// Point of a surface with its tangents.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfacePoint {
    /// Position in the coordinates of the surface's owner, m.
    pub position: [f64; 3],
    /// Derivatives of the position by `u` and by `v`.
    pub tangents: [[f64; 3]; 2],
    /// Unit normal, out of the material.
    pub normal: [f64; 3],
}

/// Smooth part of the boundary of a body, over a rectangle of coordinates.
///
/// The surface has a continuous normal and may be evaluated slightly beyond its rectangle, where it
/// continues smoothly.
pub trait Surface: Send + Sync {
    /// Returns the ranges of `u` and of `v`, ascending.
    fn range(&self) -> [[f64; 2]; 2];

    /// Returns the point at `u`, `v`.
    fn at(&self, u: f64, v: f64) -> SurfacePoint;

    /// Returns whether the surface is a plane profile extruded along the owner's z axis, straight
    /// or with a constant rotation per length (flanks of spur and helical gears, apart from
    /// modifications): `u` is the arc length of the profile, `v` the axial coordinate, and side
    /// faces are normal to the axis. The compliance of such a surface takes a shorter computation.
    fn is_extruded(&self) -> bool {
        false
    }

    /// Returns the values of `u`, ascending and inside the range, at which the curvature jumps:
    /// start of a relief, or of a rounded edge.
    fn breaks(&self) -> &[f64] {
        &[]
    }

    /// Returns the `u` from which the surface belongs to a rounded edge: pressures there are edge
    /// pressures. `None` without an edge.
    fn edge_from(&self) -> Option<f64> {
        None
    }
}
