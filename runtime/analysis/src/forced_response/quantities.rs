//! Quantities of a forced response, and their derivatives by the motion at a position.

use super::ResponseQuantity;
use crate::observables::{BearingStiffness, Equilibrium, Observable, TransmissionError};
use calyx_model::bearing::BearingState;
use calyx_model::dof::{DOF_NAMES, Dof};
use calyx_model::ids::{BearingId, BodyId, PairId};
use calyx_model::mechanism::Mechanism;
use calyx_model::pairs::SurfacePair;
use calyx_numerics::vec3::dot;
use calyx_solve::forced_response::LinearQuantity;
use calyx_solve::step::StepResult;
use calyx_solve::system::System;
use nalgebra::{DMatrix, DVector};

const THETA_Z: usize = 5;

/// State of one position.
pub(super) struct Sample {
    pub stiffness: DMatrix<f64>,
    pub mass: DMatrix<f64>,
    pub statics: DVector<f64>,
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
pub(super) enum Measure {
    TransmissionError(PairId),
    /// Moment of all tooth contacts of a body about its axis.
    ToothTorque(BodyId, usize),
    /// Force or moment of a bearing on the body of its first race along one of the bearing's axes.
    BearingForce(BearingId, usize),
    Motion(usize),
}

/// Returns a quantity over the samples; only its static value and contact vary.
pub(super) fn linear(samples: &[&Sample], measure: Measure, index: usize) -> LinearQuantity {
    let states = || samples.iter().map(|sample| &sample.quantities[index]);
    let count = match measure {
        Measure::ToothTorque(..) | Measure::BearingForce(..) => samples.len(),
        Measure::TransmissionError(_) | Measure::Motion(_) => 1,
    };
    LinearQuantity {
        statics: states().map(|state| state.value).collect(),
        rows: states().take(count).map(|state| state.row.clone()).collect(),
        // The axes of a bearing may rotate with its carrier.
        rates: states().filter_map(|state| state.rate.clone()).collect(),
    }
}

/// Returns the quantities of a response: transmission errors of meshes, tooth torques of gears that
/// rotate freely about their axes, and motions of all degrees of freedom.
pub(super) fn measures(system: &System<'_>, scene: &Mechanism) -> Vec<Measure> {
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
        (0..6)
            .filter(move |&component| own.resists(component))
            .map(move |component| Measure::BearingForce(BearingId(bearing), component))
    }));
    found.extend((0..system.dofs.len()).map(Measure::Motion));
    found
}

/// Returns the name of a quantity.
pub(super) fn label(system: &System<'_>, scene: &Mechanism, measure: Measure) -> ResponseQuantity {
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
    let is_tooth_load =
        matches!(measure, Measure::ToothTorque(body, _) if is_loaded_in_one_sense(scene, body));
    ResponseQuantity { name, unit, is_tooth_load }
}

/// Returns true if all meshes of a gear load it in one sense, as those of a sun or a ring, so that
/// teeth separate where the sum changes its sign. The meshes of a planet or an idler balance.
fn is_loaded_in_one_sense(scene: &Mechanism, body: BodyId) -> bool {
    let sense = |pair: &SurfacePair| {
        let mesh = pair.mesh.as_ref().filter(|_| pair.front.is_none())?;
        // The teeth push the driving gear against its motion, and the driven one along its own.
        match pair.bodies.map(|one| one == body) {
            [true, _] => Some(-mesh.drive_sense),
            [_, true] => Some(-mesh.sign * mesh.drive_sense),
            [false, false] => None,
        }
    };
    let mut senses = scene.pairs.iter().filter_map(sense);
    senses.next().is_some_and(|first| senses.all(|other| other == first))
}

/// Returns the state of a solved position; `None` if nothing vibrates.
pub(super) fn sample(system: &System<'_>, step: &StepResult, measures: &[Measure]) -> Option<Sample> {
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
