//! Sound field of velocity patterns over the frequency: solved at some frequencies, interpolated
//! between them.
//!
//! The quadratic form of the power, divided by the square of the frequency, is smooth: it varies
//! with the size of the body in wavelengths. It is interpolated by polynomials of third degree in
//! the logarithm of the frequency. Intervals are halved until the interpolation at their middle
//! agrees with a solution there.

use super::Lines;
use super::motion::{SurfaceMotion, Vibrating};
use super::plane::extent;
use super::solver::{Solution, Solver};
use calyx_acoustics::{RadiationImpedance, SoundMethod};
use calyx_model::resources::Resources;
use calyx_numerics::error::EngineError;
use faer::{Mat, c64};
use std::f64::consts::TAU;
use std::ops::Range;

/// Largest relative error of the power by interpolation, at the middle of an interval before its
/// solution is added: 0.02 dB.
const TOLERANCE: f64 = 0.005;
/// Largest ratio of a frequency to the next lower one in the first grid.
const RATIO: f64 = 1.6;
/// Largest distance of frequencies in the first grid, in wavenumbers times half the size of the
/// body with its mirror image.
const STEP: f64 = 1.0;
/// Largest number of halvings of an interval, and of solved frequencies.
const HALVINGS: usize = 5;
const MOST: usize = 400;
/// Number of frequencies of an interpolation.
const POINTS: usize = 4;
/// Part of the largest power below which the difference of the far field does not count.
const NOTABLE: f64 = 0.01;
/// Sound field of the patterns of a body.
pub(super) struct Field {
    /// Level of the field.
    pub method: SoundMethod,
    /// Form of the equivalent radiated power.
    equivalent: RadiationImpedance,
    /// Forms of the equivalent radiated powers of the panels.
    equivalent_panels: Vec<RadiationImpedance>,
    solutions: Vec<Solution>,
    /// Distances of the points from the middle of the body, m.
    distances: Vec<f64>,
    wavenumber: f64,
    /// Largest relative error of the power at the middle of an interval, before its solution is
    /// added.
    pub interpolation_error: f64,
    /// Largest relative difference of the powers on the surface and in the far field, of lines with
    /// notable power; NaN without boundary elements.
    pub far_field_difference: f64,
}

/// Velocities that occur near a frequency.
struct Probe<'a> {
    /// Frequency (Hz) and amplitudes, by ascending frequency.
    all: Vec<(f64, &'a [c64])>,
}

impl Probe<'_> {
    fn new<'a>(lines: &Lines<'_>, speeds: &[f64], motions: &[&'a SurfaceMotion]) -> Probe<'a> {
        let mut all: Vec<(f64, &'a [c64])> = Vec::new();
        for (speed, motion) in speeds.iter().zip(motions) {
            for (order, own) in lines.orders.iter().zip(&motion.velocities[0]) {
                let frequency = order * speed / TAU;
                let moves = own.iter().any(|value| value.norm_sqr() > 0.0);
                if frequency > 0.0 && frequency <= lines.highest && moves {
                    all.push((frequency, own));
                }
            }
        }
        all.sort_by(|one, other| one.0.total_cmp(&other.0));
        Probe { all }
    }

    /// Returns the velocities at the frequency that is nearest.
    fn near(&self, frequency: f64) -> Option<&[c64]> {
        let ratio = |at: f64| (at / frequency).ln().abs();
        self.all.iter().min_by(|one, other| ratio(one.0).total_cmp(&ratio(other.0))).map(|found| found.1)
    }

    fn range(&self) -> Option<[f64; 2]> {
        Some([self.all.first()?.0, self.all.last()?.0])
    }
}

impl Field {
    /// Solves the field of a body at the frequencies of all lines and speeds.
    ///
    /// # Errors
    /// Those of the acoustic solution and of the interrupt.
    pub fn new(
        body: &Vibrating,
        method: SoundMethod,
        lines: &Lines<'_>,
        (speeds, motions): (&[f64], &[&SurfaceMotion]),
        resources: &Resources,
    ) -> Result<Field, EngineError> {
        let mesh = &body.surface.skin.mesh;
        let mut field = Field {
            method,
            equivalent: body.equivalent.clone(),
            equivalent_panels: body.equivalent_panels.clone(),
            solutions: Vec::new(),
            distances: body.distances.clone(),
            wavenumber: TAU / body.fluid.speed_of_sound,
            interpolation_error: 0.0,
            far_field_difference: f64::NAN,
        };
        let probe = Probe::new(lines, speeds, motions);
        let Some(range) = probe.range().filter(|_| method != SoundMethod::EquivalentPower) else {
            return Ok(field);
        };
        let solver = Solver::new(body, method, &resources.interrupt);
        let step = STEP / (field.wavenumber * 0.5 * extent(mesh));
        // Powers on the surface and in the far field.
        let mut powers: Vec<[f64; 2]> = Vec::new();
        for frequency in grid(range, step) {
            let solution = solver.solve(frequency, probe.near(frequency), &mut powers)?;
            field.solutions.push(solution);
        }
        // Intervals with the error at the middle of the wider ones from which they come.
        let pairs = field.solutions.windows(2);
        let mut intervals: Vec<([f64; 2], f64)> =
            pairs.map(|pair| ([pair[0].frequency, pair[1].frequency], 0.0)).collect();
        for _ in 0..HALVINGS {
            let mut added = Vec::new();
            let mut remaining = Vec::new();
            for ([low, high], error) in std::mem::take(&mut intervals) {
                let at = (low * high).sqrt();
                let velocities = probe.near(at).filter(|_| field.solutions.len() + added.len() < MOST);
                let Some(velocities) = velocities else {
                    remaining.push(([low, high], error));
                    continue;
                };
                let solved = solver.solve(at, Some(velocities), &mut powers)?;
                let own = field.difference(&solved, velocities);
                match own > TOLERANCE {
                    true => intervals.extend([([low, at], own), ([at, high], own)]),
                    false => field.interpolation_error = field.interpolation_error.max(own),
                }
                added.push(solved);
            }
            intervals.extend(remaining);
            field.solutions.extend(added);
            field.solutions.sort_by(|one, other| one.frequency.total_cmp(&other.frequency));
            if intervals.is_empty() {
                break;
            }
        }
        for (_, error) in intervals {
            field.interpolation_error = field.interpolation_error.max(error);
        }
        let largest = powers.iter().map(|[_, far]| *far).fold(0.0, f64::max);
        let notable = powers.iter().filter(|[_, far]| *far >= NOTABLE * largest);
        let differences = notable.map(|[on_surface, far]| (on_surface / far - 1.0).abs());
        field.far_field_difference = differences.fold(f64::NAN, f64::max);
        Ok(field)
    }

    /// Returns the relative difference between an interpolation and a solution, of the power and of
    /// the pressures at the points.
    fn difference(&self, solved: &Solution, velocities: &[c64]) -> f64 {
        let form = self.interpolated(solved.frequency, |solution| &solution.power);
        let [found, expected] = [&form, &solved.power].map(|form| quadratic(form, velocities));
        let power = (found / expected - 1.0).abs();
        let rows = self.interpolated(solved.frequency, |solution| &solution.pressures);
        let [found, expected] = [&rows, &solved.pressures].map(|rows| products(rows, velocities));
        let size = |values: &[c64]| values.iter().map(|value| value.norm_sqr()).sum::<f64>().sqrt();
        let differences: Vec<c64> = found.iter().zip(&expected).map(|(a, b)| a - b).collect();
        if expected.is_empty() { power } else { power.max(size(&differences) / size(&expected)) }
    }

    /// Interpolates a matrix of the solutions at a frequency, Hz.
    fn interpolated(&self, frequency: f64, of: impl Fn(&Solution) -> &Mat<c64>) -> Mat<c64> {
        let rows = self.solutions.first().map_or(0, |solution| of(solution).nrows());
        self.interpolated_rows(0..rows, frequency, of)
    }

    /// Interpolates some rows of a matrix of the solutions at a frequency, Hz.
    fn interpolated_rows(
        &self,
        rows: Range<usize>,
        frequency: f64,
        of: impl Fn(&Solution) -> &Mat<c64>,
    ) -> Mat<c64> {
        let count = self.solutions.len().min(POINTS);
        let above = self.solutions.partition_point(|solution| solution.frequency < frequency);
        let first = above.saturating_sub(POINTS / 2).min(self.solutions.len() - count);
        let own = &self.solutions[first..first + count];
        let at = frequency.ln();
        let place = |k: usize| own[k].frequency.ln();
        let weight = |k: usize| -> f64 {
            let others = (0..count).filter(|&other| other != k);
            others.map(|other| (at - place(other)) / (place(k) - place(other))).product()
        };
        let weights: Vec<f64> = (0..count).map(weight).collect();
        let columns = of(&own[0]).ncols();
        Mat::from_fn(rows.len(), columns, |i, j| {
            let of_row = |(solution, weight): (&Solution, &f64)| of(solution)[(rows.start + i, j)] * *weight;
            own.iter().zip(&weights).map(of_row).sum()
        })
    }

    /// Returns the power at a frequency (Hz) of these velocities of the coordinates, W.
    pub fn power(&self, frequency: f64, velocities: &[c64]) -> f64 {
        if self.solutions.is_empty() {
            return self.equivalent_power(velocities);
        }
        let form = self.interpolated(frequency, |solution| &solution.power);
        (quadratic(&form, velocities) * frequency * frequency).max(0.0)
    }

    /// Returns the contributions of the panels to [`Field::power`], W, which sum to it; empty
    /// without panels. The intensity on the surface is integrated over each; the difference of
    /// their sum from the power, which is that in the far field, is distributed in proportion to
    /// the equivalent radiated powers.
    pub fn panel_powers(&self, frequency: f64, velocities: &[c64]) -> Vec<f64> {
        let equivalent: Vec<f64> =
            self.equivalent_panels.iter().map(|panel| panel.power(velocities)).collect();
        if self.solutions.is_empty() || equivalent.is_empty() {
            return equivalent;
        }
        let power = |panel: usize| {
            let form = self.interpolated(frequency, |solution| &solution.panels[panel]);
            quadratic(&form, velocities) * frequency * frequency
        };
        let powers: Vec<f64> = (0..equivalent.len()).map(power).collect();
        let difference = self.power(frequency, velocities) - powers.iter().sum::<f64>();
        let total: f64 = equivalent.iter().sum();
        let corrected = |(power, own): (&f64, &f64)| match total > 0.0 {
            true => power + difference * own / total,
            false => *power,
        };
        powers.iter().zip(&equivalent).map(corrected).collect()
    }

    /// Returns the amplitudes of the far field in all directions, Pa·m, relative to the middle of
    /// the body; empty without boundary elements.
    pub fn far_field(&self, frequency: f64, velocities: &[c64]) -> Vec<c64> {
        if self.solutions.is_empty() {
            return Vec::new();
        }
        let rows = self.interpolated(frequency, |solution| &solution.far_field);
        products(&rows, velocities).into_iter().map(|value| value * frequency).collect()
    }

    /// Returns the equivalent radiated power, W.
    pub fn equivalent_power(&self, velocities: &[c64]) -> f64 {
        self.equivalent.power(velocities)
    }

    /// Returns the pressures at all points, Pa.
    pub fn pressures(&self, frequency: f64, velocities: &[c64]) -> Vec<c64> {
        self.pressures_at(0..self.distances.len(), frequency, velocities)
    }

    /// Returns the pressures at some points, Pa.
    pub fn pressures_at(&self, points: Range<usize>, frequency: f64, velocities: &[c64]) -> Vec<c64> {
        // Without velocities there is nothing to solve.
        if self.solutions.is_empty() || points.is_empty() {
            return vec![c64::new(0.0, 0.0); points.len()];
        }
        let rows = self.interpolated_rows(points.clone(), frequency, |solution| &solution.pressures);
        let turned = |(value, distance): (c64, &f64)| {
            value * c64::from_polar(frequency, -self.wavenumber * frequency * distance)
        };
        products(&rows, velocities).into_iter().zip(&self.distances[points]).map(turned).collect()
    }

    /// Returns the number of points at which the pressure is known.
    pub fn point_count(&self) -> usize {
        self.distances.len()
    }

    /// Returns the number of panels, with the rest of the surface.
    pub fn panel_count(&self) -> usize {
        self.equivalent_panels.len()
    }

    /// Returns the frequencies of the solutions, Hz.
    pub fn frequencies(&self) -> Vec<f64> {
        self.solutions.iter().map(|solution| solution.frequency).collect()
    }
}

/// Returns `½ Re(a* R a)`.
fn quadratic(form: &Mat<c64>, amplitudes: &[c64]) -> f64 {
    let mut sum = 0.0;
    for (j, column) in amplitudes.iter().enumerate() {
        let product: c64 = amplitudes.iter().enumerate().map(|(i, row)| row.conj() * form[(i, j)]).sum();
        sum += (product * column).re;
    }
    0.5 * sum
}

fn products(rows: &Mat<c64>, amplitudes: &[c64]) -> Vec<c64> {
    let row = |i: usize| amplitudes.iter().enumerate().map(|(j, a)| rows[(i, j)] * a).sum();
    (0..rows.nrows()).map(row).collect()
}

/// Returns the first grid of frequencies, with both ends of a range. Its distances are larger than
/// a step if there would be too many.
fn grid(range: [f64; 2], step: f64) -> Vec<f64> {
    let mut step = step;
    loop {
        let all = stepped(range, step);
        // Half of the frequencies are for the middles of the intervals.
        if all.len() <= MOST / 2 {
            return all;
        }
        step *= 1.5;
    }
}

fn stepped([low, high]: [f64; 2], step: f64) -> Vec<f64> {
    let mut all = vec![low];
    let mut at = low;
    while at < high {
        at = (at * RATIO).min(at + step).min(high);
        // The last interval is not much shorter than the others.
        if high - at < 0.3 * (RATIO * at - at).min(step) {
            at = high;
        }
        all.push(at);
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_grid_has_both_ends_and_bounded_steps() {
        for (range, step) in [([20.0, 5000.0], 400.0), ([100.0, 101.0], 500.0), ([50.0, 50.0], 10.0)] {
            let found = grid(range, step);
            assert_eq!((found[0], found[found.len() - 1]), (range[0], range[1]));
            for pair in found.windows(2) {
                assert!(pair[1] > pair[0] && pair[1] <= 1.31 * RATIO * pair[0]);
                assert!(pair[1] - pair[0] <= 1.31 * step, "{found:?}");
            }
        }
    }

    #[test]
    fn the_first_grid_of_a_wide_range_has_both_ends_and_room_for_the_middles() {
        for (range, step) in [([100.0, 5000.0], 55.0), ([1e-3, 2e4], 10.0)] {
            let found = grid(range, step);
            assert_eq!((found[0], found[found.len() - 1]), (range[0], range[1]));
            assert!(found.len() <= MOST / 2, "{}", found.len());
        }
    }
}
