//! Rigid-body degrees of freedom of the frames of bodies.

/// The six freedoms of a frame, in the order of their indices: names of [`Component`].
pub const FREEDOMS: [&str; 6] = ["u_x", "u_y", "u_z", "theta_x", "theta_y", "theta_z"];

/// A component of a frame's motion along and about the ground axes, in the order of [`FREEDOMS`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Component {
    /// Displacement along x.
    Ux,
    /// Displacement along y.
    Uy,
    /// Displacement along z, across a plane model.
    Uz,
    /// Turn about x.
    ThetaX,
    /// Turn about y.
    ThetaY,
    /// Turn about z, in the plane of a plane model.
    ThetaZ,
}

/// A free component of a body's frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Freedom {
    /// Index of the body in the scene.
    pub body: usize,
    /// Index in [`FREEDOMS`].
    pub component: usize,
}
