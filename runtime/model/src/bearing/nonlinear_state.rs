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

/// Difference of two deflections by rounding, relative to their largest component.
const ROUNDING: f64 = 1e-9;

impl NonlinearState {
    /// Returns force and moment on the first race, N and N m.
    pub fn push(&self) -> [f64; 6] {
        let [x, y, z, about_x, about_y] = self.evaluation.load.map(|load| -load);
        [x, y, z, about_x, about_y, 0.0]
    }

    /// Returns true if the state is that of a deflection, except for rounding.
    pub fn is_at(&self, deflection: &[f64; 6]) -> bool {
        let is_near = |components: std::ops::Range<usize>| {
            let largest = components.clone().map(|k| deflection[k].abs()).fold(0.0, f64::max);
            components.clone().all(|k| (self.deflection[k] - deflection[k]).abs() <= ROUNDING * largest)
        };
        is_near(0..3) && is_near(3..5)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_state_is_at_its_deflection_except_for_rounding() {
        let at = |deflection: [f64; 6]| {
            let state = NonlinearState {
                deflection: [2e-6, -1e-5, 0.0, 3e-5, 0.0],
                evaluation: Evaluation::default(),
                raceway: Vec::new(),
                raceway_loads: Vec::new(),
                start: Start::default(),
            };
            state.is_at(&deflection)
        };
        assert!(at([2e-6, -1e-5, 0.0, 3e-5, 0.0, 0.7]));
        assert!(at([2e-6, -1e-5, 1e-20, 3e-5, 1e-20, 0.0]));
        for other in [
            [2.0001e-6, -1e-5, 0.0, 3e-5, 0.0, 0.0],
            [2e-6, -1e-5, 0.0, 3e-5, 1e-12, 0.0],
            [2e-6, -1e-5, 0.0, 0.0, 0.0, 0.0],
            [f64::NAN, -1e-5, 0.0, 3e-5, 0.0, 0.0],
        ] {
            assert!(!at(other), "{other:?}");
        }
    }
}
