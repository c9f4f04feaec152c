//! Recorder of the loads of all meshes and bearings, for [`crate::component_loads`].
//!
//! It evaluates observables at solved positions. It never changes a solution, and the plan does
//! not depend on it.

use crate::component_loads::{Component, ComponentLoads, LoadQuantity, LoadStatistics, RollingKind};
use crate::observables::{
    BearingForce, BearingFriction, BearingLife, BearingMoment, BearingPressure, Direction, Equilibrium,
    FrictionLoss, LubricatedLoss, MaxContactPressure, MaxEdgePressure, MaxRootStress, MeshForce,
    Misalignment, MisalignmentComponent, Needs, Observable, Observe, Quantity, TransmissionError,
};
use crate::rows::StepRow;
use crate::scene::Scene;
use crate::summary::mean_of_repeating;
use calyx_model::bearing::{BearingState, Support};
use calyx_model::fidelity::Fidelity;
use calyx_model::ids::{BearingId, PairId};
use calyx_model::motion::angular_velocity;
use calyx_model::observed::Observed;
use calyx_numerics::vec3::{dot, minus};
use calyx_rolling::Elements;
use calyx_rolling::rating::{LifeConditions, LoadDirection, rating_life};
use calyx_solve::step::StepResult;
use calyx_solve::system::System;
use std::any::Any;
use std::sync::Arc;

/// Quantity as a sum or a maximum of observables.
struct Recorded {
    quantity: LoadQuantity,
    observables: Vec<Arc<dyn Observable>>,
    combine: fn(f64, f64) -> f64,
}

impl Recorded {
    fn one(quantity: LoadQuantity, observable: impl Observable) -> Recorded {
        Recorded::shared(quantity, Arc::new(observable))
    }

    fn shared(quantity: LoadQuantity, observable: Arc<dyn Observable>) -> Recorded {
        Recorded { quantity, observables: vec![observable], combine: |_, other| other }
    }

    /// Combines an observable of the drive flanks and that of the coast flanks.
    fn flanks<T: Observable>(
        quantity: LoadQuantity,
        flanks: &[PairId],
        observable: impl Fn(PairId) -> T,
        combine: fn(f64, f64) -> f64,
    ) -> Recorded {
        let observables = flanks.iter().map(|&pair| Arc::new(observable(pair)) as Arc<dyn Observable>);
        Recorded { quantity, observables: observables.collect(), combine }
    }
}

/// Loads of all meshes and bearings at the positions solved so far.
pub(crate) struct ComponentRecorder {
    components: Vec<(Component, Vec<Recorded>)>,
    /// Values by position, in the order of the components and their quantities.
    values: Vec<Vec<f64>>,
}

impl ComponentRecorder {
    pub fn new(scene: &Scene) -> ComponentRecorder {
        let meshes = (0..scene.pairs.len()).filter_map(|pair| of_mesh(scene, PairId(pair)));
        let bearings = (0..scene.bearings.len()).map(|bearing| of_bearing(scene, BearingId(bearing)));
        ComponentRecorder { components: meshes.chain(bearings).collect(), values: Vec::new() }
    }

    /// Evaluates all quantities at a solved position. `observed` has the values of the observables
    /// of the scene, which are not evaluated twice.
    pub fn evaluate(
        &self,
        system: &System<'_>,
        step: &StepResult,
        fidelity: Fidelity,
        (scene, observed): (&Scene, &[Observed]),
    ) -> Vec<f64> {
        let value = |observable: &Arc<dyn Observable>| {
            let known = scene.observables.iter().position(|known| known.equals(observable.as_any()));
            match known.and_then(|known| observed.get(known)) {
                Some(known) => known.value,
                None => system.values(step, fidelity, std::slice::from_ref(observable))[0].value,
            }
        };
        let combined = |recorded: &Recorded| {
            let combined = recorded.observables.iter().map(value).reduce(recorded.combine);
            let combined = combined.unwrap_or(f64::NAN);
            // An unloaded bearing has an infinite life and no damage.
            let is_damage = matches!(recorded.quantity, LoadQuantity::Damage | LoadQuantity::ModifiedDamage);
            if is_damage { combined.recip() } else { combined }
        };
        self.components.iter().flat_map(|(_, recorded)| recorded).map(combined).collect()
    }

    pub fn push(&mut self, values: Vec<f64>) {
        self.values.push(values);
    }

    /// Returns the statistics over all positions. Quantities without a value at some position are
    /// left out.
    pub fn finish(self, rows: &[StepRow], scene: &Scene) -> Vec<ComponentLoads> {
        let mut index = 0;
        let mut statistics = || {
            let values: Vec<f64> =
                self.values.iter().filter_map(|values| values.get(index).copied()).collect();
            index += 1;
            if values.is_empty() || values.len() != rows.len() || values.iter().any(|v| !v.is_finite()) {
                return None;
            }
            Some(LoadStatistics {
                min: values.iter().copied().fold(f64::INFINITY, f64::min),
                mean: mean_of_repeating(rows, scene, &values),
                max: values.iter().copied().fold(f64::NEG_INFINITY, f64::max),
            })
        };
        let mut all = Vec::new();
        for (component, recorded) in &self.components {
            let found = recorded.iter().map(|recorded| (recorded.quantity, statistics()));
            let quantities: Vec<_> = found.filter_map(|(quantity, found)| Some((quantity, found?))).collect();
            if !quantities.is_empty() {
                all.push(ComponentLoads { component: component.clone(), quantities });
            }
        }
        all
    }
}

/// Returns the quantities of a mesh; `None` for coast flanks, which belong to the mesh of the drive
/// flanks, and for surfaces other than gears.
fn of_mesh(scene: &Scene, front: PairId) -> Option<(Component, Vec<Recorded>)> {
    use LoadQuantity as Of;
    let pair = scene.pairs.get(front.0).filter(|pair| pair.front.is_none())?;
    let mesh = pair.mesh.as_ref()?;
    let backs = (0..scene.pairs.len()).filter(|&other| scene.pairs[other].front == Some(front));
    let flanks: Vec<PairId> = std::iter::once(front).chain(backs.map(PairId)).collect();
    let sum = |one: f64, other: f64| one + other;
    // A NaN persists, unlike in `f64::max`.
    let largest = |one: f64, other: f64| if other > one || other.is_nan() { other } else { one };
    let mut recorded = vec![
        Recorded::one(Of::Torque, MeshTorque(front)),
        Recorded::flanks(Of::MeshForce, &flanks, MeshForce, sum),
        Recorded::one(Of::TransmissionError, TransmissionError(front)),
        Recorded::flanks(Of::ContactPressure, &flanks, MaxContactPressure, largest),
        Recorded::flanks(Of::EdgePressure, &flanks, MaxEdgePressure, largest),
    ];
    // The plan recovers stresses of those bodies only of which the model requests stresses.
    for (quantity, body) in [Of::FirstRootStress, Of::SecondRootStress].into_iter().zip(pair.bodies) {
        if scene.observables.iter().any(|observable| observable.stresses_of() == Some(body)) {
            recorded.push(Recorded::one(quantity, MaxRootStress(body)));
        }
    }
    use MisalignmentComponent as Misaligned;
    let misalignment = match mesh.first_contact {
        None => [
            (Of::MisalignmentSlope, Misaligned::SlopeInPlane),
            (Of::MisalignmentOffset, Misaligned::OffsetInPlane),
        ],
        Some(_) => [(Of::OffsetError, Misaligned::Offset), (Of::ShaftAngleError, Misaligned::ShaftAngle)],
    };
    let misalignment = misalignment.into_iter();
    recorded.extend(misalignment.map(|(of, component)| Recorded::one(of, Misalignment(front, component))));
    recorded.extend(requested(scene, Of::FrictionLoss, |observable| {
        let of_friction = observable.downcast_ref::<FrictionLoss>().map(|loss| loss.0);
        let pair = of_friction.or_else(|| observable.downcast_ref::<LubricatedLoss>().map(|loss| loss.0));
        pair.is_some_and(|pair| flanks.contains(&pair))
    }));
    recorded.push(Recorded::one(Of::MeshSpeed, MeshSpeed(front)));
    let names = pair.bodies.map(|body| scene.bodies[body.0].name.clone());
    Some((Component::Mesh(names), recorded))
}

fn of_bearing(scene: &Scene, id: BearingId) -> (Component, Vec<Recorded>) {
    use LoadQuantity as Of;
    let bearing = &scene.bearings[id.0];
    let mut recorded = vec![
        Recorded::one(Of::RadialForce, BearingForce(id, Direction::Radial)),
        Recorded::one(Of::AxialForce, BearingForce(id, Direction::Axial)),
        Recorded::one(Of::TiltingMoment, BearingMoment(id, Direction::Radial)),
    ];
    let life = |modified: bool| {
        move |observable: &dyn Any| {
            let life = observable.downcast_ref::<BearingLife>();
            life.is_some_and(|life| life.bearing == id && life.modified == modified)
        }
    };
    let mut kind = None;
    let rolling = bearing.rolling().and_then(|rolling| Some((rolling, rolling.bearing.rows().first()?)));
    if let Some((rolling, row)) = rolling {
        kind = Some(match row.elements {
            Elements::Balls(_) => RollingKind::Balls,
            Elements::Rollers(_) => RollingKind::Rollers,
        });
        let lives = scene.observables.iter().filter_map(|known| known.as_any().downcast_ref::<BearingLife>());
        let direction = lives.filter(|life| life.bearing == id).map(|life| life.conditions.direction).next();
        let direction = direction.unwrap_or(rolling.load_direction());
        recorded.push(Recorded::one(Of::ElementPressure, BearingPressure(id)));
        recorded.push(Recorded::one(Of::EquivalentLoad, EquivalentLoad { bearing: id, direction }));
        recorded.extend(requested(scene, Of::Damage, life(false)));
        recorded.extend(requested(scene, Of::ModifiedDamage, life(true)));
        recorded.extend(requested(scene, Of::BearingLoss, |observable| {
            let friction = observable.downcast_ref::<BearingFriction>();
            friction.is_some_and(|friction| friction.bearing == id && friction.is_loss)
        }));
    }
    recorded.push(Recorded::one(Of::BearingSpeed, BearingSpeed(id)));
    (Component::Bearing { name: bearing.name.clone(), kind }, recorded)
}

/// Returns the observable of the scene that meets a condition. Several ones have different
/// conditions, such as coefficients of friction, and none of them is preferred.
fn requested(scene: &Scene, quantity: LoadQuantity, meets: impl Fn(&dyn Any) -> bool) -> Option<Recorded> {
    let mut all = scene.observables.iter().filter(|observable| meets(observable.as_any()));
    let only = all.next().filter(|_| all.next().is_none())?;
    Some(Recorded::shared(quantity, only.clone()))
}

/// Magnitude of the torque of a mesh on its first gear, N m.
#[derive(Clone, Copy, Debug, PartialEq)]
struct MeshTorque(PairId);

impl Observable for MeshTorque {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("mesh_torque", "N*m")
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        let torque: f64 = at.mesh_contacts(self.0).map(|contact| contact.torque(0)).sum();
        Observed::number(torque.abs())
    }

    fn pair_of(&self) -> Option<PairId> {
        Some(self.0)
    }
}

/// Speed of the first gear relative to the carrier of the mesh, rad/s: that of its load cycles.
#[derive(Clone, Copy, Debug, PartialEq)]
struct MeshSpeed(PairId);

impl Observable for MeshSpeed {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("mesh_speed", "rad/s")
    }

    fn needs(&self) -> Needs {
        Needs::Motions
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        Observed::number(at.system.speed_on_carrier(self.0.0, 0, at.time()).abs())
    }

    fn pair_of(&self) -> Option<PairId> {
        Some(self.0)
    }
}

/// Speed of the first race relative to the second about the axis of the bearing, rad/s.
#[derive(Clone, Copy, Debug, PartialEq)]
struct BearingSpeed(BearingId);

impl Observable for BearingSpeed {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("bearing_speed", "rad/s")
    }

    fn needs(&self) -> Needs {
        Needs::Motions
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        let scene = at.system.scene;
        let bearing = &scene.bearings[self.0.0];
        let Ok(state) = BearingState::at(&scene.bodies, bearing, at.time()) else {
            return Observed::number(f64::NAN);
        };
        let velocity = |body: usize| angular_velocity(scene.bodies[body].motion.as_ref(), at.time());
        let second = match bearing.to {
            Support::Ground => [0.0; 3],
            Support::Body(body) => velocity(body.0),
        };
        Observed::number(dot(minus(velocity(bearing.body.0), second), state.axes[2]).abs())
    }

    fn bearing_of(&self) -> Option<BearingId> {
        Some(self.0)
    }
}

/// Dynamic equivalent reference load of a rolling bearing, N. It depends on the loads of the
/// elements and on the internal geometry, and on no load rating: a larger rating increases the
/// ratings of all contacts alike. The direction is that of a requested life; otherwise the load is
/// steady relative to the second race.
#[derive(Clone, Copy, Debug, PartialEq)]
struct EquivalentLoad {
    bearing: BearingId,
    direction: LoadDirection,
}

impl Observable for EquivalentLoad {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("bearing_equivalent_load", "N")
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        let load = || {
            let elements = at.system.scene.bearings[self.bearing.0].rolling()?;
            let states = at.rolling_elements(self.bearing)?;
            let conditions = LifeConditions { direction: self.direction, ..LifeConditions::default() };
            Some(rating_life(&elements.bearing, &states, &conditions).ok()?.equivalent_load)
        };
        Observed::number(load().unwrap_or(f64::NAN))
    }

    fn bearing_of(&self) -> Option<BearingId> {
        Some(self.bearing)
    }
}
