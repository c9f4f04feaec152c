//! Newton's method for the loads and half-widths of the strips of contact lines.

use super::strips::{StripLoads, Strips, Work};
use crate::linear::{product, solve_lower, solve_upper};

/// Largest number of Newton steps.
const STEPS: usize = 100;
/// Residual of the approaches relative to the largest one.
pub(super) const TOLERANCE: f64 = 1e-14;
/// Residual at which rounding may stop the iteration.
const STALLED: f64 = 1e-10;

/// Approach without importance, relative to the radius.
const NEGLIGIBLE: f64 = 1e-9;

/// Newton's step of the loads per length and of the squares of the half-widths.
#[derive(Default)]
pub(super) struct Step {
    pub loads: Vec<f64>,
    pub squares: Vec<f64>,
}

impl Strips {
    /// Returns the square of the half-width of a strip without load, by a fixed point that plane
    /// sections reach in one step: that of a vanishing load.
    fn unloaded_square(&self, strip: usize, at: &StripLoads, work: &Work) -> f64 {
        let share = self.strips[strip].length / self.widths[strip];
        let ratio = (1.0 - work.widening[strip] / share).clamp(0.0, 10.0);
        (at.squares[strip] * ratio).max(self.least)
    }

    /// Returns the largest violation of the contact conditions, as an approach relative to the
    /// largest one, and of the conditions of half-widths, weighted by the loads.
    pub(super) fn violation(&self, approaches: &[f64], at: &StripLoads, work: &Work) -> f64 {
        // An approach without importance.
        let largest = approaches.iter().fold(NEGLIGIBLE * self.strips[0].radius, |most, x| most.max(*x));
        let most_loaded = at.loads.iter().fold(f64::MIN_POSITIVE, |most, load| most.max(*load));
        let mut most = 0.0f64;
        for (i, strip) in self.strips.iter().enumerate() {
            let unit = strip.length * self.modulus * largest;
            if at.loads[i] == 0.0 {
                // A better half-width reduces the gap at most by this.
                let change = self.unloaded_square(i, at, work) - at.squares[i];
                let reserve = 0.5 * (work.widening[i] * change).abs();
                most = most.max((reserve - work.gradient[i]) / unit);
                continue;
            }
            most = most.max(work.gradient[i].abs() / unit);
            if at.squares[i] > self.least || work.widening[i] < 0.0 {
                let width = work.widening[i] * self.widths[i] / strip.length;
                most = most.max(0.1 * width.abs() * at.loads[i] / most_loaded);
            }
        }
        most
    }

    /// Starts from the loads of plane sections at a typical ratio of length and half-width.
    pub(super) fn first_loads(&self, approaches: &[f64]) -> StripLoads {
        let load = |approach: &f64| 0.1 * self.modulus * approach.max(0.0);
        let loads: Vec<f64> = approaches.iter().map(load).collect();
        let square = |(load, width): (&f64, &f64)| (width * load).max(self.least);
        let squares = loads.iter().zip(&self.widths).map(square).collect();
        StripLoads { loads, squares }
    }

    /// Solves for the steps of the loads of the free strips at fixed approaches, with half-widths
    /// that follow. `work` has the factors.
    pub(super) fn step_of_loads(&self, work: &Work) -> Vec<f64> {
        let mut right: Vec<f64> = work.free.iter().map(|&i| -work.gradient[i]).collect();
        let mut first = 0;
        for line in &work.widths {
            let mut residual: Vec<f64> = line.strips.iter().map(|&i| work.widening[i]).collect();
            solve_lower(&line.factor, &mut residual);
            for (k, entries) in line.rows.chunks_exact(line.strips.len().max(1)).enumerate() {
                right[first + k] += product(entries, &residual);
            }
            first += line.free;
        }
        solve_lower(&work.factor, &mut right);
        solve_upper(&work.factor, &mut right);
        right
    }

    /// Completes the step of all strips from that of the loads of the free strips.
    pub(super) fn complete(&self, at: &StripLoads, work: &Work, step: &[f64]) -> Step {
        let count = self.strips.len();
        let mut result = Step { loads: vec![0.0; count], squares: vec![0.0; count] };
        for (&i, step) in work.free.iter().zip(step) {
            result.loads[i] = *step;
        }
        let mut first = 0;
        for line in &work.widths {
            // y = -M⁻¹ (e + T' Δw), and the square changes by 2 y / w.
            let mut residual: Vec<f64> = line.strips.iter().map(|&i| work.widening[i]).collect();
            solve_lower(&line.factor, &mut residual);
            for (k, entries) in line.rows.chunks_exact(line.strips.len().max(1)).enumerate() {
                for (entry, value) in residual.iter_mut().zip(entries) {
                    *entry += value * step[first + k];
                }
            }
            first += line.free;
            solve_upper(&line.factor, &mut residual);
            for (&i, value) in line.strips.iter().zip(&residual) {
                result.squares[i] = -2.0 * value / at.loads[i];
            }
        }
        result
    }

    /// Applies a fraction of a step: loads stay at least zero and half-widths positive. Returns the
    /// expected change of the energy.
    pub(super) fn advance(
        &self,
        at: &StripLoads,
        step: &Step,
        fraction: f64,
        work: &Work,
        next: &mut StripLoads,
    ) -> f64 {
        next.clone_from(at);
        let mut change = 0.0;
        for i in 0..self.strips.len() {
            next.loads[i] = (at.loads[i] + fraction * step.loads[i]).max(0.0);
            change += work.gradient[i] * (next.loads[i] - at.loads[i]);
            if at.loads[i] > 0.0 {
                // The step is one of the reciprocal of the square, in which the condition of plane
                // sections is linear.
                let relative = (fraction * step.squares[i] / at.squares[i]).min(0.9);
                next.squares[i] = (at.squares[i] / (1.0 - relative)).max(self.least);
                change += 0.5 * at.loads[i] * work.widening[i] * (next.squares[i] - at.squares[i]);
            } else {
                let square = self.unloaded_square(i, at, work);
                next.squares[i] = square.max(0.1 * self.widths[i] * next.loads[i]);
            }
        }
        change
    }

    /// Minimizes the complementary energy over loads that are not negative and over half-widths by
    /// Newton's method with projection and a line search, from the given loads if there are any.
    /// Returns whether the contact conditions are satisfied. `work` is that of the solution.
    pub(crate) fn solve(&self, approaches: &[f64], at: &mut StripLoads, work: &mut Work) -> bool {
        if at.loads.len() != self.strips.len() || at.loads.iter().all(|load| *load == 0.0) {
            *at = self.first_loads(approaches);
        }
        self.evaluate(approaches, at, work);
        let mut violation = self.violation(approaches, at, work);
        let mut next = StripLoads::default();
        for _ in 0..STEPS {
            if violation <= TOLERANCE {
                return true;
            }
            self.factor(at, work);
            let step = self.complete(at, work, &self.step_of_loads(work));
            let (energy, mut fraction) = (work.energy, 1.0);
            let before = (work.gradient.clone(), work.widening.clone());
            loop {
                let change = self.advance(at, &step, fraction, work, &mut next);
                self.evaluate(approaches, &next, work);
                let after = self.violation(approaches, &next, work);
                if work.energy <= energy + 1e-4 * change.min(0.0) || after < 0.7 * violation {
                    // Rounding hides the rest of the residual.
                    let stalled = violation <= STALLED && after >= 0.5 * violation;
                    violation = after;
                    std::mem::swap(at, &mut next);
                    if stalled {
                        return true;
                    }
                    break;
                }
                fraction *= 0.5;
                if fraction < 1e-10 {
                    self.evaluate(approaches, at, work);
                    return violation <= STALLED;
                }
                work.gradient.clone_from(&before.0);
                work.widening.clone_from(&before.1);
            }
        }
        violation <= STALLED
    }
}
