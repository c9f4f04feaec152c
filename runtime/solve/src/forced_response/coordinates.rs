//! Vibration of all coordinates, and the forces of the modal damping on them.

use super::basis::Basis;
use super::{Coefficients, ForcedVibration, PeriodicSystem, Series, matrix_coefficient, one_sided};
use faer::{Mat, c64};
use nalgebra::{Complex, DMatrix, DVector};

/// Vibration of all coordinates at a speed: complex amplitudes by line, like those of quantities
/// ([`super::Amplitudes`]).
#[derive(Clone, Debug, PartialEq)]
pub struct Motion {
    /// Displacements by line, in the units of the coordinates.
    pub displacements: Vec<DVector<Complex<f64>>>,
    /// Forces of the modal damping on the coordinates by line, against their velocities: their
    /// power is dissipated.
    pub damping_forces: Vec<DVector<Complex<f64>>>,
}

/// Transformation of modal coordinates into all coordinates.
pub(super) struct Coordinates {
    with_inertia: DMatrix<f64>,
    without_inertia: DMatrix<f64>,
    /// Momentum of the modes with inertia.
    momentum: DMatrix<f64>,
    /// Deflection of the modes without inertia for each of the others.
    followed: Series<DMatrix<Complex<f64>>>,
    /// Static equilibrium by order of the response.
    statics: Vec<DVector<Complex<f64>>>,
}

impl Coordinates {
    /// Prepares the coordinates of a system with the modes of its mean stiffness, from the
    /// deflections of the modes without inertia by sample and the static equilibrium by order.
    pub fn new(
        system: &PeriodicSystem,
        basis: &Basis,
        followed: &[DMatrix<f64>],
        statics: &[DVector<Complex<f64>>],
    ) -> Coordinates {
        let with_inertia = basis.with_inertia();
        let coupling = system.orders.coupling();
        let coefficient = |&order: &i64| (order, matrix_coefficient(followed, &system.sampling, order));
        let without_inertia = basis.without_inertia();
        let followed = match without_inertia.ncols() {
            0 => Series::new(),
            _ => coupling.iter().map(coefficient).collect(),
        };
        Coordinates {
            momentum: &system.mass * &with_inertia,
            with_inertia,
            without_inertia,
            followed,
            statics: statics.to_vec(),
        }
    }
}

/// Returns the product of a real matrix and a complex vector.
fn product(matrix: &DMatrix<f64>, vector: &DVector<Complex<f64>>) -> DVector<Complex<f64>> {
    let (real, imaginary) = (matrix * vector.map(|value| value.re), matrix * vector.map(|value| value.im));
    real.zip_map(&imaginary, Complex::new)
}

/// Returns the sum of the products of a series and vectors by order of the response that have an
/// order.
fn convolved(
    series: &Coefficients,
    vectors: &[DVector<Complex<f64>>],
    response: &[i64],
    order: i64,
) -> Option<DVector<Complex<f64>>> {
    let terms = response.iter().zip(vectors).filter_map(|(&of_block, vector)| {
        let coefficient = series.get(&(order - of_block).abs())?;
        Some(if order < of_block { coefficient.conjugate() * vector } else { coefficient * vector })
    });
    terms.reduce(|sum, term| sum + term)
}

impl ForcedVibration {
    /// Returns the vibration of all coordinates from the deviation by order of the response; that
    /// of the static equilibrium alone without a deviation. `None` if the coordinates are not
    /// prepared.
    pub(super) fn motion(&self, speed: f64, deviation: Option<&Mat<c64>>) -> Option<Motion> {
        let own = self.coordinates.as_ref()?;
        let (response, modes) = (self.orders.response(), self.damping.nrows());
        let modal = |block: usize| {
            let at = |mode: usize| deviation.map_or(c64::new(0.0, 0.0), |found| found[(mode, block)]);
            DVector::from_fn(modes, |mode, _| Complex::new(at(mode).re, at(mode).im))
        };
        let deviations: Vec<DVector<Complex<f64>>> = (0..response.len()).map(modal).collect();
        let frequency = speed * self.frequency;
        let rate = |(block, own): (usize, &DVector<Complex<f64>>)| {
            (own + &self.statics[block]) * Complex::new(0.0, response[block] as f64 * frequency)
        };
        let rates: Vec<DVector<Complex<f64>>> = deviations.iter().enumerate().map(rate).collect();
        let (mut displacements, mut damping_forces) = (Vec::new(), Vec::new());
        for (order, _) in self.orders.lines() {
            let block = response.iter().position(|&other| other == order)?;
            let mut moved = &own.statics[block] + product(&own.with_inertia, &deviations[block]);
            if let Some(followed) = convolved(&own.followed, &deviations, response, order) {
                moved += product(&own.without_inertia, &followed);
            }
            let factor = Complex::from(one_sided(order));
            let damped = convolved(&self.modal_damping, &rates, response, order);
            let damped = damped.unwrap_or_else(|| DVector::zeros(modes));
            displacements.push(moved * factor);
            damping_forces.push(product(&own.momentum, &damped) * factor);
        }
        Some(Motion { displacements, damping_forces })
    }
}
