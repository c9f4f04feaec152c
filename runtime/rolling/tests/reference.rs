//! Comparison with independent computations: ball bearings with Hertz contacts, cylindrical and
//! tapered roller bearings with 41 laminae per contact, all with rigid rings. Lengths of the tables
//! are in mm.

use crate::sample::{angular_contact, balls, close, cylindrical, deep_groove, evaluate, rollers, tapered};
use calyx_rolling::bearing::Contacts;
use calyx_rolling::hertz::point::PointContact;
use calyx_rolling::{Conditions, Motion, RollingBearing};
use serde_json::Value;

/// Relative tolerance of loads, displacements and stiffness.
const TOLERANCE: f64 = 1e-6;
/// Length that makes moments comparable with forces, mm.
const RADIUS: f64 = 30.0;

fn table(text: &str) -> Value {
    serde_json::from_str(text).expect("valid JSON")
}

fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

fn five(value: &Value) -> [f64; 5] {
    [0, 1, 2, 3, 4].map(|k| number(&value[k]))
}

fn milli(values: [f64; 5]) -> [f64; 5] {
    let [x, y, z, about_x, about_y] = values;
    [x * 1e-3, y * 1e-3, z * 1e-3, about_x, about_y]
}

/// Compares load and stiffness at the displacement of a case, and the displacement at its load.
fn compare(bearing: &RollingBearing, case: &Value, prescribed: [bool; 5]) {
    let (q, load) = (five(&case["q"]), five(&case["F"]));
    let at = evaluate(bearing, &milli(q), &Motion::REST);
    let radius = [1.0, 1.0, 1.0, RADIUS, RADIUS];
    let total = (0..5).fold(0.0f64, |most, k| most.max(load[k].abs() / radius[k]));
    let in_mm = [1.0, 1.0, 1.0, 1e3, 1e3];
    for k in 0..5 {
        close(at.load[k] * in_mm[k] / radius[k], load[k] / radius[k], total, TOLERANCE, &format!("load {k}"));
    }
    let stiffness: Vec<[f64; 5]> = (0..5).map(|k| five(&case["K"][k])).collect();
    let largest = (0..5).fold(0.0f64, |most, k| most.max(stiffness[k][k].abs() / radius[k] / radius[k]));
    for i in 0..5 {
        for j in 0..5 {
            // N/m to N/mm; rotations have no length.
            let value = at.stiffness[i][j] * in_mm[i] * in_mm[j] * 1e-3;
            let unit = radius[i] * radius[j];
            close(value / unit, stiffness[i][j] / unit, largest, TOLERANCE, &format!("stiffness {i} {j}"));
        }
    }
    let [fx, fy, fz, mx, my] = load;
    let mut start = [0.0; 5];
    for k in 0..5 {
        if prescribed[k] {
            start[k] = milli(q)[k];
        }
    }
    let load = [fx, fy, fz, mx * 1e-3, my * 1e-3];
    let solution =
        bearing.equilibrium(&Conditions { load, prescribed, start }, &Motion::REST).expect("solved");
    let largest = (0..5).fold(0.0f64, |most, k| most.max((milli(q)[k] * radius[k]).abs()));
    for k in 0..5 {
        let (value, expected) = (solution.displacement[k] * radius[k], milli(q)[k] * radius[k]);
        close(value, expected, largest, TOLERANCE, &format!("displacement {k}"));
    }
}

#[test]
fn hertz_contacts_of_a_groove() {
    let data = table(include_str!("data/ball_bearings.json"));
    for row in data["hertz_ball_on_groove"]["rows"].as_array().expect("rows") {
        let modulus = number(&data["Estar"]) * 1e6;
        let contact = PointContact::new(1e3 * number(&row["A"]), 1e3 * number(&row["B"]), modulus);
        let load = number(&row["Q"]);
        let ellipse = contact.ellipse(load);
        let approach = (load / contact.stiffness).powf(2.0 / 3.0);
        for (value, name, unit) in [
            (ellipse.x, "a", 1e-3),
            (ellipse.y, "b", 1e-3),
            (ellipse.pressure, "p0", 1e6),
            (approach, "delta", 1e-3),
        ] {
            let expected = number(&row[name]) * unit;
            close(value, expected, expected, 1e-8, name);
        }
    }
}

fn compare_balls(name: &str, bearing: &RollingBearing) {
    let data = table(include_str!("data/ball_bearings.json"));
    for case in data[name]["cases"].as_array().expect("cases") {
        let mut prescribed = [false; 5];
        for k in case["fixed"].as_array().expect("indices") {
            prescribed[number(k) as usize] = true;
        }
        compare(bearing, case, prescribed);
        let states = bearing.elements(&milli(five(&case["q"])), &Motion::REST).expect("finite");
        let expected = case["elements"].as_array().expect("elements");
        assert_eq!(states.len(), expected.len());
        let most = expected.iter().map(|element| number(&element["Qi"])).fold(0.0, f64::max);
        for (state, expected) in states.iter().zip(expected) {
            close(state.azimuth.to_degrees(), number(&expected["psi_deg"]), 360.0, 1e-12, "azimuth");
            let Contacts::Ball(ball) = &state.contacts else { panic!("balls") };
            for (contact, side) in [(ball.inner[0], "i"), (ball.outer[0], "o")] {
                close(contact.load, number(&expected[format!("Q{side}")]), most, TOLERANCE, "load");
                let angle = number(&expected[format!("alpha_{side}_deg")]);
                close(contact.angle.to_degrees(), angle, 90.0, TOLERANCE, "contact angle");
                if contact.load == 0.0 {
                    continue;
                }
                for (value, name, unit) in [
                    (contact.pressure, "p0_", 1e6),
                    (contact.across, "a_", 1e-3),
                    (contact.along, "b_", 1e-3),
                ] {
                    let expected = number(&expected[format!("{name}{side}")]) * unit;
                    close(value, expected, expected, TOLERANCE, name);
                }
            }
        }
    }
}

#[test]
fn deep_groove_ball_bearing() {
    let bearing = balls(deep_groove());
    compare_balls("dgbb", &bearing);
}

#[test]
fn angular_contact_ball_bearing() {
    let bearing = balls(angular_contact());
    compare_balls("acbb", &bearing);
}

fn compare_rollers(data: &Value, bearing: &RollingBearing, prescribed: [bool; 5]) {
    for case in data["cases"]["lamina"].as_array().expect("cases") {
        compare(bearing, case, prescribed);
        let states = bearing.elements(&milli(five(&case["q"])), &Motion::REST).expect("finite");
        let expected = case["elements"].as_array().expect("elements");
        let most = number(&expected[0]["Qo"]);
        for (state, expected) in states.iter().zip(expected) {
            let Contacts::Roller(roller) = &state.contacts else { panic!("rollers") };
            close(roller.rib, number(&expected["Qf"]), most, TOLERANCE, "load of the rib");
            for (contact, side) in [(&roller.inner, "inner"), (&roller.outer, "outer")] {
                let initial = &side[..1];
                close(contact.load, number(&expected[format!("Q{initial}")]), most, TOLERANCE, "load");
                let moment = number(&expected[format!("M{initial}")]);
                close(contact.moment * 1e3, moment, most, TOLERANCE, "moment");
                // Unloaded rollers have no laminae in the table.
                let Some(loads) = expected[format!("q_{side}")].as_array() else {
                    assert_eq!(contact.load, 0.0);
                    continue;
                };
                let highest = loads.iter().map(number).fold(0.0, f64::max);
                for (k, load) in loads.iter().enumerate() {
                    let position = number(&data["x_lamina"][k]);
                    close(contact.positions[k] * 1e3, position, 10.0, 1e-12, "position");
                    close(
                        contact.loads[k] * 1e-3,
                        number(load),
                        highest.max(1.0),
                        TOLERANCE,
                        "load per length",
                    );
                }
                let pressure = number(&expected[format!("pmax_{side}")]);
                close(contact.pressure * 1e-6, pressure, pressure.max(1.0), TOLERANCE, "pressure");
            }
            // The table keeps unloaded rollers at other positions within the clearance.
            for k in (0..3).filter(|_| roller.outer.load > 0.0) {
                let unit = if k < 2 { 1e-3 } else { 1.0 };
                let value = number(&expected["roller_ur_uz_phi"][k]) * unit;
                close(roller.displacement[k], value, 1e-4, TOLERANCE, "displacement of the roller");
            }
        }
    }
}

#[test]
fn cylindrical_roller_bearing() {
    let data = table(include_str!("data/cylindrical_roller_bearing.json"));
    compare_rollers(&data, &rollers(cylindrical()), [false, false, true, false, false]);
}

#[test]
fn tapered_roller_bearing() {
    let data = table(include_str!("data/tapered_roller_bearing.json"));
    let geometry = tapered();
    close(geometry.roller_diameter, 10.0775774622e-3, 10e-3, 1e-10, "roller diameter");
    compare_rollers(&data, &rollers(geometry), [false; 5]);
}
