//! Binary trees of clusters of points.

use calyx_numerics::vec3::{Vector, length, minus};
use std::ops::Range;

/// Cluster of consecutive positions in the order of the tree.
#[derive(Clone, Debug)]
pub(crate) struct Cluster {
    /// Positions in [`ClusterTree::order`].
    pub range: Range<usize>,
    /// Bounding box of the supports of the items.
    pub bounds: [Vector; 2],
    /// Indices of the halves; `None` for a leaf.
    pub halves: Option<[usize; 2]>,
}

impl Cluster {
    /// Returns the diagonal of the bounding box.
    pub fn diameter(&self) -> f64 {
        length(minus(self.bounds[1], self.bounds[0]))
    }

    /// Returns the distance of two bounding boxes.
    pub fn distance(&self, other: &Self) -> f64 {
        let gap = |axis: usize| {
            let above = other.bounds[0][axis] - self.bounds[1][axis];
            let below = self.bounds[0][axis] - other.bounds[1][axis];
            above.max(below).max(0.0)
        };
        length([0, 1, 2].map(gap))
    }
}

/// Clusters of items by their positions. The first cluster has all items.
#[derive(Clone, Debug)]
pub(crate) struct ClusterTree {
    /// Items in the order of the clusters.
    pub order: Vec<usize>,
    pub clusters: Vec<Cluster>,
}

impl ClusterTree {
    /// Creates a tree of items with these supports (bounding boxes). Leaves have at most `leaf`
    /// items.
    pub fn new(supports: &[[Vector; 2]], leaf: usize) -> Self {
        let mut tree = Self { order: (0..supports.len()).collect(), clusters: Vec::new() };
        tree.divide(supports, 0..supports.len(), leaf.max(1));
        tree
    }

    fn divide(&mut self, supports: &[[Vector; 2]], range: Range<usize>, leaf: usize) -> usize {
        let mut bounds = [[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]];
        for &item in &self.order[range.clone()] {
            for axis in 0..3 {
                bounds[0][axis] = bounds[0][axis].min(supports[item][0][axis]);
                bounds[1][axis] = bounds[1][axis].max(supports[item][1][axis]);
            }
        }
        let own = self.clusters.len();
        self.clusters.push(Cluster { range: range.clone(), bounds, halves: None });
        if range.len() > leaf {
            let extent = minus(bounds[1], bounds[0]);
            let axis = (0..3).fold(0, |best, axis| if extent[axis] > extent[best] { axis } else { best });
            let middle = |item: usize| supports[item][0][axis] + supports[item][1][axis];
            self.order[range.clone()]
                .sort_by(|&a, &b| middle(a).total_cmp(&middle(b)).then_with(|| a.cmp(&b)));
            let half = range.start + range.len() / 2;
            let first = self.divide(supports, range.start..half, leaf);
            let second = self.divide(supports, half..range.end, leaf);
            self.clusters[own].halves = Some([first, second]);
        }
        own
    }

    /// Returns the items of a cluster.
    pub fn items(&self, cluster: usize) -> &[usize] {
        &self.order[self.clusters[cluster].range.clone()]
    }

    /// Returns the indices of the leaves, in the order of their items.
    pub fn leaves(&self) -> Vec<usize> {
        (0..self.clusters.len()).filter(|&cluster| self.clusters[cluster].halves.is_none()).collect()
    }
}
