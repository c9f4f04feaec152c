//! Section of a shaft: a body of revolution that extends along its axis, with steps and cones.

use super::block::{Block, Side, uniform};
use super::builder::{MeshBuilder, MeshError};
use super::interpolation::ElementOrder;
use super::mesh::PlaneMesh;
use super::strips::{Cell, Cut, cells};

/// Least number of elements across each strip of a section and along each stretch of it, and the
/// largest number along a stretch.
const ACROSS: usize = 2;
const ALONG: usize = 2;
const MOST_ALONG: usize = 24;
/// Tolerance of radii relative to the wall: twice that of the lines.
const SAME: f64 = 2e-6;

/// Radii of a shaft at a position.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AxialCut {
    /// Position along the axis, m.
    pub position: f64,
    /// Radius of the bore, 0 for a solid shaft, and outside radius, m.
    pub radii: [f64; 2],
}

/// Section of a shaft, by cuts along its axis and straight lines between them. Two cuts at one
/// position are a step.
#[derive(Clone, Debug, PartialEq)]
pub struct AxialSection {
    cuts: Vec<AxialCut>,
}

impl AxialSection {
    /// Builds a section. Returns `None` unless there are at least two cuts in ascending order with
    /// positive walls, and both sides of each step touch each other.
    pub fn new(cuts: Vec<AxialCut>) -> Option<Self> {
        let sound =
            |cut: &AxialCut| cut.position.is_finite() && 0.0 <= cut.radii[0] && cut.radii[0] < cut.radii[1];
        let joins = |pair: &[AxialCut]| {
            let [a, b] = [pair[0], pair[1]];
            a.position < b.position || a.position == b.position && common(a.radii, b.radii).is_some()
        };
        let is_step = |pair: &[AxialCut]| pair[0].position == pair[1].position;
        let steps_end = cuts.len() < 2 || is_step(&cuts[..2]) || is_step(&cuts[cuts.len() - 2..]);
        let good = !steps_end
            && cuts.iter().all(sound)
            && cuts.windows(2).all(joins)
            && !cuts.windows(3).any(|three| three[0].position == three[2].position);
        good.then_some(Self { cuts })
    }

    /// Returns the radii of the section at each position of a cut, m: at a step those that both
    /// sides have in common. `None` if there is no cut at the position.
    pub fn radii_at(&self, position: f64) -> Option<[f64; 2]> {
        let mut at = self.cuts.iter().filter(|cut| cut.position == position).map(|cut| cut.radii);
        let first = at.next()?;
        match at.next() {
            Some(second) => common(first, second),
            None => Some(first),
        }
    }

    /// Meshes the section, radius as x and axial coordinate as y, with a chain `station k` across
    /// the shaft at the position of each of these cuts. `fineness` is a factor on the number of
    /// elements in each direction.
    ///
    /// # Errors
    /// The cuts leave no room for elements.
    pub fn mesh(
        &self,
        order: ElementOrder,
        fineness: usize,
        stations: &[f64],
    ) -> Result<PlaneMesh, MeshError> {
        let mut builder = MeshBuilder::new();
        let cuts: Vec<Cut> = self.cuts.iter().map(|cut| Cut { at: cut.position, ends: cut.radii }).collect();
        let end = cuts.last().map_or(0.0, |cut| cut.at);
        let station = |at: f64| stations.iter().position(|&station| station == at);
        for Cell { cut, lines: [start, finish] } in cells(&cuts) {
            let pair = [cuts[cut], cuts[cut + 1]];
            let (length, wall) = (pair[1].at - pair[0].at, |cut: Cut| cut.ends[1] - cut.ends[0]);
            let squares = 4.0 * length / (wall(pair[0]) + wall(pair[1]));
            let along = (squares.ceil() as usize).clamp(ALONG, MOST_ALONG) * fineness;
            let corners = [
                [start[0], pair[0].at],
                [start[1], pair[0].at],
                [finish[1], pair[1].at],
                [finish[0], pair[1].at],
            ];
            let mut block = Block::quadrilateral(corners).divided(uniform(ACROSS * fineness), uniform(along));
            let inside = |at: f64, [from, to]: [f64; 2]| {
                self.radii_at(at).is_some_and(|[bore, outside]| {
                    let slack = SAME * (outside - bore);
                    bore - slack <= from && to <= outside + slack
                })
            };
            if let Some(k) = station(pair[0].at).filter(|_| inside(pair[0].at, start)) {
                block = block.named(Side::Bottom, &station_name(k));
            }
            if let Some(k) = station(pair[1].at).filter(|_| pair[1].at == end) {
                block = block.named(Side::Top, &station_name(k));
            }
            builder.block(block);
        }
        builder.finish(order)
    }
}

/// Returns the name of the chain of a station.
pub fn station_name(station: usize) -> String {
    format!("station {station}")
}

/// Returns the part of two ranges of radii that both have; `None` if they do not overlap.
fn common(a: [f64; 2], b: [f64; 2]) -> Option<[f64; 2]> {
    let both = [a[0].max(b[0]), a[1].min(b[1])];
    (both[0] < both[1]).then_some(both)
}
