//! Bodies that are their own mirror images in mid-face, as spur gears are whose web stands in the middle.
//!
//! Displacements that the mirror leaves as they are and displacements that it turns into their opposite do not know of each other.
//! Either kind is known from the nodes on one side, so that each is a problem of half the unknowns, with half of the loads (polynomials along
//! the face are even or odd). Nothing is left out, and condensing both takes a quarter of the work of condensing the whole.

use super::responses::{Exchange, Sector};
use crate::fe::SparseVector;
use crate::fe::solid::SolidMesh;
use crate::structure::condense::{Assembled, Cuts};
use faer::sparse::{SparseColMat, SymbolicSparseColMat};
use std::collections::BTreeSet;

/// How far a node may be from the mirror image of its like, relative to the face width: rounding.
const SAME: f64 = 1e-11;
/// Rows that differ by less than this, relative to their largest entry, are one.
const EQUAL: f64 = 1e-10;

/// The nodes of a mesh and their mirror images.
pub(super) struct Mirrored {
    /// By node.
    image: Vec<usize>,
    /// Nodes of the first half with those on the mirror, ascending.
    half: Vec<usize>,
    /// By node: the place in `half` of the node itself or of its image.
    place: Vec<usize>,
}

/// A half, to be condensed: degrees of freedom are those of its own nodes.
pub(super) struct Half {
    pub assembled: Assembled,
    pub cuts: Cuts,
    /// Degrees of freedom that do not move.
    pub held: Vec<usize>,
    pub loads: Kept<usize>,
    pub rows: Kept<Option<(usize, f64)>>,
}

/// Vectors of a half, and how those of the whole are numbered among them or they among those.
pub(super) struct Kept<N> {
    pub vectors: Vec<SparseVector>,
    pub numbers: Vec<N>,
}

/// Displacements of one kind: by axis, the sign of those of a node's image.
#[derive(Clone, Copy)]
struct Signs([f64; 3]);

impl Mirrored {
    /// `None` if the mesh is not its own mirror image, node by node.
    pub fn of(mesh: &SolidMesh) -> Option<Self> {
        let swept = mesh.swept.as_ref()?;
        let [start, end] = swept.z_range();
        let near = |a: f64, b: f64| (a - b).abs() <= SAME * (end - start);
        let mut mirrored = Self { image: vec![0; mesh.nodes.len()], half: Vec::new(), place: Vec::new() };
        for axode in swept.axode_starts.windows(2) {
            for node in axode[0]..axode[1] {
                let image = axode[0] + axode[1] - 1 - node;
                let ([x, y, z], [u, v, w]) = (mesh.nodes[node], mesh.nodes[image]);
                if !(near(x, u) && near(y, v) && near(z - start, end - w)) {
                    return None;
                }
                mirrored.image[node] = image;
            }
        }
        let (count, layers) = (swept.section.elements.len(), swept.stations.len() - 1);
        let image = |element: usize| (layers - 1 - element / count) * count + element % count;
        if !mesh.absent.iter().all(|&element| mesh.absent.contains(&image(element))) {
            return None;
        }
        // Along an axode numbers grow with the axial coordinate.
        mirrored.half = (0..mesh.nodes.len()).filter(|&node| node <= mirrored.image[node]).collect();
        mirrored.place = vec![0; mesh.nodes.len()];
        for (place, &node) in mirrored.half.iter().enumerate() {
            mirrored.place[node] = place;
            mirrored.place[mirrored.image[node]] = place;
        }
        Some(mirrored)
    }

    fn on_mirror(&self, node: usize) -> bool {
        self.image[node] == node
    }

    fn is_first(&self, node: usize) -> bool {
        node <= self.image[node]
    }

    /// The problem of the displacements that the mirror leaves as they are, or of those that it turns into their `odd` opposite.
    pub fn half(&self, odd: bool, sector: &Sector, exchange: &Exchange) -> Half {
        let signs = Signs(if odd { [-1.0, -1.0, 1.0] } else { [1.0, 1.0, -1.0] });
        let of_half = |nodes: &[usize]| -> Vec<usize> {
            nodes.iter().filter(|&&node| self.is_first(node)).map(|&node| self.place[node]).collect()
        };
        let cuts = Cuts {
            first: of_half(&sector.cuts.first),
            last: of_half(&sector.cuts.last),
            angle: sector.cuts.angle,
        };
        let on_cuts: BTreeSet<usize> = cuts.first.iter().chain(&cuts.last).copied().collect();
        let held_nodes = of_half(&sector.held).into_iter().flat_map(|place| 3 * place..3 * place + 3);
        let still = (0..3 * self.half.len())
            .filter(|dof| self.is_still(self.half[dof / 3], dof % 3, signs) && !on_cuts.contains(&(dof / 3)));
        let mut held: Vec<usize> = held_nodes.chain(still).collect();
        held.sort_unstable();
        held.dedup();
        let assembled = Assembled {
            stiffness: self.stiffness(&sector.assembled.stiffness, signs),
            dofs_per_node: 3,
            positions: self.half.iter().map(|&node| sector.assembled.positions[node]).collect(),
        };
        let numbers: Vec<usize> =
            (0..exchange.loads.len()).filter(|&load| exchange.odd[load] == odd).collect();
        let vectors = numbers.iter().map(|&load| self.folded(&exchange.loads[load], signs)).collect();
        Half {
            assembled,
            cuts,
            held,
            loads: Kept { vectors, numbers },
            rows: self.rows(exchange, signs, if odd { -1.0 } else { 1.0 }),
        }
    }

    /// Whether a node moves along an axis in none of these displacements: it is its own image.
    fn is_still(&self, node: usize, axis: usize, signs: Signs) -> bool {
        self.on_mirror(node) && signs.0[axis] < 0.0
    }

    /// What a displacement of the half is at a degree of freedom of the whole: the number of the former, and its sign; `None` where
    /// nothing moves.
    fn seen(&self, dof: usize, signs: Signs) -> Option<(usize, f64)> {
        let (node, axis) = (dof / 3, dof % 3);
        let sign = if self.is_first(node) { 1.0 } else { signs.0[axis] };
        (!self.is_still(node, axis, signs)).then(|| (3 * self.place[node] + axis, sign))
    }

    /// Work of forces on displacements of the half.
    fn folded(&self, forces: &SparseVector, signs: Signs) -> SparseVector {
        let seen =
            |&(dof, value): &(usize, f64)| self.seen(dof, signs).map(|(own, sign)| (own, sign * value));
        forces.entries.iter().filter_map(seen).collect()
    }

    /// Rows of the half, one for a place and its image where they are images of each other. `own` is the sign that the mirror gives
    /// displacements of this kind.
    fn rows(&self, exchange: &Exchange, signs: Signs, own: f64) -> Kept<Option<(usize, f64)>> {
        let largest = |row: &SparseVector| row.entries.iter().fold(0.0_f64, |a, (_, b)| a.max(b.abs()));
        let mut kept = Kept { vectors: Vec::<SparseVector>::new(), numbers: Vec::new() };
        for (number, row) in exchange.rows.iter().enumerate() {
            let folded = self.folded(row, signs);
            if largest(&folded) <= EQUAL * largest(row) {
                kept.numbers.push(None);
                continue;
            }
            // A place whose image came before it.
            let image = exchange.images[number].filter(|&(image, _)| image < number);
            let known = image.and_then(|(image, sign)| Some((kept.numbers[image]?, sign * own)));
            let shared = known.filter(|&((at, of_image), sign)| {
                equal(&folded, &kept.vectors[at], of_image * sign, EQUAL * largest(&folded))
            });
            kept.numbers.push(Some(match shared {
                Some(((at, of_image), sign)) => (at, of_image * sign),
                None => {
                    kept.vectors.push(folded);
                    (kept.vectors.len() - 1, 1.0)
                }
            }));
        }
        kept
    }

    /// Stiffness of the half: of the displacements of the whole that belong to its own. What is still has a spring of its own, so that
    /// cuts of every kind have three degrees of freedom a node.
    fn stiffness(&self, whole: &SparseColMat<usize, f64>, signs: Signs) -> SparseColMat<usize, f64> {
        let size = 3 * self.half.len();
        let (mut starts, mut rows, mut values) = (vec![0], Vec::new(), Vec::new());
        let mut sums = vec![0.0; size];
        for &node in &self.half {
            // All three columns have the same rows.
            let around = whole.row_idx_of_col(3 * node).map(|row| self.place[row / 3]);
            let mut around: Vec<usize> = around.collect();
            around.sort_unstable();
            around.dedup();
            // Forces on the node's image do the same work again.
            let twice = if self.on_mirror(node) { 1.0 } else { 2.0 };
            for axis in 0..3 {
                let column = 3 * node + axis;
                for (row, value) in whole.row_idx_of_col(column).zip(whole.val_of_col(column)) {
                    match self.seen(row, signs) {
                        _ if self.is_still(node, axis, signs) => {
                            if row == column {
                                sums[3 * self.place[node] + axis] = *value;
                            }
                        }
                        Some((own, sign)) => sums[own] += twice * sign * value,
                        None => {}
                    }
                }
                for own in around.iter().flat_map(|&place| 3 * place..3 * place + 3) {
                    rows.push(own);
                    values.push(std::mem::take(&mut sums[own]));
                }
                starts.push(rows.len());
            }
        }
        SparseColMat::new(SymbolicSparseColMat::new_checked(size, size, starts, None, rows), values)
    }
}

/// Of each point the one that is its mirror image in the middle of an axial range, if there is one among them.
pub(super) fn images_of(points: &[[f64; 3]], [start, end]: [f64; 2]) -> Vec<Option<usize>> {
    let near = |a: f64, b: f64| (a - b).abs() <= SAME * (end - start);
    let image = |&[x, y, z]: &[f64; 3]| {
        points.iter().position(|&[u, v, w]| near(x, u) && near(y, v) && near(z - start, end - w))
    };
    points.iter().map(image).collect()
}

/// Whether one row is `sign` times the other, up to `slack`.
fn equal(one: &SparseVector, other: &SparseVector, sign: f64, slack: f64) -> bool {
    one.entries.len() == other.entries.len()
        && one
            .entries
            .iter()
            .zip(&other.entries)
            .all(|(a, b)| a.0 == b.0 && (a.1 - sign * b.1).abs() <= slack)
}
