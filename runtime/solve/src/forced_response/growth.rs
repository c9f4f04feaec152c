//! Growth of disturbances in a system with periodic stiffness (Floquet).

use nalgebra::{Complex, DMatrix};
use std::f64::consts::TAU;

/// Largest ratio of the frequencies of a mode and of the period up to which the mode can become
/// unstable: the growth of higher orders is below any damping.
const ORDERS: f64 = 12.0;
/// Steps of a period in which the growth of disturbances is integrated: 25 in the shortest period.
const STEPS: usize = 300;
/// Number of squarings of the matrix of a period, whose norm then gives its spectral radius.
const SQUARINGS: i32 = 14;

/// Part of the least variation of the stiffness for a parametric resonance at a damping ratio,
/// below which modes are stable.
const SAFE: f64 = 0.5;

/// Returns the modes that the varying stiffness can make unstable, and the lowest one, by index.
///
/// Two modes with the frequencies `w` resonate parametrically if the amplitude of the stiffness
/// between them exceeds `4 zeta w1 w2` (first-order theory of combination resonances, of which that
/// of one mode is a case). `frequencies` are those of the modes (rad/s), `stiffness` the Fourier
/// coefficients but the mean.
pub(super) fn unstable_modes<'m>(
    frequencies: &[f64],
    stiffness: impl Iterator<Item = &'m DMatrix<Complex<f64>>>,
    damping_ratio: f64,
) -> Vec<usize> {
    let modes = frequencies.len();
    let mut amplitudes = DMatrix::<f64>::zeros(modes, modes);
    for coefficient in stiffness {
        amplitudes += coefficient.map(|value| 2.0 * value.norm());
    }
    let resonates = |i: usize, j: usize| {
        amplitudes[(i, j)] >= SAFE * 4.0 * damping_ratio * frequencies[i] * frequencies[j]
    };
    (0..modes).filter(|&i| i == 0 || (0..modes).any(|j| resonates(i, j))).collect()
}

/// Returns the factor by which a disturbance grows within a period: the spectral radius of the
/// monodromy matrix. NaN if the matrix is not finite.
///
/// `frequency` is that of the period (rad/s), `frequencies` those of some modes in ascending order,
/// `rates` their damping and gyroscopic matrix, and `stiffness` the Fourier coefficients of their
/// stiffness from the mean on.
///
/// The implicit midpoint rule integrates over the period. It neither damps nor excites. Modes above
/// twelve times the frequency of the period are left out.
pub(super) fn growth(
    frequency: f64,
    frequencies: &[f64],
    rates: &DMatrix<f64>,
    stiffness: &[DMatrix<Complex<f64>>],
) -> f64 {
    let modes = frequencies.partition_point(|own| *own <= ORDERS * frequency);
    if modes == 0 || frequency == 0.0 {
        return 0.0;
    }
    let rates = rates.view((0, 0), (modes, modes));
    let half = 0.5 * TAU / (frequency * STEPS as f64);
    let mut positions = DMatrix::<f64>::identity(modes, 2 * modes);
    let mut velocities = DMatrix::<f64>::zeros(modes, 2 * modes);
    velocities.view_mut((0, modes), (modes, modes)).fill_with_identity();
    for step in 0..STEPS {
        let stiffness = stiffness_at(stiffness, (step as f64 + 0.5) / STEPS as f64, modes);
        let matrix = DMatrix::identity(modes, modes) + half * rates + half * half * &stiffness;
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
fn stiffness_at(coefficients: &[DMatrix<Complex<f64>>], phase: f64, modes: usize) -> DMatrix<f64> {
    let mut found = DMatrix::zeros(modes, modes);
    for (harmonic, coefficient) in coefficients.iter().enumerate() {
        let (sine, cosine) = (TAU * harmonic as f64 * phase).sin_cos();
        let double = if harmonic == 0 { 1.0 } else { 2.0 };
        let part = coefficient.view((0, 0), (modes, modes));
        found += part.map(|value| double * (value.re * cosine - value.im * sine));
    }
    found
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
