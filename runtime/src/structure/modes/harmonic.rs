//! Modes of a ring with a given number of waves: a Hermitian eigenproblem on one sector.
//!
//! With `z = exp(i n pitch)` the last cut is the first one, turned, times `z`. The eigenproblem `K phi = omega² M phi` is solved by a
//! block Lanczos iteration with `(K + s M)^-1 M`, all of the basis kept orthogonal in `M`: `s > 0` makes free rings as good as held ones,
//! and what is inside the sector is decomposed once for all numbers of waves ([`super::sector`]). How many modes there are below
//! a frequency is known beforehand, from the signs of the pivots at that frequency; the iteration ends when it has found so many.
//!
//! Means that are held (`G^H phi = 0`) are held in every solution: `x = A^-1 f - A^-1 G (G^H A^-1 G)^-1 G^H A^-1 f`.

use super::super::StructureError;
use super::complex::{Columns, Spectrum, adjoint, times};
use super::sector::{Sector, Shifted, scattered};
use crate::interrupt::Interrupt;
use faer::{Mat, c64};
use std::f64::consts::TAU;
use std::ops::Range;

/// What an iteration leaves of a mode, relative to it.
const TOLERANCE: f64 = 1e-10;
/// Columns iterated at once: more than modes of one frequency that a sector can have with one number of waves.
const BLOCK: usize = 4;
/// Columns of the basis that each mode may take, and that there may be besides.
const BASIS: [usize; 2] = [6, 80];
/// A column of which less is left, in the norm, by the others is one of theirs.
const DEPENDENT: f64 = 1e-9;

/// Sectors that vibrate with a number of waves around, at a shift.
pub(super) struct Harmonic<'s> {
    shifted: &'s Shifted<'s>,
    /// By which the last cut is ahead of the first.
    ahead: c64,
    /// Of the cut.
    closed: Spectrum,
    means: Option<Means>,
    waves: u32,
}

/// Means that are held.
struct Means {
    /// `G`.
    forms: Columns,
    /// `A^-1 G`.
    answers: Columns,
    /// `G^H A^-1 G`.
    yielding: Spectrum,
}

/// Modes of a number of waves, of unit modal mass on one sector.
pub(in super::super) struct HarmonicModes {
    pub waves: u32,
    /// Of `omega²`, ascending.
    pub squares: Vec<f64>,
    /// On all degrees of freedom of sector 0.
    pub fields: Columns,
}

impl HarmonicModes {
    /// Only so many of the lowest.
    pub fn keep(&mut self, count: usize) {
        self.select(0..count.min(self.squares.len()));
    }

    /// All but so many of the lowest.
    pub fn leave_out(&mut self, count: usize) {
        self.select(count.min(self.squares.len())..self.squares.len());
    }

    fn select(&mut self, range: Range<usize>) {
        self.fields =
            Columns::from_fn(self.fields.rows(), range.len(), |row, k| self.fields.at(row, range.start + k));
        self.squares = self.squares[range].to_vec();
    }
}

/// Whether fields of so many waves are real.
pub(super) fn is_real(waves: u32, sectors: u32) -> bool {
    waves == 0 || 2 * waves == sectors
}

fn broken() -> StructureError {
    StructureError::Modes("the equations of a sector are not of numbers")
}

impl<'s> Harmonic<'s> {
    pub fn new(shifted: &'s Shifted<'s>, waves: u32) -> Result<Self, StructureError> {
        let sector = shifted.sector;
        let ahead = if waves == 0 {
            c64::new(1.0, 0.0)
        } else if is_real(waves, sector.count) {
            c64::new(-1.0, 0.0)
        } else {
            let (sin, cos) = (TAU * f64::from(waves) / f64::from(sector.count)).sin_cos();
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
        let mut harmonic = Self { shifted, ahead, closed, means: None, waves };
        let forms = forms(sector, waves);
        if forms.count() > 0 {
            let answers = harmonic.solve(&forms);
            let yielding = Spectrum::of(&forms.adjoint_times(&answers)).ok_or_else(broken)?;
            harmonic.means = Some(Means { forms, answers, yielding });
        }
        Ok(harmonic)
    }

    /// Columns of its basis that finding so many modes may take, at most.
    pub fn columns(count: usize) -> usize {
        // Each with its load.
        2 * (BASIS[0] * count + BASIS[1] + 2 * BLOCK)
    }

    /// How many modes there are with `omega²` below the shift.
    pub fn below(&self) -> Option<usize> {
        let given_away = self.means.as_ref().map_or(0, |means| means.yielding.negative());
        (self.shifted.negative + self.closed.negative()).checked_sub(given_away)
    }

    /// Displacements of the sector under forces, which may act on both cuts.
    fn solve(&self, forces: &Columns) -> Columns {
        let Sector { inner, cuts: [first, last], angle, .. } = self.shifted.sector;
        let count = forces.count();
        let inside = Mat::from_fn(inner.len(), 2 * count, |row, column| forces.parts[(inner[row], column)]);
        let n = first.len();
        let mut answers = Columns::zeros(forces.rows(), count);
        let (sin, cos) = angle.sin_cos();
        let mut inside_by_cuts = None;
        if n > 0 {
            let passed = Columns { parts: self.shifted.on_cuts(&inside) };
            // Of the last cut in the frame that is turned.
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
                    answers.set(first[row], column, moved[(row, column)]);
                }
                for row in (0..n).step_by(2) {
                    let (x, y) = (self.ahead * moved[(row, column)], self.ahead * moved[(row + 1, column)]);
                    answers.set(last[row], column, x * cos - y * sin);
                    answers.set(last[row + 1], column, x * sin + y * cos);
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
            crate::dense::add_product(inside.as_mut(), 1.0, follows, both.parts.as_ref());
        }
        for place in 0..2 * count {
            for (row, &dof) in inner.iter().enumerate() {
                answers.parts[(dof, place)] = inside[(row, place)];
            }
        }
        if let Some(means) = &self.means {
            let left = means.forms.adjoint_times(&answers);
            answers.add_times(-1.0, &means.answers, means.yielding.solve(left.as_ref()).as_ref());
        }
        answers
    }

    /// The `count` modes of lowest frequency. The shift is below all of them.
    pub fn lowest(&self, count: usize, interrupt: &Interrupt) -> Result<HarmonicModes, StructureError> {
        let sector = self.shifted.sector;
        let shift = Lanczos::new(self, sector).lowest(count, interrupt)?;
        self.refined(&shift)
    }

    /// Modes from columns that nearly are: once more iterated, and made to diagonalise stiffness and mass.
    fn refined(&self, near: &Columns) -> Result<HarmonicModes, StructureError> {
        let sector = self.shifted.sector;
        let mut fields = self.solve(&near.under(&sector.mass));
        let mut squares = Vec::new();
        // The second time for what the first leaves of orthogonality.
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
        let real = is_real(self.waves, sector.count);
        for column in 0..fields.count() {
            in_phase(&mut fields, column, real);
        }
        Ok(HarmonicModes { waves: self.waves, squares, fields })
    }
}

/// Gives a field the phase in which its first large displacement is real and positive; a real field has no imaginary part.
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

/// Forms that are held with a number of waves. Of a pair `a`, `b` with `w` waves of its own the sum of `a + i b` over the ring is `sum
/// exp(i (w + n) j pitch) (a + i b)`, which vanishes of itself unless `w + n` is a multiple of the number of sectors.
fn forms(sector: &Sector, waves: u32) -> Columns {
    let modulo = f64::from(sector.count);
    let multiple = |number: f64| number.rem_euclid(modulo) == 0.0;
    let waves_of = f64::from(waves);
    let paired = |form: usize| sector.shared.pairs.iter().any(|(places, _)| places.contains(&form));
    let mut held: Vec<Vec<(usize, c64)>> = Vec::new();
    let one = c64::new(1.0, 0.0);
    if waves == 0 {
        held.extend((0..sector.forms.len()).filter(|&form| !paired(form)).map(|form| vec![(form, one)]));
    }
    for &([cosine, sine], own) in &sector.shared.pairs {
        match (multiple(own + waves_of), multiple(own - waves_of)) {
            (true, true) => held.extend([vec![(cosine, one)], vec![(sine, one)]]),
            // Conjugate, for G^H is the form.
            (true, false) => held.push(vec![(cosine, one), (sine, c64::new(0.0, -1.0))]),
            (false, true) => held.push(vec![(cosine, one), (sine, c64::new(0.0, 1.0))]),
            (false, false) => {}
        }
    }
    let mut columns = Columns::zeros(sector.dofs(), held.len());
    for (column, terms) in held.iter().enumerate() {
        for &(form, factor) in terms {
            for &(dof, value) in sector.forms.get(form).iter().flat_map(|form| &form.entries) {
                columns.set(dof, column, columns.at(dof, column) + factor * value);
            }
        }
    }
    columns
}

/// The basis of an iteration.
struct Lanczos<'h> {
    harmonic: &'h Harmonic<'h>,
    sector: &'h Sector,
    /// Orthonormal in the mass.
    basis: Vec<Columns>,
    /// Each of them under the mass.
    loads: Vec<Columns>,
    /// The operator on the basis: a column for each column it has been applied to.
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
                // Nothing new: what the basis holds is closed under the operator.
                self.begin();
            }
        }
    }

    /// Adds columns without order to the basis.
    fn begin(&mut self) {
        let dofs = self.sector.dofs();
        let numbers = scattered(dofs, self.scattered + 2 * BLOCK);
        let real = is_real(self.harmonic.waves, self.sector.count);
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

    /// Takes out of columns what the basis has of them, and returns it, by blocks of the basis.
    fn take_out(&self, columns: &mut Columns) -> Vec<Mat<c64>> {
        let mut shares: Vec<Mat<c64>> = Vec::new();
        // The second time for what rounding leaves.
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

    /// Adds what columns span to the basis, given their products in the mass; false if that is nothing.
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
        // Of what was nearly in the basis, rounding has brought some back.
        self.take_out(&mut block);
        let load = block.under(&self.sector.mass);
        let Some(again) = Spectrum::of(&block.adjoint_times(&load)) else { return false };
        let identity = Mat::identity(kept.len(), kept.len());
        let unit = again.apply(identity.as_ref(), |value| value.sqrt().recip());
        self.loads.push(load.times(unit.as_ref()));
        self.basis.push(block.times(unit.as_ref()));
        true
    }

    /// The modes, if the basis has so many. `left` are the products in the mass of what the operator has led out of the basis from its last
    /// block.
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
