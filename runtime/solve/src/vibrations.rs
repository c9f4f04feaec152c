//! Free vibrations about an equilibrium: natural frequencies and mode shapes.

use nalgebra::DMatrix;

/// Free vibrations: coordinates by modes. Coordinates are the DOFs, then the modal coordinates,
/// body by body.
#[derive(Clone, Debug, PartialEq)]
pub struct Vibrations {
    /// Natural frequencies, rad/s, ascending; those of rigid-body motions are 0 within rounding.
    pub frequencies: Vec<f64>,
    /// Mass-normalized mode shapes, one per column: m and rad by DOF, m kg^1/2 per root of a metre
    /// by modal coordinate, per square root of kg.
    pub shapes: DMatrix<f64>,
    /// Mass matrix: kg, kg m and kg m² for DOFs.
    pub mass: DMatrix<f64>,
    /// Stiffness matrix: N/m, N and N m for DOFs.
    pub stiffness: DMatrix<f64>,
}

impl Vibrations {
    /// Returns the fraction of a mode's kinetic energy in each coordinate; they add up to 1.
    pub fn energies(&self, mode: usize) -> Vec<f64> {
        let shape = self.shapes.column(mode);
        let momentum = &self.mass * shape;
        shape.iter().zip(momentum.iter()).map(|(moved, momentum)| moved * momentum).collect()
    }
}
