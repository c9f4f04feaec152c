//! Free vibrations about an equilibrium: natural frequencies and mode shapes.

use nalgebra::DMatrix;

/// Free vibrations: coordinates by modes. Coordinates are the freedoms, then the modal coordinates of the bodies, body after body.
#[derive(Clone, Debug, PartialEq)]
pub struct Vibrations {
    /// Natural frequencies, rad/s, ascending; those of free rigid motions are 0 but for rounding.
    pub frequencies: Vec<f64>,
    /// A column a mode, of unit modal mass: m and rad by freedom, m kg^1/2 per root of a metre by modal coordinate, per square root of kg.
    pub shapes: DMatrix<f64>,
    /// Between coordinates: kg, kg m and kg m² of freedoms.
    pub mass: DMatrix<f64>,
    /// Between coordinates: N/m, N and N m of freedoms.
    pub stiffness: DMatrix<f64>,
}

impl Vibrations {
    /// What each coordinate has of a mode's kinetic energy, the whole being 1.
    pub fn energies(&self, mode: usize) -> Vec<f64> {
        let shape = self.shapes.column(mode);
        let momentum = &self.mass * shape;
        shape.iter().zip(momentum.iter()).map(|(moved, momentum)| moved * momentum).collect()
    }
}
