//! Rigid-body degrees of freedom of the frames of bodies.

/// Names of the six DOFs of a frame, in the order of [`Component`].
pub const DOF_NAMES: [&str; 6] = ["u_x", "u_y", "u_z", "theta_x", "theta_y", "theta_z"];

/// Component of the motion of a frame along or about the ground axes, in the order of
/// [`DOF_NAMES`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Component {
    /// Displacement along x.
    Ux,
    /// Displacement along y.
    Uy,
    /// Displacement along z, normal to a plane model.
    Uz,
    /// Rotation about x.
    ThetaX,
    /// Rotation about y.
    ThetaY,
    /// Rotation about z, the in-plane rotation of a plane model.
    ThetaZ,
}

/// DOF: a free component of a body's frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Dof {
    /// Index of the body in the scene.
    pub body: usize,
    /// Index in [`DOF_NAMES`].
    pub component: usize,
}
