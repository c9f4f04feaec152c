//! Compares the face gear of `examples/face_gear.cx`, whose machine is written in Calyx, with
//! closed forms: the limits of its face, zero transmission error of conjugate flanks, and the
//! forces at the contact point.

use crate::models::engine;
use calyx::rt::{ParamAssignment, RunOptions, run};
use calyx::{Module, Override, check_file};
use calyx_runtime::estimate::Estimates;
use calyx_tests::root;
use std::collections::BTreeMap;
use std::f64::consts::PI;
use std::fs;
use std::path::{Path, PathBuf};

type Columns = BTreeMap<String, Vec<f64>>;

/// Runs a model and returns the columns of its table, in SI units.
fn columns(model: &Path, given: &[(&str, &str)]) -> Columns {
    let checked = check_file(model).expect("the model can be read");
    let module = Module::from_checked(&engine(), checked).expect("the model compiles");
    let directory = tempfile::tempdir().expect("a directory");
    let options = RunOptions {
        directory: directory.path().into(),
        given: given.iter().map(|(name, value)| ParamAssignment::text(*name, *value)).collect(),
        quiet: true,
        overrides: Override { error_estimates: Some(Estimates::None), ..Override::default() },
        ..RunOptions::default()
    };
    run(module.as_program(), &options).unwrap_or_else(|error| panic!("{given:?}: {error:?}"));
    let text = fs::read_to_string(directory.path().join("steps.csv")).expect("a table");
    let mut lines = text.lines().map(|line| line.split(',').map(str::to_owned).collect::<Vec<_>>());
    let names = lines.next().expect("a header");
    let rows: Vec<Vec<String>> = lines.collect();
    let column = |index: usize| rows.iter().filter_map(|row| row[index].parse().ok()).collect();
    names.iter().enumerate().map(|(index, name)| (name.clone(), column(index))).collect()
}

fn example() -> PathBuf {
    root().join("examples/face_gear.cx")
}

/// Shaper and face gear of the example, in modules; the default values of its params.
#[derive(Clone, Copy)]
struct Machine {
    pinion_teeth: u32,
    more_shaper_teeth: u32,
    teeth: u32,
    pressure_angle: f64,
    shaper_addendum: f64,
    shaper_edge_radius: f64,
    addendum: f64,
}

const DEFAULT: Machine = Machine {
    pinion_teeth: 18,
    more_shaper_teeth: 2,
    teeth: 100,
    pressure_angle: 25.0,
    shaper_addendum: 1.2,
    shaper_edge_radius: 0.15,
    addendum: 1.0,
};

/// Returns the root of an increasing function between two arguments.
fn bisected(function: impl Fn(f64) -> f64, [mut low, mut high]: [f64; 2]) -> f64 {
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if function(middle) > 0.0 { high = middle } else { low = middle }
    }
    low
}

impl Machine {
    /// Returns the radii of undercut and of pointed teeth in modules, see
    /// `docs/theory/bevel-gears.md`: in a transverse section of the shaper the contact is that of a
    /// pinion and a rack, so that no system of equations of the surfaces needs to be solved.
    fn limits(&self) -> [f64; 2] {
        let shaper_teeth = f64::from(self.pinion_teeth + self.more_shaper_teeth);
        let pressure_angle = self.pressure_angle.to_radians();
        let ratio = f64::from(self.teeth) / shaper_teeth;
        let pitch_radius = 0.5 * shaper_teeth;
        let base_radius = pitch_radius * pressure_angle.cos();
        let edge_center = pitch_radius + self.shaper_addendum - self.shaper_edge_radius;
        let arm = (edge_center.powi(2) - base_radius.powi(2)).sqrt();
        let roll = (arm + self.shaper_edge_radius) / base_radius;
        // Distance from the shaper's axis of the section whose rack has a pressure angle, along the
        // shaper's axis.
        let section = |angle: f64| ratio * base_radius / angle.cos();
        let undercut = {
            let excess = |t: f64| t * t * (1.0 + t * t) - roll * (roll - t) / ratio.powi(2);
            let angle = bisected(excess, [0.0, roll]).atan();
            let along = section(angle);
            let from_pitch_line = base_radius * roll - along / ratio * angle.sin();
            along.hypot(from_pitch_line * angle.cos())
        };
        let pointed = {
            let tip = |angle: f64| {
                let rack = section(angle) / ratio;
                let from_pitch_line = (pitch_radius - self.addendum - rack) / angle.sin();
                let roll = (from_pitch_line + rack * angle.sin()) / base_radius;
                let shaper = PI / (2.0 * shaper_teeth) + pressure_angle.tan() - pressure_angle - roll;
                let across = from_pitch_line * angle.cos();
                let azimuth = across.atan2(section(angle)) + (angle + shaper) / ratio;
                (azimuth - PI / f64::from(self.teeth), section(angle).hypot(across))
            };
            tip(bisected(|angle| tip(angle).0, [pressure_angle, 1.0])).1
        };
        [undercut, pointed]
    }

    fn given(&self) -> Vec<(&'static str, String)> {
        vec![
            ("pinion_teeth", self.pinion_teeth.to_string()),
            ("more_shaper_teeth", self.more_shaper_teeth.to_string()),
            ("teeth", self.teeth.to_string()),
            ("pressure_angle", format!("{} deg", self.pressure_angle)),
            ("shaper_addendum", self.shaper_addendum.to_string()),
            ("shaper_edge_radius", self.shaper_edge_radius.to_string()),
            ("addendum", self.addendum.to_string()),
        ]
    }
}

#[test]
fn undercut_and_pointed_teeth_limit_the_face_where_closed_forms_do() {
    let machines = [
        DEFAULT,
        Machine { teeth: 160, pressure_angle: 20.0, ..DEFAULT },
        Machine { pinion_teeth: 25, more_shaper_teeth: 0, addendum: 0.8, ..DEFAULT },
        Machine { pinion_teeth: 30, more_shaper_teeth: 3, shaper_addendum: 1.1, teeth: 91, ..DEFAULT },
        Machine { shaper_edge_radius: 0.05, pressure_angle: 22.0, ..DEFAULT },
    ];
    for machine in machines {
        let given = machine.given();
        let mut given: Vec<(&str, &str)> = given.iter().map(|(name, value)| (*name, &value[..])).collect();
        given.extend([("fidelity", "rigid"), ("steps", "2"), ("module", "1 mm"), ("sections", "9")]);
        let found = columns(&example(), &given);
        for (name, expected) in ["undercut_radius", "pointed_radius"].into_iter().zip(machine.limits()) {
            let off = 1e3 * found[name][0] / expected - 1.0;
            assert!(off.abs() < 1e-13, "{given:?}: {name} {off:e}");
        }
    }
}

/// The flanks of the shaper, of a pinion with fewer teeth in mesh with it, and of the face gear
/// have the same lines of action, so that pinion and face gear are conjugate. With the shaper as
/// pinion the contact is a line and ends at the ends of the face when the axes are displaced; with
/// fewer teeth it is a point, and the pair remains conjugate (Litvin and Fuentes 2004, section
/// 18.1). The interpolation along the face limits the accuracy.
#[test]
fn face_gear_and_pinion_are_conjugate() {
    let largest = |teeth: &str, given: &[(&str, &str)]| {
        let given = [given, &[("fidelity", "rigid"), ("more_shaper_teeth", teeth)]].concat();
        let lag = columns(&example(), &given).remove("transmission_error").expect("an output");
        assert_eq!(lag.len(), 8);
        lag.iter().fold(0.0, |largest: f64, lag| largest.max(lag.abs()))
    };
    let displacements: [&[(&str, &str)]; 4] = [
        &[("offset_error", "0.1 mm")],
        &[("gear_axial", "0.1 mm")],
        &[("shaft_angle_error", "0.05 deg")],
        &[("offset_error", "-0.1 mm"), ("gear_axial", "-0.02 mm"), ("shaft_angle_error", "-0.02 deg")],
    ];
    let fine = ("sections", "33");
    for teeth in ["0", "1", "2"] {
        let aligned = largest(teeth, &[fine]);
        assert!(aligned < 1e-9, "{teeth}: {aligned:e}");
    }
    for displacement in displacements {
        let given = [displacement, &[fine]].concat();
        let [line, point] = ["0", "2"].map(|teeth| largest(teeth, &given));
        assert!(point < 1e-9 && line > 1e-7, "{displacement:?}: {point:e} {line:e}");
    }
    // Splines of degree 5: half the distance of the sections has at best a 64th of the error.
    let [usual, fine] = ["17", "33"].map(|sections| largest("0", &[("sections", sections)]));
    assert!(usual < 3e-7 && usual / fine > 32.0, "{usual:e} {fine:e}");
}

/// A pinion with fewer teeth than the shaper touches the face gear in the section through the pitch
/// point, at the pressure angle. Its supports and those of the gear are in equilibrium with its
/// torque.
#[test]
fn forces_are_those_of_the_contact_point() {
    let directory = tempfile::tempdir().expect("a directory");
    let model = directory.path().join("face_gear.cx");
    let text = fs::read_to_string(example()).expect("an example");
    let moments: Vec<(String, String)> = ["pinion", "gear"]
        .into_iter()
        .flat_map(|body| ["x", "y", "z"].map(|axis| (body, axis)))
        .map(|(body, axis)| {
            let name = format!("moment_{body}_{axis}");
            let output = format!("output {name} := gears.support_moment({body}, \"{axis}\");\n");
            (name, output)
        })
        .collect();
    let outputs: String = moments.iter().map(|(_, output)| &output[..]).collect();
    assert!(text.contains("\nanalyze("));
    fs::write(&model, text.replace("\nanalyze(", &format!("\n{outputs}\nanalyze("))).expect("a file");
    // The deviation of an elastic contact from its point decreases with the torque.
    let torque = 0.01;
    let given = [("pinion_torque", "0.01 N*m"), ("steps", "4"), ("sections", "33")];
    let found = columns(&model, &given);
    let [pinion_radius, shaper_radius, pitch_section] = [27e-3, 30e-3, 150e-3];
    let half = |name: &str, inset: f64| 0.5 * (found[name][0] + inset);
    let middle = half("undercut_radius", 0.5 * 3e-3) + half("pointed_radius", -2.0 * 3e-3);
    let tangential = torque / pinion_radius;
    let mut compared = 0;
    for step in 0..4 {
        let at = |names: [&str; 3]| names.map(|name| found[name][step]);
        let pinion = at(["pinion_force_axial", "pinion_force_tangential", "pinion_force_separating"]);
        let gear = at(["gear_force_radial", "gear_force_tangential", "gear_force_axial"]);
        let moment = at(["moment_pinion_x", "moment_pinion_y", "moment_pinion_z"]);
        let gear_moment = at(["moment_gear_x", "moment_gear_y", "moment_gear_z"]);
        let [x, z] = [middle, pinion_radius - shaper_radius];
        let of_force = [-z * pinion[1], z * pinion[0] - x * pinion[2], x * pinion[1]];
        for k in 0..3 {
            assert!((pinion[k] + gear[k]).abs() < 1e-9 * tangential, "{pinion:?} {gear:?}");
            let applied = if k == 0 { torque } else { 0.0 };
            let sum = applied + of_force[k] + moment[k] + gear_moment[k];
            assert!(sum.abs() < 1e-9 * torque, "component {k} of the moments: {sum:e}");
        }
        // Edges carry part of the load where a pair of teeth enters and leaves.
        if found["max_edge_pressure"][step] > 0.0 {
            continue;
        }
        compared += 1;
        let expected = [0.0, tangential, -tangential * 25_f64.to_radians().tan()];
        for (force, expected) in pinion.iter().zip(expected) {
            assert!((force - expected).abs() < 5e-5 * tangential, "{pinion:?} {expected}");
        }
        let section = middle + moment[2] / pinion[1];
        assert!((section - pitch_section).abs() < 5e-6, "contact at {section} m");
        let ratio = gear_moment[2] / torque * 18.0 / 100.0;
        assert!((ratio + 1.0).abs() < 1e-6, "{ratio}");
    }
    assert!(compared >= 2, "edges carry load at every position");
}
