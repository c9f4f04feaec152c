//! Sound of a vibration at all of its frequencies.
//!
//! Cases are solved in octaves, the highest first. The surface of each octave is coarsened to six
//! elements in a wavelength of its highest frequency, and less if the waves of the walls are
//! shorter. Cases of the same frequency share the equations.

use super::cases::{CaseKind, refused};
use super::results::{CaseSound, SurfaceOfSound, SurfaceSound};
use super::surface::{ClosedSurface, edges_of_box, engine_error};
use super::vibration::Vibration;
use crate::coarse_surface::CoarseSurface;
use crate::fluid::Fluid;
use crate::mesh::SurfaceMesh;
use crate::method::SoundMethod;
use crate::model::{RadiationModel, Settings};
use crate::plane::RigidPlane;
use crate::radiation::equivalent_radiated_power;
use crate::rayleigh;
use crate::skin::Skin;
use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::Interrupt;
use calyx_numerics::vec3::Vector;
use faer::c64;

/// Elements per wavelength below which a warning states that the mesh is too coarse.
const COARSE: f64 = 5.0;
/// Relative difference of the powers on the surface and in the far field above which a warning
/// states it: 0.4 dB.
const NOTABLE: f64 = 0.1;
/// Polar angles of the far field: twice the number of wavelengths across the body and its mirror
/// image, and these.
const RINGS: usize = 10;

/// Options of the sound of a vibration.
#[derive(Clone, Debug, PartialEq)]
pub struct SoundOptions {
    /// Fluid around the body.
    pub fluid: Fluid,
    /// Method.
    pub method: SoundMethod,
    /// Rigid plane in front of which the body is; only with boundary elements.
    pub plane: Option<RigidPlane>,
    /// Points at which the pressure is computed, m; only with boundary elements.
    pub points: Vec<Vector>,
    /// Closes all openings of shells by lids that move with their rims.
    pub close_openings: bool,
}

impl Default for SoundOptions {
    fn default() -> Self {
        Self {
            fluid: Fluid::AIR,
            method: SoundMethod::default(),
            plane: None,
            points: Vec::new(),
            close_openings: false,
        }
    }
}

/// Computes the sound of all cases of a vibration. `progress` is called with the number of cases
/// that are done and that of all.
///
/// # Errors
/// E0784: the method has no pressures or no rigid plane, a point is not in the fluid, a node of the
/// surface has no result, or the acoustic solution fails. E0785: the surface does not enclose a
/// body. Those of the interrupt.
pub fn surface_sound(
    vibration: &Vibration,
    options: &SoundOptions,
    interrupt: &Interrupt,
    progress: &mut dyn FnMut(usize, usize),
) -> Result<SurfaceSound, EngineError> {
    options.check()?;
    let closed = ClosedSurface::new(vibration, options.close_openings, options.plane)?;
    let mesh = &closed.skin.mesh;
    check_points(mesh, options)?;
    check_frequencies(mesh, vibration, options)?;
    let count = vibration.cases.len();
    let bytes = 16 * mesh.triangles().len() * count;
    let _room = interrupt.reserve_memory(bytes as u64)?;
    let velocities: Vec<Vec<c64>> = vibration
        .cases
        .iter()
        .map(|case| closed.normal_velocities(vibration, case))
        .collect::<Result<_, _>>()?;
    let frequency = |case: usize| vibration.cases[case].frequency;
    // The highest frequency first, and cases of the same frequency together.
    let mut order: Vec<usize> = (0..count).collect();
    order.sort_by(|&one, &other| frequency(other).total_cmp(&frequency(one)).then(one.cmp(&other)));
    let mut solver = Solver { closed: &closed, options, interrupt, triangles: Vec::new(), coarse: None };
    let mut found: Vec<Option<CaseSound>> = vec![None; count];
    let mut done = 0;
    while done < count {
        let highest = frequency(order[done]);
        let octave = order[done..].iter().take_while(|&&case| frequency(case) > 0.5 * highest).count().max(1);
        let cases = &order[done..done + octave];
        let own: Vec<&[c64]> = cases.iter().map(|&case| &velocities[case][..]).collect();
        let surface = coarse_surface(&closed.skin, options.fluid.speed_of_sound / highest, &own)?;
        solver.triangles.push(surface.skin.mesh.triangles().len());
        let mut from = 0;
        while from < octave {
            let at = frequency(cases[from]);
            let same = cases[from..].iter().take_while(|&&case| frequency(case) == at).count().max(1);
            let kinds: Vec<&CaseKind> =
                cases[from..from + same].iter().map(|&case| &vibration.cases[case].kind).collect();
            let sounds = solver.solve(&surface, at, (&kinds, &own[from..from + same]))?;
            for (&case, sound) in cases[from..from + same].iter().zip(sounds) {
                found[case] = Some(sound);
            }
            from += same;
            progress(done + from, count);
        }
        done += octave;
    }
    Ok(solver.finish(vibration, found.into_iter().flatten().collect()))
}

impl SoundOptions {
    /// Checks that the method has what is requested.
    fn check(&self) -> Result<(), EngineError> {
        if self.method == SoundMethod::BoundaryElements {
            return Ok(());
        }
        let name = self.method.name();
        let missing = match (self.points.is_empty(), self.plane) {
            (false, _) => "sound pressure in the fluid",
            (true, Some(_)) => "rigid plane",
            (true, None) => return Ok(()),
        };
        Err(refused(
            format!("the method \"{name}\" has no {missing}"),
            "choose the method \"boundary_elements\", or leave this request out",
        ))
    }
}

/// Checks that the mean element of a mesh is shorter than the least wavelength. Otherwise the sound
/// would have no meaning, and the oscillating integrals would take long.
fn check_frequencies(
    mesh: &SurfaceMesh,
    vibration: &Vibration,
    options: &SoundOptions,
) -> Result<(), EngineError> {
    let highest = vibration.cases.iter().map(|case| case.frequency).fold(0.0, f64::max);
    let wavelength = options.fluid.speed_of_sound / highest;
    // Edge of equilateral triangles of the mean area.
    let edge = (mesh.area() / mesh.triangles().len() as f64 * 4.0 / 3f64.sqrt()).sqrt();
    if options.method == SoundMethod::EquivalentPower || edge <= wavelength {
        return Ok(());
    }
    let [x, y, z] = edges_of_box(mesh.vertices());
    Err(refused(
        format!(
            "the mean element, with edges of {edge:.3} m, is longer than the wavelength of {wavelength:.3} m at {highest:.1} Hz; the surface is in a box of {x:.3} x {y:.3} x {z:.3} m"
        ),
        "if the box is too large, state the unit of length (dataset 164, or `--length-unit` for a deck); else refine the mesh, or leave out high frequencies",
    ))
}

/// Checks that the points are in the fluid, before anything is solved.
fn check_points(mesh: &SurfaceMesh, options: &SoundOptions) -> Result<(), EngineError> {
    for &at in &options.points {
        let place = if !at.iter().all(|x| x.is_finite()) {
            "not finite"
        } else if options.plane.is_some_and(|plane| plane.distance(at) < 0.0) {
            "behind the rigid plane"
        } else if mesh.enclosure(at) > 0.5 {
            "inside of the body"
        } else {
            continue;
        };
        let [x, y, z] = at;
        return Err(refused(
            format!("the point ({x}, {y}, {z}) m, at which sound pressure is requested, is {place}"),
            "give a point in the fluid, in the coordinates of the file",
        ));
    }
    Ok(())
}

/// Coarsens a skin for a wavelength, m, and for these normal velocities.
fn coarse_surface(skin: &Skin, wavelength: f64, velocities: &[&[c64]]) -> Result<CoarseSurface, EngineError> {
    let parts: Vec<[Vec<f64>; 2]> = velocities.iter().map(|own| parts(own)).collect();
    let all: Vec<&[f64]> = parts.iter().flatten().map(Vec::as_slice).collect();
    CoarseSurface::new(skin, wavelength, &all).map_err(engine_error)
}

/// Returns the normal velocities of a coarsened surface from those of the fine one.
fn projected(surface: &CoarseSurface, velocities: &[c64]) -> Vec<c64> {
    let [real, imaginary] = parts(velocities).map(|part| surface.projection.normal_velocities(&part));
    real.into_iter().zip(imaginary).map(|(re, im)| c64::new(re, im)).collect()
}

/// Returns real and imaginary parts.
fn parts(velocities: &[c64]) -> [Vec<f64>; 2] {
    [|value: &c64| value.re, |value: &c64| value.im].map(|part| velocities.iter().map(part).collect())
}

/// Solver of all cases.
struct Solver<'a> {
    closed: &'a ClosedSurface,
    options: &'a SoundOptions,
    interrupt: &'a Interrupt,
    /// Numbers of triangles of the coarsened surfaces.
    triangles: Vec<usize>,
    /// Least number of elements in a wavelength, and its frequency, Hz.
    coarse: Option<(f64, f64)>,
}

impl Solver<'_> {
    /// Solves cases of one frequency, Hz, with these normal velocities of the fine triangles.
    fn solve(
        &mut self,
        surface: &CoarseSurface,
        frequency: f64,
        (kinds, velocities): (&[&CaseKind], &[&[c64]]),
    ) -> Result<Vec<CaseSound>, EngineError> {
        self.interrupt.check()?;
        let SoundOptions { fluid, method, points, .. } = self.options;
        let (fine, mesh) = (&self.closed.skin.mesh, &surface.skin.mesh);
        let elements = fluid.speed_of_sound / (frequency * mesh.longest_edge());
        if *method != SoundMethod::EquivalentPower && self.coarse.is_none_or(|(least, _)| elements < least) {
            self.coarse = Some((elements, frequency));
        }
        let projected: Vec<Vec<c64>> = velocities.iter().map(|own| projected(surface, own)).collect();
        let mut sounds: Vec<CaseSound> = kinds
            .iter()
            .zip(velocities)
            .map(|(kind, own)| {
                let equivalent_power = equivalent_radiated_power(fine, fluid, own);
                CaseSound {
                    kind: (*kind).clone(),
                    frequency,
                    power: equivalent_power,
                    equivalent_power,
                    mean_square_velocity: equivalent_power / (fluid.impedance() * fine.area()),
                    pressures: Vec::new(),
                    far_field_difference: f64::NAN,
                }
            })
            .collect();
        match method {
            SoundMethod::EquivalentPower => {}
            SoundMethod::Rayleigh => {
                let corners: Vec<[Vector; 3]> =
                    (0..mesh.triangles().len()).map(|triangle| mesh.corners(triangle)).collect();
                for (sound, own) in sounds.iter_mut().zip(&projected) {
                    let power = rayleigh::power(&corners, own, fluid, frequency, self.interrupt);
                    sound.power = power.map_err(engine_error)?;
                }
            }
            SoundMethod::BoundaryElements => {
                let model = RadiationModel { mesh: mesh.clone(), fluid: *fluid };
                let equations = model.equations(frequency, &Settings::default(), self.interrupt);
                let equations = equations.map_err(engine_error)?;
                let radiations = equations.solve(&projected, self.interrupt).map_err(engine_error)?;
                let rings = RINGS + (2.0 * mesh.extent() * frequency / fluid.speed_of_sound).ceil() as usize;
                for (sound, radiation) in sounds.iter_mut().zip(&radiations) {
                    let far = equations.far_field_power(radiation, rings, self.interrupt);
                    sound.power = far.map_err(engine_error)?;
                    sound.far_field_difference = (radiation.power(mesh) / sound.power - 1.0).abs();
                    if let CaseKind::Response(_) = sound.kind {
                        let pressures = equations.pressures(radiation, points, self.interrupt);
                        sound.pressures = pressures.map_err(engine_error)?;
                    }
                }
            }
        }
        let is_finite = |sound: &&CaseSound| sound.power.is_finite() && sound.equivalent_power.is_finite();
        if let Some(sound) = sounds.iter().find(|sound| !is_finite(sound)) {
            return Err(refused(
                format!("the sound power at {frequency} Hz is {} W", sound.power),
                "correct the velocities, which are too large",
            ));
        }
        Ok(sounds)
    }

    fn finish(self, vibration: &Vibration, cases: Vec<CaseSound>) -> SurfaceSound {
        let SoundOptions { fluid, method, points, .. } = self.options;
        let mesh = &self.closed.skin.mesh;
        let edges = edges_of_box(mesh.vertices());
        let [x, y, z] = edges.map(|edge| 1e3 * edge);
        let mut notes = vibration.notes.clone();
        notes.extend(self.closed.notes.iter().cloned());
        notes.push(format!(
            "the surface of {} triangles and {:.6} m² is in a box of {x:.1} x {y:.1} x {z:.1} mm",
            mesh.triangles().len(),
            mesh.area()
        ));
        let least = self.triangles.iter().copied().min().unwrap_or(0);
        let most = self.triangles.iter().copied().max().unwrap_or(0);
        if *method != SoundMethod::EquivalentPower && least < mesh.triangles().len() {
            let range = if least == most { format!("{least}") } else { format!("{least} to {most}") };
            notes.push(format!(
                "the surface is coarsened to {range} triangles: six elements in a wavelength, and more for short waves of the walls"
            ));
        }
        if cases.iter().any(|case| matches!(case.kind, CaseKind::Mode(_))) && !points.is_empty() {
            notes.push("modes have no sound pressure at points, because their amplitude is arbitrary".into());
        }
        let mut warnings = vibration.warnings.clone();
        if let Some((elements, frequency)) = self.coarse.filter(|(elements, _)| *elements < COARSE) {
            warnings.push(format!(
                "the surface has {elements:.1} elements in a wavelength at {frequency:.0} Hz, and six are needed for errors of some percent: refine its mesh, or leave out high frequencies"
            ));
        }
        let largest = |cases: &[CaseSound]| {
            let differences = cases.iter().map(|case| case.far_field_difference);
            differences.filter(|difference| difference.is_finite()).fold(0.0, f64::max)
        };
        let difference = largest(&cases);
        if difference > NOTABLE {
            warnings.push(format!(
                "the sound powers on the surface and in the far field differ by up to {:.0} %, because its elements are coarse for the waves of the walls, or because the motions of the walls nearly cancel each other: refine its mesh",
                1e2 * difference
            ));
        }
        SurfaceSound {
            method: *method,
            fluid: *fluid,
            surface: SurfaceOfSound {
                triangles: mesh.triangles().len(),
                coarse_triangles: [least, most],
                area: mesh.area(),
                edges,
                lids: self.closed.rims.len(),
            },
            points: points.clone(),
            cases,
            notes,
            warnings,
        }
    }
}
