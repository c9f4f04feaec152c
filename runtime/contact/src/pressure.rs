//! Peak pressure and half-width of a patch from the pressures of its cells.
//!
//! In a Hertzian contact p² is a parabola across the patch, p² = p0² (1 - (x - c)²/a²). A fit to a
//! few cells is accurate to second order in the cell width, although the pressure has a vertical
//! tangent at the ends of the patch.

use nalgebra::{Matrix3, Vector3};
use std::f64::consts::PI;

/// Returns the half-width of a Hertzian line contact, m: a² = 4 q / (pi E* k), for `force` q (N/m),
/// E* in Pa and the relative curvature k in 1/m (Johnson, eq. 4.43).
pub fn hertz_half_width(force: f64, contact_modulus: f64, relative_curvature: f64) -> f64 {
    (4.0 * force / (PI * contact_modulus * relative_curvature)).sqrt()
}

/// Interval of uniform pressure on a line: a cell of a plane patch, or a slice of a
/// three-dimensional one.
pub trait PressureStrip {
    /// Ends, ascending, m.
    fn ends(&self) -> [f64; 2];
}

impl PressureStrip for [f64; 2] {
    fn ends(&self) -> [f64; 2] {
        *self
    }
}

pub(super) fn center(piece: &impl PressureStrip) -> f64 {
    let [from, to] = piece.ends();
    0.5 * (from + to)
}

/// Peak pressure of some cells of a patch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Peak {
    /// Peak pressure, Pa.
    pub pressure: f64,
    /// Location along the tangent, m.
    pub x: f64,
    /// Loaded cell nearest to the location.
    pub cell: usize,
}

/// Number of cells on either side of the largest for the parabola of the peak.
const PEAK_REACH: usize = 2;

/// Returns the peak pressure: the vertex of a parabola through p² of the (at most five) loaded
/// neighbours of the cell with the largest pressure, or that cell's own pressure if the maximum
/// lies at the end of the patch. `None` if no cell is loaded. `pressures` are in Pa, one per cell.
///
/// The outermost loaded cell on a side is loaded over part of its width, so it counts only if there
/// is no other neighbour on that side. Of four or five loaded cells it would raise the vertex by
/// several per cent.
pub fn peak(cells: &[impl PressureStrip], pressures: &[f64]) -> Option<Peak> {
    let belongs = |i: usize| pressures[i] > 0.0;
    let largest = (0..cells.len())
        .filter(|&i| belongs(i))
        .max_by(|&i, &j| pressures[i].total_cmp(&pressures[j]).then(j.cmp(&i)))?;
    let own = Peak { pressure: pressures[largest], x: center(&cells[largest]), cell: largest };
    let loaded_before = (1..=largest).take_while(|k| belongs(largest - k)).count();
    let loaded_after = (largest + 1..cells.len()).take_while(|&i| belongs(i)).count();
    let fitted = |loaded: usize| loaded.min(1).max(loaded.saturating_sub(1)).min(PEAK_REACH);
    let [first, last] = [loaded_before, loaded_after].map(fitted);
    if first == 0 || last == 0 {
        return Some(own);
    }
    let fit = Parabola::through(cells, pressures, largest - first, largest + last);
    Some(match fit.and_then(|f| f.vertex()) {
        // A vertex outside the fitted cells is not their maximum.
        Some((x, squared))
            if squared > 0.0
                && x > cells[largest - first].ends()[0]
                && x < cells[largest + last].ends()[1] =>
        {
            Peak { pressure: squared.sqrt(), x, cell: largest }
        }
        _ => own,
    })
}

/// Returns the half-width of the loaded zone, m: half the distance between the extrapolated zeros
/// of p². `None` with fewer than five loaded cells, or if the fit of p² does not have two zeros.
pub fn half_width(cells: &[impl PressureStrip], pressures: &[f64]) -> Option<f64> {
    zeros_of_squared_pressure(cells, pressures).map(|[left, right]| 0.5 * (right - left))
}

/// Returns the zeros of a parabola fitted to p² of the loaded cells. The fit excludes the outermost
/// cell on each side, which is loaded over part of its width.
pub(super) fn zeros_of_squared_pressure(cells: &[impl PressureStrip], pressures: &[f64]) -> Option<[f64; 2]> {
    let first = pressures.iter().position(|&p| p > 0.0)?;
    let last = pressures.iter().rposition(|&p| p > 0.0)?;
    if last < first + 4 {
        return None;
    }
    Parabola::through(cells, pressures, first + 1, last - 1)?.zeros()
}

/// Smallest pressure, relative to the largest, of the cells from which the extent of a point
/// contact is extrapolated.
const CORE: f64 = 0.6;

/// Returns the half-width like [`half_width`], extrapolated from the core of the contact. Along the
/// boundary of an ellipse, cells are loaded in part, and the pressure of cells next to it is less
/// accurate.
pub(super) fn half_width_of_core(cells: &[impl PressureStrip], pressures: &[f64]) -> Option<f64> {
    let largest = pressures.iter().copied().fold(0.0, f64::max);
    let in_core = |p: &f64| *p >= CORE * largest && *p > 0.0;
    let (first, last) = (pressures.iter().position(in_core)?, pressures.iter().rposition(in_core)?);
    if last < first + 4 {
        return half_width(cells, pressures);
    }
    let [left, right] = Parabola::through(cells, pressures, first, last)?.zeros()?;
    Some(0.5 * (right - left))
}

/// Parabola c0 + c1 u + c2 u², with u = (x - origin) / unit.
struct Parabola {
    origin: f64,
    unit: f64,
    coefficients: [f64; 3],
}

impl Parabola {
    /// Least-squares fit to p² of the cells `first ..= last`, at least three.
    fn through(cells: &[impl PressureStrip], pressures: &[f64], first: usize, last: usize) -> Option<Self> {
        let origin = 0.5 * (cells[first].ends()[0] + cells[last].ends()[1]);
        let unit = 0.5 * (cells[last].ends()[1] - cells[first].ends()[0]);
        let mut normal = Matrix3::zeros();
        let mut right = Vector3::zeros();
        for i in first..=last {
            let u = (center(&cells[i]) - origin) / unit;
            let row = Vector3::new(1.0, u, u * u);
            normal += row * row.transpose();
            right += row * (pressures[i] * pressures[i]);
        }
        let c = normal.lu().solve(&right)?;
        Some(Self { origin, unit, coefficients: [c[0], c[1], c[2]] })
    }

    /// Returns position and value of the maximum.
    fn vertex(&self) -> Option<(f64, f64)> {
        let [c0, c1, c2] = self.coefficients;
        if c2 >= 0.0 {
            return None;
        }
        let u = -0.5 * c1 / c2;
        Some((self.origin + self.unit * u, c0 + 0.5 * c1 * u))
    }

    /// Returns the zeros, ascending.
    fn zeros(&self) -> Option<[f64; 2]> {
        let [c0, c1, c2] = self.coefficients;
        let discriminant = c1 * c1 - 4.0 * c2 * c0;
        (c2 < 0.0 && discriminant > 0.0).then(|| {
            [1.0, -1.0].map(|sign| self.origin + self.unit * (sign * discriminant.sqrt() - c1) / (2.0 * c2))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Hertzian pressure with peak 1, averaged over cells of unit width.
    fn averages(half_width: f64, middle: f64) -> (Vec<[f64; 2]>, Vec<f64>) {
        let primitive = |x: f64| {
            let u = ((x - middle) / half_width).clamp(-1.0, 1.0);
            0.5 * half_width * (u * (1.0 - u * u).sqrt() + u.asin())
        };
        let cells: Vec<[f64; 2]> = (-8..8).map(|k| [f64::from(k), f64::from(k + 1)]).collect();
        let pressures = cells.iter().map(|[from, to]| primitive(*to) - primitive(*from)).collect();
        (cells, pressures)
    }

    #[test]
    fn outermost_cells_hardly_change_the_peak() {
        for (half_width, tolerance) in [(1.6, 0.03), (2.1, 0.015), (2.5, 0.01), (3.0, 0.007), (5.0, 0.003)] {
            let error = |offset: f64| {
                let (cells, pressures) = averages(half_width, offset);
                (peak(&cells, &pressures).map_or(0.0, |peak| peak.pressure) - 1.0).abs()
            };
            let largest = (0..20).map(|k| error(f64::from(k) / 20.0)).fold(0.0, f64::max);
            assert!(largest < tolerance, "half-width of {half_width} cells: {largest}");
        }
    }
}
