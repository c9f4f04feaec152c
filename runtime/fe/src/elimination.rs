//! Multifrontal elimination of the unknowns of a mesh, part by part of its [`Dissection`], down to
//! the retained ones.
//!
//! Loads and linear forms are processed like additional retained unknowns. With the stiffness `K`,
//! the loads `B` and the forms `C`, the unknowns that are not retained are eliminated from the
//! matrix `[K B; B^T 0; C 0]`. The Schur complement contains everything that a condensed structure
//! needs, including the responses to loads. No factor is stored, no response of the whole mesh is
//! formed, and a load takes part only in the parts above the elements it acts on. (Duff and Reid,
//! ACM Transactions on Mathematical Software 9, 1983.)
//!
//! The result does not depend on the number of threads bit for bit: parallel work is divided in the
//! same way on any machine.

use super::dissection::{Dissection, Part};
use super::solve::SolveError;
use super::sparse::SparseVector;
use calyx_numerics::dense::Interruptible;
use faer::Mat;
use faer::sparse::SparseColMat;

/// The matrix is singular to working precision if a pivot is a smaller share of its unknown's own
/// stiffness than this: there is a mechanism.
const SINGULAR: f64 = 1e-13;

/// Schur complement with loads and forms; `c` retained unknowns, `m` loads, `q` forms.
#[derive(Clone, Debug)]
pub struct SchurComplement {
    /// Square matrix of size `c + m`: the stiffness of the retained unknowns, the equivalent loads
    /// on them (and their transpose), and, negative, the displacements of the loads by the loads
    /// with the retained unknowns fixed. Lower triangle.
    pub square: Mat<f64>,
    /// Matrix `q` by `c + m`: the forms of the retained unknowns, and, negative, of the loads with
    /// the retained unknowns fixed.
    pub forms: Mat<f64>,
}

/// Update matrix that a part passes to the one above it.
struct Update {
    /// Slots of the degrees of freedom and loads that the part was coupled to.
    slots: Vec<usize>,
    forms_at: Vec<usize>,
    square: Mat<f64>,
    forms: Mat<f64>,
}

/// Entries of sparse vectors by degree of freedom.
struct ByDof {
    /// Number of vectors.
    count: usize,
    starts: Vec<usize>,
    /// Index of the vector, and its value.
    entries: Vec<(usize, f64)>,
}

impl ByDof {
    fn new(dofs: usize, vectors: &[SparseVector]) -> Self {
        let mut starts = vec![0; dofs + 1];
        for &(dof, _) in vectors.iter().flat_map(|vector| &vector.entries) {
            starts[dof + 1] += 1;
        }
        for dof in 0..dofs {
            starts[dof + 1] += starts[dof];
        }
        let mut entries = vec![(0, 0.0); starts[dofs]];
        let mut next = starts.clone();
        for (number, vector) in vectors.iter().enumerate() {
            for &(dof, value) in &vector.entries {
                entries[next[dof]] = (number, value);
                next[dof] += 1;
            }
        }
        Self { count: vectors.len(), starts, entries }
    }

    /// Returns the indices, ascending, of the vectors that have an entry at any of these degrees of
    /// freedom, and of others.
    fn present(&self, dofs: &[usize], others: impl Iterator<Item = usize>) -> Vec<usize> {
        let mut seen = vec![false; self.count];
        let own = dofs.iter().flat_map(|&dof| self.at(dof)).map(|&(number, _)| number);
        others.chain(own).for_each(|number| seen[number] = true);
        (0..self.count).filter(|&number| seen[number]).collect()
    }

    fn at(&self, dof: usize) -> &[(usize, f64)] {
        &self.entries[self.starts[dof]..self.starts[dof + 1]]
    }
}

/// Memory demand of a part and those below it.
struct Need {
    /// Largest number of values at any time, for any number of threads.
    peak: u64,
    /// Number of values in its update.
    left: u64,
    loads: Vec<usize>,
    forms: Vec<usize>,
}

impl Need {
    /// Returns the demand for `pivots` by `rest` unknowns and loads by `forms`, after the demand of
    /// `below`.
    fn numbers([pivots, rest, forms]: [usize; 3], below: &[Need]) -> [u64; 2] {
        let [pivots, rest, forms] = [pivots, rest, forms].map(|count| count as u64);
        let left = (rest + forms) * rest;
        let front = (pivots + rest + forms) * pivots + left;
        let sum = |of: fn(&Need) -> u64| below.iter().map(of).sum::<u64>();
        [sum(|need| need.peak).max(sum(|need| need.left) + front), left]
    }
}

/// Returns the largest memory of [`eliminate`] in addition to its arguments, bytes.
pub fn memory(dissection: &Dissection, loads: &[SparseVector], forms: &[SparseVector]) -> u64 {
    let [of_loads, of_forms] = [loads, forms].map(|vectors| ByDof::new(dissection.order.len(), vectors));
    let mut needs: Vec<Option<Need>> = Vec::with_capacity(dissection.parts.len());
    for part in &dissection.parts {
        let below: Vec<Need> = part.below.iter().filter_map(|&part| needs[part].take()).collect();
        let all = |vectors: &ByDof, inherited: fn(&Need) -> &[usize]| {
            vectors.present(&part.pivots, below.iter().flat_map(inherited).copied())
        };
        let (loads, forms) = (all(&of_loads, |need| &need.loads), all(&of_forms, |need| &need.forms));
        let sizes = [part.pivots.len(), part.boundary.len() + loads.len(), forms.len()];
        let [peak, left] = Need::numbers(sizes, &below);
        needs.push(Some(Need { peak, left, loads, forms }));
    }
    let top: Vec<Need> = needs.pop().into_iter().flatten().collect();
    let eliminated: usize = dissection.parts.iter().map(|part| part.pivots.len()).sum();
    let kept = dissection.order.iter().flatten().count() - eliminated;
    let [peak, _] = Need::numbers([0, kept + loads.len(), forms.len()], &top);
    peak * size_of::<f64>() as u64
}

struct Elimination<'a, C> {
    stiffness: &'a SparseColMat<usize, f64>,
    dissection: &'a Dissection,
    loads: ByDof,
    forms: ByDof,
    /// Slot of the first load; degrees of freedom precede it, in the order of elimination.
    first_load: usize,
    checkpoint: C,
}

/// Eliminates all unknowns that the dissection does not retain, with a `checkpoint` before each
/// part and before each piece of its dense operations.
///
/// # Errors
/// There is a mechanism, or the checkpoint returns an error.
pub fn eliminate<E: From<SolveError> + Send>(
    stiffness: &SparseColMat<usize, f64>,
    dissection: &Dissection,
    loads: &[SparseVector],
    forms: &[SparseVector],
    checkpoint: impl Fn() -> Result<(), E> + Sync,
) -> Result<SchurComplement, E> {
    let dofs = stiffness.ncols();
    let first_load = dissection.order.iter().flatten().count();
    let eliminated: usize = dissection.parts.iter().map(|part| part.pivots.len()).sum();
    let elimination = Elimination {
        stiffness,
        dissection,
        loads: ByDof::new(dofs, loads),
        forms: ByDof::new(dofs, forms),
        first_load,
        checkpoint,
    };
    let below = match dissection.parts.last().map(|top| top.below.as_slice()) {
        Some(&[top]) => Some(elimination.part(top)?),
        _ => None,
    };
    (elimination.checkpoint)()?;

    let kept = first_load - eliminated;
    let mut square = Mat::zeros(kept + loads.len(), kept + loads.len());
    let mut left = Mat::zeros(forms.len(), kept + loads.len());
    for (dof, slot) in dissection.order.iter().enumerate() {
        let Some(column) = slot.and_then(|slot| slot.checked_sub(eliminated)) else { continue };
        let entries = stiffness.row_idx_of_col(dof).zip(stiffness.val_of_col(dof));
        for (row, value) in entries {
            let row = dissection.order[row].and_then(|slot| slot.checked_sub(eliminated));
            if let Some(row) = row.filter(|&row| row >= column) {
                square[(row, column)] += value;
            }
        }
        for &(load, value) in elimination.loads.at(dof) {
            square[(kept + load, column)] += value;
        }
        for &(form, value) in elimination.forms.at(dof) {
            left[(form, column)] += value;
        }
    }
    if let Some(update) = below {
        let places: Vec<usize> = update.slots.iter().map(|slot| slot - eliminated).collect();
        for (from, &column) in places.iter().enumerate() {
            for (row, &place) in places.iter().enumerate().skip(from) {
                square[(place, column)] += update.square[(row, from)];
            }
            for (row, &form) in update.forms_at.iter().enumerate() {
                left[(form, column)] += update.forms[(row, from)];
            }
        }
    }
    Ok(SchurComplement { square, forms: left })
}

impl<E: From<SolveError> + Send, C: Fn() -> Result<(), E> + Sync> Elimination<'_, C> {
    /// Eliminates a part and all below it.
    fn part(&self, number: usize) -> Result<Update, E> {
        let part = &self.dissection.parts[number];
        let below = match *part.below.as_slice() {
            [] => Vec::new(),
            [only] => vec![self.part(only)?],
            [first, second, ..] => {
                let (first, second) = rayon::join(|| self.part(first), || self.part(second));
                vec![first?, second?]
            }
        };
        (self.checkpoint)()?;
        self.front(part, below)
    }

    fn front(&self, part: &Part, below: Vec<Update>) -> Result<Update, E> {
        let slot = |dof: usize| self.dissection.order[dof].unwrap_or(usize::MAX);
        let count = part.pivots.len();
        let mut slots: Vec<usize> = part.boundary.iter().map(|&dof| slot(dof)).collect();
        let loads_below = below.iter().flat_map(|update| {
            let dofs = update.slots.partition_point(|&slot| slot < self.first_load);
            update.slots[dofs..].iter().map(|slot| slot - self.first_load)
        });
        let loads = self.loads.present(&part.pivots, loads_below);
        let forms_below = below.iter().flat_map(|update| update.forms_at.iter().copied());
        let forms_at = self.forms.present(&part.pivots, forms_below);
        slots.extend(loads.into_iter().map(|load| self.first_load + load));
        let (rest, forms) = (slots.len(), forms_at.len());

        // Columns of the pivots: rows of the pivots, of the boundary, of the forms.
        let mut columns = Mat::<f64>::zeros(count + rest + forms, count);
        let mut square = Mat::<f64>::zeros(rest, rest);
        let mut left = Mat::<f64>::zeros(forms, rest);
        let first = part.pivots.first().map_or(0, |&dof| slot(dof));
        let find = |slot: usize| slots.binary_search(&slot).unwrap_or(usize::MAX);
        let mut own = Vec::with_capacity(count);
        for (column, &dof) in part.pivots.iter().enumerate() {
            // The next row usually has the next slot too.
            let mut guess = 0;
            for (row, &value) in self.stiffness.row_idx_of_col(dof).zip(self.stiffness.val_of_col(dof)) {
                let Some(slot) = self.dissection.order[row].filter(|&slot| slot >= first + column) else {
                    continue;
                };
                let place = if slot < first + count {
                    slot - first
                } else {
                    guess = if slots.get(guess) == Some(&slot) { guess } else { find(slot) } + 1;
                    count + guess - 1
                };
                columns[(place, column)] += value;
            }
            own.push(columns[(column, column)]);
            for &(load, value) in self.loads.at(dof) {
                columns[(count + find(self.first_load + load), column)] += value;
            }
            for &(form, value) in self.forms.at(dof) {
                if let Ok(place) = forms_at.binary_search(&form) {
                    columns[(count + rest + place, column)] += value;
                }
            }
        }
        for update in below {
            let mut places = Vec::with_capacity(update.slots.len());
            let mut next = 0;
            for &slot in &update.slots {
                if slot < first + count {
                    places.push(slot - first);
                } else {
                    next += slots[next..].partition_point(|&other| other < slot);
                    places.push(count + next);
                }
            }
            let forms: Vec<usize> =
                update.forms_at.iter().map(|form| forms_at.partition_point(|other| other < form)).collect();
            for (from, &place) in places.iter().enumerate() {
                let values = update.square.col(from);
                let of_forms = update.forms.col(from);
                if place < count {
                    let mut target = columns.col_mut(place);
                    for (row, &to) in places.iter().enumerate().skip(from) {
                        target[to] += values[row];
                    }
                    for (row, &to) in forms.iter().enumerate() {
                        target[count + rest + to] += of_forms[row];
                    }
                } else {
                    let mut target = square.col_mut(place - count);
                    for (row, &to) in places.iter().enumerate().skip(from) {
                        target[to - count] += values[row];
                    }
                    let mut target = left.col_mut(place - count);
                    for (row, &to) in forms.iter().enumerate() {
                        target[to] += of_forms[row];
                    }
                }
            }
        }

        let (mut pivots, mut lower) = columns.as_mut().split_at_row_mut(count);
        let dense = Interruptible(&self.checkpoint);
        if !dense.cholesky_in_place(pivots.as_mut())? {
            return Err(SolveError::Singular.into());
        }
        let regular = |pivot: usize| pivots[(pivot, pivot)].powi(2) > SINGULAR * own[pivot];
        if !(0..count).all(regular) {
            return Err(SolveError::Singular.into());
        }
        dense.divide_by_cholesky_factor(lower.as_mut(), pivots.as_ref())?;
        let (upper, lower) = lower.as_ref().split_at_row(rest);
        dense.add_product_lower(square.as_mut(), -1.0, upper, upper.transpose())?;
        dense.add_product(left.as_mut(), -1.0, lower, upper.transpose())?;
        Ok(Update { slots, forms_at, square, forms: left })
    }
}
