//! Bore of a ring as a raceway of rolling elements: its radial displacement as a Fourier series around and
//! Legendre polynomials along it.
//!
//! Elements press on the bore at angles that change with their cage. The structure therefore has no
//! displacement of each, but the coefficients of a series, from which contact outside of the
//! structure ([`super::bore_interface`]) evaluates the displacement at any angle. With the
//! coefficients `c` and the terms `e(t, z)` of the series at a point, a radial force `Q` there has
//! the conjugate forces `e Q`, and the displacement is `e'c`: the force is smoothed to the terms of
//! the series, and so is the displacement.
//!
//! See `docs/theory/rolling-bearings.md`.

use calyx_fe::solid::fourier::{Component, Series, Term};
use calyx_numerics::quadrature::gauss_legendre;
use faer::Mat;
use serde::{Deserialize, Serialize};
use std::f64::consts::PI;

/// Highest degree of the polynomials along a raceway.
pub const HIGHEST_DEGREE: u8 = 5;
/// Number of Gauss points along a contact, exact for the highest degree times a line.
const POINTS: usize = 4;

/// Raceway of rolling elements in a bore about the z axis.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Raceway {
    /// Radius, m.
    pub radius: f64,
    /// Axial coordinates of its ends, m; equal in a plane model.
    pub ends: [f64; 2],
    /// Highest harmonic of the series around it.
    pub harmonics: u16,
    /// Highest degree of the polynomials along it.
    pub degree: u8,
}

impl Raceway {
    /// Returns the number of terms of the series.
    pub fn terms(&self) -> usize {
        (usize::from(self.degree) + 1) * (2 * usize::from(self.harmonics) + 1)
    }

    /// Returns the terms of the series in order.
    fn all(&self) -> impl Iterator<Item = Term> + use<> {
        let harmonics = self.harmonics;
        (0..=self.degree).flat_map(move |degree| {
            (0..=harmonics).flat_map(move |harmonic| {
                [false, true].into_iter().take(1 + usize::from(harmonic > 0)).map(move |sine| Term {
                    component: Component::Radial,
                    degree,
                    harmonic,
                    sine,
                })
            })
        })
    }

    /// Returns the terms at an angle (rad) and an axial coordinate (m).
    pub fn terms_at(&self, angle: f64, z: f64) -> Vec<f64> {
        let along = legendre(self.zeta(z));
        self.all().map(|term| around(&term, angle) * along[usize::from(term.degree)]).collect()
    }

    /// Returns the mean square of each term over the raceway.
    pub fn mean_squares(&self) -> Vec<f64> {
        let of = |term: Term| {
            let around = if term.harmonic == 0 { 1.0 } else { 0.5 };
            around / f64::from(2 * term.degree + 1)
        };
        self.all().map(of).collect()
    }

    /// Returns the means of the Legendre polynomials along a contact of a length (m) whose middle
    /// has an axial coordinate (m), and the derivatives of the lines nearest to them, 1/m. At a
    /// point, of length 0, there are no derivatives.
    fn polynomials_along(&self, z: f64, length: f64) -> [[f64; 2]; HIGHEST_DEGREE as usize + 1] {
        if length == 0.0 {
            return legendre(self.zeta(z)).map(|value| [value, 0.0]);
        }
        let mut along = [[0.0; 2]; HIGHEST_DEGREE as usize + 1];
        for (node, weight) in gauss_legendre(POINTS) {
            let from_middle = 0.5 * length * node;
            for (sum, value) in along.iter_mut().zip(legendre(self.zeta(z + from_middle))) {
                sum[0] += 0.5 * weight * value;
                sum[1] += 0.5 * weight * 12.0 * from_middle / (length * length) * value;
            }
        }
        along
    }

    /// Returns the distributions along the raceway of a unit force and a unit moment of an element,
    /// as far as its polynomials contain them, at a distance (m) from its start: 1/m and 1/m². The
    /// contact has a length (m), 0 for a ball, and its middle an axial coordinate (m).
    pub fn distributions(&self, z: f64, length: f64) -> impl Fn(f64) -> [f64; 2] + use<> {
        let (along, width) = (self.polynomials_along(z, length), self.ends[1] - self.ends[0]);
        let degree = usize::from(self.degree);
        move |from_start| {
            let values = legendre(2.0 * from_start / width - 1.0);
            let part = |which: usize| {
                let term = |n: usize| (2 * n + 1) as f64 / width * along[n][which] * values[n];
                (0..=degree).map(term).sum()
            };
            [part(0), part(1)]
        }
    }

    /// Returns an axial coordinate (m) relative to the middle and half the width of the raceway; 0
    /// in a plane model.
    fn zeta(&self, z: f64) -> f64 {
        let width = self.ends[1] - self.ends[0];
        if width > 0.0 { (2.0 * z - self.ends[0] - self.ends[1]) / width } else { 0.0 }
    }

    /// Returns the terms at an angle (rad) along a contact of a length (m) whose middle has an axial
    /// coordinate (m): their means, and the derivatives along the axis of the lines that are
    /// nearest to them in the mean square, 1/m. In a plane model the derivatives vanish.
    ///
    /// Conjugate to the mean is the uniformly distributed force of a contact, to the derivative the
    /// moment of a linear pressure.
    pub fn terms_along(&self, angle: f64, z: f64, length: f64) -> [Vec<f64>; 2] {
        let along = self.polynomials_along(z, length);
        let part = |which: usize| {
            self.all()
                .map(move |term| around(&term, angle) * along[usize::from(term.degree)][which])
                .collect()
        };
        [part(0), part(1)]
    }

    /// Returns true if a term of the series of a bore contributes to that of the raceway.
    pub(super) fn needs(&self, term: &Term) -> bool {
        term.component == Component::Radial && term.degree <= self.degree && term.harmonic <= self.harmonics
    }

    /// Returns the coefficients of the raceway by the unknowns `places` of the series of a bore.
    /// Rigid parts of its terms are constrained, and so are unknowns that `places` omits.
    fn coefficients(&self, series: &Series, places: &[usize]) -> Option<Mat<f64>> {
        // A plane model has unit length.
        let length = if self.ends[1] > self.ends[0] { self.ends[1] - self.ends[0] } else { 1.0 };
        let mut coefficients = Mat::zeros(self.terms(), places.len());
        for (row, term) in self.all().enumerate() {
            // Reciprocal of the mean square of the term over the bore.
            let around = if term.harmonic == 0 { 2.0 * PI } else { PI };
            let norm = f64::from(2 * term.degree + 1) / (length * around * self.radius);
            for (unknown, amount) in series.amounts(term)? {
                if let Some(place) = places.iter().position(|&place| place == unknown) {
                    coefficients[(row, place)] += norm * amount;
                }
            }
        }
        Some(coefficients)
    }

    /// Builds the raceway on a bore of which some unknowns of the series are constrained. `None` if
    /// the series does not span that of the raceway.
    pub(super) fn on(&self, series: &Series, places: &[usize]) -> Option<RacewayForms> {
        let [[radius, start], [_, end]] = series.surface().generator;
        let middle = series.surface().center[2];
        let raceway = Raceway { radius, ends: [middle + start, middle + end], ..*self };
        Some(RacewayForms { raceway, coefficients: raceway.coefficients(series, places)? })
    }
}

/// Returns the factor of a term that depends on the angle (rad).
fn around(term: &Term, angle: f64) -> f64 {
    let (sine, cosine) = (f64::from(term.harmonic) * angle).sin_cos();
    if term.sine { sine } else { cosine }
}

/// Returns the Legendre polynomials up to [`HIGHEST_DEGREE`] at a coordinate.
fn legendre(zeta: f64) -> [f64; HIGHEST_DEGREE as usize + 1] {
    let mut values = [1.0, zeta, 0.0, 0.0, 0.0, 0.0];
    for n in 1..usize::from(HIGHEST_DEGREE) {
        let k = n as f64;
        values[n + 1] = ((2.0 * k + 1.0) * zeta * values[n] - k * values[n - 1]) / (k + 1.0);
    }
    values
}

/// Raceway before the ring is solved.
#[derive(Clone, Debug)]
pub(super) struct RacewayForms {
    pub raceway: Raceway,
    /// Coefficients by all amplitudes of the bore, constrained ones first.
    pub coefficients: Mat<f64>,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polynomials_along_a_raceway_are_those_of_legendre() {
        let expected = [1.0, 0.5, -0.125, -0.4375, -0.289_062_5, 0.089_843_75];
        for (value, expected) in legendre(0.5).iter().zip(expected) {
            assert!((value - expected).abs() < 1e-15, "{value} {expected}");
        }
        // Means along a roller as long as the raceway: all but the constant vanish.
        let raceway = Raceway { radius: 1.0, ends: [-1.0, 1.0], harmonics: 0, degree: HIGHEST_DEGREE };
        let [means, slopes] = raceway.terms_along(0.3, 0.0, 2.0);
        for (degree, (mean, slope)) in means.iter().zip(&slopes).enumerate() {
            let [one, line] = [0, 1].map(|own| f64::from(u8::from(degree == own)));
            assert!((mean - one).abs() < 1e-14 && (slope - line).abs() < 1e-14, "{degree}: {mean} {slope}");
        }
    }
}
