//! Plane surface profiles: exact curves for contact, independent of any mesh.

/// Point of a profile with its differential geometry.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ProfilePoint {
    /// Position in the coordinates of the profile's owner (a tooth, a disc), m.
    pub position: [f64; 2],
    /// Unit tangent, towards increasing arc length.
    pub tangent: [f64; 2],
    /// Unit normal, out of the material.
    pub normal: [f64; 2],
    /// Curvature, positive where the material is convex, 1/m.
    pub curvature: f64,
}

/// Curve on the boundary of a body, by arc length `s` in `0 ..= length()` metres.
///
/// The curve has a continuous normal; its curvature may jump at [`Profile::breaks`]. It may be
/// evaluated slightly beyond its ends, where it continues smoothly.
pub trait Profile: Send + Sync {
    /// Returns the length, m.
    fn length(&self) -> f64;

    /// Returns the point at an arc length, m.
    fn at(&self, s: f64) -> ProfilePoint;

    /// Returns the arc lengths, ascending and inside the curve, at which the curvature jumps (start
    /// of a relief, start of a rounded edge).
    fn breaks(&self) -> &[f64] {
        &[]
    }

    /// Returns the arc length from which the profile belongs to a rounded edge: pressures there are
    /// edge pressures. `None` without an edge.
    fn edge_from(&self) -> Option<f64> {
        None
    }
}
