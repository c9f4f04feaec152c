//! Gears whose tooth is given by tables of boundary points: bevel, hypoid and any other gears.
//!
//! The engine sees no machine. [`table::ToothTable`] contains points of the flanks and fillets of
//! tooth 0 on section cones along the face ([`section`]). The tooth is interpolated from them
//! ([`tooth`]); the interpolant is the contact surface ([`surface`]) and the boundary of the mesh
//! ([`layout`]). Closed-form models take the dimensions of its sections ([`analytic`]).
//!
//! See `docs/theory/tabulated-teeth.md`.

mod analytic;
pub mod bore;
mod boundary;
pub mod known_gears;
mod layout;
pub mod prototype;
pub mod section;
pub mod solid_mesh;
pub(crate) mod spline;
pub mod surface;
pub mod table;
#[cfg(test)]
pub(crate) mod test_teeth;
pub mod tooth;
