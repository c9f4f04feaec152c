//! Lugs: the teeth of a spline, or keys, by which the frame holds the bore of a ring at some places around.
//!
//! Their number need not be commensurate with that of the sectors: no sector has a lug of its own, and what lugs do to two teeth depends on
//! where both stand, not only on how far apart. So they are no part of the repeated sector. They remain degrees of freedom of the ring's
//! boundary: a lug's displacement, the mean of the bore's over the lug, is a linear form of the amplitudes of the bore's series
//! ([`super::bore`]), which all sectors share, and its force on the ring is conjugate to it. The ring is solved with these amplitudes held
//! at nought, which leaves its sectors equal; then they are let go, against the lugs.
//!
//! With `K` the stiffness of the ring against its amplitudes `a`, semidefinite because the ring as a whole may move, `h` the forces that held
//! them against the loads, `C` the lugs' displacements by amplitudes and `S` the lugs' compliance,
//!
//! ```text
//! K a = h + C' f,    C a = -S f
//! ```
//!
//! give the lugs' forces `f`. This is positive definite as `C' D C + K` with `D` between nought and `1/S`, and a correction for the rest of
//! the lugs' stiffness, which may be infinite.
//!
//! A lug is seen through the series: up to [`Lugs::waves`] waves around. Its pressure is not quite even and fades beyond its ends over
//! half a wave.

use super::StructureError;
use super::dense::{add_product, cholesky, half_solve, mirror_lower, other_half_solve, product, solve};
use super::ring::FreeRing;
use crate::fe::solid::fourier::{Component, Series, Term};
use faer::{Mat, MatRef};
use serde::{Deserialize, Serialize};
use std::f64::consts::{PI, TAU};

/// Equal lugs, evenly around, that bear both ways. At least three hold a ring.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Lugs {
    /// How many.
    pub count: u16,
    /// Angle of the middle of the first one in the body's frame, rad.
    pub first: f64,
    /// Angle that each takes up, rad.
    pub width: f64,
    /// Displacement around by force, for a unit of the lug's length along the axis, m/(N/m); 0 for rigid ones.
    pub tangential: f64,
    /// The same outwards; `None` where a lug does not hold the bore from moving inwards and outwards.
    pub radial: Option<f64>,
    /// Degree of polynomials along the bore up to which they hold it: 0 holds their mean, 1 its leaning too.
    pub degree: u8,
}

/// Waves by lugs that tell lugs from each other and from an even hold.
const WAVES_BY_LUG: f64 = 3.0;

impl Lugs {
    /// Waves around of the series through which lugs are seen: three a lug, and as many as lugs side by side would take up the circle.
    pub fn waves(&self) -> u16 {
        let waves = (WAVES_BY_LUG * f64::from(self.count)).max(TAU / self.width.abs());
        waves.ceil().min(f64::from(u16::MAX)) as u16
    }

    /// Angle of the middle of a lug in the body's frame, rad.
    pub fn angle(&self, lug: u16) -> f64 {
        self.first + TAU * f64::from(lug) / f64::from(self.count)
    }

    /// Directions in which lugs hold, with what they yield there.
    fn directions(&self) -> Vec<(Component, f64)> {
        let radial = self.radial.map(|compliance| (Component::Radial, compliance));
        [(Component::Tangential, self.tangential)].into_iter().chain(radial).collect()
    }

    /// Whether a term of the series is of the lugs' displacements.
    pub(super) fn needs(&self, term: &Term) -> bool {
        let of_direction = match term.component {
            Component::Tangential => true,
            // A translation, which moves lugs around, is also one wave outwards.
            Component::Radial => self.radial.is_some() || (term.degree, term.harmonic) == (0, 1),
            Component::Axial => false,
        };
        of_direction && term.degree <= self.degree && term.harmonic <= self.waves()
    }

    /// The lugs on a cylindrical bore, seen through some of the unknowns of its series. `None` if these do not span the lugs' displacements.
    pub(super) fn on(&self, series: &Series, places: &[usize]) -> Option<LugForms> {
        let [[radius, start], [_, end]] = series.surface().generator;
        // Of a plane model, a unit.
        let length = if end > start { end - start } else { 1.0 };
        let directions = self.directions();
        let degrees = usize::from(self.degree) + 1;
        let count = usize::from(self.count) * directions.len() * degrees;
        let mut displacements = Mat::zeros(count, places.len());
        let mut compliance = vec![0.0; count];
        for (number, &(component, yielding)) in directions.iter().enumerate() {
            for degree in 0..=self.degree {
                let row =
                    |lug: u16| (usize::from(lug) * directions.len() + number) * degrees + usize::from(degree);
                // Of polynomials along: their mean squares are 1 / (2 d + 1).
                let along = f64::from(2 * degree + 1) / length;
                (0..self.count).for_each(|lug| compliance[row(lug)] = along * yielding);
                for harmonic in 0..=self.waves() {
                    let waves = f64::from(harmonic);
                    let share = if harmonic == 0 { 0.5 } else { sinc(0.5 * waves * self.width) };
                    let mean = along * share / (PI * radius);
                    for sine in [false, true].into_iter().take(1 + usize::from(harmonic > 0)) {
                        let amounts = series.amounts(Term { component, degree, harmonic, sine })?;
                        let amounts = amounts
                            .into_iter()
                            .filter(|(_, amount)| *amount != 0.0)
                            .map(|(unknown, amount)| {
                                Some((places.iter().position(|&place| place == unknown)?, amount))
                            })
                            .collect::<Option<Vec<_>>>()?;
                        for lug in 0..self.count {
                            let (sin, cos) = (waves * self.angle(lug)).sin_cos();
                            let value = mean * if sine { sin } else { cos };
                            for &(place, amount) in &amounts {
                                displacements[(row(lug), place)] += value * amount;
                            }
                        }
                    }
                }
            }
        }
        Some(LugForms { lugs: *self, displacements, compliance })
    }
}

fn sinc(x: f64) -> f64 {
    if x == 0.0 { 1.0 } else { x.sin() / x }
}

/// Lugs before the ring is solved: by lug, direction and polynomial along.
#[derive(Clone, Debug)]
pub(super) struct LugForms {
    pub lugs: Lugs,
    /// By amplitudes of the bore, m.
    pub displacements: Mat<f64>,
    /// m/N, in the plane m/(N/m).
    pub compliance: Vec<f64>,
}

/// Lugs that hold a ring.
#[derive(Clone, Debug)]
pub(crate) struct LugSet {
    pub lugs: Lugs,
    /// Their forces on the ring, by lug, direction and polynomial along, by forces on the amplitudes in the body's frame.
    pub reactions: Mat<f64>,
}

impl LugForms {
    /// Amplitudes by forces on them, from number `first` on, those before being held, with the lugs' forces. `stiffness` is that of the
    /// ring against these amplitudes.
    ///
    /// # Errors
    /// The lugs do not hold the ring, or the series cannot tell them apart.
    pub fn hold(
        &self,
        stiffness: MatRef<'_, f64>,
        first: usize,
    ) -> Result<(Mat<f64>, LugSet), StructureError> {
        let size = stiffness.nrows();
        let lugs = self.displacements.as_ref().subcols(first, size);
        // Of the lugs' stiffness as much as is like the ring's, so that neither drowns the other.
        let trace = |matrix: MatRef<'_, f64>| (0..size).map(|k| matrix[(k, k)]).sum::<f64>();
        let softest = trace(product(lugs.transpose(), lugs).as_ref()) / trace(stiffness);
        let soft: Vec<f64> = self.compliance.iter().map(|compliance| compliance + softest).collect();
        let scaled = Mat::from_fn(lugs.nrows(), size, |row, column| lugs[(row, column)] / soft[row]);
        let mut held = stiffness.to_owned();
        add_product(held.as_mut(), 1.0, lugs.transpose(), scaled.as_ref());
        mirror_lower(&mut held);
        let factor = cholesky(held).ok_or(FreeRing)?;
        let mut release = solve(factor.as_ref(), Mat::identity(size, size));
        mirror_lower(&mut release);
        // The rest of their stiffness.
        let by_forces = product(lugs, release.as_ref());
        let mut yielding = product(by_forces.as_ref(), lugs.transpose());
        for (lug, (compliance, soft)) in self.compliance.iter().zip(&soft).enumerate() {
            yielding[(lug, lug)] += compliance * soft / softest;
        }
        let factor = cholesky(yielding).ok_or(StructureError::CoarseLugs)?;
        let half = half_solve(factor.as_ref(), by_forces);
        add_product(release.as_mut(), -1.0, half.transpose(), half.as_ref());
        mirror_lower(&mut release);
        let mut reactions = other_half_solve(factor.as_ref(), half);
        for column in 0..size {
            for (row, soft) in soft.iter().enumerate() {
                reactions[(row, column)] *= -soft / softest;
            }
        }
        Ok((release, LugSet { lugs: self.lugs, reactions }))
    }
}

/// What a lug exerts on the ring, spread over its place on the bore. In the plane per metre of face width.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LugForce {
    /// Angle of its middle in the body's frame, rad.
    pub angle: f64,
    /// Counter-clockwise, N.
    pub tangential: f64,
    /// Outwards, N.
    pub radial: f64,
}

impl LugSet {
    /// Forces by those on the amplitudes in the body's frame.
    pub fn forces(&self, amplitudes: MatRef<'_, f64>) -> Vec<LugForce> {
        let all = product(self.reactions.as_ref(), amplitudes);
        let (directions, degrees) = (self.lugs.directions().len(), usize::from(self.lugs.degree) + 1);
        let force = |lug: u16| {
            let first = usize::from(lug) * directions * degrees;
            let radial = if directions > 1 { all[(first + degrees, 0)] } else { 0.0 };
            LugForce { angle: self.lugs.angle(lug), tangential: all[(first, 0)], radial }
        };
        (0..self.lugs.count).map(force).collect()
    }

    /// Memory, in bytes.
    pub fn bytes(&self) -> usize {
        self.reactions.nrows() * self.reactions.ncols() * size_of::<f64>()
    }
}
