//! Three-dimensional pairs of gears: axial forces, hands of the helix, equilibrium and periodicity,
//! bearings, misalignment, runout, both sides of the teeth, and the fidelity levels without meshes.

mod bearings;
mod both_sides;
mod elastic;
mod helical;
mod hollow;
mod ladder;
mod load_factors;
mod misaligned;
pub mod pairs;
mod rolling_bearings;
mod runout;
