//! Skin of shell elements: their mid-surface, with lids over its openings.

use crate::error::AcousticError;
use crate::mesh::{Face, SurfaceMesh};
use crate::openings::{edges, free_edges, loops, sorted};
use crate::plane::RigidPlane;
use crate::skin::{Skin, extent, volume};
use calyx_numerics::vec3::{Vector, plus, scaled};
use std::collections::{BTreeMap, BTreeSet};

/// Reason why shells do not enclose a body. Indices are those of nodes.
#[derive(Clone, Debug, PartialEq)]
pub enum ShellProblem {
    /// Free edges remain.
    Open {
        /// Closed lines of free edges.
        rims: Vec<Vec<usize>>,
        /// Number of all free edges.
        edges: usize,
    },
    /// More than two shells meet along an edge, and none of them ends in a free edge.
    Junction {
        /// Nodes of the edge.
        edge: [usize; 2],
        /// Number of shells.
        shells: usize,
    },
    /// The surface has only one side, like a Möbius strip.
    OneSided {
        /// Nodes of an edge.
        edge: [usize; 2],
    },
    /// Two closed parts intersect.
    Intersection {
        /// Node of one part inside of the other one.
        node: usize,
    },
    /// The surface is degenerate.
    Mesh(AcousticError),
}

impl From<AcousticError> for ShellProblem {
    fn from(error: AcousticError) -> Self {
        Self::Mesh(error)
    }
}

/// Skin of shells.
#[derive(Clone, Debug, PartialEq)]
pub struct ShellSkin {
    /// The skin.
    pub skin: Skin,
    /// Number of shells that are left out: ribs that end in a free edge, and parts inside.
    pub left_out: usize,
}

impl ShellSkin {
    /// Closes the surface of shells, whose normals may have any sense, by lids along the free edges
    /// whose nodes all belong to an opening. Ribs that end in a free edge, and parts that others
    /// enclose, are left out.
    ///
    /// Also returns the number of lids of each opening.
    ///
    /// # Errors
    /// The shells and lids do not enclose a body.
    pub fn new(
        nodes: &[Vector],
        shells: &[Face],
        openings: &[BTreeSet<usize>],
        plane: Option<RigidPlane>,
    ) -> Result<(Self, Vec<usize>), ShellProblem> {
        let is_rim =
            |edge: &[usize; 2]| openings.iter().any(|opening| edge.iter().all(|node| opening.contains(node)));
        let all = shells.len();
        let mut shells = without_ribs(shells, is_rim)?;
        let free = free_edges(&shells);
        let open: BTreeSet<[usize; 2]> = free.iter().copied().filter(|edge| !is_rim(edge)).collect();
        if !open.is_empty() {
            // The whole free edge, with the parts of it that openings select.
            let rims = loops(&free).unwrap_or_default();
            let is_open = |rim: &Vec<usize>| {
                (0..rim.len()).any(|k| open.contains(&sorted([rim[k], rim[(k + 1) % rim.len()]])))
            };
            let rims = rims.into_iter().filter(is_open).collect();
            return Err(ShellProblem::Open { rims, edges: open.len() });
        }
        orient(&mut shells)?;
        let rims = loops(&free).unwrap_or_default();
        let opening_of = |rim: &Vec<usize>| {
            openings.iter().position(|opening| rim.iter().all(|node| opening.contains(node)))
        };
        // Rims that touch, or that no opening has as a whole, cannot be closed.
        let others: Vec<_> = rims.iter().filter(|rim| opening_of(rim).is_none()).cloned().collect();
        if !others.is_empty() || (rims.is_empty() && !free.is_empty()) {
            return Err(ShellProblem::Open { rims: others, edges: free.len() });
        }
        let mut origins: Vec<Vec<usize>> = (0..nodes.len()).map(|node| vec![node]).collect();
        let mut points = nodes.to_vec();
        let directed: BTreeSet<[usize; 2]> = shells.iter().flat_map(edges).collect();
        let mut closed: Vec<usize> = vec![0; openings.len()];
        for rim in &rims {
            closed[opening_of(rim).unwrap_or_default()] += 1;
            let centre = points.len();
            let sum = rim.iter().fold([0.0; 3], |sum, &node| plus(sum, nodes[node]));
            points.push(scaled(sum, 1.0 / rim.len() as f64));
            origins.push(rim.clone());
            for (at, &from) in rim.iter().enumerate() {
                let to = rim[(at + 1) % rim.len()];
                // The lid runs along the rim in the opposite sense.
                let is_directed = directed.contains(&[from, to]);
                let [from, to] = if is_directed { [to, from] } else { [from, to] };
                shells.push(Face::Triangle([from, to, centre]));
            }
        }
        let lids: usize = rims.iter().map(Vec::len).sum();
        let kept = outside(&points, shells)?;
        let left_out = all + lids - kept.len();
        Ok((Self { skin: numbered(&points, &kept, &origins, plane)?, left_out }, closed))
    }
}

/// Removes connected shells with a free edge that begins at a junction with others.
fn without_ribs(shells: &[Face], is_rim: impl Fn(&[usize; 2]) -> bool) -> Result<Vec<Face>, ShellProblem> {
    let mut shells = shells.to_vec();
    loop {
        let around = around(&shells);
        let Some((&edge, of_edge)) = around.iter().find(|(_, of_edge)| of_edge.len() > 2) else {
            return Ok(shells);
        };
        let parts = parts(&shells, &around);
        let count = parts.iter().max().map_or(0, |last| last + 1);
        // A free edge of a rib begins at a junction; the rim of an opening in a wall does not.
        let junctions: BTreeSet<usize> =
            around.iter().filter(|(_, of_edge)| of_edge.len() > 2).flat_map(|(edge, _)| *edge).collect();
        let mut is_rib = vec![false; count];
        for (edge, of_edge) in around.iter().filter(|(_, of_edge)| of_edge.len() == 1) {
            let meets = edge.iter().any(|node| junctions.contains(node));
            is_rib[parts[of_edge[0]]] |= meets && !is_rim(edge);
        }
        if !is_rib.contains(&true) {
            return Err(ShellProblem::Junction { edge, shells: of_edge.len() });
        }
        let kept = shells.iter().zip(&parts).filter(|(_, part)| !is_rib[**part]);
        shells = kept.map(|(shell, _)| *shell).collect();
    }
}

/// Returns the shells at each edge.
fn around(shells: &[Face]) -> BTreeMap<[usize; 2], Vec<usize>> {
    let mut around: BTreeMap<[usize; 2], Vec<usize>> = BTreeMap::new();
    for (index, shell) in shells.iter().enumerate() {
        edges(shell).into_iter().for_each(|edge| around.entry(sorted(edge)).or_default().push(index));
    }
    around
}

/// Returns the part of each shell: those that edges with two shells connect.
fn parts(shells: &[Face], around: &BTreeMap<[usize; 2], Vec<usize>>) -> Vec<usize> {
    let mut parts = vec![usize::MAX; shells.len()];
    let mut count = 0;
    for start in 0..shells.len() {
        if parts[start] != usize::MAX {
            continue;
        }
        let mut stack = vec![start];
        parts[start] = count;
        while let Some(shell) = stack.pop() {
            for edge in edges(&shells[shell]).into_iter().map(sorted) {
                for &other in around[&edge].iter().filter(|_| around[&edge].len() == 2) {
                    if parts[other] == usize::MAX {
                        parts[other] = count;
                        stack.push(other);
                    }
                }
            }
        }
        count += 1;
    }
    parts
}

fn reversed(face: &Face) -> Face {
    let mut face = *face;
    match &mut face {
        Face::Triangle(corners) => corners.reverse(),
        Face::Quadrilateral(corners) => corners.reverse(),
    }
    face
}

/// Reverses shells so that neighbours have normals on the same side.
fn orient(shells: &mut [Face]) -> Result<(), ShellProblem> {
    let around = around(shells);
    let mut reached = vec![false; shells.len()];
    for start in 0..shells.len() {
        if std::mem::replace(&mut reached[start], true) {
            continue;
        }
        let mut stack = vec![start];
        while let Some(shell) = stack.pop() {
            for edge in edges(&shells[shell]) {
                for &other in around[&sorted(edge)].iter().filter(|&&other| other != shell) {
                    let is_opposite = edges(&shells[other]).contains(&[edge[1], edge[0]]);
                    match (reached[other], is_opposite) {
                        (true, false) => return Err(ShellProblem::OneSided { edge: sorted(edge) }),
                        (true, true) => {}
                        (false, _) => {
                            if !is_opposite {
                                shells[other] = reversed(&shells[other]);
                            }
                            reached[other] = true;
                            stack.push(other);
                        }
                    }
                }
            }
        }
    }
    Ok(())
}

/// Returns the closed parts with normals out of the body, without those that the largest one
/// encloses.
fn outside(points: &[Vector], faces: Vec<Face>) -> Result<Vec<Face>, ShellProblem> {
    let of_faces = parts(&faces, &around(&faces));
    let count = of_faces.iter().max().map_or(0, |last| last + 1);
    let mut all: Vec<Vec<Face>> = vec![Vec::new(); count];
    for (face, part) in faces.into_iter().zip(of_faces) {
        all[part].push(face);
    }
    for part in &mut all {
        if volume(points, part) < 0.0 {
            part.iter_mut().for_each(|face| *face = reversed(face));
        }
    }
    all.sort_by(|one, other| extent(points, other).total_cmp(&extent(points, one)));
    let mut parts = all.into_iter();
    let Some(mut kept) = parts.next() else { return Ok(Vec::new()) };
    let origins: Vec<Vec<usize>> = (0..points.len()).map(|point| vec![point]).collect();
    let mut meshes = vec![numbered(points, &kept, &origins, None)?.mesh];
    for part in parts {
        let used: BTreeSet<usize> = part.iter().flat_map(Face::vertices).copied().collect();
        let is_in_largest = |&&node: &&usize| meshes[0].enclosure(points[node]) >= 0.5;
        let inside = used.iter().filter(is_in_largest).count();
        if inside == used.len() {
            continue;
        }
        let own = numbered(points, &part, &origins, None)?.mesh;
        let common = |other: &SurfaceMesh| {
            let of_part = used.iter().find(|node| other.enclosure(points[**node]) >= 0.5).copied();
            let position = |at: &Vector| points.iter().position(|point| point == at);
            let at_vertex = || other.vertices().iter().find(|at| own.enclosure(**at) >= 0.5);
            of_part.or_else(|| at_vertex().and_then(position))
        };
        if let Some(node) = meshes.iter().find_map(common) {
            return Err(ShellProblem::Intersection { node });
        }
        meshes.push(own);
        kept.extend(part);
    }
    Ok(kept)
}

/// Creates the skin with the vertices of its faces only.
fn numbered(
    points: &[Vector],
    faces: &[Face],
    origins: &[Vec<usize>],
    plane: Option<RigidPlane>,
) -> Result<Skin, AcousticError> {
    let used: BTreeSet<usize> = faces.iter().flat_map(Face::vertices).copied().collect();
    let numbers: BTreeMap<usize, usize> = used.iter().enumerate().map(|(new, &old)| (old, new)).collect();
    let renumbered = |face: &Face| match *face {
        Face::Triangle(corners) => Face::Triangle(corners.map(|corner| numbers[&corner])),
        Face::Quadrilateral(corners) => Face::Quadrilateral(corners.map(|corner| numbers[&corner])),
    };
    let faces: Vec<Face> = faces.iter().map(renumbered).collect();
    let vertices = used.iter().map(|&point| points[point]).collect();
    let nodes = used.iter().map(|&point| origins[point].clone()).collect();
    Ok(Skin { mesh: SurfaceMesh::new(vertices, &faces, plane)?, nodes })
}
