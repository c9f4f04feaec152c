//! Profile curves: consistent differential geometry, conjugate action, and the fillet as the
//! envelope of the rack.

use crate::common::{INCH, chapter_5, chapter_5_data, standard_data};
use calyx_gears::external::ExternalGear;
use calyx_gears::fillet::Side;
use calyx_gears::flank::Flank;
use calyx_gears::mesh_geometry::MeshGeometry;
use calyx_gears::modification::{LINEAR_BLEND, Modification, ReliefShape};
use calyx_runtime::profile::{Profile, ProfilePoint};
use std::f64::consts::PI;

fn relief(shape: ReliefShape, start_deg: f64) -> Modification {
    Modification::tip_relief(0.0005 * INCH, start_deg.to_radians(), shape)
}

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

fn minus(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] - b[0], a[1] - b[1]]
}

/// Eighth-order finite difference.
fn derivative(f: impl Fn(f64) -> [f64; 2], at: f64, step: f64) -> [f64; 2] {
    let weights = [4.0 / 5.0, -1.0 / 5.0, 4.0 / 105.0, -1.0 / 280.0];
    let mut sum = [0.0; 2];
    for (k, weight) in weights.iter().enumerate() {
        let h = (k as f64 + 1.0) * step;
        let difference = minus(f(at + h), f(at - h));
        sum = [sum[0] + weight * difference[0] / step, sum[1] + weight * difference[1] / step];
    }
    sum
}

/// Compares tangent and curvature with finite differences, well inside the smooth parts.
fn check_profile(name: &str, profile: &dyn Profile, curvature_scale: f64) {
    let mut bounds = vec![0.0];
    bounds.extend_from_slice(profile.breaks());
    bounds.push(profile.length());
    for part in bounds.windows(2) {
        let length = part[1] - part[0];
        if length < 1e-9 {
            continue;
        }
        for k in 1..10 {
            let s = part[0] + length * (0.2 + 0.06 * f64::from(k));
            let step = 0.005 * length;
            let point = profile.at(s);
            let tangent = derivative(|s| profile.at(s).position, s, step);
            let bend = derivative(|s| profile.at(s).tangent, s, step);
            for axis in 0..2 {
                assert!((tangent[axis] - point.tangent[axis]).abs() < 1e-10, "{name}: tangent at {s}");
                let expected = -point.curvature * point.normal[axis];
                let error = (bend[axis] - expected).abs() / point.curvature.abs().max(curvature_scale);
                assert!(error < 1e-7, "{name}: curvature at {s}, {error}");
            }
            assert!(dot(point.tangent, point.normal).abs() < 1e-15);
            assert!((dot(point.normal, point.normal) - 1.0).abs() < 1e-15);
        }
    }
}

/// Position and normal are continuous where two parts meet.
fn check_joins(name: &str, a: &ProfilePoint, b: &ProfilePoint, size: f64) {
    for axis in 0..2 {
        let gap = (a.position[axis] - b.position[axis]).abs();
        assert!(gap < 1e-13 * size, "{name}: positions differ by {gap}");
        let turn = (a.normal[axis] - b.normal[axis]).abs();
        assert!(turn < 1e-11, "{name}: normals differ by {turn}");
    }
}

#[test]
fn flanks_and_fillets_have_consistent_geometry() {
    let cases: [(&str, u32, Vec<Modification>); 4] = [
        ("unmodified", 20, vec![]),
        ("quadratic", 20, vec![relief(ReliefShape::Quadratic, 27.25)]),
        ("linear", 40, vec![relief(ReliefShape::Linear, 22.0)]),
        ("both", 40, vec![relief(ReliefShape::Linear, 24.0), relief(ReliefShape::Quadratic, 19.6)]),
    ];
    for (name, teeth, modifications) in cases {
        let gear = chapter_5(teeth);
        for side in [Side::CounterClockwise, Side::Clockwise] {
            let flank = Flank::new(&gear, &modifications, side).expect("a flank");
            let scale = 1.0 / gear.pitch_radius;
            check_profile(name, &flank, scale);
            let [edge_start, edge_end] = flank.edge_range();
            for &s in flank.breaks() {
                let step = 1e-15 * gear.outer_radius;
                check_joins(name, &flank.at(s - step), &flank.at(s + step), gear.outer_radius);
            }
            // The edge ends on the tip circle with a radial normal.
            let end = flank.at(edge_end);
            assert!((end.position[0].hypot(end.position[1]) - gear.outer_radius).abs() < 1e-15 * INCH);
            assert!((dot(end.position, end.normal) - gear.outer_radius).abs() < 1e-15);
            assert_eq!(flank.edge_from(), Some(edge_start));
            // Outward normals: counter-clockwise on surface 0.
            let outwards = flank.at(0.3 * edge_start).normal[1];
            assert!(if side == Side::CounterClockwise { outwards > 0.0 } else { outwards < 0.0 });

            let fillet = gear.root_fillet(side);
            check_profile(name, &fillet, scale);
            let (form, start) = (flank.at(0.0), fillet.at(0.0));
            check_joins("form circle", &form, &start, gear.outer_radius);
            let join = fillet.fillet_length();
            check_joins("root circle", &fillet.at(join * (1.0 - 1e-15)), &fillet.at(join), gear.outer_radius);
            let root = fillet.at(fillet.length());
            assert!((root.position[1].atan2(root.position[0]).abs() - PI / f64::from(teeth)).abs() < 1e-15);
            assert!((root.position[0].hypot(root.position[1]) - gear.root_radius).abs() < 1e-15);
        }
    }
}

#[test]
fn arc_length_and_roll_are_inverse() {
    let gear = chapter_5(20);
    let flank =
        Flank::new(&gear, &[relief(ReliefShape::Quadratic, 27.25)], Side::Clockwise).expect("a flank");
    for k in 0..=100 {
        let roll = gear.form_roll + (flank.edge_roll() - gear.form_roll) * f64::from(k) / 100.0;
        let back = flank.roll_at(flank.s_at_roll(roll));
        assert!((back - roll).abs() < 2e-15, "{roll}: {back}");
    }
    // Unmodified: r (g^2 - g0^2) / 2.
    let exact = 0.5 * gear.base_radius * (0.25 - gear.form_roll * gear.form_roll);
    let plain = Flank::new(&gear, &[], Side::Clockwise).expect("a flank");
    assert!((plain.s_at_roll(0.45) - exact - 0.5 * gear.base_radius * (0.45 * 0.45 - 0.25)).abs() < 1e-17);
}

#[test]
fn relief_is_measured_normal_to_the_involute() {
    let gear = chapter_5(20);
    let plain = Flank::new(&gear, &[], Side::CounterClockwise).expect("a flank");
    let depth = 0.0005 * INCH;
    let (start, tip) = (27.25_f64.to_radians(), gear.tip_roll);
    for (shape, power) in [(ReliefShape::Linear, 1), (ReliefShape::Quadratic, 2)] {
        let flank = Flank::new(&gear, &[relief(shape, 27.25)], Side::CounterClockwise).expect("a flank");
        for roll in [0.3, start - 1.1 * LINEAR_BLEND * (tip - start), 0.52, 0.55, 0.57] {
            let expected = depth * ((roll - start) / (tip - start)).max(0.0).powi(power);
            let (point, involute) = (flank.at(flank.s_at_roll(roll)), plain.at(plain.s_at_roll(roll)));
            let offset = minus(involute.position, point.position);
            assert!((dot(offset, involute.normal) - expected).abs() < 1e-16, "{shape:?} at {roll}");
            assert!(dot(offset, involute.tangent).abs() < 1e-16, "{shape:?} at {roll}");
        }
        let amount = flank.amount_at(tip);
        assert!((amount - depth).abs() < 1e-18, "{shape:?}: {amount}");
    }
}

/// Rotates a point from tooth coordinates to the position of the tooth.
fn turned([x, y]: [f64; 2], angle: f64) -> [f64; 2] {
    let (sine, cosine) = angle.sin_cos();
    [cosine * x - sine * y, sine * x + cosine * y]
}

#[test]
fn involutes_are_conjugate_through_the_path_of_contact() {
    // The first gear pushes counter-clockwise with its surface 0; also at an increased centre
    // distance.
    let (first, second) = (chapter_5(20), chapter_5(40));
    let flank = Flank::new(&first, &[], Side::CounterClockwise).expect("a flank");
    let mate = Flank::new(&second, &[], Side::CounterClockwise).expect("a flank");
    for spread in [0.0, 0.02] {
        let distance = (3.0 + spread) * INCH;
        let mesh = MeshGeometry::external(&first, &second, distance).expect("a mesh");
        let path = mesh.first_roll;
        // Between the rounded edges.
        let (start, end) =
            (path.start_of_active_profile + 0.02, flank.edge_roll().min(path.end_of_active_profile));
        for k in 0..=50 {
            let roll = start + (end - start) * f64::from(k) / 50.0;
            let second_roll = mesh.second_roll(roll);
            let on_first = flank.at(flank.s_at_roll(roll));
            let on_second = mate.at(mate.s_at_roll(second_roll));
            // The normals lie along the line of action: at -a from the normal of the line of
            // centres on the first gear, and opposite on the second, whose centre is at (distance,
            // 0).
            let turn =
                |point: &ProfilePoint, direction: f64| direction - point.normal[1].atan2(point.normal[0]);
            let action = 0.5 * PI - mesh.operating_pressure_angle;
            let (first_turn, second_turn) = (turn(&on_first, action), turn(&on_second, action + PI));
            let a = turned(on_first.position, first_turn);
            let b = turned(on_second.position, second_turn);
            let gap = minus([b[0] + distance, b[1]], a);
            assert!(gap[0].hypot(gap[1]) < 1e-15 + 1e-13 * first.rack.module, "{k}: {gap:?}");
            // The angles of the teeth keep the transmission ratio: both follow from the roll
            // angles.
            let first_expected = roll - first.half_base_angle - mesh.operating_pressure_angle;
            assert!(
                (first_turn - first_expected).rem_euclid(2.0 * PI).min(1.0).abs() < 1e-13
                    || (first_expected - first_turn).rem_euclid(2.0 * PI) < 1e-13
            );
        }
    }
}

/// Signed distance of a point from the rack's tooth with sharp flanks and rounded corners, negative
/// inside. Rack coordinates: `x` along the pitch line from the middle of the tooth, `y` into the
/// gear.
fn distance_to_rack(gear: &ExternalGear, [x, y]: [f64; 2]) -> f64 {
    let rack = &gear.rack;
    let (sine, cosine) = rack.pressure_angle.sin_cos();
    let dedendum = gear.pitch_radius - gear.root_radius;
    let half = 0.5 * (rack.pitch() - gear.tooth_thickness);
    let x = x.abs();
    // Outward distances from flank and tip line; the corner's circle is tangent to both.
    let flank = (x - half) * cosine + y * sine;
    let tip = y - dedendum;
    let centre_y = dedendum - rack.tip_radius;
    let centre_x = half - centre_y * sine / cosine - rack.tip_radius / cosine;
    // In the sector of the corner, between the two normals through its centre.
    let (dx, dy) = (x - centre_x, y - centre_y);
    let past_flank = -dx * sine + dy * cosine > 0.0;
    if past_flank && dx > 0.0 { dx.hypot(dy) - rack.tip_radius } else { flank.max(tip) }
}

#[test]
fn the_rack_touches_every_point_of_the_root_and_enters_none() {
    let gears = [
        chapter_5(20),
        chapter_5(40),
        ExternalGear::new(chapter_5_data(20, 0.045, 0.16)).expect("a gear"),
        ExternalGear::new(chapter_5_data(20, 0.005, 0.10)).expect("a gear"),
        // Undercut, slightly and strongly.
        ExternalGear::new(standard_data(14, 0.0, 0.25)).expect("a gear"),
        ExternalGear::new(standard_data(9, 0.0, 0.3)).expect("a gear"),
    ];
    for gear in &gears {
        let fillet = gear.root_fillet(Side::CounterClockwise);
        let flank = Flank::new(gear, &[], Side::CounterClockwise).expect("a flank");
        let points = (0..=20).map(|k| fillet.at(fillet.length() * f64::from(k) / 20.0).position);
        let on_involute = (0..=10).map(|k| flank.at(flank.edge_range()[0] * f64::from(k) / 10.0).position);
        for point in points.chain(on_involute) {
            // The tooth's centreline is half a pitch from the middle of the space; the gear rotates
            // by `roll`.
            let distance = |roll: f64| {
                let [x, y] = turned(point, -PI / f64::from(gear.teeth) - roll);
                distance_to_rack(gear, [y + gear.pitch_radius * roll, gear.pitch_radius - x])
            };
            // Exhaustive search, then a golden-section search around the best value.
            let (count, range) = (4000, 1.5 * PI / f64::from(gear.teeth) + 0.4);
            let place = |k: i32| range * f64::from(k) / f64::from(count);
            let best = (-count..=count)
                .min_by(|&a, &b| distance(place(a)).total_cmp(&distance(place(b))))
                .expect("there are places");
            let (mut a, mut b) = (place(best - 1), place(best + 1));
            let golden = 0.5 * (5.0_f64.sqrt() - 1.0);
            for _ in 0..60 {
                let (c, d) = (b - golden * (b - a), a + golden * (b - a));
                if distance(c) < distance(d) { b = d } else { a = c }
            }
            let least = distance(0.5 * (a + b)) / gear.rack.module;
            assert!(least.abs() < 1e-12, "{} teeth: {least} at {point:?}", gear.teeth);
        }
    }
}

#[test]
fn undercut_shortens_the_involute() {
    let gear = ExternalGear::new(standard_data(9, 0.0, 0.3)).expect("a gear");
    assert!(gear.undercut);
    assert_eq!(gear.warnings.len(), 1);
    assert_eq!(gear.warnings[0].code, "E0614");
    let (form, start) = (
        Flank::new(&gear, &[], Side::CounterClockwise).expect("a flank").at(0.0),
        gear.root_fillet(Side::CounterClockwise).at(0.0),
    );
    for axis in 0..2 {
        assert!((form.position[axis] - start.position[axis]).abs() < 1e-16, "they cross at the form circle");
    }
    // The profile shift that the message proposes is the limit of undercut.
    let shift =
        (1.25 - 0.3 * (1.0 - 20.0_f64.to_radians().sin())) - 4.5 * 20.0_f64.to_radians().sin().powi(2);
    for (more, undercut) in [(-1e-6, true), (1e-6, false)] {
        let gear = ExternalGear::new(standard_data(9, shift + more, 0.3)).expect("a gear");
        assert_eq!(gear.undercut, undercut);
    }
}
