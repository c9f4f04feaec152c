//! Static condensation of a mesh: responses to its loads at the loads themselves, at its cuts and
//! in the recovered stresses.
//!
//! Implements the report's equations 2.69 to 2.89, with `h` the amplitudes of given load vectors
//! and `delta` the work-conjugate displacements, so that `B = A^T`; the condensed matrices keep
//! that symmetry.
//!
//! See `docs/theory/substructures.md`.

use super::StructureError;
use super::bore::BoreMeans;
use super::dense::{add_product, cholesky, product, solve};
use super::ring::CutStiffness;
use calyx_fe::dissection::Dissection;
use calyx_fe::elimination::{eliminate, memory};
use calyx_fe::solid::SolidMesh;
use calyx_fe::{PlaneModel, SparseVector};
use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::{Interrupt, MemoryReservation};
use calyx_numerics::vec3::cross;
use faer::sparse::SparseColMat;
use faer::{Mat, MatRef};
use std::collections::BTreeSet;
use std::ops::Range;

/// Assembled equations of a two- or three-dimensional mesh.
pub(super) struct Assembled {
    /// Stiffness matrix, symmetric, both triangles; the degrees of freedom of a node are adjacent.
    pub stiffness: SparseColMat<usize, f64>,
    /// 2 in a plane model, 3 in a three-dimensional one.
    pub dofs_per_node: usize,
    /// Positions of the nodes, m; z is 0 in a plane model.
    pub positions: Vec<[f64; 3]>,
    /// Coordinates of the nodes that determine the order of elimination
    /// ([`SolidMesh::ordering_coordinates`]).
    pub ordering: Vec<[f64; 3]>,
    /// Memory reservation for the stiffness matrix.
    pub room: MemoryReservation,
}

impl Assembled {
    /// Assembles the equations of a plane mesh.
    pub fn plane(model: &PlaneModel) -> Self {
        let positions: Vec<[f64; 3]> = model.mesh.nodes.iter().map(|&[x, y]| [x, y, 0.0]).collect();
        Self {
            stiffness: model.stiffness(),
            dofs_per_node: 2,
            ordering: positions.clone(),
            positions,
            room: MemoryReservation::default(),
        }
    }

    /// Assembles the equations of a three-dimensional mesh after reserving memory for them.
    pub fn solid(
        mesh: &SolidMesh,
        interrupt: &Interrupt,
        stiffness: impl FnOnce() -> Result<SparseColMat<usize, f64>, EngineError>,
    ) -> Result<Self, StructureError> {
        let mut room =
            interrupt.reserve_memory(mesh.stiffness_memory()).map_err(StructureError::Interrupted)?;
        let stiffness = stiffness().map_err(StructureError::Interrupted)?;
        room.shrink_to((stiffness.compute_nnz() * (size_of::<f64>() + size_of::<usize>())) as u64);
        let (positions, ordering) = (mesh.nodes.clone(), mesh.ordering_coordinates());
        Ok(Self { stiffness, dofs_per_node: 3, positions, ordering, room })
    }

    /// Returns the degrees of freedom of nodes, in their order.
    pub fn dofs_of(&self, nodes: &[usize]) -> Vec<usize> {
        let count = self.dofs_per_node;
        nodes.iter().flat_map(|&node| count * node..count * (node + 1)).collect()
    }
}

/// Support of the mesh.
pub(super) enum Support<'a> {
    /// Fixed degrees of freedom.
    Constrained(&'a [usize]),
    /// Fixed degrees of freedom, and mean displacements of the ring's bore that vanish.
    Means {
        /// Fixed degrees of freedom.
        constrained: &'a [usize],
        /// Means that vanish.
        means: &'a BoreMeans,
    },
    /// No support: forces distributed like inertia balance the loads. Load pairs in equilibrium
    /// cause no such forces.
    Free {
        /// Mass matrix of any uniform density: only the distribution of the inertia forces counts.
        mass: &'a SparseColMat<usize, f64>,
        /// All rigid-body motions, three in a plane model and six in three dimensions, as full
        /// vectors.
        motions: &'a [Vec<f64>],
    },
}

impl<'a> Support<'a> {
    /// Returns the support of a ring's sector.
    pub fn for_ring(constrained: &'a [usize], means: Option<&'a BoreMeans>) -> Self {
        match means {
            Some(means) => Support::Means { constrained, means },
            None => Support::Constrained(constrained),
        }
    }
}

/// Nodes of the two cuts of a sector, in the same order.
pub(super) struct Cuts {
    pub first: Vec<usize>,
    pub last: Vec<usize>,
    /// Rotation of the last cut against the first, rad.
    pub angle: f64,
}

/// Mesh condensed onto its cuts, with `m` loads, `q` stress rows and `c` unknowns: those of both
/// cuts and the mean constraint forces of the bore.
pub(super) struct Condensed {
    /// Stiffness, `c` by `c`; `None` without cuts.
    pub stiffness: Option<CutStiffness>,
    /// Equivalent forces on the cuts for each load, and the means over the bore under it with the
    /// cuts fixed, negative; `c` by `m`.
    pub on_cuts: Mat<f64>,
    /// Displacements at the loads by the loads with the cuts fixed, `m` by `m`, symmetric.
    pub own: Mat<f64>,
    /// Stress rows by loads with the cuts fixed, `q` by `m`.
    pub rows_own: Mat<f64>,
    /// Stress rows by the unknowns, `q` by `c`.
    pub rows_cuts: Mat<f64>,
}

/// Condenses a model, with a checkpoint before each part of the elimination. `rows` are linear
/// forms of its displacements that vanish for rigid-body motions.
pub(super) fn condense(
    model: &Assembled,
    support: &Support<'_>,
    cuts: Option<&Cuts>,
    loads: &[SparseVector],
    rows: &[SparseVector],
    interrupt: &Interrupt,
) -> Result<Condensed, StructureError> {
    let checkpoint = || interrupt.check().map_err(StructureError::Interrupted);
    checkpoint()?;
    let kept = cuts.map_or_else(Vec::new, |cuts| [cuts.first.as_slice(), &cuts.last].concat());
    let (constrained, inertia) = match support {
        Support::Constrained(constrained) | Support::Means { constrained, .. } => {
            (constrained.to_vec(), None)
        }
        Support::Free { mass, motions } => {
            (statically_determinate_support(&model.positions, motions), Some(Inertia::new(mass, motions)?))
        }
    };
    let dissection =
        Dissection::new_until(&model.stiffness, &model.ordering, &constrained, &kept, &checkpoint)?;
    let balancing = inertia.as_ref().map_or_else(Vec::new, |inertia| inertia.forces.clone());
    // Mean constraints are processed like loads and retained like cuts.
    let shared = match support {
        Support::Means { means, .. } => means.forms.as_slice(),
        Support::Constrained(_) | Support::Free { .. } => &[],
    };
    let all_loads = [shared, loads, &balancing].concat();
    let _room = interrupt
        .reserve_memory(memory(&dissection, &all_loads, rows))
        .map_err(StructureError::Interrupted)?;
    let left = eliminate(&model.stiffness, &dissection, &all_loads, rows, checkpoint)?;
    checkpoint()?;

    let (m, q) = (loads.len(), rows.len());
    let answering = m + balancing.len();
    let square = left.square.as_ref();
    // Fixed degrees of freedom on a cut have been omitted.
    let mut moving = 0;
    let mut places: Vec<Option<usize>> = model
        .dofs_of(&kept)
        .into_iter()
        .map(|dof| {
            dissection.order[dof]?;
            moving += 1;
            Some(moving - 1)
        })
        .collect();
    let of_cuts = places.len();
    places.extend((moving..moving + shared.len()).map(Some));
    moving += shared.len();
    let c = places.len();
    let mut on_cuts =
        Mat::from_fn(m, c, |load, dof| places[dof].map_or(0.0, |place| square[(moving + load, place)]));
    let mut rows_cuts =
        Mat::from_fn(q, c, |row, dof| places[dof].map_or(0.0, |place| left.forms[(row, place)]));
    let mut own = Mat::from_fn(answering, answering, |row, column| {
        -square[(moving + row.max(column), moving + row.min(column))]
    });
    checkpoint()?;
    let mut rows_own = Mat::from_fn(q, answering, |row, column| -left.forms[(row, moving + column)]);
    if let Some(inertia) = inertia {
        let shares = inertia.balancing(loads);
        // Both directions are treated alike and summed so that symmetry remains to the bit.
        own = balanced(own.as_ref(), m, shares.as_ref());
        let mut of_loads = rows_own.as_ref().subcols(0, m).to_owned();
        add_product(of_loads.as_mut(), -1.0, rows_own.as_ref().subcols(m, balancing.len()), shares.as_ref());
        rows_own = of_loads;
    }
    checkpoint()?;
    let stiffness = cuts.map(|cuts| {
        // Each fixed degree of freedom gets an uncoupled spring, so that every node of a cut has
        // the same number of unknowns.
        let mut matrix = Mat::from_fn(c, c, |row, column| match (places[row], places[column]) {
            (Some(row), Some(column)) => square[(row.max(column), row.min(column))],
            _ if row == column => square[(0, 0)],
            _ => 0.0,
        });
        let last = of_cuts / 2..of_cuts;
        for _ in 0..2 {
            turn(&mut matrix, last.clone(), model.dofs_per_node, cuts.angle);
            matrix = matrix.transpose().to_owned();
        }
        turn(&mut on_cuts, last.clone(), model.dofs_per_node, cuts.angle);
        turn(&mut rows_cuts, last, model.dofs_per_node, cuts.angle);
        match support {
            Support::Means { means, .. } => CutStiffness::with_shared(matrix, means.shared.clone()),
            Support::Constrained(_) | Support::Free { .. } => CutStiffness::new(matrix),
        }
    });
    Ok(Condensed { stiffness, on_cuts: on_cuts.transpose().to_owned(), own, rows_own, rows_cuts })
}

/// Orders the nodes of the last cut as those of the first one, rotated by `angle` about the z axis;
/// nodes in `constrained` belong to neither.
pub(super) fn match_cuts(
    positions: &[[f64; 3]],
    first: &[usize],
    last: &[usize],
    constrained: &[usize],
    angle: f64,
) -> Option<Cuts> {
    let constrained: BTreeSet<usize> = constrained.iter().copied().collect();
    let free =
        |cut: &[usize]| cut.iter().copied().filter(|node| !constrained.contains(node)).collect::<Vec<_>>();
    let (first, mut rest) = (free(first), free(last));
    if first.len() != rest.len() || first.is_empty() {
        return None;
    }
    let size = positions.iter().map(|&[x, y, _]| x.hypot(y)).fold(0.0, f64::max);
    let (sin, cos) = angle.sin_cos();
    let mut ordered = Vec::with_capacity(rest.len());
    for &node in &first {
        let [x, y, z] = positions[node];
        let target = [cos * x - sin * y, sin * x + cos * y, z];
        let near = |other: usize| distance(positions[other], target) <= 1e-8 * size;
        let found = rest.iter().position(|&other| near(other))?;
        ordered.push(rest.swap_remove(found));
    }
    Some(Cuts { first, last: ordered, angle })
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1]).hypot(a[2] - b[2])
}

/// Replaces the columns of nodes by those of displacements in a frame rotated by `angle` about z.
pub(super) fn turn(matrix: &mut Mat<f64>, columns: Range<usize>, dofs_per_node: usize, angle: f64) {
    let (sin, cos) = angle.sin_cos();
    for column in columns.step_by(dofs_per_node) {
        for row in 0..matrix.nrows() {
            let (x, y) = (matrix[(row, column)], matrix[(row, column + 1)]);
            matrix[(row, column)] = cos * x + sin * y;
            matrix[(row, column + 1)] = cos * y - sin * x;
        }
    }
}

/// Forces distributed like the inertia of a body.
struct Inertia<'a> {
    motions: &'a [Vec<f64>],
    /// Inertia forces by the acceleration along each rigid-body motion.
    forces: Vec<SparseVector>,
    /// Cholesky factor of the inertia of the rigid-body motions.
    factor: Mat<f64>,
}

impl<'a> Inertia<'a> {
    fn new(mass: &SparseColMat<usize, f64>, motions: &'a [Vec<f64>]) -> Result<Self, StructureError> {
        let mut forces = Mat::<f64>::zeros(mass.nrows(), motions.len());
        for entry in mass.triplet_iter() {
            for (mode, motion) in motions.iter().enumerate() {
                forces[(entry.row, mode)] += *entry.val * motion[entry.col];
            }
        }
        let of_motions = Mat::from_fn(mass.nrows(), motions.len(), |row, mode| motions[mode][row]);
        let factor = cholesky(product(of_motions.transpose(), forces.as_ref()));
        let sparse = |force: faer::ColRef<'_, f64>| force.iter().copied().enumerate().collect();
        Ok(Self {
            motions,
            forces: forces.col_iter().map(sparse).collect(),
            factor: factor.ok_or(StructureError::NoArea)?,
        })
    }

    /// Returns the accelerations caused by loads (columns), one for each rigid-body motion.
    fn balancing(&self, loads: &[SparseVector]) -> Mat<f64> {
        let work =
            Mat::from_fn(self.motions.len(), loads.len(), |mode, load| loads[load].dot(&self.motions[mode]));
        solve(self.factor.as_ref(), work)
    }
}

/// Returns the responses of balanced loads to balanced loads: each of the first `m` loads, less
/// `shares` of the others.
fn balanced(responses: MatRef<'_, f64>, m: usize, shares: MatRef<'_, f64>) -> Mat<f64> {
    let others = responses.nrows() - m;
    let (own, across, last) = (
        responses.submatrix(0, 0, m, m),
        responses.submatrix(0, m, m, others),
        responses.submatrix(m, m, others, others),
    );
    // R - C S - (C S)^T + S^T L S, of which the lower triangle counts.
    let mut between = product(across, shares);
    add_product(between.as_mut(), -0.5, product(shares.transpose(), last).as_ref(), shares);
    Mat::from_fn(m, m, |row, column| own[(row, column)] - (between[(row, column)] + between[(column, row)]))
}

/// Selects a statically determinate support with as many degrees of freedom as there are rigid-body
/// motions: of three distant nodes, those on which the motions depend most.
pub(super) fn statically_determinate_support(positions: &[[f64; 3]], motions: &[Vec<f64>]) -> Vec<usize> {
    let axes = motions.first().map_or(0, |motion| motion.len() / positions.len().max(1));
    let farthest = |measure: &dyn Fn(usize) -> f64| {
        (0..positions.len()).fold(0, |best, node| if measure(node) > measure(best) { node } else { best })
    };
    let second = farthest(&|node| distance(positions[node], positions[0]));
    let off_line = |node: usize| {
        let [a, b] =
            [0, second].map(|from| [0, 1, 2].map(|axis| positions[node][axis] - positions[from][axis]));
        distance(cross(a, b), [0.0; 3])
    };
    let third = farthest(&off_line);
    let candidates: Vec<usize> =
        [0, second, third].into_iter().flat_map(|node| axes * node..axes * (node + 1)).collect();
    // Each motion is scaled by its largest displacement, so that rotations compare with
    // translations.
    let mut left = Mat::from_fn(candidates.len(), motions.len(), |row, mode| {
        let largest = motions[mode].iter().fold(0.0_f64, |largest, part| largest.max(part.abs()));
        motions[mode][candidates[row]] / largest
    });
    // Gaussian elimination with complete pivoting selects the most independent rows.
    let mut chosen = Vec::new();
    for _ in 0..motions.len() {
        let places = (0..left.nrows()).flat_map(|row| (0..left.ncols()).map(move |column| (row, column)));
        let larger = |a, b| if left[b].abs() > left[a].abs() { b } else { a };
        let Some((row, column)) = places.reduce(larger).filter(|&place| left[place] != 0.0) else { break };
        chosen.push(candidates[row]);
        let pivot = left.row(row).to_owned();
        for other in 0..left.nrows() {
            let factor = left[(other, column)] / pivot[column];
            for mode in 0..left.ncols() {
                left[(other, mode)] -= factor * pivot[mode];
            }
            left[(other, column)] = 0.0;
        }
    }
    chosen
}
