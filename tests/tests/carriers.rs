//! Planetary sets on flexible carriers: against a rigid carrier, load shares against springs in
//! series, and the tilt of pins against the condensed body.

use crate::models::{close, codes, means};
use calyx_runtime::elastic::Resources;
use calyx_runtime::elastic::assembly::System;
use calyx_runtime::elastic::attachment::{Attachment, Connection, Region, attach};
use calyx_runtime::elastic::carrier::{CarrierModel, CarrierShape, HUB, Webs};
use calyx_runtime::elastic::condensation::static_condensation;
use nalgebra::{DMatrix, DVector};
use std::collections::BTreeMap;
use std::f64::consts::TAU;

const TORQUE: f64 = 400.0;

/// A spur set of three planets at the first position, on planet bearings without stiffness against
/// tilting. `modulus` is that of the carrier, GPa.
fn set(carrier: &str, modulus: f64) -> String {
    let mut text = format!(
        "import gears;
units SI;
var steel = gears.material(youngs_modulus = 206 GPa, poissons_ratio = 0.3, density = 7850 kg/m^3);
var cast = gears.material(youngs_modulus = {modulus} GPa, poissons_ratio = 0.3, density = 7850 kg/m^3);
var blank = gears.external(24, module = 2.5 mm, face_width = 22 mm, tooth_thickness = 3.88 mm, material = steel);
var ring_blank = gears.internal(72, module = 2.5 mm, minor_diameter = 175.6 mm, face_width = 22 mm, tooth_thickness = 3.88 mm, material = steel);
var sun = gears.body(\"sun\", blank, free = [\"theta_z\"], moment = {TORQUE} N*m * e3, frame := Rotate(4 rpm * Time, e3));
var ring = gears.body(\"ring\", ring_blank, frame := Rotate(0 deg, e3));
var hub = gears.rigid_body(\"carrier\", frame := Rotate(1 rpm * Time, e3));
var carrier = gears.carrier(
    hub, planets = 3, material = cast, pin_circle_diameter = 120 mm, pin_diameter = 24 mm,
    outside_diameter = 176 mm, bore_diameter = 50 mm, thickness = 16 mm, second_thickness = 12 mm, gap = 30 mm,
    web_angle = 30 deg, element_size = 20 mm{carrier});
"
    );
    for k in 0..3 {
        text += &format!(
            "var planet{k} = gears.body(
    \"planet {k}\", blank, free = [\"u_x\", \"u_y\", \"theta_z\"], frame := Rotate(-3 rpm * Time, e3) * Translate(carrier.positions[{k}]) * hub.frame);
gears.bearing(\"bearing {k}\", planet{k}, to = carrier.pins[{k}], radial_stiffness = 6e8 N/m);
var inside{k} = gears.mesh(sun, planet{k});
var outside{k} = gears.mesh(planet{k}, ring);
output load{k} := gears.mesh_force(inside{k});
output x{k} := gears.rotation(carrier.pins[{k}], \"x\");
output y{k} := gears.rotation(carrier.pins[{k}], \"y\");
output z{k} := gears.rotation(carrier.pins[{k}], \"z\");
output u{k} := gears.displacement(carrier.pins[{k}], \"x\");
output v{k} := gears.displacement(carrier.pins[{k}], \"y\");
"
        );
    }
    text += "output wind_up := gears.rotation(sun, \"z\");
analyze(\"quasi_static\", over = gears.times(1 us, 1 us, 1), fidelity = \"analytic\", error_estimates = \"none\");
";
    text
}

/// Compliance of the pins with the hub fixed, condensed independently.
fn compliance() -> DMatrix<f64> {
    let shape = CarrierShape {
        planets: 3,
        pin_circle_diameter: 0.12,
        pin_diameter: 0.024,
        pin_bore: 0.0,
        outside_diameter: 0.176,
        bore_diameter: 0.05,
        thickness: vec![0.016, 0.012],
        gap: 0.03,
        hub_at_negative_z: true,
        webs: Some(Webs {
            inside_diameter: 0.12 - 0.024,
            outside_diameter: 0.176,
            angle: 30_f64.to_radians(),
        }),
        element_size: 0.02,
    };
    let steel = calyx_runtime::elastic::Material {
        youngs_modulus: 206e9,
        poissons_ratio: 0.3,
        shear_modulus: 206e9 / 2.6,
        density: 7850.0,
        structural_damping: 0.0,
    };
    let CarrierModel { mut model, mut pins } = shape.model(&steel);
    let hub = Attachment {
        name: "attached hub".into(),
        position: Some([0.0; 3]),
        region: Region::Set(HUB.into()),
        connection: Connection::Rigid,
    };
    pins.push(attach(&mut model, &hub).expect("attached")[0]);
    let resources = Resources::default();
    let system = System::new(&model, &resources).expect("valid");
    let body = static_condensation(&system, &pins, &[], &resources).expect("condensed");
    let stiffness = DMatrix::from_fn(18, 18, |i, j| body.stiffness[(i, j)]);
    stiffness.try_inverse().expect("supported")
}

/// Tangential forces on the pins from the mesh forces: both meshes of a planet push it.
fn pin_loads(found: &BTreeMap<String, f64>) -> DVector<f64> {
    let mut loads = DVector::zeros(18);
    for k in 0..3 {
        let force = 2.0 * found[&format!("load{k}")] * 20_f64.to_radians().cos();
        let (sin, cos) = (TAU * k as f64 / 3.0).sin_cos();
        loads[6 * k] -= force * sin;
        loads[6 * k + 1] += force * cos;
    }
    loads
}

/// The limit of a stiff material, by extrapolation of two stiff ones, is the rigid carrier, on
/// which planets are mounted without it. The largest modulus of the library is 5,000 times that of
/// steel; the extrapolation differs by up to 3e-5.
#[test]
fn a_stiff_carrier_is_a_rigid_one() {
    let error = ", pin_position_errors = [10 um]";
    let [one, twice] = [5e5, 1e6].map(|modulus| means(&set(error, modulus)));
    let rigid = means(&set(&format!("{error}, elastic = FALSE"), 206.0));
    for name in ["load0", "load1", "load2", "wind_up"] {
        close(name, twice[name], rigid[name], 1e-3);
        close(name, 2.0 * twice[name] - one[name], rigid[name], 1e-4);
    }
    let largest = rigid["load1"].max(rigid["load2"]);
    assert!(rigid["load0"] < 0.9 * largest || rigid["load0"] > 1.1 * largest, "{rigid:?}");
}

/// The compliance of the carrier between pins is in series with that of teeth and bearings: the
/// difference of the loads due to a pin error is the error divided by their sum.
#[test]
fn a_pin_error_loads_planets_as_springs_in_series() {
    let error = 8e-6;
    let with = |elastic: &str, modulus: f64| {
        let text = |error: f64| format!(", pin_position_errors = [{error} m]{elastic}");
        let [with, without] = [error, 0.0].map(|error| means(&set(&text(error), modulus)));
        let uneven = |found: &BTreeMap<String, f64>| {
            let loads = pin_loads(found);
            let tangential = |k: usize| {
                let (sin, cos) = (TAU * k as f64 / 3.0).sin_cos();
                cos * loads[6 * k + 1] - sin * loads[6 * k]
            };
            tangential(0) - 0.5 * (tangential(1) + tangential(2))
        };
        uneven(&with) - uneven(&without)
    };
    let [rigid, flexible] = [with(", elastic = FALSE", 206.0), with("", 206.0)];
    let compliance = compliance();
    // Tangential displacement of the first pin by its own force, less that by the force of another.
    let (sin, cos) = (TAU / 3.0).sin_cos();
    let other = cos * compliance[(1, 7)] - sin * compliance[(1, 6)];
    let series = 1.0 / (1.0 / rigid.abs() + (compliance[(1, 1)] - other) / error);
    println!("rigid {rigid}, flexible {flexible}, springs in series {series}");
    assert!(flexible.abs() < 0.9 * rigid.abs());
    close("difference of the loads", flexible.abs(), series, 0.02);
}

/// Displacements and tilts of the pins are those of the condensed body under the forces of the
/// bearings.
#[test]
fn pins_tilt_by_the_wind_up_of_the_carrier() {
    let found = means(&set("", 206.0));
    let motions = compliance() * pin_loads(&found);
    for k in 0..3 {
        // Displacements of a pin refer to the axis of rotation of its frame, that of the carrier.
        let (sin, cos) = (TAU * k as f64 / 3.0).sin_cos();
        let swept = 0.06 * found[&format!("z{k}")];
        let largest = motions.rows(6 * k, 2).amax();
        for (row, name, carried) in [(0, "u", -sin * swept), (1, "v", cos * swept)] {
            let moved = found[&format!("{name}{k}")] + carried;
            let difference = (moved - motions[6 * k + row]).abs();
            assert!(difference < 1e-3 * largest, "{name}{k}: {difference:e} of {largest:e}");
        }
        let tilt = motions.rows(6 * k + 3, 2).amax();
        for (row, name) in [(3, "x"), (4, "y")] {
            let difference = (found[&format!("{name}{k}")] - motions[6 * k + row]).abs();
            assert!(difference < 1e-3 * tilt, "{name}{k}: {difference:e} of {tilt:e}");
        }
        assert!(tilt > 1e-5, "{tilt}");
    }
}

/// A check rejects what a run would reject.
#[test]
fn checks_reject_impossible_carriers() {
    assert_eq!(codes(&set("", 206.0)), Vec::<String>::new());
    for (from, to) in
        [("web_angle = 30 deg", "web_angle = 100 deg"), ("pin_diameter = 24 mm", "pin_diameter = 80 mm")]
    {
        let found = codes(&set("", 206.0).replace(from, to));
        assert!(found.contains(&"E0995".to_owned()), "{found:?}");
    }
    // Spur teeth do not support the carrier along its axis.
    let loose =
        set("", 206.0).replace("rigid_body(\"carrier\", ", "rigid_body(\"carrier\", free = [\"u_z\"], ");
    assert_eq!(codes(&loose), ["E0715"]);
    let plane = codes(&set("", 206.0).replace("\"analytic\"", "\"plane\""));
    assert!(plane.contains(&"E0611".to_owned()), "{plane:?}");
}

/// The assembled planetary set has the results of the set of single bodies.
#[test]
fn an_assembled_set_has_the_same_flexible_carrier() {
    let single = means(&set(", pin_position_errors = [20 um]", 206.0));
    let mut text = format!(
        "import gears;
units SI;
var steel = gears.material(youngs_modulus = 206 GPa, poissons_ratio = 0.3, density = 7850 kg/m^3);
var blank = gears.external(24, module = 2.5 mm, face_width = 22 mm, tooth_thickness = 3.88 mm, material = steel);
var ring_blank = gears.internal(72, module = 2.5 mm, minor_diameter = 175.6 mm, face_width = 22 mm, tooth_thickness = 3.88 mm, material = steel);
var set = gears.planetary(blank, blank, ring_blank, center_distance = 60 mm, sun_speed = 4 rpm, sun_torque = {TORQUE} N*m,
    pin_stiffness = 6e8 N/m, pin_position_errors = [20 um],
    carrier_dimensions = gears.CarrierDimensions(
        material = steel, pin_diameter = 24 mm, outside_diameter = 176 mm, bore_diameter = 50 mm, thickness = 16 mm,
        second_thickness = 12 mm, gap = 30 mm, web_angle = 30 deg, element_size = 20 mm));
output wind_up := gears.rotation(set.sun, \"z\");
"
    );
    for k in 0..3 {
        text += &format!("output load{k} := gears.mesh_force(set.sun_meshes[{k}]);\n");
    }
    text += "analyze(\"quasi_static\", over = gears.times(1 us, 1 us, 1), fidelity = \"analytic\", error_estimates = \"none\");\n";
    let assembled = means(&text);
    for name in ["wind_up", "load0", "load1", "load2"] {
        close(name, assembled[name], single[name], 1e-9);
    }
    // The pin error matters.
    assert!((assembled["load0"] / assembled["load1"] - 1.0).abs() > 0.1);
}
