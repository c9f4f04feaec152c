//! Cells with straight edges between the nodes of a mesh, for output.
//!
//! An element with a grid of nodes has as many cells as the grid; in coarse output it is a single
//! cell, by its corners.

/// Local coordinates with a smaller difference are equal.
const SAME: f64 = 1e-9;

/// Cells between points.
#[derive(Clone, Debug, Default)]
pub(crate) struct Outline {
    /// Nodes of the mesh, ascending.
    pub nodes: Vec<usize>,
    /// Corners as indices into these nodes: four of a quadrilateral, counter-clockwise; eight of a
    /// hexahedron, those of the face towards the first station before their opposites.
    pub cells: Vec<Vec<usize>>,
    /// Index of the element of each cell.
    pub elements: Vec<usize>,
}

impl Outline {
    /// Returns the cells of elements, each with its nodes and its cells as indices of these.
    pub fn new<'a>(elements: impl Iterator<Item = (&'a [usize], &'a [Vec<usize>])>) -> Outline {
        let (mut cells, mut owners) = (Vec::new(), Vec::new());
        for (index, (nodes, own)) in elements.enumerate() {
            cells.extend(own.iter().map(|cell| cell.iter().map(|&local| nodes[local]).collect::<Vec<_>>()));
            owners.resize(cells.len(), index);
        }
        let mut nodes: Vec<usize> = cells.iter().flatten().copied().collect();
        nodes.sort_unstable();
        nodes.dedup();
        let place = |node: &mut usize| *node = nodes.partition_point(|other| other < node);
        cells.iter_mut().flatten().for_each(place);
        Outline { nodes, cells, elements: owners }
    }
}

/// Returns the cells of an element from the local coordinates of its nodes, and the cell of its
/// corners.
pub(crate) fn cells(places: &[[f64; 3]]) -> [Vec<Vec<usize>>; 2] {
    let values = |axis: usize| {
        let mut values: Vec<f64> = places.iter().map(|place| place[axis]).collect();
        values.sort_by(f64::total_cmp);
        values.dedup_by(|a, b| (*a - *b).abs() < SAME);
        values
    };
    let lines = [0, 1, 2].map(values);
    let near = |a: &[f64; 3], b: &[f64; 3]| (0..3).all(|axis| (a[axis] - b[axis]).abs() < SAME);
    // Finds the node at a point of the grid of all values.
    let node = |at: [usize; 3]| {
        let wanted = [0, 1, 2].map(|axis| lines[axis][at[axis]]);
        places.iter().position(|place| near(place, &wanted))
    };
    let cell = |low: [usize; 3], high: [usize; 3]| {
        let corners = [[0, 0], [1, 0], [1, 1], [0, 1]];
        let layers = if low[2] == high[2] { 0..1 } else { 0..2 };
        let corner = |layer: usize, [x, y]: [usize; 2]| {
            let [x, y, layer] = [(x, 0), (y, 1), (layer, 2)].map(|(end, axis)| [low, high][end][axis]);
            node([x, y, layer])
        };
        layers.flat_map(|layer| corners.map(|at| corner(layer, at))).collect::<Option<Vec<_>>>()
    };
    let last = lines.each_ref().map(|line| line.len() - 1);
    let whole: Vec<Vec<usize>> = cell([0; 3], last).into_iter().collect();
    let mut all = Some(Vec::new());
    for k in 0..last[2].max(1) {
        for j in 0..last[1] {
            for i in 0..last[0] {
                let one = cell([i, j, k], [i + 1, j + 1, (k + 1).min(last[2])]);
                all = all.zip(one).map(|(mut all, one)| {
                    all.push(one);
                    all
                });
            }
        }
    }
    // Nodes that do not form a grid leave gaps in it.
    [all.unwrap_or_else(|| whole.clone()), whole]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Nodes that form a grid make cells between all of them; otherwise the corners make one cell.
    #[test]
    fn elements_without_inner_nodes_are_one_cell() {
        let at =
            |places: &[[f64; 2]]| -> Vec<[f64; 3]> { places.iter().map(|&[x, y]| [x, y, 0.0]).collect() };
        let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
        let sides = [[0.0, -1.0], [1.0, 0.0], [0.0, 1.0], [-1.0, 0.0]];
        let serendipity = at(&[corners, sides].concat());
        let [all, whole] = cells(&serendipity);
        assert_eq!((&all, &whole), (&vec![vec![0, 1, 2, 3]], &all));
        let grid = at(&[&[[0.0, 0.0]], &corners[..], &sides[..]].concat());
        let [all, whole] = cells(&grid);
        assert_eq!((all.len(), whole), (4, vec![vec![1, 2, 3, 4]]));
        assert_eq!(all[0], [1, 5, 0, 8]);
    }
}
