//! Roots roughed by a tool with protuberance, compared with the tool itself: its profile is swept
//! past the gear, without the equations of the envelope.

use crate::common::standard_data;
use calyx_gears::external::{ExternalGear, ExternalGearData};
use calyx_gears::fillet::Side;
use calyx_gears::flank::Flank;
use calyx_gears::mesh_geometry::{HelicalTeeth, MeshGeometry};
use calyx_runtime::profile::Profile;
use std::f64::consts::PI;

const MODULE: f64 = 1e-3;
const DEDENDUM: f64 = 1.4;
const TIP_RADIUS: f64 = 0.39;

/// Roughing tool, lengths in modules.
#[derive(Clone, Copy)]
struct Tool {
    teeth: u32,
    shift: f64,
    protuberance: f64,
    degrees: f64,
    allowance: f64,
}

impl Tool {
    fn data(&self) -> ExternalGearData {
        let plain = standard_data(self.teeth, self.shift, TIP_RADIUS);
        let rack = plain
            .rack
            .with_protuberance((self.protuberance - self.allowance) * MODULE, self.degrees.to_radians())
            .expect("a tool");
        let root_radius = 0.5 * f64::from(self.teeth) * MODULE - (DEDENDUM - self.shift) * MODULE;
        ExternalGearData { rack, root_radius, ..plain }
    }

    fn gear(&self) -> ExternalGear {
        ExternalGear::new(self.data()).expect("a gear")
    }

    /// Signed distance of a point from the tool in modules, negative inside. `x` along the pitch
    /// line from the middle of the tool's tooth, `y` into the gear, both in modules.
    fn distance(&self, [x, y]: [f64; 2]) -> f64 {
        let x = x.abs();
        let (sine, cosine) = 20.0_f64.to_radians().sin_cos();
        let depth = DEDENDUM - self.shift;
        // The tooth of the finished gear is as thick as its profile shift says; the tool is thinner
        // by the allowance.
        let half = 0.25 * PI - self.shift * sine / cosine;
        let flank = (x - half) * cosine + y * sine + self.allowance;
        // The tip rounding touches the parallel to the flank that protrudes by the protuberance.
        let centre_y = depth - TIP_RADIUS;
        let centre_x =
            half - (self.allowance - self.protuberance + TIP_RADIUS) / cosine - centre_y * sine / cosine;
        let (dx, dy) = (x - centre_x, y - centre_y);
        let (steep_sine, steep_cosine) = self.degrees.to_radians().sin_cos();
        let steep = dx * steep_cosine + dy * steep_sine - TIP_RADIUS;
        let tip = y - depth;
        let rounded = dx > 0.0 && -dx * steep_sine + dy * steep_cosine > 0.0;
        let protuberance = if rounded { dx.hypot(dy) - TIP_RADIUS } else { steep.max(tip) };
        // The main flank ends where it meets that of the protuberance.
        let end = centre_y
            + ((TIP_RADIUS - self.protuberance) / cosine - TIP_RADIUS / steep_cosine)
                / (sine / cosine - steep_sine / steep_cosine);
        protuberance.min(flank.max(y - end))
    }

    /// Least distance of a point of the tooth from the tool during the whole motion, modules.
    fn clearance(&self, [x, y]: [f64; 2]) -> f64 {
        let teeth = f64::from(self.teeth);
        let radius = 0.5 * teeth;
        let at = |roll: f64| {
            let (sine, cosine) = (-PI / teeth - roll).sin_cos();
            let [a, b] = [(cosine * x - sine * y) / MODULE, (sine * x + cosine * y) / MODULE];
            self.distance([b + radius * roll, radius - a])
        };
        let (count, range) = (8000, 1.5 * PI / teeth + 8.0 / teeth + 0.1);
        let place = |k: i32| range * f64::from(k) / f64::from(count);
        let best = (-count..=count).min_by(|&a, &b| at(place(a)).total_cmp(&at(place(b)))).expect("places");
        let (mut a, mut b) = (place(best - 1), place(best + 1));
        let golden = 0.5 * (5.0_f64.sqrt() - 1.0);
        for _ in 0..60 {
            let (c, d) = (b - golden * (b - a), a + golden * (b - a));
            if at(c) < at(d) { b = d } else { a = c }
        }
        at(0.5 * (a + b))
    }
}

const TOOLS: [Tool; 7] = [
    Tool { teeth: 20, shift: 0.0, protuberance: 0.05, degrees: 10.0, allowance: 0.0 },
    Tool { teeth: 25, shift: 0.3, protuberance: 0.1, degrees: 8.0, allowance: 0.06 },
    Tool { teeth: 40, shift: -0.2, protuberance: 0.12, degrees: 12.0, allowance: 0.07 },
    Tool { teeth: 12, shift: 0.0, protuberance: 0.05, degrees: 10.0, allowance: 0.02 },
    Tool { teeth: 60, shift: 0.0, protuberance: 0.08, degrees: 0.0, allowance: 0.04 },
    // The flank of the protuberance, not the tip rounding, meets the finished flank.
    Tool { teeth: 300, shift: 0.0, protuberance: 0.12, degrees: 14.0, allowance: 0.05 },
    Tool { teeth: 1000, shift: 0.5, protuberance: 0.1, degrees: 10.0, allowance: 0.04 },
];

#[test]
fn the_tool_touches_every_point_of_the_root_and_enters_neither_root_nor_flank() {
    for tool in TOOLS {
        let gear = tool.gear();
        let fillet = gear.root_fillet(Side::CounterClockwise);
        let flank = Flank::new(&gear, &[], Side::CounterClockwise).expect("a flank");
        for k in 0..=40 {
            let point = fillet.at(fillet.length() * f64::from(k) / 40.0).position;
            let clearance = tool.clearance(point);
            assert!(clearance.abs() < 1e-11, "{} teeth, fillet {k}: {clearance}", tool.teeth);
        }
        for k in 0..=20 {
            let point = flank.at(flank.edge_range()[0] * f64::from(k) / 20.0).position;
            let clearance = tool.clearance(point);
            // Away from the root, the grinding allowance remains.
            let least = if k == 20 { tool.allowance - 1e-11 } else { -1e-11 };
            assert!(clearance >= least, "{} teeth, flank {k}: {clearance}", tool.teeth);
        }
        // Fillet and flank meet in one point, at the form circle.
        let [a, b] = [fillet.at(0.0).position, flank.at(0.0).position];
        assert!((a[0] - b[0]).hypot(a[1] - b[1]) < 1e-12 * MODULE * f64::from(tool.teeth), "{}", tool.teeth);
        assert!((a[0].hypot(a[1]) - gear.form_radius).abs() < 1e-15);
    }
}

#[test]
fn parts_of_the_root_join_smoothly() {
    let mut with_lead_in = 0;
    for tool in TOOLS {
        let gear = tool.gear();
        let fillet = gear.root_fillet(Side::CounterClockwise);
        with_lead_in += usize::from(fillet.breaks().len() == 2);
        for &s in fillet.breaks() {
            let [before, after] = [s * (1.0 - 1e-13), s * (1.0 + 1e-13)].map(|s| fillet.at(s));
            for axis in 0..2 {
                assert!((before.position[axis] - after.position[axis]).abs() < 1e-14, "{}", tool.teeth);
                assert!((before.normal[axis] - after.normal[axis]).abs() < 1e-9, "{}", tool.teeth);
            }
        }
        // The tangent is the derivative of the position by the arc length.
        let mut bounds = vec![0.0];
        bounds.extend(fillet.breaks());
        bounds.push(fillet.length());
        for part in bounds.windows(2).filter(|part| part[1] - part[0] > 1e-6 * MODULE) {
            let (s, step) = (0.5 * (part[0] + part[1]), 1e-3 * (part[1] - part[0]));
            let [before, at, after] = [s - step, s, s + step].map(|s| fillet.at(s));
            for axis in 0..2 {
                let tangent = (after.position[axis] - before.position[axis]) / (2.0 * step);
                assert!((tangent - at.tangent[axis]).abs() < 1e-5, "{} teeth", tool.teeth);
                let bend = (after.tangent[axis] - before.tangent[axis]) / (2.0 * step);
                let expected = -at.curvature * at.normal[axis];
                assert!((bend - expected).abs() < 1e-4 * at.curvature.abs(), "{} teeth", tool.teeth);
            }
        }
    }
    assert!(with_lead_in > 0, "no case begins on the flank of the protuberance");
}

#[test]
fn a_vanishing_protuberance_has_the_bits_of_the_plain_rack() {
    let tool = Tool { teeth: 25, shift: 0.3, protuberance: 0.1, degrees: 10.0, allowance: 0.1 };
    let plain =
        ExternalGear::new(ExternalGearData { rack: standard_data(25, 0.3, TIP_RADIUS).rack, ..tool.data() });
    let [with, without] = [tool.gear(), plain.expect("a gear")];
    assert_eq!(with.form_radius.to_bits(), without.form_radius.to_bits());
    let [a, b] = [&with, &without].map(|gear| gear.root_fillet(Side::Clockwise));
    for k in 0..=50 {
        let at = |fillet: &dyn Profile| fillet.at(fillet.length() * f64::from(k) / 50.0);
        assert_eq!(at(&a), at(&b));
    }
    // The form circle moves with the square root of a small protuberance: a circle of radius rho
    // leaves its tangent at the depth c over a length of sqrt(2 rho c).
    for small in [1e-6, 1e-8, 1e-10] {
        let small = Tool { protuberance: 0.1 + small, ..tool }.gear();
        let moved = (small.form_radius - without.form_radius) / MODULE;
        let depth = small.rack.residual_undercut / MODULE;
        assert!(moved > 0.0 && moved < 3.0 * depth.sqrt(), "{depth}: {moved}");
    }
}

#[test]
fn a_protuberance_that_leaves_no_flank_is_an_error() {
    let tool = Tool { teeth: 20, shift: 0.0, protuberance: 1.0, degrees: 0.0, allowance: 0.0 };
    let errors = ExternalGear::new(tool.data()).expect_err("no flank remains");
    assert_eq!(errors[0].code, "E0934");
}

#[test]
fn a_shortened_path_of_contact_is_reported() {
    let plain = ExternalGear::new(standard_data(60, 0.0, TIP_RADIUS)).expect("a gear");
    for (protuberance, shortened) in [(0.05, false), (0.2, true)] {
        let gear = Tool { protuberance, ..TOOLS[4] }.gear();
        let distance = gear.pitch_radius + plain.pitch_radius;
        for (gears, roll) in [([&gear, &plain], 0), ([&plain, &gear], 1)] {
            let checked =
                MeshGeometry::check_external(gears[0], gears[1], distance, &HelicalTeeth::default());
            let (mesh, warnings) = checked.expect("a mesh");
            let found = warnings.iter().find(|warning| warning.code == "W0849");
            assert_eq!(found.map(|warning| warning.argument), shortened.then_some(["first", "second"][roll]));
            let start = if roll == 0 {
                mesh.first_roll.start_of_active_profile
            } else {
                mesh.second_roll(mesh.first_roll.end_of_active_profile)
            };
            assert!(start >= gear.form_roll - 1e-12, "{protuberance}: {start} {}", gear.form_roll);
            assert_eq!((start - gear.form_roll).abs() < 1e-12, shortened, "{protuberance}");
        }
    }
}
