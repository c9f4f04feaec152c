//! Observables of spline teeth: those that are part of a structure's support, and those with
//! clearance, which are in contact.

use super::{Equilibrium, Observable, Quantity};
use calyx_model::flanks::arms_at;
use calyx_model::ids::BodyId;
use calyx_model::observed::Observed;
use calyx_model::spline_contact::SplineContact;
use calyx_solve::system::Bodies;
use calyx_structure::SplineToothForce;

impl Equilibrium<'_> {
    /// Returns the spline teeth with clearance that support a body, with the forces on their flanks
    /// in the unit of the contact problem.
    fn spline_forces_by_contact(&self, body: BodyId) -> Option<(&SplineContact, &[f64])> {
        let mut first = self.system.stops();
        for (index, contact) in &self.system.spline_teeth {
            let flanks = first..first + contact.flanks();
            if *index == body.0 {
                // Without contact forces there are none.
                return Some((contact, self.step.stops.get(flanks).unwrap_or_default()));
            }
            first = flanks.end;
        }
        None
    }

    /// Returns the forces of these spline teeth on the body, counter-clockwise, in the unit of the
    /// contact problem; empty for a body without spline teeth.
    pub(super) fn spline_clearance_forces(&self, body: BodyId) -> Vec<f64> {
        self.spline_forces_by_contact(body).map_or_else(Vec::new, |(contact, flanks)| contact.around(flanks))
    }

    /// Returns the forces of these spline teeth on the body's frame, as in
    /// [`Equilibrium::contact_force`]: force (N) and moment about the body's axis of rotation (N
    /// m).
    pub fn spline_forces_on(self, body: BodyId) -> [f64; 6] {
        let mut total = [0.0; 6];
        let Some((contact, flanks)) = self.spline_forces_by_contact(body) else { return total };
        let Ok(arms) = arms_at(self.system.scene, body.0, contact, self.step.time) else {
            return [f64::NAN; 6];
        };
        for (arms, force) in arms.iter().zip(flanks) {
            for (component, arm) in [0, 1, 5].into_iter().zip(arms) {
                total[component] += self.system.width(body.0) * force * arm;
            }
        }
        total
    }
}

/// Force of one spline tooth on the body that it supports, N: circumferential, counter-clockwise,
/// or radial, outwards; 0 for a body without it. Spline teeth without clearance carry only tooth
/// contact forces, neither inertia nor loads on the frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SplineToothLoad {
    /// Body that the spline tooth supports.
    pub body: BodyId,
    /// Number of the spline tooth, counter-clockwise from 0.
    pub spline_tooth: u32,
    /// Selects the radial component instead of the circumferential one.
    pub radial: bool,
}

impl Observable for SplineToothLoad {
    fn quantity(&self) -> Quantity {
        Quantity::passing("lug_force", "N")
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        let width = at.system.width(self.body.0);
        if at.spline_forces_by_contact(self.body).is_some() {
            let force = at
                .spline_clearance_forces(self.body)
                .get(self.spline_tooth as usize)
                .copied()
                .unwrap_or_default();
            return Observed::number(if self.radial { 0.0 } else { width * force });
        }
        let forces = match &at.system.bodies {
            Bodies::Plane(bodies) => {
                let structure = bodies.structures.get(self.body.0).and_then(Option::as_ref);
                structure.map(|structure| structure.spline_tooth_forces(&at.surface_loads(self.body)))
            }
            Bodies::Solid(bodies) => {
                let structure = bodies.structures.get(self.body.0).and_then(Option::as_ref);
                structure.map(|structure| structure.spline_tooth_forces(&at.segment_loads(self.body)))
            }
        };
        let force = forces.unwrap_or_default().get(self.spline_tooth as usize).copied();
        let along = |force: SplineToothForce| if self.radial { force.radial } else { force.tangential };
        Observed::number(width * force.map_or(0.0, along))
    }

    fn frame_of(&self) -> Option<BodyId> {
        Some(self.body)
    }
}
