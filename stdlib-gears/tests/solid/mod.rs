//! Pairs of gears in space, analysed.

mod bearings;
mod both_sides;
mod elastic;
mod helical;
mod ladder;
mod misaligned;
pub mod pairs;
mod runout;
