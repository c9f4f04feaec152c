//! Analyses that a model can request with `analyze`: [`ANALYSES`] registers them by name.

use crate::dynamics_externs::motion_in_time;
use crate::externs::refusal;
use crate::host::ModelHost;
use calyx_abi::RuntimeError;
use calyx_abi::externs::Handle;
use calyx_runtime::analyses::Analysis;
use calyx_runtime::analysis::Position;
use calyx_runtime::method::QuasiStatic;
use std::borrow::Cow;
use std::sync::Arc;

/// Arguments of `analyze` from which an analysis takes its options.
pub(crate) struct Arguments<'a> {
    /// Handle of the list of positions.
    pub over: Handle,
    /// These positions, without those that a settings override leaves out.
    pub positions: Vec<Position>,
    /// Name of the time integration scheme.
    pub newmark: &'a str,
    /// Factors of Rayleigh damping on mass, 1/s, and on stiffness, s.
    pub rayleigh: [f64; 2],
    /// Name of the initial state.
    pub start: &'a str,
}

/// Creates an analysis from arguments of `analyze`.
type Create = fn(&ModelHost, Arguments<'_>) -> Result<Arc<dyn Analysis>, RuntimeError>;

/// Analyses by the `method` of `analyze`, which `prelude.cx` declares with the same choices.
const ANALYSES: &[(&str, Create)] = &[("quasi_static", quasi_static), ("dynamic", dynamic)];

/// Returns the names of all analyses.
pub fn names() -> impl Iterator<Item = &'static str> {
    ANALYSES.iter().map(|(name, _)| *name)
}

/// Creates the analysis of a name.
pub(crate) fn create(
    host: &ModelHost,
    method: &str,
    arguments: Arguments<'_>,
) -> Result<Arc<dyn Analysis>, RuntimeError> {
    let Some((_, create)) = ANALYSES.iter().find(|(name, _)| *name == method) else {
        let known: Vec<String> = names().map(|name| format!("\"{name}\"")).collect();
        let message = format!("there is no analysis called \"{method}\"");
        return Err(refusal("E0679", "method", &message, &format!("choose {}", known.join(" or "))));
    };
    create(host, arguments)
}

fn quasi_static(_: &ModelHost, arguments: Arguments<'_>) -> Result<Arc<dyn Analysis>, RuntimeError> {
    Ok(Arc::new(QuasiStatic { positions: Cow::Owned(arguments.positions) }))
}

fn dynamic(host: &ModelHost, arguments: Arguments<'_>) -> Result<Arc<dyn Analysis>, RuntimeError> {
    Ok(Arc::new(motion_in_time(host, &arguments)?))
}
