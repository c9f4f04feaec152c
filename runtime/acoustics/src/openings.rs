//! Rims of openings of a surface: closed lines of edges.

use crate::mesh::Face;
use std::collections::{BTreeMap, BTreeSet};

/// Directed edges of a face.
pub(crate) fn edges(face: &Face) -> Vec<[usize; 2]> {
    let corners = face.vertices();
    (0..corners.len()).map(|at| [corners[at], corners[(at + 1) % corners.len()]]).collect()
}

/// Returns an edge without its direction.
pub(crate) fn sorted([a, b]: [usize; 2]) -> [usize; 2] {
    [a.min(b), a.max(b)]
}

/// Returns the edges that belong to one face only.
pub fn free_edges(faces: &[Face]) -> BTreeSet<[usize; 2]> {
    let mut count: BTreeMap<[usize; 2], usize> = BTreeMap::new();
    for edge in faces.iter().flat_map(edges).map(sorted) {
        *count.entry(edge).or_default() += 1;
    }
    count.into_iter().filter(|(_, count)| *count == 1).map(|(edge, _)| edge).collect()
}

/// Divides edges into closed lines, each as its vertices in order. `None` if a vertex does not
/// belong to two edges.
pub fn loops(edges: &BTreeSet<[usize; 2]>) -> Option<Vec<Vec<usize>>> {
    let mut around: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    for &[a, b] in edges {
        around.entry(a).or_default().push(b);
        around.entry(b).or_default().push(a);
    }
    if around.values().any(|neighbours| neighbours.len() != 2) {
        return None;
    }
    let (mut reached, mut found) = (BTreeSet::new(), Vec::new());
    for &start in around.keys() {
        let (mut line, mut at) = (Vec::new(), start);
        while reached.insert(at) {
            line.push(at);
            let next = around[&at].iter().find(|next| !reached.contains(next));
            at = next.copied().unwrap_or(start);
        }
        if !line.is_empty() {
            found.push(line);
        }
    }
    Some(found)
}

/// Returns the rims that a set of vertices selects on the skin of solid elements: the boundary of
/// the faces whose vertices all belong to it, such as both ends of a bore, or else the closed line
/// of edges between its vertices. `None` if they form neither.
pub fn selected_rims(faces: &[Face], nodes: &BTreeSet<usize>) -> Option<Vec<Vec<usize>>> {
    let is_selected = |face: &&Face| face.vertices().iter().all(|node| nodes.contains(node));
    let inside: Vec<Face> = faces.iter().filter(is_selected).copied().collect();
    let edges: BTreeSet<[usize; 2]> = match inside.is_empty() {
        false => free_edges(&inside),
        true => faces
            .iter()
            .flat_map(edges)
            .map(sorted)
            .filter(|edge| edge.iter().all(|node| nodes.contains(node)))
            .collect(),
    };
    loops(&edges).filter(|rims| !rims.is_empty())
}
