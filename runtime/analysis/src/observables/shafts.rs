//! Observables of elastic connections and shafts: forces on bodies, motions and forces of sections,
//! nominal stresses, reactions.

use super::bearings::Direction;
use super::{Equilibrium, Needs, Observable, Quantity};
use calyx_model::bearing::Support;
use calyx_model::connection::{CondensedShaft, ConnectionState, ElasticConnection};
use calyx_model::ids::{BodyId, ConnectionId};
use calyx_model::observed::Observed;
use calyx_model::shaft::SectionForces;
use calyx_numerics::vec3::cross;

/// Elastic connection in equilibrium.
pub struct ConnectionLoad<'a> {
    connection: &'a ElasticConnection,
    state: ConnectionState,
    /// Motions of the attachments, m along and rad about the reference axes.
    pub motions: Vec<[f64; 6]>,
    /// Forces (N) and moments (N m) of the connection on the attachments, along the same axes.
    pub push: Vec<[f64; 6]>,
}

impl ConnectionLoad<'_> {
    /// Returns the force (N) and the moment about the body's axis of rotation (N m) of the
    /// connection on a body, along ground axes.
    pub fn wrench_on(&self, body: BodyId) -> [f64; 6] {
        self.state.wrench_on(body, &self.push)
    }

    fn shaft(&self) -> Option<&CondensedShaft> {
        self.connection.shaft.as_ref()
    }

    /// Returns the motion of a section of a shaft at a position (m): displacement and rotation
    /// along and about the reference axes; `None` for another connection.
    fn motion_at(&self, z: f64) -> Option<[f64; 6]> {
        let CondensedShaft { shaft, stations, .. } = self.shaft()?;
        Some(shaft.motion_at(stations, &self.motions, z))
    }

    /// Returns the forces in a section of a shaft, before or after those that act at its position;
    /// `None` for another connection and for a rigid shaft.
    pub fn section_forces(&self, at: (f64, bool)) -> Option<SectionForces> {
        let CondensedShaft { shaft, stations, rigid } = self.shaft()?;
        (!rigid).then(|| shaft.section_forces(stations, &self.forces_on_shaft(), at))
    }

    /// Returns the forces (N) and moments (N m) of the bodies on a shaft at its stations.
    pub(super) fn forces_on_shaft(&self) -> Vec<[f64; 6]> {
        self.push.iter().map(|push| push.map(|part| -part)).collect()
    }

    pub(super) fn state(&self) -> &ConnectionState {
        &self.state
    }

    fn along(&self, [x, y, z]: [f64; 3], direction: Direction) -> f64 {
        match direction {
            Direction::Ground(axis) => self.state.to_ground([x, y, z])[axis],
            Direction::Axial => z,
            Direction::Radial => x.hypot(y),
        }
    }
}

impl<'a> Equilibrium<'a> {
    /// Evaluates an elastic connection of the scene; `None` if the scene has no such connection, or
    /// its bodies have moved apart.
    pub fn connection(self, connection: ConnectionId) -> Option<ConnectionLoad<'a>> {
        let system = self.system;
        let own = system.elastic_connections.get(connection.0)?;
        let state = ConnectionState::at(&system.scene.bodies, own, self.step.time).ok()?;
        let motions = state.motions(&system.dofs, &self.step.motion);
        let push = match system.connections.contains(&connection.0) {
            true => {
                let on_body = own.forces_on_body(&motions, &self.raceway_forces(connection.0));
                on_body.into_iter().map(|six| six.map(|force| 0.0 - force)).collect()
            }
            false => vec![[0.0; 6]; motions.len()],
        };
        Some(ConnectionLoad { connection: own, state, motions, push })
    }

    /// Returns the sum of the forces and moments of all elastic connections on a body, as in
    /// [`ConnectionLoad::wrench_on`].
    pub fn connections_on(self, body: BodyId) -> [f64; 6] {
        let mut total = [0.0; 6];
        for (index, connection) in self.system.scene.connections.iter().enumerate() {
            if !connection.bodies().any(|other| other == body) {
                continue;
            }
            let Some(load) = self.connection(ConnectionId(index)) else { continue };
            for (sum, part) in total.iter_mut().zip(load.wrench_on(body)) {
                *sum += part;
            }
        }
        total
    }
}

/// Half of six components: the rotational ones if `about`.
fn half(numbers: [f64; 6], about: bool) -> [f64; 3] {
    let from = if about { 3 } else { 0 };
    std::array::from_fn(|k| numbers[from + k])
}

/// Position on a shaft: the connection that condenses it, its first body and the distance from its
/// origin, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShaftPosition {
    /// Connection of the shaft.
    pub shaft: ConnectionId,
    /// A body of the shaft, through which the observable depends on the scene.
    pub body: BodyId,
    /// Distance from the origin of the shaft, m.
    pub at: f64,
}

/// Displacement of a section of a shaft from its prescribed position, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShaftDisplacement(pub ShaftPosition, pub Direction);

impl Observable for ShaftDisplacement {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("shaft_displacement", "m")
    }

    fn needs(&self) -> Needs {
        Needs::Motions
    }

    fn frame_of(&self) -> Option<BodyId> {
        Some(self.0.body)
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        Observed::number(section_motion(at, self.0, self.1, false))
    }
}

/// Rotation of a section of a shaft from its prescribed orientation, rad: slope and twist.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShaftRotation(pub ShaftPosition, pub Direction);

impl Observable for ShaftRotation {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("shaft_rotation", "rad")
    }

    fn needs(&self) -> Needs {
        Needs::Motions
    }

    fn frame_of(&self) -> Option<BodyId> {
        Some(self.0.body)
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        Observed::number(section_motion(at, self.0, self.1, true))
    }
}

fn section_motion(at: &Equilibrium<'_>, position: ShaftPosition, direction: Direction, about: bool) -> f64 {
    let load = at.connection(position.shaft);
    let along =
        |load: ConnectionLoad<'_>| Some(load.along(half(load.motion_at(position.at)?, about), direction));
    load.and_then(along).unwrap_or(f64::NAN)
}

/// Component of the forces in a section of a shaft.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SectionComponent {
    /// Magnitude of the bending moment, N m.
    Bending,
    /// Torque of the part towards +z on the part towards -z, N m.
    Torque,
}

/// Moment in a section of a shaft, N m: the larger one of both sides of a position at which a
/// force acts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShaftMoment(pub ShaftPosition, pub SectionComponent);

impl Observable for ShaftMoment {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("shaft_moment", "N*m")
    }

    fn frame_of(&self) -> Option<BodyId> {
        Some(self.0.body)
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        let ShaftMoment(ShaftPosition { shaft, at: z, .. }, component) = *self;
        let sides = at
            .connection(shaft)
            .and_then(|load| Some([load.section_forces((z, false))?, load.section_forces((z, true))?]));
        let of = |forces: SectionForces| match component {
            SectionComponent::Bending => forces.bending_moment(),
            SectionComponent::Torque => forces.torque(),
        };
        let larger = |[before, after]: [f64; 2]| if after.abs() > before.abs() { after } else { before };
        Observed::number(sides.map_or(f64::NAN, |sides| larger(sides.map(of))))
    }
}

/// Nominal stress of a shaft.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NominalStress {
    /// Bending with axial force.
    Bending,
    /// Torsion.
    Torsion,
    /// Equivalent stress of both (von Mises).
    Equivalent,
}

/// Nominal stress in a section of a shaft, Pa, without stress concentrations: the larger one of
/// both sides of a step or of a force. Without a position, the largest along the shaft.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShaftStress {
    /// Connection of the shaft.
    pub shaft: ConnectionId,
    /// A body of the shaft.
    pub body: BodyId,
    /// Distance from the origin of the shaft, m.
    pub at: Option<f64>,
    /// The stress.
    pub stress: NominalStress,
}

/// Number of parts of each segment at whose ends the largest stress is searched: in a cylinder it
/// is at an end of a segment or at a force, in a cone it may be between.
const SEARCHED: usize = 8;

impl Observable for ShaftStress {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("shaft_stress", "Pa")
    }

    fn bounds(&self) -> [f64; 2] {
        [0.0, f64::INFINITY]
    }

    fn frame_of(&self) -> Option<BodyId> {
        Some(self.body)
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        let largest = at.connection(self.shaft).and_then(|load| {
            let CondensedShaft { shaft, stations, .. } = load.shaft()?;
            let positions: Vec<f64> = match self.at {
                Some(at) => vec![at],
                None => {
                    let parts = shaft.ends().windows(2).flat_map(|ends| {
                        let (start, length) = (ends[0], ends[1] - ends[0]);
                        (0..=SEARCHED).map(move |k| start + length * (k as f64 / SEARCHED as f64))
                    });
                    parts.chain(stations.iter().copied()).collect()
                }
            };
            let mut largest = 0.0_f64;
            for z in positions {
                for after in [false, true] {
                    let forces = load.section_forces((z, after))?;
                    let [bending, torsion, equivalent] = shaft.nominal_stress((z, after), &forces);
                    largest = largest.max(match self.stress {
                        NominalStress::Bending => bending,
                        NominalStress::Torsion => torsion,
                        NominalStress::Equivalent => equivalent,
                    });
                }
            }
            Some(largest)
        });
        Observed::number(largest.unwrap_or(f64::NAN))
    }
}

/// Reaction of the constraints of all sections of a shaft, about the position, along a ground axis
/// (0 to 2): a force in N, or a moment in N m if `about`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShaftReaction {
    /// Position to which moments refer.
    pub about: ShaftPosition,
    /// True for the moment, false for the force.
    pub moment: bool,
    /// Ground axis.
    pub axis: usize,
}

impl Observable for ShaftReaction {
    fn quantity(&self) -> Quantity {
        match self.moment {
            true => Quantity::repeating("support_moment", "N*m"),
            false => Quantity::repeating("support_force", "N"),
        }
    }

    fn frame_of(&self) -> Option<BodyId> {
        Some(self.about.body)
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        let ShaftPosition { shaft, at: z, .. } = self.about;
        let Some(load) = at.connection(shaft) else { return Observed::number(f64::NAN) };
        let stations = load.shaft().map_or(&[][..], |shaft| &shaft.stations);
        let mut sum = [0.0; 6];
        for (index, attachment) in load.connection.attachments.iter().enumerate() {
            let Support::Body(body) = attachment.to else { continue };
            // A body with several attachments counts once.
            if load.connection.attachments[..index].iter().any(|other| other.to == attachment.to) {
                continue;
            }
            let reaction = at.support(body);
            let position = stations.get(index).map_or(0.0, |station| station - attachment.at[2]);
            let arm = load.state.to_ground([0.0, 0.0, position - z]);
            let turned = cross(arm, half(reaction, false));
            for k in 0..3 {
                sum[k] += reaction[k];
                sum[3 + k] += reaction[3 + k] + turned[k];
            }
        }
        Observed::number(sum[if self.moment { 3 + self.axis } else { self.axis }])
    }
}
