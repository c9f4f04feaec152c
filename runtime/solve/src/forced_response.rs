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
//! one complex linear system for all harmonics: the Toeplitz blocks of kappa couple them. Modes far
//! above all harmonics have no inertia: they are condensed at each sample.
//!
//! See `docs/theory/forced-response.md`.

use calyx_numerics::dense::{solve_complex, symmetric_eigen};
use faer::{Mat, c64};
use nalgebra::{Complex, DMatrix, DVector};
use std::f64::consts::TAU;

/// A mode has inertia if its frequency is at most this multiple of the highest harmonic's.
const DYNAMIC: f64 = 6.0;
/// Frequency relative to the highest one below which a mode is a rigid-body motion.
const RIGID: f64 = 1e-7;

/// Largest ratio of the frequencies of a mode and of the period up to which the mode can become
/// unstable: the growth of higher orders is below any damping.
const ORDERS: f64 = 12.0;
/// Steps of a period in which the growth of disturbances is integrated: 25 in the shortest period.
const STEPS: usize = 300;
/// Number of squarings of the matrix of a period, whose norm then gives its spectral radius.
const SQUARINGS: i32 = 14;

/// Complex amplitudes of harmonics 0 to H: the value at phase `p` in 0 to 1 is the real part of
/// `c_0 + sum c_h exp(2 pi i h p)`.
pub type Harmonics = Vec<Complex<f64>>;

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
    /// Derivatives by the rates of all coordinates, if the value depends on them.
    pub rate: Option<DVector<f64>>,
}

/// A periodic system in modal coordinates, prepared for many speeds.
pub struct ForcedVibration {
    harmonics: usize,
    frequency: f64,
    /// Frequencies of the modes with inertia, rad/s.
    frequencies: Vec<f64>,
    /// Modes without stiffness.
    rigid: Vec<bool>,
    damping_ratio: f64,
    damping: DMatrix<f64>,
    gyroscopic: DMatrix<f64>,
    /// Fourier coefficients of the stiffness, from 0 to twice the number of harmonics.
    stiffness: Vec<DMatrix<Complex<f64>>>,
    /// Fourier coefficients of the static equilibrium by harmonic.
    statics: Vec<DVector<Complex<f64>>>,
    /// Fourier coefficients of the products of static equilibrium and damping or gyroscopic matrix.
    static_rates: [Vec<DVector<Complex<f64>>>; 2],
    quantities: Vec<ModalQuantity>,
    /// Fourier coefficients of the static values by quantity, from 0 to the number of harmonics.
    static_values: Vec<Harmonics>,
}

/// A quantity in modal coordinates.
struct ModalQuantity {
    /// Fourier coefficients of the row, from 0 to twice the number of harmonics.
    rows: Vec<DVector<Complex<f64>>>,
    /// Derivatives by the rates of the modes, and Fourier coefficients of the product of the
    /// derivatives by all rates and the static equilibrium.
    rate: Option<(DVector<Complex<f64>>, Harmonics)>,
}

/// Returns the Fourier coefficient of equally spaced samples at a harmonic.
fn coefficient(samples: usize, harmonic: usize, mut add: impl FnMut(usize, Complex<f64>)) {
    for k in 0..samples {
        let angle = -TAU * ((harmonic * k) % samples) as f64 / samples as f64;
        add(k, Complex::new(angle.cos(), angle.sin()) / samples as f64);
    }
}

fn vector_coefficient(samples: &[DVector<f64>], harmonic: usize) -> DVector<Complex<f64>> {
    let mut found = DVector::zeros(samples.first().map_or(0, |first| first.len()));
    coefficient(samples.len(), harmonic, |k, weight| {
        found += samples[k].map(|value| weight * value);
    });
    found
}

fn matrix_coefficient(samples: &[DMatrix<f64>], harmonic: usize) -> DMatrix<Complex<f64>> {
    let size = samples.first().map_or(0, |first| first.nrows());
    let mut found = DMatrix::zeros(size, size);
    coefficient(samples.len(), harmonic, |k, weight| {
        found += samples[k].map(|value| weight * value);
    });
    found
}

/// Returns the smallest number of samples for a number of harmonics: the stiffness couples
/// harmonics up to twice their number, which more samples resolve without aliasing.
pub fn sample_count(harmonics: usize) -> usize {
    4 * harmonics + 2
}

/// Modes of the mean stiffness, those with inertia first.
struct Basis {
    frequencies: Vec<f64>,
    shapes: DMatrix<f64>,
    /// Number of modes with inertia.
    dynamic: usize,
}

impl Basis {
    fn of(system: &PeriodicSystem, harmonics: usize, highest: f64) -> Option<Basis> {
        let mean = system.stiffness.iter().sum::<DMatrix<f64>>() / system.stiffness.len().max(1) as f64;
        let (frequencies, shapes) = modes(&system.mass, &mean)?;
        let limit = DYNAMIC * harmonics as f64 * highest * system.frequency;
        let dynamic = frequencies.partition_point(|frequency| *frequency <= limit);
        Some(Basis { frequencies, shapes, dynamic })
    }

    fn with_inertia(&self) -> DMatrix<f64> {
        self.shapes.columns(0, self.dynamic).clone_owned()
    }

    /// Returns the stiffness of the modes with inertia at a sample, and the deflection of the
    /// others for each of them. `None` if the others have no stiffness.
    fn condensed(&self, stiffness: &DMatrix<f64>) -> Option<(DMatrix<f64>, DMatrix<f64>)> {
        let modal = self.shapes.transpose() * stiffness * &self.shapes;
        let (dynamic, others) = (self.dynamic, modal.nrows() - self.dynamic);
        let own = modal.view((0, 0), (dynamic, dynamic)).clone_owned();
        if others == 0 {
            return Some((own, DMatrix::zeros(0, dynamic)));
        }
        let between = modal.view((dynamic, 0), (others, dynamic)).clone_owned();
        let factor = modal.view((dynamic, dynamic), (others, others)).clone_owned().cholesky()?;
        let followed = -factor.solve(&between);
        Some((own + between.tr_mul(&followed), followed))
    }
}

/// Returns the number of unknowns of a system at a speed, see [`ForcedVibration::unknowns`]; `None`
/// if a matrix is invalid.
pub fn unknowns(system: &PeriodicSystem, harmonics: usize, highest: f64) -> Option<usize> {
    Basis::of(system, harmonics, highest).map(|basis| basis.dynamic * (2 * harmonics + 1))
}

impl ForcedVibration {
    /// Prepares the response up to a number of harmonics and a highest speed relative to the
    /// reference speed. `None` if a matrix is not finite or not positive definite.
    pub fn new(
        system: &PeriodicSystem,
        quantities: &[LinearQuantity],
        harmonics: usize,
        highest: f64,
    ) -> Option<ForcedVibration> {
        let all = Basis::of(system, harmonics, highest)?;
        let basis = all.with_inertia();
        let condensed: Vec<(DMatrix<f64>, DMatrix<f64>)> =
            system.stiffness.iter().map(|stiffness| all.condensed(stiffness)).collect::<Option<_>>()?;
        let (stiffness, followed): (Vec<_>, Vec<_>) = condensed.into_iter().unzip();
        let others = all.shapes.columns(all.dynamic, all.shapes.ncols() - all.dynamic);
        let projected = |matrix: &DMatrix<f64>| -> Vec<DVector<Complex<f64>>> {
            let onto = basis.transpose() * matrix;
            let samples: Vec<DVector<f64>> = system.statics.iter().map(|at| &onto * at).collect();
            (0..=harmonics).map(|harmonic| vector_coefficient(&samples, harmonic)).collect()
        };
        let quantity = |quantity: &LinearQuantity| {
            let row = |(sample, followed): (usize, &DMatrix<f64>)| {
                let row = &quantity.rows[sample.min(quantity.rows.len() - 1)];
                basis.tr_mul(row) + followed.tr_mul(&others.tr_mul(row))
            };
            let rows: Vec<DVector<f64>> = followed.iter().enumerate().map(row).collect();
            let rate = quantity.rate.as_ref().map(|rate| {
                let statics: Vec<f64> = system.statics.iter().map(|at| rate.dot(at)).collect();
                (basis.tr_mul(rate).map(Complex::from), series(&statics, harmonics))
            });
            ModalQuantity {
                rows: (0..=2 * harmonics).map(|harmonic| vector_coefficient(&rows, harmonic)).collect(),
                rate,
            }
        };
        let frequencies = all.frequencies[..all.dynamic].to_vec();
        let largest = all.frequencies.last().copied().unwrap_or_default();
        let own = frequencies.iter().map(|frequency| 2.0 * system.damping_ratio * frequency);
        Some(ForcedVibration {
            harmonics,
            frequency: system.frequency,
            damping_ratio: system.damping_ratio,
            rigid: frequencies.iter().map(|frequency| *frequency <= RIGID * largest).collect(),
            damping: basis.transpose() * &system.damping * &basis
                + DMatrix::from_diagonal(&DVector::from_iterator(all.dynamic, own)),
            gyroscopic: basis.transpose() * &system.gyroscopic * &basis,
            stiffness: (0..=2 * harmonics).map(|harmonic| matrix_coefficient(&stiffness, harmonic)).collect(),
            statics: projected(&system.mass),
            static_rates: [projected(&system.damping), projected(&system.gyroscopic)],
            quantities: quantities.iter().map(quantity).collect(),
            static_values: quantities.iter().map(|quantity| series(&quantity.statics, harmonics)).collect(),
            frequencies,
        })
    }

    /// Returns the number of unknowns of a speed.
    pub fn unknowns(&self) -> usize {
        self.damping.nrows() * (2 * self.harmonics + 1)
    }

    /// Returns the static values: the limit of slow rotation.
    pub fn static_values(&self) -> &[Harmonics] {
        &self.static_values
    }

    /// Returns the harmonics of all quantities at a speed relative to the reference speed. `None`
    /// if the response is not finite: an undamped resonance. At rest it is static.
    pub fn at(&self, speed: f64) -> Option<Vec<Harmonics>> {
        if speed == 0.0 {
            return Some(self.static_values.clone());
        }
        let deviation = self.deviation(speed)?;
        Some((0..self.quantities.len()).map(|quantity| self.value(quantity, speed, &deviation)).collect())
    }

    /// Returns the factor by which a disturbance grows within a period at a speed: the spectral
    /// radius of the monodromy matrix (Floquet). Above 1 the varying stiffness makes the vibration
    /// unstable, and it never becomes that of [`ForcedVibration::at`]. NaN if the matrix is not
    /// finite.
    ///
    /// The implicit midpoint rule integrates over the period. It neither damps nor excites. Modes
    /// above twelve times the frequency of the period are left out.
    pub fn growth(&self, speed: f64) -> f64 {
        let limit = ORDERS * speed * self.frequency;
        let modes = self.frequencies.partition_point(|frequency| *frequency <= limit);
        if modes == 0 || speed == 0.0 {
            return 0.0;
        }
        let rates =
            self.damping.view((0, 0), (modes, modes)) + speed * self.gyroscopic.view((0, 0), (modes, modes));
        let half = 0.5 * TAU / (speed * self.frequency * STEPS as f64);
        let mut positions = DMatrix::<f64>::identity(modes, 2 * modes);
        let mut velocities = DMatrix::<f64>::zeros(modes, 2 * modes);
        velocities.view_mut((0, modes), (modes, modes)).fill_with_identity();
        for step in 0..STEPS {
            let stiffness = self.stiffness_at((step as f64 + 0.5) / STEPS as f64, modes);
            let matrix = DMatrix::identity(modes, modes) + half * &rates + half * half * &stiffness;
            let Some(middle) = matrix.lu().solve(&(&velocities - half * &stiffness * &positions)) else {
                return f64::NAN;
            };
            positions += 2.0 * half * &middle;
            velocities = 2.0 * middle - velocities;
        }
        spectral_radius(DMatrix::from_fn(2 * modes, 2 * modes, |i, j| match i.checked_sub(modes) {
            None => positions[(i, j)],
            Some(i) => velocities[(i, j)],
        }))
    }

    /// Returns the stiffness of the lowest modes at a phase of the period from 0 to 1.
    fn stiffness_at(&self, phase: f64, modes: usize) -> DMatrix<f64> {
        let of = |coefficient: &DMatrix<Complex<f64>>| coefficient.view((0, 0), (modes, modes)).clone_owned();
        let mut found = of(&self.stiffness[0]).map(|value| value.re);
        for (harmonic, coefficient) in self.stiffness.iter().enumerate().skip(1) {
            let (sine, cosine) = (TAU * harmonic as f64 * phase).sin_cos();
            found += of(coefficient).map(|value| 2.0 * (value.re * cosine - value.im * sine));
        }
        found
    }

    /// Returns the damping of a mode by the damping ratio, rad/s.
    fn modal_damping(&self, mode: usize) -> f64 {
        2.0 * self.damping_ratio * self.frequencies[mode]
    }

    /// Returns the deviation from static equilibrium in modal coordinates, for harmonics -H to H.
    fn deviation(&self, speed: f64) -> Option<Vec<DVector<Complex<f64>>>> {
        let (modes, count) = (self.damping.nrows(), self.harmonics as isize);
        let frequency = speed * self.frequency;
        let order = |block: usize| block as isize - count;
        // Damping and gyroscopic terms by mode, at the speed.
        let rates = &self.damping + speed * &self.gyroscopic;
        let blocks = 2 * self.harmonics + 1;
        let mut matrix = Mat::<c64>::zeros(blocks * modes, blocks * modes);
        let mut right = Mat::<c64>::zeros(blocks * modes, 1);
        for row in 0..blocks {
            let omega = order(row) as f64 * frequency;
            let statics = with_sign(&self.statics, order(row));
            let [damped, turned] = [0, 1].map(|kind| with_sign(&self.static_rates[kind], order(row)));
            for i in 0..modes {
                let rated = damped[i] + turned[i] * speed + statics[i] * self.modal_damping(i);
                let force = statics[i] * (omega * omega) - rated * Complex::new(0.0, omega);
                right[(row * modes + i, 0)] = c64::new(force.re, force.im);
                for j in 0..modes {
                    matrix[(row * modes + i, row * modes + j)] += c64::new(0.0, omega * rates[(i, j)]);
                }
                matrix[(row * modes + i, row * modes + i)] -= c64::new(omega * omega, 0.0);
            }
            for column in 0..blocks {
                let stiffness = &self.stiffness[order(row).abs_diff(order(column))];
                let sign = if row >= column { 1.0 } else { -1.0 };
                for j in 0..modes {
                    for i in 0..modes {
                        let entry = stiffness[(i, j)];
                        matrix[(row * modes + i, column * modes + j)] += c64::new(entry.re, sign * entry.im);
                    }
                }
            }
        }
        // No spring determines the mean position of a rigid-body motion.
        for mode in (0..modes).filter(|mode| self.rigid[*mode]) {
            matrix[(self.harmonics * modes + mode, self.harmonics * modes + mode)] += c64::new(1.0, 0.0);
        }
        let found = solve_complex(matrix, right)?;
        let block = |row: usize| {
            DVector::from_fn(modes, |i, _| {
                let value = found[(row * modes + i, 0)];
                Complex::new(value.re, value.im)
            })
        };
        Some((0..blocks).map(block).collect())
    }

    /// Returns the harmonics of a quantity, from the deviation by harmonics -H to H.
    fn value(&self, quantity: usize, speed: f64, deviation: &[DVector<Complex<f64>>]) -> Harmonics {
        let ModalQuantity { rows, rate } = &self.quantities[quantity];
        let count = self.harmonics as isize;
        (0..=count)
            .map(|harmonic| {
                let mut sum = Complex::new(0.0, 0.0);
                for (block, of_block) in deviation.iter().enumerate() {
                    let order = harmonic - (block as isize - count);
                    if (order.unsigned_abs()) < rows.len() {
                        sum += with_sign(rows, order).tr_mul(of_block)[0];
                    }
                }
                let omega = Complex::new(0.0, harmonic as f64 * speed * self.frequency);
                let double = if harmonic == 0 { 1.0 } else { 2.0 };
                let mut found = self.static_values[quantity][harmonic as usize] + sum * double;
                if let Some((rate, statics)) = rate {
                    let of_modes = rate.tr_mul(&deviation[(count + harmonic) as usize])[0] * double;
                    found += omega * (of_modes + statics[harmonic as usize]);
                }
                found
            })
            .collect()
    }
}

/// Returns the spectral radius of a matrix, to a part in a thousand: the limit of the norms of its
/// powers.
fn spectral_radius(mut matrix: DMatrix<f64>) -> f64 {
    let mut logarithm = 0.0;
    for squaring in 0..=SQUARINGS {
        let norm = matrix.norm();
        if norm == 0.0 || !norm.is_finite() {
            return norm;
        }
        logarithm += norm.ln() / 2f64.powi(squaring);
        matrix /= norm;
        matrix = &matrix * &matrix;
    }
    logarithm.exp()
}

/// Returns the coefficient of a real series at a harmonic of either sign.
fn with_sign(series: &[DVector<Complex<f64>>], order: isize) -> DVector<Complex<f64>> {
    let own = &series[order.unsigned_abs()];
    if order < 0 { own.map(|value| value.conj()) } else { own.clone() }
}

/// Returns the one-sided harmonics of equally spaced real samples.
fn series(samples: &[f64], harmonics: usize) -> Harmonics {
    (0..=harmonics)
        .map(|harmonic| {
            let mut sum = Complex::new(0.0, 0.0);
            coefficient(samples.len(), harmonic, |k, weight| sum += weight * samples[k]);
            if harmonic == 0 { sum } else { sum * 2.0 }
        })
        .collect()
}

/// Returns the frequencies (rad/s, ascending) and mass-normalized mode shapes of a stiffness.
/// `None` if the mass is not positive definite or an entry is not finite.
fn modes(mass: &DMatrix<f64>, stiffness: &DMatrix<f64>) -> Option<(Vec<f64>, DMatrix<f64>)> {
    let size = mass.nrows();
    // Unit inertia of each coordinate makes metres and radians comparable.
    let scale = DVector::from_fn(size, |k, _| mass[(k, k)].sqrt().recip());
    if !scale.iter().all(|scale| scale.is_finite()) {
        return None;
    }
    let scaled =
        |matrix: &DMatrix<f64>| DMatrix::from_fn(size, size, |i, j| scale[i] * matrix[(i, j)] * scale[j]);
    let lower = scaled(mass).cholesky()?.l();
    let half = lower.solve_lower_triangular(&scaled(stiffness))?;
    let whole = lower.solve_lower_triangular(&half.transpose())?;
    let symmetric = Mat::from_fn(size, size, |i, j| 0.5 * (whole[(i, j)] + whole[(j, i)]));
    let (squares, vectors) = symmetric_eigen(symmetric.as_ref())?;
    let vectors = DMatrix::from_fn(size, size, |i, j| vectors[(i, j)]);
    let shapes = lower.tr_solve_lower_triangular(&vectors)?;
    let shapes = DMatrix::from_fn(size, size, |i, j| scale[i] * shapes[(i, j)]);
    Some((squares.iter().map(|square| square.max(0.0).sqrt()).collect(), shapes))
}

#[cfg(test)]
mod tests;
