//! What the program that embeds a model provides to it by name.

use crate::error::Error;
use calyx_abi::Context;
use calyx_abi::description::ModelDescription;
use calyx_abi::host::{self, HostClosure, HostFunctions, Resolved};
use calyx_gears::deviation::Deviation;
use calyx_gears::host::{ModelHost, Provided};
use calyx_runtime::load::Load;
use std::sync::Arc;

/// What an embedding program provides to a model. Cheap to clone; one may serve any number of instances, also at once.
///
/// ```
/// use calyx_rt::Host;
/// use calyx_runtime::load::Wrench;
/// let host = Host::new()
///     // The model declares `host function friction(in sliding: Velocity) -> Number { return 0.05; }`.
///     .function("friction", |sliding: f64| 0.05 / (1.0 + sliding.abs()))
///     // It makes a body with `host_load = "shaking"`.
///     .load("shaking", |time: f64| Wrench::of_moment([0.0, 0.0, 20.0 * (50.0 * time).sin()]))
///     // It cuts a gear with `gears.host_modification("measured")`.
///     .modification("measured", |roll: f64| 1.5e-6 * (1.0 - (60.0 * roll).cos()));
/// # drop(host);
/// ```
#[derive(Clone, Default)]
pub struct Host {
    functions: HostFunctions,
    scene: Provided,
}

impl Host {
    pub fn new() -> Host {
        Host::default()
    }

    /// Provides a closure in place of the body of the model's `host function` of this name (`module.name` of one in an
    /// imported module). It takes and gives `f64` in coherent SI units, `bool`, `String`, `[f64; 3]`, and `Vec` of these; it may
    /// return a `Result`. Its errors and panics are errors of the model at the call. Runs on several threads call it at once.
    ///
    /// Whether it fits the model is asked where the host is given to an instance.
    #[must_use]
    pub fn function<S>(mut self, name: impl Into<String>, closure: impl HostClosure<S>) -> Host {
        self.functions.add(name, closure);
        self
    }

    /// As [`Host::function`], for a function whose types are known at run time only.
    #[must_use]
    pub fn provided(mut self, name: impl Into<String>, function: host::Provided) -> Host {
        self.functions.add_provided(name, function);
        self
    }

    /// Provides what acts on the bodies that ask for a load of this name, beside their own loads.
    #[must_use]
    pub fn load(mut self, name: impl Into<String>, load: impl Load + 'static) -> Host {
        self.scene.loads.insert(name.into(), Arc::new(load));
        self
    }

    /// Provides what is taken off the flanks of gears that ask for a modification of this name: from the roll angle (rad) to the
    /// amount (m) normal to the involute.
    #[must_use]
    pub fn modification(
        mut self,
        name: impl Into<String>,
        amount: impl Fn(f64) -> f64 + Send + Sync + 'static,
    ) -> Host {
        let name = name.into();
        let deviation = Deviation::new(name.as_str(), amount);
        self.scene.modifications.insert(name, deviation);
        self
    }

    /// What of it a model calls.
    ///
    /// # Errors
    /// The model has no such function, or one with other arguments or another result; the message shows both.
    pub(crate) fn fitted(&self, description: &ModelDescription) -> Result<ResolvedHost, Error> {
        let found = self.functions.resolve(&description.host_functions);
        let functions = found.map_err(|unfit| Error::given(unfit.message, unfit.help))?;
        Ok(ResolvedHost { functions, scene: self.scene.clone() })
    }
}

/// What is provided, as one model uses it.
#[derive(Clone, Default)]
pub(crate) struct ResolvedHost {
    functions: Resolved,
    scene: Provided,
}

impl ResolvedHost {
    /// Gives a context what is provided, before the program runs in it.
    pub(crate) fn provide(&self, context: &mut Context) {
        context.host_functions = self.functions.clone();
        if let Some(host) = context.host::<ModelHost>() {
            host.provided = self.scene.clone();
        }
    }
}
