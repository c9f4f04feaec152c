//! Tests of the engine, one module per subject. They are one program: it is linked once, and its
//! tests run in parallel.

mod discs;
mod dynamics;
mod dynamics_in_space;
mod extensions;
mod fidelities;
mod helical;
mod impacts;
mod load_path;
mod raceway;
mod ring_on_springs;
mod seat_raceways;
mod solids;
mod tolerance;
mod whole_equations;
