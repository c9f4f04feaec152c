//! Sparse vectors over degrees of freedom (loads, and rows of linear maps from displacements) and
//! sparse sums.

use faer::sparse::{SparseColMat, SymbolicSparseColMat};

/// Sparse vector, by ascending, distinct degree of freedom.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SparseVector {
    /// Indices and values.
    pub entries: Vec<(usize, f64)>,
}

impl SparseVector {
    /// Returns the value of the row at a full displacement vector.
    pub fn dot(&self, full: &[f64]) -> f64 {
        self.entries.iter().map(|&(dof, value)| value * full[dof]).sum()
    }

    /// Adds `factor` times this vector to a full vector.
    pub fn add_to(&self, factor: f64, full: &mut [f64]) {
        for &(dof, value) in &self.entries {
            full[dof] += factor * value;
        }
    }

    /// Returns the memory of the entries, bytes.
    pub fn memory(&self) -> u64 {
        size_of_val(self.entries.as_slice()) as u64
    }

    /// Returns the full vector, including zeros.
    pub fn to_full(&self, dof_count: usize) -> Vec<f64> {
        let mut full = vec![0.0; dof_count];
        self.add_to(1.0, &mut full);
        full
    }

    /// Returns the sum of vectors, each times its factor, added in the given order.
    pub fn combination<'a>(terms: impl IntoIterator<Item = (f64, &'a SparseVector)>) -> Self {
        let scaled = |(factor, vector): (f64, &'a SparseVector)| {
            vector.entries.iter().map(move |&(dof, value)| (dof, factor * value))
        };
        terms.into_iter().flat_map(scaled).collect()
    }
}

/// Adds the values of the same degree of freedom, in the given order.
impl FromIterator<(usize, f64)> for SparseVector {
    fn from_iter<T: IntoIterator<Item = (usize, f64)>>(entries: T) -> Self {
        let mut entries = entries.into_iter().collect::<Vec<_>>();
        // The sort is stable, so that the order within a degree of freedom remains.
        entries.sort_by_key(|entry| entry.0);
        entries.dedup_by(|next, sum| {
            let same = next.0 == sum.0;
            if same {
                sum.1 += next.1;
            }
            same
        });
        entries.shrink_to_fit();
        Self { entries }
    }
}

/// Builds the square sparse matrix of `(column, row, value)` entries; duplicates are summed in the
/// order given, so symmetric contributions give a matrix symmetric to the bit.
pub fn summed(count: usize, mut entries: Vec<(usize, usize, f64)>) -> SparseColMat<usize, f64> {
    // The sort is stable, so that the order of duplicates remains.
    entries.sort_by_key(|&(column, row, _)| (column, row));
    entries.dedup_by(|next, sum| {
        let same = (next.0, next.1) == (sum.0, sum.1);
        if same {
            sum.2 += next.2;
        }
        same
    });
    let mut starts = vec![0; count + 1];
    for &(column, ..) in &entries {
        starts[column + 1] += 1;
    }
    for column in 0..count {
        starts[column + 1] += starts[column];
    }
    let rows = entries.iter().map(|entry| entry.1).collect();
    let values = entries.iter().map(|entry| entry.2).collect();
    SparseColMat::new(SymbolicSparseColMat::new_checked(count, count, starts, None, rows), values)
}
