//! Surfaces in space: the true shapes that contact sees, independent of any mesh.
//!
//! Nothing assumes profile by lead: `u` and `v` are any regular coordinates. For teeth of gears `u` runs along the profile from the
//! root to the tip and `v` along the face.

/// A point of a surface with its tangents.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfacePoint {
    /// In the coordinates of whatever owns the surface, m.
    pub position: [f64; 3],
    /// Derivatives of the position by `u` and by `v`.
    pub tangents: [[f64; 3]; 2],
    /// Unit normal, out of the material.
    pub normal: [f64; 3],
}

/// A smooth piece of the boundary of a body, over a rectangle of coordinates.
///
/// It is continuous with a continuous normal, and may be evaluated a little beyond its rectangle, where it continues smoothly.
pub trait Surface: Send + Sync {
    /// Ends of `u` and of `v`, ascending.
    fn range(&self) -> [[f64; 2]; 2];

    /// The point at `u`, `v`.
    fn at(&self, u: f64, v: f64) -> SurfacePoint;

    /// Values of `u`, ascending and inside the range, at which curvature jumps: start of a relief, of the rounding of an edge.
    fn breaks(&self) -> &[f64] {
        &[]
    }

    /// From this `u` on, the surface belongs to a rounded edge: pressures there are edge pressures. `None` if it has none.
    fn edge_from(&self) -> Option<f64> {
        None
    }
}
