//! Log of the inputs at which kernels returned NaN, so that an error can report the origin of the
//! NaN.

use calyx_abi::limits::Limits;
use calyx_abi::{Cancel, Kernel};
use std::collections::HashMap;
use std::sync::{Arc, Mutex, PoisonError};

/// Inputs at which the kernels of one run returned NaN. Clones share the log.
#[derive(Clone, Default)]
pub struct NanLog {
    state: Arc<Mutex<State>>,
    /// Cancellation of the run, and of the computations that explain its failure.
    pub cancel: Cancel,
    pub limits: Limits,
}

#[derive(Default)]
struct State {
    inputs: HashMap<usize, Vec<f64>>,
    last: Option<usize>,
}

impl NanLog {
    /// Creates a log for a run with this cancellation and these limits.
    pub fn new(cancel: Cancel, limits: Limits) -> NanLog {
        NanLog { cancel, limits, ..NanLog::default() }
    }

    /// Wraps the kernels, one per site, so that they record inputs with a NaN result.
    pub fn watched(&self, kernels: Vec<Arc<dyn Kernel>>) -> Vec<Arc<dyn Kernel>> {
        let watch =
            |(site, kernel)| Arc::new(Watched { kernel, site, seen: self.clone() }) as Arc<dyn Kernel>;
        kernels.into_iter().enumerate().map(watch).collect()
    }

    /// Returns the last inputs at which the kernel of a site returned NaN.
    pub fn inputs(&self, site: usize) -> Option<Vec<f64>> {
        self.with(|state| state.inputs.get(&site).cloned())
    }

    /// Returns the site whose kernel returned NaN last.
    pub fn last(&self) -> Option<usize> {
        self.with(|state| state.last)
    }

    fn note(&self, site: usize, inputs: &[f64]) {
        self.with(|state| {
            state.inputs.insert(site, inputs.to_vec());
            state.last = Some(site);
        });
    }

    fn with<R>(&self, ask: impl FnOnce(&mut State) -> R) -> R {
        ask(&mut self.state.lock().unwrap_or_else(PoisonError::into_inner))
    }
}

struct Watched {
    kernel: Arc<dyn Kernel>,
    site: usize,
    seen: NanLog,
}

impl Kernel for Watched {
    fn eval(&self, inputs: &[f64], outputs: &mut [f64]) {
        self.kernel.eval(inputs, outputs);
        let count = self.kernel.outputs().min(outputs.len());
        if outputs[..count].iter().any(|output| output.is_nan()) {
            self.seen.note(self.site, inputs);
        }
    }

    fn inputs(&self) -> usize {
        self.kernel.inputs()
    }

    fn outputs(&self) -> usize {
        self.kernel.outputs()
    }
}
