//! Two-dimensional mesh of one tooth with its sector of the rim, from the middle of one tooth space
//! to the next.
//!
//! A strip of elements follows the boundary from the root centre over fillet, flank, tip edge and
//! tip. It is graded as finely as loads and fillet stresses require. Inside it are the core of the
//! tooth and, below, the rim in two parts: one under the tooth, one under the space. The layout
//! covers one half, with the tooth's centreline along +x. The other half is its mirror image, so
//! that the two cuts have the same nodes (cyclic symmetry).
//!
//! ```text
//!            space : C ______                 C root centre      K middle of the fillet
//!                    |  B0   \ K              M middle of the tip edge's arc, T tip centre
//!              rim   C'-----. \_____________  (primed points: inner side of the strip)
//!              under |       K'\  B1  B2  B3 \M
//!   bore       space |        | `-----------M' |
//!     E..............|........|    core     |  | B4, B5
//!              under tooth    D-------------T'-T   centreline
//! ```
//!
//! An internal gear has the same parts, with its outside as the bore. Radii are reversed, and
//! blocks that would be left-handed are mirrored.

mod boundary;
pub(crate) mod divisions;
mod refinement;

pub use refinement::{Refinement, TipEdge};

use boundary::Boundary;
use divisions::{divisions, ends, growth, normalised, piecewise_linear};

use crate::fillet::Side as ToothSide;
use crate::flank::Flank;
use crate::gear::Gear;
use calyx_abi::math;
use calyx_runtime::fe::block::{graded, uniform};
use calyx_runtime::fe::memoized::Memoized;
use calyx_runtime::fe::{Block, Curve, MeshBuilder, MeshError, PlaneMesh, Side};
use calyx_runtime::profile::Profile;
use std::sync::Arc;

/// Smallest thickness between root circle and bore that can be meshed, in modules.
pub const THINNEST_RIM: f64 = 0.25;

/// Largest thickness of the strip, in modules.
const STRIP_DEPTH: f64 = 0.25;
/// Ratio of the depth of the strip's outermost layer to the length of the flank's elements above
/// it.
pub(crate) const OUTERMOST_LAYER: f64 = 0.4;
/// Growth of the element length per distance from the fillet.
pub(crate) const FILLET_GROWTH: f64 = 0.4;
/// Ratio of the length of the flank's last element to that of the edge's elements.
const FLANK_BESIDE_EDGE: f64 = 0.25;
/// Ratio of the depth of the web's elements to the width of a sector; the other constant is their
/// maximum number.
const WEB_DEPTH: f64 = 1.5;
const DEEPEST_WEB: f64 = 6.0;
/// Ratio of the length of the tip land's first element to that of the edge's elements.
pub(crate) const LAND_GROWTH: f64 = 1.5;

/// Creates the mesh of tooth 0 and its sector. `flanks` are the counter-clockwise and the clockwise
/// flank; `bore_radius` (m) is at least [`THINNEST_RIM`] modules below the root radius, or above
/// that of an internal gear.
///
/// Chains: `flank_0`, `flank_1` on the flank's profile from the form circle to the tip edge;
/// `edge_0`, `edge_1` on it over the rounded edge, if the mesh has one; `fillet_0`, `fillet_1` on
/// the profile of [`Gear::root_fillet`] from the form circle to the root centre; `tip`, `bore`;
/// `cut_left` at half a pitch counter-clockwise and `cut_right` at half a pitch clockwise.
///
/// # Errors
/// The mesh folds over itself because the block layout does not suit the shape of the tooth.
pub fn sector_mesh(
    gear: &Gear,
    flanks: [Arc<Flank>; 2],
    bore_radius: f64,
    refinement: &Refinement,
) -> Result<PlaneMesh, MeshError> {
    webbed_sector_mesh(gear, flanks, [bore_radius, bore_radius], refinement)
}

/// Creates the same mesh with a web: a rim down to the first radius and a web from there to the
/// second one (m), where the chain `bore` then lies. Without a web, both radii are equal. The
/// elements of the web are those beyond the first radius.
///
/// # Errors
/// As [`sector_mesh`].
pub fn webbed_sector_mesh(
    gear: &Gear,
    flanks: [Arc<Flank>; 2],
    [rim_radius, bore_radius]: [f64; 2],
    refinement: &Refinement,
) -> Result<PlaneMesh, MeshError> {
    let mut builder = MeshBuilder::new();
    // Both halves are laid out on the counter-clockwise side; the clockwise flank is mirrored.
    for (side, flank) in [ToothSide::CounterClockwise, ToothSide::Clockwise].into_iter().zip(flanks) {
        let web_radius = (bore_radius != rim_radius).then_some(bore_radius);
        let layout = Layout { web_radius, ..Layout::new(gear, flank, rim_radius, refinement) };
        for half_block in layout.blocks() {
            builder.block(half_block.on(side, gear.form().internal));
        }
    }
    builder.finish(refinement.order)
}

type Mapping = Arc<dyn Fn(f64, f64) -> [f64; 2] + Send + Sync>;

/// Block of the counter-clockwise half.
struct HalfBlock {
    /// Bottom, right, top and left side as in [`Block::new`].
    sides: [Curve; 4],
    u: Vec<f64>,
    v: Vec<f64>,
    /// Mapping that replaces the transfinite interpolation of the sides.
    mapping: Option<Mapping>,
    names: Vec<(Side, Name, Option<[f64; 2]>)>,
}

/// Chain names before the half is chosen.
#[derive(Clone, Copy)]
enum Name {
    Flank,
    Edge,
    Fillet,
    Tip,
    Bore,
    /// Inner boundary of a rim with a web.
    Rim,
    Cut,
}

impl Name {
    fn on(self, side: ToothSide) -> &'static str {
        match (self, side) {
            (Name::Flank, ToothSide::CounterClockwise) => "flank_0",
            (Name::Flank, ToothSide::Clockwise) => "flank_1",
            (Name::Edge, ToothSide::CounterClockwise) => "edge_0",
            (Name::Edge, ToothSide::Clockwise) => "edge_1",
            (Name::Fillet, ToothSide::CounterClockwise) => "fillet_0",
            (Name::Fillet, ToothSide::Clockwise) => "fillet_1",
            (Name::Cut, ToothSide::CounterClockwise) => "cut_left",
            (Name::Cut, ToothSide::Clockwise) => "cut_right",
            (Name::Tip, _) => "tip",
            (Name::Bore, _) => "bore",
            (Name::Rim, _) => "rim",
        }
    }
}

impl HalfBlock {
    /// Returns the block, or its mirror image on the clockwise side. Left and right are exchanged
    /// where necessary to keep it right-handed.
    fn on(self, side: ToothSide, internal: bool) -> Block {
        let mirrored = side == ToothSide::Clockwise;
        let turned = mirrored != internal;
        let placed = move |[x, y]: [f64; 2]| if mirrored { [x, -y] } else { [x, y] };
        let [bottom, right, top, left] = self.sides;
        let curve = |curve: Curve| Curve::new(move |t| placed(curve.at(t)));
        let back = |curve: Curve| Curve::new(move |t| placed(curve.at(1.0 - t)));
        let mut block = if turned {
            let u = self.u.iter().rev().map(|u| 1.0 - u).collect();
            Block::new(back(bottom), curve(left), back(top), curve(right)).divided(u, self.v)
        } else {
            Block::new(curve(bottom), curve(right), curve(top), curve(left)).divided(self.u, self.v)
        };
        if let Some(mapping) = self.mapping {
            block = block.mapped(move |u, v| placed(mapping(if turned { 1.0 - u } else { u }, v)));
        }
        for (place, name, s) in self.names {
            let (place, s) = match place {
                _ if !turned => (place, s),
                Side::Left => (Side::Right, s),
                Side::Right => (Side::Left, s),
                _ => (place, s.map(|[from, to]| [to, from])),
            };
            block = match s {
                Some(s) => block.on_profile(place, name.on(side), s),
                None => block.named(place, name.on(side)),
            };
        }
        block
    }
}

/// Data for the layout of the blocks of the counter-clockwise half.
#[derive(Clone)]
struct Layout {
    boundary: Arc<Boundary>,
    refinement: Refinement,
    module: f64,
    /// Element lengths on the fillet, on the tip edge's arc, and of the last flank element, m.
    fillet_size: f64,
    edge_size: f64,
    last_size: f64,
    /// Divisions of the boundary in `p`: the element boundaries in each part, including its ends.
    parts: Vec<(Part, Vec<f64>)>,
    tip_radius: f64,
    /// Polar angle at which the tip edge's arc meets the tip circle.
    tip_angle: f64,
    bore_radius: f64,
    /// Radius at which the web below the rim ends, m.
    web_radius: Option<f64>,
    cut_angle: f64,
    /// +1, or -1 for an internal gear.
    sense: f64,
}

/// Parts of the boundary, with `p` ascending.
#[derive(Clone, Copy, PartialEq)]
enum Part {
    /// From the middle of the fillet downwards, including the root circle.
    Root,
    /// From the middle of the fillet upwards.
    Fillet,
    Flank,
    /// First half of the tip edge's arc.
    Edge,
}

impl Layout {
    fn new(gear: &Gear, flank: Arc<Flank>, bore_radius: f64, refinement: &Refinement) -> Self {
        let teeth = gear.form();
        let (module, sense) = (teeth.module, teeth.sense());
        let fillet = gear.root_fillet(ToothSide::CounterClockwise);
        let form = fillet.length();
        let [edge_start, edge_end] = flank.edge_range();
        let middle_of_fillet = form - fillet.at_turned_normal(0.5);
        let edge = form + edge_start;
        let rounding = match refinement.edge {
            TipEdge::Rounded(_) => edge_end - edge_start,
            TipEdge::Corner(_) => 0.0,
        };
        let end = edge + 0.5 * rounding;
        let mut boundary = Boundary {
            fillet_from: form - fillet.fillet_length(),
            fillet,
            flank,
            form,
            edge,
            anchors: Vec::new(),
            tip_start: 0.0,
            tip_end: end,
            tip_depth: 0.0,
            sense,
        };
        let rim = sense * (teeth.root_radius - bore_radius);
        boundary.place_strip(module, rim);

        // A very short arc of the root circle has no elements of its own: it joins the fillet.
        let root_circle = boundary.fillet_from;
        let fillet_size = boundary.fillet.fillet_length() / refinement.fillet as f64;
        let mut root = Vec::new();
        if root_circle > 0.3 * fillet_size {
            root.extend(divisions(0.0, root_circle, |p| {
                (fillet_size + FILLET_GROWTH * (root_circle - p)).min(0.4 * module)
            }));
            root.pop();
            root.extend(divisions(root_circle, middle_of_fillet, |_| fillet_size));
        } else {
            root.extend(divisions(0.0, middle_of_fillet, |_| fillet_size));
        }
        let (edge_size, last_size) = match refinement.edge {
            TipEdge::Rounded(elements) => {
                let size = (end - edge) / elements as f64;
                (size, FLANK_BESIDE_EDGE * size)
            }
            TipEdge::Corner(last) => (last * module, last * module),
        };
        let [x, y] = boundary.flank_at(edge_start + rounding).position;
        let mut layout = Self {
            boundary: Arc::new(boundary),
            refinement: *refinement,
            module,
            fillet_size,
            edge_size,
            last_size,
            parts: Vec::new(),
            tip_radius: x.hypot(y),
            tip_angle: math::atan2(y, x),
            bore_radius,
            web_radius: None,
            cut_angle: 0.5 * teeth.pitch_angle(),
            sense,
        };
        layout.parts = vec![
            (Part::Root, root),
            (Part::Fillet, divisions(middle_of_fillet, form, |_| fillet_size)),
            (Part::Flank, divisions(form, edge, |p| layout.size(p))),
        ];
        if let TipEdge::Rounded(elements) = refinement.edge {
            let at = uniform(elements).iter().map(|part| edge + part * (end - edge)).collect();
            layout.parts.push((Part::Edge, at));
        }
        layout
    }

    fn inner(&self, from: f64, to: f64) -> Curve {
        let boundary = Arc::clone(&self.boundary);
        Curve::new(move |t| boundary.inner((1.0 - t) * from + t * to))
    }

    fn outer(&self, from: f64, to: f64) -> Curve {
        let boundary = Arc::clone(&self.boundary);
        Curve::new(move |t| boundary.outer((1.0 - t) * from + t * to).position)
    }

    /// Boundaries of the layers through the strip at `p`, as fractions of the distance from its
    /// inner side. Layers are thinnest at the boundary and grow geometrically.
    fn layers_at(&self, p: f64) -> Vec<f64> {
        let boundary = &self.boundary;
        let [from, to] = [boundary.inner(p), boundary.outer(p).position];
        let depth = (to[0] - from[0]).hypot(to[1] - from[1]);
        let layers = self.refinement.layers;
        let outermost = (OUTERMOST_LAYER * self.size(p) / depth).min(1.0 / layers as f64);
        let growth = growth(layers, outermost);
        graded(layers, math::pow(growth, 1.0 - layers as f64))
    }

    /// Target length of elements along the boundary, m.
    fn size(&self, p: f64) -> f64 {
        let boundary = &self.boundary;
        if p > boundary.edge {
            return self.edge_size;
        }
        let from_fillet = (boundary.fillet_from - p).max(p - boundary.form).max(0.0);
        let from_edge = self.last_size + self.refinement.tip_growth * (self.boundary.edge - p).max(0.0);
        let largest = self.refinement.flank * self.module;
        from_edge.min(largest).min(self.fillet_size + FILLET_GROWTH * from_fillet)
    }

    fn blocks(&self) -> Vec<HalfBlock> {
        let mut blocks = self.strip();
        blocks.extend(self.tip());
        blocks.extend(self.inside());
        blocks
    }

    /// Strip from the root centre to the middle of the tip edge's arc.
    fn strip(&self) -> Vec<HalfBlock> {
        let boundary = &self.boundary;
        let layers = uniform(self.refinement.layers);
        let mut blocks = Vec::new();
        for (part, at) in &self.parts {
            let (from, to) = ends(at);
            let mut names = match part {
                Part::Root | Part::Fillet => {
                    vec![(Side::Top, Name::Fillet, Some([boundary.form - from, boundary.form - to]))]
                }
                Part::Flank | Part::Edge => {
                    let name = if *part == Part::Flank { Name::Flank } else { Name::Edge };
                    vec![(Side::Top, name, Some([from - boundary.form, to - boundary.form]))]
                }
            };
            if *part == Part::Root {
                names.push((Side::Left, Name::Cut, None));
            }
            let layout = self.clone();
            let columns = Memoized::new(move |u| {
                let p = (1.0 - u) * from + u * to;
                let ends = [layout.boundary.inner(p), layout.boundary.outer(p).position];
                (Arc::new(layout.layers_at(p)), ends)
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
                v: layers.clone(),
                mapping: Some(Arc::new(through)),
                names,
            });
        }
        blocks
    }

    /// Number of elements from the strip to the centreline and over half of the tip edge's arc.
    fn across(&self) -> usize {
        self.refinement.edge.elements() + self.refinement.across
    }

    /// Corners of the inner side of the tip's strip: below the tip edge, below its end, and on the
    /// centreline.
    fn tip_corners(&self) -> [[f64; 2]; 3] {
        let corner = self.boundary.inner(self.boundary.tip_end);
        // As deep below the middle of the tip as at its edge.
        let centre = [corner[0] + 0.5 * (self.tip_radius - self.tip_radius * math::cos(self.tip_angle)), 0.0];
        let edge = self.refinement.edge.elements() as f64 / self.across() as f64;
        let between = [0, 1].map(|axis| (1.0 - edge) * corner[axis] + edge * centre[axis]);
        [corner, between, centre]
    }

    /// Strip over the second half of the arc, if the mesh has one, and along the tip circle.
    fn tip(&self) -> Vec<HalfBlock> {
        let boundary = &self.boundary;
        let [corner, between, centre] = self.tip_corners();
        let [_, edge_end] = boundary.flank.edge_range();
        let on_circle = {
            let (sine, cosine) = math::sincos(self.tip_angle);
            [self.tip_radius * cosine, self.tip_radius * sine]
        };
        // From the edge's elements to the middle of the tip land.
        let on_land = Curve::arc([0.0; 2], self.tip_radius, self.tip_angle, 0.0);
        let across = self.refinement.across;
        let smallest = LAND_GROWTH * self.edge_size / (self.tip_radius * self.tip_angle);
        let land =
            graded(across, math::pow(growth(across, smallest.min(1.0 / across as f64)), across as f64 - 1.0));
        let mut blocks = Vec::new();
        if let TipEdge::Rounded(elements) = self.refinement.edge {
            let (from, to) = (boundary.tip_end, boundary.form + edge_end);
            blocks.push(HalfBlock {
                sides: [
                    Curve::line(corner, between),
                    Curve::line(between, on_circle),
                    self.outer(from, to),
                    Curve::line(corner, boundary.outer(from).position),
                ],
                u: uniform(elements),
                v: self.layers_at(boundary.tip_end),
                mapping: None,
                names: vec![(Side::Top, Name::Edge, Some([from - boundary.form, edge_end]))],
            });
        }
        blocks.push(HalfBlock {
            sides: [
                Curve::line(between, centre),
                Curve::line(centre, [self.tip_radius, 0.0]),
                Curve::new(move |u| on_land.at(piecewise_linear(&land, u))),
                Curve::line(between, on_circle),
            ],
            u: uniform(across),
            v: self.layers_at(boundary.tip_end),
            mapping: None,
            names: vec![(Side::Top, Name::Tip, None)],
        });
        blocks
    }

    /// Core of the tooth, the two parts of the rim, and those of the web if there is one.
    fn inside(&self) -> Vec<HalfBlock> {
        let boundary = &self.boundary;
        let [corner, _, tip] = self.tip_corners();
        let knee_p = self.parts[1].1[0];
        let knee = boundary.inner(knee_p);
        let root = boundary.inner(0.0);
        let (knee_radius, knee_angle) = (knee[0].hypot(knee[1]), math::atan2(knee[1], knee[0]));
        let depth = self.sense * (knee_radius - self.bore_radius);
        let bottom = [knee[0] - self.sense * (0.3 * knee[1]).min(0.3 * depth), 0.0];
        let on_bore = |angle: f64| {
            let (sine, cosine) = math::sincos(angle);
            [self.bore_radius * cosine, self.bore_radius * sine]
        };
        let foot_angle = 0.9 * knee_angle;
        let bore_arc = |from: f64, to: f64| Curve::arc([0.0; 2], self.bore_radius, from, to);

        let across = self.across();
        let along = self.parts[1..].iter().fold(Vec::new(), |mut all: Vec<f64>, (_, at)| {
            all.extend(if all.is_empty() { &at[..] } else { &at[1..] });
            all
        });
        let core = HalfBlock {
            sides: [
                self.centreline(bottom[0], tip[0], knee_p),
                Curve::line(tip, corner),
                self.inner(knee_p, boundary.tip_end),
                Curve::line(bottom, knee),
            ],
            u: normalised(&along),
            v: uniform(across),
            mapping: None,
            names: Vec::new(),
        };
        let beneath = if self.web_radius.is_some() { Name::Rim } else { Name::Bore };
        let into_rim = self.depths_of_rim(depth);
        let under_tooth = HalfBlock {
            sides: [
                Curve::line(bottom, knee),
                Curve::line(knee, on_bore(foot_angle)),
                bore_arc(0.0, foot_angle),
                Curve::line(bottom, [self.bore_radius, 0.0]),
            ],
            u: uniform(across),
            v: into_rim.clone(),
            mapping: None,
            names: vec![(Side::Top, beneath, None)],
        };
        let under_space = HalfBlock {
            sides: [
                self.inner(knee_p, 0.0),
                Curve::line(root, on_bore(self.cut_angle)),
                bore_arc(foot_angle, self.cut_angle),
                Curve::line(knee, on_bore(foot_angle)),
            ],
            u: self.root_divisions(),
            v: into_rim,
            mapping: None,
            names: vec![(Side::Top, beneath, None), (Side::Right, Name::Cut, None)],
        };
        let mut blocks = vec![core, under_tooth, under_space];
        blocks.extend(self.web_radius.into_iter().flat_map(|web_radius| self.web(web_radius, foot_angle)));
        blocks
    }

    /// The two parts of the web below those of the rim.
    fn web(&self, web_radius: f64, foot_angle: f64) -> [HalfBlock; 2] {
        let (rim_radius, cut_angle) = (self.bore_radius, self.cut_angle);
        let part = |from: f64, to: f64, u: Vec<f64>, cut: bool| {
            let at = |radius: f64, angle: f64| {
                let (sine, cosine) = math::sincos(angle);
                [radius * cosine, radius * sine]
            };
            let ray = |angle: f64| Curve::line(at(rim_radius, angle), at(web_radius, angle));
            let arc = |radius: f64| Curve::arc([0.0; 2], radius, from, to);
            // For a good aspect ratio, elements are as deep as a part of the sector is wide. Their
            // number is limited to what the bending of a web requires.
            let depth = math::log(rim_radius / web_radius).abs();
            let count = (depth / (WEB_DEPTH * 2.0 * cut_angle)).ceil().clamp(1.0, DEEPEST_WEB);
            let mut names = vec![(Side::Top, Name::Bore, None)];
            if cut {
                names.push((Side::Right, Name::Cut, None));
            }
            HalfBlock {
                sides: [arc(rim_radius), ray(to), arc(web_radius), ray(from)],
                u,
                v: uniform(count as usize),
                mapping: None,
                names,
            }
        };
        [
            part(0.0, foot_angle, uniform(self.across()), false),
            part(foot_angle, cut_angle, self.root_divisions(), true),
        ]
    }

    /// Divisions of the blocks under the tooth space, from the fillet's middle (K') to the cut.
    fn root_divisions(&self) -> Vec<f64> {
        let knee_p = self.parts[1].1[0];
        normalised(&self.parts[0].1.iter().rev().map(|p| knee_p - p).collect::<Vec<_>>())
    }

    /// Centreline of the core, divided like the inner side of the strip above it, so that the
    /// elements of a thin tooth are not sheared.
    fn centreline(&self, from_x: f64, to_x: f64, from: f64) -> Curve {
        let boundary = Arc::clone(&self.boundary);
        let to = boundary.tip_end;
        let [start, end] = [from, to].map(|p| boundary.inner(p)[0]);
        Curve::new(move |t| {
            let x = boundary.inner((1.0 - t) * from + t * to)[0];
            let part = (x - start) / (end - start);
            [(1.0 - part) * from_x + part * to_x, 0.0]
        })
    }

    /// Divisions from the strip down to the bore, growing geometrically.
    fn depths_of_rim(&self, depth: f64) -> Vec<f64> {
        let growth = self.refinement.rim_growth;
        let first = self.refinement.flank * self.module;
        let count =
            (math::log(1.0 + depth * (growth - 1.0) / first) / math::log(growth)).ceil().max(1.0) as usize;
        graded(count, math::pow(growth, (count - 1) as f64))
    }
}
