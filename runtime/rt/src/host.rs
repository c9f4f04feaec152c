//! What the program that embeds a model provides to it by name.

use calyx_abi::Context;

/// What an embedding program provides to a model. Cheap to clone; one may serve any number of instances.
#[derive(Clone, Default)]
pub struct Host {}

impl Host {
    /// Gives a context what is provided, before the program runs in it.
    pub(crate) fn provide(&self, _context: &mut Context) {}
}
