//! Forced response of a scene to its meshes over the speed: the vibration that the transmission
//! error and the varying mesh stiffness of a mesh cycle excite.
//!
//! See `docs/theory/forced-response.md` and [`calyx_solve::forced_response`].

use crate::observables::{BearingStiffness, Equilibrium, Observable, TransmissionError};
use calyx_model::bearing::{BearingState, damping as bearing_damping};
use calyx_model::dof::{DOF_NAMES, Dof};
use calyx_model::fidelity::Fidelity;
use calyx_model::ids::{BearingId, BodyId, PairId};
use calyx_model::mechanism::Mechanism;
use calyx_model::resources::Resources;
use calyx_numerics::error::EngineError;
use calyx_numerics::vec3::dot;
use calyx_solve::forced_response::{
    ForcedVibration, Harmonics, LinearQuantity, PeriodicSystem, sample_count, unknowns,
};
use calyx_solve::step::StepResult;
use calyx_solve::system::System;
use nalgebra::{Complex, DMatrix, DVector};
use rayon::prelude::*;
use std::f64::consts::TAU;

const THETA_Z: usize = 5;
/// Relative difference of the equilibrium after a mesh cycle above which it does not repeat.
const REPEATS: f64 = 1e-5;
/// Relative difference of mesh periods that counts as rounding.
const SAME_PERIOD: f64 = 1e-9;
/// Largest number of complex unknowns of a speed: 150 MB, and some seconds.
const LARGEST: usize = 3000;
/// Smallest number of positions of a mesh cycle.
const POSITIONS: usize = 128;
/// Multiple of the difference from half of the positions that is the estimated error. The
/// difference varies with the phase of the positions to the jumps of the stiffness.
const CAUTION: f64 = 2.0;
/// Growth of a disturbance within a mesh cycle above which a vibration is unstable: the spectral
/// radius is known to a thousandth.
const UNSTABLE: f64 = 1.002;
/// Largest number of ranges of speeds in a warning.
const RANGES: usize = 4;

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
    /// Quantities.
    pub quantities: Vec<ResponseQuantity>,
    /// Response by speed.
    pub points: Vec<ForcedPoint>,
}

/// Quantity of a forced response.
#[derive(Clone, Debug, PartialEq)]
pub struct ResponseQuantity {
    /// Name with its bodies, bearing or mesh.
    pub name: String,
    /// Unit of the SI.
    pub unit: &'static str,
    /// True for the torque of a single mesh, whose sign changes only if teeth separate.
    pub is_tooth_load: bool,
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

impl ForcedResponse {
    /// Returns warnings about the response, in sentences.
    pub fn warnings(&self) -> Vec<String> {
        let mut all = Vec::new();
        if let Some(speeds) = self.ranges(|point| point.growth > UNSTABLE) {
            all.push(format!(
                "the varying stiffness of the teeth makes the vibration unstable at {speeds} of \"{}\": the forced response is not reached there, and teeth separate (column `growth` of forced_response.csv)",
                self.body
            ));
        }
        for (index, quantity) in
            self.quantities.iter().enumerate().filter(|(_, quantity)| quantity.is_tooth_load)
        {
            if let Some(speeds) = self.ranges(|point| point.separates(index)) {
                all.push(format!(
                    "teeth separate at {speeds} of \"{}\", because the amplitude of {} exceeds its mean value; the forced response of teeth that remain in contact is not reached there",
                    self.body, quantity.name
                ));
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
    /// Solves at a speed (rad/s) and its ratio to the reference speed, with all positions and with
    /// every second one. `phase` is that of the first position in the cycle, from 0 to 1.
    fn new(speed: f64, [fine, coarse]: &[ForcedVibration; 2], ratio: f64, phase: f64) -> ForcedPoint {
        let nothing = |harmonics: &Harmonics| vec![Complex::new(f64::NAN, f64::NAN); harmonics.len()];
        let at = |vibration: &ForcedVibration| {
            let found = vibration.at(ratio);
            let mut found = found.unwrap_or_else(|| vibration.static_values().iter().map(nothing).collect());
            for (harmonic, value) in found.iter_mut().flat_map(|values| values.iter_mut().enumerate()) {
                *value *= Complex::from_polar(1.0, -TAU * harmonic as f64 * phase);
            }
            found
        };
        let (amplitudes, coarse) = (at(fine), at(coarse));
        let difference = |(fine, coarse): (&Harmonics, &Harmonics)| {
            fine.iter().zip(coarse).map(|(fine, coarse)| CAUTION * (fine - coarse).norm()).collect()
        };
        let errors = amplitudes.iter().zip(&coarse).map(difference).collect();
        ForcedPoint { speed, amplitudes, errors, growth: fine.growth(ratio) }
    }

    /// Returns whether a quantity changes its sign within the mesh cycle.
    fn separates(&self, quantity: usize) -> bool {
        let amplitudes = &self.amplitudes[quantity];
        let mean = amplitudes.first().map_or(0.0, |mean| mean.re);
        let variation = |phase: f64| -> f64 {
            let terms = amplitudes.iter().enumerate().skip(1);
            terms.map(|(h, value)| (value * Complex::from_polar(1.0, TAU * h as f64 * phase)).re).sum()
        };
        let count = 8 * amplitudes.len();
        (0..count).any(|k| mean.abs() + mean.signum() * variation(k as f64 / count as f64) < 0.0)
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
    /// Force or moment of a bearing on the body of its first race along one of the bearing's axes.
    BearingForce(BearingId, usize),
    Motion(usize),
}

/// Checks that a scene can have a forced response at a fidelity level with component modes up to a
/// frequency (Hz), and this number of DOFs.
///
/// # Errors
/// E0774: nothing vibrates, or the equilibrium cannot repeat after a mesh cycle.
pub(crate) fn check(
    scene: &Mechanism,
    request: &ForcedResponseRequest,
    (fidelity, highest_frequency): (Fidelity, f64),
    dofs: usize,
) -> Result<(), EngineError> {
    let refused = |message: String, help: &str| Err(EngineError::new("E0774", message, help));
    if fidelity == Fidelity::Rigid {
        let help = "choose a fidelity level with elastic teeth, such as \"analytic\", or remove `gears.forced_response`";
        return refused("rigid teeth have no forced response".into(), help);
    }
    if fidelity == Fidelity::Plane && highest_frequency > 0.0 {
        let help = "set `highest_frequency = 0 Hz`";
        return refused("a forced response does not support the component modes of gears".into(), help);
    }
    if dofs == 0 {
        let help = "free a body in the directions in which it vibrates (`free`), or give the gears shafts and bearings";
        return refused("nothing vibrates: no body has a free degree of freedom".into(), help);
    }
    let Some(own) = scene.pairs[request.mesh.0].mesh.as_ref() else {
        return refused("the mesh of the forced response has no gears".into(), "give a mesh of two gears");
    };
    for pair in scene.pairs.iter().filter(|pair| pair.front.is_none()) {
        let Some(mesh) = &pair.mesh else { continue };
        let [first, second] = pair.bodies.map(|body| &scene.bodies[body.0].name);
        if mesh.carrier != [0.0; 3] {
            let message = format!(
                "the axes of \"{first}\" and \"{second}\" move, so the forced response is not periodic"
            );
            return refused(message, "use time integration at the fidelity level \"plane\"");
        }
        if (mesh.period / own.period - 1.0).abs() > SAME_PERIOD {
            let message = format!(
                "the mesh of \"{first}\" and \"{second}\" has the frequency {:.6} Hz, and that of the forced response {:.6} Hz",
                mesh.period.recip(),
                own.period.recip()
            );
            return refused(message, "model the other mesh by its forces, or use time integration");
        }
    }
    Ok(())
}

/// Computes the requested forced response.
///
/// # Errors E0774: the equilibrium does not repeat after a mesh cycle, a matrix is not finite, or
/// the problem is too large. Also those of a position.
pub(crate) fn forced_response(
    system: &System<'_>,
    scene: &Mechanism,
    request: &ForcedResponseRequest,
    resources: &Resources,
) -> Result<ForcedResponse, EngineError> {
    let singular = || {
        let message =
            "the forced response has no solution: mass or stiffness matrix are singular or not finite";
        EngineError::new("E0774", message, "check masses, loads and frames of the bodies")
    };
    let pair = &scene.pairs[request.mesh.0];
    let mesh = pair.mesh.as_ref().ok_or_else(singular)?;
    let measures = measures(system, scene);
    let frequency = TAU / mesh.period;
    let own = frequency / f64::from(mesh.teeth[0]);
    let highest = request.speeds[1] / own;
    // Every second position gives the error estimate.
    let count = (2 * sample_count(request.harmonics)).max(POSITIONS);
    // Positions off the start of the cycle, where the stiffness jumps.
    let time = |k: usize| mesh.start + mesh.period * ((k as f64 + 0.5) / count as f64);
    let solve = |k: usize| -> Result<Sample, EngineError> {
        resources.interrupt.check()?;
        sample(system, &system.solve(time(k))?, &measures).ok_or_else(singular)
    };
    let (first, again) = (solve(0)?, solve(count)?);
    if !repeats(&first, &again) {
        let message =
            "the equilibrium does not repeat after a mesh cycle, so its forced response is not periodic";
        let help = "a forced response needs axes at rest, equal teeth and constant loads; use time integration for other models";
        return Err(EngineError::new("E0774", message, help));
    }
    let (gyroscopic, damping) = (system.gyroscopic_matrix(time(0)), damping(system, time(0))?);
    let periodic = |used: &[&Sample]| PeriodicSystem {
        mass: first.mass.clone(),
        gyroscopic: gyroscopic.clone(),
        damping: damping.clone(),
        stiffness: used.iter().map(|sample| sample.stiffness.clone()).collect(),
        statics: used.iter().map(|sample| sample.statics.clone()).collect(),
        frequency,
        damping_ratio: request.damping_ratio,
    };
    let unknowns = unknowns(&periodic(&[&first]), request.harmonics, highest).ok_or_else(singular)?;
    if unknowns > LARGEST {
        let message = format!(
            "the forced response has {unknowns} unknowns by mode and harmonic, and at most {LARGEST} are possible"
        );
        let help = "give fewer `harmonics`, a lower `highest_speed`, or a lower `highest_frequency` of the component modes";
        return Err(EngineError::new("E0774", message, help));
    }
    let others = || (1..count).into_par_iter().map(solve).collect::<Result<Vec<Sample>, _>>();
    let others = resources.install(others)?;
    let samples: Vec<&Sample> = std::iter::once(&first).chain(&others).collect();
    let prepared = |stride: usize| {
        let used: Vec<&Sample> = samples.iter().copied().step_by(stride).collect();
        let quantities: Vec<LinearQuantity> =
            (0..measures.len()).map(|k| linear(&used, measures[k], k)).collect();
        ForcedVibration::new(&periodic(&used), &quantities, request.harmonics, highest).ok_or_else(singular)
    };
    let vibrations = [prepared(1)?, prepared(2)?];
    let [lowest, highest] = request.speeds;
    let speed = |k: usize| lowest + (highest - lowest) * (k as f64 / (request.count - 1).max(1) as f64);
    let point = |k: usize| -> Result<ForcedPoint, EngineError> {
        resources.interrupt.check()?;
        Ok(ForcedPoint::new(speed(k), &vibrations, speed(k) / own, 0.5 / count as f64))
    };
    let all = || (0..request.count).into_par_iter().map(point).collect::<Result<Vec<_>, _>>();
    Ok(ForcedResponse {
        body: scene.bodies[pair.bodies[0].0].name.clone(),
        order: f64::from(mesh.teeth[0]),
        quantities: measures.iter().map(|measure| label(system, scene, *measure)).collect(),
        points: resources.install(all)?,
    })
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
    // Unit inertia of each coordinate makes metres and radians comparable.
    let root = DVector::from_fn(first.mass.nrows(), |k, _| first.mass[(k, k)].sqrt());
    let scaled = |matrix: &DMatrix<f64>| {
        DMatrix::from_fn(root.len(), root.len(), |i, j| matrix[(i, j)] / (root[i] * root[j]))
    };
    let equal =
        |a: &DMatrix<f64>, b: &DMatrix<f64>| (scaled(a) - scaled(b)).amax() <= REPEATS * scaled(a).amax();
    let moved = |statics: &DVector<f64>| statics.component_mul(&root);
    equal(&first.stiffness, &again.stiffness)
        && equal(&first.mass, &again.mass)
        && (moved(&first.statics) - moved(&again.statics)).amax() <= REPEATS * moved(&first.statics).amax()
}

/// Returns the quantities of a response: transmission errors of meshes, tooth torques of gears that
/// rotate freely about their axes, and motions of all degrees of freedom.
fn measures(system: &System<'_>, scene: &Mechanism) -> Vec<Measure> {
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
    // Stops and spline teeth with clearance act on the rotation as well.
    if system.stops() == 0 && system.spline_teeth.is_empty() {
        found.extend(bodies.filter_map(|body| Some(Measure::ToothTorque(body, rotation(body)?))));
    }
    // The force of a stop is not a linear function of the motion.
    let linear = system.bearings.iter().filter(|&&bearing| scene.bearings[bearing].walls() == 0);
    found.extend(linear.flat_map(|&bearing| {
        let own = &scene.bearings[bearing];
        let resists = move |component: &usize| {
            own.nonlinear.is_some()
                || own.linearization.is_some()
                || own.stiffness[*component].iter().chain(&own.damping[*component]).any(|&entry| entry != 0.0)
        };
        (0..6).filter(resists).map(move |component| Measure::BearingForce(BearingId(bearing), component))
    }));
    found.extend((0..system.dofs.len()).map(Measure::Motion));
    found
}

/// Returns the name of a quantity.
fn label(system: &System<'_>, scene: &Mechanism, measure: Measure) -> ResponseQuantity {
    let name = |body: BodyId| &scene.bodies[body.0].name;
    let (name, unit) = match measure {
        Measure::TransmissionError(pair) => {
            let [first, second] = scene.pairs[pair.0].bodies.map(name);
            (format!("transmission_error({first}, {second})"), "rad")
        }
        Measure::ToothTorque(body, _) => (format!("tooth_torque({})", name(body)), "N*m"),
        Measure::BearingForce(bearing, component) => {
            let axis = ["x", "y", "z"][component % 3];
            let (kind, unit) = if component < 3 { ("force", "N") } else { ("moment", "N*m") };
            (format!("bearing_{kind}_{axis}({})", scene.bearings[bearing.0].name), unit)
        }
        Measure::Motion(dof) => {
            let dof = &system.dofs[dof];
            let unit = if dof.component < 3 { "m" } else { "rad" };
            (format!("{}({})", DOF_NAMES[dof.component], name(BodyId(dof.body))), unit)
        }
    };
    let meshes = |body: BodyId| {
        let own = scene.pairs.iter().filter(|pair| pair.front.is_none() && pair.bodies.contains(&body));
        own.count()
    };
    let is_tooth_load = matches!(measure, Measure::ToothTorque(body, _) if meshes(body) == 1);
    ResponseQuantity { name, unit, is_tooth_load }
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
