//! Pairs of gears in space, analysed.

#[path = "../common/mod.rs"]
mod common;

mod bearings;
mod both_sides;
mod elastic;
mod helical;
mod misaligned;
mod pairs;
mod runout;
