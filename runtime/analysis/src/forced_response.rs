//! Forced response of a scene to its meshes over the speed: the vibration that the transmission
//! error and the varying mesh stiffness of a mesh cycle excite.
//!
//! See `docs/theory/forced-response.md` and [`calyx_solve::forced_response`].

use crate::observables::{BearingStiffness, Equilibrium, Observable, TransmissionError};
use crate::scene::Scene;
use calyx_model::bearing::{BearingState, damping as bearing_damping};
use calyx_model::dof::{DOF_NAMES, Dof};
use calyx_model::ids::{BearingId, BodyId, PairId};
use calyx_model::resources::Resources;
use calyx_numerics::error::EngineError;
use calyx_numerics::vec3::dot;
use calyx_solve::forced_response::{
    ForcedVibration, Harmonics, LinearQuantity, PeriodicSystem, sample_count,
};
use calyx_solve::step::StepResult;
use calyx_solve::system::System;
use nalgebra::{Complex, DMatrix, DVector};
use rayon::prelude::*;
use std::f64::consts::TAU;

const THETA_Z: usize = 5;
/// Relative difference of the equilibrium after a mesh cycle above which it does not repeat.
const REPEATS: f64 = 1e-5;
/// Largest number of complex unknowns of a speed: 400 MB, and about ten seconds.
const LARGEST: usize = 5000;

/// Request for a forced response.
#[derive(Clone, Debug, PartialEq)]
pub struct ForcedResponseRequest {
    /// Mesh whose cycle is the period. The speed of its first gear is the abscissa.
    pub mesh: PairId,
    /// Lowest and highest speed of this gear, rad/s.
    pub speeds: [f64; 2],
    /// Number of speeds at equal distances; at least two.
    pub count: usize,
    /// Number of harmonics of the mesh frequency; at least one.
    pub harmonics: usize,
    /// Damping ratio of all modes.
    pub damping_ratio: f64,
}

/// Forced response over the speed.
#[derive(Clone, Debug, PartialEq)]
pub struct ForcedResponse {
    /// Name of the gear whose speed is the abscissa.
    pub body: String,
    /// Mesh frequency over the rotational frequency of this gear.
    pub order: f64,
    /// Quantities: name and unit.
    pub quantities: Vec<(String, &'static str)>,
    /// Response by speed.
    pub points: Vec<ForcedPoint>,
}

/// Forced response at a speed.
#[derive(Clone, Debug, PartialEq)]
pub struct ForcedPoint {
    /// Speed of the gear, rad/s.
    pub speed: f64,
    /// Complex amplitudes by quantity, then by harmonic of the mesh frequency, from the mean value;
    /// the phase is zero at the start of the mesh cycle. NaN at a resonance without damping.
    pub amplitudes: Vec<Harmonics>,
    /// Estimated errors of the amplitudes: their difference from those of every second position.
    pub errors: Vec<Vec<f64>>,
    /// Factor by which a disturbance grows within a mesh cycle; above 1 the vibration is unstable.
    pub growth: f64,
}

/// Growth of a disturbance within a mesh cycle above which a vibration is unstable.
const UNSTABLE: f64 = 1.002;

impl ForcedResponse {
    /// Returns warnings about the response, in sentences.
    pub fn warnings(&self) -> Vec<String> {
        let unstable = || self.points.iter().filter(|point| point.growth > UNSTABLE);
        let rpm = |point: &ForcedPoint| point.speed * 60.0 / TAU;
        match (unstable().next(), unstable().next_back()) {
            (Some(first), Some(last)) => vec![format!(
                "the varying stiffness of the teeth makes the vibration unstable at {} of {} speeds between {:.0} and {:.0} rpm of \"{}\": there the forced response is not reached, and teeth separate (column `growth` of forced_response.csv)",
                unstable().count(),
                self.points.len(),
                rpm(first),
                rpm(last),
                self.body
            )],
            _ => Vec::new(),
        }
    }
}

impl ForcedPoint {
    /// Solves at a speed (rad/s) and its ratio to the reference speed, with all positions and with
    /// every second one.
    fn new(speed: f64, [fine, coarse]: [&ForcedVibration; 2], ratio: f64) -> ForcedPoint {
        let nothing = |harmonics: &Harmonics| vec![Complex::new(f64::NAN, f64::NAN); harmonics.len()];
        let at = |vibration: &ForcedVibration| {
            vibration.at(ratio).unwrap_or_else(|| vibration.static_values().iter().map(nothing).collect())
        };
        let (amplitudes, coarse) = (at(fine), at(coarse));
        let difference = |(fine, coarse): (&Harmonics, &Harmonics)| {
            fine.iter().zip(coarse).map(|(fine, coarse)| (fine - coarse).norm()).collect()
        };
        let errors = amplitudes.iter().zip(&coarse).map(difference).collect();
        ForcedPoint { speed, amplitudes, errors, growth: fine.growth(ratio) }
    }

    /// Returns the root mean square of a quantity's variation about its mean.
    pub fn rms(&self, quantity: usize) -> f64 {
        self.amplitudes[quantity].iter().skip(1).map(|c| 0.5 * c.norm_sqr()).sum::<f64>().sqrt()
    }
}

/// State of one position of the cycle.
struct Sample {
    stiffness: DMatrix<f64>,
    mass: DMatrix<f64>,
    statics: DVector<f64>,
    quantities: Vec<State>,
}

/// Static value of a quantity, and its derivatives by all coordinates and by their rates.
struct State {
    value: f64,
    row: DVector<f64>,
    rate: Option<DVector<f64>>,
}

/// Quantity of the response.
#[derive(Clone, Copy)]
enum Measure {
    TransmissionError(PairId),
    /// Moment of all tooth contacts of a body about its axis.
    ToothTorque(BodyId, usize),
    /// Force of a bearing on the body of its first race along one of the bearing's axes.
    BearingForce(BearingId, usize),
    Motion(usize),
}

/// Computes the requested forced response; `None` for rigid bodies, which do not vibrate.
///
/// # Errors
/// E0774: the equilibrium does not repeat after a mesh cycle, or the problem is too large. Also those
/// of a position.
pub(crate) fn forced_response(
    system: &System<'_>,
    scene: &Scene,
    request: &ForcedResponseRequest,
    resources: &Resources,
) -> Result<Option<ForcedResponse>, EngineError> {
    let pair = &scene.pairs[request.mesh.0];
    let Some(mesh) = pair.mesh.as_ref().filter(|_| !system.rigid) else { return Ok(None) };
    let measures = measures(system, scene);
    // Every second position gives the error estimate.
    let count = 2 * sample_count(request.harmonics);
    let time = |k: usize| mesh.start + mesh.period * (k as f64 / count as f64);
    let solve = |k: usize| -> Result<Option<Sample>, EngineError> {
        resources.interrupt.check()?;
        let step = system.solve(time(k))?;
        Ok(sample(system, &step, &measures))
    };
    // The last sample is one period after the first.
    let all = || (0..=count).into_par_iter().map(solve).collect::<Result<Option<Vec<Sample>>, _>>();
    let Some(mut samples) = resources.install(all)? else { return Ok(None) };
    let (Some(again), Some(first)) = (samples.pop(), samples.first()) else { return Ok(None) };
    if !repeats(first, &again) {
        let message =
            "the equilibrium does not repeat after a mesh cycle, so its forced response is not periodic";
        let help = "a forced response needs axes at rest, equal teeth, and one mesh frequency for all meshes; use time integration, or leave out the other meshes";
        return Err(EngineError::new("E0774", message, help));
    }
    let frequency = TAU / mesh.period;
    let own = frequency / f64::from(mesh.teeth[0]);
    let gyroscopic = system.gyroscopic_matrix(mesh.start);
    let damping = damping(system, mesh.start)?;
    let [lowest, highest] = request.speeds;
    let prepared = |stride: usize| {
        let used: Vec<&Sample> = samples.iter().step_by(stride).collect();
        let periodic = PeriodicSystem {
            mass: first.mass.clone(),
            gyroscopic: gyroscopic.clone(),
            damping: damping.clone(),
            stiffness: used.iter().map(|sample| sample.stiffness.clone()).collect(),
            statics: used.iter().map(|sample| sample.statics.clone()).collect(),
            frequency,
            damping_ratio: request.damping_ratio,
        };
        let quantities: Vec<LinearQuantity> =
            (0..measures.len()).map(|k| linear(&used, measures[k], k)).collect();
        ForcedVibration::new(&periodic, &quantities, request.harmonics, highest / own)
    };
    let (Some(fine), Some(coarse)) = (prepared(1), prepared(2)) else { return Ok(None) };
    if fine.unknowns() > LARGEST {
        let message = format!(
            "the forced response has {} unknowns by mode and harmonic, and at most {LARGEST} are possible",
            fine.unknowns()
        );
        let help = "give fewer `harmonics`, a lower `highest_speed`, or a lower `highest_frequency` of the component modes";
        return Err(EngineError::new("E0774", message, help));
    }
    let speed = |k: usize| lowest + (highest - lowest) * (k as f64 / (request.count - 1).max(1) as f64);
    let point = |k: usize| -> Result<ForcedPoint, EngineError> {
        resources.interrupt.check()?;
        Ok(ForcedPoint::new(speed(k), [&fine, &coarse], speed(k) / own))
    };
    let all = || (0..request.count).into_par_iter().map(point).collect::<Result<Vec<_>, _>>();
    Ok(Some(ForcedResponse {
        body: scene.bodies[pair.bodies[0].0].name.clone(),
        order: f64::from(mesh.teeth[0]),
        quantities: measures.iter().map(|measure| label(system, scene, *measure)).collect(),
        points: resources.install(all)?,
    }))
}

/// Returns a quantity over the samples; only its static value and contact vary.
fn linear(samples: &[&Sample], measure: Measure, index: usize) -> LinearQuantity {
    let states = || samples.iter().map(|sample| &sample.quantities[index]);
    let count = match measure {
        Measure::ToothTorque(..) | Measure::BearingForce(..) => samples.len(),
        Measure::TransmissionError(_) | Measure::Motion(_) => 1,
    };
    LinearQuantity {
        statics: states().map(|state| state.value).collect(),
        rows: states().take(count).map(|state| state.row.clone()).collect(),
        rate: states().next().and_then(|state| state.rate.clone()),
    }
}

/// Returns true if the equilibrium after a cycle is that at its start.
fn repeats(first: &Sample, again: &Sample) -> bool {
    let equal = |a: &DMatrix<f64>, b: &DMatrix<f64>| (a - b).amax() <= REPEATS * a.amax();
    equal(&first.stiffness, &again.stiffness)
        && equal(&first.mass, &again.mass)
        && (&first.statics - &again.statics).amax() <= REPEATS * first.statics.amax()
}

/// Returns the quantities of a response: transmission errors of meshes, tooth torques of gears that
/// rotate freely about their axes, and motions of all degrees of freedom.
fn measures(system: &System<'_>, scene: &Scene) -> Vec<Measure> {
    let meshes =
        scene.pairs.iter().enumerate().filter(|(_, pair)| pair.mesh.is_some() && pair.front.is_none());
    let mut found: Vec<Measure> =
        meshes.clone().map(|(index, _)| Measure::TransmissionError(PairId(index))).collect();
    let rotation = |body: BodyId| {
        let own = Dof { body: body.0, component: THETA_Z };
        system.dofs.iter().position(|dof| *dof == own)
    };
    let geared = |body: &BodyId| meshes.clone().any(|(_, pair)| pair.bodies.contains(body));
    let bodies = (0..scene.bodies.len()).map(BodyId).filter(geared);
    found.extend(bodies.filter_map(|body| Some(Measure::ToothTorque(body, rotation(body)?))));
    // The force of a stop is not a linear function of the motion.
    let linear = system.bearings.iter().filter(|&&bearing| scene.bearings[bearing].walls() == 0);
    found.extend(
        linear.flat_map(|&bearing| (0..3).map(move |axis| Measure::BearingForce(BearingId(bearing), axis))),
    );
    found.extend((0..system.dofs.len()).map(Measure::Motion));
    found
}

/// Returns the name and the unit of a quantity.
fn label(system: &System<'_>, scene: &Scene, measure: Measure) -> (String, &'static str) {
    let name = |body: BodyId| &scene.bodies[body.0].name;
    match measure {
        Measure::TransmissionError(pair) => {
            let [first, second] = scene.pairs[pair.0].bodies.map(name);
            (format!("transmission_error({first}, {second})"), "rad")
        }
        Measure::ToothTorque(body, _) => (format!("tooth_torque({})", name(body)), "N*m"),
        Measure::BearingForce(bearing, axis) => {
            let axis = ["x", "y", "z"][axis];
            (format!("bearing_force_{axis}({})", scene.bearings[bearing.0].name), "N")
        }
        Measure::Motion(dof) => {
            let dof = &system.dofs[dof];
            let unit = if dof.component < 3 { "m" } else { "rad" };
            (format!("{}({})", DOF_NAMES[dof.component], name(BodyId(dof.body))), unit)
        }
    }
}

/// Returns the state of a solved position; `None` if nothing vibrates.
fn sample(system: &System<'_>, step: &StepResult, measures: &[Measure]) -> Option<Sample> {
    let vibrations = system.vibrations(step)?;
    let at = Equilibrium::new(system, step);
    let coordinates = vibrations.stiffness.nrows();
    let known = step.motion.iter().chain(&step.modal).copied();
    // Component modes of elastic bodies do not move in static equilibrium.
    let statics = DVector::from_iterator(coordinates, known.chain(std::iter::repeat(0.0)).take(coordinates));
    let springs = system.spring_stiffness(step)?;
    let quantity = |measure: &Measure| {
        let mut row = DVector::zeros(coordinates);
        let mut rate = None;
        let value = match *measure {
            Measure::TransmissionError(pair) => {
                let (mesh, [first, second]) = at.mesh(pair)?;
                let ratio = f64::from(mesh.teeth[0]) / f64::from(mesh.teeth[1]);
                for (body, factor) in [(first, ratio), (second, mesh.sign)] {
                    let own = Dof { body: body.0, component: THETA_Z };
                    if let Some(dof) = system.dofs.iter().position(|dof| *dof == own) {
                        row[dof] = mesh.drive_sense * factor;
                    }
                }
                TransmissionError(pair).value(&at).value
            }
            Measure::ToothTorque(body, dof) => {
                for column in 0..coordinates {
                    row[column] = springs[(dof, column)] - vibrations.stiffness[(dof, column)];
                }
                let [_, _, _, x, y, z] = at.contact_force(body);
                dot(system.axes(body.0, step.time)[2], [x, y, z])
            }
            Measure::BearingForce(bearing, axis) => {
                let own = system.scene.bearings.get(bearing.0)?;
                let placed = BearingState::at(&system.scene.bodies, own, step.time).ok()?;
                let mut damped = DVector::zeros(coordinates);
                for column in 0..6 {
                    let stiffness = BearingStiffness { bearing, row: axis, column }.value(&at).value;
                    for (dof, on) in system.dofs.iter().enumerate() {
                        let deflection = placed.deflection(on)[column];
                        row[dof] -= stiffness * deflection;
                        damped[dof] -= own.damping[axis][column] * deflection;
                    }
                }
                rate = Some(damped);
                at.bearing(bearing)?.push[axis]
            }
            Measure::Motion(dof) => {
                row[dof] = 1.0;
                step.motion[dof]
            }
        };
        Some(State { value, row, rate })
    };
    Some(Sample {
        stiffness: vibrations.stiffness.clone(),
        mass: vibrations.mass.clone(),
        statics,
        quantities: measures.iter().map(quantity).collect::<Option<_>>()?,
    })
}

/// Returns the damping matrix of the bearings in all coordinates, N s/m and N m s/rad.
fn damping(system: &System<'_>, time: f64) -> Result<DMatrix<f64>, EngineError> {
    let scene = system.scene;
    let (dofs, all) = (system.dofs.len(), system.dofs.len() + system.mode_count());
    let found =
        bearing_damping(&scene.bodies, &scene.bearings, &system.bearings, &system.dofs, |_| 1.0, time)?;
    Ok(DMatrix::from_fn(all, all, |i, j| if i.max(j) < dofs { found[i * dofs + j] } else { 0.0 }))
}
