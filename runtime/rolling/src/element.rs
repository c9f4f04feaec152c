//! Response of one rolling element to a displacement of the inner ring in the plane of the element.

/// Displacement of the inner ring in the axial plane of an element: radial, m; axial, m; rotation
/// from axial to radial, rad. A point at radius R and axial position z moves by `radial + z tilt`
/// and `axial - R tilt`.
pub(crate) type Local = [f64; 3];

/// Force, moment and stiffness of one element.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Response {
    /// Load on the inner ring that balances the element, conjugate to [`Local`].
    pub force: [f64; 3],
    /// Derivatives of the force with respect to the displacement.
    pub stiffness: [[f64; 3]; 3],
    /// The equilibrium of the element is not converged.
    pub unconverged: bool,
}
