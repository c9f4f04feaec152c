//! Interpolation over the frequency: run-ups at any number of speeds from transfer vectors and
//! impedances at a few frequencies.

use crate::error::AcousticError;
use crate::fluid::Fluid;
use crate::mesh::SurfaceMesh;
use crate::transfer::{RadiationImpedance, TransferVectors};
use calyx_numerics::interrupt::{Interrupt, MemoryReservation};
use calyx_numerics::vec3::{length, minus};
use faer::c64;
use std::f64::consts::TAU;

/// Number of frequencies of an interpolation: polynomials of third degree.
const POINTS: usize = 4;

/// Transfer vectors over the frequency.
///
/// The phase exp(-ikr) of the distance r between triangle and point is divided out before the
/// interpolation, because it varies faster than the rest.
#[derive(Debug)]
pub struct TransferSweep {
    speed_of_sound: f64,
    vectors: Vec<TransferVectors>,
    /// Distances by point and triangle, m.
    distances: Vec<Vec<f64>>,
    /// Values without the phase by point, frequency and triangle.
    smooth: Vec<Vec<Vec<c64>>>,
    _memory: MemoryReservation,
}

impl TransferSweep {
    /// Creates the interpolation from transfer vectors of a mesh at ascending frequencies.
    ///
    /// # Errors
    /// There are fewer than four frequencies, they do not ascend, the points or triangles differ,
    /// or the caller refuses the memory.
    pub fn new(
        vectors: Vec<TransferVectors>,
        mesh: &SurfaceMesh,
        fluid: &Fluid,
        interrupt: &Interrupt,
    ) -> Result<Self, AcousticError> {
        check_frequencies(vectors.iter().map(TransferVectors::frequency))?;
        let triangles = mesh.triangles().len();
        let points = vectors[0].points().to_vec();
        if vectors.iter().any(|v| v.points() != points || v.vectors().nrows() != triangles) {
            return Err(AcousticError::input(
                "transfer vectors at different frequencies have different points or triangles",
                "compute all of them for the same points and mesh",
            ));
        }
        let bytes = 8 * points.len() * triangles * (2 * vectors.len() + 1);
        let memory = interrupt.reserve_memory(bytes as u64)?;
        let distances: Vec<Vec<f64>> = points
            .iter()
            .map(|point| (0..triangles).map(|t| length(minus(mesh.centroid(t), *point))).collect())
            .collect();
        let smooth = distances
            .iter()
            .enumerate()
            .map(|(point, distances)| {
                let at = |v: &TransferVectors| {
                    let wavenumber = TAU * v.frequency() / fluid.speed_of_sound;
                    let value = |(t, r): (usize, &f64)| {
                        let (sine, cosine) = (wavenumber * r).sin_cos();
                        v.vectors()[(t, point)] * c64::new(cosine, sine)
                    };
                    distances.iter().enumerate().map(value).collect()
                };
                vectors.iter().map(at).collect()
            })
            .collect();
        Ok(Self { speed_of_sound: fluid.speed_of_sound, vectors, distances, smooth, _memory: memory })
    }

    /// Returns the pressures at the points for normal velocities of the triangles at a frequency,
    /// Pa.
    ///
    /// # Errors
    /// The frequency is outside of the range, or the number of velocities is not that of the
    /// triangles.
    pub fn pressures(&self, frequency: f64, velocities: &[c64]) -> Result<Vec<c64>, AcousticError> {
        let (first, weights) = interpolation(self.vectors.iter().map(TransferVectors::frequency), frequency)?;
        crate::model::check_velocities(velocities, self.vectors[0].vectors().nrows(), 0)?;
        let wavenumber = TAU * frequency / self.speed_of_sound;
        let at = |(distances, smooth): (&Vec<f64>, &Vec<Vec<c64>>)| {
            let mut sum = c64::new(0.0, 0.0);
            for (triangle, (r, velocity)) in distances.iter().zip(velocities).enumerate() {
                let value: c64 = (0..POINTS).map(|k| smooth[first + k][triangle] * weights[k]).sum();
                let (sine, cosine) = (wavenumber * r).sin_cos();
                sum += value * c64::new(cosine, -sine) * velocity;
            }
            sum
        };
        Ok(self.distances.iter().zip(&self.smooth).map(at).collect())
    }
}

/// Radiation impedance over the frequency.
#[derive(Debug)]
pub struct ImpedanceSweep {
    impedances: Vec<RadiationImpedance>,
}

impl ImpedanceSweep {
    /// Creates the interpolation from impedances of the same patterns at ascending frequencies.
    ///
    /// # Errors
    /// There are fewer than four frequencies, they do not ascend, or the numbers of patterns
    /// differ.
    pub fn new(impedances: Vec<RadiationImpedance>) -> Result<Self, AcousticError> {
        check_frequencies(impedances.iter().map(RadiationImpedance::frequency))?;
        let count = impedances[0].matrix().nrows();
        if impedances.iter().any(|impedance| impedance.matrix().nrows() != count) {
            return Err(AcousticError::input(
                "impedances at different frequencies have different patterns",
                "compute all of them for the same patterns",
            ));
        }
        Ok(Self { impedances })
    }

    /// Returns the power of amplitudes of the patterns at a frequency, W.
    ///
    /// # Errors
    /// The frequency is outside of the range, or the number of amplitudes is not that of the
    /// patterns.
    pub fn power(&self, frequency: f64, amplitudes: &[c64]) -> Result<f64, AcousticError> {
        let count = self.impedances[0].matrix().nrows();
        if amplitudes.len() != count {
            return Err(AcousticError::input(
                format!("{} amplitudes for {count} patterns", amplitudes.len()),
                "pass one amplitude for each pattern",
            ));
        }
        let frequencies = self.impedances.iter().map(RadiationImpedance::frequency);
        let (first, weights) = interpolation(frequencies, frequency)?;
        let parts = weights.iter().zip(&self.impedances[first..]);
        Ok(parts.map(|(weight, impedance)| weight * impedance.power(amplitudes)).sum())
    }
}

fn check_frequencies(frequencies: impl Iterator<Item = f64>) -> Result<(), AcousticError> {
    let all: Vec<f64> = frequencies.collect();
    if all.len() < POINTS || all.windows(2).any(|pair| pair[0] >= pair[1]) {
        return Err(AcousticError::input(
            format!("the frequencies {all:?} are fewer than {POINTS} or do not ascend"),
            format!("state at least {POINTS} ascending frequencies"),
        ));
    }
    Ok(())
}

/// Returns the first frequency of an interpolation, and the weights of Lagrange's polynomials.
fn interpolation(
    frequencies: impl Iterator<Item = f64>,
    at: f64,
) -> Result<(usize, [f64; POINTS]), AcousticError> {
    let all: Vec<f64> = frequencies.collect();
    let [low, high] = [all[0], all[all.len() - 1]];
    if !(low..=high).contains(&at) {
        return Err(AcousticError::input(
            format!("the frequency {at} Hz is outside of {low} to {high} Hz"),
            "compute transfer vectors or impedances at frequencies around it",
        ));
    }
    let above = all.partition_point(|frequency| *frequency < at);
    let first = above.saturating_sub(POINTS / 2).min(all.len() - POINTS);
    let own = &all[first..first + POINTS];
    let weight = |k: usize| {
        let others = own.iter().enumerate().filter(|(other, _)| *other != k);
        others.map(|(_, other)| (at - other) / (own[k] - other)).product()
    };
    Ok((first, [0, 1, 2, 3].map(weight)))
}
