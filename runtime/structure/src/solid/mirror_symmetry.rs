//! Bodies with mirror symmetry about mid-face, such as spur gears with a central web.
//!
//! Symmetric and antisymmetric displacements are uncoupled. Each kind is determined by the nodes on
//! one side, so each is a problem of half the unknowns, with half of the loads (polynomials along
//! the face are even or odd). The method is exact, and condensing both takes a quarter of the work
//! of condensing the whole.

use super::exchange::{LoadsAndRows, Sector};
use crate::StructureError;
use crate::condense::{Assembled, Cuts};
use calyx_fe::SparseVector;
use calyx_fe::solid::{SolidElement, SolidMesh, SolidModel};
use calyx_numerics::interrupt::Interrupt;
use std::sync::Arc;

/// Largest distance of a node from the mirror image of its counterpart, relative to the face width:
/// rounding.
const SAME: f64 = 1e-11;
/// Rows with a smaller difference, relative to their largest entry, are equal.
const EQUAL: f64 = 1e-10;

/// Nodes of a mesh and their mirror images.
pub(super) struct MirrorMap {
    /// Image by node.
    image: Vec<usize>,
    /// Nodes of the first half including those on the mirror plane, ascending.
    half: Vec<usize>,
    /// Index in `half` of the node itself or of its image, by node.
    place: Vec<usize>,
    /// Number of elements of the section, and of layers.
    elements: [usize; 2],
}

/// Half of a body, to be condensed: degrees of freedom are those of its own nodes.
pub(super) struct HalfModel {
    pub cuts: Cuts,
    /// Fixed degrees of freedom.
    pub constrained: Vec<usize>,
    pub loads: ReducedVectors<usize>,
    pub rows: ReducedVectors<Option<(usize, f64)>>,
}

/// Vectors of a half, and the correspondence with those of the whole.
pub(super) struct ReducedVectors<N> {
    pub vectors: Vec<SparseVector>,
    pub numbers: Vec<N>,
}

/// Symmetric or antisymmetric displacements: the sign of those of a node's image, by axis.
#[derive(Clone, Copy)]
struct Signs([f64; 3]);

impl Signs {
    fn of(odd: bool) -> Self {
        Self(if odd { [-1.0, -1.0, 1.0] } else { [1.0, 1.0, -1.0] })
    }
}

impl MirrorMap {
    /// Returns `None` if the mesh is not mirror-symmetric node by node.
    pub fn of(mesh: &SolidMesh) -> Option<Self> {
        let swept = mesh.swept.as_ref()?;
        let [start, end] = swept.z_range();
        let near = |a: f64, b: f64| (a - b).abs() <= SAME * (end - start);
        let (count, layers) = (swept.section.elements.len(), swept.stations.len() - 1);
        let mut mirrored = Self {
            image: vec![0; mesh.nodes.len()],
            half: Vec::new(),
            place: Vec::new(),
            elements: [count, layers],
        };
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
        let image = |element: usize| (layers - 1 - element / count) * count + element % count;
        if !mesh.absent.iter().all(|&element| mesh.absent.contains(&image(element))) {
            return None;
        }
        // Along an axode the node index increases with the axial coordinate.
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

    /// Returns the equations of the symmetric and of the antisymmetric displacements. If no element
    /// lies on both sides of the mirror plane, they are equal except for the constraints.
    pub fn equations(
        &self,
        model: &SolidModel,
        interrupt: &Interrupt,
    ) -> Result<[Arc<Assembled>; 2], StructureError> {
        let [count, layers] = self.elements;
        let whole = layers / 2 * count;
        let of_half = |element: &SolidElement| {
            let own = element.nodes.iter().filter(|&&node| self.is_first(node));
            SolidElement { nodes: own.map(|&node| self.place[node]).collect(), ..element.clone() }
        };
        let elements: Vec<SolidElement> =
            model.mesh.elements[..layers.div_ceil(2) * count].iter().map(of_half).collect();
        let half = SolidMesh {
            nodes: self.half.iter().map(|&node| model.mesh.nodes[node]).collect(),
            absent: model.mesh.absent.range(..elements.len()).copied().collect(),
            elements,
            ..SolidMesh::default()
        };
        let assembled = |odd: bool| {
            let signs = Signs::of(odd);
            let of_element = |index: usize, matrix: Vec<f64>| {
                if index < whole {
                    // The image contributes the same work.
                    return matrix.into_iter().map(|value| 2.0 * value).collect();
                }
                self.element(&model.mesh.elements[index].nodes, &half.elements[index].nodes, &matrix, signs)
            };
            let stiffness = || model.reduced_stiffness(&half, of_element, || interrupt.check());
            Assembled::solid(&half, interrupt, stiffness).map(Arc::new)
        };
        let even = assembled(false)?;
        let odd = if layers % 2 == 0 { even.clone() } else { assembled(true)? };
        Ok([even, odd])
    }

    /// Returns the matrix of an element on the mirror plane for those of its `nodes` that belong to
    /// the half, in `own` indices.
    fn element(&self, nodes: &[usize], own: &[usize], matrix: &[f64], signs: Signs) -> Vec<f64> {
        let at = |node: usize| own.iter().position(|&place| place == self.place[node]).unwrap_or(0);
        let sign = |node: usize, axis: usize| if self.is_first(node) { 1.0 } else { signs.0[axis] };
        let mut reduced = vec![0.0; 9 * own.len() * own.len()];
        let mut blocks = matrix.chunks_exact(9);
        for &column in nodes {
            for &row in nodes {
                let Some(block) = blocks.next() else { return reduced };
                let first = 9 * (at(column) * own.len() + at(row));
                for (entry, value) in block.iter().enumerate() {
                    reduced[first + entry] += sign(column, entry / 3) * sign(row, entry % 3) * value;
                }
            }
        }
        reduced
    }

    /// Returns the part of a sector and its loads for symmetric displacements, or antisymmetric
    /// ones if `odd`.
    pub fn half(&self, odd: bool, sector: &Sector, exchange: &LoadsAndRows) -> HalfModel {
        let signs = Signs::of(odd);
        let of_half = |nodes: &[usize]| -> Vec<usize> {
            nodes.iter().filter(|&&node| self.is_first(node)).map(|&node| self.place[node]).collect()
        };
        let cuts = Cuts {
            first: of_half(&sector.cuts.first),
            last: of_half(&sector.cuts.last),
            angle: sector.cuts.angle,
        };
        let constrained_nodes =
            of_half(&sector.constrained).into_iter().flat_map(|place| 3 * place..3 * place + 3);
        let dofs = 0..3 * self.half.len();
        let still = dofs.filter(|dof| self.is_fixed_by_symmetry(self.half[dof / 3], dof % 3, signs));
        let mut constrained: Vec<usize> = constrained_nodes.chain(still).collect();
        constrained.sort_unstable();
        constrained.dedup();
        let numbers: Vec<usize> =
            (0..exchange.loads.len()).filter(|&load| exchange.odd[load] == odd).collect();
        let vectors = numbers.iter().map(|&load| self.folded(&exchange.loads[load], signs)).collect();
        let rows = self.rows(exchange, signs, if odd { -1.0 } else { 1.0 });
        HalfModel { cuts, constrained, loads: ReducedVectors { vectors, numbers }, rows }
    }

    /// Returns true if a node is fixed along an axis in these displacements: it is its own image.
    fn is_fixed_by_symmetry(&self, node: usize, axis: usize, signs: Signs) -> bool {
        self.on_mirror(node) && signs.0[axis] < 0.0
    }

    /// Returns the displacement of the half at a degree of freedom of the whole: the index of the
    /// former, and its sign; `None` where the displacement vanishes.
    fn seen(&self, dof: usize, signs: Signs) -> Option<(usize, f64)> {
        let (node, axis) = (dof / 3, dof % 3);
        let sign = if self.is_first(node) { 1.0 } else { signs.0[axis] };
        (!self.is_fixed_by_symmetry(node, axis, signs)).then(|| (3 * self.place[node] + axis, sign))
    }

    /// Returns the work of forces on displacements of the half.
    fn folded(&self, forces: &SparseVector, signs: Signs) -> SparseVector {
        let seen =
            |&(dof, value): &(usize, f64)| self.seen(dof, signs).map(|(own, sign)| (own, sign * value));
        forces.entries.iter().filter_map(seen).collect()
    }

    /// Returns the rows of the half, one for a point and its image where they are mirror images.
    /// `own` is the sign of the mirror image for displacements of this kind.
    fn rows(&self, exchange: &LoadsAndRows, signs: Signs, own: f64) -> ReducedVectors<Option<(usize, f64)>> {
        let largest = |row: &SparseVector| row.entries.iter().fold(0.0_f64, |a, (_, b)| a.max(b.abs()));
        let mut kept = ReducedVectors { vectors: Vec::<SparseVector>::new(), numbers: Vec::new() };
        for (number, row) in exchange.rows.iter().enumerate() {
            let folded = self.folded(row, signs);
            if largest(&folded) <= EQUAL * largest(row) {
                kept.numbers.push(None);
                continue;
            }
            // A point whose image precedes it.
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
}

/// Finds for each point its mirror image about the middle of an axial range, if it is one of the
/// points.
pub(super) fn images_of(points: &[[f64; 3]], [start, end]: [f64; 2]) -> Vec<Option<usize>> {
    let near = |a: f64, b: f64| (a - b).abs() <= SAME * (end - start);
    let image = |&[x, y, z]: &[f64; 3]| {
        points.iter().position(|&[u, v, w]| near(x, u) && near(y, v) && near(z - start, end - w))
    };
    points.iter().map(image).collect()
}

/// Returns true if one row is `sign` times the other, up to `slack`.
fn equal(one: &SparseVector, other: &SparseVector, sign: f64, slack: f64) -> bool {
    one.entries.len() == other.entries.len()
        && one
            .entries
            .iter()
            .zip(&other.entries)
            .all(|(a, b)| a.0 == b.0 && (a.1 - sign * b.1).abs() <= slack)
}
