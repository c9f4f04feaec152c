//! Observables of bodies: contact forces, support reactions, displacements and loaded radii.

use super::{Equilibrium, Needs, Observable, Quantity};
use calyx_model::ids::BodyId;
use calyx_model::observed::{Location, Observed};
use std::ops::Add;

impl Equilibrium<'_> {
    /// Returns the contact forces on the frame of a body, in the order of
    /// [`calyx_model::dof::DOF_NAMES`]: force (N) and moment about the body's axis of rotation
    /// ([`calyx_model::motion::axle`]: the origin of its frame unless the body is eccentric; N m),
    /// along ground axes. Summed over all bodies, forces, and moments about any one point, vanish.
    ///
    /// Along a free DOF they balance the external load; along a constrained one the support carries
    /// both.
    pub fn contact_force(self, body: BodyId) -> [f64; 6] {
        let mut total = [0.0; 6];
        for (contact, side) in self.contacts_on(body) {
            for (sum, part) in total.iter_mut().zip(contact.wrench(side)) {
                *sum += part;
            }
        }
        total
    }

    /// Returns the support reaction of a body, in the order of [`calyx_model::dof::DOF_NAMES`]:
    /// force (N) and moment about the body's axis of rotation (N m), along ground axes. It balances
    /// contact, bearings, elastic connections, spline teeth with clearance, external load and
    /// inertia, so it vanishes along free DOFs.
    pub fn support(self, body: BodyId) -> [f64; 6] {
        let (contact, load) =
            (self.contact_force(body), self.system.scene.bodies[body.0].acted_on(self.step.time, 1.0));
        let [fx, fy, fz] = load.force;
        let [mx, my, mz] = load.moment;
        let load = [fx, fy, fz, mx, my, mz];
        let (bearings, spline_teeth) = (self.bearings_on(body), self.spline_forces_on(body));
        let connections = self.connections_on(body);
        let other_loads = self.step.other_loads.get(body.0).copied().unwrap_or_default();
        // Subtract from 0.0, not -(a + b): the result of no forces is 0, not -0.
        let all = |k: usize| 0.0 - contact[k] - load[k] - bearings[k] - spline_teeth[k] - other_loads[k];
        std::array::from_fn(|k| all(k) - connections[k])
    }
}

/// Support reaction force on a body, in addition to bearings, along a ground axis (0 to 2), N.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SupportForce(pub BodyId, pub usize);

impl Observable for SupportForce {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("support_force", "N")
    }

    fn frame_of(&self) -> Option<BodyId> {
        Some(self.0)
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        Observed::number(at.support(self.0)[self.1])
    }
}

/// Support reaction moment on a body, in addition to bearings, about its axis of rotation and along
/// a ground axis (0 to 2), N m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SupportMoment(pub BodyId, pub usize);

impl Observable for SupportMoment {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("support_moment", "N*m")
    }

    fn frame_of(&self) -> Option<BodyId> {
        Some(self.0)
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        Observed::number(at.support(self.0)[3 + self.1])
    }
}

/// Displacement of a body's frame from its prescribed position, along a ground axis (0 to 2), m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Displacement(pub BodyId, pub usize);

impl Observable for Displacement {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("displacement", "m")
    }

    fn needs(&self) -> Needs {
        Needs::Motions
    }

    fn frame_of(&self) -> Option<BodyId> {
        Some(self.0)
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        Observed::number(at.deviation(self.0, self.1))
    }
}

/// Rotation of a body's frame from its prescribed orientation, about a ground axis (0 to 2), rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rotation(pub BodyId, pub usize);

impl Observable for Rotation {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("rotation", "rad")
    }

    fn needs(&self) -> Needs {
        Needs::Motions
    }

    fn frame_of(&self) -> Option<BodyId> {
        Some(self.0)
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        Observed::number(at.deviation(self.0, 3 + self.1))
    }
}

/// Sum of the normal forces on one tooth of a body, N.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ToothLoad(pub BodyId, pub u32);

impl Observable for ToothLoad {
    fn quantity(&self) -> Quantity {
        Quantity::passing("tooth_load", "N")
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        let on_tooth = at.contacts_on(self.0).filter(|(contact, side)| contact.teeth()[*side] == self.1);
        Observed::number(on_tooth.map(|(contact, _)| contact.force()).fold(0.0, Add::add))
    }

    fn frame_of(&self) -> Option<BodyId> {
        Some(self.0)
    }
}

/// Smallest radius of loaded contact on a body, m; 0 without load.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LowestContact(pub BodyId);

impl Observable for LowestContact {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("lowest_contact", "m")
    }

    fn needs(&self) -> Needs {
        Needs::Motions
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        loaded_end(at, self.0, |radius, end| radius < end)
    }

    fn frame_of(&self) -> Option<BodyId> {
        Some(self.0)
    }
}

/// Largest radius of loaded contact on a body, m; 0 without load.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HighestContact(pub BodyId);

impl Observable for HighestContact {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("highest_contact", "m")
    }

    fn needs(&self) -> Needs {
        Needs::Motions
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        loaded_end(at, self.0, |radius, end| radius > end)
    }

    fn frame_of(&self) -> Option<BodyId> {
        Some(self.0)
    }
}

/// Returns the loaded point of a body with the extreme radius.
fn loaded_end(at: &Equilibrium<'_>, body: BodyId, beyond: impl Fn(f64, f64) -> bool) -> Observed {
    let places = at.contacts_on(body).flat_map(|(contact, side)| contact.loaded(side));
    let end: Option<Location> =
        places.map(|(place, _)| place).reduce(|end, place| match beyond(place.radius, end.radius) {
            true => place,
            false => end,
        });
    Observed { value: end.as_ref().map_or(0.0, |end| end.radius), least: None, location: end }
}
