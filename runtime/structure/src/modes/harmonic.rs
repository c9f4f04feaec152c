//! Modes of a ring with a given number of nodal diameters: a Hermitian eigenproblem on one sector.
//!
//! With `z = exp(i n pitch)` the last cut is the rotated first one times `z`. A block Lanczos
//! iteration with `(K + s M)^-1 M` solves the eigenproblem `K phi = omega² M phi`, with full
//! reorthogonalization in `M`. The shift `s > 0` admits free rings as well as supported ones, and
//! the interior of the sector is factorized once for all nodal diameters ([`super::sector`]). The
//! number of modes below a frequency is known beforehand from the signs of the pivots at that
//! frequency (Sturm count); the iteration ends when it has found as many.
//!
//! Mean constraints (`G^H phi = 0`) are satisfied in every solution:
//! `x = A^-1 f - A^-1 G (G^H A^-1 G)^-1 G^H A^-1 f`.
//!
//! See `docs/theory/modes.md`.

use super::super::StructureError;
use super::complex::{Columns, Spectrum, adjoint, times};
use super::sector::{Sector, Shifted, scattered};
use calyx_numerics::interrupt::Interrupt;
use faer::{Mat, c64};
use std::f64::consts::TAU;
use std::ops::Range;

/// Relative residual of a converged mode.
const TOLERANCE: f64 = 1e-10;
/// Block size: larger than the multiplicity of a frequency that a sector can have with one number
/// of nodal diameters.
const BLOCK: usize = 4;
/// Basis columns allowed for each mode, and in addition.
const BASIS: [usize; 2] = [6, 80];
/// A column is linearly dependent if less than this part of its norm remains after
/// orthogonalization.
const DEPENDENT: f64 = 1e-9;

/// Shifted equations of a sector for one number of nodal diameters.
pub(super) struct Harmonic<'s> {
    shifted: &'s Shifted<'s>,
    /// Phase factor of the last cut ahead of the first.
    ahead: c64,
    /// Stiffness of the cut.
    closed: Spectrum,
    means: Option<Means>,
    nodal_diameters: u32,
}

/// Mean constraints.
struct Means {
    /// Constraint forms `G`.
    forms: Columns,
    /// `A^-1 G`.
    responses: Columns,
    /// `G^H A^-1 G`.
    yielding: Spectrum,
}

/// Modes with one number of nodal diameters, of unit modal mass on one sector.
pub(in super::super) struct HarmonicModes {
    pub nodal_diameters: u32,
    /// Values of `omega²`, ascending.
    pub squares: Vec<f64>,
    /// Mode shapes on all degrees of freedom of sector 0.
    pub fields: Columns,
}

impl HarmonicModes {
    /// Keeps the `count` lowest modes only.
    pub fn keep(&mut self, count: usize) {
        self.select(0..count.min(self.squares.len()));
    }

    /// Removes the `count` lowest modes.
    pub fn leave_out(&mut self, count: usize) {
        self.select(count.min(self.squares.len())..self.squares.len());
    }

    fn select(&mut self, range: Range<usize>) {
        self.fields =
            Columns::from_fn(self.fields.rows(), range.len(), |row, k| self.fields.at(row, range.start + k));
        self.squares = self.squares[range].to_vec();
    }
}

/// Returns true if fields with this number of nodal diameters are real.
pub(super) fn is_real(nodal_diameters: u32, sectors: u32) -> bool {
    nodal_diameters == 0 || 2 * nodal_diameters == sectors
}

fn broken() -> StructureError {
    StructureError::Modes("the equations of a sector are not of numbers")
}

impl<'s> Harmonic<'s> {
    pub fn new(shifted: &'s Shifted<'s>, nodal_diameters: u32) -> Result<Self, StructureError> {
        let sector = shifted.sector;
        let ahead = if nodal_diameters == 0 {
            c64::new(1.0, 0.0)
        } else if is_real(nodal_diameters, sector.count) {
            c64::new(-1.0, 0.0)
        } else {
            let (sin, cos) = (TAU * f64::from(nodal_diameters) / f64::from(sector.count)).sin_cos();
            c64::new(cos, sin)
        };
        let n = sector.cuts[0].len();
        let real = |row: usize, column: usize| c64::new(shifted.closed[(row, column)], 0.0);
        let closed = Mat::from_fn(n, n, |row, column| {
            real(row, column)
                + real(n + row, n + column)
                + ahead * real(row, n + column)
                + ahead.conj() * real(n + row, column)
        });
        let closed = Spectrum::of(&closed).ok_or_else(broken)?;
        let mut harmonic = Self { shifted, ahead, closed, means: None, nodal_diameters };
        let forms = forms(sector, nodal_diameters);
        if forms.count() > 0 {
            let responses = harmonic.solve(&forms);
            let yielding = Spectrum::of(&forms.adjoint_times(&responses)).ok_or_else(broken)?;
            harmonic.means = Some(Means { forms, responses, yielding });
        }
        Ok(harmonic)
    }

    /// Returns the largest number of basis columns to find so many modes.
    pub fn columns(count: usize) -> usize {
        // Each column is stored with its product with the mass matrix.
        2 * (BASIS[0] * count + BASIS[1] + 2 * BLOCK)
    }

    /// Returns the number of modes with `omega²` below the shift.
    pub fn below(&self) -> Option<usize> {
        let given_away = self.means.as_ref().map_or(0, |means| means.yielding.negative());
        (self.shifted.negative + self.closed.negative()).checked_sub(given_away)
    }

    /// Returns the displacements of the sector under forces, which may act on both cuts.
    fn solve(&self, forces: &Columns) -> Columns {
        let Sector { inner, cuts: [first, last], angle, .. } = self.shifted.sector;
        let count = forces.count();
        let inside = Mat::from_fn(inner.len(), 2 * count, |row, column| forces.parts[(inner[row], column)]);
        let n = first.len();
        let mut responses = Columns::zeros(forces.rows(), count);
        let (sin, cos) = angle.sin_cos();
        let mut inside_by_cuts = None;
        if n > 0 {
            let passed = Columns { parts: self.shifted.on_cuts(&inside) };
            // Converts forces on the last cut to the rotated frame.
            let on_last = |row: usize, column: usize| {
                let [x, y] = [row & !1, row | 1].map(|place| forces.at(last[place], column));
                if row & 1 == 0 { x * cos + y * sin } else { y * cos - x * sin }
            };
            let on_cut = Mat::from_fn(n, count, |row, column| {
                let own = forces.at(first[row], column) + passed.at(row, column);
                own + self.ahead.conj() * (on_last(row, column) + passed.at(n + row, column))
            });
            let moved = self.closed.solve(on_cut.as_ref());
            for column in 0..count {
                for row in 0..n {
                    responses.set(first[row], column, moved[(row, column)]);
                }
                for row in (0..n).step_by(2) {
                    let (x, y) = (self.ahead * moved[(row, column)], self.ahead * moved[(row + 1, column)]);
                    responses.set(last[row], column, x * cos - y * sin);
                    responses.set(last[row + 1], column, x * sin + y * cos);
                }
            }
            let both = Columns::from_fn(2 * n, count, |row, column| {
                if row < n { moved[(row, column)] } else { self.ahead * moved[(row - n, column)] }
            });
            inside_by_cuts = Some(both);
        }
        let mut inside = self.shifted.inside(inside);
        if let Some(both) = inside_by_cuts {
            let follows = self.shifted.follows.as_ref();
            calyx_numerics::dense::add_product(inside.as_mut(), 1.0, follows, both.parts.as_ref());
        }
        for place in 0..2 * count {
            for (row, &dof) in inner.iter().enumerate() {
                responses.parts[(dof, place)] = inside[(row, place)];
            }
        }
        if let Some(means) = &self.means {
            let left = means.forms.adjoint_times(&responses);
            responses.add_times(-1.0, &means.responses, means.yielding.solve(left.as_ref()).as_ref());
        }
        responses
    }

    /// Finds the `count` modes of lowest frequency. The shift is below all of them.
    pub fn lowest(&self, count: usize, interrupt: &Interrupt) -> Result<HarmonicModes, StructureError> {
        let sector = self.shifted.sector;
        let shift = Lanczos::new(self, sector).lowest(count, interrupt)?;
        self.refined(&shift)
    }

    /// Refines approximate modes by another iteration, followed by diagonalization of stiffness and
    /// mass (Rayleigh-Ritz).
    fn refined(&self, near: &Columns) -> Result<HarmonicModes, StructureError> {
        let sector = self.shifted.sector;
        let mut fields = self.solve(&near.under(&sector.mass));
        let mut squares = Vec::new();
        // The second pass removes the loss of orthogonality of the first.
        for _ in 0..2 {
            let mass = Spectrum::of(&fields.adjoint_times(&fields.under(&sector.mass))).ok_or_else(broken)?;
            let unit =
                mass.apply(Mat::identity(near.count(), near.count()).as_ref(), |value| value.sqrt().recip());
            let stiffness = fields.adjoint_times(&fields.under(&sector.stiffness));
            let once = times(stiffness.as_ref(), unit.as_ref());
            let of_units = Spectrum::of(&times(unit.as_ref(), once.as_ref())).ok_or_else(broken)?;
            fields = fields.times(times(unit.as_ref(), of_units.vectors.as_ref()).as_ref());
            squares = of_units.values;
        }
        let real = is_real(self.nodal_diameters, sector.count);
        for column in 0..fields.count() {
            in_phase(&mut fields, column, real);
        }
        Ok(HarmonicModes { nodal_diameters: self.nodal_diameters, squares, fields })
    }
}

/// Normalizes the phase of a field so that its first large displacement is real and positive; a
/// real field has no imaginary part.
fn in_phase(fields: &mut Columns, column: usize, real: bool) {
    let largest = (0..fields.rows()).map(|row| fields.at(row, column).norm_sqr()).fold(0.0, f64::max);
    let first = (0..fields.rows()).find(|&row| fields.at(row, column).norm_sqr() >= 0.5 * largest);
    let Some(first) = first.map(|row| fields.at(row, column)).filter(|value| value.norm_sqr() > 0.0) else {
        return;
    };
    let back = first.conj() / first.norm_sqr().sqrt();
    for row in 0..fields.rows() {
        let value = fields.at(row, column) * back;
        fields.set(row, column, if real { c64::new(value.re, 0.0) } else { value });
    }
}

/// Returns the constraint forms for a number of nodal diameters. For a pair `a`, `b` with harmonic
/// `w`, the sum of `a + i b` over the ring is `sum exp(i (w + n) j pitch) (a + i b)`, which
/// vanishes identically unless `w + n` is a multiple of the number of sectors.
fn forms(sector: &Sector, nodal_diameters: u32) -> Columns {
    let modulo = f64::from(sector.count);
    let multiple = |number: f64| number.rem_euclid(modulo) == 0.0;
    let diameters = f64::from(nodal_diameters);
    let paired = |form: usize| sector.shared.pairs.iter().any(|(places, _)| places.contains(&form));
    let mut constrained: Vec<Vec<(usize, c64)>> = Vec::new();
    let one = c64::new(1.0, 0.0);
    if nodal_diameters == 0 {
        constrained
            .extend((0..sector.forms.len()).filter(|&form| !paired(form)).map(|form| vec![(form, one)]));
    }
    for &([cosine, sine], own) in &sector.shared.pairs {
        match (multiple(own + diameters), multiple(own - diameters)) {
            (true, true) => constrained.extend([vec![(cosine, one)], vec![(sine, one)]]),
            // Conjugate, because the form is G^H.
            (true, false) => constrained.push(vec![(cosine, one), (sine, c64::new(0.0, -1.0))]),
            (false, true) => constrained.push(vec![(cosine, one), (sine, c64::new(0.0, 1.0))]),
            (false, false) => {}
        }
    }
    let mut columns = Columns::zeros(sector.dofs(), constrained.len());
    for (column, terms) in constrained.iter().enumerate() {
        for &(form, factor) in terms {
            for &(dof, value) in sector.forms.get(form).iter().flat_map(|form| &form.entries) {
                columns.set(dof, column, columns.at(dof, column) + factor * value);
            }
        }
    }
    columns
}

/// State of a block Lanczos iteration.
struct Lanczos<'h> {
    harmonic: &'h Harmonic<'h>,
    sector: &'h Sector,
    /// Basis, orthonormal in the mass.
    basis: Vec<Columns>,
    /// Products of the basis with the mass matrix.
    loads: Vec<Columns>,
    /// Operator projected on the basis: one column for each column it has been applied to.
    operator: Vec<Vec<c64>>,
    scattered: usize,
}

impl<'h> Lanczos<'h> {
    fn new(harmonic: &'h Harmonic<'h>, sector: &'h Sector) -> Self {
        Self { harmonic, sector, basis: Vec::new(), loads: Vec::new(), operator: Vec::new(), scattered: 0 }
    }

    fn size(&self) -> usize {
        self.basis.iter().map(Columns::count).sum()
    }

    fn lowest(mut self, count: usize, interrupt: &Interrupt) -> Result<Columns, StructureError> {
        let checkpoint = || interrupt.check().map_err(StructureError::Interrupted);
        let most = BASIS[0] * count + BASIS[1];
        self.begin();
        loop {
            checkpoint()?;
            let Some(last) = self.loads.last() else {
                return Err(StructureError::Modes("a sector has fewer degrees of freedom than modes"));
            };
            let mut next = self.harmonic.solve(last);
            let (applied, width) = (self.size(), next.count());
            let shares = self.take_out(&mut next);
            for column in 0..width {
                self.operator.push(
                    shares
                        .iter()
                        .flat_map(|share| (0..share.nrows()).map(move |row| share[(row, column)]))
                        .collect(),
                );
            }
            let load = next.under(&self.sector.mass);
            let left = next.adjoint_times(&load);
            if applied >= count
                && let Some(found) = self.found(count, applied, &left)
            {
                return Ok(found);
            }
            if applied > most {
                return Err(StructureError::Modes("the iteration for them does not converge"));
            }
            if !self.extend(&next, &left) {
                // The basis is invariant under the operator: restart with new columns.
                self.begin();
            }
        }
    }

    /// Adds pseudorandom columns to the basis.
    fn begin(&mut self) {
        let dofs = self.sector.dofs();
        let numbers = scattered(dofs, self.scattered + 2 * BLOCK);
        let real = is_real(self.harmonic.nodal_diameters, self.sector.count);
        let first = self.scattered;
        let forces = Columns::from_fn(dofs, BLOCK, |row, column| {
            let at = first + 2 * column;
            c64::new(numbers[(row, at)], if real { 0.0 } else { numbers[(row, at + 1)] })
        });
        self.scattered += 2 * BLOCK;
        let once = self.harmonic.solve(&forces.under(&self.sector.mass));
        let mut columns = self.harmonic.solve(&once.under(&self.sector.mass));
        self.take_out(&mut columns);
        let left = columns.adjoint_times(&columns.under(&self.sector.mass));
        self.extend(&columns, &left);
    }

    /// Orthogonalizes columns against the basis and returns the coefficients, by blocks of the
    /// basis.
    fn take_out(&self, columns: &mut Columns) -> Vec<Mat<c64>> {
        let mut shares: Vec<Mat<c64>> = Vec::new();
        // The second pass removes rounding errors.
        for round in 0..2 {
            for (block, (basis, load)) in self.basis.iter().zip(&self.loads).enumerate() {
                let share = load.adjoint_times(columns);
                columns.add_times(-1.0, basis, share.as_ref());
                if round == 0 {
                    shares.push(share);
                } else {
                    shares[block] += share;
                }
            }
        }
        shares
    }

    /// Adds the span of columns to the basis, given their products in the mass; returns false if
    /// the span is empty.
    fn extend(&mut self, columns: &Columns, products: &Mat<c64>) -> bool {
        let Some(spectrum) = Spectrum::of(products) else { return false };
        let largest =
            self.operator.iter().enumerate().filter_map(|(at, column)| column.get(at)).map(|own| own.re);
        let least = (DEPENDENT * largest.fold(0.0, f64::max)).powi(2);
        let kept: Vec<usize> = (0..spectrum.values.len())
            .filter(|&k| {
                spectrum.values[k] > least.max(1e-24 * spectrum.values.last().copied().unwrap_or(0.0))
            })
            .collect();
        if kept.is_empty() {
            return false;
        }
        let unit = Mat::from_fn(products.nrows(), kept.len(), |row, k| {
            spectrum.vectors[(row, kept[k])] / spectrum.values[kept[k]].sqrt()
        });
        let mut block = columns.times(unit.as_ref());
        // Rounding has reintroduced components of columns that were nearly in the basis.
        self.take_out(&mut block);
        let load = block.under(&self.sector.mass);
        let Some(again) = Spectrum::of(&block.adjoint_times(&load)) else { return false };
        let identity = Mat::identity(kept.len(), kept.len());
        let unit = again.apply(identity.as_ref(), |value| value.sqrt().recip());
        self.loads.push(load.times(unit.as_ref()));
        self.basis.push(block.times(unit.as_ref()));
        true
    }

    /// Returns the modes if the basis contains `count` converged ones. `left` are the products in
    /// the mass of the residual block of the iteration.
    fn found(&self, count: usize, applied: usize, left: &Mat<c64>) -> Option<Columns> {
        let entry = |row: usize, column: usize| {
            self.operator.get(column).and_then(|column| column.get(row)).copied().unwrap_or_default()
        };
        let square = Mat::from_fn(applied, applied, |row, column| {
            if row <= column { entry(row, column) } else { entry(column, row).conj() }
        });
        let ritz = Spectrum::of(&square)?;
        let width = left.nrows();
        let chosen = Mat::from_fn(applied, count, |row, k| ritz.vectors[(row, applied - 1 - k)]);
        let ends = chosen.as_ref().subrows(applied - width, width);
        let outside = times(adjoint(ends).as_ref(), times(left.as_ref(), ends).as_ref());
        let converged =
            |k: usize| outside[(k, k)].re.max(0.0).sqrt() <= TOLERANCE * ritz.values[applied - 1 - k].abs();
        if !(0..count).all(converged) {
            return None;
        }
        let mut found = Columns::zeros(self.sector.dofs(), count);
        let mut from = 0;
        for block in &self.basis {
            found.add_times(1.0, block, chosen.as_ref().subrows(from, block.count()));
            from += block.count();
        }
        Some(found)
    }
}
