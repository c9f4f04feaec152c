//! Nested dissection: elimination order of the unknowns of a mesh, from the positions of its nodes
//! or other coordinates of them.
//!
//! A separator, a layer of nodes, divides a mesh into two halves and is eliminated after both; the
//! halves are dissected in the same way. The unknowns that are eliminated together form one dense
//! matrix, small at the bottom, and separate halves can be processed in parallel. Meshes of high
//! order are dissected well by positions alone if cuts follow the faces of elements. Every position
//! along every axis is tried, in one pass over the graph, and the cut with the best ratio of
//! separation to size is used.

use faer::sparse::SparseColMat;
use std::collections::HashMap;
use std::convert::Infallible;

/// Largest number of unknowns that are not dissected further. A few elements: below, overhead
/// exceeds the waste of dense arithmetic.
const LEAF: usize = 96;
/// Number of nodes between two checkpoints.
const BATCH: usize = 1024;
/// No slot: the degree of freedom is fixed.
const NONE: usize = usize::MAX;

/// Degrees of freedom that are eliminated together, after those of the parts below.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Part {
    /// Unknowns that are eliminated here, in the order of elimination.
    pub pivots: Vec<usize>,
    /// Other unknowns coupled to the pivots after elimination of the parts below, in the order of
    /// elimination.
    pub boundary: Vec<usize>,
    /// Indices of the parts directly below: all of them precede this one.
    pub below: Vec<usize>,
}

/// Elimination order. The last part is above all others and has no pivots: it contains the retained
/// unknowns.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Dissection {
    /// Parts; those below precede those above.
    pub parts: Vec<Part>,
    /// Position of each degree of freedom in the elimination order, retained ones last, in their
    /// original order; `None` if it is fixed.
    pub order: Vec<Option<usize>>,
}

/// Nodes with the same neighbours, such as the inner ones of an element or of a face between two:
/// they stay together.
struct Group {
    /// Unconstrained degrees of freedom.
    dofs: Vec<usize>,
    position: [f64; 3],
    /// Neighbours without the group itself.
    neighbours: Vec<usize>,
}

impl Dissection {
    /// Orders the unknowns of a stiffness of which only the pattern is read (both triangles; the
    /// degrees of freedom of a node are adjacent). `positions` are those of the nodes or any other
    /// three coordinates of each node, of which only the order counts. The `constrained` degrees of
    /// freedom are omitted, those of the nodes `kept` come last.
    pub fn new(
        stiffness: &SparseColMat<usize, f64>,
        positions: &[[f64; 3]],
        constrained: &[usize],
        kept: &[usize],
    ) -> Self {
        let Ok(ordered) =
            Self::new_until(stiffness, positions, constrained, kept, &|| Ok::<_, Infallible>(()));
        ordered
    }

    /// Orders the unknowns like [`Dissection::new`], with a `checkpoint` before each batch of nodes
    /// and each cut.
    ///
    /// # Errors
    /// That of the checkpoint.
    pub fn new_until<E>(
        stiffness: &SparseColMat<usize, f64>,
        positions: &[[f64; 3]],
        constrained: &[usize],
        kept: &[usize],
        checkpoint: &impl Fn() -> Result<(), E>,
    ) -> Result<Self, E> {
        let per_node = stiffness.ncols() / positions.len().max(1);
        let mut is_constrained = vec![false; stiffness.ncols()];
        constrained.iter().for_each(|&dof| is_constrained[dof] = true);
        let mut is_kept = vec![false; positions.len()];
        kept.iter().for_each(|&node| is_kept[node] = true);
        let groups = group(stiffness, per_node, positions, [&is_constrained, &is_kept], checkpoint)?;
        let mut dissector = Dissector {
            region: vec![0; groups.len()],
            rank: vec![0; groups.len()],
            regions: 0,
            own: Vec::new(),
            below: Vec::new(),
            groups,
        };
        let inner = |&group: &usize| !is_kept[dissector.groups[group].dofs[0] / per_node];
        let all: Vec<usize> = (0..dissector.groups.len()).filter(inner).collect();
        // Retained unknowns are in no region.
        dissector.region.fill(NONE);
        let top = dissector.dissect(all, checkpoint)?;
        dissector.own.push(Vec::new());
        dissector.below.push(top.into_iter().collect());

        let mut order = vec![None; stiffness.ncols()];
        let mut placed = 0;
        let mut place = |dof: usize| {
            order[dof] = Some(placed);
            placed += 1;
        };
        for own in &dissector.own {
            own.iter().flat_map(|&group| &dissector.groups[group].dofs).for_each(|&dof| place(dof));
        }
        let kept = kept.iter().flat_map(|&node| per_node * node..per_node * (node + 1));
        kept.filter(|&dof| !is_constrained[dof]).for_each(place);
        checkpoint()?;
        let parts = dissector.parts(&order);
        Ok(Self { parts, order })
    }

    /// Returns the number of multiplications to eliminate everything, and the number of entries of
    /// the corresponding factor.
    pub fn cost(&self) -> (f64, f64) {
        let of_part = |part: &Part| {
            let columns =
                (0..part.pivots.len()).map(|pivot| (part.pivots.len() - pivot + part.boundary.len()) as f64);
            columns
                .fold((0.0, 0.0), |(work, entries), height| (work + 0.5 * height * height, entries + height))
        };
        self.parts.iter().map(of_part).fold((0.0, 0.0), |sum, part| (sum.0 + part.0, sum.1 + part.1))
    }
}

fn group<E>(
    stiffness: &SparseColMat<usize, f64>,
    per_node: usize,
    positions: &[[f64; 3]],
    [is_constrained, is_kept]: [&[bool]; 2],
    checkpoint: &impl Fn() -> Result<(), E>,
) -> Result<Vec<Group>, E> {
    let moves = |node: usize| (per_node * node..per_node * (node + 1)).any(|dof| !is_constrained[dof]);
    // Nodes by their neighbours, including themselves, and by whether they are retained.
    let mut alike: HashMap<(Vec<usize>, bool), usize> = HashMap::new();
    let mut members: Vec<Vec<usize>> = Vec::new();
    let mut group_of = vec![NONE; positions.len()];
    for node in (0..positions.len()).filter(|&node| moves(node)) {
        if node % BATCH == 0 {
            checkpoint()?;
        }
        let mut near = vec![node];
        for dof in per_node * node..per_node * (node + 1) {
            near.extend(stiffness.row_idx_of_col(dof).map(|row| row / per_node));
            // The rows of a node are adjacent.
            near.dedup();
        }
        near.sort_unstable();
        near.dedup();
        let group = *alike.entry((near, is_kept[node])).or_insert(members.len());
        if group == members.len() {
            members.push(Vec::new());
        }
        members[group].push(node);
        group_of[node] = group;
    }
    let mut neighbours = vec![Vec::new(); members.len()];
    for ((near, _), group) in alike {
        if group % BATCH == 0 {
            checkpoint()?;
        }
        let mut others: Vec<usize> = near
            .iter()
            .map(|&node| group_of[node])
            .filter(|&other| other != NONE && other != group)
            .collect();
        others.sort_unstable();
        others.dedup();
        neighbours[group] = others;
    }
    let of = |(nodes, neighbours): (Vec<usize>, Vec<usize>)| {
        let mean =
            |axis: usize| nodes.iter().map(|&node| positions[node][axis]).sum::<f64>() / nodes.len() as f64;
        let dofs = nodes.iter().flat_map(|&node| per_node * node..per_node * (node + 1));
        Group {
            position: [0, 1, 2].map(mean),
            dofs: dofs.filter(|&dof| !is_constrained[dof]).collect(),
            neighbours,
        }
    };
    Ok(members.into_iter().zip(neighbours).map(of).collect())
}

struct Dissector {
    groups: Vec<Group>,
    /// Index of the most recent set of each group.
    region: Vec<usize>,
    /// Position along the axis of each group of the current set.
    rank: Vec<usize>,
    regions: usize,
    /// Groups by part.
    own: Vec<Vec<usize>>,
    below: Vec<Vec<usize>>,
}

/// Cut of an ordered set before position `at`; the separator is taken from the front or from the
/// back.
#[derive(Clone, Copy)]
struct Cut {
    at: usize,
    from_front: bool,
    /// Cost, to be minimized.
    badness: f64,
}

impl Dissector {
    /// Dissects a set and returns the topmost part; `None` for an empty set.
    fn dissect<E>(
        &mut self,
        set: Vec<usize>,
        checkpoint: &impl Fn() -> Result<(), E>,
    ) -> Result<Option<usize>, E> {
        if set.is_empty() {
            return Ok(None);
        }
        checkpoint()?;
        let cut = if self.weight(&set) > LEAF { self.best_cut(&set) } else { None };
        let Some((ordered, cut)) = cut else {
            self.own.push(set);
            self.below.push(Vec::new());
            return Ok(Some(self.own.len() - 1));
        };
        ordered.iter().enumerate().for_each(|(rank, &group)| self.rank[group] = rank);
        let region = self.region[ordered[0]];
        let crosses = |&group: &usize| {
            let front = self.rank[group] < cut.at;
            front == cut.from_front
                && self.groups[group]
                    .neighbours
                    .iter()
                    .any(|&other| self.region[other] == region && (self.rank[other] < cut.at) != front)
        };
        let (layer, rest): (Vec<usize>, Vec<usize>) = ordered.iter().partition(|&group| crosses(group));
        let (front, behind): (Vec<usize>, Vec<usize>) =
            rest.into_iter().partition(|&group| self.rank[group] < cut.at);
        let mut below = Vec::new();
        for half in [front, behind] {
            below.extend(self.dissect(half, checkpoint)?);
        }
        self.own.push(layer);
        self.below.push(below);
        Ok(Some(self.own.len() - 1))
    }

    fn weight(&self, set: &[usize]) -> usize {
        set.iter().map(|&group| self.groups[group].dofs.len()).sum()
    }

    /// Returns the best cut along any axis, with the set sorted along it.
    fn best_cut(&mut self, set: &[usize]) -> Option<(Vec<usize>, Cut)> {
        self.regions += 1;
        set.iter().for_each(|&group| self.region[group] = self.regions);
        let mut best: Option<(Vec<usize>, Cut)> = None;
        for axis in 0..3 {
            let mut ordered = set.to_vec();
            let place = |group: usize| self.groups[group].position[axis];
            ordered.sort_by(|&a, &b| place(a).total_cmp(&place(b)).then(a.cmp(&b)));
            if place(ordered[0]) == place(ordered[ordered.len() - 1]) {
                continue;
            }
            if let Some(cut) = self.best_along(&ordered)
                && best.as_ref().is_none_or(|(_, other)| cut.badness < other.badness)
            {
                best = Some((ordered, cut));
            }
        }
        best
    }

    fn best_along(&mut self, ordered: &[usize]) -> Option<Cut> {
        ordered.iter().enumerate().for_each(|(rank, &group)| self.rank[group] = rank);
        let region = self.region[ordered[0]];
        let count = ordered.len();
        // Change of the separator's weight from one cut position to the next, for separators in
        // front of the cut and behind it.
        let mut change = [vec![0_i64; count + 1], vec![0_i64; count + 1]];
        let mut before = vec![0_i64; count + 1];
        for (rank, &group) in ordered.iter().enumerate() {
            let weight = self.groups[group].dofs.len() as i64;
            before[rank + 1] = before[rank] + weight;
            let near = self.groups[group].neighbours.iter().filter(|&&other| self.region[other] == region);
            let (first, last) = near.fold((rank, rank), |(first, last), &other| {
                (first.min(self.rank[other]), last.max(self.rank[other]))
            });
            // The group is in the separator in front of a cut at rank + 1 ..= last, and in the one
            // behind a cut at first + 1 ..= rank.
            change[0][rank + 1] += weight;
            change[0][last + 1] -= weight;
            change[1][first + 1] += weight;
            change[1][rank + 1] -= weight;
        }
        let total = before[count];
        let mut layers = [0_i64; 2];
        let mut best: Option<Cut> = None;
        for at in 1..count {
            for (side, from_front) in [(0, true), (1, false)] {
                layers[side] += change[side][at];
                let layer = layers[side];
                let (mut front, mut behind) = (before[at], total - before[at]);
                if from_front {
                    front -= layer
                } else {
                    behind -= layer
                }
                // An empty half is not allowed: the cut would separate nothing but the separator
                // itself.
                if front <= 0 || behind <= 0 {
                    continue;
                }
                let badness = (layer as f64 + 1.0) / (front as f64 * behind as f64);
                if best.is_none_or(|other| badness < other.badness) {
                    best = Some(Cut { at, from_front, badness });
                }
            }
        }
        best
    }

    /// Returns the parts with their boundaries, by symbolic elimination of the groups.
    fn parts(self, order: &[Option<usize>]) -> Vec<Part> {
        let place = |group: usize| order[self.groups[group].dofs[0]];
        let mut boundaries: Vec<Vec<usize>> = Vec::with_capacity(self.own.len());
        let mut parts = Vec::with_capacity(self.own.len());
        let mut marked = vec![NONE; self.groups.len()];
        for (number, (own, below)) in self.own.iter().zip(self.below).enumerate() {
            own.iter().for_each(|&group| marked[group] = number);
            let last = own.iter().filter_map(|&group| place(group)).max();
            let mut boundary = Vec::new();
            let coupled = own.iter().flat_map(|&group| &self.groups[group].neighbours);
            let inherited = below.iter().flat_map(|&part| &boundaries[part]);
            for &group in coupled.chain(inherited) {
                if marked[group] != number && last.is_none_or(|last| place(group) > Some(last)) {
                    marked[group] = number;
                    boundary.push(group);
                }
            }
            let dofs = |groups: &[usize]| -> Vec<usize> {
                groups.iter().flat_map(|&group| &self.groups[group].dofs).copied().collect()
            };
            let mut part = Part { pivots: dofs(own), boundary: dofs(&boundary), below };
            part.boundary.sort_unstable_by_key(|&dof| order[dof]);
            parts.push(part);
            boundaries.push(boundary);
        }
        parts
    }
}
