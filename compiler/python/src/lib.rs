//! Extension module `calyx._calyx` of the Python package: the embedding API of the crate `calyx`
//! for the Python code in `calyx/`, which has the public interface.
//!
//! Numbers cross the boundary as bytes, from which NumPy creates arrays without another copy.
//! Models are solved on threads of their own without the GIL; the calling thread waits for messages
//! and handles signals ([`running`]). Errors become the exceptions of `calyx.errors` ([`errors`]).

mod arrays;
mod describe;
mod engines;
mod errors;
mod fields;
mod host;
mod model;
mod results;
mod running;
mod values;

use pyo3::prelude::*;

#[pymodule]
fn _calyx(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
    module.add_class::<model::Model>()?;
    module.add_class::<results::Results>()?;
    module.add_class::<running::Cancel>()?;
    module.add_class::<describe::Units>()?;
    module.add_function(wrap_pyfunction!(engines::configure, module)?)
}
