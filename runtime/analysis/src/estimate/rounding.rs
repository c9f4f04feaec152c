//! Values that are nothing but rounding: what stays of sums whose terms cancel, as the turn of a body that symmetry holds.
//!
//! Such a value differs from one sibling to the next by as much as it is large, and an error of so many hundredths of it says nothing. How small
//! it has to be follows from the scene: places and angles are known to some roundings of where bodies are and of how far they have turned, and
//! forces balance to some roundings of the loads. Stresses, pressures and stiffnesses are no such sums; of these nothing is taken for rounding.

use crate::observe::Quantity;
use crate::scene::Scene;
use calyx_model::observed::{Observed, OutputRequest};

/// Roundings that places and angles are known to: some hundreds of operations lie between a frame and what is solved there.
const OF_PLACES: f64 = 1e3 * f64::EPSILON;
/// Part of the loads that forces balance to where structures share them out: what a flank's place is known to by how far it gives.
const OF_LOADS: f64 = 1e-10;

/// Natural sizes of a scene, SI.
#[derive(Clone, Copy, Debug)]
struct Sizes {
    /// How far out the outermost body reaches.
    length: f64,
    force: f64,
    moment: f64,
}

impl Sizes {
    fn of(scene: &Scene, time: f64) -> Sizes {
        let norm = |vector: [f64; 3]| vector.iter().map(|entry| entry * entry).sum::<f64>().sqrt();
        let mut sizes = Sizes { length: 0.0, force: 0.0, moment: 0.0 };
        for body in &scene.bodies {
            let [.., x, y, z] = body.motion.frame(time);
            let radius = body.prototype.enclosing_radius();
            let load = body.acted_on(time, 1.0);
            let [force, moment] = [load.force, load.moment].map(norm);
            sizes.length = sizes.length.max(norm([x, y, z]) + radius);
            // A moment is borne by forces at most as far out as the body reaches.
            let borne = if radius > 0.0 { moment / radius } else { 0.0 };
            sizes.force = sizes.force.max(force + borne);
            sizes.moment = sizes.moment.max(force * radius + moment);
        }
        sizes
    }

    /// Magnitude up to which a quantity may be nothing but rounding.
    fn rounding(&self, quantity: Quantity) -> f64 {
        match quantity.unit {
            "m" => OF_PLACES * self.length,
            "rad" => OF_PLACES,
            "N" => OF_LOADS * self.force,
            "N*m" => OF_LOADS * self.moment,
            _ => 0.0,
        }
    }
}

/// Magnitude up to which each output may be nothing but rounding at a time (s), near these values of the scene's observables: what it changes by if
/// each of them changes by its rounding.
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
