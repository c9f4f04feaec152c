//! Tests of planetary sets from the library function `planetary`, from the model to the table:
//! driven and fixed members, errors of planets, dynamics, stepped planets.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::LazyLock;

const BLANKS: &str = "import gears;
units SI;
var steel = gears.material(youngs_modulus = 206 GPa, poissons_ratio = 0.3);
var rack = gears.rack(module = 2 mm, tip_radius = 0.5 mm);
function blank(in teeth, in thickness = 3.08 mm) {
    return gears.external(teeth = teeth, rack = rack, tooth_thickness = thickness, face_width = 20 mm,
        outer_diameter = (teeth + 2) * 2 mm, root_diameter = (teeth - 2.5) * 2 mm, material = steel,
        rim = gears.simple_rim((teeth - 4) * 2 mm, (teeth - 8) * 2 mm));
}
var ring = gears.internal(teeth = 72, shaper = gears.shaper(25, module = 2 mm, tip_radius = 0.4 mm), tooth_thickness = 3.08 mm,
    face_width = 20 mm, minor_diameter = 140.8 mm, root_diameter = 149 mm, material = steel, rim = gears.outer_rim(151 mm, 159 mm));
";

/// Outputs of a set of three planets, with its positions.
const OUTPUTS: &str = "
output one := gears.mesh_force(set.sun_meshes[0]);
output two := gears.mesh_force(set.sun_meshes[1]);
output three := gears.mesh_force(set.ring_meshes[2]);
output sun_x := gears.displacement(set.sun, \"x\");
output sun_turn := gears.rotation(set.sun, \"z\");
output ring_turn := gears.rotation(set.ring, \"z\");
output sun_moment := gears.support_moment(set.sun, \"z\");
output ring_moment := gears.support_moment(set.ring, \"z\");
output carrier_moment := gears.support_moment(set.carrier, \"z\");
";

/// Structure cache that all tests share.
static CACHE: LazyLock<PathBuf> = LazyLock::new(|| {
    let cache = Path::new(env!("CARGO_TARGET_TMPDIR")).join("planetary-cache");
    // Structures of an earlier engine version are useless.
    let _ = fs::remove_dir_all(&cache);
    cache
});

/// Runs a model; returns the columns of `steps.csv` in SI units.
fn run(model: &str) -> BTreeMap<String, Vec<f64>> {
    let directory = tempfile::tempdir().unwrap();
    let path = directory.path().join("model.cx");
    fs::write(&path, format!("{BLANKS}{model}")).unwrap();
    let output = Command::new(env!("CARGO_BIN_EXE_calyx"))
        .arg("run")
        .arg(&path)
        .arg("--cache")
        .arg(CACHE.as_path())
        .arg("--out")
        .arg(directory.path().join("run"))
        .output()
        .unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let table = fs::read_to_string(directory.path().join("run/steps.csv")).unwrap();
    let mut lines = table.lines();
    let names: Vec<&str> = lines.next().unwrap().split(',').collect();
    let rows: Vec<Vec<&str>> = lines.map(|line| line.split(',').collect()).collect();
    let column = |index: usize| rows.iter().filter_map(|row| row[index].parse().ok()).collect();
    names.iter().enumerate().map(|(index, name)| (name.to_string(), column(index))).collect()
}

fn set(arguments: &str, outputs: &str, analysis: &str) -> BTreeMap<String, Vec<f64>> {
    run(&format!(
        "var set = gears.planetary(sun = blank(24), planet = blank(24), ring = ring, center_distance = 48 mm, contact_cells = 6,
            tip_corner_contact = FALSE, {arguments});{outputs}{analysis}"
    ))
}

#[track_caller]
fn close(found: f64, expected: f64, part: f64) {
    assert!((found - expected).abs() <= part * expected.abs(), "{found} {expected}");
}

/// Without any load, the sun drives all planets and each planet the ring, in the limit of vanishing
/// load.
#[test]
fn a_set_without_torque_has_no_forces() {
    for supports in ["", ", pin_stiffness = 5e8 N/m, sun_stiffness = 2e7 N/m"] {
        let found = set(
            &format!("sun_speed = 1000 rpm{supports}"),
            OUTPUTS,
            "analyze(\"quasi_static\", over = gears.mesh_cycle(set.sun_meshes[0], steps = 3), fidelity = \"analytic\");",
        );
        for name in ["one", "two", "three", "sun_moment", "carrier_moment"] {
            assert!(found[name].iter().all(|value| value.abs() < 1e-9), "{name} {:?}", found[name]);
        }
        assert!(found["sun_turn"].iter().all(|turn| turn.abs() < 1e-9), "{:?}", found["sun_turn"]);
    }
}

/// For a torque on any member, the moments on sun, ring and carrier are proportional to Zs, Zr and
/// -(Zs + Zr), and the tooth forces are equal.
#[test]
fn a_torque_on_the_ring_is_one_on_the_sun() {
    let analysis = "analyze(\"quasi_static\", over = gears.times(from = 1 ms, to = 5 ms, count = 2));";
    let by_sun = set("sun_speed = 400 rpm, sun_torque = 100 N*m, pin_stiffness = 1e9 N/m", OUTPUTS, analysis);
    let by_ring =
        set("sun_speed = 400 rpm, ring_torque = 300 N*m, pin_stiffness = 1e9 N/m", OUTPUTS, analysis);
    for row in 0..2 {
        close(by_sun["ring_moment"][row], 300.0, 1e-3);
        close(by_sun["carrier_moment"][row], -400.0, 1e-3);
        close(by_ring["sun_moment"][row], 100.0, 1e-3);
        close(by_ring["carrier_moment"][row], -400.0, 1e-3);
        assert!(by_sun["sun_moment"][row].abs() < 1e-8 && by_ring["ring_moment"][row].abs() < 1e-8);
        for force in ["one", "two", "three"] {
            close(by_ring[force][row], by_sun[force][row], 5e-3);
        }
        // The deflections are equal except for the mesh phase, because the member under torque
        // rotates by its deflection.
        assert!(by_sun["sun_turn"][row] > 0.0, "{by_sun:?}");
        close(by_ring["ring_turn"][row], by_sun["sun_turn"][row] / 3.0, 0.05);
    }
}

/// With the carrier, the ring or the sun fixed, the motion relative to the carrier and the tooth
/// forces are equal.
#[test]
fn whichever_member_is_held_teeth_bear_the_same() {
    // Relative to the carrier the sun has 300 rpm.
    let analysis = "analyze(\"quasi_static\", over = gears.times(from = 2 ms, to = 2 ms, count = 1));";
    let held = [
        "sun_speed = 300 rpm, ring_speed = -100 rpm",
        "sun_speed = 400 rpm",
        "sun_speed = 0 rpm, ring_speed = -400 rpm",
    ];
    let all = held.map(|speeds| {
        set(&format!("{speeds}, sun_torque = 100 N*m, pin_stiffness = 1e9 N/m"), OUTPUTS, analysis)
    });
    for other in &all[1..] {
        for force in ["one", "two", "three", "sun_turn", "carrier_moment"] {
            close(other[force][0], all[0][force][0], 1e-8);
        }
    }
}

/// A set on bearings with damping and clearance that rotates slowly stays in its initial
/// equilibrium and follows it: the dynamic results equal the static ones.
#[test]
fn a_slow_set_follows_its_equilibrium_in_time() {
    let arguments =
        "sun_speed = 4 rpm, sun_torque = 100 N*m, pin_stiffness = 3e8 N/m, pin_damping = 2e4 N*s/m,
        pin_clearance = 4 um, sun_stiffness = 2e7 N/m, sun_damping = 1e4 N*s/m, carrier_stiffness = 5e8 N/m,
        carrier_damping = 5e4 N*s/m, carrier_mass = 3 kg";
    let statics = "analyze(\"quasi_static\", over = gears.times(to = 0.16 s, count = 5));";
    let dynamics = "analyze(\"dynamic\", rayleigh_mass = 500 Hz, newmark = \"backward_difference\",
        over = gears.time_ranges([gears.time_range(0.16 s, step = 5 ms, output_every = 8)]));";
    let outputs = format!(
        "{OUTPUTS}output pin := gears.bearing_force(set.pins[1], \"radial\");
        output pin_moves := gears.bearing_deflection(set.pins[1], \"radial\");"
    );
    let (expected, found) = (set(arguments, &outputs, statics), set(arguments, &outputs, dynamics));
    assert_eq!(found["time"].len(), 5);
    for (row, time) in found["time"].iter().enumerate() {
        close(*time, expected["time"][row], 1e-9);
        for output in ["one", "two", "three", "sun_turn", "pin", "pin_moves"] {
            close(found[output][row], expected[output][row], 2e-3);
        }
    }
    // The motion is not trivial: the teeth advance by a part of their cycle, and the clearances are
    // closed.
    let turns = &expected["sun_turn"];
    assert!(turns.iter().any(|turn| (turn / turns[0] - 1.0).abs() > 1e-2), "{turns:?}");
    assert!(expected["pin_moves"][0] > 2e-6, "{expected:?}");
}

/// Errors of one planet: pin position error and runout in the same direction are equivalent, a
/// planet with thinner teeth carries less load.
#[test]
fn planets_have_errors_of_their_own() {
    let analysis = "analyze(\"quasi_static\", over = gears.times(from = 0 s, to = 0 s, count = 1));";
    let with = |errors: &str| {
        set(&format!("sun_speed = 400 rpm, sun_torque = 100 N*m{errors}"), OUTPUTS, analysis)["two"][0]
    };
    let [as_meant, pin, runout, thin, elsewhere] = [
        "",
        ", pin_position_errors = [0 um, 1 um]",
        ", planet_runouts = [0 um*e1, 1 um*e2]",
        ", actual_planets = [blank(24), blank(24, thickness = 3.078 mm)]",
        // Three of 96 possible positions further than a third of a revolution.
        ", places = [0 deg, 131.25 deg, 240 deg]",
    ]
    .map(with);
    // At time 0 the planet's y axis points in the direction of positive pin errors.
    close(runout - as_meant, pin - as_meant, 1e-2);
    // 2 um cos(20 deg) of base thickness correspond to 1 um 2 cos(20 deg).
    close(thin - as_meant, pin - as_meant, 0.02);
    assert!(
        pin < 0.999 * as_meant && (elsewhere / as_meant - 1.0).abs() > 1e-5,
        "{as_meant} {pin} {elsewhere}"
    );
}

/// A planet position at which teeth and spaces do not match is rejected at the call, with the
/// nearest valid one.
#[test]
fn a_place_where_a_planet_does_not_go_is_refused() {
    let directory = tempfile::tempdir().unwrap();
    let path = directory.path().join("model.cx");
    let model =
        "var set = gears.planetary(sun = blank(24), planet = blank(24), ring = ring, center_distance = 48 mm,
    sun_speed = 400 rpm, sun_torque = 100 N*m, planet_angles = [0 deg, 92 deg]);";
    fs::write(&path, format!("{BLANKS}{model}")).unwrap();
    let output = Command::new(env!("CARGO_BIN_EXE_calyx")).arg("check").arg(&path).output().unwrap();
    let said = String::from_utf8(output.stderr).unwrap() + &String::from_utf8(output.stdout).unwrap();
    assert!(!output.status.success() && said.contains("E0750") && said.contains("93.75 deg"), "{said}");
    assert!(said.contains("model.cx"), "{said}");
}

/// Stepped planets, two gears on one shaft: the sun meshes with the large gear, the ring with the
/// small one. By Willis's equation the ratio to the carrier is 1 + Z1 Zr / (Zs Z2), and so is the
/// ratio of the moments.
#[test]
fn a_stepped_planet_is_two_bodies_on_a_stiff_coupling() {
    let model = "
var speed = 400 rpm;
var ratio = 1 + 30*72/(24*18);
var carrier_speed = speed/ratio;
var own = -(speed - carrier_speed)*24/30;
var sun = gears.body(\"sun\", blank(24), free = [\"theta_z\"], moment = TORQUE*e3, frame := Rotate(speed*Time, e3));
var annulus = gears.body(\"ring\", ring, frame := Rotate(0 rpm*Time, e3));
var carrier = gears.rigid_body(\"carrier\", frame := Rotate(carrier_speed*Time, e3));
var with_sun = [];
var with_ring = [];
for (var i = 0; i < 3; i = i + 1) {
    function planet(in name, in gear, in place) {
        return gears.body(name, gear, free = [\"u_x\", \"u_y\", \"theta_z\"],
            frame := Rotate(own*Time, e3)*Translate(54 mm*e1)*Rotate(place + carrier_speed*Time, e3));
    }
    var large = planet(\"large {i}\", blank(30), i*120 deg);
    var small = planet(\"small {i}\", blank(18), i*120 deg);
    gears.bearing(\"pin {i}\", large, to = carrier, radial_stiffness = 3e8 N/m);
    gears.bearing(\"step {i}\", small, to = large, radial_stiffness = 3e9 N/m, torsional_stiffness = 1e7 N*m/rad);
    push(with_sun, gears.mesh(sun, large, contact_cells = 6, tip_corner_contact = FALSE));
    push(with_ring, gears.mesh(small, annulus, contact_cells = 6, tip_corner_contact = FALSE));
}
output on_sun := gears.mesh_force(with_sun[1]);
output on_ring := gears.mesh_force(with_ring[1]);
output sun_turn := gears.rotation(sun, \"z\");
output ring_moment := gears.support_moment(annulus, \"z\");
output carrier_moment := gears.support_moment(carrier, \"z\");
analyze(\"quasi_static\", over = gears.times(from = 1 ms, to = 1 ms, count = 1));";
    // Driving and driven: the active flanks follow the torque, not the speed.
    for torque in [100.0, -100.0] {
        let found = run(&model.replace("TORQUE", &format!("{torque} N*m")));
        // The planet transmits its moment over its two base radii.
        close(found["on_ring"][0], found["on_sun"][0] * 30.0 / 18.0, 1e-3);
        close(found["on_sun"][0], 100.0 / 3.0 / (24e-3 * 20.0_f64.to_radians().cos()), 1e-2);
        close(found["ring_moment"][0], torque * 30.0 * 72.0 / (24.0 * 18.0), 1e-3);
        close(found["carrier_moment"][0], -torque * (1.0 + 30.0 * 72.0 / (24.0 * 18.0)), 1e-3);
        assert!(found["sun_turn"][0] * torque > 0.0);
    }
}
