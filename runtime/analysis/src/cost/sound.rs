//! Predicted cost of radiated sound: the field of a body at some frequencies.

use super::{Cost, EFFICIENCY, Rates};
use crate::forced_response::highest_frequency;
use crate::radiated_sound::{JoinedRequests, SKIN_LINES, SoundRequest, SurfaceSize};
use crate::scene::Scene;
use calyx_acoustics::SoundMethod;
use calyx_model::fidelity::Fidelity;
use calyx_model::ids::BodyId;

/// Times of the integrals of a pair of triangles, of those of a triangle with the near ones, and of
/// a triangle with a point in the fluid, in logarithms. Measured: 4.5 s of two threads for a sphere
/// of 5,120 triangles, 0.44 s for a housing of 1,104 triangles, and 0.27 s more for 1,806 points,
/// on a machine with 3.3 nanoseconds per logarithm.
const LOGARITHMS_PER_PAIR: f64 = 58.0;
const LOGARITHMS_PER_TRIANGLE: f64 = 1.27e5;
const LOGARITHMS_PER_POINT: f64 = 65.0;
/// Time of a pair of triangles in the Rayleigh integral, in logarithms. Measured: 0.13 s of two
/// threads for the same housing.
const LOGARITHMS_PER_RAYLEIGH_PAIR: f64 = 52.0;
/// Assumed number of component modes with pseudo-modes.
const MODES: f64 = 60.0;
/// Number of frequencies per wavelength across the body, and those at low frequencies. The number
/// adapts to the body; these fit bodies of one to two wavelengths.
const PER_WAVELENGTH: f64 = 14.0;
const LOW_FREQUENCIES: f64 = 12.0;

/// Size of the last link from velocities to sound.
#[derive(Clone, Debug, PartialEq)]
pub struct SoundSize {
    /// Name of the body.
    pub body: String,
    /// Method.
    pub method: SoundMethod,
    /// Number of triangles.
    pub triangles: usize,
    /// Area of the surface, m².
    pub area: f64,
    /// Highest frequency, Hz.
    pub highest_frequency: f64,
    /// Number of frequencies at which the field is solved.
    pub frequencies: usize,
    /// Number of points at which the pressure is requested.
    pub points: usize,
    /// Number of velocity patterns.
    patterns: f64,
}

impl SoundSize {
    /// Predicts the cost on a machine of given rates.
    pub fn cost(&self, rates: &Rates) -> Cost {
        let (triangles, patterns, points) = (self.triangles as f64, self.patterns, self.points as f64);
        let vertices = 0.5 * triangles;
        let count = self.frequencies.max(1) as f64;
        let (logarithms, products, bytes) = match self.method {
            SoundMethod::EquivalentPower => {
                (0.0, triangles * patterns * patterns, 8.0 * triangles * patterns)
            }
            SoundMethod::Rayleigh => {
                let pairs = triangles * triangles;
                (LOGARITHMS_PER_RAYLEIGH_PAIR * pairs, pairs * patterns, 8.0 * triangles * patterns)
            }
            // A complex multiplication is four real ones.
            SoundMethod::BoundaryElements => {
                let pairs = LOGARITHMS_PER_PAIR * triangles + LOGARITHMS_PER_TRIANGLE;
                let columns = (2.0 * vertices + triangles) * vertices + points * (vertices + triangles);
                (
                    (pairs + LOGARITHMS_PER_POINT * points) * triangles,
                    4.0 * (vertices.powi(3) / 3.0 + columns * patterns),
                    16.0 * (vertices * (vertices + triangles) + (triangles + count * points) * patterns),
                )
            }
        };
        let solved = match self.method {
            SoundMethod::EquivalentPower => count,
            // The sound on the surface of the loudest lines is solved once more.
            _ => count + SKIN_LINES as f64,
        };
        let time = solved * (logarithms / rates.logarithms + products / rates.products);
        Cost { time: time / (EFFICIENCY * rates.threads.max(1) as f64), memory: bytes }
    }
}

/// Returns the sizes of all requested sounds of a scene with component modes up to a frequency, Hz.
/// Rejected requests are left out.
pub fn sound_size(scene: &Scene, fidelity: Fidelity, highest: f64) -> Vec<SoundSize> {
    let Some(response) = &scene.forced_response else { return Vec::new() };
    let highest = highest.min(highest_frequency(scene, response));
    let size = |request: &SoundRequest| {
        let connection = scene.connections.get(request.body.0)?;
        let SurfaceSize { triangles, area, width, points } =
            SurfaceSize::new(scene, request, highest).ok()?;
        let free = |id: BodyId| scene.bodies.get(id.0).map_or([false; 6], |body| body.free);
        let dofs = connection.bodies().flat_map(free).filter(|free| *free).count();
        let method = request.method_at(fidelity);
        let across = width * highest / request.fluid.speed_of_sound;
        Some(SoundSize {
            body: connection.name.clone(),
            method,
            triangles,
            area,
            highest_frequency: highest,
            frequencies: match method {
                SoundMethod::EquivalentPower => 0,
                _ => (LOW_FREQUENCIES + PER_WAVELENGTH * across).ceil() as usize,
            },
            points,
            patterns: dofs as f64 + MODES,
        })
    };
    JoinedRequests::new(&scene.sounds, fidelity).distinct.iter().filter_map(size).collect()
}
