//! Plane surface profiles: the true curves that contact sees, independent of any mesh.

/// A point of a profile with its differential geometry.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ProfilePoint {
    /// In the coordinates of whatever owns the profile (a tooth, a disc), metres.
    pub position: [f64; 2],
    /// Unit tangent, towards growing arc length.
    pub tangent: [f64; 2],
    /// Unit normal, out of the material.
    pub normal: [f64; 2],
    /// Positive where the material is convex, 1/m.
    pub curvature: f64,
}

/// A curve on the boundary of a body, by arc length `s` in `0 ..= length()` metres.
///
/// It is continuous with a continuous normal; its curvature may jump at [`Profile::breaks`].
/// It may be evaluated a little beyond its ends, where it continues smoothly.
pub trait Profile: Send + Sync {
    /// m
    fn length(&self) -> f64;

    /// The point at an arc length, m.
    fn at(&self, s: f64) -> ProfilePoint;

    /// Arc lengths, ascending and inside the curve, at which its curvature jumps
    /// (start of a relief, start of the rounding of an edge).
    fn breaks(&self) -> &[f64] {
        &[]
    }

    /// From this arc length on, the profile belongs to a rounded edge: pressures there are edge pressures.
    /// `None` if it has no edge.
    fn edge_from(&self) -> Option<f64> {
        None
    }
}
