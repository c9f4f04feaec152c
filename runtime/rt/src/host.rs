//! Functions, loads and modifications that an embedding program provides to a model by name.

use crate::error::Error;
use calyx_abi::Context;
use calyx_abi::description::ModelDescription;
use calyx_abi::host::{self, HostClosure, HostFunctions, Resolved};
use calyx_gears::deviation::Deviation;
use calyx_gears::host::{ModelHost, Provided};
use calyx_runtime::load::Load;
use std::sync::Arc;

/// Functions, loads and modifications that an embedding program provides to a model. Cheap to
/// clone; any number of instances may share one, also concurrently.
///
/// ```
/// use calyx_rt::Host;
/// use calyx_runtime::load::Wrench;
/// let host = Host::new()
///     // The model declares
///     // `host function friction(in sliding: Velocity) -> Number { return 0.05; }`.
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

    /// Provides a closure that replaces the body of the model's `host function` of this name
    /// (`module.name` in an imported module). Its arguments and result are `f64` in coherent SI
    /// units, `bool`, `String`, `[f64; 3]`, and `Vec` of these; it may return a `Result`. Its
    /// errors and panics become errors of the model at the call. Runs on several threads call it
    /// concurrently.
    ///
    /// The signature is checked against the model when an instance receives the host.
    #[must_use]
    pub fn function<S>(mut self, name: impl Into<String>, closure: impl HostClosure<S>) -> Host {
        self.functions.add(name, closure);
        self
    }

    /// Provides a function whose types are known at run time only; otherwise as [`Host::function`].
    #[must_use]
    pub fn provided(mut self, name: impl Into<String>, function: host::Provided) -> Host {
        self.functions.add_provided(name, function);
        self
    }

    /// Provides a load for the bodies that request it by name; it acts in addition to their own
    /// loads.
    #[must_use]
    pub fn load(mut self, name: impl Into<String>, load: impl Load + 'static) -> Host {
        self.scene.loads.insert(name.into(), Arc::new(load));
        self
    }

    /// Provides a flank modification for the gears that request it by name: a function from the
    /// roll angle (rad) to the removed amount (m) normal to the involute.
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

    /// Resolves the functions that a model calls.
    ///
    /// # Errors
    /// The model declares no such function, or one with other arguments or another result; the
    /// message shows both.
    pub(crate) fn fitted(&self, description: &ModelDescription) -> Result<ResolvedHost, Error> {
        let found = self.functions.resolve(&description.host_functions);
        let functions = found.map_err(|unfit| Error::given(unfit.message, unfit.help))?;
        Ok(ResolvedHost { functions, scene: self.scene.clone() })
    }
}

/// The host resolved for one model.
#[derive(Clone, Default)]
pub(crate) struct ResolvedHost {
    functions: Resolved,
    scene: Provided,
}

impl ResolvedHost {
    /// Passes the host to a context, before the program runs in it.
    pub(crate) fn provide(&self, context: &mut Context) {
        context.host_functions = self.functions.clone();
        if let Some(host) = context.host::<ModelHost>() {
            host.provided = self.scene.clone();
        }
    }
}
