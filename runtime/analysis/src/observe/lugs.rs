//! What the lugs of a body do to it: those that hold it as part of its structure, and those with clearance, which bear by contact.

use super::{Equilibrium, Observable, Quantity};
use calyx_model::flanks::arms_at;
use calyx_model::ids::BodyId;
use calyx_model::lug_contact::LugContact;
use calyx_model::observed::Observed;
use calyx_solve::system::Bodies;
use calyx_structure::LugForce;

impl Equilibrium<'_> {
    /// The lugs by which a body rests by contact, with the forces on their flanks, in the unit of the problem's.
    fn lugs_by_contact(&self, body: BodyId) -> Option<(&LugContact, &[f64])> {
        let mut first = self.system.stops();
        for (index, contact) in &self.system.lugs {
            let flanks = first..first + contact.flanks();
            if *index == body.0 {
                // Where nothing is pressed there are none.
                return Some((contact, self.step.stops.get(flanks).unwrap_or_default()));
            }
            first = flanks.end;
        }
        None
    }

    /// The forces of these lugs on the body, counter-clockwise, in the unit of the problem's; none of a body without such lugs.
    pub(super) fn loose_lug_forces(&self, body: BodyId) -> Vec<f64> {
        self.lugs_by_contact(body).map_or_else(Vec::new, |(contact, flanks)| contact.around(flanks))
    }

    /// What these lugs do to the body's frame, as [`Equilibrium::contact_force`] counts it: force (N) and moment about the body's axle (N m).
    pub fn lugs_on(self, body: BodyId) -> [f64; 6] {
        let mut total = [0.0; 6];
        let Some((contact, flanks)) = self.lugs_by_contact(body) else { return total };
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

/// The force of one of the lugs that hold a body on it, N: around, counter-clockwise, or outwards; 0 of a body without such a lug. Of lugs
/// without clearance it is the contact of teeth that they bear, not the inertia nor what acts on the frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LugLoad {
    /// Which body.
    pub body: BodyId,
    /// Which lug, from the first one on counter-clockwise.
    pub lug: u32,
    /// Outwards instead of around.
    pub radial: bool,
}

impl Observable for LugLoad {
    fn quantity(&self) -> Quantity {
        Quantity::passing("lug_force", "N")
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        let width = at.system.width(self.body.0);
        if at.lugs_by_contact(self.body).is_some() {
            let force = at.loose_lug_forces(self.body).get(self.lug as usize).copied().unwrap_or_default();
            return Observed::number(if self.radial { 0.0 } else { width * force });
        }
        let forces = match &at.system.bodies {
            Bodies::Plane(bodies) => {
                let structure = bodies.structures.get(self.body.0).and_then(Option::as_ref);
                structure.map(|structure| structure.lug_forces(&at.surface_loads(self.body)))
            }
            Bodies::Solid(bodies) => {
                let structure = bodies.structures.get(self.body.0).and_then(Option::as_ref);
                structure.map(|structure| structure.lug_forces(&at.spot_loads(self.body)))
            }
        };
        let force = forces.unwrap_or_default().get(self.lug as usize).copied();
        let along = |force: LugForce| if self.radial { force.radial } else { force.tangential };
        Observed::number(width * force.map_or(0.0, along))
    }

    fn frame_of(&self) -> Option<BodyId> {
        Some(self.body)
    }
}
