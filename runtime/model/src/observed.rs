//! Values of observables, and requests for outputs computed from them.

use crate::ids::ObservableId;
use calyx_abi::{Kernel, Repr, SymbolicValue};
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// Point on a body at which a maximum occurs.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Location {
    /// Name of the body.
    pub body: String,
    /// Number of the tooth, counter-clockwise from 0.
    pub tooth: u32,
    /// Roll angle, rad; `None` if the profile has no involute there.
    pub roll_angle: Option<f64>,
    /// Radius, m.
    pub radius: f64,
    /// Axial coordinate in the frame of the body, m: from the middle of the face of a cylindrical
    /// gear. `None` in a plane model.
    pub axial: Option<f64>,
}

/// Value of an observable at a position, with its location if it is a maximum over points.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Observed {
    /// Value in SI units.
    pub value: f64,
    /// Smallest of the values of which `value` is the largest, if the observable is a range, such
    /// as the stress at the same point of several teeth.
    pub least: Option<f64>,
    /// Location of a maximum.
    #[serde(rename = "place")]
    pub location: Option<Location>,
}

impl Observed {
    /// Former name of the field [`Observed::location`].
    #[deprecated(since = "0.1.0", note = "use the field `location`")]
    pub fn place(&self) -> Option<&Location> {
        self.location.as_ref()
    }

    /// Creates a value without a location.
    pub const fn number(value: f64) -> Observed {
        Observed { value, least: None, location: None }
    }
}

/// Requested output: a kernel over time, parameters and observables.
#[derive(Clone)]
pub struct OutputRequest {
    /// Name in results.
    pub name: String,
    /// Expression that is evaluated.
    pub value: Arc<SymbolicValue>,
    /// Parameter inputs of the kernel.
    pub params: Arc<[f64]>,
}

impl OutputRequest {
    /// Creates the output that equals an observable of the scene.
    pub fn observing(name: impl Into<String>, observable: ObservableId) -> OutputRequest {
        let observed = vec![observable.0 as f64];
        let value = SymbolicValue::new(0, Repr::Number, Arc::new(Itself), observed, vec![0], Vec::new());
        OutputRequest { name: name.into(), value: Arc::new(value), params: Arc::from([]) }
    }

    /// Evaluates the output at `time` (s) from the values of all observables of the scene.
    pub fn evaluate(&self, time: f64, observed: &[Observed]) -> Observed {
        let seen = |index: usize| observed.get(index).map_or(f64::NAN, |seen| seen.value);
        // An output that depends on one observable keeps the location of that observable.
        let mut sources = self.value.observes().into_iter();
        let location = match (sources.next(), sources.next()) {
            (Some(only), None) => observed.get(only).and_then(|seen| seen.location.clone()),
            _ => None,
        };
        let ranges = |index: usize| observed.get(index).is_some_and(|seen| seen.least.is_some());
        let low =
            |index: usize| observed.get(index).map_or(f64::NAN, |seen| seen.least.unwrap_or(seen.value));
        let least = self.observes(ranges).then(|| self.at(time, &low));
        Observed { value: self.at(time, &seen), least, location }
    }

    /// Evaluates the output at `time` (s) from values of observables by index.
    pub fn at(&self, time: f64, observed: &dyn Fn(usize) -> f64) -> f64 {
        let outputs = self.value.evaluate(time, &self.params, observed).unwrap_or_default();
        outputs.first().copied().unwrap_or(f64::NAN)
    }

    /// Returns whether the output depends on an observable that satisfies `like`.
    pub fn observes(&self, like: impl Fn(usize) -> bool) -> bool {
        self.value.observes().into_iter().any(like)
    }
}

/// Kernel that returns its observable.
struct Itself;

impl Kernel for Itself {
    fn eval(&self, inputs: &[f64], outputs: &mut [f64]) {
        // Input 0 is the time.
        outputs[0] = inputs[1];
    }

    fn inputs(&self) -> usize {
        2
    }

    fn outputs(&self) -> usize {
        1
    }
}
