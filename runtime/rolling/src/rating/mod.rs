//! Load ratings, rating life, static safety and friction.

mod capacity;
mod friction;
mod life;

pub use capacity::{Capacity, bearing_capacity, capacity};
pub use friction::{Friction, FrictionCoefficients, friction, friction_load};
pub use life::{Life, LifeConditions, LoadDirection, life_modification, rating_life, static_safety};
