//! Contact of smooth elastic bodies according to Hertz.

pub mod elliptic;
pub mod line;
pub mod point;
