//! Forced vibration of a system with periodic coefficients, by harmonic balance.
//!
//! The static equilibrium x_s(t) and the tangent stiffness K(t) repeat after a period. Small
//! vibrations about the equilibrium obey
//!
//! ```text
//! M x'' + (C + G) x' + K(t) (x - x_s(t)) = 0 .
//! ```
//!
//! In the mass-normalized modes X of the mean stiffness, with `x - x_s = X eta` and `s = X' M x_s`,
//!
//! ```text
//! eta'' + (D + X' C X + H) eta' + kappa(t) eta = -s'' - (D + X' C X + H) s' .
//! ```
//!
//! C contains the dampers of bearings, and modal damping `D = 2 zeta omega` is added to `X' C X`.
//! `H = X' G X` and `kappa = X' K X`. A Fourier series turns it into
//! one complex linear system for all orders: the Toeplitz blocks of kappa couple them. The series
//! has the orders of all mesh frequencies and their sidebands ([`orders`]). Modes far above all
//! orders have no inertia: they are condensed at each sample.
//!
//! See `docs/theory/forced-response.md`.

mod balance;
mod basis;
mod coordinates;
mod growth;
pub mod orders;
pub mod sampling;

use balance::{Coefficients, Couplings};
use basis::Basis;
use coordinates::Coordinates;
pub use coordinates::Motion;
use faer::{Mat, c64};
use nalgebra::{Complex, DMatrix, DVector};
use orders::Orders;
use sampling::Sampling;
use std::collections::BTreeMap;

/// Frequency relative to the highest one below which a mode is a rigid-body motion.
const RIGID: f64 = 1e-7;

/// Complex amplitudes `c` of the orders from 0, ascending ([`Orders::lines`]): the value at the
/// fraction `p` of the common period is the real part of `sum c exp(2 pi i order p)`.
pub type Amplitudes = Vec<Complex<f64>>;

/// System with periodic coefficients, sampled over its period.
#[derive(Clone, Debug)]
pub struct PeriodicSystem {
    /// Mass matrix of all coordinates.
    pub mass: DMatrix<f64>,
    /// Gyroscopic matrix at the reference speed, skew-symmetric.
    pub gyroscopic: DMatrix<f64>,
    /// Damping matrix of bearings.
    pub damping: DMatrix<f64>,
    /// Tangent stiffness matrix by sample.
    pub stiffness: Vec<DMatrix<f64>>,
    /// Static equilibrium by sample.
    pub statics: Vec<DVector<f64>>,
    /// Orders of the stiffness and of the response.
    pub orders: Orders,
    /// Places of the samples.
    pub sampling: Sampling,
    /// Frequency of the period at the reference speed, rad/s.
    pub frequency: f64,
    /// Damping ratio of all modes of the mean stiffness; if carriers rotate, of all modes at each
    /// position.
    pub damping_ratio: f64,
}

/// A quantity that is linear in the deviation from the static equilibrium: `value = statics + row *
/// (x - x_s) + rate * x'` by sample.
#[derive(Clone, Debug)]
pub struct LinearQuantity {
    /// Value in static equilibrium by sample.
    pub statics: Vec<f64>,
    /// Derivatives by all coordinates by sample; one row if they are constant.
    pub rows: Vec<DVector<f64>>,
    /// Derivatives by the rates of all coordinates by sample; one row if they are constant, none if
    /// the value does not depend on the rates.
    pub rates: Vec<DVector<f64>>,
}

/// A periodic system in modal coordinates, prepared for many speeds.
pub struct ForcedVibration {
    orders: Orders,
    frequency: f64,
    /// Frequencies of the modes with inertia, rad/s.
    frequencies: Vec<f64>,
    /// One for modes without stiffness: no spring determines their mean position.
    rigid: Vec<f64>,
    /// Damping by bearings.
    damping: DMatrix<f64>,
    gyroscopic: DMatrix<f64>,
    /// Fourier coefficients of the damping by the damping ratio.
    modal_damping: Coefficients,
    /// Fourier coefficients of the stiffness.
    stiffness: Coefficients,
    couplings: Couplings,
    /// Fourier coefficients of the static equilibrium by order of the response.
    statics: Vec<DVector<Complex<f64>>>,
    /// Fourier coefficients of the products of static equilibrium and damping or gyroscopic matrix.
    static_rates: [Vec<DVector<Complex<f64>>>; 2],
    /// Modes that the varying stiffness can make unstable, by index.
    unstable: Vec<usize>,
    quantities: Vec<ModalQuantity>,
    /// Amplitudes of the static values by quantity.
    static_values: Vec<Amplitudes>,
    /// All coordinates, if they are requested.
    coordinates: Option<Coordinates>,
}

/// Response at a speed.
#[derive(Clone, Debug, PartialEq)]
pub struct Response {
    /// Amplitudes by quantity.
    pub quantities: Vec<Amplitudes>,
    /// Vibration of all coordinates, if [`ForcedVibration::with_coordinates`] has prepared it.
    pub motion: Option<Motion>,
}

/// Fourier coefficients by order from zero; those of negative orders are conjugate.
type Series<T> = BTreeMap<i64, T>;

/// A quantity in modal coordinates.
struct ModalQuantity {
    /// Derivatives by the modes.
    rows: Series<DVector<Complex<f64>>>,
    /// Derivatives by the rates of the modes.
    rates: Series<DVector<Complex<f64>>>,
    /// Amplitudes of the product of the derivatives by all rates and the rate of the static
    /// equilibrium, at the unit frequency of the period.
    static_rates: Amplitudes,
}

/// Returns the Fourier coefficient of samples at an order.
fn number_coefficient(samples: &[f64], sampling: &Sampling, order: i64) -> Complex<f64> {
    sampling.weights(order).iter().zip(samples).map(|(weight, value)| weight * value).sum()
}

fn vector_coefficient(samples: &[DVector<f64>], sampling: &Sampling, order: i64) -> DVector<Complex<f64>> {
    let mut found = DVector::zeros(samples.first().map_or(0, |first| first.len()));
    for (weight, sample) in sampling.weights(order).into_iter().zip(samples) {
        found += sample.map(|value| weight * value);
    }
    found
}

fn matrix_coefficient(samples: &[DMatrix<f64>], sampling: &Sampling, order: i64) -> DMatrix<Complex<f64>> {
    let (rows, columns) = samples.first().map_or((0, 0), |first| first.shape());
    let mut found = DMatrix::zeros(rows, columns);
    for (weight, sample) in sampling.weights(order).into_iter().zip(samples) {
        found.zip_apply(sample, |sum: &mut Complex<f64>, value| *sum += weight * value);
    }
    found
}

/// Returns the coefficient of the static equilibrium at an order: zero for the interactions that
/// samples do not determine.
fn static_coefficient(
    samples: &[DVector<f64>],
    (sampling, orders): (&Sampling, &Orders),
    order: i64,
) -> DVector<Complex<f64>> {
    match orders.is_sampled(order) {
        true => vector_coefficient(samples, sampling, order),
        false => DVector::zeros(samples.first().map_or(0, |first| first.len())),
    }
}

/// Returns the series of rows by sample; that of one constant row is its mean.
fn row_series(
    rows: &[DVector<f64>],
    (sampling, orders): (&Sampling, &Orders),
) -> Series<DVector<Complex<f64>>> {
    match rows {
        [] => Series::new(),
        [constant] => Series::from([(0, constant.map(Complex::from))]),
        _ => orders
            .coupling()
            .iter()
            .map(|&order| (order, vector_coefficient(rows, sampling, order)))
            .collect(),
    }
}

/// Returns the amplitudes of real samples at the orders from zero.
fn amplitudes(samples: &[f64], (sampling, orders): (&Sampling, &Orders)) -> Amplitudes {
    let amplitude = |(order, _): (i64, orders::Line)| match orders.is_sampled(order) {
        true => one_sided(order) * number_coefficient(samples, sampling, order),
        false => Complex::new(0.0, 0.0),
    };
    orders.lines().map(amplitude).collect()
}

/// Returns the factor of an amplitude over the coefficient of a positive order: two, as the
/// negative order is included.
fn one_sided(order: i64) -> f64 {
    if order == 0 { 1.0 } else { 2.0 }
}

/// Returns the number of unknowns of a system up to a speed relative to the reference speed, with
/// or without the vibration of all coordinates; `None` if a matrix is invalid.
pub fn unknowns(system: &PeriodicSystem, highest: f64, coordinates: bool) -> Option<usize> {
    let highest = highest_frequency(system, highest);
    let basis = Basis::of(&system.mass, &system.stiffness, highest, multiple(coordinates))?;
    Some(basis.dynamic * system.orders.response().len())
}

impl ForcedVibration {
    /// Prepares the response up to a highest speed relative to the reference speed. `None` if a
    /// matrix is not finite or not positive definite.
    pub fn new(
        system: &PeriodicSystem,
        quantities: &[LinearQuantity],
        highest: f64,
    ) -> Option<ForcedVibration> {
        Self::prepared(system, quantities, highest, false)
    }

    /// Prepares the response like [`ForcedVibration::new`], with the vibration of all coordinates.
    pub fn with_coordinates(
        system: &PeriodicSystem,
        quantities: &[LinearQuantity],
        highest: f64,
    ) -> Option<ForcedVibration> {
        Self::prepared(system, quantities, highest, true)
    }

    fn prepared(
        system: &PeriodicSystem,
        quantities: &[LinearQuantity],
        highest: f64,
        coordinates: bool,
    ) -> Option<ForcedVibration> {
        let orders = system.orders.clone();
        let at = (&system.sampling, &orders);
        let highest = highest_frequency(system, highest);
        let all = Basis::of(&system.mass, &system.stiffness, highest, multiple(coordinates))?;
        let (basis, others) = (all.with_inertia(), all.without_inertia());
        let condensed: Vec<(DMatrix<f64>, DMatrix<f64>)> =
            system.stiffness.iter().map(|stiffness| all.condensed(stiffness)).collect::<Option<_>>()?;
        let (stiffness, followed): (Vec<_>, Vec<_>) = condensed.into_iter().unzip();
        let modal_damping = modal_damping(system, &stiffness, &all.frequencies[..all.dynamic])?;
        let stiffness: Coefficients = orders
            .coupling()
            .iter()
            .map(|&order| (order, matrix_coefficient(&stiffness, &system.sampling, order)))
            .collect();
        let statics: Vec<DVector<Complex<f64>>> =
            orders.response().iter().map(|&order| static_coefficient(&system.statics, at, order)).collect();
        let projected = |matrix: &DMatrix<f64>| -> Vec<DVector<Complex<f64>>> {
            let onto = (basis.transpose() * matrix).map(Complex::from);
            statics.iter().map(|at| &onto * at).collect()
        };
        let quantity = |quantity: &LinearQuantity| {
            let row = |(sample, followed): (usize, &DMatrix<f64>)| {
                let row = &quantity.rows[sample.min(quantity.rows.len() - 1)];
                basis.tr_mul(row) + followed.tr_mul(&others.tr_mul(row))
            };
            let constant = quantity.rows.len() == 1 && others.ncols() == 0;
            let used = if constant { 1 } else { followed.len() };
            let rows: Vec<DVector<f64>> = followed.iter().enumerate().take(used).map(row).collect();
            let modal: Vec<DVector<f64>> = quantity.rates.iter().map(|rate| basis.tr_mul(rate)).collect();
            ModalQuantity {
                rows: row_series(&rows, at),
                rates: row_series(&modal, at),
                static_rates: static_rates(&row_series(&quantity.rates, at), &statics, &orders),
            }
        };
        let frequencies = all.frequencies[..all.dynamic].to_vec();
        let largest = all.frequencies.last().copied().unwrap_or_default();
        let is_rigid = |frequency: &f64| f64::from(u8::from(*frequency <= RIGID * largest));
        Some(ForcedVibration {
            frequency: system.frequency,
            rigid: frequencies.iter().map(is_rigid).collect(),
            damping: basis.transpose() * &system.damping * &basis,
            gyroscopic: basis.transpose() * &system.gyroscopic * &basis,
            couplings: Couplings::new(&orders, &stiffness, &modal_damping),
            unstable: growth::unstable_modes(
                &frequencies,
                stiffness.iter().filter(|(order, _)| **order != 0).map(|(_, coefficient)| coefficient),
                system.damping_ratio,
            ),
            modal_damping,
            stiffness,
            static_rates: [projected(&system.damping), projected(&system.gyroscopic)],
            quantities: quantities.iter().map(quantity).collect(),
            static_values: quantities.iter().map(|of| amplitudes(&of.statics, at)).collect(),
            coordinates: coordinates.then(|| Coordinates::new(system, &all, &followed, &statics)),
            statics: projected(&system.mass),
            frequencies,
            orders,
        })
    }

    /// Returns the number of unknowns of a speed.
    pub fn unknowns(&self) -> usize {
        self.damping.nrows() * self.orders.response().len()
    }

    /// Returns the frequencies of the modes of the mean stiffness that have inertia, rad/s,
    /// ascending.
    pub fn natural_frequencies(&self) -> &[f64] {
        &self.frequencies
    }

    /// Returns true if carriers rotate.
    pub fn rotates(&self) -> bool {
        self.orders.rotates()
    }

    /// Returns the static values: the limit of slow rotation.
    pub fn static_values(&self) -> &[Amplitudes] {
        &self.static_values
    }

    /// Returns the amplitudes of all quantities at a speed relative to the reference speed. `None`
    /// if the response is not finite: an undamped resonance. At rest it is static.
    pub fn at(&self, speed: f64) -> Option<Vec<Amplitudes>> {
        self.response(speed).map(|response| response.quantities)
    }

    /// Returns the response at a speed like [`ForcedVibration::at`], with the vibration of all
    /// coordinates if it is prepared.
    pub fn response(&self, speed: f64) -> Option<Response> {
        if speed == 0.0 {
            return Some(Response {
                quantities: self.static_values.clone(),
                motion: self.motion(speed, None),
            });
        }
        let deviation = self.deviation(speed)?;
        let value = |quantity: usize| self.value(quantity, speed, &deviation);
        Some(Response {
            quantities: (0..self.quantities.len()).map(value).collect(),
            motion: self.motion(speed, Some(&deviation)),
        })
    }

    /// Returns the largest factor by which a disturbance grows within a cycle of a mesh at a speed
    /// (Floquet), as the stiffness varies with this mesh only. Above 1 the varying stiffness makes
    /// the vibration unstable, and it never becomes that of [`ForcedVibration::at`]. NaN if the
    /// matrix of a cycle is not finite, and if carriers rotate, as the stiffness does not repeat
    /// after a mesh cycle then.
    pub fn growth(&self, speed: f64) -> f64 {
        if self.orders.rotates() {
            return f64::NAN;
        }
        let modal = self.modal_damping[&0].map(|value| value.re);
        let rates = self.of_unstable(&(&self.damping + modal + speed * &self.gyroscopic));
        let frequencies: Vec<f64> = self.unstable.iter().map(|&mode| self.frequencies[mode]).collect();
        let of_mesh = |&cycles: &i64| {
            let harmonics = 0..=2 * self.orders.harmonics() as i64;
            let stiffness: Vec<_> = harmonics
                .filter_map(|harmonic| self.stiffness.get(&(harmonic * cycles)))
                .map(|coefficient| self.of_unstable(coefficient))
                .collect();
            let frequency = speed * self.frequency * cycles as f64;
            growth::growth(frequency, &frequencies, &rates, &stiffness)
        };
        let all = self.orders.meshes().iter().map(of_mesh);
        // NaN must remain NaN.
        all.fold(
            0.0,
            |largest: f64, growth| if largest.is_nan() || growth <= largest { largest } else { growth },
        )
    }

    /// Returns the part of a matrix for the modes that can become unstable.
    fn of_unstable<T: nalgebra::Scalar>(&self, matrix: &DMatrix<T>) -> DMatrix<T> {
        matrix.select_rows(&self.unstable).select_columns(&self.unstable)
    }

    /// Returns the deviation from static equilibrium in modal coordinates by order of the response.
    fn deviation(&self, speed: f64) -> Option<Mat<c64>> {
        let frequency = speed * self.frequency;
        let rates = &self.damping + speed * &self.gyroscopic;
        let response = self.orders.response();
        let [damped, turned] = &self.static_rates;
        let modal = self.static_modal_damping(frequency);
        let right = Mat::from_fn(rates.nrows(), response.len(), |i, block| {
            let omega = response[block] as f64 * frequency;
            let rated = damped[block][i] + turned[block][i] * speed;
            let statics = self.statics[block][i] * (omega * omega);
            let force = statics - rated * Complex::new(0.0, omega) - modal[block][i];
            c64::new(force.re, force.im)
        });
        self.couplings.solve(frequency, &rates, &self.rigid, &right)
    }

    /// Returns the product of the modal damping and the rate of the static equilibrium by order of
    /// the response.
    fn static_modal_damping(&self, frequency: f64) -> Vec<DVector<Complex<f64>>> {
        let response = self.orders.response();
        let of = |&order: &i64| {
            let mut sum = DVector::zeros(self.damping.nrows());
            for (block, &of_block) in response.iter().enumerate() {
                let Some(coefficient) = self.modal_damping.get(&(order - of_block).abs()) else { continue };
                let rate = &self.statics[block] * Complex::new(0.0, of_block as f64 * frequency);
                sum += if order < of_block { coefficient.conjugate() * rate } else { coefficient * rate };
            }
            sum
        };
        response.iter().map(of).collect()
    }

    /// Returns the amplitudes of a quantity from the deviation by order of the response.
    fn value(&self, quantity: usize, speed: f64, deviation: &Mat<c64>) -> Amplitudes {
        let ModalQuantity { rows, rates, static_rates } = &self.quantities[quantity];
        let frequency = speed * self.frequency;
        let amplitude = |(index, (order, _)): (usize, (i64, orders::Line))| {
            let mut sum = Complex::new(0.0, 0.0);
            for (block, &of_block) in self.orders.response().iter().enumerate() {
                let omega = Complex::new(0.0, of_block as f64 * frequency);
                for (series, factor) in [(rows, Complex::new(1.0, 0.0)), (rates, omega)] {
                    let Some(row) = series.get(&(order - of_block).abs()) else { continue };
                    let is_conjugate = order < of_block;
                    let product = row.iter().zip(deviation.col(block).iter()).map(|(entry, value)| {
                        let entry = if is_conjugate { entry.conj() } else { *entry };
                        entry * Complex::new(value.re, value.im)
                    });
                    sum += factor * product.sum::<Complex<f64>>();
                }
            }
            self.static_values[quantity][index] + static_rates[index] * frequency + sum * one_sided(order)
        };
        self.orders.lines().enumerate().map(amplitude).collect()
    }
}

/// Returns the multiple of the highest frequency up to which modes have inertia.
fn multiple(coordinates: bool) -> f64 {
    if coordinates { basis::DYNAMIC_COORDINATES } else { basis::DYNAMIC }
}

/// Returns the highest frequency of a response up to a speed relative to the reference speed,
/// rad/s. It is infinite if carriers rotate: the mean stiffness along ground axes is not that of
/// the modes, so all modes need inertia.
fn highest_frequency(system: &PeriodicSystem, highest: f64) -> f64 {
    match system.orders.rotates() {
        true => f64::INFINITY,
        false => system.orders.highest() as f64 * highest * system.frequency,
    }
}

/// Returns the Fourier coefficients of the damping by the damping ratio in modal coordinates with
/// these frequencies (rad/s), rad/s. With the stiffness `kappa` at a position it is `2 zeta
/// kappa^(1/2)` for rotating carriers, and its mean over the mesh cycles counts. `None` if the
/// stiffness is not finite.
fn modal_damping(
    system: &PeriodicSystem,
    stiffness: &[DMatrix<f64>],
    frequencies: &[f64],
) -> Option<Coefficients> {
    let factor = 2.0 * system.damping_ratio;
    if !system.orders.rotates() || factor == 0.0 {
        let own = frequencies.iter().map(|frequency| Complex::from(factor * frequency));
        let diagonal = DVector::from_iterator(frequencies.len(), own);
        return Some(Coefficients::from([(0, DMatrix::from_diagonal(&diagonal))]));
    }
    let root = |stiffness: &DMatrix<f64>| basis::square_root(stiffness).map(|root| factor * root);
    let samples: Vec<DMatrix<f64>> = stiffness.iter().map(root).collect::<Option<_>>()?;
    Some(
        system
            .orders
            .turning()
            .iter()
            .map(|&order| (order, matrix_coefficient(&samples, &system.sampling, order)))
            .collect(),
    )
}

/// Returns the amplitudes of the product of a row and the rate of the static equilibrium at the
/// unit frequency of the period.
fn static_rates(
    row: &Series<DVector<Complex<f64>>>,
    statics: &[DVector<Complex<f64>>],
    orders: &Orders,
) -> Amplitudes {
    let amplitude = |(order, _): (i64, orders::Line)| {
        let term = |(block, &of_block): (usize, &i64)| {
            let row = row.get(&(order - of_block).abs())?;
            let product = row.iter().zip(statics[block].iter()).map(|(entry, value)| {
                let entry = if order < of_block { entry.conj() } else { *entry };
                entry * value
            });
            Some(product.sum::<Complex<f64>>() * Complex::new(0.0, of_block as f64))
        };
        let sum: Complex<f64> = orders.response().iter().enumerate().filter_map(term).sum();
        sum * one_sided(order)
    };
    orders.lines().map(amplitude).collect()
}

#[cfg(test)]
mod coordinate_tests;
#[cfg(test)]
mod tests;
