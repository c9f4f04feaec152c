//! x
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cell { pub x: [f64; 2], pub edge: bool }
impl Cell { pub fn center(&self) -> f64 { 0.5 * (self.x[0] + self.x[1]) } }
