//! Newmark's family of time integration schemes (report 2.1, table 2.1) in acceleration form.
//!
//! The report's three-point form subtracts displacements of neighbouring steps, which at small
//! steps differ only in their last digits. Here the state consists of displacement, velocity and
//! acceleration. The unknown of a step is `y`, the difference between the displacement at its end
//! and the predicted one: `y = beta h² a`. No small quantity is a difference of large ones.

/// Scheme of the family.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scheme {
    /// Weight of the acceleration at the end of a step in its displacement.
    pub beta: f64,
    /// Weight of the acceleration at the end of a step in its velocity. 1/2 gives second order
    /// without numerical damping.
    pub gamma: f64,
}

impl Scheme {
    /// Average acceleration (trapezoidal rule): unconditionally stable, second order, no numerical
    /// damping.
    pub const AVERAGE: Scheme = Scheme { beta: 0.25, gamma: 0.5 };

    /// Schemes of table 2.1 by name. Central differences are excluded: with beta = 0 contact at the
    /// end of a step does not affect the step. The printed value 1/10 for linear acceleration is a
    /// misprint.
    pub const ALL: [(&'static str, Scheme); 5] = [
        ("average_acceleration", Scheme::AVERAGE),
        ("linear_acceleration", Scheme { beta: 1.0 / 6.0, gamma: 0.5 }),
        ("fox_goodwin", Scheme { beta: 1.0 / 12.0, gamma: 0.5 }),
        ("galerkin", Scheme { beta: 0.8, gamma: 1.5 }),
        ("backward_difference", Scheme { beta: 1.0, gamma: 1.5 }),
    ];

    /// Returns a scheme by its name.
    pub fn named(name: &str) -> Option<Scheme> {
        Scheme::ALL.into_iter().find(|(known, _)| *known == name).map(|(_, scheme)| scheme)
    }

    /// Predicts the end of a step of length `h` (s): displacement and velocity without the
    /// acceleration at the end, which is left unchanged.
    pub fn predicted(&self, state: &State, h: f64) -> State {
        let Scheme { beta, gamma } = *self;
        let coordinates = state.displacement.iter().zip(&state.velocity).zip(&state.acceleration);
        let displacement = coordinates.map(|((x, v), a)| x + h * v + h * h * (0.5 - beta) * a).collect();
        let both = state.velocity.iter().zip(&state.acceleration);
        let velocity = both.map(|(v, a)| v + h * (1.0 - gamma) * a).collect();
        State { displacement, velocity, acceleration: state.acceleration.clone() }
    }

    /// Returns the end of the step, whose displacement exceeds the predicted one by `y`.
    pub fn corrected(&self, predicted: State, y: &[f64], h: f64) -> State {
        let by = (self.beta * h * h).recip();
        let acceleration: Vec<f64> = y.iter().map(|y| by * y).collect();
        let State { mut displacement, mut velocity, .. } = predicted;
        displacement.iter_mut().zip(y).for_each(|(x, y)| *x += y);
        velocity.iter_mut().zip(&acceleration).for_each(|(v, a)| *v += self.gamma * h * a);
        State { displacement, velocity, acceleration }
    }

    /// Returns the factors of mass, damping and stiffness in the effective matrix of the unknown
    /// `y`.
    pub fn weights(&self, h: f64) -> [f64; 3] {
        let square = self.beta * h * h;
        [square.recip(), self.gamma * h / square, 1.0]
    }
}

/// Displacements, velocities and accelerations of all coordinates, SI units.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct State {
    /// Displacements, m or rad; m sqrt(kg/m) for modal coordinates.
    pub displacement: Vec<f64>,
    /// Velocities, the same units per second.
    pub velocity: Vec<f64>,
    /// Accelerations, the same units per second squared.
    pub acceleration: Vec<f64>,
}

impl State {
    /// Creates a state at rest.
    pub fn at_rest(displacement: Vec<f64>) -> State {
        let count = displacement.len();
        State { displacement, velocity: vec![0.0; count], acceleration: vec![0.0; count] }
    }

    /// Returns all values as one row for storage.
    pub fn to_row(&self) -> Vec<f64> {
        [self.displacement.as_slice(), &self.velocity, &self.acceleration].concat()
    }

    /// Restores a state from [`State::to_row`]; `None` if it has another number of coordinates.
    pub fn of_row(row: &[f64], count: usize) -> Option<State> {
        let part = |k: usize| row.get(k * count..(k + 1) * count).map(<[f64]>::to_vec);
        if row.len() != 3 * count {
            return None;
        }
        Some(State { displacement: part(0)?, velocity: part(1)?, acceleration: part(2)? })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two masses (2 and 1 kg) on springs k1 to ground and k2 between, from rest under a step force
    /// on the first; the schemes alone.
    fn end(scheme: Scheme, steps: usize, duration: f64) -> [f64; 2] {
        let (m, k) = ([2.0, 1.0], [[500.0, -200.0], [-200.0, 200.0]]);
        let force = [3.0, 0.0];
        let h = duration / steps as f64;
        let mut state = State::at_rest(vec![0.0; 2]);
        state.acceleration = vec![force[0] / m[0], 0.0];
        let [mass, _, stiffness] = scheme.weights(h);
        let s = [[0, 1], [2, 3]].map(|row: [usize; 2]| {
            row.map(|entry| {
                let (i, j) = (entry / 2, entry % 2);
                stiffness * k[i][j] + if i == j { mass * m[i] } else { 0.0 }
            })
        });
        let det = s[0][0] * s[1][1] - s[0][1] * s[1][0];
        for _ in 0..steps {
            let predicted = scheme.predicted(&state, h);
            let x = &predicted.displacement;
            let g = [0, 1].map(|i: usize| force[i] - k[i][0] * x[0] - k[i][1] * x[1]);
            let y = [(s[1][1] * g[0] - s[0][1] * g[1]) / det, (s[0][0] * g[1] - s[1][0] * g[0]) / det];
            state = scheme.corrected(predicted, &y, h);
        }
        [state.displacement[0], state.displacement[1]]
    }

    /// Modal solution with the roots of det(K - l M) = 0, [500 - 2 l, -200; -200, 200 - l]: l² -
    /// 450 l + 30000 = 0.
    fn exact(time: f64) -> [f64; 2] {
        let root = f64::sqrt(450.0 * 450.0 - 120_000.0);
        let mut x = [0.0; 2];
        for square in [0.5 * (450.0 - root), 0.5 * (450.0 + root)] {
            // Shape (1, 200 / (200 - l)), modal mass 2 + shape².
            let shape = [1.0, 200.0 / (200.0 - square)];
            let mass = 2.0 + shape[1] * shape[1];
            let amplitude = 3.0 / mass / square * (1.0 - (square.sqrt() * time).cos());
            x = [x[0] + amplitude * shape[0], x[1] + amplitude * shape[1]];
        }
        x
    }

    #[test]
    fn schemes_of_the_second_order_converge_as_that_to_the_exact_motion() {
        for name in ["average_acceleration", "linear_acceleration"] {
            let scheme = Scheme::named(name).expect("known");
            let meant = exact(1.0);
            let found: Vec<[f64; 2]> = (0..6).map(|k| end(scheme, 500 << k, 1.0)).collect();
            let error = |k: usize| (found[k][0] - meant[0]).hypot(found[k][1] - meant[1]);
            for k in 0..5 {
                let order = (error(k) / error(k + 1)).log2();
                assert!((order - 2.0).abs() < 0.02, "{name} {k}: {order}");
            }
            // Richardson extrapolation of the last three.
            let once =
                |k: usize| [0, 1].map(|i: usize| found[k + 1][i] + (found[k + 1][i] - found[k][i]) / 3.0);
            let (coarse, fine) = (once(3), once(4));
            let size = meant[0].hypot(meant[1]);
            for i in 0..2 {
                let twice = fine[i] + (fine[i] - coarse[i]) / 15.0;
                assert!((twice - meant[i]).abs() < 1e-8 * size, "{name}: {twice} {}", meant[i]);
            }
        }
    }

    /// The Fox-Goodwin scheme is of fourth order for undamped motions with a smooth start, as here
    /// in the accelerations.
    #[test]
    fn fox_goodwin_is_of_the_fourth_order() {
        let scheme = Scheme::named("fox_goodwin").expect("known");
        let meant = exact(1.0);
        let error = |steps| {
            let found = end(scheme, steps, 1.0);
            (found[0] - meant[0]).hypot(found[1] - meant[1])
        };
        let order = (error(400) / error(800)).log2();
        assert!((order - 4.0).abs() < 0.1 || (order - 2.0).abs() < 0.1, "{order}");
    }

    /// The trapezoidal rule conserves energy exactly in every step, so the change over a million
    /// steps is rounding.
    #[test]
    fn a_million_steps_add_rounding_only() {
        let (scheme, h, square) = (Scheme::AVERAGE, 1e-3_f64, 400.0);
        let [mass, _, stiffness] = scheme.weights(h);
        let mut state = State::at_rest(vec![1.0]);
        state.acceleration = vec![-square];
        let energy = |state: &State| {
            0.5 * (state.velocity[0] * state.velocity[0]
                + square * state.displacement[0] * state.displacement[0])
        };
        let before = energy(&state);
        for _ in 0..1_000_000 {
            let predicted = scheme.predicted(&state, h);
            let y = -square * predicted.displacement[0] / (mass + stiffness * square);
            state = scheme.corrected(predicted, &[y], h);
        }
        let gained = energy(&state) / before - 1.0;
        assert!(gained.abs() < 1e-11, "{gained:e}");
    }

    /// With steps of a billionth of the period the first oscillation is exact to rounding; the
    /// three-point form would have lost all digits.
    #[test]
    fn the_smallest_steps_keep_their_digits() {
        let (scheme, square) = (Scheme::AVERAGE, 1.0);
        let h = std::f64::consts::TAU * 1e-9;
        let [mass, _, stiffness] = scheme.weights(h);
        let mut state = State::at_rest(vec![1.0]);
        state.acceleration = vec![-square];
        for _ in 0..1000 {
            let predicted = scheme.predicted(&state, h);
            let y = -square * predicted.displacement[0] / (mass + stiffness * square);
            state = scheme.corrected(predicted, &[y], h);
        }
        let time = 1000.0 * h;
        assert!((state.velocity[0] / -time.sin() - 1.0).abs() < 1e-12, "{}", state.velocity[0] / -time.sin());
    }
}
