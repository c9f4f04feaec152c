//! Rounding errors of outputs: residues of sums whose terms cancel, such as the rotation of a body
//! that symmetry prevents.
//!
//! Such a value differs between perturbed solves by its own size, so a relative error is
//! meaningless. The threshold follows from the scene: positions and angles are accurate to some
//! roundings of the bodies' positions and rotations, and forces balance to some roundings of the
//! loads. Stresses, pressures and stiffnesses are not such sums and are never treated as rounding.

use crate::observables::Quantity;
use crate::scene::Scene;
use calyx_model::observed::{Observed, OutputRequest};
use calyx_model::pairs::SurfacePair;

/// Relative accuracy of positions and angles: some hundreds of operations lie between a frame and
/// the solution.
const OF_PLACES: f64 = 1e3 * f64::EPSILON;
/// The same for gears on general axes, whose flanks are interpolated.
const OF_INTERPOLATED_PLACES: f64 = 2e-9;
/// Fraction of the loads to which forces balance where structures distribute them: the accuracy of
/// a flank's position relative to its deflection.
const OF_LOADS: f64 = 1e-10;

/// Scales of a scene, SI.
#[derive(Clone, Copy, Debug)]
struct Sizes {
    /// Relative accuracy of positions and angles.
    places: f64,
    /// Largest outer radius of a body.
    length: f64,
    force: f64,
    moment: f64,
}

impl Sizes {
    fn of(scene: &Scene, time: f64) -> Sizes {
        let norm = |vector: [f64; 3]| vector.iter().map(|entry| entry * entry).sum::<f64>().sqrt();
        let general =
            |pair: &SurfacePair| pair.mesh.as_ref().is_some_and(|mesh| mesh.first_contact.is_some());
        let places = if scene.pairs.iter().any(general) { OF_INTERPOLATED_PLACES } else { OF_PLACES };
        let mut sizes = Sizes { places, length: 0.0, force: 0.0, moment: 0.0 };
        for body in &scene.bodies {
            let [.., x, y, z] = body.motion.frame(time);
            let radius = body.prototype.enclosing_radius();
            let load = body.acted_on(time, 1.0);
            let [force, moment] = [load.force, load.moment].map(norm);
            sizes.length = sizes.length.max(norm([x, y, z]) + radius);
            // Forces that balance a moment act at most at the outer radius of the body.
            let force_of_moment = if radius > 0.0 { moment / radius } else { 0.0 };
            sizes.force = sizes.force.max(force + force_of_moment);
            sizes.moment = sizes.moment.max(force * radius + moment);
        }
        sizes
    }

    /// Returns the magnitude up to which a quantity may consist of rounding.
    fn rounding(&self, quantity: Quantity) -> f64 {
        match quantity.unit {
            "m" => self.places * self.length,
            "rad" => self.places,
            "N" => OF_LOADS * self.force,
            "N*m" => OF_LOADS * self.moment,
            _ => 0.0,
        }
    }
}

/// Returns the magnitude up to which each output may consist of rounding at a time (s), near these
/// values of the scene's observables: its change if each observable changes by its rounding.
pub(crate) fn of_outputs(
    scene: &Scene,
    outputs: &[OutputRequest],
    observed: &[Observed],
    time: f64,
) -> Vec<f64> {
    let sizes = Sizes::of(scene, time);
    let of_output = |output: &OutputRequest| {
        let own = output.evaluate(time, observed).value;
        let shifted = |index: usize| {
            let by = sizes.rounding(scene.observables[index].quantity());
            if by == 0.0 {
                return 0.0;
            }
            let mut observed = observed.to_vec();
            observed[index].value += by;
            (output.evaluate(time, &observed).value - own).abs()
        };
        let sum: f64 = output.value.observes().into_iter().map(shifted).sum();
        if sum.is_finite() { sum } else { 0.0 }
    };
    outputs.iter().map(of_output).collect()
}
