//! Pairs of gears in equilibrium: exact properties, invariance of the results, and reference
//! values.

mod bearings;
mod chapter_5;
mod equilibrium;
mod first_day;
mod friction;
mod given_by_functions;
mod internal;
mod invariance;
mod other_pairs;
mod sharing;
mod supports;

/// Fractions of the mesh cycle of the chapter 5 pair used by the tests: two tooth pairs are in
/// contact up to 0.4925.
const CYCLE: [f64; 5] = [0.02, 0.27, 0.47, 0.51, 0.83];
