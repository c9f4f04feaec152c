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
mod growth;
pub mod orders;

use balance::Couplings;
use basis::Basis;
use faer::{Mat, c64};
use nalgebra::{Complex, DMatrix, DVector};
use orders::Orders;
use std::collections::BTreeMap;
use std::f64::consts::TAU;

/// Frequency relative to the highest one below which a mode is a rigid-body motion.
const RIGID: f64 = 1e-7;

/// Complex amplitudes `c` of the orders from 0, ascending ([`Orders::lines`]): the value at the
/// fraction `p` of the common period is the real part of `sum c exp(2 pi i order p)`.
pub type Amplitudes = Vec<Complex<f64>>;

/// System with periodic coefficients, sampled at equal distances over its period.
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
    /// Frequency of the period at the reference speed, rad/s.
    pub frequency: f64,
    /// Damping ratio of all modes of the mean stiffness.
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
    damping_ratio: f64,
    damping: DMatrix<f64>,
    gyroscopic: DMatrix<f64>,
    /// Fourier coefficients of the stiffness.
    stiffness: Series<DMatrix<Complex<f64>>>,
    couplings: Couplings,
    /// Fourier coefficients of the static equilibrium by order of the response.
    statics: Vec<DVector<Complex<f64>>>,
    /// Fourier coefficients of the products of static equilibrium and damping or gyroscopic matrix.
    static_rates: [Vec<DVector<Complex<f64>>>; 2],
    quantities: Vec<ModalQuantity>,
    /// Amplitudes of the static values by quantity.
    static_values: Vec<Amplitudes>,
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

/// Calls a function for each sample with its weight in the Fourier coefficient of an order.
fn coefficient(samples: usize, order: i64, mut add: impl FnMut(usize, Complex<f64>)) {
    let order = order.rem_euclid(samples.max(1) as i64) as usize;
    for k in 0..samples {
        let angle = -TAU * ((order * k) % samples) as f64 / samples as f64;
        add(k, Complex::new(angle.cos(), angle.sin()) / samples as f64);
    }
}

fn number_coefficient(samples: &[f64], order: i64) -> Complex<f64> {
    let mut found = Complex::new(0.0, 0.0);
    coefficient(samples.len(), order, |k, weight| found += weight * samples[k]);
    found
}

fn vector_coefficient(samples: &[DVector<f64>], order: i64) -> DVector<Complex<f64>> {
    let mut found = DVector::zeros(samples.first().map_or(0, |first| first.len()));
    coefficient(samples.len(), order, |k, weight| found += samples[k].map(|value| weight * value));
    found
}

fn matrix_coefficient(samples: &[DMatrix<f64>], order: i64) -> DMatrix<Complex<f64>> {
    let size = samples.first().map_or(0, |first| first.nrows());
    let mut found = DMatrix::zeros(size, size);
    coefficient(samples.len(), order, |k, weight| {
        found.zip_apply(&samples[k], |sum, value| *sum += weight * value);
    });
    found
}

/// Returns the series of rows by sample; that of one constant row is its mean.
fn row_series(rows: &[DVector<f64>], orders: &Orders) -> Series<DVector<Complex<f64>>> {
    match rows {
        [] => Series::new(),
        [constant] => Series::from([(0, constant.map(Complex::from))]),
        _ => orders.coupling().iter().map(|&order| (order, vector_coefficient(rows, order))).collect(),
    }
}

/// Returns the amplitudes of real samples at the orders from zero.
fn amplitudes(samples: &[f64], orders: &Orders) -> Amplitudes {
    orders.lines().map(|(order, _)| one_sided(order) * number_coefficient(samples, order)).collect()
}

/// Returns the factor of an amplitude over the coefficient of a positive order: two, as the
/// negative order is included.
fn one_sided(order: i64) -> f64 {
    if order == 0 { 1.0 } else { 2.0 }
}

/// Returns the number of unknowns of a system up to a speed relative to the reference speed; `None`
/// if a matrix is invalid.
pub fn unknowns(system: &PeriodicSystem, highest: f64) -> Option<usize> {
    let highest = system.orders.highest() as f64 * highest * system.frequency;
    let basis = Basis::of(&system.mass, &system.stiffness, highest)?;
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
        let orders = system.orders.clone();
        let highest = orders.highest() as f64 * highest * system.frequency;
        let all = Basis::of(&system.mass, &system.stiffness, highest)?;
        let (basis, others) = (all.with_inertia(), all.without_inertia());
        let condensed: Vec<(DMatrix<f64>, DMatrix<f64>)> =
            system.stiffness.iter().map(|stiffness| all.condensed(stiffness)).collect::<Option<_>>()?;
        let (stiffness, followed): (Vec<_>, Vec<_>) = condensed.into_iter().unzip();
        let stiffness: Series<_> =
            orders.coupling().iter().map(|&order| (order, matrix_coefficient(&stiffness, order))).collect();
        let statics: Vec<DVector<Complex<f64>>> =
            orders.response().iter().map(|&order| vector_coefficient(&system.statics, order)).collect();
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
                rows: row_series(&rows, &orders),
                rates: row_series(&modal, &orders),
                static_rates: static_rates(&row_series(&quantity.rates, &orders), &statics, &orders),
            }
        };
        let frequencies = all.frequencies[..all.dynamic].to_vec();
        let largest = all.frequencies.last().copied().unwrap_or_default();
        let is_rigid = |frequency: &f64| f64::from(u8::from(*frequency <= RIGID * largest));
        let own = frequencies.iter().map(|frequency| 2.0 * system.damping_ratio * frequency);
        Some(ForcedVibration {
            frequency: system.frequency,
            damping_ratio: system.damping_ratio,
            rigid: frequencies.iter().map(is_rigid).collect(),
            damping: basis.transpose() * &system.damping * &basis
                + DMatrix::from_diagonal(&DVector::from_iterator(all.dynamic, own)),
            gyroscopic: basis.transpose() * &system.gyroscopic * &basis,
            couplings: Couplings::new(&orders, &stiffness),
            stiffness,
            static_rates: [projected(&system.damping), projected(&system.gyroscopic)],
            quantities: quantities.iter().map(quantity).collect(),
            static_values: quantities.iter().map(|of| amplitudes(&of.statics, &orders)).collect(),
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

    /// Returns the static values: the limit of slow rotation.
    pub fn static_values(&self) -> &[Amplitudes] {
        &self.static_values
    }

    /// Returns the amplitudes of all quantities at a speed relative to the reference speed. `None`
    /// if the response is not finite: an undamped resonance. At rest it is static.
    pub fn at(&self, speed: f64) -> Option<Vec<Amplitudes>> {
        if speed == 0.0 {
            return Some(self.static_values.clone());
        }
        let deviation = self.deviation(speed)?;
        Some((0..self.quantities.len()).map(|quantity| self.value(quantity, speed, &deviation)).collect())
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
        let rates = &self.damping + speed * &self.gyroscopic;
        let of_mesh = |&cycles: &i64| {
            let harmonics = 0..=2 * self.orders.harmonics() as i64;
            let stiffness: Vec<_> =
                harmonics.filter_map(|harmonic| self.stiffness.get(&(harmonic * cycles))).collect();
            let frequency = speed * self.frequency * cycles as f64;
            growth::growth(frequency, &self.frequencies, &rates, &stiffness)
        };
        let all = self.orders.meshes().iter().map(of_mesh);
        // NaN must remain NaN.
        all.fold(
            0.0,
            |largest: f64, growth| if largest.is_nan() || growth <= largest { largest } else { growth },
        )
    }

    /// Returns the damping of a mode by the damping ratio, rad/s.
    fn modal_damping(&self, mode: usize) -> f64 {
        2.0 * self.damping_ratio * self.frequencies[mode]
    }

    /// Returns the deviation from static equilibrium in modal coordinates by order of the response.
    fn deviation(&self, speed: f64) -> Option<Mat<c64>> {
        let frequency = speed * self.frequency;
        let rates = &self.damping + speed * &self.gyroscopic;
        let response = self.orders.response();
        let [damped, turned] = &self.static_rates;
        let right = Mat::from_fn(rates.nrows(), response.len(), |i, block| {
            let omega = response[block] as f64 * frequency;
            let statics = self.statics[block][i];
            let rated = damped[block][i] + turned[block][i] * speed + statics * self.modal_damping(i);
            let force = statics * (omega * omega) - rated * Complex::new(0.0, omega);
            c64::new(force.re, force.im)
        });
        self.couplings.solve(frequency, &rates, &self.rigid, &right)
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

/// Returns the amplitudes of the product of a row and the rate of the static equilibrium at the unit
/// frequency of the period.
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
mod tests;
