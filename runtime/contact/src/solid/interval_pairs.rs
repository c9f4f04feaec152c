//! Cells by their intervals across and along the patch.
//!
//! The half-space influence between two coplanar cells depends only on the relative position of
//! their intervals across and along. The cells of a grid share their intervals, of which there are
//! as many as columns and rows, and many pairs of intervals have the same relative position. Each
//! influence coefficient is therefore computed once per pair of relative positions: on a lattice as
//! many times as there are cells, not pairs of cells.

use super::grid::Cell;
use std::collections::BTreeMap;

/// Resolution of intervals: the extent of the grid divided by this is rounding.
const ROUNDING: f64 = (1_u64 << 44) as f64;
/// Least number of cells that share an interval; with fewer, grouping does not save work.
const FEW: usize = 4;
/// Largest number of relative positions per cell that are stored. Lattices have fewer. Next to tip
/// edges, where the columns of slices differ, there are more, and few pairs of cells are alike.
const MOST_RELATIONS: usize = 64;

/// Intervals of some cells along one axis.
pub(super) struct Intervals {
    /// Interval by cell; `None` if too few cells share it.
    class: Vec<Option<usize>>,
    /// Centre and size of each shared interval, m.
    shared: Vec<[f64; 2]>,
    /// Resolution, m.
    step: f64,
}

impl Intervals {
    pub fn of(cells: &[Cell], axis: usize) -> Self {
        let all = || cells.iter().map(|cell| cell.ends(axis));
        let low = all().fold(f64::INFINITY, |low, [end, _]| low.min(end));
        let high = all().fold(f64::NEG_INFINITY, |high, [_, end]| high.max(end));
        let step = (high - low) / ROUNDING;
        let of = |cell: &Cell| [cell.center[axis], cell.size[axis]];
        let key = |interval: [f64; 2]| interval.map(|length| (length / step).round() as i64);
        let mut counts = BTreeMap::<[i64; 2], (usize, Option<usize>)>::new();
        cells.iter().for_each(|cell| counts.entry(key(of(cell))).or_default().0 += 1);
        let mut shared = Vec::new();
        let class = cells.iter().map(|cell| {
            let (_, class) = counts.get_mut(&key(of(cell))).filter(|(count, _)| *count >= FEW)?;
            Some(*class.get_or_insert_with(|| {
                shared.push(of(cell));
                shared.len() - 1
            }))
        });
        Self { class: class.collect(), shared, step }
    }

    /// Groups pairs of intervals that have equal sizes and equal values of `between`, a function of
    /// their centres.
    pub fn pairs(&self, between: impl Fn(f64, f64) -> f64) -> Pairs<'_> {
        let key = |length: f64| (length / self.step).round() as i64;
        let count = self.shared.len();
        let mut known = BTreeMap::new();
        let relation = (0..count * count).map(|pair| {
            let [one, other] = [self.shared[pair / count], self.shared[pair % count]];
            let sizes = [key(one[1].min(other[1])), key(one[1].max(other[1]))];
            let next = known.len();
            *known.entry((key(between(one[0], other[0])), sizes)).or_insert(next)
        });
        let relation = relation.collect();
        Pairs { class: &self.class, count, relation, relations: known.len() }
    }

    /// Groups no pairs, except those of the same two intervals.
    pub fn each_pair(&self) -> Pairs<'_> {
        let count = self.shared.len();
        let ordered = |a: usize, b: usize| a.max(b) * (a.max(b) + 1) / 2 + a.min(b);
        let relation = (0..count * count).map(|pair| ordered(pair / count, pair % count)).collect();
        Pairs { class: &self.class, count, relation, relations: count * (count + 1) / 2 }
    }
}

/// Relative positions of pairs of intervals.
pub(super) struct Pairs<'a> {
    class: &'a [Option<usize>],
    count: usize,
    /// Class by the one interval, then the other.
    relation: Vec<usize>,
    relations: usize,
}

impl Pairs<'_> {
    fn of(&self, cell: usize, other: usize) -> Option<usize> {
        Some(self.relation[self.class[cell]? * self.count + self.class[other]?])
    }
}

/// Influence coefficients by the relative position of two cells, across and along.
pub(super) struct RelationCache<'a> {
    pairs: [Pairs<'a>; 2],
    known: Vec<f64>,
}

impl<'a> RelationCache<'a> {
    /// Creates the table for a number of cells. Where cells have so many relative positions that
    /// few pairs of them are alike, it stores none.
    pub fn new(pairs: [Pairs<'a>; 2], cells: usize) -> Self {
        let room = pairs[0].relations * pairs[1].relations;
        let known = if room <= MOST_RELATIONS * cells { vec![f64::NAN; room] } else { Vec::new() };
        Self { pairs, known }
    }

    /// Returns the coefficient of a pair of cells.
    pub fn get(&mut self, cell: usize, other: usize, find: impl FnOnce() -> f64) -> f64 {
        let [across, along] = &self.pairs;
        let place = across.of(cell, other).zip(along.of(cell, other));
        match place.and_then(|(across, row)| self.known.get_mut(across * along.relations + row)) {
            Some(known) => {
                if known.is_nan() {
                    *known = find();
                }
                *known
            }
            None => find(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cell(center: [f64; 2], size: [f64; 2]) -> Cell {
        Cell {
            center,
            size,
            places: [[0.0; 2]; 2],
            loaded_at: [[0.0; 2]; 2],
            axial: [0.0; 2],
            spans: [0.0; 2],
            gap: 0.0,
            point: [0.0; 3],
            slope: [0.0; 2],
            edge: false,
        }
    }

    /// Lattice with a shortened last row, and one cell unlike all others.
    fn cells() -> Vec<Cell> {
        let row = |y: f64, size: f64| (0..7).map(move |k| cell([0.1 * f64::from(k), y], [0.1, size]));
        let whole = (0..5).flat_map(|k| row(0.3 * f64::from(k), 0.3));
        whole.chain(row(1.425, 0.15)).chain([cell([0.33, 1.6], [0.07, 0.2])]).collect()
    }

    #[test]
    fn pairs_that_lie_alike_are_found_once_and_are_alike() {
        let cells = cells();
        let [across, along] = [0, 1].map(|axis| Intervals::of(&cells, axis));
        assert_eq!((across.shared.len(), along.shared.len()), (7, 6));
        let apart = |a: f64, b: f64| (a - b).abs();
        let mut cache = RelationCache::new([across.pairs(apart), along.pairs(apart)], cells.len());
        let own = |one: &Cell, other: &Cell| {
            let [x, y] = [0, 1].map(|axis| apart(one.center[axis], other.center[axis]));
            x + 10.0 * y + 100.0 * (one.size[1] * other.size[1])
        };
        let mut found = 0;
        for (i, one) in cells.iter().enumerate() {
            for (j, other) in cells.iter().enumerate() {
                let answer = cache.get(i, j, || {
                    found += 1;
                    own(one, other)
                });
                assert!((answer - own(one, other)).abs() < 1e-12, "{i} {j}");
            }
        }
        // Seven distances across by five of whole rows, five from the shortened row and its own;
        // all pairs of the odd cell.
        assert_eq!(found, 7 * 11 + 2 * cells.len() - 1);
    }

    #[test]
    fn pairs_of_intervals_are_told_apart_where_their_places_matter() {
        let cells = cells();
        let [across, along] = [0, 1].map(|axis| Intervals::of(&cells, axis));
        let mut cache =
            RelationCache::new([across.pairs(|a, b| (a - b).abs()), along.each_pair()], cells.len());
        for (i, one) in cells.iter().enumerate() {
            for (j, other) in cells.iter().enumerate() {
                let own = one.center[1] * other.center[1];
                assert!((cache.get(i, j, || own) - own).abs() < 1e-12, "{i} {j}");
            }
        }
    }
}
