//! Sound field on the surface of a radiating body, and quantities that follow from it.

use crate::fluid::Fluid;
use crate::mesh::SurfaceMesh;
use crate::transfer::RadiationImpedance;
use faer::{Mat, c64};

/// Pressure and normal velocity on a surface, as complex amplitudes with the time factor exp(iωt).
#[derive(Clone, Debug, PartialEq)]
pub struct Radiation {
    frequency: f64,
    fluid: Fluid,
    pressures: Vec<c64>,
    velocities: Vec<c64>,
}

impl Radiation {
    pub(crate) fn new(frequency: f64, fluid: Fluid, pressures: Vec<c64>, velocities: Vec<c64>) -> Self {
        Self { frequency, fluid, pressures, velocities }
    }

    /// Returns the frequency, Hz.
    pub fn frequency(&self) -> f64 {
        self.frequency
    }

    /// Returns the pressures at the vertices, Pa.
    pub fn pressures(&self) -> &[c64] {
        &self.pressures
    }

    /// Returns the normal velocities of the triangles, m/s.
    pub fn velocities(&self) -> &[c64] {
        &self.velocities
    }

    /// Returns the mean pressure on a triangle, Pa.
    pub fn mean_pressure(&self, mesh: &SurfaceMesh, triangle: usize) -> c64 {
        mesh.triangles()[triangle].iter().map(|&vertex| self.pressures[vertex]).sum::<c64>() / 3.0
    }

    /// Returns the active intensity into the fluid on each triangle, W/m²: ½ Re(p v*).
    pub fn intensities(&self, mesh: &SurfaceMesh) -> Vec<f64> {
        let intensity = |(triangle, velocity): (usize, &c64)| {
            0.5 * (self.mean_pressure(mesh, triangle) * velocity.conj()).re
        };
        self.velocities.iter().enumerate().map(intensity).collect()
    }

    /// Returns the radiated sound power, W.
    pub fn power(&self, mesh: &SurfaceMesh) -> f64 {
        self.intensities(mesh).iter().zip(mesh.areas()).map(|(intensity, area)| intensity * area).sum()
    }

    /// Returns the radiation efficiency: the power relative to that of a plane wave with the same
    /// mean square velocity. NaN if the surface is at rest.
    pub fn efficiency(&self, mesh: &SurfaceMesh) -> f64 {
        self.power(mesh) / equivalent_radiated_power(mesh, &self.fluid, &self.velocities)
    }

    /// Returns the power of each panel, W. `panels` has the panel of each triangle, from 0 to
    /// `count`; the powers of triangles with larger numbers are omitted.
    pub fn panel_powers(&self, mesh: &SurfaceMesh, panels: &[usize], count: usize) -> Vec<f64> {
        let mut powers = vec![0.0; count];
        for ((intensity, area), panel) in self.intensities(mesh).iter().zip(mesh.areas()).zip(panels) {
            if let Some(power) = powers.get_mut(*panel) {
                *power += intensity * area;
            }
        }
        powers
    }
}

/// Returns the equivalent radiated power ½ρc ∫|v|² dS of normal velocities of the triangles, W: the
/// power of a surface that radiates plane waves everywhere.
pub fn equivalent_radiated_power(mesh: &SurfaceMesh, fluid: &Fluid, velocities: &[c64]) -> f64 {
    let sum: f64 = velocities.iter().zip(mesh.areas()).map(|(v, area)| v.norm_sqr() * area).sum();
    0.5 * fluid.impedance() * sum
}

/// Returns the impedance of real velocity patterns whose power is the equivalent radiated power. It
/// does not depend on the frequency, which is infinite in the result. A pattern has the normal
/// velocities of the triangles, m/s, and `areas` the areas of the triangles that count, m²: those
/// of a mesh, or of its panels.
pub fn equivalent_impedance(areas: &[f64], fluid: &Fluid, patterns: &[Vec<f64>]) -> RadiationImpedance {
    let product = |one: &[f64], other: &[f64]| -> f64 {
        one.iter().zip(other).zip(areas).map(|((one, other), area)| one * other * area).sum()
    };
    let impedance = Mat::from_fn(patterns.len(), patterns.len(), |i, j| {
        c64::new(fluid.impedance() * product(&patterns[i], &patterns[j]), 0.0)
    });
    RadiationImpedance::new(f64::INFINITY, impedance)
}
