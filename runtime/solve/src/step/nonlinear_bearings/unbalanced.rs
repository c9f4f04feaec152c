//! Error of bearings that do not balance their loads.

use super::{NonlinearBearings, NonlinearIteration};
use calyx_model::bearing::NonlinearLoad;
use calyx_numerics::error::{EngineError, Subject};

impl NonlinearBearings<'_> {
    pub(super) fn unbalanced(&self, iteration: &NonlinearIteration) -> EngineError {
        let members = self.members.iter().zip(&iteration.states);
        let worst = members.into_iter().find(|(own, _)| own.bearing == iteration.worst);
        let Some((own, state)) = worst else {
            return EngineError::new("E0726", "no deflection of the bearings balances the load", "");
        };
        let [x, y, z, ..] = state.evaluation.load;
        let (force, highest) = (x.hypot(y).hypot(z), own.nonlinear.highest_load());
        let name = &self.system.scene.bearings[own.bearing].name;
        let (what, limit) = match own.nonlinear {
            NonlinearLoad::Rolling(_) => ("rolling bearings", "its static load rating C0"),
            NonlinearLoad::Curves(_) => ("bearings", "the largest force of its load curves"),
        };
        let message = format!(
            "no deflection of the {what} balances the load: the search ended with {} on \"{name}\", {:.3} of {limit} = {}",
            shown_force(force),
            force / highest,
            shown_force(highest)
        );
        let help = match own.nonlinear {
            NonlinearLoad::Rolling(_) if force > highest => {
                "check the unit of the load, or choose larger bearings: the static load rating is the limit of permanent deformation (ISO 76)"
            }
            NonlinearLoad::Rolling(_) => {
                "support the body in every direction of its load: tapered roller bearings carry axial force in the sense of `thrust` only, cylindrical roller and needle bearings none"
            }
            NonlinearLoad::Curves(_) => {
                "check the units of the load and of the curve, and support the body in every direction of its load"
            }
        };
        EngineError::new("E0726", message, help).about(Subject::Bearing(own.bearing))
    }
}

/// Formats a force in N or kN.
fn shown_force(newtons: f64) -> String {
    if newtons < 1e3 { format!("{newtons:.1} N") } else { format!("{:.2} kN", 1e-3 * newtons) }
}
