//! Solutions of the sound field of velocity patterns at a frequency, and on the surface for
//! velocities at a line.

use super::engine_error;
use super::motion::Vibrating;
use super::plane::extent;
use calyx_acoustics::{RadiationModel, Settings, SolvedPatterns, SoundMethod, rayleigh};
use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::Interrupt;
use calyx_numerics::vec3::{Vector, dot};
use faer::{Mat, c64};
use std::f64::consts::TAU;

/// Polar angles of the far field: twice the number of wavelengths across the body and its mirror
/// image, and these.
const RINGS: usize = 10;

/// Sound of patterns at a frequency.
pub(super) struct Solution {
    /// Frequency, Hz.
    pub frequency: f64,
    /// Hermitian form of the power, over the square of the frequency.
    pub power: Mat<c64>,
    /// Hermitian forms of the powers of the panels on the surface, over the square of the
    /// frequency.
    pub panels: Vec<Mat<c64>>,
    /// Pressures at the points by pattern, without the phase of the distance and over the
    /// frequency.
    pub pressures: Mat<c64>,
    /// Amplitudes of the far field by direction and pattern, relative to the middle of the body and
    /// over the frequency.
    pub far_field: Mat<c64>,
}

/// Sound on the surface at a line.
#[derive(Clone, Debug, PartialEq)]
pub struct SkinField {
    /// Index of the line.
    pub line: usize,
    /// Normal velocities of the triangles, m/s.
    pub velocities: Vec<c64>,
    /// Pressures at the vertices, Pa; empty without boundary elements.
    pub pressures: Vec<c64>,
    /// Active intensities of the triangles into the fluid, W/m².
    pub intensities: Vec<f64>,
}

/// Solver of the field of a body.
pub(super) struct Solver<'a> {
    body: &'a Vibrating,
    model: RadiationModel,
    method: SoundMethod,
    patterns: Vec<Vec<c64>>,
    triangles: Vec<[Vector; 3]>,
    interrupt: &'a Interrupt,
}

impl<'a> Solver<'a> {
    pub fn new(body: &'a Vibrating, method: SoundMethod, interrupt: &'a Interrupt) -> Solver<'a> {
        let mesh = &body.surface.skin.mesh;
        let complex = |pattern: &Vec<f64>| pattern.iter().map(|value| c64::new(*value, 0.0)).collect();
        Solver {
            body,
            model: RadiationModel { mesh: mesh.clone(), fluid: body.fluid },
            method,
            patterns: body.patterns.iter().map(complex).collect(),
            triangles: (0..mesh.triangles().len()).map(|triangle| mesh.corners(triangle)).collect(),
            interrupt,
        }
    }

    /// Solves the field at a frequency. For boundary elements, `near` are velocities that occur
    /// near it, and their powers on the surface and in the far field are added to `powers`.
    ///
    /// # Errors
    /// Those of the acoustic solution and of the interrupt.
    pub fn solve(
        &self,
        frequency: f64,
        near: Option<&[c64]>,
        powers: &mut Vec<[f64; 2]>,
    ) -> Result<Solution, EngineError> {
        self.interrupt.check()?;
        let count = self.patterns.len();
        let shares: Vec<Vec<f64>> =
            self.body.surface.panels.iter().map(|panel| panel.shares.clone()).collect();
        let (impedance, panels, pressures, far_field) = match self.method {
            SoundMethod::EquivalentPower | SoundMethod::Rayleigh => {
                let all = vec![vec![1.0; self.triangles.len()]];
                let parts: Vec<Vec<f64>> = all.into_iter().chain(shares).collect();
                let medium = (&self.body.fluid, frequency);
                let patterns = &self.body.patterns;
                let found =
                    rayleigh::panel_impedances(&self.triangles, patterns, &parts, medium, self.interrupt);
                let mut found = found.map_err(engine_error)?;
                let panels = found.split_off(1);
                (found.remove(0), panels, Mat::zeros(0, count), Mat::zeros(0, count))
            }
            SoundMethod::BoundaryElements => {
                let equations = self.model.equations(frequency, &Settings::default(), self.interrupt);
                let equations = equations.map_err(engine_error)?;
                let solved = SolvedPatterns::new(&equations, &self.patterns, self.interrupt);
                let solved = solved.map_err(engine_error)?;
                let across = extent(&self.model.mesh) * frequency / self.body.fluid.speed_of_sound;
                let rings = RINGS + (2.0 * across).ceil() as usize;
                let far = solved.far_impedance(rings, self.interrupt).map_err(engine_error)?;
                if let Some(velocities) = near {
                    powers.push([&solved.impedance(), &far].map(|form| form.power(velocities)));
                }
                let panels = shares.iter().map(|shares| solved.panel_impedance(shares)).collect();
                (far, panels, self.pressures(&solved, frequency)?, self.far_field(&solved, frequency)?)
            }
        };
        let scale = 0.5 / (frequency * frequency);
        let hermitian = |form: &calyx_acoustics::RadiationImpedance| {
            let z = form.matrix();
            Mat::from_fn(count, count, |i, j| (z[(i, j)] + z[(j, i)].conj()) * scale)
        };
        Ok(Solution {
            frequency,
            power: hermitian(&impedance),
            panels: panels.iter().map(hermitian).collect(),
            pressures,
            far_field,
        })
    }

    fn wavenumber(&self, frequency: f64) -> f64 {
        TAU * frequency / self.body.fluid.speed_of_sound
    }

    /// Returns the pressures at the points by pattern, without the phase of the distance and over
    /// the frequency.
    fn pressures(&self, solved: &SolvedPatterns<'_, '_>, frequency: f64) -> Result<Mat<c64>, EngineError> {
        let wavenumber = self.wavenumber(frequency);
        let mut found = solved.pressures(&self.body.points, self.interrupt).map_err(engine_error)?;
        for (row, distance) in self.body.distances.iter().enumerate() {
            let turn = c64::from_polar(frequency.recip(), wavenumber * distance);
            (0..found.ncols()).for_each(|pattern| found[(row, pattern)] *= turn);
        }
        Ok(found)
    }

    /// Returns the amplitudes of the far field by direction and pattern, relative to the middle of
    /// the body and over the frequency.
    fn far_field(&self, solved: &SolvedPatterns<'_, '_>, frequency: f64) -> Result<Mat<c64>, EngineError> {
        let wavenumber = self.wavenumber(frequency);
        let vectors = &self.body.directions;
        let mut found = solved.far_field(vectors, self.interrupt).map_err(engine_error)?;
        for (row, vector) in vectors.iter().enumerate() {
            let turn = c64::from_polar(frequency.recip(), -wavenumber * dot(*vector, self.body.middle));
            (0..found.ncols()).for_each(|pattern| found[(row, pattern)] *= turn);
        }
        Ok(found)
    }

    /// Returns the sound on the surface for the velocities of the coordinates at a line.
    ///
    /// # Errors
    /// Those of the acoustic solution and of the interrupt.
    pub fn skin(&self, line: usize, frequency: f64, amplitudes: &[c64]) -> Result<SkinField, EngineError> {
        self.interrupt.check()?;
        let (mesh, fluid) = (&self.model.mesh, &self.body.fluid);
        let velocity = |triangle: usize| -> c64 {
            self.body.patterns.iter().zip(amplitudes).map(|(pattern, a)| a * pattern[triangle]).sum()
        };
        let velocities: Vec<c64> = (0..self.triangles.len()).map(velocity).collect();
        let (intensities, pressures) = match self.method {
            SoundMethod::EquivalentPower => {
                let intensity = |velocity: &c64| 0.5 * fluid.impedance() * velocity.norm_sqr();
                (velocities.iter().map(intensity).collect(), Vec::new())
            }
            SoundMethod::Rayleigh => {
                let powers =
                    rayleigh::triangle_powers(&self.triangles, &velocities, fluid, frequency, self.interrupt);
                let powers = powers.map_err(engine_error)?;
                (powers.iter().zip(mesh.areas()).map(|(power, area)| power / area).collect(), Vec::new())
            }
            SoundMethod::BoundaryElements => {
                let equations = self.model.equations(frequency, &Settings::default(), self.interrupt);
                let equations = equations.map_err(engine_error)?;
                let found = equations.solve(std::slice::from_ref(&velocities), self.interrupt);
                let radiation = found.map_err(engine_error)?.remove(0);
                (radiation.intensities(mesh), radiation.pressures().to_vec())
            }
        };
        Ok(SkinField { line, velocities, pressures, intensities })
    }
}
