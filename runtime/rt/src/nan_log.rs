//! Notes of a run: the inputs at which kernels gave NaN, so that an error can say where that arose.

use calyx_abi::limits::Limits;
use calyx_abi::{Cancel, Kernel};
use std::collections::HashMap;
use std::sync::{Arc, Mutex, PoisonError};

/// Inputs at which the kernels of one run gave NaN. Clones share their notes.
#[derive(Clone, Default)]
pub struct NanLog {
    state: Arc<Mutex<State>>,
    /// What ends the run, and whatever is done to explain how it ended.
    pub cancel: Cancel,
    pub limits: Limits,
}

#[derive(Default)]
struct State {
    inputs: HashMap<usize, Vec<f64>>,
    last: Option<usize>,
}

impl NanLog {
    /// Notes of a run that ends by these.
    pub fn new(cancel: Cancel, limits: Limits) -> NanLog {
        NanLog { cancel, limits, ..NanLog::default() }
    }

    /// Kernels, one per site, that note it when NaN comes out of them.
    pub fn watched(&self, kernels: Vec<Arc<dyn Kernel>>) -> Vec<Arc<dyn Kernel>> {
        let watch =
            |(site, kernel)| Arc::new(Watched { kernel, site, seen: self.clone() }) as Arc<dyn Kernel>;
        kernels.into_iter().enumerate().map(watch).collect()
    }

    /// Inputs at which the kernel of a site gave NaN last.
    pub fn inputs(&self, site: usize) -> Option<Vec<f64>> {
        self.with(|state| state.inputs.get(&site).cloned())
    }

    /// The site whose kernel gave NaN last.
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
