//! Mesh of a plate in its plane: quadrilaterals of 8 nodes.
//!
//! Circles and radii divide a sector into cells. Around the seat of a pin, rings of cells between a
//! block of this grid and the circle of the seat replace the cells of the block. The nodes of the
//! block's boundary and those of the seat are on common rays from the centre of the seat. Nodes
//! have whole-number keys, so sectors join without comparing positions.

use super::shape::{CarrierShape, count};
use std::collections::BTreeMap;
use std::f64::consts::TAU;

/// Distance of the block from the centre of a seat, relative to the radius of the seat, if there is
/// space.
const BLOCK: f64 = 1.6;
/// Distance of a line of the block from one of the webs, relative to the distance of the block from
/// the seat, within which both become one.
const SNAP: f64 = 0.6;

/// Mesh of a plate.
pub(super) struct PlaneMesh {
    /// Positions of the nodes, m.
    pub(super) nodes: Vec<[f64; 2]>,
    /// Cells.
    pub(super) cells: Vec<PlaneCell>,
    /// Nodes on the bore: corners and midsides.
    pub(super) bore: Vec<PlaneNode>,
    /// Nodes on the seat of each pin.
    pub(super) seats: Vec<Vec<PlaneNode>>,
}

/// Node of a curve: its index, and whether it is a corner of cells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct PlaneNode {
    pub(super) index: usize,
    pub(super) corner: bool,
}

/// Quadrilateral of 8 nodes, counter-clockwise.
pub(super) struct PlaneCell {
    pub(super) corners: [usize; 4],
    /// Midside node after each corner.
    pub(super) midsides: [usize; 4],
    /// True if a web is on this cell.
    pub(super) web: bool,
}

/// Key of a node; positions between corners have odd numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum PlaneKey {
    /// Circle and radius, counted around the whole plate.
    Grid(usize, usize),
    /// Planet, ring from the block inwards, and position around the block.
    Ring(usize, usize, usize),
}

/// Lines of a sector and the block around its seat.
struct Sector {
    /// Radii of circles, ascending.
    radii: Vec<f64>,
    /// Angles of radii relative to the planet, ascending, from one middle between planets to the
    /// next.
    angles: Vec<f64>,
    /// Indices of the circles and of the radii that bound the block.
    block: [[usize; 2]; 2],
    /// Number of rings between block and seat.
    rings: usize,
    /// Radius of the seat and of the circle of the pins.
    seat: f64,
    centre: f64,
}

/// Returns the lines at these ends with further ones between them at distances of at most `size`.
fn divided(ends: &[f64], size: impl Fn(f64) -> f64) -> Vec<f64> {
    let mut lines = vec![ends[0]];
    for pair in ends.windows(2) {
        let parts = count(pair[1] - pair[0], size(pair[1]));
        lines.extend((1..=parts).map(|k| match k == parts {
            true => pair[1],
            false => pair[0] + (pair[1] - pair[0]) * (k as f64 / parts as f64),
        }));
    }
    lines
}

/// Returns the value at a number of half steps along lines.
fn halfway(lines: &[f64], half: usize) -> f64 {
    match half % 2 {
        0 => lines[half / 2],
        _ => 0.5 * (lines[half / 2] + lines[half / 2 + 1]),
    }
}

fn line_of(lines: &[f64], value: f64) -> usize {
    lines.iter().position(|line| *line == value).unwrap_or_default()
}

impl Sector {
    fn new(shape: &CarrierShape) -> Sector {
        let (seat, centre) = (0.5 * shape.pin_diameter, 0.5 * shape.pin_circle_diameter);
        let [bore, outside] = [shape.bore_diameter, shape.outside_diameter].map(|d| 0.5 * d);
        let webs =
            shape.webs.map_or(vec![], |webs| vec![0.5 * webs.inside_diameter, 0.5 * webs.outside_diameter]);
        // A block line is between the seat and the next edge, and on a line of the webs nearby.
        let placed = |direction: f64, edge: f64| {
            let space = direction * (edge - centre) - seat;
            let own = centre + direction * (seat + ((BLOCK - 1.0) * seat).min(0.5 * space));
            let snapped =
                webs.iter().find(|web| (*web - own).abs() < SNAP * (direction * (own - centre) - seat));
            snapped.copied().unwrap_or(own)
        };
        let radial = [placed(-1.0, bore), placed(1.0, outside)];
        let free = shape.free_angle();
        let least = (seat / centre).asin();
        let across = (BLOCK * least).min(0.5 * (least + free));
        let mut circles = vec![bore, outside, radial[0], radial[1]];
        circles.extend(&webs);
        let half = shape.half_pitch();
        let mut rays = vec![-half, -across, across, half];
        if shape.webs.is_some() {
            rays.extend([-free, free]);
        }
        for lines in [&mut circles, &mut rays] {
            lines.sort_by(f64::total_cmp);
            lines.dedup();
        }
        let radii = divided(&circles, |_| shape.element_size);
        let angles = divided(&rays, |_| shape.element_size / centre);
        let block = [
            radial.map(|radius| line_of(&radii, radius)),
            [-across, across].map(|angle| line_of(&angles, angle)),
        ];
        let rings = count(0.5 * (radial[1] - radial[0]) - seat, shape.element_size);
        Sector { radii, angles, block, rings, seat, centre }
    }

    /// Returns the number of half steps around the block.
    fn around(&self) -> usize {
        let [[i0, i1], [j0, j1]] = self.block;
        4 * (i1 - i0 + j1 - j0)
    }

    /// Returns the circle and radius, in half steps, at a number of half steps around the block,
    /// counter-clockwise from its inner corner at the lower angle.
    fn boundary(&self, step: usize) -> [usize; 2] {
        let [[i0, i1], [j0, j1]] = self.block.map(|ends| ends.map(|line| 2 * line));
        let (long, wide) = (i1 - i0, j1 - j0);
        match step % self.around() {
            step if step <= long => [i0 + step, j0],
            step if step <= long + wide => [i1, j0 + step - long],
            step if step <= 2 * long + wide => [i1 - (step - long - wide), j1],
            step => [i0, j1 - (step - 2 * long - wide)],
        }
    }

    /// Returns the position of a grid node relative to its planet's direction.
    fn grid(&self, [i, j]: [usize; 2]) -> [f64; 2] {
        let (radius, angle) = (halfway(&self.radii, i), halfway(&self.angles, j));
        [radius * angle.cos(), radius * angle.sin()]
    }

    /// Returns the position of a node of a ring.
    fn ring(&self, ring: usize, step: usize) -> [f64; 2] {
        let outer = self.grid(self.boundary(step));
        let from = [outer[0] - self.centre, outer[1]];
        let scale = self.seat / from[0].hypot(from[1]);
        let part = ring as f64 / (2 * self.rings) as f64;
        let toward = |k: usize| from[k] * (1.0 - part + part * scale);
        [self.centre + toward(0), toward(1)]
    }

    fn within_block(&self, i: usize, j: usize) -> bool {
        let [[i0, i1], [j0, j1]] = self.block;
        (i0..i1).contains(&i) && (j0..j1).contains(&j)
    }
}

/// Collects nodes by key.
struct Nodes<'s> {
    sector: &'s Sector,
    planets: usize,
    known: BTreeMap<PlaneKey, usize>,
    positions: Vec<[f64; 2]>,
}

impl Nodes<'_> {
    /// Returns the node at a circle and a radius of a planet's sector, in half steps.
    fn grid(&mut self, planet: usize, [i, j]: [usize; 2]) -> usize {
        let per_sector = 2 * (self.sector.angles.len() - 1);
        // The last radius of a sector is the first one of the next.
        let (owner, own) = if j == per_sector { ((planet + 1) % self.planets, 0) } else { (planet, j) };
        self.node(PlaneKey::Grid(i, owner * per_sector + own), owner, || [i, own])
    }

    fn node(&mut self, key: PlaneKey, planet: usize, grid: impl Fn() -> [usize; 2]) -> usize {
        if let Some(&known) = self.known.get(&key) {
            return known;
        }
        let [x, y] = match key {
            PlaneKey::Grid(..) => self.sector.grid(grid()),
            PlaneKey::Ring(_, ring, step) => self.sector.ring(ring, step),
        };
        let (sin, cos) = (TAU * planet as f64 / self.planets as f64).sin_cos();
        self.positions.push([cos * x - sin * y, sin * x + cos * y]);
        self.known.insert(key, self.positions.len() - 1);
        self.positions.len() - 1
    }

    /// Returns the node of a ring at a number of half steps around the block; ring 0 is the block's
    /// boundary.
    fn ring(&mut self, planet: usize, ring: usize, step: usize) -> usize {
        let step = step % self.sector.around();
        match ring {
            0 => self.grid(planet, self.sector.boundary(step)),
            _ => self.node(PlaneKey::Ring(planet, ring, step), planet, || [0, 0]),
        }
    }
}

/// Returns the cell of the corners and midsides at these half steps from its first corner.
fn cell(mut node: impl FnMut(usize, usize) -> usize, web: bool) -> PlaneCell {
    let corners = [node(0, 0), node(2, 0), node(2, 2), node(0, 2)];
    PlaneCell { corners, midsides: [node(1, 0), node(2, 1), node(1, 2), node(0, 1)], web }
}

impl PlaneMesh {
    pub(super) fn new(shape: &CarrierShape) -> PlaneMesh {
        let sector = Sector::new(shape);
        let mut nodes =
            Nodes { sector: &sector, planets: shape.planets, known: BTreeMap::new(), positions: Vec::new() };
        let (mut cells, mut bore, mut seats) = (Vec::new(), Vec::new(), Vec::new());
        let (free, webs) = (shape.free_angle(), shape.webs);
        let on_web = |i: usize, j: usize| {
            let (radius, angle) = (halfway(&sector.radii, 2 * i + 1), halfway(&sector.angles, 2 * j + 1));
            webs.is_some_and(|webs| {
                angle.abs() > free && (webs.inside_diameter..webs.outside_diameter).contains(&(2.0 * radius))
            })
        };
        for planet in 0..shape.planets {
            for i in 0..sector.radii.len() - 1 {
                for j in 0..sector.angles.len() - 1 {
                    if !sector.within_block(i, j) {
                        let node = |a: usize, b: usize| nodes.grid(planet, [2 * i + a, 2 * j + b]);
                        cells.push(cell(node, on_web(i, j)));
                    }
                }
            }
            for ring in 0..sector.rings {
                for step in 0..sector.around() / 2 {
                    // From the inner ring outwards, then around.
                    let node = |a: usize, b: usize| nodes.ring(planet, 2 * ring + 2 - a, 2 * step + b);
                    cells.push(cell(node, false));
                }
            }
            let half_steps = 2 * (sector.angles.len() - 1);
            bore.extend(
                (0..half_steps).map(|j| PlaneNode { index: nodes.grid(planet, [0, j]), corner: j % 2 == 0 }),
            );
            let seat = (0..sector.around()).map(|step| PlaneNode {
                index: nodes.ring(planet, 2 * sector.rings, step),
                corner: step % 2 == 0,
            });
            seats.push(seat.collect());
        }
        PlaneMesh { nodes: nodes.positions, cells, bore, seats }
    }
}
