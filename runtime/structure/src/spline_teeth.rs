//! Spline teeth, or keys, through which the frame supports the bore of a ring at some angular
//! positions.
//!
//! Their number need not be commensurate with that of the sectors. The coupling of two teeth
//! through them depends on the positions of both teeth, not only on their distance, so spline teeth
//! cannot be part of the repeated sector. They act on degrees of freedom of the ring's boundary
//! instead. The displacement of a spline tooth is the mean displacement of the bore over the tooth.
//! It is a linear form of the amplitudes of the bore's series ([`super::bore`]), which all sectors
//! share; the force of the spline tooth on the ring is conjugate to it. The ring is first solved
//! with these amplitudes fixed at zero, which keeps its sectors equal; then the amplitudes are
//! released against the spline teeth.
//!
//! Let `K` be the stiffness of the ring against its amplitudes `a`, semidefinite because of the
//! ring's rigid-body motion, `h` the constraint forces of the amplitudes under the loads, `C` the
//! displacements of the spline teeth by amplitudes and `S` the compliance of the spline teeth. Then
//!
//! ```text
//! K a = h + C' f,    C a = -S f
//! ```
//!
//! determine the forces `f` of the spline teeth. The system is solved as the positive definite
//! `C' D C + K`, with `D` between zero and `1/S`, and a correction for the rest of the stiffness of
//! the spline teeth, which may be infinite.
//!
//! The series resolves a spline tooth up to [`SplineTeeth::harmonics`] harmonics around the bore.
//! The pressure of a tooth is therefore not quite uniform and decays beyond its ends over half a
//! wavelength.
//!
//! See `docs/theory/substructures.md`.

use super::StructureError;
use super::dense::{Interruptible, mirror_lower, product};
use super::error::UnrestrainedRing;
use calyx_fe::solid::fourier::{Component, Series, Term};
use calyx_numerics::interrupt::Interrupt;
use faer::{Mat, MatRef};
use serde::{Deserialize, Serialize};
use std::f64::consts::{PI, TAU};

/// Equal, uniformly spaced spline teeth that carry load in both directions. At least three support
/// a ring.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct SplineTeeth {
    /// Number of spline teeth.
    pub count: u16,
    /// Angle of the middle of the first spline tooth in the body's frame, rad.
    pub first: f64,
    /// Angular width of each spline tooth, rad.
    pub width: f64,
    /// Tangential compliance for unit axial length of the spline tooth, m/(N/m); 0 for rigid ones.
    pub tangential: f64,
    /// Radial compliance for unit axial length, m/(N/m); `None` if spline teeth do not constrain
    /// the radial motion of the bore.
    pub radial: Option<f64>,
    /// Degree of the polynomials along the bore up to which the spline teeth constrain it: 0
    /// constrains the mean, 1 the tilt too.
    pub degree: u8,
}

/// Harmonics per spline tooth that are needed to distinguish spline teeth from each other and from
/// uniform support.
const HARMONICS_PER_SPLINE_TOOTH: f64 = 3.0;

impl SplineTeeth {
    /// Returns the number of harmonics of the series that resolves the spline teeth: three for
    /// each, and at least the number of adjacent spline teeth that would fill the circle.
    pub fn harmonics(&self) -> u16 {
        let harmonics = (HARMONICS_PER_SPLINE_TOOTH * f64::from(self.count)).max(TAU / self.width.abs());
        harmonics.ceil().min(f64::from(u16::MAX)) as u16
    }

    /// Returns the angle of the middle of a spline tooth in the body's frame, rad.
    pub fn angle(&self, spline_tooth: u16) -> f64 {
        self.first + TAU * f64::from(spline_tooth) / f64::from(self.count)
    }

    /// Returns the directions in which spline teeth constrain the bore, with the compliance in
    /// each.
    fn directions(&self) -> Vec<(Component, f64)> {
        let radial = self.radial.map(|compliance| (Component::Radial, compliance));
        [(Component::Tangential, self.tangential)].into_iter().chain(radial).collect()
    }

    /// Returns true if a term of the series contributes to the displacements of spline teeth.
    pub(super) fn needs(&self, term: &Term) -> bool {
        let of_direction = match term.component {
            Component::Tangential => true,
            // A translation, which displaces spline teeth tangentially, also has one radial
            // harmonic.
            Component::Radial => self.radial.is_some() || (term.degree, term.harmonic) == (0, 1),
            Component::Axial => false,
        };
        of_direction && term.degree <= self.degree && term.harmonic <= self.harmonics()
    }

    /// Builds the spline teeth on a cylindrical bore from some of the unknowns of its series.
    /// `None` if these do not span the displacements of the spline teeth.
    pub(super) fn on(&self, series: &Series, places: &[usize]) -> Option<SplineToothForms> {
        let [[radius, start], [_, end]] = series.surface().generator;
        // A plane model has unit length.
        let length = if end > start { end - start } else { 1.0 };
        let directions = self.directions();
        let degrees = usize::from(self.degree) + 1;
        let count = usize::from(self.count) * directions.len() * degrees;
        let mut displacements = Mat::zeros(count, places.len());
        let mut compliance = vec![0.0; count];
        for (number, &(component, yielding)) in directions.iter().enumerate() {
            for degree in 0..=self.degree {
                let row = |spline_tooth: u16| {
                    (usize::from(spline_tooth) * directions.len() + number) * degrees + usize::from(degree)
                };
                // Mean squares of the Legendre polynomials along the bore are 1 / (2 d + 1).
                let along = f64::from(2 * degree + 1) / length;
                (0..self.count).for_each(|spline_tooth| compliance[row(spline_tooth)] = along * yielding);
                for harmonic in 0..=self.harmonics() {
                    let harmonics = f64::from(harmonic);
                    let share = if harmonic == 0 { 0.5 } else { sinc(0.5 * harmonics * self.width) };
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
                        for spline_tooth in 0..self.count {
                            let (sin, cos) = (harmonics * self.angle(spline_tooth)).sin_cos();
                            let value = mean * if sine { sin } else { cos };
                            for &(place, amount) in &amounts {
                                displacements[(row(spline_tooth), place)] += value * amount;
                            }
                        }
                    }
                }
            }
        }
        Some(SplineToothForms { spline_teeth: *self, displacements, compliance })
    }
}

fn sinc(x: f64) -> f64 {
    if x == 0.0 { 1.0 } else { x.sin() / x }
}

/// Spline teeth before the ring is solved: by tooth, direction and polynomial along the bore.
#[derive(Clone, Debug)]
pub(super) struct SplineToothForms {
    pub spline_teeth: SplineTeeth,
    /// Displacements by amplitudes of the bore, m.
    pub displacements: Mat<f64>,
    /// Compliance, m/N; m/(N/m) in a plane model.
    pub compliance: Vec<f64>,
}

/// Spline teeth that support a ring.
#[derive(Clone, Debug)]
pub(crate) struct SplineToothSet {
    pub spline_teeth: SplineTeeth,
    /// Forces of the spline teeth on the ring, by tooth, direction and polynomial along the bore,
    /// by forces on the amplitudes in the body's frame.
    pub reactions: Mat<f64>,
}

impl SplineToothForms {
    /// Returns the amplitudes by forces on them, from index `first` on (the preceding ones are
    /// fixed), with the forces of the spline teeth. `stiffness` is that of the ring against these
    /// amplitudes.
    ///
    /// # Errors
    /// The spline teeth do not support the ring, the series cannot distinguish them, or the
    /// computation is interrupted.
    pub fn constrain(
        &self,
        stiffness: MatRef<'_, f64>,
        first: usize,
        interrupt: &Interrupt,
    ) -> Result<(Mat<f64>, SplineToothSet), StructureError> {
        let checkpoint = || interrupt.check().map_err(StructureError::Interrupted);
        let dense = Interruptible(&checkpoint);
        let size = stiffness.nrows();
        let spline_teeth = self.displacements.as_ref().subcols(first, size);
        // Uses a part of the spline teeth's stiffness that is similar to that of the ring, so that
        // both remain significant in the sum.
        let trace = |matrix: MatRef<'_, f64>| (0..size).map(|k| matrix[(k, k)]).sum::<f64>();
        let softest =
            trace(dense.product(spline_teeth.transpose(), spline_teeth)?.as_ref()) / trace(stiffness);
        let soft: Vec<f64> = self.compliance.iter().map(|compliance| compliance + softest).collect();
        let scaled =
            Mat::from_fn(spline_teeth.nrows(), size, |row, column| spline_teeth[(row, column)] / soft[row]);
        let mut constrained = stiffness.to_owned();
        dense.add_product(constrained.as_mut(), 1.0, spline_teeth.transpose(), scaled.as_ref())?;
        mirror_lower(&mut constrained);
        let factor = dense.cholesky(constrained)?.ok_or(UnrestrainedRing)?;
        let mut release = dense.solve(factor.as_ref(), Mat::identity(size, size))?;
        mirror_lower(&mut release);
        // The rest of the stiffness of the spline teeth.
        let by_forces = dense.product(spline_teeth, release.as_ref())?;
        let mut yielding = dense.product(by_forces.as_ref(), spline_teeth.transpose())?;
        for (spline_tooth, (compliance, soft)) in self.compliance.iter().zip(&soft).enumerate() {
            yielding[(spline_tooth, spline_tooth)] += compliance * soft / softest;
        }
        let factor = dense.cholesky(yielding)?.ok_or(StructureError::CoarseSplineTeeth)?;
        let half = dense.solve_lower(factor.as_ref(), by_forces)?;
        dense.add_product(release.as_mut(), -1.0, half.transpose(), half.as_ref())?;
        mirror_lower(&mut release);
        let mut reactions = dense.solve_upper(factor.as_ref(), half)?;
        for column in 0..size {
            for (row, soft) in soft.iter().enumerate() {
                reactions[(row, column)] *= -soft / softest;
            }
        }
        Ok((release, SplineToothSet { spline_teeth: self.spline_teeth, reactions }))
    }
}

/// Force of a spline tooth on the ring, distributed over its location on the bore. Per metre of
/// face width in a plane model.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SplineToothForce {
    /// Angle of the middle of the spline tooth in the body's frame, rad.
    pub angle: f64,
    /// Tangential force, counter-clockwise, N.
    pub tangential: f64,
    /// Radial force, outwards, N.
    pub radial: f64,
}

impl SplineToothSet {
    /// Returns the forces of the spline teeth from those on the amplitudes in the body's frame.
    pub fn forces(&self, amplitudes: MatRef<'_, f64>) -> Vec<SplineToothForce> {
        let all = product(self.reactions.as_ref(), amplitudes);
        let (directions, degrees) =
            (self.spline_teeth.directions().len(), usize::from(self.spline_teeth.degree) + 1);
        let force = |spline_tooth: u16| {
            let first = usize::from(spline_tooth) * directions * degrees;
            let radial = if directions > 1 { all[(first + degrees, 0)] } else { 0.0 };
            SplineToothForce {
                angle: self.spline_teeth.angle(spline_tooth),
                tangential: all[(first, 0)],
                radial,
            }
        };
        (0..self.spline_teeth.count).map(force).collect()
    }

    /// Returns the memory, in bytes.
    pub fn bytes(&self) -> usize {
        self.reactions.nrows() * self.reactions.ncols() * size_of::<f64>()
    }
}
