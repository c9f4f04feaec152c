//! Plane mesh of a developed section: one tooth with its sector of the rim, from the middle of one
//! tooth space to the next.
//!
//! The parts are those of [`crate::sector_mesh`]: a strip along the boundary, the core of the
//! tooth, and the rim under the tooth and under the spaces. Both halves are laid out separately, on
//! the middle line between the inner sides of their strips, so the tooth need not be symmetric. The
//! divisions are decided in the middle section; the meshes of all sections have the same elements
//! and chains and differ in positions only.

use super::boundary::{Breaks, Half, StripDepths, cut_azimuth, distance, root_end, strip_depths};
use super::tooth::Tooth;
use crate::root_finding::solve_bracketed;
use crate::sector_mesh::divisions::{divisions, ends, growth, normalised, piecewise_linear};
use crate::sector_mesh::{FILLET_GROWTH, LAND_GROWTH, OUTERMOST_LAYER, Refinement, TipEdge};
use calyx_abi::math;
use calyx_runtime::fe::block::{graded, uniform};
use calyx_runtime::fe::memoized::Memoized;
use calyx_runtime::fe::{Block, Curve, MeshBuilder, MeshError, PlaneMesh, Side};
use std::sync::Arc;

/// Least and greatest part of a fillet between the flank and the point where the core begins.
const KNEE: [f64; 2] = [0.3, 0.7];
/// Shortest root with elements of its own, in lengths of an element of the fillet.
const SHORTEST_LAND: f64 = 0.3;
/// Azimuth of the division of the rim relative to that of the fillet's middle.
const FOOT: f64 = 0.9;

/// Divisions of all sections of a gear.
pub(super) struct Layout {
    tooth: Arc<Tooth>,
    breaks: Breaks,
    knee_parts: [f64; 2],
    /// Element boundaries in `q`: root with the lower part of the fillet, upper part of the fillet,
    /// flank.
    parts: [Vec<f64>; 3],
    /// Divisions from the strip down to the bore.
    into_rim: Vec<f64>,
    /// Divisions of half of the tip land, from the flank.
    land: Vec<f64>,
    refinement: Refinement,
    layers: Layers,
}

/// Target lengths of elements, m in the middle section.
#[derive(Clone, Copy)]
struct Sizes {
    fillet: f64,
    last: f64,
    largest: f64,
    tip_growth: f64,
    breaks: Breaks,
}

impl Sizes {
    fn at(&self, q: f64) -> f64 {
        let Breaks { land, form, edge, .. } = self.breaks;
        let from_fillet = (land - q).max(q - form).max(0.0);
        let from_edge = self.last + self.tip_growth * (edge - q).max(0.0);
        from_edge.min(self.largest).min(self.fillet + FILLET_GROWTH * from_fillet)
    }
}

/// Layers of elements through the strip, the same in all sections.
#[derive(Clone, Copy)]
struct Layers {
    sizes: Sizes,
    /// Thickness of the strip in the middle section.
    depths: StripDepths,
    count: usize,
}

impl Layers {
    /// Boundaries of the layers at `q`, as fractions of the distance from the inner side of the
    /// strip. Layers are thinnest at the boundary and grow geometrically.
    fn at(&self, q: f64) -> Vec<f64> {
        let Breaks { form, edge, .. } = self.sizes.breaks;
        let part = ((q - form) / (edge - form)).clamp(0.0, 1.0);
        let depth = self.depths.root + part * (self.depths.tip - self.depths.root);
        let outermost = (OUTERMOST_LAYER * self.sizes.at(q) / depth).min(1.0 / self.count as f64);
        let growth = growth(self.count, outermost);
        graded(self.count, math::pow(growth, 1.0 - self.count as f64))
    }
}

impl Layout {
    /// Decides the divisions. `bore_height` is the height of the bore in the middle section, m.
    pub fn new(tooth: &Arc<Tooth>, refinement: &Refinement, bore_height: f64) -> Self {
        let module = tooth.module;
        let mean = |value: &dyn Fn(usize) -> f64| 0.5 * (value(0) + value(1));
        let fillet = mean(&|side| tooth.fillet_length(side));
        let knee_parts = [0, 1].map(|side| knee_part(tooth, side));
        let knee = mean(&|side| tooth.fillet_length(side) * knee_parts[side]);
        let flank = mean(&|side| tooth.edge_from(side));
        let fillet_size = fillet / refinement.fillet as f64;
        let land = shortest_land(tooth);
        let own_land = land > SHORTEST_LAND * fillet_size;
        let middle_land = mean(&|side| land_length(tooth, side, 0.0));
        let below = middle_land + fillet - knee;
        let breaks = Breaks {
            land: if own_land { middle_land } else { 0.0 },
            knee: below,
            form: below + knee,
            edge: below + knee + flank,
        };
        let last = match refinement.edge {
            TipEdge::Corner(last) => last * module,
            TipEdge::Rounded(_) => 0.25 * refinement.flank * module,
        };
        let sizes = Sizes {
            fillet: fillet_size,
            last,
            largest: refinement.flank * module,
            tip_growth: refinement.tip_growth,
            breaks,
        };
        let mut root = Vec::new();
        if own_land {
            let size = |q: f64| sizes.at(q).min(0.4 * module);
            root.extend(divisions(0.0, breaks.land, size));
            root.pop();
        }
        root.extend(divisions(breaks.land, breaks.knee, |_| fillet_size));
        let parts = [
            root,
            divisions(breaks.knee, breaks.form, |_| fillet_size),
            divisions(breaks.form, breaks.edge, |q| sizes.at(q)),
        ];
        let mut layout = Self {
            tooth: Arc::clone(tooth),
            breaks,
            knee_parts,
            parts,
            into_rim: uniform(1),
            land: uniform(1),
            refinement: *refinement,
            layers: Layers {
                sizes,
                depths: StripDepths { root: module, tip: module },
                count: refinement.layers,
            },
        };
        layout.layers.depths = layout.depths(&layout.plain_halves(0.0), bore_height);
        layout.divide(bore_height);
        layout
    }

    /// Divisions of the rim and of the tip land.
    fn divide(&mut self, bore_height: f64) {
        let halves = self.halves(0.0, bore_height);
        let knee = halves[0].inner(self.breaks.knee);
        let depth = halves[0].rolled(knee)[0] - bore_height;
        let growth_rate = self.refinement.rim_growth;
        let first = self.refinement.flank * self.tooth.module;
        let count = (math::log(1.0 + depth * (growth_rate - 1.0) / first) / math::log(growth_rate))
            .ceil()
            .max(1.0) as usize;
        self.into_rim = graded(count, math::pow(growth_rate, (count - 1) as f64));
        let tops = halves.each_ref().map(|half| half.outer(self.breaks.edge)[0]);
        let half_land = 0.5 * distance(tops[0], [tops[1][0], -tops[1][1]]);
        let across = self.refinement.across;
        let smallest = (LAND_GROWTH * self.layers.sizes.last / half_land).min(1.0 / across as f64);
        self.land = graded(across, math::pow(growth(across, smallest), across as f64 - 1.0));
    }

    fn plain_halves(&self, v: f64) -> [Half; 2] {
        [0, 1].map(|side| Half::new(&self.tooth, side, v, self.breaks, self.knee_parts[side]))
    }

    fn depths(&self, halves: &[Half; 2], bore_height: f64) -> StripDepths {
        let lengths = halves
            .each_ref()
            .map(|half| distance(half.outer(self.breaks.form)[0], half.outer(self.breaks.edge)[0]));
        let middle = self.plain_halves(0.0);
        let nominal = middle
            .each_ref()
            .map(|half| distance(half.outer(self.breaks.form)[0], half.outer(self.breaks.edge)[0]));
        let scale = (lengths[0] + lengths[1]) / (nominal[0] + nominal[1]);
        strip_depths([&halves[0], &halves[1]], halves[0].root_height - bore_height, scale)
    }

    fn halves(&self, v: f64, bore_height: f64) -> [Half; 2] {
        let mut halves = self.plain_halves(v);
        let depths = self.depths(&halves, bore_height);
        halves.iter_mut().for_each(|half| half.place_strip(depths));
        halves
    }

    /// Mesh of the section at `v` with the bore at a height (m), in its development. Chains:
    /// `flank_0`, `flank_1` with the coordinate `u` of [`Tooth::flank_at`] up to the tip edge;
    /// `fillet_0`, `fillet_1` with the coordinate of [`Tooth::fillet_at`], continued to the middle
    /// of the space; `tip`, `bore`; `cut_left` and `cut_right`.
    ///
    /// # Errors
    /// The mesh folds over itself because the layout does not suit the shape of the tooth.
    pub fn mesh(&self, v: f64, bore_height: f64) -> Result<PlaneMesh, MeshError> {
        let halves = self.halves(v, bore_height).map(Arc::new);
        let mut builder = MeshBuilder::new();
        for side in 0..2 {
            let section = HalfSection {
                layout: self,
                half: Arc::clone(&halves[side]),
                other: Arc::clone(&halves[1 - side]),
                bore_height,
            };
            for block in section.blocks() {
                builder.block(block.on(side));
            }
        }
        builder.finish(self.refinement.order)
    }
}

/// Length of the root between a fillet and the middle of the space, m.
fn land_length(tooth: &Tooth, side: usize, v: f64) -> f64 {
    let [height, azimuth] = root_end(tooth, side, v);
    tooth.cones.radius(tooth.along(v), height) * (cut_azimuth(tooth, side, v) - azimuth)
}

/// Shortest root of all sections, m.
fn shortest_land(tooth: &Tooth) -> f64 {
    const SECTIONS: usize = 16;
    let [start, end] = tooth.face;
    let sections = (0..=SECTIONS).map(|k| start + (end - start) * k as f64 / SECTIONS as f64);
    sections.flat_map(|v| [0, 1].map(|side| land_length(tooth, side, v))).fold(f64::INFINITY, f64::min)
}

/// Part of a fillet's length from the flank to the point where the normal has rotated by half.
fn knee_part(tooth: &Arc<Tooth>, side: usize) -> f64 {
    let length = tooth.fillet_length(side);
    let angle = |part: f64| {
        let [x, y] = tooth.fillet_at(side, part * length, 0.0).by_u;
        let y = if side == 0 { y } else { -y };
        // Towards the root, so that the angle decreases from the flank.
        math::atan2(-x, y)
    };
    let half = 0.5 * (angle(0.0) + angle(1.0));
    solve_bracketed(|part| angle(part) - half, 0.0, 1.0).clamp(KNEE[0], KNEE[1])
}

type Mapping = Arc<dyn Fn(f64, f64) -> [f64; 2] + Send + Sync>;

/// Block of one half, mirrored to the counter-clockwise side.
struct HalfBlock {
    /// Bottom, right, top and left side as in [`Block::new`].
    sides: [Curve; 4],
    u: Vec<f64>,
    v: Vec<f64>,
    mapping: Option<Mapping>,
    names: Vec<(Side, &'static str, Option<[f64; 2]>)>,
}

impl HalfBlock {
    fn plain(sides: [Curve; 4], u: Vec<f64>, v: Vec<f64>) -> Self {
        Self { sides, u, v, mapping: None, names: Vec::new() }
    }

    fn named(mut self, side: Side, name: &'static str) -> Self {
        self.names.push((side, name, None));
        self
    }

    /// Returns the block on its side of the tooth. Left and right are exchanged on the clockwise
    /// side to keep it right-handed.
    fn on(self, side: usize) -> Block {
        let mirrored = side == 1;
        let placed = move |[x, y]: [f64; 2]| if mirrored { [x, -y] } else { [x, y] };
        let [bottom, right, top, left] = self.sides;
        let curve = |curve: Curve| Curve::new(move |t| placed(curve.at(t)));
        let back = |curve: Curve| Curve::new(move |t| placed(curve.at(1.0 - t)));
        let mut block = if mirrored {
            let u = self.u.iter().rev().map(|u| 1.0 - u).collect();
            Block::new(back(bottom), curve(left), back(top), curve(right)).divided(u, self.v)
        } else {
            Block::new(curve(bottom), curve(right), curve(top), curve(left)).divided(self.u, self.v)
        };
        if let Some(mapping) = self.mapping {
            block = block.mapped(move |u, v| placed(mapping(if mirrored { 1.0 - u } else { u }, v)));
        }
        for (place, name, s) in self.names {
            let (place, s) = match place {
                _ if !mirrored => (place, s),
                Side::Left => (Side::Right, s),
                Side::Right => (Side::Left, s),
                _ => (place, s.map(|[from, to]| [to, from])),
            };
            block = match s {
                Some(s) => block.on_profile(place, name, s),
                None => block.named(place, name),
            };
        }
        block
    }
}

/// Half of a section with the other half, which determines the middle line.
struct HalfSection<'a> {
    layout: &'a Layout,
    half: Arc<Half>,
    other: Arc<Half>,
    bore_height: f64,
}

impl HalfSection<'_> {
    fn blocks(&self) -> Vec<HalfBlock> {
        let mut blocks = self.strip();
        blocks.push(self.tip());
        blocks.extend(self.inside());
        blocks
    }

    fn name(&self, names: [&'static str; 2]) -> &'static str {
        names[self.half.side]
    }

    fn inner(&self, from: f64, to: f64) -> Curve {
        let half = Arc::clone(&self.half);
        Curve::new(move |t| half.inner((1.0 - t) * from + t * to))
    }

    fn outer(&self, from: f64, to: f64) -> Curve {
        let half = Arc::clone(&self.half);
        Curve::new(move |t| half.outer((1.0 - t) * from + t * to)[0])
    }

    /// Point at mid-distance between a point of this half and one of the other half.
    fn between(own: [f64; 2], other: [f64; 2]) -> [f64; 2] {
        [0.5 * (own[0] + other[0]), 0.5 * (own[1] - other[1])]
    }

    /// Coordinates of the fillet at the ends of a part of the boundary below the flank.
    fn fillet_range(&self, from: f64, to: f64) -> [f64; 2] {
        let (breaks, tooth, side) = (&self.layout.breaks, &self.layout.tooth, self.half.side);
        let length = tooth.fillet_length(side);
        let knee = length * self.layout.knee_parts[side];
        let bottom = length + land_length(tooth, side, 0.0).max(0.0);
        [from, to].map(|q| {
            if q >= breaks.knee {
                knee * (breaks.form - q) / (breaks.form - breaks.knee)
            } else if breaks.land > 0.0 && q >= breaks.land {
                knee + (length - knee) * (breaks.knee - q) / (breaks.knee - breaks.land)
            } else if breaks.land > 0.0 {
                bottom + (length - bottom) * q / breaks.land
            } else {
                bottom + (knee - bottom) * q / breaks.knee
            }
        })
    }

    /// Strip from the middle of the space to the tip edge.
    fn strip(&self) -> Vec<HalfBlock> {
        let layout = self.layout;
        let breaks = layout.breaks;
        let mut blocks = Vec::new();
        let [root, fillet, flank] = &layout.parts;
        let mut pieces: Vec<&[f64]> = vec![fillet, flank];
        // The coordinate of the fillet is linear in each block.
        let split = root.iter().position(|&q| q == breaks.land).filter(|&at| at > 0);
        match split {
            Some(at) => pieces.extend([&root[..=at], &root[at..]]),
            None => pieces.push(root),
        }
        for at in pieces {
            let (from, to) = ends(at);
            let mut names = if from >= breaks.form {
                let scale = layout.tooth.edge_from(self.half.side) / (breaks.edge - breaks.form);
                let s = [from, to].map(|q| scale * (q - breaks.form));
                vec![(Side::Top, self.name(["flank_0", "flank_1"]), Some(s))]
            } else {
                let s = self.fillet_range(from, to);
                vec![(Side::Top, self.name(["fillet_0", "fillet_1"]), Some(s))]
            };
            if from == 0.0 {
                names.push((Side::Left, self.name(["cut_left", "cut_right"]), None));
            }
            let half = Arc::clone(&self.half);
            let layers = layout.layers;
            let columns = Memoized::new(move |u: f64| {
                let q = (1.0 - u) * from + u * to;
                (Arc::new(layers.at(q)), [half.inner(q), half.outer(q)[0]])
            });
            let through = move |u: f64, v: f64| {
                let (layers, [inner, outer]) = columns.at(u);
                let v = piecewise_linear(&layers, v);
                [0, 1].map(|axis| (1.0 - v) * inner[axis] + v * outer[axis])
            };
            let across = |u: f64| {
                let through = through.clone();
                Curve::new(move |v| through(u, v))
            };
            blocks.push(HalfBlock {
                sides: [self.inner(from, to), across(1.0), self.outer(from, to), across(0.0)],
                u: normalised(at),
                v: uniform(layout.refinement.layers),
                mapping: Some(Arc::new(through)),
                names,
            });
        }
        blocks
    }

    /// Corner of the tip edge, the inner side of the strip below it, the middle of the tip land,
    /// and the inner side of its strip.
    fn tip_corners(&self) -> [[f64; 2]; 4] {
        let edge = self.layout.breaks.edge;
        let [corner, others] = [&self.half, &self.other].map(|half| half.outer(edge)[0]);
        let below = self.half.inner(edge);
        [corner, below, self.on_land(corner, others, 1.0), self.middle(1.0)]
    }

    /// Tip land from the corner of this half (0) to the middle (1).
    fn on_land(&self, corner: [f64; 2], other: [f64; 2], part: f64) -> [f64; 2] {
        let own = self.half.rolled(corner);
        let other = self.half.rolled([other[0], -other[1]]);
        let [height, azimuth] = [0, 1].map(|k: usize| (1.0 - 0.5 * part) * own[k] + 0.5 * part * other[k]);
        self.half.at_height(height, azimuth)
    }

    fn tip(&self) -> HalfBlock {
        let [corner, below, top, centre] = self.tip_corners();
        let other = self.other.outer(self.layout.breaks.edge)[0];
        let land = self.layout.land.clone();
        let (half, heights) = (Arc::clone(&self.half), [corner, other]);
        let [own, other] = [half.rolled(heights[0]), half.rolled([heights[1][0], -heights[1][1]])];
        let on_land = Curve::new(move |u| {
            let part = piecewise_linear(&land, u);
            let [height, azimuth] =
                [0, 1].map(|k: usize| (1.0 - 0.5 * part) * own[k] + 0.5 * part * other[k]);
            half.at_height(height, azimuth)
        });
        let sides =
            [Curve::line(below, centre), Curve::line(centre, top), on_land, Curve::line(below, corner)];
        let v = self.layout.layers.at(self.layout.breaks.edge);
        HalfBlock::plain(sides, uniform(self.layout.refinement.across), v).named(Side::Top, "tip")
    }

    /// Depth by which the lower end of the middle line lies below the middles of the fillets, m.
    fn drop(&self) -> f64 {
        let knee = self.layout.breaks.knee;
        let [own, other] = [&self.half, &self.other].map(|half| half.inner(knee));
        let width = 0.5 * (own[1] + other[1]);
        let height = 0.5 * (self.half.rolled(own)[0] + self.half.rolled(other)[0]);
        (0.3 * width).min(0.3 * (height - self.bore_height))
    }

    /// Middle line of the core from its lower end (0) to the strip of the tip (1).
    fn middle(&self, t: f64) -> [f64; 2] {
        middle_point(&self.half, &self.other, self.drop(), t)
    }

    /// Core of the tooth and the two parts of the rim.
    fn inside(&self) -> [HalfBlock; 3] {
        let layout = self.layout;
        let (knee_q, edge) = (layout.breaks.knee, layout.breaks.edge);
        let [_, corner, _, centre] = self.tip_corners();
        let bottom = self.middle(0.0);
        let knee = self.half.inner(knee_q);
        let root = self.half.inner(0.0);
        let azimuths = [&self.half, &self.other].map(|half| FOOT * half.rolled(half.inner(knee_q))[1]);
        let middle = 0.5 * (azimuths[0] - azimuths[1]);
        let (foot, cut) = (azimuths[0], self.half.cut);
        let on_bore = |azimuth: f64| self.half.at_height(self.bore_height, azimuth);
        let bore_arc = |from: f64, to: f64| {
            let (half, height) = (Arc::clone(&self.half), self.bore_height);
            Curve::new(move |t| half.at_height(height, (1.0 - t) * from + t * to))
        };
        let across = layout.refinement.across;
        let along: Vec<f64> = layout.parts[1].iter().chain(&layout.parts[2][1..]).copied().collect();
        let (half, other, drop) = (Arc::clone(&self.half), Arc::clone(&self.other), self.drop());
        let middle_line = Curve::new(move |t| middle_point(&half, &other, drop, t));
        let core = HalfBlock::plain(
            [middle_line, Curve::line(centre, corner), self.inner(knee_q, edge), Curve::line(bottom, knee)],
            normalised(&along),
            uniform(across),
        );
        let under_tooth = HalfBlock::plain(
            [
                Curve::line(bottom, knee),
                Curve::line(knee, on_bore(foot)),
                bore_arc(middle, foot),
                Curve::line(bottom, on_bore(middle)),
            ],
            uniform(across),
            layout.into_rim.clone(),
        );
        let lower = &layout.parts[0];
        let below = normalised(&lower.iter().rev().map(|q| knee_q - q).collect::<Vec<_>>());
        let under_space = HalfBlock::plain(
            [
                self.inner(knee_q, 0.0),
                Curve::line(root, on_bore(cut)),
                bore_arc(foot, cut),
                Curve::line(knee, on_bore(foot)),
            ],
            below,
            layout.into_rim.clone(),
        );
        [
            core,
            under_tooth.named(Side::Top, "bore"),
            under_space.named(Side::Top, "bore").named(Side::Right, self.name(["cut_left", "cut_right"])),
        ]
    }
}

fn middle_point(half: &Half, other: &Half, drop: f64, t: f64) -> [f64; 2] {
    let q = (1.0 - t) * half.breaks.knee + t * half.breaks.edge;
    let [x, y] = HalfSection::between(half.inner(q), other.inner(q));
    [x - (1.0 - t) * drop, y]
}
