//! Observables of bearings: forces, moments, deflections and tilts.

use super::{Equilibrium, Needs, Observable, Quantity};
use calyx_model::bearing::{BearingState, ElasticRaceways, NonlinearLoad, NonlinearState, SeatTerms, five};
use calyx_model::ids::{BearingId, BodyId};
use calyx_model::observed::Observed;

/// Bearing in equilibrium.
pub struct BearingLoad {
    /// Deflection: motion of the first race relative to the second, m along and rad about the
    /// bearing's axes.
    pub deflection: [f64; 6],
    /// Force (N) and moment about the bearing's origin (N m) on the first race, along the bearing's
    /// axes. The opposite acts on the second race.
    pub push: [f64; 6],
    placed: BearingState,
}

/// Direction of a reported force, moment or motion of a bearing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Direction {
    /// Ground axis, 0 to 2.
    Ground(usize),
    /// Axis of the bearing.
    Axial,
    /// Magnitude of the components normal to the bearing's axis.
    Radial,
}

impl BearingLoad {
    /// Returns the force (N) and the moment about the body's axis of rotation (N m) of the bearing
    /// on a connected body, along ground axes.
    pub fn wrench_on(&self, body: BodyId) -> [f64; 6] {
        self.placed.wrench_on(body, self.push)
    }

    /// Returns the origin of the bearing in ground coordinates, m.
    pub(super) fn origin(&self) -> [f64; 3] {
        self.placed.origin
    }

    /// Transforms a vector from the bearing's axes to ground axes.
    pub(super) fn to_ground(&self, vector: [f64; 3]) -> [f64; 3] {
        self.placed.to_ground(vector)
    }

    fn along(&self, [x, y, z]: [f64; 3], direction: Direction) -> f64 {
        match direction {
            Direction::Ground(axis) => self.placed.to_ground([x, y, z])[axis],
            Direction::Axial => z,
            Direction::Radial => x.hypot(y),
        }
    }
}

impl Equilibrium<'_> {
    /// Evaluates a bearing of the scene; `None` if the scene has no such bearing, or its races have
    /// separated.
    pub fn bearing(self, bearing: BearingId) -> Option<BearingLoad> {
        let system = self.system;
        let own = system.scene.bearings.get(bearing.0)?;
        let placed = BearingState::at(&system.scene.bodies, own, self.step.time).ok()?;
        let of = |motions: &[f64]| {
            let mut deflection = [0.0; 6];
            for (dof, motion) in system.dofs.iter().zip(motions) {
                for (sum, part) in deflection.iter_mut().zip(placed.deflection(dof)) {
                    *sum += part * motion;
                }
            }
            deflection
        };
        let (deflection, rate) = (of(&self.step.motion), of(&self.step.velocity));
        let before = system.bearings.iter().take_while(|&&other| other != bearing.0);
        let skipped: usize = before.map(|&other| system.scene.bearings[other].walls()).sum();
        let width = system.width(own.body.0);
        let walls: Vec<f64> = self.step.stops.iter().skip(skipped).map(|force| width * force).collect();
        let walls = if system.bearings.contains(&bearing.0) { &walls[..] } else { &[] };
        let nonlinear = match self.step.bearing_state(bearing.0, &deflection) {
            Some(state) => Some(state.push()),
            None => self.nonlinear_load(bearing).map(|nonlinear| nonlinear.push(&deflection)),
        };
        let (sprung, damped) = (own.push(&deflection, walls, nonlinear), own.damping_at(&rate));
        let push = std::array::from_fn(|k| sprung[k] - damped[k]);
        Some(BearingLoad { deflection, push, placed })
    }

    /// Returns the nonlinear load of a bearing of the scene, between raceways as elastic bodies
    /// displace them; `None` without one.
    pub(super) fn nonlinear_load(self, bearing: BearingId) -> Option<NonlinearLoad> {
        let load = self.system.nonlinear_load(bearing.0, self.step.time)?;
        let raceway = self.step.raceways.iter().find(|raceway| raceway.bearing == bearing.0);
        Some(raceway.map_or(load.clone(), |raceway| load.on_raceway(&raceway.displacement)))
    }

    /// Returns the forces on the displacements of the bore of a body on which contact outside of
    /// its structure acts, in the unit of the contact problem: of spline teeth with clearance, or
    /// of rollers on the terms of a raceway. Empty for another bore.
    pub(super) fn interface_forces(self, body: BodyId) -> Vec<f64> {
        let mut total = self.spline_clearance_forces(body);
        for raceway in &self.step.raceways {
            let placed = self.system.elastic_raceways(raceway.bearing, self.step.time).ok().flatten();
            let bore = placed.as_ref().and_then(ElasticRaceways::bore);
            let Some(bore) = bore.filter(|bore| bore.body == body.0) else { continue };
            let forces = bore.on_terms(&raceway.loads) / self.system.width(body.0);
            total.resize(forces.len(), 0.0);
            total.iter_mut().zip(forces.iter()).for_each(|(sum, force)| *sum += force);
        }
        total
    }

    /// Returns the forces of rolling elements on the coefficients of the raceways of an elastic
    /// connection, by its index in the scene; empty without any.
    pub(super) fn raceway_forces(self, connection: usize) -> Vec<f64> {
        let mut total = Vec::new();
        for raceway in &self.step.raceways {
            let placed = self.system.elastic_raceways(raceway.bearing, self.step.time).ok().flatten();
            for own in placed.iter().flat_map(|placed| &placed.raceways) {
                let seat = own.seat.filter(|seat| seat.connection == connection);
                let Some(SeatTerms { first, .. }) = seat else { continue };
                total.resize(self.system.elastic_connections[connection].raceways.terms(), 0.0);
                let forces = own.on_terms(&raceway.loads);
                total[first..].iter_mut().zip(forces.iter()).for_each(|(sum, force)| *sum += force);
            }
        }
        total
    }

    /// Returns the sum of the forces and moments of all bearings on a body, as in
    /// [`BearingLoad::wrench_on`].
    pub fn bearings_on(self, body: BodyId) -> [f64; 6] {
        let mut total = [0.0; 6];
        for (index, bearing) in self.system.scene.bearings.iter().enumerate() {
            let Some(load) =
                bearing.bodies().find(|b| *b == body).and_then(|_| self.bearing(BearingId(index)))
            else {
                continue;
            };
            for (sum, part) in total.iter_mut().zip(load.wrench_on(body)) {
                *sum += part;
            }
        }
        total
    }
}

/// Returns the three rotational (`about`) or translational of six components.
fn half(numbers: [f64; 6], about: bool) -> [f64; 3] {
    let from = if about { 3 } else { 0 };
    std::array::from_fn(|k| numbers[from + k])
}

fn observed(at: &Equilibrium<'_>, bearing: BearingId, of: impl Fn(&BearingLoad) -> f64) -> Observed {
    Observed::number(at.bearing(bearing).map_or(f64::NAN, |load| of(&load)))
}

/// Entry of the stiffness matrix of a bearing at the deflection of a position, in its axes: force
/// (N) or moment (N m) by displacement (m) or rotation (rad). Clearances with stops are not
/// included.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BearingStiffness {
    /// Bearing.
    pub bearing: BearingId,
    /// Component of the force.
    pub row: usize,
    /// Component of the deflection.
    pub column: usize,
}

impl Observable for BearingStiffness {
    fn quantity(&self) -> Quantity {
        match [self.row < 3, self.column < 3] {
            [true, true] => Quantity::repeating("bearing_stiffness", "N/m"),
            [false, false] => Quantity::repeating("bearing_tilting_stiffness", "N*m/rad"),
            _ => Quantity::repeating("bearing_coupling_stiffness", "N/rad"),
        }
    }

    fn bearing_of(&self) -> Option<BearingId> {
        Some(self.bearing)
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        let own = &at.system.scene.bearings[self.bearing.0];
        observed(at, self.bearing, |load| {
            let linear = own.stiffness[self.row][self.column];
            let Some(nonlinear) = at.nonlinear_load(self.bearing) else {
                return linear;
            };
            let tangent = |state: &NonlinearState| {
                linear + nonlinear.tangent(state, 0.0).stiffness[self.row][self.column]
            };
            match at.step.bearing_state(self.bearing.0, &load.deflection) {
                Some(state) => tangent(state),
                None => {
                    nonlinear.state(None, five(&load.deflection)).map_or(f64::NAN, |state| tangent(&state))
                }
            }
        })
    }
}

/// Force of a bearing on the body of its first race, N.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BearingForce(pub BearingId, pub Direction);

impl Observable for BearingForce {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("bearing_force", "N")
    }

    fn bearing_of(&self) -> Option<BearingId> {
        Some(self.0)
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        observed(at, self.0, |load| load.along(half(load.push, false), self.1))
    }
}

/// Moment of a bearing on the body of its first race, about the bearing's origin, N m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BearingMoment(pub BearingId, pub Direction);

impl Observable for BearingMoment {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("bearing_moment", "N*m")
    }

    fn bearing_of(&self) -> Option<BearingId> {
        Some(self.0)
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        observed(at, self.0, |load| load.along(half(load.push, true), self.1))
    }
}

/// Displacement of the first race relative to the second, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BearingDeflection(pub BearingId, pub Direction);

impl Observable for BearingDeflection {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("bearing_deflection", "m")
    }

    fn needs(&self) -> Needs {
        Needs::Motions
    }

    fn bearing_of(&self) -> Option<BearingId> {
        Some(self.0)
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        observed(at, self.0, |load| load.along(half(load.deflection, false), self.1))
    }
}

/// Rotation of the first race relative to the second, rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BearingTilt(pub BearingId, pub Direction);

impl Observable for BearingTilt {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("bearing_tilt", "rad")
    }

    fn needs(&self) -> Needs {
        Needs::Motions
    }

    fn bearing_of(&self) -> Option<BearingId> {
        Some(self.0)
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        observed(at, self.0, |load| load.along(half(load.deflection, true), self.1))
    }
}
