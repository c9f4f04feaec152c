//! Tables of teeth for tests.

use super::table::{PointGrid, ToothTable};
use crate::blank::GearBlank;
use crate::fillet::Side;
use crate::helix::{Hand, Helix};
use crate::prototype::GearPrototype;
use crate::rack::Rack;
use calyx_runtime::profile::Profile;
use calyx_runtime::scene::StructureOptions;
use calyx_runtime::surface::Surface;
use std::sync::Arc;

pub const MODULE: f64 = 3e-3;

/// Cylindrical gear of 24 teeth.
pub fn cylindrical(helix_degrees: f64) -> Arc<GearPrototype> {
    let rack = Rack::new(MODULE, 20_f64.to_radians(), 0.3 * MODULE).expect("a rack");
    let mut blank = GearBlank::standard(24, rack).face_width(8.0 * MODULE);
    if helix_degrees > 0.0 {
        blank.helix = Helix::new(helix_degrees.to_radians(), Hand::Right).expect("a helix");
    }
    blank.cut().expect("a gear")
}

fn parts(count: usize) -> impl Iterator<Item = f64> {
    (0..count).map(move |k| k as f64 / (count - 1) as f64)
}

/// Table with the flanks and fillets of a cylindrical gear.
pub fn sampled(gear: &GearPrototype, stations: usize, points: usize) -> ToothTable {
    // Flanks up to the tip circle.
    let flanks = gear.flanks_with(1e-9 * MODULE, &[]).expect("flanks");
    let twist = gear.twist_per_length();
    let z: Vec<f64> = parts(stations).map(|part| (part - 0.5) * gear.face_width).collect();
    let flank = |side: usize| -> PointGrid {
        let end = flanks[side].edge_range()[0];
        let point = |part: f64, z: f64| {
            // Points at equal differences of the roll angle: the curvature varies like its
            // reciprocal.
            let roll = flanks[side].form_roll() * (1.0 - part) + flanks[side].roll_at(end) * part;
            let [x, y] = flanks[side].at(flanks[side].s_at_roll(roll)).position;
            let (sine, cosine) = (twist * z).sin_cos();
            [cosine * x - sine * y, sine * x + cosine * y, z]
        };
        z.iter().map(|&z| parts(points).map(|part| point(part, z)).collect()).collect()
    };
    let fillet = |side: Side| -> PointGrid {
        let fillet = gear.gear.root_fillet(side);
        let point = |part: f64, z: f64| {
            let [x, y] = fillet.at(part * fillet.fillet_length()).position;
            let (sine, cosine) = (twist * z).sin_cos();
            [cosine * x - sine * y, sine * x + cosine * y, z]
        };
        z.iter().map(|&z| parts(points).map(|part| point(part, z)).collect()).collect()
    };
    ToothTable {
        teeth: gear.gear.teeth(),
        pitch_angle: 0.0,
        flanks: [flank(0), flank(1)],
        fillets: [fillet(Side::CounterClockwise), fillet(Side::Clockwise)],
    }
}

/// Conical gear: the section of a cylindrical gear of `virtual_teeth` teeth in each back cone,
/// scaled with the distance from the apex.
#[derive(Clone, Copy, Debug)]
pub struct Conical {
    pub teeth: u32,
    pub virtual_teeth: u32,
    /// Tip radius of the rack, modules.
    pub tip_radius: f64,
    /// Spiral angle at mid-face, degrees, right hand if positive.
    pub spiral: f64,
    /// Rotation of the profile by its height, rad per module: flanks of different pressure angles.
    pub lean: f64,
    /// True if the pitch cone opens towards +e3.
    pub upwards: bool,
    /// Face width relative to the outer cone distance.
    pub face: f64,
}

impl Conical {
    pub const PINION: Self = Self {
        teeth: 12,
        virtual_teeth: 13,
        tip_radius: 0.3,
        spiral: 35.0,
        lean: 0.0,
        upwards: false,
        face: 0.33,
    };
    pub const GEAR: Self = Self { teeth: 36, virtual_teeth: 100, spiral: -35.0, ..Self::PINION };

    pub fn pitch_angle(&self) -> f64 {
        (f64::from(self.teeth) / f64::from(self.virtual_teeth)).acos()
    }

    /// Outer cone distance for a module of 5 mm at the heel, m.
    pub fn outer_cone_distance(&self) -> f64 {
        0.5 * 5e-3 * f64::from(self.teeth) / self.pitch_angle().sin()
    }

    pub fn table(&self, stations: usize, points: usize) -> ToothTable {
        let rack = Rack::new(1.0, 20_f64.to_radians(), self.tip_radius).expect("a rack");
        let virtual_gear = GearBlank::standard(self.virtual_teeth, rack).cut().expect("a virtual gear");
        let sharp = StructureOptions { sharp_edges: true, ..StructureOptions::default() };
        let surfaces = virtual_gear.surfaces(&sharp).expect("flanks");
        let (sine, cosine) = self.pitch_angle().sin_cos();
        let outer = self.outer_cone_distance();
        let mean = (1.0 - 0.5 * self.face) * outer;
        let pitch_radius = 0.5 * f64::from(self.virtual_teeth);
        let place = |[x, y]: [f64; 2], distance: f64| {
            let scale = distance * sine / cosine / pitch_radius;
            let height = x.hypot(y) - pitch_radius;
            let angle = y.atan2(x) + self.lean * height / pitch_radius;
            // Logarithmic spiral: the spiral angle is the same everywhere.
            let spiral = self.spiral.to_radians().tan() / sine * (distance / mean).ln();
            let (radius, azimuth) = (distance * sine + scale * height * cosine, angle / cosine + spiral);
            let z = distance * cosine - scale * height * sine;
            [radius * azimuth.cos(), radius * azimuth.sin(), if self.upwards { z } else { -z }]
        };
        let distances: Vec<f64> =
            parts(stations).map(|part| outer * (1.0 - self.face * (1.0 - part))).collect();
        let grid = |curve: &dyn Fn(f64) -> [f64; 2]| -> PointGrid {
            distances
                .iter()
                .map(|&distance| parts(points).map(|part| place(curve(part), distance)).collect())
                .collect()
        };
        let flank = |side: usize| {
            let end = surfaces[side].edge_from().expect("an edge");
            grid(&|part| {
                let [x, y, _] = surfaces[side].at(part * end, 0.0).position;
                [x, y]
            })
        };
        let fillet = |side: Side| {
            let fillet = virtual_gear.gear.root_fillet(side);
            grid(&|part| fillet.at(part * fillet.fillet_length()).position)
        };
        ToothTable {
            teeth: self.teeth,
            pitch_angle: self.pitch_angle(),
            flanks: [flank(0), flank(1)],
            fillets: [fillet(Side::CounterClockwise), fillet(Side::Clockwise)],
        }
    }
}

/// Spiral bevel gear (36 teeth), pinion (12 teeth) or pinion with wider edges of its blades
/// ("pinion 0.07") of chapter 6 of the report, from the machine settings.
pub fn aerospace(name: &str) -> ToothTable {
    const INCH: f64 = 0.0254;
    let (mut flanks, mut fillets) =
        ([PointGrid::new(), PointGrid::new()], [PointGrid::new(), PointGrid::new()]);
    let rows = include_str!("../../tests/data/bevel_teeth.csv").lines();
    for cells in rows.map(|row| row.split(',').collect::<Vec<&str>>()).filter(|cells| cells[0] == name) {
        let count = |cell: usize| cells[cell].parse::<usize>().expect("an index");
        let (side, section) = (count(2), count(3));
        let grid = if cells[1] == "flank" { &mut flanks[side] } else { &mut fillets[side] };
        if grid.len() <= section {
            grid.push(Vec::new());
        }
        grid[section].push([4, 5, 6].map(|cell: usize| INCH * cells[cell].parse::<f64>().expect("a number")));
    }
    let (teeth, pitch_angle) = if name == "gear" { (36, 71.5666_f64) } else { (12, 18.433) };
    ToothTable { teeth, pitch_angle: pitch_angle.to_radians(), flanks, fillets }
}
