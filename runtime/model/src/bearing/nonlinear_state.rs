//! State of a bearing with a nonlinear load in the search for equilibrium.

use calyx_rolling::{Displacement, Evaluation, RacewayDisplacement, RacewayLoad, Start};

/// State of the nonlinear load of one bearing in the search for equilibrium.
#[derive(Clone, Debug)]
pub struct NonlinearState {
    /// Deflection: displacement of the first race relative to the second.
    pub deflection: Displacement,
    /// Load on the first race and stiffness there.
    pub evaluation: Evaluation,
    /// Displacement of elastic raceways by element; empty between rigid ones.
    pub raceway: Vec<RacewayDisplacement>,
    /// Loads of the elements on them.
    pub raceway_loads: Vec<RacewayLoad>,
    /// Positions of rolling elements, from which the next evaluation starts.
    pub(super) start: Start,
}
