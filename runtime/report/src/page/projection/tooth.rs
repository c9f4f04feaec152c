//! Tooth on its projection plane, from `tooth_flanks.csv`: its outline, and the positions of points
//! of the flank.

use crate::flank_tables::{FlankRow, ON_FLANK, ON_ROOT};
use std::collections::BTreeMap;

/// Flank of a gear in a mesh, on the projection plane.
#[derive(Clone, Debug, PartialEq)]
pub struct Tooth {
    pub body: String,
    pub mate: String,
    /// `drive` or `coast`.
    pub flank: String,
    /// 0 for the counter-clockwise flank, 1 for the clockwise one.
    pub surface: u32,
    /// `concave`, `convex` or `straight`.
    pub shape: String,
    /// True if distances run from the toe to the heel.
    pub conical: bool,
    /// Points by column along the face and row along the profile, m.
    nodes: Vec<Vec<[f64; 2]>>,
    /// Points of the root along the face, m.
    root: Vec<[f64; 2]>,
    /// First row of the rounded tip edge.
    edge_row: usize,
}

impl Tooth {
    /// Returns the flanks of a run in the order of the table.
    pub fn all(rows: &[FlankRow]) -> Vec<Tooth> {
        let key = |row: &FlankRow| (row.body.clone(), row.mate.clone(), row.flank.clone());
        rows.chunk_by(|a, b| key(a) == key(b)).filter_map(Tooth::of).collect()
    }

    fn of(rows: &[FlankRow]) -> Option<Tooth> {
        let first = rows.first()?;
        let mut columns: BTreeMap<usize, BTreeMap<usize, [f64; 2]>> = BTreeMap::new();
        for row in rows.iter().filter(|row| row.part != ON_ROOT) {
            columns.entry(row.column).or_default().insert(row.row, [row.distance, row.height]);
        }
        let nodes: Vec<Vec<[f64; 2]>> =
            columns.into_values().map(|column| column.into_values().collect()).collect();
        let count = nodes.first()?.len();
        let complete = nodes.len() > 1 && count > 1 && nodes.iter().all(|column| column.len() == count);
        let on_flank = rows.iter().filter(|row| row.part == ON_FLANK);
        complete.then(|| Tooth {
            body: first.body.clone(),
            mate: first.mate.clone(),
            flank: first.flank.clone(),
            surface: first.surface,
            shape: first.shape.clone(),
            conical: first.conical,
            nodes,
            root: rows
                .iter()
                .filter(|row| row.part == ON_ROOT)
                .map(|row| [row.distance, row.height])
                .collect(),
            edge_row: on_flank.map(|row| row.row + 1).max().unwrap_or(count).min(count - 1),
        })
    }

    /// Describes the flank: `concave flank (drive)`.
    pub fn describe(&self) -> String {
        let shape = match self.shape.as_str() {
            "straight" if self.surface == 0 => "counter-clockwise",
            "straight" => "clockwise",
            curved => curved,
        };
        format!("{shape} flank ({})", self.flank)
    }

    /// Returns the position of a point of the flank from its fractions along the face and along the
    /// profile: distance along the pitch cone and height, m. Points beyond the flank are on its
    /// ends.
    pub fn position(&self, place: [f64; 2]) -> [f64; 2] {
        let counts = [self.nodes.len() - 1, self.nodes[0].len() - 1];
        let [(i, x), (j, y)] = [0, 1].map(|k: usize| {
            let at = (place[k].clamp(0.0, 1.0)) * counts[k] as f64;
            let index = (at.floor() as usize).min(counts[k] - 1);
            (index, at - index as f64)
        });
        [0, 1].map(|k: usize| {
            let row = |j: usize| {
                let (from, to) = (self.nodes[i][j][k], self.nodes[i + 1][j][k]);
                from + x * (to - from)
            };
            row(j) + y * (row(j + 1) - row(j))
        })
    }

    /// Returns true if the toe is at the first column.
    fn starts_at_toe(&self) -> bool {
        let middle = self.nodes[0].len() / 2;
        self.nodes[0][middle][0] <= self.nodes[self.nodes.len() - 1][middle][0]
    }

    /// Returns the profile at the end with the smaller (toe) or larger distance, from the fillet to
    /// the tip.
    pub fn end(&self, heel: bool) -> &[[f64; 2]] {
        let last = self.nodes.len() - 1;
        &self.nodes[if self.starts_at_toe() == heel { last } else { 0 }]
    }

    /// Returns the line at which the flank begins, in the order of the table.
    pub fn flank_start(&self) -> Vec<[f64; 2]> {
        self.nodes.iter().map(|column| column[0]).collect()
    }

    /// Returns the line at which the rounded tip edge begins.
    pub fn edge_start(&self) -> Vec<[f64; 2]> {
        self.nodes.iter().map(|column| column[self.edge_row]).collect()
    }

    /// Returns the boundary of the tooth as a closed polygon: root, heel, tip, toe.
    pub fn outline(&self) -> Vec<[f64; 2]> {
        let last = self.nodes.len() - 1;
        let top = self.nodes[0].len() - 1;
        let mut line = if self.root.is_empty() { self.flank_start() } else { self.root.clone() };
        line.extend(&self.nodes[last]);
        line.extend((0..last).rev().map(|column| self.nodes[column][top]));
        line.extend(self.nodes[0].iter().rev());
        line.extend(line.first().copied());
        line
    }
}
