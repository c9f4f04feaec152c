//! Values of observables, and requests for outputs that are made of them.

use crate::ids::ObservableId;
use calyx_abi::{Kernel, Repr, SymbolicValue};
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// Where on a body something was found.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Place {
    /// Its name.
    pub body: String,
    /// Counted counter-clockwise from 0.
    pub tooth: u32,
    /// rad; absent where there is no involute.
    pub roll_angle: Option<f64>,
    /// m
    pub radius: f64,
    /// Along the axis from the middle of the face, m; absent in a plane model.
    pub axial: Option<f64>,
}

/// The value of an observable at a position, and where it arose if it is a maximum over places.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Observed {
    /// SI
    pub value: f64,
    /// The least of the values that `value` is the largest of, where an observable tells of a range: of the same place of
    /// several teeth, say.
    pub least: Option<f64>,
    /// Of a maximum over places.
    pub place: Option<Place>,
}

impl Observed {
    /// A value that has no place.
    pub const fn number(value: f64) -> Observed {
        Observed { value, least: None, place: None }
    }
}

/// A wanted output: a kernel over time, params and observables.
#[derive(Clone)]
pub struct OutputRequest {
    /// As results call it.
    pub name: String,
    /// What is evaluated.
    pub value: Arc<SymbolicValue>,
    /// The kernel's param inputs.
    pub params: Arc<[f64]>,
}

impl OutputRequest {
    /// The output that is an observable of the scene and nothing more.
    pub fn observing(name: impl Into<String>, observable: ObservableId) -> OutputRequest {
        let observed = vec![observable.0 as f64];
        let value = SymbolicValue::new(0, Repr::Number, Arc::new(Itself), observed, vec![0], Vec::new());
        OutputRequest { name: name.into(), value: Arc::new(value), params: Arc::from([]) }
    }

    /// The output's value at `time` s, given the value of every observable of the scene.
    pub fn evaluate(&self, time: f64, observed: &[Observed]) -> Observed {
        let seen = |index: usize| observed.get(index).map_or(f64::NAN, |seen| seen.value);
        // An output made of one observable keeps that one's place.
        let place = match self.value.observables.as_slice() {
            [at] => observed.get(self.value.captured[*at] as usize).and_then(|seen| seen.place.clone()),
            _ => None,
        };
        let ranges = |index: usize| observed.get(index).is_some_and(|seen| seen.least.is_some());
        let low =
            |index: usize| observed.get(index).map_or(f64::NAN, |seen| seen.least.unwrap_or(seen.value));
        let least = self.observes(ranges).then(|| self.at(time, &low));
        Observed { value: self.at(time, &seen), least, place }
    }

    /// The value at `time` s for these values of observables, by their indices.
    pub fn at(&self, time: f64, observed: &dyn Fn(usize) -> f64) -> f64 {
        let outputs = self.value.evaluate(time, &self.params, observed).unwrap_or_default();
        outputs.first().copied().unwrap_or(f64::NAN)
    }

    /// Whether it depends on an observable that is like this.
    pub fn observes(&self, like: impl Fn(usize) -> bool) -> bool {
        self.value.observes().into_iter().any(like)
    }
}

/// The kernel whose value is what it captured.
struct Itself;

impl Kernel for Itself {
    fn eval(&self, inputs: &[f64], outputs: &mut [f64]) {
        // Time comes first.
        outputs[0] = inputs[1];
    }

    fn inputs(&self) -> usize {
        2
    }

    fn outputs(&self) -> usize {
        1
    }
}
