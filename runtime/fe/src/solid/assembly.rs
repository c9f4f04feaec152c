//! Assembly of element matrices into a sparse matrix: the pattern from the nodes that share
//! elements, with values added in place.
//!
//! There is no sorting. Element matrices are computed in parallel in blocks of fixed size, then
//! added in parallel by columns. Each entry is summed in the order of the elements, so that the
//! result does not depend on the number of threads bit for bit.

use super::mesh::SolidMesh;
use faer::sparse::{SparseColMat, SymbolicSparseColMat};
use rayon::prelude::*;

/// Largest number of element matrices in memory; cubic elements take 20 MB.
const ELEMENTS_AT_ONCE: usize = 64;

/// Number of column ranges that are summed in parallel.
const RANGES: usize = 16;

/// Coupling of nodes in a matrix of three degrees of freedom each.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Coupling {
    /// Every axis with every other.
    Full,
    /// Every axis with itself.
    SameAxis,
}

/// Returns the sum of element matrices. Each is given over pairs of its nodes: for each column node
/// those of its row nodes, for each pair the column-major 3 by 3 block ([`Coupling::Full`]) or one
/// value. There is a `checkpoint` before each block of element matrices.
///
/// # Errors
/// That of the checkpoint.
pub(super) fn assemble<E>(
    mesh: &SolidMesh,
    coupling: Coupling,
    matrix: impl Fn(usize) -> Vec<f64> + Sync,
    checkpoint: impl Fn() -> Result<(), E>,
) -> Result<SparseColMat<usize, f64>, E> {
    checkpoint()?;
    let (starts, neighbours) = neighbours(mesh);
    let rows_per_node = if coupling == Coupling::Full { 3 } else { 1 };
    let mut values = vec![0.0; 3 * rows_per_node * neighbours.len()];

    let mut ranges = Vec::with_capacity(RANGES);
    let mut rest = values.as_mut_slice();
    let mut first = 0;
    for range in 1..=RANGES {
        let end = mesh.nodes.len() * range / RANGES;
        let (own, others) = rest.split_at_mut(3 * rows_per_node * (starts[end] - starts[first]));
        ranges.push((first..end, own));
        (rest, first) = (others, end);
    }
    let present = (0..mesh.elements.len()).filter(|element| !mesh.absent.contains(element));
    let indices = present.collect::<Vec<_>>();
    for portion in indices.chunks(ELEMENTS_AT_ONCE) {
        checkpoint()?;
        let matrices = portion.par_iter().map(|&element| matrix(element)).collect::<Vec<_>>();
        ranges.par_iter_mut().for_each(|(range, values)| {
            let offset = starts[range.start];
            let mut places = Vec::new();
            for (&element, matrix) in portion.iter().zip(&matrices) {
                let nodes = &mesh.elements[element].nodes;
                let size = matrix.len() / nodes.len();
                for (&column, matrix) in nodes.iter().zip(matrix.chunks_exact(size)) {
                    if !range.contains(&column) {
                        continue;
                    }
                    let around = &neighbours[starts[column]..starts[column + 1]];
                    places.clear();
                    places.extend(nodes.iter().map(|row| around.partition_point(|other| other < row)));
                    let height = rows_per_node * around.len();
                    let first = 3 * rows_per_node * (starts[column] - offset);
                    add(coupling, &mut values[first..first + 3 * height], height, &places, matrix);
                }
            }
        });
    }

    checkpoint()?;
    let mut column_starts = Vec::with_capacity(mesh.dof_count() + 1);
    let mut rows = Vec::with_capacity(values.len());
    column_starts.push(0);
    for column in 0..mesh.nodes.len() {
        let around = &neighbours[starts[column]..starts[column + 1]];
        for axis in 0..3 {
            match coupling {
                Coupling::Full => rows.extend(around.iter().flat_map(|&row| 3 * row..3 * row + 3)),
                Coupling::SameAxis => rows.extend(around.iter().map(|&row| 3 * row + axis)),
            }
            column_starts.push(rows.len());
        }
    }
    let size = mesh.dof_count();
    Ok(SparseColMat::new(SymbolicSparseColMat::new_checked(size, size, column_starts, None, rows), values))
}

/// Adds the blocks of a column node to the node's three columns of a height, at the positions of
/// the row nodes.
fn add(coupling: Coupling, columns: &mut [f64], height: usize, places: &[usize], blocks: &[f64]) {
    for (axis, column) in columns.chunks_exact_mut(height).enumerate() {
        match coupling {
            Coupling::Full => {
                for (place, block) in places.iter().zip(blocks.chunks_exact(9)) {
                    for row in 0..3 {
                        column[3 * place + row] += block[3 * axis + row];
                    }
                }
            }
            Coupling::SameAxis => {
                for (place, value) in places.iter().zip(blocks) {
                    column[*place] += value;
                }
            }
        }
    }
}

/// Returns for each node the nodes that share an element with it, including itself, ascending:
/// start indices, and all lists concatenated.
fn neighbours(mesh: &SolidMesh) -> (Vec<usize>, Vec<usize>) {
    let mut elements_of = vec![Vec::new(); mesh.nodes.len()];
    for (index, element) in mesh.elements.iter().enumerate().filter(|(k, _)| !mesh.absent.contains(k)) {
        for &node in &element.nodes {
            elements_of[node].push(index);
        }
    }
    // Each node is appended to its neighbours' lists in turn, so that the lists ascend.
    let mut lists = vec![Vec::new(); mesh.nodes.len()];
    let mut told_by = vec![usize::MAX; mesh.nodes.len()];
    for (node, elements) in elements_of.iter().enumerate() {
        for &other in elements.iter().flat_map(|&element| &mesh.elements[element].nodes) {
            if told_by[other] != node {
                told_by[other] = node;
                lists[other].push(node);
            }
        }
    }
    let mut starts = vec![0];
    for list in &lists {
        starts.push(starts[starts.len() - 1] + list.len());
    }
    (starts, lists.concat())
}
