//! What contact, frames and stresses see of modes.
