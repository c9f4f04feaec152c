//! Forced response of a scene to its meshes over the speed: the vibration that the transmission
//! errors and the varying mesh stiffnesses excite.
//!
//! See `docs/theory/forced-response.md` and [`calyx_solve::forced_response`].

mod excitation;
mod quantities;
mod speeds;

use crate::radiated_sound::{RadiatedSound, SoundModels, SoundTask};
use calyx_model::bearing::damping as bearing_damping;
use calyx_model::fidelity::Fidelity;
use calyx_model::ids::PairId;
use calyx_model::mechanism::Mechanism;
use calyx_model::resources::Resources;
use calyx_numerics::error::{EngineError, Subject};
use calyx_solve::forced_response::sampling::Sampling;
use calyx_solve::forced_response::{Amplitudes, ForcedVibration, LinearQuantity, PeriodicSystem, unknowns};
use calyx_solve::system::System;
use excitation::Excitation;
use nalgebra::{Complex, DMatrix, DVector};
use quantities::{Sample, label, linear, measures, sample};
use rayon::prelude::*;
use speeds::Prepared;
use std::f64::consts::TAU;

/// Relative difference of the equilibrium after a period up to which it repeats, and of the mass
/// and damping matrices of its positions above which they vary.
const REPEATS: f64 = 1e-5;
/// Relative difference of the equilibrium after a period above which a warning states it.
const NOTABLE: f64 = 1e-4;
/// Relative difference of the equilibrium after a period above which it does not repeat.
const VARIES: f64 = 0.02;
/// Fraction of the period after which the damping matrix is compared.
const LATER: f64 = 0.31;
/// Fractions of the mesh cycle at which the equilibrium is compared until it repeats at one: where
/// a pair of teeth enters contact, it depends on rounding.
const PLACES: [f64; 4] = [0.11, 0.38, 0.59, 0.84];
/// Largest number of complex unknowns of a speed: about a second.
const LARGEST: usize = 10_000;
/// Multiple of the difference from half of the positions that is the estimated error. The
/// difference varies with the phase of the positions to the jumps of the stiffness.
const CAUTION: f64 = 2.0;
/// Growth of a disturbance within a mesh cycle above which a vibration is unstable: the spectral
/// radius is known to a thousandth.
const UNSTABLE: f64 = 1.002;
/// Largest number of ranges of speeds in a warning.
const RANGES: usize = 4;
/// Number of times by line at which the sign of a quantity is examined.
const SIGNS: usize = 32;
const GOLDEN_RATIO: f64 = 1.618_033_988_749_895;

/// Request for a forced response.
#[derive(Clone, Debug, PartialEq)]
pub struct ForcedResponseRequest {
    /// Mesh of which the speed of the first gear is the abscissa.
    pub mesh: PairId,
    /// Lowest and highest speed of this gear, rad/s.
    pub speeds: [f64; 2],
    /// Number of speeds at equal distances; at least two.
    pub count: usize,
    /// Number of harmonics of each mesh frequency; at least one.
    pub harmonics: usize,
    /// Damping ratio of all modes.
    pub damping_ratio: f64,
}

/// Forced response over the speed.
#[derive(Clone, Debug, PartialEq)]
pub struct ForcedResponse {
    /// Name of the gear whose speed is the abscissa.
    pub body: String,
    /// Spectral lines of all quantities, by ascending frequency from the mean value.
    pub lines: Vec<ResponseLine>,
    /// Natural frequencies of the mean stiffness without gyroscopic moments, Hz, ascending, up to
    /// six times the highest frequency of a line, with sound up to 15 times; empty if carriers
    /// rotate.
    pub natural_frequencies: Vec<f64>,
    /// Relative difference of the static equilibrium and of its stiffness a common period apart.
    pub difference: f64,
    /// Quantities.
    pub quantities: Vec<ResponseQuantity>,
    /// Response by speed.
    pub points: Vec<ForcedPoint>,
    /// Sound that elastic bodies radiate, by request.
    pub sounds: Vec<RadiatedSound>,
}

/// Spectral line of a forced response: a harmonic of a mesh frequency, or one of its sidebands.
#[derive(Clone, Debug, PartialEq)]
pub struct ResponseLine {
    /// Names of the gears of the first mesh with this frequency; empty for harmonic 0.
    pub mesh: String,
    /// Harmonic of the mesh frequency; 0 is the mean value and its sidebands.
    pub harmonic: usize,
    /// Name of the carrier or of the other mesh that modulates the harmonic; empty for sideband 0.
    pub modulation: String,
    /// Multiple of the carrier's rotational frequency or of the other mesh frequency that is added.
    pub sideband: i64,
    /// Frequency over the rotational frequency of the gear whose speed is the abscissa.
    pub order: f64,
}

/// Quantity of a forced response.
#[derive(Clone, Debug, PartialEq)]
pub struct ResponseQuantity {
    /// Name with its bodies, bearing or mesh.
    pub name: String,
    /// Unit of the SI.
    pub unit: &'static str,
    /// True for the torque of meshes that load a gear in one sense: its sign changes only if teeth
    /// separate.
    pub is_tooth_load: bool,
}

/// Forced response at a speed.
#[derive(Clone, Debug, PartialEq)]
pub struct ForcedPoint {
    /// Speed of the gear, rad/s.
    pub speed: f64,
    /// Complex amplitudes by quantity, then by line; the phase is zero at the start of the mesh
    /// cycle of the request. NaN at a resonance without damping.
    pub amplitudes: Vec<Amplitudes>,
    /// Estimated errors of the amplitudes: their difference from those of every second position.
    pub errors: Vec<Vec<f64>>,
    /// Factor by which a disturbance grows within a mesh cycle; above 1 the vibration is unstable.
    /// NaN if carriers rotate.
    pub growth: f64,
}

impl ForcedResponse {
    /// Returns warnings about the response, in sentences.
    pub fn warnings(&self) -> Vec<String> {
        let mut all = Vec::new();
        if self.difference > NOTABLE {
            all.push(format!(
                "the equilibrium differs by {:.2} % after a common period of all meshes, because something else varies, such as the places of rolling elements; the forced response does not contain this variation",
                1e2 * self.difference
            ));
        }
        if let Some(speeds) = self.ranges(ForcedPoint::is_unknown) {
            all.push(format!(
                "no forced response was found at {speeds} of \"{}\": an undamped resonance, or varying stiffness that makes the vibration grow; give a higher `damping_ratio`",
                self.body
            ));
        }
        if let Some(speeds) = self.ranges(|point| point.growth > UNSTABLE) {
            all.push(format!(
                "the varying stiffness of the teeth makes the vibration unstable at {speeds} of \"{}\": the forced response is not reached there, and teeth separate (column `growth` of forced_response.csv)",
                self.body
            ));
        }
        for (index, quantity) in
            self.quantities.iter().enumerate().filter(|(_, quantity)| quantity.is_tooth_load)
        {
            if let Some(speeds) = self.ranges(|point| point.separates(index, &self.lines)) {
                all.push(format!(
                    "teeth separate at {speeds} of \"{}\", because the vibration of {} exceeds its mean value; the forced response of teeth that remain in contact is not reached there",
                    self.body, quantity.name
                ));
            }
        }
        // Sounds of one body share warnings.
        for warning in self.sounds.iter().flat_map(RadiatedSound::warnings) {
            if !all.contains(&warning) {
                all.push(warning);
            }
        }
        all
    }

    /// Describes the ranges of speeds with a property; `None` if no speed has it.
    fn ranges(&self, has: impl Fn(&ForcedPoint) -> bool) -> Option<String> {
        let rpm = |point: &ForcedPoint| point.speed * 60.0 / TAU;
        let mut found: Vec<String> = Vec::new();
        for range in self.points.chunk_by(|one, other| has(one) == has(other)) {
            match range {
                [first, ..] if !has(first) => {}
                [only] => found.push(format!("{:.0}", rpm(only))),
                [first, .., last] => found.push(format!("{:.0} to {:.0}", rpm(first), rpm(last))),
                [] => {}
            }
        }
        let more = found.len().saturating_sub(RANGES);
        found.truncate(RANGES);
        let rest = if more > 0 { format!(" and {more} more ranges of rpm") } else { " rpm".into() };
        (!found.is_empty()).then(|| found.join(", ") + &rest)
    }
}

impl ForcedPoint {
    /// Takes the responses at a speed (rad/s) with all positions and with every second one.
    fn new(speed: f64, [fine, coarse]: [&[Amplitudes]; 2], growth: f64) -> ForcedPoint {
        let difference = |(fine, coarse): (&Amplitudes, &Amplitudes)| {
            fine.iter().zip(coarse).map(|(fine, coarse)| CAUTION * (fine - coarse).norm()).collect()
        };
        let errors = fine.iter().zip(coarse).map(difference).collect();
        ForcedPoint { speed, amplitudes: fine.to_vec(), errors, growth }
    }

    /// Returns whether the response is not known.
    fn is_unknown(&self) -> bool {
        self.amplitudes.iter().flatten().any(|amplitude| amplitude.re.is_nan())
    }

    /// Returns whether a quantity changes its sign.
    fn separates(&self, quantity: usize, lines: &[ResponseLine]) -> bool {
        let amplitudes = &self.amplitudes[quantity];
        let mean = amplitudes.first().map_or(0.0, |mean| mean.re);
        // Multiples of an irrational fraction of a cycle, which reach all phases of all lines.
        let lowest = lines.iter().map(|line| line.order).find(|&order| order > 0.0).unwrap_or(1.0);
        let variation = |time: f64| -> f64 {
            let terms = amplitudes.iter().zip(lines).skip(1);
            terms.map(|(value, line)| (value * Complex::from_polar(1.0, TAU * line.order * time)).re).sum()
        };
        let step = GOLDEN_RATIO.recip() / lowest;
        let mut times = (0..SIGNS * amplitudes.len()).map(|k| k as f64 * step);
        times.any(|time| mean.abs() + mean.signum() * variation(time) < 0.0)
    }

    /// Returns the root mean square of a quantity's variation about its mean.
    pub fn rms(&self, quantity: usize) -> f64 {
        self.amplitudes[quantity].iter().skip(1).map(|c| 0.5 * c.norm_sqr()).sum::<f64>().sqrt()
    }
}

/// Returns the highest frequency of a line over all speeds of a request and the speed of the scene,
/// Hz; infinite if the request is rejected.
pub(crate) fn highest_frequency(scene: &Mechanism, request: &ForcedResponseRequest) -> f64 {
    Excitation::new(scene, request).map_or(f64::INFINITY, |excitation| {
        let highest = excitation.orders.lines().map(|(order, _)| order).max().unwrap_or(0);
        let ratio = (request.speeds[1] / excitation.speed).max(1.0);
        highest as f64 * ratio / excitation.period
    })
}

/// Returns the lowest frequency of a line at the speed of the scene, Hz; zero if the request is
/// rejected.
pub(crate) fn lowest_frequency(scene: &Mechanism, request: &ForcedResponseRequest) -> f64 {
    Excitation::new(scene, request).map_or(0.0, |excitation| {
        let orders = excitation.orders.lines().map(|(order, _)| order).filter(|order| *order > 0);
        orders.min().map_or(0.0, |lowest| lowest as f64 / excitation.period)
    })
}

/// Checks that a scene can have a forced response at a fidelity level with component modes up to a
/// frequency (Hz), and this number of DOFs.
///
/// # Errors
/// E0774: nothing vibrates. Also those of [`Excitation::new`].
pub(crate) fn check(
    scene: &Mechanism,
    request: &ForcedResponseRequest,
    (fidelity, highest_frequency): (Fidelity, f64),
    dofs: usize,
) -> Result<(), EngineError> {
    let refused = |message: &str, help: &str| EngineError::new("E0774", message, help);
    if fidelity == Fidelity::Rigid {
        let help = "choose a fidelity level with elastic teeth, such as \"analytic\", or remove `gears.forced_response`";
        return Err(refused("rigid teeth have no forced response", help).blame("fidelity"));
    }
    if fidelity == Fidelity::Plane && highest_frequency > 0.0 {
        let help = "set `highest_frequency = 0 Hz`";
        let message = "a forced response does not support the component modes of gears";
        return Err(refused(message, help).blame("highest_frequency"));
    }
    if dofs == 0 {
        let help = "free a body in the directions in which it vibrates (`free`), or give the gears shafts and bearings";
        let error = refused("nothing vibrates: no body has a free degree of freedom", help);
        return Err(error.about(Subject::ForcedResponse));
    }
    Excitation::new(scene, request).map(drop)
}

/// Returns the number of positions that a forced response solves, for the prediction of the time;
/// zero if it is rejected.
pub(crate) fn position_count(scene: &Mechanism, request: &ForcedResponseRequest) -> usize {
    Excitation::new(scene, request).map_or(0, |excitation| excitation.sampling.count() + 2)
}

/// Computes the requested forced response and its sound.
///
/// # Errors
/// E0774: the equilibrium does not repeat, a matrix is not finite or varies, or the problem is too
/// large. Also those of a position and of the sound.
pub(crate) fn forced_response(
    system: &System<'_>,
    scene: &Mechanism,
    request: &ForcedResponseRequest,
    task: &SoundTask<'_>,
    resources: &Resources,
) -> Result<ForcedResponse, EngineError> {
    let found = solved(system, scene, request, task, resources);
    // Vibrations that an interruption ends are missing, as those of a singular system are.
    resources.interrupt.check()?;
    found
}

fn solved(
    system: &System<'_>,
    scene: &Mechanism,
    request: &ForcedResponseRequest,
    task: &SoundTask<'_>,
    resources: &Resources,
) -> Result<ForcedResponse, EngineError> {
    let sound = match task.requests.is_empty() {
        true => None,
        false => Some(SoundModels::new(system, task, highest_frequency(scene, request), resources)?),
    };
    let pair = &scene.pairs[request.mesh.0];
    let mesh = pair.mesh.as_ref().ok_or_else(singular)?;
    let excitation = Excitation::new(scene, request)?;
    let measures = measures(system, scene);
    let frequency = TAU / excitation.period;
    let own = excitation.speed;
    let highest = request.speeds[1] / own;
    // Sound is that of the speed of the model, too.
    let highest = if sound.is_some() { highest.max(1.0) } else { highest };
    let sampling = &excitation.sampling;
    let solve = |time: f64| -> Result<Sample, EngineError> {
        resources.interrupt.check()?;
        sample(system, &system.solve(time)?, &measures).ok_or_else(singular)
    };
    let compared = PLACES.map(|place| mesh.start + place * mesh.period);
    let (first, difference) = most_repeating(&solve, compared, excitation.period)?;
    let gyroscopic = system.gyroscopic_matrix(compared[0]);
    let damping = damping(system, compared[0])?;
    check_damping(&damping, &self::damping(system, compared[0] + LATER * excitation.period)?)?;
    let periodic = |used: &[&Sample], sampling: &Sampling| PeriodicSystem {
        mass: first.mass.clone(),
        gyroscopic: gyroscopic.clone(),
        damping: damping.clone(),
        stiffness: used.iter().map(|sample| sample.stiffness.clone()).collect(),
        statics: used.iter().map(|sample| sample.statics.clone()).collect(),
        orders: excitation.orders.clone(),
        sampling: sampling.clone(),
        frequency,
        damping_ratio: request.damping_ratio,
    };
    let unknowns = unknowns(&periodic(&[&first], sampling), highest, sound.is_some()).ok_or_else(singular)?;
    if unknowns > LARGEST {
        let message = format!(
            "the forced response has {unknowns} unknowns by mode and spectral line, and at most {LARGEST} are possible"
        );
        let help = "give fewer `harmonics`, a lower `highest_speed`, or a lower `highest_frequency` of the component modes";
        return Err(EngineError::new("E0774", message, help).about(Subject::ForcedResponse));
    }
    // Off the start of the cycle, where the stiffness jumps.
    let time = |k: usize| mesh.start + excitation.period * (sampling.place(k) + sampling.half_step());
    let positions = (0..sampling.count()).into_par_iter();
    let all = || positions.map(|k| solve(time(k))).collect::<Result<Vec<Sample>, _>>();
    let samples = resources.install(all)?;
    check_mass(&first, &samples)?;
    let prepared = |sampling: &Sampling, used: &[usize]| {
        let used: Vec<&Sample> = used.iter().map(|&index| &samples[index]).collect();
        let quantities: Vec<LinearQuantity> =
            (0..measures.len()).map(|k| linear(&used, measures[k], k)).collect();
        speeds::vibration(&periodic(&used, sampling), &quantities, (highest, sound.is_some()))
    };
    let (coarse, kept) = sampling.every_second();
    let every: Vec<usize> = (0..sampling.count()).collect();
    let orders = excitation.orders.lines().map(|(order, _)| order as f64);
    let lines = lines(&excitation, frequency / own);
    let prepared = Prepared {
        vibrations: [prepared(sampling, &every)?, prepared(&coarse, &kept)?],
        phases: orders.map(|order| TAU * order * sampling.half_step()).collect(),
        lines: &lines,
        measures: &measures,
        own,
    };
    let [lowest, highest] = request.speeds;
    let speed = |k: usize| lowest + (highest - lowest) * (k as f64 / (request.count - 1).max(1) as f64);
    let speeds: Vec<f64> = (0..request.count).map(speed).collect();
    let (points, sounds) = prepared.solve(system, speeds, (sound, task), resources)?;
    let natural_frequencies = natural_frequencies(&prepared.vibrations[0]);
    Ok(ForcedResponse {
        body: scene.bodies[pair.bodies[0].0].name.clone(),
        lines,
        natural_frequencies,
        difference,
        quantities: measures.iter().map(|measure| label(system, scene, *measure)).collect(),
        points,
        sounds,
    })
}

/// Returns the sample that repeats best after a period among those at some times, and its relative
/// difference from the one a period later.
///
/// # Errors
/// E0774: no sample repeats. Also those of a position.
fn most_repeating(
    solve: &impl Fn(f64) -> Result<Sample, EngineError>,
    times: [f64; 4],
    period: f64,
) -> Result<(Sample, f64), EngineError> {
    let mut first = solve(times[0])?;
    let mut difference = difference(&first, &solve(times[0] + period)?);
    for &time in &times[1..] {
        if difference <= REPEATS {
            break;
        }
        let state = solve(time)?;
        let own = self::difference(&state, &solve(time + period)?);
        if own < difference {
            (first, difference) = (state, own);
        }
    }
    if difference <= VARIES {
        return Ok((first, difference));
    }
    let message = format!(
        "the equilibrium differs by {:.1} % after a common period of all meshes, so the forced response is not periodic",
        1e2 * difference
    );
    let help = "a forced response needs equal teeth, concentric gears and constant loads; use time integration for other models";
    Err(EngineError::new("E0774", message, help).about(Subject::ForcedResponse))
}

/// Returns the natural frequencies, Hz. With carriers that rotate, the mean stiffness along ground
/// axes has no meaning.
fn natural_frequencies(vibration: &ForcedVibration) -> Vec<f64> {
    match vibration.rotates() {
        true => Vec::new(),
        false => vibration.natural_frequencies().iter().map(|own| own / TAU).collect(),
    }
}

fn singular() -> EngineError {
    let message = "the forced response has no solution: mass or stiffness matrix are singular or not finite";
    EngineError::new("E0774", message, "check masses, loads and frames of the bodies")
}

/// Returns the lines of the response; `order` is the frequency of the period over the rotational
/// frequency of the gear whose speed is the abscissa.
fn lines(excitation: &Excitation, order: f64) -> Vec<ResponseLine> {
    let line = |(multiple, line)| {
        let [mesh, modulation] = excitation.names(line);
        let (harmonic, sideband) = (line.harmonic, line.sideband);
        ResponseLine { mesh, harmonic, modulation, sideband, order: multiple as f64 * order }
    };
    excitation.orders.lines().map(line).collect()
}

/// Returns the square roots of the inertia of each coordinate, which make metres and radians
/// comparable.
fn roots(mass: &DMatrix<f64>) -> DVector<f64> {
    DVector::from_fn(mass.nrows(), |k, _| mass[(k, k)].sqrt())
}

/// Returns the largest difference of two matrices relative to the first one, in coordinates of unit
/// inertia.
fn relative_difference(one: &DMatrix<f64>, other: &DMatrix<f64>, root: &DVector<f64>) -> f64 {
    let scaled = |matrix: &DMatrix<f64>| {
        DMatrix::from_fn(root.len(), root.len(), |i, j| matrix[(i, j)] / (root[i] * root[j]))
    };
    (scaled(one) - scaled(other)).amax() / scaled(one).amax()
}

/// Returns the relative difference of the stiffness and the static equilibrium a period apart.
fn difference(first: &Sample, again: &Sample) -> f64 {
    let root = roots(&first.mass);
    let moved = |statics: &DVector<f64>| statics.component_mul(&root);
    let of_motion = (moved(&first.statics) - moved(&again.statics)).amax() / moved(&first.statics).amax();
    relative_difference(&first.stiffness, &again.stiffness, &root).max(of_motion)
}

/// Checks that the mass matrix is that of the first position at all others.
fn check_mass(first: &Sample, samples: &[Sample]) -> Result<(), EngineError> {
    let root = roots(&first.mass);
    if samples.iter().all(|sample| relative_difference(&first.mass, &sample.mass, &root) <= REPEATS) {
        return Ok(());
    }
    let message = "the mass matrix varies as the bodies rotate, so the forced response is not periodic";
    let help =
        "give bodies their centre of mass on the axis of rotation and equal moments of inertia across it";
    Err(EngineError::new("E0774", message, help).about(Subject::ForcedResponse))
}

/// Checks that the damping matrix at a later time is that of the first position.
fn check_damping(first: &DMatrix<f64>, later: &DMatrix<f64>) -> Result<(), EngineError> {
    if (first - later).amax() <= REPEATS * first.amax() {
        return Ok(());
    }
    let message =
        "the damping of a bearing rotates with its carrier, and a forced response needs constant damping";
    let help = "give this bearing equal damping in all radial directions, or none";
    Err(EngineError::new("E0774", message, help).about(Subject::ForcedResponse))
}

/// Returns the damping matrix of the bearings in all coordinates, N s/m and N m s/rad.
fn damping(system: &System<'_>, time: f64) -> Result<DMatrix<f64>, EngineError> {
    let scene = system.scene;
    let (dofs, all) = (system.dofs.len(), system.dofs.len() + system.mode_count());
    let found =
        bearing_damping(&scene.bodies, &scene.bearings, &system.bearings, &system.dofs, |_| 1.0, time)?;
    Ok(DMatrix::from_fn(all, all, |i, j| if i.max(j) < dofs { found[i * dofs + j] } else { 0.0 }))
}
