//! Small test bodies: a disc, and a gear-like ring with straight-sided teeth.

use crate::profile::{Profile, ProfilePoint};
use crate::{BoreSupport, RingSource, SurfaceSource};
use calyx_fe::block::uniform;
use calyx_fe::material::{Material, Plane};
use calyx_fe::{Block, Curve, ElementOrder, MeshBuilder, PlaneMesh, PlaneModel, Side};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};
use std::sync::Arc;

pub const STEEL: Material = Material { youngs_modulus: 2.06e11, poissons_ratio: 0.3, density: 7800.0 };

/// Circular arc with the material inside, counter-clockwise from angle `from`.
pub struct Arc2 {
    pub radius: f64,
    pub from: f64,
    pub angle: f64,
}

impl Profile for Arc2 {
    fn length(&self) -> f64 {
        self.radius * self.angle
    }

    fn at(&self, s: f64) -> ProfilePoint {
        let (sin, cos) = (self.from + s / self.radius).sin_cos();
        ProfilePoint {
            position: [self.radius * cos, self.radius * sin],
            tangent: [-sin, cos],
            normal: [cos, sin],
            curvature: 1.0 / self.radius,
        }
    }
}

/// Straight line with the material on one side.
pub struct Line {
    pub from: [f64; 2],
    pub to: [f64; 2],
    pub material_on_left: bool,
}

impl Profile for Line {
    fn length(&self) -> f64 {
        (self.to[0] - self.from[0]).hypot(self.to[1] - self.from[1])
    }

    fn at(&self, s: f64) -> ProfilePoint {
        let tangent = [0, 1].map(|axis| (self.to[axis] - self.from[axis]) / self.length());
        let side = if self.material_on_left { 1.0 } else { -1.0 };
        ProfilePoint {
            position: [0, 1].map(|axis| self.from[axis] + s * tangent[axis]),
            tangent,
            normal: [side * tangent[1], -side * tangent[0]],
            curvature: 0.0,
        }
    }
}

/// Returns a disc about the origin; surfaces 0 and 1 are quarter arcs about the +x and the -x axis.
pub fn disc(radius: f64, divisions: usize) -> (PlaneModel, Vec<SurfaceSource>) {
    let core = 0.5 * radius;
    let inner = |angle: f64| [core * angle.cos(), core * angle.sin()];
    let outer = |angle: f64| [radius * angle.cos(), radius * angle.sin()];
    let corner = |k: usize| FRAC_PI_4 + FRAC_PI_2 * k as f64;
    let mut builder = MeshBuilder::new();
    let along = uniform(divisions);
    // Quarter k lies between corner k - 1 and corner k; the core's sides bulge half as much as a
    // circle.
    let bulged = |a: f64, b: f64| {
        let (from, to) = (inner(a), inner(b));
        Curve::new(move |u| {
            let (sin, cos) = ((1.0 - u) * a + u * b).sin_cos();
            [
                0.5 * (core * cos + (1.0 - u) * from[0] + u * to[0]),
                0.5 * (core * sin + (1.0 - u) * from[1] + u * to[1]),
            ]
        })
    };
    builder.block(
        Block::new(
            bulged(corner(2), corner(3)),
            bulged(corner(3), corner(4)),
            bulged(corner(1), corner(0)),
            bulged(corner(2), corner(1)),
        )
        .divided(along.clone(), along.clone()),
    );
    for k in 0..4 {
        let (a, b) = (corner(k) - FRAC_PI_2, corner(k));
        let mut block = Block::new(
            bulged(b, a),
            Curve::line(inner(a), outer(a)),
            Curve::arc([0.0; 2], radius, b, a),
            Curve::line(inner(b), outer(b)),
        )
        .divided(along.clone(), uniform(divisions));
        if k % 2 == 0 {
            block = block.on_profile(Side::Top, &format!("rim_{}", k / 2), [FRAC_PI_2 * radius, 0.0]);
        }
        builder.block(block);
    }
    let mesh = builder.finish(ElementOrder::QUADRATIC).unwrap();
    let surfaces = [0, 1]
        .map(|side| SurfaceSource {
            profile: Arc::new(Arc2 { radius, from: PI * side as f64 - FRAC_PI_4, angle: FRAC_PI_2 }),
            chain: format!("rim_{side}"),
            edges: [None; 2],
            stress_chain: None,
            stress_points_per_edge: 1,
        })
        .to_vec();
    (PlaneModel::new(mesh, STEEL, Plane::Strain), surfaces)
}

/// Divisions of the sector of the toothed ring.
#[derive(Clone, Copy)]
pub struct Divisions {
    pub rim: usize,
    pub tooth_root: usize,
    pub flank: usize,
    pub thickness: usize,
    /// Ratio of the element size in the middle of the flank to that at the tip.
    pub grading: f64,
}

pub const COARSE: Divisions = Divisions { rim: 3, tooth_root: 3, flank: 10, thickness: 8, grading: 5.0 };

pub fn ring_source(teeth: u32) -> RingSource<'static> {
    RingSource {
        sectors: teeth,
        cuts: ["cut_first", "cut_last"],
        bore: "bore",
        support: BoreSupport::Rigid,
        coupled: 3,
    }
}

/// Returns symmetric divisions, finer towards both ends.
fn towards_both(count: usize, grading: f64) -> Vec<f64> {
    let half = calyx_fe::block::graded(count / 2, grading);
    let mut at: Vec<f64> = half.iter().map(|x| 0.5 * x).collect();
    at.extend(half.iter().rev().skip(1).map(|x| 1.0 - 0.5 * x));
    at
}

fn towards_end(count: usize, grading: f64) -> Vec<f64> {
    calyx_fe::block::graded(count, grading).iter().rev().map(|x| 1.0 - x).collect()
}

/// Radius of the root circle, and default radius of the bore.
const ROOT: f64 = 0.9;
pub const BORE: f64 = 0.75;

/// Adds the blocks of one sector, with its tooth at `angle`, in a ring of `teeth`; sides are named
/// only for the first sector.
fn sector_blocks(
    builder: &mut MeshBuilder,
    (teeth, bore): (u32, f64),
    scale: f64,
    angle: f64,
    divisions: Divisions,
    named: bool,
) {
    let (bore, root) = (bore * scale, ROOT * scale);
    let half_pitch = PI / f64::from(teeth);
    let half_tooth = 0.55 * half_pitch;
    let turned = move |[x, y]: [f64; 2]| {
        let (sin, cos) = angle.sin_cos();
        [cos * x - sin * y, sin * x + cos * y]
    };
    let polar = move |radius: f64, at: f64| turned([radius * at.cos(), radius * at.sin()]);
    let rim = |from: f64, to: f64| {
        Block::new(
            Curve::arc([0.0; 2], bore, angle + from, angle + to),
            Curve::line(polar(bore, to), polar(root, to)),
            Curve::arc([0.0; 2], root, angle + from, angle + to),
            Curve::line(polar(bore, from), polar(root, from)),
        )
    };
    let name = |block: Block, side: Side, chain: &str| if named { block.named(side, chain) } else { block };
    let across = towards_both(divisions.thickness, divisions.grading);
    let sides = uniform(divisions.rim);
    let blocks = [
        rim(half_pitch, half_tooth).divided(sides.clone(), uniform(divisions.rim)),
        rim(half_tooth, -half_tooth).divided(across.clone(), uniform(divisions.rim)),
        rim(-half_tooth, -half_pitch).divided(sides, uniform(divisions.rim)),
    ];
    for (index, block) in blocks.into_iter().enumerate() {
        let mut block = block.named(Side::Bottom, "bore");
        if index == 0 {
            block = name(block, Side::Left, "cut_last");
        } else if index == 2 {
            block = name(block, Side::Right, "cut_first");
        }
        builder.block(block);
    }
    let [lower, upper] = tooth_corners(teeth, scale);
    let [foot, middle, tip] = [polar(root, half_tooth), turned(lower), turned(upper)];
    let mirror = |[x, y]: [f64; 2]| turned([x, -y]);
    let [foot_low, middle_low, tip_low] = [polar(root, -half_tooth), mirror(lower), mirror(upper)];
    let mut base = Block::new(
        Curve::arc([0.0; 2], root, angle + half_tooth, angle - half_tooth),
        Curve::line(foot_low, middle_low),
        Curve::line(middle, middle_low),
        Curve::line(foot, middle),
    )
    .divided(across.clone(), uniform(divisions.tooth_root));
    base = name(name(base, Side::Left, "root_0"), Side::Right, "root_1");
    builder.block(base);
    let mut head = Block::new(
        Curve::line(middle, middle_low),
        Curve::line(middle_low, tip_low),
        Curve::line(tip, tip_low),
        Curve::line(middle, tip),
    )
    .divided(across, towards_end(divisions.flank, divisions.grading));
    if named {
        let length = (upper[0] - lower[0]).hypot(upper[1] - lower[1]);
        head = head.on_profile(Side::Left, "flank_0", [0.0, length]).on_profile(
            Side::Right,
            "flank_1",
            [0.0, length],
        );
    }
    builder.block(head);
}

/// Returns the start and the end of flank 0 of the tooth on the x axis.
fn tooth_corners(teeth: u32, scale: f64) -> [[f64; 2]; 2] {
    let pitch = ROOT * 2.0 * PI / f64::from(teeth) * scale;
    [[ROOT * scale + 0.3 * pitch, 0.25 * pitch], [ROOT * scale + 0.8 * pitch, 0.14 * pitch]]
}

/// Returns one sector with its tooth on the x axis, and its two flanks.
pub fn toothed_sector(teeth: u32, scale: f64, divisions: Divisions) -> (PlaneModel, Vec<SurfaceSource>) {
    sector_on((teeth, BORE), scale, divisions)
}

/// Returns the sector with a different bore radius, relative to the ring's radius of 1 before
/// scaling.
pub fn sector_on(ring: (u32, f64), scale: f64, divisions: Divisions) -> (PlaneModel, Vec<SurfaceSource>) {
    let mut builder = MeshBuilder::new();
    sector_blocks(&mut builder, ring, scale, 0.0, divisions, true);
    let mesh = builder.finish(ElementOrder::QUADRATIC).unwrap();
    let [lower, upper] = tooth_corners(ring.0, scale);
    let mirrored = |[x, y]: [f64; 2]| [x, -y];
    let lines = [
        Line { from: lower, to: upper, material_on_left: false },
        Line { from: mirrored(lower), to: mirrored(upper), material_on_left: true },
    ];
    let surfaces = lines
        .into_iter()
        .enumerate()
        .map(|(side, line)| SurfaceSource {
            profile: Arc::new(line) as Arc<dyn Profile>,
            chain: format!("flank_{side}"),
            edges: [None, Some(0.0)],
            stress_chain: Some(format!("root_{side}")),
            stress_points_per_edge: 2,
        })
        .collect();
    (PlaneModel::new(mesh, STEEL, Plane::Strain), surfaces)
}

/// Returns the whole ring as one mesh, with the names of its first sector and `bore` on the whole
/// circumference.
pub fn toothed_ring(teeth: u32, divisions: Divisions) -> PlaneMesh {
    ring_on((teeth, BORE), divisions)
}

/// Returns the whole ring with a different bore radius.
pub fn ring_on(ring: (u32, f64), divisions: Divisions) -> PlaneMesh {
    let mut builder = MeshBuilder::new();
    for tooth in 0..ring.0 {
        let angle = 2.0 * PI * f64::from(tooth) / f64::from(ring.0);
        sector_blocks(&mut builder, ring, 1.0, angle, divisions, tooth == 0);
    }
    builder.finish(ElementOrder::QUADRATIC).unwrap()
}
